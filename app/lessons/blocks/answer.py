"""``answer``: a typed number, a matrix, a place, or a choice that may be repeated."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction

from app.languages import said
from app.lessons import marking
from app.lessons.blocks.block import Here, Verdict
from app.lessons.blocks.choices import Choices
from app.lessons.blocks.click import Click
from app.lessons.blocks.matrix import MatrixQuestion
from app.lessons.blocks.order import OrderQuestion
from app.lessons.blocks.question import CHECKS, RIGHT, MarkedQuestion, Question, Reply, Value
from app.lessons.lines import Body, refused
from app.lessons.marking import TypedNumber
from app.model.formula import Formula
from app.model.refusal import REFUSALS, Refusal

WAYS = ("value", "count", "matrix", "click", "order", "choice")  # the keys by which one answers
_ONLY = {  # the ways of answering that other keys belong to
    "at": "click", "within": "click", "first": "matrix", "tiles": "order", "number": "value, count",
    "unit": "value, count, matrix", "wrong": "value, count, matrix, click",
}  # fmt: skip
_KINDS: dict[str, type[Choices | Click | MatrixQuestion | OrderQuestion]] = {
    "choice": Choices, "click": Click, "matrix": MatrixQuestion, "order": OrderQuestion
}  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class Answer(MarkedQuestion):
    """A question whose answer is the value of a formula; of what it `counts`, the exact one."""

    kind = "answer"
    counts: bool = False

    @classmethod
    def read(cls, body: Body) -> Question:
        text, items = body.items(*WAYS[:-1], *_ONLY, *CHECKS, choices=True)
        way = next((item.key for item in items if item.key in WAYS), "")
        if not way:
            kinds = said("“value:”, “count:”, “matrix:”, “click:”, “order:”, or choices")
            raise refused(body.line, REFUSALS["lacks"], kinds)
        for item in items:
            if item.key in WAYS and item.key != way:
                kinds = said("{0} and choices", ", ".join(WAYS[:-1]))
                raise refused(item.line, REFUSALS["answer-either"], kinds)
            if way not in _ONLY.get(item.key, way):
                raise refused(item.line, REFUSALS["of-another-way"], item.key, _ONLY[item.key])
        if way in _KINDS:
            return _KINDS[way].of(body, text, items)
        value = items.single(way)
        assert value is not None
        symbol, _, formula = value.text.rpartition("=")
        return cls(
            **cls.fields(body, text, items),
            symbol=symbol.strip(),
            replies=tuple(
                Reply.of(each, formulas=(each.formula(),)) for each in items.every("wrong")
            ),
            right=(value._replace(text=formula.strip()).formula(),),
            right_line=value.line,
            counts=value.key == "count",
        )

    def answer(self, here: Here) -> float:
        return self.values(here, *self.key)[0]

    def values(self, here: Here, formulas: tuple[Formula, ...], line: int) -> Value:
        values = super().values(here, formulas, line)
        if not self.counts:
            return values
        (value,) = values
        if not (math.isfinite(value) and math.isclose(value, round(value), rel_tol=1e-9)):
            raise refused(line, REFUSALS["not-whole"], f"{value:.6g}")
        return (float(round(value)),)

    def are_alike(self, here: Here, one: Value, other: Value) -> bool:
        return one == other if self.counts else super().are_alike(here, one, other)

    def mark(self, here: Here, typed: str) -> Verdict:
        value = self.answer(here)
        number = marking.read(typed, self.unit, value)
        if self.counts and number.value.denominator > 1:
            raise Refusal("answer", typed, REFUSALS["a-count"])
        is_value = _is_count if self.counts else marking.equals
        if is_value(number, value):
            return Verdict(True, says=self.why)
        wrong = self.mistaken(here, [number], is_value)
        if wrong is None and not self.counts and not marking.is_rounded(number, value):
            wrong = self.mistaken(here, [number], marking.is_rounded)
        too_short = marking.is_too_short(number, value) and not self.counts
        return wrong or Verdict(False, too_short=too_short, remark=marking.remark(number, value))

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        return self.printed([write(self.answer(here))])

    def printed(self, numbers: Sequence[str]) -> str:
        unit = self.unit if self.unit in ("", "°") else f" {self.unit}"
        return super().printed(numbers) + unit

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        return f"{self.text}  \n**{answer}**{RIGHT}" if answer else self.text


def _is_count(typed: TypedNumber, value: float) -> bool:
    return typed.value == Fraction(value)
