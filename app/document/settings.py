"""Set values by their paths, as ``--set`` and lessons do; resolve compared pictures."""

import contextlib
import difflib
import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from typing import Any, TypeAlias

from app.document.codec import LONGEST_SHOWN, Path, document_paths, from_tree, to_tree
from app.document.compare import NAME_ENDS, ComparedPicture
from app.document.document import (
    ANGLES,
    CALIBRATED,
    CAMERA_P,
    FIVE,
    Document,
    Field,
    controls_of,
    fields_of,
    lens_fields,
)
from app.document.files import read
from app.document.view import AS_EVER, STRIP
from app.languages import said
from app.lecture.equation import equation_of
from app.model.chain import NOT_MOVED, FiveTiles
from app.model.limits import OTHER_SIDE, positive
from app.model.numerals import numbers
from app.model.parameters import FOCAL_LENGTH, FOV_X, FOV_Y, KEEP, WINDOW_SIDES
from app.model.projection import LENSES, Intrinsics, kinds
from app.model.refusal import REFUSALS, Refusal, format_value, nearest, shown_name
from app.scenes.phenomena import PHENOMENA

Values: TypeAlias = dict[str, Any]
MEASURES = {field.path: field for field in (*CALIBRATED, *ANGLES)}
_SIDES = tuple(each.path for each in WINDOW_SIDES)
_DECIDING = (
    tuple(field.path for field in CALIBRATED), *((field.path,) for field in ANGLES),
    (FOV_Y.path,), (*_SIDES, KEEP.path),
)  # fmt: skip
_RIVALS = (
    _DECIDING,
    (("lens.K",), ("lens.fx", "lens.fy"), ("lens.focal_mm", "lens.sensor_width_mm",
                                           "lens.sensor_height_mm")),
    (("lens.K",), ("lens.cx", "lens.cy")),
)  # fmt: skip
"""Values of which only those of one group can be set together."""


