"""The panels under the panes: folded, one open at a time."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QToolButton
from pytestqt.qtbot import QtBot

from widgets.panels import Panels


def test_one_panel_is_open_at_a_time(qtbot: QtBot) -> None:
    panels = Panels()
    first, second = QLabel("first"), QLabel("second")
    panels.add("One", first, "the first")
    panels.add("Two", second, "the second")
    qtbot.addWidget(panels)
    panels.show()
    qtbot.waitExposed(panels)
    one, two = panels.findChildren(QToolButton)
    assert [one.text(), two.text(), one.toolTip()] == ["One", "Two", "the first"]
    assert panels.open_panel is None
    assert not first.isVisible() and not second.isVisible()
    folded = panels.sizeHint().height()
    with qtbot.waitSignal(panels.opened):
        qtbot.mouseClick(two, Qt.MouseButton.LeftButton)
    assert panels.open_panel is second and second.isVisible() and not first.isVisible()
    assert two.isChecked() and not one.isChecked()
    assert panels.sizeHint().height() > folded
    qtbot.mouseClick(one, Qt.MouseButton.LeftButton)
    assert panels.open_panel is first and not second.isVisible() and not two.isChecked()
    qtbot.mouseClick(one, Qt.MouseButton.LeftButton)
    assert panels.open_panel is None and not first.isVisible() and not one.isChecked()
