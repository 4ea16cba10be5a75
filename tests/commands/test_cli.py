"""The command line as a user types it: `python3 -m app ...` in a process of its own."""

import contextlib
import csv
import errno
import io
import itertools
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import fields, replace
from importlib import metadata
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image

from app.__main__ import command_first
from app.bootstrap import ROOT
from app.commands import cli, options
from app.document.document import Document
from app.document.files import read, write
from app.document.settings import set_values
from app.document.view import View
from app.drawings.figure import ENDINGS, FITS, HIDDEN
from app.drawings.style import PALETTES
from app.lessons.contents import CONTENT, file_of
from app.model.chain import SPACES
from app.model.limits import SMALLEST_WINDOW, DepthRange
from app.model.projection import (
    LARGEST,
    PLANES,
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
    Stage,
)
from app.picking.picking import Probe
from app.precision.levels import PRECISIONS, Precision, predict, trace
from app.precision.quality import Quality
from app.scenes.scene import load
from tests import PATIENCE_S
from tests.oracles import exact
from tests.support.commands import (
    comma_locale,
    one_sentence,
    refused,
    refused_by_a_process,
    run,
    run_here,
)
from tests.support.drawings import colours_of
from tests.support.unreachable import unreachable
from widgets.program import application

__all__ = ["comma_locale"]

# Numbers that a hand can follow: cot(90/2) = 1, the aspect is 2, near 1 and far 9.
BY_HAND = Document(
    "letter-f",
    Projection(
        Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
        Perspective(90.0, 1.0, 9.0),
        (200, 100),
    ),
)


@pytest.mark.parametrize("asked", [["--language", "hr"], ["--language=hr"]])
def test_a_language_may_stand_before_the_command(asked: list[str]) -> None:
    assert command_first([*asked, "lesson", "list"]) == ["lesson", *asked, "list"]
    for words in ([], ["--set", "lens.near=2"], ["--", "own.json"]):
        assert command_first([*asked, *words]) == [*asked, *words]


def test_what_is_refused_ends_a_process_with_its_sentence_and_status() -> None:
    for arguments in (("matrices", "--set", "lens.near=abc"), ("export", "no-picture.txt")):
        assert refused_by_a_process(*arguments) == refused(*arguments)


@pytest.fixture
def by_hand(tmp_path: Path) -> Path:
    path = tmp_path / "by hand.json"
    write(BY_HAND, path)
    return path


@pytest.fixture
def one_point(tmp_path: Path) -> Path:
    path = tmp_path / "point.csv"
    path.write_text("0.1,1234567.5,1e-9\n", encoding="utf-8")
    return path


# --------------------------------------------------------------------------- project


def project(*arguments: str | Path, points: str) -> list[dict[str, Any]]:
    done = run_here("project", *arguments, "-", "--format", "json", text=points)
    assert (done.returncode, done.stderr) == (0, "")
    found: list[dict[str, Any]] = json.loads(done.stdout)["points"]
    return found


def test_json_is_exactly_the_trace_of_the_model(by_hand: Path) -> None:
    rng = np.random.default_rng(7)
    points = rng.normal(scale=6.0, size=(200, 3))
    projection = Projection(
        Camera((3.1, 2.7, 9.3), (0.1, 0.2, 0.3), (0.1, 1.0, 0.0)),
        Perspective(37.0, 0.01, np.inf),
        (1366, 768),
        "reversed",
    )
    write(Document("letter-f", projection), by_hand)
    text = "".join(f"{x!r},{y!r},{z!r}\n" for x, y, z in points.tolist())
    done = run_here("project", by_hand, "-", "--format=json", text=text)
    answer = json.loads(done.stdout)
    traced = projection.trace(points)
    assert list(answer) == ["points", "matrices", "rung", "predicted_error_px", "predictions"]
    assert list(answer["matrices"]) == ["view_from_world", "clip_from_view", "clip_from_world"]
    for name, matrix in answer["matrices"].items():
        assert np.array_equal(matrix, stage_of(projection, name).matrix)
    keys = ["world", "view", "clip", "ndc", "image", "depth", "inside", "outside_of"]
    for i, point in enumerate(answer["points"]):
        assert list(point) == keys
        for name in ("world", "view", "clip"):
            assert point[name] == getattr(traced, name)[i].tolist()
        for name in ("ndc", "image", "depth"):
            value = getattr(traced, name)[i].tolist() if traced.in_front[i] else None
            assert point[name] == value
        assert point["inside"] == (traced.in_front[i] and not traced.outside[i].any())
        assert point["outside_of"] == [PLANES[k] for k in np.flatnonzero(traced.outside[i])]
    assert {point["inside"] for point in answer["points"]} == {True, False}
    assert any(point["ndc"] is None for point in answer["points"])
    predictions = predict(projection, points)
    assert predictions is not None and answer["rung"] == "float64"
    assert answer["predictions"] == {precision: p._asdict() for precision, p in predictions.items()}
    assert answer["predicted_error_px"] == predictions["float64"].px


def stage_of(projection: Projection, name: str) -> Stage:
    (stage,) = (s for s in (*projection.stages, *projection.direct_stages) if s.name == name)
    return stage


@pytest.mark.parametrize("precision", PRECISIONS)
def test_a_forced_precision_computes_the_numbers(by_hand: Path, precision: Precision) -> None:
    done = run_here(
        "project", by_hand, "-", "--format=json", f"--rung={precision}", text="0.1,0.7,-1e-3\n"
    )
    answer = json.loads(done.stdout)
    points = np.array([[0.1, 0.7, -1e-3]])
    predictions = predict(BY_HAND.projection, points)
    assert predictions is not None
    assert (answer["rung"], answer["predicted_error_px"]) == (precision, predictions[precision].px)
    (point,), traced = answer["points"], trace(BY_HAND.projection, points, precision)
    for name in ("view", "clip", "ndc", "image"):
        assert point[name] == getattr(traced, name)[0].tolist()
    assert point["depth"] == traced.depth[0]
    table = run_here("project", by_hand, "-", f"--rung={precision}", text="0.1,0.7,-1e-3\n").stdout
    assert f"\ncomputed in {precision}; errors are below: float32 " in table


def test_numbers_are_exact_where_float64_would_lose_too_many_digits(by_hand: Path) -> None:
    near_next_to_far = ("--set=lens.near=1", "--set=lens.far=1.0000000000001")
    command = ("project", by_hand, "-", "--format=json", *near_next_to_far)
    answer = json.loads(run_here(*command, text="0.3,0.2,3.9999999999995\n").stdout)
    assert answer["rung"] == "exact"


def test_points_without_a_picture_have_no_error_and_an_infinite_one_is_written_in_words(
    by_hand: Path,
) -> None:
    done = run_here("project", by_hand, "-", "--format=json", text="2,1,6\n2,1,5\n")
    answer = json.loads(done.stdout)
    expected = {"rung": "float64", "predicted_error_px": None, "predictions": {}}
    assert {name: answer[name] for name in expected} == expected
    assert "computed" not in run_here("project", by_hand, "-", text="2,1,6\n").stdout
    # float32 ends at 3e38.
    answer = json.loads(
        run_here("project", by_hand, "-", "--format=json", text="0,1e39,-1e40").stdout
    )
    assert answer["predictions"]["float32"] == {"px": "inf", "depth": "inf"}
    assert (answer["rung"], answer["points"][0]["view"]) == ("float64", [0.0, 1e39, -1e40])


@pytest.mark.parametrize("w", ["", ",1"])
def test_only_a_point_beyond_the_numbers_of_float32_has_none(by_hand: Path, w: str) -> None:
    """The others are the same as without it."""
    rows = [f"{row}{w}" for row in ("0,0,0", "0,1e39,-1e40", "2,1,1")]
    head = f"x,y,z{w and ',w'},name"
    text = "\n".join([head, *(f"{row},p{i}" for i, row in enumerate(rows))])
    fewer = "\n".join([head, f"{rows[0]},p0", f"{rows[2]},p2"])
    arguments = ("project", by_hand, "-", "--rung=float32")
    why = "float32 cannot hold its numbers"

    first, lost, last = json.loads(run_here(*arguments, "--format=json", text=text).stdout)[
        "points"
    ]
    others = json.loads(run_here(*arguments, "--format=json", text=fewer).stdout)["points"]
    assert [first, last] == others and last["columns"] == {"name": "p2"}
    assert lost["world"][:3] == [0.0, 1e39, -1e40] and lost["columns"] == {"name": "p1"}
    unknown = ("view", "clip", "ndc", "image", "depth", "inside", "outside_of")
    assert lost["reason"] == why and all(lost[key] is None for key in unknown)

    told = run_here(*arguments, "--format=csv", text=text).stdout
    table = [*csv.DictReader(told.splitlines())]
    assert [row["reason"] for row in table] == ["", why, ""]
    assert {key: value for key, value in table[1].items() if value} == {
        "world_x": "0.0", "world_y": "1e+39", "world_z": "-1e+40", "name": "p1", "reason": why,
        **({"world_w": "1.0"} if w else {}),
    }  # fmt: skip
    plain = run_here(*arguments, "--format=csv", text=fewer).stdout
    assert [{**row, "reason": ""} for row in csv.DictReader(plain.splitlines())] == table[::2]

    blocks = run_here(*arguments, text=text).stdout.split("\npoint ")[1:]
    assert blocks[1].count(f"none: {why}\n") == 5 and "1e+39" in blocks[1] and "p1" in blocks[1]
    assert "none" not in blocks[2] and "inside" in blocks[2] and "inside" not in blocks[1]


