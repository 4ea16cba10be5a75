"""Pictures to compare with: kept, refused, and those that the lectures set side by side."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.document.codec import parse, to_json
from app.document.compare import ComparedPicture, DifferenceWriter, Held, differences, names_in
from app.document.document import Document
from app.document.settings import compared, name_of, picture_text, pictured, set_values
from app.document.view import View
from app.model.parameters import TITLES
from app.model.projection import FreeMatrix
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.words import figure
from app.scenes.scene import load

LIVE = ComparedPicture(live=True)


def of(scene: str) -> Document:
    return Document(scene, load(scene).start)


def ready_made(scene: str, name: str) -> list[Document]:
    """The pictures of a ready-made comparison, from left to right."""
    document = compared(of(scene), name)
    return [pictured(document, picture) for picture in document.view.compare]


def shown(document: Document) -> Illustration:
    scene = load(document.scene)
    assert scene.phenomenon is not None
    return scene.phenomenon.illustration(document.projection, document.settings, scene.subject)


# -- kept


@pytest.fixture
def held() -> Document:
    """A document compared with its former state."""
    before = of("interpolation")
    after = replace(before, projection=before.projection.with_depth("direct3d"))
    pictures = (
        ComparedPicture("before", held=before.state),
        LIVE,
        ComparedPicture(changes=("lens.far=30",)),
    )
    return replace(after, view=View(compare=pictures, dividers=(0.25, 0.5)))


def test_compared_pictures_are_saved_but_no_part_of_the_model(held: Document) -> None:
    again = parse(to_json(held))
    assert again.view == held.view
    assert again == replace(held, view=View())
    first, own, follows = (pictured(again, picture) for picture in again.view.compare)
    assert first.projection.depth == "opengl" and own == again
    assert (follows.projection.lens.far, follows.projection.depth) == (30.0, "direct3d")


def test_a_following_picture_has_its_own_values_and_the_documents_others(held: Document) -> None:
    moved = set_values(held, ["camera.eye=1,2,9", "lens.near=2"])
    before, _, follows = (pictured(moved, picture) for picture in moved.view.compare)
    assert before.projection == of("interpolation").projection
    assert follows.projection.camera == moved.projection.camera
    assert (follows.projection.lens.near, follows.projection.lens.far) == (2.0, 30.0)


@pytest.mark.parametrize(
    ("good", "bad", "sentence"),
    [
        ('"near": 3, "far": 24}, "depth": "opengl"', '"near": -3, "far": 24}, "depth": "opengl"',
         "view.compare[0].held.lens.near = -3: must be greater than 0."),
        ('"held": {', '"held": {"scene": "cube", ',
         "view.compare[0].held.scene = 'cube': must be the document's own, 'interpolation'."),
        ('"live": true', '"live": 1', "view.compare[1].live = 1: must be true or false."),
        ('{"live": true}', '7',
         "view.compare[1] = 7: must be an object with named values in braces."),
        (', {"live": true}', "",
         "view.compare = ['before', '']: must be a list of 2 to 4 pictures, exactly one of them the"
         " document's own."),
        ('["lens.far=30"]', '"lens.far=30"',
         "view.compare[2].set = 'lens.far=30': must be a list of texts NAME=VALUE."),
        ("lens.far=30", "scene=cube",
         "view.compare[2].set = 'scene=cube': must be a value of settings, camera, lens, image,"
         " object or depth, as NAME=VALUE."),
        ("[0.25, 0.5]", "[0.5, 0.25]",
         "view.dividers = [0.5, 0.25]: must be increasing numbers from 0 to 1, one fewer than the"
         " compared pictures, or none for side by side."),
    ],
)  # fmt: skip
def test_a_damaged_comparison_is_refused_in_one_sentence(
    held: Document, good: str, bad: str, sentence: str
) -> None:
    text = to_json(held)
    assert text.count(good) >= 1
    place = text.rindex(good)
    with pytest.raises(Refusal) as refused:
        parse(text[:place] + bad + text[place + len(good) :])
    assert str(refused.value) == sentence


def test_a_document_opens_even_if_it_cannot_have_a_compared_picture_now() -> None:
    document = set_values(of("letter-f"), ["view.compare=lens.near=6"])
    nearer = replace(
        document,
        projection=replace(document.projection, lens=document.projection.lens.replaced(far=5.5)),
    )
    again = parse(to_json(nearer))
    with pytest.raises(Refusal, match=r"lens.near = 6"):
        pictured(again, again.view.compare[0])


@pytest.mark.parametrize(
    ("texts", "sentence"),
    [
        (["view.compare=other"], "view.compare = 'other': must be one of the scene's own"
         " comparisons (interpolation), or PATH=VALUE, with ; between the values of a picture,"
         " | between pictures, and NAME: before a picture that has a name."),
        (["view.compare=lens.near=-1"], "lens.near = -1: must be greater than 0."),
        (["view.dividers=0.5"], "view.dividers = [0.5]: must be increasing numbers from 0 to 1,"
         " one fewer than the compared pictures, or none for side by side."),
        (["view.compare=interpolation", "view.dividers=x"], "view.dividers = 'x': must be"
         " increasing numbers from 0 to 1, one fewer than the compared pictures, or none for side"
         " by side."),
    ],
)  # fmt: skip
def test_a_wrong_comparison_cannot_be_set(texts: list[str], sentence: str) -> None:
    with pytest.raises(Refusal) as refused:
        set_values(of("interpolation"), texts)
    assert str(refused.value) == sentence


def test_pictures_are_set_by_values_or_by_the_name_of_a_comparison() -> None:
    document = set_values(
        of("letter-f"), ["view.compare=lens.near=2;lens.far=40|lens.fov_y_deg=60"]
    )
    near, wide, own = (pictured(document, each).projection for each in document.view.compare)
    assert (near.lens.near, near.lens.far) == (2.0, 40.0)
    assert wide == replace(own, lens=own.lens.replaced(fov_y_deg=60.0))
    document = set_values(of("eye-plane"), ["view.compare=divides", "view.dividers=0.2,0.7"])
    assert document.settings["drawn"] == "clipped", "the last, if it is none of them"
    assert document.view.dividers == (0.2, 0.7)
    document = set_values(document, ["view.compare="])
    assert document.view == View()


def test_every_ready_made_comparison_has_pictures_that_differ() -> None:
    found = 0
    for name, phenomenon in PHENOMENA.items():
        for comparison in phenomenon.words.comparisons:
            pictures = ready_made(name, comparison.name)
            assert all(one != other for one in pictures for other in pictures if one is not other)
            found += 1
    assert found >= 4


def test_the_live_picture_has_its_name_as_long_as_it_has_its_values() -> None:
    document = compared(of("interpolation"), "interpolation")
    names = [name_of(document, picture) for picture in document.view.compare]
    assert names == ["affine", "correct"] and document.view.compare[0].live
    other = document.with_settings({"interpolation": "correct"})
    assert [name_of(other, picture) for picture in document.view.compare] == ["", "correct"]


PLAIN = DifferenceWriter(lambda name: TITLES[name], str, figure)


def names(document: Document) -> list[str]:
    """The names of the compared pictures as they are written above them."""
    pictures = document.view.compare
    phenomenon = PHENOMENA.get(document.scene)
    return names_in(
        [name_of(document, picture) for picture in pictures],
        [pictured(document, picture).state for picture in pictures],
        () if phenomenon is None else phenomenon.settings,
        PLAIN,
    )


@pytest.mark.parametrize(
    ("scene", "compared_with", "expected"),
    [
        ("letter-f", "lens.near=8", ["near 8", "near 5"]),
        ("letter-f", "camera.eye=1,1,9;lens.fov_y_deg=95", ["field of view 95°",
                                                           "field of view 38°"]),
        ("letter-f", "lens.near=8|lens.near=8;lens.far=40", ["near 8, far 12.5", "near 8, far 40",
                                                            "near 5, far 12.5"]),
        ("letter-f", "lens.kind=orthographic", ["orthographic", "perspective"]),
        ("letter-f", "image.width=720", ["720 × 720", "1280 × 720"]),
        ("letter-f", "lens.near=5", ["", ""]),
        ("letter-f", "lens.near=5.0000001", ["near 5.0000001", "near 5"]),
        ("field-of-view", "settings.preset=eye|settings.preset=monitor",
         ["Human eye: 120° across", "Monitor: 30° across", "Photograph: 29 mm at 30 cm"]),
        ("field-of-view", "eye 120°: settings.preset=eye|settings.preset=monitor",
         ["eye 120°", "Monitor: 30° across", "Photograph: 29 mm at 30 cm"]),
    ],
)  # fmt: skip
def test_a_picture_is_called_what_differs(
    scene: str, compared_with: str, expected: list[str]
) -> None:
    document = set_values(of(scene), [f"view.compare={compared_with}"])
    assert names(document) == expected


def test_an_author_names_pictures_and_says_which_is_the_documents_own() -> None:
    text = "wide: lens.fov_y_deg=60|d: lens.fov_y_deg=38|near 8: lens.near=8"
    document = set_values(of("letter-f"), [f"view.compare={text}"])
    assert [picture.live for picture in document.view.compare] == [False, True, False]
    assert names(document) == ["wide", "d", "near 8"]
    assert "|".join(map(picture_text, document.view.compare)) == text
    assert parse(to_json(document)).view == document.view
    turned = set_values(document, ["lens.fov_y_deg=30"])
    assert names(turned) == ["wide", "field of view 30°, near 5", "near 8"], "it is no longer d"


# -- in what they differ


def test_only_what_differs_is_found() -> None:
    start = of("letter-f").projection
    other = replace(
        start, lens=start.lens.replaced(near=8.0, fov_y_deg=60.0), image_size=(720, 720)
    )
    assert differences([Held(start), Held(start)]) == []
    assert differences([Held(start), Held(other), Held(start)]) == [
        ("lens.fov_y_deg", (38.0, 60.0, 38.0)),
        ("lens.near", (5.0, 8.0, 5.0)),
        ("image", ((1280, 720), (720, 720), (1280, 720))),
    ]


def test_moving_towards_the_target_changes_the_distance_only() -> None:
    start = of("field-of-view")
    near, far = (each.state for each in ready_made("field-of-view", "photographs"))
    found = dict(differences([near, far]))
    assert found["settings.preset"] == ("wide", "tele")
    assert found["camera.distance"] == pytest.approx((3.0, 36.0))
    assert "camera.eye" not in found
    turned = set_values(start, ["camera.up=0.1,1,0"])
    assert {path for path, _ in differences([start.state, turned.state])} == {"camera.up"}


def test_the_differences_of_a_moved_object_are_found() -> None:
    start = of("letter-f")
    moved = set_values(start, ["object.rotate_deg=0,30,0", "depth=reversed"])
    assert differences([start.state, moved.state]) == [
        ("object.rotate_deg", ((0.0, 0.0, 0.0), (0.0, 30.0, 0.0))),
        ("depth", ("opengl", "reversed")),
    ]
    pictures = (ComparedPicture(held=moved.state), LIVE)
    held = replace(start, view=View(compare=pictures))
    assert parse(to_json(held)).view.compare == pictures


def test_lenses_of_two_kinds_are_compared_by_their_common_fields() -> None:
    start = of("letter-f").projection
    parallel = start.with_lens("orthographic")
    typed = replace(start, lens=FreeMatrix(np.eye(4).tolist()))
    paths = [path for path, _ in differences([Held(start), Held(parallel)])]
    assert paths == ["lens.kind"]
    assert "lens.kind" in [path for path, _ in differences([Held(start), Held(typed)])]


# -- the lectures' own


def test_l7_the_window_is_stretched_or_keeps_x_or_y() -> None:
    """A window of 8 by 4.5, its middle 1.5 to the left, in an image as high as wide.

    Lecture 000, variants X and Y; the window is as far away as the target, and near is less far.
    """
    stretch, keep_x, keep_y = (each.projection for each in ready_made("off-axis-window",
                                                                    "proportions"))  # fmt: skip
    part = stretch.lens.near / stretch.camera.distance
    left, right, bottom, top = -5.5 * part, 2.5 * part, -2.25 * part, 2.25 * part
    assert stretch.window == pytest.approx((left, right, bottom, top))
    assert keep_x.window == pytest.approx((left, right, -4.0 * part, 4.0 * part)), "y is fitted"
    k = (4.5 - 8.0) / 2.0 * part
    assert keep_y.window == pytest.approx((left - k, right + k, bottom, top)), "x2 is x_max + k"
    for projection, square in ((stretch, False), (keep_x, True), (keep_y, True)):
        # One unit across and one up, in the plane of the window: circles stay round, or do not.
        x, y, _ = projection.camera.target
        corner, across, up = projection.trace(
            np.array([(x, y, 0.0), (x + 1.0, y, 0.0), (x, y + 1.0, 0.0)])
        ).image
        sides = across[0] - corner[0], corner[1] - up[1]
        assert (sides[0] == pytest.approx(sides[1])) == square
        assert projection.image_size == (720, 720)


def test_l18_one_picture_interpolates_affinely_and_the_other_divides() -> None:
    affine, correct = ready_made("interpolation", "interpolation")
    assert affine.projection == correct.projection
    textures = [shown(each).rendering for each in (affine, correct)]
    assert [each and each.texture and each.texture.affine for each in textures] == [True, False]


def value(document: Document, label: str) -> Any:
    (reading,) = (each for each in shown(document).readings if each.label == label)
    return reading.value
