"""Open damaged and hostile meshes, documents, lessons and talks with ``python3 -m app``.

``python3 -m tests.hostile --count 5000 --seed 1`` makes 5000 files, opens meshes and documents with
``matrices FILE``, lessons and talks with ``lesson check FILE``, and reports the outcome. A file
must open, or be refused in one sentence that begins with its name. Anything else is a finding: a
signal, a traceback, a second line, 10 s of work, 60 s of waiting, or 2 GiB.

``--window`` also opens each file in a real window, draws all three panes, and reads and answers
every step of a lesson. There a finding is an exception, a drawing that is taken back, more than
`LONGEST_STALL_S` of work without handling events, or opening a file that does not belong to the
lesson. A window that crashes is a finding, and the next file gets a new window.

The command is imported once. A fork of that process opens each file, so that its signal, status and
processor time (which other jobs do not lengthen) are its own. Every finding, and one file in
`CONFIRMED`, is opened by the whole command as well, which must say the same. Without fork the whole
command opens all files.
"""

from __future__ import annotations

import argparse
import base64
import collections
import contextlib
import copy
import json
import os
import random
import re
import select
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[1]
CONFIRMED = 50
LONGEST_S = 10.0
LONGEST_WAIT_S = 60.0
LONGEST_STALL_S = 0.2
"""Processor time of the window's thread."""
LARGEST_BYTES = 2 * 2**30

POINTS = [(0.125, 0, 0.25), (3.25, 0, 0.5), (3.0, 0, 3.125), (0.25, 0, 3), (1.5, 4, 1.75)]
FACES = [(0, 1, 2, 3), (0, 4, 1), (1, 4, 2), (2, 4, 3), (3, 4, 0)]
TRIANGLES = [(0, 1, 2), (0, 2, 3), (0, 4, 1), (1, 4, 2), (2, 4, 3), (3, 4, 0)]
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


def _obj(rng: random.Random) -> bytes:
    colours = rng.random() < 0.3
    corner = rng.choice(["{0}", "{0}/{0}", "{0}//{0}", "{0}/{0}/{0}", "-{0}", "{0}/", "{0}//"])
    lines = ["mtllib a.mtl", "o name", *([f"vt {i} 0" for i in range(5)] if "/" in corner else [])]
    for x, y, z in POINTS:
        lines.append(f"v {x} {y} {z}{' 1 0.5 0' if colours else ''}")
    lines += ["vn 0 1 0"] * rng.choice([0, 1, 5])
    lines += ["usemtl", "g a b", "s off", "# comment", "l 1 2", "p 1"][: rng.randrange(7)]
    for face in rng.choice([FACES, TRIANGLES]):
        lines.append("f " + " ".join(corner.format(i + 1) for i in face))
    return (rng.choice(["\n", "\r\n", "\r"]).join(lines) + "\n").encode()


def _ply(rng: random.Random) -> bytes:
    encoding = rng.choice(["ascii", "binary_little_endian", "binary_big_endian"])
    order = ">" if "big" in encoding else "<"
    real, letter = rng.choice([("double", "d"), ("float", "f"), ("float64", "d")])
    rgb, face_rgb = rng.random() < 0.4, rng.random() < 0.3
    channels = "".join(f"property uchar {name}\n" for name in ("red", "green", "blue"))
    faces = rng.choice([FACES, TRIANGLES])
    head = (
        f"ply\nformat {encoding} 1.0\ncomment {rng.choice(['', 'TextureFile a.png'])}\n"
        f"element vertex 5\nproperty {real} x\nproperty {real} y\nproperty {real} z\n"
        f"{channels if rgb else ''}element face {len(faces)}\n"
        f"property list uchar int {rng.choice(['vertex_indices', 'vertex_index'])}\n"
        f"{channels if face_rgb else ''}end_header\n"
    ).encode()
    rows: list[tuple[str, list[Any]]] = []
    rows += [(f"3{letter}" + "3B" * rgb, [*p, *([9, 8, 7] if rgb else [])]) for p in POINTS]
    rows += [
        (f"B{len(f)}i" + "3B" * face_rgb, [len(f), *f, *([60, 70, 80] if face_rgb else [])])
        for f in faces
    ]
    if encoding == "ascii":
        return head + "".join(" ".join(map(str, row)) + "\n" for _, row in rows).encode()
    return head + b"".join(struct.pack(order + kinds, *row) for kinds, row in rows)


