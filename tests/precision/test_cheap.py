"""Cheap arithmetic against 700 digits, the program's own float32, and points done by hand."""

import itertools
import math
from fractions import Fraction

import numpy as np
import pytest

from app.arithmetic.formats import FORMATS, QUANTISED, RECIPROCALS, SNAPS
from app.model.projection import Camera, Lens, Orthographic, Perspective, Projection
from app.model.refusal import Refusal
from app.precision.cheap import CELLS, Hardware, cheap, cheap_formats, stored
from app.precision.levels import cell_terms, trace
from tests.fuzz.cheap import ratios_of
from tests.support.lenses import LENSES, SLANTED, free_matrix
from tests.support.reference import Reference
from tests.support.samples import pairwise, with_depths

EVERY_LENS = LENSES | {"matrix": free_matrix()}
STRAIGHT = Camera((0.0, 0.0, 4.0), (0.0, 0.0, 0.0))
POINTS = np.random.default_rng(1).uniform(-3.0, 3.0, (200, 3))


@pytest.mark.parametrize("seed", range(40))
def test_no_bound_is_below_the_error_in_random_documents(seed: int) -> None:
    """``python3 -m tests.fuzz cheap`` draws many more."""
    ratios_of(seed)


@pytest.mark.parametrize(("lens", "depth"), with_depths(EVERY_LENS))
def test_every_choice_of_hardware_is_within_its_bounds(lens: Lens, depth: str) -> None:
    projection = Projection(SLANTED, lens, depth=depth)
    reference = Reference.of(projection, POINTS)
    chosen = itertools.product(
        ("float64", "float16", "8 bits", "13 bits"), FORMATS, SNAPS, RECIPROCALS
    )
    for names in pairwise(chosen):
        picture = cheap(projection, POINTS, Hardware(*names))
        errors = reference.errors(np.column_stack([picture.image, picture.depth]))
        known = ~np.isnan(errors)
        assert known.any()
        assert (errors[known] <= picture.bounds[known]).all(), names
        # The bound of a class: good for something, not only true.
        finite = known & np.isfinite(picture.bounds)
        assert np.median(picture.bounds[finite]) < 40.0 * np.median(errors[finite]), names


@pytest.mark.parametrize(("lens", "depth"), with_depths(EVERY_LENS))
def test_float32_is_the_programs_own_to_the_last_bit(lens: Lens, depth: str) -> None:
    projection = Projection(SLANTED, lens, (801, 333), depth)
    for origin in ((0.0, 0.0, 0.0), (1.5, -2.0, 0.3)):
        traced = trace(projection, POINTS, "float32", origin)
        picture = cheap(projection, POINTS, Hardware(), origin)
        assert np.array_equal(picture.image, traced.image, equal_nan=True)
        assert np.array_equal(picture.depth, traced.depth, equal_nan=True)


def test_the_cells_of_a_matrix_are_within_their_error() -> None:
    for lens in EVERY_LENS.values():
        for camera in (SLANTED, Camera((1e6, -3.0, 2e5), (1e6 + 3.0, 0.0, 2e5))):
            projection = Projection(camera, lens)
            cells = projection.clip_from_local(camera.eye)
            lost = CELLS * cell_terms(projection, projection.local_to_eye(camera.eye))
            exact = projection.exact_from_eye[1]
            for true_row, row, errors in zip(exact, cells, lost, strict=True):
                for true, cell, error in zip(true_row, row.tolist(), errors.tolist(), strict=True):
                    assert abs(true - Fraction(cell)) <= Fraction(error)


def test_float64_is_as_good_as_the_matrix() -> None:
    projection = Projection(SLANTED)
    picture = cheap(projection, POINTS, Hardware("float64", "float64"))
    assert np.abs(picture.image - projection.trace(POINTS).image).max() < 1e-11
    assert picture.bounds[:, :2].max() < 1e-11


def test_a_point_done_by_hand_in_half_floats() -> None:
    """A square picture with a field of 90 degrees: x' = x/w, and 8 px are one."""
    projection = Projection(STRAIGHT, Perspective(90.0, 1.0, 9.0), (16, 16))
    picture = cheap(projection, [(1.0 + 2.0**-12, 2.0, 0.0)], Hardware("float16", "float16"))
    # x is stored as 1, and 1/4 + 1 = 5/4 of 8 px; y is 1 - 2/4 of 8 px.
    assert picture.image.tolist() == [[10.0, 4.0]]
    off_px = 2.0**-12 / 4.0 * 8.0
    assert off_px <= picture.bounds[0, 0] < 0.05


