"""Camera files of other programs: NeRF's transforms.json, COLMAP's text, OpenCV's K, R, t.

A file has views by name: functions that put a camera in the place of a projection's.

================  =====================================  ==========================================
file              pose                                   principal point, counted from
================  =====================================  ==========================================
transforms.json   world from camera; x right, y up,      the corner of the first pixel: W/2 is the
                  z backward (OpenGL), as our view       middle
COLMAP            camera from world; x right, y down,    the corner of the first pixel
                  z forward
OpenCV            as COLMAP                              the centre of the first pixel, as in
                                                         `Intrinsics`: (W - 1)/2 is the middle
================  =====================================  ==========================================

Of YAML only names with numbers, and groups of them, are read: no object is made, no alias followed.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from app.document.codec import MISSING, TOO_DEEP, Path, tree_of
from app.document.fields import Tree, number
from app.model.calibration import (
    rotation_from_quaternion,
    rotation_from_vector,
    straightened,
    taken_apart,
    world_from_opencv,
)
from app.model.limits import Array, positive
from app.model.projection import Camera, Perspective, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.strangers import printable

View: TypeAlias = Callable[[Projection, bool], Projection]
"""Puts a camera in the place of a projection's, whose image size was chosen for it if true."""
Views: TypeAlias = dict[str, View]
Group: TypeAlias = Mapping[str, tuple[str, Any]]
"""The values of a camera by their names in lower case without signs, each with its own name."""

MOST_VALUES = 1_000_000
DEEPEST = 20
LONGEST_NAME = 200

OTHER = QT_TRANSLATE_NOOP(
    "Refusal",
    "is a file of {0}, which is not read: export its cameras as COLMAP text, transforms.json or"
    " OpenCV's K, R, t",
)
BINARY = QT_TRANSLATE_NOOP(
    "Refusal",
    "is binary: write text with colmap model_converter --input_path IN --output_path OUT"
    " --output_type TXT",
)
DISTORTED = QT_TRANSLATE_NOOP(
    "Refusal",
    "is a lens with distortion, and here straight lines stay straight: undistort the pictures,"
    " and use the camera of the new ones",
)
NO_PERSPECTIVE = QT_TRANSLATE_NOOP("Refusal", "is no perspective camera, and is not read")
NUMBERS = QT_TRANSLATE_NOOP("Refusal", "must be {0} finite numbers")
ROTATION = QT_TRANSLATE_NOOP("Refusal", "must have three equally long axes at right angles")
MIRRORED = QT_TRANSLATE_NOOP("Refusal", "is a mirrored camera: its determinant is negative")
NO_POSE = QT_TRANSLATE_NOOP(
    "Refusal", "must have three numbers of translation for three or nine of rotation: {0} for {1}"
)
NO_SIZE = QT_TRANSLATE_NOOP(
    "Refusal",
    "is in pixels of an image whose size is not known, and which is not {0} x {1}: set image.width"
    " and image.height as well",
)
NO_MATRIX = QT_TRANSLATE_NOOP(
    "Refusal", "has no camera matrix: camera_matrix, K, or fx, fy, cx and cy"
)
NO_XML = QT_TRANSLATE_NOOP("Refusal", "is not XML as OpenCV writes it: {0}")
OF_COLMAP = QT_TRANSLATE_NOOP("Refusal", "must be {0}")
NO_CAMERA = QT_TRANSLATE_NOOP("Refusal", "has a CAMERA_ID that is not in cameras.txt")
NO_VIEW = QT_TRANSLATE_NOOP("Refusal", "has no view")

_OTHERS = {
    ".nvm": "VisualSFM", ".out": "Bundler", ".sfm": "Meshroom", ".blend": "Blender",
    ".abc": "Alembic", ".fbx": "Autodesk (FBX)", ".npy": "NumPy", ".npz": "NumPy",
    ".db": "COLMAP (its database)", ".bag": "ROS (a bag)",
}  # fmt: skip
_OTHER_KEYS = {
    "sfm_data_version": "OpenMVG", "featuresFolders": "Meshroom", "shots": "OpenSfM",
    "img_name": "Gaussian Splatting",
}  # fmt: skip
_TURNED = 3e-3
"""Most that the axes of a pose may miss right angles: three digits are enough to be read."""
_MIDDLE = 0.3, 0.7
"""Where the principal point is in an image of the right size, in widths and heights."""

