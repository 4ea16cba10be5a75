"""The projection core: its meaning, its laws, independent oracles, and what it refuses."""

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import FrozenInstanceError, replace
from fractions import Fraction
from functools import partial, reduce
from importlib import import_module
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkCamera

from app.model.lenses.oblique import OBLIQUE_PRESETS, oblique_angles, receding_of
from app.model.lenses.perspective import (
    focal_length_35mm,
    fov_x_from_fov_y,
    fov_y_from_focal_length_35mm,
    fov_y_from_focal_length_e,
    fov_y_from_window,
)
from app.model.limits import OTHER_SIDE, SMALLEST, check_name
from app.model.projection import (
    DEPTH_RANGES,
    LARGEST,
    LARGEST_IMAGE_PX,
    PLANES,
    Array,
    Camera,
    FreeMatrix,
    Frustum,
    Intrinsics,
    Lens,
    Oblique,
    Orbit,
    Orthographic,
    Perspective,
    Projection,
    kinds,
)
from app.model.refusal import REFUSALS, Refusal, shown_limits, six_digits
from tests.oracles import exact
from tests.support.lenses import LENSES, ONE_OF_EACH, SLANTED, at_distance, in_world, made
from tests.support.marked import marked

EPS = float(np.finfo(np.float64).eps)
QUICK = settings(max_examples=60)


def homogeneous(points: Array) -> Array:
    return np.column_stack([points, np.ones(len(points))])


PROJECTIONS = [
    Projection(SLANTED, LENSES[lens], (1280, 720), depth)
    for lens, depth in product(LENSES, DEPTH_RANGES)
]


# --------------------------------------------------------------------------- meaning


@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_meaning(lens: Lens, depth: str) -> None:
    """Right goes to +x, up to +y, near and far to the ends of the depth range."""
    projection = Projection(SLANTED, lens, (1280, 720), depth)
    near, z_near, z_far = lens.near, *DEPTH_RANGES[depth]
    far = 1e14 if lens.far == math.inf else lens.far  # as good as infinitely far
    depth_near, depth_far = (1.0, 0.0) if depth == "reversed" else (0.0, 1.0)
    meaning = [
        # a point of view space                    NDC                   image         depth
        (at_distance(projection, near), (0.0, 0.0, z_near), (640.0, 360.0), depth_near),
        (at_distance(projection, near, 1.0), (1.0, 0.0, z_near), (1280.0, 360.0), depth_near),
        (at_distance(projection, near, 0.0), (-1.0, 0.0, z_near), (0.0, 360.0), depth_near),
        (at_distance(projection, near, 0.5, 1.0), (0.0, 1.0, z_near), (640.0, 0.0), depth_near),
        (at_distance(projection, near, 0.5, 0.0), (0.0, -1.0, z_near), (640.0, 720.0), depth_near),
        (at_distance(projection, near, 0.0, 1.0), (-1.0, 1.0, z_near), (0.0, 0.0), depth_near),
        (at_distance(projection, near, 1.0, 0.0), (1.0, -1.0, z_near), (1280.0, 720.0), depth_near),
        (at_distance(projection, far), (0.0, 0.0, z_far), (640.0, 360.0), depth_far),
        (at_distance(projection, far, 0.0, 1.0), (-1.0, 1.0, z_far), (0.0, 0.0), depth_far),
        (at_distance(projection, far, 0.75, 0.25), (0.5, -0.5, z_far), (960.0, 540.0), depth_far),
    ]
    points_view, points_ndc, points_image, depths = map(np.array, zip(*meaning, strict=True))
    points_world = in_world(projection.camera, points_view)
    trace = projection.trace(points_world)
    scale = np.abs(points_view).max(axis=-1, keepdims=True)
    np.testing.assert_allclose(trace.view / scale, points_view / scale, atol=1e-13)
    np.testing.assert_allclose(trace.ndc, points_ndc, atol=1e-12)
    np.testing.assert_allclose(trace.image, points_image, atol=1e-9)
    np.testing.assert_allclose(trace.depth, depths, atol=1e-12)
    # The matrices that a GPU is given say the same.
    clip = homogeneous(points_world) @ projection.clip_from_world.T
    np.testing.assert_allclose(clip / scale, trace.clip / scale, atol=1e-12)
    ndc = clip[:, :3] / clip[:, 3:]
    np.testing.assert_allclose(ndc, points_ndc, atol=1e-12)
    image = homogeneous(ndc) @ projection.image_from_ndc.T
    np.testing.assert_allclose(image[:, :2], points_image, atol=1e-9)
    np.testing.assert_allclose(image[:, 2], depths, atol=1e-12)
    assert (clip[:, 3] > 0.0).all()
    back = projection.world_from_image(np.column_stack([points_image, depths])[:7])
    np.testing.assert_allclose(back, points_world[:7], atol=1e-12)


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_outside_names_the_planes_that_a_point_lies_beyond(lens: Lens) -> None:
    projection, near, far = Projection(SLANTED, lens), lens.near, lens.far
    middle = near + 1.0  # a distance between the planes, for every lens of the table
    points = {
        (): at_distance(projection, middle),
        ("near",): at_distance(projection, near - 0.01),
        ("left",): at_distance(projection, middle, -0.5),
        ("right",): at_distance(projection, middle, 1.5),
        ("bottom",): at_distance(projection, middle, 0.5, -0.5),
        ("top",): at_distance(projection, middle, 0.5, 1.5),
        ("right", "top"): at_distance(projection, middle, 1.5, 1.5),
    }
    if far != math.inf:
        points["far",] = at_distance(projection, far + 0.01)
    points_world = in_world(projection.camera, [*points.values()])
    for depth in DEPTH_RANGES:
        outside = replace(projection, depth=depth).trace(points_world).outside
        assert [tuple(np.array(PLANES)[row].tolist()) for row in outside] == list(points)


@pytest.mark.parametrize("kind", ["frustum", "orthographic"])
def test_what_lies_on_a_plane_is_inside(kind: str) -> None:
    """On an axis, where every digit is exact: 45 degrees to each side, or a window of 8 by 8."""
    window = (-4, 4, -4, 4, 1, 8) if kind == "orthographic" else (-1, 1, -1, 1, 1, 8)
    on = [(0, 0, -1), (0, 0, -8), (4, 0, -4), (-4, 0, -4), (0, 4, -4), (0, -4, -4)]
    assert (
        not Projection(AXIS, type(ONE_OF_EACH[kind])(*window), (800, 800)).trace(on).outside.any()
    )


def test_shape_of_a_trace_is_the_shape_of_its_points() -> None:
    for shape in ((), (7,), (0,), (2, 3)):
        trace = Projection().trace(np.ones((*shape, 3)))
        assert [array.shape for array in trace] == [
            (*shape, 3), (*shape, 3), (*shape, 4), (*shape, 3), (*shape, 2),
            shape, shape, (*shape, 6),
        ]  # fmt: skip


# --------------------------------------------------------------------------- hand-computed points


# --------------------------------------------------------------------------- laws


def logarithmic(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(math.log10(low), math.log10(high)).map(lambda power: 10.0**power)


@st.composite
def directions(draw: st.DrawFn) -> tuple[float, float, float]:
    turn, height = draw(st.floats(0.0, 2.0 * math.pi)), draw(st.floats(-1.0, 1.0))
    level = math.sqrt(1.0 - height * height)
    return level * math.cos(turn), height, level * math.sin(turn)


@st.composite
def cameras(draw: st.DrawFn) -> Camera:
    target = draw(st.tuples(*[st.floats(-100.0, 100.0)] * 3))
    backward = draw(directions())
    # Up at 4 degrees from the view direction, or more.
    u = np.cross(backward, np.eye(3)[np.argmin(np.abs(backward))])
    u /= np.linalg.norm(u)
    turn, tilt = draw(st.floats(-math.pi, math.pi)), draw(st.floats(-1.5, 1.5))
    level = math.cos(turn) * u + math.sin(turn) * np.cross(backward, u)
    up = math.cos(tilt) * level + math.sin(tilt) * np.array(backward)
    distance = draw(logarithmic(0.1, 1e4))
    return Camera(np.add(target, np.multiply(distance, backward)), target, up)


def mostly(usual: st.SearchStrategy[float], *extremes: float) -> st.SearchStrategy[float]:
    """Usual values, and every third time one from the ends of what is allowed."""
    return st.one_of(usual, usual, st.sampled_from(extremes))


AXIS = Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0))
"""View space is the world: no digit of a point is lost, so that every lens can be held to."""
UP_TO_180 = math.nextafter(180.0, 0.0)


@st.composite
def planes(draw: st.DrawFn, *, wild: bool, finite: bool = False) -> tuple[float, float]:
    ends = (1e-180, 1e-30, 1e30, 1e60) if wild else (1e-3, 1e3)
    near = draw(mostly(logarithmic(1e-3, 1e3), *ends))
    usual = logarithmic(1.01, 1e6)
    far = near * draw(mostly(usual, 1.0 + 1e-12, 1e9)) if wild else near * draw(usual)
    return near, far if finite else draw(st.sampled_from([far, far, math.inf]))


@st.composite
def perspectives(draw: st.DrawFn, *, wild: bool = False) -> Perspective:
    ends = (1e-90, 1e-4, 179.99, UP_TO_180) if wild else (1.0, 170.0)
    fov_y_deg = draw(mostly(st.floats(1.0, 170.0), *ends))
    return Perspective(fov_y_deg, *draw(planes(wild=wild)))


