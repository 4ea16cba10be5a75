"""The walk round the scene: as a function of time, and as it is played."""

import math
import threading
from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from app.model.projection import Camera, Projection
from app.model.refusal import Refusal
from app.scenes.scene import load
from tests.support.controls import choose
from tests.support.shown import show
from tests.support.window import pixels, settle
from widgets.controls.animation import PERIOD_S, STEP_S, AnimationBar, Motion, camera_at
from widgets.controls.controls import Controls
from widgets.parts.clock import LONGEST_FRAME_S, Clock
from widgets.parts.number_rows import NumberRow
from widgets.window.main_window import MainWindow

# 5 to the +z side of the target and 3 above it.
START = Camera((0.0, 5.0, 5.0), (0.0, 2.0, 0.0))
AFAR = Camera((0.0, 2.0, 20.0), START.target)
QUARTER_S = 4.5  # at 20 degrees per second
SWING = Motion(height="swing", lowest=3.0, highest=7.0, clock_s=PERIOD_S / 4)
STEPS = Motion(height="steps", lowest=3.0, highest=9.0)


# -- the walk as a function of time


@pytest.mark.parametrize(
    ("speed_deg_s", "moved", "eye"),
    [
        (20.0, (0.0, 0.0, 0.0), (5.0, 5.0, 0.0)),  # from the z side to the x side
        (-20.0, (0.0, 0.0, 0.0), (-5.0, 5.0, 0.0)),
        (20.0, (101.0, 0.0, 50.0), (106.0, 5.0, 50.0)),  # round the target, not the origin
    ],
)
def test_the_camera_walks_round_the_target(
    speed_deg_s: float, moved: Any, eye: tuple[float, ...]
) -> None:
    ends: Any = [np.add(point, moved).tolist() for point in (START.eye, START.target)]
    camera = camera_at(Camera(*map(tuple, ends)), QUARTER_S, Motion(speed_deg_s=speed_deg_s))
    assert camera.eye == pytest.approx(eye)
    assert camera.target == tuple(ends[1]) and camera.up == START.up


def test_a_full_turn_comes_back_to_the_digit() -> None:
    assert camera_at(START, 18.0, Motion(speed_deg_s=20.0)) == START
    assert camera_at(START, 1.8e9, Motion(speed_deg_s=20.0)) == START


@given(
    st.floats(0.0, 1e4),
    st.sampled_from(["fixed", "swing", "steps"]),
    st.sampled_from(["target", "level"]),
    st.floats(-90.0, 90.0),
)
def test_the_distance_from_the_vertical_never_changes(
    seconds: float, height: Any, look: Any, speed: float
) -> None:
    motion = Motion(speed, height, look, 3.0, 7.0, PERIOD_S / 4)
    camera = camera_at(START, seconds, motion)
    x, _, z = camera.eye
    assert math.hypot(x, z) == pytest.approx(5.0)
    if height == "fixed":
        assert camera.eye[1] == 5.0
    else:
        assert 3.0 - 1e-9 <= camera.eye[1] <= 7.0 + 1e-9
    assert camera.target == (0.0, camera.eye[1] if look == "level" else 2.0, 0.0)


def test_looking_level_is_horizontal() -> None:
    for seconds in (0.0, 1.0, 7.3):
        camera = camera_at(START, seconds, replace(SWING, look="level"))
        assert camera.frame[2][1] == 0.0  # n of lecture 004


def test_the_swing_is_smooth_and_reaches_both_limits() -> None:
    heights = [camera_at(START, t, SWING).eye[1] for t in (0.0, 3.0, 6.0, 9.0, 12.0)]
    assert heights == pytest.approx([5.0, 7.0, 5.0, 3.0, 5.0])
    step_s = 1 / 60
    path = [camera_at(START, i * step_s, SWING).eye[1] for i in range(720)]
    fastest = 2.0 * math.pi / PERIOD_S * 2.0  # of a swing of reach 2
    assert max(abs(b - a) for a, b in pairwise(path)) <= fastest * step_s * 1.01


