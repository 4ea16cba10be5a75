"""The document: a scene with its settings, seen through a projection.

A document is a frozen value. `app.document.codec` turns it into text and back, `app.document.files`
keeps it in files, and `app.document.settings` sets its values by their paths. All follow one table
of fields: the section of each, how a person types it, and whether a file must have it. The classes
that hold the values check their bounds, once for the whole program.
"""

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias, get_type_hints

from app.document.compare import Held
from app.document.view import View
from app.model.chain import FiveTiles, Tile
from app.model.lenses import LENSES, FreeMatrix, kinds
from app.model.limits import Cells, Frozen, Vector, check_type
from app.model.matrix_text import read_matrix
from app.model.numerals import number, numbers
from app.model.parameter import Settings
from app.model.parameters import FOCAL_LENGTH, FOV_X, HEIGHT, WIDTH
from app.model.projection import LARGEST_IMAGE_PX, Camera, Intrinsics, Orbit, Projection
from app.model.refusal import REFUSALS, Refusal
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.phenomena import PHENOMENA
from app.scenes.shapes import LETTER_F

MESH_ENDINGS = (".obj", ".stl", ".ply", ".gltf", ".glb")
"""A scene name with one of these endings is a mesh file; every other scene is built in."""


def is_mesh(scene: str) -> bool:
    """Whether a scene's name is the path of a mesh file."""
    return scene.lower().endswith(MESH_ENDINGS)


@dataclass(frozen=True)
class Document(Frozen):
    """The content of a document file.

    Raises a `Refusal` if a value is not valid, the scene cannot have this mesh or these settings,
    or the projection moves objects that are fixed.

    - `scene`: name of a built-in scene, or path of a mesh file.
    - `extra`: keys that this program does not know, at their places in the file:
      ``{"author": "...", "lens": {"label": "..."}}``. Not to be changed in place.
    - `view`: how the document is looked at. It is saved, but not compared.
    - `settings`: the settings of the scene's phenomenon; missing ones get their defaults. Complete
      and read-only after construction, and empty for every other scene.
    - `mesh`: path of the user's mesh that replaces a phenomenon's own objects; empty for none.
    - `quality`: the precision and detail of the drawing.
    """

    scene: str = "letter-f"
    projection: Projection = LETTER_F
    extra: "Tree" = field(default_factory=dict)
    view: View = field(default_factory=View, compare=False)
    settings: Settings = field(default_factory=dict)
    mesh: str = ""
    quality: Quality = AUTOMATIC

    def __post_init__(self) -> None:
        if not isinstance(self.scene, str) or not self.scene or "\0" in self.scene:
            raise Refusal.in_document(REFUSALS["scene-name"], field="scene", value=self.scene)
        for name, kind in (("projection", Projection), ("view", View), ("quality", Quality)):
            check_type(name, getattr(self, name), kind)
        phenomenon = PHENOMENA.get(self.scene)
        settings = phenomenon.checked(self.settings) if phenomenon else MappingProxyType({})
        object.__setattr__(self, "settings", settings)
        if phenomenon is not None and not self.projection.placement.is_identity:
            raise Refusal.in_document(REFUSALS["fixed"], self.scene, field="object")
        if self.mesh != "":
            if not isinstance(self.mesh, str) or "\0" in self.mesh or not is_mesh(self.mesh):
                bound = REFUSALS["mesh-name"], ", ".join(MESH_ENDINGS)
                raise Refusal.in_document(*bound, field="mesh", value=self.mesh)
            if phenomenon is None or not phenomenon.own_mesh:
                raise Refusal.in_document(
                    REFUSALS["no-mesh-here"], self.scene, field="mesh", value=self.mesh
                )
        if self.extra:  # a key unknown to the previous lens may be a field of the current one
            left = unknown(self.extra, self.scene, self.projection.lens.kind, self.view.panes)
            object.__setattr__(self, "extra", left)

    def __hash__(self) -> int:
        return hash(
            (self.scene, self.projection, tuple(self.settings.items()), self.mesh, self.quality)
        )

    def with_settings(self, settings: Mapping[str, Any]) -> "Document":
        """Return the document with other settings, and the projection that they require.

        Raises a `Refusal` if the scene cannot have them, or no projection fits them.
        """
        phenomenon = PHENOMENA.get(self.scene)
        if phenomenon is None:
            return self
        projection, after = phenomenon.changed(self.projection, self.settings, settings)
        return replace(self, projection=projection, settings=after)

    @property
    def state(self) -> Held:
        """The part of the document that can be held and compared with later states."""
        return Held(self.projection, self.settings)


Tree: TypeAlias = dict[str, Any]

_UNIT = re.compile(r"(?<=[0-9.])\s{0,2}([°×]|1/w|[a-z]{1,5})(?=[\s,)\]]|$)")

SECTIONS = ("settings", "object", "camera", "lens", "image", "quality", "view")


