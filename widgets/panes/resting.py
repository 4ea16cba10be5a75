"""Drawings that rest in a pane's window: of scenes that were shown, or that may be shown next."""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from app.drawings.drawing import Drawing
from widgets.panes.canvas import AnyCanvas, RasterCanvas, release_context, smooth_window
from widgets.parts.panel import ShownData

MOST = 6  # drawings of a pane, about 3 MB each
MOST_CELLS = 20_000  # of the scene of each


class Resting(NamedTuple):
    args: tuple[Any, ...] | None  # the arguments of `Pane.build` that the drawing is for
    drawing: Drawing
    applied: Mapping[str, Any]  # the values of `Pane.request` that it shows
    shown: ShownData | None  # what it shows in its first view; None if more has happened to it


class RestingDrawings:
    """The drawings of a canvas that it does not show, the one that rests longest first.

    `make_drawing` is that of the `Pane`, and what it makes shows `as_built`.
    """

    def __init__(
        self, canvas: AnyCanvas, make_drawing: Callable[..., Drawing], as_built: Mapping[str, Any]
    ) -> None:
        self._canvas, self._make_drawing, self._as_built = canvas, make_drawing, as_built
        self.all: list[Resting] = []
        self._old: list[Drawing] = []  # releasing them takes time

    def draw(self, shown: ShownData, now: Drawing | None, *args: object) -> None:
        """Make the drawing that a `build` with the same arguments will show, not `now`."""
        canvas, is_there = self._canvas, any(each.args == args for each in self.all)
        if is_there or not isinstance(canvas, RasterCanvas) or not canvas.is_open:
            return
        page = canvas.renderer
        if now is not None:
            now.state.canvas.set_drawn(False)
        try:
            with canvas.new_page():
                drawing = self._make_drawing(canvas, *args)
            drawing.show_projection(shown.projection, shown.illustration)
            drawing.reset_view()
            smooth_window(canvas.render_window, canvas.smoothing)
            canvas.draw_unseen()  # compiles the shaders
            self.put(Resting(args, drawing, self._as_built, shown))
        finally:
            canvas.renderer = page
            if now is not None:
                now.state.canvas.set_drawn(True)

    def draw_beside(self, pictures: int, shown: ShownData, *args: object) -> None:
        """Have windows ready for pictures that will be compared with the canvas' own."""
        from app.drawings.off_screen import kept

        beside = [RasterCanvas(None) for _ in range(pictures if pictures > len(kept) else 0)]
        try:
            for canvas in beside:
                release_context()
                canvas.resize(self._canvas.size())
                canvas.open()
                canvas.smooth(self._canvas.smoothing)
                ahead = RestingDrawings(canvas, self._make_drawing, self._as_built)
                ahead.draw(shown, None, *args)
                ahead.clear()
        finally:
            for canvas in beside:
                canvas.close()
                canvas.deleteLater()

    def put(self, resting: Resting) -> None:
        """Let a drawing rest; if there are too many, or it is too large, it is released later."""
        canvas = resting.drawing.state.canvas
        canvas.set_drawn(False)
        if resting.args and resting.args[0].cells <= MOST_CELLS and canvas.can_rest:
            self.all.append(resting)
        else:
            self._old.append(resting.drawing)
        while len(self.all) > MOST:
            self._old.append(self.all.pop(0).drawing)

    def take(self, args: tuple[object, ...]) -> Resting | None:
        """Show the drawing for these arguments, if there is one."""
        for each in self.all:
            if each.args == args:
                self.all.remove(each)
                self._canvas.renderer = each.drawing.state.canvas.renderer
                each.drawing.state.canvas.set_drawn(True)
                return each
        return None

    def clear(self) -> None:
        self._old += [each.drawing for each in self.all]
        self.all.clear()
        self.release()

    def release(self) -> None:
        """Release what was put here in vain."""
        for drawing in self._old:
            drawing.remove()
            self._canvas.render_window.RemoveRenderer(drawing.state.canvas.renderer)
        self._old.clear()
