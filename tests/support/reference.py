"""The true pictures of points, by the exact precision."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.model.projection import Array, Projection, Space
from app.precision import levels


class Reference(NamedTuple):
    """The true image and depth of points, the reference for other arithmetics.

    Attributes
    ----------
    numbers : (n, 3) float64 array
        x and y in pixels and depth, by the exact precision; NaN where there is no picture.
    rests : (n, 3) float64 array
        The rounding error of `numbers`.
    """

    numbers: Array
    rests: Array

    @classmethod
    def of(cls, projection: Projection, points: ArrayLike, space: Space = "world") -> Reference:
        """Return the reference of points (n, 3) of a space."""
        with np.errstate(all="ignore"):
            placed = projection.placed(points, space)
            given = np.reshape(np.asarray(points, dtype=np.float64), (-1, 3))
            numbers, rests, _ = levels.exact_numbers(projection, placed, given, space)
        numbers[:, ~(numbers[6] > 0.0)] = np.nan
        return cls(numbers[10:].T, rests.T)

    def errors(self, answers: Array) -> Array:
        """Upper bounds of the errors of x and y in pixels and depth, (n, 3).

        NaN where the answer is NaN or there is no picture.
        """
        unknown = levels.CERTAIN * np.spacing(np.abs(self.numbers))
        errors: Array = np.abs((answers - self.numbers) - self.rests) + unknown
        return errors
