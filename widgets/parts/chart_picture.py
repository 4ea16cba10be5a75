"""Draw the charts of measurements into a picture, an SVG or a PDF, also without a window."""

import re
import textwrap
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import NamedTuple

from PySide6.QtCore import QBuffer, QMarginsF, QPointF, QRectF, QSizeF, Qt, QUuid
from PySide6.QtGui import QColor, QFont, QImage, QPageSize, QPaintDevice, QPainter, QPdfWriter
from PySide6.QtSvg import QSvgGenerator

from app.document.lengths import DPI, Size
from app.drawings.style import PALETTES, Style
from app.measure import chart
from app.measure.meaning import meaning
from app.measure.results import Measurements, Sweep, Trade
from app.scenes.phenomena.words import Diagram
from widgets.parts.diagram_painter import SMALL, DiagramPainter
from widgets.parts.saving import png_of
from widgets.parts.translator import off_screen_application
from widgets.parts.typeset import resized, words_font

ONE_PX, COLUMN_PX, ROW_PX = QSizeF(800.0, 490.0), 550.0, 350.0
"""Size of a picture of one chart with its notes, and of each chart of a larger picture."""
GAP_PX, FONT_PX, NOTE_LETTERS = 8.0, 12, 0.15
"""NOTE_LETTERS is the most letters in a line of the notes, per pixel of width."""
PX_PER_INCH, TEXT_PT = 100.0, 7.0  # of a picture without and with a size
_PDF_DPI = 1200
_DATES, _BOX = rb"/(Creation|Mod)Date \(.*?\)", rb"(/MediaBox )(\[[^]]*\])"


class Paper(NamedTuple):
    """How a chart is printed, as in `Figure`; sized, it has one size of letters and no notes."""

    size: Size | None = None
    width: float | None = None
    text_pt: float | None = None
    palette: str = "screen"

    @property
    def is_sized(self) -> bool:
        return bool(self.size or self.width or self.text_pt)


def picture(
    results: Measurements,
    file: str,
    current: Mapping[str, str] | None = None,
    other: Measurements | None = None,
    paper: Paper | None = None,
) -> bytes:
    """Draw all charts of some results; return the bytes of the file.

    The ending of `file` selects the format: one of `chart.ENDINGS`. The other parameters are as for
    `chart.diagrams`; `other` is drawn over the charts of the same name. For bytes, draw
    `results.by_cost`.
    """
    off_screen_application()
    font = words_font()  # whatever the letters of the window
    font.setPixelSize(FONT_PX)
    parts: list[Trade | Sweep] = [*results.trades, *results.sweeps]
    others: dict[str, Trade | Sweep] = {}
    if other is not None:
        others = {t.name: t for t in other.trades} | {s.parameter: s for s in other.sweeps}
    shown: list[Diagram | str] = []
    paper = paper or Paper()
    for part in parts:
        over = others.get(part.name if isinstance(part, Trade) else part.parameter)
        said = meaning(part) if isinstance(part, Trade) else "-"
        diagrams = chart.diagrams(part, current, over, chart.machine(other) if other else "")
        if paper.is_sized:  # the file says the remarks, for which a line on paper has no room
            diagrams = tuple(replace(each, title=chart.title(part)) for each in diagrams)
        shown += diagrams or [f"{chart.title(part)}\n\n{said}"]
    lines = [chart.seen(results), chart.where(results)]
    about = "; ".join([*map(chart.titled, parts), *lines])
    if len(parts) == 1 and isinstance(parts[0], Trade):
        lines.insert(0, meaning(parts[0]))
    per_inch = PX_PER_INCH
    if paper.is_sized:  # then the letters' size is a whole number of pixels
        per_inch, lines = FONT_PX * 72.0 / (paper.text_pt or TEXT_PT), []
    style = PALETTES[paper.palette]
    size = _size(paper, per_inch, shown, font, style)
    draw = partial(
        _paint, size=size, font=font, shown=shown, lines=lines, style=style, sized=paper.is_sized
    )
    if file.lower().endswith(".png"):
        finer = DPI / per_inch if paper.is_sized else 1.0
        image = QImage((size * finer).toSize(), QImage.Format.Format_RGB32)
        image.setDotsPerMeterX(round(per_inch * finer / 0.0254))
        image.setDotsPerMeterY(round(per_inch * finer / 0.0254))
        image.setText("Description", about)
        draw(image, finer)
        return png_of(image)
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.WriteOnly)
    if file.lower().endswith(".svg"):
        drawn = QSvgGenerator()
        drawn.setOutputDevice(buffer)
        drawn.setTitle(about)
        drawn.setResolution(_PDF_DPI)
        finer = _PDF_DPI / per_inch
        drawn.setSize((size * finer).toSize())
        drawn.setViewBox(QRectF(QPointF(), size * finer))
        draw(drawn, finer)
        return bytes(buffer.data().data())
    writer = QPdfWriter(buffer)
    writer.setTitle(about)
    writer.setResolution(_PDF_DPI)
    writer.setPageSize(QPageSize(size / per_inch, QPageSize.Unit.Inch))
    writer.setPageMargins(QMarginsF())
    writer.setDocumentXmpMetadata(b"<metadata/>")  # Qt's own have the time, and a random id
    writer.setDocumentId(QUuid())
    draw(writer, _PDF_DPI / per_inch)
    wide, high = (side * 72.0 / per_inch for side in (size.width(), size.height()))
    box = b"[0 %.4f %.4f %d]" % (round(high) - high, wide, round(high))  # Qt has whole points
    # The same results give the same file at any time; its offsets stay right.
    file_bytes = re.sub(_DATES, lambda date: b" " * len(date[0]), bytes(buffer.data().data()))
    return re.sub(_BOX, lambda old: old[1] + box.ljust(len(old[2])), file_bytes)