def test_the_table_divides_by_its_entry() -> None:
    projection = Projection(STRAIGHT, Perspective(90.0, 1.0, 9.0), (16, 16))
    hardware = Hardware("float64", "float64", "none", "table")
    picture = cheap(projection, [(1.0, 2.0, 0.0)], hardware)
    assert picture.image == pytest.approx(np.array([[8 + 2 * 511 / 512, 8 - 4 * 511 / 512]]))


@pytest.mark.parametrize("snap", [name for name in SNAPS if name != "none"])
def test_snapped_positions_are_on_the_grid_and_at_most_half_a_step_away(snap: str) -> None:
    projection, step = Projection(SLANTED), SNAPS[snap]
    free = cheap(projection, POINTS, Hardware("float64", "float64"))
    snapped = cheap(projection, POINTS, Hardware("float64", "float64", snap))
    assert (snapped.image / step % 1.0 == 0.0).all()
    away = np.abs(snapped.image - free.image)
    assert 0.45 * step < away.max() <= step / 2.0
    assert np.array_equal(snapped.depth, free.depth)
    assert (snapped.bounds[:, :2] >= away).all()


def test_formats_that_are_compared_are_those_of_one_picture_each() -> None:
    projection, names = Projection(SLANTED), ("8 bits", "float16", "float64")
    box = [(-3.0, -3.0, -3.0), (3.0, 3.0, 3.0)]
    for name, picture in zip(
        names, cheap_formats(projection, POINTS, Hardware(), names, box=box), strict=True
    ):
        alone = cheap(projection, POINTS, Hardware(name), box=box)
        for part, of_one in zip(picture, alone, strict=True):
            assert np.array_equal(part, of_one)


def test_stored_vertices_are_where_the_format_has_them() -> None:
    box = [(-3.0, -3.0, -3.0), (3.0, 3.0, 3.0)]
    for name in QUANTISED:
        step = 6.0 / (2.0 ** QUANTISED[name] - 1.0)
        places = stored(POINTS, Hardware(name), box=box)
        counts = (places + 3.0) / step
        assert np.allclose(counts, np.rint(counts), rtol=0, atol=1e-6)
        assert 0.45 * step < np.abs(places - POINTS).max() <= 0.5001 * step
    origin = np.array((1.0, 0.0, 0.0))
    halves = stored(POINTS, Hardware("float16"), (1.0, 0.0, 0.0))
    assert np.array_equal(halves, (POINTS - origin).astype(np.float16) + origin)
    assert np.isnan(stored([(4.0, 0.0, 0.0)], Hardware("8 bits"), box=box)).any()


def test_each_bit_of_the_vertices_halves_the_error_and_the_bound() -> None:
    projection = Projection(SLANTED)
    reference = Reference.of(projection, POINTS)
    errors, bounds = [], []
    for name in QUANTISED:
        picture = cheap(projection, POINTS, Hardware(name, "float64"))
        numbers = np.column_stack([picture.image, picture.depth])
        errors.append(float(reference.errors(numbers)[:, :2].max()))
        bounds.append(float(picture.bounds[:, :2].max()))
    assert np.array(bounds)[:-1] / bounds[1:] == pytest.approx(np.full(8, 2.0), rel=0.35)
    assert all(0.5 * bound < error <= bound for error, bound in zip(errors, bounds, strict=True))
    assert np.array(errors)[:-1] / errors[1:] == pytest.approx(np.full(8, 2.0), rel=0.35)


def test_a_vertex_on_its_grid_is_off_by_roundings_of_float64_alone() -> None:
    """A cube of a mesh's box, whose corners every grid has but for a rounding of the step."""
    projection, box = Projection(SLANTED), np.array([(-0.7, -0.7, -0.7), (1.3, 1.3, 1.3)])
    corners = np.array([(x, y, z) for x in box[:, 0] for y in box[:, 1] for z in box[:, 2]])
    for name in QUANTISED:
        picture = cheap(projection, corners, Hardware(name, "float64"), box=box)
        numbers = np.column_stack([picture.image, picture.depth])
        errors = Reference.of(projection, corners).errors(numbers)
        assert (errors <= picture.bounds).all() and picture.bounds.max() < 1e-9


def test_a_vertex_that_the_format_has_loses_nothing() -> None:
    projection = Projection(SLANTED, image_size=(1024, 512))
    whole = np.round(POINTS)
    stored = [cheap(projection, whole, Hardware(name, "float64")) for name in FORMATS]
    for picture in stored[1:]:
        assert np.array_equal(picture.bounds, stored[0].bounds)


