"""The depth buffer's readings, against rays that are cut with the ramp in world space."""

import math
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import pyvista as pv

from app.drawings.off_screen import off_screen
from app.drawings.rasterising import counted_wrong_share
from app.model.depth import DepthBuffer
from app.model.lenses import LENSES
from app.model.projection import Array, Camera, Orthographic, Perspective, Projection
from app.scenes.phenomena.depth_buffer import PHENOMENON, buffer_of, distances
from app.scenes.phenomena.illustration import Subject
from app.scenes.phenomena.sampling import seen_distances
from app.scenes.phenomena.words import Phrase
from app.scenes.scene import load
from app.scenes.shapes import box_faces
from tests.oracles.illustrations import projections, showing

RAMP = np.array([(-5.0, 0, 4), (5, 0, 4), (5, 6, -44), (-5, 6, -44)])
RANGES = [name for name, _ in next(s.choices for s in PHENOMENON.settings if s.name == "range")]
SUBJECT = Subject((-5.0, 0.0, -44.0), (5.0, 6.0, 4.0), RAMP[[2, 0, 3, 1]])


shown = showing(PHENOMENON, SUBJECT)


def random_projection(random: np.random.Generator, number: int) -> Projection:
    eye = (random.uniform(-6, 6), random.uniform(2, 9), random.uniform(8, 16))
    target = (random.uniform(-2, 2), random.uniform(0, 4), random.uniform(-20, -3))
    near, far = 10.0 ** random.uniform(-3, 0), 10.0 ** random.uniform(1.8, 4)
    lens = Perspective(random.uniform(30, 70), near, far)
    projection = Projection(Camera(eye, target, (0.0, 1.0, 0.0)), lens, (640, 360))
    return projection.with_lens(list(LENSES)[number % len(LENSES)])


def brute_force(projection: Projection, gap: float, random: np.random.Generator) -> Array:
    """Distances of both surfaces at random pixels, (k, 2), by un-projected rays."""
    pixels = random.uniform((0, 0), projection.image_size, (20_000, 2))
    depths = [np.full((len(pixels), 1), part) for part in (0.0, 0.9)]
    first, last = (
        projection.world_from_image(np.concatenate([pixels, depth], axis=1)) for depth in depths
    )
    across, along = RAMP[1] - RAMP[0], RAMP[3] - RAMP[0]
    normal = np.cross(across, along)
    n, eye = projection.camera.frame[2], np.array(projection.camera.eye)
    found = []
    aside = np.cross(normal, n)
    for shift in (np.zeros(3), -gap * n + 3.0 * aside / np.linalg.norm(aside)):
        part = ((RAMP[0] + shift - first) @ normal) / ((last - first) @ normal)
        place = first + part[:, None] * (last - first)
        local = place - RAMP[0] - shift
        s, t = local @ across / (across @ across), local @ along / (along @ along)
        w = (eye - place) @ n
        on = (np.abs(s - 0.5) <= 0.5) & (np.abs(t - 0.5) <= 0.5) & (w >= projection.lens.near)
        found.append(np.where(on & (w <= projection.lens.far), w, np.nan))
    both: Array = np.array(found).T
    return both[np.isfinite(both).all(axis=1)]


