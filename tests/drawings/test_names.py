"""What a drawing names is drawn and framed; the rest is quiet, or not drawn at all."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from vtkmodules.vtkRenderingCore import vtkActor2D

from app.document.document import Document
from app.document.naming import nameable, named_in
from app.document.view import View
from app.drawings import WORDS, DrawingWords
from app.drawings.actors import CUBE_CORNERS
from app.drawings.image import ImageDrawing
from app.drawings.near_picture import NearPicture
from app.drawings.pointing import FACES
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT, QUIET, QUIET_WIDTH, TITLE_EM, rgb
from app.drawings.world import WorldDrawing
from app.lecture.highlight import AXES, CORNERS, WINDOW
from app.lecture.letters import Letters
from app.model.projection import Camera, Perspective
from app.picking.handles import Handle
from app.picking.picking import Probe
from app.scenes.scene import BUILT_IN, load
from tests.support.drawings import MakeScreen, drawn, labels_of, lit_at, texts_of, to_bytes

PANE_PX = 580, 660
ACROSS_PX = 1480, 700


def opened(screen: Any, name: str = "letter-f", **options: Any) -> WorldDrawing:
    scene = load(name)
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT, **options)
    illustration = None
    if scene.phenomenon is not None:
        settings = scene.phenomenon.checked({})
        illustration = scene.phenomenon.illustration(scene.start, settings, scene.subject)
    drawing.show_projection(scene.start, illustration)
    drawing.show_fixed(scene.fixed)
    screen.pixels()
    return drawing


def actors(drawing: WorldDrawing, *axes: str) -> list[Any]:
    return [drawing.camera.shafts[axis] for axis in axes]


def test_axes_and_target_are_drawn_if_they_are_named_or_pointed_at(off_screen: MakeScreen) -> None:
    screen = off_screen(*PANE_PX)
    drawing = opened(screen)
    target = drawing.camera.discs["target"]
    assert not any(part.GetVisibility() for part in (*actors(drawing, *"uvn"), target))
    drawing.show_highlight(frozenset({"v", "target"}))
    assert [part.GetVisibility() for part in (*actors(drawing, *"uvn"), target)] == [0, 1, 0, 1]
    drawing.show_highlight(frozenset())
    drawing.show_names(frozenset({"u", "n"}))
    assert [part.GetVisibility() for part in (*actors(drawing, *"uvn"), target)] == [1, 0, 1, 0]
    drawing.show_names(None)
    assert all(part.GetVisibility() for part in (*actors(drawing, *"uvn"), target))


def test_a_plane_that_is_not_named_is_quiet_until_it_is_pointed_at(off_screen: MakeScreen) -> None:
    drawing = opened(off_screen(*PANE_PX))
    line = drawing.frustum.outlines["near"].GetProperty()
    width, colour = line.GetLineWidth(), np.array(line.GetColor())
    drawing.show_names(frozenset({"eye"}))
    quiet = (1.0 - QUIET) * np.array(rgb(LIGHT.near)) + QUIET * np.array(rgb(LIGHT.background))
    assert line.GetLineWidth() == QUIET_WIDTH * width
    assert np.allclose(line.GetColor(), quiet)
    drawing.show_highlight(frozenset({"near"}))
    assert line.GetLineWidth() > width and np.allclose(line.GetColor(), colour)
    drawing.show_highlight(frozenset())
    assert line.GetLineWidth() == QUIET_WIDTH * width
    drawing.show_names(frozenset({"near"}))
    assert line.GetLineWidth() == width and np.allclose(line.GetColor(), colour)


def test_at_rest_the_controls_have_grips_and_else_the_handle_in_the_hand(
    off_screen: MakeScreen,
) -> None:
    screen = off_screen(*PANE_PX)
    drawing = opened(screen, live=True)
    resting = {handle.name for handle in drawing.handles.drawn}
    assert resting == {"eye", "target", "near", "far"}
    drawing.handles.rest(())
    drawing.show_layers(frozenset())  # which places the labels afresh
    untouched = screen.pixels()
    near = next(handle for handle, _ in drawing.handles.shown if handle.name == "near")
    assert len(drawing.handles.shown) > 4  # they can be found
    drawing.show_layers(frozenset({"handles"}))
    assert (screen.pixels() == untouched).all()
    drawing.show_layers(frozenset())
    drawing.hold(near)
    held = screen.pixels()
    accent = to_bytes(LIGHT.accent)
    assert drawn(held, accent).any() and not drawn(untouched, accent).any()
    drawing.hold(None)
    assert (screen.pixels() == untouched).all()
    drawing.show_names(None)
    everything = screen.pixels()
    drawing.show_layers(frozenset({"handles"}))
    assert (screen.pixels() != everything).any()


def test_labels_at_rest_keep_off_the_grips_that_a_list_of_controls_asks_for(
    off_screen: MakeScreen,
) -> None:
    screen = off_screen(*PANE_PX)
    drawing = opened(screen, live=True)
    drawing.show_names(None)
    drawing.handles.rest(())
    drawing.handles.call(frozenset(handle.name for handle, _ in drawing.handles.shown))
    drawing.refit()
    with_grips = screen.pixels()
    drawing.reset_view()  # which places the labels afresh
    assert (screen.pixels() == with_grips).all()
    drawing.show_names(frozenset({"near", "far"}))
    drawing.refit()
    screen.pixels()
    drawing.handles.call(frozenset())
    drawing.refit()
    without = screen.pixels()
    drawing.show_layers(frozenset())
    assert (screen.pixels() == without).all()


def test_what_is_held_is_named(off_screen: MakeScreen) -> None:
    drawing = opened(off_screen(*PANE_PX), live=True)
    drawing.hold(Handle("target"))
    assert drawing.camera.discs["target"].GetVisibility()
    drawing.hold(None)
    assert not drawing.camera.discs["target"].GetVisibility()


def test_where_a_hand_takes_hold_of_the_target_the_target_is_pointed_at(
    off_screen: MakeScreen,
) -> None:
    """And not the side of the volume before it."""
    drawing = opened(off_screen(*PANE_PX), live=True)
    x, y = dict(drawing.handles.shown)[Handle("target")]
    assert lit_at(drawing, x, y) == {"target"}


def test_a_volume_that_is_not_drawn_has_no_sides_with_names(off_screen: MakeScreen) -> None:
    """While the camera's frame is built, it would cover the arrows."""
    screen = off_screen(*PANE_PX)
    drawing = opened(screen)
    drawing.show_names(None)
    screen.pixels()
    assert sum(text[:2] in ("l ", "r ", "b ", "t ") for text in texts_of(screen)) == 4
    drawing.show_step(4)
    screen.pixels()
    assert not any("=" in text for text in texts_of(screen))


