"""Labels: how they are typeset, and the pixels in which they reach the screen."""

import math
from dataclasses import fields
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.drawings import DrawingWords
from app.drawings.label import HALO_EM, SceneLabel, drawn, rim_px, size_px
from app.drawings.style import DARK, LIGHT, Style, contrast, rgb, tone
from app.lecture.typesetting import line_of, mathtext, outline, piece_of, pieces_of
from app.model.formula import ARROW
from app.scenes.scene import BUILT_IN, load
from tests.support.drawings import MakeScreen, OffScreen, illustrated, to_bytes

EM = 15.0
INK, PAPER = "#000000", "#ffffff"


@pytest.mark.parametrize(
    ("text", "pieces"),
    [
        ("y_p", [("y_{p}", True)]),
        ("P'", [("P'", True)]),
        ("x_min", [(r"x_{\mathrm{min}}", True)]),
        ("V_12", [("V_{12}", True)]),
        (f"n{ARROW}", [(r"\vec{n}", True)]),
        (f"T_0{ARROW}", [(r"\vec{T}_{0}", True)]),
        (f"T\u2081{ARROW}", [(r"\vec{T}_{1}", True)]),
        (f"look{ARROW}", [(r"\vec{\mathrm{look}}", True)]),
        ("θ_h/2", [(r"\theta _{h}", True), ("/", False), ("2", False)]),
        ("fov_x", [(r"\mathrm{fov}_{x}", True)]),
        ("fov", [(r"\mathrm{fov}", True)]),
        ("f tan(x)", [("f", True), (" ", False), (r"\tan ", True), ("(", False), ("x", True),
                      (")", False)]),
        ("near n", [("near", False), (" ", False), ("n", True)]),
        ("½ в мире", [("½", False), (" ", False), ("в", False), (" ", False), ("мире", False)]),
        ("½ u\u00a0svijetu", [("½", False), (" ", False), ("u\u00a0svijetu", False)]),
        ("u\u00a0= 1", [("u", True), ("\u00a0", False), ("=", False), (" ", False), ("1", False)]),
        (r"$\frac{y}{w}$", [(r"\frac{y}{w}", True)]),
    ],
)  # fmt: skip
def test_letters_are_formulas_and_words_are_words(
    text: str, pieces: list[tuple[str, bool]]
) -> None:
    assert pieces_of(text) == pieces
    left, low, right, high = line_of(text).box
    assert right > left and high > low and math.isfinite(line_of(text).pieces[-1][3])


@given(st.text(max_size=30))
def test_no_text_is_lost_and_any_can_be_drawn(text: str) -> None:
    left, low, right, high = line_of(text).box
    assert left <= right and low <= high
    assert line_of(text, plain=True).pieces == ((text, False, 1.0, 0.0),)
    assert all(side >= 0 for side in size_px(text, EM))


def test_a_sign_that_no_font_has_is_shown_as_a_missing_one() -> None:
    left, _, right, _ = line_of("\u6f22").box
    assert right > left and line_of("\u6f22").box == line_of("\u5b57").box


def test_broken_tex_is_shown_as_it_is_typed() -> None:
    typed = r"$\frac{1$"
    assert line_of(typed) == line_of(typed, plain=True)


def test_a_letter_alone_is_larger_than_a_word_and_a_subscript_hangs_lower() -> None:
    (_, _, alone, _), *_ = line_of("x").pieces
    (_, _, word, _), *_, (_, _, beside, _) = line_of("near x").pieces
    assert word == 1.0 < beside < alone
    _, low, _, high = line_of("y_p").box
    _, low_alone, _, high_alone = line_of("y").box
    assert low < low_alone and high == pytest.approx(high_alone)


def test_a_plain_text_has_no_formulas(off_screen: MakeScreen) -> None:
    """A stranger's text is shown letter by letter: in its size and in its pixels."""
    text = "a_b $x$"
    screen, label = off_screen(160, 40), SceneLabel(text, LIGHT, anchor=(-1, -1), plain=True)
    assert label.size_px == size_px(text, EM, plain=True) != size_px(text, EM)
    assert (
        pixels_of(screen, label, 10, 10) == flat(drawn(text, EM, label_tone(), PAPER, plain=True))
    ).all()


@pytest.mark.parametrize("em", [9.0, 15.0, 40.0])
def test_letters_have_the_size_that_they_report(em: float) -> None:
    for text in ("near n = 4", "y_p", "g", "P'"):
        pixels, rim = drawn(text, em, INK, PAPER), rim_px(em)
        wide, high = size_px(text, em)
        assert pixels.shape[:2] == (high + 2 * rim, wide + 2 * rim)
        dark = (pixels[..., :3].max(axis=2) < 128) & (pixels[..., 3] > 128)
        rows, columns = np.nonzero(dark)
        most = max(2.0, 0.1 * em)
        assert abs(np.ptp(rows) + 1 - high) <= most and abs(np.ptp(columns) + 1 - wide) <= most
    assert size_px("near", 2.0 * em)[1] == pytest.approx(2.0 * size_px("near", em)[1], abs=1.5)
    capital = size_px("H", em)[1] if em > 9.0 else 0.9 * em
    assert 0.8 * em < capital < 1.1 * em


