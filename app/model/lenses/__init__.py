"""The lenses, one file each; to add one, write its file and add it to `LENSES`."""

from app.model.lenses.free import FreeMatrix
from app.model.lenses.frustum import Frustum
from app.model.lenses.geometry import LENSES
from app.model.lenses.lens import Lens
from app.model.lenses.oblique import Oblique
from app.model.lenses.orthographic import Orthographic
from app.model.lenses.perspective import Perspective

LENSES.update({lens.kind: lens for lens in (Perspective, Frustum, Orthographic, Oblique)})


def kinds() -> tuple[str, ...]:
    """The possible values of a document's ``lens.kind``."""
    return (*LENSES, FreeMatrix.kind)


__all__ = [
    "LENSES", "FreeMatrix", "Frustum", "Lens", "Oblique", "Orthographic", "Perspective", "kinds",
]  # fmt: skip
