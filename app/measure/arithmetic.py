"""Trade 1, arithmetic: ns per point against the largest error in px and in depth; the sweeps.

Every way of projecting gets the same points, in its preferred layout, and does the same work: the
matrix, the divide and the viewport, as a GPU does. `reference.Truth` gives the errors of a sample
of the points. `summed` runs the same code in every precision: only the number format differs.
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkPerspectiveTransform
from vtkmodules.vtkRenderingCore import vtkCamera

from app.measure.reference import SAMPLE, Truth, sample, truth
from app.measure.results import IN_SOFTWARE, ChartPoint, ErrorCurve, Sweep, Trade
from app.measure.run import Watch, timed, unwatched
from app.model.projection import Array, Camera, Frustum, Perspective, Projection, Vector
from app.model.refusal import QT_TRANSLATE_NOOP, Cancelled, Refusal
from app.precision.cheap import Hardware, cheap
from app.precision.levels import Precision, Prediction, predict, trace

Rows: TypeAlias = NDArray[Any]
"""(3, n): x and y in pixels, depth in [0, 1]; NaN or infinite where there is no answer."""

MOST_POINTS = 16384
"""Number of points that are projected: every way does them in one block."""
_PRECISIONS: dict[str, Precision] = {
    "float32": "float32",
    "float64, every stage": "float64",
    "exact": "exact",
}
"""The projections that are precisions of the model, which predicts their errors."""
_OWN = {"settings.preset": "own", "settings.snap": "none", "settings.reciprocal": "exact"}
_SINGLE = {**_OWN, "settings.vertices": "float32", "settings.numbers": "float32"}
CHEAP: dict[str, tuple[Hardware, dict[str, str]]] = {
    **{
        f"{bits} bits": (Hardware(f"{bits} bits"), {"settings.preset": f"bits{bits}"})
        for bits in (8, 12, 16)
    },
    "float16": (Hardware("float16", "float16"), {"settings.preset": "half"}),
    **{
        name: (
            Hardware(name, name),
            {**_OWN, "settings.vertices": drawn, "settings.numbers": drawn},
        )
        for name, drawn in (("bfloat16", "bfloat16"), ("fixed 16.16", "fixed"))
    },
    **{
        f"float32, snapped to {name}": (Hardware(snap=name), {**_SINGLE, "settings.snap": drawn})
        for name, drawn in (("whole px", "whole"), ("1/4 px", "quarter"), ("1/16 px", "sixteenth"))
    },
    **{
        f"float32, reciprocal {name}": (
            Hardware(reciprocal=name),
            {**_SINGLE, "settings.reciprocal": drawn},
        )
        for name, drawn in (
            ("table", "table"),
            ("table, 1 Newton step", "newton1"),
            ("table, 2 Newton steps", "newton2"),
        )
    },
}
"""What numpy can only imitate: judged, but not timed.

