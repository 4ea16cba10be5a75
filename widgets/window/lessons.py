"""A lesson or a talk in the window: shows its steps, and restores a step after manual changes.

::

    file --Lessons.open--> Course --go(step)--> Store (undo begins here) --> the window
    a saved change of the file --> the same step again, if it shows something else now

The user may change anything at a step. Such changes are not unsaved work, and `come_back` shows the
step again as in the file.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QFileSystemWatcher, QObject, QTimer, Signal

from app import languages
from app.document.document import Document
from app.document.store import Store
from app.document.view import AS_EVER, FIELDS, View
from app.lecture.letters import Letters
from app.lessons import transition
from app.lessons.blocks.block import State
from app.lessons.checking import CheckReport
from app.lessons.contents import CONTENT
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Lesson, read
from app.lessons.player import Player
from app.model.projection import Camera
from app.model.refusal import Cancelled, Refusal
from widgets.parts.clock import Clock
from widgets.parts.messages import MessageBar, sentence
from widgets.parts.progress import apart
from widgets.window.files import Files
from widgets.window.transition import Transition

TRANSITION_S = 0.4  # duration of the model's motion between two steps
MOST_MISTAKES = 5  # most mistakes of a file that are named at once
SETTLED_MS = 150  # delay before a changed file is read: editors may write it twice


class Lessons(QObject):
    """Shows the steps of the open lesson.

    - `stand_still`: stops all animations before another step is shown.
    - `to_stage`: moves the stage strip to a position.
    - `look_from`: sets the cameras of panes; other panes get their default camera.
    """

    opened = Signal()  # a lesson was opened, read again, or closed: `course` has changed
    mistakes_changed = Signal(str)  # mistakes in the open file, one a line; empty once fixed
    refused = Signal(str)  # why a step cannot be shown; the previous step stays
    entered = Signal()  # a step begins; what its page poses now is shown as the step's state
    stepped = Signal()  # another step is shown, or the same one again
    arrived = Signal()  # the model has moved to where it goes

    def __init__(
        self,
        store: Store,
        files: Files,
        messages: MessageBar,
        stand_still: Callable[[], None],
        to_stage: Callable[[float], None],
        look_from: Callable[[Mapping[str, Camera]], None],
        panes: Transition,
    ) -> None:
        super().__init__(store)
        self._store, self._files, self._messages = store, files, messages
        self._stand_still, self._to_stage = stand_still, to_stage
        self._look_from, self._panes = look_from, panes
        self.player: Player | None = None  # the open lesson, as it is played
        self.letters: Letters | None = None  # instead of those that lessons ask for
        self._clock = Clock(self, self._move)
        self._start = self._end = store.document
        self._part = 1.0
        self._stages = (0.0, 0.0)
        self._moving = self._checks = False
        self._watcher = QFileSystemWatcher(self)
        self._settled = QTimer(self, singleShot=True, interval=SETTLED_MS)
        self._settled.timeout.connect(self.read_again)
        self._watcher.fileChanged.connect(lambda _path: self._settled.start())
        self._watcher.directoryChanged.connect(lambda _path: self._settled.start())
        store.changed.connect(self._see)

    # -- what is open

    @property
    def course(self) -> Course | None:
        return self.player.course if self.player is not None else None

    @property
    def place(self) -> int:
        """The current step, counted from 0."""
        return self.player.place if self.player is not None else 0

    @property
    def lesson(self) -> Lesson | None:
        return self.player.lesson if self.player is not None else None

    @property
    def is_moving(self) -> bool:
        """Whether the model is moving to a step."""
        return self._clock.running

    @property
    def is_away(self) -> bool:
        """Whether the window no longer shows the step, because the user changed something."""
        store, player = self._store, self.player
        return player is not None and player.is_away(store.document, store.look())

    def open(self, path: str | Path, step: str = "") -> bool:
        """Open a lesson at its first step, or at the named one; emit the reason if that fails."""
        try:
            course = Course(read(path, letters=self.letters))
        except Refusal as error:
            self._messages.show_message(named(error, Path(path)))
            return False
        return self.play(course, step)

    def play(self, course: Course, step: str = "") -> bool:
        """Open a lesson that is read already, as `open` does."""
        try:
            place = course.lesson.place_of(step)
            shown = course.shown(place)
            scene = scene_of(shown.document)
        except Refusal as error:
            self._messages.show_message(named(error, course.lesson.path))
            return False
        self.mistakes_changed.emit("")
        self._messages.done()
        self._finish()
        self._stand_still()
        left, self.player = self.player, Player(course, place)
        look = self._store.look()
        # A lesson begins with the default view, whatever the window showed before.
        view = replace(AS_EVER, layout=look.layout, letters=look.letters, panel="")
        document = replace(shown.document, view=replace(view, **shown.view))
        if not self._files.open_step(document, scene, course.file):
            self.player = left
            return False
        is_own = course.lesson.path.parent != CONTENT  # the program's speak its language
        languages.follow_lesson(course.lesson.language if is_own else "")
        self._unwatch()
        if course.file is not None:
            self._watcher.addPaths([str(course.file), str(course.file.parent)])
        self.opened.emit()
        self.entered.emit()
        self.stepped.emit()
        return True

    def close(self) -> None:
        """Close the lesson; the window stays as it is."""
        if self.player is None:
            return
        self._finish()
        self._unwatch()
        self.player = None
        languages.follow_lesson("")
        self._store.origin.is_work = True
        self._store.mark_saved()
        self.opened.emit()

    # -- navigation

    def go(self, place: int) -> bool:
        """Show a step; return False, and keep the current one, if that is impossible."""
        player = self.player
        if player is None or not 0 <= place < len(player.lesson.steps):
            return False
        try:
            scene_of(player.shown_at(place).document)
        except Refusal as error:
            self.refused.emit(named(error, player.lesson.path))
            return False
        self._finish()
        self._stand_still()
        left = player.place
        player.turn_to(place)
        self._moving = True
        self.entered.emit()
        self._moving = False
        shown = player.shown_at(place)
        is_other = self._is_other(shown.document)
        view = player.view_of(shown, self._store.look(), other_scene=is_other)
        if not self._move_to(replace(shown.document, view=view), scene_of(shown.document)):
            player.turn_to(left)
            player.reach_again()
            self.entered.emit()
            return False
        if place != left:
            self._store.forget_steps()
            player.arrived = self._store.look().panes
        elif self._store.look().panes != player.arrived:
            self._look_from(player.arrived)
        self.stepped.emit()
        self._set_off()
        return True

    def next(self) -> bool:
        """Go to the next step; return False at the last."""
        return self.go(self.place + 1)

    def previous(self) -> bool:
        """Go to the previous step; return False at the first."""
        return self.go(self.place - 1)

    def come_back(self) -> bool:
        """Show the step as in its file, with the cameras it began with; this can be undone."""
        return self.go(self.place)

    def pose(self, document: Document) -> None:
        """Show the state of an exercise as the step's own, until another step is shown."""
        assert self.player is not None
        self.player.posed = document
        if not self._moving and self.go(self.player.place):
            self._store.forget_steps()

    def show_predicted(self, state: State) -> None:
        """Show the state that answers a prediction of the step, if possible."""
        assert self.player is not None
        try:
            document = self.player.course.at(self.player.place).shown_by(state)
        except Refusal as error:
            self.refused.emit(named(error, self.player.lesson.path))
        else:
            self.show(document)

    def show(self, document: Document) -> None:
        """Show a state that refutes an idea or answers a prediction, without leaving the step."""
        assert self.player is not None
        self._finish()
        self._stand_still()
        is_other = self._is_other(document)
        view = self.player.view_beside(document, self._store.look(), other_scene=is_other)
        self._move_to(replace(document, view=view), scene_of(document))
        self._set_off()

    def show_left(self, document: Document) -> None:
        """Show at once how a student has left the step."""
        self._move_to(document, scene_of(document))
        self._finish()

    def _is_other(self, document: Document) -> bool:
        here = self._store.document
        return (here.scene, here.mesh) != (document.scene, document.mesh)

    def _move_to(self, end: Document, scene: Any) -> bool:
        """Change to a document in one undo step, moving if possible; return False if refused."""
        store = self._store
        start, look = store.document, store.look()
        self._files.keep(end, scene)
        self._start, self._end = start, end
        self._stages = look.stage, end.view.stage
        first, is_there = None, True
        is_other, panes = self._is_other(end), self._panes
        moves = panes.is_wanted
        fades = moves and panes.begin(cuts=is_other or _slide(look) != _slide(end.view))
        # Nobody would see the model move under a picture that fades.
        if moves and not fades and transition.can_move(start, end):
            first = transition.between(start, end, 0.02)
        else:  # the model changes at once; only the stage strip may move
            self._start = end
        self._moving = True
        if start == end:
            changes = {
                name: getattr(end.view, name)
                for name in FIELDS
                if getattr(end.view, name) != getattr(look, name)
            }
            store.set_view(**changes)
            self._look_from(end.view.panes)  # which frames the picture anew
        else:  # first the end, for the undo history; then from the start to the end, frame by frame
            # The end also determines the cameras of the panes that the user has not turned.
            is_there = store.set_document(end)
        if not is_there or not moves:
            self._moving = False
            return is_there
        if fades or is_other:
            self._stages = end.view.stage, end.view.stage
        # Before the model stands at the start again, which the panes would frame.
        goes = panes.start(first is not None or self._stages[0] != self._stages[1])
        if first is not None:
            store.go_on(first)
        self._moving = False
        if goes:
            self._part = 0.0
            self._to_stage(self._stages[0])
            panes.go(0.0)
            self._clock.start()
        return True

    def _set_off(self) -> None:
        """Paint the beginning of the way, and let the time begin after that."""
        if self._clock.running:
            self._panes.paint()
            self._clock.start()

    def _move(self, seconds: float) -> None:
        self._part = min(1.0, self._part + seconds / TRANSITION_S)
        eased = 0.5 - 0.5 * math.cos(math.pi * self._part)
        at: Document | None = self._end
        if self._part == 1.0:
            self._clock.stop()
        elif self._start != self._end:
            at = transition.between(self._start, self._end, eased)
        if at is not None and at != self._store.document:
            view = self._store.document.view
            if at.view is not view:  # the view has changed since the motion began
                at = replace(at, view=view)
            self._moving = True
            self._store.go_on(at)
            self._moving = False
        begin, end = self._stages
        self._to_stage(begin + eased * (end - begin))  # exactly there if both are the same
        self._panes.go(eased)
        if self._part == 1.0:
            self.arrived.emit()

    def _finish(self) -> None:
        """Move the model to its end at once."""
        if self._clock.running:
            self._part = 1.0
            self._move(0.0)

    def _see(self, _document: Document) -> None:
        """Stop moving when something else changes the document."""
        if not self._moving and self._clock.running:
            self._clock.stop()
            self._panes.go(1.0)
            self.arrived.emit()

    # -- the file

    def _unwatch(self) -> None:
        watched = [*self._watcher.files(), *self._watcher.directories()]
        if watched:
            self._watcher.removePaths(watched)
        self._settled.stop()

    def read_again(self, name: str = "") -> None:
        """Read a changed file; stay at the step with the given name, else at the current number."""
        player = self.player
        if player is None:
            return
        if self._checks:  # the window goes on meanwhile
            self._settled.start()
            return
        before, path = player.course, player.lesson.path
        if str(path) not in self._watcher.files():  # editors replace the file
            self._watcher.addPath(str(path))
        try:
            course = Course(read(path, letters=self.letters))
            if course.lesson == before.lesson:
                self._emit_mistakes()
                return
            last = len(course.lesson.steps) - 1
            place = course.lesson.place_of(name or player.step.name, min(player.place, last))
            shown = course.shown(place)
        except Refusal as error:
            if before.lesson.is_talk:
                self.mistakes_changed.emit(named(error, path))
            else:
                self._emit_mistakes()
            return
        self._messages.done()
        same = player.posed is None and shown == before.shown(player.place)
        self.player = player.read_again(course, place)
        self.opened.emit()
        if same:
            self.entered.emit()
            self.stepped.emit()
        else:
            self.go(place)
        self._emit_mistakes()

    def _emit_mistakes(self) -> None:
        """Emit the mistakes of a lesson; those of a talk are shown when a step needs them."""
        is_talk = self.lesson is not None and self.lesson.is_talk
        mistakes = "" if is_talk else self.mistakes()
        if mistakes is not None:
            self.mistakes_changed.emit(mistakes)

    def mistakes(self) -> str | None:
        """Check the open file as `lesson check` does, without its pictures; say what is wrong.

        Returns None if the user cancels it.
        """
        assert self.lesson is not None
        report, path = CheckReport(), self.lesson.path
        self._checks = True
        try:
            with self._files.progress(self.tr("Checking {0}").format(path.name)) as tell:
                apart(partial(report.read, path), tell)
        except Cancelled:
            return None
        finally:
            self._checks = False
        texts = [sentence(error) for error in report.wrong[:MOST_MISTAKES]]
        if len(report.wrong) > MOST_MISTAKES:
            texts.append(self.tr("… and {0} more").format(len(report.wrong) - MOST_MISTAKES))
        return "\n".join(texts)


def _slide(view: View) -> tuple[object, ...]:
    """Return what a class sees as another slide if it differs."""
    return view.slide, view.large, view.equation, view.compare


def named(error: Refusal, path: Path) -> str:
    """Describe the mistake in a file, with its name."""
    text = sentence(error)
    known = error.file is not None and str(path) in text
    return text if known else f"{path.name}: {text}"
