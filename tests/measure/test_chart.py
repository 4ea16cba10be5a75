"""Charts of measurements as data and as pictures, and names that do not overlap."""

import io
import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import pyvista as pv
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image
from PySide6.QtCore import QSizeF
from PySide6.QtGui import QColor, QImage, QPainter

import app.measure.run
from app.document.lengths import parse_length
from app.drawings.curve_names import beside
from app.drawings.style import LIGHT, PALETTES
from app.measure import chart, measuring, results
from app.measure.meaning import USUAL, boldest, meaning
from app.measure.measuring import TRADES
from app.measure.results import (
    COLUMNS,
    JUDGED,
    WORDS,
    ChartPoint,
    Sweep,
    Trade,
    named,
    table,
    to_csv,
)
from app.measure.sweeps import SWEEPS
from app.model.projection import Projection
from app.model.refusal import MEASURE
from app.scenes.phenomena.words import Diagram, Spot
from tests.support.commands import refused, run_here
from tests.support.pdf import content_of
from tests.support.results import RESULTS, SWEEP, TRADE, choice, curve, sweep
from widgets.parts.chart_picture import Paper, picture
from widgets.parts.diagram_painter import DiagramPainter
from widgets.parts.typeset import words_font


def spots(diagram: Diagram) -> dict[str, Spot]:
    return {spot.key or spot.name: spot for spot in diagram.spots}


# -- trades


def test_every_trade_and_sweep_has_its_texts() -> None:
    assert set(chart.TITLES) == {*TRADES, *SWEEPS}
    for name in TRADES:
        if name not in ("depth", "cracks"):
            (diagram,) = chart.diagrams(replace(TRADE, name=name))
            assert diagram.title == chart.TITLES[name] and diagram.x_label and diagram.y_label
            assert diagram.x_log and diagram.y_log
        (diagram,) = chart.diagrams(replace(TRADE, name=name, cost_unit="B"))
        assert "bytes" in diagram.x_label and not diagram.x_log and diagram.y_log
    for name in SWEEPS:
        (diagram, *_) = chart.diagrams(replace(SWEEP, parameter=name))
        assert diagram.title == chart.TITLES[name] and diagram.x_log and diagram.y_log


def test_the_boldest_choice_saves_most_time_before_bytes() -> None:
    def bold(*choices: ChartPoint) -> tuple[str, str] | None:
        best = boldest(Trade("arithmetic", "ns", "px", choices, 1))
        return best and (best[0], best[1].name)

    usual = replace(choice(USUAL["arithmetic"], 10.0, 1e-3), bytes=12.0)
    quick, quickest = choice("quick", 4.0, 0.5), choice("quickest", 2.0, 5.0)
    small = replace(choice("small", None, 2.0), bytes=3.0)
    exact = replace(choice("exact", 90.0, 1e-9), bytes=24.0)
    assert bold(usual, quick, quickest, small, exact) == ("time", "quickest")
    assert bold(usual, small, exact) == ("bytes", "small")
    assert bold(usual, exact) == ("time", "exact"), "nothing is saved"
    pieces = [
        replace(choice(f"{count}", cost, 1.0 / count), bytes=8.0 * count)
        for count, cost in ((1, 2.02), (2, 2.0), (64, 2.05))
    ]
    assert bold(usual, *pieces) == ("time", "1"), "of equal times the smallest"
    same = [
        replace(choice(name, 2.0, error), bytes=3.0) for name, error in (("a", 0.1), ("b", 4.0))
    ]
    assert bold(usual, *same) == ("time", "b"), "of equal costs the least exact"
    assert bold(usual, choice("equal", 9.8, 1e-4)) == ("time", "equal")
    assert bold(exact) is None and bold(usual) is None


