"""Points and lines of a file are a scene, with faces or without."""

from pathlib import Path

import numpy as np
import pytest

from app.document.document import Document
from app.document.files import read, write
from app.model.refusal import REFUSALS, Refusal
from app.scenes import finishing, reading
from app.scenes.fewer_triangles import reduced, shares_for_dragging
from app.scenes.scene import Scene, load
from app.scenes.shapes import DRAWN_RGB, is_grid

SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
XYZ = "property float x\nproperty float y\nproperty float z\n"


def opened(path: Path, content: str | bytes) -> Scene:
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return load(str(path))


def dots_of(scene: Scene) -> np.ndarray:
    """World coordinates of the dots, (n, 3)."""
    if scene.dots is None:
        return np.empty((0, 3))
    return np.array(scene.dots.points, dtype=np.float64) + scene.origin


def lines_of(scene: Scene) -> np.ndarray:
    """World coordinates of the ends of the file's own lines, (n, 2, 3)."""
    assert scene.lines is not None
    rgb = np.asarray(scene.lines.cell_data["rgb"])
    ends = np.asarray(scene.lines.points).reshape(-1, 2, 3) + scene.origin
    return np.asarray(ends[(rgb == DRAWN_RGB).all(axis=1)])


def test_a_ply_file_without_faces_is_a_cloud(tmp_path: Path) -> None:
    head = f"ply\nformat ascii 1.0\nelement vertex 3\n{XYZ}end_header\n"
    cloud = opened(tmp_path / "points.ply", f"{head}0 0 0\n1 0 0\n0 1 0\n")
    assert cloud.surface is None and cloud.faces == 0 and cloud.triangles == 0
    assert dots_of(cloud).tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert (cloud.lower, cloud.upper) == ((0.0, 0.0, 0.0), (1.0, 1.0, 0.0))
    assert not cloud.start.trace(dots_of(cloud)).outside.any()
    assert len(lines_of(cloud)) == 0 and cloud.ground_lines > 0


@pytest.mark.parametrize("order", ["<", ">"])
def test_a_binary_cloud_keeps_its_colours_and_nothing_else_of_a_row(
    order: str, tmp_path: Path
) -> None:
    rows = np.zeros(
        4, [("place", f"{order}f8", 3), ("normal", f"{order}f4", 3), ("rgb", "u1", 3), ("a", "u1")]
    )
    rows["place"] = 1e7 + np.arange(12.0).reshape(4, 3) / 8.0
    rows["rgb"] = np.arange(12).reshape(4, 3) * 20
    name = {"<": "little", ">": "big"}[order]
    head = f"ply\nformat binary_{name}_endian 1.0\nelement vertex 4\n{XYZ}".replace(
        "float", "double"
    )
    head += "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
    head += "property uchar green\nproperty uchar blue\nproperty uchar alpha\n"
    head += "element face 0\nproperty list uchar int vertex_indices\nend_header\n"
    cloud = opened(tmp_path / "cloud.ply", head.encode() + rows.tobytes())
    assert (dots_of(cloud) == rows["place"]).all()
    assert cloud.dots is not None
    assert (np.asarray(cloud.dots.point_data["rgb"]) == rows["rgb"]).all()


def test_edges_of_a_ply_file_are_lines_and_its_other_vertices_dots(tmp_path: Path) -> None:
    head = f"ply\nformat ascii 1.0\nelement vertex 4\n{XYZ}element edge 2\n"
    head += "property int vertex1\nproperty int vertex2\nproperty uchar red\nend_header\n"
    body = "0 0 0\n1 0 0\n0 1 0\n5 5 5\n0 1 9\n2 1 9\n"
    wires = opened(tmp_path / "wires.ply", head + body)
    assert lines_of(wires).tolist() == [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 0, 0]]]
    assert dots_of(wires).tolist() == [[5, 5, 5]]
    with pytest.raises(Refusal, match="line 17 names a vertex that does not exist"):
        opened(tmp_path / "cut.ply", (head + body).replace("2 1 9", "4 1 9"))


@pytest.mark.parametrize(
    ("elements", "lines", "dots"),
    [
        ("l 1 2 3 4 1\nl 1 3\n", [(1, 2), (2, 3), (3, 4), (4, 1), (1, 3)], []),
        ("l 1/7 2/8\nl -1 -2 \\\n -3\n", [(1, 2), (4, 3), (3, 2)], []),
        ("p 2\np 4 -4\n", [], [2, 4, 1]),
        ("l 3\nl 1 2\n", [(1, 2)], [3]),
        ("l\np 1 3\n", [], [1, 3]),
        ("f 1 2 3\nl 1 3\np 4\n", [(1, 3)], [4]),
        ("", [], [1, 2, 3, 4]),
        ("vn 0 0 1\ng line\n", [], [1, 2, 3, 4]),
    ],
)
def test_lines_and_points_of_an_obj_file(
    elements: str, lines: list[tuple[int, int]], dots: list[int], tmp_path: Path
) -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=np.float64)
    found = opened(tmp_path / "m.obj", SQUARE + elements)
    expected = corners[np.array(lines, dtype=int).reshape(-1, 2) - 1]
    assert lines_of(found).tolist() == expected.tolist()
    assert dots_of(found).tolist() == corners[np.array(dots, dtype=int) - 1].tolist()
    assert (found.surface is not None) == ("f" in elements)