def test_a_swing_that_starts_beyond_its_limits_does_not_jump() -> None:
    motion = replace(SWING, clock_s=SWING.clock_at(50.0))
    start = Camera((0.0, 50.0, 5.0), (0.0, 2.0, 0.0))
    assert camera_at(start, 0.0, motion).eye[1] == 50.0
    assert camera_at(start, 1e-3, motion).eye[1] == pytest.approx(50.0, abs=0.05)
    assert camera_at(start, 30.0, motion).eye[1] <= 7.0 + 1e-9


def test_steps_are_held_for_two_seconds() -> None:
    at = [camera_at(START, t, STEPS).eye[1] for t in (0.0, 1.99, 2.0, 3.99, 4.0, 6.0)]
    assert at == pytest.approx([5.0, 5.0, 5.0, 5.0, 7.0, 9.0])  # 3, 5, 7, 9; start first
    down = [camera_at(START, t, STEPS).eye[1] for t in (8.0, 10.0, 12.0, 14.0)]
    assert down == pytest.approx([7.0, 5.0, 3.0, 5.0])
    start = replace(START, eye=(0.0, 4.0, 5.0))
    assert camera_at(start, 1.99, STEPS).eye[1] == 4.0
    assert STEP_S == 2.0


@pytest.mark.parametrize("height", [3.0, 3.5, 5.0, 6.9, 7.0])
@pytest.mark.parametrize("rising", [True, False])
def test_the_clock_finds_the_height_and_its_direction(height: float, rising: bool) -> None:
    clock_s = SWING.clock_at(height, rising=rising)
    assert SWING.swing(clock_s) == pytest.approx(height)
    if 3.0 < height < 7.0:
        later = SWING.swing(clock_s + 0.01)
        assert (later > height) == rising
        assert replace(SWING, clock_s=clock_s).rising == rising


def test_up_walks_along() -> None:
    start = Camera((0.0, 9.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, -1.0))  # straight above
    camera = camera_at(start, QUARTER_S, Motion(speed_deg_s=20.0))
    assert camera.eye == start.eye and camera.up == pytest.approx((-1.0, 0.0, 0.0), abs=1e-15)


def test_from_straight_above_there_is_no_level_view() -> None:
    start = Camera((0.0, 9.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, -1.0))
    with pytest.raises(Refusal):
        camera_at(start, 1.0, Motion(look="level"))


# -- played


class Record:
    """Records the signals of the bar in order."""

    def __init__(self, bar: AnimationBar) -> None:
        self.cameras: list[Camera] = []
        self.events: list[str] = []
        bar.edited.connect(self.cameras.append)
        bar.gesture_started.connect(lambda: self.events.append("start"))
        bar.gesture_finished.connect(lambda: self.events.append("finish"))


@pytest.fixture
def bar(display: Any, qtbot: Any) -> Iterator[AnimationBar]:
    widget = AnimationBar()
    qtbot.addWidget(widget)
    widget.set_scene(4.0, AFAR)  # heights from 1 to 6
    widget.show_camera(START)
    widget.show()
    yield widget
    widget.pause()


@pytest.fixture
def record(bar: AnimationBar) -> Record:
    return Record(bar)


def motion(bar: AnimationBar) -> Motion:
    """Return the walk from `START` that the rows describe."""
    said = Motion(
        bar.speed.value(),
        bar.height_mode.value(),  # type: ignore[arg-type]
        bar.look.value(),  # type: ignore[arg-type]
        bar.lowest.value(),
        bar.highest.value(),
    )
    return replace(said, clock_s=said.clock_at(START.eye[1]))


