"""Lens and focus: the standard formulas against rays through a thin lens, in 40 digits."""

import math
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from app.model.lenses import Frustum, Oblique, Orthographic, Perspective
from app.model.lenses.perspective import focal_length_35mm
from app.model.projection import Camera, Orbit, Projection
from app.scenes.phenomena.focus import PHENOMENON, blur_mm, sharpness
from app.scenes.phenomena.illustration import OwnMesh, Subject
from app.scenes.phenomena.marks import Aperture
from tests.oracles.illustrations import readings, showing

mp.mp.dps = 40

POINTS = PHENOMENON.geometry()[0][0].reshape(-1, 3)
SUBJECT = Subject(tuple(POINTS.min(axis=0)), tuple(POINTS.max(axis=0)), POINTS)
EYE = Camera((0.0, 0.0, 0.0), (0.0, 0.0, -5.0))


show = showing(PHENOMENON, SUBJECT)


class ThinLens:
    """Rays in a plane through the axis: at the lens the slope changes by -y/f. All in mm."""

    def __init__(self, f_mm: Any, f_number: Any, focus_m: Any) -> None:
        self.f, self.half = mp.mpf(f_mm), mp.mpf(f_mm) / mp.mpf(f_number) / 2
        # The film is where the rays from the axis at the focal distance meet.
        focus = 1000 * mp.mpf(focus_m)
        self.film = -self.half / (self.half / focus - self.half / self.f)

    def disc(self, distance_m: Any, height_mm: Any = 0) -> Any:
        """Diameter on the film of what comes from one point."""
        distance = 1000 * mp.mpf(distance_m)
        ends = []
        for y in (self.half, -self.half):
            slope = (y - height_mm) / distance - y / self.f
            ends.append(y + slope * self.film)
        return abs(ends[0] - ends[1])


def draw(rng: np.random.Generator) -> tuple[Projection, dict[str, float]]:
    fov = float(rng.uniform(3.0, 110.0))
    projection = Projection(EYE, Perspective(fov, 0.1, 100.0))
    return projection, {
        "focus": float(10 ** rng.uniform(-0.3, 2)),
        "aperture": float(2 ** rng.uniform(0, 6)),
        "confusion": float(10 ** rng.uniform(-2.5, -1)),
    }


def test_the_limits_are_where_traced_discs_are_as_large_as_the_circle_of_confusion() -> None:
    rng = np.random.default_rng(11)
    infinite = 0
    for _ in range(50):
        projection, settings = draw(rng)
        focus, c = settings["focus"], settings["confusion"]
        got = readings(show(projection, **settings))
        fov = mp.radians(mp.mpf(projection.lens.fov_y_deg))  # type: ignore[union-attr]
        diagonal = mp.tan(fov / 2) * mp.hypot(mp.mpf(1280) / 720, 1)  # of half the field of view
        f = mp.hypot(36, 24) / 2 / diagonal
        assert got["focal length f"] == pytest.approx(float(f), rel=1e-14)
        assert got["opening f / N"] == pytest.approx(float(f / settings["aperture"]), rel=1e-14)
        lens = ThinLens(f, settings["aperture"], focus)
        near, far = got["sharp from"], got["sharp to"]
        assert near < focus
        # Also of a point off the axis: the disc is the same.
        assert float(lens.disc(near)) == pytest.approx(c, rel=1e-10)
        assert float(lens.disc(near, 700)) == pytest.approx(c, rel=1e-10)
        assert lens.disc(0.99 * near) > c > lens.disc(near + 0.01 * (focus - near))
        if far is None:
            infinite += 1
            assert lens.disc(mp.mpf(10) ** 30) <= c
            assert got["depth of field"] is None
        else:
            assert float(lens.disc(far)) == pytest.approx(c, rel=1e-9)
            assert lens.disc(1.01 * far) > c > lens.disc(far - 0.01 * (far - focus))
            assert got["depth of field"] == pytest.approx(far - near, rel=1e-14)
        # Focused at the hyperfocal distance, what is infinitely far away is just sharp.
        hyperfocal = got["hyperfocal distance H"]
        at_h = ThinLens(f, settings["aperture"], hyperfocal)
        assert float(at_h.disc(mp.mpf(10) ** 30)) == pytest.approx(c, rel=1e-10)
        assert (far is None) == (focus >= hyperfocal)
        pixels = math.hypot(1280, 720) / math.hypot(36, 24)
        blur = float(lens.disc(5)) * pixels
        assert got["blur of the target"] == pytest.approx(blur, rel=1e-10, abs=1e-12)
        distances = np.array([0.3 * focus, 0.9 * focus, 2 * focus, 50 * focus])
        discs = [float(lens.disc(float(d))) for d in distances]
        own = blur_mm(got["focal length f"], settings["aperture"], focus, distances)
        np.testing.assert_allclose(own, discs, rtol=1e-12)
    assert 5 < infinite < 45


