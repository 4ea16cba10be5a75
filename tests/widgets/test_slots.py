"""Where the panes stand: the large slot, the whole window, columns, windows of their own."""

from collections.abc import Iterator
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QSplitter, QToolButton
from pytestqt.qtbot import QtBot

from app.model.projection import Perspective
from app.scenes.scene import load
from tests.support.window import (
    activate,
    counted_repaints,
    drag,
    present,
    seen,
    settle,
    show_scene,
)
from widgets.window.main_window import MainWindow
from widgets.window.slots import LAYOUTS

LEFT = Qt.MouseButton.LeftButton
CTRL = Qt.KeyboardModifier.ControlModifier
PANES = ("world", "ndc", "image")
IMAGE_LEADS = "field-of-view"


@pytest.fixture
def window(window: MainWindow) -> MainWindow:
    """With the keyboard."""
    activate(window)
    settle()
    return window


def places(window: MainWindow) -> dict[str, tuple[int, int, int, int]]:
    """Left, top, width and height in the window of each pane that is docked and seen."""
    return {
        name: (*pane.mapTo(window, QPoint()).toTuple(), *pane.size().toTuple())
        for name, pane in window.panes.items()
        if pane.isVisible() and not pane.isWindow()
    }


def slots(window: MainWindow) -> tuple[str, ...]:
    """The panes that are docked and seen: from the left, and from above."""
    found = places(window)
    return tuple(sorted(found, key=lambda name: found[name][:2]))


def is_whole(window: MainWindow) -> bool:
    """Whether one pane has all the window below the tool bar; else the rest must be there."""
    beside = [window.controls, window.bottom, window.status, window.panels.names]
    assert len({widget.isVisible() for widget in beside}) == 1
    found = places(window)
    if beside[0].isVisible():
        return False
    ((left, top, width, height),) = found.values()
    below = window.height() - window.menus.tools.geometry().bottom()
    assert width > 0.98 * window.width() and height > 0.97 * below and left < 10 < top
    assert not window.panels.isVisible()
    return True


def press(window: MainWindow, key: str) -> None:
    """A key with Ctrl, wherever the keyboard is."""
    QTest.keyClick(QApplication.focusWidget() or window, getattr(Qt.Key, f"Key_{key}"), CTRL)
    settle()


def by_key(window: MainWindow, name: str) -> None:
    press(window, str(1 + PANES.index(name)))


def by_title(window: MainWindow, name: str) -> None:
    header = window.panes[name].header
    QTest.mouseDClick(header, LEFT, pos=header.rect().center())
    QTest.mouseRelease(header, LEFT, pos=header.rect().center())
    settle()


def by_button(window: MainWindow, name: str) -> None:
    (button,) = (
        button
        for button in window.panes[name].findChildren(QToolButton)
        if button.toolTip().startswith("Enlarge")
    )
    QTest.mouseClick(button, LEFT)
    settle()


@pytest.mark.undrawn
def test_a_pane_is_brought_into_the_large_slot_then_alone_and_back(window: MainWindow) -> None:
    window.panels.open(window.matrices)
    settle()
    for bring in (by_key, by_title, by_button):
        assert slots(window) == ("world", "image", "ndc") and not is_whole(window)
        for name, beside in (("image", ("world", "ndc")), ("ndc", ("world", "image"))):
            bring(window, name)
            assert slots(window) == (name, *beside)
            found = places(window)
            assert all(found[name][2] > found[other][2] for other in beside)
            assert all(found[name][3] > 1.8 * found[other][3] for other in beside)
            assert not is_whole(window)
            bring(window, name)
            assert slots(window) == (name,) and is_whole(window)
            bring(window, name)
            assert places(window) == found and not is_whole(window)
            assert window.panels.open_panel is window.matrices
        press(window, "0")
    assert not window.store.can_undo and not window.isWindowModified()


@pytest.mark.undrawn
@pytest.mark.undrawn
@pytest.mark.parametrize("name", PANES)
def test_the_focus_stays_in_a_pane_that_moves(window: MainWindow, name: str) -> None:
    """A hidden pane gives it to the one that fills the window, not to a control."""
    canvases = {each: pane.canvas for each, pane in window.panes.items()}
    canvases[name].setFocus()
    for large in (*PANES, *PANES):
        window.slots.arrange("pictures", large)
        assert canvases[name].hasFocus(), large
    for layout in LAYOUTS[::-1]:
        window.slots.arrange(layout, "image")
        assert canvases[name].hasFocus(), layout
    for _ in range(2):
        window.comparing.toggle()
        assert canvases[name].hasFocus(), "F6"
    window.slots.arrange("pictures", "ndc", "ndc")
    assert canvases["ndc"].hasFocus()
    window.slots.make_large("ndc")
    assert canvases["ndc"].hasFocus()


