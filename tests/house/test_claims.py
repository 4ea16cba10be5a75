"""The claims of docs/measurements.md: a run that contradicts one names it."""

from typing import Any

import pytest

from tests.claims import CLAIMS, PAGE, untrue, written

ROWS = """| what | figure |
|---|---|
| from exec to the picture on the screen, seen from outside | 0.91 (0.8 to 0.93), 1.88 |
| F5 and back, each, median | 250 ms |
"""


def start(picture: float, card: float) -> dict[str, Any]:
    return {
        "first-frame": {
            "exec to picture / empty, ours (median, lowest, highest)": [picture, 0.0, 9.0],
            "exec to picture / empty, ours with the start card (median)": [card, 0.0, 9.0],
        }
    }


def test_a_run_like_the_page_contradicts_nothing() -> None:
    assert untrue(ROWS, start(0.95, 1.8)) == []


@pytest.mark.parametrize(
    ("picture", "card", "said"),
    [
        (1.13, 1.88, ["from exec to the picture on the screen: 0.91 claimed, 1.13 measured"]),
        (0.91, 1.2, ["from exec to the picture on the screen: 1.88 claimed, 1.2 measured"]),
    ],
)
def test_a_claim_that_is_no_longer_true_is_named(
    picture: float, card: float, said: list[str]
) -> None:
    assert untrue(ROWS, start(picture, card)) == said


def test_a_missing_row_and_a_missing_figure_are_named() -> None:
    assert untrue("", start(1.0, 1.0)) == [
        "from exec to the picture on the screen: not on the page"
    ]
    faults = untrue(ROWS, {"first-frame": {}})
    assert len(faults) == 2 and all("the run has no figure" in fault for fault in faults)


def test_what_is_written_is_true() -> None:
    page = written(ROWS, start(1.134, 1.5))
    assert "| 1.13, 1.50 |" in page and "| 250 ms |" in page
    assert untrue(page, start(1.134, 1.5)) == []


def test_times_are_converted_to_the_pace_of_the_page() -> None:
    """A machine that is half as quick contradicts nothing, and a program that is half as quick."""
    page = f"{ROWS}| the pace of the machine, of which the times are | 20 ms |\n"
    felt = {"F5 and back, each": [500.0]}
    slow, quick = ({"felt": felt, "pace": {"felt": pace}} for pace in (40.0, 20.0))
    assert not [fault for fault in untrue(page, slow) if "F5" in fault]
    assert "F5 and back, each, median: 250 claimed, 500 measured" in untrue(page, quick)
    assert "| 125 ms |" in written(page, {"felt": felt, "pace": {"felt": 80.0}})


def test_what_is_at_most_so_may_be_less() -> None:
    page = "| slider step during a measurement, p50 and p95 at most | 1.20, 1.30 |\n"
    few = {"measuring": {"dragged": [0.8, 0.7], "typed": [1.1, 1.2]}}
    many = {"measuring": {"dragged": [0.8, 0.7], "typed": [1.5, 1.2]}}
    assert untrue(page, few) == []
    assert untrue(page, many) == [
        "slider step during a measurement: 1.2 claimed, 0.8 to 1.5 measured"
    ]
    assert "| 1.10, 1.20 |" in written(page, few)


def test_the_page_has_every_claim() -> None:
    page = PAGE.read_text(encoding="utf-8")
    lacking = untrue(page, {claim.part: {} for claim in CLAIMS})
    assert not [fault for fault in lacking if "the run has no figure" not in fault]
