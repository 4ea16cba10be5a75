"""The file of a lesson or of a talk: Markdown with blocks, read once and checked as it is read.

`docs/lessons.md` explains the format to a teacher. A file comes from a stranger: it is bounded, and
what is wrong with it is refused with its line and what was expected there. What its states and
formulas are worth is `app.lessons.course`'s.
"""

from __future__ import annotations

import contextlib
import difflib
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from app.document.codec import Path as AnyPath
from app.document.files import TOO_LARGE, UNREADABLE, blamed_on
from app.lecture.notation import LETTERS, Letters
from app.lessons.quantities import Condition
from app.model.formula import Formula, parse
from app.model.limits import ONE_OF
from app.model.refusal import QT_TRANSLATE_NOOP, Bound, Refusal
from app.strangers import open_regular

if TYPE_CHECKING:
    from markdown_it import MarkdownIt
    from markdown_it.rules_inline import StateInline
    from markdown_it.token import Token

ENDINGS = (".md", ".markdown")
"""Of files that are lessons."""
VERSION = 1
"""Of the format; a file may say the one that it needs (``version: 1``)."""
LARGEST = 2 * 2**20
"""Most bytes of a file."""
MOST_STEPS = 500
"""Of a talk."""

TOP = QT_TRANSLATE_NOOP(
    "Refusal", "must begin the lesson: ---, then lines as “title: ...”, then --- again"
)
TOP_UNCLOSED = QT_TRANSLATE_NOOP(
    "Refusal", "has no line --- above it, which must end the lines as “title: ...”"
)
NOT_UTF8 = QT_TRANSLATE_NOOP("Refusal", "is not UTF-8 text: save the file in that encoding")
TOP_KEY = QT_TRANSLATE_NOOP("Refusal", "must be one of {0}, a colon, and its value")
NO_TITLE = QT_TRANSLATE_NOOP("Refusal", "lacks a line “title: ...”")
NEWER = QT_TRANSLATE_NOOP(
    "Refusal",
    "was written for a newer Frustum Lab, which reads version {0}; this one reads up to {1}",
)
NO_BLOCK = QT_TRANSLATE_NOOP("Refusal", "has a block that there is not, {0}; the nearest is {1}")
NO_HEADING = QT_TRANSLATE_NOOP("Refusal", "must begin a step with its title, as “# Title”")
NO_STEPS = QT_TRANSLATE_NOOP("Refusal", "has no steps")
TOO_MANY_STEPS = QT_TRANSLATE_NOOP("Refusal", "has more than {0} steps")
TWICE = QT_TRANSLATE_NOOP("Refusal", "has the name of line {0} again; every one needs its own")
BAD_NAME = QT_TRANSLATE_NOOP("Refusal", "must be a name of letters, digits and -")
UNCLOSED = QT_TRANSLATE_NOOP("Refusal", "begins a block that is not closed: a line ``` must end it")
UNCLOSED_ABOVE = QT_TRANSLATE_NOOP(
    "Refusal",
    "begins a block that is not closed: a line ``` must end it, above line {0}, where another"
    " begins",
)
CODE_UNCLOSED = QT_TRANSLATE_NOOP(
    "Refusal",
    "begins code that is not closed: there is a line ``` too many, or one without its kind",
)
BLOCK_IN_CODE = QT_TRANSLATE_NOOP(
    "Refusal",
    "begins code, not a block, and the block of line {0} is in it: there is a line ``` too many, or"
    " one without its kind",
)
STEP_IN_STEP = QT_TRANSLATE_NOOP("Refusal", "has the title of a step, but no line --- above it")
BLOCK_INDENTED = QT_TRANSLATE_NOOP(
    "Refusal", "begins a block, but is indented: ``` stands where a line begins"
)
TOPICS = QT_TRANSLATE_NOOP("Refusal", "must be of L1 to L24, with commas between them")
UNEXPECTED = QT_TRANSLATE_NOOP("Refusal", "must be one of {0}, a colon, and its value")
INDENTED = QT_TRANSLATE_NOOP(
    "Refusal", "is indented, but there is nothing above that it belongs to"
)
LACKS = QT_TRANSLATE_NOOP("Refusal", "needs {0}")
ONLY_ONCE = QT_TRANSLATE_NOOP("Refusal", "has {0} twice")
NO_CHOICE = QT_TRANSLATE_NOOP("Refusal", "must begin with “- [x]”, if it is right, or “- [ ]”")
ONE_RIGHT = QT_TRANSLATE_NOOP(
    "Refusal", "needs at least two choices, just one of them right: “- [x]”, the others “- [ ]”"
)
EITHER = QT_TRANSLATE_NOOP("Refusal", "has choices and a value: only one of them can be")
A_SAMPLE = QT_TRANSLATE_NOOP("Refusal", "must be a sample, as “NAME: SAMPLE -> VERDICT”")
AN_ASSIGNMENT = QT_TRANSLATE_NOOP(
    "Refusal", "must be written as NAME=VALUE, or document: FILE.json"
)
BESIDE = QT_TRANSLATE_NOOP("Refusal", "must be a file beside the lesson, or in a folder there")
CANNOT_BE = QT_TRANSLATE_NOOP("Refusal", "cannot be shown: {0}")
A_NUMBER = QT_TRANSLATE_NOOP("Refusal", "must be a number from {0} to {1}")


