"""Handles on the camera and the view volume: where they are in a pane, and what a drag changes.

Everything follows from one `Sight`, which turns a pixel into a ray. A handle either moves freely in
a plane (eye, target, a corner of the window), where the ray meets it, or on a rail: a line in the
world along which one number of the model moves it (near, far, a field of view). The rail's picture
is a straight line too, so the point nearest to the pixel solves one linear equation. Beyond the
vanishing point the solution is infinite, and the model decides whether it accepts that. A rail that
is seen end-on has no picture: then up on the screen is outwards.

Whatever point of a plane or an edge was grabbed stays under the pointer: the rail runs through it.

A drag depends on its start and on the mouse's position, not on the path between them.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import repeat
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from app.model import parameters
from app.model.chain import KINDS, Tile
from app.model.lenses.lens import FAR, NEAR
from app.model.lenses.perspective import FOV_Y
from app.model.limits import vector
from app.model.parameter import Parameter
from app.model.parameters import (
    BOTTOM,
    CHAIN,
    LEFT,
    PARAMETERS,
    RIGHT,
    ROTATE,
    SCALE,
    TOP,
    TRANSLATE,
    UP,
)
from app.model.projection import LENSES, Array, Chain, Projection, Vector
from app.model.refusal import REFUSALS, Refusal
from app.picking.sight import Sight, heading

Change: TypeAlias = dict[str, "float | Vector | Chain"]
"""New values for fields of the camera, the lens or the object."""
Spot: TypeAlias = tuple[float, float]  # a position in a pane, in pixels from its top left


class Handle(NamedTuple):
    """A point that can be dragged.

    - `name`: as the table of parameters has it, ``grip`` or ``object``.
    - `face`: the plane of the view volume that it lies on, if any.
    - `at`: position on that face, from -1 to 1: a corner, or a side of the window if one part is 0.
      For the object and up: the drawn length of the axes, twice.
    - `setting`: for a grip: the scene setting that it moves. For the object: one of
      `OBJECT_POINTS`.
    """

    name: str
    face: str = ""
    at: tuple[float, float] = (0.0, 0.0)
    setting: str = ""


EYE, TARGET = Handle(parameters.EYE.handle), Handle(parameters.TARGET.handle)
CORNER = LEFT.handle
# A plane's handle is at the middle of an edge, or in its own middle if no edge is in the pane.
_MIDDLES = ((0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 0.0))
_CORNERS = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
_SIDES = ((0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0))
_NEAR = [Handle(NEAR.handle, NEAR.name, at) for at in _MIDDLES]
_FAR = [Handle(FAR.handle, FAR.name, at) for at in _MIDDLES]
NEAR_CORNERS = [Handle(CORNER, NEAR.name, at) for at in _CORNERS]
FAR_CORNERS = [Handle(CORNER, FAR.name, at) for at in _CORNERS]
NEAR_SIDES = [Handle(CORNER, NEAR.name, at) for at in _SIDES]
_ALL = [EYE, TARGET, *_NEAR, *_FAR, *NEAR_CORNERS, *FAR_CORNERS, *NEAR_SIDES]
_ON_FACES = _ALL[2:]
_AT = np.array([handle.at for handle in _ON_FACES])
_IS_FAR = np.array([handle.face == FAR.name for handle in _ON_FACES])

PLANES = {NEAR.handle: _NEAR, FAR.handle: _FAR}
OBJECT_POINTS = ("origin", "x", "y", "z", "turn")
"""The object's handles: one to move it, three to stretch it along an axis, one to turn it."""
_TURN_OUT = 0.75  # of the axes' length, between x and z
_CAMERA = (EYE.name, TARGET.name)
_OF_OBJECT = {each.handle: each for each in (TRANSLATE, ROTATE, SCALE)}
_PER_PX = 0.1  # values are rounded to this part of a pixel: no hand is steadier
_END_ON = 30.0  # times as far is a pixel on a rail that is seen end-on
_UPWARDS = 1.005  # times as far away for each pixel upwards


