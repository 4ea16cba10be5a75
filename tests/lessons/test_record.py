"""The record of a student's answers: its file, and what follows from it."""

import itertools
import json
import os
from datetime import date, timedelta
from pathlib import Path

import pytest

from app.lessons import record
from app.lessons.record import Attempt, Record, corrected, due, ideas_met, minutes_each, standings
from app.model.refusal import Refusal

DAY_S = 86_400
NOON = 1_700_000_000 - 1_700_000_000 % DAY_S + DAY_S // 2
"""A noon in Greenwich, far enough from midnight in most time zones."""


def attempt(seed: int = 1, verdict: str = "right", *, day: int = 0, **more: object) -> Attempt:
    made = Attempt(NOON + day * DAY_S, "l03", "practise/wide", seed, "91.5", verdict)
    return made._replace(**more)


def today(day: int) -> date:
    return date.fromtimestamp(NOON + day * DAY_S)


def test_what_is_added_is_read_again_also_by_another_window(tmp_path: Path) -> None:
    path = tmp_path / "new" / "record.jsonl"
    one, other = Record(path), Record(path)
    said = [
        attempt(typed="−√3/2 °"),
        attempt(2, "wrong", typed="0", idea="angle-linear", hints=2),
        attempt(3, "shown", typed="", exercise="a/b", is_test=False),
        attempt(4, is_test=True),
    ]
    for place, each in enumerate(said):
        (one, other)[place % 2].add(each)
    assert one.read() == other.read() == said and one.problem is None
    assert Record(tmp_path / "none").read() == []


@pytest.mark.parametrize(
    "bad",
    [
        b"{", b"[]", b"7", b"\xff\xfe{}", b'"' + b"[" * 100_000, b"[" * 100_000,
        b"{}", b'{"when": 1, "lesson": "a", "exercise": "b", "seed": 1}',
        *(
            json.dumps(attempt()._asdict() | change).encode()
            for change in (
                {"when": -1}, {"when": True}, {"when": 1e400}, {"when": 10**30}, {"seed": 10_000},
                {"seed": "1"}, {"typed": 7}, {"typed": "x" * 2001}, {"typed": "\ud800"},
                {"typed": "a\nb"}, {"lesson": None}, {"verdict": "good"}, {"hints": 101},
                {"is_test": 1}, {"is_test": "no"},
            )
        ),
        b'{"when": ' + b"9" * 5000 + b"}",
    ],
)  # fmt: skip
def test_the_good_lines_of_a_damaged_file_stay(tmp_path: Path, bad: bytes) -> None:
    kept = Record(tmp_path / "record.jsonl")
    kept.add(attempt(1))
    with (tmp_path / "record.jsonl").open("ab") as file:
        file.write(b"\n" + bad)  # and no line break after it
    kept.add(attempt(2))
    assert [each.seed for each in kept.read()] == [1, 2]
    assert str(kept.problem) == (
        f"{tmp_path / 'record.jsonl'} has unreadable lines (1), which are left out."
    )


def test_a_line_that_another_program_wrote_in_latin_1_stays(tmp_path: Path) -> None:
    line = json.dumps(attempt(typed="30 °")._asdict(), ensure_ascii=False)
    (tmp_path / "record.jsonl").write_bytes(line.encode("latin-1"))
    assert Record(tmp_path / "record.jsonl").read() == [attempt(typed="30 °")]


def test_a_full_file_becomes_the_old_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(record, "LARGEST", 1000)
    path = tmp_path / "record.jsonl"
    for seed in range(1, 100):
        Record(path).add(attempt(seed))
    seeds = [each.seed for each in Record(path).read()]
    assert seeds == list(range(seeds[0], 100)) and len(seeds) > 7, "the newest are all there"
    assert sum(file.stat().st_size for file in tmp_path.iterdir()) < 2300
    path.write_bytes(b"x" * 50_000)  # somebody else's
    Record(path).add(attempt(99))
    assert [each.seed for each in Record(path).read()][-1] == 99


def test_an_answer_is_written_whole_if_the_system_takes_it_in_parts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write = os.write
    monkeypatch.setattr(os, "write", lambda file, line: write(file, line[:7]))
    kept = Record(tmp_path / "record.jsonl")
    kept.add(attempt(1))
    kept.add(attempt(2))
    assert [each.seed for each in kept.read()] == [1, 2] and kept.problem is None


def test_what_is_no_file_is_refused_in_a_sentence(tmp_path: Path) -> None:
    folder = Record(tmp_path)
    with pytest.raises(Refusal, match="cannot be written"):
        folder.add(attempt())
    assert folder.read() == [] and "cannot be read" in str(folder.problem)