_K = ("cameramatrix", "k", "m", "mtx", "intrinsics", "intrinsic", "intrinsicmatrix")
_P = ("p", "projectionmatrix", "cameraprojectionmatrix")
_FOUR = ("fx", "fy", "cx", "cy")
_DISTORTION = (
    ("distortioncoefficients", "distcoeffs", "distortion", "dist", "d"),
    *((name,) for name in ("k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2")),
)
_ROTATIONS = (
    "rvec", "rvecs", "rotationvector", "rotationvectors", "r", "rotation", "rotationmatrix",
)  # fmt: skip
_MOVES = ("t", "tvec", "tvecs", "translation", "translationvector", "translationvectors")
_POSES = ("extrinsic", "extrinsics", "extrinsicmatrix", "rt")
_SIZES = (("w", "imagewidth", "width"), ("h", "imageheight", "height"))
_PARAMETERS = {
    "SIMPLE_PINHOLE": 3, "PINHOLE": 4, "SIMPLE_RADIAL": 4, "RADIAL": 5, "OPENCV": 8,
    "FULL_OPENCV": 12,
}  # fmt: skip
"""The perspective models of COLMAP, which also transforms.json names, and their parameters."""


# --------------------------------------------------------------------------- the file


def views_of(path: Path, text: str, beside: Callable[[str], str]) -> Views | None:
    """Return the views of a camera file; None if it is no such file.

    `beside` returns the text of a file in the same folder, or an empty one if there is none.
    """
    ending = os.path.splitext(path)[1].lower()
    if ending in (".yml", ".yaml", ".xml"):
        is_xml = text.lstrip("\ufeff \t\r\n").startswith("<")
        if views := list(_cameras(_xml(text) if is_xml else _yaml(text), "", DEEPEST)):
            return _named(views)
        raise Refusal.in_document(NO_MATRIX)
    if ending != ".json" and not text.lstrip("\ufeff \t\r\n").startswith("{"):
        return _colmap(text, beside)
    tree = tree_of(text, MOST_VALUES)
    first = tree[0] if isinstance(tree, list) and tree else tree
    for key, program in _OTHER_KEYS.items():
        if isinstance(first, dict) and key in first:
            raise Refusal.in_document(OTHER, program)
    if not isinstance(tree, dict):
        return None
    if not isinstance(frames := tree.get("frames"), list):
        views = list(_cameras(tree, "", DEEPEST))
        return _named(views) if views else None
    own = [frame if isinstance(frame, dict) else {} for frame in frames]
    return _named(
        (str(frame.get("file_path") or ""), partial(_frame, _group({**tree, **frame})))
        for frame in own
    )


def refuse_others(path: Path) -> None:
    """Refuse the cameras of other programs by the name of their program."""
    name = os.path.basename(path).lower()
    if re.fullmatch(r"(cameras|images|points3d|frames|rigs)\.bin", name):
        raise Refusal.in_document(BINARY)
    if program := _OTHERS.get(os.path.splitext(name)[1]):
        raise Refusal.in_document(OTHER, program)


def _named(views: Iterable[tuple[str, View]]) -> Views:
    """Return views by their names; those without one, or with that of another, are numbered."""
    named: Views = {}
    for count, (name, view) in enumerate(views, 1):
        shown = printable(name[:LONGEST_NAME])
        named[shown if shown and shown not in named else f"{shown} ({count})".strip()] = view
    if not named:
        raise Refusal.in_document(NO_VIEW)
    return named


# --------------------------------------------------------------------------- a camera of ours


def seen_through(p: Any, projection: Projection, is_sized: bool) -> Projection:
    """Return the projection of a camera matrix P, (3, 4), as `_seen` does."""
    found = taken_apart(p)
    k, _ = straightened(found, projection.image_size)
    pose = world_from_opencv(found.rotation, found.translation)
    return _seen({"k": ("P", k.tolist())}, pose, 0.0, projection, is_sized)


