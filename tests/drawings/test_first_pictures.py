"""The first picture of each scene: large enough, its parts apart, its labels beside it."""

import itertools
import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkActor2D

from app.drawings import WORDS
from app.drawings.style import LIGHT, TITLE_EM, Style
from app.drawings.world import WorldDrawing
from app.model.projection import Camera
from app.scenes.scene import BUILT_IN, load
from tests.support.drawings import (
    MakeScreen,
    OffScreen,
    boxes_of,
    illustrated,
    overlapping,
    to_bytes,
)

Mask = NDArray[np.bool_]
LARGE, SMALL = (580, 640), (420, 203)  # as in a window of 1366 x 768
SLOT_PX = 584, 690
"""Of the world in a window of 1366 x 768."""


def opened(
    screen: OffScreen, name: str, style: Style = LIGHT, *, live: bool = True, own: bool = False
) -> Any:
    """A scene's world, as it opens, with its own names or with all."""
    scene = load(name)
    drawing = WorldDrawing(screen, scene, WORDS, style, live=live)
    if not own:
        drawing.show_names(None)
    drawing.show_projection(scene.start, illustrated(scene))
    drawing.reset_view()
    screen.pixels()
    return drawing


@contextmanager
def alone(screen: OffScreen, *shown: Any) -> Iterator[None]:
    """Draw these props and no others."""
    props = list(screen.renderer.GetViewProps())
    before = [prop.GetVisibility() for prop in props]
    for prop in props:
        prop.SetVisibility(any(prop is other for other in shown))
    yield
    for prop, visible in zip(props, before, strict=True):
        prop.SetVisibility(visible)


def mask_of(screen: OffScreen, *shown: Any) -> Mask:
    """The pixels of these props, from the bottom up."""
    with alone(screen, *shown):
        image = screen.pixels()
    return np.asarray((image != to_bytes(LIGHT.background)).any(axis=-1)[::-1])


def extent_px(mask: Mask) -> tuple[int, int]:
    rows, columns = np.nonzero(mask)
    return int(np.ptp(columns)) + 1, int(np.ptp(rows)) + 1


@pytest.mark.parametrize(
    ("name", "size_px"),
    [*((name, SMALL) for name in BUILT_IN), *((name, LARGE) for name in BUILT_IN[::3])],
)
def test_no_label_lies_on_the_object_the_camera_or_another(
    off_screen: MakeScreen, name: str, size_px: tuple[int, int]
) -> None:
    """Its own names hide little of it; if everything is named there may be no better place."""
    screen, own_names = off_screen(*size_px), frozenset(load(name).names)
    drawing = opened(screen, name)
    boxes = boxes_of(screen)
    assert "eye" in boxes
    if size_px == LARGE:  # in a small one some have no room
        assert "target" in boxes
        assert len({"near", "far", "u⃗", "v⃗", "n⃗"} & {text.split()[0] for text in boxes}) >= 4
    for text, (left, bottom, right, top) in boxes.items():
        for handle, (x, y) in drawing.handles.shown:
            y = size_px[1] - y
            assert not (left < x < right and bottom < y < top), (text, handle)
    for names, most in ((None, 1.0), (own_names, 0.4 if size_px == SMALL else 0.05)):
        drawing.show_names(names)
        thing = mask_of(screen, faces_of(screen))
        body = mask_of(screen, *drawing.camera.solid)
        boxes = boxes_of(screen)
        assert thing.any() and boxes
        assert overlapping(boxes) == []
        for text, (left, bottom, right, top) in boxes.items():
            assert left >= 0 and bottom >= 0 and right <= size_px[0] and top <= size_px[1], text
            part = np.s_[math.floor(bottom) : math.ceil(top), math.floor(left) : math.ceil(right)]
            if name != "vertex-depth":  # its floor lies round everything
                assert thing[part].mean() <= most, text
            assert not body[part].any(), text


def faces_of(screen: OffScreen) -> Any:
    """The actor of the scene's faces, which is added before all others."""
    return next(prop for prop in screen.renderer.GetViewProps() if not isinstance(prop, vtkActor2D))


def drawn_px(screen: OffScreen, name: str) -> tuple[int, int]:
    """The extent of a drawing without its labels."""
    drawing = opened(screen, name, live=False, own=True)
    assert not drawing.handles.shown
    for prop in screen.renderer.GetViewProps():
        if isinstance(prop, vtkActor2D):
            prop.SetVisibility(False)
    return extent_px((screen.pixels() != to_bytes(LIGHT.background)).any(axis=-1))


def test_the_letters_frustum_takes_its_share_of_the_window(off_screen: MakeScreen) -> None:
    """The drawing without labels takes 15 % of 1366 x 768."""
    width, height = drawn_px(off_screen(*SLOT_PX), "letter-f")
    assert width * height >= 0.15 * 1366 * 768