def test_a_choice_is_at_its_cost_and_error() -> None:
    """A line joins the choices that no other one beats; 0 and infinity are at the edges."""
    (diagram,) = chart.diagrams(TRADE)
    found = spots(diagram)
    assert set(found) == {"fast", "bad", "good", "right", "endless"}
    assert (found["bad"].x, found["bad"].y) == (5.0, 2.0)
    assert all(diagram.left < spot.x < diagram.right for spot in found.values())
    assert all(diagram.bottom < spot.y < diagram.top for spot in found.values())
    assert {name for name, spot in found.items() if spot.faded} == {"bad", "endless"}
    (line,) = diagram.curves
    assert line.points[:, 0].tolist() == [1.0, 10.0, 100.0]
    assert found["right"].name == "right (0)" and found["endless"].name == "endless (∞)"
    assert found["right"].y < 1e-6 and found["endless"].y > 2.0


def test_the_present_choice_is_marked() -> None:
    (diagram,) = chart.diagrams(TRADE, {"rung": "good", "detail": "1"})
    assert [spot.key for spot in diagram.spots if spot.marked] == ["good"]
    assert spots(diagram)["good"].name == "good (now)"
    (diagram,) = chart.diagrams(TRADE, {"detail": "1"})
    assert not any(spot.marked for spot in diagram.spots)
    useless = replace(TRADE, choices=tuple(replace(c, use={}) for c in TRADE.choices))
    (diagram,) = chart.diagrams(useless, {"rung": "good"})
    assert not any(spot.marked for spot in diagram.spots)


def test_of_several_choices_in_use_the_one_that_says_most_is_marked() -> None:
    general, special, other = TRADE.choices[:3]
    special = replace(special, use={**general.use, "scene": "cube"})
    trade = replace(TRADE, choices=(general, special, other))
    (diagram,) = chart.diagrams(trade, {**general.use, "scene": "cube"})
    assert [spot.key for spot in diagram.spots if spot.marked] == [special.name]
    (diagram,) = chart.diagrams(trade, {**general.use, "scene": "posts"})
    assert [spot.key for spot in diagram.spots if spot.marked] == [general.name]


def test_choices_at_one_place_share_a_name_and_keep_their_keys() -> None:
    alike = Trade(
        "depth", "B", "world units",
        (
            choice("fixed8, opengl", 1.0, 0.5), choice("fixed8, reversed", 1.0, 0.5),
            choice("fixed8, logarithmic", 1.0, 0.25),
        ),
        1,
    )  # fmt: skip
    (diagram,) = chart.diagrams(alike)
    names = [spot.name for spot in diagram.spots]
    assert sorted(names) == ["", "fixed8, logarithmic", "fixed8, opengl / reversed"]
    assert [s.key for s in diagram.spots] != [] and len(spots(diagram)) == 3


def test_another_machine_is_drawn_thinner_with_its_name_inside_the_chart() -> None:
    slower = replace(
        TRADE, choices=tuple(replace(c, cost=c.cost and 1000.0 * c.cost) for c in TRADE.choices)
    )
    (diagram,) = chart.diagrams(TRADE, {}, slower, "Box 8, yesterday")
    *over, line = diagram.curves
    assert [c.label for c in over] == ["", "Box 8, yesterday"]
    assert all(c.width < line.width for c in over)
    assert over[0].points[:, 0].tolist() == [1e3, 1e4, 1e5] and diagram.right > 1e5
    assert len(over[1].points) == 5, "nothing of it is dropped"


@pytest.mark.usefixtures("qapp")
def test_a_trade_without_numbers_has_words_and_no_chart() -> None:
    absent = replace(TRADE, choices=(choice("", None, None, "no vertex"),))
    assert chart.diagrams(absent) == ()
    assert chart.diagrams(replace(SWEEP, values=(), curves={})) == ()
    assert "(cancelled)" in chart.title(replace(TRADE, complete=False))
    empty = picture(replace(RESULTS, trades=(absent,), sweeps=()), "a.png")
    assert empty.startswith(b"\x89PNG")


# -- sweeps


def test_a_sweep_breaks_where_there_is_no_answer_and_says_why() -> None:
    (diagram,) = chart.diagrams(SWEEP)
    by_label = {c.label: c for c in diagram.curves if c.label}
    assert set(by_label) == {"float32", "VTK"}
    assert np.isnan(by_label["float32"].points[:2, 1]).all()
    assert by_label["float32"].points[2:].tolist() == [[1.0, 1e-3], [10.0, 1e-4]]
    (bar,) = (c for c in diagram.curves if not c.label)
    assert bar.points[:, 0].tolist() == [0.01, 0.1] and bar.colour == by_label["float32"].colour
    found = spots(diagram)
    nan, clamped = found["float32: returns NaN"], found["VTK: clamps"]
    assert nan.broken and nan.x == 0.1, "beside what still works"
    assert clamped.broken and (clamped.x, clamped.y) == (10.0, 1e-2)


