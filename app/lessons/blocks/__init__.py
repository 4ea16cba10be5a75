"""The kinds of block."""

from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Block
from app.lessons.blocks.choices import Predict
from app.lessons.blocks.exercise import Exercise
from app.lessons.blocks.shown import Note, Samples, ShownState
from app.lessons.blocks.task import Task

_CLASSES = ShownState, Predict, Task, Answer, Exercise, Note, Samples
KINDS: dict[str, type[Block]] = {kind.kind: kind for kind in _CLASSES}
