"""What holds for every phenomenon: its data, its refusals, and that it never shows a NaN."""

import ast
import functools
import inspect
import math
import random
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.model.lenses import central, oblique, orthographic
from app.model.limits import PLANES
from app.model.parameter import Parameter, Settings
from app.model.projection import Projection
from app.model.refusal import Refusal
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.illustration import Illustration, Phenomenon
from app.scenes.phenomena.words import Phrase
from tests.oracles.illustrations import assert_sound, projections, subject_of
from tests.support.lenses import ONE_OF_EACH
from tests.support.marked import marked
from tests.texts import content_texts

EVERY = pytest.mark.parametrize("phenomenon", PHENOMENA.values(), ids=list(PHENOMENA))
LEAST_SEEN = {
    "view-volumes": 0.3, "off-axis-window": 0.75, "eye-plane": 0.4, "far-plane-popping": 0.14,
    "focus": 0.9, "clipping": 0.4, "vertex-depth": 0.8,
    "cracks": 0.45,
}  # fmt: skip
"""The least share of the subject in the picture, for scenes that leave some of it out."""


def values_of(setting: Parameter) -> list[Any]:
    """Its choices, or its default and its bounds; for a point also tiny coordinates."""
    if isinstance(setting.default, bool):
        return [True, False]
    if isinstance(setting.default, str):
        return [name for name, _ in setting.choices]
    low, high = max(setting.low, -1e100), min(setting.high, 1e100)
    if isinstance(setting.default, tuple):
        ends = [(low, high, low), (high, low, high), (high, high, low), (0.0, high, 0.0)]
        tiny = [(0.0, 5e-324, 0.0), (1e-300, 0.0, 0.0), (1.0, 1e-40, 0.0), (0.0, 0.0, 0.0)]
        return [setting.default, *ends, *tiny]
    return [setting.default, low, high, *(setting.span or ())]


def wild_settings(phenomenon: Phenomenon) -> list[Settings]:
    """Each setting at each of its values alone, and random combinations."""
    dice = random.Random(1)
    values = {setting.name: values_of(setting) for setting in phenomenon.settings}
    tried: list[dict[str, Any]] = [{}]
    tried += [{name: value} for name, many in values.items() for value in many]
    tried += [{name: dice.choice(many) for name, many in values.items()} for _ in range(100)]
    found = []
    for each in tried:
        try:
            found.append(phenomenon.checked(each))
        except Refusal as error:
            assert error.field.startswith("settings."), error
    assert phenomenon.settings == () or len(found) > 20
    return found


@EVERY
def test_the_data_are_whole(phenomenon: Phenomenon) -> None:
    assert re.fullmatch(r"[a-z]+(-[a-z]+)*", phenomenon.name)
    assert 1 <= phenomenon.words.explanation.count(". ") + 1 <= 5
    assert phenomenon.lectures and list(phenomenon.lectures) == sorted(set(phenomenon.lectures))
    assert set(phenomenon.lectures) <= {"000", "001", "002", "003", "004"}
    said = set(re.findall(r"\b00\d\b", phenomenon.words.explanation))
    assert said <= set(phenomenon.lectures)
    names = [setting.name for setting in phenomenon.settings]
    assert len(set(names)) == len(names)
    for setting in phenomenon.settings:
        assert re.fullmatch(r"[a-z][a-z0-9_]*", setting.name)
        assert setting.title and setting.tip
        assert setting.checked(setting.default) == setting.default
    assert phenomenon.checked({}) == {each.name: each.default for each in phenomenon.settings}
    (faces, rgb), (lines, line_rgb) = phenomenon.geometry()
    assert faces.shape[1:] == (4, 3) and rgb.shape == (len(faces), 3) and rgb.dtype == np.uint8
    assert lines.shape[1:] == (2, 3) and line_rgb.shape == (len(lines), 3)
    assert np.isfinite(faces).all() and np.isfinite(lines).all()


@EVERY
def test_the_start_shows_the_subject(phenomenon: Phenomenon) -> None:
    trace = phenomenon.start.trace(subject_of(phenomenon).points)
    assert (~trace.outside.any(axis=1)).mean() > LEAST_SEEN.get(phenomenon.name, 0.999)


@EVERY
def test_the_defaults_keep_the_start(phenomenon: Phenomenon) -> None:
    defaults = phenomenon.checked({})
    assert phenomenon.follow(phenomenon.start, defaults, defaults) == phenomenon.start


@EVERY
def test_the_defaults_read_and_draw_something(phenomenon: Phenomenon) -> None:
    illustration = phenomenon.show(phenomenon.start, phenomenon.checked({}), subject_of(phenomenon))
    assert_sound(phenomenon, illustration, phenomenon.start)
    assert illustration.warning is None
    assert any(reading.value is not None for reading in illustration.readings)


