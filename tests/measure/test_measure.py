"""The measurements: their numbers against 80 digits, their predictions and their file."""

import itertools
import json
import math
import sys
import types
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from hypothesis import given
from hypothesis import strategies as st

import app.measure.run
import app.measure.smoothing
from app.document.document import Document
from app.drawings import WORDS
from app.drawings.image import ImageDrawing
from app.drawings.off_screen import OffScreen, pixels_of
from app.drawings.picture_frame import UNFRAMED
from app.drawings.style import LIGHT
from app.measure import chart
from app.measure.arithmetic import CHEAP, looked_at, measure, peers, summed, timed_projections
from app.measure.depth import gaps, smallest_gap
from app.measure.depth import measure as measure_depth
from app.measure.detail import TOO_FEW, apart, outline
from app.measure.detail import measure as measure_detail
from app.measure.interpolation import (
    ClipEdge,
    affine,
    aligned,
    bound,
    correct,
    steepest_edge,
    tabled,
)
from app.measure.interpolation import measure as measure_interpolation
from app.measure.interpolation import truth as true_place
from app.measure.meaning import meaning
from app.measure.measuring import measure_all
from app.measure.reference import SAMPLE, sample, truth
from app.measure.results import (
    JUDGED,
    ChartPoint,
    Measurements,
    Sweep,
    Trade,
    from_json,
    table,
    to_csv,
    to_json,
)
from app.measure.run import Watch, in_turns, part_of, steady
from app.measure.smoothing import SMOOTHINGS, pane, pictures, samples_given, shown
from app.measure.smoothing import measure as measure_smoothing
from app.measure.sweeps import SWEEPS, WORLD, in_view, sweep, values_of
from app.model.depth import FORMATS, MAPPINGS, DepthBuffer
from app.model.projection import DEPTH_RANGES, Camera, Orthographic, Perspective, Projection
from app.model.refusal import MEASURE, Cancelled, Refusal
from app.precision.levels import trace
from app.scenes.fewer_triangles import QUADRIC_TRIANGLES, SHARES, reduced
from app.scenes.scene import Scene, load
from tests.oracles.exact import Exact, mp
from tests.support.letter_f import letter_f
from tests.support.samples import pairwise

LETTER_F = letter_f()
POINTS = LETTER_F.sample
START = LETTER_F.start


# --------------------------------------------------------------------------- arithmetic


def whole(parameter: str, count: int) -> tuple[float, ...]:
    """Values from where float64 ends on one side to where it ends on the other."""
    return values_of(parameter, count, SWEEPS[parameter].low, SWEEPS[parameter].high)


def oracle_errors(projection: Projection, world: np.ndarray, answers: np.ndarray) -> list[float]:
    """Largest error in px and in depth of answers (n, 3), at 80 digits."""
    exact, largest = Exact(projection), [mp.mpf(0), mp.mpf(0)]
    for point, (x, y, depth) in zip(world.tolist(), answers.tolist(), strict=True):
        truth = exact(point)
        for axis, value in enumerate((x, y)):
            largest[0] = max(largest[0], abs(mp.mpf(value) - truth.image[axis]))
        largest[1] = max(largest[1], abs(mp.mpf(depth) - truth.depth))
    return [float(error) for error in largest]


@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize("parameter", list(SWEEPS))
def test_the_reference_is_the_oracle(parameter: str, depth: str) -> None:
    """Both agree over the swept extremes, in all 32 digits of a pair of float64."""
    for value in whole(parameter, 7):
        projection, moved = SWEEPS[parameter].set(replace(START, depth=depth), value)
        world = in_view(projection, POINTS + moved)[:5]
        assert_true(projection, world)


@pytest.mark.parametrize(
    ("kind", "keep", "depth"),
    pairwise(
        itertools.product(
            ("frustum", "orthographic", "oblique"), ("stretch", "x", "y"), DEPTH_RANGES
        )
    ),
)
def test_the_reference_is_the_oracle_for_every_lens(kind: str, keep: str, depth: str) -> None:
    projection = replace(START, depth=depth).with_lens(kind)
    lens = replace(projection.lens, left=-3.0, bottom=-0.5, keep=keep)
    assert_true(replace(projection, lens=lens), looked_at(projection, POINTS)[:5])


def assert_true(projection: Projection, world: np.ndarray) -> None:
    known = truth(projection, world)
    with mp.workdps(300):  # a field of view of 1e-80 degrees enlarges what is cut off
        oracle = Exact(projection)
        for point, numbers, rests in zip(world.tolist(), *known, strict=True):
            answer = oracle(point)
            expected = (*answer.image, answer.depth)
            for number, rest, exact in zip(numbers.tolist(), rests.tolist(), expected, strict=True):
                slack = mp.mpf(2) ** -104 * abs(exact) + mp.mpf(10) ** -100
                assert abs(mp.mpf(number) + mp.mpf(rest) - exact) <= slack


def test_a_sample_has_each_point_once_and_all_parts_of_the_list() -> None:
    points = np.repeat(np.random.default_rng(1).normal(size=(500, 3)), 3, axis=0)
    some, where = sample(points)
    np.testing.assert_array_equal(some, points[where])
    assert len(np.unique(some, axis=0)) == len(some) == SAMPLE
    assert where[0] == 0 and where[-1] >= 1497 and np.diff(where).max() < 40
    few, where = sample(points[:9])
    np.testing.assert_array_equal(few, points[[0, 3, 6]])


