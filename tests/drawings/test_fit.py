"""The fit of the world pane against VTK's own camera; what it cuts against pixels by hand."""

from dataclasses import replace

import numpy as np
import pytest
from vtkmodules.vtkRenderingCore import vtkCamera

from app.commands.composed import faults_in
from app.document.document import Document
from app.document.settings import set_values
from app.drawings import WORDS
from app.drawings.composition import measured
from app.drawings.pane_view import nearest_place
from app.drawings.style import LIGHT
from app.drawings.world import WorldDrawing
from app.model.projection import Array, Camera, Perspective
from app.scenes.scene import BUILT_IN, load
from tests.support.drawings import MakeScreen, illustrated

SIZES = (584, 680), (1000, 830), (1480, 910), (200, 120)


def on_screen(camera: vtkCamera, aspect: float, points: Array) -> Array:
    """Where VTK's camera sees points, (n, 3): from -1 to 1, with the depth's sign in w."""
    matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)
    rows = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    clip = np.column_stack([points, np.ones(len(points))]) @ rows.T
    assert (clip[:, 3] > 0.0).all(), "behind the camera"
    seen: Array = clip[:, :2] / clip[:, 3:]
    return seen


@pytest.mark.parametrize("seed", range(40))
def test_the_nearest_place_holds_all_points_and_no_nearer_one_does(seed: int) -> None:
    rng = np.random.default_rng(seed)
    view, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    view[2] = np.cross(view[0], view[1]) * -1.0  # right, up, toward
    half, aspect = np.tan(np.radians(25.0)), rng.uniform(0.3, 3.0)
    room = rng.uniform(0.3, 0.95, 4)  # left, right, down, up
    slopes = half * room * (aspect, aspect, 1.0, 1.0)
    points = rng.normal(size=(rng.integers(2, 40), 3)) * rng.uniform(0.1, 50.0, 3) + 7.0
    narrow = 0.5 * slopes, points[:1] + 1.0
    sights = (view @ points.T, slopes), (view @ narrow[1].T, narrow[0])
    right, up, back = nearest_place(sights, -1e9)
    place = np.array([right, up, -back]) @ view
    camera = vtkCamera()
    camera.SetViewAngle(50.0)
    camera.SetClippingRange(1e-3, 1e6)
    both = ((points, room), (narrow[1], 0.5 * room))

    def beyond(at: Array) -> float:
        """How far the farthest point is beyond its room, along either side of the pane."""
        camera.SetPosition(*at)
        camera.SetFocalPoint(*(at + view[2]))
        camera.SetViewUp(*view[1])
        most = -1.0
        for some, (left, to_right, down, above) in both:
            x, y = on_screen(camera, aspect, some).T
            most = max(most, (x - to_right).max(), (-x - left).max())
            most = max(most, (y - above).max(), (-y - down).max())
        return float(most)

    if (view[2] @ (points - place).T).min() > 1e-6:
        assert beyond(place) == pytest.approx(0.0, abs=1e-6)
        step = 1e-3 * np.ptp(points)
        nearer = place + step * view[2]
        aside = [i * view[0] + j * view[1] for i in (-1, 0, 1) for j in (-1, 0, 1)]
        if (view[2] @ (points - nearer).T).min() > 1e-6:
            assert min(beyond(nearer + 0.5 * step * way) for way in aside) > 0.0


@pytest.mark.parametrize(
    ("name", "size"),
    [
        *((name, SIZES[0]) for name in BUILT_IN),
        *((name, SIZES[1 + at % 3]) for at, name in enumerate(BUILT_IN)),
    ],
)
def test_a_scene_opens_with_all_that_has_to_be_inside(
    off_screen: MakeScreen, name: str, size: tuple[int, int]
) -> None:
    """Also where the pane's own measure is not asked, but VTK's camera."""
    screen, scene = off_screen(*size), load(name)
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_projection(scene.start, illustrated(scene))
    assert drawing.cut() == {}
    inside = drawing.layers.inside()
    assert {"subject", *({"near", "far"} & set(scene.names))} <= inside.keys()
    subject = inside["subject"]
    if "subject" in scene.leaves_out:  # drawn, and much longer than what is framed
        del inside["subject"]
    camera = screen.renderer.GetActiveCamera()
    seen = on_screen(camera, size[0] / size[1], np.concatenate(list(inside.values())))
    assert np.abs(seen).max() <= 0.93, "a margin of 4 % on each side, and labels"
    filled, is_small = np.ptp(seen, axis=0).max() / 2.0, size == SIZES[-1]
    assert filled >= (0.55 if is_small else 0.77), "and as large as labels allow"
    subject = on_screen(camera, size[0] / size[1], subject)
    assert is_small or np.ptp(subject[:, 1]) / 2.0 >= 0.195, "a fifth of the pane's height"


@pytest.mark.parametrize("turns", [(0.0,), (0.0, 90.0, 180.0, 270.0), (0.0, 20.0, 40.0)])
def test_a_film_shows_all_of_each_moment_at_each_turn(
    off_screen: MakeScreen, turns: tuple[float, ...]
) -> None:
    screen, scene = off_screen(600, 400), load("letter-f")
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT)
    lens = scene.start.lens
    assert isinstance(lens, Perspective)
    moments = [
        replace(scene.start, lens=replace(lens, fov_y_deg=angle, far=far))
        for angle, far in ((20.0, 12.0), (50.0, 20.0))
    ]
    views = drawing.views([(moment, None) for moment in moments], turns)
    assert len(views) == len(turns)
    for view in views:
        drawing.show_view(view)
        for moment in moments:
            drawing.show_projection(moment)
            assert drawing.cut() == {}
    if len(views) > 1:
        distances = {round(view.distance, 9) for view in views}
        assert len(distances) == 1, "round the middle"


def test_what_is_cut_is_counted_in_pixels(off_screen: MakeScreen) -> None:
    """From straight before the letter, whose farthest place in the pane is computed by hand."""
    screen, scene = off_screen(600, 400), load("letter-f")
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_names(frozenset())
    drawing.show_layers(frozenset({"camera", "frustum"}))
    front = scene.upper[2]
    drawing.show_view(Camera((0.0, 2.0, front + 5.0), (0.0, 2.0, front)))
    half = 5.0 * np.tan(np.radians(25.0))
    high = scene.upper[1] - 2.0
    assert high > half
    assert drawing.cut() == pytest.approx({"subject": (high / half - 1.0) * 200.0})
    drawing.show_view(Camera((0.0, 2.0, front - 0.5), (0.0, 2.0, front - 9.0)))
    assert drawing.cut() == {"subject": np.inf}, "a part of it is behind the viewer"


def test_a_planted_close_up_is_found(off_screen: MakeScreen) -> None:
    scene = load("letter-f")
    document = Document("letter-f", scene.start)
    planted = "view.panes=world: 4,5,9,0,2,0", "view.names=near,far"
    (close,) = measured(set_values(document, planted), scene, "world", (584, 680), 15.5)
    assert {"near", "far", "eye"} <= dict(close.outside).keys()
    said = [text for kind, text in faults_in(close, None) if kind == "cut"]
    assert any(text.startswith("“near” lies ") for text in said)
    (whole,) = measured(set_values(document, planted[1:]), scene, "world", (584, 680), 15.5)
    assert whole.outside == ()