def test_the_ground_is_pale_where_the_cameras_axes_are_named(off_screen: MakeScreen) -> None:
    """Its lines are as dark as the arrows otherwise."""
    screen = off_screen(*PANE_PX)
    drawing = opened(screen)
    dark = {}
    for names in ({"target"}, {"target", "n"}):
        drawing.show_names(frozenset(names))
        drawing.show_layers(frozenset({"labels", "camera", "frustum", "near-picture"}))
        drawing.show_fixed("top")
        dark[len(names)] = int((screen.pixels().max(axis=2) < 160).sum())
    assert 0 < dark[2] < 0.7 * dark[1]


@pytest.mark.parametrize("size_px", [PANE_PX, ACROSS_PX], ids=["window", "slide"])
def test_the_letters_picture_shows_eye_frustum_and_letter(
    off_screen: MakeScreen, size_px: tuple[int, int]
) -> None:
    drawing = opened(off_screen(*size_px))
    scene = load("letter-f")
    points = [scene.start.camera.eye, *scene.objects_box, *drawing.state.volume.corners]
    seen = drawing.sight.seen(np.array(points))
    assert (seen > 0.0).all() and (seen < size_px).all()
    across, up = np.ptp(seen, axis=0) / size_px
    assert max(across, up) >= 0.6


