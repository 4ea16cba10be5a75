"""An equation as a slide: matrices in letters that the back row can read.

A cell has the colour of the axis that it is made of. Cells that the controls of the slide change
are framed.
"""

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFont, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.drawings.style import LIGHT, Style, tone
from app.lecture.copying import as_text
from app.lecture.equation import Equation, Term, equation_of
from app.lecture.equation_form import APART_EM, BRACKET_EM, GAP_EM, MatrixLayout, laid_out, width_em
from app.lecture.highlight import ENDS, OBJECT_AXES
from app.lecture.notation import letters_in
from app.lecture.typesetting import line_of, piece_of
from app.model.parameters import PARAMETERS
from app.model.refusal import Refusal
from widgets.parts.messages import sentence
from widgets.parts.panel import PROJECTION, Changed, Readable, ShownData, faded
from widgets.parts.typeset import fill_line, paint_brackets

LARGEST_EM, LEAST_EM = 0.058, 0.034
"""Sizes of the letters, in heights of the screen. A picture beside the equation gives way before
they are smaller."""
LEAST_CELL, USUAL_CELL = 0.08, 0.155
"""Heights of a cell, in heights of the screen: in a product, and of a matrix alone."""
WIDEST_EM = 4.6  # width of the columns of a matrix alone, where there is room
EDGE = 0.05  # free at the left and at the right, in heights of the screen
_CAPTION = 0.85
_WORD = 0.55  # size of a word below a part of a matrix


def _changed_by(path: str) -> tuple[str, ...]:
    """Return the fields that a control changes, in the matrices' terms."""
    if path.startswith("settings."):
        return (path,)
    name = path.rpartition(".")[2]
    return PARAMETERS[name].fields if name in PARAMETERS else (name,)


