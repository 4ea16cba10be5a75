"""The one kind of pane: a title, and a canvas that shows any drawing.

How a change reaches the screen, and why it is drawn once::

    take(shown, changed) --> drawing.show_projection(p)   matrices only, draws nothing
                         --> canvas.redraw()              coalesced by Qt
    mouse on the canvas -> vtkCamera of this pane only -> canvas.redraw()
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Sequence
from typing import Any, Protocol, cast

from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, Qt, Signal
from PySide6.QtGui import (
    QCloseEvent,
    QColor,
    QKeyEvent,
    QMouseEvent,
    QMoveEvent,
    QPainter,
    QPaintEvent,
    QResizeEvent,
    QShowEvent,
)
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from app.drawings import AXES
from app.lecture.highlight import NOTHING, Highlight
from app.model.projection import Camera, Projection
from app.picking.picking import Probe, Sight
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene
from widgets.panes.canvas import AnyCanvas, Hand, RasterCanvas
from widgets.parts.icons import show_icon
from widgets.parts.note import Title
from widgets.parts.panel import PROJECTION, Changed, Shown

SCALES = {"half resolution": 0.5, "supersampling 2 x 2": 2.0}
"""Pixels that are drawn for one that is shown, along each side, where that is not one."""
SMOOTHINGS = ("none", "FXAA", "MSAA 2", "MSAA 4", "MSAA 8", *SCALES)
"""What a pane can do: of larger pictures Qt takes four pixels at the most for one."""


def multisamples(smoothing: str) -> int:
    """The samples a pixel that one of `SMOOTHINGS` asks OpenGL for."""
    kind, _, samples = smoothing.partition(" ")
    return int(samples) if kind == "MSAA" else 0


class Drawing(Protocol):
    """What a pane needs of a drawing."""

    def show_projection(self, projection: Projection, illustration: Illustration | None) -> None:
        """Take over the model's matrices; draw nothing yet."""

    def show_detail(self, fewer: Scene | None) -> None:
        """Take a scene's fewer triangles, or all for None; then show a projection."""

    def reset_view(self) -> None:
        """Put the pane's own camera where the whole drawing is in view."""

    def refit(self) -> bool:
        """Fit a view that nobody moved to what has left it; tell whether it changed."""

    def reset_clipping_range(self) -> None:
        """Fit the pane camera's own near and far to the drawing after it has moved."""

    def show_layers(self, hidden: frozenset[str]) -> None:
        """Switch off what the drawing has of these layers; then show a projection."""

    @property
    def view(self) -> Camera | None:
        """Where the pane's own camera was moved to; None if it was not."""

    def show_view(self, view: Camera) -> None:
        """Move the pane's own camera there."""

    def show_probes(self, probes: Sequence[Probe]) -> None:
        """Mark these probes, and no others; draw nothing yet."""

    @property
    def sight(self) -> Sight:
        """How the pane looks at the world just now."""

    def show_highlight(self, highlighted: Highlight) -> bool:
        """Let what is highlighted stand out; tell whether that changes what is seen."""

    def highlight_at(self, x_px: float, y_px: float) -> Highlight:
        """What is at a device pixel from the pane's top left."""

    def remove(self) -> None:
        """Take everything out of the screen again."""


class PlacedDrawing(Drawing, Protocol):
    """A drawing that shows where the object stands."""

    def show_object_axes(self, wanted: bool) -> None:
        """Show the object's axes also where they are the world's; draw nothing yet."""


class StagedDrawing(Drawing, Protocol):
    """A drawing that can show other stages of the pipeline than its own."""

    def show_stage(self, position: float) -> None:
        """Move to a position of the stage strip; draw nothing yet."""


class SteppedDrawing(Drawing, Protocol):
    """A drawing in which the camera's frame can be built step by step."""

    def show_step(self, step: int | None) -> None:
        """Build it up to a step, or show what is always shown; draw nothing yet."""


class FixedDrawing(Drawing, Protocol):
    """A drawing that has fixed views beside the free one."""

    @property
    def fixed(self) -> str:
        """The fixed view that is shown; ``""`` for the free one."""

    def show_fixed(self, view: str) -> None:
        """Take a fixed view, or the free one; draw nothing yet."""


