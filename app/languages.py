"""The languages of the program: which one it speaks, and its texts in it.

The English text is the key. Qt Linguist's files ``translations/*.ts`` have the others and are read
as they are, without a compiled form: what a translator saves is there at the next start.
``program_hr.ts`` has the texts of window and commands, ``lessons_hr.ts`` those of lessons and
talks, which are read when a lesson opens. ``docs/glossary.md`` has the terms.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from functools import cache, lru_cache, wraps
from pathlib import Path
from typing import Any, ParamSpec, TypeAlias, TypeVar

_T = TypeVar("_T")
_P = ParamSpec("_P")
Forms: TypeAlias = tuple[str, ...]
"""A text in another language; its plural forms if it has a number."""

ENGLISH = "en"
LANGUAGES = {
    ENGLISH: "English", "hr": "Hrvatski", "sr": "Српски", "sr-Latn": "Srpski (latinica)",
    "et": "Eesti",
}  # fmt: skip
"""What each language is called in itself, by its code in BCP 47."""
OF_LESSONS = frozenset(
    ("LessonCard", "StepMarks", "BlockView", "ChoiceView", "TaskView", "ClickView", "ExerciseView",
     "MarkedAnswerView", "NumberAnswerView", "MatrixAnswerView", "OrderView", "Exam", "Spoken")
)  # fmt: skip
"""The contexts of a lesson's card, and of a test on paper."""
_QUOTES = {"hr": "„{}”", "sr": "„{}”", "sr-Latn": "„{}”", "et": "„{}“"}
LETTERS = {"hr": "004", "sr": "003", "sr-Latn": "003", "et": "002"}
"""The lecture whose letters a lesson in a language has, if it asks for no others."""
TRANSLATIONS = Path(__file__).with_name("translations")

_LATIN = str.maketrans(
    dict(zip("абвгдђежзијклмнопрстћуфхцчшАБВГДЂЕЖЗИЈКЛМНОПРСТЋУФХЦЧШ",
             "abvgdđežzijklmnoprstćufhcčšABVGDĐEŽZIJKLMNOPRSTĆUFHCČŠ", strict=True))
    | {"љ": "lj", "њ": "nj", "џ": "dž", "Љ": "Lj", "Њ": "Nj", "Џ": "Dž"}
)  # fmt: skip
_MESSAGE = re.compile(
    "<name>(.*?)</name>|<source>(.*?)</source>.*?<translation"
    """((?: type="(?:vanished|obsolete)")?)[^>]*?(?:/>|>(.*?)</translation>)""",
    re.DOTALL,
)
_FORM = re.compile("<numerusform>(.*?)</numerusform>", re.DOTALL)
_ENTITIES = {"&lt;": "<", "&gt;": ">", "&quot;": '"', "&apos;": "'", "&#xa0;": "\xa0", "&amp;": "&"}
_CAPITAL = "[\u0402-\u040f\u0410-\u042f]"
_IN_CAPITALS = re.compile(f"(?<={_CAPITAL})[ЉЊЏ]|[ЉЊЏ](?={_CAPITAL})")
_NUMBERS = re.compile(r"(?<![\w.])[-−+]?\d+(?:\.\d+)?(?:, *[-−+]?\d+(?:\.\d+)?)+(?![\w.]*\d)")
_IN_BRACKETS = re.compile(r"[(\[][^()\[\]]*[)\]]")  # of TeX, which parts what a comma ends
_TYPED = re.compile(r"[=:]\S*\d\.\d|ndc: |16\.16")  # texts with what stays as it is typed
_POINT = re.compile(r"(?<=\d)\.(?=\d)(?!\d+\.\d)(?<!\d\.\d\.)")


class _Chosen:
    """The language that the program speaks, and that of an open lesson, if it has its own."""

    program, lesson = ENGLISH, ""


def chosen() -> str:
    return _Chosen.program


def choose(language: str) -> None:
    """Speak a language from now on; what is shown already stays as it is."""
    _Chosen.program = language


def follow_lesson(language: str) -> None:
    """Let the language that an open lesson states rule its card; empty for that of the program."""
    _Chosen.lesson = language


def of_lessons() -> str:
    """Return the language of the open lesson's card and of its refutations."""
    return _Chosen.lesson or _Chosen.program


def cached(function: Callable[_P, _T]) -> Callable[_P, _T]:
    """Keep the results of a function, for each language."""

    @lru_cache(maxsize=1024)
    def kept(_languages: tuple[str, str], *given: Any) -> _T:
        return function(*given)  # type: ignore[call-arg]

    @wraps(function)
    def result(*given: _P.args, **_named: _P.kwargs) -> _T:
        return kept((chosen(), of_lessons()), *given)

    return result


def known(names: Iterable[str]) -> str:
    """Return the first language that the program has, of locales such as ``sr_RS@latin``."""
    for name in names:
        code, *more = re.split("[-_.@]", name.lower())
        if code == "sr" and {"latn", "latin"} & {*more}:
            return "sr-Latn"
        if code in LANGUAGES:
            return code
    return ENGLISH


