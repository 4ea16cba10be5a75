"""The files of figures, each written whole or not at all."""

import io
import os
import re
from collections.abc import Callable, Sequence
from functools import partial

from PIL import Image, PngImagePlugin

from app.document.codec import FORMAT
from app.document.files import write_bytes_atomically
from app.document.lengths import DPI
from app.drawings.describing import Description
from app.drawings.off_screen import Pixels
from app.drawings.pdf import pdf
from app.drawings.svg import svg
from app.drawings.tikz import LARGEST, tikz
from app.drawings.vectors import Shape
from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal
from app.strangers import printable

A_LINK = QT_TRANSLATE_NOOP("Refusal", "{0}: is a link, where a picture of the figure would be.")


def write_shapes(
    path: str,
    shapes: Sequence[Shape],
    size: tuple[float, float],
    about: Description,
    watch: Callable[[], object],
) -> None:
    """Write shapes of a size in pixels as SVG, PDF or TikZ, which reads PNG files beside it."""
    name, ending = os.path.splitext(os.path.basename(path))
    said = about.title, about.text
    if ending.lower() == ".tex":
        content, pictures = tikz(shapes, size, *said, name)
        if pictures and not re.fullmatch(r"[\w.+=-]+", name, re.ASCII):
            raise Refusal.saying(REFUSALS["not-found-by-tex"], path)
        if len(content) > LARGEST:
            sizes = (f"{count / 1e6:.3g}" for count in (len(content), LARGEST))
            raise Refusal.saying(REFUSALS["too-large-for-tex"], path, *sizes, f"{name}.pdf")
        beside = {os.path.join(os.path.dirname(path), each): each for each in pictures}
        if any(map(os.path.islink, beside)):  # a stranger's list of figures chooses the name
            raise Refusal.saying(A_LINK, next(filter(os.path.islink, beside)))
        for place, each in beside.items():
            write_bytes_atomically(place, pictures[each])
    else:
        write = partial(pdf, watch=watch) if ending.lower() == ".pdf" else svg
        content = write(shapes, size, *said)
    write_bytes_atomically(path, content)


def png_bytes(
    pixels: Pixels,
    document_json: str | None = None,
    scale: float = 1.0,
    about: Description | None = None,
) -> bytes:
    """Return the PNG file of pixels.

    Dropped on the window, it brings `document_json` back. `scale` sets its dots per inch. `about`
    says what it shows to those who do not see it.
    """
    buffer = io.BytesIO()
    dpi = max(1.0, DPI * scale)
    info = PngImagePlugin.PngInfo()
    if document_json is not None:
        info.add_itxt(FORMAT, document_json)
    if about is not None:
        info.add_itxt("Title", printable(about.title))
        info.add_itxt("Description", printable(about.text))
    Image.fromarray(pixels).save(buffer, "PNG", dpi=(dpi, dpi), pnginfo=info)
    return buffer.getvalue()
