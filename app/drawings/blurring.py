"""Pictures that are made of several: through the opening of a lens, or with two eyes.

Every point of the opening sees a picture of its own. All have the focused plane as their common
window, and so their average is sharp there and blurred elsewhere, as on the film of a camera. The
pictures are drawn one by one in a window of their own, which is on no screen. After any of them
the average can be shown: it becomes finer with each. Those of two eyes are put together, and
averaged only to smooth their edges.
"""

import math
import time
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkActor, vtkTexture

from app.drawings.actors import identity_camera, unlit_actor
from app.drawings.off_screen import OffScreen, Pixels, pixels_of, take_screen
from app.drawings.precision import ModelActors
from app.drawings.prop_group import PropGroup
from app.drawings.style import Style, rgb
from app.model.projection import Array, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.marks import Aperture, Eyes
from app.scenes.poly_mesh import PolyMesh
from app.scenes.scene import Scene

MOST = 64  # pictures that are averaged
FIRST = 4  # fewer are not shown: they look like so many ghosts
_ROOT = 1.1673039782614187  # of x^5 = x + 1: its powers fill four dimensions evenly


def spread(count: int) -> Array:
    """Points of the opening, and of a pixel, (count, 4): each beginning of them is spread evenly.

    Right and up in the unit disc, then -1/2 to 1/2 each.
    """
    steps = (np.arange(count)[:, None] + 0.5) * _ROOT ** -np.arange(1.0, 5.0) % 1.0
    radius, turn = np.sqrt(steps[:, 0]), 2.0 * math.pi * steps[:, 1]
    disc = np.stack([radius * np.cos(turn), radius * np.sin(turn)], axis=1)
    return np.concatenate([disc, steps[:, 2:] - 0.5], axis=1)


_SPREAD = spread(MOST)
_OPENING, _EYES = (FIRST, MOST, 0.03), (1, 8, 0.0)  # at least, at most, seconds of one call


def _together(left: Pixels, right: Pixels, eyes: Eyes) -> Pixels:
    """Put the pictures (height, width, 4) of two eyes, or their middle halves, into one.

    Red-cyan pictures are the luma of Rec. 709: red glass shows the left one and cyan the right one.
    """
    if eyes.pictures == "red-cyan":
        parts = (np.moveaxis(each, -1, 0).astype(np.uint16) for each in (left, right))
        red, cyan = ((54 * r + 183 * g + 19 * b >> 8).astype(np.uint8) for r, g, b, _ in parts)
        return np.stack([red, cyan, cyan, left[..., 3]], axis=-1)
    one, other = (left, right) if eyes.shares[0] < 0.0 else (right, left)
    return np.concatenate([one, other], axis=1)


