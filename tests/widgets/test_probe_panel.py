"""Probes: clicked in any pane, marked in all of them, and their numbers those of `project`."""

import itertools
import json
import math
import threading
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton, QToolButton
from pytestqt.qtbot import QtBot

from app.commands import cli
from app.document.document import Document
from app.document.files import write
from app.document.view import MOST_PROBES
from app.drawings import probes
from app.drawings.style import LIGHT, rgb
from app.lecture.letters import stacked
from app.lecture.notation import matrices
from app.model.chain import Chain
from app.model.formula_text import OVER
from app.model.projection import Camera, FreeMatrix, Oblique, Perspective, Projection
from app.model.refusal import format_value
from app.picking.picking import PickSurface, Probe
from app.scenes.scene import load
from tests import PATIENCE_MS
from tests.support.digits import all_digits_shown, plain
from tests.support.shown import show
from tests.support.window import MakeWindow, activate, click, move_mouse, pixels, settle
from widgets.panels.probe_panel import ProbePanel
from widgets.panels.probe_table import FORMULA
from widgets.parts.panel import Readable
from widgets.parts.typeset import typeset
from widgets.window.drawer import REST_MS
from widgets.window.main_window import MainWindow

CORNER = (1.5, 5.0, 0.5)
"""A corner of the letter F that is visible in all three panes at the start."""
ACCENT = np.round(255 * np.array(rgb(LIGHT.accent)))


def start() -> Projection:
    return load("letter-f").start


def marked(window: MainWindow, name: str, place_px: Any) -> bool:
    """Whether the probe's colour is on the screen around a place of a pane's canvas."""
    array = pixels(window, name)
    x, y = (round(part) for part in place_px)
    near = array[max(0, y - 2) : y + 3, max(0, x - 2) : x + 3].reshape(-1, 3).astype(float)
    return len(near) > 0 and bool((np.abs(near - ACCENT).max(axis=1) <= 12).any())


def any_mark(window: MainWindow, name: str) -> bool:
    array = pixels(window, name).astype(float)
    return int((np.abs(array - ACCENT).max(axis=2) <= 3).sum()) > 20


