"""Drawings that are made before they are shown, so that a step of a lesson appears at once."""

from collections.abc import Callable
from typing import Any, NamedTuple

from app.drawings.drawing import Drawing
from widgets.panes.canvas import AnyCanvas, RasterCanvas, smooth_window
from widgets.parts.panel import ShownData


class _DrawnAhead(NamedTuple):
    args: tuple[object, ...]  # the arguments of `Pane.build` that the drawing is for
    shown: ShownData
    screen: Any
    drawing: Drawing


class DrawingsAhead:
    """The drawings that are made ahead for a canvas; only a `RasterCanvas` can take them.

    `make_drawing` is that of the `Pane`.
    """

    def __init__(self, canvas: AnyCanvas, make_drawing: Callable[..., Drawing]) -> None:
        self._canvas, self._make_drawing = canvas, make_drawing
        self._drawn: list[_DrawnAhead] = []
        self._replaced: list[tuple[Any, Drawing | None]] = []
        """Screens and drawings that were replaced; releasing them takes time."""

    def draw(self, shown: ShownData, *args: object) -> None:
        """Make the drawing that a `build` with the same arguments will show."""
        canvas = self._canvas
        if not isinstance(canvas, RasterCanvas) or not canvas.is_open:
            return
        if not any(each.args == args for each in self._drawn):
            screen = canvas.screen_ahead()
            drawing = self._make_drawing(screen, *args)
            drawing.show_projection(shown.projection, shown.illustration)
            drawing.reset_view()
            smooth_window(screen.render_window, canvas.smoothing)
            screen.render_window.Render()  # compiles the shaders
            self._drawn.append(_DrawnAhead(args, shown, screen, drawing))

    def keep(self, *wanted: tuple[object, ...]) -> None:
        """Release all drawings with other arguments, and all replaced drawings."""
        old = [each for each in self._drawn if each.args not in wanted]
        self._drawn = [each for each in self._drawn if each.args in wanted]
        for screen, _ in (*self._replaced, *((each.screen, each.drawing) for each in old)):
            screen.give_back()
        self._replaced.clear()

    def take(
        self, args: tuple[object, ...], before: Drawing | None
    ) -> tuple[ShownData, Drawing] | None:
        """Show the drawing for these arguments instead of the one before, if there is one."""
        for each in self._drawn:
            if each.args == args and isinstance(self._canvas, RasterCanvas):
                self._drawn.remove(each)
                self._replaced.append((self._canvas.show_screen(each.screen), before))
                return each.shown, each.drawing
        return None
