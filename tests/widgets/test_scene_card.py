"""The scene's card in the dock: any setting can be changed and refused, any reading read."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any, TypeAlias

import numpy as np
import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QGuiApplication, QHelpEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QLineEdit, QSlider, QToolTip, QWidget
from pytestqt.qtbot import QtBot

from app.document.document import Document
from app.document.store import Store
from app.lessons.contents import CONTENT
from app.model.lenses.oblique import receding_of
from app.model.parameter import Parameter, Settings
from app.model.projection import Camera, FreeMatrix, Frustum, Oblique
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.illustration import Illustration, Subject
from app.scenes.phenomena.words import Phrase, Reading
from app.scenes.scene import load
from tests.support.controls import choose
from tests.support.phenomenon import EVERYTHING, called
from tests.support.window import activate, enter, show_scene
from widgets.controls.parameter_rows import SettingMotion, make_row, scale_of
from widgets.controls.readout import NONE
from widgets.controls.scene_card import SceneCard
from widgets.parts import palette
from widgets.parts.fields import CheckRow, ChoiceRow
from widgets.parts.messages import all_digits, number_text
from widgets.parts.number_rows import NumberRow, VectorRow
from widgets.parts.panel import EVERYTHING as EVERY_CHANGE
from widgets.parts.panel import Readable, ShownData
from widgets.window.main_window import MainWindow

TRIES = ("Drag this.", "What happens there?", "And here?")
SUBJECT = Subject((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), np.zeros((1, 3)))


def tip_of(part: QWidget) -> str:
    """Return the tooltip that a part shows."""
    QToolTip.hideText()
    place = part.rect().center()
    QApplication.sendEvent(part, QHelpEvent(QEvent.Type.ToolTip, place, part.mapToGlobal(place)))
    return QToolTip.text()


class Owner:
    """Handles a card as the window does, and records its signals."""

    def __init__(self, card: SceneCard) -> None:
        self.card = card
        self.settings: Settings = EVERYTHING.checked({})
        self.projection = EVERYTHING.start
        self.edits: list[dict[str, Any]] = []
        self.gestures: list[str] = []
        card.settings_edited.connect(self.edited)
        card.gesture_started.connect(lambda: self.gestures.append("started"))
        card.gesture_finished.connect(lambda: self.gestures.append("finished"))
        self.show()

    def edited(self, values: dict[str, Any]) -> None:
        self.edits.append(values)
        try:
            self.settings = EVERYTHING.checked({**self.settings, **values})
        except Refusal as error:
            self.card.refuse(error)
        else:
            self.show()

    def show(self) -> None:
        illustration = EVERYTHING.show(self.projection, self.settings, SUBJECT)
        self.card.show_illustration(illustration, self.settings, self.projection)


@pytest.fixture
def card(qtbot: QtBot) -> SceneCard:
    made = SceneCard()
    qtbot.addWidget(made)
    made.show_scene("A setting of every kind", TRIES, EVERYTHING)
    made.resize(260, 900)
    made.show()
    qtbot.waitExposed(made)
    made.readout.more.setChecked(True)
    return made


@pytest.fixture
def owner(card: SceneCard) -> Owner:
    return Owner(card)


Desk: TypeAlias = Callable[[str], tuple[Store, SceneCard]]


@pytest.fixture
def desk(qtbot: QtBot) -> Desk:
    """Makes a store with a scene, and a card that is connected with it as in the window."""

    def make(name: str) -> tuple[Store, SceneCard]:
        scene, card = load(name), SceneCard()
        qtbot.addWidget(card)
        store = Store(Document(name, scene.start))

        def edit(settings: Settings) -> None:
            try:
                store.set_settings(settings)
            except Refusal as error:
                card.refuse(error)

        def show(document: Document) -> None:
            card.take(ShownData.of(document, scene), EVERY_CHANGE)

        card.settings_edited.connect(edit)
        store.changed.connect(show)
        card.show_scene(name, scene.tries, scene.phenomenon)
        card.show()
        qtbot.waitExposed(card)
        show(store.document)
        return store, card

    return make


def number_row(card: SceneCard, name: str) -> NumberRow:
    row = card.rows[name]
    assert isinstance(row, NumberRow)
    return row


def readings(card: SceneCard) -> list[tuple[str, str, str]]:
    return [
        (label.text(), value.text(), unit.text())
        for label, value, unit in card.readout.lines
        if label.isVisible()
    ]


# -- settings


def test_there_is_a_row_for_every_setting_of_its_kind(owner: Owner) -> None:
    rows = owner.card.rows
    kinds = [NumberRow, NumberRow, NumberRow, ChoiceRow, CheckRow, VectorRow]
    assert [type(row) for row in rows.values()] == kinds
    assert [row.name for row in rows.values()] == [s.title for s in EVERYTHING.settings]
    assert {name: row.value() for name, row in rows.items()} == dict(EVERYTHING.checked({}))
    assert number_row(owner.card, "gap").unit_label.text() == "mm"
    assert owner.edits == []
    for setting, row in zip(EVERYTHING.settings, rows.values(), strict=True):
        assert setting.tip in row.name_label.toolTip()


def test_every_row_makes_its_edit(owner: Owner) -> None:
    card = owner.card
    number_row(card, "turn").slider.setValue(0)
    enter(number_row(card, "gap").field, "0,25 mm")
    choose(card.rows["kind"], "b")  # type: ignore[arg-type]
    row: Any = card.rows["correct"]
    QTest.mouseClick(row.box, Qt.MouseButton.LeftButton, pos=row.box.rect().center())
    row = card.rows["light"]
    enter(row.fields[2], "1/4")
    assert owner.edits == [
        {"turn": -180.0}, {"gap": 0.25}, {"kind": "b"}, {"correct": False},
        {"light": (1.0, 3.6, 0.25)},
    ]  # fmt: skip


def test_a_refusal_goes_when_another_setting_is_accepted(owner: Owner) -> None:
    card = owner.card
    light: Any = card.rows["light"]
    enter(light.fields[1], "high")
    assert light.error and light.fields[1].text() == "high"
    owner.projection = replace(owner.projection, camera=Camera((9.0, 9.0, 9.0)))
    owner.show()
    assert light.error and light.fields[1].text() == "high", "its field has the focus"
    enter(number_row(card, "gap").field, "0.25")
    assert not light.error and light.fields[1].text() == "3.6"


def test_a_free_matrix_disables_the_settings_and_a_tooltip_says_why(
    owner: Owner, qapp: QApplication
) -> None:
    card = owner.card
    start = EVERYTHING.start
    cells = tuple(map(tuple, np.eye(4).tolist()))
    free = replace(start, lens=FreeMatrix(cells))
    card.motions["turn"].play()
    card.show_illustration(
        EVERYTHING.illustration(free, owner.settings, SUBJECT), owner.settings, free
    )
    assert not any(row.isEnabled() for row in card.rows.values())
    assert not card.motions["turn"].playing and not card.motions["turn"].button.isEnabled()
    assert card.use_mesh.isEnabled() and "choose a lens" in card.warning.text()
    row = number_row(card, "gap")
    for part in (row.slider, row.field, row.name_label):
        assert tip_of(part).endswith("choose a lens to see this.")
    card.show_illustration(
        EVERYTHING.illustration(start, owner.settings, SUBJECT), owner.settings, start
    )
    assert all(row.isEnabled() for row in card.rows.values())
    assert card.motions["turn"].button.isEnabled()
    assert "choose a lens" not in tip_of(row.field)


def test_a_reset_brings_the_default_of_every_kind(owner: Owner) -> None:
    changed = {"gap": 3.0, "turn": 9.0, "count": 7.0, "kind": "b", "correct": False,
               "light": (0.0, 1.0, -2.0)}  # fmt: skip
    owner.settings = EVERYTHING.checked(changed)
    owner.show()
    rows: Any = owner.card.rows
    assert owner.edits == [] and owner.gestures == [], "what is shown is no edit"
    assert {name: row.value() for name, row in rows.items()} == dict(owner.settings)
    assert [field.text() for field in rows["light"].fields] == ["0", "1", "-2"]
    assert not rows["correct"].box.isChecked()
    for row in rows.values():
        QTest.mouseDClick(row.name_label, Qt.MouseButton.LeftButton)
    assert owner.settings == EVERYTHING.checked({})
    assert len(owner.edits) == 6


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("gap", "1e4", "Gap = 10000: must be at most 1000."),
        ("gap", "500", "Gap = 500: must be less than the count, which is 40."),
        ("count", "2.5", "Count = 2.5: must be a whole number."),
        ("count", "x", "Count = “x”: must be a number, such as 40; must be at least 1;"
         " must be at most 64."),
        ("gap", "x", "Gap = “x”: must be a number, such as 0.5 or 2e-3; must be at least 0.001;"
         " must be at most 1000."),
        ("light", "1e101", "Light = 1e+101: must be at most 1e+100."),
        ("light", "inf", "Light y = ∞: must be a finite number."),
    ],
)  # fmt: skip
def test_a_refusal_names_the_row_the_value_and_the_bound_and_changes_nothing(
    owner: Owner, name: str, text: str, sentence: str
) -> None:
    row: Any = owner.card.rows[name]
    field = row.fields[1] if name == "light" else row.field
    before, shown = owner.settings, readings(owner.card)
    enter(field, text)
    assert row.error == field.accessibleDescription() == f"Not possible. {sentence}"
    assert owner.settings == before and row.value() == before[name]
    assert readings(owner.card) == shown
    assert field.text() == text  # to be put right
    QTest.keyClick(field, Qt.Key.Key_Escape)
    assert row.error == ""
    assert field.text() == number_text(3.6 if name == "light" else float(before[name]))  # type: ignore[arg-type]


def test_an_error_goes_when_another_value_removes_its_cause(owner: Owner) -> None:
    gap = number_row(owner.card, "gap")
    gap.slider.setSliderDown(True)
    gap.slider.setValue(gap.slider.maximum() - 10)  # above ten times the count
    assert gap.error
    gap.slider.setSliderDown(False)
    assert gap.error == "" and gap.value() == owner.settings["gap"]
    gap.show_error("Refused.")
    owner.edited({"turn": 5.0})
    assert gap.error == ""


def test_during_a_gesture_only_the_edited_value_is_updated(
    owner: Owner, monkeypatch: pytest.MonkeyPatch
) -> None:
    card, turn = owner.card, number_row(owner.card, "turn")
    monkeypatch.setattr(Readable, "now_ms", lambda _self: 0.0)
    card.gesture_started.connect(card.readable.begin_gesture)
    card.gesture_finished.connect(card.readable.end_gesture)
    owner.edited({"turn": 1.0})
    before = readings(card)
    motion = card.motions["turn"]
    motion.play()
    motion.advance(1.0)
    assert turn.value() == 91.0 == owner.settings["turn"]
    owner.edited({"gap": 7.0})
    assert readings(card) == before and card.rows["gap"].value() == 2.0
    motion.pause()
    assert readings(card)[0] == ("gap", "7", "mm") and card.rows["gap"].value() == 7.0


def test_a_refusal_stays_when_what_was_accepted_before_it_is_shown_at_last(
    owner: Owner, monkeypatch: pytest.MonkeyPatch
) -> None:
    card, motion = owner.card, owner.card.motions["count"]
    owner.edited({"gap": 30.0, "count": 4.0})
    monkeypatch.setattr(Readable, "now_ms", lambda _self: 0.0)
    card.readable.begin_gesture()
    motion.play()
    owner.edited({"turn": 5.0})
    motion.speed = -2.0
    motion.advance(1.0)
    card.readable.end_gesture()
    assert "must be less than the count" in card.rows["count"].error
    assert card.rows["turn"].value() == 5.0


def test_another_scene_is_shown_at_once_during_a_gesture(
    owner: Owner, monkeypatch: pytest.MonkeyPatch
) -> None:
    card = owner.card
    monkeypatch.setattr(Readable, "now_ms", lambda _self: 0.0)
    card.readable.begin_gesture()
    triangles = PHENOMENA["similar-triangles"]
    card.show_scene("Similar triangles", triangles.words.tries, triangles)
    settings = triangles.checked({"distance": 3.0})
    card.show_illustration(
        triangles.illustration(triangles.start, settings, SUBJECT), settings, triangles.start
    )
    assert card.rows["distance"].value() == 3.0


def test_another_scene_has_other_rows_and_none_of_the_old(
    owner: Owner, qtbot: QtBot, qapp: QApplication
) -> None:
    triangles = PHENOMENA["similar-triangles"]
    owner.card.show_scene("Similar triangles", triangles.words.tries, triangles)
    assert list(owner.card.rows) == ["distance", "point"] and not owner.card.motions
    qapp.processEvents()
    qapp.sendPostedEvents(None, 52)  # QEvent.DeferredDelete
    assert len(owner.card.findChildren(QSlider)) == 1
    assert owner.card.tries.text() == "\n".join(triangles.words.tries)
    owner.card.show_scene("Letter F", TRIES, None)
    assert not owner.card.rows and owner.card.title.text() == "Letter F"
    assert readings(owner.card) == []


def test_a_mesh_can_be_asked_for_and_taken_away_where_there_is_a_place_for_it(
    card: SceneCard,
) -> None:
    assert card.use_mesh.isVisible() and not card.remove_mesh.isVisible()
    card.show_scene("Everything", TRIES, EVERYTHING, "bunny.obj")
    assert card.remove_mesh.isVisible()
    card.show_scene("Everything", TRIES, replace(EVERYTHING, own_mesh=False))
    assert not card.use_mesh.isVisible() and not card.remove_mesh.isVisible()


def test_a_setting_without_ends_has_a_slider_about_its_default(qtbot: QtBot) -> None:
    row = make_row(Parameter("a", 4.0))
    qtbot.addWidget(row)
    assert isinstance(row, NumberRow)
    assert row.value() == 4.0 and row.slider.minimum() < row.slider.value() < row.slider.maximum()


# -- playing


def played(motion: SettingMotion, *seconds: float) -> list[float]:
    """Advance a motion and return its values."""
    values: list[float] = []
    motion.stepped.connect(values.append)
    for step in seconds:
        motion.advance(step)
    return values


def test_a_number_runs_back_and_forth_between_the_ends(owner: Owner) -> None:
    motion = owner.card.motions["turn"]
    assert played(motion, 1.0) == []  # it is not playing
    motion.play()
    assert played(motion, 1.0, 1.5, 0.5, 3.0, 1.0) == [90.0, 180.0, 135.0, -135.0, -180.0]
    assert owner.edits[:2] == [{"turn": 90.0}, {"turn": 180.0}]
    motion.pause()
    assert played(motion, 1.0) == []
    motion.play()
    assert played(motion, 1.0) == [-90.0]
    enter(number_row(owner.card, "turn").field, "-30")  # a hand puts it elsewhere
    motion.advance(0.5)
    assert owner.settings["turn"] == 15.0


def test_playing_is_one_gesture(owner: Owner, qtbot: QtBot) -> None:
    motion = owner.card.motions["turn"]
    motion.button.click()
    assert motion.playing and owner.gestures == ["started"]
    qtbot.waitUntil(lambda: len(owner.edits) >= 3)  # by its own clock
    assert owner.gestures == ["started"]
    motion.button.click()
    assert not motion.playing and owner.gestures == ["started", "finished"]
    seen = len(owner.edits)
    QApplication.processEvents()
    assert len(owner.edits) == seen
    assert owner.card.rows["turn"].value() == owner.edits[-1]["turn"]


def test_one_number_plays_at_a_time_and_none_in_a_folded_panel(owner: Owner) -> None:
    turn, count = owner.card.motions["turn"], owner.card.motions["count"]
    turn.play()
    count.play()
    assert count.playing and not turn.playing
    assert owner.gestures == ["started", "finished", "started"]
    owner.card.hide()
    assert not count.playing and owner.gestures[-1] == "finished"


def test_a_count_counts_and_powers_run_evenly(qtbot: QtBot) -> None:
    count = SettingMotion(Parameter("n", 1.0, 1.0, 64.0, whole=True, per_second=4.0))
    count.show_value(1.0)
    count.play()
    assert played(count, 0.1, 0.15, 0.25, 0.5) == [2.0, 3.0, 5.0]
    power = SettingMotion(Parameter("e", 1.0, 0.01, 1e4, logarithmic=True, per_second=1.0))
    power.show_value(1.0)
    power.play()
    assert played(power, 1.0, 2.0, 5.0, 1.0) == [10.0, 1000.0, 10000.0, 1000.0]
    for motion in (count, power):
        motion.pause()


def test_playing_reports_a_refused_value_and_passes_over_it(owner: Owner) -> None:
    owner.edited({"gap": 30.0, "count": 4.0})
    motion, row = owner.card.motions["count"], owner.card.rows["count"]
    motion.show_value(4.0)
    motion.speed = -2.0
    motion.play()
    motion.advance(1.0)  # 2: not above a tenth of the gap
    assert "must be less than the count" in row.error and owner.settings["count"] == 4.0
    motion.speed = 2.0
    motion.advance(1.0)
    motion.advance(1.0)
    assert row.error == "" and owner.settings["count"] == 6.0


# -- readout


def test_every_reading_is_shown_with_its_unit(owner: Owner) -> None:
    owner.edited({"gap": 1 / 3, "light": (0.5, 3.6, -1.0)})
    shown = readings(owner.card)
    assert shown[:4] == [
        ("gap", "0.3333", "mm"), ("kind", "a", ""), ("x_s", "0.5", "×"), ("y_s", "3.6", "×"),
    ]  # fmt: skip
    rows = [row.split("\t") for row in shown[4][1].splitlines()]
    assert np.shape(rows) == (4, 4) and rows[3][2:] == ["4.667", "5"]  # 14/3 and 15/3
    value, exact = owner.card.readout.lines[4][1], [repr(part * (1 / 3)) for part in range(16)]
    assert value.toolTip().split() == [text.removesuffix(".0") for text in exact]
    QTest.keyClick(value, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert QGuiApplication.clipboard().text().count("\t") == 12
    assert list(map(float, QGuiApplication.clipboard().text().split())) == list(map(float, exact))
    value = owner.card.readout.lines[0][1]
    assert value.toolTip() == "0.3333333333333333"
    for copy in (
        lambda: QTest.keyClick(value, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier),
        value.actions()[0].trigger,
    ):
        QGuiApplication.clipboard().clear()
        copy()
        assert QGuiApplication.clipboard().text() == "0.3333333333333333"
    all_digits.set(True)
    try:
        assert readings(owner.card)[0] == ("gap", "0.3333333333333333", "mm")
    finally:
        all_digits.set(False)
    assert readings(owner.card)[0] == ("gap", "0.3333", "mm")
    assert not owner.card.readout.note.isVisible()


NUMBERS = [
    (name, setting)
    for name, phenomenon in PHENOMENA.items()
    for setting in phenomenon.settings
    if type(setting.default) is float
]


@pytest.mark.parametrize(
    ("name", "setting"), NUMBERS, ids=[f"{name}.{setting.name}" for name, setting in NUMBERS]
)
def test_every_place_of_a_slider_is_a_value_of_its_setting(name: str, setting: Parameter) -> None:
    scale = scale_of(setting)
    assert scale.last >= (min(10.0, setting.high - setting.low) if setting.whole else 10)
    values = [scale.value_at(position) for position in range(scale.last + 1)]
    assert values == sorted(values)
    assert all(setting.checked(value) == value for value in values)
    assert [scale.value_at(scale.position_of(value)) for value in values] == values


def test_the_parts_of_the_board_can_be_doubled_up_to_its_bound(desk: Desk) -> None:
    store, card = desk("interpolation")
    row = number_row(card, "subdivision")
    for key, parts in (
        (Qt.Key.Key_PageUp, 3.0), (Qt.Key.Key_End, 64.0), (Qt.Key.Key_PageDown, 32.0),
        (Qt.Key.Key_Home, 1.0), (Qt.Key.Key_Right, 2.0),
    ):  # fmt: skip
        QTest.keyClick(row.slider, key)
        assert store.document.settings["subdivision"] == parts and not row.error
    enter(row.field, "5")
    assert store.document.settings["subdivision"] == 5.0  # others can be typed


def test_missing_readings_give_their_reason_once(owner: Owner) -> None:
    owner.projection = replace(
        EVERYTHING.start, camera=Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0))
    )
    owner.show()
    assert readings(owner.card)[2:4] == [("x_s", NONE, ""), ("y_s", NONE, "")]
    assert owner.card.readout.note.text() == "The light is behind the eye at z = 3."
    assert owner.card.readout.note.isVisible()
    owner.projection = EVERYTHING.start
    owner.edited({"light": (0.5, 3.6, -1.0)})
    assert readings(owner.card)[2] == ("x_s", "0.5", "×")
    assert not owner.card.readout.note.isVisible()


def test_a_warning_comes_and_goes(owner: Owner) -> None:
    assert not owner.card.warning.isVisible()
    owner.edited({"gap": 200.0})
    assert owner.card.warning.isVisible()
    assert owner.card.warning.text() == "Nothing of it is seen."
    owner.edited({"gap": 2.0})
    assert not owner.card.warning.isVisible()


def test_numbers_are_larger_than_their_words_in_any_font(owner: Owner, qapp: QApplication) -> None:
    _, value, _ = owner.card.readout.lines[0]
    base = owner.card.font().pointSizeF()
    assert value.font().pointSizeF() == pytest.approx(1.15 * base)
    assert owner.card.title.font().pointSizeF() == pytest.approx(1.25 * base)
    try:
        palette.apply(qapp, dark=True, screen_px=768.0)
        qapp.processEvents()
        assert owner.card.font().pointSizeF() > 1.2 * base
        assert value.font().pointSizeF() == pytest.approx(1.15 * owner.card.font().pointSizeF())
        title = owner.card.title.font().pointSizeF()
        assert title == pytest.approx(1.25 * owner.card.font().pointSizeF())
    finally:
        palette.apply(qapp, dark=False, screen_px=0.0)
        qapp.processEvents()
    assert value.font().pointSizeF() == pytest.approx(1.15 * base)


def test_the_first_numbers_are_seen_and_the_others_written_when_they_are_unfolded(
    owner: Owner,
) -> None:
    card = owner.card
    card.show_scene("Anew", TRIES, replace(called("anew"), numbers=2))
    many = [Reading(f"number {i}", float(i)) for i in range(5)]
    card.readout.show_readings(many)
    assert [label for label, _, _ in readings(card)] == ["number 0", "number 1"]
    assert card.readout.more.isVisible()
    card.readout.show_readings([Reading(f"number {i}", i + 0.5) for i in range(5)])
    assert "4.5" not in [value.text() for _, value, _ in card.readout.lines]
    card.readout.more.click()
    assert readings(card)[4] == ("number 4", "4.5", "")
    card.readout.show_readings(many[:3])  # a fold for one would take as much room
    assert len(readings(card)) == 3 and not card.readout.more.isVisible()


def test_the_way_to_the_diagrams_is_named_where_there_are_some(owner: Owner) -> None:
    card = owner.card
    assert card.explanation.text() == "Diagrams…"
    card.show_illustration(Illustration(()), owner.settings, owner.projection)
    assert card.explanation.text() == "Explanation…"
    card.show_scene("Letter F", TRIES, None)
    assert not card.explanation.isVisible()


def test_no_number_is_cut(owner: Owner) -> None:
    owner.edited({"gap": 1.23456e-3})
    QApplication.processEvents()
    _, value, _ = owner.card.readout.lines[0]
    assert value.width() >= value.fontMetrics().horizontalAdvance(value.text())
    least = value.minimumWidth()
    owner.edited({"gap": 2.0})
    # It does not jump back.
    assert value.minimumWidth() == least > value.fontMetrics().horizontalAdvance(value.text())


def test_a_folded_panel_fills_nothing_in_and_is_up_to_date_when_it_opens(
    owner: Owner, qtbot: QtBot
) -> None:
    card, shown = owner.card, readings(owner.card)
    card.hide()
    owner.edited({"gap": 7.0})
    texts = [value.text() for _, value, _ in card.readout.lines]
    assert texts == [value for _, value, _ in shown]
    assert card.rows["gap"].value() == 2.0
    card.show()
    qtbot.waitExposed(card)
    assert readings(card)[0] == ("gap", "7", "mm") and card.rows["gap"].value() == 7.0


def test_it_needs_no_more_than_the_narrowest_dock(owner: Owner, qapp: QApplication) -> None:
    """Whatever a scene shows in it."""
    many = tuple(Reading(f"a long name of number {i}", -1e-5 / 3 + i, "px") for i in range(12))
    pairs = Reading("two numbers of many digits", (-1234.5678, 0.000123456), "px")
    owner.card.show_illustration(
        Illustration((pairs, *many), warning=Phrase("a long warning " * 20)),
        owner.settings,
        owner.projection,
    )
    qapp.processEvents()
    assert owner.card.minimumSizeHint().width() <= 244
    all_digits.set(True)
    try:
        qapp.processEvents()
        assert owner.card.minimumSizeHint().width() <= 244
    finally:
        all_digits.set(False)


# -- languages


@pytest.mark.undrawn
@pytest.mark.parametrize("scene", ["letter-f", "planar-shadow"])
def test_a_burst_of_keys_ends_with_its_scene(window: MainWindow, qtbot: QtBot, scene: str) -> None:
    show_scene(window, "similar-triangles")
    row = next(row for row in window.controls.card.rows.values() if isinstance(row, NumberRow))
    for _ in range(3):  # of which not all are shown yet
        qtbot.keyClick(row.slider, Qt.Key.Key_Right)
    assert window.store.in_gesture
    window.files.choose_scene(scene)
    assert not window.store.in_gesture
    assert window.controls.card.rows.keys() == window.store.document.settings.keys()


# -- settings that move camera and lens, which others move too


def shown(card: SceneCard, *names: str) -> list[Any]:
    return [card.rows[name].value() for name in names]


def in_words(card: SceneCard, name: str) -> str:
    row = card.rows[name]
    assert isinstance(row, ChoiceRow)
    combo = row.widgets[0]
    assert isinstance(combo, QComboBox)
    return combo.currentText() or combo.placeholderText()


def test_the_view_volume_is_that_of_the_lens_and_can_be_chosen_again(desk: Desk) -> None:
    store, card = desk("view-volumes")
    start = store.document
    store.set_projection(start.projection.with_lens("orthographic"))
    assert shown(card, "volume") == ["box"] and store.document.settings == start.settings
    choose(card.rows["volume"], "pyramid")
    assert store.document.projection.lens.kind == "perspective"
    assert shown(card, "volume") == ["pyramid"]
    store.undo()
    assert store.document.projection.lens.kind == "orthographic"
    assert shown(card, "volume") == ["box"]
    choose(card.rows["volume"], "cone")
    store.set_projection(store.document.projection.with_lens("oblique"))
    assert shown(card, "volume") == ["oblique"]


def test_a_camera_that_was_turned_is_free_and_can_be_turned_back(desk: Desk) -> None:
    store, card = desk("vanishing-points")
    start = store.document.projection
    assert shown(card, "points") == ["2"]
    store.set_projection(replace(start, camera=replace(start.camera, eye=(3.0, 5.0, 5.0))))
    assert shown(card, "points") == ["free"]
    card.settings_edited.emit({"t": 0.25})
    assert store.document.projection.camera.eye == (3.0, 5.0, 5.0)
    choose(card.rows["points"], "2")
    assert shown(card, "points") == ["2"]
    np.testing.assert_allclose(store.document.projection.camera.frame, start.camera.frame)
    # Nearer, but in the same direction: still two points.
    camera = store.document.projection.camera
    near = Camera.from_orbit(camera.target, camera.orbit._replace(distance=4.0))
    store.set_projection(replace(store.document.projection, camera=near))
    assert shown(card, "points") == ["2"]


def test_the_drawing_follows_an_oblique_lens(desk: Desk) -> None:
    store, card = desk("oblique-drawing")
    start = store.document.projection
    rows = card.rows
    assert shown(card, "drawing", "angle_deg", "morph") == ["cavalier", 45.0, 1.0]
    assert not rows["receding"].isEnabled()  # of the free drawing alone
    lens = replace(start.lens, alpha_deg=80.0)
    store.set_projection(replace(start, lens=lens))
    drawing, receding, angle_deg, morph = shown(card, "drawing", "receding", "angle_deg", "morph")
    assert (drawing, morph) == ("free", 1.0) and rows["receding"].isEnabled()
    scale, direction = receding_of(lens)
    assert receding == pytest.approx(scale, rel=1e-9)
    assert angle_deg == pytest.approx(direction, rel=1e-9)
    # An edit of one number keeps the others as they are shown.
    number_row(card, "angle_deg").edited.emit(30.0)
    drawn = store.document.projection.lens
    assert isinstance(drawn, Oblique)
    assert receding_of(drawn) == pytest.approx((scale, 30.0))
    choose(card.rows["drawing"], "cavalier")
    drawn = store.document.projection.lens
    assert isinstance(drawn, Oblique) and receding_of(drawn) == pytest.approx((1.0, 30.0))
    # Another lens makes no oblique drawing.
    store.set_projection(store.document.projection.with_lens("perspective"))
    assert in_words(card, "drawing") == "none of these"
    assert not rows["angle_deg"].isEnabled() and not rows["morph"].isEnabled()
    assert shown(card, "angle_deg", "morph") == [30.0, 1.0]  # with what it would be drawn
    choose(card.rows["drawing"], "cavalier")
    assert store.document.projection.lens.kind == "oblique"
    assert shown(card, "drawing") == ["cavalier"] and rows["angle_deg"].isEnabled()


def test_a_moved_camera_is_none_of_the_photographs(desk: Desk) -> None:
    store, card = desk("field-of-view")
    start = store.document.projection
    target, orbit = start.camera.target, start.camera.orbit
    away = Camera.from_orbit(target, orbit._replace(distance=9.0))
    store.set_projection(replace(start, camera=away))
    assert in_words(card, "preset") == "none of these"
    assert shown(card, "distance") == [pytest.approx(3.0)]
    assert number_text(shown(card, "distance")[0]) == "3"
    choose(card.rows["preset"], "wide")
    now = store.document.projection
    assert now.camera.distance == pytest.approx(3.0)
    assert now.lens.fov_y_deg == pytest.approx(start.lens.fov_y_deg)
    assert shown(card, "preset", "distance") == ["wide", 1.0]
    assert store.document.settings["distance"] == 1.0
    # An edit of the distance keeps the photograph: the size stays.
    card.settings_edited.emit({"distance": 2.0})
    assert shown(card, "preset", "distance") == ["wide", 2.0]
    # Away from a photograph the distance moves the eye from where it is.
    store.set_projection(replace(start, camera=away))
    card.settings_edited.emit({"distance": 1.5})
    assert store.document.projection.camera.distance == pytest.approx(4.5)
    assert shown(card, "distance") == [1.5] and in_words(card, "preset") == "none of these"
    # A distance beyond the slider is shown, and stays when another setting is edited.
    far = Camera.from_orbit(target, orbit._replace(distance=300.0))
    store.set_projection(replace(start, camera=far))
    assert shown(card, "distance") == [pytest.approx(100.0)]
    card.settings_edited.emit({"enlarged": False})
    assert store.document.projection.camera == far


def test_the_shift_follows_the_middle_of_the_window(desk: Desk) -> None:
    store, card = desk("off-axis-window")
    start = store.document.projection
    assert shown(card, "shift") == [1.5]
    lens = start.lens
    assert isinstance(lens, Frustum)
    moved = replace(lens, left=lens.left - 0.5, right=lens.right - 0.5)
    store.set_projection(replace(start, lens=moved))  # 1.25 to the left at the distance 8
    assert shown(card, "shift") == [pytest.approx(2.75)]
    number_row(card, "shift").edited.emit(1.5)
    now = store.document.projection
    assert now.camera.eye == pytest.approx((0.25, 2.4, 8.0))
    assert now.window == pytest.approx(start.window) and shown(card, "shift") == [1.5]
    store.set_projection(now.with_lens("perspective"))
    assert shown(card, "shift") == [0.0]
    number_row(card, "shift").edited.emit(1.5)
    assert store.document.projection.window == pytest.approx(start.window)


def test_the_position_follows_the_camera(desk: Desk) -> None:
    store, card = desk("far-plane-popping")
    start = store.document.projection
    for z in (-20.0, -400.0):
        there = replace(start.camera, eye=(0.5, 2.2, z), target=(0.0, 2.0, z - 50.0))
        store.set_projection(replace(start, camera=there))
        assert shown(card, "position") == [start.camera.eye[2] - z]
        card.settings_edited.emit({"detail": z == -20.0})
        assert store.document.projection.camera == there  # nobody has asked for another place
    number_row(card, "position").edited.emit(0.0)
    assert store.document.projection.camera.eye == pytest.approx(start.camera.eye)


def test_a_setting_without_effect_names_the_setting_it_needs(desk: Desk) -> None:
    store, card = desk("far-plane-popping")
    rows = card.rows

    def enabled() -> set[str]:
        return {name for name, row in rows.items() if row.isEnabled()}

    always = {"position", "fog", "detail"}
    assert enabled() == always
    for name, said in (
        ("fog_start", "Only with “Fog”: linear, from start to end."),
        ("detail_1", "Only with “Level of detail” switched on."),
    ):
        assert tip_of(number_row(card, name).field) == said
    store.set_settings({"fog": "linear"})
    assert enabled() == always | {"fog_start", "fog_end"}
    store.set_settings({"fog": "exponential", "detail": True})
    assert enabled() == always | {"fog_density", "detail_1", "detail_2"}


def test_a_bound_is_written_as_all_numbers_are(desk: Desk) -> None:
    store, card = desk("far-plane-popping")
    store.set_settings({"fog": "linear"})
    row = number_row(card, "fog_end")
    enter(row.field, "10")
    assert row.error.endswith("Fog ends at = 10: must be greater than 15.")


@pytest.mark.undrawn
def test_another_scene_is_shown_from_the_top_without_the_search(window: MainWindow) -> None:
    controls = show_scene(window, "planar-shadow").controls
    bar = controls.verticalScrollBar()
    bar.setValue(bar.maximum())
    controls.search.setText("near")
    show_scene(window, "eye-plane")
    assert (bar.value(), controls.search.text()) == (0, "")
    assert controls.card.title.isVisible()
    bar.setValue(20)
    enter(controls.rows["near"].field, "0.5")
    assert bar.value() == 20, "a value does not scroll the dock"


@pytest.mark.undrawn
def test_a_number_that_is_being_typed_does_not_outlive_its_scene(
    window: MainWindow, qtbot: QtBot
) -> None:
    show_scene(window, "focus")
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    field = window.controls.card.rows["focus"].findChild(QLineEdit)
    assert isinstance(field, QLineEdit)
    field.setFocus()
    QTest.keyClicks(field, "33")
    window.lesson_card.open(CONTENT / "l06-off-axis-frustum.md")
    assert window.store.document.scene == "off-axis-window"
    assert "shift" in window.controls.card.rows
    assert window.store.document == window.shown.document


@pytest.mark.undrawn
def test_a_row_that_the_card_gives_back_keeps_the_keyboard(window: MainWindow) -> None:
    activate(show_scene(window, "view-volumes"))
    near = window.controls.rows["near"]
    near.take_focus()
    held = QApplication.focusWidget()
    show_scene(window, "vanishing-points")
    assert near.isVisible() and QApplication.focusWidget() is held
