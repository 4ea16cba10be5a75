"""The line format of block bodies, and refusals that name the line.

A body is a text, then lines ``key: value``, or choices ``- [x] text``. An indented line continues
the value above it; such lines below a choice or a wrong value may have their own keys.
"""

import contextlib
import difflib
import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from app.languages import said
from app.lessons.quantities import Condition, read_formula
from app.model import numerals
from app.model.formula import Formula
from app.model.refusal import REFUSALS, Bound, Refusal

LONGEST_LINE = 4000  # most characters of a line, also with the indented lines that continue it

Lines = Sequence[tuple[int, str]]  # lines of a file with their numbers, from 1


def refused(line: int, bound: Bound, *limits: object, value: object = ...) -> Refusal:
    return Refusal.in_document(bound, *limits, field=f"line {line}", value=value)


@contextlib.contextmanager
def on_line(line: int, what: str = "") -> Iterator[None]:
    """Add to a refusal of the model the line, and the key there (``value``)."""
    try:
        yield
    except Refusal as error:
        if error.field.startswith("line ") or (error.file is not None and error.file != ""):
            raise
        if not error.field and error.value is ...:  # a whole sentence, of a scene or its file
            raise refused(line, REFUSALS["cannot-be"], str(error).rstrip(".")) from error
        name = what if error.field in ("formula", "condition") and what else error.field
        where = f"line {line}, {name}" if name else f"line {line}"
        raise Refusal.in_document(
            error.bound, *error.limits, field=where, value=error.value
        ) from error


def continued(above: str, text: str, line: int) -> str:
    """Return a value with a line that continues it; refuse one that becomes too long."""
    whole = f"{above} {text.strip()}".strip()
    if len(whole) > LONGEST_LINE:
        raise refused(line, REFUSALS["long-value"], len(whole), LONGEST_LINE)
    return whole


def number_in(text: str, line: int, low: float, high: float) -> float:
    value = numerals.number(text)
    if value is None or not low <= value <= high:
        raise refused(line, REFUSALS["a-number"], low, high, value=text)
    return value


def whole(text: str, most: int) -> int:
    """Return a whole number from 1 to `most`; 0 for any other text."""
    if not text.isdecimal() or len(text) > len(str(most)):  # Python reads 4300 digits at most
        return 0
    return int(text) if int(text) <= most else 0


def split(text: str) -> list[str]:
    """Split a text at its commas outside brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter == "(") - (letter == ")")
        if letter == "," and not depth:
            parts.append("")
        else:
            parts[-1] += letter
    return parts


class LineItem(NamedTuple):
    """A line that begins with a key or is a choice, joined with its indented lines.

    The key of a choice is ``choice``. `about` is the word after the key (``wrong ABOUT: ...``), or
    ``x`` for a right choice.
    """

    key: str
    about: str
    text: str
    line: int
    below: "Sequence[LineItem]" = ()

    def formula(self) -> Formula:
        with on_line(self.line, self.key):
            return read_formula(self.text)


class Items(tuple[LineItem, ...]):
    def every(self, key: str) -> list[LineItem]:
        return [item for item in self if item.key == key]

    def single(self, key: str) -> LineItem | None:
        """Return the item of a key; refuse a second one."""
        same = self.every(key)
        if len(same) > 1:
            raise refused(same[1].line, REFUSALS["only-once"], key)
        return same[0] if same else None

    def text(self, key: str) -> str:
        """Return the text of a single key; empty if it is missing."""
        item = self.single(key)
        return item.text if item else ""

    def texts(self, key: str) -> tuple[str, ...]:
        return tuple(item.text for item in self.every(key))

    def conditions(self, key: str) -> tuple[tuple[int, Condition], ...]:
        """Read every condition of a key, each with its line."""
        conditions = []
        for item in self.every(key):
            with on_line(item.line, key):
                conditions.append((item.line, Condition.read(item.text)))
        return tuple(conditions)

    def sentences(self) -> tuple[tuple[int, str], ...]:
        """Return every sentence for the student that may contain formulas, with its line."""
        own = [(item.line, item.text) for item in self if item.key in ("why", "hint", "done")]
        below = [each for item in self for each in item.below if each.key in ("says", "title")]
        sentences = *own, *((each.line, each.text) for each in below)
        for line, text in sentences:
            if not text:
                raise refused(line, REFUSALS["lacks"], "a text")
        return sentences


class Body(NamedTuple):
    """A block as in its file; `line` is that of the kind, `lines` are the ones inside."""

    kind: str
    name: str
    line: int
    lines: Lines

    def items(self, *keys: str, choices: bool = False) -> tuple[str, Items]:
        """Read the text at the start of the body, and the items with these keys that follow."""
        question: list[str] = []
        items: list[LineItem] = []
        for number, text in self.lines:
            indented = text[:1] in (" ", "\t")
            choice = _CHOICE.fullmatch(text.rstrip()) if choices and not indented else None
            key = _KEY.fullmatch(text.strip())
            if choice:
                about, answer = choice[1].strip().lower(), choice[2].strip()
                items.append(LineItem("choice", about, answer, number))
            elif indented and items:
                items[-1] = _continued(items[-1], key, text.strip(), number, keys)
            elif key and not indented and key[1] in keys:
                items.append(LineItem(key[1], (key[2] or "").strip(), key[3].strip(), number))
            elif not items and not mistyped(text.strip(), keys):
                question.append(text)
            elif choices and text.startswith(("-", "*")):
                raise refused(number, REFUSALS["no-choice"], value=text.strip()[:60])
            elif text.strip():
                bound = REFUSALS["indented"] if indented else REFUSALS["unexpected"]
                raise refused(number, bound, ", ".join(keys), value=text.strip()[:60])
        asked = "\n".join(question).strip()
        if not asked:
            raise refused(self.line, REFUSALS["lacks"], said("a question or a task"))
        return asked, Items(items)


_CHOICE = re.compile(r"[-*]\s+\[([ xX])\]\s+(.*)")
_KEY = re.compile(r"([a-z]+)(\s+[\w-]+)?:(.*)")
_WITH_BELOW = ("choice", "wrong")
_BELOW = ("says", "state", "title")


def _continued(
    last: LineItem, key: re.Match[str] | None, text: str, number: int, keys: Sequence[str]
) -> LineItem:
    """Return the last item, extended by an indented line."""
    has_own = last.key in _WITH_BELOW
    if has_own and key and key[1] in _BELOW:
        return last._replace(below=[*last.below, LineItem(key[1], "", key[3].strip(), number)])
    if mistyped(text, (*_BELOW, *keys)):
        bound = REFUSALS["unexpected"] if has_own else REFUSALS["indented"]
        raise refused(number, bound, ", ".join(_BELOW), value=text[:60])
    if last.below:
        further = last.below[-1]
        further = further._replace(text=continued(further.text, text, number))
        return last._replace(below=[*last.below[:-1], further])
    return last._replace(text=continued(last.text, text, number))


def mistyped(text: str, keys: Sequence[str]) -> bool:
    """Whether a line of free text looks like a misspelt key."""
    match = re.match(r"([A-Za-z]+)(\s+[\w-]+)?\s*:", text)
    if match is None:
        return False
    near = difflib.get_close_matches(match[1].lower(), keys, n=1, cutoff=0.8)
    # Only `wrong` is followed by a word: “Check this:” is a sentence.
    return bool(near) and near[0][0] == text[0].lower() and (not match[2] or near[0] == "wrong")
