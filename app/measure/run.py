"""Timing: interleaved rounds until the least times are steady, which a watch may pause or cancel.

Each round runs every choice once, so that other load on the machine affects all choices alike. Load
only adds to a time, so the least one is that of the work, and the spread is that of the machine.
"""

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from app.measure.results import STEADY, Trade
from app.model.refusal import Cancelled

_SHORTEST = 1e-3  # least duration of one timing in seconds; shorter runs are repeated and averaged
LEAST_ROUNDS = 7  # also the number of rounds whose least time must repeat that of all before
MOST_ROUNDS = 2000
_LEAST_PART = 0.2  # of the given time: load that lasts for less is no part of the result

Watch: TypeAlias = Callable[[float], None]
"""Called with the finished fraction before every timing.

It waits while others need the machine, and raises `Cancelled` to stop the measurement.
"""


def unwatched(_fraction: float) -> None:
    """Neither wait nor cancel."""


def part_of(watch: Watch, first: float, last: float) -> Watch:
    return lambda fraction: watch(first + (last - first) * fraction)


class Times(NamedTuple):
    """Least time and 95th percentile of one run in seconds, the number of rounds, and `steady`."""

    least: float
    p95: float
    rounds: int
    is_steady: bool


def in_turns(
    runs: Mapping[str, Callable[[], Any]], seconds: float, watch: Watch = unwatched
) -> dict[str, Times]:
    """Time each run, round after round, until all are `steady`, or for some `seconds` in all.

    A `Cancelled` that `watch` raises has the times so far.
    """
    taken: dict[str, list[float]] = {name: [] for name in runs}

    def times() -> dict[str, Times]:
        return {
            name: Times(min(each), float(np.percentile(each, 95)), len(each), steady(each))
            for name, each in taken.items()
            if each
        }

    try:
        repeats = {}
        for name, run in runs.items():
            watch(0.0)
            run()  # warm up the caches
            began = time.perf_counter()
            run()
            repeats[name] = max(1, round(_SHORTEST / max(time.perf_counter() - began, 1e-9)))
        rounds, spent = 0, 0.0
        while rounds < LEAST_ROUNDS or (
            spent < seconds
            and rounds < MOST_ROUNDS
            and not (spent > _LEAST_PART * seconds and all(map(steady, taken.values())))
        ):
            for name, run in runs.items():
                watch(min(rounds / LEAST_ROUNDS, spent / max(seconds, 1e-9), 1.0))
                began = time.perf_counter()
                for _ in range(repeats[name]):
                    run()
                took = time.perf_counter() - began
                taken[name].append(took / repeats[name])
                spent += took
            rounds += 1
    except Cancelled as cancelled:
        raise Cancelled(times()) from cancelled
    return times()


def steady(times: Sequence[float]) -> bool:
    """Whether the last rounds repeat the least time of all before, to a part of `STEADY`."""
    before, last = times[:-LEAST_ROUNDS], times[-LEAST_ROUNDS:]
    return bool(before) and abs(min(before) - min(last)) <= STEADY * min(times)


def timed(
    trade: Trade,
    runs: Mapping[str, Callable[[], Any]],
    seconds: float,
    per_second: float,
    watch: Watch = unwatched,
    same: Mapping[str, str] = MappingProxyType({}),
) -> Trade:
    """Add the costs of the choices to a trade, timed by `in_turns`.

    The runs have the choices' names, which `same` gives to choices of the same work; a choice
    without a run gets no cost. A second of one run costs `per_second` units.

    A `Cancelled` that `watch` raises has the costs so far.
    """
    complete = True
    try:
        times = in_turns(runs, seconds, watch)
    except Cancelled as cancelled:
        times, complete = cancelled.partial, False
    choices = []
    for choice in trade.choices:
        took = times.get(same.get(choice.name, choice.name))
        if took is not None:
            cost, p95 = per_second * took.least, per_second * took.p95
            choice = replace(choice, cost=cost, cost_p95=p95, steady=took.is_steady)
        choices.append(choice)
    rounds = min((each.rounds for each in times.values()), default=0)
    measured = replace(trade, choices=tuple(choices), rounds=rounds, complete=complete)
    if not complete:
        raise Cancelled(measured)
    return measured
