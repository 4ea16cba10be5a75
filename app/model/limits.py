"""Types, limits and checks of the model's numbers, and the sentences that refuse them."""

import math
import numbers
from collections.abc import Collection
from dataclasses import fields
from types import MappingProxyType
from typing import Any, Literal, TypeAlias, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal

Vector: TypeAlias = tuple[float, float, float]
Row: TypeAlias = tuple[float, float, float, float]
Cells: TypeAlias = tuple[Row, Row, Row, Row]
Array: TypeAlias = NDArray[np.float64]
DepthRange: TypeAlias = Literal["opengl", "direct3d", "reversed"]
Keep: TypeAlias = Literal["stretch", "x", "y"]

DEPTH_RANGES: dict[str, tuple[float, float]] = {  # NDC z of the near and of the far plane
    "opengl": (-1.0, 1.0),
    "direct3d": (0.0, 1.0),
    "reversed": (1.0, 0.0),
}

PLANES = (  # the six planes of the view volume, in the order of `Trace.outside`
    QT_TRANSLATE_NOOP("Plane", "near"),
    QT_TRANSLATE_NOOP("Plane", "far"),
    QT_TRANSLATE_NOOP("Plane", "left"),
    QT_TRANSLATE_NOOP("Plane", "right"),
    QT_TRANSLATE_NOOP("Plane", "bottom"),
    QT_TRANSLATE_NOOP("Plane", "top"),
)

LARGEST = 1e100
"""Largest coordinate or distance: together with `SMALLEST`, no matrix overflows (2e205 * 1e100)."""
SMALLEST = 1e-205  # smallest near distance, and smallest depth range of a parallel lens
SMALLEST_WINDOW = 1e-200
"""Smallest side of a parallel lens's window: points beside it have pixels below 1e305."""
LARGEST_IMAGE_PX = 16384  # largest image side: the texture limit of every current OpenGL driver
SMALLEST_FIELD = 1e-90
"""Smallest field of view in degrees; its inverse is the steepest ray to the edge of a window."""
SMALLEST_OPENING = 1e-98
"""Smallest side of a frustum's window in units of near; less than that of `SMALLEST_FIELD`."""
SMALLEST_CELL = 1e-75
"""Smallest nonzero cell of a typed matrix: products of two are far from underflow."""
LARGEST_INVERSE = 10**150  # largest cell of the inverse of a typed matrix, for the same reason
BEYOND = 1e250
"""Coordinates from which points count as infinitely far: double-double would overflow."""
LARGEST_SHEAR = 1e6  # largest cotangent of an oblique lens's angles, which start at 5.8e-5 degrees
SMALLEST_UP_ANGLE = 1e-15
"""Least angle in radians between up and the view direction.

Decimal coordinates are rounded by up to half an ulp; closer to parallel, the frame would consist of
these errors.
"""

OTHER_SIDE = {
    REFUSALS["near-before-far"]: ("far", REFUSALS["far-beyond-near"]),
    REFUSALS["left-before-right"]: ("right", REFUSALS["right-of-left"]),
    REFUSALS["bottom-before-top"]: ("top", REFUSALS["top-above-bottom"]),
}
"""For the bound of one field, the opposite field and its bound.

A lens cannot know which of the two fields was changed; callers that know use these.
"""


# --------------------------------------------------------------------------- checks


def keep_checked(frozen: object, **values: object) -> None:
    """Store checked values in a frozen dataclass during its construction."""
    for name, value in values.items():
        object.__setattr__(frozen, name, value)


class Frozen:
    """A frozen dataclass that is copied and pickled by its fields, without what it computed."""

    def __reduce__(self: Any) -> tuple[Any, ...]:
        own = [getattr(self, each.name) for each in fields(self)]
        return type(self), tuple(dict(v) if isinstance(v, MappingProxyType) else v for v in own)


def check_type(field: str, value: object, kind: type) -> None:
    if not isinstance(value, kind):
        raise Refusal(field, value, REFUSALS["of-type"], kind.__name__)


