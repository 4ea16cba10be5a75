"""Depth at the vertices: the formula against a search, and the moved vertices against VTK's rule.

The rule: NDC z is interpolated linearly on the screen, whatever it means.
"""

from dataclasses import replace

import mpmath
import numpy as np
import pytest

from app.measure.vertex_depth import PIECES, measure
from app.model.projection import Array, Camera, Projection
from app.model.refusal import Refusal
from app.scenes.fewer_triangles import LEAST_TRIANGLES, can_be_reduced, reduced, shares_for_dragging
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.vertex_depth import MOST_PIECES, PHENOMENON, borders, largest_factor
from app.scenes.scene import load
from tests.oracles.illustrations import showing, subject_of, value

START = PHENOMENON.start
shown = showing(PHENOMENON, subject_of(PHENOMENON))
FLOOR = 2 * MOST_PIECES + 2


def to_far(far: float) -> Projection:
    return replace(START, lens=START.lens.replaced(far=far))


def factor(r: float, s: float) -> mpmath.mpf:
    return mpmath.mpf(r) ** s * (1 - mpmath.mpf(s) + mpmath.mpf(s) / r)


def test_the_largest_factor_is_the_one_that_a_search_finds() -> None:
    with mpmath.workdps(40):
        for r in (1.0, 1.0001, 1.9756, 30.0, 63.4375, 1000.0, 1e6):
            shares = [mpmath.mpf(s) / 4000 for s in range(4001)]
            most = max(factor(r, s) for s in shares)
            assert largest_factor(r)[0] == pytest.approx(float(most), rel=2e-5)
            assert largest_factor(r)[0] >= float(most) * (1 - 1e-14)


@pytest.mark.parametrize("pieces, told", [(1, 53.6), (16, 5.9), (1024, 1.06)])
def test_a_floor_to_a_thousand_is_drawn_as_much_too_far_as_the_lesson_says(
    pieces: int, told: float
) -> None:
    illustration = shown(to_far(1000.0), pieces=pieces)
    most = value(illustration, "factor")
    assert most == pytest.approx(told, rel=6e-3)
    true, drawn = value(illustration, "its distance w"), value(illustration, "drawn at")
    assert drawn / true == pytest.approx(most, rel=1e-12)
    r = 1 + 999 / pieces
    with mpmath.workdps(40):
        s = (1 - 1 / mpmath.mpf(true)) / (1 - 1 / mpmath.mpf(r))
        assert float(factor(r, s)) == pytest.approx(most, rel=1e-12)


def test_an_eye_in_the_wall_s_own_plane_moves_no_vertex_of_the_wall() -> None:
    """They have w = 0, and no logarithm."""
    illustration = shown(replace(START, camera=Camera((0.0, 1.7, 0.0), (0.0, 1.7, -10.0))))
    assert illustration.vertices is not None
    stored, projected = illustration.vertices.stored, illustration.vertices.projected
    in_plane = (np.arange(len(stored)) >= FLOOR) & (stored[:, 2] == 0.0)
    assert in_plane.sum() >= 4 and np.isfinite(projected).all()
    assert (projected[in_plane] == stored[in_plane]).all()


def floor_of(illustration: Illustration) -> Array:
    """The middle of the floor's borders as the picture draws them."""
    assert illustration.vertices is not None
    return illustration.vertices.projected[:FLOOR].reshape(-1, 2, 3).mean(axis=1)


@pytest.mark.parametrize("pieces", [1, 3, 16])
def test_the_depth_that_the_rasteriser_interpolates_is_the_formula_s(pieces: int) -> None:
    """Between two moved vertices NDC z is linear; read as a logarithm, it is m r^s."""
    projection = to_far(400.0)
    near, far = 1.0, 400.0
    moved = projection.trace(floor_of(shown(projection, pieces=pieces)))
    plain = projection.trace(floor_of(shown(projection, pieces=pieces, depth="pixel")))
    assert moved.image == pytest.approx(plain.image, abs=1e-9)
    ends = -plain.view[: pieces + 1, 2]
    assert ends == pytest.approx(borders(near, far, pieces), rel=1e-12)
    depth = 0.5 * moved.ndc[: pieces + 1, 2] + 0.5
    assert depth == pytest.approx(np.log(ends / near) / np.log(far / near), abs=1e-12)
    with mpmath.workdps(30):
        for m, end, one, other in zip(ends[:-1], ends[1:], depth[:-1], depth[1:], strict=True):
            for s in (0.25, 0.75):
                drawn = near * (mpmath.mpf(far) / near) ** ((1 - s) * one + s * other)
                true = 1 / ((1 - s) / mpmath.mpf(m) + s / mpmath.mpf(end))
                assert float(drawn / true) == pytest.approx(float(factor(end / m, s)), rel=1e-10)


def test_the_world_shows_the_trough_and_each_pixel_s_floor_is_flat() -> None:
    trough, flat = shown(pieces=1).vertices, shown(depth="pixel").vertices
    assert trough is not None and flat is not None
    assert np.abs(flat.stored[:FLOOR, 1]).max() < 1e-12
    eye = np.array(START.camera.eye)
    stretched = (eye - trough.stored[:FLOOR])[:, 1] / eye[1]
    assert stretched.min() == pytest.approx(1.0)
    assert stretched.max() == pytest.approx(largest_factor(30.0)[0], rel=1e-3)
    assert (flat.projected[FLOOR:] == trough.own[FLOOR:]).all()


def test_its_many_strips_are_never_reduced() -> None:
    """A drag that is too slow reduces meshes, and here every vertex has its place."""
    scene = load("vertex-depth")
    assert scene.triangles >= LEAST_TRIANGLES
    assert not can_be_reduced(scene) and reduced(scene, 0.1) is scene
    assert shares_for_dragging(scene) == ()


def test_where_there_is_no_floor_it_says_why() -> None:
    down = Projection(Camera((0.0, 9.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, -1.0)), START.lens)
    past = replace(START, camera=Camera((0.0, 1.7, 1.0), (2.0, 1.7, 1.0)))
    for projection, words in (
        (to_far(np.inf), "not at infinity"),
        (down, "straight down"),
        (START.with_lens("orthographic"), "parallel"),
        (past, "behind the eye"),
    ):
        warning = shown(projection).warning
        assert warning is not None and words in warning.sentence()
    for pieces in (0, 1025, 1e9, 1.5):
        with pytest.raises(Refusal, match=r"settings\.pieces = "):
            PHENOMENON.checked({"pieces": pieces})


def test_the_trade_measures_what_it_predicts() -> None:
    trade = measure(to_far(1000.0), 0.01)
    choices = dict(zip((0, *PIECES), trade.choices, strict=True))
    for pieces, choice in choices.items():
        assert choice.error is not None and choice.predicted is not None
        assert choice.error <= choice.predicted <= 1.001 * choice.error + 1e-12
        if pieces:
            most = value(shown(to_far(1000.0), pieces=pieces), "factor")
            assert choice.predicted == pytest.approx(most - 1.0, rel=1e-9)
            assert choice.use["settings.pieces"] == str(pieces)
    assert choices[1].cost == choices[1024].cost
    assert choices[0].bytes == choices[1].bytes == 32.0
    (nothing,) = measure(to_far(np.inf), 0.01).choices
    assert nothing.error is None and "far" in nothing.note
