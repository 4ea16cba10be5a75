"""L2: the object's own transform, against turning points by hand and against mpmath."""

import math
from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.arithmetic import double_double as dd
from app.model.chain import KINDS, MOST_TILES, ORDERS, Chain, FiveTiles, Tile, view_chain
from app.model.projection import (
    DEPTH_RANGES,
    Array,
    Camera,
    FreeMatrix,
    Lens,
    Perspective,
    Projection,
)
from app.model.refusal import Refusal
from app.precision.levels import PRECISIONS, drawing_bounds_px, predict, trace
from tests.oracles import exact
from tests.support.lenses import ONE_OF_EACH

TURNED = FiveTiles((1.0, 2.0, 3.0), (0.0, 90.0, 0.0), (2.0, 1.0, 0.5)).chain


def test_l2_the_columns_are_the_objects_axes_and_its_origin() -> None:
    """Turned by 90 degrees about y, x points to -z and z to x; each is as long as its scale."""
    assert TURNED.matrix.tolist() == [
        [0.0, 0.0, 0.5, 1.0],
        [0.0, 1.0, 0.0, 2.0],
        [-2.0, 0.0, 0.0, 3.0],
        [0.0, 0.0, 0.0, 1.0],
    ]


@pytest.mark.parametrize(
    ("turn", "seen"),
    [
        ((90.0, 0.0, 0.0), (0.0, 0.0, 1.0)),  # y goes to z
        ((0.0, 90.0, 0.0), (0.0, 1.0, 0.0)),
        ((0.0, 0.0, 90.0), (-1.0, 0.0, 0.0)),  # y goes to -x
        ((90.0, 90.0, 0.0), (1.0, 0.0, 0.0)),  # first about x, then y takes z to x
    ],
)
def test_l2_turns_are_right_handed_about_x_then_y_then_z(
    turn: tuple[float, ...], seen: tuple[float, ...]
) -> None:
    found = FiveTiles(rotate_deg=turn).chain.matrix[:3, :3] @ [0.0, 1.0, 0.0]  # type: ignore[arg-type]
    assert tuple(found.tolist()) == seen


def test_l2_the_two_orders_differ_in_where_the_object_is_and_not_in_how_it_lies() -> None:
    """T R turns it where it stands; R T carries it round the world's origin."""
    there, round_it = (
        Chain.read(text)
        for text in ("translate 2,0,0; rotate z 90", "rotate z 90; translate 2,0,0")
    )
    assert there.matrix[:3, 3].tolist() == [2.0, 0.0, 0.0]
    assert round_it.matrix[:3, 3].tolist() == [0.0, 2.0, 0.0]
    assert np.array_equal(there.matrix[:3, :3], round_it.matrix[:3, :3])


def test_l2_the_stage_comes_first_with_its_factors() -> None:
    stage = Projection(placement=TURNED).stages[0]
    assert stage.name == "world_from_object"
    assert [name for name, _ in stage.factors] == [
        "translation",
        "rotation_z",
        "rotation_y",
        "rotation_x",
        "scale",
    ]
    product = np.eye(4)
    for _, factor in stage.factors:
        product = product @ factor
    assert np.array_equal(product, stage.matrix) and np.array_equal(stage.matrix, TURNED.matrix)
    assert Projection().stages[0].factors == ()


def test_where_the_object_is_not_moved_nothing_changes_to_the_last_bit() -> None:
    points = np.random.default_rng(3).normal(size=(200, 3)) * 4.0
    turned_round = Projection(placement=FiveTiles(rotate_deg=(360.0, -720.0, 0.0)).chain)
    for level in PRECISIONS:
        own, world = (
            trace(turned_round, points, level, space="object"),
            trace(Projection(), points, level),
        )
        for a, b in zip(own, world, strict=True):
            assert np.array_equal(a, b, equal_nan=True)


