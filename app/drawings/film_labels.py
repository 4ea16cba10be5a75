"""The labels of a film, which are placed on all of its frames together.

A label keeps its offset from what it names as long as it covers nothing. Where it has to leave, it
fades out and in again elsewhere, once for the rest of the film if that is possible.
"""

from collections.abc import Hashable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.drawings.label_placement import (
    LEADER_FROM_EM,
    Candidates,
    Floats,
    Ground,
    KeptSpot,
    Places,
    Wish,
    candidates,
    cheapest,
    crossed,
    overlap,
    placed_label,
)
from app.drawings.labels import Standing

_ASKED = 9  # frames whose own candidates are tried in all frames
_SAME_EM = 0.25  # candidates that are as close are one
_LEAVING = 60.0  # what it costs to leave a place: as much as bad places in several frames
_JUMPING = 10.0  # to move by an em more than one from a frame to the next
_STILL = 1.0  # and to stand still beside what moves
_HIDDEN = 1e3  # and to be hidden in a frame
_FOREIGN = 10.0  # and to be nearer to what another label names
_NEAR = 4  # frames before and after, in which a step is usual or a jump
_FADING = 2  # frames in which a label fades, on each side of a change


class Wanted(NamedTuple):
    """The wishes of one frame's labels, each with its candidates, and what they must not hide."""

    wishes: Sequence[tuple[Wish, Places]]
    ground: Ground


class FilmPlace(NamedTuple):
    """A place of a label: an offset from what it names, or a place where it stands `still`."""

    kept: KeptSpot
    away: float
    still: tuple[float, float] | None = None


def placed_in_film(frames: Sequence[Wanted], *, is_round: bool, fades: bool) -> list[Standing]:
    """Return where the labels of one pane stand in each frame.

    If the film `is_round`, its first frame follows its last one.
    """
    ranks: dict[Hashable, float] = {}
    for frame in frames:
        for wish, _ in frame.wishes:
            ranks[wish.key] = min(wish.rank, ranks.get(wish.key, wish.rank))
    options = {key: _options(key, frames) for key in ranks}
    tried = [_tried(frame, options) for frame in frames]
    stands: list[dict[Hashable, tuple[KeptSpot, float]]] = [{} for _ in frames]
    placed: list[list[Candidates]] = [[] for _ in frames]
    for key in sorted(ranks, key=ranks.__getitem__):
        steps = _steps([own.get(key) for own in tried], len(options[key])) / frames[0].ground.em
        costs = np.hstack([_JUMPING * np.maximum(steps - 1.0, 0.0), np.zeros((len(frames), 1))])
        costs += [*(0.0 if option.still is None else _STILL for option in options[key]), 0.0]
        for number, (own, here) in enumerate(zip(tried, placed, strict=True)):
            costs[number, -1] = _HIDDEN if key in own else 0.0
            costs[number, :-1] += own[key].costs if key in own else np.inf
            for other in here if key in own else ():
                covers = _clash(own[key], other, frames[number].ground.em)
                costs[number, :-1][covers] = np.inf
        path = _path(np.tile(costs, (2, 1)))[len(frames) :] if is_round else _path(costs)
        lights = _lights(path, np.hstack([steps, 0.0 * steps[:, :1]]), is_round)
        for number, (at, light) in enumerate(zip(path, lights, strict=True)):
            if at < len(options[key]):
                chosen = tried[number][key].part(at, at + 1)
                placed[number].append(chosen)
                kept, _, still = options[key][at]
                kept = kept._replace(leads=bool(chosen.has_leader[0]))
                if still is not None:
                    x, y = chosen.anchors[0].tolist()
                    kept = kept._replace(offset=(still[0] - x, still[1] - y))
                stands[number][key] = kept, light if fades else 1.0
    return list(stands)


def _options(key: Hashable, frames: Sequence[Wanted]) -> list[FilmPlace]:
    """Return the places of a label that are good in some frame."""
    chosen = sorted({round(at) for at in np.linspace(0, len(frames) - 1, _ASKED)})
    kept: dict[Hashable, FilmPlace] = {}
    for frame in map(frames.__getitem__, chosen):
        em = frame.ground.em
        for wish, places in frame.wishes:
            if wish.key != key or not len(places.centres):
                continue
            own = candidates([(wish, places)], frame.ground)
            for number in cheapest(own.costs, own.brief):
                label = placed_label(wish, places, number, em)
                spot = label.kept
                turn = round(spot.turn, 1), spot.spot, spot.leads, spot.brief
                option = FilmPlace(spot, float(places.away[number]))
                kept.setdefault((*turn, *_rounded(spot.offset, em)), option)
                if len(wish.spots) == 1 and places.leads:
                    still = option._replace(still=label.centre)
                    kept.setdefault((turn, *_rounded(label.centre, em)), still)
    return list(kept.values())


def _rounded(place: tuple[float, float], em: float) -> tuple[int, int]:
    return round(place[0] / (_SAME_EM * em)), round(place[1] / (_SAME_EM * em))


