"""The common base of predictions and answers: one right reply, and wrong ones with their ideas.

The value of a reply is one number, those of a matrix, or the coordinates of a place. A wrong number
can be shown beside the right one: the model with each of them, as compared pictures.
"""

import difflib
import math
from abc import abstractmethod
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Self, TypeAlias

from app.document.compare import ComparedPicture
from app.document.document import Document
from app.document.settings import set_values
from app.document.view import PANES
from app.lessons import marking
from app.lessons.blocks.block import REVEALED, Asked, Here, State, Trial, Verdict, state_in
from app.lessons.blocks.working import has_way, in_markdown, working
from app.lessons.lines import Body, Items, LineItem, on_line, refused
from app.lessons.marking import UNITS, TypedNumber
from app.lessons.quantities import Condition, NotThere, Quantities
from app.model.formula import Formula, Letter, parse
from app.model.parameters import FOCAL_E, FOV_X, FOV_Y, PARAMETERS
from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal

YOURS = QT_TRANSLATE_NOOP("phenomena", "your idea")
MODEL = QT_TRANSLATE_NOOP("phenomena", "the model")

_PATHS = {  # of the numbers of a lens that are fields of a document
    each.formula: each.path
    for each in PARAMETERS.values()
    if each.section == "lens" and not each.changes
}
_OF_WIDTH = (FOV_X.formula, FOCAL_E.formula)
"""Numbers of the horizontal angle, which the lens has from the vertical one."""


def beside(here: Here, own: Document, name: str, wrong: float) -> Document | None:
    """Return a state that shows another value of a number beside its own one.

    None if no value of ``--set`` is this number, or the model does not allow the value.
    """
    change = _change(own, name, wrong)
    try:
        value = here.quantities(set_values(own, [change])).value(Letter(name)) if change else None
    except (Refusal, NotThere):
        return None
    if value is None or not math.isclose(value, wrong, rel_tol=1e-9):
        return None
    pictures = ComparedPicture(YOURS, (change,)), ComparedPicture(MODEL, live=True)
    return replace(own, view=replace(own.view, compare=pictures, dividers=(), large="image"))


def _change(own: Document, name: str, value: float) -> str:
    """Return the assignment that gives a number a value; empty if there is none."""
    if name in _OF_WIDTH:
        is_angle = name == FOV_X.formula
        if not 0.0 < value < (180.0 if is_angle else math.inf):
            return ""
        across = math.tan(math.radians(value / 2.0)) if is_angle else 1.0 / value
        name, value = FOV_Y.formula, 2.0 * math.degrees(math.atan(across / own.projection.aspect))
    if name.startswith("settings_"):
        return f"settings.{name.removeprefix('settings_')}={value!r}"
    return f"{_PATHS[name]}={value!r}" if name in _PATHS else ""


Value: TypeAlias = tuple[float, ...]  # an answer's numbers: one, a matrix by rows, or coordinates

LETTERS = "ABCDEFGHIJ"  # the letters by which a class names the choices
RIGHT = "\N{NO-BREAK SPACE}**✓**"  # marks the right answer, in Markdown
HIDDEN = ("numbers", "lens", "scale", *PANES)
"""What a question may hide; the scale on paper only, where a ruler would find the answer."""
CHECKS = ("check", "why", "hint", "hide")  # keys that every question may have


@dataclass(frozen=True, kw_only=True)
class Reply:
    """An answer that the lesson expects, the formulas of its value, and the response to it."""

    line: int
    right: bool = False
    formulas: tuple[Formula, ...] = ()
    idea: str = ""
    title: str = ""
    says: str = ""
    state: State | None = None

    @classmethod
    def of(cls, item: LineItem, **more: Any) -> Self:
        """Return the reply of a choice or a wrong value, with what is indented below it."""
        below = Items(item.below)
        more = {"idea": item.about, "state": state_in(below.single("state")), **more}
        return cls(line=item.line, title=below.text("title"), says=below.text("says"), **more)

    def verdict(self, here: Here, why: str = "") -> Verdict:
        """Return the verdict; a known idea supplies a title, and words with their state."""
        says = self.says
        state = here.shown_by(self.state) if self.state is not None else None
        if self.right:
            return Verdict(True, says=says or why, state=state)
        idea, title = here.idea(self.idea), self.title
        if idea is not None:
            title = title or idea.title
            if not says:  # its state belongs to its own words
                says, state = idea.says, state or idea.state
        return Verdict(False, self.idea, says, state, title=title.rstrip("."))

    def check(self, here: Here, trial: Trial) -> None:
        """Report an unknown idea without a sentence, and an impossible state."""
        if self.idea and here.idea(self.idea) is None and not self.says:
            near = difflib.get_close_matches(self.idea, here.idea_names, n=1, cutoff=0.0)[0]
            trial.add_fault(refused(self.line, REFUSALS["no-idea"], near, value=self.idea))
        if self.right and self.idea:
            trial.add_fault(refused(self.line, REFUSALS["idea-of-right"], value=self.idea))
        if not (self.right or self.idea or self.says):
            trial.add_fault(refused(self.line, REFUSALS["no-reply"]))
        if self.state is not None:
            with trial.kept():
                here.shown_by(self.state)

    def check_number(self, value: float) -> None:
        """Refuse a number in the text that differs from its formula's value."""


