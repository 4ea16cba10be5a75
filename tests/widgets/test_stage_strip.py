"""The stage strip: slider, keys and play in the real window, and what is drawn at every stop."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QStyle, QStyleOptionSlider

from app.document.settings import set_values
from app.drawings import WORDS
from app.drawings.stage import StageDrawing
from app.drawings.style import DARK, LIGHT, Style, rgb
from app.lecture import stages
from app.lecture.stages import IMAGE, NDC, STOPS, VIEW, WORLD, Morph, morph_of
from app.lecture.typed_matrix import with_cell
from app.model.projection import DEPTH_RANGES, Lens, Perspective
from app.scenes.scene import load
from tests.support.drawings import OffScreen, labels_of, rendered
from tests.support.lenses import LENSES
from tests.support.window import activate, move_mouse, picture, present, settle  # fmt: skip
from widgets.panes import stage_strip
from widgets.panes.stage_strip import CATCH, REST_S, STEP_S, STEPS, StageStrip
from widgets.window.main_window import MainWindow

Pixels = NDArray[np.uint8]
CENTRAL, ENDLESS = LENSES["perspective"], LENSES["infinite"]
OFF_AXIS, PARALLEL = LENSES["frustum"], LENSES["oblique"]


class Shown:
    """An NDC drawing of the letter F, off screen."""

    def __init__(self, size: tuple[int, int] = (320, 300), style: Style = LIGHT) -> None:
        self.plotter = OffScreen(*size)
        self.scene = load("letter-f")
        self.drawing = StageDrawing(self.plotter, self.scene, WORDS, style)
        self.drawing.show_names(None)
        self.drawing.show_projection(self.scene.start)

    def pixels(self, position: float | None = None) -> Pixels:
        """Render once, at a position if one is given."""
        if position is not None:
            self.drawing.show_stage(position)
        return rendered(self.plotter.render_window)


@pytest.fixture
def shown() -> Iterator[Callable[..., Shown]]:
    made: list[Shown] = []

    def make(*args: object) -> Shown:
        made.append(Shown(*args))  # type: ignore[arg-type]
        return made[-1]

    yield make
    for each in made:
        each.drawing.remove()
        each.plotter.close()


def lit(pixels: Pixels, colour: str) -> NDArray[np.bool_]:
    """The pixels of a colour."""
    wanted = np.round(np.array(rgb(colour)) * 255.0)
    close: NDArray[np.bool_] = (np.abs(pixels.astype(int) - wanted) <= 3).all(axis=-1)
    return close


# -- the drawing


@pytest.mark.parametrize("lens", [ENDLESS, PARALLEL], ids=["endless", "parallel"])
def test_back_at_ndc_every_pixel_is_as_before(lens: Lens, shown: Callable[..., Shown]) -> None:
    screen = shown()
    screen.drawing.show_projection(replace(screen.scene.start, lens=lens))
    before = screen.pixels()
    pictures = [screen.pixels(position) for position in (0.0, 0.6, 1.0, 1.2, 2.0, 2.5, 3.0, 5.0)]
    assert all((picture != before).any() for picture in pictures)
    assert np.array_equal(screen.pixels(float(NDC)), before)


@pytest.mark.parametrize(
    ("lens", "style"),
    [(CENTRAL, LIGHT), (ENDLESS, DARK), (OFF_AXIS, LIGHT.enlarged(1.6)), (PARALLEL, LIGHT)],
    ids=["light", "dark", "big", "parallel"],
)
def test_the_scene_is_in_the_pane_at_every_stop(
    lens: Lens, style: Style, shown: Callable[..., Shown]
) -> None:
    """The letter's faces are visible, and do not touch the border."""
    screen = shown((320, 460), style)
    screen.drawing.show_projection(replace(screen.scene.start, lens=lens))
    for position in (0.0, 1.0, 2.0, 3.0, 4.0, 5.0):
        pixels = screen.pixels(position)
        saturated = pixels.max(axis=-1).astype(int) - pixels.min(axis=-1) > 60
        assert saturated.sum() > 50, position
        border = np.concatenate([saturated[0], saturated[-1], saturated[:, 0], saturated[:, -1]])
        if lens.far < math.inf:
            assert not border.any(), position


