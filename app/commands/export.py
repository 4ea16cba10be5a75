"""The command ``export``: a figure, the figures of a list, or a moving picture."""

from __future__ import annotations

import argparse
import contextlib
import os
import sys
from collections.abc import Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any, TypeVar

from app.commands import batch, page, sweep
from app.commands.arguments import (
    check_drawing,
    check_out,
    document_before,
    document_of,
    importing,
    load_scene,
)
from app.commands.options import CliError, parser_of, print_error
from app.document.codec import picture_json
from app.document.document import Document
from app.document.files import (
    LARGEST_PICTURE,
    UNWRITABLE,
    blamed_on,
    content_of,
    write_bytes_atomically,
)
from app.document.view import PANES
from app.lessons.lesson import is_lesson
from app.model.refusal import Refusal

if TYPE_CHECKING:
    from app.drawings.off_screen import Pixels
    from app.scenes.scene import Scene

_Frame = TypeVar("_Frame")

_SHAPES = (".svg", ".pdf", ".tex")
_ENDINGS = (".png", *_SHAPES)
_FILMS = (".gif", ".apng", ".webp", ".mp4")
_OF_BATCH, _OF_FILMS = ("resume", "format"), ("frames", "fps", "loop")


def run(arguments: Sequence[str]) -> int:
    """Draw the figures that the arguments ask for; return the exit status."""
    options, (out, *files) = parser_of("export").read(arguments)
    motions = sweep.motions(options)
    if motions and (len(motions) > 1 or options.batch is not None):
        raise CliError(f"--{motions[0]}: cannot be used with --{(*motions, 'batch')[1]}.")
    if options.batch is not None:
        if options.step is not None:
            raise CliError("--step: is a column of the list of --batch.")
        return batch.run(options, out, files, _draw)
    moving = "--sweep, --orbit, --stages or --transition"
    for names, needed in ((_OF_BATCH, "--batch"), (() if motions else _OF_FILMS, moving)):
        for option in names:
            if sweep.is_given(options, option):
                raise CliError(f"--{option}: needs {needed}.")
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
    _check(options, out, _ENDINGS)
    document = document_of(file, options.set, options.step)
    scene = load_scene(document.scene, document.mesh, file)
    warning = _warning(document, scene)  # or a `Refusal`, before any drawing
    _sizes(options, [document], sweep.panes(options))
    check_drawing()
    _write(options, out, document, scene)
    return warning


def _draw_moving(options: argparse.Namespace, out: str, file: str | None) -> str:
    """Draw a moving picture: a film, written whole or not at all, or a figure for each frame."""
    _choose_panes(options, file)
    options.loop = options.loop or sweep.usual_loop(options, numbered=bool(sweep.names(out, 1)))
    order, _ = sweep.order(options), sweep.speed(options)
    names = sweep.names(out, len(order))
    for name in names or [out]:
        _check(options, name, _ENDINGS if names else _FILMS)
    if not names and options.crop:
        raise CliError("--crop: is for single figures; frames of a film have one size.")
    if options.transparent and _ending(out) in (".gif", ".mp4"):
        lack = "no smooth edges then" if _ending(out) == ".gif" else "no transparency"
        raise CliError(f"--transparent: {_ending(out)} has {lack}; write .apng or .webp.")
    states = sweep.states(options, file)
    scene = load_scene(states[0].scene, states[0].mesh, file)
    warnings = [_warning(state, scene) for state in states]
    sizes = _sizes(options, states, sweep.panes(options))
    if not names:
        _check_film(options, out, sizes)
    check_drawing()
    states = sweep.with_views(options, file, states)
    if names:
        first: dict[int, str] = {}
        for name, state in zip(names, _with_progress(order), strict=True):
            if state in first:
                write_bytes_atomically(name, content_of(first[state], LARGEST_PICTURE))
            else:
                first[state] = name
                _write(options, name, states[state], scene)
    else:
        _write_film(options, out, [states[state] for state in order], scene, sizes.pop())
    return next(filter(None, warnings), "")


