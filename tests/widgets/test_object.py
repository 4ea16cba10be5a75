"""L2 in the window: the object's own transform in dock, panes and panel."""

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QToolButton

from app.document.document import Document
from app.document.files import write
from app.document.settings import set_values
from app.drawings.frame import axes_reach
from app.model.chain import Chain, FiveTiles
from app.scenes.scene import BUILT_IN, load
from tests.support.controls import enter
from tests.support.drawings import lit_at
from tests.support.window import activate, move_mouse, pixels, settle, show_scene
from widgets.controls.chain_editor import ChainEditor
from widgets.parts.movable import MoveButton
from widgets.parts.number_rows import NumberRow
from widgets.window.main_window import MainWindow


def spots(window: MainWindow, *points: Any) -> list[tuple[float, float]]:
    """Return the pixels of points in the world pane, for a scene at the origin."""
    pane = window.panes["world"].drawing.own.pane
    return [(x, pane.size_px[1] - y) for x, y, _ in pane.seen(np.array(points))]


KEYS = [f"{vector}_{x}" for vector in ("translate", "rotate_deg", "scale") for x in "xyz"]


def build(window: MainWindow, text: str) -> ChainEditor:
    """Unfold the object's tiles, and make it this chain."""
    window.controls.sections["object"].set_open(True)
    editor = window.controls.chain
    editor.edited.emit(Chain.read(text))
    settle()
    return editor


def row_of(window: MainWindow, key: str) -> NumberRow:
    row = window.controls.chain.rows[key]
    assert isinstance(row, NumberRow)
    return row


def chain_of(window: MainWindow) -> Chain:
    return window.store.document.projection.placement


def test_l2_every_number_of_the_object_is_a_row_and_moves_all_panes(window: MainWindow) -> None:
    build(window, FiveTiles().chain.text)
    for key in KEYS:
        row = row_of(window, key)
        assert row.isVisible() and row.tip
        before = {name: pixels(window, name) for name in window.panes}
        row.edited.emit(row.value() + 0.75 if "rotate" not in key else 35.0)
        settle()
        for name, picture in before.items():
            assert (pixels(window, name) != picture).any(), (key, name)
    assert chain_of(window) == FiveTiles((0.75,) * 3, (35.0,) * 3, (1.75,) * 3).chain
    for _ in KEYS:
        window.store.undo()
    assert chain_of(window).is_identity
    assert row_of(window, "scale_x").value() == 1.0


def test_every_scene_has_its_pipeline_in_the_dock(window: MainWindow) -> None:
    """A sample of those with a phenomenon, and all without one."""
    window.controls.sections["object"].set_open(True)
    editor = window.controls.chain
    for name in [each for each in BUILT_IN if each in BUILT_IN[::5] or not load(each).phenomenon]:
        show_scene(window, name)
        assert len(editor.beyond) >= 5 and all(button.isVisible() for button in editor.beyond)
        has_tiles = load(name).phenomenon is None
        if has_tiles:
            build(window, "translate 1,0,0")
        for at, turned in ((1, False), (2, True))[: 1 + has_tiles]:
            stops = []
            for button in editor.beyond[::-1]:
                button.click()
                stops.append(window.strip.position)
            settle()
            assert sorted(stops[:2]) == [0.5, 1.0] and stops[at - 1] == 0.5, name
            assert stops[2:] == sorted(stops[2:]) and stops[-1] == 5.0, name
            assert window.panes["ndc"].drawing.state.morph.from_left is turned, name
            if has_tiles:
                window.strip.direction.click()


@pytest.mark.undrawn
def test_the_dock_has_the_whole_pipeline_and_each_factor_is_a_place_to_stand(
    window: MainWindow,
) -> None:
    editor = build(window, "translate 3,0,0; rotate z 90")

    def names() -> list[str]:
        return [button.text() for button in editor.beyond]

    eye = window.store.document.projection.camera.eye
    moved = f"translation ({', '.join(f'{-part:.4g}' for part in eye)})".replace("-", "\u2212")
    assert names()[:3] == ["image ← NDC", "division by w", "clip ← depth range"]
    assert names()[-2:] == ["rotation", moved]
    stops = []
    for button in reversed(editor.beyond):
        button.click()
        stops.append(window.strip.position)
    assert stops == sorted(stops) and (stops[0], stops[1], stops[-1]) == (0.5, 1.0, 5.0)
    editor.undone.click()
    kinds = [name.rpartition(" ")[0] for name in names()[-3:-1]]
    assert kinds == ["rotation about x", "rotation about y"] and names()[-1] == moved
    window.store.set_projection(
        set_values(window.store.document, ["lens.kind=orthographic"]).projection
    )
    settle()
    assert names()[-1] == moved and len(editor.beyond) == len(names())
    shown = [button.text() for button in editor.beyond if button.isVisible()]
    assert shown == names()


