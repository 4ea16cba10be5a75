"""Documents: exact, tolerant of unknown keys, strict about wrong values, never half a file."""

import copy
import errno
import itertools
import json
import math
import os
import pickle
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import app.model.projection
import app.scenes.scene
from app import languages
from app.bootstrap import ROOT
from app.document import codec, files
from app.document.codec import SHORTEST, parse, to_json, to_tree
from app.document.compare import ComparedPicture
from app.document.document import (
    MESH_ENDINGS,
    NUMBER,
    NUMBER_OR_WORD,
    Document,
    is_mesh,
    lens_fields,
)
from app.document.files import (
    extract,
    holds_document,
    read,
    read_letters,
    write,
    write_bytes_atomically,
)
from app.document.settings import set_values
from app.document.view import FIELDS as VIEW_FIELDS
from app.document.view import FIXED, LAYERS, PANELS, PANES, STAGES, View, without_scene
from app.lecture.camera_frame import STEPS
from app.lecture.letters import LETTERS
from app.model.projection import (
    DEPTH_RANGES,
    LENSES,
    Camera,
    FreeMatrix,
    Frustum,
    Orthographic,
    Perspective,
    Projection,
    kinds,
)
from app.model.refusal import REFUSALS, Refusal
from app.picking.picking import Probe
from app.scenes.phenomena import PHENOMENA
from tests import PATIENCE_S
from tests.fuzz.catalogue import a_valid_tree, any_view
from tests.fuzz.documents import outcome_of
from tests.support.carrier import carrier
from tests.support.phenomenon import EVERYTHING, called, make_known

DESIGN = """
{"format": "frustum-lab", "version": 3, "scene": "letter-f",
 "camera": {"eye": [5, 4.5, 8], "target": [0, 2.2, 0], "up": [0, 1, 0]},
 "lens": {"kind": "perspective", "fov_y_deg": 38, "near": 1, "far": 30},
 "depth": "opengl", "image": {"width": 1280, "height": 720}}
"""
WRITTEN = """\
{
  "format": "frustum-lab",
  "version": 3,
  "scene": "letter-f",
  "camera": {"eye": [5, 4.5, 8], "target": [0, 2.2, 0], "up": [0, 1, 0]},
  "lens": {"kind": "perspective", "fov_y_deg": 38, "near": 5, "far": 12.5},
  "depth": "opengl",
  "image": {"width": 1280, "height": 720}
}
"""
BOX = Orthographic(-4.0, 4.0, -3.0, 3.0, -1.0, 30.0, "y")
PARALLEL = Document("cube", Projection(lens=BOX))


def sentence(make: Callable[..., object], *arguments: object) -> str:
    """The one sentence with which something is refused."""
    with pytest.raises(Refusal) as caught:
        make(*arguments)
    text = str(caught.value)
    assert "\n" not in text
    assert text.endswith(".")
    assert len(text) < 400
    return text


def with_value(path: str, value: object, text: str = DESIGN) -> str:
    """The document with one value changed, or removed if it is `Ellipsis`."""
    tree = json.loads(text)
    *sections, key = path.split(".")
    inner = tree
    for section in sections:
        inner = inner[section]
    if value is ...:
        del inner[key]
    else:
        inner[key] = value
    return json.dumps(tree)


# --------------------------------------------------------------------------- the format


def test_the_format_is_that_of_the_design() -> None:
    document = parse(DESIGN)
    assert document.scene == "letter-f"
    assert document.extra == {}
    assert document.projection == Projection(
        Camera((5.0, 4.5, 8.0), (0.0, 2.2, 0.0), (0.0, 1.0, 0.0)),
        Perspective(38.0, 1.0, 30.0),
        (1280, 720),
        "opengl",
    )
    assert to_json(document) == WRITTEN.replace('5, "far": 12.5', '1, "far": 30')


def test_an_orthographic_lens_writes_keep_and_may_leave_it_out() -> None:
    tree = json.loads(to_json(PARALLEL))
    assert tree["lens"] == {
        "kind": "orthographic", "left": -4, "right": 4, "bottom": -3, "top": 3, "near": -1,
        "far": 30, "keep": "y",
    }  # fmt: skip
    without = parse(with_value("lens.keep", ..., to_json(PARALLEL)))
    assert without.projection.lens == replace(BOX, keep="stretch")


def test_a_whole_number_may_be_written_with_a_point() -> None:
    written = with_value("image.width", 1280.0, with_value("version", 1.0))
    assert parse(with_value("lens.near", 1.0, written)) == parse(DESIGN)


JSON_VALUES = st.recursive(
    st.one_of(
        st.none(),
        st.booleans(),
        st.integers(-(2**1000), 2**1000),
        st.floats(allow_nan=False, allow_infinity=False),
        st.text(),
    ),
    lambda inner: st.lists(inner, max_size=2) | st.dictionaries(st.text(), inner, max_size=2),
    max_leaves=5,
)


def unknown_keys(known: Iterable[str]) -> st.SearchStrategy[dict[str, Any]]:
    return st.dictionaries(st.text().filter(lambda key: key not in known), JSON_VALUES, max_size=2)


@st.composite
def documents(draw: st.DrawFn) -> Document:
    """Any document, with unknown keys at every level."""
    rng = random.Random(draw(st.integers(0, 10**9)))
    projection = parse(json.dumps(a_valid_tree(rng))).projection
    camera = projection.camera
    seen_from = camera if min(camera.distance, math.hypot(*camera.up)) > SHORTEST else Camera()
    view = any_view(rng, seen_from)
    tree = to_tree(Document(projection=projection))
    known = {name: set(value) for name, value in tree.items() if isinstance(value, dict)}
    extra = draw(unknown_keys({*tree, "mesh", "settings", "object", "quality", "view"}))
    inside = draw(unknown_keys({*itertools.chain(*known.values()), "former", "view_from_world"}))
    if inside:
        extra[draw(st.sampled_from(sorted(known)))] = inside
    beside: dict[str, Any] = draw(unknown_keys(VIEW_FIELDS))
    if view.panes and inside:
        beside["panes"] = {draw(st.sampled_from(sorted(view.panes))): inside}
    if beside:
        extra["view"] = beside
    # Also names that are not UTF-8, which a POSIX folder may hold.
    letters = st.characters(exclude_categories=["Cs"], exclude_characters="\0")
    scene = draw(st.text(letters | st.sampled_from("\udc80\udcff"), min_size=1))
    return Document(scene, projection, extra, view)


@given(documents())
@settings(max_examples=60)
@example(Document("not UTF-8 \udcff.stl"))
@example(Document("cube", Projection(Camera(target=(-0.0, 5e-324, 1e16), up=(1e15, 1 / 3, 1e-7)))))
def test_the_round_trip_is_exact(document: Document) -> None:
    text = to_json(document)
    again = parse(text)
    assert again == document and again.view == document.view
    assert repr(again.projection) == repr(document.projection)  # each bit, and -0.0
    assert repr(again.view.probes) == repr(document.view.probes)
    assert to_json(again) == text  # and in the unknown keys 1 is not 1.0, nor True
    assert hash(again) == hash(document)
    text.encode()


# --------------------------------------------------------------------------- unknown keys, versions


def test_unknown_keys_survive_at_every_level() -> None:
    tree = json.loads(DESIGN)
    tree |= {"author": "Ana Horvat, čćžšđ", "notes": {"page": [3, {"line": None}]}}
    tree["camera"]["label"] = "A"
    tree["lens"] |= {"maker": "?", "left": -1}  # a field of another lens is not ours here
    tree["image"]["dpi"] = 300
    tree["view"] = {"mood": 7, "panes": {"world": tree["camera"] | {"label": "from above"}}}
    document = parse(json.dumps(tree))
    assert json.loads(to_json(document)) == tree
    assert "čćžšđ" in to_json(document)  # as a person can read it
    # They stay when the document is edited ...
    moved = set_value(document, "lens.near", "2")
    tree["lens"]["near"] = 2
    assert json.loads(to_json(moved)) == tree
    # ... and what the new lens knows is taken from the lens.
    flat = set_value(document, "lens.kind", "orthographic")
    lens = json.loads(to_json(flat))["lens"]
    # What belonged to a pane's view goes with it.
    assert "from above" not in to_json(replace(document, view=View()))
    assert json.loads(to_json(replace(document, view=View())))["view"] == {"mood": 7}
    assert lens["left"] == flat.projection.lens.left < -1.0
    assert lens["maker"] == "?"
    assert parse(to_json(flat)) == flat


def test_only_a_lens_whose_far_may_be_infinite_offers_inf() -> None:
    for text in ("Infinity", '"Infinity"'):
        flat = to_json(PARALLEL).replace('"far": 30', f'"far": {text}')
        assert sentence(parse, flat).endswith(": must be a finite number.")
    frustum = to_json(set_value(parse(DESIGN), "lens.kind", "frustum"))
    for text in ("Infinity", '"Infinity"'):
        endless = frustum.replace('"far": 30', f'"far": {text}')
        assert sentence(parse, endless).endswith("number or inf.")