def shown(
    projection: Projection,
    drawn: tuple[float, float],
    sight: Sight,
    size_px: tuple[int, int],
    apart_px: float,
    kept: Handle | None = None,
    grips: Mapping[str, Array] = MappingProxyType({}),
    without: frozenset[str] = frozenset(),
    object_reach: float = 0.0,
    up_reach: float = 0.0,
) -> list[tuple[Handle, Spot]]:
    """Return the handles that fit into a pane, with their positions.

    The order is grips, object, eye, target, up, sides, near, far, corners. A plane's handle is
    `apart_px` from the others, and out of the title, if it can be. There are corners of the far
    face, and of the near face unless that is small, then also sides of a window that is given in
    numbers.

    Near and far are drawn at the distances `drawn`. The `kept` handle is being dragged. `grips` are
    world points of the scene's settings, by name. Handles with a name in `without` are omitted. The
    reaches are drawn lengths of the object's axes and of the arrow up; 0 if they are not drawn.
    """
    has_faces = projection.lens.planes is not None  # a free matrix has no planes, no window
    free: dict[Handle, Array] = {Handle("grip", setting=name): at for name, at in grips.items()}
    if object_reach:
        reach = object_reach, object_reach
        points = object_points(projection.placement, object_reach)
        free |= {Handle("object", "", reach, name): point for name, point in points.items()}
    if projection.has_camera:
        free |= {handle: place(projection, handle, drawn) for handle in (EYE, TARGET)}
        if up_reach:
            up = Handle(UP.handle, "", (up_reach, up_reach))
            free[up] = place(projection, up, drawn)
    free = {handle: at for handle, at in free.items() if handle.name not in without}
    places = np.array(list(free.values())).reshape(-1, 3)
    if has_faces:
        places = np.vstack([places, _places(projection, drawn)])
    seen = map(tuple, sight.seen(places).tolist())
    spots: dict[Handle, Any] = dict(zip((*free, *_ON_FACES), seen, strict=False))
    width_px, height_px = size_px
    visible: dict[Handle, Spot] = {}

    def take(handle: Handle, least_px: float = 0.0) -> bool:
        x, y = spot = spots[handle]
        rim_px = 2.0 * least_px  # nor NaN, behind the pane's camera
        if not (rim_px <= x < width_px - rim_px and rim_px <= y < height_px - rim_px):
            return False
        if min(map(math.dist, repeat(spot), visible.values()), default=math.inf) < least_px:
            return False
        visible[handle] = x, y
        return True

    for handle in free:
        take(handle)
    has_window, side_px = has_faces and CORNER not in without, 0.0
    if has_window:
        corners = [spots[handle] for handle in NEAR_CORNERS]
        side_px = min(math.dist(corners[i], corners[i - 1]) for i in range(4))
    has_sides = projection.lens.fov_y_deg is None and side_px >= 4.0 * apart_px
    for handle in NEAR_SIDES if has_sides else ():
        take(handle)
    for name, alternatives in PLANES.items():
        if not has_faces or name in without:
            continue
        if kept is not None and kept.name == name:
            alternatives = [kept]
        for least_px in (apart_px, 0.0):
            if any(take(handle, least_px) for handle in alternatives):
                break
    near_corners = NEAR_CORNERS if side_px >= 2.0 * apart_px else []
    for handle in (*near_corners, *FAR_CORNERS) if has_window else ():
        take(handle)
    if kept is not None and kept in spots and kept.name not in without:
        visible[kept] = spots[kept]
    return list(visible.items())


def nearest(handles: Sequence[tuple[Handle, Spot]], pixel: Spot, within_px: float) -> Handle | None:
    away, best = within_px, None
    for handle, spot in handles:
        distance = math.dist(spot, pixel)
        if distance < away:  # never for NaN
            away, best = distance, handle
    return best


