"""The matrices panel: the matrices of all stages, as numbers or formulas, for reading and copying.

::

    take --at most every 100 ms, and at rest--> app.lecture.notation.matrices --> MatrixBox
    MatrixView.typed --> app.lecture.typed_matrix.with_cell --> edited

Nothing is computed while the panel is folded. A drag counts as one change of the cells.
"""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QFileDialog, QMenu, QToolButton

from app.document.camera_files import seen_through
from app.document.files import read_letters
from app.lecture.copying import as_latex, as_numpy, as_text
from app.lecture.highlight import NOTHING, Highlight
from app.lecture.letters import LETTERS, Letters
from app.lecture.notation import WrittenMatrix, cell_sign, has_own_signs, matrices
from app.lecture.pasting import Pasted, pasted
from app.lecture.stages import NDC, REACHED_BY
from app.lecture.titles import stage_title
from app.lecture.typed_matrix import (
    EDITABLE,
    MatrixProperty,
    properties,
    rounded_view,
    shown,
    with_cell,
)
from app.model.formula import ARROW
from app.model.limits import finite_matrix
from app.model.matrix_text import is_by_columns, read_matrix
from app.model.projection import Projection
from app.model.refusal import Refusal, format_value
from widgets.panels.cell_words import CellWords
from widgets.panels.matrix_row import MatrixBox, MatrixRow
from widgets.panels.matrix_view import MatrixNotation, MatrixView, add_copies, rich
from widgets.parts.labels import REFUSAL_SHEET, WarningLabel
from widgets.parts.layouts import FREE, in_column, in_row, tool_button
from widgets.parts.messages import read_text, sentence, translated
from widgets.parts.number_field import refusal
from widgets.parts.number_text import parse_number
from widgets.parts.panel import PROJECTION, Changed, ReadablePanel, ShownData
from widgets.parts.wording import Wording

WORDS = Wording(__file__)


def note_on(matrix: WrittenMatrix, projection: Projection, letters: Letters) -> str:
    """Return the note below a matrix, translated; empty for none."""
    if matrix.note:
        return translated(matrix.note, "Stage")
    if matrix.name == "clip_from_world":
        return WORDS.say("divided")
    if not projection.lens.has_steps:
        return _words(properties(projection, matrix.name, read_text), "\n")
    if matrix.name != "clip_from_view" or not has_own_signs(projection, letters):
        return ""
    if projection.depth != "opengl":
        return WORDS.say("sign")
    return WORDS.say("signs" if projection.clip_from_view[3, 2] else "sign-depth")


def _words(properties: Sequence[MatrixProperty], between: str = "; ") -> str:
    """Return the sentences about a matrix, translated."""
    return between.join(translated(text, "Matrix").format(*each) for text, each in properties)


