"""Read the triangles of a glTF scene: a .gltf file with its parts beside it, or a .glb file."""

from __future__ import annotations

import base64
import json
import math
import os
from pathlib import Path, PurePath, PureWindowsPath
from typing import Any
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import Refusal
from app.scenes.mesh import (
    CUT_OFF,
    DAMAGED_LINE,
    NO_MEMORY,
    NO_SUCH_VERTEX,
    NOT_OF_KIND,
    PAINT_RGB,
    PART,
    UNSUPPORTED,
    Floats,
    Mesh,
    Source,
    full_scale,
    rgb_bytes,
)
from app.strangers import LARGEST_FILE, decode, open_regular

MOST_REPEATED = 25_000
"""Most triangles of a file with fewer bytes than triangles: such a file repeats its parts."""
_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_PACKED = frozenset({"KHR_draco_mesh_compression", "EXT_meshopt_compression"})
_MOST_BRACKETS = 1_000_000
"""Most lists and objects in a description; 100 000 nodes need half as many."""


def read_gltf(source: Source) -> Mesh:
    """Join all triangles of the scene. Each mesh is read once, however many nodes use it."""
    path, data, body = source.path, source.file.read(), b""
    if path.suffix.lower() == ".glb":
        if data[:4] != b"glTF":
            raise Refusal.saying(NOT_OF_KIND, path, "GLB")
        text_end = 20 + int.from_bytes(data[12:16], "little")
        data, body = data[20:text_end], data[text_end + 8 :]
    if data.count(b"[") + data.count(b"{") > _MOST_BRACKETS:
        raise Refusal.saying(NO_MEMORY, path)
    try:
        return _Gltf(source, json.loads(decode(data)[0])).mesh(body)
    except json.JSONDecodeError as error:
        raise Refusal.saying(DAMAGED_LINE, path, error.lineno, "JSON") from None
    except Refusal:
        raise
    except (UnicodeDecodeError, RecursionError):
        source.fail("JSON")
    except (LookupError, AttributeError, TypeError, ValueError, ArithmeticError) as error:
        lacking = str(error.args[0]) if isinstance(error, KeyError) else ""
        source.fail(lacking if lacking.isidentifier() else "glTF")