def test_a_newer_version_is_refused() -> None:
    assert sentence(parse, with_value("version", 4)) == (
        "The document was written by a newer Frustum Lab: its version is 4, this program reads "
        "up to 3."
    )
    # Whatever else it holds, that is what is said.
    sentence(parse, json.dumps({"format": "frustum-lab", "version": 4})).index("newer")


def test_older_versions_are_migrated_step_by_step(monkeypatch: pytest.MonkeyPatch) -> None:
    def spell_out(tree: dict[str, Any]) -> dict[str, Any]:
        return tree | {"scene": tree["place"]}

    def add_word(tree: dict[str, Any]) -> dict[str, Any]:
        return tree | {"scene": tree["scene"] + "-f"}

    monkeypatch.setattr(codec, "MIGRATIONS", (spell_out, add_word))
    monkeypatch.setattr(codec, "VERSION", 3)
    tree = json.loads(DESIGN)
    del tree["scene"]
    assert parse(json.dumps(tree | {"version": 1, "place": "letter"})).scene == "letter-f"
    assert parse(json.dumps(tree | {"version": 2, "scene": "letter"})).scene == "letter-f"
    assert parse(json.dumps(tree | {"version": 3, "scene": "letter"})).scene == "letter"
    assert json.loads(to_json(Document()))["version"] == 3


# --------------------------------------------------------------------------- what is refused

FINITE = "must be a finite number"
PLACE = "must be three finite numbers x, y, z"
KINDS = f"must be one of {', '.join(kinds())}"
RANGES = f"must be one of {', '.join(DEPTH_RANGES)}"
PIXELS = "must be a whole number of pixels from 1 to 16384"
ANGLE = "must lie between 0 and 180, both excluded"
BRACES = "must be an object with named values in braces"
VERSIONS = "must be a whole number, 1 or more"
SCENES = "must be the name of a scene or of a mesh file"
BAD_VALUES: list[tuple[str, object, str]] = [
    ("lens.near", -1, "-1: must be greater than 0"),
    ("lens.near", None, f"null: {FINITE}"),
    ("lens.near", True, f"true: {FINITE}"),
    ("lens.near", {"m": 1}, "{m: ...}: " + FINITE),
    ("lens.near", "inf", f"'inf': {FINITE}"),
    ("lens.far", "infinity", f"'infinity': {FINITE} or inf"),
    ("lens.fov_y_deg", 180, f"180: {ANGLE}"),
    ("lens.kind", "fisheye", f"'fisheye': {KINDS}"),
    ("camera.eye", [1, 2], f"[1, 2]: {PLACE}"),
    ("camera.eye", "6,5,9", f"'6,5,9': {PLACE}"),
    ("camera.eye", [6, None, 9], f"[6, null, 9]: {PLACE}"),
    ("camera.up", [10, 4.6, 16], "[10, 4.6, 16]: must not be parallel to the view direction"),
    ("image.width", 0, f"0: {PIXELS}"),
    ("image.height", "720", f"'720': {PIXELS}"),
    ("depth", "vulkan", f"'vulkan': {RANGES}"),
    ("depth", {}, "{}: " + RANGES),
    ("scene", "", f"'': {SCENES}"),
    ("scene", "a\0.stl", f"'a\\x00.stl': {SCENES}"),
    ("camera", [6, 5, 9], f"[6, 5, 9]: {BRACES}"),
    ("lens", "perspective", f"'perspective': {BRACES}"),
    ("image", None, f"null: {BRACES}"),
    ("version", 1.5, f"1.5: {VERSIONS}"),
    ("version", 0.0, f"0: {VERSIONS}"),
    ("version", True, f"true: {VERSIONS}"),
]


def test_a_wrong_value_is_named_with_its_bound() -> None:
    for path, value, said in BAD_VALUES:
        text = with_value(path, value)
        assert sentence(parse, text) == f"{path} = {said}."
    moved = with_value("camera.eye", [0, 2.2, 0])  # the model names the target
    assert sentence(parse, moved).startswith("camera.target = [0, 2.2, 0]: must differ fr")
    for value in ("obj", ["frustum-lab"], ...):
        text = with_value("format", value)
        found = sentence(parse, text)
        assert found == "The document is not a Frustum Lab document."


@pytest.mark.parametrize("document", [Document(), PARALLEL], ids=["perspective", "orthographic"])
def test_a_missing_field_is_named(document: Document) -> None:
    tree = json.loads(to_json(document))
    paths = [key for key in tree if key != "format"]
    paths += [f"{key}.{name}" for key in tree if isinstance(tree[key], dict) for name in tree[key]]
    for path in set(paths) - {"lens.keep"}:
        text = with_value(path, ..., to_json(document))
        assert sentence(parse, text) == f"{path} is missing."


NOT_JSON = "The document is broken or cut short: the text from line {}, column {} on is not JSON."
FOREIGN = "The document is not a Frustum Lab document."
EMPTY = "The document is empty."
DEEP = "The document has more than 50 levels of brackets."
MANY = "The document has more than 100000 values."
ZEROS = "lens.near = 1" + "0" * 56 + f"...: {FINITE}."
BAD_TEXTS = [
    ('"near": 1', '"near": NaN', f"lens.near = NaN: {FINITE}."),
    ('"far": 30', '"far": Infinity', f"lens.far = Infinity: {FINITE} or inf."),
    ('"far": 30', '"far": "INF"', f"lens.far = 'INF': {FINITE} or inf."),
    ('"far": 30', '"far": -1e400', f"lens.far = -1e400: {FINITE} or inf."),
    ('"far": 30', '"far": 30, "far": 31', "lens.far is given twice."),
    ('"depth"', '"far": Infinity, "depth"', f"far = Infinity: {FINITE}."),
    ("[5, 4.5, 8]", "[5, -Infinity, 8]", f"camera.eye[1] = -Infinity: {FINITE}."),
    ('"near": 1', '"near": 1' + "0" * 100_000, ZEROS),
    ('"depth"', '"note": {"a": [NaN]}, "depth"', f"note.a[0] = NaN: {FINITE}."),
    ('"depth"', '"depth": "opengl", "depth"', "depth is given twice."),
    ('"depth"', '"a": [{"b": 1, "c": 2, "b": 3}], "depth"', "a[0].b is given twice."),
    ('"depth"', '"a\\nb": NaN, "depth"', f"'a\\nb' = NaN: {FINITE}."),
    ("\n{", "", NOT_JSON.format(1, 9)),
    ("720}}", "720}", NOT_JSON.format(6, 1)),
    ("720}}", "720}}}", NOT_JSON.format(5, 61)),
    ('"near": 1', '"near": 0x1', NOT_JSON.format(4, 60)),
    *((DESIGN, empty, EMPTY) for empty in ("", " \n\t", "\ufeff")),
    *((DESIGN, other, FOREIGN) for other in ("null", "[]", "{}", "3", "NaN")),
    *((DESIGN, deep, DEEP) for deep in ("[" * 60_000, '{"a":' * 60_000, "[" * 60 + "]" * 60)),
    *(
        (DESIGN, many, MANY)
        for many in ("[" * 10**6, '{"a":' * 10**6, "0," * 10**5, "[]," * 50_000)
    ),
]


def test_a_wrong_text_is_refused() -> None:
    for old, new, expected in BAD_TEXTS:
        assert old in DESIGN
        text = DESIGN.replace(old, new, 1)
        assert sentence(parse, text) == expected


def test_any_beginning_of_a_document_is_refused() -> None:
    for end in range(len(WRITTEN) - 2):
        sentence(parse, WRITTEN[:end])


@given(st.text() | st.from_regex(r'[\[\]{}:,"0-9eE.+\-a-z\\ ]*', fullmatch=True))
def test_any_other_text_is_refused(text: str) -> None:
    sentence(parse, text)


@given(st.data())
def test_any_value_anywhere_is_accepted_or_refused(data: st.DataObject) -> None:
    paths = ["version", "scene", "camera", "lens", "image", "depth", "camera.eye", "camera.up"]
    paths += ["lens.kind", "lens.near", "lens.far", "lens.fov_y_deg", "image.width"]
    tree = with_value(data.draw(st.sampled_from(paths)), data.draw(JSON_VALUES))
    try:
        document = parse(tree)
    except Refusal as error:
        assert str(error).endswith(".")
    else:
        assert parse(to_json(document)) == document


# --------------------------------------------------------------------------- no silent NaN


def test_random_documents_give_no_silent_nan() -> None:
    """Many are valid, and many are refused, for various reasons; warnings are errors."""
    found = [outcome_of(seed) for seed in range(1000)]
    assert found.count("valid") > 200
    assert len(set(found)) > 15


def test_an_error_keeps_its_parts_so_that_it_can_be_translated() -> None:
    with pytest.raises(Refusal) as caught:
        parse(with_value("lens.near", -1))
    error = caught.value
    assert (error.field, error.value, error.bound) == ("lens.near", -1.0, REFUSALS["above"])
    assert error.limits == (0,)
    words = {REFUSALS["above"]: "mora biti veći od {0}"}
    assert error.sentence(words.__getitem__) == "lens.near = -1: mora biti veći od 0."
    for clone in (copy.copy(error), pickle.loads(pickle.dumps(error))):
        assert str(clone) == str(error)
    with pytest.raises(Refusal) as caught:
        read("no-such-file.json")
    assert caught.value.sentence(str.upper) == "no-such-file.json DOES NOT EXIST."
    with pytest.raises(Refusal) as caught:
        parse("")
    assert caught.value.sentence(str.upper) == "THE DOCUMENT IS EMPTY."


