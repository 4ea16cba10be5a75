"""The Measure panel, with real measurements by the real process."""

import os
import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import psutil
import pytest
from PySide6.QtCore import QPoint, QPointF, QProcess, Qt
from PySide6.QtGui import QPalette
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.document.document import Document
from app.measure import arithmetic, chart, depth, interpolation, smoothing
from app.measure import results as kept
from app.measure.arithmetic import CHEAP
from app.measure.meaning import bargain, meaning
from app.measure.results import ChartPoint, Measurements, Trade, from_json, table, to_csv, to_json
from app.measure.single import SHIPPED, read_results, split
from app.model.projection import Camera, Perspective, Projection
from app.model.refusal import MEASURE
from app.scenes.phenomena.cheap_arithmetic import hardware_of
from app.scenes.phenomena.illustration import Diagram
from app.scenes.scene import load
from tests.support.results import RESULTS, TRADE, curve, sweep
from tests.support.shown import show
from tests.support.window import rgb_of, settle
from widgets.panels import measuring
from widgets.panels.measure_panel import MeasurePanel
from widgets.panes.canvas import SMOOTHINGS
from widgets.parts.diagram import HIT_PX
from widgets.window.main_window import MainWindow

IN_USE = {"depth_format": "fixed24", "depth_mapping": "reversed", "rung": "good"}


@pytest.fixture
def document() -> Document:
    return Document("letter-f", load("letter-f").start)


@pytest.fixture
def panel(qtbot: QtBot, document: Document) -> Iterator[MeasurePanel]:
    made = MeasurePanel(lambda: document, lambda: IN_USE, SMOOTHINGS, QWidget())
    qtbot.addWidget(made)
    made.resize(1340, 300)
    made.show()
    qtbot.waitExposed(made)
    yield made
    made.close_process()


def measured(qtbot: QtBot, panel: MeasurePanel, *names: str) -> None:
    panel.choose(*names)
    with qtbot.waitSignal(panel.measuring.finished):
        qtbot.mouseClick(panel.run_button, Qt.MouseButton.LeftButton)


def cells(panel: MeasurePanel) -> list[list[str]]:
    rows, columns = panel.table.rowCount(), panel.table.columnCount()
    return [[panel.table.item(y, x).text() for x in range(columns)] for y in range(rows)]


def heads(panel: MeasurePanel) -> list[str]:
    columns = range(panel.table.columnCount())
    return [panel.table.horizontalHeaderItem(x).text() for x in columns]


def found(view: Any) -> dict[str, tuple[QPoint, bool]]:
    """A pixel of each spot that can be chosen, and whether the spot is marked."""
    spots = {}
    step = int(HIT_PX)  # a pixel of every spot, unless another one is as near
    for x, y in product(range(0, view.width(), step), range(0, view.height(), step)):
        spot = view.spot_at(QPointF(x, y), key_only=True)
        if spot is not None:
            spots[spot.key] = QPoint(x, y), spot.marked
    return spots


def click_spot(panel: MeasurePanel, key: str) -> None:
    (view,) = (view for view in panel.diagrams if view.isVisible())
    view.grab()
    place, _ = found(view)[key]
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, place)


def process_of(panel: MeasurePanel) -> QProcess:
    """The running process; an earlier one may not be deleted yet."""
    return panel.measuring.findChildren(QProcess)[-1]


def click_cell(panel: MeasurePanel, row: int) -> None:
    place = panel.table.visualItemRect(panel.table.item(row, 1)).center()
    none = Qt.KeyboardModifier.NoModifier
    QTest.mouseClick(panel.table.viewport(), Qt.MouseButton.LeftButton, none, place)


def write(path: Path, results: Measurements) -> Path:
    path.write_text(to_json(results), encoding="utf-8")
    return path


# -- measuring


def hue_of(panel: MeasurePanel) -> int:
    """How far the chart's most colourful pixel is from grey."""
    (view,) = (view for view in panel.diagrams if view.isVisible())
    seen = rgb_of(view.grab().toImage()).astype(int)
    return int((seen.max(axis=2) - seen.min(axis=2)).max())


