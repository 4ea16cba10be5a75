"""The matrices panel: every stage's matrix in a row, as numbers or formulas, to read and copy.

::

    MatrixPanel.take --at most every 100 ms, and at rest--> app.lecture.notation.matrices
                                --what changed--> MatrixView, one for each matrix and factor

    MatrixView.typed --a cell's text--> app.lecture.typed_matrix.with_cell --> MatrixPanel.edited

Nothing is computed while the panel is folded. A drag counts as one change of the cells.
"""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from functools import partial
from typing import cast

from PySide6.QtCore import QCoreApplication, QEvent, QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QMenu,
    QSizePolicy,
    QSpacerItem,
    QToolButton,
    QWidget,
)

from app.drawings.style import LIGHT, Style
from app.lecture.highlight import NOTHING, Highlight
from app.lecture.notation import (
    LETTERS,
    Letters,
    Matrix,
    as_latex,
    as_numpy,
    as_text,
    cell_sign,
    cell_text,
    has_own_signs,
    matrices,
    written,
)
from app.lecture.stages import NDC, REACHED_BY
from app.lecture.typed_matrix import EDITABLE, properties, with_cell
from app.model.formula import ARROW
from app.model.projection import Projection
from app.model.refusal import Refusal
from widgets.panels.matrix_view import VIEW, MatrixView, is_a_cameras, rich
from widgets.parts.buttons import tool_button
from widgets.parts.combo import Combo
from widgets.parts.icons import REFUSAL_SHEET, WarningLabel, show_icon
from widgets.parts.layouts import FREE, Part, in_column, in_row, scrolled
from widgets.parts.messages import field_name, read_text, sentence, stage_title, translated
from widgets.parts.number_field import refusal
from widgets.parts.number_text import parse_number
from widgets.parts.panel import PROJECTION, Changed, Shown
from widgets.parts.plain import Label, set_tip
from widgets.parts.readable import ReadablePanel

_NOTE_CHARACTERS = 36
"""Characters in a line of a note, which shall not be wider than its matrix."""


def _named(matrix: Matrix) -> str:
    """What a lecture calls a matrix, with its subscripts."""
    return re.sub(r"_(\S+)", r"<sub>\1</sub>", matrix.called)


def note_on(matrix: Matrix, projection: Projection, letters: Letters) -> str:
    """What is to be said of a matrix beside its cells; empty for nothing."""
    if matrix.note:
        return translated(matrix.note, "Stage")
    if matrix.name == "clip_from_world":
        return QCoreApplication.translate("MatrixPanel", "then x, y and z are divided by w")
    if not projection.lens.has_steps:
        found = [
            translated(template, "Matrix").format(*figures)
            for template, figures in properties(projection, matrix.name, read_text)
        ]
        return "\n".join(found)
    if matrix.name != "clip_from_view":
        return ""
    if not has_own_signs(projection, letters):
        return ""
    if projection.depth != "opengl":
        return QCoreApplication.translate("MatrixPanel", "with lecture 002's sign: w = z")
    if not projection.clip_from_view[3, 2]:
        return QCoreApplication.translate(
            "MatrixPanel", "with lecture 002's sign: z runs from 1 at near to −1"
        )
    return QCoreApplication.translate(
        "MatrixPanel", "with lecture 002's signs: w = z, and z runs from 1 at near to −1"
    )


