"""The letter F from a camera of the tests' own, whatever the scene opens with."""

from dataclasses import replace

from app.model.projection import Camera, Perspective, Projection
from app.scenes.scene import Scene, load

AFAR = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0)), Perspective(45.0, 4.0, 18.0))


def letter_f() -> Scene:
    return replace(load("letter-f"), start=AFAR)
