"""Tests of several topics, and exercises that come back: by keyboard alone."""

import time
from collections.abc import Iterator
from datetime import date, timedelta
from pathlib import Path

import pytest
from PySide6.QtCore import QDate, QLocale, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QFileDialog,
    QInputDialog,
    QLabel,
    QLineEdit,
    QRadioButton,
    QToolButton,
)
from pytestqt.qtbot import QtBot

from app.lessons import practice
from app.lessons.course import Course
from app.lessons.lesson import read as read_lesson
from app.lessons.practice import (
    ExerciseMark,
    Sheet,
    draw_test,
    exercises_of,
    find_waiting,
    to_review,
)
from app.lessons.record import RIGHT, WRONG, Attempt, standings
from app.lessons.results import read
from tests.support.exercises import WIDE
from tests.support.layout import cut
from tests.support.window import activate, enter, settle
from tests.widgets.test_lesson_card import ALT, KEY, buttons, come_to_rest, keyboard, press, texts
from widgets.parts.labels import WarningLabel
from widgets.window.lesson_blocks.view import Sign
from widgets.window.main_window import RECORD, MainWindow
from widgets.window.overview import Overview, SelfTestMarks
from widgets.window.practice import SelfTestDialog, review_text
from widgets.window.settings import data_folder

pytestmark = pytest.mark.undrawn

HEAD = """---
title: {0}
topic: {0}
---
# Practise {{#practise}}
```state
scene=letter-f
view.panel=matrices
```
Angles go from bottom to top.
"""
HINTED = f"```exercise wide\n{WIDE}hint: Take the tangent.\nwhy: The tangent grows faster.\n```\n"
SET = """```exercise set
vary wanted: 0.5..4 step 0.1
Set near to {=wanted}.
until: near = wanted
done: It is there.
```
"""
CHOOSE = """```exercise choose
vary n: 2..40
Is {=n} larger than {=n+1}?
- [ ] yes
- [x] no
```
"""