@pytest.mark.undrawn
@pytest.mark.parametrize("whole", ["", "world"])
def test_no_pane_that_a_class_does_not_see_has_the_focus(window: MainWindow, whole: str) -> None:
    window.slots.arrange("pictures", "world", whole)
    present(window)
    window.panes["world"].canvas.setFocus()
    window.slots.make_large("image")
    settle()
    assert slots(window) == ("image",) and window.hasFocus()


@pytest.mark.undrawn
def test_a_pane_that_fills_the_window_takes_the_focus_of_a_hidden_control(
    window: MainWindow,
) -> None:
    """Otherwise Qt gives it to the choice of scenes, where an arrow opens another scene."""
    window.panels.open(window.matrices)
    settle()
    for control in (window.controls.search, window.matrices.views["view_from_world"]):
        control.setFocus()
        assert control.hasFocus()
        window.slots.make_large("world")
        settle()
        assert is_whole(window) and window.panes["world"].canvas.hasFocus()
        window.slots.make_large("world")
        settle()


def test_ctrl_0_goes_back_to_how_the_scene_opens(window: MainWindow) -> None:
    start = places(window)
    for name in ("image", "image", "ndc"):
        by_key(window, name)
    window.slots.toggle_float("world")
    settle()
    assert slots(window) == ("ndc",)
    press(window, "0")
    assert places(window) == start and window.slots.floating == ()
    show_scene(window, IMAGE_LEADS)
    by_key(window, "world")
    press(window, "0")
    assert slots(window) == ("image", "world", "ndc")


@pytest.mark.undrawn
def test_esc_leaves_what_is_on_top_first(window: MainWindow) -> None:
    window.probe_panel.follow(point=(0.0, 0.0, 0.0))
    by_key(window, "image")
    by_key(window, "image")
    window.messages.show_message("A refusal.")
    settle()

    def escape() -> tuple[bool, bool, int]:
        QTest.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_Escape)
        settle()
        return bool(window.messages.text), is_whole(window), len(window.probe_panel.probes)

    assert escape() == (False, True, 1)
    assert escape() == (False, False, 1)
    assert slots(window) == ("image", "world", "ndc")
    assert escape() == (False, False, 0)


@pytest.mark.undrawn
def test_columns_and_back(window: MainWindow) -> None:
    start = places(window)
    action = next(a for a in all_actions(window) if a.text() == "Panes in col&umns")
    assert not action.isChecked()
    action.trigger()
    settle()
    assert slots(window) == PANES and action.isChecked()
    found = places(window)
    assert len({(top, height) for _, top, _, height in found.values()}) == 1, "side by side"
    by_key(window, "ndc")
    assert slots(window) == ("ndc",) and is_whole(window), "in columns none is larger"
    by_key(window, "ndc")
    assert places(window) == found and action.isChecked()
    action.trigger()
    settle()
    assert not action.isChecked() and slots(window) == ("ndc", "world", "image")
    by_key(window, "world")
    assert places(window) == start


def all_actions(window: MainWindow) -> Iterator[Any]:
    """Of the menus."""
    for menu in window.menuBar().actions():
        yield from menu.menu().actions()


def test_docked_panes_take_the_room_of_floating_ones(window: MainWindow, qtbot: QtBot) -> None:
    changed: list[Perspective] = []
    for layout, afloat in [
        ("pictures", ("world",)),
        ("columns", ("image",)),
        ("pictures", ("ndc",)),
        ("columns", ("world", "ndc")),
        ("pictures", PANES),
    ]:
        window.slots.arrange(layout, "world")
        settle()
        order = PANES if layout == "columns" else ("world", "image", "ndc")
        start = places(window)
        assert slots(window) == order
        for name in afloat:
            window.slots.toggle_float(name)
            qtbot.waitExposed(window.panes[name])
        settle()
        docked = tuple(name for name in order if name not in afloat)
        assert window.slots.floating == afloat and slots(window) == docked
        assert all(pane.isVisible() for pane in window.panes.values())

        def ends(found: dict[str, tuple[int, int, int, int]]) -> tuple[int, int]:
            rooms = found.values()
            return max(left + width for left, _, width, _ in rooms), max(
                top + height for _, top, _, height in rooms
            )

        if docked:
            assert ends(places(window)) == ends(start), "no gap"
        with counted_repaints(window) as counts:
            lens = Perspective(46.0 + len(changed), 1.0, 30.0)
            changed.append(lens)
            window.store.set_projection(seen(window, lens=lens))
            settle()
        assert counts == dict.fromkeys(PANES, 1)
        for name in afloat:
            window.panes[name].close()  # by the button of its window
            settle()
        assert window.slots.floating == () and places(window) == start