def test_it_opens_with_the_results_of_another_machine_in_grey(
    panel: MeasurePanel, qtbot: QtBot
) -> None:
    shipped = split(read_results(SHIPPED))
    grey = panel.palette().color(QPalette.ColorRole.PlaceholderText)
    for name, results in shipped.items():
        panel.choose(name)
        assert hue_of(panel) < 40, name
        assert panel.table.rowCount()
        assert panel.table.item(0, 0).foreground().color() == grey
        assert chart.machine(results) in panel.sentence.text()
    panel.choose("depth")
    assert panel.run_button.text() == "Measure here" and not panel.export_button.isEnabled()
    panel.setStyleSheet("#measureHere { padding: 8px 16px; }")  # of the window's style sheet
    qtbot.waitUntil(lambda: panel.run_button.height() > 1.3 * panel.load_button.height())
    measured(qtbot, panel, "depth")
    assert hue_of(panel) > 100 and "another machine" not in panel.sentence.text()
    assert chart.where(panel.measured["depth"]) in panel.sentence.text()
    panel.choose("near")
    assert hue_of(panel) < 40, "only what was measured is replaced"


def test_the_results_that_the_program_brings_name_no_place() -> None:
    assert not re.search(r"[/\\](?!u00)\w{3,}|home|user", SHIPPED.read_text(encoding="utf-8"))
    results = read_results(SHIPPED)
    assert re.fullmatch(r"[A-Za-z]+ [\d.]+", results.machine["system"]), "no name of its own"
    assert results.complete and set(split(results)) == set(chart.TITLES)


def test_a_trade_is_measured_and_shown(panel: MeasurePanel, qtbot: QtBot) -> None:
    assert "on another machine" in panel.sentence.text() and not panel.export_button.isEnabled()
    fractions = QSignalSpy(panel.measuring.progressed)
    panel.choose("depth")
    settle()
    cancel = panel.cancel_button.geometry()
    panel.run()
    settle()
    assert panel.cancel_button.geometry() == cancel, "nothing moves under the pointer"
    file = process_of(panel).arguments()[-1]
    assert os.path.exists(file) and panel.cancel_button.isEnabled()
    assert not panel.run_button.isEnabled() and panel.progress.isVisible()
    qtbot.waitUntil(lambda: not panel.measuring.running)
    assert not os.path.exists(file)
    assert panel.run_button.isEnabled() and not panel.cancel_button.isEnabled()
    assert not panel.progress.isVisible()
    results = panel.measured["depth"]
    assert fractions.count() > 3 and panel.progress.value() == 1000
    assert results.complete and results.document["lens"]["far"] == 12.5
    trade = results.trades[0]
    assert [heads(panel), *cells(panel)] == table(trade)  # as the command prints them
    (current,) = (c for c in trade.choices if c.name == "fixed24, reversed")
    assert panel.sentence.text().startswith(f"{bargain(trade, current)} {meaning(trade)}")
    assert chart.where(results) in panel.sentence.text(), "every word can be read"
    assert "letter-f; eye (5, 4.5, 8)" in panel.sentence.text()
    assert not panel.list.currentItem().icon().isNull() and panel.list.item(0).icon().isNull()
    heights = [*map(panel.list.sizeHintForRow, range(panel.list.count()))]
    assert max(heights) - min(heights) <= 2, "a tick is no larger than the letters"
    (view,) = (view for view in panel.diagrams if view.isVisible())
    assert view.accessibleName() == "Depth buffer"


