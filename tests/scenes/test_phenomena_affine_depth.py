"""Bent by an affine z: the closed form against a search along the bow, in 30 digits."""

import math
from dataclasses import replace
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from app.lecture.letters import LETTERS, in_letters
from app.model.projection import (
    Array,
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.scenes.phenomena.affine_depth import PHENOMENON, bow, inside
from app.scenes.phenomena.illustration import Illustration, OwnMesh, Subject
from app.scenes.shapes import edges_of, letter_f
from tests.oracles.illustrations import readings

mp.mp.dps = 30

EYE = Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0))
"""World coordinates are the lectures' camera coordinates."""
FACES = letter_f()[0].reshape(-1, 3)
SUBJECT = Subject((-1.5, 0.0, -0.5), (1.5, 5.0, 0.5), np.unique(FACES, axis=0))
RANGES = {"opengl": (-1, 1), "direct3d": (0, 1), "reversed": (1, 0)}
CAMERA = Camera((3.0, 3.0, 9.0), (0.0, 2.5, 0.0))
"""It sees all of the letter."""


def show(projection: Projection, start: Any, end: Any) -> Illustration:
    return PHENOMENON.show(projection, PHENOMENON.checked({"start": start, "end": end}), SUBJECT)


def values(illustration: Illustration) -> list[Any]:
    return list(readings(illustration).values())


def bent(projection: Projection, view: Any) -> Any:
    """Lecture 000: (6) and (8) for x' and y', and (9) for z', A and B from their two equations."""
    lens = projection.lens
    left, right, bottom, top = map(mp.mpf, projection.window)
    near, far = mp.mpf(lens.near), mp.mpf(lens.far)
    z_near, z_far = RANGES[projection.depth]
    a = (z_far - z_near) / (near - far)  # A (-n) + B = z_near, A (-f) + B = z_far
    b = z_near + a * near
    x, y, z = view
    return mp.matrix([
        (2 * near / (right - left) * x + (right + left) / (right - left) * z) / -z,
        (2 * near / (top - bottom) * y + (top + bottom) / (top - bottom) * z) / -z,
        a * z + b,
    ])  # fmt: skip


def searched(projection: Projection, start: Any, end: Any) -> tuple[Any, Any]:
    """Largest distance from the chord in % of it, and w there: sampled densely, then narrowed."""
    start, end = (mp.matrix(list(map(mp.mpf, place))) for place in (start, end))
    first, last = bent(projection, start), bent(projection, end)
    chord = last - first
    length = mp.norm(chord)

    def distance(t: Any) -> Any:
        aside = bent(projection, start + t * (end - start)) - first
        along = mp.fdot(aside, chord) / length
        return mp.sqrt(max(mp.fdot(aside, aside) - along**2, mp.mpf(0)))

    best = max(range(1, 50), key=lambda i: distance(mp.mpf(i) / 50))
    low, high = mp.mpf(best - 1) / 50, mp.mpf(best + 1) / 50
    while high - low > 1e-10:
        one, other = low + (high - low) / 3, high - (high - low) / 3
        low, high = (one, high) if distance(one) < distance(other) else (low, other)
    t = (low + high) / 2
    return 100 * distance(t) / length, -(start + t * (end - start))[2]


def draw(rng: np.random.Generator) -> tuple[Projection, Array]:
    """A lens, and two points of its view volume."""
    near = float(10 ** rng.uniform(-2, 1))
    far = near * float(10 ** rng.uniform(0.1, 3))
    lens: Lens = Perspective(float(rng.uniform(10, 150)), near, far)
    if rng.random() < 0.5:
        left, bottom = rng.uniform(-near, near, 2)
        width, height = rng.uniform(0.1 * near, 2 * near, 2)
        lens = Frustum(left, left + width, bottom, bottom + height, near, far)
    projection = Projection(EYE, lens, (1280, 720), list(RANGES)[rng.integers(3)])  # type: ignore[arg-type]
    left, right, bottom, top = projection.window
    w = np.exp(rng.uniform(math.log(near * 1.001), math.log(far * 0.999), 2))
    x, y = rng.uniform([left, bottom], [right, top], (2, 2)).T
    return projection, np.stack([x * w / near, y * w / near, -w], axis=1) * [0.999, 0.999, 1.0]


