"""A state in words gives itself back; a step put into a file leaves all else as it was."""

import json
import os
import random
import re
from dataclasses import replace
from pathlib import Path

import pytest

from app.document.codec import parse, to_json
from app.document.document import Document
from app.document.files import read
from app.document.settings import set_values
from app.document.view import AS_EVER
from app.lessons.contents import CONTENT, contained
from app.lessons.course import Course, scene_of
from app.lessons.lesson import parse_lesson
from app.lessons.lesson import read as read_lesson
from app.lessons.writing import add_step, assignments, begin_talk
from app.model.projection import Camera
from app.model.refusal import REFUSALS, Refusal
from app.picking.picking import Probe
from app.scenes.scene import BUILT_IN
from tests.fuzz.catalogue import a_tree, a_view, edited


def given_back(document: Document, letters: str | None = None) -> Document:
    """What the assignments of a document make of its scene as it opens."""
    first, *values = assignments(document, letters)  # type: ignore[arg-type]
    assert first == f"scene={document.scene}"
    view = replace(AS_EVER, letters=letters or AS_EVER.letters)
    return set_values(Document(document.scene, scene_of(document).start, view=view), values)


def in_words(document: Document) -> Document:
    """Of a state what has words: neither fixed views, nor how far an unseen frame is built."""
    view = replace(document.view, panes={}, pinned=frozenset())
    if view.panel != "frame":
        view = replace(view, frame_step=AS_EVER.frame_step)
    return replace(document, view=view)


def test_a_state_changed_by_hand_gives_itself_back_to_the_last_bit() -> None:
    rng = random.Random(1)
    silent = 0
    for number in range(2 * len(BUILT_IN)):
        scene = BUILT_IN[number % len(BUILT_IN)]
        document = Document(scene, scene_of(Document(scene)).start, view=a_view(rng))
        for _ in range(rng.randrange(6)):
            document = edited(rng, document)
        try:
            made = given_back(document)
        except Refusal as error:
            assert error.bound == REFUSALS["not-in-words"]
            silent += 1
            continue
        assert to_json(made) == to_json(in_words(document))
    assert silent <= 3  # of settings that camera and lens have left behind


def test_a_document_at_the_ends_of_float64_gives_itself_back() -> None:
    taken = 0
    for seed in range(100):
        try:
            document = parse(json.dumps(a_tree(random.Random(seed))))
        except Refusal:
            continue
        assert to_json(given_back(document)) == to_json(document)
        taken += 1
    assert taken > 25


def test_the_states_of_the_ideas_are_as_short_as_they_can_be() -> None:
    course = Course(read_lesson(CONTENT / "ideas.md"))
    for place, step in enumerate(course.lesson.steps):
        document = course.shown(place).document
        found = assignments(document)
        assert to_json(given_back(document)) == to_json(in_words(document))
        for left_out in range(1, len(found)):
            values = found[1:left_out] + found[left_out + 1 :]
            start = Document(document.scene, scene_of(document).start)
            try:
                shorter = set_values(start, values)
            except Refusal:
                continue
            assert to_json(shorter) != to_json(document), (step.name, found[left_out])


def test_only_what_is_not_as_ever_is_said() -> None:
    start = Document("letter-f", scene_of(Document()).start)
    assert assignments(start) == ["scene=letter-f"]
    lens = replace(start.projection.lens, fov_y_deg=60.0)  # type: ignore[call-arg]
    changed = replace(
        start,
        projection=replace(start.projection, lens=lens),
        view=replace(AS_EVER, stage=2.0, large="ndc", letters="001"),
    )
    values = ["scene=letter-f", "lens.fov_y_deg=60", "view.stage=pyramid", "view.large=ndc"]
    assert sorted(assignments(changed, "001")) == sorted(values)
    assert sorted(assignments(changed)) == sorted([*values, "view.letters=001"])


TALK = """---
title: A talk
letters: 001
---
# One {#one}

Words  with two spaces.\t

```state
scene=posts
```

---

# Two {#two}
```state
lens.near=2
```
```note
minutes: 1
---
Not a step's end.
```
---
# Three {#three}
```state
scene=letter-f
```"""


@pytest.fixture
def talk(tmp_path: Path) -> Path:
    path = tmp_path / "talk.md"
    path.write_bytes(TALK.encode())
    return path


def states(path: Path) -> dict[str, str]:
    course = Course(read_lesson(path))
    return {
        step.name: to_json(course.shown(place).document)
        for place, step in enumerate(course.lesson.steps)
    }


def a_state() -> Document:
    document = Document("cube", scene_of(Document("cube")).start)
    lens = replace(document.projection.lens, near=1.25)
    return replace(document, projection=replace(document.projection, lens=lens))


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_a_step_more_leaves_every_other_byte_as_it_was(talk: Path, newline: str, mark: str) -> None:
    before = (mark + TALK.replace("\n", newline)).encode()
    talk.write_bytes(before)
    shown = states(talk)
    added = add_step(talk, "two", "New: a $x$", a_state())
    after = talk.read_bytes()
    assert added == ("new-a-x", 2)
    assert {*re.findall("\r\n|\r|\n", after.decode())} == {newline}
    begin = next(i for i in range(len(before)) if before[i] != after[i])
    rest = len(after) - len(before)
    cuts = [i for i in range(begin + 1) if after[:i] + after[i + rest :] == before]
    assert cuts, "something else was changed"
    new = states(talk)
    assert [*new] == ["one", "two", "new-a-x", "three"]
    document = Course(read_lesson(talk)).shown(2).document
    assert document == a_state()
    assert {name: text for name, text in new.items() if name != "new-a-x"} == shown


