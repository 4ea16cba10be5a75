"""Dragging a handle changes the model so that the handle follows the pointer."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import (
    LARGEST,
    Array,
    Camera,
    Frustum,
    Lens,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.refusal import Refusal
from app.picking import handles
from app.picking.handles import (
    EYE,
    NEAR_SIDES,
    TARGET,
    Handle,
    changed,
    dollied,
    nearest,
    panned,
    place,
    present,
    shown,
)
from app.picking.sight import Sight
from tests.support.handles import dragged
from tests.support.lenses import LENSES

SIZE = (800, 700)
# The fields that a handle changes.
FIELDS = {"eye": {"eye"}, "target": {"target"}, "near": {"near"}, "far": {"far"}}
CORNERS = [Handle("corner", "near", (x, y)) for x in (-1.0, 1.0) for y in (-1.0, 1.0)]
FAR_CORNERS = [handle._replace(face="far") for handle in CORNERS]
ALL_MIDDLES = [
    Handle(name, name, at)  # type: ignore[arg-type]
    for name in ("near", "far")
    for at in ((0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 0.0))
]
PLANES = [Handle(name, name, at) for name in ("near", "far") for at in ((0.0, 1.0), (-1.0, 0.0))]  # type: ignore[arg-type]


def looks(camera: Camera) -> Sight:
    """The view of the world pane, from beside and above the model's camera."""
    pane = Camera((-22.0, 14.0, 25.0), camera.target)
    return Sight.of(Projection(pane, Perspective(50.0, 0.1, 1e5), SIZE))


def at(projection: Projection, handle: Handle, drawn: tuple[float, float], sight: Sight) -> Array:
    spot: Array = sight.seen([place(projection, handle, drawn)])[0]
    return spot


