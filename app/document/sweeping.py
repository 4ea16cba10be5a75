"""Values that change from frame to frame of a film, and the order of its frames."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from app.document.document import Document, fields_of
from app.model.limits import check_name, real
from app.model.numerals import numbers
from app.model.refusal import REFUSALS, Refusal

EASES = ("linear", "log", "smooth")
LOOPS = ("repeat", "once", "back-and-forth")
FRAMES, FPS = 48, 25.0  # frames, and frames a second, unless others are asked for
MOST_FRAMES, FASTEST = 1000, 50  # players slow a GIF down that asks for more frames a second


class ValueSweep(NamedTuple):
    """A value of ``--set`` that changes from some numbers to others."""

    path: str
    first: Sequence[float]
    last: Sequence[float]


def parse_sweeps(texts: Sequence[str]) -> list[ValueSweep]:
    """Parse ``lens.near=0.5:8`` and others, which change together."""
    sweeps = dict[str, ValueSweep]()
    for text in texts:
        path, _, ends = text.partition("=")
        try:
            first, last = map(numbers, ends.split(":"))
        except ValueError:
            first = last = None
        if not first or not last or len(first) != len(last):
            raise Refusal.saying(REFUSALS["a-sweep"], repr(text))
        if path.strip() in sweeps:
            raise Refusal.saying(REFUSALS["sweeping-twice"], repr(text), path.strip())
        sweeps[path.strip()] = ValueSweep(path.strip(), first, last)
    return list(sweeps.values())


def swept(
    sweeps: Sequence[ValueSweep], start: Document, count: int, ease: str = "linear"
) -> list[list[str]]:
    """Return the values of so many frames, in the form of ``--set``.

    They go in equal steps, in equal ratios (``log``), or begin and end slowly (``smooth``). Whole
    numbers stay whole.
    """
    check_name("ease", ease, EASES)
    fields = fields_of(start.scene, start.projection.lens.kind)
    whole = {field.path for field in fields if field.whole}

    def text(sweep: ValueSweep, part: float) -> str:
        texts = list[str]()
        for first, last in zip(sweep.first, sweep.last, strict=True):
            value = first if first == last else first * (1.0 - part) + last * part
            if ease == "log" and 0.0 < part < 1.0 and first != last:
                if first * last <= 0.0:
                    raise Refusal.saying(
                        REFUSALS["no-ratio"], sweep.path, f"{first:g}", f"{last:g}"
                    )
                value = first * (last / first) ** part
            value = float(round(value)) if sweep.path in whole else value
            texts.append(repr(value).removesuffix(".0"))
        return f"{sweep.path}={','.join(texts)}"

    parts = [step / (count - 1) for step in range(count)]
    parts = [eased(part) if ease == "smooth" else part for part in parts]
    return [[text(sweep, part) for sweep in sweeps] for part in parts]


def eased(part: float) -> float:
    """Ease a share of the way: begin and end slowly, as in the window."""
    return 0.5 - 0.5 * math.cos(math.pi * part)


def order(frames: int, loop: str) -> list[int]:
    """Return the number of the state that each frame shows; refuse impossible frames.

    There and back, neither the first nor the last state comes twice in a row.
    """
    check_name("loop", loop, LOOPS)
    is_back = loop == "back-and-forth"
    if not isinstance(frames, int) or not 2 <= frames <= MOST_FRAMES:
        raise Refusal.saying(REFUSALS["some-frames"], frames, MOST_FRAMES)
    if is_back and frames % 2:
        raise Refusal.saying(REFUSALS["even-frames"], frames)
    return [min(frame, frames - frame) if is_back else frame for frame in range(frames)]


def checked_speed(fps: float) -> float:
    if not 1.0 <= real("fps", fps) <= FASTEST:
        raise Refusal.saying(REFUSALS["a-speed"], f"{fps:g}", FASTEST)
    return fps