Each with the settings with which the scene ``cheap-arithmetic`` draws it.
"""

WORLD = "float32, world coordinates"
"""With vertices that are not measured from near the camera; over distances only."""

NO_POINTS = QT_TRANSLATE_NOOP(
    "Measure", "no vertex is in front of the eye, so there is nothing to measure"
)
NOT_INSTALLED = QT_TRANSLATE_NOOP("Measure", "not installed")
NOT_A_NUMBER = QT_TRANSLATE_NOOP("Measure", "returns NaN")
INFINITE = QT_TRANSLATE_NOOP("Measure", "overflows")


class TimedProjection(NamedTuple):
    """One way of projecting: the timed function, how to read its answer, bytes of a vertex."""

    run: Callable[[], Any]
    rows: Callable[[Any], Rows]
    bytes: float | None = None


def looked_at(projection: Projection, points_world: Array) -> Array:
    """Return the points to measure with, (n, 3): those inside the view volume, else in front.

    They are repeated until the overhead of a call does not matter.
    """
    traced = projection.trace(points_world)
    inside = traced.in_front & ~traced.outside.any(axis=1)
    points = points_world[inside if inside.any() else traced.in_front]
    if not len(points):
        return points
    chosen: Array = np.resize(points[:: max(1, len(points) // MOST_POINTS)], (MOST_POINTS, 3))
    return chosen


def timed_projections(
    projection: Projection, world: Array, origin: Vector
) -> dict[str, TimedProjection]:
    """Return our own projections, from float32 to the exact one; `origin` as for `summed`."""

    def same(rows: Rows) -> Rows:
        return rows

    ours = {
        kind: TimedProjection(
            summed(projection, world, origin, kind), same, 3.0 * np.dtype(kind).itemsize
        )
        for kind in ("float32", "float64")
    }
    for kind in ("float32", "float64"):  # moved in float64, so every point keeps its 24 bytes
        ours[f"{kind}, eye first"] = TimedProjection(
            summed(projection, world, None, kind), same, 24.0
        )
    for name, precision in _PRECISIONS.items():
        if precision != "float32":  # which is above, without unused results
            ours[name] = TimedProjection(
                partial(trace, projection, world, precision),
                lambda traced: np.vstack([traced.image.T, traced.depth]),
                24.0,
            )
    return ours


def summed(
    projection: Projection, world: Array, origin: Vector | None, kind: str
) -> Callable[[], Rows]:
    """Return a function that applies matrix, division and viewport in one precision, as a GPU does.

    Parameters
    ----------
    origin : Vector or None
        World point that is subtracted from the vertices once, in float64. None subtracts the eye,
        which moves, in every run.
    kind : str
        ``"float32"`` or ``"float64"``. With an origin, float32 is bit for bit the
        precision ``float32`` of `app.precision.levels`.
    """
    columns = np.ascontiguousarray(world.T)
    eye = np.array(projection.camera.eye).reshape(3, 1)
    with np.errstate(all="ignore"):
        if origin is None:
            matrix = projection.clip_from_eye.astype(kind)
        else:
            matrix = projection.clip_from_world_at(origin).astype(kind)
            columns = (columns - np.reshape(origin, (3, 1))).astype(kind)
    offset, product = np.empty_like(columns), np.empty(columns.shape[1], dtype=kind)
    done = np.empty((4, columns.shape[1]), dtype=kind)
    x, y, z, w = done
    # Nothing but arithmetic remains to be done in a run.
    rows = [(row, *map(np.array, cells)) for row, cells in zip(done, matrix, strict=True)]
    sides = np.array(projection.image_size) / 2.0
    width, height, one, half = (np.array(each, dtype=kind) for each in (*sides, 1.0, 0.5))
    opengl = projection.depth == "opengl"
    add, multiply, divide = np.add, np.multiply, np.divide

    def run() -> Rows:
        points = columns
        if origin is None:
            points = np.subtract(columns, eye, out=offset).astype(kind, copy=False)
        for row, a, b, c, d in rows:
            multiply(a, points[0], row)
            add(row, multiply(b, points[1], product), row)
            add(row, multiply(c, points[2], product), row)
            add(row, d, row)
        for row in (x, y, z):
            divide(row, w, row)
        multiply(add(x, one, x), width, x)
        multiply(np.subtract(one, y, y), height, y)
        if opengl:
            add(multiply(z, half, z), half, z)
        return done[:3]

    return run


def peers(
    projection: Projection, world: Array
) -> tuple[dict[str, TimedProjection], dict[str, str]]:
    """Return the projections of other libraries in float64, and why some are missing.

    Each library gets the matrix and the points in its own kind of array; numpy does what it lacks.
    """
    projections: dict[str, TimedProjection] = {}
    missing: dict[str, str] = {}
    with np.errstate(all="ignore"):  # an overflow is a result
        matrix = np.array(projection.clip_from_world)
    columns = np.ascontiguousarray(world.T)
    scale, shift = np.diagonal(projection.image_from_ndc)[:3], projection.image_from_ndc[:3, 3]

    def viewport(ndc: Rows) -> Rows:
        ndc *= scale
        ndc += shift
        return ndc

    def numpy(_module: Any) -> TimedProjection:
        def run() -> Rows:
            clip = np.hstack([world, np.ones((len(world), 1))]) @ matrix.T
            return viewport(clip[:, :3] / clip[:, 3:])

        return TimedProjection(run, np.transpose)

    def vtk(_module: Any) -> TimedProjection:
        transform, elements = vtkPerspectiveTransform(), vtkMatrix4x4()
        elements.DeepCopy(matrix.ravel().tolist())
        transform.SetMatrix(elements)
        source, target = vtkPoints(), vtkPoints()
        source.SetData(numpy_to_vtk(world))  # type: ignore[no-untyped-call]
        target.SetDataTypeToDouble()

        def run() -> Any:
            target.Reset()
            transform.TransformPoints(source, target)
            return viewport(vtk_to_numpy(target.GetData()))  # type: ignore[no-untyped-call]

        return TimedProjection(run, np.transpose)

    def proj3d(module: Any) -> TimedProjection:
        def run() -> Any:
            ndc = module.proj_transform(*columns, matrix)
            return [part * by + to for part, by, to in zip(ndc, scale, shift, strict=True)]

        return TimedProjection(run, np.array)

    def pylinalg(module: Any) -> TimedProjection:
        return TimedProjection(lambda: viewport(module.vec_transform(world, matrix)), np.transpose)

    def pyglm(module: Any) -> TimedProjection:
        transform = module.dmat4(*matrix.T.ravel().tolist())
        vectors = module.array(np.column_stack([world, np.ones(len(world))]))

        def run() -> Rows:
            clip = np.asarray(transform * vectors)
            return viewport(clip[:, :3] / clip[:, 3:])

        return TimedProjection(run, np.transpose)

    for name, module, make in (
        ("numpy's hstack", "numpy", numpy),
        ("VTK's transform", "vtkmodules", vtk),
        ("matplotlib's proj3d", "mpl_toolkits.mplot3d.proj3d", proj3d),
        ("pylinalg", "pylinalg", pylinalg),
        ("PyGLM", "pyglm.glm", pyglm),
    ):
        try:
            projections[name] = make(importlib.import_module(module))
        except ModuleNotFoundError:
            missing[name] = NOT_INSTALLED
        except Exception as error:  # whatever a library does when it is imported
            missing[name] = f"{type(error).__name__}: {error}"
    return projections, missing


def measure(
    projection: Projection,
    points_world: Array,
    origin: Vector = (0.0, 0.0, 0.0),
    seconds: float = 10.0,
    watch: Watch = unwatched,
) -> Trade:
    """Measure trade 1 with the scene's vertices (n, 3); `origin` as for `summed`.

    Raises
    ------
    Cancelled
        By `watch`; with the errors, and the times so far.
    """
    world = looked_at(projection, points_world)
    if not len(world):
        return Trade(
            "arithmetic", "ns", "px", (ChartPoint("", None, None, None, note=NO_POINTS),), 0
        )
    judged, where = sample(world)
    reference = truth(projection, judged)
    predicted = predict(projection, world, origin) or {}
    others, missing = peers(projection, world)
    every = timed_projections(projection, world, origin) | others
    with np.errstate(all="ignore"):
        largest = {
            name: _largest(reference, np.asarray(way.rows(way.run()), dtype=np.float64).T[where])
            for name, way in every.items()
        }
    choices = []
    for name, (errors, note) in largest.items():
        precision = _PRECISIONS.get(name)
        expected = None if precision is None else predicted.get(precision)
        use = {} if precision in (None, "exact") else {"rung": str(precision)}
        choice = _choice(name, errors, expected, note, use, every[name].bytes)
        choices.append(replace(choice, library=name in others))
    box = np.stack([points_world.min(axis=0), points_world.max(axis=0)])
    for name, (hardware, drawn) in CHEAP.items():
        picture = cheap(projection, world, hardware, origin, box)
        answers = np.column_stack([picture.image, picture.depth])[where]
        errors, note = _largest(reference, answers)
        bounds = picture.bounds.max(axis=0).tolist()
        prediction = Prediction(max(bounds[:2]), bounds[2])
        use = {"scene": "cheap-arithmetic", **drawn}
        # Snapping and reciprocals save no memory, so they have no place among the formats.
        size = None if hardware.vertices == "float32" else hardware.bytes_per_vertex
        choices.append(_choice(name, errors, prediction, note or IN_SOFTWARE, use, size))
    choices += [
        ChartPoint(name, None, None, None, note=note, library=True)
        for name, note in missing.items()
    ]
    choices.sort(key=lambda choice: choice.library)
    trade = Trade("arithmetic", "ns", "px", tuple(choices), 0)
    runs = {name: way.run for name, way in every.items()}
    with np.errstate(all="ignore"):
        return timed(trade, runs, seconds, 1e9 / len(world), watch)


def _choice(
    name: str,
    errors: Prediction | None,
    predicted: Prediction | None,
    note: str,
    use: Mapping[str, str],
    size: float | None,
) -> ChartPoint:
    depths = {"error_depth": errors, "predicted_depth": predicted}
    values = {key: each.depth for key, each in depths.items() if each is not None}
    px, expected = (None if each is None else each.px for each in (errors, predicted))
    return ChartPoint(name, None, None, px, expected, values, note, use, size)


def _largest(reference: Truth, answers: Array) -> tuple[Prediction | None, str]:
    errors = reference.errors(answers)
    if np.isnan(answers).any():
        return None, NOT_A_NUMBER
    if np.isinf(answers).any():
        return None, INFINITE
    return Prediction(float(errors[:, :2].max()), float(errors[:, 2].max())), ""


# --------------------------------------------------------------------------- sweeps


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
    from_top: bool = False
    """Whether the steps also shrink towards the upper end: 179.9, 179.99, ..."""


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
    "near": Range("", 1e-200, 1e99, (1e-6, 1e9), _with_near),
    "far": Range("", 1e-6, 1e99, (1e-6, 1e9), _with_far),
    "fov": Range("°", 1e-80, 180.0 - 1e-12, (1.0, 179.0), _with_fov, from_top=True),
    "distance": Range("", 1e-3, 1e16, (1.0, 1e9), _with_distance),
    "up": Range("°", 1e-13, 90.0, (1.0, 90.0), _with_up_angle),
    "aspect": Range("", 1e-12, 1e12, (0.1, 10.0), _with_aspect),
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
    at: Callable[[str, Projection, Array, float], Mapping[str, Answer]] | None = None,
) -> Sweep:
    """Measure something at every value of a parameter, with the scene's points (n, 3).

    `at` returns the answer of each choice; by default `errors`.

    Raises
    ------
    Cancelled
        By `watch`; with the values done.
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


