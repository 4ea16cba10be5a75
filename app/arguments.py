"""What the commands share: their words and options, their complaints, and the files they open.

Every wrong input becomes a `CliError` of one sentence. Numbers only: a scene is loaded, and VTK
with it, when it is asked for.
"""

from __future__ import annotations

import argparse
import difflib
import functools
import io
import os
import re
import sys
from collections.abc import Container, Iterable, Sequence
from typing import TYPE_CHECKING, NoReturn, TextIO

from app import bootstrap
from app.document import SETTABLE, Document, DocumentError, is_mesh, read, set_values
from app.phenomena import PHENOMENA
from app.projection import (
    BOTTOM_BEFORE_TOP,
    LEFT_BEFORE_RIGHT,
    NEAR_BEFORE_FAR,
    NOT_THE_EYE,
    Projection,
    format_value,
)
from app.strangers import printable

if TYPE_CHECKING:
    from app.scene import Scene

BAD_INPUT = 2
CANNOT_DRAW = 3
INTERRUPTED = 130

SUMMARIES = {
    "export": "draw a figure into a PNG picture, without a window or display",
    "project": "follow points through every stage of the projection",
    "matrices": "print every stage's matrix",
    "measure": "measure what speed costs in accuracy, here, for a scene and a camera",
    "doctor": "say what this machine has, what is missing and how to get it",
}
"""The words that the command line may begin with, and what each is for."""


class CliError(Exception):
    """One sentence for standard error, and the exit status."""

    def __init__(self, sentence: str, status: int = BAD_INPUT) -> None:
        super().__init__(sentence)
        self.status = status


def complain(sentence: str, status: int) -> int:
    """Write a sentence to standard error, on one line, and give the exit status back."""
    if sys.stderr is not None:
        print(printable(" ".join(sentence.split())), file=sys.stderr)
    return status


def standard_output() -> TextIO:
    """Where the output goes, whose every character can be written there.

    Files and other programs get UTF-8, as the documents are and as TeX and JSON are read, wherever
    it was made; Python would take the locale's, in Windows cp1252, which has no minus sign. What
    shows itself has its own: there a character that it lacks is told by its number.

    Raises
    ------
    CliError
        If it is closed, as in ``pythonw``.
    """
    if sys.stdout is None:
        raise CliError("Standard output is closed.")
    if isinstance(sys.stdout, io.TextIOWrapper):
        encoding = sys.stdout.encoding if sys.stdout.isatty() else "utf-8"
        sys.stdout.reconfigure(encoding=encoding, errors="backslashreplace")
    return sys.stdout


def write_out(texts: Iterable[str]) -> None:
    """Write to standard output, now: an error must come here, not when Python ends."""
    out = standard_output()
    try:
        for text in texts:
            out.write(text)
        out.flush()
    except OSError as error:
        # What is still buffered must not fail once more at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), out.fileno())
        if isinstance(error, BrokenPipeError):
            raise
        raise CliError(f"Standard output cannot be written: {error.strerror}.") from error


# --------------------------------------------------------------------------- options


