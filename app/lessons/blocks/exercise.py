"""``exercise``: a question or a task whose numbers are drawn anew for each seed.

An exercise is a recipe. For a seed it draws the numbers of its ``vary`` lines, writes them into its
text, and so becomes an ordinary ``answer`` or ``task`` in a state of its own. The same seed gives
the same numbers on every machine.
"""

import math
import random
import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import NamedTuple

from app.document.settings import assignments_in
from app.languages import said
from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Asked, Here, State, Trial, Variant, read_state
from app.lessons.blocks.question import Question, hidden_in
from app.lessons.blocks.task import Task
from app.lessons.lines import Body, Lines, continued, mistyped, on_line, refused, whole
from app.lessons.marking import are_alike
from app.lessons.quantities import WITHOUT_VALUE, Condition, rational
from app.model.formula import parse
from app.model.refusal import REFUSALS, Refusal

MOST_NAMES, MOST_VALUES = 8, 1000
LEAST_VARIANTS = 20  # fewer variants are learnt by heart
LARGEST_SEED = 9999
_DRAWS = 200  # how often numbers are drawn until they suit; one in seven does in every seed
SEEDS, _WHOLE = 200, 5  # how many seeds a check draws; for how many it checks the whole question


_VARY = re.compile(r"vary\s+([^\W\d_]\w*)\s*:(.*)")
_KEYS = "vary", "where", "state", "hide"
_OWN = re.compile(rf"({'|'.join(_KEYS[1:])})\s*:(.*)")
_DRAWN = re.compile(r"\{([=~])([^{}]*)\}")
"""A formula; ``{~...}`` stands for its sign, equal or nearly equal, and its value."""
_IN_FULL = re.compile(r"\s*(?:right|state|tiles|order(?: \w+)?):")  # whose numbers have all digits


class Varied(NamedTuple):
    """A number that is drawn from some values."""

    name: str
    values: tuple[Fraction, ...]


