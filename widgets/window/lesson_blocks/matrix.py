"""The view of a question whose answer is a matrix: a grid of cells to type into."""

import itertools
import re

from PySide6.QtCore import QEvent, QObject, QRectF, Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent, QKeySequence, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QGridLayout, QLineEdit, QSizePolicy, QWidget

from app.lessons import marking
from app.lessons.blocks.block import Verdict
from app.lessons.blocks.matrix import MatrixQuestion
from app.lessons.player import PlayedBlock
from app.model.matrix_text import LONGEST, read_matrix
from app.model.refusal import Refusal, format_value
from widgets.parts.layouts import FREE
from widgets.parts.messages import sentence
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.typeset import paint_brackets
from widgets.window.lesson_blocks.marked import MarkedAnswerView
from widgets.window.lesson_blocks.view import Sign, on_holder

CELL_EM = 6.0  # largest width of a cell, in line heights
_BRACKET_PX = 6


class _MatrixCellEdit(QLineEdit):
    """A cell with a sign below it is marked; the sign goes when the cell is edited."""

    def __init__(self, row: int, column: int) -> None:
        super().__init__(maxLength=80, alignment=Qt.AlignmentFlag.AlignRight)
        self.row, self.column = row, column
        self.place = self.tr("Row {0}, column {1}").format(row + 1, column + 1)
        self.setAccessibleName(self.place)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        em = self.fontMetrics().height()
        self.setMinimumWidth(3 * em)
        self.setMaximumWidth(round(CELL_EM * em))
        self.textEdited.connect(self.unmark)
        self.sign = Sign("", "")  # below the cell, where it takes no room from the number
        self.sign.hide()

    def mark(self, is_right: bool) -> None:
        said = self.tr("Right") if is_right else self.tr("Wrong")
        self.sign.show_icon("check" if is_right else "close", said)
        self.sign.show()
        self.setAccessibleDescription(said)

    def unmark(self) -> None:
        self.sign.hide()
        self.setAccessibleDescription("")


class _Brackets(QWidget):
    """The cells between two square brackets."""

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        with QPainter(self) as painter:
            painter.setPen(QPen(self.palette().text().color(), 1.6))
            paint_brackets(painter, QRectF(self.rect()).adjusted(1, 1, -3, -3), _BRACKET_PX)


class MatrixAnswerView(MarkedAnswerView):
    """A matrix or a vector; arrow keys and Tab go from cell to cell, Enter checks them all."""

    question: MatrixQuestion

    def __init__(self, played: PlayedBlock, question: MatrixQuestion) -> None:
        super().__init__(played, question)
        holder = _Brackets()
        grid = QGridLayout(holder)
        grid.setContentsMargins(_BRACKET_PX + 2, 4, _BRACKET_PX + 2, 4)
        grid.setSpacing(3)
        self.cells = [
            _MatrixCellEdit(row, column)
            for row in range(question.rows)
            for column in range(question.columns)
        ]
        for cell in self.cells:
            tip = self.tr("A number: 0.5, 1 1/2, √3/2 or 2e-3; arrow keys change the cell (Enter)")
            set_tip(cell, tip)
            cell.returnPressed.connect(self.check)
            cell.installEventFilter(self)
            grid.addWidget(cell, 2 * cell.row, cell.column)
            grid.addWidget(cell.sign, 2 * cell.row + 1, cell.column, Qt.AlignmentFlag.AlignHCenter)
        self._check = self._answer_button(self.check)
        unit = [PlainLabel(question.unit)] if question.unit else []
        self._insert(on_holder(holder, *unit, FREE, gap=5))
        self._insert(on_holder(self._check, FREE, gap=5))

    @property
    def first(self) -> QWidget | None:
        return self.cells[0]

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        is_pressed = event.type() == QEvent.Type.KeyPress
        if is_pressed and isinstance(event, QKeyEvent) and isinstance(watched, _MatrixCellEdit):
            if event.matches(QKeySequence.StandardKey.Paste):
                return self.played.is_open and self._paste()
            if not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
                return self._go(watched, Qt.Key(event.key()))
        return super().eventFilter(watched, event)

    def _paste(self) -> bool:
        """Fill all cells with the clipboard's matrix, if it has the shape of the answer."""
        try:
            rows = read_matrix(QGuiApplication.clipboard().text()[: LONGEST + 1])
        except Refusal:  # one number, or what the cell's own paste is for
            return False
        if (len(rows), len(rows[0])) != (self.question.rows, self.question.columns):
            return False
        for cell, number in zip(self.cells, itertools.chain(*rows), strict=True):
            cell.setText(format_value(number))
            cell.unmark()
        return True

    def _go(self, cell: _MatrixCellEdit, key: Qt.Key) -> bool:
        """Go to a neighbour by an arrow key; within a text, left and right move the cursor."""
        row, column, at = cell.row, cell.column, cell.cursorPosition()
        if key == Qt.Key.Key_Up:
            row -= 1
        elif key == Qt.Key.Key_Down:
            row += 1
        elif key == Qt.Key.Key_Left and at == 0:
            column -= 1
        elif key == Qt.Key.Key_Right and at == len(cell.text()):
            column += 1
        else:
            return False
        if 0 <= row < self.question.rows and 0 <= column < self.question.columns:
            self._enter(self.cells[row * self.question.columns + column])
        return True

    def _enter(self, cell: _MatrixCellEdit) -> None:
        cell.setFocus(Qt.FocusReason.OtherFocusReason)
        cell.selectAll()

    def check(self) -> None:
        """Say which numbers are right; go to one that is missing or cannot be read."""
        if not self.played.is_open:
            return
        for cell in self.cells:
            try:
                marking.read(cell.text(), self.question.unit)
            except Refusal as error:
                self._refuse_cell(cell, error)
                return
        self._submit(self.typed)

    @property
    def typed(self) -> str:
        rows = [
            " | ".join(re.sub("[|;]", " ", cell.text()) for cell in self.cells if cell.row == row)
            for row in range(self.question.rows)
        ]
        return "; ".join(rows) if any(cell.text() for cell in self.cells) else ""

    def _refuse_cell(self, cell: _MatrixCellEdit, error: Refusal) -> None:
        self._enter(cell)
        said = Refusal(cell.place, error.value or ..., error.bound, *error.limits)
        self._refuse(said)
        self._speak(sentence(said))

    def _show(self, typed: str) -> None:
        for cell, text in zip(self.cells, self.question.texts_of(typed), strict=True):
            cell.setText(text)

    def _show_verdict(self, verdict: Verdict) -> None:
        for cell, is_right in zip(self.cells, verdict.cells, strict=True):
            if is_right or not verdict.too_short:
                cell.mark(is_right)
        wrong = [cell for cell, fits in zip(self.cells, verdict.cells, strict=True) if not fits]
        if wrong:
            self._enter(wrong[0])

    def _close(self) -> None:
        for cell in self.cells:
            cell.setReadOnly(True)
        self._check.hide()
