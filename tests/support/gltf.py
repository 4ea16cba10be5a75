"""glTF files written by hand, number by number."""

from pathlib import Path
from typing import Any

import numpy as np

from tests.support.meshes import write_gltf

SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
TYPES = {"i1": 5120, "u1": 5121, "<i2": 5122, "<u2": 5123, "<u4": 5125, "<f4": 5126}
WIDTHS = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class GltfSquare:
    """A glTF file of two triangles at z = 0, to be changed by a test."""

    def __init__(self) -> None:
        self.body = b""
        self.content: dict[str, Any] = {
            "asset": {"version": "2.0"}, "buffers": [{}], "bufferViews": [], "accessors": [],
            "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        }  # fmt: skip
        positions, indices = self.add(SQUARE), self.add([0, 1, 2, 0, 2, 3], "<u2")
        self.primitive: dict[str, Any] = {"attributes": {"POSITION": positions}, "indices": indices}
        self.mesh: dict[str, Any] = {"primitives": [self.primitive]}
        self.content["meshes"] = [self.mesh]

    def view(self, values: Any, kind: str) -> dict[str, int]:
        data = np.array(values, dtype=kind).tobytes()
        views = self.content["bufferViews"]
        views.append({"buffer": 0, "byteOffset": len(self.body), "byteLength": len(data)})
        self.body += data + b"\0" * (-len(data) % 4)
        self.content["buffers"][0]["byteLength"] = len(self.body)
        return {"bufferView": len(views) - 1}

    def add(self, values: Any, kind: str = "<f4", **more: Any) -> int:
        """Add an accessor; return its index."""
        rows = np.array(values).reshape(len(values), -1)
        accessor = {"componentType": TYPES[kind], "count": len(rows), "type": WIDTHS[rows.shape[1]]}
        self.content["accessors"].append(accessor | self.view(rows, kind) | more)
        return len(self.content["accessors"]) - 1

    def sparse(self, places: list[int], values: Any, kind: str = "<u2") -> dict[str, Any]:
        indices = self.view(places, kind) | {"componentType": TYPES[kind]}
        return {"count": len(places), "indices": indices, "values": self.view(values, "<f4")}

    def add_skin(
        self,
        joints: Any,
        weights: Any,
        nodes: list[dict[str, Any]],
        kind: str = "<f4",
        bind: Any = None,
    ) -> None:
        """Add a skin whose joints are new nodes, and sets of four joints a vertex."""
        first = len(self.content["nodes"])
        skin: dict[str, Any] = {"joints": list(range(first, first + len(nodes)))}
        self.content["nodes"] += nodes
        self.content["nodes"][0]["skin"] = 0
        self.content["skins"] = [skin]
        if bind is not None:
            skin["inverseBindMatrices"] = self.add(bind)
        attributes = self.primitive["attributes"]
        joints, weights = (np.array(each).reshape(4, -1, 4) for each in (joints, weights))
        for i in range(joints.shape[1]):
            attributes[f"JOINTS_{i}"] = self.add(joints[:, i], "u1")
            attributes[f"WEIGHTS_{i}"] = self.add(weights[:, i], kind, normalized=kind != "<f4")

    def write(self, path: Path) -> Path:
        write_gltf(path, self.content, self.body)
        return path
