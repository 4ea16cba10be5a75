"""The one placer of labels, for all panes and figures; numpy only.

Each label brings its candidates: where it could stand, best first. The ground knows what must stay
visible. The placer finds the cheapest places together: greedily by rank, then by simulated
annealing with a fixed seed (Christensen, Marks and Shieber, "An Empirical Study of Algorithms for
Point-Feature Label Placement", ACM TOG 14(3), 1995). The positions round a point are Imhof's
("Positioning Names on Maps", 1975).

All lengths are pixels from the left and from the bottom.
"""

import math
import random
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from functools import partial
from itertools import product
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Spot: TypeAlias = tuple[float, float]

CLOSE = 1.0  # the last rank, of a length, whose name stays close to it on paper, too
MARGIN_EM = 0.3  # between labels and the pane's border
HEAD, HEAD_RADIUS = 0.18, 0.06  # of an arrow, in its lengths
SQUARE_EM = 1.0 / 3.0  # side of the squares in which ink is counted
LEADER_FROM_EM = 1.2  # beyond this distance a leader joins a label to its mark
_GAPS_EM = (0.45, 1.6, 3.0, 5.0)
_PAST = np.array(  # beyond the tip of an arrow, in em, and how far aside; at a border even back
    [
        (gap, turn)
        for turns in ((0.0, 0.7, -0.7, 1.0, -1.0), (1.6, -1.6, 2.2, -2.2))
        for gap in (0.4, 1.1, 1.8)
        for turn in turns
    ]
)
_BESIDE = np.array(  # which point of a line, how far from it, in em, and on which side
    [(i, gap, way) for gap in (0.35, 1.6) for way in (1, -1) for i in range(5)]
    + [(0, gap, way) for gap in (3.0, 5.0) for way in (1, -1)]
)
_ROUND = np.array([(1, 1), (1, -1), (-1, 1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1)], float)
_FINELY = np.array([(math.cos(turn), math.sin(turn)) for turn in np.arange(24) * math.tau / 24.0])
_FINELY /= np.abs(_FINELY).max(axis=1, keepdims=True)  # round a box
_FINE_GAPS_EM = (0.9, 1.6, 2.3, 3.0, 4.0, 5.0, 6.5, 8.0)  # of more places on paper
_STEEPEST = math.radians(30.0)
_ALONG = (0.5, 0.2, 0.8)  # where along an edge its name may stand
# What a place costs.
_INK, _CROSSES, _ORDER, _FOREIGN, _OVERLAP, _UNPLACED = 20.0, 8.0, 0.08, 10.0, 1e6, 1e3
_BRIEF = 5.0  # of a letter alone
_BITES = 4.0  # on paper, where its halo hides any ink
_CLOSE = 0.5  # on paper, where another mark is as near
_PARTS = (3, 1), (24, 4)  # of a label, along and across it: on a screen, and on paper
_APART = 2.5  # times as far apart are labels on paper
_MOVES = 600, 2400  # on a screen, and on paper
_TRIED = 12  # candidates of a label: the first ones that are free, and as many of the cheapest
_TRIED_BRIEF = 6  # and of its letter alone
_RIM_EM = 0.45  # of a mark, where its leader begins
_SAME_EM = 0.1  # marks that are so near to each other are one
_ROUNDING_PX = 1e-6  # beyond the frame: a label that slides to its border is inside
_FAR = 1e9  # cells: a box beyond hides no ink, and its place is still a whole number


class Places(NamedTuple):
    """The candidates of a label, best first."""

    centres: Floats  # (n, 2), of the letters
    turns: Floats  # (n,), radians
    anchors: Floats  # (n, 2): what a leader would join to the label
    away: Floats  # (n,), distance from the anchor in px
    leads: bool = True  # whether a leader may join a place that is far away
    brief: NDArray[np.bool_] | None = None  # (n,), where the letter stands alone; None: nowhere

    def part(self, which: slice) -> "Places":
        at = self.centres[which], self.turns[which], self.anchors[which], self.away[which]
        return Places(*at, self.leads)


NOWHERE = Places(np.empty((0, 2)), np.empty(0), np.empty((0, 2)), np.empty(0))