def test_several_measurements_run_together_and_are_shown_and_exported_one_by_one(
    panel: MeasurePanel, qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    refused, succeeded = QSignalSpy(panel.refused), QSignalSpy(panel.succeeded)
    assert not panel.export(tmp_path / "early.csv") and "nothing to export" in refused.at(0)[0]
    measured(qtbot, panel, "depth", "near", "fov")
    assert set(panel.measured) == {"depth", "near", "fov"}
    assert panel.name == "fov"
    assert sum(view.isVisible() for view in panel.diagrams) == 1
    assert heads(panel)[0] == "fov, °" and len(cells(panel)) == 13
    assert chart.where(panel.measured["fov"]) in panel.sentence.text()
    panel.choose("near")
    assert heads(panel)[0] == "near"
    assert sum(view.isVisible() for view in panel.diagrams) == 1
    panel.choose("up")
    assert panel.sentence.isVisible() and "on another machine" in panel.sentence.text()
    panel.choose("depth")
    for ending in ("csv", "json", "png", "pdf"):
        assert panel.export(tmp_path / f"depth.{ending}")
    assert succeeded.count() == 4
    trade = panel.measured["depth"].trades[0]
    assert (tmp_path / "depth.csv").read_text(encoding="utf-8") == to_csv(trade)
    assert (
        from_json((tmp_path / "depth.json").read_text(encoding="utf-8")) == panel.measured["depth"]
    )
    assert (tmp_path / "depth.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "depth.pdf").read_bytes().startswith(b"%PDF")
    assert not panel.export(tmp_path / "depth.doc") and "must end in one of" in refused.at(1)[0]
    assert not panel.export(tmp_path / "no" / "depth.csv") and refused.count() == 3
    assert "Traceback" not in refused.at(2)[0]
    assert QApplication.overrideCursor() is None
    # Another machine's results are drawn over these.
    mine = panel.measured["depth"]
    theirs = replace(mine, machine={"system": "Box 9"}, date="2020-02-02T00:00:00+00:00")
    own_rows = cells(panel)
    assert not panel.forget_button.isEnabled()
    drawn: list[Diagram] = []
    monkeypatch.setattr(panel.diagrams[0], "show_diagram", drawn.append)
    assert panel.load(write(tmp_path / "a.json", theirs))
    assert "Box 9, 2020-02-02T00:00:00+00:00" in [c.label for c in drawn[-1].curves]
    rows = cells(panel)
    assert rows[: len(own_rows)] == own_rows and len(rows) == 2 * len(own_rows)
    assert rows[-1][:-1] == own_rows[-1][:-1]
    assert rows[-1][-1] == "Box 9, 2020-02-02T00:00:00+00:00"
    assert panel.export(tmp_path / "both.csv")
    assert (tmp_path / "both.csv").read_text(encoding="utf-8").count("choice,cost_B") == 2
    qtbot.mouseClick(panel.forget_button, Qt.MouseButton.LeftButton)
    assert cells(panel) == own_rows and panel.measured["depth"] is mine


def test_an_unsaved_document_is_measured_with_its_mesh(
    qtbot: QtBot, document: Document, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mesh = tmp_path / "triangle.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)  # where the process is not
    start = load(str(mesh)).start
    changed = Document("triangle.obj", replace(start, lens=replace(start.lens, far=77.5)))
    panel = MeasurePanel(lambda: changed, dict, SMOOTHINGS, QWidget())
    qtbot.addWidget(panel)
    measured(qtbot, panel, "interpolation")
    found = panel.measured["interpolation"].document
    assert found["scene"] == str(mesh) and found["lens"]["far"] == 77.5


def test_a_cancelled_measurement_keeps_its_results_and_says_so(
    panel: MeasurePanel, qtbot: QtBot
) -> None:
    panel.how.setCurrentIndex(1)  # full: it would take half a minute
    panel.choose("arithmetic", "depth")
    before, said = cells(panel), panel.sentence.text()
    panel.run()
    with qtbot.waitSignal(panel.measuring.progressed):
        pass
    with qtbot.waitSignal(panel.measuring.finished):
        qtbot.mouseClick(panel.cancel_button, Qt.MouseButton.LeftButton)
    panel.choose("arithmetic")
    assert not panel.measured["arithmetic"].complete
    assert "(cancelled)" in panel.sentence.text()
    assert len(cells(panel)) == len(panel.measured["arithmetic"].trades[0].choices) > 5
    notes = {row[-1] for row in cells(panel) if row[1] == "-"}
    assert notes <= {"cancelled", "not installed", MEASURE["in-software"]}
    panel.choose("depth")
    assert "depth" not in panel.measured
    assert cells(panel) == before and panel.sentence.text() == said, "the program's own, again"


def test_it_waits_while_a_control_is_dragged(panel: MeasurePanel, qtbot: QtBot) -> None:
    panel.begin_gesture()
    panel.choose("depth")
    panel.run()
    assert panel.progress.format() == "paused"
    with qtbot.assertNotEmitted(panel.measuring.finished, wait=0):
        process_of(panel).waitForFinished(2500)  # longer than it takes where nothing holds it up
        assert panel.measuring.running
    panel.begin_gesture()
    panel.end_gesture()
    assert panel.progress.format() == "paused"
    with qtbot.waitSignal(panel.measuring.finished):
        panel.end_gesture()
    assert panel.progress.format() != "paused"
    assert panel.measured["depth"].complete


def test_a_refusal_of_the_process_is_one_sentence(
    qtbot: QtBot, document: Document, tmp_path: Path
) -> None:
    gone = replace(document, scene=str(tmp_path / "gone.obj"))
    panel = MeasurePanel(lambda: gone, dict, SMOOTHINGS, QWidget())
    qtbot.addWidget(panel)
    refused = QSignalSpy(panel.refused)
    panel.show()
    measured(qtbot, panel, "depth")
    assert refused.count() == 1
    (said,) = refused.at(0)
    assert said.startswith(f"{tmp_path / 'gone.obj'}: there is no such file"), said
    assert said.count("\n") == 0
    assert cells(panel) == [["", said]] and panel.sentence.text() == said


def test_without_opengl_a_trade_of_pictures_says_why_it_is_missing(
    panel: MeasurePanel, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MESA_GL_VERSION_OVERRIDE", "2.1")
    measured(qtbot, panel, "smoothing", "depth")
    assert "depth" in panel.measured
    panel.choose("smoothing")
    ((_, words),) = cells(panel)
    assert "OpenGL" in words and "Not measured: smoothing." in words


def test_a_scene_behind_the_eye_is_explained_in_the_table(
    qtbot: QtBot, document: Document, tmp_path: Path
) -> None:
    away = replace(document.projection, camera=Camera((0, 0, 500), (0, 0, 900)))
    panel = MeasurePanel(lambda: replace(document, projection=away), dict, SMOOTHINGS, QWidget())
    qtbot.addWidget(panel)
    panel.show()
    measured(qtbot, panel, "arithmetic")
    assert cells(panel)[0][-1] == MEASURE["no-points"]
    assert panel.sentence.text().startswith(f"Nothing could be measured: {MEASURE['no-points']}.")
    assert panel.list.currentItem().icon().isNull() and panel.progress.value() == 0
    assert panel.export(tmp_path / "nothing.png")


def test_a_process_that_cannot_start_or_dies_is_a_sentence(
    panel: MeasurePanel, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    refused = QSignalSpy(panel.refused)
    monkeypatch.setattr(measuring.modules.sys, "executable", "/nowhere/python")
    panel.choose("depth")
    with qtbot.waitSignal(panel.measuring.finished):
        panel.run()
    assert "cannot be started" in refused.at(0)[0] and not panel.measuring.running
    monkeypatch.undo()
    panel.run()
    with qtbot.waitSignal(panel.measuring.finished):
        process_of(panel).kill()
    assert refused.at(1)[0] == "The measurement ended unexpectedly."
    assert panel.run_button.isEnabled()


# -- using


def test_a_click_on_a_point_or_a_row_uses_the_choice(panel: MeasurePanel, tmp_path: Path) -> None:
    used = QSignalSpy(panel.used)
    assert panel.load(write(tmp_path / "a.json", RESULTS))
    panel.choose("arithmetic")
    click_spot(panel, "good")
    assert [used.at(i)[0] for i in range(used.count())] == [{"rung": "good"}]
    assert panel.table.currentRow() == 2
    click_cell(panel, 0)
    assert used.at(1)[0] == {"rung": "fast"} and used.count() == 2
    (view,) = (view for view in panel.diagrams if view.isVisible())
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, QPoint(2, 2))
    assert used.count() == 2, "a click beside the points uses nothing"


def test_a_choice_that_the_panes_cannot_draw_with_is_not_used(
    panel: MeasurePanel, tmp_path: Path
) -> None:
    used = QSignalSpy(panel.used)
    peers = replace(TRADE, choices=tuple(replace(c, use={}) for c in TRADE.choices))
    panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(peers,))))
    panel.choose("arithmetic")
    click_spot(panel, "good")
    assert not panel.table.selectedItems() and used.count() == 0
    click_cell(panel, 1)
    assert not panel.table.selectedItems() and used.count() == 0
    panel.load(write(tmp_path / "a.json", RESULTS))
    click_cell(panel, 1)
    assert {item.row() for item in panel.table.selectedItems()} == {1} and used.count() == 1


def test_the_caption_says_what_a_clicked_choice_buys_and_pays(
    panel: MeasurePanel, tmp_path: Path
) -> None:
    """Of one that cannot be drawn too, until the document changes."""
    usual = replace(TRADE.choices[2], name="float32", bytes=12.0, use={})
    small = replace(TRADE.choices[0], name="12 bits", error=0.3, predicted=0.4, bytes=4.5, use={})
    trade = replace(TRADE, choices=(usual, small))
    panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(trade,), sweeps=())))
    before = panel.sentence.text()
    click_spot(panel, "12 bits")
    said = "12 bits instead of float32: 10 times faster, at most 0.4 px off."
    assert panel.sentence.text() == f"{said} {before}"
    show(panel, Projection())
    assert panel.sentence.text() == before


