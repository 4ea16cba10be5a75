"""The way between two steps: cameras move with the model, pictures fade, nothing is left over."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QRect
from pytestqt.qtbot import QtBot

from app.drawings.pane_view import Pose
from app.lessons.contents import CONTENT
from app.model.projection import Perspective
from tests.support.lessons import lesson_of
from tests.support.window import MakeWindow, activate, arrive, pixels, present, seen, settle, tick
from widgets.panes import adaptive
from widgets.window.lessons import TRANSITION_S
from widgets.window.main_window import MainWindow

TALK = lesson_of(
    "scene=letter-f\nview.fixed=side",
    "view.fixed=top",
    "view.fixed=\ncamera.eye=2,6,12",
    "scene=similar-triangles\nview.controls=settings.distance",
    "scene=letter-f\nview.slide=image",
    "view.slide=ndc\nlens.near=2",
    "view.compare=near: lens.near=2|nearer: lens.near=1\nview.stage=box",
    "view.slide=kinds\nview.compare=",
)


@pytest.fixture
def window(window: MainWindow, talk: Path) -> MainWindow:
    """Presenting a talk at its first step, as far as the system is asked with motion."""
    window.settings.speaker_window = False
    window.settings.reduce_motion = False
    assert window.lessons.open(talk)
    activate(window)
    present(window, QRect(0, 0, 1366, 768))  # quickly drawn
    return window


def camera_of(window: MainWindow) -> np.ndarray:
    """Place and focus of the world pane's own camera."""
    camera = window.panes["world"].canvas.renderer.GetActiveCamera()
    scale = camera.GetParallelScale() if camera.GetParallelProjection() else 0.0
    return np.array([*camera.GetPosition(), *camera.GetFocalPoint(), *camera.GetViewUp(), scale])


def old_of(window: MainWindow) -> Any:
    """The picture of the step before, over the slide."""
    return next(each for each in window.slide.children() if type(each).__name__ == "_Old")


def light_of(window: MainWindow) -> float:
    """How much of the labels is seen in the world pane."""
    props = window.panes["world"].canvas.renderer.GetViewProps()
    lights = {prop.GetProperty().GetOpacity() for prop in props if hasattr(prop, "label")}
    assert len(lights) == 1
    return float(lights.pop())


def test_the_pane_camera_moves_and_arrives_where_it_would_stand_at_once(window: MainWindow) -> None:
    begun = camera_of(window)
    window.settings.reduce_motion = True
    assert window.lessons.go(1) and not window.lessons.is_moving
    settle()
    wanted, picture = camera_of(window), pixels(window)
    assert window.lessons.go(0)
    settle()
    np.testing.assert_allclose(camera_of(window), begun, atol=1e-9)
    window.settings.reduce_motion = False
    assert window.lessons.go(1) and window.lessons.is_moving
    np.testing.assert_allclose(camera_of(window), begun, atol=1e-6)
    tick(window.lessons, TRANSITION_S / 2.0)
    halfway = camera_of(window)
    assert np.abs(halfway - begun).max() > 0.5 and np.abs(halfway - wanted).max() > 0.5
    arrive(window.lessons)
    settle()
    np.testing.assert_allclose(camera_of(window), wanted, atol=1e-9)
    assert (pixels(window) == picture).all()
    assert not window.lessons.is_away and window.panes["world"].view is None


def test_the_pane_rests_where_it_would_without_motion(
    make_window: MakeWindow, qtbot: QtBot
) -> None:
    """After what a prediction shows, a step that ended another early, and a change of size."""
    window = make_window()
    lessons = window.lessons

    def rests() -> Iterator[np.ndarray]:
        for file, places in (("l02-columns", (1, 2)), ("l16-eye-plane", (7, 8))):
            assert lessons.open(CONTENT / f"{file}.md") and lessons.course is not None
            for part in lessons.course.lesson.steps[0].parts:
                if part.show is not None:
                    lessons.show_predicted(part.show)
                    yield rest()
            window.store.begin_gesture()  # a slider is held, and let go on the way
            assert all(map(lessons.go, places))
            window.store.end_gesture()
            yield rest()

    def rest() -> np.ndarray:
        assert lessons.is_moving is not window.settings.reduce_motion
        if lessons.is_moving:
            arrive(lessons)
        settle()
        qtbot.waitUntil(lambda: not window.panels.rest.isActive())  # which resizes the pane
        settle()
        return camera_of(window)

    window.settings.reduce_motion = True
    wanted = list(rests())
    window.settings.reduce_motion = False
    np.testing.assert_allclose(list(rests()), wanted, atol=1e-9)


def test_labels_appear_after_sixty_percent(window: MainWindow) -> None:
    assert light_of(window) == 1.0
    assert window.lessons.go(2)
    assert light_of(window) == 0.0
    tick(window.lessons, 0.5 * TRANSITION_S)
    assert light_of(window) == 0.0
    tick(window.lessons, 0.3 * TRANSITION_S)
    assert 0.0 < light_of(window) < 1.0
    tick(window.lessons, TRANSITION_S)
    assert light_of(window) == 1.0