@pytest.fixture(autouse=True)
def own_topics(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[None]:
    lessons = {}
    for name, blocks in (("L3", HINTED + SET), ("L5", CHOOSE)):
        path = tmp_path / f"{name}.md"
        path.write_text(HEAD.format(name) + blocks, encoding="utf-8")
        lessons[name] = read_lesson(path)
    found = {name: Course(lesson) for name, lesson in lessons.items()}
    monkeypatch.setattr(practice, "topics", lambda: found)
    monkeypatch.setattr("widgets.window.practice.topics", lambda: found)
    yield


def test_an_answer_that_cannot_be_one_is_none(qtbot: QtBot) -> None:
    """The file that keeps a test until it is handed in may be damaged."""
    sheet = Sheet("", "", draw_test(["L5"], 7), is_test=True)
    (item,), (step,) = sheet.items, sheet.lesson.steps
    key = f"{step.name}/choose"
    for typed in ("abc", "3", "-1", "2" * 5000, "1" + "\N{SUPERSCRIPT TWO}"):
        marks = practice.marked(sheet, {key: f"{item.variant.seed} {typed}"})
        assert marks == [ExerciseMark(item, "", WRONG)]
        qtbot.addWidget(SelfTestMarks(marks))
    assert practice.marked(sheet, {key: f"{item.variant.seed} 2"}) == [
        ExerciseMark(item, "2", RIGHT)
    ]


def test_a_number_gives_everyone_the_same_test() -> None:
    def keys(names: list[str], number: int) -> list[tuple[str, int]]:
        return [(item.placed.exercise.name, item.variant.seed) for item in draw_test(names, number)]

    assert keys(["L3", "L5"], 7) == keys(["L5", "L3"], 7)
    assert sorted(name for name, _ in keys(["L3", "L5"], 7)) == ["choose", "set", "wide"]
    assert len({tuple(keys(["L3", "L5"], number)) for number in range(1, 30)}) == 29
    assert keys(["L4"], 1) == [] and {name for name, _ in keys(["L5"], 1)} == {"choose"}
    (item,) = draw_test(["L5"], 3)
    assert [found.key[1] for found in exercises_of(item.placed.course)] == ["practise/choose"]


@pytest.fixture
def with_test(window: MainWindow) -> MainWindow:
    """Return a window whose card shows test 4 of both topics."""
    activate(window)
    window.practice.begin_test(["L3", "L5"], 4)
    window.side.setSizes([0, 1000])
    come_to_rest(window)
    return window


def answer(window: MainWindow) -> tuple[str, str]:
    """Answer the exercise on the card, "wide" wrongly; return its name and what was typed."""
    (view,) = window.lesson_card.page.blocks
    if view.played.block.name == "wide":
        here, question = view.played.variant.here, view.played.variant.question
        typed = f"{question.values(here, question.replies[0].formulas, 1)[0]:.4g}"
        keyboard().selectAll()
        QTest.keyClicks(keyboard(), typed)
    elif view.played.block.name == "choose":
        typed = "2"
        press(KEY.Key_Down)
    else:
        wanted = float(view.played.variant.numbers["wanted"])
        enter(window.controls.rows["near"].field, str(wanted))
        come_to_rest(window)
        typed = f"lens.near={wanted:g}"
        assert view.played.is_open, "nothing says that it is right"
        buttons(window.lesson_card)["Hand it in"].setFocus()
    press(KEY.Key_Return)
    settle()
    return view.played.block.name, typed


def test_the_keyboard_begins_at_the_first_topic(window: MainWindow) -> None:
    dialog = SelfTestDialog({"L1": ("One", 3), "L2": ("Two", 1)}, 1, window)
    dialog.show()
    activate(dialog)
    focus = QApplication.focusWidget()
    assert isinstance(focus, QCheckBox) and focus.text() == "L1 One"
    dialog.close()


def test_a_test_is_chosen_by_keyboard_alone(window: MainWindow) -> None:
    def choose() -> None:
        dialog = next(w for w in QApplication.topLevelWidgets() if isinstance(w, SelfTestDialog))
        assert not dialog.begin.isEnabled()
        for box in dialog.findChildren(QCheckBox):
            QTest.keyClick(box, KEY.Key_Space)
        assert dialog.topics == ["L3", "L5"]
        enter(dialog.number, "4")
        if dialog.isVisible():
            QTest.keyClick(dialog.begin, KEY.Key_Return)

    activate(window)
    window.panels.open(window.matrices)
    QTimer.singleShot(0, choose)
    window.menus.lesson_menu.test.trigger()
    come_to_rest(window)
    assert window.lessons.lesson.title == "Test 4: all topics"
    assert len(window.lessons.lesson.steps) == 3 and window.panels.open_panel is None


def test_a_test_helps_with_nothing_and_says_nothing_of_right_and_wrong(
    with_test: MainWindow,
) -> None:
    card, menus = with_test.lesson_card, with_test.menus.lesson_menu
    assert not card.hint.isVisible() and not card.anew.isVisible()
    assert not menus.hint.isEnabled() and not menus.anew.isEnabled()
    for place in range(3):
        (view,) = card.page.blocks
        assert "Angles go from bottom to top." in texts(card), "what the step says before it"
        assert with_test.store.document == view.played.variant.here.document
        assert not view.played.hints and view.seed.isHidden() is False and not view.seed.isVisible()
        assert place or view.visibleRegion().boundingRect() == view.rect(), "it makes room"
        if view.played.block.name == "wide":
            assert isinstance(keyboard(), QLineEdit)
            QTest.keyClicks(keyboard(), "what")
            press(KEY.Key_Return)
            assert "cannot be read" in texts(card) or "neither" in texts(card)
        elif view.played.block.name == "choose":
            assert isinstance(keyboard(), QRadioButton)
        else:
            buttons(card)["Hand it in"].click()
            settle()
            assert "Nothing is changed yet." in texts(card)
        answer(with_test)
        assert not view.played.is_open and "Your answer is kept until the end." in texts(card)
        assert not any(sign.icon == "check" for sign in card.findChildren(Sign)), "it may be wrong"
        assert "✓" not in "".join(mark.text() for mark in card.findChildren(QToolButton))
        assert "Right" not in texts(card) and "idea" not in texts(card)
        assert "Show the answer" not in buttons(card)
        assert keyboard() is card.next
        if place < 2:
            press(KEY.Key_Return)
            come_to_rest(with_test)


def test_a_test_that_is_left_is_gone_on_with(with_test: MainWindow) -> None:
    card = with_test.lesson_card
    answer(with_test)
    card.leave()
    assert with_test.messages.text == "The test is kept." and with_test.panels.open_panel is None
    (go_on,) = with_test.messages.choices
    go_on.click()
    come_to_rest(with_test)
    (view,) = card.page.blocks
    assert not view.played.is_open and "Your answer is kept" in texts(card)
    assert with_test.lessons.place == 0 and keyboard() is card.next


def test_an_answer_that_cannot_be_recorded_is_said_so(with_test: MainWindow) -> None:
    (data_folder() / RECORD).mkdir(parents=True)
    answer(with_test)
    settle()
    said = texts(with_test.lesson_card)
    assert "Your answer is kept" in said and f"{RECORD} cannot be written" in said


def test_a_test_that_is_handed_in_shows_its_marks_and_saves_them(
    with_test: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    card = with_test.lesson_card
    given = dict([answer(with_test)])
    for place in (1, 2):
        press(KEY.Key_Return)
        come_to_rest(with_test)
        if place == 2:
            press(KEY.Key_N, ALT)
            assert "Not answered yet: 3." in texts(card)
            buttons(card)["Back to exercise 3"].click()
            come_to_rest(with_test)
        given |= [answer(with_test)]
    press(KEY.Key_Return)
    come_to_rest(with_test)
    said = texts(card)
    assert "2 of 3 right" in said and with_test.lessons.lesson is None
    assert keyboard().visibleRegion().boundingRect() == keyboard().rect(), (
        "what to do is above the fold"
    )
    assert f"Your answer: {given['wide']}" in said and "The tangent grows faster." in said
    assert "Your answer: no" in said and given["set"] in said
    assert "The idea behind it" in said
    assert not with_test.practice.begun and with_test.panels.open_panel is None
    attempts = {each.exercise.partition("/")[2]: each for each in with_test.record.read()}
    assert {name: each.typed for name, each in attempts.items()} == given
    assert attempts["wide"].idea == "angle-linear" and attempts["set"].verdict == "right"
    assert {(each.hints, each.is_test) for each in attempts.values()} == {(0, True)}
    outcomes = {key[1]: each.outcome for key, each in standings(attempts.values()).items()}
    assert outcomes["practise/choose"] == outcomes["practise/set"] == "alone"
    out = tmp_path / "mine.json"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(out), ""))
    monkeypatch.setattr(QInputDialog, "getText", lambda *_: (500 * "A", True))
    press(KEY.Key_Return)
    assert "student must be one line of at most 100" in with_test.messages.text
    assert not out.exists(), "no name is cut"
    monkeypatch.setattr(QInputDialog, "getText", lambda *_: ("  Ana\tB\n", True))
    press(KEY.Key_Return)
    assert with_test.messages.text == f"The result is in {out}."
    result = read(out)
    assert result.student == "Ana B" and len(result.attempts) == 3
    assert {each.exercise.partition("/")[2]: each.typed for each in result.attempts} == given
    press(KEY.Key_Tab)
    press(KEY.Key_Return)
    assert not card.is_on


