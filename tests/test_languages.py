"""The language of the program: which one, its texts, plural forms, letters and numbers."""

import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest

from app import api, languages
from app.document.document import Document
from app.drawings import DrawingWords
from app.drawings.label import SceneLabel
from app.drawings.style import LIGHT
from app.lecture.typesetting import outline
from app.lessons.contents import contained
from app.lessons.course import ideas
from app.lessons.lesson import head_of, read
from app.lessons.practice import exercises_of, topics
from app.lessons.text import html_of, spoken_tex
from app.lessons.translating import in_language
from app.measure.meaning import meaning
from app.measure.single import shipped
from app.model.refusal import REFUSALS, Refusal


def forget() -> None:
    languages.texts.cache_clear()
    languages.forms_of.cache_clear()


@pytest.fixture(autouse=True)
def _in_english_again() -> Iterator[None]:
    yield
    languages.choose("en")


@pytest.mark.parametrize(
    ("environment", "language"),
    [
        ({}, "en"),
        ({"LANG": "hr_HR.UTF-8"}, "hr"),
        ({"LANG": "en_US.UTF-8", "LC_MESSAGES": "et_EE"}, "et"),
        ({"LANG": "et_EE", "LC_ALL": "C.UTF-8"}, "en"),
        ({"LANG": "sr_RS.UTF-8@latin"}, "sr-Latn"),
        ({"LANG": "sr_RS"}, "sr"),
        ({"LANG": "de_DE", "LANGUAGE": "nl:hr"}, "hr"),
        ({"LANG": "C", "LANGUAGE": "hr"}, "en"),
        ({"LANG": "fi_FI"}, "en"),
    ],
)
def test_the_language_of_the_system(environment: dict[str, str], language: str) -> None:
    assert languages.of_system(environment) == language


def test_serbian_in_latin_letters() -> None:
    assert languages.in_latin("Његош воли џез; ЊЕГОШ, Љ и w, NDC") == (
        "Njegoš voli džez; NJEGOŠ, Lj i w, NDC"
    )


@pytest.mark.parametrize(
    ("language", "count", "form"),
    [("hr", 1, 0), ("hr", 2, 1), ("hr", 5, 2), ("hr", 11, 2), ("hr", 12, 2), ("hr", 21, 0),
     ("hr", 22, 1), ("sr", 112, 2), ("et", 1, 0), ("et", 0, 1), ("et", 21, 1)],
)  # fmt: skip
def test_plural_forms(language: str, count: int, form: int) -> None:
    assert languages.plural(language, count) == form


@pytest.mark.parametrize(
    ("english", "other"),
    [
        ("1.5 and 2.5.", "1,5 and 2,5."), ("(0.5, 1, 2)", "(0,5; 1; 2)"),
        ("(3, 1, 0)", "(3, 1, 0)"), ("3, and 0.5", "3, and 0,5"), ("1.2.3", "1.2.3"),
        ("-0.25, 3", "-0,25; 3"), ("house.obj", "house.obj"),
    ],
)  # fmt: skip
def test_numbers_have_a_comma(english: str, other: str) -> None:
    assert languages.with_comma(english) == english
    languages.choose("hr")
    assert languages.with_comma(english) == other


@pytest.mark.parametrize(
    ("english", "other"),
    [
        ("T_0 = (5, 4.5, 8)", "T_0 = (5; 4{,}5; 8)"), (r"(1.5,\ -2,\ x)", r"(1{,}5; \ -2; \ x)"),
        (r"\left[-0.5,1\right]", r"\left[-0{,}5; 1\right]"), ("(3, 1, 0)", "(3, 1, 0)"),
        (r"(1\,000, 2)\,0.5", r"(1\,000, 2)\,0{,}5"),
        ("x = 0.5, y = (z, 1)", "x = 0{,}5, y = (z, 1)"),
        (r"(1\,000.5, 2)", r"(1\,000{,}5; 2)"),
    ],
)  # fmt: skip
def test_a_point_with_commas_in_its_numbers_has_semicolons_in_a_formula(
    english: str, other: str
) -> None:
    assert html_of(f"${english}$")[1] == (english,)
    languages.choose("hr")
    assert html_of(f"${english}$")[1] == (other,)
    outline(other)


def test_a_lesson_s_language_has_its_commas_in_an_english_window() -> None:
    forget()
    languages.follow_lesson("hr")
    try:
        said = languages.translate("A number: 0.5, 1 1/2, √3/2 or 2e-3; arrow keys change the cell"
                                   " (Enter)", "MatrixAnswerView")  # fmt: skip
    finally:
        languages.follow_lesson("")
    assert "0,5" in said


def test_a_spoken_number_has_the_programs_comma_beside_a_lesson_with_its_own_language() -> None:
    languages.follow_lesson("hr")
    try:
        english = spoken_tex("0.5")
        languages.choose("et")
        estonian = spoken_tex("0.5")
    finally:
        languages.follow_lesson("")
    assert (english, estonian) == ("0.5", "0,5")


@pytest.mark.parametrize("part", ["program", "lessons"])
@pytest.mark.parametrize("language", ["hr", "sr", "et"])
def test_the_texts_are_those_that_an_xml_parser_reads(part: str, language: str) -> None:
    count = 0
    for context in ElementTree.parse(languages.TRANSLATIONS / f"{part}_{language}.ts").getroot():
        for message in context.iter("message"):
            text, translation = message.findtext("source", ""), message.find("translation")
            assert translation is not None
            forms = tuple(form.text for form in translation) or (translation.text,)
            read = languages.forms_of(part, language, context.findtext("name", ""), text)
            assert read == forms or "," in "".join(read), text
            count += 1
    assert count == len(languages.texts(part, language)) > 1000