class Surface(QWidget):
    """Holds a canvas so that its edges are on whole pixels of the screen.

    Where the screen's scale is 1.5, say, they are not everywhere: Qt then leaves a black line at
    an edge, and stretches the picture by the rest of a pixel.

    Attributes
    ----------
    beside : QColor or None
        Of what the canvas leaves free; the window's if None.
    """

    def __init__(self, canvas: QWidget) -> None:
        super().__init__()
        self._margins = QVBoxLayout(self)
        self._margins.setContentsMargins(0, 0, 0, 0)
        self._margins.addWidget(canvas)
        self._room: QRect | None = None
        self.beside: QColor | None = None

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._room is not None and self.beside is not None:
            painter = QPainter(self)
            painter.fillRect(event.rect(), self.beside)
            painter.end()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.fit()

    def set_room(self, room: QRect | None) -> None:
        """Give the canvas a part of the surface, or None for all of it."""
        if room != self._room:
            self._room = room
            self.fit()

    def fit(self) -> None:
        """Move the edges inwards to the next whole pixels."""
        place, ratio = self.mapTo(self.window(), QPoint()), self.devicePixelRatioF()
        room = self._room or self.rect()
        left, top = place.x() + room.x(), place.y() + room.y()
        self._margins.setContentsMargins(
            room.x() + _to_whole(left, 1, ratio),
            room.y() + _to_whole(top, 1, ratio),
            self.width() - room.x() - room.width() + _to_whole(left + room.width(), -1, ratio),
            self.height() - room.y() - room.height() + _to_whole(top + room.height(), -1, ratio),
        )
        self._margins.invalidate()
        self._margins.activate()


def _to_whole(edge: int, inwards: int, ratio: float) -> int:
    """How far it is from an edge to a whole pixel of the screen; 0 if there is none near."""
    for away in range(8):
        at = (edge + inwards * away) * ratio
        if abs(at - round(at)) < 1e-6:
            return away
    return 0


