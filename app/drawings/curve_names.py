"""Names beside the points and the curves of a diagram, by the one placer of labels."""

from functools import partial

import numpy as np

from app.drawings.label_placement import (
    LEADER_FROM_EM,
    Floats,
    Ground,
    Places,
    Spot,
    Wish,
    around,
    crossed,
    overlap,
    place,
)

GAP_PX = 3.0  # between a curve and its name


def beside(
    points: Floats, sizes: Floats, frame: Floats, along: Floats, gaps: Floats, taken: Floats
) -> list[Floats | None]:
    """Place the names of points; None where a name has no free place.

    - `points`, `sizes` (n, 2): in pixels; the first ones choose first. A name without width gets no
      place. A name is nearer to its point than to any other that does not cover it.
    - `frame`, `taken` (4,) and (k, 4): left, low, right, high: where names may be, and boxes of
      other names; so is the result.
    - `along` (m, 2): places along curves, which no name hides. No line to a name crosses a curve,
      another point or a name.
    - `gaps` (n,): from each point to its name.
    """
    em = float(sizes[:, 1].max())
    ground = Ground(frame.tolist(), em)
    pairs = np.stack([along[:-1], along[1:]])[:, (along[1:, 0] >= along[:-1, 0]).nonzero()[0]]
    between = pairs[0] + np.linspace(0.0, 1.0, 6)[:, None, None] * (pairs[1] - pairs[0])
    inked = np.vstack([along, between.reshape(-1, 2)])
    for box in (*taken.tolist(), *np.hstack([inked - 1.0, inked + 1.0]).tolist()):
        ground.keep_box(*box)
    lines = np.vstack([np.hstack([pairs.min(axis=0), pairs.max(axis=0)]), taken])
    marks, rim = points[np.isfinite(points).all(axis=1)], 0.6 * float(gaps.min())
    wishes = []
    for i, (point, size, gap) in enumerate(zip(points, sizes, gaps.tolist(), strict=True)):
        ground.keep([point.tolist()], 0.4 * gap)
        if size[0] > 0.0:
            wide, high = size.tolist()
            own = np.concatenate([point - gap, point + gap])
            foreign = marks[np.linalg.norm(marks - point, axis=1) > rim]
            rims = np.hstack([foreign - rim, foreign + rim])
            others = np.vstack([lines[~overlap(own[None], lines)[0]], rims])
            near = gap - 0.3 * em
            places = partial(_clear, point, (wide, high), em, near, others, foreign, frame)
            wishes.append(Wish(i, (wide, high), [(point[0], point[1])], places, i))
    placed = place(wishes, ground, untangled=True)
    labels = (placed.get(i) for i in range(len(points)))
    return [
        None
        if each is None
        else np.concatenate([each.centre - size / 2.0, each.centre + size / 2.0])
        for each, size in zip(labels, sizes, strict=True)
    ]


def _clear(
    point: Floats, size: Spot, em: float, rim: float, lines: Floats, foreign: Floats, frame: Floats
) -> Places:
    """The places nearest to a point, whose leaders cross no line; only with one they slide."""
    places, half = around(point, size, em, rim), np.array(size) / 2.0
    boxes = np.hstack([places.centres - half, places.centres + half])
    far = places.away > LEADER_FROM_EM * em
    free = ~(far & crossed(places.anchors, boxes, lines).any(axis=1))
    free &= far | (np.clip(boxes, frame[[0, 1, 0, 1]], frame[[2, 3, 2, 3]]) == boxes).all(axis=1)
    own = np.minimum(_apart(boxes, point[None]), LEADER_FROM_EM * em)  # a leader says whose it is
    free &= (own + 0.2 * em < _apart(boxes, foreign)).all(axis=1)
    centres, turns, anchors, away, *_ = places
    return Places(centres[free], turns[free], anchors[free], away[free])


def _apart(boxes: Floats, points: Floats) -> Floats:
    """How far points, (m, 2), are from boxes, (n, 4): (n, m)."""
    nearest = np.clip(points, boxes[:, None, :2], boxes[:, None, 2:])
    return np.asarray(np.linalg.norm(nearest - points, axis=2))


def stays(
    kept: Floats, frame: Floats, along: Floats, size: tuple[float, float], taken: Floats
) -> bool:
    """Whether a curve's name can keep its place, (4,): it is free, and beside the curve."""
    if np.abs(kept[2:] - kept[:2] - size).max() >= 1e-3:
        return False
    near = kept + size[1] * np.array([-1.0, -1.0, 1.0, 1.0])
    fits = (kept[:2] >= frame[:2]).all() and (kept[2:] <= frame[2:]).all()
    is_free = fits and not overlap(kept[None], taken).any()
    return bool(is_free and overlap(near[None], np.hstack([along, along])).any())


def beside_curve(
    frame: Floats,
    along: Floats,
    half: float,
    size: tuple[float, float],
    taken: Floats,
    lines: Floats,
    foreign: Floats,
    *,
    strict: bool = False,
) -> Floats | None:
    """Place a curve's name beside the curve, free of other names and of curves, if possible, and
    nearer to its curve than to a foreign one.

    Without a free place the name goes into a list at the top left; if `strict`, it has none unless
    it hides no curve and is nearest to its own.

    - `frame` (4,): left, top, right, bottom: where names may be; so are all boxes.
    - `along` (n, 2): places along the curve, which is `half` pixels wide on either side.
    - `taken`, `lines` (m, 4) and (k, 4): boxes of other names, and of pieces of all curves.
    - `foreign` (j, 2): places along the other curves.
    """
    width, height = size
    right, left = GAP_PX + half - 1.0, 1.0 - half - width  # a line touches its name, a dot does not
    sides = np.array([(right, -height), (left, -height), (right, 1.0), (left, 1.0)])
    corners = (along[::-1, None, :] + sides).reshape(-1, 2)  # from the right, where curves part
    boxes = np.hstack([corners, corners + size])
    costs = overlap(boxes, lines).sum(axis=1).astype(np.float64)
    if len(foreign) and len(boxes):
        apart = _apart(boxes, foreign).min(axis=1)
        costs += 3.0 * np.clip(1.0 - apart / height, 0.0, 1.0)
        is_stray = apart < _apart(boxes, along).min(axis=1) + height / 4.0
        costs[strict & is_stray] = np.inf
    costs[strict & overlap(boxes, lines).any(axis=1)] = np.inf
    inside = (boxes[:, :2] >= frame[:2]).all(axis=1) & (boxes[:, 2:] <= frame[2:]).all(axis=1)
    costs[~inside | overlap(boxes, taken).any(axis=1)] = np.inf
    if len(costs) and costs.min() < np.inf:
        return np.asarray(boxes[int(costs.argmin())])
    if strict:
        return None
    left, top = frame[:2] + GAP_PX
    box = np.array([left, top, left + width, top + height])
    while overlap(box[None], taken).any() and box[3] < frame[3]:
        box += (0.0, height, 0.0, height)
    return box