@pytest.mark.parametrize("name", BUILT_IN)
def test_the_named_marks_of_a_scene_are_large_in_its_world(
    off_screen: MakeScreen, name: str
) -> None:
    """With the subject, of which a named mark may be a part."""
    scene = load(name)
    drawing = opened(off_screen(*PANE_PX), name)
    names = named_in("world", scene)
    assert names is not None
    if scene.phenomenon is None or scene.leading != "world":
        return
    shown = scene.phenomenon.illustration(
        scene.start, scene.phenomenon.checked({}), scene.subject
    ).world
    points = [text.point for text in shown.texts if text.name in names]
    if "eye" in names:
        points.append(np.array(scene.start.camera.eye))
    seen = drawing.sight.seen(np.array(points))
    assert (seen >= 0.0).all() and (seen <= PANE_PX).all()
    around = np.vstack([seen, drawing.sight.seen(scene.objects_box)]).clip(0.0, PANE_PX)
    assert max(np.ptp(around, axis=0) / PANE_PX) >= 0.6


def test_the_flat_view_frames_the_triangle(off_screen: MakeScreen) -> None:
    """From the eye to P, of the width of the pane; the frustum's far plane leaves it."""
    drawing = opened(off_screen(*ACROSS_PX), "similar-triangles")
    scene = load("similar-triangles")
    assert drawing.fixed == "side"
    eye, p = drawing.sight.seen(np.array([scene.start.camera.eye, (1.5, 5.0, 0.5)]))
    assert 0.5 <= (p[0] - eye[0]) / ACROSS_PX[0] <= 0.9


def test_an_unnamed_label_is_not_written(off_screen: MakeScreen) -> None:
    screen = off_screen(*PANE_PX)
    drawing = opened(screen)
    names = "eye", "target", "near", "far", *AXES, *WINDOW
    labels = {name: drawing.board.label(name) for name in names}
    screen.pixels()
    shown = {name for name, label in labels.items() if label.is_visible}
    assert shown == {"eye", "near", "far"}
    drawing.show_names(frozenset({"near"}))
    assert {name for name, label in labels.items() if label.is_visible} == {"near"}


def test_the_cube_is_in_the_middle_of_what_the_title_leaves(off_screen: MakeScreen) -> None:
    for width_px, height_px in ((480, 300), (300, 480)):
        drawing = StageDrawing(off_screen(width_px, height_px), load("letter-f"), WORDS, LIGHT)
        drawing.show_projection(drawing.state.scene.start)
        seen = np.array(drawing.state.seen(CUBE_CORNERS))[:, :2]
        middle = (seen.min(axis=0) + seen.max(axis=0)) / 2.0
        title_px = TITLE_EM * LIGHT.font_size
        assert middle == pytest.approx([width_px / 2.0, (height_px - title_px) / 2.0], abs=0.01)


def test_the_cube_has_its_axes_if_all_three_are_named(off_screen: MakeScreen) -> None:
    """A single y is a length of another pane."""
    drawing = StageDrawing(off_screen(480, 300), load("letter-f"), WORDS, LIGHT)
    assert np.isfinite(drawing.box.axes[:3]).all()
    drawing.show_names(frozenset({"y", "near"}))
    assert np.isnan(drawing.box.axes).all()
    drawing.show_highlight(frozenset({"v"}))
    assert np.isfinite(drawing.box.axes[1]).all() and np.isnan(drawing.box.axes[[0, 2]]).all()


