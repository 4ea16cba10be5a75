"""What the model's numbers may be: types, limits, checks, and the one error that they raise."""

from __future__ import annotations

import math
import numbers
from collections.abc import Iterable
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Vector: TypeAlias = tuple[float, float, float]
Row: TypeAlias = tuple[float, float, float, float]
Cells: TypeAlias = tuple[Row, Row, Row, Row]
Array: TypeAlias = NDArray[np.float64]
DepthRange: TypeAlias = Literal["opengl", "direct3d", "reversed"]
Keep: TypeAlias = Literal["stretch", "x", "y"]

DEPTH_RANGES: dict[str, tuple[float, float]] = {
    "opengl": (-1.0, 1.0),
    "direct3d": (0.0, 1.0),
    "reversed": (1.0, 0.0),
}
"""NDC z of the near and of the far plane."""

PLANES = ("near", "far", "left", "right", "bottom", "top")
"""The six planes of the view volume, in the order of `Trace.outside`."""

LARGEST = 1e100
"""Largest coordinate or distance; with `SMALLEST`, no matrix overflows float64 (2e205 * 1e100)."""
SMALLEST = 1e-205
"""Smallest near distance, and smallest depth range of a parallel lens."""
SMALLEST_WINDOW = 1e-200
"""Smallest side of a parallel lens' window: a point beside it has pixels below 1e305."""
LARGEST_IMAGE_PX = 16384
"""Largest image side, the texture limit that every current OpenGL driver offers."""
SMALLEST_FIELD = 1e-90
"""Smallest field of view in degrees; its inverse is the steepest ray to a window's edge."""
SMALLEST_OPENING = 1e-98
"""Smallest side of a frustum's window in units of near: that of the smallest field, and less."""
SMALLEST_CELL = 1e-75
"""Smallest cell of a free matrix but 0: its square, and a product of two, is far from underflow."""
LARGEST_INVERSE = 10**150
"""Largest cell of a free matrix' inverse, for the same reason."""
LARGEST_SHEAR = 1e6
"""Largest cotangent of an oblique lens' angles; theirs start at 5.8e-5 degrees."""
SMALLEST_UP_ANGLE = 1e-15
"""Least angle in radians between up and the view direction.

Coordinates typed in decimal are off by up to half an ulp, so that nearer to parallel than this
the frame would be made of their rounding errors.
"""

_SHOWN = 100
SHOWN_DIGITS = 6
"""Of a bound, and of a value that a hand has dragged."""


class ProjectionError(ValueError):
    """A value that no projection can have.

    Parameters
    ----------
    field : str
        Name of the refused parameter, as in the document (``"near"``, ``"up"``).
    value : object
        The value that was refused.
    bound : str
        What the value must be, with ``{0}``, ``{1}`` for the limits, so that it can be
        translated before they are filled in. One of `BOUNDS`.
    *limits : object
        The limits themselves.
    """

    def __init__(self, field: str, value: object, bound: str, *limits: object) -> None:
        self.field, self.value, self.bound, self.limits = field, value, bound, limits
        shown = bound.format(*shown_limits(limits, value))
        super().__init__(f"{field} = {format_value(value)}: {shown}.")