def test_angles_on_both_sides_of_90_degrees_have_a_chart_each() -> None:
    values = (1e-6, 1.0, 90.0, 179.0, 180.0 - 1e-9)
    errors = (1e-3,) * 5
    low, high = chart.diagrams(sweep("fov", values, {"float32": curve(errors, ("",) * 5)}))
    assert (low.left, low.right) == (1e-6, 90.0) and low.curves[0].points[1, 0] == 1.0
    assert high.left == 90.0 and high.right == pytest.approx(1e-9, rel=1e-4)
    assert high.curves[0].points[:, 0] == pytest.approx([90.0, 1.0, 1e-9], rel=1e-4)


def test_a_huge_error_leaves_the_chart_and_not_the_others() -> None:
    wild = sweep("aspect", (1.0, 2.0), {"a": curve((1e200, 1e-9), ("", ""))})
    (diagram,) = chart.diagrams(wild)
    assert diagram.top < 1e60 and diagram.bottom < 1e-9


# -- tables


def test_a_table_has_a_note_for_each_missing_number() -> None:
    heads, *rows = table(replace(TRADE, complete=False))
    assert heads == ["", "ns", "p95", "bytes", "px", "predicted", JUDGED]
    assert rows[1] == ["bad", "5", "5", "-", "2", "-", ""]
    assert rows[-1] == ["absent", "-", "-", "-", "-", "-", "not installed"]
    waiting = Trade("arithmetic", "ns", "px", (choice("late", None, 1.0),), 0, complete=False)
    assert table(waiting)[1][-1] == "cancelled"
    assert table(replace(waiting, complete=True))[1][-1] == ""
    assert table(SWEEP)[1] == ["0.01", "-", "1e-09", "float32 returns NaN"]


def test_a_sweep_s_values_have_four_digits_or_all(monkeypatch: pytest.MonkeyPatch) -> None:
    values = (179.0, 179.999999999995, 180.0 - 1e-12)
    head, *rows = table(Sweep("fov", "°", values, {"a": curve((1e-9,) * 3, ("",) * 3)}))
    assert head == ["fov, °", "a", JUDGED]
    assert [row[0] for row in rows] == ["179", "179.999999999995", "179.999999999999"]
    with monkeypatch.context() as patch:
        patch.setattr(results, "of_measure", {"fov": "kut"}.__getitem__)
        assert named(head[0]) == "kut, °"
    values = (0.0316227766017, 1234567.0, 2.5)
    swept = sweep("near", values, {"a": curve((1 / 3,) * 3, ("",) * 3)})
    assert [row[:2] for row in table(swept)[1:]] == [
        ["0.03162", "0.33"], ["1234567", "0.33"], ["2.5", "0.33"],
    ]  # fmt: skip
    whole = table(swept, all_digits=True)[1:]  # measured errors keep two digits
    assert [row[:2] for row in whole] == [[repr(value), "0.33"] for value in values]


@pytest.mark.parametrize("parameter", ["near", "far"])
def test_the_table_names_the_other_parameter_that_a_sweep_changes(parameter: str) -> None:
    said = table(sweep(parameter, (1.0,), {"a": curve((1e-9,), ("",))}))[0][-1]
    judged, told = said.split(", ")
    assert judged == MEASURE["gap"] and told in WORDS
    low, high = SWEEPS[parameter].low, SWEEPS[parameter].high
    lenses = [SWEEPS[parameter].set(Projection(), value)[0].lens for value in (low, 1.0, high)]
    assert {lens.near * 4.0 for lens in lenses} & {lens.far for lens in lenses}, told
    assert told == {"near": "far is at least 4 near", "far": "near is at most far / 4"}[parameter]


