"""Files by the glTF 2.0 specification, written here byte by byte, have the right shape."""

import json
import math
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.model.refusal import REFUSALS, Refusal
from app.scenes import mesh, mesh_files, reading
from app.scenes.scene import load
from app.scenes.shapes import DRAWN_RGB
from tests.support.gltf import SQUARE, GltfSquare
from tests.support.meshes import glb


def read(square: GltfSquare, folder: Path, name: str = "m.glb") -> mesh.Mesh:
    return mesh_files.read(square.write(folder / name))


def bounds(square: GltfSquare, folder: Path) -> list[list[float]]:
    points = read(square, folder).points
    found: list[list[float]] = np.round([points.min(axis=0), points.max(axis=0)], 12).tolist()
    return found


def refusal(square: GltfSquare, folder: Path, name: str = "m.glb") -> tuple[Any, ...]:
    """What the refusal says beside the file's name."""
    with pytest.raises(Refusal) as caught:
        mesh_files.read(square.write(folder / name))
    return (caught.value.bound, *caught.value.limits[1:])


def column_by_column(*places: list[float]) -> list[list[float]]:
    return [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, *place, 1] for place in places]


# --------------------------------------------------------------------------- numbers


@pytest.mark.parametrize(
    ("kind", "numbers", "expected"),
    [
        ("i1", [-128, -127, 127], [-1.0, -1.0, 1.0]),
        ("u1", [0, 51, 255], [0.0, 0.2, 1.0]),
        ("<i2", [-32768, 0, 32767], [-1.0, 0.0, 1.0]),
        ("<u2", [0, 13107, 65535], [0.0, 0.2, 1.0]),
        ("<f4", [-5.5, 2.0, 7.25], [-5.5, 2.0, 7.25]),  # the word has no meaning there
    ],
)
def test_normalised_integers_are_fractions(
    kind: str, numbers: list[float], expected: list[float], tmp_path: Path
) -> None:
    for normalized, right in ((True, expected), (False, numbers)):
        square = GltfSquare()
        corners = [[numbers[0], 0, 0], [numbers[1], 1, 0], [numbers[2], 1, 0], [0, 0, 1]]
        square.primitive["attributes"] = {
            "POSITION": square.add(corners, kind, normalized=normalized)
        }
        found = read(square, tmp_path).points[:3, 0]
        assert np.allclose(found, right, rtol=0, atol=1e-15)


def test_normalised_integers_of_four_bytes_are_refused(tmp_path: Path) -> None:
    square = GltfSquare()
    square.primitive["attributes"] = {"POSITION": square.add(SQUARE, "<u4", normalized=True)}
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], "accessors[2].normalized")


@pytest.mark.parametrize("kind", ["u1", "<u2", "<u4"])
def test_sparse_values_replace_those_of_the_buffer_or_zeros(kind: str, tmp_path: Path) -> None:
    square = GltfSquare()
    accessor = square.content["accessors"][0]
    accessor["sparse"] = square.sparse([2], [[3, 4, 0]], kind)
    assert bounds(square, tmp_path) == [[0, 0, 0], [3, 4, 0]]
    accessor["sparse"] = square.sparse([1, 3], [[2, 0, 0], [0, 5, 0]], kind)
    del accessor["bufferView"]
    assert bounds(square, tmp_path) == [[0, 0, 0], [2, 5, 0]]


def test_sparse_indices_of_faces_are_read(tmp_path: Path) -> None:
    square = GltfSquare()
    sparse = square.sparse([5], [0])
    sparse["values"] = square.view([1], "<u2")
    square.content["accessors"][1]["sparse"] = sparse
    assert read(square, tmp_path).corners.tolist() == [0, 1, 2, 0, 2, 1]


@pytest.mark.parametrize(
    ("places", "kind", "count"), [([4], "u1", 1), ([0], "i1", 1), ([0], "u1", 9), ([0], "u1", 0)]
)
def test_sparse_indices_are_checked(
    places: list[int], kind: str, count: int, tmp_path: Path
) -> None:
    square = GltfSquare()
    sparse = square.sparse(places, [[3, 4, 0]], kind) | {"count": count}
    square.content["accessors"][0]["sparse"] = sparse
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], "accessors[0].sparse")


