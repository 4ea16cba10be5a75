"""Typed matrices: recognised as a lens or a camera, or described by their properties."""

import math
import random
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from app.arithmetic.rationals import eliminate, product, rationals
from app.lecture.typed_matrix import (
    EDITABLE,
    properties,
    recognised_camera,
    recognised_lens,
    shown,
    with_cell,
    with_matrix,
)
from app.model.lenses.oblique import OBLIQUE_PRESETS
from app.model.projection import (
    DEPTH_RANGES,
    LARGEST,
    LENSES,
    Camera,
    FreeMatrix,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.refusal import MATRIX, Refusal
from app.precision import levels as precision
from tests.support.frustum import corners_world
from tests.support.samples import with_depths

QUICK = settings(max_examples=80)
PLACES = [(i, j) for i in range(4) for j in range(4)]
CAVALIER = dict(zip(("alpha_deg", "beta_deg"), OBLIQUE_PRESETS["cavalier-30"], strict=True))
TYPED: dict[str, Lens] = {
    "perspective": Perspective(),
    "infinite": Perspective(60.0, 0.1, math.inf),
    "far": Perspective(20.5, 0.01, 1e6),
    "close": Perspective(120.0, 3.0, 3.5),
    "frustum": Frustum(-0.7, 0.9, -0.4, 0.65, 1.5, 40.0),
    "infinite frustum": Frustum(-0.7, 0.7, -0.4, 0.4, 1.5, math.inf),
    "kept frustum": Frustum(-0.7, 0.9, -0.4, 0.65, 1.5, 40.0, "x"),
    "orthographic": Orthographic(),
    "behind": Orthographic(-3.0, 5.0, -2.0, 2.5, -4.0, 20.0, "y"),
    "oblique": Oblique(-3.0, 5.0, -2.0, 2.5, -4.0, 20.0, alpha_deg=63.4, beta_deg=90.0),
    "cavalier": Oblique(-3.0, 5.0, -2.0, 2.5, 2.0, 20.0, **CAVALIER),
}
EDIT = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0)))


def plain(lens: Lens) -> Lens:
    """Without `keep`, which the matrix does not contain."""
    window = Projection(lens=lens).window
    if isinstance(lens, Perspective | FreeMatrix):
        return lens
    sides = dict(zip(("left", "right", "bottom", "top"), window, strict=True))
    return replace(lens, keep="stretch", **sides)


def texts(projection: Projection, name: str = "clip_from_view") -> list[str]:
    return [template for template, _ in properties(projection, name)]


def edited(row: int, column: int, value: float, name: str = "clip_from_view") -> Projection:
    return with_cell(EDIT, name, row, column, value)


# --------------------------------------------------------------------------- recognition


@pytest.mark.parametrize(("lens", "depth"), with_depths(TYPED))
def test_a_lens_own_matrix_is_that_lens(lens: Lens, depth: Any) -> None:
    projection = replace(EDIT, lens=lens, depth=depth)
    for name in EDITABLE:
        cells = shown(projection, name)
        for row, column in PLACES:
            assert with_cell(projection, name, row, column, cells[row][column]) is projection
    # The present fields stay where they fit.
    spoiled = with_cell(projection, "clip_from_view", 0, 1, 0.25)
    assert isinstance(spoiled.lens, FreeMatrix) and spoiled.lens.former == lens
    assert with_cell(spoiled, "clip_from_view", 0, 1, 0.0) == projection
    # Typed over a free matrix in any order: only the last cell completes the lens.
    typed = Projection(projection.camera, LENSES[lens.kind](), (1280, 720), depth)
    typed = with_cell(typed, "clip_from_view", 0, 1, 0.25)
    cells = shown(projection, "clip_from_view")
    order = [place for place in PLACES if place != (0, 1)]
    random.Random(repr(lens)).shuffle(order)
    for row, column in order:
        typed = with_cell(typed, "clip_from_view", row, column, cells[row][column])
        assert isinstance(typed.lens, FreeMatrix)
        assert typed.lens.clip_from_view[row][column] == cells[row][column]
    typed = with_cell(typed, "clip_from_view", 0, 1, cells[0][1])
    assert typed.lens == plain(lens)
    assert typed.camera == projection.camera


