"""The frozen snapshot that the window shows, and the interfaces of the objects that show it.

Running numbers are shown only as often as they can be read, and when the input stops::

    changed --no gesture------------------------------> show, at once
            --in a gesture, after a rest--------------> show, at once: before the panes are drawn
            --in a gesture, every READ_MS and STEPS---> show, likewise
            --in a gesture, sooner--------------------> show, when it rests

What the user points at is highlighted by one value for the whole window::

    row, cell, word or pane --mark(who, what)--> Highlighter --changed(what)--> all that show it

A widget under the mouse or with the focus marks its subject, and marks `NOTHING` afterwards. The
latest mark counts; when it is removed, the previous one counts again.
"""

import time
from abc import abstractmethod
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol, TypeAlias

from PySide6.QtCore import QObject, QRectF, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent, QPen, QShowEvent
from PySide6.QtWidgets import QWidget

from app.document.document import Document
from app.document.naming import inks
from app.drawings.style import LIGHT, Style
from app.lecture.highlight import NOTHING, Highlight
from app.model.projection import Projection
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene
from widgets.parts.gestures import Gestures
from widgets.parts.layouts import OfWidget
from widgets.parts.messages import all_digits
from widgets.parts.plain import PlainLabel


class Highlighter(QObject):
    """Keeps the current highlight."""

    changed = Signal(object)  # the new `Highlight`

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._by_whom: dict[Hashable, Highlight] = {}
        self._now = NOTHING

    def mark(self, who: Hashable, what: Highlight) -> None:
        """Set or remove (`NOTHING`) the highlight of one source."""
        self._by_whom.pop(who, None)
        if what:
            self._by_whom[who] = what
        now = next(reversed(self._by_whom.values()), NOTHING)
        if now != self._now:
            self._now = now
            self.changed.emit(now)


def faded(colour: QColor | str, opacity: float) -> QColor:
    pale = QColor(colour)
    pale.setAlphaF(opacity)
    return pale


def paint_highlight(widget: QWidget, painter: QPainter, rect: QRectF) -> None:
    """Tint and frame a highlighted part of a widget."""
    colour = widget.palette().highlight().color()
    painter.fillRect(rect, faded(colour, 0.2))
    painter.setPen(QPen(colour, 1.0))
    painter.drawRect(rect.adjusted(0.5, 0.5, -0.5, -0.5))


class TintedWidget(OfWidget):
    """A widget that is tinted while its subject is highlighted elsewhere."""

    is_marked = False

    def set_marked(self, marked: bool) -> None:
        if marked != self.is_marked:
            self.is_marked = marked
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.is_marked:
            with QPainter(self) as painter:
                paint_highlight(self, painter, QRectF(self.rect()))


class MarkedLabel(TintedWidget, PlainLabel):
    """Words that are tinted while their subject is highlighted elsewhere."""


Changed: TypeAlias = frozenset[str]  # some of `EVERYTHING`
PROJECTION: Changed = frozenset({"lens", "camera", "image_size", "depth", "placement"})
"""The fields of a `Projection`."""
EVERYTHING: Changed = PROJECTION | {"scene", "illustration", "settings", "quality", "view"}


@dataclass(frozen=True, eq=False)
class ShownData:
    """The data that all panes and panels show, made once per change of the document.

    The scene belongs to the document. The illustration is for this projection, or None if the scene
    is not a phenomenon.
    """

    document: Document
    scene: Scene
    illustration: Illustration | None

    @classmethod
    def of(cls, document: Document, scene: Scene) -> "ShownData":
        return cls(document, scene, scene.illustration(document.projection, document.settings))

    @cached_property
    def projection(self) -> Projection:
        return self.document.projection

    def hues(self, style: Style) -> dict[str, str]:
        """Return the colours of the letters that the pictures name in one, for formulas."""
        colours = inks(self.document, self.scene, self.illustration)
        return {name: getattr(style, colour) for name, colour in colours.items()}

    def changed_since(self, before: "ShownData | None") -> Changed:
        """Return the parts that differ from an earlier snapshot, if there was one."""
        if before is None:
            return EVERYTHING
        new, old = self.document, before.document
        changed = {
            part
            for part in PROJECTION
            if getattr(self.projection, part) != getattr(before.projection, part)
        }
        besides = {
            "scene": self.scene is not before.scene,
            "illustration": self.illustration is not before.illustration,
            "settings": new.settings != old.settings,
            "quality": new.quality != old.quality,
            # An edit shares its view with the document before; another document brings its own.
            "view": new.view is not old.view,
        }
        return frozenset(changed.union(part for part, is_new in besides.items() if is_new))