def test_an_exercise_is_solved_alone_at_the_first_try_without_a_hint() -> None:
    for attempts, outcome in (
        ([attempt()], "alone"),
        ([attempt(verdict="wrong")], ""),
        ([attempt(verdict="wrong"), attempt()], "helped"),
        ([attempt(hints=1)], "helped"),
        ([attempt(verdict="shown")], "shown"),
        ([attempt(verdict="shown"), attempt()], "shown"),  # its answer is known
        ([attempt(verdict="shown"), attempt(2)], "alone"),
        ([attempt(), attempt(2, "wrong")], ""),
    ):
        assert standings(attempts)["l03", "practise/wide"].outcome == outcome, attempts


def test_what_was_not_solved_alone_comes_back_after_1_3_and_7_days() -> None:
    said = [attempt(verdict="wrong"), attempt()]

    def come_back(day: int) -> bool:
        (standing,) = standings(said).values()
        assert not (standing.due and standing.due < today(0))
        return bool(due(standings(said), today(day)))

    assert not come_back(0) and come_back(1)
    said.append(attempt(2))  # too early: it comes back all the same
    assert come_back(1)
    said.append(attempt(3, day=1))
    assert not come_back(3) and come_back(4)
    said.append(attempt(4, day=5))
    assert not come_back(11) and come_back(12)
    assert not due(standings([*said, attempt(5, day=12)]), today(10_000))
    said.append(attempt(5, "shown", day=12))
    assert not come_back(12) and come_back(13)
    assert standings([attempt()])["l03", "practise/wide"].due is None
    assert not due(standings([attempt(0, "wrong")]), today(9)), "its numbers never change"


def test_what_waits_longest_comes_first_and_ideas_are_counted() -> None:
    said = [
        attempt(1, "wrong", idea="a", day=1),
        attempt(1, "wrong", idea="a", exercise="x/y"),
        attempt(1, "wrong", idea="b", lesson="l04"),
    ]
    known = standings(said)
    assert due(known, today(2))[0] == ("l03", "x/y") and len(known) == 3
    assert known["l03", "x/y"].due == today(0) + timedelta(days=1)
    assert ideas_met(said, known) == {("l03", "a"): (2, ""), ("l04", "b"): (1, "")}
    said.append(attempt(1, exercise="x/y"))
    assert ideas_met(said, standings(said))["l03", "a"] == (2, "helped"), "as where it was met last"


def test_an_exercise_takes_as_long_as_most_have_taken() -> None:
    assert minutes_each([]) == 2.0

    def answers(*gaps: int, seeds: int = 9) -> list[Attempt]:
        times = itertools.accumulate(gaps, initial=1_700_000_000)
        return [attempt(1 + n % seeds)._replace(when=when) for n, when in enumerate(times)]

    assert minutes_each(answers(60, 60, 60, 60)) == 2.0, "they are too few"
    assert minutes_each(answers(60, 90, 30, 90, 3000, 90)) == 1.5, "a pause does not count"
    assert minutes_each(answers(60, -50, 60, 60, 60, 180)) == 1.0, "nor a clock that is set back"
    assert minutes_each(answers(*[40] * 11, seeds=6)) == 80 / 60, "all tries at a variant do"
    assert minutes_each([each._replace(seed=0) for each in answers(*[30] * 8)]) == 2.0


def test_the_hints_that_older_programs_counted_in_tests_are_left_out() -> None:
    """All hints counted as read there; practice begins at 1 and goes on from a seed it has seen."""

    def hints(*said: Attempt) -> list[int]:
        known = {("l03", "practise/wide"): 2}
        return [each.hints for each in corrected(said, lambda key: known.get(key, 0))]

    assert hints(attempt(5000, hints=2), attempt(77, "wrong", hints=2)) == [0, 0]
    (standing,) = standings(corrected([attempt(5000, hints=2)], lambda _key: 2)).values()
    assert standing.outcome == "alone"
    for said in (
        [attempt(5000, hints=1)],  # not all
        [attempt(5000, hints=2, lesson="own/own.md")],  # tests do not ask it
        [attempt(1, hints=2), attempt(3, hints=2)],
        [attempt(5000, "wrong"), attempt(5000, hints=2), attempt(5001, hints=2)],
        [attempt(5000, hints=2, is_test=False)],  # this program says so
    ):
        assert hints(*said) == [each.hints for each in said], said
