"""``predict``: a choice that must be made before the step continues."""

from dataclasses import dataclass

from app.lessons.blocks.choices import Choices
from app.lessons.blocks.question import CHECKS
from app.lessons.lines import Body
from app.lessons.state import state_in


@dataclass(frozen=True, kw_only=True)
class Predict(Choices):
    """A prediction: it is made once, and then the model shows the right answer."""

    kind = "predict"
    holds = True
    retries = False

    @classmethod
    def read(cls, body: Body) -> Choices:
        text, items = body.items("show", *CHECKS, choices=True)
        return cls.of(body, text, items, show=state_in(items.single("show")))
