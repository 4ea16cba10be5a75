"""A lesson's text: Markdown with formulas, without links, pictures or scripts.

`set_text` fills any `QTextDocument`, for the window and for paper; `LessonText` is as high as its
text.
"""

import math
from functools import lru_cache
from pathlib import Path
from string import Template
from typing import Any, cast

from PySide6 import QtCore, QtGui
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QSizePolicy

from app.lecture.typesetting import Outline, outline
from app.lessons.blocks.block import Here, ReadBlock
from app.lessons.marking import digits_shown
from app.lessons.text import DISPLAYED, FORMULA, html_of, readable, spoken_text
from app.model.parameter import read_content
from widgets.parts.messages import FEW, figure_text
from widgets.parts.plain import ReadText, with_native_keys
from widgets.parts.roles import give_role
from widgets.parts.typeset import em_px, fill_line

INKS = "inks"  # a document's property: the colours of letters, ``"#rrggbb"`` by their names
SPACIOUS = "spacious"  # a document's property: room for large fractions and displayed formulas
_KIND = QtGui.QTextFormat.ObjectTypes.UserObject + 1
_TEX, _IS_DISPLAYED, _TAIL = (QtGui.QTextFormat.Property.UserProperty + at for at in (1, 2, 3))
LONGEST_TAIL = 24
"""Most characters behind a formula that are drawn with it: Qt breaks a line behind any object."""
LARGER = 1.12  # size of a formula's letters relative to the text's, whose small letters are taller
DISPLAYED_LARGER = 1.25
"""Size of a formula on its own line relative to one in a line, in a spacious document."""
ROOM_EM = 0.06  # space on both sides of a formula
MAY_BREAK, NO_BREAK = "\u200b", "\u2060"
"""Characters without width: a line may break at the first, but not at the second."""
_PLACE = QtCore.QRegularExpression(f"[{FORMULA}{DISPLAYED}]")
_ENDS = FORMULA, DISPLAYED, "\ufdd0", "\ufdd1", "\0"
"""What ends the word behind a formula, besides spaces: another one, or a table's cell."""
LIST_EM = 0.55  # half the indent of a list: Qt indents by two units
STYLE = Template(read_content(Path(__file__).with_name("content") / "lesson.css"))


def answer_of(part: ReadBlock, here: Here) -> str:
    """Return the right number with its unit, to four digits or more; a `Refusal` names the line."""
    return part.answer_text(here, lambda value: figure_text(value, digits_shown(value, FEW)))


def set_text(
    document: QtGui.QTextDocument,
    text: str,
    *,
    title: bool = False,
    palette: QtGui.QPalette | None = None,
) -> None:
    """Fill a document, which has its font already, with a lesson's Markdown."""
    text = with_native_keys(text)
    html, formulas = html_of(f"## {text}" if title else text)
    line = palette.color(QtGui.QPalette.ColorRole.Mid).name() if palette is not None else "#888888"
    document.setDefaultStyleSheet(STYLE.substitute(line=line))
    document.setDocumentMargin(0.0)
    document.setIndentWidth(LIST_EM * 2.0 * em_px(document.defaultFont()))
    document.setHtml(html)
    layout = document.documentLayout()
    layout.unregisterHandler(_KIND)  # otherwise the handler would be connected again
    layout.registerHandler(_KIND, _formulas())
    cursor = QtGui.QTextCursor(document)
    cursor.beginEditBlock()  # so that it is laid out once
    for tex in formulas:
        cursor = document.find(_PLACE, cursor)
        is_displayed = cursor.selectedText() == DISPLAYED
        kept, plain = cursor.charFormat(), cursor.charFormat()
        begin, behind = cursor.selectionStart(), cursor.selectionEnd()
        try:
            outline(tex)
        except ValueError:  # as it was typed
            cursor.insertText(f"${tex}$", plain)
            continue
        kept.setObjectType(_KIND)
        kept.setProperty(_TEX, tex)
        kept.setProperty(_IS_DISPLAYED, is_displayed)
        tail = _tail(document, behind)
        kept.setProperty(_TAIL, tail)
        cursor.setPosition(begin)
        cursor.setPosition(behind + len(tail), QtGui.QTextCursor.MoveMode.KeepAnchor)
        kept.setVerticalAlignment(QtGui.QTextCharFormat.VerticalAlignment.AlignMiddle)
        # A line with only a formula is as high as one of letters; no line ends beside a formula.
        begins = begin == cursor.block().position() or _at(document, begin - 1).isspace()
        cursor.insertText(MAY_BREAK if begins else NO_BREAK, plain)
        cursor.insertText("\ufffc", kept)
        if not _at(document, cursor.position()).isspace():
            cursor.insertText(NO_BREAK, plain)
    last = QtGui.QTextCursor(document)
    last.movePosition(QtGui.QTextCursor.MoveOperation.End)
    end = last.blockFormat()
    end.setBottomMargin(0.0)
    last.setBlockFormat(end)
    last.endEditBlock()