def test_play_and_pause_enclose_one_gesture(bar: AnimationBar, record: Record) -> None:
    bar.advance(1.0)  # without effect
    QTest.mouseClick(bar.button, Qt.MouseButton.LeftButton)
    assert bar.playing and bar.button.accessibleName() == "Pause"
    bar.advance(1.0)
    bar.advance(1.0)
    QTest.mouseClick(bar.button, Qt.MouseButton.LeftButton)
    assert not bar.playing and bar.button.accessibleName() == "Play"
    bar.advance(1.0)
    assert record.events == ["start", "finish"]
    assert record.cameras == [camera_at(START, t, motion(bar)) for t in (1.0, 2.0)]


def test_no_frame_is_asked_for_while_one_is_handled(bar: AnimationBar, qtbot: Any) -> None:
    waiting, timer = [], bar.findChild(Clock).findChild(QTimer)
    bar.edited.connect(lambda _camera: waiting.append(timer.isActive()))
    bar.play()
    qtbot.waitUntil(lambda: len(waiting) >= 2)
    assert waiting[:2] == [False, False]


def test_a_stalled_window_does_not_jump(bar: AnimationBar, record: Record) -> None:
    bar.play()
    threading.Event().wait(1.5 * LONGEST_FRAME_S)
    bar.findChild(Clock).findChild(QTimer).timeout.emit()
    assert record.cameras == [camera_at(START, LONGEST_FRAME_S, motion(bar))]


def test_playing_on_goes_on(bar: AnimationBar, record: Record) -> None:
    choose(bar.height_mode, "swing")
    bar.play()
    for _ in range(10):
        bar.advance(0.7)
    bar.pause()
    stood = record.cameras[-1]
    bar.play()
    bar.advance(1e-9)
    assert record.cameras[-1].eye == pytest.approx(stood.eye, abs=1e-6)
    bar.advance(0.7)
    straight = camera_at(START, 7.7, motion(bar))
    assert record.cameras[-1].eye == pytest.approx(straight.eye, abs=1e-6)


def test_the_way_of_the_eye_is_in_the_world_pane_while_it_walks(window: MainWindow) -> None:
    """For the letter F a circle round the target, all of it inside the pane."""
    walk, pane = window.controls.animation, window.panes["world"]
    assert pane.drawing is not None
    camera = window.store.document.projection.camera
    walk.play()
    settle()
    eyes = np.array(pane.requested["walk"])
    x, _, z = np.subtract(camera.eye, camera.target).tolist()
    quarters = (eyes - camera.target)[[0, 30, 60, 90, 120]]
    assert np.allclose(quarters[:, ::2], [(x, z), (z, -x), (-x, -z), (-z, x), (x, z)])
    assert np.allclose(eyes[:, 1], camera.eye[1])
    walk.advance(3.0)
    settle()
    spots, walking = np.round(pane.drawing.sight.seen(eyes)).astype(int), pixels(window)
    height, width, _ = walking.shape
    assert ((spots > 2) & (spots < (width - 2, height - 2))).all() and not pane.drawing.cut()
    walk.pause()
    settle()
    assert pane.requested["walk"] == ()
    apart = (walking != pixels(window)).any(axis=2)
    drawn = [apart[y - 2 : y + 3, x - 2 : x + 3].any() for x, y in spots.tolist()]
    assert np.mean(drawn) > 0.7, "the line goes when the walk ends; the F hides a part of it"


def test_another_speed_does_not_jump(bar: AnimationBar, record: Record) -> None:
    choose(bar.height_mode, "swing")
    bar.play()
    bar.advance(4.0)  # over the top and falling
    before = record.cameras[-1]
    bar.speed.slider.setFocus()
    QTest.keyClick(bar.speed.slider, Qt.Key.Key_End)
    assert bar.speed.value() == 90.0
    bar.advance(1e-9)
    assert record.cameras[-1].eye == pytest.approx(before.eye, abs=1e-6)
    bar.advance(1.0)
    assert record.cameras[-1].orbit.azimuth_deg == pytest.approx(80.0 + 90.0)
    assert record.cameras[-1].eye[1] < before.eye[1]  # falling still


