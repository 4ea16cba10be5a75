"""The rows of the lens for every lens: every number that can define it, in both directions."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox

from app.model.lenses.oblique import OBLIQUE_PRESETS
from app.model.projection import (
    Frustum,
    Intrinsics,
    Oblique,
    Orthographic,
    Perspective,
)
from tests.support.controls import (
    BOX,
    KEY,
    OFF_AXIS,
    SLANTED,
    START,
    Column,
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
from tests.support.lenses import ONE_OF_EACH
from tests.support.shown import show
from widgets.parts.scales import Linear, Log

SHOWN = {kind: replace(START, lens=lens) for kind, lens in ONE_OF_EACH.items()}
SHOWN |= {p.lens.kind: p for p in (START, OFF_AXIS, BOX, SLANTED)}


@pytest.fixture
def column(display: Any, qtbot: Any) -> Column:
    """The column with the lens's sections open, showing a perspective lens."""
    return column_with_the_keyboard(qtbot, "more_lens")


def combo(controls: Column, key: str) -> QComboBox:
    widget = choice(controls, key).widgets[0]
    assert isinstance(widget, QComboBox)
    return widget


# -- perspective: one value, many measures


def test_the_half_window_sliders_follow_near(column: Column) -> None:
    for near in (1e-3, 1.0, 250.0):
        show(column, replace(START, lens=Perspective(90.0, near, 1e6)))
        for key in ("window_right", "window_top"):
            row = number(column, key)
            assert isinstance(row.scale, Log)
            assert row.slider.minimum() < row.slider.value() < row.slider.maximum()


# -- frustum: six numbers


def test_the_windows_sliders_are_in_proportion_to_it(column: Column) -> None:
    for near in [1e-6, 0.01, 1.0, 25.0]:
        show(column, replace(START, lens=Perspective(45.0, near, 30.0)))
        choose(choice(column, "kind"), "frustum")
        _, right, _, top = column.projection.window
        for key in ("left", "right", "bottom", "top"):
            scale = number(column, key).scale
            assert isinstance(scale, Linear) and scale.low == -scale.high
            assert scale.high == pytest.approx(2.0 * right, rel=0.01)
            assert 0 < number(column, key).slider.value() < scale.last
        row = number(column, "right")
        scale = row.scale
        enter(row, repr(0.5 * right))
        assert row.scale is scale  # it still fills a fair part of the slider
        enter(row, repr(5.0 * right))
        assert row.scale.high == pytest.approx(10.0 * right, rel=0.01)
        assert top < 5.0 * right


def test_focal_lengths_have_sliders_that_suit_the_image(column: Column) -> None:
    show(column, START)
    for size in ((100, 50), (3000, 2000)):
        show(column, replace(START, image_size=size))
        ends = [number(column, key).scale for key in ("fx", "fy")]
        assert [(each.low, each.high) for each in ends] == [(1e-2 * size[0], 1e2 * size[0])] * 2


def test_a_window_that_shrinks_in_the_hand_gets_finer_sliders_afterwards(column: Column) -> None:
    show(column, replace(START, lens=Frustum(-0.01, 1.0, -0.01, 0.01, 1.0, 30.0)))
    row = number(column, "right")
    scale = row.scale
    press(row.slider)
    drag(row.slider, scale.position_of(0.02))
    assert row.scale is scale
    release(row.slider)
    assert row.scale.high == pytest.approx(0.04, rel=0.05)
    assert row.slider.value() == row.scale.position_of(row.value())


def test_a_box_keeps_the_scenes_sliders(column: Column) -> None:
    for shown in (BOX, SLANTED, replace(BOX, lens=Orthographic(-0.1, 0.1, -0.1, 0.1))):
        show(column, shown)
        assert number(column, "left").scale.high == pytest.approx(12.0, rel=0.01)
    show(column, replace(BOX, lens=Orthographic(-40.0, 4.0)))
    assert number(column, "left").scale.high == pytest.approx(80.0, rel=0.01)
    choose(choice(column, "kind"), "frustum")
    row = number(column, "far")
    row.slider.setFocus()
    QTest.keyClick(row.slider, KEY.Key_End)
    assert column.projection.lens.far == math.inf


# -- oblique: angles, and how things recede


def test_through_no_receding_at_all_the_direction_is_kept(column: Column) -> None:
    show(column, SLANTED)
    enter(number(column, "receding_deg"), "30")
    row = number(column, "receding")
    press(row.slider)
    for value in (0.2, 0.0, 0.2, 0.0, 0.5):
        drag(row.slider, row.scale.position_of(value))
        assert number(column, "receding_deg").field.text() == "30"
        lens = column.projection.lens
        assert isinstance(lens, Oblique)
        assert (lens.alpha_deg, lens.beta_deg) == (90.0, 90.0) or value > 0.0
    release(row.slider)
    assert choice(column, "preset").value() == "cabinet-30"
    assert number(column, "receding").field.text() == "0.5"


