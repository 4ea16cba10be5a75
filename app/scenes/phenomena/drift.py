"""Drift: a camera turned by products of small turns, which does not come home after 360 degrees.

`app.precision.drift` turns the camera's axes u, v, n and bounds their error E. Eye and lens stay:
a point at q in view space is drawn at ``q + E q``. An E too small to see is enlarged, in the world
and in the image alike.
"""

import math

import numpy as np

from app.model.parameter import Settings, number
from app.model.projection import Array, Projection
from app.precision.drift import AXIS, drifted, errors_px
from app.scenes.phenomena.cheap_arithmetic import enlargement, times_text
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Copy, Mark, Marks, Text, dash_dot, named, segment
from app.scenes.phenomena.picture import seen
from app.scenes.phenomena.words import PhenomenonWords, Reading, figure

WORDS = PhenomenonWords("drift")

_ROOM = 0.15  # of the picture's height, for an error that is enlarged
_LONG = 0.3  # the axes, in distances of the target
_DEPTHS = 0.02  # of the depths what is drawn anew has, before its ghost


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    rounds = int(number(settings, "rounds"))
    off, bound = drifted(str(settings["numbers"]), str(settings["way"]), rounds)
    points = subject.points[seen(projection.trace(subject.points))]
    outside = None if len(points) else WORDS.phrase("outside")
    px, bounds = errors_px(projection, points, off, bound)
    lengths = np.where(np.isfinite(px).all(axis=1), np.linalg.norm(px, axis=1), math.inf)
    measured, predicted = (float(each.max(initial=0.0)) for each in (lengths, bounds))
    times = max(1.0, enlargement(measured, _ROOM * projection.image_size[1]) or 1.0)
    axes = np.eye(3) + off
    aside = np.linalg.norm(np.cross(axes, np.eye(3)), axis=1)
    lean = np.degrees(np.arctan2(aside, np.diagonal(axes)))
    longer = np.abs(np.linalg.norm(axes, axis=1) - 1.0)
    # Axes that are all longer see the same through an eye, but not once they are enlarged.
    longer_all = float(np.trace(off)) / 3.0 if projection.lens.central else 0.0
    enlarged = times * (off - longer_all * np.eye(3)) / (1.0 + longer_all)
    copy = _picture(projection, np.eye(3) + enlarged)
    return Illustration(
        (
            Reading.or_why(WORDS["measured"], measured, "px", WORDS.phrase("behind")),
            Reading.or_why(WORDS["predicted"], predicted, "px", WORDS.phrase("no-bound")),
            Reading(WORDS["direction"], float(lean.max()), "°"),
            Reading(WORDS["lengths"], 100.0 * float(longer.max()), "%"),
            Reading(WORDS["enlarged"], times, "×"),
        ),
        world=_world_marks(projection, np.eye(3) + times * off),
        image=_image_marks(projection, points, lengths, enlarged, times),
        copies=(Copy(copy, ("image",)),) if np.isfinite(copy).all() else (),
        warning=outside,
    )


def _picture(projection: Projection, axes: Array) -> Array:
    """The matrix (4, 4) that moves the world to where these axes see it, before its ghost."""
    turned, forward = np.eye(4), np.eye(4)
    turned[:3, :3] = axes
    forward[2, 2:] = _DEPTHS, (1.0 - _DEPTHS) * projection.depth_range[0]
    with np.errstate(all="ignore"):
        world_from_clip = projection.world_from_clip_at((0.0, 0.0, 0.0))
        clip_from_world = projection.clip_from_view @ turned @ projection.view_from_world
        return np.asarray(world_from_clip @ forward @ clip_from_world)


def _world_marks(projection: Projection, axes: Array) -> Marks:
    """The axis of the turns through the eye, the true frame and the drifted one."""
    camera = projection.camera
    eye, reach = np.array(camera.eye), _LONG * camera.distance
    about = 1.2 * reach * (np.array(AXIS, dtype=np.float64) @ camera.frame)
    marks: list[Mark] = [*dash_dot(eye - about, eye + about, reach / 4.0, "muted", 1.0)]
    marks.append(Text("axis", eye + about, "muted", (), eye, WORDS["axis"]))
    for name, true, way in zip("uvn", camera.frame, axes @ camera.frame, strict=True):
        tip = eye + reach * way
        marks.append(segment(eye, eye + reach * true, "leader", 1.5))
        marks.append(segment(eye, tip, name, 2.5))
        marks.append(named(f"{name}'", tip, name, 1.0, f"{{axis_{name}}}'"))
    return Marks.of(*marks)


def _image_marks(
    projection: Projection, points: Array, lengths: Array, off: Array, times: float
) -> Marks:
    """The largest error, from the true pixel to the drifted one, and how much it is enlarged."""
    if not len(points):
        return Marks()
    worst = points[[int(lengths.argmax())]]
    start = projection.trace(worst).image[0]
    end = start + errors_px(projection, worst, off, 0.0)[0][0]
    if not ((end >= 0.0) & (end <= projection.image_size)).all():
        return Marks()
    enlarged = f" ({times_text(times)})" if times > 1.0 else ""
    text = f"{figure(float(lengths.max()), 2)} px{enlarged}"
    return Marks.of(segment(start, end, "accent", 1.5), Text("drift", end, "accent", text=text))


PHENOMENON = Phenomenon.of(WORDS, show=_show)
