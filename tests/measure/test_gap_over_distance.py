"""The gap over the distance, against brute force over neighbouring depth codes."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app.document.document import Document
from app.document.settings import set_values
from app.measure.depth import distances, gaps
from app.measure.results import EVERY_BUFFER, OVER_DISTANCE, ErrorCurve, Sweep
from app.model.projection import Array, Perspective
from app.scenes.scene import load

START = load("letter-f").start


def _code(name: str, w: Array, near: float, far: float) -> Array:
    """The codes of distances, from the formulas of the lectures; no code of the program's."""
    form, _, mapping = name.partition(", ")
    nearness = (1.0 / w - 1.0 / far) / (1.0 / near - 1.0 / far)
    depth = {
        "reversed": nearness, "logarithmic": np.log(w / near) / np.log(far / near)
    }.get(mapping, 1.0 - nearness)  # fmt: skip
    if form.startswith("fixed"):
        return np.asarray(np.rint(depth * (2.0 ** int(form[5:]) - 1.0)))
    if not mapping:
        depth = 0.5 * (2.0 * depth - 1.0).astype(np.float32).astype(np.float64) + 0.5
    return np.asarray(depth.astype(form).astype(np.float64))


@pytest.mark.parametrize("name", EVERY_BUFFER)
def test_the_gap_over_the_distance_is_that_of_brute_force_over_neighbouring_codes(
    name: str,
) -> None:
    """Among 20 000 surfaces just behind one, the two farthest apart that share a code."""
    lens = Perspective(45.0, 0.5, 300.0)
    projection = replace(START, lens=lens, depth="opengl")
    checked = 0
    for distance in np.geomspace(0.7, 200.0, 12).tolist():
        answer, predicted, _ = gaps(OVER_DISTANCE, projection, np.empty((0, 3)), distance)[name]
        if answer is None:  # the next code is that of far
            behind = _code(name, np.array([distance, 0.9999 * lens.far]), lens.near, lens.far)
            codes = np.unique(_code(name, np.geomspace(distance, lens.far, 20_000), 0.5, 300.0))
            assert len(codes) <= 3 or behind[0] == behind[1]
            continue
        assert predicted is not None
        gap = answer.px
        if gap < 1e-9 * distance or distance + 4.0 * gap > lens.far:
            continue  # float64 has too few surfaces there
        checked += 1
        surfaces = np.linspace(distance, distance + 3.0 * gap, 20_000)
        codes = _code(name, surfaces, lens.near, lens.far)
        starts = np.flatnonzero(np.diff(codes, prepend=np.nan) != 0)
        ends = np.append(starts[1:], len(codes)) - 1
        widest = (surfaces[ends] - surfaces[starts])[:3].max()
        assert widest <= gap * (1.0 + 1e-6) + 1e-13 * distance, distance
        first = np.linspace(distance - 2.0 * gap, distance, 20_000)
        codes = _code(name, np.maximum(first, lens.near), lens.near, lens.far)
        own = distance - first[codes == codes[-1]].min()
        whole = max(widest, own + surfaces[ends[0]] - distance)
        assert whole == pytest.approx(gap, rel=2e-3), distance
    assert checked > 3


def test_a_click_on_a_distance_opens_the_depth_buffer_there() -> None:
    values = distances(replace(START, lens=Perspective(45.0, 0.5, 300.0)))
    assert values == (0.5, pytest.approx(300.0 / 1.01))
    endless = replace(START, lens=Perspective(45.0, 0.5, math.inf))
    assert distances(endless)[1] == pytest.approx(5e3 / 1.01)
    curve = ErrorCurve(*(((1.0,),) * 4), ("",))
    swept = Sweep(OVER_DISTANCE, "", (20.0,), dict.fromkeys(EVERY_BUFFER, curve))
    use = swept.use(0, 7, {"near": 0.5, "far": "inf"})
    document = set_values(
        Document("depth-buffer", load("depth-buffer").start),
        [f"{k}={value}" for k, value in use.items() if k not in ("scene", "camera.distance")],
    )
    assert use["scene"] == "depth-buffer" and use["camera.distance"] == "20.0"
    assert (document.projection.lens.near, document.projection.lens.far) == (0.5, math.inf)
    assert (document.settings["format"], document.settings["range"]) == ("float32", "reversed")
    assert swept.use(0, 0) == {"scene": "depth-buffer", "camera.distance": "20.0"}
    assert swept.use(1, 1) == {}
