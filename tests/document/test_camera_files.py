"""Camera files of other programs: their conventions, by their own examples, and hostile ones."""

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app import api
from app.document.codec import picture_json
from app.document.document import Document
from app.document.files import LARGEST_CAMERAS, holds_document, read
from app.model.projection import Orthographic, Perspective, Projection
from app.model.refusal import Refusal

# OpenCV's samples/data/left_intrinsics.yml, with two of its 13 views.
LEFT = """%YAML:1.0
---
nframes: 13
image_width: 640
image_height: 480
square_size: 2.5000000372529030e-02
flags: 2
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 5.3591573396163199e+02, 0., 3.4228315473308373e+02, 0.,
       5.3591573396163199e+02, 2.3557082909788173e+02, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -2.6637260909660682e-01, -3.8588898922304653e-02,
       1.7831947042852964e-03, -2.8122100441115472e-04,
       2.3839153080878486e-01 ]
avg_reprojection_error: 3.9259098975581364e-01
extrinsic_parameters: !!opencv-matrix
   rows: 2
   cols: 6
   dt: d
   data: [ 1.6866673097722978e-01, 2.7567195383689680e-01,
       1.3463666677617407e-02, -7.5217911266918208e-02,
       -1.0895943925991841e-01, 3.9970206949907272e-01,
       4.1331287656496363e-01, 6.4989015618432178e-01,
       -1.3371537960145106e+00, -5.8571677080547203e-02,
       8.2925805670236566e-02, 3.5381014833230601e-01 ]
"""
DISTORTION = LEFT[LEFT.index("distortion") : LEFT.index("avg_")]
STRAIGHT = LEFT.replace(DISTORTION, "")
K = [[535.91573396163199, 0, 342.28315473308373], [0, 535.91573396163199, 235.57082909788173],
     [0, 0, 1]]  # fmt: skip
CELLS = [cell for row in K for cell in row]
RVEC = (0.41331287656496363, 0.64989015618432178, -1.3371537960145106)
TVEC = (-0.058571677080547203, 0.082925805670236566, 0.35381014833230601)
# cv2.Rodrigues and cv2.projectPoints of OpenCV 5.0.0, without distortion.
R = [[0.09744500169718176, 0.975885384557258, 0.19532585044424863],
     [-0.7565220818995463, 0.2001530144152088, -0.6225858257452394],
     [-0.6466674657369215, -0.08710044218049617, 0.7577827536499822]]  # fmt: skip
BOARD = [(0, 0, 0), (0.2, 0, 0), (0, 0.125, 0), (0.2, 0.125, -0.05)]
SEEN = (
    [(241.4318827489518, 89.47932165032645), (523.9921803701798, 77.92807961180367),
     (248.01734888225457, 253.74694132335645), (518.284004610145, 285.45058613788314)],
    [(253.56471785403897, 361.1784302919106), (248.97714314072766, 72.32368290549473),
     (441.38586447499654, 404.26600662199996), (565.3629425854494, 198.2665942447303)],
)  # fmt: skip

# COLMAP's documentation, "Output Format".
CAMERAS = """# Camera list with one line of data per camera:
#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]
# Number of cameras: 3
1 SIMPLE_PINHOLE 3072 2304 2559.81 1536 1152
2 PINHOLE 3072 2304 2560.56 2560.56 1536 1152
3 SIMPLE_RADIAL 3072 2304 2559.69 1536 1152 -0.0218531
"""
IMAGES = """# Image list with two lines of data per image:
#   IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME
#   POINTS2D[] as (X, Y, POINT3D_ID)
# Number of images: 2, mean observations per image: 2
1 0.851773 0.0165051 0.503764 -0.142941 -0.737434 1.02973 3.74354 1 P1180141.JPG
2362.39 248.498 58396 1784.7 268.254 59027 1784.7 268.254 -1
2 0.851773 0.0165051 0.503764 -0.142941 -0.737434 1.02973 3.74354 3 sub dir/P1180142.JPG

"""
EYE_BACK = [[1, 0, 0, 0.8], [0, 1, 0, 1.0], [0, 0, 1, 1.2], [0, 0, 0, 1]]
NERF = {
    "camera_angle_x": 0.6911112,
    "frames": [{"file_path": "./r_0", "transform_matrix": EYE_BACK}],
}


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Files are named without their folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def seen(name: str, content: str | dict[str, Any] | None = None, **options: Any) -> Projection:
    """The projection of a file, which is written first if there is a content for it."""
    if content is not None:
        text = content if isinstance(content, str) else json.dumps(content)
        Path(name.rpartition("#")[0] or name).write_text(text, encoding="utf-8")
    return read(name, **options).projection


