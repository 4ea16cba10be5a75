"""Refusals: one sentence with field, value and bound that says why something is refused.

The core knows no Qt. Its sentences are on the page ``content/sentences.md``, and its words are
marked with `QT_TRANSLATE_NOOP`, which lupdate finds. The widgets translate a template and then fill
it in.
"""

import difflib
import json
import math
import numbers
import re
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import Any, NewType, cast

from app import languages
from app.strangers import printable

Bound = NewType("Bound", str)
"""The template of a refusal; only `REFUSALS` has them, so each can be translated."""


def QT_TRANSLATE_NOOP(_context: str, text: str) -> str:
    """Mark a text for translation; the widgets translate it when they show it."""
    return text


def _sentences() -> dict[str, dict[str, str]]:
    page = (Path(__file__).parent / "content" / "sentences.md").read_text("utf-8")
    sections: dict[str, dict[str, str]] = {}
    section: dict[str, str] = {}
    for line in page.splitlines():
        if line.startswith("## "):
            section = sections[line[3:]] = {}
        elif line.startswith("- "):
            name, _, text = line[2:].partition(": ")
            section[name] = text or name
    return sections


SENTENCES = _sentences()
"""The texts of the page, by section and name."""
REFUSALS = cast(Mapping[str, Bound], SENTENCES["Refusal"])
DESCRIPTION, MEASURE, HEALTH, MATRIX = (
    SENTENCES[name] for name in ("Description", "Measure", "Health", "Matrix")
)
SHOWN_DIGITS = 6  # displayed digits of a bound, and of a dragged value
_SHOWN = 100
_LONGEST_WRITTEN = 60
_DEEPEST = 4
_LONGEST_FILE = 200


class Refusal(ValueError):
    """An invalid value of the model, or an invalid part of a document, a file or a scene.

    - `field`: name of the refused parameter (``"eye"``), or its path in a document
      (``"camera.eye"``); empty for the whole document.
    - `value`: the refused value; `Ellipsis` if there is none to show.
    - `bound`: the condition that the value violates, with ``{0}``, ``{1}`` for the limits.
    - `file`: the file of the document, or empty; None outside documents.
    """

    def __init__(
        self, field: str, value: object, bound: Bound, *limits: object, file: str | None = None
    ) -> None:
        super().__init__(field, value, bound, *limits)
        self.field, self.value, self.bound, self.limits = field, value, bound, limits
        self.file = file

    @classmethod
    def in_document(
        cls, bound: Bound, *limits: object, field: str = "", value: object = ..., file: str = ""
    ) -> "Refusal":
        """Refuse a document or a file; the value is written as in the document."""
        return cls(field, value, bound, *limits, file=file)

    @classmethod
    def saying(cls, template: Bound, *parts: object) -> "Refusal":
        """Refuse with a template that is the whole sentence."""
        return cls("", ..., template, *parts)

    def __str__(self) -> str:
        return self.sentence(partial(languages.translate, context="Refusal"))

    def sentence(
        self,
        translate: Callable[[str], str] = str,
        field_name: Callable[[str], str] = str,
        written: Callable[[object], str] | None = None,
    ) -> str:
        """The sentence with file, field, value and bound.

        `translate` translates templates and `field_name` the names of the model's parameters, but
        not the paths of a document. `written` replaces `format_value` for values of the model.
        """
        bound = translate(self.bound)
        if self.file is None:
            if not self.field and self.value is ...:  # a whole sentence
                return bound.format(*(printable(str(part)) for part in self.limits))
            shown = bound.format(*shown_limits(self.limits, self.value))
            if self.value is ...:
                return f"{field_name(self.field)} {shown}."
            return f"{field_name(self.field)} = {(written or format_value)(self.value)}: {shown}."
        bound = re.sub(r"(?<!\?)\Z", ".", bound.format(*shown_limits(self.limits, self.value)))
        file = shown_name(self.file)
        if len(file) > _LONGEST_FILE:
            file = "..." + file[3 - _LONGEST_FILE :]
        if not self.field:
            return f"{file or translate(REFUSALS['the-document'])} {bound}"
        field = re.sub(r"\bline (?=\d)", f"{languages.said('line')} ", self.field)
        place = f"{file}: {field}" if file else field
        if self.value is ...:
            return f"{place} {bound}"
        return f"{place} = {_as_written(self.value)}: {bound}"


class Cancelled(Exception):
    """The user has cancelled a computation; `partial` is its result so far."""

    def __init__(self, partial: Any = None) -> None:
        super().__init__()
        self.partial = partial