@dataclass(frozen=True, kw_only=True)
class Question(Asked):
    reveals: ClassVar[bool] = True
    is_on_paper: ClassVar[bool] = True
    replies: Sequence[Reply]  # choices, or the wrong values that have an idea
    checks: tuple[tuple[int, Condition], ...] = ()  # they hold if the right reply is correct
    symbol: str = ""  # TeX of what the value is called in its worked solution
    number: str = ""
    """The name of the number of the model that the value is; empty if it is none, or is the key."""

    @staticmethod
    def fields(body: Body, text: str, items: Items) -> dict[str, Any]:
        checks, why = items.conditions("check"), items.text("why")
        hide = items.single("hide")
        hides = frozenset[str]() if hide is None else frozenset(hidden_in(hide.text, hide.line))
        return Asked.fields(body, text, items) | {"checks": checks, "why": why, "hides": hides}

    @property
    @abstractmethod
    def key(self) -> tuple[tuple[Formula, ...], int]:
        """Return the formulas of the right value, if there are any, and their line."""

    @property
    def answer_line(self) -> int:
        return self.key[1]

    def right_sample(self, here: Here) -> str:
        try:
            values = self.values(here, *self.key)
        except Refusal:
            return ""
        return self.sample_of([f"{each:.{marking.digits_shown(each, 5)}g}" for each in values])

    def sample_of(self, numbers: Sequence[str]) -> str:
        """Return the numbers of an answer as a sample."""
        return " ".join(numbers)

    def printed(self, numbers: Sequence[str]) -> str:
        return ("; " if "," in "".join(numbers) else ", ").join(numbers)

    def mistakes(self, here: Here, write: Callable[[float], str]) -> Iterator[tuple[str, str]]:
        for letter, reply in zip(LETTERS, self.replies, strict=False):
            if reply.idea and not reply.right:
                name = reply.verdict(here).title or reply.idea.replace("-", " ")
                numbers = [write(each) for each in self.values(here, reply.formulas, reply.line)]
                yield name, self.printed(numbers) if numbers else letter

    def known(self, here: Here) -> Quantities:
        """Return the quantities for its formulas: of the state that it shows, if it shows one."""
        return here.quantities(here.shown_by(self.show) if self.show is not None else None)

    def values(self, here: Here, formulas: tuple[Formula, ...], line: int) -> Value:
        """Return the values of some of its formulas; a `Refusal` names the line."""
        known = self.known(here)
        with on_line(line, "formula"):
            try:
                return tuple(known.value(formula) for formula in formulas)
            except NotThere as error:
                raise refused(line, REFUSALS["no-value"], str(error)) from error

    def are_alike(self, here: Here, one: Value, other: Value) -> bool:
        """Whether two values cannot be told apart: the same typed numbers would count as both."""
        return all(map(marking.are_alike, one, other))

    def check(self, here: Here, trial: Trial) -> None:
        trial.checks += 1
        known = self.known(here)
        for line, condition in self.checks:
            with trial.kept(), on_line(line, "check"):
                if not condition.holds(known):
                    raise refused(line, REFUSALS["not-so"], value=condition.text)
        for reply in self.replies:
            reply.check(here, trial)
        value, wrong = None, list[tuple[int, Value]]()
        for owner, formulas, line in self.formulas:
            with trial.kept():
                values = self.values(here, formulas, line)
                if owner is not None:
                    with trial.kept():
                        owner.check_number(values[0])
                if owner is None or owner.right:
                    value = values
                    with trial.kept():
                        self._check_number(here, line, *values)
                else:
                    wrong.append((line, values))
        for clash in self._clashes(here, value, wrong):
            trial.add_fault(clash)

    def _check_number(self, here: Here, line: int, *value: float) -> None:
        """Refuse a number of the model that is not the right value, or that cannot be set."""
        if self.number:
            known = self.known(here)
            with on_line(line, "number"):
                held = known.value(parse(self.number))
            is_held = math.isclose(value[0], held, rel_tol=1e-9)
            if not is_held or not _change(known.document, self.number, 1.0):
                raise refused(line, REFUSALS["other-number"], f"{held:.6g}", value=self.number)

    def check_values(self, here: Here) -> None:
        """Refuse a value that does not exist, and wrong ones that equal another one."""
        values = [
            (reply, line, self.values(here, formulas, line))
            for reply, formulas, line in self.formulas
        ]
        value = next((v for reply, _, v in values if reply is None or reply.right), None)
        wrong = [(line, v) for reply, line, v in values if reply is not None and not reply.right]
        for clash in self._clashes(here, value, wrong):
            raise clash

    @property
    def formulas(self) -> Iterator[tuple[Reply | None, tuple[Formula, ...], int]]:
        """Yield the formulas of every value, with its reply, if it has one, and its line."""
        formulas, line = self.key
        right = next((reply for reply in self.replies if reply.right), None)
        if formulas:
            yield right, formulas, line
        for wrong in self.replies:
            if not wrong.right and wrong.formulas:
                yield wrong, wrong.formulas, wrong.line

    def solution(self, here: Here) -> str:
        """Return the way to the answer as Markdown: in letters, with the step's numbers, its value.

        Empty if there is none: the formula is a number or a name, or no reader knows a name in it.
        """
        formulas, _ = self.key
        is_way = any(has_way(each) for each in formulas)
        steps = working(formulas[0], self.known(here)) if is_way else None
        return in_markdown(steps.sides(self.symbol, self.unit)) if steps is not None else ""

    def reply_to(self, here: Here, wrong: Reply) -> Verdict:
        """Return the reply to a wrong idea, with both numbers beside each other where it can be."""
        verdict = wrong.verdict(here)
        formulas, _ = self.key
        name = self.number or (formulas[0].text if len(formulas) == 1 else "")
        if len(wrong.formulas) != 1 or not name:
            return verdict
        (value,) = self.values(here, wrong.formulas, wrong.line)
        return verdict._replace(beside=beside(here, self.known(here).document, name, value))

    def _clashes(
        self, here: Here, value: Value | None, wrong: Sequence[tuple[int, Value]]
    ) -> Iterator[Refusal]:
        """Yield the refusals of wrong values that equal the right one, or an earlier wrong one."""
        for place, (line, each) in enumerate(wrong):
            if value is not None and self.are_alike(here, each, value):
                yield refused(line, REFUSALS["also-right"], _figures(value))
            for before, other in wrong[:place]:
                if self.are_alike(here, each, other):
                    yield refused(line, REFUSALS["same-wrong"], before, _figures(other))


