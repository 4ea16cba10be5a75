"""A lesson's text as it is read: Markdown with formulas, of which nothing leads anywhere.

`set_text` fills any `QTextDocument`, for a window as for paper; `LessonText` is as high as what it
holds.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any, cast

from PySide6.QtCore import QEvent, QMimeData, QRect, QRectF, QSignalBlocker, QSize, QSizeF, Qt
from PySide6.QtGui import (
    QBrush,
    QFontMetrics,
    QGuiApplication,
    QPainter,
    QPainterPath,
    QPalette,
    QPyTextObject,
    QResizeEvent,
    QTextCharFormat,
    QTextCursor,
    QTextDocument,
    QTextFormat,
    QWheelEvent,
)
from PySide6.QtWidgets import QFrame, QSizePolicy, QTextEdit

from app.lessons.course import Course
from app.lessons.lesson import Question
from app.lessons.text import FORMULA, Outline, html_of, outline, plain_of
from widgets.parts.messages import figure_text
from widgets.parts.plain import TextDocument

_KIND = QTextFormat.ObjectTypes.UserObject + 1
_TEX = QTextFormat.Property.UserProperty + 1
CHOICES = "ABCDEFGHIJ"
RIGHT = " **✓**"
LARGER = 1.12
"""The formulas' letters, against those of the text, whose small ones are higher."""
ROOM_EM = 0.06
"""Free on both sides of a formula."""
MAY_BREAK, NO_BREAK = "\u200b", "\u2060"
"""Signs without width, for where a line may end and where it may not."""
LIST_EM = 0.55
"""How far a list is indented, for each of the two that Qt reckons with."""
STYLE = """
p, ul, ol, table { margin-top: 0px; margin-bottom: 6px; }
li { margin-bottom: 4px; }
td, th { padding: 2px 7px; border: 1px solid %s; }
table { border-collapse: collapse; border: 1px solid %s; }
h1, h2, h3, h4 { margin-top: 0px; margin-bottom: 4px; font-size: large; }
"""


def question_text(question: Question, answer: str, *, told: bool, others: bool) -> str:
    """A question as a class reads it, in Markdown.

    Parameters
    ----------
    question : Question
    answer : str
        Of `answer_text`; empty where there are choices.
    told : bool
        Whether what is right is marked and said.
    others : bool
        Whether the choices that are not right are there then, too.
    """
    lines = [question.text]
    for letter, choice in zip(CHOICES, question.choices, strict=False):
        if choice.right or others or not told:
            lines.append(f"**{letter}** {choice.text}{RIGHT if told and choice.right else ''}")
    if told and answer:
        lines.append(f"**{answer}**{RIGHT}")
    return "\n\n".join(["  \n".join(lines), *([question.why] if told and question.why else [])])


def answer_text(course: Course, place: int, question: Question) -> str:
    """The right number of a question, with its unit; empty where there are choices.

    Raises
    ------
    Refusal
        If it has no value in the state of its step: with its line.
    """
    if question.value is None:
        return ""
    unit = question.unit if question.unit in ("", "°") else f" {question.unit}"
    return f"{figure_text(course.answer(place, question), 4)}{unit}"


def set_text(document: QTextDocument, text: str, *, title: bool = False, line: str = "") -> None:
    """Let a document hold a lesson's text.

    Parameters
    ----------
    document : QTextDocument
        With its font.
    text : str
        Markdown.
    title : bool
        Whether it is a step's title.
    line : str
        Colour of a table's lines.
    """
    html, formulas = html_of(f"## {text}" if title else text)
    line = line or "#888888"
    document.setDefaultStyleSheet(STYLE % (line, line))
    document.setDocumentMargin(0.0)
    document.setIndentWidth(LIST_EM * 2.0 * _em(document, QTextCharFormat()))
    document.setHtml(html)
    layout = document.documentLayout()
    layout.unregisterHandler(_KIND)  # or it would be joined to it once more
    layout.registerHandler(_KIND, _formulas())
    cursor = QTextCursor(document)
    for tex in formulas:
        cursor = document.find(FORMULA, cursor)
        kept, plain = cursor.charFormat(), cursor.charFormat()
        try:
            outline(tex)
        except ValueError:  # as it was typed
            cursor.insertText(f"${tex}$", plain)
            continue
        kept.setObjectType(_KIND)
        kept.setProperty(_TEX, tex)
        kept.setVerticalAlignment(QTextCharFormat.VerticalAlignment.AlignMiddle)
        # A line of nothing else is as high as of letters, and no line ends beside one.
        begins = cursor.positionInBlock() == 0 or _before(document, cursor).isspace()
        cursor.insertText(MAY_BREAK if begins else NO_BREAK, plain)
        cursor.insertText("\ufffc", kept)
        if not document.characterAt(cursor.position()).isspace():
            cursor.insertText(NO_BREAK, plain)
    last = QTextCursor(document)
    last.movePosition(QTextCursor.MoveOperation.End)
    end = last.blockFormat()
    end.setBottomMargin(0.0)
    last.setBlockFormat(end)


def _before(document: QTextDocument, cursor: QTextCursor) -> str:
    """The letter before a place."""
    return str(cast(Any, document).characterAt(cursor.position() - 1))


def _em(document: QTextDocument, character: QTextCharFormat) -> float:
    """Pixels of an em on the screen, in which a document is laid out for paper too.

    The layout's own paint device is not asked: it is no QObject, and when it has gone PySide takes
    whatever comes to lie in its place for it.
    """
    font = character.font().resolve(document.defaultFont())
    return float(font.pixelSize()) if font.pixelSize() > 0 else font.pointSizeF() * _dpi() / 72.0


