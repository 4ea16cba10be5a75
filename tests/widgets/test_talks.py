"""Talks: wandering and coming back, the keys of clickers, the band, the speaker's window."""

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import cycle
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, QRectF, QSize, Qt, QTimer
from PySide6.QtGui import QGuiApplication, QKeySequence, QTextDocument, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QWidget

from app.document.codec import to_json
from app.document.document import Document
from app.document.store import Store
from app.document.view import AS_EVER
from app.drawings.off_screen import OffScreen, close_kept, kept
from app.drawings.world import WorldDrawing
from app.lecture.typesetting import SET, line_of, outline, piece_of
from app.lessons.contents import CONTENT
from app.lessons.course import Course, scene_of
from app.lessons.lesson import MOST_STEPS, Step, parse_lesson, read
from app.model.projection import Camera
from app.scenes.scene import BUILT_IN, Scene
from tests.fuzz.catalogue import a_view, edited
from tests.support.lessons import lesson_of
from tests.support.window import (
    MakeWindow,
    activate,
    arrive,
    go_to,
    pixels,
    present,
    rgb_of,
    settle,
    tick,
)
from widgets.panes.pane import Pane
from widgets.parts.lesson_text import LessonText, set_text
from widgets.parts.messages import MessageBar
from widgets.window import talk_keys
from widgets.window.lesson_card import heads
from widgets.window.lessons import TRANSITION_S, Lessons
from widgets.window.main_window import MainWindow
from widgets.window.question import QuestionOverlay
from widgets.window.settings import Settings
from widgets.window.speaker import SpeakerWindow, TalkClock
from widgets.window.talk_ahead import REST_MS
from widgets.window.talk_band import (
    GAP_SHARE,
    LINE_SHARE,
    LINES,
    SMALLER,
    TITLE_SHARE,
    TOP_SHARE,
    TalkBand,
)
from widgets.window.talk_keys import TYPED_MS

WALKED = lesson_of(
    "scene=letter-f\nlens.fov_y_deg=60\nview.large=world",
    "camera.eye=9,2,3\nview.stage=pyramid\nview.large=ndc\nlens.near=2",
    "",
    "scene=affine-depth\nview.fixed=side",
    "scene=view-volumes\nsettings.volume=box\nview.probes=1,2,3",
    "scene=letter-f\nlens.kind=frustum\nlens.left=-1\nlens.right=3\nlens.bottom=-1\nlens.top=1\n"
    "object.rotate_deg=0,30,0",
)


class StubFiles:
    """What of `Files` a talk needs, without dialogs."""

    def __init__(self, store: Store) -> None:
        self._store = store

    def keep(self, _document: Document, _scene: Scene) -> None:
        """All scenes are kept by `scene_of`."""

    def open_step(self, document: Document, _scene: Scene, _lesson: Path) -> bool:
        return self._store.open(document, is_work=False)


def wander(rng: random.Random, store: Store, lessons: Lessons) -> None:
    """Do something by hand, or go somewhere."""
    kind = rng.randrange(10)
    if kind < 3:
        document = edited(rng, store.document)
        if document != store.document:
            store.set_document(document)
    elif kind == 3:
        store.set_projection(edited(rng, store.document).projection)
    elif kind == 4:
        view = a_view(rng)
        names = rng.sample(("large", "stage", "layers", "fixed", "probes"), 2)
        store.set_view(**{name: getattr(view, name) for name in names})
    elif kind == 5:
        eye = rng.uniform(1.0, 9.0), rng.uniform(1.0, 9.0), 4.0
        store.set_view(panes={"world": Camera(eye, (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))})
    elif kind == 6:
        (store.undo if rng.random() < 0.7 else store.redo)()
    elif kind == 7:
        scene = rng.choice(BUILT_IN)
        start = scene_of(Document(scene)).start
        store.set_document(Document(scene, start, view=replace(store.look(), panes={})))
    elif kind == 8:
        tick(lessons, rng.uniform(0.01, TRANSITION_S))
    else:
        go = rng.choice((lessons.next, lessons.previous, lambda: lessons.go(rng.randrange(6))))
        go()


@pytest.fixture
def walk(display: Any, tmp_path: Path) -> tuple[Store, MessageBar, Lessons]:
    """A lesson without a window."""
    path = tmp_path / "walk.md"
    path.write_text(WALKED, encoding="utf-8")
    store, messages = Store(Document("cube", scene_of(Document("cube")).start)), MessageBar()
    files: Any = StubFiles(store)
    still: Any = SimpleNamespace(  # panes whose cameras do not move
        is_wanted=True, begin=lambda cuts: False, start=lambda moves: moves, paint=lambda: None,
        go=lambda part: None,
    )  # fmt: skip
    lessons = Lessons(
        store, files, messages, lambda: None, lambda _stage: None,
        lambda cameras: store.set_view(panes=dict(cameras)), still,
    )  # fmt: skip
    assert lessons.open(path)
    return store, messages, lessons


def test_random_walks_come_back_to_the_file_bit_for_bit(
    walk: tuple[Store, MessageBar, Lessons],
) -> None:
    store, messages, lessons = walk
    expected = Course(parse_lesson(WALKED, Path("walk.md")))  # not the one of the window
    arrived = [store.look().panes]
    lessons.stepped.connect(lambda: arrived.append(store.look().panes))
    rng = random.Random(7)
    moved = 0
    for _ in range(400):
        for _ in range(rng.randrange(1, 6)):
            wander(rng, store, lessons)
        place, before, was_moving = lessons.place, store.seen, lessons.is_moving
        shown = expected.shown(place)
        assert lessons.is_away == (
            store.document != shown.document
            or any(getattr(store.look(), name) != value for name, value in shown.view.items())
            or store.look().panes != arrived[-1]
        )
        turned = arrived[-1]
        assert lessons.come_back()
        moved += lessons.is_moving
        arrive(lessons)
        now = store.seen
        assert to_json(replace(now, view=AS_EVER)) == to_json(replace(shown.document, view=AS_EVER))
        assert {name: getattr(now.view, name) for name in shown.view} == shown.view
        assert now.view.panes == turned == arrived[-1]
        assert not lessons.is_away
        assert not store.modified  # nobody is asked to save it
        if (before.scene, before.mesh) == (now.scene, now.mesh):
            free = {*vars(now.view)} - {*shown.view}
            free.remove("panes")
            assert {"layers", "layout"} <= free
            assert {name: getattr(now.view, name) for name in free} == {
                name: getattr(before.view, name) for name in free
            }
        changed = before.projection != now.projection or before.scene != now.scene
        if changed and not was_moving:  # else undo goes to where the model was going
            store.undo()
            assert store.document == replace(before, view=AS_EVER)
            assert store.look() == before.view
            store.redo()
            assert store.document == shown.document
    assert moved > 40  # and not all of them at once
    assert not messages.text


def test_undo_ends_at_the_step(walk: tuple[Store, MessageBar, Lessons]) -> None:
    store, _, lessons = walk
    before = seen_near(store, 3.0)
    lessons.next()
    arrive(lessons)
    shown = store.document
    assert not store.can_undo and not store.can_redo
    store.undo()
    assert store.document == shown
    tried = seen_near(store, 2.5)
    assert lessons.come_back()
    arrive(lessons)
    for expected in (tried, shown, shown):
        store.undo()
        assert store.document == expected
    store.redo()
    assert store.document == tried
    lessons.close()
    while store.can_undo:
        store.undo()
    assert store.document.scene == "cube", "what was open before the lesson is not lost"
    assert before.scene != "cube"


def seen_near(store: Store, near: float) -> Document:
    """The document after an edit of the near plane."""
    projection = store.document.projection
    store.set_projection(replace(projection, lens=replace(projection.lens, near=near)))
    return store.document


# --------------------------------------------------------------------------- in the window

