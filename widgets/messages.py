"""What is said when something is refused: one sentence, in the reader's language.

The core raises errors whose parts are data (field, value, bound, limits) because it knows no Qt;
here they become a sentence. The lists below repeat the core's English so that lupdate finds it;
a test holds them against the core's own lists.
"""

from __future__ import annotations

import math
import numbers

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication

from app.document import DocumentError
from app.projection import (
    BOTTOM_BEFORE_TOP,
    FINITE_NUMBER,
    LEFT_BEFORE_RIGHT,
    NEAR_BEFORE_FAR,
    NOT_THE_EYE,
    THREE_NUMBERS,
    ProjectionError,
    format_value,
)

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
    QT_TRANSLATE_NOOP("ProjectionError", "is too close to {0} for float64 to tell apart"),
)
"""Every bound of a `ProjectionError`: the members of `app.projection.BOUNDS`."""

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
    QT_TRANSLATE_NOOP("DocumentError", "is given twice"),
    QT_TRANSLATE_NOOP("DocumentError", "has more than {0} levels of brackets"),
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
    QT_TRANSLATE_NOOP("DocumentError", "is a picture without a Frustum Lab document in it"),
    QT_TRANSLATE_NOOP("DocumentError", "is not known; the nearest name is {0}"),
    QT_TRANSLATE_NOOP("DocumentError", "belongs to another lens: set lens.kind={0} as well"),
    QT_TRANSLATE_NOOP("DocumentError", "must be written as NAME=VALUE"),
    QT_TRANSLATE_NOOP("DocumentError", "The document"),
)
"""Every further part of a `DocumentError`: the members of `app.document.BOUNDS`."""

# What only a control can refuse: text that is no number, and the core's one-sided bounds as
# seen from the other side (far dragged below near is far's fault in the reader's eyes).
A_NUMBER = QT_TRANSLATE_NOOP("ProjectionError", "must be a number, such as 0.5 or 2e-3")
A_NUMBER_OR_INFINITY = QT_TRANSLATE_NOOP("ProjectionError", "must be a number, or inf for ∞")
FAR_BEYOND_NEAR = QT_TRANSLATE_NOOP("ProjectionError", "must be greater than near, which is {0}")
RIGHT_OF_LEFT = QT_TRANSLATE_NOOP("ProjectionError", "must be greater than left, which is {0}")
TOP_ABOVE_BOTTOM = QT_TRANSLATE_NOOP("ProjectionError", "must be greater than bottom, which is {0}")
NOT_THE_TARGET = QT_TRANSLATE_NOOP(
    "ProjectionError", "must differ from the target, or the camera looks nowhere"
)

FIELDS = {
    "near": QT_TRANSLATE_NOOP("Field", "Near"),
    "far": QT_TRANSLATE_NOOP("Field", "Far"),
    "fov_y_deg": QT_TRANSLATE_NOOP("Field", "Vertical fov"),
    "fov_x_deg": QT_TRANSLATE_NOOP("Field", "Horizontal fov"),
    "focal_length_mm": QT_TRANSLATE_NOOP("Field", "Focal length"),
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


def field_name(field: str) -> str:
    """The translated name of a field; a name that is not in `FIELDS` is already one."""
    return QCoreApplication.translate("Field", FIELDS[field]) if field in FIELDS else field


def number_text(value: float) -> str:
    """A number with every digit it has, as a person would type it: ``0.1``, ``30``, ``∞``."""
    if math.isinf(value):
        return "∞" if value > 0 else "-∞"
    return format_value(value)


def _value_text(value: object) -> str:
    if isinstance(value, str):
        return f"“{value if len(value) <= 40 else value[:37] + '...'}”"
    if isinstance(value, numbers.Real) and not isinstance(value, bool):
        return number_text(float(value))
    return format_value(value)


def _bound(template: str) -> str:
    context = "DocumentError" if template in DOCUMENT_BOUNDS else "ProjectionError"
    return QCoreApplication.translate(context, template)


def sentence(error: Exception) -> str:
    """Say what was refused: the field, the value, the bound, in the window's language.

    Parameters
    ----------
    error : Exception
        A `ProjectionError` or `DocumentError` is translated; any other speaks for itself.
    """
    if isinstance(error, DocumentError):
        return error.sentence(_bound)
    if isinstance(error, ProjectionError):
        bound = _bound(error.bound).format(*error.limits)
        return f"{field_name(error.field)} = {_value_text(error.value)}: {bound}."
    return str(error)


_OTHER_SIDE = {
    ("far", NEAR_BEFORE_FAR): FAR_BEYOND_NEAR,
    ("right", LEFT_BEFORE_RIGHT): RIGHT_OF_LEFT,
    ("top", BOTTOM_BEFORE_TOP): TOP_ABOVE_BOTTOM,
}


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
    if (field, error.bound) in _OTHER_SIDE:
        lower = _value_text(error.value)
        return ProjectionError(field, value, _OTHER_SIDE[field, error.bound], lower)
    if field == "eye" and error.bound == NOT_THE_EYE:
        return ProjectionError("eye", error.value, NOT_THE_TARGET)
    if error.bound == THREE_NUMBERS:
        return ProjectionError(name, value, FINITE_NUMBER)
    return error