def _tail(document: QtGui.QTextDocument, place: int) -> str:
    """Return the punctuation or the ending behind a formula, up to a space or another formula."""
    tail, after = "", QtGui.QTextCursor(document)
    after.setPosition(place)
    own = after.charFormat()
    while len(tail) < LONGEST_TAIL:
        letter = _at(document, place + len(tail))
        if letter.isspace() or letter in _ENDS:
            break
        after.setPosition(place + len(tail) + 1)
        if after.charFormat() != own:
            break
        tail += letter
    return tail


def _at(document: QtGui.QTextDocument, place: int) -> str:
    return str(cast(Any, document).characterAt(place))


class _Formulas(QtGui.QPyTextObject):
    """Lays out and draws the formulas of documents, in the colour of the text around them.

    Letters may have colours of their own, by the document's property `INKS`.
    """

    def _set(
        self, document: QtGui.QTextDocument, at: int, form: QtGui.QTextFormat
    ) -> tuple[str, Outline, float, QtCore.QSizeF]:
        """Return TeX, outline, em in pixels, and the size with which Qt centres the formula."""
        font = _font(document, form)
        tail = QtGui.QFontMetricsF(font).horizontalAdvance(form.stringProperty(_TAIL))
        tex = form.stringProperty(_TEX)
        em = LARGER * em_px(font)
        if document.property(SPACIOUS):
            tex = readable(tex)
            em *= DISPLAYED_LARGER if form.property(_IS_DISPLAYED) else 1.0
        shape = outline(tex)
        block = document.findBlock(at)
        listed = block.textList()
        deep = block.blockFormat().indent() + (listed.format().indent() if listed else 0)
        beside = 2.0 * document.documentMargin() + deep * document.indentWidth()
        widest = document.textWidth() - beside - 2.0 * ROOM_EM * em - tail
        if 0.0 < widest < shape.width * em:
            em = widest / shape.width
        # Qt centres an object a quarter of the letters' x-height above the line.
        half = QtGui.QFontMetrics(form.toCharFormat().font()).xHeight() / 2.0
        height = max(2.0 * shape.ascent * em - half, 2.0 * shape.descent * em + half)
        return tex, shape, em, QtCore.QSizeF((shape.width + 2.0 * ROOM_EM) * em + tail, height)

    def intrinsicSize(
        self, document: QtGui.QTextDocument, at: int, form: QtGui.QTextFormat
    ) -> QtCore.QSizeF:
        return self._set(document, at, form)[3]

    def drawObject(
        self,
        painter: QtGui.QPainter,
        rect: QtCore.QRectF | QtCore.QRect,
        document: QtGui.QTextDocument,
        at: int,
        form: QtGui.QTextFormat,
    ) -> None:
        tex, shape, em, _ = self._set(document, at, form)
        block = document.findBlock(at)
        line = block.layout().lineForTextPosition(at - block.position())
        top = document.documentLayout().blockBoundingRect(block).top()
        painter.save()
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        painter.translate(rect.left() + ROOM_EM * em, top + line.y() + line.ascent())
        own = form.toCharFormat().foreground()
        brush = own if own.style() != Qt.BrushStyle.NoBrush else QtGui.QBrush(painter.pen().color())
        painter.setPen(QtGui.QPen(brush, 0))
        # `drawText` would take the letters' size from the device, which on paper has other dots.
        tail = QtGui.QTextLayout(form.stringProperty(_TAIL), _font(document, form))
        tail.beginLayout()
        letters = tail.createLine()
        letters.setNumColumns(LONGEST_TAIL)
        tail.endLayout()
        tail.draw(painter, QtCore.QPointF((shape.width + ROOM_EM) * em, -letters.ascent()))
        inks = {name: QtGui.QColor(ink) for name, ink in (document.property(INKS) or {}).items()}
        fill_line(painter, f"${tex}$", em, (0.0, 0.0), brush, inks)
        painter.restore()