def refusal(name: str, content: str | dict[str, Any] | None = None) -> str:
    with pytest.raises(Refusal) as caught:
        seen(name, content)
    return str(caught.value)


def nerf(frame: dict[str, Any] | None = None, **values: Any) -> dict[str, Any]:
    frames = [{**NERF["frames"][0], **(frame or {})}]  # type: ignore[index]
    return {**NERF, "frames": frames, **values}


# --------------------------------------------------------------------------- NeRF


def test_a_nerf_camera_is_opengls() -> None:
    """The eye is the last column; the camera looks along -z; the angle is that of the width."""
    projection = seen("transforms.json", NERF)
    assert projection.camera.eye == (0.8, 1.0, 1.2)
    np.testing.assert_allclose(projection.camera.frame, np.eye(3), atol=1e-15)
    angles = projection.lens.angles(Fraction(*projection.image_size))
    assert angles is not None and angles.fov_x_deg == pytest.approx(39.597798, abs=1e-4)
    assert projection.image_size == Document().projection.image_size
    small = api.load("transforms.json", "image.height=800", "image.width=800").projection
    assert isinstance(small.lens, Perspective)
    assert small.lens.fov_y_deg == pytest.approx(math.degrees(0.6911112), rel=1e-14)


def test_near_and_far_follow_the_distance_of_the_target() -> None:
    start, found = Document().projection, seen("transforms.json", NERF)
    ratio = math.dist((0.8, 1.0, 1.2), start.camera.target) / start.camera.distance
    assert found.camera.distance == pytest.approx(start.camera.distance * ratio, rel=1e-14)
    assert found.lens.near == pytest.approx(start.lens.near * ratio, rel=5e-3)
    assert found.lens.far == pytest.approx(start.lens.far * ratio, rel=5e-3)
    flat = Document(projection=Projection(lens=Orthographic(near=-3, far=9)))
    assert seen("transforms.json", over=flat).lens.near > 0.0


def test_a_nerf_camera_has_its_own_numbers_before_those_of_the_file() -> None:
    """As nerfstudio's data conventions and instant-ngp write them; cx = w/2 is the middle."""
    common = {"w": 3008, "h": 2000.0, "fl_x": 1072.0, "fl_y": 1068.0, "cx": 1504.0, "cy": 1000.0,
              "k1": 0.0, "p2": 0, "camera_model": "OPENCV"}  # fmt: skip
    k = seen("a.json", nerf(**common)).intrinsics
    assert k == pytest.approx((1072, 1068, 1503.5, 999.5), rel=1e-14)
    own = seen("b.json", nerf({"fl_x": 900.0, "cx": 1500, "w": 3000}, **common))
    assert own.intrinsics == pytest.approx((900, 1068, 1499.5, 999.5), rel=1e-14)
    assert own.image_size == (3000, 2000)
    # One focal length stands for both; degrees come before it.
    assert seen("c.json", nerf(fl_x=500, w=640, h=480)).intrinsics[:2] == pytest.approx((500, 500))
    wide = {"frames": NERF["frames"], "x_fov": 90.0, "y_fov": 60.0, "w": 640, "h": 480}
    k = seen("d.json", wide).intrinsics
    assert k[:2] == pytest.approx((320, 240 * math.sqrt(3)), rel=1e-14)