def remove(card: Any) -> None:
    """Click the last button of a tile."""
    card.findChildren(QToolButton)[-1].click()


def drag(editor: ChainEditor, place: int, to: int) -> None:
    """Drag a tile by its grip to the middle of another one's place."""
    grip = editor.cards[place].findChild(MoveButton)
    end = editor.cards[to]
    y = end.mapTo(editor, QPoint(0, end.height() // 2)).y()
    y = grip.mapFrom(editor, QPoint(0, y)).y() + (3 if to > place else -3)
    QTest.mousePress(grip, Qt.MouseButton.LeftButton)
    move_mouse(grip, QPoint(4, y), Qt.MouseButton.LeftButton)
    QTest.mouseRelease(grip, Qt.MouseButton.LeftButton, pos=QPoint(4, y))
    settle()


@pytest.mark.undrawn
def test_a_product_leads_to_its_factors_and_a_factor_to_its_tile(window: MainWindow) -> None:
    editor = build(window, "rotate z 90; off mirror x; translate 3,0,0; rotate z 20")
    activate(window)
    QTest.keyClick(editor.to_factors, Qt.Key.Key_Space)
    settle()
    panel = window.matrices
    assert window.panels.open_panel is panel
    views = [panel.views[f"world_from_object/{name}"] for name in ("rotation_z2", "rotation_z")]
    assert all(view.isVisible() for view in views)
    titles = [card.switch.text() for card in editor.cards]
    assert titles == ["rotation about z", "mirror x", "translation", "rotation about z 2"]
    assert panel.views["world_from_object"].hasFocus()
    section = window.controls.sections["object"]
    for view, row in zip(views, ("rotate_deg2_z", "rotate_deg_z"), strict=True):
        section.set_open(False)
        place = view.cell_rect(1, 0).center().toPoint()
        move_mouse(view, place, Qt.MouseButton.NoButton)
        QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=place)
        settle()
        card = editor.rows[row].parentWidget()
        top = card.mapTo(window.controls, QPoint(0, 0)).y()
        assert section.is_open and 0 <= top < window.controls.height()
        assert editor.rows[row].is_marked and view.hasFocus()
        QTest.keyClick(view, Qt.Key.Key_Return)
        settle()
        assert editor.rows[row].isAncestorOf(window.focusWidget())
    window.present.begin()
    settle()
    section.set_open(False)
    panel.sought.emit("world_from_object/rotation_z", True)
    assert not section.is_open


@pytest.mark.undrawn
def test_a_tile_is_added_moved_switched_off_and_removed(window: MainWindow) -> None:
    editor = build(window, "rotate z 90")
    editor.add.menu().actions()[1].trigger()  # a translation
    assert chain_of(window).text == "translate 0,0,0; rotate z 90"
    enter(row_of(window, "translate_x"), "3")
    card = editor.cards[0]
    grip = card.findChild(MoveButton)
    QTest.keyClick(grip, Qt.Key.Key_Up)  # it is at the top
    QTest.keyClick(grip, Qt.Key.Key_Down)
    assert chain_of(window).text == "rotate z 90; translate 3,0,0"
    assert chain_of(window).matrix[:3, 3].tolist() == [0.0, 3.0, 0.0]
    assert editor.cards[1] is card and editor.rows["translate_x"] is card.rows["x"]
    QTest.keyClick(grip, Qt.Key.Key_Down)  # it is at the bottom
    card.switch.click()
    assert chain_of(window).text == "rotate z 90; off translate 3,0,0"
    assert chain_of(window).matrix[0, 3] == 0.0 and not row_of(window, "off1_x").error
    remove(card)
    assert chain_of(window).text == "rotate z 90" and len(editor.cards) == 1
    texts = []
    while window.store.can_undo:
        window.store.undo()
        texts.append(chain_of(window).text)
    assert texts[:2] == ["rotate z 90; off translate 3,0,0", "rotate z 90; translate 3,0,0"]
    assert texts[-3:] == ["translate 0,0,0; rotate z 90", "rotate z 90", ""]
    settle()
    assert not editor.cards
    editor.add.menu().actions()[0].trigger()
    assert chain_of(window) == FiveTiles().chain


def type_for_a_tile(window: MainWindow) -> None:
    """Begin to type another number for a tile, without Enter."""
    editor = build(window, "translate 3,0,0")
    activate(window)
    field = editor.cards[0].findChildren(QLineEdit)[0]
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "7")


