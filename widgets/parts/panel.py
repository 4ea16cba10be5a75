"""The frozen snapshot that the window shows, and the interfaces of the objects that show it."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol, TypeAlias

from PySide6.QtCore import Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from app.document.document import Document
from app.document.naming import inks
from app.drawings.style import Style
from app.lecture.highlight import Highlight
from app.model.projection import Projection
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene
from widgets.parts.gestures import Gestures

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
    def of(cls, document: Document, scene: Scene) -> ShownData:
        """Make the snapshot of a document with its loaded scene."""
        return cls(document, scene, scene.illustration(document.projection, document.settings))

    @cached_property
    def projection(self) -> Projection:
        return self.document.projection

    def hues(self, style: Style) -> dict[str, str]:
        """Return the colours of the letters that the pictures name in one, for formulas."""
        colours = inks(self.document, self.scene, self.illustration)
        return {name: getattr(style, colour) for name, colour in colours.items()}

    def changed_since(self, before: ShownData | None) -> Changed:
        """Return the parts that differ from an earlier snapshot, if there was one."""
        if before is None:
            return EVERYTHING
        new, old = self.document, before.document
        changed = {
            part
            for part in PROJECTION
            if getattr(new.projection, part) != getattr(old.projection, part)
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
