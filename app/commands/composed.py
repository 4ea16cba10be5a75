"""The check of pictures by the rules of composition: each step of a lesson or talk, as drawn."""

import math
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from app.commands.arguments import check_drawing, importing
from app.document.document import Document
from app.document.view import PANES
from app.languages import said
from app.lessons.course import Course, scene_of, unnameable
from app.lessons.lesson import Lesson, Step
from app.model.refusal import Refusal, counted

if TYPE_CHECKING:
    from app.drawings.composition import ComposedPicture

SLIDE_PX, SLIDE_HIGH_PX = (1920, 1080), 910
"""A screen of a class, and the height that title and formula leave of it for the picture."""
BESIDE_EQUATION = 0.3  # width of a picture beside an equation, relative to the screen's
SLIDE_EM_PX = 0.034 * SLIDE_PX[1]
PANE_PX, PANE_EM_PX = (580, 660), 15.5  # large pane of a 1366 by 768 window, and the letters there

Measure = Callable[[Document, str, tuple[int, int], float], "list[ComposedPicture]"]


@dataclass
class Composed:
    """How many steps were drawn, and what is wrong with their pictures, a line each."""

    steps: int = 0
    faulty: Counter[str] = field(default_factory=Counter)  # how many steps have each kind of fault
    wrong: list[str] = field(default_factory=list)

    def __str__(self) -> str:
        counts = (self.faulty[kind] for kind in ("crowded", "empty", "hidden", "cut"))
        overlaps, steps = counted(self.faulty["overlap"], "overlap"), counted(self.steps, "step")
        return said("composed", overlaps, *counts, steps)

    def take(self, course: Course, place: int, documents: list[Document], draw: Measure) -> None:
        """Draw a step's states, and add what is wrong with them."""
        lesson, step = course.lesson, course.lesson.steps[place]
        line = step.state.line if step.state is not None else step.line
        where = place_in(lesson, line, place)
        self.steps += 1
        faults, kinds = dict[str, None](), set[str]()
        for document in documents:
            seen = panes_of(document, lesson.is_talk)
            em, screen_px = (SLIDE_EM_PX, SLIDE_PX[1]) if lesson.is_talk else (PANE_EM_PX, None)
            for name in unnameable(document, [*seen] if lesson.is_talk else PANES):
                named = said("view.names has {0}, which no pane draws here.", name)
                faults[f"{where}: {named}"] = None
            for pane, size in seen.items():
                for picture in draw(document, pane, size, em):
                    for kind, fault in faults_in(picture, screen_px):
                        faults[f"{where}, {picture.pane}: {fault}"] = None
                        kinds.add(kind)
        self.wrong += faults
        self.faulty.update(kinds)


def place_in(lesson: Lesson, line: int, place: int) -> str:
    name = lesson.steps[place].name
    return said("{0}: line {1}, step {2} ({3})", lesson.path, line, place + 1, name)


def panes_of(document: Document, is_talk: bool) -> dict[str, tuple[int, int]]:
    """The panes in which a class, or a student, sees a step, with their sizes in pixels."""
    view = document.view
    large = view.large or scene_of(document).leading
    if not is_talk:
        return {large: PANE_PX}
    slide = view.slide or (large,)
    panes = [each for each in slide if each in PANES]
    share = BESIDE_EQUATION if len(panes) < len(slide) else 1.0 / max(1, len(panes))
    return {pane: (round(share * SLIDE_PX[0]), SLIDE_HIGH_PX) for pane in panes}


def faults_in(picture: "ComposedPicture", screen_px: int | None) -> Iterator[tuple[str, str]]:
    """Yield what is wrong with a picture: its kind, and a sentence with its numbers.

    `screen_px` is the height of the screen that a class looks at; None for a window.
    """
    from app.drawings.composition import CAPITAL, FULL, LEAST_AREA, LEAST_FILL, LETTERS, MOST_LABELS

    for one, other in picture.overlaps:
        yield "overlap", said("“{0}” overlaps “{1}”.", one, other)
    if len(picture.labels) > MOST_LABELS:
        yield (
            "crowded",
            said("{0}; at most {1}.", counted(len(picture.labels), "label"), MOST_LABELS),
        )
    if picture.is_empty:
        yield "empty", said("empty-picture", *picture.fill, LEAST_FILL, FULL, LEAST_AREA)
    for text in picture.left_out:
        yield "hidden", said("“{0}” is named and not drawn: there is no place for it.", text)
    for one, other in picture.covered:
        yield "hidden", said("“{0}” lies on the point that “{1}” names.", one, other)
    for text in picture.raw:
        yield "raw", said("“{0}” has an underscore that is not typeset.", text)
    for name, part in picture.outside:
        behind = said("“{0}” lies behind the viewer.", name)
        outside = said("“{0}” lies outside the pane by {1:.1%} of its height.", name, part)
        yield "cut", outside if part < math.inf else behind
    for text in picture.cut:
        yield "cut", said("“{0}” is cut off at the border.", text)
    if screen_px is not None:
        least, most = LETTERS
        for height in {CAPITAL * each.em / screen_px for each in picture.labels}:
            if not least <= height <= most:
                yield "letters", said("capitals", height, least, most)


def measure() -> Measure:
    """Return what measures pictures; a `CliError` if nothing can be drawn here."""
    with importing():
        from app.drawings.composition import measured
    check_drawing()
    return lambda document, pane, size, em: measured(document, scene_of(document), pane, size, em)


def states_of(course: Course, place: int) -> list[Document]:
    """What a step shows, then its predictions, an exercise with its first numbers, and replies."""
    here = course.at(place)
    states = [part.show for part in here.step.parts if part.show is not None]
    posed = [(part.varies, part.variant(here, int(part.varies))) for part in here.step.asked]
    drawn = [variant.here.document for varies, variant in posed if varies]
    replied = [
        variant.here.shown_by(reply.state)
        for _, variant in posed
        for reply in variant.question.replies
        if reply.state is not None
    ]
    return [here.document, *map(here.shown_by, states), *drawn, *replied]


def taken(
    composed: Composed, course: Course, draw: Measure, known: Sequence[Refusal]
) -> list[Refusal]:
    """Measure all steps; return why some cannot be drawn, unless a check knows it already."""
    refused: list[Refusal] = []
    said = {*map(str, known)}
    for place, step in enumerate(course.lesson.steps):
        try:
            composed.take(course, place, states_of(course, place), draw)
        except Refusal as error:
            error = _placed(error, course.lesson, step)
            if str(error) not in said:
                said.add(str(error))
                refused.append(error)
    return refused


def _placed(error: Refusal, lesson: Lesson, step: Step) -> Refusal:
    """Add file and line to a refusal that does not name them."""
    if not error.field.startswith("line "):
        line = step.state.line if step.state is not None else step.line
        error = Refusal.in_document(
            error.bound, *error.limits, field=f"line {line}, {error.field}", value=error.value
        )
    error.file = str(lesson.path)
    return error
