"""Scenes: the built-in ones, the user's mesh in a phenomenon, names, and first cameras."""

import math
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest
import pyvista as pv
from hypothesis import given
from hypothesis import strategies as st

from app.model.projection import Camera, Perspective, Projection
from app.model.refusal import REFUSALS, Cancelled, Refusal
from app.scenes import finishing
from app.scenes.first_camera import frame_camera
from app.scenes.own_mesh import SUBJECT_TRIANGLES
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import BUILT_IN, ENDINGS, SUBJECT_SAMPLE, load
from app.scenes.shapes import distinct_rows
from tests.support.meshes import (
    FAR,
    PYRAMID,
    WRITERS,
    faces,
    obj_file,
    outside,
    pyramid_file,
    rgb,
    segments,
    side,
    world_points,
)

SIDES = ("+x", "-x", "+y", "-y", "+z", "-z")


# --------------------------------------------------------------------------- built-in scenes


def test_l22_letter_f_is_eight_unit_cubes_without_the_faces_between_them() -> None:
    f = load("letter-f")
    drawn = faces(f)
    # 8 cubes x 6 faces, less 2 for each of the 7 touching pairs (4 in the stem, 2 + 1 in the arms)
    assert len(drawn) == 8 * 6 - 2 * 7
    # Gauss: the volume inside a closed surface of outward faces is the sum of area * height / 3.
    volume = sum(
        face.mean(axis=0) @ np.cross(face[1] - face[0], face[3] - face[0]) for face in drawn
    )
    assert volume / 3.0 == pytest.approx(8.0)
    assert (f.lower, f.upper) == ((-1.5, 0.0, -0.5), (1.5, 5.0, 0.5))
    assert f.size == pytest.approx(math.sqrt(9 + 25 + 1))
    assert f.centre == (0.0, 2.5, 0.0)
    # Seen from the front: the columns of each row, from the ground up.
    front = {
        tuple(np.floor(face.mean(axis=0)[:2] + np.array([1.5, 0.0])))
        for face in drawn
        if side(face) == "+z"
    }
    assert front == {(0, 0), (0, 1), (0, 2), (1, 2), (0, 3), (0, 4), (1, 4), (2, 4)}


def test_letter_f_opens_as_the_default_document() -> None:
    assert load("letter-f").start == Projection(
        Camera((5.0, 4.5, 8.0), (0.0, 2.2, 0.0), (0.0, 1.0, 0.0)),
        Perspective(38.0, 5.0, 12.5),
        (1280, 720),
    )


@pytest.mark.parametrize("name", ["letter-f", "cube"])
def test_each_side_of_the_cubes_has_one_colour_of_its_own(name: str) -> None:
    scene = load(name)
    of_side: dict[str, set[tuple[int, ...]]] = {name: set() for name in SIDES}
    for face, colour in zip(faces(scene), rgb(scene).tolist(), strict=True):
        of_side[side(face)].add(tuple(colour))
    assert all(len(colours) == 1 for colours in of_side.values())
    luminance = {
        name: float(np.dot(colours.pop(), (0.2126, 0.7152, 0.0722)))
        for name, colours in of_side.items()
    }
    # Never colour alone: the two sides of an axis differ in a grey picture too.
    for axis in "xyz":
        assert luminance["+" + axis] - luminance["-" + axis] > 25