def test_only_a_point_at_the_infinity_of_a_typed_view_has_no_numbers(tmp_path: Path) -> None:
    """w of view space is 1 - z/2, which is 0 for z = 2."""
    view = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,-0.5,1"
    clip = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1"
    typed = (f"--set=lens.clip_from_view={clip}", f"--set=lens.view_from_world={view}")
    for rung in ("float64", "exact"):
        done = run_here(
            "project", "-", "--set=lens.kind=matrix", *typed, "--format=json", f"--rung={rung}",
            text="0,0,2\n1,0,1\n",
        )  # fmt: skip
        lost, other = json.loads(done.stdout)["points"]
        assert lost["view"] is None and lost["reason"] == "its view coordinates are at infinity"
        assert other["view"] == [2.0, 0.0, 2.0]


def test_l13_a_fourth_column_is_w_and_0_is_a_direction(by_hand: Path) -> None:
    """Along -z: x and y in the middle of 200 x 100, z of the cube (9 + 1)/(9 - 1)."""
    text = "x,y,z,w\n0,0,-2,0\n4,2,2,2\n0,0,2,0\n1,0,0,0\n2,1,1\n"
    ahead, halved, behind, across, point = project(by_hand, points=text)
    assert ahead["world"] == ahead["view"] == [0, 0, -2, 0]
    assert ahead["clip"] == [0, 0, 2.5, 2]
    assert (ahead["ndc"], ahead["image"], ahead["depth"]) == ([0, 0, 1.25], [100, 50], 1.125)
    assert (ahead["inside"], ahead["outside_of"]) == (False, ["far"])
    assert halved["world"] == [2, 1, 1, 1] and halved == point
    assert [point["image"] for point in (behind, across)] == [None, None]
    done = run_here("project", by_hand, "-", "--format", "csv", text=text)
    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    assert [(row["world_w"], row["view_w"]) for row in rows] == [
        (w, w) for w in ("0.0", "1.0", "0.0", "0.0", "1.0")
    ]
    table = run_here("project", by_hand, "-", text=text).stdout
    assert re.search(r"^     world +0 +0 +-2 +0$", table, re.MULTILINE)
    assert table.count("none: the point at infinity is behind the eye") == 3
    assert table.count("none: the picture is at infinity too: w = 0") == 3
    last = run_here("project", by_hand, "-", text="0,0,-2,0\n").stdout.splitlines()[-1]
    assert last == "outside of  far"  # and no bound, of no finite point


def test_csv_has_the_same_numbers_as_json_and_empty_cells_for_null(by_hand: Path) -> None:
    points = "0.1,0.2,0.3\n0,0,6\n-90,0,1e-5\n"
    done = run_here("project", by_hand, "-", "--format", "csv", text=points)
    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    for row, point in zip(rows, project(by_hand, points=points), strict=True):
        for stage, axes in (("world", "xyz"), ("view", "xyz"), ("clip", "xyzw"), ("ndc", "xyz")):
            cells = [row[f"{stage}_{axis}"] for axis in axes]
            expected = point[stage]
            assert cells == (list(map(repr, expected)) if expected else [""] * len(axes))
        cells = [row["image_x_px"], row["image_y_px"]]
        assert cells == (list(map(repr, point["image"])) if point["image"] else ["", ""])
        assert row["depth"] == ("" if point["depth"] is None else repr(point["depth"]))
        assert row["inside"] == str(point["inside"]).lower()
        assert row["outside_of"] == " ".join(point["outside_of"])


def test_table_has_a_block_for_each_point_with_the_numbers_aligned(by_hand: Path) -> None:
    # One unit behind the eye: w = -1 and z_clip = -1.25*1 - 2.25.
    done = run_here("project", by_hand, "-", text="0,0,6\n0,0,0\n")
    errors = r"float32 (\S+) px, float64 (\S+) px, exact (\S+) px"
    last = re.fullmatch(
        f"computed in float64; errors are below: {errors}", done.stdout.split("\n")[-2]
    )
    assert last is not None
    # Of the middle of the picture, (100, 50), half an ulp is 7.105e-15.
    single, double, exactly = map(float, last.groups())
    assert 2.0**-47 < exactly == 7.2e-15 < double < 1e-12 < 1e-6 < single < 1e-3
    assert done.stdout.splitlines()[2:11] == [
        "point 1     x  y   z     w",
        "     world  0  0   6",
        "      view  0  0   1",
        "      clip  0  0  -3.5  -1",
        "       NDC  none: the point is not in front of the eye",
        "  image px  none: the point is not in front of the eye",
        "     depth  none: the point is not in front of the eye",
        "outside of  near, left, right, bottom, top",
        "",
    ]
    # Parallel rays, the window 4 wide and 2 high, at distance 4: z = 2*(4-1)/(9-1) - 1 = -0.25.
    sets = ["kind=orthographic", "left=-2", "right=2", "bottom=-1", "top=1"]
    arguments = [f"--set=lens.{value}" for value in sets]
    assert run_here("project", by_hand, "-", *arguments, text="1,0.5,1\n").stdout.splitlines()[
        2:-2
    ] == [
        "point 1       x       y     z     w",
        "     world    1       0.5   1",
        "      view    1       0.5  -4",
        "      clip    0.5     0.5  -0.25  1",
        "       NDC    0.5     0.5  -0.25",
        "  image px  150      25",
        "     depth    0.375",
        "    inside  the view volume",
    ]


def test_csv_of_many_programs_is_read() -> None:
    for text in (
        b"\xef\xbb\xbfx,y,z\r\n1,2,3\r\n", b"X, Y, Z\n\n1,2,3\n\n", b' 1 , 2 ,"3"\n',
        b"+1,2e0,.3e1", b"1,2,3\r", "x,y,z\n1,2,3\n".encode("utf-16"), b"1;2;3\n",
        b"1.000000000000000000e+00 2.000000000000000000e+00 3.000000000000000000e+00\n",
        b"# x y z\n# by hand\n1 2 3\n", b"  1\t 2  3 \n", b"1,\t2,\t3\n", b"z,x,y\n3,1,2\n",
        b"# points x, y and z\n1,2,3\n", b"sep=;\r\nx;y;z\r\n1,0;2,0;3\r\n", b"1,0\t2,0\t3\n",
        "1,2,3\n0,\u22121,-2\n".encode(), b"(1, 2, 3)\n", b"[[1. 2. 3.]\n [4. 5. 6.]]\n",
        b"2/2,4/2,3\n", b"1,0 2,0 3,0\n", b"(1,0  2 3)\n", b"P 1 2,0 3\n",
    ):  # fmt: skip
        done = run_here("project", "-", "--format", "json", text=text)
        assert json.loads(done.stdout)["points"][0]["world"] == [1, 2, 3], text


@pytest.mark.parametrize(
    ("text", "w", "columns"),
    [
        ("x\ty\tz\n1\t2\t3\n", None, None),
        ("1\t2\t3\t0\n", 0, None),
        ("x,y,z,name\n1,2,3,A\n", None, {"name": "A"}),
        ('X,Y,Z,W,name,n\n1,2,3,1,"A, ""b""",4\n', 1, {"name": 'A, "b"', "n": "4"}),
        ("x,y,z,weight\n1,2,3,7\n", None, {"weight": "7"}),
        ("x,y,z,name\n1,2,3\n", None, {"name": ""}),
        ("x\ty\tz\tname\n1\t2\t3\t=A, b\n", None, {"name": "=A, b"}),
        ("1,2,3,corner,7\n", None, {"column_4": "corner", "column_5": "7"}),
        ("1,2,3,\n", None, None),
        ("x,y,z\n1,2,3,é\n", None, {"column_4": "é"}),
        ("name,x,y,z\nA,1,2,3\n", None, {"name": "A"}),
        (",x,y,z\n0,1,2,3\n", None, {"column_1": "0"}),  # pandas
        ("n;w;Z;Y;X\n7;1;3;2;1\n", 1, {"n": "7"}),
        ("A 1 2 3 0\n", 0, {"column_1": "A"}),
        ('"A B"  1  2  3 \n', None, {"column_1": "A B"}),
    ],
)
def test_other_columns_of_the_points_are_kept(
    text: str, w: float | None, columns: dict[str, str] | None
) -> None:
    answer = run_here("project", "-", "--format", "json", text=text)
    (point,) = json.loads(answer.stdout)["points"]
    assert point["world"] == [1, 2, 3, *([] if w is None else [w])]
    assert point.get("columns") == columns
    in_csv = run_here("project", "-", "--format", "csv", text=text).stdout
    (row,) = csv.DictReader(in_csv.splitlines())
    assert list(row.items())[len(row) - len(columns or {}) :] == list((columns or {}).items())
    table = run_here("project", "-", text=text).stdout
    for name, value in (columns or {}).items():
        assert f"{name:>10}  {value}\n" in table


