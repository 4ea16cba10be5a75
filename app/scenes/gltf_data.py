"""Read the numbers of a glTF file: its buffers, the views of them, and the accessors (s. 3.6)."""

import base64
import os
from pathlib import Path, PurePath, PureWindowsPath
from typing import Any
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import REFUSALS, Refusal
from app.scenes.mesh import Floats, MeshSource, full_scale
from app.strangers import LARGEST_FILE, open_regular

_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class GltfData:
    """The accessors of a description; each buffer is read when it is first needed."""

    def __init__(self, source: MeshSource, content: dict[str, Any], body: bytes) -> None:
        self._source, self._content, self._body = source, content, body
        self._buffers: dict[int, bytes] = {}
        self._beside = 0  # bytes of the files beside the description
        self._made: dict[int, NDArray[Any]] = {}  # accessors with values of their own
        self._made_rows = 0

    def item(self, kind: str, index: Any) -> Any:
        """Return a node, a mesh and so on; refuse the negative indices that Python would accept."""
        items = self._content.get(kind, ())
        if type(index) is not int or not 0 <= index < len(items):
            self._source.fail(f"{kind}[{index}]")
        return items[index]

    def count(self, accessor: int) -> int:
        count = self.item("accessors", accessor)["count"]
        if type(count) is not int or count < 1:
            self._source.fail(f"accessors[{accessor}].count")
        return count

    def values(self, index: int, *types: str) -> NDArray[Any]:
        """Return the values of an accessor of one of these types, a row for each element."""
        accessor, count = self.item("accessors", index), self.count(index)
        what = f"accessors[{index}]"
        component, width = accessor["componentType"], accessor["type"]
        if component not in _TYPES or width not in types:
            self._source.fail(f"{what}: {component}, {width}")
        if index in self._made:
            return self._made[index]
        kind, parts = np.dtype(_TYPES[component]), _WIDTHS[width]
        if "bufferView" in accessor:
            values = self._rows(accessor, kind, parts, count, what)
            if "sparse" not in accessor:
                return values
        self._made_rows += count
        self._source.check_size(self._made_rows, 0, 0)
        values = values.copy() if "bufferView" in accessor else np.zeros((count, parts), kind)
        if "sparse" in accessor:
            sparse, what = accessor["sparse"], f"{what}.sparse"
            places = self._rows(
                sparse["indices"], np.dtype(_TYPES[sparse["indices"]["componentType"]]), 1,
                sparse["count"], what,
            )[:, 0]  # fmt: skip
            if places.dtype.kind != "u" or places.max() >= count:
                self._source.fail(what)
            values[places] = self._rows(sparse["values"], kind, parts, len(places), what)
        self._made[index] = values
        return values

    def numbers(
        self, index: int, *types: str, used: Any = slice(None), normalized: bool = False
    ) -> Floats:
        """Return used rows of an accessor; integers may stand for 0 to 1 or −1 to 1 (s. 3.11)."""
        values = self.values(index, *types)[used]
        numbers: Floats = values.astype(np.float64)
        if not (normalized or self.item("accessors", index).get("normalized", False)):
            return numbers
        if values.dtype == np.uint32:
            self._source.fail(f"accessors[{index}].normalized")
        if values.dtype.kind != "f":
            np.maximum(numbers / full_scale(values.dtype), -1.0, out=numbers)
        return numbers

    def _rows(
        self, place: dict[str, Any], kind: np.dtype[Any], parts: int, count: int, what: str
    ) -> NDArray[Any]:
        """Return a part of a buffer as rows of numbers, without a copy."""
        view = self.item("bufferViews", place["bufferView"])
        first, start = view.get("byteOffset", 0), place.get("byteOffset", 0)
        stride = view.get("byteStride", kind.itemsize * parts)
        data = memoryview(self._buffer(view["buffer"]))[max(first, 0) : first + view["byteLength"]]
        end = start + (count - 1) * stride + kind.itemsize * parts
        if min(first, start) < 0 or min(stride, count) < 1 or end > len(data):
            self._source.fail(what)
        return np.ndarray((count, parts), kind, data, start, (stride, kind.itemsize))

    def _buffer(self, index: Any) -> bytes:
        buffer = self.item("buffers", index)
        if index not in self._buffers:
            address = buffer.get("uri")
            if address is None:
                data = b"" if index else self._body
            elif address.startswith("data:"):
                data = base64.b64decode(unquote(address.partition(",")[2]))
            else:
                data = self._file(unquote(address))
            if len(data) < buffer["byteLength"]:
                packed = ", ".join(sorted(buffer.get("extensions", ())))
                if packed:  # this buffer stands for what is packed in another one
                    raise Refusal.saying(REFUSALS["unsupported"], self._source.path, packed)
                raise Refusal.saying(REFUSALS["cut-off"], self._source.path)
            self._buffers[index] = data
        return self._buffers[index]

    def _file(self, name: str) -> bytes:
        """Return the bytes of a file in the folder of the mesh."""
        path = self._source.path
        if not _is_beside(path, name):
            raise Refusal.saying(REFUSALS["part"], path, name)
        try:
            with open_regular(path.parent / name) as file:
                self._beside += os.fstat(file.fileno()).st_size
                if self._beside > LARGEST_FILE:
                    raise Refusal.saying(REFUSALS["no-memory"], path)
                return file.read()
        except OSError:
            raise Refusal.saying(REFUSALS["part"], path, name) from None


def _is_beside(path: Path, name: str) -> bool:
    """Whether a name leads to a place in a file's own folder, or in one below it."""
    for kind in (PurePath, PureWindowsPath):  # even checking a network path would connect to it
        pure = kind(name)
        if pure.drive or pure.root or ".." in pure.parts:
            return False
    folder = os.path.realpath(path.parent)
    return os.path.commonpath([folder, os.path.realpath(path.parent / name)]) == folder
