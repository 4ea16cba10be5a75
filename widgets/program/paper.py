"""A4 pages as PDF: texts, figures and lines to write on, placed below each other.

A page consists of blocks. The figures of all blocks have the size with which the pages are filled
best. No display is needed.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import NamedTuple, TypeAlias

import numpy as np
from PySide6 import QtGui
from PySide6.QtCore import QBuffer, QMarginsF, QPointF, QRectF, Qt

from app.document.document import Document
from app.document.lengths import DPI as DPI_OF_FIGURES
from app.drawings.drawing import Drawing
from app.drawings.figure import Figure
from app.drawings.style import LIGHT
from app.lessons.course import panes_of, scene_of
from app.model.refusal import REFUSALS, Refusal
from widgets.parts.lesson_text import SPACIOUS, set_text
from widgets.parts.plain import TextDocument
from widgets.parts.translator import off_screen_application
from widgets.parts.typeset import words_font
from widgets.window.pictures import image_of

MARGIN_MM = 18.0
TEXT_PT, TITLE_PT, NOTE_PT, FOOT_PT = 10.5, 15.0, 9.0, 8.0
BETWEEN_PT, BETWEEN_STEPS_PT = 6.0, 20.0
NOTE_INDENT_PT, CAPTION_PT = 12.0, 2.0
FIGURE_PX_PER_INCH, FIGURE_TEXT_PT = 220, 7.0
EDGE_PT = 0.5  # how far beyond the edge of a figure a place on it may come by rounding
PANE_ASPECT = 1.6  # width to height of a figure of one pane; the image has its own
BLANK = 0.3  # largest share of a page that may stay blank below its last line
RULE_PT = 24.0  # distance between lines to write on
DPI = 1200  # Qt places lines and letters on whole pixels of the page


PaintPage: TypeAlias = Callable[[QtGui.QPainter], object]


def pdf(title: str, lay_out: Callable[[float, float], Iterable[PaintPage]]) -> bytes:
    """Return the content of a PDF file.

    `lay_out` returns what paints each page, for the width and height between the margins in points.
    """
    off_screen_application()
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.WriteOnly)
    writer = QtGui.QPdfWriter(buffer)
    writer.setTitle(title)
    writer.setCreator("Frustum Lab")
    writer.setResolution(DPI)
    margins = QMarginsF(MARGIN_MM, MARGIN_MM, MARGIN_MM, MARGIN_MM)
    a4 = QtGui.QPageSize(QtGui.QPageSize.PageSizeId.A4)
    writer.setPageLayout(
        QtGui.QPageLayout(
            a4, QtGui.QPageLayout.Orientation.Portrait, margins, QtGui.QPageLayout.Unit.Millimeter
        )
    )
    page = QRectF(writer.pageLayout().paintRect(QtGui.QPageLayout.Unit.Point))
    pages = lay_out(page.width(), page.height() - 2.0 * FOOT_PT)
    painter = QtGui.QPainter(writer)
    painter.setRenderHint(QtGui.QPainter.RenderHint.LosslessImageRendering)
    painter.scale(DPI / 72.0, DPI / 72.0)
    try:
        for number, paint in enumerate(pages):
            if number:
                writer.newPage()
            paint(painter)
    finally:
        painter.end()
    return bytes(buffer.data().data())


@dataclass
class PageBlock:
    """A part of a page over its width, in points; `kept` on the same page as the next one."""

    height: float
    paint: Callable[[QtGui.QPainter, QRectF], object]  # paints the part of the block in a rectangle
    left: float = 0.0
    kept: bool = False
    after: float = BETWEEN_PT
    wide: float = 0.0  # how wide its content is

    def draw(self, painter: QtGui.QPainter, x: float, y: float, part: QRectF | None = None) -> None:
        """Paint the block, or a part of it, with its upper left at a place."""
        part = part or QRectF(0.0, 0.0, 1e4, self.height)
        painter.save()
        painter.translate(x, y)
        if self.left:
            line = QRectF(0.25 * self.left, part.top(), 1.5, part.height())
            painter.fillRect(line, QtGui.QColor(LIGHT.near))
        painter.translate(self.left, 0.0)
        self.paint(painter, QRectF(0.0, part.top(), part.width() - self.left, part.height()))
        painter.restore()


def text(
    text: str, width: float, size: float, *, title: bool = False, left: float = 0.0
) -> PageBlock:
    document = TextDocument()
    font = words_font()
    font.setStyleHint(QtGui.QFont.StyleHint.SansSerif)
    screen = QtGui.QGuiApplication.primaryScreen()  # a document is laid out in its pixels
    font.setPointSizeF(size * 72.0 / screen.logicalDotsPerInchY())
    font.setHintingPreference(QtGui.QFont.HintingPreference.PreferNoHinting)
    document.setDefaultFont(font)
    document.setUseDesignMetrics(True)
    document.setProperty(SPACIOUS, True)
    set_text(document, text, title=title)
    document.setTextWidth(width - left)
    wide = document.idealWidth() + left
    return PageBlock(document.size().height(), document.drawContents, left, title, wide=wide)


def beside(figure: PageBlock, others: Sequence[PageBlock], left: float) -> PageBlock:
    right = sum(block.height for block in others) + BETWEEN_PT * max(0, len(others) - 1)

    def paint(painter: QtGui.QPainter, part: QRectF) -> None:
        figure.paint(painter, part)
        y = 0.0
        for block in others:
            block.draw(painter, left, y, QRectF(0.0, 0.0, part.width() - left, block.height))
            y += block.height + BETWEEN_PT

    return PageBlock(max(figure.height, right), paint)


def below(figure: PageBlock, caption: PageBlock) -> PageBlock:

    def paint(painter: QtGui.QPainter, part: QRectF) -> None:
        figure.paint(painter, part)
        caption.draw(painter, 0.0, figure.height + CAPTION_PT)

    return PageBlock(figure.height + CAPTION_PT + caption.height, paint, wide=figure.wide)


def ruled(width: float, height: float) -> PageBlock:
    """Lines to write on."""

    def paint(painter: QtGui.QPainter, part: QRectF) -> None:
        painter.setPen(QtGui.QPen(QtGui.QColor(LIGHT.muted), 0.6))
        for number in range(1, int(height / RULE_PT + 0.5) + 1):
            y = number * height / max(1, int(height / RULE_PT + 0.5))
            if part.top() <= y <= part.bottom() + 0.5:
                painter.drawLine(QPointF(0.0, y), QPointF(width, y))

    return PageBlock(height, paint)


def picture(image: QtGui.QImage, width: float) -> PageBlock:
    place = QRectF(0.0, 0.0, width, width * image.height() / image.width())

    def paint(painter: QtGui.QPainter, _part: QRectF) -> None:
        painter.drawImage(place, image)
        painter.setPen(QtGui.QPen(QtGui.QColor(LIGHT.muted), 0.6))
        painter.drawRect(place)

    return PageBlock(place.height(), paint, wide=width)


class MarkedPlace(NamedTuple):
    """A ring round a place, as of `Drawing.spots_of`; its radius relative to the width."""

    place: tuple[float, ...]
    radius: float


def figure(
    document: Document,
    width: float,
    one_pane: float,
    panes: Sequence[str] = (),
    mark: MarkedPlace | None = None,
) -> PageBlock:
    """The picture of a state: one pane, or the compared pictures across the page.

    Painting it raises a `Refusal` if the place of a mark is not in the picture.
    """
    panes = panes or panes_of(document)
    is_image = [*panes] == ["image"]
    count = len(document.view.compare) if is_image else 0
    aspect = document.projection.aspect if is_image else PANE_ASPECT
    wide, high = one_pane, one_pane / PANE_ASPECT
    if len(panes) > 1:
        wide, high = width, width / (len(panes) * PANE_ASPECT)
    elif count and not document.view.dividers:
        wide, high = width, width / (count * aspect) + 3.0 * FIGURE_TEXT_PT
    elif is_image:
        wide = min(one_pane, high * aspect)
        high = wide / aspect
    px_per_pt = FIGURE_PX_PER_INCH / 72.0
    spots: list[QPointF] = []

    def find(drawing: Drawing, finer: int) -> None:
        if mark is not None:
            ((x, y),) = drawing.spots_of(np.array([mark.place])).tolist()
            spots.append(QPointF(x, y) / (finer * px_per_pt))

    figure = Figure(
        document, scene_of(document), panes, (round(wide * px_per_pt), round(high * px_per_pt)),
        text_pt=FIGURE_TEXT_PT * FIGURE_PX_PER_INCH / DPI_OF_FIGURES,
    )  # fmt: skip
    drawn = cache(lambda: image_of(figure.pixels(seen=find)))

    def paint(painter: QtGui.QPainter, _part: QRectF) -> None:
        place = QRectF(0.0, 0.0, wide, high)
        painter.drawImage(place, drawn())
        if is_image and not count:
            painter.setPen(QtGui.QPen(QtGui.QColor(LIGHT.muted), 0.6))
            painter.drawRect(place)
        for spot in spots:
            # A place on the edge is in it, but not a place that is not a number.
            if not place.adjusted(-EDGE_PT, -EDGE_PT, EDGE_PT, EDGE_PT).contains(spot):
                raise Refusal("place", mark.place if mark else (), REFUSALS["not-in-picture"])
            for brush, thick in ((Qt.GlobalColor.white, 3.0), (QtGui.QColor(LIGHT.ink), 1.2)):
                painter.setPen(QtGui.QPen(brush, thick))
                painter.drawEllipse(spot, *2 * [wide * (mark.radius if mark else 0.0)])
                painter.drawPoint(spot)

    return PageBlock(high, paint, wide=wide)


def in_row(blocks: Sequence[PageBlock]) -> PageBlock:
    """Blocks beside each other, their middles on a line."""
    height = max(block.height for block in blocks)

    def paint(painter: QtGui.QPainter, _part: QRectF) -> None:
        x = 0.0
        for block in blocks:
            block.draw(painter, x, (height - block.height) / 2.0)
            x += block.wide + BETWEEN_PT

    return PageBlock(height, paint)


# --------------------------------------------------------------------------- pages


class PagePiece(NamedTuple):
    """The part of a block on a page, and its place."""

    block: PageBlock
    y: float
    begin: float
    height: float


class PaperPage(NamedTuple):
    pieces: list[PagePiece]
    blank: float  # of its height, below the last piece


def placed(blocks: Sequence[PageBlock], height: float) -> list[PaperPage]:
    """Place blocks below each other, and begin a new page for one that does not fit."""
    pages, pieces, y = list[PaperPage](), list[PagePiece](), 0.0

    def turn() -> None:
        nonlocal pieces, y
        end = max((piece.y + piece.height for piece in pieces), default=0.0)
        pages.append(PaperPage(pieces, 1.0 - end / height))
        pieces, y = [], 0.0

    for number, block in enumerate(blocks):
        needed, place = block.height, number
        while blocks[place].kept and place + 1 < len(blocks):
            needed += blocks[place].after + blocks[place + 1].height
            place += 1
        if y > 0.0 and y + needed > height:
            turn()
        done = 0.0
        while True:
            part = min(block.height - done, height - y)
            pieces.append(PagePiece(block, y, done, part))
            y, done = y + part, done + part
            if done >= block.height - 0.5:
                break
            turn()
        y += block.after
    turn()
    return pages


def best(layouts: Sequence[list[PaperPage]]) -> list[PaperPage]:
    """The first of the layouts whose pages are full enough, or the one with the fullest pages."""

    def emptiest(pages: list[PaperPage]) -> float:
        return max(page.blank for page in pages)

    full = (pages for pages in layouts if emptiest(pages) <= BLANK)
    return next(full, min(layouts, key=emptiest))


def paint_page(
    page: PaperPage,
    left: str,
    right: str,
    width: float,
    height: float,
    painter: QtGui.QPainter,
    *,
    is_ruled: bool = False,
) -> None:
    """Paint a page; what is blank becomes space between its blocks, or lines to write on.

    The two texts are at its foot.
    """
    blank = page.blank * height
    gaps = sum(not piece.block.kept for piece in page.pieces[:-1])
    more = 0.0 if is_ruled else min(blank / max(1, gaps), BETWEEN_STEPS_PT)
    down = 0.0
    for piece in page.pieces:
        part = QRectF(0.0, piece.begin, width, piece.height)
        piece.block.draw(painter, 0.0, piece.y + down - piece.begin, part)
        down += 0.0 if piece.block.kept else more
    if is_ruled and blank > 2.0 * RULE_PT:
        ruled(width, blank - BETWEEN_PT).draw(painter, 0.0, height - blank + BETWEEN_PT)
    foot(painter, left, right, width, height)


def foot(painter: QtGui.QPainter, left: str, right: str, width: float, height: float) -> None:
    painter.save()
    font = words_font()
    font.setPointSizeF(FOOT_PT * 72.0 / DPI)
    painter.setFont(font)
    painter.setPen(QtGui.QColor(LIGHT.muted))
    place = QRectF(0.0, height + 0.7 * FOOT_PT, width, 1.3 * FOOT_PT)
    room = width - painter.fontMetrics().horizontalAdvance(f"   {right}")
    left = painter.fontMetrics().elidedText(left, Qt.TextElideMode.ElideRight, int(room))
    painter.drawText(place, Qt.AlignmentFlag.AlignLeft, left)
    painter.drawText(place, Qt.AlignmentFlag.AlignRight, right)
    painter.restore()
