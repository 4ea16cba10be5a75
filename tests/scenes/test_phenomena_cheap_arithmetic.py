"""Cheap arithmetic: what is drawn and read, against vertices done by hand in 40 digits."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.model.lenses import LENSES
from app.model.projection import Camera, Perspective, Projection
from app.scenes.phenomena.cheap_arithmetic import PHENOMENON, PRESETS, enlargement
from app.scenes.phenomena.illustration import Illustration
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import readings, showing, subject_of, value, why

POINTS = np.unique(PHENOMENON.geometry()[0][0].reshape(-1, 3), axis=0)
START = PHENOMENON.start
EXACTLY = {"preset": "own", "numbers": "float64", "reciprocal": "exact"}
"""Nothing but the vertices or the snapping is cheap."""

show = showing(PHENOMENON, subject_of(PHENOMENON))


def pixel(seen: Projection, point: Any) -> list[Any]:
    return Exact(seen)([mp.mpf(part) for part in point]).image


def largest(seen: Projection, stored: Any, drawn: Any = lambda place: place) -> float:
    """The length of the longest error, with vertices stored and pixels drawn as these say."""
    errors = []
    for point in POINTS.tolist():
        true, found = pixel(seen, point), drawn(pixel(seen, stored(point)))
        errors.append(mp.hypot(found[0] - true[0], found[1] - true[1]))
    return float(max(errors))


def arrows(shown: Illustration) -> np.ndarray:
    """Where the arrows of the image start and end, (k, 2, 2)."""
    return np.array([line.points[:2] for line in shown.image.lines])


@pytest.mark.parametrize("bits", [8, 12, 16])
def test_vertices_of_few_bits_are_at_the_nearest_of_their_places(bits: int) -> None:
    """The scene is 8 long, from -4, -4 to 4, 4; the places are 8/(2^b - 1) apart."""
    step = mp.mpf(8) / (2**bits - 1)

    def stored(point: Any) -> list[Any]:
        lower = -4, 0, -4
        return [low + step * mp.nint((p - low) / step) for p, low in zip(point, lower, strict=True)]

    shown = show(vertices=f"bits{bits}", **EXACTLY)
    assert value(shown, "measured") == pytest.approx(largest(START, stored), rel=1e-9)
    assert value(shown, "bytes") == 3 * bits / 8
    assert shown.vertices is not None
    apart = [stored(point) for point in shown.vertices.own.tolist()]
    assert shown.vertices.stored == pytest.approx(np.array(apart, dtype=float), abs=1e-12)


@pytest.mark.parametrize(("snap", "step"), [("whole", 1), ("quarter", 4), ("sixteenth", 16)])
def test_a_snapped_vertex_is_at_the_nearest_place_of_the_grid(snap: str, step: int) -> None:
    def drawn(place: list[Any]) -> list[Any]:
        return [mp.nint(part * step) / step for part in place]

    shown = show(vertices="float64", snap=snap, **EXACTLY)
    expected = largest(START, list, drawn)
    assert value(shown, "measured") == pytest.approx(expected, rel=1e-9)
    assert 0.3 / step < expected <= value(shown, "predicted") <= 0.7072 / step


def test_far_from_the_origin_x_is_a_multiple_of_a_sixteenth() -> None:
    """Near 1 000 000, which is between 2^19 and 2^20, the last of 24 bits counts 2^-4."""
    shown = show(preset="far")
    assert shown.vertices is not None
    own, stored = shown.vertices.own, shown.vertices.stored
    assert (stored[:, 0] * 16.0 == np.rint(own[:, 0] * 16.0)).all()
    assert stored[:, 1:] == pytest.approx(own[:, 1:], abs=1e-6)
    near, far = (value(show(preset="far", origin=at), "measured") for at in (1e3, 1e8))
    assert near < 0.01 < 1.0 < value(shown, "measured") < far


def test_no_error_is_larger_than_predicted_whatever_the_camera_does() -> None:
    dice = np.random.default_rng(35)
    for number in range(150):
        eye = tuple(dice.uniform(-12.0, 12.0, 3).tolist())
        lens = Perspective(float(dice.uniform(20.0, 100.0)), 0.1, 60.0)
        seen = replace(START, camera=Camera(eye, (0.0, 1.0, 0.0)), lens=lens)
        preset = [*PRESETS][number % len(PRESETS)]
        shown = show(seen.with_lens([*LENSES][number % len(LENSES)]), preset=preset)
        found = readings(shown)
        predicted = found["largest error, predicted"]
        if predicted is not None:
            assert found["largest error, measured"] <= predicted + 1e-12, (preset, seen)


def test_the_drawn_vertices_have_the_pixels_that_came_out_and_their_own_depth() -> None:
    for preset in PRESETS:
        for kind in LENSES:
            seen = START.with_lens(kind)
            shown = show(seen, preset=preset)
            assert shown.vertices is not None
            own, drawn = (
                seen.trace(points) for points in (shown.vertices.own, shown.vertices.projected)
            )
            off = np.linalg.norm(drawn.image - own.image, axis=1)
            measured = value(shown, "measured")
            assert off.max() == pytest.approx(measured, rel=1e-6, abs=1e-11), (preset, kind)
            assert drawn.view[:, 2] == pytest.approx(own.view[:, 2], rel=1e-12)
            if preset == "console":
                assert drawn.image == pytest.approx(np.rint(drawn.image), abs=1e-9)


def test_the_arrows_are_the_errors_enlarged_as_they_say() -> None:
    for preset in PRESETS:
        shown = show(preset=preset)
        factor = readings(shown)["arrows in the image, enlarged"]
        if preset == "exact":
            assert factor is None and "no error" in why(shown, "enlarged")
            assert shown.image.lines == shown.world.lines == ()
            continue
        starts, tips = np.moveaxis(arrows(shown), 1, 0)
        vertices = shown.vertices
        assert vertices is not None
        true, drawn = (START.trace(p).image for p in (vertices.own, vertices.projected))
        row = np.array([np.abs(true - start).sum(axis=1).argmin() for start in starts])
        assert starts == pytest.approx(true[row], abs=1e-9)
        assert tips - starts == pytest.approx(factor * (drawn - true)[row], rel=1e-6, abs=1e-6)
        assert len(starts) > 20
        longest = np.linalg.norm(tips - starts, axis=1).max()
        assert longest <= 0.12 * 240.0
        (text,) = shown.image.texts
        assert not ((tips[:, 0] > text.point[0]) & (tips[:, 1] < text.point[1])).any()
        assert text.text == f"{factor:,.0f} ×".replace(",", " ")


@pytest.mark.parametrize(
    ("longest", "factor"),
    [(1.0, 20.0), (28.8, 1.0), (28.9, 0.5), (0.6, 20.0), (0.0028, 10_000.0), (0.0, None),
     (1e-12, None), (math.inf, None)],
)  # fmt: skip
def test_arrows_are_enlarged_by_a_round_number(longest: float, factor: float | None) -> None:
    assert enlargement(longest, 28.8) == (None if factor is None else pytest.approx(factor))


def test_the_error_of_a_stored_vertex_grows_as_the_camera_comes_nearer() -> None:
    found = []
    for distance in (8.0, 16.0, 32.0):
        seen = replace(START, camera=Camera((0.0, 1.0, distance), (0.0, 1.0, 0.0)))
        seen = replace(seen, lens=Perspective(60.0, 1.0, 50.0))
        found.append(value(show(seen, vertices="bits8", **EXACTLY), "measured"))
    assert found[0] > 1.7 * found[1] > 3.0 * found[2]


def test_what_has_no_number_says_so_and_is_drawn_where_it_belongs() -> None:
    """A half float ends at 65 504."""
    shown = show(preset="own", vertices="fixed", numbers="fixed")
    assert value(shown, "measured") < 0.1
    near = replace(START, lens=Perspective(1e-4, 4.0, 20.0))
    lost = show(near, preset="half")
    assert lost.vertices is not None and np.isfinite(lost.vertices.projected).all()
    away = replace(START, camera=Camera(START.camera.target, START.camera.eye))
    shown = show(away)
    assert "no vertex" in why(shown, "predicted") and shown.diagrams == ()
    assert shown.warning is not None


def test_the_diagram_has_each_format_at_its_bytes_and_its_error() -> None:
    for name in ("bits8", "bits12", "bits16"):
        shown = show(preset=name)
        (diagram,) = shown.diagrams
        (spot,) = (spot for spot in diagram.spots if spot.marked)
        assert spot.name == f"{name.removeprefix('bits')} bits"
        assert (spot.x, spot.y) == (value(shown, "bytes"), value(shown, "measured"))
        assert [value(show(preset="own", vertices=v), "measured") for v in ("bits8", "bits16")] == [
            spot.y for spot in diagram.spots if spot.name in ("8 bits", "16 bits")
        ] or name != "bits8"