NO_SIZE = (
    "is in pixels of an image whose size is not known, and which is not 1280 x 720: set image.width"
    " and image.height, or add image_width and image_height to the file."
)
DISTORTED = (
    "is a lens with distortion, and here straight lines stay straight: undistort the pictures, and"
    " use the camera of the new ones."
)
TURNED = "must be a rotation: equally long axes at right angles, not mirrored."


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (nerf(k1=-0.2), f"k1 = '-0.2': {DISTORTED}"),
        (nerf({"p1": 1e-3}), f"p1 = '0.001': {DISTORTED}"),
        (nerf(camera_model="OPENCV_FISHEYE"),
         "camera_model = 'OPENCV_FISHEYE': is no perspective camera, and is not read."),
        (nerf(is_fisheye=True), "is_fisheye = 'True': is no perspective camera, and is not read."),
        ({"frames": NERF["frames"]}, "fl_x is missing."),
        (nerf(fl_x=500, cx=300), f"cx, cy = [299.5, 359.5]: {NO_SIZE}"),
        (nerf(fl_x=-500, w=640, h=480),
         "fx = -500: must be greater than 0; below 0 the image's x points left: take fx = 500 and"
         " cx = W - 1 - cx."),
        (nerf({"transform_matrix": 3}),
         "transform_matrix = '3': must be 16 finite numbers."),
        (nerf({"transform_matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}),
         "transform_matrix = '1 0 0 0 1 0 0 0 1': must be 16 finite numbers."),
        (nerf({"transform_matrix": [[1, 0, 0, "x"], *EYE_BACK[1:]]}),
         "transform_matrix = '1 0 0 x 0 1 0 1.0 0 0 1 1.2 0 0 0 1': must be 16 finite numbers."),
        (nerf({"transform_matrix": [[1, 0.2, 0, 3], *EYE_BACK[1:]]}),
         f"transform_matrix = '1 0.2 0 3 0 1 0 1.0 0 0 1 1.2 0 0 0 1': {TURNED}"),
        (nerf({"transform_matrix": [[0, 0, 0, 3], *EYE_BACK[1:]]}), TURNED),
        (nerf({"transform_matrix": [[2, 0, 0, 3], *EYE_BACK[1:]]}), TURNED),
        (nerf({"transform_matrix": [[-1, 0, 0, 3], *EYE_BACK[1:]]}), TURNED),
        (nerf(w=0.5, h=480), "must be a whole number of pixels from 1 to 16384."),
        (nerf(camera_angle_x=0), "camera_angle_x = 0: must lie between 0 and 3.14159"),
        (nerf(camera_angle_x=3.2), "camera_angle_x = 3.2: must lie between 0 and 3.14159"),
        (nerf(camera_angle_x=5e-324), "camera_angle_x = 0: must be greater than 0."),
        (nerf(x_fov=180), "x_fov = 180: must lie between 0 and 180, both excluded."),
        (nerf(fl_x="wide"), "fl_x = 'wide': must be a finite number."),
        ({"frames": []}, "transforms.json has no camera: no camera_matrix, K or fx, and no frame."),
        ({"frames": [3], "fl_x": 900},
         "transform_matrix is missing."),
        ({"sfm_data_version": "0.3", "views": []},
         "transforms.json is a file of OpenMVG, which is not read: export its cameras as COLMAP"
         " text, transforms.json or OpenCV's K, R, t."),
        ({"version": ["1"], "featuresFolders": []}, "transforms.json is a file of Meshroom,"),
        ({"camera": 1}, "transforms.json is not a Frustum Lab document."),
        ('{"frames": [{"transform_matrix": [[NaN]]}]}',
         "frames[0].transform_matrix[0][0] = NaN: must be a finite number."),
        ('{"frames": [' + "[" * 60 + "]" * 60 + "]}", "has more than 50 levels of brackets."),
        ('{"frames": [' + "[" * 100_000, "has more than 50 levels of brackets."),
        ('{"frames": [1, 2', "is broken or cut short"),
        ('{"frames": [' + "0," * 1_000_000 + "0]}", "has more than 1000000 values."),
        ('{"class_name": "PinholeCameraParameters"}', "is a file of Open3D, which is not read"),
        ('[{"img_name": "a", "fx": 3}]', "is a file of Gaussian Splatting, which is not read"),
    ],
)  # fmt: skip
def test_what_is_no_perspective_camera_is_refused(content: Any, sentence: str) -> None:
    assert sentence in refusal("transforms.json", content)


