"""The program for scripts and notebooks: documents, points, matrices and figures.

Import it as ``frustum_lab`` where the wheel is installed, and as ``app.api`` in a checkout. The
import brings numpy only; VTK is imported when a figure is drawn, and Qt never.

>>> import frustum_lab as lab
>>> document = lab.load("letter-f", "lens.near=2")
>>> lab.project(document, [1.0, 2.0, 0.5]).image
>>> lab.figure(document, points=[(1.0, 2.0, 0.5)])

Everything is a frozen value. Use `dataclasses.replace` or `load` with other values to change one.
Conventions (axes, units, depth ranges) are stated once, in `app.model.projection`. An impossible
value raises a `Refusal`: one sentence with the field, the value and the bound.
"""

import os
import re
import warnings
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from app import __version__
from app.document.document import Document, is_mesh
from app.document.files import path_of
from app.document.lengths import DPI, PX_PER, Size, parse_length, parse_points, parse_size
from app.document.settings import open_with, set_values
from app.document.sweeping import FPS, FRAMES
from app.document.view import MOST_PROBES, PANES
from app.drawings import figure as drawn
from app.drawings.describing import Description
from app.drawings.describing import describe as described
from app.drawings.style import LIGHT
from app.model.infinity import homogeneous_rows
from app.model.lenses import FreeMatrix, Frustum, Lens, Oblique, Orthographic, Perspective
from app.model.limits import real
from app.model.pipeline import Stage, Trace, checked_points
from app.model.projection import Array, Camera, Chain, Intrinsics, Projection, Space
from app.model.refusal import REFUSALS, Refusal
from app.picking.picking import Probe
from app.precision.levels import Precision, precision_for_reading, predict, trace, trace_homogeneous
from app.scenes.mesh import Colours
from app.scenes.scene import BUILT_IN, Scene, cloud_alone
from app.scenes.scene import load as load_scene

__all__ = [
    "Camera", "Chain", "Description", "Document", "Figure", "FreeMatrix", "Frustum",
    "Intrinsics", "Lens", "Oblique", "Orthographic", "Perspective", "Projection",
    "Refusal", "Stage", "Trace", "__version__", "describe", "figure", "load", "matrices", "project",
]  # fmt: skip

Source: TypeAlias = Document | Projection
"""What points are projected through: a document stands for its projection."""

Pane: TypeAlias = Literal["world", "ndc", "image", "equation"]
Panes: TypeAlias = Literal[
    "world,ndc,image", "world,image,ndc", "ndc,world,image", "ndc,image,world", "image,world,ndc",
    "image,ndc,world", "world,ndc", "world,image", "ndc,world", "ndc,image", "image,world",
    "image,ndc", "world/ndc/image", "world/image/ndc", "ndc/world/image", "ndc/image/world",
    "image/world/ndc", "image/ndc/world", "world/ndc", "world/image", "ndc/world", "ndc/image",
    "image/world", "image/ndc",
]  # fmt: skip
Palette: TypeAlias = Literal["screen", "print", "dark", "contrast"]
Hidden: TypeAlias = Literal["none", "dashed", "grey"]
Fit: TypeAlias = Literal["named", "frustum", "scene"]

MOST_DOTS = 1_000_000  # most points of a cloud
DOT_PT = 0.1, 72.0  # least and largest diameter of its dots, in points
_HEX = re.compile("#[0-9a-fA-F]{6}").fullmatch
_number = partial(real, "")  # `_read` raises a refusal with the field


