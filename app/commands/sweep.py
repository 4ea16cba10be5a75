"""The states of a film: a document that changes from frame to frame.

``--sweep`` changes values, ``--orbit`` the place from which the world is seen, ``--stages`` the
stage of the NDC pane, and ``--transition`` goes from one step of a talk to the next. The world
pane's own view stands still, or goes round.
"""

import argparse
import contextlib
import os
import re
from collections.abc import Iterator
from dataclasses import replace

from app.commands.arguments import course_of, document_before, place_of, state_at, with_values
from app.commands.options import FULL_TURN
from app.commands.terminal import CliError
from app.document import sweeping
from app.document.document import Document
from app.document.sweeping import FPS, FRAMES, eased
from app.drawings import film
from app.drawings.figure import Figure
from app.lecture.stages import IMAGE
from app.model.projection import Camera
from app.model.refusal import Refusal

MOTIONS = ("sweep", "orbit", "stages", "transition")  # options that move a picture, one at a time
_FRAMES = {"stages": 120, "transition": 24}  # unless others are asked for
_RESTING = 0.5  # of the time, at the stops of the stages
_NUMBER = re.compile(r"%(?:0[1-9])?d")


def motions(options: argparse.Namespace) -> list[str]:
    return [name for name in MOTIONS if is_given(options, name)]


def is_given(options: argparse.Namespace, option: str) -> bool:
    """Whether an option is there, even with the number 0."""
    value = getattr(options, option)
    return value is not None and value is not False


def order(options: argparse.Namespace) -> list[int]:
    """Return the number of the state that each frame shows; refuse impossible frames."""
    usual = next((_FRAMES.get(name, FRAMES) for name in motions(options)), FRAMES)
    frames = usual if options.frames is None else options.frames
    with _options():
        return sweeping.order(frames, options.loop or "repeat")


def speed(options: argparse.Namespace) -> float:
    """Return the frames a second."""
    with _options():
        return sweeping.checked_speed(FPS if options.fps is None else options.fps)


@contextlib.contextmanager
def _options() -> Iterator[None]:
    """Turn the refusal of a value into one of an option."""
    try:
        yield
    except Refusal as error:
        raise CliError(f"--{error}") from error


def states(options: argparse.Namespace, file: str | None) -> list[Document]:
    """Return the states, from the first value to the last; a `Refusal` if one is impossible.

    They still lack the place from which the world is seen. Without a motion there is one state.
    """
    count = max(order(options)) + 1
    if options.transition:
        return _transition(options, file, count)
    before = document_before(file, options.set, options.step)
    if options.orbit is not None:
        _check_orbit(options)
        return [with_values(before, options.set)] * count
    if not motions(options):
        return [with_values(before, options.set)]
    parts = [step / (count - 1) for step in range(count)]
    if options.stages:
        check_stages(options)
        values = [[f"view.stage={_position(part)!r}"] for part in parts]
    else:
        start = with_values(before, options.set)
        with _options():
            sweeps = sweeping.parse_sweeps(options.sweep)
            values = sweeping.swept(sweeps, start, count, options.ease)
    return [with_values(before, [*options.set, *each]) for each in values]


def with_views(
    options: argparse.Namespace, file: str | None, figures: list[Figure]
) -> list[Figure]:
    """Return figures with the places from which their worlds are seen, on a machine that draws."""
    if options.transition:
        return _along(options, file, figures)
    if options.orbit is not None:
        return _round(options, figures)
    return film.still(figures) if options.sweep else figures


def swept_paths(options: argparse.Namespace) -> list[str]:
    return [text.partition("=")[0].strip() for text in options.sweep or ()]


def steady(options: argparse.Namespace, figures: list[Figure], *, fades: bool) -> list[Figure]:
    """Return figures whose labels are placed on all of them together, with their values."""
    is_round = options.loop == "repeat" and options.orbit is not None
    noted = swept_paths(options) if options.show_value else ()
    return film.steady(figures, noted, is_round=is_round, fades=fades)


def check_stages(options: argparse.Namespace) -> None:
    """Refuse panes that look the same at every stage."""
    if "ndc" not in panes(options):
        raise CliError("--stages: needs the pane ndc, and --panes = {0!r}.", options.panes)


def panes(options: argparse.Namespace) -> list[str]:
    return re.split("[,/]", options.panes)


