"""Sample lenses and cameras, the same for every room: no test has a list of lenses of its own."""

import dataclasses
import math
from collections.abc import Iterable
from typing import Any

import numpy as np

from app.model import lenses
from app.model.projection import (
    Array,
    Camera,
    FreeMatrix,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from tests.oracles.exact import cotangent_deg

SLANTED = Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0), (0.3, 1.0, -0.2))
"""A camera that no axis of the world is parallel to."""

_VARIED: tuple[tuple[str, Lens], ...] = (
    ("perspective", Perspective(45.0, 1.0, 30.0)),
    ("wide", Perspective(120.0, 0.5, 20.0)),
    ("infinite", Perspective(60.0, 0.5, math.inf)),
    ("frustum", Frustum(-0.6, 0.9, -0.4, 0.5, 1.0, 40.0)),
    ("frustum, kept", Frustum(-0.6, 0.9, -0.4, 0.5, 1.0, 40.0, "x")),
    ("frustum, infinite", Frustum(-0.3, 0.5, -0.4, 0.2, 0.5, math.inf)),
    ("orthographic", Orthographic(-4.0, 4.0, -3.0, 3.0, 1.0, 30.0)),
    ("orthographic, kept", Orthographic(-1.0, 7.0, -5.0, 3.0, -5.0, 30.0, "y")),
    ("oblique", Oblique(-5.0, 5.0, -3.0, 3.0, 8.0, 40.0, alpha_deg=60.0, beta_deg=50.0)),
)
LENSES: dict[str, Lens] = dict(_VARIED) | {
    kind: made() for kind, made in lenses.LENSES.items() if kind not in dict(_VARIED)
}
"""Every kind of lens, some of them kept to an image, off the axis, behind the eye or infinite."""

ONE_OF_EACH: dict[str, Lens] = {kind: LENSES[kind] for kind in lenses.LENSES}
"""One lens of each kind, by kind."""


def free_matrix() -> FreeMatrix:
    """A perspective whose w also depends on x and y, so that it vanishes on an oblique plane."""
    cells = Projection(lens=LENSES["perspective"]).clip_from_view.copy()
    cells[0, 1] += 0.2
    cells[3] += 0.05, -0.03, 0.0, 0.1
    return FreeMatrix(cells.tolist())


def made(kind: str, window: Iterable[float], near: float, far: float, **own: object) -> Lens:
    """A lens of a kind from the sides of a window, planes, and values of the fields that it has."""
    values = dict(zip(("left", "right", "bottom", "top"), window, strict=True))
    values |= {"near": near, "far": far, **own}
    names = {field.name for field in dataclasses.fields(lenses.LENSES[kind])}
    lens: Lens = lenses.LENSES[kind](**{name: values[name] for name in names & set(values)})
    return lens


def at_distance(
    projection: Projection, distance: Any, across: Any = 0.5, along: Any = 0.5
) -> tuple[Any, Any, Any]:
    """The view-space points seen at these parts of the picture's width and height."""
    lens, (left, right, bottom, top) = projection.lens, projection.window
    x, y = left + across * (right - left), bottom + along * (top - bottom)
    if not lens.parallel:
        return x * (distance / lens.near), y * (distance / lens.near), -distance
    if isinstance(lens, Oblique):  # its projectors lean: (-cot a, -cot b, -1) into the picture
        x = x + (distance - lens.near) * float(cotangent_deg(lens.alpha_deg))
        y = y + (distance - lens.near) * float(cotangent_deg(lens.beta_deg))
    return x, y, -distance


def in_world(camera: Camera, points_view: Any) -> Array:
    """Points given along u, v, n from the eye, in world coordinates."""
    return np.asarray(points_view) @ camera.frame + camera.eye