def test_a_click_on_a_number_of_a_sweep_uses_its_value_and_its_buffer(
    panel: MeasurePanel, tmp_path: Path
) -> None:
    used = QSignalSpy(panel.used)
    gaps = {name: curve((1.0, 2.0), ("", "")) for name in kept.BUFFERS}
    errors = {"float64, every stage": curve((1.0,), ("",)), "exact": curve((1.0,), ("",))}
    for parameter, values, curves in (
        ("near", (0.5, 2.0), gaps), ("fov", (30.0,), errors), ("up", (30.0,), errors),
    ):  # fmt: skip
        swept = sweep(parameter, values, curves)
        panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(), sweeps=(swept,))))
        panel.choose(parameter)
        for column in (1, 4) if parameter == "near" else (1, 2):
            panel.table.cellClicked.emit(len(values) - 1, column)
    fixed, reversed_ = list(kept.BUFFERS.values())[::3]
    assert [used.at(i)[0] for i in range(used.count())] == [
        {"lens.near": "2.0", **fixed}, {"lens.near": "2.0", **reversed_},
        {"lens.fov_y_deg": "30.0", "rung": "float64"}, {"lens.fov_y_deg": "30.0"},
    ]  # fmt: skip
    for parameter, values, keys in (
        ("near", (0.5, 2.0), {"0,1", "1,1"}), ("up", (30.0, 60.0), set[str]())
    ):  # fmt: skip
        curves = {next(iter(kept.BUFFERS)): curve((1.0, 20.0), ("", ""))}
        swept = sweep(parameter, values, curves)
        panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(), sweeps=(swept,))))
        panel.choose(parameter)
        (diagram,) = (view for view in panel.diagrams if view.isVisible())
        drawn = chart.diagrams(swept, {})[0].curves[0]
        assert set(drawn.keys) == keys
        QTest.mouseClick(
            diagram, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier,
            diagram.to_px(*drawn.points[1]).toPoint(),
        )  # fmt: skip
    assert used.count() == 5 and used.at(4)[0] == {"lens.near": "2.0", **fixed}
    assert (panel.table.currentRow(), panel.table.currentColumn()) == (1, 1)


