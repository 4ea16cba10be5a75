"""A figure's world in pyvista, in world coordinates; pyvista is no dependency of the program."""

from dataclasses import replace
from typing import Any

import numpy as np

from app.drawings.actors import CUBE_EDGES
from app.drawings.figure import Figure
from app.drawings.style import PALETTES
from app.model.refusal import REFUSALS, Refusal


def plotter_of(figure: Figure, **options: Any) -> Any:
    """Return a `pyvista.Plotter` of objects, frustum and eye; `options` are the plotter's own."""
    try:
        import pyvista as module
    except ImportError:
        raise Refusal.saying(REFUSALS["needs-pyvista"]) from None
    pyvista: Any = module  # its types want other windows
    scene, projection, style = figure.scene, figure.document.projection, PALETTES[figure.palette]
    plotter, origin = pyvista.Plotter(**options), np.array(scene.origin)
    plotter.set_background(style.background)
    for part, space in scene.parts(projection.placement):
        for mesh in (part.surface, part.lines, part.dots):
            if mesh is None:
                continue
            shown: Any = pyvista.PolyData()
            shown.ShallowCopy(mesh)
            points = mesh.points.astype(np.float64) + origin
            is_moved = space == "object"
            shown.points = projection.placement.placed(points).world if is_moved else points
            plotter.add_mesh(shown, scalars="rgb", rgb=True, lighting=mesh is part.surface)

    picture = next(replace(figure, panes=("world",), size=None, text_pt=None).pictures())
    with picture.drawn(lay_out=lambda drawing: drawing.state.canvas.lay_out()) as (window, drawing):
        volume: Any = getattr(drawing.state, "volume")  # noqa: B009
        camera = window.GetRenderers().GetFirstRenderer().GetActiveCamera()
        plotter.camera.DeepCopy(camera)
        plotter.camera.SetPosition(np.add(camera.GetPosition(), origin))
        plotter.camera.SetFocalPoint(np.add(camera.GetFocalPoint(), origin))
    if volume.exists:
        corners = volume.corners + origin
        lines = [part for edge in CUBE_EDGES for part in (len(edge), *edge)]
        plotter.add_mesh(pyvista.PolyData(corners, lines=lines), color=style.frustum)
        for colour, tint, face in zip(
            (style.near, style.far), style.tints, (corners[:4], corners[4:]), strict=True
        ):
            plotter.add_mesh(pyvista.PolyData(face, [4, *range(4)]), color=colour, opacity=tint)
    eye, how = np.array([projection.camera.eye]), {"render_points_as_spheres": True}
    plotter.add_points(eye, color=style.eye, point_size=10, **how)
    return plotter
