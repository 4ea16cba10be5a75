"""The strip's matrices are exact at the stops, keep lines straight, and are always finite."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.lecture.stages import (
    CANONICAL_PARALLEL,
    CANONICAL_PERSPECTIVE,
    CLOSED_AT,
    IMAGE,
    NDC,
    RADIUS,
    STOPS,
    VIEW,
    WORLD,
    FreeMorph,
    Morph,
    rotation_between,
)
from app.lecture.typed_matrix import with_cell
from app.model.projection import (
    Array,
    Camera,
    FreeMatrix,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.scenes.scene import load
from tests.support.frustum import corners_world
from tests.support.lenses import LENSES
from tests.support.samples import with_depths

EXTREME: dict[str, Lens] = {
    "near 1e-6": Perspective(45.0, 1e-6, 1e6),
    "near 1e-6, far inf": Perspective(45.0, 1e-6, math.inf),
    "near 1e-205, far inf": Perspective(45.0, 1e-205, math.inf),
    "all": Perspective(45.0, 1e-205, 1e100),
    "far 1e100": Perspective(45.0, 1.0, 1e100),
    "near ~ far": Perspective(45.0, 10.0, 10.0000001),
    "narrow": Perspective(1e-3, 0.1, 1e3),
    "wide": Perspective(179.9, 0.1, 1e3),
    "wide, far inf": Perspective(179.9, 1.0, math.inf),
    "off-axis far": Frustum(100.0, 101.0, -0.3, 0.5, 1e-3, math.inf),
    "box": Orthographic(-1e6, 1e6, -1e-6, 1e-6, -1e6, 1e6),
    "flat oblique": Oblique(-5.0, 5.0, -4.0, 4.0, 2.0, 25.0, alpha_deg=0.01, beta_deg=90.0),
}
CORNERS = np.array([(x, y, z) for x in (-4.0, 4.0) for y in (0.0, 5.0) for z in (-4.0, 3.0)])
CUBE = np.array([(x, y, z, 1.0) for z in (1.0, 0.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)])
CAMERA = Camera((6.0, 5.0, 9.0), (0.3, 2.2, -0.1), (0.1, 1.0, 0.0))
MOMENTS = np.linspace(0.0, 5.0, 51)


def morph(
    lens: Lens, depth: str = "opengl", origin: tuple[float, float, float] = (0, 0, 0)
) -> Morph:
    projection = Projection(CAMERA, lens, (1280, 720), depth)  # type: ignore[arg-type]
    return Morph(projection, origin, CORNERS)


def euclid(points: Array) -> Array:
    result: Array = points[..., :3] / points[..., 3:]
    return result


@pytest.mark.parametrize(("lens", "depth"), with_depths(LENSES))
def test_a_stop_is_the_product_of_the_pipelines_own_stages(lens: Lens, depth: str) -> None:
    strip = morph(lens, depth)
    _, _, first, m_pp, *_, image = strip.projection.stages
    wanted = {WORLD: np.eye(4)}
    wanted[VIEW] = strip.projection.view_from_world
    wanted[CANONICAL_PERSPECTIVE] = first.matrix @ wanted[VIEW]
    wanted[CANONICAL_PARALLEL] = m_pp.matrix @ wanted[CANONICAL_PERSPECTIVE]
    wanted[NDC] = strip.projection.clip_from_world
    wanted[IMAGE] = image.matrix @ wanted[NDC]
    for stop, matrix in wanted.items():
        if stop < NDC:
            assert np.array_equal(strip.stage_from_local(stop), matrix), STOPS[stop]
        shown = strip.display_from_local(float(stop))
        framed = strip.display_from_stage(stop) @ matrix
        assert np.abs(shown - framed).max() <= 1e-15 * np.abs(framed).max(), STOPS[stop]
    assert np.array_equal(strip.stage_from_local(NDC), strip.projection.clip_from_local((0, 0, 0)))


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_the_frames_scale_shift_and_mirror_and_do_nothing_else(lens: Lens) -> None:
    strip = morph(lens)
    for stop in range(len(STOPS)):
        frame = strip.display_from_stage(stop)
        assert not (frame[:3, :3] - np.diag(np.diag(frame[:3, :3]))).any()
        assert frame[3].tolist() == [0.0, 0.0, 0.0, 1.0]
        x, y, z = np.diag(frame)[:3]
        if stop < NDC:
            assert x == y == z > 0.0
    assert strip.display_from_stage(NDC)[2, 2] == -1.0  # NDC is left-handed
    assert strip.display_from_stage(IMAGE)[1, 1] < 0.0  # y down


def test_for_a_parallel_lens_m_pp_is_the_identity() -> None:
    for name in ("orthographic", "oblique"):
        strip = morph(LENSES[name])
        positions = (CANONICAL_PERSPECTIVE, 2.5, CANONICAL_PARALLEL)
        before, between, after = map(strip.display_from_local, positions)
        assert np.array_equal(before, between) and np.array_equal(before, after)


@pytest.mark.parametrize(("lens", "depth"), with_depths(LENSES))
def test_the_path_arrives_at_every_stop(lens: Lens, depth: str) -> None:
    strip = morph(lens, depth)
    points = np.column_stack([CORNERS, np.ones(8)])
    box = np.column_stack([CUBE[:, :2], np.maximum(CUBE[:, 2], 0.01), CUBE[:, 3]])
    for stop in range(1, 6):
        for matrix, drawn in ((strip.display_from_local, points), (strip.display_from_box, box)):
            at = euclid(drawn @ matrix(float(stop)).T)
            for close in (stop - 1e-9, stop + 1e-9 if stop < IMAGE else stop):
                assert np.abs(euclid(drawn @ matrix(close).T) - at).max() < 1e-6


@pytest.mark.parametrize(("lens", "depth"), with_depths(LENSES))
def test_scene_and_view_volume_move_as_one(lens: Lens, depth: str) -> None:
    """The scene's matrix maps the model's own corners to the volume's corners."""
    strip = morph(lens, depth)
    corners = corners_world(strip.projection)
    box = np.array([(x, y, z, 1.0) for z in (1.0, 0.0)
                    for x, y in ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))])  # fmt: skip
    for position in MOMENTS:
        of_scene = corners @ strip.display_from_local(position).T
        of_volume = box @ strip.display_from_box(position).T
        # The same points of projective space: parallel 4-vectors.
        of_scene /= np.linalg.norm(of_scene, axis=1, keepdims=True)
        of_volume /= np.linalg.norm(of_volume, axis=1, keepdims=True)
        assert np.abs(of_scene - of_volume).max() < 1e-12, position


