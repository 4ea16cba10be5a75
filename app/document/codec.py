"""Documents as JSON text: `parse` reads one, `to_json` writes one.

Text from outside is checked here, and every fault is refused in one sentence. The table
`app.document.document` says which fields there are; the classes that hold the values check their
bounds.
"""

import contextlib
import json
import math
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from functools import partial
from typing import Any, NamedTuple, TypeAlias

from app.document.compare import MOST_PICTURES, PARTS, ComparedPicture, Held
from app.document.document import (
    CAMERA,
    IMAGE,
    OBJECT,
    QUALITY,
    VIEW,
    Document,
    Field,
    Tree,
    is_mesh,
    lens_fields,
    model_paths,
    read_tiles,
    unknown,
)
from app.document.view import read_view, view_tree
from app.model.chain import Chain, FiveTiles
from app.model.projection import LENSES, Camera, FreeMatrix, Lens, Projection
from app.model.refusal import REFUSALS, Bound, Refusal, format_value, shown_name
from app.precision.quality import Quality

Path: TypeAlias = str | os.PathLike[str]

FORMAT = "frustum-lab"


def _with_view(tree: Tree) -> Tree:
    """Move the panes' cameras of version 1 under "view", a key that version 1 did not use."""
    strange = {"version 1": tree.pop("view")} if "view" in tree else {}
    panes = {"panes": tree.pop("views")} if "views" in tree else {}
    return tree | ({"view": panes | strange} if panes or strange else {})


MIGRATIONS: tuple[Callable[[Tree], Tree], ...] = (_with_view, lambda tree: tree)
"""Step i turns a document of version i + 1 into one of version i + 2. Version 3 has the object's
chain; the fields of version 2 are read as ``--set`` sets them."""
VERSION = len(MIGRATIONS) + 1  # version of the documents that are written

MOST_VALUES = 100_000
"""Most values in a document, estimated from its commas and brackets: one takes microseconds."""
SHORTEST = 1e-100  # shortest distance and up vector of a pane's own camera: VTK squares them
DEEPEST = 50  # most levels of brackets in a document, far below what Python's recursion can write
LONGEST_SHOWN = 60  # most characters of a key in a refusal


# --------------------------------------------------------------------------- text to tree


class _Literal(str):
    """A number that no float can hold, as it was typed; messages show it without quotes."""

    def __repr__(self) -> str:
        return str(self)


class _Refused(NamedTuple):
    """Placeholder for an invalid value in a tree, until its path is known."""

    bound: Bound
    key: str = ""
    value: object = ...


def _read_pairs(pairs: list[tuple[str, Any]]) -> Tree | _Refused:
    tree: Tree = {}
    for key, value in pairs:
        if key in tree:
            return _Refused(REFUSALS["twice"], key)
        tree[key] = value
    return tree


def _read_number(make: Callable[[str], float], text: str) -> float | _Refused:
    return make(text) if math.isfinite(float(text)) else _not_finite(text)


def _not_finite(text: str) -> _Refused:
    return _Refused(REFUSALS["finite-number"], "", _Literal(text))


def _check_tree(value: Any, path: str, depth: int) -> None:
    """Refuse invalid values that JSON's grammar allows, naming their paths."""
    if isinstance(value, _Refused):
        path = _join(path, value.key) if value.key else path
        if not path:
            raise Refusal.in_document(REFUSALS["foreign"])
        raise Refusal.in_document(value.bound, field=path, value=value.value)
    if depth > DEEPEST:
        raise Refusal.in_document(REFUSALS["too-deep"], DEEPEST)
    parts = value.items() if isinstance(value, dict) else enumerate(value)
    for key, part in parts:
        if isinstance(part, (dict, list, _Refused)):
            inner = _join(path, key) if isinstance(key, str) else f"{path}[{key}]"
            if (
                key == "far"
                and isinstance(part, _Refused)
                and part.bound == REFUSALS["finite-number"]
            ):
                part = part._replace(bound=_bound_of_far(value.get("kind")))
            _check_tree(part, inner, depth + 1)


def _bound_of_far(kind: object) -> Bound:
    """Return the bound on a lens's far, which only some lenses allow to be infinite."""
    lens = LENSES.get(kind) if isinstance(kind, str) else None
    may_be_infinite = lens is not None and lens.far_may_be_infinite
    return REFUSALS["finite-or-inf"] if may_be_infinite else REFUSALS["finite-number"]


def _join(path: str, key: str) -> str:
    shown = shown_name(key[:LONGEST_SHOWN])
    return f"{path}.{shown}" if path else shown


