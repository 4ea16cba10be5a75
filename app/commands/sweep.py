"""The states of a moving picture: a document that changes from frame to frame.

``--sweep`` changes a value, ``--orbit`` the place from which the world is seen, and ``--stages``
the stage of the NDC pane. The world pane's own view stands still, or goes round.
"""

from __future__ import annotations

import argparse
import math
import os
import re
from collections.abc import Sequence
from dataclasses import replace

from app.commands.arguments import (
    check_drawing,
    document_before,
    importing,
    load_scene,
    with_values,
)
from app.commands.options import FULL_TURN, CliError, parse_number
from app.document.document import Document
from app.lecture.stages import IMAGE
from app.model.projection import Camera

MOTIONS = ("sweep", "orbit", "stages")
"""The options that make a picture move; one at a time."""
FRAMES, FRAMES_OF_STAGES, FPS = 48, 120, 12.0
"""Frames, and frames a second, unless others are asked for."""
_RESTING = 0.5  # of the time, at the stops of the stages
MOST_FRAMES = 1000
FASTEST = 50
"""Most frames a second: players slow a GIF down that asks for more."""
_NUMBER = re.compile(r"%(?:0[1-9])?d")


def order(found: argparse.Namespace) -> list[int]:
    """Return the number of the state that each frame shows; refuse impossible frames.

    There and back, neither the first nor the last state comes twice in a row.
    """
    usual = FRAMES_OF_STAGES if found.stages else FRAMES
    frames = usual if found.frames is None else found.frames
    is_back = found.loop == "back-and-forth"
    if not 2 <= frames <= MOST_FRAMES:
        raise CliError(f"--frames = {frames}: must be a whole number from 2 to {MOST_FRAMES}.")
    if is_back and frames % 2:
        raise CliError(f"--frames = {frames}: must be even for --loop back-and-forth.")
    return [min(frame, frames - frame) if is_back else frame for frame in range(frames)]


def speed(found: argparse.Namespace) -> float:
    """Return the frames a second."""
    fps: float = FPS if found.fps is None else found.fps
    if not 1.0 <= fps <= FASTEST:
        raise CliError(f"--fps = {fps:g}: must be from 1 to {FASTEST}.")
    return fps


def states(found: argparse.Namespace, file: str | None) -> list[Document]:
    """Return the states, from the first value to the last; a `Refusal` if one is impossible."""
    before, count = document_before(file, found.set), max(order(found)) + 1
    if found.orbit is not None:
        return _orbit(found, file, with_values(before, found.set), count)
    parts = [step / (count - 1) for step in range(count)]
    if found.stages:
        if "ndc" not in panes(found):
            raise CliError(f"--stages: needs the pane ndc, and --panes = {found.panes!r}.")
        values = [f"view.stage={_position(part)!r}" for part in parts]
        return [with_values(before, [*found.set, value]) for value in values]
    path, first, last = _ends(found.sweep)
    values = []
    for part in parts:
        numbers = [a * (1.0 - part) + b * part for a, b in zip(first, last, strict=True)]
        values.append(f"{path}={','.join(map(_written, numbers))}")
    return still(found, file, [with_values(before, [*found.set, value]) for value in values])


def panes(found: argparse.Namespace) -> list[str]:
    """Return the panes of ``--panes``, in their order."""
    return re.split("[,/]", found.panes)


def usual_loop(found: argparse.Namespace, *, numbered: bool) -> str:
    """Return the loop where nobody asked for one: without a jump, and numbered files only once."""
    goes_round = found.orbit is not None and abs(found.orbit) == FULL_TURN
    if found.sweep or goes_round:
        return "repeat"
    return "once" if numbered else "back-and-forth"


def _position(part: float) -> float:
    """Return the position on the stage strip at a part of the way, which rests at each stop."""
    stop = min(int(part * IMAGE), IMAGE - 1)
    way = (part * IMAGE - stop - _RESTING / 2.0) / (1.0 - _RESTING)
    return round(stop + 0.5 - 0.5 * math.cos(math.pi * min(1.0, max(0.0, way))), 9)


# --------------------------------------------------------------------------- the world's view


def still(found: argparse.Namespace, file: str | None, states: list[Document]) -> list[Document]:
    """Return states whose world is seen from one place, as in the window while a value changes."""
    first = states[0]
    scene = load_scene(first.scene, first.mesh, file)
    with importing():
        from app.document.naming import seen_from
    is_free = not seen_from(first.view, scene) and "world" not in first.view.panes
    if "world" not in panes(found) or not is_free:
        return states
    (view,) = _standing(found, file, states, [0.0])
    return [_seen(state, view) for state in states]


def _orbit(
    found: argparse.Namespace, file: str | None, document: Document, count: int
) -> list[Document]:
    """Return states whose world is seen from places around it; the camera stays where it is."""
    if not 0.0 < abs(found.orbit) <= FULL_TURN:
        raise CliError(
            f"--orbit = {found.orbit:g}: must be from -{FULL_TURN:g} to {FULL_TURN:g} degrees, not"
            " 0."
        )
    if "world" not in panes(found):
        raise CliError(f"--orbit: needs the pane world, and --panes = {found.panes!r}.")
    # Round and round, the step after the last one leads to the first.
    steps = count if found.loop == "repeat" and abs(found.orbit) == FULL_TURN else count - 1
    turns_deg = [found.orbit * step / steps for step in range(count)]
    if (view := document.view.panes.get("world")) is None:
        views = _standing(found, file, [document], turns_deg)
    else:
        at = view.orbit
        views = [view]  # to the last bit
        views += (
            Camera.from_orbit(view.target, at._replace(azimuth_deg=at.azimuth_deg + turn_deg))
            for turn_deg in turns_deg[1:]
        )
    return [_seen(document, view) for view in views]


def _seen(state: Document, view: Camera) -> Document:
    panes = state.view.panes | {"world": view}
    return replace(state, view=replace(state.view, fixed="", panes=panes))


def _standing(
    found: argparse.Namespace, file: str | None, states: Sequence[Document], turns: list[float]
) -> list[Camera]:
    scene = load_scene(states[0].scene, states[0].mesh, file)
    check_drawing()
    with importing():
        from app.drawings.standing import standing
    return standing(
        scene, states, turns, panes=panes(found), column="/" in found.panes, size=found.size,
        scale=found.scale, text_pt=found.text_size,
    )  # fmt: skip


# --------------------------------------------------------------------------- the options


def _ends(sweep: str) -> tuple[str, list[float], list[float]]:
    path, _, ends = sweep.partition("=")
    try:
        first, last = ([parse_number(part) for part in end.split(",")] for end in ends.split(":"))
    except ValueError:
        first, last = [], [0.0]
    if len(first) != len(last) or not all(map(math.isfinite, [*first, *last])):
        raise CliError(
            f"--sweep = {sweep!r}: must be NAME=FIRST:LAST with finite numbers, such as"
            " lens.near=0.5:8 or camera.eye=3,2,4:0,2,5."
        )
    return path.strip(), first, last


def _written(value: float) -> str:
    return repr(value).removesuffix(".0")


def names(out: str, frames: int) -> list[str]:
    """Return the name of each frame; nothing if `out` has no number such as ``%03d``."""
    folder, name = os.path.split(out)
    found = list(_NUMBER.finditer(name))
    if len(found) != 1:
        return []
    before, after = name[: found[0].start()], name[found[0].end() :]
    return [os.path.join(folder, f"{before}{found[0][0] % k}{after}") for k in range(frames)]