def test_in_a_low_pane_of_large_letters_the_cube_is_not_small(shown: Callable[..., Shown]) -> None:
    """As while presenting; it had 0.40 of the height when the labels' margins took half of it."""
    style, height = LIGHT.enlarged(17.0 / LIGHT.font_size), 126
    screen = shown((480, height), style)
    screen.drawing.show_layers(frozenset({"labels"}))
    screen.pixels(float(NDC))
    screen.drawing.show_projection(screen.scene.start)
    edges = lit(screen.pixels(), style.far) | lit(screen.pixels(), style.near)
    rows, _ = np.nonzero(edges)
    assert np.ptp(rows) > 0.55 * height and rows.min() > 0 and rows.max() < height - 1


def test_at_the_image_stop_the_cube_is_the_picture(shown: Callable[..., Shown]) -> None:
    """The letter F is where `trace` puts it in the rectangle of the picture."""
    screen = shown((400, 300))
    projection = screen.scene.start
    pixels = screen.pixels(float(IMAGE))
    frame = lit(pixels, LIGHT.u)  # the arrow along the picture's top edge
    rows, columns = np.nonzero(frame)
    top, left = int(np.median(rows)), int(columns.min())
    right_edge = lit(pixels, LIGHT.near)
    right = int(np.nonzero(right_edge)[1].max())
    scale = (right - left) / projection.image_size[0]
    # Middles of the letter's faces: what covers most of the picture.
    assert scale > 0.1
    points = np.array([(0.0, 2.2, 0.0), (0.5, 4.5, 0.5)])
    for x, y in projection.trace(points).image:
        column, row = round(left + scale * x), round(top + scale * y)
        around = pixels[row - 4 : row + 5, column - 4 : column + 5].astype(int)
        assert (around.max(axis=-1) - around.min(axis=-1) > 60).any(), (x, y)


@pytest.mark.parametrize(("position", "lens"), [(2.0, CENTRAL), (3.0, PARALLEL)])
def test_l9_a_canonical_volume_fills_its_pane(
    position: float, lens: Lens, shown: Callable[..., Shown]
) -> None:
    """With the labels of near and far it is as high as the pane under the title."""
    screen = shown((580, 600))
    screen.pixels(position)
    screen.drawing.show_projection(replace(screen.scene.start, lens=lens))
    rows, columns = np.nonzero(lit(screen.pixels(), LIGHT.far) | lit(screen.pixels(), LIGHT.near))
    assert 0.8 < (rows.max() - rows.min()) / 600 < 0.95
    assert rows.min() > 20 and rows.max() < 580 and columns.min() > 10 and columns.max() < 570


def test_the_scene_is_whole_until_the_volume_closes(shown: Callable[..., Shown]) -> None:
    """The frustum holds nothing of the letter: first all of it is visible, then none."""
    screen = shown((600, 600))
    away = replace(screen.scene.start, lens=Perspective(45.0, 25.0, 30.0))
    screen.drawing.show_projection(away)

    def letter(position: float) -> int:
        return int(lit(screen.pixels(position), "#e69f00").sum())

    assert letter(WORLD) > 20
    assert letter(VIEW) > 20
    assert letter(1.5) == letter(2.0) == letter(2.5) == letter(3.0) == 0


def test_nothing_is_smeared_when_the_eye_goes_to_infinity(shown: Callable[..., Shown]) -> None:
    """The ground grid passes under the eye: behind it, its lines would cross the whole pane."""
    screen = shown()
    camera = replace(screen.scene.start.camera, eye=(0.3, 2.0, 0.2), target=(0.0, 2.0, -5.0))
    screen.drawing.show_projection(
        replace(screen.scene.start, camera=camera, lens=Perspective(60.0, 0.05, 30.0))
    )
    for position in np.linspace(2.0, 3.0, 9):
        pixels = screen.pixels(float(position))
        drawn = (pixels != pixels[0, 0]).any(axis=-1)
        assert not drawn[:3].any()
        assert not drawn[-3:].any()


def test_letters_and_limits_are_the_stops_own(shown: Callable[..., Shown]) -> None:
    screen = shown()
    texts = (
        {"x", "y", "z", "u⃗", "v⃗", "n⃗", "near", "far"},
        {"u⃗", "v⃗", "n⃗", "near", "far"},
        {"x", "y", "z", "far", "−1", "1", "near −0.4"},
        {"x", "y", "z", "near", "far", "−1", "1", "0"},
        {"x", "y", "z", "near −1", "far +1", "−1", "1"},
        {"x", "y", "0", "1280", "720"},
    )
    for start, stop in product(range(len(STOPS)), repeat=2):
        screen.drawing.show_stage(float(start))
        screen.drawing.show_stage(float(stop))
        written = set(labels_of(screen.plotter.renderer))
        assert written == texts[stop], (start, stop)


