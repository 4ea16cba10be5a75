"""Read a glTF 2.0 scene: a .gltf file with its parts beside it, or a .glb file.

The shape is that of the file at rest: default morph weights, joints where their nodes are, and no
animation. Section numbers are those of the glTF 2.0 specification.
"""

import json
import re
from collections.abc import Iterable
from functools import cache
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import REFUSALS, Refusal
from app.scenes.gltf_data import GltfData
from app.scenes.mesh import PAINT_RGB, Floats, Ints, Mesh, MeshSource, joins_left_out, rgb_bytes
from app.scenes.shapes import DRAWN_RGB, flat
from app.strangers import decode

_STILL = {"rotation": (0.0, 0.0, 0.0, 1.0), "scale": (1.0,) * 3, "translation": (0.0,) * 3}
"""The default turn, scale and move of a node, and of a copy of a mesh."""
_READ = re.compile(  # extensions that this module reads, or that change no shape
    "KHR_mesh_quantization|KHR_node_visibility|EXT_mesh_gpu_instancing"
    r"|[A-Z]+_(animation|image|lights|materials|techniques?|texture|xmp)\w*"
)
_DRACO = "KHR_draco_mesh_compression"
_MOST_BRACKETS = 1_000_000  # most lists and objects in a description; 100 000 nodes need half of it
_OVERHEAD = 400  # vertices that take as long to read as a primitive takes without any
_INFLUENCES = 1 << 18  # joints of vertices that are applied at a time

_Use: TypeAlias = tuple[int, int | None, tuple[float, ...] | None]
"""A mesh, and the skin and weights of its node: what determines the shape, apart from its place."""


def read_gltf(source: MeshSource) -> Mesh:
    """Join all shapes of the scene. Each is read once, however many nodes use it."""
    path, data, body = source.path, source.file.read(), b""
    if data[:4] == b"glTF":
        data, body = _chunks(source, data)
    elif path.suffix.lower() == ".glb":
        raise Refusal.saying(REFUSALS["not-of-kind"], path, "GLB")
    if (count := data.count(b"[") + data.count(b"{")) > _MOST_BRACKETS:
        raise Refusal.saying(REFUSALS["brackets"], path, count, _MOST_BRACKETS)
    try:
        return _Gltf(source, json.loads(decode(data)[0]), body).mesh()
    except json.JSONDecodeError as error:
        raise Refusal.saying(REFUSALS["damaged-line"], path, error.lineno, "JSON") from None
    except Refusal:
        raise
    except (UnicodeDecodeError, RecursionError):
        source.fail("JSON")
    except (LookupError, AttributeError, TypeError, ValueError, ArithmeticError) as error:
        lacking = str(error.args[0]) if isinstance(error, KeyError) else ""
        source.fail(lacking if lacking.isidentifier() else "glTF")


def _chunks(source: MeshSource, data: bytes) -> tuple[bytes, bytes]:
    """Return the description in a .glb file, and the buffer after it."""
    version, size = (int.from_bytes(data[at : at + 4], "little") for at in (4, 12))
    if version != 2:
        raise Refusal.saying(REFUSALS["unsupported"], source.path, f"glTF {version}.0")
    end = 20 + size
    if len(data) < end:
        raise Refusal.saying(REFUSALS["cut-off"], source.path)
    size = int.from_bytes(data[end : end + 4], "little")
    is_buffer = data[end + 4 : end + 8] == b"BIN\0"
    return data[20:end], data[end + 8 : end + 8 + size] if is_buffer else b""


class _MeshSize(NamedTuple):
    """The counts of a mesh.

    - `targets`, `sets`: most morph targets and most sets of four joints of a primitive.
    """

    vertices: int
    elements: int  # most triangles, lines and points
    targets: int
    sets: int
    weights: int  # default morph weights that are not 0
    overhead: int  # vertices that take as long as its primitives and targets do without any


