"""Scenes: the built-in ones, meshes from real files of every format, bad files, first cameras."""

from __future__ import annotations

import json
import math
import os
import struct
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise, product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from hypothesis import given
from hypothesis import strategies as st

from app.model.projection import Camera, Perspective, Projection
from app.model.refusal import Cancelled, Refusal
from app.scenes import finishing
from app.scenes.mesh_files import PAINT_RGB
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import (
    BUILT_IN,
    ENDINGS,
    SUBJECT_SAMPLE,
    SUBJECT_TRIANGLES,
    Scene,
    frame_camera,
    load,
)
from app.scenes.shapes import brightness, distinct_rows
from tests.support.meshes import (
    PYRAMID,
    QUAD_AND_TRIANGLES,
    TRIANGLES,
    gltf_parts,
    obj_file,
    ply_file,
    ply_header,
    write_gltf,
)

SIDES = ("+x", "-x", "+y", "-y", "+z", "-z")


def world_points(scene: Scene) -> np.ndarray:
    assert scene.surface is not None
    return np.asarray(scene.surface.points, dtype=np.float64) + np.array(scene.origin)


def faces(scene: Scene) -> list[np.ndarray]:
    """World corners of every face, (k, 3) each."""
    assert scene.surface is not None
    points = world_points(scene)
    offsets = scene.surface.GetPolys().GetOffsetsArray()
    ends = [int(offsets.GetValue(i)) for i in range(scene.surface.n_cells + 1)]
    corners = np.asarray(scene.surface.GetPolys().cell_connectivity)
    return [points[corners[a:b]] for a, b in pairwise(ends)]


def rgb(scene: Scene) -> np.ndarray:
    assert scene.surface is not None
    colours = np.asarray(scene.surface.cell_data["rgb"])
    assert colours.dtype == np.uint8
    assert colours.shape == (scene.surface.n_cells, 3)
    return colours


def segments(scene: Scene) -> np.ndarray:
    """World ends of every line, (m, 2, 3)."""
    assert scene.lines is not None
    assert scene.lines.cell_data["rgb"].shape == (scene.lines.n_cells, 3)
    ends = np.asarray(scene.lines.points, dtype=np.float64) + np.array(scene.origin)
    return ends[np.asarray(scene.lines.GetLines().cell_connectivity).reshape(-1, 2)]


def side(face: np.ndarray) -> str:
    """The direction that an axis-parallel face looks to, from the order of its corners."""
    normal = np.cross(face[1] - face[0], face[2] - face[0])
    axis = int(abs(normal).argmax())
    return ("+" if normal[axis] > 0 else "-") + "xyz"[axis]


def outside(projection: Projection, points: Any) -> bool:
    return bool(projection.trace(np.asarray(points, dtype=np.float64)).outside.any())


# --------------------------------------------------------------------------- built-in scenes


def test_l22_letter_f_is_eight_unit_cubes_without_the_faces_between_them() -> None:
    f = load("letter-f")
    drawn = faces(f)
    # 8 cubes x 6 faces, less 2 for each of the 7 touching pairs (4 in the stem, 2 + 1 in the arms)
    assert len(drawn) == 8 * 6 - 2 * 7
    # Gauss: the volume inside a closed surface of outward faces is the sum of area * height / 3.
    volume = sum(
        face.mean(axis=0) @ np.cross(face[1] - face[0], face[3] - face[0]) for face in drawn
    )
    assert volume / 3.0 == pytest.approx(8.0)
    assert (f.lower, f.upper) == ((-1.5, 0.0, -0.5), (1.5, 5.0, 0.5))
    assert f.size == pytest.approx(math.sqrt(9 + 25 + 1))
    assert f.centre == (0.0, 2.5, 0.0)
    # Seen from the front: the columns of each row, from the ground up.
    front = {
        tuple(np.floor(face.mean(axis=0)[:2] + np.array([1.5, 0.0])))
        for face in drawn
        if side(face) == "+z"
    }
    assert front == {(0, 0), (0, 1), (0, 2), (1, 2), (0, 3), (0, 4), (1, 4), (2, 4)}


def test_letter_f_opens_as_the_default_document() -> None:
    assert load("letter-f").start == Projection(
        Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0), (0.0, 1.0, 0.0)),
        Perspective(45.0, 4.0, 18.0),
        (1280, 720),
    )


@pytest.mark.parametrize("name", ["letter-f", "cube"])
def test_each_side_of_the_cubes_has_one_colour_of_its_own(name: str) -> None:
    scene = load(name)
    of_side: dict[str, set[tuple[int, ...]]] = {name: set() for name in SIDES}
    for face, colour in zip(faces(scene), rgb(scene).tolist(), strict=True):
        of_side[side(face)].add(tuple(colour))
    assert all(len(colours) == 1 for colours in of_side.values())
    luminance = {
        name: float(np.dot(colours.pop(), (0.2126, 0.7152, 0.0722)))
        for name, colours in of_side.items()
    }
    # Never colour alone: the two sides of an axis differ in a grey picture too.
    for axis in "xyz":
        assert luminance["+" + axis] - luminance["-" + axis] > 25


