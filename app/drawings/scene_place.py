"""A scene in its present place: its matrices, and the largest error of each precision."""

from itertools import chain, islice
from typing import NamedTuple
from weakref import WeakKeyDictionary

from app.model.projection import Array, Projection
from app.precision.levels import Precision, Prediction, drawing_bounds_px, predict
from app.scenes.scene import Scene


class ScenePlace(NamedTuple):
    """A scene under a projection: its matrices, (4, 4), and float32's bounds.

    The bounds are those of its faces, dots and lines, and of a ground left behind.
    """

    projection: Projection
    clip_from_object: Array
    clip_from_world: Array
    bounds_px: tuple[float, ...]


def place_of(scene: Scene, projection: Projection) -> ScenePlace:
    """Return how a scene stands under a projection, computed once for all panes of a step."""
    kept = _places.get(scene)
    if kept is None or kept.projection != projection:
        parts = scene.parts(projection.placement)
        boxes = [(part.boxes.together, space) for part, space in parts]
        errors = iter(drawing_bounds_px(projection, boxes, scene.origin))
        kinds = chain.from_iterable(part.boxes for part, _ in parts)
        bounds = [max(islice(errors, len(each)), default=0.0) for each in kinds]
        del bounds[3:5]  # the ground has no faces and no dots
        matrices = [projection.clip_from_local(scene.origin, space) for _, space in parts]
        kept = ScenePlace(projection, matrices[0], matrices[-1], tuple(bounds))
        _places[scene] = kept
    return kept


def predictions(projection: Projection, scene: Scene) -> dict[Precision, Prediction] | None:
    """Return bounds of every precision's largest error over the vertices of a scene's objects.

    Those of a ground do not count: they may lie beside the eye, where nobody sees them.
    """
    objects, moved = scene.apart[0], not projection.placement.is_identity
    if not objects.has_vertices:
        return None
    return predict(projection, objects.vertices, scene.origin, "object" if moved else "world")


_places: WeakKeyDictionary[Scene, ScenePlace] = WeakKeyDictionary()