def hard(rng: np.random.Generator) -> Iterator[Projection]:
    """Objects near and far, turned by much and by next to nothing, under every lens and level."""
    lenses = [*ONE_OF_EACH.values(), Perspective(1e-4, 0.1, math.inf)]
    for away, angle_deg, lens, order in product(
        (0.0, 1e3, 1e9), (1e-9, 33.0, 12345.678), lenses, ORDERS
    ):
        centre = move = away * rng.normal(size=3)
        eye = centre + rng.normal(size=3) * 5.0
        camera = Camera(tuple(eye.tolist()), tuple(centre.tolist()))
        turn = FiveTiles(rotate_deg=tuple(angle_deg * rng.normal(size=3)))
        if order == "rts":  # so that it gets to the same place
            move = np.linalg.solve(turn.chain.matrix[:3, :3], centre)
        scale = tuple(10.0 ** rng.uniform(-2, 2, 3) * rng.choice([-1.0, 1.0], 3))
        placement = FiveTiles(tuple(move.tolist()), turn.rotate_deg, scale, order).chain
        depth = str(rng.choice(sorted(DEPTH_RANGES)))
        yield Projection(camera, lens, (1920, 1080), depth, placement)  # type: ignore[arg-type]


def test_an_object_far_away_that_is_turned_by_next_to_nothing_is_within_every_bound() -> None:
    rng, counted = np.random.default_rng(20), 0
    with exact.mp.workdps(120):
        for projection in hard(rng):
            points = rng.normal(size=(4, 3))
            points /= np.abs(projection.placement.tiles[-1].numbers)  # a unit or so in the world
            bounds = predict(projection, points, space="object")
            oracle = exact.Exact(projection)
            answers = [oracle(exact.placed(projection.placement, p)) for p in points]
            for level in PRECISIONS:
                found = trace(projection, points, level, space="object")
                for answer, view, image, depth in zip(
                    answers, found.view, found.image, found.depth, strict=True
                ):
                    if not np.isfinite(image).all():
                        continue
                    assert bounds is not None
                    px, of_depth = bounds[level]
                    off = max(abs(a - float(b)) for a, b in zip(answer.image, image, strict=True))
                    assert off <= px, (level, projection)
                    assert abs(answer.depth - float(depth)) <= of_depth, (level, projection)
                    counted += 1
                    if level == "exact":
                        numbers = [*answer.image, answer.depth, *answer.view]
                        for true, one in zip(numbers, [*image, depth, *view], strict=True):
                            assert abs(true - float(one)) <= 0.5001 * np.spacing(abs(float(one)))
    assert counted > 500


def test_float64_places_a_far_object_as_exactly_as_a_near_one() -> None:
    """1e9 away and turned by 1e-9 degrees, where world coordinates in float64 are 1e-7 off."""
    away = 1e9
    camera = Camera((away + 5.0, away, away), (away, away, away))
    placement = FiveTiles((away, away, away), (0.0, 1e-9, 0.0)).chain
    projection = Projection(
        camera, Perspective(45.0, 0.1, 100.0), (1920, 1080), placement=placement
    )
    points = np.array([[0.3, 0.1, 0.7], [1e-7, 1e-9, -1e-8]])
    found = trace(projection, points, "float64", space="object").image
    with exact.mp.workdps(80):
        oracle = exact.Exact(projection)
        for point, image in zip(points, found, strict=True):
            truth = oracle(exact.placed(placement, point)).image
            assert max(abs(a - float(b)) for a, b in zip(truth, image, strict=True)) < 1e-11
    rounded = projection.trace(projection.placed(points, "object").world).image
    assert np.abs(rounded - found).max() > 1e-6


def test_the_gpus_matrix_is_right_and_its_bound_holds() -> None:
    rng = np.random.default_rng(5)
    corners = np.array([[(i >> k & 1) * 2.0 - 1.0 for k in range(3)] for i in range(8)])
    with exact.mp.workdps(80):
        for projection in hard(rng):
            boxes = (corners / np.abs(projection.placement.tiles[-1].numbers)).reshape(1, 8, 3)
            (bound_px,) = drawing_bounds_px(projection, [(boxes, "object")])
            found = trace(projection, boxes[0], "float32", space="object")
            oracle = exact.Exact(projection)
            for point, image, outside in zip(boxes[0], found.image, found.outside, strict=True):
                if outside.any() or not np.isfinite(image).all():
                    continue
                truth = oracle(exact.placed(projection.placement, point)).image
                off = max(abs(a - float(b)) for a, b in zip(truth, image, strict=True))
                assert off <= bound_px, projection