def test_l24_by_hand() -> None:
    """A 50-mm lens at f/2, focused at 10 m, c = 0.025 mm: H = 2500/0.05 + 50 mm = 50.05 m.

    Near: 10 x 50/(50 + 9.95) = 8.3403 m; far: 10 x 50/(50 - 9.95) = 12.4844 m.
    """
    window = math.hypot(36, 24) / 50 / math.hypot(1280, 720)
    right, top = 1280 * window / 2, 720 * window / 2
    projection = Projection(EYE, Frustum(-right, right, -top, top, 1.0, 100.0))
    got = readings(show(projection, focus=10.0, aperture=2.0, confusion=0.025))
    assert got["focal length f"] == pytest.approx(50.0, rel=1e-14)
    assert got["opening f / N"] == pytest.approx(25.0, rel=1e-14)
    assert got["hyperfocal distance H"] == pytest.approx(50.05, rel=1e-14)
    assert got["sharp from"] == pytest.approx(500 / 59.95, rel=1e-14)
    assert got["sharp to"] == pytest.approx(500 / 40.05, rel=1e-13)
    # Focused at H, sharp from H/2 on; also exactly there, where 1 - 1 is divided by.
    assert sharpness(50.0, 2.0, 50.05, 0.025).far == math.inf
    assert (50.05 - 0.05) / 50.0 == 1.0
    at_h = readings(show(projection, focus=50.06, aperture=2.0, confusion=0.025))
    assert at_h["sharp to"] is None
    assert at_h["sharp from"] == pytest.approx(25.03, rel=1e-3)


def test_a_target_in_focus_has_no_disc_from_whichever_side_it_is_seen() -> None:
    for elevation_deg in range(-60, 61, 5):
        camera = Camera.from_orbit((-1.6, 0.5, 1.8), Orbit(45.0, elevation_deg, 5.0))
        found = show(Projection(camera, Perspective(28.0, 1.7, 22.0)), focus=5.0)
        assert readings(found)["blur of the target"] == 0.0


@pytest.mark.parametrize("fov", [1e-4, 1e-2, 1.0, 28.0])
def test_what_is_sharp_is_as_deep_as_its_limits_are_apart_to_the_last_digits(fov: float) -> None:
    f_mm = float(mp.hypot(36, 24) / 2 / mp.tan(mp.radians(fov) / 2) / mp.hypot(1, mp.mpf(9) / 16))
    f_mm *= 9 / 16  # the angle is the vertical one
    focus = 1.5e-3 * f_mm
    found = readings(
        show(Projection(EYE, Perspective(fov)), focus=focus, aperture=0.5, confusion=1e-6)
    )
    f, s = mp.mpf(found["focal length f"]) / 1000, mp.mpf(focus)
    assert float(f) == pytest.approx(f_mm / 1000)
    q = (s - f) * mp.mpf(0.5) * mp.mpf(1e-6) / 1000 / f**2
    assert found["depth of field"] == pytest.approx(
        float(s / (1 - q) - s / (1 + q)), rel=1e-12, abs=0.0
    )


def test_in_a_stretched_picture_the_disc_has_a_width_and_a_height() -> None:
    """The film is sqrt(36^2 + 24^2) mm across its corners and shaped like the window, 16 : 9."""
    window = (-0.4, 0.4, -0.225, 0.225)
    stretched = Frustum(*window, 1.0, 30.0, "stretch")
    illustration = show(Projection(EYE, stretched, (600, 1800)), focus=3.0)
    f_mm = math.hypot(36, 24) / math.hypot(0.8, 0.45)
    disc_mm = float(ThinLens(f_mm, PHENOMENON.checked({})["aperture"], 3.0).disc(5.0))
    reading = illustration.readings[-1]
    film_mm = 0.8 * f_mm, 0.45 * f_mm
    assert reading.value == pytest.approx((disc_mm * 600 / film_mm[0], disc_mm * 1800 / film_mm[1]))
    assert reading.note is not None and "stretched" in reading.note.sentence()
    assert not isinstance(
        readings(show(Projection(EYE, stretched, (1600, 900))))[reading.label], tuple
    )
    far = show(Projection(Camera((0.0, 0.0, 5e-324), (0.0, 0.0, 0.0)), stretched, (600, 1800)))
    assert far.readings[-1].value is None