@pytest.mark.parametrize("far", [30.0, math.inf])
@pytest.mark.parametrize("depth", ["opengl", "reversed"])
def test_measured_errors_are_those_of_the_oracle(depth: str, far: float) -> None:
    projection = replace(START, lens=Perspective(45.0, 1.0, far), depth=depth)
    trade = measure(projection, POINTS, seconds=0.0)
    world = looked_at(projection, POINTS)
    some, where = sample(world)
    every = timed_projections(projection, world, (0.0, 0.0, 0.0)) | peers(projection, world)[0]
    compared = 0
    for choice in trade.choices:
        if choice.note == MEASURE["not-installed"] or choice.name in CHEAP:
            continue
        way = every[choice.name]
        answers = np.asarray(way.rows(way.run())).T[where]
        px, of_depth = oracle_errors(projection, some, answers)
        assert choice.error == pytest.approx(px, rel=1e-9), choice.name
        assert choice.values["error_depth"] == pytest.approx(of_depth, rel=1e-9), choice.name
        compared += 1
    assert compared >= 8


def test_trade_1_times_every_way_and_defines_its_errors() -> None:
    trade = measure(START, POINTS, seconds=0.0)
    assert trade.complete and trade.rounds >= 7
    found = {
        choice.name: choice for choice in trade.choices if choice.note != MEASURE["not-installed"]
    }
    untimed = {name for name, choice in found.items() if choice.cost is None}
    assert (
        untimed
        == set(CHEAP)
        == {name for name, c in found.items() if c.note == MEASURE["in-software"]}
    )
    for name in CHEAP:
        assert 0.0 < found[name].error <= found[name].predicted, name
    assert all(
        0.0 < choice.cost <= choice.cost_p95 for choice in found.values() if choice.cost is not None
    )
    assert found["float16"].bytes == 6.0 and found["float32"].bytes == 12.0
    assert found["12 bits"].bytes == 4.5
    assert {each.name for each in found.values() if each.library} == set(peers(START, POINTS)[0])
    precisions = {choice.use["rung"] for choice in trade.choices if "rung" in choice.use}
    assert precisions == {"float32", "float64"}  # the panes cannot draw the exact one
    for name in ("{}", "{}, eye first"):  # the same code in two formats
        single, double = (found[name.format(kind)] for kind in ("float32", "float64"))
        assert 1e-6 < single.error < 1e-3 and double.error < 1e-11
    assert str(SAMPLE) in JUDGED and table(trade)[0][-1] == JUDGED
    assert table(sweep("up", START, POINTS, (9.0,)))[0][-1] == JUDGED
    assert table(measure_depth(START))[0][-1] == ""


def test_a_division_is_predicted_at_least_as_well_as_what_stands_for_it() -> None:
    trade = measure(START, POINTS, seconds=0.0)
    predicted = {choice.name: choice.predicted for choice in trade.choices}
    for name in ("float32, reciprocal table, 2 Newton steps", "float32, snapped to 1/16 px"):
        assert predicted["float32"] <= predicted[name]
    assert all(c.error <= c.predicted for c in trade.choices if None not in (c.predicted, c.error))


def test_float32_is_the_models_precision_to_the_bit() -> None:
    origin = (1.0, 2.0, 3.0)
    for depth in ("opengl", "direct3d", "reversed"):
        projection = replace(START, depth=depth)
        world = looked_at(projection, POINTS)
        traced = trace(projection, world, "float32", origin)
        rows = summed(projection, world, origin, "float32")()
        np.testing.assert_array_equal(rows[:2].T, traced.image)
        np.testing.assert_array_equal(rows[2], traced.depth)


@pytest.mark.parametrize("parameter", list(SWEEPS))
@pytest.mark.parametrize("depth", ["opengl", "direct3d", "reversed"])
def test_predictions_hold_over_every_sweep(parameter: str, depth: str) -> None:
    """Our float64 stays accurate over the sweep, and VTK's camera breaks somewhere."""
    projection = replace(START, depth=depth)
    swept = sweep(parameter, projection, POINTS, whole(parameter, 13))
    assert len(swept.values) == 13 and swept.complete
    curves = dict(swept.curves)
    vtk = curves.pop("VTK's camera")
    assert set(vtk.predicted) == {None}
    ratios = []
    for name, curve in curves.items():
        for errors, predicted in (
            (curve.errors, curve.predicted),
            (curve.errors_depth, curve.predicted_depth),
        ):
            for error, expected, note in zip(errors, predicted, curve.notes, strict=True):
                if error is None:
                    assert note and expected == math.inf
                    continue
                assert error <= expected, (name, error)
                ratios.append(expected / max(error, 1e-30))
    assert len(ratios) > 30 and np.median(ratios) <= 30.0
    largest = max(filter(None, curves["float64, every stage"].errors))
    # Below 1e-12 degrees no float64 point can be placed in the picture.
    assert parameter == "fov" or largest < 1e-12
    if parameter in ("fov", "distance", "up", "aspect"):
        assert max(filter(None, vtk.errors)) > 0.1
    if parameter == "fov":
        assert "clamps" in vtk.notes[0] and "clamps" in vtk.notes[-1]


def test_far_from_the_origin_float32_needs_vertices_near_the_camera() -> None:
    """At 1e7 world units neighbours of float32 are 1 unit apart: a tenth of the letter."""
    curves = sweep("distance", START, POINTS, (1.0, 1e7)).curves
    assert curves["float32"].errors[1] < 1e-3
    assert curves[WORLD].errors[0] < 1e-3 and 10.0 < curves[WORLD].errors[1] < 1000.0
    assert WORLD not in sweep("up", START, POINTS, (10.0,)).curves


def test_a_swept_point_is_what_the_oracle_says() -> None:
    for parameter in SWEEPS:
        value = whole(parameter, 7)[2]
        projection, moved = SWEEPS[parameter].set(START, value)
        world = in_view(projection, POINTS + moved)
        (error,) = sweep(parameter, START, POINTS, (value,)).curves["float64, every stage"].errors
        answers = projection.trace(world)
        px, _ = oracle_errors(projection, world, np.column_stack([answers.image, answers.depth]))
        assert error == pytest.approx(px, rel=0.01), parameter


