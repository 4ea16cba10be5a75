"""The views of the blocks that require an answer: one file each, and this table."""

from collections.abc import Callable

from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Asked
from app.lessons.blocks.choices import Choices, Predict
from app.lessons.blocks.click import Click
from app.lessons.blocks.exercise import Exercise
from app.lessons.blocks.matrix import MatrixQuestion
from app.lessons.blocks.order import OrderQuestion
from app.lessons.blocks.task import Task
from app.lessons.player import PlayedBlock
from widgets.window.lesson_blocks.choices import ChoiceView
from widgets.window.lesson_blocks.exercise import ExerciseView
from widgets.window.lesson_blocks.marked import ClickView, NumberAnswerView, TaskView
from widgets.window.lesson_blocks.matrix import MatrixAnswerView
from widgets.window.lesson_blocks.order import OrderView
from widgets.window.lesson_blocks.view import BlockView

VIEWS: dict[type[Asked], Callable[..., BlockView]] = {
    Predict: ChoiceView,
    Choices: ChoiceView,
    Answer: NumberAnswerView,
    MatrixQuestion: MatrixAnswerView,
    Click: ClickView,
    OrderQuestion: OrderView,
    Task: TaskView,
    Exercise: lambda played, exercise: ExerciseView(played, exercise, view_of),
}


def view_of(played: PlayedBlock, question: Asked) -> BlockView:
    return VIEWS[type(question)](played, question)