def test_a_turned_camera_with_few_digits_is_read() -> None:
    """A scaled one as well: the cameras of Blender may have a scale."""
    rows = [[0.832, -0.139, 0.537, 6], [0, 0.968, 0.251, 5], [-0.555, -0.209, 0.806, 9]]
    frame = seen("a.json", nerf({"transform_matrix": rows})).camera.frame
    doubled = [[2 * part for part in row[:3]] + row[3:] for row in rows]
    np.testing.assert_allclose(
        seen("b.json", nerf({"transform_matrix": doubled})).camera.frame, frame, atol=1e-15
    )
    np.testing.assert_allclose(frame, np.array(rows)[:, :3].T, atol=1e-3)


def test_a_pose_with_rows_and_columns_exchanged_is_refused() -> None:
    turned = np.transpose(EYE_BACK).tolist()
    wanted = " = [0.8, 1, 1.2, 1]: must be 0, 0, 0, 1, the last row of a pose"
    assert f"a.json: transform_matrix{wanted}" in refusal(
        "a.json", nerf({"transform_matrix": turned})
    )
    k = [[500, 0, 320], [0, 500, 240], [0, 0, 1]]
    assert f"b.json: extrinsic{wanted}" in refusal("b.json", {"K": k, "extrinsic": turned})


# --------------------------------------------------------------------------- one view of several


def test_a_view_is_chosen_by_name_or_number() -> None:
    frames = [{"file_path": f"./train/r_{i}", "transform_matrix": EYE_BACK, "fl_x": 900 + i}
              for i in (0, 1, 2)]  # fmt: skip
    Path("t.json").write_text(json.dumps({"frames": frames}), encoding="utf-8")
    for view in ("3", "r_2", "./train/r_2"):
        assert seen(f"t.json#{view}").intrinsics.fx == pytest.approx(902, rel=1e-14)
    names = "./train/r_0, ./train/r_1, ./train/r_2"
    assert refusal("t.json") == (
        f"t.json must be followed by # and the number, up to 3, or the name of a view: {names}."
    )
    for view in ("4", "0", "r", "r_2.png", "\u0663"):
        assert refusal(f"t.json#{view}") == (
            f"t.json must be followed by # and the number, up to 3, or the name of a view: {names}."
        )
    asked = list[list[str]]()
    found = seen("t.json", choose=lambda names: asked.append(names) or names[1])  # type: ignore[func-returns-value]
    assert asked == [names.split(", ")] and found.intrinsics.fx == pytest.approx(901)
    # A name may be missing, occur twice or have control characters; a file may have a #.
    frames = [{"transform_matrix": EYE_BACK}, *[{**frames[0], "file_path": "a\x1b"}] * 2]
    Path("a#b.json").write_text(json.dumps({"frames": frames}), encoding="utf-8")
    assert "(1), a\\x1b, a\\x1b (3)." in refusal("a#b.json")
    assert seen("a#b.json#2").intrinsics.fx == pytest.approx(900)
    whole = {"frames": [{**frames[0], "fl_x": 950}]}
    Path("a#b.json#2").write_text(json.dumps(whole), encoding="utf-8")
    assert seen("a#b.json#2").intrinsics.fx == pytest.approx(950), "a file of the whole name"
    many = {"frames": [{"file_path": f"{i:03}"} for i in range(500)]}
    assert refusal("many.json", many).endswith("008, 009, 010, 011, ....")


def test_a_document_has_no_views() -> None:
    Path("own.json").write_text(picture_json(Document()), encoding="utf-8")
    assert refusal("own.json#2") == "own.json is a document, and has no view #2."
    assert refusal("none.json#2") == "none.json#2 does not exist."


def test_saving_never_writes_over_a_camera_file() -> None:
    seen("t.json", NERF)
    assert not holds_document("t.json") and not holds_document("t.json#1")
    Path("own.json").write_text(picture_json(Document()), encoding="utf-8")
    assert holds_document("own.json")


# --------------------------------------------------------------------------- OpenCV


