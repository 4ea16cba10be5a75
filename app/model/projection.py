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

Points are projected *eye first*: the eye is subtracted before anything else; then follow the
rotation and the closed form of the lens. A concatenated matrix loses the digits that the eye and
the point have in common (5e-5 px at 1e9 from the origin, against 1e-12 px here); it exists for the
GPU, and because the lectures write it.

The dot products of the rotation have some 75 bits, because a lens stretches their rounding (a field
of view near 0 or 180 degrees, a parallel camera far from its small window).

The letters u, v, n, the look-at and the view matrix are those of lecture 004 (Horvat); the
perspective matrix is equation (13) of lecture 000, the oblique one P_ort H of lecture 002, the
canonical volumes and the matrices M_pp and M_z between them those of lecture 001.
"""

from dataclasses import dataclass, replace
from functools import lru_cache, reduce
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from app.model.camera import Camera, Orbit, checked_intrinsics
from app.model.chain import Chain, Space
from app.model.eye_first import EyeFirst
from app.model.formula import FLOAT64
from app.model.lenses import LENSES, FreeMatrix, Frustum, Oblique, Orthographic, Perspective, kinds
from app.model.lenses.answers import Intrinsics
from app.model.lenses.lens import Lens, Seen
from app.model.lenses.perspective import fov_x_from_fov_y, fov_y_from_window
from app.model.limits import (
    DEPTH_RANGES,
    LARGEST,
    LARGEST_IMAGE_PX,
    PLANES,
    Array,
    DepthRange,
    Vector,
    between,
    check_name,
    read_only,
)
from app.model.pipeline import Pipeline, Stage, Trace, checked_pixels, checked_points, translation
from app.model.tables import evaluated
from app.model.typed_cells import TypedCells

__all__ = [  # the other packages import the model from here
    "DEPTH_RANGES", "LARGEST", "LARGEST_IMAGE_PX", "LENSES", "PLANES", "Array", "Camera", "Chain",
    "FreeMatrix", "Frustum", "Intrinsics", "Lens", "Oblique", "Orbit", "Orthographic",
    "Perspective", "Projection", "Space", "Stage", "Trace", "Vector", "kinds",
]  # fmt: skip

Passage: TypeAlias = EyeFirst | TypedCells
"""Projects points through a lens; both classes have the same methods."""


@dataclass(frozen=True)
class Projection(Pipeline):
    """A camera, a lens, an image, a depth range and an object: everything a picture depends on.

    Every instance is valid; edits use `dataclasses.replace`. `Pipeline` has the fields and the
    displayed matrices.
    """

    @property
    def passage(self) -> Passage:
        """The object that projects points; a new one each time, to avoid a reference cycle."""
        return EyeFirst(self) if self.lens.planes is not None else TypedCells(self)

    @property
    def intrinsics(self) -> Intrinsics:
        """The perspective camera's K, or a `Refusal` for a lens without one."""
        return self.lens.intrinsics(self.image_size)

    # -- matrices, with the eye subtracted first

    def clip_from_local(self, origin: ArrayLike, space: Space = "world") -> Array:
        """The matrix to clip space from world or object points relative to `origin`, (4, 4).

        The eye is subtracted from the origin in float64 before any product, so that a scene at 1e9
        loses no digits.
        """
        return read_only(self.clip_from_eye @ self.local_to_eye(origin, space))

    def local_to_eye(self, origin: ArrayLike, space: Space = "world") -> Array:
        """From points relative to `origin` to world axes with their origin in the eye, (4, 4).

        Both the points and the origin, (3,), are given in `space`.
        """
        if space == "object" and not self.placement.is_identity:
            x, y, z = np.asarray(origin, dtype=np.float64).tolist()
            return self.placement.local_from((x, y, z), self.camera.eye)
        return translation(np.asarray(origin, dtype=np.float64) - self.camera.eye)

    def world_from_clip_at(self, origin: ArrayLike) -> Array:
        """The inverse of `clip_from_local`, (4, 4).

        Raises a `Refusal` for a typed matrix without an inverse, or with one that float64 cannot
        hold.
        """
        shift = translation(self.camera.eye - np.asarray(origin, dtype=np.float64))
        return read_only(reduce(np.matmul, self.passage.eye_from_clip, shift))

    @property
    def frustum_sign(self) -> int:
        """The sign of w at all eight un-projected corners of the cube; 0 for no frustum.

        A lens always has a frustum, perhaps with far corners at infinity. A typed matrix has none
        if its inverse does not exist or is too large to be drawn, or if its volume reaches
        infinity.
        """
        return self.passage.frustum_sign

    # -- points

    def trace(self, points: ArrayLike, space: Space = "world") -> Trace:
        """Follow points (..., 3) of a space through every stage, eye first and in closed form.

        Raises a `Refusal` if a coordinate is not a finite number.

        Depth is ``f/(f - n) * ((w - n)/w)``, not ``A + B/w``: the difference ``w - n`` keeps
        1.3e-16 where the sum of two large numbers keeps 6e-5 (near close to far).
        """
        rest: Array | None = None
        if space == "world":
            world = checked_points(points)
        else:
            view = self.placed(points, space)
            world = view.world.reshape(np.shape(points))
            rest = None if view.rest is None else view.rest.reshape(np.shape(points))
        with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
            return self.passage.trace(world, rest)

    def world_from_image(self, points_image: ArrayLike) -> Array:
        """World coordinates, (..., 3), of pixels x, y with a depth in [0, 1].

        Raises a `Refusal` if a number is not finite, if a depth is outside [0, 1] or that of a far
        plane at infinity (or farther than 1e250), where a pixel has a direction but no point, and
        for a typed matrix without an inverse.
        """
        return self.passage.world_from_image(checked_pixels(points_image))

    # -- the same picture with another lens

    def with_depth(self, depth: DepthRange) -> "Projection":
        """Return the same view volume and picture in another depth range."""
        if depth == self.depth:
            return self
        changed = replace(self, depth=depth)
        lens = self.lens.in_depth_range(self.depth_range, changed.depth_range)
        return changed if lens is self.lens else replace(changed, lens=lens)

    def with_lens(self, kind: str) -> "Projection":
        """Change the kind of lens to one of `kinds`, changing the picture as little as possible.

        Near, far and `keep` stay if the new lens can have them. Between perspective lenses the
        window on the near plane stays, and so does the whole picture; otherwise the picture of the
        plane through the target stays. A typed matrix starts with the cells of the lens, and
        returns to that lens.
        """
        check_name("kind", kind, kinds())
        if kind == self.lens.kind:
            return self
        if self.lens.former is not self.lens:
            return replace(self, lens=self.lens.former).with_lens(kind)
        if kind == FreeMatrix.kind:
            cells: Any = self.direct_stages[0].matrix.tolist()
            return replace(self, lens=FreeMatrix(cells, None, self.lens))
        seen = Seen(self.lens, self.window, self.camera.distance)
        return replace(self, lens=LENSES[kind].showing(seen))

    def with_eye(self) -> "Projection":
        """Return the same camera with a lens whose projectors meet in the eye: its own, if so."""
        return self if self.lens.central else self.with_lens("perspective")

    def between(self, near: float, far: float) -> "Projection":
        """Return the same view volume and picture between other near and far planes.

        Raises a `Refusal` for planes that the lens cannot have, and for a typed matrix.
        """
        return replace(self, lens=self.lens.cut(self.window, near, far))

    def matrices_between(self, near: float, far: float) -> tuple[Array, Array]:
        """`clip_from_view` and `view_from_clip` of `between`, in the reversed depth range.

        Only the depth rows change, so these matrices also exist for planes between which the window
        of a lens would overflow or vanish, and for far = inf of a central lens. A typed matrix,
        which has no planes, raises a `Refusal`.
        """
        left, right, bottom, top = self.window  # a typed matrix has no planes
        kind: Any = type(self.lens)
        depth, back = _depth_rows(kind, near, far)
        clip_from_view, view_from_clip = self.clip_from_view.copy(), self.view_from_clip.copy()
        clip_from_view[2], view_from_clip[2:] = depth, back
        if not self.lens.central:
            for row, (low, high) in enumerate(((left, right), (bottom, top))):
                cot = self.lens.shear[row]
                view_from_clip[row, 2] = -cot * (far - near)
                view_from_clip[row, 3] = (low + high) / 2.0 + cot * (far - self.lens.near)
        return clip_from_view, view_from_clip

    def with_fov_x(self, fov_x_deg: float) -> "Projection":
        """Return the same camera with a symmetric lens of this horizontal field of view."""
        fov_x_deg = between("fov_x_deg", fov_x_deg, 0, 180)
        fov_y_deg = fov_x_from_fov_y(fov_x_deg, 1.0 / self.aspect)
        return replace(self, lens=self.lens.replaced(fov_y_deg=fov_y_deg))

    def with_angles(self, alpha_deg: float, beta_deg: float) -> "Projection":
        """Change the angles of an oblique lens, and keep the target's place in the picture."""
        lens: Any = self.lens
        leaning = replace(lens, alpha_deg=alpha_deg, beta_deg=beta_deg)
        away = self.camera.distance - lens.near
        x, y = ((was - now) * away for was, now in zip(lens.shear, leaning.shear, strict=True))
        lens = replace(
            leaning,
            left=lens.left + x, right=lens.right + x, bottom=lens.bottom + y, top=lens.top + y,
        )  # fmt: skip
        return replace(self, lens=lens)

    def with_intrinsics(self, intrinsics: ArrayLike) -> "Projection":
        """Return the same camera with the lens of a calibrated camera, in pixels of this image.

        `intrinsics` are fx, fy, cx, cy as OpenCV counts them, from the centre of the first pixel,
        or K, (3, 3). The lens is a `Perspective` if the pixels are square and the axis is in the
        middle of the image, and a `Frustum` otherwise. Near and far stay. Raises a `Refusal` for a
        focal length that is not above 0, a number that is not finite, a K with skew, and a window
        that a `Frustum` refuses.
        """
        fx, fy, cx, cy = checked_intrinsics(intrinsics, self.image_size)
        width, height = self.image_size
        lens = self.with_lens("frustum").lens
        near, far = lens.near, lens.far
        if fx == fy and cx == (width - 1) / 2.0 and cy == (height - 1) / 2.0:
            return replace(self, lens=Perspective(fov_y_from_window(height / 2.0, fy), near, far))
        left, right = near * (-0.5 - cx) / fx, near * (width - 0.5 - cx) / fx
        top, bottom = near * (cy + 0.5) / fy, near * (cy + 0.5 - height) / fy
        return replace(self, lens=Frustum(left, right, bottom, top, near, far))


@lru_cache(maxsize=16)  # the drawn parts of one volume, which most edits do not change
def _depth_rows(kind: Any, near: float, far: float) -> tuple[list[float], list[list[float]]]:
    """Row z of `clip_from_view`, and rows z and w of its inverse, in the reversed range.

    `kind` is a class of lenses.
    """
    table = kind.table_to(far)
    assert table.view_from_clip is not None
    z_near, z_far = DEPTH_RANGES["reversed"]
    rows = table.clip_from_view[2], *table.view_from_clip[2:]
    depth, *back = evaluated(rows, {"n": near, "f": far, "z_n": z_near, "z_f": z_far}, FLOAT64)
    return depth, back
