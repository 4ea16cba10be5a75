"""How exactly and how finely a document's panes are drawn, where somebody chose it.

Everything is automatic at first: the cheapest arithmetic that is exact enough, edges smoothed
while the hand rests, all triangles, and the depth buffer that the graphics card has. A choice,
mostly of a point in a chart of `app.measure`, is part of the document: it can be undone and saved.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from app.model.depth import FORMATS, MAPPINGS, DepthBuffer
from app.model.limits import finite, keep_checked, within
from app.model.projection import ONE_OF, Projection
from app.model.refusal import Refusal

AUTO = "auto"
PRECISIONS = (AUTO, "float32", "float64")
SMOOTHINGS = (
    AUTO, "none", "half resolution", "FXAA", "MSAA 2", "MSAA 4", "MSAA 8",
    "supersampling 2 x 2", "supersampling 3 x 3",
)  # fmt: skip
LEAST_DETAIL = 0.01
"""Share of the triangles that is kept at the least."""
_CHOICES = {
    "rung": PRECISIONS,
    "smoothing": SMOOTHINGS,
    "depth_format": ("", *FORMATS),
    "depth_mapping": ("", *MAPPINGS),
}


@dataclass(frozen=True)
class Quality:
    """What was chosen; what was not is automatic.

    Parameters
    ----------
    rung : one of `PRECISIONS`
        The arithmetic that the image and the NDC cube are drawn with.
    smoothing : one of `SMOOTHINGS`
        Of the panes; figures are always averaged.
    detail : float
        Share of the scene's triangles that is drawn, from `LEAST_DETAIL` to 1.
    depth_format : name in `app.model.depth.FORMATS`, or empty
        Of the image's depth buffer; empty for the graphics card's own, or ``"fixed24"`` if
        there is a mapping.
    depth_mapping : name in `app.model.depth.MAPPINGS`, or empty
        Empty for the projection's own depth range.

    Raises
    ------
    Refusal
        For a name that is not known, or a share that cannot be drawn.
    """

    rung: str = AUTO
    smoothing: str = AUTO
    detail: float = 1.0
    depth_format: str = ""
    depth_mapping: str = ""

    def __post_init__(self) -> None:
        for field, known in _CHOICES.items():
            value = getattr(self, field)
            if not isinstance(value, str) or value not in known:
                names = ", ".join(name or "''" for name in known)
                raise Refusal(f"quality.{field}", value, ONE_OF, names)
        detail = finite("quality.detail", self.detail)
        keep_checked(self, detail=within("quality.detail", detail, LEAST_DETAIL, 1))

    @property
    def chosen(self) -> dict[str, str | float]:
        """What is not automatic, by its name in the document."""
        values = {f.name: (getattr(self, f.name), f.default) for f in fields(self)}
        return {name: value for name, (value, default) in values.items() if value != default}

    def tolerance_px(self, tolerance_px: float) -> float:
        """The error up to which float32 may draw: any, none, or the one that is given."""
        return {"float32": math.inf, "float64": 0.0}.get(self.rung, tolerance_px)

    @property
    def has_depth(self) -> bool:
        """Whether a depth buffer was chosen."""
        return bool(self.depth_format or self.depth_mapping)

    def depth_buffer(self, projection: Projection) -> DepthBuffer:
        """The depth buffer that was chosen, in front of a projection's lens.

        Raises
        ------
        Refusal
            If the lens cannot have it.
        """
        mapping = self.depth_mapping or projection.depth
        try:
            return DepthBuffer(self.depth_format or "fixed24", mapping, projection.lens)
        except Refusal as error:
            paths = {"mapping": "quality.depth_mapping", "kind": "lens.kind"}
            path = paths.get(error.field, error.field)
            raise Refusal(path, error.value, error.bound, *error.limits) from error


AUTOMATIC = Quality()
