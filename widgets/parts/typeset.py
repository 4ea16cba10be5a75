"""Typeset formulas: stacked fractions, matrices in brackets, bold vectors.

A formula is a text. Fractions come from `app.model.formula.stacked_fraction`, matrices from
`matrix`; ``_`` begins a subscript, ``^`` a superscript, and `ARROW` follows the letter or word of a
vector.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QAction,
    QFont,
    QFontMetricsF,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QPainter,
    QPaintEvent,
    QPen,
)

from app.model.formula import ARROW, CLOSE, OPEN, OVER
from widgets.parts.highlight import MarkedLabel, paint_highlight

SMALLER = 0.8
"""Size of the letters of a fraction, relative to its line."""
SMALL = 0.75
"""Size of subscripts and superscripts, relative to the line."""
LOWER, HIGHER = 0.2, -0.35
"""Shift of subscripts and superscripts below the line, in heights of a line."""
RULE_PX, ROOM_PX = 1.2, 2.0
"""Thickness of a fraction's line and of a bracket, and the gap beside them."""
FOOT_PX = 4.0
"""Length of the feet of a bracket."""
BETWEEN_COLUMNS, BETWEEN_ROWS = 0.7, 0.15
"""Gaps in a matrix, in heights of a line."""
LEAST_EM = 8
"""Least width of a formula that shrinks, in heights of a line."""

_SIGNS = (OPEN, "[", "_", "^", ARROW, "\n")
_PIECE = re.compile(
    "_(?P<below>[^\\W_]*(?:\u2192[^\\W_]+)?)|\\^(?P<above>[-−]?[^\\W_]*)"
    f"|(?<![^\\W\\d_])(?P<vector>[^\\W\\d_]+){ARROW}|(?P<plain>.)"
)


@dataclass(frozen=True)
class Typeset:
    """A laid-out formula; coordinates are in pixels from the left end of its line.

    Attributes
    ----------
    ascent, descent : float
        Height above and below the line.
    runs : tuple of (float, float, str, QFont)
        Texts with their left end, their shift below the line, and their font.
    cells : tuple of QRectF
        The cells of a matrix, row by row.
    """

    width: float
    ascent: float
    descent: float
    runs: tuple[tuple[float, float, str, QFont], ...] = ()
    rules: tuple[QLineF, ...] = field(default=(), hash=False)
    cells: tuple[QRectF, ...] = field(default=(), hash=False)

    @property
    def height(self) -> float:
        return self.ascent + self.descent

    @property
    def below_middle(self) -> float:
        """Distance of the line below the middle."""
        return (self.ascent - self.descent) / 2.0

    def at(self, x: float, y: float) -> Typeset:
        """Return a copy that is moved to the right and down, with the same width."""
        return Typeset(
            self.width, self.ascent - y, self.descent + y,
            tuple((left + x, base + y, text, font) for left, base, text, font in self.runs),
            tuple(rule.translated(x, y) for rule in self.rules),
            tuple(cell.translated(x, y) for cell in self.cells),
        )  # fmt: skip

    def paint(self, painter: QPainter, x: float, y: float) -> None:
        """Paint the formula with the painter's pen."""
        font, pen = painter.font(), painter.pen()
        for left, base, text, its_font in self.runs:
            painter.setFont(its_font)
            painter.drawText(QPointF(x + left, y + base), text)
        painter.setFont(font)
        painter.setPen(QPen(pen.color(), RULE_PX))
        painter.drawLines([rule.translated(x, y) for rule in self.rules])
        painter.setPen(pen)


def typeset(text: str, font: QFont) -> Typeset:
    """Lay out a formula, or several lines of them."""
    if not any(sign in text for sign in _SIGNS):  # the usual case: a running number
        return _run(text, font)
    return _laid_out(text, font.toString())


@lru_cache(maxsize=1024)
def _laid_out(text: str, described: str) -> Typeset:
    font = QFont()
    font.fromString(described)
    lines = [_TypesetReader(line).line(font) for line in text.split("\n")]
    room = BETWEEN_ROWS * QFontMetricsF(font).height()
    placed, y = [], 0.0
    for number, line in enumerate(lines):
        y += line.ascent + lines[number - 1].descent + room if number else 0.0
        placed.append(line.at(0.0, y))
    return _together(placed, max(line.width for line in lines))


def _together(parts: Sequence[Typeset], width: float, *rules: QLineF) -> Typeset:
    """Join parts that are already placed."""
    return Typeset(
        width,
        max(part.ascent for part in parts),
        max(part.descent for part in parts),
        tuple(run for part in parts for run in part.runs),
        (*(rule for part in parts for rule in part.rules), *rules),
        tuple(cell for part in parts for cell in part.cells),
    )


def _resized(font: QFont, factor: float) -> QFont:
    other = QFont(font)
    if font.pointSizeF() > 0.0:
        other.setPointSizeF(factor * font.pointSizeF())
    else:
        other.setPixelSize(round(factor * font.pixelSize()))
    return other