def test_zeros_that_no_byte_stands_for_are_counted_before_memory_is_used(tmp_path: Path) -> None:
    square = GltfSquare()
    accessor = square.content["accessors"][0]
    del accessor["bufferView"]
    accessor["count"] = 10**12
    assert refusal(square, tmp_path)[0] == REFUSALS["too-much"]
    accessor["sparse"] = square.sparse([2], [[3, 4, 0]])
    assert refusal(square, tmp_path)[0] == REFUSALS["too-much"]


# --------------------------------------------------------------------------- morph targets


def test_morph_targets_have_the_weights_of_the_mesh_unless_the_node_has_some(
    tmp_path: Path,
) -> None:
    square = GltfSquare()
    square.primitive["targets"] = [{"POSITION": square.add([[0, 0, 8]] * 4)}]
    assert bounds(square, tmp_path)[1] == [1, 1, 0]
    square.mesh["weights"] = [0.5]
    assert bounds(square, tmp_path)[1] == [1, 1, 4]
    square.content["nodes"][0]["weights"] = [0.25]
    assert bounds(square, tmp_path)[1] == [1, 1, 2]
    square.content["nodes"].append({"mesh": 0, "translation": [10, 0, 0]})  # with the mesh's 0.5
    square.content["scenes"][0]["nodes"].append(1)
    assert bounds(square, tmp_path) == [[0, 0, 2], [11, 1, 4]]


def test_morph_targets_add_up_and_may_be_sparse_or_normalised(tmp_path: Path) -> None:
    square = GltfSquare()
    sparse = square.add(SQUARE, sparse=square.sparse([1], [[0, 0, 6]]))
    del square.content["accessors"][sparse]["bufferView"]
    fractions = square.add(
        [[0, 0, 0], [0, 0, 0], [0, 0, 32767], [0, 0, -32768]], "<i2", normalized=True
    )
    square.primitive["targets"] = [{"POSITION": sparse}, {"NORMAL": 0}, {"POSITION": fractions}]
    square.mesh["weights"] = [0.5, 1, -2]
    assert read(square, tmp_path).points[:, 2].tolist() == [0, 3, -2, 2]


def test_morph_targets_change_only_the_vertices_that_a_primitive_uses(tmp_path: Path) -> None:
    square = GltfSquare()
    square.primitive["indices"] = square.add([1, 2, 3], "u1")
    square.primitive["targets"] = [{"POSITION": square.add([[0, 0, i] for i in range(4)])}]
    square.mesh["weights"] = [1]
    assert read(square, tmp_path).points[:, 2].tolist() == [1, 2, 3]


def test_a_morph_target_of_another_length_is_refused(tmp_path: Path) -> None:
    square = GltfSquare()
    square.primitive["targets"] = [{"POSITION": square.add([[0, 0, 8]] * 5)}]
    square.mesh["weights"] = [1]
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], "accessors[2].count")


# --------------------------------------------------------------------------- skins


FIRST = [[1.0, 0, 0, 0]] * 4


def test_a_skin_is_placed_by_its_joints_and_not_by_its_node(tmp_path: Path) -> None:
    square = GltfSquare()
    square.content["nodes"][0]["translation"] = [100, 0, 0]
    square.add_skin(np.zeros((4, 4)), FIRST, [{"translation": [0, 0, 7]}])
    assert bounds(square, tmp_path) == [[0, 0, 7], [1, 1, 7]]  # the joint is outside the scene
    square.content["nodes"].append({"children": [1], "scale": [2, 2, 2]})
    assert bounds(square, tmp_path) == [[0, 0, 14], [2, 2, 14]]


