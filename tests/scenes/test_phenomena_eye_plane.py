"""Crossing the eye plane: each readout against lecture 004's formula in 80 digits."""

import math
from dataclasses import replace
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from app.model.clipping import EYE_Z
from app.model.projection import Camera, Perspective, Projection
from app.scenes.phenomena.eye_plane import PHENOMENON, circle_angles, pictures, principal_point
from app.scenes.phenomena.illustration import Illustration, OwnMesh, Subject
from app.scenes.shapes import edges_of, letter_f
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import readings
from tests.support.lenses import LENSES

SIZE = (1280, 720)
CENTRAL = [lens for lens in LENSES.values() if lens.central]
FACES = letter_f()[0].reshape(-1, 3)
SUBJECT = Subject((-1.5, 0.0, -0.5), (1.5, 5.0, 0.5), np.unique(FACES, axis=0))
START = PHENOMENON.start
exact = cache(Exact)


def show(
    projection: Projection = START,
    start: Any = (-2.5, 1.5, 0.0),
    end: Any = (2.5, 1.8, 2.5),
    subject: Subject = SUBJECT,
) -> Illustration:
    return PHENOMENON.show(projection, PHENOMENON.checked({"start": start, "end": end}), subject)


def value(illustration: Illustration, label: str) -> Any:
    return readings(illustration)[label]


def case_of(illustration: Illustration) -> int:
    return int(value(illustration, "case, by the cut at z = −0.01").partition(":")[0])


def view_of(projection: Projection, place: Any) -> Any:
    return exact(projection)(place).view


def pixel(projection: Projection, x: Any, y: Any, z: Any) -> tuple[Any, Any]:
    """``x_p = -(d/z) x`` on the near plane, then u = s_x x_p + p_x (lecture 004, Persp)."""
    left, right, bottom, top = exact(projection).window()
    width, height = projection.image_size
    x_p, y_p = -mp.mpf(projection.lens.near) / z * x, -mp.mpf(projection.lens.near) / z * y
    return width * (x_p - left) / (right - left), height * (top - y_p) / (top - bottom)


def length_in_frame(projection: Projection, place: Any, breaks: list[Any]) -> Any:
    """Length of the drawn curve ``place(t)``, t between breaks, inside the frame."""
    total = mp.mpf(0)
    width, height = projection.image_size
    breaks = sorted(t for t in breaks if 0 <= t <= 1)
    for low, high in pairwise(breaks):
        if high - low < mp.mpf(10) ** -30:
            continue
        middle = place((low + high) / 2)
        if middle is None or not (0 < middle[0] < width and 0 < middle[1] < height):
            continue
        inner = (high - low) * mp.mpf(10) ** -25  # an end itself may lie in the eye plane
        one, other = place(low + inner), place(high - inner)
        total += mp.hypot(other[0] - one[0], other[1] - one[1])
    return total


def lengths(projection: Projection, start: Any, end: Any) -> tuple[Any, Any, Any]:
    """The lengths in px of the naive, the cut and the right picture of a segment.

    The pictures change where the signed distances from the frame's sides change their signs.
    """
    a, b = view_of(projection, start), view_of(projection, end)
    width, height = projection.image_size

    def at(t: Any) -> list[Any]:
        return [(1 - t) * p + t * q for p, q in zip(a, b, strict=True)]

    # Homogeneous distances from the sides are linear in t: two values give the root.
    def sides(t: Any) -> list[Any]:
        x, y, z = at(t)
        px, py = pixel(projection, x, y, z)
        return [px * -z, (width - px) * -z, py * -z, (height - py) * -z, -z, EYE_Z - z]

    ends = zip(sides(mp.mpf(0)), sides(mp.mpf(1)), strict=True)
    roots = [mp.mpf(0), mp.mpf(1), *(p / (p - q) for p, q in ends if p != q)]

    def before(z_cut: float) -> Any:
        def place(t: Any) -> Any:
            return pixel(projection, *at(t)) if at(t)[2] < z_cut else None

        return length_in_frame(projection, place, roots)

    one, other = pixel(projection, *a), pixel(projection, *b)
    crossings = [mp.mpf(0), mp.mpf(1)]
    for p, q, most in zip(one, other, (width, height), strict=True):
        crossings += [(bound - p) / (q - p) for bound in (0, most) if p != q]

    def naive(s: Any) -> tuple[Any, ...]:
        return tuple((1 - s) * p + s * q for p, q in zip(one, other, strict=True))

    return length_in_frame(projection, naive, crossings), before(EYE_Z), before(0.0)