def test_a_sweep_sets_what_it_is_named_after() -> None:
    def swept(parameter: str, value: float) -> Projection:
        return SWEEPS[parameter].set(START, value)[0]

    assert swept("near", 0.25).lens.near == 0.25 and swept("near", 99.0).lens.near == 99.0
    assert swept("far", 0.5).lens.far == 0.5
    assert swept("fov", 120.0).lens.fov_y_deg == 120.0
    assert swept("aspect", 7.0).window[1] / swept("aspect", 7.0).window[3] == pytest.approx(7.0)
    moved = np.array(swept("distance", 1e6).camera.eye) - START.camera.eye
    assert np.linalg.norm(moved) == pytest.approx(1e6)
    np.testing.assert_allclose(SWEEPS["distance"].set(START, 1e6)[1], moved)
    camera = swept("up", 3.0).camera
    cosine = np.array(camera.up) @ -camera.frame[2] / np.linalg.norm(camera.up)
    assert math.degrees(math.acos(cosine)) == pytest.approx(3.0)


@pytest.mark.parametrize("parameter", list(SWEEPS))
def test_a_sweep_covers_its_range_and_can_be_narrowed(parameter: str) -> None:
    swept = SWEEPS[parameter]
    for values, (low, high) in (
        (whole(parameter, 9), (swept.low, swept.high)),
        (values_of(parameter, 9), swept.usual),
    ):
        assert swept.low <= low < high <= swept.high
        assert (values[0], values[-1]) == pytest.approx((low, high))
        assert list(values) == sorted(values)
    assert values_of(parameter, 2, 1.0, 2.0) == pytest.approx((1.0, 2.0))
    box = replace(START, lens=Orthographic(-4.0, 4.0, -2.25, 2.25, 1.0, 30.0))
    assert sweep(parameter, box, POINTS, whole(parameter, 3)).complete


def test_a_note_states_that_no_vertex_is_in_front() -> None:
    away = replace(START, camera=Camera(START.camera.target, START.camera.eye, START.camera.up))
    trade = measure(away, POINTS[:1] * 0.0 + np.array([[0.0, 0.0, -50.0]]), seconds=0.0)
    (choice,) = trade.choices
    assert choice.error is None and "no vertex" in choice.note


def test_a_peer_that_fails_to_import_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    class Broken(types.ModuleType):
        def __getattr__(self, name: str) -> object:
            raise RuntimeError("broken on purpose")

    monkeypatch.setitem(sys.modules, "pylinalg", None)  # as if it were not installed
    broken = Broken("pyglm.glm")
    monkeypatch.setitem(sys.modules, "pyglm", types.ModuleType("pyglm"))
    monkeypatch.setitem(sys.modules, "pyglm.glm", broken)
    found, missing = peers(START, POINTS)
    assert missing["pylinalg"] == MEASURE["not-installed"]
    assert "broken on purpose" in missing["PyGLM"]
    assert "matplotlib's proj3d" in found
    notes = {c.name: c.note for c in measure(START, POINTS, seconds=0.0).choices}
    assert notes["PyGLM"] == missing["PyGLM"]


def test_two_measurements_agree_exactly_in_errors_and_bytes() -> None:
    def exact_parts() -> list[tuple[object, ...]]:
        trades = [
            measure(START, POINTS, seconds=0.0),
            measure_interpolation(START, LETTER_F.corners, seconds=0.0),
            measure_depth(START),
        ]
        choices = [choice for trade in trades for choice in trade.choices]
        return [(c.name, c.error, c.bytes, c.predicted, c.values) for c in choices]

    assert exact_parts() == exact_parts()


def test_every_library_is_asked_for_the_same_picture() -> None:
    """The peers and the program's own ways all apply matrix, divide and viewport."""
    for depth in DEPTH_RANGES:
        projection = replace(START, depth=depth)
        traced = projection.trace(POINTS)
        expected = np.vstack([traced.image.T, traced.depth])
        for name, way in peers(projection, POINTS)[0].items():
            for _ in range(2):  # a second run does not move a picture that is already placed
                answer = np.asarray(way.rows(way.run()))
            np.testing.assert_allclose(answer, expected, rtol=1e-9, atol=1e-9, err_msg=name)


# --------------------------------------------------------------------------- depth


@pytest.mark.parametrize("parameter", ["near", "far"])
def test_a_sweep_of_near_or_far_shows_gaps_that_the_formula_predicts(parameter: str) -> None:
    swept = sweep(parameter, START, POINTS, values_of(parameter, 31), at=gaps)
    assert (swept.values[0], swept.values[-1]) == pytest.approx((1e-6, 1e9)) and swept.complete
    for name, curve in swept.curves.items():
        assert any(curve.errors), name
        for gap, predicted, note in zip(curve.errors, curve.predicted, curve.notes, strict=True):
            assert (gap is None) == (note == MEASURE["nothing-apart"]), name
            if gap is not None:  # beside the far plane the last code is cut short
                assert 0.5 * predicted <= gap <= 4.0 * predicted, name


def test_a_near_plane_ten_times_nearer_costs_24_bits_a_digit_and_reversed_floats_none() -> None:
    """Lecture 000: a step s of the depth is about w^2 s / n wide at a distance w."""
    swept = sweep("near", START, POINTS, (1e-3, 1e-2), at=gaps)
    w = -float(START.trace(START.camera.target).view[2])
    fixed, turned = (swept.curves[name].errors for name in ("fixed24", "float32, reversed"))
    for gap, near in zip(fixed, swept.values, strict=True):
        assert gap == pytest.approx(w * w / (near * (2**24 - 1)), rel=0.02)
    assert turned[0] == pytest.approx(turned[1], rel=0.5) and turned[0] < 1e-5


