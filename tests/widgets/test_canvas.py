"""Both kinds of canvas show the same pictures with the same input and as many repaints."""

import math
import os
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.bootstrap import ROOT
from app.document.document import Document
from app.drawings.image import ImageDrawing
from app.drawings.label_placement import Ground
from app.drawings.labels import Board
from app.drawings.off_screen import off_screen
from app.drawings.off_screen import pixels_of as pixels_in
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT
from app.drawings.world import WorldDrawing
from app.model.projection import Perspective
from app.precision.quality import Quality
from app.scenes.scene import BUILT_IN, load
from tests import PATIENCE_S
from tests.support.drawings import colours_of
from tests.support.window import (
    MakeWindow,
    activate,
    click,
    counted_repaints,
    pixels,
    pixels_of,
    seen,
    settle,
)
from widgets.panes.canvas import CANVASES, REST_MS, SCALES, RasterCanvas
from widgets.window.main_window import MainWindow

pytestmark = pytest.mark.smooth

CANVAS = sorted(CANVASES)
FIGURES: dict[str, Any] = {
    "world": partial(WorldDrawing, live=True),
    "ndc": StageDrawing,
    "image": partial(ImageDrawing, live=True),
}
Opened = Callable[[], MainWindow]
PLAIN = Quality(smoothing="none")


def document_of(scene: str) -> Document:
    return Document(scene, load(scene).start, quality=PLAIN)


@pytest.fixture(params=CANVAS)
def opened(request: pytest.FixtureRequest, make_window: MakeWindow) -> Opened:
    """Opens a window with canvases of either kind."""

    def open_window() -> MainWindow:
        window = make_window(canvas=request.param)
        settle()
        return window

    return open_window


def test_both_show_the_pixels_that_a_figure_averages(make_window: MakeWindow, qtbot: QtBot) -> None:
    windows = [make_window(document_of("letter-f"), canvas=canvas) for canvas in CANVAS]
    for window in windows:
        window.resize(960, 640)  # quickly drawn
    for scene in BUILT_IN[::16]:
        for each in windows:
            each.store.open(document_of(scene))
            each.quality.use({"smoothing": "none"})
        settle()
        panes = [pane for each in windows for pane in each.panes.values()]
        qtbot.waitUntil(lambda all_of=panes: not any(each.drawing.is_coarse for each in all_of))
        shown, words = windows[0].shown, windows[0].look.words
        for name, kind in FIGURES.items():
            first, second = (pixels(each, name) for each in windows)
            assert colours_of(first) > 3, (scene, name)
            assert np.array_equal(first, second), (scene, name)
            height, width = first.shape[:2]
            with off_screen(width, height) as screen:
                figure = kind(screen, shown.scene, words, LIGHT)
                figure.show_projection(shown.projection, shown.illustration)
                about = shown.illustration.about if shown.illustration else ()
                figure.show_highlight(frozenset(about))  # as figures do
                figure.reset_view()
                figure.refine(whole=True)
                screen.render_window.Render()
                drawn = pixels_in(screen.render_window)[..., :3]
                figure.remove()
            assert np.array_equal(drawn, first), (scene, name)


@pytest.mark.parametrize("scale", SCALES)
def test_both_draw_finer_and_coarser_pictures_of_the_same_things(
    scale: str, make_window: MakeWindow
) -> None:
    document = replace(document_of("letter-f"), quality=Quality(smoothing=scale))
    first, second = (
        pixels(make_window(document, canvas=canvas), "image").astype(int) for canvas in CANVAS
    )
    assert first.shape == second.shape
    assert (np.abs(first - second).max(axis=2) > 16).mean() < 0.01


