"""Diagrams show every point of the data at its place, and nothing else."""

import math
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor
from pytestqt.qtbot import QtBot

from app.drawings.style import DARK, LIGHT
from app.scenes.phenomena.words import Curve, Diagram, Spot
from tests.support.window import rgb_of
from widgets.parts.diagram import DiagramView
from widgets.parts.diagram_axis import decade_ticks, round_ticks, segments
from widgets.parts.messages import figure_text

MAGENTA, GREEN = "#ff00ff", "#00ff00"
LINE = Curve(np.array([(0.0, 0.0), (10.0, 5.0)]), MAGENTA, width=2.0)
PLAIN = Diagram("A line", (LINE,), 0.0, 10.0, 0.0, 10.0, "across", "up")


def sized(width: int, height: int, diagram: Diagram) -> DiagramView:
    made = DiagramView()
    made.resize(width, height)
    made.show_diagram(diagram)
    return made


@pytest.fixture
def view(qtbot: QtBot) -> DiagramView:
    made = DiagramView()
    qtbot.addWidget(made)
    made.resize(420, 300)
    made.show()
    qtbot.waitExposed(made)
    return made


def pixels(view: DiagramView) -> np.ndarray:
    return rgb_of(view.grab().toImage()).astype(int)


def near(view: DiagramView, place: QPointF, colour: str, within: int = 2) -> bool:
    """Whether a colour is within some pixels of a place."""
    scale = view.devicePixelRatioF()
    x, y = round(place.x() * scale), round(place.y() * scale)
    picture = pixels(view)[max(0, y - within) : y + within + 1, max(0, x - within) : x + within + 1]
    wanted = QColor(colour)
    away = np.abs(picture - (wanted.red(), wanted.green(), wanted.blue())).sum(axis=2)
    return bool((away < 120).any())


def count(view: DiagramView, colour: str) -> int:
    wanted = QColor(colour)
    away = np.abs(pixels(view) - (wanted.red(), wanted.green(), wanted.blue())).sum(axis=2)
    return int((away < 60).sum())


# -- curves


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"bottom": 10.0, "top": 0.0},
        {"left": 10.0, "right": 0.0},
        {"left": -10.0, "right": 30.0, "equal": True},
        {"left": 1e-3, "x_log": True},
        {"bottom": 1e-3, "y_log": True},
        {"title": "", "x_label": "", "y_label": ""},
    ],
)
def test_a_curve_goes_through_its_points(view: DiagramView, changes: dict[str, Any]) -> None:
    ends = np.array([(1.0, 2.0), (10.0, 2.0), (10.0, 8.0)])
    view.show_diagram(replace(PLAIN, curves=(replace(LINE, points=ends),), **changes))
    for x, y in ((1.0, 2.0), (5.0, 2.0), (10.0, 5.0), (9.99, 8.0)):
        assert near(view, view.to_px(x, y), MAGENTA), (x, y)
    for x, y in ((5.0, 5.0), (1.0, 8.0), (5.0, 8.0)):
        assert not near(view, view.to_px(x, y), MAGENTA, 1), (x, y)


def test_the_window_s_corners_are_the_frame_s() -> None:
    """With top above bottom y runs up, with bottom above top it runs down, as in an image."""
    view = sized(420, 300, PLAIN)
    assert view.to_px(0.0, 0.0) == view.frame.bottomLeft()
    assert view.to_px(10.0, 10.0) == view.frame.topRight()
    view.show_diagram(replace(PLAIN, bottom=10.0, top=0.0))
    assert view.to_px(0.0, 0.0) == view.frame.topLeft()


def test_a_power_of_ten_is_as_wide_as_another() -> None:
    view = sized(420, 300, replace(PLAIN, left=1.0, right=1e4, x_log=True))
    places = [view.to_px(x, 0.0).x() for x in (1.0, 10.0, 100.0, 1e3, 1e4)]
    assert np.diff(places) == pytest.approx(view.frame.width() / 4.0)


