"""The states of ``--sweep``: a value of the document that changes from frame to frame."""

from __future__ import annotations

import argparse
import math
import os
import re

from app.commands.arguments import document_before, with_values
from app.commands.options import CliError, parse_number
from app.document.document import Document

FRAMES, FPS = 48, 12.0
"""Frames, and frames a second, unless others are asked for."""
MOST_FRAMES = 1000
FASTEST = 50
"""Most frames a second: players slow a GIF down that asks for more."""
_NUMBER = re.compile(r"%(?:0[1-9])?d")


def order(found: argparse.Namespace) -> list[int]:
    """Return the number of the state that each frame shows; refuse impossible frames.

    There and back, neither the first nor the last state comes twice in a row.
    """
    frames = FRAMES if found.frames is None else found.frames
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
    path, first, last = _ends(found.sweep)
    before = document_before(file, found.set)
    steps = max(order(found))
    values = []
    for step in range(steps + 1):
        part = step / steps
        numbers = [a * (1.0 - part) + b * part for a, b in zip(first, last, strict=True)]
        values.append(",".join(map(_written, numbers)))
    return [with_values(before, [*found.set, f"{path}={value}"]) for value in values]


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
