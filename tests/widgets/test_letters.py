"""The choice of letters holds in panes, panels and figures."""

from __future__ import annotations

import numpy as np
import pytest

from app.document.view import View
from app.drawings.figures import render
from app.lecture.notation import LETTERS, Letters, axis_letters, frame_letters
from app.scenes.scene import load
from tests.support.window import pixels, settle
from widgets.window.main_window import MainWindow


@pytest.mark.parametrize(
    ("letters", "expected"),
    [
        ("own", {"u": "u", "v": "v", "n": "n"}),
        ("001", {"u": "u", "v": "v", "n": "w"}),  # w = -look
        ("004", {"u": "u", "v": "v", "n": "n", "up": "V"}),
    ],
)
def test_l1_the_arrows_are_called_as_in_the_lecture(
    letters: Letters, expected: dict[str, str]
) -> None:
    assert axis_letters(letters) == expected


def choose(window: MainWindow, letters: Letters) -> None:
    combo = window.matrices.letters
    combo.setCurrentIndex(combo.findData(letters))
    settle()


def test_panes_and_panels_are_written_in_the_letters_that_are_chosen(window: MainWindow) -> None:
    own = pixels(window, "world")
    choose(window, "001")
    assert window.look.words["n"] == "w"
    assert (pixels(window, "world") != own).any()
    panel = window.frame_panel
    window.panels.open(panel)
    panel.go_to(3)
    settle()
    assert "w" in panel.title.text() and "−w" in panel.sentence.text()
    assert window.store.document is window.store.seen or not window.store.can_undo
    choose(window, "004")
    panel.go_to(4)
    settle()
    assert "V" in panel.sentence.text() and window.look.words["up"] == "V"
    choose(window, "own")
    settle()
    assert window.look.words["n"] == "n" and window.look.words["up"] == "up"


def test_a_figure_is_written_in_the_views_letters() -> None:
    scene = load("letter-f")
    figures = {
        letters: render(
            scene, scene.start, panes=("world",), size=(320, 240), view=View(letters=letters)
        )
        for letters in ("own", "001", "002")
    }
    assert (figures["own"] != figures["001"]).any()
    assert np.array_equal(figures["own"], figures["002"])


def test_every_choice_is_told_from_the_others_in_words(window: MainWindow) -> None:
    combo = window.matrices.letters
    texts = [combo.itemText(i) for i in range(combo.count())]
    assert [combo.itemData(i) for i in range(combo.count())] == [*LETTERS]
    assert len(set(texts)) == len(LETTERS) and not any("lecture" in text for text in texts)
    assert all(frame_letters(letters)["u"] == "u" for letters in LETTERS)
