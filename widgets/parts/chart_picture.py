"""Draw the charts of measurements into a picture or a PDF, also without a window."""

import re
import textwrap
from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QBuffer, QCoreApplication, QMarginsF, QPointF, QRectF, QSizeF, Qt, QUuid
from PySide6.QtGui import (
    QColor,
    QFont,
    QGuiApplication,
    QImage,
    QPageSize,
    QPainter,
    QPdfWriter,
)

from app.drawings.style import LIGHT
from app.measure import chart
from app.measure.meaning import meaning
from app.measure.results import Measurements, Sweep, Trade
from app.scenes.phenomena.words import Diagram
from widgets.parts.diagram_painter import SMALL, DiagramPainter
from widgets.parts.saving import png_of
from widgets.parts.typeset import resized, words_font

ONE_PX, COLUMN_PX, ROW_PX = QSizeF(800.0, 490.0), 550.0, 350.0
"""Size of a picture of one chart with its notes, and of each chart of a larger picture."""
GAP_PX, FONT_PX, NOTE_LETTERS = 8.0, 12, 0.15
"""NOTE_LETTERS is the most letters in a line of the notes, per pixel of width."""
DPI, PX_PER_INCH = 1200, 100
_DATES = rb"/(Creation|Mod)Date \(.*?\)"


def picture(
    results: Measurements,
    file: str,
    current: Mapping[str, str] | None = None,
    other: Measurements | None = None,
    translate: Callable[[str], str] = str,
) -> bytes:
    """Draw all charts of some results; return the bytes of the file.

    The ending of `file` selects the format: one of `chart.ENDINGS`. The other parameters are as for
    `chart.diagrams`; `other` is drawn over the charts of the same name. For bytes, draw
    `results.by_cost`.
    """
    application = QCoreApplication.instance() or QGuiApplication(["app", "-platform", "offscreen"])
    assert isinstance(application, QGuiApplication)
    font = words_font()  # whatever the letters of the window
    font.setPixelSize(FONT_PX)
    parts: list[Trade | Sweep] = [*results.trades, *results.sweeps]
    others: dict[str, Trade | Sweep] = {}
    if other is not None:
        others = {t.name: t for t in other.trades} | {s.parameter: s for s in other.sweeps}
    shown: list[Diagram | str] = []
    for part in parts:
        over = others.get(part.name if isinstance(part, Trade) else part.parameter)
        name = chart.machine(other) if other else ""
        said = meaning(part, translate) if isinstance(part, Trade) else "-"
        diagrams = chart.diagrams(part, current, over, name, translate)
        shown += diagrams or [f"{chart.title(part, translate)}\n\n{said}"]
    lines = [chart.seen(results, translate), chart.where(results)]
    if len(parts) == 1 and isinstance(parts[0], Trade):
        lines.insert(0, meaning(parts[0], translate))
    rows = max(1, -(-len(shown) // 2))
    size = ONE_PX if len(shown) == 1 else QSizeF(2.0 * COLUMN_PX, ROW_PX * rows + 40.0)
    draw = partial(_paint, size=size, font=font, shown=shown, lines=lines)
    if file.lower().endswith(".pdf"):
        buffer = QBuffer()
        buffer.open(QBuffer.OpenModeFlag.WriteOnly)
        writer = QPdfWriter(buffer)
        writer.setResolution(DPI)
        writer.setPageSize(QPageSize(size / PX_PER_INCH, QPageSize.Unit.Inch))
        writer.setPageMargins(QMarginsF())
        writer.setDocumentXmpMetadata(b"<metadata/>")  # Qt's own have the time, and a random id
        writer.setDocumentId(QUuid())
        painter = QPainter(writer)
        painter.scale(DPI / PX_PER_INCH, DPI / PX_PER_INCH)
        draw(painter)
        painter.end()
        # The same results give the same file at any time; its offsets stay right.
        return re.sub(_DATES, lambda date: b" " * len(date[0]), bytes(buffer.data().data()))
    image = QImage(size.toSize(), QImage.Format.Format_RGB32)
    image.fill(LIGHT.background)
    painter = QPainter(image)
    draw(painter)
    painter.end()
    return png_of(image)


def _paint(
    painter: QPainter, size: QSizeF, font: QFont, shown: list[Diagram | str], lines: list[str]
) -> None:
    """Paint the charts, or why there is none, in one column or two, and the notes below."""
    width, columns = size.width(), 1 if len(shown) == 1 else 2
    notes = [n for line in lines for n in textwrap.wrap(line, round(NOTE_LETTERS * width))]
    painter.setFont(resized(font, SMALL))
    painter.setPen(QColor(LIGHT.muted))
    height = painter.fontMetrics().height() * len(notes) + GAP_PX
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
            painter.setPen(QColor(LIGHT.ink))
            wrapped = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(QRectF(QPointF(), inside), wrapped, each)
        else:
            DiagramPainter(each, inside, font, LIGHT, has_grid=True).paint(painter)
        painter.restore()
