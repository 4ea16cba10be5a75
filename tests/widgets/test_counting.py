"""Counting the pixels of a phenomenon's picture after a gesture, in the real window."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.drawings import rasterising
from tests.support.drawings import heard
from tests.support.window import pixels, show_scene
from widgets.window.main_window import MainWindow


def shown(window: Any) -> list[str]:
    lines = window.controls.card.readout.lines
    return [value.text() for label, value, _ in lines if not label.isHidden()]


def test_the_counted_share_stands_beside_the_predicted_one(window: MainWindow, qtbot: Any) -> None:
    show_scene(window, "depth-buffer")
    qtbot.waitUntil(lambda: shown(window)[1] != "–")
    predicted, counted = map(float, shown(window)[:2])
    assert 5.0 < predicted < 95.0 and counted == pytest.approx(predicted, abs=5.0)
    assert counted != predicted
    window.store.set_settings({"format": "fixed24"})
    assert shown(window)[1] == "–", "what was counted before is of another picture"
    qtbot.waitUntil(lambda: shown(window)[1] != "–")
    assert shown(window)[:2] == ["0", "0"]
    assert "few pixels" not in window.controls.card.readout.note.text()
    start = window.store.document.projection
    window.store.set_projection(replace(start, lens=replace(start.lens, fov_y_deg=179.0)))
    qtbot.waitUntil(lambda: "few pixels" in window.controls.card.readout.note.text())
    assert shown(window)[1] == "–"


@pytest.mark.undrawn
def test_nothing_is_counted_while_the_hand_moves(window: MainWindow, qtbot: Any) -> None:
    show_scene(window, "depth-buffer")
    qtbot.waitUntil(lambda: shown(window)[1] != "–")
    window.store.begin_gesture()
    window.store.set_settings({"gap": 0.3})
    with qtbot.assertNotEmitted(window.counting.counted, wait=700):
        pass
    window.store.end_gesture()
    qtbot.waitUntil(lambda: shown(window)[1] != "–")


@pytest.mark.undrawn
def test_a_count_made_behind_a_hidden_dock_appears_with_it(window: MainWindow, qtbot: Any) -> None:
    show_scene(window, "depth-buffer")
    qtbot.waitUntil(lambda: shown(window)[1] != "–")
    window.controls.hide()
    with qtbot.waitSignal(window.counting.counted):
        window.store.set_settings({"format": "fixed24"})
    with qtbot.assertNotEmitted(window.counting.counted, wait=400):
        window.controls.show()
        assert shown(window)[:2] == ["0", "0"]


@pytest.mark.undrawn
def test_a_large_mesh_is_not_counted(
    window: MainWindow, qtbot: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("widgets.panes.counting.MOST_FACES", 0)
    show_scene(window, "depth-buffer")
    with qtbot.assertNotEmitted(window.counting.counted, wait=1000):
        pass
    assert shown(window)[1] == "–"


def test_a_refused_shader_is_told_and_the_picture_drawn_the_ordinary_way(
    window: MainWindow, qtbot: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(rasterising, "_DEPTH", "this is no GLSL;")
    panel = window.controls.card
    with heard() as said:
        show_scene(window, "depth-buffer")
        qtbot.waitUntil(lambda: "rejects the shader" in panel.warning.text())
    assert not panel.warning.isHidden() and shown(window)[1] == "–"

    def orange() -> int:
        image = pixels(window, "image")
        return int((np.abs(image.astype(int) - (230, 159, 0)).sum(axis=-1) < 6).sum())

    with heard():
        qtbot.waitUntil(lambda: orange() > 500)
    assert "this is no GLSL" in said.GetOutput()
    window.guide.choose("similar-triangles")
    assert panel.warning.isHidden()
