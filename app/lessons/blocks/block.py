"""The interface of all kinds of block: reading, checking, asking, answering, printing.

A kind is a subclass of `Block`, or of `Asked` if the student answers it. Code that shows or checks
a lesson uses these methods, whatever the kind.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, NamedTuple, Protocol, TypeVar

from app.document.document import Document
from app.document.view import View
from app.lessons.lines import Body, Items
from app.lessons.quantities import Quantities
from app.lessons.state import State
from app.model.refusal import Refusal


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
    def asked(self) -> Mapping[str, Asked]:
        """Return the step's questions and tasks, by name."""

    @property
    def idea_names(self) -> Sequence[str]:
        """Return the names of the wrong ideas that the program knows."""

    def shown_by(self, state: State) -> Document:
        """Return the document of a state that continues the step's own state, or begins anew."""

    def quantities(self, now: Document | None = None, view: View | None = None) -> Quantities:
        """Return the quantities of the step's own state, or of the window's current state."""

    def varied(self, state: State | None, given: Mapping[str, float]) -> Here:
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


@dataclass(frozen=True, kw_only=True)
class Block:
    """A block of a step.

    Attributes
    ----------
    kind : str
        The word after its three backticks.
    once : bool
        Whether a step may have only one block of this kind.
    asks : bool
        Whether the student has to answer it; such a block has a name.
    """

    kind: ClassVar[str] = ""
    once: ClassVar[bool] = False
    needs_answer: ClassVar[bool] = False
    line: int

    @classmethod
    def read(cls, body: Body) -> Block:
        """Read the block; a `Refusal` names the line that is wrong."""
        raise NotImplementedError

    def texts(self) -> Iterator[tuple[int, str]]:
        """Yield every text that may contain formulas, with its line."""
        yield from ()

    def check_names(self, asked: Iterable[str]) -> None:
        """Refuse names that do not match the step's questions and tasks."""

    def check(self, here: Here, trial: Trial) -> None:
        """Try the whole block on the model; a `Refusal` ends the check of this block."""


AnyBlock = TypeVar("AnyBlock", bound=Block)


def of_kind(blocks: Iterable[Block], kind: type[AnyBlock]) -> tuple[AnyBlock, ...]:
    """Return the blocks of a kind, in order."""
    return tuple(block for block in blocks if isinstance(block, kind))


@dataclass(frozen=True, kw_only=True)
class ReadBlock(Block):
    """A block that the student or the class reads.

    Attributes
    ----------
    reveals : bool
        Whether a talk first asks the class and then shows the right answer.
    text, why : str
        Markdown; `why` is shown once the answer is known.
    show : State, optional
        The state that the model then moves to.
    """

    reveals: ClassVar[bool] = False
    text: str
    why: str = ""
    show: State | None = None

    @property
    def is_tall(self) -> bool:
        """Whether a talk's band needs many lines for it."""
        return "$$" in self.text or "\n|" in self.text

    def posed(self) -> str:
        """Return the question as Markdown for a class."""
        return self.text

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        """Return the question with its right answer as Markdown; `answer` is from `answer_text`."""
        return self.text

    def explained(self, answer: str, *, others: bool = True) -> str:
        """Return the text of `told` and the reason."""
        return "\n\n".join(filter(None, (self.with_answer(answer, others=others), self.why)))

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        """Return the right answer if `told` does not already contain it, else an empty text."""
        return ""


class TextBlock(ReadBlock):
    """The text between two blocks."""

    def texts(self) -> Iterator[tuple[int, str]]:
        yield self.line, self.text


@dataclass(frozen=True, kw_only=True)
class Asked(ReadBlock):
    """A block that the student has to answer.

    Attributes
    ----------
    holds : bool
        Whether the step continues only after an answer.
    name : str
        Used by samples and the student's progress; unique within a step.
    said : tuple of (int, str)
        All replies to answers, and the hints, each with its line.
    hides : frozenset of str
        What would show the answer, of `HIDDEN`; it is not seen until there is one.
    """

    needs_answer: ClassVar[bool] = True
    holds: ClassVar[bool] = False
    name: str
    hints: tuple[str, ...] = ()
    responses: tuple[tuple[int, str], ...] = ()
    hides: frozenset[str] = frozenset()

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

    def verdict(self, here: Here, sample: str, line: int) -> str:
        """Return the verdict on a sample answer, as the word in a ``test`` block."""
        raise NotImplementedError

    def drawn(self, here: Here, sample: str) -> str:
        """Return the numbers that an exercise has drawn for a sample that it could mark."""
        return ""
