"""Figures of shapes: they agree with the pixels of the same state, and their text is text."""

import random
import re
import zlib
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QByteArray, QPointF, Qt
from PySide6.QtGui import QImage, QPainter, QPolygonF
from PySide6.QtSvg import QSvgRenderer

from app.document.document import Document
from app.document.lengths import Size
from app.document.settings import set_values
from app.drawings import hidden, vectors
from app.drawings.actors import face_actor, identity_camera, line_actor, put_in_front
from app.drawings.figure import Figure
from app.drawings.occlusion import Points, ScreenCell
from app.drawings.off_screen import off_screen
from app.drawings.pdf import pdf
from app.drawings.prop_group import PropGroup
from app.drawings.side_by_side import panes_in
from app.drawings.style import LIGHT, rgb
from app.drawings.svg import svg
from app.drawings.vectors import Area, LineShape, PixelShape, TextShape, shapes_of
from app.lecture.typesetting import line_of, piece_of, pieces_of
from app.lessons.course import scene_of
from app.model.refusal import Cancelled, Refusal
from app.scenes.scene import load
from tests.support.drawings import figure_of

Pixels = NDArray[np.float64]
OVER = 2
"""Pixels of the raster, along each side, that become one."""
SEEN = 12.0
"""Difference of a colour, of 255, that is one."""


