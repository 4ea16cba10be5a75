"""Every thing that a control moves is dragged by any free place on it, with a real mouse."""

import math
import os
from dataclasses import fields
from typing import Any, NamedTuple

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from app.document.document import Document
from app.lecture.highlight import NOTHING, WINDOW, Highlight
from app.scenes.scene import BUILT_IN
from tests.support.drawings import lit_at
from tests.support.window import (
    LEFT,
    Highlighted,
    MakeWindow,
    activate,
    move_mouse,
    settle,
    show_scene,
)
from widgets.window.main_window import MainWindow

POINT_PX, EDGE_PX = 12.0, 9.0
"""So near to a point or an edge, another place is not free."""
PLACES, TRIES = (10, 2) if "ALL_SCENES" in os.environ else (2, 1)
"""Of a thing, and of what lights up alike."""
GRID_PX = {"world": 14, "ndc": 20, "image": 20}
"""So near that nothing that lights up lies between; only the world has small grips."""
MOST_THINGS = 30  # in one pane
KEY, SHIFT = Qt.Key, Qt.KeyboardModifier.ShiftModifier
SIDES = {"left": (0, 3), "right": (1, 2), "bottom": (0, 1), "top": (3, 2)}
SAMPLE: tuple[str, ...] = (
    "letter-f",
    "similar-triangles",
    "off-axis-window",
    "affine-depth",
)
MORE = "vanishing-points", "planar-shadow", "two-eyes"


class Thing(NamedTuple):
    """A thing on the screen: a point, an edge, a label's box or a face, in pixels."""

    name: str
    kind: str
    spots: np.ndarray
    moves: str
    """The field or the setting that a drag changes."""


def world(window: MainWindow) -> Any:
    return window.panes["world"].drawing


def control_names(window: MainWindow) -> set[str]:
    phenomenon = window.shown.scene.phenomenon
    if phenomenon is None:
        return {"near", "far"}
    return {path.rpartition(".")[2] for path in phenomenon.controls}


def things(window: MainWindow) -> list[Thing]:
    """What can be dragged in the world pane, from the model and the marks alone."""
    drawing, document = world(window), window.store.document
    state, sight, projection = drawing.state, drawing.sight, document.projection
    hidden, lens = drawing.state.canvas.hidden, projection.lens
    origin = state.origin
    made: list[Thing] = []

    def add(name: str, kind: str, points: Any, moves: str) -> None:
        spots = sight.seen(np.reshape(points, (-1, 3)))
        if np.isfinite(spots).all():
            made.append(Thing(name, kind, spots, moves))

    if "camera" not in hidden:
        add("eye", "point", projection.camera.eye, "eye")
        add("target", "point", projection.camera.target, "target")
    corners = state.volume.corners + origin
    own = control_names(window)
    has_sides = bool(own & set(SIDES))
    if "frustum" not in hidden and state.volume.exists:
        first = "fov_y_deg" if lens.fov_y_deg is not None else "window"
        for name, face in (("near", corners[:4]), ("far", corners[4:])):
            for i in range(4):
                moves = first if name == "near" and lens.fov_y_deg is None else name
                add(f"{name} edge {i}", "edge", face[[i, (i + 1) % 4]], moves)
            if name in own and not drawing.fixed:
                add(f"{name} face", "face", face, name)
    elif has_sides:
        for name, ends in SIDES.items():
            add(f"{name} side", "edge", corners[list(ends)], name)
    for handle, spot in drawing.handles.shown:
        if handle.name in ("corner", "object"):
            kept = np.array([spot])
            made.append(Thing(f"{handle}", "point", kept, handle.setting or "window"))
    for setting, grip in state.grips.items():
        add(setting, "point", grip.point, setting)
        for i in range(len(grip.face)):
            add(f"{setting} edge {i}", "edge", grip.face[[i, (i + 1) % len(grip.face)]], setting)
        if len(grip.face) > 2:
            add(f"{setting} face", "face", grip.face, setting)
    height = state.size_px[1]
    movable = {"eye", "target", "near", "far", *WINDOW} - (
        set() if "frustum" not in hidden else {"near", "far"}
    )
    named = {grip.name: setting for setting, grip in state.grips.items()}
    for key in (*sorted(movable), *(("text", name, 0) for name in named)):
        name, label = key if isinstance(key, str) else key[1], state.board.label(key)
        if label.actor.GetVisibility():
            left, right, bottom, top = label.box_px
            box = np.array([(left, height - top), (right, height - bottom)])
            made.append(
                Thing(f"label {name}", "label", box, named.get(name, WINDOW.get(name, name)))
            )
    return made