def test_letters_of_an_unknown_encoding_are_noted() -> None:
    done = run_here("project", "-", "--format", "csv", text="1,2,3,caf\u00e9\n".encode("latin-1"))
    assert done.returncode == 0 and done.stdout.endswith(",caf\u00e9\n")
    assert "read as Latin-1" in done.stderr and done.stderr.count("\n") == 1


def test_a_name_of_a_point_cannot_write_to_the_terminal() -> None:
    table = run_here("project", "-", text="1,2,3,\x1b[31mred\n").stdout
    assert "  column_4  \ufffd[31mred\n" in table


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (b"x,y,z,name\n1,2,3,A,B\n", ["line 2", "has 5 columns, but the first row names 4"]),
        (b"x,y,z,w\n1,2,3,A\n", ["line 2", "w = 'A'"]),
        (b"x,y,z,a,a\n1,2,3,A,B\n", ["line 1", "two columns of the same name"]),
        (b"", ["no points"]),
        (b"x,y,z\n", ["no points"]),
        (b"1,2,3\n1,2\n", ["line 2", "2 columns", "three"]),
        (b"1,2,3,4,5\n", ["line 1", "5 columns", "three"]),
        (b"0,0,0,0\n", ["line 1: w = 0: must not be 0 if x, y and z are 0"]),
        (b"1,2,3,nan\n", ["line 1", "w = 'nan'", "finite number"]),
        (b"1,2,3,1e308\n", ["line 1", "w = 1e308", f"{LARGEST}"]),
        (b"1e100,2,3,1e-300\n", ["line 1", "x/w = inf", "finite number"]),
        (b"1;2\n", ["line 1", "has 2 columns, must"]),
        (b"a;b;c\n", ["line 1", "must name columns x, y and z"]),
        (b"name,px,py\nA,1,2\n", ["line 1", "must name columns x, y and z"]),
        (b"name,x,y,z\nA,1,2\n", ["line 2", "z = ''", "finite number"]),
        (b"A,1,2,3\nB,1,b,3\n", ["line 2", "y = 'b'", "finite number"]),
        (b"1,2,3\n\n1,b,3\n", ["line 3", "y = 'b'", "finite number"]),
        (b"1,2,nan\n", ["line 1", "z = 'nan'", "finite number"]),
        (b"1e200,2,3\n", ["line 1", "x = 1e200", f"{LARGEST}"]),
        (b"1_000,2,3\n", ["line 1", "x = '1_000'", "finite number"]),
        (b"1,,3\n", ["line 1", "y = ''", "finite number"]),
        (b"1,2,3\n\xff\xfe\n", ["line 2: has 1 column"]),
        (b"1,2," + b"3" * 200_000, ["line 1", "CSV"]),
        (b"1,2,3\0\n", ["line 1", "z = '3\\x00'"]),
    ],
)
def test_bad_points_are_refused_with_their_line(text: bytes, words: list[str]) -> None:
    said = refused("project", "-", text=text)
    for word in ["Standard input", *words]:
        assert word in said


@pytest.mark.parametrize(
    "command", ["", "matrices", "project", "export", "export a.png", "measure"]
)
def test_an_empty_name_is_refused(command: str) -> None:
    assert "was given an empty name." in refused(*command.split(), "")