def test_the_deviation_matches_a_search() -> None:
    rng = np.random.default_rng(3)
    found = []
    for _ in range(20):
        projection, ends = draw(rng)
        percent, w = searched(projection, *ends.tolist())
        got = values(show(projection, *map(tuple, ends.tolist())))
        assert got[0] == pytest.approx(float(percent), rel=1e-9, abs=1e-9)
        if percent > 1e-3:  # on a straight line there is no farthest place
            assert got[1] == pytest.approx(float(w), rel=1e-5)
        assert got[1] == pytest.approx(math.sqrt(ends[0, 2] * ends[1, 2]), rel=1e-12)
        found.append(got[0])
    assert max(found) > 20.0
    assert min(found) < 2.0


def test_a_cut_segment_is_reported_and_measured_between_its_own_ends() -> None:
    """P and Q may have any w, below 0 too; P' and Q' are found among points of PQ."""
    rng = np.random.default_rng(5)
    counted = {True: 0, False: 0}
    for _ in range(150):
        projection, ends = draw(rng)
        ends = ends.mean(axis=0) + rng.choice([0.9, 1.5, 4.0]) * (ends - ends.mean(axis=0))
        illustration = show(projection, *map(tuple, ends.tolist()))
        shares = np.linspace(0.0, 1.0, 4001)[:, None]
        trace = projection.trace((1.0 - shares) * ends[0] + shares * ends[1])
        inner = np.flatnonzero(~trace.outside.any(axis=1))
        if len(inner) < 100:
            continue
        cut = len(inner) < len(shares)
        deviation, where, _ = illustration.readings
        said = deviation.note is not None and "cuts PQ" in deviation.note.template
        assert said == cut == ("P'" in where.label) == ("Q'" in where.label)
        counted[cut] += 1
        w = trace.clip[inner[[0, -1]], 3]
        step = abs(trace.clip[1, 3] - trace.clip[0, 3])  # the ends may be as far beyond the last
        tolerance = 1e-12 if not cut else 1e-12 + float(step / w.min())
        assert where.value == pytest.approx(math.sqrt(w[0] * w[1]), rel=tolerance)
    assert min(counted.values()) > 25


@pytest.mark.parametrize("count", [None, 9, 999])
def test_the_subject_has_its_worst_edge(count: int | None) -> None:
    """The letter's, or a mesh's; a mesh with more edges than are counted says so."""
    projection = Projection(CAMERA, Perspective(60.0, 2.0, 30.0))
    edges, subject, name = edges_of(letter_f()[0])[0], SUBJECT, "letter"
    if count is not None:
        edges = np.random.default_rng(6).uniform((-1.5, 0.0, -3.0), (1.5, 5.0, 3.0), (9, 2, 3))
        subject, name = replace(SUBJECT, mesh=OwnMesh(edges, count, np.empty((0, 3, 3)))), "mesh"
    trace = projection.trace(edges)
    assert not trace.outside.any()
    worst = max(searched(projection, *ends.tolist())[0] for ends in trace.view)
    illustration = PHENOMENON.show(projection, PHENOMENON.checked({}), subject)
    reading = illustration.readings[-1]
    assert reading.label.startswith(f"worst edge of the {name}")
    assert reading.value == pytest.approx(float(worst), rel=1e-9) and worst > 0.01
    assert (reading.note and reading.note.values) == (("200", "999") if count == 999 else None)
    bows = [line.points for line in illustration.ndc.lines if len(line.points) == 9]
    ends = trace.ndc[..., :2]
    np.testing.assert_allclose([points[[0, -1], :2] for points in bows], ends, atol=1e-9)
    away = Projection(Camera((3.0, 3.0, 9.0), (3.0, 3.0, 90.0)), projection.lens)
    nothing = PHENOMENON.show(away, PHENOMENON.checked({}), subject).readings[-1]
    assert nothing.value is None and nothing.note is not None
    assert name in nothing.note.template


