"""The three pictures of a scene as VTK actors; no Qt.

`drawing` states what all three can do, `layer` what each is made of; `actors` holds what layers
share, `style` has the colours.
"""

from collections.abc import Mapping
from pathlib import Path

from app.languages import translate
from app.lecture.highlight import ENDS
from app.lecture.letters import Letters, axis_letters, in_letters
from app.model.parameter import read_sections
from app.model.parameters import TITLES

SENTENCES = read_sections(Path(__file__).with_name("content") / "words.md")["Words"].named
_OWN: Mapping[str, str] = {
    **{word: word for word in "uvnxyzd"},
    **{f"object_{axis}": axis for axis in "xyz"},
}


class DrawingWords(dict[str, str]):
    """The words written into the drawings, and a scene's own, with a lecture's letters."""

    def __init__(self, letters: Letters = "own") -> None:
        own = {
            **{key: translate(text, "Look") for key, text in SENTENCES.items()},
            **{title: translate(title, "Field") for title in TITLES.values()},
            **{plane: translate(plane, "Plane") for plane in ENDS},
        }
        super().__init__({**_OWN, **own, **axis_letters(letters)})
        self._letters = letters

    def __missing__(self, word: str) -> str:
        return in_letters(translate(word, "phenomena"), self._letters)

    def get(self, word: str, default: object = None) -> str:
        return self[word]


WORDS: Mapping[str, str] = DrawingWords()

AXES = "axes"  # a layer that no document names: the pixel axes, which compared pictures hide
