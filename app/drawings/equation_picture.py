"""An equation as a figure of its own: matrices in lines that are no wider than a column."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from app.document.document import Document
from app.document.lengths import PX_PER
from app.drawings.label import LabelText
from app.drawings.off_screen import Pixels
from app.drawings.style import Style, rgb
from app.drawings.vectors import Area, LineShape, Shape, TextShape
from app.lecture.equation import equation_of
from app.lecture.equation_layout import (
    APART_EM,
    BETWEEN_EM,
    BRACKET_EM,
    MatrixLayout,
    laid_out,
    width_em,
)
from app.lecture.typesetting import line_of, piece_of
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

TOO_NARROW = QT_TRANSLATE_NOOP(
    "Refusal", "width = {0} mm: a line of this equation needs {1} mm in letters of {2} points."
)
_LINES_APART_EM, _CAPTION_EM, _AXIS_EM, _FOOT_EM, _RULE_EM = 0.9, 1.3, 0.25, 0.22, 0.045


class _EquationPart(NamedTuple):
    """A matrix of a line, and the sign before it."""

    sign: str
    laid: MatrixLayout
    gap_em: float  # before it, unless it begins a line

    @property
    def sign_em(self) -> float:
        return width_em(self.sign) + 2.0 * BETWEEN_EM if self.sign else 0.0

    @property
    def width_em(self) -> float:
        return self.sign_em + self.laid.width


@dataclass(frozen=True, eq=False)
class EquationPicture:
    """The equation of a document's view; `size` in pixels, of which a side may be 0: as it needs.

    `scale` is that of the pixels.
    """

    document: Document
    style: Style
    size: tuple[float, float] = (0.0, 0.0)
    transparent: bool = False
    scale: float = 1.0

    @cached_property
    def _lines(self) -> list[list[_EquationPart]]:
        """The matrices, as many in a line as there is room for."""
        document, view = self.document, self.document.view
        equation = equation_of(document.projection, view.letters, view.equation, document.settings)
        room, lines = self.size[0] / self._em or float("inf"), list[list[_EquationPart]]()
        laid = [*laid_out(equation)]
        gap_em = BETWEEN_EM if equation.result else APART_EM
        for place, each in enumerate(laid):
            is_result = equation.result is not None and place == len(laid) - 1
            sign = each.lead if len(laid) == 1 else "=" if is_result else ""
            part = _EquationPart(sign, each, gap_em)
            if lines and _width_em([*lines[-1], part]) <= room:
                lines[-1].append(part)
            else:
                lines.append([part])
        widest = max(map(_width_em, lines))
        if widest > room:
            mm = (f"{side * self._em / PX_PER['mm']:.3g}" for side in (room, widest))
            raise Refusal.saying(TOO_NARROW, *mm, f"{self._em * 0.24:.3g}")
        return lines

    @property
    def _em(self) -> float:
        return self.style.font_size

    def _heights_em(self, line: list[_EquationPart]) -> tuple[list[float], float]:
        """The heights of a line's rows, and of the names below them."""
        rows = [max(each.laid.heights[row] for each in line) for row in range(4)]
        is_named = sum(map(len, self._lines)) > 1 and any(each.laid.term.name for each in line)
        return rows, _CAPTION_EM if is_named else 0.0

    @cached_property
    def needed(self) -> tuple[float, float]:
        """The width and the height that it needs, in pixels."""
        heights = [sum(rows) + below for rows, below in map(self._heights_em, self._lines)]
        high = sum(heights) + _LINES_APART_EM * (len(heights) - 1) + _RULE_EM
        return max(map(_width_em, self._lines)) * self._em, high * self._em

    def pixels(self, seen: object = None) -> Pixels:
        from app.drawings.pdf import rastered

        width, height = (own or side for own, side in zip(self.size, self.needed, strict=True))
        corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
        ground = [] if self.transparent else [Area([corners], rgb(self.style.background), 1.0)]
        shapes = [*ground, *self.shapes("none", lambda: None)]
        drawn = rastered(shapes, (width, height), self.scale)
        return drawn if self.transparent else drawn[..., :3]

    def shapes(self, _hidden: str, _watch: Callable[[], None]) -> list[Shape]:
        return [*self._shapes()]

    def _shapes(self) -> Iterator[Shape]:
        width, height = (own or side for own, side in zip(self.size, self.needed, strict=True))
        em, y = self._em, (height - self.needed[1] + _RULE_EM * self._em) / 2.0
        for line in self._lines:
            rows, below = self._heights_em(line)
            x = (width - em * _width_em(line)) / 2.0
            high = em * sum(rows)
            for place, part in enumerate(line):
                x += em * part.gap_em if place else 0.0
                if part.sign:
                    yield self._text(part.sign, x + em * part.sign_em / 2.0, y + high / 2.0)
                    x += em * part.sign_em
                yield from self._matrix(part.laid, x, y, rows)
                if below and part.laid.term.name:
                    middle = x + em * part.laid.width / 2.0
                    name = f"${part.laid.term.name}$"
                    yield self._text(name, middle, y + high + em * (below - _AXIS_EM * 2.0))
                x += em * part.laid.width
            y += high + em * (below + _LINES_APART_EM)

    def _matrix(
        self, laid: MatrixLayout, left: float, top: float, rows: list[float]
    ) -> Iterator[Shape]:
        em, ink = self._em, rgb(self.style.ink)
        half = _RULE_EM * em / 2.0
        right, low = left + em * laid.width - half, top + em * sum(rows)
        for x, foot in ((left + half, _FOOT_EM * em), (right, -_FOOT_EM * em)):
            points = [(x + foot, top), (x, top), (x, low), (x + foot, low)]
            yield LineShape(points, ink, 1.0, 2.0 * half)
        y = top
        for row, high in enumerate(rows):
            x = left + BRACKET_EM * em
            for column, wide in enumerate(laid.widths):
                text = laid.cells[row][column]
                _, down, _, up = line_of(text, formula=1.0).box
                middle = y + em * (high + down + up) / 2.0
                yield self._text(text, x + em * wide / 2.0, middle, base=True)
                x += em * wide
            y += em * high

    def _text(self, text: str, middle: float, y: float, base: bool = False) -> TextShape:
        """A formula round a place, or on a line of writing."""
        line, em, style = line_of(text, formula=1.0), self._em, self.style
        place = middle - em * line.width / 2.0, y if base else y + _AXIS_EM * em
        widths = tuple(piece_of(piece, is_tex).width for piece, is_tex, *_ in line.pieces)
        written = LabelText(
            text, line.pieces, widths, place, 0.0, em, style.tone(""), style.background, 1.0, False
        )
        return TextShape(written, place, em)


def _width_em(line: list[_EquationPart]) -> float:
    gaps: list[Any] = [each.gap_em for each in line[1:]]
    return sum((each.width_em for each in line), sum(gaps))
