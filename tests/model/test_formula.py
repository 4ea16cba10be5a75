"""The language of formulas: what it reads, what it refuses and where, what it says and is worth."""

import math
import re
from contextlib import suppress
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.lecture.algebra import SYMBOLS, Letters, Ratio, number, ratio
from app.model import formula_text
from app.model.formula import Arithmetic, Formula, parse
from app.model.refusal import REFUSALS, Refusal

LETTERS = ("n", "f", "r", "l", "z_n", "theta_h")


def called(name: str, arguments: Any) -> float:
    return float(getattr(math, name)(*arguments))


QUICK = settings(max_examples=60, deadline=None)
FLOATS = Arithmetic(float, called)


def texts() -> st.SearchStrategy[str]:
    """Formulas as somebody may type them, with needless brackets and spaces."""
    atoms = st.sampled_from(LETTERS) | st.integers(0, 30).map(str) | st.sampled_from(["0.5", ".25"])
    return st.recursive(
        atoms,
        lambda inner: st.one_of(
            st.builds("{} {} {}".format, inner, st.sampled_from("+-*/"), inner),
            st.builds("({})".format, inner),
            st.builds("-{}".format, inner),
            st.builds("({})^{}".format, inner, st.integers(-2, 3)),
        ),
        max_leaves=8,
    )


numbers = st.fractions(-5, 5, max_denominator=12)
known = st.fixed_dictionaries(dict.fromkeys(LETTERS, numbers))


def pythons_own(text: str, values: dict[str, Fraction]) -> Fraction:
    """The oracle: Python reads the same text, every number a rational."""
    exact = re.sub(r"(?<![\w.])(\d*\.\d+|\d+)(?![\w.])", r"Fraction('\1')", text)
    exact = re.sub(r"\^Fraction\('(\d+)'\)", r"**\1", exact)
    exact = re.sub(r"\^-Fraction\('(\d+)'\)", r"**-\1", exact)
    return Fraction(eval(exact, {"Fraction": Fraction, **values}))


@QUICK
@given(texts(), known)
def test_it_is_worth_what_python_makes_of_it(text: str, values: dict[str, Fraction]) -> None:
    try:
        wanted = pythons_own(text, values)
    except ZeroDivisionError:
        with pytest.raises(ZeroDivisionError):
            parse(text).value(values)
        return
    assert parse(text).value(values) == wanted


@QUICK
@given(texts(), known)
def test_its_text_reads_as_itself(text: str, values: dict[str, Fraction]) -> None:
    once = parse(text)
    again = parse(once.text)
    assert again.text == once.text and again.letters == once.letters
    with suppress(ZeroDivisionError):
        assert again.value(values) == once.value(values)


@QUICK
@given(texts(), known)
def test_in_letters_it_is_worth_the_same(text: str, values: dict[str, Fraction]) -> None:
    """Reduced to one quotient, wherever neither divides by 0, and written."""
    try:
        wanted, reduced = parse(text).value(values), ratio(parse(text))
        assert parse(reduced.text).value(values) == wanted
    except ZeroDivisionError:
        return
    assert not (reduced - reduced) and ratio(parse(reduced.text)) == reduced


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("-2^2", -4), ("2*-3", -6), ("8/4/2", 1), ("8/4*2", 4), ("2 − 3·4", -10),
        ("1.25", Fraction(5, 4)), ("2^-2", Fraction(1, 4)), ("1 - 2 - 3", -4), ("--1", 1),
    ],
)  # fmt: skip
def test_signs_bind_as_in_the_textbooks(text: str, wanted: Fraction) -> None:
    assert parse(text).value({}) == wanted


@pytest.mark.parametrize(
    ("text", "position", "refusal"),
    [
        ("2n", 1, "left-over"), ("n f", 2, "left-over"), ("a + ", 3, "expected"),
        ("", 0, "expected"), ("(a + b", 6, "formula-unclosed"), ("a)", 1, "left-over"),
        ("a + %", 4, "formula-unknown"), ("a.b", 1, "formula-unknown"), ("x^y", 2, "whole-power"),
        ("x^1.5", 2, "whole-power"), ("x^1000", 2, "formula-too-large"),
        ("(x^60)^60", 2, "formula-too-large"), ("+a", 0, "expected"),
        ("cot(a, )", 7, "expected"), ("__import__", 0, "formula-unknown"),
        ("(" * 60 + "a" + ")" * 60, 30, "formula-too-deep"),
        ("-" * 60 + "a", 30, "formula-too-deep"),
        ("a+" * 300 + "a", 400, "formula-too-long"), ("x = 1", 2, "formula-unknown"),
    ],
)  # fmt: skip
def test_what_is_none_is_refused_where_it_stops_being_one(
    text: str, position: int, refusal: str
) -> None:
    with pytest.raises(Refusal) as refused:
        parse(text)
    error = refused.value
    assert (error.field, error.value, error.bound) == ("formula", text, REFUSALS[refusal])
    assert error.limits[1] == position + 1
    is_long = refusal == "formula-too-long"
    told = "400 characters." if is_long else f"(character {position + 1})."
    assert str(error).startswith("formula = ") and str(error).endswith(told)


@QUICK
@given(st.text(max_size=60) | st.text("()^-+*/ab12.,_ ", max_size=60))
def test_a_strangers_text_is_read_or_refused(text: str) -> None:
    with suppress(Refusal, ZeroDivisionError, LookupError):
        parse(text).value({"a": Fraction(2), "b": Fraction(3)})


