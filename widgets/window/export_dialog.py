"""The dialog that asks for a picture's panes, size, scale and background."""

from __future__ import annotations

import re
from typing import NamedTuple

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLineEdit,
    QWidget,
)

from app.document.lengths import DPI
from app.document.view import PANES
from app.drawings.figures import checked_size, checked_text
from app.model.refusal import Refusal
from widgets.parts.combo import Combo
from widgets.parts.icons import WarningLabel
from widgets.parts.layouts import in_column, in_row
from widgets.parts.messages import sentence
from widgets.parts.number_text import parse_number
from widgets.parts.plain import Label, set_tip


class ExportChoice(NamedTuple):
    """The user's choice; the picture has ``size * scale`` pixels."""

    panes: tuple[str, ...]
    size: tuple[int, int]
    scale: float
    transparent: bool
    text_pt: float | None = None
    """None for letters of the usual size."""


class ExportDialog(QDialog):
    """Asks for an `ExportChoice`.

    Parameters
    ----------
    titles : dict
        Translated pane titles by name.
    image_size : (int, int)
        Size of the model's image, the default size of a picture of the image pane alone.
    """

    def __init__(
        self, titles: dict[str, str], image_size: tuple[int, int], parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Export a picture"))
        self._image_size = image_size
        self._boxes = {name: QCheckBox(titles[name]) for name in PANES}
        for box in self._boxes.values():
            box.setChecked(True)
            box.toggled.connect(self._panes_changed)
        letters, tip = (
            self.tr("Height of the letters in points"),
            self.tr(
                "Height of the letters in points, 72 to an inch; at scale 1 an inch has {0} pixels"
            ),
        )
        self._width = self._field("1800", self.tr("Width in pixels"))
        self._height = self._field("600", self.tr("Height in pixels"))
        self._text = self._field("", letters, tip.format(DPI))
        self._scale = Combo()
        set_tip(
            self._scale,
            self.tr("Draws the same figure with more pixels; text and lines scale with it"),
        )
        for factor in (1, 2, 3, 4):
            self._scale.addItem(f"{factor} ×", float(factor))
        self._scale.currentIndexChanged.connect(self._check)
        self._background = Combo()
        self._background.addItem(self.tr("white"), False)
        self._background.addItem(self.tr("transparent"), True)
        self._problem = WarningLabel()
        self._buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Save | QDialogButtonBox.StandardButton.Cancel
        )
        self._buttons.accepted.connect(self.accept)
        self._buttons.rejected.connect(self.reject)
        form = QFormLayout()
        size = in_row(self._width, Label("×"), self._height, Label(self.tr("px")))
        form.addRow(self.tr("Panes"), in_row(*self._boxes.values()))
        form.addRow(self.tr("Size"), size)
        form.addRow(self.tr("Letters (pt)"), self._text)
        form.addRow(self.tr("Scale"), self._scale)
        form.addRow(self.tr("Background"), self._background)
        in_column(form, self._problem, self._buttons, on=self)
        self._check()

    def _field(self, text: str, name: str, tip: str = "") -> QLineEdit:
        field = QLineEdit(text)
        field.setAccessibleName(name)
        set_tip(field, tip or name)
        field.textChanged.connect(self._check)
        return field

    @property
    def _panes(self) -> tuple[str, ...]:
        return tuple(name for name, box in self._boxes.items() if box.isChecked())

    def choice(self) -> ExportChoice:
        """Return the current choice; it is valid once the dialog is accepted."""
        text = self._text
        return ExportChoice(
            self._panes,
            (_whole(self._width.text()), _whole(self._height.text())),
            float(self._scale.currentData()),
            bool(self._background.currentData()),
            parse_number(self.tr("Letters"), text.text()) if text.isModified() else None,
        )

    def _panes_changed(self) -> None:
        width, height = 600 * max(1, len(self._panes)), 600
        if self._panes == ("image",):
            width, height = self._image_size
        if not (self._width.isModified() or self._height.isModified()):  # a typed size stays
            self._width.setText(str(width))
            self._height.setText(str(height))
        self._check()

    def _check(self) -> None:
        problem = self._find_problem()
        self._problem.setText(problem)
        self._buttons.button(QDialogButtonBox.StandardButton.Save).setEnabled(not problem)

    def _find_problem(self) -> str:
        """Say why this figure is impossible; otherwise show its default text size."""
        if not self._panes:
            return self.tr("Choose at least one pane.")
        try:
            choice = self.choice()
            figure = self._image_size, choice.panes, choice.size
            checked_size(*figure, choice.scale)
            text_pt = checked_text(*figure, choice.text_pt)
        except Refusal as error:
            return sentence(error)
        except ValueError:
            return self.tr("Width and height must be whole numbers.")
        if choice.text_pt is None:
            with QSignalBlocker(self._text):
                self._text.setText(f"{text_pt:.2g}")
        return ""


def _whole(text: str) -> int:
    """Parse a whole number, without Python's own forms such as 1_800 and other scripts' digits.

    Raises
    ------
    ValueError
        If the text is not a whole number.
    """
    if not re.fullmatch(r"\s*[-+]?[0-9]+\s*", text):
        raise ValueError(text)
    return int(text)
