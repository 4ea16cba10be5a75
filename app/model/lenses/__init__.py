"""The lenses, one file each; a new one is its file and a line of `LENSES`."""

from __future__ import annotations

from typing import Any

from app.model.lenses.free import FreeMatrix
from app.model.lenses.frustum import Frustum
from app.model.lenses.lens import Lens
from app.model.lenses.oblique import Oblique
from app.model.lenses.orthographic import Orthographic
from app.model.lenses.perspective import Perspective

LENSES: dict[str, Any] = {lens.kind: lens for lens in (Perspective, Frustum, Orthographic, Oblique)}
"""The lenses that have fields; `FreeMatrix` is beside them."""


def kinds() -> tuple[str, ...]:
    """What a document's ``lens.kind`` can be."""
    return (*LENSES, FreeMatrix.kind)


__all__ = [
    "LENSES",
    "FreeMatrix",
    "Frustum",
    "Lens",
    "Oblique",
    "Orthographic",
    "Perspective",
    "kinds",
]
