"""The matrices panel with real widgets: what it shows, marks, says and copies."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication, QMouseEvent
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from app import cli, notation
from app.drawings.style import DARK, LIGHT
from app.projection import Camera, Frustum, Oblique, Perspective, Projection
from widgets import matrix_panel
from widgets.matrix_panel import MatrixPanel, MatrixView, first_change
from widgets.rows import short_text

OFF_AXIS = Projection(
    Camera((6.0, 5.0, 9.0), (0.5, 2.0, -0.25)), Frustum(-0.7, 0.9, -0.4, 0.65, 1.5, 40.0)
)


@pytest.fixture
def panel(display: Any, qtbot: QtBot) -> MatrixPanel:
    panel = MatrixPanel()
    qtbot.addWidget(panel)
    panel.show_projection(OFF_AXIS)
    panel.resize(1350, 240)
    panel.show()
    qtbot.waitExposed(panel)
    return panel


def moved(projection: Projection, **fields: Any) -> Projection:
    return replace(projection, lens=replace(projection.lens, **fields))


def shown_after(panel: MatrixPanel, qtbot: QtBot, projection: Projection) -> None:
    panel.show_projection(projection)
    qtbot.waitUntil(lambda: not panel._pending)


def choose(box: Any, value: str) -> None:
    box.setCurrentIndex(box.findData(value))


def test_numbers_are_those_of_the_command(panel: MatrixPanel) -> None:
    told = json.loads(cli._matrices_json(OFF_AXIS))
    assert [matrix.name for matrix in panel.shown] == list(told)
    words = cli._matrices_text(OFF_AXIS).split()
    for matrix in panel.shown:
        view = panel.views[matrix.name]
        assert view.texts == [[short_text(value) for value in row] for row in told[matrix.name]]
        for i in range(4):
            for j in range(4):
                number = notation.cell_text(told[matrix.name][i][j])
                assert number in words
                assert f"{number}. " in panel.sentence(matrix, i, j)


def test_folded_computes_nothing(
    display: Any, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[Projection] = []

    def counted(projection: Projection, *args: Any, **options: Any) -> Any:
        calls.append(projection)
        return notation.matrices(projection, *args, **options)

    monkeypatch.setattr(matrix_panel, "matrices", counted)
    panel = MatrixPanel()
    qtbot.addWidget(panel)
    panel.set_style(LIGHT)
    for near in (1.0, 1.25, 1.5):
        panel.show_projection(moved(OFF_AXIS, near=near))
        display.processEvents()
    panel.set_style(DARK)
    panel.running.setChecked(True)
    assert not calls
    panel.show()
    qtbot.waitExposed(panel)
    assert calls == [moved(OFF_AXIS, near=1.5)]
    assert not any(view.lit for view in panel.views.values())
    for near in (1.0, 1.25, 2.0):  # one update for many steps
        panel.show_projection(moved(OFF_AXIS, near=near))
    assert len(calls) == 1
    qtbot.waitUntil(lambda: len(calls) > 1)
    assert calls[1] == moved(OFF_AXIS, near=2.0)
    count = len(calls)
    panel.hide()
    panel.show_projection(OFF_AXIS)
    display.processEvents()
    assert len(calls) == count


def test_cells_that_a_change_changed_are_lit(panel: MatrixPanel, qtbot: QtBot) -> None:
    assert not panel.views["clip_from_view"].lit
    shown_after(panel, qtbot, moved(OFF_AXIS, far=50.0))
    assert panel.views["clip_from_view"].lit == {(2, 2), (2, 3)}
    assert panel.views["view_from_world"].lit == set()
    assert panel.views["canonical_perspective_from_view/scale"].lit == {(0, 0), (1, 1), (2, 2)}
    assert panel.views["canonical_perspective_from_view/shear"].lit == set()


def test_a_drag_is_marked_against_its_beginning(panel: MatrixPanel, qtbot: QtBot) -> None:
    panel.begin_gesture()
    shown_after(panel, qtbot, moved(OFF_AXIS, left=-0.75))
    shown_after(panel, qtbot, moved(OFF_AXIS, left=-0.75, far=50.0))
    lit = panel.views["clip_from_view"].lit
    assert lit == {(0, 0), (0, 2), (2, 2), (2, 3)}
    mark = panel.views["clip_from_view"].marks[2][2]
    before, after = (short_text(-(far + 1.5) / (far - 1.5)) for far in (40.0, 50.0))
    assert mark == first_change(before, after) and before[:mark] == after[:mark] and mark
    shown_after(panel, qtbot, OFF_AXIS)  # dragged back to where it began
    assert not panel.views["clip_from_view"].lit
    panel.end_gesture()
    shown_after(panel, qtbot, moved(OFF_AXIS, far=50.0))
    assert panel.views["clip_from_view"].lit == {(2, 2), (2, 3)}


@pytest.mark.parametrize(
    ("before", "after", "first"),
    [
        ("1.25", "1.25", None), ("1.25", "1.27", 3), ("1.25", "1.2", 3), ("9.9", "10.1", 0),
        ("-1.5", "1.5", 0), ("1e-5", "1e-6", 0), ("2", "2.5", 1), ("0.5", "0.6", 2),
    ],
)  # fmt: skip
def test_where_digits_begin_to_differ(before: str, after: str, first: int | None) -> None:
    assert first_change(before, after) == first


def test_light_and_underline_reach_the_screen(panel: MatrixPanel, qtbot: QtBot) -> None:
    """The cell's ground takes the accent's colour, and its last digits get a line below."""
    view = panel.views["clip_from_view"]
    plain = view.grab().toImage()
    shown_after(panel, qtbot, moved(OFF_AXIS, far=50.0))
    lit = view.grab().toImage()
    inside = view._cell_rect(2, 2).topLeft() + QPointF(4.0, 4.0)
    other = view._cell_rect(1, 2).topLeft() + QPointF(4.0, 4.0)
    assert plain.pixelColor(inside.toPoint()) != lit.pixelColor(inside.toPoint())
    assert plain.pixelColor(other.toPoint()) == lit.pixelColor(other.toPoint())


def test_formulas_in_the_letters_of_a_lecture(panel: MatrixPanel) -> None:
    choose(panel.cells, "formulas")
    view = panel.views["clip_from_view"]
    assert view.texts[0] == ["2n/(r − l)", "0", "(r + l)/(r − l)", "0"]
    choose(panel.letters, "000")
    assert view.texts[0][0] == "2z_min/(x_max − x_min)"
    choose(panel.letters, "002")
    assert view.texts[3] == ["0", "0", "1", "0"]
    box = panel._boxes[[matrix.name for matrix in panel.shown].index("clip_from_view")]
    assert "lecture 002" in box.note.text() and box.note.isVisible()
    choose(panel.letters, "001")
    assert panel.views["view_from_world"].texts[2] == ["w_x", "w_y", "w_z", "−w·P"]


def test_row_vectors(panel: MatrixPanel) -> None:
    columns = {matrix.name: matrix for matrix in panel.shown}
    choose(panel.vectors, "rows")
    for matrix in panel.shown:
        assert np.array_equal(np.transpose(columns[matrix.name].values), matrix.values)
    shown = {matrix.name: matrix for matrix in panel.shown}
    assert [f.name for f in shown["view_from_world"].factors] == ["translation", "rotation"]
    assert "It makes w the distance" in panel.sentence(shown["clip_from_view"], 2, 3)


def test_running_products_and_the_inverse(panel: MatrixPanel) -> None:
    panel.running.setChecked(True)
    names = [matrix.name for matrix in panel.shown]
    assert names[1:3] == ["view_from_world", "world_from_view"]
    assert "canonical_parallel_from_world" in names
    columns = np.array(panel.shown[2].values)[:3, :3].T
    assert np.array_equal(columns, OFF_AXIS.camera.frame)


@pytest.mark.parametrize(
    ("name", "row", "column", "words"),
    [
        ("view_from_world", 0, 1, "the camera's axis u"),
        ("view_from_world", 0, 3, "It shifts x by"),
        ("clip_from_view", 0, 0, "It scales x by"),
        ("clip_from_view", 0, 2, "times z to x: a shear"),
        ("clip_from_view", 3, 2, "It makes w the distance"),
        ("clip_from_view", 2, 3, "before the divide"),
        ("clip_from_view", 1, 0, "x has no part in y"),
        ("image_from_ndc", 1, 1, "turns it round"),
    ],
)
def test_a_cell_says_what_it_does(
    panel: MatrixPanel, name: str, row: int, column: int, words: str
) -> None:
    (matrix,) = (matrix for matrix in panel.shown if matrix.name == name)
    assert words in panel.sentence(matrix, row, column)


def test_a_cell_says_which_control_it_depends_on(panel: MatrixPanel) -> None:
    matrix = next(matrix for matrix in panel.shown if matrix.name == "clip_from_view")
    assert panel.sentence(matrix, 2, 2).endswith("It depends on: Far, Near, Depth range.")
    assert panel.sentence(matrix, 3, 2).endswith("It depends on no control.")


def test_pointing_with_mouse_and_keys(panel: MatrixPanel, qtbot: QtBot) -> None:
    view = panel.views["view_from_world"]
    with qtbot.waitSignal(view.pointed) as hover:
        place = view._cell_rect(1, 3).center()
        nothing = Qt.MouseButton.NoButton
        move = QMouseEvent(
            QEvent.Type.MouseMove, place, view.mapToGlobal(place), nothing, nothing,
            Qt.KeyboardModifier.NoModifier,
        )  # fmt: skip
        QGuiApplication.sendEvent(view, move)
    assert "row 2, column 4" in hover.args[0] == panel.explanation.text()
    qtbot.mouseClick(view, Qt.MouseButton.LeftButton, pos=view._cell_rect(0, 0).center().toPoint())
    qtbot.keyClick(view, Qt.Key.Key_Right)
    qtbot.keyClick(view, Qt.Key.Key_Down)
    qtbot.keyClick(view, Qt.Key.Key_Down)
    assert "row 3, column 2" in panel.explanation.text()
    assert view.accessibleDescription() == panel.explanation.text()
    assert view.accessibleName() == "view_from_world"


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
        "Copy as text", "Copy for NumPy", "Copy for LaTeX",
    ]  # fmt: skip
    actions[1].trigger()
    numbers: dict[str, Any] = {"np": np}
    exec(clipboard.text(), numbers)
    assert (
        numbers["clip_from_view"].tolist()
        == json.loads(cli._matrices_json(OFF_AXIS))["clip_from_view"]
    )
    actions[2].trigger()
    assert r"\begin{pmatrix}" in clipboard.text()
    menu.close()
    panel.copy.menu().actions()[1].trigger()
    exec(clipboard.text(), numbers)
    for name, matrix in json.loads(cli._matrices_json(OFF_AXIS)).items():
        assert numbers[name].tolist() == matrix


def test_factors_unfold_and_stay_so(panel: MatrixPanel, qtbot: QtBot) -> None:
    view = panel.views["view_from_world/rotation"]
    assert not view.isVisible()
    box = panel._boxes[1]
    qtbot.mouseClick(box.fold, Qt.MouseButton.LeftButton)
    assert view.isVisible()
    shown_after(panel, qtbot, OFF_AXIS.with_lens("oblique"))
    qtbot.waitUntil(panel.views["view_from_world/rotation"].isVisible)
    assert not panel.views["canonical_parallel_from_view/shear"].isVisible()


@pytest.mark.parametrize("lens", [Perspective(45.0, 1.0, math.inf), Oblique()])
def test_notes_are_shown(panel: MatrixPanel, qtbot: QtBot, lens: Any) -> None:
    projection = replace(OFF_AXIS, lens=lens)
    shown_after(panel, qtbot, projection)
    notes = {box.note.text().replace("\n", " ") for box in panel._boxes if not box.note.isHidden()}
    assert {stage.note for stage in projection.stages if stage.note} <= notes


def test_the_window_shows_the_current_value_when_the_panel_opens(
    make_window: Callable[..., Any], qtbot: QtBot
) -> None:
    window = make_window()
    panel = window.matrices
    assert not panel.shown
    window.panels.open(panel)
    qtbot.waitUntil(panel.isVisible)
    projection = window.store.document.projection
    by_name = {matrix.name: matrix for matrix in panel.shown}
    assert by_name["clip_from_view"].values[1][1] == projection.direct_stages[0].matrix[1, 1]
    start = projection
    window.controls.gesture_started.emit()
    for near in (1.25, 1.5):
        window.store.set_projection(moved(start, near=near))
    qtbot.waitUntil(lambda: not panel._pending)
    assert panel.views["clip_from_view"].lit == {(2, 2), (2, 3)}
    window.controls.gesture_finished.emit()
    assert all(isinstance(view, MatrixView) for view in panel.views.values())