def _tried(frame: Wanted, options: dict[Hashable, list[FilmPlace]]) -> dict[Hashable, Candidates]:
    em, choices, strays = frame.ground.em, [], list[Floats]()
    outlines = [_outline(wish) for wish, _ in frame.wishes]
    for number, (wish, _) in enumerate(frame.wishes):
        places, spots = options[wish.key], [*wish.spots, (np.nan, np.nan)]
        if not places:
            continue
        anchors = np.array([spots[min(each.kept.spot, len(wish.spots))] for each in places])
        centres = anchors + [each.kept.offset for each in places]
        stands = np.array([each.still is not None for each in places])
        centres[stands] = np.reshape([each.still for each in places if each.still], (-1, 2))
        turns = np.array([each.kept.turn for each in places])
        brief = np.array([each.kept.brief for each in places])
        tried = Places(centres, turns, anchors, np.zeros(len(places)), brief=brief)
        sizes = wish.sizes(tried)
        own = _apart(centres, sizes, outlines[number])
        away = np.where(stands | (len(wish.spots) > 1), own, [each.away for each in places])
        leads = np.array([each.kept.leads for each in places])
        centres[~stands & ~leads & (away > LEADER_FROM_EM * em)] = np.nan  # too far
        choices.append((wish, tried._replace(away=away)))
        others = np.vstack([np.full((1, 2), np.nan), *outlines[:number], *outlines[number + 1 :]])
        strays.append(np.where(_apart(centres, sizes, others) < own, _FOREIGN, 0.0))
    if not choices:
        return {}
    every = candidates(choices, frame.ground)
    every = every._replace(costs=every.costs + np.concatenate(strays))
    ends = np.cumsum(every.counts).tolist()
    return {
        wish.key: every.part(start, end)
        for (wish, _), start, end in zip(choices, [0, *ends], ends, strict=False)
    }


def _outline(wish: Wish) -> Floats:
    """Return points of what a label names: its only spot, or along the edges between its spots."""
    ends = np.reshape(np.array(wish.spots, dtype=np.float64), (-1, 2))
    parts = np.linspace(0.0, 1.0, 9)[:, None, None] if len(ends) > 1 else np.zeros((1, 1, 1))
    return np.asarray((ends + parts * (np.roll(ends, -1, 0) - ends)).reshape(-1, 2))


def _apart(centres: Floats, sizes: Floats, points: Floats) -> Floats:
    """Return how far the nearest of some points is from each box."""
    beside = np.abs(points - centres[:, None]) - sizes[:, None] / 2.0
    apart = np.linalg.norm(np.maximum(beside, 0.0), axis=2)
    return np.asarray(np.where(np.isnan(apart), np.inf, apart).min(axis=1, initial=np.inf))


def _steps(each: Sequence[Candidates | None], count: int) -> Floats:
    """Return how far each place is from where it was in the frame before, (frames, places)."""
    lost = np.full((count, 2), np.nan)
    middles = [lost if own is None else own.boxes.reshape(-1, 2, 2).mean(axis=1) for own in each]
    moved = np.linalg.norm(np.diff(middles, axis=0, prepend=middles[:1]), axis=2)
    return np.asarray(np.nan_to_num(moved))


def _clash(some: Candidates, other: Candidates, em: float) -> NDArray[np.bool_]:
    """Whether candidates come too near to a label that is placed, or a leader crosses it."""
    half = np.array([-0.12, -0.06, 0.12, 0.06]) * em
    clash = overlap(some.boxes + half, other.boxes + half)[:, 0]
    clash |= some.has_leader & crossed(some.anchors, some.boxes, other.boxes)[:, 0]
    return np.asarray(clash | other.has_leader & crossed(other.anchors, other.boxes, some.boxes)[0])


def _path(costs: Floats) -> list[int]:
    """Return the cheapest way through the frames, (frames, places): Viterbi's."""
    total, came = costs[0], []
    for row in costs[1:]:
        best = int(total.argmin())
        leaves = total > total[best] + _LEAVING
        came.append(np.where(leaves, best, np.arange(len(total))))
        total = row + np.where(leaves, total[best] + _LEAVING, total)
    path = [int(total.argmin())]
    for before in reversed(came):
        path.append(int(before[path[-1]]))
    return path[::-1]


def _lights(path: Sequence[int], steps: Floats, is_round: bool) -> list[float]:
    """Return the light of a label in each frame: it fades where it, or what it names, jumps."""
    lights, count = [1.0] * len(path), len(path)
    moved = [steps[number, at] for number, at in enumerate(path)]
    for number in range(0 if is_round else 1, count):
        usual = float(np.median(moved[max(0, number - _NEAR) : number + _NEAR + 1]))
        most = 2.0 * usual if usual > 1.0 else 1.0
        if path[number] == path[number - 1] and moved[number] <= most:
            continue
        for away in range(_FADING):
            for at in (number - 1 - away, number + away):
                if is_round or 0 <= at < count:
                    lights[at % count] = min(lights[at % count], (away + 1) / (_FADING + 1))
    return lights