def on(thing: Thing, random: np.random.Generator) -> tuple[float, float]:
    """A random place on a thing."""
    spots = thing.spots
    if thing.kind == "point":
        return tuple((spots[0] + random.uniform(-4.0, 4.0, 2)).tolist())  # type: ignore[return-value]
    if thing.kind == "edge":
        return tuple((spots[0] + random.uniform() * (spots[1] - spots[0])).tolist())  # type: ignore[return-value]
    if thing.kind == "label":
        return tuple(random.uniform(spots[0] + 1.0, spots[1] - 1.0).tolist())  # type: ignore[return-value]
    a, b, c = spots[0], *spots[sorted(random.permutation(np.arange(1, len(spots)))[:2])]
    s, t = sorted(random.uniform(size=2))
    return tuple((a + s * (b - a) + (t - s) * (c - a)).tolist())  # type: ignore[return-value]


def away(thing: Thing, place: tuple[float, float]) -> float:
    """How far a place is from a thing, in pixels; 0 inside a label or a face."""
    at, spots = np.array(place), thing.spots
    if thing.kind == "point":
        return float(np.linalg.norm(spots[0] - at))
    if thing.kind == "edge":
        along = spots[1] - spots[0]
        part = np.clip((at - spots[0]) @ along / max(along @ along, 1e-9), 0.0, 1.0)
        return float(np.linalg.norm(spots[0] + part * along - at))
    if thing.kind == "label":
        return 0.0 if ((spots[0] - 1 <= at) & (at <= spots[1] + 1)).all() else math.inf
    rolled = np.roll(spots, -1, axis=0) - spots
    to = at - spots
    turns = rolled[:, 0] * to[:, 1] - rolled[:, 1] * to[:, 0]
    return 0.0 if (turns >= 0).all() or (turns <= 0).all() else math.inf


ORDER = ("point", "edge", "label", "face")


def is_free(
    window: MainWindow, thing: Thing, every: list[Thing], place: tuple[float, float]
) -> bool:
    """Whether nothing lies over a thing here: neither another thing, nor a face of the scene."""
    canvas = window.panes["world"].canvas
    if not (3 <= place[0] < canvas.width() - 3 and 3 <= place[1] < canvas.height() - 3):
        return False
    whole = QPoint(*map(math.floor, place))
    over = window.panes["world"].childAt(canvas.mapTo(window.panes["world"], whole))
    if over is not canvas and not canvas.isAncestorOf(over):
        return False
    near = {"point": POINT_PX, "edge": EDGE_PX, "label": 1.0, "face": 0.0}
    for other in every:
        if other.moves == thing.moves or ORDER.index(other.kind) > ORDER.index(thing.kind):
            continue
        if thing.kind == "point" and other.kind == "point":
            if away(other, place) <= 2.0 * POINT_PX:
                return False
        elif away(other, place) <= near[other.kind]:
            return False
    return not (thing.kind in ("edge", "face") and is_covered(window, thing, place))


def is_covered(window: MainWindow, thing: Thing, place: tuple[float, float]) -> bool:
    """Whether a triangle of the scene may be before the thing: found without the picker."""
    scene, sight = window.shown.scene, world(window).sight
    if scene.surface is None:
        return False
    mesh = scene.surface.triangulate()
    placed = window.store.document.projection.placement.placed(mesh.points + np.array(scene.origin))
    spots = sight.seen(placed.world)[mesh.regular_faces]
    grown = EDGE_PX
    low, high = spots.min(axis=1) - grown, spots.max(axis=1) + grown
    near = ((low <= place) & (place <= high)).all(axis=1)
    return bool(near.any())


