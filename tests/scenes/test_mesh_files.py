"""Mesh files: what is read from each format, and what is refused before it does harm."""

import base64
import json
import math
import os
import struct
import subprocess
import sys
import time
from collections.abc import Callable
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv

from app.bootstrap import ROOT
from app.document.codec import parse, picture_json
from app.document.document import Document
from app.document.files import read
from app.model.refusal import REFUSALS, Cancelled, Refusal
from app.scenes import finishing, gltf, gltf_data, mesh, mesh_files, ply, reading
from app.scenes.fewer_triangles import reduced, shares_for_dragging
from app.scenes.mesh import PAINT_RGB, Mesh
from app.scenes.scene import ENDINGS, Scene, load
from app.scenes.shapes import brightness
from tests.support.marked import marked
from tests.support.meshes import (
    FAR,
    PYRAMID,
    WRITERS,
    faces,
    gltf_file,
    gltf_parts,
    obj_file,
    outside,
    ply_file,
    ply_header,
    pyramid_file,
    rgb,
    segments,
    side,
    stl_file,
    stl_text_file,
    world_points,
    write_gltf,
)

THREE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
POSIX = pytest.mark.skipif(sys.platform == "win32", reason="a file of POSIX systems")


def obj(folder: Path, text: str) -> Mesh:
    path = folder / "m.obj"
    path.write_bytes(text.encode())
    return mesh_files.read(path)


def scene_of_obj(folder: Path, text: str) -> Scene:
    (folder / "m.obj").write_text(text, encoding="utf-8")
    return load(str(folder / "m.obj"))


def scene_of_gltf(
    folder: Path, change: Callable[[dict[str, Any]], object], name: str = "m.glb"
) -> Scene:
    """The pyramid as a glTF scene, after a change of its description."""
    content, body = gltf_parts(PYRAMID)
    change(content)
    write_gltf(folder / name, content, body)
    return load(str(folder / name))


def refused(path: Path) -> Refusal:
    with pytest.raises(Refusal) as caught:
        reading.read(path)
    return caught.value


# --------------------------------------------------------------------------- every format


def test_every_ending_is_tested() -> None:
    assert {Path(name).suffix for name, _, _ in WRITERS.values()} == set(ENDINGS)


@pytest.mark.parametrize(
    ("kind", "offset"),
    [(kind, 0.0) for kind in WRITERS] + [(kind, FAR) for kind in WRITERS if kind != "stl binary"],
)
def test_a_mesh_of_every_format_keeps_its_vertices_and_faces(
    kind: str, offset: float, tmp_path: Path
) -> None:
    """Binary STL has float32 coordinates: it cannot be tried far from the origin."""
    path = pyramid_file(tmp_path, kind, offset)
    scene, expected = load(str(path)), np.unique(PYRAMID + offset, axis=0)
    assert scene.name == str(path)
    assert (scene.lower, scene.upper) == (tuple(expected.min(axis=0)), tuple(expected.max(axis=0)))
    assert len(faces(scene)) == len(rgb(scene)) == WRITERS[kind][2]
    assert (np.unique(np.concatenate(faces(scene)), axis=0) == expected).all()
    assert scene.surface is not None and scene.surface.points.dtype == np.float64
    assert abs(scene.surface.points).max() <= scene.size + 4.0  # the GPU gets small numbers
    assert not outside(scene.start, world_points(scene))


@pytest.mark.parametrize("kind", ["obj", "stl text", "ply text", "gltf"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16-le", "utf-16-be", "utf-32-le", "utf-32-be"])
def test_a_text_mesh_is_read_in_every_encoding(kind: str, encoding: str, tmp_path: Path) -> None:
    """Cases 01 and 03: the mark hid the first vertex, and UTF-16 all of them."""
    path = pyramid_file(tmp_path, kind)
    text, expected = path.read_text(encoding="utf-8"), mesh_files.read(path)
    for mark in ("", "\ufeff"):
        path.write_bytes(f"{mark}{text}".encode(encoding))
        found = mesh_files.read(path)
        assert (found.points == expected.points).all()
        assert (found.corners == expected.corners).all()


def test_a_mark_is_no_part_of_the_first_vertex(tmp_path: Path) -> None:
    """Also if the rest is not UTF-8, and in the middle of files that were joined."""
    text = "\ufeffv -1 0 0\nv 1 0 0\n\ufeffv 0 1 0\nv 0 0 0\nv 3 0 0\nv 0 0 5\nf 1 2 3\n# ".encode()
    (tmp_path / "m.obj").write_bytes(text + b"\xe9\n")
    assert mesh_files.read(tmp_path / "m.obj").points.tolist() == [[-1, 0, 0], [1, 0, 0], [0, 1, 0]]


@pytest.mark.parametrize("header", [b"", b"\xef\xbb\xbfsolid", b"\0\0\1"])
def test_the_header_of_a_binary_stl_is_no_encoding(header: bytes, tmp_path: Path) -> None:
    stl_file(tmp_path / "m.stl", PYRAMID, header.ljust(80, b"\0"))
    assert len(mesh_files.read(tmp_path / "m.stl").points) == 5


def test_decimals_are_read_to_the_last_bit(tmp_path: Path) -> None:
    """0.1 + 1e7 is not a sum of powers of 2: only correct rounding of the text finds it."""
    points = np.random.default_rng(4).normal(size=(5, 3)) * 1e7
    for kind in ("obj", "ply text", "stl text"):
        name, write, _ = WRITERS[kind]
        write(tmp_path / name, points)
        scene = load(str(tmp_path / name))
        assert scene.lower == tuple(points.min(axis=0))
        assert scene.upper == tuple(points.max(axis=0))


@pytest.mark.parametrize("kind", WRITERS)
def test_progress_rises_from_0_to_1_and_can_cancel(kind: str, tmp_path: Path) -> None:
    path = str(pyramid_file(tmp_path, kind))
    seen: list[float] = []
    load(path, lambda fraction: seen.append(fraction) is None)
    assert seen == sorted(seen) and (seen[0], seen[-1]) == (0.0, 1.0)
    assert len(set(seen)) >= 4
    for stop_at in range(len(seen)):
        answers = iter([True] * stop_at + [False])
        with pytest.raises(Cancelled):
            load(path, lambda _fraction, answers=answers: next(answers))


def test_names_may_have_capital_endings_and_any_letters(tmp_path: Path) -> None:
    for name, write in (("M.OBJ", obj_file), ("ćevapčići õun.glb", gltf_file)):
        write(tmp_path / name, PYRAMID)
        assert load(str(tmp_path / name)).name == str(tmp_path / name)


# --------------------------------------------------------------------------- OBJ


@pytest.mark.parametrize(
    "face",
    [
        "f 1/1 2/2 3/3", "f 1/9 2/2 3/3", "f 1//9 2//9 3//9", "f 1// 2// 3//", "f 1/1/ 2/2/ 3/3/",
        "f +1 +2 +3", "f -3 -2 -1", "f -3/-9 2 3//1", "f\t1  2\t3 ", "  f 1 2 3", "f 1 2 3 # a",
        "f 1 \\\n2 3", "f 1 2 \\\r\n3", "usemtl\nf 1 2 3", "usemtl \ng\nf 1 2 3", "f 1 2 3\r",
        "vt\nvn x\nf 1 2 3", "# C:\\models\\\nf 1 2 3", "f 1 2 3 # \\\nv 4 4 4",
    ],
)  # fmt: skip
def test_corners_of_obj_are_read_as_other_programs_read_them(face: str, tmp_path: Path) -> None:
    """Textures and normals need not exist."""
    found = obj(tmp_path, THREE + face + "\n")
    assert found.points.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert found.corners.tolist() == [0, 1, 2] and found.offsets.tolist() == [0, 3]


def test_numbers_of_obj_may_have_signs_and_no_decimals(tmp_path: Path) -> None:
    found = obj(tmp_path, "v +1 2. .5\nv 1e0 -0 1 1\nv 0 1 0 0.5 0.5 0.5\nf 1 2 3\n")
    assert found.points.tolist() == [[1, 2, 0.5], [1, 0, 1], [0, 1, 0]]


def test_a_corner_counts_back_from_its_own_line(tmp_path: Path) -> None:
    found = obj(tmp_path, THREE + "f -3 -2 -1\nv 5 0 0\nf -4 -1 2 3\n")
    assert found.corners.tolist() == [0, 1, 2, 0, 3, 1, 2]
    assert found.offsets.tolist() == [0, 3, 7]


@pytest.mark.parametrize(
    ("name", "write"), [("m.obj", obj_file), ("m.stl", stl_text_file)], ids=["obj", "stl"]
)
def test_a_text_larger_than_a_block_is_read_across_the_seams(
    name: str, write: Callable[..., None], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path / name, PYRAMID)
    whole = mesh_files.read(tmp_path / name)
    (tmp_path / "bad.obj").write_text("v 0 0 0\n# a\n" * 3 + "v 1 x 0\n", encoding="utf-8")
    for block in (1, 7, 64, 300):
        monkeypatch.setattr(mesh_files, "BLOCK", block)
        found = mesh_files.read(tmp_path / name)
        assert (found.points == whole.points).all() and (found.corners == whole.corners).all()
        assert refused(tmp_path / "bad.obj").limits[1:] == (7, "OBJ")


def test_obj_with_normals_and_textures_has_no_edges_inside_a_plane(tmp_path: Path) -> None:
    """The file repeats vertices for them. Two faces are neighbours only if these are merged."""
    scene = scene_of_obj(
        tmp_path,
        "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 1\nvn 0 1 0\nvn 0 -1 0\n"
        "f 1/1/1 2/1/1 3/1/1\nf 1/2/2 3/2/2 4/2/2\n",
    )
    ends = segments(scene)
    of_mesh = ends[(abs(ends - 0.5) <= 0.5).all(axis=(1, 2))]
    assert len(of_mesh) and (np.count_nonzero(np.ptp(of_mesh, axis=1), axis=1) == 1).all()


# --------------------------------------------------------------------------- STL


def test_copied_corners_of_stl_become_one_vertex(tmp_path: Path) -> None:
    for write in (stl_text_file, stl_file):
        write(tmp_path / "m.stl", PYRAMID)
        assert len(mesh_files.read(tmp_path / "m.stl").points) == 5


def test_binary_stl_with_bytes_after_its_triangles_opens(tmp_path: Path) -> None:
    stl_file(tmp_path / "m.stl", PYRAMID, b"made by a test")
    with (tmp_path / "m.stl").open("ab") as file:
        file.write(b"more")
    assert len(faces(load(str(tmp_path / "m.stl")))) == 6


FACETS = """
  FACET NORMAL 0 0 1
    OUTER LOOP
      VERTEX 0 0 0
      VERTEX +1.0E+00 0 0
      VERTEX 0 1. -0.0
    ENDLOOP
  ENDFACET
"""


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (f"solid a{FACETS}endsolid a\n", 1),
        (f"SOLID a{FACETS}ENDSOLID a\n".replace("\n", "\r\n"), 1),
        (f"Solid a{FACETS}".replace("\n", "\r"), 1),
        (f"solid{FACETS}{FACETS}", 2),
        (f"solid a{FACETS}endsolid a\nsolid vertex loop{FACETS}endsolid vertex loop", 2),
        (f"solid a{FACETS}".replace("\n", " ").replace("  ", "\t"), 1),
        (f"\n\n  solid a b c facet{FACETS}endsolid", 1),
        (FACETS, 1),
    ],
)
def test_text_stl_is_read_in_the_forms_that_writers_use(
    text: str, count: int, tmp_path: Path
) -> None:
    (tmp_path / "m.stl").write_bytes(text.encode())
    found = mesh_files.read(tmp_path / "m.stl")
    assert found.points.tolist() == [[0, 0, 0], [0, 1, 0], [1, 0, 0]]
    assert found.corners.tolist() == [0, 2, 1] * count


