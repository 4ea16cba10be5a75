"""The tools beside the suite: each says what it is for, and what is wrong with a word."""

from importlib import import_module
from pathlib import Path

import pytest

from tests.fuzz.__main__ import TOOLS

STARTED = 'if __name__ == "__main__":'
NAMES = [
    path.stem
    for path in sorted(Path(__file__).parents[1].glob("[!_]*.py"))
    if STARTED in path.read_text(encoding="utf-8")
]


@pytest.mark.parametrize("name", [*NAMES, "fuzz.__main__", *(f"fuzz.{tool}" for tool in TOOLS)])
def test_every_tool_has_help_and_one_sentence_for_a_wrong_word(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    tool = import_module(f"tests.{name}")
    with pytest.raises(SystemExit) as ended:
        tool.main(["--help"])
    assert ended.value.code == 0 and tool.__doc__.splitlines()[0] in capsys.readouterr().out
    if name == "portable":  # pytest reads the other words
        return
    with pytest.raises(SystemExit) as ended:
        tool.main(["--not-an-option"])
    said = capsys.readouterr().err
    assert ended.value.code == 2 and said.count("\n") == 1 and said.startswith("python3 -m tests.")


@pytest.mark.parametrize("name", ["tex", "composition", "pictures", "mutants"])
def test_a_word_that_names_nothing_is_named(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        import_module(f"tests.{name}").main(["list", "no-such-thing"][name != "mutants" :])
    assert ended.value.code == 2 and "no-such-thing" in capsys.readouterr().err