@pytest.mark.parametrize("mode", ["swing", "steps"])
def test_another_height_mode_does_not_jump(bar: AnimationBar, record: Record, mode: str) -> None:
    bar.play()
    bar.advance(1.0)
    choose(bar.height_mode, mode)
    bar.advance(1e-9)
    assert record.cameras[-1].eye[1] == pytest.approx(5.0, abs=1e-6)
    assert bar.lowest.isVisible()
    for _ in range(200):
        bar.advance(0.1)
    heights = [camera.eye[1] for camera in record.cameras]
    assert min(heights) == pytest.approx(1.0, abs=0.01)
    assert max(heights) == pytest.approx(6.0, abs=0.01)
    choose(bar.height_mode, "fixed")
    bar.advance(1.0)
    assert record.cameras[-1].eye[1] == heights[-1] and not bar.lowest.isVisible()


@pytest.mark.parametrize(("seconds", "rising"), [(1.0, True), (4.0, False)])
def test_other_limits_do_not_jump(
    bar: AnimationBar, record: Record, seconds: float, rising: bool
) -> None:
    choose(bar.height_mode, "swing")
    bar.play()
    bar.advance(seconds)
    before = record.cameras[-1].eye[1]
    bar.lowest.field.setFocus()
    bar.lowest.field.selectAll()
    QTest.keyClicks(bar.lowest.field, "-8\r")
    assert bar.lowest.value() == -8.0
    bar.advance(1e-9)
    assert record.cameras[-1].eye[1] == pytest.approx(before, abs=1e-6)
    bar.advance(0.5)
    walk = motion(bar)
    clock_s = walk.clock_at(before, rising=rising)
    assert record.cameras[-1].eye[1] == pytest.approx(walk.swing(clock_s + 0.5), abs=1e-6)


def test_a_moved_target_is_what_the_walk_goes_round(bar: AnimationBar, record: Record) -> None:
    bar.play()
    bar.advance(QUARTER_S)
    moved = replace(record.cameras[-1], target=(1.0, 2.5, 0.0))  # the eye is at (5, 5, 0)
    bar.show_camera(moved)
    bar.advance(QUARTER_S)
    assert record.cameras[-1].target == (1.0, 2.5, 0.0)
    assert record.cameras[-1].eye == pytest.approx((1.0, 5.0, -4.0))


def test_a_raised_camera_swings_on_from_there(bar: AnimationBar, record: Record) -> None:
    choose(bar.height_mode, "swing")
    bar.play()
    bar.advance(4.0)
    assert record.cameras[-1].eye[1] < 6.0
    eye = record.cameras[-1].eye
    bar.show_camera(replace(record.cameras[-1], eye=(eye[0], 3.0, eye[2])))
    bar.advance(1e-9)
    assert record.cameras[-1].eye[1] == pytest.approx(3.0, abs=1e-6)
    bar.advance(0.5)
    walk = motion(bar)
    falling_s = walk.clock_at(3.0, rising=False)
    assert record.cameras[-1].eye[1] == pytest.approx(walk.swing(falling_s + 0.5), abs=1e-6)
    assert record.cameras[-1].eye[1] < 3.0


def test_its_own_camera_coming_back_is_no_edit(bar: AnimationBar, record: Record) -> None:
    bar.edited.connect(bar.show_camera)
    bar.edited.connect(lambda camera: bar.show_camera(replace(camera)))
    bar.play()
    elapsed_s = 0.0
    for _ in range(180):
        bar.advance(0.1)
        elapsed_s += 0.1
    assert record.cameras[-1] == camera_at(START, elapsed_s, motion(bar))  # no rounding adds up
    assert len(record.cameras) == 180