def place(projection: Projection, handle: Handle, drawn: tuple[float, float]) -> Array:
    """World position (3,) of a handle."""
    if handle.name in _CAMERA:
        return np.array(getattr(projection.camera, handle.name))
    if handle.name == UP.handle:
        up = np.array(projection.camera.up)
        return np.asarray(projection.camera.eye + handle.at[0] * up / np.linalg.norm(up))
    if handle.name == "object":
        return object_points(projection.placement, handle.at[0])[handle.setting]
    return np.asarray(_places(projection, drawn)[_ON_FACES.index(handle)])


class _HandleDrag(NamedTuple):
    """A handle, the world point (3,) of it that was grabbed, and the pixel where that shall be."""

    handle: Handle
    grabbed: Array
    sight: Sight
    pixel: Spot


def dragged(
    projection: Projection,
    handle: Handle,
    grabbed: Array,
    drawn: tuple[float, float],
    sight: Sight,
    pixel: Spot,
    *,
    shift: bool = False,
) -> Change:
    """New field values when a handle is dragged to a pixel; `changed` checks them.

    The projection is that when the drag began, when near and far were drawn at the two distances
    `drawn`; `grabbed` is the world point (3,) that shall be at the pixel. `shift` moves the eye or
    the target along the world's vertical instead of in the plane that faces the pane, and a
    window's corner symmetrically about the window's middle.

    Near keeps its window: it moves towards the eye for a `Perspective` lens, and straight along the
    view direction for lenses whose window is given in numbers. If a plane is drawn at a break,
    short of its true distance, a drag inwards puts it where it is drawn, and a drag outwards moves
    it in proportion.
    """
    drag = _HandleDrag(handle, grabbed, sight, pixel)
    if handle.name in _CAMERA:
        before = getattr(projection.camera, handle.name)
        return {handle.name: moved_point(before, sight, pixel, shift)}
    if handle.name == UP.handle:
        camera = projection.camera
        moved = moved_point(vector(grabbed), sight, pixel, shift) - np.array(camera.eye)
        longer = np.linalg.norm(camera.up) / max(float(np.linalg.norm(moved)), 1e-300)
        return {UP.name: vector(np.round(longer * moved, 4))}
    if handle.name == "object":
        return {CHAIN.name: _moved_object(projection.placement, drag, shift)}
    if handle.name in PLANES:
        return {handle.name: _moved_plane(projection, drag, drawn)}
    before = projection.lens.fov_y_deg
    if before is not None:
        return {FOV_Y.name: _opened(projection, before, drag)}
    return _resized(projection, drag, shift)


def way(projection: Projection, handle: Handle, grabbed: Array) -> Array | None:
    """The direction (3,) in the world in which a handle can go; None if it has a choice."""
    if handle.name in PLANES:
        return _rail(projection, handle, grabbed)[1]
    if handle.name == CORNER and projection.lens.fov_y_deg is not None:
        return _across(projection, handle, grabbed)
    if handle.name == CORNER and 0.0 in handle.at:
        return np.array(projection.camera.frame[int(handle.at[0] == 0.0)])
    if handle.name == "object" and handle.setting in "xyz":
        return projection.placement.directions[:, "xyz".index(handle.setting)]
    return None


def slid_grip(
    start: Vector, along: Sequence[float], before: float, grabbed: Array, sight: Sight, pixel: Spot
) -> float | None:
    """The new number of a grip on a rail of `heading`; None if it is seen end-on at 0."""
    value, per_px = _slid(np.array(start), np.array(along), before, grabbed, sight, pixel)
    return _tidy(value, before, per_px) if math.isfinite(value) else None


def panned(projection: Projection, shift_px: tuple[float, float]) -> Change:
    """New eye and target when the image is dragged by (right, down) pixels.

    Points at the target's distance follow the mouse.
    """
    camera, lens = projection.camera, projection.lens
    left, right, bottom, top = projection.window
    away = lens.enlarged(camera.distance)
    width, height = projection.image_size
    per_px = (right - left) * away / width, (top - bottom) * away / height
    across, up = (
        _tidy(sign * unit * px, 0.0, unit)
        for sign, unit, px in zip((-1.0, 1.0), per_px, shift_px, strict=True)
    )
    shift = across * camera.frame[0] + up * camera.frame[1]
    return {name: vector(np.array(getattr(camera, name)) + shift) for name in _CAMERA}