def test_the_axes_of_the_world_stand_still_while_the_camera_comes_to_them(
    off_screen: MakeScreen,
) -> None:
    """In pixels: x, y and z stay; u, v and n begin at the eye, and at the view's stop are there."""
    screen, scene = off_screen(600, 600), load("letter-f")
    drawing = StageDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_names(frozenset("xyzuvn"))
    drawing.show_projection(scene.start)
    camera_at, world_at = [], []
    for position in (0.0, 0.25, 0.5, 0.75, 0.999999):
        drawing.show_stage(position)
        spots = np.array(drawing.state.seen(drawing.box.axes[:, ::2].reshape(-1, 3)))[:, :2]
        assert (spots > 0.0).all() and (spots < 600.0).all()
        assert len(set(map(tuple, spots[[0, 2, 4]].round(6)))) == 1
        camera_at.append(spots[:6])
        world_at.append(spots[6:])
    for moment in world_at[1:]:
        assert moment[0] == pytest.approx(world_at[0][0], abs=0.5)
    assert np.ptp([moment[0] for moment in camera_at[:3]], axis=0).max() > 60.0
    assert camera_at[2][0] == pytest.approx(world_at[2][0], abs=1e-6)
    assert np.abs(camera_at[2] - world_at[2]).max() > 20.0
    assert camera_at[4] == pytest.approx(world_at[4], abs=0.1)
    drawing.show_stage(1.0)
    assert np.isfinite(drawing.box.axes[:3]).all() and np.isnan(drawing.box.axes[3:]).all()


def test_the_picture_fills_its_pane_unless_its_pixels_are_named(off_screen: MakeScreen) -> None:
    drawing = ImageDrawing(off_screen(480, 300), load("letter-f"), WORDS, LIGHT)
    bare = drawing.picture_rectangle_px
    assert bare.width >= 0.9 * 480 or bare.height >= 0.9 * 300
    drawing.show_names(frozenset({"pixels"}))
    assert drawing.picture_rectangle_px.width < bare.width


def test_a_point_outside_the_pane_has_no_letter(off_screen: MakeScreen) -> None:
    """The pane looks at probe 1 from nearby; probe 2 is far beyond the border."""
    screen, scene = off_screen(*PANE_PX), load("letter-f")
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_projection(scene.start)
    drawing.show_names(frozenset({"probe-A"}))
    drawing.show_probes([Probe(1, (0.0, 1.0, 0.0)), Probe(2, (60.0, 1.0, 0.0))])
    drawing.own.show(Camera((0.0, 1.0, 6.0), (0.0, 1.0, 0.0)))
    drawing.reset_clipping_range()
    assert {"A"} == {text for text in texts_of(screen) if text in ("1", "2", "A", "B")}
    drawing.show_names(frozenset())
    assert "1" in texts_of(screen) and "A" not in texts_of(screen)


def test_probes_have_letters_in_every_pane_that_the_view_names(off_screen: MakeScreen) -> None:
    screen, scene = off_screen(*PANE_PX), load("letter-f")
    drawing = StageDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_projection(scene.start)
    drawing.show_names(frozenset({"probe-B"}))
    drawing.show_probes([Probe(1, (0.0, 1.0, 0.0)), Probe(2, (1.0, 3.0, 0.0))])
    assert {"1", "B"} == {text for text in texts_of(screen) if text in ("1", "2", "A", "B")}
    document = Document("letter-f", scene.start)
    two = replace(document, view=View(probes=(Probe(1, (0, 1, 0)), Probe(2, (1, 3, 0)))))
    for pane in ("world", "ndc", "image"):
        assert {"probe-A", "probe-B"} <= nameable(pane, two, scene)
        assert "probe-A" not in nameable(pane, document, scene)


@pytest.mark.parametrize("fixed", ["", "side"])
def test_the_projectors_of_probes_are_ink(off_screen: MakeScreen, fixed: str) -> None:
    drawing = WorldDrawing(off_screen(480, 300), load("letter-f"), WORDS, LIGHT)
    drawing.show_projection(load("letter-f").start)
    drawing.show_fixed(fixed)
    drawing.show_layers(frozenset({"grid", "frustum", "near-picture"}))
    point, eye = np.array((6.0, 6.0, 4.0)), np.array(load("letter-f").start.camera.eye)
    x, y = drawing.own.pane.spots((point + eye) / 2.0 - drawing.state.origin)
    box = np.array([[x - 9.0, y - 9.0, x + 9.0, y + 9.0]])
    before = drawing.layers.ground().hidden(box)
    drawing.show_probes([Probe(1, (6.0, 6.0, 4.0))])
    assert drawing.layers.ground().hidden(box) > before + 0.1