class Parser(argparse.ArgumentParser):
    """An argument parser whose complaints are sentences, and name the nearest option."""

    def __init__(
        self, command: str, names: str, text: str, description: str, epilog: str = ""
    ) -> None:
        usage = " ".join(f"python3 -m app {command} [options] {names}".split())
        super().__init__(
            usage=usage,
            description=description,
            epilog=epilog,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )
        self._command = command
        self._names = names
        self.add_argument("words", nargs="*", metavar=names, help=text)

    def _print_message(self, message: str, _file: object = None) -> None:
        """Print the help or the version; argparse itself is silent about what fails there."""
        write_out([message])

    def error(self, message: str) -> NoReturn:
        raise CliError(f"{message[0].upper()}{message[1:]}.")

    def read(
        self, arguments: Sequence[str], least: int, most: int
    ) -> tuple[argparse.Namespace, list[str]]:
        """Parse options and words in any order; refuse too few words and too many."""
        # Behind -- all are names; argparse forgets it when options and names may be mixed.
        end = arguments.index("--") if "--" in arguments else len(arguments)
        found, extra = self.parse_known_intermixed_args(arguments[:end])
        for word in extra:
            option = word.partition("=")[0]
            names = [name for action in self._actions for name in action.option_strings]
            where = f"an option of {self._command}" if self._command else "an option of the window"
            raise CliError(f"{option} is not {where}; the nearest is {_nearest(option, names)}.")
        words: list[str] = [*found.words, *arguments[end + 1 :]]
        command = self._command or "The window"
        if "" in words:
            raise CliError(f"{command} was given an empty name.")
        if not least <= len(words) <= most:
            takes = self._names or "no names"
            raise CliError(f"{command} takes {takes}, and {len(words)} names were given.")
        return found, words

    def add_set(self) -> None:
        """Take ``--set``."""
        self.add_argument(
            "--set",
            action="append",
            default=[],
            metavar="NAME=VALUE",
            help="change a value of the document, such as lens.far=inf; may be given repeatedly; "
            f"the names are {', '.join(SETTABLE)} and settings.NAME of the scene's own",
        )

    def add_choice(self, option: str, values: Sequence[str], text: str, default: str = "") -> None:
        """Take one of several values."""
        self.add_argument(
            option,
            type=lambda value: one_of(option, value, values),
            metavar="|".join(values),
            default=default or None,
            help=text,
        )


def _nearest(word: str, known: Iterable[str]) -> str:
    def likeness(name: str) -> float:
        return difflib.SequenceMatcher(None, word.lower(), name).ratio()

    return max(known, key=likeness)


def one_of(option: str, value: str, values: Sequence[str]) -> str:
    """An option's value, which must be one of several."""
    # CliError is none of the errors that argparse would put into words of its own.
    if value not in values:
        raise CliError(f"{option} = {value!r}: must be one of {', '.join(values)}.")
    return value


def parse_number(text: str) -> float:
    """A number in the C locale; not what only Python writes, such as 1_000."""
    if "_" in text:
        raise ValueError(text)
    return float(text)


# --------------------------------------------------------------------------- files


def document_of(file: str | None, assignments: Sequence[str]) -> Document:
    """The document that a FILE is, holds, or opens with, after the values set by ``--set``."""
    return with_values(document_before(file, assignments), assignments)


def document_before(file: str | None, assignments: Sequence[str]) -> Document:
    """The document that a FILE is, holds, or opens with, before the values set by ``--set``.

    Without a FILE, ``scene=NAME`` opens that scene as the menu does: seen with its own camera.
    """
    scene = _texts(assignments).get("scene")
    if file is None:
        return Document() if scene is None else _opened(scene)
    document = _open(file)
    if scene:
        _start(scene)
    return document


def with_values(document: Document, assignments: Sequence[str]) -> Document:
    """A document after the values set by ``--set``, or a complaint that speaks of these."""
    texts = _texts(assignments)
    try:
        return set_values(document, assignments)
    except DocumentError as error:
        raise _seen_from(texts, error) from error


_OTHER_SIDE = {
    ("lens.near", NEAR_BEFORE_FAR): ("lens.far", "must be greater than near, which is {0}"),
    ("lens.left", LEFT_BEFORE_RIGHT): ("lens.right", "must be greater than left, which is {0}"),
    ("lens.bottom", BOTTOM_BEFORE_TOP): ("lens.top", "must be greater than bottom, which is {0}"),
}


def _seen_from(texts: Container[str], error: DocumentError) -> DocumentError:
    """Turn a complaint so that it speaks of what was set.

    The model says "near must be less than far" whichever of the two was set.

    Parameters
    ----------
    texts : container of str
        The paths that were set.
    error : DocumentError
        What the document answered.
    """
    if error.field in texts:
        return error
    if error.bound == NOT_THE_EYE and "camera.eye" in texts:
        bound = "must differ from the target, or the camera looks nowhere"
        return DocumentError(bound, field="camera.eye", value=error.value)
    other, bound = _OTHER_SIDE.get((error.field, error.bound), ("", ""))
    if other in texts:
        (refused,) = error.limits
        return DocumentError(
            bound, format_value(error.value), field=other, value=float(str(refused))
        )
    return error


