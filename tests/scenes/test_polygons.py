"""Polygons in triangles: their area and place are those of the shoelace formula, in any plane."""

import subprocess
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv

from app.model.refusal import REFUSALS, Refusal
from app.scenes import reading
from app.scenes.finishing import finished
from app.scenes.mesh import Mesh
from app.scenes.polygons import area_vectors, divided
from app.scenes.scene import load
from tests.support.meshes import segments

Floats = np.ndarray


def shoelace(ring: Floats) -> float:
    """Signed area of a polygon (n, 2)."""
    x, y = (ring - ring[0]).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2.0


def triangles(ring: Floats) -> Floats:
    """The triangles (k, 3, 2 or 3) of a polygon in the plane or in space."""
    points = np.column_stack([ring, np.zeros(len(ring))]) if ring.shape[1] == 2 else ring
    ends = np.array([0, len(ring)])
    found, owner = divided(points, ends, np.arange(len(ring)), lambda _: None)
    assert (owner == 0).all()
    return ring[found]


def areas(found: Floats) -> Floats:
    """Areas of triangles (k, 3, 3)."""
    return (
        np.linalg.norm(np.cross(found[:, 1] - found[:, 0], found[:, 2] - found[:, 0]), axis=1) / 2
    )


def ragged(random: np.random.Generator, count: int, centre: Floats, radius: float) -> Floats:
    """A concave polygon about a centre, counter-clockwise."""
    turn = (np.arange(count) + random.uniform(0.0, 0.6, count)) * (2.0 * np.pi / count)
    around = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    return centre + around * random.uniform(0.55, 1.0, (count, 1)) * radius


def keyholed(random: np.random.Generator) -> tuple[Floats, list[Floats]]:
    """A concave polygon with holes, as one outline with bridges, and its rings."""
    outer = ragged(random, int(random.integers(7, 40)), np.zeros(2), 4.0)
    outer *= 1.0 + 0.3 / np.linalg.norm(outer, axis=1, keepdims=True)
    rings, outline = [outer], [*outer.tolist()]
    for place in range(int(random.integers(1, 5))):
        centre = 0.9 * np.array([np.cos(place * np.pi / 2), np.sin(place * np.pi / 2)])
        hole = ragged(random, int(random.integers(3, 9)), centre, 0.5)[::-1]
        at = int(random.integers(len(outline)))
        outline[at + 1 : at + 1] = [*hole.tolist(), hole[0].tolist(), outline[at]]
        rings.append(hole)
    return np.array(outline), rings


def is_inside(ring: Floats, places: Floats) -> np.ndarray:
    (x, y), (next_x, next_y) = ring.T[:, :, None], np.roll(ring, -1, axis=0).T[:, :, None]
    px, py = places.T
    with np.errstate(all="ignore"):
        crossing = x + (py - y) * (next_x - x) / (next_y - y)
    return ((((y > py) != (next_y > py)) & (px < crossing)).sum(axis=0) % 2).astype(bool)


def test_polygons_with_holes_in_any_plane_keep_their_area_and_place() -> None:
    random = np.random.default_rng(20)
    for _ in range(100):
        outline, rings = keyholed(random)
        plane, _ = np.linalg.qr(random.normal(size=(3, 3)))
        scale, away = 10.0 ** random.uniform(-9.0, 9.0), random.normal(size=3)
        flat = np.column_stack([outline, np.zeros(len(outline))])
        area = shoelace(rings[0]) - sum(abs(shoelace(hole)) for hole in rings[1:])
        for points, unit in ((flat, 1.0), (scale * (flat @ plane.T + away), scale)):
            parts = triangles(points)
            assert areas(parts).sum() == pytest.approx(area * unit**2, rel=1e-12)
        visible = areas(triangles(flat)) > 1e-9
        middles = triangles(outline).mean(axis=1)[visible]
        assert is_inside(rings[0], middles).all()
        assert not any(is_inside(hole, middles).any() for hole in rings[1:])


SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
OUTLINES: dict[str, tuple[list[list[float]], float]] = {
    "a hole that turns like its outline": (
        [*SQUARE, [0, 0], [1, 1], [3, 1], [3, 3], [1, 3], [1, 1]], 12.0,
    ),
    "keyhole": ([*SQUARE, [0, 0], [1, 1], [1, 3], [3, 3], [3, 1], [1, 1]], 12.0),
    "bridge in two pieces": (
        [*SQUARE, [0, 0], [0.5, 0.5], [1, 1], [1, 3], [3, 3], [3, 1], [1, 1]], 12.0,
    ),
    "collinear corners": ([[0, 0], [1, 0], [2, 0], [4, 0], [4, 4], [2, 4], [2, 2], [0, 2]], 12.0),
    "corner that touches an edge": ([*SQUARE[:3], [2, 0], [0, 4]], 8.0),
    "corner that touches a corner": (
        [[0, 0], [2, 2], [4, 0], [4, 4], [2, 2], [0, 4]], 8.0,
    ),
    "spike": ([*SQUARE[:2], [7, 1], [4, 0], *SQUARE[2:], [0, 2]], 16.0),
    "edges there and back only": ([[0, 0], [4, 0], [0, 0], [0, 3], [0, 0], [2, 2]], 0.0),
    "crossing": ([[0, 0], [4, 4], [4, 0], [0, 4], [-1, 2]], 10.0),
    "bow tie": ([[0, 0], [4, 4], [4, 0], [0, 4]], 16.0),
    "line": ([[0, 0], [1, 1], [3, 3], [2, 2], [0.5, 0.5]], 0.0),
    "L that is a fan of its second corner": (
        [[4, 2], [2, 2], [2, 4], [0, 4], [0, 0], [4, 0]], 12.0,
    ),
    "U": ([[0, 0], [3, 0], [3, 3], [2, 3], [2, 1], [1, 1], [1, 3], [0, 3]], 7.0),
    "arrow of four corners": ([[0, 0], [4, 4], [0, 2], [-4, 4]], 8.0),
}  # fmt: skip


@pytest.mark.parametrize("name", OUTLINES)
def test_odd_outlines_keep_their_area(name: str) -> None:
    corners, area = OUTLINES[name]
    for first in range(len(corners)):
        for step in (1, -1):
            ring = np.roll(np.array(corners, dtype=float), first, axis=0)[::step]
            found = areas(triangles(np.column_stack([ring, ring @ [0.5, -2.0]]))).sum()
            if name != "crossing":
                assert found / np.sqrt(1 + 0.25 + 4.0) == pytest.approx(area, abs=1e-12)


def test_a_touch_may_be_rounded_as_float32_rounds_it() -> None:
    """The notch touches the edge opposite; rounding moves its tip through that edge, or not."""
    notched = np.array([[0, 0], [4, 0], [4, 4], [3, 4], [2, 0], [1, 4], [0, 4]], dtype=float)
    for angle in np.linspace(0.1, 3.0, 12):
        cos, sin = np.cos(angle), np.sin(angle)
        ring = notched @ [[cos, sin], [-sin, cos]]
        for rounded in (ring, ring.astype(np.float32).astype(float), (ring + 1e8) - 1e8):
            found = areas(triangles(np.column_stack([rounded, 0.0 * rounded[:, 0]]))).sum()
            assert found == pytest.approx(12.0, rel=1e-6)


def test_a_polygon_that_is_not_quite_flat_stays_whole() -> None:
    random = np.random.default_rng(3)
    outline, _ = keyholed(random)
    height = 1e-3 * np.sin(3.0 * outline[:, 0])
    found = areas(triangles(np.column_stack([outline, height]))).sum()
    assert found == pytest.approx(shoelace(outline), rel=1e-4)
    assert found > shoelace(outline)


def test_a_star_of_10_000_corners_takes_less_than_seconds() -> None:
    count = 10_000
    turn = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    radius = np.random.default_rng(1).uniform(0.1, 1.0, count)
    ring = np.stack([radius * np.cos(turn), radius * np.sin(turn), 0.0 * turn], axis=1)
    began = time.process_time()
    found = triangles(ring)
    assert time.process_time() - began < 5.0
    assert areas(found).sum() == pytest.approx(shoelace(ring[:, :2]), rel=1e-12)