def test_a_pane_that_was_turned_stays_turned(shown: Callable[..., Shown]) -> None:
    screen = shown()
    camera = screen.plotter.renderer.GetActiveCamera()
    screen.drawing.show_stage(3.0)
    framed = camera.GetPosition()
    screen.drawing.show_stage(5.0)
    assert camera.GetPosition() != framed  # nobody turned it: it faces the picture
    camera.Azimuth(12.0)
    turned = camera.GetPosition()
    for position in (4.0, 2.5, 0.0):
        screen.drawing.show_stage(position)
        assert camera.GetPosition() == turned
    screen.drawing.reset_view()
    assert camera.GetPosition() != turned


def test_at_ndc_no_other_stage_is_computed(
    shown: Callable[..., Shown], monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[Morph] = []

    def counted(*args: Any) -> Morph:
        made.append(morph_of(*args))
        return made[-1]

    screen = shown()
    monkeypatch.setattr(stages, "morph_of", counted)
    for far in (30.0, 31.0):
        screen.drawing.show_projection(
            replace(screen.scene.start, lens=Perspective(45.0, 1.0, far))
        )
    assert not made
    for position in (0.0, 0.5, 1.0, 5.0):
        screen.drawing.show_stage(position)
    assert len(made) == 1  # one per projection, however far the strip is moved


def test_at_ndc_the_cube_waits_for_another_depth_range(shown: Callable[..., Shown]) -> None:
    screen = shown()
    drawing, start = screen.drawing, screen.scene.start
    other_lens = replace(start, lens=Perspective(30.0, 2.0, 31.0))
    placed = drawing.box.placed
    drawing.show_projection(other_lens)
    assert drawing.box.placed is placed
    drawing.show_projection(replace(start, depth="direct3d"))
    assert drawing.box.placed is not placed
    drawing.show_stage(2.0)
    placed = drawing.box.placed
    drawing.show_projection(other_lens)
    assert drawing.box.placed is not placed


@pytest.mark.parametrize("depth", ["opengl", "reversed"])
def test_the_heads_of_the_axes_are_as_long_in_half_a_cube(
    depth: Any, shown: Callable[..., Shown]
) -> None:
    """Seen from the left, the blue head of z is as large as in a whole cube."""
    screen = shown((400, 400))
    screen.drawing.show_projection(replace(screen.scene.start, depth=depth))
    camera = screen.plotter.renderer.GetActiveCamera()
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(-10.0, 0.0, 0.0)
    camera.SetParallelScale(1.6)
    screen.drawing.reset_clipping_range()
    screen.drawing.show_layers(frozenset({"labels"}))  # a letter may lie over it
    start, _, tip = screen.drawing.box.axes[2]
    z_near, z_far = DEPTH_RANGES[depth]
    assert abs(tip[2] - start[2]) == pytest.approx(0.28 * abs(z_far - z_near))
    pixels_per_unit = 400 / 3.2
    column, row = round(200.0 + pixels_per_unit * tip[2]), round(200.0 - pixels_per_unit * tip[1])
    # The head ends at the tip, and reaches 0.14 back from it.
    head = lit(screen.pixels(), LIGHT.n)[row - 6 : row + 7, column - 24 : column + 25]
    long = (head.sum(axis=0) > 4).sum()  # the shaft is thinner
    assert 0.05 * pixels_per_unit < long < 0.12 * pixels_per_unit


def test_a_step_of_the_strip_touches_no_actor(shown: Callable[..., Shown]) -> None:
    screen = shown()
    actors = screen.plotter.renderer.GetActors()
    meshes = [actor.GetMapper().GetInput() for actor in actors]
    times = [mesh.GetMTime() for mesh in meshes]
    for position in np.linspace(0.0, 5.0, 21):
        screen.drawing.show_stage(float(position))
    assert [mesh.GetMTime() for mesh in meshes] == times
    assert screen.plotter.renderer.GetActors().GetNumberOfItems() == len(meshes)


# -- the window


@pytest.mark.undrawn
def test_arrow_keys_go_from_stop_to_stop(window: MainWindow) -> None:
    strip, key = window.strip, Qt.Key
    seen: list[float] = []
    strip.moved.connect(seen.append)
    for pressed in (key.Key_Right, key.Key_Right, key.Key_Left, key.Key_Down, key.Key_Home):
        QTest.keyClick(strip.slider, pressed)
    assert seen == [5.0, 4.0, 3.0, 0.0]  # right of the last stop there is none
    QTest.keyClick(strip.slider, key.Key_PageUp)
    assert 0.0 < strip.position < 0.5
    QTest.keyClick(strip.slider, key.Key_Left)
    assert strip.position == 0.0
    QTest.keyClick(strip.slider, key.Key_PageUp)
    QTest.keyClick(strip.slider, key.Key_Up)
    assert strip.position == 1.0


@pytest.mark.undrawn
def test_a_drag_is_caught_by_the_stops(window: MainWindow) -> None:
    slider = window.strip.slider
    slider.setSliderDown(True)
    for steps, position in (
        (2 * STEPS + CATCH, 2.0),
        (2 * STEPS + CATCH + 1, 2.0 + (CATCH + 1) / STEPS),
        (3 * STEPS - 1, 3.0),
    ):
        slider.setSliderPosition(steps)
        assert window.strip.position == position
        assert slider.value() == position * STEPS
    slider.setSliderDown(False)
    slider.setValue(2 * STEPS + CATCH)  # as the keys do
    assert window.strip.position == 2.0 + CATCH / STEPS


@pytest.mark.undrawn
def test_escape_puts_the_slider_back_and_removes_no_probe(window: MainWindow) -> None:
    before = 1.0 + 0.3 / STEPS
    activate(window)
    window.probe_panel.follow(point=(1.5, 5.0, 0.5))
    strip, slider = window.strip, window.strip.slider
    strip.go_to(before)  # as played, also between the slider's steps
    option = QStyleOptionSlider()
    slider.initStyleOption(option)
    handle = slider.style().subControlRect(
        QStyle.ComplexControl.CC_Slider, option, QStyle.SubControl.SC_SliderHandle, slider
    )
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=handle.center())
    assert slider.isSliderDown()

    middle = QPointF(slider.width() / 2.0, handle.center().y())
    move_mouse(slider, middle + QPointF(9.0, 0.0))
    assert strip.position != before
    QTest.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_Escape)
    assert strip.position == before
    move_mouse(slider, middle + QPointF(19.0, 0.0))
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=handle.center())
    assert strip.position == before and len(window.probe_panel.probes) == 1
    QTest.keyClick(slider, Qt.Key.Key_Escape)
    assert window.probe_panel.probes == ()  # the slider is let go of


