"""The one placer: no label covers another one or a mark, and none jumps while something moves."""

import math
from functools import partial
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.drawings.curve_names import beside, beside_curve, stays
from app.drawings.label import HALO_EM
from app.drawings.label_placement import (
    CLOSE,
    LEADER_FROM_EM,
    SQUARE_EM,
    Ground,
    PlacedLabel,
    Places,
    Wish,
    along,
    around,
    beyond,
    candidates,
    cheapest,
    clipped,
    flanking,
    on,
    place,
    placed_label,
    room,
)
from app.drawings.layer import Silhouette
from app.scenes.scene import load

EM = 15.0
FRAME = (0.0, 0.0, 480.0, 320.0)
SPOTS = st.lists(
    st.tuples(st.floats(10.0, 470.0), st.floats(10.0, 310.0)), min_size=1, max_size=7, unique=True
)
SIZES = st.tuples(st.floats(8.0, 120.0), st.floats(8.0, 24.0))
Box = tuple[float, float, float, float]


def wish(key: object, spot: tuple[float, float], size: tuple[float, float], rank: float) -> Wish:
    return Wish(key, size, [spot], partial(around, spot, size, EM, 6.0), rank)  # type: ignore[arg-type]


def box_of(placed: PlacedLabel, size: tuple[float, float]) -> Box:
    (x, y), cos, sin = placed.centre, abs(math.cos(placed.turn)), abs(math.sin(placed.turn))
    half_x, half_y = (cos * size[0] + sin * size[1]) / 2, (sin * size[0] + cos * size[1]) / 2
    return x - half_x, y - half_y, x + half_x, y + half_y


