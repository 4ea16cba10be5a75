"""What a scene leaves out of the world, and from where the world is seen."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.commands.arguments import document_of
from app.drawings import WORDS
from app.drawings.frame import BODY_BOX
from app.drawings.image import ImageDrawing
from app.drawings.stage import StageDrawing
from app.drawings.stage_box import BODY
from app.drawings.style import LIGHT, rgb
from app.drawings.world import WorldDrawing
from app.lecture.stages import VIEW, WORLD
from app.model.projection import Camera, Perspective
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import BUILT_IN, load
from tests.support.drawings import MakeScreen, Pixels, illustrated

SIZE = 580, 600
EVERYTHING_OUT = [name for name, each in PHENOMENA.items() if "frustum" in each.leaves_out]


def opened(screen: Any, name: str) -> WorldDrawing:
    scene = load(name)
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_projection(scene.start, None if scene.phenomenon is None else illustrated(scene))
    return drawing


def share(pixels: Pixels, colour: str, paper: float = 0.0) -> float:
    """The share of pixels in a colour that has so much paper in it."""
    mixed = (1.0 - paper) * np.array(rgb(colour)) + paper * np.array(rgb(LIGHT.background))
    return float((abs(pixels / 255.0 - mixed) < 0.02).all(axis=2).mean())


@pytest.mark.parametrize("name", EVERYTHING_OUT)
def test_the_frustum_is_left_out_until_one_of_its_planes_is_named(
    off_screen: MakeScreen, name: str
) -> None:
    screen = off_screen(*SIZE)
    drawing = opened(screen, name)
    without = screen.pixels()
    named = load(name).names
    drawing.show_names(frozenset({*named, "far"}))
    with_far = screen.pixels()
    drawing.show_names(frozenset(named))
    assert np.array_equal(screen.pixels(), without)
    assert not np.array_equal(with_far, without)
    drawing.show_names(None)
    everything = screen.pixels()
    assert not np.array_equal(everything, without)


def test_without_the_frustum_the_subject_is_larger(off_screen: MakeScreen) -> None:
    screen = off_screen(*SIZE)
    drawing = opened(screen, "camera-obscura")
    blue = "#56b4e9"
    large = share(screen.pixels(), blue)
    drawing.show_names(frozenset({"near", "far"}))
    assert large > 1.5 * share(screen.pixels(), blue) > 0.0


@pytest.mark.parametrize("fixed", ["", "top", "side"])
def test_a_subject_much_longer_than_the_frustum_may_leave_the_pane(
    off_screen: MakeScreen, fixed: str
) -> None:
    drawing = opened(off_screen(*SIZE), "far-plane-popping")
    drawing.show_fixed(fixed)

    def filled() -> float:
        spots = drawing.own.pane.spots(drawing.state.volume.corners)
        return float((np.ptp(spots, axis=0) / SIZE).max())

    assert filled() > 0.6
    assert not drawing.cut()
    subject = drawing.state.objects
    assert drawing.own.pane.outside_px(subject) > 100.0
    drawing.show_names(frozenset())
    drawing.reset_view()
    assert drawing.own.pane.outside_px(subject) <= 0.0
    assert filled() < 0.4


def test_a_pale_subject_is_a_silhouette_and_its_picture_is_not(off_screen: MakeScreen) -> None:
    screen = off_screen(*SIZE)
    opened(screen, "similar-triangles")
    pixels, blue = screen.pixels(), "#56b4e9"
    assert share(pixels, blue, 0.7) > 0.01 > 0.2 * share(pixels, blue) > 0.0


@pytest.mark.parametrize(
    ("name", "size"),
    [
        *((name, SIZE) for name in BUILT_IN),
        *((name, SIZE[::-1]) for name in BUILT_IN if load(name).upright is not None),
    ],
)
def test_the_world_is_seen_from_the_scenes_shot(
    off_screen: MakeScreen, name: str, size: tuple[int, int]
) -> None:
    screen, scene = off_screen(*size), load(name)
    opened(screen, name).show_fixed("")
    upright = scene.upright if size[0] < size[1] else None
    azimuth, elevation, about = scene.shot if upright is None else upright
    if about == "camera":
        x, _, z = scene.start.camera.frame[2]
        azimuth += math.degrees(math.atan2(x, z))
    x, y, z = (-part for part in screen.renderer.GetActiveCamera().GetDirectionOfProjection())
    assert math.degrees(math.asin(y)) == pytest.approx(elevation, abs=1e-6)
    turned = math.degrees(math.atan2(x, z)) - azimuth
    assert math.remainder(turned, 360.0) == pytest.approx(0.0, abs=1e-6)


def test_the_camera_s_axes_are_seen_from_one_side_while_they_are_built(
    off_screen: MakeScreen,
) -> None:
    screen = off_screen(*SIZE)
    drawing, seen = opened(screen, "letter-f"), []
    for names, step in (({"eye", "u", "v", "n"}, None), ({"eye", "target", "n", "up"}, 3)):
        drawing.show_names(frozenset(names))
        drawing.show_step(step)
        drawing.reset_view()
        seen.append(screen.renderer.GetActiveCamera().GetDirectionOfProjection())
    assert seen[0] == pytest.approx(seen[1])


def test_the_cube_is_seen_from_the_scenes_side(off_screen: MakeScreen) -> None:
    """Beside the near face, y upright: the bow of the affine depth is as wide as it can be."""
    looked = {}
    for name in ("affine-depth", "clipping"):
        screen, scene = off_screen(*SIZE), load(name)
        StageDrawing(screen, scene, WORDS, LIGHT).show_projection(scene.start, illustrated(scene))
        x, y, z = (-part for part in screen.renderer.GetActiveCamera().GetDirectionOfProjection())
        looked[name] = math.degrees(math.atan2(x, z)), math.degrees(math.asin(y))
    assert looked["affine-depth"] == pytest.approx(PHENOMENA["affine-depth"].cube_side)
    assert PHENOMENA["clipping"].cube_side is None
    assert looked["clipping"] != pytest.approx(looked["affine-depth"])


@pytest.mark.parametrize("size", [SIZE, SIZE[::-1]])
def test_the_stage_shows_all_of_the_camera(off_screen: MakeScreen, size: tuple[int, int]) -> None:
    screen, scene = off_screen(*size), load("letter-f")
    for eye in ((0.0, 2.5, 8.0), scene.start.camera.eye, (-9.0, 1.0, 2.0)):
        drawing = StageDrawing(screen, scene, WORDS, LIGHT)
        drawing.show_names(frozenset({"near", "far", "eye"}))
        lens = Perspective(45.0, 1.0, 9.0)
        at = replace(scene.start, camera=Camera(eye, (0.0, 2.5, 0.0)), lens=lens)
        drawing.show_projection(at)
        for position in (WORLD, VIEW):
            drawing.show_stage(position)
            start, axes = drawing.state.morph.axes_at(position)
            body = np.column_stack([start + BODY * BODY_BOX @ axes, np.ones(8)])
            x, y = (drawing.own.pane_from_display @ body.T)[:2]
            assert min(x.min(), y.min()) >= 0.0
            assert x.max() <= size[0]
            assert y.max() <= size[1]


def test_a_scene_opens_in_its_fixed_view() -> None:
    for name, phenomenon in PHENOMENA.items():
        assert document_of(None, [f"scene={name}"]).view.fixed == phenomenon.fixed
    assert PHENOMENA["similar-triangles"].fixed == "side"
    assert document_of(None, ["scene=similar-triangles", "view.fixed=top"]).view.fixed == "top"


def test_the_cards_of_clipping_are_pale_where_the_triangle_matters(off_screen: MakeScreen) -> None:
    scene, shown = load("clipping"), illustrated(load("clipping"))
    kinds: dict[str, Any] = {"world": WorldDrawing, "ndc": StageDrawing, "image": ImageDrawing}
    shares = {}
    for pane, kind in kinds.items():
        screen = off_screen(*SIZE)
        kind(screen, scene, WORDS, LIGHT).show_projection(scene.start, shown)
        pixels = screen.pixels()
        red, green, blue = np.moveaxis(pixels, 2, 0)
        shares[pane] = float(((red > 215) & (green > 190) & (blue < 110)).mean())
    assert max(shares["world"], shares["ndc"]) < 0.1 * shares["image"]  # of the yellow card
