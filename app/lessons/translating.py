"""A lesson of the program in another language: only its sentences change.

A sentence is a paragraph, an item of a list, a cell of a table, a title, a choice or a reply.
Formulas, states, numbers and tests stand in the English file alone: a sentence has ``{0}``, ``{1}``
where they are. The other language has as many lines, so that a fault has the same line in all.
"""

import re
from collections.abc import Callable, Iterator
from itertools import pairwise

Translate = Callable[[str], str]
"""From a sentence of a file to that in another language."""

_FIXED = re.compile(r"\$\$.+?\$\$|\$[^$]+\$|\{[=~][^{}]*\}|`[^`]+`")
_WORD = re.compile(r"[^\W\d_]")
_FENCE = re.compile(r"(?:```+|~~~+)\s*(\w*)")
_TITLE = re.compile(r"(#+ +)(.*?)((?:\s*\{#[^{}]*\})?\s*)")
_TOP = re.compile(r"(title: *)(.*?)(\s*)")
_REPLY = re.compile(r"(\s*(?:says|title|why|hint|done):\s*)(.*?)(\s*)")
_CHOICE = re.compile(r"([-*]\s+\[[ xX]\]\s+)(.*?)((?:\s+\{[a-z][\w-]*\}|\s+:=\s.*)*\s*)")
_ITEM = re.compile(r"(\s*[-*]\s+)(.*?)(\s*)")
_PLAIN = re.compile(r"(\s*)(\S.*?)(\s*)")
_VALUE = re.compile(
    r"\s*(?:until|right|wrong|value|count|matrix|first|click|at|within|unit|vary|where|state|hide"
    r"|number|show|check|minutes|order|tiles)(?:\s+[\w-]+)?:.*"
)
_COMPARED = re.compile(r"view\.compare=.*?(?=; view\.|$)")
_PICTURE = re.compile(r"(?<=[=|])[^=|;:]*[^\W\d_][^=|;:]*(?=: )")  # the name of a compared one
_CELL = re.compile(r"(?<=\|)(\s*)([^|]+?)(\s*)(?=\|)")
_PROSE = ("predict", "task", "answer", "exercise", "note")  # the blocks that hold sentences


def parted(text: str) -> tuple[str, list[str]]:
    """Return a sentence with ``{0}``, ``{1}`` for its formulas, and these."""
    fixed: list[str] = []

    def number(match: re.Match[str]) -> str:
        fixed.append(match[0])
        return f"{{{len(fixed) - 1}}}"

    return _FIXED.sub(number, text), fixed


def in_language(text: str, translate: Translate) -> str:
    """Return a lesson's file with each of its sentences translated."""
    lines: list[str] = []
    sentence: list[re.Match[str]] = []  # the lines of the sentence that may go on

    def in_cell(match: re.Match[str]) -> str:
        return match[1] + _translated([match[2]], translate)[0] + match[3]

    def of_compared(match: re.Match[str]) -> str:
        return _PICTURE.sub(lambda name: translate(name[0]), match[0])

    def end() -> None:
        parts = _translated([match[2] for match in sentence], translate)
        whole = zip(sentence, parts, strict=True)
        lines.extend(match[1] + part + match[3] for match, part in whole)
        sentence.clear()

    for line, match in _matched(text.split("\n")):
        if match is None or match.re is not _PLAIN or (sentence and sentence[-1].re is _TITLE):
            end()
        if match is not None:
            sentence.append(match)
        elif line.startswith("|"):
            lines.append(_CELL.sub(in_cell, line))
        else:
            lines.append(_COMPARED.sub(of_compared, line))
    end()
    return "\n".join(lines)


def _matched(lines: list[str]) -> Iterator[tuple[str, re.Match[str] | None]]:
    block: str | None = "top"
    is_value = False  # of a block: whether an indented line continues a value
    for number, line in enumerate(lines):
        match: re.Match[str] | None = None
        if block == "top":
            match = _TOP.fullmatch(line)
            block = None if number and line.strip() == "---" else block
        elif fence := _FENCE.match(line):
            block, is_value = None if block is not None else fence[1], False
        elif block is None and line.strip() != "---" and not line.startswith("|"):
            match = _TITLE.fullmatch(line) or _ITEM.fullmatch(line) or _PLAIN.fullmatch(line)
        elif block in _PROSE and not line.startswith("|"):
            match = _REPLY.fullmatch(line) or _CHOICE.fullmatch(line)
            if match is not None or _VALUE.fullmatch(line):
                is_value = match is None
            elif not (is_value and line[:1] == " "):
                match, is_value = _ITEM.fullmatch(line) or _PLAIN.fullmatch(line), False
        yield line, match


def _translated(lines: list[str], translate: Translate) -> list[str]:
    """Return the lines of a sentence in the other language, if it has words."""
    template, fixed = parted(" ".join(lines))
    if not _WORD.search(re.sub(r"\{\d+\}", "", template)):
        return lines
    translated = translate(template)
    if translated == template:
        return lines
    words = translated.split(" ")
    cuts = [len(words) * at // len(lines) for at in range(len(lines) + 1)]
    return [
        re.sub(r"\{(\d+)\}", lambda place: fixed[int(place[1])], " ".join(words[begin:end]))
        for begin, end in pairwise(cuts)
    ]
