"""Documents in words: each sentence is known by hand."""

from dataclasses import replace

import pytest

from app import api
from app.drawings import describing
from app.drawings.describing import describe
from app.model.refusal import HEALTH
from app.scenes.scene import load


def told(*values: str) -> api.Description:
    return api.describe(api.load("letter-f", *values))


def test_the_letter_f_in_words() -> None:
    found = told("view.probes=1,2,3,0,0,100", "lens.far=inf")
    assert found.title == "Letter F"
    assert found.general == (
        "The eye is at (5, 4.5, 8) and looks at (0, 2.2, 0).",
        "Lens: perspective, near 5, far ∞.",
        "The vertical field of view is 38°.",
        "Point 1 at (1, 2, 3) has its picture at the pixel (525.4, 502.4).",
        "Point 2 has no picture.",
    )
    assert found.panes == {
        "world": "World: the scene from a free viewpoint.",
        "ndc": "Cube: the scene in normalized device coordinates.",
        "image": "Image: the picture, 1280 by 720 pixels.",
    }
    assert found.cut == ("All of the scene's objects lie inside the view volume.",)
    assert found.risky == ()


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        (["lens.near=12.4999999"], "near 12.4999999, far 12.5."),
        (["lens.far=5.00001"], "near 5, far 5.00001."),
        (["lens.near=3.9999", "lens.far=18.00001"], "near 4, far 18."),
        (["lens.fov_y_deg=179.99999"], "field of view is 179.99999°."),
        (["lens.fov_y_deg=1e-9"], "field of view is 1e−09°."),
        (["camera.eye=1e9,0,5", "camera.target=1000000001,0,5"],
         "The eye is at (1000000000, 0, 5) and looks at (1000000001, 0, 5)."),
        (["view.probes=1,2,3,1,2,3.00001"], "Point 2 at (1, 2, 3.00001) has its picture at"),
    ],
)  # fmt: skip
def test_nearly_equal_numbers_have_the_digits_that_tell_them_apart(
    values: list[str], expected: str
) -> None:
    assert expected in " ".join(told(*values).general)


def test_what_is_cut_is_named() -> None:
    # The letter is 3 wide, 5 high and 1 deep; an eye 0.2 before its middle sees little of it.
    inside = told("camera.eye=0,2.2,0.2", "lens.near=0.1").cut
    assert inside == (
        "Parts of the scene's objects lie outside of these planes: near, left, right, bottom, top.",
        "Parts of the scene's objects lie behind the eye, where a point has no picture.",
    )
    # At 170 degrees the half before it is seen, and the half behind it is not left or right of all.
    wide = told("camera.eye=0,2.2,0.2", "lens.near=0.1", "lens.fov_y_deg=170").cut
    assert wide[0].endswith("planes: near.") and wide[1] == inside[1]
    # From 9 beside its middle it spans 8.5 to 9.5: far cuts it, and nothing else.
    level = "camera.eye=0,2.5,9", "camera.target=0,2.5,0"
    assert told(*level, "lens.far=9").cut == (
        "Parts of the scene's objects lie outside of these planes: far.",
    )
    away = told("camera.eye=0,2.5,9", "camera.target=0,2.5,20")
    assert away.cut == (
        "Parts of the scene's objects lie behind the eye, where a point has no picture.",
    )
    assert away.risky == (
        "None of the scene's objects is in the picture: all lie outside the near plane.",
    )


def test_risks_are_those_of_the_health_line() -> None:
    assert told("lens.near=1e-9").risky[0] == f"{HEALTH['no-gap']}."


def test_views_stages_and_comparisons_are_said() -> None:
    panes = told("view.fixed=top", "view.stage=1.5", "view.compare=lens.near=5").panes
    assert panes == {
        "world": "World: the scene from above the camera, in parallel projection.",
        "ndc": "Cube: the scene on its way from view to canonical perspective coordinates.",
        "image": "Image: the picture, 1280 by 720 pixels. 2 pictures are compared.",
    }
    parallel = told("lens.kind=orthographic", "view.stage=pyramid").panes["ndc"]
    assert parallel == "Cube: the scene in canonical parallel coordinates."
    typed = told("lens.kind=matrix", "view.stage=2.5").panes["ndc"]
    assert typed == "Cube: the scene on its way from view to normalized device coordinates."


def test_another_language_gets_every_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    texts = list[tuple[str, str]]()

    def marked(text: str, context: str) -> str:
        texts.append((text, context))
        return f"<{text}>"

    monkeypatch.setattr(describing, "translate", marked)
    away = api.load("letter-f", "camera.eye=0,2.5,9", "camera.target=0,2.5,20")
    (risk,) = describe(away, load("letter-f")).risky
    assert risk.endswith("the <near> plane>.")
    document = api.load("focus", "camera.eye=0,1.3,-4", "lens.near=1e-9")
    found = describe(document, load("focus"), ("world",))
    assert {context for _, context in texts} == {
        "Description", "Health", "Lens", "Plane", "phenomena"
    }  # fmt: skip
    assert list(found.panes) == ["world"]
    assert all(
        said.startswith("<")
        for said in (found.title, *found.general, *found.panes.values(), *found.cut, *found.risky)
    )


def test_a_title_is_text_that_a_file_can_hold() -> None:
    """A file's name need not be UTF-8, and XML has no control characters."""
    mesh = replace(load("cube"), name="folder/F\udcff\x01.obj")
    assert describe(api.load("cube"), mesh).title == r"F\udcff\x01.obj"