def place_in(window: MainWindow, name: str, point: Any) -> tuple[float, float]:
    """The pixel of a world point by VTK's own camera, from the pane's top left."""
    pane, projection = window.panes[name], window.store.document.projection
    drawing: Any = pane.drawing
    if name == "image":
        left, top, width, height = drawing.picture_rectangle_px
        image_width, image_height = projection.image_size
        x, y = projection.trace(point).image
        return left + x * width / image_width, top + y * height / image_height
    shown = np.array(point) - load("letter-f").origin
    if name == "ndc":  # OpenGL's cube with z mirrored for display, half as deep for [0, 1]
        z_near, z_far = projection.depth_range
        ndc = replace(projection, depth="opengl").trace(point).ndc
        shown = ndc * (1.0, 1.0, -abs(z_far - z_near) / 2.0)
    renderer = pane.canvas.renderer
    renderer.SetWorldPoint(*shown, 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    return x, pane.canvas.render_window.GetSize()[1] - y


def cells(panel: ProbePanel, block: int, row: int) -> list[str]:
    """The texts of a line of a probe."""
    model = panel.table.model()
    texts = [model.data(model.index(row, 1 + 4 * block + part)) for part in range(4)]
    return [text for text in texts if text]


def copied(panel: ProbePanel) -> list[list[str]]:
    """The whole table as it is copied: the formula of each line, and its numbers."""
    QGuiApplication.clipboard().clear()
    panel.table.selectAll()
    QTest.keyClick(panel.table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    return [line.split("\t") for line in QGuiApplication.clipboard().text().split("\n")]


# -- clicks


def test_a_click_on_a_vertex_in_any_pane_marks_it_in_all(window: MainWindow) -> None:
    for name, pane in window.panes.items():
        window.probe_panel.clear()
        click(pane.canvas, place_in(window, name, CORNER))
        (probe,) = window.probe_panel.probes
        assert probe.point == pytest.approx(CORNER, abs=1e-5 * load("letter-f").size), name
        for other in window.panes:
            assert marked(window, other, place_in(window, other, CORNER)), (name, other)


def test_a_double_click_resets_the_view_and_follows_nothing(window: MainWindow) -> None:
    canvas = window.panes["world"].canvas
    place = place_in(window, "world", CORNER)
    pos = QPoint(math.floor(place[0]), math.floor(place[1]))

    def double_click() -> None:
        QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=pos)
        assert window.probe_panel.probes
        QTest.mouseDClick(canvas, Qt.MouseButton.LeftButton, pos=pos)
        QApplication.processEvents()

    double_click()
    assert window.probe_panel.probes == () and window.probe_panel.chosen is None
    window.probe_panel.follow(point=(0.0, 0.0, 0.0))
    before = window.probe_panel.probes
    double_click()
    assert window.probe_panel.probes == before and window.probe_panel.chosen == before[0]


Point = tuple[float, float, float]


def test_a_click_follows_the_point_of_a_face_and_the_nearest_of_a_line(window: MainWindow) -> None:
    def clicked(name: str, place: Point) -> tuple[Point, tuple[float, float]]:
        """Which point is followed then, and where in the pane the click was."""
        x, y = (math.floor(part) + 0.5 for part in place_in(window, name, place))
        window.probe_panel.clear()
        click(window.panes[name].canvas, (x, y))
        (probe,) = window.probe_panel.probes
        assert probe.point is not None
        return probe.point, (x, y)

    for name in ("world", "ndc", "image"):
        window.slots.go_back()
        # The cubes are small, and no vertex may be within 6 pixels.
        window.slots.arrange("pictures", name, name)
        settle()
        point, place = clicked(name, (0.0, 2.5, 0.5))
        assert point[2] == pytest.approx(0.5, abs=1e-6)
        assert place_in(window, name, point) == pytest.approx(place, abs=0.5)
        point, place = clicked(name, (2.0, 0.0, 1.4))
        assert point == pytest.approx((2.0, 0.0, 1.4), abs=0.1)
        assert min(abs(point[0] - 2.0), abs(point[2] - 1.0)) <= 1e-12
        assert math.dist(place_in(window, name, point), place) <= 1.0


def test_picking_is_prepared_in_a_thread_when_the_scene_is_opened(
    make_window: MakeWindow, monkeypatch: pytest.MonkeyPatch, qtbot: QtBot
) -> None:
    made: list[str] = []

    class Counted(PickSurface):
        def __init__(self, *arguments: Any) -> None:
            made.append(threading.current_thread().name)
            super().__init__(*arguments)

    monkeypatch.setattr(probes, "PickSurface", Counted)
    window = make_window()
    click(window.panes["world"].canvas, place_in(window, "world", CORNER))
    click(window.panes["image"].canvas, place_in(window, "image", CORNER))
    assert window.probe_panel.probes and len(made) == 1
    assert made[0] != threading.main_thread().name
    monkeypatch.setattr("widgets.window.look.SORTED_AHEAD", 0)  # as for a large mesh
    window.files.choose_scene("cube")
    qtbot.waitUntil(lambda: len(made) == 2)  # before any click


def in_gesture(panel: ProbePanel) -> bool:
    """Whether the panel is in a gesture."""
    return bool(panel.findChild(Readable).in_gesture)


def test_a_mark_is_dragged_in_the_image_in_its_plane_or_along_its_ray(window: MainWindow) -> None:
    window.probe_panel.follow(point=CORNER)
    window.probe_panel.pin.click()
    window.probe_panel.follow(point=(0.0, 0.5, 0.5))
    canvas = window.panes["image"].canvas
    before, held = start().trace(CORNER), []

    def drag(place: tuple[float, float], right: int, down: int, key: Any) -> Any:
        x, y = (math.floor(part) for part in place)
        QTest.mousePress(canvas, Qt.MouseButton.LeftButton, key, pos=QPoint(x, y))
        for part in (1, 2):
            to = QPoint(x + right * part // 2, y + down * part // 2)
            move_mouse(canvas, to, key=key)
        held.append(in_gesture(window.probe_panel))
        end = QPoint(x + right, y + down)
        QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, key, pos=end)
        return window.probe_panel.probes[0].point

    none, shift = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
    moved = start().trace(drag(place_in(window, "image", CORNER), 20, 12, none))
    scale = 1280 / window.panes["image"].drawing.picture_rectangle_px.width  # type: ignore
    assert moved.image - before.image == pytest.approx([20 * scale, 12 * scale], rel=0.02)
    assert moved.view[2] == pytest.approx(before.view[2], rel=1e-12)
    place = place_in(window, "image", window.probe_panel.probes[0].point)
    farther = start().trace(drag(place, 0, -20, shift))
    assert farther.image == pytest.approx(moved.image, abs=1e-9)
    assert farther.view[2] < 1.1 * moved.view[2]
    drag((3.0, 3.0), 20, 20, none)  # it starts on no mark, and beside the picture
    assert start().trace(window.probe_panel.probes[0].point).view == pytest.approx(farther.view)
    assert window.probe_panel.probes[1].point == (0.0, 0.5, 0.5)
    assert held == [True, True, False] and not in_gesture(window.probe_panel)
    assert not window.store.modified


@pytest.mark.parametrize("focus", ["field", "canvas"])
def test_escape_puts_a_dragged_probe_back_and_ends_the_drag(
    window: MainWindow, qtbot: QtBot, focus: str
) -> None:
    activate(window)
    panel, canvas = window.probe_panel, window.panes["image"].canvas
    window.panels.open(panel)
    panel.follow(point=CORNER)
    panel.pin.click()
    {"field": panel.fields[0], "canvas": canvas}[focus].setFocus()
    x, y = (math.floor(part) for part in place_in(window, "image", CORNER))

    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x, y))
    move_mouse(canvas, QPoint(x + 20, y + 20))
    assert panel.probes[0].point != CORNER
    for _ in range(2):  # until the hand lets go, it is not "remove the probe" either
        QTest.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_Escape)
        assert panel.probes == (Probe(1, CORNER),) and panel.pin.isChecked()
        move_mouse(canvas, QPoint(x + 24, y + 24))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x + 24, y + 24))
    assert panel.probes == (Probe(1, CORNER),) and not in_gesture(panel)
    QTest.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_Escape)
    assert panel.probes == ()