class Wish(NamedTuple):
    """A label that wants a place; of two that want the same one the lower rank has it.

    `spots` are the points that it names. `places` makes its candidates, if they are needed; `short`
    is the size of its letter, which may stand alone, and what makes the candidates of that.
    """

    key: Hashable
    size: tuple[float, float]
    spots: Sequence[Spot]
    places: Callable[[], Places]
    rank: float = 0.0
    short: tuple[tuple[float, float], Callable[[], Places]] | None = None

    def sizes(self, places: Places) -> Floats:
        """The size of the label in each of its candidates, (n, 2)."""
        of = np.tile(self.size, (len(places.centres), 1)).astype(np.float64)
        if places.brief is not None and self.short is not None:
            of[places.brief] = self.short[0]
        return of

    def choices(self, ground: "Ground") -> "tuple[Wish, Places]":
        """Make its candidates; level ones that a leader may join slide into the frame."""
        places, frame = self.places(), np.array(ground.limits)
        if self.rank > CLOSE and ground.halo and places.leads and len(self.spots) == 1:
            finer = partial(around, sides=_FINELY, gaps_em=_FINE_GAPS_EM)
            places = joined(places, finer(self.spots, self.size, ground.em))
        if self.short is not None and len(places.centres):
            whole, places = len(places.centres), joined(places, self.short[1]())
            places = places._replace(brief=np.arange(len(places.centres)) >= whole)
        if places.leads and len(places.centres):
            half, centres = self.sizes(places) / 2.0, places.centres
            inside = np.clip(
                centres, frame[:2] + half, np.maximum(frame[2:] - half, frame[:2] + half)
            )
            beside = np.abs(inside - places.anchors) >= half  # not over its own mark
            slides = beside.any(axis=1) & (places.turns == 0.0)
            if len(self.spots) > 1:  # nor, beside a line, over that
                slides &= places.away > LEADER_FROM_EM * ground.em
            places = places._replace(centres=np.where(slides[:, None], inside, centres))
        return self, places


class KeptSpot(NamedTuple):
    """Where a label stands, from one of its spots."""

    spot: int
    offset: Spot
    turn: float
    leads: bool
    brief: bool = False  # whether its letter stands alone

    def is_elsewhere(self, other: "KeptSpot | None") -> bool:
        if other is None or (self.spot, self.brief) != (other.spot, other.brief):
            return True
        return math.dist(self.offset, other.offset) + abs(self.turn - other.turn) > 1.0


class PlacedLabel(NamedTuple):
    """Where a label stands, with its leader from the mark's rim to its box."""

    centre: Spot
    turn: float
    leader: tuple[Spot, Spot] | None
    kept: KeptSpot
    is_free: bool = True


# --------------------------------------------------------------------------- candidates


def around(
    spots: ArrayLike,
    size: tuple[float, float],
    em: float,
    rim: float = 0.0,
    way: Spot | None = None,
    sides: Floats = _ROUND,
    gaps_em: Sequence[float] = _GAPS_EM,
) -> Places:
    """Imhof's positions round points, first near, then farther away; towards `way` first."""
    points = np.reshape(np.asarray(spots, dtype=np.float64), (-1, 2))
    half = np.array(size) / 2.0
    if way is not None and math.hypot(*way) > 0.0:
        turned = _ROUND / np.linalg.norm(_ROUND, axis=1, keepdims=True) @ np.array(way)
        sides = _ROUND[np.argsort(-turned, kind="stable")]
    gaps = np.array(gaps_em) * em + rim
    gap = np.repeat(gaps, len(sides))[:, None]
    side = np.tile(sides, (len(gaps), 1))
    # At a corner the letters come a little nearer: their box is empty there.
    near = np.where(np.abs(side).sum(axis=1, keepdims=True) > 1.0, 0.6, 1.0)
    offsets = side * (half + gap * near)
    centres = (points[None] + offsets[:, None]).reshape(-1, 2)
    anchors = np.tile(points, (len(offsets), 1))
    away = np.repeat(gap[:, 0] - rim, len(points))
    return Places(centres, np.zeros(len(centres)), anchors, away)


def beyond(tip: Spot, way: Spot, size: tuple[float, float], em: float) -> Places:
    """On the line of an arrow, beyond its tip, and a little aside; never with a leader."""
    length = math.hypot(*way)
    if length < 1e-9:
        return around(tip, size, em)._replace(leads=False)
    along = np.array(way) / length
    gaps, turns = em * _PAST[:, 0], _PAST[:, 1, None]
    outward = np.cos(turns) * along + np.sin(turns) * (-along[1], along[0])
    centres = np.array(tip) + outward * (_reach(outward, size) + gaps)[:, None]
    count = len(centres)
    return Places(
        centres, np.zeros(count), np.tile(tip, (count, 1)),
        np.minimum(gaps, LEADER_FROM_EM * em), leads=False,
    )  # fmt: skip


