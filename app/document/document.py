"""The document: a scene with its settings, and a projection, kept in a file.

It is JSON, described in `to_json`. Everything that comes from outside (files, PNG pictures that
carry a document, the ``--set`` language of the command line) enters here and is checked here;
what is wrong is refused with one sentence, a `Refusal`. Files are written whole or not at
all. The numbers themselves are checked by `app.model.projection`, once for the whole program.
"""

from __future__ import annotations

import contextlib
import difflib
import json
import math
import os
import re
import secrets
import stat
import struct
import sys
import time
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import partial
from types import MappingProxyType
from typing import Any, BinaryIO, NamedTuple, TypeAlias

from app.document.compare import (
    HELD_ELSEWHERE,
    MOST_PICTURES,
    PARTS,
    SOME_DIVIDERS,
    SOME_PICTURES,
    Held,
    Picture,
)
from app.document.view import AS_EVER, View, read_view, view_tree
from app.document.view import FIELDS as VIEW_FIELDS
from app.model.limits import FOUR_BY_FOUR, OTHER_SIDE
from app.model.object_transform import NOT_MOVED, ObjectTransform
from app.model.projection import (
    FINITE_NUMBER,
    LARGEST_IMAGE_PX,
    LENSES,
    ONE_OF,
    THREE_NUMBERS,
    WHOLE_PIXELS,
    Camera,
    FreeMatrix,
    Lens,
    Projection,
    kinds,
)
from app.model.refusal import QT_TRANSLATE_NOOP, Bound, Refusal, format_value, shown_name
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.settings import YES_OR_NO, Setting, Settings
from app.scenes.shapes import LETTER_F
from app.strangers import open_regular

if sys.platform != "win32":
    import fcntl

Path: TypeAlias = str | os.PathLike[str]
Tree: TypeAlias = dict[str, Any]

FORMAT = "frustum-lab"


def _with_view(tree: Tree) -> Tree:
    """Version 1 had the panes' cameras alone, at the top; a key "view" there was nobody's."""
    strange = {"version 1": tree.pop("view")} if "view" in tree else {}
    panes = {"panes": tree.pop("views")} if "views" in tree else {}
    return tree | ({"view": panes | strange} if panes or strange else {})


MIGRATIONS: tuple[Callable[[Tree], Tree], ...] = (_with_view,)
"""Step i turns a document of version i + 1 into one of version i + 2."""
VERSION = len(MIGRATIONS) + 1
"""Version of the documents that are written."""

MESH_ENDINGS = (".obj", ".stl", ".ply", ".gltf", ".glb")
"""A scene whose name ends so is a mesh file; any other is built in."""

LARGEST_DOCUMENT = 16 * 2**20
"""Most bytes read as a document; one of a thousand keys of its own has 100 000."""
LARGEST_PICTURE = 2**30
"""Most bytes read as a PNG picture."""
MOST_VALUES = 200_000
"""Most values of a document, by its commas: reading takes microseconds for each."""
SHORTEST = 1e-100
"""Shortest distance and up of a pane's own camera: VTK squares them."""
DEEPEST = 50
"""Most levels of brackets in a document, far below what Python's recursion can write again."""

MISSING = QT_TRANSLATE_NOOP("Refusal", "is missing")
EMPTY = QT_TRANSLATE_NOOP("Refusal", "is empty")
BROKEN = QT_TRANSLATE_NOOP(
    "Refusal", "is broken or cut short: from line {0}, column {1} on it is not JSON"
)
NOT_TEXT = QT_TRANSLATE_NOOP("Refusal", "is not a Frustum Lab document: it is not UTF-8 text")
FOREIGN = QT_TRANSLATE_NOOP("Refusal", "is not a Frustum Lab document")
NEWER = QT_TRANSLATE_NOOP(
    "Refusal",
    "was written by a newer Frustum Lab: its version is {0}, this program reads up to {1}",
)
VERSION_NUMBER = QT_TRANSLATE_NOOP("Refusal", "must be a whole number from 1 on")
TWICE = QT_TRANSLATE_NOOP("Refusal", "is given twice")
FINITE_OR_INF = QT_TRANSLATE_NOOP("Refusal", "must be a finite number or inf")
TOO_DEEP = QT_TRANSLATE_NOOP("Refusal", "has more than {0} levels of brackets")
TOO_MANY = QT_TRANSLATE_NOOP("Refusal", "has more than {0} values")
TOO_LARGE = QT_TRANSLATE_NOOP("Refusal", "is larger than {0} MiB")
OBJECT = QT_TRANSLATE_NOOP("Refusal", "must be an object with named values in braces")
SCENE_NAME = QT_TRANSLATE_NOOP("Refusal", "must be the name of a scene or of a mesh file")
NO_FILE = QT_TRANSLATE_NOOP("Refusal", "does not exist")
FOLDER = QT_TRANSLATE_NOOP("Refusal", "is a folder, not a file")
WRITE_PROTECTED = QT_TRANSLATE_NOOP("Refusal", "cannot be written: it is write-protected")
NOT_REGULAR = QT_TRANSLATE_NOOP(
    "Refusal", "cannot be written: it is a pipe or a device, not a regular file"
)
UNREADABLE = QT_TRANSLATE_NOOP("Refusal", "cannot be read: {0}")
UNWRITABLE = QT_TRANSLATE_NOOP("Refusal", "cannot be written: {0}")
BAD_NAME = QT_TRANSLATE_NOOP("Refusal", "is not a name that a file can have")
BROKEN_PICTURE = QT_TRANSLATE_NOOP(
    "Refusal", "is not a whole PNG picture: it is broken or cut short"
)
NEITHER = QT_TRANSLATE_NOOP(
    "Refusal",
    "is neither a document (.json), a lesson (.md), an exported picture (.png) nor a mesh ({0})",
)
PLAIN_PICTURE = QT_TRANSLATE_NOOP("Refusal", "is a picture without a Frustum Lab document in it")
UNKNOWN = QT_TRANSLATE_NOOP("Refusal", "is not known; the nearest name is {0}")
OTHER_LENS = QT_TRANSLATE_NOOP("Refusal", "belongs to another lens: set lens.kind as well ({0})")
OTHER_SCENE = QT_TRANSLATE_NOOP("Refusal", "belongs to another scene: set scene as well ({0})")
MESH_NAME = QT_TRANSLATE_NOOP("Refusal", "must be the path of a mesh file ({0}), or empty for none")
NO_MESH_HERE = QT_TRANSLATE_NOOP(
    "Refusal", "cannot be shown in the scene {0}, which needs its own objects"
)
FIXED = QT_TRANSLATE_NOOP(
    "Refusal", "cannot be moved in the scene {0}, whose objects are fixed; another scene's can"
)
POINTS = QT_TRANSLATE_NOOP("Refusal", "must be x, y, z of one point after the other")
AWAY_FROM_TARGET = QT_TRANSLATE_NOOP("Refusal", "must be at least {0} away from the target")
LONGER = QT_TRANSLATE_NOOP("Refusal", "must be at least {0} long")
A_NAME = QT_TRANSLATE_NOOP("Refusal", "must be a name")
SOME_CHANGES = QT_TRANSLATE_NOOP("Refusal", "must be a list of texts NAME=VALUE")
COMPARED = QT_TRANSLATE_NOOP(
    "Refusal",
    "must be a ready-made comparison of the scene ({0}), or NAME=VALUE; with ; between the values"
    " of a picture, and | between pictures",
)
NO_EQUALS = QT_TRANSLATE_NOOP("Refusal", "must be written as NAME=VALUE")


