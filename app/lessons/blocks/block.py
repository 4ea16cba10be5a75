"""The interface of all kinds of block: reading, checking, asking, answering, printing.

A kind is a subclass of `Block`, or of `Asked` if the student answers it. Code that shows or checks
a lesson uses these methods, whatever the kind.
"""

import re
from abc import abstractmethod
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Any, ClassVar, NamedTuple, Protocol

from app.document.document import Document
from app.document.settings import assignments_in
from app.document.view import View
from app.lessons.lines import Body, Items, LineItem, Lines, refused
from app.lessons.quantities import Quantities
from app.lessons.text import escaped
from app.model.refusal import REFUSALS, Refusal


class State(NamedTuple):
    """A state: ``NAME=VALUE`` lines with their numbers, or a document beside the file."""

    line: int
    values: tuple[tuple[int, str], ...] = ()
    document: str = ""
    document_line: int = 0

    @property
    def begins_anew(self) -> bool:
        """Whether it names a scene or a document, and so ignores the previous step."""
        return bool(self.document) or any(path_of(text) == "scene" for _, text in self.values)


def path_of(assignment: str) -> str:
    return assignment.partition("=")[0].strip()


def read_state(lines: Lines, line: int) -> State:
    values: list[tuple[int, str]] = []
    document, document_line = "", 0
    names = set[str]()
    for number, text in lines:
        text = text.strip()
        if not text:
            continue
        is_document = text.startswith("document:")
        name = "document" if is_document else path_of(text)
        if name in names:
            raise refused(number, REFUSALS["only-once"], name)
        names.add(name)
        if is_document:
            document, document_line = _beside(text[len(name) + 1 :].strip(), number), number
        elif "=" in text:
            values.append((number, _mesh_beside(text, number)))
        else:
            raise refused(number, REFUSALS["an-assignment"], value=text[:60])
    if not values and not document:
        raise refused(line, REFUSALS["lacks"], "NAME=VALUE")
    return State(line, tuple(values), document, document_line)


def state_in(item: LineItem | None) -> State | None:
    """Read a state on one line, its values separated by semicolons."""
    if item is None:
        return None
    return read_state([(item.line, part) for part in assignments_in(item.text)], item.line)


def _mesh_beside(text: str, line: int) -> str:
    """Return an assignment; refuse one that names a file outside the lesson's folder."""
    value = text.partition("=")[2].strip()
    is_file = bool(set(value) & set("/\\:")) or value.startswith("~")
    if path_of(text) in ("scene", "mesh") and is_file:
        _beside(value, line)
    return text


def _beside(path: str, line: int) -> str:
    """Return the path of a file that is in the lesson's folder or below it."""
    if not path or path[0] in "/\\~" or ".." in re.split(r"[/\\]", path) or ":" in path:
        raise refused(line, REFUSALS["beside"], value=path[:60])
    return path


REVEALED = "told"  # kept as the answer if the program has shown it


class Idea(NamedTuple):
    """A common wrong idea: Markdown that refutes it, and a state that shows the refutation."""

    name: str
    title: str
    says: str
    state: Document


class Here(Protocol):
    """The step that contains a block, as a state of the model."""

    @property
    def document(self) -> Document:
        """Return the step's own state; a `Refusal` names the line that makes it impossible."""

    @property
    def given(self) -> Mapping[str, float]:
        """Return the numbers with names of their own that an exercise has drawn."""

    @property
    def asked(self) -> "Mapping[str, Asked]":
        """Return the step's questions and tasks, by name."""

    @property
    def idea_names(self) -> Sequence[str]:
        """Return the names of the wrong ideas that the program knows."""

    def shown_by(self, state: State) -> Document:
        """Return the document of a state that continues the step's own state, or begins anew."""

    def quantities(self, now: Document | None = None, view: View | None = None) -> Quantities:
        """Return the quantities of the step's own state, or of the window's current state."""

    def varied(self, state: State | None, given: Mapping[str, float]) -> "Here":
        """Return the step in another state of its own, with names for some numbers."""

    def idea(self, name: str) -> Idea | None:
        """Return the wrong idea with this name, if the program knows it."""


@dataclass
class Trial:
    """The progress of a check: what was tried, and the faults found, by their sentences.

    A warning is about what the check cannot know to be right.
    """

    path: Path
    checks: int = 0
    wrong: dict[str, Refusal] = field(default_factory=dict)
    warnings: list[Refusal] = field(default_factory=list)

    def add_fault(self, error: Refusal) -> None:
        """Add a fault, but only once for all steps that continue a faulty one."""
        error.file = str(self.path)
        self.wrong.setdefault(str(error), error)

    def add_warning(self, error: Refusal) -> None:
        error.file = str(self.path)
        self.warnings.append(error)

    @contextmanager
    def kept(self) -> Iterator[None]:
        """Record a refusal, and continue."""
        try:
            yield
        except Refusal as error:
            self.add_fault(error)


