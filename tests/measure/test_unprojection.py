"""Back from the picture, the trade: its numbers, its bounds, and what it uses."""

import numpy as np
import pytest

from app.document.document import Document
from app.document.settings import set_values
from app.measure.arithmetic import looked_at
from app.measure.unprojection import AWAY, measure, timed_way
from app.model.projection import Camera
from app.model.refusal import MEASURE
from app.precision.unprojecting import WAYS, float32_pixels, followed
from app.scenes.phenomena.unprojection import origin_away
from app.scenes.scene import load
from tests.oracles.exact import mp
from tests.oracles.unprojected import unprojected

SCENE = load("unprojection")
START = SCENE.start


@pytest.mark.parametrize("form", ["float32", "float64"])
@pytest.mark.parametrize("way", WAYS)
def test_what_is_timed_is_what_is_judged_bit_for_bit(way: str, form: str) -> None:
    trace = START.trace(looked_at(START, SCENE.sample)[:200])
    pixels = float32_pixels(trace.image, trace.depth)
    origin = origin_away(START, AWAY)
    run = timed_way(START, pixels, way, form, origin)
    run()  # a second run must not start from the first one's results
    points = run()
    assert points.dtype == form
    assert np.array_equal(points, followed(START, pixels, way, form, origin).value)


def test_errors_are_those_of_80_digits_and_below_their_bounds() -> None:
    trade = measure(START, SCENE.sample, seconds=0.0)
    assert len(trade.choices) == 6
    trace = START.trace(looked_at(START, SCENE.sample)[:200])
    pixels = np.unique(float32_pixels(trace.image, trace.depth), axis=0)
    origin = origin_away(START, AWAY)
    moved = [mp.mpf(e) - mp.mpf(o) for e, o in zip(START.camera.eye, origin, strict=True)]
    true = [unprojected(START, pixel) for pixel in pixels.tolist()]
    for choice in trade.choices:
        way, form = choice.use["settings.way"], choice.use["settings.numbers"]
        assert choice.error is not None and choice.predicted is not None
        assert choice.error <= choice.predicted <= 25.0 * choice.error
        value, _ = followed(START, pixels, way, form, origin)
        worst = max(
            mp.norm([a - b - c for a, b, c in zip(map(mp.mpf, row), offset, moved, strict=True)])
            / mp.norm(offset)
            for row, offset in zip(value.T.tolist(), true, strict=True)
        )
        assert choice.error == pytest.approx(float(worst), rel=1e-9)
        assert choice.values["error_1"] < choice.error and choice.cost and choice.bytes
    inverse, inverses, ray = trade.choices[:3]
    assert (inverse.error or 0.0) > 300.0 * (ray.error or 1.0)
    near = [choice.values["error_1"] for choice in (inverse, inverses, ray)]
    assert max(near) < 3.0 * min(near), "near the origin, no way is much better"


def test_a_choice_opens_the_scene_with_it() -> None:
    use = measure(START, SCENE.sample, seconds=0.0).choices[2].use
    document = set_values(
        Document(use["scene"], START),
        [f"{key}={value}" for key, value in use.items() if key != "scene"],
    )
    assert document.settings["way"] == "ray" and document.settings["origin"] == AWAY


def test_without_a_point_in_front_there_is_a_reason() -> None:
    away = Camera((0.0, 1.0, 5.0), (0.0, 1.0, 50.0))
    (choice,) = measure(START.__class__(away), SCENE.sample, seconds=0.0).choices
    assert choice.note == MEASURE["no-points"]