@st.composite
def windows(draw: st.DrawFn, unit: float, *, wild: bool) -> tuple[float, float, float, float]:
    """Windows up to a few hundred of their widths off the axis."""
    ends = (1e-6, 1e6, 1e-80) if wild else (0.1, 10.0)
    width = unit * draw(mostly(logarithmic(0.1, 10.0), *ends))
    height = width * draw(mostly(logarithmic(0.1, 10.0), *((1e-6, 1e6) if wild else (0.1,))))
    left, bottom = draw(st.tuples(*[mostly(st.floats(-1.5, 0.5), -0.5, 100.0)] * 2))
    return left * width, (left + 1.0) * width, bottom * height, (bottom + 1.0) * height


KEEPS = st.sampled_from(["stretch", "x", "y"])


@st.composite
def frusta(draw: st.DrawFn, *, wild: bool = False) -> Frustum:
    near, far = draw(planes(wild=wild))
    return Frustum(*draw(windows(near, wild=wild)), near, far, draw(KEEPS))


@st.composite
def boxes(draw: st.DrawFn, *, wild: bool) -> tuple[float, ...]:
    ends = (1e-30, 1e30) if wild else (1e-2, 1e2)
    unit = draw(mostly(logarithmic(0.1, 1e3), *ends))
    near = unit * draw(mostly(st.floats(-10.0, 10.0), 0.0, -1e3))
    far = near + unit * draw(logarithmic(0.1, 10.0))
    return *draw(windows(unit, wild=wild)), near, far, draw(KEEPS)


@st.composite
def orthographics(draw: st.DrawFn, *, wild: bool = False) -> Orthographic:
    return Orthographic(*draw(boxes(wild=wild)))


@st.composite
def obliques(draw: st.DrawFn, *, wild: bool = False) -> Oblique:
    ends = (1e-4, 90.0, 179.9999) if wild else (30.0, 45.0, 90.0)
    angles = draw(st.tuples(*[mostly(st.floats(20.0, 160.0), *ends)] * 2))
    return Oblique(*draw(boxes(wild=wild)), *angles)


@st.composite
def projections(
    draw: st.DrawFn, *lenses: Callable[..., st.SearchStrategy[Lens]], wild: bool = True
) -> Projection:
    """Everyday lenses on any camera, and lenses up to the ends of what is allowed on an axis."""
    lens = draw(st.sampled_from(lenses or (perspectives, frusta, orthographics, obliques)))
    size = draw(st.tuples(*[mostly(st.integers(100, 4000), 1, LARGEST_IMAGE_PX)] * 2))
    depth = draw(st.sampled_from(sorted(DEPTH_RANGES)))
    if wild and draw(st.booleans()):
        return Projection(AXIS, draw(lens(wild=True)), size, depth)
    return Projection(draw(cameras()), draw(lens()), size, depth)


def points_in_view(projection: Projection, parts: Array) -> Array:
    """World points of the view volume; parts (n, 3) in (0, 1) across, along and deep."""
    lens, points = projection.lens, []
    far = lens.far if lens.far != math.inf else 1e3 * lens.near
    for across, along, deep in np.asarray(parts):
        if lens.parallel:
            distance = lens.near + (far - lens.near) * deep
        else:
            distance = lens.near * (far / lens.near) ** deep
        points.append(at_distance(projection, distance, across, along))
    return in_world(projection.camera, points)


def rounding_ndc(projection: Projection) -> float:
    """How far a point moves in NDC by the rounding of numbers of float64.

    World coordinates are rounded in units of their distance from the origin, beside a picture that
    may be tiny; the place in a window in units of its distance from the axis, and of the shear.
    """
    lens, (left, right, bottom, top) = projection.lens, projection.window
    width, height = right - left, top - bottom
    depth, shear = lens.far - lens.near, projection.lens.shear
    off = max(abs(left) + abs(right), abs(shear[0]) * depth if shear[0] else 0.0) / width
    off = max(off, (abs(bottom) + abs(top)) / height)
    off = max(off, abs(shear[1]) * depth / height if shear[1] else 0.0)
    if lens.parallel:  # the planes' distances are rounded too
        off = max(off, max(abs(lens.near), abs(lens.far)) / depth)
        off *= 1.0 + max(map(abs, shear)) * max(abs(lens.near), abs(lens.far)) / min(width, height)
    else:
        off = max(off, lens.near / depth)
    if projection.camera == AXIS:
        return EPS * off
    if not lens.parallel:
        depth = min(depth, lens.near)
    size = np.abs([projection.camera.eye, projection.camera.target]).max()
    size += max(map(abs, (left, right, bottom, top)))
    if lens.parallel:
        size += max(abs(lens.near), abs(lens.far)) * (1.0 + max(map(abs, shear)))
    leaning = 1.0 + max(map(abs, shear))
    off += projection.stretch
    return EPS * off + EPS * float(size * leaning * (1.0 / width + 1.0 / height + 1.0 / depth))


PARTS = st.tuples(*[st.floats(0.02, 0.98)] * 3)


@given(projections())
@QUICK
def test_world_from_clip_undoes_clip_from_world(projection: Projection) -> None:
    origin = np.array((3.0, 1.0, 2.0))
    lens, lens_back = np.abs(projection.clip_from_view), np.abs(projection.view_from_clip)
    for there, back, offset in (
        (projection.clip_from_view, projection.view_from_clip, None),
        (projection.clip_from_world, projection.world_from_clip_at((0.0, 0.0, 0.0)), np.zeros(3)),
        (projection.clip_from_local(origin), projection.world_from_clip_at(origin), origin),
    ):
        # What rounding can do at most: the product of the factors' absolute values.
        size, size_back = lens, lens_back
        if offset is not None:
            shift, turn = np.eye(4), np.abs(projection.view_rotation)
            shift[:3, 3] = np.abs(offset - projection.camera.eye)
            size, size_back = lens @ turn @ shift, shift @ turn.T @ lens_back
        np.testing.assert_array_less(
            np.abs(there @ back - np.eye(4)), 20.0 * EPS * (size @ size_back) + 1e-300
        )
        np.testing.assert_array_less(
            np.abs(back @ there - np.eye(4)), 20.0 * EPS * (size_back @ size) + 1e-300
        )


@given(
    st.tuples(*[st.floats(-100.0, 100.0)] * 3),
    st.floats(-180.0, 180.0),
    st.floats(-89.9, 89.9),
    logarithmic(0.5, 1e4),
    st.floats(-179.9, 179.9),
)
@example((1.0, 2.0, 3.0), 0.0, 90.0, 5.0, 0.0)
@example((1.0, 2.0, 3.0), 40.0, 90.0, 5.0, 0.0)
@example((1.0, 2.0, 3.0), 40.0, -90.0, 5.0, 0.0)
@QUICK
def test_orbit_round_trip(
    target: tuple, azimuth: float, elevation: float, distance: float, roll: float
) -> None:
    camera = Camera.from_orbit(target, Orbit(azimuth, elevation, distance, roll))
    orbit = camera.orbit
    found = [math.remainder(orbit[0] - azimuth, 360.0), orbit[1] - elevation]
    found += [(orbit[2] - distance) / distance, math.remainder(orbit[3] - roll, 360.0)]
    # An azimuth near the pole is known less well; a roll below 1e-9 degrees is read as none.
    level = 1.0 if abs(elevation) == 90.0 else math.cos(math.radians(elevation))
    np.testing.assert_allclose(found, 0.0, atol=2e-9 + 1e-10 / level)
    again = Camera.from_orbit(target, orbit)
    np.testing.assert_allclose(again.eye, camera.eye, rtol=0.0, atol=1e-11 * (100.0 + distance))
    np.testing.assert_allclose(again.frame, camera.frame, rtol=0.0, atol=2e-11 + 1e-11 / level)


def test_orbit_angles_mean_what_they_say() -> None:
    def placed(*orbit: float) -> Camera:
        return Camera.from_orbit((0.0, 0.0, 0.0), Orbit(*orbit))

    assert placed(0, 0, 5).eye == (0.0, 0.0, 5.0)
    assert placed(90, 0, 5).eye == (5.0, 0.0, 0.0)
    assert placed(-180, 0, 5).eye == (0.0, 0.0, -5.0)
    assert placed(0, 90, 5).eye == (0.0, 5.0, 0.0)
    assert placed(720 + 90, 0, 5).eye == (5.0, 0.0, 0.0)
    np.testing.assert_allclose(placed(0, 0, 5).frame[0], [1, 0, 0], atol=1e-15)
    # Rolled clockwise by 90 degrees, the camera's right side points down.
    np.testing.assert_allclose(placed(0, 0, 5, 90).frame[0], [0, -1, 0], atol=1e-15)
    # Looking straight down, the picture's top is what the azimuth turned away from.
    np.testing.assert_allclose(placed(0, 90, 5).frame[1], [0, 0, -1], atol=1e-15)
    assert placed(30, 20, 5).up == (0.0, 1.0, 0.0)
    assert placed(30, 20, 5).orbit.roll_deg == 0.0


@pytest.mark.parametrize("azimuth", [1e15, 1e30, -1e100])
def test_an_angle_of_many_turns_is_its_rest(azimuth: float) -> None:
    rest = float(Fraction(azimuth) % 360)
    many = Camera.from_orbit((0.0, 0.0, 0.0), Orbit(azimuth, 10.0, 5.0))
    once = Camera.from_orbit((0.0, 0.0, 0.0), Orbit(rest, 10.0, 5.0))
    np.testing.assert_allclose(many.eye, once.eye, atol=1e-14)


@given(st.floats(0.5, 179.5), logarithmic(0.1, 10.0))
@QUICK
def test_fields_of_view_come_back(fov_y_deg: float, aspect: float) -> None:
    fov_x_deg = fov_x_from_fov_y(fov_y_deg, aspect)
    assert fov_x_from_fov_y(fov_x_deg, 1.0 / aspect) == pytest.approx(fov_y_deg, rel=1e-11)
    focal_length_mm = focal_length_35mm(fov_y_deg, aspect)
    assert fov_y_from_focal_length_35mm(focal_length_mm, aspect) == pytest.approx(
        fov_y_deg, rel=1e-13
    )
    # The angle is the one that the picture's side is seen under.
    width = 2.0 * math.tan(math.radians(fov_x_deg / 2.0))
    height = 2.0 * math.tan(math.radians(fov_y_deg / 2.0))
    assert width / height == pytest.approx(aspect, rel=1e-9)


