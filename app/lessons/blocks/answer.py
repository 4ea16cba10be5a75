"""``answer``: a typed number, or a choice that may be repeated."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from app.lessons import marking
from app.lessons.blocks.block import Here
from app.lessons.blocks.choices import Choices
from app.lessons.blocks.question import CHECKS, RIGHT, Question, Reply, Verdict, said_below
from app.lessons.lines import LACKS, Body, refused
from app.lessons.quantities import FUNCTIONS
from app.model.formula import Call, Formula, Letter, Negative, Number, latex
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

EITHER = QT_TRANSLATE_NOOP("Refusal", "has both choices and a value: keep one of them")


@dataclass(frozen=True, kw_only=True)
class Answer(Question):
    """A question whose answer is the value of a formula."""

    kind = "answer"
    formula: Formula
    formula_line: int
    unit: str

    @classmethod
    def read(cls, body: Body) -> Question:
        text, items = body.items("value", "unit", "wrong", *CHECKS, choices=True)
        value = items.single("value")
        if any(item.key == "choice" for item in items):
            if value is not None:
                raise refused(value.line, EITHER)
            return Choices.of(body, text, items)
        if value is None:
            raise refused(body.line, LACKS, "“value: FORMULA”, or choices")
        wrong = (item for item in items if item.key == "wrong")
        return cls(
            **cls.fields(body, text, items),
            replies=tuple(
                Reply(line=each.line, formula=each.formula(), idea=each.about, **said_below(each))
                for each in wrong
            ),
            formula=value.formula(),
            formula_line=value.line,
            unit=items.text("unit"),
        )

    @property
    def key(self) -> tuple[Formula, int]:
        return self.formula, self.formula_line

    def answer(self, here: Here) -> float:
        return self.value(here, *self.key)

    def mark(self, here: Here, typed: str) -> Verdict:
        """Return the verdict on a typed text; a `Refusal` of ``answer`` if it is not a number."""
        number, value = marking.read(typed, self.unit), self.answer(here)
        if marking.equals(number, value):
            return Verdict(True, says=self.why)
        for wrong in self.replies:
            assert wrong.formula is not None
            if marking.equals(number, self.value(here, wrong.formula, wrong.line)):
                return wrong.verdict(here)
        too_short = marking.is_too_short(number, value)
        return Verdict(False, too_short=too_short, remark=marking.remark(number, value))

    def verdict(self, here: Here, sample: str, line: int) -> str:
        try:
            return self.mark(here, sample).word
        except Refusal as error:
            if error.field != "answer":
                raise
            return "no number"

    def solution(self, here: Here) -> str:
        """Return the way to the answer as Markdown: in letters, with the step's numbers, its value.

        Empty if the formula has no letters: the question itself says the numbers.
        """
        known, terms = self.known(here), dict[str, Formula]()
        for part in self.formula:
            is_name = isinstance(part, Letter) and part.name not in ("pi", "infinity")
            if is_name or (isinstance(part, Call) and part.name not in FUNCTIONS):
                number = Number(abs(Fraction(f"{known.value(part):.4g}")))
                terms[part.text] = number if known.value(part) >= 0.0 else Negative(number)
        if not terms:
            return ""
        value = f"{self.answer(here):.4g}"
        sides = latex(self.formula, {}), latex(self.formula.where(terms), {}), value
        return f"${' = '.join(sides)}$"

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        unit = self.unit if self.unit in ("", "°") else f" {self.unit}"
        return f"{write(self.answer(here))}{unit}"

    def told(self, answer: str, *, others: bool = True) -> str:
        return f"{self.text}  \n**{answer}**{RIGHT}" if answer else self.text
