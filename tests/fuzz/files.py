"""Files of all kinds that the program opens: sound ones, damaged at random."""

import base64
import copy
import json
import random
import re
import struct
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from app.document.document import Document
from app.lessons.contents import CONTENT as LESSONS
from app.scenes.scene import load
from tests.fuzz.catalogue import a_viewed_tree
from tests.support.gltf import SQUARE, GltfSquare
from tests.support.meshes import (
    PYRAMID,
    QUAD_AND_TRIANGLES,
    TRIANGLES,
    glb,
    gltf_parts,
    stl_file,
    stl_text_file,
)

NUMBERS = [
    *("nan", "-nan", "inf", "-inf", "1e308", "-1e308", "1e999", "1e-320", "1e40", "-0", "0", "1"),
    *("-1", "-6", "6", "255", "256", "65535", "2147483647", "2147483648", "-2147483649", "1e9"),
    *("4294967295", "9223372036854775807", "99999999999999999999", "9" * 400, "0." + "3" * 400),
    *("+1", "2.", ".5", "1.5", "1,5", "0x10", "1_000", "1e", "--1", "1-1", "", " ", "\t", "/"),
    *("1/", "1//", "1//1", "2/2/", "1/1/1/1", "/1", "//", "x", "f", "v", "#", "\\", "\\\n", "\n"),
    *("\0", "\x1b[31m", "\x1b]0;x\x07", "\r", "\x85", "\u202e", "\u0663", "\ud83d", "é", "\ufeff"),
]
VALUES: list[Any] = [
    *(None, True, False, 0, 1, -1, 2, 7, 255, 2**31, 2**32, 2**63, 2**64, -(2**40), 10**400),
    *(0.5, 1e308, -1e308, 1e-320, 1e40, float("nan"), float("inf"), "", "0", "POSITION", "\x1b[2J"),
    *([], {}, [0], [[]], [1, 2, 3], [1e308] * 3, [1e200] * 16, {"a": 1}, "SCALAR", "VEC4", "MAT4"),
    *(5120, 5121, 5123, 5125, 5126, 5130, [0, 0, 0, 0], ["x"] * 3, [None] * 3, list(range(40))),
]
WORDS = [
    *("```", "---", "\0", "$\\frac{", "$$", "{#", "}", "- [x] ", " := ", "value: ", "(" * 60, "|"),
    *("1/0", "9^99", "9" * 400, "scene=../../etc/passwd.obj", "scene=cube", "lens.kind=matrix"),
    *("document: /etc/passwd", "document: pipe.bin", "scene=pipe.obj", "view.probes=1,2,3,4"),
    *("view.compare=lens.near=1|", "settings.distance=0", "camera.eye=0,0,0", "wrong x: 1/0"),
    *("until: near = ", "until: 1 > 0", "-> right", "# ", "<script>", "^-99", "was_was_near"),
    *("clip_from_view(99, 99)", "reading_", "infinity", "sqrt(", "image.width=99999999", "```note"),
    *("\u202e", "\x1b[31m", "version: 99", "letters: 009", "minutes: -1", "title:", "hint:", "\t"),
]
ADDRESSES = [
    *("/dev/zero", "/proc/self/environ", "/etc/passwd", "../out.bin", "pipe.bin", "link.bin", "."),
    *("http://localhost/m.bin", "file:///etc/passwd", "C:\\m.bin", "\\\\host\\m.bin", "a%00b", ""),
    *("m.bin", "%2e%2e/m.bin", "x" * 5000, "data:,", "data:;base64,!!!!", "data:;base64,AAAA"),
    *("\x1b[31m.bin", "\ud83d", "sub/../m.bin", "./m.bin"),
]  # fmt: skip


# --------------------------------------------------------------------------- sound files


_ODD_FACES = [[0, 1, 2, 3, 0, 4, 1, 4, 0], [0, 1], [2, 2, 3, 2], [0, 2, 1, 3], [0, 4, 3, 1, 2]]
"""A spike, two faces of too few corners, and two that cross themselves."""


