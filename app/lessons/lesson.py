"""The file of a lesson or a talk: Markdown with blocks, checked while it is read.

`docs/lessons.md` explains the format to a teacher. A file may come from a stranger: its size is
limited, and a refusal names the line and what was expected there. `app.lessons.blocks` reads the
blocks.
"""

import difflib
import os
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from app import languages
from app.document.codec import Path as AnyPath
from app.document.files import blamed_on, content_of, read_letters
from app.languages import said
from app.lecture.letters import LETTERS, Letters
from app.lessons.blocks import KINDS
from app.lessons.blocks.block import Block, StepContent, TextBlock
from app.lessons.blocks.shown import ShownState
from app.lessons.contents import CONTENT
from app.lessons.lines import LONGEST_LINE, Body, Lines, number_in, refused
from app.lessons.text import markdown
from app.lessons.translating import in_language
from app.model.refusal import REFUSALS, Refusal
from app.strangers import decode, log_warning, open_regular

if TYPE_CHECKING:
    from markdown_it.token import Token

ENDINGS = (".md", ".markdown")  # endings of lesson files
VERSION = 1  # version of the format; a file may state the one it needs (``version: 1``)
LARGEST = 2 * 2**20  # largest file in bytes
MOST_STEPS = 500  # most steps of a talk
_MOST_READ = 20_000  # most lines of a block whose faults are all found; of a longer one, the first


AddFault: TypeAlias = Callable[[Refusal], object]


@dataclass(unsafe_hash=True)
class Step(StepContent):
    name: str
    title: str
    line: int
    blocks: tuple[Block, ...] = ()

    def __post_init__(self) -> None:
        for block in self.blocks:
            block.add_to(self)

    @property
    def varies(self) -> bool:
        """Whether it has an exercise, with other numbers for each seed."""
        return any(part.varies for part in self.asked)


@dataclass(frozen=True)
class Lesson:
    path: Path
    title: str
    steps: tuple[Step, ...]
    lecture: str = ""
    topics: tuple[str, ...] = ()  # ``L1`` to ``L27``
    language: str = ""  # that it states; empty for the program's
    letters: Letters | None = None  # whose letters the formulas use; None for the window's choice
    minutes: float = 0.0  # planned duration of the talk

    @property
    def is_talk(self) -> bool:
        """Whether it is a talk: it has notes for a speaker."""
        return any(step.note is not None for step in self.steps)

    def place_of(self, step: str, otherwise: int = 0) -> int:
        """Return the index of the step with a name, or `otherwise` if there is none."""
        return next((at for at, each in enumerate(self.steps) if each.name == step), otherwise)

    def practises(self, step: Step) -> bool:
        """Whether a step has an exercise, in a lesson that has other steps, too."""
        return step.varies and not all(each.varies for each in self.steps)


# --------------------------------------------------------------------------- reading


def is_lesson(path: str) -> bool:
    return path.lower().endswith(ENDINGS)


def read(path: AnyPath, complain: AddFault | None = None, letters: Letters | None = None) -> Lesson:
    """Read a lesson from its file; a `Refusal` names the line that is wrong.

    `letters` replace those that the lesson asks for. `complain` receives the refusal of every
    faulty block and step; the lesson then lacks these.
    """
    with blamed_on(path, REFUSALS["files-unreadable"]):
        text, note = decode(content_of(path, LARGEST))
        lesson = parse_lesson(_in_language(text, Path(path)), Path(path), complain, letters)
        if note and complain is not None:
            complain(Refusal.in_document(REFUSALS["not-utf8"], file=os.fspath(path)))
        else:
            log_warning(path, note)
        return lesson


def _in_language(text: str, path: Path) -> str:
    """Return a lesson of the program in the language that it speaks; of others, the same text."""
    if path.parent != CONTENT:
        return text
    return in_language(text, partial(languages.sentence_of, path.stem))


class Head(NamedTuple):
    """A lesson's entry in a list of lessons; a talk has its lecture as its topic."""

    path: Path
    title: str
    topics: tuple[str, ...]
    is_talk: bool


