"""A student's way through a lesson: the card beside the pictures, by hand and by keyboard alone."""

from __future__ import annotations

import re
import threading
import time
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
import shiboken6
from PySide6.QtCore import QPoint, QRect, Qt, QTimer
from PySide6.QtGui import QAccessible, QFont, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QProgressDialog,
    QPushButton,
    QRadioButton,
    QScrollArea,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app.document.document import Document
from app.document.settings import set_values
from app.drawings import labels
from app.lessons.blocks import KINDS
from app.lessons.blocks.block import REVEALED, Asked, Here, Verdict
from app.lessons.blocks.task import DONE
from app.lessons.checking import CheckReport
from app.lessons.contents import CONTENT, contained
from app.lessons.course import idea_named
from app.lessons.lesson import Step, read
from app.lessons.lines import Body
from app.lessons.player import Player
from app.lessons.text import spoken_text
from app.model.projection import Perspective
from tests.support.exercises import WIDE
from tests.support.keys import clashes
from tests.support.lessons import LESSON, PREDICTED
from tests.support.window import (
    NO_KEY,
    MakeWindow,
    activate,
    arrive,
    click,
    enter,
    go_to,
    pixels,
    present,
    seen,
    settle,
    show_scene,
)
from widgets.parts.layouts import in_row
from widgets.parts.lesson_text import LessonText
from widgets.parts.progress import ReportProgress
from widgets.window.lesson_blocks import VIEWS
from widgets.window.lesson_blocks.choices import ChoiceView
from widgets.window.lesson_blocks.marked import ClickView, TaskView
from widgets.window.lesson_blocks.view import BlockView, Sign
from widgets.window.lesson_card import TOUR, WHILE_MOVING_MS, LessonCard
from widgets.window.main_window import MainWindow
from widgets.window.pointing import Cross
from widgets.window.step_page import StepPage

KEY = Qt.Key
ALT, SHIFT = Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def lesson(tmp_path: Path) -> Path:
    path = tmp_path / "wide.md"
    path.write_text(LESSON, encoding="utf-8")
    return path


def opened(window: MainWindow, tmp_path: Path, text: str) -> LessonCard:
    """The card of an active window with a lesson of this text, once all is at rest."""
    path = tmp_path / "lesson.md"
    path.write_text(text, encoding="utf-8")
    activate(window)
    window.lesson_card.open(path)
    come_to_rest(window)
    return window.lesson_card


def test_a_sign_grows_with_the_letters_beside_it(qtbot: QtBot) -> None:
    row, sign = QWidget(), Sign("", "")
    qtbot.addWidget(row)
    row.setLayout(in_row(sign))
    row.show()
    for size_px in (12, 40):
        row.setStyleSheet(f"* {{ font-size: {size_px}px }}")
        settle()
        assert sign.height() == sign.width() >= sign.fontMetrics().height() > size_px


def texts(widget: QWidget) -> str:
    """All that can be read in it."""
    found = [text.accessibleName() for text in widget.findChildren(LessonText) if text.isVisible()]
    found += [label.text() for label in widget.findChildren(QLabel) if label.isVisible()]
    return "\n".join(found)


def buttons(widget: QWidget) -> dict[str, QPushButton]:
    return {
        button.text().replace("&", ""): button
        for button in widget.findChildren(QPushButton)
        if button.isVisible()
    }


def keyboard() -> QWidget:
    """What has the keyboard; the window has it again when a scene's progress has had it."""
    if QApplication.focusWidget() is None:
        tops = QApplication.topLevelWidgets()
        activate(next(top for top in tops if isinstance(top, MainWindow) and top.isVisible()))
    focus = QApplication.focusWidget()
    assert focus is not None
    return focus


