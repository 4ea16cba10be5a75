"""L2 in the panes: moving the object looks like moving the camera the other way."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.api import figure
from app.document.document import Document
from app.document.settings import set_values
from app.document.view import LAYERS, STAGES, View
from app.drawings.image import ImageDrawing
from app.drawings.picture_frame import UNFRAMED
from app.drawings.style import LIGHT
from app.model.chain import FiveTiles
from app.model.projection import Camera, Chain, Perspective, Projection
from app.scenes.scene import load
from tests.support.drawings import MakeScreen, figure_of

F = load("letter-f")
TURN_DEG, SHIFT = 30.0, (1.0, 0.5, -2.0)
BARE = View(layers=frozenset(LAYERS))


def moved_object() -> Projection:
    return replace(F.start, placement=FiveTiles(SHIFT, (0.0, TURN_DEG, 0.0)).chain)


def moved_camera() -> Projection:
    """The camera in the object's coordinates: turned back, after it was shifted back."""
    back = FiveTiles(rotate_deg=(0.0, -TURN_DEG, 0.0)).chain.matrix[:3, :3]
    camera = F.start.camera
    eye, target = (tuple(back @ np.subtract(p, SHIFT)) for p in (camera.eye, camera.target))
    return replace(F.start, camera=Camera(eye, target))


def differing(a: np.ndarray, b: np.ndarray) -> float:
    """The share of pixels that are clearly another colour."""
    return float((np.abs(a.astype(int) - b.astype(int)).max(axis=-1) > 60).mean())


@pytest.mark.parametrize("pane", ["image", "ndc"])
def test_l2_a_moved_object_is_what_a_camera_sees_that_moves_the_other_way(pane: str) -> None:
    pictures = [
        figure_of(F, projection, panes=(pane,), size=(480, 360), view=BARE).pixels()
        for projection in (moved_object(), moved_camera(), F.start)
    ]
    assert differing(pictures[0], pictures[1]) < 2e-3
    assert differing(pictures[0], pictures[2]) > 0.01


def test_l2_the_ground_stays_where_it_is_and_the_object_does_not() -> None:
    without_object = replace(F.start, placement=FiveTiles((0.0, 500.0, 0.0)).chain)
    pictures = [
        figure_of(
            F,
            projection,
            panes=("image",),
            size=(480, 360),
            view=View(layers=frozenset({"labels"})),
        ).pixels()
        for projection in (without_object, F.start)
    ]
    changed = np.abs(pictures[0].astype(int) - pictures[1].astype(int)).max(axis=-1) > 60
    rows, columns = np.nonzero(changed)
    # Only round the letter: the same grid is seen left and right of it and below.
    assert 0.02 < changed.mean() < 0.2
    assert columns.min() > 150 and columns.max() < 350 and rows.max() < 300


@pytest.mark.parametrize("tolerance_px", [1e-9, 1e9])
def test_l2_both_precisions_draw_the_moved_object(
    off_screen: MakeScreen, tolerance_px: float
) -> None:
    """Also 1e6 away from its origin, with the camera beside it."""
    words: Any = dict.fromkeys("xy", "")
    pictures = []
    for away in (0.0, 1e6):
        screen = off_screen(320, 240)
        drawing = ImageDrawing(screen, F, words, LIGHT, tolerance_px, options=UNFRAMED)
        drawing.show_layers(frozenset({"grid"}))
        camera = Camera((6.0 + away, 5.0, 9.0), (away, 2.2, 0.0))
        placement = FiveTiles((away, 0.0, 0.0), (0.0, 20.0, 0.0), (1.0, 0.5, 1.0)).chain
        drawing.show_projection(
            Projection(camera, Perspective(45.0, 4.0, 18.0), (320, 240), placement=placement)
        )
        assert drawing.precision == ("float64" if tolerance_px < 1.0 else "float32")
        pictures.append(screen.pixels())
        drawing.remove()
    assert differing(*pictures) < 5e-3


def test_l2_no_vertex_is_touched(off_screen: MakeScreen) -> None:
    """Moving the object changes matrices: the meshes and their points stay the same ones."""
    screen = off_screen(320, 240)
    words: Any = dict.fromkeys("xy", "")
    drawing = ImageDrawing(screen, F, words, LIGHT, options=UNFRAMED)

    def meshes() -> list[Any]:
        actors = screen.renderer.GetRenderWindow().GetRenderers()
        found = [
            actor.GetMapper().GetInput()
            for i in range(actors.GetNumberOfItems())
            for actor in actors.GetItemAsObject(i).GetActors()
        ]
        return [(mesh, mesh.GetMTime(), mesh.GetPoints() and mesh.GetPoints().GetMTime())
                for mesh in found if mesh.GetNumberOfCells()]  # fmt: skip

    drawing.show_projection(moved_object())
    screen.pixels()
    before = meshes()
    for x in (0.5, 3.0, -2.0):
        placement = FiveTiles((x, 0.0, 0.0), (x, 10.0, 0.0), (1.0, 2.0, x)).chain
        drawing.show_projection(replace(F.start, placement=placement))
        screen.pixels()
        assert meshes() == before
    drawing.remove()


@pytest.mark.parametrize(
    "placement",
    [
        FiveTiles(scale=(1.0, 0.0, 1.0)).chain,
        FiveTiles(scale=(0.0, 0.0, 0.0)).chain,
        FiveTiles(scale=(-1.0, 1.0, 1.0)).chain,
        FiveTiles((1e100, 0.0, 0.0)).chain,
        FiveTiles(scale=(1e30, 1e-100, 1.0)).chain,
        FiveTiles((0.0, 0.0, 1e9), (1e-9, 0.0, 1e30)).chain,
    ],
    ids=["flat", "point", "mirrored", "gone", "wild", "far"],
)
def test_any_object_is_drawn_in_every_pane_and_at_every_stage(placement: Chain) -> None:
    projection = replace(F.start, placement=placement)
    for stage in ("view", "ndc"):
        view = View(stage=float(STAGES.index(stage)))
        pixels = figure_of(
            F, projection, panes=("world", "ndc", "image"), size=(480, 160), view=view
        ).pixels()
        assert pixels.std() > 1.0


def test_a_stop_of_the_strip_shows_the_object_after_its_first_moves_and_ghosts_beside_it() -> None:
    """In the image the object alone; in the world the stops before and after it, too."""
    start = Document("letter-f", F.start)
    whole = set_values(start, ["object.chain=translate 1,0,0; rotate z 90", "view.stage=-1"])
    alone = set_values(start, ["object.chain=rotate z 90", "view.stage=0"])
    for pane, is_same in (("image", True), ("world", False)):
        one, other = (figure(each, panes=pane, size="240x200").array() for each in (whole, alone))
        assert (one == other).all() == is_same, pane