def test_every_cube_of_the_letter_f_is_outlined() -> None:
    drawn = {tuple(sorted(map(tuple, ends))) for ends in segments(load("letter-f")).tolist()}
    for column, row in ((0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (1, 4), (2, 4), (1, 2)):
        x, y = column - 1.5, float(row)
        corners = [(x, y, 0.5), (x + 1, y, 0.5), (x + 1, y + 1, 0.5), (x, y + 1, 0.5)]
        for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
            assert tuple(sorted((a, b))) in drawn


def test_the_grid_lies_on_the_ground_and_its_axes_are_darker() -> None:
    f = load("letter-f")
    assert f.lines is not None
    ends, colours = segments(f), np.asarray(f.lines.cell_data["rgb"]).astype(int)
    grid = (ends[:, :, 1] == 0.0).all(axis=1) & (abs(ends).max(axis=(1, 2)) > 2.0)
    on_axis = grid & ((ends[:, :, 0] == 0.0).all(axis=1) | (ends[:, :, 2] == 0.0).all(axis=1))
    assert np.count_nonzero(on_axis) == 2
    assert colours[on_axis].max() < colours[grid & ~on_axis].min()
    ordinary = colours[grid & ~on_axis]
    assert (ordinary == ordinary[0]).all() and len(set(ordinary[0])) == 1  # grey


def test_the_cube_is_a_unit_cube_with_its_axes() -> None:
    cube = load("cube")
    assert np.subtract(cube.upper, cube.lower).tolist() == [1.0, 1.0, 1.0]
    assert cube.lower[1] == 0.0  # it stands on the ground
    assert cube.centre == (0.0, 0.5, 0.0)
    assert sorted(map(side, faces(cube))) == sorted(SIDES)
    from_origin = segments(cube)[(segments(cube)[:, 0] == 0.0).all(axis=1)]
    assert [tuple(np.sign(end)) for _, end in from_origin] == [(1, 0, 0), (0, 1, 0), (0, 0, 1)]


def test_posts_recede_at_equal_steps_and_are_numbered_on_geometry() -> None:
    posts = load("posts")
    written = [face for face in faces(posts) if side(face) == "+z" and np.ptp(face[:, 1]) < 0.8]
    z = sorted({float(face[0, 2].round(3)) for face in written}, reverse=True)
    assert len(z) == 20
    assert np.allclose(np.diff(z), np.diff(z)[0])
    for number in range(1, 21):
        mine = np.array([face for face in written if abs(face[0, 2] - z[number - 1]) < 1e-3])
        assert read_display(mine) == str(number)


# The usual code of a seven-segment display: bit 0 is the top, then clockwise, bit 6 the middle.
DISPLAY = {code: str(i) for i, code in enumerate(bytes.fromhex("3F065B4F666D7D077F6F"))}


def read_display(quads: np.ndarray) -> str:
    """Read seven-segment digits, (m, 4, 3), from the front: from -x to +x."""
    x, y = quads.mean(axis=1)[:, 0], quads.mean(axis=1)[:, 1]
    height, middle = 0.8, 2.05
    width, pitch = height / 2, 0.75 * height
    count = 1 if np.ptp(x) < width else 2
    text = ""
    for place in range(count):
        centre = (place - (count - 1) / 2) * pitch
        code = 0
        for right, up in zip((x - centre) / width, (y - middle) / height, strict=True):
            if abs(right) < 0.7:
                column, row = round(right / 0.4), round(up / 0.225)
                code |= 1 << {(0, 2): 0, (1, 1): 1, (1, -1): 2, (0, -2): 3, (-1, -1): 4,
                              (-1, 1): 5, (0, 0): 6}[column, row]  # fmt: skip
        text += DISPLAY[code]
    return text


CUT = ("view-volumes", "off-axis-window", "eye-plane", "far-plane-popping", "focus", "clipping")
"""Scenes about what is not seen: test points, cards and trees outside the view volume, a beam that
runs out of the window's side, a letter through the eye plane; and a row that begins before the
picture's edge, where what is too near is out of focus."""


@pytest.mark.parametrize("name", BUILT_IN)
def test_all_of_a_built_in_scene_is_in_view_when_it_opens(name: str) -> None:
    scene = load(name)
    assert scene.name == name
    points = world_points(scene)
    assert outside(scene.start, points) == (name in CUT)
    assert np.allclose(points.min(axis=0), scene.lower)
    assert np.allclose(points.max(axis=0), scene.upper)


def test_built_in_scenes_are_in_lecture_order() -> None:
    assert BUILT_IN[:4] == ("letter-f", "cube", "posts", "similar-triangles")
    assert BUILT_IN[3:] == tuple(PHENOMENA)


def test_a_scene_knows_its_phenomenon_and_its_subject() -> None:
    plain = load("letter-f")
    assert plain.phenomenon is None and plain.requires == frozenset()
    scene = load("similar-triangles")
    assert scene.phenomenon is PHENOMENA["similar-triangles"]
    assert scene.requires == scene.phenomenon.requires
    assert scene.start == scene.phenomenon.start
    subject = scene.subject
    assert (subject.lower, subject.upper) == (scene.lower, scene.upper)
    assert {tuple(p) for p in subject.points.tolist()} == {
        tuple(p) for p in world_points(scene).tolist()
    }
    grid = np.abs(segments(scene)).max()
    assert np.abs(subject.points).max() < grid  # without the ground
    large = replace(scene, surface=pv.PolyData(np.zeros((2 * SUBJECT_SAMPLE - 1, 3))))
    assert SUBJECT_SAMPLE / 2 <= len(large.subject.points) <= SUBJECT_SAMPLE


# --------------------------------------------------------------------------- files to read

# A square pyramid: one quad and four triangles, offset by 1e7 with steps of k/8, exact in float64
# and lost in float32, whose step at 1e7 is 1.
FAR = 1e7


def stl_text_file(path: Path, points: np.ndarray) -> None:
    text = "solid the vertex loop of a facet\n"
    for corners in points[TRIANGLES].tolist():
        rows = "".join(f"      vertex {x!r} {y!r} {z!r}\n" for x, y, z in corners)
        text += f"  facet normal 0 0 0\n    outer loop\n{rows}    endloop\n  endfacet\n"
    path.write_text(text + "endsolid the vertex loop of a facet\n")


def stl_file(path: Path, points: np.ndarray, header: bytes = b"solid but binary") -> None:
    data = header.ljust(80) + struct.pack("<I", len(TRIANGLES))
    for corners in points[TRIANGLES]:
        data += struct.pack("<12fH", 0, 0, 0, *corners.ravel(), 0)
    path.write_bytes(data)


def ply_text_file(path: Path, points: np.ndarray) -> None:
    text = ply_header("ascii", len(points), 5)
    text += "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
    text += "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in QUAD_AND_TRIANGLES)
    path.write_text(text)


def ply_big_endian_file(path: Path, points: np.ndarray) -> None:
    ply_file(path, points, ">")


def gltf_file(path: Path, points: np.ndarray) -> None:
    """Vertices near 0, carried to their place by the node: what float32 allows."""
    offset = points.min(axis=0).round()
    write_gltf(path, *gltf_parts(points - offset, offset.tolist()))


Writer = Callable[[Path, np.ndarray], None]
WRITERS: dict[str, tuple[str, Writer, int]] = {
    "obj": ("m.obj", obj_file, 5),
    "stl text": ("m.stl", stl_text_file, 6),
    "stl binary": ("m.stl", stl_file, 6),
    "ply text": ("m.ply", ply_text_file, 5),
    "ply binary": ("m.ply", ply_file, 5),
    "ply big-endian": ("m.ply", ply_big_endian_file, 5),
    "gltf": ("m.gltf", gltf_file, 6),
    "glb": ("m.glb", gltf_file, 6),
}


def pyramid_file(folder: Path, kind: str, offset: float = 0.0) -> Path:
    name, write, _ = WRITERS[kind]
    write(folder / name, PYRAMID + offset)
    return folder / name


def test_every_ending_is_tested() -> None:
    assert {Path(name).suffix for name, _, _ in WRITERS.values()} == set(ENDINGS)


@pytest.mark.parametrize("kind", WRITERS)
def test_a_mesh_of_every_format_is_read(kind: str, tmp_path: Path) -> None:
    path = pyramid_file(tmp_path, kind)
    scene = load(str(path))
    assert scene.name == str(path)
    assert scene.lower == tuple(PYRAMID.min(axis=0))
    assert scene.upper == tuple(PYRAMID.max(axis=0))
    drawn = faces(scene)
    assert len(drawn) == WRITERS[kind][2]
    assert len(rgb(scene)) == len(drawn)
    expected = {tuple(point) for point in PYRAMID.tolist()}
    assert {tuple(point) for face in drawn for point in face.tolist()} == expected
    assert scene.surface is not None
    assert scene.surface.points.dtype == np.float64
    assert not outside(scene.start, world_points(scene))


@pytest.mark.parametrize("kind", [kind for kind in WRITERS if kind != "stl binary"])
def test_a_mesh_at_1e7_keeps_its_vertices(kind: str, tmp_path: Path) -> None:
    """Binary STL is left out: the format itself has float32 coordinates."""
    scene = load(str(pyramid_file(tmp_path, kind, FAR)))
    points = np.unique(world_points(scene), axis=0)
    expected = np.unique(PYRAMID + FAR, axis=0)
    assert points.shape == expected.shape
    assert (points == expected).all()
    assert scene.lower == tuple(expected.min(axis=0))
    assert scene.surface is not None  # what the GPU gets is small numbers
    assert abs(scene.surface.points).max() <= scene.size
    assert not outside(scene.start, points)


@pytest.mark.parametrize("kind", WRITERS)
def test_a_mesh_takes_the_place_of_a_phenomenons_subject(kind: str, tmp_path: Path) -> None:
    built_in = load("similar-triangles")
    path = pyramid_file(tmp_path, kind, 64.0)
    scene = load("similar-triangles", mesh=str(path))
    assert scene.name == "similar-triangles" and scene.phenomenon is built_in.phenomenon
    assert scene.start == built_in.start
    points = np.unique(world_points(scene).round(5), axis=0)
    # Scaled alike in all directions, as large as the depth of 1 allows, and moved.
    offset, scale = np.unique(PYRAMID, axis=0), 1.0 / (3.125 - 0.25)
    expected = (offset - PYRAMID.min(axis=0)) * scale
    assert len(points) == 5
    assert np.allclose(np.ptp(points, axis=0), np.ptp(expected, axis=0), atol=1e-5)
    assert min(np.subtract(built_in.upper, built_in.lower) - np.ptp(points, axis=0)) > -1e-5
    middle = (points.min(axis=0) + points.max(axis=0)) / 2.0
    assert points[:, 1].min() == pytest.approx(built_in.lower[1])  # it stands where that stood
    assert np.allclose(middle[[0, 2]], np.array(built_in.centre)[[0, 2]], atol=1e-5)
    assert np.allclose(scene.lower, points.min(axis=0), atol=1e-5)
    assert np.allclose(scene.subject.points.max(axis=0), scene.upper, atol=1e-5)
    # The ground of the scene stays, its edges do not.
    lines = segments(built_in)
    ground = {
        tuple(map(tuple, ends)) for ends in lines[np.ptp(lines, axis=1).max(axis=1) > 5.0].tolist()
    }
    drawn = {tuple(map(tuple, ends)) for ends in segments(scene).tolist()}
    assert len(ground) > 20 and ground <= drawn
    assert len(drawn - ground) >= 5
    assert not outside(scene.start, world_points(scene))


@pytest.mark.parametrize(
    ("sides", "is_seen"),
    [
        ((1.0, 1.0, 1.0), True),
        ((4.0, 1.0, 4.0), True),
        ((2.0, 3.0, 1.0), True),
        ((1.0, 1.0, 16.0), False),
        ((7.0, 0.0, 7.0), True),
    ],
)
def test_a_mesh_in_the_scene_of_the_eye_plane_goes_through_it(
    sides: tuple[float, float, float], is_seen: bool, tmp_path: Path
) -> None:
    path = tmp_path / "box.ply"
    x, y, z = sides
    box = pv.Box((5.0, 5.0 + x, 7.0, 7.0 + y, -2.0, z - 2.0)).triangulate().subdivide(3)
    box.save(path)
    scene = load("eye-plane", mesh=str(path))
    trace = scene.start.trace(world_points(scene))
    assert (trace.clip[:, 3] > 0.0).any() and (trace.clip[:, 3] < 0.0).any()
    assert (~trace.outside.any(axis=1)).any() == is_seen
    size = np.subtract(scene.upper, scene.lower)
    assert size.max() <= 20.0 and np.allclose(size / size.max(), np.array(sides) / max(sides))


@pytest.mark.parametrize("kind", WRITERS)
def test_a_mesh_in_a_phenomenon_has_its_edges_once(kind: str, tmp_path: Path) -> None:
    """Also where the file repeats a vertex for every face."""
    assert load("eye-plane").subject.mesh is None
    scene = load("eye-plane", mesh=str(pyramid_file(tmp_path, kind, 64.0)))
    assert "subject" in vars(scene), "found while progress is shown, not by the first drawing"
    mesh = scene.subject.mesh
    assert mesh is not None and not mesh.more_triangles
    assert mesh.edge_count == len(mesh.edges)
    ends = {frozenset(map(tuple, edge)) for edge in mesh.edges.round(4).tolist()}
    assert len(ends) == len(mesh.edges)
    lengths = np.linalg.norm(mesh.edges[:, 1] - mesh.edges[:, 0], axis=1)
    assert (np.diff(lengths) <= 0.0).all()
    sides = mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2, 3)
    assert ends <= {frozenset(map(tuple, edge)) for edge in sides.round(4).tolist()}
    assert len(ends) in (8, 9)  # the base may be one face or two