def test_what_placed_coordinates_lack_is_bounded() -> None:
    rng = np.random.default_rng(6)
    for projection in hard(rng):
        points = rng.normal(size=(3, 3)) * 10.0 ** rng.uniform(-9, 9, (3, 1))
        found = projection.placed(points, "object")
        assert found.rest is not None
        for point, high, low, lost in zip(points, found.world, found.rest, found.lost, strict=True):
            truth = projection.placement.exactly(point.tolist())
            off = sum(
                abs(true - Fraction(a) - Fraction(b))
                for true, a, b in zip(truth, high.tolist(), low.tolist(), strict=True)
            )
            assert off <= lost <= 1e-28 * (1e9 + np.abs(high).sum() + np.abs(point).sum() * 1e3)


@given(st.floats(-1e6, 1e6))
def test_sines_and_cosines_have_all_their_bits(angle_deg: float) -> None:
    cos, sin = dd.cos_sin_deg(Fraction(angle_deg))
    with exact.mp.workdps(90):
        angle = exact.mp.radians(exact.mp.mpf(angle_deg))
        for found, true in ((cos, exact.mp.cos(angle)), (sin, exact.mp.sin(angle))):
            mine = exact.mp.mpf(found.numerator) / found.denominator
            assert abs(mine - true) < exact.mp.mpf(2) ** -240


def test_back_to_the_object_each_number_is_rounded_once() -> None:
    point = TURNED.placed(np.array([[0.25, 1.0, 2.0]])).world[0]
    assert TURNED.object_from_world((*point, 1.0)) == (0.25, 1.0, 2.0, 1.0)
    assert TURNED.object_from_world((0.0, 0.0, 2.0, 0.0)) == (-1.0, 0.0, 0.0, 0.0)
    with pytest.raises(Refusal) as caught:
        FiveTiles(scale=(1.0, 0.0, 1.0)).chain.object_from_world((1.0, 2.0, 3.0, 1.0))
    assert caught.value.field == "world_from_object"


def test_a_coordinate_of_the_object_beyond_float64_is_infinite() -> None:
    """A probe's field takes 1e99, and the panel shows it on the object too."""
    tiny = FiveTiles(scale=(1e-300, 1.0, 1.0), translate=(0.0, 2.0, 0.0)).chain
    assert tiny.object_from_world((1e99, 2.0, 3.0, 1.0)) == (math.inf, 0.0, 3.0, 1.0)
    assert tiny.object_from_world((-1e99, 2.0, 3.0, 1.0))[0] == -math.inf


def test_a_scale_of_0_flattens_and_says_what_is_gone() -> None:
    flat = FiveTiles(rotate_deg=(10.0, 20.0, 30.0), scale=(1.0, 0.0, 1.0)).chain
    assert flat.rank == 2 and FiveTiles(scale=(0.0, 0.0, 0.0)).chain.rank == 0
    stage = Projection(placement=flat).stages[0]
    assert "inverse" in stage.note and not Projection(placement=TURNED).stages[0].note
    seen = Projection(placement=flat).trace([[1.0, 5.0, 2.0], [1.0, -7.0, 2.0]], "object")
    assert np.array_equal(seen.image[0], seen.image[1]) and np.isfinite(seen.image).all()


@pytest.mark.parametrize("lens", [FreeMatrix(np.eye(4).tolist()), Perspective()])
def test_a_typed_matrix_goes_through_it_as_well(lens: Lens) -> None:
    projection = Projection(lens=lens, placement=TURNED)
    point: Array = np.array([0.5, 1.0, 2.0])
    whole = projection.trace(point, "object")
    hand = projection.trace([1.0 + 0.5 * 2.0, 2.0 + 1.0, 3.0 - 2.0 * 0.5])
    assert np.array_equal(whole.clip, hand.clip) and np.array_equal(whole.world, hand.world)


@pytest.mark.parametrize(
    ("values", "field"),
    [
        ({"scale": (1.0, math.nan, 1.0)}, "scale"),
        ({"rotate_deg": (0.0, math.inf, 0.0)}, "rotate_deg"),
        ({"translate": (1e308, 0.0, 0.0)}, "translate"),
        ({"translate": (0.0, 0.0)}, "translate"),
        ({"scale": (1.0, -2e30, 1.0)}, "scale"),
        ({"order": "srt"}, "order"),
    ],
)
def test_bad_numbers_are_refused_by_name(values: dict[str, object], field: str) -> None:
    with pytest.raises(Refusal) as caught:
        FiveTiles(**values)  # type: ignore[arg-type]
    assert caught.value.field == field