class Verdict(NamedTuple):
    """The response to an answer."""

    right: bool
    idea: str = ""  # name of the wrong idea behind it; empty if it has none
    says: str = ""  # Markdown
    state: Document | None = None  # a state that shows what `says` explains
    too_short: bool = False  # whether the answer is right but has too few digits
    remark: Refusal | None = None  # how an answer that no idea explains differs from the right one
    cells: tuple[bool, ...] = ()  # which numbers of a matrix are right, row after row
    beside: Document | None = None  # a state that shows the idea's number beside the model's own
    title: str = ""  # the idea in the student's words

    @property
    def word(self) -> str:
        """Return the word in a ``test`` block: ``right``, the idea's name, or ``wrong``."""
        return "right" if self.right else self.idea or "wrong"


class Sample(NamedTuple):
    """A sample answer to a block, or values to set in a task, and the expected verdict."""

    block: str
    text: str
    verdict: str
    line: int


class SpeakerNote(NamedTuple):
    """What only the speaker reads at a step, and the planned minutes."""

    line: int
    text: str
    minutes: float


@dataclass
class StepContent:
    """The content of a step, to which each block adds itself."""

    parts: "list[ReadBlock]" = field(default_factory=list, init=False, compare=False)
    """Everything that the student reads and answers; `words` and `asked` are among them."""
    words: "list[TextBlock]" = field(default_factory=list, init=False, compare=False)
    asked: "list[Asked]" = field(default_factory=list, init=False, compare=False)
    samples: list[Sample] = field(default_factory=list, init=False, compare=False)
    state: State | None = field(default=None, init=False, compare=False)
    """None if it shows the previous step's."""
    note: SpeakerNote | None = field(default=None, init=False, compare=False)


@dataclass(frozen=True, kw_only=True)
class Block:
    kind: ClassVar[str] = ""  # the word after its three backticks
    once: ClassVar[bool] = False  # whether a step may have only one block of this kind
    needs_answer: ClassVar[bool] = False  # the student has to answer it; such a block has a name
    line: int

    @classmethod
    def read(cls, body: Body) -> "Block":
        """Read a block; a `Refusal` names the line that is wrong."""
        raise NotImplementedError  # not abstract, or `type[Asked]` could be no key of the views

    def add_to(self, content: StepContent) -> None:
        """Add the block to what the step shows, asks, or says to a speaker or a check."""

    def texts(self) -> Iterator[tuple[int, str]]:
        """Yield every text that may contain formulas, with its line."""
        yield from ()

    def check(self, here: Here, trial: Trial) -> None:
        """Try the whole block on the model; a `Refusal` ends the check of this block."""


@dataclass(frozen=True, kw_only=True)
class ReadBlock(Block):
    reveals: ClassVar[bool] = False  # whether a talk asks the class before it shows the answer
    text: str
    why: str = ""  # Markdown; `why` is shown once the answer is known
    show: State | None = None  # the state that the model then moves to

    def add_to(self, content: StepContent) -> None:
        content.parts.append(self)

    def posed(self) -> str:
        """Return the question as Markdown for a class."""
        return self.text

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        """Return the question with its right answer as Markdown; `answer` is from `answer_text`."""
        return self.text

    def explained(self, answer: str, *, others: bool = True) -> str:
        """Return the text of `with_answer` and the reason."""
        return "\n\n".join(filter(None, (self.with_answer(answer, others=others), self.why)))

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        """Return the right answer if `with_answer` lacks it, else an empty text."""
        return ""


class TextBlock(ReadBlock):
    """The text between two blocks."""

    def add_to(self, content: StepContent) -> None:
        super().add_to(content)
        content.words.append(self)

    def texts(self) -> Iterator[tuple[int, str]]:
        yield self.line, self.text


class Variant(NamedTuple):
    """A question or a task with its numbers, and the step with its state."""

    seed: int
    numbers: Mapping[str, Fraction]
    question: "Asked"
    here: Here


