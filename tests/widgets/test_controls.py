"""The dock with real widgets: edits of the user go out, values of the model come in."""

import math
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import fields, replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import (
    QAccessible,
    QFont,
    QHelpEvent,
    QInputMethodEvent,
    QMouseEvent,
    QWheelEvent,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QSlider,
    QToolButton,
    QWidget,
)

from app.document.document import IMAGE, Document, lens_fields
from app.document.settings import set_values
from app.model.chain import FiveTiles
from app.model.lenses.oblique import OBLIQUE_PRESETS
from app.model.lenses.perspective import fov_x_from_fov_y
from app.model.projection import (
    LARGEST,
    LENSES,
    Camera,
    FreeMatrix,
    Lens,
    Oblique,
    Orbit,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.refusal import REFUSALS, Refusal
from app.scenes import scene
from app.scenes.phenomena import PHENOMENA
from tests.support.controls import (
    BOX,
    KEY,
    NONSENSE,
    OFF_AXIS,
    SLANTED,
    START,
    Column,
    Reader,
    Record,
    choice,
    choose,
    column_with_the_keyboard,
    drag,
    enter,
    number,
    press,
    release,
)
from tests.support.layout import cut
from tests.support.shown import show
from widgets.controls.controls import Controls
from widgets.controls.dock import ControlTexts, find
from widgets.parts import messages
from widgets.parts.messages import all_digits
from widgets.parts.number_rows import QUIET_MS, NumberRow
from widgets.parts.number_text import parse_number, short_text
from widgets.parts.scales import Doubling, Linear, Log

CLOSE = replace(START, lens=Perspective(45.0, 3.5, 5.0))
"""Near and far limit each other within the range of their sliders."""


@pytest.fixture
def controls(display: Any, qtbot: Any) -> Column:
    return column_with_the_keyboard(qtbot)


@pytest.fixture
def reader(display: Any, qtbot: Any) -> Reader:
    return Reader(qtbot)


@pytest.fixture
def record(controls: Column) -> Record:
    return Record(controls)


def in_mode(controls: Column, key: str) -> None:
    """Bring the row into view: the right lens, and its section unfolded."""
    if key in ("left", "right", "bottom", "top", "keep"):
        show(controls, BOX)
    if key in ("preset", "receding", "receding_deg", "alpha_deg", "beta_deg"):
        show(controls, SLANTED)
    for section in controls.sections.values():
        section.set_open(section.isAncestorOf(controls.rows[key]))


def each(controls: Column, keys: Iterable[str]) -> Iterator[tuple[str, Record]]:
    """Yield each row in turn, in view in a column as at the start, with a fresh record."""
    record = Record(controls)
    for key in keys:
        show(controls, START)
        in_mode(controls, key)
        record.events.clear()
        record.edits.clear()
        yield key, record


def lens(fov_y_deg: float = 45.0, near: float = 1.0, far: float = 30.0) -> Projection:
    return replace(START, lens=Perspective(fov_y_deg, near, far))


def box(**fields: Any) -> Projection:
    return replace(BOX, lens=replace(BOX.lens, **fields))


def slanted(**fields: Any) -> Projection:
    return replace(SLANTED, lens=replace(SLANTED.lens, **fields))


def seen_from(*camera: tuple[float, float, float]) -> Projection:
    return replace(START, camera=Camera(*camera))


def sized(width: int, height: int) -> Projection:
    return replace(START, image_size=(width, height))


def half_tan(p: Projection) -> float:
    return math.tan(math.radians(p.lens.fov_y_deg / 2))  # type: ignore[union-attr, operator]


def of_k(p: Projection, name: str, pixels: float) -> bool:
    return p.lens.kind == "frustum" and getattr(p.intrinsics, name) == pytest.approx(pixels)


def leans(p: Projection, preset: str) -> bool:
    return (p.lens.alpha_deg, p.lens.beta_deg) == OBLIQUE_PRESETS[preset]  # type: ignore[union-attr]


ABOVE_THE_TARGET = (0.0, 2.0, 0.0)
VECTORS = seen_from((1.5, 2.5, 3.5), (-1.5, -2.5, -3.5), (0.5, 0.6, 0.7))
NUMBERS: dict[str, tuple[str, Any, Projection, str]] = {
    "fov_y_deg": ("60", lambda p: p == lens(60.0), lens(30.5), "30.5"),
    # tan(fov_y/2) = tan(fov_x/2)/aspect, and tan(45) = 1
    "fov_x_deg": (
        "90", lambda p: math.isclose(half_tan(p), 9 / 16),
        lens(math.degrees(2 * math.atan(9 / 16))), "90",
    ),
    # half the film's diagonal over the focal length, shared out 9 : hypot(16, 9)
    "focal_length_mm": (
        "50",
        lambda p: math.isclose(half_tan(p), math.hypot(36, 24) / 2 / 50 * 9 / math.hypot(16, 9)),
        lens(30.0), "39.58",  # 21.6333 * cot(15) * 9 / hypot(16, 9)
    ),
    "near": ("0.125", lambda p: p == lens(near=0.125), lens(near=2.5), "2.5"),
    "far": ("1e3", lambda p: p == lens(far=1000.0), lens(far=math.inf), "∞"),
    "left": ("-5", lambda p: p.lens.left == -5.0, box(left=-1.5), "-1.5"),
    "right": ("5", lambda p: p.lens.right == 5.0, box(right=1.5), "1.5"),
    "bottom": ("-5", lambda p: p.lens.bottom == -5.0, box(bottom=-1.5), "-1.5"),
    "top": ("5", lambda p: p.lens.top == 5.0, box(top=1.5), "1.5"),
    # e = 1/tan(fov_x/2)
    "e": ("2", lambda p: math.isclose(half_tan(p), 0.5 * 9 / 16), lens(90.0), "0.5625"),
    "window_right": (
        "3.2", lambda p: p.window == pytest.approx((-3.2, 3.2, -1.8, 1.8)), lens(90.0, 2.25), "4"
    ),
    "window_top": (
        "1", lambda p: p.lens.fov_y_deg == pytest.approx(90.0), lens(90.0, 2.25), "2.25"
    ),
    "fx": ("900", lambda p: of_k(p, "fx", 900.0), lens(90.0), "360"),  # half of the height
    "fy": ("900", lambda p: of_k(p, "fy", 900.0), OFF_AXIS, "360"),  # 720 px for 2 units at 1
    # a quarter of 1280 px from the left, three quarters of 720 from the top, less half a pixel
    "cx": ("100", lambda p: of_k(p, "cx", 100.0), OFF_AXIS, "319.5"),
    "cy": ("100", lambda p: of_k(p, "cy", 100.0), OFF_AXIS, "539.5"),
    "receding": (
        "1", lambda p: leans(p, "cavalier-45"), slanted(alpha_deg=90.0, beta_deg=135.0), "1"
    ),
    "receding_deg": (
        "30", lambda p: leans(p, "cabinet-30"), slanted(alpha_deg=90.0, beta_deg=45.0), "-90"
    ),
    "alpha_deg": ("60", lambda p: p == slanted(alpha_deg=60.0), slanted(alpha_deg=70.5), "70.5"),
    "beta_deg": ("60", lambda p: p == slanted(beta_deg=60.0), slanted(beta_deg=70.5), "70.5"),
    "azimuth_deg": (  # 90 is the +x side, at the same height and distance
        "90", lambda p: np.allclose(p.camera.eye, (math.hypot(6, 9), 5.0, 0.0), atol=1e-12),
        seen_from((0.0, 2.0, 7.0), ABOVE_THE_TARGET), "0",
    ),
    "elevation_deg": (
        "0", lambda p: p.camera.eye[1] == 2.0 and math.isclose(p.camera.distance, math.sqrt(126)),
        seen_from((0.0, 9.0, 7.0), ABOVE_THE_TARGET), "45",
    ),
    "distance": (
        "20", lambda p: math.isclose(p.camera.distance, 20.0) and p.camera.target[1] == 2.0,
        seen_from((0.0, 2.0, 7.0), ABOVE_THE_TARGET), "7",
    ),
    "roll_deg": (  # the camera's v was the old u
        "90", lambda p: p.camera.frame[1] == pytest.approx(START.camera.frame[0]),
        seen_from((0.0, 2.0, 7.0), ABOVE_THE_TARGET, (1.0, 0.0, 0.0)), "90",
    ),
    "width": ("640", lambda p: p.image_size == (640, 720), sized(99, 9), "99"),
    "height": ("400", lambda p: p.image_size == (1280, 400), sized(99, 9), "9"),
}  # fmt: skip
"""For each row: a text that the user types, a check of the resulting model, another value of the
model, and the text of that value."""


def _component(part: str, vector: str, axis: int, typed: str) -> Callable[[Projection], bool]:
    return lambda p: getattr(getattr(p, part), vector)[axis] == float(typed)


for _vector, _texts in (
    ("eye", ("1.5", "2.5", "3.5")),
    ("target", ("-1.5", "-2.5", "-3.5")),
    ("up", ("0.5", "0.6", "0.7")),
):
    for _axis, _letter in enumerate("xyz"):
        _holds = _component("camera", _vector, _axis, "7.5")
        NUMBERS[f"{_vector}_{_letter}"] = ("7.5", _holds, VECTORS, _texts[_axis])

CHOICES: dict[str, tuple[str, Any, Projection]] = {
    "kind": ("orthographic", lambda p: p.lens.kind == "orthographic", BOX),
    "keep": ("x", lambda p: p.lens.keep == "x", box(keep="x")),
    "preset": (
        "cavalier-30",
        lambda p: leans(p, "cavalier-30"),
        replace(SLANTED, lens=Oblique(-4, 4, -4, 4, 1, 30, "x", *OBLIQUE_PRESETS["cavalier-30"])),
    ),
    "aspect": ("4:3", lambda p: p.image_size == (960, 720), replace(START, image_size=(96, 72))),
    "depth": ("reversed", lambda p: p.depth == "reversed", replace(START, depth="reversed")),
}


def test_the_tables_name_every_row(controls: Column) -> None:
    own = {each.name for lens in LENSES.values() for each in lens.parameters}
    assert {*NUMBERS, *CHOICES} | own == set(controls.rows)


# -- one user's action is one edit; a shown projection is none


def test_a_typed_number_is_one_edit(controls: Column) -> None:
    for key, record in each(controls, NUMBERS):
        text, holds, _, _ = NUMBERS[key]
        enter(number(controls, key), text)
        assert record.events == ["start", "edit", "finish"], key
        assert holds(record.edits[0]), (key, record.edits[0])
        assert number(controls, key).field.text() == messages.number_text(float(text)), key


def test_a_shown_projection_updates_each_row_without_a_signal(controls: Column) -> None:
    for key, record in each(controls, NUMBERS):
        _, _, shown, text = NUMBERS[key]
        row = number(controls, key)
        show(controls, shown)
        assert row.field.text() == text, key
        assert not row.isHidden(), key
        if row.slider.minimum() < row.slider.value() < row.slider.maximum():
            place, scale = row.slider.value(), row.scale
            near_by = scale.value_at(place)
            assert abs(near_by - row.value()) <= abs(scale.value_at(place + 1) - near_by), key
        assert record.events == [], key


def test_a_choice_is_one_edit(controls: Column) -> None:
    for key, record in each(controls, CHOICES):
        wanted, holds, _ = CHOICES[key]
        row = choice(controls, key)
        widget = row.widgets[0]
        if isinstance(widget, QComboBox):
            widget.setFocus()
            ahead = row.keys.index(wanted) > widget.currentIndex()
            while row.keys[widget.currentIndex()] != wanted:
                QTest.keyClick(widget, KEY.Key_Down if ahead else KEY.Key_Up)
            assert record.edits and record.events[-3:] == ["start", "edit", "finish"], key
        else:
            QTest.mouseClick(row.widgets[row.keys.index(wanted)], Qt.MouseButton.LeftButton)
            assert record.events == ["start", "edit", "finish"], key
        assert holds(record.edits[-1]), key


def test_a_shown_choice_emits_no_signal(controls: Column) -> None:
    for key, record in each(controls, CHOICES):
        wanted, _, shown = CHOICES[key]
        show(controls, shown)
        row = choice(controls, key)
        widget = row.widgets[0]
        if isinstance(widget, QComboBox):
            assert widget.currentIndex() == row.keys.index(wanted), key
        else:
            checked = [b.isChecked() for b in row.widgets if isinstance(b, QToolButton)]
            assert checked == [name == wanted for name in row.keys], key
        assert record.events == [], key


def test_choosing_the_current_option_emits_nothing(controls: Column, record: Record) -> None:
    controls.sections["image"].set_open(True)
    button = choice(controls, "aspect").widgets[2]
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert isinstance(button, QToolButton) and button.isChecked()
    assert record.events == []


def test_a_row_alone_keeps_the_users_value(display: Any, qtbot: Any) -> None:
    row = NumberRow("Speed", "How fast.", Linear(0.0, 10.0, 1.0))
    qtbot.addWidget(row)
    values: list[float] = []
    row.edited.connect(values.append)
    row.setValue(3.5)
    assert (row.value(), row.field.text(), values) == (3.5, "3.5", [])
    row.show()
    press(row.slider)
    for value in (5.0, 6.0, 5.0):
        drag(row.slider, row.scale.position_of(value))
    assert row.value() == 5.0
    row.edited.connect(lambda value: row.show_error("Too fast.") if value > 8.0 else None)
    for value in (9.0, 5.0, 4.0):
        drag(row.slider, row.scale.position_of(value))
    release(row.slider)
    assert row.value() == 4.0
    # 8 was taken while 9 was refused, then 5 again.
    assert values[:4] == [5.0, 6.0, 5.0, 9.0] and values[-2:] == [5.0, 4.0]


def test_an_aspect_that_is_no_preset_chooses_none(controls: Column) -> None:
    controls.sections["image"].set_open(True)
    show(controls, replace(START, image_size=(1000, 999)))
    buttons = choice(controls, "aspect").widgets
    assert not any(b.isChecked() for b in buttons if isinstance(b, QToolButton))
    show(controls, replace(START, image_size=(999, 999)))
    assert [b.isChecked() for b in buttons if isinstance(b, QToolButton)] == [True, False, False]


def test_the_controls_show_their_own_edit_before_they_emit_it(controls: Column) -> None:
    texts: list[str] = []
    controls.sections["more_lens"].set_open(True)
    controls.edited.connect(lambda _edit: texts.append(number(controls, "fov_x_deg").field.text()))
    enter(number(controls, "fov_y_deg"), "90")
    assert texts == [short_text(fov_x_from_fov_y(90.0, 16 / 9), 180.0, 4)]


def test_no_echo_when_the_owner_shows_the_edit_again(controls: Column, record: Record) -> None:
    controls.edited.connect(partial(show, controls))
    controls.edited.connect(lambda edit: show(controls, replace(edit)))
    enter(number(controls, "near"), "2")
    assert len(record.edits) == 1


# -- sliders


def test_every_slider_goes_to_its_ends(controls: Column, reader: Reader) -> None:
    """The model stays valid, or the row says why not; never an exception, never silence."""
    for end, back in ((KEY.Key_Home, KEY.Key_Up), (KEY.Key_End, KEY.Key_Down)):
        for key, record in each(controls, NUMBERS):
            row = number(controls, key)
            row.slider.setFocus()
            QTest.keyClick(row.slider, end)
            QTest.keyClick(row.slider, back)
            row.finish_gesture()
            assert record.edits or row.error, key
            assert row.value() == pytest.approx(reader.read(key, controls.projection)), key
            assert row.slider.value() == row.scale.position_of(row.value()), key


def within(row: NumberRow, low: float, high: float) -> list[float]:
    """The values of a slider between two others, both excluded."""
    scale = row.scale
    values = [scale.value_at(position) for position in range(scale.last + 1)]
    return [value for value in values if low < value < high]


def test_a_drag_goes_to_the_limit_however_fast_it_is(controls: Column) -> None:
    for key, by, end in [
        ("far", [0], 0),
        ("far", [-10, -30, 0], 0),
        ("far", [-1] * 200, 0),
        ("near", [10**6], 10**6),
        ("near", [5, 50, 10**6], 10**6),
    ]:
        show(controls, CLOSE)
        record = Record(controls)
        row = number(controls, key)
        possible = within(row, 3.5, 5.0)
        last = possible[0] if key == "far" else possible[-1]
        press(row.slider)
        for step in by:
            drag(row.slider, row.slider.sliderPosition() + step)
        drag(row.slider, end)
        assert row.value() == getattr(record.edits[-1].lens, key) == last
        ends = messages.number_text(row.scale.value_at(row.slider.sliderPosition()))
        assert row.error.startswith(f"Not possible. {row.name} = {ends}: must be")
        show(controls, replace(controls.projection, depth="reversed"))
        assert row.error, "another part of the projection has changed"
        count = len(record.edits)
        drag(row.slider, end + (1 if end == 0 else -1))
        assert len(record.edits) == count and row.value() == last and row.error
        release(row.slider)
        assert row.error == "" and row.field.text() == short_text(last, None, 4)
        assert row.slider.value() == row.scale.position_of(last)
        assert record.events[0] == "start" and record.events[-1] == "finish"
        assert record.events.count("start") == 1


def test_a_drag_that_follows_a_burst_is_one_gesture_with_it(
    controls: Column, record: Record, qtbot: Any
) -> None:
    row = number(controls, "azimuth_deg")
    row.slider.setFocus()
    QTest.keyClick(row.slider, KEY.Key_Right)
    press(row.slider)
    qtbot.wait(QUIET_MS + 200)  # the burst would have ended, under the hand
    assert record.events == ["start", "edit"]
    release(row.slider)
    assert record.events == ["start", "edit", "finish"]


def test_a_burst_ends_when_another_row_is_taken(controls: Column, record: Record) -> None:
    number(controls, "azimuth_deg").slider.setFocus()
    QTest.keyClick(number(controls, "azimuth_deg").slider, KEY.Key_Right)
    enter(number(controls, "near"), "2")
    assert record.events == ["start", "edit", "finish", "start", "edit", "finish"]


NO_KEY, SHIFT, CTRL = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
)


