"""L2: dragging the object in the world pane changes its transform."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app.model.chain import Chain, FiveTiles, Tile
from app.model.projection import Camera, Projection
from app.picking.handles import OBJECT_POINTS, Handle, changed, object_points, place, present, shown
from app.picking.sight import Sight
from tests.picking.test_handles import SIZE, looks, planes
from tests.support.handles import dragged

REACH = 2.0


def handle(name: str) -> Handle:
    return Handle("object", "", (REACH, REACH), name)


def placed(random: np.random.Generator, order: str = "trs") -> Projection:
    """A random object of ordinary size in front of a camera."""
    placement = FiveTiles(
        tuple(random.uniform(-2.0, 2.0, 3)),
        tuple(random.uniform(-170.0, 170.0, 3)),
        tuple(random.uniform(0.5, 2.0, 3)),
        order,  # type: ignore[arg-type]
    ).chain
    return Projection(Camera((6.0, 5.0, 9.0), (0.0, 1.0, 0.0)), placement=placement)


def spot(projection: Projection, name: str, sight: Sight) -> np.ndarray:
    return np.asarray(sight.seen([place(projection, handle(name), planes(projection))])[0])


@pytest.mark.parametrize("order", ["trs", "rts"])
@pytest.mark.parametrize("name", ["origin", "x", "y", "z"])
def test_l2_the_held_handle_follows_the_pointer(name: str, order: str) -> None:
    """Drag to the pixel of the same handle of an object with another scale."""
    random = np.random.default_rng(3)
    for _ in range(40):
        projection = placed(random, order)
        sight, placement = looks(projection.camera), projection.placement
        if name == "origin":
            end = spot(projection, name, sight) + random.uniform(-30.0, 30.0, 2)
        else:
            scale = np.array(placement.tiles[-1].numbers)
            scale["xyz".index(name)] *= random.uniform(0.6, 1.5)
            other = placement.with_tile(4, Tile("scale", tuple(scale.tolist())), over=1)
            end = spot(replace(projection, placement=other), name, sight)
        change = dragged(projection, handle(name), planes(projection), sight, tuple(end.tolist()))
        after = changed(projection, change)
        assert math.dist(spot(after, name, sight), end) < 1.0
        changed_kind = "translate" if name == "origin" else "scale"
        for before, now in zip(placement.tiles, after.placement.tiles, strict=True):
            assert before == now or before.kind == now.kind == changed_kind


def test_the_object_s_handles_are_on_its_columns() -> None:
    projection = placed(np.random.default_rng(5))
    points, matrix = object_points(projection.placement, REACH), projection.placement.matrix
    assert tuple(points) == OBJECT_POINTS
    assert np.array_equal(points["origin"], matrix[:3, 3])
    for axis, name in enumerate("xyz"):
        tip = matrix @ [*(REACH * np.eye(3)[axis]), 1.0]
        assert np.allclose(points[name], tip[:3])


def test_the_object_has_handles_only_while_its_axes_are_drawn() -> None:
    projection = Projection(placement=FiveTiles((0.0, 0.0, 1.0), (0.0, 20.0, 0.0)).chain)
    sight = looks(Camera((9.0, 6.0, 12.0), (0.0, 2.0, 0.0)))

    def names(reach: float) -> set[str]:
        found = shown(projection, planes(projection), sight, SIZE, 10.0, object_reach=reach)
        return {each.setting for each, _ in found if each.name == "object"}

    assert names(0.0) == set()
    assert names(REACH) == set(OBJECT_POINTS)


def test_a_drag_is_taken_back_to_the_chain_before_it() -> None:
    projection = placed(np.random.default_rng(6))
    before = present(projection, ("chain",))
    moved = changed(projection, {"chain": Chain.read("scale 0,1,1")})
    assert moved.placement.rank == 2 and changed(moved, before) == projection


CHAINS = (
    "", "rotate z 90", "scale 2,1,1; translate 1,0,0", "rotate z 90; translate 3,0,0; scale 2,1,1",
    "translate 1,0,0; rotate 1,1,0 30; translate 0,1,0", "shear xy 0.5; mirror x; rotate y 20",
    "off translate 1,1,1; matrix 1,0.2,0,1 0,1,0,0 0,0.3,1,0 0,0,0,1; rotate x 30; scale 1,2,1",
)  # fmt: skip


@pytest.mark.parametrize("text", CHAINS)
def test_l2_any_chain_follows_a_drag_of_its_origin_with_its_leftmost_translation(text: str) -> None:
    chain = Chain.read(text)
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 1.0, 0.0)), placement=chain)
    sight = looks(projection.camera)
    end = spot(projection, "origin", sight) + np.array([25.0, -14.0])
    after = changed(
        projection,
        dragged(projection, handle("origin"), planes(projection), sight, tuple(end.tolist())),
    )
    assert math.dist(spot(after, "origin", sight), end) < 1.0
    place, tiles = chain.place_of("translate"), after.placement.tiles
    if place is None:  # the new one is in the world's axes
        assert tiles[0].kind == "translate" and tiles[1:] == chain.tiles
    else:
        assert [a == b for a, b in zip(tiles, chain.tiles, strict=True)].index(False) == place


@pytest.mark.parametrize("text", CHAINS)
@pytest.mark.parametrize("name", ["x", "y", "z"])
def test_l2_any_chain_follows_a_drag_of_an_axis_with_its_leftmost_scale(
    text: str, name: str
) -> None:
    chain = Chain.read(text)
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 1.0, 0.0)), placement=chain)
    sight = looks(projection.camera)
    longer = chain.with_tile(
        len(chain.tiles), Tile("scale", tuple(1.0 + 0.3 * (x == name) for x in "xyz"))
    )
    end = spot(replace(projection, placement=longer), name, sight)
    change = dragged(projection, handle(name), planes(projection), sight, tuple(end.tolist()))
    after = changed(projection, change)
    assert math.dist(spot(after, name, sight), end) < 1.0
    scales = [tile.kind for tile in after.placement.tiles].count("scale")
    assert scales == max(1, [tile.kind for tile in chain.tiles].count("scale"))


@pytest.mark.parametrize("text", CHAINS)
def test_l2_any_chain_turns_with_its_leftmost_rotation_about_the_origin_of_the_object(
    text: str,
) -> None:
    chain = Chain.read(text)
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 1.0, 0.0)), placement=chain)
    sight = looks(projection.camera)
    centre, start = (spot(projection, name, sight) for name in ("origin", "turn"))
    x, y = start - centre
    end = centre + np.array([0.94 * x - 0.34 * y, 0.34 * x + 0.94 * y])  # 20 degrees
    change = dragged(projection, handle("turn"), planes(projection), sight, tuple(end.tolist()))
    tiles = changed(projection, change).placement.tiles
    turns = [tile for tile in tiles if tile.kind.startswith("rotate")]
    assert len(turns) == max(1, text.count("rotate"))
    before = [tile for tile in chain.tiles if tile.kind.startswith("rotate")] or [
        Tile("rotate y", (0.0,))
    ]
    assert abs(turns[0].numbers[-1] - before[0].numbers[-1]) == pytest.approx(20.0, abs=1.0)
    assert [t for t in tiles if t not in turns] == [t for t in chain.tiles if t not in before]


def test_a_flattened_axis_can_be_pulled_out_again() -> None:
    projection = Projection(
        Camera((6.0, 5.0, 9.0), (0.0, 1.0, 0.0)), placement=FiveTiles(scale=(1.0, 0.0, 1.0)).chain
    )
    sight = looks(projection.camera)
    up = sight.seen([(0.0, REACH * 1.5, 0.0)])[0]
    change = dragged(projection, handle("y"), planes(projection), sight, tuple(up.tolist()))
    assert changed(projection, change).placement.tiles[-1].numbers[1] == pytest.approx(
        1.5, abs=0.01
    )