def test_the_planes_stand_where_the_limits_are() -> None:
    rng = np.random.default_rng(12)
    counted = 0
    for _ in range(50):
        camera = Camera(tuple(rng.uniform(-5, 5, 3)), tuple(rng.uniform(-5, 5, 3)))
        projection = Projection(camera, Perspective(40.0, 2.0, 20.0), (1280, 720))
        focus = float(rng.uniform(1, 25))
        illustration = show(projection, focus=focus)
        got = readings(illustration)
        expected = [
            d for d in (got["sharp from"], focus, got["sharp to"]) if d and 2.0 <= d <= 20.0
        ]
        assert len(illustration.world.faces) == len(illustration.world.texts) == len(expected)
        for face, distance in zip(illustration.world.faces, expected, strict=True):
            trace = projection.trace(face.points)
            np.testing.assert_allclose(-trace.view[:, 2], distance, rtol=1e-12)
            corners = [(0, 720), (1280, 720), (1280, 0), (0, 0)]
            np.testing.assert_allclose(trace.image, corners, atol=1e-9)
            counted += 1
        # Thick edges run from the near limit to the far one, inside the frustum.
        edges = [line for line in illustration.world.lines if len(line.points) == 2]
        for edge in edges:
            w = -projection.trace(edge.points).view[:, 2]
            bounds = max(2.0, got["sharp from"]), min(20.0, got["sharp to"] or 20.0)
            np.testing.assert_allclose(w, bounds, rtol=1e-12)
        (diagram,) = illustration.diagrams
        assert diagram.left < got["sharp from"] < focus < diagram.right
        curve = diagram.curves[1].points
        assert curve[:, 1].min() == 0.0
        assert curve[np.argmin(curve[:, 1]), 0] == focus
    assert counted > 50


def test_the_picture_outlines_the_posts_whose_numbers_are_in_the_range_and_no_others() -> None:
    """Their faces with the number stand 0.15 m before it, in the camera the scene opens with."""
    posts = 2, 3, 4, 5, 6, 8, 10, 12, 15, 20
    start = PHENOMENON.start
    outlined = {}
    for aperture in (1.0, 2.8, 22.0):
        illustration = show(start, aperture=aperture)
        got = readings(illustration)
        low, high = got["sharp from"], got["sharp to"] or math.inf
        # About, for the camera looks down a little.
        sharp = [d for d in posts if low < 0.99 * (d - 0.15) and 1.01 * (d - 0.15) < high]
        lines = [line for line in illustration.image.lines if line.colour == "v"]
        outlined[aperture] = sharp
        # Four sides each, but for those that leave the picture at the bottom.
        assert 3 * len(sharp) <= len(lines) <= 4 * len(sharp)
        assert [text.text for text in illustration.image.texts] == ["sharp"]
        flat = [np.ptp(line.points, axis=0) for line in lines]
        widths = sorted({round(x, 3) for x, y in flat if x > 10.0 * y})
        # As wide as a post's 0.3 m are at its distance.
        window = 2.0 * math.tan(math.radians(14.0)) * 1280 / 720
        expected = sorted(0.3 / (window * (post - 0.15)) * 1280 for post in sharp)
        for ours, theirs in ((widths, expected), (expected, widths)):
            assert all(any(abs(w - v) < 0.03 * v for v in theirs) for w in ours)
    assert outlined[1.0] == [5] and outlined[2.8] == [5, 6] and len(outlined[22.0]) > 5


