"""What is said when something is refused: one sentence, in the reader's language.

The core raises errors whose parts are data (template, field, value, limits) because it knows no
Qt; here they become a sentence. The lists below repeat the core's English so that lupdate finds it;
a test holds them against the core's own lists.
"""

from __future__ import annotations

import math
import numbers
import re
from collections.abc import Callable
from pathlib import Path
from typing import Protocol, cast, runtime_checkable

from PySide6 import QtCore
from PySide6.QtCore import QCoreApplication

from app.model.projection import (
    FINITE_NUMBER,
    NOT_THE_EYE,
    OTHER_SIDE,
    THREE_NUMBERS,
    ProjectionError,
    format_value,
    shown_limits,
)

# PySide6 declares that it takes and gives objects.
QT_TRANSLATE_NOOP = cast("Callable[[str, str], str]", QtCore.QT_TRANSLATE_NOOP)

STAGE_NOTES = (
    QT_TRANSLATE_NOOP("Stage", "the scene's objects are given in world coordinates"),
    QT_TRANSLATE_NOOP("Stage", "a parallel lens has no M_pp: this is the identity"),
    QT_TRANSLATE_NOOP(
        "Stage", "far is infinite: the canonical pyramid is scaled by near, which is at z = -1"
    ),
)
"""Every note of a `Stage`: the members of `app.model.projection.NOTES`."""

