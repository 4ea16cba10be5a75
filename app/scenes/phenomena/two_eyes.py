"""Two eyes: a stereo pair, of cameras with off-axis frusta or of cameras that are toed in.

The eyes are h = s/2 to the left and to the right of the camera's eye. Off axis, both look straight
ahead through one window in the screen plane at distance D: glFrustum's l and r (lecture 003) move
by ``h n/D``. Toed in, the camera's lens turns to the screen's middle by the angle whose tangent is
t = h/D. An eye at -h or +h sees a point (x, y) at distance w from the eye plane at the tangents::

    x' = (x -+ (h/D) (D - w)) / (w -+ t (x -+ h))       y' = y sqrt(1 + t^2) / (w -+ t (x -+ h))

Off axis, where t = 0, the right picture's minus the left one's are ``s (1/D - 1/w)`` and 0. Toed in
they differ by ``2 t x y sqrt(1 + t^2)`` over both denominators in height: the vertical parallax of
keystone distortion, which is largest in the corners (A. Woods, T. Docherty and R. Koch, "Image
distortions in stereoscopic video systems", Proc. SPIE 1915, 1993, section 2.5).
"""

import math
from dataclasses import replace

import numpy as np

from app.model.limits import vector
from app.model.parameter import ImpliedSettings, Settings, number, point
from app.model.projection import Array, Camera, Projection
from app.model.refusal import REFUSALS, Refusal
from app.scenes.phenomena import marks
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.picture import grip_of_plane, section
from app.scenes.phenomena.words import PhenomenonWords, Reading
from app.scenes.shapes import SIDE_RGB, Coloured, box_faces, edges_of, ground_grid, joined, letter_f

WORDS = PhenomenonWords("two-eyes")

_NAMES, _COLOURS, _IMAGES = ("left-eye", "right-eye"), ("u", "n"), ("P_l", "P_r")


def eyes_of(projection: Projection, settings: Settings) -> marks.Eyes:
    """Return what both eyes see. Raises a `Refusal` if no camera and lens do that."""
    camera = projection.camera
    window = marks.Aperture(number(settings, "separation") / 2.0, camera.distance)
    left, right = (window.seen_from(projection, side, 0.0) for side in (-1.0, 1.0))
    if settings["cameras"] == "toed-in":
        up = vector(camera.frame[1])
        turned = (Camera(each.camera.eye, camera.target, up) for each in (left, right))
        left, right = (replace(projection, camera=each) for each in turned)
    return marks.Eyes(left, right, str(settings["pictures"]))


def _geometry() -> tuple[Coloured, Coloured]:
    """The letter F, whose front is in the plane z = 0, a cube before it and a post behind it."""
    letter, rgb = letter_f()
    boxes = (((0.2, 0.0, 2.2), (1.0, 0.8, 3.0)), ((1.7, 0.0, -5.0), (2.7, 3.4, -4.0)))
    faces = np.concatenate([0.8 * letter + (-0.3, 0.0, -0.4), *(box_faces(*box) for box in boxes)])
    lines = joined(ground_grid((-4.0, -6.0), (4.0, 4.0), (1.0, 1.0), 0.0), edges_of(faces))
    return (faces, np.concatenate([rgb, SIDE_RGB, SIDE_RGB])), lines


def _follow(projection: Projection, before: ImpliedSettings, after: Settings) -> Projection:
    """The screen plane is the target's."""
    screen, near, camera = number(after, "screen"), projection.lens.near, projection.camera
    if screen == before["screen"]:
        return projection
    if screen < near:
        raise Refusal("settings.screen", screen, REFUSALS["not-before-near"], near)
    target = vector(camera.eye - screen * camera.frame[2])
    return replace(projection, camera=Camera(camera.eye, target, camera.up))


