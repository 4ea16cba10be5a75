"""Field of view: the lectures' wide angle and telephoto, with sizes at the target kept.

The size of an object in the plane through the target goes with ``1 / (d tan(fov/2))``, its
foreshortening with the distance d alone. A ride along n that keeps d tan(fov/2) (a dolly zoom)
shows that perspective depends on where one stands. Parts nearer than the target are drawn larger,
parts farther away smaller. Fields of view and the two photographs, 29 mm at 30 cm and 105 mm at
360 cm, are lecture 001's; one unit of this scene is 10 cm.
"""

import math
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from app.model.lenses.perspective import fov_x_from_fov_y, fov_y_from_focal_length_35mm
from app.model.limits import vector
from app.model.parameter import CLOSE, ImpliedSettings, Settings, number
from app.model.projection import Array, Camera, Orbit, Perspective, Projection, Vector
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Grip, Marks, Polyline, Text
from app.scenes.phenomena.picture import cut_in_picture, seen_lines, seen_texts
from app.scenes.phenomena.words import PhenomenonWords, Phrase, Reading
from app.scenes.shapes import Coloured, box_faces, edges_of, flat, ground_grid, joined

WORDS = PhenomenonWords("field-of-view")

_WIDE_MM, _TELE_MM = 29.0, 105.0
_WIDE_DISTANCE, _TELE_DISTANCE = 3.0, 36.0
# Horizontal fields of view in lecture 001: without peripheral vision, at a comfortable distance (25
# to 30 degrees), "only a few degrees".
_SEEN_DEG = {"eye": 120.0, "monitor": 30.0, "phone": 5.0}


def _geometry() -> tuple[Coloured, Coloured]:
    """A head of boxes that looks along +z, with nose, brow and ears at different depths."""
    skin, dark, light = (225, 180, 140), (120, 84, 60), (245, 242, 230)
    parts = [
        ((-0.5, 0.9, -0.5), (0.5, 2.0, 0.4), skin),
        ((-0.14, 1.2, 0.4), (0.14, 1.5, 0.8), (213, 94, 0)),
        ((-0.52, 1.78, -0.52), (0.52, 2.1, 0.48), dark),
        ((-0.36, 1.5, 0.4), (-0.16, 1.66, 0.44), light),
        ((0.16, 1.5, 0.4), (0.36, 1.66, 0.44), light),
        ((-0.26, 1.0, 0.4), (0.26, 1.08, 0.44), dark),
        ((-0.66, 1.2, -0.3), (-0.5, 1.6, 0.0), (0, 158, 115)),
        ((0.5, 1.2, -0.3), (0.66, 1.6, 0.0), (0, 114, 178)),
        ((-0.9, 0.0, -0.7), (0.9, 0.75, 0.2), (86, 180, 233)),
        ((-0.25, 0.75, -0.4), (0.25, 0.9, 0.1), skin),
    ]
    shades = (0.92, 0.84, 1.0, 0.6, 0.97, 0.7)  # so that the sides of a box differ
    quads, rgb = [], []
    for lower, upper, colour in parts:
        quads.append(0.8 * box_faces(lower, upper))
        rgb += [flat([round(part * shade) for part in colour], 1) for shade in shades]
    faces = np.concatenate(quads)
    lines = joined(ground_grid((-6.0, -12.0), (6.0, 2.0), (1.0, 1.0), 0.0), edges_of(faces))
    return (faces, np.concatenate(rgb)), lines


class DollyView(NamedTuple):
    """Distance from the subject in world units, and vertical field of view in degrees."""

    distance: float
    fov_y_deg: float


def preset_view(name: str, aspect: float, enlarged: bool = True) -> DollyView:
    """The view of a preset: "wide", "tele", "eye", "monitor" or "phone".

    `aspect` is the image's width over its height. The focal lengths are those of the full-frame
    camera with the same diagonal field of view, the others are horizontal fields of view. Things at
    the target's distance are always as large as on the 29-mm photograph at 30 cm, for the 105-mm
    one only if it is `enlarged`, which narrows its field of view.
    """
    wide_deg = fov_y_from_focal_length_35mm(_WIDE_MM, aspect)
    half_height = _WIDE_DISTANCE / Perspective(wide_deg).cot_half_fov_y  # at the subject
    if name == "wide":
        return DollyView(_WIDE_DISTANCE, wide_deg)
    if name == "tele":
        fov_y_deg = fov_y_from_focal_length_35mm(_TELE_MM, aspect)
        if enlarged:
            fov_y_deg = math.degrees(2.0 * math.atan2(half_height, _TELE_DISTANCE))
        return DollyView(_TELE_DISTANCE, fov_y_deg)
    fov_y_deg = fov_x_from_fov_y(_SEEN_DEG[name], 1.0 / aspect)
    return DollyView(half_height * Perspective(fov_y_deg).cot_half_fov_y, fov_y_deg)