def test_a_dragged_probe_does_not_return_after_another_scene(window: MainWindow) -> None:
    panel, canvas = window.probe_panel, window.panes["image"].canvas
    hand = window.panes["image"].hand
    panel.follow(point=CORNER)
    x, y = (math.floor(part) for part in place_in(window, "image", CORNER))
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x, y))
    hand.drag_started.emit(QPointF(x, y))
    window.files.choose_scene("cube")
    hand.dragged.emit(QPointF(20.0, 20.0), False)
    assert panel.probes == ()
    hand.drag_ended.emit()
    assert not in_gesture(panel)


def test_a_click_with_a_small_movement_is_still_a_click(window: MainWindow) -> None:
    canvas = window.panes["world"].canvas
    x, y = (math.floor(part) for part in place_in(window, "world", CORNER))
    camera = window.panes["world"].hand.camera
    position = camera.GetPosition()
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x, y))
    QTest.mouseMove(canvas, QPoint(x + 2, y + 1))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=QPoint(x + 2, y + 1))
    assert len(window.probe_panel.probes) == 1
    assert camera.GetPosition() == position


def test_a_click_on_empty_image_space_shows_the_ray(window: MainWindow) -> None:
    drawing: Any = window.panes["image"].drawing
    left, top, width, height = drawing.picture_rectangle_px
    place = left + width // 10, top + height // 8
    click(window.panes["image"].canvas, place)
    (probe,) = window.probe_panel.probes
    assert probe.point is None and probe.pixel is not None
    x, y = (place[0] + 0.5 - left) / width * 1280, (place[1] + 0.5 - top) / height * 720
    assert probe.pixel == pytest.approx((x, y))
    assert marked(window, "image", place)
    on_near = start().world_from_image((x, y, 0.0))
    assert marked(window, "world", place_in(window, "world", on_near))
    # The line itself, between the planes and at one place of the cube.
    between = start().world_from_image((x, y, 0.3))
    assert marked(window, "world", place_in(window, "world", between))
    assert marked(window, "ndc", place_in(window, "ndc", between))


def test_a_ray_without_a_frustum_is_drawn_or_refused_with_a_reason(window: MainWindow) -> None:
    for last, words, is_drawn in [
        ((0.1, 0.0, -1.0, 0.3), "the pixel's ray, as far as it is in front of the eye", True),
        ((0.0, 0.0, -1.0, 2.2 / 1.1), "no ray in the world: the matrix has no inverse", False),
        ((-0.1, 0.0, 1.0, -0.3), "no ray in the world: all of it is behind the eye", False),
    ]:
        rows = ((1.2, 0.1, 0.3, 0.0), (0.0, 1.5, 0.1, 0.2), (0.0, 0.0, -1.1, -2.2))
        if not is_drawn and last[0] == 0.0:
            rows = (*rows[:2], (0.0, 0.0, -1.1, 2.2))  # 1.1 times the last
        matrix: Any = FreeMatrix((*rows, last))  # type: ignore[arg-type]
        window.store.set_projection(replace(start(), lens=matrix))
        assert window.store.document.projection.frustum_sign == 0
        window.panels.open(window.probe_panel)
        window.probe_panel.follow(pixel=(1200.0, 30.0))
        QApplication.processEvents()
        assert cells(window.probe_panel, 0, 0) == [words]
        assert any_mark(window, "world") == is_drawn


def test_the_inside_of_a_free_matrix_is_described_without_planes(panel: ProbePanel) -> None:
    panel.follow(point=CORNER)
    for depth, formula in (("opengl", "−w ≤ z ≤ w"), ("reversed", "0 ≤ z ≤ w")):
        cells_free = start().clip_from_view + np.diag([0.0, 0.0, 0.0, 0.1])
        projection = replace(start(), lens=FreeMatrix(cells_free.tolist()), depth=depth)  # type: ignore[arg-type]
        show(panel, projection)
        assert copied(panel)[-1][0] == f"|x|, |y| ≤ w;  {formula}"


