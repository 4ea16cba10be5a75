"""Open the documents and scenes of commands, and apply the values of ``--set``.

VTK is imported only when a scene is loaded.
"""

import argparse
import atexit
import contextlib
import functools
import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from app import bootstrap, python_packages, system_packages
from app.commands.options import check_file
from app.commands.terminal import CANNOT_DRAW, CliError, print_error
from app.document.document import Document, is_mesh
from app.document.files import blamed_on, read_letters
from app.document.settings import open_with, set_values
from app.document.view import View
from app.languages import said
from app.lecture.letters import LETTERS, Letters
from app.lessons.lesson import is_lesson
from app.model.refusal import REFUSALS, Refusal, nearest
from app.scenes.phenomena import PHENOMENA

if TYPE_CHECKING:
    from app.lessons.course import Course
    from app.scenes.scene import Scene


def document_of(file: str | None, assignments: Sequence[str], step: str | None = None) -> Document:
    return with_values(document_before(file, assignments, step), assignments)


def set_letters(options: argparse.Namespace) -> Letters | None:
    """Return what ``--letters`` asks for, of a lecture or a file, and make it a ``--set``."""
    letters: Letters | None = options.letters
    if letters is not None and letters not in LETTERS:
        letters = read_letters(full_path(letters))
    if letters is not None:
        options.set = [*vars(options).get("set", ()), f"view.letters={letters}"]
    return letters


def course_of(lesson: str) -> "Course":
    from app.lessons.course import Course
    from app.lessons.lesson import read as read_lesson

    return Course(read_lesson(full_path(lesson)))


def place_of(course: "Course", step: str | None) -> int:
    """Return the place, from 0, of a step that ``--step`` names or counts; the first without."""
    if step is None:
        return 0
    names = [each.name for each in course.lesson.steps]
    if step in names:
        return names.index(step)
    if not re.fullmatch("[0-9]{1,4}", step) or not 1 <= int(step) <= len(names):
        near = "" if step.isdigit() else said("; the nearest is {0}", nearest(step, names))
        raise CliError("step", step, len(names), near)
    return int(step) - 1


def state_at(course: "Course", place: int) -> Document:
    """Return a step's document; a refusal names the lesson's file."""
    with blamed_on(course.lesson.path, REFUSALS["files-unreadable"]):
        return course.shown(place).document


def document_before(
    file: str | None, assignments: Sequence[str], step: str | None = None
) -> Document:
    """Return the document of a FILE (a document, picture or mesh) before ``--set``.

    With a step, FILE is a lesson or a talk. Without a FILE, ``scene=NAME`` opens that scene with
    its own camera, as the menu does.
    """
    scene = set_texts(assignments).get("scene")
    if step is not None and file is None:
        raise CliError("--step: needs a lesson or a talk as FILE.")
    if file is not None and (step is not None or is_lesson(file)):
        if scene:
            raise CliError("--set scene: the steps of a lesson have scenes of their own.")
        course = course_of(file)
        return state_at(course, place_of(course, step))
    before = Document() if scene is None else _opened(scene)
    return before if file is None else _open(file, before, assignments)


def with_values(document: Document, assignments: Sequence[str]) -> Document:
    """Return a document with the values of ``--set``; a refusal names the value that was set."""
    texts = set_texts(assignments)
    try:
        return set_values(document, assignments)
    except Refusal as error:
        # The model says "target must differ from the eye" whichever of the two was set.
        if (
            error.bound != REFUSALS["not-the-eye"]
            or "camera.eye" not in texts
            or error.field in texts
        ):
            raise
        raise Refusal.in_document(
            REFUSALS["not-the-target"], field="camera.eye", value=error.value
        ) from error


def set_texts(assignments: Iterable[str]) -> dict[str, str]:
    parts = (assignment.partition("=") for assignment in assignments)
    return {key.strip(): text.strip() for key, _, text in parts}


def full_path(name: str) -> str:
    """Return a file's absolute path; raise a `CliError` if the current folder was deleted."""
    try:
        return os.path.abspath(name)
    except FileNotFoundError as error:
        raise CliError("{0!r} is in the current folder, which was deleted.", name) from error


def check_out(name: str, out: str, inputs: Iterable[str] = ()) -> None:
    """Refuse a file that cannot be written, as far as one can tell before anything is computed."""
    if os.path.exists(out) and any(os.path.exists(i) and os.path.samefile(out, i) for i in inputs):
        raise CliError("{0} = {1!r}: is read by this command; write to another file.", name, out)
    if os.path.isdir(out):
        raise CliError("{0} = {1!r}: is a folder.", name, out)
    needed = [out] if os.path.exists(out) else []
    if needed and not os.path.isfile(out):
        raise CliError("{0} = {1!r}: is a pipe or a device, not a regular file.", name, out)
    folder = os.path.dirname(os.path.realpath(full_path(out)))
    if not os.path.isdir(folder):
        raise CliError("no-folder", name, out, os.path.dirname(out) or folder)
    needed.append(folder)
    if not all(os.access(place, os.W_OK) for place in needed):
        raise CliError("{0} = {1!r}: may not be written.", name, out)


def _opened(scene: str) -> Document:
    """Return a scene with its own camera; phenomena need not be loaded for that."""
    if scene in PHENOMENA:
        phenomenon = PHENOMENA[scene]
        return Document(scene, phenomenon.start, view=View(fixed=phenomenon.fixed))
    name = full_path(scene) if is_mesh(scene) else scene
    return Document(name, load_scene(name).start, view=View(fixed=""))


def _open(file: str, over: Document, assignments: Sequence[str]) -> Document:
    if is_mesh(file):
        return _opened(file)
    check_file(file)
    return open_with(file, over, assignments)


def load_scene(scene: str, mesh: str = "", file: str | None = None) -> "Scene":
    """Load a scene once; raise a `CliError` that names `file`, if any, when that fails."""
    with importing():
        from app.scenes.scene import load
    try:
        return _load_once(load, scene, mesh)
    except Refusal as error:
        asked = "" if file is None or is_mesh(file) else f"{file}: "
        raise CliError(f"{asked}{error}") from error


@functools.lru_cache(maxsize=8)  # of a list of large meshes not all
def _load_once(load: "Callable[..., Scene]", scene: str, mesh: str) -> "Scene":
    loaded = load(scene, mesh=mesh)
    for note in loaded.notes:
        print_error(str(note), 0)
    return loaded


# pyvista's meshes need its modules when they are deleted, and Python clears modules at its end.
atexit.register(_load_once.cache_clear)


@contextlib.contextmanager
def importing() -> Iterator[None]:
    """Import libraries in this block, or raise a `CliError` with what is missing."""
    try:
        with python_packages.for_good():
            yield
    except ImportError as error:
        missing = system_packages.missing_system("window")
        text = said("library-not-loaded", error, bootstrap.PROGRAM)
        text = f"{system_packages.advice(missing)}." if missing else text
        raise CliError(text, status=CANNOT_DRAW) from error


@functools.cache
def check_drawing() -> None:
    """Import what draws; raise a `CliError` if VTK cannot draw without a window, nor through Qt."""
    with importing():
        from app.drawings import compared_figures, figure_files  # noqa: F401
        from app.drawings.off_screen import check_off_screen
    try:
        check_off_screen()
    except RuntimeError as error:
        try:
            if sys.platform != "win32":
                raise
            from widgets.program.opengl import draw_through_qt

            draw_through_qt()
        except RuntimeError as last:
            raise CliError(str(last), status=CANNOT_DRAW) from error