def texts_shown(illustration: Illustration) -> set[str]:
    """Every text of an illustration that must be translated."""
    readings, diagrams = illustration.readings, illustration.diagrams
    phrases = [illustration.warning, *(reading.note for reading in readings)]
    found = {phrase.template for phrase in phrases if phrase is not None}
    found |= {reading.label for reading in readings}
    found |= {reading.value for reading in readings if isinstance(reading.value, str)}
    for diagram in diagrams:
        found |= {diagram.title, diagram.x_label, diagram.y_label}
        found |= {curve.label for curve in diagram.curves}
    return found


@EVERY
def test_no_projection_and_no_setting_shows_a_nan_or_a_text_without_translation(
    phenomenon: Phenomenon,
) -> None:
    """Each projection with a few settings, so that all settings are tried.

    A text without a word of its own (``x_p = d·x / w``) is the same in every language.
    """
    subject, every, followed = subject_of(phenomenon), wild_settings(phenomenon), 0
    shown: set[str] = set()
    for settings in every:
        shown |= texts_shown(phenomenon.show(phenomenon.start, settings, subject))

    def check(seen: Projection, settings: Settings) -> None:
        illustration = phenomenon.show(seen, settings, subject)
        assert_sound(phenomenon, illustration, seen)
        shown.update(texts_shown(illustration))

    for index, projection in enumerate(projections(phenomenon)):
        for settings in every[index % 72 :: 72]:
            try:
                check(projection, settings)
                seen = phenomenon.follow(projection, phenomenon.checked({}), settings)
                if seen != projection:
                    followed += 1
                    check(seen, settings)
            except Refusal as error:
                assert str(error).endswith(".")
            except Exception as error:
                error.add_note(f"{projection}: {dict(settings)}")
                raise
    assert (followed > 12) == (phenomenon.follow is not Phenomenon.follow)
    words = re.compile(r"(?!arctan|atan|cot|tan|sin|cos)\b[^\W\d_]{3,}")
    assert not {text for text in shown - marked_texts() if words.search(text)}


@functools.cache
def marked_texts() -> set[str]:
    """What is translated: read once for all phenomena."""
    return content_texts() | marked(central, oblique, orthographic, context="phenomena")


def bad_values(setting: Parameter) -> list[Any]:
    """Values of other kinds, and numbers just beyond the bounds."""
    bad = ["nonsense", math.nan, None, (1.0, 2.0), (0.0, math.inf, 0.0), math.inf]
    if isinstance(setting.default, float):
        low, high = setting.low, setting.high
        bad += [True, math.nextafter(low, -math.inf), math.nextafter(high, math.inf)]
        bad += [setting.default + 0.5] if setting.whole else []
    return bad


@EVERY
def test_bad_settings_are_refused_by_name(phenomenon: Phenomenon) -> None:
    for setting in phenomenon.settings:
        for value in bad_values(setting):
            with pytest.raises(Refusal) as caught:
                phenomenon.checked({setting.name: value})
            assert caught.value.field == setting.path, value


def test_a_phrase_is_translated_before_its_numbers_are_filled_in() -> None:
    phrase = Phrase("{0} of {1}", (-1 / 3, "2"))
    assert phrase.sentence() == "\N{MINUS SIGN}0.3333 of 2"
    assert phrase.sentence({"{0} of {1}": "{1} od {0}"}.__getitem__) == "2 od \N{MINUS SIGN}0.3333"
    assert phrase.sentence(write=repr) == "-0.3333333333333333 of 2"


@EVERY
def test_the_code_uses_every_word_of_the_content_file(phenomenon: Phenomenon) -> None:
    """A name that the file lacks is a KeyError; a name that nothing uses is found here."""
    source = ast.parse(Path(inspect.getfile(phenomenon.show)).read_text(encoding="utf-8"))
    used = {node.value for node in ast.walk(source) if isinstance(node, ast.Constant)}
    used |= {"parallel", *PLANES}
    for key in phenomenon.words:  # or put together, from "kind-" and 1
        hyphen = key.find("-")
        assert used & {key, key[: hyphen + 1], key[hyphen:]}, key


@EVERY
def test_every_camera_and_lens_has_its_settings(phenomenon: Phenomenon) -> None:
    """Also a parallel lens whose near plane goes through the eye."""
    for projection in projections(phenomenon):
        assert phenomenon.at_hand(projection, phenomenon.checked({})).keys() == (
            phenomenon.checked({}).keys()
        )


@EVERY
def test_a_phenomenon_that_a_parallel_lens_does_not_show_says_so(phenomenon: Phenomenon) -> None:
    for kind in (kind for kind, lens in ONE_OF_EACH.items() if lens.parallel):
        projection = phenomenon.start.with_lens(kind)
        illustration = phenomenon.show(projection, phenomenon.checked({}), subject_of(phenomenon))
        notes = [illustration.warning, *(reading.note for reading in illustration.readings)]
        said = any(note is not None and "parallel lens" in note.template for note in notes)
        assert said == ("parallel" in set(phenomenon.words))