def on(spot: Spot) -> Places:
    """Right on a place: in the gap of a dimension line, or inside an area."""
    return Places(np.array([spot]), np.zeros(1), np.array([spot]), np.zeros(1), leads=False)


def along(
    edges: ArrayLike, middle: Spot, size: tuple[float, float], em: float, body: ArrayLike
) -> Places:
    """Outside an area along its edges, (n, 2, 2), turned with them up to 30 degrees, else level.

    `body` has the corners, (m, 2), of what the area bounds: edges beyond which it lies come last,
    after the places diagonally from the others.
    """
    ends = np.reshape(np.asarray(edges, dtype=np.float64), (-1, 2, 2))
    spans, mids = ends[:, 1] - ends[:, 0], ends.mean(axis=1)
    lengths = np.hypot(*spans.T)
    across = spans / np.maximum(lengths, 1e-9)[:, None]
    outward = np.stack([-across[:, 1], across[:, 0]], axis=1)
    outward[((mids - middle) * outward).sum(axis=1) < 0.0] *= -1.0
    # Upper edges first, and of them the longest: there is most room.
    towards = np.asarray(body) - (mids + em * outward)[:, None]  # from a place beside each edge
    angles = np.sort(np.arctan2(towards[..., 1], towards[..., 0]), axis=1)
    gaps = np.diff(angles, axis=1, append=angles[:, :1] + math.tau)
    is_before = gaps.max(axis=1) < math.pi  # corners are all round that place
    order = np.lexsort((-(mids[:, 1] - middle[1] + 0.1 * lengths), is_before))
    round_mids = around(mids[order], size, em)  # also of a plane that is seen as a point
    good = order[~is_before[order]]
    diagonal = around(mids[good], size, em).part(slice(4 * len(good)))
    order = order[lengths[order] >= 1.0]
    turns = np.arctan2(across[:, 1], across[:, 0])
    turns -= math.pi * np.round(turns / math.pi)
    is_turned = (np.abs(turns) <= _STEEPEST) & (lengths > size[0])
    half = np.abs(outward) @ np.array(size) / 2.0  # so that the nearest corner is at the gap
    reach = size[1] / 2.0 + np.abs(outward[:, 0]) * size[0] / 6.0  # of the boxes that ink is in
    away = np.where(is_turned, reach, half) + 0.35 * em
    anchors = (ends[:, :1] + np.array(_ALONG)[:, None] * spans[:, None])[order].reshape(-1, 2)
    centres = anchors + np.repeat((away[:, None] * outward)[order], len(_ALONG), axis=0)
    turns = np.repeat(np.where(is_turned, turns, 0.0)[order], len(_ALONG))
    places = Places(centres, turns, anchors, np.full(len(anchors), 0.35 * em))
    first = len(_ALONG) * int((~is_before[order]).sum())
    return joined(places.part(slice(first)), diagonal, places.part(slice(first, None)), round_mids)


def flanking(
    spots: ArrayLike, out: Spot, size: tuple[float, float], em: float, rim: float
) -> Places:
    """Beside a side of a shape, at points of it, first outside; round a side that is a point.

    `out` leads from the shape's middle to the side. Inside, a name is nearer to its own side than
    to the one opposite.
    """
    points = np.asarray(spots, dtype=np.float64)
    way = points[-1] - points[0]
    length = math.hypot(*way)
    if length < em:
        return around(points[:1], size, em, rim, out)
    across = np.array((-way[1], way[0])) / length
    room = across @ np.array(out)
    across *= math.copysign(1.0, room)
    half = np.abs(across) @ np.array(size) / 2.0  # so that the nearest corner is at the gap
    beside = _BESIDE[(_BESIDE[:, 2] > 0.0) | (half + em * _BESIDE[:, 1] <= abs(room))]
    at = points[beside[:, 0].astype(int) % len(points)]
    outward, gaps = across * beside[:, 2:], em * beside[:, 1]
    return Places(at + outward * (half + gaps)[:, None], np.zeros(len(at)), at, gaps)


def joined(*places: Places) -> Places:
    """Return the candidates of all of these, the first ones best."""
    centres, turns, anchors, away = (
        np.concatenate(parts) for parts in list(zip(*places, strict=True))[:4]
    )
    return Places(centres, turns, anchors, away, any(each.leads for each in places))


def _reach(outward: Floats, size: tuple[float, float]) -> Floats:
    """How far the middle of a box is from its rim in directions, (n, 2)."""
    return np.asarray((np.array(size) / 2.0 / np.maximum(np.abs(outward), 1e-9)).min(axis=1))


