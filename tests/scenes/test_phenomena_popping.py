"""Popping's readings, against a drive that counts."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import Camera, Perspective, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Subject
from app.scenes.phenomena.popping import (
    HEIGHT,
    PHENOMENON,
    ROWS,
    SPACING,
    SPEED,
    TREES,
    VERTICES,
    places,
    popped_per_second,
    trees_in_view,
)
from tests.oracles.illustrations import showing

SUBJECT = Subject((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), np.zeros((1, 3)))


shown = showing(PHENOMENON, SUBJECT)
LEVELS = shown().rendering.levels  # type: ignore[union-attr]


def random_projection(random: np.random.Generator) -> Projection:
    eye = (random.uniform(-2, 2), random.uniform(1, 6), random.uniform(-60, 10))
    target = (eye[0] + random.uniform(-5, 5), random.uniform(0, 4), eye[2] - 40.0)
    lens = Perspective(random.uniform(30, 60), 0.5, random.uniform(40, 150))
    return Projection(Camera(eye, target, (0.0, 1.0, 0.0)), lens)


def driven(projection: Projection, by: float) -> Projection:
    before = PHENOMENON.checked({"position": 0.0})
    return PHENOMENON.follow(projection, before, PHENOMENON.checked({"position": by}))


def test_driving_moves_the_camera_along_the_avenue_and_back() -> None:
    start = PHENOMENON.start
    there = driven(start, 30.0)
    x, y, z = start.camera.eye
    assert there.camera.eye == (x, y, z - 30.0)
    assert there.camera.target[2] == start.camera.target[2] - 30.0
    one, other = PHENOMENON.checked({"position": 30.0}), PHENOMENON.checked({})
    assert PHENOMENON.follow(there, one, other) == start
    assert driven(start, 0.0) is start


def with_fov(projection: Projection, factor: float) -> Projection:
    lens = projection.lens
    assert isinstance(lens, Perspective)
    return replace(projection, lens=replace(lens, fov_y_deg=factor * lens.fov_y_deg))


def test_l23_as_many_pop_in_as_a_drive_counts() -> None:
    """50 cameras, half of them looking up or down: a row counts if a point of a tree passes far.

    Points of a tree are places on its faces; over one spacing every row has had its turn. They are
    a little apart, and so are the steps: the count lies between those of pictures as much narrower
    and wider.
    """
    random = np.random.default_rng(11)
    quads, _ = LEVELS[0].faces
    quads = quads[: len(quads) // len(places())] - places()[0]
    part = np.linspace(0.0, 1.0, 4)
    a, b = (grid.reshape(-1, 1) for grid in np.meshgrid(part, part))
    weights = np.hstack([(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b])
    on_tree = np.unique((weights @ quads).reshape(-1, 3).round(9), axis=0)
    rates, sure, only_parts = set(), 0, 0
    for number in range(50):
        projection = random_projection(random)
        x, y, z = projection.camera.target
        y += random.uniform(-10, 30) * (number % 2)
        aside = replace(projection.camera, target=(x + random.uniform(-45, 45), y, z))
        projection = replace(projection, camera=aside)
        if random.random() < 0.4:  # backwards
            (x, y, z), (tx, ty, tz) = projection.camera.eye, projection.camera.target
            eye = (x, y, z - 200.0)
            camera = replace(projection.camera, eye=eye, target=(tx, ty, eye[2] + (z - tz)))
            projection = replace(projection, camera=camera)
        w = -projection.trace(places()).view[:, 2]
        passing = places()[np.abs(w - projection.lens.far) < 25.0]
        rows: dict[bool, set[float]] = {True: set(), False: set()}
        before = None
        for by in np.linspace(0.0, SPACING, 31):
            outside = driven(projection, float(by)).trace(
                passing[:, None] + on_tree
            ).outside  # fmt: skip
            in_picture = ~outside[..., 2:].any(axis=-1)
            if before is not None:
                for comes in (True, False):
                    passed = (before == comes) & (outside[..., 1] != comes) & in_picture
                    rows[comes] |= set(passing[passed.any(axis=1), 0].tolist())
            before = outside[..., 1]
        counted = [2.0 * len(rows[comes]) for comes in (True, False)]
        least, most = (popped_per_second(with_fov(projection, k)) for k in (0.96, 1.04))
        assert least[0] <= counted[0] <= most[0] and least[1] <= counted[1] <= most[1], projection
        sure += least == most == popped_per_second(projection) == tuple(counted)
        rates.add(popped_per_second(projection))
        n, eye = projection.camera.frame[2], np.array(projection.camera.eye)
        middles = np.array([(x, HEIGHT / 2.0, 0.0) for x in ROWS])
        middles[:, 2] = ((eye - middles) @ n - projection.lens.far) / n[2]
        seen = (~projection.trace(middles).outside[:, 2:].any(axis=1)).sum()
        only_parts += 2.0 * seen < max(counted)
    assert sure > 35 and only_parts >= 2
    assert rates >= {(0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (0.0, 2.0), (0.0, 4.0)}


def test_crowns_pass_where_the_middle_of_no_tree_is_seen() -> None:
    """Looking up: the picture's lower edge is above the trees' middles, where far is."""
    start = replace(PHENOMENON.start, lens=Perspective(45.0, 6.0, 100.0))
    camera = Camera((0.5, 2.2, 10.0), (0.0, 11.2, -40.0))
    up = replace(with_fov(start, 0.4), camera=camera)
    readings = shown(up).readings
    assert readings[2].value == 4.0 and readings[4].value == 100.0
    # Looking down at the trunks of one row alone, of which the simplest trees have none.
    camera = Camera((4.0, 20.0, 10.0), (4.0, 0.6, -88.1))
    down = replace(with_fov(start, 0.5 / 45.0), camera=camera)
    assert shown(down).readings[2].value == 2.0
    assert shown(down, detail=True).readings[2].value == 0.0


def test_nothing_pops_in_past_the_last_tree_or_at_infinity_or_looking_back() -> None:
    start = PHENOMENON.start
    assert popped_per_second(start) == (2 * SPEED / SPACING, 0.0)
    end = driven(start, 300.0)
    past = replace(end, lens=Perspective(45.0, 1.0, 90.0))
    assert popped_per_second(past) == (0.0, 0.0)
    none_pops = shown(past, fog="linear").readings[4]
    assert none_pops.value is None and none_pops.note is not None
    endless = shown(replace(start, lens=Perspective(45.0, 1.0, math.inf))).readings
    assert endless[2].value == 0.0 and endless[4].value is None
    assert endless[2].note is not None and endless[4].note is not None
    back = replace(start, camera=Camera((0.0, 2.0, -200.0), (0.0, 2.0, 0.0)))
    assert [reading.value for reading in shown(back).readings[2:]] == [0.0, 4.0, 100.0]


def test_the_vertices_drawn_are_those_of_the_trees_in_view() -> None:
    """50 cameras: each tree's own distance and level; in view are all with a vertex that is."""
    random = np.random.default_rng(31)
    (quads, _), objects = LEVELS[0].faces, LEVELS[0].objects
    per_tree = len(quads) // len(places())
    assert VERTICES[0] == 4 * per_tree
    corners = quads.reshape(len(places()), -1, 3)
    for _ in range(50):
        projection = random_projection(random)
        first, second = sorted(random.uniform(5, 120, 2).tolist())
        seen = trees_in_view(projection)
        some_inside = ~projection.trace(corners).outside.any(axis=2)
        assert seen[some_inside.any(axis=1)].all()
        eye, n = np.array(projection.camera.eye), projection.camera.frame[2]
        expected = 0
        for tree in places()[seen]:
            w = float(n @ (eye - tree))
            expected += VERTICES[0 if w < first else 1 if w < second else 2]
        readings = shown(projection, detail=True, detail_1=first, detail_2=second).readings
        assert readings[0].value == expected
        assert readings[1].value == VERTICES[0] * int(seen.sum())
        assert shown(projection).readings[0].value == readings[1].value
    assert (np.unique(objects, axis=0) == np.unique(places(), axis=0)).all()