class _Gltf:
    """The description of a scene; a missing entry raises `KeyError` with its name."""

    def __init__(self, source: Source, content: dict[str, Any]) -> None:
        self._source, self._content = source, content
        self._buffers: list[bytes] = []

    def mesh(self, body: bytes) -> Mesh:
        source, content = self._source, self._content
        version = str(content["asset"]["version"])
        packed = sorted(_PACKED.intersection(content.get("extensionsRequired", ())))
        if packed or not version.startswith("2."):
            raise Refusal.saying(UNSUPPORTED, source.path, ", ".join(packed) or f"glTF {version}")
        nodes = self._nodes()
        sizes = {index: self._size(index) for index in {index for index, _ in nodes}}
        vertices, triangles = (sum(sizes[index][part] for index, _ in nodes) for part in (0, 1))
        source.check_size(vertices, triangles, 3 * triangles)
        self._buffers = self._read_buffers(body)
        most = max(sum(map(len, self._buffers)), MOST_REPEATED)
        source.check_size(vertices, triangles, 3 * triangles, most)
        source.report(0.2)
        meshes: dict[int, Mesh] = {}
        parts = []
        for index, world_from_node in nodes:
            if index not in meshes:
                primitives = self._item("meshes", index)["primitives"]
                meshes[index] = _joined([self._primitive(p) for p in primitives])
            parts.append(_placed(meshes[index], world_from_node))
            source.report(0.3)
        return _joined(parts)

    def _item(self, kind: str, index: Any) -> Any:
        """Return a node, a mesh and so on; refuse the negative indices that Python would accept."""
        if not isinstance(index, int) or index < 0:
            raise IndexError
        return self._content[kind][index]

    def _read_buffers(self, body: bytes) -> list[bytes]:
        """Read the buffers: from the file itself, or from files in its folder."""
        found, path, total = [], self._source.path, 0
        for buffer in self._content.get("buffers", ()):
            address = buffer.get("uri")
            if address is None:
                data = body
            elif address.startswith("data:"):
                data = base64.b64decode(address.partition(",")[2])
            else:
                name = unquote(address)
                if not _is_beside(path, name):
                    raise Refusal.saying(PART, path, name)
                try:
                    with open_regular(path.parent / name) as file:
                        total += os.fstat(file.fileno()).st_size
                        if total > LARGEST_FILE:
                            raise Refusal.saying(NO_MEMORY, path)
                        data = file.read()
                except OSError:
                    raise Refusal.saying(PART, path, name) from None
            if len(data) < buffer["byteLength"]:
                raise Refusal.saying(CUT_OFF, path)
            found.append(data)
        return found

    def _nodes(self) -> list[tuple[int, Floats]]:
        """Return the mesh of each node that has one, and the node's world_from_node (4, 4)."""
        nodes = self._content.get("nodes", [])
        if self._content.get("scenes"):
            roots = self._item("scenes", self._content.get("scene", 0)).get("nodes", [])
        else:
            roots = set(range(len(nodes))).difference(*(n.get("children", ()) for n in nodes))
        waiting = [(root, np.eye(4)) for root in roots]
        found = []
        for index, world_from_parent in waiting:  # the list grows meanwhile
            node = self._item("nodes", index)
            world_from_node = world_from_parent @ _parent_from_node(node)
            if "mesh" in node:
                found.append((node["mesh"], world_from_node))
            waiting += [(child, world_from_node) for child in node.get("children", ())]
            if len(waiting) > len(nodes):
                self._source.fail("children")  # a node is its own descendant
        return found

    def _size(self, mesh: int) -> tuple[int, int]:
        """Return the most vertices and triangles of a mesh, before any data is read."""
        vertices = triangles = 0
        for primitive in self._item("meshes", mesh)["primitives"]:
            position = self._count(primitive["attributes"]["POSITION"])
            corners = self._count(primitive["indices"]) if "indices" in primitive else position
            vertices += min(position, corners)
            mode = primitive.get("mode", 4)
            triangles += corners // 3 if mode == 4 else corners if mode in (5, 6) else 0
        return vertices, triangles

    def _count(self, accessor: int) -> int:
        count = self._item("accessors", accessor)["count"]
        if not isinstance(count, int) or count < 1:
            raise ValueError
        return count

    def _primitive(self, primitive: dict[str, Any]) -> Mesh:
        """Return the triangles of a primitive; none if it consists of points or lines."""
        attributes = primitive["attributes"]
        points = self._values(attributes["POSITION"])
        if points.shape[1] != 3:
            raise ValueError
        colours = None
        if "COLOR_0" in attributes:
            linear = self._values(attributes["COLOR_0"])[:, :3]
            if linear.shape != points.shape:
                raise ValueError
            colours = _srgb(linear.astype(np.float64) / full_scale(linear.dtype))
        order = np.arange(len(points))
        if "indices" in primitive:
            indices = self._values(primitive["indices"])
            if indices.dtype.kind != "u" or indices.shape[1] != 1:
                raise ValueError
            order = indices.ravel().astype(np.int64)
            if len(order) < len(points) and order.max() < len(points):  # a part of a shared list
                used, order = np.unique(order, return_inverse=True)
                points = points[used]
                colours = None if colours is None else colours[used]
        triangles = _triangles(order, primitive.get("mode", 4))
        if len(triangles) and triangles.max() >= len(points):  # not a vertex of the next mesh
            raise Refusal.saying(NO_SUCH_VERTEX, self._source.path, len(points))
        offsets = np.arange(0, triangles.size + 1, 3)
        mesh = Mesh(points.astype(np.float64), offsets, triangles.ravel())
        if colours is not None:
            mesh.paint(colours)
        if mesh.rgb is None:
            rgb = np.array(self._paint(primitive), dtype=np.uint8)
            mesh.rgb = np.tile(rgb, (len(triangles), 1))
        return mesh

    def _paint(self, primitive: dict[str, Any]) -> Any:
        """Return the colour of a primitive's material."""
        if "material" not in primitive:
            return PAINT_RGB
        material = self._item("materials", primitive["material"]).get("pbrMetallicRoughness", {})
        factor = np.array(material.get("baseColorFactor", (1, 1, 1))[:3], dtype=np.float64)
        # A mesh without colours is white, as is one with a texture.
        return PAINT_RGB if (factor.reshape(3) == 1.0).all() else rgb_bytes(_srgb(factor))

    def _values(self, index: int) -> NDArray[Any]:
        """Return the values of an accessor, a row for each element."""
        accessor = self._item("accessors", index)
        if "sparse" in accessor or "bufferView" not in accessor:
            raise Refusal.saying(UNSUPPORTED, self._source.path, "sparse")
        view = self._item("bufferViews", accessor["bufferView"])
        first, buffer = view.get("byteOffset", 0), view["buffer"]
        if buffer not in range(len(self._buffers)) or first < 0:
            raise IndexError
        data = memoryview(self._buffers[buffer])[first : first + view["byteLength"]]
        component, width = accessor["componentType"], accessor["type"]
        if component not in _TYPES or width not in _WIDTHS:
            raise ValueError
        kind, parts, count = np.dtype(_TYPES[component]), _WIDTHS[width], self._count(index)
        stride = view.get("byteStride", kind.itemsize * parts)
        start = accessor.get("byteOffset", 0)
        end = start + (count - 1) * stride + kind.itemsize * parts
        if start < 0 or stride < 1 or end > len(data):
            self._source.fail(f"accessors[{index}]")
        return np.ndarray((count, parts), kind, data, start, (stride, kind.itemsize))


