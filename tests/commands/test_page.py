"""A page for phones: ``export figure.html``. No browser is needed to see what is in it."""

import base64
import hashlib
import re
from collections.abc import Iterator
from html import escape
from pathlib import Path

import pytest

from app.drawings import page, vectors
from tests.support.commands import refused, run_here
from tests.support.html import Read
from tests.support.meshes import PYRAMID, obj_file

SIZE = ("--size=64x48", "--text-size=2")
SWEEP = "--sweep=lens.near=2:4"


def slots_of(text: str) -> Iterator[list[str]]:
    """What the script of a page writes into its places, for each state."""
    found = dict(re.findall(r'<script type="text/plain" id="(\w+)">\n(.*?)\n</script>', text, re.S))
    parts = found["parts"].split("\n")
    assert len(parts) == len(set(parts))
    for state in found["states"].split("\n"):
        slots = []
        for slot in state.split(";"):
            ends = [[int(end, 36) for end in run.split("-")] for run in slot.split(",")]
            slots.append("".join("".join(parts[run[0] : run[-1] + 1]) for run in ends))
        yield slots


# With a label: its leader is before it, and its halo has the tint below it.
HALO = r' stroke="[^"]*"(?= stroke-width="[^"]*" opacity=)'
MOVES = rf' transform="[^"]*"| d="[^"]*"(?=/><g stroke=)|{HALO}'


def test_a_page_has_every_state_whole_and_the_middle_one_without_scripts(tmp_path: Path) -> None:
    out = tmp_path / "a.html"
    sweep = (SWEEP, "--frames=3", "--set=view.probes=0,1,0", *SIZE, "--panes=image,ndc")
    assert run_here("export", out, *sweep).stderr == ""
    text = out.read_text("utf-8")
    read = Read(text)
    assert read.open == [] and len(read.ids) == len(set(read.ids)) > 8
    assert re.findall("https?:|url\\((?!data:font)|@import|src=", text) == []
    states = list(slots_of(text))
    assert [slots[4] for slots in states] == ["near n = 2", "near n = 3", "near n = 4"]
    assert all(f"near {near}, far 12.5." in states[k][5] for k, near in enumerate("234"))
    alone = tmp_path / "alone.svg"
    of_one = ("--set=lens.near=4", "--panes=ndc", *sweep[2:5])
    assert run_here("export", alone, *of_one).returncode == 0
    root = dict(Read(alone.read_text("utf-8")).given)["svg"]
    inherited = [name for name in root if name.startswith(("role", "fill", "stroke"))]
    for tag, given in read.given:
        assert tag != "svg" or [given[name] for name in inherited] == [root[n] for n in inherited]
    elements = "".join(alone.read_text("utf-8").split("</desc>")[1].splitlines()[1:-1])
    # But for the labels' places and leaders: they are those of all states together.
    drawn = re.sub(r'(id="|#)p1t', r"\1t", states[2][2])
    bare, alone_bare = (re.sub(MOVES, "", each) for each in (drawn, elements))
    assert bare == alone_bare
    svgs = re.findall(r"<svg [^>]*data-slot>(.*?)</svg>", text)
    assert svgs == [states[1][0], states[1][2]]
    assert dict(read.given)["form"]["hidden"] is None and ("output", "near n = 3") in read.texts
    slider = dict(read.given)["input"]
    assert (slider["max"], slider["value"], slider["aria-label"]) == ("2", "1", "near n")


def test_the_sliders_values_are_told_apart(tmp_path: Path) -> None:
    out = tmp_path / "a.html"
    for sweep, expected in (
        ("lens.near=4:4.00002", ["near n = 4", "near n = 4.00001", "near n = 4.00002"]),
        ("view.stage=1:1.00002", ["stage = 1", "stage = 1.00001", "stage = 1.00002"]),
    ):
        options = ("--sweep", sweep, "--frames=3", *SIZE, "--panes=ndc")
        assert run_here("export", out, *options).stderr == ""
        states = slots_of(out.read_text("utf-8"))
        assert [next(text for text in slots if " = " in text) for slots in states] == expected


def test_only_the_pages_own_script_runs_and_one_state_has_none(tmp_path: Path) -> None:
    strange = tmp_path / '<b id="x">&amp;\u202e.obj'
    obj_file(strange, PYRAMID)
    texts = []
    for options in ([SWEEP, "--frames=2"], [SWEEP, "--frames=2"], []):
        out = tmp_path / "a.html"
        assert run_here("export", out, strange, *options, "--panes=image").returncode == 0
        texts.append(out.read_text("utf-8"))
    assert texts[0] == texts[1] != texts[2]
    for text in texts[1:]:
        read = Read(text)
        assert "b" not in [tag for tag, _ in read.given] and "x" not in read.ids
        assert escape('<b id="x">&amp;') in text and "\u202e" not in text
        policy = next(given["content"] for tag, given in read.given if "http-equiv" in given)
        assert policy is not None and policy.startswith("default-src 'none'; img-src data:;")
        for tag in ("style", "script"):
            bare = re.findall(f"<{tag}>(.*?)</{tag}>", text, re.S)
            hashes = [
                f"'sha256-{base64.b64encode(hashlib.sha256(each.encode()).digest()).decode()}'"
                for each in bare
            ]
            assert re.findall(f"{tag}-src ([^;]*)", policy) == hashes
    assert "<script" not in text and "<input" not in text


def test_a_large_page_is_written_and_says_what_makes_it_smaller(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page, "LARGEST", 2000)
    monkeypatch.setattr(vectors, "MOST_CELLS", 10)
    done = run_here("export", tmp_path / "a.html", "--panes=image", "--hidden=grey")
    assert (tmp_path / "a.html").read_text("utf-8").count("data:image/png;base64,") == 1
    assert done.returncode == 0 and (tmp_path / "a.html").exists()
    assert done.stderr.startswith("a.html has ")
    assert done.stderr.endswith(" should have at most 2 kB: ask for fewer --panes.\n")


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ("--loop=once", "--loop: is not for .html, whose pictures change"),
        ("--crop", "--crop: is not for .html"),
        ("--scale=2", "--scale: is for .png"),
        ("--frames=1", "--frames = 1: must be a whole number from 2"),
        ("--size=64000x48", "--size width = 64000: must be"),
    ],
)
def test_options_of_other_figures_are_refused(tmp_path: Path, option: str, words: str) -> None:
    assert words in refused("export", tmp_path / "a.html", SWEEP, option)
