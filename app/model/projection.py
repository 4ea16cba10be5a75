"""The shared projection model: camera, lens, image, and every matrix between them.

Conventions, stated once for the whole program:

=================  ==========================================================================
vectors, matrices  column vectors, ``p_out = M @ p_in``; batches are rows ``(..., 3)``; float64
names              ``target_from_source``; points carry their space (``points_world``)
world, view        right-handed, y up; the camera looks along -z of view space
camera frame       ``n = (eye - target)/|.|``, ``u = up x n / |.|``, ``v = n x u``
clip, NDC          OpenGL cube ``[-1, 1]^3``, near -> -1, far -> +1 (``opengl``);
                   ``direct3d`` maps near..far to ``[0, 1]``, ``reversed`` to ``[1, 0]``
image              origin top-left, x right, y down, pixels; the first pixel's centre is at 0.5
angles, lengths    degrees at every boundary (``_deg``), world units
=================  ==========================================================================

Points are projected *eye first*: the eye is subtracted before anything else, then the rotation,
then the closed form of the lens. A concatenated matrix loses the digits that the eye and the
point have in common (5e-5 px at 1e9 from the origin, against 1e-12 px here); it is still made,
because it is what a GPU is given and what the lectures write.

The dot products of the rotation are taken with some 75 bits, because a lens stretches their
rounding (a field of view near 0 or 180 degrees, a parallel camera far from its small window).

The letters u, v, n, the look-at and the view matrix are those of lecture 004 (Horvat); the
perspective matrix is equation (13) of lecture 000, the oblique one P_ort H of lecture 002, the
canonical volumes and the matrices M_pp and M_z between them those of lecture 001.
"""

from __future__ import annotations

import numbers
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, lru_cache, reduce
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble
from app.arithmetic.rationals import Rationals, product, rationals
from app.model.camera import Camera, Orbit
from app.model.formula import FLOAT64
from app.model.lenses import (
    LENSES,
    FreeMatrix,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    kinds,
)
from app.model.lenses.lens import LensTable, Seen
from app.model.lenses.oblique import OBLIQUE_PRESETS, oblique_angles, receding_of
from app.model.lenses.perspective import (
    focal_length_35mm,
    focal_length_e,
    fov_x_from_fov_y,
    fov_y_from_focal_length_35mm,
    fov_y_from_focal_length_e,
    fov_y_from_window,
)
from app.model.lenses.setup import Axis, ExactLens, Intrinsics, Trace
from app.model.limits import (
    AT_LEAST,
    AT_MOST,
    BETWEEN,
    DEPTH_RANGES,
    FINITE_NUMBER,
    LARGEST,
    LARGEST_IMAGE_PX,
    LARGEST_INVERSE,
    LARGEST_SHEAR,
    NOT_THE_EYE,
    ONE_OF,
    PLANES,
    SMALL_INVERSE,
    SMALLEST_FIELD,
    SMALLEST_OPENING,
    THREE_NUMBERS,
    WHOLE_PIXELS,
    Array,
    DepthRange,
    Vector,
    finite,
    keep_checked,
    positive,
    read_only,
    within,
)
from app.model.object_transform import NOT_MOVED, SPACES, ObjectTransform, Placed, Space
from app.model.refusal import Refusal
from app.model.tables import VIEWPORT, Step, evaluated, inverse, rounded

__all__ = [  # the model's one door: what its other rooms hold can be had here
    "AT_LEAST",
    "AT_MOST",
    "BETWEEN",
    "DEPTH_RANGES",
    "FINITE_NUMBER",
    "LARGEST",
    "LARGEST_IMAGE_PX",
    "LARGEST_SHEAR",
    "LENSES",
    "NOT_THE_EYE",
    "OBLIQUE_PRESETS",
    "ONE_OF",
    "PLANES",
    "THREE_NUMBERS",
    "WHOLE_PIXELS",
    "Array",
    "Camera",
    "DepthRange",
    "ExactLens",
    "FreeMatrix",
    "Frustum",
    "Intrinsics",
    "Lens",
    "ObjectTransform",
    "Oblique",
    "Orbit",
    "Orthographic",
    "Perspective",
    "Placed",
    "Projection",
    "Rationals",
    "Space",
    "Stage",
    "Trace",
    "Vector",
    "checked_points",
    "focal_length_35mm",
    "focal_length_e",
    "fov_x_from_fov_y",
    "fov_y_from_focal_length_35mm",
    "fov_y_from_focal_length_e",
    "fov_y_from_window",
    "kinds",
    "oblique_angles",
    "receding_of",
]