@pytest.mark.parametrize("size", [(420, 200), (200, 420), (800, 800)])
def test_in_a_picture_both_axes_have_one_scale(size: tuple[int, int]) -> None:
    picture = replace(PLAIN, right=1280.0, bottom=720.0, top=0.0, equal=True)
    view = sized(*size, picture)
    frame = view.frame
    assert frame.width() / frame.height() == pytest.approx(1280 / 720)
    assert QRectF(view.rect()).contains(frame)


def test_a_broken_curve_is_broken_and_a_closed_one_closed(view: DiagramView) -> None:
    square = np.array([(2.0, 2.0), (8.0, 2.0), (8.0, 8.0), (2.0, 8.0)])
    view.show_diagram(replace(PLAIN, curves=(replace(LINE, points=square),)))
    assert near(view, view.to_px(8.0, 5.0), MAGENTA)
    assert not near(view, view.to_px(2.0, 5.0), MAGENTA)
    view.show_diagram(replace(PLAIN, curves=(replace(LINE, points=square, closed=True),)))
    assert near(view, view.to_px(2.0, 5.0), MAGENTA)
    broken = np.insert(square, 2, np.nan, axis=0)
    view.show_diagram(replace(PLAIN, curves=(replace(LINE, points=broken),)))
    assert not near(view, view.to_px(8.0, 5.0), MAGENTA)
    assert near(view, view.to_px(5.0, 2.0), MAGENTA) and near(view, view.to_px(5.0, 8.0), MAGENTA)


def test_dots_are_at_their_points_and_not_between(view: DiagramView) -> None:
    view.show_diagram(replace(PLAIN, curves=(replace(LINE, dots=True),)))
    for x, y in ((0.0, 0.0), (10.0, 5.0)):
        assert near(view, view.to_px(x, y), MAGENTA)
    assert not near(view, view.to_px(5.0, 2.5), MAGENTA)


def test_points_outside_the_window_are_not_drawn(view: DiagramView) -> None:
    far = np.array([(-5.0, 20.0), (15.0, 20.0), (15.0, -5.0), (-5.0, -5.0)])
    view.show_diagram(replace(PLAIN, curves=(replace(LINE, points=far, closed=True),)))
    assert count(view, MAGENTA) == 0
    upward = replace(LINE, points=np.array([(5.0, -1e300), (5.0, 5.0)]))
    view.show_diagram(replace(PLAIN, curves=(upward,)))
    assert near(view, view.to_px(5.0, 1.0), MAGENTA)
    assert not near(view, view.to_px(5.0, 8.0), MAGENTA)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, 0.0, -1.0])
def test_no_value_of_a_curve_breaks_the_diagram(view: DiagramView, value: float) -> None:
    points = np.array([(1.0, 1.0), (value, value), (9.0, 9.0)])
    for log in (False, True):
        view.show_diagram(
            replace(PLAIN, curves=(replace(LINE, points=points),), left=0.5, bottom=0.5,
                    x_log=log, y_log=log)
        )  # fmt: skip
        assert view.grab().width() > 0
    for points in (np.empty((0, 2)), np.array([(1.0, 1.0)])):
        curve = replace(LINE, points=points, label="none", closed=True)
        view.show_diagram(replace(PLAIN, curves=(curve,)))
        assert view.grab().width() > 0


@pytest.mark.parametrize(
    "changes",
    [
        {"left": 1.0, "right": 1.0},
        {"bottom": math.nan},
        {"top": math.inf},
        {"left": 0.0, "x_log": True},
        {"left": -3.0, "x_log": True},
    ],
)
def test_an_invalid_window_shows_only_a_frame(view: DiagramView, changes: dict[str, Any]) -> None:
    view.show_diagram(replace(PLAIN, **changes))
    assert count(view, MAGENTA) == 0
    assert count(view, LIGHT.background) > 1000


