"""The dialog that asks what a picture shows, how large, in which colours, and as which file."""

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import QSignalBlocker, QSize, Qt, QTimer
from PySide6.QtGui import QPixmap, QShowEvent
from PySide6.QtWidgets import QCheckBox, QDialog, QDialogButtonBox, QFormLayout, QLineEdit, QWidget

from app.document.lengths import DPI, PX_PER, Size
from app.document.view import PANES
from app.drawings.figure import ENDINGS, Figure
from app.model.refusal import Cancelled, Refusal
from widgets.parts.icons import Combo
from widgets.parts.labels import WarningLabel
from widgets.parts.layouts import dialog_buttons, in_column, in_row
from widgets.parts.messages import sentence
from widgets.parts.number_text import parse_number
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.progress import ReportProgress, progress

_PREVIEW_EM, _WIDER_EM = (17.0, 13.0), 14.0
_PAUSE_MS = 300  # after the last change, before the preview is drawn


class ExportDialog(QDialog):
    """Asks how the figure of the window is drawn, and for the ending of its file.

    `draw` returns the preview of a figure, at most as large as a size in pixels; a `Refusal` if
    there is none. `kept` is the last choice, as the property returned it.
    """

    def __init__(
        self,
        titles: dict[str, str],
        shown: Figure,
        parent: QWidget | None = None,
        draw: Callable[[Figure, QSize, ReportProgress], QPixmap] | None = None,
        kept: Mapping[str, Any] | None = None,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Export a picture"))
        self._shown, self._draw, self._unit = shown, draw, "px"
        self._boxes = {name: QCheckBox(titles[name]) for name in PANES}
        for box in self._boxes.values():
            box.setChecked(True)
            box.toggled.connect(self._panes_changed)
        tip = self.tr(
            "Height of the letters in points, 72 to an inch; at scale 1 an inch has {0} pixels"
        )
        self._fields = {
            "width": self._field("1800", self.tr("Width of the picture")),
            "height": self._field("600", self.tr("Height of the picture")),
            "text": self._field("", self.tr("Height of the letters in points"), tip.format(DPI)),
        }
        self._form, self._combos = QFormLayout(), dict[str, Combo]()
        tip = self.tr(
            "The file's format; SVG, PDF and TEX (TikZ) have shapes and text, no pixels."
            " Moving pictures and many at once: the command “export”"
        )
        formats = {ending[1:].upper(): ending[1:] for ending in ENDINGS}
        self._choose("ending", self.tr("&Format"), tip, formats)
        self._form.addRow(self.tr("Panes"), in_row(*self._boxes.values()))
        tip = self.tr("Whether the panes stand beside or below each other")
        is_column = {self.tr("in a row"): False, self.tr("in a column"): True}
        self._choose("column", self.tr("&Arranged"), tip, is_column)
        tip = self.tr("Unit of the size; a picture has {0} pixels an inch").format(DPI)
        self._choose("unit", "", tip, {unit: unit for unit in ("px", "mm", "cm", "in")})
        width, height = self._sides
        size = in_row(width, PlainLabel("×"), height, self._combos["unit"])
        self._form.addRow(self.tr("Size"), size)
        self._form.addRow(self.tr("&Letters (pt)"), self._fields["text"])
        tip = self.tr("In print, faces and lines that differ in colour differ in grey, too")
        palettes = {
            self.tr("as on the screen"): "screen",
            self.tr("for print"): "print",
            self.tr("dark"): "dark",
            self.tr("most contrast"): "contrast",
        }
        self._choose("palette", self.tr("C&olours"), tip, palettes)
        tip = self.tr("What becomes of lines behind faces, in SVG, PDF and TEX")
        lines = {self.tr("left out"): "none", self.tr("dashed"): "dashed", self.tr("grey"): "grey"}
        self._choose("hidden", self.tr("&Hidden lines"), tip, lines)
        tip = self.tr("Draws the same PNG with more pixels; text and lines scale with it")
        factors = {f"{factor} ×": float(factor) for factor in (1, 2, 3, 4)}
        self._choose("scale", self.tr("Scal&e"), tip, factors)
        tip = self.tr("What is behind the picture")
        is_transparent = {self.tr("filled"): False, self.tr("transparent"): True}
        self._choose("transparent", self.tr("&Background"), tip, is_transparent)
        self._combos["column"].currentIndexChanged.connect(self._panes_changed)
        self._combos["unit"].currentIndexChanged.connect(self._unit_changed)
        self._crop = QCheckBox(self.tr("C&rop to the content"))
        set_tip(self._crop, self.tr("Leaves a margin of 2 mm around what is drawn"))
        self._crop.toggled.connect(self._check)
        self._problem = WarningLabel()
        self._preview = PlainLabel(wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter)
        self._preview.setAccessibleName(self.tr("Preview"))
        em = self.fontMetrics().height()
        self._preview.setMinimumSize(*(round(side * em) for side in _PREVIEW_EM))
        self._timer = QTimer(self, singleShot=True, interval=_PAUSE_MS)
        self._timer.timeout.connect(self.show_preview)
        self._buttons = dialog_buttons(self, QDialogButtonBox.StandardButton.Save)
        self._form.addRow("", self._crop)
        in_column(in_row(self._form, (self._preview, 1)), self._problem, self._buttons, on=self)
        self._take(kept or {})
        self._check()
        hint, room = self.sizeHint(), self.screen().availableSize()
        self.resize(min(hint.width() + round(_WIDER_EM * em), room.width() - 2 * em), hint.height())

    def _field(self, text: str, name: str, tip: str = "") -> QLineEdit:
        field = QLineEdit(text)
        field.setAccessibleName(name)
        set_tip(field, tip or name)
        field.textChanged.connect(self._check)
        return field

    def _choose(self, name: str, label: str, tip: str, values: Mapping[str, object]) -> None:
        """Add a choice, in a row of its own if it has a label."""
        combo = self._combos[name] = Combo("", tip, values.items())
        combo.currentIndexChanged.connect(self._check)
        if label:
            self._form.addRow(label, combo)

    @property
    def _panes(self) -> tuple[str, ...]:
        return tuple(name for name, box in self._boxes.items() if box.isChecked())

    @property
    def _sides(self) -> tuple[QLineEdit, QLineEdit]:
        return self._fields["width"], self._fields["height"]

    @property
    def _chosen(self) -> dict[str, Any]:
        chosen = {name: combo.currentData() for name, combo in self._combos.items()}
        return chosen | {"panes": self._panes, "crop": self._crop.isChecked()}

    @property
    def kept(self) -> dict[str, Any]:
        """The choice with which the next dialog begins."""
        return self._chosen | {
            name: field.text() if field.isModified() else "" for name, field in self._fields.items()
        }

    def _take(self, kept: Mapping[str, Any]) -> None:
        """Show a kept choice, of which any part may be impossible now."""
        for name, combo in self._combos.items():
            known = [combo.itemData(place) for place in range(combo.count())]
            combo.setCurrentIndex(known.index(kept[name]) if kept.get(name) in known else 0)
        panes = kept.get("panes")
        if isinstance(panes, (list, tuple)) and any(name in panes for name in PANES):
            for name, box in self._boxes.items():
                box.setChecked(name in panes)
        self._crop.setChecked(kept.get("crop") is True)
        for name, field in self._fields.items():
            text = kept.get(name)
            if isinstance(text, str) and 0 < len(text) < 20:
                with QSignalBlocker(field):
                    field.setText(text)
                field.setModified(True)

    @property
    def ending(self) -> str:
        """The ending of the chosen format, without its dot."""
        return str(self._combos["ending"].currentData())

    def figure(self) -> Figure:
        """Return the figure as it is chosen; a `Refusal` if it is impossible."""
        chosen, text = self._chosen, self._fields["text"]
        del chosen["unit"]
        chosen |= {"hidden": "none"} if chosen.pop("ending") == "png" else {"scale": 1.0}
        number = _whole if self._unit == "px" else partial(parse_number, self.tr("Size"))
        width, height = (number(field.text()) for field in self._sides)
        text_pt = parse_number(self.tr("Letters"), text.text()) if text.isModified() else None
        size = Size(width, height, self._unit)
        return replace(self._shown, **chosen, size=size, text_pt=text_pt)

    def _panes_changed(self) -> None:
        width, height = 600 * max(1, len(self._panes)), 600
        if self._combos["column"].currentData():
            width, height = height, width
        if self._panes == ("image",):
            width, height = self._shown.document.projection.image_size
        if not any(field.isModified() for field in self._sides):  # a typed size stays
            self._show_size(float(width), float(height))
        self._check()

    def _unit_changed(self) -> None:
        """Write the same size in another unit."""
        former, self._unit = self._unit, str(self._combos["unit"].currentData())
        try:
            sides = [float(each.text().replace(",", ".")) for each in self._sides]
        except ValueError:
            sides = []
        if sides:
            self._show_size(*(side * PX_PER[former] for side in sides))
        self._check()

    def _show_size(self, width_px: float, height_px: float) -> None:
        for field, side in zip(self._sides, (width_px, height_px), strict=True):
            was_modified = field.isModified()
            with QSignalBlocker(field):
                field.setText(
                    f"{round(side / PX_PER[self._unit], 0 if self._unit == 'px' else 2):g}"
                )
            field.setModified(was_modified)

    def _check(self) -> None:
        has_pixels = self.ending == "png"
        self._combos["scale"].setEnabled(has_pixels)
        self._combos["hidden"].setEnabled(not has_pixels)
        problem = self._find_problem()
        self._problem.setText(problem)
        self._buttons.button(QDialogButtonBox.StandardButton.Save).setEnabled(not problem)
        if self.isVisible():
            self._timer.start()

    def _find_problem(self) -> str:
        """Say why this figure is impossible; otherwise show its default text size."""
        if not self._panes:
            return self.tr("Choose at least one pane.")
        try:
            figure = self.figure()
        except Refusal as error:
            return sentence(error)
        except ValueError:
            return self.tr("Width and height must be whole numbers.")
        if figure.text_pt is None:
            text = self._fields["text"]
            with QSignalBlocker(text):
                text.setText(f"{figure.em_pt:.2g}")
        return ""

    # -- preview

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._timer.start()

    def show_preview(self) -> None:
        if self._draw is None or self._find_problem():
            return
        room = self._preview.size() * self.devicePixelRatioF()
        try:
            with progress(self, self.tr("Drawing the preview")) as tell:
                picture = self._draw(self.figure(), room, tell)
        except Cancelled:
            return
        except Refusal as error:
            self._preview.setText(sentence(error))
            return
        picture.setDevicePixelRatio(self.devicePixelRatioF())
        self._preview.setPixmap(picture)


def _whole(text: str) -> int:
    """Parse a whole number in plain digits, unlike Python's 1_800, or raise ValueError."""
    if not re.fullmatch(r"\s*[-+]?[0-9]+\s*", text):
        raise ValueError(text)
    return int(text)
