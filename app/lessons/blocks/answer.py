"""``answer``: a typed number, a matrix, a place, or a choice that may be repeated."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from app.lessons import marking
from app.lessons.blocks.block import Here
from app.lessons.blocks.choices import Choices
from app.lessons.blocks.click import Click
from app.lessons.blocks.matrix import Matrix
from app.lessons.blocks.question import CHECKS, RIGHT, Marked, Question, Reply, Verdict, said_below
from app.lessons.lines import LACKS, Body, refused
from app.model.refusal import QT_TRANSLATE_NOOP

EITHER = QT_TRANSLATE_NOOP("Refusal", "gives the answer in a second way: keep one of {0}")
WAYS = ("value", "matrix", "click", "choice")
"""The keys by which an answer may be given."""


@dataclass(frozen=True, kw_only=True)
class Answer(Marked):
    """A question whose answer is the value of a formula."""

    kind = "answer"

    @classmethod
    def read(cls, body: Body) -> Question:
        keys = ("value", "matrix", "click", "at", "within", "first", "unit", "wrong", *CHECKS)
        text, items = body.items(*keys, choices=True)
        ways = [item for item in items if item.key in WAYS]
        if not ways:
            raise refused(
                body.line, LACKS, "“value: FORMULA”, “matrix: CELLS”, “click: PICTURE”, or choices"
            )
        other = next((item for item in ways if item.key != ways[0].key), None)
        if other is not None:
            raise refused(other.line, EITHER, "value, matrix, click and choices")
        if ways[0].key == "choice":
            return Choices.of(body, text, items)
        if ways[0].key == "click":
            return Click.of(body, text, items)
        if ways[0].key == "matrix":
            return Matrix.of(body, text, items)
        value = items.single("value")
        assert value is not None
        wrong = (item for item in items if item.key == "wrong")
        symbol, _, formula = value.text.rpartition("=")
        return cls(
            **cls.fields(body, text, items),
            symbol=symbol.strip(),
            replies=tuple(
                Reply(line=w.line, formulas=(w.formula(),), idea=w.about, **said_below(w))
                for w in wrong
            ),
            right=(value._replace(text=formula.strip()).formula(),),
            right_line=value.line,
        )

    def answer(self, here: Here) -> float:
        return self.values(here, *self.key)[0]

    def mark(self, here: Here, typed: str) -> Verdict:
        number, value = marking.read(typed, self.unit), self.answer(here)
        if marking.equals(number, value):
            return Verdict(True, says=self.why)
        for wrong in self.replies:
            if marking.equals(number, *self.values(here, wrong.formulas, wrong.line)):
                return wrong.verdict(here)
        too_short = marking.is_too_short(number, value)
        return Verdict(False, too_short=too_short, remark=marking.remark(number, value))

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        unit = self.unit if self.unit in ("", "°") else f" {self.unit}"
        return f"{write(self.answer(here))}{unit}"

    def told(self, answer: str, *, others: bool = True) -> str:
        return f"{self.text}  \n**{answer}**{RIGHT}" if answer else self.text
