"""The projection: formulas, lenses, camera, limits, points, clipping, depth. numpy only."""
