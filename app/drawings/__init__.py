"""What the three panes show, as VTK actors; no Qt.

Every drawing is made once per scene, ``Drawing(screen, scene, words, style)``, into a render
window that it does not own, and has

- ``show_layers(hidden)``: switches off what it has of `app.document.view.LAYERS`,
- ``show_projection(projection, illustration=None)``: takes the model over by setting matrices, and
  what a phenomenon shows for it; never renders,
- ``reset_view()``: puts the pane's own camera back,
- ``refit()``: at a gesture's end, fits a view that nobody has moved to what has left it,
- ``reset_clipping_range()``: to be called after that camera was moved from outside,
- ``view`` and ``show_view(view)``: where that camera was moved to, as a `Camera`, and back there,
- ``show_probes(probes)``: marks these points and rays; ``sight``: how the pane looks at the world,
  for picking,
- ``remove()``: takes everything out of the window again.

The world's has besides ``show_fixed(view)`` and ``fixed``, one of `app.document.view.FIXED` or
``""`` for the view that a hand turns freely; and, if it is ``live``, marks to take hold of the
camera by: ``hold(handle)``, ``held``, ``handle_at(pixel, within_px)``; a figure has none.

`actors` holds what they share, `style` their colours and sizes.
"""

from __future__ import annotations

from collections.abc import Mapping

from app.lecture.notation import Letters, axis_letters, in_letters

_OWN: Mapping[str, str] = {
    **{
        word: word
        for word in (
            *("near", "far", "eye", "target", "look", "up", "u", "v", "n", "x", "y", "z", "d"),
            *("held", "now", "other", "half width", "half height"),
        )
    },
    **{f"object_{axis}": axis for axis in "xyz"},
    "no planes": "A typed matrix has no near, no far and no angle.",
    "no angle": "A parallel lens has no angle: it is as wide at every distance.",
    "no eye": "A parallel lens has no eye: this is the view along its axis.",
    "no room": "No room for all dimensions.",
    "no half angle": "This window is off the axis, which does not halve its angle.",
}


class Words(dict[str, str]):
    """The words written into the drawings, and a scene's own, in English with a lecture's letters.

    A mapping with the same keys translates them.
    """

    def __init__(self, letters: Letters = "own") -> None:
        super().__init__({**_OWN, **axis_letters(letters)})
        self._letters = letters

    def __missing__(self, word: str) -> str:
        return in_letters(word, self._letters)

    def get(self, word: str, default: object = None) -> str:
        """The word; a scene's own is one itself."""
        return self[word]


WORDS: Mapping[str, str] = Words()

AXES = "axes"
"""A layer that no document names: the pixel axes, which pictures beside each other do without."""
