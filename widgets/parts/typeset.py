"""Formulas drawn by Qt's painter: stacked fractions, matrices in brackets, and lines of letters.

A formula is a text. Fractions come from `app.model.formula_text.stacked_fraction`, matrices from
`matrix`; `app.lecture.typesetting` sets the rest, in the letters of the pictures and the lessons.
A number alone, in a matrix, or behind an equals sign has the font of the text beside it: it is
drawn while something is dragged, and Qt keeps the pictures of its digits.
"""

import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, lru_cache
from itertools import islice

from PySide6 import QtGui
from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt

from app.lecture.typesetting import Outline, font_file, line_of, piece_of
from app.model.formula import ARROW
from app.model.formula_text import CLOSE, OPEN, OVER
from widgets.parts.panel import MarkedLabel, paint_highlight

LETTERS_EM = 1.19  # size of a formula's letters in the text's: then small letters are as tall
SMALLER = 0.88  # size of the letters of a fraction, relative to its line
AXIS_EM = 0.28  # height of a minus sign, and of a fraction's line, above the line
RULE_PX, ROOM_PX = 1.2, 2.0  # thickness of fractions' lines and brackets, and the gap beside them
FOOT_PX = 4.0  # length of the feet of a bracket
BETWEEN_COLUMNS, BETWEEN_ROWS = 0.7, 0.15  # gaps in a matrix, in heights of a line
LEAST_EM = 8  # least width of a formula that shrinks, in heights of a line

_BLOCK = re.compile(
    rf"{OPEN}(?P<above>[^{OPEN}{OVER}{CLOSE}]*){OVER}(?P<below>[^{OPEN}{OVER}{CLOSE}]*){CLOSE}"
    r"|\[(?P<matrix>[^\[\]]*)\]"
)
_INDEXED = re.compile("((?<![^\\W_])[^\\W_]+_[^\\W_]+(?:\u2192[^\\W_]+)?)")
_IS_FORMULA = re.compile(  # not the powers of ten of a number
    rf"(?:(?<!\d)|(?!e[-+]?\d))[^\W\d⁰¹²³⁴-⁹]|[{OPEN}\[\n:]"
)


@cache
def bring_font() -> None:
    QtGui.QFontDatabase.addApplicationFont(font_file("DejaVuSans"))


def words_font() -> QtGui.QFont:
    """The font of words on paper and in charts; only Linux has it without matplotlib's file."""
    bring_font()
    return QtGui.QFont("DejaVu Sans")


@dataclass(frozen=True)
class Typeset:
    """A laid-out formula; coordinates are in pixels from the left end of its line.

    `letters` are the outlines of formulas. `runs` are numbers with their left end, their shift
    below the line, and their font. `cells` are those of a matrix, row by row.
    """

    width: float
    ascent: float
    descent: float
    letters: QtGui.QPainterPath = field(default_factory=QtGui.QPainterPath, hash=False)
    runs: tuple[tuple[float, float, str, QtGui.QFont], ...] = ()
    rules: tuple[QLineF, ...] = field(default=(), hash=False)
    cells: tuple[QRectF, ...] = field(default=(), hash=False)

    @property
    def height(self) -> float:
        return self.ascent + self.descent

    @property
    def below_middle(self) -> float:
        """Distance of the line below the middle."""
        return (self.ascent - self.descent) / 2.0

    def at(self, x: float, y: float) -> "Typeset":
        """Return a copy that is moved to the right and down, with the same width."""
        return Typeset(
            self.width, self.ascent - y, self.descent + y, self.letters.translated(x, y),
            tuple((left + x, base + y, text, font) for left, base, text, font in self.runs),
            tuple(rule.translated(x, y) for rule in self.rules),
            tuple(cell.translated(x, y) for cell in self.cells),
        )  # fmt: skip

    def paint(self, painter: QtGui.QPainter, x: float, y: float) -> None:
        font, pen = painter.font(), painter.pen()
        for left, base, text, its_font in self.runs:
            painter.setFont(its_font)
            painter.drawText(QPointF(x + left, y + base), text)
        painter.setFont(font)
        painter.fillPath(self.letters.translated(x, y), pen.brush())
        painter.setPen(QtGui.QPen(pen.color(), RULE_PX))
        painter.drawLines([rule.translated(x, y) for rule in self.rules])
        painter.setPen(pen)


def typeset(text: str, font: QtGui.QFont, *, is_formula: bool = False) -> Typeset:
    """Lay out a formula, or several lines of them; a number alone, only if it `is_formula`."""
    if not is_formula and _IS_FORMULA.search(text) is None:  # the usual case: a running number
        return words(text, font)
    return _laid_out(text, font.toString())


