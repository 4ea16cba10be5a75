"""The viewpoints of the world in a moving picture.

The free view of a figure depends on what it shows. In a moving picture it would jump about; so
one place shows all of the frames, or a round of places shows one state.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from app.document.document import Document
from app.drawings.drawing import Drawing
from app.drawings.figures import render
from app.drawings.one_pane import illustration_of
from app.drawings.world import WorldDrawing
from app.model.projection import Camera
from app.scenes.scene import Scene

_MOST_MOMENTS = 9


def standing(
    scene: Scene, states: Sequence[Document], turns_deg: Sequence[float], **options: Any
) -> list[Camera]:
    """Return the views of the world that show all of the states, one for each turn.

    `options` are those of `render`, as far as they matter for the size of the panes.
    """
    cameras: list[list[Camera]] = []
    last = len(states) - 1
    chosen = sorted({round(last * part / (_MOST_MOMENTS - 1)) for part in range(_MOST_MOMENTS)})
    shown = [states[place] for place in chosen]
    moments = [(of.projection, illustration_of(scene, of.projection, of.settings)) for of in shown]

    def seen(drawing: Drawing, _factor: int) -> None:
        if isinstance(drawing, WorldDrawing):
            cameras.append(drawing.views(moments, turns_deg))

    first = states[0]
    render(
        scene, first.projection, view=first.view, settings=first.settings, quality=first.quality,
        seen=seen, **options,
    )  # fmt: skip
    # Compared pictures have a world each.
    return max(cameras, key=lambda each: each[0].distance)
