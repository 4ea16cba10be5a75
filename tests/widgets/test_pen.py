"""The pen: strokes belong to their step, can be taken back, and are kept for the handout."""

import itertools
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFrame

from app.drawings.style import DARK, LIGHT, Style, rgb
from app.lessons.strokes import (
    COLOURS,
    Stroke,
    path_beside,
    picture_beside,
    read_strokes,
    write_strokes,
)
from app.model.refusal import Refusal
from tests.support.lessons import PREDICTED, lesson_of
from tests.support.window import activate, arrive, move_mouse, pixels, present, rgb_of, settle
from widgets.program.handout import handout
from widgets.program.handout_content import StepFigure, contents
from widgets.window.main_window import MainWindow

TALK = lesson_of("scene=letter-f", "lens.near=2")
LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton


@pytest.fixture
def window(window: MainWindow, talk: Path) -> MainWindow:
    window.settings.speaker_window = False
    window.settings.reduce_motion = True
    assert window.lessons.open(talk)
    activate(window)
    present(window)
    return window


def draw(window: MainWindow, *places: tuple[int, int]) -> None:
    pen = window.slide.pen
    QTest.mousePress(pen, LEFT, pos=QPoint(*places[0]))
    for place in places[1:]:
        move_mouse(pen, QPoint(*place))
    QTest.mouseRelease(pen, LEFT, pos=QPoint(*places[-1]))
    settle()


def slide(window: MainWindow) -> np.ndarray:
    return rgb_of(window.slide.grab().toImage())


def test_strokes_lie_over_the_picture_and_belong_to_their_step(window: MainWindow) -> None:
    pen, plain = window.slide.pen, slide(window)
    model, picture = window.store.document, pixels(window)
    QTest.keyClick(window, Qt.Key.Key_D)
    assert pen.is_on and window.menus.pen.isChecked()
    draw(window, (300, 300), (400, 320), (500, 300))
    draw(window, (300, 400), (500, 420))
    assert [len(stroke.points) for stroke in pen.here] == [3, 2]
    QTest.keyClick(pen, Qt.Key.Key_D)
    settle()
    assert not pen.is_on
    drawn = slide(window)
    changed = np.nonzero((drawn != plain).any(axis=2))
    assert changed[0].min() > 290 and changed[0].max() < 430
    assert window.store.document == model and (pixels(window) == picture).all()
    assert window.lessons.next()
    arrive(window.lessons) if window.lessons.is_moving else settle()
    assert pen.here == []
    assert window.lessons.previous()
    settle()
    assert (slide(window) == drawn).all()


