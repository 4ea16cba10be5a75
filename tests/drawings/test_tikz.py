"""TikZ figures: every shape as its command, and no text that is a command."""

import os
import re
from pathlib import Path

import numpy as np
import pytest

from app.drawings.tikz import tikz
from app.drawings.vectors import Area, Disc, LabelText, LineShape, PixelShape, Shape, TextShape
from app.lecture.typesetting import line_of, piece_of
from app.model.refusal import Refusal
from app.scenes.scene import load
from tests.support.drawings import figure_of

BLUE, RED = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)
SIZE = 1000.0, 500.0  # in pixels, 300 an inch: 240 by 120 units of 1/72 inch
PALE = np.full((2, 3, 3), 200, dtype=np.uint8)


def label(text: str, anchor: int = 0, turn: float = 0.0, *, plain: bool = False) -> TextShape:
    pieces = line_of(text, plain).pieces
    widths = tuple(piece_of(piece, is_tex).width for piece, is_tex, *_ in pieces)
    place = (100.0, 200.0)
    written = LabelText(
        text, pieces, widths, place, turn, 25.0, "#ff0000", "#ffffff", 1.0, False, anchor
    )
    return TextShape(written, place, 25.0)


def body(*shapes: Shape, title: str = "t") -> list[str]:
    """The lines of the shapes, after those that name colours and styles."""
    lines = tikz(shapes, SIZE, title)[0].decode().splitlines()
    assert lines[-1] == r"\end{tikzpicture}%"
    (box,) = [place for place, line in enumerate(lines) if line.startswith(r"\useasboundingbox")]
    assert lines[box] == r"\useasboundingbox (0,0) rectangle (240,120);"
    begin, end = r"\begin{scope}\clip (0,0) rectangle (240,120);", r"\end{scope}"
    assert lines.count(begin) == lines.count(end)
    return [line for line in lines[box + 1 : -1] if line not in (begin, end)]


def said(text: str, *, plain: bool = False) -> str:
    contour, line = body(label(text, plain=plain))
    letters = line[line.index("{") + 1 : line.rindex("}")]
    halo = contour.replace(r"\gap{} ", " ").replace(r"\gap\ ", r"\ ")
    assert halo.endswith(rf" {{\halo{{{letters}}}}};")
    return letters


TRIANGLE = [(0.0, 0.0), (100.0, 0.0), (100.0, 50.0)]


@pytest.mark.parametrize(
    ("shape", "expected"),
    [
        (
            Area([TRIANGLE], BLUE, 1.0),
            r"\path[fill=c1,draw=c1,line width=0.1bp] (24,108)--(24,120)--(0,120)--cycle;",
        ),
        (
            Area([TRIANGLE[::-1]], BLUE, 0.25),
            r"\path[fill=c1,fill opacity=0.25] (24,108)--(24,120)--(0,120)--cycle;",
        ),
        (
            LineShape(TRIANGLE, BLUE, 1.0, 5.0),
            r"\path[draw=c1,line width=1.2bp] (0,120)--(24,120)--(24,108);",
        ),
        (
            LineShape(TRIANGLE[:2], BLUE, 0.5, 2.5, (20.0, 10.0)),
            r"\path[draw=c1,line width=0.6bp,line cap=butt,dash pattern=on 4.8bp off 2.4bp"
            r",draw opacity=0.5] (0,120)--(24,120);",
        ),
        (Disc((100.0, 50.0), 10.0, BLUE, 1.0), r"\path[fill=c1] (24,108) circle[radius=2.4];"),
        (
            PixelShape(PALE, (100.0, 0.0, 500.0, 250.0)),
            r"\node[anchor=north west,inner sep=0bp] at (24,120)"
            r" {\includegraphics[width=120bp,height=60bp]{g-pixels1.png}};",
        ),
        (label("eye", -1), r"\node[t1,text=c2,anchor=base west] at (24,72) {eye};"),
        (label("eye", -1, np.pi / 2), r"\node[t1,text=c2,anchor=base west,rotate=90.00]"
                                      r" at (24,72) {eye};"),
    ],
)  # fmt: skip
def test_a_shape_is_the_command_that_an_author_would_write(shape: Shape, expected: str) -> None:
    contour = expected.replace("c2", "c1").replace("] at", ",text opacity=0.8] at")
    contour = contour.replace("{eye}", r"{\halo{eye}}")
    assert body(shape) == [contour] * isinstance(shape, TextShape) + [expected]


