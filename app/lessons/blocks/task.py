"""``task``: something to do in the window, in any way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from app.document.document import Document
from app.document.settings import set_values
from app.document.view import PANES, View
from app.lessons.blocks.block import Asked, Here, Trial
from app.lessons.blocks.question import with_numbers
from app.lessons.lines import LACKS, Body, on_line, refused
from app.lessons.quantities import Condition
from app.model.formula import latex
from app.model.limits import ONE_OF
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

NOTHING_TO_DO = QT_TRANSLATE_NOOP("Refusal", "is done before the student does anything")
_PANES = "view.panes="
_MOVED_BY = {
    "near": "near", "far": "far", "eye": "eye", "distance": "eye", "target": "target",
    "left": "corner", "right": "corner", "bottom": "corner", "top": "corner",
}  # fmt: skip
"""Which handle of the world moves what a name stands for."""


@dataclass(frozen=True, kw_only=True)
class Task(Asked):
    """A task: done when all of `until` hold; then the student reads `done`."""

    kind = "task"
    until: tuple[tuple[int, Condition], ...]
    done: str

    @classmethod
    def read(cls, body: Body) -> Task:
        text, items = body.items("until", "done", "hint")
        until = items.conditions("until")
        if not until:
            raise refused(body.line, LACKS, "“until: CONDITION”")
        return cls(**cls.fields(body, text, items), until=until, done=items.text("done"))

    @property
    def handles(self) -> frozenset[str]:
        """The handles of the world that change what the task is about, by name or setting."""
        found = set()
        for name in (name for _, condition in self.until for name in condition.letters):
            head, _, rest = name.removeprefix("was_").partition("_")
            setting = rest.rpartition("_")[0] or rest
            found.add(setting if head == "settings" else _MOVED_BY.get(head, ""))
        return frozenset(found - {""})

    def is_done(self, here: Here, now: Document, view: View | None = None) -> bool:
        """Whether the window's current state fulfils the task; a `Refusal` names the line."""
        known = here.quantities(now, view)
        for line, condition in self.until:
            with on_line(line, "until"):
                if not condition.holds(known):
                    return False
        return True

    def solution(self, here: Here) -> str:
        """Return the values that numbers of an exercise ask for, as Markdown; else an empty text.

        Each is a condition in letters, with the numbers put in, and its value.
        """
        known, lines = here.quantities(), list[str]()
        for line, condition in self.until:
            left, right = condition.left, condition.right
            if left is not None and right is not None and {*right.letters} & {*here.given}:
                with on_line(line, "until"):
                    sides = right, *with_numbers([right], known)
                    value = f"{known.value(right):.4g}"
                texts = dict.fromkeys((*(latex(side, {}) for side in sides), value))
                lines.append(f"${latex(left, {})} {condition.sign} {' = '.join(texts)}$")
        return "  \n".join(lines)

    def check(self, here: Here, trial: Trial) -> None:
        trial.checks += 1
        if self.is_done(here, here.document):
            raise refused(self.line, NOTHING_TO_DO)

    def verdict(self, here: Here, sample: str, line: int) -> str:
        own = here.document
        with on_line(line):
            now = _after(own, sample.split())
        return "done" if self.is_done(here, now) else "open"


def _after(document: Document, assignments: Sequence[str]) -> Document:
    """Apply the values of a sample; ``view.panes=world`` stands for any turn of a pane by hand."""
    document = set_values(document, (each for each in assignments if not each.startswith(_PANES)))
    turned = dict(document.view.panes)
    for each in assignments:
        names = each.removeprefix(_PANES) if each.startswith(_PANES) else ""
        for name in filter(None, names.split(",")):
            if name not in PANES:
                raise Refusal("view.panes", name, ONE_OF, ", ".join(PANES))
            turned[name] = document.projection.camera
    return replace(document, view=replace(document.view, panes=turned))