def test_a_tiny_diagram_draws_without_warnings(view: DiagramView) -> None:
    view.setMinimumSize(1, 1)
    for size in ((1, 1), (40, 12), (12, 300), (150, 110)):
        view.resize(*size)
        view.show_diagram(replace(PLAIN, curves=(replace(LINE, label="a name"),)))
        assert view.grab().width() == size[0] * view.devicePixelRatioF()


@given(st.lists(st.tuples(st.floats(-1e12, 1e12), st.floats(-1e12, 1e12)), min_size=2, max_size=12))
def test_segments_are_inside_and_on_the_curve(points: list[tuple[float, float]]) -> None:
    for start, end in segments(np.array(points))[0]:
        for place in (start, end, (start + end) / 2.0):
            assert (place >= -1e-6).all() and (place <= 1.0 + 1e-6).all()
            away = min(_distance(place, np.array(a), np.array(b)) for a, b in pairwise(points))
            assert away < 1e-3


def _distance(place: np.ndarray, start: np.ndarray, end: np.ndarray) -> float:
    along = end - start
    length = float(along @ along)
    t = 0.0 if length == 0.0 else min(max(float((place - start) @ along) / length, 0.0), 1.0)
    return float(np.linalg.norm(place - start - t * along))


# -- ticks


@pytest.mark.parametrize(
    ("low", "high", "most", "expected"),
    [
        (0.0, 1.0, 6, [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]),
        (-3.0, 12.0, 4, [0.0, 5.0, 10.0]),
        (0.0, 1280.0, 5, [0.0, 500.0, 1000.0]),
        (1e-9, 9e-9, 5, [2e-9, 4e-9, 6e-9, 8e-9]),
        (99.98, 100.02, 5, [99.98, 99.99, 100.0, 100.01, 100.02]),
        (5.0, 5.0, 5, []),
    ],
)
def test_ticks_are_round(low: float, high: float, most: int, expected: list[float]) -> None:
    assert round_ticks(low, high, most) == expected


@given(st.floats(-1e6, 1e6), st.floats(1e-3, 1e6), st.integers(2, 12))
def test_there_are_never_too_many_ticks_and_enough_where_there_is_room(
    low: float, reach: float, most: int
) -> None:
    ticks = round_ticks(low, low + reach, most)
    assert len(ticks) <= most
    assert len(ticks) >= most // 3
    assert all(low - 1e-6 * reach <= tick <= low + reach * (1 + 1e-6) for tick in ticks)


@pytest.mark.parametrize(
    ("low", "high", "most", "expected"),
    [
        (1.0, 1e3, 6, [1.0, 10.0, 100.0, 1000.0]),
        (1e-12, 1e12, 9, [1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12]),
        (1.0, 8.0, 4, [1.0, 2.0, 5.0]),
        (1.0, 90.0, 9, [1.0, 2.0, 5.0, 10.0, 20.0, 50.0]),
        (3.0, 3.5, 6, [3.0, 3.1, 3.2, 3.3, 3.4, 3.5]),
    ],
)
def test_a_logarithmic_axis_has_powers_of_ten(
    low: float, high: float, most: int, expected: list[float]
) -> None:
    assert decade_ticks(low, high, most) == expected


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"), (-0.0, "0"), (0.25, "0.25"), (-12.5, "−12.5"), (1e-5, "10⁻⁵"),
        (-1e-5, "−10⁻⁵"), (-2.5e-7, "−2.5·10⁻⁷"), (1e10, "10¹⁰"), (1 / 3, "0.333333"),
        (123456.0, "123456"), (1234567.0, "1.23457·10⁶"), (math.inf, "∞"), (-math.inf, "−∞"),
        (999999.6, "10⁶"),
    ],
)  # fmt: skip
def test_numbers_are_written_for_reading_from_afar(value: float, text: str) -> None:
    assert figure_text(value) == text


