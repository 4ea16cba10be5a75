"""Calibrated cameras without the window: K, angles and focal lengths after ``--set``."""

import math
from itertools import permutations
from typing import Any

import numpy as np
import pytest

from app.document.document import Document
from app.document.settings import set_values
from app.model.camera import taken_apart
from app.model.projection import Camera, Frustum, Orthographic, Perspective, Projection
from app.model.refusal import Refusal
from tests.support.commands import run_here

IMAGE = ("image.width=1280", "image.height=720")
K = ("lens.fx=912.3", "lens.fy=905.1", "lens.cx=633.2", "lens.cy=371.9")
AXIS = Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0))
UPRIGHT = Projection(AXIS, Perspective(), image_size=(1080, 1920))


def set_to(*assignments: str) -> Projection:
    return set_values(Document(), assignments).projection


def refusal(*assignments: str) -> str:
    with pytest.raises(Refusal) as caught:
        set_to(*assignments)
    return str(caught.value)


def test_k_is_set_as_opencv_writes_it() -> None:
    """P[0, 0] = 2 fx/W, P[0, 2] = 1 - 2 (cx + 0.5)/W, P[1, 2] = 2 (cy + 0.5)/H - 1."""
    projection = set_to(*IMAGE, *K)
    p = projection.clip_from_view
    assert p[0, 0] == pytest.approx(1.42546875, rel=1e-14)
    assert p[1, 1] == pytest.approx(2 * 905.1 / 720, rel=1e-14)
    assert p[0, 2] == pytest.approx(1 - 2 * 633.7 / 1280, abs=1e-14)
    assert p[1, 2] == pytest.approx(2 * 372.4 / 720 - 1, abs=1e-14)
    assert (projection.lens.near, projection.lens.far) == (5.0, 12.5)
    # Nothing else changes, and near may be set at the same time.
    near = set_to(*IMAGE, *K, "lens.near=1", "camera.eye=1,2,3")
    assert near.intrinsics == pytest.approx(projection.intrinsics, rel=1e-13)
    assert (near.lens.near, near.camera.eye) == (1.0, (1.0, 2.0, 3.0))


def test_the_order_of_k_and_the_image_does_not_matter() -> None:
    small = ("image.width=640", "image.height=480", "lens.fx=500", "lens.cx=300")
    found = {set_to(*each).lens for each in permutations((*small, "lens.kind=frustum"))}
    assert len(found) == 1
    assert set_to(*small).intrinsics == pytest.approx((500, 500, 300, 239.5), rel=1e-14)
    assert set_to("scene=cube", *K).lens.kind == set_to(*K, "scene=cube").lens.kind == "frustum"


def test_what_is_not_set_stays() -> None:
    """One focal length is that of square pixels; the principal point stays where it is."""
    for path in ("lens.fx=900", "lens.fy=900"):
        lens = set_to(path).lens
        assert isinstance(lens, Perspective)
        assert lens.fov_y_deg == pytest.approx(math.degrees(2 * math.atan(360 / 900)), rel=1e-15)
    assert set_to("lens.kind=frustum", "lens.fx=900").lens.kind == "frustum"
    shifted = set_values(Document(), K)
    other = set_values(shifted, ["lens.fx=800"]).projection.intrinsics
    assert other == pytest.approx((800, 800, 633.2, 371.9), rel=1e-13)
    other = set_values(shifted, ["lens.cy=300"]).projection.intrinsics
    assert other == pytest.approx((912.3, 905.1, 633.2, 300), rel=1e-13)


def test_other_measures_of_a_lens() -> None:
    lens = set_to("lens.fov_x_deg=90").lens
    assert isinstance(lens, Perspective)
    assert lens.fov_y_deg == pytest.approx(math.degrees(2 * math.atan(9 / 16)), rel=1e-15)
    # The diagonal of 36 x 24 mm, of which an image of 4 : 3 has 3/5 in height.
    shape = ("image.width=800", "image.height=600")
    lens = set_to("lens.focal_length_mm=50", *shape).lens
    assert isinstance(lens, Perspective)
    half = 0.6 * math.hypot(36, 24) / 2
    assert lens.fov_y_deg == pytest.approx(math.degrees(2 * math.atan(half / 50)), rel=1e-14)
    # fx = f W / width of the sensor; without a height the pixels are square.
    k = set_to("lens.focal_mm=50", "lens.sensor_width_mm=36", *shape).intrinsics
    assert k == pytest.approx((50 * 800 / 36, 50 * 800 / 36, 399.5, 299.5), rel=1e-14)
    k = set_to("lens.sensor_height_mm=24", "lens.focal_mm=50", *shape, "lens.cx=390").intrinsics
    assert k == pytest.approx((1250, 1250, 390, 299.5), rel=1e-14)
    both = "lens.sensor_height_mm=24", "lens.sensor_width_mm=36", "lens.focal_mm=50"
    assert set_to(*both, *shape).intrinsics[:2] == pytest.approx((50 * 800 / 36, 1250), rel=1e-14)