def test_the_kind_in_hand_comes_before_the_simplest() -> None:
    symmetric = Frustum(-1.6, 1.6, -0.9, 0.9, 1.0, 30.0)
    upright = replace(Oblique(), alpha_deg=90.0, beta_deg=90.0)
    for typed, in_hand, kind in (
        (symmetric, symmetric, "frustum"),
        (symmetric, Orthographic(), "perspective"),
        (upright, upright, "oblique"),
        (upright, Perspective(), "orthographic"),
    ):
        cells = shown(replace(EDIT, lens=typed), "clip_from_view")
        found = recognised_lens(cells, replace(EDIT, lens=in_hand))
        assert found is not None and found.kind == kind


def test_one_cell_makes_the_lens_that_has_it() -> None:
    # Lecture 000 (13): cot(fov/2) of y alone makes pixels that are not square: a frustum.
    taller = edited(1, 1, 1.0)
    assert isinstance(taller.lens, Frustum)
    assert taller.lens.top == 1.0 and taller.lens.bottom == -1.0
    # A = -(f + n)/(f - n) = -3 and B = -2 f n/(f - n) as it was: n = B/(A - 1), f = B/(A + 1).
    b = shown(EDIT, "clip_from_view")[2][3]
    nearer = edited(2, 2, -3.0)
    assert isinstance(nearer.lens, Perspective)
    assert nearer.lens.near == pytest.approx(-b / 4.0, rel=1e-15)
    assert nearer.lens.far == pytest.approx(-b / 2.0, rel=1e-15)
    aslant = edited(0, 2, 0.125)
    assert isinstance(aslant.lens, Frustum)
    left, right, _, _ = aslant.window
    assert (right + left) / (right - left) == pytest.approx(0.125, rel=1e-14)


@pytest.mark.parametrize("lens", TYPED.values(), ids=TYPED)
def test_a_positive_factor_changes_nothing(lens: Lens) -> None:
    """A negative factor reverses w: everything would be behind the eye."""
    projection = replace(EDIT, lens=lens)
    own = np.array(shown(projection, "clip_from_view"))
    for factor in (0.5, 3.0, 1e-20, 1e20):
        found = recognised_lens((own * factor).tolist(), projection)
        assert found is not None and found.kind == lens.kind
        again = shown(replace(projection, lens=found), "clip_from_view")
        assert np.allclose(again, own, rtol=4e-15, atol=1e-15)
        assert recognised_lens((-own * factor).tolist(), projection) is None


@pytest.mark.parametrize("value", [1e-20, 1e-75])
def test_a_tiny_cell_is_not_taken_for_zero(value: float) -> None:
    for row, column in ((0, 1), (0, 2), (3, 3)):
        typed = edited(row, column, value)
        assert shown(typed, "clip_from_view")[row][column] == value
        assert isinstance(typed.lens, FreeMatrix)


LENS = st.one_of(
    st.builds(
        Perspective,
        st.floats(1.0, 179.0), st.floats(0.01, 10.0), st.floats(11.0, 1e5) | st.just(math.inf),
    ),
    *(
        st.builds(
            kind,
            st.floats(-9.0, -0.1), st.floats(0.1, 9.0), st.floats(-9.0, -0.1), st.floats(0.1, 9.0),
            near, st.floats(11.0, 1e4),
            **angles,
        )
        for kind, near, angles in (
            (Frustum, st.floats(0.01, 10.0), {}),
            (Orthographic, st.floats(-10.0, 10.0), {}),
            (Oblique, st.floats(-10.0, 10.0),
             dict.fromkeys(("alpha_deg", "beta_deg"), st.floats(10.0, 170.0))),
        )
    ),
)  # fmt: skip