def test_a_click_beside_the_picture_or_beside_the_scene_does_nothing(window: MainWindow) -> None:
    click(window.panes["image"].canvas, (3, 3))
    click(window.panes["world"].canvas, (3, 3))
    click(window.panes["ndc"].canvas, (3, 3))
    assert window.probe_panel.probes == ()


# -- marks


def test_marks_follow_every_change_of_the_model(window: MainWindow) -> None:
    window.probe_panel.follow(point=CORNER)
    for changes in (
        {"camera": Camera((-5.0, 4.0, 8.0), (0.0, 2.2, 0.0))},
        {"lens": Oblique(-6.0, 6.0, -4.0, 4.0, 5.0, 30.0, alpha_deg=60.0, beta_deg=60.0)},
        {"image_size": (600, 720)},
        {"depth": "reversed"},
    ):
        window.store.set_projection(replace(window.store.document.projection, **changes))
        QApplication.processEvents()
        for name in window.panes:
            assert marked(window, name, place_in(window, name, CORNER)), (name, changes)


def test_the_projector_runs_from_the_eye_and_along_z(window: MainWindow) -> None:
    window.probe_panel.follow(point=CORNER)
    QApplication.processEvents()
    eye = np.array(start().camera.eye)
    # A label may hide some of it.
    parts = [eye + part * (np.array(CORNER) - eye) for part in np.linspace(0.15, 0.95, 17)]
    assert sum(marked(window, "world", place_in(window, "world", part)) for part in parts) >= 9
    x, y, _ = start().trace(CORNER).ndc
    renderer = window.panes["ndc"].canvas.renderer
    renderer.SetWorldPoint(x, y, 0.9, 1.0)  # displayed: near the front
    renderer.WorldToDisplay()
    place_x, place_y, _ = renderer.GetDisplayPoint()
    height = window.panes["ndc"].canvas.render_window.GetSize()[1]
    assert marked(window, "ndc", (place_x, height - place_y))


def test_no_mark_is_drawn_for_a_point_at_or_behind_the_eye(window: MainWindow) -> None:
    for along in (0.0, -1.0):
        camera = start().camera
        # Beside the eye, or behind it and a little aside; mirrored, that would be in the picture.
        point = np.array(camera.eye) + 0.5 * camera.frame[0] - 3.0 * along * camera.frame[2]
        window.probe_panel.follow(point=tuple(point.tolist()))
        QApplication.processEvents()
        for name in ("ndc", "image"):
            assert not any_mark(window, name), name
        window.probe_panel.follow(point=CORNER)
        QApplication.processEvents()
        for name in ("ndc", "image"):
            assert any_mark(window, name), name


def test_probes_survive_edits_and_themes_and_end_with_the_scene(window: MainWindow) -> None:
    window.probe_panel.follow(point=CORNER)
    window.store.set_projection(replace(start(), lens=Perspective(50.0, 1.0, 30.0)))
    window.store.undo()
    window.look.set_presenting(True)
    window.look.set_presenting(False)
    settle()
    assert [probe.point for probe in window.probe_panel.probes] == [CORNER]
    assert marked(window, "image", place_in(window, "image", CORNER))
    assert not window.store.modified  # they are the window's, not the document's
    window.store.set_document(Document("cube", load("cube").start))
    assert window.probe_panel.probes == ()


# -- the panel


@pytest.fixture
def panel(qtbot: QtBot) -> ProbePanel:
    made = ProbePanel()
    qtbot.addWidget(made)
    show(made, start())
    made.show()
    qtbot.waitExposed(made)
    return made


