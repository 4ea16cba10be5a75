"""Set probes with the mouse: a click in a pane follows a point, a drag in the image moves it.

In a scene whose setting is a point to be `clicked`, a click in the image moves that point instead.

The lecturer's pointer is a probe without a number, which follows the mouse.
"""

import math
from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QCursor, QPainter, QPalette, QPen, QPixmap
from PySide6.QtWidgets import QWidget

from app.model.parameter import Value
from app.picking.picking import Probe, dragged
from widgets.panels.probe_panel import ProbePanel
from widgets.panes.manipulation import HOLD_WITHIN_PX, Manipulation
from widgets.panes.pane import Pane
from widgets.parts.gestures import EscapeKey
from widgets.parts.panel import Changed, Panel, ShownData

RING_SHARE = 0.035  # diameter of the lecturer's mouse pointer, a ring, in heights of the screen


class Probing(QObject):
    """Turns clicks in the panes and drags in the image into probes.

    The panel holds the probes; `manipulation` takes over a drag in the image that does not start
    on a probe; `shown` returns the current snapshot.
    """

    concerns = frozenset({"scene"})
    refused = Signal(str)  # why a click in the image chose no point

    def __init__(
        self,
        panes: Mapping[str, Pane],
        panel: ProbePanel,
        manipulation: Manipulation,
        shown: Callable[[], ShownData],
        window: QWidget,
    ) -> None:
        super().__init__(window)
        self._window, self._shown = window, shown
        self._panes, self._panel, self._manipulation = panes, panel, manipulation
        self._held: Probe | None = None  # the dragged probe, as it was before the drag
        self._escape = EscapeKey(self)
        self._escape.pressed.connect(self._put_back)
        self._is_pointing = False
        self._pointer: tuple[Probe, ...] = ()
        self._before_click: tuple[tuple[Probe, ...], int] = ((), 0)
        self._moved: dict[str, Value] = {}  # the setting that the last click moved, and its value
        panel.changed.connect(self._show)
        for name, pane in panes.items():
            pane.clicked.connect(partial(self._follow, name))
            pane.double_clicked.connect(self._unfollow)
            pane.hand.hovered.connect(partial(self._point, name))
            pane.hand.left.connect(self._point_nowhere)
        hand = panes["image"].hand
        hand.drag_started.connect(self._hold)
        hand.dragged.connect(self._drag)
        hand.drag_ended.connect(self._let_go)

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Remove every probe, even a held one, because their scene is gone."""
        self._drop()
        self._pointer = ()
        self._panel.clear()

    def _show(self) -> None:
        for pane in self._panes.values():
            pane.request("probes", (*self._panel.probes, *self._pointer))

    def set_pointing(self, on: bool) -> None:
        """Start or stop marking the point under the mouse in all panes."""
        self._is_pointing = on
        self._point_nowhere()
        for pane in self._panes.values():  # a canvas has its own cursor over draggable objects
            if on:
                pane.setCursor(self._ring())
            else:
                pane.rest_pointer()

    def _ring(self) -> QCursor:
        """Return a mouse cursor that is large enough for a class."""
        ratio = self._window.devicePixelRatioF()
        side = math.ceil(RING_SHARE * self._window.screen().size().height() * ratio)
        pixmap = QPixmap(side, side)
        pixmap.fill(Qt.GlobalColor.transparent)
        with QPainter(pixmap) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            colours = self._window.palette()
            roles = QPalette.ColorRole
            for role, width in ((roles.WindowText, 0.2), (roles.Highlight, 0.12)):
                painter.setPen(QPen(colours.color(role), width * side))
                edge = 0.1 * side
                painter.drawEllipse(QRectF(pixmap.rect()).adjusted(edge, edge, -edge, -edge))
        pixmap.setDevicePixelRatio(ratio)
        return QCursor(pixmap)

    def _point(self, name: str, place: QPointF) -> None:
        if self._is_pointing:
            self._pointer = self._probes_at(name, place)
            self._show()

    def _point_nowhere(self) -> None:
        if self._pointer:
            self._pointer = ()
            self._show()

    def _probes_at(self, name: str, place: QPointF) -> tuple[Probe, ...]:
        """Return a probe at a position in a pane: a point, a pixel's ray, or nothing."""
        drawing = self._panes[name].drawing
        if drawing is None:  # not drawn yet
            return ()
        from app.drawings.probes import pick_in

        at, pixel = (place.x(), place.y()), None
        if name == "image":
            pixel = drawing.image_pixel(*at)
            if pixel is None:  # outside the picture
                return ()
        shown, ratio = self._shown(), self._panes[name].canvas.pixel_ratio
        hit = pick_in(shown.scene, shown.projection, drawing.sight, at, ratio)
        if hit is not None:
            return (Probe(0, point=hit.point),)
        return () if pixel is None else (Probe(0, pixel=pixel),)

    def _follow(self, name: str, place: QPointF) -> None:
        chosen, shown = self._panel.chosen, self._shown()
        self._before_click = self._panel.probes, chosen.number if chosen else 0
        phenomenon, self._moved = shown.scene.phenomenon, {}
        setting = phenomenon.clicked if phenomenon is not None and name == "image" else ""
        for probe in self._probes_at(name, place):
            if not setting:
                self._panel.follow(point=probe.point, pixel=probe.pixel)
            elif probe.point is not None:
                self._moved = {setting: shown.document.settings[setting]}
                self._manipulation.setting_edited.emit({setting: probe.point})
            else:
                depth = float(shown.projection.depth != "reversed")
                text = self.tr("depth = {0}: must be that of something drawn, but nothing is here")
                self.refused.emit(text.format(f"{depth:g}"))

    def begin(self, panel: Panel) -> None:
        """Follow the first vertex of the picture when the user opens a panel without probes."""
        drawing = self._panes["image"].drawing
        if panel is not self._panel or self._panel.probes or drawing is None:
            return
        from app.drawings.probes import next_vertex, vertex_of

        shown, ratio = self._shown(), self._panes["image"].canvas.pixel_ratio
        scene, projection, room = shown.scene, shown.projection, drawing.picture_rectangle_px
        number = next_vertex(scene, projection, drawing.sight, room, ratio, None, forwards=True)
        if number is not None:
            self._panel.follow(point=vertex_of(scene, projection, number))

    def _unfollow(self) -> None:
        """Undo the click that was the first half of a double-click."""
        self._panel.restore(*self._before_click)
        if self._moved:
            self._manipulation.setting_edited.emit(self._moved)

    def _hold(self, place: QPointF) -> None:
        """Hold the mark in the image that a drag starts on; otherwise, the picture."""
        drawing = self._panes["image"].drawing
        if drawing is None:
            return
        nearest = HOLD_WITHIN_PX * self._panes["image"].canvas.pixel_ratio
        for probe in self._panel.probes:
            if probe.point is None:
                continue
            ((x_px, y_px),) = drawing.sight.seen([list(probe.point)]).tolist()
            away = math.hypot(x_px - place.x(), y_px - place.y())
            if away <= nearest:  # never true for NaN, a point without a picture
                nearest, self._held = away, probe
        if self._held is not None:
            self._panes["image"].hand.keep_view()
            self._panel.choose(self._held.number)
            self._panel.begin_gesture()
            self._escape.watch(self._window)
        else:
            self._manipulation.take_picture(place)

    def _drag(self, away: QPointF, along_ray: bool) -> None:
        drawing = self._panes["image"].drawing
        if self._held is None or self._held.point is None or drawing is None:
            return
        projection = self._shown().projection
        shift_px = drawing.image_shift(away.x(), away.y())
        point = dragged(projection, self._held.point, shift_px, along_ray=along_ray)
        if point is not None:
            self._panel.put(self._held.number, point)

    def _let_go(self) -> None:
        if self._escape.is_watched:
            self._escape.leave()
            self._held = None
            self._panel.end_gesture()

    def _put_back(self) -> None:
        """Cancel the drag, and ignore the mouse until its button is released."""
        if self._held is not None and self._held.point is not None:
            self._panel.put(self._held.number, self._held.point)
        self._drop()

    def _drop(self) -> None:
        """Forget the held probe, and end the drag."""
        held, self._held = self._held, None
        if held is not None:
            self._panes["image"].hand.dropped.emit()
