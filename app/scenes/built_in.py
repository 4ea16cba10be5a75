"""The built-in scenes that are not phenomena: geometry, first camera, and what to try.

The letter F of eight cubes standing on a grid in the xz plane is the scene of lecture 004 (Horvat).
The cube and the receding row of posts prepare and follow it.
"""

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from app.model.parameters import EYE, FAR, NEAR
from app.model.projection import Camera, Perspective, Projection
from app.scenes import shapes
from app.scenes.mesh import PAINT_RGB
from app.scenes.phenomena.illustration import Shot
from app.scenes.phenomena.words import PhenomenonWords

Parts: TypeAlias = tuple[shapes.Coloured, shapes.Coloured, Projection]
"""Faces, lines, and the projection with which the scene opens."""
NAMES = (EYE.name, NEAR.name, FAR.name, "x", "y", "z")
"""The things named in the pictures of these scenes and of the user's meshes."""
SHOWN: dict[str, dict[str, Any]] = {  # how the panes show a scene that differs from the letter F
    "cube": {"shot": Shot(-80.0, 25.0, "camera")},
    # The numbers are on the fronts; in the cube the posts crowd along its depth.
    "posts": {
        "shot": Shot(-38.0, 28.0, "camera"),
        "upright": Shot(-20.0, 35.0, "camera"),
        "cube_side": (75.0, 10.0),
    },
}
WORDS_OF_A_MESH = PhenomenonWords("own-mesh")


def _letter_f() -> Parts:
    """Eight unit cubes on the ground, the letter's three columns centred about x = 0."""
    return (*shapes.letter_f_on_grid((-8.0, -8.0), (8.0, 8.0)), shapes.LETTER_F)


def _cube() -> Parts:
    """A unit cube standing on the ground, with the world's axes coming out of it."""
    faces = shapes.box_faces((-0.5, 0.0, -0.5), (0.5, 1.0, 0.5))
    axes = np.array([[(0.0, 0.0, 0.0), end] for end in np.diag([0.9, 1.3, 0.9]).tolist()])
    return (
        (faces, shapes.SIDE_RGB.copy()),
        shapes.joined(
            shapes.ground_grid((-3.0, -3.0), (3.0, 3.0), (0.5, 0.5), 0.0),
            shapes.edges_of(faces),
            (axes, shapes.SIDE_RGB[[1, 3, 5]]),  # the darker shades, visible on a light background
        ),
        Projection(Camera((1.5, 1.4, 2.0), (0.0, 0.5, 0.0)), Perspective(38.0, 1.5, 3.5)),
    )


_POSTS = 6
_POST_SPACING = 6.0


def _posts() -> Parts:
    """Posts of equal height and spacing, numbered with geometry that every pane projects."""
    lit = shapes.brightness(np.repeat(np.eye(3), 2, axis=0) * np.tile([[1.0], [-1.0]], (3, 1)))
    wood = (lit[:, None] * PAINT_RGB).astype(np.uint8)
    plate_rgb = (np.clip(lit + 0.25, 0.0, 1.0)[:, None] * shapes.PLATE_RGB).astype(np.uint8)
    plate_rgb[4] = shapes.PLATE_RGB  # the written side
    quads: list[shapes.Coloured] = []
    lines: list[shapes.Coloured] = []
    for number in range(1, _POSTS + 1):
        z = -_POST_SPACING * (number - 1)
        post = shapes.box_faces((-0.1, 0.0, z - 0.24), (0.1, 2.4, z - 0.04))
        plate = shapes.box_faces((-0.8, 1.5, z - 0.04), (0.8, 2.6, z + 0.04))
        digits = shapes.written_number(number, (0.0, 2.05, z + 0.06), height=0.8)
        quads += [
            (post, wood),
            (plate, plate_rgb),
            (digits, shapes.flat(shapes.EDGE_RGB, len(digits))),
        ]
        outline = shapes.edges_of(plate)[0]  # grey: far away little but the outline is visible
        lines.append((outline, shapes.flat(shapes.OUTLINE_RGB, len(outline))))
    return (
        shapes.joined(*quads),
        shapes.joined(shapes.ground_grid((-6.0, -36.0), (6.0, 12.0), (2.0, 6.0), 0.0), *lines),
        Projection(Camera((3.0, 2.6, 10.0), (0.2, 1.2, -10.0)), Perspective(26.0, 9.0, 41.0)),
    )


BUILDERS: dict[str, Callable[[], Parts]] = {"letter-f": _letter_f, "cube": _cube, "posts": _posts}
WORDS = {name: PhenomenonWords(name) for name in BUILDERS}
"""The title of each scene, and what to try there."""