def test_a_preset_is_known_by_its_angles(column: Column) -> None:
    for preset in OBLIQUE_PRESETS:
        show(column, SLANTED)
        choose(choice(column, "preset"), preset)
        assert combo(column, "preset").currentText().startswith(preset.split("-", 1)[0])
        name, angle = preset.split("-")
        assert number(column, "receding").value() == {"cavalier": 1.0, "cabinet": 0.5}[name]
        assert number(column, "receding_deg").value() == pytest.approx(float(angle), abs=0.05)
        record = Record(column)
        enter(number(column, "alpha_deg"), "100")
        assert choice(column, "preset").value() is None
        assert combo(column, "preset").currentIndex() == -1
        assert combo(column, "preset").placeholderText() == "free"
        enter(number(column, "alpha_deg"), repr(OBLIQUE_PRESETS[preset][0]))
        assert choice(column, "preset").value() == preset and len(record.edits) == 2


def test_a_free_drawing_says_so_on_the_screen(column: Column) -> None:
    """The placeholder is painted: the box differs from an empty one."""
    show(column, replace(SLANTED, lens=Oblique(alpha_deg=100.0)))
    box = combo(column, "preset")
    said = box.grab().toImage()
    box.setPlaceholderText("")
    assert box.grab().toImage() != said


def test_another_drawing_leaves_the_target_in_its_place(column: Column) -> None:
    for key, text in [("receding", "1.25"), ("receding_deg", "-140"), ("preset", "cavalier-63.4")]:
        show(column, SLANTED)
        target = SLANTED.camera.target
        before = SLANTED.trace(target).image
        if key == "preset":
            choose(choice(column, key), text)
        else:
            enter(number(column, key), text)
        after = column.projection.trace(target).image
        assert np.allclose(after, before, rtol=0, atol=1e-9)
        assert column.projection.lens != SLANTED.lens


# -- the calibrated camera


def test_a_calibrated_camera_is_typed_in_one_number_after_the_other(
    column: Column, qtbot: Any
) -> None:
    """A camera of 640 x 480 as OpenCV's calibration samples find it."""
    show(column, replace(START, image_size=(640, 480)))
    record = Record(column)
    typed = {
        "fx": 536.0734536715783,
        "fy": 536.0163645962017,
        "cx": 342.3704616528871,
        "cy": 235.5368772063594,
    }
    for count, (key, value) in enumerate(typed.items(), 1):
        row = number(column, key)
        enter(row, repr(value))
        assert row.error == "" and len(record.edits) == count
        assert row.field.hasFocus() and row.isVisible()
        shown = {name: number(column, name).value() for name in Intrinsics._fields}
        expected = {name: typed[name] for name in list(typed)[:count]}
        assert {name: shown[name] for name in expected} == expected  # to the last digit
    lens = column.projection.lens
    assert isinstance(lens, Frustum) and (lens.near, lens.far) == (1.0, 30.0)
    assert column.projection.intrinsics == pytest.approx(tuple(typed.values()), rel=1e-13)


def test_the_row_in_hand_keeps_its_place_when_the_lens_becomes_another(
    column: Column, qtbot: Any
) -> None:
    column.resize(320, 240)
    row = number(column, "cy")
    column.ensureWidgetVisible(row)
    QApplication.processEvents()

    def place() -> int:
        return row.mapTo(column.viewport(), QPoint()).y()

    before = place()
    assert column.verticalScrollBar().value() > 60
    for text, kind in (("300", "frustum"), ("359.5", "perspective")):
        in_column = row.mapTo(column.widget(), QPoint()).y()
        enter(row, text)
        assert column.projection.lens.kind == kind
        qtbot.waitUntil(
            lambda was=in_column: (
                row.mapTo(column.widget(), QPoint()).y() != was and place() == before
            )
        )
        assert row.field.hasFocus()


def test_a_drag_of_k_turns_the_lens_and_is_one_gesture(column: Column) -> None:
    row = number(column, "cx")
    column.ensureWidgetVisible(row)
    record = Record(column)
    press(row.slider)
    for position in (row.slider.value() + 10, row.slider.value() + 20):
        drag(row.slider, position)
        QApplication.processEvents()
        assert row.slider.isSliderDown() and row.slider.value() == position
    release(row.slider)
    assert record.events == ["start", "edit", "edit", "finish"]
    assert record.edits[-1].lens.kind == "frustum"