@QUICK
@example(Orthographic(-1.0, 1.0, -1.0, 1.0, 7.620625532145991e-40, 11.0), "direct3d")
@example(Oblique(-1.0, 1.0, -1.0, 1.0, 3.93114654410951e-11, 11.0), "direct3d")
@example(Perspective(165.77260352285845, 4.540286496156354, math.inf), "opengl")
@example(
    Oblique(
        -1.0, 2.0, -1.0, 1.0, 2.187130168476247, 11.0,
        alpha_deg=165.09355157873904, beta_deg=161.76328127509197,
    ),
    "opengl",
)  # fmt: skip
@given(LENS, st.sampled_from(sorted(DEPTH_RANGES)))
def test_recognition_is_the_inverse_of_the_matrix(lens: Any, depth: Any) -> None:
    projection = replace(EDIT, lens=lens, depth=depth)
    cells = np.array(shown(projection, "clip_from_view"))
    in_hand = replace(projection, lens=LENSES[lens.kind]())
    found = recognised_lens(cells.tolist(), in_hand)
    assert found is not None and found.kind == lens.kind
    again = np.array(shown(replace(projection, lens=found), "clip_from_view"))
    largest = np.abs(cells).max(axis=1, keepdims=True)
    assert (np.abs(again - cells) <= 8 * 2.0**-52 * np.maximum(largest, 1.0)).all()
    lost = 16 * 2.0**-52 * (lens.far - lens.near)  # of near, where cells are off by so much of 1
    assert found.near == pytest.approx(lens.near, rel=1e-12, abs=max(1e-12, lost))


@QUICK
@given(
    *(st.tuples(*[st.floats(-100.0, 100.0)] * 3) for _ in range(3)),
    st.sampled_from(sorted(DEPTH_RANGES)),
)
def test_a_cameras_own_matrix_is_that_camera(eye: Any, target: Any, up: Any, depth: Any) -> None:
    try:
        camera = Camera(eye, target, up)
    except Refusal:
        assume(False)
    assume(camera.distance > 1e-3)
    projection = Projection(camera, depth=depth)
    cells = shown(projection, "view_from_world")
    assert recognised_camera(cells, camera) == camera
    # Another camera in hand lends its distance, and its up where that is the same upright.
    other = recognised_camera(cells, EDIT.camera)
    assert other is not None
    assert other.distance == pytest.approx(EDIT.camera.distance, rel=1e-12)
    again = np.array(shown(Projection(other), "view_from_world"))
    room = 1e-13 * (1.0 + np.abs(eye).max())
    assert np.abs(again - cells).max() <= room


def test_a_view_matrix_typed_cell_by_cell_is_its_camera() -> None:
    wanted = Camera((1.0, 2.0, 3.0), (-4.0, 0.5, 1.0), (0.3, 1.0, 0.0))
    cells = shown(Projection(wanted), "view_from_world")
    typed = EDIT
    free = 0
    for row, column in PLACES:
        typed = with_cell(typed, "view_from_world", row, column, cells[row][column])
        free += isinstance(typed.lens, FreeMatrix)
        if isinstance(typed.lens, FreeMatrix):
            assert shown(typed, "clip_from_view") == shown(EDIT, "clip_from_view")
            assert typed.camera == EDIT.camera
    assert free > 3 and typed.lens == EDIT.lens
    assert typed.camera.eye == wanted.eye
    assert np.abs(typed.camera.frame - wanted.frame).max() < 1e-15
    assert typed.camera.distance == pytest.approx(EDIT.camera.distance, rel=1e-14)


def test_up_stays_where_it_gives_the_same_frame() -> None:
    wanted = Camera((1.0, 2.0, 3.0), (-4.0, 0.5, 1.0))
    level = recognised_camera(shown(Projection(wanted), "view_from_world"), EDIT.camera)
    assert level is not None and level.up == (0.0, 1.0, 0.0)
    rolled = replace(wanted, up=(0.3, 1.0, 0.0))
    found = recognised_camera(shown(Projection(rolled), "view_from_world"), EDIT.camera)
    assert found is not None and found.up == tuple(rolled.frame[1])


@pytest.mark.parametrize("turn", [1e-7, 1e-12])
def test_a_shear_that_rounding_cannot_explain_is_no_camera(turn: float) -> None:
    cells = [list(row) for row in shown(EDIT, "view_from_world")]
    cells[0][1] += turn
    assert recognised_camera(cells, EDIT.camera) is None  # type: ignore[arg-type]
    typed = with_matrix(EDIT, "view_from_world", cells)
    assert MATRIX["not-rigid"] in texts(typed, "view_from_world")


# --------------------------------------------------------------------------- bad input


@pytest.mark.parametrize(
    ("value", "bound"),
    [
        (math.nan, "must be a finite number"),
        (math.inf, "must be a finite number"),
        (1e101, "must be at most 1e+100"),
        (-1e101, "must be at least -1e+100"),
        (10**400, "must be at most 1e+100"),
    ],
)
def test_an_impossible_cell_is_named(value: Any, bound: str) -> None:
    for name in EDITABLE:
        with pytest.raises(Refusal, match="0, 2") as caught:
            with_cell(EDIT, name, 0, 2, value)
        assert caught.value.field == f"{name}[0, 2]"
        assert str(caught.value).endswith(f": {bound}.")


