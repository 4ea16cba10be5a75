"""The choice of letters holds in panes, panels and figures."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QFileDialog

from app.document.view import View
from app.drawings import DrawingWords
from app.lecture.letters import LETTERS, Letters, axis_letters, frame_letters, in_letters
from app.scenes.scene import load
from tests.support.drawings import figure_of
from tests.support.window import pixels, settle, show_scene
from widgets.panels.probe_table import EXACT
from widgets.window.main_window import MainWindow


@pytest.mark.parametrize(
    ("letters", "expected"),
    [
        ("own", {"u": "u", "v": "v", "n": "n"}),
        ("001", {"u": "u", "v": "v", "n": "w", "eye": "P"}),  # w = -look
        ("003", {"u": "u", "v": "v", "n": "n"} | {f"object_{x}": f"O_{x}" for x in "xyz"}),
        ("004", {"u": "u", "v": "v", "n": "n", "up": "V", "eye": "T\u2080", "target": "T\u2081"}),
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
    window.store.set_view(names=("n",))
    settle()
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


@pytest.mark.undrawn
def test_letters_of_a_file_are_chosen_kept_and_refused(
    window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    own, bad = tmp_path / "letters.toml", tmp_path / "bad.toml"
    own.write_text(
        '[vectors]\nn = "k"\neye = "C"\n[matrices]\nview_from_world = "V"\n', encoding="utf-8"
    )
    bad.write_text('[vectors]\nn = "$"\n', encoding="utf-8")
    window.panels.open(window.matrices)
    for path in (own, bad):
        monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_, path=path: (str(path), ""))
        window.matrices.file.click()
        settle()
        assert window.look.words["n"] == "k" and window.store.seen.view.letters == own.read_text(
            encoding="utf-8"
        )
    assert "line 2: n = '$': must be a Latin letter" in window.matrices.explanation.text()
    assert window.matrices.shown[0].called == "V" and window.matrices.letters.count() == 7
    choose(window, "003")
    window.store.set_view(letters='[vectors]\nn = "m"\n')
    settle()
    assert window.matrices.letters.count() == 7
    window.matrices.choose_letters('[vectors]\nn = "m"\n')
    settle()
    assert window.look.words["n"] == "m" and window.matrices.letters.currentText() == "of a file"


def test_a_scenes_own_marks_are_written_in_the_views_letters() -> None:
    scene = load("off-axis-window")
    own, lecture_000, lecture_003 = (
        figure_of(
            scene, scene.start, panes=("world",), size=(480, 360), view=View(letters=letters),
            settings=scene.phenomenon and scene.phenomenon.checked({}),
        ).pixels()
        for letters in ("own", "000", "003")
    )  # fmt: skip
    assert (own != lecture_000).any() and np.array_equal(own, lecture_003)


def test_the_blackboards_lengths_have_the_views_letters() -> None:
    scene = load("letter-f")
    own, lecture_000, lecture_003 = (
        figure_of(
            scene, scene.start, panes=("world",), size=(480, 360),
            view=View(letters=letters, fixed="side"),
        ).pixels()
        for letters in ("own", "000", "003")
    )  # fmt: skip
    assert (own != lecture_000).any() and np.array_equal(own, lecture_003)
    for letters, far, angles in (
        ("own", "f", ("fov", "fov_x")), ("000", "z_max", ("fov", "fov_x")),
        ("001", "f", ("θ_v", "θ_h")), ("002", "−z_f", ("fov", "fov_x")),
        ("003", "f", ("β", "\u03b1")),
    ):  # fmt: skip
        words = DrawingWords(letters)
        assert words.get("{far_distance}") == far
        assert (words.get("{fov}"), words.get("{fov_x}")) == angles


def test_a_text_has_the_letters_of_a_lecture_only_where_they_are_marked() -> None:
    text = "{l}, {r} of the left window: near {n}, axis {axis_n} {0}"
    assert in_letters(text, "own") == "l, r of the left window: near n, axis n {0}"
    assert in_letters(text, "000").startswith("x_min, x_max of the left window: near z_min, axis n")
    assert in_letters(text, "001").endswith("near n, axis w {0}")
    assert in_letters(text, "002").startswith("x_l, x_r of the left window: near z_n")


@pytest.mark.undrawn
def test_the_readout_of_a_scene_has_the_letters_that_are_chosen(window: MainWindow) -> None:
    show_scene(window, "off-axis-window")
    settle()
    readout = window.controls.card.readout

    def labels() -> list[str]:
        return [label.text() for label, _, _ in readout.lines if not label.isHidden()]

    readout.more.setChecked(True)
    assert "l, r of the left screen" in labels() and "off the axis, (r + l)/(r − l)" in labels()
    choose(window, "000")
    assert "x_min, x_max of the left screen" in labels() and "y_min, y_max" in labels()
    choose(window, "002")
    assert "off the axis, (x_r + x_l)/(x_r − x_l)" in labels()
    assert not any("{" in text for text in labels())


@pytest.mark.undrawn
def test_the_stage_strip_names_axes_and_planes_in_the_letters(window: MainWindow) -> None:
    said: list[str] = []
    window.strip.named.connect(lambda _title, words: said.append(words))
    window.strip.go_to(1.0)
    choose(window, "001")
    window.strip.go_to(2.0)
    choose(window, "000")
    assert said[0].startswith("u, v, n in") and said[1].startswith("u, v, w in")
    assert said[2].startswith("x, y ±1, z −n/f = −0.4") and "z −z_min/z_max" in said[3]


FORMULAS: dict[Letters, tuple[str, ...]] = {
    "own": ("I p", "R (p − e)", "P p_view;  w = −z_view", "n ≤ −z_view ≤ f"),
    "000": ("I p", "R (p − e)", "P p_view;  w = −z_view", "z_min ≤ −z_view ≤ z_max"),
    "001": ("I p", "R (p − P)", "f M_z M_pp M_persp p_view;  w = −z_view", "n ≤ −z_view ≤ f"),
    "002": ("M p", "V p", "P_persp p_view;  w = z_view", "z_f ≤ z_view ≤ z_n"),
    "003": ("M_O→W p", "M_W→E p", "M_projection p_view;  w = −z_view", "n ≤ −z_view ≤ f"),
    "004": ("I p", "R P p", "P p_view;  w = −z_view", "n ≤ −z_view ≤ f"),
}


@pytest.mark.undrawn
def test_l13_the_probes_formulas_and_numbers_are_the_lectures(window: MainWindow) -> None:
    """Lecture 002 divides by w = z, and its z' is 1 at near: numbers and formulas together."""
    panel = window.probe_panel
    window.panels.open(panel)
    panel.follow(point=(1.0, 2.0, 0.5))
    settle()
    model = panel.table.model()

    def cells(row: int) -> list[float]:
        texts = (model.index(row, column).data(EXACT) for column in range(1, 5))
        return [float(text.replace("÷ ", "").replace("−", "-")) for text in texts if text]

    own = [cells(row) for row in range(8)]
    for letters, (world, view, clip, between) in FORMULAS.items():
        choose(window, letters)
        said = [model.index(row, 0).data() for row in range(model.rowCount())]
        assert (said[1], said[2], said[3]) == (world, view, clip)
        assert said[8].endswith(between)
        sign = -1.0 if letters == "002" else 1.0
        x, y, z, w = own[3]
        assert cells(3) == [sign * x, sign * y, z, sign * w]
        assert cells(4) == [sign * w] * 3
        assert cells(5) == [own[5][0], own[5][1], sign * own[5][2]]
        assert cells(6) == own[6] and cells(7) == own[7]
    choose(window, "002")
    assert "|w|" in model.index(8, 0).data() and cells(3)[3] == cells(2)[2]


@pytest.mark.undrawn
def test_each_choice_of_letters_has_its_own_text(window: MainWindow) -> None:
    combo = window.matrices.letters
    texts = [combo.itemText(i) for i in range(combo.count())]
    assert [combo.itemData(i) for i in range(combo.count())] == [*LETTERS]
    assert len(set(texts)) == len(LETTERS) and not any("lecture" in text for text in texts)
    assert all(frame_letters(letters)["u"] == "u" for letters in LETTERS)
