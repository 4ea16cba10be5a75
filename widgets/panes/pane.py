"""A pane: a title, and a canvas that shows any drawing.

How a change reaches the screen, and why it is drawn once::

    take(shown, changed) --> drawing.show_projection(p)   sets matrices, draws nothing
                         --> canvas.redraw()              coalesced by Qt
    mouse on the canvas -> vtkCamera of this pane only -> canvas.redraw()
"""

import sys
import time
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from typing import Any

from PySide6.QtCore import QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QKeyEvent, QMouseEvent, QMoveEvent, QShowEvent, QTransform
from PySide6.QtWidgets import QFrame, QGridLayout, QWidget

from app.document.naming import named_in
from app.drawings import AXES
from app.drawings.drawing import Drawing
from app.lecture.highlight import NOTHING, Highlight
from app.model.projection import Camera
from app.picking.picking import Probe
from widgets.panes.canvas import REST_MS, AnyCanvas, CanvasHolder, Hand, release_context
from widgets.panes.header import Header
from widgets.panes.resting import Resting, RestingDrawings
from widgets.parts.clock import Clock
from widgets.parts.layouts import tool_button
from widgets.parts.panel import PROJECTION, Changed, ShownData
from widgets.parts.plain import PlainLabel

AS_BUILT: dict[str, Any] = {
    "smoothing": "none",
    "detail": None,
    "layers": frozenset(),
    "bare": False,
    "names": None,
    "projection": None,
    "stage": None,
    "from_left": False,
    "former": None,
    "probes": (),
    "view": None,
    "step": None,
    "fixed": "",
    "object_axes": False,
    "walk": (),
    "handles": frozenset(),
    "grips": None,
    "highlight": NOTHING,
}
"""The requests that a pane takes, with their first values, in the order of the calls."""
_SHOW: dict[str, Callable[[Drawing, Any], object]] = {
    "detail": lambda drawing, fewer: drawing.show_detail(fewer),
    "stage": lambda drawing, position: drawing.show_stage(max(position or 0.0, 0.0)),
    **dict.fromkeys(("from_left", "former"), lambda drawing, wanted: None),
    "probes": lambda drawing, probes: drawing.show_probes(probes),
    "step": lambda drawing, step: drawing.show_step(step),
    "fixed": lambda drawing, view: drawing.show_fixed(view),
    "object_axes": lambda drawing, wanted: drawing.show_object_axes(wanted),
    "walk": lambda drawing, eyes: drawing.show_walk(eyes),
    "handles": lambda drawing, names: drawing.handles.call(names),
    "grips": lambda drawing, paths: drawing.handles.rest(paths),
    "highlight": lambda drawing, highlighted: drawing.show_highlight(highlighted),
}
"""How a drawing shows the requests that take one call."""