@pytest.mark.undrawn
def test_a_floating_pane_stays_afloat_whatever_is_brought(window: MainWindow, qtbot: QtBot) -> None:
    window.slots.toggle_float("image")
    qtbot.waitExposed(window.panes["image"])
    settle()
    for bring in (by_key, by_title, by_button):
        bring(window, "image")
        assert window.slots.floating == ("image",) and slots(window) == ("world", "ndc")
        assert not is_whole(window)
    by_key(window, "ndc")
    assert slots(window) == ("ndc", "world")
    by_key(window, "ndc")
    assert slots(window) == ("ndc",) and is_whole(window) and window.panes["image"].isVisible()
    window.panes["image"].close()
    settle()
    assert slots(window) == ("ndc",) and is_whole(window)
    by_key(window, "ndc")
    assert slots(window) == ("ndc", "world", "image")


@pytest.mark.undrawn
def test_dragged_sizes_are_kept_when_panes_are_swapped(window: MainWindow) -> None:
    (small,) = window.slots.findChildren(QSplitter)
    drag(window.slots, 1, QPoint(-70, 0))
    drag(small, 1, QPoint(0, 40))
    chosen = sorted(places(window).values())
    for name in ("image", "ndc", "world"):
        by_key(window, name)
        assert slots(window)[0] == name
        assert sorted(places(window).values()) == chosen
    by_key(window, "world")  # alone
    by_key(window, "world")
    assert sorted(places(window).values()) == chosen
    press(window, "0")
    assert sorted(places(window).values()) != chosen, "back to how it opens"


@pytest.mark.undrawn
def test_a_scene_brings_the_pane_that_it_is_about_and_undo_brings_back(window: MainWindow) -> None:
    assert load(IMAGE_LEADS).leading == "image" and load("cube").leading == "world"
    window.files.choose_scene(IMAGE_LEADS)
    settle()
    assert slots(window) == ("image", "world", "ndc")
    by_key(window, "ndc")
    window.store.set_projection(seen(window, lens=Perspective(46.0, 1.0, 30.0)))
    settle()
    assert slots(window)[0] == "ndc", "what was chosen stays while the scene does"
    window.store.undo()
    window.store.undo()
    settle()
    assert window.store.document.scene == "letter-f" and slots(window) == ("world", "image", "ndc")
    window.store.redo()
    settle()
    assert slots(window) == ("ndc", "world", "image"), "as it was left"
    by_key(window, "image")
    by_key(window, "image")
    window.files.choose_scene("cube")
    settle()
    assert slots(window) == ("world",) and is_whole(window)


def test_after_every_arrangement_a_change_repaints_each_visible_pane_once(
    window: MainWindow,
) -> None:
    fov_deg = 46.0
    for layout, large, whole in (
        *((layout, large, "") for layout in LAYOUTS for large in PANES),
        *((layout, large, large) for layout in LAYOUTS for large in PANES),
    ):
        window.slots.arrange(layout, large, whole)
        settle()
        fov_deg += 1.0
        with counted_repaints(window) as counts:
            window.store.set_projection(seen(window, lens=Perspective(fov_deg, 1.0, 30.0)))
            settle()
        assert counts == {name: int(whole in ("", name)) for name in PANES}, (layout, whole)


def test_arranging_draws_nothing_that_is_hidden_or_stays(window: MainWindow) -> None:
    with counted_repaints(window) as counts:
        window.slots.arrange("pictures", "world")
        press(window, "0")
        assert counts == dict.fromkeys(PANES, 0)
        by_key(window, "ndc")
        by_key(window, "ndc")
        before = dict(counts)
        window.slots.arrange("columns", "ndc", "ndc")
        window.slots.arrange("columns", "image", "image")
        settle()
    assert (counts["world"], counts["ndc"]) == (before["world"], before["ndc"])
    assert counts["image"] > before["image"]