def test_pictures_from_the_opening_s_rim_differ_by_the_traced_disc() -> None:
    """Right and left end of the opening, and its top and bottom, see a point a disc apart."""
    rng = np.random.default_rng(13)
    for _ in range(20):
        projection, settings = draw(rng)
        camera = Camera(tuple(rng.uniform(-5, 5, 3)), tuple(rng.uniform(-5, 5, 3)))
        start = Projection(camera, projection.lens)
        illustration = show(start, **settings)
        assert illustration.rendering is not None
        aperture = illustration.rendering.aperture
        assert aperture is not None
        lens = ThinLens(
            readings(illustration)["focal length f"], settings["aperture"], settings["focus"]
        )
        per_mm = math.hypot(*start.image_size) / math.hypot(36, 24)
        for away in (0.3, 1.0, 1.5, 20.0):
            distance = away * settings["focus"]
            view = np.array([0.1, -0.2, -1.0]) * distance
            place = np.array(camera.eye) + view @ camera.frame
            disc = float(lens.disc(distance)) * per_mm
            for axis, ends in ((0, ((1, 0), (-1, 0))), (1, ((0, 1), (0, -1)))):
                one, other = (aperture.seen_from(start, *end).trace(place).image for end in ends)
                assert abs(one - other)[axis] == pytest.approx(disc, rel=1e-6, abs=1e-6)
                assert abs(one - other)[1 - axis] == pytest.approx(0.0, abs=1e-6)


def test_a_shift_moves_the_picture_by_parts_of_a_pixel() -> None:
    start, place = PHENOMENON.start, (0.3, 1.0, -7.0)
    still, moved = (
        Aperture(0.0, 5.0).seen_from(start, 0.0, 0.0, shift).trace(place).image
        for shift in ((0.0, 0.0), (0.25, 0.5))
    )
    np.testing.assert_allclose(still, start.trace(place).image, atol=1e-9)
    np.testing.assert_allclose(moved - still, (0.25, -0.5), atol=1e-9)


def test_the_cube_shows_the_limits_where_depth_puts_them() -> None:
    """NDC z = (f + n)/(f - n) - 2 f n/((f - n) w), by the lecture's own formula."""
    illustration = show(PHENOMENON.start)
    got, lens = readings(illustration), PHENOMENON.start.lens
    n, f = lens.near, lens.far
    expected = [
        (f + n) / (f - n) - 2.0 * f * n / ((f - n) * w)
        for w in (got["sharp from"], 5.0, got["sharp to"])
    ]
    for face, z in zip(illustration.ndc.faces, expected, strict=True):
        np.testing.assert_allclose(face.points[:, 2], z, atol=1e-12)
        np.testing.assert_allclose(np.abs(face.points[:, :2]), 1.0, atol=1e-12)


def test_the_sharp_vertices_of_a_user_s_mesh_are_marked() -> None:
    points = np.array([(0.0, 1.0, -d) for d in (3.0, 4.9, 5.0, 5.1, 9.0)])
    nothing = np.empty((0, 2, 3)), 0, np.empty((0, 3, 3))
    subject = Subject((0.0, 1.0, -9.0), (0.0, 1.0, -3.0), points, OwnMesh(*nothing))
    illustration = PHENOMENON.illustration(PHENOMENON.start, PHENOMENON.checked({}), subject)
    places = np.array([dot.point for dot in illustration.image.dots])
    np.testing.assert_allclose(places, PHENOMENON.start.trace(points[1:4]).image)
    assert illustration.image.lines == () and illustration.image.faces == ()


def test_a_lens_that_cannot_be_focused_says_why() -> None:
    tele = Projection(EYE, Perspective(1.0, 0.5, 30.0))  # 1215 mm
    illustration = show(tele, focus=1.0)
    assert illustration.warning is not None
    f_m = focal_length_35mm(1.0, 16 / 9) / 1000
    assert illustration.warning.values == pytest.approx((1.0, f_m), rel=1e-5)
    assert readings(illustration)["sharp from"] is None
    assert readings(illustration)["focal length f"] is not None
    for lens in (Orthographic(), Oblique()):
        parallel = show(Projection(EYE, lens))
        assert parallel.warning is not None
        assert set(readings(parallel).values()) == {None}
        assert parallel.diagrams == () and parallel.world.faces == ()


def test_l24_each_plane_s_name_points_at_another_corner_of_it() -> None:
    """At the same corner the names would cover each other, and the planes behind."""
    start = PHENOMENON.start
    texts = show().world.texts
    assert [text.text for text in texts] == ["sharp from", "in focus", "sharp to"]
    view = start.trace([text.point for text in texts]).view
    limits = readings(show())
    depths = [limits["sharp from"], PHENOMENON.checked({})["focus"], limits["sharp to"]]
    assert -view[:, 2] == pytest.approx(depths, rel=1e-12)
    sides = {(x > 0.0, y > 0.0) for x, y in view[:, :2].tolist()}
    assert len(sides) == 3
