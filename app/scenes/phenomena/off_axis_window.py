"""Off-axis window: the frustum of an eye that is not in front of the middle of its window.

The window stays in the plane through the target while the eye moves sideways, so that left and
right of the near plane's window become unequal (lectures 000, 002, 003: glFrustum). A wall of two
screens is two such frusta with one eye: the right side of the one is the left side of the other.
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np

from app.model.projection import Array, Camera, Frustum, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.scenes.phenomena.illustration import Comparison, Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Line, Mark, Marks, Text, plate
from app.scenes.phenomena.picture import section
from app.scenes.phenomena.readout import Phrase, Reading, figure, of_parallel
from app.scenes.phenomena.settings import Found, Setting, Settings, number
from app.scenes.shapes import SIDE_RGB, Coloured, box_faces, edges_of, ground_grid, joined, letter_f

_ONE_SCREEN = QT_TRANSLATE_NOOP("phenomena", "there is only one screen, and so no join")
_TOO_NARROW = QT_TRANSLATE_NOOP("phenomena", "this window is too narrow for two screens")
_NOT_SEEN = QT_TRANSLATE_NOOP(
    "phenomena", "no point of the subject that is compared is in the picture"
)
_PARALLEL = QT_TRANSLATE_NOOP(
    "phenomena",
    "with a parallel lens it is a box that goes through the window, not a frustum from the eye",
)
_UNMEASURED = QT_TRANSLATE_NOOP(
    "phenomena", "the subject's pixels are more than float64 can hold on one of the screens"
)
_LEFT = QT_TRANSLATE_NOOP("phenomena", "left screen")
_RIGHT = QT_TRANSLATE_NOOP("phenomena", "right screen")
_WINDOW = QT_TRANSLATE_NOOP("phenomena", "window")
_SIDES_LEFT = QT_TRANSLATE_NOOP("phenomena", "{l}, {r} of the left screen")
_SIDES_RIGHT = QT_TRANSLATE_NOOP("phenomena", "{l}, {r} of the right screen")
_SIDES_WINDOW = QT_TRANSLATE_NOOP("phenomena", "{l}, {r} of the window")
_JOIN = QT_TRANSLATE_NOOP("phenomena", "join")

_SAMPLE = 100  # about as many vertices are compared at every step


def _geometry() -> tuple[Coloured, Coloured]:
    letter, rgb = letter_f()
    letter = letter * 0.8 + (-2.4, 0.0, -1.5)
    # A beam before the window and one behind it, both across the join.
    beams = [((-3.2, 0.6, 1.0), (3.0, 1.0, 1.4)), ((-4.5, 3.6, -5.0), (4.5, 4.2, -4.4))]
    blocks = [((1.2, 0.0, -2.5), (2.4, 2.6, -1.3)), ((-0.5, 0.0, -4.0), (0.6, 1.6, -2.9))]
    quads = [letter, *(box_faces(*box) for box in (*beams, *blocks))]
    faces = np.concatenate(quads)
    colours = np.concatenate([rgb, *([SIDE_RGB] * 4)])
    lines = joined(ground_grid((-6.0, -8.0), (6.0, 4.0), (1.0, 1.0), 0.0), edges_of(faces))
    return (faces, colours), lines


# --------------------------------------------------------------------------- the two halves


def halves(projection: Projection) -> tuple[Projection, Projection]:
    """The left and the right screen of the wall that the whole window is.

    Parameters
    ----------
    projection : Projection
        With an image at least 2 pixels wide.

    Returns
    -------
    left, right : Projection
        Same camera and planes; the join is at a column of pixels, in the middle or, with an odd
        width, half a pixel beside it.

    Raises
    ------
    Refusal
        For a window or an image that is too narrow to be split.
    """
    width, height = projection.image_size
    windowed = projection if projection.lens.window_stays else projection.with_lens("frustum")
    left, right, bottom, top = projection.window
    columns = width // 2
    middle = left + (right - left) * (columns / width)
    screens = []
    for low, high, across in ((left, middle, columns), (middle, right, width - columns)):
        half = windowed.lens.but(left=low, right=high, bottom=bottom, top=top, keep="stretch")
        screens.append(replace(projection, lens=half, image_size=(across, height)))
    return screens[0], screens[1]


def join_error_px(screens: tuple[Projection, Projection]) -> float:
    """How far apart the two screens show points of the plane in which they join, in pixels.

    A point of the right edge of the left screen, and with it its projector, goes through the left
    lens's own numbers and through the right one's, in rationals: with
    glFrustum ``x_clip/w = 2n/(r - l) x/w - (r + l)/(r - l)``. On the left it should be at the last
    column's end, on the right at the first one's beginning.

    Returns
    -------
    float
        The largest gap or overlap; exactly 0 if the halves join.
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
    """How far the wall shows points from where one picture of the whole window does, in pixels.

    Parameters
    ----------
    projection : Projection
    screens : (Projection, Projection)
        Its `halves`.
    points_world : (n, 3) array

    Returns
    -------
    float or None
        In float64, over the points in the whole picture, each on the screen that it is on; None
        if there are none, inf if a screen's pixels are more than float64 can hold.
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


# --------------------------------------------------------------------------- what is shown


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    two = settings["screens"] == "2"
    screens: tuple[Projection, ...] = (projection,)
    warning = None
    if two:
        try:
            screens = halves(projection)
        except Refusal:  # said in the illustration, where it belongs to the camera
            warning = Phrase(_TOO_NARROW)
    names = (_LEFT, _RIGHT) if len(screens) == 2 else (_WINDOW,)
    readings = _join_readings(projection, screens, subject, warning or Phrase(_ONE_SCREEN))
    sides = (_SIDES_LEFT, _SIDES_RIGHT) if len(screens) == 2 else (_SIDES_WINDOW,)
    for label, screen in zip(sides, screens, strict=True):
        readings.append(Reading(label, screen.window[:2], about=("left", "right")))
    left, right, bottom, top = projection.window
    readings += [
        Reading(QT_TRANSLATE_NOOP("phenomena", "{b}, {t}"), (bottom, top), about=("bottom", "top")),
        Reading(
            QT_TRANSLATE_NOOP("phenomena", "off the axis, ({r} + {l})/({r} − {l})"),
            (left / 2.0 + right / 2.0) / (right / 2.0 - left / 2.0),
            about=("left", "right"),
        ),
    ]
    return Illustration(
        tuple(readings),
        world=_world_marks(projection, screens, names),
        ndc=_ndc_marks(projection, screens),
        image=_image_marks(projection, screens, names),
        warning=warning or of_parallel(projection, _PARALLEL),
    )


def _join_readings(
    projection: Projection, screens: tuple[Projection, ...], subject: Subject, why: Phrase
) -> list[Reading]:
    join: float | None = None
    difference: float | None = None
    unmeasured = why
    if len(screens) == 2:
        pair = (screens[0], screens[1])
        join = join_error_px(pair)
        points = subject.points[:: max(1, len(subject.points) // _SAMPLE)]
        difference = largest_difference_px(projection, pair, points)
        unmeasured = Phrase(_NOT_SEEN if difference is None else _UNMEASURED)
        if difference == math.inf:
            difference = None
    against = QT_TRANSLATE_NOOP("phenomena", "wall against one picture, float64")
    return [
        Reading.or_why(QT_TRANSLATE_NOOP("phenomena", "error of the join"), join, "px", why),
        Reading.or_why(against, difference, "px", unmeasured),
    ]


def _world_marks(
    projection: Projection, screens: tuple[Projection, ...], names: tuple[str, ...]
) -> Marks:
    """The window in the plane through the target, and the frusta from the eye to its screens.

    And, on the near plane, the four numbers that glFrustum takes of it (lecture 003).
    """
    marks: list[Mark] = _near_rectangle(projection)
    for screen, name, colour in zip(screens, names, ("u", "n"), strict=False):
        corners = section(screen, screen.camera.distance)
        starts = section(screen, screen.lens.near)
        if screen.lens.central:
            starts = np.broadcast_to(np.array(screen.camera.eye), (4, 3))
        marks.append(plate(corners, colour, 2.0, 0.16))
        marks += [Line(np.array(ends), colour, 1.0) for ends in zip(starts, corners, strict=True)]
        marks.append(Text(name, (corners[2] + corners[3]) / 2.0, colour))
    if len(screens) == 2:
        marks.append(Line(section(screens[1], screens[1].camera.distance)[[0, 3]], "accent", 2.0))
    return Marks.of(*marks)


def _near_rectangle(projection: Projection) -> list[Mark]:
    """The near plane's window, l, r, b and t written at the side where each of them is."""
    left_bottom, right_bottom, right_top, left_top = section(projection, projection.lens.near)
    ends = {
        "left": (left_bottom, left_top),
        "right": (right_bottom, right_top),
        "bottom": (left_bottom, right_bottom),
        "top": (left_top, right_top),
    }
    marks: list[Mark] = []
    middle = (left_bottom + right_top) / 2.0
    for (side, edge), value in zip(ends.items(), projection.window, strict=True):
        marks.append(Line(np.array(edge), "near", 1.5, (side,)))
        text = f"{{{side[0]}}} = {figure(value, 4)}"
        marks.append(Text(text, (edge[0] + edge[1]) / 2.0, "near", (side,), middle))
    return marks


