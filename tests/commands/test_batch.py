"""Many figures by one command: ``export --batch``."""

import os
import re
import shutil
import sys
from pathlib import Path

import pytest

from app import languages
from app.document.document import Document
from app.document.files import write
from app.languages import said
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
    source.write_text(LIST, encoding="utf-8")
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
        f"{of_line} 11: crop = 'maybe': must be true or false.",
        f"{of_line} 12: OUT = '{out / 'h.gif'}': must end in .png, .svg, .pdf or .tex.",
    ]
    assert done.stdout.splitlines()[:3] == ["1/9 a.png", "2/9 b&b.svg", "3/9 c.png failed"]
    assert sorted(os.listdir(out)) == ["a.png", "b&b.svg", "index.html"]
    page = (out / "index.html").read_text(encoding="utf-8")
    alts = dict(re.findall('<img src="./([^"]*)" alt="([^"]*)">', page))
    assert "near 0.5, far 12. " in alts["a.png"] and "near 2, far 11. " in alts["b%26b.svg"]
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


def test_each_figure_of_a_list_has_its_language(tmp_path: Path) -> None:
    source, out = tmp_path / "list.csv", tmp_path / "out"
    rows = ["out,language", "a.svg,hr", "b.svg,", "c.svg,xx", "d.svg,et"]
    source.write_text("\n".join(rows), encoding="utf-8")
    done = run_here("export", out, "--batch", source, *SMALL)
    assert done.stderr.endswith("'xx': must be one of en, hr, sr, sr-Latn, et.\n")
    titles = [re.findall("<title>(.*?)</title>", (out / f"{name}.svg").read_text("utf-8"))[0]
              for name in "abd"]  # fmt: skip
    assert titles == ["Slovo F", "Letter F", "F-täht"]
    assert languages.chosen() == "en"


def test_a_list_in_latin_1_is_read_with_a_note(tmp_path: Path) -> None:
    source, out = tmp_path / "list.csv", tmp_path / "out"
    source.write_bytes("out\ncafé.tif\n".encode("latin-1"))
    done = run_here("export", out, "--batch", source)
    assert done.stderr.splitlines() == [
        f"{source} {said('read-as-latin-1')}.",
        f"{source}, line 2: OUT = '{out / 'café.tif'}': must end in .png, .svg, .pdf or .tex.",
    ]


def test_a_folder_gives_a_figure_of_each_document(tmp_path: Path) -> None:
    documents, out = tmp_path / "lecture", tmp_path / "out"
    documents.mkdir()
    assert "has no documents" in refused("export", out, "--batch", documents)
    write(Document("cube"), documents / "one.json")
    shutil.copy(documents / "one.json", documents / "two.json")
    (documents / "three.json").write_text("{", encoding="utf-8")
    done = run_here("export", out, "--batch", documents, *SMALL, "--format=svg")
    assert (done.returncode, done.stderr.count("three.json")) == (2, 2)
    assert sorted(os.listdir(out)) == ["index.html", "one.svg", "two.svg"]


LESSON = """\
---
title: Three
---
# One {#one}
```state
scene=cube
view.slide=image,ndc
```
---
# Two {#two}
```state
lens.near=99
```
---
# Three {#three}
```state
document: kept.json
```
"""


def test_lessons_give_a_figure_of_each_step(tmp_path: Path) -> None:
    lecture, out = tmp_path / "lecture", tmp_path / "out"
    lecture.mkdir()
    (lecture / "three.md").write_text(LESSON, encoding="utf-8")
    (lecture / "wrong.md").write_text("---\n", encoding="utf-8")
    (lecture / "README.md").write_text("# Not a lesson\n", encoding="utf-8")
    write(Document("letter-f"), lecture / "kept.json")
    done = run_here("export", out, "--batch", lecture, *SMALL)
    assert done.returncode == 2
    assert done.stdout.splitlines() == [
        "1/5 kept.png",
        "2/5 three-01-one.png",
        "3/5 three-02-two.png failed",
        "4/5 three-03-three.png",
        "5/5 wrong failed",
    ]
    two, wrong = done.stderr.splitlines()
    assert two.startswith(f"{lecture / 'three.md'}, step 2: ") and "line 12" in two
    assert wrong.startswith(f"{lecture / 'wrong.md'}: ") and "title" in wrong
    assert sorted(os.listdir(out)) == [
        "index.html", "kept.png", "three-01-one.png", "three-03-three.png",
    ]  # fmt: skip
    alone = tmp_path / "alone.png"
    assert run_here("export", alone, lecture / "three.md", "--step=one", *SMALL).returncode == 0
    assert alone.read_bytes() == (out / "three-01-one.png").read_bytes()

    os.utime(lecture / "kept.json")  # newer than the figures; the third step shows it
    again = run_here("export", out, "--batch", lecture / "three.md", *SMALL, "--resume")
    assert [line.partition("png")[2] for line in again.stdout.splitlines()] == ["", " failed", ""]
    os.utime(lecture / "kept.json", (1, 1))
    again = run_here("export", out, "--batch", lecture / "three.md", *SMALL, "--resume")
    assert again.stdout.splitlines()[2] == "3/3 three-03-three.png is there already"