TALK = """---
title: A talk
letters: 001
---
# Fields of $\\alpha$ {#one}
The class reads **this**, and $\\frac{1}{2}$.

```state
scene=letter-f
lens.fov_y_deg=60
```
```note
minutes: 2
Only *the speaker* reads this.
```
---
# A vote {#two}
```predict wide
How wide is it?
- [ ] 106.7° {angle-linear}
- [x] 91.5°
show: lens.near=2
why: The tangents are in proportion.
```
```note
minutes: 1.5
```
---
# The cube {#three}
```state
view.large=ndc
view.stage=pyramid
```
"""
PAGE_DOWN, PAGE_UP = Qt.Key.Key_PageDown, Qt.Key.Key_PageUp


@pytest.fixture
def window(window: MainWindow, talk: Path) -> Iterator[MainWindow]:
    """Presenting a talk, without the speaker's window, and with the keyboard."""
    window.settings.speaker_window = False
    assert window.lessons.open(talk)
    activate(window)
    press(window, Qt.Key.Key_F5)
    present(window)
    yield window
    if window.talks.speaker is not None:
        window.talks.speaker.close()


def press(window: Any, *keys: Qt.Key) -> None:
    """Press keys where the window has the keyboard."""
    for key in keys:
        QTest.keyClick(QApplication.focusWidget() or window, key)
        settle()


def speaker_of(window: MainWindow) -> SpeakerWindow:
    """The speaker's window, opened."""
    window.talks.open_speaker()
    assert window.talks.speaker is not None
    return window.talks.speaker


def change(window: MainWindow, text: str) -> None:
    """Save the open file with another text."""
    assert window.lessons.lesson is not None
    window.lessons.lesson.path.write_text(text, encoding="utf-8")
    window.lessons.read_again()
    settle()


def read_on(widget: QWidget) -> list[str]:
    """The lines that stand on a widget."""
    return [label.text() for label in widget.findChildren(QLabel) if label.isVisible()]


def timer(owner: QObject, interval_ms: int) -> QTimer:
    """The one of an owner's timers that waits so long."""
    (found,) = (each for each in owner.findChildren(QTimer) if each.interval() == interval_ms)
    return found


def is_asked(window: MainWindow) -> bool:
    """Whether somebody asks of an event what it is before Qt hands it to the window."""
    asked = []

    class Noted(QEvent):
        def type(self) -> QEvent.Type:
            asked.append(self)
            return super().type()

    QApplication.sendEvent(window.statusBar(), Noted(QEvent.Type.User))
    return bool(asked)


def documents_of(band: QWidget) -> list[QTextDocument]:
    """What a band or a question shows; a band may have laid out others for the next step."""
    is_band = isinstance(band, TalkBand)
    return [band.laid.title, band.laid.words] if is_band else band.findChildren(QTextDocument)


def column(band: QWidget, text: str) -> QTextDocument:
    """The document of a band or a question that a text stands in."""
    columns = documents_of(band)
    (found,) = (each for each in columns if text in each.toPlainText())
    return found


def letters_px(band: QWidget, text: str) -> int:
    """How large a text stands there."""
    return column(band, text).defaultFont().pixelSize()


def has_room(band: QWidget) -> bool:
    """Whether all that a question says is seen: the wheel moves nothing."""
    before, none = band.grab().toImage(), Qt.MouseButton.NoButton
    for turned in (-1200, 1200):
        at, turn = QPointF(band.rect().center()), QPoint(0, turned)
        held, phase = Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase
        wheel = QWheelEvent(at, band.mapToGlobal(at), QPoint(), turn, none, held, phase, False)
        QApplication.sendEvent(band, wheel)
        if band.grab().toImage() != before:
            return False
    return True


def asked(window: MainWindow) -> str:
    """What a class is asked or told just now."""
    question = window.slide.question
    return question.accessibleName() if question.isVisible() else ""


def type_number(window: MainWindow, number: int) -> None:
    press(window, *(Qt.Key(Qt.Key.Key_0.value + int(digit)) for digit in str(number)))


@pytest.mark.undrawn
def test_the_keys_of_a_clicker(window: MainWindow) -> None:
    lessons, present = window.lessons, window.present
    assert present.is_on and lessons.place == 0
    found = []
    keys = Qt.Key
    for key in (
        *(PAGE_DOWN,) * 5, *(PAGE_UP,) * 3, keys.Key_Period, keys.Key_Period,
        keys.Key_B, PAGE_UP, keys.Key_Escape,
    ):  # fmt: skip
        press(window, key)
        if key == PAGE_DOWN and len(found) == 4:
            assert window.band.message == "This is the last step."
        found.append((lessons.place, window.lessons.player.revealed, present.is_blank))
    assert found == [
        (1, 0, False), (1, 1, False), (1, 2, False), (2, 0, False), (2, 0, False),
        (1, 2, False), (1, 1, False), (1, 0, False),  # the same way back
        (1, 0, True), (1, 0, False), (1, 0, True),
        (0, 0, False),  # nobody goes on in the dark
        (0, 0, False),
    ]  # fmt: skip
    assert not present.is_on


@pytest.mark.undrawn
def test_a_key_without_effect_says_why_and_the_times_have_names(window: MainWindow) -> None:
    press(window, Qt.Key.Key_W)
    assert window.band.message == "There is only one screen."
    go_to(window.lessons, 2)
    press(window, PAGE_DOWN)
    assert window.band.message == "This is the last step."
    assert {"Time", "Elapsed"} <= {*read_on(speaker_of(window))}


@pytest.mark.undrawn
def test_digits_and_enter_jump(window: MainWindow) -> None:
    type_number(window, 3)
    assert window.band.message == "To step 3…" and window.lessons.place == 0
    press(window, Qt.Key.Key_Return)
    assert (window.lessons.place, window.band.message) == (2, "")
    type_number(window, 999)
    press(window, Qt.Key.Key_Enter)
    assert window.lessons.place == 2
    assert window.band.message == "There is no step 999; the last is 3."
    type_number(window, 1)
    press(window, Qt.Key.Key_Escape)
    assert window.band.message == "" and window.present.is_on
    type_number(window, 1)
    timer(window.talks, TYPED_MS).timeout.emit()  # a pause
    press(window, Qt.Key.Key_Return)
    assert window.lessons.place == 2


@pytest.mark.undrawn
def test_a_field_takes_what_is_typed(window: MainWindow) -> None:
    field = window.controls.rows["near"].field
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "3.5")
    press(window, Qt.Key.Key_Return)
    assert window.store.document.projection.lens.near == 3.5
    assert window.lessons.place == 0 and not window.present.is_blank
    press(window, PAGE_DOWN)  # which is nobody's there
    assert window.lessons.place == 1
    window.setFocus()


def test_without_presenting_the_keys_belong_to_the_pane(window: MainWindow) -> None:
    window.talks.open_speaker()  # where they are the talk's all the same
    activate(window)
    press(window, Qt.Key.Key_Escape)
    window.panes["image"].canvas.setFocus()
    press(window, PAGE_DOWN)
    assert window.lessons.place == 0 and window.cursors["image"].text
    press(window, Qt.Key.Key_F5)
    window.panes["image"].canvas.setFocus()
    press(window, PAGE_DOWN)
    assert window.lessons.place == 1
    window.setFocus()


@pytest.mark.undrawn
def test_panels_open_by_steps_and_by_hand_come_back_as_presenting_ends(window: MainWindow) -> None:
    change(window, TALK.replace("view.large=ndc", "view.panel=matrices\nview.large=ndc"))
    go_to(window.lessons, 2)
    assert window.panels.open_panel is window.matrices
    press(window, PAGE_UP)
    arrive(window.lessons)
    assert window.panels.open_panel is None
    press(window, Qt.Key.Key_Escape)
    assert not window.present.is_on and window.panels.open_panel is None
    assert not window.lessons.is_away
    window.panels.open(window.matrices)
    press(window, Qt.Key.Key_F5)
    assert window.present.is_on and window.panels.open_panel is None
    press(window, Qt.Key.Key_Escape)
    assert window.panels.open_panel is window.matrices