def wheel(slider: QSlider, keys: Qt.KeyboardModifier = NO_KEY, turned: int = 120) -> bool:
    """Turn the wheel; return whether the slider accepts the event."""
    centre = QPointF(slider.rect().center())
    event = QWheelEvent(
        centre,
        slider.mapToGlobal(centre),
        QPoint(),
        QPoint(0, turned),
        Qt.MouseButton.NoButton,
        keys,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(slider, event)
    return event.isAccepted()


def test_the_wheel_scrolls_the_column_unless_the_slider_has_focus_or_ctrl(
    controls: Column, record: Record
) -> None:
    row = number(controls, "azimuth_deg")
    number(controls, "near").field.setFocus()
    assert not wheel(row.slider) and record.edits == []
    assert wheel(row.slider, CTRL) and len(record.edits) == 1
    row.slider.setFocus()
    wheel(row.slider)
    wheel(row.slider, turned=40)  # of a finer wheel, three make a notch
    wheel(row.slider, turned=80)
    assert [edit.camera.orbit.azimuth_deg for edit in record.edits] == pytest.approx(
        [35.0, 36.0, 37.0]
    )


def test_shift_makes_wheel_and_drag_ten_times_finer(controls: Column, record: Record) -> None:
    row = number(controls, "fov_y_deg")
    row.slider.setFocus()
    wheel(row.slider, SHIFT)
    assert row.value() == 45.05
    row.finish_gesture()
    moved = {}
    for keys in (NO_KEY, SHIFT):
        enter(row, "45")
        place = press(row.slider)
        hand = QPointF(place + QPoint(50, 0))
        left = Qt.MouseButton.LeftButton
        event = QMouseEvent(
            QEvent.Type.MouseMove, hand, row.slider.mapToGlobal(hand), left, left, keys
        )
        QApplication.sendEvent(row.slider, event)
        moved[keys] = row.value() - 45.0
        release(row.slider)
    assert moved[NO_KEY] > 25.0 and moved[NO_KEY] % 0.5 == 0.0
    assert moved[SHIFT] == pytest.approx(moved[NO_KEY] / 10.0, abs=0.06)


def test_arrow_keys_in_the_field_move_the_slider(controls: Column, record: Record) -> None:
    row = number(controls, "fov_y_deg")
    row.field.setFocus()
    QTest.keyClick(row.field, KEY.Key_Up)
    QTest.keyClick(row.field, KEY.Key_PageDown)
    assert [edit.lens.fov_y_deg for edit in record.edits] == [45.5, 40.5]
    assert row.field.text() == "40.5"


def test_far_reaches_infinity_at_the_end_of_its_slider(controls: Column, record: Record) -> None:
    row = number(controls, "far")
    row.slider.setFocus()
    QTest.keyClick(row.slider, KEY.Key_End)
    assert record.edits[-1].lens.far == math.inf and row.field.text() == "∞"
    QTest.keyClick(row.slider, KEY.Key_Down)
    assert 200.0 < record.edits[-1].lens.far < 300.0  # 20 times what there is behind the eye


def test_near_and_far_reach_as_far_as_the_scene(controls: Column) -> None:
    back = START.camera.distance + 3.0
    for name in ("near", "far"):
        row = number(controls, name)
        ends = row.scale.value_at(0), row.scale.value_at(row.slider.maximum() - (name == "far"))
        assert ends[0] < getattr(START.lens, name) < ends[1]
        assert back <= ends[1] <= 21.0 * back, "no decades that show nothing"
        middle = row.scale.value_at(row.scale.last // 2)
        assert middle == pytest.approx(math.sqrt(ends[0] * ends[1]), rel=0.05)


def test_near_has_the_same_ratio_of_ends_in_every_scene(controls: Column) -> None:
    for name in scene.BUILT_IN:
        loaded = scene.load(name)
        show(controls, loaded.start)
        controls.set_scene(loaded.size, loaded.start)
        row = number(controls, "near")
        if loaded.start.lens.parallel:
            assert isinstance(row.scale, Linear), name
            continue
        assert row.slider.minimum() < row.slider.value() < row.slider.maximum(), name
        assert row.scale.high == pytest.approx(40.0 * row.scale.low), name


def test_a_box_has_even_sliders_and_no_infinity(controls: Column) -> None:
    show(controls, BOX)
    record = Record(controls)
    enter(number(controls, "near"), "-12")
    assert record.edits[-1].lens.near == -12.0
    enter(number(controls, "far"), "inf")
    assert number(controls, "far").error.endswith("Far = ∞: must be a finite number.")
    row = number(controls, "far")
    row.slider.setFocus()
    QTest.keyClick(row.slider, KEY.Key_End)
    assert record.edits[-1].lens.far == 45.0


def test_a_refused_key_is_explained_until_the_next_change_of_any_kind(controls: Column) -> None:
    """The next key starts from the accepted value."""
    show(controls, CLOSE)
    row = number(controls, "near")
    last = within(row, 3.5, 5.0)[-1]
    row.slider.setFocus()
    QTest.keyClick(row.slider, KEY.Key_End)
    row.finish_gesture()  # 0.5 s later, too soon to have read it
    assert "must be less than far" in row.error and row.value() == last
    enter(number(controls, "azimuth_deg"), "20")
    assert not row.error and row.field.text() == short_text(last, None, 4)
    row.slider.setFocus()
    QTest.keyClick(row.slider, KEY.Key_End)
    assert row.error and controls.projection.lens.near == last
    QTest.keyClick(row.slider, KEY.Key_Left)
    assert not row.error and 0.9 * last < controls.projection.lens.near < last


def test_the_model_does_not_move_a_slider_in_the_users_hand(
    controls: Column, record: Record
) -> None:
    row = number(controls, "fov_y_deg")
    place = row.scale.position_of(51.0)
    press(row.slider)
    drag(row.slider, place)
    other = replace(controls.projection, lens=Perspective(51.0000000001, 1.0, 30.0))
    show(controls, other)
    assert (row.slider.value(), row.field.text()) == (place, "51")
    show(controls, replace(other, lens=Perspective(20.0, 1.0, 30.0)))
    assert row.slider.value() == place
    release(row.slider)
    assert row.field.text() == "20" and row.slider.value() == row.scale.position_of(20.0)
    assert len(record.edits) == 1


@pytest.mark.parametrize(
    "scale",
    [
        Log(6e-2, 60.0, infinite=True),
        Log(0.35, 14.0),
        Linear(1.0, 179.0, 0.5),
        Linear(1.0, 64.0, 1.0, 1),
        Linear.about(1e7, 12.0),
        Linear.about(0.0, 1e-200),
        Linear.about(2.2, 23.0),
        Linear.about(-1e130, 1e140),
        Doubling(1.0, 64.0),
    ],
    ids=repr,
)
def test_slider_positions_and_values_are_inverse(scale: Any) -> None:
    values = [scale.value_at(position) for position in range(scale.last + 1)]
    assert values == sorted(values) and len(set(values)) > scale.last / 3
    assert [scale.value_at(scale.position_of(value)) for value in values] == values
    assert scale.position_of(-1e200) == 0 and scale.position_of(math.inf) == scale.last
    if isinstance(scale, Log):
        assert (values[0], values[-1 - scale.infinite]) == (scale.low, scale.high)
        assert all(value == float(f"{value:.3e}") for value in values)  # four digits at most
        assert 1.0 in values and 10.0 in values
    else:
        assert len(set(values)) == len(values)


def test_linear_values_look_decimal() -> None:
    scale = Linear.about(0.0, 1.0)
    values = [scale.value_at(position) for position in range(scale.last + 1)]
    assert max(len(repr(value)) for value in values) <= len("-0.9995")
    assert 0.3 in values  # not 0.30000000000000004
    assert max(len(repr(value)) for value in values[:: scale.stops.key]) <= len("-0.995")


# -- orbit


@pytest.mark.parametrize("end", [90.0, -90.0])
def test_through_the_zenith_without_flips(controls: Column, record: Record, end: float) -> None:
    rows = {name: number(controls, name) for name in Orbit._fields}
    enter(rows["azimuth_deg"], "30")
    enter(rows["roll_deg"], "20")
    slider = rows["elevation_deg"].slider
    press(slider)
    for elevation in (0.0, end / 2, 0.98 * end, end, end, 0.98 * end):
        drag(slider, rows["elevation_deg"].scale.position_of(elevation))
        assert (rows["azimuth_deg"].value(), rows["roll_deg"].value()) == (30.0, 20.0)
    drag(slider, rows["elevation_deg"].scale.position_of(end))
    release(slider)
    at_end = controls.projection.camera.frame
    enter(rows["azimuth_deg"], "31")
    assert rows["elevation_deg"].value() == end and rows["roll_deg"].value() == 20.0
    # One degree of azimuth turns the picture by one degree, up there too.
    turned = controls.projection.camera.frame
    assert float(at_end[0] @ turned[0]) == pytest.approx(math.cos(math.radians(1.0)))
    enter(rows["roll_deg"], "0")
    enter(rows["elevation_deg"], "0")
    assert controls.projection.camera.orbit[:2] == pytest.approx((31.0, 0.0))


def test_an_angle_past_a_full_turn_is_taken_as_typed(controls: Column, record: Record) -> None:
    row = number(controls, "azimuth_deg")
    enter(row, "270")
    assert row.field.text() == "270" and row.slider.value() == row.slider.maximum()
    assert record.edits[0].camera.eye[0] == pytest.approx(-math.hypot(6, 9))
    enter(row, "nan")
    show(controls, START)
    show(controls, record.edits[0])
    assert row.value() == 270.0 and len(record.edits) == 1


@pytest.mark.parametrize("text", ["-", "-2"])
def test_a_text_in_a_row_that_another_lens_hides_is_dropped(
    controls: Column, record: Record, text: str
) -> None:
    """Hiding the row takes the keyboard away from its field, which ends the typing."""
    show(controls, BOX)
    row = number(controls, "bottom")
    row.field.setFocus()
    row.field.selectAll()
    QTest.keyClicks(row.field, text)
    show(controls, START)
    assert row.isHidden() and not row.field.hasFocus()
    show(controls, BOX)
    show(controls, replace(BOX, image_size=(100, 100)))
    assert row.field.text() == "-3" and row.error == "" and record.edits == []


# -- typed


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1,5", 1.5), (" 2.5 ", 2.5), (".5", 0.5), ("5.", 5.0), ("1E-3", 1e-3), ("1e-90", 1e-90),
        ("0.1234567890123456", 0.1234567890123456), ("2.5 units", 2.5), ("1/3", 1 / 3),
        ("-2/-7", 2 / 7), ("-2/7", -2 / 7), ("0/5", 0.0), (" 1,5 / 4 units", 0.375),
        ("−1,5e−3", -1.5e-3), ("inf", math.inf), ("∞", math.inf), ("Infinity", math.inf),
        ("+inf", math.inf), ("-∞", -math.inf),
    ],
)  # fmt: skip
def test_a_number_is_read_as_it_is_typed(text: str, value: float) -> None:
    assert parse_number("Near", text, "units") == value