def head_of(path: Path) -> Head:
    """Read only the data for a list of lessons."""
    with blamed_on(path, REFUSALS["files-unreadable"]):
        with open_regular(path) as file:
            text, _ = decode(file.read(LARGEST))
        top, _ = _top(text.split("\n"))
        if path.parent == CONTENT:
            top["title"] = languages.sentence_of(path.stem, top["title"])
        is_talk = re.search(r"^(```+|~~~+)\s*note\b", text, re.MULTILINE) is not None
        return Head(path, top["title"], (top["lecture"],) if is_talk else top["topics"], is_talk)


def parse_lesson(
    text: str, path: Path, complain: AddFault | None = None, letters: Letters | None = None
) -> Lesson:
    """Read a lesson from its text, as `read` does; the file need not exist yet."""
    lines = _lines(text)
    top, first = _top(lines)
    asked = letters or top["letters"] or languages.LETTERS.get(top["language"])
    if asked is not None and letters is None and asked not in LETTERS:  # a file beside the lesson
        try:
            asked = read_letters(Path(os.path.dirname(os.path.realpath(path))) / asked)
        except Refusal as error:
            line = next(at for at, each in enumerate(lines, 1) if each.startswith("letters"))
            raise refused(line, REFUSALS["files-unreadable"], str(error).rstrip(".")) from error
    top["letters"] = asked
    return Lesson(path, steps=_steps(lines, first, path, complain), **top)


def _lines(text: str) -> list[str]:
    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", "\ufffd")
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):  # before a regular expression reads it
        if len(line) > LONGEST_LINE:
            raise refused(number, REFUSALS["long-line"], len(line), LONGEST_LINE)
    return lines


_BESIDE = re.compile(r"[\w][\w .-]*\.toml")
_TOPIC = re.compile(r"L([1-9]|1\d|2[0-7])")
_TOP_KEYS = ("title", "lecture", "topic", "language", "letters", "minutes", "version")


def _top(lines: Sequence[str]) -> tuple[dict[str, Any], int]:
    """Read the front matter; return the fields of `Lesson`, and how many lines it takes."""
    if not lines or lines[0].strip() != "---":
        raise refused(1, REFUSALS["top"], value=lines[0][:60] if lines else "")
    values: dict[str, str] = {}
    for number, line in enumerate(lines[1:], 2):
        if line.strip() == "---":
            break
        key, colon, value = (part.strip() for part in line.partition(":"))
        if not line.strip():
            continue
        if line.startswith(("#", "```", "~~~")):
            raise refused(number, REFUSALS["top-unclosed"], value=line[:60])
        if not colon or key not in _TOP_KEYS:
            raise refused(number, REFUSALS["unexpected"], ", ".join(_TOP_KEYS), value=line[:60])
        if key in values:
            raise refused(number, REFUSALS["only-once"], key)
        values[key] = value
        _check_top(key, value, number)
    else:
        raise refused(len(lines), REFUSALS["top"])
    title = values.get("title", "")
    if not title:
        raise refused(1, REFUSALS["no-title"])
    if len(title) > 2 and title[0] == title[-1] and title[0] in "\"'":  # as in YAML
        title = title[1:-1]
    return {
        "title": title,
        "lecture": values.get("lecture", ""),
        "topics": tuple(_parted(values.get("topic", ""))),
        "language": values.get("language", ""),
        "letters": values.get("letters"),
        "minutes": float(values.get("minutes", 0.0)),
    }, number


def _check_top(key: str, value: str, line: int) -> None:
    if key == "version":
        wanted = number_in(value, line, 1, 1e6)
        if wanted > VERSION:
            raise refused(line, REFUSALS["lesson-newer"], f"{wanted:g}", VERSION)
    elif key == "minutes":
        number_in(value, line, 0, 1000)
    elif key == "letters" and value not in LETTERS and not _BESIDE.fullmatch(value):
        raise refused(line, REFUSALS["letters-of"], ", ".join(LETTERS), value=value)
    elif key == "language" and value not in languages.LANGUAGES:
        raise refused(line, REFUSALS["one-of"], ", ".join(languages.LANGUAGES), value=value)
    elif key == "topic" and not all(map(_TOPIC.fullmatch, _parted(value))):
        raise refused(line, REFUSALS["topics"], value=value)


