"""Drawings of scenes that were visited rest in their pane's window, and are shown again."""

import gc
import weakref
from collections import Counter
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from app.drawings.actors import FlatActor
from app.drawings.labels import Board
from app.drawings.off_screen import close_kept, kept
from app.lecture.highlight import NOTHING
from app.picking.picking import Probe
from tests.support.window import edit, pixels, settle, show_scene, turn
from widgets.panes import resting
from widgets.panes.pane import AS_BUILT
from widgets.window.main_window import MainWindow

PROBES = (Probe(1, point=(0.5, 0.5, 0.5)),)


def shown(window: MainWindow) -> dict[str, np.ndarray]:
    settle()
    return {name: pixels(window, name) for name, pane in window.panes.items() if pane.isVisible()}


def differing(window: MainWindow, expected: dict[str, np.ndarray]) -> list[str]:
    now = shown(window)
    assert now.keys() == expected.keys()
    return [name for name in now if not np.array_equal(now[name], expected[name])]


def assert_same(window: MainWindow, expected: dict[str, np.ndarray]) -> None:
    assert differing(window, expected) == []


@pytest.mark.parametrize("between", ["posts", "clipping"])  # in panes of the same size, of others
def test_a_scene_that_is_come_back_to_makes_no_actor_and_places_no_label(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch, between: str
) -> None:
    first = shown(show_scene(window, "cube"))
    show_scene(window, between)
    counted: Counter[str] = Counter()
    for of, method in ((FlatActor, "__init__"), (Board, "settle")):
        done = getattr(of, method)

        def count(*args: Any, done: Any = done, **how: Any) -> Any:
            counted[done.__qualname__] += 1
            return done(*args, **how)

        monkeypatch.setattr(of, method, count)
    assert_same(show_scene(window, "cube"), first)
    assert not counted


ACTS: dict[str, Callable[[MainWindow], object]] = {
    "edit": edit,
    "turn": lambda window: [turn(window, name) for name in ("world", "ndc")],
    "names": lambda window: window.panes["world"].request("names", frozenset()),
    "layers": lambda window: window.panes["image"].request("layers", frozenset({"grid", "labels"})),
    "stage": lambda window: window.strip.go_to(1.5),
    "probes": lambda window: window.panes["world"].request("probes", PROBES),
    "fixed": lambda window: window.panes["world"].request("fixed", "top"),
    "step": lambda window: window.panes["world"].request("step", 2),
    "grips": lambda window: window.panes["world"].request("grips", ()),
    "highlight": lambda window: window.panes["ndc"].show_highlight(frozenset({"near"})),
}


def test_what_was_done_to_a_scene_is_not_seen_when_it_is_chosen_again(window: MainWindow) -> None:
    first = shown(show_scene(show_scene(window, "clipping"), "letter-f"))  # in panes of other sizes
    before = window.panes["world"].drawing
    for act, do in ACTS.items():
        do(window)
        settle()
        show_scene(window, "clipping")
        for pane in window.panes.values():
            pane.show_highlight(NOTHING)
            for what in ("names", "layers", "probes", "fixed", "step", "grips"):
                pane.request(what, AS_BUILT[what])
        assert differing(show_scene(window, "letter-f"), first) == [], act
        assert window.panes["world"].drawing is before, act


def test_another_size_and_other_words_are_seen_in_a_scene_that_is_come_back_to(
    window: MainWindow,
) -> None:
    show_scene(show_scene(window, "letter-f"), "posts")
    window.resize(window.width() - 150, window.height() - 100)
    settle()
    resized = shown(show_scene(window, "letter-f"))
    window.look.rebuild()
    assert_same(window, resized)
    show_scene(window, "posts")
    window.look.set_letters("004")
    lettered = shown(show_scene(window, "letter-f"))
    window.look.rebuild()
    assert_same(window, lettered)


def test_few_and_small_drawings_rest(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch, qtbot: Any
) -> None:
    monkeypatch.setattr(resting, "MOST", 2)
    pane, left = window.panes["world"], []
    for name in ("cube", "posts", "view-volumes", "letter-f"):
        show_scene(window, name)
        assert pane.drawing is not None
        left.append(weakref.ref(pane.drawing))
    del name
    qtbot.waitUntil(lambda: gc.collect() >= 0 and left[0]() is None)
    assert [each.drawing for each in pane.resting.all] == [each() for each in left[1:3]]
    assert pane.canvas.render_window.GetRenderers().GetNumberOfItems() == 3
    monkeypatch.setattr(resting, "MOST_CELLS", 0)
    show_scene(window, "cube")
    assert left[3]() not in [each.drawing for each in pane.resting.all]


def test_a_picture_beside_that_cannot_be_drawn_ahead_gives_its_window_back(
    window: MainWindow,
) -> None:
    """The step itself will say what is wrong."""
    close_kept()
    pane = window.panes["image"]

    def fails(*_args: object) -> Any:
        raise ValueError("no drawing")

    with pytest.raises(ValueError, match="no drawing"):
        resting.RestingDrawings(pane.canvas, fails, AS_BUILT).draw_beside(1, window.shown, "cube")
    assert len(kept) == 1