def test_every_cube_of_the_letter_f_is_outlined() -> None:
    drawn = {tuple(sorted(map(tuple, ends))) for ends in segments(load("letter-f")).tolist()}
    for column, row in ((0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (1, 4), (2, 4), (1, 2)):
        x, y = column - 1.5, float(row)
        corners = [(x, y, 0.5), (x + 1, y, 0.5), (x + 1, y + 1, 0.5), (x, y + 1, 0.5)]
        for a, b in zip(corners, corners[1:] + corners[:1], strict=True):
            assert tuple(sorted((a, b))) in drawn


def test_the_grid_lies_on_the_ground_and_its_axes_are_darker() -> None:
    f = load("letter-f")
    assert f.lines is not None
    ends, colours = segments(f), np.asarray(f.lines.cell_data["rgb"]).astype(int)
    grid = (ends[:, :, 1] == 0.0).all(axis=1) & (abs(ends).max(axis=(1, 2)) > 2.0)
    on_axis = grid & ((ends[:, :, 0] == 0.0).all(axis=1) | (ends[:, :, 2] == 0.0).all(axis=1))
    assert np.count_nonzero(on_axis) == 2
    assert colours[on_axis].max() < colours[grid & ~on_axis].min()
    ordinary = colours[grid & ~on_axis]
    assert (ordinary == ordinary[0]).all() and len(set(ordinary[0])) == 1  # grey


def test_the_cube_is_a_unit_cube_with_its_axes() -> None:
    cube = load("cube")
    assert np.subtract(cube.upper, cube.lower).tolist() == [1.0, 1.0, 1.0]
    assert cube.lower[1] == 0.0  # it stands on the ground
    assert cube.centre == (0.0, 0.5, 0.0)
    assert sorted(map(side, faces(cube))) == sorted(SIDES)
    from_origin = segments(cube)[(segments(cube)[:, 0] == 0.0).all(axis=1)]
    assert [tuple(np.sign(end)) for _, end in from_origin] == [(1, 0, 0), (0, 1, 0), (0, 0, 1)]


def test_posts_recede_at_equal_steps_and_are_numbered_on_geometry() -> None:
    posts = load("posts")
    written = [face for face in faces(posts) if side(face) == "+z" and np.ptp(face[:, 1]) < 0.8]
    z = sorted({float(face[0, 2].round(3)) for face in written}, reverse=True)
    assert len(z) == 6
    assert np.allclose(np.diff(z), np.diff(z)[0])
    for number in range(1, 7):
        mine = np.array([face for face in written if abs(face[0, 2] - z[number - 1]) < 1e-3])
        assert read_display(mine) == str(number)


# The usual code of a seven-segment display: bit 0 is the top, then clockwise, bit 6 the middle.
DISPLAY = {code: str(i) for i, code in enumerate(bytes.fromhex("3F065B4F666D7D077F6F"))}


def read_display(quads: np.ndarray) -> str:
    """Read seven-segment digits, (m, 4, 3), from the front: from -x to +x."""
    x, y = quads.mean(axis=1)[:, 0], quads.mean(axis=1)[:, 1]
    height, middle = 0.8, 2.05
    width, pitch = height / 2, 0.75 * height
    count = 1 if np.ptp(x) < width else 2
    text = ""
    for place in range(count):
        centre = (place - (count - 1) / 2) * pitch
        code = 0
        for right, up in zip((x - centre) / width, (y - middle) / height, strict=True):
            if abs(right) < 0.7:
                column, row = round(right / 0.4), round(up / 0.225)
                code |= 1 << {(0, 2): 0, (1, 1): 1, (1, -1): 2, (0, -2): 3, (-1, -1): 4,
                              (-1, 1): 5, (0, 0): 6}[column, row]  # fmt: skip
        text += DISPLAY[code]
    return text


CUT = (
    "view-volumes", "off-axis-window", "eye-plane", "far-plane-popping", "focus", "clipping",
    "vertex-depth", "cracks",
)  # fmt: skip
"""Scenes about what is not seen: test points, cards and trees outside the view volume, a beam that
runs out of the window's side, a letter through the eye plane; and a row that begins before the
picture's edge, where what is too near is out of focus; a floor from near on, and long meshes."""


@pytest.mark.parametrize("name", BUILT_IN)
def test_all_of_a_built_in_scene_is_in_view_when_it_opens(name: str) -> None:
    scene = load(name)
    assert scene.name == name
    points = world_points(scene)
    assert outside(scene.start, points) == (name in CUT)
    assert np.allclose(points.min(axis=0), scene.lower)
    assert np.allclose(points.max(axis=0), scene.upper)


def test_built_in_scenes_are_in_lecture_order() -> None:
    assert BUILT_IN[:4] == ("letter-f", "cube", "posts", "similar-triangles")
    assert BUILT_IN[3:] == tuple(PHENOMENA)


def test_a_scene_knows_its_phenomenon_and_its_subject() -> None:
    plain = load("letter-f")
    assert plain.phenomenon is None and plain.requires == frozenset()
    scene = load("similar-triangles")
    assert scene.phenomenon is PHENOMENA["similar-triangles"]
    assert scene.requires == scene.phenomenon.requires
    assert scene.start == scene.phenomenon.start
    subject = scene.subject
    assert (subject.lower, subject.upper) == (scene.lower, scene.upper)
    assert {tuple(p) for p in subject.points.tolist()} == {
        tuple(p) for p in world_points(scene).tolist()
    }
    grid = np.abs(segments(scene)).max()
    assert np.abs(subject.points).max() < grid  # without the ground
    large = replace(scene, surface=pv.PolyData(np.zeros((2 * SUBJECT_SAMPLE - 1, 3))))
    assert SUBJECT_SAMPLE / 2 <= len(large.subject.points) <= SUBJECT_SAMPLE


# --------------------------------------------------------------------------- meshes from files


@pytest.mark.parametrize("kind", WRITERS)
def test_a_mesh_takes_the_place_of_a_phenomenons_subject(kind: str, tmp_path: Path) -> None:
    built_in = load("similar-triangles")
    path = pyramid_file(tmp_path, kind, 64.0)
    scene = load("similar-triangles", mesh=str(path))
    assert scene.name == "similar-triangles" and scene.phenomenon is built_in.phenomenon
    assert scene.start == built_in.start
    points = np.unique(world_points(scene).round(5), axis=0)
    # Scaled uniformly, as large as the depth of 1 allows, and moved.
    offset, scale = np.unique(PYRAMID, axis=0), 1.0 / (3.125 - 0.25)
    expected = (offset - PYRAMID.min(axis=0)) * scale
    assert len(points) == 5
    assert np.allclose(np.ptp(points, axis=0), np.ptp(expected, axis=0), atol=1e-5)
    assert min(np.subtract(built_in.upper, built_in.lower) - np.ptp(points, axis=0)) > -1e-5
    middle = (points.min(axis=0) + points.max(axis=0)) / 2.0
    assert points[:, 1].min() == pytest.approx(built_in.lower[1])  # it stands where that stood
    assert np.allclose(middle[[0, 2]], np.array(built_in.centre)[[0, 2]], atol=1e-5)
    assert np.allclose(scene.lower, points.min(axis=0), atol=1e-5)
    assert np.allclose(scene.subject.points.max(axis=0), scene.upper, atol=1e-5)
    # The ground of the scene stays; the edges of its subject go.
    lines = segments(built_in)
    ground = {
        tuple(map(tuple, ends)) for ends in lines[np.ptp(lines, axis=1).max(axis=1) > 5.0].tolist()
    }
    drawn = {tuple(map(tuple, ends)) for ends in segments(scene).tolist()}
    assert len(ground) > 20 and ground <= drawn
    assert len(drawn - ground) >= 5
    assert not outside(scene.start, world_points(scene))


@pytest.mark.parametrize(
    ("sides", "is_seen"),
    [
        ((1.0, 1.0, 1.0), True),
        ((4.0, 1.0, 4.0), True),
        ((2.0, 3.0, 1.0), True),
        ((1.0, 1.0, 16.0), False),
        ((7.0, 0.0, 7.0), True),
    ],
)
def test_a_mesh_in_the_scene_of_the_eye_plane_goes_through_it(
    sides: tuple[float, float, float], is_seen: bool, tmp_path: Path
) -> None:
    path = tmp_path / "box.ply"
    x, y, z = sides
    box = pv.Box((5.0, 5.0 + x, 7.0, 7.0 + y, -2.0, z - 2.0)).triangulate().subdivide(3)
    box.save(path)
    scene = load("eye-plane", mesh=str(path))
    trace = scene.start.trace(world_points(scene))
    assert (trace.clip[:, 3] > 0.0).any() and (trace.clip[:, 3] < 0.0).any()
    assert (~trace.outside.any(axis=1)).any() == is_seen
    size = np.subtract(scene.upper, scene.lower)
    assert size.max() <= 20.0 and np.allclose(size / size.max(), np.array(sides) / max(sides))


@pytest.mark.parametrize("kind", WRITERS)
def test_a_mesh_in_a_phenomenon_has_its_edges_once(kind: str, tmp_path: Path) -> None:
    """Even if the file repeats a vertex for every face."""
    assert load("eye-plane").subject.mesh is None
    scene = load("eye-plane", mesh=str(pyramid_file(tmp_path, kind, 64.0)))
    assert "subject" in vars(scene), "found while progress is shown, not by the first drawing"
    mesh = scene.subject.mesh
    assert mesh is not None and not mesh.more_triangles
    assert mesh.edge_count == len(mesh.edges)
    ends = {frozenset(map(tuple, edge)) for edge in mesh.edges.round(4).tolist()}
    assert len(ends) == len(mesh.edges)
    lengths = np.linalg.norm(mesh.edges[:, 1] - mesh.edges[:, 0], axis=1)
    assert (np.diff(lengths) <= 0.0).all()
    sides = mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2, 3)
    assert ends <= {frozenset(map(tuple, edge)) for edge in sides.round(4).tolist()}
    assert len(ends) in (8, 9)  # the base may be one face or two


