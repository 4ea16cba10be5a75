"""A PNG picture that carries a document, made without the program."""

import io

from PIL import Image, PngImagePlugin


def carrier(text: str | None = None, keyword: str = "frustum-lab", **options: object) -> bytes:
    """A small picture, with a text if one is given; `options` are those of `PngInfo.add_itxt`."""
    image = Image.new("RGBA", (5, 3))
    image.putdata([(40 * x, 70 * y, 9, 255 - x) for y in range(3) for x in range(5)])
    info = PngImagePlugin.PngInfo()
    info.add_itxt("Title", "another text")
    if text is not None:
        info.add_itxt(keyword, text, **options)  # type: ignore[arg-type]
    file = io.BytesIO()
    image.save(file, "PNG", pnginfo=info)
    return file.getvalue()