def test_a_large_mesh_in_a_phenomenon_has_its_longest_edges(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.scenes.scene.SUBJECT_EDGES", 200)
    random = np.random.default_rng(2)
    points = random.normal(size=(900, 3))
    lines = [f"v {x} {y} {z}" for x, y, z in points.tolist()]
    faces = np.stack([np.arange(1, 899), np.arange(2, 900), np.arange(3, 901)], axis=1)
    faces = np.concatenate([faces, random.permuted(faces, axis=0)])
    faces = faces[[len(set(face)) == 3 for face in faces.tolist()]]
    path = tmp_path / "many.obj"
    path.write_text("\n".join(lines + [f"f {a} {b} {c}" for a, b, c in faces.tolist()]))
    mesh = load("affine-depth", mesh=str(path)).subject.mesh
    assert mesh is not None and mesh.more_triangles
    assert len(mesh.edges) == 200 and len(mesh.triangles) == SUBJECT_TRIANGLES
    pairs = {tuple(sorted(pair)) for a, b, c in faces.tolist() for pair in ((a, b), (b, c), (c, a))}
    all_lengths = sorted((float(np.linalg.norm(points[a - 1] - points[b - 1])) for a, b in pairs),
                         reverse=True)  # fmt: skip
    assert mesh.edge_count == len(pairs)
    found = np.linalg.norm(mesh.edges[:, 1] - mesh.edges[:, 0], axis=1)
    expected = np.array(all_lengths[:200])
    assert np.allclose(found / found[0], expected / expected[0], rtol=1e-4)
    sides = mesh.triangles - np.roll(mesh.triangles, 1, axis=1)
    longest = np.linalg.norm(sides, axis=2).max(axis=1)
    assert (np.diff(longest) <= 0.0).all() and np.isclose(longest[0], found[0])


def test_a_mesh_of_points_in_a_phenomenon_has_an_edge(tmp_path: Path) -> None:
    """Each face is at one place, but not at the same."""
    path = tmp_path / "points.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 1 1\nf 2 2 2\nf 3 3 3\n")
    for name in ("interpolation", "affine-depth", "eye-plane"):
        scene = load(name, mesh=str(path))
        mesh, phenomenon = scene.subject.mesh, scene.phenomenon
        assert mesh is not None and mesh.edges.shape == (1, 2, 3)
        assert phenomenon is not None
        phenomenon.illustration(scene.start, phenomenon.checked({}), scene.subject)


def test_a_flat_mesh_and_one_of_another_scale_stand_there_too(tmp_path: Path) -> None:
    built_in = load("similar-triangles")
    for number, points in enumerate(
        (PYRAMID * (1.0, 0.0, 1.0), PYRAMID * (0.0, 1.0, 1.0), PYRAMID * 1e20, PYRAMID * 1e-20)
    ):
        path = tmp_path / f"{number}.obj"
        obj_file(path, points)
        scene = load("similar-triangles", mesh=str(path))
        room, taken = (np.subtract(s.upper, s.lower) for s in (built_in, scene))
        assert (taken <= room + 1e-5).all()
        assert np.isclose(taken, room, atol=1e-5).any()
        assert scene.lower[1] == pytest.approx(built_in.lower[1])