def raster(text: str, size: tuple[int, int]) -> Pixels:
    """What another program makes of an SVG file, (h, w, 3)."""
    width, height = size
    image = QImage(OVER * width, OVER * height, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    QSvgRenderer(QByteArray(text.encode())).render(painter)
    painter.end()
    pixels = np.frombuffer(image.constBits(), np.uint8).reshape(height, OVER, width, OVER, 4)
    return pixels[..., 2::-1].astype(np.float64).mean(axis=(1, 3))


def around(pixels: NDArray[Any]) -> NDArray[Any]:
    """Every pixel with its eight neighbours, (9, h, w, ...)."""
    height, width = pixels.shape[:2]
    wide = np.pad(pixels, [(1, 1), (1, 1)] + [(0, 0)] * (pixels.ndim - 2), mode="edge")
    return np.stack([wide[y : y + height, x : x + width] for y in range(3) for x in range(3)])


def agreeing(one: Pixels, other: Pixels) -> float:
    """The share of the pixels far from any edge that have the same colour in two pictures."""
    edges = np.zeros(one.shape[:2], dtype=np.bool_)
    for pixels in (one, other):
        edges |= np.ptp(around(pixels), axis=0).max(axis=-1) > SEEN
    inner = ~around(edges).any(axis=0)
    same = np.abs(one - other).max(axis=-1) <= SEEN
    assert inner.mean() > 0.3
    return float(same[inner].mean())


def dark_lines(pixels: Pixels, depth: float) -> NDArray[np.bool_]:
    """The pixels that are darker than those on both sides, by so much of 255."""
    light = pixels @ [0.2126, 0.7152, 0.0722]
    deepest = np.zeros_like(light)
    for x, y in ((1, 0), (0, 1), (1, 1), (1, -1)):
        for away in (2, 3):
            one = np.roll(light, (away * y, away * x), axis=(0, 1))
            other = np.roll(light, (-away * y, -away * x), axis=(0, 1))
            deepest = np.maximum(deepest, np.minimum(one, other) - light)
    return deepest > depth


def lost_lines(one: Pixels, other: Pixels, found: list[vectors.Shape]) -> int:
    """How many pixels of one's dark lines have none of the other within 1.5 pixels."""
    lost = dark_lines(one, 40.0) & ~around(dark_lines(other, 20.0)).any(axis=0)
    lost[:4], lost[-4:], lost[:, :4], lost[:, -4:] = False, False, False, False
    for label in found:  # whose font another program may not have
        if isinstance(label, TextShape):
            left, top, right, low = (round(s) for s in vectors.box_of([label], "#ffffff") or ())
            lost[max(0, top - 6) : low + 6, max(0, left - 12) : right + 12] = False
    return int(lost.sum())


def drawn_as(
    document: Document, panes: list[str], size: tuple[int, int]
) -> tuple[str, list[vectors.Shape], Pixels]:
    """A document's figure as SVG, as shapes, and in pixels."""
    figure = Figure(document, scene_of(document), panes, size)
    found, pixels = figure.shapes()[1], figure.pixels()
    return svg(found, size, figure.scene.name).decode(), found, pixels[..., :3].astype(np.float64)


@pytest.mark.parametrize(
    ("scene", "pane", "values"),
    [
        ("letter-f", "world", ("lens.near=7",)),  # the near plane cuts the letter
        ("letter-f", "ndc", ("view.stage=pyramid", "lens.kind=oblique")),
        ("clipping", "ndc", ()),  # an opaque card between two faces that are blended first
        ("off-axis-window", "image", ("depth=reversed",)),
        ("vanishing-points", "world", ()),  # a picture on a near plane that is seen askew
        ("interpolation", "world", ()),  # a shader
        ("posts", "image", ("view.compare=a: lens.near=2|b: lens.near=9", "view.dividers=0.4")),
        ("eye-plane", "world", ("view.compare=a: lens.near=1|b: lens.near=2", "view.slide=world")),
    ],
)
def test_shapes_are_where_the_pixels_are(
    qapp: Any, scene: str, pane: str, values: tuple[str, ...]
) -> None:
    document = set_values(Document(scene, load(scene).start), values)
    text, found, pixels = drawn_as(document, [pane], (400, 300))
    shown = raster(text, (400, 300))
    assert agreeing(shown, pixels) >= 0.998
    assert lost_lines(pixels, shown, found) <= 25, "lines that only the pixels have"
    assert lost_lines(shown, pixels, found) <= 25, "lines that only the shapes have"
    is_shaded = scene == "interpolation"
    assert text.count("<image ") == is_shaded
    assert any(isinstance(shape, Area) for shape in found) or is_shaded


def test_edges_cover_lines_of_the_ground_in_the_same_place() -> None:
    scene, along = load("cube"), np.linspace(-0.4, 0.4, 9)
    pixels = figure_of(scene, scene.start, ["image"], (1280, 720)).pixels().astype(np.float64)
    for x, z in ((along, 0.5), (0.5, along)):
        points = np.stack(np.broadcast_arrays(x, 0.0, z), axis=1)
        dark = around(pixels.mean(axis=2)).min(axis=0)
        at = np.rint(scene.start.trace(points).image - 0.5).astype(int)
        assert (dark[at[:, 1], at[:, 0]] < 120.0).all(), "a line of the ground has 158"


def test_a_figure_has_its_labels_as_text_and_is_small() -> None:
    document = Document("letter-f", load("letter-f").start)
    text, found, _ = drawn_as(document, ["world", "ndc", "image"], (1920, 640))
    again = drawn_as(document, ["world", "ndc", "image"], (1920, 640))[0]
    assert text == again and len(text) <= 50_000
    assert "l0 0" not in text, "no line is a point"
    tree = ElementTree.fromstring(text)
    written = ["".join(each.itertext()) for each in tree.iter("{http://www.w3.org/2000/svg}text")]
    labels = [shape.written.text for shape in found if isinstance(shape, TextShape)]
    assert len(labels) >= 6 and "near n = 5" in labels
    assert [each.replace("\u200b", "") for each in written] == labels
    assert tree.get("width") == "162.56mm" and tree.get("viewBox") == "0 0 1920 640"


def test_the_images_frame_is_a_line_over_all_backgrounds() -> None:
    document = Document("letter-f", load("letter-f").start)
    _, found, _ = drawn_as(document, ["world", "image"], (1280, 640))
    long = [
        at
        for at, shape in enumerate(found)
        if isinstance(shape, LineShape) and max(np.ptp(shape.points, axis=0)) > 350.0
        and min(np.ptp(shape.points, axis=0)) == 0.0
    ]  # fmt: skip
    large = [
        at
        for at, shape in enumerate(found)
        if isinstance(shape, Area)
        and shape.opacity == 1.0
        and (np.ptp(shape.rings[0], axis=0) > 350.0).all()
    ]
    assert len(long) == 4 and len(large) >= 3 and large[-1] < long[0]


def test_areas_of_one_colour_may_overlap_in_any_order_of_their_corners() -> None:
    ring = [(1.0, 1.0), (9.0, 1.0), (9.0, 9.0), (1.0, 9.0)]
    areas = [Area([ring], (0.0, 0.0, 0.0), 1.0), Area([ring[::-1]], (0.0, 0.0, 0.0), 1.0)]
    assert (raster(svg(areas, (10, 10), "t").decode(), (10, 10))[2:8, 2:8] < 1.0).all()


@pytest.mark.parametrize(
    ("label", "said"),
    [
        ("y_p", "yp"),
        ("f tan(\u03b1/2)", "f tan(\u03b1/2)"),
        ("P'", "P\u2032"),
        ("$\\frac{a}{b}$", None),
        ("$\\write18$", "$\\write18$"),
    ],
)
def test_formulas_are_letters_or_at_least_their_outlines(label: str, said: str | None) -> None:
    widths = tuple(1.0 for _ in pieces_of(label))
    written = vectors.LabelText(
        label, line_of(label).pieces, widths, (0.0, 0.0), 0.0, 20.0, "#000000", "#ffffff", 1.0, True
    )
    text = svg([TextShape(written, (10.0, 20.0), 20.0)], (100, 50), "a < b").decode()
    tree = ElementTree.fromstring(text)
    (element,) = tree.iter("{http://www.w3.org/2000/svg}text")
    (title,) = tree.iter("{http://www.w3.org/2000/svg}title")
    assert title.text == "a < b"
    if said is None:
        assert not "".join(element.itertext()) and text.count("<path") == 2  # and its underline
    else:
        assert "".join(element.itertext()).replace("\u200b", "") == said


def test_a_line_that_is_a_point_is_no_path() -> None:
    point = LineShape([(5.0, 5.0), (5.01, 5.0)], (0.0, 0.0, 0.0), 1.0, 1.0)
    assert "<path" not in svg([point], (10, 10), "t").decode()


def streams_of(content: bytes) -> list[bytes]:
    """The streams of a PDF file that are compressed."""
    found = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", content, re.DOTALL)
    return [zlib.decompress(each) for each in found if each[:1] == b"x"]


def test_a_pdf_has_shapes_text_and_its_fonts() -> None:
    document = Document("letter-f", load("letter-f").start)
    _, found = Figure(document, scene_of(document), ["world", "image"], (1280, 640)).shapes()
    content = pdf(found, (1280, 640), "A title", "Its text")
    assert content == pdf(found, (1280, 640), "A title", "Its text") and len(content) <= 50_000
    (box,) = re.findall(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", content)
    sides_mm = [float(side) / 72.0 * 25.4 for side in box]
    assert sides_mm == pytest.approx([108.37, 54.19], abs=0.01)
    assert b"/Subtype /Image" not in content
    assert b"/Title (A title)" in content and b"/Subject (Its text)" in content
    fonts = set(re.findall(rb"/BaseFont /[A-Z]+\+(\S+)", content))
    assert {b"DejaVuSans", b"STIXGeneral-Italic"} <= fonts
    assert content.count(b"/FontFile2") >= 2  # TrueType
    labels = sum(isinstance(shape, TextShape) for shape in found)
    drawn = b"".join(streams_of(content))
    assert len(re.findall(rb" T[jJ]\n", drawn)) >= labels > 2


def test_a_page_and_its_letters_are_as_large_as_asked_in_every_pane() -> None:
    document = set_values(
        Document("letter-f", load("letter-f").start), ("view.names=eye,near,pixels",)
    )
    scene, panes = scene_of(document), ["world", "ndc", "image"]
    size, found = Figure(document, scene, panes, Size(12.0, 4.0, "cm"), text_pt=7.3).shapes()
    content = pdf(found, size, "t")
    (box,) = re.findall(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", content)
    assert [float(side) for side in box] == pytest.approx([12 / 2.54 * 72, 4 / 2.54 * 72])
    assert b'width="120mm" height="40mm"' in svg(found, size, "t")
    drawn = b"".join(streams_of(content))
    known = np.multiply(7.3, [1.0, 0.7])  # of all letters, and of their subscripts
    sizes = [float(em) for em in re.findall(rb"/F\d+ ([\d.]+) Tf", drawn)]
    assert all(np.abs(known - em).min() < 0.1 for em in sizes) and min(sizes) < 7.4
    number = rb"(-?[\d.e-]+) "
    turns = re.findall(4 * number + 2 * number + rb"(?:cm|Tm)\n", drawn)
    for turn in turns:  # and no matrix enlarges them
        a, b, c, d = map(float, turn[:4])
        assert (a * d - b * c, a * c + b * d) == pytest.approx((1.0, 0.0), abs=1e-6)
    texts = [shape for shape in found if isinstance(shape, TextShape)]
    assert len(turns) >= len(texts)
    rights = [left + wide for left, _, wide, _ in panes_in((1418, 473), [None, None, 16 / 9])]
    assert {sum(right < text.place[0] for right in rights) for text in texts} == {0, 1, 2}


def test_a_cropped_figure_is_what_is_seen_and_2_mm() -> None:
    figure = figure_of(load("cube"), panes=["ndc"], size=(300, 200), column=True, crop=True)
    pixels, ((width, height), found) = figure.pixels(), figure.shapes()
    assert pixels.shape[:2] == pytest.approx((height, width), abs=2.0)
    left, top, right, bottom = vectors.box_of(found, LIGHT.background) or (0.0,) * 4
    assert 300 > width > right - left
    assert (left, width - right) == pytest.approx((2.0 / 25.4 * 300,) * 2)
    assert (top, height - bottom) == pytest.approx((2.0 / 25.4 * 300,) * 2, abs=10.0)
    corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
    page = Area([corners], rgb(LIGHT.background), 1.0)
    clear = replace(figure, transparent=True)
    size, shapes = clear.shapes()
    assert size == (width, height) and found[0] == page and page not in shapes
    assert clear.pixels().shape[:2] == pytest.approx(pixels.shape[:2], abs=2.0)
    finer = replace(figure, scale=2.0).pixels().shape[:2]
    assert finer == pytest.approx((2 * height, 2 * width), abs=3.0), "so is the margin"
    figure = figure_of(load("similar-triangles"), panes=["world"], size=(300, 300), crop=True)
    pixels, ((width, height), _) = figure.pixels(), figure.shapes()
    assert pixels.shape[0] < 250, "without what drawings keep outside until they need it"
    assert pixels.shape[:2] == pytest.approx((height, width), abs=2.0)


@pytest.mark.parametrize(
    "scene", ["depth-buffer", "interpolation", "far-plane-popping", "two-eyes"]
)
def test_pixels_of_a_transparent_figure_have_no_ground(scene: str) -> None:
    solid = figure_of(load(scene), panes=["image"], size=(240, 160))
    pages = []
    for figure in (solid, replace(solid, transparent=True)):
        page: Pixels = np.full((160, 240, 3), 255.0 * np.array(rgb(LIGHT.background)))
        shapes = [shape for shape in figure.shapes()[1] if isinstance(shape, PixelShape)]
        for pixels, (left, top, wide, high), _ in shapes:
            assert (pixels.shape[2] == 4) is figure.transparent
            share = pixels[..., 3:] / 255.0 if figure.transparent else 1.0
            part = page[int(top) : int(top + high), int(left) : int(left + wide)]
            part[:] = share * pixels[..., :3] + (1.0 - share) * part
        pages.append(page)
    assert np.abs(pages[0] - pages[1]).max() <= 3.0


def test_a_note_is_the_lowest_line_of_a_figure() -> None:
    figure = figure_of(load("cube"), panes=["ndc"], size=(300, 200), column=True)
    noted = replace(figure, note="near = 2")
    (above, below) = (
        [each for each in shown.shapes()[1] if isinstance(each, TextShape)]
        for shown in (figure, noted)
    )
    assert len(below) == len(above) + 1
    assert max(text.place[1] for text in below[:-1]) < below[-1].place[1] < 200.0


def test_no_half_of_an_images_pane_is_empty() -> None:
    assert panes_in((840, 320), [None, 16 / 9]) == [(0, 0, 420, 320), (420, 0, 420, 320)]
    assert panes_in((1920, 640), [None, None, 16 / 9])[2] == (1124, 0, 796, 640)
    assert panes_in((900, 600), [0.5, None]) == [(0, 0, 429, 600), (429, 0, 471, 600)]
    assert panes_in((600, 1200), [None, 2.0], column=True) == [(0, 0, 600, 771), (0, 771, 600, 429)]
    # The pane beside it keeps three quarters of an equal share.
    assert panes_in((800, 800), [None, 2.0]) == [(0, 0, 300, 800), (300, 0, 500, 800)]


def test_no_line_shows_between_the_words_of_a_figure(qapp: Any) -> None:
    line = LineShape([(0.0, 54.0), (100.0, 54.0)], (0.0, 0.0, 0.0), 1.0, 4.0)
    moves = []
    for text in ("ill lie", "illlie"):
        pieces = line_of(text).pieces
        widths = tuple(piece_of(piece, is_tex).width for piece, is_tex, *_ in pieces)
        written = vectors.LabelText(
            text, pieces, widths, (0.0, 0.0), 0.0, 20.0, "#ffffff", "#ffffff", 1.0, False
        )
        shapes = [line, TextShape(written, (10.0, 60.0), 20.0)]
        if text != "illlie":
            under = raster(svg(shapes, (100, 100), "t").decode(), (100, 100))[54, :, 0]
            assert under[5] == 0.0 and under[10 : 10 + round(20.0 * sum(widths))].min() > 200.0
        drawn = b"".join(streams_of(pdf(shapes, (100, 100), "t")))
        moves.append(len(re.findall(rb"[\d.]+ m\n", drawn)))
    assert moves[0] == moves[1] + 2, "lines in the space have a halo"


def test_no_line_shows_above_the_point_of_a_number_in_a_figure() -> None:
    """It would read as a colon."""
    line = LineShape([(0.0, 52.0), (100.0, 52.0)], (0.0, 0.0, 0.0), 1.0, 4.0)
    pieces = line_of("0.9").pieces
    widths = tuple(piece_of(piece, is_tex).width for piece, is_tex, *_ in pieces)
    written = vectors.LabelText(
        "0.9", pieces, widths, (0.0, 0.0), 0.0, 20.0, "#ffffff", "#ffffff", 1.0, False
    )
    drawn = svg([line, TextShape(written, (10.0, 60.0), 20.0)], (100, 100), "t").decode()
    begin, end = (round(10.0 + 20.0 * at) for *_, at in pieces[1:])
    assert raster(drawn, (100, 100))[52, begin:end, 0].min() > 200.0


def test_a_halo_has_the_colour_of_a_tint_and_is_white_on_what_is_dark_and_in_a_hole() -> None:
    pieces = line_of("A").pieces
    written = vectors.LabelText(
        "A", pieces, (1.0,), (0.0, 0.0), 0.0, 20.0, "#000000", "#ffffff", 1.0, False
    )

    def square(left: float, right: float) -> Points:
        return [(left, left), (right, left), (right, right), (left, right)]

    tint = Area([square(0.0, 100.0), square(40.0, 60.0)], (0.6, 0.8, 1.0), 0.5)
    dark = Area([square(70.0, 100.0)], (0.4, 0.2, 0.0), 1.0)
    labels = [TextShape(written, (at, at + 7.0), 20.0) for at in (10.0, 43.0, 78.0)]
    shapes = vectors.tinted([*labels, tint, dark, *labels], "#ffffff")
    halos = [shape.written.halo for shape in shapes if isinstance(shape, TextShape)]
    assert halos == ["#ffffff"] * 3 + ["#cce6ff", "#ffffff", "#ffffff"]


@pytest.mark.parametrize("em", [20.0, 4090.0])  # a quarter of `LARGEST_PX` is the largest
def test_letters_and_words_of_a_pdf_stand_on_one_line(em: float) -> None:
    text = "near P' ="
    pieces = line_of(text).pieces
    written = vectors.LabelText(
        text, pieces, (1.0,) * len(pieces), (0.0, 0.0), 0.0, em, "#000000", "#ffffff", 1.0, False
    )
    drawn = b"".join(streams_of(pdf([TextShape(written, (10.0, 60.0), em)], (100, 100), "t")))
    number = rb"(-?[\d.]+)"
    lines = re.findall(number + rb" cm\nBT\n(.*?)ET", drawn, re.DOTALL)
    moves = [re.findall(number + b" " + number + rb" Td", part) for _, part in lines]
    ups = [[float(up) for _, up in each] for each in moves]
    assert len(lines) >= 3 and any(each[0] > 0.1 for each in ups), "as matplotlib raises them"
    heights = [float(line) + each[0] for (line, _), each in zip(lines, ups, strict=True)]
    assert heights == pytest.approx([40.0 * 0.24] * len(heights), abs=max(0.01, 1e-4 * em))
    assert [up for each in ups for up in each[1:]] == [0.0], "a prime is high enough by itself"


def test_a_pdf_has_each_shape_at_its_place() -> None:
    red = (1.0, 0.0, 0.0)
    found = [
        Area([[(10.0, 20.0), (30.0, 20.0), (30.0, 60.0)]], red, 0.5),
        LineShape([(0.0, 100.0), (100.0, 0.0)], red, 1.0, 5.0),
        PixelShape(np.zeros((25, 50, 3), np.uint8), (25.0, 50.0, 50.0, 25.0)),
    ]
    content = pdf(found, (100, 100), "t")
    drawn = b"".join(streams_of(content))  # a pixel is 0.24 pt
    assert b"2.4 19.2 m\n7.2 19.2 l\n7.2 9.6 l\n" in drawn
    assert b" 1.2 w " in drawn and b"0 0 m\n24 24 l\n\nS\n" in drawn
    assert b"1 0 0 1 6 6 cm 12 0 0 -6 0 6 cm" in drawn, "exactly there: it would hide a frame"
    assert content.count(b"/Subtype /Image") == 1
    assert b"/Width 50" in content and b"/Height 25" in content, "its own pixels"


# --------------------------------------------------------------------------- what hides what

SIDE = 200
"""Of a window for actors in clip coordinates, in pixels."""


def drawn(*actors: Any, finer: int = 1, hidden: str = "none") -> list[vectors.Shape]:
    """The shapes of actors that a pane shows through the identity."""

    class Layout:
        def show(self, _width: int, _height: int) -> None:
            pass

    layout = Layout()
    with off_screen(SIDE, SIDE) as screen:
        canvas = PropGroup(screen, LIGHT, layout.show)
        screen.renderer.SetActiveCamera(identity_camera())
        canvas.add(*actors)
        screen.render_window.Render()
        found = shapes_of(screen.render_window, finer, hidden)
        canvas.remove()
    return found


def quad(z: list[float], colour: str, opacity: float = 1.0, half: float = 0.5) -> Any:
    """A square, with the depths of its corners from the lower left one against the clock."""
    corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
    points = [(x, y, depth) for (x, y), depth in zip(corners, z, strict=True)]
    return face_actor(points, [[0, 1, 2, 3]], colour, opacity)


def ends_of(found: list[vectors.Shape]) -> list[list[tuple[float, float]]]:
    strokes = [shape for shape in found if isinstance(shape, LineShape)]
    return sorted([(round(x, 2), round(y, 2)) for x, y in sorted(s.points)] for s in strokes)


def test_a_line_ends_where_a_face_hides_it_and_is_tinted_behind_a_translucent_one() -> None:
    def line(z: float, end: float | None = None) -> Any:
        points = [(-0.8, 0.0, z), (0.8, 0.0, z if end is None else end)]
        return line_actor(points, [(0, 1)], "#000000", 2.0)

    face = quad([0.0] * 4, "#ff0000")  # from pixel 50 to pixel 150
    assert ends_of(drawn(face, line(0.5))) == [
        [(20.0, 100.0), (50.0, 100.0)], [(150.0, 100.0), (180.0, 100.0)]
    ]  # fmt: skip
    assert ends_of(drawn(face, line(-0.5))) == [[(20.0, 100.0), (180.0, 100.0)]]
    # From before the face to behind it: it passes through it in the middle.
    assert ends_of(drawn(face, line(-0.5, 0.5))) == [
        [(20.0, 100.0), (100.0, 100.0)], [(150.0, 100.0), (180.0, 100.0)]
    ]  # fmt: skip
    in_front = line(0.5)
    put_in_front(in_front)
    assert ends_of(drawn(face, in_front)) == [[(20.0, 100.0), (180.0, 100.0)]]
    tinted = drawn(quad([0.0] * 4, "#ff0000", 0.25), line(0.5))
    assert sorted({shape.colour for shape in tinted if isinstance(shape, LineShape)}) == [
        (0.0, 0.0, 0.0), (0.25, 0.0, 0.0)
    ]  # fmt: skip


def test_what_is_hidden_of_a_line_is_dashed_or_grey() -> None:
    face = quad([0.0] * 4, "#ff0000")  # from pixel 50 to pixel 150
    around = [(-0.8, 0.2, 0.5), (0.1, 0.2, 0.5), (0.1, 0.8, 0.5)]
    ground = line_actor([(-0.8, 0.0, 0.5), (0.8, 0.0, 0.5)], [(0, 1)], "#9e9e9e", 2.0)
    ground.is_drawing = True
    actors = [face, line_actor(around, [(0, 1, 2)], "#0000ff", 4.0), ground]
    none = [shape for shape in drawn(*actors) if isinstance(shape, LineShape)]
    assert {(shape.width, shape.dash) for shape in none} == {(4.0, None), (2.0, None)}
    mm = 300 / 25.4
    grey = [s for s in drawn(*actors, hidden="grey") if isinstance(s, LineShape)]
    assert len(grey) == len(none) + 1
    assert (grey[0].colour, grey[0].width, grey[0].dash) == ((0.6,) * 3, 0.13 * mm, None)
    first, *others = [s for s in drawn(*actors, hidden="dashed") if isinstance(s, LineShape)]
    # One chain round the corner, before what is seen, in the narrow line of its group of ISO 128.
    assert np.allclose(first.points, [(50, 80), (110, 80), (110, 50)], atol=0.01)
    assert first.width == pytest.approx(0.18 * mm) and first.colour == (0.0, 0.0, 1.0)
    assert first.dash == pytest.approx((12 * 0.18 * mm, 3 * 0.18 * mm))
    assert {round(s.width / mm, 2) for s in others} == {0.35, 0.18}
    assert not any(s.dash for s in others)
    text = svg([first], (100, 100), "t").decode()
    assert 'stroke-dasharray="25.51 6.38"' in text
    assert re.search(rb"\[ ?6.1\d* 1.5\d* ?\] 0 d", b"".join(streams_of(pdf([first], (9, 9), "t"))))


def colour_at(found: list[vectors.Shape], x: float, y: float) -> tuple[float, float, float]:
    """The colour of a point: that of the last shape that holds it."""
    colour = (1.0, 1.0, 1.0)
    for shape in found:
        for ring in shape.rings if isinstance(shape, Area) else ():
            polygon = QPolygonF([QPointF(*corner) for corner in ring])
            if polygon.containsPoint(QPointF(x, y), Qt.FillRule.OddEvenFill):
                colour = shape.colour  # type: ignore[union-attr]
    return colour


@pytest.mark.parametrize("most_splits", [200, -100])
@pytest.mark.parametrize("seed", range(4))
def test_everywhere_the_nearest_face_is_seen(
    seed: int, most_splits: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where faces pass through each other, split or not, and where they lie in a ring."""
    monkeypatch.setattr(hidden, "MOST_SPLITS", most_splits)
    chance = random.Random(seed)
    planes, actors = [], []
    for number in range(7):
        a, b, c = (chance.uniform(-0.4, 0.4) for _ in range(3))
        half = chance.uniform(0.4, 0.9)
        corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
        level = (number + 1) * 30
        actors.append(quad([a * x + b * y + c for x, y in corners], f"#{level:02x}0000", half=half))
        planes.append((half, a, b, c, level / 255.0))
    found = drawn(*actors)
    for _ in range(200):
        x, y = chance.uniform(-1.0, 1.0), chance.uniform(-1.0, 1.0)
        here = sorted(
            (a * x + b * y + c, red)
            for half, a, b, c, red in planes
            if max(abs(x), abs(y)) < half - 0.01
        )
        near_a_border = any(abs(max(abs(x), abs(y)) - plane[0]) < 0.02 for plane in planes)
        if near_a_border or (len(here) > 1 and here[1][0] - here[0][0] < 0.01):
            continue
        red = colour_at(found, (x + 1.0) / 2.0 * SIDE, (1.0 - y) / 2.0 * SIDE)[0]
        assert red == pytest.approx(here[0][1] if here else 1.0, abs=0.003), (x, y)


def soup(count: int) -> list[ScreenCell]:
    """Random triangles on a screen of 200 pixels, most of which cross many others."""
    corners = np.random.default_rng(1).random((count, 3, 3)) * [200.0, 200.0, 1.0]
    return [
        ScreenCell(each, (0.0, 0.0, number / count), 1.0, (0, number))
        for number, each in enumerate(corners)
    ]


def test_faces_that_cross_many_others_are_not_split(monkeypatch: pytest.MonkeyPatch) -> None:
    compared = list[tuple[ScreenCell, ScreenCell]]()
    common = hidden.common

    def counted(one: ScreenCell, other: ScreenCell) -> Points:
        compared.append((one, other))
        return common(one, other)

    monkeypatch.setattr(hidden, "common", counted)
    count = 80
    faces = hidden.in_order(soup(count))
    assert len(faces) <= count
    found = list(hidden.visible(faces))
    assert 10 < len(found) <= count
    assert len(compared) < 2 * count**2, "each pair once for the order and twice for what is seen"


@pytest.mark.parametrize("limit", ["MOST_CROSSINGS", "MOST_CUTS"])
def test_too_many_crossings_are_refused(limit: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hidden, limit, 10)
    with pytest.raises(Refusal, match="cross each other in too many places"):
        list(hidden.visible(hidden.in_order(soup(80))))


def test_a_line_that_leaves_the_frame_and_comes_back_is_two() -> None:
    points = [(0.0, 0.5, 0.0), (1.5, 0.5, 0.0), (1.5, -0.5, 0.0), (0.0, -0.5, 0.0)]
    line = line_actor(points, [(0, 1, 2, 3)], "#000000", 2.0)
    assert ends_of(drawn(line)) == [
        [(100.0, 50.0), (200.0, 50.0)], [(100.0, 150.0), (200.0, 150.0)]
    ]  # fmt: skip


def test_neighbours_in_a_plane_become_one_face() -> None:
    points = [(x / 4.0 - 0.5, y / 4.0 - 0.5, 0.0) for y in range(3) for x in range(3)]
    triangles = []
    for corner in (0, 1, 3, 4):
        triangles += [[corner, corner + 1, corner + 4], [corner, corner + 4, corner + 3]]
    background, *found = drawn(face_actor(points, triangles, "#00ff00"))
    assert isinstance(background, Area)
    (face,) = found
    assert isinstance(face, Area)
    ((*corners,),) = face.rings
    assert sorted(corners) == [(50.0, 100.0), (50.0, 150.0), (100.0, 100.0), (100.0, 150.0)]


def test_shapes_of_a_pane_are_cancelled_on_the_way(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.drawings.figure._REPORT_EVERY_S", 0.0)
    scene, told = load("cube"), list[float]()

    def go_on(fraction: float) -> bool:
        told.append(fraction)
        return len(told) < 5

    with pytest.raises(Cancelled):
        figure_of(scene, scene.start, ["image"], (100, 100)).shapes(go_on)
    assert len(told) == 5 and sorted(told) == told and 0.0 < told[-1] < 1.0


def test_a_pdf_is_cancelled_while_matplotlib_draws_it(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("app.drawings.figure._REPORT_EVERY_S", 0.0)
    monkeypatch.setattr("app.drawings.pdf._WATCHED", 2)
    areas = [Area([[(0.0, 0.0), (9.0, 0.0), (9.0, float(k))]], (0, 0, 0), 1.0) for k in range(1, 9)]
    calls: list[int] = []
    content = pdf(areas, (10, 10), "t", watch=lambda: calls.append(len(calls)))
    assert content == pdf(areas, (10, 10), "t"), "nothing of it is in the file"
    assert len(calls) == 8 + 4, "for each shape, and then for every second"

    told = list[float]()

    def go_on(fraction: float) -> bool:
        told.append(fraction)
        return len(told) < ends_at

    scene, ends_at = load("cube"), 10**6
    figure = figure_of(scene, scene.start, panes=["image"], size=(64, 64))
    figure.save(tmp_path / "a.pdf", go_on)
    assert sorted(told) == told and told[0] == 0.0 and 0.5 < told[-1] < 1.0
    ends_at = len(told)
    told.clear()
    with pytest.raises(Cancelled):
        figure.save(tmp_path / "b.pdf", go_on)
    assert not (tmp_path / "b.pdf").exists()


def test_too_many_faces_are_refused_with_the_file_to_write_instead(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(vectors, "MOST_CELLS", 10)
    scene = load("letter-f")
    with pytest.raises(Refusal) as refused:
        figure_of(scene, scene.start, panes=["image"]).save("no folder/my.figure.svg")
    assert str(refused.value).endswith("without pixels is 10: write my.figure.png.")
