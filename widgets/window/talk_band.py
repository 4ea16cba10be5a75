"""The band that the class reads during a talk: a title, one line of formula, the step's number.

It stands above the slide, never over it, and has one height all through a talk. Longer texts are
left to the speaker's notes; of a text of which no part fits, the beginning
is shown.
"""

import math
import re
from bisect import bisect_left
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from PySide6 import QtGui
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtWidgets import QApplication, QFrame, QSizePolicy

from app.drawings.style import LIGHT, Style, tone
from app.lessons.lesson import Step
from app.lessons.text import spoken_text
from widgets.parts.layouts import FittedWidget
from widgets.parts.lesson_text import INKS, set_text
from widgets.parts.panel import Changed, ShownData
from widgets.parts.plain import TextDocument
from widgets.parts.translator import off_screen_application

TITLE_SHARE, LINE_SHARE = 0.055, 0.09
"""Largest heights of the title and of the line below it, in heights of the screen."""
GAP_SHARE = 0.0075
"""Free between the title and the line, in heights of the screen: a fraction fills the line."""
TITLES = LINES = (0.036, 0.033, 0.0305)
"""Sizes of letters, in heights of the screen: the largest that fit are taken. Capitals of the
smallest are 2.2 % high."""
SMALLER = (0.028, 0.025, 0.022)  # sizes for a text of which no part fits in those letters
NUMBER_SHARE = 0.024
EDGE_SHARE, TOP_SHARE = 0.05, 0.012  # free at the sides, and above, in heights of the screen
MOST_LINES = 2
_PIECE = re.compile(r"\$\$.+?\$\$|\$.+?\$\S*|\S+", re.DOTALL)
"""A word, or a formula with what follows it directly."""


class _LaidOut(NamedTuple):
    """The texts of a step as they fit the band."""

    title: TextDocument
    words: TextDocument
    shown: str  # the part of the words that fits
    left_out: str  # what the speaker says instead
    is_cut: bool  # no part fits: smaller letters show one, or only its beginning is shown