@dataclass(frozen=True)
class Document:
    """What a file holds: a scene seen through a projection.

    Parameters
    ----------
    scene : str
        Name of a built-in scene, or path of a mesh file.
    projection : Projection
    extra : dict
        Keys that this program does not know, kept for those that do, in the places where they
        stood: ``{"author": "...", "lens": {"label": "..."}}``. Not to be changed in place.
    view : View
        How it is looked at: no part of the model, so that it is no part of what is compared, but
        a figure shall be drawn as it was seen.
    settings : mapping
        Of the phenomenon that the scene is; those not given are its defaults. Complete and
        read-only when it is made, and empty for every other scene.
    mesh : str
        Path of the user's mesh that stands in the place of a phenomenon's own objects; empty for
        none.
    quality : Quality
        How exactly and how finely it is drawn.

    Raises
    ------
    Refusal
        If the scene is not a name, the mesh not one that it can show, the scene cannot have these
        settings, or its objects are fixed and the projection moves them.
    """

    scene: str = "letter-f"
    projection: Projection = LETTER_F
    extra: Tree = field(default_factory=dict)
    view: View = field(default_factory=View, compare=False)
    settings: Settings = field(default_factory=dict)
    mesh: str = ""
    quality: Quality = AUTOMATIC

    def __post_init__(self) -> None:
        if not isinstance(self.scene, str) or not self.scene or "\0" in self.scene:
            raise Refusal.in_document(SCENE_NAME, field="scene", value=self.scene)
        phenomenon = PHENOMENA.get(self.scene)
        settings = phenomenon.checked(self.settings) if phenomenon else MappingProxyType({})
        object.__setattr__(self, "settings", settings)
        if phenomenon is not None and not self.projection.placement.is_identity:
            raise Refusal.in_document(FIXED, self.scene, field="object")
        if self.mesh != "":
            if not isinstance(self.mesh, str) or "\0" in self.mesh or not is_mesh(self.mesh):
                bound = MESH_NAME, ", ".join(MESH_ENDINGS)
                raise Refusal.in_document(*bound, field="mesh", value=self.mesh)
            if phenomenon is None or not phenomenon.own_mesh:
                raise Refusal.in_document(NO_MESH_HERE, self.scene, field="mesh", value=self.mesh)
        # A key that the lens before did not know may be a field of the one it was changed to.
        object.__setattr__(
            self,
            "extra",
            _unknown(self.extra, self.scene, self.projection.lens.kind, self.view.panes),
        )

    def __hash__(self) -> int:
        return hash(
            (self.scene, self.projection, tuple(self.settings.items()), self.mesh, self.quality)
        )

    def with_settings(self, settings: Mapping[str, Any]) -> Document:
        """The document with some settings changed, and the projection that goes with them.

        Parameters
        ----------
        settings : mapping
            New values; what is not in it stays.

        Raises
        ------
        Refusal
            If the scene cannot have them, or no projection goes with them.
        """
        phenomenon = PHENOMENA.get(self.scene)
        if phenomenon is None:
            return self
        projection, after = phenomenon.changed(self.projection, self.settings, settings)
        return replace(self, projection=projection, settings=after)

    def pictured(self, picture: Picture) -> Document:
        """The document as one of the pictures shows it that it is compared with.

        Raises
        ------
        Refusal
            If there is no such picture of it just now.
        """
        plain = replace(self, view=AS_EVER)
        if picture.live:
            return plain
        if picture.held is not None:
            return replace(
                plain, projection=picture.held.projection, settings=picture.held.settings
            )
        return set_values(plain, picture.changes)

    def compared(self, name: str) -> Document:
        """The document beside the other pictures of one of its scene's own comparisons.

        It is the picture whose values it has, or becomes the last of them.

        Raises
        ------
        Refusal
            If the scene has none of this name, or has no such pictures just now.
        """
        phenomenon = PHENOMENA.get(self.scene)
        ready = {each.name: each for each in phenomenon.comparisons} if phenomenon else {}
        if name not in ready:
            names = ", ".join(ready) or "none"
            raise Refusal.in_document(COMPARED, names, field="view.compare", value=name)
        pictures = [Picture(*each) for each in ready[name].pictures]
        states = [self.pictured(picture) for picture in pictures]
        own = states.index(self) if self in states else len(states) - 1
        pictures[own] = replace(pictures[own], live=True)
        view = replace(self.view, compare=tuple(pictures), dividers=())
        return replace(states[own], view=view)

    def name_of(self, picture: Picture) -> str:
        """What one of the pictures is called that it is compared with.

        Its own name; that of the document's own picture as long as it has the values for it. Else
        one of the drawings' words: ``held``, ``now``, ``other``.
        """
        if not picture.live:
            return picture.name or ("other" if picture.held is None else "held")
        if picture.name:
            with contextlib.suppress(Refusal):  # then it has not these values
                if self.pictured(replace(picture, live=False)) == self:
                    return picture.name
        return "now"

    @property
    def state(self) -> Held:
        """What of it can be held, to be compared with what comes."""
        return Held(self.projection, self.settings)


# --------------------------------------------------------------------------- names and values


def lens_fields(kind: object) -> tuple[str, ...]:
    """The fields of a kind of lens; none of a kind that there is not."""
    if not isinstance(kind, str) or kind not in kinds():
        return ()
    return tuple(field.name for field in fields(LENSES.get(kind, FreeMatrix)))