@pytest.mark.parametrize("more", [b"", b"\n", b"more", bytes(49), bytes(51)])
@pytest.mark.parametrize("header", [b"solid part", b"SOLID\nfacet normal", b"made by a test"])
def test_binary_stl_is_known_by_its_length(header: bytes, more: bytes, tmp_path: Path) -> None:
    stl_file(tmp_path / "m.stl", PYRAMID, header)
    whole = (tmp_path / "m.stl").read_bytes()
    for count in (6, 0, 2**32 - 1):  # some writers do not know it when they begin
        counted = whole[:80] + struct.pack("<I", count) + whole[84:]
        (tmp_path / "m.stl").write_bytes(counted + more[: None if count == 6 else 49])
        found = mesh_files.read(tmp_path / "m.stl")
        assert len(found.offsets) - 1 == 6
        assert (found.points == np.unique(PYRAMID, axis=0)).all()


# --------------------------------------------------------------------------- PLY


def written(folder: Path, header: str, body: bytes) -> Mesh:
    (folder / "m.ply").write_bytes(header.encode() + body)
    return mesh_files.read(folder / "m.ply")


STRIPS = [0, 4, 1, 3, -1, 1, 2, 4, -1, 2, 3]
IN_STRIPS = [[0, 4, 1], [4, 3, 1], [1, 2, 4]]
"""Every other triangle of a strip runs the other way round."""


@pytest.mark.parametrize("encoding", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_triangle_strips_of_ply_are_read(encoding: str, tmp_path: Path) -> None:
    header = (
        f"ply\nformat {encoding} 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
        "property double z\nelement tristrips 2\nproperty list int int vertex_indices\nend_header\n"
    )
    rows = [STRIPS, [0, 1, 1, 2, 3]]
    if encoding == "ascii":
        body = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in PYRAMID.tolist()).encode()
        body += "".join(f"{len(row)} {' '.join(map(str, row))}\n" for row in rows).encode()
    else:
        order = "<" if "little" in encoding else ">"
        body = PYRAMID.astype(f"{order}f8").tobytes()
        for row in rows:
            body += struct.pack(f"{order}{len(row) + 1}i", len(row), *row)
    found = written(tmp_path, header, body)
    assert (found.points == PYRAMID).all()
    assert found.corners.reshape(-1, 3).tolist() == [*IN_STRIPS, [1, 2, 3]]
    assert not found.notes  # a repeated corner joins strips


def test_faces_of_ply_by_another_name_are_refused_by_it(tmp_path: Path) -> None:
    """Their vertices alone would be a cloud that the file does not show."""
    path = tmp_path / "m.ply"
    xyz = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in PYRAMID.tolist())
    header = ply_header("ascii", 5, 1).replace("element face", "element trifans")
    path.write_text(f"{header}{xyz}4 0 1 2 3\n", encoding="utf-8")
    assert refused(path).limits[1:] == ("element trifans",)


def test_triangle_strips_of_ply_may_stand_beside_faces(tmp_path: Path) -> None:
    header = ply_header("ascii", 5, 1).replace(
        "end_header", "element tristrips 1\nproperty list int int vertex_indices\nend_header"
    )
    xyz = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in PYRAMID.tolist())
    found = written(tmp_path, header, f"{xyz}4 0 1 2 3\n4 0 1 4 2\n".encode())
    assert found.corners.tolist() == [0, 1, 2, 3, 0, 1, 4, 1, 2, 4]
    assert found.offsets.tolist() == [0, 4, 7, 10]