def test_the_inverse_bind_matrix_comes_before_the_joint(tmp_path: Path) -> None:
    square = GltfSquare()
    turn = {"rotation": [0, 0, math.sqrt(0.5), math.sqrt(0.5)], "translation": [10, 0, 0]}
    square.add_skin(np.zeros((4, 4)), FIRST, [turn], bind=column_by_column([5, 0, 0]))
    # (x + 5, y) is turned by 90° to (-y, x + 5), then moved by 10
    assert bounds(square, tmp_path) == [[9, 5, 0], [10, 6, 0]]


@pytest.mark.parametrize(
    ("kind", "full"), [("<f4", 1), ("u1", 255), ("<u2", 65535), ("<f4", 7), ("u1", 100)]
)
def test_weights_of_joints_are_fractions_of_their_sum(
    kind: str, full: float, tmp_path: Path
) -> None:
    square = GltfSquare()
    joints = [[0, 0, 0, 0], [1, 0, 0, 0], [0, 1, 9, 9], [0, 0, 0, 0]]  # 9 has no weight
    weights = np.array([[1, 0, 0, 0], [1, 0, 0, 0], [0.8, 0.2, 0, 0], [0, 0, 0, 0]]) * full
    nodes = [{"translation": [0, 0, 10]}, {"translation": [0, 0, 20]}]
    square.add_skin(joints, weights.round(5), nodes, kind)
    # without any weight, a vertex follows its first joint
    assert np.allclose(read(square, tmp_path).points[:, 2], [10, 20, 12, 10], atol=1e-5)


def test_eight_joints_move_a_vertex(tmp_path: Path) -> None:
    square = GltfSquare()
    weights = [[0.125] * 8, [0, 0, 0, 0, 0, 0, 0, 1], *([[1] + [0] * 7] * 2)]
    nodes = [{"translation": [0, 0, i]} for i in range(8)]
    square.add_skin([range(8)] * 4, weights, nodes)
    assert read(square, tmp_path).points[:, 2].tolist() == [3.5, 7, 0, 0]


def test_a_skin_moves_what_the_morph_targets_made(tmp_path: Path) -> None:
    square = GltfSquare()
    square.primitive["targets"] = [{"POSITION": square.add([[0, 0, 8]] * 4)}]
    square.mesh["weights"] = [1]
    square.add_skin(np.zeros((4, 4)), FIRST, [{"scale": [1, 1, 3]}])
    assert bounds(square, tmp_path) == [[0, 0, 24], [1, 1, 24]]


def test_joints_that_mirror_turn_the_faces_over(tmp_path: Path) -> None:
    square = GltfSquare()
    square.add_skin(np.zeros((4, 4)), FIRST, [{"scale": [-1, 1, 1]}])
    found = read(square, tmp_path)
    for a, b, c in found.points[found.corners.reshape(-1, 3)]:
        assert np.cross(b - a, c - a)[2] > 0


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (lambda s: s.content["skins"][0].update(joints=[7]), "nodes[7]"),
        (lambda s: s.content["nodes"][0].update(skin=3), "skins[3]"),
        (lambda s: s.content["accessors"][-2].update(componentType=5120), "JOINTS_0, WEIGHTS_0"),
        (lambda s: s.content["accessors"][-2].update(type="VEC3"), "accessors[2]: 5121, VEC3"),
        (lambda s: s.content["accessors"][-1].update(count=3), "accessors[3].count"),
        (lambda s: s.primitive["attributes"].pop("WEIGHTS_0"), "WEIGHTS_0"),
    ],
)
def test_a_faulty_skin_is_refused(
    change: Callable[[GltfSquare], Any], what: str, tmp_path: Path
) -> None:
    square = GltfSquare()
    square.add_skin(np.zeros((4, 4)), FIRST, [{}])
    change(square)
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], what)


def test_each_joint_has_an_inverse_bind_matrix(tmp_path: Path) -> None:
    square = GltfSquare()
    square.add_skin(np.zeros((4, 4)), FIRST, [{}, {}], bind=column_by_column([5, 0, 0]))
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], "inverseBindMatrices")


@pytest.mark.parametrize(("joint", "weight"), [(1, 1.0), (0, -1.0)])
def test_joints_and_weights_are_checked(joint: int, weight: float, tmp_path: Path) -> None:
    square = GltfSquare()
    square.add_skin([[joint] * 4] * 4, [[weight] * 4] * 4, [{}])
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], "JOINTS_0, WEIGHTS_0")