@dataclass(frozen=True, kw_only=True)
class MarkedQuestion(Question):
    """A question whose answer is marked each time; `right` are the formulas of its value."""

    right: tuple[Formula, ...]
    right_line: int

    @property
    def key(self) -> tuple[tuple[Formula, ...], int]:
        return self.right, self.right_line

    @staticmethod
    def fields(body: Body, text: str, items: Items) -> dict[str, Any]:
        unit = items.single("unit")
        if unit is not None and unit.text.lower() not in UNITS:
            raise refused(unit.line, REFUSALS["one-of"], ", ".join(UNITS), value=unit.text)
        more = {"unit": items.text("unit"), "number": items.text("number")}
        return Question.fields(body, text, items) | more

    def mistaken(
        self,
        here: Here,
        numbers: Sequence[TypedNumber],
        is_value: Callable[[TypedNumber, float], bool],
    ) -> Verdict | None:
        """Return the reply to the wrong idea whose values are typed, if there is one."""
        for wrong in self.replies:
            if all(map(is_value, numbers, self.values(here, wrong.formulas, wrong.line))):
                return self.reply_to(here, wrong)
        return None

    def accepts(self, here: Here, kept: str) -> bool:
        try:
            return kept == REVEALED or self.mark(here, kept).right
        except Refusal:
            return False

    def reasons(self, here: Here) -> Iterator[str]:
        yield self.solution(here)
        yield self.why

    def check_tried(self, verdicts: Collection[str], trial: Trial) -> None:
        if Verdict(True).word not in verdicts:
            trial.add_warning(refused(self.right_line, REFUSALS["no-right"], self.name))

    def verdict(self, here: Here, sample: str, line: int) -> str:
        with on_line(line):
            try:
                return self.mark(here, sample).word
            except Refusal as error:
                if error.field != "answer":
                    raise
                return "no number"


def hidden_in(text: str, line: int) -> set[str]:
    """Read the names of the things that a question hides."""
    names = {name.strip() for name in text.split(",")}
    for name in names.difference(HIDDEN):
        raise refused(line, REFUSALS["one-of"], ", ".join(HIDDEN), value=name)
    return names


def _figures(value: Value) -> str:
    return ", ".join(f"{each:.6g}" for each in value)
