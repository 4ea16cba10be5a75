"""What docs/measurements.md claims of the figures of ``tests.benchmark``.

Each `Claim` is one row of the page's first table. `untrue` compares the rows with a run, and
`written` brings them up to date. Times in milliseconds depend on the machine, so each part of a run
also measures the machine's pace, and its times are converted to the pace that the page states.
"""

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from app.bootstrap import ROOT

PAGE = Path(ROOT) / "docs" / "measurements.md"
TOLERANCE = 0.2
"""By how much a figure may be above or below its claim: two quiet runs differ by up to a tenth."""
TOLERANCE_OF_TIMES = 0.4
"""The same of a time that was converted: no two machines differ by one factor in all they do."""

Figures = Mapping[str, Mapping[str, Any]]
"""The figures of each part of the benchmark, and under `PACE` the machine's pace in each part."""
PACE = "pace"
_AT_MOST = "at most"  # a row with these words has no lower bound
_PACE_ROW = re.compile(r"^\| the pace of the machine[^|]*\| ([\d.]+) ms \|$", re.MULTILINE)


class Claim(NamedTuple):
    """One row: how its text begins, the part that measures it, and where each number comes from.

    A source is a pattern of the names of figures, and the place in their lists. A number, or the
    ends of a range ("25 to 32"), stands for all figures that match. `is_paced` if a machine that
    is half as quick takes twice as long, and no target of time decides.
    """

    row: str
    part: str
    sources: tuple[tuple[str, int], ...]
    is_paced: bool = False


def _each(pattern: str, values: Sequence[object], place: int = 0) -> tuple[tuple[str, int], ...]:
    return tuple((pattern.format(re.escape(str(value))), place) for value in values)


_VERTICES = (100, 10_000, 1_000_000)
_SIZES = ("1366 x 768", "1920 x 1080")
_FASTEST = "letter-f|cube|posts|view-volumes|vanishing-points"
_SLOWEST = ("clipping", "eye-plane", "far-plane-popping", "off-axis-window", "focus")

CLAIMS = (
    Claim("slider step over the bare repaint", "step",
          _each("^{} vertices: p50, p95 of step / bare repaint", _VERTICES)),
    Claim("slider step with the matrices", "panels",
          _each("^{}: step / (step without|the same)", ("matrices and three probes",
                                                        "the probes' numbers"))),
    Claim("step of the stage strip", "strip",
          _each("^{} vertices: p50, p95 of step / bare repaint", _VERTICES)),
    Claim("a step, panes that paint pixels", "canvases", _each("^{}: step,", _SIZES)),
    Claim("a slider's own repaint", "canvases",
          _each("^{}: slider,", _SIZES) + _each("^{}: typing,", _SIZES)),
    Claim("what a control highlights", "canvases", _each("^{}: hover,", _SIZES)),
    Claim("a dragged step in a window of 1920 x 1080 with", "scenes", ((f"^({_FASTEST}):", 3),),
          True),
    Claim("the same: the other scenes", "scenes",
          ((f"^(?!{_FASTEST}|{'|'.join(_SLOWEST)})", 3),), True),
    Claim("the same: clipping", "scenes", _each("^{}:", _SLOWEST, 3), True),
    Claim("a dragged step with a target", "adaptive",
          _each("^1600 x 700, {} vertices, target", _VERTICES, 1)),
    Claim("the same in one of 1920 x 1080", "adaptive",
          _each("^1920 x 1080, {} vertices, target", _VERTICES, 1)),
    Claim("the same without a target", "adaptive",
          _each("^1600 x 700, {} vertices, no target", _VERTICES, 1), True),
    Claim("a step over the same three pictures by pyvista", "peers",
          _each("^{} vertices: .*pyvista", (100, 10_000, 100_000, 1_000_000))),
    Claim("the same over matplotlib", "peers", _each("^{} vertices: .*matplotlib", (100, 10_000))),
    Claim("slider step during a measurement", "measuring", ((".", 0), (".", 1))),
    Claim("from exec to the picture on the screen", "first-frame",
          (("^exec to picture .*, ours \\(", 0), ("^exec to picture .*start card", 0))),
    Claim("a talk of 200 steps", "talks",
          (("^200 steps", 0), ("own work, same scene", 0), ("own work, other scene", 0)),
          True),
    Claim("another scene from the list, median, largest", "felt",
          (("^another scene", 0), ("^another scene", 1)), True),
    Claim("F5 and back, each, median", "felt", (("^F5 and back", 0),), True),
    Claim("first picture of a step, median, largest: lesson L5", "felt",
          (("^first picture.*l05.*same", 0), ("^first picture.*l05.*same", 1)), True),
    Claim("first picture of a step, median: talk 003", "felt",
          (("^first picture.*talk-003, same", 0), ("^first picture.*talk-003, another", 0)), True),
    Claim("a move that turns one's own view", "felt",
          _each("^own view turned, {} vertices", (100_000, 1_000_000))),
    Claim("Matrices opened, the first time", "felt", (("^Matrices opened", 0),), True),
    Claim("letter F at 1920 x 1080, a slider step, p50, p95: alone", "felt",
          (("step.*alone", 0), ("step.*alone", 1), ("step.*hog", 0), ("step.*hog", 1)),
          True),
    Claim("memory of the window as it opens", "felt", (("^memory at rest", 0),)),
)  # fmt: skip