def dollied(projection: Projection, factor: float) -> Change:
    """The eye at `factor` times its distance from the target, in the same direction.

    Raises a `Refusal` if a typed view matrix has replaced the camera.
    """
    if not projection.has_camera:
        raise Refusal("kind", projection.lens.kind, REFUSALS["one-of"], ", ".join(LENSES))
    eye, target = np.array(projection.camera.eye), np.array(projection.camera.target)
    return {EYE.name: vector(target + factor * (eye - target))}


def changed(projection: Projection, change: Mapping[str, float | Vector | Chain]) -> Projection:
    """The projection with new field values.

    Raises a `Refusal` if the camera or the lens cannot have these values.
    """
    parts: dict[str, Change] = {}
    for name, value in change.items():
        if isinstance(value, Chain):
            projection = CHAIN.put(projection, value)
            continue
        parts.setdefault(PARAMETERS[name].part, {})[name] = value
    owners: dict[str, Any] = {part: getattr(projection, part) for part in parts}
    return replace(
        projection, **{part: replace(owners[part], **values) for part, values in parts.items()}
    )


def present(projection: Projection, names: Iterable[str]) -> Change:
    """Current values of fields of the camera, the lens or the object."""
    return {name: PARAMETERS[name].value(projection) for name in names}


def moved_by(projection: Projection, handle: Handle) -> tuple[Parameter, ...]:
    """The parameters that a handle changes; none for a grip."""
    if handle.name == "grip":
        return ()
    if handle.name == "object":
        return (_OF_OBJECT.get(handle.setting, SCALE),)
    if handle.name != CORNER:
        return (PARAMETERS[handle.name],)
    if projection.lens.fov_y_deg is not None:
        return (FOV_Y,)
    right, up = handle.at
    across, upwards = RIGHT if right > 0.0 else LEFT, TOP if up > 0.0 else BOTTOM
    return (across,) if up == 0.0 else (upwards,) if right == 0.0 else (across, upwards)


# --------------------------------------------------------------------------- the object


def object_points(chain: Chain, reach: float) -> dict[str, Array]:
    """World points (3,) of the object's handles, by `OBJECT_POINTS`.

    `reach` is the drawn length of an axis, in lengths of its matrix column.
    """
    matrix, turned = chain.matrix, chain.directions
    origin = matrix[:3, 3]
    tips = [origin + reach * matrix[:3, axis] for axis in range(3)]
    aside = origin + _TURN_OUT * reach * (turned[:, 0] + turned[:, 2])
    return dict(zip(OBJECT_POINTS, (origin, *tips, aside), strict=True))


def _moved_object(chain: Chain, drag: _HandleDrag, shift: bool) -> Chain:
    """Move the origin to the pixel, stretch an axis to it, or turn the object.

    The leftmost tile of the kind changes; without one, a tile is added where the object moves as
    it is seen: a translation at the left, a scale and a rotation next to the object.
    """
    handle, _, sight, pixel = drag
    if handle.setting == "origin":
        return _translated(chain, sight, pixel, shift)
    if handle.setting == "turn":
        return _turned(chain, object_points(chain, handle.at[0]), sight, pixel)
    return _scaled(chain, "xyz".index(handle.setting), drag)


def _of_kind(chain: Chain, new: int, *kinds: str) -> tuple[Chain, int]:
    """The chain with a tile of some kinds, put in at a place if there is none, and its place."""
    place = chain.place_of(*kinds)
    if place is not None:
        return chain, place
    return chain.with_tile(new, Tile(kinds[0], KINDS[kinds[0]].neutral)), new


