"""Samples that find what a full product would."""

import itertools
from collections.abc import Iterable, Mapping
from typing import Any, TypeVar

import pytest

Row = TypeVar("Row", bound=tuple[Any, ...])


def pairwise(rows: Iterable[Row]) -> list[Row]:
    """Some of the rows, in which every two values that stand together in a row still do.

    What a mistake takes is nearly always one value or two that meet (Kuhn, Wallace and Gallo,
    "Software Fault Interactions and Implications for Software Testing", 2004).
    """
    left = {
        row: {
            (one, other, row[one], row[other])
            for one, other in itertools.combinations(range(len(row)), 2)
        }
        for row in rows
    }
    wanted = set().union(*left.values())
    chosen = []
    while wanted:
        best = max(left, key=lambda row: len(left[row] & wanted))
        wanted -= left.pop(best)
        chosen.append(best)
    return chosen


def with_depths(lenses: Mapping[str, Any]) -> list[Any]:
    """Parameters ``lens, depth``: each lens with opengl, and with the other ranges in turn."""
    others = itertools.cycle(("reversed", "direct3d"))
    return [
        pytest.param(lens, depth, id=f"{name}-{depth}")
        for name, lens in lenses.items()
        for depth in ("opengl", next(others))
    ]
