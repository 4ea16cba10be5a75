"""The perspective lens with an arbitrary window: glFrustum, lecture 002's H before the scale."""

from dataclasses import dataclass
from typing import ClassVar

from app.model.lenses.answers import Window
from app.model.lenses.central import Central
from app.model.lenses.lens import LensTable, Windowed
from app.model.lenses.perspective import pyramid_tables
from app.model.limits import SMALLEST_FIELD, SMALLEST_OPENING, Keep, within
from app.model.tables import rows_of

TABLE, TABLE_AT_INFINITY = pyramid_tables(
    {name: rows_of(f"frustum {name}") for name in ("scale", "shear")},
    rows_of("frustum clip_from_view"),
    rows_of("frustum view_from_clip"),
)


@dataclass(frozen=True)
class Frustum(Central, Windowed):
    """The perspective lens with any window on the near plane (glFrustum); far may be ``inf``."""

    kind: ClassVar[str] = "frustum"
    tables: ClassVar[tuple[LensTable, ...]] = (TABLE, TABLE_AT_INFINITY)

    left: float = -0.7
    right: float = 0.7
    bottom: float = -0.4
    top: float = 0.4

    @property
    def least_window(self) -> float:
        """The least width and height of the window: near divided by them must not overflow."""
        return max(1e-290, SMALLEST_OPENING * self.near)

    def check_window(self, left: float, right: float, bottom: float, top: float) -> None:
        super().check_window(left, right, bottom, top)
        limit = self.near / SMALLEST_FIELD
        for name, side in {"left": left, "right": right, "bottom": bottom, "top": top}.items():
            within(name, side, -limit, limit)

    @classmethod
    def with_window(cls, window: Window, near: float, far: float, keep: Keep) -> "Frustum":
        return cls(*window, near, far, keep)
