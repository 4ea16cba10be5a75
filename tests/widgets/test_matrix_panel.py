"""The matrices panel with real widgets: what it shows, marks, says and copies."""

import itertools
import json
import math
import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QColor, QContextMenuEvent, QFontMetricsF, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QMenu, QScrollArea, QToolButton
from pytestqt.qtbot import QtBot

from app.drawings.style import LIGHT
from app.lecture import notation
from app.lecture.conventions import in_convention
from app.lecture.copying import as_latex
from app.lecture.letters import LETTERS
from app.lecture.titles import stage_title
from app.lecture.typed_matrix import with_cell
from app.lecture.typesetting import pieces_of
from app.model.formula import ARROW
from app.model.formula_text import OVER, stacked_fraction
from app.model.projection import Camera, FreeMatrix, Frustum, Oblique, Perspective, Projection
from app.model.refusal import format_value
from app.picking.picking import Probe
from tests.support import controls as dock
from tests.support.commands import told_matrices
from tests.support.digits import all_digits_shown, plain
from tests.support.shown import show
from tests.support.window import activate, click, move_mouse, named, rgb_of, settle
from widgets.panels.matrix_panel import MatrixPanel
from widgets.panels.matrix_view import MatrixView, first_change, rich
from widgets.parts.messages import read_text
from widgets.parts.plain import subscripts
from widgets.parts.typeset import typeset
from widgets.window.main_window import MainWindow

OFF_AXIS = Projection(
    Camera((6.0, 5.0, 9.0), (0.5, 2.0, -0.25)), Frustum(-0.7, 0.9, -0.4, 0.65, 1.5, 40.0)
)

STOPS = (
    "world_from_object",
    "view_from_world",
    "canonical_perspective_from_view",
    "canonical_parallel_from_canonical_perspective",
    "depth_range_from_canonical_parallel",
    "image_from_ndc",
)
"""The matrices that lead to the stops of the stage strip."""


@pytest.fixture
def panel(display: Any, qtbot: QtBot) -> MatrixPanel:
    panel = MatrixPanel()
    qtbot.addWidget(panel)
    show(panel, OFF_AXIS)
    panel.resize(1350, 240)
    panel.show()
    qtbot.waitExposed(panel)
    return panel


def moved(projection: Projection, **fields: Any) -> Projection:
    return replace(projection, lens=replace(projection.lens, **fields))


def shown_after(panel: MatrixPanel, qtbot: QtBot, projection: Projection) -> None:
    show(panel, projection)
    shown_at_last(panel, qtbot, projection)


def shown_at_last(panel: MatrixPanel, qtbot: QtBot, projection: Projection) -> None:
    """Wait until the pending value is shown."""
    rows, running = panel.vectors.currentData() == "rows", panel.running.isChecked()
    matrices = notation.matrices(
        projection, panel.letters.currentData(), rows=rows, running=running
    )
    qtbot.waitUntil(lambda: panel.shown == matrices)


def title_of(panel: MatrixPanel, name: str) -> QLabel:
    """The label above a matrix."""
    return panel.views[name].parentWidget().findChild(QLabel, "paneTitle")


def speaks_of(panel: MatrixPanel, *names: str) -> bool:
    """Whether the explanation is about one of these matrices."""
    starts = tuple(f"{panel.views[name].accessibleName()}, row " for name in names)
    return bool(panel.explanation.text().startswith(starts))


def title(panel: MatrixPanel, name: str) -> str:
    """The text above a matrix."""
    return str(title_of(panel, name).text())


def fold(panel: MatrixPanel, name: str) -> QToolButton:
    """The button that unfolds a matrix's factors."""
    return panel.views[name].parentWidget().findChild(QToolButton)


def left_of(panel: MatrixPanel, name: str) -> int:
    """The left edge of a matrix in the visible part of the row, in px."""
    return panel.views[name].mapTo(panel.findChild(QScrollArea).viewport(), QPoint()).x()


def choose(box: Any, value: str) -> None:
    box.setCurrentIndex(box.findData(value))


def test_numbers_are_those_of_the_command(panel: MatrixPanel) -> None:
    told = json.loads(told_matrices(OFF_AXIS, "json"))
    assert [matrix.name for matrix in panel.shown] == list(told)
    words = told_matrices(OFF_AXIS, "text").split()
    for matrix in panel.shown:
        view = panel.views[matrix.name]
        for i in range(4):
            for j in range(4):
                value = told[matrix.name][i][j]
                assert plain(view.texts[i][j]) == f"{value:.4g}"
                assert f"{view.texts[i][j]}. " in panel.sentence(matrix, i, j)
                assert format_value(value) in words


def lit(view: MatrixView) -> set[tuple[int, int]]:
    """Row and column of the cells with a frame and a background in the accent's colour."""
    picture, found = rgb_of(view.grab().toImage()).astype(int), set()
    accent = np.array(QColor(LIGHT.accent).getRgb()[:3])
    ground = np.array(view.palette().window().color().getRgb()[:3])
    off = np.abs(picture - accent).sum(axis=2) / np.abs(ground - accent).sum()
    for i, j in itertools.product(range(4), range(4)):
        cell = view.cell_rect(i, j).toRect()
        # Above what is written; its frame may lie between two lines of pixels.
        above = off[cell.top() : cell.top() + 4, cell.left() + 4 : cell.right() - 4]
        if (above.min(axis=0) < 0.5).all():
            found.add((i, j))
    return found


def underlined_px(view: MatrixView, row: int, column: int) -> int:
    """The length of the longest horizontal line in a cell."""
    cell = view.cell_rect(row, column).toRect()
    dark = rgb_of(view.grab().toImage()).mean(axis=2) < 128
    lines = dark[cell.top() : cell.bottom(), cell.left() : cell.right()]
    runs = (list(run) for line in lines for is_dark, run in itertools.groupby(line) if is_dark)
    return max(map(len, runs), default=0)


def test_changed_cells_are_highlighted(panel: MatrixPanel, qtbot: QtBot) -> None:
    assert not lit(panel.views["clip_from_view"])
    shown_after(panel, qtbot, moved(OFF_AXIS, far=50.0))
    assert lit(panel.views["clip_from_view"]) == {(2, 2), (2, 3)}
    assert lit(panel.views["view_from_world"]) == set()
    assert lit(panel.views["canonical_perspective_from_view/scale"]) == {(0, 0), (1, 1), (2, 2)}
    assert lit(panel.views["canonical_perspective_from_view/shear"]) == set()


def test_a_drag_is_compared_with_its_start(panel: MatrixPanel, qtbot: QtBot) -> None:
    panel.begin_gesture()
    shown_after(panel, qtbot, moved(OFF_AXIS, left=-0.75))
    shown_after(panel, qtbot, moved(OFF_AXIS, left=-0.75, far=50.0))
    assert lit(panel.views["clip_from_view"]) == {(0, 0), (0, 2), (2, 2), (2, 3)}
    before, after = (read_text(-(far + 1.5) / (far - 1.5)) for far in (40.0, 50.0))
    mark = first_change(before, after)
    assert mark and before[:mark] == after[:mark]
    view = panel.views["clip_from_view"]
    of_others_px = QFontMetricsF(view.font()).horizontalAdvance(after[mark:])
    # Square ends make the line longer by up to two pixels each; a digit is wider than that.
    assert underlined_px(view, 2, 2) == pytest.approx(of_others_px + 2.0, abs=2.0)
    shown_after(panel, qtbot, OFF_AXIS)  # dragged back to where it began
    assert not lit(panel.views["clip_from_view"])
    panel.end_gesture()
    shown_after(panel, qtbot, moved(OFF_AXIS, far=50.0))
    assert lit(panel.views["clip_from_view"]) == {(2, 2), (2, 3)}