LISTED = """ply
format ascii 1.0
comment made by a test
obj_info num_cols 5
element camera 1
property float view_px
property list uchar float more
element vertex 5
property list uchar int before
property float x
property float y
property float z
element other 2
property int a
element face 3
property list uchar float texcoord
property {} vertex_index
property uchar flags
end_header
1 2 7 7
0 0 0 0
1 9 1 0 0
0 1 1 0
2 9 9 0 1 0
0 0.5 0.5 1

1
2
6 0 0 1 0 1 1 3 0 1 2 255
0 3 0 2 3 0
2 0 0 3 3 2 4 0
"""


@pytest.mark.parametrize("counted", ["list uchar int", "list int uint", "list ushort short"])
@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_lists_of_ply_stand_before_and_after_others(counted: str, end: str, tmp_path: Path) -> None:
    text = LISTED.format(counted).replace("\n", end)
    found = written(tmp_path, "", text.encode())
    assert found.corners.tolist() == [0, 1, 2, 0, 2, 3, 3, 2, 4]
    assert found.points[4].tolist() == [0.5, 0.5, 1]
    longer = text.replace(f"255{end}", f"255 8 9{end}").replace(f"1 1 0{end}", f"1 1 0 5{end}")
    assert written(tmp_path, "", longer.encode()).corners.tolist() == found.corners.tolist()


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_a_binary_body_may_begin_with_any_byte(end: str, tmp_path: Path) -> None:
    for first in (0x20, 0x0A, 0x09, 0x0D if end != "\n" else 0x0C):
        points = PYRAMID.astype("<f8")
        points.view(np.uint8)[0, 0] = first
        header = ply_header("binary_little_endian", 5, 1).replace("\n", end)
        body = points.tobytes() + struct.pack("<B3i", 3, 0, 1, 2)
        assert (written(tmp_path, header, body).points == points[:3]).all()


def test_rows_of_a_text_ply_may_be_wrapped(tmp_path: Path) -> None:
    body = "0 0 0 1 0 0 0 1 0 3 0 1 2\n"
    assert written(tmp_path, ply_header("ascii", 3, 1), body.encode()).corners.tolist() == [0, 1, 2]


# --------------------------------------------------------------------------- what is left out


def test_small_faces_are_left_out_and_the_first_is_named(tmp_path: Path) -> None:
    found = obj(tmp_path, THREE + "f 1 2 3\nf \\\n1 2\nf 3 2 1\nf 1 1/2 2 1\nf 2\nf 3 1 2\n")
    assert found.corners.tolist() == [0, 1, 2, 2, 1, 0, 2, 0, 1]
    assert found.notes == [(REFUSALS["few-corners-line"], 3, 6, 5)]
    header = ply_header("binary_little_endian", 5, 3, "", channels("uchar"))
    body = PYRAMID.astype("<f8").tobytes() + struct.pack("<B3i3B", 3, 0, 1, 2, 1, 2, 3)
    body += struct.pack("<B2i3B", 2, 0, 1, 4, 5, 6) + struct.pack("<B3i3B", 3, 0, 2, 3, 7, 8, 9)
    found = written(tmp_path, header, body)
    assert found.notes == [(REFUSALS["few-corners"], 1, 3, 2)]
    assert found.rgb is not None and found.rgb.tolist() == [[1, 2, 3], [7, 8, 9]]


def test_vertices_that_are_not_finite_and_unused_are_left_out(tmp_path: Path) -> None:
    found = obj(tmp_path, THREE + "v -1.#IND 0 0\nv 5 5 5\nv 0 -inf 0 # a\nf 1 2 3\nl 1 5\n")
    assert found.notes == [(REFUSALS["unused-line"], 2, 6, 4)]
    assert len(found.points) == 4
    (tmp_path / "line.obj").write_text(
        THREE + "v nan 0 0\nf 1 2 3\nl 3 1\nl 1 2 4\n", encoding="utf-8"
    )
    error = refused(tmp_path / "line.obj")
    assert (error.bound, error.limits[1:]) == (REFUSALS["not-finite-line"], (4, 7))
    points = np.vstack([PYRAMID, [[math.nan, 0, 0]]]).astype("<f8")
    header = ply_header("binary_little_endian", 6, 1)
    found = written(tmp_path, header, points.tobytes() + struct.pack("<B3i", 3, 0, 1, 2))
    assert found.notes == [(REFUSALS["unused"], 1, 6, 6)]


def test_dots_that_are_not_finite_are_left_out(tmp_path: Path) -> None:
    """Scanners write them for rays that meet nothing."""
    found = obj(tmp_path, "v 0 0 0 1 0 0\nv nan nan nan 0 1 0\nv 1 1 1 0 0 1\n")
    assert found.points.tolist() == [[0, 0, 0], [1, 1, 1]]
    assert found.dot_rgb is not None
    assert found.dot_rgb.tolist() == [[255, 0, 0], [0, 0, 255]]
    assert found.notes == [(REFUSALS["unused-line"], 1, 3, 2)]
    (tmp_path / "m.obj").write_text("v nan 0 0\nv 0 inf 0\n", encoding="utf-8")
    assert refused(tmp_path / "m.obj").bound == REFUSALS["not-finite"]


def test_a_scene_says_what_of_its_file_is_left_out(tmp_path: Path) -> None:
    scene = scene_of_obj(tmp_path, THREE + "f 1 2\nf 1 2 3\n")
    assert [str(note) for note in scene.notes] == [
        f"{tmp_path / 'm.obj'}: faces left out: 1 of 2, because they have fewer than three "
        "different corners; the first is on line 4."
    ]
    of_phenomenon = load("similar-triangles", mesh=str(tmp_path / "m.obj"))
    assert [note.limits for note in of_phenomenon.notes] == [note.limits for note in scene.notes]