# --------------------------------------------------------------------------- what it holds


class State(NamedTuple):
    """What the window is to show: assignments of ``--set``, or a document's file.

    Attributes
    ----------
    line : int
    values : tuple of (int, str)
        ``NAME=VALUE``, each with its line.
    document : str
        Path of a document, from the lesson's folder; empty for none.
    document_line : int
    """

    line: int
    values: tuple[tuple[int, str], ...] = ()
    document: str = ""
    document_line: int = 0

    @property
    def begins_anew(self) -> bool:
        """Whether it names a scene or a document, and so has nothing of the step before."""
        return bool(self.document) or any(
            text.partition("=")[0].strip() == "scene" for _, text in self.values
        )


@dataclass(frozen=True)
class Choice:
    """One of several answers.

    Attributes
    ----------
    text : str
        Markdown.
    right : bool
    line : int
    formula : Formula, optional
        What its number comes from.
    idea : str
        Name of the wrong idea that leads there.
    says : str
        Markdown; what is said to it.
    state : State, optional
        That shows it.
    """

    text: str
    right: bool
    line: int
    formula: Formula | None = None
    idea: str = ""
    says: str = ""
    state: State | None = None


@dataclass(frozen=True)
class Wrong:
    """A wrong value that an idea leads to; attributes as of `Choice`."""

    formula: Formula
    line: int
    idea: str = ""
    says: str = ""
    state: State | None = None


@dataclass(frozen=True)
class Words:
    """Text between the blocks, as Markdown."""

    text: str
    line: int


@dataclass(frozen=True)
class Question:
    """What is asked: a prediction, to be committed before the step goes on, or an answer.

    Attributes
    ----------
    name : str
    line : int
    text : str
        Markdown.
    predicts : bool
    choices : tuple of Choice
    value : Formula, optional
        The right number, where there are no choices.
    unit : str
    wrong : tuple of Wrong
    show : State, optional
        Where a prediction's model goes.
    checks : tuple of Condition
        What makes the right choice right.
    why : str
        Markdown; what is said then.
    hints : tuple of str
    value_line : int
        Of its value; that of the block where there are choices.
    said : tuple of (int, str)
        All that is said to an answer, and the hints, each with its line.
    """

    name: str
    line: int
    text: str
    predicts: bool
    choices: tuple[Choice, ...] = ()
    value: Formula | None = None
    unit: str = ""
    wrong: tuple[Wrong, ...] = ()
    show: State | None = None
    checks: tuple[tuple[int, Condition], ...] = ()
    why: str = ""
    hints: tuple[str, ...] = ()
    value_line: int = 0
    said: tuple[tuple[int, str], ...] = ()


@dataclass(frozen=True)
class Task:
    """What is to be done in the window, by any way.

    Attributes
    ----------
    until : tuple of (int, Condition)
        Of the model as it stands; all must hold. Each with its line.
    done : str
        Markdown; said once they do.
    hints : tuple of str
    said : tuple of (int, str)
        That and the hints, each with its line.
    """

    name: str
    line: int
    text: str
    until: tuple[tuple[int, Condition], ...]
    done: str = ""
    hints: tuple[str, ...] = ()
    said: tuple[tuple[int, str], ...] = ()


