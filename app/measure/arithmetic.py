"""Trade 1, arithmetic: ns per point against the largest error in px and in depth.

Every way of projecting gets the same points, in its preferred layout, and does the same work: the
matrix, the divide and the viewport, as a GPU does. `reference.Truth` gives the errors of a sample
of the points. `summed` runs the same code in every precision: only the number format differs.
"""

import importlib
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkPerspectiveTransform

from app.measure.reference import Truth, sample, truth
from app.measure.results import ChartPoint, Trade, without_numbers
from app.measure.run import Watch, timed, unwatched
from app.model.projection import Array, Projection, Vector
from app.model.refusal import MEASURE
from app.precision.cheap import CheapPicture, Hardware, cheap
from app.precision.levels import Precision, Prediction, predict, trace
from app.scenes.phenomena.cheap_arithmetic import hardware_of

Rows: TypeAlias = NDArray[Any]
"""(3, n): x and y in pixels, depth in [0, 1]; NaN or infinite where there is no answer."""

MOST_POINTS = 16384  # number of points that are projected: every way does them in one block
PRECISIONS: dict[str, Precision] = {
    "float32": "float32",
    "float64, every stage": "float64",
    "exact": "exact",
}
"""The projections that are precisions of the model, which predicts their errors."""
_OWN = {
    "preset": "own", "snap": "none", "reciprocal": "exact",
    "vertices": "float32", "numbers": "float32",
}  # fmt: skip
CHEAP: dict[str, dict[str, str]] = {
    "8 bits": {"preset": "bits8"},
    "12 bits": {"preset": "bits12"},
    "16 bits": {"preset": "bits16"},
    "float16": {"preset": "half"},
    "bfloat16": _OWN | {"vertices": "bfloat16", "numbers": "bfloat16"},
    "fixed 16.16": _OWN | {"vertices": "fixed", "numbers": "fixed"},
    "float32, snapped to whole px": _OWN | {"snap": "whole"},
    "float32, snapped to 1/4 px": _OWN | {"snap": "quarter"},
    "float32, snapped to 1/16 px": _OWN | {"snap": "sixteenth"},
    "float32, reciprocal table": _OWN | {"reciprocal": "table"},
    "float32, reciprocal table, 1 Newton step": _OWN | {"reciprocal": "newton1"},
    "float32, reciprocal table, 2 Newton steps": _OWN | {"reciprocal": "newton2"},
}
"""What numpy can only imitate, judged but not timed: settings of the scene ``cheap-arithmetic``."""


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
    return np.asarray(np.resize(points[:: max(1, len(points) // MOST_POINTS)], (MOST_POINTS, 3)))


def timed_projections(
    projection: Projection, world: Array, origin: Vector
) -> dict[str, TimedProjection]:
    """Return our own projections, from float32 to the exact one; `origin` as for `summed`."""
    ours = {}
    for name, start in (("{}", origin), ("{}, eye first", None)):
        for kind, size in (("float32", 12.0), ("float64", 24.0)):
            size = 24.0 if start is None else size  # eye first, the points stay in float64
            run = summed(projection, world, start, kind)
            ours[name.format(kind)] = TimedProjection(run, np.asarray, size)
    for name, precision in PRECISIONS.items():
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

    The world point `origin` is subtracted from the vertices once, in float64; None subtracts the
    eye, which moves, in every run. `kind` is ``"float32"`` or ``"float64"``. With an origin,
    float32 is bit for bit the precision ``float32`` of `app.precision.levels`.
    """
    columns = np.ascontiguousarray(world.T)
    eye = np.array(projection.camera.eye).reshape(3, 1)
    with np.errstate(all="ignore"):
        matrix = projection.clip_from_eye.astype(kind)
        if origin is not None:
            matrix = projection.clip_from_local(origin).astype(kind)
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
            missing[name] = MEASURE["not-installed"]
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
    """Measure trade 1 with the scene's vertices (n, 3); `origin` as for `summed`."""
    world = looked_at(projection, points_world)
    if not len(world):
        return without_numbers("arithmetic", "px", MEASURE["no-points"])
    judged, where = sample(world)
    reference = truth(projection, judged)
    predicted = predict(projection, world, origin) or {}
    box = np.stack([points_world.min(axis=0), points_world.max(axis=0)])

    def imitated(hardware: Hardware) -> tuple[CheapPicture, Prediction]:
        picture = cheap(projection, world, hardware, origin, box)
        bounds = picture.bounds.max(axis=0).tolist()
        return picture, Prediction(max(bounds[:2]), bounds[2])

    if predicted:  # the numbers are the same, and the bound that runs along is nearer
        bounds = zip(predicted["float32"], imitated(Hardware())[1], strict=True)
        predicted["float32"] = Prediction(*map(min, bounds))
    others, missing = peers(projection, world)
    every = timed_projections(projection, world, origin) | others
    with np.errstate(all="ignore"):
        largest = {
            name: largest_errors(reference, np.asarray(way.rows(way.run()), np.float64).T[where])
            for name, way in every.items()
        }
    choices = []
    for name, (errors, note) in largest.items():
        precision = PRECISIONS.get(name)
        expected = None if precision is None else predicted.get(precision)
        use = {} if precision in (None, "exact") else {"rung": str(precision)}
        choice = _choice(name, errors, expected, note, use, every[name].bytes)
        choices.append(replace(choice, library=name in others))
    for name, settings in CHEAP.items():
        hardware = hardware_of(settings)
        picture, prediction = imitated(hardware)
        answers = np.column_stack([picture.image, picture.depth])[where]
        errors, note = largest_errors(reference, answers)
        use = {"scene": "cheap-arithmetic"}
        use |= {f"settings.{setting}": value for setting, value in settings.items()}
        # Snapping and reciprocals save no memory, so they have no place among the formats.
        size = None if hardware.vertices == "float32" else hardware.bytes_per_vertex
        choices.append(_choice(name, errors, prediction, note or MEASURE["in-software"], use, size))
    for name, note in missing.items():
        choices.append(ChartPoint(name, None, None, None, note=note, library=True))
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


def largest_errors(reference: Truth, answers: Array) -> tuple[Prediction | None, str]:
    errors = reference.errors(answers)
    if np.isnan(answers).any():
        return None, MEASURE["not-a-number"]
    if np.isinf(answers).any():
        return None, MEASURE["infinite"]
    return Prediction(float(errors[:, :2].max()), float(errors[:, 2].max())), ""