def opencv_views() -> dict[str, str]:
    """The second view of `STRAIGHT`, as several writers write it."""
    rows = ", ".join(repr(float(part)) for row in K for part in row)
    matrix = {"type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d", "data": CELLS}
    pose = f"rvec: [{', '.join(map(repr, RVEC))}]\ntvec: [{', '.join(map(repr, TVEC))}]\n"
    size = "image_width: 640\nimage_height: 480\n"
    plain = {"mtx": K, "dist": [[0, 0, 0, 0, 0]], "R": R, "t": [[x] for x in TVEC]}
    xml = "".join(
        f'<{name} type_id="opencv-matrix"><rows>3</rows><cols>1</cols><dt>d</dt>\n<data>'
        f"\n   {' '.join(map(repr, values))}</data></{name}>\n"
        for name, values in (("cameraMatrix", CELLS), ("Rvec", RVEC), ("Tvec", TVEC))
    )
    blocks = "\n".join(f"- - {a!r}\n  - {b!r}\n  - {c!r}" for a, b, c in K)
    return {
        "flow.yaml": f"K: [{rows}]  # pixels\n{size}{pose}",
        "blocks.yml": f"# numpy\ncamera_matrix:\n{blocks}\nimage_size: [640, 480]\n{pose}",
        "opencv.json": json.dumps({"camera_matrix": matrix, "width": 640, "height": 480,
                                   "rvecs": [RVEC], "tvecs": [TVEC], "flags": 2}),
        "plain.json": json.dumps(plain | {"image_size": [640, 480]}),
        "rt.json": json.dumps({"K": K, "w": 640, "h": 480, "extrinsics":
                               [[*row, t] for row, t in zip(R, TVEC, strict=True)]}),
        "a.xml": '<?xml version="1.0"?>\n<opencv_storage>\n<calibration_Time>"Fri"'
                 "</calibration_Time>"
                 f"\n<image_Width>640</image_Width><image_Height>480</image_Height>{xml}"
                 "</opencv_storage>\n",
        "nested.yml": "".join(f"  {line}\n" for line in f"k: [{rows}]\n{size}{pose}".splitlines())
                      .join(["%YAML 1.2\n---\nleft:\n", "other: 3\n"]),
        "kalibr.yaml": "cam0:\n  camera_model: pinhole\n  distortion_coeffs: [0.0, 0.0, 0, 0]\n"
                       "  distortion_model: radtan\n  intrinsics: [535.91573396163199,"
                       " 535.91573396163199, 342.28315473308373, 235.57082909788173]\n"
                       "  is_fisheye: false\n  resolution: [640, 480]\n"
                       f"  rvec: {list(RVEC)}\n  tvec: {list(TVEC)}\n",
        "orb.yaml": "%YAML:1.0\nCamera.type: PinHole\nCamera.fx: 535.91573396163199\n"
                    "Camera.fy: 535.91573396163199\nCamera.cx: 342.28315473308373\n"
                    "Camera.cy: 235.57082909788173\nCamera.k1: 0.0\nCamera.width: 640\n"
                    f"Camera.height: 480\n{pose}",
    }  # fmt: skip


@pytest.mark.parametrize("number", [1, 2])
def test_the_sample_of_opencv_is_seen_as_opencv_projects_it(number: int) -> None:
    """The first pixel's centre is (0, 0) there and (0.5, 0.5) here."""
    assert DISTORTED in refusal(f"left.yml#{number}", LEFT)
    projection = seen(f"left.yml#{number}", STRAIGHT)
    assert projection.image_size == (640, 480)
    image = projection.trace(BOARD).image - 0.5
    np.testing.assert_allclose(image, SEEN[number - 1], atol=1e-9)


@pytest.mark.parametrize("name", opencv_views())
def test_every_way_to_write_k_r_and_t_is_the_same_camera(name: str) -> None:
    projection = seen(name, opencv_views()[name])
    assert projection.image_size == (640, 480)
    np.testing.assert_allclose(projection.trace(BOARD).image - 0.5, SEEN[1], atol=1e-9)


