"""``order:`` in an ``answer``: tiles that the student arranges until their product is right.

A typed answer is the text of a chain, ``translate 3,0,0; off rotate z 30``. Each order with the
right product counts, and a wrong one is known by what it does (`app.lecture.wrong_chains`).
"""

import random
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from typing import Self

import numpy as np

from app.document.compare import ComparedPicture
from app.document.document import Document
from app.languages import translate
from app.lecture.copying import latex_called
from app.lecture.equation import USUAL
from app.lecture.titles import stage_title, tile_title
from app.lecture.typed_matrix import with_matrix
from app.lecture.wrong_chains import (
    DIVIDE,
    DIVIDE_XYZ,
    OF_LENS,
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
from app.lessons.blocks.question import LETTERS, MODEL, YOURS, MarkedQuestion
from app.lessons.lines import Body, Items, on_line, refused
from app.lessons.text import escaped
from app.model.chain import FROM_OBJECT, KINDS, Chain, Tile
from app.model.limits import Array
from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal

OF = {"object": FROM_OBJECT, "view": "view_from_world", "projection": "clip_from_view"}
"""The matrices whose factors may be arranged in a picture of their own."""
_MADE, _VIEWED = (1.0, 0.0, 0.0, 1.0), (1.0, 1.0, -5.0, 1.0)  # the points of worked solutions
_MOST = 6  # tiles of a right order, since all their orders are compared
_IN_LETTERS = QT_TRANSLATE_NOOP(
    "Exam", "Write the letters of the tiles as a product: what stands on the right acts first."
)


def tile_parts(text: str) -> tuple[str, str, str]:
    """Return the part of a tile that stays, its title as Markdown, and its numbers as typed."""
    kind = max((each for each in KINDS if text.startswith(each)), key=len, default="")
    if kind:
        return kind, stage_title(KINDS[kind].factor), text[len(kind) :].strip()
    if text in (*USUAL, DIVIDE, DIVIDE_XYZ):
        return text, stage_title(USUAL.get(text, text)), ""
    name, inverted, _ = text.partition("^-1")
    return text, f"${latex_called(name)}{'^{-1}' * bool(inverted)}$", ""


def _printed(text: str) -> str:
    kind, title, numbers = tile_parts(text)
    return tile_title(kind, escaped(numbers)) if kind in KINDS else title


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
        for item, parts, most in ((order, right, _MOST), (tiles or order, given, len(LETTERS))):
            if len(parts) > most:
                raise refused(item.line, REFUSALS["chain-too-many"], most, len(parts))
        chance = random.Random(f"{given} {re.findall('[0-9]+', text)}")  # in every language alike
        mixed = chance.sample(given, len(given))
        while mixed == right and len({*given}) > 1:
            mixed = chance.sample(given, len(given))
        return cls(
            **cls.fields(body, text, items), replies=(), right=(), right_line=order.line,
            chain="; ".join(right), tiles=tuple(mixed), product=order.about,
        )  # fmt: skip

    def factors(self, here: Here, typed: str = "") -> Factors:
        """Read a typed chain, or the right one; a `Refusal` of ``answer``, or of the line."""
        known = here.document.projection, here.document.view.letters
        try:
            return factors_of(typed or self.chain, *known)
        except Refusal as error:
            if typed:
                raise Refusal("answer", error.value, error.bound, *error.limits) from error
            with on_line(self.right_line):
                raise

    def variant(self, here: Here, seed: int) -> Variant:
        """Return the question with the object in its place, by a matrix that tells no order."""
        if self.product == "object":
            cells = effect(self.factors(here), np.eye(4)).ravel().tolist()
            text = f"object.chain=matrix {','.join(map(repr, cells))}"
            here = here.varied(State(self.line, ((self.line, text),)), here.given)
        return Variant(seed, {}, self, here)

    def mark(self, here: Here, typed: str) -> Verdict:
        right, given = self.factors(here), self.factors(here, typed or " ")
        name = mistake(right, given)
        if name is None:
            return Verdict(True, says=self.why)
        idea = here.idea(name)
        title, says, state = (idea.title, idea.says, idea.state) if idea else ("", "", None)
        shown, compared = self._with_product(here.document, given), None
        if shown is not None:
            wrong = ComparedPicture(YOURS, held=shown.state)
            view = replace(shown.view, compare=(wrong, ComparedPicture(MODEL, live=True)))
            compared = replace(here.document, view=replace(view, dividers=(), large="image"))
        return Verdict(
            False, name, says, shown or state, remark=difference(right, given), beside=compared,
            title=title,
        )  # fmt: skip

    def _with_product(self, own: Document, chain: Factors) -> Document | None:
        """Return the state with a wrong product; None if the model does not allow it."""
        cells, projection = effect(chain, np.eye(4)), own.projection
        try:
            if self.product == "object":
                placement = Chain((Tile("matrix", tuple(cells.ravel())),))
                return replace(own, projection=replace(projection, placement=placement))
            if self.product:
                name, rows = OF[self.product], cells.tolist()
                return replace(own, projection=with_matrix(projection, name, rows, whole=False))
        except Refusal:
            pass
        return None

    def posed(self) -> str:
        """Return the question with a letter for each tile."""
        tiles = "\n".join(f"- {letter}: {title}" for letter, title in self._lettered.items())
        return f"{self.text}\n\n{tiles}\n\n{translate(_IN_LETTERS, 'Exam')}"

    @property
    def shape(self) -> tuple[int, int]:
        return 1, len(self.tiles)

    @property
    def _lettered(self) -> dict[str, str]:
        """The tiles as they are printed, by their letters; a student's numbers are left out."""
        parts = [(text, *tile_parts(text)) for text in self.tiles]
        return {
            letter: title if kind in KINDS and text == Tile(kind, KINDS[kind].neutral).text
            else _printed(text)
            for letter, (text, kind, title, _) in zip(LETTERS, parts, strict=False)
        }  # fmt: skip

    def _letter(self, printed: str) -> str:
        tiles = self._lettered.items()
        return next((each for each, tile in tiles if f"{printed} ".startswith(f"{tile} ")), "")

    def printed(self, numbers: Sequence[str]) -> str:
        return " · ".join(map(_printed, numbers))

    def answer_text(self, here: Here, write: Callable[[float], str]) -> str:
        """Return each order of the right tiles that has the right product."""
        right = self.factors(here)
        orders = (order for order in permutations(right) if same(effect(order), effect(right)))
        printed = (self.printed([factor.text for factor in order]) for order in orders)
        return " = ".join(dict.fromkeys(printed))

    def with_answer(self, answer: str, *, others: bool = True) -> str:
        parts = re.split("( · | = )", answer)
        parts[::2] = [f"{self._letter(part)}: {part}" for part in parts[::2]]
        return f"{self.text}\n\n**{''.join(parts)}**"

    def own_answer(self, typed: str) -> str:
        return f"**{self.printed(typed.split('; '))}**"

    def right_sample(self, here: Here) -> str:
        return self.chain

    def mistakes(self, here: Here, write: Callable[[float], str]) -> Iterator[tuple[str, str]]:
        right, named = self.factors(here), set[str]()
        for wrong in permutations(right):
            name = mistake(right, wrong) or ""
            if name not in named and (idea := here.idea(name)) is not None:
                named.add(name)
                yield idea.title, " · ".join(self._letter(_printed(f.text)) for f in wrong)

    def solution(self, here: Here) -> str:
        """Return what each factor makes of a point, from the right."""
        right = self.factors(here)
        point = np.array([_VIEWED if right[-1].kind.startswith(OF_LENS) else _MADE]).T
        lines = [f"- ${_place(point)}$"]
        for factor in reversed(right):
            point = effect((factor,), point)
            lines.append(f"- {_printed(factor.text)}: ${_place(point)}$")
        return "\n".join(lines)

    def check_values(self, here: Here) -> None:
        right, given = self.factors(here), self.factors(here, "; ".join(self.tiles))
        needed, had = ([each.kind for each in chain] for chain in (right, given))
        for factor in right:  # of each tile the student may change the numbers
            if had.count(factor.kind) < needed.count(factor.kind):
                raise refused(self.right_line, REFUSALS["no-tile"], factor.text)
        if same(effect(given), effect(right)):
            raise refused(self.right_line, REFUSALS["order-any"])
        stages = {each.name: each.matrix for each in here.document.projection.all_stages}
        own = Factor("", "", stages[OF.get(self.product, FROM_OBJECT)])
        divide = Factor("", DIVIDE, None)  # of the lens only the picture counts
        if self.product and not same(effect((divide, *right)), effect((divide, own))):
            raise refused(self.right_line, REFUSALS["other-product"], OF[self.product])

    def check(self, here: Here, trial: Trial) -> None:
        super().check(here, trial)
        with trial.kept(), on_line(self.right_line):
            self.check_values(here)


def _place(point: Array) -> str:
    w = float(point[3, 0])
    return written_numbers(point[: 3 if abs(w - 1.0) < 1e-9 else 4, 0])
