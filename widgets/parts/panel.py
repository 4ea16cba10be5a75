"""What is shown, as one frozen snapshot per change, and who is told what changed in it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, TypeAlias

from PySide6.QtCore import Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from app.document.document import Document
from app.drawings.style import Style
from app.lecture.highlight import Highlight
from app.model.projection import Projection
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene
from widgets.parts.gestures import Gestures

Changed: TypeAlias = frozenset[str]
"""Some of `EVERYTHING`."""
PROJECTION: Changed = frozenset({"lens", "camera", "image_size", "depth", "placement"})
"""The fields of a `Projection`."""
EVERYTHING: Changed = PROJECTION | {"scene", "illustration", "settings", "quality", "view"}


@dataclass(frozen=True, eq=False)
class Shown:
    """What all panes and panels show, made once per change of the document.

    Parameters
    ----------
    document : Document
    scene : Scene
        The loaded one of the document.
    illustration : Illustration or None
        What the scene's phenomenon shows for this projection; None for a scene that is none.
    """

    document: Document
    scene: Scene
    illustration: Illustration | None

    @classmethod
    def of(cls, document: Document, scene: Scene) -> Shown:
        """What is to be seen of a document, whose scene is loaded."""
        illustration = None
        if scene.phenomenon is not None:
            illustration = scene.phenomenon.illustration(
                document.projection, document.settings, scene.subject
            )
        return cls(document, scene, illustration)

    @property
    def projection(self) -> Projection:
        """That of the document."""
        return self.document.projection

    def changed_since(self, before: Shown | None) -> Changed:
        """What is another one than in an earlier snapshot.

        Parameters
        ----------
        before : Shown or None
            None if nothing was shown before.
        """
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


class Told(Protocol):
    """Whoever is told of changes: the panes, the controls, a panel, a room of the window."""

    @property
    def concerns(self) -> Changed:
        """Of the parts of a `Shown` those that it has to do with."""

    def take(self, shown: Shown, changed: Changed) -> None:
        """Show another snapshot.

        Parameters
        ----------
        shown : Shown
        changed : frozenset of str
            What of it is new since this one was told last: never nothing of what concerns it.
        """


class Panel(QWidget, Gestures):
    """A panel of the drawer under the panes.

    It is told of a change while it is open; a folded one is told of all changes at once when it is
    opened, before it appears. The window wires its signals, whichever of them it has a use for.
    """

    concerns = EVERYTHING
    """As of `Told`."""

    edited = Signal(object)
    """The user made this `Projection`."""
    highlighted = Signal(object)
    """The `Highlight` that what is under the mouse or the cursor draws."""
    told = Signal(str)
    """What was done otherwise than it was asked for, in one sentence."""
    refused = Signal(str)
    """What cannot be, in one sentence."""
    copy_wanted = Signal(QImage)
    export_wanted = Signal(QImage)
    """This picture of a diagram shall go to the clipboard, or into a file."""

    def take(self, shown: Shown, changed: Changed) -> None:
        """Show another snapshot, as of `Told`."""
        raise NotImplementedError

    def begin_gesture(self) -> None:
        """Until `end_gesture`, values run: a control is dragged, or something plays."""

    def end_gesture(self) -> None:
        """End the gesture that `begin_gesture` began."""

    def show_highlight(self, highlighted: Highlight) -> None:
        """Mark what is highlighted."""

    def set_style(self, style: Style) -> None:
        """Take over colours and sizes of the drawings."""
