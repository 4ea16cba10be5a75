"""What holds for every phenomenon: its data, its refusals, and that it never shows a NaN."""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.bootstrap import ROOT
from app.model.projection import LENSES, Camera, Orthographic, Perspective, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.illustration import (
    Copy,
    Curve,
    Diagram,
    Dot,
    Exhibit,
    Face,
    Line,
    Marks,
    Phenomenon,
    Phrase,
    Reading,
    Setting,
    Settings,
    Subject,
    Text,
)

EVERY = pytest.mark.parametrize("phenomenon", PHENOMENA.values(), ids=list(PHENOMENA))
PANES = ("world", "ndc", "image")


def subject_of(phenomenon: Phenomenon) -> Subject:
    quads = phenomenon.geometry()[0][0].reshape(-1, 3)
    low, high = quads.min(axis=0).tolist(), quads.max(axis=0).tolist()
    return Subject(tuple(low), tuple(high), quads)


def wild_projections(start: Projection) -> dict[str, Projection]:
    """Every lens, and the ends of what a projection can be."""
    camera = start.camera
    away = dataclasses.replace(start, camera=Camera(camera.target, camera.eye, camera.up))
    near_far = (start.lens.near, start.lens.far)
    return {
        **{kind: start.with_lens(kind) for kind in LENSES if kind != "matrix"},
        **{depth: dataclasses.replace(start, depth=depth) for depth in ("direct3d", "reversed")},
        "far inf": dataclasses.replace(start, lens=Perspective(45.0, near_far[0], math.inf)),
        "reversed inf": dataclasses.replace(
            start, lens=Perspective(45.0, near_far[0], math.inf), depth="reversed"
        ),
        "looking away": away,
        "narrow": dataclasses.replace(start, lens=Perspective(1e-80, 1e-200, 1e90)),
        "wide": dataclasses.replace(start, lens=Perspective(179.9999, 1e-6, 1e6)),
        "near far": dataclasses.replace(start, lens=Perspective(45.0, 1.0, math.nextafter(1.0, 2))),
        "far away": dataclasses.replace(
            start, camera=Camera((1e90, 2e90, 1e90), (1e89, 0.0, 0.0), (0.0, 1.0, 0.0))
        ),
        "inside": dataclasses.replace(
            start, camera=Camera(camera.target, (0.0, camera.target[1], -9.0), camera.up)
        ),
        "flat image": dataclasses.replace(start, image_size=(16384, 1)),
        "huge box": dataclasses.replace(start, lens=Orthographic(-1e90, 1e90, -1e90, 1e90)),
        "tiny box": dataclasses.replace(start, lens=Orthographic(-1e-190, 1e-190, -1e-190, 1e-190)),
    }


def wild_settings(phenomenon: Phenomenon) -> list[Settings]:
    """Each setting at its ends and its choices, the others at their defaults."""
    found = [phenomenon.defaults]
    for setting in phenomenon.settings:
        values: list[Any] = []
        if isinstance(setting.default, bool):
            values = [True, False]
        elif isinstance(setting.default, str):
            values = [name for name, _ in setting.choices]
        elif isinstance(setting.default, tuple):
            ends = (max(setting.low, -1e90), min(setting.high, 1e90))
            values = [(a, b, c) for a in ends for b in ends for c in ends]
        else:
            values = [max(setting.low, -1e90), min(setting.high, 1e90)]
            values += list(setting.span or ())
        for value in values:
            try:
                found.append(phenomenon.checked({**phenomenon.defaults, setting.name: value}))
            except Refusal as error:
                assert error.field.startswith("settings."), error
    return found