AROUND = lesson_of(
    "scene=letter-f\ncamera.eye=6,3,9\ncamera.target=0,1,0",
    "camera.eye=-9,2,0.5\nview.fixed=side",
    "camera.eye=0.5,1,-10\nview.fixed=",
    "camera.eye=8,2,-4",
)


def test_an_unturned_pane_looks_the_same_whichever_step_came_first(window: MainWindow) -> None:
    def looks() -> tuple[np.ndarray, ...]:
        drawing = window.panes["world"].drawing
        assert isinstance(drawing, WorldDrawing)
        window.look.rest()
        return drawing.own.pane.axes, drawing.own.pane.eye

    change(window, AROUND)
    go_to(window.lessons, 0)
    go_to(window.lessons, 2)
    window.panes["world"].reset_view()
    settle()
    wanted = looks()
    for way in ((0, 1, 2), (1, 0, 2), (1, 2), (3, 2), (0, 3, 1, 2)):
        for place in way:
            go_to(window.lessons, place)
            settle()
        for found, other in zip(looks(), wanted, strict=True):
            np.testing.assert_allclose(found, other, atol=1e-9, err_msg=str(way))


def test_presenting_without_a_talk_is_unchanged(window: MainWindow) -> None:
    window.lessons.close()
    settle()
    assert window.present.is_on and window.band.isHidden()
    window.panes["image"].canvas.setFocus()
    press(window, PAGE_DOWN, Qt.Key.Key_3, Qt.Key.Key_Return)
    assert window.lessons.course is None
    window.setFocus()


@pytest.mark.undrawn
def test_a_prediction_is_answered_by_the_state_that_it_shows(window: MainWindow) -> None:
    def near() -> float:
        return float(window.store.document.projection.lens.near)

    go_to(window.lessons, 1)
    first = near()
    assert not asked(window), "the picture comes first"
    press(window, Qt.Key.Key_V)
    assert "How wide is it? A 106.7° B 91.5°" in asked(window)
    press(window, Qt.Key.Key_Period)
    press(window, Qt.Key.Key_V)  # nobody is answered in the dark
    assert window.lessons.is_moving and not window.present.is_blank
    assert not asked(window), "nothing hides what moves"
    arrive(window.lessons)
    said = asked(window)
    assert near() == 2.0 and "B 91.5° ✓" in said
    press(window, Qt.Key.Key_V)  # there is no other
    press(window, PAGE_DOWN, PAGE_UP)  # as it was left
    arrive(window.lessons)
    assert near() == 2.0 and asked(window) == said
    press(window, PAGE_UP)
    arrive(window.lessons)
    assert near() == first and "✓" not in asked(window)


@pytest.mark.undrawn
def test_a_question_and_the_pen_lie_over_the_kinds_and_hide_few(window: MainWindow) -> None:
    kinds = "# A vote {#two}\n```state\nview.slide=kinds\n```"
    text = TALK.replace("# A vote {#two}", kinds).replace("large=ndc", "slide=ndc")
    change(window, text)
    go_to(window.lessons, 1)
    press(window, PAGE_DOWN)
    assert window.kinds_panel.isVisible() and "106.7" in asked(window)
    go_to(window.lessons, 2)
    assert not window.kinds_panel.isVisible() and window.panes["ndc"].isVisible()
    press(window, PAGE_UP, PAGE_DOWN, Qt.Key.Key_D)
    arrive(window.lessons)
    assert window.kinds_panel.isVisible() and "91.5" in asked(window)
    slide, pen = window.slide, window.slide.pen
    assert pen.isVisible() and pen.size() == slide.size()
    press(window, Qt.Key.Key_D)
    assert slide.childAt(slide.question.geometry().center()) is slide.question
    place = QRect(slide.question.mapToGlobal(QPoint()), slide.question.size())
    nodes = window.kinds_panel.nodes.values()
    boxes = [QRect(node.mapToGlobal(QPoint()), node.size()) for node in nodes]
    assert sum(place.intersects(box) for box in boxes) < len(boxes) / 2
    press(window, Qt.Key.Key_F5)
    assert window.panels.isVisible() and window.panels.parent() is window.drawer
    assert slide.height() > window.panels.height() > 0