def _stl(rng: random.Random) -> bytes:
    if rng.random() < 0.5:
        head = rng.choice([b"made by a test", b"solid but binary"]).ljust(80)
        rows = [
            struct.pack("<12fH", 0, 0, 0, *(v for i in t for v in POINTS[i]), 0) for t in TRIANGLES
        ]
        return head + struct.pack("<I", len(rows)) + b"".join(rows)
    text = rng.choice(["solid\n", "solid the vertex loop of a facet\n", "solid x\n"])
    for t in TRIANGLES:
        corners = "".join("vertex {} {} {}\n".format(*POINTS[i]) for i in t)
        text += f"facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n"
    return (text + "endsolid\n").encode()


def _description(rng: random.Random) -> tuple[dict[str, Any], bytes]:
    positions = b"".join(struct.pack("<3f", *p) for p in POINTS)
    kind, letter = rng.choice([(5121, "B"), (5123, "H"), (5125, "I")])
    indices = b"".join(struct.pack(f"<3{letter}", *t) for t in TRIANGLES)
    indices += b"\0" * (-len(indices) % 4)
    colours = b"".join(struct.pack("<3f", 1, 0.5, 0) for _ in POINTS)
    body = positions + indices + colours
    primitive: dict[str, Any] = {"attributes": {"POSITION": 0}, "indices": 1}
    if rng.random() < 0.5:
        primitive["attributes"]["COLOR_0"] = 2
    if rng.random() < 0.3:
        primitive["material"] = 0
    if rng.random() < 0.3:
        primitive["mode"] = rng.choice([0, 1, 4, 5, 6])
    views = [(0, len(positions)), (len(positions), len(indices))]
    views.append((len(positions) + len(indices), len(colours)))
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [
            {"children": [1, 2], "translation": [1, 2, 3]},
            {"mesh": 0, "scale": [1, 2, 1], "rotation": [0, 0.6, 0, 0.8]},
            {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]},
        ],
        "meshes": [{"primitives": [primitive]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}],
        "images": [{"uri": "missing.png"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"},
            {"bufferView": 1, "componentType": kind, "count": 18, "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5126, "count": 5, "type": "VEC3"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": length} for start, length in views
        ],
        "buffers": [{"byteLength": len(body)}],
    }, body


def _document(rng: random.Random) -> dict[str, Any]:
    """A document with a view, of version 2 or 1."""
    camera = {"eye": [6, 5, 9], "target": [0, 2.2, 0], "up": [0, 1, 0]}
    tree: dict[str, Any] = {
        "format": "frustum-lab",
        "version": rng.choice([1, 2, 2, 2]),
        "scene": rng.choice(["letter-f", "similar-triangles"]),
        "camera": camera,
        "lens": {"kind": "perspective", "fov_y_deg": 45, "near": 1, "far": 30},
        "depth": "opengl",
        "image": {"width": 1280, "height": 720},
        "view": {
            "layout": "columns", "large": "image", "stage": rng.choice(["pyramid", 2.5]),
            "frame_step": "n", "panel": "frame", "letters": "002", "layers": ["grid", "labels"],
            "fixed": "side", "probes": [[1, 2, 3], None, [640, 360]], "pinned": [1],
            "panes": {"world": dict(camera), "second-screen": dict(camera), "ndc": dict(camera)},
            "compare": {"near": 2},
        },
    }  # fmt: skip
    if tree["version"] == 1:
        tree["views"] = tree["view"]["panes"]
    return tree


def _viewed(rng: random.Random, tree: dict[str, Any]) -> dict[str, Any]:
    """Damage the view alone: other damage is mostly refused before the view is read."""
    tree["view"] = _structure(rng, {"view": tree["view"]}).get("view")
    return tree


def _packed(content: Any, body: bytes, glb: bool) -> bytes:
    if not glb:
        with_data = copy.deepcopy(content)
        with contextlib.suppress(LookupError, TypeError, AttributeError):
            with_data["buffers"][0].setdefault(
                "uri", "data:application/octet-stream;base64," + base64.b64encode(body).decode()
            )
        return json.dumps(with_data).encode()
    text = json.dumps(content).encode()
    text += b" " * (-len(text) % 4)
    return (
        struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(body))
        + struct.pack("<I4s", len(text), b"JSON") + text
        + struct.pack("<I4s", len(body), b"BIN\0") + body
    )  # fmt: skip