def draw(rng: np.random.Generator) -> tuple[Projection, tuple[float, ...], tuple[float, ...]]:
    """A camera and a segment; one time in three so close to the eye that the cut is seen."""
    eye, target, start, end = rng.uniform(-4, 4, (4, 3))
    if rng.random() < 1 / 3:
        start, end = eye + (start - eye) / 300, eye + (end - eye) / 300
    eye, target, start, end = (tuple(map(float, place)) for place in (eye, target, start, end))
    return Projection(Camera(eye, target), CENTRAL[rng.integers(len(CENTRAL))], SIZE), start, end


def test_cases_and_lengths_match_the_formula() -> None:
    rng = np.random.default_rng(7)
    seen = set()
    drawn_wrongly = cut_off = 0
    for _ in range(80):
        projection, start, end = draw(rng)
        illustration = show(projection, start, end)
        naive, cut, right = lengths(projection, start, end)
        za, zb = (view_of(projection, p)[2] for p in (start, end))
        case = [[2, 3], [4, 1]][za <= EYE_Z][zb <= EYE_Z]
        seen.add(case)
        assert case_of(illustration) == case
        both = za < 0 and zb < 0
        close = {"abs": 1e-8, "rel": 1e-10}
        wrong = value(illustration, "AB drawn wrongly")
        written = "wrong" in [text.text for text in illustration.image.texts]
        assert written == (wrong > 0.0)
        assert wrong == pytest.approx(0.0 if both else float(naive), **close)
        assert value(illustration, "AB missed") == pytest.approx(
            0.0 if both else float(right), **close
        )
        left_out = value(illustration, "AB left out by the cut at z = −0.01")
        assert left_out == pytest.approx(float(right - cut), **close)
        drawn_wrongly += wrong > 10.0
        cut_off += left_out > 10.0
    assert seen == {1, 2, 3, 4}
    assert drawn_wrongly > 10
    assert cut_off >= 3


@pytest.mark.parametrize("count", [None, 12, 999])
def test_the_subject_s_lengths_are_the_sums_of_its_edges(count: int | None) -> None:
    """Of the letter F, or of a mesh; a mesh with more edges than are counted says so."""
    edges, subject, name = edges_of(letter_f()[0])[0], SUBJECT, "F"
    if count is not None:
        edges = np.random.default_rng(4).uniform((-1.5, 0.0, -3.0), (1.5, 5.0, 3.0), (12, 2, 3))
        subject, name = replace(SUBJECT, mesh=OwnMesh(edges, count, np.empty((0, 3, 3)))), "mesh"
    wrong = missed = mp.mpf(0)
    for start, end in edges:
        if any(view_of(START, p)[2] >= 0 for p in (start, end)):
            naive, _, right = lengths(START, start, end)
            wrong, missed = wrong + naive, missed + right
    illustration = show(subject=subject)
    assert float(wrong) > 100.0
    assert value(illustration, f"{name} drawn wrongly") == pytest.approx(float(wrong), rel=1e-9)
    assert value(illustration, f"{name} missed") == pytest.approx(float(missed), abs=1e-9)
    some = ("12", "999") if count == 999 else None
    for reading in illustration.readings:
        if reading.label.startswith(name):
            assert (reading.note and reading.note.values) == some
    told = [r.value for r in illustration.readings if r.label.startswith("edges of the mesh")]
    assert told == ([(12.0, 999.0)] if some else [])
    trace = START.trace(edges)
    drawn = pictures(START, trace.view, trace.clip)
    for diagram, part in zip(illustration.diagrams, drawn[:3], strict=False):
        shown = diagram.curves[1].points.reshape(-1, 3, 2)[:, :2]
        np.testing.assert_allclose(shown, part)


