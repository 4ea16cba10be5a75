"""What every illustration must be, whatever the projection, and projections at the model's
limits."""

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from app.drawings.style import LIGHT
from app.model.lenses import LENSES
from app.model.projection import (
    Camera,
    Frustum,
    Oblique,
    Orbit,
    Orthographic,
    Perspective,
    Projection,
)
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Marks
from app.scenes.phenomena.words import Reading


def subject_of(phenomenon: Phenomenon) -> Subject:
    """The phenomenon's own subject, as the scene hands it out."""
    (faces, _), _ = phenomenon.geometry()
    points = faces.reshape(-1, 3)
    lower, upper = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    return Subject((lower[0], lower[1], lower[2]), (upper[0], upper[1], upper[2]), points)


def showing(phenomenon: Phenomenon, subject: Subject) -> Callable[..., Illustration]:
    """What a phenomenon shows of a projection, its start if none is given, with some settings."""

    def show(projection: Projection = phenomenon.start, **settings: object) -> Illustration:
        return phenomenon.show(projection, phenomenon.checked(settings), subject)

    return show


def readings(illustration: Illustration) -> dict[str, Any]:
    """Every value by its label; a reading without a value must say why."""
    for one in illustration.readings:
        assert one.value is not None or one.note is not None, one.label
    return {one.label: one.value for one in illustration.readings}


def reading(illustration: Illustration, label: str) -> Reading:
    """The one reading whose label contains the words."""
    (found,) = (r for r in illustration.readings if label in r.label)
    return found


def why(illustration: Illustration, label: str) -> str:
    """Why the reading has no value."""
    found = reading(illustration, label)
    assert found.value is None and found.note is not None, label
    return found.note.sentence()


def value(illustration: Illustration, label: str) -> float:
    """The number that it reads."""
    found = reading(illustration, label).value
    assert isinstance(found, float), label
    return found


def projections(phenomenon: Phenomenon) -> Iterator[Projection]:
    """Every lens and depth range, and cameras and lenses at the limits of what can be."""
    start = phenomenon.start
    subject = subject_of(phenomenon)
    centre = tuple((a + b) / 2.0 for a, b in zip(subject.lower, subject.upper, strict=True))
    kinds = [start.with_lens(kind) for kind in LENSES]
    for seen in kinds:
        for depth in ("opengl", "direct3d", "reversed"):
            yield replace(seen, depth=depth)  # type: ignore[arg-type]
    cameras = [
        Camera((1e100, 0.0, 0.0), (0.0, 0.0, 0.0)),
        Camera((1e9, 2.0, 1e9), (1e9, 2.0, 0.0)),
        Camera(centre, (centre[0], centre[1], centre[2] - 1.0)),  # type: ignore[arg-type]
        Camera((centre[0], subject.upper[1], subject.upper[2]), centre),  # type: ignore[arg-type]
        Camera((0.0, 20.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, -1.0)),
        Camera((0.0, 1.0, 5.0), (0.0, 1.0, 50.0)),  # away from the subject
        Camera((3.0, 4.0, 5.0), (3.0, 4.0, 5.0 - 1e-12)),
        Camera((6.0, 5.0, 9.0), (0.0, 2.0, 0.0), (1.0, 0.3, 0.0)),
    ]
    for camera in cameras:
        for seen in kinds:
            yield replace(seen, camera=camera)
    lenses = [
        Perspective(1e-90, 1e-205, math.inf), Perspective(179.99999999, 1e-205, 1e100),
        Perspective(1e-6, 1e99, 1e100), Perspective(45.0, 1.0, 1.0 + 1e-15),
        Frustum(1e3, 1e3 + 1e-6, -1e-6, 1e-6, 1.0, math.inf, "stretch"),
        Frustum(-1.0, 1.0, -1.0, 1.0, 1e-3, 1e100, "y"),
        Orthographic(-1e100, 1e100, -1e100, 1e100, -1e100, 1e100),
        Orthographic(-1e-200, 1e-200, -1e-200, 1e-200, 1.0, 2.0),
        Oblique(-1.0, 1.0, -1.0, 1.0, 0.0, 1.0, "x", 5.8e-5, 179.9999),
        Oblique(-1e-190, 1e-190, -1e-190, 1e-190, -1.0, 1e100, "stretch", 90.0, 90.0),
    ]  # fmt: skip
    for lens in lenses:
        yield replace(start, lens=lens)
        yield replace(start, lens=lens, camera=cameras[0])
    away = Camera(start.camera.target, start.camera.eye, start.camera.up)
    yield replace(start, camera=away)
    for size in ((1, 1), (1, 16384), (16384, 1), (1279, 721)):
        yield replace(start, image_size=size)