@pytest.mark.undrawn
@pytest.mark.parametrize("other", ["scale 2,1,1", ""])
def test_what_is_typed_for_a_tile_that_goes_away_changes_no_other(
    window: MainWindow, other: str
) -> None:
    type_for_a_tile(window)
    window.store.set_document(set_values(window.store.document, [f"object.chain={other}"]))
    settle()
    assert chain_of(window) == Chain.read(other)


@pytest.mark.undrawn
def test_a_tile_that_moves_stays_in_view(window: MainWindow) -> None:
    editor = build(window, "; ".join(["translate 1,0,0", *["scale 1,2,1"] * 7]))
    controls, card = window.controls, editor.cards[0]
    controls.bring_into_view(card)
    grip = card.findChild(MoveButton)
    activate(window)
    QTest.mouseClick(grip, Qt.MouseButton.LeftButton)
    for place in range(1, 8):
        QTest.keyClick(grip, Qt.Key.Key_Down)
        settle()
        assert editor.cards[place] is card and grip.hasFocus()
        assert controls.viewport().rect().contains(grip.mapTo(controls.viewport(), QPoint(5, 5)))
    QTest.mousePress(grip, Qt.MouseButton.LeftButton)
    for _ in range(20):
        top = grip.mapFrom(controls.viewport(), QPoint(0, 2)).y()
        move_mouse(grip, QPoint(4, top), Qt.MouseButton.LeftButton)
    QTest.mouseRelease(grip, Qt.MouseButton.LeftButton)
    assert chain_of(window).tiles[0].kind == "translate"


@pytest.mark.undrawn
def test_what_is_typed_for_a_tile_does_not_move_the_fixed_objects_of_another_scene(
    window: MainWindow,
) -> None:
    type_for_a_tile(window)
    window.store.set_document(Document("clipping", load("clipping").start))
    settle()
    assert chain_of(window) == Chain() and window.store.document.scene == "clipping"


@pytest.mark.undrawn
def test_a_tile_is_dragged_to_another_place(window: MainWindow) -> None:
    editor = build(window, "translate 3,0,0; rotate z 90; mirror x")
    drag(editor, 0, 1)
    assert chain_of(window).text == "rotate z 90; translate 3,0,0; mirror x"
    drag(editor, 2, 0)
    assert chain_of(window).text == "mirror x; rotate z 90; translate 3,0,0"
    assert [card.kind for card in editor.cards] == ["mirror x", "rotate z", "translate"]
    window.store.undo()
    window.store.undo()
    settle()
    assert [card.kind for card in editor.cards] == ["translate", "rotate z", "mirror x"]


def test_both_orders_are_seen_at_once_and_one_sentence_says_what_differs(
    window: MainWindow,
) -> None:
    editor = build(window, "translate 3,0,0; rotate z 90")
    world = window.panes["world"]
    drag(editor, 0, 1)
    assert world.drawing.former == Chain.read("translate 3,0,0; rotate z 90")
    assert "swings about the origin, and ends 4.243 units" in editor.first.text()
    both = pixels(window)
    world.request("former", None)
    settle()
    assert (pixels(window) != both).any(), "the first order is pale beside the second"
    drag(editor, 0, 1)
    assert world.drawing.former == Chain.read("rotate z 90; translate 3,0,0")
    enter(row_of(window, "translate_x"), "2")
    settle()
    assert world.drawing.former is None and "bottom" in editor.first.text()
    editor = build(window, "translate 3,0,0; translate 0,1,0")
    drag(editor, 0, 1)
    assert editor.first.text() == "Both orders do the same."