@pytest.mark.parametrize("mapping", MAPPINGS)
@pytest.mark.parametrize("format_", list(FORMATS))
@pytest.mark.parametrize("far", [30.0, math.inf])
def test_the_smallest_gap_is_never_below_the_formulas(
    far: float, format_: str, mapping: str
) -> None:
    """What is found holds for surfaces about the target, what is predicted for one at it."""
    if far == math.inf and mapping == "logarithmic":
        return
    buffer = DepthBuffer(format_, mapping, Perspective(near=1.0, far=far))
    for distance in (1.7, 11.0, 25.0, *np.random.default_rng(1).uniform(1.0, 30.0, 8).tolist()):
        found, predicted = smallest_gap(buffer, distance), float(buffer.gap(distance))
        if predicted == math.inf:
            continue
        assert found >= predicted * (1.0 - 1e-6)  # as float64 knows where codes begin
        if found == math.inf:
            behind = distance + predicted
            assert buffer.encode(min(behind, far)) == buffer.encode(min(far, 1e300))
            continue
        # It is real: a pair somewhat closer about there has one code, and none farther apart.
        surfaces = np.linspace(distance, distance + 3.0 * found, 3001)
        surfaces = surfaces[surfaces + 1.001 * found <= min(far, 1e300)]
        closer = buffer.encode(surfaces) == buffer.encode(surfaces + 0.99 * found)
        assert closer.any() or len(surfaces) < 3001
        near = surfaces[surfaces <= distance + predicted / 1000.0]
        assert (buffer.encode(near) != buffer.encode(near + 1.001 * found)).all()


def test_the_depth_trade_has_every_format_and_range() -> None:
    trade = measure_depth(START)
    assert len(trade.choices) == len(FORMATS) * len(MAPPINGS)
    for choice in trade.choices:
        assert choice.cost is not None and choice.values["collapsed"] == pytest.approx(
            choice.values["collapsed_predicted"], abs=0.01
        )
    infinite = measure_depth(replace(START, lens=Perspective(45.0, 1.0, math.inf)))
    notes = [choice.note for choice in infinite.choices if choice.name.endswith("logarithmic")]
    assert all("far" in note for note in notes)
    near = measure_depth(replace(START, lens=Perspective(45.0, 20.0, 30.0)))
    assert {choice.note for choice in near.choices} == {MEASURE["beyond"]}


# --------------------------------------------------------------------------- interpolation


@given(st.floats(0.01, 100.0), st.floats(0.01, 100.0), st.integers(1, 64))
def test_affine_errors_reach_their_bound_and_no_more(one: float, other: float, splits: int) -> None:
    """At 80 digits t = s/w1 / ((1 - s)/w0 + s/w1); between two split points, a straight line."""
    start, end = np.array([-one, 0.0, 0.0, one]), np.array([other, 0.0, 0.0, other])
    edge = ClipEdge(start, end, 100.0)
    s = np.linspace(0.0, 1.0, 4097)
    wrong = np.abs(affine(edge, s, splits)() - correct(edge, s)())
    predicted = bound(edge, splits)
    assert wrong.max() <= predicted + 1e-12
    assert wrong.max() >= 0.9 * predicted - 1e-12
    near, far = mp.mpf(one), mp.mpf(other)
    for place in (0.0, 0.25, 0.5, 1.0):
        right = (place / far) / ((1 - mp.mpf(place)) / near + place / far)
        got = correct(edge, np.array([place]))()[0]
        assert float(abs(right - got)) < 1e-15 * edge.ratio
        assert true_place(edge, np.array([place]))[0] == pytest.approx(float(right), abs=1e-12)


def test_the_edge_is_cut_to_the_picture_and_the_steepest() -> None:
    scene = load("posts")
    edge = steepest_edge(scene.start, scene.corners)
    assert edge is not None and edge.ratio > 3.0 and edge.length_px > 100.0
    for end in (edge.start, edge.end):
        assert (np.abs(end[:3]) <= end[3] * (1.0 + 1e-12)).all()


def test_correct_interpolation_is_exact_and_more_pieces_are_better() -> None:
    trade = measure_interpolation(START, LETTER_F.corners, seconds=0.0)
    exact, *pieces = (choice for choice in trade.choices if "table" not in choice.name)
    assert exact.error is not None and exact.error <= (exact.predicted or 0.0) < 1e-9
    assert len({choice.cost for choice in pieces}) == 1, "a pixel's work is the same"
    said = meaning(trade)
    assert "1040 B" in said and "40 B" in said
    errors = [choice.error for choice in pieces]
    assert errors == sorted(errors, reverse=True) and errors[0] > 10.0
    for choice in pieces:
        assert choice.predicted is not None and choice.error is not None
        assert 0.9 * choice.predicted <= choice.error <= choice.predicted * (1.0 + 1e-9)
    box = replace(START, lens=Orthographic(-4.0, 4.0, -2.25, 2.25, 1.0, 30.0))
    flat = measure_interpolation(box, LETTER_F.corners, seconds=0.0)
    exact_ways = [choice for choice in flat.choices if "table" not in choice.name]
    assert max(choice.error or 0.0 for choice in exact_ways) < 1e-9
    away = replace(START, camera=Camera((0.0, 50.0, 0.0), (0.0, 90.0, 0.0), (0.0, 0.0, 1.0)))
    (nothing,) = measure_interpolation(away, LETTER_F.corners, seconds=0.0).choices
    assert nothing.error is None and "no edge" in nothing.note


