"""Random documents and hardware: no bound of the error is below the error at 700 digits.

``python3 -m tests.fuzz cheap --count 2000`` projects the points of 2000 documents with random
formats, reciprocals and snapping, stops at the first bound that is too low, and names its seed. The
table says how much larger than the errors the bounds are. The suite takes fewer documents.
"""

import collections
import itertools
import json
import random
from collections.abc import Sequence
from typing import Any

import numpy as np

from app.arithmetic.formats import FORMATS, QUANTISED, RECIPROCALS, SNAPS
from app.document.codec import parse
from app.document.document import Document
from app.model.projection import Array, Projection
from app.precision.cheap import CheapPicture, Hardware, cheap
from app.scenes.scene import BUILT_IN, load
from tests.fuzz.catalogue import a_valid_tree, edited, some_points
from tests.oracles import exact
from tests.support.tools import ToolParser

DIGITS = 700
"""As in `tests.precision.test_levels`: documents have numbers from 1e-205 to 1e100."""


def main(words: Sequence[str]) -> int:
    """Print the ratios of bounds and errors for every format."""
    parser = ToolParser("fuzz cheap", __doc__)
    parser.add_argument("--count", type=int, default=2_000)
    options = parser.parse_args(words)
    found: dict[str, list[list[float]]] = collections.defaultdict(list)
    for seed in range(options.count):
        for name, ratios in ratios_of(seed).items():
            found[f"{name}, {'any' if seed % 2 else 'edited'}"].append(ratios)
    print("format, document     results  known  median  least of a document: median, largest")
    for name, documents in found.items():
        ratios = np.concatenate(documents)
        known = ratios[np.isfinite(ratios)]
        least = [min(each) for each in documents if each and np.isfinite(min(each))]
        figures = np.median(known), np.median(least), max(least)
        print(f"{name:20} {len(ratios):7} {len(known):6}", *(f"{each:7.3g}" for each in figures))
    return 0


def any_hardware(rng: random.Random, numbers: str) -> Hardware:
    """Hardware that computes in a format."""
    return Hardware(
        rng.choice((*FORMATS, *QUANTISED)), numbers,
        rng.choice([*SNAPS]), rng.choice([*RECIPROCALS]),
    )  # fmt: skip


def truth(projection: Projection, points: Array) -> list[list[Any]]:
    """x and y in pixels and the depth at 700 digits; None where there is no picture."""
    with exact.mp.workdps(DIGITS):
        oracle = exact.Exact(projection)
        rows: list[list[Any]] = []
        for point in points.tolist():
            try:
                answer = oracle(point)
            except ZeroDivisionError:  # in the eye plane
                rows.append([None] * 3)
            else:
                seen = answer.w > 0
                rows.append([*answer.image, answer.depth] if seen else [None] * 3)
        return rows


def ratios_of(seed: int) -> dict[str, list[float]]:
    """Bound over error of every result of a document, by format; a failure names the seed.

    Even seeds edit a scene of the program, odd ones draw any document.
    """
    rng = random.Random(seed)
    if seed % 2:
        projection = parse(json.dumps(a_valid_tree(rng))).projection
        points = np.array(some_points(rng, projection.view_from_world))
        points = points[(np.abs(points) <= 1e100).all(axis=1)]
    else:
        scene = rng.choice(BUILT_IN)
        document = Document(scene, load(scene).start)
        for _ in range(rng.randrange(6)):
            document = edited(rng, document)
        projection = document.projection
        points = np.array([[rng.uniform(-4.0, 4.0) for _ in range(3)] for _ in range(13)])
    origin = rng.choice(((0.0, 0.0, 0.0), projection.camera.target))
    true = truth(projection, points)
    found = {}
    for name in FORMATS:
        hardware = any_hardware(rng, name)
        picture = cheap(projection, points, hardware, origin)
        try:
            found[name] = _ratios(picture, true)
        except AssertionError as error:
            error.add_note(f"of the document with seed {seed}, with {hardware} from {origin}")
            raise
    return found


def _ratios(picture: CheapPicture, true: list[list[Any]]) -> list[float]:
    image, depth, bounds = picture
    numbers = np.column_stack([image, depth])
    assert not np.isnan(bounds).any()
    assert (np.isnan(numbers).any(axis=1) == np.isnan(numbers).all(axis=1)).all()
    assert np.isinf(bounds[np.isnan(numbers)]).all()
    ratios = []
    with exact.mp.workdps(DIGITS):
        for value, bound, number in zip(
            numbers.ravel().tolist(),
            bounds.ravel().tolist(),
            itertools.chain.from_iterable(true),
            strict=True,
        ):
            if np.isnan(value):
                continue
            if number is None:  # behind the eye, but not for certain
                assert np.isinf(bound)
                continue
            error = abs(exact.mp.mpf(value) - number)
            assert error <= bound, (value, bound, number)
            ratios.append(float(bound / error) if error else 1.0)
    return ratios