# --------------------------------------------------------------------------- the same picture


def test_the_window_of_a_parallel_lens_follows_the_images_shape_as_the_field_of_view_does() -> None:
    camera = Camera.from_orbit((1.0, 2.0, 3.0), Orbit(30.0, 20.0, 8.0))
    wide = Projection(camera, Perspective(40.0, 0.01, 1e4), (1280, 720))
    u, v, _ = camera.frame
    cross = camera.target + np.array([u, -u, v, -v])
    flat, seen = (
        replace(each, image_size=(720, 720)).trace(cross).image
        for each in (wide.with_lens("orthographic"), wide)
    )
    np.testing.assert_allclose(flat, seen, rtol=0.0, atol=1e-8)


def test_with_lens_always_gives_a_lens_that_works() -> None:
    infinite = Projection(lens=Perspective(45.0, 1.0, math.inf))
    for kind in [kind for kind, lens in ONE_OF_EACH.items() if lens.parallel]:
        flat = infinite.with_lens(kind)
        assert math.isfinite(flat.lens.far)
        assert flat.lens.far > infinite.camera.distance  # the target is still in it
    assert infinite.with_lens("frustum").lens.far == math.inf
    # The target is far in front of near: the box still has a depth.
    close = Projection(Camera((0.0, 0.0, 1.0), (0.0, 0.0, 0.5)), Perspective(45.0, 10.0, math.inf))
    assert all(close.with_lens(kind).lens.far > 10.0 for kind in ("orthographic", "oblique"))
    for near, far in (
        (-5.0, 20.0), (-5.0, -3.0), (0.0, 20.0), (-1e-3, 0.0), (-5.0, 0.0), (1e-290, 20.0),
    ):  # fmt: skip
        for flat in (Orthographic(near=near, far=far), Oblique(near=near, far=far)):
            for kind in ("perspective", "frustum"):
                changed = Projection(lens=flat).with_lens(kind)
                assert 0.0 < changed.lens.near < changed.lens.far
                seen = changed.trace(changed.camera.target)
                assert far < changed.camera.distance or not seen.outside[:2].any()
    same = Projection()
    assert same.with_lens("perspective") is same


@given(projections(wild=False), st.sampled_from(sorted(ONE_OF_EACH)), st.lists(PARTS, max_size=4))
@QUICK
def test_with_lens_keeps_the_picture_of_the_plane_through_the_target(
    projection: Projection, kind: str, parts: list
) -> None:
    """For every pair of lenses, and all of the picture between two perspective ones."""
    lens, distance = projection.lens, projection.camera.distance
    changed = projection.with_lens(kind)
    assert changed.lens.kind == kind
    assert (changed.camera, changed.image_size) == (projection.camera, projection.image_size)
    if lens.window_stays and not changed.lens.window_stays:
        # It may have no window off the axis, and none of another shape: only the height is kept.
        (_, _, bottom, top), (_, _, low, high) = projection.window, changed.window
        scale = 1.0 if not lens.parallel else distance / changed.lens.near
        # An angle near 180 degrees is rounded, and its tangent magnifies that.
        rounded = np.finfo(float).eps * math.pi * (high - low) / changed.lens.near
        assert (high - low) * scale == pytest.approx(top - bottom, rel=1e-9 + rounded)
        return
    there = [at_distance(projection, distance, x, y) for x, y, _ in parts]
    if not (lens.parallel or changed.lens.parallel):
        there += [at_distance(projection, 1.5 * lens.near * z, x, y) for x, y, z in parts]
    before = projection.trace(in_world(projection.camera, [(0.0, 0.0, -distance), *there]))
    after = changed.trace(before.world)
    tolerance = 1e-9 + 1e3 * (rounding_ndc(projection) + rounding_ndc(changed))
    # Outside the picture, where the axis may be for a window far off it, relative.
    np.testing.assert_allclose(after.ndc[:, :2], before.ndc[:, :2], rtol=tolerance, atol=tolerance)
    if (lens.near, lens.far) == (changed.lens.near, changed.lens.far) and len(there) > len(parts):
        np.testing.assert_allclose(after.depth, before.depth, rtol=1e-12, atol=1e-12)


@given(projections(), st.sampled_from(sorted(ONE_OF_EACH)))
@QUICK
def test_with_lens_gives_a_lens_or_a_reason(projection: Projection, kind: str) -> None:
    """Only at the ends of what is allowed is there none; then the field is named."""
    try:
        changed = projection.with_lens(kind)
    except Refusal as error:
        assert projection.camera == AXIS, error  # never in an everyday world
    else:
        assert changed.lens.kind == kind


def other_planes(lens: Lens, factor: float, ratio: float) -> tuple[float, float]:
    """Near and far elsewhere, also beyond the lens' own."""
    if lens.parallel:
        near = lens.near + (factor - 1.0) * (lens.far - lens.near)
        return near, near + ratio * (lens.far - lens.near)
    return factor * lens.near, ratio * factor * lens.near


@given(projections(), st.floats(0.1, 3.0), logarithmic(1.1, 100.0), PARTS)
@QUICK
def test_between_other_planes_the_picture_is_the_same(
    projection: Projection, factor: float, ratio: float, part: tuple
) -> None:
    near, far = other_planes(projection.lens, factor, ratio)
    try:
        other = projection.between(near, far)
    except Refusal:  # sheared so far off that its window is lost in the digits there
        assert rounding_ndc(projection) > 1e-3
        return
    assert (other.lens.near, other.lens.far) == (near, far)
    assert other.lens.kind == projection.lens.kind
    points = points_in_view(projection, np.array([part]))
    tolerance = 1e-11 + 1e3 * (rounding_ndc(projection) + rounding_ndc(other))
    before, after = projection.trace(points).ndc[:, :2], other.trace(points).ndc[:, :2]
    np.testing.assert_allclose(after, before, rtol=0.0, atol=tolerance)


@example(
    Projection(
        AXIS, Oblique(0.0, 1e6, -5e5, 5e5, 0.0, 1.0, alpha_deg=20.0, beta_deg=20.0), (100, 100)
    ),
    2.0,
    10.0,
)
@given(projections(), st.floats(0.1, 3.0), logarithmic(1.1, 100.0))
@QUICK
def test_the_matrices_between_other_planes_are_those_of_the_lens_there(
    projection: Projection, factor: float, ratio: float
) -> None:
    near, far = other_planes(projection.lens, factor, ratio)
    try:
        other = replace(projection.between(near, far), depth="reversed")
    except Refusal:
        return
    rounding = 1e3 * (rounding_ndc(projection) + rounding_ndc(other))
    found = projection.matrices_between(near, far)
    # A row that makes NDC errs by parts of NDC, however small its own numbers are: those of a
    # window of a million are 1e-6. A row that makes view coordinates errs by parts of its own size.
    for matrix, expected, least in zip(
        found, (other.clip_from_view, other.view_from_clip), (1.0, 0.0), strict=True
    ):
        size = np.abs(expected).max(axis=1, keepdims=True)
        off = np.abs(matrix - expected)
        assert (off <= 1e-12 * size + rounding * np.maximum(size, least)).all()


def test_the_matrices_between_reach_infinity_and_come_back() -> None:
    """By hand: a lens of 90 degrees, cut at 2 and 8, and at 2 and infinity."""
    for whole in (Perspective(90.0, 1.0, 4.0), Perspective(90.0, 1.0, math.inf)):
        projection = Projection(Camera(), whole, (100, 100))
        for far, (a, b), (c, d) in (
            (8.0, (1 / 3, 8 / 3), (3 / 8, 1 / 8)),
            (math.inf, (0.0, 2.0), (0.5, 0.0)),
        ):
            clip_from_view, view_from_clip = projection.matrices_between(2.0, far)
            expected = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, a, b], [0, 0, -1, 0]]
            np.testing.assert_allclose(clip_from_view, expected, rtol=0, atol=1e-15)
            expected = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, -1], [0, 0, c, d]]
            np.testing.assert_allclose(view_from_clip, expected, rtol=0, atol=1e-15)


# --------------------------------------------------------------------------- intrinsics, presets


@given(projections(perspectives, frusta), st.lists(PARTS, min_size=1, max_size=4))
@QUICK
def test_intrinsics_are_k_of_opencv(projection: Projection, parts: list) -> None:
    """K [X Y Z]/Z with x right, y down, z forward; its first pixel's centre is 0, ours is 0.5."""
    fx, fy, cx, cy = intrinsics = projection.intrinsics
    trace = projection.trace(points_in_view(projection, np.array(parts)))
    x, y, z = (trace.view * (1.0, -1.0, -1.0)).T
    plain = np.column_stack([fx * x / z + cx, fy * y / z + cy]) + 0.5
    size = np.array(projection.image_size) * (1.0 + 1e4 * rounding_ndc(projection))
    size = size + np.abs([cx, cy])
    assert (np.abs(plain - trace.image) <= 1e-11 * size).all()
    # Typed in again, it is the same lens.
    try:
        again = projection.with_intrinsics(intrinsics)
    except Refusal:
        assert projection.camera == AXIS
        return
    assert again.lens.near == projection.lens.near
    rtol = 1e-9 + 1e2 * rounding_ndc(projection)  # a window's sides are float64, as they are typed
    np.testing.assert_allclose(again.intrinsics, intrinsics, rtol=rtol, atol=rtol * size.max())
    if isinstance(projection.lens, Perspective):
        assert isinstance(again.lens, Perspective)
        assert again.lens.fov_y_deg == pytest.approx(projection.lens.fov_y_deg, rel=1e-13)


