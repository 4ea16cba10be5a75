"""Blocks that ask nothing.

``state``: what the window shows at the step; ``note``: text for the speaker only, and the planned
minutes; ``test``: sample answers of a step, and their expected verdicts.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from app.lessons.blocks import block
from app.lessons.lines import Body, number_in, refused
from app.model.refusal import REFUSALS


@dataclass(frozen=True, kw_only=True)
class ShownState(block.Block):
    """The state of a step; a step without one keeps the previous state."""

    kind = "state"
    once = True
    state: block.State

    def add_to(self, content: block.StepContent) -> None:
        content.state = self.state

    @classmethod
    def read(cls, body: Body) -> "ShownState":
        return cls(line=body.line, state=block.read_state(body.lines, body.line))


@dataclass(frozen=True, kw_only=True)
class Note(block.Block):
    """Text for the speaker only; a lesson with a note is a talk."""

    kind = "note"
    once = True
    text: str
    minutes: float
    text_line: int

    def add_to(self, content: block.StepContent) -> None:
        content.note = block.SpeakerNote(self.line, self.text, self.minutes)

    @classmethod
    def read(cls, body: Body) -> "Note":
        minutes, lines, first = None, [], 0
        for number, text in body.lines:
            if text.strip().startswith("minutes:"):
                if minutes is not None:
                    raise refused(number, REFUSALS["only-once"], "minutes")
                minutes = number_in(text.partition(":")[2].strip(), number, 0, 1000)
            elif re.match(r"\s*min\w*\s*[:=]\s*\d", text, re.IGNORECASE):
                raise refused(number, REFUSALS["unexpected"], "minutes", value=text.strip()[:60])
            else:
                lines.append(text)
                first = first or (number if text.strip() else 0)
        text, line = "\n".join(lines).strip(), body.line
        return cls(line=line, text=text, minutes=minutes or 0.0, text_line=first or line)

    def texts(self) -> Iterator[tuple[int, str]]:
        yield self.text_line, self.text


@dataclass(frozen=True, kw_only=True)
class Samples(block.Block):
    kind = "test"
    samples: tuple[block.Sample, ...]

    def add_to(self, content: block.StepContent) -> None:
        content.samples += self.samples

    @classmethod
    def read(cls, body: Body) -> "Samples":
        samples = (_sample(text, number) for number, text in body.lines if text.strip())
        return cls(line=body.line, samples=tuple(samples))

    def check(self, here: block.Here, trial: block.Trial) -> None:
        # A step lacks the blocks that cannot be read.
        for each in (each for each in self.samples if each.block in here.asked):
            trial.checks += 1
            with trial.kept():
                asked = here.asked[each.block]
                got = asked.verdict(here, each.text, each.line)
                if got != each.verdict:
                    drawn = asked.drawn(here, each.text)
                    why = (REFUSALS["of-variant"], got, each.verdict, drawn)
                    raise refused(
                        each.line, *(why if drawn else (REFUSALS["other-verdict"], *why[1:3]))
                    )


def _sample(text: str, line: int) -> block.Sample:
    name, colon, rest = text.partition(":")
    sample, arrow, verdict = rest.rpartition("->")
    if not colon or not arrow or not verdict.strip():
        raise refused(line, REFUSALS["a-sample"], value=text.strip()[:60])
    return block.Sample(name.strip(), sample.strip(), verdict.strip(), line)
