"""``matrix:`` in an ``answer``: a matrix or a vector, each of whose numbers is marked by itself."""

import operator
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, combinations
from typing import TypeVar

from app.lessons import marking
from app.lessons.blocks.block import Here, Verdict
from app.lessons.blocks.question import MarkedQuestion, Reply, Value
from app.lessons.blocks.working import has_names, in_list, working
from app.lessons.lines import Body, Items, LineItem, number_in, on_line, refused, split
from app.lessons.marking import TypedNumber
from app.lessons.quantities import read_formula
from app.lessons.text import escaped
from app.model.formula import Formula
from app.model.refusal import REFUSALS, Refusal

Part = TypeVar("Part")

MOST = 4  # most rows, and most columns


@dataclass(frozen=True, kw_only=True)
class MatrixQuestion(MarkedQuestion):
    """A question whose answer is a matrix or a vector; its values are listed row after row.

    A typed answer is one text: its cells are separated by ``|``, its rows by ``;``.
    """

    kind = "answer"
    rows: int
    columns: int
    first: tuple[int, ...] = ()
    """Row and column of the first cell in the matrix that these are a part of, from 1."""

    @classmethod
    def of(cls, body: Body, text: str, items: Items) -> "MatrixQuestion":
        right = items.single("matrix")
        assert right is not None
        rows, columns, formulas = _cells(right)
        replies = []
        for item in items.every("wrong"):
            *shape, wrong = _cells(item)
            if shape != [rows, columns]:
                raise refused(item.line, REFUSALS["other-shape"], *shape, rows, columns)
            replies.append(Reply.of(item, formulas=wrong))
        return cls(
            **cls.fields(body, text, items), replies=tuple(replies), right=formulas,
            right_line=right.line, rows=rows, columns=columns, first=_first(items),
        )  # fmt: skip

    def answer(self, here: Here) -> Value:
        return self.values(here, *self.key)

    def texts_of(self, typed: str) -> list[str]:
        """Return the texts of the cells, row after row; a `Refusal` if their number is wrong."""
        rows = [row.split("|") for row in typed.split(";")]
        if len(rows) != self.rows or any(len(row) != self.columns for row in rows):
            raise Refusal("cells", typed, REFUSALS["cells"], self.rows, self.columns)
        return [cell.strip() for row in rows for cell in row]

    def mark(self, here: Here, typed: str) -> Verdict:
        right, texts = self.answer(here), self.texts_of(typed)
        numbers = [
            marking.read(text, self.unit, value) for text, value in zip(texts, right, strict=True)
        ]
        cells = tuple(map(marking.equals, numbers, right))
        if all(cells):
            return Verdict(True, says=self.why, cells=cells)
        wrong = self.mistaken(here, numbers, marking.equals)
        short = map(marking.is_too_short, numbers, right)
        too_short = all(map(operator.or_, cells, short))
        if wrong is None and not all(map(_counts_as, numbers, right)):
            wrong = self.mistaken(here, numbers, _counts_as)
        remark = self._remark(numbers, right, cells)
        return (wrong or Verdict(False, too_short=too_short, remark=remark))._replace(cells=cells)

    def _remark(
        self, numbers: Sequence[TypedNumber], right: Sequence[float], cells: Sequence[bool]
    ) -> Refusal:
        """Say how a wrong matrix differs from the right one."""
        for remark, order in self._rearranged():
            if all(map(marking.equals, numbers, [right[at] for at in order])):
                return remark
        turned = [*map(marking.equals, [each.times(Fraction(-1)) for each in numbers], right)]
        if all(turned):
            return Refusal.saying(REFUSALS["all-signs"])
        wrong = [place for place, is_right in enumerate(cells) if not is_right]
        if all(turned[place] for place in wrong):
            return Refusal.saying(REFUSALS["some-signs"])
        if not any(cells):
            return Refusal.saying(REFUSALS["none"])
        rows = {place // self.columns + 1 for place in wrong}
        columns = {place % self.columns + 1 for place in wrong}
        if len(wrong) == 1 and self.rows > 1 and self.columns > 1:
            return Refusal.saying(REFUSALS["one-cell"], *rows, *columns)
        if len(rows) == 1 and self.rows > 1:
            return Refusal.saying(REFUSALS["one-row"], *rows)
        if len(columns) == 1 and self.columns > 1:
            return Refusal.saying(REFUSALS["one-column"], *columns)
        return Refusal.saying(REFUSALS["counted"], sum(cells), len(cells))

    def _rearranged(self) -> Iterator[tuple[Refusal, list[int]]]:
        """Yield the ways to mix up a matrix: for each cell, whose value it then has."""
        places = self._in_rows(range(self.rows * self.columns))
        if self.rows == self.columns:
            yield Refusal.saying(REFUSALS["transposed"]), [*chain(*zip(*places, strict=True))]
        for one, other in combinations(range(self.rows), 2):
            yield (
                Refusal.saying(REFUSALS["rows"], one + 1, other + 1),
                [*chain(*_swapped(places, one, other))],
            )
        for one, other in combinations(range(self.columns), 2):
            swapped = (_swapped(row, one, other) for row in places)
            yield Refusal.saying(REFUSALS["columns"], one + 1, other + 1), [*chain(*swapped)]

    def solution(self, here: Here) -> str:
        """Return a line for each number that has letters; the numbers are in `answer_text`."""
        known, lines = self.known(here), list[list[str]]()
        for place, formula in enumerate(self.right):
            steps = working(formula, known) if has_names(formula) else None
            if steps is not None:
                lines.append(steps.sides(self._name(place)))
        return in_list(lines)

    def _name(self, place: int) -> str:
        """Return what a cell is called in the worked solution."""
        row, column = divmod(place, self.columns)
        if self.first:
            return f"m_{{{row + self.first[0]}{column + self.first[1]}}}"
        is_vector = min(self.rows, self.columns) == 1
        return f"v_{place + 1}" if is_vector else f"m_{{{row + 1}{column + 1}}}"

    @property
    def shape(self) -> tuple[int, int]:
        return self.rows, self.columns

    def _in_rows(self, cells: Sequence[Part]) -> list[Sequence[Part]]:
        return [cells[at : at + self.columns] for at in range(0, len(cells), self.columns)]

    def sample_of(self, numbers: Sequence[str]) -> str:
        return "; ".join(" | ".join(row) for row in self._in_rows(numbers))

    def printed(self, numbers: Sequence[str]) -> str:
        comma = " | " if "," in "".join(numbers) else ", "  # where that is in the numbers
        return "; ".join(comma.join(row) for row in self._in_rows(numbers))

    def own_answer(self, typed: str) -> str:
        return f"\n\n{self.table([escaped(cell) for cell in self.texts_of(typed)])}"

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        unit = f"\n\n{self.unit}" if self.unit else ""
        return self.table([write(value) for value in self.answer(here)]) + unit

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        return f"{self.text}\n\n{answer}" if answer else self.text

    def table(self, cells: Sequence[str]) -> str:
        """Write the cells as a table in Markdown."""
        lines = [[""] * self.columns, ["---"] * self.columns, *self._in_rows(cells)]
        return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _counts_as(typed: TypedNumber, value: float) -> bool:
    """Whether a typed number is a value, or is rounded to too few digits."""
    return marking.equals(typed, value) or marking.is_rounded(typed, value)


def _first(items: Items) -> tuple[int, ...]:
    item = items.single("first")
    if item is None:
        return ()
    parts = item.text.split(",")
    if len(parts) != 2:
        raise refused(item.line, REFUSALS["a-cell"], value=item.text[:60])
    return tuple(int(number_in(part.strip(), item.line, 1, MOST)) for part in parts)


def _swapped(parts: Sequence[Part], one: int, other: int) -> list[Part]:
    swapped = [*parts]
    swapped[one], swapped[other] = parts[other], parts[one]
    return swapped


def _cells(item: LineItem) -> tuple[int, int, tuple[Formula, ...]]:
    """Read the rows and columns of a matrix, and its formulas row after row."""
    rows = [split(row) for row in item.text.split(";")]
    count, width = len(rows), len(rows[0])
    is_even = all(len(row) == width for row in rows)
    if not is_even or max(count, width) > MOST or count * width < 2:
        raise refused(item.line, REFUSALS["a-matrix"], MOST, value=item.text[:60])
    with on_line(item.line, item.key):
        return count, width, tuple(read_formula(cell.strip()) for row in rows for cell in row)
