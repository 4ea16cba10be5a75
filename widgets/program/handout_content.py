"""The content of a handout: each step's title, figure, texts, matrices, numbers and questions.

`handout` prints it on A4, `handout_page` writes it for phones.
"""

import os
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from textwrap import wrap
from typing import NamedTuple, TypeAlias

from app.document.document import Document
from app.lecture.equation import equation_of, latex_cell
from app.lecture.notation import matrices
from app.lecture.titles import stage_title
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Lesson, Step
from app.lessons.strokes import answer_picture, picture_beside
from app.lessons.text import escaped
from widgets.controls.readout import full_sentence, value_text
from widgets.panels.matrix_panel import note_on
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import of_phenomena, read_text
from widgets.parts.typeset import matrix

NOTE_CHARACTERS = 36  # line length of a matrix's note, so that it is not wider than the matrix


class ToWrite:
    """Room for an answer."""


class Heading(NamedTuple):
    text: str


class StepFigure(NamedTuple):
    """A state, with the texts that belong beside it."""

    document: Document
    texts: list[str]
    note: str = ""  # for the teacher
    slide: Path | None = None
    """The file of a picture of the slide on which somebody has drawn, instead of the figure."""
    has_question: bool = False  # whether students are to answer a question about it


class EquationTables(NamedTuple):
    """The matrices of a slide that is an equation, each as Markdown."""

    tables: list[str]


class PanelNumbers(NamedTuple):
    """The numbers of a panel: Markdown, and what is typeset."""

    texts: list[str]
    formulas: list[str]


Content: TypeAlias = Heading | StepFigure | EquationTables | PanelNumbers | ToWrite | str
"""Or Markdown."""


def planned(lesson: Lesson) -> str:
    """Return the minutes of a talk, if its author has planned them."""
    minutes = lesson.minutes or sum(
        step.note.minutes for step in lesson.steps if step.note is not None
    )
    return f"{minutes:g} min" if minutes else ""


def contents(course: Course, place: int, answers: bool) -> Iterator[Content]:
    """Yield what is handed out of a step; a `Refusal` if its state is impossible."""
    step = course.lesson.steps[place]
    counted = f"{place + 1}. " if len(course.lesson.steps) > 1 else ""
    yield Heading(counted + step.title)
    shown, here = course.shown(place).document, course.at(place)
    asked = [part.variant(here, 1) for part in step.asked]
    texts = [part.text for part in step.parts if part not in step.asked]
    note, slide = _note(step) if answers else "", _drawn_on(course, step.name)
    yield StepFigure(shown, texts, note, slide, has_question=bool(asked) and not answers)
    if not any("\n|" in part.text for part in step.parts if not part.reveals):
        yield EquationTables(list(_equation(shown)))
    if "equation" not in shown.view.slide:  # else it has its matrices
        yield _panel(shown, course.shown(place - 1).document if place else None)
    number = 0
    for block, (_, _, part, own) in zip(step.asked, asked, strict=True):
        text = part.with_answer(answer_of(part, own)) if answers else part.posed()
        is_own = own.document != shown and block.hides <= {"numbers", "lens"}
        yield StepFigure(own.document, [text], has_question=not answers) if is_own else text
        if not answers:
            yield ToWrite()
            continue
        whys = [part.why] if part.why else []
        if part.show is not None:
            after = own.shown_by(part.show)
            number += part.reveals
            drawn_on = _drawn_on(course, answer_picture(step.name, number))
            yield StepFigure(after, whys, slide=drawn_on)
            if "equation" not in after.view.slide:
                yield _panel(after, shown)
            elif after.view.equation != shown.view.equation:
                yield EquationTables(list(_equation(after)))
        else:
            yield from whys


def _drawn_on(course: Course, picture: str) -> Path | None:
    """The kept slide with its strokes, if there is one."""
    slide = picture_beside(course.lesson.path, picture)
    return slide if os.path.isfile(slide) else None


def _note(step: Step) -> str:
    """The note for the teacher, with the planned minutes."""
    if step.note is None:
        return ""
    minutes = f"*{step.note.minutes:g} min.* " if step.note.minutes else ""
    return minutes + step.note.text


def _equation(document: Document) -> Iterator[str]:
    """Yield each matrix of a slide that is an equation, as Markdown."""
    view = document.view
    if "equation" not in view.slide:
        return
    shown = equation_of(document.projection, view.letters, view.equation, document.settings)
    for term in shown.terms:
        cells = [[f"${latex_cell(cell, term.letters)}$" for cell in row]
                 for row in term.matrix.formulas]  # fmt: skip
        if shown.is_in_numbers:
            cells = [[read_text(value) for value in row] for row in term.matrix.values]
        parts = shown.factors if shown.factors and term is shown.result else (term,)
        if all(each.name for each in parts):
            above = f"${' '.join(each.name for each in parts)}$"
        else:
            above = " · ".join(f"({stage_title(each.matrix.name)})" for each in parts)
        lines = [f"{above} =", "", "| | | | |", "|---|---|---|---|"]
        lines += [f"| {' | '.join(row)} |" for row in cells]
        yield "\n".join(lines)


def _panel(document: Document, before: Document | None) -> PanelNumbers:
    """Return the numbers of the open panel, unless they are the same as in the state before."""
    view = document.view
    seen = None if before is None else (before, before.view.panel, before.view.letters)
    if seen == (document, view.panel, view.letters) or view.panel not in ("matrices", "scene"):
        return PanelNumbers([], [])
    if view.panel == "matrices":
        return PanelNumbers([], list(_matrices(document)))
    return _readout(document)


def _matrices(document: Document) -> Iterator[str]:
    """Yield each matrix below its name, with its note."""
    for each in matrices(document.projection, document.view.letters):
        name = stage_title(each.name)
        lines = [f"{name} = {each.called}" if each.called else name]
        lines.append(matrix([read_text(value) for value in row] for row in each.values))
        for line in note_on(each, document.projection, document.view.letters).splitlines():
            lines += wrap(line, NOTE_CHARACTERS, break_on_hyphens=False)
        yield "\n".join(lines)


def _readout(document: Document) -> PanelNumbers:
    """The scene's numbers, except the one counted in the window's own picture."""
    shown = scene_of(document).illustration(document.projection, document.settings)
    numbers = PanelNumbers([], [])
    if shown is None:
        return numbers
    said = partial(of_phenomena, letters=document.view.letters)
    rows, reasons = ["| | |", "|---|---:|"], list[str]()
    for each in shown.readings:
        if each.counted:
            continue
        label = said(each.label)
        value = (
            said(each.value) if isinstance(each.value, str) else value_text(each.value, read_text)
        )
        if value.startswith("["):
            numbers.formulas.append(f"{label}\n{value}")
            continue
        unit = said(each.unit) if each.unit and each.value is not None else ""
        cells = (escaped(text.replace("\n", " ")) for text in (label, f"{value} {unit}".strip()))
        rows.append(f"| {' | '.join(cells)} |")
        if each.note is not None:
            reasons.append(full_sentence(each.note.sentence(said, read_text)))
    if len(rows) > 2:
        numbers.texts.append("\n".join(rows))
    numbers.texts.extend(map(escaped, dict.fromkeys(reasons)))
    return numbers
