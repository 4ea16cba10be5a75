"""A lesson over the model: each step's document, what its formulas are worth, what is answered.

The documents are made from the file alone, in its order, so that a step is the same bit for bit
whatever was done in the window meanwhile.
"""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import replace
from functools import cache, cached_property, lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from app.document import files
from app.document.document import Document, is_mesh
from app.document.settings import set_values
from app.document.view import AS_EVER, FIELDS, View
from app.lessons import marking
from app.lessons.lesson import (
    BESIDE,
    Choice,
    Lesson,
    Question,
    State,
    Task,
    Words,
    Wrong,
    on_line,
    read,
    refused,
)
from app.lessons.quantities import NotThere, Quantities
from app.model.formula import Formula
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.scenes.scene import BUILT_IN, Scene, load

NO_VALUE = QT_TRANSLATE_NOOP("Refusal", "has no value in this state: there is no {0}")
CONTENT = Path(__file__).with_name("content")
"""The lessons, talks and wrong ideas that come with the program."""


@lru_cache(maxsize=32)
def _scene(name: str, mesh: str) -> Scene:
    return load(name, mesh=mesh)


def scene_of(document: Document) -> Scene:
    """The scene of a document; the same one again while few others were asked for."""
    return _scene(document.scene, document.mesh)


class Shown(NamedTuple):
    """What a step shows.

    Attributes
    ----------
    document : Document
        Its view has what the file sets.
    view : dict
        What of the view the lesson sets at this step, by the fields of `View`: all that any of
        its steps sets, so that it is as ever where this one does not.
    """

    document: Document
    view: dict[str, Any]


class Verdict(NamedTuple):
    """What is said to an answer.

    Attributes
    ----------
    right : bool
    idea : str
        Name of the wrong idea that leads there, if it is one that has a name.
    says : str
        Markdown.
    state : Document, optional
        That shows it.
    too_short : bool
        Whether it only lacks digits.
    value : float, optional
        The right one.
    """

    right: bool
    idea: str = ""
    says: str = ""
    state: Document | None = None
    too_short: bool = False
    value: float | None = None


