"""The tree of planar projections of lecture 002: conditions and scale factors."""

import math
from dataclasses import replace

import pytest

from app.lecture.kinds import AXES, KINDS, TOLERANCE, kind_of, path, scale_factors, with_kind
from app.model.infinity import trace_at_infinity
from app.model.lenses.oblique import oblique_angles
from app.model.projection import Camera, Frustum, Oblique, Orbit, Orthographic, Projection
from app.scenes.phenomena.vanishing_points import PHENOMENON
from app.scenes.scene import load

STARTS = {
    "letter-f": load("letter-f").start,
    "vanishing-points": load("vanishing-points").start,
    "oblique-drawing": load("oblique-drawing").start,
    "off-axis": replace(load("letter-f").start, lens=Frustum(-1.0, 3.0, -0.5, 2.0, 2.0, 30.0)),
}
PARENTS = {kind.parent for kind in KINDS.values()}


@pytest.mark.parametrize("start", STARTS)
def test_l12_each_node_sets_what_it_says(start: str) -> None:
    before = STARTS[start]
    for name in KINDS:
        found = with_kind(before, name)
        now = kind_of(found)
        assert now is not None and name in path(now)
        assert now == name or name in PARENTS, "a leaf is itself"
        assert with_kind(found, name) is found
        assert found.camera.target == before.camera.target
        assert found.camera.distance == pytest.approx(before.camera.distance, rel=1e-12)


THIRD = math.sqrt(2.0 / 3.0)
FACTORS = {
    "isometric": (THIRD, THIRD, THIRD),
    # From (1, 1, sqrt 7)/3: sqrt(1 - 1/9), twice, and sqrt(1 - 7/9).
    "dimetric": (math.sqrt(8.0) / 3.0, math.sqrt(8.0) / 3.0, math.sqrt(2.0) / 3.0),
    "front": (1.0, 1.0, 0.0),
    "top": (1.0, 0.0, 1.0),
    "side": (0.0, 1.0, 1.0),
    "cavalier": (1.0, 1.0, 1.0),
    "cabinet": (1.0, 1.0, 0.5),
}


@pytest.mark.parametrize("kind", FACTORS)
def test_l12_scale_factors_are_those_of_the_textbook(kind: str) -> None:
    found = with_kind(STARTS["letter-f"], kind)
    # The picture's size and stretch do not matter.
    lens = replace(found.lens, left=-1.0, right=7.0, keep="stretch")  # type: ignore[call-arg]
    for each in (found, replace(found, lens=lens)):
        assert scale_factors(each) == pytest.approx(FACTORS[kind], abs=1e-15, rel=1e-14)


def test_l12_the_trimetric_drawing_has_three_scales() -> None:
    """With azimuth a and elevation e they are the components across the line of sight."""
    found = scale_factors(with_kind(STARTS["letter-f"], "trimetric"))
    a, e = math.radians(30.0), math.radians(20.0)
    sight = math.cos(e) * math.sin(a), math.sin(e), math.cos(e) * math.cos(a)
    assert found == pytest.approx([math.sqrt(1.0 - part**2) for part in sight], rel=1e-14)
    squares = sum(part**2 for part in found or ())
    assert squares == pytest.approx(2.0, rel=1e-14)  # as for every orthographic picture


def test_l12_a_perspective_has_as_many_vanishing_points_as_its_name_says() -> None:
    for points in (1, 2, 3):
        found = with_kind(STARTS["letter-f"], f"{points}-point")
        both = [
            trace_at_infinity(found, (s * x, s * y, s * z)).in_front
            for x, y, z in AXES
            for s in (1.0, -1.0)
        ]
        assert sum(map(bool, both)) == points and scale_factors(found) is None


ORTHOGRAPHIC = Orthographic(-4.0, 4.0, -3.0, 3.0, 1.0, 30.0)


def seen(azimuth_deg: float, elevation_deg: float, roll_deg: float = 0.0) -> Projection:
    orbit = Orbit(azimuth_deg, elevation_deg, 10.0, roll_deg)
    return Projection(Camera.from_orbit((0.0, 1.0, 0.0), orbit), ORTHOGRAPHIC)


@pytest.mark.parametrize(
    ("projection", "kind"),
    [
        (seen(45.0, 35.26), "isometric"),  # as it is typed
        (seen(-135.0, -35.2644), "isometric"),
        (seen(45.0, 35.3), "dimetric"),
        (seen(44.9, 35.26), "trimetric"),
        (seen(45.0, 0.0), "dimetric"),
        (seen(30.0, 0.0), "trimetric"),
        (seen(0.0, 0.0, 20.0), "front"),
        (seen(180.0, 0.0), "multiview"),  # from behind
        (seen(0.0, -90.0), "multiview"),  # from below
        (seen(0.003, 0.003), "front"),
        (seen(0.01, 0.0), "trimetric"),
    ],
)
def test_l12_the_kind_follows_from_the_camera_alone(projection: Projection, kind: str) -> None:
    assert kind_of(projection) == kind


@pytest.mark.parametrize(
    ("receding", "direction_deg", "kind"),
    [
        (1.0, 30.0, "cavalier"),
        (0.5, -120.0, "cabinet"),
        (0.5 + 2.0 * TOLERANCE, 45.0, "oblique"),
        (0.7, 45.0, "oblique"),
        (0.0, 45.0, "front"),
    ],
)
def test_l12_an_oblique_drawing_is_known_by_its_receding_scale(
    receding: float, direction_deg: float, kind: str
) -> None:
    front = replace(seen(0.0, 0.0), lens=Oblique(-4.0, 4.0, -3.0, 3.0, 1.0, 30.0))
    found = front.with_angles(*oblique_angles(receding, direction_deg))
    assert kind_of(found) == kind
    assert (scale_factors(found) or ())[2] == pytest.approx(receding, abs=1e-15, rel=1e-12)
    turned = replace(found, camera=seen(20.0, 10.0).camera)
    assert kind_of(turned) == ("oblique" if receding else "trimetric")


def test_l12_a_typed_matrix_is_none_of_them_until_one_is_chosen() -> None:
    typed = STARTS["letter-f"].with_lens("matrix")
    assert kind_of(typed) is None and scale_factors(typed) is None
    for name in KINDS:
        assert name in path(kind_of(with_kind(typed, name)) or "planar")


def test_l12_the_scene_s_own_choice_is_found_again() -> None:
    for points in (1, 2, 3):
        found = with_kind(PHENOMENON.start, f"{points}-point")
        settings = PHENOMENON.implied(found, PHENOMENON.checked({"points": "free"}))
        assert settings["points"] == str(points)
    isometric = with_kind(PHENOMENON.start, "isometric")
    assert PHENOMENON.implied(isometric, PHENOMENON.checked({}))["points"] == "free"