@pytest.mark.parametrize(
    ("text", "bound"),
    [
        ("1.000,5", "messages-a-number"), ("1'000", "messages-a-number"),
        ("½", "messages-a-number"), ("\uff11", "messages-a-number"),
        ("1e300/1e-300", "at-most"), ("1e300/-1e-300", "at-least"), ("-1e400", "at-least"),
        ("1/1e400", "at-most"), ("1e-300/1e300", "distinct"), ("1/1e-400", "distinct"),
    ],
)  # fmt: skip
def test_a_text_beyond_float64_is_refused(text: str, bound: str) -> None:
    with pytest.raises(Refusal) as caught:
        parse_number("Near", text)
    assert caught.value.bound == REFUSALS[bound]


def test_what_the_dock_shows_can_be_set(controls: Column) -> None:
    """With its unit, and in the window's own notation: −0.00002 may be −2e-5."""
    camera = replace(START.camera, eye=(-0.00002, 123457.0, -1.5e9))
    for like in (START, OFF_AXIS, BOX):
        state, kind = replace(like, camera=camera), like.lens.kind
        show(controls, state)
        for section in controls.sections.values():
            section.set_open(True)
        shown = {
            f"{field.section}.{field.name}": number(controls, field.name)
            for field in (*lens_fields(kind), *IMAGE)
            if isinstance(controls.rows.get(field.name), NumberRow)
        }
        assert "lens.near" in shown and "image.width" in shown
        texts = [
            f"{path}={row.field.text()} {row.unit_label.text()}" for path, row in shown.items()
        ]
        eye = [number(controls, f"eye_{axis}").field.text() for axis in "xyz"]
        texts.append(f"camera.eye=({', '.join(eye)})")
        found = set_values(Document(projection=state), [f"lens.kind={kind}", *texts]).projection
        assert found.camera.eye == camera.eye
        assert found.lens == state.lens and found.image_size == state.image_size


