"""Many figures by one command: ``export --batch``."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

from app.document.document import Document
from app.document.files import write
from tests.support.commands import refused, run_here

SMALL = ("--size=64x32", "--panes=image")
LIST = """\
out,file,palette,lens.near,crop,set
a.png,,print,0.5,,
b&b.svg,kept.json,,,no,"lens.near=2
lens.far=11"
c.png,,,99999,,
../d.png,,,,,
A.png,,,,,

e.png,,pink,,,
f.png,,,,,,9
g.png,,,,maybe,
h.gif,,,,,
"""


def test_a_list_gives_the_figures_of_single_commands_and_names_each_line_that_fails(
    tmp_path: Path,
) -> None:
    source, out = tmp_path / "list.csv", tmp_path / "out"
    source.write_text(LIST)
    write(Document("cube"), tmp_path / "kept.json")
    done = run_here("export", out, "--batch", source, *SMALL, "--set=lens.far=12")
    assert done.returncode == 2
    of_line = f"{source}, line"
    assert done.stderr.splitlines() == [
        f"{of_line} 5: lens.near = 99999: must be less than far, which is 12.",
        f"{of_line} 6: out = '../d.png': must be a file name without a folder.",
        f"{of_line} 7: out = 'A.png': is written by {of_line} 2.",
        f"{of_line} 9: --palette = 'pink': must be one of screen, print, dark, contrast.",
        f"{of_line} 10: has 7 columns, but the first row names 6.",
        f"{of_line} 11: crop = 'maybe': must be yes or no.",
        f"{of_line} 12: OUT = '{out / 'h.gif'}': must end in .png, .svg, .pdf or .tex.",
    ]
    assert done.stdout.splitlines()[:3] == ["1/9 a.png", "2/9 b&b.svg", "3/9 c.png failed"]
    assert sorted(os.listdir(out)) == ["a.png", "b&b.svg", "index.html"]
    page = (out / "index.html").read_text()
    assert '<img src="./b%26b.svg" alt="b&amp;b.svg">' in page
    assert "<script" not in page and "must be less than far" in page

    alone = (tmp_path / "a.png", tmp_path / "b.svg")
    near = ("--set=lens.far=12", "--set=lens.near=0.5", "--palette=print")
    both = (tmp_path / "kept.json", "--set=lens.near=2", "--set=lens.far=11")
    for file, name, own in zip(alone, ("a.png", "b&b.svg"), (near, both), strict=True):
        assert run_here("export", file, *own, *SMALL).returncode == 0
        assert (out / name).read_bytes() == file.read_bytes()

    os.utime(out / "b&b.svg", (1, 1))  # older than the list
    again = run_here("export", out, "--batch", source, *SMALL, "--set=lens.far=12", "--resume")
    assert again.stdout.splitlines()[:2] == ["1/9 a.png is there already", "2/9 b&b.svg"]
    assert (out / "b&b.svg").stat().st_mtime > 1


def test_a_folder_gives_a_figure_of_each_document(tmp_path: Path) -> None:
    documents, out = tmp_path / "lecture", tmp_path / "out"
    documents.mkdir()
    assert "has no documents" in refused("export", out, "--batch", documents)
    write(Document("cube"), documents / "one.json")
    shutil.copy(documents / "one.json", documents / "two.json")
    (documents / "three.json").write_text("{")
    done = run_here("export", out, "--batch", documents, *SMALL, "--format=svg")
    assert (done.returncode, done.stderr.count("three.json")) == (2, 2)
    assert sorted(os.listdir(out)) == ["index.html", "one.svg", "two.svg"]


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "has no figures"),
        (b"out\n", "has no figures"),
        (b"\xff\xfe", "is not UTF-8 text."),
        (b"file\na.json\n", "line 1: has no column out"),
        (b"out,out\n", "line 1: has two columns out."),
        (b"out,pallete\n", "line 1: 'pallete' is not a column; the nearest is palette."),
        (b"out,batch\n", "'batch' is not a column"),
        (b'out\n"a.png', "line 2: is not CSV"),
        (b"out\n" + b"a" * 200_000, "field larger than field limit"),
        (b"out\n" * 300_000, "is larger than 1 MiB."),
        (b"out,lens.near\na.png,1\0\n", "line 2: lens.near = '1\\x00': has a character NUL."),
        (b"out\na\0.png\n", "line 2: out = 'a\\x00.png': must be a file name"),
        (b"out\nC:a.png\n", "line 2: out = 'C:a.png': must be a file name without a folder."),
    ],
)  # fmt: skip
def test_a_list_that_cannot_be_read_is_refused(content: bytes, said: str, tmp_path: Path) -> None:
    source = tmp_path / "list.csv"
    source.write_bytes(content)
    done = run_here("export", tmp_path / "out", "--batch", source)
    assert done.returncode == 2 and said in done.stderr
    assert done.stderr.count("\n") == 1


def test_a_figure_of_a_list_does_not_follow_a_link(tmp_path: Path) -> None:
    source, out = tmp_path / "list.csv", tmp_path / "out"
    source.write_text("out\na.png\n")
    out.mkdir()
    (out / "a.png").symlink_to(tmp_path / "elsewhere.png")
    assert "is a link" in run_here("export", out, "--batch", source).stderr
    assert not (tmp_path / "elsewhere.png").exists()
    assert "must be a folder" in refused("export", source, "--batch", source)
    assert "needs --batch" in refused("export", "a.png", "--resume")