@pytest.mark.undrawn
def test_a_name_goes_to_its_stop_and_the_header_says_so(window: MainWindow) -> None:
    pane, wanted = window.panes["ndc"], {
        0: ("World", "x, y, z in world units"),
        1: ("View", "u, v, n in world units"),
        2: ("Canonical perspective", "x, y ±1, z −n/f = −0.4 … −1"),
        3: ("Canonical parallel", "x, y ±1, z 0 … −1"),
        4: ("NDC cube", "x, y ±1, z −1 … 1"),
        5: ("Image", "1280 × 720 pixels, y down"),
    }  # fmt: skip
    for stop, (title, note) in wanted.items():
        QTest.mouseClick(window.strip.stops[stop], Qt.MouseButton.LeftButton)
        assert (window.strip.position, pane.title.text()) == (stop, title)
        assert window.panes["ndc"].note.text() == note
    window.strip.go_to(2.0)
    window.strip.play()
    QTest.mouseClick(window.strip.stops[2], Qt.MouseButton.LeftButton)  # where it stands
    assert not window.strip.playing
    window.strip.go_to(2.5)
    assert pane.title.text() == "Pyramid → Box"
    window.strip.go_to(2.0)
    start = window.store.document.projection
    window.store.set_projection(replace(start, lens=replace(start.lens, far=math.inf)))
    assert window.panes["ndc"].note.text() == "near z −1, far −∞ (scaled by 1/n)"


