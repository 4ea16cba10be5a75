"""The trades of drift and jitter: their errors, their bounds, and the scenes that they open."""

from dataclasses import replace

import numpy as np
import pytest

from app.measure import chart, drift, jitter, results
from app.measure.meaning import bargain, meaning
from app.measure.results import Trade, named
from app.measure.run import Watch, unwatched
from app.model.projection import Array, Projection
from app.model.refusal import MEASURE, Cancelled
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import load
from tests.oracles.illustrations import readings, showing, subject_of

START = load("letter-f").start
POINTS = load("letter-f").sample


def of_text(text: str) -> str | float:
    return float(text) if text[0].isdigit() else text


def cancel(_fraction: float) -> None:
    raise Cancelled


def untimed(name: str, seen: Projection = START, points: Array = POINTS) -> Trade:
    """The errors of a trade, without its times."""
    module = {"drift": drift, "jitter": jitter}[name]
    watch: Watch = cancel
    with pytest.raises(Cancelled) as caught:
        module.measure(seen, points, 0.0, watch)
    return caught.value.partial


@pytest.mark.parametrize("name", ["drift", "jitter"])
def test_every_choice_has_a_bound_that_is_not_below_its_error(name: str) -> None:
    choices = untimed(name).choices
    assert len(choices) == {"drift": 12, "jitter": 3}[name]
    for choice in choices:
        assert choice.error is not None and choice.predicted is not None
        assert 0.0 < choice.error <= choice.predicted < 1e3 * choice.error, choice.name


@pytest.mark.parametrize("name", ["drift", "jitter"])
def test_errors_are_the_same_in_every_run(name: str) -> None:
    assert untimed(name) == untimed(name)


@pytest.mark.parametrize("name", ["drift", "jitter"])
def test_a_choice_opens_the_scene_that_shows_its_error(name: str) -> None:
    """With the scene's own vertices and camera: the readings are what is measured."""
    phenomenon = PHENOMENA[name]
    subject, seen = subject_of(phenomenon), phenomenon.start
    if name == "jitter":  # the trade looks at many vertices, the scene at the nearest one
        trace = seen.trace(subject.points)
        subject = replace(subject, points=subject.points[[trace.clip[:, 3].argmin()]])
    for choice in untimed(name, seen, subject.points).choices:
        assert choice.use["scene"] == name
        settings = {
            setting.name: of_text(choice.use[f"settings.{setting.name}"])
            for setting in phenomenon.settings
            if f"settings.{setting.name}" in choice.use
        }
        shown = readings(showing(phenomenon, subject)(seen, **settings))
        ((_, measured),) = [r for r in shown.items() if "measured" in r[0]]
        assert measured == pytest.approx(choice.error, rel=1e-6), choice.name


def test_half_floats_are_not_timed_and_take_the_fewest_bytes() -> None:
    trade = drift.measure(START, POINTS, 0.0)
    for choice in trade.choices:
        half = choice.name.startswith("float16")
        assert (choice.cost is None) == half and (choice.note == MEASURE["in-software"]) == half
    sizes = {choice.name: choice.bytes for choice in trade.choices}
    assert sizes["float16, products"] == 18.0 and sizes["float64, products"] == 72.0
    assert sizes["float32, two sines"] == 4.0


def test_vertices_from_the_object_are_the_same_work_and_a_thousandth_of_the_error() -> None:
    world, relative, two = jitter.measure(START, POINTS, 0.0).choices
    assert world.cost == relative.cost and two.cost is not None
    assert world.error is not None and relative.error is not None
    assert world.error > 500.0 * relative.error
    assert (world.bytes, relative.bytes, two.bytes) == (12.0, 12.0, 24.0)


@pytest.mark.parametrize("name", ["drift", "jitter"])
def test_a_trade_has_a_chart_a_sentence_and_names_that_are_translated(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    trade = {"drift": drift, "jitter": jitter}[name].measure(START, POINTS, 0.0, unwatched)
    (diagram,) = chart.diagrams(trade)
    assert len(diagram.spots) == sum(choice.cost is not None for choice in trade.choices)
    assert "No choice is cheaper" in meaning(trade)
    assert "instead of" in bargain(trade, trade.choices[-1])
    monkeypatch.setattr(results, "of_measure", lambda text: f"<{text}>")
    for choice in trade.choices:
        assert named(choice.name).count("<") >= 1


@pytest.mark.parametrize("name", ["drift", "jitter"])
def test_without_a_vertex_there_is_nothing_to_measure(name: str) -> None:
    module = {"drift": drift, "jitter": jitter}[name]
    (choice,) = module.measure(START, np.empty((0, 3)), 0.0).choices
    assert choice.note == MEASURE["no-points"] and choice.error is None