class TalkBand(FittedWidget, QFrame):
    """A step's title and what it says in two lines at the most.

    `laid` is what it shows.
    """

    concerns = frozenset({"scene", "view"})

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("talkBand")
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._number = self.message = ""
        self._texts: tuple[str, ...] = "", ""
        """The title, and what the line may say: the first that fits is taken."""
        self._ready: dict[tuple[str, ...], _LaidOut] = {}
        self.laid = _LaidOut(TextDocument(), TextDocument(), "", "", False)
        self._screen_px = 0.0
        self._inks: dict[str, str] = {}
        self._style = LIGHT
        self._shown: ShownData | None = None
        self.hide()

    def set_style(self, style: Style) -> None:
        self._style = style
        self._colour()

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Give the letters of formulas the colours of what the pictures name by them."""
        self._shown = shown
        self._colour()

    def _colour(self) -> None:
        if self._shown is not None:
            paper, hues = self._style.background, self._shown.hues(self._style)
            self._inks = {name: tone(hue, paper) for name, hue in hues.items()}
            self.laid.words.setProperty(INKS, self._inks)
            self.update()

    def set_screen(self, screen_px: float) -> None:
        """Take the height from that of the screen."""
        self._screen_px = screen_px
        self.setFixedHeight(round((TOP_SHARE + TITLE_SHARE + GAP_SHARE + LINE_SHARE) * screen_px))

    def show_step(self, step: Step, number: str) -> None:
        self._number, self._texts = number, _texts_of(step)
        self._show()
        self._ready.clear()

    def prepare(self, step: Step) -> None:
        """Lay out a step that may be shown next."""
        if self._screen_px:
            texts = _texts_of(step)
            self._ready[texts] = self._laid_out(texts)

    def show_message(self, note: str) -> None:
        """Show a message below the number of the step; an empty one hides it."""
        self.message = note
        self.update()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.PaletteChange):
            self._fit()

    @property
    def _room(self) -> QRectF:
        edge = EDGE_SHARE * self._screen_px
        return QRectF(self.rect()).adjusted(edge, TOP_SHARE * self._screen_px, -edge, 0.0)

    def _fit(self) -> None:
        self._ready.clear()
        self._show()

    def _show(self) -> None:
        if not self._screen_px:  # no talk: F5 does not wait for the reader of Markdown
            return
        self.laid = self._ready.get(self._texts) or self._laid_out(self._texts)
        self.laid.words.setProperty(INKS, self._inks)
        self.setAccessibleName(spoken_text(f"{self._texts[0]}\n\n{self.laid.shown}"))
        self.update()

    def _laid_out(self, texts: tuple[str, ...]) -> _LaidOut:
        """Take the first of the texts that fits, in the largest letters that do."""
        room, title_px = self._room, math.ceil((TITLE_SHARE + GAP_SHARE) * self._screen_px)
        number_px = 5.0 * NUMBER_SHARE * self._screen_px
        title, words = TextDocument(), TextDocument()
        set_text(title, texts[0], title=True, palette=self.palette())
        for share in TITLES:
            self._lay_out(title, share, room.width() - number_px)
            if title.size().height() <= title_px:
                break
        shown = next((text for text in texts[1:] if self._fits(words, text)), None)
        is_cut = shown is None and len(texts) > 2
        if shown is None:
            shown = self._squeezed(words, texts[-1] if is_cut else "")
        return _LaidOut(title, words, shown, "" if shown == texts[1] else texts[1], is_cut)

    def _squeezed(self, words: TextDocument, text: str) -> str:
        """Lay out as much of a text as fits in smaller letters, at least a word; return it."""
        pieces = _PIECE.findall(text)
        if self._fits(words, text, SMALLER) or len(pieces) < 2:
            return text
        shorter = [f"{' '.join(pieces[:count])} …" for count in range(1, len(pieces))]
        too_long = bisect_left(shorter, True, key=lambda each: not self._fits(words, each, SMALLER))
        shown = shorter[max(0, too_long - 1)]
        self._fits(words, shown, SMALLER)
        return shown

    def _fits(self, words: TextDocument, text: str, letters: tuple[float, ...] = LINES) -> bool:
        """Lay out a text; return whether it fits the line."""
        set_text(words, text, palette=self.palette())
        cursor = QtGui.QTextCursor(words)  # a displayed formula would stand in the middle
        cursor.select(QtGui.QTextCursor.SelectionType.Document)
        left = QtGui.QTextBlockFormat()
        left.setAlignment(Qt.AlignmentFlag.AlignLeft)
        cursor.mergeBlockFormat(left)
        for share in letters:
            self._lay_out(words, share, self._room.width())
            if words.size().height() <= LINE_SHARE * self._screen_px:
                return _lines_of(words) <= MOST_LINES
        return not text

    def _lay_out(self, document: QtGui.QTextDocument, share: float, width: float) -> None:
        font = QtGui.QFont(self.font())
        font.setPixelSize(max(8, round(share * self._screen_px)))
        document.setDefaultFont(font)
        document.setTextWidth(max(1.0, width))

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:
        super().paintEvent(event)
        painter, room = QtGui.QPainter(self), self._room
        below = room.top() + (TITLE_SHARE + GAP_SHARE) * self._screen_px
        free = LINE_SHARE * self._screen_px - self.laid.words.size().height()
        self.laid.title.paint(painter, room.topLeft(), self.palette())
        corner = QPointF(room.left(), below + max(0.0, free / 3.0))
        self.laid.words.paint(painter, corner, self.palette())
        font = QtGui.QFont(self.font())
        font.setPixelSize(max(8, round(NUMBER_SHARE * self._screen_px)))
        painter.setFont(font)
        painter.setPen(self.palette().color(QtGui.QPalette.ColorRole.PlaceholderText))
        right_of = Qt.AlignmentFlag.AlignRight
        painter.drawText(room, right_of | Qt.AlignmentFlag.AlignTop, self._number)
        if self.message:  # over the text that is there
            at_foot = right_of | Qt.AlignmentFlag.AlignBottom
            place = painter.boundingRect(room, at_foot, self.message)
            painter.fillRect(place, self.palette().color(QtGui.QPalette.ColorRole.Window))
            painter.drawText(room, at_foot, self.message)
        painter.end()


def shortened(steps: Iterable[Step], size: tuple[int, int]) -> Iterator[tuple[bool, bool]]:
    """Yield for each step whether its band `is_cut` on a screen, and whether words are left out."""
    application = off_screen_application()
    assert isinstance(application, QApplication)  # it lives as long as the band
    band = TalkBand()
    band.set_screen(float(size[1]))
    band.resize(size[0], band.height())
    for step in steps:
        band.show_step(step, "")
        yield band.laid.is_cut, bool(band.laid.left_out)
    del band  # before the application


def _texts_of(step: Step) -> tuple[str, ...]:
    words = "\n\n".join(part.text for part in step.parts if not part.reveals)
    # The band has no room for a table; such a step shows its equation.
    paragraphs = [each for each in words.split("\n\n") if not each.startswith("|")]
    formulas = [each for each in paragraphs if each.startswith("$$")]
    shorter = ["\n\n".join(formulas), *formulas[:1], *paragraphs[:1]]
    return step.title, words, *filter(None, shorter)


def _lines_of(document: QtGui.QTextDocument) -> int:
    block, lines = document.begin(), 0
    while block.isValid():
        lines += block.layout().lineCount()
        block = block.next()
    return lines