def planes(projection: Projection) -> tuple[float, float]:
    """The distances at which the planes are drawn."""
    return projection.lens.near, min(projection.lens.far, 60.0)


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
@pytest.mark.parametrize("shift", [False, True], ids=["plain", "shift"])
def test_the_dragged_handle_ends_under_the_pointer(lens: Lens, shift: bool) -> None:
    """Drag to the pixel of the same handle in another model, 200 times at random."""
    random = np.random.default_rng(7)
    free, tried = [EYE, TARGET, *CORNERS, *FAR_CORNERS], 0
    for _ in range(200):
        eye, target = random.uniform((-5, 1, 5), (8, 8, 12)), random.uniform(-2.0, 2.0, 3)
        projection = Projection(Camera(tuple(eye), tuple(target)), lens, (1280, 720))
        drawn, sight = planes(projection), looks(projection.camera)
        handle = [*free, *PLANES][random.integers(len(free) + len(PLANES))]
        if handle.name == "far" and lens.far == math.inf:
            continue
        start = at(projection, handle, drawn, sight)
        if not ((start >= 0.0) & (start < SIZE)).all():  # outside the pane
            continue
        tried += 1
        pixel = start + random.uniform(-25.0, 25.0, 2)
        rail = None
        if handle.name in ("near", "far"):
            value = getattr(lens, handle.name)
            other = changed(projection, {handle.name: value * random.uniform(0.8, 1.2)})
            rail = at(other, handle, planes(other), sight)
        elif handle.name == "corner" and isinstance(lens, Perspective):
            other = changed(projection, {"fov_y_deg": lens.fov_y_deg * random.uniform(0.7, 1.3)})
            rail = at(other, handle, drawn, sight)
        elif handle.name == "corner" and getattr(lens, "keep", "stretch") != "stretch":
            # On the diagonal through the opposite corner, which stays or is mirrored.
            window = np.array(projection.window).reshape(2, 2)
            fixed = (
                window.mean(axis=1) if shift else window[[0, 1], [int(x < 0) for x in handle.at]]
            )
            window = fixed[:, None] + (window - fixed[:, None]) * random.uniform(0.8, 1.2)
            sides = dict(zip(("left", "right", "bottom", "top"), window.ravel(), strict=True))
            other = replace(projection, lens=replace(lens, keep="stretch", **sides))  # type: ignore[call-arg]
            rail = at(other, handle, drawn, sight)
        elif handle.name == "corner":  # no farther than it may go
            names = "right" if handle.at[0] > 0 else "left", "top" if handle.at[1] > 0 else "bottom"
            left, right, bottom, top = projection.window
            by = random.uniform(-0.3, 0.3, 2) * (right - left, top - bottom)
            sides = {n: getattr(lens, n) + b for n, b in zip(names, by.tolist(), strict=True)}
            rail = at(changed(projection, sides), handle, drawn, sight)
        elif handle.name in ("eye", "target") and shift:
            x, y, z = getattr(projection.camera, handle.name)
            rail = sight.seen([(x, y + random.uniform(-2.0, 2.0), z)])[0]
        x, y = (pixel if rail is None else rail).tolist()
        change = dragged(projection, handle, drawn, sight, (x, y), shift=shift)
        moved = changed(projection, change)
        where = at(moved, handle, planes(moved) if handle.name in FIELDS else drawn, sight)
        assert math.dist(where, (x, y)) <= 0.5, (handle, change)
        if handle.name in FIELDS:
            assert set(change) == FIELDS[handle.name]
        else:
            assert set(change) <= {"fov_y_deg", "left", "right", "bottom", "top"}
        assert moved.camera.up == projection.camera.up and moved.lens.kind == lens.kind
    assert tried > 90


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_a_handle_that_is_not_moved_moves_nothing(lens: Lens) -> None:
    """A drag back to its start keeps every digit."""
    projection = Projection(Camera((1 / 3, 5.0, 9.0), (0.1, 2.2, -1 / 7)), lens, (1280, 720))
    drawn, sight = planes(projection), looks(projection.camera)
    for handle in (EYE, TARGET, *PLANES, *CORNERS, *FAR_CORNERS, *NEAR_SIDES):
        if handle.name == "far" and lens.far == math.inf:
            continue
        x, y = at(projection, handle, drawn, sight).tolist()
        if math.isnan(x):  # behind the eye of the pane
            continue
        change = dragged(projection, handle, drawn, sight, (x, y))
        moved = changed(projection, change)
        if getattr(lens, "keep", "stretch") == "stretch" or handle.name != "corner":
            assert moved == projection, handle
        else:  # the fields become the visible window
            assert moved.window == pytest.approx(projection.window, rel=1e-14)


def test_eye_and_target_keep_their_depth_in_the_pane_and_shift_keeps_the_vertical() -> None:
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0)), LENSES["perspective"])
    sight = looks(projection.camera)
    for handle in (EYE, TARGET):
        x, y = at(projection, handle, (1.0, 30.0), sight).tolist()
        before = np.array(getattr(projection.camera, handle.name))
        pixel = x + 40.0, y - 30.0
        after = dragged(projection, handle, (1.0, 30.0), sight, pixel)[handle.name]
        assert sight.rows[3, :3] @ (after - before) == pytest.approx(0.0, abs=0.02)
        up = dragged(projection, handle, (1.0, 30.0), sight, pixel, shift=True)[handle.name]
        assert up[0] == before[0] and up[2] == before[2] and up[1] > before[1] + 0.3  # type: ignore[index]


def test_the_opposite_corner_stays_or_is_mirrored() -> None:
    lens = Frustum(-0.6, 0.9, -0.4, 0.5, 1.0, 40.0)
    projection = Projection(Camera(), lens, (1280, 720))
    sight = looks(projection.camera)
    handle = Handle("corner", "near", (1.0, 1.0))
    x, y = at(projection, handle, (1.0, 40.0), sight).tolist()
    change = dragged(projection, handle, (1.0, 40.0), sight, (x + 5.0, y - 9.0))
    assert set(change) == {"right", "top"}
    change = dragged(projection, handle, (1.0, 40.0), sight, (x + 5.0, y - 9.0), shift=True)
    assert change["left"] + change["right"] == pytest.approx(0.3)  # type: ignore[operator]
    assert change["bottom"] + change["top"] == pytest.approx(0.1)  # type: ignore[operator]
    for keep in ("x", "y"):
        kept = replace(projection, lens=replace(lens, keep=keep))  # type: ignore[type-var]
        x, y = at(kept, handle, (1.0, 40.0), sight).tolist()
        moved = changed(kept, dragged(kept, handle, (1.0, 40.0), sight, (x + 9.0, y - 9.0)))
        left, right, bottom, top = moved.window
        assert (left, bottom) == pytest.approx((kept.window[0], kept.window[2]), abs=1e-12)
        assert (right - left) / (top - bottom) == pytest.approx(1280 / 720)
        assert right > kept.window[1]


