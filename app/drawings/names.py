"""The things that a drawing names: those of its view, and the one pointed at or held."""

from app.lecture.highlight import NOTHING, Highlight
from app.picking.handles import Handle

QUIET = 0.6  # how much of the paper is mixed into the colour of a thing that is not named
QUIET_WIDTH = 0.5  # of the width of its lines


class Names:
    """The ids that a drawing names; ``id in names`` asks for one.

    `wanted` is None for everything. What is `pointed` at or `held` is named in any case.
    """

    def __init__(self, wanted: frozenset[str] | None) -> None:
        self.wanted = wanted
        self.pointed: Highlight = NOTHING
        self.held: Handle | None = None

    def __contains__(self, name: object) -> bool:
        if self.wanted is None or name in self.wanted or name in self.pointed:
            return True
        return self.held is not None and name == self.held.name

    def wants(self, name: str) -> bool:
        """Whether a thing is named without being pointed at or held: the framing depends on it."""
        return self.wanted is None or name in self.wanted