def _draw_page(options: argparse.Namespace, out: str, file: str | None) -> str:
    """Draw a page for phones, of one state or of a sweep."""
    _choose_panes(options, file)
    _check(options, out, (".html",))
    page.check(options)
    asked = page.asked(options)
    states = sweep.states(asked, file)
    scene = load_scene(states[0].scene, states[0].mesh, file)
    warnings = [_warning(state, scene) for state in states]
    for pane in sweep.panes(options):
        _sizes(options, states, [pane])
    check_drawing()
    states = sweep.with_views(asked, file, states)
    with _of_options(options):
        frames = _with_progress(states)
        large = page.write(options, out, frames, states, scene, partial(_options, options))
    return next(filter(None, [large, *warnings]), "")


def _choose_panes(options: argparse.Namespace, file: str | None) -> None:
    """Take all panes where none is asked for, and of a lesson's step those that a class sees."""
    if options.panes is not None:
        return
    panes: Sequence[str] = PANES
    is_step = file is not None and (options.step is not None or is_lesson(file))
    if is_step and not options.stages and options.orbit is None:
        with importing():
            from app.lessons.course import panes_of
        panes = panes_of(document_before(file, options.set, options.step))
    options.panes = ",".join(panes)


def _check(options: argparse.Namespace, out: str, endings: Sequence[str]) -> None:
    """Refuse options that do not fit one another, before anything is loaded."""
    ending = _ending(out)
    if ending not in endings:
        film = ", or have one number such as %03d" if endings is _FILMS else ""
        if ending in _FILMS and not options.batch:
            film = "; for a film add --sweep, --orbit, --stages or --transition"
        known = f"{', '.join(endings[:-1])} or {endings[-1]}"
        if endings is _ENDINGS and not options.batch:
            known += ", or in .html for a page"
        raise CliError(f"OUT = {out!r}: must end in {known}{film}.")
    has_pixels = ending not in (*_SHAPES, ".html")
    if not has_pixels and options.scale != 1.0:
        raise CliError("--scale: is for .png; shapes are as fine at every scale.")
    if has_pixels and options.hidden:
        raise CliError("--hidden: is for .svg, .pdf, .tex and .html, whose lines are shapes.")
    if "/" in options.panes and "," in options.panes:
        raise CliError(f"--panes = {options.panes!r}: must be a row or a column, not both.")
    check_out("OUT", out)


def _sizes(
    options: argparse.Namespace, states: Sequence[Document], panes: Sequence[str]
) -> set[tuple[int, int]]:
    """Return the sizes of figures in pixels; refuse impossible ones, also of letters."""
    from app.drawings.figure_size import checked_size, checked_text

    column, sizes = "/" in options.panes and len(panes) > 1, set[tuple[int, int]]()
    with _of_options(options):
        for image in {state.projection.image_size for state in states}:
            sizes.add(checked_size(image, panes, options.size, options.scale, column))
            checked_text(image, panes, options.size, options.text_size, column)
    return sizes


def _check_film(options: argparse.Namespace, out: str, sizes: set[tuple[int, int]]) -> None:
    """Refuse sizes that a film cannot have, and then a machine that cannot encode it."""
    with importing():
        from app.drawings.moving import WEBP_PX
        from app.drawings.mp4 import program
    if len(sizes) > 1:
        raise CliError(
            f"--{sweep.motions(options)[0]}: frames of a film have one size; set --size."
        )
    (size,) = sizes
    if _ending(out) == ".webp" and max(size) > WEBP_PX:
        raise CliError(f"OUT = {out!r}: .webp has at most {WEBP_PX} pixels along each side.")
    if _ending(out) == ".mp4":
        if size[0] % 2 or size[1] % 2:
            sides = "x".join(map(str, size))
            raise CliError(
                f"OUT = {out!r}: .mp4 has even sides in pixels, not {sides}; set --size."
            )
        with blamed_on(out, UNWRITABLE):
            program()