# --------------------------------------------------------------------------- nodes


def test_instances_are_drawn(tmp_path: Path) -> None:
    square = GltfSquare()
    places = {"TRANSLATION": square.add([[0, 0, 0], [4, 0, 0], [8, 0, 0]])}
    node = square.content["nodes"][0]
    node["extensions"] = {"EXT_mesh_gpu_instancing": {"attributes": places}}
    node["translation"] = [0, 0, 5]
    assert bounds(square, tmp_path) == [[0, 0, 5], [9, 1, 5]]
    assert len(read(square, tmp_path).corners) == 3 * 3 * 2
    half_turn = square.add([[0, 0, 0, 127], [0, 0, 127, 0], [0, 0, 0, 127]], "i1", normalized=True)
    places |= {"ROTATION": half_turn, "SCALE": square.add([[1, 1, 1], [1, 3, 1], [2, 1, 1]])}
    assert bounds(square, tmp_path) == [[0, -3, 5], [10, 1, 5]]
    places["SCALE"] = 0
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], "EXT_mesh_gpu_instancing")


def test_the_default_scene_is_drawn(tmp_path: Path) -> None:
    square = GltfSquare()
    square.content["nodes"].append({"mesh": 0, "translation": [5, 0, 0]})
    square.content["scenes"].append({"nodes": [1]})
    assert bounds(square, tmp_path)[0] == [0, 0, 0]
    square.content["scene"] = 1
    assert bounds(square, tmp_path)[0] == [5, 0, 0]
    del square.content["scenes"]
    assert bounds(square, tmp_path) == [[0, 0, 0], [6, 1, 0]]


def test_what_a_hidden_node_holds_is_not_drawn(tmp_path: Path) -> None:
    square = GltfSquare()
    hidden = {"KHR_node_visibility": {"visible": False}}
    square.content["nodes"] += [
        {"children": [2], "extensions": hidden}, {"mesh": 0, "translation": [5, 0, 0]}
    ]  # fmt: skip
    square.content["scenes"][0]["nodes"].append(1)
    assert bounds(square, tmp_path)[1] == [1, 1, 0]


def test_children_are_placed_by_all_nodes_above_them(tmp_path: Path) -> None:
    square = GltfSquare()
    nodes = square.content["nodes"]
    nodes += [{"children": [i], "translation": [1, 0, 0], "scale": [1, 2, 1]} for i in range(20)]
    square.content["scenes"][0]["nodes"] = [20]
    assert bounds(square, tmp_path) == [[20, 0, 0], [21, 2**20, 0]]


@pytest.mark.parametrize(
    "children", [[[1], [0]], [[1, 1], []], [[2], [2], []], [[], [], [3], [2]], [[0]]]
)
def test_a_node_has_one_parent_and_is_not_its_own_descendant(
    children: list[list[int]], tmp_path: Path
) -> None:
    square = GltfSquare()
    square.content["nodes"] = [{"mesh": 0, "children": each} for each in children]
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], "children")


def test_a_mesh_of_many_nodes_is_as_large_as_they_make_it(tmp_path: Path) -> None:
    square = GltfSquare()
    nodes = [{"mesh": 0, "translation": [2 * i, 0, 0]} for i in range(30_000)]
    square.content["nodes"], square.content["scenes"][0]["nodes"] = nodes, list(range(30_000))
    found = reading.read(square.write(tmp_path / "m.glb"))
    assert len(found.corners) == 30_000 * 6 and found.bounds[1] == (59_999.0, 1.0, 0.0)


def hostile_weights(square: GltfSquare) -> None:
    """Each node has a shape of its own."""
    square.primitive["targets"] = [{"POSITION": 0}]
    count = 15_000
    square.content["nodes"] = [{"mesh": 0, "weights": [i + 1]} for i in range(count)]
    square.content["scenes"][0]["nodes"] = list(range(count))


