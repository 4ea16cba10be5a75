"""Telling a widget of a change, as the window does."""

from functools import cache

from app.document.document import Document
from app.model.projection import Projection
from app.scenes.scene import Scene, load
from widgets.parts.panel import PROJECTION, Changed, Listener, ShownData


@cache
def _letter() -> Scene:
    return load("letter-f")


def show(
    listener: Listener,
    projection: Projection,
    scene: Scene | None = None,
    changed: Changed = PROJECTION,
) -> None:
    """Show another projection; of the letter F if no scene is given."""
    scene = scene or _letter()
    listener.take(ShownData.of(Document(scene.name, projection), scene), changed)