class MatrixPanel(ReadablePanel):
    """All matrices between the object and its picture."""

    concerns = PROJECTION
    sought = Signal(str, bool)  # a factor to see in the dock, and whether to go there
    letters_changed = Signal(str)  # the chosen letters, for panes and panels alike

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Matrices"))
        self.shown: tuple[WrittenMatrix, ...] = ()
        self._highlight = NOTHING
        self._projection: Projection | None = None
        self._before: Projection | None = None
        self._plan: object = None
        self._unfolded: set[str] = set()
        self._speaker: MatrixView | None = None  # the view whose cell is explained
        self._stop = NDC
        self._earlier: tuple[object, tuple[WrittenMatrix, ...]] = (None, ())
        self._words = CellWords(self)
        self._row = MatrixRow()
        self._lay_out()

    def _lay_out(self) -> None:
        self.cells, self.vectors = WORDS.combo("cells"), WORDS.combo("vectors")
        self.letters = WORDS.combo("letters")
        for place, letters in enumerate(LETTERS):
            if letters != "own":
                tip = WORDS.say("of-lecture", letters)
                self.letters.setItemData(place, tip, Qt.ItemDataRole.ToolTipRole)
        for box in (self.cells, self.vectors, self.letters):
            box.currentIndexChanged.connect(self._readable.changed)
        self.letters.currentIndexChanged.connect(lambda _: self.letters_changed.emit(self._letters))
        name, tip, _ = WORDS["file"]
        self.file = tool_button("\u2026", tip, self._ask_for_letters, name=name)
        self.running = WORDS.check("running", self._readable.changed)
        self.copy = WORDS.tool("copy")
        self.copy.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.copy.setMenu(QMenu(self.copy))
        add_copies(self.copy.menu(), lambda form: self._copy(form, *self.shown))
        self.explanation = WarningLabel()
        self.explanation.set_is_warning(False)
        self.explanation.setAccessibleDescription(WORDS.say("about-cell"))
        self.explanation.setMinimumHeight(2 * self.fontMetrics().height())
        self.explanation.setAlignment(Qt.AlignmentFlag.AlignTop)
        bar = in_row(
            self.cells, self.vectors, self.letters, self.file, self.running, FREE, self.copy
        )
        parts = (bar, (self._row, 1), self.explanation)
        in_column(*parts, on=self, margins=(2, 0, 2, 2), gap=2)

    @property
    def _letters(self) -> Letters:
        return str(self.letters.currentData())

    def choose_letters(self, letters: Letters) -> None:
        """Take a lecture's letters, or those of a file, which stand last in the list."""
        if self.letters.findData(letters) < 0:
            self.letters.removeItem(len(LETTERS))
            self.letters.addItem(WORDS.say("of-file"), letters)
        self.letters.setCurrentIndex(self.letters.findData(letters))

    def _ask_for_letters(self) -> None:
        title, _, kinds = WORDS["file"]
        path, _ = QFileDialog.getOpenFileName(self.window(), title, "", kinds)
        if not path:
            return
        try:
            self.choose_letters(read_letters(path))
        except Refusal as error:
            self._explain(refusal(sentence(error)), REFUSAL_SHEET)

    @property
    def _writing(self) -> MatrixNotation:
        formulas = self.cells.currentData() == "formulas"
        return MatrixNotation(
            self._letters, self.vectors.currentData() == "rows", formulas, style=self._style
        )

    def _new_view(self, name: str) -> MatrixView:
        view = MatrixView(stage_title(name), self.sentence, editable=name in EDITABLE)
        view.pointed.connect(partial(self._explain_cell, view))
        view.copied.connect(self._copy)
        view.highlighted.connect(self.highlighted)
        view.show_highlight(self._highlight)
        view.typed.connect(partial(self._typed, view, name))
        view.pasted.connect(partial(self._pasted, view, name))
        # The view of that time: another lens has other views.
        view.moved_on.connect(lambda *cell: self.views[name].edit_cell(*cell))
        return view

    # -- words

    def sentence(self, matrix: WrittenMatrix, row: int, column: int) -> str:
        writing = self._writing
        typed = matrix.name in EDITABLE and not writing.formulas
        return self._words.sentence(
            matrix, row, column, writing.letters, rows=writing.rows, typed=typed
        )

    def _explain_cell(self, view: MatrixView, text: str) -> None:
        self._speaker = view
        self._explain(text)

    def _explain(self, text: str, sheet: str = "") -> None:
        self.explanation.setStyleSheet(sheet)
        self.explanation.set_is_warning(bool(sheet))
        self.explanation.setText(rich(text) if ARROW in text else text)

    # -- typing

    def _typed(self, view: MatrixView, name: str, row: int, column: int, text: str) -> None:
        """Accept the text of a cell, or say why it is refused."""
        if self._projection is None:
            return
        into, of = (column, row) if self._writing.rows else (row, column)
        cell = WORDS.say("cell", stage_title(name), row + 1, column + 1)
        try:
            value = parse_number(cell, text)
            sign = cell_sign(self._projection, self._letters, name, into, of)
            projection = with_cell(self._projection, name, into, of, sign * value)
        except Refusal as error:
            view.refuse()
            if error.field == f"{name}[{into}, {of}]":  # the model's name of the cell
                error = Refusal(cell, error.value, error.bound, *error.limits)
            self._explain(refusal(sentence(error)), REFUSAL_SHEET)
            return
        if "/" in text:
            self.adjusted.emit(WORDS.say("quotient", text.strip(), format_value(value)))
        cells: Any = [list(line) for line in shown(self._projection, name)]
        self._edit(projection)
        cells[into][of] = sign * value
        if name == "view_from_world" and projection.has_camera:
            rounding = _words(rounded_view(projection, finite_matrix(name, cells), read_text))
            if rounding:
                self._explain(rounding)

    def _edit(self, projection: Projection) -> None:
        if projection != self._projection:
            self._show(projection)
            self._readable.settle()
            self.edited.emit(projection)

    def _pasted(self, view: MatrixView, name: str, text: str) -> None:
        """Take a whole matrix; where it has several meanings, ask for one in a menu."""
        projection = self._projection
        if projection is None:
            return
        try:
            rows = read_matrix(text, stage_title(name))
            if np.shape(rows) == (3, 4) and (name != "view_from_world" or _has_focal_length(rows)):
                projection = seen_through(rows, projection)
                view.abandon()
                self._edit(projection)
                return
            is_k = name == "clip_from_view" and len(rows) == 3
            if self._writing.rows and not (is_by_columns(text) or is_k):
                rows = [list(row) for row in zip(*rows, strict=True)]
            signed = [
                [cell_sign(projection, self._letters, name, i, j) * x for j, x in enumerate(row)]
                for i, row in enumerate(rows)
            ]
            meanings = pasted(projection, name, signed, read_text)
            if signed != rows and not meanings[0].properties:  # of another program, not a lecture's
                meanings = pasted(projection, name, rows, read_text)
        except Refusal as error:
            self._explain(refusal(sentence(error)), REFUSAL_SHEET)
            return
        view.abandon()
        if len(meanings) == 1:
            self._take_meaning(meanings[0])
            return
        menu = QMenu(view)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(WORDS.say("may-mean")).setEnabled(False)
        for meaning in meanings:
            menu.addAction(_words(meaning.properties), partial(self._take_meaning, meaning))
        menu.popup(view.mapToGlobal(view.cell_rect(*view.place).bottomLeft().toPoint()))

    def _take_meaning(self, meaning: Pasted) -> None:
        self._edit(meaning.projection)
        self._explain(_words(meaning.properties))

    def _in_hand(self) -> tuple[str, int, tuple[int, int]] | None:
        """Return name, left edge and cell of the matrix that has the focus."""
        focus = self.window().focusWidget()
        for name, view in self.views.items():
            if focus is not None and focus in (view, view.field):
                return name, self._row.left_of(view), view.place
        return None

    # -- the model

    def begin_gesture(self) -> None:
        """Compare with the present matrices until `end_gesture`."""
        if not self._readable.in_gesture:
            self._before = self._projection
        super().begin_gesture()

    def end_gesture(self) -> None:
        super().end_gesture()
        self._fit()

    def _fit(self) -> None:
        """Shrink the columns, unless numbers change quickly or one is being typed."""
        if not self._readable.in_gesture and self._in_hand() is None:
            for view in self.views.values():
                view.fit()

    def prepare(self, projection: Projection) -> None:
        """Work out the formulas, which are kept, and make the boxes before the panel opens."""
        self._matrices(projection)
        if self._plan is None:
            self._projection = projection
            self._fill()

    def take(self, shown: ShownData, changed: Changed) -> None:
        self._show(shown.projection)

    def _show(self, projection: Projection) -> None:
        if projection == self._projection:  # made here
            return
        if not self._readable.in_gesture:
            self._before = self._projection
        self._projection = projection
        if not self.isVisible():
            self._before = None
        self._readable.changed()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._plan = None  # new views measure the new font
            self.explanation.setMinimumHeight(2 * self.fontMetrics().height())
            self._readable.changed()

    @property
    def views(self) -> dict[str, MatrixView]:
        """The views by the names of their matrices; factors are ``stage/factor``."""
        views: dict[str, MatrixView] = {}
        for matrix, box in zip(self.shown, self._row.boxes, strict=True):
            names = (matrix.name, *(f"{matrix.name}/{factor.name}" for factor in matrix.factors))
            views |= zip(names, box.views, strict=True)
        return views

    def _matrices(self, projection: Projection) -> tuple[WrittenMatrix, ...]:
        rows, running = self._writing.rows, self.running.isChecked()
        return matrices(projection, self._letters, rows=rows, running=running)

    def _fill(self) -> None:
        if self._projection is None:
            return
        in_hand, writing = self._in_hand(), self._writing
        self.shown = self._matrices(self._projection)
        before: dict[str, WrittenMatrix] = {}
        if self._before is not None:
            key = (self._before, writing.letters, writing.rows, self.running.isChecked())
            if self._earlier[0] != key:
                self._earlier = (key, self._matrices(self._before))
            before = {matrix.name: matrix for matrix in self._earlier[1]}
        plan = [(matrix.name, [f.name for f in matrix.factors]) for matrix in self.shown]
        anew, self._plan = plan != self._plan, plan
        if anew:
            self._build()
        for matrix, box in zip(self.shown, self._row.boxes, strict=True):
            title = stage_title(matrix.name)
            if properties(self._projection, matrix.name):
                title = WORDS.say("free", title)
            note = note_on(matrix, self._projection, writing.letters)
            box.show_matrix(matrix, before.get(matrix.name), title, note, writing)
        self._fit()
        self._mark_reached()
        if anew and in_hand is not None and in_hand[0] in self.views:
            name, left_px, cell = in_hand
            self._row.keep_in_place(self.views[name], left_px)
            self.views[name].take_over(cell)
        if self._speaker is not None:
            self._speaker.describe_again()

    def _build(self) -> None:
        boxes = []
        for matrix in self.shown:
            box = MatrixBox(matrix, self._new_view, unfolded=matrix.name in self._unfolded)
            box.unfolded.connect(partial(self._folded, matrix.name))
            for factor, view in zip(matrix.factors, box.factor_views, strict=True):
                view.sought.connect(partial(self.sought.emit, f"{matrix.name}/{factor.name}"))
            boxes.append(box)
        self._row.fill(boxes)
        if self._speaker is not None:  # `fill` may emit its sentence by moving the focus
            self._speaker = None
            self._explain("")

    def _folded(self, name: str, unfolded: bool) -> None:
        (self._unfolded.add if unfolded else self._unfolded.discard)(name)

    # -- what stands out

    def show_object(self) -> None:
        """Unfold the factors of the object's matrix, which stands first, and go to it."""
        for box in self._row.boxes[:1]:
            box.fold.setChecked(True)
            self._row.scroll_to(box)
            box.view.setFocus()

    def show_highlight(self, highlighted: Highlight) -> None:
        self._highlight = highlighted
        for box in self._row.boxes:  # as drawn: the model may have changed since
            for view in box.views:
                view.show_highlight(highlighted)
        self._show_rows()

    def _show_rows(self) -> None:
        if self.isVisible():
            self._row.show_rows(self._highlight)

    def show_stage(self, position: float) -> None:
        """Highlight the matrix that leads to this position of the stage strip."""
        stop = int(max(position, 0.0) + 0.5)
        if stop != self._stop:
            self._stop = stop
            reached = self._mark_reached()
            if reached is not None and self.isVisible():
                self._row.scroll_to(reached)

    def _mark_reached(self) -> MatrixBox | None:
        by_name = {box.name: box for box in self._row.boxes}
        candidates = (by_name[name] for name in REACHED_BY[self._stop] if name in by_name)
        reached = next(candidates, None)
        for box in self._row.boxes:
            box.mark_reached(box is reached)
        return reached

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        QTimer.singleShot(0, self, self._show_rows)  # after the layout of the matrices

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._row.close_gap()

    # -- copying

    def _copy(self, form: str, *copied: WrittenMatrix) -> None:
        letters, formulas = self._letters, self._writing.formulas
        write = as_latex if form == "latex" else as_text
        texts = (
            as_numpy(each) if form == "numpy" else write(each, letters, formulas=formulas)
            for each in copied
        )
        QGuiApplication.clipboard().setText("\n".join(texts))


def _has_focal_length(rows: list[list[float]]) -> bool:
    """Whether a matrix (3, 4) is a camera's P = K [R | t] in pixels, not [R | t] alone."""
    return 10.0 < float(np.linalg.cond(np.array(rows)[:, :3])) < 1e12