def test_every_number_is_the_command_s_to_the_last_digit(
    panel: ProbePanel, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    points = [CORNER, (0.1, 1 / 3, -2.0), (40.0, -7.0, 2.0), (9.0, 7.0, 14.0)]
    source = tmp_path / "points.csv"
    source.write_text("\n".join(",".join(map(repr, point)) for point in points), encoding="utf-8")
    document = tmp_path / "document.json"
    for lens, depth in (
        (Perspective(45.0, 1.0, 30.0), "reversed"),
        (Perspective(1e-3, 1.0, 30.0), "opengl"),  # read from the exact precision
        (Oblique(-6.0, 6.0, -4.0, 4.0, 5.0, 30.0, alpha_deg=60.0, beta_deg=60.0), "reversed"),
    ):
        projection = replace(start(), lens=lens, depth=depth)  # type: ignore[arg-type]
        write(Document("letter-f", projection), document)
        assert cli.main(["project", str(document), str(source), "--format", "json"]) == 0
        answer = json.loads(capsys.readouterr().out)
        panel.clear()
        show(panel, projection)
        for point in points:
            panel.follow(point=point)
            panel.pin.click()
        lines = copied(panel)
        for block, expected in enumerate(answer["points"]):
            rows = {0: "world", 1: "world", 2: "view", 3: "clip", 5: "ndc", 6: "image", 7: "depth"}
            for row, name in rows.items():
                values = expected[name]
                values = [] if values is None else np.atleast_1d(values).tolist()
                values += [1.0] if name in ("world", "view") else []
                mine = list(filter(None, lines[row][1 + 4 * block : 5 + 4 * block]))
                assert mine == list(map(format_value, values)), name
                assert list(map(float, mine)) == values
            beyond = expected["outside_of"]
            said = f"outside of: {', '.join(beyond)}" if beyond else "inside"
            assert cells(panel, block, 8) == [said]


def test_a_point_is_followed_through_the_tiles_that_change_something(panel: ProbePanel) -> None:
    def rows(text: str) -> dict[str, list[str]]:
        show(panel, replace(start(), placement=Chain.read(text)))
        model = panel.table.model()
        heads = [model.headerData(row, Qt.Orientation.Vertical) for row in range(model.rowCount())]
        formulas = [model.data(model.index(row, 0)) for row in range(model.rowCount())]
        return {
            head: [formula, *cells(panel, 0, row)]
            for row, (head, formula) in enumerate(zip(heads, formulas, strict=True))
        }

    panel.follow(point=(1.0, 2.0, 0.0))
    seen = rows("translate 3,0,0; rotate z 90; off mirror x; shear xy 0; scale 2,1,1")
    assert [*seen][:5] == ["object", "scale", "rotation about z", "world", "view"]
    assert [*seen.values()][:4] == [
        ["p", "1", "2", "0", "1"], ["S p", "2", "2", "0", "1"],
        ["R_z S p", "\u22122", "2", "0", "1"], [seen["world"][0], "1", "2", "0", "1"],
    ]  # fmt: skip
    assert seen["divide"][1].startswith("÷")
    assert [*rows("translate 3,0,0; scale 0,1,1")][:3] == ["object", "scale", "world"]
    assert cells(panel, 0, 0)[0].startswith("none") and cells(panel, 0, 1)[0] == "\u22122"
    for usual in ("", "rotate z 30", "translate 1,0,0; rotate z 0"):
        assert [*rows(usual)][:3] == ["object", "world", "view"]
    panel.follow(pixel=(3.0, 4.0))
    assert len(rows("translate 3,0,0; rotate z 90")) == 10


def test_a_row_says_why_there_is_no_picture(panel: ProbePanel) -> None:
    camera = Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0))
    show(panel, replace(start(), camera=camera))
    panel.follow(point=(1.0, 2.0, 7.0))
    assert cells(panel, 0, 4) == ["behind the eye"]
    panel.follow(point=(1.0, 2.0, 5.0))
    assert cells(panel, 0, 4) == ["in the eye plane (w = 0)"]
    assert [cells(panel, 0, row) for row in (5, 6, 7)] == [[], [], []]
    panel.follow(point=(1.0, 2.0, 3.0))
    assert cells(panel, 0, 4) == ["÷ 2"] * 3


def test_every_number_is_fully_visible(panel: ProbePanel) -> None:
    panel.resize(1200, 300)
    panel.follow(point=(1 / 3, 2 / 3, -1 / 7))
    show(panel, replace(start(), camera=Camera((6.1, 5.3, 9.7), (0.1, 2.2, 0.3))))
    metrics, model = panel.table.fontMetrics(), panel.table.model()
    for all_digits in (False, True):
        with all_digits_shown(all_digits):
            for row, column in itertools.product(range(8), range(1, 5)):
                text = model.data(model.index(row, column)) or ""
                assert metrics.horizontalAdvance(text) + 6 <= panel.table.columnWidth(column), text


def test_four_digits_are_shown_all_with_the_switch_and_all_are_copied(panel: ProbePanel) -> None:
    show(panel, replace(start(), camera=Camera((6.1, 5.3, 9.7), (0.1, 2.2, 0.3))))
    panel.follow(point=(1 / 3, 2 / 3, -1 / 7))

    def shown() -> list[str]:
        return [text.removeprefix("÷ ") for row in range(8) for text in cells(panel, 0, row)]

    few, whole = shown(), copied(panel)
    exact = [text.removeprefix("÷ ") for line in whole[:8] for text in line[1:] if text]
    assert few[0] == "0.3333" and few != exact and len(few) == len(exact) == 25
    for short, number in zip(few, exact, strict=True):
        assert plain(short) == f"{float(number):.4g}", number
    width = panel.table.columnWidth(1)
    with all_digits_shown():
        assert shown() == exact and panel.table.columnWidth(1) > width
        assert copied(panel) == whole
    assert shown() == few and panel.table.columnWidth(1) == width
    model = panel.table.model()
    assert model.data(model.index(0, 1), Qt.ItemDataRole.ToolTipRole) == exact[0]


