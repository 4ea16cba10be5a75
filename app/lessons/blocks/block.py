"""What every kind of block is to the rest of the program: read, checked, asked, answered, printed.

A kind is a subclass of `Block`, or of `Asked` if the student answers it. Whoever shows or checks a
lesson uses these methods and does not ask for the kind.
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
    """A wrong idea that students have: Markdown against it, and a state that shows it."""

    name: str
    title: str
    says: str
    state: Document


class Here(Protocol):
    """The step that a block stands in, as a state of the model."""

    @property
    def document(self) -> Document:
        """Return the step's own state; a `Refusal` names the line that makes it impossible."""

    @property
    def asked(self) -> Mapping[str, Asked]:
        """Return what the step asks, by name."""

    @property
    def idea_names(self) -> Sequence[str]:
        """Return the names of the wrong ideas that the program knows."""

    def shown_by(self, state: State) -> Document:
        """Return a state that goes on from the step's own, or begins anew."""

    def quantities(self, now: Document | None = None, view: View | None = None) -> Quantities:
        """Return the names of formulas over the step's own state, or over the window's now."""

    def idea(self, name: str) -> Idea | None:
        """Return the wrong idea of a name, if the program knows it."""


@dataclass
class Trial:
    """What was tried of a lesson, and what is wrong with it."""

    path: Path
    checks: int = 0
    wrong: list[Refusal] = field(default_factory=list)

    def complain(self, error: Refusal) -> None:
        """Add what is wrong; once, for all steps that go on from a wrong one."""
        error.file = str(self.path)
        if str(error) not in map(str, self.wrong):
            self.wrong.append(error)

    @contextmanager
    def kept(self) -> Iterator[None]:
        """Add what is refused, and go on."""
        try:
            yield
        except Refusal as error:
            self.complain(error)


@dataclass(frozen=True, kw_only=True)
class Block:
    """A block of a step.

    Attributes
    ----------
    kind : str
        The word behind its three backticks.
    once : bool
        Whether a step has at most one of the kind.
    asks : bool
        Whether the student has to answer it: then the block has a name.
    """

    kind: ClassVar[str] = ""
    once: ClassVar[bool] = False
    asks: ClassVar[bool] = False
    line: int

    @classmethod
    def read(cls, body: Body) -> Block:
        """Read the block; a `Refusal` names the line that is wrong."""
        raise NotImplementedError

    def texts(self) -> Iterator[tuple[int, str]]:
        """Yield every text that may hold formulas, with its line."""
        yield from ()

    def check_names(self, asked: Iterable[str]) -> None:
        """Refuse what does not fit the names of what the step asks."""

    def check(self, here: Here, trial: Trial) -> None:
        """Try everything in it over the model; a `Refusal` ends the check of this block."""


AnyBlock = TypeVar("AnyBlock", bound=Block)


def of_kind(blocks: Iterable[Block], kind: type[AnyBlock]) -> tuple[AnyBlock, ...]:
    """Return the blocks of a kind, in their order."""
    return tuple(block for block in blocks if isinstance(block, kind))


@dataclass(frozen=True, kw_only=True)
class Part(Block):
    """A block that student and class read.

    Attributes
    ----------
    reveals : bool
        Whether a talk first puts it to the class and then tells what is right.
    text, why : str
        Markdown; the reason is read once the answer is known.
    show : State, optional
        The state that the model goes to then.
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
        """Return what is asked, as Markdown for a class."""
        return self.text

    def told(self, answer: str, *, others: bool = True) -> str:
        """Return it with what is right, as Markdown; `answer` is that of `answer_text`."""
        return self.text

    def explained(self, answer: str, *, others: bool = True) -> str:
        """Return what `told` does, and the reason."""
        return "\n\n".join(filter(None, (self.told(answer, others=others), self.why)))

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        """Return what is right where the text does not say it; empty where it does."""
        return ""


class Words(Part):
    """The text between two blocks."""

    def texts(self) -> Iterator[tuple[int, str]]:
        yield self.line, self.text


@dataclass(frozen=True, kw_only=True)
class Asked(Part):
    """A block that the student has to answer.

    Attributes
    ----------
    holds : bool
        Whether the step goes on only when it is answered.
    name : str
        For samples and the student's progress; a step has no two of a name.
    said : tuple of (int, str)
        Everything said to an answer, and the hints, each with its line.
    """

    asks: ClassVar[bool] = True
    holds: ClassVar[bool] = False
    name: str
    hints: tuple[str, ...] = ()
    said: tuple[tuple[int, str], ...] = ()

    def texts(self) -> Iterator[tuple[int, str]]:
        yield self.line + 1, self.text  # below the block's first line
        yield from self.said

    @staticmethod
    def fields(body: Body, text: str, items: Items) -> dict[str, Any]:
        """Return what every block that asks takes from its body, by field."""
        return {
            "name": body.name,
            "line": body.line,
            "text": text,
            "hints": items.texts("hint"),
            "said": items.sentences(),
        }

    def verdict(self, here: Here, sample: str, line: int) -> str:
        """Return the verdict on a sample answer, in the word that a ``test`` block expects."""
        raise NotImplementedError