def test_what_a_translator_has_left_open_stays_english(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    messages = """<context><name>A &amp; B</name>
    <message><source>&lt;one&gt;</source><comment>of two</comment>
    <translation>&quot;jedan&quot;</translation></message>
    <message><source>new</source><translation type="unfinished" /></message>
    <message><source>gone</source><translation type="vanished">prošlo</translation></message>
    <message numerus="yes"><source>%n steps</source><translation>
    <numerusform>%n korak</numerusform><numerusform></numerusform></translation></message>
    </context><context><name>Options</name></context></TS>"""
    (tmp_path / "program_hr.ts").write_text(messages, encoding="utf-8")
    monkeypatch.setattr(languages, "TRANSLATIONS", tmp_path)
    forget()
    languages.choose("hr")
    try:
        assert languages.translate("<one>", "A & B") == '"jedan"'
        for text in ("new", "gone", "%n steps", "<two>"):
            assert languages.translate(text, "A & B", 1) == text
        assert languages.translate("new", "Options") == "new"
    finally:
        forget()


def test_a_broken_file_is_named_and_the_texts_stay_english(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    (tmp_path / "program_hr.ts").write_text("<TS><context><name>Field", encoding="utf-8")
    monkeypatch.setattr(languages, "TRANSLATIONS", tmp_path)
    forget()
    languages.choose("hr")
    try:
        assert languages.translate("Near", "Field") == "Near"
        assert languages.sentence_of("l03-field-of-view", "A text") == "A text"
    finally:
        forget()
    assert [("program_hr.ts" in each, "lessons_hr.ts" in each) for each in caplog.messages] == [
        (True, False), (False, True),
    ]  # fmt: skip


def test_only_the_sentences_of_a_lesson_change() -> None:
    for path in contained():
        text = path.read_text("utf-8")
        same = in_language(text, str)
        assert " ".join(same.split()) == " ".join(text.split()), path
        assert same.count("\n") == text.count("\n")
        other = in_language(text, lambda sentence: f"{sentence} x")
        assert other.count("\n") == text.count("\n"), path


def test_a_lesson_is_the_same_in_every_language() -> None:
    paths = contained()
    english = [read(path) for path in paths]
    for language in languages.LANGUAGES:
        languages.choose(language)
        for path, before in zip(paths, english, strict=True):
            lesson = read(path)
            assert head_of(path).title == lesson.title
            for one, other in zip(before.steps, lesson.steps, strict=True):
                assert (one.name, one.samples) == (other.name, other.samples)
                assert [type(part) for part in one.parts] == [type(part) for part in other.parts]
        assert len(ideas().lesson.steps) > 30


def test_a_figure_has_the_words_and_the_numbers_of_the_language() -> None:
    near = replace(Document().projection.lens, near=4.5)
    document = replace(Document(), projection=replace(Document().projection, lens=near))
    languages.choose("hr")
    drawn = api.figure(document, panes="world", size=(640, 640)).svg()
    assert "bliska" in drawn and "4,5" in drawn and "4.5<" not in drawn


def test_the_marks_of_a_scene_are_in_the_language() -> None:
    languages.choose("hr")
    assert DrawingWords()["smooth path"] == "glatki put"
    label = SceneLabel("1.5", LIGHT)
    before = label.text
    label.set_text("2.5")
    assert (before, label.text) == ("1,5", "2,5")


def test_what_a_measurement_means_has_its_units_in_the_language() -> None:
    languages.choose("hr")
    trades = [trade for each in shipped().values() for trade in each.trades]
    for trade in trades:
        said = meaning(trade)
        assert trade.error_unit in ("px", "w") or trade.error_unit not in said, said
    assert any("teksela" in meaning(trade) for trade in trades)


def test_a_refusal_speaks_the_language() -> None:
    error = Refusal("near", 0.0, REFUSALS["at-least"], 1)
    before = str(error)
    languages.choose("hr")
    assert str(error) != before and str(error).startswith("near = 0: ")


def test_a_command_speaks_the_language_asked_for() -> None:
    def said(*arguments: str) -> str:
        command = [sys.executable, "-m", "app", *arguments]
        done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8")
        return done.stdout + done.stderr

    assert "the lens" not in said("matrices", "--help", "--language", "hr")
    assert "--language = 'xx': must be one of en, hr, sr, sr-Latn, et." in said(
        "matrices", "--language=xx"
    )
    refused = said("matrices", "--set", "lens.near=-1", "--language", "et")
    assert refused.startswith("lens.near = -1: ") and "must be" not in refused


BEHIND_MANY = "krugova|bitova|stabala|metara|stupnjeva|redaka"
BEHIND_FEW, BEHIND_ONE = f"{BEHIND_MANY}|jedinica", f"{BEHIND_MANY}|radijana|piksela"
"""Forms of nouns that are wrong behind 2, 3 or 4, or behind 1 and 21, in Croatian and Serbian."""


@pytest.mark.parametrize("language", ["hr", "sr-Latn"])
def test_no_noun_behind_a_drawn_number_has_the_form_behind_another_one(language: str) -> None:
    languages.choose(language)
    few = rf"(?<![\d.,])\d*(?<!1)[2-4]\$? (?:{BEHIND_FEW})\b"
    one = rf"(?<![\d.,])\d*(?<!1)1\$? (?:{BEHIND_ONE})\b"
    wrong = set()
    for course in topics().values():
        for exercise in exercises_of(course):
            for seed in range(1, 9):
                with suppress(Refusal):
                    *_, question, here = exercise.with_numbers(seed)
                    replies = [reply.verdict(here).says for reply in question.replies]
                    text = " ".join((question.text, *question.hints, question.why, *replies))
                    wrong.update(re.findall(rf"{few}|{one}", text))
    assert not wrong
