"""The largest error of each precision for a scene in its present place."""

from itertools import chain, islice
from weakref import WeakKeyDictionary

from app.model.projection import Projection
from app.precision.levels import Precision, Prediction, drawing_bounds_px, predict
from app.scenes.scene import Scene


def bounds_px(projection: Projection, scene: Scene) -> tuple[float, ...]:
    """Return float32's bounds for a scene's faces, dots and lines, and for a ground left behind.

    They are computed once for all panes of a step.
    """
    kept = _bounds.get(scene)
    if kept is None or kept[0] != projection:
        parts = [*scene.parts(projection.placement)]
        boxes = [(part.boxes.together, space) for part, space in parts]
        errors = iter(drawing_bounds_px(projection, boxes, scene.origin))
        kinds = chain.from_iterable(part.boxes for part, _ in parts)
        bounds = [max(islice(errors, len(each)), default=0.0) for each in kinds]
        del bounds[3:5]  # the ground has no faces and no dots
        kept = _bounds[scene] = projection, tuple(bounds)
    return kept[1]


def predictions(projection: Projection, scene: Scene) -> dict[Precision, Prediction] | None:
    """Return bounds of every precision's largest error over the vertices of a scene's objects.

    Those of a ground do not count: they may lie beside the eye, where nobody sees them.
    """
    objects, moved = scene.apart[0], not projection.placement.is_identity
    if not objects.has_vertices:
        return None
    return predict(projection, objects.vertices, scene.origin, "object" if moved else "world")


_bounds: WeakKeyDictionary[Scene, tuple[Projection, tuple[float, ...]]] = WeakKeyDictionary()