def dollied(projection: Projection, factor: float) -> Projection:
    """Ride along n to `factor` times the distance, while the target's plane keeps its size.

    Raises a `Refusal` if the lens or the camera cannot follow.
    """
    camera, lens = projection.camera, projection.lens
    moved = replace(projection, camera=_at(camera, factor * camera.distance))
    return replace(moved, lens=lens.dollied(projection.window, factor))


def _at(camera: Camera, distance: float) -> Camera:
    """The camera at another distance from its target, on the same line."""
    return replace(camera, eye=vector(camera.target + distance * camera.frame[2]))


def _from_preset(projection: Projection, settings: Settings, factor: float) -> Projection:
    view = preset_view(str(settings["preset"]), projection.aspect, bool(settings["enlarged"]))
    lens = projection.with_lens("perspective").lens
    at = Projection(
        _at(projection.camera, view.distance),
        Perspective(view.fov_y_deg, lens.near, lens.far),
        projection.image_size,
        projection.depth,
    )
    return dollied(at, factor) if factor != 1.0 else at


def _follow(projection: Projection, before: ImpliedSettings, after: Settings) -> Projection:
    if before["preset"] is None:
        return _from_preset(projection, after, 1.0)
    factor = number(after, "distance")
    enlarged = after["preset"] == "tele" and before["enlarged"] != after["enlarged"]
    if enlarged or before["preset"] != after["preset"]:
        return _from_preset(projection, after, factor)
    if before["distance"] != after["distance"]:
        return dollied(projection, factor / number(before, "distance"))
    return projection


def _implied(projection: Projection, settings: Settings) -> ImpliedSettings:
    name, camera, lens = str(settings["preset"]), projection.camera, projection.lens
    view = preset_view(name, projection.aspect, bool(settings["enlarged"]))
    held = view.distance / Perspective(view.fov_y_deg).cot_half_fov_y  # half the plane's height
    x, y = projection.aspect * held, held
    seen = lens.window_at(projection.window, camera.distance)
    holds = lens.central and math.dist(seen, (-x, x, -y, y)) <= CLOSE * x
    return {"preset": name if holds else None, "distance": camera.distance / view.distance}