def test_world_to_view_is_a_rigid_motion() -> None:
    strip = morph(LENSES["perspective"])
    start = strip.display_from_local(0.0)
    scale = start[0, 0]
    for position in np.linspace(0.0, 1.0, 11):
        matrix = strip.display_from_local(position)
        turn = matrix[:3, :3] / scale
        assert np.abs(turn @ turn.T - np.eye(3)).max() < 1e-15 * 8
        assert np.linalg.det(turn) == pytest.approx(1.0, abs=1e-14)
        assert matrix[3].tolist() == [0.0, 0.0, 0.0, 1.0]
    between = strip.display_from_local(0.75)[:3, :3] / scale
    assert np.abs(between @ between - CAMERA.frame).max() < 1e-14  # twice half the turn


@pytest.mark.parametrize("from_left", [False, True])
def test_first_p_moves_the_eye_then_r_rotates_about_it_or_the_reverse(from_left: bool) -> None:
    """Relative to the stage's origin: the world's own places, then less the eye, then R of that."""
    strip = replace(morph(LENSES["perspective"]), from_left=from_left)
    scale, eye = strip.display_from_local(0.0)[0, 0], np.array(CAMERA.eye)
    points = np.array([(0.0, 0.0, 0.0), (1.0, 2.0, 3.0), eye])
    local = np.column_stack([points - strip.origin, np.ones(3)])
    r, none = CAMERA.frame, np.eye(3)
    half = rotation_between(r, 0.5)
    way = ((0.0, 0.0, none), (0.25, 0.5, none), (0.5, 1.0, none), (0.75, 1.0, half), (1.0, 1.0, r))
    if from_left:
        way = ((0.0, 0.0, none), (0.25, 0.0, half), (0.5, 0.0, r), (0.75, 0.5, r), (1.0, 1.0, r))
    for position, moved, turn in way:
        shown = (local @ strip.display_from_local(position).T)[:, :3] - strip.origin_at(position)
        assert shown == pytest.approx(scale * (points - moved * eye) @ turn.T, abs=1e-12)
        start, axes = strip.axes_at(position)
        assert start - strip.origin_at(position) == pytest.approx(shown[2], abs=1e-12)
        assert axes == pytest.approx(CAMERA.frame @ turn.T, abs=1e-12)


def test_half_a_turn_has_an_axis_too() -> None:
    for camera in (
        Camera((0, 0, -5), (0, 0, 0), (0, 1, 0)),  # about y
        Camera((0, 0, -5), (0, 0, 0), (0, -1, 0)),  # about x
        Camera((0, 0, 5), (0, 0, 0), (0, -1, 0)),  # about z
        Camera((0, 0, 5), (0, 0, 0), (0, 1, 0)),  # none
        Camera((3, -7, 2), (0, 1, 0), (1e-3, -1, 0.3)),
        Camera((1e-9, 0, -5), (0, 0, 0), (0, 1, 0)),
    ):
        half, nearly = (rotation_between(camera.frame, part) for part in (0.5, 1.0 - 1e-12))
        for turn, whole in ((half, half @ half), (nearly, nearly)):
            assert np.abs(whole - camera.frame).max() < 1e-11
            assert np.abs(turn @ turn.T - np.eye(3)).max() < 1e-14


