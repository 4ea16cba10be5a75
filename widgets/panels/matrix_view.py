"""One 4x4 matrix: it paints its cells, highlights them and lets the user type in them.

A cell whose value differs from before the last change is highlighted, and its digits are underlined
from the first that differs.
"""

import re
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from PySide6 import QtGui
from PySide6.QtCore import QCoreApplication, QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtWidgets import QLineEdit, QMenu, QSizePolicy, QWidget

from app.drawings.style import LIGHT, Style
from app.lecture.highlight import NOTHING, Highlight, made_of
from app.lecture.letters import Letters, stacked, written
from app.lecture.notation import WrittenMatrix, letters_in
from app.model.formula import ARROW
from app.model.matrix_text import LONGEST
from app.model.refusal import format_value
from widgets.parts.messages import all_digits, read_text
from widgets.parts.panel import faded, paint_highlight
from widgets.parts.plain import Markup, set_tip, show_tip
from widgets.parts.typeset import FOOT_PX, RULE_PX, Typeset, paint_brackets, resized, typeset

VIEW = ("view_from_world", "rotation")
TO_CLIP = ("clip_from_view", "clip_from_world")  # matrices whose rows are clip coordinates
ROW_GAP_PX = 3.0
_POWER = re.compile("e|·?10(?=[⁻⁰¹²³⁴⁵⁶⁷⁸⁹])")
_STEPS = {
    Qt.Key.Key_Left: (0, -1), Qt.Key.Key_Right: (0, 1),
    Qt.Key.Key_Up: (-1, 0), Qt.Key.Key_Down: (1, 0),
}  # fmt: skip


class MatrixNotation(NamedTuple):
    """How the panel writes every matrix: letters, rows or columns, numbers or formulas."""

    letters: Letters = "own"
    rows: bool = False  # whether vectors are rows, so that the axes are rows too
    formulas: bool = False
    style: Style = LIGHT


def _parts(text: str) -> tuple[str, str]:
    """The digits of a number, and the power of ten after them."""
    power = _POWER.search(text)
    return (text, "") if power is None else (text[: power.start()], text[power.end() :])


def first_change(before: str, after: str) -> int | None:
    """Return the index of the first digit that differs; None if the texts are equal.

    If the numbers of digits before the point differ, all digits differ, because their weights do.
    """
    if before == after:
        return None
    (number, power), (other, another) = (_parts(text) for text in (before, after))
    if len(number.partition(".")[0]) != len(other.partition(".")[0]) or power != another:
        return 0
    pairs = enumerate(zip(before, after, strict=False))
    return next((i for i, (a, b) in pairs if a != b), min(len(before), len(after)))


def _differences(
    matrix: WrittenMatrix, before: WrittenMatrix | None, writing: MatrixNotation
) -> dict[tuple[int, int], int | None]:
    """Return the cells that differ, each with its first differing digit, or None for a formula."""
    if before is None:
        return {}
    return {
        (i, j): None if writing.formulas else first_change(read_text(old), read_text(new))
        for i, rows in enumerate(zip(before.values, matrix.values, strict=True))
        for j, (old, new) in enumerate(zip(*rows, strict=True))
        if old != new
    }


def is_a_cameras(matrix: WrittenMatrix) -> bool:
    """Whether a matrix is built from a camera's axes; a typed matrix is not."""
    return matrix.name in (*VIEW, "world_from_view") and matrix.formulas[0][0] != "m_11"


def clipboard_text() -> str:
    """Return the text of the clipboard, or as much of it as shows that it is not a matrix."""
    return QtGui.QGuiApplication.clipboard().text()[: LONGEST + 1]


def is_one_number(text: str) -> bool:
    """Whether a text belongs into one cell, and is not the text of a matrix."""
    return len(text) < 100 and len(re.split(r"[\s,;&|/]+", text.strip())) <= 3