def test_intrinsics_of_a_calibrated_camera() -> None:
    # 640 x 480, 500 pixels of focal length: a point 1 right, 0.5 down, 2 away is seen at
    # u = 500 * 1/2 + 310.25 = 560.25, v = 510 * 0.5/2 + 250.5 = 378, from the first pixel's
    # centre; half a pixel more from its corner.
    given_k = Intrinsics(500.0, 510.0, 310.25, 250.5)
    projection = Projection(AXIS, image_size=(640, 480)).with_intrinsics(given_k)
    assert isinstance(projection.lens, Frustum)
    image = projection.trace((1.0, -0.5, -2.0)).image
    np.testing.assert_allclose(image, [560.75, 378.5], atol=1e-11)
    np.testing.assert_allclose(projection.intrinsics, given_k, rtol=1e-14)
    # Square pixels and the axis in the middle, (640 - 1)/2: the symmetric lens.
    centred = projection.with_intrinsics(Intrinsics(480.0, 480.0, 319.5, 239.5))
    assert isinstance(centred.lens, Perspective)
    assert centred.lens.fov_y_deg == pytest.approx(math.degrees(2 * math.atan(0.5)), rel=1e-15)
    assert centred.intrinsics == pytest.approx((480.0, 480.0, 319.5, 239.5), rel=1e-15)
    # A parallel lens gets a near plane before the eye.
    flat = Projection(AXIS, Orthographic(near=-3.0, far=9.0)).with_intrinsics(given_k)
    assert 0.0 < flat.lens.near < flat.lens.far == 9.0


@pytest.mark.parametrize("name", OBLIQUE_PRESETS)
def test_presets_draw_receding_edges_as_they_say(name: str) -> None:
    """A cavalier drawing keeps their length, a cabinet drawing halves it."""
    kind, _, label = name.partition("-")
    alpha_deg, beta_deg = OBLIQUE_PRESETS[name]
    lens = Oblique(alpha_deg=alpha_deg, beta_deg=beta_deg)
    projection = Projection(AXIS, lens, (800, 800))  # of a window of 8 by 8: 100 px a unit
    near, far = projection.trace([(0.0, 0.0, -2.0), (0.0, 0.0, -3.0)]).image
    across, up = far[0] - near[0], near[1] - far[1]
    length = {"cavalier": 100.0, "cabinet": 50.0}[kind]
    assert math.hypot(across, up) == pytest.approx(length, rel=1e-12)
    assert math.degrees(math.atan2(up, across)) == pytest.approx(float(label), abs=0.05)
    receding, receding_deg = receding_of(lens)
    assert receding == pytest.approx(length / 100.0, rel=1e-14)
    assert receding_deg == pytest.approx(float(label), abs=0.05)


@given(logarithmic(1e-3, 1e3), st.floats(-180.0, 180.0))
@QUICK
def test_oblique_angles_come_back(receding: float, receding_deg: float) -> None:
    alpha_deg, beta_deg = oblique_angles(receding, receding_deg)
    found = receding_of(Oblique(alpha_deg=alpha_deg, beta_deg=beta_deg))
    assert found[0] == pytest.approx(receding, rel=1e-10)
    assert math.remainder(found[1] - receding_deg, 360.0) == pytest.approx(0.0, abs=1e-9)


def test_an_upright_oblique_lens_is_the_orthographic_one() -> None:
    assert oblique_angles(0.0, 30.0) == (90.0, 90.0)
    upright = Oblique(*BOX_SIDES, alpha_deg=90.0, beta_deg=90.0)
    ortho = Projection(SLANTED, Orthographic(*BOX_SIDES))
    same = Projection(SLANTED, upright)
    np.testing.assert_array_equal(same.clip_from_world, ortho.clip_from_world)
    assert receding_of(upright) == (0.0, 0.0)


BOX_SIDES = (-4.0, 4.0, -3.0, 3.0, 1.0, 30.0)


@pytest.mark.parametrize("lens", ["perspective", "orthographic"])
@pytest.mark.parametrize("power", [-664, -300, 300])  # 2**-664 is 1e-200
def test_a_world_of_another_size_has_the_same_picture(lens: str, power: int) -> None:
    projection = Projection(SLANTED).with_lens(lens)
    points = np.random.default_rng(1).normal(size=(50, 3))
    by = 2.0**power  # exact, so that every bit has to be the same
    kept = projection.lens
    if isinstance(kept, Perspective):
        scaled: Lens = replace(kept, near=kept.near * by, far=kept.far * by)
    else:
        names = ("left", "right", "bottom", "top", "near", "far")
        scaled = replace(kept, **{name: getattr(kept, name) * by for name in names})
    camera = Camera(np.multiply(SLANTED.eye, by), np.multiply(SLANTED.target, by), SLANTED.up)
    there = Projection(camera, scaled).trace(points * by)
    here = projection.trace(points)
    assert here.in_front.all()
    np.testing.assert_array_equal(there.image, here.image)
    np.testing.assert_array_equal(there.ndc, here.ndc)
    np.testing.assert_array_equal(there.outside, here.outside)


# --------------------------------------------------------------------------- 80 digits


def camera_at(rng: np.random.Generator, offset: float) -> Camera:
    """A camera anywhere round a place far from the origin, looking anywhere."""

    def direction() -> Array:
        vector = rng.normal(size=3)
        return vector / np.linalg.norm(vector)

    eye = offset * direction() + 5.0 * rng.normal(size=3)
    return Camera(eye, eye + 8.0 * direction(), direction())


def worst_px(projection: Projection, points: Array) -> float:
    """The largest error in pixels, of the points that are in the view volume."""
    image, oracle, (width, height) = (
        projection.trace(points).image, exact.Exact(projection), projection.image_size,
    )  # fmt: skip
    errors = [0.0]
    for point, found in zip(points, image, strict=True):
        expected = oracle(point)
        x, y = expected.image
        deep = projection.lens.near <= -expected.view[2] <= projection.lens.far
        if deep and 0 <= x <= width and 0 <= y <= height:
            errors += [abs(float(e - float(f))) for e, f in zip((x, y), found, strict=True)]
    assert len(errors) > 1
    return max(errors)


OFFSETS = [0.0, 1e3, 1e6, 1e9]
FARS = [10.0, 1e3, 1e9, math.inf]
FULL_HD = (1920, 1080)
WINDOWED = [kind for kind, lens in ONE_OF_EACH.items() if lens.window_stays]
Measured = tuple[Lens, tuple[int, int], float]
"""A lens, the size of its image, and the error that it may have, in pixels."""


def symmetric(fov_y_deg: float) -> Iterator[Measured]:
    """5e-12 px, also where a radian is 3e8 pixels: there the digits are doubled."""
    for far in FARS:
        yield Perspective(fov_y_deg, 1.0, far), FULL_HD, 5e-12


def stretched(aspect: float) -> Iterator[Measured]:
    """5e-12 px about the axis at any aspect: stretched windows, and images of 1 x 16384 pixels."""
    long, short = LARGEST_IMAGE_PX, 1
    for size, far in product((0.4, 10.0), FARS[::3]):
        right, top = size * min(aspect, 1.0), size * min(1.0 / aspect, 1.0)
        yield Frustum(-right, right, -top, top, 1.0, far), FULL_HD, 5e-12
        for image_size, keep in (((long, short), "x"), ((short, long), "y")):
            lens = Frustum(-right, right, -top, top, 1.0, far, keep)
            yield lens, image_size, 5e-12 * LARGEST_IMAGE_PX / 1920


def off_axis(away: float) -> Iterator[Measured]:
    """1e-12 px times how far the window is from the axis, in units of its own width.

    A point's place is compared with the window's sides, as far from the axis as they are, so that
    it is rounded in units of their distance: a window a million widths off has lost 6 of 16 digits
    (3.5e-7 px). `keep` moves both sides alike, and loses none.
    """
    for kind, keep, far in product(WINDOWED, ("stretch", "x", "y"), (10.0, 1e3)):
        width, sides = 1.7, (1.7 * (away - 0.5), 1.7 * (away + 0.5), -0.3, 0.7)
        near = -3.0 if ONE_OF_EACH[kind].parallel else 1.0
        lens = made(kind, sides, near, far, keep=keep, alpha_deg=89.9, beta_deg=90.1)
        left, right, bottom, top = Projection(AXIS, lens, FULL_HD).window
        loss = max(away * width / (right - left), 1.0 / (top - bottom), 1.0)
        yield lens, FULL_HD, 1e-12 * (loss + 0.01 * far)


def boxed(size: float) -> Iterator[Measured]:
    """5e-12 px about the axis, whatever the window's size and however deep the box."""
    for near, far in ((1.0, 30.0), (-1e3, 1e9)):
        yield Orthographic(-size, size, -size, size, near, far), FULL_HD, 5e-12


def leaning(alpha_deg: float) -> Iterator[Measured]:
    """1e-12 px times the shear of the whole depth, in units of the window.

    A point and its shear are each as far from the window as the shear is long, and are rounded in
    units of that before they meet: 2e-12 px for a cavalier box 4 windows deep, 1e-2 px where the
    projectors lean by 2e12 windows.
    """
    for far in (9.0, 30.0, 1e6):
        lens = Oblique(-4.0, 4.0, -3.0, 3.0, 1.0, far, "stretch", alpha_deg, 60.0)
        cot_alpha, cot_beta = map(abs, lens.shear)
        shear = 1.0 + max(cot_alpha / 8.0, cot_beta / 6.0) * far
        if shear < 1e11:  # or rounding the points to float64 moves them out of the picture
            yield lens, FULL_HD, 1e-12 * shear


