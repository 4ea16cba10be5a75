"""Speed and accuracy as one of the first things: the trades as pictures, each with its price."""

import json
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QToolButton

from app.bootstrap import ROOT
from app.document.document import Document
from app.measure import chart
from app.measure.meaning import GIVEN_UP, bargain, boldest
from app.measure.measuring import TRADES
from app.measure.results import SWEPT
from app.measure.single import SHIPPED, shipped
from app.scenes.scene import BUILT_IN, load
from tests import PATIENCE_MS
from tests.support.layout import cut, overlapping
from tests.support.window import activate, click, rgb_of, settle, show_scene
from widgets.window import trades_card
from widgets.window.main_window import MainWindow
from widgets.window.start_card import StartCard
from widgets.window.trades_card import TradesCard


def opened(window: MainWindow) -> TradesCard:
    """The card, from the start card, where it stands beside lessons and talks."""
    window.menus.start_card.trigger()
    settle()
    start = window.cover
    assert isinstance(start, StartCard)
    (button,) = (b for b in start.findChildren(QToolButton) if b.text() == "Speed and accuracy")
    click(button)
    settle()
    card = window.cover
    assert isinstance(card, TradesCard) and card.isVisible()
    return card


def said(tile: QToolButton) -> list[str]:
    return [label.text() for label in tile.findChildren(QLabel) if label.text()]


def is_drawn(tile: QToolButton) -> bool:
    return any(not label.pixmap().isNull() for label in tile.findChildren(QLabel))


def test_every_trade_is_a_picture_in_every_window(window: MainWindow, qtbot: Any) -> None:
    for size in ((1366, 768), (1000, 600)):
        window.resize(*size)
        settle()
        card = opened(window)
        assert list(card.tiles) == list(TRADES)
        settle()
        before = [tile.geometry() for tile in card.tiles.values()]
        qtbot.waitUntil(
            lambda card=card: all(map(is_drawn, card.tiles.values())), timeout=PATIENCE_MS
        )
        assert [tile.geometry() for tile in card.tiles.values()] == before, "none moves"
        pictures = [rgb_of(tile.grab().toImage()) for tile in card.tiles.values()]
        assert len({picture.tobytes() for picture in pictures}) == len(TRADES)
        assert all(np.ptp(picture[:60], axis=(0, 1)).max() > 100 for picture in pictures)
        assert card.rect().contains(card.card.geometry())
        assert cut(card) == [] and overlapping(card) == []


@pytest.mark.undrawn
def test_a_trade_that_cannot_be_drawn_is_there_by_its_name(
    window: MainWindow, qtbot: Any, monkeypatch: pytest.MonkeyPatch, caplog: Any
) -> None:
    def broken(name: str) -> Any:
        if name == "drift":
            raise RuntimeError("no picture of it")
        return load(name)

    monkeypatch.setattr(trades_card, "load", broken)
    card = opened(window)
    others = [tile for name, tile in card.tiles.items() if name != "drift"]
    qtbot.waitUntil(lambda: all(map(is_drawn, others)), timeout=PATIENCE_MS)
    assert not is_drawn(card.tiles["drift"]) and "drift cannot be drawn" in caplog.text
    click(card.tiles["drift"])
    assert window.store.document.scene == "drift"


@pytest.mark.undrawn
def test_each_says_what_is_given_up_and_the_shipped_price(window: MainWindow) -> None:
    tiles = opened(window).tiles
    for name, tile in tiles.items():
        assert said(tile)[:2] == [chart.TITLES[name], GIVEN_UP[name]]
        assert tile.accessibleName() == chart.TITLES[name] and tile.accessibleDescription()
    # Recomputed from the file.
    trades = {
        trade["name"]: trade for trade in json.loads(SHIPPED.read_text(encoding="utf-8"))["trades"]
    }

    def row(trade: str, name: str) -> Any:
        return next(c for c in trades[trade]["choices"] if c["name"] == name)

    bits, usual = row("arithmetic", "8 bits"), row("arithmetic", "float32")
    off = max(bits["error"], bits["predicted"])
    times = usual["bytes"] / bits["bytes"]
    text = f"8 bits instead of float32: {times:.2g} times smaller, at most {off:.2g} px off."
    assert said(tiles["arithmetic"])[2] == text
    affine, usual = row("interpolation", "affine"), row("interpolation", "perspective-correct")
    times, off = usual["cost"] / affine["cost"], max(affine["error"], affine["predicted"])
    assert said(tiles["interpolation"])[2] == (
        f"affine instead of perspective-correct: {times:.2g} times faster,"
        f" at most {off:.2g} texels off."
    )


