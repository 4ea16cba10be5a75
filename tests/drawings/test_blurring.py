"""The blurred picture of a lens with an opening: what is sharp in it, and how it becomes finer."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app.drawings import WORDS
from app.drawings.blurring import FIRST, MOST, spread
from app.drawings.image import ImageDrawing
from app.drawings.picture_frame import UNFRAMED
from app.drawings.style import LIGHT, rgb
from app.model.projection import Camera, Projection
from app.scenes.phenomena.focus import PHENOMENON
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import load
from tests.support.drawings import MakeScreen, Pixels, figure_of

SCENE, START = load("focus"), PHENOMENON.start
SIDE = replace(START, image_size=(640, 360))


def shown(projection: Projection = SIDE, **settings: float) -> Illustration:
    return PHENOMENON.illustration(projection, PHENOMENON.checked(settings), SCENE.subject)


def edge_px(pixels: Pixels, post: float, x: float) -> int:
    """How many rows the upper edge of a post's face is high: neither paper nor face."""
    place = SIDE.trace((x, 1.4, 0.15 - post)).image
    column = pixels[round(place[1]) - 12 : round(place[1]) + 12, round(place[0]), 0].astype(float)
    paper, face = column[0], column[-1]
    assert paper == 255.0 > face + 100.0
    return int(((column < 0.95 * paper + 0.05 * face) & (abs(column - face) > 3.0)).sum())


def figure(**settings: float) -> Pixels:
    """The picture, without an outline round any post."""
    return figure_of(SCENE, SIDE, ("image",), settings={"confusion": 1e-6, **settings}).pixels()


def test_the_focused_post_stays_sharp_and_the_others_edges_are_as_wide_as_their_discs() -> None:
    wide, small = figure(aperture=1.0), figure(aperture=64.0)
    corners = PHENOMENON.geometry()[0][0].reshape(-1, 3)
    tops = corners[corners[:, 1] == 1.4]
    places = {post: tops[np.isclose(tops[:, 2], 0.15 - post), 0].mean() for post in (2, 5, 20)}
    opening = 2.0 * shown(aperture=1.0, focus=5.0).rendering.aperture.radius  # type: ignore[union-attr]
    px_per_m = 360.0 / (2.0 * 5.0 * math.tan(math.radians(14.0)))
    for post, x in places.items():
        disc = opening * abs(1.0 - 5.0 / (post - 0.15)) * px_per_m
        assert edge_px(small, post, x) <= 4
        assert edge_px(wide, post, x) == pytest.approx(disc, abs=4.0)
    assert edge_px(wide, 2, places[2]) >= 8


def test_the_average_has_no_dark_rim_where_the_paper_is_transparent() -> None:
    pixels = figure_of(
        SCENE, SIDE, ("image",), settings={"aperture": 1.0}, transparent=True
    ).pixels()
    solid = figure_of(SCENE, SIDE, ("image",), settings={"aperture": 1.0}).pixels()
    alpha = pixels[..., 3:] / 255.0
    assert 0.0 == alpha.min() < alpha.max() == 1.0
    assert ((alpha > 0.2) & (alpha < 0.8)).sum() > 1000
    on_paper = pixels[..., :3] * alpha + 255.0 * (1.0 - alpha)
    assert abs(on_paper - solid).mean() < 1.0


def test_a_picture_is_sharp_at_first_and_becomes_finer_until_another_one_is_shown(
    off_screen: MakeScreen,
) -> None:
    screen = off_screen(640, 360)
    drawing = ImageDrawing(screen, SCENE, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_projection(SIDE, shown(aperture=0.5))
    sharp = screen.pixels()
    assert drawing.is_coarse
    drawing.refine()
    coarse = screen.pixels()
    assert not np.array_equal(coarse, sharp) and drawing.is_coarse
    steps = 1
    while drawing.is_coarse:
        drawing.refine()
        steps += 1
        assert steps <= MOST
    fine = screen.pixels()
    assert not np.array_equal(fine, coarse)
    # The circle of confusion changes marks and nothing else.
    drawing.show_projection(SIDE, shown(aperture=0.5, confusion=0.2))
    assert not drawing.is_coarse
    other = replace(SIDE, camera=Camera((0.1, 1.3, 0.0), (0.0, 1.0, -5.0)))
    drawing.show_projection(other, shown(other, aperture=0.5))
    assert drawing.is_coarse
    at_once = screen.pixels()
    drawing.remove()
    again = ImageDrawing(screen, SCENE, WORDS, LIGHT, options=UNFRAMED)
    again.show_projection(other, shown(other, aperture=0.5))
    assert np.array_equal(at_once, screen.pixels())


def test_the_layers_of_the_picture_are_those_of_its_average(off_screen: MakeScreen) -> None:
    def lines_px(hidden: frozenset[str]) -> int:
        screen = off_screen(640, 360)
        drawing = ImageDrawing(screen, SCENE, WORDS, LIGHT, options=UNFRAMED)
        drawing.show_projection(SIDE, shown())
        drawing.refine(whole=True)
        drawing.show_layers(hidden)
        drawing.show_projection(SIDE, shown())
        drawing.refine(whole=True)
        found = int((abs(screen.pixels()[300:] / 255.0 - rgb(LIGHT.background)) > 0.02).sum())
        drawing.remove()
        return found

    assert lines_px(frozenset({"grid"})) < lines_px(frozenset())


def test_every_beginning_of_the_points_is_spread_over_the_opening() -> None:
    points = spread(MOST)
    assert (np.hypot(*points[:, :2].T) <= 1.0).all() and (abs(points[:, 2:]) <= 0.5).all()
    for count in (FIRST, 16, MOST):
        some = points[:count]
        assert (abs(some.mean(axis=0)) < 1.3 / count).all()
        assert len({(x > 0.0, y > 0.0) for x, y in some[:, :2].tolist()}) == 4