@pytest.mark.parametrize(
    ("assignments", "sentence"),
    [
        ("lens.fx=900 lens.fov_y_deg=40",
         "lens.fx cannot be set together with lens.fov_y_deg: both decide what the lens sees."),
        ("lens.fov_x_deg=50 lens.cx=600",
         "lens.cx cannot be set together with lens.fov_x_deg: both decide what the lens sees."),
        ("lens.focal_mm=50 lens.fy=900 lens.sensor_width_mm=36",
         "lens.fy cannot be set together with lens.focal_mm: both decide what the lens sees."),
        ("lens.kind=frustum lens.top=3 lens.cy=300",
         "lens.cy cannot be set together with lens.top: both decide what the lens sees."),
        ("lens.kind=perspective lens.cx=600",
         "lens.kind cannot be set together with lens.cx: both decide what the lens sees."),
        ("lens.kind=oblique lens.fx=900",
         "lens.fx belongs to another lens: set lens.kind as well (perspective, frustum)."),
        ("lens.kind=frustum lens.fov_x_deg=50",
         "lens.fov_x_deg belongs to another lens: set lens.kind as well (perspective)."),
        ("lens.focal_mm=50",
         "lens.focal_mm = 50: needs lens.sensor_width_mm or lens.sensor_height_mm; the one that"
         " compares with 36 x 24 mm is lens.focal_length_mm."),
        ("lens.sensor_width_mm=36", "lens.focal_mm is missing."),
        ("lens.focal_mm=-5 lens.sensor_width_mm=36", "lens.focal_mm = -5: must be greater than 0."),
        ("lens.focal_mm=5 lens.sensor_width_mm=0",
         "lens.sensor_width_mm = 0: must be greater than 0."),
        ("lens.fov_x_deg=180", "lens.fov_x_deg = 180: must lie between 0 and 180, both excluded."),
        ("lens.fx=many", "lens.fx = 'many': must be a finite number."),
        ("lens.focl_mm=5", "lens.focl_mm is not known; the nearest name is lens.focal_mm."),
        ("lens.k=5", "lens.k is not known; the nearest name is lens.K."),
        ("camera.p=5", "camera.p is not known; the nearest name is camera.P."),
        ("lens.fy=-512 lens.cy=300",
         "lens.fy = -512: must be greater than 0; below 0 the image's y points up: take fy = 512"
         " and cy = H - 1 - cy."),
        ("lens.fx=-512",
         "lens.fx = -512: must be greater than 0; below 0 the image's x points left: take fx = 512"
         " and cx = W - 1 - cx."),
        ("lens.fx=0.71 lens.fy=1.26 lens.cx=0.49 lens.cy=0.52",
         "lens.fx = 0.71: must be in pixels, but the four numbers are in widths and heights of the"
         " image: multiply fx and cx by 1280, fy and cy by 720, then subtract 0.5 from cx and cy."),
    ],
)  # fmt: skip
def test_a_wrong_measure_is_refused(assignments: str, sentence: str) -> None:
    for given in (assignments.split(), assignments.split()[::-1]):
        assert refusal(*given) == sentence


def test_what_y_up_advises_is_right() -> None:
    """The same point at the same row, counted from the other end."""
    with pytest.raises(Refusal, match=r"take fy = 512 and cy = H - 1 - cy"):
        UPRIGHT.with_intrinsics((512, -512, 540, 960))
    _, row = UPRIGHT.with_intrinsics((512, 512, 540, 1919 - 960)).trace((0.3, 0.7, -2)).image - 0.5
    y_down = -0.7
    assert 1919 - row == pytest.approx(-512 * y_down / 2 + 960, abs=1e-10)


