"""The whole window: one model drives three panes, and nothing is lost."""

import contextlib
import gc
import itertools
import json
import math
import os
import re
import subprocess
import sys
import weakref
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest
from PIL import Image
from PySide6.QtCore import QEvent, QMimeData, QObject, QPoint, QPointF, QSize, Qt, QTimer, QUrl
from PySide6.QtGui import QAction, QDropEvent, QFont
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QLabel,
    QLineEdit,
    QMessageBox,
    QProgressDialog,
    QPushButton,
    QScrollArea,
    QStyle,
    QStyleOptionSlider,
    QTextEdit,
    QToolButton,
)

import app.scenes.scene
from app.bootstrap import ROOT
from app.document.codec import picture_json, to_json
from app.document.document import Document
from app.document.files import extract, read, write
from app.document.lengths import Size
from app.drawings.figure import Figure
from app.drawings.figure_files import png_bytes
from app.drawings.image import ImageDrawing
from app.drawings.stage import StageDrawing
from app.drawings.style import DARK, LIGHT, rgb
from app.drawings.world import WorldDrawing
from app.model.projection import Camera, Orbit, Orthographic, Perspective, Projection
from app.model.refusal import REFUSALS, Refusal
from app.precision.quality import Quality
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import load
from app.scenes.shapes import GRID_RGB
from tests import PATIENCE_MS, PATIENCE_S
from tests.support.controls import number
from tests.support.drawings import colours_of, labels_of
from tests.support.meshes import PYRAMID, obj_file
from tests.support.phenomenon import EVERYTHING, make_known
from tests.support.window import (
    LEFT,
    NO_KEY,
    MakeWindow,
    activate,
    click,
    counted_repaints,
    edit,
    enter,
    named,
    pixels,
    pixels_of,
    present,
    rgb_of,
    seen,
    settle,
    show_scene,
    turn,
)
from widgets.controls.controls import Controls
from widgets.panels.frame_panel import FramePanel
from widgets.panels.matrix_panel import MatrixPanel
from widgets.panes.counting import Counting
from widgets.panes.stage_strip import StageStrip
from widgets.parts import palette
from widgets.parts.icons import Combo
from widgets.parts.labels import WarningLabel
from widgets.parts.messages import number_text, sentence
from widgets.window import recovery
from widgets.window.export_dialog import ExportDialog
from widgets.window.files import Files
from widgets.window.main_window import MainWindow
from widgets.window.pictures import preview
from widgets.window.probing import Probing
from widgets.window.recovery import Autosave
from widgets.window.scene_guide import SceneGuide
from widgets.window.settings import Settings, data_folder
from widgets.window.status_line import StatusLine

# -- one model, three panes


def test_nothing_under_a_canvas_is_painted(window: MainWindow) -> None:
    """Qt would, and hand all of it to OpenGL, whenever a slider is painted beside the canvases."""
    slider = window.controls.rows["fov_y_deg"].slider
    settle()
    painted: list[QObject] = []

    class Watch(QObject):
        def eventFilter(self, watched: QObject, event: QEvent) -> bool:
            if event.type() == QEvent.Type.Paint:
                painted.append(watched)
            return False

    watch = Watch()
    for widget in (slider, *window.panes.values()):
        widget.installEventFilter(watch)
    slider.setValue(slider.value() + 1)
    settle()
    assert painted == [slider]


@pytest.mark.smooth
@pytest.mark.parametrize("software", [True, False])
def test_a_drag_repaints_once_a_step_and_without_a_gpu_once_to_refine(
    make_window: MakeWindow, software: bool
) -> None:
    window = make_window(software_rendering=software)
    window.store.set_view(names=())  # the end of a gesture would place labels again
    settle()
    with counted_repaints(window) as counts:
        window.store.begin_gesture()
        # A GPU gets one step only: this computer is so slow that the next one is coarser.
        depths = ("direct3d", "opengl", "direct3d") if software else ("direct3d",)
        for step, depth in enumerate(depths, start=1):
            window.store.set_projection(seen(window, depth=depth))
            settle()
            assert counts == dict.fromkeys(window.panes, step)
        window.store.end_gesture()
        settle()
    assert counts == dict.fromkeys(window.panes, 4 if software else 1)