def is_number(value: object) -> TypeGuard[float]:
    """Whether it is a real number, as a truth value is not."""
    return isinstance(value, numbers.Real) and not isinstance(value, bool)


def real(field: str, value: Any) -> float:
    """A real number as a float, perhaps infinite, or a `Refusal`."""
    if not is_number(value):
        raise Refusal(field, value, REFUSALS["finite-number"])
    try:
        return float(value)
    except OverflowError:  # an int of more than 308 digits
        large: Any = value
        return within(field, large, -LARGEST, LARGEST)


def finite(field: str, value: Any) -> float:
    """A finite number up to `LARGEST` as a float, or a `Refusal`."""
    number = real(field, value)
    if not math.isfinite(number):
        raise Refusal(field, number, REFUSALS["finite-number"])
    return within(field, number, -LARGEST, LARGEST)


def positive(field: str, value: Any) -> float:
    """A finite number above 0 as a float, or a `Refusal`."""
    number = finite(field, value)
    if number <= 0.0:
        raise Refusal(field, number, REFUSALS["above"], 0)
    return number


def within(field: str, number: float, low: float, high: float) -> float:
    """A number inside a closed interval, or a `Refusal` that names the violated end."""
    if number < low:
        raise Refusal(field, number, REFUSALS["at-least"], low)
    if number > high:
        raise Refusal(field, number, REFUSALS["at-most"], high)
    return number


def check_name(field: str, value: Any, known: Collection[str], *, or_none: bool = False) -> None:
    """Refuse what is none of the known names, nor empty if there may be `or_none`."""
    if (not isinstance(value, str) or value not in known) and not (or_none and value == ""):
        bound = REFUSALS["one-or-none"] if or_none else REFUSALS["one-of"]
        raise Refusal(field, value, bound, ", ".join(known))


def between(field: str, value: Any, low: int, high: float) -> float:
    """A number inside an open interval as a float, or a `Refusal` that names its ends."""
    try:
        number = finite(field, value)
    except Refusal as error:
        if error.bound == REFUSALS["finite-number"]:
            raise
        # Infinity is beyond every number, and so beyond these bounds.
        raise Refusal(field, error.value, REFUSALS["between"], low, high) from None
    if not low < number < high:
        raise Refusal(field, number, REFUSALS["between"], low, high)
    return number


def vector(values: ArrayLike) -> Vector:
    x, y, z = np.asarray(values, dtype=np.float64).tolist()
    return x, y, z


def finite_vector(field: str, value: Any) -> Vector:
    """Three finite numbers as a tuple of floats, or a `Refusal`."""
    try:
        parts = tuple(value)
        if isinstance(value, (str, bytes)) or len(parts) != 3:
            raise TypeError
    except TypeError:
        raise Refusal(field, value, REFUSALS["three-numbers"]) from None
    for part in parts:
        if not is_number(part):
            raise Refusal(field, value, REFUSALS["three-numbers"])
        if not math.isfinite(real(field, part)):
            raise Refusal(field, parts, REFUSALS["three-numbers"])
    x, y, z = (finite(field, part) for part in parts)
    return x, y, z


def finite_matrix(field: str, value: Any, smallest: float = 0.0) -> Cells:
    """Four rows of four finite numbers, each 0 or at least `smallest`, or a `Refusal`."""
    try:
        rows = [tuple(row) for row in value]
        if len(rows) != 4 or any(len(row) != 4 for row in rows):
            raise TypeError
    except TypeError:
        raise Refusal(field, value, REFUSALS["four-by-four"]) from None
    return tuple(  # type: ignore[return-value]
        tuple(_cell(f"{field}[{i}, {j}]", part, smallest) for j, part in enumerate(row))
        for i, row in enumerate(rows)
    )


def _cell(field: str, value: Any, smallest: float) -> float:
    number = finite(field, value)
    if number != 0.0 and abs(number) < smallest:
        raise Refusal(field, number, REFUSALS["zero-or-at-least"], smallest)
    return number + 0.0  # store 0 for minus zero


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