_LARGE_STRETCH = 2.0**24  # `Projection.stretch` up to which dot products of 75 bits will do
_ABOVE_OFFSETS = 2.0**27  # added and taken away again, leaves the upper 27 bits of the offsets


def _translation(offset: ArrayLike) -> Array:
    matrix = np.eye(4)
    matrix[:3, 3] = offset
    return read_only(matrix)


class Stage(NamedTuple):
    """One step of the pipeline.

    Attributes
    ----------
    name : str
        ``target_from_source``.
    exact : 4 lists of 4 Fraction
        The matrix before it is rounded.
    factors : tuple of (str, (4, 4) array)
        Named factors whose product, in this order, is the matrix; empty for the identity.
    note : str
        What is special about it for this lens; empty if nothing is.
    """

    name: str
    exact: Rationals
    factors: tuple[tuple[str, Array], ...]
    note: str

    @property
    def matrix(self) -> Array:
        """The matrix, (4, 4), every number rounded once."""
        return rounded(self.exact)


def _stage(step: Step, letters: Mapping[str, Fraction]) -> Stage:
    """A step of a table in numbers."""
    factors = [(name, evaluated(table, letters)) for name, table in step.factors]
    return _product(step.name, factors, step.note)


def _product(name: str, factors: Sequence[tuple[str, Rationals]], note: str = "") -> Stage:
    """A stage that is the product of its factors."""
    whole = _diagonal(1, 1, 1, 1)
    for _, factor in factors:
        whole = product(whole, factor)
    return Stage(name, whole, tuple((label, rounded(f)) for label, f in factors), note)


def _diagonal(*parts: Fraction | int) -> Rationals:
    return [[Fraction(part if i == j else 0) for j in range(4)] for i, part in enumerate(parts)]


def _shift(*offset: Fraction | int) -> Rationals:
    matrix = _diagonal(1, 1, 1, 1)
    for row, part in zip(matrix, offset, strict=False):
        row[3] = Fraction(part)
    return matrix


