"""What the world pane cuts when the window comes to rest is what the checks of pictures say."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QRect

from app.drawings.composition import measured
from app.lessons.contents import CONTENT
from app.lessons.course import scene_of
from tests.support.window import arrive, give_room, present, settle, show_scene
from widgets.window.main_window import MainWindow

TALK = """---
title: A talk
letters: own
---
# One {#one}
```state
scene=letter-f
view.slide=world
view.names=eye,near,far
lens.near=6
```
---
# Two {#two}
```state
camera.eye=-6,4.5,8
lens.fov_y_deg=50
```
```predict wide
How wide?
- [x] wide
- [ ] narrow
show: lens.fov_y_deg=75; lens.far=25; view.fixed=top
why: It is.
```
---
# Close {#close}
```state
view.panes=world: 4,5,9,0,2,0
```
---
# Whole again {#whole}
```state
view.panes=
lens.fov_y_deg=35
```
"""
SHAPES = QRect(0, 0, 1366, 768), QRect(0, 0, 820, 900)


@pytest.fixture
def window(window: MainWindow) -> MainWindow:
    window.settings.speaker_window = False
    window.settings.reduce_motion = False
    return window


def cut_at_rest(window: MainWindow) -> set[str]:
    """What the pane cuts now, which is what the check says of such a pane."""
    if window.lessons.is_moving:
        arrive(window.lessons)
    settle()
    drawing = window.panes["world"].drawing
    assert drawing is not None and window.panes["world"].isVisible()
    document = replace(window.store.document, view=window.store.look())
    size = drawing.state.size_px
    picture, *_ = measured(document, scene_of(document), "world", size, drawing.state.em)
    said = {name: part * size[1] for name, part in picture.outside}
    assert drawing.cut() == pytest.approx(said, abs=0.5)
    return set(said)


def steps(window: MainWindow) -> Iterator[str]:
    assert window.lessons.lesson is not None
    for place, step in enumerate(window.lessons.lesson.steps):
        assert window.lessons.go(place)
        yield step.name


@pytest.mark.parametrize("room", SHAPES, ids=["wide", "upright"])
def test_a_planted_close_up_is_said_and_nothing_else_is_cut(
    window: MainWindow, talk: Path, room: QRect
) -> None:
    give_room(window, room)
    assert window.lessons.open(talk)
    cut = {name: cut_at_rest(window) for name in steps(window)}
    assert cut.pop("close") >= {"near", "far", "eye"}
    assert not any(cut.values()), cut


def test_a_scene_that_enlarges_the_pane_is_seen_from_the_shot_for_it(window: MainWindow) -> None:
    """The pane is small and wide before, and large and upright after."""
    give_room(window, SHAPES[0])
    show_scene(show_scene(window, "cracks"), "unprojection")
    drawing = window.panes["world"].drawing
    assert drawing is not None
    width, height = drawing.state.size_px
    assert width < height
    at_rest = drawing.own.pose
    window.panes["world"].reset_view()
    assert drawing.own.pose.is_near(at_rest)


@pytest.mark.parametrize("room", SHAPES, ids=["wide", "upright"])
def test_a_reveal_frames_the_picture_anew(window: MainWindow, talk: Path, room: QRect) -> None:
    assert window.lessons.open(talk, "two")
    present(window)
    give_room(window, room)
    assert not cut_at_rest(window)
    while window.talks.reveal():
        assert not cut_at_rest(window)
    assert window.store.document.projection.lens.planes == (6.0, 25.0)
    window.talks.previous()
    assert not cut_at_rest(window)


@pytest.mark.parametrize(
    ("name", "room"),
    [
        ("l03-field-of-view", SHAPES[0]),
        ("l16-eye-plane", SHAPES[1]),
        ("l22-walk-round-the-f", SHAPES[0]),
    ],
)
def test_what_a_lesson_shows_is_whole(window: MainWindow, name: str, room: QRect) -> None:
    """Each step, and what "Show it" shows there."""
    give_room(window, room)
    assert window.lessons.open(CONTENT / f"{name}.md") and window.lessons.lesson is not None
    for place, step in enumerate(window.lessons.lesson.steps[:5]):
        assert window.lessons.go(place)
        for part in step.parts:
            if window.panes["world"].isVisible():
                assert not cut_at_rest(window), step.name
            if part.show is not None:
                window.lessons.show_predicted(part.show)


def test_a_step_that_shows_the_same_is_framed_anew(window: MainWindow, talk: Path) -> None:
    """Also after a hand has made the frustum larger, and smaller again."""
    assert window.lessons.open(talk)
    settle()
    own = window.panes["world"].drawing
    assert own is not None and own.own is not None
    begun, projection = own.own.pose, window.store.document.projection
    for lens in (replace(projection.lens, fov_y_deg=fov) for fov in (80.0, 41.5)):
        window.store.set_projection(replace(projection, lens=lens))
        window.look.rest()
    assert not own.own.pose.is_near(begun), "a hand's own framing stays while nothing is cut"
    assert window.lessons.come_back()
    assert not cut_at_rest(window) and own.own.pose.is_near(begun)