def press(key: Qt.Key, modifier: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
    """A key, to whatever has the focus."""
    focus = keyboard()
    # Looked for before: afterwards what the window has may just be being deleted.
    buttons = focus.window().findChildren(QPushButton)
    QTest.keyClick(focus, key, modifier)
    QApplication.processEvents()
    while any(shiboken6.isValid(button) and button.isDown() for button in buttons):
        QTest.qWait(10)  # which Qt shows pressed for a moment
    settle()


def come_to_rest(window: MainWindow) -> None:
    """Let the model be where it is moving to, and the card see what of it is done."""
    settle()
    arrive(window.lessons)
    for timer in window.lesson_card.findChildren(QTimer):
        if timer.isActive() and timer.interval() == WHILE_MOVING_MS:
            timer.timeout.emit()
    settle()


def fov(window: MainWindow) -> float:
    return float(window.store.document.projection.lens.fov_y_deg)  # type: ignore[union-attr]


@pytest.mark.undrawn
def test_a_prediction_is_made_before_the_step_goes_on(window: MainWindow, lesson: Path) -> None:
    window.resize(1366, 768)
    activate(window)
    window.files.open(lesson)
    settle()
    card = window.lesson_card
    assert card.isVisible() and window.controls.isVisible()
    assert "<script>alert(1)</script>" in texts(card) and "What comes" not in texts(card)
    assert isinstance(QApplication.focusWidget(), QRadioButton)
    press(KEY.Key_Right, ALT)
    assert window.lessons.place == 0 and "prediction first" in texts(card)
    press(KEY.Key_Return)
    assert "Choose one first" in texts(card) and fov(window) == 45.0
    press(KEY.Key_Down)
    press(KEY.Key_Up)
    press(KEY.Key_Return)
    come_to_rest(window)
    assert keyboard() is card.next, "which comes next, whatever has gone with the choices"
    said = texts(card)
    assert "You said 106.7°; the model says 91.5°." in said and "What comes" in said
    idea = idea_named("angle-linear")
    assert idea is not None and idea.title.rstrip(".") in said and "grows faster" in said
    assert fov(window) == 60.0
    (block,) = card.page.blocks
    assert not any(each.isEnabled() for each in block.findChildren(QRadioButton))
    marked = [each.accessibleDescription() for each in block.findChildren(QRadioButton)]
    assert marked == ["Your choice", "The model's answer", ""]
    press(KEY.Key_W, ALT)
    come_to_rest(window)
    assert window.store.document == idea.state
    assert card.again.isEnabled()
    press(KEY.Key_F7)
    come_to_rest(window)
    assert fov(window) == 45.0 and not card.again.isEnabled() and window.lessons.place == 0
    assert "You said" in texts(card), "the step's page is as it was left"
    press(KEY.Key_Right, ALT)
    assert window.lessons.place == 1
    press(KEY.Key_Left, ALT)
    assert window.lessons.place == 0 and "You said" in texts(card)
    assert card.findChildren(QRadioButton)[0].isChecked(), "as it was answered"


@pytest.mark.undrawn
def test_page_down_reads_to_the_end_of_a_page_and_then_turns_it(
    window: MainWindow, lesson: Path
) -> None:
    activate(window)
    window.lesson_card.open(lesson)
    come_to_rest(window)
    lessons, page = window.lessons, window.lesson_card.page
    press(KEY.Key_PageDown)
    assert lessons.place == 0 and "prediction first" in texts(window.lesson_card)
    lessons.go(1)
    for widget in (window.lesson_card.next, page):
        widget.setFocus()
        lessons.go(1)
        press(KEY.Key_PageDown, SHIFT)
        assert lessons.place == 1
        press(KEY.Key_PageDown)
        assert lessons.place == 2, widget
        press(KEY.Key_PageUp)
        assert lessons.place == 1
    page.setFocus()
    cast(QWidget, page.widget()).setMinimumHeight(2 * page.height() + 50)
    settle()
    bar = page.verticalScrollBar()
    for _ in range(9):
        if bar.value() == bar.maximum():
            break
        press(KEY.Key_PageDown)
        assert lessons.place == 1 and bar.value() > 0
    press(KEY.Key_PageDown)
    assert lessons.place == 2


@pytest.mark.undrawn
def test_a_scene_asks_nothing_beside_a_lesson(window: MainWindow, lesson: Path) -> None:
    tries = window.controls.card.tries
    assert tries.isVisible()
    assert window.lessons.open(lesson)
    settle()
    assert not tries.isVisible()
    window.lessons.close()
    settle()
    assert tries.isVisible()


def answered(window: MainWindow, typed: str) -> str:
    """What is said to a number that is typed into the first field of the step."""
    block = window.lesson_card.page.blocks[0]
    field = block.findChild(QLineEdit)
    field.setFocus()
    field.selectAll()
    QTest.keyClick(field, KEY.Key_Delete)
    QTest.keyClicks(field, typed)
    QTest.keyClick(field, KEY.Key_Return)
    settle()
    return texts(block)


HINTS = """---
title: Hints
---
# Two {#two}
```state
scene=letter-f
```
```answer one
Half?
value: 1/2
hint: One by two.
```
```answer other
A third?
value: 1/3
hint: One by three.
```
```answer bare
Four?
value: 4
```
```task near
Closer.
until: near < 0.5
hint: Drag it.
right: lens.near=0.4
```
"""


@pytest.mark.undrawn
def test_the_keys_of_several_questions_are_those_of_the_one_with_the_cursor(
    window: MainWindow, tmp_path: Path
) -> None:
    card = opened(window, tmp_path, HINTS)
    one, other, bare, near = card.page.blocks
    other.field.setFocus()
    press(KEY.Key_I, ALT)
    assert "One by three." in texts(other) and "One by two." not in texts(card)
    near.give_hint()
    near.reveal_answer()
    settle()
    assert "a state that fulfils the task" in texts(near) and "Show it" in buttons(near)
    bare.field.setFocus()
    assert not card.hint.isEnabled(), "it has none"
    one.field.setFocus()
    press(KEY.Key_I, ALT)
    assert not card.hint.isEnabled() and not clashes(window)
    assert {"Check", "Show the answer"} == {*buttons(one)} & {*buttons(other)}
    press(KEY.Key_A, ALT)
    assert not one.played.is_open and other.played.is_open
    other.field.setFocus()
    QTest.keyClicks(other.field, "0.333")
    press(KEY.Key_K, ALT)
    assert not other.played.is_open and bare.played.is_open


@pytest.mark.undrawn
def test_a_right_answer_moves_the_focus_on_and_can_be_deleted(
    window: MainWindow, lesson: Path
) -> None:
    activate(window)
    card = window.lesson_card
    card.open(lesson)
    card.begin_again()
    assert not window.messages.text  # nothing was answered
    go_to(window.lessons, 2)
    assert "It is 98.2." in answered(window, " 98,2° ") and not card.page.blocks[0].played.is_open
    assert isinstance(QApplication.focusWidget(), QLineEdit)
    assert card.page.blocks[1].isAncestorOf(QApplication.focusWidget())
    card.begin_again()
    assert "were deleted" in window.messages.text and window.lessons.place == 0
    assert not window.settings.progress[str(lesson)].answers
    go_to(window.lessons, 2)
    assert card.page.blocks[0].played.is_open
    (undo,) = window.messages.choices
    undo.click()
    assert window.lessons.place == 2 and not card.page.blocks[0].played.is_open
    card.leave()
    card.open(lesson)
    assert window.lessons.place == 2 and not card.page.blocks[0].played.is_open


@pytest.mark.undrawn
def test_the_tips_name_both_keys_and_no_frame_is_left_behind(window: MainWindow) -> None:
    card = window.lesson_card
    card.open(TOUR)
    activate(window)
    assert "Alt+Right, PgDown" in card.next.toolTip() and "Alt+Left, PgUp" in card.back.toolTip()
    card.next.setFocus()
    card.leave()
    settle()
    assert keyboard() is window
    dock = window.controls.viewport()
    click(dock, (dock.width() - 3.0, dock.height() - 3.0))
    assert keyboard() is window, "nor does a click beside the rows draw one"


def buttons_of(widget: QWidget) -> dict[str, QPushButton]:
    return {b.text().replace("&", ""): b for b in widget.findChildren(QPushButton)}


@pytest.mark.undrawn
def test_a_wrong_idea_is_seen_beside_the_model_until_the_step_goes_on(
    window: MainWindow, lesson: Path
) -> None:
    card, comparing = window.lesson_card, window.comparing
    card.open(lesson)
    (block,) = card.page.blocks
    block.findChildren(QRadioButton)[0].click()
    buttons_of(block)["Commit"].click()
    arrive(window.lessons)
    buttons_of(block)["Your idea beside the model"].click()
    arrive(window.lessons)
    settle()
    yours, model = comparing.pictures.pictures
    assert comparing.pictures.is_on and model.live and window.store.look().large == "image"
    known = card.page.blocks[0].played.here.quantities(
        set_values(window.store.document, yours.changes)
    )
    assert known["fov_x"] == pytest.approx(60 * 16 / 9)
    assert window.store.document.projection.lens.fov_y_deg == 60
    assert card.again.isEnabled()
    card.again.click()
    arrive(window.lessons)
    assert not comparing.pictures.is_on and window.store.look().large != "image"
    buttons_of(block)["Your idea beside the model"].click()
    arrive(window.lessons)
    comparing.end()
    window.slots.arrange(window.slots.layout_name, "ndc")
    card.go_on()
    arrive(window.lessons)
    assert not comparing.pictures.is_on and window.store.look().large == "ndc", (
        "as the student has put it"
    )
    for number in (2, 1):  # a wrong one without a number, and the right one
        card.begin_again()
        block = card.page.blocks[0]
        block.findChildren(QRadioButton)[number].click()
        buttons_of(block)["Commit"].click()
        assert "Your idea beside the model" not in buttons_of(block)


@pytest.mark.undrawn
def test_a_state_that_is_seen_already_is_not_offered(window: MainWindow, tmp_path: Path) -> None:
    card = opened(window, tmp_path, PREDICTED)
    for number, is_offered in ((1, False), (2, True)):
        block = card.page.blocks[0]
        block.findChildren(QRadioButton)[number].click()
        buttons_of(block)["Commit"].click()
        arrive(window.lessons)
        assert ("Show it" in buttons_of(block)) == is_offered
        assert "Show what happens" in buttons_of(block)
        card.begin_again()


def test_the_tour_can_be_done_with_the_keyboard_alone(window: MainWindow) -> None:
    activate(window)
    window.menus.lesson_menu.tour.trigger()
    card, controls = window.lesson_card, window.controls
    lens = window.store.document.projection.lens

    def done(key: Qt.Key, widget: QWidget | None = None, modifier: Any = NO_KEY) -> list[bool]:
        """What of the step is done before a key, and after it."""
        come_to_rest(window)
        found = [block.played.is_open for block in card.page.blocks]
        QTest.keyClick(widget or keyboard(), key, modifier)
        come_to_rest(window)
        found += [block.played.is_open for block in card.page.blocks]
        press(KEY.Key_Right, ALT)
        return found

    come_to_rest(window)
    (task,) = card.page.blocks
    task.show_wanted.emit(set_values(window.store.document, ["lens.near=2"]))
    come_to_rest(window)
    assert task.played.is_open, "what the lesson shows by itself, nobody has done"
    window.store.set_projection(seen(window, lens=Perspective(50.0, lens.near, lens.far)))
    come_to_rest(window)
    assert task.played.is_open, "only a nearer near plane ticks"
    near = controls.rows["near"].field
    near.setFocus()
    near.selectAll()
    QTest.keyClicks(near, "2")
    assert done(KEY.Key_Return) == [True, False]
    assert done(KEY.Key_Left, window.panes["world"].canvas) == [True, False]
    assert done(KEY.Key_2, None, Qt.KeyboardModifier.ControlModifier) == [True, False]
    assert done(KEY.Key_Left, window.strip.slider) == [True, False]
    field = controls.rows["fov_y_deg"].field
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "60")
    assert done(KEY.Key_Return) == [True, False]
    kinds = controls.rows["kind"].findChild(QComboBox)
    kinds.setFocus()
    come_to_rest(window)
    for _ in range(kinds.findText("orthographic") - kinds.currentIndex()):
        QTest.keyClick(kinds, KEY.Key_Down)
    come_to_rest(window)
    assert not card.page.blocks[0].played.is_open
    press(KEY.Key_Right, ALT)
    assert window.lessons.course is None
    first = read(contained()[0])
    assert f"Next lesson: {first.title}" in buttons(card)
    press(KEY.Key_Return)
    assert window.lessons.lesson == first