@pytest.mark.parametrize(("size_px", "em"), [((584, 680), 15.5), ((1480, 840), 36.0)])
def test_the_name_of_the_next_tree_stands_clear_of_the_other_trees(
    off_screen: MakeScreen, size_px: tuple[int, int], em: float
) -> None:
    """The avenue's faces are ink, although they are many: else the name hid the small trees."""
    scene, screen = load("far-plane-popping"), off_screen(*size_px)
    style = LIGHT.enlarged(em / LIGHT.font_size)
    drawing = ImageDrawing(screen, scene, WORDS, style)
    drawing.show_names(frozenset({"next-tree"}))
    drawing.show_projection(scene.start, scene.illustration(scene.start, {}))
    screen.render_window.Render()
    (box,) = drawing.board.boxes[:1]
    (label,) = labels_of(drawing.board.renderer).values()
    assert label.text == "the next tree"
    label.set_visible(False)
    left, low, right, high = (round(side) for side in box)
    to_right, up = drawing.board.renderer.GetOrigin()
    base = size_px[1] - up
    beneath = screen.pixels()[base - high : base - low, to_right + left : to_right + right]
    assert beneath.size and (np.ptp(beneath.astype(int), axis=2) > 60).mean() < 0.005


@pytest.mark.parametrize(("letters", "near", "far"), [("002", "+1", "−1"), ("003", "−1", "+1")])
def test_lecture_002_has_its_own_sign_of_depth_in_the_cube(
    off_screen: MakeScreen, letters: Letters, near: str, far: str
) -> None:
    """002: z' = A + B/z with A = -(z_f + z_n)/(z_f - z_n), B = 2 z_n z_f/(z_f - z_n): 1 at near."""
    z_n, z_f = -4.0, -18.0
    a, b = -(z_f + z_n) / (z_f - z_n), 2.0 * z_n * z_f / (z_f - z_n)
    assert (a + b / z_n, a + b / z_f) == pytest.approx((1.0, -1.0))
    screen = off_screen(*PANE_PX)
    drawing = StageDrawing(screen, load("letter-f"), DrawingWords(letters), LIGHT)
    drawing.show_names(frozenset({"near", "far"}))
    assert {f"near {near}", f"far {far}"} <= texts_of(screen).keys()


def test_an_angle_is_written_in_degrees_if_the_view_asks_for_it(off_screen: MakeScreen) -> None:
    """By hand: 16:9 and 60 degrees high: half the width is atan(16/9 tan 30) = 45.75 degrees."""
    screen, scene = off_screen(*PANE_PX), load("letter-f")
    drawing = WorldDrawing(screen, scene, DrawingWords("001"), LIGHT, live=True)
    drawing.show_names(frozenset({"angle", "degrees"}))
    drawing.show_projection(replace(scene.start, lens=Perspective(60.0, 4.0, 18.0)))
    drawing.show_fixed("top")
    screen.pixels()
    assert "θ_h/2 = 45.75°" in texts_of(screen)
    drawing.show_names(frozenset({"angle"}))
    screen.pixels()
    assert "θ_h/2" in texts_of(screen)


def test_a_named_frame_of_the_eye_is_drawn_as_its_named_axes_are(off_screen: MakeScreen) -> None:
    """Three spaces have three frames: the eye's was small and pale."""
    drawing, seen = opened(off_screen(*PANE_PX)), []
    for names in ({"frame-e"}, {"u", "v", "n"}, {"eye"}):
        drawing.show_names(frozenset(names))
        shaft = drawing.camera.shafts["v"]
        prop = shaft.GetProperty()
        seen.append((drawing.camera.axes_lead, prop.GetLineWidth(), prop.GetColor()))
    assert seen[0] == seen[1] and seen[0][0] and not seen[2][0]


