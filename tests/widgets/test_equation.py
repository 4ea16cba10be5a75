"""An equation as a slide: its size, the picture beside it, and the cells that controls change."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QRect, QRectF

from app.document.settings import set_values
from app.drawings.style import LIGHT
from app.lessons.lesson import parse_lesson
from app.model.refusal import Refusal
from tests.support.drawings import to_bytes
from tests.support.window import activate, give_room, rgb_of, settle
from widgets.window.equation import LEAST_CELL, LEAST_EM
from widgets.window.main_window import MainWindow

FORMULA = """---
title: A
---
# B {#b}
$$n + \\vec n$$
"""


@pytest.fixture
def window(window: MainWindow) -> MainWindow:
    """Presenting."""
    activate(window)
    window.present.begin()
    give_room(window, window.screen().geometry())
    return window


def inked(window: MainWindow) -> QRect:
    """The rectangle of what the equation has painted."""
    image = rgb_of(window.slide.equation.grab().toImage()).astype(int)
    rows, columns = np.nonzero(np.abs(image - image[0, 0]).max(axis=2) > 40)
    return QRect(
        int(columns.min()), int(rows.min()), int(np.ptp(columns)) + 1, int(np.ptp(rows)) + 1
    )


@pytest.mark.undrawn
def test_an_equation_has_a_small_world_beside_it(window: MainWindow) -> None:
    equation = window.slide.equation
    assert not equation.isVisible()
    window.store.set_view(slide=("equation",), equation="view")
    settle()
    width, height = window.width(), window.height()
    world = window.panes["world"]
    assert equation.isVisible() and world.isVisible()
    assert not window.panes["image"].isVisible()
    assert 0.2 <= world.width() / width <= 0.35
    found = inked(window)
    assert 0.6 <= found.width() / width <= 0.75
    assert found.height() >= 4 * LEAST_CELL * height
    window.store.set_view(slide=(), equation="")
    settle()
    assert not equation.isVisible() and world.width() == width


@pytest.mark.undrawn
def test_a_product_of_three_takes_the_whole_slide(window: MainWindow) -> None:
    window.store.set_view(slide=("equation",), equation="M_z M_pp M_persp", letters="001")
    settle()
    equation = window.slide.equation
    assert equation.width() == window.width() and not window.panes["world"].isVisible()
    found = inked(window)
    assert found.left() > 0 and found.right() < equation.width() - 1
    assert found.width() >= 0.75 * window.width()
    assert found.height() >= 4 * LEAST_CELL * window.height()
    sides = [edge for side in equation.brackets for edge in (side.left(), side.right())]
    assert min(sides) <= found.left() + 1 and max(sides) >= found.right() - 1
    assert len(equation.brackets) == 8 and max(each.width() for each in equation.brackets) < 40.0
    *_, (_, hidden_px) = window.slide.named()
    box = QRectF(equation.brackets[0]).getCoords()
    assert hidden_px(np.array([box, (0.0, 0.0, 5.0, 5.0)])).astype(bool).tolist() == [True, False]
    assert equation.em_in(equation.width(), equation.height()) >= 0.6 * LEAST_EM * window.height()


@pytest.mark.undrawn
@pytest.mark.parametrize(
    ("text", "letters", "share"),
    [("M_z M_pp M_persp", "001", 0.34), ("frustum", "000", 0.31), ("view", "001", 0.77)],
)
def test_an_equation_in_a_low_place_is_whole(
    window: MainWindow, text: str, letters: str, share: float
) -> None:
    """With two lines of text above, the first row was cut, or the words below."""
    window.store.set_view(slide=("equation",), equation=text, letters=letters)
    settle()
    equation = window.slide.equation
    equation.setFixedHeight(round(share * window.height()))
    settle()
    equation.grab()
    cells = [*equation.cells, *equation.brackets]
    low, high = min(cell.top() for cell in cells), max(cell.bottom() for cell in cells)
    assert -0.01 <= low < high <= equation.height()


@pytest.mark.undrawn
def test_the_cells_that_a_control_changes_light_up(window: MainWindow) -> None:
    window.store.set_view(slide=("equation",), equation="frustum")
    settle()
    equation = window.slide.equation
    before = rgb_of(equation.grab().toImage())
    window.store.set_view(controls=("lens.far",))
    settle()
    strip = window.control_strip.rows
    assert [row.name for row in strip] == ["Far"]
    after = rgb_of(equation.grab().toImage())
    blue = np.array([30, 155, 226])

    def framed(image: np.ndarray) -> int:
        return int((np.abs(image.astype(int) - blue).max(axis=2) < 12).sum())

    assert framed(before) < 50 < framed(after)


def coloured(image: np.ndarray, colour: str) -> int:
    """How many pixels have a colour, of ``"#rrggbb"``."""
    wanted = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)])
    return int((np.abs(image.astype(int) - wanted).max(axis=2) < 6).sum())


@pytest.mark.undrawn
def test_letters_have_the_colours_of_what_the_picture_names(window: MainWindow) -> None:
    window.store.set_view(slide=("equation",), equation="frustum", letters="000", names=("eye",))
    settle()
    equation, near, far = window.slide.equation, "#8a5a00", "#0b6aa8"
    assert coloured(rgb_of(equation.grab().toImage()), near) == 0
    window.store.set_view(names=("near",))
    settle()
    image = rgb_of(equation.grab().toImage())
    assert coloured(image, near) > 100 and coloured(image, far) == 0
    window.store.set_view(equation="frustum numbers")
    settle()
    assert coloured(rgb_of(equation.grab().toImage()), near) == 0


@pytest.mark.undrawn
def test_a_line_of_formula_has_them_too(window: MainWindow) -> None:
    band, shown, document = window.band, window.shown, window.store.document
    band.show()
    band.set_screen(float(window.height()))
    band.show_step(parse_lesson(FORMULA, Path("a.md")).steps[0], "1 / 1")
    counts = []
    for names in ((), ("near",), ("near", "n")):
        view = replace(document.view, names=names)
        band.take(replace(shown, document=replace(document, view=view)), {"view"})
        image = rgb_of(band.grab().toImage())
        counts.append([coloured(image, colour) > 10 for colour in ("#8a5a00", "#00609a")])
    assert counts == [[False, False], [True, False], [True, True]]


@pytest.mark.undrawn
def test_the_columns_of_the_objects_matrix_have_the_colours_of_its_axes(window: MainWindow) -> None:
    """Each of the first three columns is one band from top to bottom, also where it is 0."""
    shades = np.array([to_bytes(shade) for shade in (LIGHT.u, LIGHT.v, LIGHT.n)])
    turned = set_values(window.store.document, ["object.rotate_deg=0,0,-30"])
    window.store.set_projection(turned.projection)
    for equation in ("object numbers", "frustum numbers"):
        window.store.set_view(slide=("equation",), equation=equation)
        settle()
        image = rgb_of(window.slide.equation.grab().toImage()).astype(int)
        tinted = [
            np.abs(image - 0.2 * shade - 0.8 * image[0, 0]).max(axis=2) < 3 for shade in shades
        ]
        if equation == "frustum numbers":
            assert not any(each.any() for each in tinted)
            continue
        lefts = [int(np.nonzero(each.any(axis=0))[0].min()) for each in tinted]
        highs = [int(each.any(axis=1).sum()) for each in tinted]
        assert lefts == sorted(lefts) and min(highs) > 0.95 * max(highs)
        assert min(highs) > 0.7 * inked(window).height()  # three rows of four


@pytest.mark.undrawn
def test_words_under_the_view_matrix_say_what_its_parts_do(window: MainWindow) -> None:
    heights = []
    for equation in ("view", "view numbers", "frustum"):
        window.store.set_view(slide=("equation",), equation=equation)
        settle()
        heights.append(inked(window).height())
    assert heights[0] == heights[1] > 1.02 * heights[2]


@pytest.mark.undrawn
def test_numbers_follow_the_model(window: MainWindow) -> None:
    window.store.set_view(slide=("equation",), equation="frustum numbers")
    settle()
    equation = window.slide.equation
    near = window.store.document.projection.lens.near
    before = equation.accessibleName()
    changed = set_values(window.store.document, [f"lens.near={near / 2}"])
    window.store.set_projection(changed.projection)
    settle()
    assert equation.accessibleName() != before
    assert f"{changed.projection.clip_from_view[2, 3]:.4g}" in equation.accessibleName()


@pytest.mark.undrawn
def test_what_is_set_is_checked(window: MainWindow) -> None:
    document = window.store.document
    for text, said in (
        ("view.slide=world,image,ndc", "must be a list of at most 2 names"),
        ("view.panes=world", "what a class sees is view.slide"),
        ("view.slide=front", "view.slide = .front"),
        ("view.controls=lens.neer", "the nearest name is lens.near"),
        ("view.equation=frus", "has no matrix 'frus'"),
    ):
        with pytest.raises(Refusal, match=said):
            set_values(document, [text])