def test_the_mirrored_end_is_the_formula_s_and_the_frame_minus_the_right_one() -> None:
    """Equal where the window is symmetric; otherwise their sum is twice the principal point."""
    rng = np.random.default_rng(8)
    counted = {True: 0, False: 0}
    while min(counted.values()) < 15 or sum(counted.values()) < 50:
        projection, start, end = draw(rng)
        behind = [p for p in (end, start) if view_of(projection, p)[2] > 0]
        illustration = show(projection, start, end)
        got = value(illustration, "mirrored end"), value(illustration, "frame size minus right end")
        if not behind:
            assert got == (None, None)
            continue
        x, y, z = view_of(projection, behind[0])
        mirrored = [float(part) for part in pixel(projection, x, y, z)]
        right = [float(part) for part in pixel(projection, x, y, -z)]
        scale = max(1.0, *map(abs, mirrored))
        assert got[0] == pytest.approx(mirrored, abs=1e-11 * scale)
        minus = [SIZE[0] - right[0], SIZE[1] - right[1]]
        assert got[1] == pytest.approx(minus, abs=1e-11 * scale)
        symmetric = isinstance(projection.lens, Perspective)
        counted[symmetric] += 1
        if symmetric:
            assert got[0] == pytest.approx(got[1], abs=1e-11 * scale)
        else:
            principal = [float(part) for part in pixel(projection, 0, 0, -1)]
            assert principal_point(projection) == pytest.approx(principal, rel=1e-13)
            together = [m + r for m, r in zip(mirrored, right, strict=True)]
            assert together == pytest.approx([2 * part for part in principal], abs=1e-11 * scale)
            assert got[0] != pytest.approx(got[1], abs=1.0)
            note = illustration.readings[-1].note
            assert note is not None and note.values == pytest.approx(tuple(principal))


def test_the_circle_has_the_two_arcs() -> None:
    """The segment's own arc includes the top only if its ends are on both sides of the plane."""
    rng = np.random.default_rng(9)
    across = 0
    for _ in range(150):
        projection, start, end = draw(rng)
        trace = projection.trace(np.array([start, end]))
        angles = circle_angles(projection, trace.clip)
        assert angles is not None
        tops = [math.pi * k for k in range(-5, 6, 2)]
        crosses = any(min(angles) < top < max(angles) for top in tops)
        za, zb = trace.view[:, 2]
        assert crosses == ((za < 0.0) != (zb < 0.0))
        across += crosses
        # Distances along the line, from the angles, are those between the pixels.
        half = math.hypot(*SIZE) / 2
        a, b = (half * math.tan(angle / 2) for angle in angles)
        pixels = [pixel(projection, *view_of(projection, p)) for p in (start, end)]
        apart = mp.hypot(*(p - q for p, q in zip(*pixels, strict=True)))
        scale = max(abs(a), abs(b), half)
        assert abs(b - a) == pytest.approx(float(apart), abs=1e-9 * scale)
        circle = show(projection, start, end).diagrams[3].curves
        assert ("image of AB" in {curve.label for curve in circle}) == (min(za, zb) < 0.0)
        if min(za, zb) >= 0.0:
            continue
        naive, right = circle[1].points, circle[2].points
        np.testing.assert_allclose(np.hypot(*right.T), 1.0, rtol=1e-12)
        assert naive[:, 1].max() < 0.94
        same = bool(np.allclose(naive / np.hypot(*naive.T)[:, None], right, atol=1e-9))
        assert same == (not crosses)
    assert 25 <= across <= 110


