"""The kinds of block: one file each, and this list."""

from typing import Protocol

from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Block
from app.lessons.blocks.exercise import Exercise
from app.lessons.blocks.note import Note
from app.lessons.blocks.predict import Predict
from app.lessons.blocks.samples import Samples
from app.lessons.blocks.shown import ShownState
from app.lessons.blocks.task import Task
from app.lessons.lines import Body


class Kind(Protocol):
    """A class of blocks that a lesson's file can name."""

    kind: str
    once: bool
    needs_answer: bool

    def read(self, body: Body) -> Block:
        """Read a block; a `Refusal` names the line that is wrong."""


KINDS: dict[str, Kind] = {
    kind.kind: kind for kind in (ShownState, Predict, Task, Answer, Exercise, Note, Samples)
}