@pytest.mark.parametrize("count", [1, 7, 4097])
def test_timed_arrays_begin_at_a_line_of_the_cache(count: int) -> None:
    for _ in range(20):
        array = aligned(count)
        assert array.shape == (count,) and array.ctypes.data % 64 == 0
    edge = ClipEdge(np.array([-1.0, 0.0, 0.0, 1.0]), np.array([9.0, 0.0, 0.0, 9.0]), 100.0)
    for run in (correct(edge, array), affine(edge, array, 4)):
        arrays = [c.cell_contents for c in run.__closure__ or ()]
        arrays = [a for a in arrays if isinstance(a, np.ndarray)]
        assert arrays and all(a.ctypes.data % 64 == 0 for a in arrays)


def test_a_table_of_reciprocals_is_off_by_its_own_error_and_each_newton_step_squares_it() -> None:
    trade = measure_interpolation(START, LETTER_F.corners, seconds=0.0)
    tables = [choice for choice in trade.choices if "table" in choice.name]
    assert len(tables) == 3
    for steps, choice in enumerate(tables):
        error, predicted = choice.error or 0.0, choice.predicted or 0.0
        assert error <= predicted == pytest.approx(256.0 * 2.0 ** (-8.453 * 2**steps), rel=0.02)
        assert error > 0.4 * predicted and choice.cost is None


@given(st.floats(0.01, 1e4), st.floats(0.01, 1e4), st.integers(0, 2))
def test_reciprocals_of_a_table_are_within_the_bound_on_every_edge(
    one: float, other: float, steps: int
) -> None:
    edge = ClipEdge(np.array([-one, 0.0, 0.0, one]), np.array([other, 0.0, 0.0, other]), 100.0)
    s = np.linspace(0.0, 1.0, 501)
    found, predicted = tabled(edge, s, steps)
    assert np.abs(found - correct(edge, s)()).max() <= predicted + 1e-14 * edge.ratio


# --------------------------------------------------------------------------- running


def stop_after(calls: int) -> Watch:
    seen = itertools.count(1)

    def watch(_fraction: float) -> None:
        if next(seen) > calls:
            raise Cancelled

    return watch


def test_turns_are_interleaved_and_progress_grows() -> None:
    order: list[str] = []
    seen: list[float] = []
    times = in_turns(
        {"a": lambda: order.append("a"), "b": lambda: order.append("b")}, 0.0, seen.append
    )
    assert {name: each.rounds for name, each in times.items()} == {"a": 7, "b": 7}
    blocks = [name for name, _ in itertools.groupby(order)]
    assert blocks[-6:] == ["a", "b"] * 3
    assert seen == sorted(seen) and seen[0] >= 0.0 and seen[-1] <= 1.0


def test_times_are_steady_when_the_last_seven_rounds_repeat_the_least() -> None:
    quiet = [1.0, 1.2, 1.1, 1.3, 1.0, 1.1, 1.2]
    assert not steady(quiet), "nothing was repeated"
    assert steady([*quiet, *(1.04 * each for each in quiet)])
    assert not steady([*quiet, *(1.06 * each for each in quiet)]), "slower than before"
    assert not steady([*quiet, *quiet, 0.94]), "a better one was just found"
    assert steady([*quiet, 0.94, *quiet[1:], 0.94])


def test_a_machine_with_other_work_is_called_busy_in_table_and_chart() -> None:
    calm, busy = ChartPoint("a", 10.0, 30.0, 1.0), ChartPoint("b", 10.0, 30.1, 0.5, bytes=8.0)
    trade = Trade("arithmetic", "ns", "px", (calm, busy), 20)
    assert [row[-1] for row in table(trade)[1:]] == ["", MEASURE["busy"]]
    assert chart.diagrams(trade)[0].title == f"Arithmetic: {MEASURE['busy']}"
    assert chart.diagrams(replace(trade, choices=(calm,)))[0].title == "Arithmetic"
    assert chart.diagrams(trade.by_cost("bytes"))[0].title == "Arithmetic", (
        "bytes are never disturbed"
    )


def test_a_time_that_ran_out_before_it_was_steady_is_doubted_in_row_and_sentence() -> None:
    rushed = measure_interpolation(START, LETTER_F.corners, seconds=0.0)
    timed = [choice for choice in rushed.choices if choice.cost is not None]
    assert timed and all(choice.doubt in (MEASURE["unsteady"], MEASURE["busy"]) for choice in timed)
    assert "Not certain: " in meaning(rushed)
    calm = replace(rushed, choices=tuple(ChartPoint(c.name, 1.0, 1.0, c.error) for c in timed))
    assert not calm.doubts and "Not certain" not in meaning(calm)
    lasting = Measurements("", {}, {}, {}, (rushed,))
    assert from_json(to_json(lasting)).trades[0].doubts == rushed.doubts
    tree = json.loads(to_json(lasting))
    for choice in tree["trades"][0]["choices"]:
        del choice["steady"]
    older = from_json(json.dumps(tree)).trades[0]
    assert MEASURE["unsteady"] not in older.doubts, "older files do not say it"


def test_equal_times_are_called_equal_and_no_winner() -> None:
    points = [ChartPoint(name, cost, cost, off, bytes=b) for name, cost, off, b in (
        ("none", 1.0, 9.0, 8.0), ("FXAA", 1.04, 8.0, 12.0), ("MSAA 4", 2.0, 1.0, 36.0),
    )]  # fmt: skip
    trade = Trade("smoothing", "ms", "levels RMS", tuple(points), 20)
    said = meaning(trade)
    assert said.startswith("No choice is cheaper than FXAA (1 ms, 12 B, off by 8 levels RMS)")
    assert said.endswith("Equal in time to FXAA: none (8 B).")
    apart = replace(trade, choices=(replace(points[0], cost=0.9), *points[1:]))
    assert "Equal in time" not in meaning(apart)