def test_a_question_knows_where_the_objects_are(off_screen: MakeScreen) -> None:
    drawing = opened(off_screen(*PANE_PX))
    x, y, _ = np.array(drawing.state.seen(drawing.state.objects)).mean(axis=0).tolist()
    ground = drawing.layers.ground()
    boxes = (x - 15.0, y - 15.0, x + 15.0, y + 15.0), (-200.0, -200.0, 0.0, 0.0), (-9, -9, 9e3, 9e3)
    inside, beside, everywhere = ground.inked_px(np.array(boxes)).tolist()
    assert inside > 300.0 and beside == 0.0 and everywhere < 0.5 * PANE_PX[0] * PANE_PX[1]


def test_what_is_hidden_is_made_when_it_is_first_seen(off_screen: MakeScreen) -> None:
    """A new drawing has no mesh for its hidden labels and leaders."""
    drawing = opened(off_screen(*PANE_PX))
    flat = [prop for prop in drawing.board.renderer.GetViewProps() if isinstance(prop, vtkActor2D)]
    hidden = [actor for actor in flat if not actor.GetVisibility()]
    assert hidden and all(actor.GetMapper() is None for actor in hidden)
    label = drawing.board.label("another", "another")
    assert label.actor.GetMapper() is None
    label.set_visible(True)
    assert label.actor.GetMapper().GetInput().GetNumberOfPoints() == 4


def test_a_highlight_makes_what_it_shows_once_and_in_its_place(off_screen: MakeScreen) -> None:
    """What lies before another thing lies before it, too, if it is made later."""
    drawing = opened(off_screen(*PANE_PX))
    props = drawing.board.renderer.GetViewProps()
    before = list(props)
    drawing.show_highlight(frozenset({"left"}))
    after = list(props)
    made = [prop for prop in after if prop not in before]
    assert made and [prop for prop in after if prop in before] == before
    first = after.index(made[0])
    assert after[first : first + len(made)] == made and after[-1] is before[-1]
    assert sum(bool(prop.GetVisibility()) for prop in made) == 2  # the face and its outline
    drawing.show_highlight(frozenset())
    drawing.show_highlight(frozenset({"right", "near_left_bottom"}))
    assert list(props) == after
    assert sum(bool(prop.GetVisibility()) for prop in made) == 3


@pytest.mark.parametrize("kind", [WorldDrawing, StageDrawing])
def test_every_face_and_corner_that_is_pointed_at_is_seen(
    off_screen: MakeScreen, kind: Any
) -> None:
    screen, scene = off_screen(*PANE_PX), load("letter-f")
    drawing = kind(screen, scene, WORDS, LIGHT)
    drawing.show_projection(scene.start)
    unlit = screen.pixels()
    for name in (*FACES, *CORNERS):
        drawing.show_highlight(frozenset({name}))
        assert (screen.pixels() != unlit).any(), name
    drawing.show_highlight(frozenset())
    assert (screen.pixels() == unlit).all()


def test_labels_are_placed_after_several_changes(off_screen: MakeScreen) -> None:
    drawing = opened(screen := off_screen(*PANE_PX))
    start = drawing.state.projection
    with drawing.layers.placing_once():
        drawing.show_projection(replace(start, lens=Perspective(20.0, 2.0, 8.0)))
        drawing.reset_view()
    once = screen.pixels()
    drawing.show_layers(frozenset())  # which places the labels afresh
    assert (screen.pixels() == once).all()


def test_several_changes_settle_once(
    off_screen: MakeScreen, monkeypatch: pytest.MonkeyPatch
) -> None:
    settled: list[object] = []
    monkeypatch.setattr(NearPicture, "settle", lambda layer: settled.append(layer))
    drawing = WorldDrawing(off_screen(*PANE_PX), load("letter-f"), WORDS, LIGHT)
    assert len(settled) == 1
    with drawing.layers.placing_once():
        drawing.show_projection(drawing.state.scene.start)
        drawing.reset_view()
        assert len(settled) == 1
    assert len(settled) == 2