def tree_of(text: str, most: int = MOST_VALUES) -> Any:
    """Return what a JSON text holds, with finite numbers and no name twice, or a `Refusal`."""
    text = text.removeprefix("\ufeff")  # the byte order mark that some editors write
    if not text.strip():
        raise Refusal.in_document(REFUSALS["empty"])
    if sum(map(text.count, ",[{")) >= most:  # before JSON's parser takes its time
        raise Refusal.in_document(REFUSALS["codec-too-many"], most)
    try:
        tree = json.loads(
            text,
            object_pairs_hook=_read_pairs,
            parse_float=partial(_read_number, float),
            parse_int=partial(_read_number, int),
            parse_constant=_not_finite,
        )
    except json.JSONDecodeError as error:
        raise Refusal.in_document(REFUSALS["broken"], error.lineno, error.colno) from error
    except RecursionError as error:
        raise Refusal.in_document(REFUSALS["too-deep"], DEEPEST) from error
    if isinstance(tree, (dict, list, _Refused)):
        _check_tree(tree, "", 0)
    return tree


def parse(text: str, folder: Path | None = None) -> Document:
    """Read a document from its text, JSON as `to_json` writes it; a `Refusal` for anything else.

    Relative mesh paths start at the `folder` of the text.
    """
    tree = tree_of(text)
    if not isinstance(tree, dict) or tree.get("format") != FORMAT:
        raise Refusal.in_document(REFUSALS["foreign"])
    version = _whole(_required(tree, "version"))
    if isinstance(version, bool) or not isinstance(version, int) or version < 1:
        raise Refusal.in_document(REFUSALS["version-number"], field="version", value=version)
    if version > VERSION:
        raise Refusal.in_document(REFUSALS["newer"], format_value(version), VERSION)
    for step in MIGRATIONS[version - 1 :]:
        tree = step(tree)
    try:
        return from_tree(tree, folder)
    except Refusal as error:
        if version == 1 and error.field.startswith("view.panes"):  # in the order of the file
            error.field = error.field.replace("view.panes", "views", 1)
        raise


# --------------------------------------------------------------------------- tree to document


def _whole(number: Any) -> Any:
    """Convert 800.0 to 800: JSON has only one kind of number."""
    return int(number) if isinstance(number, float) and number.is_integer() else number


def _required(tree: Tree, key: str, section: str = "") -> Any:
    if key not in tree:
        raise Refusal.in_document(REFUSALS["missing"], field=f"{section}.{key}" if section else key)
    return tree[key]


def _mapping(value: Any, path: str) -> Tree:
    if not isinstance(value, dict):
        raise Refusal.in_document(REFUSALS["mapping"], field=path, value=value)
    return value


def _values(section: Any, known: Iterable[Field], path: str) -> Tree:
    """Return the known fields of a section; refuse a section that lacks a required one."""
    values, known = _mapping(section, path), tuple(known)
    for each in known:
        if each.required:
            _required(values, each.name, path)
    return {each.name: values[each.name] for each in known if each.name in values}


@contextlib.contextmanager
def document_paths(section: str = "") -> Iterator[None]:
    """Add document paths to the model's refusals, within `section` if it is given."""
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


@document_paths()
def from_tree(tree: Tree, folder: Path | None = None) -> Document:
    """Make a document of the current version from its JSON tree, as `parse` does."""
    scene = _required(tree, "scene")
    if not isinstance(scene, str):
        raise Refusal.in_document(REFUSALS["scene-name"], field="scene", value=scene)
    mesh = tree.get("mesh", "")
    if folder is not None:
        if is_mesh(scene):
            scene = os.path.normpath(os.path.join(os.path.realpath(folder), scene))
        if isinstance(mesh, str) and mesh:
            mesh = os.path.normpath(os.path.join(os.path.realpath(folder), mesh))
    settings = _mapping(tree.get("settings", {}), "settings")
    camera = Camera(**_values(_required(tree, "camera"), CAMERA, "camera"))
    lens = _lens(_required(tree, "lens"), "lens")
    size = _values(_required(tree, "image"), IMAGE, "image")
    depth = _required(tree, "depth")
    placement = _placement(_values(tree.get("object", {}), OBJECT, "object"))
    width, height = map(_whole, size.values())
    projection = Projection(camera, lens, (width, height), depth, placement)
    values = _values(tree.get("view", {}), VIEW, "view")
    panes = _mapping(values.get("panes", {}), "view.panes")
    cameras = {name: _pane_camera(panes[name], _join("view.panes", name)) for name in panes}
    pictures = _pictures(values.get("compare", []), scene, mesh)
    with document_paths("view"):
        view = read_view(values, cameras, pictures)
    quality = Quality(**_values(tree.get("quality", {}), QUALITY, "quality"))
    extra = unknown(tree, scene, lens.kind, cameras)
    return Document(scene, projection, extra, view, settings, mesh, quality)