def test_a_long_value_is_cut() -> None:
    for value in ("x" * 10**6, list(range(10**4)), {str(i): i for i in range(10**4)}):
        assert "...: must be" in sentence(parse, with_value("depth", value))


def test_a_document_has_a_scene() -> None:
    assert sentence(Document, None).startswith("scene = null: ")


# --------------------------------------------------------------------------- --set


def lens_of(*assignments: str, document: Document = PARALLEL) -> app.model.projection.Lens:
    return set_values(document, assignments).projection.lens


def test_values_are_set_by_their_paths() -> None:
    document = set_values(
        parse(DESIGN),
        [
            "lens.far=inf", "lens.near = .5", "lens.fov_y_deg=6e1", "camera.eye=3,2,4",
            "camera.target= -1 , +2.5 , 1e-3", "camera.up=0,0,1", "depth=reversed",
            "scene=cube", "image.width=800", "image.height=600.0",
        ],
    )  # fmt: skip
    assert document == Document(
        "cube",
        Projection(
            Camera((3, 2, 4), (-1, 2.5, 1e-3), (0, 0, 1)),
            Perspective(60, 0.5, math.inf),
            (800, 600),
            "reversed",
        ),
    )
    assert lens_of("lens.keep=x", "lens.left=-7") == replace(BOX, keep="x", left=-7)
    assert set_value(parse(DESIGN), "scene", "a=b.stl").scene == "a=b.stl"
    assert set_values(parse(DESIGN), []) == parse(DESIGN)
    assert set_values(parse(DESIGN), ["lens.near=2", "lens.near=3"]).projection.lens.near == 3.0


def test_the_order_of_settings_does_not_matter() -> None:
    settings = ["lens.near=50", "lens.far=100"]
    assert lens_of(*settings) == lens_of(*settings[::-1]) == replace(BOX, near=50, far=100)
    # Moving the camera through its target.
    both = ["camera.eye=0,2.2,0", "camera.target=5,5,5"]
    assert set_values(parse(DESIGN), both) == set_values(parse(DESIGN), both[::-1])
    # A field of the lens that comes later.
    settings = ["lens.fov_y_deg=60", "lens.near=2", "lens.kind=perspective"]
    assert lens_of(*settings) == lens_of(*settings[::-1]) == Perspective(60, 2, 30)


@pytest.mark.parametrize(("volume", "kind"), [("cone", "orthographic"), ("box", "perspective")])
def test_lens_kind_wins_over_the_lens_that_a_setting_chooses(volume: str, kind: str) -> None:
    document = Document("view-volumes", PHENOMENA["view-volumes"].start)
    paths = [f"settings.volume={volume}", f"lens.kind={kind}", "lens.near=0.5"]
    made = set_values(document, paths)
    assert made == set_values(document, paths[::-1])
    assert (made.projection.lens.kind, made.projection.lens.near) == (kind, 0.5)
    assert made.settings["volume"] == volume


def test_a_change_of_the_lens_keeps_the_picture_similar() -> None:
    document = parse(DESIGN)
    flat = set_value(document, "lens.kind", "orthographic")
    assert flat.projection == document.projection.with_lens("orthographic")
    assert set_value(document, "lens.kind", "perspective") == document


NEAREST = "is not known; the nearest name is"
WITH_WINDOW = ", ".join(kind for kind, lens in LENSES.items() if lens.window_stays)
WINDOWED = f"belongs to another lens: set lens.kind as well ({WITH_WINDOW})."
BAD_SETTINGS = [
    ("lens.nera=1", f"lens.nera {NEAREST} lens.near."),
    ("near=1", f"near {NEAREST} lens.near."),
    ("fov=60", f"fov {NEAREST} lens.fov_y_deg."),
    ("camera.eyes=1,2,3", f"camera.eyes {NEAREST} camera.eye."),
    ("width=800", f"width {NEAREST} image.width."),
    ("camera=1", f"camera {NEAREST} camera.up."),
    ("Depth=opengl", f"Depth {NEAREST} depth."),
    ("version=2", f"version {NEAREST}"),
    ("lens.former=1", "lens.former belongs to another lens: set lens.kind as well (matrix)."),
    ("=1", "=1 must be written as NAME=VALUE."),
    ("", "'' must be written as NAME=VALUE."),
    ("lens.near", "lens.near must be written as NAME=VALUE."),
    ("lens.left=1", f"lens.left {WINDOWED}"),
    ("keep=x", f"keep {WINDOWED}"),
    ("lens.kind=frustrum", f"lens.kind = 'frustrum': {KINDS}."),
    ("scene=", f"scene = '': {SCENES}."),
    *(
        (f"lens.near={text}", f"lens.near = {text!r}: {FINITE}.")
        for text in ("", "nan", "inf", "0x10", "1_000", "1,5", "\u0661", "1 2", "true")
    ),
    ("lens.far=1e400", f"lens.far = '1e400': {FINITE} or inf."),
    ("lens.near=1e-400", "lens.near = 0: must be greater than 0."),
    ("lens.far=0.5", "lens.far = 0.5: must be greater than near, which is 1."),
    *(
        (f"camera.eye={text}", f"camera.eye = {text!r}: {PLACE}.")
        for text in ("1,2", "1,2,3,4", "1,2,inf", "1;2;3")
    ),
    ("image.width=1_000", f"image.width = '1_000': {PIXELS}."),
    ("image.width=0.5", f"image.width = 0.5: {PIXELS}."),
    ("image.width=" + "9" * 5000, "image.width = "),
]


def test_a_wrong_setting_is_refused() -> None:
    for assignment, expected in BAD_SETTINGS:
        found = sentence(set_values, parse(DESIGN), [assignment])
        assert found.startswith(expected)


@pytest.mark.parametrize(
    ("assignments", "expected"),
    [
        (["lens.far=-2"], "lens.far = -2: must be greater than near, which is -1."),
        (["lens.right=-4"], "lens.right = -4: must be greater than left, which is -4."),
        (["lens.top=-5"], "lens.top = -5: must be greater than bottom, which is -3."),
        (["lens.near=40"], "lens.near = 40: must be less than far, which is 30."),
        (["lens.near=9", "lens.far=8"], "lens.near = 9: must be less than far, which is 8."),
        (
            ["lens.right=-4", "lens.far=-2"],
            "lens.far = -2: must be greater than near, which is -1.",
        ),
    ],
)
def test_a_refusal_names_the_value_that_was_set(assignments: list[str], expected: str) -> None:
    """A lens names the lower of two bounds, but a user may have set the upper one."""
    assert sentence(set_values, PARALLEL, assignments) == expected


@given(st.text(), st.text())
def test_any_setting_is_accepted_or_refused(path: str, text: str) -> None:
    sentence(set_value, Document(), f"my {path}", text)
    for known in ("lens.near", "camera.eye", "image.width", "depth"):
        try:
            set_value(Document(), known, text)
        except Refusal as error:
            assert str(error).startswith(known)


# --------------------------------------------------------------------------- PNG pictures


def test_a_document_in_a_picture_is_read() -> None:
    document = Document("mreža-čćž.stl", PARALLEL.projection, {"author": "Ülo 日本 🎓"})
    assert parse(extract(carrier(to_json(document))) or "") == document


def test_a_document_compressed_by_another_program_is_read() -> None:
    found = carrier(WRITTEN, lang="hr", tkey="dokument", zip=True)
    assert b"letter-f" not in found
    assert extract(found) == WRITTEN


def test_a_picture_without_a_document() -> None:
    assert extract(carrier()) is None


def text_chunk(body: bytes) -> bytes:
    chunk = b"iTXt" + b"frustum-lab\0" + body
    return struct.pack(">I", len(chunk) - 4) + chunk + struct.pack(">I", zlib.crc32(chunk))


def test_a_broken_picture_is_refused_wherever_it_is_cut_or_changed() -> None:
    whole = carrier(WRITTEN)
    broken = "The document is not a complete PNG picture: it is damaged or cut short."
    for end in range(len(whole)):
        assert sentence(extract, whole[:end]) == broken
        changed = bytearray(whole)
        changed[end] ^= 0x21
        assert sentence(extract, bytes(changed)) == broken
    for garbage in (b"", b"\x89PNG\r\n\x1a\n", WRITTEN.encode(), whole[8:], bytes(1000)):
        assert sentence(extract, garbage) == broken
    bomb = zlib.compress(bytes(2**25), 9)
    for body in (
        b"", b"\0", b"\0\0", b"\0\0\0\0\xff\xfe",  # no UTF-8
        b"\1\0\0\0no zlib", b"\1\0\0\0" + zlib.compress(b"x" * 99)[:-5], b"\1\0\0\0" + bomb,
    ):  # fmt: skip
        damaged = whole[:33] + text_chunk(body) + carrier()[33:]
        assert sentence(extract, damaged) == broken


# --------------------------------------------------------------------------- files


