"""The command `measure`: what it prints and writes, what it refuses, how it is stopped."""

import itertools
import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

import app.measure.meaning as meaning_module
from app.bootstrap import ROOT
from app.commands.arguments import check_out
from app.commands.terminal import CliError
from app.measure.meaning import bargain, cheapest, meaning
from app.measure.measuring import NEED_OPENGL, TRADES
from app.measure.results import ChartPoint, Trade, from_json, to_csv
from app.measure.sweeps import SWEEPS
from tests import PATIENCE_S
from tests.support.commands import refused, run, run_here


def test_a_trade_and_a_sweep_are_printed_and_written(tmp_path: Path) -> None:
    out, table = tmp_path / "out.json", tmp_path / "out.csv"
    done = run(
        "measure", "--trade", "depth", "--sweep", "near=0.01:5", "--quick",
        "--set", "lens.far=100", "--json", out, "--csv", table, DISPLAY=None,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    results = from_json(out.read_text(encoding="utf-8"))
    assert [trade.name for trade in results.trades] == ["depth"]
    assert results.document["lens"]["far"] == 100
    (sweep,) = results.sweeps
    assert sweep.values[0] == pytest.approx(0.01) and sweep.values[-1] == pytest.approx(5.0)
    assert results.machine["opengl"] not in ("", "none")
    assert "fixed24, reversed" in done.stdout and "smallest gap in world units" in done.stdout
    assert meaning(results.trades[0]) in done.stdout
    lines = table.read_text(encoding="utf-8").splitlines()
    assert lines[0].startswith("choice,cost_B") and "" in lines
    for choice in results.trades[0].choices:  # what is printed is what is written
        assert choice.name in done.stdout


def test_tables_can_go_to_standard_output_as_csv(tmp_path: Path) -> None:
    out = tmp_path / "out.json"
    words = ("--trade=depth", "--sweep=near=1:2", "--quick", "--csv=-", "--json", out)
    done = run_here("measure", *words)
    results = from_json(out.read_text(encoding="utf-8"))
    assert done.stdout == "\n".join(map(to_csv, (*results.trades, *results.sweeps)))
    assert not (ROOT / "-").exists()


def test_a_reader_who_leaves_early_does_not_cost_the_files(tmp_path: Path) -> None:
    out = tmp_path / "out.json"
    command = [sys.executable, "-m", "app", "measure", "--trade=depth", "--json", str(out)]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        process.stdout.close()
        assert process.wait(PATIENCE_S) == 0
    assert from_json(out.read_text(encoding="utf-8")).complete


@pytest.mark.parametrize("option", ["--json", "--csv", "--chart"])
def test_a_folder_is_refused_before_anything_is_measured(tmp_path: Path, option: str) -> None:
    folder = tmp_path / "out.png"
    folder.mkdir()
    assert f"{option} = '{folder}': is a folder." in refused("measure", option, folder)


def test_a_write_protected_file_is_refused_before_anything_is_measured(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`os.access` is replaced, because root may write to every folder."""
    monkeypatch.setattr(os, "access", lambda place, _mode: place != str(tmp_path))
    for name in ("new.json", "link.json"):
        (tmp_path / "link.json").unlink(missing_ok=True)
        (tmp_path / "link.json").symlink_to("target.json")
        with pytest.raises(CliError, match=f"--json = '.*{name}': may not be written"):
            check_out("--json", str(tmp_path / name))


def test_without_opengl_the_other_trades_still_run() -> None:
    words = ("measure", "--quick", "--trade=depth", "--trade=detail", "--json=-")
    done = run(*words, MESA_GL_VERSION_OVERRIDE="2.1")
    assert done.returncode == 0, done.stderr
    assert "Not measured: detail." in done.stderr and done.stderr.count("\n") == 1
    results = from_json(done.stdout)
    assert [trade.name for trade in results.trades] == ["depth"]
    assert results.machine["opengl"] == "none"
    assert "OpenGL" in refused("measure", "--trade=smoothing", status=3)
    assert set(NEED_OPENGL) == {"smoothing", "detail"} < set(TRADES)


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["--trade=speed"], "--trade = 'speed': must be one of arithmetic, interpolation, depth"),
        (["--sweep=size"], "--sweep = 'size': must be one of near, far, fov"),
        (["--sweep=near=5"], "must be LOW:HIGH"),
        (["--sweep=near=5:1"], "must have LOW below HIGH, both from 1e-200 to 1e+99"),
        (["--sweep=near=nan:1"], "must have LOW below HIGH"),
        (["--sweep=fov=1:180"], "must have LOW below HIGH, both from 1e-80 to 179.999999999999."),
        (["--sweep=near=a:b"], "must be LOW:HIGH"),
        (["--scene=cubee"], "cube"),
        (["--json=/nowhere/a.json"], "there is no folder /nowhere"),
        (["--csv=/nowhere/a.csv"], "there is no folder /nowhere"),
        (["--json=-", "--csv=-"], "--json and --csv must go to different files."),
        (["--json=a.pdf", "--chart=a.pdf"], "--json and --chart must go to different files."),
        (["--set=lens.near=0"], "lens.near"),
        (["--set=lens.kind=matrix"], "lens.kind = matrix: a free matrix has no near, no far"),
        (["--tradee=depth"], "the nearest is --trade"),
    ],
)
def test_bad_input_is_refused(arguments: list[str], words: str) -> None:
    assert words in refused("measure", *arguments)


def attended(*arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "app", "measure", "--attended", "--json=-", *arguments],
        cwd=ROOT,
        env=dict(os.environ),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def fraction_told(process: subprocess.Popen[str]) -> float:
    """The next fraction, without the messages of libraries, such as those about fonts."""
    assert process.stderr is not None
    (line,) = itertools.islice(filter(re.compile(r"[\d.]+\n").fullmatch, process.stderr), 1)
    return float(line)


def test_an_attending_program_gets_progress_and_is_obeyed() -> None:
    """A pause stops the progress; after a cancel the results are marked as incomplete."""
    process = attended("--trade=arithmetic")
    assert process.stdin is not None
    first = fraction_told(process)
    assert 0.0 <= first < 0.2
    process.stdin.write("pause\nresume\n")
    process.stdin.flush()
    assert fraction_told(process) > first
    out, _ = process.communicate("cancel\n", timeout=PATIENCE_S)
    assert process.returncode == 130
    results = from_json(out)
    assert not results.complete
    assert results.trades[0].choices[0].error is not None


def test_it_ends_with_the_attending_program() -> None:
    process = attended("--trade=arithmetic")
    out, _ = process.communicate("", timeout=PATIENCE_S)
    assert process.returncode == 130 and not json.loads(out)["complete"]


def test_control_c_keeps_what_was_measured(tmp_path: Path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "app", "measure", "--attended", "--json", str(tmp_path / "a.json")],
        cwd=ROOT,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stderr is not None
    process.stderr.readline()
    process.send_signal(signal.SIGINT)
    # Standard input stays open: it is the signal that ends it.
    assert process.wait(PATIENCE_S) == 130
    assert not from_json((tmp_path / "a.json").read_text(encoding="utf-8")).complete
    process.communicate()


# --------------------------------------------------------------------------- what it means


def choice(name: str, cost: float | None, error: float | None, note: str = "") -> ChartPoint:
    return ChartPoint(name, cost, cost, error, note=note)


@pytest.mark.parametrize(
    "choices, words",
    [
        ([choice("a", 1.0, 1e-3)], "No choice is cheaper (1 ns) or more exact (0.001 px) than a"),
        (
            [choice("a", 1.0, 1.0), choice("b", 2.0, 1e-3), choice("c", 3.0, 1e-9)],
            "of those off by less than 0.01 px, none is cheaper than b",
        ),
        ([choice("a", 1.0, 1.0), choice("b", 2.0, 0.5)], "none is off by less than 0.01 px"),
        ([choice("a", None, None, "it broke")], "Nothing could be measured: it broke."),
        ([], "Nothing could be measured: -."),
    ],
)
def test_a_trade_has_one_sentence(
    choices: list[ChartPoint], words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    trade = Trade("arithmetic", "ns", "px", tuple(choices), 5)
    said = meaning(trade)
    assert words in said
    monkeypatch.setattr(meaning_module, "of_measure", str.upper)
    assert meaning(trade) != said


@pytest.mark.parametrize(
    ("cost", "name", "words"),
    [
        ("bytes", "12 bits", "12 bits instead of float32: 2.7 times smaller, at most 0.4 px off."),
        ("bytes", "wide", "wide instead of float32: 2 times larger, up to 1e-13 px off."),
        ("time", "12 bits", "12 bits instead of float32: 2 times slower, at most 0.4 px off."),
        ("time", "wide", "wide instead of float32: the same cost, up to 1e-13 px off."),
        ("time", "float32", ""),
        ("time", "untimed", ""),
    ],
)
def test_a_bargain_names_what_is_bought_and_what_is_paid(cost: str, name: str, words: str) -> None:
    choices = (
        ChartPoint("float32", 10.0, 11.0, 1e-5, 1e-4, bytes=12.0),
        ChartPoint("12 bits", 20.0, 21.0, 0.1, 0.4, bytes=4.5),
        ChartPoint("wide", 10.4, 11.0, 1e-13, bytes=24.0),
        ChartPoint("untimed", None, None, 1.0, bytes=6.0),
    )
    trade = Trade("arithmetic", "ns", "px", choices, 7).by_cost(cost)
    (chosen,) = (each for each in trade.choices if each.name == name)
    assert bargain(trade, chosen) == words


def test_the_cheapest_that_is_good_enough() -> None:
    trade = Trade(
        "detail", "ms", "px", (choice("a", 1.0, 3.0), choice("b", 2.0, 1.0)), 5
    )  # fmt: skip
    assert cheapest(trade, 0.5) is None
    assert cheapest(trade, 1.0) == trade.choices[1]
    assert cheapest(trade, 5.0) == trade.choices[0]


def test_help_names_every_trade_and_sweep() -> None:
    text = run("measure", "--help").stdout
    for name in (*TRADES, *SWEEPS):
        assert name in text


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--width", "1mm"), "width = 1 mm: must be from 2.71 to 1387 mm."),
        (("--size", "9000mmx90mm"), "width = 9000 mm: must be from 2.71 to 1387 mm."),
        (("--text-size", "0"), "text size = 0: must be from 0.24 to "),
        (("--text-size", "-4"), "text size = -4: must be from 0.24 to "),
        (("--width", "84mm", "--text-size", "100"), "text size = 100: must be from 0.24 to "),
    ],
)
def test_a_chart_of_no_possible_size_is_refused_before_it_is_measured(
    tmp_path: Path, words: tuple[str, ...], said: str
) -> None:
    done = run_here("measure", "--trade", "drift", "--chart", tmp_path / "chart.png", *words)
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and said in done.stderr
    assert not done.stdout and not list(tmp_path.iterdir())
