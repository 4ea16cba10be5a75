"""The marks of a lesson's steps: where the student is, what is done, what is practice."""

from functools import partial

from PySide6.QtCore import Signal
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QToolButton, QWidget

from app.lessons.player import Player
from app.lessons.text import in_line
from widgets.parts.layouts import FREE, discard, in_row, tool_button
from widgets.parts.plain import PlainLabel
from widgets.parts.roles import give_role

MOST_MARKS = 12  # most steps for which each has a mark
MOST_COUNTED = 8  # most marks beside which there is room for the number of the step


class StepMarks(QWidget):
    """A button for each step, and the number of the current one."""

    chosen = Signal(int)  # the user wants to go to a step, from 0

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("stepMarks")
        self.setAccessibleName(self.tr("Steps"))
        give_role(self, QAccessible.Role.PageTabList)
        self._numbers: list[QToolButton] = []
        self._heads: list[QWidget] = []  # the words before the marks of steps with an exercise
        self._counted = PlainLabel(objectName="paneNote")
        self._row = in_row(FREE, self._counted, on=self, margins=(0, 0, 0, 0), gap=2)

    def make(self, player: Player) -> None:
        row, lesson = self._row, player.lesson
        discard(row, (*self._numbers, *self._heads))
        self._numbers.clear()
        self._heads.clear()
        before = False
        for place, step in enumerate(lesson.steps if len(lesson.steps) <= MOST_MARKS else ()):
            practises = lesson.practises(step)
            if practises and not before:
                head = PlainLabel(self.tr("Practice"), objectName="paneNote")
                head.setContentsMargins(5, 0, 2, 0)
                self._heads.append(head)
                row.insertWidget(place + len(self._heads) - 1, head)
            before = practises
            act = partial(self.chosen.emit, place)
            mark = tool_button(str(place + 1), in_line(step.title), act, flat=True, checkable=True)
            mark.setProperty("practice", practises)
            give_role(mark, QAccessible.Role.PageTab)
            self._numbers.append(mark)
            row.insertWidget(place + len(self._heads), mark)
        self._counted.setVisible(len(self._numbers) <= MOST_COUNTED)

    def show_progress(self, player: Player) -> None:
        steps = player.lesson.steps
        self._counted.setText(self.tr("Step {0} of {1}").format(player.place + 1, len(steps)))
        tick, done = "✓", self.tr("done")
        if player.is_test:  # which says later what is right
            tick, done = "•", self.tr("answered")
        for number, (mark, step) in enumerate(zip(self._numbers, steps, strict=False)):
            is_here, is_done = number == player.place, player.is_done(step)
            mark.setChecked(is_here)
            mark.setText(tick if is_done and not is_here else str(number + 1))
            said = self.tr("Step {0}: {1}")
            if player.lesson.practises(step):
                said = self.tr("Step {0}, practice: {1}")
            mark.setAccessibleName(said.format(number + 1, in_line(step.title)))
            mark.setAccessibleDescription(done if is_done else "")
