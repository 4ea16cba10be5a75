"""Helpers for tests of the dock: actions of a user, and a record of its signals."""

from dataclasses import replace
from typing import Any

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QInputMethodEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QSlider

from app.model.projection import Camera, Frustum, Oblique, Orthographic, Perspective, Projection
from tests.support.shown import show
from widgets.controls.controls import Controls
from widgets.parts.fields import ChoiceRow
from widgets.parts.number_rows import NumberRow
from widgets.parts.panel import Changed, ShownData

KEY = Qt.Key
START = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.0, 0.0)), Perspective(45.0, 1.0, 30.0))
OFF_AXIS = replace(START, lens=Frustum(-0.25, 0.75, -0.5, 1.5, 1.0, 30.0))
BOX = replace(START, lens=Orthographic(-4.0, 4.0, -3.0, 3.0, 1.0, 30.0))
SLANTED = replace(START, lens=Oblique(near=2.0))
"""Cabinet, rising at 45 degrees."""


class Column(Controls):
    """The dock and the projection of its owner.

    Attributes
    ----------
    projection : Projection
        What was shown or edited at last.
    """

    def __init__(self) -> None:
        super().__init__()
        self.projection = Projection()
        self.edited.connect(self._keep)

    def take(self, shown: ShownData, changed: Changed) -> None:
        self.projection = shown.projection
        super().take(shown, changed)

    def _keep(self, edit: Projection) -> None:
        self.projection = edit


def column_with_the_keyboard(qtbot: Any, *sections: str) -> Column:
    """Make a dock that shows `START`, with these sections open."""
    controls = Column()
    qtbot.addWidget(controls)
    controls.resize(320, 900)
    controls.set_scene(6.0, START)
    show(controls, START)
    for name in sections:
        controls.sections[name].set_open(True)
    controls.show()
    qtbot.waitExposed(controls)
    controls.activateWindow()
    qtbot.waitUntil(controls.isActiveWindow)
    return controls


class Reader:
    """Another dock with all rows in view, for comparison."""

    def __init__(self, qtbot: Any) -> None:
        self._column = Controls()
        qtbot.addWidget(self._column)
        self._column.set_scene(6.0, START)
        for section in self._column.sections.values():
            section.set_open(True)

    def read(self, key: str, shown: Projection) -> float:
        """Return the number that a row shows of a projection."""
        show(self._column, shown)
        return number(self._column, key).value()


class Record:
    """Records the signals of the dock in order."""

    def __init__(self, controls: Controls) -> None:
        self.edits: list[Projection] = []
        self.events: list[str] = []
        controls.edited.connect(self._edited)
        controls.gesture_started.connect(lambda: self.events.append("start"))
        controls.gesture_finished.connect(lambda: self.events.append("finish"))

    def _edited(self, edit: Projection) -> None:
        self.edits.append(edit)
        self.events.append("edit")


def number(controls: Controls, key: str) -> NumberRow:
    row = controls.rows[key]
    assert isinstance(row, NumberRow)
    return row


def choice(controls: Controls, key: str) -> ChoiceRow:
    row = controls.rows[key]
    assert isinstance(row, ChoiceRow)
    return row


def choose(row: ChoiceRow, key: str) -> None:
    """Choose from a row's box, or by one of its buttons."""
    index = row.keys.index(key)
    box = row.widgets[0]
    if isinstance(box, QComboBox):
        box.setCurrentIndex(index)
        box.activated.emit(index)
    else:
        row.widgets[index].click()


def enter(row: NumberRow, text: str) -> None:
    """Replace the text of the field, and press Return."""
    row.field.setFocus()
    row.field.selectAll()
    QTest.keyClick(row.field, KEY.Key_Delete)
    if text.isascii():
        QTest.keyClicks(row.field, text)
    else:  # as an input method hands it over
        event = QInputMethodEvent()
        event.setCommitString(text)
        QApplication.sendEvent(row.field, event)
    QTest.keyClick(row.field, KEY.Key_Return)


def handle(slider: QSlider) -> QPoint:
    """Return the place of the slider's handle."""
    from PySide6.QtWidgets import QStyle, QStyleOptionSlider

    option = QStyleOptionSlider()
    slider.initStyleOption(option)
    part = QStyle.SubControl.SC_SliderHandle
    control = QStyle.ComplexControl.CC_Slider
    return slider.style().subControlRect(control, option, part, slider).center()


def press(slider: QSlider) -> QPoint:
    place = handle(slider)
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=place)
    assert slider.isSliderDown()
    return place


def drag(slider: QSlider, position: int) -> None:
    """Move the pressed slider to a position, as the mouse does."""
    slider.setSliderPosition(position)


def release(slider: QSlider) -> None:
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=handle(slider))
    assert not slider.isSliderDown()


NONSENSE = ["nan", "0x10", "1_000", "", " ", "abc", "1,2,3", "1.2.3", "--1", "1e", "٣", "1 2", "-∞",
            "1/0", "1/", "/3", "1/2/3", "1//2", "1/-0", "inf/2"]  # fmt: skip
