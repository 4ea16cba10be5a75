"""A lesson applied to the model: the document of each step, and the wrong ideas.

The documents are made from the file alone, in its order: a step is the same to the last bit,
whatever the user did in the window meanwhile.
"""

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from app import languages
from app.document import files
from app.document.document import Document, is_mesh
from app.document.naming import nameable
from app.document.settings import set_values
from app.document.view import AS_EVER, EVERYTHING, FIELDS, PANES, View
from app.lessons.blocks.block import Asked, Idea, State, Variant, path_of
from app.lessons.contents import CONTENT
from app.lessons.lesson import Lesson, Step, read
from app.lessons.lines import on_line, refused
from app.lessons.quantities import Quantities
from app.model.refusal import REFUSALS, Refusal
from app.scenes.scene import BUILT_IN, Scene, load

_ALONG = {"frame_step": "panel", "probes": "pinned", "compare": "dividers"}
"""Fields of the view that are set together with another one."""


_load = lru_cache(maxsize=32)(load)


def scene_of(document: Document) -> Scene:
    return _load(document.scene, mesh=document.mesh)


def panes_of(document: Document) -> list[str]:
    """Return the panes that a class sees, or the large one."""
    large = document.view.large or scene_of(document).leading
    return [pane for pane in document.view.slide if pane in PANES] or [large]


def unnameable(document: Document, panes: Sequence[str]) -> list[str]:
    """Return the names of a view that none of these panes can draw; none if there is no pane."""
    names = document.view.names
    if names is None or names == EVERYTHING or not panes:
        return []
    scene = scene_of(document)
    drawn = frozenset[str]().union(*(nameable(pane, document, scene) for pane in panes))
    return [name for name in names if name not in drawn]


class ShownStep(NamedTuple):
    """A step's document, and the fields of the view that any step sets."""

    document: Document
    view: dict[str, Any]


class Course:
    """The steps of a lesson as states of the model, each made on demand."""

    def __init__(self, lesson: Lesson) -> None:
        self.lesson = lesson
        self.file: Path | None = lesson.path
        self.name = name_of(lesson.path)  # under which answers are kept
        self._shown: dict[int, ShownStep] = {}
        self.variants: dict[tuple[int, str, int], Variant] = {}
        """What was drawn of exercises: by the place, the block's name and the seed."""

    def at(self, place: int) -> "AtStep":
        return AtStep(self, place)

    @property
    def folder(self) -> Path:
        """Return the folder of the lesson's file, with links resolved."""
        return Path(os.path.dirname(os.path.realpath(self.lesson.path)))

    @cached_property
    def managed(self) -> frozenset[str]:
        """Return the fields of the view that any step sets."""
        fields = set()
        for step in self.lesson.steps:
            for _, text in step.state.values if step.state else ():
                section, _, field = path_of(text).partition(".")
                if section == "view":
                    fields.add(field)
            if step.state and step.state.document:
                fields |= set(FIELDS)
        fields |= {along for field, along in _ALONG.items() if field in fields}
        if self.lesson.letters:
            fields.add("letters")
        return frozenset(fields) & frozenset(FIELDS)  # a mistyped one is refused at its own step

    @property
    def files(self) -> list[str]:
        """Return the names of the documents and meshes beside the lesson that its steps use."""
        needed = []
        for step in self.lesson.steps:
            if step.state is not None:
                needed.append(step.state.document)
                parts = (text.partition("=") for _, text in step.state.values)
                needed += (
                    value.strip()
                    for path, _, value in parts
                    if path.strip() in ("scene", "mesh") and is_mesh(value.strip())
                )
        return list(filter(None, needed))

    def shown(self, place: int) -> ShownStep:
        """Return what a step shows, counted from 0; a `Refusal` names the line."""
        begin = place
        while begin > 0 and begin not in self._shown and not self._begins_anew(begin):
            begin -= 1
        for number in range(begin, place + 1):
            if number not in self._shown:
                before = None if self._begins_anew(number) else self._shown[number - 1].document
                document = self.made(self.lesson.steps[number].state, before)
                view = {name: getattr(document.view, name) for name in self.managed}
                self._shown[number] = ShownStep(document, view)
        shown = self._shown[place]
        self._try_scene(shown.document, place)
        return shown

    def _try_scene(self, document: Document, place: int) -> None:
        """Refuse a scene that can no longer be read: a mesh may be deleted during a talk."""
        while place > 0 and not self._begins_anew(place):
            place -= 1
        state = self.lesson.steps[place].state
        with on_line(state.line if state is not None else 1):
            scene_of(document)

    def _begins_anew(self, place: int) -> bool:
        state = self.lesson.steps[place].state
        return place == 0 or (state is not None and state.begins_anew)

    def made(self, state: State | None, before: Document | None) -> Document:
        """Make a state that continues the previous one, or begins anew without one."""
        letters = self.lesson.letters or AS_EVER.letters
        if state is not None and state.document:
            before = self._read(state)
        values = state.values if state else ()
        if before is None:
            named = {path_of(text): (line, text.partition("=")[2].strip()) for line, text in values}
            line, name = named.pop("scene", (1, "letter-f"))
            with on_line(line, "scene"):
                before = self._opened(name, named.pop("mesh", (0, ""))[1], line)
            values = tuple((line, text) for line, text in values if path_of(text) in named)
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
        """Return the initial document of a built-in scene, or of a mesh beside the lesson."""
        scene = name if name in BUILT_IN or not is_mesh(name) else self._beside(name, line)
        own = self._beside(mesh, line) if mesh else ""
        return Document(scene, _load(scene, mesh=own).start, mesh=own)

    def _read(self, state: State) -> Document:
        path = self._beside(state.document, state.document_line)
        try:
            document = files.read(path)
        except Refusal as error:
            why = str(error).rstrip(".")
            raise refused(state.document_line, REFUSALS["files-unreadable"], why) from error
        for file in (document.scene if is_mesh(document.scene) else "", document.mesh):
            if file and not self._is_beside(file):
                raise refused(state.document_line, REFUSALS["beside"], value=os.path.basename(file))
        return document

    def _beside(self, name: str, line: int) -> str:
        path = os.path.normpath(self.folder / name)
        if not self._is_beside(path):
            raise refused(line, REFUSALS["beside"], value=name)
        return path

    def _is_beside(self, path: str) -> bool:
        """Whether a file is in the lesson's folder, with links resolved."""
        return Path(os.path.realpath(path)).is_relative_to(self.folder)


