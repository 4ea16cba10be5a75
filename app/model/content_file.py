"""The content files: Markdown with a heading for each parameter, setting or kind of projection.

::

    ## Near {#near}
    The tooltip.
    - also: n plane zNear
    - value: label of this choice | its explanation

lupdate reads no Markdown: `tests/texts.py` makes a source for it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from app.model.parameter import Parameter

_EXPLAINED = " | "
_OWN = ("row", "said", "other", "also", "drag")
"""Items that are no choices, but texts of the parameter with the same name."""


class ContentSection(NamedTuple):
    """What stands below one heading: lines of text, and the items of a list."""

    text: list[str]
    items: list[str]

    @property
    def named(self) -> dict[str, str]:
        return dict(item.split(": ", 1) for item in self.items)


def sections_of(text: str) -> dict[str, ContentSection]:
    """Return the sections of a content file's text by their headings."""
    sections: dict[str, ContentSection] = {}
    for line in filter(None, text.splitlines()):
        if line.startswith("#"):
            section = sections.setdefault(line.lstrip("# "), ContentSection([], []))
        elif line.startswith("- "):
            section.items.append(line[2:])
        else:
            section.text.append(line)
    return sections


def section_of(name: str, sections: Mapping[str, ContentSection]) -> tuple[str, ContentSection]:
    """Return the heading of a thing, and what stands below it."""
    ending = f" {{#{name}}}"
    heading = next(each for each in sections if each.endswith(ending))
    return heading.removesuffix(ending), sections[heading]


def worded(parameter: Parameter, sections: Mapping[str, ContentSection]) -> Parameter:
    """Return a parameter with the texts below its heading."""
    title, section = section_of(parameter.name, sections)
    items = section.named
    own: dict[str, Any] = {name: items.pop(name) for name in _OWN if name in items}
    choices = {name: text.partition(_EXPLAINED) for name, text in items.items()}
    return replace(
        parameter,
        title=title,
        tip=section.text[0],
        choices=tuple((name, text) for name, (text, _, _) in choices.items()),
        tips=tuple(tip for _, _, tip in choices.values()),
        **own,
    )


def read_sections(path: Path) -> dict[str, ContentSection]:
    """Return the sections of a content file by their headings."""
    return sections_of(path.read_text(encoding="utf-8"))


@cache
def _sections() -> dict[str, ContentSection]:
    return read_sections(Path(__file__).with_name("content") / "parameters.md")


def stated(name: str, **columns: Any) -> Parameter:
    """Return a parameter of the model with its texts."""
    return worded(Parameter(name, **columns), _sections())


def texts_of(parameter: Parameter) -> set[str]:
    """Return every text of a parameter that can be translated."""
    labels = (text for _, text in parameter.choices)
    own = (getattr(parameter, name) for name in ("title", "tip", *_OWN))
    return {text for text in (*own, *labels, *parameter.tips) if text}