@pytest.mark.parametrize("matrix", [[], [[1.0] * 4] * 3, [[1.0] * 3] * 4, 7, None, "abcd"])
def test_only_two_matrices_of_four_rows_can_be_typed(matrix: Any) -> None:
    for make in (FreeMatrix, lambda cells: with_matrix(EDIT, "clip_from_view", cells)):
        with pytest.raises(Refusal, match="four rows of four finite numbers"):
            make(matrix)
    with pytest.raises(Refusal, match="view_from_world, clip_from_view"):
        with_cell(EDIT, "image_from_ndc", 0, 0, 1.0)


# --------------------------------------------------------------------------- properties

UPRIGHT = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, -1.0, 0.0), (0.0, 0.0, 0.0, 1.0))


@pytest.mark.parametrize(
    ("name", "row", "column", "value", "found"),
    [
        ("clip_from_view", 0, 1, 0.5, [MATRIX["not-affine"], MATRIX["w-vanishes"]]),
        (
            "clip_from_view",
            0,
            0,
            0.0,
            [MATRIX["singular"], MATRIX["not-affine"], MATRIX["w-vanishes"]],
        ),
        (
            "clip_from_view",
            0,
            0,
            -1.0,
            [MATRIX["mirrored-clip"], MATRIX["not-affine"], MATRIX["w-vanishes"]],
        ),
        ("clip_from_view", 3, 2, 0.0, [MATRIX["singular"], MATRIX["w-is-not-positive"]]),
        (
            "clip_from_view",
            3,
            2,
            1.0,
            [
                MATRIX["mirrored-clip"],
                MATRIX["all-behind"],
                MATRIX["not-affine"],
                MATRIX["w-vanishes"],
            ],
        ),
        (
            "clip_from_view",
            2,
            2,
            0.0,
            [MATRIX["through-infinity"], MATRIX["not-affine"], MATRIX["w-vanishes"]],
        ),
        ("clip_from_view", 3, 0, 0.05, [MATRIX["not-affine"], MATRIX["w-vanishes"]]),
        (
            "view_from_world",
            0,
            0,
            -1.0,
            [MATRIX["mirrored-view"], MATRIX["not-rigid"], MATRIX["affine"]],
        ),
        ("view_from_world", 0, 0, 2.0, [MATRIX["not-rigid"], MATRIX["affine"]]),
        ("view_from_world", 3, 2, 0.5, [MATRIX["not-affine"], MATRIX["w-vanishes"]]),
        ("view_from_world", 3, 3, 0.0, [MATRIX["singular"], MATRIX["w-is-not-positive"]]),
    ],
)
def test_the_effects_of_a_matrix_are_named(
    name: str, row: int, column: int, value: float, found: list[str]
) -> None:
    typed = edited(row, column, value, name)
    assert texts(typed, name) == found
    if name == "view_from_world":
        assert MATRIX["mirrored-clip"] not in texts(typed) and MATRIX["singular"] not in texts(
            typed
        )
        assert properties(typed, "clip_from_world") == []


def said(projection: Projection) -> list[str]:
    return [str(each) for each in properties(projection, "clip_from_view")]


@pytest.mark.parametrize(
    ("row", "found"),
    [
        ((0, 0, -1, 0), "z"),
        ((0, 2, 0, 0), "y"),
        ((0, 0, -1, 2), "−z + 2"),
        ((1, 0, -1, 0), "x − z"),
    ],
)
def test_where_w_vanishes_is_written_as_an_equation(row: Any, found: str) -> None:
    cells = [list(line) for line in shown(EDIT, "clip_from_view")]
    cells[0][1], cells[3] = 0.5, list(row)
    text = f"w vanishes where {found} = 0: the divide sends these points to infinity"
    assert text in said(with_matrix(EDIT, "clip_from_view", cells))


def test_an_affine_matrix_is_named_with_its_w_and_a_mirrored_one_with_all_pairs() -> None:
    cells = shown(EDIT, "clip_from_view")
    pairs = "mirrored: as if left and right, top and bottom, or near and far were exchanged"
    assert pairs in said(edited(1, 1, -cells[1][1]))
    sheared = [list(row) for row in UPRIGHT]
    sheared[0][1], sheared[3][3] = 0.5, 2.0
    typed = with_matrix(EDIT, "clip_from_view", sheared)
    assert said(typed) == ["affine: w is 2 everywhere"]


