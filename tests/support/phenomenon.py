"""A phenomenon with a setting of every kind, for tests of what shows any of them."""

import sys
from dataclasses import replace

import numpy as np
import pytest

from app.model.parameter import Settings, number, point
from app.model.projection import Camera, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Dot, Marks, Text
from app.scenes.phenomena.similar_triangles import PHENOMENON as SIMILAR_TRIANGLES
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Phrase, Reading

BELOW_COUNT = "must be less than the count, which is {0}"


def _show(projection: Projection, settings: Settings, _subject: Subject) -> Illustration:
    gap, light = number(settings, "gap"), np.array(point(settings, "light"))
    why = Phrase("the light is behind the eye at {0}", ("z = 3",))
    behind = projection.trace(light).view[2] >= 0.0
    across = np.linspace(0.0, 1.0, 5)
    return Illustration(
        (
            Reading("gap", gap, "mm"),
            Reading("kind", str(settings["kind"])),
            Reading("x_s", None if behind else float(light[0]), "×", why if behind else None),
            Reading("y_s", None if behind else float(light[1]), "×", why if behind else None),
            Reading("S", tuple(gap * i for i in range(16))),
        ),
        world=Marks(dots=(Dot(light),), texts=(Text("light", light),)),
        diagrams=(
            Diagram("Line", (Curve(np.stack([across, across], 1), "near", "y"),), 0, 1, 0, 1),
        ),
        warning=Phrase("nothing of {0} is seen", ("it",)) if gap > 100.0 else None,
    )


def _follow(projection: Projection, _before: Settings, after: Settings) -> Projection:
    """Put the eye as high as the light is."""
    x, _, z = projection.camera.eye
    camera = projection.camera
    eye = (x, point(after, "light")[1], z)
    return replace(projection, camera=Camera(eye, camera.target, camera.up))


def _check(settings: Settings) -> None:
    count = number(settings, "count")
    if number(settings, "gap") / 10.0 >= count:
        raise Refusal("settings.gap", settings["gap"], BELOW_COUNT, count)


TEXT = """\
# A setting of every kind
What this is about. It has two sentences.

## Try

## Settings
- gap: 2 low=1e-3 high=1e3 unit=mm logarithmic
- turn: 0 low=-180 high=180 unit=° per_second=90
- count: 40 low=1 high=64 whole per_second=4
- kind: a
- correct: yes
- light: 1,3.6,3

## Gap {#gap}
Between the two

## Turn {#turn}
How far

## Count {#count}
How many

## Kind {#kind}
Which
- a: alpha
- b: beta

## Correct {#correct}
Whether

## Light {#light}
Where it is
"""

EVERYTHING = Phenomenon(
    PhenomenonWords("everything", TEXT),
    ("001", "002"),
    SIMILAR_TRIANGLES.start,
    SIMILAR_TRIANGLES.geometry,
    _show,
    controls=("lens.near", "camera.distance"),
    follow=_follow,
    check=_check,
    own_mesh=True,
)


def called(name: str) -> Phenomenon:
    """`EVERYTHING` under another name."""
    return replace(EVERYTHING, words=PhenomenonWords(name, TEXT))


def make_known(monkeypatch: pytest.MonkeyPatch, *phenomena: Phenomenon) -> None:
    """Let every module that has been imported know some phenomena more."""
    known = {**PHENOMENA, **{each.name: each for each in phenomena}}
    for name, module in list(sys.modules.items()):
        if name.startswith("app.") and getattr(module, "PHENOMENA", None) is PHENOMENA:
            monkeypatch.setattr(module, "PHENOMENA", known)