class ScriptFigure(drawn.Figure):
    """A figure as scripts have it, ``frustum_lab.Figure``: it is drawn when it is asked for."""

    def __repr__(self) -> str:
        width, height, unit = self.full_size
        panes = ("/" if self.column else ",").join(self.panes)
        return f"<frustum_lab.Figure: {self.scene.title}, {panes}, {width:g} x {height:g} {unit}>"

    def axes(self, ax: Any) -> Any:
        """Draw it into axes of matplotlib, and return what `imshow` does.

        The image alone has its own pixels as coordinates: ``ax.plot(*project(...).image.T)``.
        """
        pixels = self.array()
        high, wide = pixels.shape[:2]
        if self.panes == ("image",) and not self.document.view.compare:
            wide, high = self.document.projection.image_size
        if not hasattr(ax, "set_axis_off"):
            raise Refusal("ax", ax, REFUSALS["some-axes"])
        ax.set_axis_off()
        return ax.imshow(pixels, extent=(0.0, wide, high, 0.0))

    def plotter(self, **options: Any) -> Any:
        """Return the world as a `pyvista.Plotter`, in world coordinates.

        `options` are those of the plotter. A `Refusal` where pyvista is not installed.
        """
        from app.drawings.guests import plotter_of

        return plotter_of(self, **options)

    def film(
        self,
        path: str | os.PathLike[str],
        *sweeps: str,
        frames: int = FRAMES,
        fps: float = FPS,
        ease: Literal["linear", "log", "smooth"] = "linear",
        loop: Literal["repeat", "once", "back-and-forth"] = "repeat",
        show_value: bool = False,
    ) -> None:
        """Write a film (.gif, .apng, .webp, .mp4) of values, as ``export --sweep`` does.

        `sweeps` are ``"lens.near=0.5:8"`` and others, which change together, in equal steps, in
        equal ratios (``log``), or slowly at both ends. `show_value` writes the values below.
        """
        from app.drawings.film import sweep_film

        _check_flags(show_value=show_value)
        sweep_film(self, path_of("path", path), sweeps, frames, fps, ease, loop, show_value)


Figure = ScriptFigure


def load(source: str | os.PathLike[str] = "letter-f", *values: str) -> Document:
    """Open a scene, a document, or a mesh, and set values in it.

    Parameters
    ----------
    source : str or path
        The name of a built-in scene (``"letter-f"``, ``"focus"``), which opens with its own camera;
        a document or a picture that contains one; or a mesh file.
    *values : str
        As after ``--set``: ``"lens.near=2"``, ``"camera.eye=3,2,4"``, ``"settings.aperture=1.4"``.
        Only the result has to be valid, so their order does not matter.
    """
    name, values = path_of("source", source), tuple(map(str, values))
    if is_mesh(name):
        name = os.path.abspath(name)
    elif name not in BUILT_IN and (os.path.exists(name) or os.path.splitext(name)[1]):
        return set_values(open_with(os.path.abspath(name), Document(), values), values)
    scene = load_scene(name)
    for note in scene.notes:
        warnings.warn(str(note), stacklevel=2)
    return set_values(Document(name, scene.start), values)


def project(
    of: Source, points: ArrayLike, *, space: Space = "world", precision: Precision | None = None
) -> Trace:
    """Follow points through every stage, as the command ``project`` does.

    Parameters
    ----------
    points : (..., 3) or (..., 4) array_like
        World units. A fourth number is w: 0 makes a point at infinity, a direction.
    space : {"world", "object"}
        The space of the points.
    precision : {"float32", "float64", "exact"}, optional
        By default float64, or exact where the error of float64 could be above 1e-9 px or 1e-12 in
        depth.

    Returns
    -------
    Trace
        Named arrays: ``world`` and ``view`` (..., 3), or (..., 4) for points with w; ``clip``
        (..., 4); ``ndc`` (..., 3); ``image`` (..., 2) in pixels; ``depth`` (...) in [0, 1];
        ``in_front`` (...) bool; and ``outside`` (..., 6) bool, beyond near, far, left, right,
        bottom and top. Where there is no picture, ``ndc``, ``image`` and ``depth`` are NaN.

    Notes
    -----
    `Projection.trace` is the same in float64, without a bound on the error. The view matrix is that
    of lecture 004, the perspective matrix equation (13) of lecture 000. The eye is subtracted
    first, so that a scene far from the origin loses no digits.
    """
    projection, given = _document(of).projection, _checked(points)
    flat = given.reshape(-1, given.shape[-1])
    has_w = flat.shape[1] == 4
    if precision is None:
        finite = flat[flat[:, 3] != 0.0, :3] if has_w else flat
        precision = precision_for_reading(predict(projection, finite, space=space))
    if has_w:
        followed = trace_homogeneous(projection, flat, precision, space)
    else:
        followed = trace(projection, flat, precision, space=space)
    return Trace._make(part.reshape(given.shape[:-1] + part.shape[1:]) for part in followed)