class EquationSlide(QWidget):
    concerns = PROJECTION | {"view", "settings"}
    filled = Signal()  # the equation, or its size, may be another one

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self._shown: ShownData | None = None
        self._text, self._controls = "", frozenset[str]()
        self._equation: Equation | None = None
        self._problem = ""
        self._laid: tuple[MatrixLayout, ...] = ()
        self._style = LIGHT
        self._hues = dict[str, str]()  # of letters with the colour of what the picture names so
        self._screen_px = 1.0
        self._is_slide = False
        self.cells: list[QRectF] = []  # cells and names; of a 0 its digit alone
        self.brackets: list[QRectF] = []
        self._readable = Readable(self, self._fill, partial(getattr, self, "_is_slide"))
        self.begin_gesture = self._readable.begin_gesture
        self.end_gesture = self._readable.end_gesture
        self.hide()

    # -- the model

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Show the equation of a view, and frame what its controls change."""
        self._shown, view = shown, shown.document.view
        self._text = view.equation
        self._controls = frozenset(field for path in view.controls for field in _changed_by(path))
        self._readable.changed()

    def set_style(self, style: Style) -> None:
        self._style = style
        self._readable.changed()

    def set_screen(self, screen_px: float) -> None:
        self._screen_px = screen_px
        self._readable.changed()

    def set_is_slide(self, asked: bool) -> None:
        """Note whether the equation is the slide; otherwise nothing is computed."""
        self._is_slide = asked
        self._readable.settle()

    def _fill(self) -> None:
        assert self._shown is not None
        document = self._shown.document
        letters = document.view.letters
        self._hues = self._shown.hues(self._style)
        try:
            equation = equation_of(document.projection, letters, self._text, document.settings)
        except Refusal as error:  # another lens may lack a matrix
            self._equation, self._laid, self._problem = None, (), sentence(error)
        else:
            self._equation, self._problem = equation, ""
            self._laid = tuple(laid_out(equation))
            texts = [
                as_text(term.matrix, term.letters, formulas=not equation.is_in_numbers)
                for term in equation.terms
            ]
            self.setAccessibleName("\n".join(texts))
        self.update()
        self.filled.emit()

    # -- places

    def needs_all(self, width: float) -> bool:
        """Whether the equation would be too small in a part of this width, or is none."""
        return bool(self._laid) and self.em_in(width, self.height()) < LEAST_EM * self._screen_px

    def em_in(self, width: float, height: float) -> float:
        """Return the size of the letters with which the equation fits, in px."""
        room = width - 2.0 * EDGE * self._screen_px
        tall = max(sum(each.heights) for each in self._laid) + max(0.6, 0.3 + self._caption_em)
        em = min(LARGEST_EM * self._screen_px, room / self._least_width, height / tall)
        return max(8.0, em)

    @property
    def _is_product(self) -> bool:
        return len(self._laid) > 1

    @property
    def _caption_em(self) -> float:
        """The height in em of what stands below: names, or words that say what parts do."""
        has_words = self._laid[0].term.matrix.name == "view_from_world"
        return 2.0 * _CAPTION if self._is_product else 1.5 * has_words

    @property
    def _has_result(self) -> bool:
        return self._is_product and self._equation is not None and bool(self._equation.result)

    @property
    def _least_width(self) -> float:
        """The width of the equation in em, with the narrowest columns."""
        return sum(each.width for each in self._laid) + self._beside

    @property
    def _beside(self) -> float:
        """The width in em of everything but the matrices."""
        if not self._is_product:
            return width_em(self._laid[0].lead) + 2.0 * GAP_EM
        equals = width_em("=") + 2.0 * GAP_EM if self._has_result else 0.0
        return self._gap_em * len(self._laid) + equals

    @property
    def _gap_em(self) -> float:
        return GAP_EM if self._has_result or not self._is_product else APART_EM

    # -- painting

    def paintEvent(self, _event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self.cells, self.brackets = [], []
            if self._problem:
                flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
                painter.setPen(self.palette().windowText().color())
                painter.drawText(self.rect().adjusted(40, 40, -40, -40), flags, self._problem)
            elif self._laid:
                self._paint(painter)

    def _paint(self, painter: QPainter) -> None:
        em, least_px = self.em_in(self.width(), self.height()), LEAST_CELL * self._screen_px
        room = self.width() - 2.0 * EDGE * self._screen_px
        caption = self._caption_em * em
        usual, high, stretch = least_px, self.height() - caption, 0.0
        if not self._is_product:
            usual, high = USUAL_CELL * self._screen_px, min(high, 0.86 * self.height())
            free = room / em - self._least_width
            stretch = max(0.0, min(free, 4.0 * WIDEST_EM - sum(self._laid[0].widths)))
        needed = [em * max(each.heights[row] for each in self._laid) for row in range(4)]
        level = min((high - sum(sorted(needed)[low:])) / low for low in (1, 2, 3, 4))
        heights = [max(each, min(usual, level)) for each in needed]
        x = (self.width() - em * (self._least_width + stretch)) / 2.0
        top = (self.height() - sum(heights) - caption) / 2.0
        middle = top + sum(heights) / 2.0
        ink = QColor(self._style.ink)
        if not self._is_product:
            x = self._draw(painter, self._laid[0].lead, em, x, middle, ink) + 2.0 * GAP_EM * em
        for place, each in enumerate(self._laid):
            if self._has_result and place == len(self._laid) - 1:
                x += GAP_EM * em
                x = self._draw(painter, "=", em, x, middle, ink) + GAP_EM * em
            widths = [em * (width + stretch / 4.0) for width in each.widths]
            if stretch and sum(widths) >= 4.0 * em * max(each.widths):  # alike where there is room
                widths = [sum(widths) / 4.0] * 4
            left = x
            x = self._paint_matrix(painter, each, em, QPointF(x, top), widths, heights)
            if self._is_product and each.term.name:
                name = f"${each.term.name}$"
                at = (left + x - _CAPTION * em * width_em(name)) / 2.0
                y = top + sum(heights) + 0.55 * caption
                self._draw(painter, name, _CAPTION * em, at, y, QColor(self._style.muted))
            x += self._gap_em * em
            if caption and not self._is_product:
                y, three = top + sum(heights), left + BRACKET_EM * em
                words = self.tr("turns"), self.tr("moves")
                spans = (three, sum(widths[:3])), (three + sum(widths[:3]), widths[3])
                for (start, wide), word in zip(spans, words, strict=True):
                    self._word(painter, word, em, QRectF(start, y, wide, 1.5 * em))

    def _word(self, painter: QPainter, word: str, em: float, place: QRectF) -> None:
        """Write what a part of a matrix does, below it."""
        font = QFont(self.font())
        font.setPixelSize(max(8, round(_WORD * em)))
        painter.setFont(font)
        painter.setPen(QColor(self._style.muted))
        painter.drawText(place, Qt.AlignmentFlag.AlignCenter, word)
        self.cells.append(place)

    def _paint_matrix(
        self,
        painter: QPainter,
        laid: MatrixLayout,
        em: float,
        place: QPointF,
        widths: Sequence[float],
        heights: Sequence[float],
    ) -> float:
        """Paint a matrix at its top left; return its right edge."""
        bracket, foot = BRACKET_EM * em, 0.22 * em
        right, bottom = place.x() + sum(widths) + 2.0 * bracket, place.y() + sum(heights)
        painter.setPen(QPen(QColor(self._style.ink), max(1.5, 0.045 * em)))
        whole = QRectF(place, QPointF(right, bottom))
        sides = place.x(), right - bracket
        self.brackets += [QRectF(x, place.y(), bracket, bottom - place.y()) for x in sides]
        paint_brackets(painter, whole.adjusted(0.05 * em, 0.0, -0.05 * em, 0.0), foot)
        y = place.y()
        for row, height in enumerate(heights):
            x = place.x() + bracket
            for column, width in enumerate(widths):
                cell = QRectF(x, y, width, height)
                line = line_of(laid.cells[row][column], formula=1.0)
                letters = [name for each in line.pieces for name, *_ in piece_of(*each[:2]).letters]
                colour = self._paint_ground(painter, laid.term, row, column, cell, em, letters)
                digit = QRectF(0.0, 0.0, em * line.width, em)
                digit.moveCenter(cell.center())
                self.cells.append(digit if colour == QColor(self._style.muted) else cell)
                left = cell.center().x() - em * line.width / 2.0
                base = cell.center().y() + em * (line.box[1] + line.box[3]) / 2.0
                fill_line(painter, laid.cells[row][column], em, (left, base), colour, self._inks)
                x += width
            y += height
        return right

    def _paint_ground(
        self,
        painter: QPainter,
        term: Term,
        row: int,
        column: int,
        cell: QRectF,
        em: float,
        letters: Sequence[str],
    ) -> QColor:
        """Tint a cell by what it is made of; return the colour of its letters."""
        style, matrix = self._style, term.matrix
        text = matrix.formulas[row][column]
        changed = self._controls.intersection(matrix.fields[row][column])
        if changed:
            shades = [getattr(style, name) for name in ENDS if name in changed]
            shades += [self._hues[name] for name in letters if name in self._hues]
            shade = next(iter(shades), style.accent)
            edge = 0.08 * em
            painter.setPen(QPen(QColor(shade), max(1.5, 0.03 * em)))
            painter.setBrush(faded(shade, 0.25))
            painter.drawRoundedRect(cell.adjusted(edge, edge, -edge, -edge), 2 * edge, 2 * edge)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            return QColor(style.ink)
        names = letters_in(matrix, row, column)
        edge = 0.06 * em
        for name, shade in zip(OBJECT_AXES, (style.u, style.v, style.n), strict=False):
            if name in names:  # of a whole column, also where it is 0
                painter.fillRect(cell.adjusted(edge, 0.0, -edge, 0.0), faded(shade, 0.2))
                return QColor(tone(shade, style.background))
        is_in_numbers = self._equation is not None and self._equation.is_in_numbers
        if matrix.values[row][column] == 0.0 and (text == "0" or is_in_numbers):
            return QColor(style.muted)
        axes = [name for name in ("u", "v", "n") if name in names]
        planes = [name for name in ENDS if name in names]
        if len(axes) == 1:
            shade = getattr(style, axes[0])
            if len(text) == 3:  # a component of the axis
                painter.fillRect(cell.adjusted(0.0, edge, 0.0, -edge), faded(shade, 0.2))
            return QColor(tone(shade, style.background))
        if len(planes) == 1:
            shade = getattr(style, planes[0])
            painter.fillRect(cell.adjusted(edge, edge, -edge, -edge), faded(shade, 0.12))
        return QColor(style.ink)

    @property
    def _inks(self) -> dict[str, QColor]:
        ground = self._style.background
        return {name: QColor(tone(hue, ground)) for name, hue in self._hues.items() if hue}

    def _draw(
        self, painter: QPainter, text: str, em: float, x: float, middle: float, ink: QColor
    ) -> float:
        """Draw on the axis of a line of formula at a height; return the right end."""
        fill_line(painter, text, em, (x, middle + 0.25 * em), ink, self._inks)
        self.cells.append(QRectF(x, middle - em / 2.0, em * width_em(text), em))
        return x + em * width_em(text)