MEASURED: list[tuple[Callable[[float], Iterator[Measured]], float]] = [
    *((symmetric, fov) for fov in (1e-4, 0.01, 1, 10, 45, 90, 90.001, 150, 179, 179.9, 179.99)),
    *((stretched, aspect) for aspect in (1e-6, 1.0, 1e6)),
    *((off_axis, away) for away in (0.5, 10.0, 1e3, 1e6)),
    *((boxed, size) for size in (1e-6, 1.0, 1e9)),
    *((leaning, alpha_deg) for alpha_deg in (1e-4, 0.01, 20.0, 109.47, 179.999)),
]


@pytest.mark.parametrize("offset", OFFSETS[::3])
@pytest.mark.parametrize(
    ("lenses", "figure"), MEASURED, ids=[f"{make.__name__} {figure}" for make, figure in MEASURED]
)
def test_pixels_against_80_digits(
    lenses: Callable[[float], Iterator[Measured]], figure: float, offset: float
) -> None:
    rng = np.random.default_rng(int(offset))
    for lens, size, error in lenses(figure):
        if offset and size != FULL_HD:  # across such pictures points cannot be told apart there
            continue
        depth = str(rng.choice(sorted(DEPTH_RANGES)))
        projection = Projection(camera_at(rng, offset), lens, size, depth)
        points = points_in_view(projection, rng.uniform(0.1, 0.9, (8, 3)))
        assert worst_px(projection, points) < error, lens


@given(projections(), st.lists(PARTS, min_size=1, max_size=3))
@QUICK
def test_pixels_of_any_projection_against_80_digits(projection: Projection, parts: list) -> None:
    """Over the whole range of every parameter, by the two rules above."""
    (left, right, bottom, top), lens = projection.window, projection.lens
    points = points_in_view(projection, np.array(parts))
    image, oracle = projection.trace(points).image, exact.Exact(projection)
    depth = max(abs(lens.far - lens.near), abs(lens.near)) if lens.parallel else 0.0
    loss = [
        2.0 + min(projection.stretch, 8.0)
        + (abs(low) + abs(high) + abs(cot) * depth) / (high - low)
        for low, high, cot in (
            (left, right, projection.lens.shear[0]), (bottom, top, projection.lens.shear[1]),
        )
    ]  # fmt: skip
    for point, found in zip(points, image, strict=True):
        expected = oracle(point).image
        for part, value, lost, side in zip(
            found, expected, loss, projection.image_size, strict=True
        ):
            # Outside the picture, where rounding has put a point beside a tiny one, relative.
            size = max(1.0, abs(float(value)) / side)
            assert abs(float(value - float(part))) <= 6.0 * EPS * side * lost * size


def test_the_matrix_for_a_far_scene_keeps_its_digits() -> None:
    # A scene at 1e9 from the origin; its points are known from there. What a GPU is given.
    rng = np.random.default_rng(3)
    lens = Perspective(45.0, 1.0, 1e3)
    projection = Projection(camera_at(rng, 1e9), lens, (1920, 1080))
    origin = np.round(projection.camera.eye)
    local = points_in_view(projection, rng.uniform(0.0, 1.0, (20, 3))) - origin
    clip = homogeneous(local) @ projection.clip_from_local(origin).T
    image = projection.image_from_ndc @ homogeneous(clip[:, :3] / clip[:, 3:]).T
    oracle = exact.Exact(projection)
    expected = np.array([[float(x) for x in oracle(p + origin).image] for p in local])
    assert np.abs(image[:2].T - expected).max() < 1e-10
    # The plain product has lost them (5e-5 px and more): that the origin counts is tested here.
    clip = homogeneous(local + origin) @ projection.clip_from_world.T
    image = projection.image_from_ndc @ homogeneous(clip[:, :3] / clip[:, 3:]).T
    assert np.abs(image[:2].T - expected).max() > 1e-6


@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize("ratio", [1.0 + 1e-9, 1.1, 1e3, 1e12, math.inf])
def test_depth_against_80_digits(depth: str, ratio: float) -> None:
    # Along the z axis w is exact, so that what is seen is the formula and not the look-at.
    lens = Perspective(45.0, 0.75, 0.75 * ratio)
    projection = Projection(Camera((0, 0, 0), (0, 0, -1), (0, 1, 0)), lens, depth=depth)
    rng = np.random.default_rng(4)
    reach = min(ratio, 1e12) ** rng.uniform(0.0, 1.0, 100)
    points = np.column_stack([rng.normal(size=(100, 2)), -0.75 * reach])
    found, oracle = projection.trace(points), exact.Exact(projection)
    for point, depth_found, ndc in zip(points, found.depth, found.ndc, strict=True):
        expected = oracle(point)
        assert abs(float(expected.depth - float(depth_found))) <= 4e-16
        assert abs(float(expected.ndc[2] - float(ndc[2]))) <= 8e-16
        if depth == "reversed" and ratio == math.inf:  # relative, down to nothing
            assert abs(float(float(depth_found) / expected.depth - 1)) <= 4e-16


def implied_distance(lens: Lens, depth: float) -> exact.Any:
    """The distance from the eye plane that a reversed depth stands for: 1/w is affine in it."""
    far_inverse = 0 if lens.far == math.inf else 1 / exact.mp.mpf(lens.far)
    d = exact.mp.mpf(depth)
    return 1 / (d / exact.mp.mpf(lens.near) + (1 - d) * far_inverse)


@pytest.mark.parametrize("kind", ["perspective", "frustum"])
@pytest.mark.parametrize("ratio", [1e1, 1e3, 1e9, 1e15, math.inf])
def test_distance_implied_by_reversed_depth(kind: str, ratio: float) -> None:
    """4e-16 of the distance for any camera, anywhere, with any field of view."""
    rng = np.random.default_rng([5, int(min(ratio, 1e16))])
    compared = 0
    for offset, fov_y_deg in product(OFFSETS, (1.0, 45.0, 125.0, 179.0)):
        near = float(10.0 ** rng.uniform(-2.0, 2.0))
        lens: Lens = Perspective(fov_y_deg, near, near * ratio)
        if kind == "frustum":
            sides = np.array([-0.3, 0.9, -0.7, 0.2]) * near * math.tan(fov_y_deg / 115.0)
            lens = Frustum(*sides, near, near * ratio)
        for camera in (AXIS, camera_at(rng, offset)):
            projection = Projection(camera, lens, (1920, 1080), "reversed")
            points = points_in_view(projection, rng.uniform(0.0, 1.0, (40, 3)))
            oracle = exact.Exact(projection)
            for point, depth in zip(points, projection.trace(points).depth, strict=True):
                w = oracle(point).w
                if lens.near <= w <= lens.far:
                    compared += 1
                    assert abs(float(implied_distance(lens, depth) / w - 1)) <= 4e-16
    assert compared > 1000


@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize("extent", [1e-12, 1e-9, 1e-3])
@pytest.mark.parametrize("lens", [Perspective(), Orthographic()], ids=["perspective", "ortho"])
def test_depth_between_planes_that_almost_meet(lens: Lens, extent: float, depth: str) -> None:
    """To the last bit on an axis; elsewhere to the 25 bits or so that are left of w."""
    rng = np.random.default_rng(7)
    for near in (0.75, 1.0, 3.3):
        lens = replace(lens, near=near, far=near * (1.0 + extent))
        for camera, error in ((AXIS, 2.3e-16), (camera_at(rng, 0.0), 4e-16 + 4e-23 / extent)):
            projection = Projection(camera, lens, (1920, 1080), depth)
            points = points_in_view(projection, rng.uniform(0.0, 1.0, (40, 3)))
            oracle = exact.Exact(projection)
            inside = 0
            for point, found in zip(points, projection.trace(points).depth, strict=True):
                expected = oracle(point).depth
                if -1 <= expected <= 2:  # rounding the points moves some beyond the planes
                    inside += 1
                    assert abs(float(expected - float(found))) <= error
            assert inside or extent == 1e-12


@pytest.mark.parametrize("ratio", [1e1, 1e3, 1e9])
@pytest.mark.parametrize("lens", ONE_OF_EACH)
def test_projected_and_un_projected(lens: str, ratio: float) -> None:
    """1e-15 of w there and back with a reversed depth; of the box's size for a parallel lens."""
    rng = np.random.default_rng([7, int(ratio)])
    for _ in range(10):
        near = float(10.0 ** rng.uniform(-2.0, 2.0))
        kept = Projection(
            camera_at(rng, 0.0), Perspective(45.0, near, near * ratio), (1920, 1080), "reversed"
        ).with_lens(lens)
        points = points_in_view(kept, rng.uniform(0.01, 0.99, (40, 3)))
        trace = kept.trace(points)
        back = kept.world_from_image(np.column_stack([trace.image, trace.depth]))
        size = -trace.view[:, 2]
        if kept.lens.parallel:
            size = max(kept.lens.far, *map(abs, kept.window))
        assert (np.linalg.norm(back - points, axis=1) <= 1e-15 * size).all()


@pytest.mark.parametrize("angle", [1.0, 1e-3, 1e-6, 1e-9, 1e-12])
def test_up_close_to_the_view_direction(angle: float) -> None:
    rng = np.random.default_rng(5)
    for offset in OFFSETS:
        base = camera_at(rng, offset)
        camera = Camera(base.eye, base.target, base.frame[2] + angle * base.frame[1])
        expected = exact.frame(camera.eye, camera.target, camera.up)
        for row, exact_row in zip(camera.frame, expected, strict=True):
            errors = [abs(float(e - float(f))) for e, f in zip(exact_row, row, strict=True)]
            assert max(errors) < 5e-16
        projection = Projection(camera, Perspective(45, 1, 100), (1920, 1080))
        points = points_in_view(projection, rng.uniform(0, 1, (10, 3)))
        assert worst_px(projection, points) < 5e-12
    # up x n = (0, -1e-12.., 0): v is x
    camera = Camera((0, 0, 0), (0, 0, -8), (angle, 0, 1))
    if angle < 1.0:
        expected = [(0, -1, 0), (1, 0, 0), (0, 0, 1)]
        np.testing.assert_allclose(camera.frame, expected, atol=1e-15)