@pytest.mark.parametrize("keep", ["x", "y", "stretch"])
@pytest.mark.parametrize("side", NEAR_SIDES)
def test_a_side_of_the_window_follows_the_pointer_from_where_it_was_grabbed(
    keep: str, side: Handle
) -> None:
    lens = Frustum(-2.2, 1.0, -0.9, 0.9, 3.2, 19.0, keep=keep)  # type: ignore[arg-type]
    projection = Projection(Camera((1.5, 2.4, 8.0), (1.5, 2.4, 0.0)), lens, (1280, 720))
    camera, sight = projection.camera, looks(projection.camera)
    axis = int(side.at[0] == 0.0)
    number = 2 * axis + int(side.at[axis] > 0.0)
    for along in (-0.8, 0.0, 0.6):
        spot = (along, side.at[1]) if axis else (side.at[0], along)
        low, high = np.array(projection.window).reshape(2, 2).T
        x, y = (low + high + (high - low) * spot) / 2.0
        grabbed = camera.eye + np.array([x, y, -3.2]) @ camera.frame
        for by in (-0.3, 0.0, 0.2):
            pixel = tuple(sight.seen([grabbed + by * camera.frame[axis]])[0].tolist())
            change = handles.dragged(projection, side, grabbed, (3.2, 19.0), sight, pixel)
            moved = changed(projection, change).window
            assert moved[number] == pytest.approx(projection.window[number] + by, abs=0.01)


def test_impossible_models_are_refused_and_never_nan() -> None:
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0)), Perspective(45.0, 1.0, 30.0))
    sight, drawn = looks(projection.camera), (1.0, 30.0)
    near, far = Handle("near", "near", (0.0, 1.0)), Handle("far", "far", (0.0, 1.0))
    corner = Handle("corner", "near", (1.0, 1.0))

    def refused(handle: Handle, pixel: tuple[float, float]) -> str:
        with pytest.raises(Refusal) as caught:
            changed(projection, dragged(projection, handle, drawn, sight, pixel))
        return str(caught.value)

    def seen(handle: Handle, **fields: float) -> tuple[float, float]:
        other = replace(projection, lens=replace(projection.lens, **fields))  # type: ignore[arg-type]
        x, y = at(other, handle, planes(other), sight).tolist()
        return x, y

    x, y = seen(near, near=29.999)
    right, down = np.array(seen(near, near=29.9)) - seen(near)
    past = x + right, y + down
    assert "must be less than far, which is 30" in refused(near, past)
    assert "must be greater than 0" in refused(near, (seen(near)[0] - right, seen(near)[1] - down))
    back = 2.0 * np.array(seen(near)) - seen(far)
    assert "must be less than far, which is 1" in refused(far, (back[0], back[1]))
    middle = at(projection, Handle("near", "near"), drawn, sight)
    beyond = 3.0 * middle - 2.0 * at(projection, corner, drawn, sight)
    assert "fov_y_deg = 0: must lie between 0 and 180" in refused(corner, tuple(beyond.tolist()))
    with pytest.raises(Refusal, match="must differ from the eye"):
        changed(projection, {"eye": projection.camera.target})


