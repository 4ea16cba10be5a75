"""Jitter: the eye moves 1 mm a frame, far from the origin of the coordinates; a unit is a metre.

With a vertex at p and the eye at e from there, a program subtracts and then projects, in float32::

    world       fl(fl(p) - fl(e))
    relative    fl(fl(p - o) - fl(e - o)): o is the object's place, subtracted in float64
    two         fl(fl(p1 - e1) + fl(p2 - e2)): p = p1 + p2, the nearest float32 and the rest

All else is alike. What the stored numbers lose is known, the roundings after it are bounded, and
`errors_px` says how far that moves a pixel. A jump from one frame to the next is wrong by the sum
of both bounds at most.
"""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from app.model.limits import vector
from app.model.parameter import Settings, number
from app.model.projection import Array, Camera, Projection
from app.precision.cheap import Hardware, cheap
from app.precision.drift import errors_px
from app.scenes.phenomena.cheap_arithmetic import enlargement, times_text
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Dot, Marks, Polyline, Text, named, segment
from app.scenes.phenomena.picture import seen
from app.scenes.phenomena.words import PhenomenonWords, Reading

WORDS = PhenomenonWords("jitter")

FRAMES = int(WORDS.settings["frame"].high)  # how often the eye moves
STEP = 1e-3  # how far it moves each time
_AWAY = np.array((0.6, 0.64, 0.48))  # the direction from the origin to the scene
_UNIT, _LOWEST = 2.0**-24, 2.0**-149  # of float32
_ROOM = 0.35  # of the picture's width, for what is enlarged


class Paths(NamedTuple):
    """Pixels (n, f, 2) of n vertices in f frames, drawn and true, and the drawn ones' bounds."""

    drawn: Array
    true: Array
    bounds: Array


def differences(way: str, points: Array, eyes: Array, place: Array) -> tuple[Array, Array]:
    """Vertices less eyes (..., 3), both from an object's `place`, and the bounds of their errors.

    The place is as far from the origin as coordinates are large.
    """
    far = points + place, eyes + place
    given = (points, far[1] - place) if way == "relative" else far
    high = [each.astype(np.float32) for each in given]
    rest = [each - most for each, most in zip(given, high, strict=True)]
    near = high[0] - high[1]
    lost = _UNIT * np.abs(near.astype(np.float64))
    if way == "two":
        low = [each.astype(np.float32) for each in rest]
        rest = [each - most for each, most in zip(rest, low, strict=True)]
        least = low[0] - low[1]
        near = near + least
        lost += _UNIT * (np.abs(least).astype(np.float64) + np.abs(near))
    lost += sum(map(np.abs, (*rest, *(2.0**-52 * each for each in far)))) + _LOWEST
    return near.astype(np.float64), np.linalg.norm(lost, axis=-1)


def paths_of(projection: Projection, points: Array, way: str, distance: float) -> Paths:
    """What becomes of points (n, 3) while the eye moves to the right.

    The origin is where the eye passes the middle of two float32 along x, half-way: far out it might
    jump in none of the frames.
    """
    camera, place = projection.camera, distance * _AWAY
    steps = STEP * np.arange(FRAMES + 1)[:, None] * camera.frame[0]
    eyes = np.array(camera.eye) + steps
    passed = place[0] + eyes[FRAMES // 2, 0]
    with np.errstate(all="ignore"):
        below = np.float32(passed)
        place[0] += float(below) + float(np.spacing(below)) / 2.0 - passed
        near, lost = differences(way, points[:, None], eyes, place)
        given = np.where(np.isfinite(near), near, 0.0).reshape(-1, 3)
        leaning = lost.reshape(-1) / np.linalg.norm(given, axis=1)
    target = vector(np.subtract(camera.target, camera.eye))
    still = replace(projection, camera=Camera((0.0, 0.0, 0.0), target, camera.up))
    picture = cheap(still, given, Hardware())
    bounds = np.linalg.norm(picture.bounds[:, :2], axis=1)
    bounds += errors_px(still, given, np.zeros((3, 3)), leaning)[1]
    true = still.trace((points[:, None] - eyes).reshape(-1, 3)).image
    drawn, true = (each.reshape(*near.shape[:2], 2) for each in (picture.image, true))
    return Paths(drawn, true, bounds.reshape(near.shape[:2]))


def jump_errors(paths: Paths) -> tuple[Array, Array]:
    """How wrong each jump (n, f - 1) from a frame to the next one is, and the bounds of that."""
    wrong = np.diff(paths.drawn - paths.true, axis=1)
    return np.linalg.norm(wrong, axis=-1), paths.bounds[:, 1:] + paths.bounds[:, :-1]


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    trace, camera = projection.trace(subject.points), projection.camera
    here = np.flatnonzero(seen(trace))
    if not len(here):
        return Illustration((), warning=WORDS.phrase("outside"))
    vertex = subject.points[here[[trace.clip[here, 3].argmin()]]]
    paths = paths_of(projection, vertex, str(settings["way"]), number(settings, "distance"))
    jumps, smooth = np.linalg.norm(np.diff([paths.drawn, paths.true], axis=2), axis=-1)
    wrong, bounds = jump_errors(paths)
    each_px = {"largest": jumps, "smooth": smooth, "wrong": wrong, "predicted": bounds}
    image, times = _image_marks(projection, paths, int(number(settings, "frame")))
    none = WORDS.phrase("no-bound")
    return Illustration(
        (
            *(
                Reading.or_why(WORDS[name], float(px.max()), "px", none)
                for name, px in each_px.items()
            ),
            Reading(WORDS["frozen"], 100.0 * float((jumps == 0.0).mean()), "%"),
            Reading.or_why(WORDS["enlarged"], times, "×", none),
        ),
        world=Marks.of(segment(camera.eye, vertex[0], "accent", 1.0), named("P", vertex[0])),
        image=image,
    )


def _image_marks(projection: Projection, paths: Paths, frame: int) -> tuple[Marks, float | None]:
    """The vertex, and how far it moves across from frame to frame: enlarged, each frame lower."""
    width, height = projection.image_size
    across = np.array([paths.drawn[0, :, 0], paths.true[0, :, 0]])
    low, high = float(across.min()), float(across.max())
    times = enlargement(high - low, _ROOM * width)
    if times is None:
        return Marks(), None
    across, down = 0.95 * width - times * (high - across), np.linspace(0.1, 0.9, FRAMES + 1)
    drawn, true = (np.column_stack([each, height * down]) for each in across)
    return Marks.of(
        Polyline(true, "leader", 2.0),
        Polyline(drawn[: frame + 1], "accent", 1.0),
        *(Dot(place, "accent", 0.6) for place in drawn[: frame + 1]),
        Text("smooth", true[0], "muted", text=WORDS["smooth-path"]),
        Text("drawn", drawn[frame], "accent", text=times_text(times)),
        named("P", paths.true[0, 0]),
    ), times


PHENOMENON = Phenomenon.of(WORDS, show=_show)