def test_a_mesh_that_no_scene_can_take_is_refused(tmp_path: Path) -> None:
    path = str(pyramid_file(tmp_path, "obj"))
    with pytest.raises(Refusal) as caught:
        load("cube", mesh=path)
    assert str(caught.value) == (
        f"mesh = {path}: the scene “cube” has a subject of its own, no mesh can take its place."
    )
    for wrong in (str(tmp_path / "m.xyz"), str(tmp_path / "none.obj")):
        with pytest.raises(Refusal, match="no such file"):
            load("similar-triangles", mesh=wrong)
    (tmp_path / "m.txt").write_text("hello")
    with pytest.raises(Refusal, match="must end in"):
        load("similar-triangles", mesh=str(tmp_path / "m.txt"))
    fractions: list[float] = []
    load("similar-triangles", lambda f: fractions.append(f) is None, mesh=path)
    assert fractions == sorted(fractions) and fractions[-1] == 1.0
    with pytest.raises(Cancelled):
        load("similar-triangles", lambda _: False, mesh=path)


def test_decimals_are_read_to_the_last_bit(tmp_path: Path) -> None:
    """0.1 + 1e7 is not a sum of powers of 2: only correct rounding of the text finds it."""
    points = np.random.default_rng(4).normal(size=(5, 3)) * 1e7
    for kind in ("obj", "ply text", "stl text"):
        name, write, _ = WRITERS[kind]
        write(tmp_path / name, points)
        scene = load(str(tmp_path / name))
        assert scene.lower == tuple(points.min(axis=0))
        assert scene.upper == tuple(points.max(axis=0))


def test_gltf_nodes_are_applied_in_float64(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID, [FAR + 0.125, -2.0, 5.0], scale=2.0)
    write_gltf(tmp_path / "m.glb", content, body)
    scene = load(str(tmp_path / "m.glb"))
    expected = 2.0 * PYRAMID + (FAR + 0.125, -2.0, 5.0)
    assert (np.unique(world_points(scene), axis=0) == np.unique(expected, axis=0)).all()


QUARTER_TURN_ABOUT_Y = [0.0, math.sqrt(0.5), 0.0, math.sqrt(0.5)]


