"""The table of parameters: each is read and changed, and its texts are those of the model."""

from collections.abc import Collection
from dataclasses import fields
from typing import get_args

import pytest

from app.model import parameters
from app.model.chain import FiveTiles
from app.model.lenses.oblique import OBLIQUE_PRESETS
from app.model.limits import DEPTH_RANGES, Keep
from app.model.parameter import Parameter
from app.model.parameters import PARAMETERS, lenses_with
from app.model.projection import LENSES, Camera, Projection
from tests.support.lenses import ONE_OF_EACH


@pytest.mark.parametrize("name", [name for name in PARAMETERS if name not in parameters.TILES])
def test_a_value_that_is_put_is_read_again(name: str) -> None:
    each = PARAMETERS[name]
    for kind in lenses_with(each) or LENSES:
        projection = Projection(lens=ONE_OF_EACH[kind])
        value = each.choices[-1][0] if each.choices else each.value(projection)
        put = each.put(projection, value)
        assert each.value(put) == (value if each.choices else pytest.approx(value))
        assert put.image_size[1] == projection.image_size[1]


def test_each_field_of_camera_object_and_lenses_is_a_parameter() -> None:
    owners = (Camera, FiveTiles, *LENSES.values())
    names = {field.name for owner in owners for field in fields(owner)}
    assert names - {"order"} <= PARAMETERS.keys()


@pytest.mark.parametrize(
    ("each", "values"),
    [
        (parameters.PRESET, OBLIQUE_PRESETS),
        (parameters.ASPECT, parameters.ASPECTS),
        (parameters.DEPTH, DEPTH_RANGES),
        (parameters.KEEP, get_args(Keep)),
    ],
)
def test_the_choices_are_the_model_s(each: Parameter, values: Collection[str]) -> None:
    assert [name for name, _ in each.choices] == list(values)
    assert all(each.tips)


def test_a_lens_has_the_parameters_that_its_numbers_need() -> None:
    assert lenses_with(parameters.FOV_Y) == lenses_with(parameters.FOV_X) == ("perspective",)
    assert lenses_with(parameters.RECEDING) == ("oblique",)
    assert lenses_with(parameters.FX) == ("perspective", "frustum")
    assert lenses_with(parameters.NEAR) == tuple(LENSES)
    assert lenses_with(parameters.KIND) == lenses_with(parameters.EYE) == ()
