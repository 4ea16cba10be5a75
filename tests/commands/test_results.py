"""``lesson results``: a class's answers, marked again; files of strangers."""

import argparse
import csv
import io
import json
from pathlib import Path
from typing import Any

import pytest

from app.commands.results import results as command
from app.lessons import results
from app.lessons.course import Course
from app.lessons.lesson import read
from app.lessons.record import Attempt
from tests.support.commands import run_here
from tests.support.exercises import WIDE

LESSON = (
    """---
title: Angles
---
# One {#one}
```state
scene=letter-f
```
```exercise wide
"""
    + WIDE
    + """```
```exercise cells
vary s: 2..30
Scale by {=s} and {=s+1}.
matrix: s, 0; 0, s+1
```
```exercise set
vary wanted: 0.5..4 step 0.1
Set near to {=wanted}.
until: near = wanted
wrong far: far = wanted
  says: That is far.
```
```predict say
Which?
- [x] this
- [ ] that
```
"""
)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "own.md").write_text(LESSON, encoding="utf-8")
    return tmp_path


def run(*files: str, table: str | None = None) -> int:
    """Run the command in the current folder, where the lesson is."""
    return command(argparse.Namespace(csv=table), files)


def answer(block: str, seed: int, typed: str, verdict: str = "wrong", **more: Any) -> Attempt:
    made = Attempt(1_700_000_000, "/folder/of/ana/own.md", f"one/{block}", seed, typed, verdict)
    return made._replace(**more)


def exported(*attempts: Attempt, student: str = "") -> dict[str, Any]:
    """The file that a student with such a record exports."""
    made = json.loads(results.to_json(student, attempts, "0.1.0"))
    assert isinstance(made, dict)
    return made


def rows(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(path.read_text(encoding="utf-8-sig"), newline="")))


