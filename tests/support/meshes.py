"""Files of meshes, written by hand."""

from __future__ import annotations

import base64
import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

PYRAMID = np.array(
    [[0.125, 0, 0.25], [3, 0, 0.375], [3.25, 0, 3], [0.5, 0, 3.125], [1.625, 2.875, 1.5]]
)
TRIANGLES = np.array([[0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0], [0, 1, 2], [0, 2, 3]])


def obj_file(path: Path, points: np.ndarray) -> None:
    rows = [f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist()]
    path.write_text("\n".join(rows) + "\nf 1 2 3 4\nf 1 5 2\nf 2 5 3\nf 3 5 4\nf -2 -1 -5\n")


def ply_header(
    encoding: str, vertices: int, faces: int, vertex_more: str = "", face_more: str = ""
) -> str:
    return (
        f"ply\nformat {encoding} 1.0\ncomment by a test\nelement vertex {vertices}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"{vertex_more}element face {faces}\nproperty list uchar int vertex_indices\n"
        f"{face_more}end_header\n"
    )


QUAD_AND_TRIANGLES = ([0, 1, 2, 3], [0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0])


def ply_file(path: Path, points: np.ndarray, order: str = "<") -> None:
    encoding = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    data = ply_header(encoding, len(points), 5).encode() + points.astype(order + "f8").tobytes()
    for face in QUAD_AND_TRIANGLES:
        data += struct.pack(f"{order}B{len(face)}i", len(face), *face)
    path.write_bytes(data)


def gltf_parts(
    points: np.ndarray, translation: list[float] | None = None, scale: float = 1.0
) -> tuple[dict[str, Any], bytes]:
    """A glTF description with a node in a node, and the bytes of its buffer."""
    positions = points.astype("<f4").tobytes()
    indices = TRIANGLES.astype("<u2").tobytes()
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
            {"bufferView": 1, "componentType": 5123, "count": TRIANGLES.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)},
        ],
        "buffers": [{"byteLength": len(positions) + len(indices)}],
    }  # fmt: skip
    return content, positions + indices


def write_gltf(path: Path, content: dict[str, Any], body: bytes) -> None:
    if path.suffix == ".gltf":
        address = "data:application/octet-stream;base64," + base64.b64encode(body).decode()
        content["buffers"][0]["uri"] = address
        path.write_text(json.dumps(content))
        return
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    body += b"\0" * (-len(body) % 4)
    path.write_bytes(
        struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(body))
        + struct.pack("<I4s", len(text), b"JSON")
        + text
        + struct.pack("<I4s", len(body), b"BIN\0")
        + body
    )
