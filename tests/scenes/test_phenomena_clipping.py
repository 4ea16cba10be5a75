"""Clipping: corners by hand, six steps against the clipper, parts that make up the whole."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.model.clipping import clip_polygon
from app.model.limits import PLANES
from app.model.projection import Array, Camera, FreeMatrix, Frustum, Projection
from app.scenes.phenomena.clipping import CARDS, PHENOMENON, TRIANGLE, classified, cut_by, steps
from app.scenes.phenomena.illustration import Illustration
from tests.oracles.illustrations import reading, showing, subject_of, value

START, SUBJECT = PHENOMENON.start, subject_of(PHENOMENON)
show = showing(PHENOMENON, SUBJECT)
# Planes x = ±w, y = ±w, w = 1 and w = 3, where w = -z.
SIMPLE = Projection(
    Camera((0, 0, 0), (0, 0, -1)), Frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 3.0), (100, 100)
)


def xyw(points_clip: Array) -> Array:
    return points_clip[:, [0, 1, 3]]


def area(points: Array) -> float:
    """The area of a flat convex polygon (n, 3)."""
    parts = np.cross(points[1:-1] - points[0], points[2:] - points[0])
    return float(np.linalg.norm(parts.sum(axis=0))) / 2.0


def faces(illustration: Illustration, colour: str) -> list[Array]:
    return [face.points for face in illustration.world.faces if face.colour == colour]


def counts(illustration: Illustration) -> tuple[float, ...]:
    return tuple(value(illustration, f"cards {what}") for what in ("whole", "outside", "crossing"))


def test_l15_the_corners_of_a_cut_by_hand() -> None:
    """A = (0, 0) at w = 1/2 is before near, B = (4, 0) at w = 5/2 right of x = w; C is inside.

    near: 1/4 of AB and of AC has w = 1; on AB that is x = 1 = w, on the right plane already.
    right: 3/8 of BC has x = 5/2 = w. All of them are numbers of few bits.
    """
    cuts = steps(SIMPLE.trace([(0.0, 0.0, -0.5), (4.0, 0.0, -2.5), (0.0, 1.0, -2.5)]).clip)
    near = [(1, 0, 1), (4, 0, 2.5), (0, 1, 2.5), (0, 0.25, 1)]
    right = [(1, 0, 1), (2.5, 0.375, 2.5), (0, 1, 2.5), (0, 0.25, 1)]
    assert [len(cut.corners) for cut in cuts] == [3, 4, 4, 4, 4, 4, 4]
    assert xyw(cuts[1].corners).tolist() == [list(corner) for corner in near]
    assert xyw(cuts[6].corners).tolist() == [list(corner) for corner in right]
    assert xyw(cuts[1].new).tolist() == [[0, 0.25, 1], [1, 0, 1]]
    assert xyw(cuts[4].new).tolist() == [[2.5, 0.375, 2.5]]
    assert xyw(cuts[1].off).tolist() == [[0, 0.25, 1], [0, 0, 0.5], [1, 0, 1]]
    assert xyw(cuts[4].off).tolist() == [[1, 0, 1], [4, 0, 2.5], [2.5, 0.375, 2.5]]
    assert [len(cut.off) for cut in cuts] == [0, 3, 0, 0, 3, 0, 0]


def test_l15_a_corner_behind_the_eye_is_cut_off_before_the_divide() -> None:
    """From w = -1 to 2, two thirds of the way have w = 1."""
    behind = SIMPLE.trace([(0.0, 0.0, 1.0), (1.5, 0.0, -2.0), (0.0, 1.5, -2.0)]).clip
    cut = cut_by(behind, "near")
    assert xyw(cut.new) == pytest.approx(np.array([(0, 1, 1), (1, 0, 1)]), abs=1e-15)
    assert len(cut.corners) == 4 and (cut.corners[:, 3] > 0.0).all()
    # All of this one is beyond far, and nothing is left for the planes after it.
    clip = SIMPLE.trace([(0.0, 0.0, -4.0), (1.0, 0.0, -5.0), (0.0, 1.0, -4.0)]).clip
    cuts = steps(clip)
    assert [len(cut.corners) for cut in cuts] == [3, 3, 0, 0, 0, 0, 0]
    assert (cuts[2].off == clip).all() and not any(len(cut.off) for cut in cuts[3:])


@pytest.mark.parametrize(
    ("kind", "depth"),
    [
        *(("perspective", "opengl"), ("frustum", "direct3d")),
        *(("orthographic", "reversed"), ("oblique", "opengl")),
    ],
)
def test_l15_after_six_steps_it_is_the_clipped_polygon(kind: str, depth: Any) -> None:
    seen = replace(START.with_lens(kind), depth=depth)
    for polygon in (TRIANGLE, *CARDS):
        clip = seen.trace(polygon).clip
        for count, cut in enumerate(steps(clip, depth)):
            one_go = clip_polygon(clip, depth, PLANES[:count])
            assert (cut.corners == one_go.points_clip).all()


def test_l15_each_plane_gives_the_triangle_one_corner_more_up_to_nine() -> None:
    for step in range(7):
        illustration = show(step=float(step))
        plane = reading(illustration, "plane of").value
        assert plane == (PLANES[step - 1] if step else "none yet")
        assert value(illustration, "corners after") == 3.0 + step
        assert value(illustration, "corners before") == max(2.0 + step, 3.0)
        assert [text.text for text in illustration.world.texts if text.text in PLANES] == (
            [plane] if step > 2 else []  # near and far have their names in the panes anyhow
        )
        assert len(illustration.world.dots) == len(illustration.ndc.dots) == (2 if step else 0)


@pytest.mark.parametrize("step", range(7))
def test_l15_the_remaining_and_the_cut_off_pieces_make_up_the_triangle(step: int) -> None:
    illustration = show(step=float(step))
    (left,) = faces(illustration, "accent")
    pale = faces(illustration, "muted")
    assert len(pale) == step
    assert area(left) + sum(map(area, pale)) == pytest.approx(area(TRIANGLE), rel=1e-12)
    for piece, plane in zip(pale, range(step), strict=True):
        assert START.trace(piece.mean(axis=0)).outside[plane]


def test_l15_cards_are_counted_as_their_corners_say() -> None:
    """The corners alone decide, because no card here passes an edge of the volume."""
    for seen in (START, START.between(2.0, 20.0), START.between(6.0, 9.0)):
        outside = seen.trace(CARDS).outside
        whole = ~outside.any(axis=(1, 2))
        beyond = outside.all(axis=1).any(axis=1)
        expected = (whole.sum(), beyond.sum(), (~whole & ~beyond).sum())
        assert counts(show(seen)) == expected
    assert counts(show()) == (3.0, 3.0, 5.0)


def test_l15_a_face_past_an_edge_of_the_volume_is_outside() -> None:
    """The first face passes the edge (2, 2) at w = 2, the second one does not."""
    past = [(4.5, 0.0, -2.0), (0.0, 4.5, -2.0), (4.5, 4.5, -2.0)]
    through = [(3.0, 0.0, -2.0), (0.0, 3.0, -2.0), (3.0, 3.0, -2.0)]
    assert not SIMPLE.trace(past).outside.all(axis=0).any()
    assert classified(SIMPLE, np.array([past, through])) == ([], [0], [1])


def test_l15_cards_are_pale_where_they_are_outside_and_nowhere_else() -> None:
    veil = faces(show(), "background")
    _, outside, crossing = classified(START, CARDS)
    for piece in veil:
        assert START.trace(piece.mean(axis=0)).outside.any()
    inside = 0.0
    for i in crossing:
        kept = (
            clip_polygon(START.trace(CARDS[i]).clip).points_clip
            @ START.world_from_clip_at((0.0, 0.0, 0.0)).T
        )
        inside += area(kept[:, :3] / kept[:, 3:])
    cards = sum(area(CARDS[i]) for i in (*outside, *crossing))
    assert sum(map(area, veil)) + inside == pytest.approx(cards, rel=1e-9)


def test_l15_before_near_has_cut_a_corner_behind_the_eye_has_no_ndc() -> None:
    nearer = replace(START, camera=Camera((0.0, 4.0, 5.0), (0.0, 4.0, 0.0)))
    uncut = show(nearer, step=0.0)
    assert uncut.warning is not None and "behind the eye" in uncut.warning.template
    assert not uncut.ndc.faces and faces(uncut, "accent")
    assert show(nearer, step=1.0).warning is None
    assert [face for face in show(nearer, step=1.0).ndc.faces if face.colour == "accent"]


CONDITIONS = {
    "opengl": "w + z ≥ 0, w − z ≥ 0, w + x ≥ 0, w − x ≥ 0, w + y ≥ 0, w − y ≥ 0",
    "direct3d": "z ≥ 0, w − z ≥ 0, w + x ≥ 0, w − x ≥ 0, w + y ≥ 0, w − y ≥ 0",
    "reversed": "w − z ≥ 0, z ≥ 0, w + x ≥ 0, w − x ≥ 0, w + y ≥ 0, w − y ≥ 0",
}


@pytest.mark.parametrize("depth", CONDITIONS)
def test_l15_each_step_says_its_plane_and_which_rows_make_it(depth: Any) -> None:
    projection = PHENOMENON.start.with_depth(depth)
    for step, condition in enumerate(CONDITIONS[depth].split(", "), 1):
        plane = PLANES[step - 1]
        illustration = show(projection, step=float(step))
        assert reading(illustration, "plane of this step").value == plane
        assert reading(illustration, "it keeps").value == condition
        rows = {f"clip_{letter}" for letter in "xyzw" if letter in condition}
        assert set(illustration.about) == {plane, *rows}
        # It is true inside, and at a corner that the step cuts off it is not.
        x, y, z, w = projection.trace((0.0, 4.0, 0.0)).clip.tolist()
        python = condition.replace("−", "-").replace("≥", ">=")
        assert eval(python, {}, {"x": x, "y": y, "z": z, "w": w})
        off = steps(projection.trace(TRIANGLE).clip, depth)[step].off
        letters = (dict(zip("xyzw", each, strict=True)) for each in off.tolist())
        assert not all(eval(python, {}, each) for each in letters)
    assert not show(projection, step=0.0).about


def test_l15_an_infinite_far_plane_cuts_nothing() -> None:
    endless = START.between(3.0, math.inf)
    cut = show(endless, step=2.0)
    assert value(cut, "corners before") == value(cut, "corners after") == 4.0
    assert not cut.world.dots
    assert counts(cut)[1] < counts(show())[1]  # that behind the far plane is whole now
    assert value(show(endless, step=6.0), "corners after") == 8.0


def test_l15_a_free_matrix_rests_and_a_parallel_lens_clips() -> None:
    free = replace(START, lens=FreeMatrix(np.eye(4).tolist()))
    shown = PHENOMENON.illustration(free, PHENOMENON.checked({}), SUBJECT)
    assert shown.idle and shown.warning is not None and not shown.world.faces
    parallel = show(START.with_lens("orthographic"), step=6.0)
    assert parallel.warning is None and value(parallel, "corners after") > 3.0


def test_a_corner_keeps_its_letter_after_it_is_cut_off() -> None:
    """By hand: eye at (0, 4, 8), cot 20° up, 16:9, near 3 and far 13. A is beyond near."""
    cot = 1.0 / math.tan(math.radians(20.0))
    for step in range(7):
        ndc = {text.name: text.point for text in show(START, step=step).ndc.texts}
        for name, (x, y, z) in zip("ABC", TRIANGLE.tolist(), strict=True):
            w = 8.0 - z
            place = cot * 9 / 16 * x / w, cot * (y - 4.0) / w, (16.0 * w - 78.0) / 10.0 / w
            assert ndc[name] == pytest.approx(place), (step, name)


def test_letters_stand_at_their_corners_or_nearest_to_them_and_new_corners_have_numbers() -> None:
    for step in range(7):
        shown = show(START, step=step)
        for marks in (shown.world, shown.ndc, shown.image):
            names = [text.name for text in marks.texts if len(text.name) == 1]
            assert sorted(set(names)) == sorted(names)
        ndc = {text.name: text.point for text in shown.ndc.texts}
        assert {"A", "B", "C"} <= set(ndc)
        assert ({"1", "2"} <= set(ndc)) == (step > 0)
        clip = START.trace(TRIANGLE).clip
        beyond = START.trace(TRIANGLE).outside[:, :step].any(axis=1)
        for letter, own, is_cut in zip("ABC", clip, beyond, strict=True):
            if not is_cut and own[3] > 0.0:
                np.testing.assert_allclose(ndc[letter], own[:3] / own[3], atol=1e-9)