def test_far_goes_to_infinity_at_its_vanishing_point_and_a_box_cannot() -> None:
    sight = looks(Camera())
    handle = Handle("far", "far", (0.0, 1.0))
    for lens in (LENSES["perspective"], LENSES["frustum"]):
        projection = Projection(Camera(), lens)
        start, other = (
            at(replace(projection, lens=replace(lens, far=far)), handle, (1.0, far), sight)
            for far in (30.0, 1e9)
        )
        x, y = (start + 1.01 * (other - start)).tolist()
        change = dragged(projection, handle, (1.0, 30.0), sight, (x, y))
        assert changed(projection, change).lens.far == math.inf
    projection = Projection(Camera(), LENSES["orthographic"])
    start, other = (at(projection, handle, (1.0, far), sight) for far in (40.0, 1e9))
    x, y = (start + 1.01 * (other - start)).tolist()
    with pytest.raises(Refusal, match="far = inf: must be a finite number"):
        changed(projection, dragged(projection, handle, (1.0, 40.0), sight, (x, y)))


def test_a_plane_at_a_break_moves_in_to_its_drawn_place_or_out_in_proportion() -> None:
    projection = Projection(Camera(), Perspective(45.0, 1.0, 1e6))
    sight, drawn = looks(Camera()), (1.0, 20.0)
    handle = Handle("far", "far", (0.0, 1.0))

    def at_distance(distance: float) -> tuple[float, float]:
        x, y = at(projection, handle, (1.0, distance), sight).tolist()
        return x, y

    inwards = dragged(projection, handle, drawn, sight, at_distance(15.0))
    assert inwards["far"] == pytest.approx(15.0, abs=0.05)
    outwards = dragged(projection, handle, drawn, sight, at_distance(30.0))
    assert outwards["far"] == pytest.approx(1.5e6, rel=0.01)
    endless = replace(projection, lens=Perspective(45.0, 1.0, math.inf))
    assert dragged(endless, handle, drawn, sight, at_distance(30.0))["far"] == math.inf
    assert dragged(endless, handle, drawn, sight, at_distance(15.0))["far"] == inwards["far"]


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_the_picture_follows_the_pointer(lens: Lens) -> None:
    random = np.random.default_rng(3)
    for _ in range(200):
        eye, target = random.uniform((-5, 1, 5), (8, 8, 12)), random.uniform(-2.0, 2.0, 3)
        camera = Camera(tuple(eye), tuple(target), tuple(random.uniform((-1, 1, -1), (1, 2, 1))))
        projection = Projection(camera, lens, (1280, 720))
        shift = random.uniform(-400.0, 400.0, 2)
        moved = changed(projection, panned(projection, (float(shift[0]), float(shift[1]))))
        before, after = (p.trace(camera.target).image for p in (projection, moved))
        assert after - before == pytest.approx(shift, abs=0.1)
        assert moved.camera.frame == pytest.approx(camera.frame, abs=1e-13)
        assert moved.camera.distance == pytest.approx(camera.distance, rel=1e-13)
    assert changed(projection, panned(projection, (0.0, 0.0))) == projection


def test_the_wheel_never_reaches_the_target() -> None:
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.5, 2.2, -0.5)))
    nearer = changed(projection, dollied(projection, 0.5))
    assert nearer.camera.distance == pytest.approx(projection.camera.distance / 2.0)
    assert nearer.camera.frame == pytest.approx(projection.camera.frame, abs=1e-15)
    assert nearer.camera.target == projection.camera.target
    with pytest.raises(Refusal, match="must differ from the eye"):
        for _ in range(100):
            nearer = changed(nearer, dollied(nearer, 0.5))
    assert nearer.camera.distance > 0.0
    with pytest.raises(Refusal, match=r"eye = .*e\+100: must be at most 1e\+100"):
        changed(projection, dollied(projection, LARGEST))


def test_a_plane_s_handle_keeps_off_the_border_where_a_title_may_lie() -> None:
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0)), Perspective(45.0, 1.0, 30.0))
    pane = Camera((40.0, 30.0, 50.0), (0.0, 0.0, -6.0))
    sight = Sight.of(Projection(pane, Perspective(50.0, 0.1, 1e5), SIZE))

    def far_at(width_px: int) -> float:
        found = shown(projection, (1.0, 30.0), sight, (width_px, SIZE[1]), 12.0)
        return next(x for handle, (x, _) in found if handle.name == "far")

    right = far_at(SIZE[0])
    assert far_at(round(right) + 30) == right
    assert far_at(round(right) + 15) < right - 20.0


