"""Every text of the program is translated, and says what the English one says."""

import ast
import re
import shutil
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import pytest

from app.bootstrap import ROOT
from app.languages import TRANSLATIONS
from tests import texts

FORMS = {"hr": 3, "sr": 3, "et": 2}
_PLACES = re.compile(r"\{\w*(?:![rs])?(?::[^{}]*)?\}|%n|%(?:\(\w+\))?[srd]")
_NUMBER = re.compile(r"\d+(?:\.\d+)?")


class Message(NamedTuple):
    """A message of a file: its context, its text in English, and its forms."""

    context: str
    source: str
    forms: tuple[str, ...]
    counts: bool


def messages(path: Path) -> Iterator[Message]:
    for context in ElementTree.parse(path).getroot().iter("context"):
        for each in context.iter("message"):
            translation = each.find("translation")
            assert translation is not None
            if translation.get("type") in ("vanished", "obsolete"):
                continue
            is_done = translation.get("type") != "unfinished"
            forms = tuple(form.text or "" for form in translation) or (translation.text or "",)
            counts = each.get("numerus") == "yes"
            name, source = context.findtext("name", ""), each.findtext("source", "")
            yield Message(name, source, forms if is_done else (), counts)


FILES = [f"{part}_{language}" for part in ("program", "lessons") for language in FORMS]


@pytest.mark.parametrize("file", FILES)
def test_every_text_is_translated_and_keeps_what_is_inserted(file: str) -> None:
    faults = []
    for message in messages(TRANSLATIONS / f"{file}.ts"):
        count = FORMS[file[-2:]] if message.counts else 1
        if len(message.forms) != count or not all(map(str.strip, message.forms)):
            faults.append(f"{message.context}: {message.source[:60]!r} is not translated")
        for form in message.forms:
            for pattern in (_PLACES, _NUMBER, re.compile(r"\*\*"), re.compile(r"&(?=\w)")):
                there, here = pattern.findall(message.source), pattern.findall(form)
                if Counter(there) != Counter(here):
                    faults.append(f"{message.source[:60]!r}: {there}, and {here} in {form[:60]!r}")
    assert not faults, "\n".join(faults[:20])


def test_the_files_are_up_to_date(tmp_path: Path) -> None:
    """Another lupdate may lay out the file otherwise: the texts count."""
    for path in TRANSLATIONS.glob("*.ts"):
        shutil.copy(path, tmp_path)
    texts.update(tmp_path)
    changed = {
        path.name: {each[:2] for each in messages(path)}
        ^ {each[:2] for each in messages(TRANSLATIONS / path.name)}
        for path in sorted(tmp_path.glob("*.ts"))
    }
    assert len(changed) == len(FILES)
    assert not any(changed.values()), "run python3 -m tests.texts, and translate what is new"


_SAYS = {
    "write_out",
    "print_error",
    "log",
    "show",
    "CliError",
    "SetupError",
    "DisplayError",
    "Finding",
}
_TWO_WORDS = re.compile(r"(?<![\w-])[a-z]{2,} [a-z]{2,}(?![\w-])")


def _written(node: ast.AST) -> Iterator[str]:
    """The texts below a node, but for what `said` translates."""
    if isinstance(node, ast.Call) and ast.unparse(node.func).endswith("said"):
        return
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    for child in ast.iter_child_nodes(node):
        yield from _written(child)


def test_commands_and_the_set_up_write_no_words_past_the_translation() -> None:
    names = ("bootstrap", "system_packages", "held_lock", "commands/*", "lessons/checking")
    programs = [path for name in names for path in (ROOT / "app").glob(f"{name}.py")]
    programs += [ROOT / "widgets" / "program" / f"{name}.py" for name in ("display", "opengl")]
    faults, calls = [], 0
    for path in programs:
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Call) and (name := ast.unparse(node.func)) in _SAYS:
                calls += 1
                # An error translates its sentence if it is one text, which lupdate is given.
                is_text = name.endswith("Error") and isinstance(node.args[0], ast.Constant)
                texts = [text for each in node.args[is_text:] for text in _written(each)]
                faults += [f"{path.name}: {text}" for text in texts if _TWO_WORDS.search(text)]
    assert calls > 150
    assert not faults
