"""Shapes as a PDF file, by matplotlib: its text is text, in embedded TrueType fonts."""

import io
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from app.document.lengths import DPI
from app.drawings.label import HALO_EM, HALO_OPACITY, UNDER_EM, surrounded
from app.drawings.occlusion import Points
from app.drawings.off_screen import Pixels
from app.drawings.style import rgb
from app.drawings.svg import SEAM_PX
from app.drawings.vectors import Area, Disc, LineShape, PixelShape, Shape, TextShape
from app.lecture.typesetting import FONT, as_shipped, font_file, is_set_in_words, mathtext, piece_of

_PT_PER_PX = 72.0 / DPI
_LARGE_PT = 1e4  # FreeType's letters are at most 65 535 pixels high
_WATCHED = 50  # shapes from one call of the watch to the next


@as_shipped()
def pdf(
    shapes: Sequence[Shape],
    size: tuple[float, float],
    title: str,
    text: str = "",
    watch: Callable[[], object] | None = None,
) -> bytes:
    """Return the file of a figure of a size in pixels; its subject is a `text` about it.

    `watch` is called for every shape and while matplotlib draws; what it raises ends that.
    """
    from matplotlib import rc_context
    from matplotlib.backends.backend_pdf import FigureCanvasPdf
    from matplotlib.figure import Figure

    figure: Any = Figure(figsize=(size[0] / DPI, size[1] / DPI), dpi=72, frameon=False)
    FigureCanvasPdf(figure)
    writer = _PdfWriter(figure, size)
    buffer = io.BytesIO()
    with rc_context({"pdf.fonttype": 42, "path.simplify": False}):
        for number, shape in enumerate(shapes):
            writer.add(shape)
            if watch is not None:
                watch()
                if not number % _WATCHED:
                    writer.call(watch)
        metadata = {
            "Title": title,
            "Subject": text or None,
            "Creator": "Frustum Lab",
            "Producer": None,
            "CreationDate": None,
        }
        figure.savefig(buffer, format="pdf", metadata=metadata)
    return buffer.getvalue()


