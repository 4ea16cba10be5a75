"""The phenomena of lenses and drawings at the limits of the model: no NaN, no exception."""

from __future__ import annotations

import itertools

import pytest

from app.model.refusal import Refusal
from app.scenes.phenomena import (
    field_of_view,
    oblique_drawing,
    off_axis_window,
    vanishing_points,
    view_volumes,
)
from app.scenes.phenomena.illustration import Phenomenon
from tests.oracles.exhibits import assert_sound, projections, subject_of

SHOWN = [
    module.PHENOMENON
    for module in (
        field_of_view, view_volumes, off_axis_window, oblique_drawing, vanishing_points,
    )
]  # fmt: skip
NAMES = [phenomenon.name for phenomenon in SHOWN]


def combinations(phenomenon: Phenomenon) -> list[dict[str, object]]:
    """Every choice with every switch, numbers at their default and at their ends."""
    axes = []
    for setting in phenomenon.settings:
        if setting.choices:
            axes.append([(setting.name, name) for name, _ in setting.choices])
        elif isinstance(setting.default, bool):
            axes.append([(setting.name, False), (setting.name, True)])
        else:
            values = (setting.default, setting.low, setting.high)
            axes.append([(setting.name, value) for value in values])
    return [dict(each) for each in itertools.product(*axes)]


@pytest.mark.parametrize("phenomenon", SHOWN, ids=NAMES)
def test_every_projection_can_be_shown_with_all_settings(phenomenon: Phenomenon) -> None:
    subject = subject_of(phenomenon)
    every = [phenomenon.checked(values) for values in combinations(phenomenon)]
    for index, projection in enumerate(projections(phenomenon)):
        # A few of many for each, and all of them over the projections.
        for settings in every[index % 7 :: max(1, len(every) // 8)]:
            assert_sound(phenomenon.show(projection, settings, subject), projection)


@pytest.mark.parametrize("phenomenon", SHOWN, ids=NAMES)
def test_every_setting_is_followed_or_refused_in_a_sentence(phenomenon: Phenomenon) -> None:
    subject = subject_of(phenomenon)
    followed = 0
    for projection in projections(phenomenon):
        for values in combinations(phenomenon)[::5]:
            settings = phenomenon.checked(values)
            try:
                seen = phenomenon.follow(projection, phenomenon.defaults, settings)
            except Refusal as error:
                assert str(error).endswith(".")
                continue
            followed += 1
            assert_sound(phenomenon.show(seen, settings, subject), seen)
    assert followed > 50


@pytest.mark.parametrize("phenomenon", SHOWN, ids=NAMES)
def test_the_start_is_where_the_defaults_lead(phenomenon: Phenomenon) -> None:
    defaults = phenomenon.defaults
    assert phenomenon.follow(phenomenon.start, defaults, defaults) == phenomenon.start
    assert phenomenon.show(phenomenon.start, defaults, subject_of(phenomenon)).warning is None


@pytest.mark.parametrize("phenomenon", SHOWN, ids=NAMES)
def test_the_start_shows_the_whole_subject(phenomenon: Phenomenon) -> None:
    """But for what the volumes are there to leave out, and what is beside a window."""
    trace = phenomenon.start.trace(subject_of(phenomenon).points)
    inside = (~trace.outside.any(axis=1)).mean()
    assert inside > {"view-volumes": 0.3, "off-axis-window": 0.75}.get(phenomenon.name, 0.999)


@pytest.mark.parametrize("phenomenon", SHOWN, ids=NAMES)
def test_words_are_sentences_for_translators(phenomenon: Phenomenon) -> None:
    assert 2 <= phenomenon.explanation.count(". ") + 1 <= 4
    assert phenomenon.explanation.endswith(".")