def hostile_primitives(square: GltfSquare) -> None:
    square.mesh["primitives"] *= 10_000


def hostile_targets(square: GltfSquare) -> None:
    square.primitive["targets"] = [{"POSITION": 0}] * 20_000
    square.content["nodes"] = [{"mesh": 0, "weights": [1] * 1000 + [i]} for i in range(100)]
    square.content["scenes"][0]["nodes"] = list(range(100))


def hostile_roots(square: GltfSquare) -> None:
    """A long chain that the scene names again and again, above a mesh that is too large."""
    hostile_primitives(square)
    count = 20_000
    nodes: list[dict[str, Any]] = [{"children": [i + 1]} for i in range(count)]
    square.content["nodes"] = [*nodes, {"mesh": 0}]
    square.content["scenes"][0]["nodes"] = [0] * count


def hostile_joints(square: GltfSquare) -> None:
    """Each of many vertices has hundreds of joints."""
    count = 10_000
    zeros, ones = square.add(np.zeros((count, 4)), "u1"), square.add(np.ones((count, 4)), "u1")
    square.content["skins"] = [{"joints": [0]}]
    square.content["nodes"][0]["skin"] = 0
    square.primitive.pop("indices")
    attributes = square.primitive["attributes"] = {"POSITION": square.add(np.eye(count, 3))}
    for i in range(300):
        attributes |= {f"JOINTS_{i}": zeros, f"WEIGHTS_{i}": ones}


def hostile_sets(square: GltfSquare) -> None:
    square.add_skin(np.zeros((4, 4)), FIRST, [{}])
    attributes = square.primitive["attributes"]
    for i in range(8_000):
        attributes |= {f"JOINTS_{i}": 2, f"WEIGHTS_{i}": 3}
    square.content["skins"] *= 1000
    square.content["nodes"] += [{"mesh": 0, "skin": i} for i in range(1000)]
    square.content["scenes"][0]["nodes"] = list(range(2, 1002))


@pytest.mark.parametrize(
    "change",
    [
        hostile_weights, hostile_primitives, hostile_targets, hostile_roots, hostile_joints,
        hostile_sets,
    ],
)  # fmt: skip
def test_work_that_a_short_file_multiplies_is_refused_at_once(
    change: Callable[[GltfSquare], None], tmp_path: Path
) -> None:
    """The window's own process reads it only if that is quick."""
    square = GltfSquare()
    change(square)
    path = square.write(tmp_path / "m.glb")
    began = time.process_time()
    with pytest.raises(Refusal) as caught:
        mesh_files.read(path, None, reading.SMALL_MESH)
    assert caught.value.bound == REFUSALS["too-much"] and time.process_time() - began < 2.0


# --------------------------------------------------------------------------- what is not read


def test_a_required_extension_that_is_not_read_is_named(tmp_path: Path) -> None:
    square = GltfSquare()
    square.content["extensionsRequired"] = [
        "KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_variants",
        "EXT_texture_webp", "KHR_lights_punctual", "EXT_mesh_gpu_instancing",
    ]  # fmt: skip
    assert bounds(square, tmp_path)[1] == [1, 1, 0]
    square.content["extensionsRequired"] += ["ACME_gizmo", "EXT_meshopt_compression"]
    expected = REFUSALS["unsupported"], "ACME_gizmo, EXT_meshopt_compression"
    assert refusal(square, tmp_path) == expected


def test_a_packed_mesh_is_read_if_it_is_there_unpacked_too(tmp_path: Path) -> None:
    square = GltfSquare()
    square.content["extensionsUsed"] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression"]
    square.primitive["extensions"] = {"KHR_draco_mesh_compression": {}}
    assert bounds(square, tmp_path)[1] == [1, 1, 0]
    view = square.content["accessors"][0].pop("bufferView")
    assert refusal(square, tmp_path) == (REFUSALS["unsupported"], "KHR_draco_mesh_compression")
    square.content["accessors"][0]["bufferView"] = view
    square.content["bufferViews"][view]["buffer"] = 1
    packed = {"byteLength": 48, "extensions": {"EXT_meshopt_compression": {"fallback": True}}}
    square.content["buffers"].append(packed)
    assert refusal(square, tmp_path) == (REFUSALS["unsupported"], "EXT_meshopt_compression")


