"""The window in each language: what it says, what fits, and how it changes the language."""

import re
from collections.abc import Iterator
from datetime import date, timedelta
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication, QMenu, QMenuBar, QRadioButton

from app import languages
from app.document.document import Document
from app.document.settings import set_values
from app.lecture.equation import equation_of
from app.lecture.equation_form import laid_out
from app.lecture.titles import stage_title
from app.lessons import marking
from app.lessons.contents import contained
from app.lessons.practice import Waiting, exercises_of, topics
from app.lessons.record import Attempt
from app.model.projection import Perspective
from app.model.refusal import REFUSALS, Refusal
from app.scenes.scene import BUILT_IN
from tests.support.layout import cut, overlapping
from tests.support.window import MakeWindow, settle, show_scene
from tests.widgets.test_lesson_card import texts
from widgets.parts.messages import TranslatedWords, sentence
from widgets.parts.translator import Translator
from widgets.window.main_window import MainWindow
from widgets.window.practice import next_review
from widgets.window.settings import data_folder

OTHERS = [each for each in languages.LANGUAGES if each != languages.ENGLISH]
LESSON = """---
title: Kut
language: {0}
---
# Prvi korak {{#first}}
Koliki je kut?

```answer angle
Koliki je?
value: fov
wrong angle-linear: 2*fov
```
"""

VOTE = """---
title: Vote
---
# Vote {#vote}
```predict straight
What comes of it?
- [ ] A line
  says: It is bent.
- [x] An arc
```
"""


@pytest.fixture
def speak(qapp: QApplication) -> Iterator[Any]:
    translator = Translator(qapp)
    qapp.installTranslator(translator)
    yield languages.choose
    languages.choose(languages.ENGLISH)
    languages.follow_lesson("")
    qapp.removeTranslator(translator)


def wrong(window: MainWindow) -> list[str]:
    settle()
    return [*cut(window), *overlapping(window)]


@pytest.mark.undrawn
@pytest.mark.parametrize("number, language", list(enumerate(OTHERS)))
def test_nothing_is_cut(number: int, language: str, speak: Any, make_window: MakeWindow) -> None:
    """Each language has an eighth of the scenes, and a lesson or two."""
    speak(language)
    window = make_window()
    window.resize(1366, 768)
    found = {}
    for name in BUILT_IN[number :: 2 * len(OTHERS)]:
        window.guide.choose(name)
        found[name] = wrong(window)
    for panel in window.panels.all:
        window.panels.open(panel)
        found[type(panel).__name__] = wrong(window)
    window.panels.open(None)
    window.show_start_card()
    settle()
    assert window.cover is not None
    found["start card"] = [*cut(window.cover), *overlapping(window.cover)]
    window.cover.close()
    for path in contained()[number :: 6 * len(OTHERS)]:
        window.lesson_card.open(path)
        for place, _ in enumerate(window.lessons.lesson.steps if window.lessons.lesson else ()):
            window.lesson_card.go_to(place)
            found[f"{path.stem} {place}"] = wrong(window)
    assert not any(found.values()), {name: each for name, each in found.items() if each}


def letters(menu: QMenu | QMenuBar) -> Iterator[list[str]]:
    """Yield the letters for Alt of an open menu, then those of each menu below it."""
    if isinstance(menu, QMenu):
        menu.aboutToShow.emit()
    texts = [action.text().lower() for action in menu.actions()]
    yield [letter for text in texts for letter in re.findall("&([^&])", text)]
    for action in menu.actions():
        below = action.menu()
        if isinstance(below, QMenu):
            yield from letters(below)


@pytest.mark.undrawn
@pytest.mark.parametrize("language", OTHERS)
def test_no_two_items_of_a_menu_share_a_letter(
    language: str, speak: Any, make_window: MakeWindow
) -> None:
    speak(language)
    of_menus = list(letters(make_window().menuBar()))
    assert len(of_menus) > 5 and all(len(each) == len(set(each)) for each in of_menus), of_menus


@pytest.mark.undrawn
def test_numbers_beside_words_have_a_comma(speak: Any, make_window: MakeWindow) -> None:
    speak("hr")
    window = make_window()
    window.panels.open(window.frame_panel)
    assert "0,1°" in window.frame_panel.nudge.text()
    window.panels.open(window.measure_panel)
    settle()
    status = window.status
    assert re.search(r"±0,\d+ px", status.precision.text())
    status.precision.menu().aboutToShow.emit()
    lines = [action.text() for action in status.precision.menu().actions()]
    assert any(re.search(r"\d,\d", line) for line in lines)
    assert not any(re.search(r"\d\.\d", line) for line in lines)
    status.show_cost(1.25, {"Svijet": (0.5, 2.5)})
    assert re.search(r"\d,\d", status.cost.toolTip())
    assert "." not in re.sub(r"\.(?!\d)", "", status.cost.toolTip())


