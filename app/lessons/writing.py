"""Write a state into a lesson's file as a new step, with as few assignments as possible.

The teacher's text stays unchanged, byte for byte. The step is inserted only where all other steps
still show the same.
"""

import codecs
import contextlib
import json
import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from app.document.codec import Path as AnyPath
from app.document.codec import to_json
from app.document.document import Document, is_mesh
from app.document.files import blamed_on, write, write_bytes_atomically
from app.document.settings import picture_text, set_values
from app.document.view import AS_EVER
from app.lecture.letters import LETTERS, Letters
from app.lessons.contents import CONTENT
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Lesson, ends, parse_lesson, read, slug
from app.model.refusal import REFUSALS, Refusal
from app.scenes.phenomena import PHENOMENA
from app.strangers import decode

NEW_TALK_MINUTES = 2  # planned minutes for the first step of a talk, until the teacher changes them


# --------------------------------------------------------------------------- state to text


def assignments(document: Document, letters: Letters | None = None) -> list[str]:
    """Return the shortest list of ``NAME=VALUE`` that turns the scene as it opens into a document.

    ``scene=`` comes first, then ``mesh=``. Cameras of panes and pins are not part of a state, and
    the lesson's own `letters` are omitted. A `Refusal` if no list reproduces the document to the
    last bit.
    """
    wanted = _as_state(document)
    view = replace(AS_EVER, letters=letters or AS_EVER.letters)
    start = Document(document.scene, scene_of(document).start, view=view, mesh=document.mesh)
    lists = [
        texts for texts in _lists(start, wanted)
        if _gives(start, texts, wanted) and "\n" not in "".join(texts.values())
    ]  # fmt: skip
    if not lists:
        raise Refusal.in_document(REFUSALS["not-in-words"], field="state")
    texts = min((_needed(start, each, wanted) for each in lists), key=len)
    first = {"scene": document.scene} | ({"mesh": document.mesh} if document.mesh else {})
    return [f"{path}={text}" for path, text in (first | texts).items()]


def changes(before: Document, after: Document) -> list[str]:
    """Return the assignments that turn one document into another, as in a sample of a task."""
    given, texts = _texts(before), _texts(after)
    lines = [f"scene={after.scene}"] if after.scene != before.scene else []
    lines += [
        f"{path}={text}"
        for path, text in texts.items()
        if given.get(path) != text and " " not in text  # a sample separates them by spaces
    ]
    turned = [name for name, camera in after.view.panes.items()
              if before.view.panes.get(name) != camera]  # fmt: skip
    return [*lines, *([f"view.panes={','.join(turned)}"] if turned else [])]


def _as_state(document: Document) -> Document:
    """Return a document with only those parts of its view that belong to a state."""
    view = replace(document.view, panes={}, pinned=frozenset())
    if view.panel != "frame":  # the step of the frame is not visible
        view = replace(view, frame_step=AS_EVER.frame_step)
    return replace(document, view=view)


def _texts(document: Document) -> dict[str, str]:
    """Return the values of a document that ``--set`` accepts, by path."""
    tree = json.loads(to_json(document))
    texts = {"depth": str(tree["depth"])}
    for section in ("lens", "camera", "object", "image", "quality", "settings"):
        for key, value in tree.get(section, {}).items():
            is_chain = (section, key) == ("object", "chain")
            texts[f"{section}.{key}"] = "; ".join(value) if is_chain else _text(value)
    ever = {"layout": "pictures", "large": "", "stage": "ndc", "letters": "own", "layers": "",
            "fixed": ""}  # fmt: skip
    texts |= {f"view.{key}": text for key, text in ever.items()}
    texts |= {f"view.{key}": _text(value) for key, value in tree.get("view", {}).items()}
    pictures = document.view.compare
    if pictures:
        phenomenon = PHENOMENA.get(document.scene)
        names = [picture.name for picture in pictures]
        ready = [
            each.name
            for each in (phenomenon.words.comparisons if phenomenon else ())
            if [picture[0] for picture in each.pictures] == names
        ]
        others = [picture_text(each) for each in pictures if each.changes]
        texts["view.compare"] = ready[0] if ready else "|".join(others)
    return texts