def numbers_of(exhibit: Exhibit) -> dict[str, np.ndarray]:
    """Every number that would be drawn or read, but a curve's breaks."""
    found: dict[str, np.ndarray] = {}
    for pane in PANES:
        marks: Marks = getattr(exhibit, pane)
        parts: list[Any] = [line.points for line in marks.lines]
        parts += [face.points for face in marks.faces]
        parts += [dot.point for dot in marks.dots] + [text.point for text in marks.texts]
        size = 2 if pane == "image" else 3
        for part in parts:
            assert np.shape(part)[-1] == size, (pane, part)
        found[pane] = np.concatenate([np.ravel(part) for part in parts]) if parts else np.zeros(0)
    found["copies"] = np.array([copy.world_from_world for copy in exhibit.copies]).ravel()
    values: list[float] = []
    for reading in exhibit.readings:
        if isinstance(reading.value, tuple):
            values += reading.value
        elif isinstance(reading.value, (int, float)):
            values.append(reading.value)
        elif reading.value is None:
            said = reading.note is not None or reading.counted  # not counted yet
            assert said, f"{reading.label} has no value and says nothing"
    found["readings"] = np.array(values, dtype=float)
    for diagram in exhibit.diagrams:
        assert diagram.curves, diagram.title
        found[f"window of {diagram.title}"] = np.array(
            [diagram.left, diagram.right, diagram.bottom, diagram.top]
        )
        assert diagram.left != diagram.right and diagram.bottom != diagram.top, diagram.title
        for curve in diagram.curves:
            assert not np.isinf(curve.points).any(), diagram.title
    return found


def check(phenomenon: Phenomenon, exhibit: Exhibit) -> None:
    for name, numbers in numbers_of(exhibit).items():
        assert np.isfinite(numbers).all(), (name, numbers[~np.isfinite(numbers)])


@EVERY
def test_the_data_are_whole(phenomenon: Phenomenon) -> None:
    assert re.fullmatch(r"[a-z]+(-[a-z]+)*", phenomenon.name)
    assert 1 <= phenomenon.explanation.count(". ") + 1 <= 4
    assert phenomenon.lectures and list(phenomenon.lectures) == sorted(set(phenomenon.lectures))
    assert set(phenomenon.lectures) <= {"000", "001", "002", "003", "004"}
    said = set(re.findall(r"\b00\d\b", phenomenon.explanation))
    assert said <= set(phenomenon.lectures)
    names = [setting.name for setting in phenomenon.settings]
    assert len(set(names)) == len(names)
    for setting in phenomenon.settings:
        assert re.fullmatch(r"[a-z][a-z0-9_]*", setting.name)
        assert setting.label and setting.tip
        assert setting.checked(setting.default) == setting.default
    assert phenomenon.checked({}) == phenomenon.defaults
    (faces, rgb), (lines, line_rgb) = phenomenon.geometry()
    assert faces.shape[1:] == (4, 3) and rgb.shape == (len(faces), 3) and rgb.dtype == np.uint8
    assert lines.shape[1:] == (2, 3) and line_rgb.shape == (len(lines), 3)
    assert np.isfinite(faces).all() and np.isfinite(lines).all()


@EVERY
def test_the_start_shows_the_subject(phenomenon: Phenomenon) -> None:
    trace = phenomenon.start.trace(subject_of(phenomenon).points)
    assert (~trace.outside.any(axis=1)).mean() > 0.2


@EVERY
def test_the_defaults_keep_the_start(phenomenon: Phenomenon) -> None:
    defaults = phenomenon.defaults
    assert phenomenon.follow(phenomenon.start, defaults, defaults) == phenomenon.start


@EVERY
def test_the_defaults_read_and_draw_something(phenomenon: Phenomenon) -> None:
    exhibit = phenomenon.show(phenomenon.start, phenomenon.defaults, subject_of(phenomenon))
    check(phenomenon, exhibit)
    assert exhibit.warning is None
    assert any(reading.value is not None for reading in exhibit.readings)


@EVERY
def test_no_projection_and_no_setting_shows_a_nan(phenomenon: Phenomenon) -> None:
    subject = subject_of(phenomenon)
    for settings in wild_settings(phenomenon):
        check(phenomenon, phenomenon.show(phenomenon.start, settings, subject))
    for name, projection in wild_projections(phenomenon.start).items():
        try:
            check(phenomenon, phenomenon.show(projection, phenomenon.defaults, subject))
        except Exception as error:
            error.add_note(name)
            raise


@EVERY
def test_settings_that_move_the_camera_give_a_projection_or_one_sentence(
    phenomenon: Phenomenon,
) -> None:
    defaults = phenomenon.defaults
    for name, projection in wild_projections(phenomenon.start).items():
        for settings in wild_settings(phenomenon):
            try:
                followed = phenomenon.follow(projection, defaults, settings)
            except Refusal:
                continue
            except Exception as error:
                error.add_note(f"{name}: {dict(settings)}")
                raise
            assert isinstance(followed, Projection)