def test_k_may_be_a_matrix() -> None:
    k = np.array([[500.0, 0.0, 310.25], [0.0, 510.0, 250.5], [0.0, 0.0, 1.0]])
    plain = Projection(AXIS, image_size=(640, 480)).with_intrinsics((500, 510, 310.25, 250.5))
    assert isinstance(plain.lens, Frustum)
    for given in (k, k.tolist(), k.astype(np.float32), -2.0 * k):
        assert plain.with_intrinsics(given) == plain
    flat = Projection(AXIS, Orthographic(), image_size=(640, 480))
    assert flat.with_intrinsics(k).intrinsics == pytest.approx(plain.intrinsics, rel=1e-14)


NOT_K = "must be fx, fy, cx, cy, or K: three rows fx, 0, cx and 0, fy, cy and 0, 0, 1."


@pytest.mark.parametrize(
    ("k", "sentence"),
    [
        ([[500, 0, 0], [0, 510, 0], [310, 250, 1]],
         "K = ((500, 0, 0), (0, 510, 0), (310, 250, 1)): is a transposed K, with cx and cy in the"
         " last row: swap rows and columns."),
        ([[500, 0.25, 310], [0, 510, 250], [0, 0, 1]],
         "K[0, 1] = 0.25: is a skew of the pixels, which must be 0: the window of a lens is a"
         " rectangle."),
        ([[500, 0, 310], [3, 510, 250], [0, 0, 1]],
         f"K = ((500, 0, 310), (3, 510, 250), (0, 0, 1)): {NOT_K}"),
        ([[500, 0, 310], [0, 510, 250], [0, 0, 0]],
         f"K = ((500, 0, 310), (0, 510, 250), (0, 0, 0)): {NOT_K}"),
        ([[500, 0, 310], [0, math.nan, 250], [0, 0, 1]], "K[1, 1] = nan: must be a finite number."),
        ([500, 310, 250],
         f"intrinsics = (500, 310, 250): {NOT_K}"),
        ([[500], [310, 250]],
         f"intrinsics = ((500), (310, 250)): {NOT_K}"),
        ("wide",
         f"intrinsics = 'wide': {NOT_K}"),
    ],
)  # fmt: skip
def test_a_wrong_k_is_refused(k: Any, sentence: str) -> None:
    with pytest.raises(Refusal) as caught:
        UPRIGHT.with_intrinsics(k)
    assert str(caught.value) == sentence


# --------------------------------------------------------------------------- K and P as matrices


def test_k_is_set_as_a_matrix() -> None:
    plain = set_to(*IMAGE, *K)
    for text in ("912.3 0 633.2; 0 905.1 371.9; 0 0 1", "[[912.3,0,633.2],[0,905.1,371.9],[0,0,1]]",
                 "1824.6, 0, 1266.4, 0, 1810.2, 743.8, 0, 0, 2"):  # fmt: skip
        assert set_to(*IMAGE, f"lens.K={text}").intrinsics == pytest.approx(plain.intrinsics)
    transposed = refusal("lens.K=912 0 0; 0 905 0; 633 371 1")
    assert transposed.startswith("lens.K = [[912, 0, 0], [0, 905, 0], [633, 371, 1]]: is a transp")
    assert refusal("lens.K=1 0 0 1; 0 1 0 1; 0 0 1 1").endswith(": must be 9 numbers, but has 12.")
    for other in ("lens.fx=9", "lens.cy=9", "lens.fov_y_deg=9", "lens.focal_mm=9"):
        assert "cannot be set together with" in refusal("lens.K=9 0 1; 0 9 1; 0 0 1", other)


# OpenCV 5.0.0: P = K [R | t] of K = [[800, 0, 330], [0, 790, 250], [0, 0, 1]] and
# R = cv2.Rodrigues((0.3, -0.5, 0.2)), t = (0.4, -1.2, 6); then cv2.decomposeProjectionMatrix(P).
P = [[851.9643260578948, -131.31738702461146, -76.23995664837093, 2300.0],
     [215.28227786046023, 798.4859165261944, -51.70862547520438, 552.0],
     [0.497991537002922, 0.23292116428443663, 0.8353156052067086, 6.0]]  # fmt: skip
P_R = [[0.8595338985586632, -0.2602267140480945, -0.43986763295823095],
       [0.11491695393636675, 0.9370324372849179, -0.32979433769225514],
       [0.4979915370029221, 0.23292116428443665, 0.8353156052067087]]  # fmt: skip
P_EYE = (-3.193862436717357, -0.16899737534548032, -5.231699783287665)
SIZE = ("image.width=640", "image.height=480")


