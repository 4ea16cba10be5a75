"""Drawings without a window, and what is on their pictures."""

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow, vtkUnsignedCharArray

from app.document.document import Document
from app.document.lengths import Size
from app.document.view import AS_EVER, PANES, View
from app.drawings import WORDS
from app.drawings.figure import Figure
from app.drawings.image import ImageDrawing
from app.drawings.label import LabelActor, SceneLabel
from app.drawings.off_screen import take_screen
from app.drawings.picture_frame import UNFRAMED
from app.drawings.style import LIGHT, rgb
from app.lecture.highlight import NOTHING, Highlight
from app.model.projection import Projection
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene, load

Pixels = NDArray[np.uint8]
Box = tuple[float, float, float, float]
"""Left, bottom, right, top, in pixels from the bottom left."""


class OffScreen:
    """A window on no screen, and the picture in it."""

    def __init__(self, width: int, height: int) -> None:
        self._screen = take_screen(width, height)
        self.window = self.render_window = self._screen.render_window
        self.renderer = self._screen.renderer

    def clear(self) -> None:
        """Make room for another drawing: a window of its own would compile its shaders anew."""
        self._screen.clear(*self.window.GetSize())
        self.renderer = self._screen.renderer

    def close(self) -> None:
        self._screen.give_back()

    def pixels(self) -> Pixels:
        return rendered(self.render_window)


def rendered(window: Any) -> Pixels:
    """Render once; (height, width, 3), the first row on top."""
    window.Render()
    width, height = window.GetSize()
    buffer = vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, buffer)
    return np.array(vtk_to_numpy(buffer).reshape(height, width, 4)[::-1, :, :3])


MakeScreen = Callable[[int, int], OffScreen]


def texts_of(screen: Any) -> dict[str, SceneLabel]:
    """The visible labels of a screen's own renderer, by their texts; a rendering places them."""
    screen.render_window.Render()
    return labels_of(screen.renderer)


def labels_of(*renderers: Any) -> dict[str, SceneLabel]:
    """The visible labels of renderers, by their texts."""
    labels = [
        prop.label()
        for renderer in renderers
        for prop in renderer.GetViewProps()
        if isinstance(prop, LabelActor) and prop.GetVisibility()
    ]
    return {label.text: label for label in labels if label is not None}


def lit_at(drawing: Any, x_px: float, y_px: float) -> Highlight:
    """What lights up under a pointer, counted from the pane's top left."""
    taken = drawing.handles.at((x_px, y_px))
    return NOTHING if taken is None else taken.about


def boxes_of(screen: Any) -> dict[str, Box]:
    """The boxes of the visible labels, by their texts."""
    boxes = {text: label.box_px for text, label in texts_of(screen).items()}
    return {text: (left, low, right, high) for text, (left, right, low, high) in boxes.items()}


def overlapping(boxes: Mapping[str, Box]) -> list[tuple[str, str]]:
    """Pairs of texts whose boxes overlap."""
    return [
        (one, other)
        for (one, a), (other, b) in itertools.combinations(boxes.items(), 2)
        if a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
    ]


def illustrated(scene: Scene, projection: Projection | None = None) -> Illustration | None:
    """What a scene's phenomenon shows with its default settings."""
    if scene.phenomenon is None:
        return None
    settings = scene.phenomenon.checked({})
    return scene.phenomenon.illustration(projection or scene.start, settings, scene.subject)


def figure_of(
    scene: Scene,
    projection: Projection | None = None,
    panes: Sequence[str] = PANES,
    size: Size | tuple[int, int] | None = None,
    *,
    view: View = AS_EVER,
    settings: Mapping[str, Any] | None = None,
    quality: Quality = AUTOMATIC,
    **options: Any,
) -> Figure:
    """A figure of a scene, under its own projection unless another is given."""
    state = Document(
        scene.name, projection or scene.start, view=view, settings=settings or {}, quality=quality
    )
    return Figure(state, scene, panes, size, **options)


def shown(screen: Any, scene: Scene, projection: Projection, *args: Any, **options: Any) -> Pixels:
    """The pixels of an unframed image drawing, or of another `kind`."""
    kind = options.pop("kind", ImageDrawing)
    if kind is ImageDrawing:
        options.setdefault("options", UNFRAMED)
    drawing = kind(screen, scene, WORDS, LIGHT, *args, **options)
    drawing.show_projection(projection)
    pixels: Pixels = screen.pixels()
    return pixels


@contextmanager
def heard() -> Iterator[vtkStringOutputWindow]:
    """What VTK says meanwhile, which is kept from everybody else."""
    said, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(said)
    yield said
    vtkOutputWindow.SetInstance(before)


@contextmanager
def off_screen_windows() -> Iterator[Callable[[int, int], OffScreen]]:
    """Make windows on no screen, closed at the end; VTK must have had nothing to say."""
    made: list[OffScreen] = []

    def make(width: int, height: int) -> OffScreen:
        made.append(OffScreen(width, height))
        return made[-1]

    with heard() as said:
        yield make
        for one in made:
            one.close()
    assert said.GetOutput() == ""


def scene_of(
    points: Any, faces: Any, colours: Any, origin: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> Scene:
    """A scene of polygons in these colours; points are relative to the origin."""
    mesh = pv.PolyData(
        np.array(points, dtype=float), faces=np.hstack([[len(f), *f] for f in faces])
    )
    mesh.cell_data["rgb"] = np.array(colours, dtype=np.uint8)
    return replace(
        load("cube"),
        origin=origin,
        surface=mesh,
        lines=None,
        lower=(-3.0, -3.0, -3.0),
        upper=(3.0, 3.0, 3.0),
    )


def drawn(image: Pixels, colour: Any) -> NDArray[np.bool_]:
    """Where a picture has just this colour; channel by channel, as `all` is slow along three."""
    channels = [image[..., i] == part for i, part in enumerate(colour)]
    return np.logical_and.reduce(channels)


def colours_of(image: Pixels) -> int:
    """How many colours a picture has."""
    return len(np.unique(image.astype(np.uint32) @ np.array([1, 1 << 8, 1 << 16], np.uint32)))


def to_bytes(colour: str) -> list[int]:
    return [round(255 * part) for part in rgb(colour)]