@pytest.mark.undrawn
def test_undo_eraser_and_clear(window: MainWindow) -> None:
    pen = window.slide.pen
    pen.switch(True)
    bar = pen.findChild(QFrame, "card")
    assert bar.width() < 0.04 * pen.width() and bar.isVisible()
    QApplication.sendEvent(bar, QEvent(QEvent.Type.Enter))
    assert bar.width() > 0.2 * pen.width() and pen.rect().contains(bar.geometry())
    QApplication.sendEvent(bar, QEvent(QEvent.Type.Leave))
    QTest.mousePress(pen, LEFT, pos=QPoint(300, 150))
    assert bar.isHidden() and bar.width() < 0.04 * pen.width()
    QTest.mouseRelease(pen, LEFT, pos=QPoint(300, 150))
    assert bar.isVisible()
    pen.clear()
    for y in (200, 300, 400):
        draw(window, (300, y), (350, y))
    model = window.store.document
    QTest.keyClick(pen, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert len(pen.here) == 2 and window.store.document == model
    field = window.controls.rows["near"].field
    field.setText("3.5")
    draw(window, (300, 400), (350, 400))
    QTest.keyClick(field, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert len(pen.here) == 2 and field.text() == "3.5", "wherever the keyboard is"
    QTest.keyClick(pen, Qt.Key.Key_E)
    draw(window, (600, 300), (350, 301))
    assert [round(stroke.points[0][1] * pen.height()) for stroke in pen.here] == [200]
    QTest.keyClick(pen, Qt.Key.Key_X)
    assert not pen.erases
    colour = pen.colour
    draw(window, (300, 600), (350, 600))
    assert pen.here[-1].colour == colour
    QTest.keyClick(pen, Qt.Key.Key_Delete)
    assert pen.here == []
    QTest.keyClick(pen, Qt.Key.Key_Escape)
    assert not pen.is_on and window.present.is_on


@pytest.mark.undrawn
def test_what_is_kept_is_there_again(window: MainWindow, talk: Path) -> None:
    pen = window.slide.pen
    pen.switch(True)
    draw(window, (300, 300), (400, 320))
    wanted = {"s1": tuple(pen.here)}
    assert read_strokes(talk) == {}
    QTest.keyClick(pen, Qt.Key.Key_K)
    assert read_strokes(talk) == wanted
    assert window.band.message == "Kept for the handout: talk.strokes.json"
    window.lessons.close()
    settle()
    assert pen.here == []
    assert window.lessons.open(talk)
    assert tuple(pen.here) == wanted["s1"]


@pytest.mark.undrawn
def test_the_handout_prints_the_slide_with_its_strokes(window: MainWindow, talk: Path) -> None:
    course = window.lessons.course
    assert course is not None
    plain = handout(course)
    pen = window.slide.pen
    pen.switch(True)
    draw(window, (300, 300), (400, 320))
    drawn = slide(window)
    QTest.keyClick(pen, Qt.Key.Key_K)
    path = picture_beside(talk, "s1")
    kept = rgb_of(QImage(str(path)))
    assert kept.shape == drawn.shape
    bar = pen.findChild(QFrame, "card").geometry()
    beside = np.ones(kept.shape[:2], dtype=bool)
    beside[bar.top() : bar.bottom() + 1, bar.left() : bar.right() + 1] = False  # not in the handout
    assert (kept[beside] == drawn[beside]).all() and (kept != drawn).any()
    assert not picture_beside(talk, "s2").exists()
    assert abs(len(handout(course)) - len(plain)) > 1000
    QTest.keyClick(pen, Qt.Key.Key_Delete)
    QTest.keyClick(pen, Qt.Key.Key_K)
    assert not path.exists() and abs(len(handout(course)) - len(plain)) < 100


@pytest.mark.undrawn
def test_strokes_belong_to_the_picture_that_they_were_drawn_on(
    window: MainWindow, talk: Path
) -> None:
    talk.write_text(PREDICTED, encoding="utf-8")
    window.lessons.close()
    assert window.lessons.open(talk)
    pen = window.slide.pen
    pen.switch(True)
    draw(window, (300, 300), (400, 320))
    assert window.talks.reveal()  # the question changes no picture
    assert len(pen.here) == 1
    assert window.talks.reveal()
    assert pen.here == []
    draw(window, (300, 300), (400, 320))
    draw(window, (300, 350), (400, 370))
    QTest.keyClick(pen, Qt.Key.Key_K)
    assert {name: len(kept) for name, kept in read_strokes(talk).items()} == {"one": 1, "one.1": 2}
    course = window.lessons.course
    assert course is not None
    figures = [each for each in contents(course, 0, answers=True) if isinstance(each, StepFigure)]
    assert [each.slide for each in figures] == [
        picture_beside(talk, name) for name in ("one", "one.1")
    ]
    window.talks.previous()
    assert len(pen.here) == 1


@pytest.mark.parametrize(
    "text", ["", "[]", '{"strokes": {"one": [["pink", [0, 0]]]}}', '{"strokes": {"one": [["n"]]}}',
             '{"strokes": {"one": [["n", [2, 0]]]}}', '{"strokes": {"one": [["n", [NaN, 0]]]}}',
             '{"strokes": {"one": [["n", [1' + 400 * "0" + ', 0]]]}}', "[" * 100_000]
)  # fmt: skip
def test_a_damaged_file_of_strokes_is_refused_and_set_aside(tmp_path: Path, text: str) -> None:
    talk = tmp_path / "talk.md"
    write_strokes(talk, {"one": [Stroke("n", ((0.5, 0.5),))]})
    assert read_strokes(talk) == {"one": (Stroke("n", ((0.5, 0.5),)),)}
    path_beside(talk).write_text(text, encoding="utf-8")
    with pytest.raises(Refusal, match="has no strokes as Frustum Lab writes them"):
        read_strokes(talk)
    write_strokes(talk, {})
    assert read_strokes(talk) == {}
    assert Path(f"{path_beside(talk)}.bak").read_text(encoding="utf-8") == text


@pytest.mark.undrawn
def test_the_speaker_sees_the_slide_with_its_strokes(window: MainWindow, qtbot: Any) -> None:
    window.talks.open_speaker()
    speaker = window.talks.speaker
    assert speaker is not None

    def shown() -> QImage:
        return speaker.now.pixmap().toImage()

    qtbot.waitUntil(lambda: not shown().isNull())
    before = shown()
    activate(window)
    window.slide.pen.switch(True)
    draw(window, (300, 300), (900, 320))
    window.slide.pen.switch(False)
    qtbot.waitUntil(lambda: shown() != before)
    screen = window.body.size()
    picture = shown()
    assert picture.width() / picture.height() == pytest.approx(
        screen.width() / screen.height(), rel=0.02
    )
    speaker.close()


VISION = {
    "all": np.eye(3),
    "protanopia": ((0.1523, 1.0526, -0.2049), (0.1145, 0.7863, 0.0992), (-0.0039, -0.0481, 1.0520)),
    "deuteranopia": ((0.3673, 0.8606, -0.2280), (0.2801, 0.6725, 0.0474), (-0.0118, 0.0429, 0.969)),
    "tritanopia": ((1.2556, -0.0767, -0.1788), (-0.0784, 0.9308, 0.1476), (0.0047, 0.6914, 0.3039)),
}
"""What linear colours become for the colour-blind (Machado, Oliveira and Fernandes 2009)."""
XYZ = ((0.4124, 0.3576, 0.1805), (0.2126, 0.7152, 0.0722), (0.0193, 0.1192, 0.9505))


def lab(colour: str, vision: Any) -> np.ndarray:
    """CIE L*a*b* of a colour, as it is seen."""
    part = np.array(rgb(colour))
    linear = np.where(part <= 0.04045, part / 12.92, ((part + 0.055) / 1.055) ** 2.4)
    white = np.array(XYZ).sum(axis=1)
    xyz = np.array(XYZ) @ np.clip(np.array(vision) @ linear, 0.0, 1.0) / white
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16.0 / 116.0)
    return np.array([116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])])


