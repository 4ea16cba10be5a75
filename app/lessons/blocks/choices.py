"""Choices, exactly one right; ``predict`` must be answered before the step goes on."""

import contextlib
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from app.lessons import marking
from app.lessons.blocks.block import REVEALED, Here, Verdict, state_in
from app.lessons.blocks.question import CHECKS, LETTERS, RIGHT, Question, Reply
from app.lessons.lines import Body, Items, LineItem, on_line, refused, whole
from app.lessons.quantities import read_formula
from app.model.formula import Formula
from app.model.refusal import REFUSALS, Refusal

_IDEA = re.compile(r"(?<=\s)\{([a-z][\w-]*)\}(?=\s*$|\s+:=\s)")
_WRITTEN = re.compile(r"[-−]?\d+(?:[.,]\d+)?(?:/\d+)?")


@dataclass(frozen=True, kw_only=True)
class Choice(Reply):
    """One of several answers; its text is Markdown."""

    text: str

    @classmethod
    def read(cls, item: LineItem) -> "Choice":
        """Read a choice: its text, then its formula and its idea in either order."""
        idea = _IDEA.search(item.text)
        text, _, behind = _IDEA.sub("", item.text).partition(":=")
        if not text.strip():
            raise refused(item.line, REFUSALS["lacks"], "a text")
        formulas: tuple[Formula, ...] = ()
        if behind.strip():
            with on_line(item.line, ":="):
                formulas = (read_formula(behind.strip()),)
        more = {"right": item.about == "x", "idea": idea[1] if idea else "", "text": text.strip()}
        return cls.of(item, formulas=formulas, **more)

    def check_number(self, value: float) -> None:
        for text in _WRITTEN.findall(self.text):
            with contextlib.suppress(Refusal):  # what cannot be read is another number
                number = marking.read(text)
                half = number.unit * Fraction("0.5001")
                if abs(number.value - Fraction(value)) <= half + marking.EXACT * abs(number.value):
                    return
        raise refused(self.line, REFUSALS["choices-other-number"], f"{value:.6g}", value=self.text)


@dataclass(frozen=True, kw_only=True)
class Choices(Question):
    is_worked: ClassVar[bool] = False
    replies: tuple[Choice, ...]

    @classmethod
    def of(cls, body: Body, text: str, items: Items, **more: Any) -> "Choices":
        choices = tuple(map(Choice.read, items.every("choice")))
        most = len(LETTERS)
        if not 2 <= len(choices) <= most or sum(each.right for each in choices) != 1:
            raise refused(body.line, REFUSALS["one-right"], most)
        return cls(**cls.fields(body, text, items), replies=choices, **more)

    @property
    def right(self) -> int:
        """Return the index of the right choice."""
        return next(place for place, each in enumerate(self.replies) if each.right)

    @property
    def key(self) -> tuple[tuple[Formula, ...], int]:
        right = self.replies[self.right]
        return right.formulas, right.line

    def texts(self) -> Iterator[tuple[int, str]]:
        yield from super().texts()
        yield from ((each.line, each.text) for each in self.replies)

    def own_answer(self, typed: str) -> str:
        return f"*{self.replies[int(typed) - 1].text}*"

    def right_sample(self, here: Here) -> str:
        return str(self.right + 1)

    def right_text(self, answer: str) -> str:
        return self.replies[self.right].text

    def accepts(self, here: Here, kept: str) -> bool:
        if kept == REVEALED:
            return self.retries
        return kept in [str(number) for number, _ in enumerate(self.replies, 1)]

    def mark(self, here: Here, typed: str) -> Verdict:
        """Return the verdict on a choice, counted from 1."""
        reply = self.replies[int(typed) - 1]
        return reply.verdict(here, self.why) if reply.right else self.reply_to(here, reply)

    def verdict(self, here: Here, sample: str, line: int) -> str:
        number = whole(sample, len(self.replies))
        if not number:
            raise refused(line, REFUSALS["a-number-of"], len(self.replies), value=sample)
        return self.mark(here, str(number)).word

    def _clashes(self, *values: Any) -> Iterator[Refusal]:
        """Yield the refusals of choices with the same text, too."""
        yield from super()._clashes(*values)
        lines = dict[str, int]()
        for each in self.replies:
            before = lines.setdefault(" ".join(each.text.split()), each.line)
            if before != each.line:
                yield refused(each.line, REFUSALS["same-choice"], before, value=each.text)

    def posed(self) -> str:
        return self._listed(lambda _each: True, "")

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        return self._listed(lambda each: others or each.right, RIGHT)

    def _listed(self, is_there: Callable[[Choice], bool], mark: str) -> str:
        lines = [self.text]
        for letter, choice in zip(LETTERS, self.replies, strict=False):
            if is_there(choice):
                lines.append(f"**{letter}** {choice.text}{mark if choice.right else ''}")
        return "  \n".join(lines)


@dataclass(frozen=True, kw_only=True)
class Predict(Choices):
    """A prediction: it is made once, and then the model shows the right answer."""

    kind = "predict"
    holds = True
    retries = False

    @classmethod
    def read(cls, body: Body) -> Choices:
        text, items = body.items("show", *CHECKS, choices=True)
        return cls.of(body, text, items, show=state_in(items.single("show")))