def _font(document: QtGui.QTextDocument, form: QtGui.QTextFormat) -> QtGui.QFont:
    font = form.toCharFormat().font().resolve(document.defaultFont())
    if form.intProperty(QtGui.QTextFormat.Property.FontSizeAdjustment) == 1:  # of a title
        font.setPixelSize(round(1.2 * em_px(font)))
    return font


@lru_cache(maxsize=1)
def _formulas() -> _Formulas:
    """Return the single handler of all documents.

    A handler for each document, kept alive by nothing else, crashed now and then when its document
    was deleted: `Shiboken::Object::destroy` releases the wrapper and then uses it once more.
    """
    return _Formulas()


class LessonText(ReadText):
    """A Markdown text, as high as its content; its formulas are copied as TeX."""

    def __init__(self, text: str, *, title: bool = False) -> None:
        super().__init__()
        self._is_title = title
        self._heights: dict[int, int] = {}  # cached by width: layouts request heights often
        self.document().setProperty(SPACIOUS, True)
        give_role(self, QtGui.QAccessible.Role.Document)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.viewport().setAutoFillBackground(False)
        policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self.show_text(text)

    def show_text(self, text: str) -> None:
        self._heights.clear()
        set_text(self.document(), text, title=self._is_title, palette=self.palette())
        self.setAccessibleName(spoken_text(text))
        self.updateGeometry()

    def hasHeightForWidth(self) -> bool:
        return True

    def heightForWidth(self, width: int) -> int:
        if width not in self._heights:
            document = self.document()
            # Otherwise Qt sets its own width again.
            blocker = QtCore.QSignalBlocker(document.documentLayout())
            before = document.textWidth()
            document.setTextWidth(width)
            self._heights[width] = math.ceil(document.size().height())
            document.setTextWidth(before)
            blocker.unblock()
        return self._heights[width]

    def changeEvent(self, event: QtCore.QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.Type.FontChange, QtCore.QEvent.Type.StyleChange):
            self._heights.clear()
            self.updateGeometry()

    def sizeHint(self) -> QtCore.QSize:
        width = max(self.width(), 120)
        return QtCore.QSize(width, self.heightForWidth(width))

    def minimumSizeHint(self) -> QtCore.QSize:
        return QtCore.QSize(60, self.fontMetrics().height())

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def wheelEvent(self, event: QtGui.QWheelEvent) -> None:
        event.ignore()  # the area around it scrolls

    def createMimeDataFromSelection(self) -> QtCore.QMimeData:
        cursor, data, words = self.textCursor(), QtCore.QMimeData(), ""
        at = QtGui.QTextCursor(self.document())
        for place in range(cursor.selectionStart(), cursor.selectionEnd()):
            at.setPosition(place + 1)
            tex, tail = (at.charFormat().stringProperty(key) for key in (_TEX, _TAIL))
            letter = cast(Any, self.document()).characterAt(place)
            words += f"${tex}${tail}" if letter == "\ufffc" and tex else letter
        data.setText(
            words.translate(str.maketrans("\u2029\ufdd0\ufdd1", "\n\t\n", MAY_BREAK + NO_BREAK))
        )
        return data