def usual_loop(options: argparse.Namespace, *, numbered: bool) -> str:
    """Return the loop where nobody asked for one: without a jump, and numbered files only once."""
    goes_round = options.orbit is not None and abs(options.orbit) == FULL_TURN
    if options.sweep or goes_round:
        return "repeat"
    return "once" if numbered or options.transition else "back-and-forth"


def _position(part: float) -> float:
    """Return the position on the stage strip at a part of the way, which rests at each stop."""
    stop = min(int(part * IMAGE), IMAGE - 1)
    way = (part * IMAGE - stop - _RESTING / 2.0) / (1.0 - _RESTING)
    return round(stop + eased(min(1.0, max(0.0, way))), 9)


def _transition(options: argparse.Namespace, file: str | None, count: int) -> list[Document]:
    """Return the states on the way to a step from the one before it.

    Where the straight way leads through an impossible state, the last possible one stays.
    """
    from app.lessons import transition

    place, start, end = _steps(options, file)
    moves = transition.can_move(start, end)
    if not moves and start != end:
        raise CliError("other-scene", place)
    states = list[Document]()
    for step in range(count):
        part = eased(step / (count - 1))
        state = transition.between(start, end, part) if moves and part < 1.0 else end
        state = state or (states or [end])[-1]
        stage = (1.0 - part) * start.view.stage + part * end.view.stage
        states.append(replace(state, view=replace(state.view, stage=stage)))
    return states


def _steps(options: argparse.Namespace, file: str | None) -> tuple[int, Document, Document]:
    """Return the number of the step that a transition leads to, and both ends of it."""
    if file is None or options.step is None:
        raise CliError("--transition: needs a lesson or a talk as FILE, and --step.")
    course = course_of(file)
    place = place_of(course, options.step)
    if not place:
        raise CliError("--transition: no step comes before --step {0}.", options.step)
    start, end = (with_values(state_at(course, at), options.set) for at in (place - 1, place))
    return place + 1, start, end


def _along(options: argparse.Namespace, file: str | None, figures: list[Figure]) -> list[Figure]:
    """Return figures whose world is seen on the way from one step's view to another's."""
    from app.lessons.transition import camera_between

    place, *ends = _steps(options, file)
    views: list[Camera | None] = [None, None]
    shown = [replace(figures[0], document=end) for end in ends]
    if not any(map(film.is_fixed, shown)):
        views = [film.still([end])[0].document.view.panes.get("world") for end in shown]
    first, last = views
    stages = {end.view.stage for end in ends}
    if ends[0] == ends[1] and len(stages) == 1 and (first is None or last in (None, first)):
        raise CliError("--transition: step {0} shows the same as the step before.", place)
    if first is None or last is None:
        return figures
    return [
        film.seen_by(figure, camera_between(first, last, eased(step / (len(figures) - 1))))
        for step, figure in enumerate(figures)
    ]


# --------------------------------------------------------------------------- the world's view


def _check_orbit(options: argparse.Namespace) -> None:
    if not 0.0 < abs(options.orbit) <= FULL_TURN:
        raise CliError("orbit", options.orbit, FULL_TURN)
    if "world" not in panes(options):
        raise CliError("--orbit: needs the pane world, and --panes = {0!r}.", options.panes)


def _round(options: argparse.Namespace, figures: list[Figure]) -> list[Figure]:
    """Return figures whose world is seen from places around it; the camera stays where it is."""
    figure, count = figures[0], len(figures)
    # Round and round, the step after the last one leads to the first.
    steps = count if options.loop == "repeat" and abs(options.orbit) == FULL_TURN else count - 1
    turns_deg = [options.orbit * step / steps for step in range(count)]
    if (view := figure.document.view.panes.get("world")) is None:
        views = film.standing(figure, [figure.document], turns_deg)
    else:
        at = view.orbit
        views = [view]  # to the last bit
        views += (
            Camera.from_orbit(view.target, at._replace(azimuth_deg=at.azimuth_deg + turn_deg))
            for turn_deg in turns_deg[1:]
        )
    return [film.seen_by(figure, view) for view in views]


# --------------------------------------------------------------------------- the options


def names(out: str, frames: int) -> list[str]:
    """Return the name of each frame; nothing if `out` has no number such as ``%03d``."""
    folder, name = os.path.split(out)
    digits = list(_NUMBER.finditer(name))
    if len(digits) != 1:
        return []
    before, after = name[: digits[0].start()], name[digits[0].end() :]
    return [os.path.join(folder, f"{before}{digits[0][0] % k}{after}") for k in range(frames)]