def _placement(values: Tree) -> Chain:
    """Read the object's chain, or its five tiles as documents before version 3 have them."""
    texts = values.pop("chain", [])
    if values:
        return FiveTiles(**values).chain
    if not isinstance(texts, list):
        raise Refusal.in_document(REFUSALS["a-chain"], field="object.chain", value=texts)
    return Chain(read_tiles(texts))


def _lens(section: Any, path: str) -> Lens:
    """Read a lens. A lens that a free matrix replaced has its own path and is no free matrix."""
    kind = _required(_mapping(section, path), "kind", path)
    owners = LENSES | ({FreeMatrix.kind: FreeMatrix} if path == "lens" else {})
    if not isinstance(kind, str) or kind not in owners:
        raise Refusal.in_document(
            REFUSALS["one-of"], ", ".join(owners), field=f"{path}.kind", value=kind
        )
    values = _values(section, lens_fields(kind), path)
    if "former" in values:
        values["former"] = _lens(values["former"], f"{path}.former")
    if values.get("far") == "inf":
        values["far"] = math.inf
    with document_paths(path):
        try:
            lens: Lens = owners[kind](**values)
            return lens
        except Refusal as error:
            if error.field == "far" and error.bound == REFUSALS["finite-number"]:
                error.bound = _bound_of_far(kind)
            raise


def _pane_camera(section: Any, path: str) -> Camera:
    with document_paths(path):
        camera = Camera(**_values(section, CAMERA, path))
        if camera.distance < SHORTEST:
            raise Refusal("eye", camera.eye, REFUSALS["away-from-target"], SHORTEST)
        if math.hypot(*camera.up) < SHORTEST:
            raise Refusal("up", camera.up, REFUSALS["longer"], SHORTEST)
    return camera


def _pictures(value: Any, scene: str, mesh: Any) -> tuple[ComparedPicture, ...]:
    """Read the compared pictures, as `_picture_tree` writes them."""
    path = "view.compare"
    if not isinstance(value, list) or len(value) > MOST_PICTURES:
        raise Refusal.in_document(REFUSALS["some-pictures"], MOST_PICTURES, field=path, value=value)
    pictures = []
    for place, part in enumerate(value):
        where = f"{path}[{place}]"
        values: Tree = {"name": "", "set": [], "live": False, "held": {}} | _mapping(part, where)
        texts = isinstance(values["set"], list) and all(isinstance(x, str) for x in values["set"])
        for key, fits, bound in (
            ("name", isinstance(values["name"], str), REFUSALS["a-name"]),
            ("set", texts, REFUSALS["some-changes"]),
            ("live", isinstance(values["live"], bool), REFUSALS["yes-or-no"]),
            ("held", isinstance(values["held"], dict), REFUSALS["mapping"]),
        ):
            if not fits:
                raise Refusal.in_document(bound, field=f"{where}.{key}", value=values[key])
        held = _held(part["held"], f"{where}.held", scene, mesh) if "held" in part else None
        with document_paths(where):
            pictures.append(
                ComparedPicture(values["name"], tuple(values["set"]), held, values["live"])
            )
    return tuple(pictures)


def _held(values: Tree, path: str, scene: str, mesh: Any) -> Held:
    """Read a held state, which must belong to the document's own scene."""
    for key, own in (("scene", scene), ("mesh", mesh)):
        if values.get(key, own) != own:
            raise Refusal.in_document(
                REFUSALS["held-elsewhere"], repr(own), field=f"{path}.{key}", value=values[key]
            )
    try:
        return from_tree(
            {key: values[key] for key in PARTS if key in values} | {"scene": scene}
        ).state
    except Refusal as error:  # its path starts at the held state
        error.field = f"{path}.{error.field}" if error.field else path
        raise


# --------------------------------------------------------------------------- document to text