def test_the_share_matches_rays_cut_with_the_ramp() -> None:
    """At 50 settings, within 4 points of 20 000 random pixels with equal codes."""
    random = np.random.default_rng(17)
    between = 0
    for number in range(50):
        projection = random_projection(random, number)
        parallel = projection.lens.parallel
        settings = {
            "range": RANGES[number % 2] if parallel else RANGES[number // 4 % 4],
            "format": str(random.choice(["fixed8", "fixed16", "fixed24", "float16", "float32"])),
        }
        buffer = buffer_of(projection, settings)
        assert isinstance(buffer, DepthBuffer)
        step = min(float(buffer.gap(projection.camera.distance)), 4.0)
        gap = min(max(step * 10.0 ** random.uniform(-1.0, 0.3), 1e-9), 3.0)
        w = brute_force(projection, gap, random)
        codes = buffer.encode(w)
        wrong = 100.0 * np.mean((codes[:, 0] == codes[:, 1]) & (w[:, 1] > w[:, 0]))
        reading = shown(projection, gap=gap, **settings).readings[0]
        assert reading.value == pytest.approx(wrong, abs=4.0), (projection, settings, gap)
        between += 5.0 < wrong < 95.0
    assert between >= 20


def test_the_share_that_the_text_names_is_that_of_a_million_rays_and_has_no_digit_more() -> None:
    """Rays of 45 degrees from (3, 7, 15), cut with both ramps here, without the scene's code."""
    eye, rng = np.array([3.0, 7.0, 15.0]), np.random.default_rng(3)
    n = (eye - (0.0, 1.5, -8.0)) / np.linalg.norm(eye - (0.0, 1.5, -8.0))
    u = np.cross((0.0, 1.0, 0.0), n) / np.linalg.norm(np.cross((0.0, 1.0, 0.0), n))
    x, y = rng.uniform(-1.0, 1.0, (2, 2_000_000)) * math.tan(math.pi / 8)
    rays = np.outer(x * 16 / 9, u) + np.outer(y, np.cross(n, u)) - n
    across, along = np.array([10.0, 0.0, 0.0]), np.array([0.0, 6.0, -48.0])
    m = np.cross(across, along)
    aside = np.cross(m, n)
    corner, w, inside = np.array([-5.0, 0.0, 4.0]), [], np.ones(len(rays), bool)
    for moved in (0.0 * n, 3.0 * aside / np.linalg.norm(aside) - 0.25 * n):
        w.append(((corner + moved - eye) @ m) / (rays @ m))
        place = eye + w[-1][:, None] * rays - corner - moved
        for side in (across, along):
            inside &= (place @ side >= 0.0) & (place @ side <= side @ side)
    for near, far, said in ((0.01, 200.0, 63), (0.1, 200.0, 0), (0.01, 60.0, 63)):
        seen = inside & (np.maximum(*w) <= far)
        one, other = (np.rint(65535 * far / (far - near) * (1 - near / each[seen])) for each in w)
        share = 100.0 * np.mean(one == other)
        assert abs(share - said) < 0.5 and f"{said} %" in PHENOMENON.words.explanation
        seen_by = replace(PHENOMENON.start, lens=Perspective(45.0, near, far))
        assert shown(seen_by).readings[0].value == said


def test_l17_the_smallest_gap_at_the_target_is_the_lectures() -> None:
    """w^2/(n 2^24) for 24 bits and far >> near; the same for 16; none beyond far."""
    camera = Camera((0.0, 6.0, 12.0), (0.0, 2.0, -10.0), (0.0, 1.0, 0.0))
    for near in (0.01, 0.03, 0.1, 0.3):
        for bits in (16, 24, 32):
            at = Projection(camera, Perspective(45.0, near, 1e9))
            reading = shown(at, format=f"fixed{bits}").readings[2]
            w = camera.distance
            step = w**2 / (near * 2**bits)
            assert reading.value == pytest.approx(step / (1.0 - step / w), rel=2e-2 / near**0.1)
    behind = shown(Projection(camera, Perspective(45.0, 1.0, 10.0))).readings
    assert behind[2].value is None and behind[2].note is not None


def test_a_surface_that_comes_to_lie_in_front_is_never_wrong() -> None:
    """If the camera looks up along the ramp, the move along n brings surface 2 to the front."""
    up = Projection(
        Camera((0.0, 9.0, 12.0), (0.0, 29.0, -28.0), (0.0, 1.0, 0.0)),
        Perspective(100.0, 0.01, 200.0),
    )
    first, second = distances(up, 0.01, SUBJECT)
    assert len(first) > 100 and (second < first).all()
    buffer = DepthBuffer("fixed8", "opengl", Perspective(near=0.01, far=200.0))
    assert (buffer.encode(first) == buffer.encode(second)).all()
    assert shown(up, format="fixed8", gap=0.01).readings[0].value == 0.0


def test_a_ramp_of_less_than_a_pixel_has_no_share() -> None:
    """At 179 degrees it has some pixels, which may be too few to count."""
    lens = PHENOMENON.start.lens
    for fov, known, why in ((179.9, False, "no pixel"), (179.0, True, "too few")):
        illustration = shown(replace(PHENOMENON.start, lens=replace(lens, fov_y_deg=fov)))
        computed, counted = illustration.readings[:2]
        assert (computed.value is not None) == (computed.note is None) == known
        assert counted.note is not None and counted.note.sentence().startswith(why)


MESHES: dict[str, Callable[[], pv.PolyData]] = {
    "triangle": lambda: pv.Triangle(),
    "sloping quad": lambda: pv.Plane(i_resolution=1, j_resolution=1).rotate_x(60),
    "cube": lambda: pv.Cube().triangulate(),
    "sphere": lambda: pv.Sphere(theta_resolution=20, phi_resolution=20),
    "torus": lambda: pv.ParametricTorus(u_res=40, v_res=40, w_res=40).triangulate(),
    "fine sphere": lambda: pv.Sphere(theta_resolution=60, phi_resolution=60),
}
"""From one triangle to more than `SUBJECT_SURFACE`, which are simplified."""


@pytest.mark.parametrize("name", MESHES)
def test_the_share_of_a_mesh_is_that_of_its_pixels(name: str, tmp_path: Path) -> None:
    """Within 5 points of the pixels of a picture."""
    path = tmp_path / "mesh.ply"
    MESHES[name]().save(path)
    scene = load("depth-buffer", mesh=str(path))
    start = PHENOMENON.start
    near_by = replace(start, camera=replace(start.camera, eye=(1.0, 6.0, 6.0)))
    between = 0
    for projection in (start, near_by, start.with_lens("orthographic")):
        for settings in (
            {"gap": 0.25, "format": "fixed16"},
            {"gap": 0.5, "format": "fixed8"},
            {"gap": 0.2, "format": "fixed8", "range": "logarithmic"},
            {"gap": 0.01, "format": "float16", "range": "reversed"},
        ):
            if projection.lens.parallel and settings.get("range") == "logarithmic":
                continue
            illustration = PHENOMENON.show(projection, PHENOMENON.checked(settings), scene.subject)
            assert illustration.rendering is not None and illustration.rendering.buffer is not None
            with off_screen(640, 360) as plotter:
                counted = counted_wrong_share(
                    plotter,
                    scene,
                    projection,
                    illustration.rendering.buffer,
                    illustration.copies[0].world_from_world,
                )
            predicted = illustration.readings[0].value
            assert counted is not None and isinstance(predicted, float)
            assert abs(predicted - 100.0 * counted) <= 5.0, (projection.lens.kind, settings)
            between += 10.0 < predicted < 90.0
    assert between >= 3


def test_a_mesh_round_the_eye_is_cut_at_near() -> None:
    """Triangles that cross the eye plane: a box from inside, against its sides' distances."""
    quads = box_faces((-2.0, -2.0, -2.0), (2.0, 2.0, 2.0))
    surface = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    at = Projection(
        Camera((0.0, 0.0, 1.0), (0.0, 0.0, -3.0)), Perspective(120.0, 0.1, 50.0), (800, 600)
    )
    first, second = seen_distances(at, surface, 0.5)
    assert len(first) > 1000
    # Straight ahead the wall z = -2 is 3 away; the sides run from the eye to it.
    assert first.max() == pytest.approx(3.0) and second.max() == pytest.approx(3.5)
    # Of the picture, 2 tan 60 high and 4/3 of that wide, the wall fills 4/3 by 4/3; moved, 8/7.
    half = math.tan(math.radians(60.0))
    for distances_seen, wall in ((first, 3.0), (second, 3.5)):
        share = np.mean(distances_seen > wall - 1e-9)
        assert share == pytest.approx((2.0 / wall) ** 2 / (half**2 * 4.0 / 3.0), abs=0.02)


def test_a_mesh_at_the_limits_has_a_share_or_a_reason(tmp_path: Path) -> None:
    """Every lens, and cameras in the mesh, beside it and 1e100 away; and faces without area."""
    path = tmp_path / "ball.ply"
    MESHES["sphere"]().save(path)
    subject = load("depth-buffer", mesh=str(path)).subject
    shares = 0
    for projection in projections(PHENOMENON):
        reading = PHENOMENON.show(projection, PHENOMENON.checked({}), subject).readings[0]
        assert isinstance(reading.value, float) or reading.note is not None
        if isinstance(reading.value, float):
            assert 0.0 <= reading.value <= 100.0
            shares += 1
    assert shares > 20
    path = tmp_path / "lines.obj"
    path.write_text(
        "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 0 1 0\nv 0 3 0\nf 1 2 3\nf 1 4 5\n", encoding="utf-8"
    )
    subject = load("depth-buffer", mesh=str(path)).subject
    reading = PHENOMENON.show(PHENOMENON.start, PHENOMENON.checked({}), subject).readings[0]
    assert reading.value is None and reading.note is not None


def test_a_buffer_that_the_lens_cannot_have_is_explained() -> None:
    start = PHENOMENON.start
    flat = replace(start, lens=Orthographic(-8.0, 8.0, -5.0, 5.0, 1.0, 80.0))
    endless = replace(start, lens=Perspective(45.0, 1.0, math.inf))
    for projection, chosen in ((flat, "logarithmic"), (flat, "infinite"), (endless, "logarithmic")):
        illustration = shown(projection, range=chosen)
        assert isinstance(illustration.warning, Phrase) and illustration.rendering is None
        assert len(illustration.copies) == 1
    away = replace(start, camera=Camera((0.0, 6.0, 12.0), (0.0, 6.0, 40.0), (0.0, 1.0, 0.0)))
    reading = shown(away).readings[0]
    assert reading.value is None and reading.note is not None
    fine = shown(replace(start, lens=Perspective(45.0, 1.0, 90.0)), format="fixed32", gap=1e-7)
    assert fine.readings[0].note is not None and fine.readings[0].value is not None


@pytest.mark.parametrize(("name", "largest"), [("fixed8", 2**8 - 1), ("fixed24", 2**24 - 1)])
def test_the_ticks_are_codes(name: str, largest: int) -> None:
    """Both axes: every 32nd part of the codes, and the last one; 8 bits: every 8th code."""
    diagram = shown(PHENOMENON.start, format=name).diagrams[0]
    buffer = DepthBuffer(name, "opengl", Perspective(near=0.01, far=200.0))
    assert diagram.y_ticks is not None and diagram.x_ticks is not None
    expected = [*range(0, largest, (largest + 1) // 32), largest]
    assert (diagram.y_ticks * largest).tolist() == pytest.approx(expected)
    assert buffer.depth(diagram.x_ticks) == pytest.approx(diagram.y_ticks, abs=1e-12)
    curve = diagram.curves[0].points
    assert curve[:, 1] == pytest.approx(buffer.depth(curve[:, 0]))


def test_the_explanations_figures_are_the_readings() -> None:
    """Near decides, far hardly; only the control that decides is offered."""
    start = PHENOMENON.start
    ((near, far),) = re.findall(r"near (\S+), \d+ % with far (\d+)", PHENOMENON.words.explanation)
    nearer, farther = (start.lens.replaced(near=float(near)), start.lens.replaced(far=float(far)))
    seen = start, replace(start, lens=nearer), replace(start, lens=farther)
    # The same pixels all three times: neither plane takes any of the ramp away.
    counts = {len(distances(projection, 0.25, SUBJECT)[0]) for projection in seen}
    assert PHENOMENON.checked({})["gap"] == 0.25 and len(counts) == 1
    shares = [shown(projection).readings[0].value for projection in seen]
    percents = [float(share) for share in re.findall(r"(\d+) %", PHENOMENON.words.explanation)]
    assert percents == pytest.approx(shares, abs=0.5)
    assert "lens.near" in PHENOMENON.controls and "lens.far" not in PHENOMENON.controls
