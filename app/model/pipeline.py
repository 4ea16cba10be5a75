"""A camera, a lens, an image and an object, and all displayed matrices between them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, reduce
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.arithmetic.rationals import Rationals, diagonal, product, rationals, shift
from app.model.camera import Camera
from app.model.chain import NOT_MOVED, SPACES, Chain, Space, WorldPoints
from app.model.formula import FLOAT64
from app.model.lenses import Lens, Perspective
from app.model.lenses.answers import Axis, ExactLens, Window
from app.model.lenses.oblique import COTS
from app.model.limits import (
    DEPTH_RANGES,
    LARGEST,
    LARGEST_IMAGE_PX,
    LARGEST_INVERSE,
    Array,
    DepthRange,
    Frozen,
    check_name,
    check_type,
    is_number,
    keep_checked,
    read_only,
)
from app.model.refusal import REFUSALS, Bound, Refusal
from app.model.tables import VIEWPORT, PipelineStep, evaluated, inverse, rounded

HalfSpaces: TypeAlias = list[tuple[tuple[float, float, float, float], float]]
"""Normals and offsets: ``normal . (x, y, z, w) + offset >= 0`` inside."""


class Trace(NamedTuple):
    """Points followed through every stage; ``...`` is the shape of the points without the 3.

    - `world`, `view` (..., 3): coordinates.
    - `clip` (..., 4): before the divide; w is the distance from the eye plane (1 for a parallel
      lens).
    - `ndc` (..., 3): after the divide; NaN where w <= 0, because a point behind the eye has no
      picture, and for a point so close to the eye plane that its picture is beyond float64's 1e308.
    - `image` (..., 2): pixels, origin top-left; NaN where `ndc` is.
    - `depth` (...): what a depth buffer in [0, 1] would hold before quantising; NaN where `ndc` is.
    - `in_front` (...): whether there is a picture: w > 0.
    - `outside` (..., 6): whether the point lies beyond each of `PLANES`.
    """

    world: Array
    view: Array
    clip: Array
    ndc: Array
    image: Array
    depth: Array
    in_front: NDArray[np.bool_]
    outside: NDArray[np.bool_]


def empty_trace(points: Array) -> Trace:
    """The trace of points (n, 3) or (n, 4), whose other numbers are still to be computed."""
    count, width = points.shape
    # One large block: the system allocates it many times faster than several.
    numbers = np.empty((width + 10) * count)
    view, clip, ndc, image = (
        numbers[first * count : last * count].reshape(count, last - first)
        for first, last in zip((10, 0, 4, 7), (width + 10, 4, 7, 9), strict=True)
    )
    in_front, outside = np.empty(count, dtype=bool), np.empty((count, 6), dtype=bool)
    depth = numbers[9 * count : 10 * count]
    return Trace(points, view, clip, ndc, image, depth, in_front, outside)


class Stage(NamedTuple):
    """One step of the pipeline in numbers.

    - `factors`: names and (4, 4) factors whose product, in this order, is the matrix; empty for
      the identity.
    """

    name: str  # ``target_from_source``
    exact: Rationals  # (4, 4): the matrix before it is rounded
    factors: tuple[tuple[str, Array], ...]
    note: str  # a remark about the stage for this lens, or empty

    @property
    def matrix(self) -> Array:
        """The matrix, (4, 4), every number rounded once."""
        return rounded(self.exact)


class Link(NamedTuple):
    """One factor of the way from the object to the picture.

    - `exact`: its matrix before it is rounded; None for the divide by w.
    - `so_far`: the product of all factors up to it, from object coordinates.
    """

    name: str
    exact: Rationals | None
    so_far: Rationals


def _product(name: str, factors: Sequence[tuple[str, Rationals]], note: str = "") -> Stage:
    whole = reduce(product, [factor for _, factor in factors] or [diagonal(1, 1, 1, 1)])
    return Stage(name, whole, tuple((label, rounded(f)) for label, f in factors), note)


@dataclass(frozen=True)
class Pipeline(Frozen):
    """Everything that a picture depends on, and the matrices of its steps.

    Raises a `Refusal` for an image side outside 1..`LARGEST_IMAGE_PX` or an unknown depth range.
    """

    camera: Camera = Camera()
    lens: Lens = Perspective()
    image_size: tuple[int, int] = (1280, 720)  # width and height in pixels
    depth: DepthRange = "opengl"  # the NDC range of z: "opengl", "direct3d" or "reversed"
    placement: Chain = NOT_MOVED  # where the scene's object stands

    def __post_init__(self) -> None:
        try:
            size = tuple(self.image_size)
            if len(size) != 2 or isinstance(self.image_size, str):
                raise TypeError
        except TypeError:
            raise Refusal("image", self.image_size, REFUSALS["two-sides"]) from None
        for name, side in zip(("width", "height"), size, strict=True):
            if not is_number(side) or not 1 <= side <= LARGEST_IMAGE_PX or side != int(side):
                raise Refusal(name, side, REFUSALS["whole-pixels"], LARGEST_IMAGE_PX)
        check_name("depth", self.depth, DEPTH_RANGES)
        for name, kind in (("camera", Camera), ("lens", Lens), ("placement", Chain)):
            check_type(name, getattr(self, name), kind)
        keep_checked(self, image_size=(int(size[0]), int(size[1])))
        self.lens.check_image(Fraction(*self.image_size))

    # -- plain figures

    @property
    def aspect(self) -> float:
        """The image's width over its height."""
        return self.image_size[0] / self.image_size[1]

    @property
    def depth_range(self) -> tuple[float, float]:
        """NDC z of the near and of the far plane."""
        return DEPTH_RANGES[self.depth]

    @cached_property
    def has_camera(self) -> bool:
        """Whether the view belongs to a camera, and was not typed as a matrix."""
        return self.lens.own_view is None

    @cached_property
    def window(self) -> Window:
        """Left, right, bottom, top of the picture on the near plane, in world units."""
        return self.lens.window(Fraction(*self.image_size))

    @cached_property
    def axes(self) -> tuple[Axis, Axis]:
        """The picture's x and y range on the near plane, after `keep`, before rounding."""
        exact = self.lens.exact_window(Fraction(*self.image_size))
        return Axis.between(*exact[:2]), Axis.between(*exact[2:])

    @cached_property
    def stretch(self) -> float:
        """How much the lens magnifies rounding errors of view coordinates in NDC; usually about 4.

        A view coordinate is off by some 1e-16 of the point's distance from the eye. The stretch is
        the largest ratio of this distance to half the width or height of the picture there, times
        what the lens adds.
        """
        return self.lens.stretch(self.window)

    # -- letters

    @cached_property
    def _letters(self) -> dict[str, float]:
        """The values of the letters of the lens's table, in float64."""
        z_near, z_far = self.depth_range
        return {**self.lens.letters(Fraction(*self.image_size)), "z_n": z_near, "z_f": z_far}

    @cached_property
    def exact_letters(self) -> dict[str, Fraction]:
        """The values of the letters of every step after the view matrix, in rationals."""
        width, height = map(Fraction, self.image_size)
        z_near, z_far = map(Fraction, self.depth_range)
        own = {"z_n": z_near, "z_f": z_far, "z_low": min(z_near, z_far), "W": width, "H": height}
        return {**self.lens.exact_letters(width / height), **own}

    # -- matrices in float64

    @cached_property
    def view_rotation(self) -> Array:
        """Factor R of the view matrix: rows u, v, n (lecture 004), (4, 4)."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.camera.frame
        return read_only(matrix)

    @cached_property
    def view_translation(self) -> Array:
        """Factor P of the view matrix: the eye moves to the origin (lecture 004), (4, 4)."""
        return read_only(translation(-np.array(self.camera.eye)))

    @cached_property
    def view_from_world(self) -> Array:
        """The view matrix R P of lecture 004, or the one typed in its place, (4, 4)."""
        if self.lens.own_view is not None:
            return read_only(self.lens.own_view)
        return read_only(self.view_rotation @ self.view_translation)

    @cached_property
    def _closed_forms(self) -> Array:
        """`clip_from_view` above its inverse, if the lens's table has that, (8 or 4, 4)."""
        table = self.lens.table
        rows = table.clip_from_view + (table.view_from_clip or ())
        return read_only(evaluated(rows, self._letters, FLOAT64))

    @cached_property
    def clip_from_view(self) -> Array:
        """The lens's matrix for the depth range, from the closed form of its table, (4, 4)."""
        return self._closed_forms[:4]

    @cached_property
    def view_from_clip(self) -> Array:
        """The inverse of `clip_from_view`, (4, 4), or a `Refusal` for a singular typed matrix."""
        if len(self._closed_forms) == 4:
            return rounded(inverse("clip_from_view", rationals(self.clip_from_view.tolist())))
        return self._closed_forms[4:]

    @cached_property
    def clip_from_world(self) -> Array:
        return read_only(self.clip_from_view @ self.view_from_world)

    @cached_property
    def clip_from_eye(self) -> Array:
        """Clip from world axes with their origin in the eye, (4, 4)."""
        if self.lens.planes is None:
            return rounded(self.exact_from_eye[1])
        return read_only(self.clip_from_view @ self.view_rotation)

    @cached_property
    def image_from_ndc(self) -> Array:
        """The viewport matrix (lecture 002), (4, 4): x, y to pixels, z to depth in [0, 1]."""
        width, height = self.image_size
        z_low = min(self.depth_range)
        matrix = np.diag([width / 2.0, -height / 2.0, 1.0 / (1.0 - z_low), 1.0])
        matrix[:3, 3] = width / 2.0, height / 2.0, -z_low / (1.0 - z_low)
        return read_only(matrix)

    # -- matrices in rationals

    @cached_property
    def exact_from_eye(self) -> tuple[Rationals, Rationals]:
        """The matrices to view and clip space from ``(p - eye, 1)``, before rounding.

        A typed view matrix may look from elsewhere. The eye is then only a nearby point: the digits
        that it shares with a point are subtracted before any product.
        """
        if self.lens.own_view is None:
            view = self._exact_rotation
        else:
            view = product(rationals(self.lens.own_view), shift(*map(Fraction, self.camera.eye)))
        return view, product(self.exact_clip_from_view, view)

    @cached_property
    def exact_clip_from_view(self) -> Rationals:
        """The clip matrix from view space in rationals: the product of `lens_stages`."""
        return evaluated(self.lens.table.clip_from_view, self.exact_letters)

    @property
    def _exact_rotation(self) -> Rationals:
        rotation = diagonal(1, 1, 1, 1)
        for row, axis in zip(rotation, self.camera.exact_frame, strict=False):
            row[:3] = axis
        return rotation

    @cached_property
    def exact_lens(self) -> ExactLens:
        """The numbers of the lens before they are rounded to float64."""
        zero, letters = Fraction(0), self.exact_letters
        upright = {**letters, **dict.fromkeys(COTS, zero)}
        x, y, _, w = evaluated(self.lens.table.clip_from_view, upright)
        at = 2 if w[2] else 3  # the column of w
        cot_alpha, cot_beta = (letters.get(cot, zero) for cot in COTS)
        return ExactLens(
            (x[0], y[1]),
            (x[at] / w[at], y[at] / w[at]),
            (cot_alpha, cot_beta),
            Fraction(self.lens.near),
            letters.get("f"),
        )

    @cached_property
    def eye_from_clip(self) -> Rationals:
        """The inverse of the clip matrix of `exact_from_eye`, or a `Refusal`."""
        view_from_clip = inverse("clip_from_view", self.exact_clip_from_view)
        whole = product(inverse("view_from_world", self.exact_from_eye[0]), view_from_clip)
        if max(abs(part) for row in whole for part in row) > LARGEST_INVERSE:
            raise Refusal("clip_from_view", self.clip_from_view.tolist(), REFUSALS["small-inverse"])
        return whole

    @cached_property
    def stages(self) -> tuple[Stage, ...]:
        """The pipeline in order; the divide by w comes between clip and NDC.

        The canonical volumes are those of lecture 001: for a perspective lens the pyramid with its
        apex in the eye, x and y from -1 to 1 at z = -1, and for every lens the box with x, y from
        -1 to 1 and z from 0 at near to -1 at far. Every number is computed in rationals and
        rounded once.
        """
        placed, viewport = map(self.staged, (self.placement.step, VIEWPORT))
        return placed, self._view_stage, *self.lens_stages, viewport

    @cached_property
    def lens_stages(self) -> tuple[Stage, ...]:
        """The `stages` from view to clip space; none if the lens has only a whole matrix."""
        return tuple(map(self.staged, self.lens.table.steps))

    def staged(self, step: PipelineStep) -> Stage:
        """Return a step of a table in this projection's numbers."""
        letters: Mapping[str, Fraction] = self.exact_letters | self.placement.letters
        factors = [(name, evaluated(table, letters)) for name, table in step.factors]
        return _product(step.name, factors, step.note)

    @property
    def _view_stage(self) -> Stage:
        if self.lens.own_view is not None:
            return Stage("view_from_world", rationals(self.lens.own_view), (), "")
        factors = [
            ("rotation", self._exact_rotation),
            ("translation", shift(*(Fraction(-part) for part in self.camera.eye))),
        ]
        view = _product("view_from_world", factors)
        # The product's zeros cancel only to the last bit of the frame.
        for row, part in zip(view.exact, self.camera.exact_origin, strict=False):
            row[3] = part
        return view

    @property
    def links(self) -> tuple[Link, ...]:
        """Every factor from the object to the picture, in the order in which they act on a point.

        A tile is named by its text. The product is written in the reverse order.
        """
        tiles = [*zip(self.placement.on, self.placement.factors, strict=True)]
        named: list[tuple[str, Rationals | None]] = [(tile.text, f) for tile, f in reversed(tiles)]
        if self.has_camera:
            moved = shift(*(Fraction(-part) for part in self.camera.eye))
            named.extend([("view translation", moved), ("view rotation", self._exact_rotation)])
        else:
            named.append(("view_from_world", self._view_stage.exact))
        named.extend((each.name, each.exact) for each in self.lens_stages or self.direct_stages[:1])
        named.extend([("divide by w", None), (VIEWPORT.name, self.staged(VIEWPORT).exact)])
        links, so_far = [], diagonal(1, 1, 1, 1)
        for name, exact in named:
            so_far = product(exact, so_far) if exact else so_far
            links.append(Link(name, exact, so_far))
        return tuple(links)

    @cached_property
    def direct_stages(self) -> tuple[Stage, Stage]:
        """`clip_from_view` and `clip_from_world` as products of `stages`, rounded once."""
        view, exact = self._view_stage, self.exact_clip_from_view
        steps = tuple((stage.name, stage.matrix) for stage in reversed(self.lens_stages))
        direct = Stage("clip_from_view", exact, steps, "")
        all_steps = *(steps or [(direct.name, direct.matrix)]), (view.name, view.matrix)
        return direct, Stage("clip_from_world", product(exact, view.exact), all_steps, "")

    @property
    def all_stages(self) -> tuple[Stage, ...]:
        """`stages`, with the products `direct_stages` before the last one, the viewport."""
        *steps, viewport = self.stages
        return (*steps, *self.direct_stages, viewport)

    # -- points

    def placed(self, points: ArrayLike, space: Space = "world", one: int = 1) -> WorldPoints:
        """World coordinates, (n, 3), of points (..., 3), with twice the digits of float64.

        `one` is w: 0 for directions.

        Raises a `Refusal` for a coordinate that is not a finite number, and for another space.
        """
        check_name("space", space, SPACES)
        given = checked_points(points).reshape(-1, 3)
        if space == "world" or self.placement.is_identity:
            return WorldPoints.at(given)
        return self.placement.placed(given, one)


