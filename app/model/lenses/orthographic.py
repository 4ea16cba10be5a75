"""The orthographic lens: glOrtho, in lecture 001's steps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from app.model.lenses.lens import LensTable
from app.model.lenses.parallel import Parallel
from app.model.lenses.windowed import Windowed
from app.model.refusal import QT_TRANSLATE_NOOP
from app.model.tables import DEPTH_RANGE, NO_M_PP, PipelineStep, matrix

TRANSLATION = """
    1  0  0  -(r + l)/2
    0  1  0  -(t + b)/2
    0  0  1  n
    0  0  0  1
"""
SCALE = """
    2/(r - l)  0          0          0
    0          2/(t - b)  0          0
    0          0          1/(f - n)  0
    0          0          0          1
"""
"""Scales to the box with x, y from -1 to 1 and z from 0 at near to -1 at far."""

W_IS_ONE = """
    1  0  0  0
    0  1  0  0
    0  0  1  0
    0  0  0  1
"""
"""The identity in place of the perspective lens's step that makes w the distance."""

CLIP_FROM_VIEW = """
    2/(r - l)  0          0  -(r + l)/(r - l)
    0          2/(t - b)  0  -(t + b)/(t - b)
    0          0          A  B
    0          0          0  1
"""
VIEW_FROM_CLIP = """
    (r - l)/2  0          0  (r + l)/2
    0          (t - b)/2  0  (t + b)/2
    0          0          C  D
    0          0          0  1
"""
DEPTH = {
    "A": "(z_n - z_f)/(f - n)",
    "B": "(z_n*f - z_f*n)/(f - n)",
    "C": "(f - n)/(z_n - z_f)",
    "D": "-(z_n*f - z_f*n)/(z_n - z_f)",
}
"""Of ``z_clip = A z_view + B``, which is z_n at near and z_f at far, and back: ``C z + D``."""

AS_002_WRITES = {
    "1/(f - n)": "-1/(n - f)",
    "-1/(f - n)": "1/(n - f)",
    "-2/(f - n)": "2/(n - f)",
    "(f + n)/(f - n)": "-(n + f)/(n - f)",
}
"""Lecture 002's forms of our formulas; its n and f are the negative z of the planes."""


def box_table(factors: Mapping[str, str], clip_from_view: str, view_from_clip: str) -> LensTable:
    """The table of a parallel lens; arguments as in `perspective.pyramid_tables`."""
    to_box = tuple((name, matrix(text)) for name, text in factors.items())
    return LensTable(
        (
            PipelineStep("canonical_parallel_from_view", to_box),
            PipelineStep("canonical_parallel_from_canonical_perspective", note=NO_M_PP),
            DEPTH_RANGE,
            PipelineStep("clip_from_depth_range", (("scale", matrix(W_IS_ONE)),)),
        ),
        matrix(clip_from_view, **DEPTH),
        matrix(view_from_clip, **DEPTH),
        written={"002": AS_002_WRITES},
    )


TABLE = box_table({"scale": SCALE, "translation": TRANSLATION}, CLIP_FROM_VIEW, VIEW_FROM_CLIP)


@dataclass(frozen=True)
class Orthographic(Parallel, Windowed):
    """The orthographic lens (glOrtho); near may be negative, behind the eye."""

    kind: ClassVar[str] = "orthographic"
    tables: ClassVar[tuple[LensTable, ...]] = (TABLE,)
    title: ClassVar[str] = QT_TRANSLATE_NOOP("Lens", "orthographic")
    tip: ClassVar[str] = QT_TRANSLATE_NOOP(
        "Lens",
        "Rays are parallel and meet the picture at right angles: distance does not change size. The"
        " view volume is a box (glOrtho).",
    )

    left: float = -4.0
    right: float = 4.0
    bottom: float = -4.0
    top: float = 4.0