def set_values(document: Document, assignments: Iterable[str]) -> Document:
    """Set values by their paths in the document, all at once.

    Only the result has to be valid, so the order of the assignments does not matter. Of two
    assignments to one path the last one counts.

    - ``scene`` comes first and sets its default settings.
    - ``lens.kind`` comes next and keeps the picture similar. If sides of its window are given, they
    are used as typed: ``lens.keep`` is then ``stretch``, unless it is set too.
    - Settings come next. Camera and lens may follow them, but the lens keeps the requested kind.
    - ``camera.P`` is a camera and its lens.
    - The measures of a lens that no document has (``lens.fx``, ``lens.fov_x_deg``) come last.
    - ``view.frame_step`` opens its panel, unless ``view.panel`` is set, too.

    Raises a `Refusal` for an unknown path (naming the nearest known one), a text that is not a
    value, or an invalid result.

    - `assignments`: ``lens.far=inf``, ``camera.eye=3,2,4``, ``depth=reversed``, ``scene=cube``,
      ``settings.distance=2``, ``view.stage=pyramid``. A matrix is its 16 cells, row by row; probes
      are the numbers x, y, z of each point in turn; hidden layers, and the things that the pictures
      name, are names separated by commas. ``view.compare=lens.near=2;lens.far=9|lens.near=3``
      compares with two pictures, and ``view.compare=NAME`` with those of one of the scene's own
      comparisons. A picture may have a name,
      ``eye: settings.preset=eye|phone: settings.preset=phone``; of several pictures one may be the
      document's own.
    """
    texts: dict[str, str] = {}
    for assignment in assignments:
        path, equals, text = (part.strip() for part in assignment.partition("="))
        if not equals or not path:
            written = assignment.strip()
            raise Refusal.in_document(
                REFUSALS["no-equals"], field=shown_name(written) or repr(written)
            )
        texts[path] = text
    scene = texts.pop("scene", document.scene)
    if scene != document.scene:
        still = replace(document.projection, placement=NOT_MOVED)
        view = replace(document.view, names=None)
        document = replace(document, scene=scene, projection=still, settings={}, mesh="", view=view)
    if "view.frame_step" in texts:
        texts.setdefault("view.panel", "frame")
    kind = texts.pop("lens.kind", "")
    if kind and any(path in texts for path in _SIDES):
        texts.setdefault(KEEP.path, "stretch")
    document = _with_lens(document, kind)
    if CAMERA_P.path in texts:
        document = _through(document, texts, kind)
    known = {each.path: each for each in fields_of(document.scene, document.projection.lens.kind)}
    measures = {path: texts.pop(path) for path in MEASURES if path in texts}
    paths = ["scene", *(path for path, each in known.items() if each.kind is not None)]
    for path in texts:
        if path not in paths:
            raise _unknown_path(path, [*paths, *MEASURES, *[CAMERA_P.path] * ("." in path)])
    beside, dividers = texts.pop("view.compare", None), texts.pop("view.dividers", None)
    settings = {known[path]: text for path, text in texts.items() if path.startswith("settings.")}
    values = {each.name: _read(each, text) for each, text in settings.items()}
    with document_paths():
        document = document.with_settings(values)
    document = _with_lens(document, kind)
    tree = to_tree(document)
    older = [field.path for field in FIVE if field.path in texts]
    if older:  # they replace the chain
        if "object.chain" in texts:
            raise Refusal.in_document(REFUSALS["either"], "object.chain", field=older[0])
        five = document.projection.placement.five or FiveTiles()
        tree["object"] = {field.name: getattr(five, field.name) for field in FIVE}
    for path, text in texts.items():
        each = known[path]
        if each not in settings:
            section = tree.setdefault(each.section, {}) if each.section else tree
            section[each.name] = _read(each, text)
    try:
        document = _measured(from_tree(tree), measures, texts, kind)
        document = _beside(document, beside, dividers)
        with document_paths("view"):
            _check_slide(document, texts)
        return document
    except Refusal as error:
        side, bound = OTHER_SIDE.get(error.bound, ("", error.bound))
        if f"lens.{side}" not in texts or error.field in texts:
            raise
        # The other one of the two was set.
        limit, value = format_value(error.value), tree["lens"][side]
        raise Refusal.in_document(bound, limit, field=f"lens.{side}", value=value) from error


def open_with(path: Path, over: Document, assignments: Iterable[str]) -> Document:
    """Read a file; a camera without an image size has that of assignments. They come later."""
    sizes = [each for each in assignments if each.strip().startswith("image.")]
    return read(path, set_values(over, sizes))


def _through(document: Document, texts: dict[str, str], kind: str) -> Document:
    """Return the document seen through the camera matrix P, which is taken out of `texts`."""
    from app.document.camera_files import seen_through

    cells = _read(CAMERA_P, texts.pop(CAMERA_P.path))
    for path in [*texts, *(["lens.kind"] if kind else [])]:
        if path.startswith(("camera.", "lens.kind")) or any(path in each for each in _DECIDING):
            raise Refusal.in_document(REFUSALS["contradicts"], CAMERA_P.path, field=path)
    sizes = [f"{path}={text}" for path, text in texts.items() if path.startswith("image.")]
    document = set_values(document, sizes)
    with document_paths():
        projection = seen_through(cells, document.projection, is_sized=bool(sizes))
    return replace(document, projection=projection)