def matrices(of: Source) -> dict[str, Array]:
    """Return the matrix of every stage by its name, ``target_from_source``, in their order.

    Column vectors: ``p_out = M @ p_in``. The divide by w comes between clip space and NDC. Each
    number is computed in rationals and rounded once. `Projection.stages` has the factors, too.
    """
    return {stage.name: stage.matrix for stage in _document(of).projection.all_stages}


def describe(of: Source) -> Description:
    """Say in words what each pane shows, what is cut off, and what is risky.

    The sentences are those with which an SVG or PDF figure describes itself.
    """
    document = _document(of)
    return described(document, load_scene(document.scene, mesh=document.mesh))


def figure(
    of: Source,
    points: ArrayLike | None = None,
    *,
    cloud: ArrayLike | None = None,
    colours: str | ArrayLike | None = None,
    dot_size: str | float | None = None,
    panes: Pane | Panes | Sequence[Pane] = "world,ndc,image",
    size: str | Sequence[float] | None = None,
    width: str | float | None = None,
    text_size: str | float | None = None,
    fit: Fit = "named",
    palette: Palette = "screen",
    hidden: Hidden = "none",
    crop: bool = False,
    transparent: bool = False,
) -> Figure:
    """Return a figure, which a notebook shows; it is drawn when it is shown or saved.

    Parameters
    ----------
    of : Document or Projection
        A projection is shown with the letter F.
    points : (n, 3) or (n, 4) array_like, optional
        At most six points in world units, or directions (w = 0), which are marked in all panes.
        They replace those of the document.
    cloud : (n, 3) array_like, optional
        1 to 1 000 000 points that are drawn as dots beside the scene's objects, in their
        coordinates; alone, if `of` is a projection. What faces hide is not seen, and near and far
        cut it. Up to 5 000 dots are circles, and more are pixels. A PNG does not contain them.
    colours : str or (3,) or (n, 3) array_like, optional
        Of the cloud: ``"#rrggbb"``, or red, green and blue, whole up to 255 or parts of 1.
    dot_size : str or float, optional
        Diameter of a dot in points, ``2`` or ``"2pt"``; smaller by default the more dots there are.
    panes : str or sequence of str
        In a row, ``"world,image"`` or ``["world", "image"]``, or in a column, ``"world/image"``.
    size : str or (width, height), optional
        On paper, ``"120mmx80mm"``, in mm, cm or in; or in pixels, 300 an inch. By default 640
        pixels a side for each pane.
    width : str or float, optional
        Instead of a size: ``"84mm"``, or pixels. It is cropped to that, and its height is free.
    text_size : str or float, optional
        Height of the letters' em in points: ``8`` or ``"8pt"``.
    fit : {"named", "frustum", "scene"}
        What the world frames.
    palette : {"screen", "print", "dark", "contrast"}
    hidden : {"none", "dashed", "grey"}
        What becomes of lines behind faces, in SVG and PDF.
    crop : bool
        Leave out what is empty around the content, but for a margin of 2 mm.
    transparent : bool
        Leave the background transparent.
    """
    document = _document(of)
    if points is not None:
        given = _checked(points)
        rows = given.reshape(-1, given.shape[-1]).tolist()
        if len(rows) > MOST_PROBES:
            raise Refusal.saying(REFUSALS["marked"], MOST_PROBES, len(rows))
        probes = tuple(
            Probe.of(number, (x, y, z, w[0] if w else 1.0))
            for number, (x, y, z, *w) in enumerate(rows, 1)
        )
        document = replace(document, view=replace(document.view, probes=probes))
    if not isinstance(panes, Sequence):
        raise Refusal("panes", panes, REFUSALS["some-panes"], ", ".join(PANES))
    column = isinstance(panes, str) and "/" in panes
    named = panes.split("/" if column else ",") if isinstance(panes, str) else list(panes)
    _check_flags(crop=crop, transparent=transparent)
    beside: dict[str, Any] = {} if width is None else {"size": size, "crop": crop or None}
    alone: dict[str, Any] = {"colours": colours, "dot_size": dot_size} if cloud is None else {}
    for name, value in (beside | alone).items():
        if value is not None:
            bound = REFUSALS["no-width"] if name in beside else REFUSALS["of-cloud"]
            raise Refusal(name, value, bound)
    if cloud is None:
        scene = load_scene(document.scene, mesh=document.mesh)
    else:
        scene = _clouded(document, cloud, colours, dot_size, alone=isinstance(of, Projection))
    units = ", ".join(PX_PER)
    bad_size = Refusal.saying(REFUSALS["a-size"], repr(size), units)
    bad_width = Refusal.saying(REFUSALS["a-length"], repr(width), units)
    return ScriptFigure(
        document, scene, named, _read(size, parse_size, _two_numbers, bad_size), column=column,
        fit=fit, palette=palette, text_pt=_points(text_size), hidden=hidden, crop=crop,
        width=_read(width, parse_length, _number, bad_width), transparent=transparent,
    )  # fmt: skip