def _axis(font: QFont) -> float:
    """Return the height of a minus sign, and of a fraction's line, above the line."""
    return QFontMetricsF(font).strikeOutPos()


class _TypesetReader:
    """Reads a formula from left to right and lays it out."""

    def __init__(self, text: str) -> None:
        self._text, self._at = text, 0

    def line(self, font: QFont, ends: str = "") -> Typeset:
        """Lay out a part of the formula up to one of the signs that end it."""
        metrics = QFontMetricsF(font)
        parts: list[Typeset] = [Typeset(0.0, metrics.ascent(), metrics.descent())]
        x = 0.0
        for part in self._beside(font, ends):
            parts.append(part.at(x, 0.0))
            x += part.width
        return _together(parts, x)

    def _beside(self, font: QFont, ends: str) -> Iterable[Typeset]:
        plain = ""
        while self._at < len(self._text) and self._text[self._at] not in ends:
            sign = self._text[self._at]
            piece = _PIECE.match(self._text, self._at)
            assert piece is not None
            if sign not in (OPEN, "[") and piece["plain"] is not None:
                plain += sign
                self._at += 1
                continue
            if plain:
                yield _run(plain, font)
                plain = ""
            if sign == OPEN:
                yield self._fraction(font)
            elif sign == "[":
                yield self._matrix(font)
            else:
                self._at = piece.end()
                yield _piece(piece, font)
        if plain:
            yield _run(plain, font)

    def _taken(self, *signs: str) -> str:
        """Read the next sign, which must be one of `signs`."""
        sign = self._text[self._at : self._at + 1]
        if sign not in signs:
            raise ValueError(f"{self._text}: {' or '.join(signs)} at {self._at}")
        self._at += 1
        return sign

    def _fraction(self, font: QFont) -> Typeset:
        smaller = _resized(font, SMALLER)
        self._taken(OPEN)
        above = _tight(self.line(smaller, OVER))
        self._taken(OVER)
        below = _tight(self.line(smaller, CLOSE))
        self._taken(CLOSE)
        width, axis = max(above.width, below.width) + 2.0 * ROOM_PX, _axis(font)
        placed = [
            above.at((width - above.width) / 2.0, -axis - ROOM_PX - above.descent),
            below.at((width - below.width) / 2.0, -axis + ROOM_PX + below.ascent),
        ]
        rule = QLineF(RULE_PX, -axis, width - RULE_PX, -axis)
        whole = _together(placed, width, rule)
        return replace(whole, ascent=whole.ascent + 1.0, descent=whole.descent + 1.0)

    def _matrix(self, font: QFont) -> Typeset:
        rows: list[list[Typeset]] = []
        sign = self._taken("[")
        while sign != "]":
            if sign != "&":
                rows.append([])
            rows[-1].append(self.line(font, "&;]"))
            sign = self._taken("&", ";", "]")
        height = QFontMetricsF(font).height()
        inside, gap = FOOT_PX + ROOM_PX, BETWEEN_COLUMNS * height
        columns = [max(cell.width for cell in column) for column in zip(*rows, strict=True)]
        placed, cells, y = [], [], 0.0
        for row in rows:
            above = max(cell.ascent for cell in row)
            below = max(cell.descent for cell in row)
            right = inside - gap
            for cell, width in zip(row, columns, strict=True):
                right += gap + width
                placed.append(cell.at(right - cell.width, y + above))
                cells.append(QRectF(right - width, y, width, above + below))
            y += above + below + BETWEEN_ROWS * height
        y -= BETWEEN_ROWS * height
        width = sum(columns) + gap * (len(columns) - 1) + 2.0 * inside
        brackets = (
            QLineF(*ends)
            for x, foot in ((RULE_PX, FOOT_PX), (width - RULE_PX, -FOOT_PX))
            for ends in ((x, 0.0, x, y), (x, 0.0, x + foot, 0.0), (x, y, x + foot, y))
        )
        whole = _together(placed, width, *brackets)
        room = Typeset(width, RULE_PX, y + RULE_PX)  # for the brackets' own lines
        whole = replace(_together([whole, room], width), cells=tuple(cells))
        return whole.at(0.0, -_axis(font) - y / 2.0)


def _run(text: str, font: QFont) -> Typeset:
    metrics = QFontMetricsF(font)
    width = metrics.horizontalAdvance(text)
    return Typeset(width, metrics.ascent(), metrics.descent(), ((0.0, 0.0, text, font),))


def _piece(piece: re.Match[str], font: QFont) -> Typeset:
    """Lay out a subscript, a superscript or a vector."""
    if piece["vector"] is not None:
        bold = QFont(font)
        bold.setBold(True)
        return _run(piece["vector"], bold)
    is_below = piece["below"] is not None
    shift = (LOWER if is_below else HIGHER) * QFontMetricsF(font).height()
    text = piece["below"] if is_below else piece["above"]
    return _run(text, _resized(font, SMALL)).at(0.0, shift)