@pytest.mark.undrawn
def test_the_second_way_of_a_key_is_one_of_the_talk_too(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    """macOS has it, where the speaker's window has no action with such a key."""
    ways = [QKeySequence("F7"), QKeySequence("Meta+7")]
    monkeypatch.setattr(talk_keys, "ways_to_press", lambda _key: ways)
    shown = window.store.document
    window.store.set_projection(replace(shown.projection, depth="reversed"))
    QTest.keyClick(window, Qt.Key.Key_7, Qt.KeyboardModifier.MetaModifier)
    arrive(window.lessons)
    assert window.store.document == shown and not window.lessons.is_away


@pytest.mark.undrawn
def test_the_strip_shows_the_values_of_the_step_that_has_come(window: MainWindow) -> None:
    volumes = "scene=view-volumes\nsettings.volume={0}\nview.controls=settings.volume"
    states = "scene=letter-f", volumes.format("cone"), volumes.format("box"), "scene=letter-f"
    change(window, lesson_of(*states))
    for place, volume in ((0, ""), (1, "cone"), (2, "box"), (3, ""), (1, "cone"), (2, "box")):
        go_to(window.lessons, place)
        settle()
        rows = window.control_strip.rows
        assert [row.value() for row in rows] == ([volume] if volume else [])
    press(window, Qt.Key.Key_C, Qt.Key.Key_C)
    assert window.control_strip.rows[0].value() == "box"


@pytest.mark.undrawn
def test_a_strip_that_comes_is_filled_once(window: MainWindow) -> None:
    stripped = "settings.volume=cone\nview.controls=settings.volume"
    change(window, lesson_of("scene=view-volumes", stripped))
    go_to(window.lessons, 0)
    settle()
    filled = list[object]()
    window.control_strip.grips_wanted.connect(filled.append)
    assert window.lessons.go(1)
    assert window.control_strip.isVisible() and len(filled) == 1


@pytest.mark.undrawn
def test_the_band_is_above_the_panes_and_never_moves_them(window: MainWindow) -> None:
    band = window.band
    assert band.isVisible()
    assert "The class reads this" in band.accessibleName()
    assert "Only the speaker" not in band.accessibleName()
    places = []
    for place in range(3):
        go_to(window.lessons, place)
        settle()
        below = band.mapToGlobal(band.rect().bottomLeft()).y()
        for pane in window.panes.values():
            assert pane.mapToGlobal(pane.rect().topLeft()).y() >= below
        places.append(window.slots.geometry())
    assert len(set(map(repr, places))) == 1
    go_to(window.lessons, 0)
    assert letters_px(band, "The class reads") == round(LINES[0] * window.screen().size().height())
    assert not window.lesson_card.isVisible()  # which would say it again
    window.present.end()
    settle()
    assert band.isHidden()


# --------------------------------------------------------------------------- the speaker's window


def test_the_speaker_sees_that_the_screen_is_black(window: MainWindow, qtbot: Any) -> None:
    window.talks.open_speaker()
    speaker = window.talks.speaker
    assert speaker is not None

    def middle() -> str:
        image = speaker.now.pixmap().toImage()
        return "" if image.isNull() else image.pixelColor(image.rect().center()).name()

    for is_black in (False, True, False):
        qtbot.waitUntil(lambda black=is_black: middle() != "" and (middle() == "#000000") is black)
        window.present.blank()


@pytest.mark.undrawn
def test_the_speakers_window(window: MainWindow) -> None:
    window.talks.open_speaker()
    speaker = window.talks.speaker
    assert speaker is not None and speaker.isVisible() and speaker.isWindow()
    activate(speaker)
    for presents in (False, True):
        QTest.keyClick(speaker, Qt.Key.Key_F5)
        assert window.present.is_on is presents
    assert is_asked(window)
    assert "Only the speaker reads this." in speaker.notes.toPlainText()
    assert "Next: A vote" in read_on(speaker)
    assert "step 1 of 3" in read_on(speaker)
    assert "planned 0 to 2 min" in read_on(speaker)
    assert speaker.steps.count() == 3
    speaker.draw_next()
    assert not speaker.picture.pixmap().isNull()
    first = speaker.picture.pixmap().toImage()
    speaker.activateWindow()
    speaker.notes.setFocus()
    for key, place in ((PAGE_DOWN, 1), (PAGE_UP, 0)):
        QTest.keyClick(speaker.notes, key)
        settle()
        assert window.lessons.place == place
    QTest.keyClick(speaker.notes, Qt.Key.Key_Period)
    assert window.present.is_blank
    QTest.keyClick(speaker, Qt.Key.Key_B)
    assert not window.present.is_blank
    speaker.jump_wanted.emit(2)
    settle()
    assert window.lessons.place == 1
    assert "planned 2 to 3.5 min" in read_on(speaker)
    asked = "How wide is it?\nA 106.7°\nB 91.5° ✓\nThe tangents are in proportion."
    assert speaker.notes.toPlainText().replace("\u2028", "\n") == asked
    speaker.draw_next()
    assert speaker.picture.pixmap().toImage() != first  # the cube: another pane leads
    go_to(window.lessons, 2)
    assert "This is the last step." in read_on(speaker)
    assert speaker.picture.pixmap().isNull()
    QTest.keyClick(speaker, Qt.Key.Key_Escape)
    assert not window.present.is_on
    QTest.keyClick(speaker, PAGE_UP)  # it goes on without presenting
    assert window.lessons.place == 1
    speaker.close()
    assert window.talks.speaker is None
    assert not is_asked(window)  # or every event of every window would wait for it


@pytest.mark.undrawn
def test_shift_f5_in_the_speakers_window_presents_from_the_first_step(window: MainWindow) -> None:
    speaker = speaker_of(window)
    activate(speaker)
    for presents in (True, False):
        go_to(window.lessons, 2)
        if not presents:
            window.present.end()
        QTest.keyClick(speaker, Qt.Key.Key_F5, Qt.KeyboardModifier.ShiftModifier)
        settle()
        assert window.present.is_on and window.lessons.place == 0


@pytest.mark.undrawn
def test_the_focus_in_the_speakers_notes_is_seen(window: MainWindow) -> None:
    speaker = speaker_of(window)
    activate(speaker)
    speaker.notes.setFocus()
    focused = speaker.notes.grab().toImage()
    speaker.next.setFocus()
    assert speaker.notes.grab().toImage() != focused


def test_enlarged_notes_stay_enlarged(window: MainWindow, tmp_path: Path) -> None:
    speaker, settings = speaker_of(window), window.settings
    before = settings.notes_px
    for times, key, size in ((40, Qt.Key.Key_Plus, 72), (25, Qt.Key.Key_Minus, before)):
        for _ in range(times):
            QTest.keyClick(speaker, key, Qt.KeyboardModifier.ControlModifier)
        assert settings.notes_px == speaker.notes.document().defaultFont().pixelSize() == size
    path = tmp_path / "settings.ini"
    settings = Settings(path)  # the name of "All digits" has a hyphen there
    settings.speaker_window, settings.notes_px, settings.all_digits = False, 30, True
    again = Settings(path)
    assert (again.speaker_window, again.notes_px, again.all_digits) == (False, 30, True)
    assert len([*tmp_path.glob("settings*")]) == 1


@pytest.mark.undrawn
def test_it_is_closed_with_the_window(make_window: Callable[..., MainWindow], talk: Path) -> None:
    window = make_window()
    window.lessons.open(talk)
    window.talks.open_speaker()
    window.close()
    assert window.talks.speaker is None
    assert not [top for top in QApplication.topLevelWidgets() if top.isVisible()]


@pytest.mark.undrawn
def test_a_screen_goes_away_and_both_windows_stay(window: MainWindow, qtbot: Any) -> None:
    speaker = speaker_of(window)
    for gone in (window, speaker):  # as on a screen that is not there any more
        gone.windowHandle().setGeometry(QRect(9000, 9000, 800, 600))
        qtbot.waitUntil(lambda gone=gone: gone.geometry().x() == 9000)
    application = QApplication.instance()
    assert isinstance(application, QGuiApplication)
    application.screenRemoved.emit(application.primaryScreen())
    settle()
    room = window.screen().availableGeometry()
    qtbot.waitUntil(lambda: room.contains(speaker.geometry()))
    assert window.isVisible() and window.present.is_on
    qtbot.waitUntil(lambda: window.geometry() == window.screen().geometry())
    press(window, PAGE_DOWN)
    assert window.lessons.place == 1
    assert "step 2 of 3" in read_on(speaker)


def test_the_clock_of_a_talk_can_be_paused_and_reset() -> None:
    now = [100.0]
    clock = TalkClock(lambda: now[0])

    def after(seconds: float) -> tuple[float, bool]:
        now[0] += seconds
        return clock.seconds, clock.is_running

    assert after(0.0) == (0.0, False)
    clock.begin()
    assert after(65.0) == (65.0, True)
    clock.toggle()
    assert after(30.0) == (65.0, False)
    clock.begin()  # the talk is presented again: it was paused on purpose
    assert after(0.0) == (65.0, False)
    clock.toggle()
    assert after(5.0) == (70.0, True)
    clock.reset()
    assert after(2.0) == (2.0, True)


@pytest.mark.undrawn
def test_the_clock_counts_while_a_talk_is_presented(window: MainWindow) -> None:
    speaker = speaker_of(window)
    assert speaker.clock.is_running
    window.talks.jump(3)  # for which no time is planned
    assert "planned 3.5 min" in read_on(speaker)
    speaker.clock.toggle()
    told = speaker.clock.seconds
    assert told > 0.0
    speaker.close()
    speaker = speaker_of(window)  # closed by mistake, and opened again
    assert speaker.clock.seconds == told and not speaker.clock.is_running
    speaker.close()
    press(window, Qt.Key.Key_F5)
    assert not speaker_of(window).clock.is_running
    settle()
    window.settings.speaker_window = True
    window.talks.close_speaker()
    window.present.begin()
    settle()
    speaker = speaker_of(window)  # it opens with a talk if that is wanted
    assert speaker.clock.is_running
    window.lessons.close()
    settle()
    assert window.talks.speaker is None


# --------------------------------------------------------------------------- files


@pytest.mark.undrawn
def test_a_state_is_added_and_shown_as_a_step(window: MainWindow, talk: Path) -> None:
    tried = replace(window.store.document.projection.lens, near=1.25)
    window.store.set_projection(replace(window.store.document.projection, lens=tried))
    assert window.talks.writer.write_step("By hand", panes=False)
    settle()
    # Behind the steps that go on from the first.
    assert [step.name for step in window.lessons.lesson.steps] == ["one", "two", "three", "by-hand"]  # type: ignore[union-attr]
    assert window.lessons.place == 3
    assert window.store.document.projection.lens.near == 1.25
    assert not window.lessons.is_away
    assert talk.read_text(encoding="utf-8").startswith(TALK.rstrip("\n"))
    assert window.band.accessibleName() == "By hand"
    assert not window.talks.writer.write_step("", panes=False)
    assert "must be one line of text" in window.messages.text
    text = talk.read_text(encoding="utf-8")
    talk.unlink()
    assert not window.talks.writer.write_step("More", panes=False)
    assert "talk.md is not in its folder any more" in window.messages.text
    assert "A new talk from here" in window.messages.text
    talk.write_text(text, encoding="utf-8")
    window.messages.done()


@pytest.mark.undrawn
def test_a_new_talk_begins_with_what_is_seen(window: MainWindow, tmp_path: Path) -> None:
    document = window.store.document
    path = tmp_path / "new.md"
    assert window.talks.writer.write_talk(path, "New", panes=False)
    settle()
    assert window.lessons.lesson is not None and window.lessons.lesson.path == path
    assert window.store.document == document
    assert not window.talks.writer.write_talk(tmp_path / "nowhere" / "new.md", "New", panes=False)
    assert "nowhere" in window.messages.text
    assert window.lessons.lesson.path == path
    window.messages.done()


@pytest.mark.undrawn
def test_a_faulty_or_deleted_file_leaves_the_last_good_lesson(
    window: MainWindow, talk: Path
) -> None:
    press(window, PAGE_DOWN)
    course, document = window.lessons.course, window.store.document
    speaker = speaker_of(window)
    wrong: list[tuple[Callable[[], object], str]] = [
        (lambda: talk.write_text("---\n", encoding="utf-8"), "line"),
        (
            lambda: talk.write_text(TALK.replace("y_deg=60", "y_deg=600"), encoding="utf-8"),
            "talk.md: line 10",
        ),
        (lambda: talk.write_text(TALK + "---\n# x\n" * MOST_STEPS * 20, encoding="utf-8"), "steps"),
        (talk.unlink, "does not exist"),
    ]
    for act, said in wrong:
        act()
        window.lessons.read_again()
        settle()
        assert any(said in text for text in read_on(speaker))
        assert not window.messages.text  # which the class would read
        assert window.lessons.course is course and window.store.document == document
    speaker.close()
    settle()
    activate(window)
    press(window, PAGE_DOWN, PAGE_DOWN, PAGE_DOWN)
    assert window.lessons.place == 2
    change(window, TALK.replace("The cube", "Its cube"))
    settle()
    assert window.band.accessibleName() == "Its cube"


@pytest.mark.undrawn
def test_a_faulty_file_is_reported_once_presenting_has_ended(window: MainWindow) -> None:
    """On one screen the speaker's window may be hidden behind the other one."""
    change(window, "# {#one")
    assert not window.messages.text
    assert window.band.message == "The file was changed, and cannot be read."  # on the one screen
    speaker = speaker_of(window)
    assert any("talk.md" in text for text in read_on(speaker))
    change(window, TALK)
    assert not any("talk.md" in text for text in read_on(speaker))
    activate(window)
    change(window, TALK.replace("fov_y_deg=60", "fov_y_deg=600"))
    assert not window.messages.text
    press(window, Qt.Key.Key_Escape)
    assert not window.present.is_on and "talk.md: line 10" in window.messages.text
    press(window, Qt.Key.Key_F5)
    assert window.present.is_on and not window.messages.text
    assert window.band.message == "The file was changed, and cannot be read."
    press(window, Qt.Key.Key_F5)
    assert "talk.md: line 10" in window.messages.text
    change(window, TALK)
    assert not window.messages.text
    change(window, "---\n")
    assert "talk.md: line" in window.messages.text


MESHES = TALK.replace("view.large=ndc\nview.stage=pyramid", "document: house.json")
TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


@pytest.mark.undrawn
@pytest.mark.parametrize("known", [False, True], ids=["never-seen", "seen-before"])
def test_an_impossible_step_is_reported_to_the_speaker_not_the_class(
    window: MainWindow, talk: Path, known: bool
) -> None:
    mesh = talk.with_name("house.obj")
    mesh.write_text(TRIANGLE, encoding="utf-8")
    document = Document(str(mesh), scene_of(Document("cube")).start)
    talk.with_name("house.json").write_text(to_json(document), encoding="utf-8")
    talk.write_text(MESHES, encoding="utf-8")
    assert window.lessons.open(talk)
    speaker = speaker_of(window)
    if known:
        go_to(window.lessons, 2)
    go_to(window.lessons, 1)
    press(window, Qt.Key.Key_V, Qt.Key.Key_V)
    arrive(window.lessons)
    mesh.unlink()
    for number in range(40):  # no mesh is kept as long as others are asked for
        other = talk.with_name(f"{number}.obj")
        other.write_text(TRIANGLE, encoding="utf-8")
        scene_of(Document(str(other), document.projection))
    shown = window.store.document
    said = f"talk.md: line {MESHES.splitlines().index('document: house.json')} cannot be shown: "
    timer(window.talks, REST_MS).timeout.emit()
    while timer(window.talks, 0).isActive():
        settle()  # what is made ahead says nothing
    assert not window.messages.text and not any(said in text for text in read_on(speaker))
    for way in (lambda: press(speaker, PAGE_DOWN), lambda: window.talks.jump(3)):
        way()
        assert [text for text in read_on(speaker) if said in text and "house.obj" in text]
        assert window.lessons.place == 1 and window.store.document == shown
        assert not window.messages.text and not window.band.message
        press(speaker, Qt.Key.Key_1, Qt.Key.Key_Escape)
        window.lessons.read_again()  # a folder that changes, but not the file
        assert any(said in text for text in read_on(speaker))
    talk.write_text("---\n", encoding="utf-8")  # what is wrong since then is said instead
    window.lessons.read_again()
    assert not any(said in text for text in read_on(speaker))
    change(window, MESHES)
    window.talks.jump(3)
    assert any(said in text for text in read_on(speaker))
    window.talks.jump(2)  # what can be shown again takes it back
    assert not any(said in text for text in read_on(speaker))
    speaker.close()
    settle()
    window.talks.jump(3)
    assert said in window.messages.text
    window.talks.jump(1)
    assert not window.messages.text


def test_an_answer_turns_panes_as_it_says_and_else_leaves_them(
    window: MainWindow, talk: Path
) -> None:
    pane, own = window.panes["world"], Camera((9.0, 5.0, 4.0), (0.0, 1.0, 0.0))
    for shows, view in (
        ("lens.near=2", own),
        ("view.panes=world: 6,4,8,1,2,3", Camera((6.0, 4.0, 8.0), (1.0, 2.0, 3.0))),
        ("lens.near=2; view.panes=world: 6,4,8,1,2,3", Camera((6.0, 4.0, 8.0), (1.0, 2.0, 3.0))),
    ):
        change(window, TALK.replace("show: lens.near=2", f"show: {shows}"))
        go_to(window.lessons, 0)
        go_to(window.lessons, 1)
        pane.look_from(own)
        assert window.talks.reveal() and window.talks.reveal()
        tick(window.lessons, TRANSITION_S)
        assert pane.view == view, shows


@pytest.mark.undrawn
def test_an_impossible_state_of_a_prediction_is_reported_to_the_speaker(
    window: MainWindow, talk: Path
) -> None:
    text = TALK.replace("show: lens.near=2", "show: lens.near=99")
    change(window, text)
    speaker = speaker_of(window)
    go_to(window.lessons, 1)
    shown = window.store.document
    assert window.talks.reveal() and window.talks.reveal()
    line = text.splitlines().index("show: lens.near=99") + 1
    assert any(f"talk.md: line {line}, lens.near = 99" in said for said in read_on(speaker))
    assert window.store.document == shown and not window.messages.text
    assert "B 91.5° ✓" in asked(window)  # it can be said without


def asked_of(step: Step, *, told: bool) -> str:
    question = next((part for part in step.parts if part.reveals), None)
    if question is None:
        return ""
    return question.explained("", others=False) if told else question.posed()


ASKED = (
    TALK
    + """---
# Two numbers and a vote {#asked}
```state
scene=letter-f
lens.fov_y_deg=60
```
Three questions.
```answer width
How wide is it?
value: fov_x
unit: °
wrong angle-linear: aspect*fov
why: The tangents are in proportion.
```
```task
Make it square.
until: fov_x = fov
```
```answer
Is it higher than wide?
- [ ] yes
- [x] no
```
```predict
And from far away?
- [x] the same
- [ ] less
show: lens.near=3
```
---
# Nothing more {#last}
"""
)


@pytest.mark.undrawn
def test_the_speaker_reads_answers_and_tasks_beforehand(window: MainWindow, talk: Path) -> None:
    change(window, ASKED)
    go_to(window.lessons, 3)
    speaker = speaker_of(window)
    assert speaker.notes.toPlainText().replace("\u2028", "\n") == (
        "How wide is it?\n91.49° ✓\nThe tangents are in proportion.\nMake it square.\n"
        "Is it higher than wide?\nA yes\nB no ✓\n"
        "And from far away?\nA the same ✓\nB less"
    )
    for said in ("question", "answer", "question"):
        assert f"Next: the {said}; later: Nothing more" in read_on(speaker)
        press(speaker, Qt.Key.Key_V)
    window.talks.jump(5)
    assert "This is the last step." in read_on(speaker)


@pytest.mark.undrawn
def test_an_answer_without_a_value_is_reported_and_the_talk_continues(
    window: MainWindow, talk: Path
) -> None:
    text = ASKED.replace("value: fov_x", "value: ndc_x")
    change(window, text)
    go_to(window.lessons, 3)
    press(window, PAGE_DOWN, PAGE_DOWN)
    line = text.splitlines().index("value: ndc_x") + 1
    assert f"talk.md: line {line} has no value in this state" in window.messages.text
    assert "The tangents are in proportion." in asked(window)
    press(window, PAGE_DOWN)
    assert "Is it higher than wide?" in asked(window)
    assert not window.messages.text


def test_the_band_shows_two_lines_and_leaves_the_rest_to_the_notes(
    display: Any, talk: Path
) -> None:
    band = TalkBand()
    band.resize(1366, 10)
    band.set_screen(768.0)
    high = round((TOP_SHARE + TITLE_SHARE + GAP_SHARE + LINE_SHARE) * 768)
    too_high = "$$k = \\frac{\\frac{h}{\\frac{w}{2}}}{2} = 1$$"
    cases = {
        "reads **this**": ("The class reads this, and", ""),
        "reads **this**" + " and more" * 60: ("The class reads this and more", "The class reads"),
        f"reads\n\n| | |\n|---|---|\n| 1 | 2 |\n\n{too_high}\n\nThis": ("reads", "| 1 | 2 |"),
        "reads **this**.\n\n" + "More. " * 60: ("The class reads this.", "More."),
        "reads **this**.\n\n" + "More. " * 60 + "\n\n$$\\frac{a}{b} = c$$\n\n": (
            "a over b equals c",
            "The class reads",
        ),
    }
    for text, (shown, left) in cases.items():
        step = parse_lesson(TALK.replace("reads **this**", text), talk).steps[0]
        band.show_step(step, "1 / 3")
        assert shown in band.accessibleName()
        assert left in band.laid.left_out and bool(left) == bool(band.laid.left_out)
        assert band.height() == high and band.height() <= 0.165 * 768
        for document in documents_of(band):
            assert document.size().height() <= LINE_SHARE * 768
            least = (SMALLER if band.laid.is_cut else LINES)[-1]
            assert document.defaultFont().pixelSize() >= math.floor(least * 768)


def ink_rows(band: TalkBand, title: str, parts: Any) -> np.ndarray:
    """The rows of the band that the letters reach."""
    band.show_step(SimpleNamespace(title=title, parts=parts), "")  # type: ignore[arg-type]
    return np.nonzero((rgb_of(band.grab().toImage()) < 140).any(axis=(1, 2)))[0]


def test_no_fraction_touches_the_title(display: Any) -> None:
    band = TalkBand()
    for head, size in zip(heads(talks=True), cycle([(1366, 768), (1920, 1080)]), strict=False):
        band.set_screen(float(size[1]))
        band.resize(size[0], band.height())
        for step in read(head.path).steps:
            title = ink_rows(band, step.title, ())
            if "$" in step.title:
                assert documents_of(band)[0].defaultFont().pixelSize() == round(0.036 * size[1]), (
                    step.title
                )
            if (line := ink_rows(band, "", step.parts)).size:
                assert line[0] - title[-1] > 0.009 * size[1], (head.path.stem, step.title)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("A vector $\\vec{look}$ " * 40, "A vector look A vector look"),
        ("$$k = \\frac{\\frac{h}{\\frac{w}{2}}}{\\frac{2}{3}} = 1$$", "k equals ("),
        ("|a|\n|---|\n|1|", ""),
    ],
)
def test_no_text_vanishes_because_it_is_too_long_or_too_high(
    display: Any, talk: Path, text: str, shown: str
) -> None:
    band = TalkBand()
    band.resize(1366, 10)
    band.set_screen(768.0)
    there = "The class reads **this**, and $\\frac{1}{2}$."
    band.show_step(parse_lesson(TALK.replace(there, text), talk).steps[0], "1 / 3")
    assert band.accessibleName().startswith(f"Fields of alpha {shown}".strip())
    assert band.laid.is_cut == bool(shown) and bool(band.laid.left_out) != text.startswith("$$")
    words = documents_of(band)[1]
    assert words.size().height() <= LINE_SHARE * 768