def test_another_scene_fades(window: MainWindow) -> None:
    before, canvas, drawn = pixels(window), window.panes["world"].canvas, list[int]()
    canvas.drawn.connect(lambda: drawn.append(canvas.height()))
    assert window.lessons.go(3) and window.lessons.is_moving
    assert drawn[-1] == canvas.height() < before.shape[0], "drawn in its place, above the strip"
    old = old_of(window)
    assert old.isVisible() and old.size() == window.slide.size()
    window.control_strip.setMinimumHeight(2 * window.control_strip.height())
    settle()
    assert old.isVisible() and old.size() == window.slide.size(), "the strip has grown since"
    arrive(window.lessons)
    settle()
    assert not old.isVisible()
    assert not np.array_equal(pixels(window), before)


def test_a_picture_that_fades_to_the_kinds_lies_over_no_later_slide(window: MainWindow) -> None:
    window.lessons.go(7)
    arrive(window.lessons)
    assert window.kinds_panel.isVisible() and not window.panes["world"].isVisible()
    window.lessons.go(3)
    arrive(window.lessons)
    assert window.panes["world"].isVisible() and not old_of(window).isVisible()
    window.lessons.go(7)
    window.slide.hide()  # as another part of the window might
    arrive(window.lessons)
    window.slide.show()
    assert not old_of(window).isVisible()


def test_the_model_does_not_move_under_a_picture_that_fades(window: MainWindow) -> None:
    window.settings.reduce_motion = True
    assert window.lessons.go(4)
    window.settings.reduce_motion = False
    assert window.lessons.go(5) and window.lessons.is_moving
    assert window.store.document.projection.lens.near == 2.0
    drawn = window.panes["ndc"].shown
    tick(window.lessons, TRANSITION_S / 2.0)
    assert window.panes["ndc"].shown is drawn
    arrive(window.lessons)
    assert window.lessons.go(6) and old_of(window).isVisible(), "pictures beside each other"
    for _ in range(7):
        tick(window.lessons, TRANSITION_S / 8.0)
        assert window.strip.position == 3.0, "not beside it by a last digit"
    arrive(window.lessons)


def test_only_the_last_frame_of_a_way_is_smooth(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In software it takes ten times as long as the rest."""
    monkeypatch.setattr(adaptive, "AT_REST", "FXAA")
    window.look.adaptive.software_rendering = True
    window.look.rest()

    def is_smooth() -> bool:
        return bool(window.panes["world"].canvas.renderer.GetUseFXAA())

    assert is_smooth()
    assert window.lessons.go(2)
    tick(window.lessons, TRANSITION_S / 2.0)
    assert not is_smooth()
    arrive(window.lessons)
    assert is_smooth()


def test_the_next_step_ends_a_transition(window: MainWindow) -> None:
    assert window.lessons.go(1) and window.lessons.is_moving
    window.talks.next()
    assert window.lessons.place == 2
    arrive(window.lessons)
    assert light_of(window) == 1.0


def test_a_change_by_hand_ends_a_transition(window: MainWindow) -> None:
    assert window.lessons.go(2) and window.lessons.is_moving
    window.store.set_projection(seen(window, lens=Perspective(50.0, 1.0, 30.0)))
    assert not window.lessons.is_moving and light_of(window) == 1.0


@pytest.mark.undrawn
def test_a_held_picture_can_be_left_for_every_view(window: MainWindow) -> None:
    lessons = window.lessons
    assert lessons.course is not None
    views = range(len(lessons.course.lesson.steps))

    def hold(place: int) -> None:
        assert lessons.go(place)
        arrive(lessons)
        if window.comparing.pictures.is_on:  # the step compares pictures itself
            window.menus.compare.trigger()
        window.menus.compare.trigger()
        compared = window.store.look().compare
        assert [each.held is not None for each in compared] == [True, False]

    def leave(place: int, other: int) -> None:
        hold(place)
        assert lessons.go(other) and lessons.place == other
        arrive(lessons)
        assert window.store.look().compare == lessons.course.shown(other).view["compare"]

    for place in views:
        for other in views[max(0, place - 1) : place + 2]:  # the previous one, the same again, next
            leave(place, other)
    window.present.end()
    for place in views[:-1]:
        leave(place, place + 1)
        hold(place)
        lessons.show(lessons.course.shown(place + 1).document)  # as "Show it" does
        arrive(lessons)
    hold(0)
    lessons.close()
    assert lessons.course is None and window.comparing.pictures.is_on


@pytest.mark.undrawn
def test_the_menu_reduces_motion_and_that_is_kept(window: MainWindow) -> None:
    window.menus.view_menu.aboutToShow.emit()
    action = window.menus.reduce_motion
    assert not action.isChecked()
    action.trigger()
    assert window.settings.reduce_motion is True
    assert window.lessons.go(3) and not window.lessons.is_moving
    window.menus.view_menu.aboutToShow.emit()
    assert action.isChecked()


def test_a_pose_goes_the_short_way() -> None:
    axes = np.eye(3)
    turned = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    one = Pose(np.zeros(3), axes, 1.0, 4.0, 0.0)
    other = Pose(np.array([2.0, 0.0, 0.0]), turned, 4.0, 4.0, 0.0)
    half = one.towards(other, 0.5)
    np.testing.assert_allclose(half.focus, [1.0, 0.0, 0.0])
    np.testing.assert_allclose(half.axes[0], [np.sqrt(0.5), np.sqrt(0.5), 0.0])
    assert half.half_height == pytest.approx(2.0) and half.slope == 0.0
    for part, wanted in ((0.0, one), (1.0, other)):
        assert one.towards(other, part).is_near(wanted)
