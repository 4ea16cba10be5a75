"""Back from the picture: what is drawn and read, against 80 digits, and what has no point."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import Camera, Perspective
from app.precision.unprojecting import WAYS, float32_pixels, followed
from app.scenes.phenomena.unprojection import PHENOMENON, origin_away
from app.scenes.shapes import letter_f_edges
from tests.oracles.exact import mp
from tests.oracles.illustrations import random_projection, reading, showing, subject_of, value
from tests.oracles.unprojected import unprojected

START = PHENOMENON.start
shown = showing(PHENOMENON, subject_of(PHENOMENON))
POINT = np.array((1.5, 4.5, 0.5))


@pytest.mark.parametrize("numbers", ["float32", "float64"])
@pytest.mark.parametrize("way", WAYS)
def test_the_error_that_is_read_is_that_of_80_digits_and_below_its_bound(
    way: str, numbers: str
) -> None:
    dice, compared = random.Random(49), 0
    for _ in range(12):
        seen = random_projection(dice, START)
        trace = seen.trace(POINT)
        pixel = float32_pixels(trace.image[None], trace.depth[None])
        origin = 10 ** dice.uniform(0, 6)
        here = shown(seen, way=way, numbers=numbers, origin=origin)
        if here.warning is not None:
            assert trace.outside.any()
            continue
        compared += 1
        start = origin_away(seen, origin)
        answer, _ = followed(seen, pixel, way, numbers, start)
        true = unprojected(seen, pixel[0].tolist())
        off = [
            mp.mpf(a) + mp.mpf(o) - mp.mpf(e) - t
            for a, o, e, t in zip(answer[:, 0].tolist(), start, seen.camera.eye, true, strict=True)
        ]
        length, away = mp.norm(off), mp.norm(true)
        assert value(here, "error of P") == pytest.approx(float(length), rel=1e-9)
        assert value(here, "bound of the error") >= length
        assert value(here, "of the distance") == pytest.approx(float(100 * length / away))
    assert compared > 3


def test_the_start_shows_the_error_as_large_as_it_is() -> None:
    """7 % of the distance with one inverse; the ray is a thousand times nearer."""
    here = shown()
    off = value(here, "error of P")
    assert 0.3 < off < 1.0 and value(here, "of the distance") > 4.0
    (line,) = (each for each in here.world.lines if each.width == 2.0)
    assert math.dist(*line.points) == pytest.approx(off, rel=1e-3)
    (text,) = (each for each in here.world.texts if each.name == "error")
    assert text.text == f"{off:.2g}"
    assert value(shown(way="ray"), "error of P") < off / 300.0
    small = shown(way="ray", origin=10.0)
    (text,) = (each for each in small.world.texts if each.name == "error")
    assert text.text.endswith(" 000 ×)")
    (back,) = (dot.point for dot in small.world.dots if dot.name == "back")
    assert 1e-3 < math.dist(back, POINT) < 1.5


def test_the_whole_letter_comes_back_from_its_pixels() -> None:
    lines = np.array([each.points for each in shown().world.lines if each.name == "back"])
    edges = letter_f_edges()[0]
    away = np.linalg.norm(lines - edges, axis=2)
    assert 0.3 < away.max() < 2.0 and away.min() > 1e-3
    seen = {tuple(start): tuple(end) for start, end in zip(edges[:, 0], lines[:, 0], strict=True)}
    assert len(set(seen.values())) == len(seen), "one place for each corner"


def test_only_the_origin_moves() -> None:
    for distance in (1.0, 1e5):
        assert math.dist(origin_away(START, distance), START.camera.eye) == pytest.approx(distance)
    assert np.array_equal(shown(origin=1.0).image.dots[0].point, shown().image.dots[0].point)


def test_one_matrix_or_two_is_a_myth() -> None:
    one, two = (value(shown(), f"drawn by {by}, off by") for by in ("P V", "V, then P"))
    assert 0.05 < one < 1.0 and 0.05 < two < 1.0
    assert (
        max(
            value(shown(numbers="float64"), f"drawn by {by}, off by") for by in ("P V", "V, then P")
        )
        < 1e-6
    )


def test_what_has_no_pixel_is_said_in_one_sentence_with_field_value_and_bound() -> None:
    def warning(point: tuple[float, float, float], projection: object = START) -> str:
        said = shown(projection, point=point).warning  # type: ignore[arg-type]
        assert said is not None
        return said.sentence()

    assert warning((6.0, 5.0, 9.5)) == "P is not in front of the eye, so it has no pixel"
    outside = warning((4.0, 0.0, 4.0))
    assert outside.startswith("y = ") and "must be from 0 to 720" in outside
    near = replace(START, lens=Perspective(38.0, 9.9, 1000.0))
    assert warning((1.5, 4.5, 0.5), near).startswith("depth = −")
    endless = replace(START, lens=Perspective(38.0, 1e-9, math.inf))
    assert warning((1.5, 4.5, 0.5), endless).startswith("depth = 1: is at infinity")
    assert warning((1.5, 4.5, 0.5), endless.with_depth("reversed").with_depth("opengl"))
    beyond = replace(START, camera=Camera((0.0, 2.0, 1e9), (0.0, 2.0, 0.0)))
    assert warning((1.5, 4.5, 0.5), beyond).startswith("depth = ")
    assert reading(shown(), "error of P").note is None