def clipped(segments: Floats, frame: Sequence[float]) -> Floats:
    """Return the parts of segments, (n, 2, 2), in a frame; those outside are left out."""
    starts, spans = segments[:, 0], segments[:, 1] - segments[:, 0]
    first, last = np.zeros(len(segments)), np.ones(len(segments))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for axis in (0, 1):
            low = (frame[axis] - starts[:, axis]) / spans[:, axis]
            high = (frame[axis + 2] - starts[:, axis]) / spans[:, axis]
            first = np.fmax(first, np.fmin(low, high))
            last = np.fmin(last, np.fmax(low, high))
    first, last = np.clip(first, 0.0, 1.0), np.clip(last, 0.0, 1.0)
    begin = starts + spans * first[:, None]
    inside = (first < last) & (begin >= np.array(frame[:2]) - 0.5).all(axis=1)
    inside &= (begin <= np.array(frame[2:]) + 0.5).all(axis=1)
    return np.asarray(np.stack([begin, starts + spans * last[:, None]], axis=1)[inside])


# --------------------------------------------------------------------------- what is there


def room(width_px: float, height_px: float, em: float) -> tuple[float, float, float, float]:
    """Return where labels may be in a pane or a picture: left, low, right, high."""
    margin = MARGIN_EM * em
    return margin, margin, width_px - margin, height_px - margin


class Ground:
    """What labels must not hide: marks never, other ink as little as possible.

    Labels stay in the frame: left, low, right, high. `draw` tells this ground where the ink is; it
    is called only if labels have to be placed anew. With a `halo`, of a width on paper, labels stay
    clear of ink that only their halos would hide, and farther from each other.
    """

    def __init__(
        self,
        frame: Sequence[float],
        em: float,
        draw: "Callable[[Ground], None]" = lambda _: None,
        halo: float = 0.0,
    ) -> None:
        self._draw: Callable[[Ground], None] | None = draw
        left, low, right, high = map(float, frame)
        self.limits, self.em, self.halo = (left, low, right, high), em, halo
        self.taken: list[tuple[float, float, float, float]] = []  # boxes that no label may overlap
        self.square = SQUARE_EM * em / (2.0 if halo else 1.0)
        self._ink: NDArray[np.bool_] | None = None
        self._counted: NDArray[np.int64] | None = None

    def keep(self, spots: Iterable[Sequence[float]], rim: float) -> None:
        """Keep labels from marks at these places."""
        for x, y, *_ in spots:
            if math.isfinite(x + y):
                self.taken.append((x - rim, y - rim, x + rim, y + rim))

    def keep_box(self, left: float, low: float, right: float, high: float) -> None:
        self.taken.append((left, low, right, high))

    @property
    def shape(self) -> tuple[int, int]:
        """The columns and rows of the ink's squares."""
        columns, rows = (max(0, int(side / self.square)) + 2 for side in self.limits[2:])
        return columns, rows

    def ink(self, held: NDArray[np.bool_]) -> None:
        """Count squares, (columns, rows), as ink."""
        self._ink = held.copy() if self._ink is None else self._ink | held

    def ink_lines(self, segments: Floats) -> None:
        """Count lines as ink, (n, 2, 2)."""
        parts = clipped(segments[np.isfinite(segments).all(axis=(1, 2))], self.limits)
        held = np.zeros(self.shape, dtype=np.bool_)
        if len(parts):
            steps = np.maximum(
                1, np.ceil(np.abs(np.diff(parts, axis=1)).max(axis=(1, 2)) / self.square)
            )
            steps = steps.astype(np.int64) + 1
            which = np.repeat(np.arange(len(parts)), steps)
            first = np.repeat(np.cumsum(steps) - steps, steps)
            part = (np.arange(len(which)) - first) / (steps[which] - 1)
            at = parts[which, 0] + part[:, None] * (parts[which, 1] - parts[which, 0])
            columns, rows = np.floor(at / self.square).astype(np.int64).T
            held[columns.clip(0, self.shape[0] - 1), rows.clip(0, self.shape[1] - 1)] = True
        self.ink(held)

    def ink_arrows(self, arrows: Floats) -> None:
        """Count arrows as ink, (n, 2, 2), each with its head."""
        along = arrows[:, 1] - arrows[:, 0]
        neck, side = arrows[:, 1] - HEAD * along, HEAD_RADIUS * along[:, ::-1] * (-1.0, 1.0)
        corners = np.stack([neck + side, arrows[:, 1], neck - side], axis=1)
        heads = np.stack([corners, np.roll(corners, 1, axis=1)], axis=2).reshape(-1, 2, 2)
        self.ink_lines(np.concatenate([arrows, heads]))

    def hidden(self, boxes: Floats) -> Floats:
        """Return which part of each box in the frame, (n, 4), is ink."""
        if self._draw is not None:
            self._draw(self)
            self._draw = None
        if self._ink is None:
            return np.zeros(len(boxes))
        if self._counted is None:
            columns, rows = self.shape
            self._counted = np.zeros((columns + 1, rows + 1), dtype=np.int64)
            self._counted[1:, 1:] = self._ink.cumsum(axis=0).cumsum(axis=1)
        limit = np.array(self.shape * 2)
        sides = np.clip(boxes / self.square, -_FAR, _FAR)
        sides = np.hstack([np.floor(sides[:, :2]), np.ceil(sides[:, 2:])]) if self.halo else sides
        cells = np.rint(sides).astype(np.int64)
        cells[:, 2:] = np.maximum(cells[:, 2:], cells[:, :2] + 1)
        left, low, right, high = np.clip(cells, 0, limit).T
        counted = self._counted
        inked = (
            counted[right, high] - counted[left, high] - counted[right, low] + counted[left, low]
        )
        return np.asarray(inked / np.maximum((right - left) * (high - low), 1))

    def inked_px(self, boxes: Floats) -> Floats:
        """Return how many square pixels of each box are ink; it may lie outside the frame."""
        sides = np.clip(boxes, 0.0, self.limits[2:] * 2)
        wide, tall = (sides[:, 2:] - sides[:, :2]).T
        return np.asarray(self.hidden(sides) * wide * tall)


