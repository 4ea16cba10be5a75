"""What a screen reader hears of the whole window, and how the keyboard goes through it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QLabel, QWidget

from app.document import Document
from app.scene import load

SAID = QAccessible.Text


def said(widget: QWidget, what: QAccessible.Text = SAID.Name) -> str:
    """What a screen reader is told of a widget."""
    return QAccessible.queryAccessibleInterface(widget).text(what)


def panels(window: Any) -> Iterator[QWidget]:
    """Every panel, opened one after the other."""
    for panel in (
        window.matrices,
        window.frame_panel,
        window.probe_panel,
        window.scene_panel,
        window.measure_panel,
    ):
        window.panels.open(panel)
        yield panel


def test_a_screen_reader_hears_what_is_shown(make_window: Callable[..., Any]) -> None:
    window = make_window(Document("depth-buffer", load("depth-buffer").start))
    window.panels.open(window.matrices)
    window.matrices.explanation.setText("a sentence")
    for _ in panels(window):
        for label in window.findChildren(QLabel):
            if label.isVisible() and label.text() and "<" not in label.text():
                heard = said(label) + said(label, SAID.Description)
                assert label.text().rstrip("…") in heard, label.text()
    heard = said(window.frame_panel.numbers)
    assert "=" in heard and "<" not in heard  # without its markup
    window.status.quality.setText("quality: 50 %")
    for button in (window.status.rung, window.status.quality):
        assert said(button) == button.text()