def _obj(path: Path, rng: random.Random) -> None:
    colours = rng.random() < 0.3
    corner = rng.choice(["{0}", "{0}/{0}", "{0}//{0}", "{0}/{0}/{0}", "-{0}", "{0}/", "{0}//"])
    lines = ["mtllib a.mtl", "o name", *([f"vt {i} 0" for i in range(5)] if "/" in corner else [])]
    lines += [f"v {x} {y} {z}{' 1 0.5 0' * colours}" for x, y, z in PYRAMID.tolist()]
    lines += ["vn 0 1 0"] * rng.choice([0, 1, 5])
    lines += ["usemtl", "g a b", "s off", "l 1 2 3/3 -1", "p 1 5"][: rng.randrange(7)]
    for face in rng.choice([QUAD_AND_TRIANGLES, TRIANGLES.tolist(), _ODD_FACES, []]):
        lines.append("f " + " ".join(corner.format(i + 1) for i in face))
    path.write_bytes((rng.choice(["\n", "\r\n", "\r"]).join(lines) + "\n").encode())


def _ply(path: Path, rng: random.Random) -> None:
    encoding = rng.choice(["ascii", "binary_little_endian", "binary_big_endian"])
    order = ">" if "big" in encoding else "<"
    real, letter = rng.choice([("double", "d"), ("float", "f"), ("float64", "d")])
    rgb, face_rgb = rng.random() < 0.4, rng.random() < 0.3
    channels = "".join(f"property uchar {name}\n" for name in ("red", "green", "blue"))
    faces = rng.choice([QUAD_AND_TRIANGLES, TRIANGLES.tolist(), _ODD_FACES, []])
    strips = rng.choice([[], [[0, 1, 2, 3, -1, 2, 3, 4], [0, 1, 4]]])
    edges = rng.choice([[], [(0, 1), (3, 2)]])
    head = (
        f"ply\nformat {encoding} 1.0\ncomment {rng.choice(['', 'TextureFile a.png'])}\n"
        f"element vertex 5\nproperty {real} x\nproperty {real} y\nproperty {real} z\n"
        f"{channels * rgb}element face {len(faces)}\n"
        f"property list uchar int {rng.choice(['vertex_indices', 'vertex_index'])}\n"
        f"{channels * face_rgb}element edge {len(edges)}\n"
        f"property int vertex1\nproperty int vertex2\nelement tristrips {len(strips)}\n"
        "property list int int vertex_indices\nend_header\n"
    ).encode()
    rows = [(f"3{letter}" + "3B" * rgb, [*p, *[9, 8, 7] * rgb]) for p in PYRAMID.tolist()]
    rows += [
        (f"B{len(face)}i" + "3B" * face_rgb, [len(face), *face, *[60, 70, 80] * face_rgb])
        for face in faces
    ]
    rows += [("2i", [*edge]) for edge in edges]
    rows += [(f"{len(strip) + 1}i", [len(strip), *strip]) for strip in strips]
    if encoding == "ascii":
        body = "".join(" ".join(map(str, row)) + "\n" for _, row in rows).encode()
    else:
        body = b"".join(struct.pack(order + kinds, *row) for kinds, row in rows)
    path.write_bytes(head + body)


def _stl(path: Path, rng: random.Random) -> None:
    if rng.random() < 0.5:
        stl_file(path, PYRAMID, rng.choice([b"made by a test", b"solid but binary"]))
    else:
        stl_text_file(path, PYRAMID, rng.choice(["", "the vertex loop of a facet", "x"]))