def test_each_level_has_the_vertices_that_it_says() -> None:
    for level, count in zip(LEVELS, VERTICES, strict=True):
        (quads, rgb), objects = level.faces, level.objects
        assert len(quads) == len(rgb) == len(objects) == len(ROWS) * TREES * count // 4
        off = np.abs(quads - objects[:, None])
        assert off[..., [0, 2]].max() <= 1.5 + 1e-9 and off[..., 1].max() <= HEIGHT + 1e-9
    assert list(VERTICES) == sorted(VERTICES, reverse=True)


def test_the_contrast_at_the_far_plane_is_the_fogs() -> None:
    random = np.random.default_rng(5)
    for _ in range(50):
        projection = random_projection(random)
        far = projection.lens.far
        start, end = sorted(random.uniform(0, 200, 2).tolist())
        density = 10.0 ** random.uniform(-3, -1)
        linear = shown(projection, fog="linear", fog_start=start, fog_end=end).readings[4]
        expected = min(max((end - far) / (end - start), 0.0), 1.0)
        assert linear.value == pytest.approx(100.0 * expected)
        thick = shown(projection, fog="exponential", fog_density=density)
        assert thick.readings[4].value == pytest.approx(100.0 * math.exp(-density * far))
        curve = thick.diagrams[0].curves[0].points
        assert curve[:, 1] == pytest.approx(100.0 * np.exp(-density * curve[:, 0]))
        assert shown(projection).readings[4].value == 100.0