def _translated(chain: Chain, sight: Sight, pixel: Spot, shift: bool) -> Chain:
    chain, place = _of_kind(chain, 0, "translate")
    before, tile = vector(chain.matrix[:3, 3]), chain.tiles[place]
    moved = moved_point(before, sight, pixel, shift)
    left = Chain(chain.tiles[:place])
    if not left.is_identity or before != tile.numbers:
        away = np.linalg.pinv(left.matrix[:3, :3]) @ np.subtract(moved, before)
        moved = vector([float(f"{part:.12g}") for part in np.add(tile.numbers, away)])
    return chain.with_tile(place, Tile("translate", moved), over=1)


def _scaled(chain: Chain, axis: int, drag: _HandleDrag) -> Chain:
    handle, grabbed, sight, pixel = drag
    chain, place = _of_kind(chain, len(chain.tiles), "scale")
    tile = chain.tiles[place]
    left, right = Chain(chain.tiles[:place]).matrix, Chain(chain.tiles[place + 1 :]).matrix
    part = int(np.abs(right[:3, axis]).argmax())  # the number of the scale that stretches most
    before = tile.numbers[part]
    origin, column, reach = chain.matrix[:3, 3], chain.matrix[:3, axis], handle.at[0]
    if column.any():  # somewhere on the axis
        reach = float(column @ (grabbed - origin)) / float(column @ column)
    along = left[:3, part] * (reach * right[part, axis] + right[part, 3])
    value, per_px = sight.slide(origin + reach * column - before * along, along, pixel)
    numbers = list(tile.numbers)
    numbers[part] = _tidy(value, before, per_px)
    return chain.with_tile(place, Tile("scale", tuple(numbers)), over=1)


def _turned(chain: Chain, points: Mapping[str, Array], sight: Sight, pixel: Spot) -> Chain:
    """The chain after its leftmost rotation has turned as the pixel goes round the origin.

    A new rotation has the axis nearest to the line of sight.
    """
    centre, held = sight.seen([points["origin"], points["turn"]])
    start, end = held - centre, np.array(pixel) - centre
    x, y, _, w = sight.rows
    # The axis towards the pane's camera: along it x and y on the screen do not change.
    toward = np.cross((x - centre[0] * w)[:3], (y - centre[1] * w)[:3])
    angle = math.atan2(start[0] * end[1] - start[1] * end[0], float(start @ end))
    angle_deg = _tidy(math.degrees(angle), 0.0, math.degrees(1.0 / max(math.hypot(*start), 1.0)))
    new = len(chain.tiles) - (chain.tiles[-1:] == chain.on[-1:] and chain.kinds[-1:] == ("scale",))
    facing = np.abs(Chain(chain.tiles[:new]).matrix[:3, :3].T @ toward)
    kinds = [f"rotate {axis}" for axis in "xyz"]
    chain, place = _of_kind(chain, new, kinds[int(facing.argmax())], *kinds, "rotate")
    tile = chain.tiles[place]
    axis = tile.numbers[:3] if tile.kind == "rotate" else np.eye(3)[kinds.index(tile.kind)]
    if Chain(chain.tiles[:place]).matrix[:3, :3] @ axis @ toward < 0.0:
        angle_deg = -angle_deg
    turned_deg = math.remainder(round(tile.numbers[-1] + angle_deg, 9), 360.0)
    return chain.with_tile(place, Tile(tile.kind, (*tile.numbers[:-1], turned_deg)), over=1)


# --------------------------------------------------------------------------- in the view volume


def _places(projection: Projection, drawn: tuple[float, float]) -> Array:
    """World points (18, 3) of all handles on the faces."""
    distances = np.where(_IS_FAR, drawn[1], drawn[0])
    low, high = np.reshape(projection.window, (2, 2)).T
    on_near = (low + high + _AT * (high - low)) / 2.0
    points = np.column_stack([_outwards(projection, on_near, distances[:, None]), -distances])
    return np.asarray(points @ projection.camera.frame + projection.camera.eye)


def _outwards(projection: Projection, on_near: Array, distances: Array) -> Array:
    """Follow projectors from the near plane: x, y of view space at these distances."""
    x, y = projection.lens.outwards(on_near[..., :1], on_near[..., 1:], distances)
    return np.concatenate([x, y], axis=-1)