def to_json(document: Document, folder: Path | None = None) -> str:
    """Write a document as text; `parse` gives back exactly the same document.

    A mesh near the `folder` that the text will be in is named from there, so that both can be moved
    together. There is one line for each part::

        "camera": {"eye": [6, 5, 9], "target": [0, 2.2, 0], "up": [0, 1, 0]},

    An infinite far is ``"inf"``. ``settings``, ``mesh``, ``object``, ``quality`` and ``view`` are
    written where they differ from their defaults. Keys that were not known when the document was
    read are written again.
    """
    tree = to_tree(document)
    if folder is not None:
        for key in ("scene", "mesh"):
            if key in tree:
                tree[key] = _mesh_from(tree[key], folder)
    text = _dump(tree, ensure_ascii=False)
    try:
        text.encode()
    except UnicodeEncodeError:  # a file name that is not UTF-8, as POSIX allows
        return _dump(tree, ensure_ascii=True)
    return text


def picture_json(document: Document) -> str:
    """Write a document as the text in a picture that may be given to strangers.

    A mesh is named without its folders, which are private; opening the picture looks for it beside
    the picture.
    """
    scene = os.path.basename(document.scene) if is_mesh(document.scene) else document.scene
    return to_json(replace(document, scene=scene, mesh=os.path.basename(document.mesh)))


def _dump(tree: Tree, ensure_ascii: bool) -> str:
    dump = partial(json.dumps, ensure_ascii=ensure_ascii, allow_nan=False)
    return "{\n" + ",\n".join(f"  {dump(k)}: {dump(v)}" for k, v in tree.items()) + "\n}\n"


def to_tree(document: Document) -> Tree:
    projection, quality = document.projection, document.quality
    width, height = projection.image_size
    tiles = [tile.text for tile in projection.placement.tiles]
    tree: Tree = {
        "format": FORMAT,
        "version": VERSION,
        "scene": document.scene,
        "mesh": document.mesh,
        "settings": _plain(document.settings),
        "object": {"chain": tiles} if tiles else {},
        "camera": _plain(projection.camera),
        "lens": _plain(projection.lens),
        "depth": projection.depth,
        "image": {"width": width, "height": height},
        "quality": _plain(quality.chosen),
        "view": _plain(view_tree(document.view)),
    }
    if document.view.panes:
        tree["view"]["panes"] = _plain(document.view.panes)
    if document.view.compare:
        pictures = document.view.compare
        tree["view"]["compare"] = [_picture_tree(picture, document.scene) for picture in pictures]
    tree = {key: value for key, value in tree.items() if value not in ("", {})}
    _add(tree, document.extra)
    return tree


def _plain(value: Any) -> Any:
    """Convert a value, or a part of a document, to JSON.

    6.0 is written as 6, and infinity, which JSON lacks, as ``"inf"``.
    """
    if is_dataclass(value):
        parts = {each.name: getattr(value, each.name) for each in fields(value)}
        kind = {"kind": value.kind} if isinstance(value, Lens) else {}
        return kind | {key: _plain(part) for key, part in parts.items() if part is not None}
    if isinstance(value, Mapping):
        return {key: _plain(part) for key, part in value.items()}
    if isinstance(value, (tuple, list)):
        return [_plain(part) for part in value]
    if not isinstance(value, float):
        return value
    if value == math.inf:
        return "inf"
    if value.is_integer() and abs(value) < 1e15 and (value or math.copysign(1.0, value) > 0):
        return int(value)
    return value


def _add(tree: Tree, extra: Tree) -> None:
    """Put unknown keys back where they stood."""
    for key, value in extra.items():
        if key not in tree:
            tree[key] = dict(value) if isinstance(value, dict) else value
        elif isinstance(tree[key], dict):
            _add(tree[key], value)


def _picture_tree(picture: ComparedPicture, scene: str) -> Tree:
    tree: Tree = {"name": picture.name, "set": list(picture.changes), "live": picture.live}
    tree = {key: value for key, value in tree.items() if value}
    if picture.held is not None:
        held = Document(scene, picture.held.projection, settings=picture.held.settings)
        tree["held"] = {key: value for key, value in to_tree(held).items() if key in PARTS}
    return tree


def _mesh_from(path: str, folder: Path) -> str:
    """Return a mesh's path relative to a folder, if it lies below it or at most two levels up."""
    if not is_mesh(path):  # a built-in scene
        return path
    # Do not resolve the mesh itself: it may deliberately be a link to a data store.
    place, name = os.path.split(os.path.abspath(path))
    mesh = os.path.join(os.path.realpath(place), name)
    with contextlib.suppress(ValueError):  # on another drive of Windows
        relative = os.path.relpath(mesh, os.path.realpath(folder))
        if relative.split(os.sep)[:3] != [os.pardir] * 3:
            mesh = relative
    return mesh.replace(os.sep, "/")