def test_a_price_in_a_further_column_is_named() -> None:
    own = ChartPoint("16 bits, own boxes", 6.0, 6.0, 0.01, 0.02, {"moved_px": 0.0096}, bytes=6.0)
    common = ChartPoint("8 bits, common grid", 3.0, 3.0, 0.0, 0.0, {"moved_px": 3.5}, bytes=3.0)
    trade = Trade("cracks", "B", "px", (own, common), 1)
    assert meaning(trade) == (
        "No choice is cheaper (3 B) or more exact (0 px) than 8 bits, common grid. Its price is in "
        "vertices moved by up to (px): 3.5, against 0.0096 for 16 bits, own boxes."
    )
    free = replace(trade, choices=(own, replace(common, values={"moved_px": 0.001})))
    assert "price" not in meaning(free)


def test_a_part_scales_its_progress() -> None:
    seen: list[float] = []
    part_of(seen.append, 0.5, 1.0)(0.5)
    assert seen == [0.75]


def test_a_time_is_the_least_with_its_95th_percentile(monkeypatch: pytest.MonkeyPatch) -> None:
    ends = itertools.accumulate([1.0, 1.0, *map(float, range(1, 8))])  # two runs are not counted
    clock = [0.0]
    fake = types.SimpleNamespace(perf_counter=lambda: clock[0])
    monkeypatch.setattr(app.measure.run, "time", fake)
    times = in_turns({"a": lambda: clock.__setitem__(0, next(ends))}, seconds=0.0)
    assert times["a"] == pytest.approx((1.0, 6.7, 7, False))


def test_a_cancelled_run_keeps_what_was_done() -> None:
    def run(calls: int, trade: str, *sweeps: str) -> Measurements:
        names = dict.fromkeys(sweeps, (None, None))
        watch, document = stop_after(calls), Document("letter-f", START)
        results = measure_all(document, LETTER_F, [trade], names, quick=True, watch=watch)
        assert results.document["scene"] == "letter-f"
        assert results.versions["numpy"] == np.__version__
        return results

    results = run(4, "depth", "near")
    (trade,) = results.trades
    assert not trade.complete and len(trade.choices) == 4
    assert not results.complete and not results.sweeps
    results = run(len(FORMATS) * len(MAPPINGS) + 3, "depth", "near")
    assert results.trades[0].complete and not results.complete
    (swept,) = results.sweeps
    assert len(swept.values) == 3 and not swept.complete
    results = run(16, "arithmetic")
    assert results.trades[0].choices[0].error is not None
    assert from_json(to_json(results)) == results
    results = run(1000, "depth")
    assert results.complete and [trade.name for trade in results.trades] == ["depth"]


# --------------------------------------------------------------------------- the file

TRADE = Trade(
    "arithmetic",
    "ns",
    "px",
    (
        ChartPoint(
            "cheap", 1.0, 1.1, 1e-3, 2e-3, {"error_depth": 1e-6}, "", {"rung": "float32"}, 12.0
        ),
        ChartPoint("dominated", 3.0, 3.5, 1e-2),
        ChartPoint("good", 2.0, 2.1, 1e-9, values={"other": math.inf}),
        ChartPoint('odd, "quoted"', None, None, None, note="returns NaN"),
    ),
    7,
)


def results_of(*sweeps: Sweep) -> Measurements:
    date = "2026-11-21T08:00:00+00:00"
    return Measurements(date, {"cores": "2"}, {"numpy": "2"}, {"a": 1}, (TRADE,), sweeps)


def test_the_file_brings_everything_back() -> None:
    swept = sweep("near", START, POINTS, values_of("near", 3))
    results = replace(results_of(swept), complete=False)
    assert from_json(to_json(results)) == results


def test_the_frontier_is_made_of_the_programs_own_choices() -> None:
    """A library is neither on it nor grey; times that differ by 5 % or less are equal."""
    library = ChartPoint("library", 0.5, 0.5, 1e-12, library=True)
    same = ChartPoint("same", 1.04, 1.1, 1e-5)
    trade = replace(TRADE, choices=(*TRADE.choices, library, same))
    assert [choice.name for choice in trade.frontier] == ["same", "good"]
    assert not trade.is_beaten(library) and trade.is_beaten(TRADE.choices[0])
    (diagram,) = chart.diagrams(trade)
    assert [spot.key for spot in diagram.spots if spot.hollow] == ["library"]
    slower = replace(trade, choices=(*TRADE.choices, replace(same, cost=1.06)))
    assert [choice.name for choice in slower.frontier] == ["cheap", "same", "good"]


def test_bytes_are_another_axis() -> None:
    sizes = (12.0, 6.0, 24.0, None)
    choices = [replace(c, bytes=size) for c, size in zip(TRADE.choices, sizes, strict=True)]
    trade = replace(TRADE, choices=tuple(choices)).by_cost("bytes")
    assert [choice.name for choice in trade.frontier] == ["dominated", "cheap", "good"]
    assert trade.cost_unit == "B" and "bytes" in chart.diagrams(trade)[0].x_label
    assert TRADE.by_cost("time") is TRADE
    assert measure_depth(START).by_cost("bytes").cost_unit == "B"


def test_a_spreadsheet_can_read_the_table() -> None:
    assert [choice.name for choice in TRADE.frontier] == ["cheap", "good"]
    lines = to_csv(TRADE).splitlines()
    assert lines[0] == "choice,cost_ns,cost_p95_ns,bytes,error_px,predicted,error_depth,other,note"
    assert lines[1] == "cheap,1.0,1.1,12.0,0.001,0.002,1e-06,,"
    assert lines[4] == '"odd, ""quoted""",,,,,,,,returns NaN'
    swept = sweep("near", START, POINTS, (1.0, 2.0))
    assert to_csv(swept).splitlines()[0].startswith("near,float32,")


