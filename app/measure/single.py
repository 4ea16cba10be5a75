"""Results with a single trade or sweep, by its name, and their tables below each other."""

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

from app.measure.chart import TITLES, machine
from app.measure.results import Measurements, Sweep, Trade, from_json, table
from app.model.refusal import REFUSALS, Refusal
from app.strangers import decode, open_regular

SHIPPED = Path(__file__).with_name("content") / "letter-f.json"
"""The results that the program brings, of another machine; `tests/pictures.py` records them."""


def only_part(results: Measurements) -> Trade | Sweep:
    parts: list[Trade | Sweep] = [*results.trades, *results.sweeps]
    return parts[0]


def has_numbers(results: Measurements) -> bool:
    part = only_part(results)
    if isinstance(part, Trade):
        return bool(part.frontier)
    return any(error is not None for curve in part.curves.values() for error in curve.errors)


def split(results: Measurements) -> dict[str, Measurements]:
    """Split results by the names of their trades and sweeps."""
    parts = {
        trade.name: replace(results, trades=(trade,), sweeps=(), complete=trade.complete)
        for trade in results.trades
    }
    return parts | {
        sweep.parameter: replace(results, trades=(), sweeps=(sweep,), complete=sweep.complete)
        for sweep in results.sweeps
    }


def read_results(path: Path) -> Measurements:
    with open_regular(path) as file:
        text, _ = decode(file.read())
    results = from_json(text, path.name)
    for name in split(results):
        if name not in TITLES:
            why = f"{json.dumps(name)} is nothing that is measured"
            raise Refusal.saying(REFUSALS["results-damaged"], path.name, why)
    return results


@cache
def shipped() -> dict[str, Measurements]:
    """Return the results that the program brings, each with a single trade or sweep."""
    return split(read_results(SHIPPED))


def rows_of_other(other: Measurements, all_digits: bool) -> tuple[list[str], list[list[str]]]:
    """The table of a file's results; its last column, the only wide one, names the machine."""
    heads, *rows = table(only_part(other), all_digits=all_digits)
    name = machine(other)
    return heads, [[*cells, "; ".join(filter(None, (name, note)))] for *cells, note in rows]


def joined_tables(
    heads: list[str], rows: list[list[str]], other_heads: list[str], other_rows: list[list[str]]
) -> tuple[list[str], list[list[str]]]:
    """Join two tables vertically; columns that only the second has come second to last."""
    middle = list(dict.fromkeys([*heads[1:-1], *other_heads[1:-1]]))
    joined = []
    for names, each in ((heads, rows), (other_heads, other_rows)):
        for row in each:
            cells = dict(zip(names[1:-1], row[1:-1], strict=True))
            joined.append([row[0], *(cells.get(name, "-") for name in middle), row[-1]])
    return [heads[0], *middle, heads[-1]], joined