@given(st.floats(1e-3, 179.999))
@example(90.0)
@example(math.nextafter(90.0, 91.0))
@example(math.nextafter(180.0, 0.0))
@QUICK
def test_cotangent_of_half_the_field_of_view(fov_y_deg: float) -> None:
    expected = exact.mp.cot(exact.mp.mpf(fov_y_deg) * exact.mp.pi / 360)
    found = Perspective(fov_y_deg).cot_half_fov_y
    assert abs(float(found / expected - 1)) <= 3.0 * EPS


# --------------------------------------------------------------------------- vtkCamera


def from_vtk(matrix: vtkMatrix4x4) -> Array:
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


@given(projections(wild=False))
@QUICK
def test_matrices_are_those_of_vtk_camera(projection: Projection) -> None:
    assume(projection.lens.far != math.inf)  # VTK has no such lens
    lens, camera = projection.lens, projection.camera
    other = vtkCamera()
    other.SetPosition(camera.eye)
    other.SetFocalPoint(camera.target)
    other.SetViewUp(camera.up)
    other.SetClippingRange(lens.near, lens.far)
    found = from_vtk(other.GetModelViewTransformMatrix())
    scale = 1.0 + np.abs(camera.eye).max()
    np.testing.assert_allclose(projection.view_from_world, found, rtol=0.0, atol=1e-11 * scale)

    left, right, bottom, top = projection.window
    width, height = right - left, top - bottom
    other.SetWindowCenter((left + right) / width, (bottom + top) / height)
    if lens.parallel:
        other.ParallelProjectionOn()
        other.SetParallelScale(height / 2.0)
    else:
        fov_y_deg = math.degrees(2.0 * math.atan2(height / 2.0, lens.near))
        assume(fov_y_deg < 179.0)  # it takes no more
        other.SetViewAngle(fov_y_deg)
    if isinstance(lens, Oblique):  # per distance, not z; from near on, in units of the target's
        cot_alpha, cot_beta = projection.lens.shear
        other.SetViewShear(-cot_alpha, -cot_beta, lens.near / camera.distance)
    z_near, z_far = projection.depth_range
    found = from_vtk(other.GetProjectionTransformMatrix(width / height, z_near, z_far))
    assume(other.GetClippingRange() == (lens.near, lens.far))  # it moves a near of 0 or less
    ours = projection.clip_from_view
    # It is handed the window's extents as differences of rounded edges.
    edges = max(map(abs, projection.window))
    lost = 1e-9 + 4.0 * EPS * edges / min(width, height)
    np.testing.assert_allclose(ours, found, rtol=lost, atol=lost * np.abs(found).max())


# --------------------------------------------------------------------------- points behind


@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize("far", [30.0, math.inf])
def test_a_point_behind_the_eye_has_no_picture(depth: str, far: float) -> None:
    projection = Projection(
        Camera((0, 0, 0), (0, 0, -1), (0, 1, 0)), Perspective(45, 1, far), depth=depth
    )
    points = [(0.1, 0.2, 3.0), (0.1, 0.2, 0.0), (0.0, 0.0, 0.0), (0.1, 0.2, -3.0)]
    trace = projection.trace(points)
    assert trace.in_front.tolist() == [False, False, False, True]
    for array in (trace.ndc, trace.image, trace.depth):
        assert np.isnan(array[:3]).all()
        assert np.isfinite(array[3]).all()
    assert np.isfinite(trace.clip).all()
    assert trace.clip[:, 3].tolist() == [-3.0, 0.0, 0.0, 3.0]
    assert trace.outside[:3, PLANES.index("near")].all()


def test_between_eye_and_near_plane_there_is_a_picture_but_it_is_cut() -> None:
    projection = Projection(Camera((0, 0, 0), (0, 0, -1), (0, 1, 0)), Perspective(90, 1, 30))
    trace = projection.trace((0.0, 0.25, -0.5))
    assert trace.image[1] == pytest.approx(180.0)  # half-way up the upper half
    assert trace.depth < 0.0
    assert trace.outside.tolist() == [True, False, False, False, False, False]


def test_a_parallel_lens_sees_behind_the_eye_plane() -> None:
    projection = Projection(
        Camera((0, 0, 0), (0, 0, -1), (0, 1, 0)), Orthographic(-1, 1, -1, 1, -5, 5), (100, 100)
    )
    trace = projection.trace((0.5, 0.5, 3.0))
    assert trace.in_front
    assert not trace.outside.any()
    np.testing.assert_allclose(trace.image, [75.0, 25.0])


@pytest.mark.parametrize("projection", PROJECTIONS[::3])
def test_a_trace_is_its_own_formulas_to_the_bit(projection: Projection) -> None:
    """However its blocks and columns are worked through: the same bits as one plain formula."""
    points = 20.0 * np.random.default_rng(7).normal(size=(17_000, 3))
    trace = projection.trace(points)
    x, y, _, w = trace.clip.T
    distance = -trace.view[:, 2]
    np.testing.assert_array_equal(w, 1.0 if projection.lens.parallel else distance)
    lens = projection.lens
    outside = [distance < lens.near, distance > lens.far, x < -w, x > w, y < -w, y > w]
    np.testing.assert_array_equal(trace.outside.T, outside)
    np.testing.assert_array_equal(trace.in_front, w > 0.0)  # nothing here is beyond float64
    x, y, z = trace.ndc.T
    width, height = projection.image_size
    np.testing.assert_array_equal(trace.image[:, 0], (x + 1.0) * (width / 2.0))
    np.testing.assert_array_equal(trace.image[:, 1], (1.0 - y) * (height / 2.0))
    opengl = projection.depth == "opengl"
    np.testing.assert_array_equal(z, 2.0 * trace.depth - 1.0 if opengl else trace.depth)
    for array in (trace.ndc, trace.image, trace.depth):
        lost = np.isnan(array.reshape(len(points), -1))
        np.testing.assert_array_equal(lost, np.repeat(~trace.in_front[:, None], lost.shape[1], 1))
    for part in (slice(16_384), slice(16_384, None)):
        for whole, alone in zip(trace, projection.trace(points[part]), strict=True):
            np.testing.assert_array_equal(whole[part], alone)


# --------------------------------------------------------------------------- values


@pytest.mark.parametrize("projection", PROJECTIONS[::5])
def test_arrays_cannot_be_written_into(projection: Projection) -> None:
    arrays = {"frame": projection.camera.frame}
    for name in dir(type(projection)):
        if name.startswith("_") or (name == "intrinsics" and projection.lens.parallel):
            continue
        value = getattr(projection, name)
        if isinstance(value, np.ndarray):
            arrays[name] = value
    arrays |= {stage.name: stage.matrix for stage in projection.stages}
    arrays |= {name: factor for stage in projection.stages for name, factor in stage.factors}
    arrays["at"] = projection.clip_from_local((1, 2, 3))
    arrays["back"] = projection.world_from_clip_at((1, 2, 3))
    assert len(arrays) >= 12
    for array in arrays.values():
        assert array.dtype == np.float64
        with pytest.raises(ValueError, match="read-only"):
            array[0, 0] = 7.0


def test_values_are_equal_and_hashable() -> None:
    a = Projection(Camera([1, 2, 3], np.array([0, 0, 0]), (0, 1, 0)), Perspective(45, 1, 30))
    b = Projection(Camera((1.0, 2.0, 3.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)), Perspective())
    _ = a.clip_from_world, a.camera.frame  # what is cached is no value
    assert a == b
    assert {a: "found"}[b] == "found"
    assert replace(b, lens=Perspective(46)) != b
    assert all(type(part) is float for part in a.camera.eye)
    assert type(a.lens.near) is float
    assert Projection(image_size=np.array([80, 60])).image_size == (80, 60)
    with pytest.raises(FrozenInstanceError):
        a.depth = "reversed"  # type: ignore[misc]


def test_stages_multiply_to_the_whole() -> None:
    for projection in PROJECTIONS:
        stages = {stage.name: stage for stage in projection.stages}
        product = np.eye(4)
        for stage in projection.stages[1:-1]:
            product = stage.matrix @ product
        np.testing.assert_allclose(product, projection.clip_from_world, rtol=1e-14, atol=1e-14)
        for stage in stages.values():
            if stage.factors:
                product = reduce(np.matmul, [factor for _, factor in stage.factors])
                np.testing.assert_allclose(product, stage.matrix, rtol=1e-14)
        np.testing.assert_array_equal(stages["image_from_ndc"].matrix, projection.image_from_ndc)


EXTREME = [1e-205, 1e-200, 1e-9, 1.0, 1e9, 1e90]


@pytest.mark.parametrize("depth", DEPTH_RANGES)
def test_what_can_be_made_works(depth: str) -> None:
    """No warning, no infinity, also at the ends of what is allowed."""
    for near in EXTREME:
        for far in (math.nextafter(near, math.inf), 2.0 * near, 1e100, math.inf):
            for fov_y_deg in (1e-90, 1.0, 90.0, math.nextafter(180.0, 0.0)):
                for size in ((1, LARGEST_IMAGE_PX), (LARGEST_IMAGE_PX, 1)):
                    lens = Perspective(fov_y_deg, near, far)
                    projection = Projection(SLANTED, lens, size, depth)
                    for matrix in (
                        projection.clip_from_world,
                        projection.world_from_clip_at((0.0, 0.0, 0.0)),
                    ):
                        assert np.isfinite(matrix).all()
                    assert np.isfinite(projection.trace(SLANTED.target).image).all()