def test_the_largest_object_has_a_picture_or_none_but_numbers() -> None:
    huge = FiveTiles((1e100, -1e100, 1e100), (10.0, 20.0, 30.0), (1e30, -1e30, 1e-100)).chain
    found = Projection(placement=huge).trace([(1e100, 1e100, -1e100), (0.0, 1.0, 0.0)], "object")
    assert np.isfinite(found.world).all() and np.isfinite(found.clip).all()
    with pytest.raises(Refusal) as caught:
        Projection().trace((0.0, 0.0, 0.0), "camera")  # type: ignore[arg-type]
    assert caught.value.field == "space"


# -- any tiles


def a_tile(rng: np.random.Generator) -> Tile:
    """A tile of any kind with numbers of 17 digits; small and large, also exact quarter turns."""
    kind = str(rng.choice(sorted(KINDS)))
    count = len(KINDS[kind].neutral)
    numbers = rng.normal(size=count) * 10.0 ** rng.uniform(-3, 3)
    if kind.startswith("rotate") and rng.random() < 0.3:
        numbers[-1] = 90.0 * rng.integers(-4, 5)
    if kind == "matrix":
        numbers[12:] = 0.0, 0.0, 0.0, 1.0
    return Tile(kind, tuple(numbers.tolist()), bool(rng.random() < 0.1))


def a_chain(rng: np.random.Generator) -> Chain:
    return Chain(tuple(a_tile(rng) for _ in range(rng.integers(1, MOST_TILES + 1))))


def test_4800_cells_of_300_chains_are_within_half_an_ulp_of_moves_one_after_the_other() -> None:
    rng, worst, cells = np.random.default_rng(51), 0.0, 0
    with exact.mp.workdps(150):
        for _ in range(300):
            chain = a_chain(rng)
            origin = exact.placed(chain, (0.0, 0.0, 0.0))
            columns = [
                [a - b for a, b in zip(exact.placed(chain, axis), origin, strict=True)]
                for axis in np.eye(3).tolist()
            ]
            truth = [[*row, o] for row, o in zip(zip(*columns, strict=True), origin, strict=True)]
            assert chain.matrix[3].tolist() == [0.0, 0.0, 0.0, 1.0]
            for row, found in zip([*truth, [0, 0, 0, 1]], chain.matrix.tolist(), strict=True):
                for cell, number in zip(row, found, strict=True):
                    cells += 1
                    off = abs(cell - number)
                    # A cell that cancels to 0 has no digit of its own.
                    size = max(np.spacing(abs(number)), 1e-60)
                    worst = max(worst, float(off / size))
    assert cells == 4800 and worst <= 0.5 + 1e-9, worst


def test_partial_products_end_at_the_whole_one_and_skip_tiles_that_are_off() -> None:
    rng = np.random.default_rng(52)
    for _ in range(100):
        chain = a_chain(rng)
        assert chain.after(0).is_identity and chain.after(len(chain.on)).exact == chain.exact
        for count in range(len(chain.on)):
            one_more = np.array(chain.factors[len(chain.on) - count - 1], dtype=np.float64)
            step = one_more @ chain.after(count).matrix
            scale = np.abs(step).max()
            assert np.abs(step - chain.after(count + 1).matrix).max() <= 1e-12 * scale


def test_moves_read_from_the_right_and_done_from_the_left_end_in_the_same_place() -> None:
    """Of 1 000 chains; half-way, a move is half of an angle, a way or a factor."""
    rng = np.random.default_rng(54)
    for _ in range(1000):
        chain = a_chain(rng)
        ends = [chain.after(len(chain.on), from_left=left).exact for left in (False, True)]
        assert ends[0] == ends[1] == chain.exact
    chain = Chain.read("translate 3,0,0; rotate 0,0,1 90; off mirror x; scale 3,1,1")
    assert chain.after(1.5).text == "rotate 0,0,1 45; scale 3,1,1"
    assert chain.after(1.5, from_left=True).text == "translate 3,0,0; rotate 0,0,1 45"
    assert chain.after(0.5).text == "scale 2,1,1"
    assert Chain.read("mirror y").after(0.75).text == "scale 1,-0.5,1"
    through = Chain.read("matrix -1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")
    assert through.after(0.5) == through  # where it would be singular