def test_every_mark_comes_from_what_was_typed(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    # By hand: seed 1 draws 30° and 2 (tests/lessons/test_exercise.py): 2 atan(2 tan 15°) = 56.374°.
    here = Course(read(folder / "own.md")).at(0)
    wanted = float(here.asked["set"].variant(here, 1).numbers["wanted"])  # type: ignore[attr-defined]
    tree = exported(
        answer("wide", 1, "56.4", "right"),
        answer("wide", 1, "60", "right"),  # edited: it is the idea that angles grow like widths
        answer("wide", 1, "77", "right", idea="angle-linear"),  # edited
        answer("wide", 1, "@SUM(A1)", "wrong"),
        answer("wide", 1, "", "shown"),
        answer("set", 1, f"lens.near=0.1 lens.far={wanted}"),
        answer("say", 0, "1", "wrong"),  # edited downwards
        answer("gone", 1, "1", "right"),
        answer("wide", 1, "60", lesson="x" * 300),
        student="=cmd|' /C calc'!A0",
    )
    assert "ana" not in json.dumps(tree), "no folder that may name the student"
    (folder / "a.json").write_text(json.dumps(tree), encoding="utf-8")
    tree["lessons"] = {"own.md": "0123"}
    tree["answers"] = [answer("wide", 1, "60", lesson="own.md")._asdict()]
    (folder / "b.json").write_text(json.dumps(tree), encoding="utf-8")
    assert run("a.json", "b.json", table="out.csv") == 0
    said = capsys.readouterr().out
    assert "2 files, 10 answers: 2 right, 5 wrong, 1 shown, 2 not marked\n" in said
    assert "3 marks not as in the files" in said and "    2    2  angle-linear  " in said
    assert "    1    1  own.md: far  That is far.\n" in said
    assert "    1  own.md one/wide 1: 77 (56.374)" in said
    found = rows(folder / "out.csv")
    assert [row["mark"] for row in found] == [
        "right", "wrong", "wrong", "wrong", "shown", "wrong", "right", "", "", "wrong",
    ]  # fmt: skip
    assert [row["idea"] for row in found if row["idea"]] == [
        "angle-linear", "far", "angle-linear",
    ]  # fmt: skip
    assert found[0]["right"] == "56.374" and found[0]["time"] == "2023-11-14T22:13:20+00:00"
    assert {row["student"] for row in found} == {"'=cmd|' /C calc'!A0"}
    assert found[3]["typed"] == "'@SUM(A1)" and found[1]["note"] == "the file says right"
    assert found[-1]["note"] == "the student had another version of the lesson"
    assert found[-2]["note"] == "no such question here"


def test_files_of_one_name_are_told_apart(folder: Path) -> None:
    """A class hands in `result.json`, as the window proposes, each in a folder."""
    for when, name in enumerate("ab"):
        (folder / name).mkdir()
        tree = exported(answer("wide", 1, "56.4", "right", when=when))
        (folder / name / "result.json").write_text(json.dumps(tree), encoding="utf-8")
    assert run("a/result.json", "b/result.json", table="out.csv") == 0
    assert [row["file"] for row in rows(folder / "out.csv")] == ["a/result.json", "b/result.json"]


def test_an_answer_that_is_given_twice_counts_once(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The same file twice, under two names, and in the whole record that is handed in later."""
    early, late = (answer("wide", 1, typed, when=n) for n, typed in enumerate(("60", "56.4")))
    given = {"test": [early], "copy": [early], "record": [early, late, late]}
    for name, attempts in given.items():
        text = json.dumps(exported(*attempts, student="Ana"))
        (folder / f"{name}.json").write_text(text, encoding="utf-8")
    (folder / "other.json").write_text(json.dumps(exported(early, student="Bo")), encoding="utf-8")
    files = "test.json", "test.json", "copy.json", "record.json", "other.json"
    assert run(*files, table="out.csv") == 0
    counts, left_out, *_ = capsys.readouterr().out.splitlines()
    assert counts == "5 files, 3 answers: 1 right, 2 wrong, 0 shown, 0 not marked"
    assert left_out == "4 answers left out: already in these files"
    found = [(row["file"], row["typed"]) for row in rows(folder / "out.csv")]
    assert found == [("test.json", "60"), ("record.json", "56.4"), ("other.json", "60")]


def test_a_test_has_no_hints_in_a_table_either(folder: Path) -> None:
    """Older programs counted all hints of a test as read, and did not say what was a test."""
    key = {"lesson": "l03-field-of-view", "exercise": "practise-1/alpha"}
    told = [answer("", seed, "62.5", hints=2)._replace(**key) for seed in (5000, 1)]
    tree = exported(*told, told[0]._replace(seed=7000, is_test=False))
    for each in tree["answers"][:2]:
        del each["is_test"]
    (folder / "ana.json").write_text(json.dumps(tree), encoding="utf-8")
    assert run("ana.json", table="out.csv") == 0
    assert [row["hints"] for row in rows(folder / "out.csv")] == ["0", "2", "2"]


def test_what_was_typed_in_every_form_is_marked(folder: Path) -> None:
    course = Course(read(folder / "own.md"))
    marker = results.Marker()

    def word(block: str, seed: int, typed: str) -> str:
        return marker.marked(answer(block, seed, typed, lesson="own.md")).word

    wanted = float(course.at(0).asked["set"].variant(course.at(0), 4).numbers["wanted"])  # type: ignore[attr-defined]
    s = int(course.at(0).asked["cells"].variant(course.at(0), 4).numbers["s"])  # type: ignore[attr-defined]
    assert word("set", 4, f"lens.near={wanted}") == "right"
    assert word("set", 4, "lens.near=x") == word("set", 4, "scene=/etc/passwd") == "wrong"
    assert word("cells", 4, f"{s} | 0; 0 | {s + 1}") == "right" != word("cells", 4, f"{s} | 0; 0")
    assert word("say", 0, "2") == "wrong" == word("say", 0, "x") and word("wide", 0, "1") == ""
    assert marker.marked(answer("cells", 4, "", lesson="own.md")).right == f"{s} | 0; 0 | {s + 1}"


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "is not a file of results"), (b"\xff\xfe", "is not a file of results"),
        (b"[" * 100_000, "is not a file of results"), (b"[]", "is not a file of results"),
        (b'{"format": "frustum-lab"}', "is not a file of results"),
        (b'{"format": "frustum-lab-results", "version": 2, "answers": []}', "by a newer"),
        (b'{"format": "frustum-lab-results", "version": 1, "answers": [7]}', "attempt must be"),
        (b" " * (2**22 + 1), "is larger than 4 MiB"),
        (b'{"format": "frustum-lab-results", "version": 1, "answers": [%s]}'
         % b",".join([b"1"] * 5001), "has more than 5000 answers"),
        (b'{"format": "frustum-lab-results", "version": 1, "answers": [], "student": "a\\nb"}',
         "student must be one line"),
    ],
)  # fmt: skip
def test_a_bad_file_gets_a_sentence_and_the_others_go_on(
    folder: Path, content: bytes, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "bad.json").write_bytes(content)
    good = exported(answer("wide", 1, "56.4", "right"))
    (folder / "good.json").write_text(json.dumps(good), encoding="utf-8")
    assert run("bad.json", "none.json", "good.json") == 2
    out, err = capsys.readouterr()
    bad, none = err.splitlines()
    assert bad.startswith("bad.json") and said in bad and "none.json does not exist." in none
    assert "1 file, 1 answer: 1 right" in out


def test_a_file_of_results_is_read_in_every_encoding(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = json.dumps(exported(answer("wide", 1, "56.4", "right")))
    for encoding in ("utf-8-sig", "utf-16", "utf-16-le"):
        (folder / "good.json").write_bytes(text.encode(encoding))
        assert run("good.json") == 0
        assert "1 file, 1 answer: 1 right" in capsys.readouterr().out


def test_its_options_are_its_own() -> None:
    assert "lesson results needs a FILE." in run_here("lesson", "results").stderr
    assert (
        "--csv: is an option of lesson results" in run_here("lesson", "list", "--csv", "a").stderr
    )
    assert "--key: is an option" in run_here("lesson", "results", "a.json", "--key").stderr


def test_a_lesson_is_found_by_its_bare_name_only() -> None:
    for name in ("../own.md", "/etc/own.md", "nothing.md", "", "."):
        assert results.Marker().marked(answer("wide", 1, "1", lesson=name)).word == ""