def test_the_formulas_fractions_are_stacked_in_rows_that_hold_them(panel: ProbePanel) -> None:
    panel.follow(point=CORNER)
    model, table = panel.table.model(), panel.table
    heights = {}
    for row in range(model.rowCount()):
        formula = model.data(model.index(row, 0), FORMULA)
        is_stacked = OVER in formula
        assert "/" not in formula.replace(OVER, "")
        heights.setdefault(is_stacked, set()).add(table.rowHeight(row))
    assert min(heights[True]) > max(heights[False])
    assert copied(panel)[5][0] == "x/w,  y/w,  z/w" and copied(panel)[7][0] == "(z + 1)/2"


@pytest.mark.undrawn
def test_an_open_panel_is_whole_in_letters_for_a_class_and_back(window: MainWindow) -> None:
    """Every formula and all nine lines are visible; afterwards the letters are small again."""
    window.resize(1920, 1080)
    panel = window.probe_panel
    window.panels.open(panel)
    panel.follow(point=CORNER)
    table, room = panel.table, []
    for on in (False, True, False):
        window.look.set_presenting(on)
        QTest.qWait(2 * REST_MS)
        metrics, model = table.fontMetrics(), table.model()
        formulas = [model.data(model.index(row, 0), FORMULA) for row in range(9)]
        for row, formula in enumerate(formulas):
            printed = typeset(formula, table.font())
            assert printed.width + 6 <= table.columnWidth(0)
            assert printed.height <= table.rowHeight(row), formula
        assert metrics.height() <= table.rowHeight(0)
        rows = 6 if on else 9  # for a class the last ones are scrolled to: a panel has a third
        assert table.viewport().height() >= sum(map(table.rowHeight, range(rows)))
        room.append([*map(table.columnWidth, range(5))])
    assert room[0] == room[2] and room[1][0] > room[2][0]


def test_a_click_moves_the_probe_unless_it_is_pinned(panel: ProbePanel, qtbot: QtBot) -> None:
    panel.follow(point=(1.0, 0.0, 0.0))
    panel.follow(point=(2.0, 0.0, 0.0))
    assert panel.probes == (Probe(1, (2.0, 0.0, 0.0)),)
    qtbot.mouseClick(panel.pin, Qt.MouseButton.LeftButton)
    panel.follow(pixel=(5.0, 6.0))
    panel.follow(point=(3.0, 0.0, 0.0))
    assert panel.probes == (Probe(1, (2.0, 0.0, 0.0)), Probe(2, (3.0, 0.0, 0.0)))
    panel.choose(1)
    panel.follow(point=(4.0, 0.0, 0.0))  # the pinned one stays, the loose one goes there
    assert panel.probes == (Probe(1, (2.0, 0.0, 0.0)), Probe(2, (4.0, 0.0, 0.0)))
    panel.choose(1)
    panel.remove()
    assert [probe.number for probe in panel.probes] == [2]
    panel.pin.click()
    panel.follow(point=(5.0, 0.0, 0.0))
    assert [probe.number for probe in panel.probes] == [1, 2]


def test_one_probe_too_many_is_refused(panel: ProbePanel, qtbot: QtBot) -> None:
    for number in range(MOST_PROBES):
        panel.follow(point=(float(number), 0.0, 0.0))
        panel.pin.click()
    before = panel.probes
    with qtbot.waitSignal(panel.refused) as said:
        panel.follow(point=(9.0, 9.0, 9.0))
    assert said.args == ["Probes = 7: at most 6 can be pinned; remove one first."]
    assert panel.probes == before


def test_the_point_can_be_typed(panel: ProbePanel, qtbot: QtBot) -> None:
    panel.activateWindow()
    assert QTest.qWaitForWindowActive(panel, PATIENCE_MS)
    for field, text in zip(panel.fields, ("1.25", "1/3", "-2e-3"), strict=False):
        field.setFocus()
        field.selectAll()
        qtbot.keyClicks(field, text)
        qtbot.keyClick(field, Qt.Key.Key_Return)
    assert panel.probes == (Probe(1, (1.25, 1 / 3, -0.002)),)
    panel.fields[1].setFocus()  # the field that is typed in has all digits, the others few
    assert [field.text() for field in panel.fields] == ["1.25", "0.3333333333333333", "-0.002", "1"]
    panel.fields[2].setFocus()
    assert [field.text() for field in panel.fields] == ["1.25", "0.3333", "-0.002", "1"]


def type_in(field: Any, text: str) -> None:
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)