class _Gltf:
    """The description of a scene; a missing entry raises `KeyError` with its name."""

    def __init__(self, source: MeshSource, content: dict[str, Any], body: bytes) -> None:
        asset = content["asset"]
        version, least = str(asset["version"]), str(asset.get("minVersion", "2.0"))
        unread = sorted(e for e in content.get("extensionsRequired", ()) if not _READ.fullmatch(e))
        if not version.startswith("2.") or least != "2.0":
            unread = [f"glTF {version if least == '2.0' else least}"]
        if unread:
            raise Refusal.saying(REFUSALS["unsupported"], source.path, ", ".join(unread))
        self._source, self._content = source, content
        self._data = GltfData(source, content, body)
        self._nodes: list[dict[str, Any]] = content.get("nodes", [])
        self._world_from_node, self._roots = self._world_from_nodes()

    def mesh(self) -> Mesh:
        source = self._source
        uses: dict[_Use, list[int]] = {}
        for index in self._shown():
            node = self._nodes[index]
            if "mesh" in node:
                weights = tuple(node["weights"]) if "weights" in node else None
                uses.setdefault((node["mesh"], node.get("skin"), weights), []).append(index)
        self._check_size(uses)
        source.report(0.2)
        world_from_bind = cache(self._world_from_bind)
        parts = []
        for (index, skin, weights), users in uses.items():
            places = np.concatenate([self._places(user) for user in users])
            mesh = self._data.item("meshes", index)
            for primitive in _drawn(mesh):
                is_skinned = skin is not None and "JOINTS_0" in primitive["attributes"]
                joints = world_from_bind(skin) if is_skinned else None
                shape = self._primitive(primitive, weights or mesh.get("weights", ()), joints)
                # The node of a mesh with a skin has no effect (s. 3.7.3.3).
                still = np.broadcast_to(np.eye(4), places.shape)
                parts.append(_placed(shape, still if is_skinned else places))
            source.report(0.3)
        joined = _joined(parts)
        joined.drop_small_faces(source.path)
        return joined

    # ----------------------------------------------------------------------- nodes

    def _world_from_nodes(self) -> tuple[Floats, list[int]]:
        """Return world_from_node (n, 4, 4) of all nodes, and the nodes without a parent."""
        nodes, above = self._nodes, [-1] * len(self._nodes)
        for index, node in enumerate(nodes):
            for child in node.get("children", ()):
                self._data.item("nodes", child)
                if above[child] >= 0:
                    self._source.fail("children")  # of two nodes
                above[child] = index
        world_from_node = self._parent_from_nodes()
        ancestor = np.array(above, dtype=np.int64)
        for _ in range(len(nodes).bit_length() + 1):  # each step doubles the ancestor's distance
            below = np.flatnonzero(ancestor >= 0)
            if not below.size:
                return world_from_node, [i for i, parent in enumerate(above) if parent < 0]
            reached = ancestor[below]
            world_from_node[below] = world_from_node[reached] @ world_from_node[below]
            ancestor[below] = ancestor[reached]
        self._source.fail("children")  # a node is its own descendant

    def _parent_from_nodes(self) -> Floats:
        """Return parent_from_node (n, 4, 4) of all nodes."""
        nodes = self._nodes
        turns, scales, moves = (
            np.array([node.get(name, default) for node in nodes], dtype=np.float64).reshape(
                len(nodes), len(default)
            )
            for name, default in _STILL.items()
        )
        parent_from_node = self._matrices(turns, scales, moves)
        for index, node in enumerate(nodes):
            if "matrix" in node:  # written column by column
                parent_from_node[index] = np.array(node["matrix"], dtype=np.float64).reshape(4, 4).T
        return parent_from_node

    def _matrices(self, turns: Floats, scales: Floats, moves: Floats) -> Floats:
        """Return matrices (n, 4, 4) that scale, then turn by quaternions (n, 4), then move."""
        length = np.linalg.norm(turns, axis=1, keepdims=True)
        if not ((length > 0.0) & (length < np.inf)).all():
            self._source.fail("rotation")
        x, y, z, w = (turns / length).T
        matrices = np.zeros((len(turns), 4, 4))
        matrices[:, :3, :3] = np.moveaxis(
            np.array(
                [
                    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
                ]
            ), 2, 0,
        ) * scales[:, None, :]  # fmt: skip
        matrices[:, :3, 3], matrices[:, 3, 3] = moves, 1.0
        return matrices

    def _shown(self) -> Iterable[int]:
        """Return the nodes of the scene; all nodes if there are no scenes."""
        roots = self._roots
        if self._content.get("scenes"):
            roots = self._data.item("scenes", self._content.get("scene", 0)).get("nodes", [])
        waiting, shown = list(roots), dict[int, None]()
        for index in waiting:  # the list grows meanwhile
            node = self._data.item("nodes", index)
            visible = node.get("extensions", {}).get("KHR_node_visibility", {}).get("visible", True)
            if index not in shown and visible:
                shown[index] = None
                waiting += node.get("children", ())
        return shown

    def _copies(self, node: int) -> tuple[dict[str, int], int]:
        """Return the accessors that place the copies of a node's mesh, and the number of copies."""
        extension = self._nodes[node].get("extensions", {}).get("EXT_mesh_gpu_instancing")
        if extension is None:
            return {}, 1
        accessors = extension.get("attributes", {})
        accessors = {name: accessors[name.upper()] for name in _STILL if name.upper() in accessors}
        counts = {self._data.count(accessor) for accessor in accessors.values()} or {1}
        if len(counts) > 1:
            self._source.fail("EXT_mesh_gpu_instancing")
        return accessors, counts.pop()

    def _places(self, node: int) -> Floats:
        """Return world_from_mesh (n, 4, 4) of the copies of a node's mesh."""
        accessors, copies = self._copies(node)
        if not accessors:
            return self._world_from_node[node : node + 1]
        turns, scales, moves = (
            self._data.numbers(accessors[name], f"VEC{len(default)}") if name in accessors
            else np.tile(default, (copies, 1))
            for name, default in _STILL.items()
        )  # fmt: skip
        return np.asarray(self._world_from_node[node] @ self._matrices(turns, scales, moves))

    def _world_from_bind(self, index: int) -> Floats:
        """Return how each joint of a skin moves the vertices (n, 4, 4)."""
        skin = self._data.item("skins", index)
        for joint in skin["joints"]:
            self._data.item("nodes", joint)
        world_from_bind: Floats = self._world_from_node[skin["joints"]]
        if "inverseBindMatrices" in skin:
            columns = self._data.numbers(skin["inverseBindMatrices"], "MAT4")
            if len(columns) < len(world_from_bind):
                self._source.fail("inverseBindMatrices")
            joint_from_bind = columns[: len(world_from_bind)].reshape(-1, 4, 4).swapaxes(1, 2)
            world_from_bind = world_from_bind @ joint_from_bind
        return world_from_bind

    # ----------------------------------------------------------------------- sizes

    def _check_size(self, uses: dict[_Use, list[int]]) -> None:
        """Refuse a scene that grows too large, before any data is read."""
        sizes = {mesh: self._size(mesh) for mesh in {mesh for mesh, _, _ in uses}}
        vertices = elements = 0
        for (mesh, skin, weights), users in uses.items():
            size, copies = sizes[mesh], sum(self._copies(user)[1] for user in users)
            applied = size.weights if weights is None else sum(map(bool, weights))
            work = min(applied, size.targets) + (2 * size.sets if skin is not None else 0)
            vertices += size.vertices * (copies + work) + size.overhead
            elements += size.elements * copies
        self._source.check_size(vertices, elements, 3 * elements)

    def _size(self, index: int) -> _MeshSize:
        mesh = self._data.item("meshes", index)
        vertices = elements = targets = sets = overhead = 0
        for primitive in _drawn(mesh):
            attributes, position = primitive["attributes"], primitive["attributes"]["POSITION"]
            is_packed = "bufferView" not in self._data.item("accessors", position)
            if is_packed and _DRACO in primitive.get("extensions", ()):
                raise Refusal.saying(REFUSALS["unsupported"], self._source.path, _DRACO)
            points = corners = self._data.count(position)
            if "indices" in primitive:
                corners = self._data.count(primitive["indices"])
            vertices += min(points, corners)
            mode = primitive.get("mode", 4)
            if mode not in range(7):
                self._source.fail("mode")
            elements += corners // {1: 2, 4: 3}.get(mode, 1)
            targets = max(targets, len(primitive.get("targets", ())))
            sets = max(sets, sum(name.startswith("JOINTS_") for name in attributes))
            overhead += _OVERHEAD + targets + sets
        weights = sum(map(bool, mesh.get("weights", ())))
        return _MeshSize(vertices, elements, targets, sets, weights, overhead)

    # ----------------------------------------------------------------------- shapes

    def _primitive(
        self, primitive: dict[str, Any], weights: Iterable[float], joints: Floats | None
    ) -> Mesh:
        count = self._data.count(primitive["attributes"]["POSITION"])
        used: Any = slice(None)
        if "indices" in primitive:
            indices = self._data.values(primitive["indices"], "SCALAR")
            if indices.dtype.kind != "u":
                self._source.fail(f"accessors[{primitive['indices']}].componentType")
            order = indices.ravel().astype(np.int64)
            if len(order) < count and order.max() < count:  # a part of a shared list
                used, order = np.unique(order, return_inverse=True)
        else:
            order = np.arange(count)
        points = self._attribute("POSITION", primitive, used, weights, "VEC3")
        mode = primitive.get("mode", 4)
        triangles = _triangles(order, mode)
        if order.max() >= len(points):  # not a vertex of the next mesh
            raise Refusal.saying(REFUSALS["no-such-vertex"], self._source.path, len(points))
        if joints is not None:
            mirrored = self._move_by_joints(points, primitive, used, joints)
            triangles = _turned_over(triangles, mirrored[triangles[:, :1]])
        mesh = Mesh(points, np.arange(0, triangles.size + 1, 3), triangles.ravel())
        mesh.lines, mesh.dots = _lines(order, mode), order[: len(order) if mode == 0 else 0]
        paint = self._paint(primitive)
        mesh.rgb = flat(PAINT_RGB if paint is None else paint, len(triangles))
        mesh.dot_rgb = None if paint is None else flat(paint, len(mesh.dots))
        if "COLOR_0" in primitive["attributes"]:
            linear = self._attribute("COLOR_0", primitive, used, weights, "VEC3", "VEC4")
            mesh.paint(_srgb(linear[:, :3]))
        return mesh

    def _attribute(
        self, name: str, primitive: dict[str, Any], used: Any, weights: Iterable[float], *types: str
    ) -> Floats:
        """Return an attribute of the used vertices, moved by the morph targets (s. 3.7.2.2)."""
        attributes, numbers = primitive["attributes"], self._data.numbers
        targets = primitive.get("targets", ())
        moves = [(w, t[name]) for w, t in zip(weights, targets, strict=False) if w and name in t]
        count = self._data.count(attributes["POSITION"])
        for accessor in (attributes[name], *(target for _, target in moves)):
            if self._data.count(accessor) != count:
                self._source.fail(f"accessors[{accessor}].count")
        is_colour = name == "COLOR_0"
        values = numbers(attributes[name], *types, used=used, normalized=is_colour)
        for weight, target in moves:
            values += weight * numbers(target, *types, used=used, normalized=is_colour)
        return values

    def _move_by_joints(
        self, points: Floats, primitive: dict[str, Any], used: Any, world_from_bind: Floats
    ) -> NDArray[np.bool_]:
        """Move points (n, 3) by their joints (s. 3.7.3.3); return which become mirrored (n,)."""
        attributes, data = primitive["attributes"], self._data
        count, sets = data.count(attributes["POSITION"]), 0
        joints, weights = [], []
        while f"JOINTS_{sets}" in attributes:
            pair = attributes[f"JOINTS_{sets}"], attributes[f"WEIGHTS_{sets}"]
            for accessor in pair:
                if data.count(accessor) != count:
                    self._source.fail(f"accessors[{accessor}].count")
            joints.append(data.values(pair[0], "VEC4")[used])
            weights.append(data.numbers(pair[1], "VEC4", used=used, normalized=True))
            sets += 1
        joint, weight = np.concatenate(joints, axis=1), np.concatenate(weights, axis=1)
        joint = np.where(weight == 0.0, 0, joint)  # a joint without weight may be any number
        if joint.dtype.kind != "u" or joint.max() >= len(world_from_bind) or weight.min() < 0.0:
            self._source.fail("JOINTS_0, WEIGHTS_0")
        total = weight.sum(axis=1, keepdims=True)
        weight[total[:, 0] == 0.0, 0] = 1.0
        weight /= np.where(total == 0.0, 1.0, total)  # exporters round them
        mirrored = np.empty(len(points), dtype=bool)
        step = max(1, _INFLUENCES // joint.shape[1])
        for first in range(0, len(points), step):
            part = slice(first, first + step)
            moves = np.einsum("ni,nijk->njk", weight[part], world_from_bind[joint[part], :3])
            points[part] = (moves[:, :, :3] @ points[part, :, None])[:, :, 0] + moves[:, :, 3]
            mirrored[part] = np.linalg.det(moves[:, :, :3]) < 0.0
        return mirrored

    def _paint(self, primitive: dict[str, Any]) -> Any:
        """Return the colour of a primitive's material, if it has one."""
        if "material" not in primitive:
            return None
        material = self._data.item("materials", primitive["material"])
        factors = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", (1, 1, 1))
        factor = np.array(factors[:3], dtype=np.float64)
        # A mesh without colours is white, as is one with a texture.
        return None if (factor.reshape(3) == 1.0).all() else tuple(rgb_bytes(_srgb(factor)))


def _drawn(mesh: dict[str, Any]) -> list[dict[str, Any]]:
    """Return the primitives of a mesh that have positions; others are not drawn (s. 3.7.2.1)."""
    return [each for each in mesh["primitives"] if "POSITION" in each["attributes"]]


def _joined(parts: list[Mesh]) -> Mesh:
    parts = [Mesh(rgb=flat(PAINT_RGB, 0)), *parts]
    first = np.cumsum([0] + [len(part.points) for part in parts])
    corners, lines, dots = (
        np.concatenate([getattr(part, name) + at for part, at in zip(parts, first, strict=False)])
        for name in ("corners", "lines", "dots")
    )
    points, rgb = (
        np.concatenate([getattr(part, name) for part in parts]) for name in ("points", "rgb")
    )
    dot_rgb = None
    if any(len(part.dots) and part.dot_rgb is not None for part in parts):
        dot_rgb = np.concatenate(
            [flat(DRAWN_RGB, len(p.dots)) if p.dot_rgb is None else p.dot_rgb for p in parts]
        )
    painted = all(part.painted for part in parts if len(part.corners))
    offsets = np.arange(0, len(corners) + 1, 3)
    return Mesh(points, offsets, corners, rgb, painted, lines, dots, dot_rgb)


def _placed(mesh: Mesh, world_from_mesh: Floats) -> Mesh:
    """Return copies of a mesh, one for each matrix (n, 4, 4)."""
    copies = len(world_from_mesh)
    turns = world_from_mesh[:, :3, :3]
    points = mesh.points @ turns.swapaxes(1, 2) + world_from_mesh[:, None, :3, 3]
    mirrored = np.linalg.det(turns)[:, None, None] < 0.0
    first = len(mesh.points) * np.arange(copies)[:, None, None]
    corners = _turned_over(mesh.corners.reshape(-1, 3), mirrored)
    corners += first
    colours = mesh.rgb, mesh.dot_rgb
    rgb, dot_rgb = (None if each is None else np.tile(each, (copies, 1)) for each in colours)
    return Mesh(
        points.reshape(-1, 3), np.arange(0, corners.size + 1, 3), corners.ravel(), rgb,
        mesh.painted, (mesh.lines + first).reshape(-1, 2), (mesh.dots + first).ravel(), dot_rgb,
    )  # fmt: skip


def _turned_over(triangles: Ints, mirrored: NDArray[np.bool_]) -> Ints:
    """Reverse triangles (n, 3) where a mirror turned them inside out."""
    return np.where(mirrored, triangles[:, ::-1], triangles)


def _triangles(order: Ints, mode: int) -> Ints:
    """Return the triangles (n, 3) of a list, a strip or a fan of vertices."""
    i = np.arange(max(len(order) - 2, 0))
    if mode == 4:
        return order[: len(order) // 3 * 3].reshape(-1, 3)
    if mode == 5:  # a strip: every other triangle runs the other way round
        odd = i % 2
        return joins_left_out(np.stack([order[i], order[i + 1 + odd], order[i + 2 - odd]], axis=1))
    if mode == 6:  # a fan about the first vertex
        return np.stack([order[i * 0], order[i + 1], order[i + 2]], axis=1)
    return np.empty((0, 3), dtype=np.int64)


def _lines(order: Ints, mode: int) -> Ints:
    """Return the ends (n, 2) of separate lines, of a closed path or of an open one."""
    if mode == 1:
        return order[: len(order) // 2 * 2].reshape(-1, 2)
    if mode in (2, 3):
        return np.stack([order, np.roll(order, -1)], axis=1)[: len(order) - (mode == 3)]
    return np.empty((0, 2), dtype=np.int64)


def _srgb(linear: Floats) -> Floats:
    """Turn linear light from 0 to 1, which glTF stores, into sRGB from 0 to 255."""
    linear = np.clip(linear, 0.0, 1.0)
    curved = 1.055 * linear ** (1 / 2.4) - 0.055
    return 255.0 * np.where(linear <= 0.0031308, 12.92 * linear, curved)