def _parted(text: str) -> list[str]:
    return [part.strip() for part in text.split(",") if part.strip()]


# --------------------------------------------------------------------------- steps

_NAME = re.compile(r"[^\W_][\w-]*")
_OWN_NAME = re.compile(r"\{#([^{}]*)\}$")
_BLOCK = re.compile(rf"\s*(```+|~~~+)\s*({'|'.join(KINDS)})\b")


def slug(title: str) -> str:
    """Return the name of a step whose title has none."""
    return "-".join(re.findall(r"[^\W_]+", title.lower()))[:60] or "step"


def _steps(
    lines: Sequence[str], first: int, path: Path, complain: AddFault | None
) -> tuple[Step, ...]:
    steps: list[Step] = []
    names: dict[str, int] = {}

    def at_fault(error: Refusal) -> None:
        if complain is None:
            raise error
        error.file = str(path)
        complain(error)

    for group, _ in _groups(lines, first):
        try:
            if group:
                step = _StepReader(lines, first, group, at_fault).step()
                if step is not None:
                    _claim(names, step.name, step.line)
                    steps.append(step)
        except Refusal as error:
            at_fault(error)
    if not steps and complain is None:
        raise refused(first, REFUSALS["no-steps"])
    return tuple(steps)


def _claim(names: dict[str, int], name: str, line: int) -> None:
    """Record the line of a name; refuse a name that is already used."""
    if name in names:
        raise refused(line, REFUSALS["lesson-twice"], names[name], value=name)
    names[name] = line


def _groups(lines: Sequence[str], first: int) -> "list[tuple[list[Token], int]]":
    """Split the file at its ``---`` lines; return the tokens and the last line of each step."""
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
                raise refused(_line(token, first), REFUSALS["too-many-steps"], MOST_STEPS)
        else:
            group.append(token)
    return [*groups, (group, len(lines))]


def ends(text: str) -> list[int]:
    """Return the line at which each step of a lesson ends, where another can be inserted."""
    lines = _lines(text)
    _, first = _top(lines)
    return [end for group, end in _groups(lines, first) if group]


def _line(token: "Token", first: int) -> int:
    assert token.map is not None
    return token.map[0] + first + 1


def _read_whole(kind: type[Block], body: Body) -> tuple[Block | None, list[Refusal]]:
    """Read a block; return it, or its faults, all if it is not too long.

    A line with a fault is left out to find the next one, with the indented lines below it. Then a
    fault of the block as a whole is only what the missing line causes, and ends the search.
    """
    faults: list[Refusal] = []
    lines = list(body.lines)
    while len(faults) * len(lines) < _MOST_READ:
        try:
            block = kind.read(body._replace(lines=lines))
        except Refusal as error:
            match = re.match(r"line (\d+)", error.field)
            numbers = [number for number, _ in lines]
            at = numbers.index(int(match[1])) if match and int(match[1]) in numbers else None
            if at is None:
                return None, faults or [error]
            faults.append(error)
            while at and lines[at][1][:1] in (" ", "\t"):
                at -= 1
            if lines[at][1].startswith("vary"):  # the other lines use its name
                break
            del lines[at]
            while at < len(lines) and lines[at][1][:1] in (" ", "\t"):
                del lines[at]
        else:
            return (None if faults else block), faults
    return None, faults