def test_l13_a_point_at_infinity_is_typed_with_w_0(panel: ProbePanel) -> None:
    """Seen along -z with near 5, far 12.5: z of the cube is (f + n)/(f - n) there."""
    show(panel, replace(start(), camera=Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0))))
    panel.follow(point=(0.0, 0.0, -1.0))
    type_in(panel.fields[3], "0")
    assert panel.probes == (Probe(1, direction=(0.0, 0.0, -1.0)),)
    assert panel.choice.currentText() == "Direction 1"
    rows = [cells(panel, 0, row) for row in range(9)]
    assert rows[0] == rows[1] == rows[2] == ["0", "0", "−1", "0"]
    assert rows[3] == ["0", "0", "2.333", "1"] and rows[4] == ["÷ 1"] * 3
    assert rows[5] == ["0", "0", "2.333"] and rows[6] == ["640", "360"]
    assert rows[8] == ["the vanishing point; outside of: far"]
    type_in(panel.fields[2], "2")
    assert cells(panel, 0, 4) == ["behind the eye: no picture"]
    assert cells(panel, 0, 5) == ["the opposite direction has a picture"]
    panel.follow(direction=(1.0, 0.0, 0.0))
    assert cells(panel, 0, 4) == ["w = 0: its picture is at infinity too"]
    assert cells(panel, 0, 5) == ["parallel to the image: lines stay parallel"]
    show(panel, start().with_lens("orthographic"))
    assert cells(panel, 0, 5) == ["parallel projectors: lines stay parallel"]


def test_l13_another_w_divides_and_four_zeros_are_refused(panel: ProbePanel) -> None:
    panel.follow(direction=(1.0, -2.0, 3.0))
    type_in(panel.fields[3], "-4")
    assert panel.probes == (Probe(1, (-0.25, 0.5, -0.75)),)
    assert panel.fields[3].text() == "1"
    panel.follow(point=(0.0, 0.0, 0.0))
    type_in(panel.fields[3], "0")
    assert panel.error.text().startswith("Not possible. w = 0: must not be 0 if x, y and z are 0")
    assert panel.fields[3].accessibleDescription() == panel.error.text()
    assert panel.probes == (Probe(1, (0.0, 0.0, 0.0)),)


def test_l13_a_point_at_infinity_is_marked_in_all_panes(window: MainWindow) -> None:
    """In the image at its vanishing point, in the world where its ray leaves by the near plane."""
    direction = (-0.2, -0.1, -1.0)
    window.probe_panel.follow(direction=direction)
    QApplication.processEvents()
    for name in ("image", "ndc"):
        place = place_in(window, name, tuple(1e9 * part for part in direction))
        x, y = (round(part) for part in place)
        found = pixels(window, name)[y - 9 : y + 10, x - 9 : x + 10].reshape(-1, 3)
        rim = np.abs(found.astype(float) - 255 * np.array(rgb(LIGHT.ink))).max(axis=1) <= 12
        assert rim.sum() > 20, name  # a hollow disc: it is beyond the far plane
    assert any_mark(window, "world")
    window.probe_panel.follow(direction=(0.2, 0.1, 1.0))
    QApplication.processEvents()
    assert not any(any_mark(window, name) for name in window.panes)  # behind the eye


def test_a_pinned_probe_s_button_looks_pressed(window: MainWindow) -> None:
    window.look.set_theme("dark")  # where Fusion hardly shows it
    panel = window.probe_panel
    window.panels.open(panel)
    panel.follow(point=CORNER)
    QApplication.processEvents()
    size = panel.pin.size()

    def colour() -> Any:
        return np.array(panel.pin.grab().toImage().pixelColor(8, 8).getRgbF()[:3])

    up = colour()
    panel.pin.click()
    QApplication.processEvents()
    assert np.abs(colour() - up).max() > 0.25
    assert panel.pin.size() == size
    panel.pin.click()
    QApplication.processEvents()
    assert np.abs(colour() - up).max() < 0.05


