"""The command ``export``: one figure, or the figures of a list."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from app.commands import batch
from app.commands.arguments import check_drawing, check_out, document_of, importing, load_scene
from app.commands.options import CliError, complain, parser_of
from app.document.codec import picture_json
from app.document.document import Document
from app.model.refusal import Refusal

if TYPE_CHECKING:
    from app.scenes.scene import Scene


def run(arguments: Sequence[str]) -> int:
    """Draw the figures that the arguments ask for; return the exit status."""
    found, (out, *file) = parser_of("export").read(arguments)
    if found.batch is not None:
        return batch.run(found, out, file, _draw)
    for option in ("resume", "format"):
        if getattr(found, option):
            raise CliError(f"--{option}: needs --batch.")
    warning = _draw(found, out, file[0] if file else None)
    if warning:
        complain(warning, 0)
    return 0


def _draw(found: argparse.Namespace, out: str, file: str | None) -> str:
    """Write a figure; return what is incomplete in it, in one sentence, or nothing."""
    if not out.lower().endswith((".png", ".svg", ".pdf")):
        raise CliError(f"OUT = {out!r}: must end in .png, .svg or .pdf.")
    has_pixels = out.lower().endswith(".png")
    if not has_pixels and found.scale != 1.0:
        raise CliError("--scale: is for .png; shapes are as fine at every scale.")
    if has_pixels and found.hidden:
        raise CliError("--hidden: is for .svg and .pdf, whose lines are shapes.")
    if "/" in found.panes and "," in found.panes:
        raise CliError(f"--panes = {found.panes!r}: must be a row or a column, not both.")
    check_out("OUT", out)
    document = document_of(file, found.set)
    scene = load_scene(document.scene, document.mesh, file)
    check_drawing()
    with importing():
        from app.drawings.describing import describe
        from app.drawings.figures import TEXT, render, write_png, write_shapes
    options = _options(found, document)
    try:
        if has_pixels:
            pixels = render(scene, document.projection, scale=found.scale, **options)
            write_png(out, pixels, picture_json(document), found.scale)
        else:
            about = describe(document, scene, options["panes"])
            hidden = found.hidden or "none"
            write_shapes(out, scene, document.projection, about, hidden=hidden, **options)
    except Refusal as error:
        of_size = found.size and error.file is None and str(error).startswith(("width", "height"))
        text = str(error).replace("text size =", "--text-size =", int(error.bound == TEXT))
        raise CliError(f"{'--size ' if of_size else ''}{text}") from error
    return _warning(document, scene)


def _options(found: argparse.Namespace, document: Document) -> dict[str, Any]:
    """Return the parameters that `render` and `write_shapes` share."""
    from app.drawings.style import PALETTES

    return {
        "panes": re.split("[,/]", found.panes),
        "column": "/" in found.panes,
        "crop": found.crop,
        "size": found.size,
        "transparent": found.transparent,
        "style": PALETTES[found.palette],
        "view": document.view,
        "settings": document.settings,
        "quality": document.quality,
        "text_pt": found.text_size,
    }


def _warning(document: Document, scene: Scene) -> str:
    """Return what a picture lacks that was written all the same."""
    if scene.phenomenon is None:
        return ""
    settings = scene.phenomenon.checked(document.settings)
    illustration = scene.phenomenon.illustration(document.projection, settings, scene.subject)
    warning = illustration.warning
    return "" if warning is None else f"{document.scene}: {warning.sentence()}."
