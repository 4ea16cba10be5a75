"""The current document, its undo history, and one signal when it changes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.document.document import Document
from app.model.projection import Projection

UNDO_LIMIT = 1000


class Store(QObject):
    """Owns the document that the whole window shows; knows no widget.

    Edits come in as whole values and go out as one `changed(document)`; an edit that changes
    nothing is silent. A gesture (a drag, a play of the animation) is one undo step however many
    edits it makes; one that comes while another goes on (a drag while the animation plays) is a
    step of its own, and so is a change of the whole document. What the outer one does afterwards
    belongs to that step: undo takes back what the user did last.

    Parameters
    ----------
    document : Document
        What is open at the start.
    saved : Document, optional
        What is in its file, if that is another one; undo goes back to it where it has the same
        scene, which is there.
    """

    changed = Signal(object)
    """The new `Document`, once per change."""
    history_changed = Signal()
    """Undo, redo or the unsaved mark may be different now."""

    def __init__(
        self,
        document: Document,
        parent: QObject | None = None,
        *,
        saved: Document | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._saved: Document | None = saved or document
        self._undo: list[Document] = []
        self._redo: list[Document] = []
        here = document.scene, document.mesh
        if saved is not None and saved != document and (saved.scene, saved.mesh) == here:
            self._undo.append(saved)
        self._gestures = 0
        self._gesture_start: Document | None = None

    @property
    def document(self) -> Document:
        """The document as it stands."""
        return self._document

    @property
    def modified(self) -> bool:
        """Whether it differs from what was last opened or saved."""
        return self._document != self._saved

    @property
    def in_gesture(self) -> bool:
        """Whether a control is being dragged or an animation plays."""
        return self._gestures > 0

    @property
    def can_undo(self) -> bool:
        """Whether there is an earlier state to go back to."""
        return bool(self._undo) or self._gesture_moved

    @property
    def can_redo(self) -> bool:
        """Whether an undone state can be taken up again."""
        return bool(self._redo)

    @property
    def _gesture_moved(self) -> bool:
        return self._gesture_start is not None and self._gesture_start != self._document

    def open(self, document: Document, *, saved: bool = True) -> None:
        """Start afresh on a document; the history of the old one is gone.

        Parameters
        ----------
        document : Document
        saved : bool
            False for a recovered document, which is not in any file of the user's.
        """
        self._undo.clear()
        self._redo.clear()
        if self._gestures:
            self._gesture_start = document
        self._saved = document if saved else None
        self._show(document)

    def mark_saved(self) -> None:
        """Note that the document as it stands is in its file."""
        self._saved = self._document
        self.history_changed.emit()

    def set_document(self, document: Document) -> None:
        """Change the whole document (to another scene, say), always one step; equal is silent."""
        if document == self._document:
            return
        self._close_gesture()
        self._gesture_start = None
        self._remember(self._document)
        self._redo.clear()
        self._show(document)

    def set_projection(self, projection: Projection) -> None:
        """Make an edit of the projection; equal is silent."""
        if projection != self._document.projection:
            self._edit(replace(self._document, projection=projection))

    def set_settings(self, settings: Mapping[str, Any]) -> None:
        """Make an edit of some of the scene's settings, which the camera may follow.

        Raises
        ------
        Refusal
            If the scene cannot have them; the document stays as it was.
        """
        self._edit(self._document.with_settings(settings))

    def _edit(self, document: Document) -> None:
        if document == self._document:
            return
        if not self._gestures:
            self._remember(self._document)
        self._redo.clear()
        self._show(document)

    def show_again(self) -> None:
        """Announce the document as it stands: a file that it names holds something else now."""
        self._show(self._document)

    def begin_gesture(self) -> None:
        """Take the edits until `end_gesture` as one undo step; gestures may overlap."""
        self._close_gesture()
        self._gesture_start = self._document
        self._gestures += 1

    def end_gesture(self) -> None:
        """End the gesture that `begin_gesture` began."""
        if not self._gestures:
            return
        self._gestures -= 1
        self._close_gesture()
        self._gesture_start = None
        self.history_changed.emit()

    def abandon_gesture(self) -> None:
        """Put back what the gesture has changed so far, as if it had not; not among several."""
        if self._gestures == 1 and self._gesture_moved and self._gesture_start is not None:
            self._show(self._gesture_start)

    def undo(self) -> None:
        """Go back one step; during a gesture, to where the gesture began."""
        self._close_gesture()
        if self._undo:
            self._redo.append(self._document)
            self._show(self._undo.pop())
            self._restart_gesture()

    def redo(self) -> None:
        """Take the last undone step up again."""
        self._close_gesture()
        if self._redo:
            self._undo.append(self._document)
            self._show(self._redo.pop())
            self._restart_gesture()

    def _close_gesture(self) -> None:
        if self._gesture_moved and self._gesture_start is not None:
            self._remember(self._gesture_start)
            self._restart_gesture()

    def _restart_gesture(self) -> None:
        if self._gesture_start is not None:
            self._gesture_start = self._document

    def _remember(self, document: Document) -> None:
        self._undo.append(document)
        del self._undo[:-UNDO_LIMIT]

    def _show(self, document: Document) -> None:
        self._document = document
        self.changed.emit(document)
        self.history_changed.emit()