@dataclass(frozen=True)
class Projection:
    """A camera, a lens, an image, a depth range and an object: everything a picture depends on.

    A value that exists is a value that works; edits are made with `dataclasses.replace`.

    Parameters
    ----------
    camera : Camera
    lens : Perspective, Frustum, Orthographic, Oblique or FreeMatrix
    image_size : (int, int)
        Width and height in pixels.
    depth : {"opengl", "direct3d", "reversed"}
        The NDC range of z.
    placement : ObjectTransform
        Where the scene's object stands.

    Raises
    ------
    Refusal
        For an image side outside 1..`LARGEST_IMAGE_PX` or an unknown depth range.
    """

    camera: Camera = Camera()
    lens: Lens = Perspective()
    image_size: tuple[int, int] = (1280, 720)
    depth: DepthRange = "opengl"
    placement: ObjectTransform = NOT_MOVED

    def __post_init__(self) -> None:
        try:
            size = tuple(self.image_size)
            if len(size) != 2:
                raise TypeError
        except TypeError:
            raise Refusal("image", self.image_size, WHOLE_PIXELS, LARGEST_IMAGE_PX) from None
        for name, side in zip(("width", "height"), size, strict=True):
            whole = isinstance(side, numbers.Integral) and not isinstance(side, bool)
            if not whole or not 1 <= side <= LARGEST_IMAGE_PX:
                raise Refusal(name, side, WHOLE_PIXELS, LARGEST_IMAGE_PX)
        if not isinstance(self.depth, str) or self.depth not in DEPTH_RANGES:
            raise Refusal("depth", self.depth, ONE_OF, ", ".join(DEPTH_RANGES))
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
    def window(self) -> tuple[float, float, float, float]:
        """Left, right, bottom, top of the picture on the near plane, in world units."""
        return self.lens.window(Fraction(*self.image_size))

    @cached_property
    def axes(self) -> tuple[Axis, Axis]:
        """The picture's x and y range on the near plane, after `keep`, without its rounding."""
        exact = self.lens.exact_window(Fraction(*self.image_size))
        return Axis.between(*exact[:2]), Axis.between(*exact[2:])

    @property
    def intrinsics(self) -> Intrinsics:
        """The perspective camera's K.

        Raises
        ------
        Refusal
            For a parallel lens and for a free matrix, which have none.
        """
        return self.lens.intrinsics(self.image_size)

    @cached_property
    def stretch(self) -> float:
        """By how much the lens enlarges the rounding of view coordinates, in NDC.

        A view coordinate is wrong by some 1e-16 of the point's distance from the eye; this is
        that distance's largest ratio to the picture's half-width or half-height there, times
        what the lens adds. About 4 for everyday lenses.
        """
        return self.lens.stretch(self.window)

    @property
    def view_error(self) -> float:
        """What `trace`'s view coordinates lack beside their last rounding, of the distance from
        the eye (the sum of the offset's sizes); z with what its rounding cut off.
        """
        return 2.0**-74 if self.stretch <= _LARGE_STRETCH else 2.0**-96

    @property
    def shear(self) -> tuple[float, float]:
        """``cot(alpha), cot(beta)`` of an oblique lens, 0 and 0 of the others."""
        return self.lens.shear

    # -- matrices

    @cached_property
    def view_rotation(self) -> Array:
        """Factor R of the view matrix: rows u, v, n (lecture 004), (4, 4)."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.camera.frame
        return read_only(matrix)

    @cached_property
    def view_translation(self) -> Array:
        """Factor P of the view matrix: the eye moves to the origin (lecture 004), (4, 4)."""
        return _translation(-np.array(self.camera.eye))

    @cached_property
    def view_from_world(self) -> Array:
        """The view matrix R P of lecture 004, or the one typed in its place, (4, 4)."""
        if self.lens.own_view is not None:
            return read_only(self.lens.own_view)
        return read_only(self.view_rotation @ self.view_translation)

    @cached_property
    def clip_from_view(self) -> Array:
        """The lens' matrix, (4, 4), for the chosen depth range: its table's closed form."""
        return read_only(evaluated(self.lens.table.clip_from_view, self._letters, FLOAT64))

    @cached_property
    def view_from_clip(self) -> Array:
        """The inverse of `clip_from_view` in closed form, (4, 4); also for far = inf.

        Raises
        ------
        Refusal
            For a free matrix without an inverse.
        """
        return self.lens.view_from_clip(self, self._letters)

    @cached_property
    def _letters(self) -> dict[str, float]:
        """What the letters of the lens' table stand for, in float64."""
        z_near, z_far = self.depth_range
        return {**self.lens.letters(Fraction(*self.image_size)), "z_n": z_near, "z_f": z_far}

    @cached_property
    def _exact_letters(self) -> dict[str, Fraction]:
        """What the letters of every step stand for, in rationals."""
        width, height = map(Fraction, self.image_size)
        z_near, z_far = map(Fraction, self.depth_range)
        return {
            **self.lens.exact_letters(width / height),
            "z_n": z_near,
            "z_f": z_far,
            "z_low": min(z_near, z_far),
            "W": width,
            "H": height,
        }

    @cached_property
    def clip_from_world(self) -> Array:
        """`clip_from_view` times `view_from_world`, (4, 4)."""
        return read_only(self.clip_from_view @ self.view_from_world)

    def clip_from_world_at(self, origin: ArrayLike) -> Array:
        """`clip_from_world` for points given relative to `origin`.

        Parameters
        ----------
        origin : (3,) array_like
            World point that the given points are measured from. It meets the eye in float64
            before anything is multiplied, so that a scene at 1e9 loses no digit.

        Returns
        -------
        (4, 4) float64 array
        """
        return self.clip_from_local(origin)

    def local_to_eye(self, origin: ArrayLike, space: Space = "world") -> Array:
        """From points relative to `origin` to world axes with their origin in the eye, (4, 4).

        Parameters
        ----------
        origin : (3,) array_like
            In the space that the points are given in.
        space : {"world", "object"}
        """
        if space == "object" and not self.placement.is_identity:
            x, y, z = np.asarray(origin, dtype=np.float64).tolist()
            return self.placement.local_from((x, y, z), self.camera.eye)
        return _translation(np.asarray(origin, dtype=np.float64) - self.camera.eye)

    def clip_from_local(self, origin: ArrayLike, space: Space = "world") -> Array:
        """Clip from points relative to `origin`, in the world or of the object, (4, 4)."""
        return read_only(self.clip_from_eye @ self.local_to_eye(origin, space))

    @cached_property
    def clip_from_eye(self) -> Array:
        """Clip from world axes with their origin in the eye: `clip_from_world_at` it, (4, 4)."""
        return self.lens.clip_from_eye(self)

    @cached_property
    def exact_from_eye(self) -> tuple[Rationals, Rationals]:
        """View and clip from ``(p - eye, 1)``, before they are rounded.

        For a view matrix of its own the eye is but a point near by: what it and a point have in
        common is subtracted before anything is multiplied.
        """
        if self.lens.own_view is None:
            view = _diagonal(1, 1, 1, 1)
            for row, axis in zip(view, self.camera.exact_frame, strict=False):
                row[:3] = axis
        else:
            eye = map(Fraction, self.camera.eye)
            view = product(rationals(self.lens.own_view), _shift(*eye))
        return view, product(self.direct_stages[0].exact, view)

    @cached_property
    def eye_from_clip(self) -> Rationals:
        """The inverse of `exact_from_eye`'s clip matrix, or a `Refusal`."""
        view_from_clip = inverse("clip_from_view", self.direct_stages[0].exact)
        whole = product(inverse("view_from_world", self.exact_from_eye[0]), view_from_clip)
        if max(abs(part) for row in whole for part in row) > LARGEST_INVERSE:
            cells = self.clip_from_view.tolist()
            raise Refusal("clip_from_view", cells, SMALL_INVERSE)
        return whole

    @cached_property
    def frustum_sign(self) -> int:
        """The sign of w at all eight of the cube's corners un-projected; 0 for no frustum.

        A lens always has one, whose far corners may be at infinity. A free matrix has none
        without an inverse, with one too large to be drawn, or where infinity lies in or on its
        volume.
        """
        return self.lens.frustum_sign(self)

    @property
    def least_w(self) -> float:
        """The least w of what is in the view volume, or less: near, of a perspective lens."""
        return self.lens.least_w(self)

    def world_from_clip_at(self, origin: ArrayLike) -> Array:
        """The inverse of `clip_from_world_at`, (4, 4).

        Raises
        ------
        Refusal
            For a free matrix without an inverse, or one that float64 cannot hold.
        """
        shift = _translation(self.camera.eye - np.asarray(origin, dtype=np.float64))
        return read_only(reduce(np.matmul, self.lens.eye_from_clip(self), shift))

    @cached_property
    def image_from_ndc(self) -> Array:
        """The viewport matrix (lecture 002), (4, 4): x, y to pixels, z to depth in [0, 1]."""
        width, height = self.image_size
        z_low = min(self.depth_range)
        matrix = np.diag([width / 2.0, -height / 2.0, 1.0 / (1.0 - z_low), 1.0])
        matrix[:3, 3] = width / 2.0, height / 2.0, -z_low / (1.0 - z_low)
        return read_only(matrix)

    @cached_property
    def exact_lens(self) -> ExactLens:
        """The numbers that the lens is made of, without their rounding to float64."""
        return self.lens.exact(self._exact_letters)

    @cached_property
    def stages(self) -> tuple[Stage, ...]:
        """The pipeline in order; between clip and NDC comes the divide by w.

        The canonical volumes and the matrices between them are those of lecture 001: for a
        perspective lens the pyramid with its apex in the eye, x and y from -1 to 1 at z = -1, and
        for every lens the box x, y from -1 to 1, z from 0 at near to -1 at far.

        These are the matrices to be read: every number is computed in rationals and rounded once.
        """
        steps = (self.placement.step, *self.lens.table.steps, VIEWPORT)
        first, *rest = map(self.staged, steps)
        return (first, self._view_stage, *rest)

    def staged(self, step: Step) -> Stage:
        """A step of a table in this projection's numbers."""
        return _stage(step, self._exact_letters | self.placement.letters)

    @property
    def _view_stage(self) -> Stage:
        if self.lens.own_view is not None:
            return Stage("view_from_world", rationals(self.lens.own_view), (), "")
        eye = [Fraction(-part) for part in self.camera.eye]
        rotation = _diagonal(1, 1, 1, 1)
        for row, axis in zip(rotation, self.camera.exact_frame, strict=False):
            row[:3] = axis
        view = _product("view_from_world", [("rotation", rotation), ("translation", _shift(*eye))])
        # The product's zeros cancel to the last of the frame's bits only.
        for row, part in zip(view.exact, self.camera.exact_view((0.0, 0.0, 0.0)), strict=False):
            row[3] = part
        return view

    @cached_property
    def direct_stages(self) -> tuple[Stage, Stage]:
        """`clip_from_view` and `clip_from_world` as products of `stages`, rounded once.

        A free matrix is one step, and has no factors.
        """
        view, *steps = self.stages[1:-1]
        if steps:
            in_order = [(stage.name, stage.exact) for stage in reversed(steps)]
            direct = _product("clip_from_view", in_order)
        else:
            exact = evaluated(self.lens.table.clip_from_view, self._exact_letters)
            direct = Stage("clip_from_view", exact, (), "")
            in_order = [(direct.name, exact)]
        return direct, _product("clip_from_world", [*in_order, (view.name, view.exact)])

    # -- points

    def placed(self, points: ArrayLike, space: Space = "world") -> Placed:
        """Points of a space in the world, (n, 3), with the digits that the eye does not share.

        Parameters
        ----------
        points : (..., 3) array_like
        space : {"world", "object"}

        Raises
        ------
        Refusal
            If a coordinate is not a finite number, or for another space.
        """
        if space not in SPACES:
            raise Refusal("space", space, ONE_OF, ", ".join(SPACES))
        given = checked_points(points).reshape(-1, 3)
        if space == "world" or self.placement.is_identity:
            return Placed.at(given)
        return self.placement.placed(given)

    def trace(self, points: ArrayLike, space: Space = "world") -> Trace:
        """Follow points through every stage, eye first and in closed form.

        Parameters
        ----------
        points : (..., 3) array_like
        space : {"world", "object"}
            What the coordinates are.

        Raises
        ------
        Refusal
            If a coordinate is not a finite number.

        Notes
        -----
        Depth is ``f/(f - n) * ((w - n)/w)``, not ``A + B/w``: the difference ``w - n`` keeps
        1.3e-16 where the sum of two large numbers keeps 6e-5 (near close to far).
        """
        rest: Array | None = None
        if space == "world":
            world = checked_points(points)
        else:
            found = self.placed(points, space)
            world = found.world.reshape(np.shape(points))
            rest = None if found.rest is None else found.rest.reshape(np.shape(points))
        with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
            return self.lens.trace(self, world, rest)

    def view(self, world: Array, rest: Array | None = None) -> tuple[Array, Array]:
        """View coordinates of points (n, 3), rounded once, and what that cut off of z.

        `rest` is what the points' own rounding cut off.

        Returns
        -------
        view : (3, n) array
        rest : (n,) array

        Notes
        -----
        Ozaki, Ogita, Oishi, Rump, "Error-free transformations of matrix multiplication" (2012):
        offsets and frame are cut in two, so that the large parts' products and sums are whole
        numbers of a unit, below 2^53 of them, which no order of summing rounds. What is left has
        2^-25 of the size, and its rounding 2^-75.
        """
        if not self.stretch <= _LARGE_STRETCH:
            parts = self.view_double_double(world, rest)
            return np.stack([part.hi for part in parts]), parts[2].lo
        large, small = self.camera.frame_parts
        offset, left_over = dd.two_sum(np.ascontiguousarray(world.T), self._minus_eye)
        if rest is not None:
            offset, left_over = dd.two_sum(offset, left_over + rest.T)
        unit = np.abs(offset)
        unit = unit[0] + unit[1] + unit[2]
        unit *= _ABOVE_OFFSETS
        high = offset + unit
        high -= unit
        whole = large @ high
        left_over += np.subtract(offset, high, out=high)
        left_over = large @ left_over
        left_over += small @ offset
        view = whole + left_over
        return view, left_over[2] - (view[2] - whole[2])

    @cached_property
    def _minus_eye(self) -> Array:
        return read_only([[-part] for part in self.camera.eye])

    def view_double_double(
        self, points_world: Array, rest: Array | None = None
    ) -> tuple[DoubleDouble, ...]:
        """View coordinates x, y, z with twice the digits of float64.

        Parameters
        ----------
        points_world : (n, 3) array
        rest : (n, 3) array, optional
            What their rounding cut off.

        Returns
        -------
        tuple of 3 DoubleDouble of (n,) arrays
            Their errors are below ``3 double_double.RELATIVE_ERROR`` of the distance from the eye.
        """
        offset = Placed(points_world, rest, np.zeros(0)).offset(self.camera.eye)
        offsets = [DoubleDouble(*parts) for parts in zip(*offset, strict=True)]
        rows = []
        for axis in self.camera.frame_double_double:
            x, y, z = (dd.multiply(part, o) for part, o in zip(axis, offsets, strict=True))
            rows.append(dd.add(dd.add(x, y), z))
        return tuple(rows)

    def world_from_image(self, points_image: ArrayLike) -> Array:
        """Un-project pixels with a depth.

        Parameters
        ----------
        points_image : (..., 3) array_like
            x and y in pixels and depth in [0, 1], as `Trace.image` and `Trace.depth`.

        Returns
        -------
        (..., 3) float64 array
            World coordinates.

        Raises
        ------
        Refusal
            If a number is not finite, a depth is outside [0, 1], or one is that of a far plane
            at infinity (or farther than 1e250), where a pixel has a direction but no point. And
            for a free matrix without an inverse.
        """
        points = checked_points(points_image)
        depth = points[..., 2]
        for wrong, bound, limit in ((depth < 0.0, AT_LEAST, 0), (depth > 1.0, AT_MOST, 1)):
            if wrong.any():
                raise Refusal("depth", float(depth[wrong][0]), bound, limit)
        return self.lens.world_from_image(self, points)

    # -- the same picture with another lens

    def with_depth(self, depth: DepthRange) -> Projection:
        """The same view volume and picture in another depth range.

        Parameters
        ----------
        depth : {"opengl", "direct3d", "reversed"}

        Raises
        ------
        Refusal
            For another depth range.
        """
        if depth == self.depth:
            return self
        changed = replace(self, depth=depth)
        lens = self.lens.in_depth_range(self.depth_range, changed.depth_range)
        return changed if lens is self.lens else replace(changed, lens=lens)

    def with_lens(self, kind: str) -> Projection:
        """Change the kind of lens, keeping the picture as alike as it can be.

        Near, far and `keep` stay where the new lens can have them. Between the perspective lenses
        the window on the near plane stays, and so does the whole picture; otherwise the picture
        of the plane through the target stays. A free matrix starts with the lens' own cells, and
        goes back to that lens.

        Parameters
        ----------
        kind : {"perspective", "frustum", "orthographic", "oblique", "matrix"}

        Raises
        ------
        Refusal
            For another kind.
        """
        if kind not in kinds():
            raise Refusal("kind", kind, ONE_OF, ", ".join(kinds()))
        if kind == self.lens.kind:
            return self
        if self.lens.former is not self.lens:
            return replace(self, lens=self.lens.former).with_lens(kind)
        if kind == FreeMatrix.kind:
            cells: Any = self.direct_stages[0].matrix.tolist()
            return replace(self, lens=FreeMatrix(cells, None, self.lens))
        seen = Seen(self.lens, self.window, self.camera.distance)
        return replace(self, lens=LENSES[kind].showing(seen))

    def between(self, near: float, far: float) -> Projection:
        """The same view volume, and so the same picture, cut by other near and far planes.

        Parameters
        ----------
        near, far : float
            Distances from the eye plane, in world units.

        Raises
        ------
        Refusal
            For planes that the lens cannot have, and for a free matrix.
        """
        return replace(self, lens=self.lens.cut(self.window, near, far))

    def matrices_between(self, near: float, far: float) -> tuple[Array, Array]:
        """`clip_from_view` and `view_from_clip` of `between`, in the reversed depth range.

        Only what belongs to depth is exchanged. So these are had also where no lens can be: its
        window would overflow there, or vanish beside its shift.

        Parameters
        ----------
        near, far : float
            Distances from the eye plane, in world units; far may be infinite for a central lens.

        Returns
        -------
        clip_from_view, view_from_clip : (4, 4) float64 arrays

        Raises
        ------
        Refusal
            For a free matrix, which has no planes.
        """
        rows = _depth_rows(self.lens.table_to(far), near, far)
        return self.lens.between(self, rows, self.window, near, far)

    def with_intrinsics(self, intrinsics: Intrinsics) -> Projection:
        """The same camera with the lens of a calibrated one.

        Parameters
        ----------
        intrinsics : Intrinsics
            In pixels of this projection's image.

        Returns
        -------
        Projection
            With a `Perspective` lens if the pixels are square and the axis is in the middle of
            the image, with a `Frustum` otherwise; near and far stay.

        Raises
        ------
        Refusal
            For a focal length that is not above 0 or a number that is not finite, and for a
            window that a `Frustum` refuses.
        """
        fx, fy, cx, cy = (
            finite(name, value) for name, value in zip(Intrinsics._fields, intrinsics, strict=True)
        )
        positive("fx", fx)
        positive("fy", fy)
        width, height = self.image_size
        for name, value, side, centre in (("fx", fx, width, cx), ("fy", fy, height, cy)):
            least = (abs(centre) + side + 1.0) * SMALLEST_FIELD
            within(name, value, least, side / (2.0 * SMALLEST_OPENING))
        lens = self.with_lens("frustum").lens
        near, far = lens.near, lens.far
        if fx == fy and cx == (width - 1) / 2.0 and cy == (height - 1) / 2.0:
            fov_y_deg = fov_y_from_window(height / 2.0, fy)
            return replace(self, lens=Perspective(fov_y_deg, near, far))
        left, right = near * (-0.5 - cx) / fx, near * (width - 0.5 - cx) / fx
        top, bottom = near * (cy + 0.5) / fy, near * (cy + 0.5 - height) / fy
        return replace(self, lens=Frustum(left, right, bottom, top, near, far))