@pytest.mark.parametrize(
    ("before", "after", "first"),
    [
        ("1.25", "1.25", None), ("1.25", "1.27", 3), ("1.25", "1.2", 3), ("9.9", "10.1", 0),
        ("-1.5", "1.5", 0), ("1e-5", "1e-6", 0), ("2", "2.5", 1), ("0.5", "0.6", 2),
        ("2.5·10⁻⁵", "2.6·10⁻⁵", 2), ("2.5·10⁻⁵", "2.5·10⁻⁶", 0), ("10⁻⁵", "10⁻⁶", 0),
        ("1000", "10⁻⁶", 0),
    ],
)  # fmt: skip
def test_the_first_digit_that_differs(before: str, after: str, first: int | None) -> None:
    assert first_change(before, after) == first


def test_four_digits_are_shown_all_with_the_switch_and_all_are_copied(
    panel: MatrixPanel, qtbot: QtBot
) -> None:
    told = json.loads(told_matrices(OFF_AXIS, "json"))
    view = panel.views["view_from_world"]

    def copied() -> str:
        QGuiApplication.clipboard().clear()
        qtbot.keyClick(view, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
        return QGuiApplication.clipboard().text()

    few, width, whole = view.texts, view.width(), copied()
    number = format_value(told["view_from_world"][0][0])
    assert number in whole and len(number) > 12
    qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=view.cell_rect(0, 0).center().toPoint())
    assert number not in panel.explanation.text() and few[0][0] in panel.explanation.text()
    with all_digits_shown():
        for matrix in panel.shown:
            exact = [[format_value(cell) for cell in row] for row in told[matrix.name]]
            assert panel.views[matrix.name].texts == exact
        assert number in panel.explanation.text() and copied() == whole
        assert view.width() > 1.5 * width
    assert view.texts == few and view.width() == width and copied() == whole
    assert number not in panel.explanation.text()


def test_a_cell_that_is_being_typed_stays_open_while_digits_are_switched(
    panel: MatrixPanel, qtbot: QtBot, edits: list[Projection]
) -> None:
    view = panel.views["clip_from_view"]
    field = double_click(panel, qtbot, "clip_from_view", 0, 2)
    field.selectAll()
    qtbot.keyClicks(field, "0.25")
    with all_digits_shown():
        assert view.field is field and field.text() == "0.25"
        assert field.geometry().contains(view.cell_rect(0, 2).center().toPoint())
    assert field.geometry().contains(view.cell_rect(0, 2).center().toPoint())
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert edits[-1].direct_stages[0].matrix[0, 2] == 0.25


def test_every_matrix_and_factor_stands_in_brackets_as_high_as_its_rows(panel: MatrixPanel) -> None:
    choose(panel.cells, "formulas")
    for matrix in panel.shown:
        if matrix.factors:
            fold(panel, matrix.name).click()
    settle()
    assert len(panel.views) > 12
    for name, view in panel.views.items():
        dark = rgb_of(view.grab().toImage()).mean(axis=2) < 128
        first, last = view.cell_rect(0, 0).toRect(), view.cell_rect(3, 3).toRect()
        for beside in (
            range(first.left() - 4, first.left()),
            range(last.right(), last.right() + 5),
        ):
            drawn = max(dark[first.top() : last.bottom(), x].mean() for x in beside)
            assert drawn > 0.95, name


def test_formulas_in_the_letters_of_a_lecture(panel: MatrixPanel) -> None:
    choose(panel.cells, "formulas")
    scale, shear = (stacked_fraction(above, "r − l") for above in ("2n", "r + l"))
    assert panel.views["clip_from_view"].texts[0] == [scale, "0", shear, "0"]
    choose(panel.letters, "000")
    texts = panel.views["clip_from_view"].texts
    assert texts[0][0] == stacked_fraction("2z_min", "x_max − x_min")
    choose(panel.letters, "002")
    assert panel.views["clip_from_view"].texts[3] == ["0", "0", "1", "0"]
    assert "lecture 002" in notes(panel, "clip_from_view")
    choose(panel.letters, "001")
    assert panel.views["view_from_world"].texts[2] == ["w_x", "w_y", "w_z", f"−w{ARROW}·P{ARROW}"]


def test_a_cell_says_what_it_does(panel: MatrixPanel) -> None:
    by_name = {matrix.name: matrix for matrix in panel.shown}
    for name, row, column, words in (
        ("view_from_world", 0, 1, "the camera's axis u"),
        ("view_from_world", 0, 3, "It shifts x by"),
        ("clip_from_view", 0, 0, "It scales x by"),
        ("clip_from_view", 0, 2, "times z to x: a shear"),
        ("clip_from_view", 3, 2, "It makes w, the divisor, the distance −z"),
        ("clip_from_view", 2, 3, "before the divide"),
        ("clip_from_view", 1, 0, "y does not depend on x."),
        ("image_from_ndc", 1, 1, "reverses its direction"),
        ("clip_from_depth_range", 3, 3, "It scales w, the divisor, by 40."),
        ("view_from_world", 3, 3, "It leaves w unchanged."),
        ("clip_from_view", 3, 3, "w does not depend on the incoming w."),
        ("clip_from_world", 3, 2, "times z to w, the divisor"),
        ("clip_from_world", 3, 3, " to w, the divisor"),
        ("clip_from_view", 2, 2, "It depends on: Far, Near, Depth range."),
        ("clip_from_view", 3, 2, "It depends on no control."),
    ):
        assert words in panel.sentence(by_name[name], row, column)


def test_pointing_with_mouse_and_keys(panel: MatrixPanel, qtbot: QtBot) -> None:
    view = panel.views["view_from_world"]
    with qtbot.waitSignal(view.pointed) as hover:
        move_mouse(view, view.cell_rect(1, 3).center(), Qt.MouseButton.NoButton)
    assert hover.args[0].startswith(f"view ← world, row 2, column 4: −v{ARROW}·e{ARROW} = ")
    assert panel.explanation.text() == rich(hover.args[0])
    assert "column 4: −<b>v</b>·<b>e</b> = " in panel.explanation.text()
    qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=view.cell_rect(0, 0).center().toPoint())
    qtbot.keyClick(view, Qt.Key.Key_Right)
    qtbot.keyClick(view, Qt.Key.Key_Down)
    qtbot.keyClick(view, Qt.Key.Key_Down)
    assert "row 3, column 2" in panel.explanation.text()
    assert rich(view.accessibleDescription()) == panel.explanation.text()
    assert view.accessibleName() == "view ← world"