def _clouded(
    document: Document,
    cloud: ArrayLike,
    colours: object,
    dot_size: str | float | None,
    *,
    alone: bool,
) -> Scene:
    points = checked_points(cloud, (3,), "cloud").reshape(-1, 3)
    if not 1 <= len(points) <= MOST_DOTS:
        raise Refusal.saying(REFUSALS["api-cloud"], len(points), MOST_DOTS)
    size_pt, (least, most) = _points(dot_size, "dot_size"), DOT_PT
    if size_pt is not None and not least <= size_pt <= most:
        raise Refusal("dot_size", dot_size, REFUSALS["a-dot"], least, most)
    widths = None if size_pt is None else size_pt * DPI / 72.0 / LIGHT.line_width
    rgb = None if colours is None else _rgb(colours, len(points))
    if alone:
        return cloud_alone(points, rgb, widths)
    return load_scene(document.scene, mesh=document.mesh).with_cloud(points, rgb, widths)


def _rgb(colours: Any, count: int) -> Colours:
    """Return the colours of so many points, (n, 3) uint8."""
    is_text = isinstance(colours, str)
    try:
        given = np.asarray(list(bytes.fromhex(colours[1:])) if _HEX(str(colours)) else colours)
    except ValueError:  # rows of other lengths
        given = np.empty(0)
    if given.dtype.kind in "uif" and given.shape in ((3,), (count, 3)):
        whole = 255.0 * given if given.dtype.kind == "f" else given
        if whole.min() >= 0 and whole.max() <= 255:
            return np.broadcast_to(np.rint(whole).astype(np.uint8), (count, 3))
    shown = colours if is_text else given.shape
    raise Refusal("colours", shown, REFUSALS["some-colours"], count)


def _check_flags(**flags: object) -> None:
    for name, flag in flags.items():
        if not isinstance(flag, bool):
            raise Refusal(name, flag, REFUSALS["yes-or-no"])


def _document(of: Source) -> Document:
    if isinstance(of, Projection):
        return Document(projection=of)
    if not isinstance(of, Document):
        named = repr(of if isinstance(of, str) else "letter-f")
        raise Refusal("of", of, REFUSALS["a-source"], named)
    return of


def _checked(points: ArrayLike) -> Array:
    """Points, (..., 3), or homogeneous ones with w = 0 or 1, (..., 4)."""
    given = checked_points(points, (3, 4))
    return given if given.shape[-1] == 3 else homogeneous_rows(given)


def _read(
    value: Any, parse: Callable[[str], Any], number: Callable[[Any], Any], no: Refusal
) -> Any:
    """Return what a text or a number means; raise `no` for anything else."""
    try:
        return value if value is None else (parse if isinstance(value, str) else number)(value)
    except (ValueError, TypeError):
        raise no from None


def _points(size: str | float | None, name: str = "text_size") -> float | None:
    no = Refusal(name, size, REFUSALS["a-text-size"])
    points: float | None = _read(size, parse_points, _number, no)
    return points


def _two_numbers(values: Sequence[float]) -> Size:
    width, height = map(_number, values)
    return Size(width, height)
