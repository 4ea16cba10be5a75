"""Running numbers are shown as often as they can be read; the tests have their own clock."""

from typing import Any

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from widgets.parts.panel import READ_MS, STEPS, Readable


class Shown(QWidget):
    """Shows one number, and records what it showed."""

    def __init__(self) -> None:
        super().__init__()
        self.number, self.seen, self.ms = 0, [], 1000.0  # type: ignore[var-annotated]
        self.fails = False
        self.readable = Readable(self, self.see)

    def see(self) -> None:
        if self.fails:
            raise ValueError("not now")
        self.seen.append(self.number)

    def step(self, number: int, after_ms: float = 1.0) -> None:
        self.ms += after_ms
        self.number = number
        self.readable.changed()

    def showEvent(self, event: Any) -> None:
        super().showEvent(event)
        self.readable.settle()


@pytest.fixture
def shown(display: Any, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> Shown:
    widget = Shown()
    monkeypatch.setattr(widget.readable, "now_ms", lambda: widget.ms)
    qtbot.addWidget(widget)
    widget.show()
    qtbot.waitExposed(widget)
    return widget


def test_without_a_gesture_every_change_is_shown_at_once(shown: Shown) -> None:
    for number in range(1, 6):
        shown.step(number)
    assert shown.seen == [1, 2, 3, 4, 5]


def test_quick_steps_are_shown_as_often_as_they_can_be_read(shown: Shown) -> None:
    shown.readable.begin_gesture()
    for number in range(1, 52):
        shown.step(number, READ_MS / 10)
    assert shown.seen == [1, 11, 21, 31, 41, 51]
    shown.step(52)
    shown.step(53)
    assert shown.seen[-1] == 51
    shown.readable.end_gesture()
    assert shown.seen[-2:] == [51, 53]
    shown.step(54)
    assert shown.seen[-1] == 54


def test_most_slow_steps_show_nothing(shown: Shown) -> None:
    shown.readable.begin_gesture()
    for number in range(1, 11):
        shown.step(number, 0.99 * READ_MS)
    assert shown.seen == list(range(1, 11, STEPS))


def test_when_the_input_stops_the_last_value_is_shown(shown: Shown, qtbot: QtBot) -> None:
    shown.readable.begin_gesture()
    for number in (1, 2, 3):
        shown.step(number)
    assert shown.seen == [1]
    qtbot.waitUntil(lambda: len(shown.seen) > 1)
    assert shown.seen == [1, 3] and shown.readable.in_gesture
    shown.step(4, READ_MS)  # the first after a rest: at once
    shown.step(5)
    assert shown.seen == [1, 3, 4]


def test_gestures_overlap(shown: Shown) -> None:
    shown.readable.begin_gesture()
    shown.readable.begin_gesture()
    shown.step(1)
    shown.step(2)
    shown.readable.end_gesture()
    assert shown.seen == [1]
    shown.readable.end_gesture()
    assert shown.seen == [1, 2]


def test_a_hidden_widget_is_updated_when_it_appears(shown: Shown) -> None:
    shown.hide()
    for number in (1, 2):
        shown.step(number)
    assert shown.seen == []
    shown.show()
    assert shown.seen == [2]
    shown.hide()
    shown.show()
    assert shown.seen == [2], "nothing has changed"


def test_a_failed_update_is_repeated_at_the_next_appearance(shown: Shown) -> None:
    shown.fails = True
    with pytest.raises(ValueError, match="not now"):
        shown.step(1)
    shown.fails = False
    shown.hide()
    shown.show()
    assert shown.seen == [1]


def test_a_gesture_shows_its_first_value_at_once(shown: Shown) -> None:
    for number in (1, 2):
        shown.readable.begin_gesture()
        shown.step(number, READ_MS)
        shown.readable.end_gesture()
        assert shown.seen[-1] == number
    shown.readable.begin_gesture()
    shown.step(3, READ_MS)
    assert shown.seen == [1, 2, 3]