@lru_cache(maxsize=16)  # the parts that are drawn of one volume, which most edits leave alone
def _depth_rows(table: LensTable, near: float, far: float) -> tuple[Array, Array]:
    """Row z of `clip_from_view`, (4,), and rows z and w of its inverse, (2, 4), reversed range."""
    assert table.view_from_clip is not None
    z_near, z_far = DEPTH_RANGES["reversed"]
    letters = {"n": near, "f": far, "z_n": z_near, "z_f": z_far}
    rows = evaluated((table.clip_from_view[2], *table.view_from_clip[2:]), letters, FLOAT64)
    depth, *back = rows
    return read_only(depth), read_only(back)


def checked_points(points: ArrayLike) -> Array:
    """Points as a float64 array of their own, (..., 3).

    Raises
    ------
    Refusal
        If they are not rows of three finite numbers up to `LARGEST`.
    """
    try:
        given = np.asarray(points)
    except ValueError:  # rows of different lengths
        raise Refusal("points", points, THREE_NUMBERS) from None
    if given.dtype.kind not in "iuf" or given.shape[-1:] != (3,):
        raise Refusal("points", points, THREE_NUMBERS)
    checked = given.astype(np.float64)
    if not checked.size or (checked.max() <= LARGEST and checked.min() >= -LARGEST):
        return checked
    wrong = ~np.isfinite(checked).all(axis=-1) | (np.abs(checked) > LARGEST).any(axis=-1)
    if wrong.any():
        raise Refusal("points", tuple(checked[wrong][0].tolist()), THREE_NUMBERS)
    return checked