def test_handles_are_inside_the_pane_and_planes_keep_apart_if_they_can() -> None:
    """From far away the near face is a dot, and only the far corners have handles."""
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0)), Perspective(45.0, 1.0, 30.0))
    random, faces = np.random.default_rng(5), set()
    for _ in range(200):
        away = float(10.0 ** random.uniform(0.3, 3.0))
        pane = Camera(tuple(away * random.uniform(-1, 1, 3)), projection.camera.eye)
        sight = Sight.of(Projection(pane, Perspective(50.0, 0.1, 1e5), SIZE))
        found = shown(projection, (1.0, 30.0), sight, SIZE, 12.0)
        assert all(0.0 <= x < SIZE[0] and 0.0 <= y < SIZE[1] for _, (x, y) in found)
        assert found[0][0] == EYE
        planes_at = [(i, spot) for i, (handle, spot) in enumerate(found) if handle in ALL_MIDDLES]
        for i, spot in planes_at:
            others = [other for _, other in found[:i]]
            middles = [middle for middle in ALL_MIDDLES if middle.name == found[i][0].name]
            places = [at(projection, middle, (1.0, 30.0), sight) for middle in middles]
            possible = [
                where
                for where in places
                if (where >= 0.0).all()
                and (where < SIZE).all()
                and all(math.dist(where, other) >= 12.0 for other in others)
            ]
            assert not possible or all(math.dist(spot, other) >= 12.0 for other in others)
        faces |= {handle.face for handle, _ in found if handle.name == "corner"}
        for handle, spot in found:
            taken = nearest(found, spot, 9.0)
            assert taken == handle or math.dist(dict(found)[taken], spot) == 0.0
            assert nearest(found, (spot[0] + 8.0, spot[1]), 9.0) is not None
            where = at(projection, handle, (1.0, 30.0), sight)
            assert math.dist(where, spot) <= 1e-9
    assert faces == {"near", "far"}
    # The same holds for a wide but low near face.
    low = replace(projection, lens=Orthographic(-3.0, 3.0, -0.1, 0.1, 1.0, 30.0))
    pane_camera = Camera((20.0, 14.0, 25.0), (4.0, 4.0, 6.0))
    sight = Sight.of(Projection(pane_camera, Perspective(50.0, 0.1, 1e5), SIZE))
    found = shown(low, (1.0, 30.0), sight, SIZE, 12.0)
    assert {handle.face for handle, _ in found if handle.name == "corner"} == {"far"}


def test_the_held_handle_stays_visible_over_other_handles() -> None:
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0)), Perspective(45.0, 1.0, 30.0))
    sight = looks(projection.camera)
    crowded = replace(projection, lens=Perspective(45.0, 1e-6, 30.0))  # near is in the eye
    held = Handle("near", "near", (-1.0, 0.0))
    crowd = shown(crowded, (1e-6, 30.0), sight, SIZE, 12.0)
    assert nearest(crowd, dict(crowd)[EYE], 9.0) == EYE  # a point is taken before a plane there
    found = dict(shown(crowded, (1e-6, 30.0), sight, SIZE, 12.0, held))
    assert held in found
    assert [handle.name for handle in found].count("near") == 1


def test_the_nearest_handle_in_reach_is_taken() -> None:
    handles = [(EYE, (3.0, 4.0)), (TARGET, (3.0, 9.0))]
    assert nearest(handles, (3.0, 3.0), 9.0) == nearest(handles[::-1], (3.0, 3.0), 9.0) == EYE
    for out_of_reach in ((math.nan, math.nan), (3.0, 13.0)):
        assert nearest([(EYE, out_of_reach)], (3.0, 3.0), 9.0) is None


def test_fields_are_read_and_written_back() -> None:
    projection = Projection(Camera(), Frustum())
    names = ("eye", "target", "near", "far", "left", "top")
    assert changed(Projection(Camera(), Frustum()), present(projection, names)) == projection