Complain: TypeAlias = Callable[[Refusal], object]
Part: TypeAlias = Words | Question | Task


class Note(NamedTuple):
    """What only the speaker reads, and the minutes that are planned.

    Attributes
    ----------
    text : str
    line, text_line : int
        Of the block, and of its first words.
    minutes : float
    """

    text: str
    line: int
    minutes: float = 0.0
    text_line: int = 0


class Sample(NamedTuple):
    """A trial answer, or what is set in a task, and what it must get."""

    block: str
    text: str
    verdict: str
    line: int


@dataclass(frozen=True)
class Step:
    """One step.

    Attributes
    ----------
    name, title : str
    line : int
    parts : tuple of Words, Question and Task
        What the student reads and does, in order.
    state : State, optional
        None where it shows what the step before did.
    note : Note, optional
    samples : tuple of Sample
    """

    name: str
    title: str
    line: int
    parts: tuple[Part, ...] = ()
    state: State | None = None
    note: Note | None = None
    samples: tuple[Sample, ...] = ()

    @property
    def asked(self) -> tuple[Question | Task, ...]:
        """What the student has to do."""
        return tuple(part for part in self.parts if not isinstance(part, Words))


@dataclass(frozen=True)
class Lesson:
    """A lesson, or a talk.

    Attributes
    ----------
    path : Path
    title, lecture, language : str
    topics : tuple of str
        ``L1`` to ``L24``.
    letters : str
        Whose letters formulas are written in; empty for those that the window has.
    minutes : float
        Planned for all of it.
    steps : tuple of Step
    """

    path: Path
    title: str
    steps: tuple[Step, ...]
    lecture: str = ""
    topics: tuple[str, ...] = ()
    language: str = "en"
    letters: Letters | None = None
    minutes: float = 0.0

    @property
    def is_talk(self) -> bool:
        """Whether somebody speaks to it: it has notes."""
        return any(step.note is not None for step in self.steps)


# --------------------------------------------------------------------------- reading


def is_lesson(path: str) -> bool:
    """Tell by its name whether a file is a lesson or a talk."""
    return path.lower().endswith(ENDINGS)