def test_a_large_mesh_in_a_phenomenon_has_its_longest_edges(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.scenes.own_mesh.SUBJECT_EDGES", 200)
    random = np.random.default_rng(2)
    points = random.normal(size=(900, 3))
    lines = [f"v {x} {y} {z}" for x, y, z in points.tolist()]
    faces = np.stack([np.arange(1, 899), np.arange(2, 900), np.arange(3, 901)], axis=1)
    faces = np.concatenate([faces, random.permuted(faces, axis=0)])
    faces = faces[[len(set(face)) == 3 for face in faces.tolist()]]
    path = tmp_path / "many.obj"
    path.write_text(
        "\n".join(lines + [f"f {a} {b} {c}" for a, b, c in faces.tolist()]), encoding="utf-8"
    )
    mesh = load("affine-depth", mesh=str(path)).subject.mesh
    assert mesh is not None and mesh.more_triangles
    assert len(mesh.edges) == 200 and len(mesh.triangles) == SUBJECT_TRIANGLES
    pairs = {tuple(sorted(pair)) for a, b, c in faces.tolist() for pair in ((a, b), (b, c), (c, a))}
    all_lengths = sorted((float(np.linalg.norm(points[a - 1] - points[b - 1])) for a, b in pairs),
                         reverse=True)  # fmt: skip
    assert mesh.edge_count == len(pairs)
    found = np.linalg.norm(mesh.edges[:, 1] - mesh.edges[:, 0], axis=1)
    expected = np.array(all_lengths[:200])
    assert np.allclose(found / found[0], expected / expected[0], rtol=1e-4)
    sides = mesh.triangles - np.roll(mesh.triangles, 1, axis=1)
    longest = np.linalg.norm(sides, axis=2).max(axis=1)
    assert (np.diff(longest) <= 0.0).all() and np.isclose(longest[0], found[0])


def test_a_mesh_of_points_in_a_phenomenon_has_an_edge(tmp_path: Path) -> None:
    """Each face is a point, but not the same one."""
    path = tmp_path / "points.obj"
    points = "".join(3 * f"v {place}\n" for place in ("0 0 0", "1 0 0", "1 1 0"))
    path.write_text(f"{points}f 1 2 3\nf 4 5 6\nf 7 8 9\n", encoding="utf-8")
    for name in ("interpolation", "affine-depth", "eye-plane"):
        scene = load(name, mesh=str(path))
        mesh, phenomenon = scene.subject.mesh, scene.phenomenon
        assert mesh is not None and mesh.edges.shape == (1, 2, 3)
        assert phenomenon is not None
        phenomenon.illustration(scene.start, phenomenon.checked({}), scene.subject)


def test_a_flat_mesh_and_one_of_another_scale_stand_there_too(tmp_path: Path) -> None:
    built_in = load("similar-triangles")
    for number, points in enumerate(
        (PYRAMID * (1.0, 0.0, 1.0), PYRAMID * (0.0, 1.0, 1.0), PYRAMID * 1e20, PYRAMID * 1e-20)
    ):
        path = tmp_path / f"{number}.obj"
        obj_file(path, points)
        scene = load("similar-triangles", mesh=str(path))
        room, taken = (np.subtract(s.upper, s.lower) for s in (built_in, scene))
        assert (taken <= room + 1e-5).all()
        assert np.isclose(taken, room, atol=1e-5).any()
        assert scene.lower[1] == pytest.approx(built_in.lower[1])


def test_a_mesh_that_no_scene_can_take_is_refused(tmp_path: Path) -> None:
    path = str(pyramid_file(tmp_path, "obj"))
    with pytest.raises(Refusal) as caught:
        load("cube", mesh=path)
    assert str(caught.value) == (
        f"mesh = {path}: the scene “cube” has a subject of its own, which no mesh can replace."
    )
    for wrong in (str(tmp_path / "m.xyz"), str(tmp_path / "none.obj")):
        with pytest.raises(Refusal, match="no such file"):
            load("similar-triangles", mesh=wrong)
    (tmp_path / "m.txt").write_text("hello", encoding="utf-8")
    with pytest.raises(Refusal, match="must end in"):
        load("similar-triangles", mesh=str(tmp_path / "m.txt"))
    fractions: list[float] = []
    load("similar-triangles", lambda f: fractions.append(f) is None, mesh=path)
    assert fractions == sorted(fractions) and fractions[-1] == 1.0
    with pytest.raises(Cancelled):
        load("similar-triangles", lambda _: False, mesh=path)


def test_edges_of_small_meshes_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = str(pyramid_file(tmp_path, "stl text"))
    edges = [ends for ends in segments(load(path)).tolist() if PYRAMID[4].tolist() in ends]
    assert len(edges) == 4
    monkeypatch.setattr(finishing, "FACES_WITH_EDGES", 5)
    assert not (segments(load(path)) == PYRAMID[4]).all(axis=2).any()


def test_the_grid_is_under_a_mesh_at_round_places(tmp_path: Path) -> None:
    scene = load(str(pyramid_file(tmp_path, "ply text", FAR)))
    ends = segments(scene)
    grid = ends[
        (ends[:, :, 1] == scene.lower[1]).all(axis=1)
        & (np.ptp(ends, axis=1).max(axis=1) > scene.size)
    ]
    x = np.unique(grid[grid[:, 0, 0] == grid[:, 1, 0]][:, 0, 0])
    spacing = np.diff(x)
    assert (spacing == 0.5).all()  # the size is 5.0: an eighth of it is 0.63
    assert (x / spacing[0] % 1.0 == 0.0).all()
    assert x.min() <= scene.lower[0] - spacing[0]
    assert x.max() >= scene.upper[0] + spacing[0]
    assert len(x) < 50


# --------------------------------------------------------------------------- names


def refusal(name: str) -> str:
    with pytest.raises(Refusal) as caught:
        load(name)
    sentence = str(caught.value)
    assert "\n" not in sentence
    assert sentence.endswith((".", "?"))
    return sentence


def test_other_endings_are_answered_with_the_list(tmp_path: Path) -> None:
    (tmp_path / "mesh.off").write_text("OFF\n", encoding="utf-8")
    sentence = refusal(str(tmp_path / "mesh.off"))
    assert str(tmp_path / "mesh.off") in sentence
    assert all(ending in sentence for ending in ENDINGS)
    assert "no such file" in refusal(str(tmp_path / "missing.off"))
    assert "directory" in refusal(str(tmp_path))


@pytest.mark.parametrize(
    ("name", "nearest"),
    [("letterf", "letter-f"), ("LETTER_F", "letter-f"), ("kube", "cube"), ("post", "posts")],
)
def test_an_unknown_name_is_answered_with_the_nearest(name: str, nearest: str) -> None:
    sentence = refusal(name)
    assert f"“{name}”" in sentence
    assert sentence.endswith(f"did you mean “{nearest}”?")
    quoted = Refusal.in_document(REFUSALS["cannot-be"], sentence, field="line 8")
    assert str(quoted) == f"line 8 cannot be shown: {sentence}"  # a question needs no full stop


@pytest.mark.parametrize("name", ["", "xyzzy", ".stl"])
def test_a_name_like_no_scene_is_answered_with_all(name: str) -> None:
    assert all(known in refusal(name) for known in BUILT_IN)


# --------------------------------------------------------------------------- the first camera


def box_strategy() -> st.SearchStrategy[tuple[tuple[float, ...], tuple[float, ...]]]:
    """Boxes of size 1e-6 to 1e9, also flat or thin ones, anywhere within 1e7 of the origin."""
    shape = st.tuples(*[st.sampled_from([0.0, 1e-3, 0.1, 0.5, 1.0])] * 3).filter(any)
    centre = st.tuples(*[st.floats(-1e7, 1e7)] * 3)

    def box(
        size: float, shape: tuple[float, ...], centre: tuple[float, ...], near: bool
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        at = tuple(c * size / 1e7 if near else c for c in centre)
        lower = tuple(c - size * s / 2 for c, s in zip(at, shape, strict=True))
        return lower, tuple(low + size * s for low, s in zip(lower, shape, strict=True))

    sizes = st.floats(-6.0, 9.0).map(lambda power: 10.0**power)
    boxes = st.builds(box, sizes, shape, centre, st.booleans())
    # at 1e7 float64 steps are 2e-9: leave boxes that have a shape there
    return boxes.filter(lambda b: math.dist(*b) > 1e3 * math.ulp(max(map(abs, b[0] + b[1]))))


def corners(lower: tuple[float, ...], upper: tuple[float, ...]) -> np.ndarray:
    return np.array(list(product(*zip(lower, upper, strict=True))))


@given(box_strategy())
def test_framing_shows_every_box_whole_with_room_around_it(
    box: tuple[tuple[float, ...], tuple[float, ...]],
) -> None:
    lower, upper = box
    projection = frame_camera(lower, upper)
    size = math.dist(lower, upper)
    trace = projection.trace(corners(lower, upper))
    assert not trace.outside.any()
    assert 0.15 < abs(trace.ndc[:, :2]).max() < 0.85  # room, but not lost in it
    camera, lens = projection.camera, projection.lens
    middle = [(low + high) / 2 for low, high in zip(lower, upper, strict=True)]
    assert math.dist(camera.target, middle) < 0.01 * size
    assert lens.near >= camera.distance / 100
    assert lens.near < camera.distance < lens.far
    assert lens.far / lens.near < 100


def test_framing_looks_from_a_three_quarter_view_by_default() -> None:
    camera = frame_camera((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0)).camera
    assert all(0.2 < part < 0.9 for part in np.array(camera.eye) / camera.distance)
    assert camera.up == (0.0, 1.0, 0.0)


def test_framing_gives_numbers_that_can_be_read() -> None:
    projection = frame_camera((0.0, 0.0, 0.0), (math.pi, math.e, math.sqrt(2.0)))
    shown = [
        *projection.camera.eye,
        *projection.camera.target,
        projection.lens.near,
        projection.lens.far,
    ]
    assert all(len(repr(abs(number))) <= 6 for number in shown)


def test_distinct_rows_are_those_of_numpy() -> None:
    random = np.random.default_rng(1)
    for count in range(1, 60):
        rows = random.integers(-1, 2, (count, 3)) * random.choice([1.0, -0.0])
        wanted, places = np.unique(rows, axis=0, return_inverse=True)
        found, where = distinct_rows(rows)
        assert (found == wanted).all() and (where == places.ravel()).all()


@pytest.mark.parametrize("name", BUILT_IN)
def test_each_face_and_each_line_lies_whole_in_a_box(name: str) -> None:
    scene = load(name)
    origin = np.array(scene.origin)
    assert scene.surface is not None and scene.lines is not None
    faces, dots, lines = scene.boxes
    assert scene.dots is None and not len(dots)
    for mesh, cells, boxes in (
        (scene.surface, scene.surface.regular_faces, faces),
        (scene.lines, np.arange(scene.lines.n_points).reshape(-1, 2), lines),
    ):
        points = mesh.points[cells].astype(float)[:, None] + origin
        low, high = boxes.min(axis=1)[:, None], boxes.max(axis=1)[:, None]
        inside = (points >= low - 1e-9) & (points <= high + 1e-9)
        assert inside.all(axis=(2, 3)).any(axis=1).all()
    everything = scene.boxes.together
    assert np.allclose(everything.min(axis=(0, 1)), scene.corners.min(axis=0))
    assert np.allclose(everything.max(axis=(0, 1)), scene.corners.max(axis=0))