PROJECTION_BOUNDS = (
    QT_TRANSLATE_NOOP("ProjectionError", "must be a finite number"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be greater than {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be at least {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be at most {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must lie between {0} and {1}, both excluded"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be less than far, which is {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be less than right, which is {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be less than top, which is {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be three finite numbers x, y, z"),
    QT_TRANSLATE_NOOP("ProjectionError", "must differ from the eye, or the camera looks nowhere"),
    QT_TRANSLATE_NOOP("ProjectionError", "must not be the zero vector"),
    QT_TRANSLATE_NOOP("ProjectionError", "must not be parallel to the view direction"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be a whole number of pixels from 1 to {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be one of {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be greater than near, which is {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be greater than left, which is {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be greater than bottom, which is {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "is too close to {0} for float64 to tell apart"),
    QT_TRANSLATE_NOOP(
        "ProjectionError", "is too close to {0} for a plane as far from the eye as near is"
    ),
    QT_TRANSLATE_NOOP("ProjectionError", "is at infinity, where there is no point but a direction"),
    QT_TRANSLATE_NOOP("ProjectionError", "must have an inverse, but its rank is {0}"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be four rows of four finite numbers"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be 0 or at least {0} in size"),
    QT_TRANSLATE_NOOP(
        "ProjectionError", "must have an inverse that float64 can hold, and multiply"
    ),
)
"""Every bound of a `ProjectionError`: the members of `app.model.projection.BOUNDS`."""

SETTING_BOUNDS = (
    QT_TRANSLATE_NOOP("ProjectionError", "must be a whole number"),
    QT_TRANSLATE_NOOP("ProjectionError", "must be true or false"),
)
"""What the phenomena's illustrations add to them; each phenomenon marks what it adds itself."""

DOCUMENT_BOUNDS = (
    QT_TRANSLATE_NOOP("DocumentError", "is missing"),
    QT_TRANSLATE_NOOP("DocumentError", "is empty"),
    QT_TRANSLATE_NOOP(
        "DocumentError",
        "is broken or cut short: from line {0}, column {1} on it is not JSON",
    ),
    QT_TRANSLATE_NOOP("DocumentError", "is not a Frustum Lab document: it is not UTF-8 text"),
    QT_TRANSLATE_NOOP("DocumentError", "is not a Frustum Lab document"),
    QT_TRANSLATE_NOOP(
        "DocumentError",
        "was written by a newer Frustum Lab: its version is {0}, this program reads up to {1}",
    ),
    QT_TRANSLATE_NOOP("DocumentError", "must be a whole number from 1 on"),
    QT_TRANSLATE_NOOP("DocumentError", "must be a finite number or inf"),
    QT_TRANSLATE_NOOP("DocumentError", "is given twice"),
    QT_TRANSLATE_NOOP("DocumentError", "has more than {0} levels of brackets"),
    QT_TRANSLATE_NOOP("DocumentError", "has more than {0} values"),
    QT_TRANSLATE_NOOP("DocumentError", "is larger than {0} MiB"),
    QT_TRANSLATE_NOOP("DocumentError", "must be an object with named values in braces"),
    QT_TRANSLATE_NOOP("DocumentError", "must be the name of a scene or of a mesh file"),
    QT_TRANSLATE_NOOP("DocumentError", "does not exist"),
    QT_TRANSLATE_NOOP("DocumentError", "is a folder, not a file"),
    QT_TRANSLATE_NOOP("DocumentError", "cannot be written: it is write-protected"),
    QT_TRANSLATE_NOOP("DocumentError", "cannot be read: {0}"),
    QT_TRANSLATE_NOOP("DocumentError", "cannot be written: {0}"),
    QT_TRANSLATE_NOOP("DocumentError", "is not a name that a file can have"),
    QT_TRANSLATE_NOOP("DocumentError", "is not a whole PNG picture: it is broken or cut short"),
    QT_TRANSLATE_NOOP(
        "DocumentError",
        "is neither a document (.json), an exported picture (.png) nor a mesh ({0})",
    ),
    QT_TRANSLATE_NOOP("DocumentError", "is a picture without a Frustum Lab document in it"),
    QT_TRANSLATE_NOOP("DocumentError", "is not known; the nearest name is {0}"),
    QT_TRANSLATE_NOOP("DocumentError", "belongs to another lens: set lens.kind as well ({0})"),
    QT_TRANSLATE_NOOP("DocumentError", "belongs to another scene: set scene as well ({0})"),
    QT_TRANSLATE_NOOP("DocumentError", "must be the path of a mesh file ({0}), or empty for none"),
    QT_TRANSLATE_NOOP(
        "DocumentError", "cannot be shown in the scene {0}, which needs its own objects"
    ),
    QT_TRANSLATE_NOOP("DocumentError", "must be written as NAME=VALUE"),
    QT_TRANSLATE_NOOP("DocumentError", "The document"),
)
"""Every further part of a `DocumentError`: the members of `app.document.document.BOUNDS`."""

SCENE_SENTENCES = (
    QT_TRANSLATE_NOOP("SceneError", "{0}: there is no such file; check its name and folder."),
    QT_TRANSLATE_NOOP("SceneError", "{0}: this is a folder; choose a mesh file inside it."),
    QT_TRANSLATE_NOOP("SceneError", "{0}: no permission to read it; change its permissions."),
    QT_TRANSLATE_NOOP("SceneError", "{0}: cannot be read ({1})."),
    QT_TRANSLATE_NOOP("SceneError", "{0}: not a possible file name; rename the file."),
    QT_TRANSLATE_NOOP("SceneError", "{0}: the file is empty; save or download it again."),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the file holds no faces (and no vertices), so that there is no surface to draw; "
        "export the mesh with faces.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the file holds no faces (one vertex), so that there is no surface to draw; "
        "export the mesh with faces.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the file holds no faces ({1} vertices), so that there is no surface to draw; "
        "export the mesh with faces.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: {1} face of {2} has fewer than three corners; "
        "the file is damaged or cut off, save or download it again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: {1} faces of {2} have fewer than three corners; "
        "the file is damaged or cut off, save or download it again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: a face names a vertex that does not exist (there are {1}); "
        "the file is damaged or cut off, save or download it again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: {1} vertex of {2} is not finite (nan or inf); repair the mesh and export it again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: {1} vertices of {2} are not finite (nan or inf); "
        "repair the mesh and export it again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: it would grow to {1} triangles and {2} MiB, and at most {3} triangles and "
        "{4} MiB are shown; "
        "make it smaller.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: there is not enough memory to read it; make it smaller, or close other programs.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "{0}: it cannot be read ({1}); export or download the file again."
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "{0}: line {1} cannot be read as OBJ; export or download the file again."
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: this is not an STL file, neither text (which begins with “solid”) nor binary; "
        "check what kind of file it is.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the file is cut off after {1} of {2} triangles; export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: a facet has not three vertices of three numbers; export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the file is cut off in the middle of a facet; export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: this is not a PLY file, which begins with “ply” and has a line “end_header”; "
        "check what kind of file it is.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its PLY header does not describe a mesh; export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: there is something between its numbers that is not a number; "
        "export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "{0}: its vertices have no x, y, z; export or download the file again."
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its faces have no list vertex_indices; export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the file is cut off before the last of its {1} {2} rows; "
        "export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: this is not a GLB file, which begins with “glTF”; check what kind of file it is.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "{0}: its mesh is compressed ({1}); export it without compression."
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its part {1} cannot be read ({2}); keep the files of a glTF mesh together.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its part {1} is not a file in the folder of the mesh, and nothing else is read; "
        "keep the files of a glTF mesh together.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the file is cut off after {1} of {2} bytes of data; "
        "export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its JSON part, which describes the mesh, is damaged in line {1}; "
        "export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its JSON part, which describes the mesh, is damaged; "
        "export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its JSON part, which describes the mesh, has more than {1} lists and objects; "
        "export it in fewer parts.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "{0}: its glTF description lacks “{1}”; export or download the file again."
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its glTF description is not valid (version {1}, not 2); "
        "export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its glTF description is not valid (a node is below itself); "
        "export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its glTF description is not valid (sparse accessors are not read); "
        "export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: its glTF description is not valid (accessor {1} asks for more data than there "
        "are); export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "{0}: its glTF description is not valid; export or download the file again."
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the program that reads it ended before it was done; "
        "make it smaller, or export or download the file again.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "{0}: a mesh file must end in {1} or {2}; convert it to one of these."
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "There is no scene “{0}”, only {1} or {2}; a mesh file needs its ending."
    ),
    QT_TRANSLATE_NOOP(
        "SceneError", "There is no scene “{0}”, only {1} or {2}; did you mean “{3}”?"
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: all vertices are at one point, so that there is nothing to see; check the export.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: all vertices are on one line, so that there is nothing to see; check the export.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "{0}: the mesh is {1} units large, but must be between 1e-30 and 1e30; scale it.",
    ),
    QT_TRANSLATE_NOOP(
        "SceneError",
        "mesh = {1}: the scene “{0}” has a subject of its own, no mesh can take its place.",
    ),
)
"""Every `SceneError`: the members of the `SENTENCES` of `mesh_files`, `reading` and `scene` in
`app.scenes`."""

FIGURE_SENTENCES = (
    QT_TRANSLATE_NOOP("FigureError", "panes = {0}: must name at least one of {1}."),
    QT_TRANSLATE_NOOP("FigureError", "pane = {0}: must be one of {1}."),
    QT_TRANSLATE_NOOP("FigureError", "scale = {0}: must lie between 0, excluded, and {1}."),
    QT_TRANSLATE_NOOP(
        "FigureError", "width = {0}: must be a whole number of pixels from {1} to {2}."
    ),
    QT_TRANSLATE_NOOP(
        "FigureError", "height = {0}: must be a whole number of pixels from {1} to {2}."
    ),
    QT_TRANSLATE_NOOP(
        "FigureError",
        "width = {0} times scale {3}: must be from {1} to {2} pixels.",
    ),
    QT_TRANSLATE_NOOP(
        "FigureError",
        "height = {0} times scale {3}: must be from {1} to {2} pixels.",
    ),
)
"""Every `FigureError`: the members of `app.drawings.figures.SENTENCES`."""

HEALTH_SENTENCES = (
    QT_TRANSLATE_NOOP(
        "Health",
        "None of the scene's objects is in the picture: all lie beyond the {0} plane",
    ),
    QT_TRANSLATE_NOOP(
        "Health", "A GPU's float32 cannot hold this picture: it is computed in float64"
    ),
    QT_TRANSLATE_NOOP(
        "Health", "At the target, a 24-bit depth buffer cannot tell any two surfaces apart"
    ),
    QT_TRANSLATE_NOOP(
        "Health", "At the target, a 24-bit depth buffer tells surfaces apart only from {0} on"
    ),
    QT_TRANSLATE_NOOP(
        "Health",
        "In float64 only {0} decimals of a pixel and {1} of the depth would be certain: the "
        "numbers are computed exactly",
    ),
    QT_TRANSLATE_NOOP(
        "Health",
        "A GPU's float32 would draw up to {0} px off: the picture is computed in float64",
    ),
    QT_TRANSLATE_NOOP("Health", "The free matrix has no inverse: no frustum is drawn"),
    QT_TRANSLATE_NOOP("Health", "The free matrix is too nearly singular: no frustum is drawn"),
    QT_TRANSLATE_NOOP(
        "Health", "The free matrix' view volume reaches infinity: no frustum is drawn"
    ),
    QT_TRANSLATE_NOOP("Health", "VTK's own camera would clamp the field of view to {0}°"),
    QT_TRANSLATE_NOOP(
        "Health",
        "The scene is {0} times as large as near: VTK by itself drops what is near from 1e7 on",
    ),
)
"""Every `app.precision.risks.Risk`: the members of `app.precision.risks.SENTENCES`."""

MEASURE_SENTENCES = (
    QT_TRANSLATE_NOOP(
        "Measure", "{0} is the fastest ({1}) and the most exact ({2}): there is nothing to trade."
    ),
    QT_TRANSLATE_NOOP(
        "Measure",
        "{0} is the fastest ({1}, off by {2}), {3} the most exact ({4}, off by {5}); the "
        "cheapest that is off by less than {6} is {7}.",
    ),
    QT_TRANSLATE_NOOP(
        "Measure",
        "{0} is the fastest ({1}, off by {2}), {3} the most exact ({4}, off by {5}); none"
        " is off by less than {6}.",
    ),
    QT_TRANSLATE_NOOP(
        "Measure",
        "At the target, {0} tells surfaces apart from {1} world units on with {2}; the "
        "finest, {3} with {4}, from {5} on.",
    ),
    QT_TRANSLATE_NOOP("Measure", "Nothing could be measured: {0}."),
    QT_TRANSLATE_NOOP("Measure", "{0}: is not a file of measurements."),
    QT_TRANSLATE_NOOP(
        "Measure",
        "{0}: was measured by another Frustum Lab: its version is {1}, this one reads {2}.",
    ),
    QT_TRANSLATE_NOOP("Measure", "{0}: is damaged: {1}."),
    QT_TRANSLATE_NOOP("Measure", "{0} is measured only: the panes are not drawn with it."),
)
"""Members of `app.measure.meaning.SENTENCES` and `app.measure.results.SENTENCES`."""

MEASURE_NOTES = (
    QT_TRANSLATE_NOOP(
        "Measure", "no vertex is in front of the eye, so that there is nothing to measure"
    ),
    QT_TRANSLATE_NOOP("Measure", "not installed"),
    QT_TRANSLATE_NOOP("Measure", "answers NaN"),
    QT_TRANSLATE_NOOP("Measure", "overflows"),
    QT_TRANSLATE_NOOP("Measure", "no edge of the scene's box is in the picture"),
    QT_TRANSLATE_NOOP("Measure", "all of the edge is equally far away: nothing is wrong"),
    QT_TRANSLATE_NOOP("Measure", "the target lies outside of near and far"),
    QT_TRANSLATE_NOOP("Measure", "the scene has too few triangles to leave any out"),
    QT_TRANSLATE_NOOP("Measure", "nothing of the scene is in the picture"),
    QT_TRANSLATE_NOOP("Measure", "cancelled"),
)
"""Why there is no number, where no value stands in it."""

MEASURE_WORDS = (
    QT_TRANSLATE_NOOP("Measure", "eye first"),
    QT_TRANSLATE_NOOP("Measure", "every stage"),
    QT_TRANSLATE_NOOP("Measure", "exact"),
    QT_TRANSLATE_NOOP("Measure", "numpy's hstack"),
    QT_TRANSLATE_NOOP("Measure", "VTK's transform"),
    QT_TRANSLATE_NOOP("Measure", "matplotlib's proj3d"),
    QT_TRANSLATE_NOOP("Measure", "perspective-correct"),
    QT_TRANSLATE_NOOP("Measure", "affine"),
    QT_TRANSLATE_NOOP("Measure", "{0} pieces"),
    QT_TRANSLATE_NOOP("Measure", "opengl"),
    QT_TRANSLATE_NOOP("Measure", "direct3d"),
    QT_TRANSLATE_NOOP("Measure", "reversed"),
    QT_TRANSLATE_NOOP("Measure", "logarithmic"),
    QT_TRANSLATE_NOOP("Measure", "none"),
    QT_TRANSLATE_NOOP("Measure", "half resolution"),
    QT_TRANSLATE_NOOP("Measure", "supersampling {0} x {0}"),
    QT_TRANSLATE_NOOP("Measure", "this OpenGL gives {0} samples"),
    QT_TRANSLATE_NOOP("Measure", "the same picture"),
    QT_TRANSLATE_NOOP("Measure", "p95"),
    QT_TRANSLATE_NOOP("Measure", "predicted"),
    QT_TRANSLATE_NOOP("Measure", "world units"),
    QT_TRANSLATE_NOOP("Measure", "texels"),
    QT_TRANSLATE_NOOP("Measure", "levels RMS"),
    QT_TRANSLATE_NOOP("Measure", "depth error (of 1)"),
    QT_TRANSLATE_NOOP("Measure", "predicted depth error (of 1)"),
    QT_TRANSLATE_NOOP("Measure", "pairs collapsed (of 1)"),
    QT_TRANSLATE_NOOP("Measure", "predicted to collapse (of 1)"),
    QT_TRANSLATE_NOOP("Measure", "memory (MiB)"),
    QT_TRANSLATE_NOOP("Measure", "first frame (ms)"),
    QT_TRANSLATE_NOOP("Measure", "reducing (ms)"),
    QT_TRANSLATE_NOOP("Measure", "triangles"),
    QT_TRANSLATE_NOOP("Measure", "near"),
    QT_TRANSLATE_NOOP("Measure", "far"),
    QT_TRANSLATE_NOOP("Measure", "fov"),
    QT_TRANSLATE_NOOP("Measure", "distance"),
    QT_TRANSLATE_NOOP("Measure", "up"),
    QT_TRANSLATE_NOOP("Measure", "aspect"),
    QT_TRANSLATE_NOOP("Measure", "far is 4 near at least"),
    QT_TRANSLATE_NOOP("Measure", "near is far / 4 at most"),
    QT_TRANSLATE_NOOP("Measure", "the largest of up to {0} points against 200 digits of mpmath"),
)
"""Members of `app.measure.results.WORDS`."""

CHART_TEXTS = (
    QT_TRANSLATE_NOOP("Measure", "Arithmetic"),
    QT_TRANSLATE_NOOP("Measure", "Interpolation"),
    QT_TRANSLATE_NOOP("Measure", "Depth buffer"),
    QT_TRANSLATE_NOOP("Measure", "Antialiasing and resolution"),
    QT_TRANSLATE_NOOP("Measure", "Detail"),
    QT_TRANSLATE_NOOP("Measure", "Sweep of near"),
    QT_TRANSLATE_NOOP("Measure", "Sweep of far"),
    QT_TRANSLATE_NOOP("Measure", "Sweep of the field of view"),
    QT_TRANSLATE_NOOP("Measure", "Sweep of the distance from the origin"),
    QT_TRANSLATE_NOOP("Measure", "Sweep of up"),
    QT_TRANSLATE_NOOP("Measure", "Sweep of the aspect"),
    QT_TRANSLATE_NOOP("Measure", "ns a point"),
    QT_TRANSLATE_NOOP("Measure", "ns a pixel"),
    QT_TRANSLATE_NOOP("Measure", "bytes a pixel"),
    QT_TRANSLATE_NOOP("Measure", "ms a frame"),
    QT_TRANSLATE_NOOP("Measure", "near"),
    QT_TRANSLATE_NOOP("Measure", "far"),
    QT_TRANSLATE_NOOP("Measure", "vertical fov, degrees"),
    QT_TRANSLATE_NOOP("Measure", "distance from the origin"),
    QT_TRANSLATE_NOOP("Measure", "angle of up and view direction, degrees"),
    QT_TRANSLATE_NOOP("Measure", "aspect of the window"),
    QT_TRANSLATE_NOOP("Measure", "180 − vertical fov, degrees"),
    QT_TRANSLATE_NOOP("Measure", "error, px"),
    QT_TRANSLATE_NOOP("Measure", "error, texels"),
    QT_TRANSLATE_NOOP("Measure", "gap, world units"),
    QT_TRANSLATE_NOOP("Measure", "error, levels of 255"),
    QT_TRANSLATE_NOOP("Measure", "silhouette, px"),
    QT_TRANSLATE_NOOP("Measure", "largest error, px"),
    QT_TRANSLATE_NOOP("Measure", "{0} (cancelled)"),
    QT_TRANSLATE_NOOP("Measure", "{0} (now)"),
    QT_TRANSLATE_NOOP("Measure", "{0}; eye {1}, target {2}, {3}"),
)
"""Members of `app.measure.chart.TEXTS`."""

PROPERTY_SENTENCES = (
    QT_TRANSLATE_NOOP("Matrix", "affine: w is {0} everywhere"),
    QT_TRANSLATE_NOOP("Matrix", "not affine: w depends on {0}"),
    QT_TRANSLATE_NOOP("Matrix", "singular (rank {0}): the frustum cannot be drawn"),
    QT_TRANSLATE_NOOP(
        "Matrix", "mirrored: it turns right-handed space into left-handed (determinant {0})"
    ),
    QT_TRANSLATE_NOOP(
        "Matrix", "mirrored: as if left and right, top and bottom, or near and far were exchanged"
    ),
    QT_TRANSLATE_NOOP(
        "Matrix", "not rigid: it changes lengths or angles, so that no camera has it"
    ),
    QT_TRANSLATE_NOOP(
        "Matrix", "w vanishes where {0} = 0: the divide sends these points to infinity"
    ),
    QT_TRANSLATE_NOOP("Matrix", "w is {0} everywhere: there is no picture"),
    QT_TRANSLATE_NOOP("Matrix", "w is negative all over the view volume: there is no picture"),
    QT_TRANSLATE_NOOP("Matrix", "the view volume reaches infinity: the frustum cannot be drawn"),
)
"""Every `Property`: the members of `app.lecture.typed_matrix.PROPERTIES`."""

SPACES = {
    "object": QT_TRANSLATE_NOOP("Space", "object"),
    "world": QT_TRANSLATE_NOOP("Space", "world"),
    "view": QT_TRANSLATE_NOOP("Space", "view"),
    "canonical_perspective": QT_TRANSLATE_NOOP("Space", "canonical perspective"),
    "canonical_parallel": QT_TRANSLATE_NOOP("Space", "canonical parallel"),
    "depth_range": QT_TRANSLATE_NOOP("Space", "depth range"),
    "clip": QT_TRANSLATE_NOOP("Space", "clip"),
    "ndc": QT_TRANSLATE_NOOP("Space", "ndc"),
    "image": QT_TRANSLATE_NOOP("Space", "image"),
}
"""The spaces that the stages lead from and to."""

FACTORS = {
    "rotation": QT_TRANSLATE_NOOP("Factor", "rotation"),
    "translation": QT_TRANSLATE_NOOP("Factor", "translation"),
    "scale": QT_TRANSLATE_NOOP("Factor", "scale"),
    "shear": QT_TRANSLATE_NOOP("Factor", "shear"),
}
"""What the stages' factors are called, but for the lectures' own letters."""

_CONTEXTS = {
    template: context
    for context, templates in (
        ("ProjectionError", PROJECTION_BOUNDS),
        ("DocumentError", DOCUMENT_BOUNDS),
        ("SceneError", SCENE_SENTENCES),
        ("FigureError", FIGURE_SENTENCES),
        ("Health", HEALTH_SENTENCES),
        ("Matrix", PROPERTY_SENTENCES),
        ("Measure", MEASURE_SENTENCES + MEASURE_NOTES + MEASURE_WORDS + CHART_TEXTS),
    )
    for template in templates
}

# What only a control can refuse: text that is no number, and what the core says of the target
# as seen from the eye.
A_NUMBER = QT_TRANSLATE_NOOP("ProjectionError", "must be a number, such as 0.5 or 2e-3")
A_NUMBER_LIKE = QT_TRANSLATE_NOOP("ProjectionError", "must be a number, such as {0}")
A_NUMBER_OR_INFINITY = QT_TRANSLATE_NOOP("ProjectionError", "must be a number, or inf for ∞")
NOT_THE_TARGET = QT_TRANSLATE_NOOP(
    "ProjectionError", "must differ from the target, or the camera looks nowhere"
)

FIELDS = {
    "near": QT_TRANSLATE_NOOP("Field", "Near"),
    "far": QT_TRANSLATE_NOOP("Field", "Far"),
    "fov_y_deg": QT_TRANSLATE_NOOP("Field", "Vertical fov"),
    "fov_x_deg": QT_TRANSLATE_NOOP("Field", "Horizontal fov"),
    "focal_length_mm": QT_TRANSLATE_NOOP("Field", "Focal length"),
    "e": QT_TRANSLATE_NOOP("Field", "Focal length e"),
    "window_right": QT_TRANSLATE_NOOP("Field", "Half-width"),
    "window_top": QT_TRANSLATE_NOOP("Field", "Half-height"),
    "preset": QT_TRANSLATE_NOOP("Field", "Drawing"),
    "alpha_deg": QT_TRANSLATE_NOOP("Field", "Alpha"),
    "beta_deg": QT_TRANSLATE_NOOP("Field", "Beta"),
    "receding": QT_TRANSLATE_NOOP("Field", "Receding"),
    "receding_deg": QT_TRANSLATE_NOOP("Field", "Direction"),
    "left": QT_TRANSLATE_NOOP("Field", "Left"),
    "right": QT_TRANSLATE_NOOP("Field", "Right"),
    "bottom": QT_TRANSLATE_NOOP("Field", "Bottom"),
    "top": QT_TRANSLATE_NOOP("Field", "Top"),
    "keep": QT_TRANSLATE_NOOP("Field", "Proportions"),
    "kind": QT_TRANSLATE_NOOP("Field", "Lens"),
    "eye": QT_TRANSLATE_NOOP("Field", "Eye"),
    "target": QT_TRANSLATE_NOOP("Field", "Target"),
    "up": QT_TRANSLATE_NOOP("Field", "Up"),
    "azimuth_deg": QT_TRANSLATE_NOOP("Field", "Azimuth"),
    "elevation_deg": QT_TRANSLATE_NOOP("Field", "Elevation"),
    "distance": QT_TRANSLATE_NOOP("Field", "Distance"),
    "roll_deg": QT_TRANSLATE_NOOP("Field", "Roll"),
    "image": QT_TRANSLATE_NOOP("Field", "Image"),
    "width": QT_TRANSLATE_NOOP("Field", "Width"),
    "height": QT_TRANSLATE_NOOP("Field", "Height"),
    "depth": QT_TRANSLATE_NOOP("Field", "Depth range"),
}
"""The name by which the window calls each field of the model."""

PLANE_NAMES = (
    QT_TRANSLATE_NOOP("Plane", "near"),
    QT_TRANSLATE_NOOP("Plane", "far"),
    QT_TRANSLATE_NOOP("Plane", "left"),
    QT_TRANSLATE_NOOP("Plane", "right"),
    QT_TRANSLATE_NOOP("Plane", "bottom"),
    QT_TRANSLATE_NOOP("Plane", "top"),
)
"""Those of `app.model.values.PLANES` inside a sentence."""


def breakable(text: str, longest: int = 40) -> str:
    """A text with zero-width spaces where Qt may break a word: a path would widen the window."""
    return re.sub(rf"(\S{{{longest}}})(?=\S)", "\\1\u200b", text)


def file_title(path: str) -> str:
    """A file's name without its folder, on one line: a name may hold line breaks."""
    return " ".join(Path(path).name.splitlines())


def field_name(field: str) -> str:
    """The translated name of a field; a name that is not in `FIELDS` is already one."""
    return QCoreApplication.translate("Field", FIELDS[field]) if field in FIELDS else field


def plane_name(plane: str) -> str:
    """The translated name of a plane of the view volume; any other text stays."""
    return QCoreApplication.translate("Plane", plane)


def stage_title(name: str) -> str:
    """``clip_from_view`` as a reader says it: clip ← view; a factor by its name."""
    target, between, source = name.partition("_from_")
    if not between:
        return QCoreApplication.translate("Factor", FACTORS[name]) if name in FACTORS else name
    spaces = (QCoreApplication.translate("Space", SPACES[space]) for space in (target, source))
    return " ← ".join(spaces)


def number_text(value: object) -> str:
    """A number with every digit it has, as a person would type it: ``0.1``, ``30``, ``∞``."""
    if value in (math.inf, -math.inf):  # a whole number may be too large to be asked isinf
        return "∞" if value == math.inf else "-∞"
    return format_value(value)


def _value_text(value: object) -> str:
    if isinstance(value, str):
        return f"“{value if len(value) <= 40 else value[:37] + '...'}”"
    if isinstance(value, numbers.Real) and not isinstance(value, bool):
        return number_text(value)
    return format_value(value)


def figure_text(value: float, digits: int = 6) -> str:
    """A number to be read from afar: ``0.5``, ``1000``, ``−2.5·10⁻⁵``, ``∞``.

    Parameters
    ----------
    value : float
    digits : int
        How many are significant.
    """
    if math.isinf(value) or value == 0.0 or 1e-3 <= abs(value) < 10.0 ** max(5, digits):
        text = number_text(value) if math.isinf(value) else f"{value + 0.0:.{digits}g}"
        if "e" not in text:
            return text.replace("-", "−")
    mantissa, _, exponent = f"{value:.{digits - 1}e}".partition("e")
    factor = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    power = "10" + str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    text = power if factor in ("1", "-1") else f"{factor.lstrip('-')}·{power}"
    return f"−{text}" if value < 0.0 else text


def of_phenomena(text: str) -> str:
    """A text of the phenomena in the window's language; numbers and letters stay."""
    return QCoreApplication.translate("phenomena", text)


class Words(dict[str, str]):
    """The drawings' words in the window's language, those of the phenomena's marks among them."""

    def __missing__(self, word: str) -> str:
        return of_phenomena(word)

    def get(self, word: str, default: object = None) -> str:
        """The word in the window's language: there is one for every word."""
        return self[word]


def translated(template: str) -> str:
    """A sentence of the core, of the lists above, in the window's language."""
    context = _CONTEXTS.get(template, "ProjectionError")  # or one that only a control can refuse
    return QCoreApplication.translate(context, template)


@runtime_checkable
class _Translatable(Protocol):
    """`DocumentError`, and `SceneError` and `FigureError`, whose rooms would bring VTK here."""

    def sentence(self, translate: Callable[[str], str]) -> str: ...


def sentence(error: Exception) -> str:
    """Say what was refused: the field, the value, the bound, in the window's language.

    Parameters
    ----------
    error : Exception
        One of the core's own is translated; any other speaks for itself.
    """
    if isinstance(error, _Translatable):
        return error.sentence(translated)
    if isinstance(error, ProjectionError):
        bound = translated(error.bound).format(*shown_limits(error.limits, error.value))
        return f"{field_name(error.field)} = {_value_text(error.value)}: {bound}."
    return str(error)


def seen_from(field: str, name: str, value: float, error: ProjectionError) -> ProjectionError:
    """Turn an error so that it speaks of what was edited.

    The core says "near must be less than far" whichever of the two was moved, and shows a whole
    vector for the one component that is not a number.

    Parameters
    ----------
    field, name : str
        The edited field, and what its row is called.
    value : float
        What it was to become.
    error : ProjectionError
        What the core answered.
    """
    side, bound = OTHER_SIDE.get(error.bound, ("", ""))
    if field == side:
        return ProjectionError(field, value, bound, _value_text(error.value))
    if field == "eye" and error.bound == NOT_THE_EYE:
        return ProjectionError("eye", error.value, NOT_THE_TARGET)
    if error.bound == THREE_NUMBERS:
        return ProjectionError(name, value, FINITE_NUMBER)
    return error
