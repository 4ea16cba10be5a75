"""``export figure.html``: a page for phones, with a slider if ``--sweep`` makes several states."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Callable, Iterable, Sequence
from functools import reduce
from typing import TYPE_CHECKING, Any

from app.commands import sweep
from app.commands.arguments import importing
from app.commands.terminal import CliError
from app.document.compare import DifferenceWriter, names_in
from app.document.document import Document
from app.document.files import write_bytes_atomically
from app.lecture.dependence import FIELDS as LETTERS
from app.lecture.letters import in_letters
from app.lecture.stages import IMAGE, WORLD
from app.lessons.text import in_line
from app.model.parameters import TITLES
from app.scenes.phenomena.words import digits_apart, figure

if TYPE_CHECKING:
    from app.drawings.figure import Figure
    from app.scenes.scene import Scene

FRAMES = 21  # states under the slider, unless another number is asked for


def check(options: Namespace) -> None:
    """Refuse options that are of other figures."""
    for option in ("crop", "width", "transparent", "loop", "fps"):
        if getattr(options, option) not in (None, False):
            raise CliError(f"--{option}: is not for .html, whose pictures change under a slider.")


def asked(options: Namespace) -> Namespace:
    """Return the options for the states of a page, which does not rest at stages."""
    if options.stages:
        sweep.check_stages(options)
        options.sweep, options.stages = f"view.stage={WORLD}:{IMAGE}", False
    # The page has each pane alone.
    alone = "world" if "world" in sweep.panes(options) else options.panes
    frames = FRAMES if options.frames is None else options.frames
    return Namespace(**vars(options) | {"panes": alone, "frames": frames})


def write(
    options: Namespace,
    out: str,
    told: Iterable[Document],
    states: Sequence[Document],
    scene: Scene,
    alone: Callable[[Document, str], Figure],
) -> str:
    """Write the page of states, which `told` yields too; return a warning if it is large.

    `alone` returns the figure of a pane.
    """
    with importing():
        from app.drawings.describing import describe
        from app.drawings.page import LARGEST, SliderPosition, drawn, page
    values = _values(options, states, scene)
    shown = []
    for value, state in zip(values, told, strict=True):
        about = describe(state, scene, sweep.panes(options))
        panes = [drawn(alone(state, pane), said) for pane, said in about.panes.items()]
        shown.append(SliderPosition(value, panes, about.general, (*about.cut, *about.risky)))
    content = page(about.title, shown, "/" in options.panes)
    write_bytes_atomically(out, content)
    if len(content) <= LARGEST:
        return ""
    name, fewer = os.path.basename(out), "--frames or --panes" if len(states) > 1 else "--panes"
    return (
        f"{name} has {len(content) // 1000} kB, and a page for phones should have at most"
        f" {LARGEST // 1000} kB: ask for fewer {fewer}."
    )


def _values(options: Namespace, states: Sequence[Document], scene: Scene) -> list[str]:
    """Return what the slider changes, in each state: ``near n = 4``."""
    if options.orbit is not None:
        turns_deg = [options.orbit * k / (len(states) - 1) for k in range(len(states))]
        return [f"angle = {turn_deg:.{digits_apart(*turns_deg)}g}°" for turn_deg in turns_deg]
    if options.transition:
        return [f"way = {100 * k / (len(states) - 1):.3g} %" for k in range(len(states))]
    path, letters = (options.sweep or "").partition("=")[0].strip(), states[0].view.letters

    def named(field: str) -> str:
        letter = next((name for name, fields in LETTERS.items() if fields == (field,)), "")
        symbol = in_line(in_letters(f"{{{letter}}}", letters)) if letter else ""
        return f"{TITLES.get(field, field)} {symbol}".strip() + " ="

    written = DifferenceWriter(named, lambda text: in_letters(text, letters), figure)
    settings = () if scene.phenomenon is None else scene.phenomenon.settings
    values = names_in([""] * len(states), [each.state for each in states], settings, written)
    if len(states) > 1 and not all(values):  # nothing that a picture compares, such as a stage
        numbers: list[Any] = [reduce(getattr, path.split("."), each) for each in states]
        digits = digits_apart(*numbers)
        values = [f"{path.rpartition('.')[2]} = {number:.{digits}g}" for number in numbers]
    return values
