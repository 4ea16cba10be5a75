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
from functools import partial
from typing import Any, NamedTuple

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
from PySide6.QtWidgets import QFrame, QGridLayout, QToolButton, QWidget

from app.drawings import AXES
from app.drawings.drawing import Drawing
from app.lecture.highlight import NOTHING, Highlight
from app.model.projection import Camera, Projection
from app.picking.picking import Probe
from app.scenes.scene import Scene
from widgets.panes.canvas import AnyCanvas, Hand, RasterCanvas
from widgets.parts.buttons import tool_button
from widgets.parts.layouts import in_column, in_row
from widgets.parts.note import Title
from widgets.parts.panel import PROJECTION, Changed, Shown
from widgets.parts.plain import set_tip

SCALES = {"half resolution": 0.5, "supersampling 2 x 2": 2.0}
"""Pixels that are drawn for one that is shown, along each side, where that is not one."""
SMOOTHINGS = ("none", "FXAA", "MSAA 2", "MSAA 4", "MSAA 8", *SCALES)
"""What a pane can do: of larger pictures Qt takes four pixels at the most for one."""


def multisamples(smoothing: str) -> int:
    """The samples a pixel that one of `SMOOTHINGS` asks OpenGL for."""
    kind, _, samples = smoothing.partition(" ")
    return int(samples) if kind == "MSAA" else 0


AS_BUILT: dict[str, Any] = {
    "detail": None,
    "layers": frozenset(),
    "projection": None,
    "stage": None,
    "view": None,
    "probes": (),
    "step": None,
    "fixed": "",
    "object_axes": False,
    "highlight": NOTHING,
}
"""What a drawing can be asked to show, and what a new drawing shows, in the order of the calls."""
_SHOW: dict[str, Callable[[Drawing, Any], object]] = {
    "detail": lambda drawing, fewer: drawing.show_detail(fewer),
    "layers": lambda drawing, hidden: drawing.show_layers(hidden),
    "stage": lambda drawing, position: drawing.show_stage(position),
    "probes": lambda drawing, probes: drawing.show_probes(probes),
    "step": lambda drawing, step: drawing.show_step(step),
    "fixed": lambda drawing, view: drawing.show_fixed(view),
    "object_axes": lambda drawing, wanted: drawing.show_object_axes(wanted),
    "highlight": lambda drawing, highlighted: drawing.show_highlight(highlighted),
}
"""How a drawing is told; ``projection`` and ``view`` take more than one call."""