@pytest.mark.parametrize(
    ("name", "size_px"),
    [
        *((name, SLOT_PX) for name in BUILT_IN),
        *((name, (1000, 830)) for name in BUILT_IN[::3]),
        *((name, SMALL) for name in BUILT_IN[1::3]),
        *((name, (1480, 910)) for name in BUILT_IN[2::3]),
    ],
)
def test_what_is_drawn_fills_a_pane_of_any_shape(
    off_screen: MakeScreen, name: str, size_px: tuple[int, int]
) -> None:
    width, height = drawn_px(off_screen(*size_px), name)
    under_title = size_px[1] - TITLE_EM * LIGHT.font_size
    less, more = sorted((width / size_px[0], height / under_title))
    assert more >= (0.8 if size_px == SMALL else 0.84)
    # Triangles on an axis, from the side, and a wall of two meshes are long and low.
    assert less >= {"similar-triangles": 0.28, "cracks": 0.35}.get(name, 0.38)


@pytest.mark.parametrize("name", BUILT_IN)
def test_no_face_of_the_marks_is_cut_at_the_border(off_screen: MakeScreen, name: str) -> None:
    """A name frames it, as the horizon frames the plane of *Vanishing points*."""
    drawing = opened(off_screen(640, 640), name, live=False, own=True)
    shown = illustrated(load(name))
    for face in () if shown is None else shown.world.faces:
        points = np.reshape(face.points, (-1, 3)) - drawing.state.origin
        assert drawing.own.pane.outside_px(points) < 1.0


@pytest.mark.parametrize("name", ["letter-f", "cube"])
def test_eye_near_plane_object_and_far_plane_do_not_cover_one_another(
    off_screen: MakeScreen, name: str
) -> None:
    """Object and far plane may overlap: the far plane is much larger."""
    screen = off_screen(*LARGE)
    drawing = opened(screen, name, live=False, own=True)
    near_tint, far_tint = (tint for tint, _ in drawing.frustum.tints.values())
    near, far = mask_of(screen, near_tint), mask_of(screen, far_tint)
    eye, thing = mask_of(screen, drawing.camera.discs["eye"]), mask_of(screen, faces_of(screen))
    for one, other in itertools.combinations((eye, near, thing), 2):
        assert (one & other).sum() <= 0.02 * min(one.sum(), other.sum())
    assert not (eye & far).any()
    assert (far & ~near & ~thing).sum() > 0.7 * far.sum()
    assert near.sum() > 0.005 * near.size  # and the picture that lies on it can be seen


@pytest.mark.parametrize("name", BUILT_IN)
def test_the_eye_is_seen_beside_what_it_looks_at(off_screen: MakeScreen, name: str) -> None:
    for size_px in (SMALL, LARGE):
        screen = off_screen(*size_px)
        drawing = opened(screen, name, live=False, own=True)
        eye, thing = mask_of(screen, drawing.camera.discs["eye"]), mask_of(screen, faces_of(screen))
        assert (eye & thing).sum() <= 0.02 * eye.sum()


@pytest.mark.parametrize("size_px", [SLOT_PX, (580, 655), (582, 640)])
def test_the_error_of_a_found_point_is_written_beside_the_mesh(
    off_screen: MakeScreen, size_px: tuple[int, int]
) -> None:
    screen = off_screen(*size_px)
    drawing, shown = opened(screen, "unprojection", own=True), illustrated(load("unprojection"))
    assert shown is not None
    back = np.concatenate([line.points for line in shown.world.lines if line.name == "back"])
    left, low, right, _high = boxes_of(screen)["0.58"]
    spots = drawing.own.pane.spots(back - drawing.state.origin)
    beside = max(left - spots[:, 0].max(), low - spots[:, 1].max())
    assert beside > -0.2 * (right - left)


@pytest.mark.parametrize("size_px", [SLOT_PX, (882, 990), (1000, 830), (1480, 910)])
def test_near_and_far_are_named_outside_the_frustum(
    off_screen: MakeScreen, size_px: tuple[int, int]
) -> None:
    """Also where a grip is in the middle of the edge that is best for it."""
    screen = off_screen(*size_px)
    drawing = opened(screen, "letter-f", own=True)
    faces = [tint for tint, _ in drawing.frustum.tints.values()]
    inside = mask_of(screen, drawing.frustum.dimmable[-1], *faces)
    for name in ("near", "far"):
        left, right, low, high = map(round, drawing.board.label(name).box_px)
        assert inside[low:high, left:right].mean() < 0.15, name  # a turned name's box reaches in