def _curve(answers: Sequence[Answer]) -> ErrorCurve:
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
        names = (*_PRECISIONS, "VTK's camera", *([WORLD] if parameter == "distance" else []))
        return dict.fromkeys(names, (None, None, str(error)))
    world = in_view(there, points_world + moved)
    reference = truth(there, world)
    origin = tuple(moved.tolist())
    origins = {name: (precision, origin) for name, precision in _PRECISIONS.items()}
    if parameter == "distance":
        origins[WORLD] = "float32", (0.0, 0.0, 0.0)
    answers: dict[str, Answer] = {}
    with np.errstate(all="ignore"):
        for name, (precision, start) in origins.items():
            traced = trace(there, world, precision, start)
            largest, note = _largest(reference, np.column_stack([traced.image, traced.depth]))
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
    traced = projection.trace(points_world)
    inside = points_world[traced.in_front & ~traced.outside.any(axis=1)]
    if len(inside) >= SAMPLE:
        step = len(inside) // SAMPLE
        kept: Array = inside[::step][:SAMPLE]
        return kept
    rng = np.random.default_rng(1)
    width, height = projection.image_size
    lens = projection.lens
    far = lens.far if math.isfinite(lens.far) else 1e3 * max(abs(lens.near), 1e-100)
    near = lens.near
    if lens.even_extent:
        depth = near + (far - near) * rng.uniform(0.02, 0.98, SAMPLE)
    else:
        # No farther than float64 can place a point beside this eye.
        depth = np.geomspace(near, min(far, 1e9 * near), SAMPLE + 2)[1:-1]
    pixels = rng.uniform(0.02, 0.98, (SAMPLE, 2)) * (width, height)
    world = _spread(projection, pixels, depth)
    traced = projection.trace(world)
    seen = traced.in_front & ~traced.outside.any(axis=1)
    # A view too narrow for float64 points still contains its middle.
    return world[seen] if seen.any() else np.array([projection.camera.target])


