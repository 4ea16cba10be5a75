"""A projection matrix that somebody typed: its cells are its table.

It has no eye plane: its near and far are those of the cube, its view matrix may be typed as well,
and w may have any sign. What is known of it is known of the cells, in rationals.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, ClassVar

import numpy as np

from app.arithmetic.double_double import DoubleDouble
from app.arithmetic.rationals import rationals
from app.model.lenses.lens import Lens, LensTable
from app.model.lenses.perspective import Perspective
from app.model.lenses.setup import HalfSpaces, Setup, Trace
from app.model.limits import (
    BEYOND,
    LARGEST,
    NO_POINT,
    SMALLEST_CELL,
    Array,
    Cells,
    Vector,
    finite_matrix,
    keep_checked,
)
from app.model.object_transform import Placed
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.model.tables import inverse, matrix, rounded

RAY_REACH = 10.0
"""A ray to infinity is drawn so many times as far as the target is."""

TABLE = LensTable(
    (),
    matrix("""
        p_11  p_12  p_13  p_14
        p_21  p_22  p_23  p_24
        p_31  p_32  p_33  p_34
        p_41  p_42  p_43  p_44
    """),
)


@dataclass(frozen=True)
class FreeMatrix(Lens):
    """A projection that is none of the lenses: cells that somebody typed.

    Parameters
    ----------
    clip_from_view : (4, 4) sequence of floats
        For the depth range in hand.
    view_from_world : (4, 4) sequence of floats, optional
        In place of the camera's own, where that was edited and no camera has it.
    former : Perspective, Frustum, Orthographic or Oblique
        The lens that it was made of, to which a choice of a lens goes back.

    Raises
    ------
    Refusal
        Naming the cell, as ``clip_from_view[0, 2]``, that is not finite, beyond `LARGEST`, or
        below `SMALLEST_CELL` in size and not 0.
    """

    kind: ClassVar[str] = "matrix"
    title: ClassVar[str] = QT_TRANSLATE_NOOP("Lens", "free matrix")
    tip: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Lens",
        "None of these: the cells of clip_from_view as they were typed in the Matrices panel. A"
        " choice of another kind goes back to the lens before.",
    )
    # Offset, cell, product and three sums.
    roundings: ClassVar[tuple[float, float, float, float]] = (6.0, 6.0, 6.0, 6.0)

    clip_from_view: Cells
    view_from_world: Cells | None = None
    former: Lens = Perspective()  # noqa: RUF009

    def __post_init__(self) -> None:
        keep_checked(
            self, clip_from_view=finite_matrix("clip_from_view", self.clip_from_view, SMALLEST_CELL)
        )
        if self.view_from_world is not None:
            view_from_world = finite_matrix("view_from_world", self.view_from_world, SMALLEST_CELL)
            keep_checked(self, view_from_world=view_from_world)

    @property
    def own_view(self) -> Cells | None:
        return self.view_from_world

    @property
    def table(self) -> LensTable:
        return TABLE

    def exact_letters(self, aspect: Fraction) -> dict[str, Fraction]:
        return {letter: Fraction(cell) for letter, cell in self.letters(aspect).items()}

    def letters(self, aspect: Fraction) -> dict[str, float]:
        return {
            f"p_{i}{j}": cell
            for i, row in enumerate(self.clip_from_view, 1)
            for j, cell in enumerate(row, 1)
        }

    @property
    def planes(self) -> None:
        return None

    def holds(self, distance: float) -> bool:
        return False

    def in_depth_range(self, old: tuple[float, float], new: tuple[float, float]) -> FreeMatrix:
        old_near, old_far = map(Fraction, old)
        new_near, new_far = map(Fraction, new)
        scale = (new_far - new_near) / (old_far - old_near)
        x, y, z, w = (tuple(map(Fraction, row)) for row in self.clip_from_view)
        z = tuple(scale * a + (new_near - scale * old_near) * b for a, b in zip(z, w, strict=True))
        cells: Any = tuple(tuple(map(float, row)) for row in (x, y, z, w))
        return replace(self, clip_from_view=cells)

    # -- its matrices

    def stated_in(self, setup: Setup) -> tuple[Array, Array]:
        return setup.clip_from_eye, np.eye(4)

    def clip_from_eye(self, setup: Setup) -> Array:
        return rounded(setup.exact_from_eye[1])

    def eye_from_clip(self, setup: Setup) -> tuple[Array, ...]:
        return (rounded(setup.eye_from_clip),)

    def view_from_clip(self, setup: Setup, letters: Mapping[str, float]) -> Array:
        return rounded(inverse("clip_from_view", rationals(self.clip_from_view)))

    def frustum_sign(self, setup: Setup) -> int:
        try:
            x, y, z, w = setup.eye_from_clip[3]
        except Refusal:
            return 0
        ends = [w + z * Fraction(z_ndc) for z_ndc in setup.depth_range]
        reach = abs(x) + abs(y)
        return (min(ends) > reach) - (max(ends) < -reach)

    def least_w(self, setup: Setup) -> float:
        if self.frustum_sign(setup) <= 0:
            return 0.0
        # Un-projected, the cube's corner (x, y, z, 1) has the inverse of the point's own w.
        x, y, z, w = setup.eye_from_clip[3]
        most = max(w + z * Fraction(z_ndc) for z_ndc in setup.depth_range) + abs(x) + abs(y)
        return float(1 / most)

    # -- points

    def trace(self, setup: Setup, world: Array, rest: Array | None = None) -> Trace:
        offsets = world - setup.camera.eye
        if rest is not None:
            offsets += rest
        view_from_eye = rounded(setup.exact_from_eye[0])
        view = offsets @ view_from_eye[:3, :3].T + view_from_eye[:3, 3]
        if tuple(view_from_eye[3]) != (0.0, 0.0, 0.0, 1.0):
            view /= (offsets @ view_from_eye[3, :3] + view_from_eye[3, 3])[..., None]
            view[~np.isfinite(view).all(axis=-1)] = np.nan
        clip = offsets @ setup.clip_from_eye[:, :3].T + setup.clip_from_eye[:, 3]
        x, y, _, w = np.moveaxis(clip, -1, 0)
        ndc = clip[..., :3] / w[..., None]
        width, height = setup.image_size
        image = np.stack(
            [(ndc[..., 0] + 1.0) * (width / 2.0), (1.0 - ndc[..., 1]) * (height / 2.0)], axis=-1
        )
        depth = np.asarray((ndc[..., 2] + 1.0) / 2.0 if setup.depth == "opengl" else ndc[..., 2])
        in_front = (w > 0.0) & np.isfinite(ndc).all(axis=-1) & np.isfinite(image).all(axis=-1)
        for array in (ndc, image, depth):
            array[~in_front] = np.nan
        sides = [x < -w, x > w, y < -w, y > w]
        outside = np.stack([*self.beyond(setup, view, clip), *sides], axis=-1)
        return Trace(world, view, clip, ndc, image, depth, in_front, outside)

    def beyond(self, setup: Setup, view: Any, clip: Any) -> tuple[Any, Any]:
        z, w = clip[..., 2], clip[..., 3]
        z_near, z_far = setup.depth_range
        sign = math.copysign(1.0, z_far - z_near)
        return sign * z < sign * z_near * w, sign * z > sign * z_far * w

    def view_of(self, setup: Setup, offsets: Any) -> Any:
        matrix = np.array(setup.exact_from_eye[0], dtype=np.float64).astype(offsets.dtype)
        view = offsets @ matrix[:, :3].T + matrix[:, 3]
        return view[:, :3] / view[:, 3:]

    def world_from_image(self, setup: Setup, points: Array) -> Array:
        z_near, z_far = setup.depth_range
        low, high = min(z_near, z_far), max(z_near, z_far)
        width, height = setup.image_size
        ndc = np.stack(
            [
                2.0 * (points[..., 0] / width) - 1.0,
                1.0 - 2.0 * (points[..., 1] / height),
                low + (high - low) * points[..., 2],
                np.ones(points.shape[:-1]),
            ],
            axis=-1,
        )
        offsets = ndc @ rounded(setup.eye_from_clip).T
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            world = offsets[..., :3] / offsets[..., 3:] + setup.camera.eye
        nowhere = ~(np.abs(world).max(axis=-1) < BEYOND)
        if nowhere.any():
            raise Refusal("depth", float(points[..., 2][nowhere][0]), NO_POINT)
        return np.asarray(world)

    def line(
        self, setup: Setup, pixel: tuple[float, float] | None, point: Vector | None, at: Array
    ) -> Array | None:
        if pixel is None:
            trace = setup.trace(point or ())
            if not trace.in_front:
                return None
            pixel = float(trace.image[0]), float(trace.image[1])
        ends = np.array([setup.image_from_ndc @ (0.0, 0.0, z, 1.0) for z in setup.depth_range])
        ends[:, :2] = pixel
        if not self.frustum_sign(setup):
            return self._line_in_front(setup, ends, at)
        try:
            start, end = setup.world_from_image(ends[:, :3])
        except Refusal:  # a pixel beside the picture may meet infinity
            return None
        line: Array = start + at[:, None] * (end - start)
        return line

    def _line_in_front(self, setup: Setup, ends: Array, shares: Array) -> Array | None:
        """What a line of the cube has in front of the eye plane, where others may reach infinity.

        w of a point un-projected is the inverse of the point's own: it passes 0 where the line
        passes infinity, and the direction there is that of what is left.
        """
        try:
            (unprojected,) = self.eye_from_clip(setup)
        except Refusal:  # no inverse
            return None
        ndc = np.linalg.solve(setup.image_from_ndc, ends.T)
        near, far = (unprojected @ ndc).T
        if near[3] <= 0.0:
            near, far = far, near
        if near[3] <= 0.0:
            return None
        start = near[:3] / near[3]
        if far[3] > 0.0:
            along = far[:3] / far[3] - start
        else:
            along = near[:3] * -far[3] + far[:3] * near[3]
            along *= RAY_REACH * setup.camera.distance / np.linalg.norm(along)
        line: Array = setup.camera.eye + start + shares[:, None] * along
        return line if np.abs(line).max() <= LARGEST else None

    def dragged(
        self, setup: Setup, trace: Trace, shift_px: tuple[float, float], *, along_ray: bool
    ) -> Array | None:
        (x_px, y_px), depth, (right_px, down_px) = trace.image, float(trace.depth), shift_px
        if along_ray:
            away = -1.0 if setup.depth == "reversed" else 1.0
            depth -= away * down_px / setup.image_size[1]
        else:
            x_px, y_px = x_px + right_px, y_px + down_px
        try:
            return setup.world_from_image((x_px, y_px, depth))
        except Refusal:  # no inverse, beyond the depth range, or at infinity
            return None

    def clipped(self, setup: Setup, x: Any, y: Any, z: Any) -> list[Any]:
        view, clip = (
            [x * row[0] + y * row[1] + z * row[2] + row[3] for row in matrix]
            for matrix in setup.exact_from_eye
        )
        if setup.exact_from_eye[0][3] != [0, 0, 0, 1]:
            nowhere = isinstance(view[3], Fraction) and view[3] == 0
            view = [math.nan if nowhere else part / view[3] for part in view]
        x_clip, y_clip, z_clip, w = clip
        z_near, z_far = map(int, setup.depth_range)
        sign = 1 if z_far > z_near else -1
        from_near, to_far = (z_clip - w * z_near) * sign, (w * z_far - z_clip) * sign
        inside = from_near, to_far, x_clip + w, -x_clip + w, y_clip + w, -y_clip + w
        return [*view[:3], *clip, *inside]

    def coordinates(self, setup: Setup, points: Placed) -> tuple[Sequence[DoubleDouble], Array]:
        offset = points.offset(setup.camera.eye)
        return [DoubleDouble(*parts) for parts in zip(*offset, strict=True)], points.lost

    def exact_coordinates(
        self, setup: Setup, point: Sequence[float | Fraction]
    ) -> tuple[Fraction, ...]:
        pairs = zip(point, setup.camera.eye, strict=True)
        return tuple(Fraction(part) - Fraction(eye) for part, eye in pairs)

    # -- what its roundings cost

    def view_error(self, setup: Setup) -> float:
        return 0.0

    def depth_terms(self, setup: Setup) -> tuple[Array, Array]:
        row, clip = setup.image_from_ndc[2, 2:], setup.clip_from_eye
        return row @ clip[2:], row @ np.abs(clip)[2:]

    # -- for what is drawn and pointed at

    def order(self, setup: Setup) -> tuple[Array, Array]:
        clip = setup.clip_from_eye
        z_near, z_far = setup.depth_range
        sign = math.copysign(1.0, z_far - z_near)
        planes = np.array([clip[2] - z_near * clip[3], z_far * clip[3] - clip[2]])
        return sign * (setup.image_from_ndc @ clip)[2], sign * planes

    def half_spaces(self, least_w: float) -> HalfSpaces:
        depth = ((0.0, 0.0, 1.0, 1.0), 0.0), ((0.0, 0.0, -1.0, 1.0), 0.0)
        return [*depth, ((0.0, 0.0, 0.0, 1.0), -least_w)]

    def nearer(
        self, a: float, b: float, share: float, length: float, least: float
    ) -> tuple[float, float]:
        return 0.0, -least  # it has no eye: the same step of depth for all