def _angles(projection: Projection, settings: Settings) -> tuple[Reading, ...]:
    angles = projection.lens.angles(Fraction(*projection.image_size))
    values: tuple[float | None, ...] = (None, None, None)
    if angles is not None:
        values = angles.fov_y_deg, angles.fov_x_deg, angles.focal_mm
    note = WORDS.of_parallel(projection)
    preset, away = _implied(projection, settings).values()
    is_preset = preset == "tele" and isinstance(away, float) and abs(away - 1.0) < CLOSE
    if values[2] is not None and is_preset and settings["enlarged"]:
        note = WORDS.phrase("enlarged", values[2] / _TELE_MM)
    lines = zip(("vertical", "horizontal", "focal"), values, ("°", "°", "mm"), strict=True)
    return tuple(Reading(WORDS[key], value, unit, note) for key, value, unit in lines)


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    camera = projection.camera
    distance = camera.distance
    height = subject.upper[1] - subject.lower[1]
    width = math.hypot(subject.upper[0] - subject.lower[0], subject.upper[2] - subject.lower[2])
    w = (np.array(camera.eye) - subject.points) @ camera.frame[2]
    w_near, w_far = float(w.min()), float(w.max())
    smaller, larger = map(projection.lens.w, (w_near, w_far))
    in_front = smaller > 0.0 and math.isfinite(larger / smaller)
    ratio = larger / smaller if in_front else None

    # The subject's height, upright in the plane through the target: a measure beside the subject,
    # with a tick at either end. The ride keeps its size.
    x, y, tick = -0.55 * width, height / 2.0, 0.06 * width
    bar = _beside_target(camera, [(x, -y, 0.0), (x, y, 0.0)])
    ends = [(x + side, end, 0.0) for end in (-y, y) for side in (-tick, tick)]
    ticks = _beside_target(camera, ends)
    size, why = _size_px(projection, bar, subject)
    lines: list[Polyline] = []
    texts: list[Text] = []
    if size is not None:
        lines += [Polyline(each, "accent", 1.5) for each in (bar, ticks[:2], ticks[2:])]
        texts.append(Text("px", bar[1], "accent", text=f"{size:.0f} px"))
    at_squares = []
    if ratio is not None:
        # Two squares of one size at the subject's nearest and farthest depth.
        # From afar they are nearly one: the names stand at different corners.
        squares = (w_near, "nearest", "near", 2), (w_far, "farthest", "far", 1)
        for depth, name, colour, corner in squares:
            square = _square(camera, 0.45 * height, depth)
            lines.append(Polyline(square, colour, 1.5, (), name))
            at_squares.append(Text(name, square[corner], colour, text=WORDS[name]))
    texts += at_squares
    d = np.array([camera.eye, camera.target])
    # The grip is in the middle of d: at its end is the eye's.
    middle, factor = d.mean(axis=0), number(_implied(projection, settings), "distance")
    along = (middle - camera.target) / factor
    segments = np.array([ends for line in lines for ends in pairwise(line.points)])
    colours = [line.colour for line in lines for _ in line.points[1:]]
    places = [text.point for text in texts]
    trace = projection.trace(np.array([*segments.reshape(-1, 3), *places]).reshape(-1, 3))
    clip = trace.clip[: 2 * len(segments)].reshape(-1, 2, 4)
    return Illustration(
        (
            Reading(WORDS["distance"], distance),
            Reading(WORDS["height"], size, "px", why),
            Reading.or_why(WORDS["foreshortening"], ratio, "×", WORDS.phrase("behind-eye")),
            *_angles(projection, settings),
        ),
        world=Marks.of(
            Polyline(d, "accent", name="d"),
            *lines,
            Text("d", middle, "accent", text=f"d = {distance:.4g}"),
            *at_squares,
        ),
        image=Marks.of(*seen_lines(projection, clip, colours, 1.5), *seen_texts(trace, texts)),
        grips=(Grip("distance", middle, camera.target, vector(along), "d", face=d),),
    )


def _size_px(
    projection: Projection, bar: Array, subject: Subject
) -> tuple[float | None, Phrase | None]:
    """How high an upright bar (2, 3) is drawn, or why it cannot be measured."""
    subject_trace, trace = projection.trace(subject.points), projection.trace(bar)
    # If all vertices are beyond one and the same plane, so is the whole subject.
    if subject_trace.outside.all(axis=0).any():
        return None, WORDS.phrase("not-seen")
    size_px = float(trace.image[0, 1] - trace.image[1, 1])
    if not size_px > 0.0:  # NaN, too
        return None, WORDS.phrase("too-large")
    if cut_in_picture(projection, trace.clip[:1], trace.clip[1:])[0] is None:
        return None, WORDS.phrase("bar-not-seen")
    return size_px, None


def _square(camera: Camera, side: float, depth: float) -> Array:
    """A closed square across the axis at a depth, (5, 3)."""
    half, z = side / 2.0, camera.distance - depth
    corners = [(-half, -half), (half, -half), (half, half), (-half, half), (-half, -half)]
    return _beside_target(camera, [(x, y, z) for x, y in corners])


def _beside_target(camera: Camera, offsets_uvn: list[Vector]) -> Array:
    """World points at offsets along u, v, n from the target; a far eye costs no digits."""
    return np.asarray(np.array(camera.target) + np.array(offsets_uvn) @ camera.frame)


_WIDE = preset_view("wide", 1280 / 720)

PHENOMENON = Phenomenon.of(
    WORDS,
    start=Projection(
        Camera.from_orbit((0.0, 0.95, 0.0), Orbit(20.0, 8.0, _WIDE.distance)),
        Perspective(_WIDE.fov_y_deg, 0.1, 200.0),
    ),
    geometry=_geometry,
    show=_show,
    follow=_follow,
    implied=_implied,
)