def _ending(out: str) -> str:
    return os.path.splitext(out)[1].lower()


# --------------------------------------------------------------------------- drawing


def _write(options: argparse.Namespace, out: str, document: Document, scene: Scene) -> None:
    with importing():
        from app.drawings.describing import describe
        from app.drawings.figures import write_png, write_shapes
    if _ending(out) == ".png":
        pixels = _pixels(options, document, scene)
        about = describe(document, scene, sweep.panes(options))
        write_png(out, pixels, picture_json(document), options.scale, about)
        return
    drawing = _options(options, document)
    with _of_options(options):
        about = describe(document, scene, sweep.panes(options))
        hidden = options.hidden or "none"
        write_shapes(out, scene, document.projection, about, hidden=hidden, **drawing)


def _write_film(
    options: argparse.Namespace,
    out: str,
    frames: Sequence[Document],
    scene: Scene,
    size: tuple[int, int],
) -> None:
    with importing():
        from app.drawings.moving import encoded, moving
    # There and back, a state is drawn once.
    done: dict[int, bytes] = {}
    for frame in _with_progress(frames):
        if id(frame) not in done:
            pixels = _pixels(options, frame, scene)
            json = picture_json(frame)
            done[id(frame)] = encoded(pixels, _ending(out), json, options.scale)
    parts = [done[id(frame)] for frame in frames]
    once, fps = options.loop == "once", sweep.speed(options)
    with blamed_on(out, UNWRITABLE):
        film = moving(parts, _ending(out), size, fps, once)
    write_bytes_atomically(out, film)


def _with_progress(frames: Sequence[_Frame]) -> Iterator[_Frame]:
    """Yield each frame, and tell a terminal how many there are."""
    terminal = sys.stderr if sys.stderr is not None and sys.stderr.isatty() else None
    try:
        for number, frame in enumerate(frames, 1):
            if terminal is not None:
                print(f"\rframe {number}/{len(frames)}", end="", file=terminal, flush=True)
            yield frame
    finally:
        if terminal is not None:
            print(file=terminal)


def _pixels(options: argparse.Namespace, document: Document, scene: Scene) -> Pixels:
    with importing():
        from app.drawings.figures import render
    drawing = _options(options, document)
    with _of_options(options):
        return render(scene, document.projection, scale=options.scale, **drawing)


@contextlib.contextmanager
def _of_options(options: argparse.Namespace) -> Iterator[None]:
    """Make a refusal of the drawing name the option that it is about."""
    from app.drawings.figure_size import TEXT

    try:
        yield
    except Refusal as error:
        of_size = options.size and error.file is None and str(error).startswith(("width", "height"))
        text = str(error).replace("text size =", "--text-size =", int(error.bound == TEXT))
        raise CliError(f"{'--size ' if of_size else ''}{text}") from error


def _options(options: argparse.Namespace, document: Document) -> dict[str, Any]:
    """Return the parameters that `render` and `write_shapes` share."""
    from app.drawings.style import PALETTES

    return {
        "panes": sweep.panes(options),
        "column": "/" in options.panes,
        "crop": options.crop,
        "size": options.size,
        "transparent": options.transparent,
        "style": PALETTES[options.palette],
        "view": document.view,
        "settings": document.settings,
        "quality": document.quality,
        "text_pt": options.text_size,
    }


def _warning(document: Document, scene: Scene) -> str:
    """Return what a picture lacks that was written all the same."""
    if scene.phenomenon is None:
        return ""
    settings = scene.phenomenon.checked(document.settings)
    illustration = scene.phenomenon.illustration(document.projection, settings, scene.subject)
    warning = illustration.warning
    return "" if warning is None else f"{document.scene}: {warning.sentence()}."