def _rail(projection: Projection, handle: Handle, grabbed: Array) -> tuple[Array, Array]:
    """World point (3,) of a plane's grabbed point at distance 0, and its step (3,) per distance."""
    lens = projection.lens
    x, y, z = projection.camera.frame @ (grabbed - projection.camera.eye)
    along = np.array([0.0, 0.0, -1.0])
    if handle.face == FAR.name or not lens.window_stays:
        along[:2] = lens.along(x, y, -z)
    start = np.array([x, y, z]) + z * along
    world_from_view = projection.camera.frame.T
    return world_from_view @ start + projection.camera.eye, world_from_view @ along


def _slid(
    start: Array, along: Array, before: float, grabbed: Array, sight: Sight, pixel: Spot
) -> tuple[float, float]:
    """`Sight.slide`; on a rail that is seen end-on, up on the screen is outwards."""
    across = min(sight.per_px(grabbed, axis) for axis in np.eye(3))
    way = heading(along, grabbed)
    if sight.per_px(grabbed, way) * float(np.linalg.norm(way)) < _END_ON * across or not before:
        return sight.slide(start, along, pixel)
    up_px = float(sight.seen([grabbed])[0, 1]) - pixel[1]
    value = before * _UPWARDS ** min(up_px, 1e4)
    return value, abs(value) * (_UPWARDS - 1.0)


def _moved_plane(projection: Projection, drag: _HandleDrag, drawn: tuple[float, float]) -> float:
    handle, grabbed, sight, pixel = drag
    before: float = getattr(projection.lens, handle.name)
    drawn_at = drawn[handle.name == FAR.handle]
    rail = _rail(projection, handle, grabbed)
    distance, per_px = _slid(*rail, drawn_at, grabbed, sight, pixel)
    if projection.lens.central and distance <= 0.0:  # at the eye or behind it
        distance = 0.0 if handle.name == NEAR.handle else projection.lens.near
    if abs(before) > (1.0 + 1e-9) * abs(drawn_at) and abs(distance) >= abs(drawn_at):
        return float(f"{before * (distance / drawn_at):.6g}")
    return _tidy(distance, before, per_px)


def _across(projection: Projection, handle: Handle, grabbed: Array) -> Array:
    """From the axis to a point of the frustum's border, for a half angle of 45 degrees."""
    frame, (right, up) = projection.camera.frame, handle.at
    distance = -float(frame[2] @ (grabbed - projection.camera.eye))
    return np.asarray(distance * (right * projection.aspect * frame[0] + up * frame[1]))


def _opened(projection: Projection, before: float, drag: _HandleDrag) -> float:
    """Field of view that puts a corner at a pixel; the rail is the diagonal of its face."""
    handle, grabbed, sight, pixel = drag
    along, slope = _across(projection, handle, grabbed), math.tan(math.radians(before) / 2.0)
    slope, per_px = sight.slide(grabbed - slope * along, along, pixel)
    slope = max(slope, 0.0)
    fov_y_deg = math.degrees(2.0 * math.atan(slope))
    return _tidy(fov_y_deg, before, math.degrees(2.0 * per_px / (1.0 + slope * slope)))