class _Box(QWidget):
    """A matrix under its name, with its factors beside it, folded until they are asked for."""

    def __init__(self, panel: MatrixPanel, matrix: Matrix, unfolded: bool) -> None:
        super().__init__()
        self.name = matrix.name
        self.title = Label()
        self.title.setObjectName("paneTitle")
        self.fold = tool_button(
            "", self.tr("Show the factors that this matrix is the product of"),
            name=self.tr("Factors of {0}").format(stage_title(matrix.name)),
            flat=True, checkable=True,
        )  # fmt: skip
        self.fold.setChecked(unfolded)
        fixed = self.fold.sizePolicy()
        fixed.setRetainSizeWhenHidden(True)  # or titles without one would stand higher
        self.fold.setSizePolicy(fixed)
        self.view = panel.new_view(matrix.name)
        self.factor_views = [panel.new_view(factor.name) for factor in matrix.factors]
        self.factor_names = [Label() for _ in matrix.factors]
        self.factors = QWidget()
        inner: list[Part] = []
        for view, name in zip(self.factor_views, self.factor_names, strict=True):
            inner += Label("·" if inner else "="), in_column(view, name, FREE, gap=1)
        in_row(*inner, on=self.factors, margins=(0, 0, 0, 0), gap=4)
        self.note = Label()
        self.note.setObjectName("paneNote")
        self.note.hide()
        both = in_row(self.view, self.factors, FREE, gap=4)
        both.setAlignment(self.view, Qt.AlignmentFlag.AlignTop)
        title = in_row(self.title, self.fold, FREE, gap=4)
        in_column(title, both, self.note, FREE, on=self, margins=(0, 0, 6, 0), gap=1)
        if not matrix.factors:
            self.fold.hide()
        self.factors.setVisible(unfolded and bool(matrix.factors))
        self.fold.toggled.connect(self.factors.setVisible)

    @property
    def views(self) -> tuple[MatrixView, ...]:
        """Of the matrix, and of its factors."""
        return (self.view, *self.factor_views)


