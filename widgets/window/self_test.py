"""The dialog that asks for the topics of a test."""

from collections.abc import Mapping

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QIntValidator
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QGridLayout,
    QLineEdit,
    QScrollArea,
    QWidget,
)

from app.lessons.blocks.exercise import LARGEST_SEED
from app.lessons.practice import MOST
from widgets.parts.buttons import push_button
from widgets.parts.layouts import FREE, in_column, in_row
from widgets.parts.plain import PlainLabel, set_tip

COLUMNS = 2


def exercises_text(count: int) -> str:
    if count == 1:
        return QCoreApplication.translate("SelfTestDialog", "1 exercise")
    return QCoreApplication.translate("SelfTestDialog", "%n exercises", "", count)


class SelfTestDialog(QDialog):
    """Asks for topics (title and number of exercises by name) and for the number of a test."""

    def __init__(
        self, topics: Mapping[str, tuple[str, int]], number: int, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Test yourself"))
        self._counts = {name: count for name, (_, count) in topics.items()}
        self._boxes = {
            name: QCheckBox(f"{name} {title}".replace("&", "&&"))
            for name, (title, _) in topics.items()
        }
        holder = QWidget()
        grid = QGridLayout(holder)
        rows = -(-len(topics) // COLUMNS)
        for place, (name, box) in enumerate(self._boxes.items()):
            box.setEnabled(self._counts[name] > 0)
            box.toggled.connect(self._show_count)
            grid.addWidget(box, place % rows, place // rows)
        area = QScrollArea(widgetResizable=True)
        area.setWidget(holder)
        area.setMinimumWidth(holder.sizeHint().width() + 2 * area.frameWidth() + 20)
        self.number = QLineEdit(str(number))
        self.number.setValidator(QIntValidator(1, LARGEST_SEED, self))
        self.number.setAccessibleName(self.tr("Number of the test"))
        set_tip(self.number, self.tr("The same topics and number give everyone the same test"))
        self.number.setMaximumWidth(5 * self.fontMetrics().height())
        self.number.textChanged.connect(self._show_count)
        self._count = PlainLabel()
        every = push_button(self.tr("&All topics"), act=lambda: self._choose(True))
        none = push_button(self.tr("&None"), act=lambda: self._choose(False))
        text = self.tr(
            "Up to {0} exercises. One try each, no hints, panels closed; give three significant"
            " digits. At the end you see all solutions."
        )
        how = PlainLabel(text.format(MOST), wordWrap=True)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.begin = buttons.addButton(self.tr("&Begin"), QDialogButtonBox.ButtonRole.AcceptRole)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        last = in_row(every, none, FREE, PlainLabel(self.tr("Test number")), self.number)
        in_column(how, (area, 1), last, in_row((self._count, 1), buttons), on=self)
        em = self.fontMetrics().height()
        wide, high = area.minimumWidth() + 30, holder.sizeHint().height() + 12 * em
        room = self.screen().availableSize() * 0.9
        self.resize(min(wide, room.width()), min(high, room.height()))
        self._show_count()

    @property
    def topics(self) -> list[str]:
        return [name for name, box in self._boxes.items() if box.isChecked()]

    def _choose(self, on: bool) -> None:
        for box in self._boxes.values():
            box.setChecked(on and box.isEnabled())

    def _show_count(self) -> None:
        count = min(MOST, sum(self._counts[name] for name in self.topics))
        text = exercises_text(count) if count else self.tr("Choose topics.")
        self._count.setText(text)
        self.begin.setEnabled(count > 0 and self.number.hasAcceptableInput())