@EVERY
def test_bad_settings_are_refused_by_name(phenomenon: Phenomenon) -> None:
    for setting in phenomenon.settings:
        for value in ("nonsense", math.nan, None, (1.0, 2.0), math.inf):
            with pytest.raises(Refusal) as caught:
                phenomenon.checked({setting.name: value})
            assert caught.value.field == setting.path


SETTING = Setting("size", "Size", "How large it is", 2.0, low=1.0, high=5.0, whole=True)


@pytest.mark.parametrize("value", [0.5, 6.0, 2.5, True, "2", math.nan])
def test_a_number_has_bounds(value: object) -> None:
    with pytest.raises(Refusal, match=r"^settings\.size = "):
        SETTING.checked(value)


def test_a_phrase_is_translated_before_it_is_filled_in() -> None:
    phrase = Phrase("{0} of {1}", ("1", "2"))
    assert phrase.sentence() == "1 of 2"
    assert phrase.sentence({"{0} of {1}": "{1} od {0}"}.__getitem__) == "2 od 1"


def texts_shown(exhibit: Exhibit) -> set[str]:
    """Every text of an exhibit that must be translated."""
    found = {reading.label for reading in exhibit.readings}
    found |= {reading.value for reading in exhibit.readings if isinstance(reading.value, str)}
    found |= {reading.note.template for reading in exhibit.readings if reading.note is not None}
    for diagram in exhibit.diagrams:
        found |= {diagram.title, diagram.x_label, diagram.y_label}
        found |= {curve.label for curve in diagram.curves}
    if exhibit.warning is not None:
        found.add(exhibit.warning.template)
    return found


def marked_texts() -> set[str]:
    """What lupdate will find: the literals inside QT_TRANSLATE_NOOP("phenomena", ...)."""
    import ast

    found: set[str] = set()
    files = [*Path(ROOT, "app", "scenes", "phenomena").glob("*.py")]
    for path in sorted([*files, *Path(ROOT, "app", "model", "lenses").glob("*.py")]):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "QT_TRANSLATE_NOOP":
                context, text = (ast.literal_eval(part) for part in node.args)
                assert context in ("phenomena", "Refusal", "Lens"), text
                found.add(text)
    return found


@EVERY
def test_every_text_can_be_translated(phenomenon: Phenomenon) -> None:
    """A text without a word of its own (``x_p = d·x / w``) is the same in every language."""
    subject = subject_of(phenomenon)
    shown = {phenomenon.title, phenomenon.explanation}
    for setting in phenomenon.settings:
        shown |= {setting.label, setting.tip, *(label for _, label in setting.choices)}
    for settings in wild_settings(phenomenon):
        shown |= texts_shown(phenomenon.show(phenomenon.start, settings, subject))
    for projection in wild_projections(phenomenon.start).values():
        shown |= texts_shown(phenomenon.show(projection, phenomenon.defaults, subject))
    words = re.compile(r"(?!arctan|atan|cot|tan|sin|cos)\b[^\W\d_]{3,}")
    missing = {text for text in shown - marked_texts() if words.search(text)}
    assert not missing


def test_marks_are_plain_data() -> None:
    points = np.zeros((2, 3))
    marks = Marks((Line(points),), (Face(points),), (Dot(points[0]),), (Text("P", points[0]),))
    exhibit = Exhibit(
        (Reading("w", 1.0),),
        world=marks,
        copies=(Copy(np.eye(4)),),
        diagrams=(Diagram("t", (Curve(points[:, :2]),), 0.0, 1.0, 0.0, 1.0),),
    )
    assert numbers_of(exhibit)["world"].size == 2 * 3 + 2 * 3 + 3 + 3


@EVERY
def test_where_a_parallel_lens_makes_the_explanation_untrue_that_is_said(
    phenomenon: Phenomenon,
) -> None:
    """But for the scenes that are about such lenses, or for which it makes no difference."""
    holds = {
        "view-volumes",
        "depth-buffer",
        "oblique-drawing",
        "planar-shadow",
        "far-plane-popping",
    }
    for kind in ("orthographic", "oblique"):
        projection = phenomenon.start.with_lens(kind)
        exhibit = phenomenon.show(projection, phenomenon.defaults, subject_of(phenomenon))
        said = [exhibit.warning, *(reading.note for reading in exhibit.readings)]
        assert any(
            note is not None and re.search("parallel lens|perspective lens", note.template)
            for note in said
        ) == (phenomenon.name not in holds)