MOST_HIDDEN = 0.001  # of the slide: a corner of a frame


def no_ink(boxes: np.ndarray) -> np.ndarray:
    return np.zeros(len(boxes))


def coloured_px(window: MainWindow, place: QRect) -> int:
    """How many pixels of a part of the slide are neither grey nor pale, without the question."""
    window.slide.question.hide()
    part = rgb_of(window.slide.grab(place).toImage()).astype(int)
    window.slide.question.show()
    return int((np.ptp(part, axis=2) > 80).sum())


def frame_sides(window: MainWindow) -> Iterator[QRectF]:
    """The sides of the shown pictures' frames, in the slide's pixels."""
    for pane in window.slide.findChildren(Pane):
        canvas, drawing = pane.canvas, pane.drawing
        if drawing is None or drawing.pane != "image" or not canvas.isVisible():
            continue
        left, top, wide, tall = np.array(drawing.picture_rectangle_px) / canvas.pixel_ratio
        corner = canvas.mapTo(window.slide, QPointF(left, top))
        for x, y, w, h in (
            (0, 0, wide, 1),
            (0, tall, wide, 1),
            (0, 0, 1, tall),
            (wide, 0, 1, tall),
        ):
            yield QRectF(corner.x() + x, corner.y() + y, w, h)


@pytest.mark.parametrize(
    ("numbers", "size"),
    [(("000", "003", "004"), (1366, 768)), (("001", "002"), (1920, 1080))],
)
def test_no_question_of_a_talk_lies_over_what_is_drawn(
    window: MainWindow,
    monkeypatch: pytest.MonkeyPatch,
    numbers: tuple[str, ...],
    size: tuple[int, int],
) -> None:
    """Neither over a name nor over what has a colour: the ground's grey lines may be hidden."""
    there = SimpleNamespace(size=lambda: QSize(*size), geometry=lambda: QRect(0, 0, *size))
    monkeypatch.setattr(MainWindow, "screen", lambda _window: there)
    question, slide, hides = window.slide.question, window.slide, {}
    for number in numbers:
        window.present.end()
        assert window.lessons.open(CONTENT / f"talk-{number}.md")
        present(window)
        assert window.lessons.lesson is not None
        for place, step in enumerate(window.lessons.lesson.steps):
            if any(part.reveals for part in step.parts):
                go_to(window.lessons, place)
            while any(part.reveals for part in step.parts) and window.talks.reveal():
                tick(window.lessons, TRANSITION_S)
                settle()
                box = question.geometry()
                names = [each.toAlignedRect() for boxes, _ in slide.named() for each in boxes]
                sides = [QRectF(box).intersects(each) for each in frame_sides(window)]
                hidden = sum(map(box.intersects, names)), coloured_px(window, box), sum(sides)
                most = 0, MOST_HIDDEN * slide.width() * slide.height(), 0
                if np.greater(hidden, most).any():
                    hides[number, step.name, asked(window)[:20]] = hidden
    assert not hides


