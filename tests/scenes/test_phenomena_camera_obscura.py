"""Camera obscura: h' against h, d and z by hand, both films' signs, and what has no picture."""

from dataclasses import replace

import mpmath as mp
import numpy as np
import pytest

from app.model.projection import Camera, Frustum, Orbit, Perspective
from app.scenes.phenomena.camera_obscura import PHENOMENON
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.similar_triangles import onto_plane
from tests.oracles.illustrations import reading, showing, subject_of, value

START, SUBJECT = PHENOMENON.start, subject_of(PHENOMENON)
show = showing(PHENOMENON, SUBJECT)


def heights_read(illustration: Illustration) -> tuple[float, float]:
    return value(illustration, "on the film"), value(illustration, "film in front")


@pytest.mark.parametrize("d", [0.5, 1.0, 4.0, 8.0])
@pytest.mark.parametrize("z", [4.5, 9.0, 12.0])
def test_l21_the_image_is_d_h_over_z_high_upside_down_and_upright(d: float, z: float) -> None:
    """h = 5, the letter's; its middle, beside which the arrow stands, is at the target."""
    camera = Camera((0.5, 2.5, z), (0.5, 2.5, 0.0))
    seen = replace(START, camera=camera, lens=Perspective(40.0, d, 30.0))
    illustration = show(seen)
    true = float(mp.mpf(d) * 5 / mp.mpf(z))
    assert heights_read(illustration) == pytest.approx((-true, true), rel=1e-14)
    assert value(illustration, "height h") == pytest.approx(5.0, rel=1e-15)
    assert value(illustration, "distance z") == z
    assert illustration.measured == (("d", d), ("z", z))


def test_l21_it_holds_wherever_the_camera_stands_and_off_its_axis() -> None:
    for number, orbit in enumerate([Orbit(40.0, 25.0, 9.0), Orbit(-100.0, 5.0, 20.0, 30.0)]):
        camera = Camera.from_orbit((0.5, 2.5, 0.0), orbit)
        lens = (Perspective(30.0, 1.5, 40.0), Frustum(-0.2, 1.0, -0.7, 0.4, 1.5, 40.0))[number]
        found = show(replace(START, camera=camera, lens=lens))
        true = 1.5 * value(found, "height h") / value(found, "distance z")
        assert heights_read(found) == pytest.approx((-true, true), rel=1e-13)


def test_l21_the_film_s_picture_is_the_synthetic_one_turned_by_a_half() -> None:
    """The eye stands between the two: (x, y) on the one is (-x, -y) on the other."""
    points = np.column_stack([SUBJECT.points, np.ones(len(SUBJECT.points))])
    behind, in_front = (points @ onto_plane(START, d).T for d in (-4.0, 4.0))
    eye = np.array(START.camera.eye)
    offsets = [part[:, :3] / part[:, 3:] - eye for part in (behind, in_front)]
    assert offsets[0] == pytest.approx(-offsets[1], abs=1e-13)
    assert offsets[0][:, 2] == pytest.approx(4.0) and offsets[1][:, 2] == pytest.approx(-4.0)
    (copy,) = show().copies
    film = points @ copy.world_from_world.T
    on_film = film[:, :3] / film[:, 3:] - eye
    assert on_film[:, :2] == pytest.approx(offsets[0][:, :2], abs=0.02)  # lifted off it a little


def test_l21_each_ray_goes_through_the_hole_and_ends_in_the_images_ends() -> None:
    marks = show().world
    rays = [line.points for line in marks.lines if line.colour == "accent" and line.width == 1.0]
    arrow, film, front = (line.points for line in marks.lines if line.width == 3.0)
    eye = np.array(START.camera.eye)
    for end, (start, stop) in enumerate(rays):
        assert start == pytest.approx(arrow[end]) and stop == pytest.approx(film[end])
        for other in (stop, front[end]):
            assert np.cross(start - eye, other - eye) == pytest.approx(0.0, abs=1e-12)
    assert film[1, 1] < film[0, 1] and front[1, 1] > front[0, 1]
    assert film[1, 1] - film[0, 1] == pytest.approx(-4.0 * 5.0 / 9.0)


def test_l21_the_film_s_distance_is_near_and_goes_with_it() -> None:
    chosen = PHENOMENON.checked({"distance": 2.0})
    projection, settings = PHENOMENON.changed(START, PHENOMENON.checked({}), {"distance": 2.0})
    assert projection == replace(START, lens=replace(START.lens, near=2.0))
    assert settings == chosen
    nearer = replace(START, lens=replace(START.lens, near=1.25))
    assert PHENOMENON.at_hand(nearer, PHENOMENON.checked({}))["distance"] == 1.25


def test_l21_there_is_no_image_behind_the_hole_or_with_a_parallel_lens() -> None:
    away = replace(START, camera=Camera((0.5, 2.5, 9.0), (0.5, 2.5, 18.0)))
    illustration = show(away)
    note = reading(illustration, "on the film").note
    assert reading(illustration, "on the film").value is None
    assert note is not None and "behind the hole" in note.template
    assert len([line for line in illustration.world.lines if line.width == 3.0]) == 0
    parallel = START.with_lens("orthographic")
    warning = show(parallel).warning
    assert warning is not None and "parallel lens" in warning.template
    back, _ = PHENOMENON.changed(parallel, PHENOMENON.checked({}), {"distance": 2.0})
    assert back.lens.central and back.lens.near == 2.0