@pytest.mark.undrawn
def test_a_trade_without_results_says_so(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    rest = {name: each for name, each in shipped().items() if name != "detail"}
    monkeypatch.setattr(trades_card, "shipped", lambda: rest)
    tiles = opened(window).tiles
    assert [said(tile)[2] for tile in tiles.values() if said(tile)[0] == "Detail"] == [
        "Not measured yet."
    ]


@pytest.mark.undrawn
def test_a_click_opens_its_scene_and_the_panel_on_it(window: MainWindow) -> None:
    window.slots.arrange("columns", window.slots.large, "")
    panel, begun = window.measure_panel, Document("letter-f", load("letter-f").start)
    scenes = {
        "arithmetic": "cheap-arithmetic", "depth": "depth-buffer", "smoothing": "letter-f",
        "detail": "far-plane-popping",
    }  # fmt: skip
    for name in TRADES:
        click(opened(window).tiles[name])
        settle()
        assert window.cover is None
        assert window.store.document.scene == scenes.get(name, name)
        assert window.panels.open_panel is panel and panel.name == name
        assert window.slots.layout_name == "columns", "what was prepared for a class stays"
        results = shipped().get(name)
        bold = None if results is None else boldest(results.trades[0])
        if results is not None and bold is not None:
            cost, choice = bold
            assert panel.cost.currentData() == cost
            assert bargain(results.trades[0].by_cost(cost), choice) in panel.sentence.text()
        window.store.undo()
        assert window.store.document == begun, "one undo step"
        window.panels.open(None)


@pytest.mark.undrawn
def test_the_keyboard_is_enough(window: MainWindow) -> None:
    activate(window)
    window.menus.start_card.trigger()
    settle()
    for key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
        start = window.cover
        assert isinstance(start, StartCard)
        for _ in range(60):
            focused = QApplication.focusWidget()
            if isinstance(focused, QToolButton) and focused.text() == "Speed and accuracy":
                break
            QTest.keyClick(focused, Qt.Key.Key_Tab)
        QTest.keyClick(QApplication.focusWidget(), key)
        settle()
        card = window.cover
        assert isinstance(card, TradesCard)
        assert QApplication.focusWidget() is card.tiles["arithmetic"]
        if key == Qt.Key.Key_Return:
            (back,) = (
                b for b in card.findChildren(QToolButton) if b.accessibleName() == "Start card"
            )
            QTest.keyClick(back, Qt.Key.Key_Space)
            settle()
    QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
    QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Return)
    settle()
    assert window.cover is None and window.store.document.scene == "interpolation"
    window.menus.trades.trigger()
    settle()
    QTest.keyClick(window, Qt.Key.Key_Escape)
    settle()
    assert window.cover is None and window.store.document.scene == "interpolation"


@pytest.mark.undrawn
def test_precision_opens_with_a_chart_of_the_scene(window: MainWindow) -> None:
    """It is that of the trade which the scene shows, or else that of arithmetic."""
    panel = window.measure_panel
    trades = {
        "interpolation": "interpolation", "depth-buffer": "depth", "far-plane-popping": "detail",
    } | {name: name for name in TRADES if name in BUILT_IN}  # fmt: skip
    for scene in (*trades, "letter-f", "focus"):
        show_scene(window, scene)
        window.panels.open(panel)
        settle()
        assert panel.name == trades.get(scene, "arithmetic"), scene
        if panel.name in shipped():
            (view,) = (view for view in panel.diagrams if view.isVisible())
            assert not view.frame.isEmpty() and panel.table.rowCount(), scene
            assert "with the letter F on another machine" in panel.sentence.text(), scene
        else:
            assert "There are no results yet" in panel.sentence.text(), scene
        window.panels.open(None)
        panel.choose("arithmetic")


def test_no_start_waits_for_it() -> None:
    """Neither its module nor the shipped results are read before the card is opened."""
    code = """
import sys
import widgets.program.application, widgets.window.main_window
from app.measure.single import shipped
assert "widgets.window.trades_card" not in sys.modules
assert shipped.cache_info().currsize == 0
"""
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=True)


def test_the_trades_are_the_measured_ones() -> None:
    assert [name for name in chart.TITLES if name not in SWEPT] == list(TRADES)
    assert set(TRADES) <= set(GIVEN_UP)