def _size(
    paper: Paper, per_inch: float, shown: list[Diagram | str], font: QFont, style: Style
) -> QSizeF:
    charts = len(shown)
    rows = -(-charts // 2)
    usual = ONE_PX if charts == 1 else QSizeF(2.0 * COLUMN_PX, ROW_PX * rows + 40.0)
    if paper.size is not None:
        return QSizeF(*paper.size.px) * (per_inch / DPI)
    if paper.width is None:
        return usual
    width = paper.width * per_inch / DPI
    columns = _columns(charts, width)
    high = width / columns * ROW_PX / COLUMN_PX
    inside = QSizeF(width / columns - 2.0 * GAP_PX, high - GAP_PX)
    charts_alone = [each for each in shown if isinstance(each, Diagram)]
    painters = [DiagramPainter(each, inside, font, style, one_size=True) for each in charts_alone]
    high += max((painter.keyed for painter in painters), default=0.0)
    return QSizeF(width, high * -(-charts // columns))


def _columns(charts: int, width: float) -> int:
    return 1 if charts == 1 or width < COLUMN_PX else 2


def _paint(
    device: QPaintDevice,
    finer: float,
    *,
    size: QSizeF,
    font: QFont,
    shown: list[Diagram | str],
    lines: list[str],
    style: Style,
    sized: bool,
) -> None:
    """Paint the charts, or why there is none, in one column or two, and the notes below."""
    painter = QPainter(device)
    painter.scale(finer, finer)
    width = size.width()
    columns = _columns(len(shown), width)
    notes = [n for line in lines for n in textwrap.wrap(line, round(NOTE_LETTERS * width))]
    painter.setFont(font if sized else resized(font, SMALL))
    painter.fillRect(QRectF(QPointF(), size), QColor(style.background))
    painter.setPen(QColor(style.muted))
    height = painter.fontMetrics().height() * len(notes) + GAP_PX if notes else 0.0
    top = size.height() - height
    flags = Qt.AlignmentFlag.AlignHCenter
    painter.drawText(QRectF(0.0, top, width, height), flags, "\n".join(notes))
    cell = QSizeF(width / columns, (top - GAP_PX) / max(1, -(-len(shown) // columns)))
    for place, each in enumerate(shown):
        row, column = divmod(place, columns)
        painter.save()
        painter.translate(QPointF(column * cell.width() + GAP_PX, row * cell.height() + GAP_PX))
        inside = cell - QSizeF(2.0 * GAP_PX, GAP_PX)
        if isinstance(each, str):
            painter.setFont(font)
            painter.setPen(QColor(style.ink))
            wrapped = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(QRectF(QPointF(), inside), wrapped, each)
        else:
            DiagramPainter(each, inside, font, style, has_grid=True, one_size=sized).paint(painter)
        painter.restore()
    painter.end()