def test_the_functions_are_the_arithmetics() -> None:
    tree = parse("2*atan(tan(x/2)) + sqrt(abs(y))")
    FLOATS_ABS = Arithmetic(
        float, lambda name, parts: abs(parts[0]) if name == "abs" else called(name, parts)
    )
    assert tree.value({"x": 0.5, "y": -4.0}, FLOATS_ABS) == pytest.approx(2.5, abs=1e-15)
    with pytest.raises(LookupError, match="tan"):
        tree.value({"x": Fraction(1), "y": Fraction(1)})
    assert tree.letters == ("x", "y")


def test_a_term_may_be_known_as_a_whole() -> None:
    tree = parse("2*n/(r - l)*cot(fov/2)")
    values = {"n": 3.0, "r - l": 0.5, "cot(fov/2)": 10.0}
    assert tree.value(values, FLOATS) == 120.0
    assert tree.where({"r - l": parse("w")}).text == "2*n/w*cot(fov/2)"


@pytest.mark.parametrize(
    ("text", "plain", "latex"),
    [
        ("-2*f*n/(f - n)", "−2f\u2009n/(f − n)", r"\frac{-2f \, n}{f - n}"),
        ("cot(alpha)*n", "cot(\u03b1)\u2009n", r"\cot\left(\alpha\right) \, n"),
        (
            "2*atan(2*f)*near",
            "2atan(2f)\u2009near",
            r"2 \, \arctan\left(2f\right) \, \mathrm{near}",
        ),
        ("2*near*10", "2near·10", r"2 \, \mathrm{near} \cdot 10"),
        ("4*2/3", "4·2/3", r"\frac{4 \cdot 2}{3}"),
        ("2*theta_x", "2theta_x", r"2\theta_{x}"),
        ("x^2*y", "x^2\u2009y", r"x^{2} \, y"),
        ("(x + y)^2", "(x + y)^2", r"(x + y)^{2}"),
        ("-dot(axis_u, eye)", "−axis_u·eye", r"-\mathrm{axis}_{u} \cdot \mathrm{eye}"),
        ("a - (-b)*c", "a − (−b)\u2009c", r"a - (-b) \, c"),
        ("a + (-b)/c*d", "a + (−b)/c\u2009d", r"a + \left(-\frac{b}{c}\right) \, d"),
        ("a - (b - 1/c)", "a − (b − 1/c)", r"a - \left(b - \frac{1}{c}\right)"),
        ("60*(53 - n)", "60(53 − n)", r"60 \cdot (53 - n)"),
        ("2*(-3)", "2(−3)", r"2 \cdot (-3)"),
    ],
)
def test_it_is_written_for_readers(text: str, plain: str, latex: str) -> None:
    symbols = {"alpha": "\u03b1"}
    assert formula_text.written(parse(text), symbols) == plain
    assert formula_text.latex(parse(text), symbols) == latex


@pytest.mark.parametrize(
    ("text", "stacked"),
    [
        ("2*n/(r - l)", "{2n|r − l}"),
        ("-n/f", "−{n|f}"),
        ("-2*f*n/(f - n)", "{−2f\u2009n|f − n}"),
        ("a - (-n)/f", "a − (−{n|f})"),
        ("cot(fov/2)/aspect", "{cot(fov/2)|aspect}"),  # as in print: one is enough
        ("1/(a/b)", "{1|a/b}"),
        ("x/2*(y + 1)", "{x|2}\u2009(y + 1)"),
        ("(a/b)^2", "({a|b})^2"),
        ("x + y", "x + y"),
    ],
)
def test_its_fractions_are_stacked(text: str, stacked: str) -> None:
    assert formula_text.stacked(parse(text), {}) == stacked.replace("|", formula_text.OVER)


def reduced(text: str, **terms: Ratio) -> str:
    return parse(text).value(Letters(terms), SYMBOLS).text


def test_products_become_one_quotient() -> None:
    assert reduced("f/(f - n)*(1/f)") == "1/(f - n)"
    assert reduced("-2/(f - n) + 1/f") == "-(f + n)/(f*(f - n))"
    assert reduced("2*n/(f*(r - l))*((r + l)/(2*n))") == "(r + l)/(f*(r - l))"
    assert reduced("(b - a)/(a - b)") == "-1"
    assert reduced("cot(x/2)*cot(x/2)/cot(x/2)^3") == "1/cot(x/2)"
    assert reduced("0*a/b") == "0"
    signs = {"z_n": number(-1), "z_f": number(1)}
    assert reduced("(z_n - z_f)*n*(f/(f - n))", **signs) == "-2*f*n/(f - n)"


def test_equal_formulas_are_equal_in_letters() -> None:
    def differ(one: str, other: str) -> bool:
        return bool(ratio(parse(one)) - ratio(parse(other)))

    assert not differ("(a + b)^2", "a^2 + 2*a*b + b^2")
    assert not differ("1/(a - b) - 1/(a + b)", "2*b/(a^2 - b^2)")
    assert differ("a/b*c", "a/(b*c)") and differ("cot(a)", "cot(b)")


def test_formulas_do_not_change() -> None:
    tree: Formula = parse("a + b")
    with pytest.raises(AttributeError):
        tree.left = parse("c")  # type: ignore[attr-defined]