# --------------------------------------------------------------------------- the placer


def place(
    wishes: Sequence[Wish],
    ground: Ground,
    kept: Mapping[Hashable, KeptSpot] | None = None,
    *,
    patient: bool = False,
    untangled: bool = False,
) -> dict[Hashable, PlacedLabel]:
    """Place labels; one without a free place is left out, the lowest rank first.

    With `kept`, labels keep their offsets while these places are free: words that jump distract
    from what moves. Only the others are placed anew. If `patient`, labels keep their offsets
    anyway, and say whether their places are free. If `untangled`, no leaders cross each other, for
    which more labels may be left out.
    """
    stays: dict[Hashable, PlacedLabel] = {}
    if kept:
        stays = _kept_labels(wishes, ground, kept, patient)
        wishes = [wish for wish in wishes if wish.key not in stays]
    choices = [wish.choices(ground) for wish in wishes]
    choices = [(wish, places) for wish, places in choices if len(places.centres)]
    if not choices:
        return stays
    tried, costs, boxes, crossings = _costs(choices, ground, untangled)
    ranks = [wish.rank for wish, _ in choices]
    em = ground.em * (_APART if ground.halo else 1.0)
    counts, moves = [len(numbers) for numbers in tried], _MOVES[ground.halo > 0.0]
    chosen = _solve(ranks, counts, costs, boxes, em, crossings, moves)
    for (wish, places), numbers, which in zip(choices, tried, chosen, strict=True):
        if which is not None:
            stays[wish.key] = placed_label(wish, places, numbers[which], ground.em)
    return stays


def _kept_labels(
    wishes: Sequence[Wish], ground: Ground, kept: Mapping[Hashable, KeptSpot], patient: bool
) -> dict[Hashable, PlacedLabel]:
    """The labels whose kept places are still free, or all; no other label may overlap them."""
    stayed: dict[Hashable, PlacedLabel] = {}
    taken = ground.taken
    left_most, lowest, right_most, highest = ground.limits
    for wish in sorted(wishes, key=lambda each: each.rank):
        was = kept.get(wish.key)
        if was is None or was.spot >= len(wish.spots) or (was.brief and wish.short is None):
            continue
        size = wish.short[0] if was.brief and wish.short is not None else wish.size
        (x, y), (to_right, up) = wish.spots[was.spot], was.offset
        cos, sin = abs(math.cos(was.turn)), abs(math.sin(was.turn))
        half_x = (cos * size[0] + sin * size[1]) / 2.0
        half_y = (sin * size[0] + cos * size[1]) / 2.0
        left, right = x + to_right - half_x, x + to_right + half_x
        low, high = y + up - half_y, y + up + half_y
        room = min(left - left_most, low - lowest, right_most - right, highest - high)
        is_free = room >= -_ROUNDING_PX and not any(
            left < t_right and t_left < right and low < t_high and t_low < high
            for t_left, t_low, t_right, t_high in taken
        )
        centre, leader = (x + to_right, y + up), None
        if not is_free and not (patient and math.isfinite(x + y)):
            continue
        taken.append((left, low, right, high))
        if was.leads:
            leader = _leader((x, y), centre, size, ground.em)
        stayed[wish.key] = PlacedLabel(centre, was.turn, leader, was, is_free)
    return stayed