def test_a_calibration_without_a_pose_keeps_the_camera() -> None:
    """A camera_info of ROS has a rectification and a projection, too; a stereo pair two cameras."""
    ros = ("image_width: 640\nimage_height: 480\ncamera_name: narrow_stereo\ncamera_matrix:\n"
           "  rows: 3\n  cols: 3\n  data: [438.783367, 0.0, 305.593336, 0, 437.302876, 243.738352,"
           " 0, 0, 1]\ndistortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n"
           "  cols: 5\n  data: [0, 0, 0, 0, 0]\nrectification_matrix:\n  rows: 3\n  cols: 3\n"
           "  data: [0.9, 0, 0, 0, 1, 0, 0, 0, 1]\n")  # fmt: skip
    projection = seen("ros.yaml", ros)
    assert projection.camera == Document().projection.camera
    for model in ('"plumb_bob"', "'plumb_bob'", "radial-tangential"):  # as rostopic echo and EuRoC
        assert seen("ros.yaml", ros.replace("plumb_bob", model)) == projection
    k = (438.783367, 437.302876, 305.593336, 243.738352)
    assert projection.intrinsics == pytest.approx(k, rel=1e-13)
    assert projection.lens.near == Document().projection.lens.near
    both = "".join(f"{name}: [500, 0, {cx}, 0, 500, 240, 0, 0, 1]\n{dist}: [0, 0, 0, 0, 0]\n"
                   for name, cx, dist in (("M1", 320, "D1"), ("M2", 330, "D2")))  # fmt: skip
    size = "width: 640\nheight: 480\n"
    assert seen("stereo.yml#2", both + size).intrinsics.cx == pytest.approx(330, rel=1e-14)
    # Without a size it is that of the present image, if the principal point is in its middle.
    assert refusal("stereo.yml#1", both).endswith(f"cx, cy = [320, 240]: {NO_SIZE}")
    given = api.load("stereo.yml#1", "image.width=640", "image.height=480").projection
    assert given.intrinsics == pytest.approx((500, 500, 320, 240), rel=1e-14)
    with pytest.raises(Refusal, match="or add image_width and image_height to the file"):
        api.load("stereo.yml#2", "image.width=3000", "image.height=300")
    off = seen("stereo.yml#2", f"{both}image_width: 3000\nimage_height: 300\n")
    assert off.intrinsics == pytest.approx((500, 500, 330, 240), rel=1e-13)


def test_a_file_may_have_p_alone() -> None:
    """P = K [I | t] for t = (0, 0, 5), so that the eye is at z = -5."""
    text = "P: [500, 0, 320, 1600, 0, 500, 240, 1200, 0, 0, 1, 5]\n"
    Path("p.yml").write_text(text, encoding="utf-8")
    found = api.load("p.yml", "image.width=640", "image.height=480").projection
    assert found.intrinsics == pytest.approx((500, 500, 320, 240), rel=1e-13)
    assert found.camera.eye == pytest.approx((0, 0, -5), abs=1e-13)
    for size in ("image_width: 640\nimage_height: 480\n", "image_size: [640, 480]\n"):
        Path("p.yml").write_text(size + text, encoding="utf-8")
        assert api.load("p.yml").projection == found


