"""Find a control by its name, its letter, its old names, or the words of its tooltip.

Each typed word must begin a word of the control; a single letter must be a whole word. Names come
before tooltips: "near" means the near plane, not everything that depends on it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication, QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLineEdit, QWidget

from app.model.refusal import QT_TRANSLATE_NOOP
from widgets.parts.plain import set_tip

ALSO = {
    "kind": QT_TRANSLATE_NOOP("Find", "projection lens perspective glFrustum glOrtho orthographic"
                                      " oblique matrix"),
    "fov_y_deg": QT_TRANSLATE_NOOP("Find", "vertical fov angle zoom gluPerspective"),
    "fov_x_deg": QT_TRANSLATE_NOOP("Find", "field of view angle"),
    "focal_length_mm": QT_TRANSLATE_NOOP("Find", "zoom 35 mm camera f"),
    "e": QT_TRANSLATE_NOOP("Find", "half-angle"),
    "window_right": QT_TRANSLATE_NOOP("Find", "window right r glFrustum"),
    "window_top": QT_TRANSLATE_NOOP("Find", "window top t glFrustum"),
    **dict.fromkeys(
        ("left", "right", "bottom", "top"),
        QT_TRANSLATE_NOOP("Find", "window l r b t glFrustum glOrtho off-axis"),
    ),
    "near": QT_TRANSLATE_NOOP("Find", "n plane clipping zNear"),
    "far": QT_TRANSLATE_NOOP("Find", "f plane clipping zFar infinity"),
    "keep": QT_TRANSLATE_NOOP("Find", "keep aspect stretch"),
    "preset": QT_TRANSLATE_NOOP("Find", "preset cavalier cabinet oblique"),
    **dict.fromkeys(
        ("receding", "receding_deg", "alpha_deg", "beta_deg"),
        QT_TRANSLATE_NOOP("Find", "oblique shear"),
    ),
    **dict.fromkeys(
        ("fx", "fy", "cx", "cy"),
        QT_TRANSLATE_NOOP("Find", "K intrinsics calibrated camera OpenCV principal point"),
    ),
    **dict.fromkeys(
        ("azimuth_deg", "elevation_deg", "distance"), QT_TRANSLATE_NOOP("Find", "orbit angles")
    ),
    "roll_deg": QT_TRANSLATE_NOOP("Find", "orbit tilt"),
    **dict.fromkeys(("eye_x", "eye_y", "eye_z"), QT_TRANSLATE_NOOP("Find", "vectors position")),
    **dict.fromkeys(
        ("target_x", "target_y", "target_z"), QT_TRANSLATE_NOOP("Find", "vectors look at")
    ),
    **dict.fromkeys(("up_x", "up_y", "up_z"), QT_TRANSLATE_NOOP("Find", "vectors view-up VUP")),
    **dict.fromkeys(("width", "height"), QT_TRANSLATE_NOOP("Find", "image size resolution pixels")),
    "aspect": QT_TRANSLATE_NOOP("Find", "image size ratio proportions"),
    "depth": QT_TRANSLATE_NOOP("Find", "depth range NDC z buffer OpenGL Direct3D reversed"),
    "animation": QT_TRANSLATE_NOOP("Find", "animation play walk turn"),
}  # fmt: skip
"""Other names of each control."""


class ControlTexts(NamedTuple):
    """The texts of a control: its names in the window's language and the model's, and its tip."""

    names: str
    tip: str


def known(key: str, names: Iterable[str], tip: str) -> ControlTexts:
    """Return the texts of the control with this key, other names included."""
    also = QCoreApplication.translate("Find", ALSO[key]) if key in ALSO else ""
    return ControlTexts(" ".join((*names, key, also)), tip)


def find(text: str, parts: Mapping[QWidget, ControlTexts]) -> set[QWidget]:
    """Return the controls whose names have all words, or else whose names and tips have them."""
    asked = _words(text)
    if not asked:
        return set()
    named = {part for part, told in parts.items() if _has(told.names, asked)}
    return named or {part for part, told in parts.items() if _has(" ".join(told), asked)}


def _words(text: str) -> list[str]:
    return re.findall(r"[^\W_]+", text.casefold())


def _has(text: str, asked: Iterable[str]) -> bool:
    words = _words(text)
    return all(
        part in words or (len(part) > 1 and any(word.startswith(part) for word in words))
        for part in asked
    )


class SearchBox(QLineEdit):
    """The search box: Enter or ↓ goes to the first result, Esc clears it."""

    taken = Signal()
    """The user wants to go to the first result."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setPlaceholderText(self.tr("Find a control"))
        self.setAccessibleName(self.tr("Find a control"))
        tip = self.tr("Shows the controls with this name, also folded ones; Enter goes to the"
                      " first, Esc shows all again (Ctrl+F)")  # fmt: skip
        set_tip(self, tip)
        self.setAccessibleDescription(tip)
        self.setClearButtonEnabled(True)

    def event(self, event: QEvent) -> bool:
        is_key = isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape
        if is_key and event.type() == QEvent.Type.ShortcutOverride and self.text():
            event.accept()  # not a shortcut of the window
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, keys = event.key(), Qt.Key
        if key == keys.Key_Escape and self.text():
            self.clear()
        elif key in (keys.Key_Return, keys.Key_Enter, keys.Key_Down) and self.text():
            self.taken.emit()
        else:
            super().keyPressEvent(event)
