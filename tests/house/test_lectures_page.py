"""Every topic of the lectures is in the table, with a test that bears its name and pictures."""

import re
from pathlib import Path

from app.bootstrap import ROOT
from app.scenes.phenomena import PHENOMENA

PAGE = (Path(ROOT) / "docs" / "lectures.md").read_text(encoding="utf-8")


def test_every_topic_has_its_row_its_tests_and_its_picture() -> None:
    tests = "\n".join(
        path.read_text(encoding="utf-8") for path in (Path(ROOT) / "tests").rglob("test_*.py")
    )
    shown = {
        int(n) for names in re.findall(r"!\[([^\]]*)\]", PAGE) for n in re.findall(r"\d+", names)
    }
    for number in range(1, 25):
        assert f"\n| L{number} | " in PAGE
        assert f"def test_l{number}_" in tests, number
        assert number in shown or number == 3, number  # whose picture is that of L20


def test_every_picture_and_every_scene_of_the_page_is_there() -> None:
    for name in re.findall(r"\]\(([^)]+)\)", PAGE):
        assert (Path(ROOT) / "docs" / name).is_file(), name
    for phenomenon in PHENOMENA.values():
        assert f"*{phenomenon.words.title}*" in PAGE, phenomenon.words.title
