"""Prepare the neighbouring steps of a talk while the speaker talks, or of a lesson that is read."""

from collections.abc import Iterator

from PySide6.QtCore import QObject, QTimer, Signal

from app.lecture.equation import equation_of
from app.lecture.equation_form import laid_out
from app.lecture.notation import matrices
from app.lecture.typesetting import line_of
from app.lessons.course import scene_of
from app.lessons.player import PlayedBlock
from app.lessons.text import spoken_text
from app.model.refusal import Refusal
from widgets.parts.lesson_text import set_text
from widgets.parts.panel import ShownData
from widgets.parts.plain import TextDocument
from widgets.window.lessons import TRANSITION_S, Lessons
from widgets.window.look import Look
from widgets.window.talk_band import TalkBand

REST_MS = round(1000 * TRANSITION_S) + 150
"""Delay after a step before the next one is prepared, in the background."""


class StepPreparation(QObject):
    """Prepares the next and the previous step, in pieces between Qt's events."""

    done = Signal()  # everything but the speaker's picture of the next step is prepared

    def __init__(self, lessons: Lessons, look: Look, band: TalkBand, parent: QObject) -> None:
        super().__init__(parent)
        self._lessons, self._look, self._band = lessons, look, band
        self._rest = QTimer(self, singleShot=True, interval=REST_MS)
        self._slice = QTimer(self, singleShot=True, interval=0)
        self._rest.timeout.connect(self._slice.start)
        self._slice.timeout.connect(self._go_on)
        self._work: Iterator[None] = iter(())
        self._draws = False

    def begin_later(self, *, draws: bool) -> None:
        """Stop, and begin again for the current step; only a talk `draws` its pictures ahead."""
        self._draws, self._work = draws, self._pieces()
        self._slice.stop() if draws else self.forget()
        self._rest.start()

    def forget(self) -> None:
        """Stop; what was prepared may be shown later."""
        self._slice.stop()

    def _go_on(self) -> None:
        """Do one piece, and schedule the next one for when Qt is idle."""
        if self._lessons.is_moving:
            self._rest.start()
        elif next(self._work, self) is None:
            self._slice.start()

    def _pieces(self) -> Iterator[None]:
        """Prepare the neighbouring steps; their mistakes are reported when they are shown."""
        player, place = self._lessons.player, self._lessons.place
        if player is None:
            return
        course = player.course
        steps, scenes = course.lesson.steps, []
        for number in (place + 1, place - 1):
            if not 0 <= number < len(steps):
                continue
            step = steps[number]
            set_text(TextDocument(), step.title, title=True)
            if self._draws:
                self._band.prepare(step)
            try:
                played = [PlayedBlock(player, number, block) for block in step.asked]
                for block in played:
                    if block.variant is None:
                        block.draw(block.seed or 1)
                        yield
                parts = (*step.words, *(block.question for block in played))
                for _, text in (each for part in parts for each in part.texts()):
                    set_text(TextDocument(), text)
                    spoken_text(text)
                    yield
                document = course.shown(number).document
                scenes.append(ShownData.of(document, scene_of(document)))
                yield
                projection, view = document.projection, document.view
                if view.panel == "matrices":  # its formulas are then typeset only once
                    matrices(projection, view.letters)
                elif "equation" in view.slide:
                    asked = projection, view.letters, view.equation, document.settings
                    laid = laid_out(equation_of(*asked))
                    yield from (None for matrix in laid if line_of(matrix.lead, formula=1.0))
                words = self._look.words
                yield from (None for n in view.names or () if line_of(words.get(f"{{{n}}}", n)))
            except Refusal:
                continue
            yield
        if self._draws:
            yield from self._look.draw_ahead(scenes)
            self.done.emit()