@pytest.mark.undrawn
def test_what_is_impossible_is_said_and_nothing_is_lost(window: MainWindow) -> None:
    editor = build(window, "off scale 1e20,1,1; scale 1e20,1,1")
    editor.cards[0].switch.click()
    assert editor.refusal.text().startswith("Not possible. ")
    assert "product" in editor.refusal.text() and not editor.cards[0].switch.isChecked()
    assert chain_of(window).text == "off scale 1e+20,1,1; scale 1e+20,1,1"
    editor = build(window, "shear xy 1e30; scale 2,1,1")
    QTest.keyClick(editor.cards[0].findChild(MoveButton), Qt.Key.Key_Down)
    assert "product" in editor.refusal.text()
    assert [card.kind for card in editor.cards] == ["shear xy", "scale"]
    assert row_of(window, "scale_x").value() == 2.0
    editor = build(window, "matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")
    column = editor.rows["matrix_x"]
    column.edited.emit((0.0, 0.0, 0.0))
    assert "inverse" in column.error and chain_of(window).is_identity
    assert column.error.count("Not possible.") == editor.refusal.text().count("Not possible.") + 1
    editor = build(window, "; ".join(["mirror x"] * 8))
    assert not editor.add.isEnabled()


@pytest.mark.undrawn
def test_the_product_is_beside_the_tiles_in_numbers_and_letters(window: MainWindow) -> None:
    editor = build(window, "translate 3,0,0; rotate z 90; scale 2,1,1")
    assert editor.product.formula.startswith("T R_z S =\n[0&\u22121&0&3;2&0&0&0")
    editor.vectors.setChecked(True)
    assert editor.product.formula.startswith("S R_z T =\n[0&2&0&0")
    editor.letters.setChecked(True)
    assert "s_x" in editor.product.formula and "t_x" in editor.product.formula


def test_l2_a_column_highlights_its_axis_and_an_axis_its_column(window: MainWindow) -> None:
    build(window, "rotate y 30")
    settle()
    drawing = window.panes["world"].drawing
    way = axes_reach(load("letter-f").size) * np.array(
        [math.cos(math.radians(30.0)), 0.0, -math.sin(math.radians(30.0))]
    )
    ((x, y),) = spots(window, 0.6 * way)
    assert "object_x" in lit_at(drawing, x, y)
    before = pixels(window, "world")
    assert drawing.show_highlight(frozenset({"object_x"}))
    window.panes["world"].canvas.redraw()
    settle()
    around = np.s_[round(y) - 4 : round(y) + 5, round(x) - 4 : round(x) + 5]
    assert (pixels(window, "world") != before)[around].any(), "the axis, not only its letter"


@pytest.mark.undrawn
def test_objects_of_a_phenomenon_are_fixed_and_a_text_says_so(window: MainWindow) -> None:
    section = window.controls.sections["object"]
    section.set_open(True)
    show_scene(window, "eye-plane")
    said = [w.text() for w in section.findChildren(QLabel) if w.isVisible() and "fixed" in w.text()]
    editor = window.controls.chain
    assert len(said) == 1 and not editor.add.isVisible() and not editor.product.isVisible()
    show_scene(window, "cube")
    assert editor.add.isVisible()
    assert not [w for w in section.findChildren(QLabel) if w.isVisible() and "fixed" in w.text()]


@pytest.mark.undrawn
def test_a_wrong_scale_is_refused_and_the_last_good_one_stays(window: MainWindow) -> None:
    build(window, "scale 1,1,1")
    row = row_of(window, "scale_x")
    for typed in ("nan", "1e308", "2e30"):
        enter(row, typed)
        settle()
        assert row.error and window.store.document.projection.placement.is_identity, typed


@pytest.mark.undrawn
def test_l2_a_prepared_document_comes_back(window: MainWindow, tmp_path: Path) -> None:
    placement = FiveTiles((1.0, 0.0, -2.0), (0.0, 30.0, 0.0), (1.0, 2.0, 1.0), "rts").chain
    document = Document("cube", replace(load("cube").start, placement=placement))
    path = tmp_path / "moved.json"
    write(document, path)
    window.controls.sections["object"].set_open(True)
    window.files.open(path)
    settle()
    assert window.store.document.projection.placement == placement
    assert row_of(window, "rotate_deg_y").value() == 30.0