class MatrixPanel(ReadablePanel):
    """Every matrix between the object and its picture."""

    concerns = PROJECTION
    letters_changed = Signal(str)
    """Whose letters are chosen: for panes and panels alike."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Matrices"))
        self._highlight = NOTHING
        self._projection: Projection | None = None
        self._before: Projection | None = None
        self._style = LIGHT
        self._shown: tuple[Matrix, ...] = ()
        self._boxes: list[_Box] = []
        self._plan: object = None
        self._unfolded: set[str] = set()
        self._speaker: MatrixView | None = None
        """Whose cell the explanation is about."""
        self._gap: QSpacerItem | None = None
        """Keeps a matrix in its place whose neighbours have gone."""
        self._stop = NDC
        self._earlier: tuple[object, tuple[Matrix, ...]] = (None, ())
        self._lay_out()

    def _lay_out(self) -> None:
        self.cells = self._choice(
            self.tr("Cells"), self.tr("What each cell shows"),
            (("numbers", self.tr("Numbers")), ("formulas", self.tr("Formulas"))),
        )  # fmt: skip
        self.vectors = self._choice(
            self.tr("Vectors"),
            self.tr("Points as columns, right of the matrix, or as rows, left of it: then every "
                    "matrix is transposed and every product turned round"),
            (("columns", self.tr("Column vectors")), ("rows", self.tr("Row vectors"))),
        )  # fmt: skip
        self.letters = self._choice(
            self.tr("Letters"),
            self.tr("Whose letters the formulas are written in: those of vectors are bold; lecture "
                    "002 has its own signs too"),
            (
                ("own", self.tr("own: u v n, n f, fov")),
                ("000", self.tr("x_min … z_max")),
                ("001", self.tr("u v w, θ")),
                ("002", self.tr("z_n z_f, both negative")),
                ("003", self.tr("e, n f")),
                ("004", self.tr("x_0 y_0 z_0, V")),
            ),
        )  # fmt: skip
        for place, letters in enumerate(LETTERS):
            if letters != "own":
                tip = self.tr("Those of lecture {0}").format(letters)
                self.letters.setItemData(place, tip, Qt.ItemDataRole.ToolTipRole)
        self.letters.currentIndexChanged.connect(lambda _: self.letters_changed.emit(self._letters))
        self.running = QCheckBox(self.tr("Running products"))
        set_tip(
            self.running,
            self.tr("Also the product of all stages so far, and the view matrix's inverse, whose "
                    "columns are the camera's axes and the eye")
        )  # fmt: skip
        self.running.toggled.connect(self._readable.changed)
        self.copy = tool_button(
            self.tr("Copy all"),
            self.tr("Copy every matrix shown, in the order of the stages"),
            name=self.tr("Copy all matrices"),
        )
        self.copy.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self.copy)
        for form, text in (
            ("text", self.tr("As text")),
            ("numpy", self.tr("For NumPy (numbers)")),
            ("latex", self.tr("For LaTeX (needs amsmath)")),
        ):
            menu.addAction(text, partial(self._copy_all, form))
        self.copy.setMenu(menu)
        self._bar = in_row(
            self.cells, self.vectors, self.letters, self.running, FREE, self.copy
        )  # fmt: skip
        self._content = QWidget()
        self._row = in_row(FREE, on=self._content, margins=(2, 0, 2, 0), gap=6)
        self._scroll = scrolled(self._content, self.tr("Matrices"))
        self.explanation = WarningLabel()
        self.explanation.set_warns(False)
        self.explanation.setAccessibleDescription(self.tr("About the cell"))
        self.explanation.setMinimumHeight(2 * self.fontMetrics().height())
        self.explanation.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._lay_out_ends()
        row = in_row(self._to_left, (self._scroll, 1), self._to_right, gap=0)
        parts = (self._bar, (row, 1), self.explanation)
        in_column(*parts, on=self, margins=(2, 0, 2, 2), gap=2)

    def _lay_out_ends(self) -> None:
        """Make what says at both ends of the row that it goes on there, and goes there."""
        tip = self.tr("More matrices: bring the next one that is cut, or not seen, into view")
        left, right = self.tr("Matrices to the left"), self.tr("Matrices to the right")
        self._to_left = tool_button("", tip, self._go_left, icon="back", name=left, flat=True)
        self._to_right = tool_button("", tip, self._go_right, icon="unfold", name=right, flat=True)
        for end in (self._to_left, self._to_right):
            policy = QSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Ignored)
            policy.setRetainSizeWhenHidden(True)  # or what is read would move
            end.setSizePolicy(policy)
        bar = self._scroll.horizontalScrollBar()
        bar.valueChanged.connect(self._show_ends)
        bar.rangeChanged.connect(self._show_ends)
        self._show_ends()

    def _show_ends(self) -> None:
        bar = self._scroll.horizontalScrollBar()
        self._to_left.setVisible(bar.value() > bar.minimum())
        self._to_right.setVisible(bar.value() < bar.maximum())

    def _go_left(self) -> None:
        """Let the last matrix that is not wholly seen at the left end at the right."""
        bar = self._scroll.horizontalScrollBar()
        page, now = bar.pageStep(), bar.value()
        ends = [box.geometry().right() + 1 - page for box in self._boxes if box.x() < now]
        if ends:  # of one that is wider than the page, the page before
            bar.setValue(ends[-1] if ends[-1] < now else now - page)

    def _go_right(self) -> None:
        """Let the first matrix that is not wholly seen at the right begin at the left."""
        bar = self._scroll.horizontalScrollBar()
        page, now = bar.pageStep(), bar.value()
        starts = [box.x() for box in self._boxes if box.geometry().right() >= now + page]
        if starts:
            bar.setValue(starts[0] if starts[0] > now else now + page)

    def _bring(self, box: _Box) -> None:
        """Let a matrix be seen whole, and none be cut at the left."""
        bar, margin = self._scroll.horizontalScrollBar(), self._boxes[0].x()
        least = box.geometry().right() + 1 - bar.pageStep()
        wanted = min(max(bar.value(), least), box.x() - margin)
        starts = (each.x() - margin for each in self._boxes)
        bar.setValue(min(start for start in starts if start >= wanted))

    def _choice(self, name: str, tip: str, choices: Sequence[tuple[str, str]]) -> Combo:
        box = Combo()
        box.setAccessibleName(name)
        set_tip(box, tip)
        for value, text in choices:
            box.addItem(text, value)
        box.currentIndexChanged.connect(self._readable.changed)
        return box

    def new_view(self, name: str) -> MatrixView:
        """A view of one matrix, wired to the explanation, the clipboard and the model."""
        view = MatrixView(stage_title(name), self.sentence, editable=name in EDITABLE)
        view.pointed.connect(partial(self._said, view))
        view.copied.connect(self._copy_one)
        view.highlighted.connect(self.highlighted)
        view.show_highlight(self._highlight)
        view.typed.connect(partial(self._typed, view, name))
        view.moved_on.connect(partial(self._edit_cell, name))
        return view

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark the cells that speak of what is highlighted."""
        self._highlight = highlighted
        for box in self._boxes:  # as they are drawn: the model may have gone on since
            for view in box.views:
                view.show_highlight(highlighted)
        self._show_rows()

    def _show_rows(self) -> None:
        """Let the matrix be seen whose rows are highlighted as coordinates of clip space."""
        if self.isVisible() and any(name.startswith("clip_") for name in self._highlight):
            for box in self._boxes:  # as they are drawn: the model may have gone on since
                if box.name == "clip_from_view":
                    self._scroll.ensureWidgetVisible(box.view, 8, 0)

    def _edit_cell(self, name: str, row: int, column: int) -> None:
        """Go on in the view of now: another lens has other ones."""
        self.views[name].edit_cell(row, column)

    def _said(self, view: MatrixView, text: str) -> None:
        self._speaker = view
        self._explain(text)

    def _explain(self, text: str, sheet: str = "") -> None:
        self.explanation.setStyleSheet(sheet)
        self.explanation.set_warns(bool(sheet))
        self.explanation.setText(rich(text) if ARROW in text else text)

    def _typed(self, view: MatrixView, name: str, row: int, column: int, text: str) -> None:
        """Take a cell that was typed, or say what is wrong with it."""
        if self._projection is None:
            return
        into, of = (column, row) if self._rows else (row, column)
        cell = self.tr("{0}, row {1}, column {2}").format(stage_title(name), row + 1, column + 1)
        try:
            value = parse_number(cell, text)
            sign = cell_sign(self._projection, self._letters, name, into, of)
            projection = with_cell(self._projection, name, into, of, sign * value)
        except Refusal as error:
            view.refuse()
            if error.field == f"{name}[{into}, {of}]":  # the core's word for it
                error = Refusal(cell, error.value, error.bound, *error.limits)
            self._explain(refusal(sentence(error)), REFUSAL_SHEET)
            return
        if "/" in text:
            taken = self.tr("{0} is taken as {1}, its quotient to all digits of float64.")
            self.told.emit(taken.format(text.strip(), cell_text(value)))
        if projection != self._projection:
            self._show(projection)
            self._readable.settle()
            self.edited.emit(projection)

    def _in_hand(self) -> tuple[str, int, tuple[int, int]] | None:
        """Name, left edge and cell of the matrix that the keyboard is in."""
        focus = self.window().focusWidget()
        for name, view in self.views.items():
            if focus is not None and focus in (view, view.field):
                return name, self._left_of(view), view.place
        return None

    def _left_of(self, view: MatrixView) -> int:
        """Where it stands in what is seen, in px."""
        return view.mapTo(self._scroll.viewport(), QPoint()).x()

    def _keep_in_place(self, view: MatrixView, left_px: int) -> None:
        """Put a view where the hand is, though its neighbours have gone or come."""
        bar = self._scroll.horizontalScrollBar()

        def scroll() -> int:
            """Scroll as far as that helps; how far to the right it has yet to go, in px."""
            QCoreApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)
            # The gap asks for none while an older request of a matrix is on its way.
            QCoreApplication.sendEvent(self._content, QEvent(QEvent.Type.LayoutRequest))
            bar.setValue(bar.value() + self._left_of(view) - left_px)
            return left_px - self._left_of(view)

        away = scroll()
        if away:  # to the left there is no more to scroll to, or to the right
            self._gap = QSpacerItem(abs(away), 0)
            before = next(i for i, box in enumerate(self._boxes) if view in box.views)
            self._row.insertItem(before if away > 0 else len(self._boxes), self._gap)
            scroll()

    # -- the model

    def begin_gesture(self) -> None:
        """Until `end_gesture`, changes are marked against what is shown now."""
        if not self._readable.in_gesture:
            self._before = self._projection
        super().begin_gesture()

    def end_gesture(self) -> None:
        super().end_gesture()
        self._fit()

    def _fit(self) -> None:
        """Narrow every column to its numbers, unless they run, or one is typed beside them."""
        if not self._readable.in_gesture and self._in_hand() is None:
            for box in self._boxes:
                for view in box.views:
                    view.fit()

    def take(self, shown: Shown, changed: Changed) -> None:
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

    def set_style(self, style: Style) -> None:
        """Take over the colours of the drawings."""
        self._style = style
        self.explanation.setMinimumHeight(2 * self.fontMetrics().height())
        self._readable.changed()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._plan = None  # widths are measured anew
            self._readable.changed()

    @property
    def shown(self) -> tuple[Matrix, ...]:
        """The matrices that are shown."""
        return self._shown

    @property
    def views(self) -> dict[str, MatrixView]:
        """The view of each matrix by its name, factors as ``stage/factor``."""
        views = {}
        for matrix, box in zip(self._shown, self._boxes, strict=True):
            views[matrix.name] = box.view
            for factor, view in zip(matrix.factors, box.factor_views, strict=True):
                views[f"{matrix.name}/{factor.name}"] = view
        return views

    def _fill(self) -> None:
        if self._projection is None:
            return
        in_hand = self._in_hand()
        self._shown = self._matrices(self._projection)
        before: dict[str, Matrix] = {}
        if self._before is not None:
            key = (self._before, self._letters, self._rows, self.running.isChecked())
            if self._earlier[0] != key:
                self._earlier = (key, self._matrices(self._before))
            before = {matrix.name: matrix for matrix in self._earlier[1]}
        plan = [(matrix.name, [f.name for f in matrix.factors]) for matrix in self._shown]
        anew, self._plan = plan != self._plan, plan
        if anew:
            self._build()
        settings = {
            "letters": self._letters, "rows": self._rows,
            "formulas": self.cells.currentData() == "formulas", "style": self._style,
        }  # fmt: skip
        for matrix, box in zip(self._shown, self._boxes, strict=True):
            title = stage_title(matrix.name)
            if properties(self._projection, matrix.name):
                title = self.tr("{0}, a free matrix").format(title)
            box.title.setText(f"{title} = {_named(matrix)}" if matrix.called else title)
            factors_of = (f"({stage_title(name)})" for name in matrix.product)
            set_tip(box.title, " = ".join([stage_title(matrix.name), " · ".join(factors_of)])
                                 if matrix.product else stage_title(matrix.name))  # fmt: skip
            note = note_on(matrix, self._projection, self._letters)
            old = before.get(matrix.name)
            box.view.show_matrix(matrix, old, **settings)
            fitting = box.view.width() // max(box.note.fontMetrics().averageCharWidth(), 1)
            wide = max(_NOTE_CHARACTERS, fitting - 2)
            box.note.setText(
                "\n".join(
                    textwrap.fill(line, wide, break_on_hyphens=False) for line in note.splitlines()
                )
            )
            box.note.setVisible(bool(note))
            factors = old.factors if old and len(old.factors) == len(matrix.factors) else None
            for number, view in enumerate(box.factor_views):
                factor = matrix.factors[number]
                name = stage_title(factor.name)
                named = f"{name} = {_named(factor)}" if factor.called else name
                box.factor_names[number].setText(named)
                view.show_matrix(factor, factors[number] if factors else None, **settings)
        self._fit()
        self._light_reached(in_view=False)
        if anew and in_hand is not None and in_hand[0] in self.views:
            name, left_px, cell = in_hand
            self._keep_in_place(self.views[name], left_px)
            self.views[name].take_over(cell)
        if self._speaker is not None:
            self._speaker.say_again()

    @property
    def _letters(self) -> Letters:
        return cast(Letters, self.letters.currentData())

    @property
    def _rows(self) -> bool:
        return bool(self.vectors.currentData() == "rows")

    def _matrices(self, projection: Projection) -> tuple[Matrix, ...]:
        return matrices(
            projection, self._letters, rows=self._rows, running=self.running.isChecked()
        )

    def show_stage(self, position: float) -> None:
        """Light the matrix by which the stage strip has come where it stands."""
        stop = int(position + 0.5)
        if stop != self._stop:
            self._stop = stop
            self._light_reached(in_view=True)

    def _light_reached(self, *, in_view: bool) -> None:
        names = [matrix.name for matrix in self._shown]
        reached = next((name for name in REACHED_BY[self._stop] if name in names), "")
        for name, box in zip(names, self._boxes, strict=True):
            is_reached = name == reached
            if bool(box.title.property("reached")) != is_reached:
                box.title.setProperty("reached", is_reached)
                box.title.setAccessibleDescription(
                    self.tr("the stage strip stands here") if is_reached else ""
                )
                box.title.style().polish(box.title)
            if is_reached and in_view and self.isVisible():
                self._bring(box)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        QTimer.singleShot(0, self, self._show_rows)  # the matrices are laid out then

    def _close_gap(self) -> None:
        if self._gap is not None:
            self._row.removeItem(self._gap)
            self._gap = None

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._close_gap()  # the hand is elsewhere

    def _build(self) -> None:
        self._close_gap()
        for box in self._boxes:
            for view in box.views:
                view.abandon()  # or it would be taken for entered, when the field is hidden
            self._row.removeWidget(box)
            box.hide()
            for view in box.views:
                view.pointed.disconnect()  # a mouse button held on it still tells it of moves
                view.highlighted.disconnect()
            box.deleteLater()
        if self._speaker is not None:  # perhaps only now, when the keyboard left what was hidden
            self._speaker = None
            self._explain("")
        self._boxes = []
        for place, matrix in enumerate(self._shown):
            box = _Box(self, matrix, matrix.name in self._unfolded)
            box.fold.toggled.connect(partial(self._folded, box, matrix.name))
            self._set_arrow(box)
            self._boxes.append(box)
            self._row.insertWidget(place, box, 0, Qt.AlignmentFlag.AlignTop)
            box.show()

    def _folded(self, box: _Box, name: str, unfolded: bool) -> None:
        (self._unfolded.add if unfolded else self._unfolded.discard)(name)
        self._set_arrow(box)

    def _set_arrow(self, box: _Box) -> None:
        show_icon(box.fold, "back" if box.fold.isChecked() else "unfold")

    # -- words

    def sentence(self, matrix: Matrix, row: int, column: int) -> str:
        """What a cell is, does and depends on."""
        value, formula = matrix.values[row][column], matrix.formulas[row][column]
        text = written(formula, self._letters)
        number = read_text(value)
        cell = (
            number if text.replace("−", "-") == number.replace("−", "-") else f"{text} = {number}"
        )
        fields = matrix.fields[row][column]
        if fields:
            depends = self.tr("It depends on: {0}.").format(", ".join(map(field_name, fields)))
        else:
            depends = self.tr("It depends on no control.")
        into, of = (column, row) if self._rows else (row, column)
        place = self.tr("row {0}, column {1}").format(row + 1, column + 1)
        does = self._does(matrix, into, of, value)
        typed = ""
        if matrix.name in EDITABLE and self.cells.currentData() == "numbers":
            typed = self.tr(
                "Double-click or press Enter to type another number, or a fraction such as 1/3."
            )
            typed += " "
        return f"{stage_title(matrix.name)}, {place}: {cell}. {does} {typed}{depends}"

    def _does(self, matrix: Matrix, into: int, of: int, value: float) -> str:
        target, source, number = "xyzw"[into], "xyzw"[of], read_text(value)
        axes = ("u", "v", written("axis_n", self._letters))
        if into < 3 and of < 3 and matrix.name in VIEW and is_a_cameras(matrix):
            text = self.tr(
                "The world's {1} component of the camera's axis {0}: it adds {3} times {1} to {2}."
            )
            return text.format(axes[into], source, target, number)
        if into < 3 and matrix.name == "world_from_view":
            if of == 3:
                return self.tr("The {0} of the eye, where view space has its origin.").format(
                    target
                )
            return self.tr("The world's {1} component of the camera's axis {0}.").format(
                axes[of], target
            )
        if into == 3:
            return self._does_to_w(matrix, source, value, number)
        if into == of:
            if value == 1.0:
                return self.tr("It leaves the scale of {0} as it is.").format(target)
            if value < 0.0:
                return self.tr("It scales {0} by {1}, and so turns it round.").format(
                    target, number
                )
            return self.tr("It scales {0} by {1}.").format(target, number)
        if value == 0.0:
            if of == 3:
                return self.tr("It does not shift {0}.").format(target)
            return self.tr("{1} has no part in {0}.").format(target, source)
        if of == 3:
            if any(
                line != end
                for line, end in zip(self._w_row(matrix), (0.0, 0.0, 0.0, 1.0), strict=True)
            ):
                return self.tr(
                    "It adds {1} to {0} before the divide, and so {1}/w to the quotient."
                ).format(target, number)
            return self.tr("It shifts {0} by {1}.").format(target, number)
        return self.tr("It adds {2} times {1} to {0}: a shear.").format(target, source, number)

    def _does_to_w(self, matrix: Matrix, source: str, value: float, number: str) -> str:
        if value == 0.0:
            if source == "w":
                return self.tr("The w that comes in has no part in w.")
            return self.tr("{0} has no part in w.").format(source)
        if sum(map(bool, self._w_row(matrix))) == 1:
            if source == "w":
                if value == 1.0:
                    return self.tr("It keeps w.")
                return self.tr("It scales w, by which all is divided, by {0}.").format(number)
            if source == "z" and value == -1.0:
                return self.tr("It makes w the distance −z, by which all is divided: perspective.")
        if source == "w" and matrix.name.endswith("_from_world"):  # where every w is 1
            return self.tr("It adds {0} to w, by which all is divided.").format(number)
        if source == "w":
            source = self.tr("the w that comes in")
        return self.tr("It adds {1} times {0} to w, by which all is divided.").format(
            source, number
        )

    def _w_row(self, matrix: Matrix) -> tuple[float, ...]:
        return tuple(row[3] for row in matrix.values) if self._rows else matrix.values[3]

    # -- copying

    def _copy_one(self, form: str, matrix: Matrix) -> None:
        QGuiApplication.clipboard().setText(self._written_out(form, matrix))

    def _copy_all(self, form: str) -> None:
        text = "\n".join(self._written_out(form, matrix) for matrix in self.shown)
        QGuiApplication.clipboard().setText(text)

    def _written_out(self, form: str, matrix: Matrix) -> str:
        if form == "numpy":
            return as_numpy(matrix)
        write = as_latex if form == "latex" else as_text
        return write(matrix, self._letters, formulas=self.cells.currentData() == "formulas")