@pytest.mark.filterwarnings("error")
def test_a_pose_that_is_too_large_is_no_rotation_and_no_warning() -> None:
    text = "K: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nt: [0, 0, 5]\n"
    huge = f"{text}R: [1e308, 0, 0, 0, 1e308, 0, 0, 0, 1e308]\n"
    assert "must be a rotation" in refusal("huge.yml", huge)
    long = f"{text}rvec: [1.5e308, 1.5e308, 1.5e308]\n"  # its length is no float64
    assert "rvec = 1.5e+308: must be at most 1e+100." in refusal("long.yml", long)
    rows = [[1e200, 0, 0, 0], [0, 1e200, 0, 0], [0, 0, 1e200, 3]]
    assert "must be a rotation" in refusal("transforms.json", nerf({"transform_matrix": rows}))


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (f"K: [500, 0, 320, 0, 500, 240, 0, 0, 1]\n{DISTORTION}",
         "left.yml: distortion_coefficients = '-2.6637260909660682e-01 -3.8588898922304653e-02 "),
        ("fx: 5\nfy: 5\ncx: 3\ncy: 3\nk2: 0.1\n", f"left.yml: k2 = '0.1': {DISTORTED}"),
        ("K: [500, 0, 320, 0, 500, 240, 0, 0]\n",
         "left.yml: K = '500 0 320 0 500 240 0 0': must be 9 finite numbers."),
        ("K: [500, 0, .Nan, 0, 500, 240, 0, 0, 1]\n", "0 1': must be 9 finite numbers."),
        ("K: [1e999, 0, 2, 0, 500, 240, 0, 0, 1]\n", "0 1': must be 9 finite numbers."),
        ("K: [500, 2, 320, 0, 500, 240, 0, 0, 1]\n", "left.yml: K[0, 1] = 2: is a skew"),
        ("K: [500, 0, 0, 0, 500, 0, 320, 240, 1]\n", "is a transposed K"),
        ("K: [500, 0, 320, 0, -500, 240, 0, 0, 1]\nw: 640\nh: 480\n",
         "left.yml: fy = -500: must be greater than 0; below 0 the image's y points up"),
        ("K: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nw: 640\nh: 480\ntvec: [1, 2, 3]\n",
         "left.yml: t = [1, 2, 3]: must have three numbers for each rotation, which has three or"),
        ("K: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nw: 640\nh: 480\nt: [1, 2, 3]\n"
         "R: [1, 0, 0, 0, 1, 0, 0, 0, -1]\n",
         "left.yml: R = '1 0 0 0 1 0 0 0 -1': must be a rotation: axes of length 1 at right angles,"
         " not mirrored."),
        ("K: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nw: 640\nh: 480\nt: [0, 0, 5]\n"
         "R: [1.1, 0, 0, 0, 1.1, 0, 0, 0, 1.1]\n", "left.yml: R = '1.1 0 0 0 1.1 0 0 0 1.1': must"),
        ("K: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nw: 640\nh: 480\n"
         "extrinsics: [0.9, 0, 0, 0, 0, 0.9, 0, 0, 0, 0, 0.9, 5]\n", "axes of length 1 at right"),
        ("camera_matrix: !!python/object/apply:os.system ['echo 1 2 3 4']\n",
         "left.yml: camera_matrix = \"!!python/object/apply:os.system 'echo 1 2 3 4'\": must be"),
        ("fx: 5\nfy: 5\ncx: 3\ncy: 3\ndist_coeff: [0, 0.1]\n", "left.yml: dist_coeff = '0 0.1': "),
        ("fx: 5\nfy: 5\ncx: 3\ncy: 3\ndistortion_model: equidistant\n",
         "left.yml: distortion_model = 'equidistant': is no perspective camera, and is not read."),
        ("flags: 3\n", "left.yml has no camera: no camera_matrix, K or fx, and no frame."),
        ("", "left.yml has no camera: "),
        ("\n".join(f"{' ' * i}a:" for i in range(60)), "has more than 20 levels of brackets."),
        ("<opencv_storage><K>1 2", "left.yml is not XML as OpenCV writes it: "),
        ('<!DOCTYPE x [<!ENTITY a "b">]><opencv_storage/>',
         "left.yml is not XML as OpenCV writes it: <!DOCTYPE."),
        ("<document><chunk/></document>",
         "left.yml is not XML as OpenCV writes it: <document>."),
    ],
)  # fmt: skip
def test_a_calibration_that_cannot_be_seen_is_refused(content: str, sentence: str) -> None:
    assert sentence in refusal("left.yml", content)


# --------------------------------------------------------------------------- COLMAP


def test_the_example_of_colmap_is_read() -> None:
    """The centre of the first pixel is (0.5, 0.5); x_camera = R x_world + t, y down, z forward."""
    Path("cameras.txt").write_text(CAMERAS, encoding="utf-8")
    projection = seen("images.txt#P1180141", IMAGES)
    assert projection == seen("cameras.txt#1") and projection.image_size == (3072, 2304)
    assert projection.intrinsics == pytest.approx((2559.81, 2559.81, 1535.5, 1151.5), rel=1e-13)
    assert isinstance(projection.lens, Perspective)
    # q (0, x) q* + t, with quaternions multiplied out by hand.
    w, v = 0.851773, np.array([0.0165051, 0.503764, -0.142941])
    norm = w * w + v @ v
    for point in ((0.0, 0.0, 0.0), (1.0, 2.0, 3.0), (-2.0, 0.5, 1.0)):
        x = np.array(point)
        turned = ((w * w - v @ v) * x + 2 * (v @ x) * v + 2 * w * np.cross(v, x)) / norm
        right, down, forward = turned + np.array([-0.737434, 1.02973, 3.74354])
        expected = 2559.81 * np.array([right, down]) / forward + (1536, 1152)
        np.testing.assert_allclose(projection.trace(point).image, expected, atol=1e-9)