class _Ahead(NamedTuple):
    """A drawing that is made and has been drawn once, of what may be shown next.

    Attributes
    ----------
    args : tuple
        What `Pane.build` is given for it.
    shown : Shown
    screen : OffScreen
        That it is in.
    drawing : Drawing
    """

    args: tuple[object, ...]
    shown: Shown
    screen: Any
    drawing: Drawing


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
        self._margins = in_column(canvas, on=self, margins=(0, 0, 0, 0))
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
        self.drawing: Drawing | None = None
        """What is drawn, once there is something."""
        self._make_drawing = make_drawing
        self._shown: Shown | None = None
        self._to_build: tuple[object, ...] | None = None
        self._built_with: tuple[object, ...] | None = None
        self._ahead: list[_Ahead] = []
        self._replaced: list[tuple[Any, Drawing | None]] = []
        """Screens and drawings that others have taken the place of: to let go takes a while."""
        self._waits = False
        self._asked = dict(AS_BUILT)
        self._due: set[str] = set()
        """Of what is asked for, what the drawing has yet to show."""
        self._hidden: frozenset[str] = frozenset()
        self._is_bare = False
        self._pointed_at = NOTHING
        self._smoothing = "none"
        self._matrices_ms = 0.0
        self._beside_title: tuple[QWidget, QWidget] | None = None

        self.title = Title(title)
        self.note = Title("", "paneNote")
        acts: dict[str, tuple[str, object]] = {
            "home": (self.tr("Reset this pane's own view (double-click)"), self.reset_view),
            "enlarge": (self.tr("Enlarge; again, to the whole window"), self.enlarge_requested),
            "float": (self.tr("Into a window of its own, and back"), self.float_requested),
        }
        if not orbits:
            del acts["home"]
        tools = [
            tool_button("", tip, act, icon=icon, name=f"{title}: {tip}", flat=True)
            for icon, (tip, act) in acts.items()
        ]
        self.header = QWidget()
        set_tip(
            self.header,
            self.tr(
                "Double-click to make this pane large; again, as large as the window, and back"
            ),
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
        self.hand.left.connect(partial(self._point_at, NOTHING))
        self.canvas.painted.connect(lambda ms: self.timed.emit(self._matrices_ms, ms))
        if orbits:
            tip = self.tr(
                "Click to follow a point; drag to turn, Shift-drag to move, wheel to zoom, "
                "double-click to reset; or Tab to here, and arrows, + −, Home"
            )
            keys = self.tr("Arrow keys turn, Shift and an arrow moves, + and − zoom, Home resets.")
        else:
            tip = self.tr(
                "Click to follow a point; drag to move the camera in its plane, wheel to go "
                "nearer to the target; or Tab to here, and arrows, + −"
            )
            keys = self.tr("Arrow keys move the camera in its plane, + and − go nearer and back.")
        set_tip(self.canvas, tip)
        cursor_keys = self.tr(
            "Page Down and Page Up go from vertex to vertex, with Shift from handle to handle or "
            "probe to probe; Space follows a vertex; Enter takes hold and lets go, Shift and Enter "
            "as a drag with Shift; arrows drag by a pixel, with Shift by ten; Escape puts back."
        )
        self.canvas.setAccessibleDescription(f"{keys} {cursor_keys}")
        self.surface = Surface(self.canvas)
        self._column.addWidget(self.surface, 0, 0)
        self._column.setRowStretch(0, 1)
        self._title_bar = in_row(self.title, self.note, on=self.header, margins=(8, 2, 2, 2))
        self._tool_bar = in_row(*tools, on=self._tools, margins=(8, 2, 2, 2))
        sides = Qt.AlignmentFlag
        for bar, side in ((self.header, sides.AlignLeft), (self._tools, sides.AlignRight)):
            self._column.addWidget(bar, 0, 0, sides.AlignTop | side)  # on the picture

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
        self._asked["view"] = view
        self._refresh()

    def set_waiting(self, waits: bool) -> None:
        """Be brought up to date no more, as several changes come together; or again, and now."""
        if waits != self._waits:
            self._waits = waits
            if not waits:
                self._refresh()

    def draw_ahead(self, shown: Shown, *args: object) -> None:
        """Make what a `build` with the same arguments will show: not where Qt has VTK's window."""
        canvas = self.canvas
        if not isinstance(canvas, RasterCanvas) or not canvas.is_open or not self.isVisible():
            return
        if not any(ahead.args == args for ahead in self._ahead):
            screen = canvas.screen_ahead()
            drawing = self._make_drawing(screen, *args)
            drawing.show_projection(shown.projection, shown.illustration)
            drawing.reset_view()
            self._smooth(screen.render_window)
            screen.render_window.Render()  # its shaders are compiled by that
            self._ahead.append(_Ahead(args, shown, screen, drawing))

    def keep_ahead(self, *wanted: tuple[object, ...]) -> None:
        """Forget what was made ahead with other arguments than these, and what was left."""
        old = [ahead for ahead in self._ahead if ahead.args not in wanted]
        self._ahead = [ahead for ahead in self._ahead if ahead.args in wanted]
        for screen, _ in (*self._replaced, *((ahead.screen, ahead.drawing) for ahead in old)):
            screen.close()
        self._replaced.clear()

    def _take_ahead(self, args: tuple[object, ...]) -> Shown | None:
        """Take the drawing that was made ahead, if there is one, and tell what it shows."""
        for ahead in self._ahead:
            if ahead.args == args and isinstance(self.canvas, RasterCanvas):
                self._ahead.remove(ahead)
                self._replaced.append((self.canvas.show_screen(ahead.screen), self.drawing))
                self.drawing = ahead.drawing
                return ahead.shown
        return None

    def look_from(self, view: Camera | None) -> None:
        """Look at the drawing from elsewhere; None from where everything is in view.

        Like `build`, with the drawing that there is: of the same scene.
        """
        if view != self.view or view is None:
            self._asked["view"] = view
            self._due.add("view")
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
        self.show_probes(tuple(probe for probe in other.probes if probe.number))
        self.set_smoothing(at_rest or other._smoothing)
        self.set_detail(None if at_rest else other._asked["detail"])

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
        asked: Camera | None = self._asked["view"]
        if self._to_build is not None or self.drawing is None or "view" in self._due:
            return asked
        return self.drawing.view

    @property
    def projection(self) -> Projection:
        """What it was told last."""
        assert self._shown is not None
        return self._shown.projection

    def take(self, shown: Shown, changed: Changed) -> None:
        """Show the model's new value, and what a phenomenon shows for it: now, or on appearing."""
        self._shown = shown
        self._due.add("projection")
        self._refresh()

    # -- what is asked for: it is shown at once if the pane is visible, else when it appears

    def _ask(self, what: str, wanted: object) -> bool:
        """Ask for one of `AS_BUILT`; whether it is another one than before."""
        if wanted == self._asked[what]:
            return False
        self._asked[what] = wanted
        self._due.add(what)
        self._refresh()
        return True

    def show_stage(self, position: float) -> None:
        """Show a position of the stage strip."""
        self._ask("stage", position)

    def show_step(self, step: int | None) -> None:
        """Build the camera's frame up to a step, or show what is always shown."""
        self._ask("step", step)

    def show_fixed(self, view: str) -> None:
        """Look from one of `app.document.view.FIXED`, or freely for ``""``."""
        self._ask("fixed", view)

    def show_object_axes(self, wanted: bool) -> None:
        """Show the object's axes also where they are the world's."""
        self._ask("object_axes", wanted)

    def show_layers(self, hidden: frozenset[str]) -> None:
        """Switch off these of `app.document.view.LAYERS`, and no others."""
        if hidden != self._hidden:
            self._hidden = hidden
            self._show_layers()
            self.marked.emit()

    def set_bare(self, bare: bool) -> None:
        """Leave a picture's axes out, for its size's sake."""
        self._is_bare = bare
        self._show_layers()

    def _show_layers(self) -> None:
        self._ask("layers", self._hidden | {AXES} if self._is_bare else self._hidden)

    def show_probes(self, probes: Sequence[Probe]) -> None:
        """Mark these probes, and no others."""
        if self._ask("probes", probes):
            self.marked.emit()

    @property
    def probes(self) -> Sequence[Probe]:
        """Those that are marked."""
        marked: Sequence[Probe] = self._asked["probes"]
        return marked

    def set_detail(self, fewer: Scene | None) -> None:
        """Draw the faces of a scene with fewer triangles, or None for all."""
        self._ask("detail", fewer)

    def show_highlight(self, highlighted: Highlight) -> None:
        """Let what is highlighted stand out."""
        self._asked["highlight"] = highlighted
        if not self.isVisible() or self._to_build is not None or self.drawing is None:
            self._due.add("highlight")
        elif self.drawing.show_highlight(highlighted):
            self.request_repaint()

    def _hovered(self, place: QPointF) -> None:
        if self.drawing is not None:
            self._point_at(self.drawing.highlight_at(place.x(), place.y()))

    def _point_at(self, highlighted: Highlight) -> None:
        if highlighted != self._pointed_at:
            self._pointed_at = highlighted
            self.highlighted.emit(highlighted)

    def _refresh(self) -> None:
        """Bring the drawing, if it is seen, up to what was asked for."""
        shown = self._shown
        if not self.isVisible() or shown is None or not self.canvas.is_open or self._waits:
            return
        if self._to_build is not None:
            ahead = self._take_ahead(self._to_build)
            if ahead is None:
                if self.drawing is not None:
                    self.drawing.remove()
                self.drawing = None
                with self.canvas.or_empty():
                    self.drawing = self._make_drawing(self.canvas, *self._to_build)
            self._to_build = None
            self._asked["detail"] = None
            others = {what for what, wanted in self._asked.items() if wanted != AS_BUILT[what]}
            self._due = others
            if ahead is None or ahead.document != shown.document:
                self._due |= {"projection", "view"}
            elif "stage" in others:  # on which the view depends
                self._due.add("view")
            self._apply_smoothing()
        if self._due & {"detail", "layers"}:
            self._due.add("projection")  # these only tell how it is shown
        drawing = self.drawing
        for what, wanted in self._asked.items():
            if drawing is None or what not in self._due:
                continue
            if what == "projection":
                began = time.perf_counter()
                drawing.show_projection(shown.projection, shown.illustration)
                self._matrices_ms = 1e3 * (time.perf_counter() - began)
            elif what == "view":
                drawing.reset_view()
                if wanted is not None:
                    drawing.show_view(wanted)
            else:
                _SHOW[what](drawing, wanted)
        self._due.clear()
        self.request_repaint()

    def add_below(self, widget: QWidget) -> None:
        """Put a widget under the canvas: it is hidden, enlarged and floated with the pane."""
        self._column.addWidget(widget, 1, 0)

    def add_to_header(self, widget: QWidget, narrow: QWidget) -> None:
        """Put a widget beside the title, and another one in its place where it has no room."""
        self._title_bar.addWidget(widget)
        self._title_bar.addWidget(narrow)
        self._beside_title = widget, narrow

    def add_tool(self, button: QToolButton) -> None:
        """Put a button before those at the end of the title row."""
        self._tool_bar.insertWidget(0, button)
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

    @property
    def samples(self) -> int:
        """Of each pixel, by OpenGL's multisampling: fewer than asked for where it has no more."""
        if self.drawing is None:
            return multisamples(self._smoothing)
        return int(self.canvas.render_window.GetMultiSamples())

    def _apply_smoothing(self) -> None:
        self._smooth(self.canvas.render_window)
        self.canvas.draw_finer(SCALES.get(self._smoothing, 1.0))

    def _smooth(self, window: Any) -> None:
        for renderer in window.GetRenderers():
            renderer.SetUseFXAA(self._smoothing == "FXAA")
        window.SetMultiSamples(multisamples(self._smoothing))

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
        self.keep_ahead()
        self.canvas.close()

    def _view_moved(self) -> None:
        if self.drawing is not None:
            self.drawing.reset_clipping_range()
            if self._asked["fixed"] and not self.drawing.fixed:
                self._asked["fixed"] = ""
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
        """Leave the note what the title and the buttons leave of the width, all in one line."""
        self.header.setMinimumHeight(self._tools.sizeHint().height())
        tools_px = 0 if self._tools.isHidden() else self._tools.sizeHint().width()
        room = max(0, self.width() - tools_px)
        bar = self._title_bar
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
