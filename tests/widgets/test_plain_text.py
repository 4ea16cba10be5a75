"""Texts of strangers in the real window: they are shown as they stand, and nothing is loaded."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from PySide6.QtGui import Qt, QTextDocument
from PySide6.QtWidgets import QApplication, QLabel, QWidget
from pytestqt.qtbot import QtBot

from tests.support.meshes import PYRAMID, obj_file
from tests.support.window import MakeWindow, rgb_of, settle
from widgets.controls.scene_card import SceneCard
from widgets.parts.labels import Balanced
from widgets.parts.plain import Markup, PlainLabel, message_box, set_tip, subscripts
from widgets.parts.progress import progress
from widgets.window.main_window import MainWindow

PINK = (255, 0, 255)
PICTURE = "<img src='pink.png' width=60 height=60>"
LESSON = f"""---
title: {PICTURE}
---
# {PICTURE} {{#one}}
{PICTURE} and ![a picture](pink.png)

```state
scene=letter-f
```

```answer a
{PICTURE}
value: near
unit: m
hint: {PICTURE}
```

---
# <b>{PICTURE}</b> {{#two}}
text

```predict b
{PICTURE}
- [x] {PICTURE}
- [ ] {PICTURE}
hint: {PICTURE}
why: {PICTURE}
```

```note
{PICTURE}
```
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder, from which Qt would load the picture."""
    Image.new("RGB", (60, 60), PINK).save(tmp_path / "pink.png")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def widgets_of(window: MainWindow) -> Iterator[QWidget]:
    settle()
    for top in QApplication.topLevelWidgets():
        if not top.isHidden():
            yield from (top, *top.findChildren(QWidget))


def assert_plain(window: MainWindow) -> None:
    """No pink pixel is visible, and no label or tooltip has markup from a file."""
    for widget in widgets_of(window):
        if isinstance(widget, QLabel):
            ours = isinstance(widget.text(), Markup)
            assert ours or widget.textFormat() == Qt.TextFormat.PlainText, widget.text()
        tip = widget.toolTip()
        assert "<img" not in tip, tip
        for document in widget.findChildren(QTextDocument):
            assert "<img" not in document.toHtml()
        if widget.isWindow():
            picture = rgb_of(widget.grab().toImage())
            assert not np.all(picture == PINK, axis=2).any()


def test_a_label_a_tooltip_and_a_box_show_what_they_are_given(folder: Path, qtbot: object) -> None:
    label, box = PlainLabel(PICTURE), message_box(None, PICTURE)  # type: ignore[arg-type]
    set_tip(label, PICTURE)
    for shown in (label, box):
        picture = rgb_of(shown.grab().toImage())
        assert not np.all(picture == PINK, axis=2).any()
    assert label.toolTip() == "<qt>&lt;img src=&#x27;pink.png&#x27; width=60 height=60&gt;</qt>"
    label.setText(Markup.of("<b>{}</b>", PICTURE))
    assert not np.all(rgb_of(label.grab().toImage()) == PINK, axis=2).any()


def test_the_check_sees_a_picture_that_is_loaded(folder: Path, qtbot: object) -> None:
    label = QLabel(PICTURE)
    assert np.all(rgb_of(label.grab().toImage()) == PINK, axis=2).any()


@pytest.mark.undrawn
def test_no_text_of_a_lesson_or_a_talk_is_marked_up(make_window: MakeWindow, folder: Path) -> None:
    window = make_window()
    for name, head in (("lesson.md", ""), ("talk.md", "minutes: 5\n")):
        path = folder / name
        path.write_text(LESSON.replace("title:", f"{head}title:", 1), encoding="utf-8")
        assert window.files.open(path)
        card = window.lesson_card
        for place in (0, 1):
            card.go_to(place)
            settle()
            card.give_hint()
            assert_plain(window)
        assert PICTURE in [label.text() for label in window.findChildren(QLabel)]


@pytest.mark.undrawn
def test_no_name_of_a_file_is_marked_up(make_window: MakeWindow, folder: Path) -> None:
    window = make_window()
    mesh = folder / f"{PICTURE}[*] & b.obj"
    obj_file(mesh, PYRAMID)
    assert window.files.open(mesh)
    assert window.windowTitle() == f"{PICTURE}[*][*] & b.obj[*] – Frustum Lab"
    assert_plain(window)
    assert window.files.choose_scene("depth-buffer")
    assert window.files.use_mesh(str(mesh))
    assert_plain(window)
    for name in (f"{PICTURE}.json", f"{PICTURE}.obj", f"{PICTURE}.md"):
        assert not window.files.open(folder / name) or window.lessons.lesson is None
        assert PICTURE in window.messages.text
        assert_plain(window)
    with progress(window, f"Opening {PICTURE}") as tell:
        tell(0.5)
        assert_plain(window)


def test_letters_after_an_underscore_are_subscripts_and_the_rest_stays_plain() -> None:
    assert subscripts("V_x, y_p : d and 3") == "V<sub>x</sub>, y<sub>p</sub> : d and 3"
    assert isinstance(subscripts("V_x"), Markup) and not isinstance(subscripts("V"), Markup)
    assert subscripts(f"x_p {PICTURE}").startswith("x<sub>p</sub> &lt;img")


def below(label: PlainLabel) -> int:
    """Return the ink of the lowest row: under letters, only an underscore has any."""
    label.resize(300, 60)
    ink = rgb_of(label.grab().toImage()).min(axis=2) < 128
    rows = np.flatnonzero(ink.any(axis=1))
    return int(ink[rows[-1]].sum())


def test_a_balanced_text_paints_no_underscore(qtbot: QtBot) -> None:
    subscripts, underscores = Balanced("x_x x_x x_x"), Balanced("xx_ xx_ xx_")
    qtbot.addWidget(subscripts)
    qtbot.addWidget(underscores)
    assert below(subscripts) < 0.5 * below(underscores)


def test_the_name_of_a_file_is_no_formula(qtbot: QtBot) -> None:
    card = SceneCard()
    qtbot.addWidget(card)
    card.show_scene("x_x x_x x_x", (), None)
    underscores = Balanced("xx_ xx_ xx_")
    qtbot.addWidget(underscores)
    assert below(card.title) > 0.9 * below(underscores)
