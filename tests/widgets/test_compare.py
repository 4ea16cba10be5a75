"""Comparing a held picture with the live one, and the lectures' own comparisons."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtTest import QTest

from app.document.compare import ComparedPicture
from app.document.files import read
from app.document.settings import compared, set_values
from app.document.view import View
from app.model.projection import Projection
from app.picking.picking import Probe
from app.scenes.scene import load
from tests.support.window import (
    LEFT,
    MakeWindow,
    activate,
    click,
    counted_repaints,
    picture,
    present,
    rgb_of,
    seen,
    settle,
    show_scene,
)
from widgets.panes.pane import Pane
from widgets.window.main_window import MainWindow


def hold(window: MainWindow) -> Any:
    """Hold the picture with the button of its pane, and return the `Compare`."""
    click(window.comparing.button)
    return window.comparing.pictures


def change(window: MainWindow, **lens: float) -> Projection:
    """Change the lens, as a control would."""
    projection = seen(window, lens=window.store.document.projection.lens.replaced(**lens))
    window.store.set_projection(projection)
    settle()
    return projection


def surface_of(window: MainWindow) -> np.ndarray:
    """The pixels of all pictures in the image pane."""
    pane = window.panes["image"]
    settle()
    whole = rgb_of(pane.grab().toImage())
    at = pane.surface.geometry()
    return whole[at.top() : at.bottom() + 1, at.left() : at.right() + 1]


def words(window: MainWindow) -> str:
    """The text about the differences."""
    return str(window.comparing.pictures.words.toolTip())


def test_the_held_picture_is_left_of_the_divider_and_the_live_one_right(window: MainWindow) -> None:
    window.slots.make_large("image")
    settle()
    compare = hold(window)
    held = window.store.document.projection
    assert window.comparing.button.isChecked() and compare.bar.isVisible()
    change(window, near=8.0, fov_y_deg=60.0)
    both = surface_of(window)
    x = compare.handles[0].geometry().center().x()
    window.slots.arrange("pictures", "image")
    rows = slice(30, both.shape[0])  # below the titles
    live = rgb_of(picture(window.panes["image"].canvas))
    assert (both[rows, x + 10 :] == live[rows, x + 10 :]).all()
    live_left = live[rows, : x - 10]
    window.store.set_projection(held)
    settle()
    alone = rgb_of(picture(window.panes["image"].canvas))
    assert (both[rows, : x - 10] == alone[rows, : x - 10]).all()
    assert (alone[rows, : x - 10] != live_left).any(), "else it is seen by no pixel"
    assert words(window).startswith("held:  no difference"), "it shows the same again"


@pytest.mark.undrawn
def test_what_differs_is_said_in_words(window: MainWindow) -> None:
    hold(window)
    assert words(window) == "held:  no difference yet: change something"
    change(window, near=8.0, fov_y_deg=60.0)
    named = "field of view 38° | field of view 60°"
    assert words(window) == f"{named}:  field of view 38° → 60°, near 5 → 8"
    captions = [caption.text() for caption in window.comparing.pictures.captions]
    assert captions == named.split(" | ")
    window.store.set_projection(seen(window, image_size=(720, 720)))
    settle()
    assert "image 1280 × 720 → 720 × 720" in words(window)
    window.store.set_projection(window.store.document.projection.with_lens("orthographic"))
    settle()
    assert "lens perspective → orthographic" in words(window)


@pytest.mark.smooth
def test_a_held_picture_is_pixels_and_what_follows_is_drawn_once_a_step(window: MainWindow) -> None:
    compare = hold(window)
    change(window, near=5.0)
    drawn: list[str] = []

    def count(other: Any, name: str) -> None:
        canvas = other.pane.canvas
        canvas.render_window.AddObserver("EndEvent", lambda *_: drawn.append(name))

    count(compare.others[0], "held")
    window.store.begin_gesture()
    with counted_repaints(window) as counts:
        for step in range(3):
            change(window, near=5.5 + step)
    window.store.end_gesture()
    settle()
    assert counts["image"] == 3 and drawn == []
    compare.show((ComparedPicture(changes=("lens.near=2",)), ComparedPicture(live=True)), ())
    compare.refresh()
    settle()
    count(compare.others[0], "follows")
    with counted_repaints(window) as counts:
        for step in range(3):
            change(window, far=20.0 + step)
    assert counts["image"] == 3 and drawn == ["follows"] * 3


def test_the_pixels_are_made_anew_for_another_size_and_another_theme(window: MainWindow) -> None:
    compare = hold(window)
    change(window, near=8.0)

    def picture_of_held() -> np.ndarray:
        settle()
        return rgb_of(picture(compare.others[0].pane.canvas))

    light = picture_of_held()
    window.look.set_theme("dark")
    dark = picture_of_held()
    assert dark.shape == light.shape and dark.mean() < light.mean() / 2
    window.look.set_theme("light")
    assert (picture_of_held() == light).all()
    window.resize(window.size() - QSize(120, 60))
    small = picture_of_held()
    assert small.shape[0] < light.shape[0]
    assert small.shape == rgb_of(picture(window.panes["image"].canvas)).shape


def test_the_divider_is_dragged_and_goes_by_keys_as_far_as_the_picture(window: MainWindow) -> None:
    activate(window)
    compare = hold(window)
    (handle,) = compare.handles
    middle = handle.geometry().center()
    QTest.mousePress(handle, LEFT, pos=QPoint(handle.width() // 2, 60))
    QTest.mouseMove(handle, QPoint(handle.width() // 2 - 80, 60))
    QTest.mouseRelease(handle, LEFT, pos=QPoint(handle.width() // 2, 60))
    settle()
    assert abs(handle.geometry().center().x() - (middle.x() - 80)) <= 2
    assert compare.others[0].width() == handle.geometry().center().x()
    place = compare.dividers[0]
    handle.setFocus()
    QTest.keyClick(handle, Qt.Key.Key_Right)
    assert compare.dividers[0] == pytest.approx(place + 0.02)
    QTest.keyClick(handle, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert compare.dividers[0] == pytest.approx(place + 0.018)
    QTest.keyClick(handle, Qt.Key.Key_End)
    assert compare.dividers == (1.0,)
    QTest.keyClick(handle, Qt.Key.Key_Right)
    assert compare.dividers == (1.0,)
    QTest.keyClick(handle, Qt.Key.Key_Home)
    assert compare.dividers == (0.0,)
    QTest.keyClick(handle, Qt.Key.Key_Escape)
    settle()
    assert not window.comparing.pictures.is_on
    assert not handle.isVisible() and not compare.bar.isVisible()


@pytest.mark.undrawn
def test_a_divider_goes_no_farther_than_the_next_one(window: MainWindow) -> None:
    near, far = (ComparedPicture(changes=(f"lens.near={near}",)) for near in (2, 3))
    compare = window.comparing.pictures
    compare.show((near, ComparedPicture(live=True), far), (0.25, 0.5))
    first, second = compare.handles
    QTest.keyClick(first, Qt.Key.Key_End)
    assert compare.dividers == (0.5, 0.5)
    QTest.keyClick(second, Qt.Key.Key_End)
    QTest.keyClick(first, Qt.Key.Key_Right)
    QTest.keyClick(second, Qt.Key.Key_Home)
    assert compare.dividers == pytest.approx((0.52, 0.52))


def test_keys_hold_toggle_and_end_a_comparison_without_undo_steps(window: MainWindow) -> None:
    activate(window)
    large = window.slots.large
    QTest.keyClick(window, Qt.Key.Key_F6)
    compare = window.comparing.pictures
    assert compare.dividers == (0.5,) and window.slots.large == "image"
    QTest.keyClick(window, Qt.Key.Key_F6, Qt.KeyboardModifier.ShiftModifier)
    assert compare.dividers == () and window.comparing.pictures.is_on
    settle()
    live, held = (pane.canvas for pane in (window.panes["image"], compare.others[0].pane))
    room = window.panes["image"].surface.height()
    assert live.height() + held.height() <= room and live.height() > 0.4 * room
    click(compare.way)
    assert compare.dividers == (0.5,) and live.height() == room
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert not window.comparing.pictures.is_on and window.slots.large == large
    assert not window.store.can_undo and not window.store.modified
    assert compare.others == []


def test_only_the_live_side_reacts_to_the_mouse(window: MainWindow) -> None:
    hold(window)
    before = window.store.document
    change(window, fov_y_deg=40.0)
    compare, pane = window.comparing.pictures, window.panes["image"]
    (other,) = compare.others
    # On the F, right of the divider.
    ((x, y_px),) = pane.drawing.sight.seen([[1.5, 4.5, 0.5]]).tolist()
    QTest.mouseClick(window.windowHandle(), LEFT,
                     pos=pane.canvas.mapTo(window, QPoint(round(x), round(y_px))))  # fmt: skip
    settle()
    assert len(window.probe_panel.probes) == 1
    place = other.mapTo(window, QPoint(other.width() - 30, pane.surface.height() // 2))
    for act in (QTest.mouseClick, QTest.mouseDClick):
        act(window.windowHandle(), LEFT, pos=place)
        settle()
    assert len(window.probe_panel.probes) == 1 and not window.slots.whole
    assert other.pane.probes == window.probe_panel.probes, "the same point in both"
    assert window.store.document.projection == replace(
        before.projection, lens=before.projection.lens.replaced(fov_y_deg=40.0)
    )


@pytest.mark.undrawn
def test_it_comes_back_from_a_file_and_goes_with_another_scene(
    window: MainWindow, tmp_path: Path
) -> None:
    compare = hold(window)
    change(window, near=8.0)
    compare.handles[0].moved.emit(200.0)
    view = window.store.seen.view
    assert view.compare[0].held is not None and view.dividers != (0.5,)
    assert window.files.save_to(tmp_path / "compared.json")
    assert read(tmp_path / "compared.json").view == view
    there = surface_of(window)
    window.guide.choose("posts")
    settle()
    assert not window.comparing.pictures.is_on and window.store.seen.view.compare == ()
    window.store.undo()
    settle()
    assert window.store.seen.view == view, "undo of the scene brings back how it was looked at"
    window.comparing.end()
    assert window.files.open(tmp_path / "compared.json")
    settle()
    assert window.store.seen.view == view
    assert (surface_of(window) == there).all()


def test_a_window_opens_with_what_is_compared(make_window: MakeWindow) -> None:
    from app.document.document import Document

    document = compared(Document("interpolation", load("interpolation").start), "interpolation")
    window = make_window(document)
    settle()
    compare = window.comparing.pictures
    assert window.comparing.button.isChecked() and len(compare.others) == 1
    assert compare.others[0].shown.document.settings["interpolation"] == "correct"
    held, live = (rgb_of(picture(pane.canvas)) for pane in (compare.others[0].pane,
                                                           window.panes["image"]))  # fmt: skip
    assert held.std() > 20 and held.shape[1] == live.shape[1]
    assert (held[: live.shape[0]] != live[: held.shape[0]]).any()


@pytest.mark.undrawn
def test_an_impossible_picture_is_replaced_by_its_reason(window: MainWindow) -> None:
    compare = hold(window)
    compare.show((ComparedPicture("near 6", ("lens.near=6",)), ComparedPicture(live=True)), ())
    compare.refresh()
    settle()
    assert compare.others[0].shown is not None
    change(window, far=5.0, near=1.0)
    assert compare.others[0].shown is None
    assert compare.others[0].why.isVisible()
    assert compare.others[0].why.text() == "lens.near = 6: must be less than far, which is 5."
    change(window, far=15.0)
    assert compare.others[0].shown is not None and not compare.others[0].why.isVisible()


@pytest.mark.undrawn
def test_the_differences_are_elided_where_two_lines_are_too_narrow(window: MainWindow) -> None:
    compare = hold(window)
    change(window, far=15.0)
    label, said = compare.words, words(window)
    label.resize(70, label.height())
    room = QRect(0, 0, 70, 1 << 20)
    used = label.fontMetrics().boundingRect(room, Qt.TextFlag.TextWordWrap, label.text())
    assert used.height() <= label.height() and label.text().endswith("…")
    assert words(window) == said, "the tooltip has all of it"


def test_pictures_of_two_sizes_are_fitted_and_a_pane_without_room_is_no_harm(
    window: MainWindow,
) -> None:
    compare = hold(window)
    window.store.set_projection(seen(window, image_size=(400, 800)))
    settle()
    assert words(window).endswith(
        "image 1280 × 720 → 400 × 800, different shapes: side by side, at equal heights"
    )
    assert compare.words.text() == words(window), "two lines are enough for that"
    assert not compare.handles[0].isVisible() and not compare.way.isEnabled()
    heights = [
        pane.drawing.picture_rectangle_px.height
        for pane in (window.panes["image"], compare.others[0].pane)
    ]
    assert abs(heights[0] - heights[1]) <= 0.05 * max(heights), "of one height, beside each other"
    image = window.panes["image"]
    image.setMinimumSize(0, 0)
    for size in (QSize(0, 0), QSize(3, 3), QSize(90, 40)):
        image.surface.resize(size)
        settle()
    window.store.set_projection(seen(window, image_size=(640, 360)))
    settle()
    assert compare.handles[0].isVisible() and compare.way.isEnabled(), "of one shape again"


def test_presenting_keeps_it_and_so_does_esc(window: MainWindow) -> None:
    activate(window)
    compare, drawn = window.comparing.pictures, list[bool]()
    compare.drawn.connect(lambda: drawn.append(True))
    window.panes["image"].request("probes", [Probe(1, seen(window).camera.target)])
    hold(window)
    change(window, near=8.0)
    assert drawn, "a question looks for its place again"
    present(window)
    assert compare.others[0].isVisible() and not compare.bar.isVisible()
    assert not window.panes["world"].isVisible()
    assert not window.comparing.button.isVisible()
    assert not compare.others[0].pane.header.isVisible(), "its name is above the picture"
    screen_px = window.screen().size().height()
    compare.toggle_way()
    settle()
    named = [box for boxes, _ in window.slide.named() for box in boxes]
    for caption in compare.captions:
        at = caption.mapTo(window.slide, QPointF())
        assert QRectF(at, caption.size().toSizeF()) in named, "no question hides it"
    for pane in (window.panes["image"], compare.others[0].pane):
        place = pane.drawing.picture_rectangle_px
        middle = place.left + place.width / 2.0, place.top + place.height / 2.0
        at = pane.canvas.mapTo(window.slide, QPointF(*middle))
        assert min((box.center() - at).manhattanLength() for box in named) < 2.0, "the probe's"

    def gaps() -> list[int]:
        """Between each caption and the picture below it."""
        drawing, other = compare.others[0].pane.drawing, compare.others[0]
        top = other.y() + drawing.rectangle_in(other.width(), other.height()).top
        return [top - 1 - caption.geometry().bottom() for caption in compare.captions]

    assert gaps()[0] > 0
    for caption in compare.captions:
        letters = caption.fontMetrics().capHeight()
        assert 0.022 * screen_px <= letters <= 0.03 * screen_px, "a class reads them"
    QTest.keyClick(window, Qt.Key.Key_Escape)
    settle()
    assert window.comparing.pictures.is_on and not window.present.is_on and compare.bar.isVisible()
    assert compare.captions[0].fontMetrics().capHeight() < 0.022 * screen_px
    title, first = window.panes["image"].title, compare.captions[0]
    place = first.mapToGlobal(QPoint()).y(), first.height()
    assert place == (title.mapToGlobal(QPoint()).y(), title.height()), "on the title's line"
    assert gaps()[0] > 0


def test_a_held_world_has_the_grips_of_the_slide_and_no_others(window: MainWindow) -> None:
    window.store.set_view(slide=("world",), controls=("lens.near",), names=("eye", "near"))
    window.present.begin()
    settle()
    hold(window)
    settle()
    pane = window.panes["world"]
    (held,) = (each for each in pane.findChildren(Pane) if each is not pane)
    grips = [{handle.name for handle in each.drawing.handles.drawn} for each in (held, pane)]
    assert grips == [{"near"}, {"near"}]


def test_a_class_compares_worlds_if_the_world_is_the_slide(window: MainWindow) -> None:
    document = set_values(
        window.store.document,
        ["camera.eye=6,5,9", "view.slide=world", "view.large=world", "view.fixed=side",
         "view.names=eye",
         "view.compare=low: camera.eye=6,2,9|high: camera.eye=6,7,9|start: camera.eye=6,5,9"],
    )  # fmt: skip
    assert window.store.open(document, is_work=False)
    settle()
    compare, world, image = window.comparing.pictures, *map(window.panes.get, ("world", "image"))
    assert all(other.parent() is image.surface for other in compare.others)
    present(window)
    settle()
    assert all(other.parent() is world.surface and other.isVisible() for other in compare.others)
    assert [each.text() for each in compare.captions] == ["low", "high", "start"]
    places = sorted([other.geometry() for other in compare.others], key=QRect.left)
    assert {place.height() for place in places} == {world.surface.height()}
    assert places[0].left() == 0 and places[1].left() > places[0].right()
    assert all(caption.isVisible() for caption in compare.captions)
    assert all(each.height() >= each.sizeHint().height() for each in compare.captions), "whole"
    drawings = [other.pane.drawing for other in compare.others]
    assert {drawing.fixed for drawing in drawings} == {"side"}
    heights = {round(float(drawing.camera.box[:, 1].mean())) for drawing in drawings}
    assert len(heights) == 2, "each has a camera of its own"
    turned = set_values(document, ["view.fixed=", "view.panes=world: 1,2,20"])
    assert window.store.open(turned, is_work=False)
    settle()
    for other in compare.others:  # all are seen from the same place
        assert other.pane.view is not None and other.pane.view.eye == pytest.approx((1, 2, 20))
    world.reset_view()
    assert all(other.pane.view is None for other in compare.others)
    window.present.end()
    settle()
    assert all(other.parent() is image.surface for other in compare.others)
    assert window.store.look().compare == document.view.compare


# -- the scenes' own


READY: dict[str, tuple[str, list[str], Callable[[View], bool]]] = {
    "field-of-view": ("29 mm | 105 mm, enlarged 3.3 times:  distance 3 → 36, field of view"
                      " 40.18° → 3.491°", ["29 mm", "105 mm, enlarged 3.3 times"],
                      lambda view: view.compare[0].live),
    "interpolation": ("affine | correct:  interpolation affine: s linear on the screen → correct:"
                      " s/w and 1/w, divided",
                      ["affine", "correct"], lambda view: view.compare[0].live),
    "eye-plane": ("naive | cut | clipped:  picture divided, not cut → cut at z = −0.01 → clipped,"
                  " then divided",
                  ["naive", "cut", "clipped"], lambda view: view.compare[2].live),
    "off-axis-window": ("stretch | keep x | keep y:  proportions stretch → x → y",
                        ["stretch", "keep x", "keep y"], lambda view: view.compare[2].live),
}  # fmt: skip


def test_l7_l16_l18_l20_are_one_click_away_in_their_scenes_and_large(window: MainWindow) -> None:
    for scene, (said, names, is_live) in READY.items():
        show_scene(window, scene)
        window.slots.arrange("pictures", window.slots.leading)
        (button,) = window.controls.card.comparisons
        assert button.text() == " | ".join(names)
        assert button.accessibleName() == f"Compare: {', '.join(names)}"
        click(button)
        compare = window.comparing.pictures
        assert window.slots.large == "image" and words(window) == said
        assert [caption.text() for caption in compare.captions] == names
        assert all(caption.isVisible() for caption in compare.captions), scene
        assert is_live(window.store.seen.view)
        widths = [other.width() for other in compare.others]
        assert all(width > window.panes["image"].surface.width() / 4 for width in widths)
        live = window.panes["image"].canvas.size()
        for other in compare.others:  # all as large as the live one
            assert (
                abs(other.width() - live.width()) <= 1 and abs(other.height() - live.height()) <= 1
            )
        edits = scene in ("eye-plane", "off-axis-window")
        assert window.store.modified == edits, "else the document is one of the pictures already"


@pytest.mark.undrawn
def test_a_ready_comparison_ends_with_the_picture_from_before(window: MainWindow) -> None:
    show_scene(window, "two-eyes")
    before = window.store.document
    for edit, goes_back in (({}, True), ({"separation": 0.5}, False)):
        window.comparing.begin("cameras")
        assert window.store.document != before
        window.store.set_settings(edit)
        compared = window.store.document
        window.comparing.end()
        assert window.store.document == (before if goes_back else compared)


@pytest.mark.undrawn
def test_a_comparison_ends_as_it_began_whatever_was_compared_before(window: MainWindow) -> None:
    show_scene(window, "two-eyes")
    window.slots.arrange("pictures", "world")
    window.comparing.begin("cameras")
    compared = window.store.document
    window.comparing.end()
    assert window.store.document != compared and window.slots.large == "world"
    window.store.undo()
    assert window.store.document == compared
    window.slots.arrange("pictures", "image")
    window.comparing.toggle()
    window.comparing.toggle()
    assert window.store.document == compared and window.slots.large == "image"