def test_table_headings_are_words_with_units() -> None:
    """A file's and a spreadsheet's columns keep their plain names."""
    values = dict.fromkeys(COLUMNS, 0.5) | {"triangles": 2.0}
    trade = replace(TRADE, choices=(replace(TRADE.choices[0], values=values),))
    assert table(trade)[0][6:-1] == [*COLUMNS.values(), "triangles"]
    assert not any("_" in head for head in table(trade)[0])
    assert set(COLUMNS.values()) <= set(WORDS)
    assert to_csv(trade).splitlines()[0].endswith(f"{','.join(values)},note")


@pytest.mark.parametrize(
    ("number", "in_table", "in_sentence"),
    [
        (872.4, "872", "872"),
        (99.6, "99.6", "100"),
        (999.6, "1000", "1000"),
        (1234567.0, "1234567", "1234567"),
        (8.72, "8.72", "8.7"),
        (1e-9, "1e-09", "1e-09"),
        (1e20, "1e+20", "1e+20"),
        (math.inf, "inf", "inf"),
    ],
)
def test_numbers_to_read_have_no_exponent_for_thousands(
    number: float, in_table: str, in_sentence: str
) -> None:
    trade = replace(TRADE, choices=(choice("only", number, 1.0), choice("error", 1.0, number)))
    assert [row[1] for row in table(trade)[1:]] == [in_table, "1"]
    alone = replace(trade, choices=trade.choices[:1])
    assert f"No choice is cheaper ({in_sentence} ns)" in meaning(alone)
    (diagram,) = chart.diagrams(replace(trade, choices=trade.choices[1:]))
    assert spots(diagram)["error"].tip == f"error: 1 ns, {in_table} px"
    swept = sweep("near", (1.0,), {"a": curve((number,), ("",))})
    assert table(swept)[1][1] == in_sentence


# -- names

NONE = np.empty((0, 4))
FRAME = np.array([0.0, 0.0, 400.0, 300.0])


def placed(given_points: list[tuple[float, float, float]]) -> tuple[np.ndarray, np.ndarray]:
    """The points, and the sizes of their names."""
    x, y, widths = np.array(given_points).T
    return np.column_stack([x, y]), np.column_stack([widths, np.full(len(x), 12.0)])


@given(
    st.lists(
        st.tuples(st.floats(10, 390), st.floats(10, 290), st.floats(0, 90)), min_size=1, max_size=14
    )
)
def test_names_never_hide_each_other_nor_dots_and_stay_inside(
    given_points: list[tuple[float, float, float]],
) -> None:
    points, sizes = placed(given_points)
    places = beside(points, sizes, FRAME, np.empty((0, 2)), np.full(len(points), 5.0), NONE)
    boxes = [box for box in places if box is not None]
    for i, box in enumerate(boxes):
        assert (box[:2] >= 0.0).all() and box[2] <= 400.0 and box[3] <= 300.0
        for other in boxes[:i]:
            apart = (box[2:] <= other[:2] + 1e-9) | (other[2:] <= box[:2] + 1e-9)
            assert apart.any()
        inside = ((points > box[:2]) & (points < box[2:])).all(axis=1)
        assert not inside.any()


@given(
    st.lists(
        st.tuples(st.floats(10, 390), st.floats(10, 290), st.floats(5, 90)), min_size=2, max_size=14
    ),
    st.floats(0, 300),
    st.floats(0, 300),
)
def test_names_and_their_lines_cross_no_curve_no_dot_and_no_earlier_name(
    given_points: list[tuple[float, float, float]], left: float, right: float
) -> None:
    """If the dots are 30 px apart; in a crowd a name is left out rather than misread."""
    alone: list[tuple[float, float, float]] = []
    for point in given_points:
        if all(math.dist(point[:2], other[:2]) >= 30.0 for other in alone):
            alone.append(point)
    points, sizes = placed(alone)
    along = np.column_stack([np.linspace(0.0, 400.0, 400), np.linspace(left, right, 400)])
    places = beside(points, sizes, FRAME, along, np.full(len(points), 5.0), NONE)
    for i, box in enumerate(places):
        if box is None:
            continue
        assert not ((along > box[:2]) & (along < box[2:])).all(axis=1).any()
        end = np.clip(points[i], box[:2], box[2:])
        line = points[i] + np.linspace(0.1, 0.9, 8)[:, None] * (end - points[i])
        for other in places[:i]:
            if other is not None:
                assert not ((line > other[:2]) & (line < other[2:])).all(axis=1).any()
        others = points[np.abs(points - points[i]).max(axis=1) > 10.0]
        assert not (np.abs(line[:, None] - others) < 4.0).all(axis=-1).any()