def _measured(
    document: Document, texts: dict[str, str], others: Collection[str], kind: str
) -> Document:
    """Return the document with the lens of the `MEASURES` in `texts`, for the final image size.

    One of fx and fy stands for both, and what is not given stays; `others` are the paths that are
    set besides, and `kind` the kind of lens.
    """
    if not texts:
        return document
    for rivals in _RIVALS:
        given = [[path for path in paths if path in {*texts, *others}] for paths in rivals]
        if len(both := list(filter(None, given))) > 1:
            raise Refusal.in_document(REFUSALS["contradicts"], both[1][0], field=both[0][0])
    values: Values = {MEASURES[path].name: _read(MEASURES[path], texts[path]) for path in texts}
    projection = document.projection
    by_angle = any(field.path in texts for field in ANGLES)
    lenses = [
        name for name, lens in LENSES.items() if (lens.symmetric if by_angle else lens.central)
    ]
    if projection.lens.kind not in lenses:
        raise Refusal.in_document(
            REFUSALS["other-lens"], ", ".join(lenses), field=next(iter(texts))
        )
    with document_paths("lens"):
        for angle in (FOV_X, FOCAL_LENGTH):
            if angle.name in values:
                projection = angle.put(projection, values[angle.name])
        if not by_angle:
            now = projection.intrinsics
            focal = _focal_px(values, projection.image_size, now)
            centre = values.get("cx", now.cx), values.get("cy", now.cy)
            projection = projection.with_intrinsics(values.get("K", (*focal, *centre)))
    if kind == "perspective" != projection.lens.kind:
        raise Refusal.in_document(REFUSALS["contradicts"], next(iter(texts)), field="lens.kind")
    return _with_lens(replace(document, projection=projection), kind)


def _focal_px(values: Values, image: tuple[int, int], now: Intrinsics) -> tuple[float, float]:
    """Return fx and fy in pixels, also of a focal length in mm; one of them stands for both."""
    fx, fy = values.get("fx"), values.get("fy")
    sides = "sensor_width_mm", "sensor_height_mm"
    if values.keys() & {"focal_mm", *sides}:
        if "focal_mm" not in values:
            raise Refusal.in_document(REFUSALS["missing"], field="lens.focal_mm")
        focal_mm = positive("focal_mm", values["focal_mm"])
        if not values.keys() & {*sides}:
            raise Refusal("focal_mm", focal_mm, REFUSALS["no-sensor"])
        fx, fy = (
            focal_mm * pixels / positive(side, values[side]) if side in values else None
            for side, pixels in zip(sides, image, strict=True)
        )
    if fx is None:
        return (now.fx, now.fy) if fy is None else (abs(fy), fy)
    return fx, abs(fx) if fy is None else fy


def _check_slide(document: Document, paths: Collection[str]) -> None:
    """Refuse controls that the scene lacks, and an equation that the lens lacks."""
    view = document.view
    if "view.controls" in paths:
        known = [STRIP, *controls_of(document.scene)]
        for name in view.controls:
            if name not in known:
                raise Refusal("controls", name, REFUSALS["unknown"], nearest(name, known))
    if "view.equation" in paths and view.equation:
        equation_of(document.projection, view.letters, view.equation, document.settings)


def _read(field: Field, text: str) -> object:
    assert field.kind is not None
    bound = field.kind.bound
    try:
        value = field.read(text)
    except Refusal as error:  # it says what in the text is not a value
        if error.field.startswith(f"{field.path}["):  # and at which place
            raise
        value, bound = None, (error.bound, *error.limits)
    if value is None:
        raise Refusal.in_document(*bound, field=field.path, value=text)
    return value


def _with_lens(document: Document, kind: str) -> Document:
    """Return the document with another kind of lens; an empty name changes nothing."""
    if kind in ("", document.projection.lens.kind):
        return document
    with document_paths():
        return replace(document, projection=document.projection.with_lens(kind))


def _unknown_path(path: str, paths: Sequence[str]) -> Refusal:
    shown = shown_name(path[:LONGEST_SHOWN])
    section, _, key = path.rpartition(".")
    others = [kind for kind in kinds() if key in {each.name for each in lens_fields(kind)}]
    if section in ("lens", "") and others and f"lens.{key}" not in paths:
        return Refusal.in_document(REFUSALS["other-lens"], ", ".join(others), field=shown)
    if section == "settings" and not any(known.startswith("settings.") for known in paths):
        scenes = [
            name
            for name, phenomenon in PHENOMENA.items()
            if key in {setting.name for setting in phenomenon.settings}
        ]
        if scenes:
            return Refusal.in_document(REFUSALS["other-scene"], ", ".join(scenes), field=shown)

    def likeness(known: str) -> float:
        typed, known = shown.lower(), known.lower()
        last, (of_part, _, named) = typed.rpartition(".")[2], known.rpartition(".")
        whole = difflib.SequenceMatcher(None, typed, known).ratio()
        begun = of_part in (section, "") and named.startswith(last)
        return max(whole, difflib.SequenceMatcher(None, last, named).ratio()) + whole / 100 + begun

    return Refusal.in_document(REFUSALS["unknown"], max(paths, key=likeness), field=shown)