@pytest.mark.parametrize("end", [(0, 0, 4), (0, 0, 0), (0, 0, -9)])
def test_a_segment_that_points_at_the_eye_has_one_point(end: tuple[float, ...]) -> None:
    projection = Projection(Camera((0, 0, 0), (0, 0, -1)), CENTRAL[0], SIZE)
    illustration = show(projection, (0, 0, -2), end)
    assert illustration.warning is not None
    assert value(illustration, "AB missed") == 0.0
    segment = illustration.diagrams[2].curves[2].points[:2]
    np.testing.assert_allclose(segment, [(640, 360), (640, 360)], atol=1e-9)


def test_an_end_in_the_eye_plane_has_its_image_at_infinity() -> None:
    projection = Projection(Camera((0, 0, 0), (0, 0, -1)), Perspective(90.0), (200, 200))
    illustration = show(projection, (0, 0, -2), (1, 0, 0))
    assert value(illustration, "mirrored end") is None
    assert value(illustration, "AB drawn wrongly") == 0.0
    assert value(illustration, "AB missed") == pytest.approx(100.0)  # from the middle to the side
    assert value(show(projection, (0, 0, -2), (1, 0, 5e-324)), "mirrored end") is None


def test_the_image_pane_shows_both_images() -> None:
    illustration = show()
    wrong, right = illustration.image.lines
    assert (wrong.colour, right.colour) == ("u", "accent")
    # Both leave the image of A, to opposite sides along the same line.
    start = START.trace(PHENOMENON.checked({})["start"]).image
    assert wrong.points[0] == pytest.approx(start)
    a, b = (line.points - wrong.points[0] for line in (wrong, right))
    far = b[np.hypot(*b.T).argmax()]
    assert np.hypot(*b.T).min() < 1e-9
    assert a[1] @ far == pytest.approx(-np.hypot(*a[1]) * np.hypot(*far), rel=1e-9)
    flipped = replace(START, camera=Camera((0.8, 2.4, 1.2), (2.8, 2.4, 2.2)))
    assert case_of(show(flipped)) == 3


def test_a_large_mesh_counts_the_edges_that_cross_the_eye_plane_first() -> None:
    """Otherwise 1500 longer edges in front would hide the 300 that are drawn wrongly."""
    random = np.random.default_rng(8)
    eye, (u, v, n) = np.array(START.camera.eye), START.camera.frame
    places = eye + random.uniform(-1.0, 1.0, (1500, 2, 1)) * u + 0.3 * random.normal() * v
    long_in_front = places + np.array([-1.0, -4.0])[None, :, None] * n
    short_across = places[:300, :1] + random.uniform(-0.1, 0.1, (300, 2, 1)) * u
    short_across = short_across + np.array([-0.05, 0.05])[None, :, None] * n
    edges = np.concatenate([long_in_front, short_across])
    mesh = OwnMesh(edges, len(edges), np.empty((0, 3, 3)))
    said = readings(show(subject=replace(SUBJECT, mesh=mesh)))
    trace = START.trace(edges)
    wrong_px = pictures(START, trace.view, trace.clip).wrong_px.sum()
    assert wrong_px > 1000.0
    assert said["mesh drawn wrongly"] == pytest.approx(wrong_px, rel=1e-9)
    assert said["edges of the mesh that are counted, and all"] == (300.0, 1800.0)


def test_nothing_is_named_that_is_not_drawn() -> None:
    """With both ends behind, only the naive divide draws AB, as the explanation says."""
    illustration = show(START, (2.5, 1.8, 2.5), (3.0, 2.0, 4.0))
    assert case_of(illustration) == 2
    for diagram in illustration.diagrams:
        for curve in diagram.curves:
            assert not curve.label or np.isfinite(curve.points).any(), (diagram.title, curve.label)
    named = [{curve.label for curve in diagram.curves} for diagram in illustration.diagrams]
    assert "AB" in named[0] and "AB" not in named[1] | named[2]
    assert "image of AB" not in named[3]
    start = show()
    assert "image of AB" in {curve.label for curve in start.diagrams[3].curves}
    assert "With one end behind" in PHENOMENON.words.explanation


