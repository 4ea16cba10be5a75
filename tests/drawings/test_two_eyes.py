"""The picture of two eyes: what each glass shows, and where each half comes from."""

from dataclasses import replace

import numpy as np
import pytest

from app.drawings import WORDS
from app.drawings.image import ImageDrawing
from app.drawings.picture_frame import UNFRAMED
from app.drawings.style import LIGHT
from app.model.projection import Projection
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import load
from tests.support.drawings import MakeScreen, Pixels, figure_of

SCENE = load("two-eyes")
SIZE = 640, 360
START = replace(SCENE.start, image_size=SIZE)
LUMA = np.array([0.2126, 0.7152, 0.0722])


def illustration(projection: Projection = START, **settings: str | float) -> Illustration:
    shown = SCENE.illustration(projection, {"point": (0.0, 90.0, 0.0), **settings})  # out of sight
    assert shown is not None
    return shown


def picture(pictures: str, **settings: str | float) -> Pixels:
    given = {"point": (0.0, 90.0, 0.0), "pictures": pictures, **settings}
    view = replace(figure_of(SCENE).document.view, names=())
    return figure_of(SCENE, START, ("image",), SIZE, view=view, settings=given).pixels()


def of_eye(side: str, **settings: str | float) -> Pixels:
    """What one eye sees, drawn as the picture of another scene."""
    rendering = illustration(**settings).rendering
    assert rendering is not None and rendering.eyes is not None
    seen = getattr(rendering.eyes, side)
    plain = replace(SCENE, phenomenon=None)
    return figure_of(plain, seen, ("image",), SIZE).pixels()


@pytest.mark.parametrize("cameras", ["off-axis", "toed-in"])
def test_each_half_is_the_middle_of_its_eye_s_picture(cameras: str) -> None:
    left, right = (of_eye(side, cameras=cameras) for side in ("left", "right"))
    middles = left[:, 160:480], right[:, 160:480]
    for pictures, halves in (("beside", middles), ("crossed", middles[::-1])):
        drawn = picture(pictures, cameras=cameras)
        for half, whole in zip((drawn[:, :318], drawn[:, 322:]), halves, strict=True):
            inner = whole[:, :318] if np.shares_memory(half, drawn[:, :318]) else whole[:, 2:]
            apart = abs(half.astype(float) - inner).max(axis=2)
            assert (apart > 60.0).mean() < 0.01  # edges are smoothed in another way
            assert apart.mean() < 2.0
    assert abs(picture("beside", cameras=cameras).astype(float) - left).mean() > 10.0


def test_red_glass_shows_the_left_eye_s_picture_and_cyan_glass_the_right_one() -> None:
    drawn = picture("red-cyan").astype(float)
    assert (drawn[..., 1] == drawn[..., 2]).all()
    for channel, side in ((0, "left"), (1, "right")):
        grey = of_eye(side) @ LUMA
        assert abs(drawn[..., channel] - grey).mean() < 2.0
        other = of_eye("right" if side == "left" else "left") @ LUMA
        assert abs(drawn[..., channel] - other).mean() > 5.0
    # On white paper, what the left eye alone sees has no red light left: it is cyan.
    left, right = of_eye("left") @ LUMA, of_eye("right") @ LUMA
    alone = (left < 150.0) & (right > 250.0)
    assert alone.sum() > 500
    red, green, _ = drawn[alone].mean(axis=0)
    assert red < 170.0 < 245.0 < green


def test_the_front_in_the_screen_plane_is_grey_and_the_cube_before_it_is_not() -> None:
    drawn = picture("red-cyan").astype(float)
    x, y = START.trace((-1.3, 0.4, 0.0)).image.round().astype(int)
    assert np.ptp(drawn[y, x]) < 2.0  # on the front of the letter, at its left side
    colour = np.ptp(drawn, axis=2)
    (low, _), (high, _) = START.trace([(0.1, 0.4, 3.0), (1.1, 0.4, 3.0)]).image.round().astype(int)
    row = int(START.trace((0.6, 0.4, 3.0)).image[1])
    assert (colour[row, low - 14 : high + 14] > 60.0).any()


def test_a_pair_is_drawn_at_once_and_becomes_smoother(off_screen: MakeScreen) -> None:
    screen = off_screen(*SIZE)
    drawing = ImageDrawing(screen, SCENE, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_projection(START, illustration())
    first = screen.pixels()
    assert drawing.is_coarse and abs(first[:, 330:] - first[:, 10:320]).max() > 50
    steps = 0
    while drawing.is_coarse:
        drawing.refine()
        steps += 1
        assert steps < 20
    fine = screen.pixels()
    assert not np.array_equal(first, fine)
    # A step shows the next pair at once, and neither the last one nor the camera's own picture.
    drawing.show_projection(START, illustration(separation=1.6))
    again = screen.pixels()
    drawing.remove()
    fresh = ImageDrawing(screen, SCENE, WORDS, LIGHT, options=UNFRAMED)
    fresh.show_projection(START, illustration(separation=1.6))
    assert np.array_equal(again, screen.pixels())
    assert fresh.image_pixel(100.0, 100.0) is None  # of which picture?
    fresh.remove()


def test_a_pane_of_another_size_shows_the_same_pair_until_it_is_drawn(
    off_screen: MakeScreen,
) -> None:
    screen = off_screen(*SIZE)
    drawing = ImageDrawing(screen, SCENE, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_projection(START, illustration())
    screen.pixels()
    screen.render_window.SetSize(480, 270)
    drawing.state.canvas.relayout()
    stretched = screen.pixels()
    assert drawing.is_coarse
    drawing.refine()
    assert abs(screen.pixels().astype(float) - stretched).mean() < 6.0
    drawing.remove()


def test_a_parallel_lens_has_one_picture(off_screen: MakeScreen) -> None:
    screen = off_screen(*SIZE)
    drawing = ImageDrawing(screen, SCENE, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_projection(START, illustration())
    parallel = START.with_lens("orthographic")
    drawing.show_projection(parallel, illustration(parallel))
    assert not drawing.is_coarse and drawing.image_pixel(100.0, 100.0) is not None
    drawing.remove()


def test_a_transparent_pair_lies_on_white_paper_as_the_solid_one() -> None:
    given = {"point": (0.0, 90.0, 0.0)}
    for pictures in ("beside", "red-cyan"):
        settings = {**given, "pictures": pictures}
        how = (SCENE, START, ("image",), SIZE)
        solid = figure_of(*how, settings=settings).pixels()
        clear = figure_of(*how, settings=settings, transparent=True).pixels()
        alpha = clear[..., 3:] / 255.0
        assert abs(clear[..., :3] * alpha + 255.0 * (1.0 - alpha) - solid).mean() < 1.0
        assert (alpha.min() == 0.0) == (pictures == "beside")