class _StepReader:
    def __init__(
        self, lines: Sequence[str], first: int, tokens: "Sequence[Token]", complain: AddFault
    ) -> None:
        self._lines, self._first, self._tokens = lines, first, tokens
        self._add_fault = complain
        self._lacking: list[str] = []  # the kinds of the blocks that cannot be read
        self._names: dict[str, int] = {}
        self._blocks: list[Block] = []
        self._words: list[Token] = []

    def step(self) -> Step | None:
        """Return the step with the blocks that can be read; None if its state cannot be."""
        name, title, line = self._heading()
        for token in self._tokens[1:]:
            self._take(token)
        self._end_words()
        step = Step(name, title, line, tuple(self._blocks))
        names = [part.name for part in step.asked]
        for sample in step.samples if not self._lacking else ():
            if sample.block not in names:
                raise refused(
                    sample.line,
                    REFUSALS["one-of"],
                    ", ".join(names) or said("none"),
                    value=sample.block,
                )
        return None if ShownState.kind in self._lacking else step

    def _heading(self) -> tuple[str, str, int]:
        heading = self._tokens[0]
        line = _line(heading, self._first)
        text = self._lines[line - 1]
        mark, *rest = text.split(None, 1)
        whole = "".join(rest).rstrip().rstrip("#").rstrip()  # a title may end with #
        match = _OWN_NAME.search(whole)
        title = whole[: match.start()].rstrip() if match is not None else whole
        if heading.type != "heading_open" or heading.tag != "h1" or mark != "#" or not title:
            raise refused(line, REFUSALS["no-heading"], value=text[:60])
        name = match[1].strip() if match is not None else slug(title)
        if not _NAME.fullmatch(name):
            raise refused(line, REFUSALS["lesson-bad-name"], value=name)
        return name, title, line

    def _take(self, token: "Token") -> None:
        """Add a token to the text, or read it as a block."""
        kind, _, given = token.info.strip().partition(" ")
        line = _line(token, self._first)
        if token.type == "code_block" and _BLOCK.match(token.content):
            raise refused(line, REFUSALS["block-indented"])
        if token.type == "heading_open" and token.tag == "h1":
            raise refused(line, REFUSALS["step-in-step"], value=self._lines[line - 1].strip()[:60])
        if token.type == "fence":
            self._check_fence(token, line, kind)
        if token.type != "fence" or not kind:
            if token.nesting >= 0:
                self._words.append(token)
            return
        self._end_words()
        try:
            cls, body = self._opened(token, kind, given.strip(), line)
            block, faults = _read_whole(cls, body)
        except Refusal as error:
            block, faults = None, [error]
        if block is not None:
            self._blocks.append(block)
            return
        self._lacking.append(kind)
        for fault in faults:
            self._add_fault(fault)

    def _opened(self, token: "Token", kind: str, given: str, line: int) -> tuple[type[Block], Body]:
        """Return the kind of a block and its unread lines."""
        if kind not in KINDS:
            near = difflib.get_close_matches(kind, KINDS, n=1, cutoff=0.0)[0]
            raise refused(line, REFUSALS["no-block"], kind, near)
        cls = KINDS[kind]
        if cls.once and kind in [block.kind for block in self._blocks]:
            raise refused(line, REFUSALS["only-once"], kind)
        name = self._name(given, kind, line) if cls.needs_answer else ""
        return cls, Body(kind, name, line, self._body(token))

    def _end_words(self) -> None:
        if self._words:
            begin, end = self._words[0].map[0], self._words[-1].map[1]  # type: ignore[index]
            text = "\n".join(self._lines[self._first + begin : self._first + end])
            self._blocks.append(TextBlock(line=self._first + begin + 1, text=text))
            self._words = []

    def _check_fence(self, token: "Token", line: int, kind: str) -> None:
        assert token.map is not None
        for number, text in self._body(token):  # its end is missing, or it is itself an end
            begun = _BLOCK.match(text)
            if begun and begun[1].startswith(token.markup):
                raise refused(
                    line, REFUSALS["unclosed-above"] if kind else REFUSALS["block-in-code"], number
                )
        last = self._lines[self._first + token.map[1] - 1].strip()
        closed = token.map[1] - token.map[0] >= 2 and set(last) == {token.markup[0]}
        if not closed:
            raise refused(line, REFUSALS["lesson-unclosed"] if kind else REFUSALS["code-unclosed"])

    def _body(self, token: "Token") -> Lines:
        assert token.map is not None
        begin = self._first + token.map[0] + 1
        end = self._first + token.map[1] - 1
        return [(number + 1, self._lines[number]) for number in range(begin, end)]

    def _name(self, given: str, kind: str, line: int) -> str:
        """Return a block's name: the given one, or its kind, numbered if that is taken."""
        name, count = given or kind, 1
        while not given and name in self._names:
            count += 1
            name = f"{kind}-{count}"
        if not _NAME.fullmatch(name):
            raise refused(line, REFUSALS["lesson-bad-name"], value=name)
        _claim(self._names, name, line)
        return name
