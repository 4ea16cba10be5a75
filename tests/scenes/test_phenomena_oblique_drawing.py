"""Oblique drawing: scale and angle as drawn, against the projectors' slant (lecture 002)."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from app.lecture.letters import in_letters
from app.model.projection import Camera, Oblique, Orbit, Projection
from app.scenes.phenomena.oblique_drawing import PHENOMENON, oblique
from tests.oracles.exact import cotangent_deg, mp
from tests.oracles.illustrations import random_projection, reading, showing, subject_of, value, why

SUBJECT = subject_of(PHENOMENON)


shown = showing(PHENOMENON, SUBJECT)


def followed(projection: Projection, **settings: object) -> Projection:
    return PHENOMENON.follow(projection, PHENOMENON.checked({}), PHENOMENON.checked(settings))


def angle_between(one_deg: float, other_deg: float) -> float:
    return abs(math.remainder(one_deg - other_deg, 360.0))


def test_what_is_drawn_is_what_was_set_for_fifty_random_drawings() -> None:
    """With any camera and any image."""
    dice = random.Random(10)
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        if dice.random() < 0.5:
            seen = seen.with_lens("orthographic")
            left, right, bottom, top = seen.window
            wider = {"left": left, "right": 2 * right - left, "bottom": bottom, "top": top}
            seen = replace(seen, lens=replace(seen.lens, keep="y", **wider))
        scale, angle_deg, morph = dice.uniform(0, 2), dice.uniform(-180, 180), dice.uniform(0.1, 1)
        seen = followed(seen, drawing="free", receding=scale, angle_deg=angle_deg, morph=morph)
        illustration = shown(seen)
        assert value(illustration, "receding scale") == pytest.approx(scale * morph, abs=1e-9)
        drawn_deg = value(illustration, "receding angle")
        assert angle_between(drawn_deg, angle_deg) * scale * morph < 1e-7
        # And that is what the angles of the projectors give, with 80 digits.
        lens = seen.lens
        assert isinstance(lens, Oblique)
        x, y = -cotangent_deg(lens.alpha_deg), -cotangent_deg(lens.beta_deg)
        assert value(illustration, "√") == pytest.approx(float(mp.sqrt(x * x + y * y)), rel=1e-12)
        assert value(illustration, "√") == pytest.approx(scale * morph, rel=1e-12)
        formula_deg = float(mp.atan2(y, x) * 180 / mp.pi)
        assert angle_between(value(illustration, "atan2"), formula_deg) < 1e-9
        assert angle_between(drawn_deg, formula_deg) * scale * morph < 1e-7


def test_the_world_names_the_receding_scale_alone_and_the_image_all_three() -> None:
    illustration = shown(PHENOMENON.start)
    scales = {"scale_u", "scale_v", "scale_n"}
    assert {text.name for text in illustration.world.texts} & scales == {"scale_n"}
    assert {text.name for text in illustration.image.texts} == scales


def test_a_stretched_picture_is_measured_in_its_pixels_and_said_to_be_stretched() -> None:
    """A window of 4 by 4 units fills images that are not square: y has its own px a unit."""
    dice = random.Random(11)
    for stretch in (0.25, 8 / 9, 1.0, 3.0):
        scale, angle_deg = dice.uniform(0.1, 2), dice.uniform(-180, 180)
        lens = replace(PHENOMENON.start.lens, left=-2.0, right=2.0, bottom=-2.0, top=2.0)
        lens = replace(lens, keep="stretch")
        seen = replace(PHENOMENON.start, lens=lens, image_size=(720, round(720 * stretch)))
        seen = followed(seen, drawing="free", receding=scale, angle_deg=angle_deg)
        illustration = shown(seen)
        turned = math.radians(angle_deg)
        x, y = scale * math.cos(turned), stretch * scale * math.sin(turned)
        drawn = value(illustration, "receding scale"), value(illustration, "receding angle")
        assert drawn[0] == pytest.approx(math.hypot(x, y), rel=1e-9)
        assert angle_between(drawn[1], math.degrees(math.atan2(y, x))) < 1e-7
        note = reading(illustration, "receding scale").note
        assert (None if note is None else note.values) == (
            None if stretch == 1.0 else pytest.approx((stretch,))
        )
        plates = {in_letters(text.text, "own") for text in illustration.world.texts}
        both = {"u: 1 \N{MULTIPLICATION SIGN}", f"v: {stretch:.3g} \N{MULTIPLICATION SIGN}"}
        assert plates & both == (set() if stretch == 1.0 else both)
        before = reading(illustration, "√").note
        assert (before is None) == (note is None)
        # And on the pixels themselves.
        front, back = seen.trace([(1, 0, 1), (1, 0, -1)]).image
        across, down = back - front
        assert angle_between(drawn[1], math.degrees(math.atan2(-down, across))) < 1e-7


@pytest.mark.parametrize(
    ("name", "scale", "angle_deg"),
    [
        *(("cavalier", 1.0, angle_deg) for angle_deg in (45.0, 135.0, -90.0)),
        *(("cabinet", 0.5, angle_deg) for angle_deg in (30.0, 63.43494882292201, 0.0)),
    ],
)
def test_the_textbooks_drawings(name: str, scale: float, angle_deg: float) -> None:
    """The cube's edges, by hand: 2 units along u are 2 k px, along n 2 k times the scale."""
    seen = followed(PHENOMENON.start, drawing=name, angle_deg=angle_deg)
    illustration = shown(seen)
    assert value(illustration, "receding scale") == pytest.approx(scale, rel=1e-12)
    assert angle_between(value(illustration, "receding angle"), angle_deg) < 1e-10
    front, right, back = seen.trace([(1, 0, 1), (-1, 0, 1), (1, 0, -1)]).image
    k = 720 / 4.2  # the window is 4.2 high
    assert front - right == pytest.approx([2 * k, 0.0], abs=1e-9)
    turned = math.radians(angle_deg)
    recede = 2 * k * scale * np.array([math.cos(turned), -math.sin(turned)])
    assert back - front == pytest.approx(recede, abs=1e-9)