@dataclass(frozen=True, eq=False)
class AtStep:
    """A step as a state of the model, perhaps one of its `own`: the `Here` of its blocks."""

    course: Course
    place: int
    own: Document | None = None
    given: Mapping[str, float] = field(default_factory=dict)

    @property
    def step(self) -> Step:
        return self.course.lesson.steps[self.place]

    @property
    def document(self) -> Document:
        return self.own or self.course.shown(self.place).document

    @property
    def asked(self) -> Mapping[str, Asked]:
        return {part.name: part for part in self.step.asked}

    @property
    def idea_names(self) -> Sequence[str]:
        return [step.name for step in ideas().lesson.steps]

    def idea(self, name: str) -> Idea | None:
        return idea_named(name)

    def shown_by(self, state: State) -> Document:
        if not state.begins_anew:
            return self.course.made(state, self.document)
        document = self.course.made(state, None)
        with on_line(state.line):
            scene_of(document)
        return document

    def variant(self, block: Asked, seed: int) -> Variant:
        """Return a block of the step with the numbers of a seed, which are drawn once."""
        kept, key = self.course.variants, (self.place, block.name, seed)
        if key not in kept:
            kept[key] = block.variant(self, seed)
        return kept[key]

    def varied(self, state: State | None, given: Mapping[str, float]) -> "AtStep":
        own = self.document if state is None else self.shown_by(state)
        return AtStep(self.course, self.place, own, given)

    def quantities(self, now: Document | None = None, view: View | None = None) -> Quantities:
        if now is None:
            return self._known
        return Quantities(now, lambda: scene_of(now), view, self._known, self.given)

    @cached_property
    def _known(self) -> Quantities:
        """The quantities of the own state: a question asks for several."""
        own = self.document
        return Quantities(own, lambda: scene_of(own), given=self.given)


def _line_of(field: str, values: Sequence[tuple[int, str]]) -> int:
    """Return the line that set the field named by a refusal, or that names it, or 0."""
    names = field.partition("[")[0], field
    lines = [line for line, text in values if path_of(text) in names or text.strip() == field]
    return (lines or [line for line, text in values if field in text] or [0])[-1]


# --------------------------------------------------------------------------- wrong ideas


@languages.cached
def ideas() -> Course:
    """Return the wrong ideas that the program knows; each is a step of one file."""
    return Course(read(CONTENT / "ideas.md"))


def idea_named(name: str) -> Idea | None:
    for place, step in enumerate(ideas().lesson.steps):
        if step.name == name:
            says = "\n\n".join(part.text for part in step.words)
            return Idea(name, step.title, says, ideas().shown(place).document)
    return None


def name_of(path: Path) -> str:
    """Return the name of a lesson: its own if it comes with the program, else its path."""
    return path.stem if path.parent == CONTENT else os.path.abspath(path)
