"""The displayed names of a document's fields."""

from __future__ import annotations

from app.model.refusal import QT_TRANSLATE_NOOP

FIELDS = {
    "near": QT_TRANSLATE_NOOP("Field", "Near"),
    "far": QT_TRANSLATE_NOOP("Field", "Far"),
    "fov_y_deg": QT_TRANSLATE_NOOP("Field", "Field of view"),
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
    "translate": QT_TRANSLATE_NOOP("Field", "Translation"),
    "rotate_deg": QT_TRANSLATE_NOOP("Field", "Rotation"),
    "scale": QT_TRANSLATE_NOOP("Field", "Scale"),
    "order": QT_TRANSLATE_NOOP("Field", "Order"),
    "image": QT_TRANSLATE_NOOP("Field", "Image"),
    "width": QT_TRANSLATE_NOOP("Field", "Width"),
    "height": QT_TRANSLATE_NOOP("Field", "Height"),
    "depth": QT_TRANSLATE_NOOP("Field", "Depth range"),
    "answer": QT_TRANSLATE_NOOP("Field", "Answer"),
}
"""The displayed name of each field of the model, in the window and in figures."""
