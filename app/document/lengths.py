"""Lengths on paper: how they are typed, and how many pixels of a figure they are."""

import re
from typing import NamedTuple

from app.model.numerals import number

DPI = 300
"""Pixels an inch of a figure at scale 1, as its file says: three panes of 640 pixels are 163 mm
wide, the text of a page; a scale makes it no larger, but finer."""
PX_PER = {"mm": DPI / 25.4, "cm": DPI / 2.54, "in": float(DPI), "px": 1.0}  # pixels by unit
_SIZE = re.compile(r"([0-9.]{1,12})([a-z]*) *[xX×] *([0-9.]{1,12})([a-z]*)")


class Size(NamedTuple):
    """Width and height in a unit of `PX_PER`."""

    width: float
    height: float
    unit: str = "px"

    @property
    def px(self) -> tuple[float, float]:
        return self.width * PX_PER[self.unit], self.height * PX_PER[self.unit]


def parse_size(text: str) -> Size:
    """Parse ``120mmx80mm``, ``12x8cm`` or ``1800x600``.

    Raises a `ValueError` if it is no size, or its unit is unknown.
    """
    match = _SIZE.fullmatch(text.strip())
    if match is None:
        raise ValueError(text)
    width, first, height, unit = match.groups()
    unit = unit or "px"
    if unit not in PX_PER or (first or unit) != unit:
        raise ValueError(text)
    return Size(float(width), float(height), unit)


def parse_length(text: str) -> float:
    """Parse ``84mm`` into pixels, of a length in px an integer if it is one.

    Raises a `ValueError` as `parse_size` does.
    """
    size = parse_size(f"{text}x{text}")
    return int(size.width) if size.unit == "px" and size.width.is_integer() else size.px[0]


def parse_points(text: str) -> float:
    """Parse a number of points, ``8`` or ``8pt``; raises a `ValueError` for anything else."""
    points = number(text.removesuffix("pt"))
    if points is None:
        raise ValueError(text)
    return points


def whole_pixels(size: tuple[float, float]) -> tuple[int, int]:
    """The whole pixels that a size covers, the last of them perhaps in part."""
    width, height = (-int(-(side - 1e-6) // 1) for side in size)
    return width, height
