"""``python3 -m tests.texts``: bring the files of ``app/translations`` up to date.

Qt's lupdate finds what is marked in Python. It reads no Markdown, so that the texts of the content
files and the sentences of the lessons are given to it as Python that marks them. Then Qt Linguist,
or an editor, fills in what is ``unfinished``.
"""

if __name__ == "__main__":  # before anything is imported that it installs
    from app import bootstrap

    bootstrap.start("tests", extras=("test",))

import argparse
import ast
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from app.bootstrap import ROOT
from app.commands import options
from app.drawings import SENTENCES as SENTENCES_OF_DRAWINGS
from app.languages import ENGLISH, LANGUAGES, TRANSLATIONS, sentences
from app.lecture.kinds import KINDS
from app.lessons.contents import CONTENT
from app.lessons.text import SPOKEN
from app.lessons.translating import in_language
from app.model.lenses import LENSES, FreeMatrix
from app.model.parameter import read_sections, texts_of
from app.model.parameters import PARAMETERS
from app.model.refusal import SENTENCES
from app.scenes.built_in import WORDS, WORDS_OF_A_MESH
from app.scenes.phenomena import PHENOMENA
from tests.support.tools import ToolParser

TRANSLATED = [each for each in LANGUAGES if each not in (ENGLISH, "sr-Latn")]
QT_TEXTS = {"OK", "Save", "Cancel", "Close", "Discard", "&Yes", "&No"}
"""Buttons that Qt itself names, in languages that it has no texts in."""
SAID = {"said": 0, "CliError": 0, "SetupError": 0, "DisplayError": 0, "_Fonts": 0, "counted": 1,
        "_parsed": 1}  # fmt: skip
"""Which argument of a call is a sentence of a command, or what is counted."""
ARGPARSE = {
    "usage: ", "options", "positional arguments", "show this help message and exit",
    "argument %(argument_name)s: %(message)s", "expected one argument",
    "ignored explicit argument %r", "unrecognized arguments: %s",
    "the following arguments are required: %s",
}  # fmt: skip
"""What Python's parser of options says."""
EVERY_LENS = (*LENSES.values(), FreeMatrix)


def content_texts() -> set[str]:
    """The texts that the content files of the scenes hold."""
    phenomena = [phenomenon.words for phenomenon in PHENOMENA.values()]
    words = (*phenomena, *WORDS.values(), WORDS_OF_A_MESH)
    return {text for each in words for text in each.texts}


def parameter_texts() -> set[str]:
    """The texts of the parameters of camera, lens, image and object."""
    return {text for parameter in PARAMETERS.values() for text in texts_of(parameter)}


def help_texts() -> set[str]:
    """The texts of the Help menu, and of its table of keys."""
    from widgets.window.help import ABOUT, key_groups

    groups = key_groups()
    texts = {*groups, *(text for lines in groups.values() for line in lines for text in line)}
    _, *about = read_sections(ABOUT).items()
    return texts.union(*((heading, *section.text) for heading, section in about))


def menu_texts() -> set[str]:
    """The texts of the menus and the tool bar."""
    from widgets.window.actions import menus

    entries = [entry for menu in menus().values() for entry in menu.entries.values()]
    texts = {menu.title for name, menu in menus().items() if name}
    return texts.union(*((entry.text, entry.tip) for entry in entries)) - {""}


def sentence_texts() -> list[tuple[str, set[str]]]:
    """The texts of the page of sentences, by their contexts."""
    contexts = {section.partition("/")[0] for section in SENTENCES}
    return [
        (
            each,
            {
                text
                for name in SENTENCES
                if name.startswith(each)
                for text in SENTENCES[name].values()
            },
        )
        for each in sorted(contexts)
    ]


def wording_texts() -> list[tuple[str, set[str]]]:
    """The texts of the pages of `Wording`, each of which belongs to a module beside its folder."""
    from widgets.parts.wording import SENTENCES, Wording

    texts = []
    for module in sorted((ROOT / "widgets").rglob("*.py")):
        if "Wording(__file__)" in module.read_text(encoding="utf-8"):
            wording = Wording(str(module))
            context, *headings = wording.sections
            of_page = {heading.partition(" {#")[0] for heading in headings} - {SENTENCES}
            for each in wording.sections.values():
                of_page.update(each.text, *(text.split(" | ") for text in each.named.values()))
            texts.append((context, of_page))
    return texts