def test_out_of_the_sliders_range_pins_the_slider(controls: Column, record: Record) -> None:
    row = number(controls, "far")
    enter(row, "1e20")
    assert record.edits[0].lens.far == 1e20
    assert row.slider.value() == row.slider.maximum() - 1  # the top is infinity
    row = number(controls, "fov_y_deg")
    enter(row, "0.25")
    assert record.edits[1].lens.fov_y_deg == 0.25 and row.slider.value() == 0
    row = number(controls, "width")
    enter(row, "9000")
    assert record.edits[2].image_size == (9000, 720) and row.slider.value() == row.slider.maximum()


def test_nonsense_is_refused_in_every_field(controls: Column) -> None:
    # Every nonsense in one field; what a field alone reads is the same in all.
    for key, record in each(controls, NUMBERS):
        before = controls.projection
        row = number(controls, key)
        for text in NONSENSE if key in ("near", "far") else NONSENSE[:3]:
            enter(row, text)
            assert row.error.startswith("Not possible. "), (key, text)
            assert row.error.endswith(".") and row.name in row.error
            assert text.strip() in row.error
            assert row.field.text() == text  # where it can be put right
            assert row.field.accessibleDescription() == row.error
        row.slider.setFocus()
        assert row.field.text() == text
        row.field.setFocus()
        assert record.edits == [] and controls.projection is before, key
        QTest.keyClick(row.field, KEY.Key_Escape)
        assert row.error == ""
        assert row.field.text() == short_text(row.value(), row.field.below, 4)


REFUSED = [
    # a bound that is another value, from both sides; a bound of its own
    ("near", "30", "Near = 30: must be less than far, which is 30."),
    ("far", "0.5", "Far = 0.5: must be greater than near, which is 1."),
    ("left", "4", "Left = 4: must be less than right, which is 4."),
    ("top", "-9", "Top = -9: must be greater than bottom, which is -3."),
    ("near", "0", "Near = 0: must be greater than 0."),
    ("fov_x_deg", "180", "Horizontal fov = 180: must lie between 0 and 180, both excluded."),
    ("focal_length_mm", "-50", "Focal length = -50: must be greater than 0."),
    ("up_y", "0", "Up = (0, 0, 0): must not be the zero vector."),
    ("height", "1.5", "Height = 1.5: must be a whole number of pixels from 1 to 16384."),
    ("window_top", "0", "Half-height = 0: must be greater than 0."),
    ("alpha_deg", "180", "Alpha = 180: must lie between 0 and 180, both excluded."),
    ("receding", "1e7", "Receding = 10000000: must be at most 1000000."),
    ("fx", "0", "fx = 0: must be greater than 0."),
    # infinity, and what is beyond all numbers: the bound of the row, if it has one
    ("near", "inf", "Near = ∞: must be less than far, which is 30."),
    ("near", "-inf", "Near = -∞: must be greater than 0."),
    ("elevation_deg", "inf", "Elevation = ∞: must be at most 90."),
    ("azimuth_deg", "inf", "Azimuth = ∞: must be a finite number."),
    ("fov_x_deg", "inf", "Horizontal fov = ∞: must lie between 0 and 180, both excluded."),
    ("height", "inf", "Height = ∞: must be a whole number of pixels from 1 to 16384."),
    ("near", "1e308", "Near = 1e+308: must be less than far, which is 30."),
    ("elevation_deg", "-1e308", "Elevation = -1e+308: must be at least -90."),
    ("fov_y_deg", "1e308", "Field of view = 1e+308: must lie between 0 and 180, both excluded."),
    ("azimuth_deg", "1e308", "Azimuth = 1e+308: must be at most 1e+100."),
    ("far", "1e308", "Far = 1e+308: must be at most 1e+100."),
    # digits that float64 cannot keep
    ("near", "1e400", f"Near = “1e400”: must be at most {LARGEST}."),
    ("near", "1e-400", "Near = “1e-400”: is too close to 0 for float64 to tell the two apart."),
    # a word: all bounds of the row, with an example that it accepts
    ("near", "nan", "Near = “nan”: must be a number, such as 0.5 or 2e-3; must be greater than 0;"
     " must be less than far, which is 30."),
    ("far", "nan", "Far = “nan”: must be a number, or inf for ∞; must be greater than near, which"
     " is 1."),
    ("eye_y", "nan", "Eye y = “nan”: must be a number, such as 0.5 or 2e-3."),
    ("width", "abc", "Width = “abc”: must be a number, such as 1280; must be a whole number of"
     " pixels from 1 to 16384."),
]  # fmt: skip