def test_a_file_is_read_by_its_content(tmp_path: Path) -> None:
    for name, content in (
        ("lesson.json", (" " + WRITTEN).encode()),
        ("lesson.frustum", WRITTEN.encode()),
        ("no ending č", WRITTEN.replace("\n", "\r\n").encode()),
        ("notepad.json", b"\xef\xbb\xbf" + WRITTEN.encode()),  # the mark of some editors
        ("powershell.json", WRITTEN.encode("utf-16")),
        ("raw.json", WRITTEN.encode("utf-16-le")),
        ("figure.png", carrier(WRITTEN)),
        ("figure.json", carrier(WRITTEN)),
        ("lesson.png", WRITTEN.encode()),
    ):
        (tmp_path / name).write_bytes(content)
        assert read(tmp_path / name) == Document()
        assert read(str(tmp_path / name)) == Document()


def test_a_file_that_is_no_document_is_refused_by_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    no_text = "is not a Frustum Lab document: it is not text."
    no_picture = "is not a complete PNG picture: it is damaged or cut short."
    negative, meshes = with_value("lens.near", -1), ", ".join(MESH_ENDINGS)
    contents: dict[str, tuple[bytes, str]] = {
        "empty.json": (b"", " is empty."),
        "two\nlines.json": (b"", " is empty."),
        "cut.json": (WRITTEN.encode()[:100], " is broken or cut short: the text from line 5,"
                     " column 33 on is not JSON."),
        "photo.json": (b"\xff\xd8\xff\xe0\0\x10JFIF", f" {no_text}"),
        "photo.jpg": (b"\xff\xd8\xff\xe0\0\x10JFIF", " is neither a document (.json), a lesson"
                      f" (.md), an exported picture (.png), a mesh ({meshes}) nor a camera file"
                      " (.json, .yml, .xml, cameras.txt, images.txt)."),
        "other.json": (b'{"a": 1}', " is not a Frustum Lab document."),
        "fake.png": (b"no picture at all", f" {no_picture}"),
        "cut.png": (carrier(WRITTEN)[:-5], f" {no_picture}"),
        "plain.png": (carrier(), " is a picture without a Frustum Lab document in it."),
        "wrong.png": (carrier(negative), ": lens.near = -1: must be greater than 0."),
        "wrong.json": (negative.encode(), ": lens.near = -1: must be greater than 0."),
        "missing.json": (with_value("lens.near", ...).encode(), ": lens.near is missing."),
    }  # fmt: skip
    for name, (content, expected) in contents.items():
        Path(name).write_bytes(content)
        shown = repr(name) if "\n" in name else name
        assert sentence(read, name) == shown + expected
    no_name = "is not a name that a file can have."
    assert sentence(read, "nothing.json") == "nothing.json does not exist."
    assert sentence(read, tmp_path) == f"{tmp_path} is a folder, not a file."
    assert sentence(read, "a\0b") == f"'a\\x00b' {no_name}"
    assert sentence(read, "\ud800") == f"'\\ud800' {no_name}"
    assert sentence(read, "x" * 5000).endswith("cannot be read: File name too long.")
    assert sentence(write, Document(), tmp_path) == f"{tmp_path} is a folder, not a file."
    missing = "no/such.json cannot be written: No such file or directory."
    assert sentence(write, Document(), "no/such.json") == missing
    assert sentence(write, Document(), "a\0b.json") == f"'a\\x00b.json' {no_name}"