def test_copies_reach_the_clipboard(panel: MatrixPanel, qtbot: QtBot) -> None:
    clipboard = QGuiApplication.clipboard()
    view = panel.views["clip_from_view"]
    qtbot.keyClick(view, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    assert clipboard.text().startswith("clip_from_view = ")
    place = QPoint(5, 5)
    view.contextMenuEvent(QContextMenuEvent(QContextMenuEvent.Reason.Mouse, place, place))
    (menu,) = view.findChildren(QMenu)
    actions = menu.actions()
    assert [action.text() for action in actions] == [
        "Copy as text", "Copy for NumPy (numbers)", "Copy for LaTeX (needs amsmath)", "Paste",
    ]  # fmt: skip
    actions[1].trigger()
    numbers: dict[str, Any] = {"np": np}
    exec(clipboard.text(), numbers)
    assert (
        numbers["clip_from_view"].tolist()
        == json.loads(told_matrices(OFF_AXIS, "json"))["clip_from_view"]
    )
    actions[2].trigger()
    assert r"\begin{pmatrix}" in clipboard.text()
    menu.close()
    panel.copy.menu().actions()[1].trigger()
    exec(clipboard.text(), numbers)
    for name, matrix in json.loads(told_matrices(OFF_AXIS, "json")).items():
        assert numbers[name].tolist() == matrix


def test_factors_unfold_and_stay_so(panel: MatrixPanel, qtbot: QtBot) -> None:
    view = panel.views["view_from_world/rotation"]
    assert not view.isVisible()
    qtbot.mouseClick(fold(panel, "view_from_world"), Qt.MouseButton.LeftButton)
    assert view.isVisible()
    shown_after(panel, qtbot, OFF_AXIS.with_lens("oblique"))
    qtbot.waitUntil(panel.views["view_from_world/rotation"].isVisible)
    assert not panel.views["canonical_parallel_from_view/shear"].isVisible()


def test_notes_are_shown(panel: MatrixPanel, qtbot: QtBot) -> None:
    for lens in (Perspective(45.0, 1.0, math.inf), Oblique()):
        projection = replace(OFF_AXIS, lens=lens)
        shown_after(panel, qtbot, projection)
        shown = {notes(panel, matrix.name) for matrix in panel.shown}
        notes_of = {subscripts(stage.note) for stage in projection.stages if stage.note}
        assert notes_of <= {each.replace("<br>", " ") for each in shown}


def test_the_window_shows_the_current_value_when_the_panel_opens(
    window: MainWindow, qtbot: QtBot
) -> None:
    panel = window.matrices
    assert not panel.shown
    window.panels.open(panel)
    qtbot.waitUntil(panel.isVisible)
    QApplication.processEvents()
    bar = panel.findChild(QScrollArea).verticalScrollBar()
    assert bar.maximum() == 0, "it is as high as its matrices"
    projection = window.store.document.projection
    by_name = {matrix.name: matrix for matrix in panel.shown}
    assert by_name["clip_from_view"].values[1][1] == projection.direct_stages[0].matrix[1, 1]
    start = projection
    window.controls.gesture_started.emit()
    for near in (1.25, 1.5):
        window.store.set_projection(moved(start, near=near))
    shown_at_last(panel, qtbot, moved(start, near=1.5))
    assert lit(panel.views["clip_from_view"]) == {(2, 2), (2, 3)}
    window.controls.gesture_finished.emit()
    assert all(isinstance(view, MatrixView) for view in panel.views.values())


# --------------------------------------------------------------------------- typing


@pytest.fixture
def edits(panel: MatrixPanel) -> list[Projection]:
    made: list[Projection] = []
    panel.edited.connect(made.append)
    return made


def double_click(panel: MatrixPanel, qtbot: QtBot, name: str, row: int, column: int) -> Any:
    view = panel.views[name]
    place = view.cell_rect(row, column).center().toPoint()
    qtbot.mouseDClick(view, Qt.MouseButton.LeftButton, pos=place)
    # Or Qt holds the button to be down, also in the tests after this one, where nothing is hovered.
    qtbot.mouseRelease(view, Qt.MouseButton.LeftButton, pos=place)
    return view.field


def type_cell(
    panel: MatrixPanel, qtbot: QtBot, name: str, row: int, column: int, text: str
) -> None:
    field = double_click(panel, qtbot, name, row, column)
    field.selectAll()
    qtbot.keyClicks(field, text)
    qtbot.keyClick(field, Qt.Key.Key_Return)


def test_a_cell_is_typed_and_goes_out_once(
    panel: MatrixPanel, qtbot: QtBot, edits: list[Projection]
) -> None:
    field = double_click(panel, qtbot, "clip_from_view", 0, 2)
    assert field.text() == format_value(panel.shown[-3].values[0][2])  # with all its digits
    assert field.text() != panel.views["clip_from_view"].texts[0][2]
    assert field.accessibleName() == "clip ← view, row 1, column 3"
    type_cell(panel, qtbot, "clip_from_view", 0, 2, "1/4")
    (edit,) = edits
    assert isinstance(edit.lens, Frustum)
    assert edit.direct_stages[0].matrix[0, 2] == 0.25
    assert panel.views["clip_from_view"].texts[0][2] == "0.25"
    assert panel.views["clip_from_view"].field is None
    assert (0, 2) in lit(panel.views["clip_from_view"])


def test_the_quotient_of_a_typed_fraction_is_reported(
    panel: MatrixPanel, qtbot: QtBot, edits: list[Projection]
) -> None:
    told: list[str] = []
    panel.adjusted.connect(told.append)
    field = double_click(panel, qtbot, "clip_from_view", 0, 2)
    assert "1/3" in field.toolTip() and field.placeholderText() == "1/3"
    assert "a fraction such as 1/3" in panel.explanation.text()
    type_cell(panel, qtbot, "clip_from_view", 0, 2, "0.25")
    assert told == []
    type_cell(panel, qtbot, "clip_from_view", 0, 2, " -1/3")
    assert told == ["-1/3 is taken as -0.3333333333333333, its quotient to all digits of float64."]
    assert edits[-1].direct_stages[0].matrix[0, 2] == -1 / 3
    type_cell(panel, qtbot, "clip_from_view", 0, 2, "1/0")
    assert len(told) == 1 and "must be a number" in panel.explanation.text()


@pytest.mark.undrawn
def test_typing_ends_when_the_matrix_disappears(window: MainWindow, qtbot: QtBot) -> None:
    start, panel = window.store.document, window.matrices
    window.panels.open(panel)
    qtbot.waitUntil(panel.isVisible)
    type_cell(panel, qtbot, "clip_from_view", 3, 0, "0.1")
    assert isinstance(window.store.document.projection.lens, FreeMatrix)
    window.activateWindow()
    field = double_click(panel, qtbot, "clip_from_view", 0, 0)
    qtbot.waitUntil(field.hasFocus)
    field.selectAll()
    qtbot.keyClicks(field, "7.5")
    window.history.reset()  # from the tool bar, which takes no keyboard
    assert window.store.document == start
    assert all(view.field is None for view in panel.views.values())


@pytest.mark.undrawn
def test_a_removed_matrix_explains_nothing(window: MainWindow, qtbot: QtBot) -> None:
    start, panel = window.store.document.projection, window.matrices
    activate(window)
    window.panels.open(panel)
    qtbot.waitUntil(panel.isVisible)
    free = with_cell(start, "clip_from_view", 3, 0, 0.1)
    names = set(panel.views)
    window.store.set_projection(free)
    vanishing = names - set(panel.views)
    assert vanishing
    for name in vanishing:
        window.store.set_projection(start)
        panel.views[name].setFocus()
        qtbot.keyClick(panel.views[name], Qt.Key.Key_Right)
        assert speaks_of(panel, name)
        window.store.set_projection(free)  # the keyboard goes on to a neighbour on the way
        assert not panel.explanation.text() or speaks_of(panel, *panel.views)


@pytest.mark.parametrize("lens", [Oblique(), OFF_AXIS.lens])
def test_entering_the_same_number_changes_nothing(
    panel: MatrixPanel, qtbot: QtBot, edits: list[Projection], lens: Any
) -> None:
    shown_after(panel, qtbot, replace(OFF_AXIS, lens=lens))
    for name, *places in (
        ("clip_from_view", (0, 0), (1, 2), (2, 3), (3, 2)), ("view_from_world", (0, 1), (2, 3)),
    ):  # fmt: skip
        for place in places:
            text = double_click(panel, qtbot, name, *place).text()
            type_cell(panel, qtbot, name, *place, text)
    assert edits == [] and panel.explanation.text()


@pytest.mark.parametrize(
    ("name", "text", "sentence"),
    [
        ("clip_from_view", "", "“”: must be a number, such as 0.5 or 2e-3."),
        ("view_from_world", "-1e101", "-1e+101: must be at least -1e+100."),
    ],
)
def test_a_refused_cell_is_named_and_nothing_changes(
    panel: MatrixPanel, qtbot: QtBot, edits: list[Projection], name: str, text: str, sentence: str
) -> None:
    before = panel.views[name].texts
    field = double_click(panel, qtbot, name, 0, 2)
    field.selectAll()
    qtbot.keyClicks(field, text) if text else qtbot.keyClick(field, Qt.Key.Key_Delete)
    qtbot.keyClick(field, Qt.Key.Key_Return)
    cell = f"{stage_title(name)}, row 1, column 3"
    assert panel.explanation.text() == f"Not possible. {cell} = {sentence}"
    assert panel.explanation.styleSheet() and panel.explanation.is_warning
    assert panel.views[name].field is field  # to be mended
    assert edits == []
    field.selectAll()
    qtbot.keyClicks(field, "0.5")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert len(edits) == 1 and panel.views[name].texts != before
    qtbot.keyClick(panel.views[name], Qt.Key.Key_Right)
    assert not panel.explanation.is_warning and not panel.explanation.styleSheet()


@pytest.mark.undrawn
@pytest.mark.parametrize(("size", "open_first"), [((1920, 1080), True), ((1366, 768), False)])
def test_the_note_of_a_free_matrix_is_fully_visible(
    window: MainWindow, qtbot: QtBot, size: tuple[int, int], open_first: bool
) -> None:
    window.resize(*size)
    panel = window.matrices
    if open_first:
        window.panels.open(panel)
        qtbot.waitUntil(panel.isVisible)
    projection = window.store.document.projection
    for row, column, value in ((3, 2, 0.0), (3, 0, 0.1), (3, 3, 0.5), (0, 1, 0.5), (1, 1, 0.0)):
        projection = with_cell(projection, "clip_from_view", row, column, value)
    window.store.set_projection(projection)
    window.panels.open(panel)
    qtbot.waitUntil(lambda: notes(panel, "clip_from_view").count(": ") >= 3)

    def is_whole() -> bool:
        note = panel.views["clip_from_view"].parentWidget().findChild(QLabel, "paneNote")
        seen = panel.findChild(QScrollArea).viewport()
        return bool(note.mapTo(seen, note.rect().bottomLeft()).y() < seen.height())

    qtbot.waitUntil(is_whole)


@pytest.mark.parametrize("scrolled", [0.5, 1.0])
def test_a_matrix_stays_in_place_when_its_neighbours_disappear_and_return(
    window: MainWindow, qtbot: QtBot, scrolled: float
) -> None:
    panel = window.matrices
    window.panels.open(panel)
    qtbot.waitUntil(lambda: panel.findChild(QScrollArea).horizontalScrollBar().maximum() > 500)
    bar = panel.findChild(QScrollArea).horizontalScrollBar()
    bar.setValue(round(scrolled * bar.maximum()))

    def left_px() -> int:
        return left_of(panel, "clip_from_view")

    left, count = left_px(), len(panel.shown)
    for text, boxes in (("0.25", count - 4), ("0", count)):
        view = panel.views["clip_from_view"]
        view.edit_cell(3, 0)
        assert view.field is not None
        view.field.setText(text)
        view.field.setModified(True)
        view.field.returnPressed.emit()
        assert len(panel.shown) == boxes
        assert left_px() == left  # at once, and when all has found its place
        for _ in range(3):
            window.panes["world"].canvas.redraw()
            QApplication.processEvents()
        assert left_px() == left
    assert panel.window().focusWidget() is panel.views["clip_from_view"]
    QApplication.sendEvent(panel, QEvent(QEvent.Type.Leave))  # the hand is elsewhere
    settle()
    boxes = [panel.views[matrix.name].parentWidget().geometry() for matrix in panel.shown]
    assert {b.left() - a.right() for a, b in itertools.pairwise(boxes)} == {7}  # no gap
    room = bar.maximum() + bar.pageStep() - boxes[-1].right()
    assert room < 20 or bar.maximum() == 0


def test_matrices_stand_on_one_line(panel: MatrixPanel, qtbot: QtBot) -> None:
    panel.running.setChecked(True)
    fold(panel, "view_from_world").click()
    qtbot.waitUntil(panel.views["view_from_world/rotation"].isVisible)
    QApplication.processEvents()

    def first_cells_px(seen: bool) -> set[int]:
        views = [view for view in panel.views.values() if view.isVisible() is seen]
        return {view.mapTo(panel, view.cell_rect(0, 0).topLeft().toPoint()).y() for view in views}

    assert len(panel.views) > 10 and len(first_cells_px(True)) == 1
    assert len({panel.views[matrix.name].height() for matrix in panel.shown}) == 1


def test_keys_open_leave_and_go_on(
    panel: MatrixPanel, qtbot: QtBot, edits: list[Projection]
) -> None:
    view = panel.views["clip_from_view"]
    view.setFocus()
    for key in (Qt.Key.Key_F2, Qt.Key.Key_Return, Qt.Key.Key_Enter):
        qtbot.keyClick(view, key)
        field = view.field
        assert field is not None
        qtbot.keyClicks(field, "7")
        qtbot.keyClick(field, Qt.Key.Key_Escape)
        assert view.field is None and panel.window().focusWidget() is view and edits == []
    field = double_click(panel, qtbot, "clip_from_view", 0, 0)
    qtbot.keyClick(field, Qt.Key.Key_Tab)
    assert view.field is not None and view.place == (0, 1)  # nothing typed, nothing edited
    assert edits == []
    qtbot.keyClicks(view.field, "0.25")  # a free matrix: the panel is built anew
    qtbot.keyClick(view.field, Qt.Key.Key_Tab)
    now = panel.views["clip_from_view"]
    assert now is not view and now.field is not None and now.place == (0, 2)
    assert isinstance(edits[0].lens, FreeMatrix)
    qtbot.keyClick(now.field, Qt.Key.Key_Backtab, Qt.KeyboardModifier.ShiftModifier)
    assert now.place == (0, 1)
    qtbot.keyClicks(now.field, "0")
    qtbot.keyClick(now.field, Qt.Key.Key_Return)
    assert edits[1] == OFF_AXIS
    assert panel.window().focusWidget() is panel.views["clip_from_view"]


def test_only_numbers_of_two_matrices_open(panel: MatrixPanel, qtbot: QtBot) -> None:
    for name in panel.views:
        opened = double_click(panel, qtbot, name, 0, 0) if "/" not in name else None
        assert (opened is not None) == (name in ("view_from_world", "clip_from_view")), name
        panel.views[name].abandon()
    hint = "press Enter to type another number"
    by_name = {matrix.name: matrix for matrix in panel.shown}
    assert hint in panel.sentence(by_name["clip_from_view"], 0, 0)
    assert hint not in panel.sentence(by_name["clip_from_world"], 0, 0)
    choose(panel.cells, "formulas")
    assert double_click(panel, qtbot, "clip_from_view", 0, 0) is None
    assert hint not in panel.sentence(by_name["clip_from_view"], 0, 0)


def test_rows_and_lecture_002_type_into_the_same_matrix(
    panel: MatrixPanel, qtbot: QtBot, edits: list[Projection]
) -> None:
    choose(panel.vectors, "rows")
    type_cell(panel, qtbot, "clip_from_view", 2, 0, "0.5")
    assert edits[-1].direct_stages[0].matrix[0, 2] == pytest.approx(0.5, rel=1e-15)
    choose(panel.letters, "002")  # its w is z
    shown = panel.views["clip_from_view"].texts[2][0]
    assert shown == "−0.5"
    type_cell(panel, qtbot, "clip_from_view", 2, 0, "-0.25")
    assert edits[-1].direct_stages[0].matrix[0, 2] == pytest.approx(0.25, rel=1e-15)


def notes(panel: MatrixPanel, name: str) -> str:
    note = panel.views[name].parentWidget().findChild(QLabel, "paneNote")
    return str(note.text()).replace("\n", " ") if note.isVisible() else ""


@pytest.mark.undrawn
def test_typing_reaches_the_whole_window_and_can_be_undone(
    window: MainWindow, qtbot: QtBot
) -> None:
    window.panels.open(window.matrices)
    qtbot.waitUntil(window.matrices.isVisible)
    store, controls = window.store, window.controls
    start = store.document.projection
    type_cell(window.matrices, qtbot, "clip_from_view", 0, 0, "0")
    assert isinstance(store.document.projection.lens, FreeMatrix)
    assert controls.rows["kind"].value() == "matrix"
    shown = {key for key, row in controls.rows.items() if not row.isHidden()}
    assert not shown & {"near", "far", "fov_y_deg", "left", "fx"}
    qtbot.waitUntil(lambda: "no frustum is drawn" in window.status.health.toolTip())
    assert controls.rows["eye_x"].isEnabled()
    type_cell(window.matrices, qtbot, "view_from_world", 0, 0, "5")
    assert not controls.rows["azimuth_deg"].isEnabled()
    assert not controls.animation.isEnabled()
    controls.animation.toggle()
    assert not controls.animation.playing
    store.undo()
    assert controls.rows["azimuth_deg"].isEnabled()
    store.undo()
    assert store.document.projection == start
    store.redo()
    dock.choose(dock.choice(controls, "kind"), "perspective")  # the way back
    assert store.document.projection == start
    dock.choose(dock.choice(controls, "kind"), "matrix")
    dock.choose(dock.choice(controls, "kind"), "orthographic")
    assert store.document.projection == start.with_lens("orthographic")


FREE_CELLS = (
    ("clip_from_view", 0, 1, 0.5), ("clip_from_view", 0, 0, 0.0), ("clip_from_view", 0, 0, -1.0),
    ("clip_from_view", 3, 2, 1.0), ("clip_from_view", 2, 2, 0.0), ("clip_from_view", 3, 0, 0.3),
    ("view_from_world", 0, 0, -2.0), ("view_from_world", 3, 2, 0.05), ("clip_from_view", 3, 2, 0.0),
)  # fmt: skip


def test_every_pane_probe_and_stop_takes_any_matrix(
    window: MainWindow, qtbot: QtBot, display: Any
) -> None:
    window.resize(940, 560)  # quickly drawn
    window.panels.open(window.probe_panel)
    start = window.store.document.projection
    probes = [Probe(1, (0.5, 2.0, 0.0)), Probe(2, pixel=(300.0, 200.0))]
    for at, cell in enumerate(FREE_CELLS):
        depth = ("opengl", "reversed")[at % 2]
        window.store.set_projection(with_cell(start.with_depth(depth), *cell))
        stops = (0.0, 0.5, 1.0, 1.9, 3.0, 3.7, 4.0, 4.5, 5.0)[at // 2 % 2 :: 2]
        for position in (*stops, 2.5):
            window.strip.go_to(position)
            display.processEvents()
            for pane in window.panes.values():
                pane.drawing.show_probes(probes)
                sight = pane.drawing.sight
                assert np.isfinite(sight.rows).all() and np.isfinite(sight.limits).all()
        assert isinstance(window.store.document.projection.lens, FreeMatrix)
        assert window.panes["ndc"].title.text() == "View → NDC"
        assert window.panes["ndc"].note.text() == "no canonical volumes"


def test_the_explanation_follows_the_value(panel: MatrixPanel, qtbot: QtBot) -> None:
    view = panel.views["clip_from_view"]
    qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=view.cell_rect(0, 0).center().toPoint())
    for right in (0.9, 1.3):
        shown_after(panel, qtbot, moved(OFF_AXIS, right=right))
        assert view.texts[0][0] in panel.explanation.text()
        matrix = next(m for m in panel.shown if m.name == "clip_from_view")
        assert panel.explanation.text() == panel.sentence(matrix, 0, 0)
    type_cell(panel, qtbot, "clip_from_view", 0, 0, "3")
    matrix = next(m for m in panel.shown if m.name == "clip_from_view")
    assert matrix.values[0][0] == 3.0
    assert panel.explanation.text() == panel.sentence(matrix, 0, 0)


# -- what is read on it


def test_a_vector_is_distinguished_from_the_plane_with_its_letter(panel: MatrixPanel) -> None:
    """In (f + n)(n.e) the first n is near, and the second the camera's axis."""
    choose(panel.cells, "formulas")
    panel.running.setChecked(True)
    for letters, vectors in zip(LETTERS, itertools.cycle(("columns", "rows")), strict=False):
        choose(panel.letters, letters)
        choose(panel.vectors, vectors)
        products = [text for row in shown_texts(panel) for text in row if "·" in text]
        assert products
        for text in products:
            before, _, after = text.partition("·")
            # Lecture 004 has a point for the eye.
            assert before.endswith(ARROW) and (after[1] == ARROW or after.startswith("T_0")), text
            vectors_of = [piece for piece, is_tex in pieces_of(text) if "vec" in piece and is_tex]
            assert len(vectors_of) == text.count(ARROW)
        (view,) = (matrix for matrix in panel.shown if matrix.name == "view_from_world")
        latex = as_latex(view, letters, formulas=True)
        assert r"\vec{" in latex and ARROW not in latex


def shown_texts(panel: MatrixPanel) -> list[list[str]]:
    return [row for view in panel.views.values() for row in view.texts]


def test_what_is_copied_is_what_is_shown(panel: MatrixPanel) -> None:
    clipboard = QGuiApplication.clipboard()
    text, _numpy, latex = panel.copy.menu().actions()
    choose(panel.cells, "formulas")
    text.trigger()
    assert f"−n{ARROW}·e{ARROW}" in clipboard.text()
    assert "2n/(r − l)" in clipboard.text()
    choose(panel.cells, "numbers")
    text.trigger()
    assert ARROW not in clipboard.text() and "(r − l)" not in clipboard.text()
    for cells in ("numbers", "formulas"):
        choose(panel.cells, cells)
        latex.trigger()
        # Each equation is displayed by itself, with nothing between that is mathematics.
        between = re.split(r"\\\[\n.*?\n\\\]\n", clipboard.text(), flags=re.DOTALL)
        assert len(between) == len(panel.shown) + 1 and not "".join(between).strip()


def test_a_matrix_has_one_name(panel: MatrixPanel) -> None:
    names = {stage_title(matrix.name) for matrix in panel.shown}
    assert {title(panel, matrix.name) for matrix in panel.shown} == names
    for matrix in panel.shown:
        name, sentence = title(panel, matrix.name), panel.sentence(matrix, 0, 0)
        assert sentence.startswith(f"{name}, row 1, column 1: ")
        said = (panel.views[matrix.name].accessibleName(), sentence)
        assert not any("_from_" in text for text in said)


def test_no_formula_is_cut_and_fractions_are_stacked(panel: MatrixPanel) -> None:
    """A fraction in a function's argument is not stacked, as in print."""
    panel.running.setChecked(True)
    assert {"world_from_view", "canonical_parallel_from_world"} <= {m.name for m in panel.shown}
    choose(panel.cells, "formulas")
    lenses = itertools.cycle((OFF_AXIS.lens, OFF_AXIS.with_lens("oblique").lens, Perspective()))
    for letters, lens in zip(LETTERS * 2, lenses, strict=False):
        choose(panel.letters, letters)
        show(panel, replace(OFF_AXIS, lens=lens))
        assert sum(OVER in text for row in shown_texts(panel) for text in row) > 8
        for view in panel.views.values():
            for i, j in itertools.product(range(4), range(4)):
                text, cell = view.texts[i][j], view.cell_rect(i, j)
                printed = typeset(text, view.font(), is_formula=True)
                assert printed.width < cell.width() and printed.height <= cell.height()
                assert "/" not in re.sub(r"\w+\([^()]*\)", "", text), text


@pytest.mark.undrawn
def test_a_held_cell_is_silent_after_its_matrix_was_removed(
    window: MainWindow, qtbot: QtBot
) -> None:
    """As with the other hand on the keyboard; its signal once reached a deleted widget."""
    start, panel = window.store.document.projection, window.matrices
    window.panels.open(panel)
    qtbot.waitUntil(panel.isVisible)
    view = panel.views["view_from_world"]
    cell = view.mapTo(window, view.cell_rect(1, 1).center().toPoint())
    QTest.mousePress(window.windowHandle(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier(0), cell)
    assert speaks_of(panel, "view_from_world")
    orthographic = start.with_lens("orthographic")
    window.store.set_projection(orthographic)
    shown_at_last(panel, qtbot, orthographic)
    assert panel.views["view_from_world"] is not view
    for step in range(3):  # the hand is not quite still, and has the old cell's mouse
        QTest.mouseMove(window.windowHandle(), cell + QPoint(step, 1))
    assert not panel.explanation.text() or speaks_of(panel, *panel.views)
    for lens in ("frustum", "orthographic"):
        QApplication.processEvents()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        window.store.set_projection(orthographic.with_lens(lens))
        shown_at_last(panel, qtbot, window.store.document.projection)  # no error on the way
    QTest.mouseRelease(window.windowHandle(), Qt.MouseButton.LeftButton, pos=cell)


def test_l9_the_reached_stage_highlights_its_matrix(panel: MatrixPanel) -> None:
    def lit() -> list[str]:
        names = [matrix.name for matrix in panel.shown]
        return [name for name in names if title_of(panel, name).property("reached")]

    assert lit() == ["depth_range_from_canonical_parallel"]  # NDC is where the strip starts
    for stop, name in enumerate(STOPS):
        panel.show_stage(float(stop))
        assert lit() == [name]
    panel.show_stage(2.4)
    assert lit() == ["canonical_perspective_from_view"]


def test_l9_the_chain_is_the_lectures_and_without_identities(panel: MatrixPanel) -> None:
    choose(panel.letters, "001")
    titles = {
        matrix.name: title(panel, matrix.name)
        for matrix in panel.shown
        if title_of(panel, matrix.name).isVisible()
    }
    assert [*titles] == [matrix.name for matrix in panel.shown]
    assert "world_from_object" not in titles
    assert titles["clip_from_view"].endswith("= f M<sub>z</sub> M<sub>pp</sub> M<sub>persp</sub>")
    assert titles["clip_from_depth_range"].endswith("= f I")
    assert titles["depth_range_from_canonical_parallel"].endswith("= M<sub>z</sub>")
    choose(panel.letters, "own")
    assert "world_from_object" in {matrix.name for matrix in panel.shown}


def end_of(panel: MatrixPanel, side: str) -> QToolButton:
    """The arrow at an end of the row."""
    button: QToolButton = named(panel, QToolButton, f"Matrices to the {side}")
    return button


def whole(panel: MatrixPanel) -> list[str]:
    """The matrices that are visible from one bracket to the other."""
    seen = panel.findChild(QScrollArea).viewport().width()
    return [
        matrix.name
        for matrix in panel.shown
        if left_of(panel, matrix.name) >= 0
        and left_of(panel, matrix.name) + panel.views[matrix.name].width() <= seen
    ]


def test_an_arrow_shows_where_the_row_continues_and_scrolls_there(panel: MatrixPanel) -> None:
    panel.resize(700, 240)
    settle()
    names = [matrix.name for matrix in panel.shown]
    bar = panel.findChild(QScrollArea).horizontalScrollBar()
    bar.setValue(0)
    places = end_of(panel, "left").geometry(), end_of(panel, "right").geometry()
    seen, clicks = whole(panel), 0
    assert not end_of(panel, "left").isVisible()
    while end_of(panel, "right").isVisible():
        assert clicks < len(names)
        before = whole(panel)
        click(end_of(panel, "right"))
        clicks += 1
        assert end_of(panel, "left").isVisible() and whole(panel) != before
        seen += whole(panel)
    assert set(seen) == set(names) and bar.value() == bar.maximum() > 0
    back = set(whole(panel))
    while end_of(panel, "left").isVisible():
        assert clicks < 2 * len(names)
        click(end_of(panel, "left"))
        clicks += 1
        back |= set(whole(panel))
    assert back == set(names) and bar.value() == 0
    assert places == (end_of(panel, "left").geometry(), end_of(panel, "right").geometry())
    panel.resize(bar.maximum() + 800, 240)
    settle()
    assert not end_of(panel, "left").isVisible() and not end_of(panel, "right").isVisible()


def test_the_reached_stage_is_fully_visible_and_no_matrix_is_cut_at_the_left(
    panel: MatrixPanel,
) -> None:
    panel.resize(700, 240)
    settle()
    bar = panel.findChild(QScrollArea).horizontalScrollBar()
    for stop, name in enumerate(STOPS):
        panel.show_stage(float(stop))
        settle()
        assert name in whole(panel)
        rights = {n: left_of(panel, n) + panel.views[n].width() for n in STOPS}
        is_cut = any(left_of(panel, n) < 0 < right for n, right in rights.items())
        assert not is_cut or bar.value() == bar.maximum(), name


def test_columns_grow_during_a_gesture_and_shrink_after_it(
    panel: MatrixPanel, qtbot: QtBot
) -> None:
    view = panel.views["clip_from_view"]
    usual = view.width()
    panel.begin_gesture()
    shown_after(panel, qtbot, moved(OFF_AXIS, left=0.89987))
    wide = view.width()
    assert wide > usual
    shown_after(panel, qtbot, OFF_AXIS)
    assert view.width() == wide
    panel.end_gesture()
    assert view.width() == usual
    shown_after(panel, qtbot, moved(OFF_AXIS, left=0.89987))
    shown_after(panel, qtbot, OFF_AXIS)
    assert view.width() == usual


# --------------------------------------------------------------------------- pasting


def paste(panel: MatrixPanel, name: str, text: str) -> None:
    """Press Ctrl+V in a matrix, as after a click on it."""
    QGuiApplication.clipboard().setText(text)
    panel.views[name].setFocus()
    QTest.keyClick(panel.views[name], Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)


def meanings_of(panel: MatrixPanel, name: str) -> list[Any]:
    """The choices of the open question, without its title."""
    menu = panel.views[name].findChild(QMenu)
    return [] if menu is None else menu.actions()[1:]


VIEW = [[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -5], [0, 0, 0, 1]]


def text_of(cells: Any) -> str:
    return "\n".join(" ".join(map(repr, map(float, row))) for row in cells)


@pytest.mark.parametrize("opened", [False, True], ids=["on a cell", "in its field"])
def test_a_pasted_matrix_is_taken_whole(panel: MatrixPanel, qtbot: QtBot, opened: bool) -> None:
    view = panel.views["view_from_world"]
    QGuiApplication.clipboard().setText(text_of(VIEW))
    view.setFocus()
    target: Any = view
    if opened:
        view.edit_cell(0, 0)
        target = view.field
    with qtbot.waitSignal(panel.edited) as edited:
        QTest.keyClick(target, Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    assert edited.args[0].camera.eye == (0.0, 0.0, 5.0)
    assert edited.args[0].lens == OFF_AXIS.lens and view.field is None
    assert plain(panel.explanation.text()) == "eye (0, 0, 5), looks along (0, 0, -1)"


def test_one_pasted_number_goes_into_its_cell(panel: MatrixPanel, qtbot: QtBot) -> None:
    paste(panel, "view_from_world", "0,25\n")
    field = panel.views["view_from_world"].field
    assert field is not None and field.text().strip() == "0,25"
    with qtbot.waitSignal(panel.edited) as edited:
        QTest.keyClick(field, Qt.Key.Key_Return)
    assert edited.args[0].lens.view_from_world[0][0] == 0.25


def test_a_text_that_is_no_matrix_is_refused(panel: MatrixPanel, qtbot: QtBot) -> None:
    with qtbot.assertNotEmitted(panel.edited):
        paste(panel, "view_from_world", "1 2 3 4")
        assert "must be 9, 12 or 16 numbers, but has 4" in panel.explanation.text()
        paste(panel, "clip_from_view", "1 0 0 0 1 0 0 0 2")
        assert "must be 16 numbers, or a calibrated camera" in panel.explanation.text()
        paste(panel, "clip_from_world", text_of(VIEW))  # cannot be typed in


@pytest.mark.parametrize("name", ["view_from_world", "clip_from_view"])
def test_a_pasted_camera_matrix_sets_camera_and_lens(
    panel: MatrixPanel, qtbot: QtBot, name: str
) -> None:
    with qtbot.waitSignal(panel.edited) as edited:  # K = 900 0 640; 0 900 360; 0 0 1, seen from +z
        paste(panel, name, "900 0 -640 3200\n0 -900 -360 1800\n0 0 -1 5")
    seen = edited.args[0]
    assert seen.camera.eye == pytest.approx((0.0, 0.0, 5.0))
    assert tuple(seen.intrinsics) == pytest.approx((900.0, 900.0, 640.0, 360.0))
    paste(panel, name, "1 0 0 0\n0 1 0 0\n0 0 0 0")
    assert name == "view_from_world" or "the camera is at infinity" in panel.explanation.text()


def test_rows_or_columns_are_asked_only_where_both_are_possible(
    panel: MatrixPanel, qtbot: QtBot
) -> None:
    turned = Projection(Camera((0.0, 0.0, 0.0), (-3.0, 0.0, -4.0))).stages[1].matrix
    with qtbot.assertNotEmitted(panel.edited):
        paste(panel, "view_from_world", text_of(turned))
    choices = meanings_of(panel, "view_from_world")
    assert [each.text() for each in choices] == [
        "eye (0, 0, 0), looks along (−0.6, 0, −0.8)",
        "rows and columns are exchanged: its transpose is meant; eye (0, 0, 0), looks along"
        " (0.6, 0, −0.8)",
    ]
    with qtbot.waitSignal(panel.edited) as edited:
        choices[1].trigger()
    assert edited.args[0].camera.frame[2] == pytest.approx([-0.6, 0.0, 0.8])
    paste(panel, "view_from_world", text_of(np.transpose(VIEW)))
    shown = panel.explanation.text()
    assert shown.startswith("rows and columns are exchanged") and "eye (0, 0, 5)" in shown


def test_a_near_plane_that_two_depth_ranges_give_is_asked(panel: MatrixPanel, qtbot: QtBot) -> None:
    cells = [[1.5, 0, 0, 0], [0, 2, 0, 0], [0, 0, -1, -0.2], [0, 0, -1, 0]]
    paste(panel, "clip_from_view", text_of(cells))
    first, second = meanings_of(panel, "clip_from_view")
    assert "z from −1 at near to 1" in first.text() and "near 0.1, far ∞" in first.text()
    assert "z from 0 at near to 1" in second.text() and "near 0.2, far ∞" in second.text()
    with qtbot.waitSignal(panel.edited) as edited:
        second.trigger()
    assert (edited.args[0].lens.near, edited.args[0].depth) == (0.2, "direct3d")


def test_twelve_numbers_nine_numbers_and_a_calibrated_camera(
    panel: MatrixPanel, qtbot: QtBot
) -> None:
    with qtbot.waitSignal(panel.edited) as edited:
        paste(panel, "view_from_world", text_of(VIEW[:3]))
    assert edited.args[0].camera.eye == (0.0, 0.0, 5.0)
    with qtbot.waitSignal(panel.edited) as edited:
        paste(panel, "view_from_world", "0.8 0 -0.6  0 1 0  0.6 0 0.8")
        meanings_of(panel, "view_from_world")[0].trigger()
    assert edited.args[0].camera.eye == (0.0, 0.0, 5.0)
    assert edited.args[0].camera.frame[0] == pytest.approx([0.8, 0.0, -0.6])
    with qtbot.waitSignal(panel.edited) as edited:
        paste(panel, "clip_from_view", "K = [[800, 0, 639.5], [0, 800, 359.5], [0, 0, 1]]")
    assert edited.args[0].intrinsics[:2] == pytest.approx((800.0, 800.0))


def test_row_vectors_do_not_turn_what_has_its_own_order(panel: MatrixPanel, qtbot: QtBot) -> None:
    choose(panel.vectors, "rows")
    with qtbot.waitSignal(panel.edited) as edited:
        paste(panel, "clip_from_view", "K = [[800, 0, 600], [0, 800, 300], [0, 0, 1]]")
    assert tuple(edited.args[0].intrinsics) == pytest.approx((800.0, 800.0, 600.0, 300.0))
    with qtbot.waitSignal(panel.edited) as edited:
        paste(panel, "clip_from_view", "mat4(2,0,0,0, 0.5,3,0,0.25, 0,0,-1.2,-1, 0,0,-2.2,0)")
    assert edited.args[0].lens.clip_from_view[0] == (2.0, 0.5, 0.0, 0.0)


@pytest.mark.parametrize("form", ["text", "numpy", "latex"])
@pytest.mark.parametrize("vectors", ["columns", "rows"])
def test_what_is_copied_can_be_pasted(
    panel: MatrixPanel, qtbot: QtBot, form: str, vectors: str
) -> None:
    choose(panel.vectors, vectors)
    texts = []
    for letters in [*LETTERS][vectors == "rows" :: 2]:  # each form in all letters
        choose(panel.letters, letters)
        shown_at_last(panel, qtbot, OFF_AXIS)
        for name in ("view_from_world", "clip_from_view"):
            matrix = next(each for each in panel.shown if each.name == name)
            panel.views[name].copied.emit(form, matrix)
            texts.append((letters, name, QGuiApplication.clipboard().text()))
    other = Projection(Camera((3.0, 1.0, 2.0), (0.0, 0.0, 0.0)), Frustum(-1, 1, -1, 1, 2, 20))
    for letters, name, text in texts:
        choose(panel.letters, letters)
        shown_after(panel, qtbot, other)
        with qtbot.waitSignal(panel.edited) as edited:
            paste(panel, name, text)
        found = edited.args[0]
        if name == "clip_from_view":
            assert found == replace(other, lens=OFF_AXIS.lens)
        else:
            assert found.camera.eye == OFF_AXIS.camera.eye and found.lens == other.lens
            assert np.abs(found.camera.frame - OFF_AXIS.camera.frame).max() < 1e-15


def test_the_last_rounded_cell_makes_a_camera_and_says_so(panel: MatrixPanel, qtbot: QtBot) -> None:
    turned: Any = ((0.9553365, -0.29552022, 0, 0), (0.29552022, 0.9553365, 0, 0), *VIEW[2:])
    cells = [list(row) for row in turned]
    cells[3][3], cells[1][1] = 1.0, 0.5
    free = replace(
        OFF_AXIS, lens=FreeMatrix(OFF_AXIS.clip_from_view.tolist(), cells, OFF_AXIS.lens)
    )
    shown_after(panel, qtbot, free)
    panel.views["view_from_world"].edit_cell(1, 1)
    field: Any = panel.views["view_from_world"].field
    field.selectAll()
    QTest.keyClicks(field, "0.9553365")
    with qtbot.waitSignal(panel.edited) as edited:
        QTest.keyClick(field, Qt.Key.Key_Return)
    assert edited.args[0].lens == OFF_AXIS.lens
    assert edited.args[0].camera.eye == (0.0, 0.0, 5.0)
    assert "rounded to float32; the nearest camera is used" in panel.explanation.text()


@pytest.mark.parametrize("name", ["opengl", "direct3d", "vulkan", "unity"])
def test_both_matrices_of_another_program_give_our_picture(
    panel: MatrixPanel, qtbot: QtBot, name: str
) -> None:
    """Its world may be mirrored; rows of the view change sign where the sentence says so."""
    view, clip, _ = in_convention(OFF_AXIS, name, rows=False).values()
    other = Projection(Camera((3.0, 1.0, 2.0), (0.0, 0.0, 0.0)))
    shown_after(panel, qtbot, other)
    with qtbot.waitSignal(panel.edited) as edited:
        paste(panel, "clip_from_view", text_of(clip))
    said = panel.explanation.text()
    assert ("in row 3" in said) == (name == "direct3d")
    assert ("with y up" in said) == (name == "vulkan")
    assert edited.args[0].lens == OFF_AXIS.lens
    if "in row 3" in said:
        view[2] *= -1.0
    with qtbot.waitSignal(panel.edited) as edited:
        paste(panel, "view_from_world", text_of(view))
    points = np.array([(0.5, 2.0, -0.25), (-1.0, 0.5, 0.75)])
    mirror = np.array([1.0, 1.0, -1.0 if name in ("direct3d", "unity") else 1.0])
    pixels = edited.args[0].trace(points * mirror).image
    assert np.abs(pixels - OFF_AXIS.trace(points).image).max() < 1e-9


@pytest.mark.undrawn
def test_formulas_and_boxes_are_ready_before_the_panel_opens(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch, qtbot: QtBot
) -> None:
    window.panels.open(None)
    for kept in ("_formulas", "_fields"):
        getattr(notation, kept).cache_clear()
    window.panels.idle.start(0)
    qtbot.waitUntil(lambda: not window.panels.idle.isActive())
    monkeypatch.setattr(notation, "evaluated", None)  # nothing is worked out any more
    view = window.matrices.views["clip_from_view"]
    there = moved(window.store.document.projection, near=1.25)
    window.store.set_projection(there)
    window.panels.open(window.matrices)
    assert window.matrices.isVisible() and window.matrices.views["clip_from_view"] is view
    by_name = {matrix.name: matrix for matrix in window.matrices.shown}
    assert by_name["clip_from_view"].values[2][2] == there.direct_stages[0].matrix[2, 2]
