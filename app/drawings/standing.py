"""The viewpoints of the world in a moving picture.

The free view of a figure depends on what it shows. In a moving picture it would jump about; so
one place shows all of the frames, or a round of places shows one state.
"""

from collections.abc import Sequence

from app.document.document import Document
from app.drawings.drawing import Drawing
from app.drawings.figure import Figure
from app.drawings.world import WorldDrawing
from app.model.projection import Camera

_MOST_MOMENTS = 9


def standing(
    figure: Figure, states: Sequence[Document], turns_deg: Sequence[float]
) -> list[Camera]:
    """Return the views of the world that show all of the states, one for each turn.

    The panes are those of the figure, which shows the first state.
    """
    cameras: list[list[Camera]] = []
    last = len(states) - 1
    chosen = sorted({round(last * part / (_MOST_MOMENTS - 1)) for part in range(_MOST_MOMENTS)})
    moments = [
        (state.projection, figure.scene.illustration(state.projection, state.settings))
        for state in map(states.__getitem__, chosen)
    ]

    def seen(drawing: Drawing, _factor: int) -> None:
        if isinstance(drawing, WorldDrawing):
            cameras.append(drawing.views(moments, turns_deg))

    figure.pixels(seen=seen)
    # Compared pictures have a world each.
    return max(cameras, key=lambda views: views[0].distance)
