"""Asks what a picture shall show, how large it is, and on which background."""

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

from app.document.view import PANES
from app.drawings.figures import DPI, checked_size, checked_text
from app.model.refusal import Refusal
from widgets.parts.combo import Combo
from widgets.parts.icons import WarningLabel
from widgets.parts.layouts import in_column, in_row
from widgets.parts.messages import sentence
from widgets.parts.number_text import parse_number
from widgets.parts.plain import Label, set_tip


class ExportChoice(NamedTuple):
    """What the user chose; the picture has ``size * scale`` pixels, and letters of these points."""

    panes: tuple[str, ...]
    size: tuple[int, int]
    scale: float
    transparent: bool
    text_pt: float | None = None


class ExportDialog(QDialog):
    """The choice of a figure's panes, size, scale and background.

    Parameters
    ----------
    titles : dict
        Translated pane titles by name.
    image_size : (int, int)
        Size of the model's image, the natural size of the image pane alone.
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
        self._width, self._height = QLineEdit("1800"), QLineEdit("600")
        for field, name in (
            (self._width, self.tr("Width in pixels")),
            (self._height, self.tr("Height in pixels")),
        ):
            field.setAccessibleName(name)
            set_tip(field, name)
            field.textChanged.connect(self._check)
        self._text = QLineEdit()
        self._text.setAccessibleName(self.tr("Height of the letters in points"))
        set_tip(
            self._text,
            self.tr(
                "Height of the letters in points: {0} pixels at scale 1 are an inch of 72"
            ).format(DPI),
        )
        self._text.textChanged.connect(self._check)
        self._scale = Combo()
        set_tip(
            self._scale,
            self.tr("Draws the same figure with more pixels: text and lines grow with it"),
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

    def choice(self) -> ExportChoice:
        """What is chosen now; valid once the dialog is accepted."""
        return ExportChoice(
            tuple(name for name in PANES if self._boxes[name].isChecked()),
            (_whole(self._width.text()), _whole(self._height.text())),
            float(self._scale.currentData()),
            bool(self._background.currentData()),
            parse_number(self.tr("Letters"), self._text.text())
            if self._text.isModified()
            else None,
        )

    def _panes_changed(self) -> None:
        chosen = [name for name in PANES if self._boxes[name].isChecked()]
        if chosen == ["image"]:
            width, height = self._image_size
        else:
            width, height = 600 * max(1, len(chosen)), 600
        if not (self._width.isModified() or self._height.isModified()):  # a typed size stays
            self._width.setText(str(width))
            self._height.setText(str(height))
        self._check()

    def _check(self) -> None:
        problem = ""
        if not any(box.isChecked() for box in self._boxes.values()):
            problem = self.tr("Choose at least one pane.")
        else:
            try:
                choice = self.choice()
            except Refusal as error:
                problem = sentence(error)
            except ValueError:
                problem = self.tr("Width and height must be whole numbers.")
            else:
                problem = self._refused(choice)
        self._problem.setText(problem)
        self._buttons.button(QDialogButtonBox.StandardButton.Save).setEnabled(not problem)

    def _refused(self, choice: ExportChoice) -> str:
        """Why there is no such figure, if there is none; else its letters are as large as usual."""
        figure = self._image_size, choice.panes, choice.size
        try:
            checked_size(*figure, choice.scale)
            checked_text(*figure, choice.text_pt)
        except Refusal as error:
            return sentence(error)
        if choice.text_pt is None:
            with QSignalBlocker(self._text):
                self._text.setText(f"{checked_text(*figure, None):.2g}")
        return ""


def _whole(text: str) -> int:
    """A whole number; not what only Python takes for one, such as 1_800 and digits of any script.

    Raises
    ------
    ValueError
        If it is none.
    """
    if not re.fullmatch(r"\s*[-+]?[0-9]+\s*", text):
        raise ValueError(text)
    return int(text)