def words(text: str, font: QtGui.QFont) -> Typeset:
    """Lay out a number or words in their own font; a letter with a subscript is a formula."""
    parts, metrics = list[Typeset](), QtGui.QFontMetricsF(font)
    for number, part in enumerate(_INDEXED.split(text)):
        if number % 2:
            parts.append(_letters(part, em_px(font)))
        else:
            width = metrics.horizontalAdvance(part)
            run = (0.0, 0.0, part, font)
            parts.append(Typeset(width, metrics.ascent(), metrics.descent(), runs=(run,)))
    return parts[0] if len(parts) == 1 else _beside(parts)


@lru_cache(maxsize=1024)
def _laid_out(text: str, described: str) -> Typeset:
    font = QtGui.QFont()
    font.fromString(described)
    return below([_line(line, font) for line in text.split("\n")], font)


def _line(text: str, font: QtGui.QFont) -> Typeset:
    """Lay out fractions, matrices and what is between them."""
    metrics, em = QtGui.QFontMetricsF(font), em_px(font)
    parts, at = [Typeset(0.0, metrics.ascent(), metrics.descent())], 0
    for block in _BLOCK.finditer(text):
        parts.append(_letters(text[at : block.start()], em))
        if block["matrix"] is None:
            parts.append(_fraction(block["above"], block["below"], em))
        else:
            parts.append(_matrix(block["matrix"], font))
        at = block.end()
    head, sign, value = text[at:].rpartition(" = ")
    is_number = bool(sign) and _IS_FORMULA.search(value) is None
    parts.append(_letters(head + sign if is_number else text[at:], em))
    if is_number:
        parts.append(words(value, font))
    return _beside(parts)


def _beside(parts: Sequence[Typeset]) -> Typeset:
    placed, x = [], 0.0
    for part in parts:
        placed.append(part.at(x, 0.0))
        x += part.width
    return _together(placed, x)


def _together(parts: Sequence[Typeset], width: float, *rules: QLineF) -> Typeset:
    """Join parts that are already placed."""
    letters = QtGui.QPainterPath()
    letters.setFillRule(Qt.FillRule.WindingFill)
    for part in parts:
        letters.addPath(part.letters)
    return Typeset(
        width,
        max(part.ascent for part in parts),
        max(part.descent for part in parts),
        letters,
        tuple(run for part in parts for run in part.runs),
        (*(rule for part in parts for rule in part.rules), *rules),
        tuple(cell for part in parts for cell in part.cells),
    )


def below(lines: Sequence[Typeset], font: QtGui.QFont) -> Typeset:
    placed, y, room = [], 0.0, BETWEEN_ROWS * QtGui.QFontMetricsF(font).height()
    for number, line in enumerate(lines):
        y += line.ascent + lines[number - 1].descent + room if number else 0.0
        placed.append(line.at(0.0, y))
    return _together(placed, max(line.width for line in lines))


@lru_cache(maxsize=512)
def _letters(text: str, em: float) -> Typeset:
    """Lay out a line without fractions, as high as its ink."""
    line, letters = line_of(text, formula=LETTERS_EM), QtGui.QPainterPath()
    for piece, is_tex, size, x in line.pieces:
        scaled = QtGui.QTransform.fromScale(size * em, size * em) * QtGui.QTransform.fromTranslate(
            x * em, 0.0
        )
        for _, path in outlines_of(piece, is_tex):
            letters.addPath(scaled.map(path))
    _, low, _, high = line.box
    return Typeset(line.width * em, high * em, -low * em, letters)


def _fraction(above: str, below: str, em: float) -> Typeset:
    over, under = (_letters(part.strip(), SMALLER * em) for part in (above, below))
    width, axis = max(over.width, under.width) + 2.0 * ROOM_PX, AXIS_EM * em
    placed = [
        over.at((width - over.width) / 2.0, -axis - ROOM_PX - over.descent),
        under.at((width - under.width) / 2.0, -axis + ROOM_PX + under.ascent),
    ]
    whole = _together(placed, width, QLineF(RULE_PX, -axis, width - RULE_PX, -axis))
    return replace(whole, ascent=whole.ascent + 1.0, descent=whole.descent + 1.0)


def _matrix(text: str, font: QtGui.QFont) -> Typeset:
    rows = [[typeset(cell, font) for cell in row.split("&")] for row in text.split(";")]
    height = QtGui.QFontMetricsF(font).height()
    inside, gap = FOOT_PX + ROOM_PX, BETWEEN_COLUMNS * height
    columns = [max(cell.width for cell in column) for column in zip(*rows, strict=True)]
    placed, cells, y = [], [], 0.0
    for row in rows:
        above, below = max(cell.ascent for cell in row), max(cell.descent for cell in row)
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
    room = Typeset(width, RULE_PX, y + RULE_PX)  # for the brackets' own lines
    whole = replace(_together([*placed, room], width, *brackets), cells=tuple(cells))
    return whole.at(0.0, -QtGui.QFontMetricsF(font).strikeOutPos() - y / 2.0)


# --------------------------------------------------------------------------- outlines