def test_given_ticks_are_drawn_at_their_places_across_the_window(view: DiagramView) -> None:
    codes = np.arange(0.5, 10.0, 1.0)
    view.show_diagram(replace(PLAIN, curves=(), y_ticks=codes))
    frame, column = view.frame, pixels(view)
    middle = round(frame.center().x() * view.devicePixelRatioF())
    rows = np.abs(column[:, middle] - 255).sum(axis=1) > 60
    for code in codes:
        y = round(view.to_px(5.0, code).y() * view.devicePixelRatioF())
        assert rows[y - 1 : y + 2].any(), code
    between = round(view.to_px(5.0, 1.0).y() * view.devicePixelRatioF())
    assert not rows[between - 2 : between + 3].any()


# -- names, colours, screens


def test_the_names_of_curves_stand_beside_them_and_not_on_each_other(view: DiagramView) -> None:
    across = np.linspace(0.0, 10.0, 50)
    curves = tuple(
        Curve(np.stack([across, 2.0 * i + 0.1 * across], axis=1), "u", f"curve {i}")
        for i in range(4)
    )
    view.show_diagram(replace(PLAIN, curves=curves))
    view.grab()
    places = [place.tolist() for place in view.names.values()]
    boxes = [QRectF(QPointF(*place[:2]), QPointF(*place[2:])) for place in places]
    assert len(boxes) == 4
    for i, box in enumerate(boxes):
        assert view.frame.contains(box)
        assert not any(box.intersects(other) for other in boxes[:i])
        on_curve = view.to_px(5.0, 2.0 * i + 0.5)
        assert abs(on_curve.y() - box.center().y()) < 3.0 * box.height()
    before = dict(view.names)
    view.show_diagram(replace(PLAIN, curves=curves, title="The same, named otherwise"))
    view.grab()
    assert all((view.names[name] == place).all() for name, place in before.items())


@pytest.mark.parametrize("colour", ["ink", "n", "accent"])
@pytest.mark.parametrize("dots", [True, False])
@pytest.mark.parametrize("scale", [1.0, 3.0])
def test_a_name_adds_no_point_and_hides_none(
    view: DiagramView, colour: str, dots: bool, scale: float
) -> None:
    """A name without letters is one plain plate, beside the point and not on it."""
    view.set_style(LIGHT.enlarged(scale))
    points = np.array([(5.0, 5.0)]) if dots else np.array([(2.0, 5.0), (8.0, 5.0)])
    curve = Curve(points, colour, dots=dots)
    plain = replace(PLAIN, curves=(curve,), x_label="", y_label="", title="")
    view.show_diagram(plain)
    without = pixels(view)
    view.show_diagram(replace(plain, curves=(replace(curve, label="    "),)))
    named = pixels(view)
    left, top, right, bottom = view.names["    "]
    assert view.frame.contains(QRectF(left, top, right - left, bottom - top))
    factor = view.devicePixelRatioF()
    box = np.s_[
        math.ceil(top * factor) + 1 : int(bottom * factor) - 1,
        math.ceil(left * factor) + 1 : int(right * factor) - 1,
    ]
    assert named[box].size > 100 and np.ptp(named[box], axis=(0, 1)).max() == 0
    assert (named[box] == 255).all() == (colour == "ink")
    assert np.ptp(without[box], axis=(0, 1)).max() == 0  # nothing was there to be hidden


def test_colours_are_those_of_the_theme_by_name(view: DiagramView) -> None:
    view.show_diagram(replace(PLAIN, curves=(replace(LINE, colour="near", width=4.0),)))
    for style in (LIGHT, DARK):
        view.set_style(style)
        assert near(view, view.to_px(5.0, 2.5), style.near)
        assert count(view, style.background) > 10_000
    ordinary = count(view, DARK.near)
    view.set_style(DARK.enlarged(3.0))
    assert count(view, DARK.near) > 2 * ordinary