@dataclass(frozen=True, kw_only=True)
class Asked(ReadBlock):
    """A block that the student has to answer."""

    needs_answer: ClassVar[bool] = True
    holds: ClassVar[bool] = False  # whether the step continues only after an answer
    retries: ClassVar[bool] = True  # whether the student may answer again after a wrong answer
    varies: ClassVar[bool] = False  # whether its numbers are drawn anew for each seed
    has_field: ClassVar[bool] = True
    """Whether the student answers in the block itself, where the cursor can be."""
    is_worked: ClassVar[bool] = True  # whether the student works the answer out on paper
    name: str  # used by samples and the student's progress; unique within a step
    unit: str = ""  # the unit of the answer, one of `UNITS`
    pane: str = ""  # the picture in which the student points at the answer; empty for other answers
    hints: tuple[str, ...] = ()
    responses: tuple[tuple[int, str], ...] = ()  # all replies to answers, and hints, by line
    replies: Sequence[Any] = ()
    """The answers that the lesson expects, each with its idea and what the lesson `says` to it."""
    hides: frozenset[str] = frozenset()
    """What would show the answer, of `HIDDEN`; it is not seen until there is one."""

    def add_to(self, content: StepContent) -> None:
        super().add_to(content)
        content.asked.append(self)

    def texts(self) -> Iterator[tuple[int, str]]:
        yield self.line + 1, self.text  # below the block's first line
        yield from self.responses

    @staticmethod
    def fields(body: Body, text: str, items: Items) -> dict[str, Any]:
        """Return the fields that all such blocks read from their body."""
        return {
            "name": body.name,
            "line": body.line,
            "text": text,
            "hints": items.texts("hint"),
            "responses": items.sentences(),
        }

    @abstractmethod
    def verdict(self, here: Here, sample: str, line: int) -> str:
        """Return the verdict on a sample answer, as the word in a ``test`` block."""

    def drawn(self, here: Here, sample: str) -> str:
        """Return the numbers that an exercise has drawn for a sample that it could mark."""
        return ""

    def variant(self, here: Here, seed: int) -> Variant:
        """Return the block for a seed; a `Refusal` if no numbers suit."""
        return Variant(0, {}, self, here)

    def check_tried(self, verdicts: Collection[str], trial: Trial) -> None:
        """Report an answer that no sample gives; `verdicts` are those of the samples."""

    # -- the student's answer

    @property
    def handles(self) -> frozenset[str]:
        """The handles of the world that change what it is about, by name or setting."""
        return frozenset()

    def mark(self, here: Here, typed: str) -> Verdict:
        """Return the verdict on an answer; a `Refusal` of ``answer`` if it cannot be read.

        A task is solved in the window: nothing that is typed solves it.
        """
        return Verdict(False)

    def accepts(self, here: Here, kept: str) -> bool:
        """Whether a kept answer, perhaps of an older lesson, settles the question."""
        return False

    def is_done(self, here: Here, now: Document, view: View | None = None) -> bool:
        """Whether the window's current state is the answer; a `Refusal` names the line."""
        return False

    def verdict_in(
        self, here: Here, now: Document, view: View | None = None
    ) -> tuple[int, Verdict] | None:
        """Return the line of the wrong idea behind the window's state, and the verdict on it."""
        return None

    def is_about(self, change: str) -> bool:
        """Whether a change of the document, as an assignment, belongs to the answer."""
        return True

    def own_answer(self, typed: str) -> str:
        """Return a student's answer as Markdown."""
        return f"**{escaped(typed)}**"

    def response_to(self, here: Here, idea: str) -> Verdict:
        """Return the response to a wrong idea; without words if no reply is to it."""
        verdicts = (each.verdict(here) for each in self.replies if each.idea == idea)
        return next(verdicts, Verdict(False, idea))

    # -- the right answer

    @property
    def answer_line(self) -> int:
        """The line that states the right answer."""
        return self.line

    @property
    def can_be_revealed(self) -> bool:
        """Whether the program knows an answer that it can show."""
        return True

    def right_sample(self, here: Here) -> str:
        """Return the right answer as in a sample; empty if it has no value."""
        return ""

    def right_text(self, answer: str) -> str:
        """Return the right answer as Markdown; `answer` is from `answer_text`."""
        return f"\n\n{answer}" if "\n" in answer else answer and f"**{answer}**"

    def solution(self, here: Here) -> str:
        """Return the way to the answer as Markdown; empty if there is none."""
        return ""

    def reasons(self, here: Here) -> Iterator[str]:
        """Yield what explains the right answer once it is known, as Markdown."""
        yield self.why

    # -- on paper

    @property
    def is_on_paper(self) -> bool:
        """Whether it can be solved on paper, rather than in the window."""
        return False

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of the numbers that are written as the answer; none for a place."""
        return 1, 1

    def marked_place(self, here: Here) -> tuple[tuple[float, ...], float] | None:
        """Return the right place in a picture, and its tolerance as a part of the width."""
        return None

    def mistakes(self, here: Here, write: Callable[[float], str]) -> Iterator[tuple[str, str]]:
        """Yield the names of the wrong ideas, and the answer that each leads to."""
        yield from ()
