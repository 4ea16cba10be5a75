"""A lesson, a talk, a test or a review as it is played, without a window.

::

    Player.turn_to(place) -> unfold(): the step's texts, and its questions as `PlayedBlock`s
    PlayedBlock.submit(typed) -> a Verdict, kept in `Player.progress` and in the record
    Player.reveal() -> a class is asked a question, then told its answer

The card beside the pictures and the talk's band show what a player holds.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

from app.document.document import Document
from app.document.view import AS_EVER, FIELDS, View, without_scene
from app.lessons.blocks.block import REVEALED, Asked, Here, ReadBlock, State, Variant, Verdict
from app.lessons.blocks.task import DONE
from app.lessons.course import Course, ShownStep, scene_of
from app.lessons.lesson import Lesson, Step
from app.lessons.practice import Sheet, verdict_on
from app.lessons.record import RIGHT, SHOWN, WRONG, Attempt, now_s, spaced
from app.lessons.strokes import answer_picture
from app.lessons.writing import changes
from app.model.projection import Camera
from app.model.refusal import Refusal


@dataclass(frozen=True)
class Progress:
    """A student's progress in a lesson; `step` is the one to continue at, empty for the first.

    An answer is stored by ``step/block``: the number of a choice, from 1, the typed text, or a
    task's result. `done` is the number of finished steps, `of` that of all steps.
    """

    step: str = ""
    answers: Mapping[str, str] = field(default_factory=dict, hash=False)
    done: int = 0
    of: int = 0


class Draft(NamedTuple):
    """What a student had begun when the step was left."""

    seed: int  # of an exercise, or 0
    hints_read: int
    typed: str


class PlayedBlock:
    """A question or a task as a student answers it."""

    def __init__(self, player: "Player", place: int, block: Asked) -> None:
        self._player, self._at, self.block = player, player.course.at(place), block
        self._key = f"{player.lesson.steps[place].name}/{block.name}"
        self.is_test = player.is_test
        self.variant: Variant | None = None if block.varies else block.variant(self._at, 0)
        if player.sheet is not None:
            self.variant = player.sheet.items[place].variant
        """The question with its numbers; None before an exercise begins."""
        self.hints_read, self.answer = 0, ""  # a sample's, `REVEALED` or `DONE`; empty while open
        self.now = self._at.document  # the window's current state, with its view
        self._named: set[int] = set()
        """The lines of the wrong ideas of a task that were named: each is named once."""
        self.typed = ""  # what was typed and not submitted when the step was left
        self._drafts = player.drafts
        draft = self._drafts.get(self._key)
        if draft is None:
            self._restore(player.progress.answers.get(self._key, ""))
            return
        if block.varies:
            self.draw(draft.seed)
        _, self.hints_read, self.typed = draft

    @property
    def question(self) -> Asked:
        return self.variant.question if self.variant is not None else self.block

    @property
    def here(self) -> Here:
        return self.variant.here if self.variant is not None else self._at

    @property
    def is_open(self) -> bool:
        return not self.answer

    @property
    def holds(self) -> bool:
        """Whether the step continues only after an answer."""
        return self.block.holds and self.is_open

    @property
    def hides(self) -> frozenset[str]:
        """What must not be seen now, because it would show the answer."""
        is_asked = self.variant is not None and (self.is_test or self.is_open)
        return self.block.hides if is_asked else frozenset()

    @property
    def hints(self) -> Sequence[str]:
        """The hints not given yet; a test has none."""
        if self.is_test or self.variant is None:
            return ()
        return self.question.hints[self.hints_read :]

    @property
    def seed(self) -> int:
        """The number of an exercise's variant; 0 for what is no exercise."""
        return self.variant.seed if self.variant is not None else 0

    def draw(self, seed: int) -> None:
        """Draw the numbers of an exercise; a `Refusal` if none suit."""
        self.variant = self._at.variant(self.block, seed)
        self.answer, self.hints_read = "", 0
        self._named.clear()

    def _restore(self, kept: str) -> None:
        """Take an answer that was kept earlier, perhaps for an older version of the lesson."""
        if not kept:
            return
        if self.block.varies:
            seed, _, kept = kept.partition(" ")
            if self.is_test and seed != str(self.seed):
                return
            try:
                self.draw(int(seed))
            except ValueError:  # a Refusal is one
                return
        if self.is_test or self.question.accepts(self.here, kept):
            self.answer = kept

    def keep_draft(self, typed: str) -> None:
        """Keep what is typed until the step is shown again, and the variant and the hints read."""
        is_drawn = self.seed and self._key not in self._player.progress.answers
        if self.is_open and (typed or self.hints_read or is_drawn):
            self._drafts[self._key] = Draft(self.seed, self.hints_read, typed)
        else:
            self._drafts.pop(self._key, None)

    def submit(self, typed: str, verdict: Verdict | None = None, given: str = "") -> Verdict:
        """Mark an answer, and keep it if it settles the question.

        A window, which can measure distances in its picture, may have a verdict already. What was
        `given` is recorded in place of what was typed.
        """
        given = spaced(given or typed).strip()
        try:
            verdict = verdict or self.question.mark(self.here, typed)
        except Refusal:
            if not self.question.retries:
                self._settle(typed)
            raise
        if self.is_test:
            self.hand_in(given)
            return verdict
        if not verdict.too_short:
            self._record(given, verdict.word)
        if verdict.right or not self.question.retries:
            self._settle(typed)
        return verdict

    def hand_in(self, given: str) -> None:
        """Keep an answer for the end of a test."""
        self._record(given, verdict_on(self.question, self.here, given))
        self._settle(given)

    def give_hint(self) -> str:
        """Return the next hint; empty if all are given."""
        hint = next(iter(self.hints), "")
        self.hints_read += bool(hint)
        return hint

    def reveal_answer(self) -> None:
        """Settle the question with the right answer."""
        self._record("", SHOWN)
        self._settle(REVEALED)

    def look(self, now: Document) -> bool:
        """Take the window's current state; return whether it has just solved a task."""
        self.now = now
        if not self.is_open or self.is_test:
            return False
        if not self.question.is_done(self.here, now, now.view):
            return False
        self._record(self.changes, RIGHT)
        self._settle(DONE)
        return True

    @property
    def changes(self) -> str:
        """What was changed, as in a sample; of the view only what the task is about."""
        return " ".join(filter(self.question.is_about, changes(self.here.document, self.now)))

    def name_idea(self) -> Verdict | None:
        """Return the verdict on the wrong idea behind the window's state, unless it was named."""
        if not self.is_open:
            return None
        line, verdict = self.question.verdict_in(self.here, self.now, self.now.view) or (0, None)
        if verdict is None or line in self._named:
            return None
        self._named.add(line)
        self._record(self.changes, verdict.word)
        return verdict

    def _settle(self, answer: str) -> None:
        self.answer = answer
        kept = f"{self.seed} {answer}" if self.block.varies else answer
        self._player.keep_answer(self._key, kept)

    def _record(self, typed: str, word: str) -> None:
        idea = "" if word in (RIGHT, WRONG, SHOWN) else word
        exercise = f"{self._at.step.name}/{self.block.name}"
        attempt = Attempt(
            now_s(), self._at.course.name, exercise, self.seed, typed,
            WRONG if idea else word, idea, self.hints_read, self.is_test,
        )  # fmt: skip
        self._player.log(attempt)


