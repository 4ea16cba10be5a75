"""The command ``talk``: every step drawn, what is wrong said with its line, and A4 pages."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.support.commands import one_sentence, run, run_here

TALK = """---
title: From <b> to $x$
letters: 001
---
# One {#one}
Words with $\\frac{1}{2}$ and <script>alert(1)</script>.

```state
scene=letter-f
```
```note
minutes: 1
Say hello.
```
---
# Two {#two}
```state
lens.near=2
view.large=ndc
```
```predict p
Which?
- [x] this
- [ ] that {none}
  says: No.
show: lens.near=3
why: So it is.
```
```note
minutes: 2.5
The notes.
```
"""


@pytest.fixture
def talk(tmp_path: Path) -> Path:
    path = tmp_path / "small.md"
    path.write_text(TALK)
    return path


def test_every_step_is_drawn_without_a_display(talk: Path) -> None:
    done = run("talk", talk, "--check", DISPLAY=None, WAYLAND_DISPLAY=None)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[-1] == "small.md: 2 steps drawn, 0 wrong"


@pytest.mark.parametrize(
    ("old", "new", "said", "last"),
    [
        ("lens.near=2\n", "lens.near=99\n", r"line 18.*near", "1 step drawn, 1 wrong"),
        ("show: lens.near=3", "show: lens.near=99", r"line 26.*near", "1 step drawn, 1 wrong"),
        ("\\frac{1}", "\\frac{1", r"line 6 = .*: has a formula", "2 steps drawn, 1 wrong"),
        ("# Two {#two}", "# Two {#one}", r"line 16", "0 steps drawn, 1 wrong"),
        ("scene=letter-f", "scene=nowhere", r"line 9.*nowhere", "0 steps drawn, 1 wrong"),
    ],
)
def test_what_is_wrong_is_said_with_its_line(
    talk: Path, old: str, new: str, said: str, last: str
) -> None:
    assert TALK.count(old) == 1
    talk.write_text(TALK.replace(old, new))
    done = run_here("talk", talk, "--check")
    lines = done.stdout.splitlines()
    assert done.returncode == 1
    assert re.search(f"small.md.*{said}", lines[0]), lines
    assert lines[-1] == f"small.md: {last}"
    assert len(lines) == int(last.split()[-2]) + 1


def pages_of(pdf: bytes) -> int:
    return len(re.findall(rb"/Type\s*/Page\b", pdf))


def images_of(pdf: bytes) -> int:
    return len(re.findall(rb"/Subtype\s*/Image\b", pdf))


def test_the_handout_has_every_step_with_figures(talk: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.pdf"
    out.write_text("of before")
    done = run("talk", talk, "--handout", out, DISPLAY=None, WAYLAND_DISPLAY=None)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    pdf = out.read_bytes()
    assert pdf.startswith(b"%PDF-") and pdf.rstrip().endswith(b"%%EOF")
    box = re.search(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)\s*\]", pdf)
    assert box is not None
    assert [round(float(side)) for side in box.groups()] == [595, 842]  # A4
    assert images_of(pdf) == 3  # each step's, and what the prediction comes to
    assert pages_of(pdf) == 2


def test_a_handout_is_written_whole_or_not_at_all(talk: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.pdf"
    out.write_bytes(b"of before")
    talk.write_text(TALK.replace("show: lens.near=3", "show: lens.near=99"))
    done = run("talk", talk, "--handout", out)
    assert "line 26" in one_sentence(done, 2)
    assert out.read_bytes() == b"of before"
    talk.unlink()
    assert "small.md does not exist" in one_sentence(run("talk", talk, "--handout", out), 2)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.pdf"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "needs --check or --handout OUT.pdf"),
        (("--handout", "out.png"), "must end in .pdf"),
        (("--handout", "/nowhere/out.pdf"), "there is no folder /nowhere"),
        (("--handouts", "out.pdf"), "the nearest is --handout"),
    ],
)
def test_a_wrong_command_line_is_refused(talk: Path, arguments: tuple[str, ...], said: str) -> None:
    assert said in one_sentence(run_here("talk", talk, *arguments), 2)