# --------------------------------------------------------------------------- values in a sentence


def format_value(value: object, depth: int = 0) -> str:
    """Write a value as a person would type it: ``1``, ``0.1``, ``inf``, ``(0, 1, 0)``."""
    if isinstance(value, (tuple, list)):
        if depth > _DEEPEST:  # a list may contain itself
            return "..."
        return _cut("(" + ", ".join(format_value(part, depth + 1) for part in value[:_SHOWN]) + ")")
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        return _cut(" ".join(repr(value).split()))
    try:
        number = float(value)
    except OverflowError:
        whole: Any = value
        return f"{'-' if whole < 0 else ''}1e{int(math.log10(abs(whole)))}"
    return str(int(number)) if number.is_integer() and abs(number) < 1e15 else repr(number)


def shown_limits(limits: Iterable[object], value: object) -> tuple[object, ...]:
    """Round limits to six digits, unless the refused value would satisfy the rounded ones.

    Words do not change, nor do the texts of numbers if the refused value is not a number.
    """
    return tuple(_shown_limit(limit, value) for limit in limits)


def _shown_limit(limit: object, value: object) -> object:
    number = _limit_number(limit)
    shown, sides = _six_digits(number), _sides(value, number)
    is_word = isinstance(limit, str) and not sides
    if shown == number or is_word or _sides(value, shown) != sides:
        return limit if isinstance(limit, str) else format_value(limit)  # 20, not 20.0
    return format_value(shown)


def six_digits(error: Refusal) -> Refusal:
    """Return the refusal of a dragged value with the value, too, rounded to six digits.

    The value keeps all its digits if six would put it on the other side of a limit. A point beyond
    the vanishing line of a pane would be at infinity.
    """
    value, limits = error.value, shown_limits(error.limits, error.value)
    if isinstance(value, tuple) and not all(map(math.isfinite, value)):
        return Refusal(error.field, math.inf, error.bound, *limits)
    short = tuple(map(_six_digits, value)) if isinstance(value, tuple) else _six_digits(value)
    numbers_shown = [_limit_number(limit) for limit in limits]
    if any(_sides(short, limit) != _sides(value, limit) for limit in numbers_shown):
        return error
    return Refusal(error.field, short, error.bound, *limits)


def _six_digits(value: Any) -> Any:
    return float(f"{value:.{SHOWN_DIGITS}g}") if isinstance(value, float) else value


def _limit_number(limit: Any) -> Any:
    """Return the number that a limit is or writes; a word stays a word."""
    try:
        return float(limit) if isinstance(limit, (float, str)) else limit
    except ValueError:
        return limit


def _sides(value: object, limit: Any) -> list[tuple[bool, bool]]:
    if not isinstance(limit, float):
        return []
    parts = value if isinstance(value, (tuple, list)) else (value,)
    real_parts = [part for part in parts if isinstance(part, (int, float))]
    return [(part > limit, part < limit) for part in real_parts]


def _cut(text: str) -> str:
    return text if len(text) <= _SHOWN else text[: _SHOWN - 3] + "..."


def _as_written(value: object) -> str:
    """Write a refused value as in a document, cut to a length that fits into a sentence."""
    if value is None or isinstance(value, bool):
        return json.dumps(value)
    if isinstance(value, (list, tuple)):
        text = "[" + ", ".join(map(_as_written, value[:_LONGEST_WRITTEN])) + "]"
    elif isinstance(value, dict):
        keys = list(value)[:_LONGEST_WRITTEN]
        text = "{" + ", ".join(f"{shown_name(str(key))}: ..." for key in keys) + "}"
    elif isinstance(value, str):
        text = repr(type(value)(value[: _LONGEST_WRITTEN + 1]))
    else:
        text = format_value(value)
    return text if len(text) <= _LONGEST_WRITTEN else text[: _LONGEST_WRITTEN - 3] + "..."


def shown_name(name: str) -> str:
    """Return a name, quoted if it has control characters."""
    return name if name.isprintable() else repr(name)


def nearest(word: str, known: Iterable[str]) -> str:
    return max(known, key=lambda each: difflib.SequenceMatcher(None, word, each).ratio())


def counted(count: int, word: str) -> str:
    """Write a number of things in the language: ``1 step``, ``2 steps``."""
    several = f"%n {word}s"
    text = languages.translate(several, "Count", count)
    return (f"%n {word}" if count == 1 and text == several else text).replace("%n", str(count))
