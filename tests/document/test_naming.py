"""What a picture names, and what a scene can name."""

from typing import Any

import pytest

from app.document.document import Document
from app.document.naming import inks, nameable, named_in
from app.document.settings import set_values
from app.document.view import EVERYTHING, MOST_NAMES, PANES
from app.scenes.scene import BUILT_IN, Scene, load

STATES = ("view.fixed=", "view.fixed=side", "view.fixed=top")


def opened(name: str, *values: str) -> tuple[Document, Scene]:
    scene = load(name)
    return set_values(Document(name, scene.start), values), scene


@pytest.mark.parametrize("name", BUILT_IN)
def test_a_pane_names_at_most_seven_things_of_its_own(name: str) -> None:
    for state in STATES:
        document, scene = opened(name, state)
        for pane in PANES:
            names = named_in(pane, scene)
            assert names is not None
            assert len(names & nameable(pane, document, scene)) <= MOST_NAMES, (state, pane)


@pytest.mark.parametrize("name", sorted(set(BUILT_IN) - {"far-plane-popping"}))
def test_a_scene_can_show_something_that_it_names(name: str) -> None:
    document, scene = opened(name)
    shown = [nameable(pane, document, scene) & set(scene.names) for pane in PANES]
    assert any(shown)


def test_a_views_own_names_replace_those_of_the_scene() -> None:
    scene = load("letter-f")
    assert named_in("world", scene, ("u",)) == {"u"}
    assert named_in("world", scene, ()) == frozenset()
    assert named_in("world", scene, EVERYTHING) is None


def test_the_cube_beside_a_scene_names_its_ends() -> None:
    names: Any = named_in("ndc", load("similar-triangles"))
    assert {"near", "far"} <= names
    names = named_in("ndc", load("clipping"))  # the cube itself is the picture, of one plane
    assert not {"near", "far"} & names


def test_letters_of_formulas_have_the_colours_of_what_is_named() -> None:
    values = "view.fixed=side", "view.names=y_p,d,-z,near,P'", "view.letters=002"
    document, scene = opened("similar-triangles", *values)
    assert scene.phenomenon is not None
    shown = scene.phenomenon.illustration(
        document.projection, scene.phenomenon.checked({}), scene.subject
    )
    expected = {"y_p": "accent", "d": "near", "z_n": "near", "P'": "accent"}
    assert inks(document, scene, shown) == expected
    document, scene = opened("letter-f", "view.names=eye,n,u,far", "view.letters=001")
    arrow = "\u20d7"
    assert inks(document, scene, None) == {f"w{arrow}": "n", f"u{arrow}": "u", "f": "far"}