def overlap(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


@settings(max_examples=60, deadline=None)
@given(SPOTS, st.lists(SIZES, min_size=7, max_size=7))
def test_no_label_covers_a_mark_or_another_label_or_leaves_the_pane(
    spots: list[tuple[float, float]], sizes: list[tuple[float, float]]
) -> None:
    ground = Ground(FRAME, EM)
    ground.keep(spots, 5.0)
    wishes = [wish(i, *each, float(i)) for i, each in enumerate(zip(spots, sizes, strict=False))]
    placed = place(wishes, ground)
    boxes = [box_of(each, sizes[int(str(key))]) for key, each in placed.items()]
    assert not any(overlap(one, other) for one, other in combinations(boxes, 2))
    assert not any(overlap(box, mark) for box in boxes for mark in ground.taken)
    for left, low, right, high in boxes:
        assert left >= 0.0 and low >= 0.0 and right <= FRAME[2] and high <= FRAME[3]
    assert placed == place(wishes, ground)  # the same picture gets the same labels


@settings(max_examples=60, deadline=None)
@given(SPOTS, st.tuples(st.floats(-30.0, 30.0), st.floats(-30.0, 30.0)))
def test_labels_keep_their_offsets_while_the_marks_move_and_there_is_room(
    spots: list[tuple[float, float]], way: tuple[float, float]
) -> None:
    size = 30.0, 14.0

    def wishes(dx: float, dy: float) -> list[Wish]:
        moved = [(x + dx, y + dy) for x, y in spots]
        return [wish(i, spot, size, float(i)) for i, spot in enumerate(moved)]

    before = place(wishes(0.0, 0.0), Ground(FRAME, EM))
    if len(before) < len(spots):
        return
    after = place(wishes(*way), Ground((-50.0, -50.0, 550.0, 400.0), EM), {
        key: each.kept for key, each in before.items()
    })  # fmt: skip
    for key, each in after.items():
        was = before[key]
        moved = was.centre[0] + way[0], was.centre[1] + way[1]
        assert each.centre == pytest.approx(moved) and each.kept.offset == was.kept.offset


def test_a_label_that_has_no_room_where_it_was_finds_another_place() -> None:
    spot, size = (100.0, 100.0), (40.0, 14.0)
    first = place([wish("a", spot, size, 0.0)], Ground(FRAME, EM))
    ground = Ground(FRAME, EM)
    ground.keep_box(*box_of(first["a"], size))
    again = place([wish("a", spot, size, 0.0)], ground, {"a": first["a"].kept})
    assert not overlap(box_of(again["a"], size), box_of(first["a"], size))


def test_of_two_labels_for_one_place_the_lower_rank_has_it() -> None:
    def only(rank: float, key: str) -> Wish:
        return Wish(key, (40.0, 14.0), [(100.0, 100.0)], partial(on, (100.0, 100.0)), rank)

    assert list(place([only(1.0, "later"), only(0.0, "first")], Ground(FRAME, EM))) == ["first"]


def choices(mark: tuple[float, float], *centres: tuple[float, float], away: float = 0.0) -> Places:
    """Places for the name of a mark, the best one first."""
    count = len(centres)
    return Places(
        np.array(centres), np.zeros(count), np.tile(mark, (count, 1)), np.full(count, away)
    )


def test_a_leader_does_not_cross_the_mark_of_another_label() -> None:
    mark, other, size = (100.0, 100.0), (130.0, 100.0), (40.0, 14.0)
    beyond_it, above_it = (170.0, 100.0), (170.0, 130.0)
    ways = partial(choices, mark, beyond_it, above_it, away=50.0)
    wishes = [
        Wish("a", size, [mark], ways),
        Wish("b", size, [other], partial(choices, other, (130.0, 60.0))),
    ]
    placed = place(wishes, Ground(FRAME, EM))
    assert placed["a"].leader is not None and placed["a"].centre == above_it
    placed = place(wishes[:1], Ground(FRAME, EM))
    assert placed["a"].centre == beyond_it


@pytest.mark.parametrize("number", [1, 2])
def test_what_names_more_than_a_point_does_not_slide_beside_it(number: int) -> None:
    """It could come to lie over the line between its points."""
    frame, size = room(16.0 * EM, 16.0 * EM, EM), (12.0 * EM, EM)
    spots = [(5.0 * EM, y * EM) for y in (5.0, 11.0)][:number]
    made = around(np.mean(spots, axis=0), size, EM)
    _, places = Wish("near", size, spots, lambda: made).choices(Ground(frame, EM))
    near = made.away <= LEADER_FROM_EM * EM
    assert (places.centres[near] == made.centres[near]).all() == (number == 2)


@pytest.mark.parametrize(("halo", "is_above"), [(0.0, True), (0.14 * EM, False)])
def test_on_paper_no_halo_bites_a_line_beside_the_letters(halo: float, is_above: bool) -> None:
    """The line runs below the letters; a line as far away as a plane's own edge is not bitten."""
    mark, size, above, far = (100.0, 100.0), (90.0, 14.0), (100.0, 110.0), (100.0, 150.0)
    for gap, is_kept in ((0.35 * EM, True), (0.1 * EM, is_above)):
        low = above[1] - size[1] / 2.0 - gap
        line = np.array([[(60.0, low), (140.0, low)]])
        ground = Ground(FRAME, EM, partial(Ground.ink_lines, segments=line), halo)
        placed = place([Wish("a", size, [mark], partial(choices, mark, above, far))], ground)["a"]
        assert placed.centre == (above if is_kept else far)


@pytest.mark.parametrize("rank", [CLOSE, CLOSE + 1.0])
def test_on_paper_a_name_finds_room_between_and_beyond_the_usual_places(rank: float) -> None:
    """The name of a length stays close to it: what it covers then are the lines of the length."""
    spot, size = (240.0, 160.0), (40.0, 14.0)
    x, y = around(spot, size, EM).centres.T
    bars = np.stack([np.column_stack([x - 4.0, y]), np.column_stack([x + 4.0, y])], axis=1)
    hides = []
    for halo in (0.0, 0.14 * EM):
        ground = Ground(FRAME, EM, partial(Ground.ink_lines, segments=bars), halo)
        wanted = Wish("a", size, [spot], partial(around, spot, size, EM), rank)
        box = box_of(place([wanted], ground)["a"], size)
        hides.append(bool(ground.hidden(np.array([box]))[0] > 0.0))
    assert hides == [True, rank == CLOSE]


@pytest.mark.parametrize(("rank", "stays"), [(CLOSE, True), (CLOSE + 1.0, False)])
def test_on_paper_a_name_rather_has_a_leader_than_cover_a_tenth_of_itself(
    rank: float, stays: bool
) -> None:
    mark, size, near, far = (100.0, 100.0), (90.0, 14.0), (100.0, 110.0), (100.0, 220.0)
    line = np.array([[(100.0, 110.0), (106.0, 110.0)]])
    ground = Ground(FRAME, EM, partial(Ground.ink_lines, segments=line), 0.14 * EM)
    places = choices(mark, near, far)._replace(away=np.array([0.0, 8.0 * EM]))
    wanted = Wish("a", size, [mark], lambda: places, rank)._replace(spots=[mark, mark])
    assert (place([wanted], ground)["a"].centre == near) == stays


def test_on_paper_the_best_places_are_annealed_not_the_first_ones() -> None:
    """Both want one place, and the next best one of the first label is its fourteenth."""
    mark, size, best, good = (100.0, 100.0), (40.0, 14.0), (100.0, 150.0), (300.0, 20.0)
    bad = [(300.0, 60.0 + 18.0 * i) for i in range(13)]
    bars = np.array([[(x, y), (x + 4.0, y)] for x, y in [*bad, (100.0, 300.0)]])
    ground = Ground(FRAME, EM, partial(Ground.ink_lines, segments=bars), 0.14 * EM)
    wishes = [
        Wish("a", size, [mark, mark], partial(choices, mark, best, *bad, good), 2.0),
        Wish("b", size, [mark, mark], partial(choices, mark, best, (100.0, 300.0)), 3.0),
    ]
    placed = place(wishes, ground)
    assert placed["a"].centre == good and placed["b"].centre == best


def test_letters_on_paper_do_not_read_as_one_word() -> None:
    mark, size = (100.0, 100.0), (14.0, 14.0)
    near, far = (100.0 + size[0] + 0.5 * EM, 100.0), (100.0, 200.0)
    wishes = [
        Wish("A", size, [mark], partial(on, mark)),
        Wish("E", size, [mark], partial(choices, mark, near, far)),
    ]
    assert place(wishes, Ground(FRAME, EM))["E"].centre == near
    assert place(wishes, Ground(FRAME, EM, halo=0.14 * EM))["E"].centre == far


def test_a_name_on_paper_does_not_stand_between_its_mark_and_another_one() -> None:
    """Its own mark is nearer, but the other one is almost as near."""
    mark, other, size = (100.0, 100.0), (100.0, 70.0), (20.0, 14.0)
    between, above = (100.0, 86.0), (100.0, 114.0)
    wishes = [
        Wish("in focus", size, [mark], partial(choices, mark, between, above)),
        Wish("eye", size, [other], partial(choices, other, (100.0, 40.0))),
    ]
    assert place(wishes, Ground(FRAME, EM))["in focus"].centre == between
    assert place(wishes, Ground(FRAME, EM, halo=0.14 * EM))["in focus"].centre == above


def test_two_names_of_one_mark_are_not_in_each_others_way() -> None:
    mark, size, ground = (100.0, 100.0), (40.0, 14.0), Ground(FRAME, EM)
    one = wish("one", mark, size, 0.0).choices(ground)
    far = Wish("two", size, [mark], partial(choices, mark, (170.0, 100.0), away=50.0))
    alone = candidates([far.choices(ground)], ground).costs
    assert candidates([one, far.choices(ground)], ground).costs[-1] == alone[0]


def test_the_head_of_an_arrow_is_ink_as_its_shaft_is() -> None:
    arrow = np.array([[(100.0, 100.0), (400.0, 100.0)]])
    ground = Ground(FRAME, EM, lambda ground: ground.ink_arrows(arrow))
    beside = [(x, 104.0, x + 10.0, 114.0) for x in (200.0, 350.0)]
    assert (ground.hidden(np.array(beside)) > 0.0).tolist() == [False, True]


@pytest.mark.parametrize(("air", "is_enough"), [(0.1 * EM, False), (0.3 * EM, True)])
def test_labels_have_air_between_them(air: float, is_enough: bool) -> None:
    mark, size = (100.0, 100.0), (40.0, 14.0)
    near, far = (100.0 + size[0] + air, 100.0), (100.0, 200.0)
    wishes = [
        Wish("a", size, [mark], partial(on, mark)),
        Wish("b", size, [mark], partial(choices, mark, near, far)),
    ]
    placed = place(wishes, Ground(FRAME, EM))
    assert placed["b"].centre == (near if is_enough else far)


def test_labels_go_where_the_ink_is_not() -> None:
    spot, size = (240.0, 160.0), (60.0, 14.0)
    right = np.array([[(x, 0.0), (x, 320.0)] for x in np.arange(246.0, 480.0, 4.0)])
    ground = Ground(FRAME, EM, lambda ground: ground.ink_lines(right))
    left, _, edge, _ = box_of(place([wish("a", spot, size, 0.0)], ground)["a"], size)
    assert edge <= 246.0 and left > 100.0


def test_leaders_that_must_not_cross_do_not_however_much_more_the_other_place_costs() -> None:
    low, high, size = (100.0, 100.0), (100.0, 140.0), (40.0, 14.0)
    beyond_high, beyond_low, above = (180.0, 160.0), (180.0, 80.0), (100.0, 280.0)
    places = choices(high, beyond_low, above)._replace(away=np.array([60.0, 900.0]))
    wishes = [
        Wish("low", size, [low], partial(choices, low, beyond_high, away=60.0), 0.0),
        Wish("high", size, [high], lambda: places, 1.0),
    ]
    assert place(wishes, Ground(FRAME, EM), untangled=True)["high"].centre == above
    assert place(wishes, Ground(FRAME, EM))["high"].centre == beyond_low


def test_a_label_far_from_its_mark_has_a_leader_that_ends_at_its_box() -> None:
    spot, size = (240.0, 160.0), (60.0, 14.0)
    ground = Ground(FRAME, EM)
    ground.keep_box(150.0, 120.0, 235.0, 200.0)
    ground.keep_box(245.0, 120.0, 330.0, 200.0)
    ground.keep_box(200.0, 166.0, 280.0, 200.0)
    ground.keep_box(200.0, 120.0, 280.0, 154.0)
    placed = place([wish("a", spot, size, 0.0)], ground)["a"]
    left, low, right, high = box_of(placed, size)
    assert placed.leader is not None
    (start_x, start_y), (x, y) = placed.leader
    assert left - 1e-6 <= x <= right + 1e-6 and low - 1e-6 <= y <= high + 1e-6
    assert 5.0 < math.dist((start_x, start_y), spot) < 9.0  # from the mark's rim


def test_a_name_stands_beyond_the_tip_of_its_arrow_and_has_no_leader() -> None:
    places = beyond((100.0, 100.0), (0.0, 20.0), (12.0, 14.0), EM)
    (x, y), low = places.centres[0].tolist(), places.centres[0][1] - 7.0
    assert x == pytest.approx(100.0) and 2.0 < low - 100.0 < EM and y > 100.0 and not places.leads


def test_a_letter_aside_of_its_arrows_line_leaves_it_whole_with_its_halo() -> None:
    """Where the arrow lies on a longer line, such as an axis on an edge of the cube."""
    size = (10.0, 14.0)
    x, y = beyond((100.0, 100.0), (0.0, 20.0), size, EM).centres[1:5].T
    aside = np.abs(x - 100.0) - size[0] / 2.0
    assert (y > 100.0).all() and (aside >= HALO_EM * EM + 1.5).all()


@pytest.mark.parametrize("tip", [(470.0, 160.0), (10.0, 160.0), (240.0, 310.0), (240.0, 10.0)])
def test_an_arrow_that_ends_at_the_border_is_named_beside_its_tip(tip: tuple[float, float]) -> None:
    way, size = (tip[0] - 240.0, tip[1] - 160.0), (14.0, 14.0)
    wanted = Wish("n", size, [tip], partial(beyond, tip, way, size, EM))
    placed = place([wanted], Ground(FRAME, EM))
    assert math.dist(placed["n"].centre, tip) < 2.0 * EM


def test_a_plane_is_named_along_an_edge_outside_it_and_never_steeply() -> None:
    square = np.array([(100, 100), (300, 140), (300, 260), (100, 220)], float)
    edges = np.stack([square, np.roll(square, -1, axis=0)], axis=1)
    places = along(edges, (200.0, 180.0), (80.0, 14.0), EM, square)
    assert np.abs(places.turns).max() <= math.radians(30.0)
    x, y = places.centres[0].tolist()
    assert y > 220.0 + 0.2 * (x - 100.0)  # above the upper edge
    assert places.turns[0] == pytest.approx(math.atan2(40.0, 200.0))


def test_a_plane_is_named_first_at_edges_behind_which_its_volume_is_not() -> None:
    far = np.array([(100, 100), (300, 140), (300, 260), (100, 220)], float)
    edges = np.stack([far, np.roll(far, -1, axis=0)], axis=1)
    near = far + np.array((300.0, 60.0))  # to the right
    places = along(edges, (200.0, 180.0), (80.0, 14.0), EM, np.concatenate([far, near]))
    x, y = places.centres[:24].T
    assert (y[:3] > 220.0 + 0.2 * (x[:3] - 100.0)).all()  # all places of an edge before another's
    assert (x[:9] < 300.0).all() and (x[21:] > 300.0).all(), "after those diagonally from others"
    # Near is in front, far shows above it and to its right: the left and the lower edge are clear.
    behind = np.concatenate([far, far + np.array((60.0, 40.0))])
    x, y = along(edges, (200.0, 180.0), (80.0, 14.0), EM, behind).centres[:12].T
    assert ((x[:6] < 100.0) | (y[:6] < 100.0 + 0.2 * (x[:6] - 100.0))).all()


def test_a_side_is_named_clear_of_its_line_and_first_outside() -> None:
    spots, normal = [(100.0, 100.0), (200.0, 150.0)], np.array([-1.0, 2.0]) / math.sqrt(5.0)
    places = flanking(spots, (-50.0, 80.0), (60.0, 14.0), EM, 6.0)
    corners = np.array([(x, y) for x in (-30.0, 30.0) for y in (-7.0, 7.0)])
    apart = (places.centres[:, None] + corners - spots[0]) @ normal  # of each box's corners
    assert (np.sign(apart) == np.sign(apart[:, :1])).all()
    assert (apart[:5] > 0.0).all() and (apart < 0.0).any()
    assert np.abs(apart).min(axis=1) == pytest.approx(places.away)
    # Inside, nearer to its own side than to the one opposite; if it is too large for that, outside.
    middles = (places.centres - spots[0]) @ normal
    assert middles.min() >= (-50.0, 80.0) @ -normal
    outside = flanking(spots, (-5.0, 8.0), (60.0, 14.0), EM, 6.0)
    assert (outside.centres == places.centres[middles > 0.0]).all()


def test_a_plane_that_is_seen_as_a_point_is_named_round_it() -> None:
    point = np.full((4, 2, 2), 200.0)
    places = along(point, (200.0, 200.0), (80.0, 14.0), EM, point[:, 0])
    assert len(places.centres) > 0 and np.isfinite(places.centres).all()
    assert (np.abs(places.centres - 200.0) > (40.0, 7.0)).any(axis=1).all()


def test_the_points_of_a_large_mesh_are_ink_and_nothing_else_is(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("app.drawings.layer._MOST_FACES", 3_000)
    silhouette = Silhouette(load("far-plane-popping"))
    count = len(silhouette.triangles)
    assert count > 3000 and silhouette.triangles.shape == (count, 1, 3)
    ground, spots = Ground(FRAME, EM), np.full((count, 1, 2), np.nan)
    spots[:2, 0] = (102.0, 51.0), (1e9, 51.0)
    silhouette.ink(ground, spots)
    boxes = np.array(
        [(100.0, 50.0, 105.0, 55.0), (0.0, 0.0, 100.0, 320.0), (105.0, 0.0, 480.0, 320.0)]
    )
    assert ground.hidden(boxes).tolist() == [1.0, 0.0, 0.0]


def test_the_name_of_a_far_side_stands_at_its_corner_rather_than_on_the_near_one() -> None:
    """There is no room above its upper edge, which is steeper than a level name is high."""
    em, size = 100.0, (271.0, 81.0)
    far = np.array([(404.0, 307.0), (805.0, 244.0), (805.0, 672.0), (404.0, 735.0)])
    body = np.concatenate([far, far - (200.0, 122.0)])
    edges = np.stack([far, np.roll(far, -1, axis=0)], axis=1)
    wish = Wish("far", size, [(605.0, 490.0)], lambda: along(edges, (605.0, 490.0), size, em, body))
    (placed,) = place([wish], Ground((30.0, 30.0, 975.0, 825.0), em)).values()
    assert placed.centre[1] > 735.0 and placed.turn == 0.0


def test_what_is_cut_away_beyond_a_volume_is_no_ink() -> None:
    silhouette, ground = Silhouette(load("letter-f")), Ground(FRAME, EM)
    board = np.array([[(0.0, 0.0), (400.0, 0.0), (0.0, 300.0)]])
    volume = np.array([(0.0, 0.0), (100.0, 0.0), (20.0, 20.0), (0.0, 100.0), (0.0, 0.0)])
    silhouette.ink(ground, board, volume)
    boxes = np.array([(5.0, 5.0, 30.0, 30.0), (110.0, 5.0, 140.0, 35.0)])
    assert ground.hidden(boxes).tolist() == [1.0, 0.0]


def test_no_stub_leads_to_a_label_that_slid_beside_its_mark() -> None:
    size, frame = (60.0, EM), room(480.0, 320.0, EM)
    stubs = 0
    for spot in ((12.0, 100.0), (74.0, 100.0), (200.0, 100.0)):
        places = around(spot, size, EM)
        for number in range(len(places.centres)):
            wish = Wish("P", size, [spot], lambda places=places: places)  # type: ignore[misc]
            placed = placed_label(*wish.choices(Ground(frame, EM)), number, EM)
            apart = np.abs(np.array(placed.centre) - spot) - np.array(size) / 2.0
            assert (apart >= -1e-9).any(), "a label that slides does not hide its own mark"
            is_far = np.hypot(*np.maximum(apart, 0.0)) > LEADER_FROM_EM * EM
            was_far = places.away[number] > LEADER_FROM_EM * EM
            assert (placed.leader is not None) == (is_far and was_far)
            stubs += was_far and not is_far
    assert stubs, "some labels slide so near that they need no leader"


@pytest.mark.parametrize("x_em", [5.0, 11.0])
def test_a_label_too_wide_for_its_side_slides_along_its_mark_and_needs_no_leader(
    x_em: float,
) -> None:
    """It fits neither to the right nor to the left of its mark, nor centred above or below."""
    frame, spot, size = room(16.0 * EM, 8.0 * EM, EM), (x_em * EM, 3.0 * EM), (12.0 * EM, EM)
    (label,) = place([wish("P", spot, size, 0.0)], Ground(frame, EM)).values()
    left, low, right, high = box_of(label, size)
    assert label.leader is None and left < spot[0] < right
    assert 0.0 < max(low - spot[1], spot[1] - high) < EM, "beside its mark"


@given(st.lists(st.tuples(*[st.floats(-600.0, 900.0)] * 4), min_size=1, max_size=5))
def test_a_segment_is_cut_at_the_pane(rows: list[tuple[float, float, float, float]]) -> None:
    parts = clipped(np.array(rows).reshape(-1, 2, 2), FRAME)
    assert len(parts) <= len(rows)
    assert (parts >= -0.6).all() and (parts <= np.array([480.6, 320.6])).all()


@pytest.mark.parametrize("em", np.linspace(9.18, 36.72, 13).tolist())
def test_a_wide_label_near_the_border_slides_into_the_frame_below_what_it_would_hide(
    em: float,
) -> None:
    """A board covers all but a strip at the bottom; the point is at the board's left edge."""
    left, low, right, high = room(16.0 * em, 8.0 * em, em)
    ground = Ground((left, low, right, high), em)
    board = np.zeros(ground.shape, dtype=np.bool_)
    board[:, int(3.0 / SQUARE_EM) :] = True
    ground.ink(board)
    spot, size = (1.5 * em, 6.0 * em), (8.0 * em, em)
    wide = Wish("P", size, [spot], lambda: around(spot, size, em))
    (label,) = place([wide], ground).values()
    x, y = label.centre
    assert x - 4.0 * em == pytest.approx(left) and low < y - em / 2.0, "in the frame"
    assert y + em / 2.0 <= 3.1 * em and label.leader is not None, "in the strip"


@pytest.mark.parametrize("room_for", ["words on this side", "words on the other", "a letter"])
def test_only_where_its_words_would_cover_something_a_letter_stands_alone(room_for: str) -> None:
    spot, whole, letter = (100.0, 100.0), (80.0, 14.0), (10.0, 14.0)
    ground = Ground(FRAME, EM)
    if room_for != "words on this side":
        held = np.ones(ground.shape, dtype=np.bool_)
        held[int(85 / 5) : int(125 / 5), int(75 / 5) : int(125 / 5)] = False
        if room_for == "words on the other":
            held[:, :20] = False
        ground.ink(held)
    short = letter, partial(around, spot, letter, EM)
    wanted = Wish("n", whole, [spot], partial(around, spot, whole, EM), 0.0, short)
    placed = place([wanted], ground)
    is_brief = room_for == "a letter"
    assert placed["n"].kept.brief == is_brief
    left, low, right, high = box_of(placed["n"], letter if is_brief else whole)
    assert ground.hidden(np.array([[left, low, right, high]])) == 0.0
    to_right, up = placed["n"].kept.offset
    was = placed["n"].kept._replace(offset=(to_right + 1.0, up + 1.0))
    narrow = Ground((left - 2.0, low - 2.0, right + 2.0, high + 2.0), EM)
    kept = place([wanted], narrow, {"n": was})
    assert kept["n"].kept == was, "it keeps its place and its form while something moves"


def test_no_line_from_a_point_to_its_name_crosses_a_curve() -> None:
    """All places above the curve are taken; there is room below it."""
    along = np.linspace((0.0, 200.0), (300.0, 20.0), 40)
    frame, point = np.array([0.0, 0.0, 300.0, 220.0]), np.array([[250.0, 90.0]])
    taken = np.array([[200.0, 60.0, 300.0, 220.0]])
    sizes, gaps = np.array([[60.0, 14.0]]), np.array([5.0])
    nothing = np.empty((0, 2))
    (name,) = beside(point, sizes, frame, nothing, gaps, taken)
    assert name is not None, "without the curve there is a place"
    assert beside(point, sizes, frame, along, gaps, taken) == [None]


def test_letters_alone_are_tried_beside_any_number_of_whole_texts() -> None:
    """Each whole text may run into another label later, so the first dozen are not enough."""
    brief = np.arange(40) >= 30
    assert {30, 31, 32} <= {*cheapest(np.arange(40.0), brief)}


def test_a_point_is_named_where_no_other_point_is_nearer() -> None:
    """A column of dots, as of one cost and many errors; some of them have no name."""
    points = np.column_stack([np.full(8, 150.0), np.linspace(40.0, 180.0, 8)])
    sizes = np.tile((120.0, 14.0), (8, 1)) * (
        (np.arange(8) % 3 > 0)[:, None] + np.array([0, 1]) > 0
    )
    frame, gaps = np.array([0.0, 0.0, 400.0, 220.0]), np.full(8, 6.0)
    nothing = np.empty((0, 2))
    names = beside(points, sizes, frame, nothing, gaps, np.empty((0, 4)))
    assert sum(name is not None for name in names) >= 4
    for point, name in zip(points, names, strict=True):
        if name is None:
            continue
        apart = np.linalg.norm(np.clip(points, name[:2], name[2:]) - points, axis=1)
        own = math.dist(point, np.clip(point, name[:2], name[2:]))
        others = (points != point).any(axis=1)
        assert own < apart[others].min() or own > EM < apart[others].min(), "or it has a line"
        ends = point + np.linspace(0.0, 1.0, 50)[:, None] * (
            np.clip(point, name[:2], name[2:]) - point
        )
        away = np.linalg.norm(ends[:, None] - points[others], axis=2)
        assert away.min() > 3.0, "its line runs over no other dot"


def test_the_name_of_a_curve_stands_where_no_other_curve_is_near() -> None:
    """Two curves part in the left half of the diagram only."""
    x = np.linspace(0.0, 300.0, 40)
    one = np.column_stack([x, np.full(40, 100.0)])
    other = np.column_stack([x, 106.0 + np.clip(150.0 - x, 0.0, None)])
    lines = np.concatenate([np.hstack([each - 1.0, each + 1.0]) for each in (one, other)])
    frame, nothing = np.array([0.0, 0.0, 300.0, 300.0]), np.empty((0, 4))
    for curve, foreign in ((one, other), (other, one)):
        name = beside_curve(frame, curve, 1.0, (40.0, 14.0), nothing, lines, foreign)
        own, apart = (
            np.linalg.norm(np.clip(each, name[:2], name[2:]) - each, axis=1).min()
            for each in (curve, foreign)
        )
        assert own + 5.0 < apart
        assert stays(name, frame, curve, (40.0, 14.0), lines)
        assert not stays(name, frame, curve, (44.0, 14.0), lines), "another text"
        assert not stays(name, frame, curve, (40.0, 14.0), np.vstack([lines, name])), "not free"
        assert not stays(name, frame - 300.0, curve, (40.0, 14.0), lines), "out of the frame"
        assert not stays(name, frame, curve + 90.0, (40.0, 14.0), nothing), "not beside its curve"


def test_no_curve_runs_through_a_name_between_the_places_that_are_known_of_it() -> None:
    along = np.linspace((0.0, 300.0), (400.0, 0.0), 14)
    frame, point = np.array([0.0, 0.0, 400.0, 300.0]), along[6:7]
    taken = np.array([[0.0, 0.0, 183.0, 300.0], [0.0, 164.0, 400.0, 300.0]])  # the curve's left
    sizes, gaps = np.array([[40.0, 14.0]]), np.array([5.0])
    (name,) = beside(point, sizes, frame, along, gaps, taken)
    line = np.linspace(along[0], along[-1], 2000)
    assert name is None or not ((name[:2] < line) & (line < name[2:])).all(axis=1).any()
