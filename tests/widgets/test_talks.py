"""Talks: wandering and coming back, the keys of clickers, the band, the speaker's window."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.document.document import Document, to_json
from app.document.store import Store
from app.document.view import AS_EVER
from app.lessons.course import Course, scene_of
from app.lessons.lesson import MOST_STEPS, parse_lesson
from app.model.projection import Camera
from app.scenes.scene import BUILT_IN, Scene
from tests import PATIENCE_MS
from tests.support.edits import a_view, edited
from tests.support.window import activate, present, settle
from widgets.parts.message_bar import MessageBar
from widgets.window.lessons import TRANSITION_S, Lessons
from widgets.window.main_window import MainWindow
from widgets.window.speaker import TalkClock, planned
from widgets.window.talk_band import TalkBand

WALKED = """---
title: A walk
letters: 001
---
# One {#one}
```state
scene=letter-f
lens.fov_y_deg=60
view.large=world
```
```note
minutes: 1
```
---
# Two {#two}
```state
camera.eye=9,2,3
view.stage=pyramid
view.large=ndc
lens.near=2
```
---
# Three {#three}
---
# Four {#four}
```state
scene=affine-depth
view.fixed=side
```
---
# Five {#five}
```state
scene=view-volumes
settings.volume=box
view.probes=1,2,3
```
---
# Six {#six}
```state
scene=letter-f
lens.kind=frustum
lens.left=-1
lens.right=3
lens.bottom=-1
lens.top=1
object.rotate_deg=0,30,0
```
"""


class StubFiles:
    """What of `Files` a talk needs, without dialogs."""

    def __init__(self, store: Store) -> None:
        self._store = store

    def keep(self, _document: Document, _scene: Scene) -> None:
        """All scenes are kept by `scene_of`."""

    def open_step(self, document: Document, _scene: Scene, _lesson: Path) -> None:
        self._store.open(document, is_work=False)


def tick(lessons: Lessons, seconds: float) -> None:
    """Let time pass for the model that is on its way."""
    if lessons.is_moving:
        lessons._clock.ticked.emit(seconds)


def arrive(lessons: Lessons) -> None:
    tick(lessons, TRANSITION_S / 3.0)
    tick(lessons, 2.0 * TRANSITION_S)
    assert not lessons.is_moving


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


def test_a_thousand_walks_come_back_to_the_file_bit_for_bit(display: Any, tmp_path: Path) -> None:
    path = tmp_path / "walk.md"
    path.write_text(WALKED)
    expected = Course(parse_lesson(WALKED, path))  # another one: not what the window has
    store, messages = Store(Document("cube", scene_of(Document("cube")).start)), MessageBar()
    files: Any = StubFiles(store)
    lessons = Lessons(store, files, messages, lambda: None, lambda _stage: None)
    assert lessons.open(path)
    rng = random.Random(7)
    moved = 0
    for _ in range(1000):
        for _ in range(rng.randrange(1, 6)):
            wander(rng, store, lessons)
        place, before, was_moving = lessons.place, store.seen, lessons.is_moving
        shown = expected.shown(place)
        assert lessons.is_away == (
            store.document != shown.document
            or any(getattr(store.look(), name) != value for name, value in shown.view.items())
        )
        assert lessons.come_back()
        moved += lessons.is_moving
        arrive(lessons)
        now = store.seen
        assert to_json(replace(now, view=AS_EVER)) == to_json(replace(shown.document, view=AS_EVER))
        assert {name: getattr(now.view, name) for name in shown.view} == shown.view
        assert not lessons.is_away
        assert not store.modified  # nobody is asked to save it
        if (before.scene, before.mesh) == (now.scene, now.mesh):
            free = {*vars(now.view)} - {*shown.view}
            assert {"panes", "layers", "layout"} <= free
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
    assert moved > 100  # and not all of them at once
    assert not messages.text


def test_a_view_of_a_pane_is_there_again_at_the_next_step_of_its_scene(
    display: Any, tmp_path: Path
) -> None:
    path = tmp_path / "walk.md"
    path.write_text(WALKED)
    store = Store(Document("cube", scene_of(Document("cube")).start))
    files: Any = StubFiles(store)
    lessons = Lessons(store, files, MessageBar(), lambda: None, lambda _stage: None)
    lessons.open(path)
    turned = {"world": Camera((1.0, 2.0, 3.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))}
    store.set_view(panes=turned)
    seen = []
    for _ in range(5):
        lessons.next()
        seen.append((store.document.scene, store.look().panes == turned))
    assert seen == [
        ("letter-f", True),
        ("letter-f", True),
        ("affine-depth", False),
        ("view-volumes", False),
        ("letter-f", True),
    ]
