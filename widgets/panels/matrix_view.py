"""One 4x4 matrix: its cells, painted, pointed at and typed.

Cells that differ from before the last change are lit, and their digits from the first other one on
underlined.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QFocusEvent,
    QFont,
    QFontMetricsF,
    QHelpEvent,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QLineEdit, QMenu, QSizePolicy, QWidget

from app.drawings.style import LIGHT, Style
from app.lecture.highlight import NOTHING, Highlight, made_of
from app.lecture.notation import Letters, Matrix, cell_text, letters_in, stacked, written
from app.model.formula import ARROW
from widgets.parts.highlight import faded, paint_highlight
from widgets.parts.messages import read_text
from widgets.parts.plain import Markup, set_tip, show_tip
from widgets.parts.typeset import typeset
from widgets.parts.writing import all_digits

_AXES = ("u", "v", "n")
VIEW = ("view_from_world", "rotation")
TO_CLIP = ("clip_from_view", "clip_from_world")
"""The matrices whose rows are the coordinates of clip space."""
ROW_GAP_PX = 3.0


_POWER = re.compile("e|·?10(?=[⁻⁰¹²³⁴⁵⁶⁷⁸⁹])")


def _parts(text: str) -> tuple[str, str]:
    """A number's digits, and the power of ten behind them, if there is one."""
    power = _POWER.search(text)
    return (text, "") if power is None else (text[: power.start()], text[power.end() :])


def first_change(before: str, after: str) -> int | None:
    """Where the digits of a number begin to differ; None if the texts are alike.

    With another count of digits before the point every digit has another place: all differ.
    """
    if before == after:
        return None
    (number, power), (other, another) = (_parts(text) for text in (before, after))
    if len(number.partition(".")[0]) != len(other.partition(".")[0]) or power != another:
        return 0
    pairs = enumerate(zip(before, after, strict=False))
    return next((i for i, (a, b) in pairs if a != b), min(len(before), len(after)))


def is_a_cameras(matrix: Matrix) -> bool:
    """Whether a matrix is made of a camera's axes; a typed one has none."""
    return matrix.name in (*VIEW, "world_from_view") and matrix.formulas[0][0] != "m_11"


class _CellField(QLineEdit):
    """Where a cell is typed: Tab goes on to the next, Esc back to what was."""

    left = Signal()
    moved_on = Signal(int)

    def event(self, event: QEvent) -> bool:
        kinds, keys = QEvent.Type, Qt.Key
        if isinstance(event, QKeyEvent) and event.type() in (
            kinds.ShortcutOverride,
            kinds.KeyPress,
        ):
            steps = {keys.Key_Tab: 1, keys.Key_Backtab: -1}
            pressed = event.type() == kinds.KeyPress
            enter = event.key() in (keys.Key_Return, keys.Key_Enter)
            if enter or event.key() == keys.Key_Escape or event.key() in steps:
                event.accept()  # a line of text would pass Enter on, which opens a cell
                if pressed and enter:
                    self.returnPressed.emit()
                elif pressed and event.key() == keys.Key_Escape:
                    self.left.emit()
                elif pressed:
                    self.moved_on.emit(steps[keys(event.key())])
                return True
        return super().event(event)


