"""An equation as a figure of its own: matrices in lines that are no wider than a column."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import NamedTuple

from app.document.document import Document
from app.document.lengths import DPI, PX_PER
from app.drawings.label import LabelText
from app.drawings.style import Style, rgb
from app.drawings.vectors import LineShape, Shape, TextShape, box_of, moved
from app.lecture.equation import equation_of
from app.lecture.equation_form import APART_EM, BRACKET_EM, GAP_EM, MatrixLayout, laid_out, width_em
from app.lecture.typesetting import line_of, piece_of
from app.model.refusal import REFUSALS, Refusal

_ROUNDING_EM = 1e-6
_WIDER = 0.1  # of a column's width, for letters of TeX
_LINES_APART_EM, _CAPTION_EM, _AXIS_EM, _FOOT_EM, _RULE_EM = 0.9, 1.0, 0.25, 0.22, 0.045


class _EquationPart(NamedTuple):
    """A matrix, the sign before it, and the width of both."""

    laid: MatrixLayout
    sign: str
    width_em: float


@dataclass(frozen=True, eq=False)
class EquationPicture:
    """The equation of a view; `size` is in pixels, and a side of 0 becomes as long as it needs."""

    document: Document
    style: Style
    size: tuple[float, float] = (0.0, 0.0)

    @cached_property
    def _set(self) -> list[Shape]:
        """Its shapes, from its left and top."""
        view, em = self.document.view, self.style.font_size
        asked = self.document.projection, view.letters, view.equation, self.document.settings
        equation = equation_of(*asked)
        laid = [
            each._replace(widths=tuple((1.0 + _WIDER) * wide for wide in each.widths))
            for each in laid_out(equation)
        ]
        room_em = self.size[0] / em + _ROUNDING_EM if self.size[0] else inf
        gap_em = GAP_EM if equation.result or len(laid) == 1 else APART_EM
        lines, right_em = list[list[_EquationPart]](), 0.0
        for place, each in enumerate(laid):
            sign = each.lead if len(laid) == 1 else ""
            if equation.factors and equation.result and place == len(laid) - 1:
                sign = "="
            before = (1.0 + _WIDER) * width_em(sign) + GAP_EM if sign else 0.0
            wide = each.width + before
            if not lines or right_em + gap_em + wide > room_em:
                right_em = -gap_em
                lines.append([])
            right_em += gap_em + wide
            if right_em > room_em:
                mm = (f"{side * em / PX_PER['mm']:.3g}" for side in (room_em, right_em))
                raise Refusal.saying(REFUSALS["too-narrow"], *mm, f"{em * 72.0 / DPI:.3g}")
            lines[-1].append(_EquationPart(each, sign, wide))
        shapes, top = list[Shape](), _RULE_EM * em / 2.0
        for line in lines:
            rows = [em * max(part.laid.heights[row] for part in line) for row in range(4)]
            low, left, names = top + sum(rows), 0.0, list[Shape]()
            for part in line:
                if part.sign:
                    shapes.append(self._text(part.sign, left, (top + low) / 2.0 + _AXIS_EM * em))
                left += em * (part.width_em - part.laid.width)
                shapes += self._matrix(part.laid, left, top, rows)
                name = f"${part.laid.term.name}$"
                if len(laid) > 1 and part.laid.term.name:
                    middle = left + em * (part.laid.width - width_em(name)) / 2.0
                    names.append(self._text(name, middle, low + _CAPTION_EM * em))
                left += em * (part.laid.width + gap_em)
            shapes += names
            top = low + em * (_LINES_APART_EM + _CAPTION_EM * bool(names))
        return shapes

    @cached_property
    def needed(self) -> tuple[float, float]:
        """The width and the height that it needs, in pixels."""
        box = box_of(self._set, "")
        return (0.0, 0.0) if box is None else (box[2], box[3])

    def shapes(self, hidden: str = "", watch: object = None) -> list[Shape]:
        free = (side - used for side, used in zip(self.size, self.needed, strict=True))
        right, down = (each / 2.0 for each in free)
        return [moved(shape, right, down) for shape in self._set]

    def _matrix(
        self, laid: MatrixLayout, left: float, top: float, rows: list[float]
    ) -> Iterator[Shape]:
        em, rule, y = self.style.font_size, _RULE_EM * self.style.font_size, top
        ends, low = (left + rule / 2.0, left + em * laid.width - rule / 2.0), top + sum(rows)
        for x, foot in zip(ends, (_FOOT_EM * em, -_FOOT_EM * em), strict=True):
            points = [(x + foot, top), (x, top), (x, low), (x + foot, low)]
            yield LineShape(points, rgb(self.style.ink), 1.0, rule)
        for high, cells in zip(rows, laid.cells, strict=True):
            x = left + BRACKET_EM * em
            for wide, text in zip(laid.widths, cells, strict=True):
                line = line_of(text, formula=1.0)
                base = y + (high + em * (line.box[1] + line.box[3])) / 2.0
                yield self._text(text, x + em * (wide - line.width) / 2.0, base)
                x += em * wide
            y += high

    def _text(self, text: str, left: float, base: float) -> TextShape:
        style, pieces = self.style, line_of(text, formula=1.0).pieces
        widths = tuple(piece_of(piece, is_tex).width for piece, is_tex, *_ in pieces)
        return TextShape(
            LabelText(text, pieces, widths, (left, base), 0.0, style.font_size, style.tone(""),
                      style.background, 1.0, False),
            (left, base), style.font_size,
        )  # fmt: skip
