"""Camera files of other programs: NeRF's transforms.json, COLMAP's text, OpenCV's K, R, t.

A file has views by name: functions that put a camera in the place of a projection's. The poses of
transforms.json are world from camera, with x right, y up, z backward, as our view (OpenGL);
COLMAP's and OpenCV's are camera from world, with x right, y down, z forward. OpenCV counts the
principal point from the centre of the first pixel, as `Intrinsics`; the others from its corner.

Of YAML only names with numbers, and groups of them, are read: no object is made, no alias followed.
"""

import math
import os
import pathlib
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, TypeAlias

import numpy as np

from app.document.codec import Path, tree_of
from app.document.document import Tree
from app.model.camera import (
    rotation_from_quaternion,
    rotation_from_vector,
    taken_apart,
    world_from_opencv,
)
from app.model.limits import Array, between, positive
from app.model.numerals import number
from app.model.parameter import read_sections
from app.model.projection import Camera, Perspective, Projection
from app.model.refusal import REFUSALS, Refusal
from app.strangers import printable

View: TypeAlias = Callable[[Projection], Projection]
"""Puts a camera in the place of a projection's; a `Refusal` if it is not possible."""
Views: TypeAlias = dict[str, View]
Group: TypeAlias = Mapping[str, tuple[str, Any]]
"""The values of a camera by their names in lower case without signs, each with its own name."""

MOST_VALUES = 1_000_000
DEEPEST = 20
LONGEST_NAME = 200


_PAGE = read_sections(pathlib.Path(__file__).with_name("content") / "camera-files.md")
_OTHERS, _OTHER_KEYS = _PAGE["endings"].named, _PAGE["keys"].named
_CALLED = {ours: names.split() for ours, names in _PAGE["names"].named.items()}
_PARAMETERS = {model: int(count) for model, count in _PAGE["models"].named.items()}
_MODELS = (*_PARAMETERS, *_CALLED["perspective"], "")
_FOUR, _SIDES, _NERF = ("fx", "fy", "cx", "cy"), ("width", "height"), "transformmatrix"
MOST_SKEW_PX = 0.5
_TURNED = 3e-3  # most that a pose's axes may miss right angles: three digits are enough to be read
_MIDDLE = 0.3, 0.7  # where an image of the right size has its principal point, in its sides


# --------------------------------------------------------------------------- the file


def views_of(path: Path, text: str, beside: Callable[[str], str]) -> Views | None:
    """Return the views of a camera file; None if it is no such file.

    `beside` returns the text of a file in the same folder, or an empty one if there is none.
    """
    ending = os.path.splitext(path)[1].lower()
    begin = text.lstrip("\ufeff \t\r\n")[:1]
    if ending in (".yml", ".yaml", ".xml"):
        return _named(_cameras(_xml(text) if begin == "<" else _yaml(text), "", DEEPEST))
    if ending != ".json" and begin != "{":
        return _colmap(text, beside)
    tree = tree_of(text, MOST_VALUES)
    first = tree[0] if isinstance(tree, list) and tree else tree
    for key in _OTHER_KEYS.keys() & (first if isinstance(first, dict) else {}):
        raise Refusal.in_document(REFUSALS["other"], _OTHER_KEYS[key])
    if not isinstance(tree, dict):
        return None
    if not isinstance(tree.get("frames"), list):
        return _named(_cameras(tree, "", DEEPEST), is_sure=False)
    frames = [frame if isinstance(frame, dict) else {} for frame in tree["frames"]]
    return _named(
        (str(each.get("file_path") or ""), partial(_frame, tree, each)) for each in frames
    )


def refuse_others(path: Path) -> None:
    """Refuse the cameras of other programs by the name of their program."""
    name = os.path.basename(path).lower()
    if re.fullmatch(r"(cameras|images|points3d|frames|rigs)\.bin", name):
        raise Refusal.in_document(REFUSALS["binary"])
    if program := _OTHERS.get(os.path.splitext(name)[1]):
        raise Refusal.in_document(REFUSALS["other"], program)