class MatrixView(QWidget):
    """One 4x4 matrix; its cells are pointed at with the mouse or the arrow keys.

    A double click, F2 or Enter opens the number of an `editable` one to be typed.

    Parameters
    ----------
    title : str
        What a reader calls it.
    explain : callable
        The sentence about a cell: ``(matrix, row, column) -> str``.

    Attributes
    ----------
    pointed : Signal(str)
        The sentence about the cell under the mouse or the cursor.
    copied : Signal(str, object)
        A format (``"text"``, ``"numpy"``, ``"latex"``) and the matrix to be copied in it.
    typed : Signal(int, int, str)
        Row, column and text of a cell, to be taken or refused by `refuse`.
    moved_on : Signal(int, int)
        Row and column of the cell that is to be typed next.
    """

    pointed = Signal(str)
    copied = Signal(str, object)
    highlighted = Signal(object)
    """The `Highlight` that the cell under the mouse or the cursor draws; only when it changes."""
    typed = Signal(int, int, str)
    moved_on = Signal(int, int)

    def __init__(
        self, title: str, explain: Callable[[Matrix, int, int], str], *, editable: bool = False
    ) -> None:
        super().__init__()
        self.setAccessibleName(title)
        self._explain, self._editable = explain, editable
        self._field: _CellField | None = None
        self._refused = False
        self._matrix: Matrix | None = None
        self._texts: list[list[str]] = []
        self._marks: list[list[int | None]] = []
        self._lit: set[tuple[int, int]] = set()
        self._columns: list[float] = [0.0] * 4
        self._fitting = self._columns
        """The widths of what is shown now."""
        self._measured: list[float] = []
        self._letters: Letters = "own"
        self._rows = self._formulas = False
        self._style = LIGHT
        self._dressed: tuple[object, ...] = ()
        """How the cells are written, all of them together."""
        self._cursor = (0, 0)
        self._highlight = self._pointed_at = NOTHING
        self._told: tuple[int, int] | None = None  # of which cell
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def show_matrix(
        self,
        matrix: Matrix,
        before: Matrix | None,
        *,
        letters: Letters,
        rows: bool,
        formulas: bool,
        style: Style,
    ) -> None:
        """Show a matrix, and what differs in it from another.

        Parameters
        ----------
        matrix : Matrix
        before : Matrix or None
            What it was before the last change.
        letters : Letters
        rows : bool
            Whether vectors are rows, so that the axes are too.
        formulas : bool
            Formulas instead of numbers.
        style : Style
            The colours of the axes.
        """
        dressed = (letters, rows, formulas, style, all_digits.now)
        before_that, self._dressed = self._dressed, dressed
        anew = dressed != before_that
        self._letters, self._rows, self._formulas, self._style = dressed[:4]
        old, self._matrix = self._matrix, matrix
        is_other = dressed[:4] != before_that[:4]
        if old is not None and (is_other or old.values != matrix.values):
            self.abandon()
        lit = set()
        marks: list[list[int | None]] = [[None] * 4 for _ in range(4)]
        for i, row in enumerate(matrix.values):
            for j, value in enumerate(row):
                if before is not None and before.values[i][j] != value:
                    lit.add((i, j))
                    if not formulas:
                        texts = read_text(before.values[i][j]), read_text(value)
                        marks[i][j] = first_change(*texts)
        if not anew and old == matrix and (lit, marks) == (self._lit, self._marks):
            return
        self._lit, self._marks = lit, marks
        if formulas:
            self._texts = [[stacked(cell, letters) for cell in row] for row in matrix.formulas]
        else:
            self._texts = [[read_text(value) for value in row] for row in matrix.values]
        self._measure(anew or old is None or old.name != matrix.name)
        if self.hasFocus():
            self._say()
        self.update()

    @property
    def texts(self) -> list[list[str]]:
        """What the cells show; of formulas, as of `widgets.parts.typeset`."""
        return self._texts

    # -- places

    def _small(self) -> QFont:
        font = QFont(self.font())
        font.setPointSizeF(font.pointSizeF() * 0.75)
        return font

    def _measure(self, anew: bool) -> None:
        height = QFontMetricsF(self.font()).height()
        cells = [[typeset(text, self.font()) for text in row] for row in self._texts]
        widths = [max(row[j].width for row in cells) + 0.8 * height for j in range(4)]
        # While numbers run, columns only grow: a row that jumps to and fro cannot be read.
        self._fitting = widths
        self._columns = widths if anew else list(map(max, self._columns, widths))
        # A subscript hangs into the room between two rows, a fraction does not.
        self._measured = [
            max(height, *(cell.height - (0.0 if cell.rules else 2.0) for cell in row)) + ROW_GAP_PX
            for row in cells
        ]
        self._take_room()

    def fit(self) -> None:
        """Make the columns as narrow as what they show: no number runs."""
        if self._columns != self._fitting:
            self._columns = self._fitting
            self._take_room()
            self.update()

    def _take_room(self) -> None:
        size = self._wanted()
        if size != self.minimumSize():
            self.setFixedSize(size)
        if self._field is not None:
            self._place_field(self._field)

    @property
    def _margin(self) -> tuple[float, float]:
        """Left and top of the first cell: room for the axes' letters and the bracket.

        Above there is room wherever the letters are, so that all matrices stand on one line.
        """
        plate = QFontMetricsF(self._small()).height() + 2.0
        return (plate + 8.0 if self._axes_are_rows else 8.0), plate + 2.0

    @property
    def _axes_are_rows(self) -> bool:
        return (self._matrix is not None and self._matrix.name in VIEW) is not self._rows

    def _wanted(self) -> QSize:
        left, top = self._margin
        return QSize(int(left + sum(self._columns) + 8.0), int(top + sum(self._heights) + 4.0))

    def sizeHint(self) -> QSize:
        return self._wanted()

    @property
    def _heights(self) -> list[float]:
        """Of the rows; of lines of text until there is a matrix, whose place is kept free."""
        return self._measured or [QFontMetricsF(self.font()).height() + ROW_GAP_PX] * 4

    def cell_rect(self, row: int, column: int) -> QRectF:
        """Where a cell is in the widget."""
        left, top = self._margin
        return QRectF(
            left + sum(self._columns[:column]), top + sum(self._heights[:row]),
            self._columns[column], self._heights[row],
        )  # fmt: skip

    def cell_at(self, place: QPointF) -> tuple[int, int] | None:
        """Row and column of the cell at a place in the widget."""
        cells = ((i, j) for i in range(4) for j in range(4))
        return next((cell for cell in cells if self.cell_rect(*cell).contains(place)), None)

    # -- painting

    def paintEvent(self, _event: QPaintEvent) -> None:
        if self._matrix is None:
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        ink = self.palette().windowText().color()
        self._paint_axes(painter)
        self._paint_brackets(painter, ink)
        for i, row in enumerate(self._texts):
            for j, text in enumerate(row):
                rect = self.cell_rect(i, j)
                if (i, j) in self._lit:
                    light = QColor(self._style.accent)
                    painter.fillRect(rect.adjusted(1, 1, -1, -1), faded(light, 0.3))
                    painter.setPen(QPen(light, 1.0))
                    painter.drawRect(rect.adjusted(1.5, 1.5, -1.5, -1.5))
                if self.is_marked(i, j):
                    paint_highlight(self, painter, rect.adjusted(1, 1, -1, -1))
                painter.setPen(faded(ink, 0.45) if text == "0" else ink)
                self._paint_text(painter, rect, text, self._marks[i][j])
        if self.hasFocus():
            painter.setPen(QPen(self.palette().highlight().color(), 2.0))
            painter.drawRect(self.cell_rect(*self._cursor).adjusted(1, 1, -1, -1))
        painter.end()

    def _paint_axes(self, painter: QPainter) -> None:
        left, top = self._margin
        painter.setFont(self._small())
        plate = QFontMetricsF(self._small()).height()
        assert self._matrix is not None
        camera = is_a_cameras(self._matrix)
        third = written("axis_n", self._letters).removesuffix(ARROW)
        names = ("u", "v", third) if camera else ("x", "y", "z")
        for k, (axis, name) in enumerate(zip(_AXES, names, strict=True)):
            colour = QColor(getattr(self._style, axis))
            if self._axes_are_rows:
                cell = self.cell_rect(k, 0)
                rect = QRectF(0.0, cell.top() + 1.0, plate, cell.height() - 2.0)
                band = QRectF(left, cell.top(), sum(self._columns), cell.height())
            else:
                cell = self.cell_rect(0, k)
                rect = QRectF(cell.left() + 2.0, 0.0, cell.width() - 4.0, plate)
                band = QRectF(cell.left(), top, cell.width(), sum(self._heights))
            painter.fillRect(band, faded(colour, 0.12))
            painter.fillRect(rect, colour)
            painter.setPen(QColor(self._style.text_on(colour.name())))
            painter.drawText(rect, Qt.AlignmentFlag.AlignCenter, name)
        painter.setFont(self.font())

    def _paint_brackets(self, painter: QPainter, ink: QColor) -> None:
        left, top = self._margin
        bottom, width = top + sum(self._heights), sum(self._columns)
        painter.setPen(QPen(ink, 1.2))
        for x, inward in ((left - 2.0, 4.0), (left + width + 2.0, -4.0)):
            painter.drawPolyline(
                [
                    QPointF(x + inward, top), QPointF(x, top),
                    QPointF(x, bottom), QPointF(x + inward, bottom),
                ]
            )  # fmt: skip

    def _paint_text(self, painter: QPainter, rect: QRectF, text: str, mark: int | None) -> None:
        metrics, cell = QFontMetricsF(self.font()), typeset(text, self.font())
        end = rect.right() - 0.4 * metrics.height()
        base = rect.center().y() + cell.below_middle
        cell.paint(painter, end - cell.width, base)
        if mark is not None:
            start = end - metrics.horizontalAdvance(text[mark:] or text[-1:])
            painter.setPen(QPen(painter.pen().color(), 2.0))
            painter.drawLine(QPointF(start, base + 3.0), QPointF(end, base + 3.0))

    # -- typing

    def edit_cell(self, row: int, column: int) -> None:
        """Open a cell to be typed, with all its digits; without effect if that is not to be."""
        if not self._editable or self._formulas or self._matrix is None:
            return
        self.abandon()
        self._cursor = (row, column)
        self._field = field = _CellField(cell_text(self._matrix.values[row][column]), self)
        place = self.tr("{0}, row {1}, column {2}")
        field.setAccessibleName(place.format(self.accessibleName(), row + 1, column + 1))
        field.setPlaceholderText("1/3")
        set_tip(
            field, self.tr("A number, or a fraction such as 1/3, which is divided to all digits")
        )
        self._place_field(field)
        field.setStyleSheet("padding: 0px; margin: 0px")
        field.returnPressed.connect(self._enter)
        field.editingFinished.connect(self._left_field)
        field.left.connect(self.abandon)
        field.moved_on.connect(self._move_on)
        field.textEdited.connect(self._mend)
        field.selectAll()
        self._say()
        field.show()
        field.setFocus()

    def _place_field(self, field: QLineEdit) -> None:
        """Put the field over its cell, as wide as what is typed needs."""
        wide = QFontMetricsF(self.font()).horizontalAdvance(field.text() + "00") + 8.0
        rect = self.cell_rect(*self._cursor)
        wide = min(max(wide, rect.width()), float(self.width()))
        left = max(min(rect.right() - wide, self.width() - wide), 0.0)
        field.setGeometry(int(left), int(rect.top()), int(wide), int(rect.height()))

    @property
    def place(self) -> tuple[int, int]:
        """Row and column of the cell that the keyboard is at."""
        return self._cursor

    def take_over(self, cursor: tuple[int, int]) -> None:
        """Go on at the cell where another view stood."""
        self._cursor = cursor
        self._say()
        self.setFocus()

    def refuse(self) -> None:
        """What was typed was not taken: it stays open to be mended."""
        self._refused = True
        if self._field is not None:
            self._field.setStyleSheet(
                f"padding: 0px; margin: 0px; border: 2px solid {self._style.far}"
            )

    def _mend(self) -> None:
        self._refused = False

    def _enter(self) -> bool:
        """Hand the text on; whether it was taken."""
        field, (row, column) = self._field, self._cursor
        if field is None or self._refused:
            return False
        if field.isModified():
            field.setModified(False)
            self.typed.emit(row, column, field.text())
            if self._refused:
                field.setModified(True)
                return False
        self.abandon()
        return True

    def _left_field(self) -> None:
        if self._field is not None and not self._field.hasFocus() and not self._enter():
            self.abandon()  # nobody mends it any more: the number before stands

    def _move_on(self, step: int) -> None:
        place = (4 * self._cursor[0] + self._cursor[1] + step) % 16
        if self._enter():
            self.moved_on.emit(*divmod(place, 4))

    def abandon(self) -> None:
        """Close the cell that is being typed, if one is; the number before stands."""
        field, self._field, self._refused = self._field, None, False
        if field is not None:
            had_focus = self.window().focusWidget() is field
            field.hide()
            field.deleteLater()
            if had_focus:
                self.setFocus()
            self.update()

    @property
    def field(self) -> QLineEdit | None:
        """Where a cell is being typed, if one is."""
        return self._field

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        cell = self.cell_at(event.position())
        if cell is not None and event.button() == Qt.MouseButton.LeftButton:
            self.edit_cell(*cell)

    # -- pointing

    def _say(self) -> None:
        if self._matrix is not None:
            self._told = self._cursor
            sentence = self._explain(self._matrix, *self._cursor)
            self.setAccessibleDescription(sentence)
            self.pointed.emit(sentence)
            self._point_at(self._cursor)

    def say_again(self) -> None:
        """Tell anew what was told of a cell, which may have changed, unless it is being typed."""
        if self._matrix is not None and self._told is not None and self._field is None:
            self.pointed.emit(self._explain(self._matrix, *self._told))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        cell = self.cell_at(event.position())
        if cell is not None and self._matrix is not None:
            self._told = cell
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
        """Mark the cells that speak of what is highlighted."""
        if highlighted != self._highlight:
            self._highlight = highlighted
            self.update()

    def is_marked(self, row: int, column: int) -> bool:
        """Whether a cell speaks of what is highlighted, or is made of it."""
        if self._matrix is None or not self._highlight:
            return False
        depends = set(self._matrix.fields[row][column]) & {"target", "up"}
        names = letters_in(self._matrix, row, column) | depends
        if self._matrix.name in TO_CLIP:
            names |= {f"clip_{'xyzw'[column if self._rows else row]}"}
        return bool(names & made_of(self._highlight))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._cursor = self.cell_at(event.position()) or self._cursor
        self._say()
        self.update()
        super().mousePressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self._say()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        steps = {
            Qt.Key.Key_Left: (0, -1), Qt.Key.Key_Right: (0, 1),
            Qt.Key.Key_Up: (-1, 0), Qt.Key.Key_Down: (1, 0),
        }  # fmt: skip
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copied.emit("text", self._matrix)
        elif event.key() in steps:
            row, column = steps[Qt.Key(event.key())]
            self._cursor = (
                min(max(self._cursor[0] + row, 0), 3), min(max(self._cursor[1] + column, 0), 3),
            )  # fmt: skip
            self._say()
            self.update()
        elif event.key() in (Qt.Key.Key_F2, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.edit_cell(*self._cursor)
        else:
            super().keyPressEvent(event)

    def event(self, event: QEvent) -> bool:
        kinds = QEvent.Type
        if isinstance(event, QHelpEvent) and event.type() == kinds.ToolTip and self._matrix:
            cell = self.cell_at(QPointF(event.pos()))
            if cell is not None:
                tip = self._explain(self._matrix, *cell)
                show_tip(event.globalPos(), rich(tip), self)
                return True
        done = super().event(event)
        if event.type() in (kinds.Leave, kinds.FocusOut, kinds.Hide):
            self._point_at(None)
        return done

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for form, text in (
            ("text", self.tr("Copy as text")),
            ("numpy", self.tr("Copy for NumPy (numbers)")),
            ("latex", self.tr("Copy for LaTeX (needs amsmath)")),
        ):
            menu.addAction(text, partial(self.copied.emit, form, self._matrix))
        menu.popup(event.globalPos())


def rich(text: str) -> Markup:
    """A text with the letters of vectors bold: few fonts put an arrow above a letter."""
    escaped = Markup.of("<p>{}</p>", text)
    return Markup(re.sub(f"(.){ARROW}", r"<b>\1</b>", escaped))