def _show(projection: Projection, settings: Settings, _subject: Subject) -> Illustration:
    if (parallel := WORDS.of_parallel(projection)) is not None:
        return Illustration((), warning=parallel)
    place, distance = np.array(point(settings, "point")), projection.camera.distance
    try:
        eyes = eyes_of(projection, settings)
    except Refusal:  # camera and lens are the reason
        return Illustration((), warning=WORDS.phrase("no-pair"))
    half, screen = number(settings, "separation") / 2.0, section(projection, distance)
    traces = [eye.trace([place, *screen]) for eye in (eyes.left, eyes.right)]
    pixels = np.array([np.where(t.in_front[:, None], t.image, math.nan) for t in traces])
    is_turned, behind = settings["cameras"] == "toed-in", WORDS.phrase("behind")
    # Off axis both eyes see each point at one height; the rest is rounding.
    apart = np.round(pixels[1] - pixels[0], 9) * (1.0, float(is_turned)) + 0.0
    across, down = apart[0].tolist() if np.isfinite(apart[0]).all() else (None, None)
    corners = np.abs(apart[1:, 1][np.isfinite(apart[1:, 1])])
    where = ("before-it", "in-it", "behind-it")[1 + int(np.sign(across or 0.0))]
    turn = math.atan2(half, distance) if is_turned else 0.0
    eye, u = projection.camera.eye, projection.camera.frame[0]
    return Illustration(
        (
            Reading.or_why(WORDS["across"], across, "px", behind),
            Reading.or_why(WORDS["down"], down, "px", behind),
            Reading.or_why(WORDS["largest"], max(corners.tolist(), default=None), "px", behind),
            Reading.or_why(WORDS["place"], None if across is None else WORDS[where], "", behind),
            Reading(WORDS["turned"], math.degrees(turn), "°"),
        ),
        world=_world_marks(screen, eyes, place),
        image=_image_marks(projection, eyes, pixels[:, 0]),
        rendering=marks.Rendering(eyes=eyes),
        warning=WORDS.phrase("before-near") if distance < projection.lens.near else None,
        grips=(
            marks.Grip("point", place, name="P"),
            grip_of_plane(projection, "screen", distance, distance, "screen", "accent"),
            marks.Grip("separation", eye + half * u, eye, vector(u / 2.0), "right-eye", "n"),
        ),
    )


def _world_marks(screen: Array, eyes: marks.Eyes, place: Array) -> marks.Marks:
    """The screen plane, both eyes with their frusta up to it, and the projectors of P."""
    parts: list[marks.Mark] = [marks.plate(screen, "accent", 1.5, 0.14, (), "screen")]
    parts.append(marks.Text("screen", screen[3], "accent", text=WORDS["screen"]))
    each = zip(_NAMES, _IMAGES, _COLOURS, (eyes.left, eyes.right), strict=True)
    for name, image, colour, seen in each:
        eye, reach = np.array(seen.camera.eye), seen.camera.distance
        window = section(seen, reach)
        parts += [marks.segment(eye, corner, colour, 0.5) for corner in window]
        if not np.allclose(window, screen):
            parts.append(marks.plate(window, colour, 1.0, 0.05))
        parts.append(marks.named(name, eye, colour, 1.6, WORDS[name]))
        away = -float(seen.trace(place).view[2])
        if away > 1e-9 * reach:  # or the projector meets the plane nowhere, or far out
            hit = eye + (place - eye) * (reach / away)
            parts.append(marks.segment(eye, place if away > reach else hit, colour, 1.5))
            parts.append(marks.named(image, hit, colour))
    return marks.Marks.of(*parts, marks.named("P", place, size=1.6))


def _image_marks(projection: Projection, eyes: marks.Eyes, pixels: Array) -> marks.Marks:
    """P in both pictures, and how far apart or how unlike in height it is there."""
    (width, height), shares = projection.image_size, np.array(eyes.shares)
    beside, middles = bool(shares.any()), width * (0.5 + shares)
    places = pixels + np.column_stack([width * shares, (0.0, 0.0)])
    x, y = places.T
    inside = np.abs(x - middles) <= width * (0.25 if beside else 0.5)
    inside &= (y >= 0.0) & (y <= height)
    parts: list[marks.Mark] = []
    if beside:
        parts.append(marks.segment((width / 2.0, 0.0), (width / 2.0, height), "ink", 1.0))
    if inside.all():
        ends = ((0.0, y[0]), (width, y[0])) if beside else places
        parts.append(marks.segment(ends[0], ends[1], "muted", 0.75))
    each = zip(_NAMES, _IMAGES, _COLOURS, places, middles, inside, strict=True)
    for name, image, colour, place, middle, is_seen in each:
        if beside:
            top = np.array([middle, 0.0])
            parts.append(marks.Text(name, top, colour, text=WORDS[name], is_title=True))
        if is_seen:
            parts.append(marks.named(image, place, colour))
    return marks.Marks.of(*parts)


PHENOMENON = Phenomenon.of(
    WORDS,
    geometry=_geometry,
    show=_show,
    follow=_follow,
    implied=lambda projection, _: {"screen": projection.camera.distance},
)