def _tight(part: Typeset) -> Typeset:
    """Remove the space that a font leaves above and below its letters."""
    ascent = descent = 0.0
    for _, base, text, font in part.runs:
        metrics = QFontMetricsF(font)
        rect = metrics.tightBoundingRect(text).translated(0.0, base)
        ascent = max(ascent, -rect.top(), metrics.capHeight() - base)
        descent = max(descent, rect.bottom())
    return Typeset(part.width, ascent, descent, part.runs, part.rules)


def matrix(rows: Iterable[Iterable[str]]) -> str:
    """Return a matrix of cells as a formula."""
    return f"[{';'.join('&'.join(row) for row in rows)}]"


_FRACTION = re.compile(f"{OPEN}([^{OPEN}{OVER}{CLOSE}]*){OVER}([^{OPEN}{OVER}{CLOSE}]*){CLOSE}")
_MATRIX = re.compile(r"\[([^\[\]]*)\]")


def in_line(text: str) -> str:
    """Write a formula as plain text: fractions with a slash, a matrix in rows."""

    def bracketed(text: str, signs: str) -> str:
        is_one = text.startswith("|") and text.find("|", 1) == len(text) - 1
        return f"({text})" if re.search(signs, text) and not is_one else text

    def fraction(match: re.Match[str]) -> str:
        above, below = bracketed(match[1], "[−+]"), bracketed(match[2], r"[−+·\s]")
        return f"{above}/{below}"

    text = _FRACTION.sub(fraction, text)
    text = _MATRIX.sub(lambda match: match[1].replace("&", "\t").replace(";", "\n"), text)
    return text.replace(ARROW, "")


class TypesetLabel(MarkedLabel):
    """Words or a formula; copying an abbreviated number copies all digits.

    Attributes
    ----------
    formula : str
        The formula, if it is one; `text` is the same as plain text.
    exact : str
        The text to copy by the keyboard or the right mouse button, if any.
    shrinks : bool
        Whether a formula that is too wide is drawn smaller.
    cell : int or None
        The cell of a matrix, counted row by row, that is marked instead of the whole.
    """

    def __init__(self) -> None:
        super().__init__()
        self.formula, self.exact, self.shrinks = "", "", False
        self.cell: int | None = None
        self._copy = QAction(self.tr("Copy with all digits"), self)
        self._copy.triggered.connect(self._to_clipboard)

    def set_formula(self, text: str) -> None:
        self.formula = text
        self.setText(in_line(text))
        self.updateGeometry()
        self.update()

    def set_words(self, text: str) -> None:
        self.formula = ""
        self.setText(text)

    def set_exact(self, text: str) -> None:
        self.exact = text
        if not self.actions():
            self.addAction(self._copy)
            self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
            flags = Qt.TextInteractionFlag
            self.setTextInteractionFlags(
                flags.TextSelectableByMouse | flags.TextSelectableByKeyboard
            )
            self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)

    def _to_clipboard(self) -> None:
        QGuiApplication.clipboard().setText(self.exact)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if self.exact and event.matches(QKeySequence.StandardKey.Copy):
            self._to_clipboard()
        else:
            super().keyPressEvent(event)

    def sizeHint(self) -> QSize:
        if not self.formula:
            return super().sizeHint()
        laid_out, margins = typeset(self.formula, self.font()), self.contentsMargins()
        return QSize(
            math.ceil(laid_out.width) + 2 + margins.left() + margins.right(),
            math.ceil(laid_out.height) + margins.top() + margins.bottom(),
        )

    def minimumSizeHint(self) -> QSize:
        if not self.formula:
            return super().minimumSizeHint()
        hint = self.sizeHint()
        least = LEAST_EM * self.fontMetrics().height()
        return QSize(min(hint.width(), least), hint.height()) if self.shrinks else hint

    def paintEvent(self, event: QPaintEvent) -> None:
        if not self.formula:
            super().paintEvent(event)
            return
        laid_out, room = typeset(self.formula, self.font()), QRectF(self.contentsRect())
        wanted = laid_out.width + 2.0
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(self.palette().color(self.foregroundRole()))
        painter.save()
        is_right = bool(self.alignment() & Qt.AlignmentFlag.AlignRight)
        painter.translate(room.right() if is_right else room.left(), room.center().y())
        if self.shrinks and wanted > room.width():
            painter.scale(room.width() / wanted, room.width() / wanted)
        x = 1.0 - wanted if is_right else 1.0
        laid_out.paint(painter, x, laid_out.below_middle)
        if self.cell is not None and self.is_marked:
            cell = laid_out.cells[self.cell].translated(x, laid_out.below_middle)
            paint_highlight(self, painter, cell.adjusted(-ROOM_PX, 0.0, ROOM_PX, 0.0))
        painter.restore()
        if self.cell is None and self.is_marked:
            paint_highlight(self, painter, QRectF(self.rect()))
        painter.end()
