"""Running measurements: in turns, for a limited time, stopped or paused from outside.

Everything is timed in interleaved rounds, each choice once in every round, so that what else the
machine does falls on all of them alike; medians and 95th percentiles are kept.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple, TypeAlias

from app.measure.results import Trade
from app.model.refusal import Cancelled

_SHORTEST = 1e-3
"""Seconds that a timing takes at least: shorter runs are repeated, and divided."""
_LEAST_ROUNDS = 5


Watch: TypeAlias = Callable[[float], None]
"""Who waits for a measurement.

It is called with the fraction done, before every timing; it waits while others need the machine,
and raises `Cancelled` when the measurement is not wanted any more.
"""


def unwatched(_fraction: float) -> None:
    """Nobody waits."""


def part_of(watch: Watch, first: float, last: float) -> Watch:
    """A watch for a part of the whole, from one fraction to another."""

    def watch_part(fraction: float) -> None:
        watch(first + (last - first) * fraction)

    return watch_part


class Times(NamedTuple):
    """Seconds of one run: its median, its 95th percentile, and how many rounds there were."""

    median: float
    p95: float
    rounds: int


def in_turns(
    runs: Mapping[str, Callable[[], Any]], seconds: float, watch: Watch = unwatched
) -> dict[str, Times]:
    """Time each run, one after the other, round after round.

    Parameters
    ----------
    runs : mapping of str to callable
    seconds : float
        For all of them together; at least a few rounds are made whatever they take.
    watch : Watch

    Returns
    -------
    dict of str to Times

    Raises
    ------
    Cancelled
        By `watch`; with the times of those that were run.
    """
    taken: dict[str, list[float]] = {name: [] for name in runs}

    def times() -> dict[str, Times]:
        return {
            name: Times(statistics.median(each), percentile95(each), len(each))
            for name, each in taken.items()
            if each
        }

    try:
        repeats = {}
        for name, run in runs.items():
            watch(0.0)
            run()  # the first one warms caches up
            began = time.perf_counter()
            run()
            repeats[name] = max(1, round(_SHORTEST / max(time.perf_counter() - began, 1e-9)))
        start = time.perf_counter()
        rounds, spent = 0, 0.0
        while rounds < _LEAST_ROUNDS or spent < seconds:
            for name, run in runs.items():
                watch(min(rounds / _LEAST_ROUNDS, spent / max(seconds, 1e-9), 1.0))
                began = time.perf_counter()
                for _ in range(repeats[name]):
                    run()
                taken[name].append((time.perf_counter() - began) / repeats[name])
                spent = time.perf_counter() - start
            rounds += 1
    except Cancelled as cancelled:
        raise Cancelled(times()) from cancelled
    return times()


def timed(
    trade: Trade,
    runs: Mapping[str, Callable[[], Any]],
    seconds: float,
    per_second: float,
    watch: Watch = unwatched,
) -> Trade:
    """A trade with what its choices cost, timed in turns.

    Parameters
    ----------
    trade : Trade
        Without costs.
    runs : mapping of str to callable
        By the choices' names; what has no run gets no cost.
    seconds : float
        As for `in_turns`.
    per_second : float
        How many of the cost's units a second of one run is.
    watch : Watch

    Raises
    ------
    Cancelled
        By `watch`; with the costs so far.
    """
    complete = True
    try:
        times = in_turns(runs, seconds, watch)
    except Cancelled as cancelled:
        times, complete = cancelled.partial, False
    choices = []
    for choice in trade.choices:
        if choice.name in times:
            median, p95, _ = times[choice.name]
            choice = replace(choice, cost=per_second * median, cost_p95=per_second * p95)
        choices.append(choice)
    rounds = min((each.rounds for each in times.values()), default=0)
    found = replace(trade, choices=tuple(choices), rounds=rounds, complete=complete)
    if not complete:
        raise Cancelled(found)
    return found


def percentile95(times: list[float]) -> float:
    """The 95th percentile; of few values, the largest."""
    if len(times) < 2:
        return times[0]
    return statistics.quantiles(times, n=20, method="inclusive")[-1]
