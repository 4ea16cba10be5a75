"""Mesh files of strangers: what is read as others read it, and what is refused before it harms."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.bootstrap import ROOT
from app.document.codec import parse, picture_json
from app.document.document import Document
from app.document.files import read
from app.model.refusal import Cancelled, Refusal
from app.scenes import mesh_files as meshes
from app.scenes import reading
from app.scenes.fewer_triangles import reduced, shares_for_dragging
from app.scenes.mesh_files import Mesh
from app.scenes.scene import load
from tests.support.meshes import PYRAMID, gltf_parts, obj_file, ply_file, write_gltf

THREE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
POSIX = pytest.mark.skipif(sys.platform == "win32", reason="a file of POSIX systems")


def obj(folder: Path, text: str) -> Mesh:
    path = folder / "m.obj"
    path.write_bytes(text.encode())
    return meshes.read(path)


def refused(path: Path) -> str:
    with pytest.raises(Refusal) as caught:
        reading.read(path)
    return str(caught.value)


@pytest.mark.parametrize(
    "face",
    [
        "f 1/1 2/2 3/3", "f 1/9 2/2 3/3", "f 1//9 2//9 3//9", "f 1// 2// 3//", "f 1/1/ 2/2/ 3/3/",
        "f +1 +2 +3", "f -3 -2 -1", "f -3/-9 2 3//1", "f\t1  2\t3 ", "  f 1 2 3", "f 1 2 3 # a",
        "f 1 \\\n2 3", "f 1 2 \\\r\n3", "usemtl\nf 1 2 3", "usemtl \ng\nf 1 2 3", "f 1 2 3\r",
        "vt\nvn x\nf 1 2 3",
    ],
)  # fmt: skip
def test_corners_of_obj_are_read_as_other_programs_read_them(face: str, tmp_path: Path) -> None:
    """Whatever they name of textures and normals, which need not be there."""
    mesh = obj(tmp_path, THREE + face + "\n")
    assert mesh.points.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert mesh.corners.tolist() == [0, 1, 2] and mesh.offsets.tolist() == [0, 3]


def test_a_vertex_that_is_not_there_is_refused_whatever_textures_are(tmp_path: Path) -> None:
    (tmp_path / "m.obj").write_text(THREE + "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 4/3\n")
    assert "does not exist (there are 3)" in refused(tmp_path / "m.obj")


def test_numbers_of_obj_may_have_signs_and_no_decimals(tmp_path: Path) -> None:
    mesh = obj(tmp_path, "v +1 2. .5\nv 1e0 -0 1 1\nv 0 1 0 0.5 0.5 0.5\nf 1 2 3\n")
    assert mesh.points.tolist() == [[1, 2, 0.5], [1, 0, 1], [0, 1, 0]]


def test_a_corner_counts_back_from_its_own_line(tmp_path: Path) -> None:
    mesh = obj(tmp_path, THREE + "f -3 -2 -1\nv 5 0 0\nf -4 -1 2 3\n")
    assert mesh.corners.tolist() == [0, 1, 2, 0, 3, 1, 2]
    assert mesh.offsets.tolist() == [0, 3, 7]


def test_obj_larger_than_a_block_is_read_across_the_seams(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    obj_file(tmp_path / "m.obj", PYRAMID)
    whole = meshes.read(tmp_path / "m.obj")
    for block in (1, 7, 64):
        monkeypatch.setattr(meshes, "BLOCK", block)
        mesh = meshes.read(tmp_path / "m.obj")
        assert (mesh.points == whole.points).all() and (mesh.corners == whole.corners).all()


def test_points_with_one_key_are_not_merged(monkeypatch: pytest.MonkeyPatch) -> None:
    points = np.array([[0.0, 0, 0], [1, 0, 0], [-0.0, 0, 0], [0, 1, 0], [1, 0, 0]])
    distinct, merged = meshes.merge_points(points)
    assert (distinct[merged] == points).all() and len(distinct) == 3
    monkeypatch.setattr(np, "argsort", lambda a, **_: np.arange(len(a)))
    distinct, merged = meshes.merge_points(points)  # keys that are not sorted are as bad
    assert (distinct[merged] == points).all()


# --------------------------------------------------------------------------- what is opened


@POSIX
def test_pipes_and_devices_are_not_opened(tmp_path: Path) -> None:
    for ending in (".obj", ".json"):
        os.mkfifo(tmp_path / f"pipe{ending}")
        (tmp_path / f"link{ending}").symlink_to(tmp_path / f"pipe{ending}")
        (tmp_path / f"zero{ending}").symlink_to("/dev/zero")
    for name in ("pipe", "link", "zero"):
        assert "not a regular file" in refused(tmp_path / f"{name}.obj")
        with pytest.raises(Refusal, match="not a regular file"):
            read(tmp_path / f"{name}.json")


@pytest.mark.parametrize(
    "address",
    [
        "../m.bin", "sub/../../m.bin", "%2e%2e/m.bin", "/proc/self/environ", "//host/m.bin",
        "C:\\m.bin", "\\\\host\\m.bin", "link.bin", "pipe.bin", "linked/m.bin", ".", "",
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
    (folder / "m.gltf").write_text(json.dumps(content))
    assert "its part" in refused(folder / "m.gltf")
    (folder / "sub").mkdir()
    (folder / "sub" / "m.bin").write_bytes(body)
    content["buffers"][0]["uri"] = "sub/m.bin"
    (folder / "m.gltf").write_text(json.dumps(content))
    assert len(reading.read(folder / "m.gltf").points) == 5


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


def test_nothing_of_a_file_commands_the_terminal(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["asset"]["version"] = "1\x1b[31m\x07\u202e"
    write_gltf(tmp_path / "m.gltf", content, body)
    sentence = refused(tmp_path / "m.gltf")
    assert sentence.isprintable() and "1\\x1b[31m\\x07\\u202e" in sentence


def test_a_document_of_millions_of_brackets_is_answered_at_once() -> None:
    text = '{"format": "frustum-lab", "version": 1, "more": [' + "[]," * 5_000_000 + "[]]}"
    started = time.process_time()
    with pytest.raises(Refusal, match="more than 200000 values"):
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


def test_what_would_grow_too_large_is_refused_by_its_counts(tmp_path: Path) -> None:
    path = bomb(tmp_path, 50_000, 100)
    content = json.loads(path.read_text())
    content["buffers"][0]["uri"] = "gone.bin"  # nothing is read before
    path.write_text(json.dumps(content))
    sentence = refused(path)
    assert "would grow to 30000000 triangles" in sentence and "at most 20000000" in sentence


def test_few_bytes_are_repeated_so_often_as_can_be_drawn_at_once(tmp_path: Path) -> None:
    assert len(reading.read(bomb(tmp_path, 415, 10)).offsets) - 1 == 24_900
    sentence = refused(bomb(tmp_path, 420, 10))
    assert "bytes until they are 25200 triangles, and at most 25000" in sentence


def test_a_circle_of_nodes_and_a_deep_tree(tmp_path: Path) -> None:
    content, body = gltf_parts(PYRAMID)
    content["nodes"] = [{"children": [i + 1]} for i in range(5000)] + [{"mesh": 0}]
    write_gltf(tmp_path / "m.gltf", content, body)
    assert len(reading.read(tmp_path / "m.gltf").points) == 5
    content["nodes"][-1]["children"] = [7]
    write_gltf(tmp_path / "m.gltf", content, body)
    assert "below itself" in refused(tmp_path / "m.gltf")


def test_a_few_bytes_that_grow_are_read_apart(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "SMALL_MESH", (100, 2**20))
    mesh = reading.read(bomb(tmp_path, 20, 2))
    assert len(mesh.offsets) - 1 == 20 * 2 * 6


# --------------------------------------------------------------------------- the other process


def test_a_large_file_is_the_same_read_apart(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ply_file(tmp_path / "m.ply", PYRAMID + 1e7 + 0.1)
    content, body = gltf_parts(PYRAMID)
    write_gltf(tmp_path / "m.glb", content, body)
    for name in ("m.ply", "m.glb"):
        here = reading.read(tmp_path / name)
        monkeypatch.setattr(reading, "SMALL", 0)
        apart = reading.read(tmp_path / name)
        monkeypatch.undo()
        assert len(here.edges)
        for one, other in zip(here, apart, strict=True):
            assert (one == other).all() and one.dtype == other.dtype


def test_a_refusal_comes_through_from_the_other_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "m.obj"
    path.write_text(THREE + "f 1 2 9\n")
    here = refused(path)
    monkeypatch.setattr(reading, "SMALL", 0)
    assert refused(path) == here and "does not exist (there are 3)" in here


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


def test_the_end_of_the_other_process_is_a_sentence(
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
        assert "ended before it was done" in refused(tmp_path / "m.obj")


@pytest.mark.skipif(sys.platform != "linux", reason="where the system keeps the limit")
def test_memory_that_is_not_there_is_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "m.stl").write_bytes(bytes(80) + (4_000_000).to_bytes(4, "little"))
    with (tmp_path / "m.stl").open("r+b") as file:
        file.truncate(84 + 50 * 4_000_000)
    code = (
        "from pathlib import Path; from app.scenes import reading; reading.MEMORY = 600 * 2**20;"
        f"reading.main(Path({str(tmp_path / 'm.stl')!r}))"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, check=False)
    answer = json.loads(done.stdout.splitlines()[-1])
    assert answer["refused"][0] == meshes.NO_MEMORY and done.stderr == b""


def test_what_a_reader_did_not_foresee_is_a_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    obj_file(tmp_path / "m.obj", PYRAMID)

    def broken(*_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(meshes, "Mesh", broken)
    assert "it cannot be read (ZeroDivisionError)" in refused(tmp_path / "m.obj")


@POSIX
def test_hostile_files_are_sound_or_refused_in_one_sentence() -> None:
    """A sample: ``python3 -m tests.hostile`` opens thousands."""
    command = [sys.executable, "-m", "tests.hostile", "--count", "80", "--seed", "7"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


# --------------------------------------------------------------------------- pictures


def test_a_picture_names_a_mesh_without_its_folder(tmp_path: Path) -> None:
    mesh = str(tmp_path / "somebody" / "cow.obj")
    for shown in (Document(mesh), Document("similar-triangles", mesh=mesh)):
        text = picture_json(shown)
        assert "somebody" not in text and '"cow.obj"' in text
        found = parse(text, tmp_path)
        assert str(tmp_path / "cow.obj") in (found.scene, found.mesh)


@pytest.mark.parametrize("copies", [20_000, 300_000])
def test_triangles_that_lie_in_one_place_are_reduced_in_no_time(
    copies: int, tmp_path: Path
) -> None:
    """VTK's locator of cells looked at all of them for each; of no triangles, there is no share."""
    (tmp_path / "m.obj").write_text(f"{THREE}v 0 0 1\nf 1 2 4\n" + "f 1 2 3\n" * copies)
    began = time.process_time()
    scene = load(str(tmp_path / "m.obj"))
    for share in shares_for_dragging(scene):
        surface = reduced(scene, share).surface
        assert surface is not None and surface.n_cells > 0
        assert len(surface.cell_data["rgb"]) == surface.n_cells
    assert time.process_time() - began < 60.0  # it was many minutes