def test_looking_level_remembers_what_to_look_at(bar: AnimationBar, record: Record) -> None:
    choose(bar.look, "level")
    bar.play()
    bar.advance(1.0)
    assert record.cameras[-1].target == (0.0, 5.0, 0.0)
    level = record.cameras[-1]
    bar.show_camera(replace(level, eye=(level.eye[0] + 1.0, *level.eye[1:])))  # a step aside
    bar.pause()
    choose(bar.look, "target")
    bar.play()
    bar.advance(1.0)
    assert record.cameras[-1].target == (0.0, 2.0, 0.0)


def test_an_impossible_walk_stops_and_says_why(bar: AnimationBar, record: Record) -> None:
    bar.show_camera(Camera((0.0, 9.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, -1.0)))
    choose(bar.look, "level")
    bar.play()
    bar.advance(1.0)
    assert not bar.playing and record.events[-1] == "finish" and not record.cameras
    said = "The camera stands straight above the target and cannot look level."
    assert refusal(bar) == f"Stopped. {said}"
    bar.show_camera(Camera((0.0, -9.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, -1.0)))
    bar.play()
    bar.advance(1.0)
    assert "straight below" in refusal(bar)


def refusal(bar: AnimationBar) -> str:
    """Return the visible reason for a stop, if there is one."""
    shown = [label.text() for label in bar.findChildren(QLabel) if label.isVisible()]
    return "".join(text for text in shown if text.startswith("Stopped"))


def stop(bar: AnimationBar) -> None:
    bar.show_camera(Camera((0.0, 9.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, -1.0)))
    choose(bar.look, "level")
    bar.play()
    bar.advance(1.0)
    assert refusal(bar)


def test_the_reason_for_a_stop_goes_when_it_no_longer_holds(bar: AnimationBar) -> None:
    stop(bar)
    bar.show_camera(START)  # a reset, an undo, a slider
    assert not refusal(bar)
    stop(bar)
    bar.set_scene(4.0, AFAR)
    assert not refusal(bar)
    stop(bar)
    choose(bar.look, "target")
    assert not refusal(bar)
    stop(bar)
    bar.show_camera(replace(START))
    bar.play()
    bar.advance(1.0)
    assert bar.playing and not refusal(bar)


def test_a_walk_through_the_target_or_along_up_says_so(bar: AnimationBar) -> None:
    choose(bar.height_mode, "steps")
    type_into(bar.lowest, "2")
    type_into(bar.highest, "2")
    bar.show_camera(Camera((0.0, 9.0, 0.0), (0.0, 2.0, 0.0), (0.0, 0.0, -1.0)))
    bar.play()
    bar.advance(3.0)
    said = "The camera is at the target and cannot look at it."
    assert not bar.playing and refusal(bar).endswith(said)
    type_into(bar.speed, "0")
    bar.show_camera(Camera((0.0, 9.0, 5.0), (0.0, 2.0, 0.0), (0.0, 0.0, 1.0)))
    bar.play()
    bar.advance(3.0)
    said = "The camera would look along its own up vector."
    assert not bar.playing and refusal(bar).endswith(said)


def test_another_scene_stops_the_walk_and_fits_the_limits(
    bar: AnimationBar, record: Record
) -> None:
    choose(bar.height_mode, "swing")
    bar.play()
    camera = Camera((0.0, 100.0, 100.0), (0.0, 100.0, 0.0))
    bar.set_scene(40.0, camera)
    assert not bar.playing
    assert (bar.lowest.value(), bar.highest.value()) == (90.0, 140.0)
    assert record.cameras == []
    bar.show_camera(camera)
    bar.play()
    for _ in range(200):
        bar.advance(0.1)
    assert min(camera.eye[1] for camera in record.cameras) == pytest.approx(90.0, abs=0.01)