class Candidates(NamedTuple):
    """The candidates of several labels, one label after the other."""

    counts: NDArray[np.int64]  # of each label
    costs: Floats  # of each candidate alone; infinite where it may not be
    boxes: Floats  # (n, 4)
    brief: NDArray[np.bool_]
    anchors: Floats  # (n, 2)
    has_leader: NDArray[np.bool_]

    def part(self, start: int, end: int) -> "Candidates":
        """Return some of them, of one label."""
        which = slice(start, end)
        return Candidates(
            np.array([end - start]), self.costs[which], self.boxes[which], self.brief[which],
            self.anchors[which], self.has_leader[which],
        )  # fmt: skip


def candidates(choices: Sequence[tuple[Wish, Places]], ground: Ground) -> Candidates:
    """Return the candidates of labels, and what each costs alone."""
    em, all_places = ground.em, [places for _, places in choices]
    counts = np.array([len(places.centres) for places in all_places])
    first = np.cumsum(counts) - counts
    of = np.repeat(np.arange(len(counts)), counts)
    centres, turns, anchors, away, *_ = joined(*all_places)
    size = np.concatenate([wish.sizes(places) for wish, places in choices])
    brief = (size != np.array([wish.size for wish, _ in choices])[of]).any(axis=1)
    leads = np.array([places.leads for places in all_places])[of]
    across, up = np.abs(np.cos(turns))[:, None], np.abs(np.sin(turns))[:, None]
    half = (across * size + up * size[:, ::-1]) / 2.0
    boxes, frame = np.hstack([centres - half, centres + half]), np.array(ground.limits)
    far = away > LEADER_FROM_EM * em
    free = (boxes[:, :2] >= frame[:2] - _ROUNDING_PX).all(axis=1)
    free &= (boxes[:, 2:] <= frame[2:] + _ROUNDING_PX).all(axis=1)
    free &= leads | ~far
    if ground.taken:
        free &= ~overlap(boxes, np.array(ground.taken)).any(axis=1)
    wholes = np.bincount(of[~brief], minlength=len(counts))
    number = np.arange(len(of)) - first[of] - brief * wholes[of]
    costs = _ORDER * np.clip(number, 0.0, 24.0) + np.where(far, away / em, 0.0) + _BRIEF * brief
    costs[~free] = np.inf
    at = np.flatnonzero(free)
    hidden = _hidden(centres[at], turns[at], size[at] + 2.0 * ground.halo, ground)
    if ground.halo:  # there a length still stands between its lines
        weight = np.array([1.0 + (wish.rank > CLOSE) for wish, _ in choices])[of[at]]
        hidden = weight * (hidden + _BITES / _INK * (hidden > 0.0))
    costs[at] += _INK * hidden
    close = _CLOSE if ground.halo else 0.0
    costs[at] += _stray_costs(anchors[at], boxes[at], far[at], of[at], anchors[first], em, close)
    return Candidates(counts, costs, boxes, brief, anchors, leads & far)


def cheapest(costs: Floats, brief: NDArray[np.bool_], firsts: int = _TRIED) -> list[int]:
    """Return which candidates of a label are tried: the first that are free, and the cheapest."""
    free = np.flatnonzero(np.isfinite(costs))
    best = free[np.argsort(costs[free], kind="stable")]
    letters = best[brief[best]][:_TRIED_BRIEF]
    return sorted({*free[:firsts].tolist(), *best[:_TRIED].tolist(), *letters.tolist()})


def _costs(
    choices: Sequence[tuple[Wish, Places]], ground: Ground, untangled: bool
) -> tuple[list[list[int]], Floats, Floats, NDArray[np.bool_]]:
    """The candidates to be tried, label by label: their numbers, and for all of them what each
    costs alone, its box, and which boxes or leaders its own leader would run over.
    """
    counts, costs, boxes, brief, anchors, leads = candidates(choices, ground)
    first = np.cumsum(counts) - counts
    parts = (np.split(each, first[1:]) for each in (costs, brief))
    firsts = 0 if ground.halo else _TRIED  # of so many places the cheapest ones are annealed
    tried = [cheapest(alone, short, firsts) for alone, short in zip(*parts, strict=True)]
    at = np.array([start + each for start, here in zip(first, tried, strict=True) for each in here])
    at = at.astype(np.int64)
    boxes, leads = boxes[at], leads[at]
    crossings = np.zeros((len(at), len(at)), dtype=np.bool_)
    crossings[leads] = crossed(anchors[at][leads], boxes[leads], boxes)
    if untangled:
        crossings[np.ix_(leads, leads)] |= _crossing(anchors[at][leads], boxes[leads])
    return tried, costs[at], boxes, crossings


