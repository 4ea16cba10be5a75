"""The true image of points, by mpmath with 200 digits, independent of the measured code.

It follows the definitions: the frame of lecture 004, similar triangles or the slant of the
projectors, and a depth linear in 1/w, or in w for a parallel lens. 200 digits suffice for fields
of view of 1e-80 degrees without rearranged formulas, so it shares no formula with the other code.
"""

from typing import Any, NamedTuple

import numpy as np

from app.model.parameters import ALPHA, BETA
from app.model.projection import Array, Projection

DIGITS = 200
SAMPLE = 64  # largest number of points that are compared


class Truth(NamedTuple):
    """The true x and y in pixels and depth in [0, 1], (n, 3), and what rounding cut off."""

    numbers: Array
    rests: Array

    def errors(self, answers: Array) -> Array:
        """Return the absolute errors (n, 3) of answers (n, 3); NaN where an answer is NaN."""
        return np.asarray(np.abs((answers - self.numbers) - self.rests))


def sample(points: Array) -> tuple[Array, Array]:
    """Return at most `SAMPLE` different points from all parts of the list, and their indices."""
    once = np.sort(np.unique(points, axis=0, return_index=True)[1])
    indices = once[np.linspace(0, len(once) - 1, min(len(once), SAMPLE)).astype(int)]
    return points[indices], indices


def truth(projection: Projection, points_world: Array) -> Truth:
    """Return the truth about world points (n, 3) in front of the eye plane.

    Raises a `Refusal` for a free matrix, which has no definition except its cells.
    """
    from mpmath import mp

    lens: Any = projection.lens
    camera = projection.camera
    with mp.workdps(DIGITS):

        def exact(values: Any) -> list[Any]:
            return [mp.mpf(value) for value in np.asarray(values).tolist()]

        def cross(a: list[Any], b: list[Any]) -> list[Any]:
            return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]

        def unit(a: list[Any]) -> list[Any]:
            return [part / mp.norm(a) for part in a]

        def cot(angle_deg: float) -> Any:
            return mp.cot(mp.radians(angle_deg))

        eye = exact(camera.eye)
        n = unit([a - b for a, b in zip(eye, exact(camera.target), strict=True)])
        u = unit(cross(exact(camera.up), n))
        frame = u, cross(n, u), n
        width, height = exact(projection.image_size)
        near, far = mp.mpf(lens.near), mp.mpf(lens.far)
        if lens.fov_y_deg is not None:
            half_height = near / cot(mp.mpf(lens.fov_y_deg) / 2)
            half_width = half_height * width / height
            left, top = -half_width, half_height
        else:
            left, right, bottom, top = exact([lens.left, lens.right, lens.bottom, lens.top])
            half_width, half_height = (right - left) / 2, (top - bottom) / 2
            if lens.keep == "x":
                top = (bottom + top) / 2 + half_width * height / width
                half_height = half_width * height / width
            elif lens.keep == "y":
                left = (left + right) / 2 - half_height * width / height
                half_width = half_height * width / height
        cot_alpha, cot_beta = (cot(getattr(lens, each.name, 90.0)) for each in (ALPHA, BETA))
        numbers, rests = np.empty((len(points_world), 3)), np.empty((len(points_world), 3))
        for row, point in enumerate(points_world):
            offset = [a - b for a, b in zip(exact(point), eye, strict=True)]
            x, y, z = (mp.fdot(axis, offset) for axis in frame)
            w = -z
            if lens.parallel:
                x, y = x + (z + near) * cot_alpha, y + (z + near) * cot_beta
                gone, left_over = w - near, far - w
            else:
                x, y = near * x / w, near * y / w
                gone, left_over = 1 / near - 1 / w, 1 / w - 1 / far
            depth = (left_over if projection.depth == "reversed" else gone) / (gone + left_over)
            across, down = (x - left) / (2 * half_width), (top - y) / (2 * half_height)
            for column, value in enumerate((width * across, height * down, depth)):
                numbers[row, column] = float(value)
                rests[row, column] = float(value - numbers[row, column])
    return Truth(numbers, rests)
