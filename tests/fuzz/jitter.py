"""Random places and cameras: no bound of a jump far from the origin is below its error.

``python3 -m tests.fuzz jitter --count 1000000`` moves random cameras by a millimetre a frame, from
1 m to 1e9 m away from the origin, and looks at random vertices in each of the arithmetics. It stops
at the first bound that is too low. The table has the median of bound over error.
"""

import random
from collections.abc import Sequence

import numpy as np

from app.model.projection import Array
from app.scenes.phenomena.jitter import jump_errors, paths_of
from app.scenes.scene import load
from tests.oracles.illustrations import random_projection
from tests.support.tools import ToolParser

WAYS = ("world", "relative", "two")


def main(words: Sequence[str]) -> int:
    """Print the median ratio of every arithmetic."""
    parser = ToolParser("fuzz jitter", __doc__)
    parser.add_argument("--count", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args(words)
    print("coordinates    jumps  below  median of bound over error")
    every = ratios_of(random.Random(options.seed), options.count // len(WAYS))
    for way, ratios in zip(WAYS, every, strict=True):
        below = int((ratios < 1.0).sum())
        print(f"{way:10} {len(ratios):9} {below:6} {np.median(ratios):8.3g}")
        assert not below, way
    print(f"all: {sum(map(len, every))} jumps, median {np.median(np.concatenate(every)):.3g}")
    return 0


def ratios_of(dice: random.Random, count: int) -> list[Array]:
    """Bound over error of so many jumps of every arithmetic."""
    start, ratios = load("letter-f").start, [list[Array]() for _ in WAYS]
    while sum(map(len, ratios[0])) < count:
        seen, distance = random_projection(dice, start), 10.0 ** dice.uniform(0.0, 9.0)
        points = np.array([[dice.uniform(-3, 3) for _ in range(3)] for _ in range(20)])
        trace = seen.trace(points)
        points = points[trace.in_front & ~trace.outside.any(axis=1)]
        for way, known in zip(WAYS, ratios, strict=True) if len(points) else ():
            errors, bounds = (
                each.ravel() for each in jump_errors(paths_of(seen, points, way, distance))
            )
            counted = np.isfinite(bounds) & (errors > 0.0)
            known.append(bounds[counted] / errors[counted])
    return [np.concatenate(each) for each in ratios]
