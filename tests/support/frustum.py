"""The frustum's corners, which is what the NDC cube's are in the world."""

from dataclasses import replace

import numpy as np

from app.model.projection import Array, Projection

FACE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))


def corners_world(projection: Projection) -> Array:
    """Left-bottom, right-bottom, right-top, left-top of the near, then the far face, (8, 4).

    w is 1, or 0 for what lies at infinity and is a direction. A lens' cube is un-projected from
    the reversed range, where the far face's 1/w is 1/far itself.
    """
    z_near, z_far = projection.depth_range
    if projection.lens.planes is not None:
        projection, z_near, z_far = replace(projection, depth="reversed"), 1.0, 0.0
    cube = np.array([(x, y, z, 1.0) for z in (z_near, z_far) for x, y in FACE])
    corners: Array = cube @ projection.world_from_clip_at(projection.camera.eye).T
    finite = corners[:, 3] != 0.0
    corners[finite] /= corners[finite, 3:]
    corners[finite, :3] += projection.camera.eye
    return corners
