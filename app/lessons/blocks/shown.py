"""``state``: what the window shows at the step."""

from __future__ import annotations

from dataclasses import dataclass

from app.lessons.blocks.block import Block, StepContent
from app.lessons.lines import Body
from app.lessons.state import State, read_state


@dataclass(frozen=True, kw_only=True)
class ShownState(Block):
    """The state of a step; a step without one keeps the previous state."""

    kind = "state"
    once = True
    state: State

    def add_to(self, content: StepContent) -> None:
        content.state = self.state

    @classmethod
    def read(cls, body: Body) -> ShownState:
        return cls(line=body.line, state=read_state(body.lines, body.line))