@pytest.mark.parametrize(
    ("node", "expected"),
    [
        # z goes to x, x to -z
        ({"rotation": QUARTER_TURN_ABOUT_Y}, [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
        # of another length than 1
        ({"rotation": [0, 3.0, 0, 3.0]}, [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
        # scaled first, then turned
        (
            {"rotation": QUARTER_TURN_ABOUT_Y, "scale": [2, 3, 4]},
            [[0, 0, 4], [0, 3, 0], [-2, 0, 0]],
        ),
        # column by column: x goes to (0, 5, 0)
        (
            {"matrix": [0, 5, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
            [[0, 1, 0], [5, 0, 0], [0, 0, 1]],
        ),
    ],
)
def test_gltf_nodes_turn_and_scale(
    node: dict[str, Any], expected: list[list[float]], tmp_path: Path
) -> None:
    content, body = gltf_parts(PYRAMID)
    content["nodes"][1] = {"mesh": 0, **node}
    write_gltf(tmp_path / "m.glb", content, body)
    scene = load(str(tmp_path / "m.glb"))
    turned = PYRAMID @ np.array(expected).T
    assert np.allclose(scene.lower, turned.min(axis=0))
    assert np.allclose(scene.upper, turned.max(axis=0))


@pytest.mark.parametrize("rotation", [[0, 0, 0, 0], [0, 0, 1e308, 1e308]])
def test_a_gltf_rotation_of_no_direction_is_refused(rotation: Any, tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["nodes"][1] = {"mesh": 0, "rotation": rotation}
    write_gltf(tmp_path / "m.glb", content, body)
    with pytest.raises(Refusal, match=r"m\.glb: its glTF description is not valid"):
        load(str(tmp_path / "m.glb"))


def test_a_translation_beyond_all_bounds_is_refused_with_the_file(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID, translation=[-1e308, 0, 0])
    write_gltf(tmp_path / "m.glb", content, body)
    with pytest.raises(Refusal, match=r"m\.glb: a vertex has the coordinate -1e\+308"):
        load(str(tmp_path / "m.glb"))


@pytest.mark.parametrize("place", [1e-3, 1.0, 9e5, 4e11])
def test_a_mesh_within_the_bounds_of_its_coordinates_is_in_view(
    place: float, tmp_path: Path
) -> None:
    (tmp_path / "m.obj").write_text(
        f"v {place} 0 0\nv {place} 1 0\nv {place} 0 1\nf 1 2 3\n", encoding="utf-8"
    )
    scene = load(str(tmp_path / "m.obj"))
    assert not outside(scene.start, world_points(scene))


@pytest.mark.parametrize("other", ["", "f 1 2 4\n"])
def test_a_polygon_that_repeats_itself_is_drawn_as_a_fan(other: str, tmp_path: Path) -> None:
    """VTK finds no triangles in it, and would leave it out."""
    corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 2 2\n"
    (tmp_path / "m.obj").write_text(f"{corners}f 1 2 3 1 2 3\n{other}", encoding="utf-8")
    scene = load(str(tmp_path / "m.obj"))
    assert scene.surface is not None
    triangles = scene.surface.triangulate()
    # The triangle twice, and the other one.
    assert triangles.area == pytest.approx(1.0 + (math.sqrt(2.0) if other else 0.0))
    assert len(rgb(scene)) == scene.surface.n_cells == 4 + bool(other)


def test_faces_of_every_number_of_corners_keep_light_and_triangles(tmp_path: Path) -> None:
    """A polygon is as bright as the same place in triangles, at once in thousands of sizes."""
    turn = np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)
    ring = np.stack([np.cos(turn), 0.2 * turn, np.sin(turn)], axis=1)
    lines = [f"v {x} {y} {z}" for x, y, z in ring.tolist()]
    faces_of = [f"f {' '.join(map(str, range(1, count + 1)))}" for count in range(3, 61)]
    (tmp_path / "m.obj").write_text("\n".join([*lines, *faces_of]), encoding="utf-8")
    shades = rgb(load(str(tmp_path / "m.obj")))
    owners = [3, 4, *(count for count in range(5, 61) for _ in range(count - 2))]
    for count, shade in zip(owners, shades, strict=True):
        fan = np.array([(0, k, k + 1) for k in range(1, count - 1)])
        area = np.cross(ring[fan[:, 1]] - ring[0], ring[fan[:, 2]] - ring[0]).sum(axis=0)
        expected = np.array(PAINT_RGB) * brightness((area / np.linalg.norm(area))[None])
        assert np.abs(shade.astype(float) - expected).max() <= 1.0


def test_a_mirrored_gltf_node_keeps_its_faces_looking_outward(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["nodes"][1]["scale"] = [-1, 1, 1]
    write_gltf(tmp_path / "m.glb", content, body)
    drawn = faces(load(str(tmp_path / "m.glb")))
    inside = np.mean([face.mean(axis=0) for face in drawn], axis=0)
    for face in drawn:
        normal = np.cross(face[1] - face[0], face[2] - face[0])
        assert normal @ (face[0] - inside) > 0.0


def test_gltf_without_a_scene_shows_all_its_nodes_once(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID, [1, 2, 3])
    del content["scene"], content["scenes"]
    write_gltf(tmp_path / "m.glb", content, body)
    scene = load(str(tmp_path / "m.glb"))
    assert len(faces(scene)) == 6
    assert scene.lower == (1.125, 2.0, 3.25)


def test_gltf_with_its_data_in_a_file_beside_it(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["buffers"][0]["uri"] = "the%20data.bin"
    content["images"] = [{"uri": "missing.png"}]  # pictures are not drawn, nor missed
    (tmp_path / "the data.bin").write_bytes(body)
    (tmp_path / "m.gltf").write_text(json.dumps(content))
    assert load(str(tmp_path / "m.gltf")).upper == tuple(PYRAMID.max(axis=0))


def test_gltf_meshes_of_several_nodes_are_joined(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["nodes"].append({"mesh": 0, "translation": [10, 0, 0]})
    content["scenes"][0]["nodes"].append(2)
    write_gltf(tmp_path / "m.gltf", content, body)
    scene = load(str(tmp_path / "m.gltf"))
    assert len(faces(scene)) == 12
    assert (scene.lower[0], scene.upper[0]) == (0.125, 3.25 + 10.0)


def test_gltf_triangle_strips_are_drawn(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    del content["meshes"][0]["primitives"][0]["indices"]
    content["meshes"][0]["primitives"][0]["mode"] = 5
    write_gltf(tmp_path / "m.gltf", content, body)
    drawn = faces(load(str(tmp_path / "m.gltf")))
    # a strip 0 1 2 3 4 is 012, 132, 234: every other one begins with its last two swapped
    assert (np.array(drawn) == PYRAMID[[[0, 1, 2], [1, 3, 2], [2, 3, 4]]]).all()


def test_obj_with_normals_and_textures_has_the_edges_of_the_bare_mesh(tmp_path: Path) -> None:
    """Such vertices are repeated; unless they are merged, every edge looks like a border."""
    flat = tmp_path / "flat.obj"
    rows = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 1\nvn 0 1 0\nvn 0 -1 0\n"
    flat.write_text(rows + "f 1/1/1 2/1/1 3/1/1\nf 1/2/2 3/2/2 4/2/2\n")
    scene = load(str(flat))
    ends = segments(scene)
    edges = ends[
        (abs(ends - 0.5).max(axis=2) <= 0.5).all(axis=1) & (np.ptp(ends, axis=1).max(axis=1) > 0.9)
    ]
    diagonal = [
        pair for pair in edges.tolist() if pair[0][0] != pair[1][0] and pair[0][2] != pair[1][2]
    ]
    assert diagonal == []


def test_edges_of_small_meshes_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = str(pyramid_file(tmp_path, "stl text"))
    edges = [ends for ends in segments(load(path)).tolist() if PYRAMID[4].tolist() in ends]
    assert len(edges) == 4
    monkeypatch.setattr(finishing, "FACES_WITH_EDGES", 5)
    assert not (segments(load(path)) == PYRAMID[4]).all(axis=2).any()


def test_the_grid_is_under_a_mesh_at_round_places(tmp_path: Path) -> None:
    scene = load(str(pyramid_file(tmp_path, "ply text", FAR)))
    ends = segments(scene)
    grid = ends[
        (ends[:, :, 1] == scene.lower[1]).all(axis=1)
        & (np.ptp(ends, axis=1).max(axis=1) > scene.size)
    ]
    x = np.unique(grid[grid[:, 0, 0] == grid[:, 1, 0]][:, 0, 0])
    spacing = np.diff(x)
    assert (spacing == 0.5).all()  # the size is 5.0: an eighth of it is 0.63
    assert (x / spacing[0] % 1.0 == 0.0).all()
    assert x.min() <= scene.lower[0] - spacing[0]
    assert x.max() >= scene.upper[0] + spacing[0]
    assert len(x) < 50


# --------------------------------------------------------------------------- colours of meshes


def ply_of_two(
    tmp_path: Path, vertex_rgb: str, rows: list[str], face_rgb: str = "", faces: str = ""
) -> Scene:
    """Two triangles on four vertices, with colours at the vertices or at the faces."""
    path = tmp_path / "colours.ply"
    xyz = ["0 0 0", "1 0 0", "0 1 0", "1 1 0"]
    body = "".join(f"{p} {row}\n" for p, row in zip(xyz, rows, strict=True))
    path.write_text(
        ply_header("ascii", 4, 2, vertex_rgb, face_rgb) + body + (faces or "3 0 1 2\n3 1 3 2\n")
    )
    return load(str(path))


def channels(kind: str) -> str:
    return "".join(f"property {kind} {channel}\n" for channel in ("red", "green", "blue"))


@pytest.mark.parametrize(("kind", "full"), [("uchar", 255), ("float", 1.0), ("ushort", 65535)])
def test_ply_vertex_colours_are_kept(kind: str, full: float, tmp_path: Path) -> None:
    red, green = f"{full} 0 0", f"0 {full} 0"
    scene = ply_of_two(tmp_path, channels(kind), [red, red, red, green])
    assert rgb(scene).tolist() == [[255, 0, 0], [170, 85, 0]]


def test_ply_colours_that_are_no_numbers_are_black(tmp_path: Path) -> None:
    scene = ply_of_two(tmp_path, channels("float"), ["1 0 0", "1 0 nan", "1 0 0", "0 0 inf"])
    assert rgb(scene)[0].tolist() == [255, 0, 0]


def test_ply_face_colours_are_kept(tmp_path: Path) -> None:
    scene = ply_of_two(
        tmp_path, "", [""] * 4, channels("uchar"), "3 0 1 2 9 8 7\n3 1 3 2 60 70 80\n"
    )
    assert rgb(scene).tolist() == [[9, 8, 7], [60, 70, 80]]


def test_ply_colours_of_faces_of_mixed_sizes_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "m.ply"
    header = ply_header("binary_little_endian", 5, 2, "", channels("uchar")).encode()
    body = PYRAMID.astype("<f8").tobytes()
    body += struct.pack("<B4i3B", 4, 0, 1, 2, 3, 11, 12, 13) + struct.pack(
        "<B3i3B", 3, 0, 4, 1, 21, 22, 23
    )
    path.write_bytes(header + body)
    scene = load(str(path))
    assert rgb(scene).tolist() == [[11, 12, 13], [21, 22, 23]]
    assert [len(face) for face in faces(scene)] == [4, 3]


def test_one_colour_for_the_whole_mesh_is_lit_so_that_its_shape_is_seen(tmp_path: Path) -> None:
    path = tmp_path / "m.obj"
    obj_file(path, PYRAMID)
    text = "".join(
        f"{row} 1 0.5 0\n" if row.startswith("v ") else row + "\n"
        for row in path.read_text().splitlines()
    )
    path.write_text(text)
    colours = rgb(load(str(path))).astype(float)
    assert len(np.unique(colours[1:], axis=0)) == 4
    assert np.allclose(colours[:, 1] / colours[:, 0], 127 / 255, atol=0.02)  # the hue stays
    assert (colours[:, 2] == 0).all()


def test_gltf_material_is_the_paint_and_converted_from_linear_light(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [1.0, 0.2140, 0.0, 1.0]}}]
    content["meshes"][0]["primitives"][0]["material"] = 0
    write_gltf(tmp_path / "m.glb", content, body)
    colours = rgb(load(str(tmp_path / "m.glb"))).astype(float)
    # linear 0.2140 is half of the sRGB scale
    assert np.allclose(colours[:, 1] / colours[:, 0], 0.5, atol=0.02)
    assert len(np.unique(colours, axis=0)) > 3


def test_gltf_vertex_colours_are_kept(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    colours = np.zeros((5, 3), dtype="<f4")
    colours[[0, 4, 1], 2] = 1.0  # the first triangle is blue
    body += b"\0" * (-len(body) % 4)
    content["bufferViews"].append(
        {"buffer": 0, "byteOffset": len(body), "byteLength": colours.nbytes}
    )
    content["accessors"].append(
        {"bufferView": 2, "componentType": 5126, "count": 5, "type": "VEC3"}
    )
    content["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 2
    content["buffers"][0]["byteLength"] = len(body) + colours.nbytes
    write_gltf(tmp_path / "m.glb", content, body + colours.tobytes())
    assert rgb(load(str(tmp_path / "m.glb"))).tolist()[:2] == [[0, 0, 255], [0, 0, 170]]


def test_light_comes_from_above_and_in_front(tmp_path: Path) -> None:
    """A cube of quads: its top is the lightest side, its bottom the darkest, no two alike."""
    path = tmp_path / "box.obj"
    rows = [f"v {x} {y} {z}" for x, y, z in product((0, 1), repeat=3)]
    quads = ["5 7 8 6", "1 2 4 3", "3 4 8 7", "1 5 6 2", "2 6 8 4", "1 3 7 5"]
    path.write_text("\n".join([*rows, *(f"f {quad}" for quad in quads)]))
    scene = load(str(path))
    of_side = {side(f): c for f, c in zip(faces(scene), rgb(scene).mean(axis=1), strict=True)}
    darkest_first = sorted(of_side, key=lambda name: of_side[name])
    assert darkest_first[0] == "-y"
    assert darkest_first[-2:] == ["+z", "+y"]
    assert np.diff(sorted(of_side.values())).min() >= 3.0


def test_shading_is_that_of_world_space_at_any_scale_and_place(tmp_path: Path) -> None:
    """Also where the cross product of two edges in float32 would leave its range or digits."""
    wanted = rgb(load(str(pyramid_file(tmp_path, "obj"))))
    assert len(np.unique(wanted, axis=0)) == 5
    brightness = wanted.mean(axis=1)
    assert brightness[1:].max() > 100  # a lit side
    assert brightness.min() > 40  # and none black
    for scale, offset in ((1.0, FAR), (1e-20, 0.0), (1e20, 0.0)):
        obj_file(tmp_path / "m.obj", PYRAMID * scale + offset)
        assert abs(rgb(load(str(tmp_path / "m.obj"))).astype(int) - wanted).max() <= 1


# --------------------------------------------------------------------------- odd but sound meshes


def test_a_flat_mesh_opens(tmp_path: Path) -> None:
    flat = PYRAMID * (1.0, 0.0, 1.0)
    obj_file(tmp_path / "flat.obj", flat)
    scene = load(str(tmp_path / "flat.obj"))
    assert scene.size > 4.0
    assert scene.lower[1] == scene.upper[1]
    assert not outside(scene.start, world_points(scene))


def test_vertices_of_no_face_do_not_count(tmp_path: Path) -> None:
    obj_file(tmp_path / "m.obj", np.concatenate([[[1e6, 1e6, 1e6]], PYRAMID]))
    path = tmp_path / "m.obj"
    path.write_text("v 1e6 1e6 1e6\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\n")
    scene = load(str(path))
    assert scene.upper == (1.0, 1.0, 0.0)
    assert scene.surface is not None
    assert scene.surface.n_points == 3


def test_copied_corners_of_stl_become_one_vertex(tmp_path: Path) -> None:
    for write in (stl_text_file, stl_file):
        write(tmp_path / "m.stl", PYRAMID)
        surface = load(str(tmp_path / "m.stl")).surface
        assert surface is not None
        assert surface.n_points == 5


def test_binary_stl_with_bytes_after_its_triangles_opens(tmp_path: Path) -> None:
    stl_file(tmp_path / "m.stl", PYRAMID, b"made by a test")
    with (tmp_path / "m.stl").open("ab") as file:
        file.write(b"more")
    assert len(faces(load(str(tmp_path / "m.stl")))) == 6


def test_text_stl_larger_than_a_block_is_read_across_the_seams(tmp_path: Path) -> None:
    path = tmp_path / "big.stl"
    stl_text_file(path, PYRAMID)
    lines = path.read_text().splitlines(keepends=True)
    path.write_text(lines[0] + "".join(lines[1:-1]) * 22_000 + lines[-1])  # two blocks of 16 MiB
    assert path.stat().st_size > 1 << 24
    scene = load(str(path))
    assert scene.surface is not None
    assert (scene.surface.n_cells, scene.surface.n_points) == (6 * 22_000, 5)


def test_endings_may_be_in_capitals(tmp_path: Path) -> None:
    obj_file(tmp_path / "M.OBJ", PYRAMID)
    assert len(faces(load(str(tmp_path / "M.OBJ")))) == 5


def test_a_file_name_may_have_any_letters(tmp_path: Path) -> None:
    for ending, write in ((".obj", obj_file), (".glb", gltf_file)):
        path = tmp_path / f"ćevapčići õun{ending}"
        write(path, PYRAMID)
        assert load(str(path)).name == str(path)


# --------------------------------------------------------------------------- progress


@pytest.mark.parametrize("kind", WRITERS)
def test_progress_rises_from_0_to_1(kind: str, tmp_path: Path) -> None:
    path = str(pyramid_file(tmp_path, kind))
    seen: list[float] = []

    def keep(fraction: float) -> bool:
        seen.append(fraction)
        return True

    load(path, keep)
    assert seen[0] == 0.0
    assert seen[-1] == 1.0
    assert seen == sorted(seen)
    assert len(set(seen)) >= 4
    for stop_at in range(len(seen)):
        answers = iter([True] * stop_at + [False])
        with pytest.raises(Cancelled):
            load(path, lambda fraction, answers=answers: next(answers))


# --------------------------------------------------------------------------- bad input


def cut(data: bytes, count: int) -> bytes:
    return data[:-count]


def bad_files(folder: Path) -> Iterator[tuple[str, str]]:
    """Name of a bad file, and what the sentence about it must say."""
    facet = "solid\nfacet normal\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    texts = {
        "prose.stl": ("Dear all, the mesh is attached.\n" * 9, "not an STL file"),
        "solid.stl": ("solid advice: this is no mesh.\n", "no faces"),
        "half.stl": ("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0", "cut off"),
        "word.stl": (
            facet.replace("0 0 0", "0 0 o"),
            "three numbers",
        ),
        "prose.ply": ("Dear all\n", "not a PLY file"),
        "header.ply": ("ply\nformat ascii 1.0\nelement vertex 3\n", "end_header"),
        "format.ply": ("ply\nformat ascii2 1.0\nelement vertex 0\nend_header\n", "header"),
        "novertex.ply": ("ply\nformat ascii 1.0\nelement face 0\nend_header\n", "header"),
        "noxyz.ply": (
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
            "no x, y, z",
        ),
        "word.ply": (ply_header("ascii", 1, 0) + "0 zero 0\n", "not a number"),
        "short.ply": (
            ply_header("ascii", 3, 1) + "0 0 0\n1 0 0\n",
            "cut off before the last of its 3 vertex",
        ),
        "shortface.ply": (
            ply_header("ascii", 3, 2) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0",
            "last of its 2 face",
        ),
        "index.ply": (
            ply_header("ascii", 3, 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n",
            "does not exist",
        ),
        "nanindex.ply": (
            ply_header("ascii", 3, 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 nan\n",
            "does not exist",
        ),
        "two.ply": (
            ply_header("ascii", 3, 1) + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n",
            "1 face of 1 has fewer",
        ),
        "points.ply": (ply_header("ascii", 1, 0) + "0 0 0\n", "no faces (one vertex)"),
        "prose.obj": ("Dear all\n", "no faces"),
        "points.obj": ("v 0 0 0\nv 1 1 1\n", "no faces (2 vertices)"),
        "lines.obj": ("v 0 0 0\nv 1 1 1\nl 1 2\n", "no faces"),
        "one.obj": ("v 0 0 0\n", "no faces (one vertex)"),
        "same.obj": ("v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n", "at one point"),
        "onecorner.obj": ("v 1 2 3\nf 1 1 1\n", "at one point"),
        "line.obj": ("v 1 2 3\nv 1 2 4\nv 1 2 7\nf 1 2 3\n", "on one line"),
        "slant.obj": ("v .1 .2 .3\nv .2 .4 .6\nv .7 1.4 2.1\nf 1 2 3\n", "on one line"),
        "index.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "does not exist"),
        "zero.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "does not exist"),
        "half.obj": ("v 0 0 0\nv 1 0", "line 2 cannot be read as OBJ"),
        "word.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 x\nf 1 2 3\n", "line 3 cannot be read as OBJ"),
        "corner.obj": ("v 1 2 3\nf 1 1 /1\n", "line 2 cannot be read as OBJ"),
        "letter.obj": ("v 1 2 3\nf 1 1 a\n", "line 2 cannot be read as OBJ"),
        "nan.obj": ("v nan 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", "2 vertices of 3 are not finite"),
        "nan.ply": (
            ply_header("ascii", 3, 1) + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n",
            "1 vertex of 3 is not finite",
        ),
        "nan.stl": (
            facet.replace("0 0 0", "0 0 nan"),
            "1 vertex of 3 is not finite",
        ),
        "huge.obj": ("v 1e40 0 0\nv -1e308 0 0\nv 0 1e308 0\nf 1 2 3\n", "between 1e-30 and 1e30"),
        "loop.stl": (2 * facet.replace("outer loop", "outer lop", 1), "three vertices of three"),
        "away.obj": ("v 1e150 0 0\nv 1e150 1 0\nv 1e150 0 1\nf 1 2 3\n", "the coordinate 1e+150"),
        "end.obj": ("v -1e308 0 0\nv -1e308 1 0\nv -1e308 0 1\nf 1 2 3\n", "within ±1e+12"),
        "face.obj": (
            "".join(f"v {n} {n % 7} 0\n" for n in range(1001))
            + f"f {' '.join(map(str, range(1, 1002)))}\n",
            "a face has 1001 corners, and at most 1000 are drawn",
        ),
        "tiny.obj": ("v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n", "between 1e-30 and 1e30"),
        "prose.gltf": ("Dear all\n", "JSON part, which describes the mesh, is damaged in line 1;"),
        "comma.gltf": ('{"asset":\n{"version": "2.0"},\n,}', "is damaged in line 3;"),
        "latin.gltf": ('{"asset": "caf\udce9"}', "which describes the mesh, is damaged;"),
        "prose.glb": ("Dear all\n", "not a GLB file"),
        "list.gltf": ("[]", "its glTF description is not valid;"),
        "deep.gltf": ("[" * 100_000, "which describes the mesh, is damaged;"),
        "empty.gltf": ("{}", "its glTF description lacks “asset”;"),
    }
    for name, (text, expected) in texts.items():
        (folder / name).write_bytes(text.encode(errors="surrogateescape"))
        yield name, expected
    for ending in ENDINGS:
        (folder / f"empty{ending}x").with_suffix(ending).write_bytes(b"")
        yield f"empty{ending}", "the file is empty"
        (folder / f"folder{ending}").mkdir()
        yield f"folder{ending}", "is a folder"
        yield f"missing{ending}", "no such file"

    stl_file(folder / "cut.stl", PYRAMID, b"made by a test")
    (folder / "cut.stl").write_bytes(cut((folder / "cut.stl").read_bytes(), 51))
    yield "cut.stl", "cut off after 4 of 6 triangles"
    for count in (1, 13, 14, 30):
        ply_file(folder / f"cut{count}.ply", PYRAMID)
        (folder / f"cut{count}.ply").write_bytes(
            cut((folder / f"cut{count}.ply").read_bytes(), count)
        )
        yield f"cut{count}.ply", "cut off before the last of its 5 face"

    gltf_file(folder / "cut.glb", PYRAMID)
    (folder / "cut.glb").write_bytes(cut((folder / "cut.glb").read_bytes(), 20))
    yield "cut.glb", "cut off after"
    whole = folder / "text.glb"
    gltf_file(whole, PYRAMID)
    whole.write_bytes(whole.read_bytes().replace(b'"asset"', b'"asset\n'))
    yield "text.glb", "its JSON part, which describes the mesh, is damaged;"
    content, body = gltf_parts(PYRAMID)
    del content["accessors"][0]["componentType"]
    write_gltf(folder / "kind.gltf", content, body)
    yield "kind.gltf", "its glTF description lacks “componentType”;"
    content, body = gltf_parts(PYRAMID)
    content["accessors"][0]["type"] = "MAT4"
    write_gltf(folder / "type.gltf", content, body)
    yield "type.gltf", "its glTF description is not valid;"
    content, body = gltf_parts(PYRAMID)
    content["accessors"][0]["count"] = 3000
    write_gltf(folder / "count.gltf", content, body)
    yield "count.gltf", "more data than there are"
    content, body = gltf_parts(PYRAMID)
    content["bufferViews"][1]["byteOffset"] += 4
    write_gltf(folder / "view.gltf", content, body)
    yield "view.gltf", "more data than there are"
    content, body = gltf_parts(PYRAMID)
    content["nodes"][1]["children"] = [0]
    write_gltf(folder / "circle.gltf", content, body)
    yield "circle.gltf", "a node is below itself"
    content, body = gltf_parts(PYRAMID * [[1], [1], [math.nan], [1], [math.inf]])
    del content["accessors"][0]["min"], content["accessors"][0]["max"]  # JSON has no nan
    write_gltf(folder / "nan.glb", content, body)
    yield "nan.glb", "2 vertices of 5 are not finite"
    content, body = gltf_parts(PYRAMID)
    content["asset"]["version"] = "1.0"
    write_gltf(folder / "old.glb", content, body)
    yield "old.glb", "version 1.0"
    content, body = gltf_parts(PYRAMID)
    content["extensionsRequired"] = ["KHR_draco_mesh_compression"]
    write_gltf(folder / "packed.gltf", content, body)
    yield "packed.gltf", "compressed (KHR_draco_mesh_compression)"
    content, body = gltf_parts(PYRAMID)
    content["meshes"][0]["primitives"][0] = {"attributes": {"POSITION": 0}, "mode": 0}
    write_gltf(folder / "points.glb", content, body)
    yield "points.glb", "no faces (5 vertices)"
    content, body = gltf_parts(PYRAMID)
    content["scenes"][0]["nodes"] = []
    write_gltf(folder / "nothing.glb", content, body)
    yield "nothing.glb", "no faces"
    content, _ = gltf_parts(PYRAMID)
    content["buffers"][0]["uri"] = "elsewhere.bin"
    (folder / "apart.gltf").write_text(json.dumps(content))
    yield "apart.gltf", "elsewhere.bin"


def refusal(name: str) -> str:
    with pytest.raises(Refusal) as caught:
        load(name)
    sentence = str(caught.value)
    assert "\n" not in sentence
    assert sentence.endswith((".", "?"))
    return sentence


def test_each_bad_file_gets_one_sentence_and_nothing_else(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    wrong = []
    for name, expected in bad_files(tmp_path):
        path = str(tmp_path / name)
        sentence = refusal(path)
        if expected not in sentence or not sentence.startswith(path + ": ") or ";" not in sentence:
            wrong.append((name, expected, sentence))
    assert wrong == []
    printed = capfd.readouterr()
    assert (printed.out, printed.err) == ("", "")


def test_a_file_without_read_permission(tmp_path: Path) -> None:
    path = tmp_path / "mine.obj"
    obj_file(path, PYRAMID)
    path.chmod(0)
    root = hasattr(os, "geteuid") and os.geteuid() == 0
    try:
        if root:  # whom no mode stops
            os.seteuid(65534)
        sentence = refusal(str(path))
    finally:
        if root:
            os.seteuid(0)
        path.chmod(0o600)
    assert "no permission" in sentence
    assert str(path) in sentence


def test_other_endings_are_answered_with_the_list(tmp_path: Path) -> None:
    (tmp_path / "mesh.off").write_text("OFF\n")
    sentence = refusal(str(tmp_path / "mesh.off"))
    assert str(tmp_path / "mesh.off") in sentence
    assert all(ending in sentence for ending in ENDINGS)
    assert "no such file" in refusal(str(tmp_path / "missing.off"))
    assert "folder" in refusal(str(tmp_path))


@pytest.mark.parametrize(
    ("name", "nearest"),
    [("letterf", "letter-f"), ("LETTER_F", "letter-f"), ("kube", "cube"), ("post", "posts")],
)
def test_an_unknown_name_is_answered_with_the_nearest(name: str, nearest: str) -> None:
    sentence = refusal(name)
    assert f"“{name}”" in sentence
    assert sentence.endswith(f"did you mean “{nearest}”?")


@pytest.mark.parametrize("name", ["", "xyzzy", ".stl"])
def test_a_name_like_no_scene_is_answered_with_all(name: str) -> None:
    assert all(known in refusal(name) for known in BUILT_IN)


@pytest.mark.parametrize("name", ["a\0b.stl", "a" * 300 + ".stl"])
def test_names_that_no_file_can_have(name: str) -> None:
    assert "file name" in refusal(name).lower()


# --------------------------------------------------------------------------- the first camera


def box_strategy() -> st.SearchStrategy[tuple[tuple[float, ...], tuple[float, ...]]]:
    """Boxes of size 1e-6 to 1e9, also flat or thin ones, anywhere within 1e7 of the origin."""
    shape = st.tuples(*[st.sampled_from([0.0, 1e-3, 0.1, 0.5, 1.0])] * 3).filter(any)
    centre = st.tuples(*[st.floats(-1e7, 1e7)] * 3)

    def box(
        size: float, shape: tuple[float, ...], centre: tuple[float, ...], near: bool
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        at = tuple(c * size / 1e7 if near else c for c in centre)
        lower = tuple(c - size * s / 2 for c, s in zip(at, shape, strict=True))
        return lower, tuple(low + size * s for low, s in zip(lower, shape, strict=True))

    sizes = st.floats(-6.0, 9.0).map(lambda power: 10.0**power)
    boxes = st.builds(box, sizes, shape, centre, st.booleans())
    # at 1e7 float64 steps are 2e-9: leave boxes that have a shape there
    return boxes.filter(lambda b: math.dist(*b) > 1e3 * math.ulp(max(map(abs, b[0] + b[1]))))


def corners(lower: tuple[float, ...], upper: tuple[float, ...]) -> np.ndarray:
    return np.array(list(product(*zip(lower, upper, strict=True))))


@given(box_strategy())
def test_framing_shows_every_box_whole_with_room_around_it(
    box: tuple[tuple[float, ...], tuple[float, ...]],
) -> None:
    lower, upper = box
    projection = frame_camera(lower, upper)
    size = math.dist(lower, upper)
    trace = projection.trace(corners(lower, upper))
    assert not trace.outside.any()
    assert 0.15 < abs(trace.ndc[:, :2]).max() < 0.85  # room, but not lost in it
    camera, lens = projection.camera, projection.lens
    middle = [(low + high) / 2 for low, high in zip(lower, upper, strict=True)]
    assert math.dist(camera.target, middle) < 0.01 * size
    assert lens.near >= camera.distance / 100
    assert lens.near < camera.distance < lens.far
    assert lens.far / lens.near < 100


def test_framing_looks_from_a_three_quarter_view_by_default() -> None:
    camera = frame_camera((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0)).camera
    assert all(0.2 < part < 0.9 for part in np.array(camera.eye) / camera.distance)
    assert camera.up == (0.0, 1.0, 0.0)


def test_framing_gives_numbers_that_can_be_read() -> None:
    projection = frame_camera((0.0, 0.0, 0.0), (math.pi, math.e, math.sqrt(2.0)))
    shown = [
        *projection.camera.eye,
        *projection.camera.target,
        projection.lens.near,
        projection.lens.far,
    ]
    assert all(len(repr(abs(number))) <= 6 for number in shown)


def test_distinct_rows_are_those_of_numpy() -> None:
    random = np.random.default_rng(1)
    for count in range(1, 60):
        rows = random.integers(-1, 2, (count, 3)) * random.choice([1.0, -0.0])
        wanted, places = np.unique(rows, axis=0, return_inverse=True)
        found, where = distinct_rows(rows)
        assert (found == wanted).all() and (where == places.ravel()).all()


@pytest.mark.parametrize("name", BUILT_IN)
def test_each_face_and_each_line_lies_whole_in_a_box(name: str) -> None:
    scene = load(name)
    origin = np.array(scene.origin)
    assert scene.surface is not None and scene.lines is not None
    things = scene.surface.regular_faces, scene.lines.lines.reshape(-1, 3)[:, 1:]
    meshes = scene.surface, scene.lines
    for mesh, cells, boxes in zip(meshes, things, scene.boxes, strict=True):
        points = mesh.points[cells].astype(float)[:, None] + origin
        low, high = boxes.min(axis=1)[:, None], boxes.max(axis=1)[:, None]
        inside = (points >= low - 1e-9) & (points <= high + 1e-9)
        assert inside.all(axis=(2, 3)).any(axis=1).all()
    everything = scene.boxes.together
    assert np.allclose(everything.min(axis=(0, 1)), scene.corners.min(axis=0))
    assert np.allclose(everything.max(axis=(0, 1)), scene.corners.max(axis=0))