class _CellField(QLineEdit):
    """The input field of a cell: Tab goes to the next cell, Esc discards the text."""

    left = Signal()
    moved_on = Signal(int)
    pasted = Signal(str)  # the text of a whole matrix

    def __init__(self, text: str, view: QWidget) -> None:
        super().__init__(text, view)
        self._view = view
        self.is_refused = False  # whether the text was refused, and has not been edited since
        self.textEdited.connect(self._mend)

    def _mend(self) -> None:
        self.is_refused = False

    def cover(self, cell: QRectF) -> None:
        """Lie over a cell, as wide as the typed text needs."""
        wide = QtGui.QFontMetricsF(self._view.font()).horizontalAdvance(self.text() + "00") + 8.0
        room = float(self._view.width())
        wide = min(max(wide, cell.width()), room)
        left = max(min(cell.right() - wide, room - wide), 0.0)
        self.setGeometry(int(left), int(cell.top()), int(wide), int(cell.height()))

    def event(self, event: QEvent) -> bool:
        kinds, keys = QEvent.Type, Qt.Key
        takes = event.type() in (kinds.ShortcutOverride, kinds.KeyPress)
        if takes and isinstance(event, QtGui.QKeyEvent):
            acts: dict[Qt.Key, Callable[[], object]] = {
                keys.Key_Return: self.returnPressed.emit,
                keys.Key_Enter: self.returnPressed.emit,
                keys.Key_Escape: self.left.emit,
                keys.Key_Tab: partial(self.moved_on.emit, 1),
                keys.Key_Backtab: partial(self.moved_on.emit, -1),
            }
            act = acts.get(keys(event.key()))
            text = clipboard_text()
            if event.matches(QtGui.QKeySequence.StandardKey.Paste) and not is_one_number(text):
                act = partial(self.pasted.emit, text)
            if act is not None:
                event.accept()  # QLineEdit forwards Enter to the view, which would open a cell
                if event.type() == kinds.KeyPress:
                    act()
                return True
        return super().event(event)