def _resized(projection: Projection, drag: _HandleDrag, symmetric: bool) -> Change:
    """Window with one corner or side at a pixel, the opposite one fixed or mirrored.

    If the window keeps the image's proportions, a corner runs on the diagonal, a side's grabbed
    point across the side, and the fields become those of the visible window.
    """
    handle, grabbed, sight, pixel = drag
    camera, keep = projection.camera, getattr(projection.lens, "keep", "stretch")
    window = projection.window
    distance = -float(camera.frame[2] @ (grabbed - camera.eye))
    moves = np.array(handle.at) != 0.0
    corner = np.array([window[1] if handle.at[0] > 0.0 else window[0],
                       window[3] if handle.at[1] > 0.0 else window[2]])  # fmt: skip
    opposite = np.array([window[0], window[2]]) + np.array([window[1], window[3]]) - corner
    fixed = (corner + opposite) / 2.0 if symmetric else opposite
    if keep != "stretch":
        x, y = camera.frame[:2] @ (grabbed - camera.eye)
        held = projection.lens.inwards(x, y, distance)

        def in_world(on_near: Array) -> Array:
            view = np.append(_outwards(projection, on_near, np.array(distance)), -distance)
            return np.asarray(camera.frame.T @ view + camera.eye)

        start, end = in_world(np.where(moves, fixed, held)), in_world(np.where(moves, corner, held))
        part, per_px = sight.slide(start, end - start, pixel)
        axis = 0 if keep == "x" else 1  # the other axis follows
        length = float(corner[axis] - fixed[axis])
        value = float(fixed[axis]) + length * part
        kept = _tidy(value, float(corner[axis]), abs(length) * per_px)
        moved = fixed + (corner - fixed) * ((kept - fixed[axis]) / length)
        moved[axis], per_px, moves[:] = kept, 0.0, True
    else:
        moved, per_px = _on_window(projection, sight, distance, pixel)
        if not np.isfinite(moved).all():  # beyond the horizon of the plane
            moved = np.array(handle.at) * math.inf
    change: Change = {}
    for axis, (low, high) in enumerate(((LEFT, RIGHT), (BOTTOM, TOP))):
        if not moves[axis]:
            continue
        side, other = (high, low) if handle.at[axis] > 0.0 else (low, high)
        value = _tidy(float(moved[axis]), float(corner[axis]), per_px)
        change[side.name] = value
        if symmetric:
            mirrored = float(opposite[axis] + (corner[axis] - value))
            change[other.name] = _tidy(mirrored, float(opposite[axis]), per_px)
        elif keep != "stretch":
            change[other.name] = float(opposite[axis])
    return change


def _on_window(
    projection: Projection, sight: Sight, distance: float, pixel: Spot
) -> tuple[Array, float]:
    """Where a pixel's ray meets the face, (2,) on the near plane, and the pixel size there."""
    frame, eye = projection.camera.frame, projection.camera.eye
    point = sight.meets(pixel, -frame[2], np.array(eye) - distance * frame[2])
    per_px = min(sight.per_px(point, axis) for axis in frame[:2])
    across, up = frame[:2] @ (point - eye)
    on_near = np.array(projection.lens.inwards(across, up, distance))
    return on_near, per_px / projection.lens.enlarged(distance)


# --------------------------------------------------------------------------- on the screen


def moved_point(before: Vector, sight: Sight, pixel: Spot, shift: bool) -> Vector:
    """The new position of a world point dragged to a pixel, moved like the eye in `dragged`."""
    point = np.array(before)
    if shift:
        up, per_px = sight.slide(point, np.array([0.0, 1.0, 0.0]), pixel)
        return before[0], _tidy(before[1] + up, before[1], per_px), before[2]
    # The plane of one order, which faces the pane even where the pane shows another space.
    depth, w = sight.rows[2:] @ np.append(point - sight.eye, 1.0)
    facing = w * sight.rows[2, :3] - depth * sight.rows[3, :3]
    moved = sight.meets(pixel, facing, point)
    per_px = min(sight.per_px(moved, axis) for axis in np.eye(3))
    x, y, z = (_tidy(new, old, per_px) for new, old in zip(moved.tolist(), before, strict=True))
    return x, y, z


def _tidy(value: float, before: float, per_px: float) -> float:
    """Round a value to the digits that a drag can distinguish.

    If it rounds to the same number as `before`, the value when the drag began, return `before`.
    `per_px` is the change of the value from one pixel to the next.
    """
    step = _PER_PX * per_px
    if not (math.isfinite(value) and 0.0 < step < math.inf):
        return value
    digits = -math.floor(math.log10(step))
    rounded = round(value, digits)
    return before if rounded == round(before, digits) else rounded
