"""All that a drawing has in a render window: its props, by layers, and its labels."""

import weakref
from collections.abc import Callable
from typing import Any

from vtkmodules.vtkRenderingCore import vtkProp

from app.drawings.label import SceneLabel
from app.drawings.style import Style, rgb


class PropGroup:
    """A drawing's props in one render window, added together and taken out together.

    `screen` has `render_window` and `renderer`; it is not kept. ``layout(width_px, height_px)`` is
    called just before a rendering in a window of another size, and after `relayout`. It must not
    render.
    """

    def __init__(self, screen: Any, style: Style, layout: Callable[[int, int], None]) -> None:
        self.window = screen.render_window
        self.renderer = screen.renderer
        self.style = style
        self._props: list[tuple[Any, vtkProp]] = []
        self._layers: dict[vtkProp, str] = {}
        self._unwanted: set[vtkProp] = set()
        self.hidden: frozenset[str] = frozenset()  # the layers that are switched off
        self._labels: list[SceneLabel] = []
        self.labels_light = 1.0  # part of the labels' opacity that is shown
        self.can_rest = True  # whether it may stay in the window while another group is drawn there
        self._layout = weakref.WeakMethod(layout)
        self._laid_out: tuple[int, int] | None = None
        self.make_ready(self.renderer)
        self.renderer.SetBackground(*rgb(style.background))
        itself = weakref.ref(self)  # or window and canvas would keep each other alive

        def start(_window: object, _event: str) -> None:
            canvas = itself()
            if canvas is not None and canvas.renderer.GetDraw():
                canvas.lay_out()

        self._observer: int | None = self.window.AddObserver("StartEvent", start)

    @staticmethod
    def make_ready(renderer: Any) -> None:
        """Make a renderer draw everything it is given, in the order it is given, and opaquely."""
        renderer.GetCullers().RemoveAllItems()
        renderer.SetBackgroundAlpha(1.0)  # or Qt blends it with the window behind it
        renderer.SetUseOIT(False)

    def set_drawn(self, drawn: bool) -> None:
        """Draw at a rendering of the window, or rest while another group does."""
        for renderer in {self.renderer, *(renderer for renderer, _ in self._props)}:
            renderer.SetDraw(drawn)

    def add(
        self, *props: vtkProp, renderer: Any = None, layer: str = "", after: Any = None
    ) -> None:
        """Add props to a renderer, the screen's own by default, to be drawn last or `after` one.

        The props of a layer are shown and hidden by `set_visible` alone.
        """
        renderer = self.renderer if renderer is None else renderer
        for prop in props:
            renderer.AddViewProp(prop)
            if after is not None:
                drawn = renderer.GetViewProps()
                drawn.RemoveItem(prop)
                drawn.InsertItem(drawn.IsItemPresent(after) - 1, prop)
            self._props.append((renderer, prop))
            if layer:
                self._layers[prop] = layer
                prop.SetVisibility(layer not in self.hidden)

    def set_visible(self, visible: bool, *props: vtkProp) -> None:
        """Show props of layers, unless the layer is hidden; or hide them."""
        (self._unwanted.difference_update if visible else self._unwanted.update)(props)
        for prop in props:
            prop.SetVisibility(visible and self._layers[prop] not in self.hidden)

    def show_layers(self, hidden: frozenset[str]) -> None:
        self.hidden = hidden
        for prop, layer in self._layers.items():
            prop.SetVisibility(prop not in self._unwanted and layer not in hidden)
        for label in self._labels:
            label.set_shown("labels" not in hidden)

    def label(self, text: str, renderer: Any = None, **options: Any) -> SceneLabel:
        label = SceneLabel(text, self.style, **options)
        label.set_shown("labels" not in self.hidden)
        label.fade(self.labels_light)
        self._labels.append(label)
        self.add(label.actor, renderer=renderer)
        self.relayout()
        return label

    def fade_labels(self, light: float) -> None:
        """Show a part of the opacity of labels and leaders, 0 to 1."""
        if light == self.labels_light:
            return
        self.labels_light = light
        for label in self._labels:
            label.fade(light)
        for prop, layer in self._layers.items():
            if layer == "labels":
                prop.GetProperty().SetOpacity(light)  # type: ignore[attr-defined]

    def relayout(self) -> None:
        """Ask for a layout before the next rendering."""
        self._laid_out = None

    @property
    def is_laid_out(self) -> bool:
        """Whether the next rendering needs no layout."""
        return bool(self._laid_out == self.window.GetSize())

    def remove(self) -> None:
        if self._observer is not None:
            self.window.RemoveObserver(self._observer)
            self._observer = None
        for renderer, prop in self._props:
            renderer.RemoveViewProp(prop)
        self._props.clear()
        self._layers.clear()
        self._unwanted.clear()
        self._labels.clear()

    def lay_out(self) -> None:
        """Lay out what was not laid out since the window has its size; a rendering does it, too."""
        now = width_px, height_px = self.window.GetSize()
        layout = self._layout()
        if now == self._laid_out or layout is None or 0 in now:
            return
        self._laid_out = now
        layout(width_px, height_px)
        self._laid_out = now  # labels that it has made are in their places