@pytest.mark.parametrize(
    ("start", "end", "case"),
    [
        ((-2.5, 1.5, 0.0), (0.8, 2.4, 1.195), 4),  # B at z = -0.0022: before the eye
        ((0.8, 2.4, 1.195), (0.8, 2.45, 1.195), 2),
        ((0.8, 2.4, 1.2), (-2.5, 1.5, 0.0), 3),  # A in the eye
    ],
)
def test_between_the_cut_and_the_eye_nothing_is_said_to_be_behind_the_eye(
    start: Any, end: Any, case: int
) -> None:
    """Lecture 004's cases depend on the side of z = -0.01, not on the side of the eye."""
    illustration = show(START, start, end)
    assert case_of(illustration) == case
    assert value(illustration, "mirrored end") is None
    assert value(illustration, "AB drawn wrongly") == 0.0
    assert "wrong" not in [text.text for text in illustration.image.texts]


def test_the_cube_shows_the_part_of_the_segment_inside_it() -> None:
    """Compare with two thousand of its points, each divided by its own w."""
    rng = np.random.default_rng(12)
    inside = 0
    for _ in range(100):
        projection, start, end = draw(rng)
        ndc = show(projection, start, end).ndc
        assert len(ndc.lines) == len(ndc.texts)
        part = np.linspace(0.0, 1.0, 2000)[:, None]
        clip = projection.trace((1.0 - part) * np.array(start) + part * np.array(end)).clip
        seen = clip[(np.abs(clip[:, :3]) <= clip[:, 3:]).all(axis=1) & (clip[:, 3] > 0.0)]
        if len(seen) < 2:
            continue
        inside += 1
        (line,), (text,) = ndc.lines, ndc.texts
        points = seen[:, :3] / seen[:, 3:]
        low, high = np.sort(line.points, axis=0)
        assert np.abs(line.points).max() <= 1.0 + 1e-9
        assert (points >= low - 1e-9).all() and (points <= high + 1e-9).all()
        assert text.text == "AB" and (low <= text.point).all() and (text.point <= high).all()
    assert inside > 20


def test_the_world_shows_where_the_divide_puts_the_end_behind_the_eye() -> None:
    """A' and B' lie on the lines through the eye, on one plane before it; B' on the other side."""
    start = PHENOMENON.start
    shown = show(start)
    places = {text.name: text.point for text in shown.world.texts}
    eye, n = np.array(start.camera.eye), start.camera.frame[2]
    depths = []
    for name in "AB":
        to_end, to_image = places[name] - eye, places[f"{name}'"] - eye
        assert np.linalg.norm(np.cross(to_end, to_image)) == pytest.approx(0.0, abs=1e-9)
        assert (to_end @ to_image > 0.0) == (name == "A")
        depths.append(-to_image @ n)
    assert depths[0] == pytest.approx(depths[1]) and depths[0] > 0.0