class FieldKind(NamedTuple):
    """How a value is typed after ``--set``."""

    read: Callable[[str], Any]
    """Converts the text to the JSON value; returns None or raises a `Refusal` if it cannot."""
    bound: tuple[Any, ...] = ()  # the bound that an invalid text violates, and the bound's limits


class Field(NamedTuple):
    """One value of a document."""

    section: str
    name: str  # the field's section and name; the top level is section ``""``
    kind: FieldKind | None  # None if ``--set`` cannot set the field
    required: bool = False  # whether its section must have it
    unit: str = ""  # may be typed after each of its numbers, as the window shows it
    whole: bool = False

    @property
    def path(self) -> str:
        return f"{self.section}.{self.name}" if self.section else self.name

    def read(self, text: str) -> Any:
        """Convert a text to the field's JSON value; return None if that is impossible."""
        assert self.kind is not None
        if self.unit and self.kind in (NUMBER, VECTOR, PIXELS, NUMBER_OR_WORD):
            text = _UNIT.sub(lambda match: "" if match[1] == self.unit else match[0], text)
        return self.kind.read(text)


# --------------------------------------------------------------------------- how values are typed


def _rows(text: str, width: int, least: int, most: float) -> list[list[float]] | None:
    """Parse rows of equal width; return None unless the numbers fill an allowed number of rows."""
    values = numbers(text)
    if values is None or len(values) % width or not least <= len(values) // width <= most:
        return None
    return [values[i : i + width] for i in range(0, len(values), width)]


def _looks(text: str) -> dict[str, Any] | None:
    """Parse where panes look from: ``ndc: 1.3,0.2,0.3``, the panes separated by ``|``."""
    looks = {}
    for part in text.split("|") if text else ():
        pane, _, places = (word.strip() for word in part.partition(":"))
        rows = _rows(places, 3, 1, 2)
        if pane not in ("world", "ndc") or rows is None:
            return None
        eye, target = (*rows, [0.0, 0.0, 0.0])[:2]
        looks[pane] = {"eye": eye, "target": target, "up": [0.0, 1.0, 0.0]}
    return looks


def _matrix(text: str) -> list[list[float]] | None:
    """Read a 4x4 matrix, or a 3x4 one to which the row 0 0 0 1 is added; None for 3x3."""
    rows = read_matrix(text)
    if len(rows[0]) == 3:
        rows = [list(column) for column in zip(*rows, strict=True)]
    if len(rows[0]) == 3:
        return None
    return rows if len(rows) == 4 else [*rows, [0.0, 0.0, 0.0, 1.0]]


def _cells(text: str, height: int, width: int) -> list[list[float]] | None:
    """Read a matrix of this size; None for another one."""
    rows = read_matrix(text, sizes=[height * width])
    return rows if (len(rows), len(rows[0])) == (height, width) else None


def read_tiles(texts: Iterable[Any]) -> tuple[Tile, ...]:
    """Read the tiles of an object's chain; refuse the first one that is not a tile by its place."""
    tiles = []
    for place, text in enumerate(texts):
        try:
            if not isinstance(text, str):
                raise Refusal("chain", text, REFUSALS["a-chain"])
            tiles.append(Tile.read(text))
        except Refusal as error:
            path = f"object.chain[{place}]"
            raise Refusal.in_document(error.bound, *error.limits, field=path, value=text) from None
    return tuple(tiles)


def _chain(text: str) -> list[str]:
    return [tile.text for tile in read_tiles(map(str.strip, text.split(";")) if text else ())]


def _number_or_word(text: str) -> float | str:
    value = number(text)
    word = "inf" if text.lower() in ("∞", "infinity") else text
    return word if value is None else value


TEXT = FieldKind(str)
NUMBER = FieldKind(number, (REFUSALS["finite-number"],))
NUMBER_OR_WORD = FieldKind(_number_or_word)
PIXELS = FieldKind(number, (REFUSALS["whole-pixels"], LARGEST_IMAGE_PX))
YES_OR_NO = {"true": True, "yes": True, "false": False, "no": False}
SWITCH = FieldKind(lambda text: YES_OR_NO.get(text, text))
VECTOR = FieldKind(
    lambda text: next(iter(_rows(text, 3, 1, 1) or ()), None), (REFUSALS["three-numbers"],)
)
MATRIX = FieldKind(_matrix, (REFUSALS["four-by-four"],))
PROBES = FieldKind(lambda text: _rows(text, 3, 0, math.inf), (REFUSALS["points"],))
PANES = FieldKind(_looks, (REFUSALS["looks"],))
NAMES = FieldKind(lambda text: [name.strip() for name in text.split(",") if name.strip()])


# --------------------------------------------------------------------------- the table

_BY_TYPE: dict[Any, FieldKind] = {float: NUMBER, Vector: VECTOR, Cells: MATRIX}
_KINDS = {bool: SWITCH, str: TEXT, tuple: VECTOR}


