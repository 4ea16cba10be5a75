"""Off-axis window: the frustum of an eye that is not in front of the middle of its window.

The window stays in the plane through the target while the eye moves sideways, so that left and
right of the near plane's window become unequal (lectures 000, 002, 003: glFrustum). A wall of two
screens is two such frusta with one eye: the right side of one is the left side of the other. At
first the window is 8 by 4.5 in the plane z = 0, 8 units away; its middle is 1.5 to the left.
"""

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np

from app.model.limits import vector
from app.model.parameter import ImpliedSettings, Settings, number
from app.model.parameters import BOTTOM, LEFT, NEAR, RIGHT, TOP
from app.model.projection import Array, Camera, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Aperture, Grip, Mark, Marks, Polyline, Text, plate, segment
from app.scenes.phenomena.picture import section
from app.scenes.phenomena.words import PhenomenonWords, Phrase, Reading
from app.scenes.shapes import SIDE_RGB, Coloured, box_faces, edges_of, ground_grid, joined, letter_f

WORDS = PhenomenonWords("off-axis-window")

_NAMES, _COLOURS = ("left", "right"), ("u", "n")
_INSET = 0.007  # of the shorter side: half of a frame's line
_SAMPLE = 100  # about so many vertices are compared at every step


def _geometry() -> tuple[Coloured, Coloured]:
    letter, rgb = letter_f()
    boxes = (
        ((-3.2, 0.6, 1.0), (3.0, 1.0, 1.4)),  # two beams across the join, one before the window
        ((-4.5, 3.6, -5.0), (4.5, 4.2, -4.4)),
        ((1.2, 0.0, -2.5), (2.4, 2.6, -1.3)),
        ((-0.5, 0.0, -4.0), (0.6, 1.6, -2.9)),
    )
    faces = np.concatenate([letter * 0.8 + (-2.4, 0.0, -1.5), *(box_faces(*box) for box in boxes)])
    colours = np.concatenate([rgb, *([SIDE_RGB] * len(boxes))])
    lines = joined(ground_grid((-6.0, -8.0), (6.0, 4.0), (1.0, 1.0), 0.0), edges_of(faces))
    return (faces, colours), lines


def halves(projection: Projection) -> tuple[Projection, Projection]:
    """The left and the right screen of the wall that the whole window is.

    The join is at a column of pixels: in the middle or, if the width is odd, half a pixel beside
    it. Raises a `Refusal` for a window or an image that is too narrow to be split.
    """
    width, height = projection.image_size
    windowed = projection if projection.lens.window_stays else projection.with_lens("frustum")
    left, right, bottom, top = projection.window
    columns = width // 2
    middle = left + (right - left) * (columns / width)
    screens = []
    for low, high, across in ((left, middle, columns), (middle, right, width - columns)):
        half = windowed.lens.replaced(left=low, right=high, bottom=bottom, top=top, keep="stretch")
        screens.append(replace(projection, lens=half, image_size=(across, height)))
    return screens[0], screens[1]


def join_error_px(screens: tuple[Projection, Projection]) -> float:
    """How far apart the two screens show points of the plane in which they join, in pixels.

    A point of the left screen's right edge goes through the left lens' own numbers and through the
    right one's, in rationals: with glFrustum
    ``x_clip/w = 2n/(r - l) x/w - (r + l)/(r - l)``. It belongs at the end of the last column on the
    left, and at the beginning of the first one on the right. The result is 0 if the halves join.
    """
    edge, near = Fraction(screens[0].window[1]), Fraction(screens[0].lens.near)
    seen = []
    for screen in screens:
        _, _, _, x_clip, _, _, w, *_ = screen.passage.clipped(edge, Fraction(0), -near)
        seen.append((x_clip / w + 1) * screen.image_size[0] / 2)
    return float(abs(seen[0] - screens[0].image_size[0] - seen[1]))


def largest_difference_px(
    projection: Projection, screens: tuple[Projection, Projection], points_world: Array
) -> float | None:
    """How far the wall shows points (n, 3) from where one picture of the window does, in pixels.

    In float64, over the points in the whole picture, each on its screen. None if there are none,
    inf if a screen's pixels are more than float64 can hold.
    """
    trace = projection.trace(points_world)
    inside = trace.in_front & ~trace.outside.any(axis=-1)
    if not inside.any():
        return None
    whole = trace.image[inside]
    columns = screens[0].image_size[0]
    on_left, on_right = (screen.trace(points_world[inside]).image for screen in screens)
    wall = np.where(whole[:, :1] <= columns, on_left, on_right + np.array((columns, 0)))
    worst = float(np.abs(wall - whole).max())
    return worst if math.isfinite(worst) else math.inf


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    pair = warning = None
    if settings["screens"] == "2":
        try:
            pair = halves(projection)
        except Refusal:  # the camera is the reason, and the illustration says so
            warning = WORDS.phrase("too-narrow")
    screens = {"window": projection} if pair is None else dict(zip(_NAMES, pair, strict=True))
    left, right, bottom, top = projection.window
    off_axis = (left / 2.0 + right / 2.0) / (right / 2.0 - left / 2.0)
    x_sides, y_sides = ("left", "right"), ("bottom", "top")
    return Illustration(
        (
            *_join_readings(projection, pair, subject, warning or WORDS.phrase("one-screen")),
            *(
                Reading(WORDS[f"sides-{name}"], screen.window[:2], about=x_sides)
                for name, screen in screens.items()
            ),
            Reading(WORDS["bottom-top"], (bottom, top), about=y_sides),
            Reading(WORDS["off-axis"], off_axis, about=x_sides),
        ),
        world=_world_marks(projection, screens),
        ndc=_ndc_marks(projection, screens),
        image=_image_marks(projection, screens),
        warning=warning or WORDS.of_parallel(projection),
        grips=(_grip(projection.camera, number(settings, "shift")),),
    )