def test_a_question_hides_the_fewest_names(display: Any) -> None:
    slide, named = QWidget(), list[QRectF]()
    slide.resize(1000, 600)
    question = QuestionOverlay(slide, lambda: [(named, no_ink)])
    slide.show()
    corners = []
    for box in ((), (20, 580, 5, 5), (980, 580, 5, 5), (0, 580, 1000, 5), (0, 20, 300, 5)):
        named += [QRectF(*box)] if box else []
        question.show_text("How wide is it?  \n**A** 1  \n**B** 2", 600.0)
        place = question.geometry()
        assert not any(place.intersects(each.toRect()) for each in named)
        assert slide.rect().contains(place) and place.height() <= 200
        corners.append((place.left() > 0, place.right() < 999, place.top() > 0))
    assert corners == [
        (False, True, True), (True, False, True), (True, True, True), (False, True, False),
        (True, False, False),
    ]  # fmt: skip
    for beside in (None, 3.0):
        named[:] = [] if beside is None else [QRectF(place.right() + beside, place.top(), 5, 5)]
        question.show_text("How wide is it?  \n**A** 1  \n**B** 2", 600.0)
        place = question.geometry()
    clear = QRectF(place).adjusted(-5.0, -5.0, 5.0, 5.0)
    assert not any(clear.intersects(each) for each in named), "it does not touch a name"
    named[:] = [QRectF(175.0, 0.0, 825.0, 600.0), QRectF(0.0, 0.0, 175.0, 310.0)]
    question.show_text("It is turned by 90° about z, then moved by 3. How high is it?", 600.0)
    assert question.geometry().right() < 175, "narrow, beside the bracket of a matrix"
    frame = QRectF(100.0, 1.0, 800.0, 598.0)

    def crossed(boxes: np.ndarray) -> np.ndarray:
        """The ink of a picture's frame that leaves no room beside it."""
        rects = [QRectF(left, top, right - left, low - top) for left, top, right, low in boxes]
        is_clear = [frame.contains(each) or not frame.intersects(each) for each in rects]
        return np.where(is_clear, 0.0, 1e5)

    question = QuestionOverlay(slide, lambda: [([], crossed)])
    question.show_text("How wide is it?  \n**A** 1  \n**B** 2", 600.0)
    assert frame.contains(QRectF(question.geometry())), "inside, rather than over a side of it"
    question = QuestionOverlay(slide, lambda: [(named, no_ink)])
    named[:] = [QRectF(0.0, 5.0, 1000.0, 5.0), QRectF(0.0, 5.0, 680.0, 590.0)]
    question.show_text("How wide is what the camera sees at this distance?\n\n" * 4, 600.0)
    place = question.geometry()
    assert 200 < place.height() <= 300 and place.left() > 680, "rather high than over a name"