class MatrixView(QWidget):
    """One 4x4 matrix; the mouse or the arrow keys point at its cells.

    A double click, F2 or Enter opens the number of a cell for typing if the matrix is `editable`.
    `title` is for screen readers; `explain` returns the sentence about a cell.
    """

    pointed = Signal(str)  # the sentence about the cell under the mouse or the cursor
    copied = Signal(str, object)
    """A format (``"text"``, ``"numpy"``, ``"latex"``) and the matrix to copy in it."""
    highlighted = Signal(object)
    """The `Highlight` of the cell under the mouse or the cursor; only when it changes."""
    typed = Signal(int, int, str)  # row, column and text of a cell; the receiver may call `refuse`
    pasted = Signal(str)  # the text of a whole matrix
    sought = Signal(bool)  # the user points at a matrix that is typed elsewhere, or goes there
    moved_on = Signal(int, int)  # row and column of the next cell to type in

    def __init__(
        self,
        title: str,
        explain: Callable[[WrittenMatrix, int, int], str],
        *,
        editable: bool = False,
    ) -> None:
        super().__init__()
        self.setAccessibleName(title)
        self._explain, self._editable = explain, editable
        self.field: _CellField | None = None  # the field of the cell that is being typed
        self.place = (0, 0)  # row and column of the keyboard's cursor
        self.texts: list[list[str]] = []  # cells' texts; formulas are for `widgets.parts.typeset`
        self._matrix: WrittenMatrix | None = None
        self._changed: dict[tuple[int, int], int | None] = {}
        """The first changed digit, by row and column of the cells that differ from before."""
        self._columns = self._fitting = [0.0] * 4
        """Widths of the columns, and the widths that the present texts need."""
        self._heights = [QtGui.QFontMetricsF(self.font()).height() + ROW_GAP_PX] * 4
        self._writing = MatrixNotation()
        self._written: tuple[object, ...] = ()
        self._highlight = self._pointed_at = NOTHING
        self._described: tuple[int, int] | None = None  # the cell of the last sentence
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def show_matrix(
        self, matrix: WrittenMatrix, before: WrittenMatrix | None, writing: MatrixNotation
    ) -> None:
        """Show a matrix, and mark the cells that differ from `before`."""
        written_before, self._written = self._written, (writing, all_digits.now)
        rewritten = self._written != written_before
        old, self._matrix = self._matrix, matrix
        if old is not None and (writing != self._writing or old.values != matrix.values):
            self.abandon()
        self._writing = writing
        changed = _differences(matrix, before, writing)
        if not rewritten and old == matrix and changed == self._changed:
            return
        self._changed = changed
        if writing.formulas:
            self.texts = [[stacked(cell, writing.letters) for cell in r] for r in matrix.formulas]
        else:
            self.texts = [[read_text(value) for value in row] for row in matrix.values]
        self._measure(rewritten or old is None or old.name != matrix.name)
        if self.hasFocus():
            self._describe_cell()
        self.update()

    # -- places

    def _small(self) -> QtGui.QFont:
        return resized(self.font(), 0.75)

    def _typeset(self, text: str) -> Typeset:
        return typeset(text, self.font(), is_formula=self._writing.formulas)

    def _measure(self, anew: bool) -> None:
        height = QtGui.QFontMetricsF(self.font()).height()
        cells = [[self._typeset(text) for text in row] for row in self.texts]
        widths = [max(row[j].width for row in cells) + 0.8 * height for j in range(4)]
        # While numbers change quickly, columns only grow, because a jumping row cannot be read.
        self._fitting = widths
        self._columns = widths if anew else list(map(max, self._columns, widths))
        # A subscript hangs into the gap between two rows, a fraction does not.
        self._heights = [
            max(height, *(cell.height - (0.0 if cell.rules else 2.0) for cell in row)) + ROW_GAP_PX
            for row in cells
        ]
        self._take_room()

    def fit(self) -> None:
        """Shrink the columns to their texts, once the numbers stand still."""
        if self._columns != self._fitting:
            self._columns = self._fitting
            self._take_room()
            self.update()

    def _take_room(self) -> None:
        size = self.sizeHint()
        if size != self.minimumSize():
            self.setFixedSize(size)
        if self.field is not None:
            self.field.cover(self.cell_rect(*self.place))

    @property
    def _margin(self) -> tuple[float, float]:
        """Return left and top of the first cell, beyond the axes' letters and the bracket.

        Space for letters above is always reserved, so that all matrices are aligned.
        """
        plate = QtGui.QFontMetricsF(self._small()).height() + 2.0
        return (plate + 8.0 if self._axes_are_rows else 8.0), plate + 2.0

    @property
    def _axes_are_rows(self) -> bool:
        return (self._matrix is not None and self._matrix.name in VIEW) is not self._writing.rows

    def sizeHint(self) -> QSize:
        left, top = self._margin
        return QSize(int(left + sum(self._columns) + 8.0), int(top + sum(self._heights) + 4.0))

    def cell_rect(self, row: int, column: int) -> QRectF:
        left, top = self._margin
        return QRectF(
            left + sum(self._columns[:column]), top + sum(self._heights[:row]),
            self._columns[column], self._heights[row],
        )  # fmt: skip

    def _cell_at(self, place: QPointF) -> tuple[int, int] | None:
        cells = ((i, j) for i in range(4) for j in range(4))
        return next((cell for cell in cells if self.cell_rect(*cell).contains(place)), None)

    # -- painting

    def paintEvent(self, _event: QtGui.QPaintEvent) -> None:
        if self._matrix is None:
            return
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        ink, accent = self.palette().windowText().color(), QtGui.QColor(self._writing.style.accent)
        self._paint_axes(painter, self._matrix)
        painter.setPen(QtGui.QPen(ink, RULE_PX))
        (left, top), wide, high = self._margin, sum(self._columns), sum(self._heights)
        paint_brackets(painter, QRectF(left - 2.0, top, wide + 4.0, high), FOOT_PX)
        for i, row in enumerate(self.texts):
            for j, text in enumerate(row):
                rect = self.cell_rect(i, j)
                if (i, j) in self._changed:
                    painter.fillRect(rect.adjusted(1, 1, -1, -1), faded(accent, 0.3))
                    painter.setPen(QtGui.QPen(accent, 1.0))
                    painter.drawRect(rect.adjusted(1.5, 1.5, -1.5, -1.5))
                if self.is_marked(i, j):
                    paint_highlight(self, painter, rect.adjusted(1, 1, -1, -1))
                painter.setPen(faded(ink, 0.45) if text == "0" else ink)
                self._paint_text(painter, rect, text, self._changed.get((i, j)))
        if self.hasFocus():
            painter.setPen(QtGui.QPen(self.palette().highlight().color(), 2.0))
            painter.drawRect(self.cell_rect(*self.place).adjusted(1, 1, -1, -1))
        painter.end()

    def _paint_axes(self, painter: QtGui.QPainter, matrix: WrittenMatrix) -> None:
        left, top = self._margin
        painter.setFont(self._small())
        plate = QtGui.QFontMetricsF(self._small()).height()
        third = written("axis_n", self._writing.letters).removesuffix(ARROW)
        style = self._writing.style
        names = ("u", "v", third) if is_a_cameras(matrix) else ("x", "y", "z")
        for k, (name, shade) in enumerate(zip(names, (style.u, style.v, style.n), strict=True)):
            if self._axes_are_rows:
                cell = self.cell_rect(k, 0)
                rect = QRectF(0.0, cell.top() + 1.0, plate, cell.height() - 2.0)
                band = QRectF(left, cell.top(), sum(self._columns), cell.height())
            else:
                cell = self.cell_rect(0, k)
                rect = QRectF(cell.left() + 2.0, 0.0, cell.width() - 4.0, plate)
                band = QRectF(cell.left(), top, cell.width(), sum(self._heights))
            colour = QtGui.QColor(shade)
            painter.fillRect(band, faded(colour, 0.12))
            painter.fillRect(rect, colour)
            painter.setPen(QtGui.QColor(style.text_on(colour.name())))
            painter.drawText(rect, Qt.AlignmentFlag.AlignCenter, name)
        painter.setFont(self.font())

    def _paint_text(
        self, painter: QtGui.QPainter, rect: QRectF, text: str, mark: int | None
    ) -> None:
        metrics, cell = QtGui.QFontMetricsF(self.font()), self._typeset(text)
        end = rect.right() - 0.4 * metrics.height()
        base = rect.center().y() + cell.below_middle
        cell.paint(painter, end - cell.width, base)
        if mark is not None:
            start = end - metrics.horizontalAdvance(text[mark:] or text[-1:])
            painter.setPen(QtGui.QPen(painter.pen().color(), 2.0))
            painter.drawLine(QPointF(start, base + 3.0), QPointF(end, base + 3.0))

    # -- typing

    def edit_cell(self, row: int, column: int) -> None:
        """Open a cell for typing, with all its digits, if the matrix shows editable numbers."""
        if not self._editable:
            self.sought.emit(True)
        if not self._editable or self._writing.formulas or self._matrix is None:
            return
        self.abandon()
        self.place = (row, column)
        self.field = field = _CellField(format_value(self._matrix.values[row][column]), self)
        place = self.tr("{0}, row {1}, column {2}")
        field.setAccessibleName(place.format(self.accessibleName(), row + 1, column + 1))
        field.setPlaceholderText("1/3")
        set_tip(
            field, self.tr("A number, or a fraction such as 1/3, which is divided to all digits")
        )
        field.cover(self.cell_rect(row, column))
        field.setStyleSheet("padding: 0px; margin: 0px")
        field.returnPressed.connect(self._enter)
        field.editingFinished.connect(self._left_field)
        field.left.connect(self.abandon)
        field.moved_on.connect(self._move_on)
        field.pasted.connect(self.pasted)
        field.selectAll()
        self._describe_cell()
        field.show()
        field.setFocus()

    def take_over(self, place: tuple[int, int]) -> None:
        """Take over the focus from another view, at the same cell."""
        self.place = place
        self._describe_cell()
        self.setFocus()

    def refuse(self) -> None:
        """Keep the refused text open, in a frame, so that it can be corrected."""
        if self.field is not None:
            self.field.is_refused = True
            frame = f"border: 2px solid {self._writing.style.far}"
            self.field.setStyleSheet(f"padding: 0px; margin: 0px; {frame}")

    def _enter(self) -> bool:
        """Submit the text; return whether it was accepted."""
        field = self.field
        if field is None or field.is_refused:
            return False
        if field.isModified():
            field.setModified(False)
            self.typed.emit(*self.place, field.text())
            if field.is_refused:
                field.setModified(True)
                return False
        self.abandon()
        return True

    def _left_field(self) -> None:
        if self.field is not None and not self.field.hasFocus() and not self._enter():
            self.abandon()  # the text will not be corrected: the previous number stays

    def _move_on(self, step: int) -> None:
        place = (4 * self.place[0] + self.place[1] + step) % 16
        if self._enter():
            self.moved_on.emit(*divmod(place, 4))

    def abandon(self) -> None:
        """Close the field of a cell, if one is open; the previous number stays."""
        field, self.field = self.field, None
        if field is not None:
            had_focus = self.window().focusWidget() is field
            field.hide()
            field.deleteLater()
            if had_focus:
                self.setFocus()
            self.update()

    def mouseDoubleClickEvent(self, event: QtGui.QMouseEvent) -> None:
        cell = self._cell_at(event.position())
        if cell is not None and event.button() == Qt.MouseButton.LeftButton:
            self.edit_cell(*cell)

    # -- pointing

    def _describe_cell(self) -> None:
        if self._matrix is not None:
            self._described = self.place
            sentence = self._explain(self._matrix, *self.place)
            self.setAccessibleDescription(sentence)
            self.pointed.emit(sentence)
            self._point_at(self.place)

    def describe_again(self) -> None:
        """Repeat the sentence about a cell that may have changed, unless one is being typed."""
        if self._matrix is not None and self._described is not None and self.field is None:
            self.pointed.emit(self._explain(self._matrix, *self._described))

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:
        cell = self._cell_at(event.position())
        if cell is not None and self._matrix is not None:
            self._described = cell
            self.pointed.emit(self._explain(self._matrix, *cell))
        self._point_at(cell)

    def _point_at(self, cell: tuple[int, int] | None) -> None:
        highlighted = NOTHING
        if cell is not None and self._matrix is not None:
            highlighted = letters_in(self._matrix, *cell)
        if highlighted != self._pointed_at:
            self._pointed_at = highlighted
            self.highlighted.emit(highlighted)

    def show_highlight(self, highlighted: Highlight) -> None:
        if highlighted != self._highlight:
            self._highlight = highlighted
            self.update()

    def is_marked(self, row: int, column: int) -> bool:
        """Whether a cell contains a highlighted quantity, or is computed from it."""
        matrix = self._matrix
        if matrix is None or not self._highlight:
            return False
        depends = set(matrix.fields[row][column]) & {"target", "up"}
        names = letters_in(matrix, row, column) | depends
        if matrix.name in TO_CLIP:
            names |= {f"clip_{'xyzw'[column if self._writing.rows else row]}"}
        return bool(names & made_of(self._highlight))

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:
        self.place = self._cell_at(event.position()) or self.place
        self.sought.emit(False)
        self._describe_cell()
        self.update()
        super().mousePressEvent(event)

    def focusInEvent(self, event: QtGui.QFocusEvent) -> None:
        super().focusInEvent(event)
        self._pointed_at = NOTHING  # the view that has lost the focus has removed the highlight
        self._describe_cell()

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        if event.matches(QtGui.QKeySequence.StandardKey.Copy):
            self.copied.emit("text", self._matrix)
        elif event.matches(QtGui.QKeySequence.StandardKey.Paste) and self._editable:
            self._paste()
        elif event.key() in _STEPS:
            down, right = _STEPS[Qt.Key(event.key())]
            row, column = self.place
            self.place = min(max(row + down, 0), 3), min(max(column + right, 0), 3)
            self._describe_cell()
            self.update()
        elif event.key() in (Qt.Key.Key_F2, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.edit_cell(*self.place)
        else:
            super().keyPressEvent(event)

    def _paste(self) -> None:
        """Take the clipboard's matrix, or its one number for the cell of the cursor."""
        text = clipboard_text()
        if not is_one_number(text):
            self.pasted.emit(text)
        elif not self._writing.formulas:
            self.edit_cell(*self.place)
            if self.field is not None:
                self.field.paste()

    def event(self, event: QEvent) -> bool:
        kinds = QEvent.Type
        if isinstance(event, QtGui.QHelpEvent) and event.type() == kinds.ToolTip and self._matrix:
            cell = self._cell_at(QPointF(event.pos()))
            if cell is not None:
                show_tip(event.globalPos(), rich(self._explain(self._matrix, *cell)), self)
                return True
        done = super().event(event)
        if event.type() in (kinds.Leave, kinds.FocusOut, kinds.Hide):
            self._point_at(None)
        return done

    def contextMenuEvent(self, event: QtGui.QContextMenuEvent) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        matrix = self._matrix
        add_copies(menu, lambda form: self.copied.emit(form, matrix))
        if self._editable:
            menu.addAction(self.tr("Paste"), self._paste)
        menu.popup(event.globalPos())


def add_copies(menu: QMenu, copy: Callable[[str], object]) -> None:
    for form, text in (
        ("text", QCoreApplication.translate("MatrixView", "Copy as text")),
        ("numpy", QCoreApplication.translate("MatrixView", "Copy for NumPy (numbers)")),
        ("latex", QCoreApplication.translate("MatrixView", "Copy for LaTeX (needs amsmath)")),
    ):
        menu.addAction(text, partial(copy, form))


def rich(text: str) -> Markup:
    """Write the letters of vectors in bold: few fonts can put an arrow above a letter."""
    return Markup(re.sub(f"(.){ARROW}", r"<b>\1</b>", Markup.of("<p>{}</p>", text)))