def test_a_step_comes_after_those_that_it_would_change_and_gets_a_free_name(talk: Path) -> None:
    shown = states(talk)
    assert add_step(talk, "one", "New", a_state()).place == 2  # the second goes on from the first
    assert {name: text for name, text in states(talk).items() if name != "new"} == shown
    talk.write_text(TALK, encoding="utf-8")
    assert add_step(talk, "three", "Two", a_state()) == ("two-2", 3)
    assert talk.read_text(encoding="utf-8").startswith(
        TALK + "\n\n---\n# Two {#two-2}\n```state\nscene=cube\n"
    )
    assert add_step(talk, "gone meanwhile", "Two", a_state()) == ("two-3", 4)


def test_what_cannot_be_said_is_a_document_beside_the_file(talk: Path) -> None:
    camera = Camera((1.0, 2.0, 3.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    view = replace(AS_EVER, probes=(Probe(1, pixel=(3.0, 4.0)),), panes={"world": camera})
    document = replace(a_state(), view=view)
    add_step(talk, "three", "Seen", document)
    assert "```state\ndocument: talk-seen.json\n```" in talk.read_text(encoding="utf-8")
    assert read(talk.with_name("talk-seen.json")).view == view
    assert Course(read_lesson(talk)).shown(3).document.view.probes == view.probes
    plain = replace(a_state(), view=replace(AS_EVER, panes={"world": camera}))
    add_step(talk, "seen", "Plain", plain)
    assert not talk.with_name("talk-plain.json").exists()
    add_step(talk, "seen", "Seen", plain, panes=True)
    assert read(talk.with_name("talk-seen-2.json")).view.panes == {"world": camera}


def test_a_mesh_must_stand_beside_the_file(talk: Path, tmp_path: Path) -> None:
    mesh = tmp_path / "meshes" / "house.obj"
    mesh.parent.mkdir()
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
    document = Document(os.fspath(mesh), scene_of(Document(os.fspath(mesh))).start)
    add_step(talk, "three", "House", document)
    assert "scene=meshes/house.obj\n" in talk.read_text(encoding="utf-8")
    assert Course(read_lesson(talk)).shown(3).document == document
    other = tmp_path / "elsewhere"
    other.mkdir()
    path = other / "talk.md"
    path.write_text(TALK, encoding="utf-8")
    with pytest.raises(Refusal, match=r"house.obj.*must be a file beside the lesson"):
        add_step(path, "three", "House", document)
    assert path.read_text(encoding="utf-8") == TALK


def test_nothing_is_written_where_it_cannot_be(talk: Path) -> None:
    for title in ("", "  ", "a\x1bb"):
        with pytest.raises(Refusal, match=r"title = .*must be one line of text"):
            add_step(talk, "two", title, a_state())
    talk.chmod(0o400)
    if os.getuid():
        with pytest.raises(Refusal, match="write-protected"):
            add_step(talk, "two", "New", a_state())
    assert talk.read_bytes() == TALK.encode()
    talk.chmod(0o600)
    talk.write_text("---\ntitle: x\n---\nno heading", encoding="utf-8")
    with pytest.raises(Refusal, match="line 4"):
        add_step(talk, "two", "New", a_state())
    talk.unlink()
    with pytest.raises(Refusal, match=r"talk.md does not exist"):
        add_step(talk, "two", "New", a_state())


def test_what_comes_with_the_program_stays_as_it_is() -> None:
    path = (contained() or (CONTENT / "ideas.md",))[0]
    before = path.read_bytes()
    for act in (
        lambda: add_step(path, "one", "New", a_state()),
        lambda: begin_talk(CONTENT / "new.md", "New", a_state()),
    ):
        with pytest.raises(Refusal, match=r"comes with the program .* copy it, and open the copy"):
            act()
    assert path.read_bytes() == before
    assert not (CONTENT / "new.md").exists()


def test_a_new_talk_shows_what_the_window_shows(tmp_path: Path) -> None:
    path = tmp_path / "mine.md"
    document = replace(a_state(), view=replace(AS_EVER, letters="002", large="image"))
    begin_talk(path, "Boxes & cubes", document)
    lesson = parse_lesson(path.read_text(encoding="utf-8"), path)
    assert lesson.is_talk and lesson.title == "Boxes & cubes"
    shown = Course(lesson).shown(0)
    assert shown.document == document
    assert shown.view == {"large": "image", "letters": "002"}
    add_step(path, "boxes-cubes", "Two", document)
    assert len(read_lesson(path).steps) == 2
