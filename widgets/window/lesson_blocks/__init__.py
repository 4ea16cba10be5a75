"""The views of the blocks that require an answer: one file each, and this table."""

from __future__ import annotations

from collections.abc import Callable

from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Part
from app.lessons.blocks.choices import Choices
from app.lessons.blocks.click import Click
from app.lessons.blocks.exercise import Exercise
from app.lessons.blocks.matrix import Matrix
from app.lessons.blocks.predict import Predict
from app.lessons.blocks.task import Task
from app.lessons.course import AtStep
from widgets.window.lesson_blocks.choices import Chooses
from widgets.window.lesson_blocks.click import Points
from widgets.window.lesson_blocks.exercise import Practises
from widgets.window.lesson_blocks.matrix import Fills
from widgets.window.lesson_blocks.number import Types
from widgets.window.lesson_blocks.task import Tries
from widgets.window.lesson_blocks.view import BlockView

VIEWS: dict[type[Part], Callable[..., BlockView]] = {
    Predict: Chooses,
    Choices: Chooses,
    Answer: Types,
    Matrix: Fills,
    Click: Points,
    Task: Tries,
    Exercise: lambda here, block: Practises(here, block, view_of),
}


def view_of(here: AtStep, block: Part) -> BlockView:
    return VIEWS[type(block)](here, block)