def values_of(document: Document, pane: str) -> dict[str, object]:
    """What a drag can change, by name; in the image, a move of the whole camera does not count."""
    projection = document.projection
    owners = [projection.lens, *([] if pane == "image" else [projection.camera])]
    parts = {part.name: getattr(owner, part.name) for owner in owners for part in fields(owner)}
    return {"chain": projection.placement, **parts, **document.settings}


def drag_from(
    window: MainWindow, place: tuple[float, float], way: tuple[int, int], pane: str = "world"
) -> set[str]:
    """Drag with the mouse; return what the drag has changed, and put it back."""
    canvas, before = window.panes[pane].canvas, window.store.document
    values = values_of(before, pane).items()
    at = QPoint(*map(math.floor, place))
    move_mouse(canvas, at, Qt.MouseButton.NoButton)
    QTest.mousePress(canvas, LEFT, pos=at)
    moved = set[str]()
    for part in (0.5, 1.0):
        move_mouse(canvas, at + QPoint(round(part * way[0]), round(part * way[1])), LEFT)
        after = values_of(window.store.document, pane)
        moved |= {name for name, value in values if after[name] != value}
    QTest.mouseRelease(canvas, LEFT, pos=at + QPoint(*way))
    if window.store.document != before:
        window.store.undo()
    window.panes[pane].reset_view()  # a drag may have framed it anew
    settle()
    return moved


def moved_by_keys(window: MainWindow, pane: str) -> set[str]:
    """What the keys change: each thing that Shift+Page Down reaches is held, moved, put back."""
    canvas, cursor, moved = window.panes[pane].canvas, window.cursors[pane], set[str]()
    canvas.setFocus()
    visited = set[str]()
    for _ in range(MOST_THINGS):
        QTest.keyClick(canvas, KEY.Key_PageDown, SHIFT)
        if cursor.text in visited:
            break
        visited.add(cursor.text)
        for ways in ((KEY.Key_Right, KEY.Key_Down), (KEY.Key_Left, KEY.Key_Up)):
            values = values_of(window.store.document, pane).items()
            QTest.keyClick(canvas, KEY.Key_Return)
            for way in ways:
                QTest.keyClick(canvas, way, SHIFT)
            after = values_of(window.store.document, pane)
            moved |= {name for name, value in values if after[name] != value}
            QTest.keyClick(canvas, KEY.Key_Escape)
    settle()
    return moved


def groups(window: MainWindow, pane: str) -> dict[Highlight, list[tuple[int, int]]]:
    """Places of a pane, on a grid, by what lights up under the pointer there."""
    canvas, places = window.panes[pane].canvas, dict[Highlight, list[tuple[int, int]]]()
    for x in range(7, canvas.width() - 7, GRID_PX[pane]):
        for y in range(50, canvas.height() - 7, GRID_PX[pane]):
            drawing = window.panes[pane].drawing
            assert drawing is not None
            places.setdefault(lit_at(drawing, x + 0.5, y + 0.5), []).append((x, y))
    return places


def shares(window: MainWindow) -> dict[str, tuple[int, int, list[Any]]]:
    """For each thing: of how many free places on it, how many drag it, and which do not."""
    random, counts = np.random.default_rng(48), {}
    window.panes["world"].reset_view()
    settle()
    every = things(window)
    for thing in every:
        tried, done, failed = 0, 0, []
        for _ in range(300):
            place = on(thing, random)
            middle = math.floor(place[0]) + 0.5, math.floor(place[1]) + 0.5
            if not is_free(window, thing, every, middle):
                continue
            tried += 1
            # In one of the directions it must move: the way may be across the mouse's.
            moved = any(drag_from(window, place, way) for way in ((28, 9), (-9, 28)))
            done += bool(moved)
            if not moved:
                failed.append(place)
            if tried == PLACES:
                break
        counts[thing.name] = tried, done, failed
    return counts