def test_a_list_names_a_step_of_a_lesson_or_takes_all(tmp_path: Path) -> None:
    source, out = tmp_path / "list.csv", tmp_path / "out"
    (tmp_path / "three.md").write_text(LESSON, encoding="utf-8")
    write(Document("letter-f"), tmp_path / "kept.json")
    rows = (
        "a.png,three.md,three", "b%02d.png,three.md,", "c.png,three.md,", "d.png,three.md,9",
        "e.png,001,cut",
    )  # fmt: skip
    source.write_text("\n".join(("out,file,step", *rows)), encoding="utf-8")
    done = run_here("export", out, "--batch", source, *SMALL)
    assert done.returncode == 2
    assert sorted(os.listdir(out)) == ["a.png", "b01.png", "b03.png", "e.png", "index.html"]
    assert (out / "a.png").read_bytes() == (out / "b03.png").read_bytes()
    _, whole, none = done.stderr.splitlines()
    assert whole.startswith(f"{source}, line 4: file = 'three.md': is a lesson; name its step")
    assert none.startswith(f"{source}, line 5: --step = '9': must be a number from 1 to 3")
    assert none.endswith("or the name of a step."), "no name is near a number"
    slide = tmp_path / "slide.svg"
    for wanted, shown in ((), ("Image", "Cube")), (("--panes=world",), ("World",)):
        done = run_here(
            "export", slide, tmp_path / "three.md", "--step=one", "--size=64x32", *wanted
        )
        assert done.returncode == 0
        assert (
            tuple(re.findall(r"(World|Cube|Image): ", slide.read_text(encoding="utf-8"))) == shown
        )
    assert "is a column of the list" in refused("export", out, "--batch", source, "--step=1")


@pytest.mark.skipif(sys.platform == "win32", reason="no limit of a file's size")
def test_a_full_disk_leaves_nothing_half_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import resource

    source, out, film = tmp_path / "list.csv", tmp_path / "out", tmp_path / "film.gif"
    source.write_text(
        "out,panes,size\na.png,image,9x9\nb.png,world,99x99\nc.png,image,9x9\n", encoding="utf-8"
    )
    film.write_bytes(b"old")
    monkeypatch.setattr(sys, "dont_write_bytecode", True)  # it would be cut off
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4000, limits[1]))
    try:
        done = run_here("export", out, "--batch", source)
        moving = run_here("export", film, "--orbit", "--frames=2", "--panes=world", "--size=99x99")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert done.returncode == moving.returncode == 2
    words = "cannot be written: File too large."
    assert done.stderr == f"{source}, line 3: {out / 'b.png'} {words}\n"
    assert moving.stderr == f"{film} {words}\n"
    assert sorted(os.listdir(out)) == ["a.png", "c.png", "index.html"]
    assert film.read_bytes() == b"old"
    assert sorted(os.listdir(tmp_path)) == ["film.gif", "list.csv", "out"]


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "has no figures"),
        (b"out\n", "has no figures"),
        (b"\xff\xfe", "has no figures"),
        ("out,out\n".encode("utf-16"), "line 1: has two columns out."),
        (b"file\na.json\n", "line 1: has no column out"),
        (b"out,out\n", "line 1: has two columns out."),
        (b"out,pallete\n", "line 1: 'pallete' is not a column; the nearest is palette."),
        (b"out,batch\n", "'batch' is not a column"),
        (b"out;scene\n", "'out;scene' is one column; they are separated by commas"),
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
    source.write_text("out\na.png\n", encoding="utf-8")
    out.mkdir()
    (out / "a.png").symlink_to(tmp_path / "elsewhere.png")
    assert "is a link" in run_here("export", out, "--batch", source).stderr
    assert not (tmp_path / "elsewhere.png").exists()
    assert "must be a folder" in refused("export", source, "--batch", source)
    assert "needs --batch" in refused("export", "a.png", "--resume")
