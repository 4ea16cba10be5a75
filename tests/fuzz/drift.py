"""Random turns and cameras: no bound of the drift is below its error in pixels.

``python3 -m tests.fuzz drift --count 1000000`` turns cameras about random axes, in each format and
each way, for one to three rounds, and looks at random points through random lenses. It stops at the
first bound that is too low. The table has the median of bound over error.
"""

import random
from collections.abc import Sequence
from fractions import Fraction
from itertools import islice

import numpy as np

from app.arithmetic.double_double import DoubleDouble
from app.model.projection import Array
from app.precision.drift import BLOCK, drifted, errors_px, exact_turn, rounds_of
from app.scenes.scene import load
from tests.oracles.illustrations import random_projection
from tests.support.tools import ToolParser

AXES, ROUNDS = 400, 3


def main(words: Sequence[str]) -> int:
    """Print the median ratio of every format and way."""
    parser = ToolParser("fuzz drift", __doc__)
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args(words)
    per_way = options.count // 12
    print("numbers, way               cases   below  median of bound/error in px, of the axes")
    every: list[float] = []
    for numbers in ("float16", "float32", "float64"):
        for way in ("products", "renormalised", "fast", "sines"):
            dice = random.Random(f"{options.seed} {numbers} {way}")
            ratios, of_axes = ratios_of(dice, numbers, way, per_way)
            below = int((ratios < 1.0).sum())
            every += ratios.tolist()
            figures = (
                f"{len(ratios):8} {below:7} {np.median(ratios):8.3g} {np.median(of_axes):8.3g}"
            )
            print(f"{numbers}, {way:14}", figures)
            assert not below, (numbers, way)
    print(f"all: {len(every)} cases, median {np.median(every):.3g}")
    return 0


def unit_axis(dice: random.Random) -> tuple[Fraction, Fraction, Fraction]:
    """A random axis of length 1, by the projection of a plane onto a ball."""
    x, y = (Fraction(dice.randint(-999, 999), dice.randint(1, 999)) for _ in range(2))
    below = 1 + x * x + y * y
    axis = [2 * x / below, 2 * y / below, (x * x + y * y - 1) / below]
    dice.shuffle(axis)
    return axis[0], axis[1], axis[2]


def stacked(turns: Sequence[DoubleDouble]) -> DoubleDouble:
    """Turns (3, 3) as one (3, 3, n)."""
    return DoubleDouble(*(np.stack(parts, axis=-1) for parts in zip(*turns, strict=True)))


def ratios_of(dice: random.Random, numbers: str, way: str, count: int) -> tuple[Array, list[float]]:
    """Bound over error of points in pixels, and of the axes themselves."""
    start, ratios, of_axes = load("letter-f").start, list[Array](), list[float]()
    done = 0
    while done < count:
        axes = [unit_axis(dice) for _ in range(AXES)]
        turns = [stacked([exact_turn(d, axis) for axis in axes]) for d in (1, BLOCK)]
        if way == "sines":
            each = [drifted(numbers, way, dice.randint(1, ROUNDS)) for _ in axes]
            off, bound = np.stack([one for one, _ in each], axis=-1), np.array([b for _, b in each])
        else:
            *_, (off, bound) = islice(rounds_of(numbers, way, turns), dice.randint(1, ROUNDS))
        of_axes += (bound / np.linalg.norm(off, axis=(0, 1))).tolist()
        for which in range(AXES):
            seen = random_projection(dice, start)
            points = np.array([[dice.uniform(-3, 3) for _ in range(3)] for _ in range(64)])
            trace = seen.trace(points)
            points = points[trace.in_front & ~trace.outside.any(axis=1)]
            px, most = errors_px(seen, points, off[:, :, which], float(bound[which]))
            known = np.isfinite(most)
            errors = np.linalg.norm(px[known], axis=1)
            ratios.append(most[known] / np.where(errors > 0.0, errors, np.nan))
            done += len(points)
    together = np.concatenate(ratios)
    return together[~np.isnan(together)], of_axes
