"""Telling a widget of a change, as the window does."""

from __future__ import annotations

from functools import cache

from app.document.document import Document
from app.model.projection import Projection
from app.scenes.scene import Scene, load
from widgets.parts.panel import PROJECTION, Changed, Shown, Told


@cache
def _letter() -> Scene:
    return load("letter-f")


def show(
    told: Told,
    projection: Projection,
    scene: Scene | None = None,
    changed: Changed = PROJECTION,
) -> None:
    """Tell of another projection, of the letter F if no scene is given."""
    scene = scene or _letter()
    told.take(Shown.of(Document(scene.name, projection), scene), changed)
