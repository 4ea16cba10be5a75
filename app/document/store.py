"""The current document, its undo history, and one signal when it changes."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NamedTuple, Self

from PySide6.QtCore import QObject, Signal

from app.document.document import Document
from app.document.view import View
from app.model.projection import Projection

UNDO_LIMIT = 1000
OPENED_LIMIT = 3  # how many openings can be undone: their scenes stay in memory


@dataclass(eq=False)
class Origin:
    """Where a document came from; opening anything creates a new origin."""

    saved: Document | None  # as in the document's file, or as it was opened; None if in no file
    path: Path | None = None  # the path of its file
    written: object = None  # the state of that file when it was last read or written here
    is_work: bool = True  # whether it must not get lost. A student's trials at a lesson's step may.


class _UndoStep(NamedTuple):
    document: Document
    origin: Origin


class Store(QObject):
    """Owns the document that the whole window shows. It does not depend on widgets.

    Edits come in as whole values and go out as one `changed(document)`; an edit that changes
    nothing emits nothing. A gesture (a drag, a run of the animation) is one undo step, however many
    edits it makes. A gesture inside another one (a drag while the animation plays) is a separate
    step, and later edits of the outer gesture belong to that step: undo reverts what the user did
    last. Changing the whole document is a step, and so is opening another one: undo restores the
    previous document with its file and its unsaved work.

    Changing the view is not a step. The widgets hold the view; the store requests it (`look`)
    before it shows another document, so that undo restores the view too.

    If the document's file has another content, `saved`, undo returns to it in the same scene.
    """

    changed = Signal(object)  # the new `Document`, once per change
    history_changed = Signal()  # undo, redo or the unsaved mark may have changed
    view_changed = Signal(object)  # the `Document`; only its view has changed
    leaving = Signal()  # a document of another origin is about to be shown

    def __init__(
        self, document: Document, parent: QObject | None = None, *, saved: Document | None = None
    ) -> None:
        super().__init__(parent)
        self._document = document
        self.origin = Origin(saved or document)
        self.look: Callable[[], View] = lambda: self._document.view
        self._undo: list[_UndoStep] = []
        self._redo: list[_UndoStep] = []
        here = document.scene, document.mesh
        if saved is not None and saved != document and (saved.scene, saved.mesh) == here:
            self._undo.append(_UndoStep(saved, self.origin))
        self._gestures = 0
        self._gesture_start: Document | None = None
        self._before: tuple[Any, ...] | None = None  # the state that a refused change goes back to
        self._is_refused = False

    @property
    def document(self) -> Document:
        return self._document

    @property
    def modified(self) -> bool:
        """Whether the document differs from the one last opened or saved, and would be lost."""
        return self.origin.is_work and self._document != self.origin.saved

    @property
    def seen(self) -> Document:
        """The document with the current view."""
        return replace(self._document, view=self.look())

    @property
    def documents(self) -> Iterator[Document]:
        """The document, and all documents that undo and redo can restore."""
        yield self._document
        for step in (*self._undo, *self._redo):
            yield step.document

    @property
    def in_gesture(self) -> bool:
        """Whether a control is being dragged or an animation plays."""
        return self._gestures > 0

    @property
    def can_undo(self) -> bool:
        """Whether there is an earlier state to go back to; a lesson is left only by closing it."""
        may_leave = self.origin.is_work
        is_there = bool(self._undo) and (may_leave or self._undo[-1].origin is self.origin)
        return is_there or self._gesture_moved

    @property
    def can_redo(self) -> bool:
        return bool(self._redo)

    @property
    def _gesture_moved(self) -> bool:
        return self._gesture_start is not None and self._gesture_start != self._document

    def open(
        self,
        document: Document,
        *,
        saved: bool = True,
        path: Path | None = None,
        is_work: bool = True,
    ) -> bool:
        """Change to a document from elsewhere, as one step; return False if it is refused.

        Only a recovered document is not `saved`: it is in no file of the user's.
        """
        left, aside = self.origin, self._document
        self._put_aside(document, Origin(document if saved else None, path, is_work=is_work))
        opened = list(dict.fromkeys(step.origin for step in self._undo))[-OPENED_LIMIT:]
        self._undo = [step for step in self._undo if step.origin in opened]
        if self._gestures:
            self._gesture_start = document
        is_shown = self._show(document)
        if is_shown and not left.is_work:  # a lesson is left by this; undo may pass through it
            left.is_work, left.saved = True, aside
        return is_shown

    def take_steps(self, other: Self) -> None:
        """Take over what undo and redo know in another store, whose document this one has."""
        self.origin, self._undo, self._redo = other.origin, other._undo, other._redo
        self.history_changed.emit()

    def mark_saved(self) -> None:
        """Record that the current document is in its file."""
        self.origin.saved = self._document
        self.history_changed.emit()

    def set_view(self, **changes: Any) -> None:
        """Change fields of the `View`, without an undo step or unsaved work.

        An equal view emits nothing, and impossible values raise a `Refusal`.
        """
        before = self.look()
        view = replace(before, **changes)
        if view != before:
            self._keep_view(view)
            self.view_changed.emit(self._document)

    def _keep_view(self, view: View) -> None:
        """Store a view in this step and in all others that had the same one."""
        old = self._document.view

        def kept(document: Document) -> Document:
            return replace(document, view=view) if document.view is old else document

        for steps in (self._undo, self._redo):
            steps[:] = [_UndoStep(kept(step.document), step.origin) for step in steps]
        self._document = kept(self._document)
        if self._gesture_start is not None:
            self._gesture_start = kept(self._gesture_start)

    def _leave(self, document: Document, origin: Origin) -> None:
        """Store the view, and the state to return to, before another document is shown."""
        if document.view is not self._document.view:
            self._keep_view(self.look())
        self._before = (
            self._document, self.origin, self._undo[:], self._redo[:], self._gesture_start
        )  # fmt: skip
        if origin is not self.origin:
            self.leaving.emit()

    def _put_aside(self, document: Document, origin: Origin) -> None:
        """Record the change to another document as a step."""
        self._close_gesture()
        self._gesture_start = None
        self._leave(document, origin)
        self._remember(self._document)
        self._redo.clear()
        self.origin = origin

    def refuse(self) -> None:
        """Revert the change that `changed` is announcing, because its scene cannot be drawn."""
        self._is_refused = True

    def set_document(self, document: Document) -> bool:
        """Change the whole document as one step; return False, changing nothing, if refused."""
        if document == self._document:
            return True
        self._put_aside(document, self.origin)
        return self._show(document)

    def forget_steps(self) -> None:
        """Let undo end at the current document; what was open before stays, for `can_undo`."""
        self._undo = [step for step in self._undo if step.origin is not self.origin]
        self._redo.clear()
        self.history_changed.emit()

    def go_on(self, document: Document) -> None:
        """Continue the change that `set_document` or `open` began, in the same step."""
        self._show(document)

    def set_projection(self, projection: Projection) -> None:
        if projection != self._document.projection:
            self._edit(replace(self._document, projection=projection))

    def set_settings(self, settings: Mapping[str, Any]) -> None:
        """Edit some of the scene's settings; the camera may follow.

        Raises a `Refusal` if the scene cannot have them; the document stays as it was.
        """
        self._edit(self._document.with_settings(settings))

    def _edit(self, document: Document) -> None:
        if document == self._document:
            return
        if not self._gestures:
            self._remember(self._document)
        self._redo.clear()
        self._show(document)

    def show_again(self) -> bool:
        """Emit `changed` because a file of the document has changed; return False if refused."""
        self._leave(self._document, self.origin)
        return self._show(self._document)

    def begin_gesture(self) -> None:
        """Combine the edits until `end_gesture` into one undo step; gestures may overlap."""
        self._close_gesture()
        self._gesture_start = self._document
        self._gestures += 1

    def end_gesture(self) -> None:
        if not self._gestures:
            return
        self._gestures -= 1
        self._close_gesture()
        self._gesture_start = None
        self.history_changed.emit()

    def abandon_gesture(self) -> None:
        """Revert the changes of the gesture in progress; do nothing if there are several."""
        if self._gestures == 1 and self._gesture_moved and self._gesture_start is not None:
            self._show(self._gesture_start)

    def undo(self) -> None:
        """Go back one step; during a gesture, to where the gesture began."""
        self._close_gesture()
        if self.can_undo:
            self._go(self._undo, self._redo)

    def redo(self) -> None:
        self._close_gesture()
        self._go(self._redo, self._undo)

    def _go(self, steps: list[_UndoStep], others: list[_UndoStep]) -> None:
        if steps:
            self._leave(*steps[-1])
            others.append(_UndoStep(self._document, self.origin))
            document, self.origin = steps.pop()
            self._show(document)
            self._restart_gesture()

    def _close_gesture(self) -> None:
        if self._gesture_moved and self._gesture_start is not None:
            self._remember(self._gesture_start)
            self._restart_gesture()

    def _restart_gesture(self) -> None:
        if self._gesture_start is not None:
            self._gesture_start = self._document

    def _remember(self, document: Document) -> None:
        self._undo.append(_UndoStep(document, self.origin))
        del self._undo[:-UNDO_LIMIT]

    def _show(self, document: Document) -> bool:
        before, self._before, self._is_refused = self._before, None, False
        self._document = document
        self.changed.emit(document)
        back_to = before if self._is_refused else None
        if back_to is not None:
            self._document, self.origin, self._undo, self._redo, self._gesture_start = back_to
            self.changed.emit(self._document)
        self.history_changed.emit()
        return back_to is None
