"""Variants of all exercises: no wrong idea counts as right or as another idea, and right is right.

``python3 -m tests.fuzz variants --first 1 --last 2000`` draws the variants of every exercise with
these seeds, and types each of their values as students do: to three digits and more, rounded and
cut off, with zeros and without. It lists what is marked otherwise. The suite takes fewer seeds.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import fields
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, ROUND_UP, Decimal
from fractions import Fraction

from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Here
from app.lessons.blocks.choices import Choices
from app.lessons.blocks.click import Click
from app.lessons.blocks.exercise import LARGEST_SEED, Exercise, Variant
from app.lessons.blocks.matrix import MatrixQuestion
from app.lessons.blocks.question import MarkedQuestion, Value
from app.lessons.blocks.task import Task
from app.lessons.contents import contained
from app.lessons.course import Course
from app.lessons.lesson import read
from app.lessons.practice import exercises_of
from app.model.refusal import Refusal
from tests.support.tools import ToolParser


def main(words: Sequence[str]) -> int:
    """Print what is marked wrongly, and how many variants there were."""
    parser = ToolParser("fuzz variants", __doc__)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--last", type=int, default=LARGEST_SEED)
    parser.add_argument("--only", default="", help="lessons whose file's name begins so")
    options = parser.parse_args(words)
    drawn = faulty = 0
    for path in contained():
        for found in exercises_of(Course(read(path))) if path.stem.startswith(options.only) else ():
            known = set[tuple[object, ...]]()
            suited = remembered(found.exercise)
            for seed in range(options.first, options.last + 1):
                drawn += 1
                variant = suited.variant(found.here, seed)
                numbers = tuple(variant.numbers.values())
                if numbers in known:
                    continue
                known.add(numbers)
                faults = [*faults_of(variant)]
                faulty += bool(faults)
                if faults:
                    print(path.stem, found.exercise.name, seed, "; ".join(faults), flush=True)
            print(path.stem, found.exercise.name, f"{len(known)} different", flush=True)
    print(f"{drawn} variants drawn, {faulty} with a fault")
    return 1 if faulty else 0


def remembered(exercise: Exercise) -> Exercise:
    """Return an exercise that tries the same numbers only once."""
    known: dict[tuple[object, ...], Variant | Refusal] = {}

    class Remembering(Exercise):
        def _suited(self, here: Here, seed: int, numbers: Mapping[str, Fraction]) -> Variant:
            key = tuple(numbers.values())
            if key not in known:
                try:
                    known[key] = super()._suited(here, seed, numbers)
                except Refusal as error:
                    known[key] = error
            found = known[key]
            if isinstance(found, Refusal):
                raise found
            return found._replace(seed=seed)

    return Remembering(**{each.name: getattr(exercise, each.name) for each in fields(exercise)})


def faults_of(variant: Variant) -> Iterator[str]:
    """Yield what is marked otherwise than it should be, as sentences."""
    question, here = variant.question, variant.here
    if isinstance(question, Task):
        if question.right is not None:
            own = here.shown_by(question.right)
            if not question.is_done(here, own) or question.mistaken_in(here, own) is not None:
                yield "the right state is not done, or is a wrong idea's"
        return
    if isinstance(question, Choices):
        return  # a number of a choice cannot be mistaken
    assert isinstance(question, MarkedQuestion)
    for reply, formulas, line in question.formulas:
        wanted = "right" if reply is None else reply.idea or "wrong"
        for typed in typed_ways(question, question.values(here, formulas, line)):
            word = question.mark(here, typed).word
            if word != wanted:
                yield f"{typed} is {word} and not {wanted}"


def typed_ways(question: MarkedQuestion, value: Value) -> list[str]:
    """Return a value as students type it, all its numbers in the same way."""
    if isinstance(question, Click):
        return [" ".join(map(repr, value))]
    several = [list(dict.fromkeys(ways_of(each))) for each in value]
    if isinstance(question, Answer):
        return [f"{value[0]:.0f}"] if question.counts else several[0]
    assert isinstance(question, MatrixQuestion)
    found = []
    for number in range(max(map(len, several))):
        texts = [ways[min(number, len(ways) - 1)] for ways in several]
        rows = (texts[at : at + question.columns] for at in range(0, len(texts), question.columns))
        found.append("; ".join(map(" | ".join, rows)))
    return found


def ways_of(value: float) -> Iterator[str]:
    """Yield a number to three digits and more: rounded, cut off, rounded up, and whole."""
    if abs(value) < 1e-12:
        yield "0"
        return
    exact = Decimal(value)
    for digits in range(3, 8):
        for rounding in (ROUND_HALF_EVEN, ROUND_DOWN, ROUND_UP):
            yield f"{exact.quantize(Decimal(1).scaleb(exact.adjusted() - digits + 1), rounding)}"
    yield repr(value)
