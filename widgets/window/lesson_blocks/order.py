"""The view of a question whose answer is a chain: tiles to arrange, switch off, and type into."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QCheckBox, QLineEdit, QWidget

from app.lessons.blocks.order import OrderQuestion, tile_parts
from app.lessons.player import PlayedBlock
from app.lessons.text import spoken_text
from app.model.chain import KINDS
from widgets.parts.layouts import FREE, in_row
from widgets.parts.lesson_text import LessonText
from widgets.parts.movable import MovableColumn, MoveButton
from widgets.parts.plain import PlainLabel, set_tip
from widgets.window.lesson_blocks.marked import MarkedAnswerView
from widgets.window.lesson_blocks.view import on_holder


class _TileRow(QWidget):
    """A tile: its grip, its switch, its name, and its numbers if it has any."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self._head, title, numbers = tile_parts(text)
        if title[0] == "$":
            title = f"\u200b{title}"  # not alone in its line, where it would be centred
        self.switch = QCheckBox()
        set_tip(self.switch, self.tr("Whether the product has this tile"))
        self.field = QLineEdit(numbers)
        self.field.setHidden(self._head not in KINDS)
        for part in (self.switch, self.field):
            part.setAccessibleName(spoken_text(title))
        parts = MoveButton(spoken_text(title)), self.switch, (LessonText(title), 1), (self.field, 1)
        in_row(*parts, on=self, margins=(0, 0, 0, 0), gap=4)

    @property
    def text(self) -> str:
        off = "off " * (not self.switch.isChecked())
        return f"{off}{self._head} {self.field.text()}".strip()


class OrderView(MarkedAnswerView):
    """Tiles in a column, as in the dock: the one at the bottom acts first."""

    question: OrderQuestion

    def __init__(self, played: PlayedBlock, question: OrderQuestion) -> None:
        super().__init__(played, question)
        self.column = MovableColumn(gap=2)
        self._show("; ".join(question.tiles))
        self._check = self._answer_button(self.check)
        first = PlainLabel(self.tr("The tile at the bottom acts first."), objectName="paneNote")
        self._insert(self.column)
        self._insert(on_holder(first, FREE, self._check, gap=5))

    @property
    def rows(self) -> list[_TileRow]:
        return [part for part in self.column.parts if isinstance(part, _TileRow)]

    @property
    def first(self) -> QWidget | None:
        return self.rows[0].switch

    def check(self) -> None:
        """Say whether the product is right."""
        self._submit(self.typed)

    @property
    def typed(self) -> str:
        return "; ".join(row.text.replace(";", ",") for row in self.rows)

    def _show(self, typed: str) -> None:
        texts = [part.strip() for part in typed.split(";")]
        self.column.show_parts([_TileRow(text.removeprefix("off ")) for text in texts])
        for row, text in zip(self.rows, texts, strict=True):
            row.switch.setChecked(text[:4] != "off ")

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.played.is_open:
            self.check()
        else:
            super().keyPressEvent(event)

    def _close(self) -> None:
        if QApplication.focusWidget() in self.column.findChildren(QWidget):
            self._check.setFocus()  # or Qt would give the focus to nothing
        self.column.setEnabled(False)
        self._check.hide()