def test_indices_count_back_from_their_own_line_in_every_block(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.scenes.mesh_files.BLOCK", 10)
    text = "v 0 0 0\nv 1 0 0\nl -1 -2\nv 0 1 0\nl -1 1\np -1\nv 0 0 1\np -1 -2\n"
    found = opened(tmp_path / "m.obj", text)
    assert lines_of(found).tolist() == [[[1, 0, 0], [0, 0, 0]], [[0, 1, 0], [0, 0, 0]]]
    assert dots_of(found).tolist() == [[0, 1, 0], [0, 0, 1], [0, 1, 0]]


def test_a_single_line_is_a_scene_though_faces_on_a_line_are_none(tmp_path: Path) -> None:
    line = opened(tmp_path / "line.obj", "v 1 2 3\nv 1 2 4\nl 1 2\n")
    assert lines_of(line).tolist() == [[[1, 2, 3], [1, 2, 4]]]
    assert not line.start.trace(lines_of(line)[0]).outside.any()


def test_vertices_that_nothing_draws_do_not_count(tmp_path: Path) -> None:
    found = opened(tmp_path / "m.obj", "v 1e6 1e6 1e6\n" + SQUARE + "l 2 3\np 5\n")
    assert found.upper == (1.0, 1.0, 0.0)
    assert lines_of(found).tolist() == [[[0, 0, 0], [1, 0, 0]]]
    assert dots_of(found).tolist() == [[0, 1, 0]]


def test_a_large_file_arrives_whole_from_its_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = "vn 0 0 1\n" + SQUARE.replace("\n", " 0.5 0.25 1\n") + "f 1 2 3\nl 1 2\np 4 1\n"
    here = opened(tmp_path / "m.obj", text)
    monkeypatch.setattr(reading, "SMALL", 10)
    apart = load(str(tmp_path / "m.obj"))
    assert (lines_of(here) == lines_of(apart)).all() and (dots_of(here) == dots_of(apart)).all()
    assert here.dots is not None and apart.dots is not None
    colours = here.dots.point_data["rgb"], apart.dots.point_data["rgb"]
    assert all(np.asarray(each).tolist() == [[128, 64, 255]] * 2 for each in colours)


def test_a_mesh_in_place_of_a_subject_needs_a_surface(tmp_path: Path) -> None:
    (tmp_path / "m.obj").write_text(SQUARE + "l 1 2\n", encoding="utf-8")
    with pytest.raises(Refusal) as refused:
        load("similar-triangles", mesh=str(tmp_path / "m.obj"))
    assert refused.value.bound == REFUSALS["no-surface"]
    (tmp_path / "m.obj").write_text(SQUARE + "f 1 2 3\nl 1 3\np 4\n", encoding="utf-8")
    placed = load("similar-triangles", mesh=str(tmp_path / "m.obj"))
    assert placed.surface is not None
    # Lines and dots move with the faces.
    a, _, c = np.asarray(placed.surface.points)[:3] + placed.origin
    assert np.allclose(lines_of(placed)[0], [a, c]) and len(dots_of(placed)) == 1


def test_each_dot_lies_in_a_box(tmp_path: Path) -> None:
    random = np.random.default_rng(5)
    rows = random.normal(size=(500, 3))
    cloud = opened(tmp_path / "m.obj", "".join(f"v {x} {y} {z}\n" for x, y, z in rows.tolist()))
    low, high = cloud.boxes.dots.min(axis=1)[:, None], cloud.boxes.dots.max(axis=1)[:, None]
    inside = (dots_of(cloud) >= low - 1e-6) & (dots_of(cloud) <= high + 1e-6)
    assert len(low) > 1 and inside.all(axis=2).any(axis=0).all()


def test_a_cloud_is_thinned_like_a_mesh(tmp_path: Path) -> None:
    rows = np.random.default_rng(5).normal(size=(20_000, 3)).round(4)
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in rows.tolist())
    cloud = opened(tmp_path / "m.obj", text)
    assert 0.05 in shares_for_dragging(cloud)
    fewer = reduced(cloud, 0.05)
    assert len(dots_of(fewer)) == 1_000
    assert {*map(tuple, dots_of(fewer))} < {*map(tuple, dots_of(cloud))}
    few = opened(tmp_path / "few.obj", SQUARE)
    assert reduced(few, 0.05) is few


def test_a_document_with_a_cloud_is_saved_and_opened_again(tmp_path: Path) -> None:
    cloud = opened(tmp_path / "m.obj", SQUARE)
    write(Document(cloud.name, cloud.start), tmp_path / "saved.json")
    document = read(tmp_path / "saved.json")
    again = load(document.scene)
    assert document.projection == cloud.start
    assert (dots_of(again) == dots_of(cloud)).all() and len(dots_of(again)) == 4


def test_many_dots_without_colours_are_shaded_like_a_ball(tmp_path: Path) -> None:
    rows = np.random.default_rng(5).normal(size=(finishing.FLAT_DOTS, 3))
    rows /= np.linalg.norm(rows, axis=1, keepdims=True)
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in rows.tolist())
    flat, round_ = (opened(tmp_path / "m.obj", text + more).dots for more in ("", "v 0 1 0\n"))
    assert flat is not None and round_ is not None
    assert {*map(tuple, flat.point_data["rgb"].tolist())} == {DRAWN_RGB}
    light = np.asarray(round_.point_data["rgb"])[:-1].astype(float).sum(axis=1)
    assert light[rows[:, 1] > 0.8].min() > light[rows[:, 1] < -0.8].max()


def test_the_ground_stays_when_points_and_lines_move(tmp_path: Path) -> None:
    found = opened(tmp_path / "m.obj", SQUARE + "l 1 2\np 3\n")
    objects, ground = found.apart
    assert objects.dots is not None and ground.dots is None
    assert objects.lines is not None and ground.lines is not None
    assert not is_grid(np.asarray(objects.lines.cell_data["rgb"])).any()
    assert is_grid(np.asarray(ground.lines.cell_data["rgb"])).all()