@pytest.mark.undrawn
def test_typing_in_the_dock_keeps_the_focus(window: MainWindow, lesson: Path) -> None:
    activate(window)
    window.lesson_card.open(lesson)
    come_to_rest(window)
    field = window.controls.rows["near"].field
    field.setFocus()
    window.lessons.go(2)
    settle()
    assert QApplication.focusWidget() is field


@dataclass(frozen=True, kw_only=True)
class Guess(Asked):
    """A kind of block that the program does not know."""

    kind = "guess"
    reveals = True

    @classmethod
    def read(cls, body: Body) -> Guess:
        text, items = body.items("hint")
        return cls(**cls.fields(body, text, items))

    def verdict(self, here: Here, sample: str, line: int) -> str:
        return "right" if sample == "7" else "wrong"

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        return f"{self.text} It is 7."


@pytest.mark.undrawn
def test_a_new_kind_of_block_is_a_class_and_a_view(
    window: MainWindow, lesson: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As docs/architecture.md says: nothing else of the program asks for the kind."""
    monkeypatch.setitem(KINDS, "guess", Guess)
    monkeypatch.setitem(VIEWS, Guess, BlockView)
    lesson.write_text(
        "---\ntitle: New\n---\n# One\n```guess mine\nWhich number?\nhint: Odd.\n```\n"
        "```test\nmine: 7 -> right\nmine: 8 -> wrong\n```\n```note\nminutes: 1\n```\n",
        encoding="utf-8",
    )
    report = CheckReport()
    report.read(lesson)
    assert (report.checks, report.wrong) == (2, [])
    card = window.lesson_card
    card.open(lesson)
    (view,) = card.page.blocks
    card.give_hint()
    settle()
    assert texts(view) == "Which number?\nHint: Odd."
    view.played.submit("7", Verdict(True))
    assert window.settings.progress[str(lesson)].answers == {"one/mine": "7"}
    present(window)
    assert window.talks.reveal() and window.talks.reveal()
    assert "Which number? It is 7." in window.slide.question.accessibleName()


# --------------------------------------------------------------------------- the keyboard alone

EXERCISE = (
    """---
title: Practise
---
# Widths {#widths}
```state
scene=letter-f
```
```exercise wide
"""
    + WIDE
    + """hint: Take the tangent.
```
```exercise set
vary near: 0.5..4 step 0.1
Set near to {=near}.
until: near = near_wanted
why: Near is ${=near}$.
right: lens.near={=near}
wrong look-n: near = near_wanted + 1
```
"""
)


@pytest.mark.undrawn
def test_an_exercise_is_practised_by_keyboard_alone(window: MainWindow, tmp_path: Path) -> None:
    path = tmp_path / "practise.md"
    text = EXERCISE.replace("vary near", "vary near_wanted").replace("{=near}", "{=near_wanted}")
    path.write_text(text, encoding="utf-8")
    activate(window)
    card = window.lesson_card
    card.open(path)
    come_to_rest(window)
    view, task = card.page.blocks
    played = view.played
    variant, right = played.variant, played.question.answer(played.here)
    assert window.store.document == variant.here.document, "it has begun by itself"
    assert keyboard() is view.first is view.asked.field and task.played.variant is None
    assert not card.again.isEnabled(), "this is what the step shows"
    assert variant.question.text in texts(view) and card.hint.isEnabled()
    window.store.set_document(set_values(window.store.document, ["lens.near=0.5"]))
    come_to_rest(window)
    press(KEY.Key_F7)
    come_to_rest(window)
    assert window.store.document == variant.here.document, "the numbers of the text again"
    QTest.keyClicks(QApplication.focusWidget(), f"{right:.4g}")
    press(KEY.Key_Return, NO_KEY)
    assert "Right." in texts(view) and not played.is_open
    press(KEY.Key_O, ALT)
    come_to_rest(window)
    assert (played.seed, played.is_open) == (2, True)
    assert window.store.document == played.here.document != variant.here.document
    assert played.question.text in texts(view) and variant.question.text not in texts(view)
    view.seed.setFocus()
    view.seed.selectAll()
    QTest.keyClicks(view.seed, "77")
    press(KEY.Key_Return, NO_KEY)
    come_to_rest(window)
    press(KEY.Key_I, ALT)
    press(KEY.Key_A, ALT)
    assert spoken_text(played.question.solution(played.here)) in texts(view) and played.seed == 77
    assert not clashes(window)

    task.begin()
    come_to_rest(window)
    wanted = float(task.played.variant.numbers["near_wanted"])
    assert "Show the answer" not in buttons(task)
    enter(window.controls.rows["near"].field, str(wanted + 1))
    come_to_rest(window)
    assert "Show the answer" in buttons(task), "after a wrong try"
    task.asked.rest()
    come_to_rest(window)
    assert "n is where I look" in texts(task) and "Show it" in buttons(task)
    enter(window.controls.rows["near"].field, str(wanted))
    come_to_rest(window)
    assert task.played.answer == DONE

    window.lessons.close()
    card.open(path)
    come_to_rest(window)
    view, task = card.page.blocks
    assert view.played.answer == REVEALED and view.seed.text() == "77"
    assert window.store.document == task.played.here.document, "beside its text"


def test_a_step_with_an_exercise_is_shown_at_once_with_its_numbers(
    window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "practise.md"
    path.write_text(EXERCISE.replace("# W", "# First\nText.\n\n---\n# W", 1), encoding="utf-8")
    window.settings.reduce_motion = True
    activate(window)
    window.lesson_card.open(path)
    settle()
    shown, placed, place = list[Document](), list[object](), labels.place
    window.store.changed.connect(shown.append)
    monkeypatch.setattr(
        labels, "place", lambda *args, **kw: placed.append(args) or place(*args, **kw)
    )
    assert window.lessons.next()
    played = window.lesson_card.page.blocks[0].played
    assert shown == [played.here.document] == [window.store.document]
    assert len(placed) <= len(window.panes), "once in each pane"
    window.menus.undo.trigger()
    assert window.store.document == shown[0], "undo does not leave the step"


@pytest.mark.undrawn
def test_the_card_says_what_is_wrong_in_a_saved_file(window: MainWindow, lesson: Path) -> None:
    activate(window)
    card, check = window.lesson_card, window.menus.lesson_menu.check
    assert not check.isEnabled()
    right = lesson.read_text(encoding="utf-8").replace("<script>alert(1)</script> ", "")
    lesson.write_text(right, encoding="utf-8")
    card.open(lesson)
    settle()
    check.trigger()
    assert "Nothing is wrong" in texts(card)
    wrong = right.replace("{angle-linear}", "{angle-liner}").replace("$a = 9/16$", "$a = 9/16")
    lesson.write_text(wrong, encoding="utf-8")
    window.lessons.read_again()
    assert "line 5" in texts(card) and "no other $" in texts(card)
    assert "angle-liner" in texts(card) and not window.messages.text
    lesson.write_text(wrong.replace("It is", "```nosuch\n```\nIt is"), encoding="utf-8")
    window.lessons.read_again()
    assert "unknown kind of block, nosuch" in texts(card)
    lesson.write_text(right, encoding="utf-8")
    window.lessons.read_again()
    assert "angle-liner" not in texts(card) and "nosuch" not in texts(card)


@pytest.mark.undrawn
def test_a_check_runs_beside_the_window_and_can_be_cancelled(
    window: MainWindow, lesson: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("widgets.parts.progress.SHOWN_AFTER_MS", 0)
    threads, said, ended = list[threading.Thread](), list[str](), threading.Event()

    def check(_report: CheckReport, _path: Path, progress: ReportProgress) -> None:
        threads.append(threading.current_thread())
        end = time.monotonic() + 10.0
        while progress(0.0) and time.monotonic() < end:  # one long piece: no other fraction
            time.sleep(0.01)
        ended.set()

    def cancel() -> None:
        dialog = QApplication.activeModalWidget()
        if isinstance(dialog, QProgressDialog):
            said.append(dialog.labelText())
            window.lessons.read_again()  # the file has changed meanwhile
            dialog.cancel()

    window.lesson_card.open(lesson)
    monkeypatch.setattr(CheckReport, "read", check)
    timer = QTimer(interval=10)
    timer.timeout.connect(cancel)
    timer.start()
    window.lesson_card.check()
    timer.stop()
    assert len(threads) == 1 and threads[0] is not threading.main_thread()
    assert said == [f"Checking {lesson.name}"]
    assert ended.wait(10.0), "the check ends, too"
    assert "Nothing is wrong" not in texts(window.lesson_card)


MATRIX = """---
title: A matrix
---
# Scale {#scale}
```state
scene=letter-f
```
```answer scale
Scale by 2, 3.5 in x, y.
matrix: 2, 0; 0, 3.5
wrong order: 3.5, 0; 0, 2
why: On the diagonal.
```
"""


BEGUN = (
    MATRIX
    + """
```answer half
Half?
value: 1/2
hint: Less than 1.
```
```answer which
Which?
- [ ] One
- [x] The other
```
```answer tiles
Which order?
order: translate 3,0,0; scale 1,2,1
tiles: scale 1,2,1; translate 3,0,0
```
---
# Another {#another}
"""
)


@pytest.mark.undrawn
def test_what_is_typed_and_not_submitted_outlives_another_step(
    window: MainWindow, tmp_path: Path
) -> None:
    card = opened(window, tmp_path, BEGUN)
    cells, half, which, tiles = card.page.blocks
    cells.findChildren(QLineEdit)[1].setText("3|")
    half.findChild(QLineEdit).setText("0,")
    half.give_hint()
    which.findChildren(QRadioButton)[1].click()
    tiles.findChildren(QLineEdit)[0].clear()
    begun = [view.typed for view in card.page.blocks]
    assert begun == [" | 3 ;  | ", "0,", "2", "scale; translate 3,0,0"]
    for _ in range(2):
        go_to(window.lessons, 1)
        go_to(window.lessons, 0)
    assert [view.typed.replace(" ", "") for view in card.page.blocks] == [
        each.replace(" ", "") for each in begun
    ]
    _, half, which, tiles = card.page.blocks
    assert "Less than 1." in texts(half) and "Show the answer" in buttons(half)
    assert buttons(which)["Check"].isEnabled()
    assert not any(each.isHidden() for each in tiles.findChildren(QLineEdit))


@pytest.mark.undrawn
def test_a_matrix_is_filled_in_by_keyboard_alone(window: MainWindow, tmp_path: Path) -> None:
    path = tmp_path / "matrix.md"
    path.write_text(MATRIX, encoding="utf-8")
    activate(window)
    card = window.lesson_card
    card.open(path)
    settle()
    (view,) = card.page.blocks
    first, second, third, last = view.cells
    assert keyboard() is first and second.accessibleName() == "Row 1, column 2"
    QTest.keyClicks(first, "2")
    press(KEY.Key_Right)
    assert keyboard() is second
    press(KEY.Key_Right)
    assert keyboard() is second, "there is no third column"
    QTest.keyClicks(second, "zero")
    press(KEY.Key_Down)
    assert keyboard() is last
    QTest.keyClicks(last, "-3.5")
    press(KEY.Key_Left)
    assert keyboard() is last, "only the cursor has moved, which was behind the text"
    press(KEY.Key_Backtab, Qt.KeyboardModifier.ShiftModifier)
    assert keyboard() is third
    press(KEY.Key_Return)
    assert keyboard() is second and "Row 1, column 2 = “zero”" in texts(view)
    QTest.keyClicks(second, "0")
    press(KEY.Key_Return)
    assert keyboard() is third and "Row 2, column 1 must be a number" in texts(view)
    QTest.keyClicks(third, "0")
    press(KEY.Key_Return)
    assert "The marked numbers have the wrong sign." in texts(view) and view.played.is_open
    assert [each.accessibleDescription() for each in view.cells] == ["Right"] * 3 + ["Wrong"]
    assert keyboard() is last
    QTest.keyClicks(last, "3,5")
    assert not last.accessibleDescription(), "an edited number is not marked any more"
    press(KEY.Key_Return)
    assert "On the diagonal." in texts(view) and not view.played.is_open
    card.leave()
    card.open(path)
    settle()
    (view,) = card.page.blocks
    assert view.played.answer and [cell.text() for cell in view.cells] == ["2", "0", "0", "3,5"]
    assert {each.accessibleDescription() for each in view.cells} == {"Right"}


HIDING = """---
title: Hiding
---
# Film {#film}
```state
scene=camera-obscura
```
```exercise film
vary d: 2..6 step 0.1
state: settings.distance={=d}
The arrow is 5 high and 9 away, the film {=d} behind the hole. How high is the picture?
value: 5*d/9
hide: numbers, lens, world
```

---
# More {#more}
Text.
"""


def test_what_would_show_the_answer_is_hidden_until_it_is_given(
    window: MainWindow, tmp_path: Path
) -> None:
    path = tmp_path / "hiding.md"
    path.write_text(HIDING, encoding="utf-8")
    activate(window)
    card, panels, scene = window.lesson_card, window.panels, window.controls.card
    names = window.panels.names.findChildren(QToolButton)
    cursor, canvas = window.cursors["image"], window.panes["image"].canvas
    more = window.controls.sections["more_lens"]
    more.set_open(True)

    def is_hidden() -> bool:
        """Whether every place where numbers are is closed."""
        canvas.setFocus()
        QTest.keyClick(canvas, KEY.Key_PageDown)
        settle()
        why = "Hidden until the exercise is answered"
        found = [
            *(not name.isEnabled() and why in name.toolTip() for name in names),
            why in scene.readout.note.text(),
            not any(value.isVisible() for _, value, _ in scene.readout.lines),
            not scene.explanation.isEnabled(),
            cursor.text == why,
            why in texts(window.panes["world"]),
            not more.is_open and why in more.heading.toolTip(),
        ]
        assert len({*found}) == 1, f"everything, or nothing: {found}"
        return found[0]

    show_scene(window, "camera-obscura")
    panels.open(window.probe_panel)
    assert not is_hidden()
    card.open(path)
    come_to_rest(window)
    (view,) = card.page.blocks
    assert is_hidden() and panels.open_panel is None
    scene.explanation.clicked.emit()
    assert panels.open_panel is None, "by no way"
    view.asked.field.setText(f"{view.played.question.answer(view.played.here):.4g}")
    view.asked.check()
    come_to_rest(window)
    assert not view.played.is_open and not is_hidden()
    assert "5d over 9 equals" in texts(view), "the way to the answer, which nothing else explains"
    assert panels.open_panel is window.scene_panel, "which was asked for meanwhile"
    view.go_on()
    come_to_rest(window)
    assert is_hidden()
    card.go_on()
    come_to_rest(window)
    assert not is_hidden()


@pytest.mark.undrawn
def test_what_two_steps_hide_is_hidden_once(window: MainWindow, tmp_path: Path) -> None:
    path = tmp_path / "hiding.md"
    head, film, more = re.split("(?m)^(?=# )", HIDING)
    path.write_text(head + film + film.replace("film}", "again}") + more, encoding="utf-8")
    told: list[Any] = []
    window.lesson_card.page.hidden.connect(told.append)
    assert window.lesson_card.open(path)
    assert window.lessons.go(1) and window.lessons.go(2)
    assert told == [{"numbers", "lens", "world"}, frozenset()]


CLICK = """---
title: Click
---
# Places {#places}
```state
scene=letter-f
```
```answer image
Where is the middle of the right half?
click: image
at: 3*width/4, height/2
wrong order: width/4, height/2
  says: That is the left half.
```
```answer ndc
Where is the corner?
click: ndc
at: 1, -1, 1
```
```answer world
Where does the camera look?
click: world
at: target_x, target_y, target_z
```
"""


def test_a_place_is_pointed_at_by_mouse_or_by_keyboard_alone(
    window: MainWindow, tmp_path: Path
) -> None:
    path = tmp_path / "click.md"
    path.write_text(CLICK, encoding="utf-8")
    activate(window)
    card = window.lesson_card
    card.open(path)
    come_to_rest(window)
    image, ndc, world = card.page.blocks
    canvas = window.panes["image"].canvas
    x, y, width, height = window.panes["image"].drawing.picture_rectangle_px

    def crosses(pane: str) -> list[QPoint]:
        """The middles of the visible marks of a pane."""
        found = window.panes[pane].canvas.findChildren(Cross)
        return [mark.geometry().center() for mark in found if mark.isVisible()]

    target = window.shown.projection.camera.target
    trace = window.shown.projection.trace(target)
    own = {"world": target, "ndc": trace.ndc, "image": trace.image[:2]}
    for name, place in own.items():
        drawing = window.panes[name].drawing
        assert np.allclose(drawing.spots_of(np.array([place])), drawing.sight.seen([target]))

    # By keyboard: from the button into the picture, by steps of ten, then Enter.
    assert keyboard() is image.first
    press(KEY.Key_Return)
    assert keyboard() is canvas and crosses("image") == [canvas.rect().center()]
    press(KEY.Key_Left)
    press(KEY.Key_Right)
    for _ in range(round(width / 40.0)):
        press(KEY.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    press(KEY.Key_Return)
    assert "That is the left half." in texts(image) and image.played.is_open
    for _ in range(round(width / 20.0)):
        press(KEY.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    press(KEY.Key_Return)
    settle()
    assert keyboard() is ndc.first, "the keys go on to the next question"
    assert (
        not image.played.is_open and "Right." in texts(image) and image.played.answer == "960 360"
    )
    (middle,) = crosses("image")
    assert abs(middle.x() - (x + 0.75 * width)) <= 1.5, "the exact place is marked"
    assert abs(middle.y() - (y + height / 2.0)) <= 1.5

    # Any question may be answered first.
    buttons(world)["Click in the picture: world"].click()
    assert keyboard() is window.panes["world"].canvas and len(crosses("world")) == 1
    # By mouse: the click places the crosshair, and follows no vertex; Check takes it.
    canvas = window.panes["ndc"].canvas
    places = window.panes["ndc"].drawing.spots_of(np.array([[1.0, -1.0, 1.0], [1.0, 1.0, 1.0]]))
    right, wrong = (QPoint(*np.round(spot).astype(int).tolist()) for spot in places)
    QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=wrong)
    assert not window.probe_panel.probes and len(crosses("ndc")) == 1
    assert not crosses("image"), "only the question that is asked has a crosshair"
    press(KEY.Key_Return)
    assert "That is not it." in texts(ndc)
    QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=right + QPoint(6, 6))
    world.check()
    settle()
    assert "That is not it." in texts(world), "by its own crosshair, in the middle"
    press(KEY.Key_Return)
    assert not ndc.played.is_open

    # In the world the pane's own camera decides; another state must be shown again first.
    canvas = window.panes["world"].canvas
    window.store.set_projection(seen(window, lens=Perspective(50.0, 1.5, 60.0)))
    come_to_rest(window)
    ((x, y),) = window.panes["world"].drawing.sight.seen([window.shown.projection.camera.target])
    QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=QPoint(round(x), round(y)))
    settle()
    assert "shows something else now" in texts(world) and not crosses("world")
    buttons(world)["Show it again"].click()
    come_to_rest(window)
    window.panes["world"].canvas.setFocus()
    QTest.keyClick(window.panes["world"].canvas, KEY.Key_Left)  # turn it: no crosshair yet
    settle()
    ((x, y),) = window.panes["world"].drawing.sight.seen([window.shown.projection.camera.target])
    QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=QPoint(round(x) + 5, round(y)))
    press(KEY.Key_Return)
    assert not world.played.is_open
    card.leave()
    canvas = window.panes["image"].canvas
    assert not crosses("world")
    QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=canvas.rect().center())
    assert window.probe_panel.probes, "a click follows a point again"
    card.open(path)
    settle()
    assert not any(block.played.is_open for block in card.page.blocks) and not crosses("image")
    typed = [float(each) for each in window.record.read()[1].typed.split()]
    assert np.allclose(typed, (960, 360), atol=12.5 * 1280 / width), "where it was clicked"


@pytest.mark.parametrize("pane", ["image", "ndc", "world"])
def test_a_place_stays_marked_when_the_window_changes_its_size(
    window: MainWindow, tmp_path: Path, pane: str
) -> None:
    path = tmp_path / "click.md"
    path.write_text(CLICK, encoding="utf-8")
    activate(window)
    window.lesson_card.open(path)
    come_to_rest(window)
    view = next(each for each in window.lesson_card.page.blocks if each.question.pane == pane)
    canvas, answer = window.panes[pane].canvas, view.question.answer(view.played.here)

    def spot() -> QPoint:
        """Where the right place is."""
        ((x, y),) = window.panes[pane].drawing.spots_of(np.array([answer]))
        return QPoint(round(x), round(y))

    QTest.mouseClick(canvas, Qt.MouseButton.LeftButton, pos=spot())
    before = spot()
    window.resize(window.width() - 200, window.height() - 120)
    come_to_rest(window)
    moved = spot() - before
    assert moved.manhattanLength() > 20
    (mark,) = (each for each in canvas.findChildren(Cross) if each.isVisible())
    assert (mark.geometry().center() - spot()).manhattanLength() <= 3
    view.check()
    assert not view.played.is_open, texts(view)


@pytest.mark.undrawn
def test_a_hidden_card_shows_only_the_lesson_that_opens(
    window: MainWindow, lesson: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A lesson that opens over a talk shows the card before the card has it: no page of the talk.

    The number of the talk's step once ended the program: an error in `showEvent` crashes PySide.
    """
    card = window.lesson_card
    window.lessons.open(CONTENT / "talk-003.md")
    present(window)
    go_to(window.lessons, 4)
    assert window.talks.is_on and card.isHidden() and card.page.widget() is None
    made: list[str] = []
    make = StepPage.make

    def noted(page: StepPage, player: Player) -> None:
        made.append(player.lesson.title)
        make(page, player)

    monkeypatch.setattr(StepPage, "make", noted)
    window.lessons.open(lesson)
    settle()
    assert not card.isHidden() and made == ["How wide?"]


def test_the_handles_of_a_task_are_shown_as_its_step_opens(
    window: MainWindow, lesson: Path, qtbot: QtBot
) -> None:
    activate(window)
    window.settings.reduce_motion = True
    drawing = window.panes["world"].drawing
    window.lesson_card.open(lesson)
    settle()
    assert drawing is not None and not drawing.handles.called
    go_to(window.lessons, 1)  # the task: until near < was_near
    settle()
    drawing = window.panes["world"].drawing
    assert drawing.handles.called == {"near"}
    window.panes["world"].request("grips", ())  # at rest there is no mark
    with_handle = pixels(window)
    qtbot.waitUntil(lambda: not drawing.handles.called)
    without = pixels(window)
    (near,) = (at for handle, at in drawing.handles.shown if handle.name == "near")
    changed = np.argwhere((with_handle != without).any(axis=2))
    assert len(changed), "a mark was there"
    assert np.abs(changed[:, ::-1] - near).max() < 30, "and no other"


KINDS_OF_ANSWER = """---
title: Feedback
---
# Number {#number}
```state
scene=letter-f
```
The tangent of half an angle is the half height at the distance 1: $\\tan(fov/2) = h/2$.
```exercise wide
vary fov: 20..60 step 1
The picture is {=fov}° high and twice as wide. How wide is its angle, seen from the eye?
value: 2*atan(2*tan(fov/2))
unit: °
wrong angle-linear: 2*fov
hint: Draw the right triangle from the eye to the middle of the upper edge of the window.
why: Half of the angle has twice the tangent, and so less than twice the angle.
```

---
# Matrix {#matrix}
```exercise scale
vary k: 2..30
Scale by {=k} in x and by 3.5 in y. Which matrix does so, with columns for the images of the axes?
matrix: k, 0; 0, 3.5
wrong order: 3.5, 0; 0, k
hint: The first column is the image of the x axis, which becomes {=k} times as long.
why: The numbers on the diagonal scale.
```

---
# Click {#click}
```exercise point
vary x: 0..600 step 10
Where in the picture is the point x = {=x}, y = 200, both in pixels from the upper left?
click: image
at: x, 200
wrong order: 200, x
  says: That is x and y exchanged.
where: abs(x - 200) > 40
hint: x goes to the right, y goes down.
why: Pixels are counted from the upper left.
```

---
# Task {#task}
```exercise set
vary w: 2..9 step 0.1
Bring the near plane to the distance {=w} from the eye.
until: near = w
hint: The near plane can be dragged in the world, or typed in the dock.
done: The plane is where the picture begins.
why: It is the distance of the plane, {=w}.
```

---
# Choice {#choice}
```exercise twice
vary w: 1..3 step 0.1
state: lens.near={=w}
Which number is twice the distance of the near plane from the eye?
- [x] {=2*w} := 2*near
- [ ] {=3*w} := 3*near {order}
- [ ] {=4*w} := 4*near
  says: That is four times, because it is twice the double.
hint: The near plane is {=w} away from the eye.
why: It is twice {=w}.
```

---
# Prediction {#prediction}
```predict
The near plane goes to 2. Which number is twice the distance of the near plane from the eye then?
- [x] 4 := 2*near
- [ ] 6 := 3*near
  says: That is three times the distance, and three times is one half more than twice, always.
- [ ] 8 := 4*near
  says: That is four times.
show: lens.near=2
why: Twice the distance is the distance and the distance again, so it is 4 for a distance of 2.
```
"""


@pytest.mark.parametrize("size", [1.0, 1.75])
def test_every_response_is_seen_whole_and_announced(
    make_window: MakeWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, size: float
) -> None:
    """At the size of a small laptop, also with large letters."""
    heard: list[str] = []
    listening = SimpleNamespace(updateAccessibility=lambda event: heard.append(event.message()))
    monkeypatch.setattr("widgets.window.lesson_blocks.view.QAccessible", listening)
    path = tmp_path / "feedback.md"
    path.write_text(KINDS_OF_ANSWER, encoding="utf-8")
    own = QApplication.font()
    large, application = QFont(own), cast(QApplication, QApplication.instance())
    large.setPointSizeF(size * own.pointSizeF())
    QApplication.setFont(large)
    application.setProperty("frustumLabFontSize", large.pointSizeF())  # from which it makes its own
    try:
        window = make_window(drawn=False)
        assert window.font() == large
        window.resize(1366, 768)
        activate(window)
        card, side = window.lesson_card, window.side
        card.open(path)
        said: list[QWidget] = []

        def response(of: str) -> str:
            """Return the newest response, once it is seen as a whole."""
            settle()
            settle()
            page = card.findChild(QScrollArea)
            (view,) = card.page.blocks
            assert page is not None and heard, of
            for widget in view.response:
                corner = widget.mapTo(page.viewport(), QPoint())
                seen = page.viewport().rect().contains(QRect(corner, widget.size()))
                assert seen and widget not in said, of
            said[:] = view.response
            text = "\n".join(texts(widget) for widget in view.response)
            assert heard[-1].split()[0] in text or heard[-1].split()[1] in text, of
            heard.clear()
            return text

        def answer(view: Any, *, right: bool) -> None:
            asked = view.asked
            if isinstance(asked, ClickView):
                place = asked.question.answer(asked.played.here)
                asked.take(lambda at: 0.0 if right and len(at) == 2 else 500.0, place)
                asked.check()
            elif isinstance(asked, ChoiceView):
                asked.findChildren(QRadioButton)[0 if right else 1].click()
                asked.commit()
            elif isinstance(asked, TaskView):
                number = float(view.played.variant.numbers["w"]) + (not right)
                lens = Perspective(45.0, number, 100.0)
                window.store.set_projection(seen(window, lens=lens))
                come_to_rest(window)
            else:
                fields = asked.findChildren(QLineEdit)
                values = asked.question.values(asked.played.here, *asked.question.key)
                for field, value in zip(fields, values, strict=True):
                    field.setText(f"{value * (1 if right else 3):.6g}")
                asked.check()

        for place in range(5):
            go_to(window.lessons, place)
            come_to_rest(window)
            (view,) = card.page.blocks
            before = side.sizes()
            of = f"{place} at {size}"
            assert view.played.variant is not None, of
            answer(view, right=False)
            if not isinstance(view.asked, TaskView):
                assert "not it" in response(f"wrong {of}") or "idea" in texts(view)
            press(KEY.Key_I, ALT)
            assert "Hint" in response(f"hint {of}")
            press(KEY.Key_A, ALT)
            assert response(f"shown {of}") and view.played.answer == REVEALED
            card.page.room_wanted.emit(30)
            view.go_on()
            come_to_rest(window)
            assert size > 1.0 or side.sizes() == before, "the numbers are new, and so is the room"
            heard.clear()
            answer(view, right=True)
            said_last = response(f"right {of}")
            assert not view.played.is_open and view.played.seed == 2, of
            if not isinstance(view.asked, TaskView):  # the way, besides its reason
                way = spoken_text(view.asked.question.solution(view.played.variant.here))
                assert way in said_last and "." in said_last.replace(way, ""), of
            window.controls.rows["near"].field.setFocus()
            settle()
            assert side.sizes() == before, "the controls are as high as before where they are used"
        go_to(window.lessons, 5)
        (view,) = card.page.blocks
        view.findChildren(QRadioButton)[1].click()
        side.setSizes([view.height() + 220, 400])  # less than what is said below needs
        settle()
        view.commit()
        assert "Twice the distance is" in response(f"prediction {size}")
    finally:
        QApplication.setFont(own)
        application.setProperty("frustumLabFontSize", own.pointSizeF())


@pytest.mark.undrawn
def test_a_screen_reader_meets_a_document_and_tabs(window: MainWindow, lesson: Path) -> None:
    activate(window)
    card = window.lesson_card
    card.open(lesson)
    role_of = QAccessible.queryAccessibleInterface
    text = card.findChildren(LessonText)[1]
    assert role_of(text).role() == QAccessible.Role.Document
    assert "vertical" in role_of(text).text(QAccessible.Text.Name)
    marks = card.findChild(QWidget, "stepMarks")
    assert role_of(marks).role() == QAccessible.Role.PageTabList
    tabs = [role_of(mark) for mark in marks.findChildren(QToolButton)]
    assert [tab.role() for tab in tabs] == [QAccessible.Role.PageTab] * 4
    assert [tab.state().selected for tab in tabs] == [1, 0, 0, 0]
    for mark in marks.findChildren(QToolButton)[:2]:
        mark.setFocus()
        seen_with_focus = mark.grab().toImage()
        mark.clearFocus()
        assert mark.grab().toImage() != seen_with_focus
    assert "Practice" not in texts(card)
    assert tabs[1].text(QAccessible.Text.Name) == "Step 2: By hand"
    window.lessons.go(1)
    tabs[0].actionInterface().doAction(tabs[0].actionInterface().actionNames()[0])
    assert window.lessons.place == 0 and tabs[0].state().selected
    mixed = lesson.with_name("mixed.md")
    begun = KINDS_OF_ANSWER.replace("# Number", "# Words\nRead them.\n\n---\n# Number", 1)
    mixed.write_text(begun, encoding="utf-8")
    card.open(mixed)
    settle()
    names = {role_of(mark).text(QAccessible.Text.Name) for mark in marks.findChildren(QToolButton)}
    assert names >= {"Step 1: Words", "Step 2, practice: Number", "Step 6, practice: Choice"}
    assert texts(card).count("Practice") == 1


@pytest.mark.undrawn
def test_a_pasted_matrix_fills_all_cells_of_an_answer(window: MainWindow, tmp_path: Path) -> None:
    path = tmp_path / "matrix.md"
    path.write_text(
        MATRIX.replace("2, 0; 0, 3.5", "1, 0, 7; 0, 1, 8; 0, 0, 1").replace(
            "3.5, 0; 0, 2", "1, 0, 8; 0, 1, 7; 0, 0, 1"
        ),
        encoding="utf-8",
    )
    activate(window)
    window.lesson_card.open(path)
    settle()
    (view,) = window.lesson_card.page.blocks
    control = Qt.KeyboardModifier.ControlModifier
    for text, cells in (
        ("[[1, 0, 7], [0, 1, 8], [0, 0, 1]]", "1 0 7 0 1 8 0 0 1"),
        ("1 0 0 7; 0 1 0 8; 0 0 1 9; 0 0 0 1", None),
    ):
        view.cells[0].setFocus()
        view.cells[0].clear()
        QGuiApplication.clipboard().setText(text)
        press(KEY.Key_V, control)
        shown = " ".join(cell.text() for cell in view.cells)
        assert shown == cells if cells else shown.startswith(text[:8])  # as into any field
    view.cells[0].setText("1")
    press(KEY.Key_Return)
    assert "On the diagonal." in texts(view)


def is_in_view(area: QScrollArea, widget: QWidget) -> bool:
    """Whether a widget is seen whole without scrolling."""
    top = widget.mapTo(area.viewport(), QPoint()).y()
    return top >= -1 and top + widget.height() <= area.viewport().height() + 1


def needed(step: Step, window: MainWindow) -> list[Any]:
    """The rows of the dock that a step names: in its state, or in italics."""
    said = re.findall(r"\*([^*]+)\*", " ".join(part.text for part in step.parts))
    asked = window.store.document.view.controls
    of_scene = {f"settings.{key}": row for key, row in window.controls.card.rows.items()}
    paths = [path.rpartition(".")[2] for path in asked if path not in of_scene]
    rows = [(key in asked, row) for key, row in of_scene.items()]
    rows += [(key in paths, row) for key, row in window.controls.rows.items()]
    return [row for is_asked, row in rows
            if (is_asked or row.name in said) and row.isVisibleTo(window.controls)]  # fmt: skip


@pytest.mark.undrawn
@pytest.mark.parametrize("number", range(4))
def test_nothing_that_a_step_needs_is_below_the_fold(window: MainWindow, number: int) -> None:
    """In a quarter of the lessons, one after the other in one window."""
    window.resize(1366, 768)
    window.settings.reduce_motion = True
    for course in sorted(CONTENT.glob("l*.md"))[number::4]:
        assert window.lesson_card.open(course)
        page, lesson = window.lesson_card.page, window.lessons.lesson
        assert lesson is not None
        for place, step in enumerate(lesson.steps):
            assert window.lessons.go(place)
            settle()
            where = course.stem, step.title
            for row in needed(step, window):
                assert is_in_view(window.controls, row), (*where, row.name)
            assert page.widget().height() <= page.viewport().height() + 1, where
            answers = [*page.findChildren(QLineEdit), *page.findChildren(QPushButton)]
            assert all(is_in_view(page, each) for each in answers if each.isVisible()), where


@pytest.mark.undrawn
def test_a_step_that_is_done_moves_no_mark_and_widens_nothing(window: MainWindow) -> None:
    card = window.lesson_card
    card.open(CONTENT / "l01-camera-frame.md")
    settle()
    marks = card.findChild(QWidget, "stepMarks").findChildren(QToolButton)

    def widths() -> list[int]:
        return [*(mark.width() for mark in marks), card.minimumSizeHint().width(), card.width()]

    before, player = widths(), window.lessons.player
    assert player is not None
    for step in player.lesson.steps:
        for name in [part.name for part in step.asked] or [""]:
            player.keep_answer(f"{step.name}/{name}", DONE)
    window.lessons.go(1)
    settle()
    assert [mark.text() for mark in marks[:3]] == ["✓", "2", "✓"]
    assert widths() == before
