"""``export figure.html``: a page for phones, with a slider if ``--sweep`` makes several states."""

import os
from argparse import Namespace
from collections.abc import Callable, Iterable, Sequence

from app.commands import sweep
from app.commands.arguments import importing
from app.commands.terminal import CliError
from app.document.document import Document
from app.document.files import write_bytes_atomically
from app.drawings.describing import describe
from app.drawings.figure import Figure
from app.drawings.film import shown_values, steady
from app.languages import said, with_comma
from app.lecture.stages import IMAGE, WORLD
from app.scenes.phenomena.words import digits_apart
from app.scenes.scene import Scene

FRAMES = 21  # states under the slider, unless another number is asked for


def check(options: Namespace) -> None:
    """Refuse options that are of other figures."""
    for option in ("crop", "width", "transparent", "loop", "fps", "show-value"):
        if getattr(options, option.replace("-", "_")) not in (None, False):
            raise CliError("--{0}: is not for .html, whose pictures change under a slider.", option)


def asked(options: Namespace) -> Namespace:
    """Return the options for the states of a page, which does not rest at stages."""
    if options.stages:
        sweep.check_stages(options)
        options.sweep, options.stages = [f"view.stage={WORLD}:{IMAGE}"], False
    # The page has each pane alone.
    alone = "world" if "world" in sweep.panes(options) else options.panes
    frames = FRAMES if options.frames is None else options.frames
    return Namespace(**vars(options) | {"panes": alone, "frames": frames})


def write(
    options: Namespace,
    out: str,
    reported: Callable[[Sequence[Document]], Iterable[Document]],
    states: Sequence[Document],
    scene: Scene,
    alone: Callable[[Document, str], Figure],
) -> str:
    """Write the page of states, which `reported` yields; return a warning if it is large.

    `alone` returns the figure of a pane.
    """
    with importing():
        from app.drawings.page import LARGEST, SliderPosition, drawn, page, sized
    values = _values(options, states, scene)
    panes = sweep.panes(options)
    figures = {pane: steady([sized(alone(each, pane)) for each in states], fades=False)
               for pane in panes}  # fmt: skip
    shown = []
    for number, (value, state) in enumerate(zip(values, reported(states), strict=True)):
        about = describe(state, scene, panes)
        pictures = [drawn(figures[pane][number], said) for pane, said in about.panes.items()]
        shown.append(SliderPosition(value, pictures, about.general, (*about.cut, *about.risky)))
    content = page(about.title, shown, "/" in options.panes)
    write_bytes_atomically(out, content)
    if len(content) <= LARGEST:
        return ""
    name, fewer = os.path.basename(out), "--panes"
    if len(states) > 1:
        fewer = said("{0} or {1}", "--frames", fewer)
    return said("too-large-page", name, len(content) // 1000, LARGEST // 1000, fewer)


def _values(options: Namespace, states: Sequence[Document], scene: Scene) -> list[str]:
    """Return what the slider changes, in each state: ``near n = 4``."""
    if options.orbit is not None:
        turns_deg = [options.orbit * k / (len(states) - 1) for k in range(len(states))]
        digits = digits_apart(*turns_deg)
        return [said("angle = {0}°", with_comma(f"{each:.{digits}g}")) for each in turns_deg]
    if options.transition:
        parts = (with_comma(f"{100 * k / (len(states) - 1):.3g}") for k in range(len(states)))
        return [said("way = {0} %", part) for part in parts]
    return shown_values(states, scene, sweep.swept_paths(options))