@pytest.mark.parametrize("language", ["en", "hr", "sr", "sr-Latn", "et"])
def test_the_sentence_of_the_next_review_ends_in_one_full_stop(language: str, speak: Any) -> None:
    """Croatian and Serbian dates end in one themselves."""
    speak(language)
    before, later = QLocale(), date.today() + timedelta(days=3)
    QLocale.setDefault(QLocale(language))
    try:
        said = next_review(Waiting((), 1, later))
    finally:
        QLocale.setDefault(before)
    assert str(later.year) in said and re.search(r"[^.]\.$", said)


@pytest.mark.parametrize("language", ["hr", "sr", "et"])
def test_examples_of_numbers_have_one_sign_between_them(language: str, speak: Any) -> None:
    speak(language)
    with pytest.raises(Refusal) as refusal:
        marking.read("1,5,5")
    assert "0,5; 1/2; √3/2" in sentence(refusal.value)


@pytest.mark.undrawn
@pytest.mark.parametrize(
    ("language", "marks"),
    [("en", "“”"), ("hr", "„”"), ("sr", "„”"), ("sr-Latn", "„”"), ("et", "„“")],
)
def test_a_language_has_its_own_quotation_marks(
    language: str, marks: str, speak: Any, make_window: MakeWindow, tmp_path: Path
) -> None:
    speak(language)
    opened, closed = marks
    with pytest.raises(Refusal) as refusal:
        marking.read("abc")
    assert f"{opened}abc{closed}" in sentence(refusal.value)
    file = tmp_path / "vote.md"
    file.write_text(VOTE, "utf-8")
    window = make_window()
    window.lesson_card.open(file)
    settle()
    (view,) = window.lesson_card.page.blocks
    view.findChildren(QRadioButton)[0].click()
    view.commit()
    settle()
    said = texts(window.lesson_card)
    assert f"{opened}A line{closed}" in said and f"{opened}An arc{closed}" in said


def test_an_equation_has_a_comma(speak: Any) -> None:
    speak("hr")
    document = set_values(Document(), ["object.rotate_deg=0,0,30"])
    equation = equation_of(document.projection, "own", "object numbers")
    cells = {cell for matrix in laid_out(equation) for row in matrix.cells for cell in row}
    assert {"0,866", "−0,5", "0,5"} <= cells


@pytest.mark.undrawn
def test_another_language_keeps_the_work(speak: Any, make_window: MakeWindow) -> None:
    speak("en")
    window = make_window()
    window.store.set_document(set_values(window.store.document, ["lens.near=4"]))
    window.choose_language("hr")
    work = window.work_left
    assert work is not None and window.isHidden() and window.settings.language == "hr"
    assert work.document.projection.lens.near == 4.0
    assert work.store is not None and work.saved == Document()
    speak("hr")
    second = make_window(work.document)
    second.go_on(work)
    assert second.menus.undo.text().replace("&", "") == "Poništi"
    assert second.controls.rows["far"].field.text() == "12,5"
    second.store.undo()
    assert second.store.document.projection.lens.near == 5.0
    assert second.controls.rows["near"].field.text() == "5"


def in_another_language(window: MainWindow, make_window: MakeWindow) -> MainWindow:
    window.choose_language("hr")
    work = window.work_left
    assert work is not None
    second = make_window(work.document, shown=False)
    second.go_on(work)
    second.show()
    settle()
    return second


@pytest.mark.undrawn
@pytest.mark.parametrize("in_a_lesson", [False, True])
def test_another_language_keeps_what_is_compared(
    speak: Any, make_window: MakeWindow, in_a_lesson: bool
) -> None:
    window = make_window()
    if in_a_lesson:
        window.lesson_card.open(contained()[3])
    window.comparing.toggle()
    near = window.store.document.projection.lens.near
    window.store.set_document(set_values(window.store.seen, [f"lens.near={near / 2}"]))
    settle()
    second = in_another_language(window, make_window)
    pictures = second.comparing.pictures.pictures
    assert [each.live for each in pictures] == [False, True] and pictures[0].held is not None
    assert pictures[0].held.projection.lens.near == near
    assert second.store.document.projection.lens.near == near / 2
    assert second.menus.compare.isChecked()