def test_it_repaints_only_after_a_change(view: DiagramView, qtbot: QtBot, qapp: Any) -> None:
    painted: list[int] = []
    paint = view.paintEvent

    def counted(event: Any) -> None:
        painted.append(1)
        paint(event)

    view.paintEvent = counted  # type: ignore[method-assign]
    view.show_diagram(PLAIN)
    qtbot.waitUntil(lambda: bool(painted))
    qapp.processEvents()
    assert len(painted) == 1
    view.show_diagram(PLAIN)
    qapp.processEvents()
    assert len(painted) == 1
    view.show_diagram(replace(PLAIN, right=5.0))
    view.show_diagram(replace(PLAIN, right=6.0))
    qtbot.waitUntil(lambda: len(painted) > 1)
    qapp.processEvents()
    assert len(painted) == 2


def test_a_screen_reader_hears_the_title(view: DiagramView) -> None:
    view.show_diagram(PLAIN)
    assert view.accessibleName() == "A line"
    view.show_diagram(None)
    assert view.accessibleName() == ""


# -- spots


def test_spots_are_at_their_places_in_their_shapes(view: DiagramView) -> None:
    dot = Spot(2.0, 2.0, colour=MAGENTA, key="dot")
    view.show_diagram(replace(PLAIN, curves=(), spots=(dot,)))
    assert near(view, view.to_px(2.0, 2.0), MAGENTA) and count(view, MAGENTA) > 20
    whole = count(view, MAGENTA)
    view.show_diagram(replace(PLAIN, curves=(), spots=(replace(dot, faded=True),)))
    assert count(view, MAGENTA) == 0 and near(view, view.to_px(2.0, 2.0), LIGHT.muted)
    view.show_diagram(replace(PLAIN, curves=(), spots=(replace(dot, broken=True),)))
    assert 0 < count(view, MAGENTA) < whole
    assert count(view, LIGHT.u) == 0
    view.show_diagram(replace(PLAIN, curves=(), spots=(replace(dot, marked=True),)))
    assert count(view, LIGHT.u) > 10 and near(view, view.to_px(2.0, 2.0), MAGENTA)
    view.show_diagram(replace(PLAIN, curves=()))
    without = pixels(view)
    view.show_diagram(replace(PLAIN, curves=(), spots=(replace(dot, x=math.nan, name="no"),)))
    assert (pixels(view) == without).all()


def test_only_a_click_on_a_spot_emits_its_key(view: DiagramView, qtbot: QtBot) -> None:
    view.show_diagram(
        replace(PLAIN, spots=(Spot(2.0, 2.0, key="a"), Spot(8.0, 8.0, key="b"), Spot(5.0, 2.0)))
    )
    told: list[str] = []
    view.spot_clicked.connect(told.append)
    left = Qt.MouseButton.LeftButton
    for x, y in ((2.0, 2.0), (8.0, 8.0), (5.0, 2.0), (5.0, 9.0)):
        qtbot.mouseClick(view, left, pos=view.to_px(x, y).toPoint())
    assert told == ["a", "b"]
    qtbot.mousePress(view, left, pos=view.to_px(2.0, 2.0).toPoint())
    qtbot.mouseRelease(view, left, pos=view.to_px(8.0, 8.0).toPoint())
    qtbot.mouseClick(view, Qt.MouseButton.RightButton, pos=view.to_px(2.0, 2.0).toPoint())
    assert told == ["a", "b"]
    qtbot.mouseMove(view, view.to_px(2.0, 2.0).toPoint())
    qtbot.waitUntil(lambda: view.cursor().shape() == Qt.CursorShape.PointingHandCursor)
    qtbot.mouseMove(view, view.to_px(5.0, 9.0).toPoint())
    qtbot.waitUntil(lambda: view.cursor().shape() == Qt.CursorShape.ArrowCursor)