@lru_cache(maxsize=1)
def _dpi() -> float:
    return QGuiApplication.primaryScreen().logicalDotsPerInchY()


@lru_cache(maxsize=512)
def _path(tex: str) -> QPainterPath:
    """A formula's outlines in em, y downwards, its baseline at 0."""
    found, path, place = outline(tex), QPainterPath(), 0
    path.setFillRule(Qt.FillRule.WindingFill)
    points = [(float(x), -float(y)) for x, y in found.vertices]
    codes = [int(code) for code in found.codes]
    draw: dict[int, Callable[..., None]]
    draw = {1: path.moveTo, 2: path.lineTo, 3: path.quadTo, 4: path.cubicTo}
    while place < len(codes):
        code = codes[place]
        count = {3: 2, 4: 3}.get(code, 1)  # points of a curve
        if code in draw:
            draw[code](*(x for point in points[place : place + count] for x in point))
        else:
            path.closeSubpath()
        place += count
    return path


class _Formulas(QPyTextObject):
    """Sets and draws the formulas of documents, in the colour of the text round them."""

    def _set(self, document: QTextDocument, form: QTextFormat) -> tuple[str, Outline, float, float]:
        """TeX, outline, em in pixels, and how high it is, as Qt wants to have it."""
        character = form.toCharFormat()
        tex = str(form.property(_TEX))
        found = outline(tex)
        em = LARGER * _em(document, character)
        widest = document.textWidth() - 2.0 * ROOM_EM * em
        if 0.0 < widest < found.width * em:
            em = widest / found.width
        # Of an object in the middle, Qt has a quarter of the letters' x-height more over the line.
        half = QFontMetrics(character.font()).xHeight() / 2.0
        height = max(2.0 * found.ascent * em - half, 2.0 * found.descent * em + half)
        return tex, found, em, height

    def intrinsicSize(self, document: QTextDocument, _at: int, form: QTextFormat) -> QSizeF:
        _, found, em, height = self._set(document, form)
        return QSizeF((found.width + 2.0 * ROOM_EM) * em, height)

    def drawObject(
        self,
        painter: QPainter,
        rect: QRectF | QRect,
        document: QTextDocument,
        at: int,
        form: QTextFormat,
    ) -> None:
        tex, _, em, _ = self._set(document, form)
        block = document.findBlock(at)
        line = block.layout().lineForTextPosition(at - block.position())
        top = document.documentLayout().blockBoundingRect(block).top()
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.translate(rect.left() + ROOM_EM * em, top + line.y() + line.ascent())
        painter.scale(em, em)
        own = form.toCharFormat().foreground()
        brush = own if own.style() != Qt.BrushStyle.NoBrush else QBrush(painter.pen().color())
        painter.fillPath(_path(tex), brush)
        painter.restore()


@lru_cache(maxsize=1)
def _formulas() -> _Formulas:
    """The one of all documents.

    One for each, held by nothing but its document, crashed now and then when that was deleted:
    in `Shiboken::Object::destroy`, which lets go of such a wrapper and then asks it once more.
    """
    return _Formulas()


class LessonText(QTextEdit):
    """A text that is read, as high as it is; its formulas are copied as TeX.

    Parameters
    ----------
    text : str
        Markdown.
    title : bool
        Whether it is a step's title.
    """

    def __init__(self, text: str, *, title: bool = False) -> None:
        super().__init__()
        self._text, self._is_title = "", title
        self._heights: dict[int, int] = {}
        """By widths: a layout asks often."""
        self.setDocument(TextDocument(self))
        self.setReadOnly(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.viewport().setAutoFillBackground(False)
        policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)
        self.say(text)

    def say(self, text: str) -> None:
        """Show another text."""
        self._text = text
        self._heights.clear()
        line = self.palette().color(QPalette.ColorRole.Mid).name()
        set_text(self.document(), text, title=self._is_title, line=line)
        self.setAccessibleName(plain_of(text))
        self.updateGeometry()

    def hasHeightForWidth(self) -> bool:
        return True

    def heightForWidth(self, width: int) -> int:
        if width not in self._heights:
            document = self.document()
            blocker = QSignalBlocker(document.documentLayout())  # or it has its own width again
            before = document.textWidth()
            document.setTextWidth(width)
            self._heights[width] = math.ceil(document.size().height())
            document.setTextWidth(before)
            blocker.unblock()
        return self._heights[width]

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._heights.clear()
            self.updateGeometry()

    def sizeHint(self) -> QSize:
        width = max(self.width(), 120)
        return QSize(width, self.heightForWidth(width))

    def minimumSizeHint(self) -> QSize:
        return QSize(60, self.fontMetrics().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()  # what it stands in scrolls

    def createMimeDataFromSelection(self) -> QMimeData:
        cursor, data, words = self.textCursor(), QMimeData(), ""
        at = QTextCursor(self.document())
        for place in range(cursor.selectionStart(), cursor.selectionEnd()):
            at.setPosition(place + 1)
            tex = at.charFormat().property(_TEX)
            letter = cast(Any, self.document()).characterAt(place)
            words += f"${tex}$" if letter == "\ufffc" and tex else letter
        data.setText(
            words.replace("\u2029", "\n").translate(dict.fromkeys(map(ord, MAY_BREAK + NO_BREAK)))
        )
        return data