def test_a_halo_surrounds_the_letters() -> None:
    """Opaque next to a stroke, in the paper's colour, and gone beyond its width."""
    em = 60.0
    pixels = drawn("l", em, INK, "#ff0000").astype(int)
    middle = pixels[len(pixels) // 2]
    inked = np.flatnonzero((middle[:, 0] < 30) & (middle[:, 3] > 250))
    beside = middle[inked.max() + 3 : inked.max() + round(HALO_EM * em) - 2]
    assert len(beside) > 1 and (beside[:, :3] == (255, 0, 0)).all() and beside[:, 3].min() > 200
    assert (middle[inked.max() + round(HALO_EM * em) + 3 :, 3] == 0).all()


def test_no_line_shows_between_the_words_of_a_label() -> None:
    em = 60.0
    pixels = drawn("all n = all", em, INK, PAPER)
    low = pixels[len(pixels) - rim_px(em) - round(0.2 * em), :, 3]
    assert low[rim_px(em) : -rim_px(em)].min() > 200


@pytest.mark.parametrize("text", ["0.9", "0,9"])
def test_no_line_shows_as_a_second_point_of_a_number(text: str) -> None:
    em, layout = 60.0, line_of(text)
    pixels = drawn(text, em, INK, PAPER)
    begin, end = (rim_px(em) + round(em * (at - layout.box[0])) for *_, at in layout.pieces[1:])
    above = pixels[: len(pixels) - rim_px(em) - round(0.2 * em), begin:end, 3]
    assert above[-round(0.4 * em) :].min() > 200


@pytest.mark.parametrize("style", [LIGHT, DARK])
def test_every_tone_can_be_read(style: Style) -> None:
    for field in fields(style):
        colour = getattr(style, field.name)
        if isinstance(colour, str) and field.name not in ("background", "margin"):
            assert contrast(tone(colour, style.background), style.background) >= 4.5, field.name
    for name in ("near", "far", "u", "v", "n", "accent"):
        assert tone(getattr(style, name), style.background) != getattr(style, name)


@given(st.tuples(*[st.integers(0, 255)] * 3), st.sampled_from([LIGHT, DARK]))
def test_any_colour_has_a_tone_that_can_be_read(rgb_8: tuple[int, int, int], style: Style) -> None:
    colour = "#{:02x}{:02x}{:02x}".format(*rgb_8)
    assert contrast(tone(colour, style.background), style.background) >= 4.5


def test_every_text_of_every_scene_is_typeset_without_raw_signs() -> None:
    for name in BUILT_IN:
        shown = illustrated(load(name))
        for marks in (shown.world, shown.ndc, shown.image) if shown else ():
            for text in marks.texts:
                words = "".join(piece for piece, is_tex in pieces_of(text.text) if not is_tex)
                assert not set(words) & set("_$\\"), (name, text.text)


# -- on the screen


def label_tone() -> str:
    return tone(LIGHT.ink, LIGHT.background)


def flat(pixels: np.ndarray) -> np.ndarray:
    """A label on white paper."""
    opacity = pixels[..., 3:] / 255.0
    return np.rint(opacity * pixels[..., :3] + (1.0 - opacity) * 255.0)


def pixels_of(screen: OffScreen, label: SceneLabel, x: int, y: int) -> np.ndarray:
    """What a window shows of a label whose letters begin at a pixel from the bottom left."""
    screen.renderer.SetBackground(*rgb(LIGHT.background))
    screen.renderer.AddViewProp(label.actor)
    label.set_position(x, y)
    image = screen.pixels()[::-1]
    rim, (wide, high) = rim_px(label.em), label.size_px
    return image[y - rim : y + high + rim, x - rim : x + wide + rim][::-1].astype(float)


@pytest.mark.parametrize("text", ["near n = 4", "y_p", "рядом", r"$\frac{y}{w}$"])
def test_the_pixels_in_a_window_are_those_that_were_drawn(
    off_screen: MakeScreen, text: str
) -> None:
    screen, label = off_screen(200, 80), SceneLabel(text, LIGHT, anchor=(-1, -1))
    shown = pixels_of(screen, label, 30, 25)
    assert np.abs(shown - flat(drawn(text, EM, label_tone(), PAPER))).max() <= 1.0
    label.set_position(30.4, 24.6)  # to whole pixels
    assert np.abs(pixels_of(screen, label, 30, 25) - shown).max() == 0.0


def test_a_label_stands_where_its_anchor_says_and_can_be_pointed_at(off_screen: MakeScreen) -> None:
    screen = off_screen(200, 80)
    screen.renderer.SetBackground(*rgb(LIGHT.background))
    for anchor in ((0, 0), (-1, 1), (1, -1)):
        label = SceneLabel("near", LIGHT, anchor=anchor)
        screen.renderer.AddViewProp(label.actor)
        label.set_position(100.0, 40.0)
        inked = (screen.pixels()[::-1] == to_bytes(label_tone())).all(axis=2)
        rows, columns = np.nonzero(inked)
        left, right, low, high = label.box_px
        assert left - 1 <= columns.min() and columns.max() <= right + 1
        assert low - 1 <= rows.min() and rows.max() <= high + 1
        assert label.covers((left + right) / 2.0, (low + high) / 2.0)
        assert label.covers((left + right) / 2.0, low - 2.0), "by its underline"
        assert not label.covers(left - 6.0, low) and not label.covers(right, high + 6.0)
        label.set_shown(False)
        assert not label.covers((left + right) / 2.0, (low + high) / 2.0)
        assert (screen.pixels() == 255).all()


def test_a_turned_label_is_as_wide_as_its_box(off_screen: MakeScreen) -> None:
    screen, label = off_screen(200, 120), SceneLabel("near n = 4", LIGHT)
    screen.renderer.AddViewProp(label.actor)
    screen.renderer.SetBackground(*rgb(LIGHT.background))
    label.set_position(100.0, 60.0, math.radians(30.0))
    rows, columns = np.nonzero((screen.pixels()[::-1] < 100).all(axis=2))
    left, right, low, high = label.box_px
    wide, tall = label.size_px
    assert right - left == pytest.approx(wide * math.cos(math.pi / 6) + tall / 2.0)
    assert left - 1 <= columns.min() and columns.max() <= right + 1
    assert low - 1 <= rows.min() and rows.max() <= high + 1
    assert np.corrcoef(columns, rows)[0, 1] > 0.7  # to the right and up


def test_an_underlined_label_keeps_its_letters_in_place(off_screen: MakeScreen) -> None:
    screen, label = off_screen(200, 80), SceneLabel("near", LIGHT, anchor=(-1, -1))
    plain = pixels_of(screen, label, 30, 30)
    label.set_underlined(True)
    assert (pixels_of(screen, label, 30, 30)[:-4] == plain[:-4]).all()
    below = screen.pixels()[::-1][24:30, 30:60]
    assert (below == to_bytes(label_tone())).all(axis=2).any(axis=0).all()


def test_only_the_letter_of_a_name_with_a_value_can_be_shown_alone(off_screen: MakeScreen) -> None:
    label = SceneLabel("near n = 5", LIGHT)
    whole = label.box_px
    label.shorten(True)
    assert label.text == label.written.text == "n" and label.box_px[1] < whole[1]
    label.set_text("near x_min = -1.5")
    assert label.text == "x_min"
    for text in ("near -1", "eye", "a = 1, b = 2", "s ="):
        label.set_text(text)
        assert label.text == text


def gaps(text: str, one_size: bool) -> list[float]:
    """The widths of the white between the words and letters of a label, in em."""
    ends = []
    for piece, is_tex, size, x in line_of(text, one_size=one_size).pieces:
        if piece != " ":
            left, _, right, _ = piece_of(piece, is_tex).box
            ends.append((x + size * left, x + size * right))
    return [after[0] - before[1] for before, after in pairwise(ends)]


@pytest.mark.parametrize("one_size", [False, True])
@pytest.mark.parametrize("text", ["far f", "far f = 1", "of j", "f tan", "f sin", "half f_x"])
def test_letters_that_lean_stand_as_far_from_words_as_upright_ones(
    text: str, one_size: bool
) -> None:
    assert min(gaps(text, one_size)) > 0.2
    assert gaps("near n", one_size) == pytest.approx(gaps("far f", one_size), abs=0.06)


@pytest.mark.parametrize("name", ["tan", "sin", "cos", "log"])
@pytest.mark.parametrize("before", ["f", "2f", "d", "V", r"\phi", "(f)", "f_x"])
def test_a_thin_space_stands_before_a_function(before: str, name: str) -> None:
    """As TeX has it; of what stands before, the function's own ink is where it would be alone."""
    alone, own = outline(rf"\{name}\alpha"), outline(before)
    both = outline(rf"{before}\{name}\alpha").vertices[len(own.vertices) :]
    white = both[:, 0].min() - own.box[2]
    assert 0.05 < white - alone.box[0] < 0.3, white
    assert outline(rf"{before} \{name} \alpha").box == outline(rf"{before}\{name}\alpha").box


def test_a_thin_space_stands_only_where_tex_has_one() -> None:
    for tex in (r"-\tan x", r"a \cdot \tan x", r"(\tan x)", r"\frac{\tan x}{2}", r"a=\cos x"):
        assert mathtext(tex) == f"${tex}$"


@pytest.mark.parametrize("letters", ["own", "004"])
def test_the_equation_of_a_plane_is_not_shortened_to_a_letter(letters: str) -> None:
    """A plane "z = 0" that is called "z" reads as an axis."""
    scene = load("planar-shadow")
    illustration = scene.illustration(scene.start, {})
    assert illustration is not None
    (ground,) = (text.text for text in illustration.world.texts if text.name == "ground")
    for text in (ground, DrawingWords(letters)["{eye_plane}"]):
        label = SceneLabel(text, LIGHT)
        assert "= 0" in text and label.letter_px == label.size_px
    valued = SceneLabel("near n = 4", LIGHT)
    assert valued.letter_px < valued.size_px