@pytest.mark.parametrize("name", BUILT_IN if "ALL_SCENES" in os.environ else SAMPLE)
def test_each_free_place_drags_what_it_is_on(make_window: MakeWindow, name: str) -> None:
    window = show_scene(make_window(), name)
    window.slots.make_large("world")
    settle()
    counts = shares(window)
    assert name not in SAMPLE or sum(tried for tried, _, _ in counts.values()) >= 5 * PLACES
    assert not {thing: count for thing, count in counts.items() if count[0] != count[1]}


@pytest.mark.parametrize("name", BUILT_IN if "ALL_SCENES" in os.environ else (SAMPLE[0], *MORE))
def test_what_lights_up_is_dragged_also_by_keys_and_nothing_else(
    make_window: MakeWindow, name: str
) -> None:
    """Whatever a mouse can change in a pane, the keys can change there."""
    window = show_scene(make_window(), name)
    activate(window)
    random, highlighted, wrong = np.random.default_rng(4), Highlighted(window), []
    lacks, count = dict[str, set[str]](), 0
    for kind, pane in window.panes.items():
        window.slots.make_large(kind)
        settle()
        pane.reset_view()
        by_mouse = set[str]()
        ordered = sorted(groups(window, kind).items(), key=lambda group: not group[0])
        for lit, places in ordered:  # a drag on nothing may turn a flat view
            for i in random.permutation(len(places))[: TRIES if lit else 5]:
                x, y = places[i]
                move_mouse(pane.canvas, QPoint(x, y), Qt.MouseButton.NoButton)
                about = lit_at(pane.drawing, x + 0.5, y + 0.5)
                is_lit = highlighted.now == about != NOTHING
                has_own = pane.canvas.cursor().shape() != pane.cursor().shape()
                ways = ((28, 9), (-9, 28)) if about else ((28, 9),)
                moved = set[str]().union(*(drag_from(window, (x, y), way, kind) for way in ways))
                if {is_lit, has_own, bool(moved)} != {bool(about)}:
                    wrong.append((kind, set(about), (x, y), is_lit, has_own, moved))
                by_mouse |= moved
        lacks[kind] = by_mouse - moved_by_keys(window, kind)
        count += len(by_mouse)
    assert not wrong and count
    assert not any(lacks.values()), lacks


@pytest.mark.parametrize("by", ["face", "edge", "label"])
def test_near_is_moved_at_the_first_try(make_window: MakeWindow, by: str) -> None:
    """As by someone who has never seen the program: press on it, and drag it to the scene."""
    window = show_scene(make_window(), "letter-f")
    settle()
    drawing, before = world(window), window.store.document.projection.lens.near
    corners = drawing.sight.seen(drawing.state.volume.corners + drawing.state.origin)
    left, right, bottom, top = drawing.state.board.label("near").box_px
    low = drawing.state.size_px[1] - (bottom + top) / 2.0
    place = {
        "face": corners[:4].mean(axis=0),
        "edge": corners[:2].mean(axis=0),
        "label": np.array([(left + right) / 2.0, low]),
    }[by]
    way = corners[4:].mean(axis=0) - corners[:4].mean(axis=0)
    way *= 30.0 / np.linalg.norm(way)
    canvas, at = window.panes["world"].canvas, QPoint(*map(math.floor, place))
    QTest.mousePress(canvas, LEFT, pos=at)
    for part in (0.2, 0.5, 1.0):
        move_mouse(canvas, at + QPoint(*np.round(part * way).astype(int).tolist()), LEFT)
    QTest.mouseRelease(canvas, LEFT, pos=at)
    assert window.store.document.projection.lens.near > 1.05 * before
    QTest.qWait(300)  # labels that move have faded
    box = drawing.state.board.label("near").box_px
    drawing.layers.place_labels(afresh=True)
    assert drawing.state.board.label("near").box_px == box, "as where the scene opens so"
