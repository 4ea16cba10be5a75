"""A small picture or chart beside the panes, as plain data."""

from dataclasses import dataclass

import numpy as np

from app.model.projection import Array


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve: points (n, 2) in the diagram's units, NaN where it is broken.

    `keys` are what its points report when they are clicked; empty if they cannot be chosen.
    """

    points: Array
    colour: str = "ink"
    label: str = ""
    width: float = 1.0
    closed: bool = False
    dots: bool = False
    keys: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Spot:
    """A point of a diagram, in its units, with a name.

    - `faded`, `marked`, `broken`, `hollow`: drawn paler, because another one is better; drawn as
      the present choice; drawn as a cross, because something ends here; drawn as a circle, because
      it is only a reference.
    """

    x: float
    y: float
    name: str = ""  # written beside it, where there is room; it is in `tip` too
    key: str = ""  # reported when it is clicked; empty if it cannot be chosen
    tip: str = ""
    colour: str = "ink"
    faded: bool = False
    marked: bool = False
    broken: bool = False
    hollow: bool = False


@dataclass(frozen=True, eq=False)
class Diagram:
    """A small picture or chart beside the panes.

    - `title`, `x_label`, `y_label`: translatable; an empty label for none.
    - `left`, `right`, `bottom`, `top`: its window; if `bottom` is greater than `top`, y runs down,
      as in an image.
    - `equal`: whether both axes have the same scale, as in a picture. A picture without axis labels
      has no numbers either.
    - `x_ticks`, `y_ticks` (n,): where lines are drawn across, such as the codes of a depth buffer.
    - `spots`: drawn over the curves; the first ones get the better places for their names.
    """

    title: str
    curves: tuple[Curve, ...]
    left: float
    right: float
    bottom: float
    top: float
    x_label: str = ""
    y_label: str = ""
    x_log: bool = False
    y_log: bool = False
    equal: bool = False
    x_ticks: Array | None = None
    y_ticks: Array | None = None
    spots: tuple[Spot, ...] = ()


def broken(segments: Array) -> Array:
    """Segments (k, 2, 2) as the points of one curve that is broken after each of them."""
    gaps = np.full((len(segments), 1, 2), np.nan)
    return np.concatenate([segments, gaps], axis=1).reshape(-1, 2)