class Pane(QFrame):
    """A titled canvas with one drawing; the mouse moves the pane's own camera if it `orbits`.

    A hidden pane neither computes nor draws; it shows the current value when it appears.
    ``make_drawing(screen, *args)`` builds the drawing, with the arguments of `build`.
    """

    concerns = PROJECTION | {"illustration"}
    fixed_left = Signal()  # the user turned the fixed view, which became the free view
    enlarge_requested = Signal()
    clicked = Signal(QPointF)  # a place in the canvas, in device pixels from its top left
    aimed = Signal(QPointF)  # likewise, while `is_aimed_at`, instead of `clicked`
    double_clicked = Signal()  # the canvas was double-clicked: the click before does not count
    float_requested = Signal()  # the pane shall get, or leave, a window of its own
    highlighted = Signal(object)  # the `Highlight` of what is under the mouse; only when it changes
    timed = Signal(float, float)
    """The ms of the last step's matrices and of a repaint; only after `set_timed`."""
    turned = Signal()  # the pane's own view was moved by hand, or put back
    marked = Signal()  # the pane shows other layers or probes

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
        self.make_drawing = make_drawing
        self.drawing: Drawing | None = None
        self.shown: ShownData | None = None  # what the pane shows, or will show when it appears
        self._to_build: tuple[object, ...] | None = None
        self.built_with: tuple[object, ...] | None = None  # the last arguments of `build`
        self.drawn_with: tuple[object, ...] | None = None  # those of `drawing`
        self._waits = self._appears = False
        self.requested = dict(AS_BUILT)  # the values of `request`
        self._due: set[str] = set()  # what the drawing has yet to show
        self._pointed_at = NOTHING
        self._matrices_ms = 0.0
        self._goes_to: tuple[Camera | None] | None = None
        """The own camera at the end of the way that the pane is on."""

        acts: dict[str, tuple[str, object]] = {
            "home": (self.tr("Reset this pane's own view (double-click)"), self.reset_view),
            "enlarge": (
                self.tr("Enlarge; click again for the whole window"),
                self.enlarge_requested,
            ),
            "float": (self.tr("Move to a window of its own, and back"), self.float_requested),
        }
        if not orbits:
            del acts["home"]
        tools = [
            tool_button("", tip, act, icon=icon, name=f"{title}: {tip}", flat=True)
            for icon, (tip, act) in acts.items()
        ]
        self.header = Header(self, title, tools)
        self.title, self.note = self.header.title, self.header.note
        self.canvas = make_canvas(self)
        self._orbits = orbits
        self.rest_pointer()
        self.header.setCursor(Qt.CursorShape.ArrowCursor)
        self.header.tools.setCursor(Qt.CursorShape.ArrowCursor)
        self.resting = RestingDrawings(self.canvas, make_drawing, AS_BUILT)
        self.canvas.setAccessibleName(title)
        self.is_aimed_at = False  # whether a question asks for a place in the picture
        self.hand = Hand(self.canvas, orbits=orbits)
        # A class keeps its flat view: a turn would be a slip of the hand.
        self.hand.may_turn = lambda: self.hand.has_tooltip or not self.requested["fixed"]
        self.hand.names = lambda: named_on(self.canvas, self)[0]
        self.hand.moved.connect(self._view_moved)
        self.hand.clicked.connect(
            lambda place: (self.aimed if self.is_aimed_at else self.clicked).emit(place)
        )
        self.hand.hovered.connect(self._point_at)
        self.hand.left.connect(self._point_at)
        self.fades: Callable[[], bool] = lambda: False
        """Whether labels fade from one place to another; otherwise they jump."""
        self._clock = Clock(self, self._pass_time)
        self._rest = QTimer(self, singleShot=True)
        self._rest.timeout.connect(self._refine)
        self._applied = dict(AS_BUILT)  # of `requested`, what the drawing shows
        self._in_first: ShownData | None = None  # what it shows, and nothing else happened to it
        self._releasing = QTimer(self, singleShot=True, interval=500)
        self._releasing.timeout.connect(self.resting.release)
        self._has_changed = True
        self.canvas.drawn.connect(self._plan_refining)
        self.canvas.painted.connect(lambda ms: self.timed.emit(self._matrices_ms, ms))
        self.surface = CanvasHolder(self.canvas)
        self._column = QGridLayout(self)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(0)
        self._column.addWidget(self.surface, 0, 0)
        self._column.setRowStretch(0, 1)
        sides = Qt.AlignmentFlag
        for bar, side in ((self.header, sides.AlignLeft), (self.header.tools, sides.AlignRight)):
            self._column.addWidget(bar, 0, 0, sides.AlignTop | side)  # on the picture
        self._cover = PlainLabel(
            wordWrap=True, alignment=sides.AlignCenter, autoFillBackground=True, visible=False
        )
        self._column.addWidget(self._cover, 0, 0)
        self._cover.stackUnder(self.header)

    def open(self) -> None:
        """Import VTK if necessary, and let it draw from now on."""
        self.canvas.open()
        if self.isVisible():
            self._appear()

    def build(
        self, shown: ShownData, view: Camera | None, *args: object, anew: bool = True
    ) -> None:
        """Make another drawing, for another scene or style; a hidden pane does it on appearing.

        `view` is the pane's own camera; None places it so that everything is in view. If not
        `anew`, a drawing that was made with the same arguments stays.
        """
        self.shown, self.built_with = shown, args
        if anew and args == self.drawn_with:
            self.drawn_with = None  # other words: the drawing of now is not shown again
        self._to_build = args if args != self.drawn_with else None
        self._due |= {"projection", "view"}
        self.requested["view"] = view
        self._refresh()

    def set_waiting(self, waits: bool) -> None:
        """Collect several changes, and show them together when the pane no longer waits."""
        if waits != self._waits:
            self._waits = waits
            if not waits:
                self._appear() if self._appears else self._refresh()

    def look_from(self, view: Camera | None) -> None:
        """Move the pane's own camera as `build` does, without another drawing."""
        self.glide(1.0)
        if view != self.view or view is None:
            self.requested["view"] = view
            self._due.add("view")
            self._refresh()

    @property
    def view(self) -> Camera | None:
        """The pane's own camera if the user has moved it, else None."""
        if self._goes_to is not None:
            return self._goes_to[0]
        asked: Camera | None = self.requested["view"]
        if self._to_build is not None or self.drawing is None or "view" in self._due:
            return asked
        return self.drawing.view

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Show the model's new value; a hidden pane does it on appearing."""
        self.shown = shown
        self._due.add("projection")
        self._refresh()

    # -- the rest of what a drawing can show

    def request(self, what: str, wanted: Any) -> bool:
        """Show one of `AS_BUILT`, now or on appearing; return whether it is new.

        ``"smoothing"``: one of `SMOOTHINGS`. ``"detail"``: a scene with fewer triangles, or None.
        ``"layers"``: those of `app.document.view.LAYERS` that are hidden. ``"bare"``: whether the
        axes are hidden, which would make a picture smaller. ``"names"``: the names of a view, or
        None for the scene's own. ``"probes"``: those that are marked. ``"stage"``: a position on
        the stage strip. ``"from_left"``: whether the object's moves are done from the left.
        ``"former"``: the object's moves before the last edit, shown pale, or None.
        ``"step"``: a step of the camera's frame, or None. ``"fixed"``: one of
        `app.document.view.FIXED`, or ``""``. ``"object_axes"``: whether they are always visible.
        ``"walk"``: places of the eye, through which its way is drawn.
        ``"handles"``: the names or settings of handles that are shown though nothing is on them.
        ``"grips"``: the values whose grips are shown at rest, or None for the scene's controls.
        """
        if wanted == self.requested[what]:
            return False
        before, self.requested[what] = self.requested[what], wanted
        self._due.add(what)
        if what in ("from_left", "former") or (
            what == "stage" and min(before or 0.0, wanted or 0.0) < 0.0
        ):
            self._due.add("projection")
        self._refresh()
        if what in ("layers", "probes"):
            self.marked.emit()
        return True

    @property
    def probes(self) -> Sequence[Probe]:
        marked: Sequence[Probe] = self.requested["probes"]
        return marked

    def show_highlight(self, highlighted: Highlight) -> None:
        self.requested["highlight"] = highlighted
        is_old = self._waits or self._to_build is not None
        if not self.isVisible() or is_old or self.drawing is None:
            self._due.add("highlight")
            return
        self._applied["highlight"] = highlighted
        if self.drawing.show_highlight(highlighted):
            self.canvas.redraw()

    def _point_at(self, place: QPointF | None = None) -> None:
        highlighted = NOTHING
        if place is not None and self.drawing is not None:
            taken = self.drawing.handles.at((place.x(), place.y()))
            highlighted = NOTHING if taken is None else taken.about
        if highlighted != self._pointed_at:
            self._pointed_at = highlighted
            self.highlighted.emit(highlighted)

    def _refresh(self) -> None:
        """Bring a visible drawing up to date."""
        shown = self.shown
        if not self.isVisible() or shown is None or not self.canvas.is_open or self._waits:
            return
        args = self._to_build
        if args is not None:
            self._build(shown, args)
        if "bare" in self._due:
            self._due = self._due - {"bare"} | {"layers"}
        if self._due & {"detail", "layers"}:
            self._due.add("projection")  # sets the matrices of the faces that are now shown
        if (drawing := self.drawing) is None:
            return
        with drawing.layers.placing_once() if len(self._due) > 1 else nullcontext():
            for what, wanted in self.requested.items():
                if what not in self._due:
                    continue
                if what == "projection":
                    began = time.perf_counter()
                    if drawing.refines:  # a pair of pictures is drawn at once
                        release_context()
                    stage, left = self.requested["stage"] or 0.0, self.requested["from_left"]
                    drawing.former = self.requested["former"]
                    drawing.show_moves(shown.projection, shown.illustration, stage, from_left=left)
                    self._matrices_ms = 1e3 * (time.perf_counter() - began)
                elif what == "smoothing":
                    self.canvas.smooth(wanted)
                elif what == "layers":
                    drawing.show_layers(wanted | {AXES} if self.requested["bare"] else wanted)
                elif what == "names":
                    drawing.show_names(named_in(drawing.pane, shown.scene, wanted))
                elif what == "view":
                    drawing.reset_view()
                    if wanted is not None:
                        drawing.show_view(wanted)
                else:
                    _SHOW[what](drawing, wanted)
        self._applied = dict(self.requested)
        if args is not None:  # none that has failed rests
            self.drawn_with, self._in_first = args, shown
        elif self._due & {"projection", "view"}:
            self._in_first = None
        self._due.clear()
        self._has_changed = True
        self._watch_labels()
        self.canvas.redraw()

    def _watch_labels(self) -> None:
        """Let time pass for labels that have to leave their places."""
        if self.drawing is not None and self.drawing.board.is_restless and not self._clock.running:
            self._clock.start()

    def _pass_time(self, seconds: float) -> None:
        board = self.drawing.board if self.drawing is not None else None
        if board is None or not board.is_restless:
            self._clock.stop()
            return
        if board.pass_time(seconds, is_soft=self.fades()):
            self.canvas.redraw()

    def _build(self, shown: ShownData, args: tuple[object, ...]) -> None:
        self.glide(1.0)
        taken = self.resting.take(args)
        if self.drawing is not None:
            self.resting.put(Resting(self.drawn_with, self.drawing, self._applied, self._in_first))
            self._releasing.start()
        self.drawing = self.drawn_with = None
        if taken is None:
            with self.canvas.new_page():
                self.drawing = self.make_drawing(self.canvas, *args)
            taken = Resting(args, self.drawing, AS_BUILT, None)
        self.drawing = taken.drawing
        self.drawing.board.is_patient = True
        self._to_build = self._goes_to = None
        self.requested["detail"] = None
        self._due = {what for what, now in self.requested.items() if now != taken.applied[what]}
        is_same = taken.shown is not None and taken.shown.document == shown.document
        if not is_same or self._due & {"stage", "from_left", "former"}:
            self._due |= {"projection", "view"}
        self._due.add("smoothing")

    def rest_pointer(self) -> None:
        """Show the pointer of turning the view, where a drag does nothing else."""
        if self._orbits:
            self.setCursor(Qt.CursorShape.OpenHandCursor)
        else:
            self.unsetCursor()

    def set_presenting(self, on: bool, *, named: bool = True) -> None:
        """Show a class the picture without buttons, frame and tooltips; `named`: with its title."""
        self.header.set_presenting(on, named=named)
        shape = QFrame.Shape.NoFrame if on else QFrame.Shape.StyledPanel
        if self.frameShape() != shape:
            self.setFrameShape(shape)
        self.hand.has_tooltip = not on

    def cover(self, why: str) -> None:
        """Cover the picture with a reason; without one, show it again."""
        self._cover.setText(why)
        self._cover.setVisible(bool(why))
        self.header.tools.setEnabled(not why)

    def add_below(self, widget: QWidget) -> None:
        """Put a widget under the canvas: it is hidden, enlarged and floated with the pane."""
        self._column.addWidget(widget, 1, 0)

    # -- painting

    def _plan_refining(self) -> None:
        """Refine a picture that was drawn coarsely: soon after a change, at once after a step."""
        drawing = self.drawing
        if drawing is not None and drawing.refines and drawing.is_coarse:
            self._rest.start(REST_MS if self._has_changed else 0)

    def _refine(self) -> None:
        if self.drawing is not None and self.isVisible():
            self._has_changed = False
            release_context()
            self.drawing.refine()
            self.canvas.redraw()

    # -- the pane's own camera

    def reset_view(self) -> None:
        """Put the pane's own camera back; the model is not touched."""
        if self.drawing is not None:
            self.drawing.reset_view()
            self.canvas.redraw()
            self.turned.emit()

    # -- on the way from one state to another

    @property
    def pose(self) -> Any:
        """Where the visible pane's camera stands, for `begin_glide`; None if there is nothing."""
        is_there = self.isVisible() and self.drawing is not None and self._to_build is None
        own = self.drawing.own if is_there and self.drawing is not None else None
        return None if own is None else own.pose

    def begin_glide(self, start: Any) -> None:
        """Begin a way from another pose to the present one; None for the present one."""
        drawing = self.drawing
        if self.isVisible() and drawing is not None and self._to_build is None:
            view, now = self.view, self.pose
            if now is not None:
                drawing.begin_glide(now if start is None else start)
            self._goes_to = (view,)

    def glide(self, part: float) -> None:
        """Show a part of the way, 0 to 1."""
        if self._goes_to is not None and self.drawing is not None:
            if part == 1.0:
                self._goes_to = None
            self.drawing.glide(part)
            self.canvas.redraw()

    def refit(self) -> None:
        """Frame again what an edit has carried out of a view that the user has not moved."""
        if self.drawing is not None and self._goes_to is None and self.isVisible():
            if self.drawing.refit():
                self.canvas.redraw()
            self._watch_labels()

    def _view_moved(self) -> None:
        self._in_first = None
        self.glide(1.0)  # the user's hand decides
        if self.drawing is not None:
            self.drawing.reset_clipping_range(afresh=not self.hand.is_down)
            if self.requested["fixed"] and not self.drawing.fixed:
                self.requested["fixed"] = ""
                self.fixed_left.emit()
        self._watch_labels()
        self.canvas.redraw()
        self.turned.emit()

    # -- in the window

    def move_to(self, window: QWidget | None, place: Callable[[], object]) -> None:
        """Move under another top-level window, the parent of the pane's own, or None to be docked.

        `place` is called while the pane is hidden, and puts it in its place.
        """
        self.hide()
        if window is None:
            self.setWindowFlags(Qt.WindowType.Widget)  # `place` expects a docked pane
        else:
            self.setParent(window, Qt.WindowType.Window)
        place()
        # Qt keeps the canvas' texture, which belongs to the old window, until the size changes.
        size = self.canvas.size()
        self.canvas.resize(size.width(), size.height() + 1)
        self.show()
        self.surface.fit()

    def close_canvas(self) -> None:
        """Release VTK's objects; call it before the window closes, and its GL context with it."""
        self.resting.clear()
        self.drawing = None
        self.canvas.close()

    def moveEvent(self, event: QMoveEvent) -> None:
        super().moveEvent(event)
        self.surface.fit()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._appear()

    def _appear(self) -> None:
        self._appears = self._waits
        if self._waits:
            return
        try:
            self._refresh()
            self.refit()  # a gesture may have ended while the pane was hidden
        except Exception:  # PySide6 loses it, or itself, where several panes are shown at once
            sys.excepthook(*sys.exc_info())

    def closeEvent(self, event: QCloseEvent) -> None:
        if self.isWindow():  # the close button of a floating pane docks it again
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
        if any(bar.geometry().contains(place) for bar in (self.header, self.header.tools)):
            self.enlarge_requested.emit()
        elif not self.is_aimed_at:
            self.double_clicked.emit()
            self.reset_view()


def named_on(widget: QWidget, pane: Pane) -> tuple[list[QRectF], QTransform]:
    """Where a pane's names and their points are on a widget that holds it; from their pixels."""
    canvas, drawing = pane.canvas, pane.drawing
    if drawing is None:
        return [], QTransform()
    right, up = drawing.board.renderer.GetOrigin()  # an image's names are counted from its frame
    corner = canvas.mapTo(widget, QPointF(0.0, canvas.height()))
    ratio = canvas.pixel_ratio
    from_pixels = QTransform(1 / ratio, 0, 0, -1 / ratio, corner.x(), corner.y())
    from_pixels.translate(right, up)
    ends = ((QPointF(*box[:2]), QPointF(*box[2:])) for box in drawing.board.boxes)
    return [from_pixels.mapRect(QRectF(*each)) for each in ends], from_pixels
