"""Random documents: each is refused with a sentence, or gives no silent NaN.

``python3 -m tests.random_documents --count 20000`` makes 20000 documents with any lens: valid ones,
some at the limits, and damaged ones. It uses those that are valid, stops at the first that gives a
silent NaN or a warning, and names its seed. The suite takes a twentieth of them.
"""

from __future__ import annotations

import argparse
import collections
import dataclasses
import json
import math
import random
import sys
import warnings
from typing import Any

import numpy as np

from app.document.codec import parse
from app.model.projection import DEPTH_RANGES, LENSES, Projection
from app.model.refusal import Refusal


def main() -> int:
    """Print how many documents had each outcome."""
    parser = argparse.ArgumentParser(prog="python3 -m tests.random_documents", description=__doc__)
    parser.add_argument("--count", type=int, default=20_000)
    options = parser.parse_args()
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


ENDS = (0.0, -0.0, 5e-324, 1e-300, 1e-205, 1e-200, 1e-100, 1e-9, 0.5, 1.0, 90.0, 180.0, 1e9, 1e90,
        1e100, 1e101, 1e308)  # fmt: skip
ODDITIES = (None, True, "inf", "nan", "1", "", [], {}, [1, 2, 3], 10**400, -1, 0, 7)


def a_size(rng: random.Random) -> float:
    """A number anywhere in the range of float64, mostly an ordinary one."""
    if rng.random() < 0.1:
        return rng.choice(ENDS)
    if rng.random() < 0.05:
        return rng.choice((1e-204, 1.1e-200, 1e-193, 1e99, 9.9e99))  # just allowed
    reach = rng.choice((1.0, 1.0, 3.0, 12.0, 100.0, 210.0))
    return float(10.0 ** rng.uniform(-reach, min(reach, 100.0)))


def a_number(rng: random.Random) -> float:
    return rng.choice((-1.0, 1.0)) * a_size(rng)


def at_the_ends(rng: random.Random) -> dict[str, Any]:
    """A lens whose numbers are all among the smallest or largest allowed."""
    kind = rng.choice(("frustum", "orthographic", "oblique"))
    small = {"frustum": (1e-290, 1e-204), "orthographic": (1.1e-200,), "oblique": (1.1e-194,)}
    lens: dict[str, Any] = {"kind": kind, "keep": rng.choice(("stretch", "x", "y"))}
    lens["near"] = rng.choice((1e-205, 1e-90, 1e90)) if kind == "frustum" else -1e100
    lens["far"] = rng.choice((1e100, lens["near"] + 2e-205, lens["near"] * 1.5))
    for low, high in (("left", "right"), ("bottom", "top")):
        lens[high] = rng.choice((1e-190, 1e-105, 1e-5, 1e90, 1e100, *small[kind]))
        lens[low] = rng.choice((-lens[high], 0.0, lens[high] * (1.0 - 1e-15)))
    if kind == "oblique":
        lens["alpha_deg"], lens["beta_deg"] = rng.choice((1e-4, 90.0, 179.9999)), 6e-5
    return lens


def an_interval(rng: random.Random, low: float) -> tuple[float, object]:
    kind = rng.random()
    if kind < 0.05:
        return low, rng.choice((low, -low, math.nextafter(low, math.inf), a_number(rng)))
    if kind < 0.5:
        return low, low + abs(low) * 10.0 ** rng.uniform(-16.0, 3.0)
    return low, low + a_size(rng)


def a_tree(rng: random.Random) -> dict[str, Any]:
    """A document with any lens: often valid, sometimes at the limits, sometimes damaged."""
    kind = rng.choice(list(LENSES))
    lens: dict[str, Any] = {"kind": kind}
    names = [field.name for field in dataclasses.fields(LENSES[kind])]
    near = a_size(rng) if LENSES[kind].central else a_number(rng)
    lens["near"], lens["far"] = an_interval(rng, near)
    if rng.random() < 0.2:
        lens["far"] = "inf"
    if "left" in names:
        for low, high in (("left", "right"), ("bottom", "top")):
            if rng.random() < 0.5:  # about the axis, as most are
                lens[high] = a_size(rng)
                lens[low] = -lens[high] * rng.choice((1.0, rng.random()))
            else:
                lens[low], lens[high] = an_interval(rng, a_number(rng))
        lens["keep"] = rng.choice(("stretch", "x", "y"))
    for name in sorted(set(names) - set(lens)):
        angles = rng.uniform(0, 180), a_size(rng), 180.0 - a_size(rng), 90.0
        lens[name] = rng.choice(angles) if name.endswith("_deg") else a_number(rng)
    if rng.random() < 0.2:
        lens = at_the_ends(rng)
    vectors = {key: [a_number(rng) for _ in range(3)] for key in ("eye", "target", "up")}
    if rng.random() < 0.1:
        vectors["eye"] = [rng.choice((-1e100, 1e100)) for _ in range(3)]
    elif rng.random() < 0.3:
        vectors["eye"] = [0.0, 0.0, a_size(rng)]
    if rng.random() < 0.7:
        vectors["up"] = [rng.uniform(-1.0, 1.0) for _ in range(3)]
    elif rng.random() < 0.3:  # up near the view direction
        turn = a_size(rng)
        vectors["up"] = [
            e - t + turn for e, t in zip(vectors["eye"], vectors["target"], strict=True)
        ]
    tree = {
        "format": "frustum-lab", "version": 1, "scene": "letter-f", "camera": vectors,
        "lens": lens, "depth": rng.choice(list(DEPTH_RANGES)),
        "image": {k: rng.choice((1, 640, 1080, 16384)) for k in ("width", "height")},
    }  # fmt: skip
    if rng.random() < 0.1:
        section: dict[str, Any] = rng.choice((tree, vectors, lens, tree["image"]))
        key = rng.choice(list(section))
        section[key] = rng.choice((*ODDITIES, math.nan, math.inf, a_number(rng)))
    return tree


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


if __name__ == "__main__":
    sys.exit(main())