# --------------------------------------------------------------------------- damage


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


def _structure(rng: random.Random, content: Any) -> Any:
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
    if what == 0:
        content["meshes"][0]["primitives"] *= rng.choice([1, 30, 300])
        content["nodes"] += [{"mesh": 0}] * many
        content["scenes"][0]["nodes"] += range(3, 3 + many)
    elif what == 1:
        content["nodes"] += [{"children": [4 + i], "mesh": 0} for i in range(many)] + [{}]
        content["scenes"][0]["nodes"] = [3]
    elif what == 2:
        content["nodes"][1]["children"] = [rng.choice([0, 1, 2])] * rng.choice([1, many])
    else:
        content["accessors"][rng.randrange(3)]["count"] = rng.choice([0, 10**6, 10**9, 2**62])
    return content


DAMAGE: dict[str, Callable[[random.Random, bytes], bytes]] = {
    "bytes": _flip, "word": _word, "cut": _cut, "chunk": _chunk, "token": _token, "line": _line,
}  # fmt: skip
CONTENT: dict[str, Callable[[random.Random, Any], Any]] = {
    "structure": _structure, "place": _place, "bomb": _bomb,
}  # fmt: skip


def _lesson(rng: random.Random) -> bytes:
    """One of the program's own lessons or talks, its lines changed, moved and mixed."""
    files = sorted((ROOT / "app" / "lessons" / "content").glob("*.md"))
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


def hostile(seed: int, number: int) -> tuple[str, str, bytes]:
    """Ending, kind of damage and content of a file."""
    rng = random.Random(f"{seed} {number}")
    ending = (".obj", ".ply", ".stl", ".gltf", ".glb", ".json", ".md")[number % 7]
    if ending == ".md":
        data = _lesson(rng)
        if rng.random() < 0.7:
            return ending, _lesson.__name__, data
    elif ending == ".json":
        tree = _document(rng)
        what = rng.choice([_viewed, _viewed, _structure, None])
        if what is not None:
            return ending, what.__name__, json.dumps(what(rng, tree)).encode()
        data = json.dumps(tree).encode()
    elif ending in (".gltf", ".glb"):
        content, body = _description(rng)
        if rng.random() < 0.7:
            kind = rng.choice(list(CONTENT))
            return ending, kind, _packed(CONTENT[kind](rng, content), body, ending == ".glb")
        data = _packed(content, body, ending == ".glb")
    else:
        data = {".obj": _obj, ".ply": _ply, ".stl": _stl}[ending](rng)
    kind = rng.choice(list(DAMAGE))
    for _ in range(rng.choice([1, 1, 2, 3])):
        data = DAMAGE[kind](rng, data or b"\n")
    return ending, kind, data


# --------------------------------------------------------------------------- opening


class Outcome(NamedTuple):
    """What became of a file."""

    status: int  # below zero: the signal
    out: bytes
    err: bytes
    seconds: float
    largest: int  # bytes of the process, and of one that it started

    def finding(self, path: Path) -> str:
        """What is wrong with it; empty if nothing is."""
        lines = self.err.decode(errors="replace").splitlines()
        if self.status < 0:
            return f"signal {-self.status}"
        if b"Traceback" in self.err or b"Error\n" in self.err:
            return "traceback"
        if self.seconds > LONGEST_S:
            return f"{self.seconds:.0f} s"
        if self.largest > LARGEST_BYTES:
            return f"{self.largest >> 20} MiB"
        if path.suffix == ".md":
            wrong = self.out.decode(errors="replace").splitlines()
            named = all(line.startswith((f"{path}: ", f"{path} ")) for line in wrong[:-1])
            printable = all(line.isprintable() for line in wrong)
            right = self.status == (len(wrong) > 1) and wrong and named and printable and not lines
            return "" if right else f"status {self.status}, or not a sentence about the file"
        if self.status == 0:
            return "" if self.out and not lines else "opened, but said something or nothing"
        if self.status != 2 or self.out or len(lines) != 1:
            return f"status {self.status}, {len(lines)} lines"
        named = f"{path} " if path.suffix == ".json" else f"{path}: "
        if not lines[0].isprintable() or not lines[0].startswith((named, f"{path}: ")):
            return "not a sentence about the file"
        return ""