# --------------------------------------------------------------------------- what is refused

NAN, INF = math.nan, math.inf
HUGE = 10**400


def camera_with(**changes: object) -> Callable[[], object]:
    return lambda: Camera(**{"eye": (6, 5, 9), "target": (0, 2, 0), "up": (0, 1, 0)} | changes)


def unprojecting(points: object, far: float = 30.0) -> Callable[[], object]:
    return lambda: Projection(lens=Perspective(far=far)).world_from_image(points)


def tracing(points: object) -> Callable[[], object]:
    return lambda: Projection().trace(points)


def orbit_with(**changes: float) -> Callable[[], object]:
    orbit = {"azimuth_deg": 0.0, "elevation_deg": 0.0, "distance": 5.0} | changes
    return lambda: Camera.from_orbit((0.0, 0.0, 0.0), Orbit(**orbit))


MODULES = "limits", "camera", "lenses.lens", "pipeline", "projection", "tables", "eye_first"
DISTANT = Camera((0, 0, 1e100), (0, 0, 0))
BOUNDS = marked(*(import_module(f"app.model.{name}") for name in MODULES))
OF_K = ("x-left", "y-up", "normalised", "not-k", "camera-transposed", "skewed", "at-infinity")
"""What is refused of a calibration; `tests/document/test_calibrated.py` has it."""
# What is refused, and the sentence: the field, the value and the bound.
ITSELF: list[object] = [1, 2]
ITSELF.append(ITSELF)
REFUSED: list[tuple[Callable[[], object], str]] = [
    # lenses
    (partial(Perspective, near=0), "near = 0: must be greater than 0."),
    (partial(Perspective, near=1e-206), "near = 1e-206: must be at least 1e-205."),
    (partial(Perspective, near=30), "near = 30: must be less than far, which is 30."),
    (partial(Perspective, near=INF), "near = inf: must be less than far, which is 30."),
    (partial(Orthographic, near=INF), "near = inf: must be less than far, which is 30."),
    (partial(Perspective, near=INF, far=INF), "near = inf: must be a finite number."),
    (partial(Perspective, near=NAN), "near = nan: must be a finite number."),
    (partial(Perspective, near=True), "near = True: must be a finite number."),
    (partial(Perspective, near="1"), "near = '1': must be a finite number."),
    (partial(Perspective, far=-INF), "far = -inf: must be a finite number."),
    (partial(Perspective, far=1e101), "far = 1e+101: must be at most 1e+100."),
    (partial(Perspective, far=HUGE), "far = 1e400: must be at most 1e+100."),
    (partial(Perspective, far="inf"), "far = 'inf': must be a finite number."),
    (partial(Perspective, fov_y_deg=0),
     "fov_y_deg = 0: must lie between 0 and 180, both excluded."),
    (partial(Perspective, fov_y_deg=180),
     "fov_y_deg = 180: must lie between 0 and 180, both excluded."),
    (partial(Perspective, fov_y_deg=1e-91), "fov_y_deg = 1e-91: must be at least 1e-90."),
    (partial(Perspective, fov_y_deg=1e101),
     "fov_y_deg = 1e+101: must lie between 0 and 180, both excluded."),
    (partial(Orthographic, far=INF), "far = inf: must be a finite number."),
    (partial(Orthographic, left=4), "left = 4: must be less than right, which is 4."),
    (partial(Orthographic, bottom=5), "bottom = 5: must be less than top, which is 4."),
    (partial(Orthographic, left=0, right=1e-310),
     "left = 0: is too close to 1e-310 for float64 to tell the two apart."),
    (partial(Orthographic, keep="z"), "keep = 'z': must be one of stretch, x, y."),
    (partial(Orthographic, keep=[]), "keep = (): must be one of stretch, x, y."),
    (partial(Projection, lens=Orthographic(0, 1e-3, 1e16, 1e16 + 100, keep="x")),
     "bottom = 1.000000000000005e+16: is too close to 1.000000000000005e+16 for float64 to tell "
     "the two apart."),
    # frusta
    (partial(Frustum, right=-0.7), "left = -0.7: must be less than right, which is -0.7."),
    (partial(Frustum, bottom=0, top=1e-111),
     "bottom = 0: is too close to 1e-111 for a plane as far from the eye as near is."),
    (partial(Frustum, right=2e89, near=1e-2), "right = 2e+89: must be at most 1e+88."),
    (partial(Frustum, left=-2e89, near=1e-2), "left = -2e+89: must be at least -1e+88."),
    (lambda: Projection(lens=Frustum(1.0, 1.0 + 1e-15, 1.0, 2.0, keep="x"), image_size=(9, 1)),
     "bottom = 1.5: is too close to 1.5 for float64 to tell the two apart."),
    # oblique lenses
    (partial(Oblique, alpha_deg=0), "alpha_deg = 0: must lie between 0 and 180, both excluded."),
    (partial(Oblique, beta_deg=180), "beta_deg = 180: must lie between 0 and 180, both excluded."),
    (partial(Oblique, alpha_deg=1e-5), "alpha_deg = 1e-05: must be at least 5.72958e-05."),
    (partial(Oblique, alpha_deg=179.99999),
     "alpha_deg = 179.99999: must be at most 179.99994270422047."),
    (partial(Oblique, left=0, right=1e-195),
     "left = 0: is too close to 1e-195 for float64 to tell the two apart."),
    (lambda: oblique_angles(-1.0, 45.0), "receding = -1: must be at least 0."),
    (lambda: oblique_angles(2e6, 0.0), "receding = 2000000: must be at most 1000000."),
    (lambda: oblique_angles(1.0, INF), "receding_deg = inf: must be a finite number."),
    # cameras
    (camera_with(eye=(0, 2, 0)),
     "target = (0, 2, 0): must differ from the eye, or the camera looks nowhere."),
    (camera_with(up=(0, 0, 0)), "up = (0, 0, 0): must not be the zero vector."),
    (camera_with(eye=(0, 9, 0)), "up = (0, 1, 0): must not be parallel to the view direction."),
    (camera_with(eye=(0, 9, 0), up=(1e-16, 1, 0)),
     "up = (1e-16, 1, 0): must not be parallel to the view direction."),
    (camera_with(target=(0, INF, 0)),
     "target = (0, inf, 0): must be three finite numbers x, y, z."),
    (camera_with(eye=(1, 2)), "eye = (1, 2): must be three finite numbers x, y, z."),
    (camera_with(eye=5), "eye = 5: must be three finite numbers x, y, z."),
    (camera_with(eye="123"), "eye = '123': must be three finite numbers x, y, z."),
    (camera_with(eye=("1", 2, 3)), "eye = ('1', 2, 3): must be three finite numbers x, y, z."),
    (camera_with(up=(0, True, 0)), "up = (0, True, 0): must be three finite numbers x, y, z."),
    (camera_with(eye=(1e101, 0, 0)), "eye = 1e+101: must be at most 1e+100."),
    (camera_with(eye=np.zeros((3, 3))),
     "eye = array([[0., 0., 0.], [0., 0., 0.], [0., 0., 0.]]): must be three finite numbers x,"
     " y, z."),
    (orbit_with(distance=0.0), "distance = 0: must be greater than 0."),
    (orbit_with(elevation_deg=90.5), "elevation_deg = 90.5: must be at most 90."),
    (orbit_with(elevation_deg=-91.0), "elevation_deg = -91: must be at least -90."),
    (orbit_with(azimuth_deg=INF), "azimuth_deg = inf: must be a finite number."),
    (lambda: Camera.from_orbit((1e9, 1, 1e9), Orbit(0, 0, 1e-9)),
     "distance = 1e-09: is too close to 0 for float64 to tell the two apart."),
    # x and z could hold it, y could not: it would be another elevation.
    (lambda: Camera.from_orbit((0, 2.2, 0), Orbit(30, 15, 1e-14)),
     "distance = 1e-14: is too close to 0 for float64 to tell the two apart."),
    # the image and the depth range
    (partial(Projection, image_size=(0, 0)),
     "width = 0: must be a whole number of pixels from 1 to 16384."),
    (partial(Projection, image_size=(100_000, 100_000)),
     "width = 100000: must be a whole number of pixels from 1 to 16384."),
    (partial(Projection, image_size=(800.5, 600)),
     "width = 800.5: must be a whole number of pixels from 1 to 16384."),
    (partial(Projection, image_size=(800, True)),
     "height = True: must be a whole number of pixels from 1 to 16384."),
    (partial(Projection, image_size=800),
     "image = 800: must be two numbers of pixels, width and height."),
    (partial(Projection, image_size="20"),
     "image = '20': must be two numbers of pixels, width and height."),
    (partial(Projection, image_size=(200.5, 200)),
     "width = 200.5: must be a whole number of pixels from 1 to 16384."),
    (partial(Projection, image_size=(200, INF)),
     "height = inf: must be a whole number of pixels from 1 to 16384."),
    (partial(Projection, depth="vulkan"),
     "depth = 'vulkan': must be one of opengl, direct3d, reversed."),
    (partial(Projection, placement="spin"), "placement = 'spin': must be of the type Chain."),
    (lambda: Projection().with_lens("fisheye"),
     f"kind = 'fisheye': must be one of {', '.join(kinds())}."),
    (lambda: Projection(DISTANT, Perspective(45, 1, INF)).with_lens("orthographic"),
     "far = 4e+100: must be at most 1e+100."),
    # points
    (tracing((NAN, 0, 0)), "points = (nan, 0, 0): must have finite real numbers only."),
    (tracing([(1, 2, 3), (1, INF, 3)]),
     "points[1] = (1, inf, 3): must have finite real numbers only."),
    (tracing([[(1, 2, 3), (1, "b", 3)]]),
     "points[0, 1] = (1, 'b', 3): must have finite real numbers only."),
    (tracing([(1j, 2, 3)]), "points[0] = (1j, 2, 3): must have finite real numbers only."),
    (tracing([(True, 2, None)]),
     "points[0] = (True, 2, None): must have finite real numbers only."),
    (tracing(None), "points = None: must have finite real numbers only."),
    (tracing("abc"), "points = 'abc': must have finite real numbers only."),
    (tracing([]), "points.shape = (0): must end in 3, the numbers of a point."),
    (tracing([1, 2]), "points.shape = (2): must end in 3, the numbers of a point."),
    (tracing([(1, 2), (3, 4)]), "points.shape = (2, 2): must end in 3, the numbers of a point."),
    (tracing([(1, 2, 3), (4, 5)]),
     "points = ((1, 2, 3), (4, 5)): must have equally many numbers in every row."),
    (tracing(ITSELF), "points = (1, 2, (1, 2, (1, 2, (1, 2, (1, 2, ...))))):"
     " must have equally many numbers in every row."),
    (tracing(np.array([(1, 2, 3)], dtype=object)), "points.dtype = 'object': must be a type such"
     " as float64, to which numpy.asarray(points, float) converts."),
    (tracing(np.ma.masked_array([(1, 2, 3), (4, 5, 6)], [(0, 0, 0), (0, 1, 0)])),
     "points[1] = (4, None, 6): must have no masked number."),
    (tracing([HUGE, 0, 0]),
     "points = (1e400, 0, 0): must have numbers up to 1e+100 in size only."),
    (tracing([1e101, 0, 0]),
     "points = (1e+101, 0, 0): must have numbers up to 1e+100 in size only."),
    # pixels
    (unprojecting((1, 2, 1.5)), "depth = 1.5: must be at most 1."),
    (unprojecting((1, 2, -0.5)), "depth = -0.5: must be at least 0."),
    (unprojecting([(1, 2, 0.5), (1, 2, 1)], far=INF),
     "depth = 1: is at infinity, so it is a direction and not a point."),
    # free matrices
    (lambda: FreeMatrix([[1, 2]]),
     "clip_from_view = ((1, 2)): must be four rows of four finite numbers."),
    (lambda: Projection(lens=FreeMatrix(((0.0,) * 4,) * 4)).view_from_clip,
     "clip_from_view = ((0, 0, 0, 0), (0, 0, 0, 0), (0, 0, 0, 0), (0, 0, 0, 0)): must have an"
     " inverse, but its rank is 0."),
    (lambda: FreeMatrix(((1e-76, 0, 0, 0), *((0.0,) * 4,) * 3)),
     "clip_from_view[0, 0] = 1e-76: must be 0 or at least 1e-75 in size."),
    (lambda: Projection(lens=FreeMatrix(
        ((1e-60, 1, 0, 0), (0, 1e-60, 1, 0), (0, 0, 1e-60, 1), (0, 0, 0, 1e-60)))
    ).world_from_clip_at((0, 0, 0)),
     "clip_from_view = ((1e-60, 1, 0, 0), (0, 1e-60, 1, 0), (0, 0, 1e-60, 1), (0, 0, 0,"
     " 1e-60)): must have an inverse whose numbers and products float64 can hold."),
    # planes, focal lengths and intrinsics
    (lambda: Projection(lens=Frustum()).between(0, 5), "near = 0: must be greater than 0."),
    (lambda: Projection(lens=Oblique()).intrinsics,
     "lens.kind = 'oblique': must be one of perspective, frustum."),
    (lambda: Projection().with_intrinsics((0, 1, 2, 3)), "fx = 0: must be greater than 0."),
    (lambda: Projection().with_intrinsics((1, 1, NAN, 3)), "cx = nan: must be a finite number."),
    (lambda: fov_y_from_window(0, 1), "top = 0: must be greater than 0."),
    (lambda: fov_y_from_focal_length_e(-2, 1), "e = -2: must be greater than 0."),
    (lambda: fov_y_from_focal_length_35mm(0, 1.5), "focal_length_mm = 0: must be greater than 0."),
    (lambda: check_name("fixed", "left", ("top", "side"), or_none=True),
     "fixed = 'left': must be one of top, side, or empty for none."),
]  # fmt: skip