def test_what_was_not_solved_alone_comes_back_with_new_numbers(window: MainWindow) -> None:
    activate(window)
    menu, record = window.menus.lesson_menu, window.record
    menu.aboutToShow.emit()
    assert menu.review.text() == "&Review" and not menu.test_again.isVisible()
    menu.review.trigger()
    assert window.messages.text.endswith("What you do not solve alone comes back in a day.")
    assert not window.messages.findChild(WarningLabel).is_warning, "all is well"
    for exercise, verdict in (("choose", "wrong"), ("wide", "right"), ("gone", "shown")):
        lesson = practice.topics()["L3" if exercise == "wide" else "L5"].name
        record.add(Attempt(1_700_000_000, lesson, f"practise/{exercise}", 1, "1", verdict))
    menu.aboutToShow.emit()
    assert menu.review.text() == "&Review: 1 exercise, about 2 minutes"
    assert of_start_card(window) == ["&Review: 1 exercise, about 2 minutes"]
    menu.review.trigger()
    come_to_rest(window)
    (view,) = window.lesson_card.page.blocks
    assert view.played.block.name == "choose" and view.played.seed == 2 and view.seed.isVisible()
    press(KEY.Key_Down)
    press(KEY.Key_Return)
    assert "Right." in texts(window.lesson_card)
    menu.aboutToShow.emit()
    assert menu.review.text() == "&Review" and record.read()[-1].seed == 2
    window.lesson_card.go_on()
    settle()
    assert "Done: “Review”." in texts(window.lesson_card)
    assert not any("Review" in name for name in window.settings.progress)
    window.lesson_card.leave()
    in_3_days = QLocale().toString(QDate.currentDate().addDays(3))
    assert of_start_card(window) == [f"The next review is on {in_3_days}."]
    menu.review.trigger()
    said = f"Nothing has come back today. The next review is on {in_3_days}."
    assert window.messages.text == said
    lesson = practice.topics()["L3"].name
    record.add(Attempt(int(time.time()), lesson, "practise/set", 1, "1", "wrong"))
    assert of_start_card(window) == ["The next review is tomorrow."]