def test_probes_are_traced_once_for_all_panes(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    window.probe_panel.follow(point=(0.125, 1.0, 0.25))
    QApplication.processEvents()
    traced, whole = [], Projection.trace

    def counted(projection: Projection, points: Any, *space: Any) -> Any:
        if np.array_equal(points, [(0.125, 1.0, 0.25)]):
            traced.append(projection)
        return whole(projection, points, *space)

    monkeypatch.setattr(Projection, "trace", counted)
    now = window.store.document.projection
    window.store.set_projection(replace(now, lens=replace(now.lens, fov_y_deg=50.0)))
    assert len(traced) == 1


def test_letters_are_those_of_the_other_panels(panel: ProbePanel) -> None:
    """M is the view matrix as in the camera frame; the image is W x H as in the matrices."""
    own_view = FreeMatrix(np.eye(4).tolist(), np.eye(4).tolist())  # type: ignore[arg-type]
    for lens, view in ((Perspective(), "R (p − e)"), (own_view, "M p")):
        show(panel, replace(start(), lens=lens))
        panel.follow(point=CORNER)
        model = panel.table.model()
        formulas = {
            model.headerData(row, Qt.Orientation.Vertical): model.data(model.index(row, 0), FORMULA)
            for row in range(model.rowCount())
        }
        assert formulas["view"] == view and "M" not in formulas["world"]
        shown = {matrix.name: matrix for matrix in matrices(Projection(), "own")}
        w_2, h_2 = (stacked(shown["image_from_ndc"].formulas[i][3], "own") for i in (0, 1))
        assert formulas["image px"] == f"(x + 1) {w_2},  (1 − y) {h_2}"


def test_l13_the_panel_that_is_opened_by_hand_follows_a_vertex_at_once(window: MainWindow) -> None:
    """One click shows the numbers of a point; an existing probe stays."""
    panel = window.probe_panel
    (name,) = (b for b in window.panels.names.findChildren(QToolButton) if b.text() == "Probe")
    name.click()
    settle()
    (probe,) = panel.probes
    vertices = np.asarray(window.shown.scene.surface.points) + window.shown.scene.origin
    assert (np.abs(vertices - probe.point).max(axis=1) < 1e-6).any()
    inside = window.store.document.projection.trace(np.array(probe.point))
    assert inside.in_front and not inside.outside.any() and panel.table.isVisible()
    panel.put(1, (1.0, 2.0, 0.5))
    name.click()
    name.click()
    assert panel.probes[0].point == (1.0, 2.0, 0.5) and len(panel.probes) == 1
    panel.clear()
    name.click()
    window.panels.open(panel)  # as a document does that was saved so
    assert not panel.probes


# -- a scene whose point is clicked


def test_a_click_in_the_image_moves_the_point_of_back_from_the_picture(window: MainWindow) -> None:
    window.guide.choose("unprojection")
    pane, before = window.panes["image"], window.store.document.settings["point"]
    corner = (-1.5, 3.0, 0.5)
    click(pane.canvas, place_in(window, "image", corner))
    assert window.store.document.settings["point"] == pytest.approx(corner, abs=1e-5)
    assert not window.probe_panel.probes
    window.store.undo()
    assert window.store.document.settings["point"] == before
    click(window.panes["world"].canvas, place_in(window, "world", corner))
    assert window.probe_panel.probes, "elsewhere a click follows a point as ever"
    left, top, *_ = pane.drawing.picture_rectangle_px
    click(pane.canvas, (left + 5.0, top + 5.0))
    assert window.store.document.settings["point"] == before
    said = "depth = 1: must be that of something drawn, but nothing is here"
    assert said in window.messages.text


def test_a_double_click_there_leaves_the_point_where_it_was(window: MainWindow) -> None:
    window.guide.choose("unprojection")
    canvas, before = window.panes["image"].canvas, window.store.document.settings["point"]
    x, y = place_in(window, "image", (-1.5, 3.0, 0.5))
    pos = QPoint(math.floor(x), math.floor(y))
    QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=pos)
    assert window.store.document.settings["point"] != before
    QTest.mouseDClick(canvas, Qt.MouseButton.LeftButton, pos=pos)
    QApplication.processEvents()
    assert window.store.document.settings["point"] == before


@pytest.mark.undrawn
def test_a_distance_of_a_chart_opens_the_depth_buffer_there(window: MainWindow) -> None:
    window.quality.use(
        {
            "scene": "depth-buffer", "camera.distance": "20.0", "lens.near": "0.5",
            "lens.far": "300.0", "settings.format": "float32", "settings.range": "reversed",
        }
    )  # fmt: skip
    document = window.store.document
    assert document.scene == "depth-buffer" and document.settings["range"] == "reversed"
    assert document.projection.camera.distance == pytest.approx(20.0)
    assert document.projection.lens.far == 300.0
    assert document.projection.camera.target == load("depth-buffer").start.camera.target


@pytest.mark.undrawn
def test_the_focus_stays_in_the_panel_when_the_last_probe_is_removed(window: MainWindow) -> None:
    """It went to the choice of lenses, where an arrow key changes the model."""
    activate(window)
    panel = window.probe_panel
    window.panels.open(panel)
    for name in ("Remove", "Clear"):
        panel.follow(point=CORNER)
        button = next(each for each in panel.findChildren(QPushButton) if each.text() == name)
        button.setFocus()
        QTest.keyClick(button, Qt.Key.Key_Space)
        assert not panel.probes and QApplication.focusWidget() is panel.fields[-1], name
    panel.follow(point=CORNER)
    settle()
    panel.table.setFocus()
    QTest.keyClick(panel.table, Qt.Key.Key_Escape)
    assert not panel.probes and QApplication.focusWidget() is panel.fields[-1]


@pytest.mark.undrawn
def test_the_refusal_of_a_probe_goes_once_there_is_room(window: MainWindow) -> None:
    panel, messages = window.probe_panel, window.messages
    for place in range(MOST_PROBES):
        panel.follow(point=(float(place), 0.0, 0.0))
        panel.pin.click()
    panel.follow(point=CORNER)
    assert "remove one first" in messages.text
    panel.remove()
    assert messages.text == "" and len(panel.probes) == MOST_PROBES - 1
    messages.show_message("Another message.")
    panel.follow(point=CORNER)
    assert messages.text == "Another message."