def test_a_question_is_as_small_as_its_text_and_moves_nothing(window: MainWindow) -> None:
    go_to(window.lessons, 0)
    settle()
    pane = window.panes["world"]
    geometry, picture = pane.geometry(), pixels(window)
    question = window.slide.question
    assert question.isHidden()
    question.show_text("How wide is it?\n\n- A: 1\n- B: 2", 1080.0)
    settle()
    slide, place = window.slide.rect(), question.geometry()
    assert place.height() < slide.height() / 3 and place.width() < slide.width() / 2
    assert place.bottomLeft() == slide.bottomLeft()
    assert pane.geometry() == geometry and (pixels(window) == picture).all()
    drawing, there = pane.drawing, pane.canvas.mapTo(window.slide, QPoint())
    assert isinstance(drawing, WorldDrawing) and len(drawing.board.boxes) > 2
    tip = drawing.board.label("far")
    left, right, low, high = tip.box_px
    top = there.y() + pane.canvas.height() - high
    (boxes, hidden_ink), _ = window.slide.named()
    name = QRectF(there.x() + left, top, right - left, high - low)
    assert name in boxes
    (x, y, _), *_ = drawing.state.seen(drawing.state.objects.mean(axis=0)[None])
    spot = QPointF(there.x() + x, there.y() + pane.canvas.height() - y)
    x, y = spot.toTuple()
    hides, is_beside = hidden_ink(np.array([(x - 10, y - 10, x + 10, y + 10), (0, 0, 1, 1)]))
    assert hides > 100.0 and is_beside == 0.0


def test_a_long_question_is_reached_by_the_wheel(display: Any, talk: Path) -> None:
    slide = QWidget()
    slide.resize(1366, 640)
    question = QuestionOverlay(slide, list)
    slide.show()
    for times, fits in ((1, True), (40, False)):
        text = TALK.replace("How wide is it?", ("How wide is it? " * 12 + "\n") * times)
        question.show_text(asked_of(parse_lesson(text, talk).steps[1], told=True), 768.0)
        assert has_room(question) == fits
        assert letters_px(question, "91.5°") >= math.floor(LINES[-1] * 768)
        assert question.height() <= (640 / 3 if fits else 640 / 2) + 1


@pytest.mark.undrawn
def test_what_a_class_does_not_read_is_in_the_notes(window: MainWindow) -> None:
    change(window, TALK.replace("reads **this**", "reads **this**" + " and more" * 60))
    go_to(window.lessons, 0)
    notes = speaker_of(window).notes.toPlainText()
    assert notes.startswith("The class reads this and more") and "Only the speaker" in notes


# --------------------------------------------------------------------------- drawn ahead

SCENES = lesson_of(
    "scene=letter-f",
    "scene=similar-triangles\nview.fixed=side",
    "scene=affine-depth\nview.stage=view",
    "scene=letter-f\nlens.fov_y_deg=60\nview.large=image",
)


def test_what_is_drawn_ahead_is_what_a_fresh_window_shows(
    window: MainWindow, make_window: MakeWindow, tmp_path: Path, qtbot: Any
) -> None:
    path = tmp_path / "scenes.md"
    path.write_text(SCENES, encoding="utf-8")
    assert window.lessons.open(path)
    seen = {}
    slides = ["world", "world", "ndc", "image"]  # one pane of each step
    scenes = ["letter-f", "similar-triangles", "affine-depth", "letter-f"]
    for place in (1, 2, 3, 2, 1):
        pane = window.panes[slides[place]]
        ahead: list[Any] = []

        def is_drawn(pane: Any = pane, scene: str = scenes[place], ahead: Any = ahead) -> bool:
            ahead[:] = [e.drawing for e in pane.resting.all if e.args[0].name == scene]
            return bool(ahead)

        qtbot.waitUntil(is_drawn)
        assert window.lessons.go(place), window.messages.text
        assert pane.isVisible() and pane.drawing in ahead
        now = {slides[place]: pixels(window, slides[place])}
        if place in seen:  # come back to
            assert all(np.array_equal(now[name], seen[place][name]) for name in now)
        seen[place] = now
    window.lessons.close()
    fresh = make_window()
    fresh.settings.speaker_window = False
    assert fresh.lessons.open(path)
    present(fresh)
    for place in (1, 2, 3):
        assert fresh.lessons.open(path, f"s{place + 1}")
        fresh.look.rebuild()  # whatever was drawn ahead here
        name = slides[place]
        qtbot.waitUntil(lambda n=name, p=place: np.array_equal(pixels(fresh, n), seen[p][n]))


