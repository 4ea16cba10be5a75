"""Numbers as people type them and as the program prints them."""

import math
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.document.codec import to_tree
from app.document.document import NUMBER, NUMBER_OR_WORD, PIXELS, VECTOR, Document, fields_of
from app.document.settings import set_values
from app.drawings.labels import written_distance
from app.model.numerals import number, numbers
from app.model.projection import kinds
from app.model.refusal import Refusal, format_value
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.words import figure
from widgets.parts.messages import figure_text, number_text
from widgets.parts.number_text import short_text


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("−12", -12.0), ("–12", -12.0), ("1e−05", 1e-5), ("1.5e-3", 1.5e-3), ("5/2", 2.5),
        (" 1 / 3 ", 1 / 3), ("-2/−7", 2 / 7), ("−2.5·10⁻⁵", -2.5e-5), ("10⁻⁵", 1e-5),
        ("−10⁻⁵", -1e-5), ("2×10^-3", 2e-3), ("2 * 10^3", 2e3), ("\u20097\u00a0", 7.0),
        ("+.5", 0.5), ("5.", 5.0), ("1E3", 1e3), ("0/5", 0.0),
    ],
)  # fmt: skip
def test_a_number_is_read_as_people_write_it(text: str, value: float) -> None:
    assert number(text) == value


@pytest.mark.parametrize(
    "text",
    ["", "-", "1_0", "\u0661", "1/0", "1/2/3", "5//2", "1 2", "1,5", "1e400", "1e999/1e999",
     "210⁻⁵", "nan", "inf", "0x10", "45°", "1e-1e-1", "10^"],
)  # fmt: skip
def test_what_is_not_a_number_is_not_read(text: str) -> None:
    assert number(text) is None


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("(0, 2, −12)", [0.0, 2.0, -12.0]), ("[0 2 -12]", [0.0, 2.0, -12.0]),
        ("0,2,-12", [0.0, 2.0, -12.0]), ("0 , 2", [0.0, 2.0]), ("1/2, 1 / 4", [0.5, 0.25]),
        ("(1, 2, 3), (4, 5, 6)", [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]), ("", []), ("()", []),
    ],
)  # fmt: skip
def test_several_numbers_are_read_with_their_brackets(text: str, values: list[float]) -> None:
    assert numbers(text) == values


@pytest.mark.parametrize("text", ["0,,2", ",1", "1,", "(1,2", "1;2", "1,x", "[1,2)"])
def test_a_gap_in_several_numbers_is_not_read(text: str) -> None:
    assert numbers(text) is None


@given(st.floats(-1e300, 1e300))
def test_what_the_program_writes_is_read_again(value: float) -> None:
    assert number(format_value(value)) == number(number_text(value)) == value
    for digits in (1, 4, 6):
        rounded = float(f"{value:.{digits}g}")
        if math.isfinite(rounded):
            assert number(figure_text(value, digits)) == rounded
            assert number(figure(value, digits)) == rounded
    assert number(written_distance(value, 6)) == float(f"{value:.6g}")
    assert math.isclose(number(short_text(value)) or 0.0, value, rel_tol=0.6)


NUMBERS = (NUMBER, NUMBER_OR_WORD, PIXELS, VECTOR)
WAYS: tuple[Callable[[float], str], ...] = (
    number_text, figure, figure_text, short_text, lambda value: f" {value:.6g}\u2009",
)  # fmt: skip


@pytest.mark.parametrize("scene", ["letter-f", *PHENOMENA])
def test_every_field_reads_what_is_printed_of_it(scene: str) -> None:
    document = set_values(Document(), [f"scene={scene}"])
    for kind in kinds():
        tree = to_tree(set_values(document, [f"lens.kind={kind}"]))
        for field in fields_of(scene, kind):
            value = tree.get(field.section, {}).get(field.name) if field.section else None
            if field.kind not in NUMBERS or value is None or value == "inf":
                continue
            parts = value if field.kind is VECTOR else [value]
            for way in WAYS:
                words = [f"{way(part)}{field.unit}" for part in parts]
                read = field.read(f"({', '.join(words)})" if field.kind is VECTOR else words[0])
                assert read == pytest.approx(value, rel=1e-3), (field.path, words)
            assert field.read(format_value(value)) == value


@pytest.mark.parametrize("text", ["∞", "inf", "Infinity"])
def test_an_infinite_far_may_be_a_sign(text: str) -> None:
    tree = to_tree(set_values(Document(), [f"lens.far={text}"]))
    assert tree["lens"]["far"] == "inf"


def test_a_unit_belongs_to_its_field() -> None:
    state = set_values(
        Document(),
        ["lens.fov_y_deg=45 °", "lens.near=1 units", "image.width=640px",
         "object.rotate_deg=(1°, 2°, 3)"],
    )  # fmt: skip
    tree = to_tree(state)
    assert (tree["lens"]["fov_y_deg"], tree["lens"]["near"]) == (45, 1)
    assert tree["image"]["width"] == 640
    assert tree["object"]["chain"][1:4] == ["rotate z 3", "rotate y 2", "rotate x 1"]
    for wrong in ("lens.near=1°", "lens.fov_y_deg=45 px", "image.width=px", "lens.near=°"):
        with pytest.raises(Refusal):
            set_values(Document(), [wrong])
