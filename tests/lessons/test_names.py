"""The page of all names, which a command prints."""

from app.bootstrap import ROOT
from tests.support.commands import run_here


def test_the_page_of_names_is_up_to_date() -> None:
    """If it is not: ``python3 -m app lesson names > docs/lesson-names.md``."""
    page = (ROOT / "docs" / "lesson-names.md").read_text(encoding="utf-8")
    assert run_here("lesson", "names").stdout == page
    assert "`camera-obscura` | `distance` (0.001 to 1e+06) | `on_the_film`" in page