def p_text(scale: float = 1.0, digits: int = 17) -> str:
    rows = ["  ".join(f"{scale * cell:.{digits}g}" for cell in row) for row in P]
    return f"camera.P={'; '.join(rows)}"


@pytest.mark.parametrize("scale", [1.0, -2.5, 1e-30, 1e30])
def test_p_is_taken_apart_as_opencv_does(scale: float) -> None:
    """At every scale and sign it is one camera: x_pixel = P x_world, divided."""
    projection = set_to(*SIZE, p_text(scale))
    assert projection.intrinsics == pytest.approx((800, 790, 330, 250), rel=1e-13)
    assert projection.camera.eye == pytest.approx(P_EYE, rel=1e-13)
    axes = np.array(P_R) * np.array([[1.0], [-1.0], [-1.0]])
    np.testing.assert_allclose(projection.camera.frame, axes, atol=1e-14)
    for x in ((0.0, 0.0, 0.0), (1.0, -2.0, 3.0)):
        u, v, w = np.array(P) @ (*x, 1.0)
        np.testing.assert_allclose(projection.trace(x).image - 0.5, (u / w, v / w), atol=1e-10)
    found = taken_apart(np.array(P) * scale)
    assert found.scale == pytest.approx(scale, rel=1e-14)
    again = found.scale * found.k @ np.column_stack([found.rotation, found.translation])
    np.testing.assert_allclose(again, np.array(P) * scale, rtol=1e-12, atol=1e-12 * abs(scale))
    assert np.linalg.det(found.rotation) == pytest.approx(1.0, rel=1e-14)


def test_what_p_does_not_say_may_be_set() -> None:
    planes = set_to(p_text(), "lens.near=2", *SIZE, "lens.far=50")
    assert (planes.lens.near, planes.lens.far) == (2.0, 50.0)
    wide = set_to(p_text(), "image.height=480", "image.width=3000")
    assert wide.intrinsics == pytest.approx((800, 790, 330, 250), rel=1e-13)
    # With six digits K has a skew, which does not move the picture by a pixel.
    rounded = set_to(*SIZE, p_text(digits=6)).intrinsics
    assert rounded == pytest.approx((800, 790, 330, 250), abs=2e-3)


@pytest.mark.parametrize(
    ("assignments", "sentence"),
    [
        ([p_text()],
         "]: is in pixels of an image whose size is not known, and which is not 1280 x 720: set"
         " image.width and image.height, or add image_width and image_height to the file."),
        (["camera.P=1 0 0 0; 0 1 0 0; 0 0 0 1"],
         "P = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]]: must have a left 3 x 3 block with an"
         " inverse: the camera is at infinity, as a parallel one is."),
        (["camera.P=0 0 0 0; 0 0 0 0; 0 0 0 0"], "the camera is at infinity"),
        (["camera.P=800 30 320 0; 0 800 240 0; 0 0 1 5", *SIZE], "K[0, 1] = 30: is a skew of the"),
        (["camera.P=1 2 3"], "must be 12 numbers, but has 3."),
        (["camera.P=1 0 0; 0 1 0; 0 0 1"], ": must be 12 numbers, but has 9."),
        ([p_text(), *SIZE, "camera.up=0,1,0"],
         "camera.up cannot be set together with camera.P: both decide what the lens sees."),
        ([p_text(), *SIZE, "lens.cx=3"], "lens.cx cannot be set together with camera.P: both"),
        ([p_text(), *SIZE, "lens.kind=frustum"], "lens.kind cannot be set together with camera.P"),
    ],
)  # fmt: skip
def test_a_wrong_p_is_refused(assignments: list[str], sentence: str) -> None:
    for given in (assignments, assignments[::-1]):
        assert sentence in refusal(*given)


def test_the_command_matrices_says_what_p_is_and_does_not_say() -> None:
    size = [word for each in SIZE for word in ("--set", each)]
    done = run_here("matrices", "--set", p_text(-2.0, 6), *size)
    *_, said = done.stdout.split("\nP = scale K [R | t]\n")
    assert "  (P has w > 0 behind the camera: perhaps y points up in its image)\n" in said
    assert "is free, and so is its sign)\n" in said
    assert " of K is left out: so many px at 45 degrees above or below)\n" in said
    assert "  (P does not say near, far and the size of the image)\n" in said
    exact = run_here("matrices", "--set", p_text(), *size).stdout
    assert "skew" not in exact and "behind" not in exact
    assert "P = scale" not in run_here("matrices").stdout