def _moved_gltf(rng: random.Random) -> tuple[dict[str, Any], bytes]:
    """A square that joints, morph targets, sparse values and instances move."""
    square = GltfSquare()
    square.primitive["mode"] = rng.choice([0, 1, 2, 3, 4, 4, 4, 4, 5, 6])
    if rng.random() < 0.5:
        square.content["accessors"][0]["sparse"] = square.sparse([2], [[3, 4, 0]])
    if rng.random() < 0.5:
        fractions = square.add(32767 * np.array(SQUARE), "<i2", normalized=True)
        square.primitive["targets"] = [{"POSITION": 0}, {"POSITION": fractions}]
        square.mesh["weights"] = [0.5, -1]
    if rng.random() < 0.5:
        places = {"TRANSLATION": square.add([[0, 0, 0], [4, 0, 0]])}
        extension = {"EXT_mesh_gpu_instancing": {"attributes": places}}
        square.content["nodes"][0]["extensions"] = extension
    if rng.random() < 0.5:
        joints = [{"translation": [0, 0, 7]}, {"scale": [2, 2, 2]}]
        weights = np.tile([1, 254, 0, 0], (4, 1))
        square.add_skin([[0, 1, 0, 0]] * 4, weights, joints, "u1", np.tile(np.eye(4), (2, 1, 1)))
    return square.content, square.body