@pytest.mark.parametrize("up", [(0.0, 1.0, 0.0), None])
def test_the_moves_that_placed_a_camera_undone_are_its_view_matrix(up: Any) -> None:
    """200 cameras: their axes are rows, and the eye comes to the origin; straight down, too."""
    rng = np.random.default_rng(20)
    directions = [*rng.uniform(-1.0, 1.0, (200, 3)), np.array([0.0, -1.0, 0.0])]
    for direction in directions:
        eye = rng.uniform(-9.0, 9.0, 3)
        own = up or rng.uniform(-1.0, 1.0, 3)
        if not np.cross(direction, own).any():
            own = np.array([0.3, 0.0, 1.0])
        camera = Camera(tuple(eye), tuple(eye + direction), tuple(own))
        chain = view_chain(camera.frame, camera.eye)
        assert chain.kinds[-3:] == ("rotate x", "rotate y", "translate")
        is_steep = not direction[::2].any()
        assert (len(chain.tiles) == 3) == (up is not None or is_steep), "level"
        wanted = np.eye(4)
        wanted[:3, :3], wanted[:3, 3] = camera.frame, camera.frame @ -eye
        np.testing.assert_allclose(chain.matrix, wanted, atol=2e-14)


def test_a_chain_is_read_back_from_its_text() -> None:
    rng = np.random.default_rng(53)
    for _ in range(300):
        chain = a_chain(rng)
        assert Chain.read(chain.text) == chain
    text = "translate 3,0,0; rotate 1,1,0 30; off scale 2,1,1; shear xy 0.5; mirror x"
    assert Chain.read(text).text == text
    assert Chain.read("rotate z 90\N{DEGREE SIGN}") == Chain.read(" rotate  z   90 ")
    assert Chain.read("rotate z −90,5") == Chain.read("rotate z -90.5")  # of one number
    assert Chain.read("") == Chain()


def test_a_drag_between_two_chains_is_a_chain_and_other_kinds_jump() -> None:
    start, end = (
        Chain.read("translate 2,0,0; rotate z 90"),
        Chain.read("translate 4,2,0; rotate z 0"),
    )
    assert start.towards(end, 0.5).text == "translate 3,1,0; rotate z 45"
    assert Chain().towards(end, 0.5).text == "translate 2,1,0; rotate z 0"
    assert start.towards(Chain(), 0.5).text == "translate 1,0,0; rotate z 45"
    assert start.towards(Chain.read("rotate z 90; translate 2,0,0"), 0.5).text[:6] == "rotate"


def test_five_tiles_are_found_again_and_other_chains_have_none() -> None:
    five = FiveTiles((1.0, 2.0, 3.0), (10.0, 20.0, 30.0), (2.0, 1.0, 1.0), "rts")
    assert five.chain.five == five and Chain().five == FiveTiles()
    assert five.chain.moved(0, 1).five is None and Chain.read("mirror x").five is None


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("turn z 90", "the nearest is rotate"),
        ("rotate w 90", "finite numbers after rotate, 4 in all"),
        ("translate 1,2", "finite numbers after translate, 3 in all"),
        ("mirror x 3", "no number after mirror x"),
        ("rotate 0,0,0 30", "zero vector"),
        ("scale 1,nan,1", "finite numbers"),
        ("translate 1" + "0" * 400 + ",0,0", "finite numbers"),
        ("translate 1e200,0,0", "at most 1e+100"),
        ("scale 2e30,1,1", "at most 1e+30"),
        ("scale 1e20,1,1; scale 1e20,1,1", "product with numbers up to 1e+30"),
        ("matrix 1 2 3 4 2 4 6 8 0 0 1 0 0 0 0 1", "its rank is 2"),
        ("matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1", "no move of an object changes w"),
        ("; ".join(["mirror x"] * 9), "at most 8 tiles, but has 9"),
        ("off", "must be one of translate"),
        ("mirror x;", "must be one of translate"),
    ],
)
def test_a_bad_chain_is_refused_in_one_sentence(text: str, says: str) -> None:
    with pytest.raises(Refusal) as caught:
        Chain.read(text)
    said = str(caught.value)
    assert says in said and said.count(". ") == 0 and len(said) < 420
