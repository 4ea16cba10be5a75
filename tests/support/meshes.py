"""Mesh files written by hand, and the faces and lines of a scene in world coordinates."""

import base64
import json
import struct
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from app.model.projection import Projection
from app.scenes.own_mesh import cells_of
from app.scenes.scene import Scene

# A square pyramid: one quad and four triangles. All coordinates are multiples of 1/8: at 1e7 from
# the origin they are exact in float64, and lost in float32, whose step there is 1.
PYRAMID = np.array(
    [[0.125, 0, 0.25], [3, 0, 0.375], [3.25, 0, 3], [0.5, 0, 3.125], [1.625, 2.875, 1.5]]
)
TRIANGLES = np.array([[0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0], [0, 1, 2], [0, 2, 3]])
QUAD_AND_TRIANGLES = ([0, 1, 2, 3], [0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0])
FAR = 1e7


def obj_file(path: Path, points: np.ndarray) -> None:
    rows = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    path.write_text(
        "\n".join(rows) + "\nf 1 2 3 4\nf 1 5 2\nf 2 5 3\nf 3 5 4\nf -2 -1 -5\n", encoding="utf-8"
    )


def stl_text_file(path: Path, points: np.ndarray, name: str = "the vertex loop of a facet") -> None:
    text = f"solid {name}\n"
    for corners in points[TRIANGLES].tolist():
        rows = "".join(f"      vertex {x!r} {y!r} {z!r}\n" for x, y, z in corners)
        text += f"  facet normal 0 0 0\n    outer loop\n{rows}    endloop\n  endfacet\n"
    path.write_text(f"{text}endsolid {name}\n", encoding="utf-8")


def stl_file(path: Path, points: np.ndarray, header: bytes = b"solid but binary") -> None:
    data = header.ljust(80) + struct.pack("<I", len(TRIANGLES))
    for corners in points[TRIANGLES]:
        data += struct.pack("<12fH", 0, 0, 0, *corners.ravel(), 0)
    path.write_bytes(data)


def ply_header(
    encoding: str, vertices: int, faces: int, vertex_more: str = "", face_more: str = ""
) -> str:
    return (
        f"ply\nformat {encoding} 1.0\ncomment by a test\nelement vertex {vertices}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"{vertex_more}element face {faces}\nproperty list uchar int vertex_indices\n"
        f"{face_more}end_header\n"
    )


def ply_text_file(path: Path, points: np.ndarray) -> None:
    text = ply_header("ascii", len(points), 5)
    text += "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
    text += "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in QUAD_AND_TRIANGLES)
    path.write_text(text, encoding="utf-8")


def ply_file(path: Path, points: np.ndarray, order: str = "<") -> None:
    encoding = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    data = ply_header(encoding, len(points), 5).encode() + points.astype(order + "f8").tobytes()
    for face in QUAD_AND_TRIANGLES:
        data += struct.pack(f"{order}B{len(face)}i", len(face), *face)
    path.write_bytes(data)


def ply_big_endian_file(path: Path, points: np.ndarray) -> None:
    ply_file(path, points, ">")


def gltf_parts(
    points: np.ndarray,
    translation: list[float] | None = None,
    scale: float = 1.0,
    kind: str = "<u2",
) -> tuple[dict[str, Any], bytes]:
    """A glTF description with a node in a node, and the bytes of its buffer."""
    positions = points.astype("<f4").tobytes()
    indices = TRIANGLES.astype(kind).tobytes()
    content: dict[str, Any] = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [
            {"children": [1], "translation": translation or [0, 0, 0]},
            {"mesh": 0, "scale": [scale] * 3},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
             "min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()},
            {"bufferView": 1, "componentType": {"u1": 5121, "<u2": 5123, "<u4": 5125}[kind],
             "count": TRIANGLES.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)},
        ],
        "buffers": [{"byteLength": len(positions) + len(indices)}],
    }  # fmt: skip
    return content, positions + indices


def glb(content: Any, body: bytes) -> bytes:
    """A binary glTF file."""
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    body += b"\0" * (-len(body) % 4)
    return (
        struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(body))
        + struct.pack("<I4s", len(text), b"JSON") + text
        + struct.pack("<I4s", len(body), b"BIN\0") + body
    )  # fmt: skip


def write_gltf(path: Path, content: dict[str, Any], body: bytes) -> None:
    if path.suffix == ".glb":
        path.write_bytes(glb(content, body))
        return
    data = base64.b64encode(body).decode()
    content["buffers"][0]["uri"] = f"data:application/octet-stream;base64,{data}"
    path.write_text(json.dumps(content), encoding="utf-8")


def gltf_file(path: Path, points: np.ndarray) -> None:
    """The float32 vertices are near 0, and the node moves them to their place."""
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
"""File name, writer and number of faces of the pyramid in each format."""


def pyramid_file(folder: Path, kind: str, offset: float = 0.0) -> Path:
    name, write, _ = WRITERS[kind]
    write(folder / name, PYRAMID + offset)
    return folder / name


# --------------------------------------------------------------------------- what a scene has


def world_points(scene: Scene) -> np.ndarray:
    assert scene.surface is not None
    return np.asarray(scene.surface.points, dtype=np.float64) + np.array(scene.origin)


def faces(scene: Scene) -> list[np.ndarray]:
    """World corners of every face, (k, 3) each."""
    assert scene.surface is not None
    points = world_points(scene)
    offsets, corners = cells_of(scene.surface.GetPolys())
    assert len(offsets) == scene.surface.n_cells + 1
    return [points[corners[a:b]] for a, b in pairwise(offsets.tolist())]


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
    return ends[cells_of(scene.lines.GetLines())[1].reshape(-1, 2)]


def side(face: np.ndarray) -> str:
    """The direction in which an axis-parallel face looks, from the order of its corners."""
    normal = np.cross(face[1] - face[0], face[2] - face[0])
    axis = int(abs(normal).argmax())
    return ("+" if normal[axis] > 0 else "-") + "xyz"[axis]


def outside(projection: Projection, points: Any) -> bool:
    return bool(projection.trace(np.asarray(points, dtype=np.float64)).outside.any())