@pytest.mark.parametrize(("lens", "depth"), with_depths({**LENSES, **EXTREME}))
def test_every_moment_is_finite_and_none_is_flat(lens: Lens, depth: str) -> None:
    strip = morph(lens, depth, origin=(1.0, 2.0, -1.0))
    middle = np.array([0.0, 0.0, 0.5, 1.0])
    with np.errstate(all="raise", under="ignore"):
        for position in MOMENTS:
            scene, box = strip.display_from_local(position), strip.display_from_box(position)
            planes = strip.planes_display(position)
            for matrix in (scene, box, planes):
                assert np.isfinite(matrix).all()
            assert np.abs(scene).max() > 0.0
            assert (box @ middle)[3] > 0.0  # and so the volume is not turned inside out
            if position >= VIEW:  # near stays before far: depth and w of the box, the right way
                assert box[2, 2] * box[3, 3] >= box[2, 3] * box[3, 2]
            if lens.near > 1e-12 * min(lens.far, 1e6):  # where the sign is more than rounding
                assert np.linalg.slogdet(scene)[0] == 1.0


@pytest.mark.parametrize("name", [name for name in LENSES if name != "wide"])
def test_framed_points_stay_in_the_frame(name: str) -> None:
    lens = LENSES[name]
    strip = morph(lens)
    ball = np.column_stack([CORNERS, np.ones(8)])
    for position in np.linspace(0.0, 1.0, 11):
        inside = euclid(ball @ strip.display_from_local(position).T)
        assert np.linalg.norm(inside, axis=1).max() <= RADIUS * (1.0 + 1e-12)
    if lens.far < math.inf:
        for position in np.linspace(0.0, 5.0, 51):
            volume = euclid(CUBE @ strip.display_from_box(position).T)
            assert np.linalg.norm(volume, axis=1).max() <= math.sqrt(3.0) * (1.0 + 1e-12)


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_the_planes_are_open_then_close_then_cut_at_the_volume(lens: Lens) -> None:
    strip = morph(lens)
    scene = np.column_stack([CORNERS, np.ones(8)])
    for position in (0.0, 0.5, 1.0, 1.0 + 1e-9):
        shown = euclid(scene @ strip.display_from_local(position).T)
        planes = strip.planes_display(position)
        assert (shown @ planes[:, :3].T + planes[:, 3] >= 0.0).all(), position
    assert planes[:, 3].min() > 1.49 * RADIUS, "they do not jump when they begin to close"
    random = np.random.default_rng(5)
    box = np.column_stack([random.uniform((-3, -3, -1), (3, 3, 2), (500, 3)), np.ones(500)])
    x, y, z, w = box.T
    inside = np.array([w + x, w - x, w + y, w - y, z, w - z])
    before = None
    for position in (1.2, 1.4, CLOSED_AT, 1.8, 2.0, 2.3, 3.0, 3.7, 4.0, 4.5, 5.0):
        drawn = box @ strip.display_from_box(position).T
        told = strip.planes_display(position) @ drawn.T
        if position < CLOSED_AT:
            front = drawn[:, 3] > 0.0
            kept = (told >= 0.0).all(axis=0) & front
            assert kept[(inside >= 0.0).all(axis=0) & front].all()
            assert before is None or not (kept & ~before).any()
            before = kept
        else:
            clear = np.abs(inside) > 1e-6
            assert ((told >= 0.0) == (inside >= 0.0))[clear].all(), position


def test_a_far_scene_keeps_its_digits() -> None:
    """A scene at 1e9 looks like the one at 0: the eye is subtracted in float64."""
    here = morph(LENSES["perspective"])
    away = np.array([1e9, -2e9, 1e9])
    camera = Camera(tuple(CAMERA.eye + away), tuple(CAMERA.target + away), CAMERA.up)
    there = Morph(replace(here.projection, camera=camera), tuple(away), CORNERS + away)
    points = np.column_stack([CORNERS, np.ones(8)])
    for position in MOMENTS:
        one, other = (euclid(points @ m.display_from_local(position).T) for m in (here, there))
        assert np.abs(one - other).max() < 1e-5 * np.abs(one).max()


