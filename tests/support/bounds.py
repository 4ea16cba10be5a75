"""What float32 can lose of all of a scene at once."""

from app.model.projection import Array, Projection, Space, Vector
from app.precision.levels import drawing_bounds_px


def drawing_bound_px(
    projection: Projection, boxes: Array, origin: Vector = (0.0, 0.0, 0.0), space: Space = "world"
) -> float:
    """The largest of `drawing_bounds_px`, of boxes (n, 8, 3) or of one, (8, 3)."""
    return max(
        drawing_bounds_px(projection, [(boxes.reshape(-1, 8, 3), space)], origin), default=0.0
    )