def test_a_refusal_of_the_model_is_explained_at_the_row(controls: Column) -> None:
    keys = (key for key, _, _ in REFUSED)
    for (key, text, expected), (_, record) in zip(REFUSED, each(controls, keys), strict=True):
        row = number(controls, key)
        before = controls.projection, row.slider.value()
        enter(row, text)
        assert row.error == f"Not possible. {expected}"
        assert row.field.text() == text
        assert record.edits == [] and (controls.projection, row.slider.value()) == before


def test_limits_are_as_short_as_the_fields_show_them(controls: Column) -> None:
    lens = Orthographic(-8.227704165888369, 8.227696165888, -3.0, 3.0, 1.0, 30.0)
    show(controls, replace(BOX, lens=lens))
    left, right = number(controls, "left"), number(controls, "right")
    enter(left, "9")
    assert left.error.endswith("Left = 9: must be less than right, which is 8.2277.")
    enter(right, "-9")
    assert right.error.endswith("Right = -9: must be greater than left, which is -8.2277.")
    enter(left, "8.227699")  # which is less than 8.2277
    assert left.error.endswith("must be less than right, which is 8.227696165888.")
    camera = Camera((1 / 3, 2 / 3, 5.0), (1 / 3, 2 / 3, 0.0))
    show(controls, replace(START, camera=camera))
    controls.sections["more_camera"].set_open(True)
    enter(number(controls, "eye_z"), "0")
    assert "Eye = (0.333333, 0.666667, 0): must differ" in number(controls, "eye_z").error


def test_eye_on_target_and_up_along_the_view(controls: Column) -> None:
    controls.sections["more_camera"].set_open(True)
    start = replace(START, camera=Camera((0.0, 2.0, 5.0), (0.0, 2.0, 0.0)))
    show(controls, start)
    record = Record(controls)
    enter(number(controls, "eye_z"), "0")
    assert number(controls, "eye_z").error.endswith(
        "Eye = (0, 2, 0): must differ from the target, or the camera looks nowhere."
    )
    enter(number(controls, "target_z"), "5")
    assert number(controls, "target_z").error.endswith(
        "Target = (0, 2, 5): must differ from the eye, or the camera looks nowhere."
    )
    assert record.edits == []
    enter(number(controls, "up_z"), "1")
    enter(number(controls, "up_y"), "0")
    assert number(controls, "up_y").error.endswith(
        "Up = (0, 0, 1): must not be parallel to the view direction."
    )
    enter(number(controls, "up_y"), "1e-12")  # as near as the issue asks
    assert controls.projection.camera.up == (0.0, 1e-12, 1.0)
    assert len(record.edits) == 2


def test_leaving_the_field_takes_what_was_typed(controls: Column, record: Record) -> None:
    row = number(controls, "near")
    row.field.setFocus()
    row.field.selectAll()
    QTest.keyClicks(row.field, "2")
    assert record.edits == []
    QTest.keyClick(row.field, KEY.Key_Tab)
    assert record.edits[0].lens.near == 2.0


LONG = 14.51302281719


def test_a_taken_number_is_shown_short_from_its_start(controls: Column, record: Record) -> None:
    row = number(controls, "azimuth_deg")
    enter(row, repr(LONG))
    assert row.field.hasFocus() and row.field.text() == "14.51"
    assert row.field.cursorPosition() == 0 and row.value() == LONG
    place = row.field.rect().center()
    asked = QHelpEvent(QEvent.Type.ToolTip, place, row.field.mapToGlobal(place))
    QApplication.sendEvent(row.field, asked)
    assert repr(LONG) in row.field.toolTip()
    row.slider.setFocus()  # not a second edit, and no digit is lost
    assert (row.value(), len(record.edits)) == (LONG, 1)
    enter(row, "1e12")
    assert row.field.text() == "1e12" and row.value() == 1e12
    row.field.setFocus()
    row.setDefault(LONG)
    QTest.keyClicks(row.field, "5")
    row.actions()[0].trigger()
    assert row.field.hasFocus() and row.field.text() == "14.51"
    assert row.field.cursorPosition() == 0
    row.slider.setFocus()
    assert row.value() == LONG  # the 5 is forgotten


def test_a_short_number_is_whole_as_soon_as_it_is_touched(controls: Column) -> None:
    row = number(controls, "azimuth_deg")
    field = row.field
    enter(row, repr(LONG))
    for key in (KEY.Key_Shift, KEY.Key_Return):
        QTest.keyClick(field, key)
        assert field.text() == "14.51"
    QTest.keyClicks(field, "1")
    assert field.text() == f"1{LONG!r}"
    QTest.keyClick(field, KEY.Key_Return)
    assert row.value() == float(f"1{LONG!r}") and field.text() == "114.5"
    QTest.mouseClick(field, Qt.MouseButton.LeftButton)
    assert field.text() == f"1{LONG!r}"
    QTest.keyClick(field, KEY.Key_Return)
    QTest.keyClick(field, KEY.Key_A, Qt.KeyboardModifier.ControlModifier)
    assert field.selectedText() == f"1{LONG!r}"
    QTest.keyClick(field, KEY.Key_Return)
    field.setCursorPosition(0)
    event = QInputMethodEvent()
    event.setCommitString("2")
    QApplication.sendEvent(field, event)
    assert field.text() == f"21{LONG!r}"


def test_entering_a_field_by_the_keyboard_shows_the_start_of_the_number(controls: Column) -> None:
    row = number(controls, "azimuth_deg")
    enter(row, repr(LONG))
    before = number(controls, "far").slider
    before.setFocus()
    QTest.keyClick(before, KEY.Key_Tab)
    assert row.field.selectedText() == row.field.text() == repr(LONG)
    assert row.field.cursorPosition() == 0
    show(controls, replace(START, camera=Camera((1.0, 2.0, 3.0), (0.0, 2.0, 0.0))))
    assert row.field.selectedText() == row.field.text() == "18.43"  # atan(1/3)
    QTest.keyClicks(row.field, "7")
    assert row.field.text() == "7"
    QTest.keyClick(row.field, KEY.Key_Escape)
    assert row.field.text() == short_text(row.value(), row.field.below, 4)


def test_undo_in_a_field_without_own_history_is_the_windows(controls: Column) -> None:
    from PySide6.QtGui import QShortcut

    asked = []
    shortcut = QShortcut("Ctrl+Z", controls)
    shortcut.activated.connect(lambda: asked.append("undo"))
    row = number(controls, "near")
    row.field.setFocus()
    QTest.keyClicks(row.field, "7")
    QTest.keyClick(row.field, KEY.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert asked == []
    enter(row, "3")
    QTest.keyClick(row.field, KEY.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert asked == ["undo"]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.1, "0.1"), (30.0, "30"), (-123.456, "-123.456"), (1 / 3, "0.333333"),
        (29.999999999999996, "30"), (-1.23456789e-12, "-1.23e-12"), (1e9, "1e9"),
        (1234567.0, "1234567"), (1e7, "10000000"), (-99999999.4, "-99999999"),
        (10000004.976, "10000005"),  # an eye far from the origin, and its target
        (99999999.6, "1e8"), (math.inf, "∞"), (1e-300, "1e-300"),
        (-1.7976931348623157e150, "-1.8e150"),
    ],
)  # fmt: skip
def test_shown_numbers_are_short_and_never_cut(value: float, text: str) -> None:
    assert short_text(value) == text and len(text) <= 9


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (180.0 - 2.0**-45, "180-3e-14"),  # the largest float64 below
        (179.99999999999, "180-1e-11"), (179.99996, "180-4e-05"), (179.9996, "179.9996"),
        (120.0, "120"), (1e-12, "1e-12"), (5e-324, "5e-324"), (179.5, "179.5"),
    ],
)  # fmt: skip
def test_an_angle_never_shows_as_the_bound_that_it_cannot_reach(value: float, text: str) -> None:
    assert short_text(value, below=180.0) == text and len(text) <= 9


def test_near_and_far_never_look_alike(controls: Column) -> None:
    """Whichever of them moves, and back again."""
    near, far = number(controls, "near"), number(controls, "far")
    shown = []
    for row, text in (
        (near, "29.9999"),
        (near, "30-1e-9"),
        (near, "4"),
        (far, "4.00001"),
        (far, "9"),
    ):
        value = 30.0 - 1e-9 if text == "30-1e-9" else float(text)
        enter(row, repr(value))
        assert not row.error
        shown.append((near.field.text(), far.field.text()))
    assert shown == [
        ("29.9999", "30"), ("30-1e-09", "30"), ("4", "30"), ("4", "4.00001"), ("4", "9"),
    ]  # fmt: skip


