"""The oblique parallel lens: lecture 002's ``P_obl = P_ort H``."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import chain
from typing import ClassVar

from app.arithmetic.double_double import cotangent_deg
from app.arithmetic.rationals import Rationals
from app.model.lenses.lens import Lens, LensTable, Windowed
from app.model.lenses.orthographic import Parallel, box_table
from app.model.lenses.solving import angle_deg, same
from app.model.limits import (
    LARGEST_SHEAR,
    SMALLEST_WINDOW,
    between,
    cos_sin_deg,
    finite,
    keep_checked,
    within,
)
from app.model.parameter import Parameter, stated
from app.model.refusal import QT_TRANSLATE_NOOP

COTS = ("cot(alpha)", "cot(beta)")  # the letters of the projectors' slant


_slant = partial(stated, section="lens", place="more_lens", unit="°", span=(1.0, 179.0), step=0.5)
ALPHA = _slant("alpha_deg", letter="alpha", formula="alpha")
BETA = _slant("beta_deg", letter="beta", formula="beta")

TABLE = box_table("oblique", "shear")


@dataclass(frozen=True)
class Oblique(Parallel, Windowed):
    """The oblique parallel lens of lecture 002: the orthographic one after its matrix H.

    ``x' = x + (z + near) cot(alpha)`` and ``y' = y + (z + near) cot(beta)`` in view space: the
    projectors are slanted, and points on the near plane do not move. ``0 < alpha_deg, beta_deg <
    180`` are the angles of the projectors with the x and the y axis; 90 and 90 is the orthographic
    lens. `oblique_angles` has those of cavalier and cabinet drawings.
    """

    kind: ClassVar[str] = "oblique"
    tables: ClassVar[tuple[LensTable, ...]] = (TABLE,)
    parameters: ClassVar[tuple[Parameter, ...]] = (ALPHA, BETA)
    shape: ClassVar[str] = QT_TRANSLATE_NOOP("phenomena", "oblique box")

    alpha_deg: float = 109.47122063449069  # cabinet, receding at 45 degrees
    beta_deg: float = 109.47122063449069

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("alpha_deg", "beta_deg"):
            angle_deg = between(name, getattr(self, name), 0, 180)
            least = math.degrees(1.0 / LARGEST_SHEAR)
            keep_checked(self, **{name: within(name, angle_deg, least, 180.0 - least)})

    @property
    def least_window(self) -> float:
        """The least width and height of the window for which the shear does not overflow."""
        return SMALLEST_WINDOW * LARGEST_SHEAR

    @property
    def shear(self) -> tuple[float, float]:
        return _cot_deg(self.alpha_deg), _cot_deg(self.beta_deg)

    @classmethod
    def _leaning(
        cls, cells: Rationals, in_hand: Lens
    ) -> tuple[dict[str, float], Sequence[Fraction]]:
        solved = [row[2] / row[i] for i, row in enumerate(cells[:2])]
        angles = list(map(_angle_deg, solved))
        if isinstance(in_hand, Oblique):
            was = in_hand.alpha_deg, in_hand.beta_deg
            angles = [
                a if same(cotangent_deg(Fraction(a)), cot, Fraction(1)) else b
                for a, b, cot in zip(was, angles, solved, strict=True)
            ]
        fields = dict(zip(("alpha_deg", "beta_deg"), angles, strict=True))
        return fields, [cotangent_deg(Fraction(angle)) for angle in angles]

    def exact_letters(self, aspect: Fraction) -> dict[str, Fraction]:
        cots = (cotangent_deg(Fraction(angle)) for angle in (self.alpha_deg, self.beta_deg))
        return super().exact_letters(aspect) | dict(zip(COTS, cots, strict=True))

    def letters(self, aspect: Fraction) -> dict[str, float]:
        return super().letters(aspect) | dict(zip(COTS, self.shear, strict=True))


def _angle_deg(cot: Fraction) -> float:
    """The angle in degrees, between 0 and 180, from its cotangent; a preset's if it may be one."""
    solved = angle_deg(cot, 1.0)
    presets = chain.from_iterable(OBLIQUE_PRESETS.values())
    return next((each for each in presets if abs(each - solved) <= 2.0 * math.ulp(solved)), solved)


def _cot_deg(angle_deg: float) -> float:
    """The cotangent of an angle in degrees, exact at 90, within 2 ulp elsewhere."""
    cos, sin = cos_sin_deg(angle_deg)
    return cos / sin


def oblique_angles(receding: float, receding_deg: float) -> tuple[float, float]:
    """The angles of an `Oblique` lens that draws receding edges in this way.

    `receding` is the drawn length of an edge along the view direction per true length: 1 in a
    cavalier, 1/2 in a cabinet drawing; from 0 to `LARGEST_SHEAR`, or a `Refusal`. `receding_deg` is
    its direction in the picture, anticlockwise from the right. A unit into the picture moves a
    point by ``(-cot(alpha), -cot(beta))`` (lecture 002, H).
    """
    receding, receding_deg = finite("receding", receding), finite("receding_deg", receding_deg)
    within("receding", receding, 0, int(LARGEST_SHEAR))
    cos, sin = cos_sin_deg(receding_deg)
    return (
        math.degrees(math.atan2(1.0, -receding * cos)),
        math.degrees(math.atan2(1.0, -receding * sin)),
    )


def receding_of(lens: Lens) -> tuple[float, float]:
    """The arguments of `oblique_angles` that give the angles of a lens."""
    cot_alpha, cot_beta = lens.shear
    length = math.hypot(cot_alpha, cot_beta)
    return length, math.degrees(math.atan2(-cot_beta, -cot_alpha)) if length else 0.0


OBLIQUE_PRESETS: dict[str, tuple[float, float]] = {
    f"{name}-{label}": oblique_angles(receding, receding_deg)
    for name, receding in (("cavalier", 1.0), ("cabinet", 0.5))
    for label, receding_deg in (
        ("30", 30.0), ("45", 45.0), ("63.4", math.degrees(math.atan(2.0))),
    )
}  # fmt: skip
"""`Oblique` angles of textbook drawings, by name and receding angle."""