def _seen(
    group: Group, pose: Array | None, half: float, projection: Projection, is_sized: bool
) -> Projection:
    """Return the projection of a camera over the scene of another one.

    What the file does not have stays: the camera, and the image size if the principal point is
    near its middle. Near and far keep their proportion to the distance of the target.

    Parameters
    ----------
    pose : (3, 4) array, optional
        The columns right, up, backward and eye, in world coordinates.
    half : float
        What the centre of the first pixel has as coordinates.
    """
    for names in _DISTORTION:
        if any(values := _numbers(group, names)):
            key = next(group[name][0] for name in names if name in group)
            value = values[0] if len(values) == 1 else values
            raise Refusal.in_document(DISTORTED, field=key, value=value)
    size = _numbers(group, ("imagesize", "cameraresolution"), 2)
    size = size or [side for names in _SIZES for side in _numbers(group, names, 1)]
    sides: Any = tuple(int(side) if side.is_integer() else side for side in size)
    image = sides if len(sides) == 2 else projection.image_size
    k: Any = _numbers(group, _K, 9, 4)
    focal = [_focal(group, axis, side) for axis, side in zip("xy", image, strict=True)]
    is_angle = not k and not any(name in group for name in ("flx", "fly", *_FOUR[:2]))
    centre = [_numbers(group, [name], 1) for name in _FOUR[2:]]
    if not k:
        if not any(focal):
            raise Refusal.in_document(MISSING, field="fl_x")
        fx, fy = (focal[0] or focal[1])[0], (focal[1] or focal[0])[0]
        middle = zip(centre, image, strict=True)
        k = [fx, fy, *(at[0] - half if at else (side - 1) / 2.0 for at, side in middle)]
    elif len(k) == 9:
        k = np.reshape(k, (3, 3)).tolist()
    camera, lens = projection.camera, projection.with_eye().lens
    near, far = lens.near, lens.far
    if pose is not None:
        camera = _placed(pose, projection.camera)
        ratio = camera.distance / projection.camera.distance
        near, far = (float(f"{plane * ratio:.3g}") for plane in (near, far))
    lens = Perspective(near=near, far=far)
    made = Projection(camera, lens, image, projection.depth, projection.placement)
    made = made.with_intrinsics(k)
    if not (is_sized or is_angle or image is sides):
        at = made.intrinsics[2:]
        low, high = _MIDDLE
        if not all(low < part / side < high for part, side in zip(at, image, strict=True)):
            raise Refusal.in_document(NO_SIZE, *image, field="cx, cy", value=list(at))
    return made


def _focal(group: Group, axis: str, side: int) -> list[float]:
    """Return the focal length along an axis in pixels, if there is one, as instant-ngp does."""
    for name, radians in ((f"{axis}fov", math.pi / 180.0), (f"cameraangle{axis}", 1.0)):
        if f"fl{axis}" not in group and (angle := _numbers(group, [name], 1)):
            return [side / 2.0 / math.tan(positive(group[name][0], angle[0] * radians) / 2.0)]
    return _numbers(group, [f"fl{axis}", f"f{axis}"], 1)


def _placed(pose: Array, before: Camera) -> Camera:
    """Return the camera of a pose; its target is as far away as that of the camera before."""
    axes, eye = pose[:, :3], pose[:, 3]
    lengths = np.linalg.norm(axes, axis=0)
    axes = axes / np.where(lengths > 0.0, lengths, 1.0)
    error = np.abs(axes.T @ axes - np.eye(3)).max()
    if error > _TURNED or lengths.max() > lengths.min() * (1.0 + _TURNED):
        raise Refusal.in_document(ROTATION, field="rotation", value=pose[:, :3].tolist())
    if np.linalg.det(axes) < 0.0:
        raise Refusal.in_document(MIRRORED, field="rotation", value=pose[:, :3].tolist())
    distance = math.dist(eye.tolist(), before.target) or before.distance
    return Camera(eye.tolist(), (eye - distance * axes[:, 2]).tolist(), axes[:, 1].tolist())


# --------------------------------------------------------------------------- names and numbers


def _group(tree: Tree) -> Group:
    return {
        re.sub("[^a-z0-9]", "", key.rpartition(".")[2].lower()): (key, node)
        for key, node in tree.items()
    }


def _tokens(node: Any) -> list[Any]:
    """Return the numbers of a matrix, a list or a text, as they are written."""
    if isinstance(node, Mapping):
        return _tokens(node.get("data", ""))
    if isinstance(node, list):
        return [token for part in node for token in _tokens(part)]
    if not isinstance(node, str):
        return [node]
    words = re.sub(r"[][,\s]+", " ", node).split()
    return [word for word in words if word != "-" and not word.startswith("!!opencv")]


