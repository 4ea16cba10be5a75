"""The command line: the window, and the start of the commands.

Every wrong input ends in one sentence on standard error and exit status 2, and a machine that
cannot draw in one sentence and status 3. Only the commands that draw import Qt, VTK and pyvista, so
that the others start fast and on any machine.
"""

import os
import sys
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

from app.commands.arguments import (
    check_out,
    document_before,
    importing,
    load_scene,
    set_letters,
    with_values,
)
from app.commands.options import SUMMARIES, Parser, check_file, choose_language
from app.commands.terminal import CANNOT_DRAW, CliError, outcome, write_out
from app.document.document import is_mesh
from app.lessons.lesson import is_lesson
from app.model.projection import LARGEST_IMAGE_PX
from app.model.refusal import REFUSALS, Refusal


def main(argv: list[str] | None = None) -> int:
    """Run the arguments after the program's name, by default those of this process.

    Return the exit status: 0 done, 1 an incomplete window, 2 bad input, 3 no usable display or
    OpenGL.
    """
    return outcome(lambda: _run(sys.argv[1:] if argv is None else argv))


def _run(arguments: Sequence[str]) -> int:
    choose_language(arguments)
    try:
        if arguments and arguments[0] in SUMMARIES:
            with importing():
                command = import_module(f"{__package__}.{arguments[0]}")
            status: int = command.run(arguments[1:])
            return status
        if arguments:
            # First: the words after a misspelt command do not belong to the window.
            check_file(arguments[0])
        return _window(arguments)
    except Refusal as error:
        raise CliError(str(error)) from error


# --------------------------------------------------------------------------- the window


def _window(arguments: Sequence[str]) -> int:
    options, words = Parser("").read(arguments)
    if options.screenshot is not None:
        if not options.screenshot.lower().endswith(".png"):
            raise CliError("--screenshot = {0!r}: must end in .png.", options.screenshot)
        check_out("--screenshot", options.screenshot, words)
    for name, side in zip(("width", "height"), options.size or (), strict=False):
        if not 1 <= side <= LARGEST_IMAGE_PX:
            bound = REFUSALS["whole-pixels"]
            raise CliError(f"--{Refusal(f'size {name}', side, bound, LARGEST_IMAGE_PX)}")
    file = words[0] if words else None
    lesson = file is not None and is_lesson(file)
    if lesson and options.set:
        given = options.set[0]
        raise CliError("--set {0}: {1} is a lesson, whose steps set what is shown.", given, file)
    is_bare = not words and not options.set
    letters = set_letters(options)
    saved = document_before(file, options.set)
    document = with_values(saved, options.set)
    from_file = is_mesh(document.scene) or document.mesh
    scene = load_scene(document.scene, document.mesh, file) if from_file else None
    with importing():
        from widgets.program import application
        from widgets.program.opengl import DisplayError
        from widgets.window.settings import delete_settings
    if options.reset:
        try:
            write_out([f"{delete_settings()}\n"])
        except OSError as error:
            raise CliError("The settings cannot be deleted: {0}.", error) from error
    path = None if file is None else Path(os.path.abspath(file))
    screenshot = None if options.screenshot is None else Path(options.screenshot)
    window_options = application.Options(
        options.theme, options.size, screenshot, options.canvas, is_bare, letters, options.language
    )
    try:
        if lesson:
            return application.run_window(document, saved, None, window_options, scene, lesson=path)
        return application.run_window(document, saved, path, window_options, scene)
    except DisplayError as error:
        raise CliError(str(error), status=CANNOT_DRAW) from error