@dataclass(frozen=True, kw_only=True)
class Exercise(Asked):
    """A recipe for questions; `recipe` is the body of each, before the numbers are written in."""

    kind = "exercise"
    varies = True
    varied: tuple[Varied, ...]
    where: tuple[tuple[int, Condition], ...]  # what the numbers must fulfil in the variant's state
    states: Lines  # the lines of the variant's state
    recipe: Lines

    @classmethod
    def read(cls, body: Body) -> "Exercise":
        varied: list[Varied] = []
        where: list[tuple[int, Condition]] = []
        states: list[tuple[int, str]] = []
        recipe: list[tuple[int, str]] = []
        hides: set[str] = set()
        for line, text in _continued(body.lines):
            vary, own = _VARY.fullmatch(text), _OWN.fullmatch(text)
            if vary is not None:
                varied.append(_varied(vary[1], vary[2].strip(), line, varied))
            elif own is not None and own[1] == "where":
                with on_line(line, "where"):
                    where.append((line, Condition.read(own[2].strip())))
            elif own is not None and own[1] == "hide":
                hides |= hidden_in(own[2], line)
            elif own is not None:
                states += [(line, part) for part in assignments_in(own[2])]
            elif mistyped(text, _KEYS):
                raise refused(line, REFUSALS["unexpected"], ", ".join(_KEYS), value=text[:60])
            elif opened := re.search(r"\{[=~](?![^{}]*\})", text):
                raise refused(line, REFUSALS["lacks"], "“{=FORMULA}”", value=text[opened.start() :])
            else:
                recipe.append((line, text))
        if not varied:
            raise refused(body.line, REFUSALS["lacks"], "“vary NAME: VALUES”")
        made = cls(
            line=body.line, name=body.name, text="", varied=tuple(varied), where=tuple(where),
            states=states, hides=frozenset(hides), recipe=recipe,
        )  # fmt: skip
        first = made.first
        return replace(made, text=first.text, hints=first.hints, replies=first.replies)

    def texts(self) -> Iterator[tuple[int, str]]:
        yield from self.first.texts()

    def question(self, numbers: Mapping[str, Fraction]) -> Question | Task:
        """Return the question or the task with these numbers in its text."""
        lines = [
            (line, _written(text, line, numbers, exact=_IN_FULL.match(text) is not None))
            for line, text in self.recipe
        ]
        body = Body("task", self.name, self.line, lines)
        if any(text.startswith("until:") for _, text in lines):
            return Task.read(body)
        return Answer.read(body._replace(kind="answer"))

    @property
    def first(self) -> Question | Task:
        """Return the question or the task with the first value of each number."""
        return self.question({each.name: each.values[0] for each in self.varied})

    @property
    def is_on_paper(self) -> bool:
        return self.first.is_on_paper

    def variant(self, here: Here, seed: int, *, complete: bool = False) -> Variant:
        """Return the exercise for a seed; a `Refusal` if no numbers suit.

        Numbers suit if their state exists, the conditions hold, every formula has a value, and no
        wrong idea leads to the right value or to that of another idea. With `complete`, an answer
        without a value is a `Refusal`.
        """
        chance = random.Random(f"{self.name} {seed}")
        problem: Refusal | None = None
        for _ in range(_DRAWS):
            numbers = {each.name: chance.choice(each.values) for each in self.varied}
            try:
                return self._suited(here, seed, numbers)
            except Refusal as error:
                if complete and error.bound == REFUSALS["no-value-with"]:
                    raise
                problem = error
        raise refused(self.line, REFUSALS["no-variant"], seed, str(problem).rstrip("."))

    def _suited(self, here: Here, seed: int, numbers: Mapping[str, Fraction]) -> Variant:
        given = {name: float(value) for name, value in numbers.items()}
        here = here.varied(self._state(numbers), given)
        known = here.quantities()
        for line, condition in self.where:
            with on_line(line, "where"):
                if not condition.holds(known):
                    raise refused(line, REFUSALS["unsuited"], value=condition.text)
        try:
            question = self.question(numbers)
            here = question.variant(here, seed).here
            if isinstance(question, Question):
                question.values(here, *question.key)
            elif question.is_done(here, here.document):
                raise refused(self.line, REFUSALS["unsuited"], value=question.text[:60])
        except Refusal as error:
            if error.bound not in WITHOUT_VALUE:
                raise
            error.limits = error.bound.format(*error.limits), _listed(numbers)
            error.bound = REFUSALS["no-value-with"]
            raise
        question.check_values(here)
        return Variant(seed, numbers, question, here)

    def _check_values_but(self, here: Here, tried: Sequence[Collection[Fraction]]) -> None:
        """Refuse an answer without a value for one more value of a name; the others are drawn."""
        chance = random.Random(self.name)
        for each, known in zip(self.varied, tried, strict=True):
            for value in (value for value in each.values if value not in known):
                numbers = {other.name: chance.choice(other.values) for other in self.varied}
                try:
                    self._suited(here, 1, numbers | {each.name: value})
                except Refusal as error:
                    if error.bound == REFUSALS["no-value-with"]:
                        raise

    def _state(self, numbers: Mapping[str, Fraction]) -> State | None:
        if not self.states:
            return None
        lines = [(line, _written(text, line, numbers, exact=True)) for line, text in self.states]
        return read_state(lines, self.states[0][0])

    def check(self, here: Here, trial: Trial) -> None:
        trial.checks += 1
        count = math.prod(len(each.values) for each in self.varied)
        variants = set[tuple[Fraction, ...]]()
        for seed in range(1, SEEDS + 1):
            variant = self.variant(here, seed, complete=True)
            variants.add(tuple(variant.numbers.values()))
            if isinstance(variant.question, Task):
                variant.question.check_right(variant.here)
        self._check_values_but(here, [set(values) for values in zip(*variants, strict=True)])
        if min(count, len(variants)) < LEAST_VARIANTS:
            raise refused(self.line, REFUSALS["too-few"], len(variants), LEAST_VARIANTS)
        shown: set[str] | None = None
        for seed in range(1, _WHOLE + 1):
            variant = self.variant(here, seed)
            variant.question.check(variant.here, trial)
            readings = _readings(variant)
            shown = readings if shown is None else shown & readings
        if shown and "numbers" not in self.hides:
            trial.add_fault(
                refused(self.line, REFUSALS["can-be-read"], min(shown).replace("_", " "))
            )

    def verdict(self, here: Here, sample: str, line: int) -> str:
        first, _, rest = sample.partition(" ")
        seed = whole(first, LARGEST_SEED)
        if not seed:
            raise refused(line, REFUSALS["a-seed"], LARGEST_SEED, value=sample)
        variant = self.variant(here, seed)
        return variant.question.verdict(variant.here, rest.strip(), line)

    def drawn(self, here: Here, sample: str) -> str:
        return _listed(self.variant(here, int(sample.partition(" ")[0])).numbers)