def test_an_outline_that_repeats_itself_takes_no_time_of_its_cube() -> None:
    ring = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.3, 0.5]] * 2_500)
    began = time.process_time()
    assert areas(triangles(np.column_stack([ring, ring[:, 0]]))).sum() > 0.0
    assert time.process_time() - began < 5.0


def test_triangles_turn_like_their_polygon() -> None:
    outline, _ = keyholed(np.random.default_rng(4))
    for ring in (outline, outline[::-1]):
        a, b, c = triangles(ring).transpose(1, 2, 0)
        turns = (b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]
        assert (turns * np.sign(shoelace(ring)) >= -1e-12).all()


def test_faces_that_take_too_long_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A random outline crosses itself a million times."""
    places = np.random.default_rng(5).uniform(size=(8_000, 2)).tolist()
    lines = [f"v {x} {y} 0" for x, y in places]
    (tmp_path / "m.obj").write_text(
        "\n".join([*lines, f"f {' '.join(map(str, range(1, 8_001)))}"]), encoding="utf-8"
    )
    monkeypatch.setattr(reading, "DIVIDING_S", 0.2)
    with pytest.raises(Refusal) as caught:
        reading.read(tmp_path / "m.obj")
    assert caught.value.bound == REFUSALS["too-long"]


HOLE = (
    "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n"
    "f 1 2 3 4 1 5 6 7 8 5\n"
)


def test_a_hole_is_empty_and_its_bridge_is_no_edge(tmp_path: Path) -> None:
    (tmp_path / "hole.obj").write_text(HOLE, encoding="utf-8")
    scene = load(str(tmp_path / "hole.obj"))
    assert scene.surface is not None
    assert pv.wrap(scene.surface).area == pytest.approx(12.0, rel=1e-6)
    ends = segments(scene)
    drawn = ends[scene.ground_lines :]
    assert len(drawn) == 8
    assert (np.count_nonzero(np.ptp(drawn, axis=1), axis=1) == 1).all()  # none is slanted


def test_a_concave_face_of_four_corners_is_divided_and_a_convex_one_stays_whole() -> None:
    points = np.array([[0, 0, 0], [4, 4, 0], [0, 2, 0], [-4, 4, 0], [0, 9, 0]], dtype=float)
    faces = np.array([0, 1, 2, 3, 0, 1, 4, 3])
    found = finished(Path("m.obj"), Mesh(points, np.array([0, 4, 8]), faces), None)
    assert np.diff(found.offsets).tolist() == [4, 3, 3]
    assert found.corners[:4].tolist() == [0, 1, 4, 3]
    parts = points[found.corners[4:].reshape(-1, 3)]
    assert areas(parts).sum() == pytest.approx(8.0)


def test_normals_of_polygons_do_not_depend_on_their_first_corner() -> None:
    ring = np.array([[0, 0, 1], [3, 0, 1], [3, 3, 1], [2, 3, 1], [2, 1, 1], [0, 1, 1]], float)
    for first in range(len(ring)):
        found = area_vectors(np.roll(ring, first, axis=0), np.array([0, 6]), np.arange(6))
        assert found.tolist() == [[0, 0, 2 * 5.0]]


def test_large_polygons_of_a_small_file_are_divided_in_a_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "hole.obj").write_text(HOLE, encoding="utf-8")
    monkeypatch.setattr(reading, "SMALL_POLYGONS", 9)
    started: list[object] = []
    popen = subprocess.Popen

    def kept(*arguments: Any, **options: Any) -> subprocess.Popen[bytes]:
        started.append(arguments)
        return popen(*arguments, **options)

    monkeypatch.setattr(subprocess, "Popen", kept)
    assert len(reading.read(tmp_path / "hole.obj").offsets) - 1 == 8
    assert len(started) == 1
