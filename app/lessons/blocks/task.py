"""``task``: something to do in the window, in any way."""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

from app.document.document import Document
from app.document.settings import set_values
from app.document.view import PANES, View
from app.lessons.blocks.block import Asked, Here, State, Trial, Verdict, state_in
from app.lessons.blocks.question import Reply
from app.lessons.lines import Body, on_line, refused
from app.lessons.quantities import Condition
from app.model.limits import check_name
from app.model.parameters import DISTANCE, EYE, FAR, NEAR, TARGET, WINDOW_SIDES
from app.model.refusal import REFUSALS

DONE = "done"  # kept as the answer of a finished task, and the verdict on a sample that fulfils it
_PANES = "view.panes="
_NEXT = re.compile(r"(?<!\s)\s+(?=[\w.]+=)")  # between assignments: a chain has spaces of its own
_IN_CONDITIONS = {"panes": "turned", "probes": "_"}
"""The names that conditions have for fields of the view with other names."""
_MOVED = NEAR, FAR, EYE, DISTANCE, TARGET, *WINDOW_SIDES
_MOVED_BY = {each.formula: each.handle for each in _MOVED}
"""The handle of the world that changes the quantity of a name."""


@dataclass(frozen=True, kw_only=True)
class Wrong(Reply):
    """A wrong idea of a task: while its condition holds, the task is not done."""

    condition: Condition


@dataclass(frozen=True, kw_only=True)
class Task(Asked):
    """A task: done when all of `until` hold; then the student reads `done`."""

    kind = "task"
    has_field = False
    until: tuple[tuple[int, Condition], ...]
    done: str
    replies: tuple[Wrong, ...] = ()
    right: State | None = None  # a state that fulfils the task, for the check; `why` tells the way

    @classmethod
    def read(cls, body: Body) -> "Task":
        text, items = body.items("until", "done", "hint", "why", "wrong", "right")
        until = items.conditions("until")
        if not until:
            raise refused(body.line, REFUSALS["lacks"], "“until: CONDITION”")
        wrong = zip(items.every("wrong"), items.conditions("wrong"), strict=True)
        replies = tuple(Wrong.of(item, condition=each) for item, (_, each) in wrong)
        return cls(
            **cls.fields(body, text, items), until=until, done=items.text("done"),
            why=items.text("why"), replies=replies, right=state_in(items.single("right")),
        )  # fmt: skip

    @property
    def handles(self) -> frozenset[str]:
        handles = set()
        for name in (name for _, condition in self.until for name in condition.letters):
            head, _, rest = name.removeprefix("was_").partition("_")
            setting = rest.rpartition("_")[0] or rest
            handles.add(setting if head == "settings" else _MOVED_BY.get(head, ""))
        return frozenset(handles - {""})

    def is_done(self, here: Here, now: Document, view: View | None = None) -> bool:
        known = here.quantities(now, view)
        for line, condition in self.until:
            with on_line(line, "until"):
                if not condition.holds(known):
                    return False
        return True

    def mistaken_in(self, here: Here, now: Document, view: View | None = None) -> Wrong | None:
        known = here.quantities(now, view)
        for wrong in self.replies:
            with on_line(wrong.line, "wrong"):
                if wrong.condition.holds(known):
                    return wrong
        return None

    def accepts(self, here: Here, kept: str) -> bool:
        return True

    def is_about(self, change: str) -> bool:
        section, _, name = change.partition("=")[0].partition(".")
        asked = " ".join(condition.text for _, condition in self.until)
        return section != "view" or _IN_CONDITIONS.get(name, name) in asked

    @property
    def can_be_revealed(self) -> bool:
        return bool(self.why) or self.right is not None

    def right_sample(self, here: Here) -> str:
        return ", ".join(condition.text for _, condition in self.until)

    def reasons(self, here: Here) -> Iterator[str]:
        yield self.done
        yield self.why

    def check_tried(self, verdicts: Collection[str], trial: Trial) -> None:
        for wrong in self.replies:
            if Verdict(False, wrong.idea).word not in verdicts:
                trial.add_fault(
                    refused(wrong.line, REFUSALS["not-tried"], value=wrong.condition.text)
                )

    def verdict_in(
        self, here: Here, now: Document, view: View | None = None
    ) -> tuple[int, Verdict] | None:
        wrong = self.mistaken_in(here, now, view)
        return None if wrong is None else (wrong.line, wrong.verdict(here))

    def check_values(self, here: Here) -> None:
        """Refuse a wrong idea that leads to the right state."""
        if self.right is not None and self.replies:
            wrong = self.mistaken_in(here, here.shown_by(self.right))
            if wrong is not None:
                raise refused(wrong.line, REFUSALS["task-also-right"], value=wrong.condition.text)

    def check_right(self, here: Here) -> None:
        """Refuse a right state that does not fulfil the task."""
        if self.right is not None and not self.is_done(here, here.shown_by(self.right)):
            raise refused(self.right.line, REFUSALS["not-done"])

    def check(self, here: Here, trial: Trial) -> None:
        trial.checks += 1
        for wrong in self.replies:
            wrong.check(here, trial)
        if self.is_done(here, here.document):
            raise refused(self.line, REFUSALS["nothing-to-do"])
        self.check_right(here)
        self.check_values(here)

    def verdict(self, here: Here, sample: str, line: int) -> str:
        own = here.document
        with on_line(line):
            now = _with_sample(own, _NEXT.split(sample))
        if self.is_done(here, now):
            return DONE
        wrong = self.mistaken_in(here, now)
        return "open" if wrong is None else wrong.verdict(here).word


def _with_sample(document: Document, assignments: Sequence[str]) -> Document:
    """Apply the values of a sample; ``view.panes=world`` stands for any turn of a pane by hand."""
    document = set_values(document, (each for each in assignments if not each.startswith(_PANES)))
    turned = dict(document.view.panes)
    for each in assignments:
        names = each.removeprefix(_PANES) if each.startswith(_PANES) else ""
        for name in filter(None, names.split(",")):
            check_name("view.panes", name, PANES)
            turned[name] = document.projection.camera
    return replace(document, view=replace(document.view, panes=turned))