def random_projection(dice: random.Random, start: Projection) -> Projection:
    """An everyday projection of any kind, somewhere round the start's target."""
    orbit = Orbit(dice.uniform(-180, 180), dice.uniform(-80, 80), dice.uniform(4, 20))
    lens = Perspective(dice.uniform(10, 120), dice.uniform(0.01, 1), dice.choice([50.0, math.inf]))
    size = (dice.randint(300, 2000), dice.randint(300, 2000))
    seen = Projection(Camera.from_orbit(start.camera.target, orbit), lens, size)
    seen = seen.with_lens(dice.choice([*LENSES]))
    if not isinstance(seen.lens, Frustum):
        return seen
    left, right, bottom, top = seen.window
    x, y = dice.uniform(-0.4, 0.4) * (right - left), dice.uniform(-0.4, 0.4) * (top - bottom)
    window = {"left": left + x, "right": right + x, "bottom": bottom + y, "top": top + y}
    return replace(seen, lens=replace(seen.lens, **window))


def assert_sound(
    phenomenon: Phenomenon, illustration: Illustration, projection: Projection
) -> None:
    """Numbers are finite or missing with a reason, marks are finite and in their pane's space."""
    for copy in illustration.copies:
        assert np.isfinite(copy.world_from_world).all()
    for one in illustration.readings:
        assert one.label
        if one.value is None:
            said = one.counted or (one.note is not None and one.note.sentence())
            assert said, f"{one.label} has no value and says nothing"
        elif isinstance(one.value, tuple):
            assert all(map(math.isfinite, one.value)), one
        elif not isinstance(one.value, str):
            assert math.isfinite(one.value), one
    for marks, size in ((illustration.world, 3), (illustration.ndc, 3), (illustration.image, 2)):
        _assert_marks(marks, size)
    width, height = projection.image_size
    for place in [p for line in illustration.image.lines for p in line.points] + [
        mark.point for mark in (*illustration.image.dots, *illustration.image.texts)
    ]:
        assert -1e-6 <= place[0] <= width + 1e-6 and -1e-6 <= place[1] <= height + 1e-6
    for diagram in illustration.diagrams:
        assert diagram.curves, diagram.title
        window = (diagram.left, diagram.right, diagram.bottom, diagram.top)
        assert all(map(math.isfinite, window))
        assert diagram.left < diagram.right and diagram.bottom != diagram.top
        for curve in diagram.curves:
            assert curve.points.ndim == 2 and curve.points.shape[1] == 2
            assert not np.isinf(curve.points).any()
            # NaN breaks a curve, and does nothing else.
            assert (
                np.isnan(curve.points).all(axis=1) | np.isfinite(curve.points).all(axis=1)
            ).all()


def _assert_marks(marks: Marks, size: int) -> None:
    for shape in (*marks.lines, *marks.faces):
        assert shape.points.ndim == 2 and shape.points.shape[1] == size
        assert np.isfinite(shape.points).all()
        assert _is_colour(shape.colour)
    for face in marks.faces:
        assert len(face.points) >= 3
    for mark in (*marks.dots, *marks.texts):
        assert np.shape(mark.point) == (size,)
        assert np.isfinite(mark.point).all()
        assert not mark.colour or _is_colour(mark.colour)


def _is_colour(name: str) -> bool:
    return name.startswith("#") or hasattr(LIGHT, name)