class Listener(Protocol):
    """An object that the window notifies of changes: a pane, the controls, a panel, a component."""

    @property
    def concerns(self) -> Changed:
        """The parts of a `ShownData` whose changes this object needs."""

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Show another snapshot; `changed` has at least one of the parts that it `concerns`."""


class Panel(QWidget, Gestures):
    """A panel of the drawer under the panes.

    An open panel is notified of each change; a folded one is notified of all changes at once before
    it opens. The window connects its signals.
    """

    concerns = EVERYTHING  # see `Listener`

    edited = Signal(object)  # the user made this `Projection`
    highlighted = Signal(object)  # the `Highlight` of the part under the mouse or the cursor
    adjusted = Signal(str)  # a sentence about something that was done differently from the request
    refused = Signal(str)  # a sentence about something that was refused
    copy_wanted = Signal(QImage)
    export_wanted = Signal(QImage)
    """The user wants this picture of a diagram on the clipboard, or in a file."""

    @abstractmethod
    def take(self, shown: ShownData, changed: Changed) -> None:
        """Show another snapshot; see `Listener`."""

    def begin_gesture(self) -> None:
        """Begin a gesture: a control is dragged, or something plays."""

    def end_gesture(self) -> None:
        """End the gesture."""

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark the parts that are highlighted."""

    def set_style(self, style: Style) -> None:
        """Use the colours and sizes of the drawings."""


READ_MS = 100  # digits that change more often cannot be read
STEPS = 3  # if steps are slow, the numbers are shown once in so many steps


class Readable(QObject):
    """Decides when a widget shows changed values: never while it is hidden.

    The widget's showEvent must call `settle`, as that of a `ReadablePanel` does. `is_seen` says
    whether the values can be seen; by default, whether the widget is visible.
    """

    def __init__(
        self, widget: QWidget, show: Callable[[], None], is_seen: Callable[[], bool] | None = None
    ) -> None:
        super().__init__(widget)
        self._show, self._is_seen = show, is_seen or widget.isVisible
        self._gestures = 0
        self._pending = False
        self._shown_ms = float("-inf")
        self._steps = STEPS  # steps since values were shown
        self._rest = QTimer(self, singleShot=True, interval=READ_MS)
        self._rest.timeout.connect(self._rested)

    @property
    def in_gesture(self) -> bool:
        """Whether values are changing: a control is dragged, or something plays."""
        return self._gestures > 0

    def begin_gesture(self) -> None:
        """Begin a gesture; gestures may overlap."""
        if not self._gestures:
            self._steps = STEPS
        self._gestures += 1

    def end_gesture(self) -> None:
        """End a gesture; after the last one its values are shown."""
        self._gestures = max(self._gestures - 1, 0)
        if not self._gestures:
            self.settle()

    def changed(self) -> None:
        """Show changed values, now or as soon as they can be read."""
        self._pending = True
        self._steps += 1
        early = self.now_ms() - self._shown_ms < READ_MS or self._steps < STEPS
        if self._gestures and early:
            self._rest.start()  # restarted at each step: steps that follow show it
        else:
            self.settle()

    def settle(self) -> None:
        """Show changed values now, if there are any."""
        self._rest.stop()
        if self._pending and self._is_seen():
            self._pending = False
            self._steps, self._shown_ms = 0, self.now_ms()
            try:
                self._show()
            except BaseException:
                self._pending = True  # the next time the widget appears, it tries again
                raise

    def _rested(self) -> None:
        self.settle()
        self._steps = STEPS

    def now_ms(self) -> float:
        return 1e3 * time.monotonic()


class ReadablePanel(Panel):
    """A panel whose running numbers are shown only as often as they can be read."""

    def __init__(self) -> None:
        super().__init__()
        self._readable = Readable(self, self._fill)
        self._style = LIGHT
        all_digits.changed.connect(self._readable.changed)

    @abstractmethod
    def _fill(self) -> None:
        """Show all current values."""

    def set_style(self, style: Style) -> None:
        self._style = style
        self._readable.changed()

    def begin_gesture(self) -> None:
        self._readable.begin_gesture()

    def end_gesture(self) -> None:
        self._readable.end_gesture()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._readable.settle()