def test_pictures_are_the_same_where_opengl_cannot_turn_their_rows_over(
    make_window: MakeWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = pixels(make_window(canvas="raster"), "image")
    monkeypatch.setattr("widgets.panes.canvas.turns_rows_over", lambda _window: False)
    second = pixels(make_window(canvas="raster"), "image")
    assert np.array_equal(first, second)
    assert not np.array_equal(first, first[::-1])


def test_all_pictures_of_a_step_are_begun_before_one_is_read(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Reading waits for the software renderer, which may draw the others meanwhile."""
    settle()
    order: list[str] = []
    for name in ("_render", "_read"):
        act = getattr(RasterCanvas, name)
        monkeypatch.setattr(
            RasterCanvas, name, lambda self, name=name, act=act: (order.append(name), act(self))
        )
    window.controls.rows["near"].slider.setValue(300)
    settle()
    assert order == ["_render"] * 3 + ["_read"] * 3


def test_another_scene_places_its_labels_once_in_each_pane(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    settle()
    placed, settle_labels = [], Board.settle

    def counted(self: Board, ground: Ground, **how: bool) -> bool:
        placed.append(self)
        return settle_labels(self, ground, **how)

    monkeypatch.setattr(Board, "settle", counted)
    window.guide.choose("cube")
    settle()
    boards = [pane.drawing.board for pane in window.panes.values() if pane.drawing is not None]
    assert sorted(map(id, placed)) == sorted(map(id, boards))
    placed.clear()
    world = window.panes["world"]
    world.set_waiting(True)
    world.request("names", frozenset({"near"}))
    world.request("layers", frozenset({"grid"}))
    world.request("fixed", "top")
    world.set_waiting(False)
    world.refit()
    assert world.drawing is not None
    assert placed == [world.drawing.board], "once for all that is new, and not again at rest"


def test_a_hand_quicker_than_the_screen_does_not_make_frames_short(
    opened: Opened, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The next step comes before the last picture has reached the screen."""
    window, frames = opened(), []
    monkeypatch.setattr(window.look.adaptive.budget, "frame", frames.append)

    def dawdle(_window: object, _event: str) -> None:
        until = time.perf_counter() + 0.02
        while time.perf_counter() < until:
            pass

    window.panes["image"].canvas.render_window.AddObserver("EndEvent", dawdle)
    slider = window.controls.rows["near"].slider
    window.store.begin_gesture()
    for _ in range(6):
        slider.setValue(slider.value() + 20)
        QApplication.processEvents()
    window.store.end_gesture()
    assert len(frames) >= 5 and min(frames) > 20.0


def test_a_slider_beside_it_draws_no_picture_anew(opened: Opened) -> None:
    window = opened()
    with counted_repaints(window) as counts:
        window.controls.rows["near"].slider.update()
        settle()
    if window.panes["world"].canvas.findChild(QOpenGLWidget) is None:
        assert set(counts.values()) == {0}


def test_the_hand_turns_moves_and_zooms_the_view_alone(opened: Opened) -> None:
    window = opened()
    pane, document = window.panes["world"], window.store.document
    canvas, camera = pane.canvas, pane.hand.camera
    activate(window)
    place, target = camera.GetPosition(), camera.GetFocalPoint()
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(90, 90))
    QTest.mouseMove(canvas, QPoint(150, 110))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=QPoint(150, 110))
    assert camera.GetPosition() != place and camera.GetFocalPoint() == target
    assert math.dist(camera.GetPosition(), target) == pytest.approx(math.dist(place, target))
    canvas.setFocus(Qt.FocusReason.TabFocusReason)
    QTest.keyClick(canvas, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert camera.GetFocalPoint() != target
    away = camera.GetDistance() / camera.GetParallelScale()
    QTest.keyClick(canvas, Qt.Key.Key_Plus)
    assert camera.GetDistance() / camera.GetParallelScale() != away or camera.GetDistance() != away
    QTest.keyClick(canvas, Qt.Key.Key_Home)
    settle()
    assert camera.GetPosition() == pytest.approx(place, abs=1e-9)
    assert window.store.document == document


def test_it_tells_where_it_is_clicked_dragged_hovered_over_and_left(opened: Opened) -> None:
    window = opened()
    pane, told = window.panes["image"], []
    ratio = pane.canvas.pixel_ratio

    def note(name: str) -> Any:
        return lambda *what: told.append((name, *what))

    for name in ("clicked", "drag_started", "dragged", "drag_ended", "hovered", "scrolled"):
        getattr(pane.hand, name).connect(note(name))
    for place in (QPoint(90, 90), QPoint(60, 61)):  # the mouse may be there already
        QTest.mouseMove(window.windowHandle(), pane.canvas.mapTo(window, place))
        settle()
    assert told[-1] == ("hovered", QPointF(60.5, 61.5) * ratio)
    told.clear()
    click(pane.canvas, (40.0, 50.0))
    assert told == [("clicked", QPointF(40.5, 50.5) * ratio)]
    told.clear()
    QTest.mousePress(pane.canvas, Qt.MouseButton.LeftButton, pos=QPoint(40, 50))
    QTest.mouseMove(pane.canvas, QPoint(70, 50))
    QTest.mouseRelease(pane.canvas, Qt.MouseButton.LeftButton, pos=QPoint(70, 50))
    names = ["drag_started", "dragged", "drag_ended", "hovered"]
    assert [name for name, *_ in told] == names
    assert told[0][1] == QPointF(40.5, 50.5) * ratio and told[1][1] == QPointF(30, 0) * ratio


def test_drops_and_keys_it_does_not_know_are_the_windows(opened: Opened) -> None:
    window = opened()
    canvases: list[QWidget] = [pane.canvas for pane in window.panes.values()]
    assert not any(canvas.acceptDrops() for canvas in canvases)
    before = pixels(window)
    for key in "3wsqerfp":
        QTest.keyClick(window.panes["world"].canvas, key)
    settle()
    assert np.array_equal(pixels(window), before)
    assert window.isVisible()


def test_lost_opengl_resources_are_created_again(opened: Opened, qtbot: QtBot) -> None:
    """As after a restart of the driver: all of VTK's resources are gone."""
    window = opened()
    shown = window.store.document.projection
    before = {name: pixels(window, name) for name in window.panes}
    for pane in window.panes.values():
        pane.canvas.render_window.Finalize()
    # A smaller volume stays inside the view, which is therefore not framed anew.
    window.store.set_projection(seen(window, lens=Perspective(30.0, 6.0, 12.0)))
    settle()
    assert not np.array_equal(pixels(window, "image"), before["image"])
    window.store.set_projection(shown)
    # VTK smooths by its own shader then, which rounds otherwise.
    for name, picture in before.items():  # once its labels have faded in
        there = picture.astype(int)
        qtbot.waitUntil(lambda n=name, seen=there: np.abs(pixels(window, n) - seen).max() <= 1)


@pytest.mark.parametrize("kind", CANVAS)
def test_a_canvas_of_any_size_is_drawn(kind: str, display: Any) -> None:
    canvas = CANVASES[kind](None)
    canvas.show()
    sizes = ((0, 0), (3, 2), (8000, 400), (300, 200))
    for size in sizes:  # still empty
        canvas.resize(*size)
        settle()
    canvas.open()
    for size in sizes:
        canvas.resize(*size)
        settle()
        canvas.redraw()
        settle()
    assert pixels_of(canvas).shape == (200, 300, 3)
    assert canvas.render_window.GetSize() == (300, 200)
    canvas.close()


def test_without_a_screen_and_without_qts_opengl_it_draws_all_the_same(tmp_path: Path) -> None:
    pictures = []
    for without in (
        {"DISPLAY": None, "QT_QPA_PLATFORM": "offscreen"},
        {"QT_XCB_GL_INTEGRATION": "none"},
    ):
        variables = {**os.environ, **without}
        out = tmp_path / f"{len(pictures)}.png"
        done = subprocess.run(
            [sys.executable, "-m", "app", "--screenshot", out, "--size", "1000x600"],
            cwd=ROOT, env={name: value for name, value in variables.items() if value is not None},
            capture_output=True, text=True, timeout=PATIENCE_S, check=False,
        )  # fmt: skip
        assert (done.returncode, done.stdout) == (0, ""), done.stderr
        pictures.append(np.asarray(Image.open(out).convert("RGB")))
    assert pictures[0].shape == (600, 1000, 3)
    assert colours_of(pictures[0]) > 50
    assert (pictures[0] != pictures[1]).any(axis=2).mean() < 0.02  # letters of two platforms


def test_a_canvas_that_is_forced_and_cannot_be_had_is_refused(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "app", "--canvas", "opengl", "--screenshot", tmp_path / "a.png"],
        cwd=ROOT, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True, text=True, timeout=PATIENCE_S, check=False,
    )  # fmt: skip
    assert done.returncode == 3
    assert "platform offscreen shows no OpenGL" in done.stderr and done.stderr.count("\n") == 1


def test_a_blurred_picture_is_refined_while_nothing_changes_and_then_rests(
    opened: Opened, qtbot: QtBot
) -> None:
    window = opened()
    window.store.open(document_of("focus"))
    pane = window.panes["image"]
    qtbot.waitUntil(lambda: pane.drawing is not None and not pane.drawing.is_coarse, timeout=60_000)
    fine = pixels(window, "image")
    settle()
    with counted_repaints(window) as counts:
        qtbot.wait(3 * REST_MS)
    assert not any(counts.values())
    window.store.open(replace(document_of("focus"), settings={"aperture": 0.5}))
    assert pane.drawing is not None and pane.drawing.is_coarse
    qtbot.waitUntil(lambda: not pane.drawing.is_coarse, timeout=60_000)
    settle()
    assert abs(pixels(window, "image").astype(int) - fine).max() > 60