def test_in_a_crowd_every_dot_has_its_name() -> None:
    points, sizes = placed([(10.0, 10.0, 57.0), (38.0, 14.0, 57.0), (11.0, 10.0, 57.0)])
    along = np.column_stack([np.linspace(0.0, 400.0, 400), np.zeros(400)])
    places = beside(points, sizes, FRAME, along, np.full(3, 5.0), NONE)
    assert all(box is not None for box in places)


def test_a_name_stands_right_beside_a_lonely_point() -> None:
    one, size = np.array([[200.0, 150.0]]), np.array([[60.0, 12.0]])
    (box,) = beside(one, size, FRAME, np.empty((0, 2)), np.array([5.0]), NONE)
    assert box is not None and box[2:] - box[:2] == pytest.approx(size[0])
    assert 0.0 < np.linalg.norm(one[0] - np.clip(one[0], box[:2], box[2:])) < 12.0
    line = np.column_stack([np.linspace(200.0, 400.0, 100), np.full(100, 150.0)])
    (box,) = beside(one, size, FRAME, line, np.array([5.0]), NONE)
    assert box is not None and not (box[1] < 150.0 < box[3] and box[0] >= 200.0)
    name = np.array([[210.0, 140.0, 300.0, 160.0]])
    (box,) = beside(one, size, FRAME, np.empty((0, 2)), np.array([5.0]), name)
    assert box is not None and (box[2] <= 210.0 or box[3] <= 140.0 or box[1] >= 160.0)
    full = np.array([0.0, 0.0, 30.0, 300.0])
    assert beside(np.array([[15.0, 150.0]]), size, full, line, np.array([5.0]), NONE) == [None]


# -- pictures


@pytest.mark.usefixtures("qapp")
def test_a_picture_shows_dots_where_they_belong_and_in_its_own_colours() -> None:
    png = picture(replace(RESULTS, sweeps=()), "a.PNG", {"rung": "good"})
    with Image.open(io.BytesIO(png)) as image:
        assert image.format == "PNG" and image.size == (800, 490)
        pixels = np.asarray(image.convert("RGB")).astype(int)

    def near(red: int, green: int, blue: int) -> int:
        return int((np.abs(pixels - (red, green, blue)).sum(axis=2) < 40).sum())

    assert near(0, 0x72, 0xB2) > 300, "the frontier"
    assert near(0xD5, 0x5E, 0) > 20, "the mark of the present choice"
    assert len(png) < 100_000