def _fields(
    section: str, owner: type, required: bool, **kinds: FieldKind | None
) -> tuple[Field, ...]:
    """Return the fields of a section that is a dataclass; texts and options are never required."""
    described, types = [], get_type_hints(owner)
    for each in fields(owner):
        own = types[each.name]
        kind = next((_BY_TYPE[t] for t in _BY_TYPE if own in (t, t | None)), TEXT)
        needed = required and own in _BY_TYPE
        unit = "°" if each.name.endswith("_deg") else "units"
        described.append(Field(section, each.name, kinds.get(each.name, kind), needed, unit))
    return tuple(described)


TOP = tuple(Field("", name, TEXT) for name in ("scene", "mesh", "depth"))
FIVE = _fields("object", FiveTiles, required=False)
"""The object's fields in documents before version 3; they replace its chain."""
OBJECT = (Field("object", "chain", FieldKind(_chain, (REFUSALS["a-chain"],))), *FIVE)
CAMERA = _fields("camera", Camera, required=True)
IMAGE = tuple(Field("image", side.name, PIXELS, True, "px", True) for side in (WIDTH, HEIGHT))
QUALITY = _fields("quality", Quality, required=False)
VIEW = _fields(
    "view", View, required=False,
    stage=NUMBER_OR_WORD, layers=NAMES, names=NAMES, slide=NAMES, controls=NAMES, probes=PROBES,
    pinned=None, panes=PANES,
)  # fmt: skip


def lens_fields(kind: object) -> tuple[Field, ...]:
    """Return the fields of a kind of lens, without the kind itself; none for an unknown kind."""
    if not isinstance(kind, str) or kind not in kinds():
        return ()
    owner = LENSES.get(kind, FreeMatrix)
    return _fields("lens", owner, required=True, far=NUMBER_OR_WORD, former=None)


def fields_of(scene: str, kind: object) -> tuple[Field, ...]:
    settings = [
        Field("settings", each.name, _KINDS.get(type(each.default), NUMBER), False, each.unit,
              each.whole)
        for each in (PHENOMENA[scene].settings if scene in PHENOMENA else ())
    ]  # fmt: skip
    lens = Field("lens", "kind", TEXT, required=True), *lens_fields(kind)
    return (*TOP, *settings, *OBJECT, *CAMERA, *lens, *IMAGE, *QUALITY, *VIEW)


CAMERA_P = Field(
    "camera", "P", FieldKind(lambda text: _cells(text, 3, 4), (REFUSALS["three-by-four"],))
)
CALIBRATED = (
    Field("lens", "K", FieldKind(lambda text: _cells(text, 3, 3), (REFUSALS["three-by-three"],))),
    *(
        Field("lens", name, NUMBER)
        for name in (*Intrinsics._fields, "focal_mm", "sensor_width_mm", "sensor_height_mm")
    ),
)
ANGLES = tuple(Field("lens", each.name, NUMBER) for each in (FOV_X, FOCAL_LENGTH))
"""Other measures of a lens, which ``--set`` knows: they are computed, and no document has them."""


def controls_of(scene: str) -> tuple[str, ...]:
    """Return the paths of the values for which there are controls, of any lens."""
    paths = {
        field.path: None
        for kind in kinds()
        for field in fields_of(scene, kind)
        if field.section in ("settings", "object", "camera", "lens", "image")
    }
    computed = *(f"camera.{name}" for name in Orbit._fields), *(field.path for field in ANGLES)
    return (*paths, *computed, "depth")


def model_paths() -> dict[str, str]:
    """Return the document paths of those model fields whose path differs from their name."""
    return {
        field.name: field.path
        for kind in kinds()
        for field in fields_of("", kind)
        if field.section in ("camera", "object", "lens", "image")
    }


def unknown(tree: Tree, scene: str, kind: object, panes: Iterable[str]) -> Tree:
    """Return the part of a document's tree whose keys this program does not know.

    `kind` is that of the lens. The document has the cameras of `panes`; unknown keys of the other
    panes are dropped with their cameras.
    """
    known: Tree = {"format": None, "version": None, **{section: {} for section in SECTIONS}}
    for each in fields_of(scene, kind):
        (known[each.section] if each.section else known)[each.name] = None
    former = tree.get("lens", {}).get("former")
    if "former" in known["lens"] and isinstance(former, dict):
        names = ["kind", *(field.name for field in lens_fields(former.get("kind")))]
        known["lens"]["former"] = dict.fromkeys(names)
    camera = {field.name: None for field in CAMERA}
    labelled = tree.get("view", {}).get("panes", {})
    known["view"]["panes"] = dict.fromkeys(labelled) | dict.fromkeys(panes, camera)
    return _without(tree, known)


def _without(tree: Tree, known: Tree) -> Tree:
    """Return a tree without the known keys; those of a nested tree form a nested tree too."""
    left = {key: value for key, value in tree.items() if key not in known}
    for key, inner in known.items():
        if inner is not None and isinstance(part := tree.get(key), dict):
            inside = _without(part, inner)
            left |= {key: inside} if inside else {}
    return left
