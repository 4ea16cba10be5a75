"""The strokes of a lecturer on the slides of a talk, and the file beside the talk with them."""

import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

from app.document.files import blamed_on, content_of, write_bytes_atomically
from app.model.refusal import REFUSALS, Refusal
from app.strangers import decode

LARGEST = 8 * 2**20  # most bytes of a file
COLOURS = ("ink", "u", "v", "n")
"""Names of the colours of a pen, as in `app.drawings.style.Style`; projectors have `accent`."""
_READABLE = (*COLOURS, "accent", "near")  # colours of strokes in files

Strokes: TypeAlias = Mapping[str, Sequence["Stroke"]]
"""By the names of the steps, and of the pictures that their answers show."""


class Stroke(NamedTuple):
    """A line that was drawn by hand, in fractions of the slide's width and height."""

    colour: str
    points: tuple[tuple[float, float], ...]


def path_beside(talk: Path) -> Path:
    return talk.with_suffix(".strokes.json")


def picture_beside(talk: Path, step: str) -> Path:
    """Return the file that keeps a slide with its strokes, for the handout."""
    return talk.with_suffix(".strokes") / f"{step}.png"


def answer_picture(step: str, number: int) -> str:
    """Return the name of the picture that an answer of a step shows, counted from 1."""
    return f"{step}.{number}"


def write_strokes(talk: Path, strokes: Strokes) -> Path:
    """Keep the strokes of a talk in the file beside it; a `Refusal` if that fails.

    A file that cannot be read stays there as ``.bak``.
    """
    tree = {
        step: [[each.colour, *each.points] for each in drawn] for step, drawn in strokes.items()
    }
    path = path_beside(talk)
    try:
        read_strokes(talk)
    except Refusal as error:
        with blamed_on(path, REFUSALS["unwritable"]):
            if error.bound == REFUSALS["no-strokes"]:
                os.replace(path, f"{path}.bak")
    write_bytes_atomically(path, json.dumps({"strokes": tree}).encode())
    return path


def read_strokes(talk: Path) -> dict[str, tuple[Stroke, ...]]:
    """Read the strokes that were kept of a talk; none if there is no file."""
    path = path_beside(talk)
    if not os.path.exists(path):
        return {}
    with blamed_on(path, REFUSALS["files-unreadable"]):
        content = content_of(path, LARGEST)
        try:
            tree = json.loads(decode(content)[0])["strokes"]
            return {str(step): tuple(map(_stroke, drawn)) for step, drawn in tree.items()}
        except (ValueError, TypeError, LookupError, ArithmeticError,
                AttributeError, RecursionError) as error:  # fmt: skip
            raise Refusal.in_document(REFUSALS["no-strokes"]) from error


def _stroke(part: Any) -> Stroke:
    colour, *points = part
    pairs = tuple((float(x), float(y)) for x, y in points)
    if colour not in _READABLE or not pairs or not all(0.0 <= c <= 1.0 for p in pairs for c in p):
        raise ValueError(part)
    return Stroke(colour, pairs)