@pytest.mark.undrawn
def test_the_stops_of_a_parallel_lens_are_named_what_they_are(window: MainWindow) -> None:
    """It has no pyramid; where nothing moves, the note says that M_pp is the identity."""
    strip, pane, start = window.strip, window.panes["ndc"], window.store.document.projection
    window.store.set_projection(start.with_lens("orthographic"))
    names = [button.text() for button in strip.stops]
    assert names == ["World", "View", "Box", "Mₚₚ", "NDC", "Image"]
    assert "identity" in strip.stops[3].toolTip()
    limits = "x, y ±1, z 0 … −1"
    for position, title, words in (
        (1.75, "View → Box", limits),
        (2.0, "Canonical parallel", f"{limits}; Mₚₚ: identity"),
        (2.25, "Canonical parallel", f"{limits}; Mₚₚ: identity"),
        (2.75, "Canonical parallel", f"{limits}; Mₚₚ: identity"),
        (3.0, "Canonical parallel", f"{limits}; Mₚₚ: identity"),
        (3.25, "Box → NDC", limits),
    ):
        strip.go_to(position)
        assert (pane.title.text(), pane.note.text()) == (title, words), position
    window.store.set_projection(start)
    assert [button.text() for button in strip.stops][1:4] == ["View", "Pyramid", "Box"]


@pytest.mark.undrawn
def test_a_typed_matrix_goes_from_the_view_to_the_cube_without_volumes(window: MainWindow) -> None:
    strip, pane, start = window.strip, window.panes["ndc"], window.store.document.projection
    for typed, title, words in (
        (True, "View → NDC", "no canonical volumes"),
        (False, "Pyramid → Box", "x, y ±1, z 0 … −1"),
    ):
        free = with_cell(start, "clip_from_view", 3, 0, 0.1)
        window.store.set_projection(free if typed else start)
        strip.go_to(2.5)
        assert (pane.title.text(), pane.note.text()) == (title, words)
    strip.go_to(1.0)
    assert pane.note.text() == "u, v, n in world units"
    window.store.set_projection(free)
    assert pane.note.text() == "x, y, z of view space"


@pytest.mark.undrawn
def test_the_text_about_a_stage_is_fully_visible_and_moves_nothing(window: MainWindow) -> None:
    window.resize(1366, 768)
    start, words, heights = window.store.document.projection, window.panes["ndc"].note, set()
    for lens in (ENDLESS, PARALLEL, replace(CENTRAL, near=0.00123)):
        window.store.set_projection(replace(start, lens=lens))
        for half in range(2 * IMAGE + 1):
            window.strip.go_to(half / 2.0)
            settle()
            assert QLabel.text(words) == words.text()
            heights.add((words.height(), window.panes["ndc"].canvas.height()))
    assert len(heights) == 1


def test_a_new_drawing_stands_where_the_strip_is(window: MainWindow) -> None:
    window.look.set_theme("light")
    window.strip.go_to(5.0)
    settle()
    light = picture(window.panes["ndc"].canvas)
    window.look.set_theme("dark")
    settle()
    assert picture(window.panes["ndc"].canvas) != light
    window.look.set_theme("light")
    settle()
    assert picture(window.panes["ndc"].canvas) == light


@pytest.mark.undrawn
def test_the_strips_framing_is_no_turn_by_the_user(window: MainWindow) -> None:
    window.strip.go_to(0.0)
    settle()
    assert window.store.seen.view.panes == {}


@pytest.mark.undrawn
def test_play_runs_to_the_picture_resting_at_each_stop(window: MainWindow) -> None:
    strip = window.strip
    strip.go_to(5.0)
    seen: list[float] = []
    strip.moved.connect(seen.append)
    QTest.mouseClick(strip.button, Qt.MouseButton.LeftButton)
    assert strip.playing
    assert seen == [0.0]  # from the end, all of it
    strip.advance(STEP_S / 2.0)
    assert strip.position == 0.5
    strip.advance(STEP_S / 2.0)
    assert strip.position == 1.0
    strip.advance(REST_S / 2.0)
    assert strip.position == 1.0
    strip.advance(REST_S / 2.0 + STEP_S / 4.0)
    assert strip.position == pytest.approx(1.25)
    QTest.mouseClick(strip.button, Qt.MouseButton.LeftButton)
    assert not strip.playing
    strip.advance(1.0)
    assert strip.position == pytest.approx(1.25)
    strip.play()
    strip.advance(100.0)
    assert strip.position == IMAGE
    assert not strip.playing
    assert set(range(6)) <= set(seen)