def _crossing(starts: Floats, boxes: Floats) -> NDArray[np.bool_]:
    """Which leaders, from their anchors to the boxes of their labels, cross each other."""
    (x, y), ends = starts.T, np.clip(starts, boxes[:, :2], boxes[:, 2:])
    to_right, up = (ends - starts).T[:, :, None]
    sides = (
        to_right * (each[:, 1] - y[:, None]) - up * (each[:, 0] - x[:, None])
        for each in (starts, ends)
    )
    is_between = math.prod(sides) < 0.0
    return np.asarray(is_between & is_between.T)


def _stray_costs(
    anchors: Floats, boxes: Floats, far: NDArray[np.bool_], of: NDArray[np.int64], marks: Floats,
    em: float, close: float,
) -> Floats:  # fmt: skip
    """The cost of a label nearer to another label's mark, or with a leader across that mark.

    `close` is that of one as near to another mark; of one twice as far from it, it is 0.
    """
    foreign = np.linalg.norm(marks[of][:, None] - marks, axis=2) > _SAME_EM * em
    own = np.linalg.norm(np.clip(anchors, boxes[:, :2], boxes[:, 2:]) - anchors, axis=1)
    away = np.clip(marks, boxes[:, None, :2], boxes[:, None, 2:]) - marks
    away = np.where(foreign, np.linalg.norm(away, axis=2), np.inf).min(axis=1)
    costs = np.where(away < own, _FOREIGN, 0.0)
    costs += close * np.clip(2.0 - away / np.maximum(own, 1e-9), 0.0, 1.0)
    rims = np.hstack([marks - 0.4 * em, marks + 0.4 * em])
    over = crossed(anchors[far], boxes[far], rims) & foreign[far]
    costs[far] += _CROSSES * over.any(axis=1)
    return costs


def _hidden(centres: Floats, turns: Floats, size: Floats, ground: Ground) -> Floats:
    """Which part of each candidate is ink: in boxes along and across it, since it may be turned."""
    steps = (np.indices(_PARTS[bool(ground.halo)]).reshape(2, -1, 1) + 0.5).transpose(1, 2, 0)
    along_it = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    (across, up), aside = np.abs(along_it).T[:, :, None], along_it[:, ::-1] * (-1.0, 1.0)
    part = size / _PARTS[bool(ground.halo)]
    half = (across * part + up * part[:, ::-1]) / 2.0
    steps = steps * part - size / 2.0
    middles = centres + steps[..., :1] * along_it + steps[..., 1:] * aside
    parts = ground.hidden(np.concatenate([middles - half, middles + half], axis=2).reshape(-1, 4))
    return np.asarray(parts.reshape(len(steps), -1).mean(axis=0))


def crossed(anchors: Floats, boxes: Floats, marks: Floats) -> NDArray[np.bool_]:
    """Whether the leader of each candidate, (n,), runs over each of these boxes, (m, 4)."""
    first, last = np.array(0.1), np.array(0.95)
    for axis in (0, 1):
        start = anchors[:, axis, None]
        way = np.clip(start, boxes[:, axis, None], boxes[:, axis + 2, None]) - start
        with np.errstate(divide="ignore", invalid="ignore"):
            low, high = (marks[:, axis] - start) / way, (marks[:, axis + 2] - start) / way
        first = np.fmax(first, np.fmin(low, high))
        last = np.fmin(last, np.fmax(low, high))
    return np.asarray(first < last)