@pytest.mark.parametrize("name", ["letter-f", "cube", "posts", "far-plane-popping"])
def test_a_swing_looks_at_no_scene_from_straight_above(bar: AnimationBar, name: str) -> None:
    scene = load(name)
    camera = scene.start.camera
    bar.set_scene(scene.size, camera)
    away = math.hypot(camera.eye[0] - camera.target[0], camera.eye[2] - camera.target[2])
    for row, least, most in ((bar.lowest, -15.0, 0.0), (bar.highest, 15.0, 35.0)):
        assert least < math.degrees(math.atan2(row.value() - camera.target[1], away)) < most


def test_standing_still_is_silent(bar: AnimationBar, record: Record) -> None:
    type_into(bar.speed, "0")
    bar.play()
    bar.advance(1.0)
    assert record.cameras == []


# -- in the column


def test_the_walk_comes_out_of_the_controls(display: Any, qtbot: Any) -> None:
    controls = Controls()
    qtbot.addWidget(controls)
    show(controls, Projection(START))
    edits: list[Projection] = []
    gestures: list[str] = []
    controls.edited.connect(edits.append)
    controls.gesture_started.connect(lambda: gestures.append("start"))
    controls.animation.play()
    controls.animation.advance(QUARTER_S)
    assert [edit.camera.eye for edit in edits] == [pytest.approx((5.0, 5.0, 0.0))]
    assert controls.rows["azimuth_deg"].value() == pytest.approx(90.0)
    # An edit meanwhile is respected.
    row = controls.rows["distance"]
    row.setDefault(10.0)
    row.reset()
    controls.animation.advance(QUARTER_S)
    assert edits[-1].camera.distance == pytest.approx(10.0)
    assert edits[-1].camera.orbit.azimuth_deg == pytest.approx(180.0)
    assert gestures == ["start"]  # the row's own; the walk's are the animation's
    controls.animation.pause()


def type_into(row: NumberRow, text: str) -> None:
    row.field.setFocus()
    row.field.selectAll()
    QTest.keyClicks(row.field, text)
    QTest.keyClick(row.field, Qt.Key.Key_Return)


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("speed", "inf", "Speed = ∞: must be at most 3600."),
        ("speed", "1e308", "Speed = 1e+308: must be at most 3600."),
        ("speed", "-3600.5", "Speed = -3600.5: must be at least -3600."),
        ("highest", "1e101", "Highest = 1e+101: must be at most 1e+100."),
        (
            "speed", "fast",
            "Speed = “fast”: must be a number, such as 0.5 or 2e-3; must be at least -3600;"
            " must be at most 3600.",
        ),
    ],
)  # fmt: skip
def test_an_impossible_value_is_refused_and_the_walk_continues(
    bar: AnimationBar, record: Record, name: str, text: str, said: str
) -> None:
    choose(bar.height_mode, "swing")
    row = getattr(bar, name)
    bar.play()
    before, walk = row.value(), motion(bar)
    type_into(row, text)
    assert row.error == f"Not possible. {said}"
    assert row.value() == before
    bar.advance(1.0)
    assert bar.playing and record.cameras == [camera_at(START, 1.0, walk)]
    choose(bar.look, "level")
    bar.height_mode.widgets[0].setFocus()
    choose(bar.look, "target")
    assert row.error == "", "it goes when anything else is accepted"


@pytest.mark.parametrize("height", ["fixed", "swing", "steps"])
def test_the_fastest_walk_between_the_farthest_limits_goes_on_or_says_why_not(
    bar: AnimationBar, record: Record, height: str
) -> None:
    choose(bar.height_mode, "swing")
    for row, text in ((bar.speed, "3600"), (bar.lowest, "-1e100"), (bar.highest, "1e100")):
        type_into(row, text)
        assert row.error == "" and row.value() == float(text)
    choose(bar.height_mode, height)
    bar.play()
    for _ in range(5):
        bar.advance(0.01)
    stopped = refusal(bar).endswith("The camera would look along its own up vector.")
    assert bar.playing != stopped and bar.playing == (len(record.cameras) == 5)
    assert bar.playing == (height != "swing")