@pytest.mark.undrawn
def test_a_change_reaches_only_the_listeners_that_it_concerns(
    make_window: MakeWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: set[str] = set()
    kinds = Controls, Counting, Files, FramePanel, MatrixPanel, Probing, SceneGuide, StageStrip
    for kind in (*kinds, StatusLine):

        def take(self: Any, *given: Any, name: str = kind.__name__, own: Any = kind.take) -> None:
            told.add(name)
            own(self, *given)

        monkeypatch.setattr(kind, "take", take)
    window = make_window()
    window.panels.open(window.matrices)
    store, document = window.store, window.store.document
    always = {"Controls"}
    for change, others in (
        (lambda: store.set_projection(seen(window, lens=Perspective(45.0, 2.0, 30.0))),
         {"StageStrip", "StatusLine", "MatrixPanel"}),
        (lambda: store.set_projection(seen(window, camera=Camera((1.0, 2.0, 3.0)))),
         {"StatusLine", "MatrixPanel"}),
        (lambda: store.set_document(replace(store.document, quality=Quality(smoothing="none"))),
         {"SceneGuide"}),
        (lambda: store.set_document(replace(document, scene="cube")),
         {"Probing", "SceneGuide", "Files", "StatusLine", "StageStrip", "MatrixPanel"}),
    ):  # fmt: skip
        told.clear()
        change()
        assert told == always | others
    told.clear()
    window.panels.open(window.frame_panel)
    assert told == {"FramePanel"}


def test_the_cube_says_its_limits_from_the_start(window: MainWindow) -> None:
    assert window.panes["ndc"].header.note.text() == "x, y ±1, z −1 … 1"


def test_a_hidden_pane_neither_computes_nor_draws_and_catches_up(window: MainWindow) -> None:
    window.slots.make_large("world")
    settle()
    asked: list[Projection] = []
    drawing = window.panes["image"].drawing
    show = drawing.show_projection
    drawing.show_projection = lambda projection, illustration: (
        asked.append(projection),
        show(projection, illustration),
    )
    with counted_repaints(window) as counts:
        for step in range(3):
            window.store.set_projection(seen(window, lens=Perspective(46.0 + step, 1.0, 30.0)))
            settle()
    assert asked == []
    assert counts == {"world": 3, "ndc": 0, "image": 0}
    window.slots.make_large("world")
    settle()
    assert asked == [window.store.document.projection]


def test_a_pane_that_reappears_looks_as_if_never_hidden(make_window: MakeWindow) -> None:
    """The end of a gesture, which fits its view and places its labels, may have passed it by."""
    window, pictures = make_window(), []
    start = window.store.document.projection
    for hidden in (False, True):
        window.store.set_projection(start)
        window.slots.reset_views()
        settle()
        if hidden:
            window.slots.arrange("pictures", "image", "image")
            settle()
        window.store.set_projection(seen(window, lens=Perspective(100.0, 1.0, 30.0)))
        settle()
        if hidden:
            window.slots.arrange("pictures", "world")
            settle()
        pictures.append(pixels(window, "world"))
    assert pictures[0].shape == pictures[1].shape and (pictures[0] == pictures[1]).all()


def test_a_window_that_opens_draws_each_pane_once(make_window: MakeWindow, qtbot: Any) -> None:
    """Qt would have it drawn as soon as it has a size, and again when it is shown."""
    window = make_window(shown=False)
    with counted_repaints(window) as counts:
        window.show()
        qtbot.waitExposed(window)
        qtbot.waitUntil(lambda: all(counts.values()))
        settle()
    assert counts == dict.fromkeys(window.panes, 1)


def test_idle_draws_nothing_even_with_an_open_panel(window: MainWindow) -> None:
    show_scene(window, "similar-triangles")
    window.panels.open(window.scene_panel)
    settle()
    with counted_repaints(window) as counts:
        QTest.qWait(700)
    assert counts == dict.fromkeys(window.panes, 0)


# -- the panes' own views


def test_the_world_stands_still_during_a_drag_and_fits_itself_after_it(window: MainWindow) -> None:
    camera = window.panes["world"].hand.camera
    place, distance = camera.GetPosition(), camera.GetDistance()
    window.store.begin_gesture()
    window.store.set_projection(seen(window, camera=Camera((18.0, 15.0, 27.0))))
    settle()
    assert camera.GetPosition() == place
    with counted_repaints(window) as counts:
        window.store.end_gesture()
        settle()
    assert counts["world"] == 1
    assert camera.GetDistance() > 1.05 * distance
    assert window.panes["world"].view is None


def test_turning_stops_at_the_pole(window: MainWindow) -> None:
    canvas, camera = window.panes["world"].canvas, window.panes["world"].hand.camera
    for _ in range(30):
        QTest.keyClick(canvas, Qt.Key.Key_Down)
        assert camera.GetViewUp()[1] > 0.0
        x, y, z = np.subtract(camera.GetPosition(), camera.GetFocalPoint())
        assert y / math.hypot(x, y, z) < math.sin(math.radians(89.1))


@pytest.mark.parametrize("name", ["world", "ndc"])
def test_labels_stay_while_a_view_is_turned_and_stand_afresh_after_it(
    window: MainWindow, name: str, qtbot: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    pane, asked = window.panes[name], list[dict[str, bool]]()
    assert pane.drawing is not None
    monkeypatch.setattr(pane.drawing.layers, "place_labels", lambda **how: asked.append(how))
    QTest.keyClick(pane.canvas, Qt.Key.Key_Right)
    assert any(how.get("afresh") for how in asked), "a single change"
    asked.clear()
    QTest.mousePress(pane.canvas, LEFT, pos=QPoint(100, 100))
    QTest.mouseMove(pane.canvas, QPoint(180, 130))
    assert asked and not any(how.get("afresh") for how in asked)
    QTest.mouseRelease(pane.canvas, LEFT, pos=QPoint(180, 130))
    qtbot.waitUntil(lambda: asked[-1].get("at_rest", False))


def test_keys_turn_move_and_zoom_a_pane_that_tab_has_reached(
    window: MainWindow, qtbot: Any
) -> None:
    activate(window)
    settle()
    keys, shift = Qt.Key, Qt.KeyboardModifier.ShiftModifier
    canvas, model = window.panes["world"].canvas, window.store.document
    camera = window.panes["world"].hand.camera
    window.menus.scene_box.setFocus()
    for _ in range(20):
        if not canvas.hasFocus():
            QTest.keyClick(QApplication.focusWidget(), keys.Key_Tab)
    assert canvas.hasFocus()
    start = camera.GetPosition(), camera.GetFocalPoint()
    for there, back in (
        ((keys.Key_Right,), (keys.Key_Left,)),
        ((keys.Key_Down,), (keys.Key_Up,)),
        ((keys.Key_Right, shift), (keys.Key_Left, shift)),
        ((keys.Key_Plus, shift), (keys.Key_Minus,)),
        ((keys.Key_Up,), (keys.Key_Home,)),
    ):
        with counted_repaints(window) as counts:
            QTest.keyClick(canvas, *there)
            settle()
        assert counts["world"] == 1
        moved = camera.GetPosition(), camera.GetFocalPoint()
        is_panned = there == (keys.Key_Right, shift)
        assert math.dist(moved[0], start[0]) > 0.3
        assert (math.dist(moved[1], start[1]) > 0.3) == is_panned
        QTest.keyClick(canvas, *back)
        assert camera.GetPosition() == pytest.approx(start[0])
        assert camera.GetFocalPoint() == pytest.approx(start[1])
    assert window.store.document == model
    assert (camera.GetPosition(), window.panes["world"].view) == (start[0], None)


def test_a_floating_pane_still_draws_and_docks_again(
    window: MainWindow, qtbot: Any, qtlog: Any
) -> None:
    pane = window.panes["ndc"]
    window.slots.toggle_float("ndc")
    qtbot.waitExposed(pane)
    assert pane.isWindow()
    before = pixels(window, "ndc")
    window.store.set_projection(seen(window, camera=Camera((-7.0, 3.0, 6.0))))
    settle()
    assert (pixels(window, "ndc") != before).any()
    assert colours_of(pixels(window, "ndc")) > 10
    pane.close()  # its own close button docks it
    settle()
    said = [record.message for record in qtlog.records]
    assert not [message for message in said if "QRhi" in message], "of the window it has left"
    assert not pane.isWindow() and pane.isVisible()
    assert window.panes["image"].geometry().bottom() < pane.geometry().top(), "its slot of before"
    window.store.set_projection(seen(window, camera=Camera((7.0, 3.0, 6.0))))
    settle()
    assert colours_of(pixels(window, "ndc")) > 10


# -- room


@pytest.mark.undrawn
def test_the_strip_plays_on_while_its_pane_goes_to_a_window_and_back(window: MainWindow) -> None:
    window.strip.play()
    for floats in (True, False):
        window.slots.toggle_float("ndc")
        settle()
        assert window.panes["ndc"].isWindow() == floats and window.strip.playing
    window.strip.pause()
    window.slots.toggle_float("ndc")
    assert not window.strip.playing


def test_themes_and_sizes_for_a_class_apply_to_every_pane(window: MainWindow) -> None:
    turn(window, "ndc")
    view = window.panes["ndc"].view
    for theme in ["light", "dark"]:
        window.look.set_theme(theme)
        size, style = window.font().pointSizeF(), {"light": LIGHT, "dark": DARK}[theme]
        settle()
        thin = share_of(window, rgb(style.near))
        window.look.set_presenting(True)
        settle()
        assert QApplication.font().pointSizeF() > 1.2 * size
        assert share_of(window, rgb(style.near)) > 1.2 * thin > 0.0, "its lines are thicker"
        background = np.median(pixels(window, "world").reshape(-1, 3), axis=0).mean()
        assert (background < 128) == (theme == "dark")
        window.look.set_presenting(False)
        window.look.set_theme("light")
        assert QApplication.font().pointSizeF() == pytest.approx(size)
    now = window.panes["ndc"].view
    assert window.panes["world"].view is None and view is not None and now is not None
    assert now.eye == pytest.approx(view.eye)


@pytest.mark.undrawn
def test_everything_has_a_name_and_a_tip(window: MainWindow) -> None:
    for button in window.findChildren(QPushButton):
        assert button.text() or button.accessibleName()
    for button in window.findChildren(QToolButton):
        assert button.isHidden() or button.toolTip(), button.text()
    for box in window.findChildren(QComboBox):
        assert box.accessibleName() and box.toolTip()


# -- files


@pytest.mark.undrawn
def test_save_open_and_the_unsaved_mark(window: MainWindow, tmp_path: Path) -> None:
    assert not window.isWindowModified()
    window.store.set_projection(seen(window, lens=Perspective(60.0, 2.0, math.inf)))
    assert window.isWindowModified()
    path = tmp_path / "lesson.json"
    assert window.files.save_to(path)
    assert not window.isWindowModified()
    assert read(path).projection == window.store.document.projection
    assert "lesson.json" in window.windowTitle()
    window.store.undo()
    assert window.isWindowModified()
    window.store.redo()
    assert not window.isWindowModified()
    other = tmp_path / "R&D.json"
    write(Document("cube", Projection(lens=Orthographic())), other)
    assert window.files.open(other)
    assert window.store.document.scene == "cube"
    assert window.files.recent[:2] == [str(other), str(path)]
    texts = [action.text() for action in window.menus.recent.actions()]
    assert texts[:2] == [str(tmp_path / "R&&D.json"), str(path)]  # as Qt writes an &


@pytest.mark.undrawn
def test_what_is_left_out_of_a_mesh_is_said(make_window: MakeWindow, tmp_path: Path) -> None:
    mesh, sound = tmp_path / "small.obj", tmp_path / "sound.obj"
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    mesh.write_text(f"{corners}f 1 2\nv nan 0 0\n", encoding="utf-8")
    sound.write_text(corners, encoding="utf-8")
    window = make_window(shown=False)
    for act in (window.files.open, window.files.use_mesh):
        assert window.files.open(sound) and window.messages.text == ""
        window.files.choose_scene("similar-triangles")
        assert act(str(mesh))
        assert window.messages.text.startswith(f"{mesh}: faces left out: 1 of 2, because")
        assert f"{mesh}: vertices left out: 1 of 4, because" in window.messages.text
    scene = load(str(mesh))
    started = make_window(Document(str(mesh), scene.start), scene=scene, shown=False)
    assert started.messages.text.startswith(f"{mesh}: faces left out")


def test_a_bad_file_gives_one_sentence_and_leaves_the_window_as_it_was(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    window = make_window(on_triangles(), shown=False)
    contents = {
        "missing.json": None,
        "missing.obj": None,
        "cut.json": b'{"format": "frustum-lab", "version": 1, "sce',
        "text.stl": b"this is not a mesh",
        "plain.png": b"\x89PNG\r\n\x1a\nnot really",
        "notes.txt": b"hello",
        "gone.json": to_json(Document(str(tmp_path / "gone.stl"))).encode(),
        "its-mesh.json": to_json(on_triangles(mesh=str(tmp_path / "gone.stl"))).encode(),
    }
    for name, content in contents.items():
        if content is not None:
            (tmp_path / name).write_bytes(content)
    before = window.store.document
    for path in (tmp_path, *(tmp_path / name for name in contents)):
        for act in (window.files.open, window.files.use_mesh):
            window.messages.hide()
            assert not act(str(path))
            assert path.name in window.messages.text
            assert "\n" not in window.messages.text and window.messages.text.endswith((".", "?"))
            assert list(window.store.documents) == [before]
            assert window.files.recent == []


@pytest.mark.parametrize(
    ("way", "kind", "step"),
    [
        ("open", WorldDrawing, "__init__"),
        ("read again", ImageDrawing, "__init__"),
        ("lesson", WorldDrawing, "show_projection"),
        ("undo", StageDrawing, "show_projection"),
    ],
)
def test_a_scene_whose_drawing_fails_leaves_everything_as_it_was(
    window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, way: str, kind: Any,
    step: str, caplog: pytest.LogCaptureFixture,
) -> None:  # fmt: skip
    mesh, lesson = tmp_path / "bad.obj", tmp_path / "bad.md"
    obj_file(mesh, PYRAMID)
    lesson.write_text(
        "---\ntitle: Bad\n---\n# A step\n```state\nscene=bad.obj\n```\n", encoding="utf-8"
    )
    assert window.files.open(mesh)
    assert window.files.choose_scene("similar-triangles")
    if way == "read again":
        assert window.files.use_mesh(str(mesh))
    window.store.set_projection(seen(window, camera=Camera((-7.0, 3.0, 6.0))))
    window.menus.fixed[""].trigger()  # of its own the scene is seen from the side
    window.panes["world"].look_from(Camera((9.0, 3.0, 6.0)))
    if way == "undo":
        window.store.undo()
        window.look.rebuild()  # no drawing of it rests

    def state() -> tuple[Any, ...]:
        settle()
        return (
            window.store.seen, window.store.origin, list(window.store.documents),
            window.windowTitle(), window.files.recent, window.lessons.lesson, window.shown.scene,
            *(rgb_of(place.grab().toImage()).tobytes() for place in (
                *(pane.canvas for pane in window.panes.values()), window.controls)),
        )  # fmt: skip

    before, original, is_armed = state(), getattr(kind, step), [True]

    def fails_once(self: Any, *args: Any, **options: Any) -> Any:
        done = original(self, *args, **options)
        if is_armed.pop() if is_armed else False:
            raise IndexError("no such corner")
        return done

    monkeypatch.setattr(kind, step, fails_once)
    act: dict[str, Callable[[], object]] = {
        "open": partial(window.files.open, mesh),
        "read again": partial(window.files.use_mesh, str(mesh)),
        "lesson": partial(window.files.open, lesson),
        "undo": window.store.undo,
    }
    assert act[way]() in (None, False) or way == "lesson"
    assert not is_armed
    assert window.messages.text == (
        "bad.obj cannot be drawn, so the previous scene stays: IndexError('no such corner')"
    )
    window.messages.done()
    for old, new in zip(before, state(), strict=True):
        assert new == old
    caplog.clear()  # its traceback holds the window


def drop(window: MainWindow, *paths: Path) -> None:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    window.dropEvent(QDropEvent(QPointF(200, 200), Qt.DropAction.CopyAction, data, LEFT, NO_KEY))
    settle()


def test_only_the_first_of_several_dropped_files_is_opened(
    window: MainWindow, tmp_path: Path
) -> None:
    mesh = tetrahedron(tmp_path)
    drop(window, mesh, tmp_path / "second.json")
    assert window.store.document.scene == str(mesh)
    assert window.status.currentMessage() == "One file is opened at a time: tetra.obj"
    trace = window.store.document.projection.trace([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
    assert not trace.outside.any()
    assert colours_of(pixels(window, "image")) > 3


@pytest.mark.undrawn
def test_reset_and_another_scene_forget_a_refused_text(window: MainWindow) -> None:
    activate(window)
    window.controls.sections["animation"].set_open(True)
    far: Any = window.controls.rows["far"]
    speed = window.controls.animation.speed
    for row, text, act, shown in (
        (far, "3", window.menus.reset.trigger, "12.5"),
        (speed, "-1e99", lambda: window.files.choose_scene("cube"), "20"),
    ):
        enter(row.field, text)
        assert row.error and row.field.text() == text and row.field.hasFocus()
        act()
        assert (row.error, row.field.text()) == ("", shown) and row.field.at_rest


def test_a_picture_written_through_a_link_finds_its_mesh(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    window = make_window(shown=False)
    mesh, link = tetrahedron(tmp_path), tmp_path / "link.png"
    assert window.files.open(mesh)
    (tmp_path / "deep").mkdir()
    link.symlink_to(tmp_path / "deep" / "real.png")
    assert window.pictures.export(link, window.pictures.figure(panes=("image",), size=(64, 64)))
    assert window.files.open(link), window.messages.text
    assert window.store.document.scene == str(mesh)


def test_a_picture_shows_the_panes_as_they_were_turned_and_so_does_its_document(
    window: MainWindow, tmp_path: Path
) -> None:
    straight, turned = tmp_path / "straight.png", tmp_path / "turned.png"
    figure = partial(window.pictures.figure, panes=("world", "ndc"), size=(800, 400))
    window.pictures.export(straight, figure())
    for name in ("world", "ndc"):
        turn(window, name)
    assert not window.store.modified, "to look from elsewhere changes no document"
    before = {name: pixels(window, name) for name in ("world", "ndc")}
    window.pictures.export(turned, figure())
    picture = np.asarray(Image.open(turned))
    assert (picture != np.asarray(Image.open(straight))).mean() > 0.02
    document = read(turned)
    again = Figure(document, load("letter-f"), ("world", "ndc"), (800, 400))
    assert (again.pixels() == picture).all()

    window.slots.reset_views()
    settle()
    assert any((pixels(window, name) != before[name]).any() for name in before)
    drop(window, turned)
    for name, there in before.items():
        assert (pixels(window, name) == there).all(), name
    drop(window, straight)
    assert window.panes["world"].view is None and window.panes["ndc"].view is None


def test_the_picture_on_the_clipboard_carries_the_document(window: MainWindow) -> None:
    window.pictures.copy()
    data = QApplication.clipboard().mimeData()
    assert data.hasImage()
    text = extract(bytes(data.data("image/png").data()))
    assert text is not None and json.loads(text)["scene"] == "letter-f"


@contextlib.contextmanager
def cancelling(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """Cancel each progress dialog as soon as it is there; yield what the dialogs say."""
    monkeypatch.setattr("widgets.parts.progress.SHOWN_AFTER_MS", 0)
    shown: list[str] = []

    def cancel() -> None:
        dialog = QApplication.activeModalWidget()
        if isinstance(dialog, QProgressDialog):
            shown.append(dialog.labelText())
            dialog.cancel()

    timer = QTimer()
    timer.timeout.connect(cancel)
    timer.start(0)
    yield shown
    timer.stop()


@pytest.mark.undrawn
def test_an_export_can_be_cancelled(
    make_window: MakeWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window, path = make_window(shown=False), tmp_path / "figure.png"
    with cancelling(monkeypatch) as shown:
        assert not window.pictures.export(path, window.pictures.figure(size=(900, 300)))
    assert shown and not path.exists() and window.messages.text == ""


def test_a_preview_can_be_cancelled(
    make_window: MakeWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = make_window(shown=False)
    titles = {name: pane.accessibleName() for name, pane in window.panes.items()}
    dialog = ExportDialog(titles, window.pictures.figure(), window, preview)
    combos = {combo.itemText(1): combo for combo in dialog.findChildren(Combo)}
    for name in ("SVG", "dashed"):  # lines behind faces take long
        combos[name].setCurrentIndex(1)
    with cancelling(monkeypatch) as shown:
        dialog.show_preview()
    drawn = named(dialog, QLabel, "Preview")
    assert shown == ["Drawing the preview"] and drawn.pixmap().isNull()
    dialog.show_preview()
    assert not drawn.pixmap().isNull()


def test_a_preview_is_on_paper_though_the_figure_is_transparent(make_window: MakeWindow) -> None:
    window = make_window(shown=False)
    figure = window.pictures.figure(panes=("world",), size=(200, 150))
    room, telling = QSize(200, 150), lambda _part: True
    drawn = [preview(replace(figure, transparent=on), room, telling) for on in (True, False)]
    assert not drawn[0].hasAlphaChannel() and drawn[0].toImage() == drawn[1].toImage()


def test_a_message_goes_when_the_next_try_succeeds_and_an_offer_stays(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    window = make_window(shown=False)
    edit(window)
    messages, taken = window.messages, []
    path, nowhere = tmp_path / "lesson.json", tmp_path / "no such folder"
    figure = window.pictures.figure(panes=("image",), size=(64, 64))
    assert not window.pictures.export(nowhere / "figure.png", figure)
    assert "figure.png" in messages.text
    assert window.pictures.copy() and messages.text == ""
    assert not window.files.save_to(nowhere / "lesson.json") and window.store.modified
    assert "lesson.json" in messages.text
    assert window.files.save_to(path) and messages.text == ""
    messages.show_message("An offer.", ("Take it", partial(taken.append, "it")))
    assert window.files.save_to(path) and messages.text == "An offer."
    assert not window.files.save_to(nowhere / "lesson.json")
    assert "no such folder" in messages.text and not messages.choices
    assert window.files.save_to(path) and messages.text == "An offer."
    messages.show_message("A refusal.")
    named(messages, QToolButton, "Dismiss this message").click()
    assert messages.text == "An offer."
    messages.show_message("A refusal.")
    messages.hide_message("A refusal.")
    messages.choices[0].click()
    assert messages.text == "" and taken == ["it"]
    messages.show_message("A refusal.")
    messages.show_message("An offer.", ("Take it", partial(taken.append, "it")))
    assert messages.text == "A refusal." and not messages.choices
    named(messages, QToolButton, "Dismiss this message").click()
    assert messages.text == "An offer." and messages.choices
    named(messages, QToolButton, "Dismiss this message").click()
    messages.show_message("A refusal.")
    messages.show_message("It is done.", ("Undo", partial(taken.append, "it")), warns=False)
    assert messages.text == "It is done."
    messages.choices[0].click()
    messages.show_message("A refusal.")
    messages.done()
    assert messages.text == ""
    messages.show_message("Another offer.", ("Take it", lambda: None))
    named(messages, QToolButton, "Dismiss this message").click()
    messages.done()
    assert messages.text == ""


def test_the_export_dialog_refuses_what_cannot_be_drawn(make_window: MakeWindow) -> None:
    window = make_window(shown=False)
    window.store.set_projection(seen(window, image_size=(640, 360)))
    shown = window.pictures.figure()
    dialog = ExportDialog(
        {n: pane.accessibleName() for n, pane in window.panes.items()}, shown, window
    )
    save = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)
    problem = dialog.findChild(WarningLabel)
    (scale,) = (each for each in dialog.findChildren(Combo) if each.itemText(0) == "1 ×")
    width = named(dialog, QLineEdit, "Width of the picture")
    panes = {box.text(): box for box in dialog.findChildren(QCheckBox)}
    assert save.isEnabled()
    for box in panes.values():
        box.setChecked(False)
    assert not save.isEnabled() and problem.text()
    panes["Image"].setChecked(True)
    assert dialog.figure() == replace(shown, panes=("image",), size=Size(640, 360))
    no_number, too_large = "must be whole numbers", "width = 1e400: must be a whole number"
    for text, part in (("1_800", no_number), ("\uff11", no_number), ("1e3", no_number),
                       ("", no_number), ("9" * 5000, no_number), ("9" * 400, too_large),
                       ("0", "width = 0"), (" 640 ", ""), ("16384", "")):  # fmt: skip
        width.setText(text)
        assert save.isEnabled() == (part == "") and part in problem.text(), text
    scale.setCurrentIndex(1)
    assert not save.isEnabled()
    scale.setCurrentIndex(0)
    width.selectAll()
    QTest.keyClicks(width, "777")
    panes["World"].setChecked(True)
    assert dialog.figure().size == Size(777, 360), "a typed size stays"


def test_a_number_of_400_digits_is_refused_in_a_sentence() -> None:
    """As a document may hold it; float64 has no such number, and infinity is another."""
    with pytest.raises(Refusal) as refused:
        Perspective(45.0, 10**399, math.inf)
    assert "1e399" in sentence(refused.value)
    assert number_text(-(10**399)) == "-1e399"
    assert number_text(-math.inf) == "-∞"


def answer(button: QMessageBox.StandardButton) -> None:
    """Press a button of the question that will be asked."""

    def press() -> None:
        box = QApplication.activeModalWidget()
        assert isinstance(box, QMessageBox)
        box.button(button).click()

    QTimer.singleShot(0, press)


@pytest.mark.undrawn
def test_closing_with_unsaved_work_asks(window: MainWindow, tmp_path: Path) -> None:
    edit(window)
    answer(QMessageBox.StandardButton.Cancel)
    assert not window.close()
    assert window.isVisible()
    window.store.origin.path = tmp_path / "kept.json"
    answer(QMessageBox.StandardButton.Save)
    assert window.close()
    assert read(tmp_path / "kept.json") == window.store.document


@pytest.mark.undrawn
def test_saving_over_the_work_of_another_program_asks(
    make_window: MakeWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window, path = make_window(shown=False), tmp_path / "lesson.json"
    asked: list[str] = []

    def press(text: str) -> None:
        def click() -> None:
            box = QApplication.activeModalWidget()
            assert isinstance(box, QMessageBox)
            asked.append(box.text())
            next(button for button in box.buttons() if button.text() == text).click()

        QTimer.singleShot(0, click)

    assert window.files.save_to(path)
    edit(window)
    assert window.files.save() and asked == [], "only this window wrote"
    for depth, text in (("direct3d", "Cancel"), ("reversed", "Save &as…"), ("opengl", "")):
        window.store.set_projection(seen(window, depth=depth))
        theirs = Document("posts")
        write(theirs, path)
        other = tmp_path / "mine.json"
        monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_, to=other: (str(to), ""))
        press(text or "Save &over it")
        assert window.files.save() == (text != "Cancel")
        assert read(path) == (theirs if text else window.store.document)
        if text == "Save &as…":
            assert read(other) == window.store.document and window.files.path == other
            assert window.files.open(path)
    assert (
        asked == ["lesson.json has been changed elsewhere since it was opened or saved here."] * 3
    )
    path.unlink()
    assert window.files.save() and path.exists(), "what is gone is written again"


def test_saving_over_a_file_whose_ending_was_not_typed_asks(
    make_window: MakeWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Qt asks about the typed name only, which belongs to another file."""
    window, asked = make_window(shown=False), list[str]()
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "mine"), ""))
    monkeypatch.setattr(QDialog, "exec", lambda _: QDialog.DialogCode.Accepted)  # the talk's title
    monkeypatch.setattr(QMessageBox, "exec", lambda box: asked.append(box.text()) or answers.pop())
    for ending, save in (
        (".md", window.talks.writer.begin_new),
        (".json", window.files.save_as),
        (".png", window.pictures.export_dialog),
    ):
        path = tmp_path / f"mine{ending}"
        path.write_text("mine", encoding="utf-8")
        answers = [QMessageBox.StandardButton.Yes, QMessageBox.StandardButton.Cancel]
        asked.clear()
        save()
        assert (
            asked == [f"mine{ending} already exists."]
            and path.read_text(encoding="utf-8") == "mine"
        )
        save()
        assert len(asked) == 2 and path.read_bytes() != b"mine"
    assert not (tmp_path / "mine").exists()


def being_typed(window: MainWindow, qtbot: Any, text: str) -> None:
    """Leave a number in the field of the vertical field of view, not yet entered."""
    field = number(window.controls, "fov_y_deg").field
    qtbot.mouseClick(field, LEFT)
    field.selectAll()
    qtbot.keyClicks(field, text)


def fov_deg(document: Document) -> float:
    lens = document.projection.lens
    assert isinstance(lens, Perspective)
    return lens.fov_y_deg


@pytest.mark.undrawn
def test_a_number_being_typed_is_saved_and_asked_about_at_closing(
    window: MainWindow, qtbot: Any, tmp_path: Path
) -> None:
    window.store.origin.path = tmp_path / "kept.json"
    being_typed(window, qtbot, "67")
    assert not window.store.modified
    window.menus.save.trigger()
    assert fov_deg(read(tmp_path / "kept.json")) == 67.0 and not window.store.modified
    being_typed(window, qtbot, "68")
    answer(QMessageBox.StandardButton.Cancel)
    assert not window.close()
    assert fov_deg(window.store.document) == 68.0
    being_typed(window, qtbot, "nonsense")
    answer(QMessageBox.StandardButton.Discard)
    assert window.close()


def test_closing_in_the_middle_of_a_drag_and_of_a_play(
    make_window: MakeWindow, everything: Document
) -> None:
    for is_walk in (True, False):
        window = make_window(everything)
        player = window.controls.animation if is_walk else window.controls.card.motions["turn"]
        window.store.begin_gesture()
        edit(window)
        player.play()
        player.advance(0.1)
        answer(QMessageBox.StandardButton.Discard)
        assert window.close()
        assert not player.playing


@pytest.mark.undrawn
def test_shortcuts_work_in_the_window_of_a_floated_pane(window: MainWindow, qtbot: Any) -> None:
    start, pane, ctrl = (
        window.store.document,
        window.panes["world"],
        Qt.KeyboardModifier.ControlModifier,
    )
    window.slots.toggle_float("world")
    pane.activateWindow()
    qtbot.waitUntil(pane.isActiveWindow)
    edit(window)
    qtbot.keyClick(pane, Qt.Key.Key_Z, ctrl)
    assert window.store.document == start
    qtbot.keyClick(pane, Qt.Key.Key_0, ctrl)
    assert not pane.isWindow()
    activate(window)
    window.history.redo()
    qtbot.keyClick(window, Qt.Key.Key_Z, ctrl)
    assert window.store.document == start


@pytest.mark.undrawn
def test_the_title_names_what_is_shown(make_window: MakeWindow, tmp_path: Path) -> None:
    window = make_window(shown=False)
    mesh = tetrahedron(tmp_path)
    assert "Untitled" in window.windowTitle()
    assert window.files.open(mesh)
    assert mesh.name in window.windowTitle()
    window.guide.choose("cube")
    assert "Untitled" in window.windowTitle()
    window.history.undo()
    assert mesh.name in window.windowTitle()


@pytest.mark.undrawn
def test_the_keys_that_help_names_are_those_of_the_window(make_window: MakeWindow) -> None:
    window = make_window(shown=False)
    window.menus.help.trigger()
    (box,) = (each for each in window.findChildren(QDialog) if each.isVisible())
    assert box.height() <= 0.9 * box.screen().availableSize().height()
    text = box.findChild(QTextEdit).toPlainText()
    named = set(re.findall(r"Ctrl\+\w+|\bF\d+", text)) - {"F2", "Ctrl+V"}  # of a matrix cell
    assert {"Ctrl+Space", "Ctrl+Z", "Ctrl+0", "Ctrl+1", "Ctrl+2", "Ctrl+3", "F4", "F5"} <= named
    assert named <= {action.shortcut().toString() for action in window.findChildren(QAction)}
    box.close()


# -- autosave


DIES = """
import os, signal, sys
from dataclasses import replace
from pathlib import Path
from PySide6.QtCore import QCoreApplication
from app.document.document import Document
from app.model.projection import Perspective
from widgets.window.recovery import Autosave
application = QCoreApplication([])
document = Document("posts")
document = replace(document, projection=replace(document.projection, lens=Perspective(61, 2, 20)))
autosave = Autosave(Path(sys.argv[1]), lambda: document)
autosave.save_now()
assert autosave.orphans() == []
os.kill(os.getpid(), signal.SIGKILL if hasattr(signal, "SIGKILL") else signal.SIGTERM)
"""


@pytest.mark.undrawn
def test_a_killed_process_leaves_its_work_to_the_next(make_window: MakeWindow) -> None:
    window = make_window(shown=False)
    folder = data_folder()
    own = list(folder.iterdir())

    def run(script: str) -> None:
        killed = subprocess.run([sys.executable, "-c", script, str(folder)], cwd=ROOT, check=False)
        assert killed.returncode != 0

    run(DIES.replace("autosave.save_now()", ""))
    assert len(list(folder.iterdir())) == 2, "its lock is left"
    assert window.recovery.autosave.orphans() == []
    assert list(folder.iterdir()) == own
    run(DIES)
    other = make_window(Document("cube"))
    activate(other)
    assert other.messages.choices, "it is offered"
    assert other.panes["world"].canvas.hasFocus(), "but Esc or Space dismisses it in the bar alone"
    window.recovery.offer()
    window.messages.choices[0].click()
    assert window.store.document.scene == "posts"
    assert window.store.document.projection.lens == Perspective(61.0, 2.0, 20.0)
    assert window.recovery.autosave.orphans() == []


def test_edits_do_not_put_off_the_copy_of_the_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A long animation is saved, too."""
    begun: list[QTimer] = []

    class Timer(QTimer):
        def start(self) -> None:  # type: ignore[override]
            begun.append(self)
            super().start()

    monkeypatch.setattr(recovery, "QTimer", Timer)
    autosave = Autosave(tmp_path, Document)
    for _ in range(3):
        autosave.schedule()
    assert len(begun) == 1
    begun[0].timeout.emit()
    assert autosave.path.exists()
    autosave.close()


@pytest.mark.undrawn
def test_a_normal_close_leaves_no_autosave(make_window: MakeWindow) -> None:
    window, folder = make_window(shown=False), data_folder()
    edit(window)
    window.recovery.autosave.save_now()
    assert list(folder.glob("autosave-*.json"))
    window.store.mark_saved()
    window.close()
    assert not list(folder.glob("autosave-*"))


@pytest.mark.undrawn
def test_a_broken_autosave_is_one_sentence(make_window: MakeWindow) -> None:
    window = make_window(shown=False)
    broken = data_folder() / "autosave-1-aaaa.json"
    broken.write_text("{", encoding="utf-8")
    window.recovery.offer()
    window.messages.choices[0].click()
    assert "autosave-1-aaaa.json" in window.messages.text
    assert not window.store.modified
    other = data_folder() / "autosave-3-aaaa.json"
    write(Document("cube"), other)
    whole = data_folder() / "autosave-2-aaaa.json"
    write(Document("posts"), whole)
    os.utime(whole, (1.0, 1.0))  # older
    window.messages.choices[1].click()
    assert not broken.exists()
    other.unlink()  # recovered in another window
    window.messages.choices[0].click()
    assert other.name in window.messages.text and not window.messages.choices
    window.recovery.offer()
    window.messages.done()  # the offer waits until the warning is dismissed
    window.messages.choices[0].click()
    assert window.store.document.scene == "posts"


@pytest.mark.undrawn
def test_recovered_work_is_in_a_copy_at_every_moment(
    make_window: MakeWindow, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    window = make_window(shown=False)

    def full(_document: Document, path: Path) -> None:
        raise Refusal.in_document(REFUSALS["unwritable"], "No space left on device", file=str(path))

    def on_a_full_disk(act: Callable[[], object]) -> None:
        with monkeypatch.context() as disk:
            disk.setattr("widgets.window.recovery.write", full)
            act()

    edit(window)
    on_a_full_disk(window.recovery.autosave.save_now)
    said = f"No copy of unsaved work can be kept in {data_folder()}: save it soon."
    assert window.messages.text == said
    window.store.mark_saved()
    lost = data_folder() / "autosave-1-aaaa.json"
    write(Document("posts"), lost)
    window.recovery.offer()
    named(window.messages, QToolButton, "Dismiss this message").click()  # the offer waited
    on_a_full_disk(window.messages.choices[0].click)
    assert window.store.document.scene == "posts"
    assert lost.exists() and "save it soon" in window.messages.text
    window.store.mark_saved()
    window.recovery.offer()
    named(window.messages, QToolButton, "Dismiss this message").click()
    window.messages.choices[0].click()
    (copy,) = data_folder().glob("autosave-*.json")
    assert copy != lost and read(copy).scene == "posts"
    caplog.clear()  # the errors hold the window


@pytest.mark.undrawn
def test_work_can_be_recovered_once_its_missing_mesh_is_back(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    window = make_window(shown=False)
    mesh = tetrahedron(tmp_path)
    copy = data_folder() / "autosave-1-aaaa.json"
    write(on_triangles(mesh=str(mesh)), copy)
    mesh.unlink()
    window.recovery.offer()
    window.messages.choices[0].click()
    assert mesh.name in window.messages.text and copy.exists()
    tetrahedron(tmp_path)
    window.messages.choices[0].click()
    assert window.store.document.mesh == str(mesh) and window.messages.text == ""


def test_the_autosave_folder_may_be_unusable(display: Any, tmp_path: Path) -> None:
    in_the_way = tmp_path / "file"
    in_the_way.write_text("", encoding="utf-8")
    autosave = Autosave(in_the_way / "data", lambda: Document())
    told: list[str] = []
    autosave.failed.connect(told.append)
    for _ in range(2):
        autosave.save_now()
    assert told == [str(in_the_way / "data")], "once"
    assert autosave.orphans() == []
    autosave.close()


def test_a_folder_that_fails_again_after_a_success_is_said_again(tmp_path: Path) -> None:
    autosave, told = Autosave(tmp_path, Document), list[str]()
    autosave.failed.connect(told.append)
    for _ in range(2):
        autosave.path.mkdir()
        assert not autosave.save_now() and not autosave.save_now()
        autosave.path.rmdir()
        assert autosave.save_now()
        autosave.path.unlink()
    assert told == [str(tmp_path)] * 2
    autosave.close()


@pytest.mark.undrawn
def test_a_copy_that_cannot_be_removed_keeps_no_window_open(
    make_window: MakeWindow, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    window = make_window(shown=False)
    other = data_folder() / "autosave-1-aaaa.json"
    write(Document("posts"), other)
    window.recovery.offer()
    window.store.set_projection(replace(window.store.document.projection, depth="direct3d"))
    assert window.recovery.autosave.save_now()

    def refuse(path: Path, missing_ok: bool = False) -> None:
        raise PermissionError(13, "Permission denied", str(path))

    with monkeypatch.context() as folder:
        folder.setattr(Path, "unlink", refuse)
        window.messages.choices[1].click()  # discard it
        assert window.messages.text == f"{other} could not be removed: Permission denied."
        window.store.mark_saved()
        assert window.close()
    assert "autosave stays" in caplog.text
    caplog.clear()  # the error holds the window


# -- scenes


@pytest.mark.undrawn
def test_a_window_of_a_missing_screen_opens_on_an_existing_one(make_window: MakeWindow) -> None:
    window, settings = make_window(), Settings(None)
    screen = window.screen().geometry()
    window.setGeometry(3 * screen.width(), 2 * screen.height(), 900, 650)
    settle()
    settings.geometry = bytes(window.saveGeometry().data())
    again = make_window(settings=settings)
    settle()
    assert screen.contains(again.frameGeometry()) and again.size().toTuple() == (900, 650)


@pytest.mark.undrawn
def test_damaged_geometry_of_the_window_is_ignored(make_window: MakeWindow) -> None:
    whole, settings = make_window(shown=False), Settings(None)
    for geometry in (b"\x00", b"x" * 70, bytes(range(256))):
        settings.geometry = geometry
        assert make_window(settings=settings, shown=False).size() == whole.size()


@pytest.mark.undrawn
def test_no_control_of_a_scene_is_in_the_dock_twice(window: MainWindow) -> None:
    show_scene(window, "oblique-drawing")
    rows, card = window.controls.rows, window.controls.card
    seen_rows = [row for row in {*rows.values(), *card.rows.values()} if row.isVisible()]
    names = [row.name for row in seen_rows]
    assert len(names) == len(set(names)) and card.rows["angle_deg"].isVisible()
    for key in ("preset", "receding", "receding_deg"):
        assert not rows[key].isVisible()
    window.controls.find_control()
    QTest.keyClicks(window.controls.search, "receding")
    assert not rows["receding"].isVisible() and card.rows["angle_deg"].isVisible()
    QTest.keyClick(window.controls.search, Qt.Key.Key_Escape)
    window.guide.choose("letter-f")
    window.store.set_projection(window.store.document.projection.with_lens("oblique"))
    settle()
    assert rows["preset"].isVisible()


# -- memory


def resident() -> int:
    return int(psutil.Process().memory_info().rss)


def test_windows_opened_and_closed_leave_nothing_behind(
    make_window: MakeWindow, display: QApplication
) -> None:
    """A leak of one window shows in six."""
    sizes, canvases = [], []
    for _ in range(6):
        window = make_window()
        canvases += [weakref.ref(pane.canvas) for pane in window.panes.values()]
        window.close()
        make_window.forget(window)  # type: ignore[attr-defined]
        del window
        display.processEvents()
        display.sendPostedEvents(None, 52)  # QEvent.DeferredDelete
        gc.collect()
        sizes.append(resident())
    assert sum(canvas() is not None for canvas in canvases) == 0
    assert sizes[-1] - sizes[1] < 20e6


def test_changes_do_not_pile_up(window: MainWindow) -> None:
    """The same changes again and again: the first round fills all caches."""
    window.resize(940, 420)  # quickly drawn
    window.store.begin_gesture()
    sizes = []
    for _ in range(4):
        for step in range(75):
            orbit = Orbit(37.0 * step % 360.0 - 180.0, step - 37.0, 2.0 + step / 2.0)
            near = 10.0 ** (step % 7 - 5)
            lens = Perspective(2.0 * (step + 1), near, near * 10.0 ** (1 + step % 8))
            camera = Camera.from_orbit((0.0, 2.2, 0.0), orbit)
            window.store.set_projection(Projection(camera, lens))
            QApplication.processEvents()
        gc.collect()
        sizes.append(resident())
    assert sizes[-1] - sizes[0] < 2e6
    window.store.end_gesture()


# -- phenomena

TRIANGLES = PHENOMENA["similar-triangles"]


def on_triangles(**changes: Any) -> Document:
    return Document("similar-triangles", TRIANGLES.start, **changes)


def illustrations_of(window: MainWindow) -> dict[str, list[Any]]:
    """What each pane is given to show from now on."""
    given: dict[str, list[Any]] = {}
    for name, pane in window.panes.items():
        given[name] = []
        for method in ("build", "take"):
            show = getattr(pane, method)

            def keep(
                shown: Any,
                *args: Any,
                to: list[Any] = given[name],
                show: Any = show,
                **options: Any,
            ) -> None:
                to.append(shown.illustration)
                show(shown, *args, **options)

            setattr(pane, method, keep)
    return given


@pytest.fixture
def everything(monkeypatch: pytest.MonkeyPatch) -> Document:
    """A document of a scene with a setting of every kind."""
    make_known(monkeypatch, EVERYTHING)
    return Document("everything", EVERYTHING.start)


def test_a_phenomenon_shows_its_card_and_opens_no_panel(window: MainWindow) -> None:
    card, box = window.controls.card, window.menus.scene_box
    before = pixels(window, "image")
    assert card.title.text() == "Letter F" and len(card.tries.text().splitlines()) == 3
    window.guide.choose("similar-triangles")
    settle()
    assert (pixels(window, "image") != before).any()
    assert (box.currentData(), window.panels.open_panel) == ("similar-triangles", None)
    assert card.title.text() == "Similar triangles"
    assert list(card.rows) == ["distance", "point"]
    row: Any = card.rows["distance"]
    enter(row.field, "0")
    assert row.error.startswith("Not possible. Plane distance d = 0: must not be 0: the plane")
    QTest.keyClick(row.field, Qt.Key.Key_Escape)
    assert card.isAncestorOf(window.controls.rows["distance"])  # the camera's
    click(card.explanation)
    assert window.panels.open_panel is window.scene_panel
    assert window.scene_panel.title.text() == "Similar triangles"
    window.guide.choose("cube")
    assert card.rows == {} and not card.isAncestorOf(window.controls.rows["distance"])
    assert window.panels.open_panel is None, "there is nothing to explain"
    window.store.undo()
    assert list(card.rows) == ["distance", "point"]
    assert window.panels.open_panel is window.scene_panel, "as it was left"
    window.store.undo()
    settle()
    assert box.currentData() == window.store.document.scene == "letter-f"
    assert (pixels(window, "image") == before).all()


def test_a_control_is_found_by_a_key_wherever_the_focus_is(window: MainWindow) -> None:
    activate(window)
    search, find = window.controls.search, window.menus.find
    window.panes["world"].canvas.setFocus()
    QTest.keyClick(window, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    assert search.hasFocus()
    QTest.keyClicks(search, "roll")
    assert window.controls.rows["roll_deg"].isVisible()
    QTest.keyClick(search, Qt.Key.Key_Escape)
    assert search.text() == "" and not window.controls.rows["roll_deg"].isVisible()
    field = window.controls.rows["near"].field  # type: ignore[attr-defined]
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "1/2")  # where / is part of a number
    assert field.hasFocus() and field.text() == "1/2"
    QTest.keyClick(field, Qt.Key.Key_Return)
    window.panes["world"].canvas.setFocus()
    QTest.keyClick(window, Qt.Key.Key_Slash)
    assert search.hasFocus() and search.text() == ""
    window.menus.controls.trigger()
    assert window.controls.isHidden()
    find.trigger()
    assert window.controls.isVisible() and window.menus.controls.isChecked() and search.hasFocus()


@pytest.mark.undrawn
def test_all_digits_are_a_setting_of_the_view_menu(make_window: MakeWindow) -> None:
    settings = Settings(None)
    window = make_window(settings=settings)
    field = window.controls.rows["azimuth_deg"].field  # type: ignore[attr-defined]
    few = field.text()
    assert len(few) == 5
    window.menus.all_digits.trigger()
    try:
        assert field.text().startswith("32.005383208") and settings.all_digits
        other = make_window(settings=settings)
        assert other.menus.all_digits.isChecked()
    finally:
        window.menus.all_digits.trigger()
    assert field.text() == few and not settings.all_digits
    assert not window.isWindowModified() and not window.store.can_undo


@pytest.mark.undrawn
def test_scenes_are_listed_in_the_order_of_the_lectures_by_their_titles(
    make_window: MakeWindow,
) -> None:
    window = make_window(shown=False)
    names = [action.data() for action in window.menus.scene_group.actions()]
    assert names[:2] == ["letter-f", "cube"]
    assert [name for name in names if name in PHENOMENA] == list(PHENOMENA)
    titles = {action.data(): action.text() for action in window.menus.scene_group.actions()}
    assert titles["similar-triangles"] == "Similar triangles"
    box = window.menus.scene_box
    listed = [box.itemData(index) for index in range(box.count())]
    assert [name for name in listed if name] == names
    first = names.index(next(iter(PHENOMENA)))
    assert listed[first] is None, "a separator before the first phenomenon"
    window.guide.choose("similar-triangles")
    assert box.currentText() == "Similar triangles"


def test_an_illustration_is_computed_once_a_change_and_shown_everywhere(
    make_window: MakeWindow, everything: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[Any] = []

    def show(*arguments: Any) -> Any:
        made.append(EVERYTHING.show(*arguments))
        return made[-1]

    counting = replace(EVERYTHING, show=show)
    monkeypatch.setitem(app.scenes.scene.PHENOMENA, "everything", counting)  # type: ignore[arg-type]
    window = make_window(everything)
    settle()
    made.clear()
    given = illustrations_of(window)
    with counted_repaints(window) as counts:
        window.store.set_settings({"gap": 3.0})
        settle()
        window.store.set_projection(seen(window, camera=Camera((-7.0, 3.0, 6.0))))
        settle()
    assert len(made) == 2
    assert given == dict.fromkeys(window.panes, made)
    assert counts == dict.fromkeys(window.panes, 2)
    value = window.controls.card.readout.lines[0][1]
    assert value.text() == "3"
    assert made[-1].readings[0].value == 3.0


@pytest.mark.undrawn
def test_no_illustration_of_one_scene_is_shown_in_another(window: MainWindow) -> None:
    show_scene(window, "similar-triangles")
    given = illustrations_of(window)
    window.guide.choose("posts")
    assert all(shown == [None] for shown in given.values())
    window.guide.choose("similar-triangles")
    for shown in given.values():
        assert shown[0] is None and shown[1] is not None and len(shown) == 2


@pytest.mark.undrawn
def test_undo_while_the_camera_walks_takes_back_what_was_done_last(window: MainWindow) -> None:
    walk, row = window.controls.animation, window.controls.rows["fov_y_deg"]
    start = window.store.document.projection
    walk.play()
    walk.advance(0.2)
    walked = window.store.document.projection
    enter(row.field, "70")
    walk.advance(0.2)
    window.menus.undo.trigger()
    assert window.store.document.projection == walked != start
    assert not walk.playing and window.store.can_redo  # playing on would leave nothing to redo
    window.menus.undo.trigger()
    assert window.store.document.projection == start
    assert not window.menus.undo.isEnabled() and window.menus.redo.isEnabled()
    window.menus.redo.trigger()
    window.menus.redo.trigger()
    assert window.store.document.projection.lens == replace(start.lens, fov_y_deg=70.0)
    window.menus.undo.trigger()
    walk.play()
    window.menus.redo.trigger()
    assert window.store.document.projection.lens == replace(start.lens, fov_y_deg=70.0)
    assert not walk.playing, "it would play on from another place"


@pytest.mark.undrawn
def test_a_play_is_one_step_of_undo_and_ends_with_the_scene(
    make_window: MakeWindow, everything: Document
) -> None:
    window = make_window(everything)
    player = window.controls.card.motions["turn"]
    player.play()
    for _ in range(5):
        player.advance(0.25)
    player.pause()
    assert window.store.document.settings["turn"] == 112.5
    window.store.undo()
    assert window.store.document == everything and not window.store.can_undo
    player.play()
    window.guide.choose("cube")
    assert not player.playing and not window.store.in_gesture


@pytest.mark.undrawn
def test_a_reset_while_the_camera_walks_puts_all_back_and_keeps_the_mesh(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    mesh = str(tetrahedron(tmp_path))
    window = make_window(on_triangles(mesh=mesh, settings={"distance": -3.0}))
    edit(window)
    window.controls.animation.play()
    window.controls.animation.advance(0.2)
    walked = window.store.document
    window.history.reset()
    settle()
    assert window.store.document == on_triangles(mesh=mesh)
    assert not window.controls.animation.playing
    window.store.undo()
    assert window.store.document == walked and walked.settings["distance"] == -3.0


def tetrahedron(folder: Path) -> Path:
    mesh = folder / "tetra.obj"
    mesh.write_text(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n", encoding="utf-8"
    )
    return mesh


@pytest.mark.undrawn
def test_a_picture_asks_for_a_mesh_that_is_not_beside_it(
    make_window: MakeWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("here", "there"):
        (tmp_path / name).mkdir()
    mesh, picture = tetrahedron(tmp_path / "there"), tmp_path / "here" / "a.png"
    text = picture_json(on_triangles(mesh=str(mesh)))
    picture.write_bytes(png_bytes(np.zeros((4, 4, 3), np.uint8), text))
    window = make_window(Document("cube"))
    asked = []

    def choose(_: object, title: str, *_more: object) -> tuple[str, str]:
        asked.append(title)
        return str(mesh), ""

    monkeypatch.setattr(QFileDialog, "getOpenFileName", choose)
    assert window.files.open(picture)
    assert window.store.document.mesh == str(mesh) and "tetra.obj" in asked[0]
    beside = tetrahedron(tmp_path / "here")
    assert window.files.open(picture) and len(asked) == 1
    assert window.store.document.mesh == str(beside)


def test_a_mesh_replaces_the_objects_and_is_removed_again(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    window = make_window(on_triangles(settings={"distance": 5.0}))
    own = pixels(window, "image")
    assert window.files.use_mesh(str(tetrahedron(tmp_path)))
    settle()
    assert (pixels(window, "image") != own).mean() > 0.005
    assert window.store.document.settings["distance"] == 5.0
    assert window.controls.card.remove_mesh.isVisible()
    document = window.store.document
    assert window.files.save_to(tmp_path / "lesson.json")
    assert read(tmp_path / "lesson.json") == document
    window.controls.card.remove_mesh.click()
    settle()
    assert window.store.document.mesh == ""
    assert (pixels(window, "image") == own).all()
    window.store.undo()
    assert window.store.document == document
    tetrahedron(tmp_path).unlink()
    window.store.undo()
    window.store.redo()  # undo cannot fail on a file that has gone meanwhile
    assert window.store.document == document


@pytest.mark.parametrize("way", ["mesh", "document", "in the objects' place"])
def test_a_file_that_is_opened_again_is_read_again(
    make_window: MakeWindow, tmp_path: Path, way: str
) -> None:
    """A user exports a mesh to the same file again and again, and looks at it each time."""
    window = make_window(on_triangles(), shown=False)
    path = mesh = tetrahedron(tmp_path)
    act: Callable[[str], bool] = window.files.open
    if way == "document":
        assert act(str(mesh))
        path = tmp_path / "lesson.json"
        assert window.files.save_to(path)
    elif way != "mesh":
        act = window.files.use_mesh
    assert act(str(path))
    before = window.shown.scene
    mesh.write_text(
        mesh.read_text(encoding="utf-8").replace("v 1 0 0", "v 7 0 0"), encoding="utf-8"
    )
    assert act(str(path))
    assert window.shown.scene is not before
    if way != "in the objects' place":  # where it is fitted into their box
        assert window.shown.scene.size > 4.0 * before.size
    for text in ("no mesh at all", None):
        if text is None:
            mesh.unlink()
        else:
            mesh.write_text(text, encoding="utf-8")
        shown = window.shown.scene
        assert not act(str(path))
        assert "tetra.obj" in window.messages.text
        assert window.shown.scene is shown


@pytest.mark.undrawn
def test_a_long_name_leaves_window_and_panel_as_wide(window: MainWindow, tmp_path: Path) -> None:
    window.resize(1366, 768)
    path = tmp_path / f"{'x' * 200}.obj"
    path.write_text("", encoding="utf-8")
    assert not window.files.open(path)
    settle()
    assert path.name in window.messages.text and window.messages.isVisible()
    assert window.width() == 1366
    path = tmp_path / f"{'x' * 100}\n{'y' * 100}.obj"  # which Linux allows
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
    assert window.files.open(path)
    window.panels.open(window.scene_panel)
    settle()
    assert window.controls.minimumSizeHint().width() <= 285
    assert window.menus.scene_box.currentText() == path.name.replace("\n", " ")
    areas = window.scene_panel.findChildren(QScrollArea)
    assert all(area.horizontalScrollBar().maximum() == 0 for area in areas)


def text_boxes(window: MainWindow) -> dict[str, tuple[float, float, float, float]]:
    """Left, bottom, right, top of the texts in the picture, in its pixels."""
    boxes = {}
    for renderer in window.panes["image"].canvas.render_window.GetRenderers():
        if not renderer.GetDraw():
            continue
        x, y = renderer.GetOrigin()
        for text, label in labels_of(renderer).items():
            left, right, low, high = label.box_px
            boxes[text] = x + left, y + low, x + right, y + high
    return boxes


def test_in_letters_for_a_class_no_text_in_a_picture_hides_another(window: MainWindow) -> None:
    present(window)
    assert window.isFullScreen()
    seen = 0
    for name in PHENOMENA:
        window.guide.choose(name)
        settle()
        assert window.controls.horizontalScrollBar().maximum() == 0, name
        assert window.controls.widget().width() <= window.controls.viewport().width(), name
        boxes = text_boxes(window)
        seen += len(boxes)
        for (one, a), (other, b) in itertools.combinations(boxes.items(), 2):
            apart = a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
            assert apart, (name, one, other)
    assert seen > 20


@pytest.mark.undrawn
def test_full_hd_at_a_screen_scale_of_two_holds_the_window_that_presents(
    window: MainWindow,
) -> None:
    window.look.set_presenting(True)
    for name in ("letter-f", *list(PHENOMENA)[::3]):
        window.guide.choose(name)
        settle()
        window.resize(960, 540)
        settle()
        assert (window.width(), window.height()) == (960, 540), name
    for panel in window.panels.all:
        window.panels.open(panel)
        settle()
        assert window.minimumSizeHint().width() <= 960


def share_of(window: MainWindow, colour: Any) -> float:
    """How much of the world pane has exactly this colour."""
    same = pixels(window, "world") == np.round(255 * np.array(colour))
    return float(same.all(axis=2).mean())


def test_the_sliders_of_near_and_far_have_their_planes_colours_from_the_start(
    window: MainWindow,
) -> None:
    for name, colour in (("near", LIGHT.near), ("far", LIGHT.far)):
        picture = window.controls.rows[name].slider.grab().toImage()
        row = (picture.pixelColor(x, picture.height() // 2) for x in range(picture.width()))
        assert colour in {each.name() for each in row}


@pytest.fixture
def make_widened(make_window: MakeWindow) -> MakeWindow:
    """Opens a window whose lines VTK's shader makes wide: where OpenGL has none, as on Wayland."""

    def made(**choices: Any) -> MainWindow:
        window = make_window(canvas="opengl", **choices)
        for pane in window.panes.values():
            pane.canvas.render_window.SetForceMaximumHardwareLineWidth(1.0)
        return window

    return made


def test_edges_that_run_far_behind_the_pane_are_lines(make_widened: MakeWindow) -> None:
    window = make_widened()
    for image_size in [(16384, 1), (4000, 100)]:
        start = window.store.document.projection
        window.store.set_projection(replace(start, image_size=image_size))
        QApplication.processEvents()
        shares = [share_of(window, rgb(colour)) for colour in (LIGHT.near, LIGHT.far)]
        assert sum(shares) > 0.001 and max(shares) < 0.008


@pytest.mark.smooth
def test_a_grid_that_runs_behind_the_pane_is_lines(
    make_widened: MakeWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = make_widened()
    lines_of_three_px = 1.5 * LIGHT.font_size / window.screen().size().height()
    monkeypatch.setattr(palette, "LABEL_SHARE", lines_of_three_px)
    window.look.set_presenting(True)
    window.slots.make_large("world")  # which has the whole window then
    QApplication.processEvents()
    hand = window.panes["world"].hand
    hand.camera.SetPosition(0.3, 0.4, 3.2)
    hand.camera.SetFocalPoint(0.0, 0.3, -3.0)
    hand.moved.emit()
    QApplication.processEvents()
    assert 0.001 < share_of(window, np.array(GRID_RGB) / 255.0) < 0.024, "0.027 with ribbons"


def test_lines_are_drawn_with_another_form_of_their_shader_declaration(
    make_widened: MakeWindow,
) -> None:
    """Another VTK may write it so; our insertion must compile there as well."""
    canvas = make_widened().panes["world"].canvas
    declared = "layout(lines) in;\nlayout(triangle_strip, max_vertices = 4) out;"
    other = "layout(lines) in;\nlayout(max_vertices = 4, triangle_strip) out;"
    pictures = []
    for text in (declared, other):  # each is compiled anew
        for renderer in canvas.render_window.GetRenderers():
            for actor in renderer.GetActors():
                actor.GetShaderProperty().AddGeometryShaderReplacement(declared, True, text, True)
        canvas.redraw()
        pictures.append(pixels_of(canvas))
    assert np.array_equal(*pictures)


@pytest.mark.undrawn
def test_a_cut_note_beside_a_panes_title_ends_in_an_ellipsis(window: MainWindow) -> None:
    note = window.panes["ndc"].note
    text = "u, v, n in world units, as the camera has them"
    note.setText(text)
    for width in (60, 150, 2000, 100):
        note.resize(width, note.height())
        shown = str(QLabel.text(note))
        assert note.fontMetrics().horizontalAdvance(shown) <= width
        assert (shown == text) == (width == 2000) and shown.endswith("…") == (width != 2000)
        assert note.text() == note.accessibleDescription() == text
        assert note.toolTip() == ("" if shown == text else text)
    font = QFont(note.font())
    font.setPointSizeF(2.0 * font.pointSizeF())
    note.setFont(font)
    assert note.fontMetrics().horizontalAdvance(QLabel.text(note)) <= 100
    note.setText("")
    assert QLabel.text(note) == ""


@pytest.mark.undrawn
def test_the_note_of_a_pane_is_cut_before_its_title(window: MainWindow) -> None:
    pane = window.panes["image"]
    title, note = pane.title, pane.note
    window.slots.toggle_float("image")
    for text in ("Image", "Canonical parallel"):
        pane.header.show_title(text, "1920 × 1080")
        whole = []
        for width in range(700, 190, -7):
            pane.resize(width, 200)
            settle()
            shown = str(QLabel.text(title))
            assert shown == text or (shown.endswith("…") and note.width() == 0)
            assert title.toolTip() == ("" if shown == text else text)
            assert title.fontMetrics().horizontalAdvance(shown) <= title.width() or shown == "…"
            whole.append((shown == text, QLabel.text(note) == note.text()))
        assert whole == sorted(whole, reverse=True), "first the note is cut, then the title"
        assert whole[0] == (True, True) and not all(each[1] for each in whole)
    window.look.set_presenting(True)
    settle()
    assert QLabel.text(title) == text or note.width() == 0
    window.look.set_presenting(False)


def test_both_panes_share_what_float64_has_projected(window: MainWindow) -> None:
    """It is gone when nobody draws with it any more."""

    def shared() -> set[Any]:
        one, other = (
            {
                actor.GetMapper().GetInput().GetPoints()
                for renderer in window.panes[name].canvas.render_window.GetRenderers()
                for actor in renderer.GetActors()
            }
            for name in ("ndc", "image")
        )
        return one & other

    own = shared()
    for step in range(3):  # faces and edges, at a field of view that float32 cannot draw
        window.store.set_projection(seen(window, lens=Perspective(1e-3 + 1e-5 * step, 1.0, 30.0)))
        assert {window.panes[name].drawing.precision for name in ("ndc", "image")} == {"float64"}  # type: ignore[union-attr]
        made = [weakref.ref(points) for points in shared() - own]
        assert len(made) == 2
    window.store.set_projection(seen(window, lens=Perspective(45.0, 1.0, 30.0)))
    assert [points() for points in made] == [None, None] and shared() == own


@pytest.mark.undrawn
def test_esc_puts_back_what_a_slider_has_dragged(window: MainWindow) -> None:
    for key in ["fov_x_deg", "far", "azimuth_deg"]:
        window.probe_panel.follow(point=(0.0, 0.0, 0.0))  # which Esc would remove otherwise
        before, could_undo = window.store.document, window.store.can_undo
        row = window.controls.rows[key]
        window.controls.sections["more_lens"].set_open(key == "fov_x_deg")
        settle()
        window.controls.ensureWidgetVisible(row)
        slider, text = row.slider, row.field.text()
        option = QStyleOptionSlider()
        slider.initStyleOption(option)
        complex_control, handle = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
        place = slider.style().subControlRect(complex_control, option, handle, slider).center()
        for is_abandoned in (True, False):
            QTest.mousePress(slider, LEFT, pos=place)
            QTest.mouseMove(slider, place + QPoint(15, 0))
            settle()
            assert window.store.document != before
            if is_abandoned:
                QTest.keyClick(slider, Qt.Key.Key_Escape)
                settle()
                assert window.store.document == before and not window.store.in_gesture
                assert (row.field.text(), window.store.can_undo) == (text, could_undo)
                assert len(window.probe_panel.probes) == 1
                QTest.mouseMove(slider, place + QPoint(30, 0))  # the hand has let go of it
            QTest.mouseRelease(slider, LEFT, pos=place + QPoint(30, 0))
            settle()
            assert (window.store.document == before) == is_abandoned
        assert window.store.can_undo
        window.store.undo()


_EDGES = """
import os, sys
from PySide6.QtCore import QPoint
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from widgets.program.opengl import prepare
prepare()
app = QApplication([])
from app.document.document import Document
from app.scenes.scene import load
from widgets.window.main_window import MainWindow
from widgets.window.settings import Settings
document = Document("letter-f", load("letter-f").start)
window = MainWindow(document, settings=Settings(None), software_rendering=True)
window.resize(1000, 600)
window.show()
assert QTest.qWaitForWindowExposed(window, int(sys.argv[1]))
for change in (None, lambda: window.slots.setSizes([301, 302, 303]),
               lambda: window.messages.show_message("Something."),
               lambda: window.slots.toggle_float("ndc"),
               lambda: window.slots.toggle_float("ndc")):
    if change is not None:
        change()
    QTest.qWait(1)
    for pane in window.panes.values():
        canvas = pane.canvas
        place = canvas.mapTo(canvas.window(), QPoint())
        ends = place + QPoint(canvas.width(), canvas.height())
        print(*(end * window.devicePixelRatioF() for end in (*place.toTuple(), *ends.toTuple())))
print("done", flush=True)
os._exit(0)
"""


def test_a_canvas_ends_on_whole_pixels_at_a_broken_scale(display: Any) -> None:
    done = subprocess.run(
        [sys.executable, "-c", _EDGES, str(PATIENCE_MS)], cwd=ROOT,
        env={**os.environ, "QT_SCALE_FACTOR": "1.75"},
        capture_output=True, text=True, timeout=PATIENCE_S, check=False,
    )  # fmt: skip
    *edges, last = done.stdout.splitlines() or [""]
    assert last == "done" and len(edges) == 15, done
    for line in edges:
        for edge in map(float, line.split()):
            assert edge == pytest.approx(round(edge), abs=1e-6), edges