def em_px(font: QtGui.QFont) -> float:
    """Return the pixels of an em on the screen; documents for paper are laid out in them, too.

    Do not ask a layout's paint device: it is not a QObject, and when it is gone PySide takes
    whatever lies at its address next for it.
    """
    return float(font.pixelSize()) if font.pixelSize() > 0 else font.pointSizeF() * _dpi() / 72.0


@lru_cache(maxsize=1)
def _dpi() -> float:
    return QtGui.QGuiApplication.primaryScreen().logicalDotsPerInchY()


@lru_cache(maxsize=1024)
def outlines_of(piece: str, is_tex: bool) -> tuple[tuple[str, QtGui.QPainterPath], ...]:
    """Return outlines in em, y downwards, with the baseline at 0: letters and the rest.

    Each part has the name of its letter, as of `Outline.letters`, or none.
    """
    whole, parts, at = piece_of(piece, is_tex), list[tuple[str, QtGui.QPainterPath]](), 0
    for name, begin, end in (*whole.letters, ("", len(whole.codes), len(whole.codes))):
        if at < begin:
            parts.append(("", _path(whole, at, begin)))
        if name:
            parts.append((name, _path(whole, begin, end)))
        at = end
    return tuple(parts)


def _path(whole: Outline, place: int, end: int) -> QtGui.QPainterPath:
    path = QtGui.QPainterPath()
    path.setFillRule(Qt.FillRule.WindingFill)
    draw: dict[int, Callable[..., None]]
    draw = {1: path.moveTo, 2: path.lineTo, 3: path.quadTo, 4: path.cubicTo}
    points = (whole.vertices[place:end] * (1.0, -1.0)).tolist()
    read = zip(whole.codes[place:end].tolist(), points, strict=True)
    for code, point in read:
        if code in draw:
            others = islice(read, {3: 1, 4: 2}.get(code, 0))  # of a curve
            draw[code](*point, *(x for _, other in others for x in other))
        else:
            path.closeSubpath()
    return path


def paint_brackets(painter: QtGui.QPainter, box: QRectF, foot: float) -> None:
    """Draw the brackets of a matrix with the painter's pen."""
    top, bottom = box.top(), box.bottom()
    for x, inward in ((box.left(), foot), (box.right(), -foot)):
        corners = ((x + inward, top), (x, top), (x, bottom), (x + inward, bottom))
        painter.drawPolyline([QPointF(*corner) for corner in corners])


def fill_line(
    painter: QtGui.QPainter,
    text: str,
    em: float,
    place: tuple[float, float],
    brush: QtGui.QBrush | QtGui.QColor,
    inks: Mapping[str, QtGui.QColor],
) -> None:
    """Draw a line of a formula; letters may have colours of their own, by their names."""
    for piece, is_tex, size, x in line_of(text, formula=1.0).pieces:
        painter.save()
        painter.translate(place[0] + x * em, place[1])
        painter.scale(size * em, size * em)
        for name, path in outlines_of(piece, is_tex):
            painter.fillPath(path, inks.get(name, brush))
        painter.restore()


def resized(font: QtGui.QFont, factor: float) -> QtGui.QFont:
    other = QtGui.QFont(font)
    if font.pointSizeF() > 0.0:
        other.setPointSizeF(factor * font.pointSizeF())
    else:
        other.setPixelSize(round(factor * font.pixelSize()))
    return other


def matrix(rows: Iterable[Iterable[str]]) -> str:
    return f"[{';'.join('&'.join(row) for row in rows)}]"


def in_line(text: str) -> str:
    """Write a formula as plain text: fractions with a slash, a matrix in rows."""

    def bracketed(text: str, signs: str) -> str:
        is_one = text.startswith("|") and text.find("|", 1) == len(text) - 1
        return f"({text})" if re.search(signs, text) and not is_one else text

    def written(block: re.Match[str]) -> str:
        if block["matrix"] is not None:
            return block["matrix"].replace("&", "\t").replace(";", "\n")
        above, below = bracketed(block["above"], "[−+]"), bracketed(block["below"], r"[−+·\s]")
        return f"{above}/{below}"

    return _BLOCK.sub(written, text).replace(ARROW, "")


class TypesetLabel(MarkedLabel):
    """Words or a `formula`; the keyboard or the right mouse button copies its `exact` text.

    A formula that `shrinks` is drawn smaller if it is too wide. `cell` is the cell of a matrix,
    counted row by row, that is marked instead of the whole.
    """

    def __init__(self) -> None:
        super().__init__()
        self.formula, self.exact, self.shrinks = "", "", False
        self.cell: int | None = None
        self._copy = QtGui.QAction(self.tr("Copy with all digits"), self)
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
        QtGui.QGuiApplication.clipboard().setText(self.exact)

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        if self.exact and event.matches(QtGui.QKeySequence.StandardKey.Copy):
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

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:
        if not self.formula:
            super().paintEvent(event)
            return
        laid_out, room = typeset(self.formula, self.font()), QRectF(self.contentsRect())
        wanted = laid_out.width + 2.0
        with QtGui.QPainter(self) as painter:
            painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
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