@pytest.mark.parametrize("key", ["fov_y_deg", "fov_x_deg"])
def test_a_fov_of_almost_180_is_shown_as_less(controls: Column, key: str) -> None:
    controls.sections["more_lens"].set_open(True)
    enter(number(controls, "focal_length_mm"), "1e-12")
    row = number(controls, key)
    assert row.field.text().startswith("180-")
    assert row.value() < 180.0
    row.field.setFocus()
    assert row.field.text().startswith("179.9999999999")  # whole, and a number to be edited
    enter(row, "180")
    assert row.error and row.value() < 180.0


def test_the_field_is_wide_enough_for_what_it_shows(controls: Column) -> None:
    field = number(controls, "near").field
    for value in (-123.456789, 1e-300, 6e9, -1.23456789e-12):
        text = field.fontMetrics().horizontalAdvance(short_text(value))
        assert text <= field.contentsRect().width() - 4


# -- reset, scene


def test_a_double_click_on_the_name_resets(controls: Column, reader: Reader) -> None:
    lenses = {
        "perspective": Perspective(70.0, 0.5, 70.0),
        "orthographic": Orthographic(-1.0, 1.0, -1.0, 1.0, -1.0, 70.0),
        "oblique": Oblique(-1.0, 1.0, -1.0, 1.0, -1.0, 70.0, "stretch", 50.0, 60.0),
    }
    camera = Camera((1.0, 2.5, 3.0), (-1.0, 0.5, -3.0), (0.5, 0.6, 0.7))
    for key, record in each(controls, NUMBERS):
        kind = controls.projection.lens.kind
        placement = FiveTiles((1.0, 2.0, 3.0), (10.0, 20.0, 30.0), (2.0, 3.0, 4.0)).chain
        show(controls, Projection(camera, lenses[kind], (99, 88), placement=placement))
        row = number(controls, key)
        QTest.mouseDClick(row.name_label, Qt.MouseButton.LeftButton)
        assert record.events == ["start", "edit", "finish"], key
        wanted = reader.read(key, START.with_lens(kind))
        assert row.value() == pytest.approx(wanted), key
        assert reader.read(key, record.edits[0]) == pytest.approx(wanted), key
        QTest.mouseDClick(row.name_label, Qt.MouseButton.LeftButton)
        assert record.events == ["start", "edit", "finish"], key  # nothing left to reset


def test_a_reset_removes_a_refused_text(controls: Column, record: Record) -> None:
    row = number(controls, "near")
    enter(row, "abc")
    QTest.mouseDClick(row.name_label, Qt.MouseButton.LeftButton)
    assert (row.error, row.field.text()) == ("", "1") and record.edits == []


def test_choices_are_reset_by_their_name(controls: Column) -> None:
    show(controls, replace(BOX, depth="reversed", image_size=(5, 7)))
    record = Record(controls)
    controls.sections["image"].set_open(True)
    for key in ("depth", "aspect", "kind"):
        QTest.mouseDClick(controls.rows[key].name_label, Qt.MouseButton.LeftButton)
    assert record.edits[-1].depth == "opengl" and record.edits[-1].image_size == (12, 7)
    assert record.edits[-1].lens.kind == "perspective"


def test_another_scene_moves_the_sliders_and_says_nothing(controls: Column, record: Record) -> None:
    large = Projection(Camera((1e4, 2e4, 3e4)), Perspective(30.0, 1000.0, 1e6))
    controls.set_scene(2e4, large)
    assert record.events == []
    row = number(controls, "near")
    assert row.scale.value_at(0) < 1000.0 < row.scale.value_at(row.scale.last)
    QTest.mouseDClick(number(controls, "far").name_label, Qt.MouseButton.LeftButton)
    assert record.edits[0].lens.far == 1e6
    far_away = replace(large, camera=Camera((1e7 + 5.0, 5.0, 1e7), (1e7, 0.0, 1e7)))
    controls.set_scene(2.0, far_away)
    controls.sections["more_camera"].set_open(True)
    show(controls, far_away)
    row = number(controls, "eye_x")
    assert row.slider.minimum() < row.slider.value() < row.slider.maximum()


def test_any_size_of_scene_has_sliders(controls: Column) -> None:
    for size in [1e-80, 1e-6, 1.0, 1e9, 1e80]:
        lens = Perspective(45.0, 0.1 * size, 10.0 * size)
        start = Projection(Camera((0.0, 0.0, 2.0 * size), (0.0, 0.0, 0.0)), lens)
        controls.set_scene(size, start)
        show(controls, start)
        record = Record(controls)
        for key in ("near", "far", "distance", "azimuth_deg"):
            row = number(controls, key)
            QTest.keyClick(row.slider, KEY.Key_Up)
            row.finish_gesture()
            assert row.error == "", key
        assert len(record.edits) == 4


# -- folding


def test_a_folded_section_is_updated_when_it_opens(controls: Column, record: Record) -> None:
    section, row = controls.sections["more_camera"], number(controls, "roll_deg")
    assert not section.is_open and not row.isVisible()
    before = row.value()
    rolled = Camera.from_orbit((0.0, 2.0, 0.0), Orbit(50.0, -20.0, 8.0, 10.0))
    show(controls, replace(START, camera=rolled))
    assert row.value() == before != 10.0  # not touched
    section.heading.setFocus()
    QTest.keyClick(section.heading, KEY.Key_Space)
    assert row.field.text() == "10" and row.isVisible()
    show(controls, replace(START, image_size=(12, 34)))
    assert number(controls, "height").value() != 34.0
    controls.sections["image"].set_open(True)
    assert number(controls, "height").value() == 34.0
    assert record.events == []


def test_sections_fold_by_the_keyboard_and_stay_so(controls: Column, record: Record) -> None:
    assert not any(section.is_open for section in controls.sections.values())
    for section in controls.sections.values():
        section.set_open(True)
        heading = section.heading
        heading.setFocus(Qt.FocusReason.TabFocusReason)
        assert heading.hasFocus() and heading.focusPolicy() & Qt.FocusPolicy.TabFocus
        for key, is_open in (
            (KEY.Key_Space, False),
            (KEY.Key_Return, True),
            (KEY.Key_Right, True),
            (KEY.Key_Left, False),
            (KEY.Key_Left, False),
            (KEY.Key_Enter, True),
            (KEY.Key_Space, False),
        ):
            QTest.keyClick(heading, key)
            assert section.is_open == is_open, key
            said = "unfolded" if is_open else "folded"
            assert heading.accessibleDescription() == said and heading.hasFocus()
    # Neither another scene, lens nor hiding the column unfolds them.
    show(controls, BOX)
    controls.set_scene(60.0, BOX)
    controls.hide()
    controls.show()
    assert not any(section.is_open for section in controls.sections.values())
    assert record.edits == []
    QTest.keyClick(controls.sections["more_lens"].heading, KEY.Key_Right)
    assert controls.rows["keep"].isVisible()


def test_a_section_that_opens_below_the_fold_comes_into_view(controls: Column, qtbot: Any) -> None:
    controls.resize(320, 560)
    heading = controls.sections["animation"].heading
    heading.setFocus(Qt.FocusReason.TabFocusReason)
    controls.resize(285, 560)
    controls.sections["more_camera"].set_open(True)
    QApplication.processEvents()
    controls.verticalScrollBar().setValue(0)
    QTest.keyClick(heading, KEY.Key_Right)
    look, viewport = controls.animation.look, controls.viewport()

    def in_view() -> bool:
        ends = [part.mapTo(viewport, QPoint()).y() for part in (heading, look)]
        return ends[0] >= 0 and ends[1] + look.height() <= viewport.height()

    qtbot.waitUntil(in_view)


def own_rows(lens: type[Lens]) -> set[str]:
    """Return the rows of a lens's fields, and of the other numbers that define those."""
    rows = {field.name for field in fields(lens)} - {"near", "far"}
    if lens.symmetric:
        rows |= {"fov_x_deg", "focal_length_mm", "e", "window_right", "window_top"}
    if "alpha_deg" in rows:
        rows |= {"preset", "receding", "receding_deg"}
    return rows


OWN_ROWS = {kind: own_rows(lens) for kind, lens in LENSES.items()}


def test_the_lens_shows_only_its_own_rows(controls: Column) -> None:
    others = set().union(*OWN_ROWS.values())
    more = controls.sections["more_lens"]
    more.set_open(True)
    for kind in (*OWN_ROWS, *reversed(OWN_ROWS)):
        choose(choice(controls, "kind"), kind)
        assert controls.projection.lens.kind == kind
        assert {key for key in others if controls.rows[key].isVisible()} == OWN_ROWS[kind]
        has_k = LENSES[kind].central
        heading = next(label for label in more.findChildren(QLabel) if "OpenCV" in label.text())
        assert heading.isVisible() == controls.rows["fx"].isVisible() == has_k
        for key in ("near", "far"):
            assert number(controls, key).value() == getattr(controls.projection.lens, key)


