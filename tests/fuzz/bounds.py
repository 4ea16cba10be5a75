"""Random cases of the trades: no bound is below the error.

``python3 -m tests.fuzz bounds --count 1000000`` draws so many cases of each trade, stops at the
first bound that is too low, and names its seed. The table says how much larger the bounds are.
"""

import collections
import random
from collections.abc import Callable, Sequence

import numpy as np

from app.model.projection import Array, Camera, Perspective, Projection
from app.precision.unprojecting import WAYS, float32_pixels, followed
from tests.fuzz.seams import seams, vertex_depth
from tests.support.tools import ToolParser, one_of

BLOCK = 1000
"""Cases that share a camera."""


def main(words: Sequence[str]) -> int:
    """Print the ratios of bounds and errors for every choice of every trade."""
    parser = ToolParser("fuzz bounds", __doc__)
    parser.add_argument("--count", type=int, default=1_000_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("trade", nargs="*", type=one_of(TRADES, "trade"))
    options = parser.parse_args(words)
    print("trade, choice                          cases   least  median")
    for trade in options.trade or TRADES:
        for name, ratios in ratios_of(trade, options.seed, options.count).items():
            label = f"{trade}, {name}"
            print(f"{label:34} {len(ratios):9} {ratios.min():7.3g} {np.median(ratios):7.3g}")
    return 0


def ratios_of(trade: str, seed: int, count: int) -> dict[str, Array]:
    """Bound over error of so many cases, by choice; a failure names the seed of its block."""
    ratios = collections.defaultdict(list)
    for block in range(seed, seed + -(-count // BLOCK)):
        for name, (error, bound) in TRADES[trade](random.Random(block)).items():
            assert (error <= bound).all(), f"{trade}, {name}: a bound is too low at --seed {block}"
            ratios[name].append(bound / np.maximum(error, 1e-300))
    return {name: np.concatenate(each)[:count] for name, each in ratios.items()}


def unprojection(dice: random.Random) -> dict[str, tuple[Array, Array]]:
    """Pixels and depths of a camera far from the origin; the truth has 64 bits, and no inverse."""
    eye = np.array([dice.gauss(0, 1) for _ in range(3)]) * 10 ** dice.uniform(0, 2)
    camera = Camera(tuple(eye.tolist()), (0.1, 0.2, 0.3), (0.0, 1.0, 0.01))
    near = 10 ** dice.uniform(-2, 0.5)
    lens = Perspective(dice.uniform(10, 120), near, dice.choice((1e3 * near, 30 * near, np.inf)))
    size = dice.randrange(300, 4000), dice.randrange(300, 4000)
    depth_range = dice.choice(("opengl", "direct3d", "reversed"))
    projection = Projection(camera, lens, size, depth_range)  # type: ignore[arg-type]
    rng = np.random.default_rng(dice.randrange(2**32))
    w = near * np.exp(rng.uniform(0.0, np.log(min(lens.far / near, 1e4)), BLOCK))
    depth = (1 / near - 1 / w) / (1 / near - 1 / lens.far)
    depth = 1 - depth if depth_range == "reversed" else depth
    pixels = float32_pixels(rng.uniform(0, 1, (BLOCK, 2)) * size, np.clip(depth, 1e-7, 1 - 1e-7))
    origin = eye + 10 ** dice.uniform(0, 6) * rng.normal(size=3) / 3**0.5

    long = np.longdouble
    x, y, depth = pixels.T.astype(long)
    part = 1 - depth if depth_range == "reversed" else depth
    w = 1 / ((1 - part) / long(near) + part / long(lens.far))
    top = _tan(lens.fov_y_deg)
    x = (2 * x / size[0] - 1) * top * size[0] / size[1] * w
    y = (1 - 2 * y / size[1]) * top * w
    u, v, n = (
        [long(float(c)) + long(float(c - type(c)(float(c)))) for c in axis]
        for axis in camera.exact_frame
    )
    moved = eye.astype(long) - origin.astype(long)
    true = np.array([x * a + y * b - w * c + e for a, b, c, e in zip(u, v, n, moved, strict=True)])
    start = tuple(origin.tolist())
    results = {}
    for form in ("float32", "float64"):
        for way in WAYS:
            value, bound = followed(projection, pixels, way, form, start)  # type: ignore[arg-type]
            error = np.abs(value.astype(long) - true)
            assert (error <= bound).all(), (form, way)
            lengths = (np.sqrt((each.astype(long) ** 2).sum(axis=0)) for each in (error, bound))
            results[f"{form}, {way}"] = tuple(each.astype(float) for each in lengths)
    return results  # type: ignore[return-value]


def _tan(fov_y_deg: float) -> np.longdouble:
    """The tangent of half an angle, to 64 bits."""
    from mpmath import mp

    with mp.workdps(40):
        tangent = mp.tan(mp.radians(mp.mpf(fov_y_deg) / 2))
        high = float(tangent)
        return np.longdouble(high) + np.longdouble(float(tangent - high))


TRADES: dict[str, Callable[[random.Random], dict[str, tuple[Array, Array]]]] = {
    "unprojection": unprojection,
    "vertex-depth": vertex_depth,
    "cracks": seams,
}
"""Each draws `BLOCK` cases: errors and bounds, (n,) each, by choice."""