_NUMBER = re.compile(r"(\d+(?:\.\d+)?)(?: to (\d+(?:\.\d+)?))?(?: \([^)]*\))?")


def _row(page: str, claim: Claim) -> re.Match[str] | None:
    return re.search(rf"^\| {re.escape(claim.row)}[^|]*\| ([^|]*) \|$", page, re.MULTILINE)


def _ends(
    page: str, figures: Figures, claim: Claim, pattern: str, place: int
) -> tuple[float, float] | None:
    """Return the least and the largest of the matching figures; None if there is none."""
    stated, measured = _PACE_ROW.search(page), figures.get(PACE, {}).get(claim.part)
    pace = float(stated[1]) / measured if claim.is_paced and stated and measured else 1.0
    values = [
        float(figure[place] if isinstance(figure, list) else figure) * pace
        for name, figure in figures[claim.part].items()
        if re.search(pattern, name)
    ]
    return (min(values), max(values)) if values else None


def untrue(page: str, figures: Figures) -> list[str]:
    """Return a sentence for each number of the page that a run contradicts, and each row it lacks.

    Rows of parts that did not run are not looked at.
    """
    faults = []
    for claim in CLAIMS:
        if claim.part not in figures:
            continue
        row = _row(page, claim)
        if row is None:
            faults.append(f"{claim.row}: not on the page")
            continue
        most = 1.0 + (TOLERANCE_OF_TIMES if claim.is_paced else TOLERANCE)
        claimed = [(float(low), float(high or low)) for low, high in _NUMBER.findall(row[1])]
        if len(claimed) < len(claim.sources):
            faults.append(f"{claim.row}: {len(claimed)} numbers of {len(claim.sources)}")
        for (low, high), (pattern, place) in zip(claimed, claim.sources, strict=False):
            ends = _ends(page, figures, claim, pattern, place)
            if ends is None:
                faults.append(f"{claim.row}: the run has no figure {pattern}")
            elif ends[1] > high * most or (ends[0] < low / most and _AT_MOST not in row[0]):
                faults.append(f"{claim.row}: {_span(low, high)} claimed, {_span(*ends)} measured")
    return faults


def _span(low: float, high: float) -> str:
    return f"{low:.4g}" if low == high else f"{low:.4g} to {high:.4g}"


def written(page: str, figures: Figures) -> str:
    """Return the page with the numbers of a run in the rows that it has; it adds none."""
    for claim in CLAIMS:
        row = _row(page, claim)
        if claim.part not in figures or row is None:
            continue
        ends = iter([_ends(page, figures, claim, *source) for source in claim.sources])

        def number(old: re.Match[str], ends: Any = ends, is_most: bool = _AT_MOST in row[0]) -> str:
            new = next(ends, None)
            if new is None:
                return old[0]
            digits = len(old[1].partition(".")[2])
            low, high = (f"{end:.{digits}f}" for end in new)
            return high if low == high or is_most else f"{low} to {high}"

        page = page[: row.start(1)] + _NUMBER.sub(number, row[1]) + page[row.end(1) :]
    return page