def test_the_arithmetic_loads_vertices_in_its_own_format() -> None:
    projection = Projection(SLANTED)
    halves = [
        cheap(projection, POINTS, Hardware(name, "float16")) for name in ("float16", "float64")
    ]
    assert np.array_equal(halves[0].image, halves[1].image)


def test_far_from_its_origin_a_vertex_jumps() -> None:
    moved = 1e6
    camera = Camera((moved, 0.0, 4.0), (moved, 0.0, 0.0))
    point = [(moved + 0.3, 0.2, 0.0)]
    far = cheap(Projection(camera), point, Hardware())
    near = cheap(Projection(camera), point, Hardware(), (moved, 0.0, 0.0))
    right = Projection(camera).trace(point).image
    assert np.abs(far.image - right).max() > 1.0
    assert np.abs(near.image - right).max() < 1e-3
    assert far.bounds[0, 0] > 1.0 and near.bounds[0, 0] < 1e-2


@pytest.mark.parametrize(
    ("hardware", "point"),
    [
        (Hardware("float16", "float16"), (7e4, 0.0, -9e4)),
        (Hardware("float64", "float16"), (4e4, 4e4, -3e4)),
        (Hardware("fixed 16.16", "fixed 16.16"), (0.0, 4e4, 0.0)),
        (Hardware("float64", "fixed 16.16"), (3e4, 0.0, 3.9)),
        (Hardware("float32", "bfloat16"), (1e39, 0.0, 0.0)),
        (Hardware("10 bits"), (0.0, 2.0, 0.0)),
        (Hardware(), (0.0, 0.0, 5.0)),
    ],
    ids=["stored", "summed", "fixed", "divided", "exponent", "box", "behind"],
)
def test_what_is_out_of_range_has_no_number(
    hardware: Hardware, point: tuple[float, float, float]
) -> None:
    box = [(-1.0, -1.0, -1.0), (1.0, 1.0, 1.0)]
    picture = cheap(Projection(STRAIGHT), [point, (0.5, 0.5, 0.0)], hardware, box=box)
    assert np.isnan(picture.image[0]).all() and math.isnan(picture.depth[0])
    assert np.isinf(picture.bounds[0]).all()
    assert np.isfinite(picture.image[1]).all()


def test_where_w_may_be_0_the_bound_is_infinite() -> None:
    picture = cheap(Projection(STRAIGHT), [(0.1, 0.0, 3.996)], Hardware("float64", "bfloat16"))
    assert np.isinf(picture.bounds).all()


def test_a_parallel_lens_divides_by_no_table() -> None:
    projection = Projection(STRAIGHT, Orthographic(-4.0, 4.0, -2.0, 2.0))
    exact, table = (cheap(projection, POINTS, Hardware(reciprocal=r)) for r in ("exact", "table"))
    assert np.array_equal(exact.image, table.image) and np.array_equal(exact.bounds, table.bounds)


def test_a_width_that_the_format_does_not_have_is_counted() -> None:
    points = np.zeros((1000, 3))
    values = np.random.default_rng(6).uniform(0.0, 1.0, 1000)
    points[:, 0] = FORMATS["bfloat16"].rounded(values)
    lens = Orthographic(-1.0, 1.0, -1.0, 1.0)
    for width in range(513, 600):
        projection = Projection(STRAIGHT, lens, (width, 512))
        picture = cheap(projection, points, Hardware("bfloat16", "bfloat16"))
        right = (points[:, 0] + 1.0) * width / 2.0
        assert (np.abs(picture.image[:, 0] - right) <= picture.bounds[:, 0]).all()


def test_no_points_have_no_picture() -> None:
    picture = cheap(Projection(), np.zeros((0, 3)), Hardware("8 bits", "float16"))
    assert picture.image.shape == (0, 2) and picture.bounds.shape == (0, 3)


@pytest.mark.parametrize("field", ["vertices", "numbers", "snap", "reciprocal"])
def test_an_unknown_name_is_refused(field: str) -> None:
    with pytest.raises(Refusal, match=f"{field} .*17 bits"):
        Hardware(**{field: "17 bits"})


def test_bytes_of_a_vertex() -> None:
    sizes = [
        Hardware(name).bytes_per_vertex for name in ("float64", "float16", "8 bits", "12 bits")
    ]
    assert sizes == [24.0, 6.0, 3.0, 4.5]