def test_a_vertex_is_picked_where_it_is_seen(window: MainWindow) -> None:
    """The keyboard goes to the moved vertices."""
    from app.drawings.probes import next_vertex, pick_in, vertex_of

    build(window, "translate 2,0,0; rotate y 40")
    settle()
    scene, projection = window.shown.scene, window.store.document.projection
    sight = window.panes["image"].drawing.sight
    rectangle = window.panes["image"].drawing.picture_rectangle_px
    number_at = next_vertex(scene, projection, sight, rectangle, 1.0, None, forwards=True)
    assert number_at is not None
    place = vertex_of(scene, projection, number_at)
    ((x, y),) = sight.seen([place]).tolist()
    hit = pick_in(scene, projection, sight, (x, y))
    assert hit is not None and hit.vertex == number_at and hit.point == pytest.approx(place)
    # The ground stays where it was.
    ((x, y),) = sight.seen([(-4.0, 0.0, 0.0)]).tolist()
    ground = pick_in(scene, projection, sight, (x, y))
    assert ground is not None and ground.point == pytest.approx((-4.0, 0.0, 0.0), abs=1e-5)


@pytest.mark.undrawn
def test_l2_a_probe_is_read_in_the_objects_coordinates_too(window: MainWindow) -> None:
    window.panels.open(window.probe_panel)
    window.probe_panel.follow(point=(2.0, 1.0, 0.0))
    build(window, FiveTiles((2.0, 0.0, 0.0), (0.0, 90.0, 0.0)).chain.text)
    settle()

    def line(row: int) -> list[str]:
        model = window.probe_panel.table.model()
        return [str(model.index(row, 1 + part).data()) for part in range(4)]

    turned = ["0", "1", "0", "1"]
    assert [line(row) for row in range(3)] == [turned, turned, ["2", "1", "0", "1"]]
    row_of(window, "scale_y").edited.emit(0.0)
    settle()
    assert "flattened" in line(0)[0] and line(1) == turned and line(3)[0] == "2"


def test_l2_axes_and_handles_are_there_before_anything_is_moved(window: MainWindow) -> None:
    """They are visible while the numbers are unfolded, and not in the first picture."""
    drawing, section = window.panes["world"].drawing, window.controls.sections["object"]

    def held() -> dict[str, tuple[float, float]]:
        shown = window.panes["world"].drawing.handles.shown
        return {each.setting: at for each, at in dict(shown).items() if each.name == "object"}

    first = pixels(window, "world")
    assert not held() and not drawing.handles.has_object
    section.set_open(True)
    settle()
    assert {"origin", "x", "y", "z"} <= {*held()}
    assert (pixels(window, "world") != first).any()
    section.set_open(False)
    settle()
    assert not held() and np.array_equal(pixels(window, "world"), first)
    section.set_open(True)
    settle()
    # x, y and z as far from the origin as they are drawn, at the identity.
    tips = axes_reach(load("letter-f").size) * np.eye(3)
    places = spots(window, *tips, np.zeros(3))
    for name, place in zip(("x", "y", "z", "origin"), places, strict=True):
        assert held()[name] == pytest.approx(place, abs=0.5)
    x, y = (round(part) for part in held()["origin"])
    canvas, at, none = window.panes["world"].canvas, QPoint(x, y), Qt.MouseButton.NoButton
    move_mouse(canvas, at, none)
    settle()
    assert "Translation" in canvas.toolTip()
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=at)
    move_mouse(canvas, at + QPoint(30, 0))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=at + QPoint(30, 0))
    settle()
    assert not window.store.document.projection.placement.is_identity
    window.store.undo()
    section.set_open(False)
    move_mouse(canvas, QPoint(2, 2), none)
    settle()
    assert not held()
    window.look.rebuild()
    section.set_open(True)
    settle()
    assert held()
    show_scene(window, "eye-plane")  # whose objects are fixed
    assert not held() and not window.panes["world"].drawing.handles.has_object
    show_scene(window, "cube")
    assert held()


@pytest.mark.undrawn
def test_the_focus_stays_among_the_tiles_when_one_is_removed(window: MainWindow) -> None:
    editor = build(window, "translate 3,0,0; rotate z 90; scale 2,1,1")
    activate(window)
    for _ in range(2):
        away = editor.cards[1].findChildren(QToolButton)[-1]
        away.setFocus()
        QTest.keyClick(away, Qt.Key.Key_Space)
        settle()
        focus = QApplication.focusWidget()
        assert focus is not None and editor.tiles.isAncestorOf(focus) and focus.isVisible()