class Player:
    """An open lesson: where the student or the class is, what is answered, and what comes next."""

    def __init__(self, course: Course, place: int = 0) -> None:
        self.course, self.place = course, place  # `place` is the current step, from 0
        self.progress = Progress()
        self.drafts: dict[str, Draft] = {}  # by ``step/block``
        self.log: Callable[[Attempt], object] = lambda _attempt: None
        self.keep: Callable[[Progress], object] = lambda _progress: None
        """Takes the progress whenever it changes, as `log` takes each answer for the record."""
        self.blocks: list[PlayedBlock] = []  # the questions of the step that are shown so far
        self._rest: list[ReadBlock] = []  # the parts of the step that are not shown yet
        self.revealed = 0
        """A class's progress: the step's picture alone, then each question asked, and answered."""
        self._reached: dict[int, int] = {}  # how far each step was revealed when it was left
        self.arrived: Mapping[str, Camera] = {}  # the panes' cameras when the step was shown
        self.posed: Document | None = None
        """The state of the step's exercise, shown in place of the step's own."""
        self._beside: dict[str, tuple[Any, Any]] = {}
        """The fields of the view that a state beside the step changed: before, and then."""
        self._aside: tuple[Document, View | None] | None = None
        """A state that the lesson shows to refute an idea: it is not the student's work."""

    # -- where one is

    @property
    def lesson(self) -> Lesson:
        return self.course.lesson

    @property
    def step(self) -> Step:
        return self.lesson.steps[self.place]

    @property
    def sheet(self) -> Sheet | None:
        """The exercises of other lessons that this one is made of, if it is a test or a review."""
        return self.course if isinstance(self.course, Sheet) else None

    @property
    def is_test(self) -> bool:
        """Whether answers are marked at the end."""
        return self.sheet is not None and self.sheet.is_test

    @property
    def is_last(self) -> bool:
        return self.place + 1 == len(self.lesson.steps)

    def turn_to(self, place: int) -> None:
        """Leave the step for another one."""
        if place != self.place:
            self._reached[self.place], self.revealed, self.place = self.revealed, 0, place
            self.blocks, self._rest, self.posed = [], [], None

    def read_again(self, course: Course, place: int) -> "Player":
        """Return the player of the changed file, with what the window shows beside its steps."""
        player = Player(course, place)
        player.arrived, player._beside = self.arrived, self._beside
        return player

    # -- what the student answers

    def begin_page(self) -> None:
        """Begin the step's page anew, with the answers that are kept."""
        self.blocks, self._rest = [], [*self.step.parts]

    def unfold(self) -> Iterator[tuple[ReadBlock, PlayedBlock | None]]:
        """Yield the parts up to an open prediction, because the rest would reveal the answer."""
        while self._rest and self.held is None:
            part = self._rest.pop(0)
            asked = (each for each in self.step.asked if each is part)
            played = [PlayedBlock(self, self.place, each) for each in asked]
            self.blocks += played
            yield part, next(iter(played), None)

    @property
    def held(self) -> PlayedBlock | None:
        """The prediction that must be made before the step continues."""
        return next((block for block in self.blocks if block.holds), None)

    def hinting(self, current: PlayedBlock | None) -> PlayedBlock | None:
        """Return the block that gives the next hint: the one with the cursor, or a task."""
        hinting = [block for block in self.blocks if block.is_open and block.hints]
        if current is not None and current.is_open:
            hinting = [b for b in hinting if b is current or not b.question.has_field]
            hinting.sort(key=lambda block: block is not current)
        return next(iter(hinting), None)

    def is_done(self, step: Step) -> bool:
        """Whether all blocks of a step are answered; one without blocks is done once it is left."""
        names = [part.name for part in step.asked] or [""]
        return all(f"{step.name}/{name}" in self.progress.answers for name in names)

    @property
    def left(self) -> list[int]:
        """The places of the steps where something is left to do."""
        return [at for at, step in enumerate(self.lesson.steps) if not self.is_done(step)]

    def keep_answer(self, key: str, answer: str) -> None:
        """Keep an answer by its ``step/block``."""
        self.progress = replace(self.progress, answers={**self.progress.answers, key: answer})
        self.save()

    def leave_step(self) -> None:
        """Mark a step that asks nothing as done."""
        if not self.step.asked:
            self.keep_answer(f"{self.step.name}/", DONE)

    def finish(self) -> None:
        """End the lesson; it will begin at its first step."""
        self.leave_step()
        self.progress = replace(self.progress, step="")
        self.save()

    def forget(self) -> Progress:
        """Delete all answers; return the progress before."""
        before, self.progress, self.drafts = self.progress, Progress(), {}
        self.save()
        return before

    def save(self) -> None:
        """Keep the progress, with the number of finished steps."""
        count = len(self.lesson.steps)
        self.progress = replace(self.progress, done=count - len(self.left), of=count)
        self.keep(self.progress)

    # -- what a class is asked

    @property
    def questions(self) -> Sequence[ReadBlock]:
        """The questions of the step that a talk first asks and then answers."""
        return [part for part in self.step.parts if part.reveals]

    @property
    def unrevealed(self) -> int:
        """How many questions and answers come before the next step."""
        return 2 * len(self.questions) - self.revealed

    @property
    def revealed_state(self) -> State | None:
        """What the last of the given answers shows; None for what the step does."""
        answered = self.questions[: self.revealed // 2]
        return next((each.show for each in reversed(answered) if each.show is not None), None)

    @property
    def picture(self) -> str:
        """The name of what a class sees: the step, or one of its answers that has a picture."""
        shows = [answer.show is not None for answer in self.questions[: self.revealed // 2]]
        return answer_picture(self.step.name, sum(shows)) if any(shows) else self.step.name

    def reveal(self) -> bool:
        """Ask the next question, or answer it; return False if all are answered."""
        goes = self.unrevealed > 0
        self.revealed += goes
        return goes

    def reach_again(self) -> None:
        """Reveal the step as far as it was when it was left."""
        self.revealed = self._reached.get(self.place, 0)

    def said(self, answer_of: Callable[[ReadBlock, Here], str]) -> str:
        """Return the current question, or its answer, as Markdown; empty for none."""
        if not self.revealed:
            return ""
        question = self.questions[(self.revealed - 1) // 2]
        if self.revealed % 2:
            return question.posed()
        return question.explained(answer_of(question, self.course.at(self.place)), others=False)

    @property
    def planned(self) -> tuple[float, float]:
        """The minutes that the notes of a talk plan before the step, and for it."""
        minutes = [step.note.minutes if step.note else 0.0 for step in self.lesson.steps]
        return sum(minutes[: self.place]), minutes[self.place]

    def minutes_late(self, seconds: float) -> int:
        """Return by how many whole minutes a talk is late after some seconds."""
        return max(0, int(seconds / 60.0 - sum(self.planned)))

    # -- what the window shows

    def shown_at(self, place: int) -> ShownStep:
        """Return what a step shows: its own state, or that of its exercise."""
        shown = self.course.shown(place)
        if self.posed is None or place != self.place:
            return shown
        return ShownStep(self.posed, _fields(self.posed, shown.view))

    def is_away(self, document: Document, look: View) -> bool:
        """Whether a window no longer shows the step, because the user changed something."""
        shown = self.shown_at(self.place)
        if look.panes != self.arrived or document != shown.document:
            return True
        beside = self._beside.items()
        if any(before != then == getattr(look, name) for name, (before, then) in beside):
            return True
        scene = scene_of(shown.document)
        is_closed = self.is_test or any("numbers" in block.hides for block in self.blocks)

        def chosen(view: View) -> View:
            """Fill in what the scene chooses, and close the panel that must be closed."""
            fixed = scene.fixed if view.fixed is None else view.fixed
            panel = "" if is_closed else view.panel
            return replace(view, large=view.large or scene.leading, fixed=fixed, panel=panel)

        return chosen(look) != chosen(replace(look, **shown.view))

    def view_of(self, shown: ShownStep, look: View, *, other_scene: bool) -> View:
        """Return the view of a step: fields set by the lesson, the others from the window."""
        beside = self._beside.items()
        own = {name: before for name, (before, then) in beside if getattr(look, name) == then}
        look, self._beside = replace(look, **own), {}
        if other_scene:
            look = without_scene(look)
        # A step is seen from its own side, wherever the user has turned the one before.
        return replace(look, **{"panes": {}, **shown.view})

    def view_beside(self, document: Document, look: View, *, other_scene: bool) -> View:
        """Return the view of a state beside the step, in which a pane stays as a hand turned it."""
        shown, panes = self.course.shown(self.place), document.view.panes
        if panes == shown.document.view.panes:
            panes = {} if other_scene else look.panes
        fields = _fields(document, shown.view)
        first = {name: before for name, (before, _) in self._beside.items()}
        self._beside |= {
            name: (first.get(name, getattr(look, name)), value) for name, value in fields.items()
        }
        return replace(look, **fields | {"panes": panes})

    def show_aside(self, document: Document | None) -> None:
        """Take a state that is shown to refute an idea; None once the step is shown again."""
        self._aside = None if document is None else (document, None)

    def is_own_work(self, document: Document, look: View) -> bool:
        """Whether the user made a state, rather than the lesson to refute an idea."""
        if self._aside is not None:
            aside, looked = self._aside
            if document == aside and looked in (None, look):
                self._aside = aside, look
                return False
            self._aside = None
        return True


def _fields(document: Document, asked: Mapping[str, Any]) -> dict[str, Any]:
    """Return the view of a document: the fields that a step sets, and those it has itself."""
    return {
        name: getattr(document.view, name)
        for name in FIELDS
        if name in asked or getattr(document.view, name) != getattr(AS_EVER, name)
    }
