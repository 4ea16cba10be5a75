"""The nearest place from which a view in a given direction holds all points: a closed form.

A view looks along its third axis. From `back` behind the origin, a place to the right sees a point
within its slopes if it lies between ``x - right * (toward + back)`` and
``x + left * (toward + back)``; likewise up. So points leave the places from ``high - right * back``
to ``low + left * back``. For a parallel view `toward` is 0, and `back` is half of its height.
"""

from collections.abc import Sequence

import numpy as np

from app.model.projection import Array


def limits_of(points: Array, slopes: Array) -> Array:
    """Return what points, (3, n) in the view's axes, leave: low, left, high and right, (4, 2).

    The slopes are how steeply they may be seen: left, right, down and up. The second column is
    that of up.
    """
    x, y, toward = points
    left, right, down, up = slopes
    return np.array([
        ((x + left * toward).min(), left, (x - right * toward).max(), right),
        ((y + down * toward).min(), down, (y - up * toward).max(), up),
    ]).T  # fmt: skip


def nearest_place(limits: Sequence[Array], least: float) -> tuple[float, float, float]:
    """Return the nearest place within all limits, at least so far back: right, up and back.

    Each lower and each higher limit meet at a distance; the largest of these is the answer.
    """
    low, less, high, more = np.stack(limits, axis=-1)
    meet = (high[:, :, None] - low[:, None]) / (more[:, :, None] + less[:, None])
    back = max(least, float(meet.max()))
    right, up = ((low + less * back).min(axis=1) + (high - more * back).max(axis=1)) / 2.0
    return float(right), float(up), back
