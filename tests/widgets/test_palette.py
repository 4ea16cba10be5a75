"""The style of widgets: frames visible in both themes, arrows and signs as large as letters."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QRect, QSize
from PySide6.QtGui import QFont, QPalette
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QLineEdit,
    QListWidget,
    QMenu,
    QRadioButton,
    QTableWidget,
    QTableWidgetItem,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app.drawings.style import contrast
from tests.support.window import rgb_of
from widgets.parts import palette
from widgets.parts.gestures import HeldSlider
from widgets.parts.icons import Combo, icon
from widgets.parts.labels import WarningLabel
from widgets.parts.plain import PlainLabel
from widgets.window.main_window import MainWindow


@pytest.fixture
def dressed(qapp: QApplication) -> Iterator[Callable[..., None]]:
    def dress(*, dark: bool = False, screen_px: float = 0.0) -> None:
        palette.apply(qapp, dark=dark, screen_px=screen_px)

    yield dress
    dress()


def hexadecimal(colour: np.ndarray) -> str:
    return "#" + bytes(colour[:3].tolist()).hex()


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize("screen_px", [0.0, 2160.0])
def test_a_frame_is_seen_against_the_window(
    dressed: Callable[..., None], qtbot: QtBot, dark: bool, screen_px: float
) -> None:
    """3 : 1, as WCAG 2.1 has it for a control's edge (1.4.11)."""
    dressed(dark=dark, screen_px=screen_px)
    behind = QWidget()
    qtbot.addWidget(behind)
    field, combo, slider = QLineEdit("4", behind), Combo(), HeldSlider()
    choice, chosen, box, ticked = QRadioButton(), QRadioButton(), QCheckBox(), QCheckBox()
    chosen.setAutoExclusive(False)
    chosen.setChecked(True)
    ticked.setChecked(True)
    combo.addItem("oblique")
    for place, part in enumerate((field, combo, slider, choice, chosen, box, ticked)):
        part.setParent(behind)
        part.setGeometry(10, 10 + 100 * place, 300, 80)
    marks = QWidget(behind, objectName="stepMarks")
    marks.setGeometry(10, 710, 300, 80)
    mark = QToolButton(marks)
    mark.setGeometry(0, 0, 300, 80)
    mark.setProperty("practice", True)
    behind.resize(320, 800)
    behind.show()
    seen = rgb_of(behind.grab().toImage())
    window = hexadecimal(seen[2, 2])
    for part in (field, combo):
        left = seen[part.y() + 40, part.x() : part.x() + 8]
        assert max(contrast(hexadecimal(pixel), window) for pixel in left) >= 3.0
        assert contrast(hexadecimal(seen[part.y() + 40, part.x() - 3]), window) == 1.0
    wide = choice.fontMetrics().height()
    for pair in ((choice, chosen), (box, ticked)):
        rings = [seen[part.y() + 40, part.x() : part.x() + wide] for part in pair]
        for ring in rings:
            assert max(contrast(hexadecimal(pixel), window) for pixel in ring[: wide // 4]) >= 3.0
        changed = [contrast(*map(hexadecimal, both)) for both in zip(*rings, strict=True)]
        assert max(changed) >= 3.0, "what is chosen is seen"
    groove = seen[slider.y() + 40, slider.x() + 200]
    assert contrast(hexadecimal(groove), window) >= 3.0
    dashes = [contrast(hexadecimal(pixel), window) >= 3.0 for pixel in seen[marks.y(), 20:300]]
    assert 0.3 < np.mean(dashes) < 0.9, "of a step that is practice"


def chosen_in_combo(root: QWidget) -> tuple[QWidget, QRect]:
    combo = Combo()
    combo.setParent(root)
    combo.addItems(["Letter F", "Unit cube", "Row of posts"])
    combo.show()
    combo.showPopup()
    view = combo.view()
    view.setCurrentIndex(view.model().index(1, 0))
    return view.viewport(), view.visualRect(view.model().index(1, 0))


def chosen_in_menu(root: QWidget) -> tuple[QWidget, QRect]:
    menu = QMenu(root)
    action = menu.addAction("Unit cube")
    menu.popup(QPoint(20, 20))
    menu.setActiveAction(action)
    return menu, menu.actionGeometry(action)


def chosen_in_list(root: QWidget) -> tuple[QWidget, QRect]:
    choices = QListWidget(root)
    choices.addItems(["Letter F", "Unit cube"])
    choices.setCurrentRow(1)
    choices.show()
    return choices.viewport(), choices.visualItemRect(choices.item(1))


def chosen_in_table(root: QWidget) -> tuple[QWidget, QRect]:
    table = QTableWidget(2, 1, root)
    table.setItem(0, 0, cell := QTableWidgetItem("HIL"))
    large = QFont()
    large.setPixelSize(24)  # strokes wider than a pixel have the letters' own colour
    cell.setFont(large)
    table.resize(300, 120)
    table.selectRow(0)
    table.show()
    return table.viewport(), table.visualItemRect(cell)


def selected_in_field(root: QWidget) -> tuple[QWidget, QRect]:
    field = QLineEdit("HIL 30.25", root)
    field.show()
    field.selectAll()
    return field, field.rect().adjusted(6, 4, -70, -4)


def pressed(place: str) -> Callable[[QWidget], tuple[QWidget, QRect]]:
    def make(root: QWidget) -> tuple[QWidget, QRect]:
        holder = QWidget(root)
        holder.setObjectName(place)
        button = QToolButton(holder, text="Unit cube", checkable=True, checked=True)
        holder.show()
        return button, button.rect()

    return make


def named(name: str, make: Callable[[QWidget], QWidget]) -> Callable[..., tuple[QWidget, QRect]]:
    def made(root: QWidget) -> tuple[QWidget, QRect]:
        widget = make(root)
        widget.setObjectName(name)
        widget.setProperty("reached", True)
        widget.show()
        return widget, widget.rect()

    return made


CHOSEN: dict[str, Callable[[QWidget], tuple[QWidget, QRect]]] = {
    "combo box": chosen_in_combo, "menu": chosen_in_menu, "list": chosen_in_list,
    "table": chosen_in_table, "field": selected_in_field, "stages": pressed("stages"),
    "views": pressed("fixedViews"), "panels": pressed("drawerNames"), "steps": pressed("stepMarks"),
    "title reached": named("paneTitle", lambda root: PlainLabel("NDC cube", root)),
    "note": named("paneNote", lambda root: PlainLabel("1280 x 720", root)),
    "message": named("messageBar", lambda root: PlainLabel("A message", root)),
}  # fmt: skip


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize("name", CHOSEN)
def test_selected_text_can_be_read(
    dressed: Callable[..., None], qtbot: QtBot, name: str, dark: bool
) -> None:
    """4.5 : 1, as WCAG 2.1 has it for text (1.4.3)."""
    dressed(dark=dark)
    root = QWidget()
    qtbot.addWidget(root)
    root.resize(400, 300)
    root.show()
    qtbot.waitExposed(root)
    root.activateWindow()
    qtbot.waitActive(root)
    widget, place = CHOSEN[name](root)
    QApplication.processEvents()
    pixels = rgb_of(widget.grab(place).toImage()).reshape(-1, 3)
    colours, counts = np.unique(pixels, axis=0, return_counts=True)
    ground = hexadecimal(colours[counts.argmax()])
    assert max(contrast(hexadecimal(colour), ground) for colour in colours) >= 4.5
    for window in QApplication.topLevelWidgets():
        window.hide()


def test_the_arrow_of_a_combo_box_grows_with_the_letters(
    dressed: Callable[..., None], qtbot: QtBot
) -> None:
    combo = Combo()
    qtbot.addWidget(combo)
    combo.addItem("oblique")
    widths = []
    for screen_px in (0.0, 2160.0):
        dressed(screen_px=screen_px)
        combo.resize(combo.sizeHint())
        combo.show()
        height = combo.fontMetrics().height()
        right = rgb_of(combo.grab().toImage())[4:-4, -round(1.1 * height) : -4].astype(int)
        arrow = np.flatnonzero((right.sum(axis=2) < 400).any(axis=0))
        widths.append(float(np.ptp(arrow)) / height)
        advance = combo.fontMetrics().horizontalAdvance(combo.currentText())
        assert combo.width() >= advance + height
    assert min(widths) > 0.2 and max(widths) < 0.8
    assert widths[0] == pytest.approx(widths[1], abs=0.15)


def test_a_warning_has_its_sign_beside_its_text(dressed: Callable[..., None], qtbot: QtBot) -> None:
    """The sign is drawn, whatever the font; an ordinary text has none."""
    dressed()
    label = WarningLabel()
    qtbot.addWidget(label)
    label.resize(300, 20)
    label.show()
    side = label.fontMetrics().height()

    def inked() -> int:
        return int((rgb_of(label.grab().toImage())[:, :side].astype(int).sum(axis=2) < 400).sum())

    assert inked() == 0
    label.setText("near")
    assert label.text() == "near" and label.indent() > side and inked() > 20
    label.setText("")
    assert inked() == 0
    label.set_is_warning(False)
    label.setText("")
    assert label.indent() == 0


@pytest.mark.undrawn
def test_the_icon_of_present_has_the_colour_of_its_text(window: MainWindow) -> None:
    action = window.menus.present
    button = window.menus.tools.widgetForAction(action)
    assert isinstance(button, QToolButton)
    colours = []
    for shown, role in ((button.icon(), "HighlightedText"), (action.icon(), "ButtonText")):
        image = shown.pixmap(QSize(32, 32)).toImage()
        drawn = {image.pixelColor(x, y).name() for x in range(32) for y in range(32)
                 if image.pixelColor(x, y).alpha() == 255}  # fmt: skip
        assert drawn == {QApplication.palette().color(QPalette.ColorRole[role]).name()}
        colours += drawn
    assert colours[0] != colours[1]


def test_an_icon_without_room_paints_nothing(qapp: object, qtlog: Any) -> None:
    """Qt warns of a painter without an image."""
    assert icon("warning").pixmap(QSize(16, 16), 0.01).isNull()
    assert not qtlog.records