def command_texts() -> set[str]:
    """What ``--help`` says of the commands, their words and their options."""
    return {
        *(text for name, page in options.pages().items() if name != "--set" for text in page.texts),
    } - {argparse.SUPPRESS}  # fmt: skip


def said_texts() -> tuple[set[str], set[str]]:
    """The sentences of the commands and of the set-up, and the names of what they count."""
    texts, counted = {*sentences().values(), *ARGPARSE}, set[str]()
    page = (ROOT / "app" / "content" / "set-up.md").read_text("utf-8")
    texts.update(re.findall("(?m)^- .*?: (.*)", page))
    for node in (each for path in code() for each in ast.walk(ast.parse(path.read_text("utf-8")))):
        if isinstance(node, ast.Call):
            name = ast.unparse(node.func).rpartition(".")[2]
            match node.args[SAID.get(name, len(node.args)) :]:
                case [ast.Constant(value=str(text)), *_]:
                    (counted if name == "counted" else texts).add(text)
    return texts - set(sentences()), counted


def code() -> list[Path]:
    """The files of the program."""
    return [path for room in ("app", "widgets") for path in sorted((ROOT / room).rglob("*.py"))]


def _noted(sentences: list[str], text: str) -> str:
    sentences.append(text)
    return text


def lesson_texts() -> list[tuple[str, list[str]]]:
    """The sentences of the lessons, the talks and the wrong ideas, by the names of their files."""
    texts = []
    for path in sorted(CONTENT.glob("*.md")):
        sentences: list[str] = []
        in_language(path.read_text("utf-8"), partial(_noted, sentences))
        texts.append((path.stem, list(dict.fromkeys(sentences))))
    return texts


def source() -> str:
    """Python that marks them all."""
    from app.lecture.titles import FACTORS, SPACES
    from widgets.panels.frame_panel import STEP_TEXTS

    said, counted = said_texts()
    plural = [f'        self.tr("%n {each}s", "", n)\n' for each in sorted(counted)]
    lines = (
        f'QT_TRANSLATE_NOOP("{context}", {json.dumps(text, ensure_ascii=False)})\n'
        for context, texts in (
            ("phenomena", content_texts()),
            ("Field", parameter_texts()),
            ("Kind", {text for kind in KINDS.values() for text in (kind.title, kind.condition)}),
            ("Help", help_texts()),
            ("Look", set(SENTENCES_OF_DRAWINGS.values())),
            (
                "FramePanel",
                {text for name, each in STEP_TEXTS.items() for text in (name, *each.text)},
            ),
            ("Space", set(SPACES.values())),
            ("Factor", set(FACTORS.values())),
            ("Lens", {text for lens in EVERY_LENS for text in (lens.title, lens.tip)}),
            ("Actions", menu_texts()),
            ("Options", command_texts()),
            ("Command", said),
            ("Spoken", SPOKEN),
            ("QPlatformTheme", QT_TEXTS),
            *sentence_texts(),
            *wording_texts(),
        )
        for text in sorted(texts)
    )
    return "".join([*lines, "class Count:\n    def say(self, n):\n", *plural])


def lesson_source() -> str:
    """Python that marks the sentences of the lessons."""
    return "".join(
        f'QT_TRANSLATE_NOOP("{context}", {json.dumps(text, ensure_ascii=False)})\n'
        for context, texts in lesson_texts()
        for text in texts
    )


def update(folder: Path = TRANSLATIONS) -> None:
    """Bring the files of all languages up to date: Qt's lupdate marks what is new or has gone."""
    with tempfile.TemporaryDirectory() as made:
        for part, text, more in (("program", source(), code()), ("lessons", lesson_source(), [])):
            page = Path(made) / f"{part}.py"
            page.write_text(text, encoding="utf-8")
            for language in TRANSLATED:
                file = folder / f"{part}_{language}.ts"
                given = [*more, page, "-locations", "none", "-no-obsolete"]
                given += ["-source-language", "en"]
                tool = [Path(sys.executable).with_name("pyside6-lupdate"), *given]
                tool += ["-target-language", language, "-ts", file]
                subprocess.run(tool, check=True, capture_output=True)


def main(words: Sequence[str]) -> int:
    ToolParser("texts", __doc__).parse_args(words)
    update()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