def translation(offset: ArrayLike) -> Array:
    matrix = np.eye(4)
    matrix[:3, 3] = offset
    return matrix


def checked_points(
    points: ArrayLike, widths: tuple[int, ...] = (3,), name: str = "points"
) -> Array:
    """Points as a new float64 array, (..., 3), or (..., 4) if `widths` has 4, or a `Refusal`.

    They must be rows of finite numbers up to `LARGEST`.
    """
    try:
        given = np.asanyarray(points)
    except ValueError:  # rows of different lengths
        raise Refusal(name, points, REFUSALS["equal-rows"]) from None
    if isinstance(given, np.ma.MaskedArray) and given.mask.any():
        _refuse_first(name, given, np.ma.getmaskarray(given), REFUSALS["nothing-masked"])
    if given.dtype.kind not in "iuf" and given.size:
        cells = np.array(points, dtype=object)
        if not cells.ndim:
            raise Refusal(name, points, REFUSALS["finite-numbers"])
        _refuse_first(
            name, cells, ~np.vectorize(is_number, otypes=[bool])(cells), REFUSALS["finite-numbers"]
        )
        _refuse_first(
            name,
            cells,
            np.array(abs(cells) > LARGEST, dtype=bool),
            REFUSALS["numbers-up-to"],
            LARGEST,
        )
        raise Refusal(f"{name}.dtype", str(given.dtype), REFUSALS["real-numbers"])
    if given.shape[-1:] not in [(width,) for width in widths]:
        limit = " or ".join(map(str, widths))
        raise Refusal(f"{name}.shape", given.shape, REFUSALS["rows-of"], limit)
    with np.errstate(over="ignore"):  # of longer floats
        checked = np.array(given, dtype=np.float64)
    if not checked.size or (checked.max() <= LARGEST and checked.min() >= -LARGEST):
        return checked
    _refuse_first(name, checked, ~np.isfinite(checked), REFUSALS["finite-numbers"])
    _refuse_first(name, checked, np.abs(checked) > LARGEST, REFUSALS["numbers-up-to"], LARGEST)
    return checked


def _refuse_first(
    name: str, points: NDArray[Any], wrong: NDArray[np.bool_], bound: Bound, *limits: float
) -> None:
    """Refuse the first point that has a wrong number, by its place."""
    for place in np.argwhere(wrong.any(axis=-1))[:1].tolist():
        raise Refusal(
            named_point(place, name), tuple(points[tuple(place)].tolist()), bound, *limits
        )


def named_point(place: Sequence[int], name: str = "points") -> str:
    """Return the name of one of several points in a refusal."""
    return f"{name}[{', '.join(map(str, place))}]" if place else name


def checked_pixels(points_image: ArrayLike) -> Array:
    """Pixels with a depth in [0, 1] as a new float64 array, (..., 3), or a `Refusal`."""
    points = checked_points(points_image)
    depth = points[..., 2]
    for wrong, bound, limit in (
        (depth < 0.0, REFUSALS["at-least"], 0),
        (depth > 1.0, REFUSALS["at-most"], 1),
    ):
        if wrong.any():
            raise Refusal("depth", float(depth[wrong][0]), bound, limit)
    return points