def test_latin_1_is_read_with_a_warning(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    path = tmp_path / "old.json"
    document = Document(str(tmp_path / "café.obj"))
    path.write_bytes(to_json(document, str(tmp_path)).encode("latin-1"))
    assert read(path) == document
    assert caplog.messages == [f"{path} {languages.said('read-as-latin-1')}."]


@pytest.mark.parametrize("size", [10, 2**21])
@pytest.mark.parametrize("name", ["scan.las", "SCAN.PCD", "scan.xyz"])
def test_a_cloud_of_another_kind_is_refused_by_its_kind_however_large(
    name: str, size: int, tmp_path: Path
) -> None:
    (tmp_path / name).write_bytes(b"LASF 1 2 3\n" * size)
    said = sentence(read, tmp_path / name)
    assert f"cloud of points of another kind ({name[-4:].lower()}): convert it to .ply" in said
    assert sentence(read, tmp_path / "no.xyz").endswith("no.xyz does not exist.")


def test_a_file_that_is_too_large_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "large.json"
    path.write_bytes(WRITTEN.encode() + b" " * (2**20 - len(WRITTEN)))
    assert read(path) == Document()
    path.write_bytes(WRITTEN.encode() + b" " * (2**20 - len(WRITTEN) + 1))
    assert sentence(read, path) == f"{path} is larger than 1 MiB."
    assert sentence(read_letters, path) == f"{path} is larger than 39 KiB."
    # A picture may be larger.
    path.write_bytes(carrier(json.dumps(json.loads(DESIGN) | {"pad": "x" * 2**20})))
    assert read(path).projection == parse(DESIGN).projection


def test_a_mesh_is_named_from_the_documents_folder(tmp_path: Path) -> None:
    folder = tmp_path / "a" / "b" / "lessons"
    (folder / "parts").mkdir(parents=True)
    path = folder / "lesson.json"
    for mesh, name in (
        (folder / "bunny.stl", "bunny.stl"),
        (folder / "parts" / "Bunny.OBJ", "parts/Bunny.OBJ"),
        (folder.parent / "bunny.ply", "../bunny.ply"),
        (folder.parent.parent / "c" / "bunny.glb", "../../c/bunny.glb"),
        (tmp_path / "bunny.gltf", (tmp_path / "bunny.gltf").as_posix()),  # too far: as it is
    ):
        document = Document(str(mesh))
        write(document, path)
        assert json.loads(path.read_text(encoding="utf-8"))["scene"] == name
        assert read(path) == document
        path.write_bytes(carrier(to_json(document, folder)))
        assert read(path) == document
    # Moved together, they find each other again.
    write(Document(str(folder / "parts" / "x.stl")), path)
    folder.rename(tmp_path / "moved")
    assert read(tmp_path / "moved" / "lesson.json").scene == str(tmp_path / "moved/parts/x.stl")


def test_a_mesh_may_be_named_from_where_the_program_was_started(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "lessons").mkdir()
    monkeypatch.chdir(tmp_path)
    write(Document("bunny.stl"), "lessons/lesson.json")
    assert (
        json.loads(Path("lessons/lesson.json").read_text(encoding="utf-8"))["scene"]
        == "../bunny.stl"
    )
    assert read("lessons/lesson.json").scene == str(tmp_path / "bunny.stl")
    # Without a folder nothing is resolved, and a built-in scene never is.
    assert parse(to_json(Document("bunny.stl"))).scene == "bunny.stl"
    write(Document("cube"), "lessons/lesson.json")
    assert read("lessons/lesson.json").scene == "cube"


def test_only_document_files_are_saved_to(tmp_path: Path) -> None:
    files = {
        "a.json": DESIGN.encode(), "notes": DESIGN.encode(), "text.png": DESIGN.encode(),
        "figure": carrier(), "pic.dat": carrier(), "figure.png": carrier(), "pic.json": carrier(),
        "x.stl": b"solid",
    }  # fmt: skip
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
    held = [name for name in files if holds_document(tmp_path / name)]
    assert held == ["a.json", "notes", "text.png"]
    assert not holds_document(os.devnull) and not holds_document(tmp_path / "gone.json")


def test_mesh_endings_are_those_that_can_be_read() -> None:
    assert set(MESH_ENDINGS) == set(app.scenes.scene.ENDINGS)
    assert not is_mesh("letter-f")
    assert all(is_mesh(f"a{end}") for end in (".obj", ".STL", ".ply", ".gltf", ".Glb"))


# --------------------------------------------------------------------------- whole or not at all


def names_in(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


@pytest.mark.parametrize("step", ["chmod", "fsync", "replace"])
def test_the_old_file_stays_whole_when_a_step_fails(
    step: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "lesson.json"
    write(Document(), path)

    def fails(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, step, fails)
        found = sentence(write, PARALLEL, path)
    assert found == f"{path} cannot be written: No space left on device."
    assert path.read_text(encoding="utf-8") == WRITTEN
    assert names_in(tmp_path) == ["lesson.json"]


def test_an_interrupted_save_leaves_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(_: int) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
        patch.setattr(os, "fsync", interrupted)
        write(Document(), tmp_path / "lesson.json")
    assert names_in(tmp_path) == []


def test_content_is_on_the_disk_before_it_takes_the_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "lesson.json"
    steps: list[str] = []
    fsync, replace_file = os.fsync, os.replace

    def watched_fsync(descriptor: int) -> None:
        size = os.fstat(descriptor).st_size
        steps.append("folder" if os.path.isdir(f"/dev/fd/{descriptor}") else f"{size} bytes")
        fsync(descriptor)

    def watched_replace(source: str, target: str) -> None:
        steps.append("replace")
        assert os.path.dirname(source) == os.path.dirname(target)
        replace_file(source, target)

    monkeypatch.setattr(os, "fsync", watched_fsync)
    monkeypatch.setattr(os, "replace", watched_replace)
    write(Document(), path)
    expected = [f"{len(WRITTEN)} bytes", "replace"]
    assert steps == ([*expected, "folder"] if os.name == "posix" else expected)


def run_script(script: str, *arguments: object) -> str:
    """Run a script in a process of its own; return its output."""
    done = subprocess.run(
        [sys.executable, "-c", script, *map(str, arguments)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=PATIENCE_S,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


KILLED = """
import json, os, signal, sys
from app.document import files
from app.document.document import Document
from app.document.files import read, write

files.STALE_S = -1.0
path, found = sys.argv[1], []
write(Document(), path)
for step, is_done in (("chmod", False), ("fsync", False), ("replace", False), ("replace", True)):
    child = os.fork()
    if child == 0:
        act = getattr(os, step)
        def die(*arguments):
            if is_done:
                act(*arguments)
            os.kill(os.getpid(), signal.SIGKILL)
        setattr(os, step, die)
        try:
            write(Document("cube"), path)
        finally:
            os._exit(1)
    _, status = os.waitpid(child, 0)
    found.append([os.WTERMSIG(status), read(path).scene, len(os.listdir(os.path.dirname(path)))])
write(Document(), path)
print(json.dumps([found, os.listdir(os.path.dirname(path))]))
"""

LIMITED = """
import os, resource, sys
from app.document.document import Document
from app.document.files import read, write
from app.model.refusal import Refusal
path = sys.argv[1]
for limit in (0, 1000, 99_999, 200_000):
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, resource.RLIM_INFINITY))
    try:
        write(Document("cube", extra={"pad": "x" * 100_000}), path)
        print("written")
    except Refusal as error:
        print(error, os.listdir(os.path.dirname(path)), read(path) == Document())
"""

UNPRIVILEGED = """
import os, sys
from app.document.document import Document
from app.document.files import write
from app.model.refusal import Refusal
if os.geteuid() == 0:
    os.setgid(65534)
    os.setuid(65534)
try:
    write(Document("cube"), sys.argv[1])
except Refusal as error:
    print(error)
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="os.fork")
def test_killed_at_any_step_a_save_leaves_a_whole_document(tmp_path: Path) -> None:
    found, files = json.loads(run_script(KILLED, tmp_path / "lesson.json"))
    assert found == [*[[signal.SIGKILL, "letter-f", 2]] * 3, [signal.SIGKILL, "cube", 1]]
    assert files == ["lesson.json"], "what one leaves, the next one removes"


@pytest.mark.skipif(sys.platform == "win32", reason="no limit of a file's size")
def test_a_full_disk_leaves_the_old_file_whole(tmp_path: Path) -> None:
    path = tmp_path / "lesson.json"
    write(Document(), path)
    # The kernel writes as much as fits, then says no, as a full disk does.
    refused = f"{path} cannot be written: File too large. ['lesson.json'] True"
    assert run_script(LIMITED, path).splitlines() == [refused, refused, refused, "written"]
    assert read(path).scene == "cube"


def test_a_pipe_or_a_device_is_neither_written_to_nor_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Run by root, a program that gets this wrong would take the machine's devices away.
    monkeypatch.setattr(os, "replace", lambda *names: pytest.fail(f"replaces {names}"))
    pipe, link = tmp_path / "pipe", tmp_path / "link"
    os.mkfifo(pipe)
    link.symlink_to(pipe)
    for place in (pipe, link, Path("/dev/null"), Path("/dev/full")):
        found = sentence(write, Document(), place)
        why = "it is a pipe or a device, not a regular file"
        assert found == f"{place} cannot be written: {why}."
    assert pipe.is_fifo()


def test_a_pipe_named_like_an_unfinished_file_hangs_nobody(tmp_path: Path) -> None:
    pipe = tmp_path / ".frustum-lab-01234567.tmp"
    os.mkfifo(pipe)
    os.utime(pipe, (0, 0))
    write(Document(), tmp_path / "lesson.json")
    assert pipe.is_fifo() and names_in(tmp_path) == [pipe.name, "lesson.json"]


def test_a_trial_says_what_prevents_writing_and_changes_nothing(tmp_path: Path) -> None:
    path = tmp_path / "lesson.json"
    write(Document(), path)
    write_bytes_atomically(path, b"x", is_trial=True)
    assert read(path) == Document() and names_in(tmp_path) == ["lesson.json"]
    with pytest.raises(Refusal, match="No such file or directory"):
        write_bytes_atomically(tmp_path / "no" / "such", b"x", is_trial=True)


def test_a_read_only_folder_or_file_is_left_as_it_is() -> None:
    # Not in pytest's own folder, which nobody but its user can enter.
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        path = folder / "lesson.json"
        write(Document(), path)
        path.chmod(0o666)
        folder.chmod(0o555)
        assert run_script(UNPRIVILEGED, path) == f"{path} cannot be written: Permission denied."
        folder.chmod(0o777)
        path.chmod(0o444)
        found = run_script(UNPRIVILEGED, path)
        assert found == f"{path} cannot be written: it is write-protected."
        assert path.read_text(encoding="utf-8") == WRITTEN
        assert names_in(folder) == ["lesson.json"]
        path.chmod(0o666)
        assert run_script(UNPRIVILEGED, path) == ""
        assert read(path).scene == "cube"


def test_permissions_are_kept_and_new_files_follow_the_umask(tmp_path: Path) -> None:
    path = tmp_path / "lesson.json"
    before = os.umask(0o027)
    try:
        write(Document(), path)
        assert path.stat().st_mode & 0o7777 == 0o640
        for mode in (0o600, 0o664, 0o755):
            path.chmod(mode)
            write(PARALLEL, path)
            assert path.stat().st_mode & 0o7777 == mode
    finally:
        os.umask(before)


def test_a_link_is_followed_and_kept(tmp_path: Path) -> None:
    (tmp_path / "store").mkdir()
    target, link = tmp_path / "store" / "real.json", tmp_path / "lesson.json"
    link.symlink_to(Path("store") / "real.json")
    write(Document(), link)  # also when nothing is there yet
    assert link.is_symlink()
    assert read(target) == Document()
    write(PARALLEL, link)
    assert link.is_symlink()
    assert read(target) == read(link) == PARALLEL
    assert names_in(tmp_path) == ["lesson.json", "store"]
    assert names_in(tmp_path / "store") == ["real.json"]
    # A mesh is named from where the document really lies.
    write(Document(str(tmp_path / "store" / "x.stl")), link)
    assert json.loads(target.read_text(encoding="utf-8"))["scene"] == "x.stl"
    assert read(link).scene == str(tmp_path / "store" / "x.stl")
    # And the mesh's folder may be linked to, but the mesh keeps the name it was given.
    (tmp_path / "meshes").symlink_to("store")
    (tmp_path / "store" / "y.stl").symlink_to("../far/away/y.stl")
    write(Document(str(tmp_path / "meshes" / "y.stl")), target)
    assert json.loads(target.read_text(encoding="utf-8"))["scene"] == "y.stl"


def test_a_file_that_another_program_is_writing_is_left_alone(tmp_path: Path) -> None:
    live, dead = tmp_path / ".frustum-lab-0123abcd.tmp", tmp_path / ".frustum-lab-ffffffff.tmp"
    foreign = [tmp_path / ".frustum-lab-notes.tmp", tmp_path / "frustum-lab-0123abcd.tmp"]
    for path in (live, dead, *foreign):
        path.write_bytes(b"half")
        if path != live:
            os.utime(path, (0, time.time() - files.STALE_S - 1))
    write(Document(), tmp_path / "lesson.json")
    assert live.exists() and not dead.exists()
    assert all(path.read_bytes() == b"half" for path in foreign)


def set_value(document: Document, path: str, text: str) -> Document:
    """Set one value by its path, as ``--set`` does."""
    return set_values(document, [f"{path}={text}"])


def test_any_bytes_are_written_whole(tmp_path: Path) -> None:
    path = tmp_path / "figure.png"
    for content in (b"", b"\r\n\0\x1a\n", os.urandom(300_000)):
        write_bytes_atomically(path, content)
        assert path.read_bytes() == content
    assert names_in(tmp_path) == ["figure.png"]


# -- the view: how a document is looked at

FROM_ABOVE = Camera((9, 8, 7), (0.5, 0, 0), (0, 1, 0))
VIEWED = Document("cube", view=View(panes={"world": FROM_ABOVE}, stage=2.5, layers={"grid"}))
OLD_VIEWS = {"world": {"eye": [9, 8, 7], "target": [0.5, 0, 0], "up": [0, 1, 0]}}


def old(**more: object) -> str:
    """A document of version 1."""
    return json.dumps(json.loads(DESIGN) | {"version": 1} | more)


def test_a_view_is_written_where_it_differs_from_the_default() -> None:
    assert parse(to_json(VIEWED)).view == VIEWED.view
    assert "view" not in json.loads(to_json(Document()))
    assert json.loads(to_json(VIEWED))["view"] == {
        "stage": 2.5, "layers": ["grid"], "panes": OLD_VIEWS
    }  # fmt: skip


def test_a_probe_has_its_number_by_its_place() -> None:
    document = parse(
        with_value("view", {"probes": [None, [1, 2, 3], [640, 360], [0, 0, -1, 0]], "pinned": [2]})
    )
    probes = (
        Probe(2, (1.0, 2.0, 3.0)),
        Probe(3, None, (640.0, 360.0)),
        Probe(4, direction=(0.0, 0.0, -1.0)),
    )
    assert document.view.probes == probes and document.view.pinned == {2}
    written = json.loads(to_json(document))["view"]
    places = [None, [1, 2, 3], [640, 360], [0, 0, -1, 0]]
    assert written == {"probes": places, "pinned": [2]}


def test_documents_that_differ_in_their_view_are_equal() -> None:
    plain = replace(VIEWED, view=View())
    assert plain == VIEWED and hash(plain) == hash(VIEWED)
    assert plain.view != VIEWED.view
    assert set_values(VIEWED, ["lens.near=2"]).view == VIEWED.view


@given(documents(), st.booleans())
@settings(max_examples=60)
def test_every_document_of_version_1_opens_and_keeps_all_it_has(
    document: Document, has_views: bool
) -> None:
    """This includes a document with a strange key where the view is now."""
    tree = json.loads(to_json(replace(document, view=View(panes=document.view.panes))))
    view = tree.pop("view", {})
    cameras = view.pop("panes", {})
    tree["version"] = 1
    if has_views:
        tree["views"] = cameras
    if view:
        tree["view"] = view
    opened = parse(json.dumps(tree))
    assert opened == replace(document, extra=opened.extra)
    assert opened.view == (View(panes=document.view.panes) if has_views else View())
    again = json.loads(to_json(opened))
    assert again.pop("version") == 3
    now = again.pop("view", {})
    assert now.get("panes", {}) == (cameras if has_views else {})
    assert now.get("version 1", {}) == view
    for gone in ("version", "views", "view"):
        tree.pop(gone, None)
    assert again == tree


@pytest.mark.parametrize("strange", [7, None, [1], {"stage": "nowhere"}, "ndc"])
def test_version_1_had_no_meaning_for_view(strange: object) -> None:
    document = parse(old(view=strange, views=OLD_VIEWS))
    assert document.view == View(panes={"world": FROM_ABOVE})
    assert json.loads(to_json(document))["view"] == {"panes": OLD_VIEWS, "version 1": strange}


WRONG_CAMERAS: list[tuple[object, str]] = [
    (7, " = 7: must be an object with named values in braces."),
    ({"world": 1}, ".world = 1: must be an object with named values in braces."),
    ({"world": {"eye": [1, 2, 3]}}, ".world.target is missing."),
    (
        {"world": {"eye": [1, 2, 3], "target": [0, 0, 0], "up": [0, 0, 0]}},
        ".world.up = [0, 0, 0]: must not be the zero vector.",
    ),
    (  # what follows VTK would take for nothing
        {"world": {"eye": [1e-200, 0, 0], "target": [0, 0, 0], "up": [0, 1, 0]}},
        ".world.eye = [1e-200, 0, 0]: must be at least 1e-100 away from the target.",
    ),
    (
        {"ndc": {"eye": [1, 2, 3], "target": [0, 0, 0], "up": [0, 1e-200, 0]}},
        ".ndc.up = [0, 1e-200, 0]: must be at least 1e-100 long.",
    ),
]


@pytest.mark.parametrize(("cameras", "found"), WRONG_CAMERAS)
def test_a_wrong_camera_of_a_pane_is_named_where_the_file_has_it(
    cameras: object, found: str
) -> None:
    written = with_value("view", {"panes": cameras})
    assert sentence(parse, written) == f"view.panes{found}"
    assert sentence(parse, old(views=cameras)) == f"views{found}"


NO_PANE = f"must be one of {', '.join(PANES)}, or empty for none."
NO_STAGE = f"must be one of {', '.join(STAGES)}, or a number from -8 to 5."
NO_PANEL = f"must be one of {', '.join(PANELS)}, or empty for none."
NO_NAMES = "must be a list of at most 7 different names, or only *."
NO_LAYERS = f"must be a list of names from {', '.join(LAYERS)}."
NO_PROBE = (
    "must be three numbers for a point, four with w, two for the ray of a pixel, or null for no"
    " probe."
)
WRONG_VIEWS: list[tuple[object, str]] = [
    (7, f" = 7: {BRACES}."),
    ({"layout": ["columns"]}, ".layout = ['columns']: must be one of pictures, columns."),
    ({"large": "second-screen"}, f".large = 'second-screen': {NO_PANE}"),
    ({"large": None}, f".large = null: {NO_PANE}"),
    ({"stage": "pyramids"}, f".stage = 'pyramids': {NO_STAGE}"),
    ({"stage": -8.1}, f".stage = -8.1: {NO_STAGE}"),
    ({"stage": 5.000000000000001}, f".stage = 5.000000000000001: {NO_STAGE}"),
    ({"stage": True}, f".stage = true: {NO_STAGE}"),
    ({"stage": {}}, ".stage = {}: " + NO_STAGE),
    ({"stage": math.nan}, f".stage = NaN: {FINITE}."),
    ({"frame_step": 3}, f".frame_step = 3: must be one of {', '.join(STEPS)}."),
    ({"panel": "precision"}, f".panel = 'precision': {NO_PANEL}"),
    ({"panel": None}, f".panel = null: {NO_PANEL}"),
    ({"letters": "uvn"}, f".letters = 'uvn': must be one of {', '.join(LETTERS)}, or a file of"
     " letters of at most 10000 characters."),
    ({"layers": "grid"}, f".layers = 'grid': {NO_LAYERS}"),
    ({"layers": ["sky"]}, f".layers = ['sky']: {NO_LAYERS}"),
    ({"layers": [["grid"]]}, f".layers = [['grid']]: {NO_LAYERS}"),
    ({"names": "eye"}, f".names = 'eye': {NO_NAMES}"),
    ({"names": None}, f".names = null: {NO_NAMES}"),
    ({"names": ["eye", 3]}, f".names = ['eye', 3]: {NO_NAMES}"),
    ({"names": ["eye", "eye"]}, f".names = ['eye', 'eye']: {NO_NAMES}"),
    ({"names": ["eye", "*"]}, f".names = ['eye', '*']: {NO_NAMES}"),
    ({"names": list("ABCDEFGH")},
     f".names = ['A', 'B', 'C', 'D', 'E', 'F', 'G', 'H']: {NO_NAMES}"),
    ({"fixed": "left"}, f".fixed = 'left': must be one of {', '.join(FIXED)}, or empty for none."),
    ({"probes": {}}, ".probes = {}: must be a list of at most 6 probes."),
    ({"probes": [None] * 7}, f".probes = [{', '.join(['null'] * 7)}]: must be a list of at most 6"
                             " probes."),
    ({"probes": [[1, 2, 3], 4]}, f".probes[1] = 4: {NO_PROBE}"),
    ({"probes": [[1, True, 2]]}, f".probes[0] = [1, true, 2]: {NO_PROBE}"),
    ({"probes": [[0, 0, 0, 0]]}, ".probes[0] = [0, 0, 0, 0]: must not be 0 if x, y and z are 0:"
                                 " (0, 0, 0, 0) is neither a point nor a direction."),
    ({"probes": [[1, 2, 1e200]]}, ".probes[0] = 1e+200: must be at most 1e+100."),
    ({"probes": [None, [16385, 2]]}, ".probes[1] = 16385: must be at most 16384."),
    ({"pinned": [1]}, ".pinned = [1]: must be a list of the numbers of probes."),
    ({"pinned": 1}, ".pinned = 1: must be a list of the numbers of probes."),
    ({"pinned": [True], "probes": [[1, 2, 3]]},
     ".pinned = [true]: must be a list of the numbers of probes."),
    ({"panes": {"": 0}}, f".panes. = 0: {BRACES}."),
]  # fmt: skip


def test_a_wrong_view_is_refused_by_its_field_value_and_bound() -> None:
    for view, found in WRONG_VIEWS:
        text = with_value("view", view)
        assert sentence(parse, text) == f"view{found}"


SET_VIEWS = {
    "view.layout=columns": View(layout="columns"),
    "view.large=image": View(large="image"),
    "view.stage=pyramid": View(stage=2.0),
    "view.stage=2.25": View(stage=2.25),
    "view.frame_step=n": View(frame_step="n", panel="frame"),
    "view.panel=matrices": View(panel="matrices"),
    "view.panel=": View(panel=""),
    "view.letters=002": View(letters="002"),
    "view.layers=grid, labels": View(layers=frozenset({"grid", "labels"})),
    "view.fixed=axis": View(fixed="axis"),
    "view.names=y, y_p,P'": View(names=("y", "y_p", "P'")),
    "view.names=*": View(names=("*",)),
    "view.names=": View(names=()),
    "view.probes=1,2,3, 4,5,6": View(probes=(Probe(1, (1, 2, 3)), Probe(2, (4, 5, 6)))),
    "view.probes=": View(),
    "view.panes=ndc: 1.3,0.2,0.3": View(panes={"ndc": Camera((1.3, 0.2, 0.3), (0, 0, 0))}),
    "view.panes=world: 1,2,3,4,5,6 | ndc: 1,0,0": View(
        panes={"world": Camera((1, 2, 3), (4, 5, 6)), "ndc": Camera((1, 0, 0), (0, 0, 0))}
    ),
    "view.panes=": View(),
}


def test_a_view_is_set_by_path() -> None:
    for assignment, view in SET_VIEWS.items():
        assert set_values(Document(), [assignment]).view == view, assignment


def test_another_scene_names_its_own_things() -> None:
    named = set_values(Document(), ["view.names=near"])
    assert set_values(named, ["scene=cube"]).view.names is None
    assert set_values(named, ["scene=cube", "view.names=far"]).view.names == ("far",)


def test_what_belongs_to_a_scene_stays_there() -> None:
    kept = View(layout="columns", letters=LETTERS[1], layers=frozenset({"grid"}), fixed="top")
    view = replace(
        kept, large="ndc", panel="probe", probes=(Probe(1, pixel=(1.0, 2.0)),),
        pinned=frozenset({1}), slide=("equation",), controls=("lens.near",), equation="V",
        names=("near",), compare=(ComparedPicture(), ComparedPicture(live=True)), dividers=(0.5,),
    )  # fmt: skip
    assert without_scene(view) == kept


def test_a_step_of_the_frame_opens_its_panel_unless_another_is_set() -> None:
    found = set_values(Document(), ["view.frame_step=v", "view.panel=probe"]).view
    assert found == View(frame_step="v", panel="probe")
    assert found.step is None and View(frame_step="v", panel="frame").step == 5


SET_WRONG_VIEWS = {
    "view.stage=nan": f"view.stage = 'nan': {NO_STAGE}",
    "view.stage=6": f"view.stage = 6: {NO_STAGE}",
    "view.layers=sky,grid": f"view.layers = ['grid', 'sky']: {NO_LAYERS}",
    "view.names=A,A": f"view.names = ['A', 'A']: {NO_NAMES}",
    "view.probes=1,2,nan": "view.probes = '1,2,nan': must be the numbers x, y, z of each point",
    **{f"{path}=1": f"{path} {NEAREST}" for path in ("view.pinned", "view", "views")},
    **{
        f"view.panes={text}": f"view.panes = '{text}': must be world or ndc with the pane's eye"
        for text in ("world", "ndc: 1,2", "ndc: 1,nan,0", "image: 1,0,0", "ndc: 1,0,0|")
    },
    "view.panes=ndc: 0,0,0": "view.panes.ndc.target",
}


def test_a_wrong_value_of_a_view_cannot_be_set() -> None:
    for assignment, found in SET_WRONG_VIEWS.items():
        said = sentence(set_values, Document(), [assignment])
        assert said.startswith(found)


def test_the_nearest_name_begins_with_the_typed_text() -> None:
    assert "lens.fov_y_deg" in sentence(set_values, Document(), ["lens.fov=60"])


# --------------------------------------------------------------------------- free matrices

SHEAR = ((1.5, 0.25, 0.0, 0.0), (0.0, 2.0, 0.0, 0.0), (0.0, 0.0, -1.0, -2.0), (0.0, 0.0, -1.0, 0.0))


@pytest.mark.parametrize("former", [Perspective(), Perspective(60.0, 0.1, math.inf), Frustum()])
@pytest.mark.parametrize("view", [None, ((2.0, 0.0, 0.0, 0.0), *SHEAR[1:])])
def test_a_free_matrix_comes_back_as_it_was_written(former: Any, view: Any) -> None:
    document = Document(projection=Projection(lens=FreeMatrix(SHEAR, view, former)))
    text = to_json(document)
    assert parse(text) == document
    tree = json.loads(text)["lens"]
    assert tree["clip_from_view"][0] == [1.5, 0.25, 0, 0]
    assert ("view_from_world" in tree) == (view is not None)
    # Without the lens before, choosing one starts from the program's own.
    del tree["former"]
    lens = parse(json.dumps(json.loads(text) | {"lens": tree})).projection.lens
    assert lens == FreeMatrix(SHEAR, view)


def test_unknown_keys_stay_in_a_free_matrix_too() -> None:
    tree = json.loads(to_json(Document(projection=Projection(lens=FreeMatrix(SHEAR)))))
    tree["lens"] |= {"label": "mine"}
    tree["lens"]["former"] |= {"maker": "Zuse"}
    again = json.loads(to_json(parse(json.dumps(tree))))
    assert again["lens"]["label"] == "mine" and again["lens"]["former"]["maker"] == "Zuse"
    assert again == tree


FOUR_ROWS = "must be four rows of four finite numbers"


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({"clip_from_view": [[1, 2], [3]]}, f"lens.clip_from_view = [[1, 2], [3]]: {FOUR_ROWS}."),
        ({"clip_from_view": "abcd"}, f"lens.clip_from_view = 'abcd': {FOUR_ROWS}."),
        ({"clip_from_view": [[1, 0, "x", 0], *SHEAR[1:]]},
         "lens.clip_from_view[0, 2] = 'x': must be a finite number."),
        ({"view_from_world": [*SHEAR[:3], [0, 0, 0, 1e101]]},
         "lens.view_from_world[3, 3] = 1e+101: must be at most 1e+100."),
        ({"former": {"kind": "perspective", "fov_y_deg": 45, "near": 0, "far": 2}},
         "lens.former.near = 0: must be greater than 0."),
        ({"former": {"kind": "matrix"}},
         f"lens.former.kind = 'matrix': must be one of {', '.join(LENSES)}."),
        ({"former": 7}, "lens.former = 7: must be an object with named values in braces."),
        ({"former": {"kind": "perspective"}}, "lens.former.fov_y_deg is missing."),
    ],
)  # fmt: skip
def test_a_wrong_free_matrix_is_named(change: dict[str, Any], expected: str) -> None:
    tree = json.loads(to_json(Document(projection=Projection(lens=FreeMatrix(SHEAR)))))
    tree["lens"] |= change
    assert sentence(parse, json.dumps(tree)) == expected
    tree["lens"] = {"kind": "matrix"}
    assert sentence(parse, json.dumps(tree)) == "lens.clip_from_view is missing."


def test_set_makes_and_changes_a_free_matrix() -> None:
    made = set_values(Document(), ["lens.kind=matrix"])
    start = Document().projection
    assert made.projection == start.with_lens("matrix")
    cells = "1.5,0.25,0,0, 0,2,0,0, 0,0,-1,-2, 0,0,-1,0"
    made = set_values(Document(), ["lens.kind=matrix", f"lens.clip_from_view={cells}"])
    assert made.projection.lens == FreeMatrix(SHEAR, None, start.lens)
    back = set_values(made, ["lens.kind=perspective"])
    assert back.projection == start
    for path in ("clip_from_view", "view_from_world"):
        for text in ("1,2,3", "nan" + ",0" * 15, "1e400" + ",0" * 15, "x"):
            said = sentence(set_value, made, f"lens.{path}", text)
            assert said.startswith(f"lens.{path} = '")
            assert re.search("numbers, but has (3|nan|1e400|0)[.]$", said)
        said = sentence(set_value, made, f"lens.{path}", "1,0,0,0,1,0,0,0,1")
        assert said.endswith(f": {FOUR_ROWS}.")
        set_values(made, [f"lens.{path}=[1 0 0 5; 0 1 0 0; 0 0 1 0]"])
    said = sentence(set_value, made, "lens.near", "2")
    assert "belongs to another lens" in said
    said = sentence(set_value, Document(), "lens.clip_from_view", cells)
    assert said.endswith("belongs to another lens: set lens.kind as well (matrix).")


# --------------------------------------------------------------------------- settings


TRIANGLES = Document("similar-triangles", PHENOMENA["similar-triangles"].start)


@pytest.fixture
def everything(monkeypatch: pytest.MonkeyPatch) -> Document:
    """A document of a scene with a setting of every kind."""
    make_known(monkeypatch, EVERYTHING, called("alike"))
    return Document("everything", EVERYTHING.start)


def test_the_settings_of_a_phenomenon_are_complete_and_read_only() -> None:
    document = replace(TRIANGLES, settings={"distance": 2})
    assert dict(document.settings) == {"distance": 2.0, "point": (1.5, 5.0, 0.5)}
    with pytest.raises(TypeError):
        document.settings["distance"] = 3.0  # type: ignore[index]
    assert Document("letter-f", settings={"distance": 2.0}).settings == {}
    with pytest.raises(Refusal, match=r"settings\.distance = 0: must not be 0"):
        replace(TRIANGLES, settings={"distance": 0.0})
    with pytest.raises(Refusal, match=r"settings\.distance = nan: must be"):
        replace(TRIANGLES, settings={"distance": math.nan})


def test_documents_with_other_settings_are_other_documents() -> None:
    one, other = (replace(TRIANGLES, settings={"distance": d}) for d in (2.0, 3.0))
    assert one != other and hash(one) != hash(other)
    assert one == replace(other, settings={"distance": 2.0})
    assert hash(one) == hash(replace(other, settings={"distance": 2.0}))
    mesh = replace(one, mesh="bunny.obj")
    assert mesh != one and hash(mesh) != hash(one)


@given(st.floats(-1e6, 1e6).filter(bool), st.tuples(*[st.floats(-1e100, 1e100)] * 3))
@example(-5e-324, (-0.0, 1e-300, 0.1))
def test_settings_come_back_exactly(distance: float, place: tuple[float, float, float]) -> None:
    document = replace(TRIANGLES, settings={"distance": distance, "point": place})
    again = parse(to_json(document))
    assert again == document
    assert repr(again.settings) == repr(document.settings)  # the sign of 0, too


def test_settings_of_every_kind_come_back(everything: Document) -> None:
    document = replace(
        everything, settings={"kind": "b", "correct": False, "count": 7.0, "light": (0.5, 1, -2)}
    )
    text = to_json(document)
    assert (
        '"settings": {"gap": 2, "turn": 0, "count": 7, "kind": "b", "correct": false,'
        ' "light": [0.5, 1, -2]}'
    ) in text
    again = parse(text)
    assert again == document
    assert repr(again.settings) == repr(document.settings)  # 7.0, not 7


def test_unknown_settings_are_kept() -> None:
    tree = json.loads(with_value("scene", "similar-triangles"))
    tree["settings"] = {"distance": 2, "colour": [1, 2]}
    older = {key: value for key, value in tree.items() if key != "settings"}
    assert parse(json.dumps(older)).settings == PHENOMENA["similar-triangles"].checked({})
    document = parse(json.dumps(tree))
    assert document.extra == {"settings": {"colour": [1, 2]}}
    changed = document.with_settings({"distance": 3.0})
    assert json.loads(to_json(changed))["settings"] == {
        "distance": 3, "point": [1.5, 5, 0.5], "colour": [1, 2]
    }  # fmt: skip
    tree["scene"] = "letter-f"  # which has none of its own
    document = parse(json.dumps(tree))
    assert document.settings == {} and document.extra["settings"] == tree["settings"]
    assert json.loads(to_json(document))["settings"] == tree["settings"]


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (5, "settings = 5: must be an object with named values in braces."),
        ({"distance": 0}, "settings.distance = 0: must not be 0"),
        ({"distance": "2"}, "settings.distance = '2': must be a finite number."),
        ({"distance": True}, "settings.distance = true: must be a finite number."),
        ({"distance": 1e7}, "settings.distance = 10000000: must be at most 1000000."),
        ({"point": [1, 2]}, "settings.point = [1, 2]: must be three finite numbers x, y, z."),
    ],
)
def test_wrong_settings_are_refused_by_their_paths(value: object, expected: str) -> None:
    tree = json.loads(with_value("scene", "similar-triangles"))
    tree["settings"] = value
    assert sentence(parse, json.dumps(tree)).startswith(expected)


def test_a_mesh_in_the_place_of_a_scene_s_objects_moves_with_the_document(tmp_path: Path) -> None:
    path = tmp_path / "lesson.json"
    document = replace(TRIANGLES, mesh=str(tmp_path / "data" / "bunny.obj"))
    write(document, path)
    assert json.loads(path.read_text(encoding="utf-8"))["mesh"] == "data/bunny.obj"
    assert read(path) == document
    path.rename(tmp_path.parent / "moved.json")
    moved = tmp_path.parent / "data" / "bunny.obj"
    assert read(tmp_path.parent / "moved.json").mesh == str(moved)
    assert '"mesh"' not in to_json(TRIANGLES)


@pytest.mark.parametrize(
    ("scene", "mesh", "words"),
    [
        ("similar-triangles", "bunny", "must be the path of a mesh file (.obj, .stl"),
        ("similar-triangles", 5, "must be the path of a mesh file (.obj, .stl"),
        ("similar-triangles", "a\0.obj", "must be the path of a mesh file (.obj, .stl"),
        ("letter-f", "bunny.obj", "cannot be shown in the scene letter-f, which needs its own"),
    ],
)
def test_a_mesh_that_the_scene_cannot_show_is_refused(scene: str, mesh: object, words: str) -> None:
    tree = json.loads(with_value("scene", scene))
    tree["mesh"] = mesh
    said = sentence(parse, json.dumps(tree))
    assert said.startswith("mesh = ") and words in said


def test_settings_are_set_by_their_paths(everything: Document) -> None:
    document = set_values(
        everything,
        [
            "settings.gap = 5e-1", "settings.kind=b", "settings.correct=false",
            "settings.light= 1 ,+2.5, -3", "settings.count=8", "mesh=a=b.obj",
        ],
    )  # fmt: skip
    assert dict(document.settings) == {
        "gap": 0.5, "turn": 0.0, "count": 8.0, "kind": "b", "correct": False,
        "light": (1.0, 2.5, -3.0),
    }  # fmt: skip
    assert document.mesh == "a=b.obj"
    assert set_value(document, "settings.correct", "true").settings["correct"] is True
    assert set_value(document, "mesh", "").mesh == ""
    # Only the outcome has to be valid: the gap needs the count.
    both = ["settings.gap=500", "settings.count=64"]
    assert set_values(document, both) == set_values(document, both[::-1])


BAD_SCENE_SETTINGS = [
    ("settings.gpa=1", "settings.gpa is not known; the nearest name is settings.gap."),
    ("gap=1", "gap is not known; the nearest name is settings.gap."),
    ("settings=1", None),
    ("settings.gap=big", "settings.gap = 'big': must be a finite number."),
    ("settings.gap=nan", "settings.gap = 'nan': must be a finite number."),
    ("settings.gap=1e400", "settings.gap = '1e400': must be a finite number."),
    ("settings.gap=0", "settings.gap = 0: must be at least 0.001."),
    ("settings.gap=500", "settings.gap = 500: must be less than the count, which is 40."),
    ("settings.count=2.5", "settings.count = 2.5: must be a whole number."),
    ("settings.correct=maybe", "settings.correct = 'maybe': must be true or false."),
    ("settings.correct=1", "settings.correct = '1': must be true or false."),
    ("settings.kind=c", "settings.kind = 'c': must be one of a, b."),
    ("settings.light=1,2", "settings.light = '1,2': must be three finite numbers x, y, z."),
    ("settings.light=1,2,inf", "settings.light = '1,2,inf': must be three finite numbers x, y, z."),
    ("settings.light=1,2,1e101", "settings.light = 1e+101: must be at most 1e+100."),
]  # fmt: skip


@pytest.mark.parametrize(("assignment", "expected"), BAD_SCENE_SETTINGS)
def test_a_wrong_setting_of_a_scene_is_refused(
    everything: Document, assignment: str, expected: str | None
) -> None:
    found = sentence(set_values, everything, [assignment])
    assert expected is None or found == expected


def test_a_setting_of_another_scene_names_that_scene() -> None:
    said = sentence(set_values, parse(DESIGN), ["settings.distance=2"])
    having = [name for name, each in PHENOMENA.items() if "distance" in each.checked({})]
    where = f"set scene as well ({', '.join(having)})"
    assert said == f"settings.distance belongs to another scene: {where}."
    said = sentence(set_values, parse(DESIGN), ["settings.colour=2"])
    assert "is not known; the nearest name is" in said


def test_another_scene_brings_its_default_settings(everything: Document) -> None:
    used = replace(everything, settings={"gap": 3.0}, mesh="bunny.obj")
    moved = set_values(used, ["settings.distance=3", "scene=similar-triangles"])
    assert dict(moved.settings) == {"distance": 3.0, "point": (1.5, 5.0, 0.5)}
    assert moved.mesh == "" and moved.projection == used.projection
    assert set_values(used, ["scene=everything"]) == used
    back = set_value(moved, "scene", "everything")
    assert back.settings == EVERYTHING.checked({})
    # Also where the two call their settings alike.
    assert set_value(used, "scene", "alike").settings == EVERYTHING.checked({})


def test_the_camera_follows_a_setting_unless_it_is_set_too(everything: Document) -> None:
    followed = set_value(everything, "settings.light", "1,7,3")
    assert followed.projection.camera.eye == (5.5, 7.0, 9.5)
    assert followed == everything.with_settings({"light": (1.0, 7.0, 3.0)})
    assert set_value(everything, "settings.light", "1,3.6,3") == everything
    both = ["settings.light=1,7,3", "camera.eye=1,2,4"]
    assert set_values(everything, both).projection.camera.eye == (1.0, 2.0, 4.0)
    assert set_values(everything, both) == set_values(everything, both[::-1])
    with pytest.raises(Refusal):
        everything.with_settings({"light": (1.0, 1e101, 3.0)})
    # A camera that follows to where none can be: below its target, at it.
    at_target = replace(
        everything,
        projection=replace(
            everything.projection, camera=Camera((5.5, 1.0, 9.5), (5.5, 7.0, 9.5), (0, 0, 1))
        ),
    )
    said = sentence(set_values, at_target, ["settings.light=1,7,3"])
    assert said.startswith("camera.target = [5.5, 7, 9.5]: must differ from the eye")


@pytest.mark.parametrize("kind", LENSES)
def test_every_number_of_a_lens_is_read_as_a_number(kind: str) -> None:
    """Its kind follows from its annotation, which has to be a text."""
    numbers = {each.name for each in lens_fields(kind) if each.kind in (NUMBER, NUMBER_OR_WORD)}
    values = vars(Projection().with_lens(kind).lens)
    assert numbers >= {name for name, value in values.items() if isinstance(value, float)}