def _waited(started: float, pid: int, folder: Path) -> Outcome:
    import signal

    while True:
        done, status, used = os.wait4(pid, os.WNOHANG)
        if done:
            break
        if time.perf_counter() - started > LONGEST_WAIT_S:
            os.kill(pid, signal.SIGKILL)
        time.sleep(0.002)
    unit = 1 if sys.platform == "darwin" else 1024
    out, err = ((folder / name).read_bytes() for name in ("out", "err"))
    return Outcome(
        os.waitstatus_to_exitcode(status), out, err, used.ru_utime + used.ru_stime,
        used.ru_maxrss * unit,
    )  # fmt: skip


def _arguments(path: Path) -> list[str]:
    return [*(["lesson", "check"] if path.suffix == ".md" else ["matrices"]), str(path)]


def _forked(path: Path, folder: Path) -> Outcome:
    from app.commands import cli

    started = time.perf_counter()
    pid = os.fork()
    if pid == 0:
        status = 70
        try:
            for descriptor, name in ((1, "out"), (2, "err")):
                file = os.open(folder / name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
                os.dup2(file, descriptor)
            status = cli.main(_arguments(path))
            sys.stdout.flush()
        except BaseException:
            import traceback

            traceback.print_exc()
            sys.stderr.flush()
        finally:
            os._exit(status)
    return _waited(started, pid, folder)


def _commanded(path: Path) -> Outcome:
    started = time.perf_counter()
    command = [sys.executable, "-m", "app", *_arguments(path)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, check=False)
    return Outcome(done.returncode, done.stdout, done.stderr, time.perf_counter() - started, 0)


# --------------------------------------------------------------------------- in a window

IN_A_WINDOW = "--in-a-window"


class InWindow:
    """Opens files in a window of a process of its own, and tells what is wrong with each."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._process: subprocess.Popen[str] | None = None

    def finding(self, path: Path) -> str:
        """What is wrong with a file; empty if nothing is."""
        if self._process is None:
            command = [sys.executable, "-m", "tests.hostile", IN_A_WINDOW, str(self._folder)]
            self._process = subprocess.Popen(
                command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
            )
            self._answer()  # the window is there
        assert self._process.stdin is not None
        print(path, file=self._process.stdin, flush=True)
        return self._answer()

    def _answer(self) -> str:
        assert self._process is not None and self._process.stdout is not None
        ready, _, _ = select.select([self._process.stdout], [], [], LONGEST_WAIT_S)
        answer = self._process.stdout.readline() if ready else ""
        if answer:
            return str(json.loads(answer))
        self._process.kill()
        status, self._process = self._process.wait(), None
        return f"the window ended with {status}" if ready else "the window hangs"

    def close(self) -> None:
        """End the window."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()


def in_a_window(folder: Path) -> None:
    """Open the files that standard input names, and answer each with what is wrong with it."""
    import matplotlib
    from PySide6.QtCore import QTimer
    from PySide6.QtTest import QTest
    from PySide6.QtWidgets import QApplication

    from widgets.program.opengl import prepare

    prepare()
    application = QApplication([])
    from app.document.document import Document
    from app.scenes.scene import load
    from tests.support.opened import opened
    from widgets.window.settings import Settings

    home = folder / "window.ini"
    window = opened(Document("cube", load("cube").start), settings=Settings(home))
    problems: list[str] = []
    import traceback

    sys.excepthook = lambda _kind, error, _trace: problems.append(
        "".join(traceback.format_exception(error)[-3:])
    )
    places = (folder, ROOT, sys.prefix, sys.base_prefix, tempfile.gettempdir(), os.devnull)
    allowed = (*map(str, places), matplotlib.get_cachedir())
    opened_elsewhere: set[str] = set()

    def audit(event: str, arguments: tuple[Any, ...]) -> None:
        if event in ("socket.connect", "socket.getaddrinfo"):
            opened_elsewhere.add(event)
        elif event != "open" or isinstance(arguments[0], int):  # a pipe that is open
            return
        elif not os.fsdecode(arguments[0]).startswith(allowed):
            opened_elsewhere.add(os.fsdecode(arguments[0]))

    sys.addaudithook(audit)
    longest, last = [0.0], [time.thread_time()]

    def beat() -> None:
        now = time.thread_time()
        longest[0], last[0] = max(longest[0], now - last[0]), now

    pulse = QTimer(interval=5)
    pulse.timeout.connect(beat)

    def settle() -> None:
        for _ in range(4):
            QTest.qWait(1)

    print(json.dumps("ready"), flush=True)
    for line in sys.stdin:
        problems.clear()
        opened_elsewhere.clear()
        longest[0], last[0] = 0.0, time.thread_time()
        pulse.start()
        is_open = window.files.open(line.rstrip("\n"))
        settle()
        if is_open and window.lessons.course is not None:
            for place in range(len(window.lessons.course.lesson.steps)):
                window.lesson_card.go_to(place)
                settle()
                for block in window.lesson_card.blocks:
                    block.give_hint()
                settle()
            if window.lessons.course.lesson.is_talk:
                window.talks.open_speaker()
                settle()
                window.talks.close_speaker()
            window.lesson_card.leave()
            settle()
        pulse.stop()
        for pane in window.panes.values():
            if pane.drawing is None:
                problems.append(f"{pane.name} shows nothing")
        if "cannot be drawn" in window.messages.text:
            problems.append(window.messages.text)
        if window.shown.document is not window.store.document:
            problems.append("the window shows another document than the store's")
        problems.extend(f"opens {name}" for name in sorted(opened_elsewhere))
        if longest[0] > LONGEST_STALL_S and not line.endswith(".md\n"):  # of many scenes
            problems.append(f"stalls for {longest[0]:.2f} s")
        print(json.dumps("; ".join(problems)), flush=True)
    application.quit()


def main() -> int:
    """Open hostile files and tell what became of them; 1 if there are findings."""
    if IN_A_WINDOW in sys.argv[1:2]:
        in_a_window(Path(sys.argv[2]))
        return 0
    parser = argparse.ArgumentParser(description="Open hostile files.")
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--first", type=int, default=0, help="number of the first, to go on from")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--window", action="store_true", help="draw each in a window, too")
    parser.add_argument("--only", default="", help="endings, such as .obj,.md")
    parser.add_argument("--keep", type=Path, help="a folder for the files of findings")
    found = parser.parse_args()
    forks = hasattr(os, "fork")
    if forks:
        os.environ["OPENBLAS_NUM_THREADS"] = "1"  # a fork takes no threads along
        from app.scenes.scene import load

        load("cube")
    findings, outcomes = 0, collections.Counter[str]()
    slowest, largest, confirmed = 0.0, 0, 0
    with tempfile.TemporaryDirectory() as place:
        outer = Path(place)
        folder = outer / "meshes"
        folder.mkdir()
        (outer / "out.bin").write_bytes(bytes(4096))
        (folder / "m.bin").write_bytes(bytes(4096))
        if forks:
            os.mkfifo(folder / "pipe.bin")
            (folder / "link.bin").symlink_to(outer / "out.bin")
        window = InWindow(folder) if found.window else None
        for number in range(found.first, found.first + found.count):
            ending, kind, data = hostile(found.seed, number)
            if found.only and ending not in found.only.split(","):
                continue
            path = folder / f"{number}{ending}"
            path.write_bytes(data)
            outcome = _forked(path, outer) if forks else _commanded(path)
            what = outcome.finding(path)
            if forks and (what or number % CONFIRMED == 0):
                again = _commanded(path)
                confirmed += 1
                if (again.status, again.out, again.err) != (
                    outcome.status,
                    outcome.out,
                    outcome.err,
                ):
                    what = what or f"the whole command says something else: {again.err!r}"
            if window is not None and (shown := window.finding(path)):
                what = f"{what}; in the window: {shown}".removeprefix("; ")
            if what:
                findings += 1
                print(
                    f"{found.seed} {number} {ending} {kind}: {what}: {outcome.err[-400:]!r}",
                    flush=True,
                )
                if found.keep:
                    found.keep.mkdir(parents=True, exist_ok=True)
                    (found.keep / path.name).write_bytes(data)
            outcomes["opened" if outcome.status == 0 else "refused"] += not what
            slowest, largest = max(slowest, outcome.seconds), max(largest, outcome.largest)
            path.unlink()
        if window is not None:
            window.close()
    print(
        f"{found.count} files from {found.first} of seed {found.seed}: "
        f"{outcomes['opened']} opened, {outcomes['refused']} refused in one sentence, "
        f"{findings} findings; at most {slowest:.1f} s and {largest >> 20} MiB; "
        f"{confirmed if forks else found.count} by the whole command"
    )
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