def test_a_label_stays_at_its_anchor_and_has_the_size_that_was_asked_for() -> None:
    """TeX's words have another width: 25 pixels are 6/72 inch, or 6.0225 points of TeX."""
    left, middle, right = (
        float(re.findall(r"\(([\d.]+),72\)", body(label("eye", anchor))[0])[0])
        for anchor in (-1, 0, 1)
    )
    width = piece_of("eye", False).width * 6.0
    assert (middle - left, right - left) == pytest.approx((width / 2.0, width), abs=0.01)
    text = tikz([label("eye")], SIZE, "t")[0].decode()
    assert r"font=\fontsize{10}{10}\selectfont\nulldelimiterspace0pt,scale=0.6022" in text


def test_a_halo_has_no_gap_between_words() -> None:
    assert r"{\halo{the\gap{} eye\gap{} \$$1$}}" in body(label("the eye $1"))[0]
    assert r"{\halo{far\gap{} $-1\gap\ 2$}}" in body(label("far \u22121 2"))[0]
    assert r"{\halo{$0\gap.9$}}" in body(label("0.9"))[0]
    halo, letters = body(label("0,9"))  # TeX parts what a comma ends
    assert r"{\halo{$0\gap{,}9$}}" in halo and "{$0{,}9$}" in letters


def test_neighbours_of_one_colour_are_one_path_unless_it_would_be_long() -> None:
    areas = [Area([TRIANGLE], BLUE, 1.0)] * 3
    assert len(body(*areas)) == 1 and len(body(*areas, Area([TRIANGLE], RED, 1.0))) == 2
    lines = body(*[Area([TRIANGLE], BLUE, 1.0)] * 1000)
    assert sum(line.count("cycle") for line in lines) == 1000
    assert max(line.count("--") for line in lines) <= 500


def test_the_edge_cuts_shapes_and_no_letters_which_are_higher_in_tex() -> None:
    line = LineShape(TRIANGLE, BLUE, 1.0, 5.0)
    lines = tikz([line, label("P"), line], SIZE, "t")[0].decode().splitlines()
    contour, text = [place for place, each in enumerate(lines) if each.startswith(r"\node")]
    clip = r"\begin{scope}\clip"
    assert lines[contour - 1].startswith(clip) and lines[contour + 1] == r"\end{scope}"
    assert lines[text - 1] == r"\end{scope}" and lines[text + 1].startswith(clip)


def test_a_line_through_several_cells_has_no_ends_inside() -> None:
    one, two = LineShape(TRIANGLE[:2], BLUE, 1.0, 5.0), LineShape(TRIANGLE[1:], BLUE, 1.0, 5.0)
    assert body(one, two) == body(LineShape(TRIANGLE, BLUE, 1.0, 5.0))


@pytest.mark.parametrize(
    ("text", "tex"),
    [
        ("near n = 4", "near $n=4$"),
        ("far −10", "far $-10$"),
        ("fov_x = 30°", r"${\mathrm{fov}_{x}}=30^\circ$"),
        ("A + B / z", "$A+B/z$"),
        ("4 m", r"$4\ m$"),
        ("u\u20d7", r"${\vec{u}}$"),
        ("P\u2032", "${P'}$"),
        ("z = ∞", r"$z=\infty$"),
        ("глаз_п", r"глаз\textsubscript{п}"),
        ("$\\frac{a}{b}$", r"${\frac{a}{b}}$"),
        ("½ on", r"${}^1\!/_2$ on"),  # or it would come from a font of bitmaps
        (r"$f \, (f - n)$", "${f(f - n)}$"),
        (r"$f \, \tan(x)$", r"${f\tan(x)}$"),
    ],
)
def test_formulas_are_formulas_of_tex(text: str, tex: str) -> None:
    assert said(text) == tex


