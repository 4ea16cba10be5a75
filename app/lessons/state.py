"""The state of a step: assignments of ``--set``, or a document file."""

import re
from typing import NamedTuple

from app.lessons.lines import LACKS, ONLY_ONCE, LineItem, Lines, refused
from app.model.refusal import QT_TRANSLATE_NOOP

AN_ASSIGNMENT = QT_TRANSLATE_NOOP("Refusal", "must be NAME=VALUE, or document: FILE.json")
BESIDE = QT_TRANSLATE_NOOP("Refusal", "must be a file beside the lesson, or in a folder there")


class State(NamedTuple):
    """A state: ``NAME=VALUE`` lines with their numbers, or a document beside the file."""

    line: int
    values: tuple[tuple[int, str], ...] = ()
    document: str = ""
    document_line: int = 0

    @property
    def begins_anew(self) -> bool:
        """Whether it names a scene or a document, and so ignores the previous step."""
        return bool(self.document) or any(path_of(text) == "scene" for _, text in self.values)


def path_of(assignment: str) -> str:
    return assignment.partition("=")[0].strip()


def read_state(lines: Lines, line: int) -> State:
    """Read the state of a block that begins at a line."""
    values: list[tuple[int, str]] = []
    document, document_line = "", 0
    names = set[str]()
    for number, text in lines:
        text = text.strip()
        if not text:
            continue
        is_document = text.startswith("document:")
        name = "document" if is_document else path_of(text)
        if name in names:
            raise refused(number, ONLY_ONCE, name)
        names.add(name)
        if is_document:
            document, document_line = _beside(text[len(name) + 1 :].strip(), number), number
        elif "=" in text:
            values.append((number, _mesh_beside(text, number)))
        else:
            raise refused(number, AN_ASSIGNMENT, value=text[:60])
    if not values and not document:
        raise refused(line, LACKS, "NAME=VALUE")
    return State(line, tuple(values), document, document_line)


def state_in(item: LineItem | None) -> State | None:
    """Read a state on one line, its values separated by semicolons."""
    if item is None:
        return None
    return read_state([(item.line, part) for part in item.text.split(";")], item.line)


def _mesh_beside(text: str, line: int) -> str:
    """Return an assignment; refuse one that names a file outside the lesson's folder."""
    value = text.partition("=")[2].strip()
    is_file = bool(set(value) & set("/\\:")) or value.startswith("~")
    if path_of(text) in ("scene", "mesh") and is_file:
        _beside(value, line)
    return text


def _beside(path: str, line: int) -> str:
    """Return the path of a file that is in the lesson's folder or below it."""
    parts = re.split(r"[/\\]", path)
    if not path or path[0] in "/\\~" or ".." in parts or ":" in path:
        raise refused(line, BESIDE, value=path[:60])
    return path