def test_a_triangle_of_a_repeated_corner_is_left_out_with_a_note(tmp_path: Path) -> None:
    text = "solid\n"
    for named in ([0, 1, 2], [0, 1, 1], [0, 2, 3]):
        vertices = "".join(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in PYRAMID[named].tolist())
        text += f"facet normal 0 0 1\nouter loop\n{vertices}endloop\nendfacet\n"
    (tmp_path / "m.stl").write_text(text + "endsolid\n", encoding="utf-8")
    content, body = gltf_parts(PYRAMID)
    indices = next(each for each in content["accessors"] if each["type"] == "SCALAR")
    view = content["bufferViews"][indices["bufferView"]]
    kind = {5121: "<u1", 5123: "<u2", 5125: "<u4"}[indices["componentType"]]
    changed = np.frombuffer(body, kind, indices["count"], view.get("byteOffset", 0)).copy()
    changed[5] = changed[4]
    at = view.get("byteOffset", 0)
    body = body[:at] + changed.tobytes() + body[at + changed.nbytes :]
    write_gltf(tmp_path / "m.glb", content, body)
    for name, count in (("m.stl", 3), ("m.glb", len(changed) // 3)):
        found = mesh_files.read(tmp_path / name)
        assert found.notes == [(REFUSALS["few-corners"], 1, count, 2)], name
        assert len(found.offsets) == count


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("m.stl", b"solid".ljust(80) + b"\0\0\0\1" + 50 * b"\0", "it uses “big-endian”"),
        (
            "m.ply",
            b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            b"property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
            b"end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
            "from line 14 on, it has more rows than its header counts",
        ),
    ],
)
def test_the_cause_of_a_fault_is_named(
    name: str, content: bytes, said: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(content)
    assert said in str(refused(tmp_path / name))


def test_what_other_programs_write_is_read(tmp_path: Path) -> None:
    stl_text_file(tmp_path / "a.stl", PYRAMID)
    text = (tmp_path / "a.stl").read_text(encoding="utf-8")
    name = text.split("\n")[0]
    for changed in (f"# made by hand\n\n# {name}\n{text}",
                    text.replace(name, "solid facet normal vertex loop", 1)):  # fmt: skip
        (tmp_path / "m.stl").write_text(changed, encoding="utf-8")
        assert len(mesh_files.read(tmp_path / "m.stl").points) == 5
    ply_file(tmp_path / "a.ply", PYRAMID)
    data = (tmp_path / "a.ply").read_bytes()
    for old, new in ((b" x\n", b" X\n"), (b"vertex_indices", b"indices")):
        assert old in data
        (tmp_path / "m.ply").write_bytes(data.replace(old, new))
        assert len(mesh_files.read(tmp_path / "m.ply").points) == 5
    found = obj(tmp_path, "v\xa00 0\xa00\nv 1\xa00 0\nv 0 1 0\nf 1 2\xa03\n")
    assert len(found.points) == 3


# --------------------------------------------------------------------------- glTF


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
        # z goes to x, x to -z; the quaternion need not have length 1
        ({"rotation": QUARTER_TURN_ABOUT_Y}, [[0, 0, 1], [0, 1, 0], [-1, 0, 0]]),
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
    scene = scene_of_gltf(tmp_path, lambda c: c["nodes"].__setitem__(1, {"mesh": 0, **node}))
    turned = PYRAMID @ np.array(expected).T
    assert np.allclose(scene.lower, turned.min(axis=0))
    assert np.allclose(scene.upper, turned.max(axis=0))


def test_a_mirrored_gltf_node_keeps_its_faces_looking_outward(tmp_path: Path) -> None:
    drawn = faces(scene_of_gltf(tmp_path, lambda c: c["nodes"][1].update(scale=[-1, 1, 1])))
    inside = np.mean([face.mean(axis=0) for face in drawn], axis=0)
    for face in drawn:
        assert np.cross(face[1] - face[0], face[2] - face[0]) @ (face[0] - inside) > 0.0


def test_gltf_without_a_scene_shows_all_its_nodes_once(tmp_path: Path) -> None:
    def without_scene(content: dict[str, Any]) -> None:
        content["nodes"][0]["translation"] = [1, 2, 3]
        del content["scene"], content["scenes"]

    scene = scene_of_gltf(tmp_path, without_scene)
    assert len(faces(scene)) == 6 and scene.lower == (1.125, 2.0, 3.25)


def test_gltf_with_its_data_in_a_file_beside_it(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["buffers"][0]["uri"] = "the%20data.bin"
    content["images"] = [{"uri": "missing.png"}]  # textures are neither drawn nor required
    (tmp_path / "the data.bin").write_bytes(body)
    (tmp_path / "m.gltf").write_text(json.dumps(content), encoding="utf-8")
    assert load(str(tmp_path / "m.gltf")).upper == tuple(PYRAMID.max(axis=0))


def test_gltf_data_in_its_description_may_have_escapes(tmp_path: Path) -> None:
    """Base64 has + and /, which some escape as in any address."""
    content, body = gltf_parts(np.array([[0, 0, 0], [1, 0.999999, 0], *PYRAMID[2:]]))
    address = f"data:application/octet-stream;base64,{base64.b64encode(body).decode()}"
    found = []
    for escaped in (address, address.translate({ord(c): f"%{ord(c):02X}" for c in "+/="})):
        content["buffers"][0]["uri"] = escaped
        (tmp_path / "m.gltf").write_text(json.dumps(content), encoding="utf-8")
        found.append(mesh_files.read(tmp_path / "m.gltf").points.tolist())
    assert "%2B" in escaped and "%2F" in escaped and found[0] == found[1]


def test_gltf_meshes_of_several_nodes_are_joined(tmp_path: Path) -> None:
    def second(content: dict[str, Any]) -> None:
        content["nodes"].append({"mesh": 0, "translation": [10, 0, 0]})
        content["scenes"][0]["nodes"].append(2)

    scene = scene_of_gltf(tmp_path, second, "m.gltf")
    assert len(faces(scene)) == 12
    assert (scene.lower[0], scene.upper[0]) == (0.125, 3.25 + 10.0)


@pytest.mark.parametrize(
    ("mode", "corners"),
    [(5, [[0, 1, 2], [1, 3, 2], [2, 3, 4]]), (6, [[0, 1, 2], [0, 2, 3], [0, 3, 4]])],
)
def test_gltf_strips_and_fans_are_drawn(mode: int, corners: Any, tmp_path: Path) -> None:
    """Every other triangle of a strip begins with its last two vertices swapped."""

    def change(content: dict[str, Any]) -> None:
        content["meshes"][0]["primitives"][0] = {"attributes": {"POSITION": 0}, "mode": mode}

    drawn = faces(scene_of_gltf(tmp_path, change))
    assert (np.array(drawn) == PYRAMID[corners]).all()


# --------------------------------------------------------------------------- colours


def ply_of_two(
    tmp_path: Path, vertex_rgb: str, rows: list[str], face_rgb: str = "", faces_text: str = ""
) -> list[list[int]]:
    """The face colours of two triangles on four vertices."""
    path = tmp_path / "colours.ply"
    xyz = ["0 0 0", "1 0 0", "0 1 0", "1 1 0"]
    body = "".join(f"{p} {row}\n" for p, row in zip(xyz, rows, strict=True))
    path.write_text(
        ply_header("ascii", 4, 2, vertex_rgb, face_rgb)
        + body
        + (faces_text or "3 0 1 2\n3 1 3 2\n"),
        encoding="utf-8",
    )
    found: list[list[int]] = rgb(load(str(path))).tolist()
    return found


def channels(kind: str) -> str:
    return "".join(f"property {kind} {channel}\n" for channel in ("red", "green", "blue"))


@pytest.mark.parametrize(("kind", "full"), [("uchar", 255), ("float", 1.0), ("ushort", 65535)])
def test_ply_vertex_colours_are_kept(kind: str, full: float, tmp_path: Path) -> None:
    red, green = f"{full} 0 0", f"0 {full} 0"
    found = ply_of_two(tmp_path, channels(kind), [red, red, red, green])
    assert found == [[255, 0, 0], [170, 85, 0]]


def test_ply_colours_that_are_not_numbers_are_black(tmp_path: Path) -> None:
    found = ply_of_two(tmp_path, channels("float"), ["1 0 0", "1 0 nan", "1 0 0", "0 0 inf"])
    assert found[0] == [255, 0, 0]


def test_ply_face_colours_are_kept(tmp_path: Path) -> None:
    rows = "3 0 1 2 9 8 7\n3 1 3 2 60 70 80\n"
    assert ply_of_two(tmp_path, "", [""] * 4, channels("uchar"), rows) == [[9, 8, 7], [60, 70, 80]]


def test_ply_colours_of_faces_of_mixed_sizes_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "m.ply"
    header = ply_header("binary_little_endian", 5, 2, "", channels("uchar")).encode()
    quad = struct.pack("<B4i3B", 4, 0, 1, 2, 3, 11, 12, 13)
    triangle = struct.pack("<B3i3B", 3, 0, 4, 1, 21, 22, 23)
    path.write_bytes(header + PYRAMID.astype("<f8").tobytes() + quad + triangle)
    scene = load(str(path))
    assert rgb(scene).tolist() == [[11, 12, 13], [21, 22, 23]]
    assert [len(face) for face in faces(scene)] == [4, 3]


def test_one_colour_for_the_whole_mesh_is_lit_so_that_its_shape_is_seen(tmp_path: Path) -> None:
    obj_file(tmp_path / "m.obj", PYRAMID)
    rows = (tmp_path / "m.obj").read_text(encoding="utf-8").splitlines()
    rows = [f"{row} 1 0.5 0" if row.startswith("v ") else row for row in rows]
    colours = rgb(scene_of_obj(tmp_path, "\n".join(rows))).astype(float)
    assert len(np.unique(colours[1:], axis=0)) == 4
    assert np.allclose(colours[:, 1] / colours[:, 0], 127 / 255, atol=0.02)  # the hue stays
    assert (colours[:, 2] == 0).all()


def test_gltf_material_is_the_paint_and_converted_from_linear_light(tmp_path: Path) -> None:
    def paint(content: dict[str, Any]) -> None:
        content["materials"] = [
            {"pbrMetallicRoughness": {"baseColorFactor": [1.0, 0.2140, 0.0, 1.0]}}
        ]
        content["meshes"][0]["primitives"][0]["material"] = 0

    colours = rgb(scene_of_gltf(tmp_path, paint)).astype(float)
    # linear 0.2140 is half of the sRGB scale
    assert np.allclose(colours[:, 1] / colours[:, 0], 0.5, atol=0.02)
    assert len(np.unique(colours, axis=0)) > 3


def test_gltf_vertex_colours_are_kept(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    colours = np.zeros((5, 3), dtype="<f4")
    colours[[0, 4, 1], 2] = 1.0  # the first triangle is blue
    view = {"buffer": 0, "byteOffset": len(body), "byteLength": colours.nbytes}
    content["bufferViews"].append(view)
    content["accessors"].append(
        {"bufferView": 2, "componentType": 5126, "count": 5, "type": "VEC3"}
    )
    content["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 2
    content["buffers"][0]["byteLength"] = len(body) + colours.nbytes
    write_gltf(tmp_path / "m.glb", content, body + colours.tobytes())
    assert rgb(load(str(tmp_path / "m.glb"))).tolist()[:2] == [[0, 0, 255], [0, 0, 170]]


def test_light_comes_from_above_and_in_front(tmp_path: Path) -> None:
    """A cube of quads: its top is the lightest side, its bottom the darkest, no two alike."""
    rows = [f"v {x} {y} {z}" for x, y, z in product((0, 1), repeat=3)]
    quads = ["5 7 8 6", "1 2 4 3", "3 4 8 7", "1 5 6 2", "2 6 8 4", "1 3 7 5"]
    scene = scene_of_obj(tmp_path, "\n".join([*rows, *(f"f {quad}" for quad in quads)]))
    of_side = {side(f): c for f, c in zip(faces(scene), rgb(scene).mean(axis=1), strict=True)}
    darkest_first = sorted(of_side, key=lambda name: of_side[name])
    assert darkest_first[0] == "-y"
    assert darkest_first[-2:] == ["+z", "+y"]
    assert np.diff(sorted(of_side.values())).min() >= 3.0


def test_shading_is_that_of_world_space_at_any_scale_and_place(tmp_path: Path) -> None:
    """Also where the cross product of two edges in float32 would leave its range or digits."""
    wanted = rgb(load(str(pyramid_file(tmp_path, "obj"))))
    assert len(np.unique(wanted, axis=0)) == 5
    assert wanted.mean(axis=1)[1:].max() > 100 and wanted.mean(axis=1).min() > 40
    for scale, offset in ((1.0, FAR), (1e-20, 0.0), (1e20, 0.0)):
        obj_file(tmp_path / "m.obj", PYRAMID * scale + offset)
        assert abs(rgb(load(str(tmp_path / "m.obj"))).astype(int) - wanted).max() <= 1


# --------------------------------------------------------------------------- odd but sound


@pytest.mark.parametrize("other", ["", "f 1 2 4\n"])
def test_a_polygon_that_repeats_itself_is_drawn_as_a_fan(other: str, tmp_path: Path) -> None:
    scene = scene_of_obj(tmp_path, f"{THREE}v 2 2 2\nf 1 2 3 1 2 3\n{other}")
    assert scene.surface is not None
    # The triangle twice, and the other one.
    expected = 1.0 + (math.sqrt(2.0) if other else 0.0)
    assert pv.wrap(scene.surface.triangulate()).area == pytest.approx(expected)
    assert len(rgb(scene)) == scene.surface.n_cells == 4 + bool(other)


def test_faces_of_every_number_of_corners_keep_light_and_triangles(tmp_path: Path) -> None:
    """A polygon is as bright as the same place in triangles, also among polygons of other sizes."""
    turn = np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)
    ring = np.stack([np.cos(turn), 0.2 * turn, np.sin(turn)], axis=1)
    lines = [f"v {x} {y} {z}" for x, y, z in ring.tolist()]
    faces_of = [f"f {' '.join(map(str, range(1, count + 1)))}" for count in range(3, 61)]
    shades = rgb(scene_of_obj(tmp_path, "\n".join([*lines, *faces_of])))
    owners = [3, 4, *(count for count in range(5, 61) for _ in range(count - 2))]
    for count, shade in zip(owners, shades, strict=True):
        fan = np.array([(0, k, k + 1) for k in range(1, count - 1)])
        area = np.cross(ring[fan[:, 1]] - ring[0], ring[fan[:, 2]] - ring[0]).sum(axis=0)
        expected = np.array(PAINT_RGB) * brightness((area / np.linalg.norm(area))[None])
        assert np.abs(shade.astype(float) - expected).max() <= 1.0


def test_a_flat_mesh_opens(tmp_path: Path) -> None:
    obj_file(tmp_path / "m.obj", PYRAMID * (1.0, 0.0, 1.0))
    scene = load(str(tmp_path / "m.obj"))
    assert scene.size > 4.0 and scene.lower[1] == scene.upper[1]
    assert not outside(scene.start, world_points(scene))


def test_vertices_without_a_face_do_not_count(tmp_path: Path) -> None:
    scene = scene_of_obj(tmp_path, "v 1e6 1e6 1e6\n" + THREE + "f 2 3 4\n")
    assert scene.upper == (1.0, 1.0, 0.0)
    assert scene.surface is not None and scene.surface.n_points == 3


@pytest.mark.parametrize("place", [1e-3, 1.0, 9e5, 4e11])
def test_a_mesh_within_the_bounds_of_its_coordinates_is_in_view(
    place: float, tmp_path: Path
) -> None:
    scene = scene_of_obj(tmp_path, f"v {place} 0 0\nv {place} 1 0\nv {place} 0 1\nf 1 2 3\n")
    assert not outside(scene.start, world_points(scene))


# --------------------------------------------------------------------------- bad files

FACET = "solid\nfacet normal\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
XYZ = "0 0 0\n1 0 0\n0 1 0\n"
TEXTS: dict[str, tuple[str, str, tuple[object, ...]]] = {
    "prose.stl": ("Dear all, the mesh is attached.\n" * 9, REFUSALS["not-of-kind"], ("STL",)),
    "solid.stl": ("solid advice: this is not a mesh.\n", REFUSALS["no-faces"], (0,)),
    "facets.stl": (
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
        "endfacet\nfacet normal 0 0 1\n", REFUSALS["cut-off"], (),
    ),
    "half.stl": ("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0", REFUSALS["cut-off"], ()),
    "word.stl": (FACET.replace("0 0 0", "0 0 o"), REFUSALS["damaged-line"], (4, "STL")),
    "four.stl": (FACET.replace("0 0 0", "0 0 0 0"), REFUSALS["damaged-line"], (4, "STL")),
    "quad.stl": (
        FACET.replace("endloop", "vertex 1 1 0\nendloop"), REFUSALS["damaged-line"], (2, "STL"),
    ),
    "loop.stl": (2 * FACET.replace("outer loop", "outer lop", 1), REFUSALS["damaged"], ("vertex",)),
    "nan.stl": (FACET.replace("0 0 0", "0 0 nan"), REFUSALS["not-finite-line"], (4, 2)),
    "prose.ply": ("Dear all\n", REFUSALS["not-of-kind"], ("PLY",)),
    "header.ply": ("ply\nformat ascii 1.0\nelement vertex 3\n", REFUSALS["not-of-kind"], ("PLY",)),
    "format.ply": (
        "ply\nformat ascii2 1.0\nelement vertex 0\nend_header\n", REFUSALS["damaged"], ("header",)
    ),
    "novertex.ply": (
        "ply\nformat ascii 1.0\nelement face 0\nend_header\n", REFUSALS["damaged"], ("header",)
    ),
    "noxyz.ply": (
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
        REFUSALS["damaged"], ("vertex: x, y, z",),
    ),
    "noface.ply": (
        ply_header("ascii", 3, 1).replace("vertex_indices", "corners") + XYZ + "3 0 1 2\n",
        REFUSALS["damaged"], ("face: vertex_indices",),
    ),
    "word.ply": (ply_header("ascii", 1, 0) + "0 zero 0\n", REFUSALS["damaged-line"], (11, "PLY")),
    "short.ply": (
        ply_header("ascii", 3, 1) + "0 0 0\n1 0 0\n", REFUSALS["cut-off-rows"], (2, 3, "vertex"),
    ),
    "shortface.ply": (
        ply_header("ascii", 3, 2) + XYZ + "3 0 1 2\n3 0", REFUSALS["cut-off-rows"], (1, 2, "face"),
    ),
    "shortrow.ply": (
        ply_header("ascii", 3, 2) + XYZ + "3 0 1\n3 0 1 2\n",
        REFUSALS["damaged-line"], (14, "face"),
    ),
    "shortrows.ply": (
        ply_header("ascii", 3, 1) + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n",
        REFUSALS["damaged-line"], (12, "vertex"),
    ),
    "longrows.ply": (
        ply_header("ascii", 3, 2) + XYZ.replace("\n", " 9 9\n") + "3 0 1 2\n",
        REFUSALS["cut-off-rows"], (1, 2, "face"),
    ),
    "index.ply": (
        ply_header("ascii", 3, 1) + XYZ + "3 0 1 9\n", REFUSALS["no-such-vertex-line"], (14, 3),
    ),
    "nanindex.ply": (
        ply_header("ascii", 3, 1) + XYZ + "3 0 1 nan\n", REFUSALS["no-such-vertex-line"], (14, 3),
    ),
    "two.ply": (
        ply_header("ascii", 3, 1) + XYZ + "2 0 1\n", REFUSALS["few-corners-line"], (1, 1, 14),
    ),
    "point.ply": (ply_header("ascii", 1, 0) + "0 0 0\n", REFUSALS["one-point"], ()),
    "none.ply": (ply_header("ascii", 0, 0), REFUSALS["no-faces"], (0,)),
    "nan.ply": (
        ply_header("ascii", 3, 1) + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n",
        REFUSALS["not-finite-line"], (12, 14),
    ),
    "prose.obj": ("Dear all\n", REFUSALS["no-faces"], (0,)),
    "surface.obj": (THREE + "deg 1 1\nsurf 0 1 0 1 1 2 3\nend\n", REFUSALS["no-faces"], (3,)),
    "curve.obj": (THREE + "deg 2\ncurv 0 1 1 2 3\nend\n", REFUSALS["no-faces"], (3,)),
    "outline.obj": (THREE + "fo 1 2 3\n", REFUSALS["no-faces"], (3,)),
    "line9.obj": (THREE + "l 1 2 9\n", REFUSALS["no-such-vertex-line"], (4, 3)),
    "point9.obj": (THREE + "p -4\n", REFUSALS["no-such-vertex-line"], (4, 3)),
    "lineword.obj": (THREE + "l 1 2 a\n", REFUSALS["damaged-line"], (4, "OBJ")),
    "same.obj": ("v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n", REFUSALS["one-point"], ()),
    "onecorner.obj": ("v 1 2 3\nf 1 1 1\n", REFUSALS["few-corners-line"], (1, 1, 2)),
    "line.obj": ("v 1 2 3\nv 1 2 4\nv 1 2 7\nf 1 2 3\n", REFUSALS["one-line"], ()),
    "slant.obj": ("v .1 .2 .3\nv .2 .4 .6\nv .7 1.4 2.1\nf 1 2 3\n", REFUSALS["one-line"], ()),
    "index.obj": (THREE + "f 1 2 9\n", REFUSALS["no-such-vertex-line"], (4, 3)),
    "texture.obj": (
        THREE + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 4/3\n", REFUSALS["no-such-vertex-line"], (7, 3),
    ),
    "joinedlines.obj": (
        "v 0 0 0\nv 1 \\\n0 \\\r\n0\nv 0 1 0\nf 1 2 9\n", REFUSALS["no-such-vertex-line"], (6, 3),
    ),
    "joinedbad.obj": ("v 0 0 0\nv 1 \\\n0 \\\n0\nv 0 1 o\n", REFUSALS["damaged-line"], (5, "OBJ")),
    "small.obj": (THREE + "f 1 2\nf 3\nf 1 2 1 2\n", REFUSALS["few-corners-line"], (3, 3, 4)),
    "zero.obj": (THREE + "f 0 1 2\n", REFUSALS["no-such-vertex-line"], (4, 3)),
    "half.obj": ("v 0 0 0\nv 1 0", REFUSALS["damaged-line"], (2, "OBJ")),
    "word.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 x\nf 1 2 3\n", REFUSALS["damaged-line"], (3, "OBJ")),
    "corner.obj": ("v 1 2 3\nf 1 1 /1\n", REFUSALS["damaged-line"], (2, "OBJ")),
    "letter.obj": ("v 1 2 3\nf 1 1 a\n", REFUSALS["damaged-line"], (2, "OBJ")),
    "joined.obj": (THREE + "f 1-2 3\n", REFUSALS["damaged-line"], (4, "OBJ")),
    "nan.obj": ("v nan 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n", REFUSALS["not-finite-line"], (1, 4)),
    "huge.obj": (
        "v 1e40 0 0\nv -1e308 0 0\nv 0 1e308 0\nf 1 2 3\n", REFUSALS["wrong-size"], ("1.4e+308",)
    ),
    "tiny.obj": (
        "v 0 0 0\nv 1e-40 0 0\nv 0 1e-40 0\nf 1 2 3\n", REFUSALS["wrong-size"], ("1.4e-40",)
    ),
    "away.obj": (
        "v 1e150 0 0\nv 1e150 1 0\nv 1e150 0 1\nf 1 2 3\n", REFUSALS["too-far"], ("1e+150", "1e+12")
    ),
    "end.obj": (
        "v -1e308 0 0\nv -1e308 1 0\nv -1e308 0 1\nf 1 2 3\n", REFUSALS["too-far"],
        ("-1e+308", "1e+12"),
    ),
    "face.obj": (
        THREE + "f" + " 1 2 3" * 33_333 + " 1 2\n", REFUSALS["face-size"], (100_001, 100_000),
    ),
    "prose.gltf": ("Dear all\n", REFUSALS["damaged-line"], (1, "JSON")),
    "comma.gltf": ('{"asset":\n{"version": "2.0"},\n,}', REFUSALS["damaged-line"], (3, "JSON")),
    "latin.gltf": ('{"asset": "caf\udce9"}', REFUSALS["damaged"], ("glTF",)),
    "prose.glb": ("Dear all\n", REFUSALS["not-of-kind"], ("GLB",)),
    "list.gltf": ("[]", REFUSALS["damaged"], ("glTF",)),
    "deep.gltf": ("[" * 100_000, REFUSALS["damaged"], ("JSON",)),
    "brackets.gltf": (
        "[" + "[]," * 1_000_000, REFUSALS["brackets"], (1_000_001, 1_000_000),
    ),
    "empty.gltf": ("{}", REFUSALS["damaged"], ("asset",)),
}  # fmt: skip
"""Name of a bad file, its text, the refusal, and what the sentence names beside the file."""
CHANGES: dict[str, tuple[str, Any, str, tuple[object, ...]]] = {
    "kind": ("accessors 0 componentType", ..., REFUSALS["damaged"], ("componentType",)),
    "type": ("accessors 0 type", "MAT4", REFUSALS["damaged"], ("accessors[0]: 5126, MAT4",)),
    "count": ("accessors 0 count", 3000, REFUSALS["damaged"], ("accessors[0]",)),
    "sparse": ("accessors 0 sparse", {}, REFUSALS["damaged"], ("indices",)),
    "view": ("bufferViews 1 byteOffset", 64, REFUSALS["damaged"], ("accessors[1]",)),
    "circle": ("nodes 1 children", [0], REFUSALS["damaged"], ("children",)),
    "turn": ("nodes 1 rotation", [0, 0, 0, 0], REFUSALS["damaged"], ("rotation",)),
    "spin": ("nodes 1 rotation", [0, 0, 1e308, 1e308], REFUSALS["damaged"], ("rotation",)),
    "moved": ("nodes 0 translation", [-1e308, 0, 0], REFUSALS["too-far"], ("-1e+308", "4e+12")),
    "old": ("asset version", "1.0", REFUSALS["unsupported"], ("glTF 1.0",)),
    "packed": (
        "extensionsRequired", ["KHR_draco_mesh_compression"],
        REFUSALS["unsupported"], ("KHR_draco_mesh_compression",),
    ),
    "few": ("meshes 0 primitives 0", {"attributes": {"POSITION": 0}, "indices": 2, "mode": 1},
            REFUSALS["damaged"], ("accessors[2]",)),
    "nothing": ("scenes 0 nodes", [], REFUSALS["no-faces"], (0,)),
}  # fmt: skip
"""The same for a change at one place of a sound glTF description."""


def changed_gltf(path: Path, place: str, value: Any) -> None:
    content, body = gltf_parts(PYRAMID)
    at: Any = content
    *parents, last = (int(key) if key.isdecimal() else key for key in place.split())
    for key in parents:
        at = at[key]
    if value is ...:
        del at[last]
    else:
        at[last] = value
    write_gltf(path, content, body)


@pytest.mark.parametrize("name", TEXTS)
def test_a_bad_text_is_refused_with_its_place(name: str, tmp_path: Path) -> None:
    text, bound, parts = TEXTS[name]
    (tmp_path / name).write_bytes(text.encode(errors="surrogateescape"))
    error = refused(tmp_path / name)
    assert (error.bound, error.limits[1:]) == (bound, parts)


@pytest.mark.parametrize("name", CHANGES)
def test_a_bad_gltf_description_is_refused_with_its_place(name: str, tmp_path: Path) -> None:
    place, value, bound, parts = CHANGES[name]
    changed_gltf(tmp_path / "m.glb", place, value)
    error = refused(tmp_path / "m.glb")
    assert (error.bound, error.limits[1:]) == (bound, parts)


def test_files_that_are_cut_off_are_refused(tmp_path: Path) -> None:
    stl_file(tmp_path / "m.stl", PYRAMID, b"made by a test")
    ply_file(tmp_path / "m.ply", PYRAMID)
    gltf_file(tmp_path / "m.glb", PYRAMID)
    whole = (tmp_path / "m.glb").read_bytes()
    (tmp_path / "m.glb").write_bytes(whole[:-20])
    assert refused(tmp_path / "m.glb").bound == REFUSALS["cut-off"]
    whole = (tmp_path / "m.stl").read_bytes()
    for count, there in ((1, 5), (50, 5), (51, 4), (300, 0)):
        for head in (whole[:80], b"solid part".ljust(80), b"SOLID\n".ljust(80, b"\0")):
            (tmp_path / "m.stl").write_bytes((head + whole[80:])[:-count])
            error = refused(tmp_path / "m.stl")
            assert (error.bound, error.limits[1:]) == (REFUSALS["cut-off-triangles"], (there, 6))
    whole = (tmp_path / "m.ply").read_bytes()
    for count, there in ((1, (4, 5, "face")), (14, (3, 5, "face")), (70, (4, 5, "vertex"))):
        (tmp_path / "m.ply").write_bytes(whole[:-count])
        error = refused(tmp_path / "m.ply")
        assert (error.bound, error.limits[1:]) == (REFUSALS["cut-off-rows"], there)


def test_gltf_vertices_that_are_not_finite_are_refused(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID * [[1], [1], [math.nan], [1], [math.inf]])
    del content["accessors"][0]["min"], content["accessors"][0]["max"]  # JSON has no nan
    write_gltf(tmp_path / "nan.glb", content, body)
    assert refused(tmp_path / "nan.glb").limits[1:] == (2, 5)


@pytest.mark.parametrize("ending", ENDINGS)
def test_what_is_not_a_file_with_bytes_is_refused(ending: str, tmp_path: Path) -> None:
    assert refused(tmp_path / f"gone{ending}").bound == REFUSALS["mesh-no-file"]
    (tmp_path / f"empty{ending}").write_bytes(b"")
    assert refused(tmp_path / f"empty{ending}").bound == REFUSALS["mesh-empty"]
    (tmp_path / f"folder{ending}").mkdir()
    for name in (f"folder{ending}", f"a\0b{ending}", "a" * 300 + ending):
        assert refused(tmp_path / name).bound == REFUSALS["unreadable"]


def test_a_file_without_read_permission_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "mine.obj"
    obj_file(path, PYRAMID)
    path.chmod(0)
    root = hasattr(os, "geteuid") and os.geteuid() == 0
    try:
        if root:  # no mode stops root
            os.seteuid(65534)
        error = refused(path)
    finally:
        if root:
            os.seteuid(0)
        path.chmod(0o600)
    assert error.bound == REFUSALS["unreadable"] and "denied" in str(error)


def test_every_refusal_is_one_sentence_with_what_to_do(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    readers = mesh, mesh_files, ply, gltf, gltf_data, finishing, reading
    templates = {template for template in marked(*readers) if "{0}" in template}
    assert len(templates) > 15
    for template in templates:
        assert template.startswith("{0}: ") and ";" in template and template.endswith(".")
    (tmp_path / "m.obj").write_text("f 1 2 3\n", encoding="utf-8")
    sentence = str(refused(tmp_path / "m.obj"))
    assert sentence.startswith(f"{tmp_path / 'm.obj'}: line 1 names a vertex")
    assert capfd.readouterr() == ("", "")


@POSIX
def test_file_names_need_not_be_utf_8(tmp_path: Path) -> None:
    path = tmp_path / os.fsdecode(b"m\xff.obj")
    obj_file(path, PYRAMID)
    assert len(reading.read(path).points) == 5
    command = [sys.executable, "-m", "app", "matrices", str(path)]
    assert subprocess.run(command, cwd=ROOT, capture_output=True, check=False).returncode == 0
    path.write_bytes(b"v 1\n")
    done = subprocess.run(command, cwd=ROOT, capture_output=True, check=False)
    assert done.returncode == 2 and b"m\\udcff.obj: line 1 cannot" in done.stderr


def test_nothing_in_a_file_commands_the_terminal(tmp_path: Path) -> None:
    changed_gltf(tmp_path / "m.gltf", "asset version", "1\x1b[31m\x07\u202e")
    sentence = str(refused(tmp_path / "m.gltf"))
    assert sentence.isprintable() and "1\\x1b[31m\\x07\\u202e" in sentence


# --------------------------------------------------------------------------- what is opened


@POSIX
def test_pipes_and_devices_are_not_opened(tmp_path: Path) -> None:
    for ending in (".obj", ".json"):
        os.mkfifo(tmp_path / f"pipe{ending}")
        (tmp_path / f"link{ending}").symlink_to(tmp_path / f"pipe{ending}")
        (tmp_path / f"zero{ending}").symlink_to("/dev/zero")
    for name in ("pipe", "link", "zero"):
        assert "not a regular file" in str(refused(tmp_path / f"{name}.obj"))
        with pytest.raises(Refusal, match="not a regular file"):
            read(tmp_path / f"{name}.json")


@pytest.mark.parametrize(
    "address",
    [
        "../m.bin", "sub/../../m.bin", "%2e%2e/m.bin", "/proc/self/environ", "//host/m.bin",
        "C:\\m.bin", "\\\\host\\m.bin", "link.bin", "pipe.bin", "linked/m.bin", ".", "", "gone.bin",
    ],
)  # fmt: skip
def test_gltf_reads_files_of_its_own_folder_only(address: str, tmp_path: Path) -> None:
    folder = tmp_path / "mesh"
    folder.mkdir()
    content, body = gltf_parts(PYRAMID)
    (tmp_path / "m.bin").write_bytes(body)
    if sys.platform != "win32":
        (folder / "link.bin").symlink_to(tmp_path / "m.bin")
        (folder / "linked").symlink_to(tmp_path)
        os.mkfifo(folder / "pipe.bin")
    content["buffers"][0]["uri"] = address
    (folder / "m.gltf").write_text(json.dumps(content), encoding="utf-8")
    assert refused(folder / "m.gltf").bound == REFUSALS["part"]
    (folder / "sub").mkdir()
    (folder / "sub" / "m.bin").write_bytes(body)
    content["buffers"][0]["uri"] = "sub/m.bin"
    (folder / "m.gltf").write_text(json.dumps(content), encoding="utf-8")
    assert len(reading.read(folder / "m.gltf").points) == 5


def test_a_document_of_millions_of_brackets_is_answered_at_once() -> None:
    text = '{"format": "frustum-lab", "version": 1, "more": [' + "[]," * 5_000_000 + "[]]}"
    started = time.process_time()
    with pytest.raises(Refusal, match="more than 100000 values"):
        parse(text)
    assert time.process_time() - started < 2.0


# --------------------------------------------------------------------------- how large it grows


def bomb(folder: Path, nodes: int, primitives: int) -> Path:
    content, body = gltf_parts(PYRAMID)
    content["meshes"][0]["primitives"] *= primitives
    content["nodes"] = [{"mesh": 0, "translation": [i, 0, 0]} for i in range(nodes)]
    content["scenes"][0]["nodes"] = list(range(nodes))
    write_gltf(folder / "m.gltf", content, body)
    return folder / "m.gltf"


def test_a_mesh_that_would_grow_too_large_is_refused_by_its_counts(tmp_path: Path) -> None:
    path = bomb(tmp_path, 50_000, 100)
    content = json.loads(path.read_text(encoding="utf-8"))
    content["buffers"][0]["uri"] = "gone.bin"  # nothing is read before
    path.write_text(json.dumps(content), encoding="utf-8")
    error = refused(path)
    assert error.bound == REFUSALS["too-much"]
    assert error.limits[1::2] == (30_000_000, mesh.LARGEST[0])


def test_a_deep_tree_of_nodes_is_read(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["nodes"] = [{"children": [i + 1]} for i in range(5000)] + [{"mesh": 0}]
    write_gltf(tmp_path / "m.gltf", content, body)
    assert len(reading.read(tmp_path / "m.gltf").points) == 5


def test_a_few_bytes_that_grow_are_read_in_a_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "SMALL_MESH", (100, 2**20))
    found = reading.read(bomb(tmp_path, 20, 2))
    assert len(found.offsets) - 1 == 20 * 2 * 6


@pytest.mark.parametrize("copies", [20_000, 300_000])
def test_triangles_at_one_place_are_reduced_quickly(copies: int, tmp_path: Path) -> None:
    """VTK's locator of cells would look at all of them for each, which takes many minutes."""
    began = time.process_time()
    scene = scene_of_obj(tmp_path, f"{THREE}v 0 0 1\nf 1 2 4\n" + "f 1 2 3\n" * copies)
    for share in shares_for_dragging(scene):
        surface = reduced(scene, share).surface
        assert surface is not None and surface.n_cells > 0
        assert len(surface.cell_data["rgb"]) == surface.n_cells
    assert time.process_time() - began < 60.0


# --------------------------------------------------------------------------- the other process


def test_a_large_file_is_the_same_read_in_a_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ply_file(tmp_path / "m.ply", PYRAMID + 1e7 + 0.1)
    gltf_file(tmp_path / "m.glb", PYRAMID)
    (tmp_path / "m.obj").write_text(THREE + "f 1 2 9\n", encoding="utf-8")
    (tmp_path / "small.obj").write_text(THREE + "f 1 2\nf 1 2 3\nv nan 0 0\n", encoding="utf-8")
    names = ("m.ply", "m.glb", "small.obj")
    here = [reading.read(tmp_path / name) for name in names]
    refusal_here = str(refused(tmp_path / "m.obj"))
    monkeypatch.setattr(reading, "SMALL", 0)
    apart = [reading.read(tmp_path / name) for name in names]
    assert len(apart[-1].notes) == 2
    assert str(refused(tmp_path / "m.obj")) == refusal_here
    for two in zip(here, apart, strict=True):
        assert len(two[0].edges)
        for one, other in zip(two[0][:-1], two[1][:-1], strict=True):
            assert (one == other).all() and one.dtype == other.dtype
        assert two[0].notes == two[1].notes


def test_cancel_ends_the_other_process(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    obj_file(tmp_path / "m.obj", PYRAMID)
    monkeypatch.setattr(reading, "SMALL", 0)
    started: list[subprocess.Popen[Any]] = []
    popen = subprocess.Popen

    def kept(*arguments: Any, **options: Any) -> subprocess.Popen[Any]:
        started.append(popen([sys.executable, "-c", "import time; time.sleep(600)"], **options))
        return started[-1]

    monkeypatch.setattr(subprocess, "Popen", kept)
    answers = iter([True, True, False])
    with pytest.raises(Cancelled):
        reading.read(tmp_path / "m.obj", lambda _: next(answers))
    assert started[0].returncode is not None


def test_the_end_of_the_other_process_is_a_refusal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    obj_file(tmp_path / "m.obj", PYRAMID)
    monkeypatch.setattr(reading, "SMALL", 0)
    popen = subprocess.Popen
    for dying in ("import os; os.abort()", "print('{\"mesh\": {')", "print('{\"done\": 0.1}')"):
        monkeypatch.setattr(
            subprocess, "Popen",
            lambda *_, dying=dying, **options: popen([sys.executable, "-c", dying], **options),
        )  # fmt: skip
        assert refused(tmp_path / "m.obj").bound == REFUSALS["ended"]


@pytest.mark.skipif(sys.platform != "linux", reason="where the system keeps the limit")
def test_too_little_memory_is_a_refusal(tmp_path: Path) -> None:
    (tmp_path / "m.stl").write_bytes(bytes(80) + (4_000_000).to_bytes(4, "little"))
    with (tmp_path / "m.stl").open("r+b") as file:
        file.truncate(84 + 50 * 4_000_000)
    code = (
        "from pathlib import Path; from app.scenes import reading; reading.MEMORY = 600 * 2**20;"
        f"reading.main(Path({str(tmp_path / 'm.stl')!r}))"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, check=False)
    answer = json.loads(done.stdout.splitlines()[-1])
    assert answer["refused"][0] == REFUSALS["no-memory"] and done.stderr == b""


def test_an_error_that_no_reader_foresaw_is_a_refusal(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    obj_file(tmp_path / "m.obj", PYRAMID)

    def broken(*_: object, **_named: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(mesh_files, "Mesh", broken)
    assert refused(tmp_path / "m.obj").limits[1:] == ("ZeroDivisionError",)


@POSIX
def test_hostile_files_are_sound_or_refused_in_one_sentence() -> None:
    """A sample: ``python3 -m tests.fuzz hostile`` opens thousands."""
    command = [sys.executable, "-m", "tests.fuzz", "hostile", "--count", "20", "--seed", "7"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_picture_names_a_mesh_without_its_folder(tmp_path: Path) -> None:
    path = str(tmp_path / "somebody" / "cow.obj")
    for shown in (Document(path), Document("similar-triangles", mesh=path)):
        text = picture_json(shown)
        assert "somebody" not in text and '"cow.obj"' in text
        found = parse(text, tmp_path)
        assert str(tmp_path / "cow.obj") in (found.scene, found.mesh)