def test_memory_is_another_axis_of_chart_caption_and_grey(
    panel: MeasurePanel, tmp_path: Path
) -> None:
    sizes = {"fast": 8.0, "bad": 2.0}
    choices = tuple(replace(c, bytes=sizes.get(c.name)) for c in TRADE.choices)
    trade = replace(TRADE, choices=choices)
    panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(trade,), sweeps=())))
    assert set(found(panel.diagrams[0])) == {"fast", "bad", "good", "right", "endless"}
    panel.cost.setCurrentIndex(panel.cost.findData("bytes"))
    panel.diagrams[0].grab()
    assert set(found(panel.diagrams[0])) == set(sizes)
    assert "No choice is cheaper than bad (2 B, off by 2 px)" in panel.sentence.text()
    grey = [
        panel.table.item(row, 0).foreground().style() != Qt.BrushStyle.NoBrush for row in range(5)
    ]
    assert not any(grey), "each of the two is smaller or more exact"
    assert panel.export(tmp_path / "a.png")


def test_the_choice_in_use_is_marked_and_follows(
    panel: MeasurePanel, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    panel.load(write(tmp_path / "a.json", RESULTS))
    panel.choose("arithmetic")

    def marked() -> list[str]:
        return [key for key, (_, is_marked) in found(panel.diagrams[0]).items() if is_marked]

    assert marked() == ["good"]
    monkeypatch.setitem(IN_USE, "rung", "bad")
    show(panel, Projection())
    assert marked() == ["bad"]


# -- files


def test_a_file_of_unknown_measurements_is_refused_and_all_stays(
    panel: MeasurePanel, tmp_path: Path
) -> None:
    refused = QSignalSpy(panel.refused)
    panel.load(write(tmp_path / "good.json", RESULTS))
    before = cells(panel)
    unknown = replace(RESULTS, trades=(replace(TRADE, name="speed"),))
    assert not panel.load(write(tmp_path / "bad.json", unknown))
    assert refused.at(0)[0] == 'bad.json: is damaged: "speed" is nothing that is measured.'
    assert cells(panel) == before and set(panel.loaded) == {"arithmetic", "near"}


# -- look


def test_every_name_of_a_choice_is_put_together_from_translated_parts(
    document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each part is a format's or a program's own name, or is translated."""
    looked_up: list[str] = []

    def translate(text: str) -> str:
        looked_up.append(text)
        return text.upper()

    monkeypatch.setattr(kept, "of_measure", translate)
    projection, scene = document.projection, load("letter-f")
    trades = [
        arithmetic.measure(projection, scene.corners, scene.origin, seconds=0.01),
        interpolation.measure(projection, scene.corners, seconds=0.01),
        depth.measure(projection),
    ]
    own = re.compile(r"(b?float|fixed ?)[\d.]+|PyGLM|pylinalg|FXAA|MSAA \d|\d+ %|ns|ms|px|B|")
    names = [c.name for trade in trades for c in trade.choices]
    names += [each.name for each in smoothing.SMOOTHINGS] + [smoothing.OTHER_SAMPLES.format(4)]
    names += [head for trade in trades for head in table(trade)[0]]
    assert len(names) > 50
    for name in names:
        for part in name.split(", "):
            looked_up.clear()
            said = kept.named(part)
            assert own.fullmatch(part) or set(looked_up) <= set(kept.WORDS), part
            assert own.fullmatch(part) or (looked_up and said == said.upper()), part
    monkeypatch.setattr(
        kept, "of_measure", {"affine": "afina", "{0} pieces": "{0} kom."}.__getitem__
    )
    assert kept.named("affine, 4 pieces") == "afina, 4 kom."


def test_an_unusable_choice_is_in_italics_and_says_why(panel: MeasurePanel, tmp_path: Path) -> None:
    """In italics and in words; grey means something else."""
    usable = ChartPoint("MSAA 2", 2.0, 2.0, 2.0, use={"smoothing": "MSAA 2"})
    winner = "supersampling 3 x 3"
    finer = replace(usable, name=winner, cost=1.0, error=1.0, use={"smoothing": winner})
    peer = ChartPoint("PyGLM", None, None, None, note="not installed")
    trade = Trade("smoothing", "ms", "levels RMS", (usable, finer, peer), 5)
    panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(trade,), sweeps=())))
    refused, used = QSignalSpy(panel.refused), QSignalSpy(panel.used)
    names, italics, greys, tips = [], [], [], []
    for row in range(3):
        cell = panel.table.item(row, 0)
        assert cell is not None
        names.append(cell.text())
        italics.append(cell.font().italic())
        greys.append(cell.foreground().style() != Qt.BrushStyle.NoBrush)
        tips.append(cell.toolTip())
        panel.table.cellClicked.emit(row, 0)
    assert names == ["MSAA 2", f"{winner} (measured only)", "PyGLM"]
    assert italics == [False, True, True]
    assert greys == [True, False, False], "only the first is worse than another one in both"
    assert tips[0] == ""
    assert tips[1] == "supersampling 3 x 3 is only measured: the panes are not drawn with it."
    assert tips[2].splitlines()[0] == "not installed" and tips[2].count("only measured") == 1
    assert used.count() == 1 and refused.count() == 2


def test_table_and_chart_show_the_same_choices_in_grey(panel: MeasurePanel, tmp_path: Path) -> None:
    other = replace(TRADE, choices=tuple(reversed(TRADE.choices)))
    panel.measured = {"arithmetic": replace(RESULTS, trades=(TRADE,), sweeps=())}
    panel.loaded = {"arithmetic": replace(RESULTS, trades=(other,), sweeps=())}
    show(panel, Projection())
    (diagram,) = chart.diagrams(TRADE)
    faded = {spot.key for spot in diagram.spots if spot.faded}
    assert faded and len(faded) < len(diagram.spots)
    names = [panel.table.item(row, 0) for row in range(panel.table.rowCount())]
    grey = [cell.foreground().style() != Qt.BrushStyle.NoBrush for cell in names]
    expected = [choice.name in faded for choice in (*TRADE.choices, *other.choices)]
    assert grey == expected
    ink = names[expected.index(True)].foreground().color()
    assert ink != panel.palette().text().color()


def test_notes_take_the_free_width_and_are_fully_visible(
    panel: MeasurePanel, display: Any, tmp_path: Path
) -> None:
    noted = ChartPoint(
        "MSAA 8", 1.0, 1.0, 2.0, note=MEASURE["no-points"], use={"smoothing": "MSAA 8"}
    )
    trade = Trade("smoothing", "ms", "levels RMS", (noted,), 5)
    panel.resize(700, 300)
    panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(trade,), sweeps=())))
    header, heights = panel.table.horizontalHeader(), []
    least = header.sectionSize(header.count() - 1)
    for width in (700, 1800, 700):
        panel.resize(width, 300)
        display.processEvents()
        room = panel.table.viewport().width() - header.length()
        assert room == 0 or (room < 0 and header.sectionSize(header.count() - 1) == least)
        heights.append(panel.table.rowHeight(0))
        last = panel.table.columnCount() - 1
        inside = panel.table.visualItemRect(panel.table.item(0, last)).adjusted(4, 0, -4, 0)
        wrap = Qt.TextFlag.TextWordWrap
        needed = panel.table.fontMetrics().boundingRect(inside, wrap, MEASURE["no-points"])
        assert needed.width() <= inside.width() and needed.height() <= heights[-1], "not whole"
    assert heights[0] == heights[2] > heights[1]


# -- in the window


@pytest.mark.undrawn
def test_a_drag_in_the_window_makes_it_wait_and_a_sentence_reaches_the_bar(
    window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    panel, waits = window.measure_panel, []
    monkeypatch.setattr(panel.measuring, "set_paused", waits.append)
    for source in (window.controls, window.controls.animation, window.manipulation, window.strip):
        source.gesture_started.emit()
        source.gesture_finished.emit()
        assert waits == [True, False]
        waits.clear()
    assert not panel.load(tmp_path / "gone.json")
    assert window.messages.text.startswith("gone.json: cannot be read")
    assert panel.load(write(tmp_path / "a.json", RESULTS)) and window.messages.text == ""


@pytest.mark.undrawn
def test_a_refusal_stays_until_the_panel_is_used_again(window: MainWindow, tmp_path: Path) -> None:
    panel, bar = window.measure_panel, window.messages
    window.panels.open(panel)
    alone = replace(TRADE.choices[0], name="float16", use={})
    usable = replace(TRADE.choices[2], name="float64", use={"rung": "float64"})
    trade = replace(TRADE, choices=(alone, usable))
    panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(trade,), sweeps=())))
    settle()

    def refuse() -> None:
        panel.table.cellClicked.emit(0, 0)
        assert bar.text == "float16 is only measured: the panes are not drawn with it."

    refuse()
    panel.table.cellClicked.emit(1, 0)
    assert bar.text == "" and window.store.document.quality.rung == "float64"
    refuse()
    click_spot(panel, "float64")
    assert bar.text == ""
    refuse()
    panel.choose("depth")
    assert bar.text == ""
    panel.choose("arithmetic")
    refuse()
    panel.run()
    assert bar.text == ""
    refuse()
    bar.show_message("Something else went wrong.")
    panel.choose("depth")
    assert bar.text == "Something else went wrong.", "that is not the panel's to take back"


@pytest.mark.undrawn
def test_a_cheap_format_opens_the_scene_that_draws_it_and_is_marked_there(
    window: MainWindow, tmp_path: Path
) -> None:
    panel = window.measure_panel
    window.panels.open(panel)
    for name, settings in CHEAP.items():
        drawn = {f"settings.{setting}": value for setting, value in settings.items()}
        choice = ChartPoint(
            name, None, None, 1.0, 2.0, use={"scene": "cheap-arithmetic", **drawn}, bytes=6.0
        )
        trade = replace(TRADE, choices=(replace(TRADE.choices[2], bytes=12.0), choice))
        panel.load(write(tmp_path / "a.json", replace(RESULTS, trades=(trade,), sweeps=())))
        panel.table.cellClicked.emit(1, 0)
        document = window.store.document
        assert document.scene == "cheap-arithmetic" and window.messages.text == "", name
        assert hardware_of(document.settings) == hardware_of(settings), name
        assert chart.in_use(trade, window.quality.in_use()) == choice
        window.store.undo()
        assert window.store.document.scene == "letter-f"


@pytest.mark.undrawn
def test_the_window_reports_the_quality_in_use(window: MainWindow) -> None:
    assert window.quality.in_use()["rung"] == "float32"
    assert window.quality.in_use()["depth_mapping"] == "opengl"
    projection = window.store.document.projection
    window.store.set_projection(
        replace(projection, depth="reversed", lens=Perspective(1e-6, 1.0, 30.0))
    )
    assert window.quality.in_use()["rung"] == "float64"
    assert window.quality.in_use()["depth_mapping"] == "reversed"


@pytest.mark.undrawn
def test_the_window_goes_on_during_a_measurement_and_ends_it_when_it_closes(
    window: MainWindow, qtbot: QtBot
) -> None:
    panel = window.measure_panel
    finished = QSignalSpy(panel.measuring.finished)
    panel.how.setCurrentIndex(1)  # full: it takes half a minute
    with qtbot.waitSignal(panel.measuring.progressed):
        panel.run()
    number, file = int(process_of(panel).processId()), process_of(panel).arguments()[-1]
    ours, its = psutil.Process(), psutil.Process(number)
    assert its.nice() == min(19, ours.nice() + 10), "the window's steps come first"
    projection = window.store.document.projection
    window.store.set_projection(replace(projection, lens=Perspective(30.0, 1.0, 30.0)))
    settle()
    assert window.controls.rows["fov_y_deg"].value() == 30.0
    assert panel.measuring.running
    window.store.mark_saved()  # or it asks
    window.close()
    assert not psutil.pid_exists(number) and not os.path.exists(file)
    assert finished.count() == 0 and not panel.measuring.running


# -- cost


def test_the_cost_of_a_step_is_shown_for_every_pane_that_is_seen(
    window: MainWindow, qtbot: QtBot
) -> None:
    assert not window.status.cost.isVisible()
    pane = window.panes["image"]
    spies = [QSignalSpy(each.timed) for each in window.panes.values()]
    projection = window.store.document.projection
    window.store.set_projection(replace(projection, lens=Perspective(30.0, 1.0, 30.0)))
    settle()
    assert [spy.count() for spy in spies] == [0, 0, 0] and window.cost.costs == {}
    window.menus.show_cost.trigger()
    assert window.status.cost.isVisible()
    with qtbot.waitSignals([each.timed for each in window.panes.values()]):
        window.store.set_projection(replace(projection, lens=Perspective(40.0, 1.0, 30.0)))
    tip = window.status.cost.toolTip()
    assert all(title in tip for title in ("model", "World", "NDC cube", "Image"))
    assert all(ms[0] > 0.0 and ms[1] > 0.0 for ms in window.cost.costs.values())
    assert window.cost.model_ms > 0.0
    pane.hide()
    with qtbot.waitSignal(window.panes["world"].timed):
        window.store.set_projection(replace(projection, lens=Perspective(50.0, 1.0, 30.0)))
    assert "Image" not in window.status.cost.toolTip()
    window.menus.show_cost.trigger()
    counts = [spy.count() for spy in spies]
    window.store.set_projection(projection)
    settle()
    assert [spy.count() for spy in spies] == counts and not window.status.cost.isVisible()
