"""The drawing quality that the user chose for a document.

By default everything is automatic: the cheapest arithmetic that is exact enough, smooth edges at
rest, all triangles, and the depth buffer of the graphics card. A choice, usually a point in a chart
of `app.measure`, is part of the document: it can be undone and saved.
"""

import math
from dataclasses import dataclass, fields

from app.model.depth import FORMATS, MAPPINGS, DepthBuffer
from app.model.limits import finite, keep_checked, within
from app.model.projection import Projection
from app.model.refusal import REFUSALS, Refusal

AUTO = "auto"
PRECISIONS = (AUTO, "float32", "float64")
SMOOTHINGS = (
    AUTO, "none", "half resolution", "FXAA", "MSAA 2", "MSAA 4", "MSAA 8",
    "supersampling 2 x 2", "supersampling 3 x 3",
)  # fmt: skip
LEAST_DETAIL = 0.01  # least share of the triangles
_CHOICES = {
    "rung": PRECISIONS,
    "smoothing": SMOOTHINGS,
    "depth_format": ("", *FORMATS),
    "depth_mapping": ("", *MAPPINGS),
}


@dataclass(frozen=True)
class Quality:
    """The chosen quality; default values mean automatic.

    - `depth_format`: in `app.model.depth.FORMATS`; empty for the graphics card's own, or for
      ``"fixed24"`` if there is a mapping.
    - `depth_mapping`: in `app.model.depth.MAPPINGS`; empty for the projection's own depth range.

    Raises a `Refusal` for an unknown name, or a share that cannot be drawn.
    """

    rung: str = AUTO  # one of `PRECISIONS`, the arithmetic of the image and the NDC cube
    smoothing: str = AUTO  # one of `SMOOTHINGS`; only for panes; figures are always averaged
    detail: float = 1.0  # drawn share of the scene's triangles and dots, from `LEAST_DETAIL` to 1
    depth_format: str = ""
    depth_mapping: str = ""

    def __post_init__(self) -> None:
        for field, known in _CHOICES.items():
            value = getattr(self, field)
            if not isinstance(value, str) or value not in known:
                names = ", ".join(name or "''" for name in known)
                raise Refusal(f"quality.{field}", value, REFUSALS["one-of"], names)
        detail = finite("quality.detail", self.detail)
        keep_checked(self, detail=within("quality.detail", detail, LEAST_DETAIL, 1))

    @property
    def chosen(self) -> dict[str, str | float]:
        """The fields that are not automatic, by their names in the document."""
        values = {f.name: (getattr(self, f.name), f.default) for f in fields(self)}
        return {name: value for name, (value, default) in values.items() if value != default}

    def tolerance_px(self, tolerance_px: float) -> float:
        """Return the error up to which float32 draws: infinite, 0, or the given one."""
        return {"float32": math.inf, "float64": 0.0}.get(self.rung, tolerance_px)

    @property
    def has_depth(self) -> bool:
        """Whether a depth buffer was chosen."""
        return bool(self.depth_format or self.depth_mapping)

    def depth_buffer(self, projection: Projection) -> DepthBuffer:
        """Return the chosen depth buffer; raise a `Refusal` if the lens cannot have it."""
        mapping = self.depth_mapping or projection.depth
        try:
            return DepthBuffer(self.depth_format or "fixed24", mapping, projection.lens)
        except Refusal as error:
            paths = {"mapping": "quality.depth_mapping", "kind": "lens.kind"}
            path = paths.get(error.field, error.field)
            raise Refusal(path, error.value, error.bound, *error.limits) from error


AUTOMATIC = Quality()