_CAMERA = tuple(f.name for f in fields(Camera))
_OBJECT = tuple(f.name for f in fields(ObjectTransform))
_QUALITY = tuple(f.name for f in fields(Quality))
_OPTIONAL = ("keep",)
_MATRICES = ("lens.clip_from_view", "lens.view_from_world")
_TEXTS = (
    *("scene", "mesh", "depth", "lens.keep", "object.order"),
    *(f"quality.{key}" for key in _QUALITY if key != "detail"),
    *(f"view.{key}" for key in VIEW_FIELDS if key != "stage"),
)
# What float() takes and no document would: 1_000, nan, infinity, digits of other scripts.
_NUMBER = re.compile(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?")
_LONGEST_SHOWN = 60


_SECTIONS = ("settings", "object", "camera", "lens", "image", "quality", "view")


def model_paths() -> dict[str, str]:
    """The paths of the model's fields in the document, where they are not the same."""
    return (
        {key: f"camera.{key}" for key in _CAMERA}
        | {key: f"object.{key}" for key in _OBJECT}
        | {key: f"lens.{key}" for kind in kinds() for key in ("kind", *lens_fields(kind))}
        | {key: f"image.{key}" for key in ("width", "height")}
    )


def _known(scene: str, kind: object) -> dict[str, tuple[str, ...]]:
    """The keys that this program knows, by section; the top level is section ``""``."""
    return {
        "": ("format", "version", "scene", "mesh", "depth", *_SECTIONS),
        "settings": tuple(setting.name for setting in _settings_of(scene)),
        "object": _OBJECT,
        "camera": _CAMERA,
        "lens": ("kind", *lens_fields(kind)),
        "image": ("width", "height"),
        "quality": _QUALITY,
        "view": VIEW_FIELDS,
    }


def _settings_of(scene: str) -> tuple[Setting, ...]:
    return PHENOMENA[scene].settings if scene in PHENOMENA else ()


def _unknown(tree: Tree, scene: str, kind: str, panes: Iterable[str]) -> Tree:
    """What is left of a document without the keys that this program knows."""
    known = _known(scene, kind)
    left = {key: value for key, value in tree.items() if key not in known[""]}
    for section in _SECTIONS:
        inside = {k: v for k, v in tree.get(section, {}).items() if k not in known[section]}
        former = tree.get(section, {}).get("former")
        if section == "lens" and "former" in known[section] and isinstance(former, dict):
            names = ("kind", *lens_fields(former.get("kind")))
            beside = {k: v for k, v in former.items() if k not in names}
            inside |= {"former": beside} if beside else {}
        if section == "view":
            cameras = tree.get("view", {}).get("panes", {})
            labels = {
                name: {k: v for k, v in cameras.get(name, {}).items() if k not in _CAMERA}
                for name in panes
            }
            labels = {name: beside for name, beside in labels.items() if beside}
            inside |= {"panes": labels} if labels else {}
        if inside:
            left[section] = inside
    return left


class _Literal(str):
    """A number as it was typed, where no float can stand for it: shown without quotes."""

    def __repr__(self) -> str:
        return str(self)


def _number(text: str) -> float | None:
    """A number in the C locale, or None: what is not one, or is too large for float64."""
    number = float(text) if _NUMBER.fullmatch(text) else math.inf
    return number if math.isfinite(number) else None


def _plain(number: float) -> float | str:
    """A number as JSON is to show it: 6, not 6.0; and it has no word for infinity."""
    if number == math.inf:
        return "inf"
    if number.is_integer() and abs(number) < 1e15 and (number or math.copysign(1.0, number) > 0):
        return int(number)
    return number


# --------------------------------------------------------------------------- text to document


class _Refused(NamedTuple):
    """Stands in a tree for what must not be there, until its path is known."""

    bound: Bound
    key: str = ""
    value: object = ...


def _read_pairs(pairs: list[tuple[str, Any]]) -> Tree | _Refused:
    tree = dict(pairs)
    if len(tree) < len(pairs):
        seen: set[str] = set()
        for key, _ in pairs:
            if key in seen:
                return _Refused(TWICE, key)
            seen.add(key)
    return tree


def _read_float(text: str) -> float | _Refused:
    number = float(text)
    return number if math.isfinite(number) else _not_finite(text)


def _read_int(text: str) -> int | _Refused:
    return int(text) if math.isfinite(float(text)) else _not_finite(text)


def _not_finite(text: str) -> _Refused:
    return _Refused(FINITE_NUMBER, "", _Literal(text))


def _check_tree(value: Any, path: str, depth: int) -> None:
    """Refuse, by its path, what JSON's grammar lets through."""
    if isinstance(value, _Refused):
        path = _join(path, value.key) if value.key else path
        if not path:
            raise Refusal.in_document(FOREIGN)
        raise Refusal.in_document(value.bound, field=path, value=value.value)
    if depth > DEEPEST:
        raise Refusal.in_document(TOO_DEEP, DEEPEST)
    if isinstance(value, dict):
        for key, part in value.items():
            if key == "far" and isinstance(part, _Refused) and part.bound == FINITE_NUMBER:
                part = part._replace(bound=_bound_of_far(value.get("kind")))
            if isinstance(part, (dict, list, _Refused)):
                _check_tree(part, _join(path, key), depth + 1)
    elif isinstance(value, list):
        for place, part in enumerate(value):
            if isinstance(part, (dict, list, _Refused)):
                _check_tree(part, f"{path}[{place}]", depth + 1)


def _bound_of_far(kind: object) -> Bound:
    """What a far that is no number must be: of some lenses it may be infinite."""
    lens = LENSES.get(kind) if isinstance(kind, str) else None
    return FINITE_OR_INF if lens is not None and lens.far_may_be_infinite else FINITE_NUMBER


def _join(path: str, key: str) -> str:
    shown = shown_name(key[:_LONGEST_SHOWN])
    return f"{path}.{shown}" if path else shown


def parse(text: str, folder: Path | None = None) -> Document:
    """Read a document from its text.

    Parameters
    ----------
    text : str
        JSON as `to_json` writes it.
    folder : path, optional
        Where the text was found; the path of a mesh is understood from there.

    Raises
    ------
    Refusal
        For anything but a valid document.
    """
    text = text.removeprefix("\ufeff")  # some editors' mark that the text is UTF-8
    if not text.strip():
        raise Refusal.in_document(EMPTY)
    if text.count(",") >= MOST_VALUES:
        raise Refusal.in_document(TOO_MANY, MOST_VALUES)
    try:
        tree = json.loads(
            text,
            object_pairs_hook=_read_pairs,
            parse_float=_read_float,
            parse_int=_read_int,
            parse_constant=_not_finite,
        )
    except json.JSONDecodeError as error:
        raise Refusal.in_document(BROKEN, error.lineno, error.colno) from error
    except RecursionError as error:
        raise Refusal.in_document(TOO_DEEP, DEEPEST) from error
    _check_tree(tree, "", 0)
    if not isinstance(tree, dict) or tree.get("format") != FORMAT:
        raise Refusal.in_document(FOREIGN)
    version = _whole(_required(tree, "version", "version"))
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise Refusal.in_document(VERSION_NUMBER, field="version", value=version)
    if version > VERSION:
        raise Refusal.in_document(NEWER, format_value(version), VERSION)
    for step in MIGRATIONS[version - 1 :]:
        tree = step(tree)
    try:
        return _document(tree, folder)
    except Refusal as error:
        if version == 1 and error.field.startswith("view.panes"):  # where the file has them
            error.field = error.field.replace("view.panes", "views", 1)
        raise


def _whole(number: Any) -> Any:
    """JSON knows one kind of number: 800.0 is 800."""
    return int(number) if isinstance(number, float) and number.is_integer() else number


def _required(tree: Tree, key: str, path: str) -> Any:
    if key not in tree:
        raise Refusal.in_document(MISSING, field=path)
    return tree[key]


def _section(tree: Tree, name: str) -> Tree:
    section = _required(tree, name, name)
    if not isinstance(section, dict):
        raise Refusal.in_document(OBJECT, field=name, value=section)
    return section


@contextlib.contextmanager
def _paths(section: str = "") -> Iterator[None]:
    """Give the model's complaints their paths in the document."""
    try:
        yield
    except Refusal as error:
        if error.file is not None:  # which has its path
            raise
        name, bracket, cell = error.field.partition("[")
        path = f"{section}.{name}" if section else model_paths().get(name, name)
        raise Refusal.in_document(
            error.bound, *error.limits, field=path + bracket + cell, value=error.value
        ) from error


@_paths()
def _document(tree: Tree, folder: Path | None = None) -> Document:
    """Make a document of the current version from its JSON tree."""
    scene = _required(tree, "scene", "scene")
    if not isinstance(scene, str):
        raise Refusal.in_document(SCENE_NAME, field="scene", value=scene)
    mesh = tree.get("mesh", "")
    if folder is not None:
        if is_mesh(scene):
            scene = os.path.normpath(os.path.join(os.path.realpath(folder), scene))
        if isinstance(mesh, str) and mesh:
            mesh = os.path.normpath(os.path.join(os.path.realpath(folder), mesh))
    settings = _section(tree, "settings") if "settings" in tree else {}

    values = _section(tree, "camera")
    camera = Camera(*(_required(values, key, f"camera.{key}") for key in _CAMERA))

    values = _section(tree, "lens")
    kind = _required(values, "kind", "lens.kind")
    lens: Lens
    if kind == FreeMatrix.kind:
        cells = _required(values, "clip_from_view", "lens.clip_from_view")
        former = _lens(values["former"], "lens.former") if "former" in values else None
        view = values.get("view_from_world")
        lens = FreeMatrix(cells, view) if former is None else FreeMatrix(cells, view, former)
    else:
        lens = _lens(values, "lens")

    values = _section(tree, "image")
    width, height = (_whole(_required(values, key, f"image.{key}")) for key in ("width", "height"))
    depth = _required(tree, "depth", "depth")
    values = _section(tree, "object") if "object" in tree else {}
    placement = ObjectTransform(**{key: values[key] for key in _OBJECT if key in values})
    projection = Projection(camera, lens, (width, height), depth, placement)
    values = _section(tree, "view") if "view" in tree else {}
    panes = values.get("panes", {})
    if not isinstance(panes, dict):
        raise Refusal.in_document(OBJECT, field="view.panes", value=panes)
    cameras = {name: _pane_camera(panes, name) for name in panes}
    pictures = _pictures(values.get("compare", []), scene, mesh)
    with _paths("view"):
        view = read_view(values, cameras, pictures)
    values = _section(tree, "quality") if "quality" in tree else {}
    quality = Quality(**{key: values[key] for key in _QUALITY if key in values})
    unknown = _unknown(tree, scene, kind, cameras)
    return Document(scene, projection, unknown, view, settings, mesh, quality)


@contextlib.contextmanager
def _inside(path: str) -> Iterator[None]:
    """Give complaints of a document that is in a document their paths in that."""
    try:
        yield
    except Refusal as error:
        error.field = f"{path}.{error.field}" if error.field else path
        raise


def _pictures(value: Any, scene: str, mesh: Any) -> tuple[Picture, ...]:
    """The pictures that a document is compared with, as `_picture_tree` writes them."""
    path = "view.compare"
    if not isinstance(value, list) or len(value) > MOST_PICTURES:
        raise Refusal.in_document(SOME_PICTURES, MOST_PICTURES, field=path, value=value)
    pictures = []
    for place, part in enumerate(value):
        where = f"{path}[{place}]"
        if not isinstance(part, dict):
            raise Refusal.in_document(OBJECT, field=where, value=part)
        values: Tree = {"name": "", "set": [], "live": False, "held": {}} | part
        texts = isinstance(values["set"], list) and all(isinstance(x, str) for x in values["set"])
        for key, fits, bound in (
            ("name", isinstance(values["name"], str), A_NAME),
            ("set", texts, SOME_CHANGES),
            ("live", isinstance(values["live"], bool), YES_OR_NO),
            ("held", isinstance(values["held"], dict), OBJECT),
        ):
            if not fits:
                raise Refusal.in_document(bound, field=f"{where}.{key}", value=values[key])
        held = _held(part["held"], f"{where}.held", scene, mesh) if "held" in part else None
        changes = tuple(values["set"])
        with _paths(where):
            pictures.append(Picture(values["name"], changes, held, values["live"]))
    return tuple(pictures)


def _held(values: Tree, path: str, scene: str, mesh: Any) -> Held:
    """A held state from its own part of a document: of the same scene."""
    for key, own in (("scene", scene), ("mesh", mesh)):
        if values.get(key, own) != own:
            field = f"{path}.{key}"
            raise Refusal.in_document(HELD_ELSEWHERE, repr(own), field=field, value=values[key])
    with _inside(path):
        return _document(
            {key: values[key] for key in PARTS if key in values} | {"scene": scene}
        ).state


def _picture_tree(picture: Picture, scene: str) -> Tree:
    tree: Tree = {}
    if picture.name:
        tree["name"] = picture.name
    if picture.changes:
        tree["set"] = list(picture.changes)
    if picture.live:
        tree["live"] = True
    if picture.held is not None:
        held = Document(scene, picture.held.projection, settings=picture.held.settings)
        tree["held"] = {key: value for key, value in _tree(held).items() if key in PARTS}
    return tree


def _lens(values: Any, path: str) -> Lens:
    """A lens that has fields; of a free matrix it is the former one, with a path of its own."""
    if not isinstance(values, dict):
        raise Refusal.in_document(OBJECT, field=path, value=values)
    kind = _required(values, "kind", f"{path}.kind")
    if not isinstance(kind, str) or kind not in LENSES:
        known = kinds() if path == "lens" else LENSES
        raise Refusal.in_document(ONE_OF, ", ".join(known), field=f"{path}.kind", value=kind)
    for key in lens_fields(kind):
        if key not in _OPTIONAL:
            _required(values, key, f"{path}.{key}")
    values = {key: values[key] for key in lens_fields(kind) if key in values}
    if values["far"] == "inf":
        values["far"] = math.inf
    try:
        lens: Lens = LENSES[kind](**values)
        return lens
    except Refusal as error:
        refused, bound = error.field, error.bound
        if refused == "far" and bound == FINITE_NUMBER:
            bound = _bound_of_far(kind)
        raise Refusal.in_document(
            bound, *error.limits, field=f"{path}.{refused}", value=error.value
        ) from error


def _pane_camera(panes: Tree, name: str) -> Camera:
    path = _join("view.panes", name)
    if not isinstance(panes[name], dict):
        raise Refusal.in_document(OBJECT, field=path, value=panes[name])
    with _paths(path):
        camera = Camera(*(_required(panes[name], key, f"{path}.{key}") for key in _CAMERA))
        if camera.distance < SHORTEST:
            raise Refusal("eye", camera.eye, AWAY_FROM_TARGET, SHORTEST)
        if math.hypot(*camera.up) < SHORTEST:
            raise Refusal("up", camera.up, LONGER, SHORTEST)
    return camera


# --------------------------------------------------------------------------- document to text


def is_mesh(scene: str) -> bool:
    """Tell whether a scene's name is the path of a mesh file."""
    return scene.lower().endswith(MESH_ENDINGS)


def to_json(document: Document, folder: Path | None = None) -> str:
    """Write a document as text; `parse` gives back exactly the same document.

    Parameters
    ----------
    document : Document
    folder : path, optional
        Where the text is going to be; a mesh near there is named from there, so that the two
        can be moved together.

    Returns
    -------
    str
        One line for each part::

            {
              "format": "frustum-lab",
              "version": 2,
              "scene": "letter-f",
              "camera": {"eye": [6, 5, 9], "target": [0, 2.2, 0], "up": [0, 1, 0]},
              "lens": {"kind": "perspective", "fov_y_deg": 45, "near": 4, "far": 18},
              "depth": "opengl",
              "image": {"width": 1280, "height": 720}
            }

        An infinite far is ``"inf"``. A phenomenon has its ``settings`` after the scene, and perhaps
        a ``mesh``; ``quality`` holds what of it is not automatic, and ``view`` what of it is not as
        ever, with the panes' cameras. Keys that were not known when it was read are there again.
    """
    tree = _tree(document)
    if folder is not None:
        for key in ("scene", "mesh"):
            if key in tree:
                tree[key] = _mesh_from(tree[key], folder)
    text = _dump(tree, ensure_ascii=False)
    if not text.isascii():
        try:
            text.encode()
        except UnicodeEncodeError:  # a file name that is not UTF-8, as POSIX allows
            return _dump(tree, ensure_ascii=True)
    return text


def picture_json(document: Document) -> str:
    """Write a document as the text that a picture carries, which goes to strangers.

    It has a mesh's name and no folder, so that nobody reads there how somebody's home is called;
    the mesh is looked for beside the picture.
    """
    scene = os.path.basename(document.scene) if is_mesh(document.scene) else document.scene
    return to_json(replace(document, scene=scene, mesh=os.path.basename(document.mesh)))


def _dump(tree: Tree, ensure_ascii: bool) -> str:
    dump = partial(json.dumps, ensure_ascii=ensure_ascii, allow_nan=False)
    return "{\n" + ",\n".join(f"  {dump(k)}: {dump(v)}" for k, v in tree.items()) + "\n}\n"


def _tree(document: Document) -> Tree:
    projection, extra = document.projection, document.extra
    camera, lens, placement = projection.camera, projection.lens, projection.placement
    width, height = projection.image_size
    tree: Tree = {
        "format": FORMAT,
        "version": VERSION,
        "scene": document.scene,
        **({"mesh": document.mesh} if document.mesh else {}),
        **({"settings": _settings_tree(document)} if document.settings else {}),
        **({"object": _object_tree(placement)} if placement != NOT_MOVED else {}),
        "camera": _camera_tree(camera),
        "lens": _lens_tree(lens),
        "depth": projection.depth,
        "image": {"width": width, "height": height},
    }
    if document.quality.chosen:
        tree["quality"] = {
            key: _plain(value) if isinstance(value, float) else value
            for key, value in document.quality.chosen.items()
        }
    view = view_tree(document.view)
    if "probes" in view:
        view["probes"] = [part and [*map(_plain, part)] for part in view["probes"]]
    if document.view.panes:
        labels = extra.get("view", {}).get("panes", {})
        view["panes"] = {
            name: _camera_tree(camera) | labels.get(name, {})
            for name, camera in document.view.panes.items()
        }
    if document.view.compare:
        pictures = document.view.compare
        view["compare"] = [_picture_tree(picture, document.scene) for picture in pictures]
    if view:
        tree["view"] = view
    for section in _SECTIONS:
        unknown = dict(extra.get(section, {}))
        if section == "view":
            unknown.pop("panes", None)
        if section == "lens" and lens.former is not lens:
            tree["lens"]["former"] |= unknown.pop("former", {})
        if section in tree:
            tree[section] |= unknown
    return tree | {key: value for key, value in extra.items() if key not in tree}


def _lens_tree(lens: Lens) -> Tree:
    values = {field.name: getattr(lens, field.name) for field in fields(lens)}
    return {"kind": lens.kind} | {
        key: _lens_value(value) for key, value in values.items() if value is not None
    }


def _lens_value(value: Any) -> Any:
    """A number, a word, a typed matrix or the lens that it was, as JSON has it."""
    if isinstance(value, Lens):
        return _lens_tree(value)
    if isinstance(value, tuple):
        return [[_plain(part) for part in row] for row in value]
    return value if isinstance(value, str) else _plain(value)


def _settings_tree(document: Document) -> Tree:
    tree: Tree = {}
    for name, value in document.settings.items():
        if isinstance(value, tuple):
            tree[name] = [_plain(part) for part in value]
        else:
            tree[name] = value if isinstance(value, (bool, str)) else _plain(value)
    return tree


def _camera_tree(camera: Camera) -> Tree:
    return {key: [_plain(part) for part in getattr(camera, key)] for key in _CAMERA}


def _object_tree(placement: ObjectTransform) -> Tree:
    tree = {
        key: [_plain(part) for part in getattr(placement, key)]
        for key in ("translate", "rotate_deg", "scale")
    }
    return tree if placement.order == NOT_MOVED.order else {**tree, "order": placement.order}


def _mesh_from(path: str, folder: Path) -> str:
    """Name a mesh as seen from a folder, if it is below it or at most two levels beside it."""
    if not is_mesh(path):  # a built-in scene
        return path
    # The mesh's own name may be a link to a far store of data, and that is how it is wanted.
    place, name = os.path.split(os.path.abspath(path))
    mesh = os.path.join(os.path.realpath(place), name)
    with contextlib.suppress(ValueError):  # on another drive of Windows
        relative = os.path.relpath(mesh, os.path.realpath(folder))
        if relative.split(os.sep)[:3] != [os.pardir] * 3:
            mesh = relative
    return mesh.replace(os.sep, "/")


# --------------------------------------------------------------------------- the --set language


def set_values(document: Document, assignments: Iterable[str]) -> Document:
    """Set values by their paths in the document, all at once.

    Parameters
    ----------
    document : Document
    assignments : iterable of str
        ``lens.far=inf``, ``camera.eye=3,2,4``, ``depth=reversed``, ``scene=cube``,
        ``settings.distance=2``, ``view.stage=pyramid``; a matrix as its 16 cells, row after row,
        probes as x, y, z of one point after the other, layers that are hidden by their names with
        commas. Pictures to compare with are ``view.compare=lens.near=2;lens.far=9|lens.near=3``, or
        the name of what the scene has ready-made, with the values that the document's own picture
        has in it. Only the outcome of
        all of them has to be valid, so that their order does not matter; of two for the same
        path the last holds. Another scene comes first and has its default settings; then
        ``lens.kind``, which keeps the picture alike, or with numbers of its window has these as
        they are typed: ``lens.keep`` is ``stretch`` then, unless it is set too; then settings,
        which the camera and the lens may follow, but not to another kind than the one that was
        asked for. A step of the camera's frame opens its panel, unless ``view.panel`` is set too.

    Raises
    ------
    Refusal
        For an unknown path (naming the nearest known one), a text that is no value, or an
        outcome that is not valid.
    """
    texts: dict[str, str] = {}
    for assignment in assignments:
        path, equals, text = (part.strip() for part in assignment.partition("="))
        if not equals or not path:
            written = assignment.strip()
            raise Refusal.in_document(NO_EQUALS, field=shown_name(written) or repr(written))
        texts[path] = text
    scene = texts.pop("scene", document.scene)
    if scene != document.scene:
        still = replace(document.projection, placement=NOT_MOVED)
        document = replace(document, scene=scene, projection=still, settings={}, mesh="")
    if "view.frame_step" in texts:
        texts.setdefault("view.panel", "frame")
    kind = texts.pop("lens.kind", "")
    if kind and any(f"lens.{side}" in texts for side in ("left", "right", "bottom", "top")):
        texts.setdefault("lens.keep", "stretch")
    document = _with_lens(document, kind)
    known = _known(document.scene, document.projection.lens.kind)
    paths = [path for path in known[""] if path not in (*known, "format", "version")]
    paths += [f"{section}.{key}" for section in known if section for key in known[section]]
    paths = [path for path in paths if path not in ("lens.former", "view.panes", "view.pinned")]
    for path in texts:
        if path not in paths:
            raise _unknown_path(path, paths)
    document = _with_lens(_set_settings(document, texts), kind)
    beside, dividers = texts.pop("view.compare", None), texts.pop("view.dividers", None)
    tree = _tree(document)
    for path, text in texts.items():
        section, _, key = path.rpartition(".")
        if section != "settings":
            (tree.setdefault(section, {}) if section else tree)[key] = _read_text(path, text)
    try:
        return _beside(_document(tree), beside, dividers)
    except Refusal as error:
        side, bound = OTHER_SIDE.get(error.bound, ("", error.bound))
        if f"lens.{side}" not in texts or error.field in texts:
            raise
        # What was set is the other of the two.
        limit, value = format_value(error.value), tree["lens"][side]
        raise Refusal.in_document(bound, limit, field=f"lens.{side}", value=value) from error


def _beside(document: Document, pictures: str | None, dividers: str | None) -> Document:
    """Compare with the pictures that a text names, or as those there are, divided so."""
    if pictures is not None and pictures and "=" not in pictures:
        document = document.compared(pictures)
    elif pictures is not None:
        with _paths("view.compare"):
            others = [
                Picture(changes=tuple(change.strip() for change in part.split(";")))
                for part in (pictures.split("|") if pictures else ())
            ]
        for other in others:
            document.pictured(other)
        compare = (*others, Picture(live=True)) if others else ()
        with _paths("view"):
            document = replace(document, view=replace(document.view, compare=compare, dividers=()))
    if dividers is not None:
        places = [_number(part.strip()) for part in dividers.split(",")] if dividers else []
        numbers = tuple(part for part in places if part is not None)
        with _paths("view"):
            if len(numbers) < len(places):
                raise Refusal("dividers", dividers, SOME_DIVIDERS)
            document = replace(document, view=replace(document.view, dividers=numbers))
    return document


def _with_lens(document: Document, kind: str) -> Document:
    """With a lens of that kind; an empty one changes nothing."""
    if kind in ("", document.projection.lens.kind):
        return document
    with _paths():
        return replace(document, projection=document.projection.with_lens(kind))


def _set_settings(document: Document, texts: Mapping[str, str]) -> Document:
    """Set those of the scene's own settings that are among the texts."""
    values = {
        setting.name: _read_setting(setting, texts[setting.path])
        for setting in _settings_of(document.scene)
        if setting.path in texts
    }
    with _paths():
        return document.with_settings(values)


def _read_setting(setting: Setting, text: str) -> Any:
    if isinstance(setting.default, bool):
        return {"true": True, "false": False}.get(text, text)
    if isinstance(setting.default, str):
        return text
    if isinstance(setting.default, tuple):
        return _read_vector(setting.path, text)
    number = _number(text)
    if number is None:
        raise Refusal.in_document(FINITE_NUMBER, field=setting.path, value=text)
    return number


def _read_vector(path: str, text: str) -> list[float]:
    vector = [_number(part.strip()) for part in text.split(",")]
    numbers = [part for part in vector if part is not None]
    if len(vector) != 3 or len(numbers) != 3:
        raise Refusal.in_document(THREE_NUMBERS, field=path, value=text)
    return numbers


def _read_text(path: str, text: str) -> Any:
    if path == "view.layers":
        return [name.strip() for name in text.split(",") if name.strip()]
    if path == "view.probes":
        numbers = [_number(part.strip()) for part in text.split(",")] if text else []
        if None in numbers or len(numbers) % 3:
            raise Refusal.in_document(POINTS, field=path, value=text)
        return [numbers[i : i + 3] for i in range(0, len(numbers), 3)]
    if path == "view.stage" and _number(text) is None:
        return text
    if path in _TEXTS or (path == "lens.far" and _number(text) is None):  # inf, or for the lens
        return text
    if path.startswith(("camera.", "object.")):
        return _read_vector(path, text)
    if path in _MATRICES:
        cells = [_number(part.strip()) for part in text.split(",")]
        if len(cells) != 16 or None in cells:
            raise Refusal.in_document(FOUR_BY_FOUR, field=path, value=text)
        return [cells[i : i + 4] for i in range(0, 16, 4)]
    number = _number(text)
    if number is None:
        whole = path.startswith("image.")
        bound = (WHOLE_PIXELS, LARGEST_IMAGE_PX) if whole else (FINITE_NUMBER,)
        raise Refusal.in_document(*bound, field=path, value=text)
    return number


def _unknown_path(path: str, paths: list[str]) -> Refusal:
    shown = shown_name(path[:_LONGEST_SHOWN])
    section, _, key = path.rpartition(".")
    others = [kind for kind in kinds() if key in lens_fields(kind)]
    if section in ("lens", "") and others and f"lens.{key}" not in paths:
        return Refusal.in_document(OTHER_LENS, ", ".join(others), field=shown)
    if section == "settings" and not any(known.startswith("settings.") for known in paths):
        scenes = [name for name in PHENOMENA if key in _known(name, None)["settings"]]
        if scenes:
            return Refusal.in_document(OTHER_SCENE, ", ".join(scenes), field=shown)

    def likeness(known: str) -> float:
        whole = difflib.SequenceMatcher(None, shown, known).ratio()
        last = difflib.SequenceMatcher(
            None, shown.rpartition(".")[2], known.rpartition(".")[2]
        ).ratio()
        of_part, _, named = known.rpartition(".")
        begun = of_part in (section, "") and named.startswith(shown.rpartition(".")[2])
        return max(whole, last) + whole / 100.0 + begun

    return Refusal.in_document(UNKNOWN, max(paths, key=likeness), field=shown)


# --------------------------------------------------------------------------- PNG pictures

_PNG = b"\x89PNG\r\n\x1a\n"
_KEYWORD = FORMAT.encode() + b"\0"


def _chunks(png: bytes) -> Iterator[tuple[bytes, int, int]]:
    """Kind, begin and end of each chunk of a PNG picture, its length and checksum included.

    Raises
    ------
    Refusal
        If the picture is not whole.
    """
    begin, kind = len(_PNG), b""
    if not png.startswith(b"IHDR", begin + 4) or not png.startswith(_PNG):
        raise Refusal.in_document(BROKEN_PICTURE)
    view = memoryview(png)
    while kind != b"IEND":
        if begin + 12 > len(png):
            raise Refusal.in_document(BROKEN_PICTURE)
        length, kind = struct.unpack_from(">I4s", png, begin)
        end = begin + 12 + length
        if end > len(png) or zlib.crc32(view[begin + 4 : end - 4]) != _crc(png, end):
            raise Refusal.in_document(BROKEN_PICTURE)
        yield kind, begin, end
        begin = end


def _crc(png: bytes, end: int) -> int:
    crc: int = struct.unpack_from(">I", png, end - 4)[0]
    return crc


def _is_ours(png: bytes, kind: bytes, begin: int) -> bool:
    return kind == b"iTXt" and png.startswith(_KEYWORD, begin + 8)


def embed(png: bytes, text: str) -> bytes:
    """Put a document into a PNG picture, in place of one that may be there.

    Parameters
    ----------
    png : bytes
        The picture, which looks the same afterwards.
    text : str
        The document as `to_json` writes it.

    Raises
    ------
    Refusal
        If `png` is not a whole PNG picture.
    """
    # Not compressed, no language, no translated keyword (PNG specification, 11.3.3.4).
    body = b"iTXt" + _KEYWORD + b"\0\0\0\0" + text.encode()
    ours = struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    parts = [_PNG]
    for kind, begin, end in _chunks(png):
        if not _is_ours(png, kind, begin):
            parts.append(png[begin:end])
        if kind == b"IHDR":
            parts.append(ours)
    return b"".join(parts)


def extract(png: bytes) -> str | None:
    """The text of the document in a PNG picture, or None if there is none.

    Raises
    ------
    Refusal
        If `png` is not a whole PNG picture, or the text in it is broken.
    """
    text = None
    for kind, begin, end in _chunks(png):
        if text is None and _is_ours(png, kind, begin):
            text = _itxt(png[begin + 8 + len(_KEYWORD) : end - 4])
    return text


def _itxt(body: bytes) -> str:
    """The text of an iTXt chunk, after its keyword; other programs may have compressed it."""
    compressed, rest = body[:1], body[2:]
    _language, _, rest = rest.partition(b"\0")
    _translated, _, rest = rest.partition(b"\0")
    try:
        if compressed == b"\1":
            unpacked = zlib.decompressobj()
            rest = unpacked.decompress(rest, LARGEST_DOCUMENT)
            if not unpacked.eof:
                raise Refusal.in_document(BROKEN_PICTURE)
        return rest.decode()
    except (zlib.error, UnicodeDecodeError) as error:
        raise Refusal.in_document(BROKEN_PICTURE) from error


# --------------------------------------------------------------------------- files


def read(path: Path) -> Document:
    """Read a document from its file, or from a PNG picture that carries one.

    Parameters
    ----------
    path : path
        Which of the two it is, is told by its content.

    Raises
    ------
    Refusal
        If there is no such file, it cannot be read, or it is not a valid document.
    """
    with blamed_on(path, UNREADABLE):
        content = _read_bytes(path)
        if content.startswith(_PNG):
            text = extract(content)
            if text is None:
                raise Refusal.in_document(PLAIN_PICTURE)
            # It has its mesh's name alone: beside the link that it may be, or beside itself.
            document = parse(text, os.path.dirname(os.path.abspath(path)))
            if os.path.exists(document.scene if is_mesh(document.scene) else document.mesh):
                return document
            return parse(text, os.path.dirname(os.path.realpath(path)))
        ending = os.path.splitext(path)[1].lower()
        try:
            return parse(_decode(content), os.path.dirname(os.path.realpath(path)))
        except Refusal as error:
            if ending == ".json" or error.bound not in (BROKEN, EMPTY, FOREIGN, NOT_TEXT):
                raise
            if ending == ".png":
                raise Refusal.in_document(BROKEN_PICTURE) from error
            raise Refusal.in_document(NEITHER, ", ".join(MESH_ENDINGS)) from error


def holds_document(path: Path) -> bool:
    """Tell whether a file that was read can be saved in: it is no mesh, picture or device."""
    if is_mesh(os.fspath(path)) or not os.path.isfile(path):
        return False
    with open_regular(path) as file:
        return file.read(len(_PNG)) != _PNG


@contextlib.contextmanager
def blamed_on(path: Path, bound: Bound) -> Iterator[None]:
    """Name the file in what is raised, and turn the system's complaints into a sentence."""
    file = os.fspath(path)
    if "\0" in file:
        raise Refusal.in_document(BAD_NAME, file=file)
    try:
        yield
    except Refusal as error:
        error.file = file
        raise
    except FileNotFoundError as error:
        if bound == UNREADABLE:
            raise Refusal.in_document(NO_FILE, file=file) from error
        raise Refusal.in_document(bound, error.strerror or error, file=file) from error
    except OSError as error:
        raise Refusal.in_document(bound, error.strerror or error, file=file) from error
    except UnicodeEncodeError as error:  # a half of a surrogate pair
        raise Refusal.in_document(BAD_NAME, file=file) from error


def _decode(content: bytes) -> str:
    try:
        return content.decode()
    except UnicodeDecodeError as error:
        raise Refusal.in_document(NOT_TEXT) from error


def _read_bytes(path: Path) -> bytes:
    if os.path.isdir(path):
        raise Refusal.in_document(FOLDER)
    with open_regular(path) as file:
        content = file.read(len(_PNG))
        limit = LARGEST_PICTURE if content == _PNG else LARGEST_DOCUMENT
        content += file.read(limit - len(content) + 1)
    if len(content) > limit:
        raise Refusal.in_document(TOO_LARGE, limit // 2**20)
    return content


def write(document: Document, path: Path) -> None:
    """Write a document to its file, whole or not at all.

    Parameters
    ----------
    document : Document
    path : path
        A link is followed; the permissions of a file that was there are kept.

    Raises
    ------
    Refusal
        If it cannot be written; the file that was there is as it was.
    """
    with blamed_on(path, UNWRITABLE):
        folder = os.path.dirname(os.path.realpath(path))
    write_bytes_atomically(path, to_json(document, folder).encode())


def write_bytes_atomically(path: Path, content: bytes) -> None:
    """Write a file whole or not at all, also if the power fails meanwhile.

    Parameters
    ----------
    path : path
        A link is followed; the permissions of a file that was there are kept.
    content : bytes

    Raises
    ------
    Refusal
        If it cannot be written; the file that was there is as it was.

    Notes
    -----
    The content goes to a new file in the same folder, which takes the old one's name when it is
    safely on the disk. What a killed program left behind of this is removed by the next one.
    """
    with blamed_on(path, UNWRITABLE):
        target = os.path.realpath(path)
        _replace(target, content, _mode_to_keep(target))


def _mode_to_keep(target: str) -> int | None:
    """The old file's mode, or None if there is none."""
    try:
        mode = os.stat(target).st_mode
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(mode):
        raise Refusal.in_document(FOLDER)
    if not stat.S_ISREG(mode):  # it would wait for a reader, or overwrite a disk
        raise Refusal.in_document(NOT_REGULAR)
    if not os.access(target, os.W_OK):  # replacing it would get round its owner's wish
        raise Refusal.in_document(WRITE_PROTECTED)
    return mode


_UNFINISHED = re.compile(r"\.frustum-lab-[0-9a-f]{8}\.tmp")


def _replace(target: str, content: bytes, mode: int | None) -> None:
    folder = os.path.dirname(target)
    _remove_unfinished(folder)
    unfinished = _create_unfinished(folder, 0o666 if mode is None else 0o600)
    try:
        with unfinished:
            if mode is not None:
                os.chmod(unfinished.name, stat.S_IMODE(mode))
            unfinished.write(content)
            unfinished.flush()
            os.fsync(unfinished.fileno())
            if sys.platform != "win32":  # while the lock is held
                os.replace(unfinished.name, target)
        if sys.platform == "win32":  # which renames closed files only
            os.replace(unfinished.name, target)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(unfinished.name)
        raise
    _sync_folder(folder)


def _create_unfinished(folder: str, mode: int) -> BinaryIO:
    while True:
        path = os.path.join(folder, f".frustum-lab-{secrets.token_hex(4)}.tmp")
        file = open(path, "xb", opener=partial(os.open, mode=mode))  # noqa: SIM115 the caller closes it
        if not _lock(file.fileno(), wait=True) or os.path.exists(path):
            return file
        file.close()  # another program took it for a dead one's before it was locked


def _lock(descriptor: int, wait: bool) -> bool:
    """Lock an open file for as long as it is open; False where that cannot be done."""
    if sys.platform != "win32":
        with contextlib.suppress(OSError):  # held by another, or a file system without locks
            fcntl.flock(descriptor, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
            return True
    return False


def _remove_unfinished(folder: str) -> None:
    """Remove what killed programs left behind: files of ours that nobody holds locked."""
    with contextlib.suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if not _UNFINISHED.fullmatch(entry.name):
                continue
            with contextlib.suppress(OSError):
                if sys.platform == "win32":
                    # There nothing is locked once it is closed, for a moment before its renaming.
                    if time.time() - entry.stat().st_mtime > 60.0:
                        os.unlink(entry.path)
                else:
                    with open(entry.path, "rb") as file:
                        if _lock(file.fileno(), wait=False):
                            os.unlink(entry.path)


def _sync_folder(folder: str) -> None:
    """Put the new name on the disk, too, where a folder can be opened for that."""
    if sys.platform != "win32":
        with contextlib.suppress(OSError):
            descriptor = os.open(folder, os.O_RDONLY)
            try:
                os.fsync(descriptor)
            finally:
                os.close(descriptor)
