"""What a lecturer prepares comes back as it was; what is seen is what a figure shows."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QDialogButtonBox,
    QFileDialog,
    QLineEdit,
    QMessageBox,
    QStatusBar,
    QToolButton,
)

from app.document.document import Document
from app.document.files import read, write
from app.document.lengths import DPI, Size
from app.document.view import View
from app.drawings.style import Style
from app.drawings.world import WorldDrawing
from app.model.projection import Camera
from app.picking.picking import Probe
from app.scenes.scene import load
from tests.support.drawings import figure_of
from tests.support.window import (
    MakeWindow,
    activate,
    click,
    counted_repaints,
    edit,
    pixels,
    settle,
    turn,
)
from widgets.parts.icons import Combo
from widgets.window.export_dialog import ExportDialog
from widgets.window.lesson_card import TOUR
from widgets.window.main_window import MainWindow
from widgets.window.pictures import Pictures
from widgets.window.settings import data_folder

PREPARED = View(
    stage=1.75,
    frame_step="u",
    panel="frame",
    letters="002",
    probes=(Probe(1, (0.5, 2.5, 0.5)), Probe(3, None, (640.0, 200.0))),
    pinned=frozenset({3}),
    panes={
        "world": Camera((0.0, 30.0, 12.0), (0.0, 1.0, 0.0), (0.0, 1.0, 0.0)),
        "second-screen": Camera(),
    },
)


@pytest.fixture(autouse=True)
def nothing_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """A question before a class would stand there until the hour is over."""

    def ask(box: QMessageBox) -> int:
        raise AssertionError(f"it was asked: {box.text()}")

    monkeypatch.setattr(QMessageBox, "exec", ask)


@pytest.fixture
def prepared(tmp_path: Path) -> Path:
    """A document that somebody has prepared."""
    path = tmp_path / "prepared.json"
    write(Document("cube", load("cube").start, view=PREPARED), path)
    return path


def open_panel(window: MainWindow, name: str) -> None:
    """Open a panel of the drawer by its name."""
    (button,) = (b for b in window.findChildren(QToolButton) if b.text() == name)
    click(button)


def is_as(view: View, other: View) -> bool:
    """Whether two views are one, but for the last digits of cameras that VTK has held."""
    if replace(view, panes={}) != replace(other, panes={}) or set(view.panes) != set(other.panes):
        return False
    return all(
        getattr(view.panes[name], key) == pytest.approx(getattr(camera, key), rel=1e-12, abs=1e-12)
        for name, camera in other.panes.items()
        for key in ("eye", "target", "up")
    )


# -- there and back


def test_an_arrangement_made_by_hand_comes_back_from_its_file(
    window: MainWindow, tmp_path: Path
) -> None:
    open_panel(window, "Matrices")
    QTest.keyClick(window.matrices.letters, Qt.Key.Key_Down)
    open_panel(window, "Camera frame")
    for _ in range(3):
        click(window.frame_panel.next)
    click(window.strip.stops[2])
    window.probe_panel.follow(point=(0.5, 2.7, 0.5))
    click(window.probe_panel.pin)
    window.probe_panel.follow(point=(-0.5, 1.0, 0.5))
    turn(window, "world")
    turn(window, "ndc")
    settle()
    assert not window.store.modified and not window.isWindowModified()
    assert not window.store.can_undo, "a change of view is no step"
    view = window.store.seen.view
    assert (view.stage, view.frame_step, view.panel, view.letters) == (2.0, "n", "frame", "000")
    assert [probe.number for probe in view.probes] == [1, 2] and view.pinned == {1}
    assert set(view.panes) == {"world", "ndc"}
    QTest.mouseMove(window.windowHandle(), QPoint(window.width() - 4, 2))  # points at nothing
    settle()
    there = {name: pixels(window, name) for name in window.panes}
    mine, other = tmp_path / "mine.json", tmp_path / "other.json"
    assert window.files.save_to(mine)
    assert read(mine).view == view
    write(Document("posts", load("posts").start, view=View(panel="")), other)
    assert window.files.open(other)
    settle()
    assert window.store.seen.view == View(panel="")
    assert window.files.open(mine)
    settle()
    assert is_as(window.store.seen.view, view)
    for name, picture in there.items():
        assert (pixels(window, name) == picture).all(), name


def test_a_window_opens_as_its_document_says(make_window: MakeWindow, prepared: Path) -> None:
    saved = read(prepared)
    window = make_window(saved, path=prepared)
    settle()
    assert is_as(window.store.seen.view, PREPARED)
    assert window.strip.position == 1.75 and window.panels.open_panel is window.frame_panel
    assert not window.store.modified
    assert window.files.save()
    assert is_as(read(prepared).view, PREPARED), "what this window cannot show is kept too"
    shown = replace(saved, view=View(stage=3.0))  # as the command line sets it
    window = make_window(shown, saved=saved, path=prepared)
    assert window.strip.position == 3.0
    assert not window.store.modified and not window.store.can_undo


def test_a_view_is_changed_by_what_shows_it_and_nothing_else_is_painted(window: MainWindow) -> None:
    turn(window, "world")
    click(window.strip.stops[1])
    told = []
    window.store.changed.connect(told.append)
    before = window.store.seen.view
    window.store.set_view(stage=3.0, letters="003", panel="matrices")
    settle()
    assert is_as(
        window.store.seen.view, replace(before, stage=3.0, letters="003", panel="matrices")
    )
    with counted_repaints(window) as counts:
        window.store.set_view(stage=2.0)
        settle()
    assert counts == {"world": 0, "ndc": 1, "image": 0}
    assert not told and not window.store.can_undo and not window.store.modified
    edit(window)
    settle()
    view = replace(before, stage=2.0, letters="003", panel="matrices")
    assert window.store.seen.view == view, "an edit leaves it alone"
    turn(window, "ndc")
    view = window.store.seen.view
    window.history.undo()
    settle()
    assert window.store.seen.view == view, "so does its undo"


# -- from file to file


def test_a_file_is_opened_over_a_changed_view_and_undo_brings_the_view_back(
    window: MainWindow, prepared: Path, tmp_path: Path
) -> None:
    assert window.files.save_to(tmp_path / "mine.json")
    click(window.strip.stops[1])
    turn(window, "world")
    view = window.store.seen.view
    assert window.files.open(prepared)
    settle()
    assert window.statusBar().currentMessage() == ""
    click(window.strip.stops[5])
    window.history.undo()
    settle()
    assert is_as(window.store.seen.view, view)
    assert window.files.path == tmp_path / "mine.json"
    assert window.windowTitle().startswith("mine.json")
    window.history.redo()
    settle()
    assert is_as(window.store.seen.view, replace(PREPARED, stage=5.0)), "as it was left"
    assert window.files.path == prepared


@pytest.mark.undrawn
def test_unsaved_work_is_undone_to_and_is_in_recovery_meanwhile(
    window: MainWindow, prepared: Path, tmp_path: Path
) -> None:
    mine = tmp_path / "mine.json"
    assert window.files.save_to(mine)
    edit(window)
    settle()
    work, panes = window.store.document, window.split.height()
    assert window.files.open(prepared)
    settle()
    assert window.status.currentMessage() == "Undo brings back the unsaved changes to mine.json."
    assert window.findChildren(QStatusBar) == [window.status], "and no second one below it"
    assert window.split.height() == panes, "nor less room for the panes"
    assert not window.isWindowModified() and window.windowTitle().startswith("prepared.json")
    (copy,) = data_folder().glob("autosave-*.json")
    assert read(copy) == work
    window.menus.undo.trigger()
    assert window.store.document == work and window.isWindowModified()
    assert window.files.path == mine and window.windowTitle().startswith("mine.json")
    assert window.status.currentMessage() == "", "it is brought back"
    window.lesson_card.open(TOUR)
    said = "Close the lesson, and Undo brings back the unsaved changes to mine.json."
    assert window.status.currentMessage() == said and not window.menus.undo.isEnabled()
    window.lesson_card.leave()
    window.history.undo()
    assert window.store.document == work
    assert window.files.save(), "and not over the file that was opened meanwhile"
    assert read(mine) == work and read(prepared).scene == "cube"
    window.recovery.autosave.save_now()
    assert not list(data_folder().glob("autosave-*.json")), "saved work needs no copy"


@pytest.mark.undrawn
def test_unsaved_work_behind_another_file_is_offered_by_the_next_window(
    make_window: MakeWindow, prepared: Path
) -> None:
    window = make_window(shown=False)
    edit(window)
    work = window.store.document
    assert window.files.open(prepared)
    other = make_window(shown=False)
    settle()
    assert other.messages.text == "", "the window lives that can undo to it"
    assert window.close(), "of what is before it nothing is unsaved"
    other.recovery.offer()
    assert other.messages.text.startswith("There is unsaved work from ")
    other.messages.choices[0].click()
    assert other.store.document == work and other.store.modified
    other.history.undo()
    assert other.store.document == Document("letter-f", load("letter-f").start)


def test_another_scene_keeps_the_preparation_and_forgets_what_belongs_to_the_previous_scene(
    window: MainWindow,
) -> None:
    click(window.strip.stops[2])
    window.probe_panel.follow(point=(0.5, 2.7, 0.5))
    turn(window, "world")
    view = window.store.seen.view
    window.guide.choose("cube")
    settle()
    assert window.store.seen.view == View(stage=2.0, panel="")
    window.history.undo()
    settle()
    assert is_as(window.store.seen.view, view)


# -- what is seen is exported


def likeness(one: np.ndarray, other: np.ndarray) -> float:
    """How far two pictures are from each other, on average over what is drawn in one of them."""
    drawn = (one < 250).any(axis=2) | (other < 250).any(axis=2)
    return float(np.abs(one[drawn].astype(float) - other[drawn]).mean())


def as_figure(window: MainWindow, pane: str, view: View) -> np.ndarray:
    """A pane as a figure of the same size, with letters of the same size."""
    shape = pixels(window, pane).shape
    document = window.store.document
    scene = load(document.scene)
    styles: list[Style] = []
    window.look.built.connect(styles.append)
    window.look.rebuild()
    settle()
    text_pt = styles[-1].font_size * 72.0 / DPI
    size = shape[1], shape[0]
    return figure_of(scene, document.projection, (pane,), size, view=view, text_pt=text_pt).pixels()


def test_a_figure_is_the_pane_at_every_stage(window: MainWindow) -> None:
    window.probe_panel.follow(point=(0.5, 2.7, 0.5))
    for stage, other in ((0.0, 1.0), (1.5, 3.0), (5.0, 4.0)):
        window.strip.go_to(stage)
        settle()
        view, there = window.store.seen.view, pixels(window, "ndc")

        def away(view: View, there: np.ndarray = there) -> float:
            return likeness(as_figure(window, "ndc", view), there)

        same = away(view)
        assert same < 0.5 * away(replace(view, stage=other)), stage
        assert stage != 1.5 or same < away(replace(view, probes=()))


def test_a_figure_is_the_world_at_every_step_of_the_frame(window: MainWindow) -> None:
    open_panel(window, "Camera frame")
    for step in ("eye", "look", "up", "n", "u", "v", "view"):
        settle()
        view, there = window.store.seen.view, pixels(window, "world")
        assert view.frame_step == step
        if step not in ("eye", "up", "view"):  # the others draw no other kinds of things
            click(window.frame_panel.next)
            continue
        same = likeness(as_figure(window, "world", view), there)
        other = likeness(as_figure(window, "world", replace(view, panel="")), there)
        assert same < other, step
        click(window.frame_panel.next)


@pytest.mark.undrawn
def test_the_window_exports_what_the_command_line_draws_of_its_document(
    window: MainWindow, tmp_path: Path, prepared: Path
) -> None:
    assert window.files.open(prepared)
    click(window.strip.stops[2])
    settle()
    out = tmp_path / "figure.png"
    figure = window.pictures.figure(panes=("world", "ndc"), size=(400, 200), text_pt=4.0)
    assert window.pictures.export(out, figure)
    document = read(out)
    assert is_as(document.view, replace(PREPARED, stage=2.0))
    again = figure_of(
        load("cube"), document.projection, ("world", "ndc"), (400, 200), view=document.view,
        text_pt=4.0,
    ).pixels()  # fmt: skip
    assert (np.asarray(Image.open(out)) == again).all()
    window.pictures.copy()
    assert QApplication.clipboard().mimeData().hasImage()
    drawn = replace(figure, panes=("ndc",), size=Size(2, 2, "cm"), text_pt=None, hidden="grey")
    assert window.pictures.export(tmp_path / "a.svg", drawn)
    text = (tmp_path / "a.svg").read_text(encoding="utf-8")
    assert 'width="20mm"' in text and "<desc>The eye is at (" in text


@pytest.mark.undrawn
def test_the_export_dialog_takes_the_size_of_letters_in_points(make_window: MakeWindow) -> None:
    window = make_window(shown=False)
    titles = {name: pane.accessibleName() for name, pane in window.panes.items()}
    shown = window.pictures.figure()
    dialog = ExportDialog(titles, shown, window)
    names = {field.accessibleName(): field for field in dialog.findChildren(QLineEdit)}
    letters = names["Height of the letters in points"]
    save = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)
    assert letters.text() == "6.6" and dialog.figure().text_pt is None
    names["Height of the picture"].setText("300")
    assert letters.text() == "3.3", "as usual for the size"
    letters.selectAll()
    QTest.keyClicks(letters, "7,5")
    assert dialog.figure().text_pt == 7.5 and save.isEnabled()
    names["Height of the picture"].setText("600")
    assert letters.text() == "7,5", "what was typed stays"
    combos = {combo.itemText(1): combo for combo in dialog.findChildren(Combo)}
    combos["mm"].setCurrentIndex(1)
    assert dialog.figure().size == Size(152.4, 50.8, "mm") and save.isEnabled()
    for name in ("SVG", "dashed", "for print", "in a column"):
        combos[name].setCurrentIndex(1)
    asked = dialog.figure()
    assert asked == replace(
        shown, size=asked.size, text_pt=7.5, column=True, palette="print", hidden="dashed"
    )
    again = ExportDialog(titles, shown, window, kept=json.loads(json.dumps(dialog.kept)))
    assert (again.figure(), again.ending) == (asked, "svg")
    for wrong in ("0", "-1", "1e9", "nan", "big", ""):
        letters.selectAll()
        QTest.keyClick(letters, Qt.Key.Key_Delete)
        QTest.keyClicks(letters, wrong)
        assert not save.isEnabled(), wrong


@pytest.mark.undrawn
def test_the_export_dialog_begins_with_the_choice_of_the_last_export(
    make_window: MakeWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window, path = make_window(shown=False), tmp_path / "a.svg"
    begun, answers, exported = list[str](), [0, 1, 1], list[Path]()

    def choose_svg(dialog: ExportDialog) -> int:
        (format_,) = (each for each in dialog.findChildren(Combo) if each.itemText(1) == "SVG")
        begun.append(format_.currentText())
        format_.setCurrentIndex(1)
        return answers.pop(0)

    monkeypatch.setattr(ExportDialog, "exec", choose_svg)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    monkeypatch.setattr(Pictures, "export", lambda _, to, figure: exported.append(to))
    for _ in range(3):
        window.pictures.export_dialog()
    assert begun == ["PNG", "PNG", "SVG"], "a choice that is cancelled is not kept"
    assert exported == [path, path]


def test_everything_is_named_and_again_only_what_the_scene_is_about(
    window: MainWindow, tmp_path: Path
) -> None:
    """The switch is kept with the document, and is no undo step."""
    assert window.menus.name_everything.shortcut().toString() == "N"
    drawing = window.panes["world"].drawing
    assert isinstance(drawing, WorldDrawing) and window.arrangement.view.names is None
    target, own = drawing.camera.discs["target"], pixels(window)
    window.menus.name_everything.trigger()
    settle()
    assert window.menus.name_everything.isChecked() and target.GetVisibility()
    assert window.arrangement.view.names == ("*",) and not window.store.can_undo
    write(window.store.seen, str(tmp_path / "all.json"))
    assert read(str(tmp_path / "all.json")).view.names == ("*",)
    window.menus.name_everything.trigger()
    settle()
    assert window.arrangement.view.names is None
    assert np.array_equal(pixels(window), own)


@pytest.mark.undrawn
def test_a_switch_back_from_everything_finds_the_names_that_were_chosen(window: MainWindow) -> None:
    window.arrangement.show(replace(View(), names=("near", "u")))
    window.menus.name_everything.trigger()
    window.menus.name_everything.trigger()
    assert window.arrangement.view.names == ("near", "u")


def test_a_scene_opens_from_its_own_viewpoint(window: MainWindow) -> None:
    window.files.choose_scene("similar-triangles")
    settle()
    drawing = window.panes["world"].drawing
    assert drawing is not None and drawing.fixed == "side"
    assert window.arrangement.view.fixed is None
    window.files.choose_scene("eye-plane")
    settle()
    drawing = window.panes["world"].drawing
    assert drawing is not None and drawing.fixed == ""


@pytest.mark.undrawn
def test_the_wheel_changes_no_choice_and_no_stage_on_its_way(window: MainWindow) -> None:
    """It opened another scene, and took other letters while it scrolled the Matrices."""
    activate(window)
    window.panes["world"].canvas.setFocus()
    for panel in (window.matrices, window.measure_panel):
        window.panels.open(panel)
        settle()
        boxes = [box for box in window.findChildren(Combo) if box.isVisible() and box.count() > 1]
        assert len(boxes) >= 4
        before = window.store.seen, [box.currentIndex() for box in boxes]
        for each in (*boxes, window.strip.slider):
            at = each.mapTo(window, each.rect().center())
            for turned in (-120, 120, 120):
                QTest.wheelEvent(window.windowHandle(), at, QPoint(0, turned))
        settle()
        assert (window.store.seen, [box.currentIndex() for box in boxes]) == before
        assert window.store.seen.view == before[0].view
    window.strip.slider.setFocus()
    QTest.wheelEvent(window.windowHandle(), at, QPoint(0, -120))
    assert window.strip.position < 4.0