@pytest.mark.parametrize(
    ("rank", "rows"), [(0, ()), (1, (0,)), (2, (0, 3)), (3, (0, 1, 3)), (3, (1, 2, 3))]
)
def test_the_rank_is_stated(rank: int, rows: tuple[int, ...]) -> None:
    cells = [list(row) if i in rows else [0.0] * 4 for i, row in enumerate(UPRIGHT)]
    typed = with_matrix(EDIT, "clip_from_view", cells)
    assert f"singular (rank {rank}): the frustum cannot be drawn" in said(typed)
    assert typed.frustum_sign == 0
    with pytest.raises(Refusal, match=f"its rank is {rank}"):
        typed.world_from_clip_at((0.0, 0.0, 0.0))
    assert np.isfinite(typed.trace([[0.0, 2.0, 0.0]]).clip).all()


def test_rounding_does_not_change_the_rank() -> None:
    """0.1 0.9 - 0.3 0.3 is 0 in decimals, but not for the nearest floats."""
    cells = [[0.1, 0.3, 0, 0], [0.3, 0.9, 0, 0], [0, 0, -1.0, -2.0], [0, 0, -1.0, 0]]
    assert np.linalg.matrix_rank(cells) == 3
    assert MATRIX["singular"] not in texts(with_matrix(EDIT, "clip_from_view", cells))
    cells[0][0], cells[1][1] = 0.5, 0.18
    cells[0][1] = cells[1][0] = 0.3
    assert eliminate(rationals(cells)).rank == 4
    cells[0][:2], cells[1][:2] = [0.1, 0.2], [0.3, 0.6]  # doubling is exact
    assert MATRIX["singular"] in texts(with_matrix(EDIT, "clip_from_view", cells))


@pytest.mark.parametrize(("lens", "depth"), with_depths(TYPED))
def test_no_lens_is_mirrored_in_any_depth_range(lens: Lens, depth: Any) -> None:
    projection = replace(EDIT, lens=lens, depth=depth)
    assert properties(projection, "clip_from_view") == []
    free = projection.with_lens("matrix")
    assert MATRIX["mirrored-clip"] not in texts(free) and MATRIX["singular"] not in texts(free)
    mirrored = np.array(shown(projection, "clip_from_view")) * [[-1.0], [1.0], [1.0], [1.0]]
    assert MATRIX["mirrored-clip"] in texts(replace(projection, lens=FreeMatrix(mirrored.tolist())))


# --------------------------------------------------------------------------- the model under it


@pytest.mark.parametrize(("lens", "depth"), with_depths(TYPED))
def test_a_lens_cells_as_a_free_matrix_make_the_same_picture(lens: Lens, depth: Any) -> None:
    projection = replace(EDIT, lens=lens, depth=depth)
    free = projection.with_lens("matrix")
    points = np.random.default_rng(1).uniform(-5.0, 5.0, (200, 3))
    before, after = projection.trace(points), free.trace(points)
    assert np.array_equal(before.in_front, after.in_front)
    near = np.abs(np.nan_to_num(before.image)).max(axis=1) < 1e5
    assert np.allclose(after.image[near], before.image[near], rtol=1e-9, equal_nan=True)
    assert np.allclose(after.depth[near], before.depth[near], atol=1e-9, equal_nan=True)
    assert np.array_equal(before.outside[near], after.outside[near])
    if lens.far < math.inf:
        assert free.frustum_sign == 1
        assert np.allclose(corners_world(free), corners_world(projection), rtol=1e-6)
        assert free.passage.least_w == pytest.approx(projection.passage.least_w, rel=1e-9)
        inside = ~after.outside.any(axis=1)
        back = free.world_from_image(np.column_stack([after.image, after.depth])[inside])
        assert np.allclose(back, points[inside], atol=1e-6)
    for other in DEPTH_RANGES:
        moved = free.with_depth(other)  # type: ignore[arg-type]
        expected = projection.with_depth(other).trace(points)  # type: ignore[arg-type]
        assert np.allclose(
            moved.trace(points).ndc[near], expected.ndc[near], atol=1e-9, equal_nan=True
        )
    assert free.with_lens(lens.kind) == projection
    assert free.with_lens("matrix") is free