# --------------------------------------------------------------------------- compared pictures


def _beside(document: Document, pictures: str | None, dividers: str | None) -> Document:
    """Compare with the pictures that a text names, or set the dividers of the present ones."""
    if pictures is not None and pictures and "=" not in pictures:
        document = compared(document, pictures)
    elif pictures is not None:
        with document_paths("view.compare"):
            others = [_picture(part) for part in (pictures.split("|") if pictures else ())]
        states = [pictured(document, picture) for picture in others]
        if len(others) > 1 and document in states:
            own = states.index(document)
            others[own] = replace(others[own], live=True)
        elif others:
            others.append(ComparedPicture(live=True))
        with document_paths("view"):
            view = replace(document.view, compare=tuple(others), dividers=())
            document = replace(document, view=view)
    if dividers is not None:
        with document_paths("view"):
            if (places := numbers(dividers)) is None:
                raise Refusal("dividers", dividers, REFUSALS["some-dividers"])
            document = replace(document, view=replace(document.view, dividers=tuple(places)))
    return document


def _picture(text: str) -> ComparedPicture:
    """Read a picture as `picture_text` writes it: its values, perhaps after its name."""
    name, ends, values = text.partition(NAME_ENDS)
    if not ends or "=" in name:
        name, values = "", text
    return ComparedPicture(name.strip(), tuple(map(str.strip, assignments_in(values))))


def assignments_in(text: str) -> list[str]:
    """Split ``NAME=VALUE; NAME=VALUE``; the tiles of ``object.chain`` have no names."""
    return _NEXT_NAME.split(text)


_NEXT_NAME = re.compile(r";(?!\s*(?:off|translate|rotate|scale|shear|mirror|matrix)\s)")


def picture_text(picture: ComparedPicture) -> str:
    """Write a picture's part of ``view.compare``: ``phone: settings.preset=phone``."""
    values = ";".join(picture.changes)
    return f"{picture.name}{NAME_ENDS}{values}" if picture.name else values


def pictured(document: Document, picture: ComparedPicture) -> Document:
    """Return the document as a compared picture shows it, or a `Refusal` if it cannot be so."""
    plain = replace(document, view=AS_EVER)
    if picture.live:
        return plain
    if picture.held is not None:
        return replace(plain, projection=picture.held.projection, settings=picture.held.settings)
    return set_values(plain, picture.changes)


def compared(document: Document, name: str) -> Document:
    """Return the document with one of its scene's own comparisons.

    The document's own picture is the one whose values the document has, else the last one. Raises a
    `Refusal` if the scene has no comparison of this name, or its pictures are impossible in the
    current state.
    """
    phenomenon = PHENOMENA.get(document.scene)
    ready = {each.name: each for each in phenomenon.words.comparisons} if phenomenon else {}
    if name not in ready:
        names = ", ".join(ready) or said("none")
        raise Refusal.in_document(REFUSALS["compared"], names, field="view.compare", value=name)
    pictures = [ComparedPicture(*each) for each in ready[name].pictures]
    states = [pictured(document, picture) for picture in pictures]
    own = states.index(document) if document in states else len(states) - 1
    pictures[own] = replace(pictures[own], live=True)
    return replace(states[own], view=replace(document.view, compare=tuple(pictures), dividers=()))


def name_of(document: Document, picture: ComparedPicture) -> str:
    """Return the name that was given to a compared picture; empty if it has none now.

    The document's own picture keeps its name only while the document has its values.
    """
    if picture.live and picture.name:
        with contextlib.suppress(Refusal):  # then the document does not have these values
            if pictured(document, replace(picture, live=False)) == document:
                return picture.name
        return ""
    return picture.name