def test_the_case_of_a_colmap_camera_alone() -> None:
    projection = seen("cameras.txt", "1 PINHOLE 800 600 750 750 400 300")
    assert projection.intrinsics == pytest.approx((750, 750, 399.5, 299.5), rel=1e-14)
    assert projection.camera == Document().projection.camera
    zero = seen("cameras.txt", "7 OPENCV 800 600 750 740 401 300 0 0 0 0\n")
    assert zero.intrinsics == pytest.approx((750, 740, 400.5, 299.5), rel=1e-13)


@pytest.mark.parametrize(
    ("name", "cameras", "images", "sentence"),
    [
        ("images.txt#2", CAMERAS, IMAGES,
         f"images.txt: cameras.txt, line 6: SIMPLE_RADIAL = '-0.0218531': {DISTORTED}"),
        ("cameras.txt", "1 OPENCV_FISHEYE 8 6 7 7 4 3 0 0 0 0", "",
         "cameras.txt: line 1 = 'OPENCV_FISHEYE': is no perspective camera, and is not read."),
        ("cameras.txt", "1 PINHOLE 800 600 750 400 300", "",
         "cameras.txt: line 1 = '800 600 750 400 300': must be 6 finite numbers."),
        ("cameras.txt", "1 PINHOLE 800 600 750 nan 400 300", "", "line 1 = '800 600 750 nan 400"),
        ("images.txt#1", "1 PINHOLE 8 6 7 7 4 3\n1", IMAGES,
         "images.txt: cameras.txt, line 2 = '': is no perspective camera, and is not read."),
        ("images.txt", "", IMAGES, "images.txt must be followed by"),
        ("images.txt#1", "", IMAGES, "images.txt: line 5 has a CAMERA_ID that is not"),
        ("images.txt#1", CAMERAS, "1 0 0 0 0 1 2 3 1 a.png",
         "quaternion = [0, 0, 0, 0]: must not be the zero vector."),
        ("images.txt#1", CAMERAS, "1 1.5e308 1.5e308 1.5e308 1.5e308 1 2 3 1 a.png",
         "quaternion = 1.5e+308: must be at most 1e+100."),
        ("images.txt", CAMERAS, "1 1 0 0 0 0 0 1e999 1 a.png",
          "line 1 = '1 0 0 0 0 0 1e999': must be 7 finite numbers."),
        ("cameras.txt", "hello\n", "", "cameras.txt is neither a document (.json)"),
    ],
)  # fmt: skip
def test_a_wrong_model_of_colmap_is_refused(
    name: str, cameras: str, images: str, sentence: str
) -> None:
    for file, text in (("cameras.txt", cameras), ("images.txt", images)):
        if text:
            Path(file).write_text(text, encoding="utf-8")
    assert sentence in refusal(name)


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        (
            "cameras.bin",
            "cameras.bin is binary: write text with colmap model_converter --input_path IN"
            " --output_path OUT --output_type TXT.",
        ),
        ("images.bin", "images.bin is binary: "),
        (
            "bundle.out",
            "bundle.out is a file of Bundler, which is not read: export its cameras as COLMAP text,"
            " transforms.json or OpenCV's K, R, t.",
        ),
        ("model.nvm", "model.nvm is a file of VisualSFM, "),
        ("cameras.sfm", "cameras.sfm is a file of Meshroom, "),
        ("scene.blend", "scene.blend is a file of Blender, "),
        ("poses_bounds.npy", "poses_bounds.npy is a file of NumPy, "),
    ],
)
def test_other_programs_are_refused_by_name(name: str, sentence: str) -> None:
    Path(name).write_bytes(b"\x00\xff\x01 {")
    assert refusal(name).startswith(sentence)


def test_a_large_file_takes_linear_time() -> None:
    """A line for each number, and an image with many points."""
    lines = "\n".join(["  0.5,"] * 100_000)
    assert "must be 9 finite numbers" in refusal("a.yml", f"K: [\n{lines} ]\nw: 640\nh: 480\n")
    points = "1 2 -1 " * 100_000
    Path("cameras.txt").write_text(CAMERAS, encoding="utf-8")
    assert seen("images.txt", f"1 1 0 0 0 0 0 0 1 a.png\n{points}\n").image_size == (3072, 2304)
    with open("huge.yml", "wb") as file:
        file.truncate(LARGEST_CAMERAS + 1)
    assert refusal("huge.yml") == "huge.yml is larger than 64 MiB."
