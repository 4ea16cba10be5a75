"""``order:`` in an ``answer``: tiles that the student arranges until their product is right.

A typed answer is the text of a chain, ``translate 3,0,0; off rotate z 30``. Each order with the
right product counts, and a wrong one is known by what it does (`app.lecture.wrong_chains`).
"""

import random
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from typing import Self

import numpy as np

from app.document.compare import ComparedPicture, Held
from app.lecture.typed_matrix import with_matrix
from app.lecture.wrong_chains import (
    DIVIDE,
    Factor,
    Factors,
    difference,
    effect,
    factors_of,
    mistake,
    same,
    written_numbers,
)
from app.lessons.blocks.block import Here, State, Trial, Variant, Verdict
from app.lessons.blocks.question import MODEL, YOURS, MarkedQuestion
from app.lessons.lines import Body, Items, on_line, refused
from app.lessons.text import escaped
from app.model.chain import FROM_OBJECT, Chain, Tile
from app.model.limits import Array
from app.model.projection import Projection
from app.model.refusal import REFUSALS, Refusal

OF = {"object": FROM_OBJECT, "view": "view_from_world", "projection": "clip_from_view"}
"""The matrices whose factors may be arranged in a picture of their own."""
_MADE, _VIEWED = (1.0, 0.0, 0.0, 1.0), (1.0, 1.0, -5.0, 1.0)  # the points of worked solutions


@dataclass(frozen=True, kw_only=True)
class OrderQuestion(MarkedQuestion):
    """A question whose answer is a chain; `tiles` are given in any order, perhaps some too many."""

    kind = "answer"
    chain: str
    tiles: tuple[str, ...]
    product: str  # one of `OF`; empty for a chain without a picture of its own

    @classmethod
    def of(cls, body: Body, text: str, items: Items) -> Self:
        order, tiles = items.single("order"), items.single("tiles")
        assert order is not None
        if order.about and order.about not in OF:
            raise refused(order.line, REFUSALS["one-of"], ", ".join(OF), value=order.about)
        right, given = (
            [part.strip() for part in item.text.split(";")] for item in (order, tiles or order)
        )
        chance = random.Random(f"{text} {given}")
        mixed = chance.sample(given, len(given))
        while mixed == right and len({*given}) > 1:
            mixed = chance.sample(given, len(given))
        return cls(
            **cls.fields(body, text, items), replies=(), right=(), right_line=order.line,
            chain="; ".join(right), tiles=tuple(mixed), product=order.about,
        )  # fmt: skip

    def factors(self, here: Here, typed: str) -> Factors:
        document = here.document
        with on_line(self.right_line):
            return factors_of(typed, document.projection, document.view.letters)

    def variant(self, here: Here, seed: int) -> Variant:
        """Return the question with the object in its place, by a matrix that tells no order."""
        if self.product == "object":
            cells = effect(self.factors(here, self.chain), np.eye(4)).ravel().tolist()
            text = f"object.chain=matrix {','.join(map(repr, cells))}"
            here = here.varied(State(self.line, ((self.line, text),)), here.given)
        return Variant(seed, {}, self, here)

    def mark(self, here: Here, typed: str) -> Verdict:
        right = self.factors(here, self.chain)
        try:
            given = factors_of(typed, here.document.projection, here.document.view.letters)
        except Refusal as error:
            raise Refusal("answer", error.value, error.bound, *error.limits) from error
        name = mistake(right, given)
        if name is None:
            return Verdict(True, says=self.why)
        idea, own = here.idea(name), here.document
        title, says, state = (idea.title, idea.says, idea.state) if idea else ("", "", None)
        wrong = self._with_product(own.projection, effect(given, np.eye(4)))
        compared = None
        if wrong is not None:
            state = replace(own, projection=wrong)
            pictures = (
                ComparedPicture(YOURS, held=Held(wrong, own.settings)),
                ComparedPicture(MODEL, live=True),
            )
            compared = replace(
                own, view=replace(own.view, compare=pictures, dividers=(), large="image")
            )
        return Verdict(
            False, name, says, state, remark=difference(right, given), beside=compared, title=title
        )  # fmt: skip

    def _with_product(self, projection: Projection, cells: Array) -> Projection | None:
        """Return a projection with a wrong product; None if the model does not allow it."""
        try:
            if self.product == "object":
                return replace(projection, placement=Chain((Tile("matrix", tuple(cells.ravel())),)))
            if self.product:
                return with_matrix(projection, OF[self.product], cells.tolist(), whole=False)
        except Refusal:
            pass
        return None

    def printed(self, numbers: Sequence[str]) -> str:
        return " · ".join(numbers)

    def posed(self) -> str:
        return "\n".join([self.text, "", *(f"- `{tile}`" for tile in self.tiles)])

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        return f"{self.text}\n\n**{answer}**" if answer else self.text

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        return self.printed(self.chain.split("; "))

    def own_answer(self, typed: str) -> str:
        return f"**{escaped(self.printed(typed.split('; ')))}**"

    def right_sample(self, here: Here) -> str:
        return self.chain

    def mistakes(self, here: Here, write: Callable[[float], str]) -> Iterator[tuple[str, str]]:
        right, named = self.factors(here, self.chain), set[str]()
        for wrong in permutations(right):
            name = mistake(right, wrong)
            if name and name not in named and (idea := here.idea(name)) is not None:
                named.add(name)
                yield idea.title, self.printed([factor.text for factor in wrong])

    def solution(self, here: Here) -> str:
        """Return what each factor makes of a point, from the right."""
        chain = self.factors(here, self.chain)
        point = np.array([_VIEWED if self.product == "projection" else _MADE]).T
        lines = [f"- ${_place(point)}$"]
        for factor in reversed(chain):
            point = effect((factor,), point)
            lines.append(f"- {escaped(factor.text)}: ${_place(point)}$")
        return "\n".join(lines)

    def check_values(self, here: Here) -> None:
        right = self.factors(here, self.chain)
        if same(effect(self.factors(here, "; ".join(self.tiles))), effect(right)):
            raise refused(self.right_line, REFUSALS["order-any"])
        stages = {each.name: each.matrix for each in here.document.projection.all_stages}
        divide = factors_of(DIVIDE, here.document.projection, here.document.view.letters)
        own = (*divide, Factor("", "", stages[OF.get(self.product, FROM_OBJECT)]))
        if self.product and not same(effect((*divide, *right)), effect(own)):
            raise refused(self.right_line, REFUSALS["other-product"], OF[self.product])

    def check(self, here: Here, trial: Trial) -> None:
        super().check(here, trial)
        with trial.kept():
            self.check_values(here)


def _place(point: Array) -> str:
    numbers = [float(part) for part in point[:, 0]]
    return written_numbers(numbers[:3] if abs(numbers[3] - 1.0) < 1e-9 else numbers)