FREE = {
    "sheared": edited(0, 1, 0.5),
    "projective": with_cell(edited(3, 0, 0.25), "clip_from_view", 3, 3, 20.0),
    "mirrored": edited(0, 0, -1.0),
    "singular": edited(0, 0, 0.0),
    "flat": edited(2, 2, 0.0).with_depth("direct3d"),
    "scaled view": edited(0, 0, 2.0, "view_from_world"),
    "projective view": edited(3, 0, 0.05, "view_from_world"),
    "all zero": with_matrix(EDIT, "clip_from_view", [[0.0] * 4] * 4),
}


@pytest.mark.parametrize("projection", FREE.values(), ids=FREE)
def test_points_are_the_products_of_the_shown_matrices(projection: Projection) -> None:
    """Products in rationals of the same cells; points behind the eye have no image."""
    points = np.random.default_rng(2).uniform(-6.0, 6.0, (40, 3))
    view, *_ = (rationals(stage.exact) for stage in projection.stages[1:2])
    clip = product(projection.exact_clip_from_view, view)
    trace = precision.trace(projection, points, "exact")
    plain = projection.trace(points)
    for i, point in enumerate(points.tolist()):
        column = [[Fraction(part)] for part in (*point, 1.0)]
        true = [float(row[0]) for row in product(clip, column)]
        assert np.allclose(trace.clip[i], true, rtol=1e-14, atol=1e-13)
        assert np.allclose(plain.clip[i], true, rtol=1e-12, atol=1e-12)
        if true[3] > 0.0:
            width, height = projection.image_size
            x, y = true[0] / true[3], true[1] / true[3]
            assert np.allclose(
                trace.image[i], [(x + 1.0) * width / 2.0, (1.0 - y) * height / 2.0], rtol=1e-9
            )
        else:
            assert np.isnan(trace.image[i]).all() and np.isnan(plain.image[i]).all()
            assert np.isnan(trace.ndc[i]).all() and not plain.in_front[i]
    predictions = precision.predict(projection, points)
    if predictions is not None:
        single = precision.trace(projection, points, "float32")
        seen = plain.in_front & single.in_front
        off = np.abs(single.image[seen] - trace.image[seen]).max(initial=0.0)
        rounded = 1e-12 * np.abs(trace.image[seen]).max(initial=0.0)  # the exact precision's own
        assert off <= predictions["float32"].px + rounded
        off = np.abs(plain.image[seen] - trace.image[seen]).max(initial=0.0)
        assert off <= predictions["float64"].px + rounded


@pytest.mark.parametrize("projection", FREE.values(), ids=FREE)
def test_a_free_matrix_refuses_the_properties_of_a_lens(projection: Projection) -> None:
    for ask in (
        lambda: projection.window,
        lambda: projection.intrinsics,
        lambda: projection.between(1.0, 2.0),
        lambda: projection.matrices_between(1.0, 2.0),
    ):
        with pytest.raises(Refusal, match=r"^lens\.kind = 'matrix': must be one of perspective"):
            ask()
    assert [stage.name for stage in projection.stages] == [
        "world_from_object", "view_from_world", "image_from_ndc",
    ]  # fmt: skip
    direct = projection.direct_stages
    assert [stage.name for stage in direct] == ["clip_from_view", "clip_from_world"]
    assert direct[0].matrix.tolist() == projection.clip_from_view.tolist()


def test_the_largest_cells_overflow_nothing() -> None:
    largest = [[LARGEST] * 4] * 4
    projection = Projection(lens=FreeMatrix(largest, largest))  # type: ignore[arg-type]
    trace = projection.trace([[LARGEST] * 3, [0.0, 0.0, 0.0]])
    assert np.isfinite(trace.clip).all()


def test_where_infinity_lies_in_the_volume_there_is_no_frustum() -> None:
    """The inverse's w is x + shift, which has one sign at all corners only for |shift| > 1."""
    for shift, sign in ((0.5, 0), (-0.5, 0), (2.0, 1), (-2.0, -1)):
        inverse = np.eye(4)
        inverse[3] = 1.0, 0.0, 0.0, shift
        cells: Any = np.linalg.inv(inverse).tolist()
        assert Projection(lens=FreeMatrix(cells)).frustum_sign == sign, shift
