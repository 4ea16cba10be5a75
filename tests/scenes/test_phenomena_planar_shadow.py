"""Planar shadow: the matrix against rays in 40 digits, and what the rasteriser makes of its w."""

import math
from dataclasses import replace
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from app.model.clipping import clip_segments
from app.model.projection import (
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Illustration, Subject
from app.scenes.phenomena.planar_shadow import PHENOMENON, cast, shadow_matrix
from app.scenes.shapes import letter_f
from tests.oracles.illustrations import readings, showing

mp.mp.dps = 40

FACES = letter_f()[0].reshape(-1, 3)
SUBJECT = Subject((-1.5, 0.0, -0.5), (1.5, 5.0, 0.5), np.unique(FACES, axis=0))
OFF = "from there to the ray's end"
HIGH = "vertices not below the light"


show = showing(PHENOMENON, SUBJECT)


def value(illustration: Illustration, label: str) -> Any:
    return readings(illustration)[label]


def met(light: Any, height: float, place: Any) -> list[float]:
    """Where the line through light (homogeneous) and place meets y = height."""
    lx, ly, lz, lw = map(mp.mpf, map(float, light))
    x, y, z = map(mp.mpf, map(float, place))
    way = [lx - lw * x, ly - lw * y, lz - lw * z]  # from the place to the light
    t = (mp.mpf(height) - y) / way[1]
    return [float(x + t * way[0]), float(y + t * way[1]), float(z + t * way[2])]


def draw(rng: np.random.Generator) -> dict[str, Any]:
    height = float(-(10 ** rng.uniform(-2, 1)))
    x, z = rng.uniform(-9, 9, 2).tolist()
    return {
        "kind": ["point", "sun"][rng.integers(2)],
        "light": (x, float(rng.uniform(0.2, 12)), z),
        "height": [0.0, height][rng.integers(2)],
        "clip": bool(rng.integers(2)),
    }


def test_shadow_and_count_are_the_ray_s() -> None:
    rng = np.random.default_rng(5)
    seen = {"some": 0, "none": 0, "anti": 0}
    for _ in range(50):
        settings = draw(rng)
        illustration = show(**settings)
        sun, height = settings["kind"] == "sun", settings["height"]
        light = [*settings["light"], 0.0 if sun else 1.0]
        above = [p for p in SUBJECT.points if not sun and p[1] >= light[1]]
        assert value(illustration, HIGH) == len(above)
        place = value(illustration, "vertex P")
        if len(above) == len(SUBJECT.points):
            assert place is None
            continue
        assert place in [tuple(p) for p in SUBJECT.points.tolist()]
        assert sun or place[1] < light[1]
        expected = met(light, height, place)
        scale = max(map(abs, expected)) + 10
        assert value(illustration, "its shadow S·P / w") == pytest.approx(
            expected, abs=1e-13 * scale
        )
        assert value(illustration, OFF) <= 1e-13 * scale
        # The matrix as read casts every vertex below the light as its ray does.
        matrix = np.reshape(value(illustration, "S"), (4, 4))
        shadows = cast(matrix, SUBJECT.points)
        for point, shadow, w in zip(SUBJECT.points, shadows.places, shadows.w, strict=True):
            assert (w > 0.0) == (sun or point[1] < light[1])
            if w != 0.0:
                there = met(light, height, point)
                assert shadow == pytest.approx(there, abs=1e-12 * (max(map(abs, there)) + 10))
        assert np.linalg.matrix_rank(matrix) == 3
        shown, *anti = illustration.copies
        scaled = shown.world_from_world * (matrix[0, 0] / shown.world_from_world[0, 0])
        np.testing.assert_allclose(scaled, matrix, rtol=1e-14)
        assert shown.world_from_world[0, 0] > 0.0
        if above and not settings["clip"]:
            np.testing.assert_array_equal(anti[0].world_from_world, -shown.world_from_world)
            assert anti[0].panes == ("world", "ndc", "image")
            seen["anti"] += 1
        else:
            assert not anti
        seen["some" if above else "none"] += 1
    assert min(seen.values()) >= 3


@pytest.mark.parametrize("tenths", range(41))
def test_a_vertex_as_high_as_the_lamp_has_no_shadow_on_any_plane(tenths: int) -> None:
    for light_y in (1.0, 2.0, 4.0):
        illustration = show(kind="point", light=(-4.0, light_y, 3.0), height=-tenths / 10)
        assert value(illustration, HIGH) == np.count_nonzero(SUBJECT.points[:, 1] >= light_y)
        place, shadow = value(illustration, "vertex P"), value(illustration, "its shadow S·P / w")
        assert place[1] == light_y - 1.0  # the letter is made of cubes
        assert shadow == pytest.approx(met((-4.0, light_y, 3.0, 1.0), -tenths / 10, place))


@pytest.mark.parametrize("kind", ["point", "sun"])
def test_l19_s_matches_the_formula_beside_it(kind: str) -> None:
    """From the numbers in the sentence alone: (p L) I - L p^T."""
    light, height = (1.25, 2.125, -3.375), -2.5
    illustration = show(kind=kind, light=light, height=height)
    note = illustration.readings[0].note
    assert note is not None and "S = (p·L) I − L pᵀ" in note.template
    offset, *said = map(float, note.values)
    plane = np.array([0.0, 1.0, 0.0, offset])
    place = np.array([*said[:3], float(kind == "point")])
    expected = (plane @ place) * np.eye(4) - np.outer(place, plane)
    for row in range(4):
        assert value(illustration, "S")[4 * row : 4 * row + 4] == pytest.approx(
            expected[row], abs=1e-12
        )
    factor = said[3] if kind == "sun" else 1.0
    assert place[:3] * factor == pytest.approx(light, rel=1e-5)


def test_p_and_its_shadow_are_marked_where_the_picture_shows_them() -> None:
    """P is 12.3, its shadow 15.1 before the eye plane."""
    lens = PHENOMENON.start.lens
    for far, marks in ((24.0, 2), (13.0, 1), (9.0, 0)):
        illustration = show(replace(PHENOMENON.start, lens=replace(lens, far=far)))
        assert len(illustration.image.dots) == marks, far
        assert len(illustration.world.dots) == 3


def test_l19_by_hand() -> None:
    """The light at (0, 4, 0) over y = 0: (1, 2, 1) is half way up, its shadow twice as far."""
    matrix = shadow_matrix(np.array([0.0, 4.0, 0.0, 1.0]), 0.0)
    assert (matrix @ [1.0, 2.0, 1.0, 1.0]).tolist() == [4.0, 0.0, 4.0, 2.0]
    assert cast(matrix, np.array([[1.0, 2.0, 1.0]])).places.tolist() == [[2.0, 0.0, 2.0]]
    # At 6, higher than the light: on the other side, with w = -2.
    high = cast(matrix, np.array([[1.0, 6.0, 1.0]]))
    assert (high.places.tolist(), high.w.tolist()) == ([[-2.0, 0.0, -2.0]], [-2.0])
    # The sun in the direction (1, 2, 0): a point 4 high is moved 2 to the left; w stays 1.
    illustration = show(kind="sun", light=(1.0, 2.0, 0.0))
    assert value(illustration, "S")[:4] == (1.0, -0.5, 0.0, 0.0)
    assert value(illustration, "S")[12:] == (0.0, 0.0, 0.0, 1.0)
    # What is just as high as the light has no shadow either: the letter's top, 8 vertices.
    assert value(show(light=(4.0, 5.0, 0.0)), HIGH) == np.sum(SUBJECT.points[:, 1] == 5.0) == 8
    # The sun's distance has no meaning.
    assert value(show(kind="sun", light=(1e-320, 2e-320, 0.0)), "S")[:2] == pytest.approx(
        (1.0, -0.5), rel=1e-3
    )


@pytest.mark.parametrize(
    ("lens", "depth"),
    [
        (Perspective(60.0, 0.5, 30.0), "opengl"),
        (Perspective(100.0, 0.5, math.inf), "reversed"),
        (Frustum(-0.3, 0.9, -0.7, 0.2, 0.8, 40.0), "direct3d"),
        (Orthographic(-9.0, 9.0, -9.0, 9.0, 1.0, 40.0), "opengl"),
        (Oblique(-9.0, 9.0, -9.0, 9.0, 1.0, 40.0), "direct3d"),
    ],
)
def test_the_gpu_cuts_the_anti_shadow_off_and_minus_s_lets_it_through(
    lens: Lens, depth: Any
) -> None:
    """Under S a point is in the volume if it has a shadow that is seen; under -S the rest is.

    What is above the light and has its image behind the eye has w > 0 again, beyond the far plane.
    """
    rng = np.random.default_rng(6)
    drawn = {True: 0, False: 0}
    for _ in range(20):
        eye = rng.uniform((-9, 1, -9), (9, 9, 9))
        projection = Projection(Camera(tuple(eye), (0.0, 1.0, 0.0)), lens, (1280, 720), depth)
        light = np.array([*rng.uniform((-3, 1, -3), (3, 6, 3)), 1.0])
        matrix = shadow_matrix(light, 0.0)
        points = rng.uniform((-2, 0, -2), (2, 8, 2), (200, 3))
        shadows = cast(matrix, points)
        seen = ~projection.trace(shadows.places).outside.any(axis=1)
        for sign in (1.0, -1.0):
            clip = np.column_stack([points, np.ones(200)]) @ (sign * matrix).T
            clip = clip @ projection.clip_from_world.T
            inside = ~clip_segments(clip, clip, depth).outside.any(axis=1)
            assert (inside == (seen & (sign * shadows.w > 0.0))).all()
            drawn[sign > 0.0] += int(inside.sum())
    assert min(drawn.values()) > 50


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        ({"light": (1, 0, 1)}, r"settings\.light = \(1, 0, 1\): must lie above the plane y = 0"),
        ({"light": (1, -3, 1), "height": -2}, r"settings\.light .* above the plane y = -2"),
        (
            {"kind": "sun", "light": (1, 0, 1)},
            r"settings\.light = \(1, 0, 1\): .* never meet the plane",
        ),
        ({"kind": "sun", "light": (1, -1, 1)}, r"settings\.light .* must point upward"),
        ({"kind": "sun", "light": (0, 0, 0)}, r"settings\.light .* zero vector"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(settings: dict[str, Any], said: str) -> None:
    with pytest.raises(Refusal, match=said):
        PHENOMENON.checked(settings)


def test_a_light_in_the_object_or_under_all_of_it_says_so() -> None:
    assert show().warning is None
    inside = show(light=(0.5, 2.0, 0.1)).warning
    assert inside is not None and "inside" in inside.template
    on_its_side = show(light=(1.5, 2.0, 0.1)).warning
    assert on_its_side is not None
    illustration = show(light=(4.0, -0.5, 0.0), height=-1.0)
    assert illustration.warning is not None and "every vertex" in illustration.warning.template
    assert value(illustration, OFF) is None
    assert value(illustration, HIGH) == len(SUBJECT.points)


def test_far_lights_are_read_as_exactly_as_near_ones() -> None:
    illustration = show(light=(1e100, 1e100, -1e100))
    assert value(illustration, OFF) <= 1e-14
    # As the sun in the same direction.
    sun = show(kind="sun", light=(1.0, 1.0, -1.0))
    shadow = value(sun, "its shadow S·P / w")
    assert value(illustration, "its shadow S·P / w") == pytest.approx(shadow, abs=1e-14)


@pytest.mark.parametrize(("height", "written"), [(0.0, "L_y = 9"), (-2.0, "L_y − h = 11")])
def test_how_high_the_lamp_is_stands_at_its_plumb_line(height: float, written: str) -> None:
    world = show(light=(-4.0, 9.0, 3.0), height=height).world
    (text,) = (text for text in world.texts if text.text.startswith("L_y"))
    assert text.text == written and text.point.tolist() == [-4.0, (9.0 + height) / 2.0, 3.0]
    plumb = [[-4.0, 9.0, 3.0], [-4.0, height, 3.0]]
    assert plumb in [line.points.tolist() for line in world.lines]
    # The sun's height is its angle; 3, 4, 5: the sine is 0.8.
    texts = [text.text for text in show(kind="sun", light=(3.0, 4.0, 0.0)).world.texts]
    assert "53.13°" in texts and not any(text.startswith("L_y") for text in texts)