HOSTILE = [
    r"\input{/etc/passwd}", r"\write18{rm -rf}", r"$\input{a}$", r"$\catcode`\%=12$",
    "$x^^5cinput$", "^^5cinput{a}", "100 % of #1 & ~x_1 {a", "}}\\end{tikzpicture}",
    "a\nb\r\\input{x}", "$$", "$a$$",
    r"\mathrm{a}_{\input{b}}", "$\\mathrm{\u0444}$", "a -- b ,, c << `d' \"e\"", "$x$\\immediate",
    "\ue000\\\ue001", r"$\frac{a}{\csname input\endcsname}$", "\u2028%\u2028\\input{a}", r"\\[1em]",
]  # fmt: skip
KNOWN = {
    "char", "textbackslash", "textasciitilde", "textasciicircum", "textsubscript", "mathrm",
}  # fmt: skip


@pytest.mark.parametrize("plain", [False, True])
@pytest.mark.parametrize("text", HOSTILE)
def test_nothing_that_a_document_says_is_a_command(text: str, plain: bool) -> None:
    tex = said(text, plain=plain)
    assert set(re.findall(r"\\([a-zA-Z]+)", tex)) <= KNOWN
    without = re.sub(r"\\[^a-zA-Z]", "", tex)
    assert not re.search(r"[%#&~\n\r]|\^\^", without)
    depth = 0
    for sign in without:
        depth += (sign == "{") - (sign == "}")
        assert depth >= 0
    assert depth == 0 and without.count("$") % 2 == 0
    for line in tikz([], SIZE, text, text)[0].decode().split("\n")[:2]:
        assert line.startswith("% ") and "\r" not in line


def test_the_head_says_how_the_figure_is_used() -> None:
    head = tikz([label("eye")], SIZE, "Letter F", "The eye is here.")[0].decode().splitlines()
    assert head[:2] == ["% Letter F", "% The eye is here."]
    assert r"\input" in head[2] and r"\usepackage{tikz}" in head[2] and "T2A" not in head[3]
    assert "T2A" in tikz([label("глаз")], SIZE, "t")[0].decode()
    assert "[T1]" in tikz([label("između")], SIZE, "t")[0].decode()


def test_pixels_lie_beside_the_figure(tmp_path: Path) -> None:
    figure = figure_of(load("interpolation"), panes=["image"], size=(96, 54))
    figure.save(str(tmp_path / "g.tex"))
    text = (tmp_path / "g.tex").read_bytes()
    assert sorted(os.listdir(tmp_path)) == ["g-pixels1.png", "g.tex"]
    assert b"]{g-pixels1.png}" in text and rb"\graphicspath" in text
    figure.save(str(tmp_path / "g.tex"))
    assert (tmp_path / "g.tex").read_bytes() == text
    with pytest.raises(Refusal, match="whose name may have only letters"):
        figure.save(str(tmp_path / "a}^^5c.tex"))
    (tmp_path / "h-pixels1.png").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(Refusal, match=r"h-pixels1\.png: is a link"):
        figure.save(str(tmp_path / "h.tex"))
    assert sorted(os.listdir(tmp_path)) == ["g-pixels1.png", "g.tex", "h-pixels1.png"]


def test_a_figure_that_the_memory_of_tex_cannot_hold_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = load("cube")
    monkeypatch.setattr("app.drawings.figure_files.LARGEST", 1000)
    with pytest.raises(Refusal, match=r"would have 0\.\d+ MB; TeX's memory .*: write g\.pdf\."):
        figure_of(scene, scene.start, panes=["image"], size=(96, 54)).save(str(tmp_path / "g.tex"))
    assert not os.listdir(tmp_path)