def test_the_free_scale_counts_in_the_free_drawing_only() -> None:
    assert followed(PHENOMENON.start, receding=1.7) == PHENOMENON.start
    freed = followed(PHENOMENON.start, drawing="free", receding=1.7)
    assert value(shown(freed), "receding scale") == pytest.approx(1.7, rel=1e-12)


def test_the_morph_starts_at_the_orthographic_drawing() -> None:
    straight = followed(PHENOMENON.start, morph=0.0)
    assert straight.lens.shear == (0.0, 0.0)
    orthographic = PHENOMENON.start.with_lens("orthographic")
    points = SUBJECT.points
    assert np.allclose(straight.trace(points).image, orthographic.trace(points).image, atol=1e-9)
    assert why(shown(straight), "receding angle")
    assert value(shown(straight), "receding scale") == pytest.approx(0.0, abs=1e-12)
    # On the way every point goes straight and evenly.
    half = followed(PHENOMENON.start, morph=0.5).trace(points).image
    whole = PHENOMENON.start.trace(points).image
    assert np.allclose(half, (straight.trace(points).image + whole) / 2, atol=1e-9)


def test_that_no_scale_can_be_read_has_its_own_reason() -> None:
    start = PHENOMENON.start
    tiny = replace(start, camera=replace(start.camera, eye=(1e15, 1e15, 1e15)))
    for projection, said in (
        (start.with_lens("perspective"), "choose the oblique lens"),
        (replace(tiny, lens=Oblique(-1e60, 1e60, -1e60, 1e60)), "too many or too few"),
    ):
        found = reading(shown(projection), "receding scale")
        assert found.value is None and found.note is not None and said in found.note.template


@pytest.mark.parametrize("scale", [1e-9, 1e-3, 1e3, 1e6, 1e9, 1e11, 1e13])
def test_a_window_of_any_size_stretches_nothing(scale: float) -> None:
    """A cavalier's edges have the scale 1 to four digits, or are too short to be measured."""
    lens = PHENOMENON.start.lens
    sides = {side: scale * getattr(lens, side) for side in ("left", "right", "bottom", "top")}
    found = reading(shown(replace(PHENOMENON.start, lens=replace(lens, **sides))), "receding scale")
    if found.value is None:
        assert scale > 1e6 and found.note is not None and "too few" in found.note.template
    else:
        assert found.note is None and found.value == pytest.approx(1.0, abs=5e-5)