def _gltf(rng: random.Random) -> tuple[dict[str, Any], bytes]:
    """A description with colours, a material, and a mesh in two nodes of a third."""
    if rng.random() < 0.5:
        return _moved_gltf(rng)
    content, body = gltf_parts(PYRAMID, [1, 2, 3], 2.0, rng.choice(["u1", "<u2", "<u4"]))
    body += b"\0" * (-len(body) % 4)
    colours = np.tile(np.float32([1, 0.5, 0]), (len(PYRAMID), 1)).tobytes()
    turned = {"mesh": 0, "scale": [1, 2, 1], "rotation": [0, 0.6, 0, 0.8]}
    content["nodes"][0]["children"].append(2)
    content["nodes"].append(turned)
    content["bufferViews"].append(
        {"buffer": 0, "byteOffset": len(body), "byteLength": len(colours)}
    )
    content["accessors"].append(
        {"bufferView": 2, "componentType": 5126, "count": 5, "type": "VEC3"}
    )
    content["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}]
    content["images"] = [{"uri": "missing.png"}]
    content["buffers"][0]["byteLength"] = len(body) + len(colours)
    (primitive,) = content["meshes"][0]["primitives"]
    if rng.random() < 0.5:
        primitive["attributes"]["COLOR_0"] = 2
    if rng.random() < 0.3:
        primitive["material"] = 0
    if rng.random() < 0.3:
        primitive["mode"] = rng.choice([0, 1, 4, 5, 6])
    return content, body + colours


def _write_gltf(path: Path, content: Any, body: bytes) -> None:
    """Write a description that may be damaged."""
    if path.suffix == ".glb":
        path.write_bytes(glb(content, body))
        return
    match content:
        case {"buffers": [dict() as buffer, *_]}:
            data = base64.b64encode(body).decode()
            buffer.setdefault("uri", f"data:application/octet-stream;base64,{data}")
    path.write_text(json.dumps(content), encoding="utf-8")


def _flip(rng: random.Random, data: bytes) -> bytes:
    found = bytearray(data)
    for _ in range(rng.choice([1, 1, 2, 5, 20])):
        found[rng.randrange(len(found))] = rng.choice([0, 0xFF, 0x7F, 0x80, rng.randrange(256)])
    return bytes(found)


def _word(rng: random.Random, data: bytes) -> bytes:
    """Replace four or eight bytes by a number that is special."""
    at = rng.randrange(len(data))
    number = rng.choice([0, 1, 2**31 - 1, 2**31, 2**32 - 1, 0x7FC00000, 0x7F800000, 0xFF7FFFFF])
    word = struct.pack(rng.choice("<>") + "I", number) * rng.choice([1, 2])
    return data[:at] + word + data[at + len(word) :]


def _cut(rng: random.Random, data: bytes) -> bytes:
    return data[: rng.randrange(len(data))]


def _chunk(rng: random.Random, data: bytes) -> bytes:
    """Remove, double or move a piece."""
    a, b = sorted(rng.randrange(len(data) + 1) for _ in range(2))
    b = min(b, a + rng.choice([1, 4, 40, 400]))
    at = rng.randrange(len(data) + 1)
    return rng.choice([data[:a] + data[b:], data[:b] + data[a:], data[:at] + data[a:b] + data[at:]])


def _token(rng: random.Random, data: bytes) -> bytes:
    """Replace words, or parts of them, by others."""
    places = [m.span() for m in re.finditer(rb"[^\s/]+|/", data[:4000])]
    if not places:
        return data
    for _ in range(rng.choice([1, 1, 2, 4])):
        start, end = rng.choice(places)
        if end <= len(data):
            new = rng.choice(NUMBERS).encode(errors="surrogatepass")
            data = data[:start] + new + data[end:]
    return data


def _line(rng: random.Random, data: bytes) -> bytes:
    """Remove, double or move lines, or insert one from another kind of file."""
    lines = data.splitlines(keepends=True)
    at, other = rng.randrange(len(lines)), rng.randrange(len(lines))
    what = rng.randrange(5)
    if what == 0:
        del lines[at]
    elif what == 1:
        lines.insert(other, lines[at])
    elif what == 2:
        lines[at], lines[other] = lines[other], lines[at]
    elif what == 3:
        lines[at] = lines[at] * rng.choice([2, 50])
    else:
        lines.insert(at, rng.choice([
            b"f 1 2\n", b"f\n", b"v\n", b"v 1\n", b"f 1/1 2/2 4/3\n", b"f 1 2 3 4 5 6 7 8 9\n",
            b"property list float int vertex_indices\n", b"property double x\n",
            b"element face 9\n",
            b"element vertex 99999999999\n", b"element edge 3\n", b"property list uchar int x\n",
            b"endloop\n", b"endsolid\nsolid\n", b"vertex 1 2 3\n", b"end_header\n", b"v 1 2 3 4\n",
        ]))  # fmt: skip
    return b"".join(lines)


def _places(tree: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    yield path
    for key in (
        tree if isinstance(tree, dict) else range(len(tree)) if isinstance(tree, list) else ()
    ):
        yield from _places(tree[key], (*path, key))


def structure(rng: random.Random, content: Any) -> Any:
    """Replace, remove, repeat or nest values at any depth."""
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        path = rng.choice(list(_places(content)))
        if not path:
            continue
        *above, key = path
        parent = content
        for step in above:
            parent = parent[step]
        what = rng.randrange(8)
        if what < 4:
            parent[key] = copy.deepcopy(rng.choice(VALUES))
        elif what == 4:
            del parent[key]
        elif what == 5 and isinstance(parent, list):
            parent += [copy.deepcopy(parent[key]) for _ in range(rng.choice([1, 3, 1000]))]
        elif what == 6:
            for _ in range(rng.choice([1, 60, 200])):
                parent[key] = [parent[key]]
        elif what == 7 and isinstance(parent, dict):
            parent[f"new \x1b[31m {key}"] = parent[key]
    return content


def _place(rng: random.Random, content: dict[str, Any]) -> dict[str, Any]:
    """Let the buffer lie elsewhere."""
    content["buffers"][0]["uri"] = rng.choice(ADDRESSES)
    return content


def _bomb(rng: random.Random, content: dict[str, Any]) -> dict[str, Any]:
    """Few bytes that expand to many triangles, circles of nodes, or very deep trees."""
    what, many = rng.randrange(4), rng.choice([10, 300, 3000])
    first = len(content["nodes"])
    if what == 0:
        content["meshes"][0]["primitives"] *= rng.choice([1, 30, 300])
        content["nodes"] += [{"mesh": 0}] * many
        content["scenes"][0]["nodes"] += range(first, first + many)
    elif what == 1:
        content["nodes"] += [{"children": [first + 1 + i], "mesh": 0} for i in range(many)]
        content["nodes"].append({})
        content["scenes"][0]["nodes"] = [first]
    elif what == 2:
        content["nodes"][-1]["children"] = [rng.choice([0, 1, 2])] * rng.choice([1, many])
    else:
        rng.choice(content["accessors"])["count"] = rng.choice([0, 10**6, 10**9, 2**62])
    return content


DAMAGE: dict[str, Callable[[random.Random, bytes], bytes]] = {
    "bytes": _flip, "word": _word, "cut": _cut, "chunk": _chunk, "token": _token, "line": _line,
}  # fmt: skip
CONTENT: dict[str, Callable[[random.Random, Any], Any]] = {
    "structure": structure, "place": _place, "bomb": _bomb,
}  # fmt: skip


def _lesson(rng: random.Random) -> bytes:
    """One of the program's own lessons or talks, its lines changed, moved and mixed."""
    files = sorted(LESSONS.glob("*.md"))
    lines, others = (rng.choice(files).read_text(encoding="utf-8").split("\n") for _ in range(2))
    for _ in range(rng.choice([1, 2, 3, 8])):
        at, word, other = rng.randrange(len(lines)), rng.choice(WORDS), rng.randrange(len(others))
        change = rng.randrange(5)
        if change == 0:
            lines[at] = word
        elif change == 1:
            column = rng.randrange(len(lines[at]) + 1)
            lines[at] = lines[at][:column] + word + lines[at][column:]
        elif change == 2:
            lines[at : at + rng.randrange(2)] = [word]
        elif change == 3:
            lines[at] = re.sub(r"\d+", lambda _: rng.choice(NUMBERS), lines[at])
        else:
            lines[at:at] = others[other : other + rng.randrange(12)]
    return "\n".join(lines).encode(errors="surrogatepass")


ENDINGS = (
    ".obj", ".ply", ".stl", ".gltf", ".glb", ".json", ".md",
    "lesson", "talk", "results", "record", "strokes", "list",
)  # fmt: skip
"""The kinds of files: by their endings, or as `tests.fuzz.lessons` names them."""


def write_hostile(folder: Path, seed: int, number: int, ending: str) -> tuple[Path, str]:
    """Write a file of a kind of `ENDINGS`; its path, and the kind of damage."""
    rng = random.Random(f"{seed} {number}")
    if not ending.startswith("."):
        from tests.fuzz import lessons

        return lessons.write(folder, rng, number, ending), ""
    path, kind = folder / f"{number}{ending}", ""
    if ending == ".md":
        path.write_bytes(_lesson(rng))
        kind = "lesson" if rng.random() < 0.7 else ""
    elif ending == ".json":
        scene = rng.choice(["letter-f", "similar-triangles"])
        tree = a_viewed_tree(rng, Document(scene, load(scene).start))
        kind = rng.choice(["view", "view", "structure", ""])
        if kind == "view":  # other damage is mostly refused before the view is read
            tree["view"] = structure(rng, {"view": tree.get("view")}).get("view")
        elif kind:
            tree = structure(rng, tree)
        path.write_text(json.dumps(tree), encoding="utf-8")
    elif ending in (".gltf", ".glb"):
        content, body = _gltf(rng)
        if rng.random() < 0.7:
            kind = rng.choice(list(CONTENT))
            content = CONTENT[kind](rng, content)
        _write_gltf(path, content, body)
    else:
        {".obj": _obj, ".ply": _ply, ".stl": _stl}[ending](path, rng)
    if kind:
        return path, kind
    kind, data = rng.choice(list(DAMAGE)), path.read_bytes()
    for _ in range(rng.choice([1, 1, 2, 3])):
        data = DAMAGE[kind](rng, data or b"\n")
    path.write_bytes(data)
    return path, kind