def test_another_version_of_gltf_is_named(tmp_path: Path) -> None:
    square = GltfSquare()
    square.content["asset"]["version"] = "2.1"  # readers of 2.0 can read it
    assert bounds(square, tmp_path)[1] == [1, 1, 0]
    square.content["asset"]["minVersion"] = "2.1"
    assert refusal(square, tmp_path) == (REFUSALS["unsupported"], "glTF 2.1")
    square.content["asset"] = {"version": "1.0"}
    assert refusal(square, tmp_path) == (REFUSALS["unsupported"], "glTF 1.0")
    (tmp_path / "m.glb").write_bytes(b"glTF" + np.array([1, 30, 2, 0], "<u4").tobytes() + b"{}")
    with pytest.raises(Refusal, match=r"glTF 1\.0"):
        mesh_files.read(tmp_path / "m.glb")


def test_a_primitive_without_positions_is_not_drawn(tmp_path: Path) -> None:
    square = GltfSquare()
    square.mesh["primitives"].append({"attributes": {"NORMAL": 0}})
    assert bounds(square, tmp_path)[1] == [1, 1, 0]


@pytest.mark.parametrize("mode", [7, -1, "4", None])
def test_an_unknown_mode_is_refused(mode: Any, tmp_path: Path) -> None:
    square = GltfSquare()
    square.primitive["mode"] = mode
    assert refusal(square, tmp_path) == (REFUSALS["damaged"], "mode")


# --------------------------------------------------------------------------- points and lines


@pytest.mark.parametrize(
    ("mode", "order", "lines", "dots"),
    [
        (0, [2, 0], [], [2, 0]),
        (1, [0, 1, 3, 2, 1], [(0, 1), (3, 2)], []),
        (2, [0, 1, 3], [(0, 1), (1, 3), (3, 0)], []),
        (3, [0, 1, 3], [(0, 1), (1, 3)], []),
        (3, [1], [], []),
    ],
)
def test_points_and_lines_are_drawn_beside_triangles_in_every_place_of_their_mesh(
    mode: int, order: list[int], lines: list[tuple[int, int]], dots: list[int], tmp_path: Path
) -> None:
    square = GltfSquare()
    attributes = {"POSITION": square.primitive["attributes"]["POSITION"]}
    others = {"attributes": attributes, "indices": square.add(order, "<u2"), "mode": mode}
    square.mesh["primitives"] = [others, square.primitive]
    square.content["nodes"] = [{"mesh": 0}, {"mesh": 0, "translation": [0, 0, 5]}]
    square.content["scenes"] = [{"nodes": [0, 1]}]
    read = mesh_files.read(square.write(tmp_path / "m.gltf"))
    places = np.array(SQUARE, dtype=np.float64) + np.array([(0, 0, 0), (0, 0, 5)])[:, None]
    wanted = [places[:, np.array(each, dtype=int)] for each in (lines, dots)]
    assert read.points[read.lines].tolist() == wanted[0].reshape(-1, 2, 3).tolist()
    assert read.points[read.dots].tolist() == wanted[1].reshape(-1, 3).tolist()
    assert len(read.offsets) - 1 == 4 and read.rgb is not None and len(read.rgb) == 4


@pytest.mark.parametrize("mode", [0, 1, 2, 3])
def test_points_and_lines_name_vertices_that_exist(mode: int, tmp_path: Path) -> None:
    square = GltfSquare()
    square.primitive |= {"mode": mode, "indices": square.add([0, 4], "<u2")}
    assert refusal(square, tmp_path)[0] == REFUSALS["no-such-vertex"]