class Course:
    """The steps of a lesson as states of the model.

    Parameters
    ----------
    lesson : Lesson

    Raises
    ------
    Refusal
        Nothing is made at once: each step when it is asked for.
    """

    def __init__(self, lesson: Lesson) -> None:
        self.lesson = lesson
        self._shown: dict[int, Shown] = {}

    @property
    def folder(self) -> Path:
        """Where the lesson's own files are."""
        return Path(os.path.dirname(os.path.realpath(self.lesson.path)))

    @cached_property
    def _managed(self) -> frozenset[str]:
        """What of the view the lesson has anything to do with."""
        fields = set()
        for step in self.lesson.steps:
            for _, text in step.state.values if step.state else ():
                section, _, rest = text.strip().partition(".")
                if section == "view":
                    fields.add(rest.partition("=")[0].strip())
            if step.state and step.state.document:
                fields |= set(FIELDS)
        for field, along in (
            ("frame_step", "panel"),
            ("probes", "pinned"),
            ("compare", "dividers"),
        ):
            if field in fields:
                fields.add(along)
        if self.lesson.letters:
            fields.add("letters")
        return frozenset(fields) & frozenset(FIELDS)  # of a mistyped one its own step complains

    def shown(self, place: int) -> Shown:
        """What a step shows, counted from 0.

        Raises
        ------
        Refusal
            With its line, if there can be no such state.
        """
        begin = place
        while begin > 0 and begin not in self._shown and not self._anew(begin):
            begin -= 1
        for number in range(begin, place + 1):
            if number not in self._shown:
                before = None if self._anew(number) else self._shown[number - 1].document
                state = self.lesson.steps[number].state
                document = self._made(state, before)
                view = {name: getattr(document.view, name) for name in self._managed}
                self._shown[number] = Shown(document, view)
        shown = self._shown[place]
        self._try_scene(shown.document, place)
        return shown

    def _try_scene(self, document: Document, place: int) -> None:
        """Read the scene, if it is not known: a mesh may vanish during a talk."""
        while place > 0 and not self._anew(place):
            place -= 1
        state = self.lesson.steps[place].state
        with on_line(state.line if state is not None else 1):
            scene_of(document)

    def _anew(self, place: int) -> bool:
        state = self.lesson.steps[place].state
        return place == 0 or (state is not None and state.begins_anew)

    def _made(self, state: State | None, before: Document | None) -> Document:
        """A state that goes on from the one before, or begins anew without it."""
        letters = self.lesson.letters or AS_EVER.letters
        if state is not None and state.document:
            before = self._read(state)
        values = [(line, text) for line, text in state.values] if state else []
        if before is None:
            name = next(
                (text.partition("=")[2].strip() for _, text in values if _path(text) == "scene"),
                "letter-f",
            )
            mesh = next(
                (text.partition("=")[2].strip() for _, text in values if _path(text) == "mesh"), ""
            )
            line = next((line for line, text in values if _path(text) == "scene"), 1)
            with on_line(line, "scene"):
                before = self._opened(name, mesh, line)
            values = [(line, text) for line, text in values if _path(text) not in ("scene", "mesh")]
            before = replace(before, view=replace(AS_EVER, letters=letters, panel=""))
        elif state is not None and state.document and self.lesson.letters:
            before = replace(before, view=replace(before.view, letters=letters))
        if not values:
            return before
        try:
            return set_values(before, (text for _, text in values))
        except Refusal as error:
            line = _line_of(error.field, values) or (state.line if state else 1)
            with on_line(line):
                raise

    def _opened(self, name: str, mesh: str, line: int) -> Document:
        """A scene as it opens: built in, or a mesh beside the lesson."""
        scene = name if name in BUILT_IN or not is_mesh(name) else self._beside(name, line)
        own = self._beside(mesh, line) if mesh else ""
        opened = _scene(scene, own)
        return Document(scene, opened.start, mesh=own)

    def _read(self, state: State) -> Document:
        path = self._beside(state.document, state.document_line)
        try:
            document = files.read(path)
        except Refusal as error:
            why = str(error).rstrip(".")
            raise refused(state.document_line, files.UNREADABLE, why) from error
        for file in (document.scene if is_mesh(document.scene) else "", document.mesh):
            if file and not self._is_beside(file):
                raise refused(state.document_line, BESIDE, value=os.path.basename(file))
        return document

    def _beside(self, name: str, line: int) -> str:
        path = os.path.normpath(self.folder / name)
        if not self._is_beside(path):
            raise refused(line, BESIDE, value=name)
        return path

    def _is_beside(self, path: str) -> bool:
        """Whether a file is in the lesson's folder, links followed."""
        folder = os.fspath(self.folder)
        real = os.path.realpath(path)
        return os.path.commonpath([folder, real]) == folder if _same_drive(folder, real) else False

    # -- formulas

    def quantities(
        self, place: int, now: Document | None = None, view: View | None = None
    ) -> Quantities:
        """The names of a step's formulas: of its own state, or of the window's as it stands now."""
        own = self.shown(place).document
        before = _quantities(own)
        return before if now is None else _quantities(now, view, before)

    def asked_over(self, place: int, question: Question) -> Quantities:
        """The names of a question's formulas: of the state that it shows, if it shows one."""
        if question.show is None:
            return self.quantities(place)
        return self.quantities(place, self.shown_by(place, question.show))

    def shown_by(self, place: int, state: State) -> Document:
        """The state that a prediction or a wrong idea shows, at a step.

        Raises
        ------
        Refusal
            With its line.
        """
        if not state.begins_anew:
            return self._made(state, self.shown(place).document)
        document = self._made(state, None)
        with on_line(state.line):
            scene_of(document)
        return document

    def value(self, place: int, question: Question, formula: Formula, line: int) -> float:
        """What a formula of a question is worth.

        Raises
        ------
        Refusal
            With its line.
        """
        with on_line(line, "formula"):
            try:
                return self.asked_over(place, question).value(formula)
            except NotThere as error:
                raise refused(line, NO_VALUE, str(error)) from error

    def answer(self, place: int, question: Question) -> float:
        """The right number of a question that has no choices.

        Raises
        ------
        Refusal
            With its line.
        """
        assert question.value is not None
        return self.value(place, question, question.value, question.value_line)

    def is_done(self, place: int, task: Task, now: Document, view: View | None = None) -> bool:
        """Whether a task's conditions hold of the window as it stands.

        Raises
        ------
        Refusal
            If one of them has no value there.
        """
        known = self.quantities(place, now, view)
        for line, condition in task.until:
            with on_line(line, "until"):
                if not condition.holds(known, lambda path: word_of(now, path, view)):
                    return False
        return True

    # -- answers

    def mark(self, place: int, question: Question, typed: str) -> Verdict:
        """What is said to a number that was typed.

        Raises
        ------
        Refusal
            If it is no number.
        """
        number, value = marking.read(typed, question.unit), self.answer(place, question)
        if marking.equals(number, value):
            return Verdict(True, says=question.why, value=value)
        for wrong in question.wrong:
            if marking.equals(number, self.value(place, question, wrong.formula, wrong.line)):
                return self._refuting(place, wrong, value)
        return Verdict(False, too_short=marking.is_too_short(number, value), value=value)

    def chosen(self, place: int, question: Question, number: int) -> Verdict:
        """What is said to a choice, counted from 0."""
        choice = question.choices[number]
        if choice.right:
            return Verdict(
                True, says=choice.says or question.why, state=self._shown_by(place, choice)
            )
        return self._refuting(place, choice, None)

    def _shown_by(self, place: int, said: Choice | Wrong) -> Document | None:
        return self.shown_by(place, said.state) if said.state is not None else None

    def _refuting(self, place: int, said: Choice | Wrong, value: float | None) -> Verdict:
        """With the idea's own sentences and state, where the lesson has none."""
        idea = idea_named(said.idea)
        says, state = said.says, self._shown_by(place, said)
        if idea is not None:
            says = says or idea.says
            state = state or idea.state
        return Verdict(False, said.idea, says, state, value=value)


