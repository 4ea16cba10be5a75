"""``click:`` in an ``answer``: a place that the student points at in a picture."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from app.document.view import PANES
from app.lessons import marking
from app.lessons.blocks.block import Here, Verdict
from app.lessons.blocks.question import MarkedQuestion, Reply, Value
from app.lessons.blocks.working import has_names, in_list, working
from app.lessons.lines import Body, Items, LineItem, number_in, on_line, refused, split
from app.lessons.quantities import read_formula
from app.model.formula import Formula
from app.model.refusal import REFUSALS, Refusal

WITHIN_PX = 12.0  # largest distance of a click that counts, unless the question says another one
PICTURE_PX, PER_NDC_PX, DISTANCE_PX = 400.0, 100.0, 200.0
"""Width of a small image pane; a unit of the cube, and the way from the eye to its target, in small
panes. A check uses them to compare places without a window."""

COORDINATES = {  # what the coordinates of a place are called in a worked solution
    "image": (r"x_{\mathrm{win}}", r"y_{\mathrm{win}}"),
    "ndc": ("x'", "y'", "z'"),
    "world": ("x", "y", "z"),
}


@dataclass(frozen=True, kw_only=True)
class Click(MarkedQuestion):
    """A question whose answer is a place in a picture, its `pane`.

    Places are in world coordinates, in those of the NDC cube, or in the image's pixels from its
    upper left.
    """

    kind = "answer"
    is_worked = False
    within_px: float  # how far from a place a click may be, on a screen with scale 1

    @classmethod
    def of(cls, body: Body, text: str, items: Items) -> "Click":
        click, at, within = (items.single(key) for key in ("click", "at", "within"))
        assert click is not None
        if click.text not in PANES:
            raise refused(click.line, REFUSALS["one-of"], ", ".join(PANES), value=click.text)
        if at is None:
            raise refused(click.line, REFUSALS["lacks"], "“at: FORMULA, FORMULA”")
        count, wrong = 2 if click.text == "image" else 3, items.every("wrong")
        return cls(
            **cls.fields(body, text, items),
            replies=tuple(Reply.of(each, formulas=_place(each, count)) for each in wrong),
            right=_place(at, count),
            right_line=at.line,
            pane=click.text,
            within_px=number_in(within.text, within.line, 2, 100) if within else WITHIN_PX,
        )

    def answer(self, here: Here) -> Value:
        return self.values(here, *self.key)

    def values(self, here: Here, formulas: tuple[Formula, ...], line: int) -> Value:
        values = super().values(here, formulas, line)
        sides = here.document.projection.image_size
        inside = {"image": [0.0 <= x <= side for x, side in zip(values, sides, strict=False)],
                  "ndc": [abs(x) <= 1.0 for x in values]}  # fmt: skip
        if not all(inside.get(self.pane, ())):
            raise refused(line, REFUSALS["outside"], ", ".join(f"{x:.4g}" for x in values))
        return values

    def are_alike(self, here: Here, one: Value, other: Value) -> bool:
        return self._away(here, one, other) < 2.0 * self.within_px

    def _away(self, here: Here, one: Value, other: Value) -> float:
        """Return about how many pixels two places are apart in a small window."""
        projection = here.document.projection
        per_unit = {
            "image": PICTURE_PX / projection.image_size[0],
            "ndc": PER_NDC_PX,
            "world": DISTANCE_PX / projection.camera.orbit.distance,
        }
        return math.dist(one, other) * per_unit[self.pane]

    def mark(self, here: Here, typed: str) -> Verdict:
        """Return the verdict on a place that is given by its coordinates."""
        parts = typed.split()
        if len(parts) != len(self.right):
            raise Refusal("place", typed, REFUSALS["a-click"], len(self.right))
        place = tuple(float(marking.read(part).value) for part in parts)
        return self.verdict_at(here, lambda other: self._away(here, place, other))

    def verdict_at(self, here: Here, away_px: Callable[[Value], float]) -> Verdict:
        """Return the verdict on a click, whose distance from any place `away_px` returns."""
        if away_px(self.answer(here)) <= self.within_px:
            return Verdict(True, says=self.why)
        for wrong in self.replies:
            if away_px(self.values(here, wrong.formulas, wrong.line)) <= self.within_px:
                return wrong.verdict(here)
        return Verdict(False)

    def solution(self, here: Here) -> str:
        """Return a line for each coordinate; none if no reader knows a name in it."""
        known = self.known(here)
        parts = [working(each, known) for each in self.right]
        if not any(map(has_names, self.right)):
            return ""
        names = COORDINATES[self.pane]
        sides = [way.sides(name) for name, way in zip(names, parts, strict=True) if way is not None]
        return in_list(sides) if len(sides) == len(parts) else ""

    @property
    def shape(self) -> tuple[int, int]:
        return 0, 0

    def marked_place(self, here: Here) -> tuple[Value, float]:
        return self.answer(here), self.within_px / PICTURE_PX

    def printed(self, numbers: Sequence[str]) -> str:
        return f"({super().printed(numbers)})"

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        return f"{self.text}\n\n**{answer}**"

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        return self.printed([write(each) for each in self.answer(here)])


def _place(item: LineItem, count: int) -> tuple[Formula, ...]:
    parts = split(item.text)
    if len(parts) != count:
        raise refused(item.line, REFUSALS["not-so-many"], count, value=item.text[:60])
    with on_line(item.line, item.key):
        return tuple(read_formula(part.strip()) for part in parts)