@as_shipped()
def rastered(shapes: Sequence[Shape], size: tuple[float, float], scale: float) -> Pixels:
    """Return shapes as pixels, (h, w, 4), without VTK."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    width, height = (max(1, round(side * scale)) / (DPI * scale) for side in size)
    figure: Any = Figure(figsize=(width, height), dpi=DPI * scale, frameon=False)
    canvas: Any = FigureCanvasAgg(figure)
    writer = _PdfWriter(figure, size)
    for shape in shapes:
        writer.add(shape)
    canvas.draw()
    return np.array(canvas.buffer_rgba())


class _PdfWriter:
    """Adds shapes to a figure of matplotlib, each above the ones before."""

    def __init__(self, figure: Any, size: tuple[float, float]) -> None:
        from matplotlib.transforms import Affine2D

        self._figure, self._number, self._size = figure, 0, size
        pt = figure.dpi / DPI
        self._place: Any = Affine2D().scale(pt, -pt).translate(0.0, pt * size[1])

    def add(self, shape: Shape) -> None:
        if isinstance(shape, Area):
            seam = SEAM_PX if shape.opacity >= 1.0 else 0.0
            self._patch(shape.rings, shape.colour, shape.opacity, seam)
        elif isinstance(shape, LineShape):
            self._line(shape)
        elif isinstance(shape, Disc):
            turns = np.linspace(0.0, 2.0 * np.pi, 33)[:-1]
            (x, y), r = shape.centre, shape.radius
            ring = [(x + r * float(np.cos(t)), y + r * float(np.sin(t))) for t in turns]
            self._patch([ring], shape.colour, shape.opacity, 0.0)
        elif isinstance(shape, PixelShape):
            self._image(shape)
        else:
            self._text(shape)

    def call(self, watch: Callable[[], object]) -> None:
        """Call `watch` when matplotlib draws what was added last."""
        from matplotlib.artist import Artist

        class Watcher(Artist):
            def draw(self, renderer: Any) -> None:
                watch()

        self._figure.add_artist(Watcher()).set_zorder(self._above())

    def _above(self) -> int:
        self._number += 1
        return self._number

    def _patch(self, rings: list[Points], colour: Any, opacity: float, seam: float) -> None:
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        paths: list[Any] = [Path([*ring, ring[0]], closed=True) for ring in rings]
        patch: Any = PathPatch(
            Path.make_compound_path(*paths), facecolor=(*colour, opacity), transform=self._place,
            edgecolor=colour if seam else "none", linewidth=seam * _PT_PER_PX,
            joinstyle="round", zorder=self._above(),
        )  # fmt: skip
        self._figure.add_artist(patch)

    def _line(self, shape: LineShape) -> None:
        from matplotlib.lines import Line2D

        x, y = zip(*shape.points, strict=True)
        line: Any = Line2D(
            x, y, color=(*shape.colour, shape.opacity), linewidth=shape.width * _PT_PER_PX,
            zorder=self._above(), transform=self._place, solid_capstyle="round",
            solid_joinstyle="round",
        )  # fmt: skip
        if shape.dash is not None:  # in widths of the line
            line.set_linestyle((0.0, [part / shape.width for part in shape.dash]))
            line.set_dash_capstyle("butt")
        self._figure.add_artist(line)

    def _image(self, picture: PixelShape) -> None:
        left, top, wide, high = picture.place
        width, height = self._size
        place = left / width, 1.0 - (top + high) / height, wide / width, high / height
        axes: Any = self._figure.add_axes(place, zorder=self._above(), frameon=False)
        axes.set_axis_off()
        axes.imshow(picture.pixels, aspect="auto", interpolation="none")  # its own pixels

    def _text(self, text: TextShape) -> None:
        from matplotlib.font_manager import FontProperties
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path
        from matplotlib.transforms import Affine2D

        written, em, turn = text.written, text.em, text.written.turn
        cos, sin = np.cos(turn), np.sin(turn)
        paths = [
            Path(size * part.vertices + (at, 0.0), part.codes)
            for piece, is_tex, size, at in written.pieces
            if len((part := surrounded(piece, is_tex)).vertices)
        ]
        matrix = Affine2D().scale(em).rotate(turn).scale(1.0, -1.0).translate(*text.place)
        halo: Any = PathPatch(
            Path.make_compound_path(*paths), facecolor="none", edgecolor=written.halo,
            alpha=HALO_OPACITY * written.opacity, linewidth=2.0 * HALO_EM * em * _PT_PER_PX,
            joinstyle="round", capstyle="round", transform=matrix + self._place,
            zorder=self._above(),
        )  # fmt: skip
        self._figure.add_artist(halo)
        for (piece, is_tex, size, _), place in zip(written.pieces, _along(text), strict=True):
            if len(piece_of(piece, is_tex).vertices):
                name = "DejaVuSans" if is_set_in_words(piece) else "STIXGeneral"
                font: Any = FontProperties(
                    fname=font_file(name), size=size * em * _PT_PER_PX, math_fontfamily=FONT
                )
                down = _raised(piece, font) / _PT_PER_PX if is_tex else 0.0
                x = (place[0] + sin * down) / self._size[0]
                y = 1.0 - (place[1] + cos * down) / self._size[1]
                self._figure.text(
                    x, y, mathtext(piece) if is_tex else piece.replace("$", r"\$"),
                    fontproperties=font, color=written.colour, alpha=written.opacity,
                    rotation=np.degrees(turn), rotation_mode="anchor", zorder=self._above(),
                    ha="left", va="baseline",
                )  # fmt: skip
        if written.underlined:
            (x, y), low = text.place, UNDER_EM * em
            end = max(
                at + w * s for (_, _, s, at), w in zip(written.pieces, written.widths, strict=True)
            )
            ends = [(x + low * sin, y + low * cos)]
            ends.append((ends[0][0] + cos * end * em, ends[0][1] - sin * end * em))
            self._line(LineShape(ends, rgb(written.colour), 1.0, low / 2.0))


def _along(text: TextShape) -> Iterator[tuple[float, float]]:
    """Yield where each piece of a label begins, in pixels of the figure."""
    (x, y), turn = text.place, text.written.turn
    for _, _, _, at in text.written.pieces:
        yield x + np.cos(turn) * at * text.em, y - np.sin(turn) * at * text.em


def _raised(tex: str, font: Any) -> float:
    """How many points matplotlib raises a formula: it rounds the formula's height up to a whole."""
    from matplotlib.mathtext import MathTextParser

    parser: Any = MathTextParser("path")
    size_pt, heights = font.get_size_in_points(), []
    for em_pt in (size_pt, _LARGE_PT):
        size = font.copy()
        size.set_size(em_pt)
        heights.append(parser.parse(mathtext(tex), 72, size).glyphs[0][-1] * size_pt / em_pt)
    return float(heights[0] - heights[1])