def _joined(parts: list[Mesh]) -> Mesh:
    """Join meshes of triangles, with colours."""
    first_point = np.cumsum([0] + [len(part.points) for part in parts])
    corners = [part.corners + at for part, at in zip(parts, first_point[:-1], strict=True)]
    joined = np.concatenate([np.empty(0, dtype=np.int64), *corners])
    return Mesh(
        np.concatenate([np.empty((0, 3)), *(part.points for part in parts)]),
        np.arange(0, len(joined) + 1, 3),
        joined,
        np.concatenate([np.empty((0, 3), dtype=np.uint8),
                        *(part.rgb for part in parts if part.rgb is not None)]),
        painted=all(part.painted for part in parts if len(part.corners)),
    )  # fmt: skip


def _placed(mesh: Mesh, world_from_node: Floats) -> Mesh:
    triangles = mesh.corners.reshape(-1, 3)
    if np.linalg.det(world_from_node[:3, :3]) < 0.0:  # a mirror turns faces inside out
        triangles = triangles[:, ::-1]
    points = mesh.points @ world_from_node[:3, :3].T + world_from_node[:3, 3]
    return Mesh(points, mesh.offsets, triangles.ravel(), mesh.rgb, mesh.painted)


def _is_beside(path: Path, name: str) -> bool:
    """Whether a name leads to a place in a file's own folder, or in one below it."""
    for kind in (PurePath, PureWindowsPath):  # even checking a network path would connect to it
        pure = kind(name)
        if pure.drive or pure.root or ".." in pure.parts:
            return False
    folder = os.path.realpath(path.parent)
    return os.path.commonpath([folder, os.path.realpath(path.parent / name)]) == folder


def _parent_from_node(node: dict[str, Any]) -> Floats:
    """Return parent_from_node (4, 4)."""
    if "matrix" in node:  # written column by column
        return np.array(node["matrix"], dtype=np.float64).reshape(4, 4).T
    turn = np.array(node.get("rotation", (0.0, 0.0, 0.0, 1.0)), dtype=np.float64)
    length = np.linalg.norm(turn)
    if not 0.0 < length < math.inf:
        raise ValueError
    x, y, z, w = turn / length
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    scale, translation = (
        np.array(node.get(name, (default,) * 3), dtype=np.float64).reshape(3)
        for name, default in (("scale", 1.0), ("translation", 0.0))
    )
    parent_from_node = np.eye(4)
    parent_from_node[:3, :3] = rotation * scale
    parent_from_node[:3, 3] = translation
    return parent_from_node


def _triangles(order: NDArray[np.int64], mode: Any) -> NDArray[np.int64]:
    """Return the triangles (n, 3) of a list, a strip or a fan of vertices."""
    i = np.arange(max(len(order) - 2, 0))
    if mode == 4:
        return order[: len(order) // 3 * 3].reshape(-1, 3)
    if mode == 5:  # a strip: every other triangle runs the other way round
        return np.stack([order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]], axis=1)
    if mode == 6:  # a fan about the first vertex
        return np.stack([order[i * 0], order[i + 1], order[i + 2]], axis=1)
    return np.empty((0, 3), dtype=np.int64)


def _srgb(linear: Floats) -> Floats:
    """Turn linear light from 0 to 1, which glTF stores, into sRGB from 0 to 255."""
    linear = np.clip(linear, 0.0, 1.0)
    return 255.0 * np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055
    )