def _grip(camera: Camera, shift: float) -> Grip:
    """The eye, which moves sideways before its window."""
    across, eye = camera.frame[0], np.array(camera.eye)
    return Grip("shift", eye, vector(eye - shift * across), vector(across), "eye", "eye")


def _join_readings(
    projection: Projection,
    pair: tuple[Projection, Projection] | None,
    subject: Subject,
    why: Phrase,
) -> tuple[Reading, Reading]:
    join = difference = None
    unmeasured = why
    if pair is not None:
        join = join_error_px(pair)
        points = subject.points[:: max(1, len(subject.points) // _SAMPLE)]
        difference = largest_difference_px(projection, pair, points)
        unmeasured = WORDS.phrase("not-seen" if difference is None else "unmeasured")
    return (
        Reading.or_why(WORDS["join-error"], join, "px", why),
        Reading.or_why(WORDS["wall"], difference, "px", unmeasured),
    )


def _world_marks(projection: Projection, screens: dict[str, Projection]) -> Marks:
    """The window in the plane through the target, and the frusta from the eye to its screens.

    And, on the near plane, the sides that glFrustum takes the numbers of (lecture 003).
    """
    near, sides = section(projection, projection.lens.near), (BOTTOM, RIGHT, TOP, LEFT)
    marks: list[Mark] = [
        Polyline(np.array([near[i], near[i - 3]]), NEAR.name, 1.5, (side.name,))
        for i, side in enumerate(sides)
    ]
    for (name, screen), colour in zip(screens.items(), _COLOURS, strict=False):
        corners = section(screen, screen.camera.distance)
        starts = section(screen, screen.lens.near)
        if screen.lens.central:
            starts = np.broadcast_to(np.array(screen.camera.eye), (4, 3))
        marks.append(plate(corners, colour, 2.0, 0.16, (), name))
        marks += [segment(*ends, colour, 1.0) for ends in zip(starts, corners, strict=True)]
        marks.append(Text(name, (corners[2] + corners[3]) / 2.0, colour, text=WORDS[name]))
    if (right := screens.get("right")) is not None:
        marks.append(Polyline(section(right, right.camera.distance)[[0, 3]], "accent", 2.0))
    return Marks.of(*marks)


def _ndc_marks(projection: Projection, screens: dict[str, Projection]) -> Marks:
    """The plane in which the frusta join: upright in the cube, through both its ends."""
    if (left := screens.get("left")) is None:
        return Marks()
    x = 2.0 * left.image_size[0] / projection.image_size[0] - 1.0
    z_near, z_far = projection.depth_range
    corners = np.array([(x, -1.0, z_near), (x, 1.0, z_near), (x, 1.0, z_far), (x, -1.0, z_far)])
    name = Text("join", corners[1], "accent", text=WORDS["join"])
    return Marks.of(plate(corners, "accent", 1.5, 0.2), name)


def _image_marks(projection: Projection, screens: dict[str, Projection]) -> Marks:
    """The screens' frames in the picture, so far inside that its border does not cut them."""
    width, height = projection.image_size
    x, inner = 0.0, _INSET * min(width, height)
    low, high = inner, height - inner
    marks: list[Mark] = []
    for (name, screen), colour in zip(screens.items(), _COLOURS, strict=False):
        end = x + screen.image_size[0]
        first, last = max(x, inner), min(end, width - inner)
        corners = [(last, low), (first, low), (first, high), (last, high)]
        if name == "right":  # each screen is open towards the join, which has its own line
            corners = [(first, low), (last, low), (last, high), (first, high)]
        elif name == "window":
            corners.append(corners[0])
        marks.append(Polyline(np.array(corners, dtype=float), colour, 2.0))
        at = np.array([x + 0.03 * width, 0.06 * height])
        marks.append(Text(name, at, colour, text=WORDS[name]))
        x = end
    if (left := screens.get("left")) is not None:
        column = float(left.image_size[0])
        marks.append(segment((column, 0.0), (column, height), "accent", 1.5))
        marks.append(Text("join", np.array([column, 0.94 * height]), "accent", text=WORDS["join"]))
    return Marks.of(*marks)


def _implied(projection: Projection, _settings: Settings) -> ImpliedSettings:
    lens, distance = projection.lens, projection.camera.distance
    left, right, _, _ = lens.window_at(projection.window, distance)
    return {"shift": 0.0 - (left / 2.0 + right / 2.0)}


def _follow(projection: Projection, before: ImpliedSettings, after: Settings) -> Projection:
    step = number(after, "shift") - number(before, "shift")
    if step == 0.0:
        return projection
    moved = projection.with_lens("frustum")
    seen = Aperture(step, moved.camera.distance).seen_from(moved, 1.0, 0.0)
    left, right, bottom, top = seen.window
    kept = moved.lens.replaced(left=left, right=right, bottom=bottom, top=top)
    return replace(seen, lens=kept)


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show, follow=_follow, implied=_implied)