def _named(views: Iterable[tuple[str, View]], *, is_sure: bool = True) -> Views:
    """Return views by their names; those without one, or with that of another, are numbered."""
    named: Views = {}
    for count, (name, view) in enumerate(views, 1):
        shown = printable(name[:LONGEST_NAME])
        named[shown if shown and shown not in named else f"{shown} ({count})".strip()] = view
    if is_sure and not named:
        raise Refusal.in_document(REFUSALS["no-view"])
    return named


# --------------------------------------------------------------------------- a camera of ours


def seen_through(
    p: Any, projection: Projection, *, sizes: Group | None = None, is_sized: bool = False
) -> Projection:
    """Return the projection of a camera matrix P, (3, 4), for an image of its size if `is_sized`.

    `sizes` are those of its file. A skew that the rounding of P explains is left out.
    """
    parts = taken_apart(p)
    k = parts.k.copy()
    k[0, 1] = 0.0 if abs(k[0, 1]) <= MOST_SKEW_PX else k[0, 1]
    pose = world_from_opencv(parts.rotation, parts.translation)
    return _seen({**(sizes or {}), "k": ("P", k.tolist())}, pose, 0.0, projection, is_sized)


def _seen(
    group: Group, pose: Array | None, half: float, projection: Projection, is_sized: bool = False
) -> Projection:
    """Return the projection of a camera over the scene of another one.

    What the file does not have stays: the camera, and the image size if the principal point is
    near its middle. Near and far keep their proportion to the distance of the target. The columns
    of `pose`, (3, 4), are right, up, backward and eye in the world; the centre of the first pixel
    is at `half`.
    """
    for name, (key, node) in group.items():
        value = " ".join(map(str, _tokens(node))).strip("'\"")  # a text of YAML
        is_model = name in ("cameramodel", "distortionmodel") and value.upper() not in _MODELS
        if is_model or (name in _CALLED["no perspective"] and value.upper() != "FALSE"):
            raise Refusal.in_document(REFUSALS["no-perspective"], field=key, value=value)
        is_distortion = name.startswith("dist") and not name.endswith("model")
        if (is_distortion or name in _CALLED["distortion"]) and any(_numbers(group, [name])):
            raise Refusal.in_document(REFUSALS["distorted"], field=key, value=value)
    size = _numbers(group, _CALLED["size"], 2)
    size = size or [side for name in _SIDES for side in _numbers(group, _CALLED[name], 1)]
    sides: Any = tuple(int(side) if side.is_integer() else side for side in size)
    image = sides if len(sides) == 2 else projection.image_size
    k: Any = _numbers(group, _CALLED["K"], 9, 4)
    focal = [_focal(group, axis, side) for axis, side in zip("xy", image, strict=True)]
    is_angle = not k and not any(name in group for name in ("flx", "fly", *_FOUR[:2]))
    centre = [_numbers(group, [name], 1) for name in _FOUR[2:]]
    if not k:
        if not any(focal):
            raise Refusal.in_document(REFUSALS["missing"], field="fl_x")
        fx, fy = (focal[0] or focal[1])[0], (focal[1] or focal[0])[0]
        middle = zip(centre, image, strict=True)
        k = [fx, fy, *(at[0] - half if at else (side - 1) / 2.0 for at, side in middle)]
    elif len(k) == 9:
        k = np.reshape(k, (3, 3)).tolist()
    camera, lens = projection.camera, projection.with_eye().lens
    near, far = lens.near, lens.far
    if pose is not None:
        camera = _placed(pose, projection.camera, group)
        ratio = camera.distance / projection.camera.distance
        near, far = (float(f"{plane * ratio:.3g}") for plane in (near, far))
    lens = Perspective(near=near, far=far)
    made = Projection(camera, lens, image, projection.depth, projection.placement)
    made = made.with_intrinsics(k)
    if not (is_sized or is_angle or image is sides):
        at = [round(part, 6) for part in made.intrinsics[2:]]
        low, high = _MIDDLE
        if not all(low < part / side < high for part, side in zip(at, image, strict=True)):
            raise Refusal.in_document(REFUSALS["no-size"], *image, field="cx, cy", value=at)
    return made


