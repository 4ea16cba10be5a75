"""Random documents: each is refused with a sentence, or gives no silent NaN.

``python3 -m tests.fuzz documents --count 20000`` makes 20000 documents with any lens: valid ones,
some at the limits, and damaged ones. It uses those that are valid, stops at the first that gives a
silent NaN or a warning, and names its seed. The suite takes a twentieth of them.
"""

import collections
import json
import random
import warnings
from collections.abc import Sequence

import numpy as np

from app.document.codec import parse
from app.model.projection import LENSES, Projection
from app.model.refusal import Refusal
from tests.fuzz.catalogue import a_number, a_size, a_tree, an_interval
from tests.support.tools import ToolParser


def main(words: Sequence[str]) -> int:
    """Print how many documents had each outcome."""
    parser = ToolParser("fuzz documents", __doc__)
    parser.add_argument("--count", type=int, default=20_000)
    options = parser.parse_args(words)
    warnings.simplefilter("error")
    found = collections.Counter(outcome_of(seed) for seed in range(options.count))
    for bound, count in found.most_common():
        print(f"{count:7} {bound}")
    return 0


def outcome_of(seed: int) -> str:
    """The `outcome` for a seed; a failure names the seed."""
    try:
        return outcome(random.Random(seed))
    except BaseException as error:
        error.add_note(f"of the document with seed {seed}")
        raise


def assert_whole(projection: Projection, points: np.ndarray) -> None:
    """Check that a projection gives NaN only for points that it says have no picture."""
    arrays = [
        projection.window, projection.stretch, projection.clip_from_world,
        projection.world_from_clip_at((0.0, 0.0, 0.0)), projection.view_from_clip,
    ]  # fmt: skip
    for stage in projection.stages:
        arrays += [stage.matrix, *(factor for _, factor in stage.factors)]
    if not projection.lens.parallel:
        arrays.append(projection.intrinsics)
    for array in arrays:
        assert np.isfinite(array).all(), array
    trace = projection.trace(points)
    assert np.isfinite(trace.view).all()
    assert np.isfinite(trace.clip).all()
    there = trace.in_front
    for array in (trace.ndc, trace.image, trace.depth):
        assert np.isfinite(array[there]).all()
        assert np.isnan(array[~there]).all()
    w = trace.clip[:, 3]
    assert not there[w <= 0.0].any()
    if not there[w > 0.0].all():  # only beside the eye plane, beyond float64's 1e308
        lost = ~there & (w > 0.0)
        size = np.abs(trace.clip[lost]).max(axis=-1) * max(projection.image_size)
        assert (np.log10(size) - np.log10(w[lost]) > 305.0).all(), (w[lost], size)


def outcome(rng: random.Random) -> str:
    """Read a random document, and use it if it is one: "valid", or the bound that refused it."""
    tree = a_tree(rng)
    text = json.dumps(tree)  # with NaN and Infinity, which are not JSON
    try:
        projection = parse(text).projection
    except Refusal as error:
        assert str(error).endswith(".")
        return error.bound
    eye, target = np.array(projection.camera.eye), np.array(projection.camera.target)
    window = max(map(abs, projection.window))
    points = np.array([
        eye, target, (0.0, 0.0, 0.0), [a_number(rng) for _ in range(3)],
        eye - projection.camera.frame[2] * projection.lens.near,
        eye + projection.camera.frame[2] * window, eye + a_number(rng), -eye,
        [rng.choice((-1e100, 1e100)) for _ in range(3)],
    ])  # fmt: skip
    assert_whole(projection, np.clip(points, -1e100, 1e100))
    for change in (
        lambda: projection.with_lens(rng.choice(list(LENSES))),
        lambda: projection.between(*an_interval(rng, a_size(rng))),
    ):
        try:
            changed = change()
        except Refusal as error:
            assert str(error).endswith(".")
        else:
            assert np.isfinite(changed.clip_from_world).all()
    return "valid"