def test_an_orthographic_lens_draws_receding_edges_with_no_length_at_all() -> None:
    dice = random.Random(13)
    for _ in range(100):
        eye, target = (tuple(round(dice.uniform(-9, 9), 1) for _ in range(3)) for _ in range(2))
        seen = replace(PHENOMENON.start, camera=Camera(eye, target)).with_lens("orthographic")
        assert value(shown(seen), "receding scale") == 0.0


def test_the_plane_through_the_target_stays() -> None:
    plane = np.array([(x, y, 0.0) for x in (-1.0, 1.0) for y in (0.0, 2.0)])
    image = PHENOMENON.start.trace(plane).image
    seen = PHENOMENON.start
    for scale, angle_deg in ((0.5, 30.0), (2.0, 200.0), (0.0, 0.0), (1.0, 45.0)):
        seen = oblique(seen, scale, angle_deg)
        assert np.allclose(seen.trace(plane).image, image, atol=1e-9)
    assert seen.window == pytest.approx(PHENOMENON.start.window, rel=1e-12)


def test_projectors_end_where_the_picture_has_their_points() -> None:
    seen = followed(
        replace(PHENOMENON.start, camera=Camera.from_orbit((0, 1, 0), Orbit(20.0, 15.0, 8.0))),
        angle_deg=30.0,
    )
    illustration = shown(seen)
    lines = illustration.world.lines
    projectors = [line.points for line in lines if line.colour == "accent" and not line.name]
    assert len(projectors) == 8
    for corner, foot in projectors:
        trace = seen.trace([corner, foot])
        assert trace.image[0] == pytest.approx(trace.image[1], abs=1e-9)
        assert trace.view[1, 2] == pytest.approx(-seen.lens.near, abs=1e-12)


def test_no_scale_is_written_where_there_is_none() -> None:
    written = {in_letters(text.text, "own") for text in shown(PHENOMENON.start).image.texts}
    assert "u: 1 \N{MULTIPLICATION SIGN}" in written
    illustration = shown(PHENOMENON.start.with_lens("perspective"))
    assert illustration.warning is not None
    assert {in_letters(text.text, "own") for text in illustration.world.texts} == {"u", "v", "n"}
    assert not any("1 " in text.text for text in illustration.image.texts)


@pytest.mark.parametrize("angle_deg", [30.0, -45.0, 135.0, 180.0])
def test_the_measured_edges_have_room_for_their_names(angle_deg: float) -> None:
    """The rightmost edge along v is marked, and the name of u stands at the end of its edge."""
    seen = followed(PHENOMENON.start, drawing="cabinet", angle_deg=angle_deg)
    # The middle of the marked edge, 2 units high, is at y = 1.
    (place,) = (text.point for text in shown(seen).image.texts if text.text.startswith("{axis_v}"))
    at_one = seen.trace([(x, 1.0, z) for x in (-1.0, 1.0) for z in (-1.0, 1.0)]).image
    assert place == pytest.approx(at_one[at_one[:, 0].argmax()])
    (place,) = (text.point for text in shown(seen).image.texts if text.text.startswith("{axis_u}"))
    assert place == pytest.approx(seen.trace((-1.0, 0.0, 1.0)).image)


def test_alpha_is_the_angle_between_the_near_plane_and_a_projector() -> None:
    """002: x' = x - (z_n - z) cot(alpha); 1 behind the plane at 45 degrees moves it by 1."""
    projection = oblique(PHENOMENON.start, 1.0, 0.0)
    marks = shown(projection).world
    texts = {text.name: text for text in marks.texts}
    u, _, n = projection.camera.frame
    way = texts["x"].point - texts["x'"].point
    between = math.degrees(math.atan2(-way @ n, way @ u))
    assert between == pytest.approx(float(projection.lens.alpha_deg))
    (arc,) = [line.points for line in marks.lines if line.name == "alpha"]
    ends = (arc[[0, -1]] - texts["x'"].point) / np.linalg.norm(arc[0] - texts["x'"].point)
    assert ends[0] == pytest.approx(u) and ends[1] == pytest.approx(way / np.linalg.norm(way))