# -- for everyone


def test_every_control_has_a_name_and_a_tip(controls: Column) -> None:
    widgets = [
        widget
        for kind in (QSlider, QLineEdit, QComboBox, QToolButton)
        for widget in controls.widget().findChildren(kind)
    ]
    assert len(widgets) > 60
    for widget in widgets:
        assert widget.accessibleName() and widget.toolTip(), widget
        said = QAccessible.queryAccessibleInterface(widget).text(QAccessible.Text.Description)
        assert said and not re.search("<qt>|<b|&#", said), said
    names = [widget.accessibleName() for widget in widgets if isinstance(widget, QLineEdit)]
    assert len(set(names)) == len(names)
    row = number(controls, "near")
    tip = row.field.accessibleDescription()
    assert tip.startswith("Distance from the eye to the near plane")  # the field has the value
    enter(row, "x")
    assert row.field.accessibleDescription() == row.error != ""
    QTest.keyClick(row.field, KEY.Key_Escape)
    assert row.field.accessibleDescription() == tip
    # A screen reader knows only a slider's position: it gets the value when the hand rests.
    for act, value in (
        (row.slider.setFocus, "1 world units. "),
        (lambda: QTest.keyClick(row.slider, KEY.Key_Right), "1 world units. "),
        (row.finish_gesture, "1.046 world units. "),
        (lambda: row.setValue(2.0), "2 world units. "),  # it was undone
    ):
        act()
        assert row.slider.accessibleDescription() == value + tip


def test_tab_goes_through_the_rows_in_their_order(controls: Column) -> None:
    row, following = number(controls, "fov_y_deg"), number(controls, "near")
    row.field.setFocus()
    visited = [QApplication.focusWidget()]
    for _ in range(3):
        QTest.keyClick(QApplication.focusWidget(), KEY.Key_Tab)
        visited.append(QApplication.focusWidget())
    assert visited == [row.field, row.slider, following.field, following.slider]


def unfold(controls: Column) -> None:
    for section in controls.sections.values():
        section.set_open(True)
    QApplication.processEvents()


@pytest.mark.parametrize("font", [1.0, 1.25, 1.5])
def test_nothing_is_cut_in_the_narrowest_dock_with_any_lens(
    controls: Column, font: float, larger_text: Callable[[float], None]
) -> None:
    larger_text(font)
    unfold(controls)
    for kind in OWN_ROWS:
        choose(choice(controls, "kind"), kind)
        QApplication.processEvents()
        controls.resize(controls.minimumSizeHint().width(), 690)
        QApplication.processEvents()
        assert controls.width() <= 270 * font and cut(controls) == [], kind
    shown = [slider for slider in controls.findChildren(QSlider) if slider.isVisible()]
    assert len(shown) > 15 and {slider.width() for slider in shown} == {shown[0].width()}
    assert shown[0].width() >= 240


def test_a_long_text_being_typed_leaves_the_dock_as_wide(controls: Column) -> None:
    width = controls.minimumSizeHint().width()
    enter(number(controls, "near"), "4" * 300)
    QApplication.processEvents()
    assert controls.widget().width() <= controls.viewport().width()
    assert controls.minimumSizeHint().width() == width <= 270


def test_the_letter_f_needs_no_scrolling_in_a_small_window(controls: Column) -> None:
    start = scene.load("letter-f")
    controls.card.show_scene("Letter F", start.tries, None)
    controls.set_scene(start.size, start.start)
    show(controls, start.start)
    controls.resize(285, 690)
    QApplication.processEvents()
    assert controls.card.tries.isVisible() and controls.card.tries.text().count("\n") == 2
    assert controls.verticalScrollBar().maximum() == 0
    six = ("fov_y_deg", "near", "far", "azimuth_deg", "elevation_deg", "distance")
    folded = [section.heading for section in controls.sections.values()]
    for part in (*(controls.rows[key] for key in six), *folded):
        assert not part.visibleRegion().isEmpty(), part
        assert part.visibleRegion().boundingRect() == part.rect()


@pytest.fixture
def larger_text(controls: Column, qapp: QApplication) -> Iterator[Callable[[float], None]]:
    """Makes all text of the column larger, as for a class."""
    before = qapp.font()

    def enlarge(factor: float) -> None:
        larger = QFont(before)
        larger.setPointSizeF(factor * before.pointSizeF())
        qapp.setFont(larger)
        controls.setFont(larger)
        QApplication.processEvents()

    yield enlarge
    qapp.setFont(before)


@pytest.fixture
def enlarged(controls: Column, larger_text: Callable[[float], None]) -> Controls:
    larger_text(1.5)
    controls.resize(controls.minimumSizeHint().width(), 640)
    QApplication.processEvents()
    return controls


