"""Figures of compared pictures, divided or side by side."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from app.document.compare import DifferenceWriter, in_words
from app.document.document import Document
from app.document.lengths import DPI
from app.document.settings import compared, pictured, set_values
from app.drawings.figure import Figure
from app.drawings.off_screen import Pixels
from app.drawings.side_by_side import cells, places_of
from app.drawings.style import LIGHT, TITLE_EM, rgb
from app.model.parameters import TITLES
from app.model.refusal import Refusal
from app.scenes.phenomena.words import figure as written_figure
from app.scenes.scene import load

SIZE = 320, 180


def figure(
    document: Document, *panes: str, size: tuple[int, int] = SIZE, text_pt: float | None = None
) -> Pixels:
    scene = load(document.scene)
    return Figure(document, scene, panes or ("image",), size, text_pt=text_pt).pixels()


def alone(document: Document, place: int) -> Document:
    """One of the pictures, compared with nothing."""
    picture = pictured(document, document.view.compare[place])
    return replace(picture, view=replace(document.view, compare=(), dividers=()))


@pytest.mark.parametrize("panes", [("image",), ("image", "ndc")])
def test_left_of_the_divider_is_the_one_picture_and_right_of_it_the_other(
    panes: tuple[str, ...],
) -> None:
    document = set_values(
        Document("letter-f", load("letter-f").start),
        ["view.compare=lens.near=8;camera.up=0.2,1,0", "view.dividers=0.5"],
    )
    size = 320 * len(panes), 180
    both = figure(document, *panes, size=size)[:, :320]
    text_pt = Figure(document, load("letter-f"), panes, size).em_pt
    other, own = (
        figure(alone(document, place), *panes, size=size, text_pt=text_pt)[:, :320]
        for place in (0, 1)
    )
    title = 60 if len(panes) > 1 else 0  # where the pictures' names are
    assert (both[title:, :156] == other[title:, :156]).all()
    assert (both[title:, 164:] == own[title:, 164:]).all()
    assert (other[title:, 164:] != own[title:, 164:]).any()
    assert (both[90, 159:161] == np.array(rgb(LIGHT.ink)) * 255).all(axis=1).any()


def bar_px(pixels: Pixels) -> int:
    """The height of the measure beside the subject."""
    colour = np.array(rgb(LIGHT.accent)) * 255.0
    is_bar = (np.abs(pixels[..., :3] - colour) < 6.0).all(axis=-1)
    # An upright line: the column of the most pixels of its colour.
    column = is_bar[:, np.argmax(is_bar.sum(axis=0))]
    return int(np.flatnonzero(column)[-1] - np.flatnonzero(column)[0])


def test_l20_the_measured_subject_is_as_high_in_both_photographs() -> None:
    document = compared(Document("field-of-view", load("field-of-view").start), "photographs")
    pixels = figure(document, size=(800, 300))
    (_, _, wide, _), (left, _, _, _) = cells(800, 300, [16 / 9, 16 / 9], 12.0)
    assert wide == left == 400
    one, other = bar_px(pixels[:, :400]), bar_px(pixels[:, 400:])
    assert one > 100 and abs(one - other) <= 1
    assert np.abs(pixels[:, :400].astype(int) - pixels[:, 400:]).max() > 100


def test_nothing_is_written_below_pictures_side_by_side() -> None:
    document = compared(Document("field-of-view", load("field-of-view").start), "photographs")
    figures = (figure(document, size=(800, height)) for height in (300, 340))
    lows = [np.flatnonzero((pixels != 255).any(axis=(1, 2)))[-1] for pixels in figures]
    # They are as high as their width allows; what is free is above and below them.
    assert 15 <= lows[1] - lows[0] <= 25 and (300 - lows[0]) < 60


def test_in_what_pictures_differ_in_words() -> None:
    start = load("letter-f").start
    document = set_values(
        Document("letter-f", start), ["view.compare=lens.near=6;lens.fov_y_deg=30;camera.up=0,2,1"]
    )
    states = [pictured(document, picture).state for picture in document.view.compare]
    plain = DifferenceWriter(lambda name: TITLES[name], str, written_figure)
    unnamed = [replace(picture, changes=()) for picture in document.view.compare]
    assert in_words(unnamed, states, (), plain) == [
        "up (0, 2, 1) → (0, 1, 0)", "field of view 30° → 38°", "near 6 → 5",
    ]  # fmt: skip


def test_a_picture_that_there_is_not_is_refused_in_one_sentence() -> None:
    document = set_values(
        Document("letter-f", load("letter-f").start), ["view.compare=lens.near=6"]
    )
    lens = document.projection.lens.replaced(far=5.5)
    document = replace(document, projection=replace(document.projection, lens=lens))
    with pytest.raises(Refusal, match=r"^lens.near = 6: must be less than far, which is 5.5\.$"):
        figure(document)


# -- side by side


@pytest.mark.parametrize(
    ("size", "aspects", "in_row"),
    [
        ((1000, 300), [16 / 9, 16 / 9], True),
        ((600, 700), [16 / 9, 16 / 9], False),
        ((300, 1000), [1.0, 1.0, 1.0], False),
        ((900, 320), [1.0, 16 / 9, 0.5], True),
    ],
)
def test_pictures_side_by_side_are_as_large_as_they_can_be(
    size: tuple[int, int], aspects: list[float], in_row: bool
) -> None:
    width, height = size
    found = cells(width, height, aspects, 13.0)
    assert len(found) == len(aspects)
    assert (found[1][1] == 0) == in_row
    for (left, top, wide, high), (next_left, next_top, _, _) in pairwise(found):
        assert (next_left, next_top) == ((left + wide, 0) if in_row else (0, top + high))
    left, top, wide, high = found[-1]
    assert left + wide <= width and top + high <= height
    if in_row and len(set(aspects)) > 1:  # of one height: the wider picture has the wider place
        assert sorted(aspects) == [a for _, a in sorted(zip((c[2] for c in found), aspects,
                                                            strict=True))]  # fmt: skip


@pytest.mark.parametrize(
    ("size", "count", "across"), [((600, 620), 3, 2), ((600, 600), 4, 2), ((620, 400), 5, 3)]
)
def test_squares_are_largest_in_rows_of_several(
    size: tuple[int, int], count: int, across: int
) -> None:
    """Three squares in a square: two above one, which is in the middle and no larger."""
    width, height = size
    found = cells(*size, [1.0] * count, 13.0)
    first, rows = found[0], -(-count // across)
    assert [left for left, top, *_ in found if top == 0] == [
        place * first[2] for place in range(across)
    ]
    assert {(wide, high) for _, _, wide, high in found} == {(first[2], height // rows)}
    left, top, wide, _ = found[-1]
    last = count - (rows - 1) * across
    assert top == (rows - 1) * (height // rows)
    assert abs(left + wide - (width + last * wide) / 2.0) <= last
    assert first[2] > 1.2 * max(width / count, min(width, height / count))


@pytest.mark.parametrize("size", [(0, 0), (1, 1), (5, 300)])
def test_places_without_room_are_places(size: tuple[int, int]) -> None:
    for left, top, wide, high in cells(*size, [1.5, 1.5, 1.5], 13.0):
        assert 0 <= left <= left + wide <= size[0] and 0 <= top <= top + high <= size[1]


def test_one_row_is_enough_if_two_would_hardly_be_larger() -> None:
    """Three pictures of 16 : 9 on a slide: two above one would be larger by a tenth."""
    found = cells(1920, 830, [16 / 9] * 3, 36.0)
    assert {top for _, top, _, _ in found} == {0}


# -- worlds


def worlds(*slide: str) -> Document:
    scene = load("letter-f")
    return set_values(
        Document("letter-f", scene.start),
        [f"view.slide={','.join(slide)}", "view.names=near", "view.fixed=side",
         "view.compare=near 5: lens.near=5|near 6: lens.near=6"],
    )  # fmt: skip


def test_if_the_world_is_the_slide_worlds_are_compared() -> None:
    """Beside each other, of one height, each as in a figure of its own; their names above."""
    document = worlds("world")
    assert document.view.compares_in == "world" and worlds("image").view.compares_in == "image"
    assert worlds("world", "image").view.compares_in == "image"
    size, text_pt = (640, 320), Figure(document, load("letter-f"), ("world",), (640, 320)).em_pt
    both = figure(document, "world", size=size, text_pt=text_pt)
    (_, _, wide, _), (left, top, other_wide, _) = places_of(
        "world", *size, [16 / 9] * 2, text_pt * DPI / 72.0
    )
    assert wide == other_wide and top == 0
    above = round(TITLE_EM * text_pt * DPI / 72.0)
    below = slice(above, size[1])
    for place, start in ((0, 0), (1, left)):
        one = figure(alone(document, place), "world", size=(wide, size[1]), text_pt=text_pt)
        part = both[:, start : start + wide]
        assert (part[:above] != 255).any(), "the name"
        assert (part[below] == one[below]).mean() > 0.99
    images = figure(document, "image", size=size)
    assert (images == figure(alone(document, 0), "image", size=size)).all(), "only one"