@pytest.mark.usefixtures("qapp")
def test_a_pdf_holds_vectors_and_is_the_same_every_time() -> None:
    small = replace(RESULTS, trades=())
    one, other = (picture(small, "a.pdf", other=small) for _ in range(2))
    assert one.startswith(b"%PDF") and one == other
    assert b"/Subtype /Image" not in one


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize(("width", "letters"), [("84mm", 8.0), ("174mm", 7.0), ("3.25in", 9.0)])
def test_a_chart_for_print_has_its_width_its_letters_and_embedded_fonts(
    width: str, letters: float
) -> None:
    """As the files say: a PDF's page and text matrices, an SVG's text, a PNG's dots per inch."""
    paper = Paper(width=parse_length(width), text_pt=letters, palette="print")
    wide_mm = parse_length(width) / 300.0 * 25.4
    small = replace(RESULTS, trades=())
    pdf, svg, png = (picture(small, f"a.{kind}", paper=paper) for kind in ("pdf", "svg", "png"))
    box = re.search(rb"/MediaBox \[0 \S+ ([\d.]+) \S+ *\]", pdf)
    assert box is not None and float(box[1]) / 72.0 * 25.4 == pytest.approx(wide_mm, abs=0.01)
    fonts = set(re.findall(rb"/Type /Font\s/Subtype /(\w+)", pdf))
    assert fonts == {b"Type0", b"CIDFontType2"}, "TrueType; none of Type 3"
    assert pdf.count(b"/FontFile2") == pdf.count(b"/BaseFont") / 2
    # The page's matrix and that of the painter scale the letters.
    (size,), outer = set(re.findall(rb"/F\d+ (\S+) Tf", content_of(pdf))), 72.0 / 1200.0
    scales = set(re.findall(rb"\n(\S+) 0 0 \1 \S+ \S+ cm\n", content_of(pdf)))
    assert {round(float(size) * float(scale) * outer, 3) for scale in scales} == {letters}
    text = svg.decode()
    root = re.search(r'width="([\d.]+)mm".*?viewBox="0 0 ([\d.]+)', text, re.DOTALL)
    assert root is not None and float(root[1]) == pytest.approx(wide_mm, abs=0.05)
    (scale,) = set(re.findall(r'transform="matrix\(([\d.]+),0,0,\1,', text))
    (size,) = set(re.findall(r'font-size="([\d.]+)"', text))
    px = float(root[1]) / float(root[2])
    assert float(size) * float(scale) * px / 25.4 * 72.0 == pytest.approx(letters, abs=0.1)
    with Image.open(io.BytesIO(png)) as image:
        assert image.size[0] == pytest.approx(parse_length(width), abs=1.0)
        assert image.info["dpi"] == pytest.approx((300.0, 300.0), abs=0.1)
        told = image.info["Description"]
    for part in ("2026-11-21", "Box 7", "softpipe", "letter-f"):
        assert part in told and part in text.partition("<title>")[2].partition("</title>")[0]
        assert part.encode("utf-16-be") in pdf.partition(b"/Title")[2]


@pytest.mark.usefixtures("qapp")
def test_a_chart_for_print_says_a_remark_in_its_properties_and_cuts_no_title() -> None:
    trade = RESULTS.trades[0]
    busy = replace(trade.choices[0], cost=1.0, cost_p95=100.0)
    small = replace(RESULTS, trades=[replace(trade, choices=[busy, *trade.choices[1:]])], sweeps=[])
    paper = Paper(width=parse_length("84mm"), text_pt=8.0)
    svg = picture(small, "a.svg", paper=paper).decode()
    head, _, drawn = svg.partition("</title>")
    assert "busy" in head and "busy" not in drawn and "…" not in drawn
    assert chart.title(trade) in drawn


@pytest.mark.usefixtures("qapp")
def test_curves_are_told_apart_without_their_colours() -> None:
    names = [f"way {number}" for number in range(len(chart.DASHES))]
    curves = {name: curve((1e-3, 1e-4), ("", "")) for name in names}
    (diagram,) = chart.diagrams(sweep("near", (1.0, 2.0), curves))
    assert len({each.dash for each in diagram.curves}) == len(names)
    alone = replace(diagram, curves=tuple(replace(c, label="") for c in diagram.curves[1:2]))
    image = QImage(400, 300, QImage.Format.Format_RGB32)
    image.fill("white")
    painter = QPainter(image)
    DiagramPainter(alone, QSizeF(400.0, 300.0), words_font(), LIGHT).paint(painter)
    painter.end()
    blue = [QColor(image.pixel(x, y)).blue() for y in range(300) for x in range(400)]
    rows = np.reshape(blue, (300, 400))
    assert (np.diff((rows[60:240, 60:380].min(axis=0) > 200).astype(int)) == 1).sum() > 8, "gaps"


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("letters", [7.0, 8.0])
def test_a_chart_for_print_has_every_name_in_the_diagram_or_in_its_key(letters: float) -> None:
    """Points in a crowd have numbers, and curves that lie close together pieces of them."""
    crowd = [choice(f"one of many ways {k}", 4.0, 10.0 ** (-k / 8.0)) for k in range(12)]
    trade = replace(TRADE, choices=(*TRADE.choices[:3], *crowd))
    lines = {f"way {k}": curve((1e-3 * 1.1**k, 1e-3 * 1.1**k), ("", "")) for k in range(5)}
    paper = Paper(width=parse_length("84mm"), text_pt=letters, palette="print")
    near = sweep("near", (1.0, 2.0), lines)
    for trades, sweeps in (((trade,), ()), ((), (near,))):
        one = replace(RESULTS, trades=trades, sweeps=sweeps)
        svg = picture(one, "a.svg", paper=paper).decode()
        drawn = " / ".join(re.findall(r"<text[^>]*>([^<]*)", svg)).split(" / ")
        names = [each.name for each in crowd] if trades else lines
        assert {*names} <= {*map(str.strip, drawn)}


