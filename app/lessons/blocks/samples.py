"""``test``: sample answers of a step, and their expected verdicts."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace

from app.lessons.blocks.block import Block, Here, Sample, StepContent, Trial
from app.lessons.lines import Body, refused
from app.model.limits import ONE_OF
from app.model.refusal import QT_TRANSLATE_NOOP

A_SAMPLE = QT_TRANSLATE_NOOP("Refusal", "must be a sample like “NAME: SAMPLE -> VERDICT”")
OTHER_VERDICT = QT_TRANSLATE_NOOP("Refusal", "gets “{0}” instead of “{1}”")
OF_VARIANT = QT_TRANSLATE_NOOP("Refusal", "gets “{0}” instead of “{1}”; this variant has {2}")


@dataclass(frozen=True, kw_only=True)
class Samples(Block):
    """Sample answers of a step."""

    kind = "test"
    samples: tuple[Sample, ...]

    def add_to(self, content: StepContent) -> None:
        content.samples += self.samples

    def only_for(self, asked: Collection[str]) -> Samples:
        return replace(self, samples=tuple(each for each in self.samples if each.block in asked))

    @classmethod
    def read(cls, body: Body) -> Samples:
        samples = (_sample(text, number) for number, text in body.lines if text.strip())
        return cls(line=body.line, samples=tuple(samples))

    def check_names(self, asked: Iterable[str]) -> None:
        for each in self.samples:
            if each.block not in asked:
                raise refused(each.line, ONE_OF, ", ".join(asked) or "none", value=each.block)

    def check(self, here: Here, trial: Trial) -> None:
        for each in self.samples:
            trial.checks += 1
            with trial.kept():
                asked = here.asked[each.block]
                got = asked.verdict(here, each.text, each.line)
                if got != each.verdict:
                    drawn = asked.drawn(here, each.text)
                    why = (OF_VARIANT, got, each.verdict, drawn)
                    raise refused(each.line, *(why if drawn else (OTHER_VERDICT, *why[1:3])))


def _sample(text: str, line: int) -> Sample:
    name, colon, rest = text.partition(":")
    sample, arrow, verdict = rest.rpartition("->")
    if not colon or not arrow or not verdict.strip():
        raise refused(line, A_SAMPLE, value=text.strip()[:60])
    return Sample(name.strip(), sample.strip(), verdict.strip(), line)