def _continued(lines: Lines) -> Lines:
    """Join the exercise's own lines with the indented lines below them."""
    joined: list[tuple[int, str]] = []
    for line, text in lines:
        above = joined[-1] if text[:1] in (" ", "\t") and joined else (0, "")
        if _VARY.fullmatch(above[1]) or _OWN.fullmatch(above[1]):
            joined[-1] = above[0], continued(above[1], text, line)
        else:
            joined.append((line, text))
    return joined


def _listed(numbers: Mapping[str, Fraction]) -> str:
    return ", ".join(f"{name} = {written_number(value)}" for name, value in numbers.items())


def _readings(variant: Variant) -> set[str]:
    """Return the names of the scene's readings that are the answer."""
    question = variant.question
    if not isinstance(question, Answer):
        return set()
    answer, readings = question.answer(variant.here), question.known(variant.here).readings
    return {
        name
        for name, value in readings.items()
        for each in (value if isinstance(value, tuple) else (value,))
        if isinstance(each, float | int) and math.isfinite(each) and are_alike(answer, each)
    }


# --------------------------------------------------------------------------- numbers


def _number(text: str, line: int, numbers: Mapping[str, Fraction]) -> Fraction:
    """Return the value of a formula of numbers and of the names that are varied."""
    with on_line(line, "formula"):
        try:
            return rational(parse(text.strip()), numbers)
        except KeyError as error:
            near = ", ".join(numbers) or said("none")
            raise Refusal(
                "formula", text.strip(), REFUSALS["no-name"], str(error.args[0]), near
            ) from error


def _varied(name: str, text: str, line: int, before: Sequence[Varied]) -> Varied:
    """Read the values of a ``vary`` line."""
    if len(before) == MOST_NAMES:
        raise refused(line, REFUSALS["too-many-names"], MOST_NAMES)
    if any(each.name == name for each in before):
        raise refused(line, REFUSALS["exercise-twice"], name)
    begin, is_range, rest = " ".join(text.split()).partition("..")
    if not is_range:
        parts = text.split(",")
        if len(parts) > MOST_VALUES:
            raise refused(line, REFUSALS["exercise-too-many"], len(parts), MOST_VALUES)
        values = [_number(part, line, {}) for part in parts]
    else:
        end, _, by = rest.partition(" step ")
        first, last, step = (_number(part, line, {}) for part in (begin, end, by or "1"))
        if step <= 0 or last < first:
            raise refused(line, REFUSALS["a-range"], value=text[:60])
        count = (last - first) // step + 1
        if count > MOST_VALUES:
            raise refused(line, REFUSALS["exercise-too-many"], count, MOST_VALUES)
        values = [first + step * place for place in range(int(count))]
    return Varied(name, tuple(values))


def _written(text: str, line: int, numbers: Mapping[str, Fraction], *, exact: bool = False) -> str:
    """Write the numbers into a text, for a reader or with all their digits."""

    def written(match: re.Match[str]) -> str:
        value = _number(match[2], line, numbers)
        text = written_number(value)
        if exact:  # a whole number as a part of a name: ``bits{=b}``
            text = str(value) if value.denominator == 1 else repr(float(value))
        if match[1] == "=":
            return text
        return f"= {text}" if Fraction(text) == value else rf"\approx {text}"

    return _DRAWN.sub(written, text)


def written_number(value: Fraction) -> str:
    """Write a number for a reader: ``0.5``, ``4/3``, and four digits where neither is short."""
    short = f"{float(value):.10g}"
    if Fraction(short) == value:
        return short
    is_common = value.denominator <= 12 and abs(value.numerator) <= 16
    return str(value) if is_common else f"{float(value):.4g}"
