"""README and docs show what the program draws, all of it and nothing else."""

import re
from pathlib import Path

import pytest
from PIL import Image
from PySide6.QtGui import QCursor

from app.bootstrap import ROOT
from tests import pictures


@pytest.mark.usefixtures("qapp")
def test_the_pictures_are_what_the_program_draws(tmp_path: Path) -> None:
    """A sample: ``python3 -m tests.pictures`` draws all of them.

    The pointer rests on a row of a window, which lights up in no picture.
    """
    QCursor.setPos(960, 540)
    assert pictures.compare([*pictures.PICTURES][::3], tmp_path) == {}


def test_every_picture_is_shown_somewhere_and_can_be_drawn_anew() -> None:
    pages = [Path(ROOT) / "README.md", *pictures.DOCS.glob("*.md")]
    shown = {
        Path(name).name
        for page in pages
        for name in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", page.read_text(encoding="utf-8"))
    }
    assert (
        shown
        == set(pictures.PICTURES)
        == {path.name for path in pictures.DOCS.iterdir() if path.suffix in (".png", ".gif")}
    )


def test_the_captions_of_the_charts_are_what_was_measured() -> None:
    page = (pictures.DOCS / "measurements.md").read_text(encoding="utf-8")
    charts = [name for name in pictures.PICTURES if name.startswith("measure-")]
    assert len(re.findall(r"\n\*[^*]", page)) == len(charts) - 1, "the sweeps have none"
    assert pictures.captioned(page) == page


def test_a_moved_label_is_detected(tmp_path: Path) -> None:
    path = pictures.DOCS / "scene-focus.png"
    with Image.open(path) as image:
        changed = image.convert("RGB")
    changed.paste(changed.crop((214, 236, 290, 254)), (280, 10))
    changed.save(tmp_path / "moved.png")
    assert pictures.different(path, path) == 0.0
    assert pictures.different(path, tmp_path / "moved.png") > pictures.MOST_DIFFERENT