def _numbers(group: Group, names: Sequence[str], *counts: int) -> list[float]:
    """Return the numbers of the first of some names, empty if there is none of them."""
    key, node = next((group[name] for name in names if name in group), ("", None))
    if node is None:
        return []
    tokens = _tokens(node)
    values = [number(str(token)) for token in tokens]
    found = [value for value in values if value is not None]
    if len(found) < len(values) or (counts and len(values) not in counts):
        shown, least = " ".join(map(str, tokens)), counts[0] if counts else len(values)
        raise Refusal.in_document(NUMBERS, least, field=key, value=shown)
    return found


# --------------------------------------------------------------------------- NeRF and OpenCV


def _frame(group: Group, projection: Projection, is_sized: bool) -> Projection:
    for name in ("isfisheye", "equirectangular", "latlong", "fthetap0", "fromna", "cameramodel"):
        key, value = group.get(name, ("", None))
        if value and not (name == "cameramodel" and value in _PARAMETERS):
            raise Refusal.in_document(NO_PERSPECTIVE, field=key, value=value)
    if not (cells := _numbers(group, ["transformmatrix"], 16, 12)):
        raise Refusal.in_document(MISSING, field="transform_matrix")
    return _seen(group, np.reshape(cells, (-1, 4))[:3], 0.5, projection, is_sized)


def _cameras(tree: Tree, name: str, levels: int) -> Iterator[tuple[str, View]]:
    """Yield the views of OpenCV's calibrations; a stereo pair has the names M1, D1 and M2, D2."""
    whole = _group(tree)
    for suffix in ("", "1", "2"):
        group = {key: whole[key] for names in _SIZES for key in names if key in whole}
        group |= {key.removesuffix(suffix): whole[key] for key in whole if key.endswith(suffix)}
        # K1 is a matrix, but k1 a distortion.
        is_k = [key in group and len(_tokens(group[key][1])) >= 4 for key in _K]
        if any(is_k) or {*_FOUR} <= group.keys():
            group = {key: group[key] for key in group if key not in _K or is_k[_K.index(key)]}
            poses = [] if suffix else _poses(group)
            for count, pose in enumerate(poses or [None], 1):
                words = (name, suffix, f"{count}" if len(poses) > 1 else "")
                yield " ".join(filter(None, words)), partial(_seen, group, pose, 0.0)
        elif not suffix and (cells := _numbers(group, _P, 12)):
            yield name, partial(seen_through, np.reshape(cells, (3, 4)))
    for key, part in tree.items():
        if isinstance(part, dict) and levels:
            yield from _cameras(part, key, levels - 1)