@pytest.mark.parametrize("size_px", [LARGE, SMALL])
@pytest.mark.parametrize("name", ["letter-f", "view-volumes", "far-plane-popping", "eye-plane"])
def test_the_cameras_body_is_no_larger_than_a_twelfth_of_the_pane(
    off_screen: MakeScreen, name: str, size_px: tuple[int, int]
) -> None:
    """In the opening view, and from as near behind it as a user can go."""
    screen = off_screen(*size_px)
    drawing = opened(screen, name)
    at = load(name).start.camera
    behind = np.array(at.eye) + at.frame[2] * 0.2 + at.frame[0] * 0.1
    for view in (None, Camera(tuple(behind), at.target), Camera(at.target, at.eye)):
        if view is not None:
            drawing.show_view(view)
        body = mask_of(screen, *drawing.camera.solid)
        if view is None:
            assert body.any()
        if body.any():
            assert max(extent_px(body)) <= min(size_px) / 12.0 + 2.0  # its lines are 2 px wide


def test_what_a_scene_is_held_at_is_not_beyond_a_break(off_screen: MakeScreen) -> None:
    """The line's end Q is 12.8 from the eye plane, the letter 7.7, far is 14: nothing is broken."""
    scene = load("affine-depth")
    drawing = WorldDrawing(off_screen(*LARGE), scene, WORDS, LIGHT)
    drawing.show_names(None)
    for far, is_broken in ((14.0, False), (20.0, True)):
        projection = replace(scene.start, lens=scene.start.lens.replaced(far=far))
        drawing.show_projection(projection, illustrated(scene, projection))
        assert any(edge.GetVisibility() for _, edge in drawing.frustum.breaks["far"]) == is_broken


@pytest.mark.parametrize(("far", "is_broken"), [(17.0, False), (17.3, True), (math.inf, True)])
def test_the_frustum_is_broken_beyond_half_again_the_objects_depth(
    off_screen: MakeScreen, far: float, is_broken: bool
) -> None:
    """The letter's deepest corner is 11.42 from the eye plane: 1.5 times that is 17.1."""
    scene = load("letter-f")
    drawing = opened(off_screen(*LARGE), "letter-f")
    drawing.show_projection(replace(scene.start, lens=scene.start.lens.replaced(far=far)))
    reach = drawing.state.volume.depths
    corner = np.array((-1.5, 0.0, -0.5)) - scene.start.camera.eye
    assert reach.high == pytest.approx(1.5 * float(-corner @ scene.start.camera.frame[2]))
    assert (reach.far_break is not None) == is_broken
    assert reach.far == pytest.approx(min(far, reach.high))


def test_every_handle_is_at_least_ten_pixels_across_and_larger_when_held(
    off_screen: MakeScreen,
) -> None:
    """It is measured by the pixels that it changes: on paper its ring is not seen."""
    screen = off_screen(*LARGE)
    drawing = opened(screen, "letter-f")
    with_marks = screen.pixels().astype(int)
    drawing.show_layers(frozenset({"handles"}))
    without = screen.pixels().astype(int)
    drawing.show_layers(frozenset())
    changed = (with_marks != without).any(axis=-1)
    shown = dict(drawing.handles.shown)
    assert {handle.name for handle in shown} == {"eye", "target", "near", "far", "corner"}
    for handle, (x, y) in shown.items():
        around = changed[int(y) - 9 : int(y) + 10, int(x) - 9 : int(x) + 10]
        assert max(extent_px(around)) >= 10, handle
    far = next(handle for handle in shown if handle.name == "far")
    sizes = []
    for held in (None, far):
        drawing.hold(held)
        x, y = (int(part) for part in shown[far])
        part = screen.pixels().astype(int)[y - 16 : y + 17, x - 16 : x + 17]
        sizes.append((part != without[y - 16 : y + 17, x - 16 : x + 17]).any(axis=-1).sum())
    assert sizes[1] > 1.5 * sizes[0]


def test_a_handle_is_set_off_from_what_lies_under_it(off_screen: MakeScreen) -> None:
    """From inside: the plane's colour, and a ring in the background's colour."""
    screen = off_screen(*LARGE)
    drawing = opened(screen, "letter-f")
    image = screen.pixels()
    x, y = next(spot for handle, spot in drawing.handles.shown if handle.name == "near")
    line = image[int(y), int(x) : int(x) + 14]
    runs = [
        tuple(int(part) for part in colour) for colour, _ in itertools.groupby(map(tuple, line))
    ]
    expected = [tuple(to_bytes(colour)) for colour in (LIGHT.near, LIGHT.background)]
    assert [run for run in runs if run in expected][:2] == expected


@pytest.mark.parametrize("name", BUILT_IN)
def test_the_eye_is_named_beside_its_camera(off_screen: MakeScreen, name: str) -> None:
    """The leader may leave the camera's body, which contains the eye."""
    screen = off_screen(*LARGE)
    drawing = opened(screen, name, own=True)
    if "eye" not in boxes_of(screen):
        return
    left, bottom, right, top = boxes_of(screen)["eye"]
    scene = load(name)
    x, y, _ = drawing.own.pane.seen(np.array([scene.start.camera.eye]) - scene.origin)[0]
    away = math.hypot(max(left - x, 0.0, x - right), max(bottom - y, 0.0, y - top))
    assert away < 2.2 * LIGHT.font_size