def _ndc_marks(projection: Projection, screens: tuple[Projection, ...]) -> Marks:
    """The plane in which the frusta join: upright in the cube, through both its ends."""
    if len(screens) == 1:
        return Marks()
    x = 2.0 * screens[0].image_size[0] / projection.image_size[0] - 1.0
    z_near, z_far = projection.depth_range
    corners = np.array([(x, -1.0, z_near), (x, 1.0, z_near), (x, 1.0, z_far), (x, -1.0, z_far)])
    return Marks.of(plate(corners, "accent", 1.5, 0.2), Text(_JOIN, corners[1], "accent"))


def _image_marks(
    projection: Projection, screens: tuple[Projection, ...], names: tuple[str, ...]
) -> Marks:
    width, height = projection.image_size
    x = 0.0
    marks: list[Mark] = []
    for screen, name, colour in zip(screens, names, ("u", "n"), strict=False):
        across = screen.image_size[0]
        end = x + across
        corners = [(end, 0.0), (x, 0.0), (x, height), (end, height)]
        if name == _RIGHT:  # each is open towards the join, which has a line of its own
            corners = [(x, 0.0), (end, 0.0), (end, height), (x, height)]
        elif name == _WINDOW:
            corners.append(corners[0])
        marks.append(Line(np.array(corners, dtype=float), colour, 2.0))
        marks.append(Text(name, np.array([x + 0.03 * width, 0.06 * height]), colour))
        x = end
    if len(screens) == 2:
        column = float(screens[0].image_size[0])
        marks.append(Line(np.array([(column, 0.0), (column, height)]), "accent", 1.5))
        marks.append(Text(_JOIN, np.array([column, 0.94 * height]), "accent"))
    return Marks.of(*marks)