@pytest.mark.parametrize(
    "change, sentence",
    [
        (lambda tree: tree.update(format="other"), "is not a file of measurements"),
        (lambda tree: tree.update(version=1), "its version is 1, this one reads 2"),
        (lambda tree: tree.pop("date"), "date is missing"),
        (lambda tree: tree.update(trades={}), "trades must be a list"),
        (
            lambda tree: tree["trades"][0]["choices"][0].update(cost="fast"),
            "trades[0].choices[0].cost must be a number",
        ),
        (lambda tree: tree["trades"][0].update(complete=1), "complete must be true or false"),
        (lambda tree: tree.update(machine=[]), "machine must be an object"),
        (
            lambda tree: tree["sweeps"][0]["choices"]["exact"]["error"].pop(),
            "as long as the sweep's values",
        ),
    ],
)
def test_another_file_is_refused_in_a_sentence(change: Any, sentence: str) -> None:
    tree = json.loads(to_json(results_of(sweep("near", START, POINTS, (1.0, 2.0)))))
    change(tree)
    with pytest.raises(Refusal) as caught:
        from_json(json.dumps(tree), "results.json")
    assert sentence in str(caught.value) and str(caught.value).startswith("results.json: ")


@pytest.mark.parametrize("text", ["", "[1]", "{", "nonsense", "[" * 100_000])
def test_a_text_without_json_is_refused(text: str) -> None:
    with pytest.raises(Refusal, match="is not a file of measurements"):
        from_json(text)


# --------------------------------------------------------------------------- pictures


@pytest.fixture
def one_round(monkeypatch: pytest.MonkeyPatch) -> None:
    """Time every choice once only."""
    monkeypatch.setattr(app.measure.run, "LEAST_ROUNDS", 1)


@pytest.mark.usefixtures("one_round")
def test_more_samples_make_smoothing_more_accurate() -> None:
    trade = measure_smoothing(LETTER_F, START, seconds=0.0)
    errors = {choice.name: choice.error for choice in trade.choices}
    assert list(errors) == [smoothing.name for smoothing, _ in pictures()]
    rising = ("supersampling 3 x 3", "supersampling 2 x 2", "none", "half resolution")
    assert all(errors[a] < errors[b] for a, b in itertools.pairwise(rising))
    multisampled = [error for name, error in errors.items() if name.startswith("MSAA")]
    assert max(multisampled) < errors["FXAA"] < errors["none"]
    assert all(choice.cost > 0.0 for choice in trade.choices)
    assert len(set(errors.values())) == len(errors), "no two are the same picture here"
    notes = {smoothing.name: note for smoothing, note in pictures()}
    assert {choice.name: choice.note for choice in trade.choices} == notes