def _focal(group: Group, axis: str, side: int) -> list[float]:
    """Return the focal length along an axis in pixels, if there is one, as instant-ngp does."""
    for name, radians in ((f"{axis}fov", math.pi / 180.0), (f"cameraangle{axis}", 1.0)):
        if f"fl{axis}" not in group and (angle := _numbers(group, [name], 1)):
            key = group[name][0]
            between(key, angle[0], 0, math.pi / radians)
            return [side / 2.0 / positive(key, math.tan(angle[0] * radians / 2.0))]
    return _numbers(group, [f"fl{axis}", f"f{axis}"], 1)


@np.errstate(over="ignore", invalid="ignore")  # what is too large is no rotation
def _placed(pose: Array, before: Camera, group: Group) -> Camera:
    """Return the camera of a pose; its target is as far away as that of the camera before.

    Only NeRF's poses may have a scale, which does not move their eye.
    """
    axes, eye = pose[:, :3], pose[:, 3]
    lengths = np.linalg.norm(axes, axis=0)
    axes = axes / np.where(lengths > 0.0, lengths, 1.0)
    error = np.abs(axes.T @ axes - np.eye(3)).max()
    scale, bound = 1.0, REFUSALS["unit-rotation"]
    if _NERF in group:
        scale, bound = lengths.max(), REFUSALS["rotation"]
    is_uneven = np.abs(lengths - scale).max() > _TURNED * scale
    if error > _TURNED or is_uneven or np.linalg.det(axes) < 0.0:
        names = (_NERF, *_CALLED["pose"], *_CALLED["rotation"])
        key, node = next(group[name] for name in names if name in group)
        raise Refusal.in_document(bound, field=key, value=" ".join(map(str, _tokens(node))))
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
    is_counted = not counts or len(tokens) in counts  # first: reading a million numbers takes long
    values = [number(str(token)) for token in tokens] if is_counted else []
    given = [value for value in values if value is not None]
    if len(given) < len(tokens):
        shown, least = " ".join(map(str, tokens)), counts[0] if counts else len(tokens)
        bound = REFUSALS["finite-number"] if least == 1 else REFUSALS["numbers"]
        raise Refusal.in_document(bound, least, field=key, value=shown)
    if counts[:1] == (16,) and len(given) == 16 and given[12:] != [0.0, 0.0, 0.0, 1.0]:
        raise Refusal.in_document(REFUSALS["last-row"], field=key, value=given[12:])
    return given


# --------------------------------------------------------------------------- NeRF and OpenCV


def _frame(tree: Tree, frame: Tree, projection: Projection) -> Projection:
    group = _group({**tree, **frame})
    if not (cells := _numbers(group, [_NERF], 16, 12)):
        raise Refusal.in_document(REFUSALS["missing"], field="transform_matrix")
    return _seen(group, np.reshape(cells, (-1, 4))[:3], 0.5, projection)