@pytest.mark.undrawn
@pytest.mark.parametrize("is_test", [True, False])
def test_another_language_goes_on_with_a_test_or_a_review(
    is_test: bool, speak: Any, make_window: MakeWindow
) -> None:
    window = make_window()
    if is_test:
        window.practice.begin_test(["L3"], 4)
        window.lesson_card.go_to(1)
    else:
        lesson, exercise = next(exercises_of(topics()["L3"])).key
        window.record.add(Attempt(1_700_000_000, lesson, exercise, 1, "1", "wrong"))
        window.practice.review()
    before = window.lessons.player
    assert before is not None and before.sheet is not None
    window.choose_language("hr")
    assert window.work_left is not None
    speak("hr")
    second = make_window(window.work_left.document)
    second.go_on(window.work_left)
    player = second.lessons.player
    assert player is not None and player.sheet is not None and not second.messages.text
    assert (player.is_test, player.place) == (is_test, before.place)
    assert player.lesson.title == ("Test 4: L3" if is_test else "Ponavljanje")
    for now, then in zip(player.sheet.items, before.sheet.items, strict=True):
        assert now.variant.seed == then.variant.seed
        assert now.variant.question.text != then.variant.question.text


@pytest.mark.undrawn
def test_another_language_offers_no_work_that_is_still_there(
    speak: Any, make_window: MakeWindow
) -> None:
    window = make_window()
    window.store.set_document(set_values(window.store.document, ["lens.near=4"]))
    window.lesson_card.open(contained()[3])
    assert len(list(data_folder().glob("autosave-*.json"))) == 1
    second = in_another_language(window, make_window)
    assert not second.messages.text
    assert len(list(data_folder().glob("autosave-*.json"))) == 1  # if this one dies
    second.lesson_card.leave()
    while second.store.document.projection.lens.near != 4.0:
        assert second.store.can_undo
        second.store.undo()
    assert second.store.modified


@pytest.mark.undrawn
def test_the_language_of_a_lesson_rules_its_card(
    speak: Any, make_window: MakeWindow, tmp_path: Path
) -> None:
    speak("en")
    window = make_window()
    card, menu = window.lesson_card, window.menus.undo.text()
    file = tmp_path / "kut.md"
    for language, back, check, letters in (
        ("et", "Tagasi", "Kontrolli", "002"), ("hr", "Natrag", "Provjeri", "004"),
        ("en", "Back", "Check", None),
    ):  # fmt: skip
        file.write_text(LESSON.format(language), encoding="utf-8")
        assert card.open(file)
        settle()
        assert card.back.text().replace("&", "") == back
        assert window.lessons.lesson is not None and window.lessons.lesson.letters == letters
        texts = [
            button.text().replace("&", "") for button in card.page.findChildren(type(card.back))
        ]
        assert check in texts
        assert window.menus.undo.text() == menu
    card.leave()
    assert languages.of_lessons() == "en"


@pytest.mark.undrawn
def test_sentences_titles_and_a_scenes_card_are_in_the_language(
    speak: Any, make_window: MakeWindow
) -> None:
    speak("hr")
    with pytest.raises(Refusal) as caught:
        Perspective(45.0, 3.0, 2.5)
    assert sentence(caught.value) == (
        "Bliska ravnina = 3: mora biti manje od udaljenosti daleke ravnine, koja je 2,5."
    )
    with pytest.raises(Refusal) as caught:
        marking.read(" ")
    assert sentence(caught.value).startswith("Odgovor mora biti broj; ")
    empty = Refusal.saying(REFUSALS["mesh-empty"], "{1}.obj")
    assert sentence(empty).startswith("{1}.obj: datoteka je prazna")
    assert sentence(OSError("no space")) == "no space"
    titles = [stage_title(name) for name in ("clip_from_view", "rotation", "M_pp")]
    assert titles == ["odsijecanje ← kamera", "rotacija", "M_pp"]
    card = show_scene(make_window(), "planar-shadow").controls.card
    assert card.tries.text().startswith("Povucite svjetiljku") and card.rows["light"].name == (
        "Svjetlo L"
    )
    assert [line[0].text() for line in card.readout.lines[1:3]] == [
        "vrh P",
        "njezina sjena S·P / w",
    ]
    words = TranslatedWords({"near": "blizu"})
    assert (words["near"], words["light"], words.get("light", "")) == ("blizu", *["svjetlo"] * 2)