def _solve(
    ranks: Sequence[float],
    counts: Sequence[int],
    costs: Floats,
    boxes: Floats,
    em: float,
    crossings: NDArray[np.bool_],
    moves: int,
) -> list[int | None]:
    """The number of each label's candidate, or None.

    `crossings` says for every candidate whose boxes or leaders its own leader would run over.
    Where one is left without a place, all are annealed once more, hotter.
    """
    first = np.concatenate([[0], np.cumsum(counts)[:-1]]).tolist()
    clash = _pairs(boxes, em) | crossings | crossings.T
    bits = [
        int.from_bytes(row.tobytes(), "little")
        for row in np.packbits(clash, axis=1, bitorder="little")
    ]
    alone: list[float] = costs.tolist()
    unplaced = [_UNPLACED - 10.0 * rank for rank in ranks]
    free = [list(range(start, start + count)) for start, count in zip(first, counts, strict=True)]
    state: list[int | None] = [None] * len(ranks)
    placed = 0  # the bits of the candidates in `state`

    def cost_of(label: int, at: int | None) -> float:
        if at is None:
            return unplaced[label]
        return alone[at] + _OVERLAP * (bits[at] & placed).bit_count()

    for label in sorted(range(len(ranks)), key=ranks.__getitem__):
        at = min([*free[label], None], key=lambda at, label=label: cost_of(label, at))  # type: ignore[misc]
        if at is not None:
            state[label], placed = at, placed | 1 << at
    total = sum(unplaced[label] if at is None else alone[at] for label, at in enumerate(state))
    cheapest = sum(
        min((alone[at] for at in free[i]), default=unplaced[i]) for i in range(len(ranks))
    )
    movable = [label for label in range(len(ranks)) if len(free[label]) > 1]
    best, least, dice = list(state), total, random.Random(1995)
    going = len(movable) > 1 and least > cheapest + 1e-9
    for hot, move in product((False, True), range(moves if going else 0)):
        if hot and move == 0 and None not in best:
            break
        label = dice.choice(movable)
        was = state[label]
        at = dice.choice(free[label] if hot and was is None else free[label][:_TRIED])
        placed &= ~(0 if was is None else 1 << was)
        change = cost_of(label, at) - cost_of(label, was)
        heat = (40.0 if hot and None in state else 4.0) * (1.0 - move / moves) ** 2 + 1e-3
        if change <= 0.0 or dice.random() < math.exp(-change / heat):
            state[label] = was = at
            total += change
            if total < least - 1e-9:
                best, least = list(state), total
        placed |= 0 if was is None else 1 << was
    return [None if at is None else at - start for at, start in zip(best, first, strict=True)]


def _pairs(boxes: Floats, em: float) -> NDArray[np.bool_]:
    """Which candidates would overlap, or come too close to be told apart."""
    half = np.array([-0.12, -0.06, 0.12, 0.06]) * em
    clash = overlap(boxes + half, boxes + half)
    np.fill_diagonal(clash, False)
    return clash


def placed_label(wish: Wish, places: Places, number: int, em: float) -> PlacedLabel:
    (x, y), (at_x, at_y) = places.centres[number].tolist(), places.anchors[number].tolist()
    turn = float(places.turns[number])
    leads = places.leads and bool(places.away[number] > LEADER_FROM_EM * em)
    apart = [math.hypot(spot_x - at_x, spot_y - at_y) for spot_x, spot_y in wish.spots]
    nearest = min(range(len(apart)), key=lambda i: apart[i] if apart[i] >= 0.0 else math.inf)
    from_x, from_y = wish.spots[nearest]
    wide, high = wish.sizes(places)[number].tolist()
    leader = _leader((at_x, at_y), (x, y), (wide, high), em) if leads else None
    brief = places.brief is not None and bool(places.brief[number])
    kept = KeptSpot(nearest, (x - from_x, y - from_y), turn, leads, brief)
    return PlacedLabel((x, y), turn, leader, kept)


def _leader(
    spot: Spot, centre: Spot, size: tuple[float, float], em: float
) -> tuple[Spot, Spot] | None:
    """From the rim of a mark to the box of its label, if that is far: no stub is drawn."""
    (x, y), (middle_x, middle_y) = spot, centre
    end_x = min(max(x, middle_x - size[0] / 2.0), middle_x + size[0] / 2.0)
    end_y = min(max(y, middle_y - size[1] / 2.0), middle_y + size[1] / 2.0)
    away = math.hypot(end_x - x, end_y - y)
    if away <= LEADER_FROM_EM * em:
        return None
    part = _RIM_EM * em / away
    return (x + part * (end_x - x), y + part * (end_y - y)), (end_x, end_y)


def overlap(boxes: Floats, others: Floats) -> NDArray[np.bool_]:
    """Which boxes, (n, 4), overlap which others, (m, 4)."""
    left, low, right, high = boxes.T[:, :, None]
    other_left, other_low, other_right, other_high = others.T[:, None, :]
    across = (left < other_right) & (other_left < right)
    return np.asarray(across & (low < other_high) & (other_low < high))