def of_start_card(window: MainWindow) -> list[str]:
    """Return what the start card says of reviews."""
    window.menus.start_card.trigger()
    settle()
    card = window.cover
    assert card is not None and cut(card) == []
    said = [each.text() for kind in (QToolButton, QLabel) for each in card.findChildren(kind)]
    card.close()
    return [text for text in said if "eview" in text]


def test_a_review_mixes_the_topics_and_says_how_long_it_takes() -> None:
    lessons = {name: course.name for name, course in practice.topics().items()}
    begin = 1_700_000_000
    said = [
        Attempt(begin + 60 * n, lessons[lesson], f"practise/{name}", n + 1, "1", "wrong")
        for n, (lesson, name) in enumerate((("L3", "wide"), ("L3", "set"), ("L5", "choose")))
    ]
    said += [each._replace(when=begin + 1000 + 50 * n, seed=9) for n, each in enumerate(said * 2)]
    found = find_waiting(said)
    assert [each.exercise.name for each in found.due] == ["set", "wide", "choose"]
    assert (found.minutes, found.following) == (3, None)
    mixed = to_review(found.due, standings(said))
    assert [item.placed.exercise.name for item in mixed] == ["set", "choose", "wide"]
    assert all(item.variant.seed not in (1, 2, 3, 9) for item in mixed)
    assert review_text(found) == "&Review: 3 exercises, about 3 minutes"
    short = found._replace(minutes=1, due=found.due * 7)
    assert review_text(short) == "&Review: 12 of 21 exercises, about 1 minute"
    day = date.fromtimestamp(begin)
    assert find_waiting(said, day) == ((), 1, day + timedelta(days=1))


def test_the_overview_shows_every_topic_and_leads_there(window: MainWindow, tmp_path: Path) -> None:
    activate(window)
    for exercise, verdict, idea in (
        ("set", "shown", ""), ("wide", "wrong", "angle-linear"), ("wide", "right", ""),
    ):  # fmt: skip
        lesson = practice.topics()["L3"].name
        window.record.add(
            Attempt(1_700_000_000, lesson, f"practise/{exercise}", 1, "1", verdict, idea)
        )
    own = tmp_path / "own.md"
    with_idea = "wrong seven: 7\n  title: All are seven.\n  says: They are not.\nhint: Take"
    text = practice.topics()["L3"].lesson.path.read_text(encoding="utf-8")
    own.write_text(text.replace("hint: Take", with_idea), encoding="utf-8")
    for idea in ("my-idea", "seven"):
        window.record.add(Attempt(1_700_000_000, str(own), "practise/wide", 1, "1", "wrong", idea))
    with (data_folder() / RECORD).open("a") as file:
        file.write("\n{")
    window.menus.lesson_menu.overview.trigger()
    settle()
    overview = window.practice.overview
    said = texts(overview)
    assert "unreadable lines (1)" in said and "once; then: solved with help" in said
    assert "“my idea” once; then: not yet" in said, "of a lesson of one's own"
    assert "“All are seven” once" in said, "as the lesson calls the idea"
    names = [each.accessibleName() for each in overview.findChildren(QToolButton)]
    assert [name.partition(". ")[0] for name in names if name] == [
        "L3, exercise 1: solved with help", "L3, exercise 2: answer shown",
        "L5, exercise 1: not yet", "own, exercise 1: not yet", "own, exercise 2: not yet",
    ]  # fmt: skip
    activate(overview)
    assert (
        overview.review.text() == "&Review: 3 exercises, about 6 minutes"
        and keyboard() is overview.review
    )
    for _ in range(30):
        press(KEY.Key_Tab)
        if "exercise 2" in keyboard().accessibleName():
            break
    press(KEY.Key_Space)
    assert window.lessons.player is not None and window.lessons.player.step.name == "practise"
    assert not any(
        isinstance(w, Overview) and w.isVisible() for w in QApplication.topLevelWidgets()
    )