@pytest.mark.parametrize("lens", {**LENSES, **EXTREME}.values(), ids={**LENSES, **EXTREME})
def test_a_box_is_cut_at_its_six_faces(lens: Lens) -> None:
    """Compare with planes by hand: left, right, bottom, top, far, near."""
    strip = morph(lens)
    for stop, half in ((CANONICAL_PARALLEL, 0.5), (NDC, 1.0), (IMAGE, 0.05)):
        up = 720.0 / 1280.0 if stop == IMAGE else 1.0
        by_hand = [
            *((1, 0, 0, 1), (-1, 0, 0, 1), (0, 1, 0, up), (0, -1, 0, up)),
            *((0, 0, 1, half), (0, 0, -1, half)),
        ]
        assert np.abs(strip.planes_display(float(stop)) - by_hand).max() < 1e-12


# --------------------------------------------------------------------------- free matrices

CELLS = (
    ("clip_from_view", 0, 1, 0.5), ("clip_from_view", 3, 3, 4.0), ("clip_from_view", 0, 0, -1.0),
    ("view_from_world", 0, 0, -2.0), ("view_from_world", 3, 2, 0.02),
)  # fmt: skip


@pytest.mark.parametrize("cell", CELLS)
def test_a_free_matrix_goes_from_view_to_ndc_in_one_step(cell: Any) -> None:
    """Its own planes clip its volume at every moment."""
    start = load("letter-f").start
    free = with_cell(start, *cell)
    assert isinstance(free.lens, FreeMatrix) and free.frustum_sign == 1
    corners = np.array([[-2.0, 0.0, -1.0], [2.0, 4.0, 1.0]])
    strip = FreeMorph(free, (0.0, 0.0, 0.0), corners)
    box = np.array([(x, y, z, 1.0) for z in (0.0, 1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)])
    local = box @ free.with_depth("reversed").world_from_clip_at((0.0, 0.0, 0.0)).T
    for position in (0.0, 0.5, 1.0, 1.5, 2.2, 2.7, 3.5, 4.0, 4.5, 5.0):
        assert strip.has_volume(position)
        seen = local @ strip.display_from_local(position).T
        volume = box @ strip.display_from_box(position).T
        assert (seen[:, 3] > 0.0).all() and (volume[:, 3] > 0.0).all()
        seen, volume = seen[:, :3] / seen[:, 3:], volume[:, :3] / volume[:, 3:]
        assert np.allclose(seen, volume, atol=1e-6 * np.abs(seen).max())
        if position >= CLOSED_AT:
            planes = strip.planes_display(position)
            inside = planes[:, :3] @ (volume.mean(axis=0)) + planes[:, 3]
            sides = planes[:, :3] @ volume.T + planes[:, 3:]
            if free.frustum_sign == 1 and cell[3] != -1.0:
                assert (inside > 0.0).all() and sides.min() > -1e-6 * np.abs(volume).max()
    # At NDC, z mirrored for display.
    middle = local.mean(axis=0) / local.mean(axis=0)[3]
    seen = strip.display_from_local(NDC) @ middle
    ndc = free.trace(middle[:3]).ndc
    assert np.allclose(seen[:3] / seen[3], ndc * (1.0, 1.0, -1.0), atol=1e-9)
    here = strip.display_from_local(VIEW - 1e-9), strip.display_from_local(VIEW + 1e-9)
    assert np.allclose(here[0] / here[0][3, 3], here[1] / here[1][3, 3], atol=1e-6)


@pytest.mark.parametrize(("row", "column", "value"), [(0, 0, 0.0), (2, 2, 0.0), (3, 2, 1.0)])
def test_without_a_volume_the_strip_jumps(row: int, column: int, value: float) -> None:
    free = with_cell(load("letter-f").start, "clip_from_view", row, column, value)
    assert isinstance(free.lens, FreeMatrix) and free.frustum_sign <= 0
    strip = FreeMorph(free, (0.0, 0.0, 0.0), np.array([[-2.0, 0.0, -1.0], [2.0, 4.0, 1.0]]))
    for position, shown, has in ((1.0, 1.0, False), (2.4, 1.0, False), (2.6, 4.0, True)):
        assert np.array_equal(strip.display_from_local(position), strip.display_from_local(shown))
        assert strip.has_volume(position) == has
        assert np.array_equal(strip.planes_display(position), strip.planes_display(shown))
    assert np.allclose(np.abs(strip.planes_display(4.0)[:4, 3]), 1.0)


@pytest.mark.parametrize("near", [0.125, 0.5, 2.0])
def test_an_infinite_pyramid_is_framed_down_to_the_deepest_corner(near: float) -> None:
    strip = morph(Perspective(45.0, near, math.inf))
    ball = np.column_stack([CORNERS, np.ones(8)])
    shown = euclid(ball @ strip.display_from_local(CANONICAL_PERSPECTIVE).T)
    assert shown[:, 2].min() == pytest.approx(-0.5)