FINITE_NUMBER = "must be a finite number"
ABOVE = "must be greater than {0}"
AT_LEAST = "must be at least {0}"
AT_MOST = "must be at most {0}"
BETWEEN = "must lie between {0} and {1}, both excluded"
NEAR_BEFORE_FAR = "must be less than far, which is {0}"
LEFT_BEFORE_RIGHT = "must be less than right, which is {0}"
BOTTOM_BEFORE_TOP = "must be less than top, which is {0}"
THREE_NUMBERS = "must be three finite numbers x, y, z"
NOT_THE_EYE = "must differ from the eye, or the camera looks nowhere"
NOT_ZERO = "must not be the zero vector"
NOT_PARALLEL = "must not be parallel to the view direction"
WHOLE_PIXELS = "must be a whole number of pixels from 1 to {0}"
ONE_OF = "must be one of {0}"
FAR_BEYOND_NEAR = "must be greater than near, which is {0}"
RIGHT_OF_LEFT = "must be greater than left, which is {0}"
TOP_ABOVE_BOTTOM = "must be greater than bottom, which is {0}"
DISTINCT = "is too close to {0} for float64 to tell apart"
WIDER = "is too close to {0} for a plane as far from the eye as near is"
NO_POINT = "is at infinity, where there is no point but a direction"
INVERTIBLE = "must have an inverse, but its rank is {0}"
FOUR_BY_FOUR = "must be four rows of four finite numbers"
ZERO_OR_AT_LEAST = "must be 0 or at least {0} in size"
SMALL_INVERSE = "must have an inverse that float64 can hold, and multiply"
BOUNDS = (
    FINITE_NUMBER, ABOVE, AT_LEAST, AT_MOST, BETWEEN, NEAR_BEFORE_FAR, LEFT_BEFORE_RIGHT,
    BOTTOM_BEFORE_TOP, THREE_NUMBERS, NOT_THE_EYE, NOT_ZERO, NOT_PARALLEL, WHOLE_PIXELS, ONE_OF,
    FAR_BEYOND_NEAR, RIGHT_OF_LEFT, TOP_ABOVE_BOTTOM, DISTINCT, WIDER, NO_POINT,
    INVERTIBLE, FOUR_BY_FOUR, ZERO_OR_AT_LEAST, SMALL_INVERSE,
)  # fmt: skip
"""Every sentence a `ProjectionError` can end with, for translators."""
OTHER_SIDE = {
    NEAR_BEFORE_FAR: ("far", FAR_BEYOND_NEAR),
    LEFT_BEFORE_RIGHT: ("right", RIGHT_OF_LEFT),
    BOTTOM_BEFORE_TOP: ("top", TOP_ABOVE_BOTTOM),
}
"""The field on the other side of a bound, and the bound as seen from there.

A lens cannot know which of the two was changed; who knows it says it with these.
"""


def format_value(value: object) -> str:
    """Write a value as a person would type it: ``1``, ``0.1``, ``inf``, ``(0, 1, 0)``."""
    if isinstance(value, (tuple, list)):
        return _cut("(" + ", ".join(format_value(part) for part in value[:_SHOWN]) + ")")
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        return _cut(" ".join(repr(value).split()))
    try:
        number = float(value)
    except OverflowError:
        whole: Any = value
        return f"{'-' if whole < 0 else ''}1e{int(math.log10(abs(whole)))}"
    return str(int(number)) if number.is_integer() and abs(number) < 1e15 else repr(number)


def shown_limits(limits: Iterable[object], value: object) -> tuple[object, ...]:
    """Limits to be read: with six digits, unless the refused value lies beyond what is shown.

    Parameters
    ----------
    limits : iterable of object
        Numbers, their texts, and words, which stay; so does a text beside what is no number.
    value : object
        What was refused; a number, or any other thing.
    """
    return tuple(_shown_limit(limit, value) for limit in limits)


def _shown_limit(limit: object, value: object) -> object:
    number = _limit_number(limit)
    shown, sides = _six_digits(number), _sides(value, number)
    is_word = isinstance(limit, str) and not sides
    if shown == number or is_word or _sides(value, shown) != sides:
        return limit if isinstance(limit, str) else format_value(limit)  # 20, not 20.0
    return format_value(shown)


def six_digits(error: ProjectionError) -> ProjectionError:
    """A refusal of what a hand has made, and nobody typed: its value too is shown with six digits.

    It keeps them all where fewer would put it on the other side of a limit.
    """
    value, limits = error.value, shown_limits(error.limits, error.value)
    short = tuple(map(_six_digits, value)) if isinstance(value, tuple) else _six_digits(value)
    numbers_shown = [_limit_number(limit) for limit in limits]
    if any(_sides(short, limit) != _sides(value, limit) for limit in numbers_shown):
        return error
    return ProjectionError(error.field, short, error.bound, *limits)


def _six_digits(value: Any) -> Any:
    return float(f"{value:.{SHOWN_DIGITS}g}") if isinstance(value, float) else value


def _limit_number(limit: Any) -> Any:
    """The number that a limit is or is the text of; a word has none, and stays."""
    try:
        return float(limit) if isinstance(limit, (float, str)) else limit
    except ValueError:
        return limit