def test_the_diagram_of_the_fog_has_far_where_it_is() -> None:
    start = PHENOMENON.start
    for far, marked in ((30.0, [[[30.0, 0.0], [30.0, 100.0]]]), (math.inf, [])):
        (diagram,) = shown(replace(start, lens=Perspective(45.0, 0.5, far))).diagrams
        curves = (curve for curve in diagram.curves if curve.colour == "far")
        assert [curve.points.tolist() for curve in curves] == marked


@pytest.mark.parametrize(
    ("settings", "field"),
    [
        ({"fog_start": 50.0, "fog_end": 50.0}, "settings.fog_end"),
        ({"detail_1": 70.0}, "settings.detail_2"),
    ],
)
def test_settings_that_do_not_go_together_are_named(
    settings: dict[str, object], field: str
) -> None:
    with pytest.raises(Refusal) as error:
        PHENOMENON.checked(settings)
    assert error.value.field == field


def test_l23_the_avenue_fills_the_picture_and_is_seen_to_end_before_it() -> None:
    """The nearest trees reach its sides and nearly its top; the last are still seen as trees."""
    start = PHENOMENON.start
    width, height = start.image_size
    seen = places()[trees_in_view(start)]
    nearest, last = seen[seen[:, 2].argmax()], seen[seen[:, 2].argmin()]

    def high(place: np.ndarray) -> float:
        bottom, top = start.trace([place, np.add(place, (0.0, HEIGHT, 0.0))]).image
        return float(bottom[1] - top[1])

    across = start.trace([(x, HEIGHT / 2.0, nearest[2]) for x in ROWS]).image[:, 0]
    assert across[1] - across[0] > 0.7 * width and high(nearest) > 0.8 * height
    assert 0.05 * height < high(last) < 0.15 * height
    beyond = (0.0, 0.0, 3.0 * SPACING)  # what is not drawn would be seen there
    assert high(last - beyond) > 0.04 * height
    assert len(seen) < len(places()) / 3


def test_the_next_tree_is_the_nearest_one_behind_far_and_goes_when_far_has_passed_it() -> None:
    start = PHENOMENON.start
    marks = PHENOMENON.illustration(start, PHENOMENON.checked({}), SUBJECT)
    (text,) = marks.world.texts
    assert text.name == "next-tree"
    eye_z, far = start.camera.eye[2], start.lens.far
    depths = -(start.trace(places()).view[:, 2])
    w = -start.trace(text.point).view[2]
    assert far < w < far + SPACING + 1.0 and eye_z - text.point[2] == pytest.approx(w, abs=1.0)
    assert not ((depths > far + 0.1) & (depths < w - 1.0)).any()
    assert {mark.name for mark in marks.image.texts} == {"next-tree"}
    farther = replace(start, lens=replace(start.lens, far=far + 2.0 * SPACING))
    (later,) = PHENOMENON.illustration(farther, PHENOMENON.checked({}), SUBJECT).world.texts
    assert later.point[2] < text.point[2] - SPACING
    endless = replace(start, lens=replace(start.lens, far=math.inf))
    assert not PHENOMENON.illustration(endless, PHENOMENON.checked({}), SUBJECT).world.texts