def test_fxaa_is_measured_as_a_pane_draws_it() -> None:
    """By the program's own shader: VTK's takes twice as long, and rounds some pixels otherwise."""
    size, (fxaa,) = (640, 360), [each for each in SMOOTHINGS if each.fxaa]
    with pane(LETTER_F, START, size, fxaa) as (draw, read):
        draw()
        measured = read()
    with closing(OffScreen(*size)) as screen:
        screen.quicken_fxaa()
        drawing = ImageDrawing(screen, LETTER_F, WORDS, LIGHT, options=UNFRAMED)
        drawing.show_projection(START)
        for renderer in screen.render_window.GetRenderers():
            renderer.UseFXAAOn()
        screen.render_window.Render()
        assert (measured == pixels_of(screen.render_window)).all()
        drawing.remove()


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({2: 4, 4: 4, 8: 4}, {"MSAA 4": "MSAA 2, MSAA 8, the same picture"}),  # as Mesa does
        ({2: 2, 4: 4, 8: 8}, {"MSAA 2": "", "MSAA 4": "", "MSAA 8": ""}),
        (
            {2: 2, 4: 6, 8: 6},
            {"MSAA 2": "", "MSAA 4": "this OpenGL gives 6 samples, MSAA 8, the same picture"},
        ),
        ({2: 1, 4: 1, 8: 1}, {"none": "MSAA 2, MSAA 4, MSAA 8, the same picture"}),
    ],
)
def test_choices_that_are_the_same_picture_are_one(
    given: dict[int, int], expected: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(app.measure.smoothing, "samples_given", given.__getitem__)
    kept = {smoothing.name: note for smoothing, note in pictures()}
    others = [each.name for each in SMOOTHINGS if not each.samples]
    assert [name for name in kept if not name.startswith("MSAA")] == others
    assert {name: note for name, note in kept.items() if note or name in expected} == expected


def test_samples_are_counted() -> None:
    assert samples_given(0) == 1
    assert samples_given(4) >= 4  # as OpenGL 3.2 demands


def test_shown_averages_or_repeats() -> None:
    pixels = np.zeros((2, 2, 4), dtype=np.uint8)
    pixels[0, 0, :3] = 100
    assert shown(pixels, 2.0, (1, 1)).tolist() == [[[25, 25, 25, 0]]]
    assert shown(pixels, 0.5, (4, 4))[1, 1].tolist() == [100, 100, 100, 0]
    assert shown(pixels, 0.5, (4, 4)).shape == (4, 4, 4)
    drawn = np.random.default_rng(3).integers(0, 256, (18, 24, 4), dtype=np.uint8)
    mean = drawn.reshape(6, 3, 8, 3, 4).mean(axis=(1, 3))
    assert np.abs(shown(drawn, 3.0, (8, 6)) - mean).max() <= 0.5
    assert shown(drawn, 1.0, (24, 18)) is drawn


@pytest.mark.usefixtures("one_round")
def test_every_choice_is_read_back_and_scaled_in_its_time(monkeypatch: pytest.MonkeyPatch) -> None:
    reads = list[Any]()
    monkeypatch.setattr(
        app.measure.smoothing, "pixels_of", lambda window: reads.append(window) or pixels_of(window)
    )
    measure_smoothing(LETTER_F, START, seconds=0.0)
    runs = [window.GetSize() for window in reads]
    # Once for the error, twice before the first round, and in it.
    assert len(runs) >= 4 * len(pictures())


@pytest.fixture(scope="module")
def sphere(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    path = tmp_path_factory.mktemp("sphere") / "sphere.ply"
    pv.Sphere(theta_resolution=60, phi_resolution=60).save(path)
    return load(str(path))


@pytest.mark.usefixtures("one_round")
def test_fewer_triangles_move_the_outline_as_far_as_they_are_long(sphere: Scene) -> None:
    trade = measure_detail(sphere, sphere.start, seconds=0.0)
    assert [choice.name for choice in trade.choices] == [
        f"{100 * share:g} %" for share in (1.0, *SHARES)
    ]
    assert trade.choices[0].error == 0.0
    errors = [choice.error for choice in trade.choices]
    assert errors == sorted(set(errors)), "each share is told from the next"
    assert errors[-1] > 1.0 and errors[1] <= 0.2
    triangles = [choice.values["triangles"] for choice in trade.choices]
    for share, count in zip(SHARES, triangles[1:], strict=True):
        assert count == pytest.approx(share * triangles[0], rel=0.2)
    assert trade.choices[-1].bytes < 0.1 * trade.choices[0].bytes
    whole_mesh = sphere.surface
    assert trade.choices[0].bytes == 12 * (whole_mesh.n_points + whole_mesh.n_cells)


def test_the_outline_is_where_the_model_projects_it(sphere: Scene) -> None:
    """The sphere's ellipse is convex, so the farthest projected vertex each way is on it."""
    places = outline(sphere, sphere.start, (320, 180)).reshape(-1, 2)
    image = sphere.start.trace(sphere.sample[: sphere.surface.n_points]).image / 4.0
    angles = np.radians(np.arange(360.0))
    ways = np.stack([np.cos(angles), np.sin(angles)])
    assert np.abs((places @ ways).max(axis=0) - (image @ ways).max(axis=0)).max() < 1e-9


def test_an_outline_with_holes_and_parts_behind_others_is_that_of_the_drawn_pixels() -> None:
    size = (640, 360)
    pieces = outline(LETTER_F, START, size)
    finer = SMOOTHINGS[0]._replace(scale=3.0)
    with pane(replace(LETTER_F, lines=None), START, size, finer) as (draw, read):
        draw()
        drawn = read()[..., :3] != 255
    covered = drawn.any(axis=2)
    inner = covered[1:-1, 1:-1]
    alone = ~(covered[:-2, 1:-1] & covered[2:, 1:-1] & covered[1:-1, :-2] & covered[1:-1, 2:])
    rows, columns = np.nonzero(inner & alone)
    pixels = (np.stack([columns, rows], axis=1) + 1.5) / 3.0
    ends = pieces.mean(axis=1)
    away = np.hypot(*(pixels[:, None] - ends[None]).transpose(2, 0, 1))
    assert away.min(axis=0).max() < 1.0, "no piece is inside the letter"
    assert away.min(axis=1).max() < 1.0, "no edge of the letter is missing"


def test_the_distance_of_two_outlines_is_that_of_their_farthest_places() -> None:
    def square(side: float) -> np.ndarray:
        corners = side / 2.0 * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], dtype=float)
        return np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)

    assert apart(square(2.0), square(2.0)) == 0.0
    assert apart(square(2.0), square(4.0)) == pytest.approx(math.sqrt(2.0))
    assert apart(np.empty((0, 2, 2)), square(2.0)) is None


@pytest.mark.usefixtures("one_round")
def test_a_scene_of_few_faces_lends_its_camera_to_a_sphere() -> None:
    """No chart is empty for the scene that opens; the choices say what they are about."""
    trade = measure_detail(LETTER_F, START, seconds=0.0)
    assert all(choice.note == TOO_FEW and not choice.use for choice in trade.choices)
    errors = [choice.error for choice in trade.choices]
    assert errors[0] == 0.0 and errors[-1] > 1.0
    (diagram,) = chart.diagrams(trade)
    assert diagram.title.endswith(f"; {TOO_FEW}"), diagram.title
    assert reduced(LETTER_F, 0.1) is LETTER_F


def test_colours_stay_where_they_were(tmp_path: Path) -> None:
    """A sphere painted by halves stays painted by halves."""
    mesh = pv.Sphere(theta_resolution=60, phi_resolution=60)
    colours = np.where(mesh.points[:, :1] > 0.0, (255, 0, 0), (0, 0, 255)).astype(np.uint8)
    mesh.point_data["RGB"] = colours
    mesh.save(tmp_path / "two.ply", texture="RGB")
    scene = load(str(tmp_path / "two.ply"))
    fewer = reduced(scene, 0.2)
    assert fewer.surface is not None
    middles = pv.wrap(fewer.surface).cell_centers().points + np.array(scene.origin)
    rgb = fewer.surface.cell_data["rgb"].astype(int)
    for colour, side in ((0, middles[:, 0] > 0.1), (2, middles[:, 0] < -0.1)):
        assert side.any() and (rgb[side, colour] > rgb[side, 2 - colour]).all()


def test_a_large_mesh_is_sorted_into_boxes(tmp_path: Path) -> None:
    pv.Sphere(theta_resolution=400, phi_resolution=400).save(tmp_path / "large.ply")
    scene = load(str(tmp_path / "large.ply"))
    assert scene.surface is not None and scene.surface.n_cells > QUADRIC_TRIANGLES
    for share in SHARES:
        fewer = reduced(scene, share)
        assert fewer.surface is not None and reduced(scene, share) is fewer
        assert fewer.surface.n_cells == pytest.approx(share * scene.surface.n_cells, rel=0.25)
        assert fewer.origin == scene.origin and fewer.lines is scene.lines