def _sides(value: object, limit: Any) -> list[tuple[bool, bool]]:
    """On which side of a limit each number of a value is."""
    if not isinstance(limit, float):
        return []
    parts = value if isinstance(value, (tuple, list)) else (value,)
    real_parts = [part for part in parts if isinstance(part, (int, float))]
    return [(part > limit, part < limit) for part in real_parts]


def _cut(text: str) -> str:
    """As much of a text as a sentence can hold."""
    return text if len(text) <= _SHOWN else text[: _SHOWN - 3] + "..."


# --------------------------------------------------------------------------- checks


def keep_checked(frozen: object, **values: object) -> None:
    """Store checked values in a frozen dataclass while it is being made."""
    for name, value in values.items():
        object.__setattr__(frozen, name, value)


def real(field: str, value: Any) -> float:
    """A real number as a float, infinite ones too, or a `ProjectionError`."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise ProjectionError(field, value, FINITE_NUMBER)
    try:
        return float(value)
    except OverflowError:  # an int of more than 308 digits
        large: Any = value
        bound, limit = (AT_MOST, LARGEST) if large > 0 else (AT_LEAST, -LARGEST)
        raise ProjectionError(field, value, bound, limit) from None


def finite(field: str, value: Any) -> float:
    """A finite number up to `LARGEST` as a float, or a `ProjectionError`."""
    number = real(field, value)
    if not math.isfinite(number):
        raise ProjectionError(field, number, FINITE_NUMBER)
    if abs(number) > LARGEST:
        bound, limit = (AT_MOST, LARGEST) if number > 0 else (AT_LEAST, -LARGEST)
        raise ProjectionError(field, number, bound, limit)
    return number


def between(field: str, value: Any, low: int, high: int) -> float:
    """A number inside an open interval as a float, or a `ProjectionError` that names its ends."""
    try:
        number = finite(field, value)
    except ProjectionError as error:
        if error.bound == FINITE_NUMBER:
            raise
        # Beyond all numbers, and so beyond these.
        raise ProjectionError(field, error.value, BETWEEN, low, high) from None
    if not low < number < high:
        raise ProjectionError(field, number, BETWEEN, low, high)
    return number


def finite_vector(field: str, value: Any) -> Vector:
    """Three finite numbers as a tuple of floats, or a `ProjectionError`."""
    try:
        parts = tuple(value)
        if isinstance(value, (str, bytes)) or len(parts) != 3:
            raise TypeError
    except TypeError:
        raise ProjectionError(field, value, THREE_NUMBERS) from None
    for part in parts:
        if isinstance(part, bool) or not isinstance(part, numbers.Real):
            raise ProjectionError(field, value, THREE_NUMBERS)
        if not math.isfinite(real(field, part)):
            raise ProjectionError(field, parts, THREE_NUMBERS)
    x, y, z = (finite(field, part) for part in parts)
    return x, y, z


def finite_matrix(field: str, value: Any, smallest: float = 0.0) -> Cells:
    """Four rows of four finite numbers, 0 or at least as large, or an error that names the cell."""
    try:
        rows = [tuple(row) for row in value]
        if len(rows) != 4 or any(len(row) != 4 for row in rows):
            raise TypeError
    except TypeError:
        raise ProjectionError(field, value, FOUR_BY_FOUR) from None
    checked = tuple(
        tuple(_cell(f"{field}[{i}, {j}]", part, smallest) for j, part in enumerate(row))
        for i, row in enumerate(rows)
    )
    return checked  # type: ignore[return-value]


def _cell(field: str, value: Any, smallest: float) -> float:
    number = finite(field, value)
    if number != 0.0 and abs(number) < smallest:
        raise ProjectionError(field, number, ZERO_OR_AT_LEAST, smallest)
    return number + 0.0  # minus zero is a zero here: 0 typed is what is kept


def cos_sin_deg(angle_deg: float) -> tuple[float, float]:
    """Cosine and sine of an angle in degrees, exact at the multiples of 90."""
    angle_deg = math.remainder(angle_deg, 360.0)  # exact, and the quarter below too, then
    quarter = round(angle_deg / 90.0)
    rest = math.radians(math.remainder(angle_deg, 90.0))
    cos, sin = math.cos(rest), math.sin(rest)
    return ((cos, sin), (-sin, cos), (-cos, -sin), (sin, -cos))[quarter % 4]


def read_only(values: ArrayLike) -> Array:
    """A float64 copy that cannot be written into."""
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array
