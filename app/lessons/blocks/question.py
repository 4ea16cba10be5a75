"""The common base of predictions and answers: one right reply, and wrong ones with their ideas."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

from app.document.document import Document
from app.lessons import marking
from app.lessons.blocks.block import Asked, Here, Trial
from app.lessons.lines import Body, Item, Items, on_line, refused
from app.lessons.quantities import Condition, NotThere, Quantities
from app.lessons.state import State, state_in
from app.model.formula import Formula
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

NO_VALUE = QT_TRANSLATE_NOOP("Refusal", "has no value in this state, which has no {0}")
NO_IDEA = QT_TRANSLATE_NOOP(
    "Refusal",
    "names an unknown wrong idea (the nearest is {0}), and has no “says:” of its own",
)
ALSO_RIGHT = QT_TRANSLATE_NOOP("Refusal", "is wrong, but its formula gives the right value, {0}")
SAME_WRONG = QT_TRANSLATE_NOOP("Refusal", "cannot be told from the wrong value of line {0}, {1}")
NOT_SO = QT_TRANSLATE_NOOP("Refusal", "does not hold")

RIGHT = " **✓**"
"""Marks the right answer, in Markdown."""
CHECKS = ("check", "why", "hint")
"""Keys that every question may have."""


class Verdict(NamedTuple):
    """The response to an answer.

    Attributes
    ----------
    idea : str
        Name of the wrong idea behind it; empty if it has none.
    says : str
        Markdown.
    state : Document, optional
        A state that shows what `says` explains.
    too_short : bool
        Whether the answer is right but has too few digits.
    remark : Refusal, optional
        How a number that no idea explains differs from the right one.
    """

    right: bool
    idea: str = ""
    says: str = ""
    state: Document | None = None
    too_short: bool = False
    remark: Refusal | None = None

    @property
    def word(self) -> str:
        """Return the word in a ``test`` block: ``right``, the idea's name, or ``wrong``."""
        return "right" if self.right else self.idea or "wrong"


@dataclass(frozen=True, kw_only=True)
class Reply:
    """An answer that the lesson expects, the formula of its number, and the response to it."""

    line: int
    right: bool = False
    formula: Formula | None = None
    idea: str = ""
    says: str = ""
    state: State | None = None

    def verdict(self, here: Here, why: str = "") -> Verdict:
        """Return the verdict; a known idea supplies sentences and a state if the reply has none."""
        says = self.says
        state = here.shown_by(self.state) if self.state is not None else None
        if self.right:
            return Verdict(True, says=says or why, state=state)
        idea = here.idea(self.idea)
        if idea is not None:
            says = says or idea.says
            state = state or idea.state
        return Verdict(False, self.idea, says, state)

    def check(self, here: Here, trial: Trial) -> None:
        """Report an unknown idea without a sentence, and an impossible state."""
        if self.idea and here.idea(self.idea) is None and not self.says:
            near = difflib.get_close_matches(self.idea, here.idea_names, n=1, cutoff=0.0)[0]
            trial.complain(refused(self.line, NO_IDEA, near, value=self.idea))
        if self.state is not None:
            with trial.kept():
                here.shown_by(self.state)

    def check_number(self, value: float) -> None:
        """Refuse a number in the text that differs from its formula's value."""


def said_below(item: Item) -> dict[str, Any]:
    """Read the sentence and the state indented below a choice or a wrong value."""
    below = Items(item.below)
    return {"says": below.text("says"), "state": state_in(below.single("state"))}


@dataclass(frozen=True, kw_only=True)
class Question(Asked):
    """A question with one right reply.

    Attributes
    ----------
    replies : tuple of Reply
        Choices, or the wrong values that have an idea.
    checks : tuple of (int, Condition)
        Conditions that hold if the right reply is correct.
    """

    reveals: ClassVar[bool] = True
    replies: Sequence[Reply]
    checks: tuple[tuple[int, Condition], ...] = ()

    @staticmethod
    def fields(body: Body, text: str, items: Items) -> dict[str, Any]:
        checks, why = items.conditions("check"), items.text("why")
        return Asked.fields(body, text, items) | {"checks": checks, "why": why}

    @property
    def is_tall(self) -> bool:
        return False  # it is in its own column beside the text

    @property
    def key(self) -> tuple[Formula | None, int]:
        """Return the formula of the right value and its line, if there is one."""
        raise NotImplementedError

    def known(self, here: Here) -> Quantities:
        """Return the quantities for its formulas: of the state that it shows, if it shows one."""
        return here.quantities(here.shown_by(self.show) if self.show is not None else None)

    def value(self, here: Here, formula: Formula, line: int) -> float:
        """Return the value of one of its formulas; a `Refusal` names the line."""
        known = self.known(here)
        with on_line(line, "formula"):
            try:
                return known.value(formula)
            except NotThere as error:
                raise refused(line, NO_VALUE, str(error)) from error

    def check(self, here: Here, trial: Trial) -> None:
        trial.checks += 1
        known = self.known(here)
        for line, condition in self.checks:
            with trial.kept(), on_line(line, "check"):
                if not condition.holds(known):
                    raise refused(line, NOT_SO, value=condition.text)
        for reply in self.replies:
            reply.check(here, trial)
        value, wrong = None, list[tuple[int, float]]()
        for owner, formula, line in self.formulas:
            with trial.kept():
                found = self.value(here, formula, line)
                if owner is not None:
                    with trial.kept():
                        owner.check_number(found)
                if owner is None or owner.right:
                    value = found
                else:
                    wrong.append((line, found))
        for clash in _clashes(value, wrong):
            trial.complain(clash)

    def check_values(self, here: Here) -> None:
        """Refuse a value that does not exist, and wrong ones that equal another one."""
        values = [
            (reply, line, self.value(here, formula, line)) for reply, formula, line in self.formulas
        ]
        value = next((v for reply, _, v in values if reply is None or reply.right), None)
        wrong = [(line, v) for reply, line, v in values if reply is not None and not reply.right]
        for clash in _clashes(value, wrong):
            raise clash

    @property
    def formulas(self) -> Iterator[tuple[Reply | None, Formula, int]]:
        """Yield every formula of a value, with its reply, if it has one, and its line."""
        formula, line = self.key
        right = next((reply for reply in self.replies if reply.right), None)
        if formula is not None:
            yield right, formula, line
        for wrong in self.replies:
            if not wrong.right and wrong.formula is not None:
                yield wrong, wrong.formula, wrong.line


def _clashes(value: float | None, wrong: Sequence[tuple[int, float]]) -> Iterator[Refusal]:
    """Yield the refusals of wrong values that equal the right one, or an earlier wrong one."""
    for place, (line, each) in enumerate(wrong):
        if value is not None and _alike(each, value):
            yield refused(line, ALSO_RIGHT, f"{value:.6g}")
        for before, other in wrong[:place]:
            if _alike(each, other):
                yield refused(line, SAME_WRONG, before, f"{other:.6g}")


def _alike(one: float, other: float) -> bool:
    """Whether two values agree to three significant digits."""
    return marking.equals(marking.read(f"{one:.{marking.DIGITS}g}"), other)
