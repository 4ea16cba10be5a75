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
from app.languages import with_comma
from app.model.refusal import Cancelled, Refusal
from widgets.parts.icons import Combo
from widgets.parts.labels import WarningLabel
from widgets.parts.layouts import dialog_buttons, in_column, in_row
from widgets.parts.messages import sentence
from widgets.parts.number_text import parse_number
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.progress import ReportProgress, progress
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
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
        self.setWindowTitle(WORDS["dialog"][0])
        self._shown, self._draw, self._unit = shown, draw, "px"
        self._boxes = {name: QCheckBox(titles[name]) for name in PANES}
        for box in self._boxes.values():
            box.setChecked(True)
            box.toggled.connect(self._panes_changed)
        first = {"width": "1800", "height": "600", "text": ""}
        self._fields = {name: self._field(name, text) for name, text in first.items()}
        self._form, self._combos = QFormLayout(), dict[str, Combo]()
        self._choose("ending", {ending[1:].upper(): ending[1:] for ending in ENDINGS})
        self._form.addRow(WORDS.say("panes"), in_row(*self._boxes.values()))
        self._choose("column", {"row": False, "column": True})
        tip, units = WORDS.say("unit", DPI), ("px", "mm", "cm", "in")
        self._combos["unit"] = Combo("", tip, zip(units, units, strict=True))
        width, height = self._sides
        size = in_row(width, PlainLabel("×"), height, self._combos["unit"])
        self._form.addRow(WORDS.say("size"), size)
        self._form.addRow(WORDS.say("letters"), self._fields["text"])
        self._choose("palette")
        self._choose("hidden")
        self._choose("scale", {f"{factor} ×": float(factor) for factor in (1, 2, 3, 4)})
        self._choose("transparent", {"filled": False, "transparent": True})
        for combo in self._combos.values():
            combo.currentIndexChanged.connect(self._check)
        self._combos["column"].currentIndexChanged.connect(self._panes_changed)
        self._combos["unit"].currentIndexChanged.connect(self._unit_changed)
        self._crop = WORDS.check("crop", self._check)
        self._problem = WarningLabel()
        self._preview = PlainLabel(wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter)
        self._preview.setAccessibleName(WORDS.say("preview"))
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

    def _field(self, name: str, text: str) -> QLineEdit:
        field = QLineEdit(text)
        said, *tip = WORDS[name]
        field.setAccessibleName(said)
        set_tip(field, tip[0].format(DPI) if tip else said)
        field.textChanged.connect(self._check)
        return field

    def _choose(self, name: str, values: Mapping[str, object] | None = None) -> None:
        """Add a row with a choice; `values` are by their texts if those are not on the page."""
        label, tip, *_ = WORDS[name]
        options = [(text, (values or {}).get(key, key)) for key, text in WORDS.choices(name)]
        combo = self._combos[name] = Combo("", tip, options or (values or {}).items())
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
        number = _whole if self._unit == "px" else partial(parse_number, WORDS.say("size"))
        width, height = (number(field.text()) for field in self._sides)
        text_pt = parse_number(WORDS.say("field"), text.text()) if text.isModified() else None
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
                digits = 0 if self._unit == "px" else 2
                field.setText(with_comma(f"{round(side / PX_PER[self._unit], digits):g}"))
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
            return WORDS.say("no-pane")
        try:
            figure = self.figure()
        except Refusal as error:
            return sentence(error)
        except ValueError:
            return WORDS.say("whole")
        if figure.text_pt is None:
            text = self._fields["text"]
            with QSignalBlocker(text):
                text.setText(with_comma(f"{figure.em_pt:.2g}"))
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
            with progress(self, WORDS.say("drawing")) as tell:
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