def _same_drive(one: str, other: str) -> bool:
    return os.path.splitdrive(one)[0].lower() == os.path.splitdrive(other)[0].lower()


def _path(text: str) -> str:
    return text.partition("=")[0].strip()


def _line_of(field: str, values: Iterable[tuple[int, str]]) -> int:
    """The line that set a field, as a refusal names it; 0 if none did."""
    name = field.partition("[")[0]
    lines = [line for line, text in values if _path(text) in (name, field) or text.strip() == field]
    return lines[-1] if lines else 0


def _quantities(
    document: Document, view: View | None = None, before: Quantities | None = None
) -> Quantities:
    return Quantities(document, lambda: scene_of(document), view, before)


def word_of(document: Document, path: str, view: View | None = None) -> str:
    """What a document has for a path of ``--set`` whose value is a word; empty for none.

    Raises
    ------
    Refusal
        For a path that there is not.
    """
    section, _, key = path.rpartition(".")
    if section == "view":
        return str(getattr(view or document.view, key, None) or "")
    if section == "lens":
        return str(getattr(document.projection.lens, key, None) or "")
    if section == "settings":
        value = document.settings.get(key, "")
        return str(value).lower() if isinstance(value, bool) else str(value)
    if section == "object":
        return str(getattr(document.projection.placement, key, ""))
    if section == "quality":
        return str(getattr(document.quality, key, ""))
    return {"scene": document.scene, "mesh": document.mesh, "depth": document.projection.depth}.get(
        path, ""
    )


# --------------------------------------------------------------------------- wrong ideas


class Idea(NamedTuple):
    """A wrong idea that students have.

    Attributes
    ----------
    name, title : str
        The title is the idea in the words of somebody who has it.
    says : str
        Markdown; two sentences against it.
    state : Document
        That shows it.
    """

    name: str
    title: str
    says: str
    state: Document


@cache
def ideas() -> Course:
    """The wrong ideas that the program knows: a step each."""
    return Course(read(CONTENT / "ideas.md"))


def idea_named(name: str) -> Idea | None:
    """The wrong idea of a name, if the program knows it."""
    for place, step in enumerate(ideas().lesson.steps):
        if step.name == name:
            says = "\n\n".join(part.text for part in step.parts if isinstance(part, Words))
            return Idea(name, step.title, says, ideas().shown(place).document)
    return None


def contained() -> tuple[Path, ...]:
    """The files of all lessons and talks that come with the program, in the lectures' order."""
    return tuple(sorted(path for path in CONTENT.glob("*.md") if path.name != "ideas.md"))
