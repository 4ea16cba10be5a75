"""The pages of `Wording` have what their modules ask for, and nothing else."""

import re

import pytest

from app.bootstrap import ROOT
from app.document.view import FIXED
from app.lecture.stages import STOPS
from app.lessons.strokes import COLOURS
from widgets.parts.wording import SENTENCES, Wording

OF_MODEL = {*STOPS, *FIXED, *COLOURS}  # keys that no module of the window writes
MODULES = [
    module
    for module in sorted((ROOT / "widgets").rglob("*.py"))
    if "Wording(__file__)" in module.read_text(encoding="utf-8")
]


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.stem)
def test_every_word_of_a_page_is_asked_for_and_every_one_asked_for_is_there(module):
    words = Wording(str(module))
    text = module.read_text(encoding="utf-8")
    sentences = words.sections[SENTENCES].named if SENTENCES in words.sections else {}
    keys = {key for heading in words.sections for key in re.findall(r"{#(.+)}", heading)}
    asked = set(re.findall(r"WORDS(?:\[|\.\w+\()\"([^\"]+)\"", text))
    assert asked <= {*sentences, *keys}
    written = {key for key in {*sentences, *keys} if re.search(f"[\"']{key}[\"']", text)}
    assert {*sentences, *keys} <= {*written, *OF_MODEL}
    assert all(words[key] for key in keys)


def test_a_panel_without_its_section_is_told_which_is_missing() -> None:
    words = Wording(str(ROOT / "widgets" / "window" / "main_window.py"))
    with pytest.raises(KeyError, match="MainWindow has no heading"):
        words["no-panel"]