def read(path: AnyPath, complain: Complain | None = None) -> Lesson:
    """Read a lesson from its file.

    Parameters
    ----------
    path : path
    complain : callable, optional
        Is told of steps in which something is wrong, and they are left out: for who wants to know
        all of it at once.

    Raises
    ------
    Refusal
        If there is no such file, or something is wrong with it: then with its line.
    """
    with blamed_on(path, UNREADABLE):
        with open_regular(path) as file:
            content = file.read(LARGEST + 1)
        if len(content) > LARGEST:
            raise Refusal.in_document(TOO_LARGE, LARGEST // 2**20)
        try:
            text = content.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            raise refused(content[: error.start].count(b"\n") + 1, NOT_UTF8) from error
        return parse_lesson(text, Path(path), complain)


class Head(NamedTuple):
    """What a list of lessons says of one; attributes as of `Lesson`."""

    path: Path
    title: str
    topics: tuple[str, ...]
    is_talk: bool


def head_of(path: Path) -> Head:
    """Read of a lesson only what a list of lessons says of it.

    Raises
    ------
    Refusal
        If there is no such file, or its top is wrong.
    """
    with blamed_on(path, UNREADABLE):
        with open_regular(path) as file:
            text = file.read(LARGEST).decode("utf-8-sig", "replace")
        top, _ = _top(text.split("\n"))
        is_talk = re.search(r"^(```+|~~~+)\s*note\b", text, re.MULTILINE) is not None
        about = (top["lecture"],) if is_talk else top["topics"]
        return Head(path, top["title"], about, is_talk)


def parse_lesson(text: str, path: Path, complain: Complain | None = None) -> Lesson:
    """Read a lesson from its text; `path` is where it is, or is going to be.

    Raises
    ------
    Refusal
        If something is wrong with it, with its line.
    """
    lines = _lines(text)
    top, first = _top(lines)
    return Lesson(path, steps=_steps(lines, first, path, complain), **top)


def _lines(text: str) -> list[str]:
    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", "\ufffd")
    return text.removeprefix("\ufeff").split("\n")


def refused(line: int, bound: Bound, *limits: object, value: object = ...) -> Refusal:
    """What is wrong with a line of a lesson, counted from 1."""
    return Refusal.in_document(bound, *limits, field=f"line {line}", value=value)


@contextlib.contextmanager
def on_line(line: int, what: str = "") -> Iterator[None]:
    """Say of a refusal of a value or of a formula in which line of the lesson it stands."""
    try:
        yield
    except Refusal as error:
        if error.field.startswith("line ") or (error.file is not None and error.file != ""):
            raise
        if not error.field and error.value is ...:  # a whole sentence, of a scene or its file
            raise refused(line, CANNOT_BE, str(error).rstrip(".?")) from error
        name = what if error.field in ("formula", "condition") and what else error.field
        raise Refusal.in_document(
            error.bound,
            *error.limits,
            field=f"line {line}, {name}" if name else f"line {line}",
            value=error.value,
        ) from error


_TOPIC = re.compile(r"L([1-9]|1\d|2[0-4])")
_TOP_KEYS = ("title", "lecture", "topic", "language", "letters", "minutes", "version")


def _top(lines: Sequence[str]) -> tuple[dict[str, Any], int]:
    """The front matter, and the number of lines that it takes."""
    if not lines or lines[0].strip() != "---":
        raise refused(1, TOP, value=lines[0][:60] if lines else "")
    found: dict[str, str] = {}
    for number, line in enumerate(lines[1:], 2):
        if line.strip() == "---":
            break
        key, colon, value = (part.strip() for part in line.partition(":"))
        if not line.strip():
            continue
        if line.startswith(("#", "```", "~~~")):
            raise refused(number, TOP_UNCLOSED, value=line[:60])
        if not colon or key not in _TOP_KEYS:
            raise refused(number, TOP_KEY, ", ".join(_TOP_KEYS), value=line[:60])
        if key in found:
            raise refused(number, ONLY_ONCE, key)
        found[key] = value
        if key == "version":
            wanted = _number(value, number, 1, 1e6)
            if wanted > VERSION:
                raise refused(number, NEWER, f"{wanted:g}", VERSION)
        elif key == "minutes":
            _number(value, number, 0, 1000)
        elif key == "letters" and value not in LETTERS:
            raise refused(number, ONE_OF, ", ".join(LETTERS), value=value)
        elif key == "topic" and not all(map(_TOPIC.fullmatch, _parted(value))):
            raise refused(number, TOPICS, value=value)
    else:
        raise refused(len(lines), TOP)
    if not found.get("title"):
        raise refused(1, NO_TITLE)
    title = found["title"]
    if len(title) > 2 and title[0] == title[-1] and title[0] in "\"'":  # as YAML has it
        title = title[1:-1]
    top: dict[str, Any] = {"title": title, "lecture": found.get("lecture", "")}
    top["topics"] = tuple(_parted(found.get("topic", "")))
    top["language"] = found.get("language", "en")
    top["letters"] = found.get("letters")
    top["minutes"] = float(found.get("minutes", 0.0))
    return top, number


def _parted(text: str) -> list[str]:
    return [part.strip() for part in text.split(",") if part.strip()]


def _number(text: str, line: int, low: float, high: float) -> float:
    try:
        number = float(text)
    except ValueError:
        number = -1.0
    if not low <= number <= high:
        raise refused(line, A_NUMBER, low, high, value=text)
    return number


@cache
def markdown() -> MarkdownIt:
    """The reader of Markdown: what could reach outside (links, pictures, HTML) is plain text.

    A line ``---`` is always a rule, never the line under a title. Formulas between dollars are
    tokens ``math`` (``markup`` is ``$`` or ``$$``), whose content nothing else reads.
    """
    from markdown_it import MarkdownIt

    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    reader.disable(["lheading", "html_block", "html_inline", "image", "link", "autolink"])
    reader.disable("reference")
    reader.inline.ruler.before("escape", "math", _math)
    return reader


_MATH = re.compile(r"(\$\$?)(?=\S)([^$\n]{1,400}?)(?<=\S)\1")


def _math(state: StateInline, silent: bool) -> bool:
    found = _MATH.match(state.src, state.pos)
    if found is None:
        return False
    if not silent:
        token = state.push("math", "", 0)
        token.content, token.markup = found[2], found[1]
    state.pos = found.end()
    return True


def formulas_in(text: str) -> list[str]:
    """The TeX of every formula in a text."""
    tokens = markdown().parse(text)
    return [
        part.content for token in tokens for part in token.children or () if part.type == "math"
    ]


# --------------------------------------------------------------------------- steps

_NAME = re.compile(r"[^\W_][\w-]*")
_HEADING = re.compile(r"#\s+(.*?)(?:\s*\{#([^{}]*)\})?\s*#*\s*")
_KINDS = ("state", "predict", "task", "answer", "note", "test")
_BLOCK = re.compile(rf"\s*(```+|~~~+)\s*({'|'.join(_KINDS)})\b")


def _steps(
    lines: Sequence[str], first: int, path: Path, complain: Complain | None
) -> tuple[Step, ...]:
    steps: list[Step] = []
    names: dict[str, int] = {}
    for group, _ in _groups(lines, first):
        try:
            if group:
                step = _Reader(lines, first, group).step()
                if step.name in names:
                    raise refused(step.line, TWICE, names[step.name], value=step.name)
                names[step.name] = step.line
                steps.append(step)
        except Refusal as error:
            if complain is None:
                raise
            error.file = str(path)
            complain(error)
    if not steps and complain is None:
        raise refused(first, NO_STEPS)
    return tuple(steps)


def _groups(lines: Sequence[str], first: int) -> list[tuple[list[Token], int]]:
    """What stands between the lines ``---``, and the number of lines up to its end."""
    body = "\n".join(lines[first:])
    groups: list[tuple[list[Token], int]] = []
    group: list[Token] = []
    for token in markdown().parse(body):
        if token.level > 0 or not token.map:
            continue
        if token.type == "hr":
            groups.append((group, _line(token, first) - 1))
            group = []
            if len(groups) > MOST_STEPS:
                raise refused(_line(token, first), TOO_MANY_STEPS, MOST_STEPS)
        else:
            group.append(token)
    return [*groups, (group, len(lines))]


def ends(text: str) -> list[int]:
    """After how many of its lines each step of a lesson ends: there another can be put."""
    lines = _lines(text)
    _, first = _top(lines)
    return [end for group, end in _groups(lines, first) if group]


def _line(token: Token, first: int) -> int:
    assert token.map is not None
    return token.map[0] + first + 1


class _Item(NamedTuple):
    """A line of a block that begins with a key or is a choice, with what is indented below it."""

    key: str
    about: str
    text: str
    line: int
    below: list[_Item]


class _Reader:
    """Reads one step from its tokens."""

    def __init__(self, lines: Sequence[str], first: int, tokens: Sequence[Token]) -> None:
        self._lines, self._first, self._tokens = lines, first, tokens
        self._names: dict[str, int] = {}

    def step(self) -> Step:
        heading = self._tokens[0]
        line = _line(heading, self._first)
        found = _HEADING.fullmatch(self._lines[line - 1].strip())
        if heading.type != "heading_open" or heading.tag != "h1" or found is None or not found[1]:
            raise refused(line, NO_HEADING, value=self._lines[line - 1][:60])
        title = found[1]
        name = found[2].strip() if found[2] is not None else slug(title)
        if not _NAME.fullmatch(name):
            raise refused(line, BAD_NAME, value=name)
        parts: list[Part] = []
        state: State | None = None
        note: Note | None = None
        samples: list[Sample] = []
        words: list[Token] = []

        def flush() -> None:
            if words:
                begin, end = words[0].map[0], words[-1].map[1]  # type: ignore[index]
                text = "\n".join(self._lines[self._first + begin : self._first + end])
                parts.append(Words(text, self._first + begin + 1))
                words.clear()

        for token in self._tokens[1:]:
            kind, _, block_name = token.info.strip().partition(" ")
            if token.type == "code_block" and _BLOCK.match(token.content):
                raise refused(_line(token, self._first), BLOCK_INDENTED)
            line = _line(token, self._first)
            if token.type == "heading_open" and token.tag == "h1":
                raise refused(line, STEP_IN_STEP, value=self._lines[line - 1].strip()[:60])
            if token.type == "fence":
                self._check_fence(token, line, kind)
            if token.type != "fence" or not kind:
                if token.nesting >= 0:
                    words.append(token)
                continue
            flush()
            items = self._body(token)
            if kind in ("predict", "task", "answer"):
                named = self._name(block_name.strip(), kind, line)
                question, found_items = self._items(items, kind, line)
                if kind == "task":
                    parts.append(_task(named, line, question, found_items))
                else:
                    parts.append(_question(named, line, question, found_items, kind == "predict"))
            elif kind == "state":
                if state is not None:
                    raise refused(line, ONLY_ONCE, "state")
                state = _state(items, line)
            elif kind == "note":
                if note is not None:
                    raise refused(line, ONLY_ONCE, "note")
                note = _note(items, line)
            else:
                samples += [_sample(text, number) for number, text in items if text.strip()]
        flush()
        step = Step(name, title, self._line_of_step, tuple(parts), state, note, tuple(samples))
        known = {part.name for part in step.asked}
        for sample in step.samples:
            if sample.block not in known:
                raise refused(sample.line, ONE_OF, ", ".join(known) or "none", value=sample.block)
        return step

    @property
    def _line_of_step(self) -> int:
        return _line(self._tokens[0], self._first)

    def _check_fence(self, token: Token, line: int, kind: str) -> None:
        if kind and kind not in _KINDS:
            near = difflib.get_close_matches(kind, _KINDS, n=1, cutoff=0.0)[0]
            raise refused(line, NO_BLOCK, kind, near)
        assert token.map is not None
        for number, text in self._body(token):  # its end was forgotten, or it is itself one
            begun = _BLOCK.match(text)
            if begun and begun[1].startswith(token.markup):
                raise refused(line, UNCLOSED_ABOVE if kind else BLOCK_IN_CODE, number)
        last = self._lines[self._first + token.map[1] - 1].strip()
        closed = token.map[1] - token.map[0] >= 2 and set(last) == {token.markup[0]}
        if not closed:
            raise refused(line, UNCLOSED if kind else CODE_UNCLOSED)

    def _body(self, token: Token) -> list[tuple[int, str]]:
        assert token.map is not None
        begin = self._first + token.map[0] + 1
        end = self._first + token.map[1] - 1
        return [(number + 1, self._lines[number]) for number in range(begin, end)]

    def _name(self, given: str, kind: str, line: int) -> str:
        name = given
        if not given:
            count = 1
            name = kind
            while name in self._names:
                count += 1
                name = f"{kind}-{count}"
        if not _NAME.fullmatch(name):
            raise refused(line, BAD_NAME, value=name)
        if name in self._names:
            raise refused(line, TWICE, self._names[name], value=name)
        self._names[name] = line
        return name

    def _items(
        self, body: Sequence[tuple[int, str]], kind: str, line: int
    ) -> tuple[str, list[_Item]]:
        """The question, and what follows it."""
        question: list[str] = []
        items: list[_Item] = []
        for number, text in body:
            indented = text[:1] in (" ", "\t")
            choice = None if indented else _CHOICE.fullmatch(text.rstrip())
            key = _KEY.fullmatch(text.strip())
            if choice and kind in _WITH_CHOICES:
                mark = "right" if choice[1] in "xX" else "false"
                items.append(_Item("choice", mark, choice[2].strip(), number, []))
            elif indented and items:
                self._below(items, key, text.strip(), number, kind)
            elif key and not indented and key[1] in _KEYS[kind]:
                items.append(_Item(key[1], (key[2] or "").strip(), key[3].strip(), number, []))
            elif not items and not _mistyped(text, _KEYS[kind]):
                question.append(text)
            elif kind in _WITH_CHOICES and text.startswith(("-", "*")):
                raise refused(number, NO_CHOICE, value=text.strip()[:60])
            elif text.strip():
                bound = INDENTED if indented else UNEXPECTED
                raise refused(number, bound, ", ".join(_KEYS[kind]), value=text.strip()[:60])
        asked = "\n".join(question).strip()
        if not asked:
            raise refused(line, LACKS, "a question or what is to be done")
        return asked, items

    @staticmethod
    def _below(
        items: list[_Item], key: re.Match[str] | None, text: str, number: int, kind: str
    ) -> None:
        last = items[-1]
        has_own = last.key in ("choice", "wrong")
        if has_own and key and key[1] in _BELOW:
            last.below.append(_Item(key[1], "", key[3].strip(), number, []))
        elif _mistyped(text, (*_BELOW, *_KEYS[kind])):
            bound = UNEXPECTED if has_own else INDENTED
            raise refused(number, bound, ", ".join(_BELOW), value=text[:60])
        elif last.below:
            further = last.below[-1]
            last.below[-1] = further._replace(text=f"{further.text} {text}".strip())
        else:
            items[-1] = last._replace(text=f"{last.text} {text}".strip())


_WITH_CHOICES = ("predict", "answer")
_CHOICE = re.compile(r"[-*]\s+\[([ xX])\]\s+(.*)")
_KEY = re.compile(r"([a-z]+)(\s+[\w-]+)?:(.*)")
_KEYS = {
    "predict": ("show", "check", "why", "hint"),
    "answer": ("value", "unit", "wrong", "check", "why", "hint"),
    "task": ("until", "done", "hint"),
}
_BELOW = ("says", "state")


def _mistyped(text: str, keys: Sequence[str]) -> bool:
    """Whether a line that is not expected to begin with a key seems to."""
    found = re.match(r"([A-Za-z]+)(\s+[\w-]+)?\s*:", text)
    if found is None:
        return False
    near = difflib.get_close_matches(found[1].lower(), keys, n=1, cutoff=0.8)
    # An idea is named behind one key alone: “Check this:” is a sentence.
    return bool(near) and near[0][0] == text[0].lower() and (not found[2] or near[0] == "wrong")


_IDEA = re.compile(r"\s+\{([a-z][\w-]*)\}(?=\s*$|\s+:=\s)")


def slug(title: str) -> str:
    """The name of a step whose title has none."""
    return "-".join(re.findall(r"[^\W_]+", title.lower()))[:60] or "step"


def _state(body: Sequence[tuple[int, str]], line: int) -> State:
    values: list[tuple[int, str]] = []
    document, document_line = "", 0
    names = set[str]()
    for number, text in body:
        text = text.strip()
        if not text:
            continue
        is_document = text.startswith("document:")
        name = "document" if is_document else text.partition("=")[0].strip()
        if name in names:
            raise refused(number, ONLY_ONCE, name)
        names.add(name)
        if is_document:
            document, document_line = _beside(text[len(name) + 1 :].strip(), number), number
        elif "=" in text:
            values.append((number, _mesh_beside(text, number)))
        else:
            raise refused(number, AN_ASSIGNMENT, value=text[:60])
    if not values and not document:
        raise refused(line, LACKS, "NAME=VALUE")
    return State(line, tuple(values), document, document_line)


def _short_state(item: _Item) -> State:
    """A state in one line, its values parted by semicolons."""
    parts = [(item.line, part) for part in item.text.split(";")]
    return _state(parts, item.line)


def _mesh_beside(text: str, line: int) -> str:
    """An assignment, whose file must be beside the lesson if it has one."""
    path, _, value = (part.strip() for part in text.partition("="))
    if path in ("scene", "mesh") and (set(value) & set("/\\:") or value.startswith("~")):
        _beside(value, line)
    return text


def _beside(path: str, line: int) -> str:
    """The path of a file that is in the lesson's folder or below it."""
    parts = re.split(r"[/\\]", path)
    if not path or path[0] in "/\\~" or ".." in parts or ":" in path:
        raise refused(line, BESIDE, value=path[:60])
    return path


def _note(body: Sequence[tuple[int, str]], line: int) -> Note:
    minutes, lines, first = None, [], 0
    for number, text in body:
        if text.strip().startswith("minutes:"):
            if minutes is not None:
                raise refused(number, ONLY_ONCE, "minutes")
            minutes = _number(text.partition(":")[2].strip(), number, 0, 1000)
        elif re.match(r"\s*min\w*\s*[:=]\s*\d", text, re.IGNORECASE):
            raise refused(number, UNEXPECTED, "minutes", value=text.strip()[:60])
        else:
            lines.append(text)
            first = first or (number if text.strip() else 0)
    return Note("\n".join(lines).strip(), line, minutes or 0.0, first or line)


def _sample(text: str, line: int) -> Sample:
    name, colon, rest = text.partition(":")
    sample, arrow, verdict = rest.rpartition("->")
    if not colon or not arrow or not verdict.strip():
        raise refused(line, A_SAMPLE, value=text.strip()[:60])
    return Sample(name.strip(), sample.strip(), verdict.strip(), line)


def _single(items: Sequence[_Item], key: str) -> _Item | None:
    found = [item for item in items if item.key == key]
    if len(found) > 1:
        raise refused(found[1].line, ONLY_ONCE, key)
    return found[0] if found else None


def _texts(items: Sequence[_Item], key: str) -> tuple[str, ...]:
    return tuple(item.text for item in items if item.key == key)


def _all_said(items: Sequence[_Item]) -> tuple[tuple[int, str], ...]:
    """Every sentence behind the question that may hold formulas, with its line."""
    found = [(item.line, item.text) for item in items if item.key in ("why", "hint", "done")]
    for item in items:
        found += [(each.line, each.text) for each in item.below if each.key == "says"]
    return tuple(found)


def _formula(text: str, line: int, what: str) -> Formula:
    with on_line(line, what):
        return parse(text)


def _conditions(items: Sequence[_Item], key: str) -> tuple[tuple[int, Condition], ...]:
    found = []
    for item in items:
        if item.key == key:
            with on_line(item.line, key):
                found.append((item.line, Condition.read(item.text)))
    return tuple(found)


def _said(item: _Item) -> dict[str, Any]:
    """What stands indented below a choice or a wrong value."""
    says, state = _single(item.below, "says"), _single(item.below, "state")
    return {
        "says": says.text if says else "",
        "state": _short_state(state) if state else None,
    }


def _choice(item: _Item) -> Choice:
    """A choice's text, then its formula and its idea in either order."""
    idea = _IDEA.search(item.text)
    text, _, behind = _IDEA.sub("", item.text).partition(" := ")
    if not text.strip():
        raise refused(item.line, LACKS, "a text")
    formula = _formula(behind.strip(), item.line, ":=") if behind.strip() else None
    said = _said(item)
    return Choice(
        text.strip(), item.about == "right", item.line, formula, idea[1] if idea else "", **said
    )


def _question(name: str, line: int, text: str, items: list[_Item], predicts: bool) -> Question:
    choices = tuple(_choice(item) for item in items if item.key == "choice")
    value, show, unit = (_single(items, key) for key in ("value", "show", "unit"))
    why = _single(items, "why")
    if choices and value is not None:
        raise refused(value.line, EITHER)
    if (choices or predicts) and (len(choices) < 2 or sum(each.right for each in choices) != 1):
        raise refused(line, ONE_RIGHT)
    if not choices and value is None:
        raise refused(line, LACKS, "“value: FORMULA”, or choices")
    wrong = tuple(
        Wrong(_formula(item.text, item.line, "wrong"), item.line, item.about, **_said(item))
        for item in items
        if item.key == "wrong"
    )
    return Question(
        name,
        line,
        text,
        predicts,
        choices,
        _formula(value.text, value.line, "value") if value else None,
        unit.text if unit else "",
        wrong,
        _short_state(show) if show else None,
        _conditions(items, "check"),
        why.text if why else "",
        _texts(items, "hint"),
        value.line if value else line,
        _all_said(items),
    )


def _task(name: str, line: int, text: str, items: list[_Item]) -> Task:
    until = _conditions(items, "until")
    if not until:
        raise refused(line, LACKS, "“until: CONDITION”")
    done = _single(items, "done")
    said = done.text if done else ""
    return Task(name, line, text, until, said, _texts(items, "hint"), _all_said(items))