@pytest.mark.undrawn
@pytest.mark.parametrize("floats", [False, True])
def test_play_goes_on_in_another_scene(window: MainWindow, floats: bool) -> None:
    """It would stand between two stops."""
    strip, before = window.strip, window.store.document.scene
    if floats:
        window.slots.toggle_float("ndc")
    strip.go_to(0.0)
    strip.play()
    strip.advance(STEP_S / 2.0)
    window.guide.choose("off-axis-window")
    settle()
    assert window.store.document.scene == "off-axis-window" != before
    assert strip.playing and 0.5 <= strip.position < 1.0


@pytest.mark.undrawn
def test_play_moves_by_itself_and_a_hand_or_a_hidden_pane_stops_it(
    window: MainWindow, qtbot: object
) -> None:
    strip: StageStrip = window.strip
    strip.go_to(0.0)
    strip.play()
    qtbot.waitUntil(lambda: strip.position > 0.05)  # type: ignore[attr-defined]
    strip.slider.setValue(3 * STEPS)
    assert not strip.playing
    assert strip.position == 3.0
    strip.play()
    window.slots.make_large("world")
    assert not strip.playing


def test_near_and_far_are_written_in_the_pane_all_the_way(window: MainWindow) -> None:
    window.resize(1920, 1080)
    present(window)
    start, cut = window.store.document.projection, []
    for near, far in ((5.0, 20.0), (12.0, 14.0), (1.0, math.inf)):
        window.store.set_projection(replace(start, lens=Perspective(45.0, near, far)))
        for quarter in range(4 * VIEW, 4 * NDC + 1):
            window.strip.go_to(quarter / 4)
            QApplication.processEvents()
            drawing = window.panes["ndc"].drawing
            assert isinstance(drawing, StageDrawing)
            for label in (drawing.box.near, drawing.box.far):
                if label.actor.GetVisibility():
                    canvas = window.panes["ndc"].canvas
                    left, right, bottom, top = label.box_px
                    width, height = canvas.render_window.GetSize()
                    if left < 0.0 or bottom < 0.0 or right > width or top > height:
                        cut.append((near, far, quarter / 4, label.text))
    assert not cut, cut


def test_the_moves_of_the_object_are_stops_before_the_world(window: MainWindow) -> None:
    """Each shows the object after its first moves, read from either end, and both end alike."""
    strip = window.strip
    assert strip.first == WORLD and strip.direction.isHidden()
    chain = "object.chain=translate 2,0,0; rotate z 90; off mirror x"
    window.store.set_document(set_values(window.store.document, [chain]))
    assert all(button.isVisible() for button in strip.stops), "the first picture leaves them room"
    settle()
    assert [button.text() for button in strip.stops][:4] == ["Object", "Rz", "World", "View"]
    places = {}
    for turned in (False, True):
        for stop in (-2.0, -1.0, 0.0):
            strip.go_to(stop)
            settle()
            shown = window.panes["world"].drawing.state
            places[turned, stop] = shown.projection.placement.text
            assert bool(shown.ghosts) == (stop < 0.0)
        assert places[turned, 0.0] == "translate 2,0,0; rotate z 90; off mirror x"
        strip.direction.click()
    assert (places[False, -1.0], places[True, -1.0]) == ("rotate z 90", "translate 2,0,0")
    assert places[False, -2.0] == places[True, -2.0] == ""
    strip.go_to(-1.0)
    settle()
    world = window.panes["world"].drawing
    assert not {handle.name for handle, _ in world.handles.shown} & {"object"}
    window.probe_panel.follow(point=(2.0, 1.0, 0.0))  # on the object at (1, 0, 0)
    settle()
    (probe,) = world.state.probes
    assert probe.point == pytest.approx((0.0, 1.0, 0.0))
    window.store.set_document(set_values(window.store.document, ["object.chain="]))
    strip.go_to(float(NDC))
    settle()
    assert strip.first == WORLD and len(strip.stops) == len(STOPS)


@pytest.mark.undrawn
def test_a_hyphen_of_a_word_is_no_minus(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(stage_strip, "tile_title", lambda kind, numbers: f"z-telje {numbers}°")
    chain = "object.chain=translate 2,0,0; rotate z -20"
    window.store.set_document(set_values(window.store.document, [chain]))
    window.strip.go_to(-1.0)
    assert window.strip.slider.accessibleDescription().endswith("z-telje  \u221220°")