def of_system(environment: Mapping[str, str] = os.environ) -> str:
    """Return the language of a terminal, as GNU programs find it."""
    names = (environment.get(name, "") for name in ("LC_ALL", "LC_MESSAGES", "LANG"))
    locale = next(filter(None, names), "C")
    if locale.partition(".")[0] in ("C", "POSIX"):
        return ENGLISH
    return known([*filter(None, environment.get("LANGUAGE", "").split(":")), locale])


def translate(text: str, context: str, count: int | None = None) -> str:
    """Return a text in the language of the program; in English where it has no translation."""
    language = of_lessons() if context in OF_LESSONS else _Chosen.program
    forms = () if language == ENGLISH else forms_of("program", language, context, text)
    if not forms:
        return text
    return forms[0 if count is None or len(forms) == 1 else plural(language, count)]


@cache
def sentences() -> Mapping[str, str]:
    """Return the longer sentences of commands and of the set-up, by their names."""
    page = Path(__file__).with_name("content") / "sentences.md"
    return dict(re.findall("(?m)^- (.+?): (.+)", page.read_text("utf-8")))


def said(sentence: str, *values: object) -> str:
    """Return a sentence of a command, or that of this name, in the language and filled in."""
    text = translate(sentences().get(sentence, sentence), "Command")
    return text.format(*values) if values else text


def sentence_of(lesson: str, text: str) -> str:
    """Return a sentence of a lesson of the program, by the name of its file."""
    if of_lessons() == ENGLISH:
        return text
    return (*forms_of("lessons", of_lessons(), lesson, text), text)[0]


@cache
def forms_of(part: str, language: str, context: str, text: str) -> Forms:
    """Return the forms of a text of ``program`` or ``lessons``; nothing where it has none."""
    if language == "sr-Latn":
        return tuple(map(in_latin, forms_of(part, "sr", context, text)))
    translation = texts(part, language).get((context, text), "")
    forms = tuple(map(_unescaped, _FORM.findall(translation) or [translation]))
    if not all(forms):
        return ()
    is_typed = context in ("Options", "Command") or _TYPED.search(text)
    return forms if is_typed else tuple(map(_with_comma, forms))


@cache
def texts(part: str, language: str) -> Mapping[tuple[str, str], str]:
    """Return what a file of Qt Linguist has for each context and English text.

    A pattern reads it in half the time of ElementTree: a start waits for it.
    """
    path, context = TRANSLATIONS / f"{part}_{language}.ts", ""
    known_texts: dict[tuple[str, str], str] = {}
    try:
        content = path.read_text("utf-8")
        if not content.rstrip().endswith("</TS>"):
            raise ValueError("its end is missing")
    except (OSError, ValueError) as error:  # a translator may have left it so
        import logging  # seldom: not at the start

        text = "%s cannot be read, and the texts stay English: %s."
        logging.getLogger("app.strangers").warning(text, path, error)  # which the window shows
        return {}
    for name, source, gone, translation in _MESSAGE.findall(content):
        context = _unescaped(name) or context
        if translation and not gone:
            known_texts[context, _unescaped(source)] = translation
    return known_texts


def _unescaped(text: str) -> str:
    for entity, sign in _ENTITIES.items() if "&" in text else ():
        text = text.replace(entity, sign)
    return text


def plural(language: str, count: int) -> int:
    """Return which form of a text a number takes, as Qt's rules count them."""
    if language == "et":
        return int(count != 1)
    if count % 10 == 1 and count % 100 != 11:
        return 0
    return 1 if 2 <= count % 10 <= 4 and not 12 <= count % 100 <= 14 else 2


def in_latin(text: str) -> str:
    """Return a Serbian text in Latin letters: ``Њ`` is ``Nj``, and ``NJ`` among capitals.

    Each Cyrillic letter has one Latin form, so this needs no list of exceptions.
    """
    text = _IN_CAPITALS.sub(lambda letter: letter[0].translate(_LATIN).upper(), text)
    return text.translate(_LATIN)


def listed(numbers: Iterable[str]) -> str:
    """Return numbers in a row: ``0.5, 1, 2``, and ``0,5; 1; 2`` where they have commas."""
    return (", " if _Chosen.program == ENGLISH else "; ").join(numbers)


def quoted(text: str, language: str = "") -> str:
    """Return a text in the quotation marks of the program's language, or of another one."""
    return _QUOTES.get(language or _Chosen.program, "“{}”").format(text)


def with_comma(text: str, *, in_tex: bool = False) -> str:
    """Return a text with its numbers as the language writes them: 1,5 and (0,5; 1; 2)."""
    if _Chosen.program == ENGLISH or "." not in text:
        return text
    return _with_comma(text, _IN_BRACKETS, "{,}") if in_tex else _with_comma(text)


def _with_comma(text: str, lists: re.Pattern[str] = _NUMBERS, comma: str = ",") -> str:
    text = lists.sub(
        lambda row: re.sub(r"(?<!\\), *", "; ", row[0]) if _POINT.search(row[0]) else row[0], text
    )
    return _POINT.sub(comma, text)
