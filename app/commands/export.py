"""The command ``export``: a figure, the figures of a list, or a film."""

import argparse
import os
import re
import sys
from collections.abc import Iterator, Sequence
from functools import partial
from typing import TypeVar

from app.commands import batch, page, sweep
from app.commands.arguments import (
    check_drawing,
    check_out,
    document_before,
    document_of,
    importing,
    load_scene,
    set_letters,
)
from app.commands.options import Parser
from app.commands.terminal import CliError, print_error
from app.document.document import Document
from app.document.files import blamed_on
from app.document.view import PANES
from app.drawings.figure import ENDINGS, Figure
from app.drawings.film import FILMS, write_film, write_frames
from app.languages import said
from app.lessons.lesson import is_lesson
from app.model.refusal import REFUSALS, Refusal
from app.scenes.scene import Scene

_Frame = TypeVar("_Frame")

_OPTIONS = {"text size": "--text-size", "pane": "--panes", "scale": "--scale"}  # as a refusal names
_OF_BATCH, _OF_FILMS = ("resume", "format"), ("frames", "fps", "loop")


def run(arguments: Sequence[str]) -> int:
    """Draw the figures that the arguments ask for; return the exit status."""
    options, (out, *files) = Parser("export").read(arguments)
    motions = sweep.motions(options)
    if motions and (len(motions) > 1 or options.batch is not None):
        raise CliError("--{0}: cannot be used with --{1}.", motions[0], (*motions, "batch")[1])
    if options.batch is not None:
        if options.step is not None:
            raise CliError("--step: is a column of the list of --batch.")
        return batch.run(options, out, files, _draw)
    moving = said("{0} or {1}", "--sweep, --orbit, --stages", "--transition")
    for names, needed in ((_OF_BATCH, "--batch"), (() if motions else _OF_FILMS, moving)):
        for option in names:
            if sweep.is_given(options, option):
                raise CliError("--{0}: needs {1}.", option, needed)
    if not options.sweep and (options.show_value or options.ease != "linear"):
        raise CliError("--{0}: needs --sweep.", "show-value" if options.show_value else "ease")
    draw = _draw_moving if motions else _draw
    if _ending(out) == ".html":
        draw = _draw_page
    warning = draw(options, out, files[0] if files else None)
    if warning:
        print_error(warning, 0)
    return 0


def _draw(options: argparse.Namespace, out: str, file: str | None) -> str:
    """Write a figure; return what is incomplete in it, in one sentence, or nothing."""
    _choose_panes(options, file)
    _check(options, out, file, ENDINGS)
    document = document_of(file, options.set, options.step)
    scene = load_scene(document.scene, document.mesh, file)
    warning = _warning(document, scene)  # or a `Refusal`, before any drawing
    figure = _figure(options, scene, document)
    check_drawing()
    figure.save(out)
    return warning


def _draw_moving(options: argparse.Namespace, out: str, file: str | None) -> str:
    """Draw a film, written whole or not at all, or a figure for each frame."""
    _choose_panes(options, file)
    options.loop = options.loop or sweep.usual_loop(options, numbered=bool(sweep.names(out, 1)))
    order, _ = sweep.order(options), sweep.speed(options)
    names = sweep.names(out, len(order))
    for name in names or [out]:
        _check(options, name, file, ENDINGS if names else FILMS)
    if not names and (options.crop or options.width is not None):
        option = "crop" if options.crop else "width"
        raise CliError("--{0}: is for single figures; frames of a film have one size.", option)
    if options.transparent and _ending(out) in (".gif", ".mp4"):
        is_gif = _ending(out) == ".gif"
        lack = said("no smooth edges then") if is_gif else said("no transparency")
        raise CliError("--transparent: {0} has {1}; write .apng or .webp.", _ending(out), lack)
    states = sweep.states(options, file)
    scene = load_scene(states[0].scene, states[0].mesh, file)
    warnings = [_warning(state, scene) for state in states]
    figures = [_figure(options, scene, state) for state in states]
    if not names:
        _check_film(options, out, {figure.size_px for figure in figures})
    check_drawing()
    figures = sweep.with_views(options, file, figures)
    figures = sweep.steady(options, figures, fades=True)
    if names:
        write_frames(names, figures, order, _with_progress)
    else:
        with blamed_on(out, REFUSALS["unwritable"]):
            once, fps = options.loop == "once", sweep.speed(options)
            write_film(out, figures, order, fps, once, _with_progress)
    return next(filter(None, warnings), "")


def _draw_page(options: argparse.Namespace, out: str, file: str | None) -> str:
    _choose_panes(options, file)
    _check(options, out, file, (".html",))
    page.check(options)
    asked = page.asked(options)
    states = sweep.states(asked, file)
    scene = load_scene(states[0].scene, states[0].mesh, file)
    warnings = [_warning(state, scene) for state in states]
    alone = partial(_figure, options, scene)
    panes = sweep.panes(options)
    figures = {pane: [alone(state, pane) for state in states] for pane in panes}
    check_drawing()
    moving = figures["world" if "world" in panes else panes[0]]
    states = [figure.document for figure in sweep.with_views(asked, file, moving)]
    large = page.write(options, out, _with_progress, states, scene, alone)
    return next(filter(None, [large, *warnings]), "")


