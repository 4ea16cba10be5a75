"""The store: one signal per change, silence for none, a drag is one undo step."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.document.document import Document
from app.document.store import OPENED_LIMIT, UNDO_LIMIT, Store
from app.document.view import View
from app.model.projection import Perspective, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA


def seen(fov_y_deg: float) -> Projection:
    return Projection(lens=Perspective(fov_y_deg, 1.0, 30.0))


@pytest.fixture
def store() -> Store:
    return Store(Document("letter-f", seen(45.0)))


def fovs(store: Store) -> list[float]:
    """Every fov that `changed` announces from now on."""
    heard: list[float] = []
    store.changed.connect(lambda document: heard.append(document.projection.lens.fov_y_deg))
    return heard


def test_an_edit_is_announced_once_and_an_equal_one_never(store: Store) -> None:
    heard = fovs(store)
    store.set_projection(seen(50.0))
    store.set_projection(seen(50.0))
    assert heard == [50.0]


def test_undo_and_redo_walk_the_history(store: Store) -> None:
    for fov in (50.0, 60.0, 70.0):
        store.set_projection(seen(fov))
    heard = fovs(store)
    store.undo()
    store.undo()
    store.redo()
    assert heard == [60.0, 50.0, 60.0]
    assert store.can_undo and store.can_redo


def test_a_new_edit_forgets_what_was_undone(store: Store) -> None:
    store.set_projection(seen(50.0))
    store.undo()
    store.set_projection(seen(60.0))
    assert not store.can_redo
    store.undo()
    assert store.document.projection == seen(45.0)
    assert not store.can_undo


def test_a_drag_is_one_step(store: Store) -> None:
    store.begin_gesture()
    for fov in range(46, 90):
        store.set_projection(seen(float(fov)))
    store.end_gesture()
    store.undo()
    assert store.document.projection == seen(45.0)
    assert not store.can_undo
    store.redo()
    assert store.document.projection == seen(89.0)


def test_a_drag_back_to_its_start_is_no_step(store: Store) -> None:
    store.begin_gesture()
    store.set_projection(seen(50.0))
    store.set_projection(seen(45.0))
    store.end_gesture()
    assert not store.can_undo


def undone(store: Store) -> list[Any]:
    """The fields of view, or scenes, that undo goes back through."""
    found: list[Any] = []
    while store.can_undo:
        scene = store.document.scene
        store.undo()
        lens = store.document.projection.lens
        assert isinstance(lens, Perspective)
        found.append(store.document.scene if store.document.scene != scene else lens.fov_y_deg)
    return found


def test_a_drag_while_the_animation_plays_is_a_step_of_its_own(store: Store) -> None:
    store.begin_gesture()
    store.set_projection(seen(50.0))
    store.begin_gesture()
    store.set_projection(seen(55.0))
    store.set_projection(seen(60.0))
    store.end_gesture()
    assert store.in_gesture
    store.set_projection(seen(70.0))  # it plays on: of this no step is made
    store.end_gesture()
    assert not store.in_gesture
    assert undone(store) == [50.0, 45.0]


def test_another_scene_while_the_animation_plays_is_a_step_of_its_own(store: Store) -> None:
    store.begin_gesture()
    store.set_projection(seen(50.0))
    store.set_document(replace(store.document, scene="cube"))
    store.set_projection(seen(60.0))
    store.end_gesture()
    store.set_projection(seen(70.0))
    assert undone(store) == [60.0, "letter-f", 45.0]


def test_what_plays_on_in_a_file_that_was_opened_meanwhile_is_a_step(store: Store) -> None:
    store.begin_gesture()
    store.open(Document("cube", seen(60.0)))
    store.set_projection(seen(70.0))
    store.end_gesture()
    assert undone(store) == [60.0, "letter-f"]


def test_a_click_while_the_animation_plays_loses_no_step(store: Store) -> None:
    store.begin_gesture()
    store.set_projection(seen(50.0))
    store.begin_gesture()
    store.end_gesture()
    store.set_projection(seen(60.0))
    store.end_gesture()
    assert undone(store) == [45.0]


def test_undo_in_the_middle_of_a_gesture_goes_to_its_start(store: Store) -> None:
    store.begin_gesture()
    store.set_projection(seen(50.0))
    assert store.can_undo
    store.undo()
    assert store.document.projection == seen(45.0)
    store.set_projection(seen(60.0))
    store.end_gesture()
    store.undo()
    assert store.document.projection == seen(45.0)


def test_an_end_without_a_beginning_is_harmless(store: Store) -> None:
    store.end_gesture()
    store.set_projection(seen(50.0))
    store.undo()
    assert store.document.projection == seen(45.0)


def test_the_unsaved_mark_follows_the_value_not_the_number_of_edits(store: Store) -> None:
    assert not store.modified
    store.set_projection(seen(50.0))
    assert store.modified
    store.undo()
    assert not store.modified
    store.redo()
    store.mark_saved()
    assert not store.modified
    store.undo()
    assert store.modified


def test_opening_is_one_step_that_brings_unsaved_work_and_its_file_back(store: Store) -> None:
    store.set_projection(seen(50.0))
    store.origin.path = Path("a.json")
    heard = fovs(store)
    store.open(Document("cube", seen(60.0)), path=Path("b.json"))
    assert heard == [60.0] and not store.modified and store.origin.path == Path("b.json")
    store.undo()
    assert store.document == Document("letter-f", seen(50.0))
    assert store.modified and store.origin.path == Path("a.json")
    store.mark_saved()
    store.redo()
    assert not store.modified and store.origin.path == Path("b.json")
    store.undo()
    assert not store.modified, "each file has what was saved in it"
    store.undo()
    assert store.modified and store.document == Document("letter-f", seen(45.0))


def test_undo_reaches_back_over_a_few_openings(store: Store) -> None:
    for number in range(OPENED_LIMIT + 2):
        store.set_projection(seen(50.0 + number))
        store.open(Document(f"mesh-{number}.stl", seen(45.0)))
    assert len({document.scene for document in store.documents}) == OPENED_LIMIT + 1
    while store.can_undo:
        store.undo()
    assert store.document == Document("mesh-1.stl", seen(45.0))


def test_leaving_is_announced_before_another_document_comes(store: Store) -> None:
    """At that time the old document can still be copied."""
    left: list[Document] = []
    store.leaving.connect(lambda: left.append(store.document))
    first, second = store.document, Document("cube", seen(60.0))
    store.open(second)
    store.set_document(Document("posts", seen(60.0)))
    store.undo()
    assert left == [first]
    store.undo()
    assert left == [first, second]


# -- how it is looked at


def test_a_view_is_no_step_and_no_unsaved_work(store: Store) -> None:
    store.set_projection(seen(50.0))
    store.mark_saved()
    steps = list(store.documents)
    heard, told = fovs(store), []
    store.view_changed.connect(told.append)
    store.set_view(stage=2.0)
    store.set_view(stage=2.0)
    assert [document.view for document in told] == [View(stage=2.0)]
    assert heard == [] and list(store.documents) == steps and not store.modified
    with pytest.raises(Refusal):
        store.set_view(stage=7.0)
    assert store.document.view == View(stage=2.0)
    store.undo()
    assert store.document.view == View(stage=2.0), "an undo of the model moves no picture"


def test_undo_brings_back_a_documents_view(store: Store) -> None:
    """This is the view when the document was left, not the one with which it was opened."""
    look = View(stage=1.0)
    store.look = lambda: look
    store.set_projection(seen(50.0))
    store.open(Document("cube", seen(60.0), view=View(stage=3.0)))
    assert store.document.view == View(stage=3.0)
    look = View(stage=2.0)
    assert store.seen == store.document and store.seen.view == look
    store.set_projection(seen(70.0))
    store.undo()
    store.undo()
    assert store.document.scene == "letter-f" and store.document.view == View(stage=1.0)
    look = View(stage=0.5)
    store.undo()
    assert store.document.view == View(stage=1.0)
    store.redo()
    store.redo()
    assert store.document.scene == "cube" and store.document.view == View(stage=2.0)
    store.undo()
    assert store.document.view == View(stage=0.5)


def test_undo_of_a_gesture_keeps_a_view_that_was_changed_meanwhile(store: Store) -> None:
    store.begin_gesture()
    store.set_projection(seen(50.0))
    store.set_view(large="ndc")
    store.end_gesture()
    store.undo()
    assert store.document == Document("letter-f", seen(45.0))
    assert store.document.view == View(large="ndc")


def test_what_cannot_be_drawn_leaves_all_as_it_was(store: Store) -> None:
    """So do a file that is opened in the middle of a drag, and a mesh that has become bad."""
    store.set_projection(seen(50.0))
    store.begin_gesture()
    store.set_projection(seen(55.0))
    refusing = store.changed.connect(lambda document: document.scene == "cube" and store.refuse())
    origin = store.origin
    assert not store.open(Document("cube", seen(60.0)), path=Path("cube.json"))
    assert not store.set_document(Document("cube", seen(60.0)))
    assert store.origin is origin and store.document == Document("letter-f", seen(55.0))
    store.end_gesture()
    store.changed.disconnect(refusing)
    assert undone(store) == [50.0, 45.0]
    assert store.show_again()
    store.changed.connect(store.refuse)
    assert not store.show_again() and store.document == Document("letter-f", seen(45.0))


def test_another_window_goes_on_with_undo_and_redo(store: Store) -> None:
    for angle in (50.0, 55.0):
        store.set_projection(seen(angle))
    store.undo()
    other = Store(store.document)
    other.take_steps(store)
    assert other.modified and other.origin is store.origin
    other.redo()
    assert other.document.projection == seen(55.0)
    assert undone(other) == [50.0, 45.0]


def test_changes_of_the_command_line_can_be_undone() -> None:
    saved, shown = Document("cube", seen(45.0)), Document("cube", seen(60.0))
    store = Store(shown, saved=saved)
    assert store.modified and store.can_undo
    store.undo()
    assert store.document == saved and not store.modified
    store.redo()
    assert store.document == shown
    assert not Store(saved, saved=saved).can_undo
    other = Store(shown, saved=Document("posts", seen(45.0)))  # which may not be there
    assert other.modified and not other.can_undo


def test_a_recovered_document_is_unsaved(store: Store) -> None:
    store.open(Document("cube", seen(60.0)), saved=False)
    assert store.modified


def test_the_history_is_bounded(store: Store) -> None:
    for i in range(UNDO_LIMIT + 10):
        store.set_projection(seen(50.0 + i / 1000.0))
    steps = 0
    while store.can_undo:
        store.undo()
        steps += 1
    assert steps == UNDO_LIMIT


def test_a_change_of_settings_is_an_edit() -> None:
    store = Store(Document("similar-triangles", PHENOMENA["similar-triangles"].start))
    heard: list[object] = []
    store.changed.connect(lambda document: heard.append(document.settings["distance"]))
    store.set_settings({"distance": 5.0})
    store.set_settings({"distance": 5.0})
    with pytest.raises(Refusal):
        store.set_settings({"distance": 0.0})
    assert heard == [5.0] and store.modified
    store.undo()
    assert heard == [5.0, 4.0] and not store.modified
    store.redo()
    assert store.document.settings["distance"] == 5.0


def test_among_several_gestures_none_is_abandoned(store: Store) -> None:
    """A playing animation is a gesture, and abandoning a slider must not take it back."""
    store.begin_gesture()
    store.begin_gesture()
    store.set_projection(seen(50.0))
    store.abandon_gesture()
    assert store.document.projection == seen(50.0)
    store.end_gesture()
    store.abandon_gesture()
    assert store.document.projection == seen(50.0)
    store.end_gesture()
    assert undone(store) == [45.0]


def test_undo_passes_through_a_lesson_that_another_one_followed(store: Store) -> None:
    """The step of a lesson is left only by closing it; the one before it is closed by the next."""
    store.set_projection(seen(50.0))
    for angle in (20.0, 25.0):
        lesson = replace(store.document, projection=seen(angle))
        store.open(lesson, is_work=False)
        assert not store.can_undo and not store.modified
    store.origin.is_work = True
    assert undone(store) == [20.0, 50.0, 45.0]


def test_a_step_of_a_lesson_that_undo_does_not_leave_takes_no_work(store: Store) -> None:
    store.set_projection(seen(50.0))
    lesson = replace(store.document, projection=seen(20.0))
    store.open(lesson, is_work=False)
    store.set_document(replace(lesson, projection=seen(25.0)))
    store.forget_steps()
    assert not store.can_undo and not store.can_redo
    store.open(Document("cube", seen(60.0)))
    store.undo()
    assert store.document.projection == seen(25.0) and not store.modified, "nobody's work"
    store.undo()
    assert store.document.projection == seen(50.0) and store.modified
