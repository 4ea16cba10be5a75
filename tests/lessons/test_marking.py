"""A typed number: what is read, what counts as right."""

from __future__ import annotations

from fractions import Fraction

import pytest

from app.lessons import marking
from app.model.refusal import Refusal


@pytest.mark.parametrize(
    ("text", "value", "digits"),
    [
        ("0.5", Fraction(1, 2), 1), ("0,5", Fraction(1, 2), 1), (",5", Fraction(1, 2), 1),
        ("1/2", Fraction(1, 2), 3), ("-3", Fraction(-3), 1), ("−2.25", Fraction(-9, 4), 3),
        ("2e-3", Fraction(1, 500), 1), ("1.20·10^2", Fraction(120), 3), ("+4", Fraction(4), 1),
        ("-1/-4", Fraction(1, 4), 3), ("2.5 units", Fraction(5, 2), 2), ("1.5×", Fraction(3, 2), 2),
        ("0", Fraction(0), 0),
    ],
)  # fmt: skip
def test_numbers_are_read_as_people_write_them(text: str, value: Fraction, digits: int) -> None:
    typed = marking.read(text)
    assert (typed.value, typed.digits) == (value, digits)


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("91.5°", "°", 91.5), ("91,50 °", "°", 91.5), ("91.5", "°", 91.5), ("120 deg", "°", 120),
        ("120 Degrees", "°", 120), ("60°", "deg", 60), ("1 280 px", "px", 1280),
        ("1280 pixels", "px", 1280), ("3.4 m", "m", 3.4), ("50 mm", "mm", 50), ("2 cm", "cm", 2),
        ("2 CM", "cm", 2), ("45 %", "%", 45),
    ],
)  # fmt: skip
def test_the_unit_of_an_answer_may_stand_behind_it(text: str, unit: str, value: float) -> None:
    assert float(marking.read(text, unit).value) == value


@pytest.mark.parametrize(
    ("text", "unit", "said"),
    [
        ("2.145°", "", "must be a number without °"), ("45 %", "", "must be a number without %"),
        ("3.4 m", "", "must be a number without m"), ("12 px", "°", "must be in °"),
        ("3400 mm", "m", "must be in m"), ("3.4 m", "mm", "must be in mm"),
        ("2 units", "cm", "must be in cm"),
        ("", "", "nothing is typed yet"), ("   ", "", "nothing is typed yet"),
        ("°", "", "nothing is typed yet"), ("1/0", "", "nothing can be divided by 0"),
        ("1/0.0", "", "nothing can be divided by 0"),
        ("1e400", "", "whose power of ten is between -300 and 300"),
        ("9e999999999", "", "whose power of ten is between -300 and 300"),
        ("1" * 61, "", "at most 60 characters"),
        *((text, "", f"and not {text}") for text in (
            "abc", "nan", "inf", "1.2.3", "1_000", "0x10", "٣", "__import__('os')",
        )),
    ],
)  # fmt: skip
def test_another_unit_or_no_number_is_refused(text: str, unit: str, said: str) -> None:
    with pytest.raises(Refusal) as caught:
        marking.read(text, unit)
    assert said in str(caught.value) and str(caught.value).startswith("answer = ")


@pytest.mark.parametrize(
    ("text", "value", "right"),
    [
        # Exact values count however short.
        ("0.5", 0.5, True), ("1/2", 0.5, True), ("-1", -1.0, True), ("0", 0.0, True),
        ("0.8", 0.8, True), ("4/5", 0.8, True), ("0", 1e-17, True), ("2/3", 2.0 / 3.0, True),
        # Others need three digits, and may be one off in the last.
        ("91.5", 91.49284451967722, True), ("91.49", 91.49284451967722, True),
        ("91.4", 91.49284451967722, True), ("91.6", 91.49284451967722, False),
        ("91", 91.49284451967722, False), ("91.47", 91.49284451967722, False),
        ("0.667", 2.0 / 3.0, True), ("0.67", 2.0 / 3.0, False), ("0.7", 2.0 / 3.0, False),
        ("-0.1111", -1.0 / 9.0, True), ("0.1111", -1.0 / 9.0, False),
        ("0.0588", 1.0 / 17.0, True), ("0.06", 1.0 / 17.0, False),
        ("355/113", 3.141592653589793, True), ("22/7", 3.141592653589793, True),
        ("3", 3.141592653589793, False), ("16/5", 3.141592653589793, False),
        ("0", 0.001, False), ("0.000", 0.001, False),
    ],
)  # fmt: skip
def test_what_counts_as_right(text: str, value: float, right: bool) -> None:
    assert marking.equals(marking.read(text), value) is right


def test_what_lacks_only_digits_is_told_apart_from_what_is_wrong() -> None:
    for text, value, too_short in (
        ("91", 91.49284451967722, True), ("90.1", 91.49284451967722, False),
        ("60", 91.49284451967722, False), ("92", 91.49284451967722, False),
        ("1", 0.8333, False),  # it may be wrong as well
        ("0.83", 0.8333, True),
    ):  # fmt: skip
        assert marking.is_too_short(marking.read(text), value) is too_short, text