def test_the_equation_of_the_next_step_and_its_names_are_set_ahead(
    window: MainWindow, tmp_path: Path, qtbot: Any
) -> None:
    path = tmp_path / "equation.md"
    equation = (
        "scene=letter-f\nlens.kind=oblique\nview.slide=equation\nview.equation=clip_from_view"
    )
    steps = "scene=letter-f", equation, "scene=letter-f\nview.names=l"
    path.write_text(lesson_of(*steps), encoding="utf-8")
    SET.clear()
    for setter in (line_of, outline, piece_of):
        setter.cache_clear()
    assert window.lessons.open(path)
    qtbot.waitUntil(lambda: "M =" in SET)  # what stands before it comes last
    made = set(SET)
    assert window.lessons.go(1)
    assert window.slide.equation.isVisible() and "cot" in window.slide.equation.accessibleName()
    assert SET.keys() == made and "l" not in made
    qtbot.waitUntil(lambda: "l" in SET)


def test_a_pane_that_the_same_scene_has_not_shown_is_drawn_ahead(
    window: MainWindow, tmp_path: Path, qtbot: Any
) -> None:
    path = tmp_path / "panes.md"
    path.write_text(lesson_of("scene=letter-f", "scene=letter-f\nview.slide=ndc"), "utf-8")
    assert window.lessons.open(path)
    pane = window.panes["ndc"]
    before = [each.drawing for each in pane.resting.all]
    qtbot.waitUntil(lambda: len(pane.resting.all) > len(before))
    (ahead,) = (each.drawing for each in pane.resting.all if each.drawing not in before)
    assert window.lessons.go(1)
    assert pane.drawing is ahead


def test_the_windows_of_a_comparison_are_made_ahead(
    window: MainWindow, tmp_path: Path, qtbot: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    close_kept()
    path = tmp_path / "compared.md"
    beside = "view.compare=wide: lens.fov_y_deg=90|high: image.height=900"
    path.write_text(lesson_of("scene=letter-f", f"scene=letter-f\n{beside}"), encoding="utf-8")
    assert window.lessons.open(path), window.messages.text
    qtbot.waitUntil(lambda: len(kept) == 2)
    monkeypatch.setattr(OffScreen, "__init__", None)  # makes a window
    assert window.lessons.go(1)
    settle()
    assert all(other.pane.drawing for other in window.comparing.pictures.others)
    assert not kept


def test_the_band_of_the_next_step_is_laid_out_ahead(
    window: MainWindow, tmp_path: Path, qtbot: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    laid: list[str] = []

    def noted(document: QTextDocument, text: str, **how: Any) -> None:
        laid.append(text)
        set_text(document, text, **how)

    monkeypatch.setattr("widgets.window.talk_band.set_text", noted)
    path = tmp_path / "band.md"
    path.write_text(lesson_of("scene=letter-f", "scene=letter-f"), encoding="utf-8")
    assert window.lessons.open(path)
    band = window.band
    qtbot.waitUntil(lambda: "Step 2" in laid)
    laid.clear()
    assert window.lessons.go(1)
    assert not laid and "Step 2" in band.accessibleName()
    assert window.lessons.go(0)  # at once: nothing is ready
    assert "Step 1" in laid and "Step 1" in band.accessibleName()
    qtbot.waitUntil(lambda: "Step 2" in laid)
    band.resize(band.width() // 2, band.height())  # what was ready has another width
    laid.clear()
    assert window.lessons.go(1)
    assert "Step 2" in laid


def open_without_notes(window: MainWindow, folder: Path, steps: str, instead: str = "") -> None:
    """Open a lesson: a talk whose notes are left out, or replaced."""
    window.present.end()
    SET.clear()  # a full one takes no more
    path = folder / "lesson.md"
    path.write_text(steps.replace("```note\nminutes: 1\n```\n", instead), encoding="utf-8")
    assert window.lessons.open(path) and not window.lessons.lesson.is_talk


@pytest.mark.undrawn
def test_the_formulas_of_a_lessons_next_step_are_set_while_it_is_read(
    window: MainWindow, tmp_path: Path, qtbot: Any
) -> None:
    steps = lesson_of("scene=letter-f", "scene=posts").replace("# Step 2", "# Step $q_{27}$")
    open_without_notes(window, tmp_path, steps)
    qtbot.waitUntil(lambda: any("q_{27}" in formula for formula in SET))
    assert window.lessons.place == 0
    resting = [each for pane in window.panes.values() for each in pane.resting.all]
    assert "posts" not in [each.args[0].name for each in resting]


@pytest.mark.undrawn
def test_the_numbers_of_a_lessons_next_exercise_are_drawn_and_set_while_it_is_read(
    window: MainWindow, tmp_path: Path, qtbot: Any
) -> None:
    exercise = "```exercise e\nvary n: 31..39\nHow much is $Q = {=n}$?\nvalue: n\n```\n"
    open_without_notes(window, tmp_path, lesson_of("scene=letter-f", ""), exercise)
    drawn = window.lessons.course.variants
    qtbot.waitUntil(lambda: any("Q = 3" in formula for formula in SET) and bool(drawn))
    made, texts = set(SET), dict(drawn)
    assert window.lessons.go(1)
    (block,) = window.lessons.player.blocks
    assert SET.keys() == made and block.variant is texts[1, "e", 1]


@pytest.mark.undrawn
def test_f5_presents_where_one_is_and_with_shift_from_the_beginning(window: MainWindow) -> None:
    press(window, Qt.Key.Key_Escape)
    go_to(window.lessons, 1)
    press(window, Qt.Key.Key_F5)
    assert window.present.is_on and window.lessons.place == 1
    for _ in range(2):  # also while one presents
        QTest.keyClick(window, Qt.Key.Key_F5, Qt.KeyboardModifier.ShiftModifier)
        settle()
        assert window.present.is_on and window.lessons.place == 0
        go_to(window.lessons, 1)
        press(window, Qt.Key.Key_Escape)


@pytest.mark.undrawn
def test_a_talk_that_is_done_is_presented_from_its_first_step(window: MainWindow) -> None:
    card = window.lesson_card
    go_to(window.lessons, 2)
    QTest.keyClick(window, Qt.Key.Key_Right, Qt.KeyboardModifier.AltModifier)
    settle()
    assert window.talks.is_on and window.lessons.place == 2  # the class sees no end page
    for held in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier):
        press(window, Qt.Key.Key_Escape)
        card.go_on()
        settle()
        assert window.lessons.player is None and not card.isHidden()
        (said,) = (text.toPlainText() for text in card.page.findChildren(LessonText))
        assert said == "Done: “A talk”."
        QTest.keyClick(window, Qt.Key.Key_F5, held)
        settle()
        assert window.talks.is_on and window.lessons.place == 0
        assert window.band.isVisible() and card.isHidden()
        go_to(window.lessons, 1)
        press(window, PAGE_UP)
        assert window.lessons.place == 0
        go_to(window.lessons, 2)
    press(window, Qt.Key.Key_Escape)
    card.go_on()
    card.leave()
    QTest.keyClick(window, Qt.Key.Key_F5, held)
    settle()
    assert window.present.is_on and window.lessons.player is None  # a closed talk stays closed


@pytest.mark.undrawn
def test_a_talk_that_was_closed_at_its_end_opens_at_the_beginning(
    window: MainWindow, talk: Path
) -> None:
    for left, opens in ((1, 1), (2, 0)):
        go_to(window.lessons, left)
        window.lesson_card.leave()
        assert window.lesson_card.open(talk)
        assert window.lessons.place == opens


@pytest.mark.parametrize("place", [2, 7])
def test_a_control_that_goes_with_its_step_leaves_no_frame_on_the_slide(
    make_window: MakeWindow, place: int
) -> None:
    window = make_window(Document("cube"))
    window.lesson_card.open(CONTENT / "talk-000.md")
    present(window)
    activate(window)
    go_to(window.lessons, place)
    window.control_strip.findChild(QLineEdit).setFocus()
    while window.lessons.place == place:
        QTest.keyClick(QApplication.focusWidget(), PAGE_DOWN)
    arrive(window.lessons)
    settle()
    assert QApplication.focusWidget() is window