def test_an_error_is_shown_whole_in_any_width(enlarged: Controls, qtbot: Any) -> None:
    row = number(enlarged, "near")
    lines = set()

    def shown_whole() -> bool:  # a layout tells the one around it in the next turn of the loop
        label = row.findChild(QLabel, "rowError")
        assert isinstance(label, QLabel)
        assert label.font().pointSizeF() == enlarged.font().pointSizeF()
        lines.add(label.height() // label.fontMetrics().lineSpacing())
        needed = label.heightForWidth(label.width())
        return label.height() >= needed and row.rect().contains(label.geometry())

    for length in range(2, 40, 3):
        enter(row, "nearer and nearer, but never quite there"[:length])
        for width in (0, 200, 0):  # beyond the least
            enlarged.resize(enlarged.minimumSizeHint().width() + width, 640)
            qtbot.waitUntil(shown_whole)
    assert {3, 4} <= lines


def test_the_scroll_bar_shifts_nothing(controls: Column) -> None:
    bar, row = controls.verticalScrollBar(), number(controls, "near")
    controls.resize(340, 1600)
    QApplication.processEvents()
    assert not bar.isVisible()
    before = row.slider.geometry(), row.field.geometry(), controls.minimumSizeHint()
    controls.resize(340, 500)
    QApplication.processEvents()
    assert bar.isVisible()
    assert (row.slider.geometry(), row.field.geometry(), controls.minimumSizeHint()) == before
    assert row.mapTo(controls, row.rect().topRight()).x() < bar.mapTo(controls, QPoint()).x()
    controls.resize(340, 1600)
    QApplication.processEvents()
    assert not bar.isVisible() and row.slider.geometry() == before[0]


# -- the controls that matter for a scene


def in_card(controls: Column) -> list[str]:
    """The rows that stand in the scene's card, from top to bottom."""
    lifted = [key for key, row in controls.rows.items() if controls.card.isAncestorOf(row)]
    return sorted(lifted, key=lambda key: controls.rows[key].y())


def test_the_controls_that_matter_stand_at_the_top_and_nowhere_else(
    controls: Column, record: Record, qtbot: Any
) -> None:
    far, near = controls.rows["far"], controls.rows["near"]
    before = [far.mapTo(controls, QPoint()).y(), far.parent()]
    controls.bring_to_front(("lens.far", "camera.roll_deg"))
    QApplication.processEvents()
    assert in_card(controls) == ["far", "roll_deg"]
    assert far.isVisible() and far.mapTo(controls, QPoint()).y() < before[0]
    assert far.y() < controls.card.height() and far.mapTo(controls, QPoint()).y() < (
        near.mapTo(controls, QPoint()).y()
    )
    # A row of a folded section is read and written like the visible ones.
    assert controls.rows["roll_deg"].isVisible() and not controls.sections["more_camera"].is_open
    rolled = Camera.from_orbit((0.0, 2.0, 0.0), Orbit(50.0, -20.0, 8.0, 10.0))
    show(controls, replace(START, camera=rolled))
    assert number(controls, "roll_deg").field.text() == "10"
    enter(number(controls, "roll_deg"), "20")
    assert record.edits[-1].camera.orbit.roll_deg == pytest.approx(20.0)
    controls.bring_to_front(("lens.near",))
    assert in_card(controls) == ["near"]
    controls.bring_to_front(())
    assert in_card(controls) == []
    qtbot.waitUntil(lambda: [far.mapTo(controls, QPoint()).y(), far.parent()] == before)
    order = [controls.rows[key].mapTo(controls, QPoint()).y() for key in ("fov_y_deg", "near")]
    assert order[0] < order[1] < before[0]


def test_a_control_of_another_lens_comes_to_the_top_with_it(controls: Column) -> None:
    controls.bring_to_front(("lens.left", "lens.right"))
    assert not controls.rows["left"].isVisible()
    show(controls, OFF_AXIS)
    QApplication.processEvents()
    assert controls.rows["left"].isVisible() and in_card(controls) == ["left", "right"]
    cells: Any = tuple(tuple(float(i == j) for j in range(4)) for i in range(4))
    show(controls, replace(START, lens=FreeMatrix(cells)))
    assert not controls.rows["left"].isVisible() and not controls.rows["near"].isVisible()


def test_every_scene_has_three_lines_to_try_and_few_controls(controls: Column) -> None:
    for name in scene.BUILT_IN:
        loaded = scene.load(name)
        tries = loaded.tries
        assert len(tries) == 3 and len(set(tries)) == 3
        assert all(line.endswith((".", "?")) and len(line) <= 42 for line in tries)
        assert sum(line.endswith("?") for line in tries) >= 1
        controls.card.show_scene(name, tries, loaded.phenomenon)
        assert controls.card.tries.text().split("\n") == list(tries)
        phenomenon = loaded.phenomenon
        if phenomenon is not None:
            controls.bring_to_front(phenomenon.controls)
            show(controls, loaded.start)
            controls.card.show_illustration(
                phenomenon.illustration(loaded.start, phenomenon.checked({}), loaded.subject),
                phenomenon.checked({}),
                loaded.start,
            )
            QApplication.processEvents()
            rows = [
                *controls.card.rows.values(),
                *(controls.rows[key] for key in in_card(controls)),
            ]
            assert 2 <= sum(row.isVisible() for row in rows) <= 4
        controls.resize(270, 690)
        QApplication.processEvents()
        assert controls.minimumSizeHint().width() == 270 and cut(controls) == []


# -- looking for a control


def look_for(controls: Column, text: str) -> list[str]:
    """Type into the search box and return the rows that are visible then."""
    controls.search.setFocus()
    controls.search.selectAll()
    QTest.keyClicks(controls.search, text)
    QApplication.processEvents()
    return [key for key, row in controls.rows.items() if row.isVisible()]


def test_a_control_is_found_by_each_of_its_names(controls: Column, record: Record) -> None:
    for text, found in [
        ("near", ["near"]),
        ("Vertical FOV", ["fov_y_deg"]),  # its old name
        ("focal e", ["e"]),
        ("zoom", ["fov_y_deg", "focal_length_mm"]),
        ("K", ["fx", "fy", "cx", "cy"]),
        ("fx", ["fx"]),
        ("roll", ["roll_deg"]),
        ("view-up", ["up_x", "up_y", "up_z"]),
        ("telephoto", ["focal_length_mm"]),  # a word of its tooltip
        ("aspect", ["aspect"]),
        ("NDC z", ["depth"]),
        ("half", ["e", "window_right", "window_top"]),
    ]:
        open_before = {key: section.is_open for key, section in controls.sections.items()}
        assert sorted(look_for(controls, text)) == sorted(found)
        for key in found:
            row = controls.rows[key]
            assert not row.visibleRegion().isEmpty(), "it is in view"
            if isinstance(row, NumberRow):
                assert row.value() == pytest.approx(row.value()) and row.field.text()
        QTest.keyClick(controls.search, KEY.Key_Escape)
        QApplication.processEvents()
        assert controls.search.text() == "" and controls.rows["azimuth_deg"].isVisible()
        assert {key: section.is_open for key, section in controls.sections.items()} == open_before
        assert record.events == []


@pytest.mark.parametrize("typed", ["zarisna", "žarišna", "ŽARIŠ", "medu", "među", "duljina zar"])
def test_a_search_needs_no_accents(typed: str, qapp: QApplication) -> None:
    part, other = QWidget(), QWidget()
    texts = {part: ControlTexts("Žarišna duljina među", ""), other: ControlTexts("Zakret", "")}
    assert find(typed, texts) == {part}


def test_a_search_leaves_no_title_without_a_row(controls: Column) -> None:
    def title() -> bool:
        labels = controls.widget().findChildren(QLabel)
        return next(each for each in labels if each.text().startswith("Calibrated")).isVisible()

    assert look_for(controls, "horizontal") == ["fov_x_deg"] and not title()
    assert look_for(controls, "fx") == ["fx"] and title()
    show(controls, SLANTED)  # no K
    assert not title()


def test_a_found_row_can_be_edited_and_stays_unfolded(controls: Column, record: Record) -> None:
    look_for(controls, "width pixels")
    row = number(controls, "width")
    assert row.isVisible() and row.field.text() == "1280"
    QTest.keyClick(controls.search, KEY.Key_Return)
    QApplication.processEvents()
    assert row.field.hasFocus() and row.isVisible() and controls.search.text() == ""
    assert controls.sections["image"].is_open and controls.rows["near"].isVisible()
    QTest.keyClicks(row.field, "640")
    QTest.keyClick(row.field, KEY.Key_Return)
    assert record.edits[-1].image_size == (640, 720)
    look_for(controls, "walk")
    assert controls.animation.isVisible()


def test_the_chain_is_found_by_its_heading_and_shown(controls: Column) -> None:
    controls.resize(300, 200)
    for text in ("chain", "tile", "rotation"):
        look_for(controls, text)
        assert controls.chain.isVisible(), text
        QTest.keyClick(controls.search, KEY.Key_Return)
        QApplication.processEvents()
        add = controls.chain.add
        assert add.hasFocus() and not add.visibleRegion().isEmpty(), f"{text}: it is in view"
        controls.sections["object"].set_open(False)


def test_a_control_of_another_lens_names_that_lens(controls: Column) -> None:
    said = [label for label in controls.widget().findChildren(QLabel) if not label.isVisible()]
    assert look_for(controls, "alpha") == []
    shown = [label.text() for label in said if label.isVisible()]
    assert shown == ["Alpha: only with the lens “oblique”."]
    look_for(controls, "flux capacitor")
    assert [label.text() for label in said if label.isVisible()] == ["No control has this name."]
    show(controls, SLANTED)
    assert look_for(controls, "alpha") == ["alpha_deg"]


def test_a_setting_of_the_scene_is_found_as_well(controls: Column) -> None:
    controls.card.show_scene("Popping", (), PHENOMENA["far-plane-popping"])
    look_for(controls, "fog density")
    rows = controls.card.rows
    assert [name for name, row in rows.items() if row.isVisible()] == ["fog_density"]
    assert not controls.card.tries.isVisible()
    QTest.keyClick(controls.search, KEY.Key_Escape)
    assert controls.card.tries.isVisible() and rows["position"].isVisible()


# -- all digits


def test_all_digits_are_shown_where_they_are_asked_for(controls: Column, record: Record) -> None:
    row = number(controls, "azimuth_deg")
    exact = repr(row.value())
    assert len(exact) > 10 and row.field.text() == short_text(row.value(), None, 4)
    width = controls.minimumSizeHint().width()
    all_digits.set(True)
    try:
        assert row.field.text() == exact
        QApplication.processEvents()
        assert cut(controls) == [] and controls.minimumSizeHint().width() == width
    finally:
        all_digits.set(False)
    assert row.field.text() == short_text(row.value(), None, 4)
    row.field.setFocus()
    assert row.field.text() == exact
    row.field.selectAll()
    row.field.copy()
    assert QApplication.clipboard().text() == exact
    number(controls, "near").field.setFocus()
    assert record.events == [] and repr(row.value()) == exact


# -- a refusal, and what is done next


def test_a_refusal_goes_when_another_field_is_accepted(controls: Column) -> None:
    for other, text in [("width", "800"), ("eye_x", "4")]:
        show(controls, START)
        in_mode(controls, other)
        near = number(controls, "near")
        enter(near, "5000")
        show(controls, replace(START, camera=Camera((1.0, 2.0, 3.0))))
        enter(number(controls, other), "nonsense")
        assert near.error and near.field.text() == "5000", "it has nothing to do with near"
        enter(number(controls, other), text)
        assert not near.error and not number(controls, other).error
        assert float(near.field.text()) == START.lens.near
        enter(near, "nonsense")
        enter(near, "1")  # the value it has
        assert not near.error


def test_a_refusal_stays_where_the_user_is_still_typing(
    controls: Column, record: Record, qapp: QApplication
) -> None:
    near = number(controls, "near")
    enter(near, "5000")
    moved = replace(START, camera=Camera((9.0, 9.0, 9.0)))
    show(controls, moved)  # as an animation does
    assert near.error and near.field.text() == "5000"
    QTest.keyClicks(near.field, "1")
    show(controls, START)
    assert near.error and near.field.text() == "15000"
    number(controls, "far").field.setFocus()
    assert near.error
    show(controls, START)  # something else of the document has changed
    assert not near.error and float(near.field.text()) == START.lens.near


def test_a_reset_of_another_lens_s_row_changes_nothing(controls: Column) -> None:
    """The row is hidden, and the current lens has no such value."""
    for kind in [*LENSES, FreeMatrix.kind]:
        for other in LENSES:
            show(controls, START.with_lens(other))
        show(controls, START.with_lens(kind))
        record = Record(controls)
        hidden = [row for row in controls.rows.values() if row.isHidden()]
        assert hidden
        for row in hidden:
            row.setValue(1e-3)
            row.setDefault(2e-3)
            row.reset()
        assert not record.edits
