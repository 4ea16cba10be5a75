"""Sweeps: the errors of every precision, and of VTK's own camera, over the range of a parameter."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias, cast

import numpy as np
from vtkmodules.vtkRenderingCore import vtkCamera

from app.measure.arithmetic import PRECISIONS, largest_errors
from app.measure.reference import SAMPLE, Truth, truth
from app.measure.results import OVER_DISTANCE, ErrorCurve, Sweep
from app.measure.run import Watch, unwatched
from app.model.parameters import ASPECT, DISTANCE, FAR, FOV_Y, NEAR, UP
from app.model.projection import Array, Camera, Frustum, Perspective, Projection
from app.model.refusal import Cancelled, Refusal
from app.precision.levels import Prediction, predict, trace
from app.scenes.phenomena.picture import image_from_ndc, seen

WORLD = "float32, world coordinates"
"""With vertices that are not measured from near the camera; over distances only."""


@dataclass(frozen=True)
class Range:
    """The range of a sweep, and the part of it that a sweep covers unless another is asked for.

    ``set(projection, value)`` returns the projection with that value, and the offset of the
    points, (3,).
    """

    unit: str
    low: float
    high: float
    usual: tuple[float, float]
    set: Callable[[Projection, float], tuple[Projection, Array]]
    from_top: bool = False  # whether steps also shrink towards the upper end: 179.9, 179.99, ...


_STILL = np.zeros(3)


# `results.SWEEP_NOTES` states what these two change besides.
def _with_near(projection: Projection, near: float) -> tuple[Projection, Array]:
    lens = _perspective(projection)
    return replace(projection, lens=replace(lens, near=near, far=max(lens.far, 4.0 * near))), _STILL


def _with_far(projection: Projection, far: float) -> tuple[Projection, Array]:
    lens = _perspective(projection)
    return replace(projection, lens=replace(lens, near=min(lens.near, far / 4.0), far=far)), _STILL


def _with_fov(projection: Projection, fov_y_deg: float) -> tuple[Projection, Array]:
    return replace(projection, lens=replace(_perspective(projection), fov_y_deg=fov_y_deg)), _STILL


def _with_distance(projection: Projection, distance: float) -> tuple[Projection, Array]:
    """Move camera and points together away from the origin, along (1, 1, 1)."""
    camera = projection.camera
    moved = np.full(3, distance / math.sqrt(3.0))
    eye, target = (tuple((np.array(p) + moved).tolist()) for p in (camera.eye, camera.target))
    return replace(projection, camera=replace(camera, eye=eye, target=target)), moved


def _with_up_angle(projection: Projection, angle_deg: float) -> tuple[Projection, Array]:
    """Set the angle between up and the view direction, in the plane of the former up."""
    camera = projection.camera
    _, v, n = camera.frame
    angle = math.radians(angle_deg)
    up = math.sin(angle) * v - math.cos(angle) * n
    turned = Camera(camera.eye, camera.target, tuple(up.tolist()))
    return replace(projection, camera=turned), _STILL


def _with_aspect(projection: Projection, aspect: float) -> tuple[Projection, Array]:
    """Show a window of another shape on the same image: its pixels are not square."""
    lens = _perspective(projection)
    top = lens.near * math.tan(math.radians(lens.fov_y_deg / 2.0))
    right = top * aspect
    wide = Frustum(-right, right, -top, top, lens.near, lens.far)
    return replace(projection, lens=wide), _STILL


def _perspective(projection: Projection) -> Perspective:
    lens: Any = projection.with_lens("perspective").lens
    return cast(Perspective, lens)


SWEEPS: dict[str, Range] = {
    NEAR.formula: Range("", 1e-200, 1e99, (1e-6, 1e9), _with_near),
    FAR.formula: Range("", 1e-6, 1e99, (1e-6, 1e9), _with_far),
    FOV_Y.formula: Range("°", 1e-80, 180.0 - 1e-12, (1.0, 179.0), _with_fov, from_top=True),
    DISTANCE.formula: Range("", 1e-3, 1e16, (1.0, 1e9), _with_distance),
    UP.formula: Range("°", 1e-13, 90.0, (1.0, 90.0), _with_up_angle),
    ASPECT.formula: Range("", 1e-12, 1e12, (0.1, 10.0), _with_aspect),
    OVER_DISTANCE: Range("", 1e-200, 1e99, (0.1, 1.0), lambda projection, _: (projection, _STILL)),
}
"""Every parameter that can be swept: from where float64 ends, and where a person would set it."""


def values_of(
    parameter: str, count: int, low: float | None = None, high: float | None = None
) -> tuple[float, ...]:
    """Return at least 2 values of a sweep, logarithmically spaced from `low` to `high`.

    An end that is None is that of the usual range.
    """
    swept = SWEEPS[parameter]
    low = swept.usual[0] if low is None else low
    high = swept.usual[1] if high is None else high
    if swept.from_top and low < 90.0 < high:
        half = count // 2
        rising = np.geomspace(low, 90.0, count - half)
        falling = 180.0 - np.geomspace(90.0, 180.0 - high, half + 1)[1:]
        return tuple(np.concatenate([rising, falling]).tolist())
    return tuple(np.geomspace(low, high, count).tolist())


def sweep(
    parameter: str,
    projection: Projection,
    points_world: Array,
    values: Sequence[float],
    watch: Watch = unwatched,
    at: "Callable[[str, Projection, Array, float], Mapping[str, Answer]] | None" = None,
) -> Sweep:
    """Measure something at every value of a parameter, with the scene's points (n, 3).

    `at` returns the answer of each choice; by default `errors`.

    A `Cancelled` that `watch` raises has the values done.
    """
    by_choice: dict[str, list[Answer]] = {}
    complete, done = True, 0
    for done, value in enumerate(values):
        try:
            watch(done / len(values))
        except Cancelled:
            complete = False
            break
        for name, answer in (at or errors)(parameter, projection, points_world, value).items():
            by_choice.setdefault(name, []).append(answer)
    curves = {name: _curve(answers) for name, answers in by_choice.items()}
    measured = tuple(values) if complete else tuple(values[:done])
    swept = Sweep(parameter, SWEEPS[parameter].unit, measured, curves, complete)
    if not complete:
        raise Cancelled(swept)
    return swept


def _curve(answers: "Sequence[Answer]") -> ErrorCurve:
    measured, predicted, notes = zip(*answers, strict=True) if answers else ((), (), ())

    def column(parts: Sequence[Prediction | None], name: str) -> tuple[float | None, ...]:
        return tuple(None if part is None else getattr(part, name) for part in parts)

    errors = column(measured, "px"), column(measured, "depth")
    return ErrorCurve(*errors, column(predicted, "px"), column(predicted, "depth"), notes)


Answer: TypeAlias = tuple[Prediction | None, Prediction | None, str]
"""The largest errors, the prediction, and the reason for a missing number."""


def errors(
    parameter: str, projection: Projection, points_world: Array, value: float
) -> Mapping[str, Answer]:
    """Return the errors of every precision, and of VTK's own camera, at one value.

    `in_view` moves the points (n, 3) into the view volume.
    """
    try:
        there, moved = SWEEPS[parameter].set(projection, value)
    except Refusal as error:
        names = (*PRECISIONS, "VTK's camera", *([WORLD] if parameter == "distance" else []))
        return dict.fromkeys(names, (None, None, str(error)))
    world = in_view(there, points_world + moved)
    reference = truth(there, world)
    origin = tuple(moved.tolist())
    origins = {name: (precision, origin) for name, precision in PRECISIONS.items()}
    if parameter == "distance":
        origins[WORLD] = "float32", (0.0, 0.0, 0.0)
    answers: dict[str, Answer] = {}
    with np.errstate(all="ignore"):
        for name, (precision, start) in origins.items():
            traced = trace(there, world, precision, start)
            largest, note = largest_errors(reference, np.column_stack([traced.image, traced.depth]))
            predicted = predict(there, world, start) or {}
            answers[name] = (largest, predicted.get(precision), note)
        answers["VTK's camera"] = _vtk_camera(there, world, reference)
    if WORLD in answers:  # last, so that the others have the same colours in every chart
        answers[WORLD] = answers.pop(WORLD)
    return answers


def in_view(projection: Projection, points_world: Array) -> Array:
    """Return at most `reference.SAMPLE` points inside the view volume, (n, 3).

    They are the scene's own if enough of those are inside, else points spread over the volume.
    """
    inside = points_world[seen(projection.trace(points_world))]
    if len(inside) >= SAMPLE:
        return np.asarray(inside[:: len(inside) // SAMPLE][:SAMPLE])
    rng = np.random.default_rng(1)
    lens, near = projection.lens, projection.lens.near
    far = lens.far if math.isfinite(lens.far) else 1e3 * max(abs(near), 1e-100)
    if lens.even_extent:
        depth = near + (far - near) * rng.uniform(0.02, 0.98, SAMPLE)
    else:
        # No farther than float64 can place a point beside this eye.
        depth = np.geomspace(near, min(far, 1e9 * near), SAMPLE + 2)[1:-1]
    pixels = rng.uniform(0.02, 0.98, (SAMPLE, 2)) * projection.image_size
    world = _spread(projection, pixels, depth)
    here = seen(projection.trace(world))
    # A view too narrow for float64 points still contains its middle.
    return world[here] if here.any() else np.array([projection.camera.target])


def _spread(projection: Projection, pixels: Array, depth: Array) -> Array:
    """Return the world points behind pixels at some distances from the eye plane."""
    left, right, bottom, top = projection.window
    width, height = projection.image_size
    x = left + (right - left) * pixels[:, 0] / width
    y = top - (top - bottom) * pixels[:, 1] / height
    grow = projection.lens.enlarged(depth)
    view = np.column_stack([x * grow, y * grow, -depth])
    return np.asarray(view @ projection.camera.frame + projection.camera.eye)


def _vtk_camera(projection: Projection, world: Array, reference: Truth) -> Answer:
    """Set VTK's own camera as a program would, and note which of the values it changes."""
    lens, camera = projection.lens, vtkCamera()
    camera.SetPosition(*projection.camera.eye)
    camera.SetFocalPoint(*projection.camera.target)
    camera.SetViewUp(*projection.camera.up)
    camera.SetClippingRange(lens.near, lens.far)
    left, right, bottom, top = projection.window
    fov_y_deg = lens.fov_y_deg
    if lens.central:
        fov_y_deg = fov_y_deg or math.degrees(2.0 * math.atan2(top, lens.near))
        camera.SetViewAngle(fov_y_deg)
    else:
        camera.ParallelProjectionOn()
        camera.SetParallelScale((top - bottom) / 2.0)
    aspect = (right - left) / (top - bottom)
    elements = camera.GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)
    matrix = np.array([elements.GetElement(i, j) for i in range(4) for j in range(4)])
    clip = np.column_stack([world, np.ones(len(world))]) @ matrix.reshape(4, 4).T
    ndc = clip[:, :3] / clip[:, 3:]
    answers = np.column_stack([image_from_ndc(projection, ndc), (ndc[:, 2] + 1.0) / 2.0])
    notes = []
    if fov_y_deg not in (None, camera.GetViewAngle()):
        notes.append(f"clamps the view angle to {camera.GetViewAngle():g}°")
    if camera.GetClippingRange() != (lens.near, lens.far):
        notes.append("changes near or far")
    errors, note = largest_errors(reference, answers)
    if note:
        notes.insert(0, note)
    return errors, None, "; ".join(notes)