class Blurring:
    """Averages the pictures of one scene, and shows the average as an actor.

    `actor` fills the picture behind all marks; it is visible once there is something to see.
    """

    def __init__(self, scene: Scene, style: Style, tolerance_px: float) -> None:
        self._style = style
        self.model = ModelActors(scene, style, tolerance_px)
        self._screen: OffScreen | None = None
        self._shown: tuple[Projection, Aperture | Eyes] | None = None
        self._size, self._kind, self._transparent = (0, 0), _OPENING, False
        self._count = 0
        self._sum: NDArray[np.uint16] = np.empty((0, 0, 4), np.uint16)
        self._image, self._texture = vtkImageData(), vtkTexture()
        self._texture.SetInputData(self._image)
        self._texture.SetColorModeToDirectScalars()
        self.actor = _screen_filling(self._texture)
        self.actor.SetVisibility(False)

    def begin(
        self, projection: Projection, through: Aperture | Eyes | None, size: tuple[int, int]
    ) -> None:
        """Average another picture of this width and height from now on; None for none."""
        shown = None if through is None else (projection, through)
        if shown == self._shown and size == self._size:
            return
        self._shown, self._size, self._count = shown, size, 0
        self._kind = _EYES if isinstance(through, Eyes) else _OPENING
        if self._kind == _OPENING:  # two eyes keep their last pictures instead of one eye's
            self.actor.SetVisibility(False)

    def restart(self) -> None:
        """Average the same picture again, because the faces or lines of the scene have changed."""
        self._count = 0
        self.actor.SetVisibility(False)

    @property
    def is_coarse(self) -> bool:
        """Whether more pictures would improve the average."""
        return self._shown is not None and self._count < self._kind[1]

    def refine(self, *, transparent: bool = False, whole: bool = False) -> None:
        """Add pictures for some milliseconds, or all that are missing, and show the average."""
        if self._shown is None:
            return
        through = self._shown[1]
        if isinstance(through, Eyes) and through.pictures == "red-cyan":
            transparent = False  # it needs the light of the paper
        if transparent != self._transparent:
            self._transparent, self._count = transparent, 0
        began, (least, most, step_s) = time.perf_counter(), self._kind
        while self._count < most:
            try:
                self._add(*self._shown)
            except Refusal:  # so far out that the opening has no digits: the picture stays sharp
                self._shown = None
                return
            late = time.perf_counter() - began > step_s
            if late and not whole and self._count >= least:
                break
        self._show()

    def close(self) -> None:
        if self._screen is not None:
            self._screen.give_back()
            self._screen = None

    def _add(self, projection: Projection, through: Aperture | Eyes) -> None:
        right, up, *shift = _SPREAD[self._count].tolist()
        if isinstance(through, Eyes):
            point = Aperture(0.0, 1.0)
            left, right = (
                self._drawn(point.seen_from(eye, 0.0, 0.0, (shift[0], shift[1])), share)
                for eye, share in zip((through.left, through.right), through.shares, strict=True)
            )
            pixels = _together(left, right, through)
        else:
            pixels = self._drawn(through.seen_from(projection, right, up, (shift[0], shift[1])))
        if self._count == 0:
            self._sum = pixels.astype(np.uint16)
        else:
            self._sum += pixels
        self._count += 1

    def _drawn(self, seen: Projection, share: float = 0.0) -> Pixels:
        """Draw a picture; of one that moves by a share of its width, the middle half."""
        width, height = self._size
        count = drawn = width
        if share:  # both are drawn in one size, and one of an odd width has a column less
            half, count = width // 2, width - width // 2
            first, drawn = (width // 4, half) if share < 0.0 else (half - width // 4, count)
            low, high, *_ = seen.window
            left, right = (low + (high - low) * k / width for k in (first, first + count))
            seen = replace(seen, lens=seen.lens.replaced(left=left, right=right))
        window = self._ready((count, height))
        self.model.show_picture(seen.with_depth("opengl"))
        window.Render()
        return pixels_of(window)[:, :drawn]

    def _ready(self, size: tuple[int, int]) -> Any:
        if self._screen is None:
            self._screen = take_screen(*size)
            renderer = self._screen.renderer
            PropGroup.make_ready(renderer)
            renderer.SetActiveCamera(identity_camera())
            for actor in self.model.actors:
                renderer.AddViewProp(actor)
        renderer, window = self._screen.renderer, self._screen.render_window
        renderer.SetBackground(*((0.0,) * 3 if self._transparent else rgb(self._style.background)))
        renderer.SetBackgroundAlpha(0.0 if self._transparent else 1.0)
        if window.GetSize() != size:
            window.SetSize(*size)
        return window

    def _show(self) -> None:
        count = np.uint16(self._count)
        pixels = ((self._sum + count // 2) // count).astype(np.uint8)
        if pixels[..., 3].min() < 255:  # a texture's colours are not multiplied by their alpha
            alpha = np.maximum(pixels[..., 3:], 1).astype(np.uint16)
            pixels[..., :3] = np.minimum(255, (pixels[..., :3] * np.uint16(255)) // alpha)
        height, width = pixels.shape[:2]
        values = numpy_to_vtk(pixels[::-1].reshape(-1, 4), deep=True)  # type: ignore[no-untyped-call]
        self._image.SetDimensions(width, height, 1)
        self._image.GetPointData().SetScalars(values)
        self._image.Modified()
        self.actor.SetVisibility(True)


def _screen_filling(texture: vtkTexture) -> vtkActor:
    """A rectangle behind everything, from edge to edge under an identity camera."""
    corners = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    mesh = PolyMesh.of(np.column_stack([corners, [0.9999] * 4]), faces=[(0, 1, 2, 3)])
    mesh.point_data["place"] = (corners + 1.0) / 2.0
    mesh.GetPointData().SetActiveTCoords("place")
    actor = unlit_actor(mesh)
    actor.SetTexture(texture)
    return actor