def _found(projection: Projection, _settings: Settings) -> Found:
    """How far the eye is to the right of the window's middle."""
    lens, distance = projection.lens, projection.camera.distance
    left, right, _, _ = lens.window_at(projection.window, distance)
    return {"shift": 0.0 - (left / 2.0 + right / 2.0)}


def _follow(projection: Projection, before: Found, after: Settings) -> Projection:
    step = number(after, "shift") - number(before, "shift")
    if step == 0.0:
        return projection
    moved = projection.with_lens("frustum")
    camera, lens = moved.camera, moved.lens
    along = [step * part for part in camera.frame[0].tolist()]
    eye, target = (
        (x + along[0], y + along[1], z + along[2]) for x, y, z in (camera.eye, camera.target)
    )
    # The window stays: seen from the eye, at the near plane, it moves the other way.
    back = step * (lens.near / camera.distance)
    left, right, bottom, top = moved.window
    return replace(
        moved,
        camera=Camera(eye, target, camera.up),
        lens=lens.but(left=left - back, right=right - back, bottom=bottom, top=top),
    )


PHENOMENON = Phenomenon(
    name="off-axis-window",
    title=QT_TRANSLATE_NOOP("phenomena", "Off-axis window"),
    explanation=QT_TRANSLATE_NOOP(
        "phenomena",
        "Walk past a window: it stays in its wall, so the frustum from the eye through it leans,"
        " and left and right of the near plane's window are no longer opposite. What lies in the"
        " window's own plane keeps its place in the image. Two screens side by side are two such"
        " frusta with one eye, and their pictures join without a gap.",
    ),
    tries=(
        QT_TRANSLATE_NOOP("phenomena", "Walk past the window: drag the eye."),
        QT_TRANSLATE_NOOP("phenomena", "Which way does the frustum lean?"),
        QT_TRANSLATE_NOOP("phenomena", "What stays in its place in the image?"),
    ),
    lectures=("000", "002", "003"),
    start=Projection(
        Camera((1.5, 2.4, 8.0), (1.5, 2.4, 0.0)),
        # The window is 8 by 4.5 in the plane z = 0, 8 units away; its middle is 1.5 to the left.
        Frustum(-2.2, 1.0, -0.9, 0.9, 3.2, 19.0, "y"),
    ),
    geometry=_geometry,
    show=_show,
    settings=(
        Setting(
            "shift",
            QT_TRANSLATE_NOOP("phenomena", "Eye right of the middle"),
            QT_TRANSLATE_NOOP(
                "phenomena",
                "From the window's middle; moves the eye: the window stays in the world",
            ),
            1.5,
            low=-1e4,
            high=1e4,
            span=(-5.0, 5.0),
            per_second=1.0,
        ),
        Setting(
            "screens",
            QT_TRANSLATE_NOOP("phenomena", "Screens"),
            QT_TRANSLATE_NOOP("phenomena", "One window, or a wall of two screens side by side"),
            "2",
            choices=(
                ("1", QT_TRANSLATE_NOOP("phenomena", "One window")),
                ("2", QT_TRANSLATE_NOOP("phenomena", "A wall of two")),
            ),
        ),
    ),
    controls=("lens.left", "lens.right"),
    follow=_follow,
    found=_found,
    own_mesh=True,
    comparisons=(
        Comparison(  # which an image of the window's own aspect would not show
            "proportions",
            (
                (QT_TRANSLATE_NOOP("phenomena", "stretch"), ("lens.keep=stretch",)),
                (QT_TRANSLATE_NOOP("phenomena", "keep x"), ("lens.keep=x",)),
                (
                    QT_TRANSLATE_NOOP("phenomena", "keep y"),
                    ("lens.keep=y", "image.width=720", "image.height=720"),
                ),
            ),
        ),
    ),
)
