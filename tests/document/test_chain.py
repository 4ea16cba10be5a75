"""The object's chain in documents: as it is set, kept in files, and in the form of old files."""

import json

import pytest

from app.document.codec import VERSION, parse, to_json
from app.document.document import Document
from app.document.settings import assignments_in, set_values
from app.lessons.quantities import Condition, NotThere, Quantities, read_formula
from app.model.chain import Chain, FiveTiles
from app.model.projection import Perspective, Projection
from app.model.refusal import Refusal
from app.scenes.scene import load

START = Document("letter-f", load("letter-f").start)
TEXT = "translate 3,0,0; rotate z 90; off scale 2,1,1; shear xy 0.5"


def known(*values: str) -> Quantities:
    return Quantities(set_values(START, values), lambda: load("letter-f"))


def test_a_chain_is_set_kept_in_a_file_and_written_as_it_was_set() -> None:
    moved = set_values(START, [f"object.chain={TEXT}"])
    assert moved.projection.placement == Chain.read(TEXT)
    tree = json.loads(to_json(moved))
    assert tree["version"] == VERSION == 3 and tree["object"] == {"chain": TEXT.split("; ")}
    assert parse(to_json(moved)) == moved
    assert set_values(moved, ["object.chain="]) == START
    assert "object" not in json.loads(to_json(START))


@pytest.mark.parametrize("version", [1, 2])
def test_an_older_file_opens_with_its_five_tiles(version: int) -> None:
    tree = json.loads(to_json(START)) | {"version": version}
    tree["object"] = {"translate": [1, 2, 3], "rotate_deg": [0, 30, 0], "label": "own"}
    found = parse(json.dumps(tree))
    five = FiveTiles((1.0, 2.0, 3.0), (0.0, 30.0, 0.0))
    assert found.projection.placement == five.chain
    assert found.extra == {"object": {"label": "own"}}
    assert parse(to_json(found)) == found
    tree["object"] = {"scale": [1, 0, 1], "order": "rts"}
    assert parse(json.dumps(tree)).projection.placement.rank == 2


def test_older_fields_replace_the_chain_and_keep_each_other() -> None:
    five = set_values(START, ["object.translate=3,0,0", "object.order=rts"])
    both = set_values(five, ["object.rotate_deg=0,0,90"]).projection.placement
    assert both == FiveTiles((3.0, 0.0, 0.0), (0.0, 0.0, 90.0), order="rts").chain
    other = set_values(START, [f"object.chain={TEXT}"])
    assert set_values(other, ["object.scale=2,2,2"]).projection.placement.five == FiveTiles(
        scale=(2.0, 2.0, 2.0)
    )
    with pytest.raises(Refusal, match=r"cannot be set together with object\.chain"):
        set_values(START, ["object.chain=mirror x", "object.translate=1,0,0"])


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("translate 1,0,0; rotate w 3", "object.chain[1] = 'rotate w 3': must have finite numb"),
        ("scale 1,nan,1", "object.chain[0] = 'scale 1,nan,1': must have finite numbers"),
        ("rotate z 1" + "0" * 400, "must have finite numbers after rotate z, 1 in all"),
        ("; ".join(["mirror x"] * 9), "object.chain = 'mirror x': must have at most 8 tiles"),
        ("matrix 1 2 3 4 2 4 6 8 0 0 1 0 0 0 0 1", "must have an inverse, but its rank is 2"),
        ("matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1", "no move of an object changes w"),
    ],
)
def test_a_bad_tile_is_refused_by_its_place_as_set_and_in_a_file(text: str, says: str) -> None:
    with pytest.raises(Refusal) as caught:
        set_values(START, [f"object.chain={text}"])
    said = str(caught.value)
    assert says in said and len(said) < 450
    tree = json.loads(to_json(START)) | {"object": {"chain": text.split("; ")}}
    with pytest.raises(Refusal) as caught:
        parse(json.dumps(tree))
    assert str(caught.value) == said


@pytest.mark.parametrize("chain", ["mirror x", [1], {"x": 1}, None])
def test_a_chain_in_a_file_is_a_list_of_texts(chain: object) -> None:
    tree = json.loads(to_json(START)) | {"object": {"chain": chain}}
    with pytest.raises(Refusal, match="must be tiles such as"):
        parse(json.dumps(tree))


def test_a_chain_stands_between_other_values_of_a_line() -> None:
    text = "lens.near=2; object.chain=translate {=m},0,0; rotate z {=φ};camera.up=0,1,0"
    assert [part.strip() for part in assignments_in(text)] == [
        "lens.near=2", "object.chain=translate {=m},0,0; rotate z {=φ}", "camera.up=0,1,0",
    ]  # fmt: skip
    pictures = "view.compare=object.chain=translate 1,0,0; rotate z 90|lens.near=2"
    first, second, _ = set_values(START, [pictures]).view.compare
    assert first.changes == ("object.chain=translate 1,0,0; rotate z 90",)
    assert second.changes == ("lens.near=2",)


def test_names_in_formulas_mean_the_only_tile_of_their_kind() -> None:
    def value(name: str, *values: str) -> float:
        return known(*values).value(read_formula(name))

    assert value("move_x") == 0.0 and value("size_y") == 1.0
    assert value("turn_z", "object.rotate_deg=0,0,90") == 90.0
    chain = "object.chain=rotate z 30; translate 3,0,0; off translate 9,9,9"
    assert (value("turn_z", chain), value("move_x", chain), value("size_x", chain)) == (30, 3, 1)
    twice = "object.chain=translate 3,0,0; rotate z 30; translate 1,0,0"
    with pytest.raises(NotThere, match="single tile “translate”"):
        value("move_x", twice)
    with pytest.raises(NotThere, match="single tile “rotate z”"):
        value("turn_z", "object.chain=rotate 0,0,1 30")
    assert not Condition.read("move_x = 3").holds(known(twice))
    assert Condition.read("object.order = rts").holds(known("object.order=rts"))


def test_a_projection_with_a_chain_is_a_value() -> None:
    one, other = (Projection(lens=Perspective(), placement=Chain.read(TEXT)) for _ in range(2))
    assert one == other and hash(one) == hash(other)