def _poses(group: Group) -> list[Array]:
    """Return the poses of the views of a camera; none if the file has none."""
    rows = np.reshape(_numbers(group, _POSES, 16, 12)[:12], (-1, 4))
    pairs = [(rows[:, :3].ravel().tolist(), rows[:, 3].tolist())] if len(rows) else []
    found = _numbers(group, ["extrinsicparameters"])
    pairs += [(found[i : i + 3], found[i + 3 : i + 6]) for i in range(0, len(found) - 5, 6)]
    moves, turns = _numbers(group, _MOVES), _numbers(group, _ROTATIONS)
    # A camera_info of ROS has a rectification R.
    if not pairs and (moves or (turns and "p" not in group)):
        count = max(1, len(moves) // 3)
        each = len(turns) // count
        if each not in (3, 9) or len(moves) != 3 * count or len(turns) != each * count:
            raise Refusal.in_document(NO_POSE, len(moves), len(turns))
        pairs = [(turns[i * each :][:each], moves[i * 3 :][:3]) for i in range(count)]
    return [
        world_from_opencv(
            rotation_from_vector(turn) if len(turn) == 3 else np.reshape(turn, (3, 3)),
            np.array(move),
        )
        for turn, move in pairs
    ]


_ENTRY = re.compile(r"""([ ]*)["']?([A-Za-z_][\w.]*)["']?[ ]*:(?:[ ]+(.*)|[ ]*)$""")


def _yaml(text: str) -> Tree:
    """Read the block mappings of YAML; what else a name has is a list of its lines."""
    tree: Tree = {}
    levels: list[tuple[int, Tree, str]] = [(-1, {"": tree}, "")]
    for line in text.splitlines():
        match = _ENTRY.match(line)
        indent, outer, name = levels[-1]
        if match is None:
            if isinstance(outer[name], list) and not line.lstrip().startswith("#"):
                outer[name].append(line)
            continue
        while len(match[1]) <= indent:
            levels.pop()
            indent, outer, name = levels[-1]
        if len(levels) > DEEPEST:
            raise Refusal.in_document(TOO_DEEP, DEEPEST)
        if not isinstance(outer[name], dict):
            outer[name] = {}
        outer[name][match[2]] = [(match[3] or "").partition(" #")[0]]
        levels.append((len(match[1]), outer[name], match[2]))
    return tree


def _xml(text: str) -> Tree:
    from xml.etree import ElementTree

    try:
        if "<!DOCTYPE" in text or "<!ENTITY" in text:
            raise ValueError("<!DOCTYPE")
        root = ElementTree.fromstring(text)
        if root.tag != "opencv_storage":
            raise ValueError(f"<{root.tag}>")
    except (ElementTree.ParseError, ValueError) as error:
        raise Refusal.in_document(NO_XML, str(error)) from error
    tree: Tree = _element(root, DEEPEST) or {}
    return tree


def _element(element: Any, levels: int) -> Any:
    if len(element) == 0 or levels == 0:
        return element.text or ""
    return {child.tag: _element(child, levels - 1) for child in element}


# --------------------------------------------------------------------------- COLMAP

_CAMERA = re.compile(r"\d+\s+[A-Z]\w*(\s+\d+){2}\s")
_IMAGE = re.compile(r"\d+(\s+[-+.\deE]+){7}\s+\d+\s")
Line: TypeAlias = tuple[str, str]


def _colmap(text: str, beside: Callable[[str], str]) -> Views | None:
    """Return the views of images.txt, or the cameras of a cameras.txt without one."""
    first = next(_lines(text), ("", ""))[1] + " "
    is_cameras = _CAMERA.match(first) is not None
    if not is_cameras and not _IMAGE.match(first):
        return None
    images = beside("images.txt") if is_cameras else text
    rows = _lines(text) if is_cameras else _lines(beside("cameras.txt"), "cameras.txt, ")
    cameras = {line.split(maxsplit=1)[0]: (where, line) for where, line in rows}
    if not images:
        return _named((key, partial(_of_camera, line, None)) for key, line in cameras.items())
    return _named(
        ((line.split(maxsplit=9)[9:] or [""])[0], partial(_image, cameras, (where, line)))
        for where, line in _lines(images, "images.txt, " if is_cameras else "", skipped=1)
    )


def _lines(text: str, file: str = "", skipped: int = 0) -> Iterator[Line]:
    """Yield the lines that are no comment and not empty, and where they are.

    The line after each is skipped if `skipped` is 1: the points of an image, even if it is empty.
    """
    lines = iter(enumerate(text.splitlines(), 1))
    for count, line in lines:
        if (line := line.strip("\ufeff \t")) and not line.startswith("#"):
            yield f"{file}line {count}", line
            if skipped:
                next(lines, None)


def _image(
    cameras: Mapping[str, Line], line: Line, projection: Projection, is_sized: bool
) -> Projection:
    where, parts = line[0], line[1].split(maxsplit=9)
    values = _floats(parts[1:8], where, "IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME", 7)
    if len(parts) < 9 or parts[8] not in cameras:
        raise Refusal.in_document(NO_CAMERA, field=where)
    rotation = rotation_from_quaternion(values[:4])
    pose = world_from_opencv(rotation, np.array(values[4:]))
    return _of_camera(cameras[parts[8]], pose, projection, is_sized)


def _of_camera(
    line: Line, pose: Array | None, projection: Projection, is_sized: bool
) -> Projection:
    """Return the projection of a line of cameras.txt."""
    where, (_, model, *rest) = line[0], (line[1] + " ?").split()[:-1]
    if model not in _PARAMETERS:
        raise Refusal.in_document(NO_PERSPECTIVE, field=where, value=model)
    form = f"CAMERA_ID {model} WIDTH HEIGHT PARAMS[]"
    values = _floats(rest, where, form, _PARAMETERS[model] + 2)
    if model in ("SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL"):  # with one focal length
        values.insert(2, values[2])
    names = "w", "h", *_FOUR, "dist"
    group = {n: (n, value) for n, value in zip(names, [*values[:6], values[6:]], strict=True)}
    group["dist"] = (f"{where}: {model}", values[6:])
    return _seen(group, pose, 0.5, projection, is_sized)


def _floats(texts: Sequence[str], where: str, form: str, count: int) -> list[float]:
    values = [value for value in map(number, texts) if value is not None]
    if len(texts) != count or len(values) != count:
        raise Refusal.in_document(OF_COLMAP, form, field=where, value=" ".join(texts))
    return values
