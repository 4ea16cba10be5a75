"""Labels kept between runs: to load matplotlib would take a sixth of the time of a window's start.

Those of the letter F come with the program; ``python3 -m tests.pictures --labels`` makes their
files, of which a language's has only what English has not. The user's own file keeps those of other
documents; if it is missing, damaged or of other versions, they are set anew. All are copies of what
`app.lecture.typesetting` and `app.drawings.label` make.
"""

import importlib.util
import json
import logging
import os
import sys
import zlib
from base64 import b64decode, b64encode
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app import languages, modules
from app.document.files import write_bytes_atomically
from app.drawings import label
from app.lecture import typesetting
from app.lecture.typesetting import Outline
from app.strangers import open_regular

_CONTENT = Path(__file__).parent / "content"
LARGEST_BYTES = 2**23  # a larger file is not read
_log = logging.getLogger(__name__)
KEYS_SHIPPED: set[str] = set()


def shipped(language: str) -> Path:
    return _CONTENT / f"labels_{language}.json.z"


def load_shipped() -> None:
    """Take over the labels that come with the program; `save` leaves them out."""
    for language in {languages.ENGLISH, languages.chosen()}:
        tree = json.loads(zlib.decompress(shipped(language).read_bytes()))
        _take(tree)
        KEYS_SHIPPED.update(tree["outlines"], tree["tiles"])


def load(path: Path) -> None:
    """Take over the labels in a file; a file that cannot be read is no error."""
    try:
        content = _content(path)
        tree = json.loads(content if len(content) <= LARGEST_BYTES else b"")
        if tree["made_by"] == _made_by():
            _take(tree)
    except FileNotFoundError:
        return
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        _log.info("%s: labels are set anew: %s", path, error)


def _take(tree: Any) -> None:
    outlines = {key: _outline(*parts) for key, parts in tree["outlines"].items()}
    tiles = {key: _tile(*parts) for key, parts in tree["tiles"].items()}
    typesetting.SET.update(outlines)
    label.TILES.update(tiles)


def save(path: Path) -> None:
    """Write all labels that are set, unless the file has them; one that cannot be is no error."""
    content = json.dumps({"made_by": _made_by(), **tree_of(KEYS_SHIPPED)}).encode()
    try:
        if not os.path.exists(path) or _content(path) != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_bytes_atomically(path, content)
    except (OSError, ValueError) as error:
        _log.info("%s: labels are not kept: %s", path, error)


def _content(path: Path) -> bytes:
    with open_regular(path) as file:
        return file.read(LARGEST_BYTES + 1)


def tree_of(without: set[str]) -> dict[str, dict[str, Any]]:
    """Return what is set, but for the labels of some keys."""
    return {
        "outlines": {
            key: [each.width, each.ascent, each.descent, _text(each.vertices), _text(each.codes),
                  each.letters]
            for key, each in typesetting.SET.items() if key not in without
        },
        "tiles": {
            key: [*letters.shape, _text(letters), _text(halo), first, top]
            for key, (letters, halo, first, top) in label.TILES.items() if key not in without
        },
    }  # fmt: skip


def _made_by() -> list[str]:
    """What the labels depend on: the modules that set them, by size and time."""
    specs = map(importlib.util.find_spec, ("matplotlib", typesetting.__name__, label.__name__))
    paths = [sys.executable] if modules.FROZEN else [spec.origin or "" for spec in specs if spec]
    files = [(path, os.stat(path)) for path in paths]
    return [f"{path} {stat.st_size} {stat.st_mtime_ns}" for path, stat in files]


def _text(array: NDArray[Any]) -> str:
    return b64encode(array.tobytes()).decode()


def _bytes(text: str) -> NDArray[np.uint8]:
    return np.frombuffer(b64decode(text, validate=True), dtype=np.uint8)


def _outline(
    width: float, ascent: float, descent: float, vertices: str, codes: str, letters: list[Any]
) -> Outline:
    places = _bytes(vertices).view(np.float64).reshape(-1, 2)
    kinds = _bytes(codes)
    named = tuple((str(name), int(begin), int(end)) for name, begin, end in letters)
    if len(places) != len(kinds) or not np.isfinite([width, ascent, descent, *places.flat]).all():
        raise ValueError("outlines without a place")
    return Outline(float(width), float(ascent), float(descent), places, kinds, named)


def _tile(height: int, width: int, letters: str, halo: str, first: int, top: int) -> label.Tile:
    shape = height, width
    if min(shape) < 0:
        raise ValueError("a tile of less than no pixels")
    return _bytes(letters).reshape(shape), _bytes(halo).reshape(shape), int(first), int(top)