def test_points_alone_are_a_cloud_with_their_colours(tmp_path: Path) -> None:
    square = GltfSquare()
    attributes = square.primitive["attributes"]
    attributes["COLOR_0"] = square.add([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1], [1, 1, 1, 1]])
    square.mesh["primitives"] = [{"attributes": attributes, "mode": 0}]
    cloud = load(str(square.write(tmp_path / "m.glb")))
    assert cloud.surface is None and cloud.dots is not None
    assert cloud.dots.point_data["rgb"].tolist() == [
        [255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]
    ]  # fmt: skip


def test_points_lines_and_faces_of_several_nodes_are_joined(tmp_path: Path) -> None:
    square = GltfSquare()
    rgb = square.add([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    attributes = square.primitive["attributes"]
    square.mesh["primitives"] += [
        {"attributes": attributes, "mode": 3},
        {"attributes": attributes | {"COLOR_0": rgb}, "mode": 0},
    ]
    square.content["nodes"].append({"mesh": 0, "translation": [5, 0, 0]})
    square.content["scenes"][0]["nodes"].append(1)
    found = read(square, tmp_path)
    assert len(found.corners) == 2 * 6 and len(found.dots) == 2 * 4
    for copy, moved in enumerate((0, 5)):
        corners = [[x + moved, y, z] for x, y, z in SQUARE]
        assert found.points[found.dots[4 * copy :][:4]].tolist() == corners
        assert found.points[found.lines[3 * copy :][:3, 0]].tolist() == corners[:3]
        assert found.points[found.corners[6 * copy :][:3]].tolist() == corners[:3]
    assert found.dot_rgb is not None and found.rgb is not None
    assert found.dot_rgb[4:7].tolist() == [[255, 0, 0], [0, 255, 0], [0, 0, 255]]
    assert (found.rgb == mesh.PAINT_RGB).all()


@pytest.mark.parametrize(("mode", "count"), [(0, 60), (1, 30), (3, 60), (4, 20), (5, 60)])
def test_points_and_lines_are_counted_before_they_are_read(
    mode: int, count: int, tmp_path: Path
) -> None:
    square = GltfSquare()
    square.primitive |= {"mode": mode, "indices": square.add([0, 1, 2] * 20, "u1")}
    path = square.write(tmp_path / "m.glb")
    assert mesh_files.read(path, None, (count, 2**30)).points.shape == (3, 3)
    with pytest.raises(Refusal) as caught:
        mesh_files.read(path, None, (count - 1, 2**30))
    assert caught.value.limits[1::2] == (count, count - 1)


def test_points_have_the_colour_of_their_material(tmp_path: Path) -> None:
    square = GltfSquare()
    factor = {"pbrMetallicRoughness": {"baseColorFactor": [0, 1, 0, 1]}}
    square.content["materials"] = [factor, {}]
    square.primitive |= {"mode": 0, "material": 1}
    assert read(square, tmp_path).dot_rgb is None
    green = square.primitive | {"material": 0}
    square.mesh["primitives"].append(green)
    found = read(square, tmp_path)
    assert found.dot_rgb is not None
    assert found.dot_rgb[[0, -1]].tolist() == [list(DRAWN_RGB), [0, 255, 0]]


# --------------------------------------------------------------------------- .glb files


def test_the_first_bytes_of_a_file_tell_a_glb(tmp_path: Path) -> None:
    square = GltfSquare()
    (tmp_path / "m.gltf").write_bytes(glb(square.content, square.body))
    assert len(mesh_files.read(tmp_path / "m.gltf").points) == 4


def test_a_chunk_that_is_no_buffer_is_ignored(tmp_path: Path) -> None:
    square = GltfSquare()
    whole = glb(square.content, square.body)
    (tmp_path / "m.glb").write_bytes(whole.replace(b"BIN\0", b"MORE"))
    with pytest.raises(Refusal) as caught:
        mesh_files.read(tmp_path / "m.glb")
    assert caught.value.bound == REFUSALS["cut-off"]
    text = len(json.dumps(square.content))
    for count in (30, text // 2):
        (tmp_path / "m.glb").write_bytes(whole[:count])
        with pytest.raises(Refusal) as caught:
            mesh_files.read(tmp_path / "m.glb")
        assert caught.value.bound == REFUSALS["cut-off"]
