"""``note``: text for the speaker only, and the planned minutes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from app.lessons.blocks.block import Block, SpeakerNote, StepContent
from app.lessons.lines import ONLY_ONCE, UNEXPECTED, Body, number_in, refused


@dataclass(frozen=True, kw_only=True)
class Note(Block):
    """Text for the speaker only; a lesson with a note is a talk."""

    kind = "note"
    once = True
    text: str
    minutes: float
    text_line: int

    def add_to(self, content: StepContent) -> None:
        content.note = SpeakerNote(self.line, self.text, self.minutes)

    @classmethod
    def read(cls, body: Body) -> Note:
        minutes, lines, first = None, [], 0
        for number, text in body.lines:
            if text.strip().startswith("minutes:"):
                if minutes is not None:
                    raise refused(number, ONLY_ONCE, "minutes")
                minutes = number_in(text.partition(":")[2].strip(), number, 0, 1000)
            elif re.match(r"\s*min\w*\s*[:=]\s*\d", text, re.IGNORECASE):
                raise refused(number, UNEXPECTED, "minutes", value=text.strip()[:60])
            else:
                lines.append(text)
                first = first or (number if text.strip() else 0)
        text, line = "\n".join(lines).strip(), body.line
        return cls(line=line, text=text, minutes=minutes or 0.0, text_line=first or line)

    def texts(self) -> Iterator[tuple[int, str]]:
        yield self.text_line, self.text