def started(*words: str | Path, **options: Any) -> subprocess.CompletedProcess[str]:
    """Run the program in a process of its own, with options of `subprocess.run`."""
    given = {"cwd": ROOT, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    given["env"] = {**os.environ, "PYTHONPATH": str(ROOT)}
    return subprocess.run(
        [sys.executable, "-m", "app", *words], check=False, timeout=PATIENCE_S, **given | options
    )


def test_a_name_in_a_deleted_folder_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    gone = tmp_path / "gone"
    gone.mkdir()
    monkeypatch.chdir(gone)
    gone.rmdir()
    for command, name in {
        "export x.png": "x.png",
        "matrices --set scene=a.obj": "a.obj",
        "matrices b.obj": "b.obj",
        "measure --json j.json": "j.json",
        "--screenshot s.png": "s.png",
    }.items():
        assert cli.main(command.split()) == 2, command
        said = f"{name!r} is in the current folder, which was deleted.\n"
        assert capsys.readouterr() == ("", said), command


def test_commands_without_files_run_in_a_deleted_folder(tmp_path: Path) -> None:
    done = subprocess.run(
        ["/bin/sh", "-c", f'rmdir "$PWD"; {sys.executable} -m app matrices'], cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.stdout == run_here("matrices").stdout


def test_after_two_dashes_all_words_are_names(tmp_path: Path, by_hand: Path) -> None:
    (tmp_path / "-x.json").write_bytes(by_hand.read_bytes())
    done = started("matrices", "--format=json", "--", "-x.json", cwd=tmp_path)
    assert (done.returncode, json.loads(done.stdout)) == (0, matrices(by_hand))
    assert "was given 2 names" in refused("matrices", by_hand, "--", "--format")
    assert "-- does not exist" in refused("matrices", "--", "--")


@pytest.mark.parametrize("ending", [".json", ".md", ".png", ".obj", ""])
def test_a_file_that_cannot_be_looked_for_is_refused_in_a_sentence(
    ending: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, source = tmp_path / "out", tmp_path / "list.csv"
    for name in unreachable(tmp_path, ending, monkeypatch):
        for command in (
            "{0}", "project {0} 1,2,3", "matrices {0}", "export {1}.png {0}", "export {0}/a.png",
            "export {1}.png {0} --step 1", "measure {0} --quick", "talk {0} --handout {1}.pdf",
            "lesson print --topics {0} --seeds 1 --out {1}",
            "talk L5 --handout {0}/a.pdf", "measure --json {0}/a.json",
            "lesson results --csv {0}/a.csv x", "project 1,2,3 --set scene={0}",
        ):  # fmt: skip
            refused(*command.format(name, out).split())
        for command in ("lesson check {0}", "lesson results {0}", "export {1} --batch {0}"):
            assert run_here(*command.format(name, out).split()).returncode
        source.write_text(f"out,file\na.png,{name}\n", encoding="utf-8")
        listed = run_here("export", out, "--batch", source)
        assert listed.returncode == 2 and listed.stderr.startswith(f"{source}, line 2: ")


@pytest.mark.skipif(sys.platform == "win32", reason="a file of POSIX systems")
@pytest.mark.parametrize(
    ("ending", "command"),
    [
        (".png", "export {0}"),
        (".png", "--screenshot {0}"),
        (".json", "measure --quick --json {0}"),
        (".pdf", "talk app/lessons/content/talk-000.md --handout {0}"),
    ],
)
def test_nothing_is_written_to_a_pipe(ending: str, command: str, tmp_path: Path) -> None:
    pipe = tmp_path / f"pipe{ending}"
    os.mkfifo(pipe)
    said = refused(*command.format(pipe).split())
    assert "is a pipe or a device, not a regular file." in said and str(pipe) in said


@pytest.mark.parametrize("point", ["1,0,-1e-308", "1,0,-1e-308,0", "1e100,0,-1e-220,0"])
def test_project_says_of_a_point_in_front_that_its_pixel_is_too_large(point: str) -> None:
    from_the_origin = ("eye=0,0,0", "target=0,0,-1", "up=0,1,0")
    camera = [word for part in from_the_origin for word in ("--set", f"camera.{part}")]
    done = run_here("project", "-", *camera, "--set", "lens.near=0.001", text=f"{point}\n")
    assert done.returncode == 0
    for label in ("NDC", "image px", "depth"):
        why = "the point is in front of the eye; its pixel is larger than float64 can hold"
        assert f"{label:>10}  none: {why}\n" in done.stdout


@pytest.mark.parametrize(
    ("words", "typed", "point"),
    [
        (["1,2,3"], "1,2,3", "1,2,3"),
        (["1", "2.5", "-3e1"], "1 2.5 -3e1", "1,2.5,-3e1"),
        (["-1,2,3"], "-1,2,3", "-1,2,3"),
        (["(1, 2, 3)", "--set", "camera.eye=1,2,3"], "(1, 2, 3)", "1,2,3"),
        (["1,2"], "1,2", "1,2,3"),
        (["1,0,0,0"], "1,0,0,0", "1,0,0,0"),
        (["1" * 60 + ",2,3,4,5"], "1" * 60 + ",2,3,4,5", "1,2,3"),
    ],
)
def test_project_of_typed_coordinates_says_how_to_give_them(
    words: list[str], typed: str, point: str
) -> None:
    assert refused("project", *words) == (
        f"POINTS = '{typed}': must be a CSV file, or - for standard input; for a point:"
        f" echo {point} | python3 -m app project -.\n"
    )
    assert run_here("project", "-", text=f"{point}\n").returncode == 0


def test_project_reads_a_file_whose_name_is_a_number(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "1,2,3"
    path.write_text("1,2,3\n", encoding="utf-8")
    assert run_here("project", path).returncode == 0
    monkeypatch.chdir(tmp_path)
    assert cli.main(["project", "1,2,3"]) == 0


def test_options_may_stand_between_the_names(by_hand: Path) -> None:
    done = run_here("project", by_hand, "--format", "json", "-", "--set=lens.far=8", text="2,1,1")
    assert json.loads(done.stdout)["matrices"]["clip_from_view"][2][2] == -9 / 7


def buffered() -> dict[str, str]:
    """The environment in which Python buffers its output until it ends."""
    return {name: text for name, text in os.environ.items() if name != "PYTHONUNBUFFERED"}


def test_a_reader_who_leaves_early_is_no_error() -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "app", "project", "-", "--format", "csv"],
        cwd=ROOT,
        env=buffered(),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdin and process.stdout and process.stderr
        process.stdout.close()  # nobody reads, from the first byte on
        process.stdin.write(b"1,2,3\n" * 20_000)
        process.stdin.close()
        assert process.stderr.read() == b""
        assert process.wait() == 0


@pytest.mark.parametrize("command", ["matrices", "--version", "export --help"])
def test_a_full_disk_behind_standard_output_is_a_sentence(command: str) -> None:
    with open("/dev/full", "wb") as full:
        done = started(*command.split(), env=buffered(), stdout=full)
    assert done.returncode == 2
    assert done.stderr == "Standard output cannot be written: No space left on device.\n"


@pytest.mark.parametrize("command", ["project -", "doctor", "measure --json -", "--help"])
def test_a_closed_standard_output_is_a_sentence_at_once(command: str) -> None:
    done = subprocess.run(
        ["/bin/sh", "-c", 'exec "$@" >&-', "sh", sys.executable, "-m", "app", *command.split()],
        cwd=ROOT, input="1,2,3\n", stderr=subprocess.PIPE, text=True, check=False,
        timeout=PATIENCE_S,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (2, "Standard output is closed.\n")


# Nothing here has these characters but UTF-8: what a pipe of Windows speaks, and a bare POSIX.
OTHER_ENCODINGS: list[dict[str, str | None]] = [
    {"PYTHONIOENCODING": "cp1252"},
    {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
]
WITH_MINUS = (
    *("matrices", "--set=lens.kind=matrix"),
    "--set=lens.clip_from_view=1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-1,2",
)
"""The note on this matrix (w vanishes where −z + 2 = 0) has a minus sign that is no hyphen."""


@pytest.mark.parametrize(
    ("environment", "form"), [*zip(OTHER_ENCODINGS, ("text", "latex"), strict=True)],
    ids=["cp1252", "ascii"],
)  # fmt: skip
def test_output_for_files_and_programs_is_utf_8_everywhere(
    environment: dict[str, str | None], form: str
) -> None:
    done = run(*WITH_MINUS, f"--format={form}", **environment)
    assert (done.returncode, done.stderr) == (0, "")
    assert "\u2212" in done.stdout
    assert done.stdout == run_here(*WITH_MINUS, f"--format={form}").stdout


def test_a_terminal_shows_the_number_of_a_character_that_it_lacks() -> None:
    ours, theirs = os.openpty()
    done = started(*WITH_MINUS, env={**os.environ, "PYTHONIOENCODING": "latin-1"}, stdout=theirs)
    os.close(theirs)
    with open(ours, "rb", buffering=0) as terminal:
        said = b""
        with contextlib.suppress(OSError):  # so ends what a terminal has to say
            while part := terminal.read(4096):
                said += part
    assert (done.returncode, done.stderr) == (0, "")
    assert rb"\u2212" in said


# --------------------------------------------------------------------------- matrices


def matrices(*arguments: str | Path) -> dict[str, Any]:
    done = run_here("matrices", *arguments, "--format", "json")
    assert (done.returncode, done.stderr) == (0, "")
    found: dict[str, Any] = json.loads(done.stdout)
    return found


PERSPECTIVE_STAGES = [
    "world_from_object",
    "view_from_world",
    "canonical_perspective_from_view",
    "canonical_parallel_from_canonical_perspective",
    "depth_range_from_canonical_parallel",
    "clip_from_depth_range",
    "clip_from_view",
    "clip_from_world",
    "image_from_ndc",
]
PARALLEL_STAGES = [*PERSPECTIVE_STAGES[:2], "canonical_parallel_from_view", *PERSPECTIVE_STAGES[3:]]


def test_matrices_as_json_hold_every_stage_to_the_last_bit(by_hand: Path) -> None:
    found = matrices(by_hand)
    assert list(found) == PERSPECTIVE_STAGES
    for name, matrix in found.items():
        assert np.array_equal(matrix, stage_of(BY_HAND.projection, name).matrix)
    # By hand, from 90 degrees, an aspect of 2, near 1 and far 9, 5 away.
    assert found["clip_from_world"] == [
        [0.5, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1.25, 4], [0, 0, -1, 5]
    ]  # fmt: skip


SLANTED_AT_1E9 = Camera((1e9 + 6.1, 5.3e8, -9e8), (1e9, 5.3e8 + 2.2, -9e8 + 7.3), (0.3, 1.0, -0.2))


@pytest.mark.parametrize(
    ("depth", "lens"),
    [
        ("opengl", Perspective(37.0, 0.01, 1e7)),
        ("reversed", Perspective(120.0, 0.3, np.inf)),
        ("direct3d", Frustum(-0.1, 0.7, 0.2, 0.9, 0.7, 31.0, "x")),
        ("reversed", Orthographic(-4.1, 7.3, -3.3, 3.1, -1.7, 30.1, "y")),
        ("opengl", Oblique(-4.1, 7.3, -3.3, 3.1, 1.7, 30.1, alpha_deg=63.4, beta_deg=150.0)),
    ],
    ids=["perspective", "infinite", "frustum", "orthographic", "oblique"],
)
def test_matrices_of_a_slanted_camera_at_1e9_are_right_to_the_last_digit(
    tmp_path: Path, lens: Lens, depth: DepthRange
) -> None:
    """Against 80 digits: the last column is a sum of products that cancels 16 of float64's."""
    projection = Projection(SLANTED_AT_1E9, lens, (1366, 768), depth)
    path = tmp_path / "far away.json"
    write(Document("letter-f", projection), path)
    found = matrices(path)
    true = exact_matrices(projection)
    for name in ("view_from_world", "clip_from_view", "clip_from_world"):
        for value, cell in zip(
            np.ravel(found[name]).tolist(), itertools.chain(*true[name]), strict=True
        ):
            within = 0.5001 * np.spacing(abs(value)) if abs(cell) > 1e-60 else 1e-60
            assert abs(value - cell) <= within, (name, value, cell)
    # The stages multiply to the whole up to the rounding of each.
    names = PARALLEL_STAGES if lens.parallel else PERSPECTIVE_STAGES
    assert list(found) == names
    product, sizes = np.eye(4), np.eye(4)
    for name in names[2:6]:
        product, sizes = found[name] @ product, np.abs(found[name]) @ sizes
    assert (np.abs(product - found["clip_from_view"]) <= 2e-15 * sizes).all()


def exact_matrices(projection: Projection) -> dict[str, list[Any]]:
    """The matrices at 80 digits, found from the pictures of points in front of the eye."""

    def matrix(of: Callable[[tuple[int, int, int]], exact.Numbers]) -> list[Any]:
        base, x, y, z = (of(place) for place in ((0, 0, -1), (1, 0, -1), (0, 1, -1), (0, 0, -2)))
        along_z = exact.minus(base, z)
        origin = [b + p for b, p in zip(base, along_z, strict=True)]
        return [*zip(exact.minus(x, base), exact.minus(y, base), along_z, origin, strict=True)]

    def clip(seen: Projection) -> list[Any]:
        answer = exact.Exact(seen)
        return matrix(lambda p: [*(part * answer(p).w for part in answer(p).ndc), answer(p).w])

    answer = exact.Exact(projection)
    return {
        "view_from_world": matrix(lambda p: [*answer(p).view, 1]),
        "clip_from_view": clip(replace(projection, camera=Camera((0, 0, 0), (0, 0, -1)))),
        "clip_from_world": clip(projection),
    }


@pytest.mark.parametrize(
    ("sets", "stage", "note"),
    [
        ([], "world_from_object", "the scene's objects are given in world coordinates"),
        (
            ["lens.kind=orthographic"],
            "canonical_parallel_from_canonical_perspective",
            "a parallel lens has no M_pp: this is the identity",
        ),
        (
            ["lens.far=inf"],
            "canonical_perspective_from_view = scale",
            "far is infinite: the canonical pyramid is scaled by near, which is at z = -1",
        ),
    ],
)
def test_special_stages_have_a_note(sets: list[str], stage: str, note: str) -> None:
    arguments = [f"--set={value}" for value in sets]
    assert f"\n{stage}\n  ({note})\n" in "\n" + run_here("matrices", *arguments).stdout
    assert f"% {note}\n\\[\n" in run_here("matrices", *arguments, "--format=latex").stdout


def test_text_shows_a_factored_view_matrix_with_aligned_columns(by_hand: Path) -> None:
    # eye (0, 0, 5) looking along -z: nothing is rotated, the eye moves to the origin.
    assert run_here("matrices", by_hand).stdout.startswith(
        """\
lens perspective, fov_y_deg 90, near 1, far 9, image 200x100, depth opengl

world_from_object
  (the scene's objects are given in world coordinates)
  1  0  0  0
  0  1  0  0
  0  0  1  0
  0  0  0  1

view_from_world = rotation translation
  1  0  0   0
  0  1  0   0
  0  0  1  -5
  0  0  0   1

  rotation
  1  0  0  0
  0  1  0  0
  0  0  1  0
  0  0  0  1

  translation
  1  0  0   0
  0  1  0   0
  0  0  1  -5
  0  0  0   1

canonical_perspective_from_view = scale
"""
    )


def test_text_shows_the_divide_between_clip_and_ndc(by_hand: Path) -> None:
    blocks = run_here("matrices", by_hand).stdout.split("\n\n")
    heads = [block.split()[0] for block in blocks if not block.startswith("  ")]
    after = PERSPECTIVE_STAGES.index("clip_from_world") + 1
    expected = [*PERSPECTIVE_STAGES[:after], "ndc_from_clip:", *PERSPECTIVE_STAGES[after:]]
    assert heads == ["lens", *expected]
    assert "ndc_from_clip: x, y and z divided by w" in blocks


def test_no_matrix_shows_a_minus_zero() -> None:
    # A symmetric window has -(right + left)/(right - left) = -0.0 in its matrix.
    for form in ("text", "json", "latex"):
        done = run_here("matrices", "--format", form, "--set", "lens.kind=orthographic")
        assert not re.search(r"-0(\.0)?(?![.\d])", done.stdout)


def test_latex_is_pmatrix_with_powers_of_ten_written_out() -> None:
    words = ("--format=latex", "--digits=17", "--width=1000pt", "--set", "lens.near=1e-7")
    done = run_here("matrices", *words)
    blocks = re.findall(r"\\begin\{pmatrix\}\n(.*?)\n\\end\{pmatrix\}", done.stdout, re.DOTALL)
    rows = [[row.split(" & ") for row in block.split(" \\\\\n")] for block in blocks]
    assert all(len(matrix) == 4 and all(len(row) == 4 for row in matrix) for matrix in rows)

    def value(cell: str) -> float:
        return float(re.sub(r" \\cdot 10\^\{(-?\d+)\}", r"e\1", cell))

    shown = [[[value(cell) for cell in row] for row in matrix] for matrix in rows]
    start = load("letter-f").start
    projection = replace(start, lens=start.lens.replaced(near=1e-7))
    *stages, last = projection.stages
    expected = []
    for stage in (*stages, *projection.direct_stages, last):
        own = [factor for name, factor in stage.factors if "_from_" not in name]
        expected += [*(own if len(own) > 1 else []), stage.matrix]
    assert len(expected) == 9 + 6  # view, depth range and viewport have two factors
    assert shown == [matrix.tolist() for matrix in expected]
    symbols = re.findall(r"^&?M_\{\\text\{(.*?)\}\\leftarrow\\text\{(.*?)\}\} ", done.stdout, re.M)
    names = ["_from_".join(symbol).replace(" ", "_") for symbol in symbols]
    assert names == PERSPECTIVE_STAGES
    assert "e-" not in done.stdout
    narrow = run_here("matrices", "--format=latex", "--width=71mm", "--digits=17")
    assert "% perhaps wider" not in narrow.stdout and "= \\textstyle -" in narrow.stdout


EACH = """
import json, sys
from app.commands.cli import main
for words in json.loads(sys.argv[1]):
    assert main(words) == 0
"""
"""Runs several commands in one process."""


def test_numbers_need_no_qt_and_no_vtk(by_hand: Path, one_point: Path) -> None:
    code = f"""{EACH}
heavy = {{"PySide6", "shiboken6", "vtk", "vtkmodules", "pyvista", "pyvistaqt", "widgets"}}
assert not heavy & {{name.partition(".")[0] for name in sys.modules}}, sorted(sys.modules)
assert "app.scenes.scene" not in sys.modules
"""
    commands = (["matrices", by_hand], ["project", by_hand, one_point], ["project", "--help"])
    words = json.dumps(commands, default=str)
    done = subprocess.run(
        [sys.executable, "-c", code, words], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_numbers_are_written_the_same_in_every_locale(
    comma_locale: dict[str, str], by_hand: Path, one_point: Path
) -> None:
    code = (
        "import locale; locale.setlocale(locale.LC_ALL, ''); "
        "assert locale.localeconv()['decimal_point'] == ','; "
        f"import numpy; numpy.set_printoptions(legacy='1.13', precision=2)\n{EACH}"
    )
    commands = (
        ["project", by_hand, one_point, "--format", "json"],
        ["project", by_hand, one_point, "--format", "csv"],
        ["project", by_hand, one_point],
        ["matrices", by_hand],
        ["matrices", by_hand, "--format", "latex"],
    )
    done = subprocess.run(
        [sys.executable, "-c", code, json.dumps(commands, default=str)],
        cwd=ROOT, env={**os.environ, **comma_locale}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.stderr == ""
    assert done.stdout == "".join(run_here(*words).stdout for words in commands)


def test_the_largest_allowed_numbers_are_finite_in_json(by_hand: Path) -> None:
    # JSON has no word for infinity: the narrowest window and the farthest points must not need one.
    sets = ["lens.kind=orthographic", "lens.keep=stretch", f"lens.left={-SMALLEST_WINDOW}"]
    arguments = [f"--set={value}" for value in [*sets, f"lens.right={SMALLEST_WINDOW}"]]
    points = project(by_hand, *arguments, points=f"{LARGEST},0,0\n{-LARGEST},0,{LARGEST}\n")
    assert [point["outside_of"] for point in points] == [["right"], ["near", "left"]]


# --------------------------------------------------------------------------- words and options


@pytest.mark.parametrize(
    ("word", "nearest"),
    [("expot", "export"), ("PROJECT", "project"), ("matrix", "matrices"), ("doktor", "doctor")],
)
def test_a_misspelt_command_names_the_nearest(word: str, nearest: str) -> None:
    said = refused(word)
    assert said == (
        f"{word!r} is neither a file, a lesson nor a command; the nearest command is {nearest}.\n"
    )


def test_a_word_unlike_any_command_lists_all_commands() -> None:
    commands = ", ".join(options.SUMMARIES)
    said = f"is neither a file, a lesson nor a command; the commands are {commands}.\n"
    assert refused("frobnicate") == f"'frobnicate' {said}"
    assert refused("L99") == f"'L99' {said}"


def test_a_scene_that_is_given_as_a_file_names_the_option() -> None:
    scene = "letter-f is a scene: write --set scene=letter-f.\n"
    for words in (("letter-f",), ("export", "out.png", "letter-f"), ("matrices", "letter-f")):
        assert refused(*words) == scene


def test_every_command_opens_a_lesson_by_its_name_as_by_its_file(tmp_path: Path) -> None:
    own = str(CONTENT / "l05-similar-triangles.md")
    points = tmp_path / "points.csv"
    points.write_text("0,1,0\n", encoding="utf-8")
    for words in (
        ["matrices", "FILE"], ["project", "FILE", str(points)], ["lesson", "list", "FILE"],
    ):  # fmt: skip
        by_name, by_file = (
            run_here(*[name if word == "FILE" else word for word in words]).stdout
            for name in ("L5", own)
        )
        assert by_name == by_file != "", words
    for word, at in (("L5", 0), ("001", 0), ("L5", 1), ("tour", 1)):
        command, words = (("", [word]), ("export", ["out.png", word]))[at]
        assert options.Parser(command).read(words)[1][at] == file_of(word) != word
    assert options.Parser("project").read(["L5"])[1] == ["L5"]  # its points
    assert options.Parser("export").read(["L5"])[1] == ["L5"]  # refused for its ending
    assert refused("--set", "lens.near=2", "L5").endswith(
        "l05-similar-triangles.md is a lesson, whose steps set what is shown.\n"
    )
    assert refused("lesson", "L5") == (
        "lesson = 'L5': must be one of check, list, names, print, results;"
        " python3 -m app L5 opens the lesson.\n"
    )


def test_a_file_needs_no_ending_and_two_are_still_too_many(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    write(BY_HAND, tmp_path / "exprot")
    monkeypatch.chdir(tmp_path)
    assert cli.main(["exprot", "out.png"]) == 2
    assert capsys.readouterr().err == "The window takes [FILE], and was given 2 names.\n"


def test_a_command_wins_over_a_file_of_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    write(BY_HAND, tmp_path / "matrices")
    monkeypatch.chdir(tmp_path)
    assert cli.main(["matrices"]) == 0
    # The letter F's matrices: the file of that name was not read.
    of_the_file = run_here("matrices", tmp_path / "matrices").stdout
    assert capsys.readouterr().out == run_here("matrices").stdout != of_the_file


def test_help_names_exactly_the_commands() -> None:
    done = run("--help")
    assert (done.returncode, done.stderr) == (0, "")
    found = re.findall(r"^  ([a-z]+) ", done.stdout.partition("commands,")[2], re.MULTILINE)
    assert found == list(options.SUMMARIES)


@pytest.mark.parametrize("command", list(options.SUMMARIES))
def test_each_command_has_help(command: str) -> None:
    done = run_here(command, "--help")
    assert done.returncode == 0
    assert done.stdout.startswith(f"usage: python3 -m app {command} [options]")


WINDOW = ("lens.kind=frustum", "lens.left=-1", "lens.right=3", "lens.bottom=-2", "lens.top=2")


@pytest.mark.parametrize("turn", [0, 3])
def test_window_sides_set_with_lens_kind_are_used_as_typed(turn: int) -> None:
    """Lecture 000 (13) by hand: 2 near / (right - left) = 4/4 in the corner, in any order."""
    typed = [*WINDOW[turn:], *WINDOW[:turn], "lens.near=2", "lens.far=10"]
    options = [word for path in typed for word in ("--set", path)]
    said = json.loads(run_here("matrices", "--format", "json", *options).stdout)
    assert said["clip_from_view"] == [[1, 0, 0.5, 0], [0, 1, 0, 0], [0, 0, -1.5, -5], [0, 0, -1, 0]]
    kept = run_here("matrices", "--format", "json", *options, "--set", "lens.keep=y")
    assert json.loads(kept.stdout)["clip_from_view"][0][0] == 0.5625  # 4 x 9/16 high, so wider


@pytest.mark.parametrize(
    ("typed", "line"),
    [
        ("", "lens perspective, fov_y_deg 38, near 5, far 12.5"),
        ("lens.far=inf", "lens perspective, fov_y_deg 38, near 5, far inf"),
        (
            " ".join(WINDOW),
            "lens frustum, left -1, right 3, bottom -2, top 2, keep stretch, near 5, far 12.5",
        ),
        (
            " ".join([*WINDOW, "lens.keep=x"]),
            "lens frustum, left -1, right 3, bottom -2, top 2, keep x (uses -1, 3, -1.125, 1.125),"
            " near 5, far 12.5",
        ),
        ("lens.kind=matrix", "lens matrix"),
    ],
)
def test_output_begins_with_the_lens_as_it_is_used(typed: str, line: str) -> None:
    options = [word for path in typed.split() for word in ("--set", path)]
    line += ", image 1280x720, depth opengl"
    assert run_here("matrices", *options).stdout.splitlines()[:2] == [line, ""]
    said = run_here("project", "-", *options, text="1,2,3\n").stdout
    assert said.splitlines()[:2] == [line, ""]
    for form in ("csv", "json"):
        assert "lens" not in run_here("project", "-", "--format", form, text="1,2,3\n").stdout


def test_the_help_names_what_exists() -> None:
    """The names are written twice, because help must work before anything is installed."""
    from app.document import view
    from app.document.document import model_paths
    from app.document.settings import MEASURES
    from app.measure import measuring
    from app.measure.sweeps import SWEEPS

    paths = {"scene", "mesh", "depth", *model_paths().values()} - {"lens.former"}
    paths |= {f"quality.{field.name}" for field in fields(Quality)}
    paths |= {f"view.{key}" for key in view.FIELDS if key not in ("panes", "pinned")}
    assert set(options.SETTABLE) == paths | {*MEASURES, "camera.P"}
    for command, option, known in (
        ("project", "--rung", PRECISIONS),
        ("project", "--space", SPACES),
        ("export", "--palette", PALETTES),
        ("export", "--hidden", HIDDEN),
        ("export", "--fit", FITS),
        ("measure", "--trade", measuring.TRADES),
    ):
        assert options.choices(command, option) == [*known], option
    assert tuple(f".{name}" for name in options.choices("export", "--format")) == ENDINGS
    assert tuple(SWEEPS) == options.SWEEPS
    for form in options.choices("project", "--format"):
        assert run_here("project", "-", "--format", form, text="1,2,3\n").returncode == 0
    for form in options.choices("matrices", "--format"):
        assert run_here("matrices", "--format", form).returncode == 0


def test_a_wrong_command_line_is_refused_in_a_sentence(by_hand: Path, tmp_path: Path) -> None:
    for words, said in {
        ("matrices", "--format"): "--format",
        ("matrices", "--fromat=json"): "is not an option of matrices; the nearest is --format.",
        ("project", by_hand, "-", "--rung", "float16"): (
            "--rung = 'float16': must be one of float32, float64, exact."
        ),
        ("matrices", "--format=latex", "--digits=18"): (
            "--digits = '18': must be a whole number from 1 to 17."
        ),
        ("matrices", "--format=latex", "--width=84"): (
            "--width = '84': must be a length in mm, cm, in, pt from 200pt to 1500pt, such as 84mm."
        ),
        ("matrices", "--width=84mm"): "--width: needs --format latex.",
        ("matrices", "--digits=4"): "--digits: needs --format latex.",
        ("matrices", "--format", "xml"): "--format = 'xml': must be one of text, json, latex.",
        ("matrices", "--set", "lens.fra=3"): "lens.fra is not known; the nearest name is lens.far.",
        ("matrices", "--set", "camera.eye=0,2.2,0"): "camera.eye = [0, 2.2, 0]: must differ from t",
        ("matrices", "--set", "camera.target=5,4.5,8"): "camera.target = [5, 4.5, 8]: must differ",
        ("matrices", "--set", "scene=post"): "did you mean “posts”",
        ("matrices", by_hand, "--set", "scene=post"): "did you mean “posts”",
        ("--set", "lens.far=9", "matrices"): "matrices is a command and must come first",
        ("--set", "lens.far=9", "export", "f.png"): "export is a command and must come first",
        ("exprot", "--size=100x100", "a.png"): "the nearest command is export.",
        (by_hand, by_hand): "takes [FILE], and was given 2 names",
        ("project",): "project takes [FILE] POINTS, and was given 0 names",
        ("project", by_hand, by_hand, "-"): "and was given 3 names",
        ("project", by_hand): "POINTS is missing",
        ("project", tmp_path / "none.csv"): "none.csv cannot be read: No such file",
        ("project", tmp_path): "cannot be read: Is a directory",
    }.items():
        assert said in refused(*words), words


# --------------------------------------------------------------------------- files


def cut(path: Path) -> None:
    path.write_text(path.read_text(encoding="utf-8")[:100], encoding="utf-8")


FILES: dict[str, tuple[str, Callable[[Path], object], list[str]]] = {
    "missing": ("a\nb.stl", lambda path: None, ["b.stl"]),
    "another ending": ("notes.txt", lambda path: path.touch(), ["neither", ".stl"]),
    "cut short": ("cut.json", lambda path: (write(BY_HAND, path), cut(path)), ["cut short"]),
}


@pytest.mark.parametrize("command", ["", "matrices", "export out.png"])
@pytest.mark.parametrize("kind", FILES)
def test_a_file_that_cannot_be_used_is_refused_by_every_command(
    tmp_path: Path, kind: str, command: str
) -> None:
    name, make, words = FILES[kind]
    make(tmp_path / name)
    arguments = [str(tmp_path / word) if "." in word else word for word in command.split()]
    said = refused(*arguments, tmp_path / name)
    for word in words:
        assert word in said
    assert not (tmp_path / "out.png").exists()


def test_a_mesh_brings_the_camera_that_shows_it(tmp_path: Path) -> None:
    mesh = tmp_path / "tetrahedron.obj"
    mesh.write_text(
        "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", encoding="utf-8"
    )
    done = run_here("project", mesh, "-", "--format=json", text="0,0,0\n2,0,0\n0,2,0\n0,0,2\n")
    points = json.loads(done.stdout)["points"]
    assert all(point["inside"] for point in points)


# --------------------------------------------------------------------------- export


def export(out: Path, *arguments: str | Path, **environment: str | None) -> np.ndarray:
    """Export a picture; in a process of its own if an environment is given."""
    import pyvista as pv

    words = ("export", out, *arguments)
    done = run(*words, **environment) if environment else run_here(*words)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    # VTK's reader has the first row at the bottom.
    image = pv.read(out)
    width, height, _ = image.dimensions
    return np.asarray(image.point_data["PNGImage"]).reshape(height, width, -1)[::-1]


def test_export_has_the_same_pixels_whatever_the_display(tmp_path: Path, by_hand: Path) -> None:
    size = ("--size", "600x200")
    assert os.environ["DISPLAY"]
    with_one = export(tmp_path / "a.png", by_hand, *size)
    without = export(tmp_path / "b.png", by_hand, *size, DISPLAY=None, WAYLAND_DISPLAY=None)
    unreachable = export(tmp_path / "c.png", by_hand, *size, DISPLAY=":9999")
    assert with_one.shape == (200, 600, 3)
    assert colours_of(with_one) > 20  # a picture, not a blank
    assert np.array_equal(with_one, without)
    assert np.array_equal(with_one, unreachable)


_COUNTED_LAST = """
import atexit, gc, sys
@atexit.register
def count():
    import pyvista
    gc.unfreeze()
    gc.collect()
    print(sum(isinstance(each, pyvista.DataObject) for each in gc.get_objects()))
from app.commands.cli import main
sys.exit(main(sys.argv[1:]))
"""


def test_what_is_left_out_of_a_mesh_is_said_once(tmp_path: Path) -> None:
    mesh = tmp_path / "small.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n", encoding="utf-8")
    done = run_here("project", mesh, "-", text="0,0,0\n")
    assert done.returncode == 0 and done.stderr == (
        f"{mesh}: faces left out: 1 of 2, because they have fewer than three different corners; "
        "the first is on line 4.\n"
    )


def test_no_mesh_outlives_pyvistas_modules(tmp_path: Path) -> None:
    command = [sys.executable, "-c", _COUNTED_LAST, "export", tmp_path / "a.png", "--size", "96x32"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE_S)
    assert (done.returncode, done.stdout, done.stderr) == (0, "0\n", "")


def test_export_carries_the_document_with_what_was_set(tmp_path: Path, by_hand: Path) -> None:
    out = tmp_path / "figure.png"
    export(out, by_hand, "--size=96x32", "--set", "lens.near=0.5")
    assert read(out) == set_values(BY_HAND, ["lens.near=0.5"])


def test_export_shows_what_is_set_of_the_view(tmp_path: Path) -> None:
    """The picture equals that of a document saved so, and brings its view back."""
    out = tmp_path / "figure.png"
    options = ("--set=view.stage=pyramid", "--set=view.probes=0,1,0", "--set=view.frame_step=n")
    shown = export(out, "--size=300x100", *options)
    view = View(stage=2.0, probes=(Probe(1, (0.0, 1.0, 0.0)),), frame_step="n", panel="frame")
    assert read(out).view == view
    write(replace(read(out), view=view), tmp_path / "saved.json")
    again = export(out, tmp_path / "saved.json", "--size=300x100")
    assert np.array_equal(again, shown)
    plain = export(out, "--size=300x100")
    for left in (0, 100, 200):
        assert not np.array_equal(plain[:, left : left + 100], shown[:, left : left + 100])


def test_text_size_and_scale_are_in_the_file(tmp_path: Path) -> None:
    out = tmp_path / "figure.png"
    usual = export(out, "--size=300x100", "--scale=2")
    with Image.open(out) as image:
        assert image.info["dpi"] == pytest.approx((600.0, 600.0), rel=1e-3)
    large = export(out, "--size=300x100", "--scale=2", "--text-size=3")
    assert not np.array_equal(large, usual)


def test_the_view_does_not_change_numbers() -> None:
    for command in (("matrices",), ("project", "-")):
        said = run_here(*command, text="1,2,3\n").stdout
        options = ("--set=view.stage=pyramid", "--set=view.letters=002", "--set=view.layers=grid")
        assert run_here(*command, *options, text="1,2,3\n").stdout == said


def test_export_options_reach_the_picture(tmp_path: Path, by_hand: Path) -> None:
    image = export(tmp_path / "image.png", by_hand, "--panes", "image")
    assert image.shape == (100, 200, 3)  # the image pane alone has the image's own size
    two = export(tmp_path / "two.png", by_hand, "--panes=world/ndc", "--scale=0.5")
    assert two.shape == (640, 320, 3)  # two squares of 640 at half the scale
    paper = export(tmp_path / "paper.png", by_hand, "--size=24mmx12mm", "--panes=ndc", "--crop")
    assert 100 < paper.shape[0] <= 142 and 100 < paper.shape[1] < 284
    clear = export(tmp_path / "clear.png", by_hand, "--size=96x32", "--transparent")
    assert clear.shape == (32, 96, 4) and clear[..., 3].min() == 0
    light = export(tmp_path / "light.png", by_hand, "--size=96x32")
    dark = export(tmp_path / "dark.png", by_hand, "--size=96x32", "--palette", "dark")
    assert np.median(dark) < 100 < 200 < np.median(light)


def test_export_writes_shapes_as_svg_and_pdf(tmp_path: Path, by_hand: Path) -> None:
    done = run_here("export", tmp_path / "a.PDF", by_hand, "--panes=image")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    content = (tmp_path / "a.PDF").read_bytes()
    assert content.startswith(b"%PDF-") and "The eye is at".encode("utf-16-be") in content
    out = tmp_path / "figure.svg"
    done = run_here("export", out, by_hand, "--panes=world,ndc", "--palette=dark", "--transparent")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    tree = ElementTree.parse(out).getroot()
    assert tree.get("viewBox") == "0 0 1280 640" and tree.get("width") == "108.37mm"
    text = out.read_text(encoding="utf-8")
    assert 'fill="#16181b"' not in text, "no background"
    assert "<desc>The eye is at (" in text and "World: the scene" in text
    assert "Image: the picture" not in text, "of the panes in the figure only"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["figure.jpg"], "OUT = 'figure.jpg': must end in .png, .svg, .pdf or .tex, or in .html"),
        (["figure.svg", "--scale", "2"], "--scale: is for .png; shapes are as fine at every scale"),
        (["figure.svg", "--panes", "world,depth"], "--panes = 'depth': must be one of world, ndc"),
        (["a.png", "--panes=depth", "--language=hr"], "--panes = 'depth': mora biti jedno od"),
        (["a.png", "--text-size=0", "--language=hr"], "--text-size = 0: mora biti od 0.24 do 38.4"),
        (["a.png", "--scale=0", "--language=et"], "--scale = 0: peab olema suurem kui 0"),
        (["no/such/folder/figure.png"], "there is no folder no/such/folder"),
        (
            ["figure.png", "--size", "960x100000"],
            "--size height = 100000: must be a whole number of pixels from 32 to 16384.",
        ),
        (
            ["figure.png", "--size", "10x100", "--panes", "world"],
            "--size width = 10: must be a whole number of pixels from 32 to 16384.",
        ),
        (["a.png", "--size=0mmx80mm"], "--size width = 0 mm: must be from 8.13 to 1387 mm."),
        (["a.png", "--width=3000mm"], "--width = 3000 mm: must be from 8.13 to 1387 mm."),
        (["a.png", "--width=0mm"], "--width = 0 mm: must be from 8.13 to 1387 mm."),
        (["a.png", "--width=2540mm"], "--width = 2540 mm: must be from 8.13 to 1387 mm."),
        (["a.png", "--panes=image", "--width=0mm"], "--width = 0 mm: must be from 0.0847"),
        (
            ["a.png", "--panes=equation", "--set=view.equation=frustum", "--width=0mm"],
            "--width = 0 mm: must be from 0.0847",
        ),
        (
            ["a.png", "--size=10cmx1000cm"],
            "--size height = 1000 cm: must be from 0.271 to 138.7 cm",
        ),
        (["a.svg", "--size=12mx8m"], "--size = '12mx8m': must be WIDTHxHEIGHT in mm, cm, in, px"),
        (["a.svg", "--panes=world,ndc/image"], "must be a row or a column, not both"),
        (["figure.png", "--size", "9000x900", "--scale", "2"], "--size width = 9000 times scale 2"),
        (["figure.png", "--size", "big"], "--size = 'big': must be WIDTHxHEIGHT"),
        (["figure.png", "--scale", "0"], "--scale = 0: must be greater than 0"),
        (["figure.png", "--scale", "2x"], "--scale = '2x': must be a finite number"),
        (["figure.png", "--text-size", "big"], "--text-size = 'big': must be a number of points."),
        (["figure.png", "--text-size", "0"], "--text-size = 0: must be from 0.24 to 38.4 points"),
        (["figure.png", "--hidden=grey"], "--hidden: is for .svg, .pdf"),
        (["figure.png", "--palette=pink"], "must be one of screen, print, dark, contrast"),
        ([], "export takes OUT [FILE], and was given 0 names"),
    ],
)
def test_bad_export_is_refused(arguments: list[str], words: str) -> None:
    assert words in refused("export", *arguments)
    assert not (ROOT / "figure.png").exists()


@pytest.mark.parametrize(
    ("arguments", "option"),
    [
        (["export", "{}.png", "{}.png"], "OUT"),
        (["export", "{}-%02d.png", "{}-01.png", "--orbit=90", "--frames=2"], "OUT"),
        (["measure", "{}.json", "--json={}.json"], "--json"),
        (["measure", "{}.png", "--chart={}.png"], "--chart"),
        (["talk", "{}.html", "--handout={}.html"], "--handout"),
        (["lesson", "results", "{}.json", "--csv={}.json"], "--csv"),
        (["{}.png", "--screenshot={}.png"], "--screenshot"),
    ],
    ids=lambda value: value[-1] if isinstance(value, list) else value,
)
def test_no_command_overwrites_what_it_reads(
    tmp_path: Path, arguments: list[str], option: str
) -> None:
    files = [tmp_path / name for name in ("a.png", "a-01.png", "a.json", "a.html")]
    for file in files:
        file.write_text("kept", encoding="utf-8")
    *others, last = (each.format(tmp_path / "a") for each in arguments)
    said = one_sentence(run_here(*others, last), 2)
    assert said.startswith(f"{option} = ") and "is read by this command" in said
    assert {file.read_text(encoding="utf-8") for file in files} == {"kept"}


def test_export_to_a_full_disk_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(_descriptor: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    out = tmp_path / "full.png"
    said = one_sentence(run_here("export", out, "--size=96x32"), 2)
    assert "full.png cannot be written: No space left" in said
    assert not list(tmp_path.iterdir())


def test_export_without_opengl_says_what_to_do_instead_of_crashing(tmp_path: Path) -> None:
    for display in (os.environ["DISPLAY"], None):
        done = run("export", tmp_path / "a.png", DISPLAY=display, MESA_GL_VERSION_OVERRIDE="2.1")
        assert done.returncode == 3
        assert "OpenGL 3.2" in done.stderr and "driver" in done.stderr
        assert done.stderr.count("\n") == 1
    assert not (tmp_path / "a.png").exists()


# --------------------------------------------------------------------------- doctor


def test_doctor_finds_everything_on_a_machine_that_runs_the_tests() -> None:
    done = run("doctor")
    assert done.returncode == 0, done.stdout
    assert done.stdout.endswith("\n\nEverything needed is here.\n")
    for name in ("Python", "numpy", "vtk", "PySide6-Essentials", "Qt",
                 "System libraries", "Settings folder", "Log folder", "Display", "Screen", "OpenGL",
                 "Panes", "Export", "MP4"):  # fmt: skip
        assert re.search(rf"^{name} +\S", done.stdout, re.MULTILINE), name
    assert os.environ["DISPLAY"] in done.stdout


def test_doctor_survives_a_driver_that_crashes() -> None:
    done = run("doctor", MESA_GL_VERSION_OVERRIDE="2.1")
    assert done.returncode == 3
    assert re.search(r"\nOpenGL +none for windows: OpenGL 2.1 is too old", done.stdout)
    assert re.search(r"\n  Export: install Mesa", done.stdout)


def with_driver(script: str, folder: Path, patch: pytest.MonkeyPatch) -> None:
    """Let a script replace the process that tries a driver."""
    if sys.platform == "win32":
        pytest.skip("needs /bin/sh")
    trial = folder / "trial"
    trial.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
    trial.chmod(0o755)
    patch.setattr(sys, "executable", str(trial))


def test_doctor_names_a_package_of_the_wrong_version(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with_driver("exit 1", tmp_path, monkeypatch)
    version = metadata.version
    monkeypatch.setattr(metadata, "version", lambda name: "9.9" if name == "vtk" else version(name))
    assert cli.main(["doctor"]) == 3
    said = capsys.readouterr().out
    assert re.search(r"This is missing:\n  vtk: .* -m pip install 'vtk>=9", said)


def test_doctor_without_a_display_says_how_to_get_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with_driver("""echo '{"window": "EGL", "renderer": "llvmpipe"}'""", tmp_path, monkeypatch)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    assert cli.main(["doctor"]) == 3
    said = capsys.readouterr().out
    assert re.search(r"This is missing:\n  Display: .*ssh with -X.*\n\Z", said)


@pytest.mark.parametrize(
    ("script", "said"),
    [
        ("kill -SEGV $$", "the driver crashed (signal 11)"),
        ("exec sleep 60", "does not answer within 0.2 s"),
        # The keyboard is the terminal's.
        ("read line || line=nothing; echo $line was typed >&2; exit 1", "nothing was typed"),
    ],
)
def test_doctor_reports_how_a_driver_failed(
    script: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from app.commands import doctor

    with_driver(script, tmp_path, monkeypatch)
    if "sleep" in script:
        monkeypatch.setattr(doctor, "LONGEST_TRIAL_S", 0.2)
    keyboard, typing = os.pipe()
    os.write(typing, b"a word\n")
    os.close(typing)
    kept = os.dup(0)
    os.dup2(keyboard, 0)
    try:
        found = {finding.name: finding.text for finding in doctor.examine()}
    finally:
        os.dup2(kept, 0)
        os.close(kept)
        os.close(keyboard)
    assert (found["OpenGL"], found["Export"]) == (said, said)


def test_a_scene_brings_its_camera_unless_a_document_has_one(tmp_path: Path) -> None:
    own = matrices("--set", "scene=posts")
    start = load("posts").start
    assert own["view_from_world"] == stage_of(start, "view_from_world").matrix.tolist()
    np.testing.assert_allclose(own["view_from_world"], start.view_from_world, rtol=1e-15, atol=0)
    write(BY_HAND, tmp_path / "seen.json")
    kept = matrices(tmp_path / "seen.json", "--set", "scene=posts")
    assert kept["view_from_world"] == BY_HAND.projection.view_from_world.tolist()  # whole numbers


# --------------------------------------------------------------------------- a free matrix

FREE = ("--set", "lens.kind=matrix", "--set",
        "lens.clip_from_view=0,0,0,0, 0,2,0,0, 0,0,-1,-2, 0,0,-1,0")  # fmt: skip


def test_a_free_matrix_is_printed_with_what_it_does() -> None:
    found = matrices(*FREE)
    assert list(found) == [
        "world_from_object", "view_from_world", "clip_from_view", "clip_from_world",
        "image_from_ndc",
    ]  # fmt: skip
    assert found["clip_from_view"] == [[0, 0, 0, 0], [0, 2, 0, 0], [0, 0, -1, -2], [0, 0, -1, 0]]
    text = run_here("matrices", *FREE).stdout
    assert "\nclip_from_view\n  (singular (rank 3): the frustum cannot be drawn)\n" in text
    assert "  (not affine: w depends on z)\n" in text
    latex = run_here("matrices", *FREE, "--format=latex").stdout
    assert "% singular (rank 3): the frustum cannot be drawn\n" in latex
    assert "rank" not in run_here("matrices").stdout


def test_a_free_matrix_is_exported(tmp_path: Path) -> None:
    for name, settings in (("flat", FREE), ("sheared", (*FREE[:3], "lens.clip_from_view="
                            "1.4,0.5,0,0, 0,2.4,0,0, 0,0,-1,-2, 0,0,-1,0"))):  # fmt: skip
        out = tmp_path / f"{name}.png"
        done = run_here("export", out, *settings, "--size=300x100")
        assert (done.returncode, done.stderr) == (0, "")
        assert run_here("matrices", out).stdout == run_here("matrices", *settings).stdout


# --------------------------------------------------------------------------- phenomena


def test_an_exported_phenomenon_carries_its_settings_and_its_mesh(tmp_path: Path) -> None:
    mesh = tmp_path / "tetra.obj"
    mesh.write_text(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n", encoding="utf-8"
    )
    out, plain = tmp_path / "figure.png", tmp_path / "plain.png"
    scene = ("--set", "scene=similar-triangles", "--set", "settings.distance=-3")
    options = ("--panes", "world,image", "--size", "300x150")
    done = run_here("export", out, *scene, "--set", f"mesh={mesh}", *options)
    assert done.returncode == 0, done.stderr
    document = read(out)
    assert document.settings["distance"] == -3.0 and document.mesh == str(mesh)
    assert run_here("export", plain, *scene, *options).returncode == 0
    with Image.open(out) as with_mesh, Image.open(plain) as without:
        assert np.mean(np.asarray(with_mesh) != np.asarray(without)) > 0.01
    missing = refused("export", out, *scene, "--set", f"mesh={tmp_path / 'gone.obj'}")
    assert "gone.obj" in missing


@pytest.mark.parametrize(
    ("settings", "sentence"),
    [
        (
            ["scene=depth-buffer", "settings.range=logarithmic", "lens.far=inf"],
            "depth-buffer: a logarithmic depth buffer needs a perspective lens and a far plane",
        ),
        (["scene=eye-plane", "lens.kind=orthographic"], "eye-plane: a parallel lens divides by 1"),
        (["scene=depth-buffer"], ""),
    ],
)
def test_export_prints_the_windows_warnings(
    settings: list[str], sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = [option for setting in settings for option in ("--set", setting)]
    out = tmp_path / "figure.png"
    assert cli.main(["export", str(out), "--panes=image", "--size=160x90", *options]) == 0
    said = capsys.readouterr()
    assert said.out == "" and out.exists()
    assert said.err.startswith(sentence) and said.err.count("\n") == bool(sentence)


@pytest.mark.parametrize(
    ("asked", "is_shown"),
    [
        ((), True),
        (("--theme", "dark"), True),
        (("--set", "scene=cube"), False),
        (("docs/scene-focus.png",), False),
        (("app/lessons/content/l05-similar-triangles.md",), False),
    ],
)
def test_the_start_card_is_not_shown_over_a_document(
    asked: tuple[str, ...], is_shown: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown: list[application.Options] = []

    def run_window(*given: Any, **_named: Any) -> int:
        shown.append(given[3])
        return 0

    monkeypatch.setattr(application, "run_window", run_window)
    assert run_here(*asked).returncode == 0
    assert [options.start_card for options in shown] == [is_shown]


OTHER_SETTINGS = """mathtext.default: rm
path.sketch: (5, 100, 2)
pdf.compression: 0
savefig.bbox: tight
text.hinting: none
text.kerning_factor: 6
"""


@pytest.mark.parametrize("ending", ["png", "svg", "pdf"])
def test_a_figure_is_the_same_whatever_matplotlib_is_set_to(ending: str, tmp_path: Path) -> None:
    """A matplotlibrc counts in the current folder and at home, MPLBACKEND comes from a notebook."""
    (tmp_path / "matplotlibrc").write_text(OTHER_SETTINGS, encoding="utf-8")
    made = []
    for set_to in ({}, {"MATPLOTLIBRC": str(tmp_path), "MPLBACKEND": "nosuch"}):
        path = tmp_path / f"{len(made)}.{ending}"
        done = run("export", path, "--size", "400x200", "--set", "scene=depth-buffer", **set_to)
        assert (done.returncode, done.stderr) == (0, "")
        made.append(path.read_bytes())
    assert made[0] == made[1]