def _spread(projection: Projection, pixels: Array, depth: Array) -> Array:
    """Return the world points behind pixels at some distances from the eye plane."""
    left, right, bottom, top = projection.window
    width, height = projection.image_size
    x = left + (right - left) * pixels[:, 0] / width
    y = top - (top - bottom) * pixels[:, 1] / height
    grow = projection.lens.enlarged(depth)
    view = np.column_stack([x * grow, y * grow, -depth])
    world: Array = view @ projection.camera.frame + projection.camera.eye
    return world


def _vtk_camera(projection: Projection, world: Array, reference: Truth) -> Answer:
    """Set VTK's own camera as a program would, and note which of the values it changes."""
    lens, camera = projection.lens, vtkCamera()
    camera.SetPosition(*projection.camera.eye)
    camera.SetFocalPoint(*projection.camera.target)
    camera.SetViewUp(*projection.camera.up)
    camera.SetClippingRange(lens.near, lens.far)
    left, right, bottom, top = projection.window
    fov_y_deg = lens.fov_y_deg
    if not lens.central:
        camera.ParallelProjectionOn()
        camera.SetParallelScale((top - bottom) / 2.0)
    else:
        if fov_y_deg is None:
            fov_y_deg = math.degrees(2.0 * math.atan2(top, lens.near))
        camera.SetViewAngle(fov_y_deg)
    aspect = (right - left) / (top - bottom)
    elements = camera.GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)
    matrix = np.array([elements.GetElement(i, j) for i in range(4) for j in range(4)])
    clip = np.column_stack([world, np.ones(len(world))]) @ matrix.reshape(4, 4).T
    ndc = clip[:, :3] / clip[:, 3:]
    width, height = projection.image_size
    answers = np.column_stack(
        [(ndc[:, 0] + 1.0) * width / 2.0, (1.0 - ndc[:, 1]) * height / 2.0, (ndc[:, 2] + 1.0) / 2.0]
    )
    notes = []
    if fov_y_deg not in (None, camera.GetViewAngle()):
        notes.append(f"clamps the view angle to {camera.GetViewAngle():g}°")
    if camera.GetClippingRange() != (lens.near, lens.far):
        notes.append("changes near or far")
    errors, note = _largest(reference, answers)
    if note:
        notes.insert(0, note)
    return errors, None, "; ".join(notes)