def _cameras(tree: Tree, name: str, levels: int) -> Iterator[tuple[str, View]]:
    """Yield the views of OpenCV's calibrations; a stereo pair has the names M1, D1 and M2, D2."""
    whole = _group(tree)
    sizes = {key: whole[key] for of in ("size", *_SIDES) for key in _CALLED[of] if key in whole}
    for suffix in ("", "1", "2"):
        # k1 and p1 are no matrices, but distortion.
        ours = whole if not suffix else [k for k in whole if k[-1:] == suffix and k[0] not in "kp"]
        group = {**sizes, **{key.removesuffix(suffix): whole[key] for key in ours}}
        if any(key in group for key in _CALLED["K"]) or {*_FOUR} <= group.keys():
            poses = [] if suffix else _poses(group)
            for count, pose in enumerate(poses or [None], 1):
                words = (name, suffix, f"{count}" if len(poses) > 1 else "")
                yield " ".join(filter(None, words)), partial(_seen, group, pose, 0.0)
        elif not suffix and (cells := _numbers(group, _CALLED["P"], 12)):
            yield name, partial(seen_through, np.reshape(cells, (3, 4)), sizes=sizes)
    for key, part in tree.items():
        if isinstance(part, dict) and levels:
            yield from _cameras(part, key, levels - 1)


def _poses(group: Group) -> list[Array]:
    """Return the poses of the views of a camera; none if the file has none."""
    rows = np.reshape(_numbers(group, _CALLED["pose"], 16, 12)[:12], (-1, 4))
    pairs = [(rows[:, :3].ravel().tolist(), rows[:, 3].tolist())] if len(rows) else []
    poses = _numbers(group, ["extrinsicparameters"])
    pairs += [(poses[i : i + 3], poses[i + 3 : i + 6]) for i in range(0, len(poses) - 5, 6)]
    moves, turns = (_numbers(group, _CALLED[name]) for name in ("move", "rotation"))
    # A camera_info of ROS has a rectification R.
    if not pairs and (moves or (turns and "p" not in group)):
        count = max(1, len(moves) // 3)
        each = len(turns) // count
        if each not in (3, 9) or len(moves) != 3 * count or len(turns) != each * count:
            raise Refusal.in_document(REFUSALS["no-pose"], field="t", value=moves)
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
            raise Refusal.in_document(REFUSALS["too-deep"], DEEPEST)
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
        raise Refusal.in_document(REFUSALS["no-xml"], str(error)) from error
    return {
        child.tag: {part.tag: part.text or "" for part in child} or child.text or ""
        for child in root
    }


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
    views = list[tuple[str, View]]()
    lines = _lines(images, "images.txt, " if is_cameras else "", are_empty=True)
    for where, line in lines:  # the points of an image follow it, and may be an empty line
        if line:
            name = line.split(maxsplit=9)[9:]
            views.append(("".join(name), partial(_image, cameras, (where, line))))
            next(lines, None)
    return _named(views)


def _lines(text: str, file: str = "", *, are_empty: bool = False) -> Iterator[Line]:
    """Yield the lines that are no comment, and where they are; empty ones only if they count."""
    for count, line in enumerate(text.splitlines(), 1):
        line = line.strip("\ufeff \t")
        if not line.startswith("#") and (line or are_empty):
            yield f"{file}line {count}", line


def _image(cameras: Mapping[str, Line], line: Line, projection: Projection) -> Projection:
    where, parts = line[0], line[1].split(maxsplit=9)
    values = _numbers({"": (where, parts[1:8])}, [""], 7)
    if len(parts) < 9 or parts[8] not in cameras:
        raise Refusal.in_document(REFUSALS["camera-files-no-camera"], field=where)
    pose = world_from_opencv(rotation_from_quaternion(values[:4]), np.array(values[4:]))
    return _of_camera(cameras[parts[8]], pose, projection)


def _of_camera(line: Line, pose: Array | None, projection: Projection) -> Projection:
    where, parts = line[0], line[1].split()
    model = "".join(parts[1:2])
    if model not in _PARAMETERS:
        raise Refusal.in_document(REFUSALS["no-perspective"], field=where, value=model)
    values = _numbers({"": (where, parts[2:])}, [""], _PARAMETERS[model] + 2)
    if model in ("SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL"):  # with one focal length
        values.insert(2, values[2])
    group = {name: (name, value) for name, value in zip(("w", "h", *_FOUR), values, strict=False)}
    return _seen({**group, "d": (f"{where}: {model}", values[6:])}, pose, 0.5, projection)