@pytest.mark.parametrize("style", [LIGHT, DARK], ids=["light", "dark"])
@pytest.mark.parametrize("vision", VISION)
def test_nobody_confuses_the_colours_of_the_pen(style: Style, vision: str) -> None:
    assert len(COLOURS) == 4 and "accent" not in COLOURS, "projectors have it"
    seen = {name: lab(getattr(style, name), VISION[vision]) for name in (*COLOURS, "background")}
    for one, other in itertools.combinations(seen, 2):
        assert np.linalg.norm(seen[one] - seen[other]) > 12.5, (one, other)
    pink = lab(style.accent, np.eye(3))
    assert all(np.linalg.norm(lab(getattr(style, each), np.eye(3)) - pink) > 40 for each in COLOURS)


def test_strokes_of_older_files_are_drawn_as_they_were(window: MainWindow, talk: Path) -> None:
    path_beside(talk).write_text(
        '{"strokes": {"s1": [["accent", [0.1, 0.5], [0.9, 0.5]]]}}', encoding="utf-8"
    )
    (stroke,) = read_strokes(talk)["s1"]
    window.slide.pen.begin_talk({"s1": [stroke]})
    settle()
    seen = slide(window)
    here = seen[seen.shape[0] // 2, seen.shape[1] // 3]
    assert np.abs(here / 255.0 - rgb(LIGHT.accent)).max() < 0.02
