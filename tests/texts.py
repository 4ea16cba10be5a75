"""``python3 -m tests.texts OUT.py``: the texts of the content files, as a source for lupdate.

It reads no Markdown, but finds what is marked in Python::

    python3 -m tests.texts texts.py
    pyside6-lupdate app widgets texts.py -ts frustum_lab_hr.ts
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from app.bootstrap import ROOT
from app.drawings import SENTENCES as SENTENCES_OF_DRAWINGS
from app.lecture.kinds import KINDS
from app.model.lenses import LENSES, FreeMatrix
from app.model.parameter import read_sections, texts_of
from app.model.parameters import PARAMETERS
from app.model.refusal import SENTENCES
from app.scenes.built_in import WORDS, WORDS_OF_A_MESH
from app.scenes.phenomena import PHENOMENA

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


def source() -> str:
    """Python that marks them all."""
    from widgets.panels.frame_panel import STEP_TEXTS
    from widgets.parts.messages import FACTORS, SPACES

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
            *sentence_texts(),
            *wording_texts(),
        )
        for text in sorted(texts)
    )
    return "".join(lines)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="python3 -m tests.texts", description=__doc__)
    parser.add_argument("out", type=Path)
    parser.parse_args().out.write_text(source(), encoding="utf-8")
