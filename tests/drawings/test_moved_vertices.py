"""Vertices that a phenomenon moves: each pane draws its own, and the texture goes with them."""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.drawings import WORDS
from app.drawings.image import ImageDrawing
from app.drawings.precision import least_tolerance
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT
from app.drawings.world import WorldDrawing
from app.model.limits import vector
from app.model.projection import Array, Camera
from app.scenes.phenomena.cheap_arithmetic import PHENOMENON
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.marks import Vertices
from app.scenes.scene import load
from tests.support.drawings import OffScreen, figure_of, heard, rendered

SIZE = (480, 360)
SCENE = load("cheap-arithmetic")
BARE = frozenset({"grid", "frustum", "camera", "near-picture"})
NOWHERE = np.full((1, 3), np.nan)


@pytest.fixture
def plotter() -> Iterator[Any]:
    with heard() as said:
        made = OffScreen(*SIZE)
        made.render_window.SetMultiSamples(0)
        yield made
        made.close()
    assert said.GetOutput() == ""


def illustration(stored: Array | None = None, projected: Array | None = None) -> Illustration:
    """The scene's own texture, correctly interpolated, and its vertices moved by these."""
    shown = PHENOMENON.show(SCENE.start, PHENOMENON.checked({"preset": "exact"}), SCENE.subject)
    assert shown.vertices is not None
    own = shown.vertices.own
    vertices = Vertices(
        own,
        own + (NOWHERE if stored is None else stored),
        own + (NOWHERE if projected is None else projected),
    )
    return Illustration((), rendering=shown.rendering, vertices=vertices)


def away(by: Array) -> Any:
    """The start, moved the other way, so that all it sees has moved by this."""
    camera = SCENE.start.camera
    eye, target = (tuple((np.array(p) - by).tolist()) for p in (camera.eye, camera.target))
    return replace(SCENE.start, camera=replace(camera, eye=eye, target=target))


def different(one: Any, other: Any) -> float:
    """The share of the pixels that differ clearly."""
    return float((abs(one.astype(int) - other.astype(int)).max(axis=-1) > 40).mean())


@pytest.mark.parametrize("kind", [ImageDrawing, StageDrawing])
def test_moved_vertices_look_as_from_a_camera_that_has_moved(plotter: Any, kind: Any) -> None:
    """With their texture: one that stayed in its place would show other checks."""
    drawing = kind(plotter, SCENE, WORDS, LIGHT)
    drawing.show_layers(BARE)
    by = np.array([0.7, 0.2, -0.4])
    drawing.show_projection(SCENE.start, illustration(projected=0.0 * by))
    still = rendered(plotter.render_window)
    drawing.show_projection(SCENE.start, illustration(projected=by))
    moved = rendered(plotter.render_window)
    drawing.show_projection(away(by), illustration(projected=0.0 * by))
    assert different(moved, rendered(plotter.render_window)) < 0.002
    assert different(moved, still) > 0.02
    drawing.show_projection(SCENE.start, replace(illustration(), vertices=None))
    assert different(rendered(plotter.render_window), still) == 0.0
    drawing.remove()


def test_the_world_draws_the_vertices_as_they_are_stored(plotter: Any) -> None:
    drawing = WorldDrawing(plotter, SCENE, WORDS, LIGHT)
    drawing.show_layers(BARE)
    by, zero = np.array([0.5, 0.3, 0.1]), np.zeros(3)
    drawing.show_projection(SCENE.start, illustration(zero, zero))
    still = rendered(plotter.render_window)
    drawing.show_projection(SCENE.start, illustration(zero, by))
    assert different(rendered(plotter.render_window), still) == 0.0, "the picture is not shown"
    drawing.show_projection(SCENE.start, illustration(by, zero))
    assert different(rendered(plotter.render_window), still) > 0.01
    drawing.show_layers(BARE - {"near-picture"})
    drawing.show_names(frozenset({"near"}))
    drawing.show_projection(SCENE.start, illustration(zero, zero))
    with_picture = rendered(plotter.render_window)
    drawing.show_projection(SCENE.start, illustration(zero, by))
    assert different(rendered(plotter.render_window), with_picture) > 0.001, "it is on near"
    drawing.remove()


def test_other_drawings_of_the_scene_keep_its_vertices(plotter: Any) -> None:
    other = OffScreen(*SIZE)
    first, second = (ImageDrawing(p, SCENE, WORDS, LIGHT) for p in (plotter, other))
    zero = np.zeros(3)
    second.show_projection(SCENE.start, illustration(projected=zero))
    still = rendered(other.render_window)
    first.show_projection(SCENE.start, illustration(projected=zero + 1.0))
    second.show_projection(SCENE.start, illustration(projected=zero))
    assert (rendered(other.render_window) == still).all()
    assert SCENE.surface is not None
    assert np.abs(SCENE.surface.points).max() <= 4.85
    first.remove()
    second.remove()
    other.close()


@pytest.mark.parametrize("name", ["cracks", "vertex-depth", "cheap-arithmetic"])
def test_moved_vertices_are_drawn_from_ever_so_near(name: str) -> None:
    """Float64 cuts faces, and then a vertex would have no place of its own."""
    scene = load(name)
    assert least_tolerance(scene, 1e-9) == math.inf
    camera = scene.start.camera
    eye = np.array(camera.target) + 0.1 * camera.frame[2]
    lens = scene.start.lens.replaced(near=1e-3)
    near = replace(scene.start, camera=Camera(vector(eye), camera.target), lens=lens)
    picture = figure_of(scene, projection=near, panes=["image"], size=(64, 36)).pixels()
    assert picture.shape[:2] == (36, 64)