def _texts(assignments: Iterable[str]) -> dict[str, str]:
    parts = (assignment.partition("=") for assignment in assignments)
    return {key.strip(): text.strip() for key, _, text in parts}


def full_path(name: str) -> str:
    """A file's name with all the folders that it is in.

    Raises
    ------
    CliError
        If it begins in the current folder, and that was deleted.
    """
    try:
        return os.path.abspath(name)
    except FileNotFoundError as error:
        raise CliError(f"{name!r} is in the current folder, which was deleted.") from error


def check_out(name: str, out: str) -> None:
    """Make sure, before anything is computed, that a file can be written, as far as one can tell.

    Raises
    ------
    CliError
        If it cannot.
    """
    if os.path.isdir(out):
        raise CliError(f"{name} = {out!r}: is a folder.")
    needed = [out] if os.path.exists(out) else []
    if not needed or os.path.isfile(out):  # it gives way to a new one; /dev/stdout does not
        folder = os.path.dirname(os.path.realpath(full_path(out)))
        if not os.path.isdir(folder):
            named = os.path.dirname(out) or folder
            raise CliError(f"{name} = {out!r}: there is no folder {named}.")
        needed.append(folder)
    if not all(os.access(place, os.W_OK) for place in needed):
        raise CliError(f"{name} = {out!r}: may not be written.")


def _opened(scene: str) -> Document:
    name = full_path(scene) if is_mesh(scene) else scene
    return Document(name, _start(name))


def _start(scene: str) -> Projection:
    """How a scene opens; only what is no phenomenon has to be loaded for that.

    Raises
    ------
    CliError
        If there is no such scene.
    """
    return PHENOMENA[scene].start if scene in PHENOMENA else load_scene(scene).start


def _open(file: str) -> Document:
    if is_mesh(file):
        return _opened(file)
    check_file(file)
    return read(file)


def check_file(word: str) -> None:
    """Take a word that is no file and looks like none for the command that it was to be.

    Raises
    ------
    CliError
        Naming the nearest command.
    """
    if os.path.lexists(word) or not re.fullmatch(r"\w[\w-]*", word):
        return
    if word in SUMMARIES:
        raise CliError(f"{word} is a command and must come first: python3 -m app {word} ...")
    near = difflib.get_close_matches(word.lower(), SUMMARIES, 1)
    known = f"nearest command is {near[0]}" if near else f"commands are {', '.join(SUMMARIES)}"
    raise CliError(f"{word!r} is neither a file nor a command; the {known}.")


def load_scene(scene: str, mesh: str = "", file: str | None = None) -> Scene:
    """Load a scene once, with VTK's import failing like any other lack of a library.

    Parameters
    ----------
    scene, mesh : str
        As a document names them.
    file : str, optional
        The document, perhaps, that asks for them.
    """
    try:
        with bootstrap.for_good():
            from app.scene import SceneError
    except ImportError as error:
        raise cannot_import(error) from error
    try:
        return _load_once(scene, mesh)
    except SceneError as error:
        asked = "" if file is None or is_mesh(file) else f"{file}: "
        raise CliError(f"{asked}{error}") from error


@functools.cache
def _load_once(scene: str, mesh: str) -> Scene:
    from app.scene import load

    return load(scene, mesh=mesh)


def cannot_import(error: ImportError) -> CliError:
    """What to say of a library that cannot be loaded: what is missing, and how to get it."""
    missing = bootstrap.missing_system("window")
    if missing:
        return CliError(f"{bootstrap.advice(missing)}.", CANNOT_DRAW)
    return CliError(
        f"A library cannot be loaded ({error}); python3 -m app doctor says more.", CANNOT_DRAW
    )
