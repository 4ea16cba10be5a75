"""u, v and n step by step: the panel, the drawing, and up near the view direction."""

import math
import re
from dataclasses import replace
from itertools import pairwise
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.drawings.frame import arrow_tips
from app.drawings.style import LIGHT, rgb
from app.lecture.camera_frame import STEPS, turned_up, up_and_view
from app.lecture.typed_matrix import with_cell
from app.model.formula import ARROW
from app.model.projection import Camera, Perspective
from app.model.refusal import Refusal, format_value
from app.scenes.scene import load
from tests.support.digits import all_digits_shown, plain
from tests.support.layout import cut, place, scrolled_by
from tests.support.window import (
    Highlighted,
    MakeWindow,
    activate,
    click,
    counted_repaints,
    enter,
    pixels,
    present,
    settle,
)
from widgets.panels.frame_panel import FramePanel
from widgets.window.main_window import MainWindow

START = load("letter-f").start
START_ORIGIN = load("letter-f").origin


@pytest.fixture
def window(window: MainWindow) -> MainWindow:
    """With the panel open."""
    activate(window)
    window.panels.open(window.frame_panel)
    settle()
    return window


def numbers(panel: FramePanel) -> str:
    """The numbers as a screen reader reads them."""
    return panel.numbers.text()


def copied(panel: FramePanel) -> str:
    QApplication.clipboard().clear()
    QTest.keyClick(panel.numbers, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    return QApplication.clipboard().text()


# -- the numbers

directions = st.tuples(*[st.floats(-10.0, 10.0).map(lambda x: round(x, 3))] * 3)


@given(eye=directions, up=directions)
def test_up_and_view_agree_with_80_digits(eye: Any, up: Any) -> None:
    try:
        camera = Camera(eye, (0.0, 0.0, 0.0), up)
    except Refusal:
        return
    with mpmath.workdps(80):
        e, w = mpmath.matrix(eye), mpmath.matrix(up)
        n = e / mpmath.norm(e)
        cross = [w[1] * n[2] - w[2] * n[1], w[2] * n[0] - w[0] * n[2], w[0] * n[1] - w[1] * n[0]]
        length, up_length = mpmath.norm(cross), mpmath.norm(w)
        cosine = -(w.T * n)[0]
        angle = float(mpmath.degrees(mpmath.atan2(length, cosine)))
        magnified = float(up_length / length)
    found = up_and_view(camera)
    assert found.angle_deg == pytest.approx(angle, rel=1e-14, abs=1e-300)
    assert found.length == pytest.approx(float(length), rel=1e-15)
    assert found.magnified == pytest.approx(magnified, rel=1e-14)
    assert found.cross == pytest.approx([float(part) for part in cross], rel=1e-14, abs=1e-30)


@pytest.mark.parametrize("angle_deg", [178.0, 45.0, 1e-3, 1e-9])
def test_turned_up_has_the_angle_and_keeps_the_frame(angle_deg: float) -> None:
    camera = turned_up(START.camera, angle_deg)
    error = 4e-16 / math.sin(math.radians(angle_deg))
    found = up_and_view(camera)
    assert found.angle_deg == pytest.approx(angle_deg, rel=max(1e-14, 4 * error))
    assert np.abs(camera.frame - START.camera.frame).max() <= max(1e-15, 2 * error)


def test_up_on_the_view_direction_is_refused_by_the_model() -> None:
    random = np.random.default_rng(5)
    cameras = [Camera(tuple(random.normal(size=3) * 10.0 ** random.uniform(-3, 6)),
                      tuple(random.normal(size=3))) for _ in range(100)]  # fmt: skip
    for camera in (START.camera, *cameras):
        for angle_deg in (0.0, 1e-14, 180.0):
            with pytest.raises(Refusal, match="up"):
                turned_up(camera, angle_deg)
    assert up_and_view(turned_up(START.camera, 1e-12)).angle_deg == pytest.approx(1e-12, rel=1e-2)


def test_the_arrows_are_the_vectors() -> None:
    camera = START.camera
    for step in range(len(STEPS)):
        tips = arrow_tips(step, camera)
        assert set(tips) == {"look", "up", "n", "u", "v"} & set(STEPS[: step + 1])
        for name, vector in (
            ("u", camera.frame[0]), ("v", camera.frame[1]), ("n", camera.frame[2]),
            ("up", np.array(camera.up)), ("look", np.subtract(camera.target, camera.eye)),
        ):  # fmt: skip
            if name in tips:
                tip = np.array(tips[name]) @ camera.frame
                along = tip @ vector / np.linalg.norm(tip) / np.linalg.norm(vector)
                assert along == pytest.approx(1.0, abs=1e-14)


# -- the panel


@pytest.mark.undrawn
def test_steps_by_its_buttons(window: MainWindow) -> None:
    panel = window.frame_panel
    assert panel.step == 0 and not panel.back.isEnabled()
    titles = [panel.title.text()]
    for _ in range(len(STEPS) - 1):
        click(panel.next)
        titles.append(panel.title.text())
    assert len(set(titles)) == 7 and titles[0].startswith("1 ") and titles[-1].startswith("7 ")
    assert not panel.next.isEnabled() and not panel.all.isEnabled()
    click(panel.back)
    assert panel.step == 5
    panel.go_to(0)
    click(panel.all)
    assert panel.step == 6


@pytest.mark.undrawn
def test_playing_goes_through_all_steps_and_stops(window: MainWindow, qtbot: Any) -> None:
    panel = window.frame_panel
    timer = panel.findChild(QTimer)
    timer.setInterval(1)
    seen: list[int] = []
    panel.step_changed.connect(seen.append)
    click(panel.play)
    qtbot.waitUntil(lambda: panel.step == 6 and not panel.playing)
    assert seen == [1, 2, 3, 4, 5, 6]
    timer.setInterval(100_000)
    click(panel.play)  # from the beginning
    assert panel.playing and panel.step == 0
    click(panel.next)
    assert not panel.playing and panel.step == 1
    click(panel.play)
    window.panels.open(None)
    assert not panel.playing


@pytest.mark.undrawn
def test_the_numbers_are_the_models(window: MainWindow) -> None:
    camera = Camera((0.1, -3.0, 1e6), (1 / 3, 0.0, 0.0), (1.0, 2.0, 0.5))
    window.store.set_projection(replace(window.store.document.projection, camera=camera))
    panel = window.frame_panel
    projection = window.store.document.projection
    expected = {
        "eye": camera.eye, "up": camera.up, "n": camera.frame[2], "u": camera.frame[0],
        "v": camera.frame[1], "look": -camera.frame[2],
    }  # fmt: skip
    for step, name in enumerate(STEPS[:-1]):
        panel.go_to(step)
        last = copied(panel).splitlines()[-1]
        written = "(" + ", ".join(format_value(x + 0.0) for x in expected[name]) + ")"
        assert last.endswith(f"= {written}"), name
    panel.go_to(3)
    assert f"|e − target| = {format_value(camera.distance)}" in copied(panel)
    panel.go_to(6)
    (stage,) = (stage for stage in projection.stages if stage.name == "view_from_world")
    cells = [format_value(value + 0.0) for value in stage.matrix.reshape(-1).tolist()]
    assert copied(panel).split() == cells


@pytest.mark.undrawn
def test_four_digits_are_read_and_all_by_the_switch(window: MainWindow) -> None:
    camera = Camera((0.1, -3.0, 7.0), (1 / 3, 0.0, 0.0), (1.0, 2.0, 0.5))
    window.store.set_projection(replace(window.store.document.projection, camera=camera))
    panel = window.frame_panel
    for step in range(len(STEPS)):
        panel.go_to(step)
        few, whole = numbers(panel), copied(panel)
        found = [re.findall(r"(?<![a-z])[-−]?\d[\d.e-]*", text) for text in (few, whole)]
        assert [plain(text) for text in found[0]] == [f"{float(text):.4g}" for text in found[1]]
        said = panel.figures.text()
        with all_digits_shown():
            assert numbers(panel) == whole == copied(panel)
            assert panel.figures.text() != said
        assert numbers(panel) == few and panel.figures.text() == said
    assert few != whole


@pytest.mark.undrawn
def test_folded_it_computes_nothing_and_opens_with_the_present_camera(
    make_window: MakeWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    window = make_window()
    settle()
    asked: list[Camera] = []
    real = up_and_view

    def ask(camera: Camera) -> Any:
        asked.append(camera)
        return real(camera)

    monkeypatch.setattr("widgets.panels.frame_panel.up_and_view", ask)
    camera = Camera((1.0, 2.0, 3.0))
    window.store.set_projection(replace(window.store.document.projection, camera=camera))
    settle()
    assert asked == []
    window.panels.open(window.frame_panel)
    settle()
    assert set(asked) == {camera} and numbers(window.frame_panel) == "e = (1, 2, 3)"
    asked.clear()
    lens = Perspective(50.0, 1.0, 30.0)
    window.store.set_projection(replace(window.store.document.projection, lens=lens))
    assert asked == []  # another lens is the same camera


@pytest.mark.undrawn
def test_a_row_turns_up_and_undo_brings_it_back(window: MainWindow) -> None:
    panel, before = window.frame_panel, window.store.document.projection
    window.controls.sections["more_camera"].set_open(True)
    panel.angle.field.setFocus()
    panel.angle.field.selectAll()
    QTest.keyClicks(panel.angle.field, "0.5")
    QTest.keyClick(panel.angle.field, Qt.Key.Key_Return)
    camera = window.store.document.projection.camera
    assert up_and_view(camera).angle_deg == pytest.approx(0.5, rel=1e-12)
    assert panel.angle.value() == 0.5
    assert "0.5°" in panel.warning.text() and "114.6 times" in panel.figures.text()
    assert window.controls.rows["up_y"].value() == pytest.approx(camera.up[1])
    window.store.undo()
    settle()
    assert window.store.document.projection == before
    assert panel.warning.text() == "" and panel.angle.value() == pytest.approx(103.7014, rel=1e-5)
    enter(panel.angle.field, "0")
    assert "must not be parallel to the view direction" in panel.angle.error


@pytest.mark.undrawn
def test_the_warning_comes_at_one_degree(window: MainWindow) -> None:
    panel = window.frame_panel
    for angle_deg, warned in ((1.01, False), (0.99, True), (179.5, True), (178.5, False)):
        window.store.set_projection(replace(START, camera=turned_up(START.camera, angle_deg)))
        assert bool(panel.warning.text()) is warned, angle_deg
    for angle_deg, turned in ((0.12, "56.44"), (179.9, "90"), (0.1, "90"), (0.05, "180")):
        window.store.set_projection(replace(START, camera=turned_up(START.camera, angle_deg)))
        assert panel.warning.text().endswith(f"by up to {turned}°.")


@pytest.mark.undrawn
def test_under_a_typed_view_matrix_the_panel_says_whose_frame_it_shows(window: MainWindow) -> None:
    panel, start = window.frame_panel, window.store.document.projection
    window.store.set_projection(with_cell(start, "clip_from_view", 3, 0, 0.1))
    assert panel.nudge.isEnabled() and not panel.warning.text()  # the camera is still there
    window.store.set_projection(with_cell(start, "view_from_world", 0, 1, 0.5))
    assert not panel.nudge.isEnabled() and not panel.angle.isEnabled()
    assert "No camera has the typed view matrix" in panel.warning.text()
    window.store.undo()
    assert panel.nudge.isEnabled() and panel.angle.isEnabled() and not panel.warning.text()


@pytest.mark.undrawn
def test_a_nudge_turns_the_picture_by_the_announced_angle(window: MainWindow) -> None:
    window.store.set_projection(replace(START, camera=turned_up(START.camera, 1.0)))
    before = window.store.document.projection.camera
    click(window.frame_panel.nudge)
    after = window.store.document.projection.camera
    turn_deg = math.degrees(math.acos(float(before.frame[0] @ after.frame[0])))
    assert turn_deg == pytest.approx(math.degrees(math.atan(0.1 / 1.0)), rel=0.02)
    window.store.undo()
    assert window.store.document.projection.camera == before


# -- the world pane


def test_each_step_is_seen_and_all_comes_back(make_window: MakeWindow) -> None:
    window = make_window()
    settle()
    before = {name: pixels(window, name) for name in window.panes}
    window.panels.open(window.frame_panel)
    settle()
    seen = [pixels(window)]
    for _ in STEPS[1:]:
        click(window.frame_panel.next)
        seen.append(pixels(window))
    for one, other in pairwise(seen):
        assert not np.array_equal(one, other)
    window.panels.open(None)
    window.slots.go_back()
    settle()
    for name, picture in before.items():
        assert np.array_equal(pixels(window, name), picture), name


def test_one_step_is_one_repaint_of_the_world_and_idle_is_none(window: MainWindow) -> None:
    with counted_repaints(window) as counts:
        window.frame_panel.go_to(1)
        settle()
        settle()
        assert counts == {"world": 1, "ndc": 0, "image": 0}
        window.frame_panel.go_to(1)
        settle()
        assert counts == {"world": 1, "ndc": 0, "image": 0}
        window.store.set_projection(replace(START, camera=Camera((1.0, 2.0, 3.0))))
        settle()
        assert counts == {"world": 2, "ndc": 1, "image": 1}


@pytest.mark.undrawn
def test_figures_show_the_step_while_its_panel_is_open(make_window: MakeWindow) -> None:
    window = make_window()
    settle()
    window.pictures.copy()
    settle()
    before = QApplication.clipboard().image()
    window.panels.open(window.frame_panel)
    window.frame_panel.go_to(6)
    settle()
    window.pictures.copy()
    assert QApplication.clipboard().image() != before
    window.panels.open(None)
    settle()
    window.pictures.copy()
    assert QApplication.clipboard().image() == before and not before.isNull()


@pytest.mark.undrawn
def test_the_formula_is_linked(window: MainWindow) -> None:
    panel, highlighted = window.frame_panel, Highlighted(window)
    panel.go_to(3)
    settle()
    place = panel.formula.mapTo(window, panel.formula.rect().center())
    QTest.mouseMove(window.windowHandle(), place)
    settle()
    assert highlighted.now == {"n"} and panel.formula.is_marked
    QTest.mouseMove(window.windowHandle(), QPoint(window.width() - 4, 2))
    settle()
    assert highlighted.now == frozenset() and not panel.formula.is_marked
    window.highlighter.mark("test", frozenset(("n",)))
    assert panel.formula.is_marked
    panel.go_to(4)
    assert not panel.formula.is_marked


def test_the_row_and_the_arrow_of_up_are_linked(window: MainWindow) -> None:
    window.frame_panel.go_to(2)
    settle()
    row, before, highlighted = window.frame_panel.angle, pixels(window), Highlighted(window)
    QTest.mouseMove(window.windowHandle(), row.mapTo(window, row.rect().center()))
    settle()
    assert highlighted.now == {"up"} and row.is_marked
    assert not np.array_equal(pixels(window), before)  # its arrow and its word
    QTest.mouseMove(window.windowHandle(), QPoint(window.width() - 4, 2))
    settle()
    assert np.array_equal(pixels(window), before)
    drawing: Any = window.panes["world"].drawing
    camera = window.store.document.projection.camera
    up = np.array(camera.up)  # of length 1
    ((x_px, y_px),) = drawing.sight.seen([camera.eye + 1.5 * drawing.camera.axes_size * up])
    canvas = window.panes["world"].canvas
    place = canvas.mapTo(window, QPoint(math.floor(x_px), math.floor(y_px)))
    QTest.mouseMove(window.windowHandle(), place)
    settle()
    assert highlighted.now == {"up"} and row.is_marked


@pytest.mark.undrawn
def test_the_view_matrix_s_formula_is_the_lecture_s(window: MainWindow) -> None:
    """Lecture 004: R^T has u, v, n as columns; R is (u, v, n)^T, with them as rows."""
    panel = window.frame_panel
    for step in range(len(STEPS)):
        panel.go_to(step)
        assert panel.formula.text().startswith(
            ("e", "look = target", "up", "n = (e − target)/|", "u = up", "v = n", "M = R T")
        )
        assert ARROW in panel.formula.formula
    assert f"R = (u{ARROW}, v{ARROW}, n{ARROW})^T" in panel.formula.formula
    rotation = START.view_rotation[:3, :3]
    np.testing.assert_array_equal(rotation, np.column_stack(START.camera.frame).T)


def test_l1_the_frame_is_seen_in_large_and_nothing_covers_the_look_arrow(
    window: MainWindow,
) -> None:
    """The axes are large and completely in the pane; the view returns when the panel is folded."""
    drawing: Any = window.panes["world"].drawing
    window.panels.open(window.matrices)
    settle()
    before = drawing.own.pane.eye.tolist()
    window.panels.open(window.frame_panel)
    window.frame_panel.go_to(len(STEPS) - 1)
    settle()
    array = pixels(window)
    height, width, _ = array.shape
    names, directions = drawing.camera.arrows
    eye = np.array([window.store.document.projection.camera.eye]) - START_ORIGIN
    spots = drawing.own.pane.seen(np.vstack([eye, eye + directions]))
    places = np.array([(x, height - y) for x, y, _ in spots])
    assert set(names) == {"look", "up", "n", "u", "v"}
    assert (places > 0).all() and (places < (width, height)).all()
    lengths = dict(zip(names, np.hypot(*(places[1:] - places[0]).T), strict=True))
    assert max(lengths.values()) > 0.25 * min(width, height), lengths
    # The arrow's own colour all along it, but where eye and label stand at its ends.
    look = places[1 + names.index("look")]
    own = np.round(255 * np.array(rgb(LIGHT.target)))
    for share in np.linspace(0.3, 0.7, 9):
        x, y = np.round(places[0] + share * (look - places[0])).astype(int)
        around = array[y - 2 : y + 3, x - 2 : x + 3].reshape(-1, 3).astype(float)
        assert (np.abs(around - own).max(axis=1) <= 24).any(), share
    assert not {handle.name for handle, _ in drawing.handles.shown} & {"near", "far"}
    window.panels.open(window.matrices)
    settle()
    assert drawing.own.pane.eye.tolist() == pytest.approx(before)
    assert {"near", "far"} <= {handle.name for handle, _ in drawing.handles.shown}


@pytest.mark.undrawn
def test_l1_lecture_004_names_the_vectors_before_division(window: MainWindow) -> None:
    """N = T0 - T1, n = N/|N|; U = V x n, u = U/|U|: its matrix of the view."""
    panel, letters = window.frame_panel, window.matrices.letters
    window.panels.open(panel)
    letters.setCurrentIndex(letters.findData("004"))
    found = []
    for step in ("n", "u", "v"):
        panel.go_to(STEPS.index(step))
        found.append(panel.formula.text())
    assert found == ["N = T\u2080 − T\u2081,   n = N/|N|", "U = V × n,   u = U/|U|", "v = n × u"]
    panel.go_to(STEPS.index("n"))  # the eye and the target are points
    assert panel.formula.formula.startswith(f"N{ARROW} = T\u2080 − T\u2081,")
    assert f"|N{ARROW}|" in panel.numbers.formula
    letters.setCurrentIndex(letters.findData("own"))
    panel.go_to(STEPS.index("u"))
    assert panel.formula.text() == "u = up × n/|up × n|"


@pytest.mark.undrawn
def test_the_part_about_up_is_fully_visible_while_presenting(window: MainWindow) -> None:
    present(window)
    window.panels.open(window.frame_panel)
    settle()
    panel = window.frame_panel
    assert cut(window) == []
    for widget in (panel.figures, panel.nudge, panel.angle):
        area = scrolled_by(widget)
        assert area is not None
        seen = place(widget, area.viewport())
        assert seen.left() >= 0 and seen.right() < area.viewport().width()