@pytest.mark.parametrize(
    ("way", "kept", "missing"),
    [
        ("naive", 1.0, None),
        ("faces", 0.5, (0.5, 1.0)),  # the image runs to infinity: up to the eye plane
        ("cut", 0.5, (0.5, 1.0)),
        ("clipped", 0.25, (0.25, 1.0)),  # at z = -1, where x = w
    ],
)
def test_the_piece_without_an_image_is_dashed(way: str, kept: float, missing: Any) -> None:
    """By hand: AB from (1, 0, -2) to (1, 0, 2) pierces z = 0 at (1, 0, 0), inside the plane."""
    eye = Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0))
    projection = Projection(eye, Perspective(90.0, 0.1, 10.0), (600, 600))
    world = PHENOMENON.illustration(
        projection,
        PHENOMENON.checked({"start": (1, 0, -2), "end": (1, 0, 2), "drawn": way}),
        SUBJECT,
    ).world
    along = [line for line in world.lines if np.allclose(line.points[:, :2], (1.0, 0.0))]
    solid = [line.points[:, 2] for line in along if line.colour in ("accent", "u")]
    dashed = [line.points[:, 2] for line in along if line.colour == "muted"]
    assert sum(float(np.ptp(z)) for z in solid) == pytest.approx(4.0 * kept)
    assert np.min(solid) == -2.0
    if missing is None:
        assert not dashed
    else:
        assert (np.min(dashed), np.max(dashed)) == pytest.approx(
            tuple(4.0 * t - 2.0 for t in missing)
        )
    front = [line.points[:, 2].max() for line in along if line.colour == "accent"]
    assert front == pytest.approx([min(0.0, 4.0 * kept - 2.0)])
    plane = next(face.points for face in world.faces if face.name == "w=0")
    assert plane[:, 2] == pytest.approx(0.0) and (np.ptp(plane, axis=0)[:2] > 2.0).all()
    name = next(text for text in world.texts if text.name == "w=0")
    assert name.point[:2] == pytest.approx((plane[:, 0].min(), plane[:, 1].max()))
    assert name.away_from == pytest.approx((0.0, 0.0, 0.0))  # beside no end of AB: A is right
    _, ruled = (line.points for line in world.lines if line.name == "w=0")
    assert len(ruled) == 13 and (np.ptp(ruled, axis=0) == np.ptp(plane, axis=0)).all()


def test_after_the_cut_the_image_runs_past_the_frame_and_after_clipping_it_ends_there() -> None:
    """By hand: the plane is 0.5 before the eye and reaches to x = 0.5; A is seen at x = 0.25."""
    eye = Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0))
    projection = Projection(eye, Perspective(90.0, 0.1, 10.0), (600, 600))
    reached = []
    for way in ("cut", "clipped"):
        settings = PHENOMENON.checked({"start": (1, 0, -2), "end": (1, 0, 2), "drawn": way})
        shown = PHENOMENON.illustration(projection, settings, SUBJECT).world
        image = [
            line.points
            for line in shown.lines
            if line.colour == "accent" and np.allclose(line.points[:, 2], -0.5)
        ]
        assert len(image) == 1 and image[0][0] == pytest.approx((0.25, 0.0, -0.5))
        reached.append(float(image[0][1, 0]))
        assert {text.name for text in shown.texts} == {"A", "B", "A'", "w=0"}
    assert reached == pytest.approx([0.9, 0.5])


def test_the_three_ways_to_draw_an_edge_that_crosses_differ_at_a_glance() -> None:
    """Wrong edges in another colour; a cut one with an arrow; a clipped one with a dot."""
    naive, cut, clipped = (
        PHENOMENON.illustration(START, PHENOMENON.checked({"drawn": way}), SUBJECT).image
        for way in ("naive", "cut", "clipped")
    )
    thick = [{line.colour for line in each.lines if line.width > 2.0}
             for each in (naive, cut, clipped)]  # fmt: skip
    assert thick == [{"u"}, {"accent"}, {"accent"}]
    arrows = [sum(len(face.points) == 3 for face in each.faces) for each in (naive, cut, clipped)]
    at_frame = [[dot for dot in each.dots if dot.size > 1.5] for each in (naive, cut, clipped)]
    dots = [len(each) for each in at_frame]
    names = [{text.name for text in each.texts} for each in (naive, cut, clipped)]
    assert names == [{"AB", "A'", "B'"}, {"AB", "A'"}, {"AB", "A'"}]
    assert arrows[0] == arrows[2] == 0 < arrows[1] and dots[0] == dots[1] == 0 < dots[2]
    for dot in at_frame[2]:
        assert np.isclose(np.minimum(dot.point, (1280, 720) - dot.point).min(), 0.0, atol=1e-3)
