"""A typed projection matrix, whose cells are its table.

It has no eye plane: near and far are faces of the NDC cube, and w may have any sign. The view
matrix may be typed as well.
"""

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar

from app.model.lenses.lens import Lens, LensTable, Seen
from app.model.lenses.perspective import Perspective
from app.model.limits import SMALLEST_CELL, Cells, finite_matrix, keep_checked
from app.model.tables import matrix

_LETTERS = [[f"p_{i}{j}" for j in range(1, 5)] for i in range(1, 5)]
TABLE = LensTable((), matrix("\n".join(map("  ".join, _LETTERS))))


@dataclass(frozen=True)
class FreeMatrix(Lens):
    """A projection matrix that belongs to no lens.

    - `clip_from_view` (4, 4): for the depth range in use.
    - `view_from_world` (4, 4): replaces the camera's view matrix, if it was edited and no camera
      has it.
    - `former`: the lens before the edit, to which choosing another kind returns.

    Raises a `Refusal` naming the cell, as ``clip_from_view[0, 2]``, that is not finite, beyond
    `LARGEST`, or below `SMALLEST_CELL` in size and not 0.
    """

    kind: ClassVar[str] = "matrix"
    tables: ClassVar[tuple[LensTable, ...]] = (TABLE,)
    # Offset, cell, product and three sums.
    roundings: ClassVar[tuple[float, float, float, float]] = (6.0, 6.0, 6.0, 6.0)

    clip_from_view: Cells
    view_from_world: Cells | None = None
    former: Lens = Perspective()  # noqa: RUF009

    def __post_init__(self) -> None:
        keep_checked(
            self, clip_from_view=finite_matrix("clip_from_view", self.clip_from_view, SMALLEST_CELL)
        )
        if self.view_from_world is not None:
            view_from_world = finite_matrix("view_from_world", self.view_from_world, SMALLEST_CELL)
            keep_checked(self, view_from_world=view_from_world)

    @property
    def own_view(self) -> Cells | None:
        return self.view_from_world

    def exact_letters(self, aspect: Fraction) -> dict[str, Fraction]:
        return {letter: Fraction(cell) for letter, cell in self.letters(aspect).items()}

    def letters(self, aspect: Fraction) -> dict[str, float]:
        return {
            f"p_{i}{j}": cell
            for i, row in enumerate(self.clip_from_view, 1)
            for j, cell in enumerate(row, 1)
        }

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        raise cls._refusal()

    @cached_property
    def planes(self) -> None:
        return None

    def in_depth_range(self, old: tuple[float, float], new: tuple[float, float]) -> "FreeMatrix":
        old_near, old_far = map(Fraction, old)
        new_near, new_far = map(Fraction, new)
        scale = (new_far - new_near) / (old_far - old_near)
        x, y, z, w = (tuple(map(Fraction, row)) for row in self.clip_from_view)
        z = tuple(scale * a + (new_near - scale * old_near) * b for a, b in zip(z, w, strict=True))
        cells: Any = tuple(tuple(map(float, row)) for row in (x, y, z, w))
        return replace(self, clip_from_view=cells)