def test_a_whole_number_of_pixels_is_one_in_any_type() -> None:
    for size in ((200.0, 100), np.array([200.0, 100.0]), (Fraction(200), np.int16(100))):
        found = Projection(image_size=size).image_size  # type: ignore[arg-type]
        assert found == (200, 100) and {*map(type, found)} == {int}


@pytest.mark.parametrize(("make", "sentence"), REFUSED, ids=[sentence for _, sentence in REFUSED])
def test_refused(make: Callable[[], object], sentence: str) -> None:
    with pytest.raises(Refusal) as caught:
        make()
    error = caught.value
    assert str(error) == sentence
    assert error.field == sentence.partition(" = ")[0] and error.bound in BOUNDS
    assert sentence.endswith(f": {error.bound.format(*shown_limits(error.limits, error.value))}.")


@pytest.mark.parametrize(
    ("value", "limit", "shown"),
    [
        (50.0, 2.0426315555555554, "2.04263"),
        (2.0426315555555554, 0.12, "0.12"),
        (2.04263157, 2.0426315555555554, "2.04263"),
        (2.04264, "2.0426381", "2.0426381"),  # 2.04264 is no bound that it breaks
        (2.042639, "2.0426381", "2.0426381"),
        (2.04263, 2.0426315555555554, "2.0426315555555554"),
        ((1.0, 2.042639, 3.0), 2.0426381, "2.0426381"),
        (True, 1 / 3, "0.333333"),
        ("a word", 1 / 3, "0.333333"),
        ("a word", "20260101", "20260101"),  # which may be another word, such as a scene's name
        (..., "20260101", "20260101"),
        (0.0, "perspective", "perspective"),
        (0, 1234567, "1234567"),
        (0.0, 16384, "16384"),
        (INF, 1e100, "1e+100"),
    ],
)
def test_a_bound_has_six_digits_unless_that_would_tell_another_story(
    value: object, limit: object, shown: str
) -> None:
    (found,) = shown_limits((limit,), value)
    assert str(found) == shown
    error = Refusal("near", value, "must be less than far, which is {0}", limit)
    assert str(error).endswith(f" {shown}.")


@pytest.mark.parametrize(
    ("value", "limit", "sentence"),
    [
        (2.0426315555555554, "1", "near = 2.04263: must be at least 1."),
        ((0.1 + 0.2, 1.0, -1 / 3), 0, "near = (0.3, 1, -0.333333): must be at least 0."),
        (0.99999999, "1", "near = 0.99999999: must be at least 1."),
        (1.0000001, "1.0000002", "near = 1: must be at least 1.0000002."),
        ("1/3", "1", "near = '1/3': must be at least 1."),
    ],
)
def test_what_a_hand_has_dragged_has_six_digits(
    value: object, limit: object, sentence: str
) -> None:
    assert str(six_digits(Refusal("near", value, REFUSALS["at-least"], limit))) == sentence


def test_every_bound_is_marked_for_translators_and_in_the_table_above() -> None:
    # What an upper bound says of a lower one is said by `document.set_values` and the controls.
    other_side = {bound for _, bound in OTHER_SIDE.values()} | {REFUSALS[name] for name in OF_K}
    said = "\n".join(sentence for _, sentence in REFUSED)
    for bound in BOUNDS - other_side:
        words = re.escape(bound).replace(r"\{0\}", ".+").replace(r"\{1\}", ".+")
        assert re.search(f": {words}[.]$", said, re.MULTILINE), bound


def test_the_refused_value_is_kept_and_its_sentence_stays_short() -> None:
    with pytest.raises(Refusal) as caught:
        Perspective(near=-1)
    assert caught.value.value == -1.0
    for make in (
        partial(Perspective, near="9" * 100_000),
        camera_with(eye=list(range(100_000))),
        tracing(np.full((100_000, 2), 1.5)),
        partial(Projection, depth="two\nlines\n" * 100),
    ):
        with pytest.raises(Refusal) as caught:
            make()
        assert len(str(caught.value)) < 300
        assert "\n" not in str(caught.value)


def test_the_limits_themselves_are_allowed() -> None:
    assert Perspective(near=SMALLEST).near == SMALLEST
    assert Perspective(far=LARGEST).far == LARGEST
    assert Perspective(far=INF).far == INF
    assert Perspective(1e-90).fov_y_deg == 1e-90
    side = LARGEST_IMAGE_PX
    assert Projection(image_size=(1, side)).image_size == (1, side)
    assert Orthographic(near=-7, far=-3).near == -7.0
    assert Camera((LARGEST, 0, 0)).eye[0] == LARGEST
    assert Camera((0, 9, 0), (0, 0, 0), (1e-12, 1, 0)).up == (1e-12, 1.0, 0.0)
    assert Camera((0, 9, 0), (0, 0, 0), (0, 0, 1e-300)).up[2] == 1e-300


# --------------------------------------------------------------------------- the module's own rules


def test_matrices_are_called_target_from_source() -> None:
    projection = Projection()
    space = "(world|eye|view|clip|ndc|image)"
    factors = {"view_rotation", "view_translation"}  # of view_from_world, named by the lecture
    names = {
        name
        for name in dir(Projection)
        if not name.startswith("_")
        and isinstance(value := getattr(projection, name), np.ndarray)
        and value.shape == (4, 4)
    }
    assert len(names) == 8
    for name in names - factors | {"world_from_clip_at"}:
        assert re.fullmatch(f"{space}_from_{space}(_at)?", name), name
        assert hasattr(projection, name)