def _choose_panes(options: argparse.Namespace, file: str | None) -> None:
    """Take all panes where none is asked for, and of a lesson's step those that a class sees."""
    set_letters(options)
    if options.panes is not None:
        return
    panes: Sequence[str] = PANES
    is_step = file is not None and (options.step is not None or is_lesson(file))
    if is_step and not options.stages and options.orbit is None:
        with importing():
            from app.lessons.course import panes_of
        document = document_before(file, options.set, options.step)
        panes = ["equation"] if document.view.slide == ("equation",) else panes_of(document)
    options.panes = ",".join(panes)
    if any(re.match(r"\s*view\.equation\s*=\s*\S", each) for each in options.set):
        options.panes = "equation"


def _check(options: argparse.Namespace, out: str, file: str | None, endings: Sequence[str]) -> None:
    """Refuse options that do not fit one another, before anything is loaded."""
    ending = _ending(out)
    if ending not in endings:
        film = said(", or have one number such as %03d") if endings is FILMS else ""
        if ending in FILMS and not options.batch:
            film = said("; for a film add --sweep, --orbit, --stages or --transition")
        known = said("{0} or {1}", ", ".join(endings[:-1]), endings[-1])
        if endings is ENDINGS and not options.batch:
            known += said(", or in .html for a page")
        raise CliError("OUT = {0!r}: must end in {1}{2}.", out, known, film)
    has_pixels = ending not in (*ENDINGS[1:], ".html")
    if not has_pixels and options.scale != 1.0:
        raise CliError("--scale: is for .png; shapes are as fine at every scale.")
    if has_pixels and options.hidden:
        raise CliError("--hidden: is for .svg, .pdf, .tex and .html, whose lines are shapes.")
    if options.width is not None and (options.size or options.crop):
        raise CliError("--width: is cropped, and its height is free; leave out --size and --crop.")
    if "/" in options.panes and "," in options.panes:
        raise CliError("--panes = {0!r}: must be a row or a column, not both.", options.panes)
    check_out("OUT", out, [file] if file else [])


def _check_film(options: argparse.Namespace, out: str, sizes: set[tuple[int, int]]) -> None:
    """Refuse sizes that a film cannot have, and then a machine that cannot encode it."""
    with importing():
        from app.drawings.moving import WEBP_PX, program
    if len(sizes) > 1:
        motion = sweep.motions(options)[0]
        raise CliError("--{0}: frames of a film have one size; set --size.", motion)
    (size,) = sizes
    if _ending(out) == ".webp" and max(size) > WEBP_PX:
        raise CliError("OUT = {0!r}: .webp has at most {1} pixels along each side.", out, WEBP_PX)
    if _ending(out) == ".mp4":
        if size[0] % 2 or size[1] % 2:
            raise CliError("even-sides", out, "x".join(map(str, size)))
        with blamed_on(out, REFUSALS["unwritable"]):
            program()


def _ending(out: str) -> str:
    return os.path.splitext(out)[1].lower()


# --------------------------------------------------------------------------- drawing


def _figure(
    options: argparse.Namespace, scene: Scene, document: Document, pane: str = ""
) -> Figure:
    """Return the figure of all panes, or of one; a refusal names the option that it is about."""
    panes = [pane] if pane else sweep.panes(options)
    try:
        return Figure(
            document, scene, panes, options.size, options.scale, "/" in options.panes and not pane,
            options.text_size, options.palette, options.hidden or "none", options.crop,
            options.transparent, width=options.width, fit=options.fit,
        )  # fmt: skip
    except Refusal as error:
        asked = "size" if options.size else "" if options.width is None else "width"
        of_size = asked and str(error).startswith(("width", "height"))
        option = _OPTIONS.get(error.bound.partition(" = ")[0])
        text = f"{option} = {str(error).partition(' = ')[2]}" if option else str(error)
        named = f"--{asked} {text.removeprefix('width ') if asked == 'width' else text}"
        raise CliError(named if of_size else text) from error


def _with_progress(frames: Sequence[_Frame]) -> Iterator[_Frame]:
    """Yield each frame, and tell a terminal how many there are."""
    terminal = sys.stderr if sys.stderr is not None and sys.stderr.isatty() else None
    try:
        for number, frame in enumerate(frames, 1):
            if terminal is not None:
                text = said("frame {0}/{1}", number, len(frames))
                print(f"\r{text}", end="", file=terminal, flush=True)
            yield frame
    finally:
        if terminal is not None:
            print(file=terminal)


def _warning(document: Document, scene: Scene) -> str:
    """Return what a picture lacks that was written all the same."""
    illustration = scene.illustration(document.projection, document.settings)
    warning = None if illustration is None else illustration.warning
    return "" if warning is None else f"{document.scene}: {warning.sentence()}."