def _text(value: object) -> str:
    """Write a JSON value for ``--set``; not every value can be read back."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return ",".join(map(_text, value))
    return value if isinstance(value, str) else repr(value)


def _lists(start: Document, wanted: Document) -> Iterator[dict[str, str]]:
    """Yield candidate lists: the values that differ after the settings are set, and all values.

    Camera and lens may follow the settings, or a setting may follow the lens; then only one list
    works.
    """
    before, texts = _texts(start), _texts(wanted)
    settings = {
        path: text
        for path, text in texts.items()
        if path.startswith("settings.") and before[path] != text
    }
    with contextlib.suppress(Refusal):  # a scene may refuse some of them without the others
        after = _texts(set_values(start, (f"{path}={text}" for path, text in settings.items())))
        yield settings | {path: text for path, text in texts.items() if after.get(path) != text}
    yield texts


def _needed(start: Document, texts: dict[str, str], wanted: Document) -> dict[str, str]:
    """Drop the entries of a list without which the result is the same."""
    for path in [*texts]:
        fewer = {name: text for name, text in texts.items() if name != path}
        if _gives(start, fewer, wanted):
            texts = fewer
    return texts


def _gives(start: Document, texts: Mapping[str, str], wanted: Document) -> bool:
    try:
        made = set_values(start, (f"{path}={text}" for path, text in texts.items()))
    except Refusal:  # these values do not produce that state
        return False
    return to_json(made) == to_json(wanted)  # as text: also a zero's sign


# --------------------------------------------------------------------------- into a file


class Added(NamedTuple):
    """The new step; its place counts from 0."""

    name: str
    place: int


def add_step(
    path: AnyPath, after: str, title: str, document: Document, *, panes: bool = False
) -> Added:
    """Write a state as a new step into a lesson's file, as the file is now.

    The step comes after the named one, or at the end if that is gone; but always after the steps
    whose state it would change.

    `after` is the name of a step. With `panes` the step keeps how the panes are turned, which needs
    a document beside the file. If that is impossible, a `Refusal` leaves the file unchanged.
    """
    _check_own(path)
    before = read(path)
    with blamed_on(path, REFUSALS["files-unreadable"]):
        content = Path(path).read_bytes()
        mark, text = content.startswith(codecs.BOM_UTF8) * codecs.BOM_UTF8, decode(content)[0]
        names = [step.name for step in before.steps]
        name = _free(slug(title), names.__contains__)
        step = _step(before, title, name, document, panes)
        place = names.index(after) if after in names else len(names) - 1
        while True:
            added = _with_lines(text, ends(text)[place], ["---", *step.lines])
            lesson = parse_lesson(added, before.path)
            place += 1
            if _following(before, place) == _following(lesson, place + 1):
                break
        step.keep(document)
        write_bytes_atomically(path, mark + added.encode())
    return Added(name, place)


def begin_talk(path: AnyPath, title: str, document: Document, *, panes: bool = False) -> None:
    """Begin a talk with a state, in a new file or over an old one; see `add_step`."""
    _check_own(path)
    with blamed_on(path, REFUSALS["files-unreadable"]):
        given = document.view.letters
        letters = given if given in LETTERS else None  # those of a file go with the document
        line = [f"letters: {letters}"] if letters else []
        top = ["---", f"title: {_one_line(title)}", *line, "---"]
        lesson = Lesson(Path(path), title, (), letters=letters)
        step = _step(lesson, title, slug(title), document, panes)
        note = ["", "```note", f"minutes: {NEW_TALK_MINUTES}", "```"]
        text = "\n".join([*top, *step.lines, *note, ""])
        parse_lesson(text, Path(path))
        step.keep(document)
        write_bytes_atomically(path, text.encode())


def _check_own(path: AnyPath) -> None:
    if Path(os.path.realpath(path)).is_relative_to(os.path.realpath(CONTENT)):
        error = Refusal.in_document(REFUSALS["ours"])
        error.file = os.fspath(path)
        raise error


class _NewStep(NamedTuple):
    """The lines of a new step, and the document file that it needs."""

    lines: list[str]
    beside: Path | None

    def keep(self, document: Document) -> None:
        if self.beside is not None:
            write(document, self.beside)


def _step(lesson: Lesson, title: str, name: str, document: Document, panes: bool) -> _NewStep:
    folder = Path(os.path.realpath(lesson.path)).parent
    for key in ("scene", "mesh"):
        file = getattr(document, key)
        if is_mesh(file):
            _beside(file, folder, key)
    beside = None
    try:
        if panes and document.view.panes:
            raise Refusal.in_document(REFUSALS["not-in-words"], field="view.panes")
        values = [_named(text, folder) for text in assignments(document, lesson.letters)]
    except Refusal as error:
        if error.bound != REFUSALS["not-in-words"]:
            raise
        stem = f"{lesson.path.stem}-{name}"
        beside = folder / _free(stem, lambda each: os.path.lexists(folder / each), ".json")
        values = [f"document: {beside.name}"]
    return _NewStep([f"# {_one_line(title)} {{#{name}}}", "```state", *values, "```"], beside)


def _one_line(title: str) -> str:
    words = " ".join(title.split())
    if not words or not words.isprintable():
        raise Refusal.in_document(REFUSALS["a-title"], field="title", value=title[:60])
    return words


def _named(assignment: str, folder: Path) -> str:
    """Return an assignment with a mesh path relative to the lesson's folder."""
    path, _, value = assignment.partition("=")
    if path in ("scene", "mesh") and is_mesh(value):
        return f"{path}={_beside(value, folder, path)}"
    return assignment


def _beside(file: str, folder: Path, field: str) -> str:
    real = Path(os.path.realpath(file))
    if not real.is_relative_to(folder):
        raise Refusal.in_document(REFUSALS["beside"], field=field, value=os.path.basename(file))
    return real.relative_to(folder).as_posix()


def _free(name: str, is_taken: Callable[[str], bool], ending: str = "") -> str:
    """Return a name, with a number appended if it is taken."""
    number, free = 1, name + ending
    while is_taken(free):
        number += 1
        free = f"{name}-{number}{ending}"
    return free


def _with_lines(text: str, end: int, step: Sequence[str]) -> str:
    """Insert lines after line `end` of a text; keep all its bytes."""
    line_end = next((each for each in ("\r\n", "\n", "\r") if each in text), "\n")
    lines = re.split(r"(?<=\n)|(?<=\r)(?!\n)", text)
    head, tail = "".join(lines[:end]), "".join(lines[end:])
    if not head.endswith(("\n", "\r")):
        head += line_end
    blank = not lines[end - 1].strip() and bool(tail)
    added = [*([] if blank else [""]), *step, *([""] if tail else [])]
    return head + "".join(line + line_end for line in added) + tail


def _following(lesson: Lesson, place: int) -> list[Document | str]:
    """Return the states of the steps that continue the one before a place."""
    course = Course(lesson)
    states: list[Document | str] = []
    for number, step in enumerate(lesson.steps[place:], place):
        if step.state is not None and step.state.begins_anew:
            break
        try:
            states.append(course.shown(number).document)
        except Refusal as error:
            states.append(str(error.bound))  # it is faulty before and after
    return states
