"""The three pictures of a scene as VTK actors; no Qt.

`drawing` states what all three can do, `layer` what each is made of; `actors` holds what layers
share, `style` has the colours.
"""

from collections.abc import Mapping

from app.lecture.highlight import ENDS
from app.lecture.letters import Letters, axis_letters, in_letters

_OWN: Mapping[str, str] = {
    **{
        word: word
        for word in (
            *ENDS,
            *("eye", "target", "look", "up", "u", "v", "n", "x", "y", "z", "d"),
            *("half width", "half height"),
        )
    },
    **{f"object_{axis}": axis for axis in "xyz"},
    "no planes": "A typed matrix has no near, no far and no angle.",
    "no angle": "A parallel lens has no angle: it is equally wide at every distance.",
    "no eye": "A parallel lens has no eye: this is the view along its axis.",
    "no half angle": "This window is off-axis: the axis does not halve its angle.",
}


class DrawingWords(dict[str, str]):
    """The words written into the drawings, and a scene's own, in English with a lecture's letters.

    A mapping with the same keys translates them.
    """

    def __init__(self, letters: Letters = "own") -> None:
        super().__init__({**_OWN, **axis_letters(letters)})
        self._letters = letters

    def __missing__(self, word: str) -> str:
        return in_letters(word, self._letters)

    def get(self, word: str, default: object = None) -> str:
        return self[word]


WORDS: Mapping[str, str] = DrawingWords()

AXES = "axes"  # a layer that no document names: the pixel axes, which compared pictures hide