def test_the_marks_are_the_bow_and_the_straight_image() -> None:
    rng = np.random.default_rng(4)
    for _ in range(20):
        projection, ends = draw(rng)
        illustration = show(projection, *map(tuple, ends.tolist()))
        (curve,) = [line.points for line in illustration.ndc.lines if len(line.points) == 65]
        straight = next(line for line in illustration.ndc.lines if line.colour == "accent").points
        np.testing.assert_allclose(straight, projection.trace(ends).ndc, atol=1e-9)
        (over,) = illustration.image.lines
        np.testing.assert_allclose(over.points, projection.trace(ends).image, atol=1e-6)
        # Points of the bow are images of points of the segment, at their own w.
        t = np.array([0.0, 0.3, 0.5, 0.8, 1.0])
        for place in ends[0] + t[:, None] * (ends[1] - ends[0]):
            image = np.array([float(part) for part in bent(projection, place.tolist())])
            steps = (image[:2] - curve[0, :2]) @ (curve[-1, :2] - curve[0, :2])
            steps /= np.sum((curve[-1, :2] - curve[0, :2]) ** 2)
            got = bow(projection, inside(projection, ends[None]), np.array([steps]))[0, 0]
            np.testing.assert_allclose(got, image, atol=1e-8)
        dot = illustration.ndc.dots[0].point
        percent, _ = searched(projection, *ends.tolist())
        chord = curve[-1] - curve[0]
        aside = np.linalg.norm(np.cross(dot - curve[0], chord)) / np.linalg.norm(chord)
        assert 100 * aside / np.linalg.norm(chord) == pytest.approx(float(percent), abs=1e-8)


def test_a_missing_bow_is_explained() -> None:
    for lens in (Orthographic(), Oblique()):  # nothing is bent
        flat = show(Projection(Camera(), lens), (3.0, 2.0, 2.0), (-2.0, 3.0, -1.0))
        assert values(flat) == [0.0, None, 0.0] and flat.warning is not None
        assert {len(line.points) for line in flat.ndc.lines} == {2}
    endless = show(Projection(Camera(), Perspective(45.0, 1.0, math.inf)), (0, 0, 0), (1, 1, 1))
    assert values(endless) == [None, None, None] and endless.warning is not None
    seen = Projection(EYE, Perspective(60.0, 1.0, 10.0))
    for ends in (
        *(((0, 0, 1), (1, 1, 5)), ((0, 0, -11), (0, 0, -20)), ((50, 0, -2), (50, 1, -2))),
        ((0, 0, -2), (0, 0, -2)),  # a point
    ):
        outside = show(seen, *ends)
        assert values(outside)[:2] == [None, None] and outside.warning is not None
    along = show(seen, (0, 0, -2), (0, 0, -8))  # in the cube along z: nowhere to bend to
    assert values(along)[0] == 0.0


def test_l8_the_deviation_is_written_beside_the_bow() -> None:
    """By hand: x' from -1 to 1, w from 1 to 4, and z' = -1 + (w - 1)/2 from -1 to 0.5.

    The chord is 2 by 1.5, 2.5 long. At w = 2, x' = 1/3, the bow is at -0.5 and the chord at 0:
    0.5 aside in z', which is 0.4 across the chord, 16 % of it.
    """
    projection = Projection(EYE, Perspective(90.0, 1.0, 5.0), (600, 600))
    illustration = show(projection, (-1.0, 0.0, -1.0), (4.0, 0.0, -4.0))
    assert values(illustration)[:2] == pytest.approx([16.0, 2.0])
    assert values(show(projection, (4.0, 0.0, -4.0), (-1.0, 0.0, -1.0)))[0] == pytest.approx(16.0)
    texts = {text.text: text for text in illustration.ndc.texts}
    assert set(texts) == {"16 %", "A z + B", "{divided_z}", "P", "Q"}
    said = texts["16 %"]
    assert said.point == pytest.approx([1 / 3, 0.0, -0.5])
    assert said.away_from == pytest.approx([1 / 3, 0.0, 0.0])


def test_the_straight_line_is_written_with_the_lectures_sign() -> None:
    """000, (12): (Az + B)/(-z) = -A - B/z. 002 divides by z itself: (Az + B)/z = A + B/z."""
    a, b, z = -1.25, -2.25, -5.0
    written = {each: in_letters("{divided_z}", each) for each in LETTERS}
    assert written.pop("002") == "A + B / z"
    for text in written.values():
        value = eval(text.replace("−", "-"), {}, {"A": a, "B": b, "z": z})
        assert value == pytest.approx((a * z + b) / -z)