class Pane(QFrame):
    """A titled canvas for one drawing.

    A pane that is not visible neither computes nor draws; it shows the current value when it
    appears.

    Parameters
    ----------
    title : str
        Translated name of the pane.
    make_drawing : callable
        Builds the drawing into a screen: ``make_drawing(screen, *args)``, with the arguments
        that `build` is given.
    orbits : bool
        Whether the mouse moves this pane's own camera.
    make_canvas : class
        `GlCanvas` or `RasterCanvas`.
    """

    concerns = PROJECTION | {"illustration"}
    fixed_left = Signal()
    """The fixed view was turned by hand, and is the free one now."""
    enlarge_requested = Signal()
    """The title was double-clicked."""
    clicked = Signal(QPointF)
    """A place in the canvas, in device pixels from its top left."""
    double_clicked = Signal()
    """The canvas was double-clicked: the click before was meant to be no click."""
    float_requested = Signal()
    """The pane shall get, or leave, a window of its own."""
    highlighted = Signal(object)
    """The `Highlight` that the mouse draws to what is under it; only when that changes."""
    timed = Signal(float, float)
    """What the last step's matrices and a repaint took, in ms; only after `set_timed`."""
    marked = Signal()
    """It shows other layers or probes."""

    def __init__(
        self,
        title: str,
        make_drawing: Callable[..., Drawing],
        *,
        orbits: bool,
        make_canvas: type[AnyCanvas],
    ) -> None:
        super().__init__()
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAccessibleName(title)
        self.drawing: Any = None
        """A `Drawing`, once there is one."""
        self._make_drawing = make_drawing
        self._shown: Shown | None = None
        self._to_build: tuple[object, ...] | None = None
        self._built_with: tuple[object, ...] | None = None
        self._view: Camera | None = None
        self._view_is_stale = False
        self._stage: float | None = None
        self._stage_is_stale = False
        self._step: int | None = None
        self._step_is_stale = False
        self._fixed = ""
        self._fixed_is_stale = False
        self._hidden: frozenset[str] = frozenset()
        self._layers_are_stale = False
        self._has_object_axes = self._axes_are_stale = False
        self._is_bare = False
        self._probes: Sequence[Probe] = ()
        self._highlight = self._pointed_at = NOTHING
        self._highlight_is_stale = False
        self._stale = False
        self._probes_stale = False
        self._smoothing = "none"
        self._fewer: Scene | None = None
        self._detail_is_stale = False
        self._matrices_ms = 0.0
        self._beside_title: tuple[QWidget, QWidget] | None = None

        self.title = Title(title)
        self.note = Title("", "paneNote")
        self._reset = self._button("home", self.tr("Reset this pane's own view (double-click)"))
        self._reset.clicked.connect(self.reset_view)
        self._reset.setVisible(orbits)
        self._float = self._button("float", self.tr("Into a window of its own, and back"))
        self._float.clicked.connect(self.float_requested)
        self._enlarge = self._button("enlarge", self.tr("Enlarge; again, to the whole window"))
        self._enlarge.clicked.connect(self.enlarge_requested)
        self.header = QWidget()
        self.header.setToolTip(
            self.tr("Double-click to make this pane large; again, as large as the window, and back")
        )
        self._tools = QWidget()
        self._column = QGridLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(0)

        self.canvas = make_canvas(self)
        self.hand = Hand(self.canvas, orbits=orbits)
        self.canvas.setAccessibleName(title)
        self.hand.moved.connect(self._view_moved)
        self.hand.clicked.connect(self.clicked)
        self.hand.hovered.connect(self._hovered)
        self.hand.left.connect(self._left)
        self.canvas.painted.connect(lambda ms: self.timed.emit(self._matrices_ms, ms))
        if orbits:
            self.canvas.setToolTip(
                self.tr(
                    "Click to follow a point; drag to turn, Shift-drag to move, wheel to zoom, "
                    "double-click to reset; or Tab to here, and arrows, + −, Home"
                )
            )
            keys = self.tr("Arrow keys turn, Shift and an arrow moves, + and − zoom, Home resets.")
        else:
            self.canvas.setToolTip(
                self.tr(
                    "Click to follow a point; drag to move the camera in its plane, wheel to go "
                    "nearer to the target; or Tab to here, and arrows, + −"
                )
            )
            keys = self.tr("Arrow keys move the camera in its plane, + and − go nearer and back.")
        cursor_keys = self.tr(
            "Page Down and Page Up go from vertex to vertex, with Shift from handle to handle or "
            "probe to probe; Space follows a vertex; Enter takes hold and lets go, Shift and Enter "
            "as a drag with Shift; arrows drag by a pixel, with Shift by ten; Escape puts back."
        )
        self.canvas.setAccessibleDescription(f"{keys} {cursor_keys}")
        self.surface = Surface(self.canvas)
        self._column.addWidget(self.surface, 0, 0)
        self._column.setRowStretch(0, 1)
        for widget, side, inside in (
            (self.header, Qt.AlignmentFlag.AlignLeft, (self.title, self.note)),
            (self._tools, Qt.AlignmentFlag.AlignRight, (self._reset, self._enlarge, self._float)),
        ):
            bar = QHBoxLayout(widget)
            bar.setContentsMargins(8, 2, 2, 2)
            for part in inside:
                bar.addWidget(part)
            self._column.addWidget(widget, 0, 0, Qt.AlignmentFlag.AlignTop | side)  # on the picture

    def _button(self, icon: str, tip: str) -> QToolButton:
        button = QToolButton()
        show_icon(button, icon)
        button.setAutoRaise(True)
        button.setToolTip(tip)
        button.setAccessibleName(f"{self.accessibleName()}: {tip}")
        return button

    def open(self) -> None:
        """Let VTK draw from now on; it is imported for that, if it was not."""
        self.canvas.open()
        if self.isVisible():
            self._appear()

    def build(self, shown: Shown, view: Camera | None, *args: object) -> None:
        """Make the drawing anew, for another scene or style: now if visible, else on appearing.

        Parameters
        ----------
        shown : Shown
            What it shows first.
        view : Camera or None
            Where the pane's own camera is to stand; None for where everything is in view.
        *args
            Handed to `make_drawing` after the screen.
        """
        self._shown = shown
        self._to_build = self._built_with = args
        self._view = view
        if self.isVisible():
            self._refresh()

    def look_from(self, view: Camera | None) -> None:
        """Look at the drawing from elsewhere; None from where everything is in view.

        Like `build`, with the drawing that there is: of the same scene.
        """
        if view != self.view or view is None:
            self._view, self._view_is_stale = view, True
            if self.isVisible():
                self._refresh()

    def another(self, title: str) -> Pane:
        """A pane that draws the same in another place, off the screen, and lets nobody turn it."""
        return Pane(title, self._make_drawing, orbits=False, make_canvas=RasterCanvas)

    def draw_like(self, other: Pane, shown: Shown, *, at_rest: str = "") -> None:
        """Show something in the way in which another pane is drawn.

        Parameters
        ----------
        other : Pane
            One that has been built.
        shown : Shown
        at_rest : str
            How it smooths, drawn with all triangles; as the other one does just now if empty.
        """
        if other._built_with is not None and other._built_with is not self._built_with:
            self.build(shown, None, *other._built_with)
            self._built_with = other._built_with
        elif shown is not self._shown:
            self.take(shown, PROJECTION)
        self.show_layers(other._hidden)
        self.set_bare(other._is_bare)
        self.show_probes(tuple(probe for probe in other._probes if probe.number))
        self.set_smoothing(at_rest or other._smoothing)
        self.set_detail(None if at_rest else other._fewer)

    @property
    def shown(self) -> Shown | None:
        """What it shows, or will when it appears."""
        return self._shown

    @property
    def name(self) -> str:
        """What it is called, translated, whatever its title says that it shows now."""
        return self.accessibleName()

    @property
    def view(self) -> Camera | None:
        """Where the user moved the pane's own camera to; None if it was not moved."""
        if self._to_build is not None or self.drawing is None or self._view_is_stale:
            return self._view
        view: Camera | None = self.drawing.view
        return view

    @property
    def projection(self) -> Projection:
        """What it was told last."""
        assert self._shown is not None
        return self._shown.projection

    def take(self, shown: Shown, changed: Changed) -> None:
        """Show the model's new value, and what a phenomenon shows for it: now, or on appearing."""
        self._shown = shown
        self._stale = True
        if self.isVisible():
            self._refresh()

    def show_stage(self, position: float) -> None:
        """Show a `StagedDrawing` at a position of its strip: at once if visible, or on appearing.

        Parameters
        ----------
        position : float
        """
        self._stage, self._stage_is_stale = position, True
        if self.isVisible():
            self._refresh()

    def show_step(self, step: int | None) -> None:
        """Show a `SteppedDrawing` at a step, or as ever: at once if visible, or on appearing."""
        if step != self._step:
            self._step, self._step_is_stale = step, True
            if self.isVisible():
                self._refresh()

    def show_fixed(self, view: str) -> None:
        """Look from a fixed view of a `FixedDrawing`: at once if visible, or on appearing.

        Parameters
        ----------
        view : str
            One of `app.document.view.FIXED`; ``""`` for the free view.
        """
        if view != self._fixed:
            self._fixed, self._fixed_is_stale = view, True
            if self.isVisible():
                self._refresh()

    def show_object_axes(self, wanted: bool) -> None:
        """Show the object's axes of a `PlacedDrawing`: at once if visible, or on appearing."""
        if wanted != self._has_object_axes:
            self._has_object_axes, self._axes_are_stale = wanted, True
            if self.isVisible():
                self._refresh()

    def show_layers(self, hidden: frozenset[str]) -> None:
        """Switch these layers off, and no others: at once if visible, or on appearing.

        Parameters
        ----------
        hidden : frozenset of str
            Of `app.document.view.LAYERS`.
        """
        if hidden != self._hidden:
            self._hidden, self._layers_are_stale = hidden, True
            if self.isVisible():
                self._refresh()
            self.marked.emit()

    def set_bare(self, bare: bool) -> None:
        """Leave a picture's axes out, for its size's sake: at once if visible, or on appearing."""
        if bare != self._is_bare:
            self._is_bare, self._layers_are_stale = bare, True
            if self.isVisible():
                self._refresh()

    @property
    def _switched_off(self) -> frozenset[str]:
        return self._hidden | {AXES} if self._is_bare else self._hidden

    def show_probes(self, probes: Sequence[Probe]) -> None:
        """Mark these probes, and no others: at once if visible, else on appearing."""
        if probes != self._probes:
            self._probes = probes
            self._probes_stale = True
            if self.isVisible():
                self._refresh()
            self.marked.emit()

    @property
    def probes(self) -> Sequence[Probe]:
        """Those that are marked."""
        return self._probes

    def show_highlight(self, highlighted: Highlight) -> None:
        """Let what is highlighted stand out: at once if visible, else on appearing."""
        self._highlight = highlighted
        if not self.isVisible() or self._to_build is not None or self.drawing is None:
            self._highlight_is_stale = True
        elif self.drawing.show_highlight(highlighted):
            self.request_repaint()

    def _hovered(self, place: QPointF) -> None:
        if self.drawing is not None:
            self._point_at(self.drawing.highlight_at(place.x(), place.y()))

    def _left(self) -> None:
        self._point_at(NOTHING)

    def _point_at(self, highlighted: Highlight) -> None:
        if highlighted != self._pointed_at:
            self._pointed_at = highlighted
            self.highlighted.emit(highlighted)

    def _refresh(self) -> None:
        """Bring the drawing up to what was asked for while nobody looked."""
        shown = self._shown
        if shown is None or not self.canvas.is_open:
            return
        if self._to_build is not None:
            if self.drawing is not None:
                self.drawing.remove()
            self.drawing = self._make_drawing(self.canvas, *self._to_build)
            self._to_build = None
            self._step_is_stale = self._step is not None
            self._fixed_is_stale = bool(self._fixed)
            self._axes_are_stale = self._has_object_axes
            self._layers_are_stale = False
            if self._switched_off:
                self.drawing.show_layers(self._switched_off)
            self._highlight_is_stale = True
            self._apply_smoothing()
            self.drawing.show_projection(shown.projection, shown.illustration)
            self._take_stage(self.drawing)
            self._look_from(self.drawing)
            self.drawing.show_probes(self._probes)
            self._fewer, self._detail_is_stale = None, False
        elif self.drawing is not None:
            if self._detail_is_stale:
                self.drawing.show_detail(self._fewer)
            if self._layers_are_stale:
                self.drawing.show_layers(self._switched_off)
            if self._stale or self._detail_is_stale or self._layers_are_stale:
                began = time.perf_counter()
                self.drawing.show_projection(shown.projection, shown.illustration)
                self._matrices_ms = 1e3 * (time.perf_counter() - began)
            if self._view_is_stale:
                self._look_from(self.drawing)
            if self._probes_stale:
                self.drawing.show_probes(self._probes)
        if self._stage_is_stale and self.drawing is not None:
            self._take_stage(self.drawing)
        if self._step_is_stale and self.drawing is not None:
            cast(SteppedDrawing, self.drawing).show_step(self._step)
            self._step_is_stale = False
        if self._fixed_is_stale and self.drawing is not None:
            cast(FixedDrawing, self.drawing).show_fixed(self._fixed)
            self._fixed_is_stale = False
        if self._axes_are_stale and self.drawing is not None:
            cast(PlacedDrawing, self.drawing).show_object_axes(self._has_object_axes)
            self._axes_are_stale = False
        if self._highlight_is_stale and self.drawing is not None:
            self.drawing.show_highlight(self._highlight)
        self._stale = self._probes_stale = self._highlight_is_stale = False
        self._detail_is_stale = self._layers_are_stale = False
        self.request_repaint()

    def _look_from(self, drawing: Drawing) -> None:
        drawing.reset_view()
        if self._view is not None:
            drawing.show_view(self._view)
        self._view_is_stale = False

    def _take_stage(self, drawing: Drawing) -> None:
        if self._stage is not None:
            cast(StagedDrawing, drawing).show_stage(self._stage)
        self._stage_is_stale = False

    def add_below(self, widget: QWidget) -> None:
        """Put a widget under the canvas: it is hidden, enlarged and floated with the pane."""
        self._column.addWidget(widget, 1, 0)

    def add_to_header(self, widget: QWidget, narrow: QWidget) -> None:
        """Put a widget beside the title, and another one in its place where it has no room."""
        layout = self.header.layout()
        assert layout is not None
        layout.addWidget(widget)
        layout.addWidget(narrow)
        self._beside_title = widget, narrow

    def add_tool(self, button: QToolButton) -> None:
        """Put a button before those at the end of the title row."""
        cast(QHBoxLayout, self._tools.layout()).insertWidget(0, button)
        self._fit_header()

    @property
    def title_room(self) -> tuple[int, int]:
        """From where to where the title row is free, in pixels from the surface's left."""
        left = self.header.x() + self.header.width()
        return left, self.width() if self._tools.isHidden() else self._tools.x()

    def set_presenting(self, on: bool) -> None:
        """Show a class no buttons in the title, which the mouse and the keys can do without."""
        self._tools.setVisible(not on)
        self._fit_header()

    def set_title(self, title: str, note: str) -> None:
        """Name what the pane shows now; its own name, for screen readers, stays."""
        self.title.setText(title)
        self.note.setText(note)
        self._fit_header()

    def set_smoothing(self, smoothing: str) -> None:
        """Change antialiasing, to one of `SMOOTHINGS`; the next repaint shows it."""
        if smoothing != self._smoothing:
            self._smoothing = smoothing
            if self.drawing is not None:
                self._apply_smoothing()
                self.request_repaint()

    def set_timed(self, timed: bool) -> None:
        """Tell with every repaint what it cost, and wait for its end; or do not."""
        self.canvas.timed = timed
        if timed and self.canvas.is_open:
            self.request_repaint()

    def set_detail(self, fewer: Scene | None) -> None:
        """Draw the faces of a scene with fewer triangles, or None for all: now, or on appearing."""
        if fewer is not self._fewer:
            self._fewer, self._detail_is_stale = fewer, True
            if self.isVisible():
                self._refresh()

    @property
    def samples(self) -> int:
        """Of each pixel, by OpenGL's multisampling: fewer than asked for where it has no more."""
        if self.drawing is None:
            return multisamples(self._smoothing)
        return int(self.canvas.render_window.GetMultiSamples())

    def _apply_smoothing(self) -> None:
        window: Any = self.canvas.render_window
        for renderer in window.GetRenderers():
            renderer.SetUseFXAA(self._smoothing == "FXAA")
        window.SetMultiSamples(multisamples(self._smoothing))
        self.canvas.draw_finer(SCALES.get(self._smoothing, 1.0))

    def request_repaint(self) -> None:
        """Ask Qt for one repaint, however often it is asked before the next paint."""
        self.canvas.redraw()

    def reset_view(self) -> None:
        """Put the pane's own camera back; the model is not touched."""
        if self.drawing is not None:
            self.drawing.reset_view()
            self.request_repaint()

    def refit(self) -> None:
        """Bring back what an edit has carried out of a view that nobody moved."""
        if self.isVisible() and self.drawing is not None and self.drawing.refit():
            self.request_repaint()

    def move_to(self, window: QWidget | None, place: Callable[[], object]) -> None:
        """Get under another top-level window, of which the picture knows nothing yet.

        Parameters
        ----------
        window : QWidget or None
            New parent as a window of its own; None to be docked by `place`.
        place : callable
            Called while the pane is hidden: puts it where it shall be.
        """
        self.hide()
        if window is None:
            self.setWindowFlags(Qt.WindowType.Widget)  # `place` takes it for a docked one
        else:
            self.setParent(window, Qt.WindowType.Window)
        place()
        # Qt keeps the canvas' texture, which belongs to the old window, until the size changes.
        size = self.canvas.size()
        self.canvas.resize(size.width(), size.height() + 1)
        self.show()
        self.surface.fit()

    def close_canvas(self) -> None:
        """Release VTK's hold; before the window's own close, or it outlives its GL context."""
        self.drawing = None
        self.canvas.close()

    def _view_moved(self) -> None:
        if self.drawing is not None:
            self.drawing.reset_clipping_range()
            if self._fixed and not cast(FixedDrawing, self.drawing).fixed:
                self._fixed = ""
                self.fixed_left.emit()
        self.request_repaint()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_header()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._fit_header()

    def _fit_header(self) -> None:
        """Leave the note what the title and the buttons leave of the width."""
        tools_px = 0 if self._tools.isHidden() else self._tools.sizeHint().width()
        room = max(0, self.width() - tools_px)
        bar = self.header.layout()
        assert bar is not None
        margins = bar.contentsMargins()
        taken = margins.left() + self.title.sizeHint().width() + bar.spacing() + margins.right()
        if self._beside_title is not None:
            wide, narrow = self._beside_title
            fits = taken + bar.spacing() + wide.sizeHint().width() <= room
            wide.setVisible(fits)
            narrow.setVisible(not fits)
            taken += bar.spacing() + (wide if fits else narrow).sizeHint().width()
        self.header.setMaximumWidth(room)
        self.note.setMaximumWidth(max(0, room - taken))

    def moveEvent(self, event: QMoveEvent) -> None:
        super().moveEvent(event)
        self.surface.fit()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._appear()

    def _appear(self) -> None:
        try:
            self._refresh()
            self.refit()  # gestures may have ended while nobody looked
        except Exception:  # PySide6 loses it, or itself, where several panes are shown at once
            sys.excepthook(*sys.exc_info())

    def closeEvent(self, event: QCloseEvent) -> None:
        if self.isWindow():  # floating: its close button docks it again
            event.ignore()
            self.float_requested.emit()
        else:
            super().closeEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Home and self.canvas.hasFocus():
            self.reset_view()
        else:
            super().keyPressEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        place = event.position().toPoint()
        if any(bar.geometry().contains(place) for bar in (self.header, self._tools)):
            self.enlarge_requested.emit()
        else:
            self.double_clicked.emit()
            self.reset_view()