@pytest.mark.usefixtures("qapp")
def test_no_name_of_a_chart_for_print_touches_the_frame_or_is_nearer_to_another_curve() -> None:
    ways = {"float32": curve((1e-3, 1e-3), ("", "")), "exact": curve((1e-9, 1.2e-9), ("", "")),
            "float64": curve((1.1e-9, 1.1e-9), ("", ""))}  # fmt: skip
    (diagram,) = chart.diagrams(sweep("near", (1.0, 2.0), ways))
    painter = DiagramPainter(diagram, QSizeF(400.0, 250.0), words_font(), LIGHT, one_size=True)
    left, top, right, bottom = painter.names["float32"].tolist()
    frame = painter.frame
    assert min(left - frame.left(), top - frame.top()) >= 2.0
    assert min(frame.right() - right, frame.bottom() - bottom) >= 2.0
    assert "float32" in painter.names and painter.keyed > 0.0
    assert len({"exact", "float64"} & painter.names.keys()) < 2, "they lie on each other"


@pytest.mark.usefixtures("qapp")
@pytest.mark.parametrize("palette", ["print", "dark"])
def test_a_chart_in_vectors_has_a_ground_as_other_figures_have(palette: str) -> None:
    paper = Paper(width=parse_length("84mm"), palette=palette)
    svg = picture(replace(RESULTS, trades=()), "a.svg", paper=paper).decode()
    colour = PALETTES[palette].background
    ground = re.search(rf'fill="{colour}"[^<]*<rect x="0" y="0" width=', svg, re.DOTALL)
    assert ground is not None and ground.start() < svg.index("<text")


def test_a_chart_names_machine_versions_scene_camera_and_date() -> None:
    assert chart.where(RESULTS) == (
        "2026-11-21T08:46:06+00:00 · Box 7, cores: 2, softpipe · frustum-lab 1"
    )
    assert chart.seen(RESULTS) == (
        "letter-f; eye (6, 5, 9), target (0, 2.25, 0), perspective, field of view 45°"
    )
    assert chart.machine(RESULTS) == "Box 7, softpipe, 2026-11-21T08:46:06+00:00"
    mesh = replace(RESULTS, document={"scene": "meshes/cow.obj", "camera": 5})
    assert chart.seen(mesh) == "cow.obj; eye (), target (), "


# -- the command


@pytest.mark.usefixtures("qapp")
def test_the_command_draws_a_chart(tmp_path: Path) -> None:
    out = tmp_path / "depth.pdf"
    done = run_here("measure", "--trade=depth", "--quick", "--chart", out)
    assert done.returncode == 0 and done.stderr == ""
    assert out.read_bytes().startswith(b"%PDF")
    assert refused("measure", "--chart=a.gif") == (
        "--chart = 'a.gif': must end in .png, .svg or .pdf.\n"
    )
    assert "no folder /nowhere" in refused("measure", "--chart=/nowhere/a.png")


def test_the_command_measures_the_mesh_in_a_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(measuring, "QUICK_SECONDS", 0.0)  # how fast it is does not matter here
    monkeypatch.setattr(app.measure.run, "LEAST_ROUNDS", 1)
    mesh = tmp_path / "ball.ply"
    pv.Sphere(theta_resolution=30, phi_resolution=30).save(mesh)
    arguments = ("measure", "--trade=detail", "--quick", "--scene=similar-triangles")
    assert "too few triangles" in run_here(*arguments).stdout
    done = run_here(*arguments, "--set", f"mesh={mesh}")
    assert done.returncode == 0 and "too few triangles" not in done.stdout and "50 %" in done.stdout
