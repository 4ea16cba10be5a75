"""A typed number: what is read, what counts as right."""

import math
from collections.abc import Iterator
from fractions import Fraction

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from app.lessons import marking
from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Here
from app.lessons.blocks.exercise import Exercise
from app.lessons.blocks.matrix import MatrixQuestion
from app.lessons.contents import contained
from app.lessons.course import Course
from app.lessons.lesson import read
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


WAYS = (
    ("1/2", 0.5), ("1 1/2", 1.5), ("-1 1/2", -1.5), ("½", 0.5), ("1½", 1.5), ("1 ½", 1.5),
    ("-½", -0.5), ("sqrt(3)", math.sqrt(3)), ("√3", math.sqrt(3)), ("-√3/2", -math.sqrt(3) / 2),
    ("√(3)/2", math.sqrt(3) / 2), ("2√3", 2 * math.sqrt(3)), ("1/√2", 1 / math.sqrt(2)),
    ("pi/6", math.pi / 6), ("π/6", math.pi / 6), ("2π", 2 * math.pi), ("1.17e-2", 0.0117),
    ("1.17E-2", 0.0117), ("1.17×10^-2", 0.0117), ("1.17·10⁻²", 0.0117), ("1.17 * 10^(-2)", 0.0117),
    ("1.17x10^-2", 0.0117), ("10⁻²", 0.01), ("0,5", 0.5), (",5", 0.5), ("5,", 5.0), ("–7", -7.0),
    ("—7", -7.0), ("−7", -7.0), ("- 7", -7.0), ("+7", 7.0), ("1 280", 1280.0), ("1 280", 1280.0),
    ("12 345.5", 12345.5), ("3\u20444", 0.75), ("1.5x", 1.5), ("45 %", 0.45), ("2²", 4.0),
    ("2/1e3", 0.002), ("2*tan(30°)", 2 / math.sqrt(3)), ("2 tan(30)", 2 / math.sqrt(3)),
    ("(1+2)/4", 0.75), ("-(1/2)", -0.5), ("2**3", 8.0), ("sqrt(3^2+4^2)", 5.0),
    ("\uff10.\uff15", 0.5), ("1.5 · 10^3", 1500.0), ("1.5×10³", 1500.0), ("2π/3", 2 * math.pi / 3),
    ("1e3", 1000.0), (".5", 0.5), ("5.", 5.0), ("√½", math.sqrt(0.5)), ("16:9", 16 / 9),
    ("= 0.5", 0.5), ("≈0.5", 0.5), ("arctan(1)", 45.0), ("⅔", 2 / 3), ("1e−3", 1e-3),
    ("1\u2009280", 1280.0), ("1\u202f280", 1280.0), ("33 1/3", 100 / 3),
    ("1/(2√3)", 0.5 / math.sqrt(3)), ("tan 45", 1.0), ("tan45°", 1.0), ("sqrt 3", math.sqrt(3)),
    ("2 tan 30°", 2 / math.sqrt(3)), ("2tan 30", 2 / math.sqrt(3)), ("-cos 60 °", -0.5),
    ("tan -45", -1.0), ("tan 45 + 1", 2.0), ("1/tan 45", 1.0), ("2 sin 30 cos 60", 0.5),
    ("sin 30/cos 60", 1.0), ("sqrt 3 tan 30", 1.0), ("arctan 1", 45.0), ("2arctan 1", 90.0),
    ("atan(2 sin 30°)", 45.0), ("tan(90°/2)", 1.0), ("cos(180° - 2*60°)", 0.5), ("tan 4,5e1", 1.0),
    *((f"{minus}7", -7.0) for minus in "-\u2212\u2010\u2011\u2012\u2013\u2014\u2015\ufe63\uff0d"),
)  # fmt: skip


@pytest.mark.parametrize(("text", "value"), WAYS)
def test_every_way_to_write_a_right_number_is_right(text: str, value: float) -> None:
    assert marking.equals(marking.read(text), value)
    assert float(marking.read(text).value) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("340 cm", "m", 3.4), ("3400 mm", "m", 3.4), ("3.4 m", "mm", 3400), ("0.05 km", "m", 50),
        ("pi/6 rad", "°", 30), ("π/6 rad", "°", 30), ("90°", "rad", math.pi / 2),
        ("45 %", "", 0.45),
        ("0.45×", "%", 45), ("30º", "°", 30), ("30 ˚", "°", 30), ("30\u2009deg", "°", 30),
        ("60°", "rad", math.pi / 3), ("1.5 mm", "cm", 0.15), ("12px", "px", 12),
        ("2 atan 0.5°", "°", 2 * math.degrees(math.atan(0.5))),
        ("√3/2 m", "cm", 50 * math.sqrt(3)), ("1 1/2 m", "cm", 150),
    ],
)  # fmt: skip
def test_a_unit_of_the_same_kind_is_converted(text: str, unit: str, value: float) -> None:
    assert float(marking.read(text, unit).value) == pytest.approx(value, rel=1e-12)


TYPED = (
    # Angles with a pi are in radians, others in degrees.
    ("cos(pi/6)", "", math.sqrt(3) / 2), ("sin(π/6)", "", 0.5), ("tan(45*pi/180)", "", 1.0),
    ("cos(pi/3 rad)", "", 0.5), ("sin(0.5 rad)", "", math.sin(0.5)),
    ("cos(180/pi)", "", math.cos(1)), ("sin(30 deg)", "", 0.5),
    ("cos π", "", -1.0), ("tan(pi/4 + pi/2)", "", -1.0),
    ("atan(1)", "rad", math.pi / 4), ("atan(1) rad", "°", 45.0), ("2 atan(1)°", "rad", math.pi / 2),
    # Names of functions, roots and powers.
    ("tg 45", "", 1.0), ("ctg(45°)", "", 1.0), ("arctg 1", "°", 45.0), ("tan^-1(1)", "°", 45.0),
    ("tan⁻¹(1)", "°", 45.0), ("cos^(-1) 0.5", "°", 60.0), ("3^(1/2)/2", "", math.sqrt(3) / 2),
    ("3^0.5", "", math.sqrt(3)), ("2^-0.5", "", math.sqrt(0.5)), ("8^(1/3)", "", 2.0),
    ("(1 + 3)^½", "", 2.0), ("2*sin(30)^0.5", "", math.sqrt(2)), ("-4^(1/2)", "", -2.0),
    ("3^(−1/2)", "", 1 / math.sqrt(3)),
    # Division, multiplication, fractions of one letter.
    ("6÷4", "", 1.5), ("16\u22369", "", 16 / 9), ("½√3", "", math.sqrt(3) / 2), ("-1½", "", -1.5),
    ("3*2½", "", 7.5), ("√2¼", "", 1.5), ("2∙3", "", 6.0), ("5 – 3", "", 2.0),
    # Endless decimals, names, words and signs before and behind a number.
    ("0.333...", "", 0.333), ("1,666…", "", 1.666), ("x=2", "", 2.0), ("v_y = 0,9", "", 0.9),
    ("y' = ½", "", 0.5), ("y\u2032=2", "", 2.0), ("x₂=5", "", 5.0), ("β ≈ 45°", "°", 45.0),
    ("ca. 5", "", 5.0), ("cca 5", "", 5.0), ("about 60", "", 60.0), ("≅5", "", 5.0),
    ("approx. 2.5", "", 2.5), ("~5", "", 5.0), ("\uff5e5", "", 5.0), ("0.5.", "", 0.5),
    ("45°.", "°", 45.0), ("0,5;", "", 0.5), ("1/2.", "", 0.5),
    # Digits of other scripts, and signs that cannot be seen.
    ("\u0663\u066b\u0665", "", 3.5), ("\u06f1\u06f2", "", 12.0), ("\u0967.\u096b", "", 1.5),
    ("\uff11\uff12\uff0c\uff15", "", 12.5),
    ("\u200f-5\u200e", "", -5.0), ("1\u200b2", "", 12.0),
    # Thousands.
    ("1'280", "", 1280.0), ("1\u2019280\u2019000,5", "", 1280000.5), ("1_280", "", 1280.0),
    ("1.280,5", "", 1280.5), ("1,280.5", "", 1280.5), ("1,280,000", "", 1280000.0),
    ("1.280.000", "", 1280000.0), ("1 280 000", "", 1280000.0), ("1\u066c280", "", 1280.0),
    # Units in words, and signs of degrees.
    ("3.4 metres", "m", 3.4), ("340 centimeters", "m", 3.4), ("3.4 kilometre", "m", 3400.0),
    ("45 stupnjeva", "°", 45.0), ("oko 45 kraadi", "°", 45.0), ("45 степени", "°", 45.0),
    ("3,4 metra", "cm", 340.0), ("340 цм", "m", 3.4), ("340 sentimeetrit", "m", 3.4),
    ("umbes 50 piksela", "px", 50.0), ("2,5 puta", "×", 2.5), ("45 odsto", "", 0.45),
    ("otprilike 3 jedinice", "units", 3.0), ("1,5 радијана", "rad", 1.5),
    ("45 per cent", "", 0.45), ("1.5 times", "", 1.5), ("60⁰", "°", 60.0), ("110⁰", "°", 110.0),
    ("60∘", "°", 60.0), ("tan 60⁰", "", math.sqrt(3)), ("2·10⁰", "", 2.0),
    ("π/2 radians", "°", 90.0),
)  # fmt: skip


@pytest.mark.parametrize(("text", "unit", "value"), TYPED)
def test_what_students_type_is_read_as_they_mean_it(text: str, unit: str, value: float) -> None:
    assert float(marking.read(text, unit).value) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("1/2√3", "; 1/2√3 may be (1/2)*√3 or 1/(2*√3): write one of them"),
        ("1/2π", "; 1/2π may be (1/2)*π or 1/(2*π): write one of them"),
        ("(1+2)/4(3)", "may be ((1+2)/4)*(3) or (1+2)/(4*(3)): write"),
        ("3^1/2", "; 3^1/2 may be 3^(1/2) or 3/2: write one of them"),
        ("1.5(3)", "; 1.5(3) may be 1.5*3 or 1.533...: write one of them"),
        ("2.5×10-2", "; 2.5×10-2 may be 2.5×10^-2 or (2.5×10)-2: write one of them"),
        ("cos π/3", "; cos π/3 may be cos(π)/3 or cos(π/3): write one of them"),
        ("cos(60°*pi/180)", "; cos(60°*pi/180) mixes degrees and radians"),
        ("cos(pi/6 + acos(0.5))", "mixes degrees and radians"),
        ("0.33...", "must have 3 significant digits in front of “...”"),
        ("2–3", "; –3 cannot be read"), ("(1,2)", "; ,2) cannot be read"),
        ("5₁₀", "; ₁₀ cannot be read"), ("±5", "; ±5 cannot be read"), ("+-5", "; +-5 cannot"),
        ("2*3=6", "; =6 cannot be read"), ("45°30'", "; °30' cannot be read"), ("5!", "; ! cannot"),
        ("2, 3", "; , 3 cannot be read"), ("2;3", "; ;3 cannot be read"),
        ("1,00,000", "; .000 cannot"),
        ("0.5 (50%)", "; %) cannot be read"), ("2.5 e-3", "; e is neither"), ("∞", "; ∞ cannot"),
    ],
)  # fmt: skip
def test_what_may_mean_two_things_is_asked_back(text: str, said: str) -> None:
    with pytest.raises(Refusal) as caught:
        marking.read(text)
    assert said in str(caught.value)


def test_a_comma_of_thousands_is_asked_about_only_where_the_number_is_so_large() -> None:
    """With a comma people write 1.28 in one country, and 1280 in another."""
    for text in ("1,280", "1.280", "12,345 px"):
        assert marking.read(text, "px", near=360.0).value < 13
        with pytest.raises(Refusal, match=r"may be .* or .*: write one of them"):
            marking.read(text, "px", near=1280.0)
    for text in ("1,28", "1,2800", "0,128", "1280", "1 280", "1.280e3"):
        assert marking.read(text, "px", near=1280.0).value > 0


def test_a_converted_number_keeps_its_digits() -> None:
    assert marking.equals(marking.read("343 cm", "m"), 3.4267)
    assert not marking.equals(marking.read("34 mm", "mm"), 3.4)
    assert marking.read("34e1 cm", "m").digits == 2


@pytest.mark.parametrize(
    ("text", "unit", "said"),
    [
        ("2.145°", "", "must be a number without °"), ("45 %", "px", "must be in px"),
        ("3.4 m", "", "must be a number without m"), ("12 px", "°", "must be in °"),
        ("3400 px", "m", "must be in m"), ("3.4 m", "°", "must be in °"),
        ("2 units", "cm", "must be in cm"),
        ("", "", "nothing is typed yet"), ("   ", "", "nothing is typed yet"),
        ("°", "", "nothing is typed yet"), ("1/0", "", "nothing can be divided by 0"),
        ("1/0.0", "", "nothing can be divided by 0"),
        ("1e400", "", "whose power of ten is between -100 and 100"),
        ("9e999999999", "", "whose power of ten is between -100 and 100"),
        ("1" * 61, "", "at most 60 characters"),
        ("10*10^100", "", "whose power of ten is between -100 and 100"), ("1/2/", "", "after 1/2/"),
        ("1.2.3", "", "3; .3 cannot be read"), ("2 3", "", "; 3 cannot be read"),
        ("__import__('os')", "", "; __import__('os') cannot be read"), ("1)", "", "; ) cannot be"),
        ("2^pi", "", "; pi cannot be read"), ("√-1", "", "sqrt is neither"),
        ("sqrt(-1)", "", "no value"),
        ("asin(2)", "", "no value"), ("sqrt(1, 2)", "", "no value"), ("√", "", "sqrt is neither"),
        ("tan 45/2", "", "; tan 45/2 may be tan(45)/2 or tan(45/2): write one of them"),
        ("3 tan 60°/2", "", "; tan 60°/2 may be tan(60°)/2 or tan(60°/2): write one of them"),
        *((text, "", "write one of them") for text in (
            "sin 30*2", "cos 60^2", "tan 1 1/2", "tan 45(2)", "sin 2 pi", "2 atan 1/2",
        )),
        *((text, "", f"; {name} is neither a number nor a unit") for text, name in (
            ("abc", "abc"), ("nan", "nan"), ("inf", "inf"), ("0x10", "x10"), ("2n/3", "n"),
            ("foo(2)", "foo"), ("2 or 3", "or"), ("infinity", "infinity"), ("60 o", "o"),
        )),
    ],
)  # fmt: skip
def test_another_unit_or_no_number_is_refused(text: str, unit: str, said: str) -> None:
    with pytest.raises(Refusal) as caught:
        marking.read(text, unit)
    begin = "answer = " if text.strip() else "answer must be a number"
    assert said in str(caught.value) and str(caught.value).startswith(begin)


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
        ("3", math.pi, False), ("16/5", math.pi, False),
        # Whole numbers are not rounded, and so are no expressions of them.
        ("355/113", math.pi, False), ("22/7", math.pi, False), ("1/3", 1.0 / 3.0, True),
        ("8/2^12", 8.0 / 4095.0, False), ("8/(2^12 - 1)", 8.0 / 4095.0, True),
        ("0.00195", 8.0 / 4095.0, True), ("8.0/2^12", 8.0 / 4095.0, True),
        ("2*tan(30)", 2.0 / math.sqrt(3.0), True), ("1.73/3", 1.0 / math.sqrt(3.0), True),
        ("0", 0.001, False), ("0.000", 0.001, False),
        # Upwards as downwards, although neither 3.2 nor 0.9 is a float64.
        ("3.21", 3.2, True), ("3.19", 3.2, True), ("3.22", 3.2, False), ("3.18", 3.2, False),
        ("4.01", 4.0, True), ("3.99", 4.0, True), ("4.02", 4.0, False), ("3.98", 4.0, False),
        ("-0.901", -0.9, True), ("-0.899", -0.9, True), ("1 1/2", 1.5, True), ("11/2", 1.5, False),
    ],
)  # fmt: skip
def test_what_counts_as_right(text: str, value: float, right: bool) -> None:
    assert marking.equals(marking.read(text), value) is right


@pytest.mark.parametrize(
    ("one", "other", "alike"),
    [
        (0.9501, 0.9501, True), (1.0, 0.993, True), (1.0, 0.985, False), (2.0, 2.02, True),
        (2.0, 2.0201, False), (9.99, 10.05, True), (-2.0, -2.02, True), (-2.0, 2.0, False),
        (0.0, 1e-17, True), (0.0, 0.001, False), (65535.0, 65536.0, True), (0.0305, 0.0312, False),
        (0.9978, 0.9901, True),
    ],
)  # fmt: skip
def test_values_are_alike_if_a_number_counts_as_both(one: float, other: float, alike: bool) -> None:
    assert marking.are_alike(one, other) is marking.are_alike(other, one) is alike


@example(value=9900.0, more=0.015625)
@given(value=st.floats(0.001, 1e4), more=st.floats(-0.03, 0.03))
def test_a_number_counts_as_two_values_only_if_they_are_alike(value: float, more: float) -> None:
    other = value * (1.0 + more)
    most = math.log10(max(value, other))
    numbers = [10.0 ** math.floor(most), 10.0 ** math.ceil(most)]
    for each in (value, other):
        unit = 10.0 ** (math.floor(math.log10(each)) - 2)
        numbers += [each - unit, each, each + unit]
    typed = [marking.read(f"{number:#.3g}") for number in numbers]
    both = [each for each in typed if marking.equals(each, value) and marking.equals(each, other)]
    assert bool(both) is marking.are_alike(value, other), both


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.95003, "0.95003"), (0.9501, "0.9501"), (math.sqrt(3), "1.732"), (0.5, "0.5"),
        (16777215.0, "16777215"), (60.0004, "60.0004"), (2.0 / 3.0, "0.6667"),
        (-0.95003, "-0.95003"), (0.12, "0.12"),
    ],
)  # fmt: skip
def test_an_answer_is_shown_so_that_it_counts(value: float, text: str) -> None:
    """Four digits without zeros at the end may leave one or two, which do not count."""
    assert f"{value:.{marking.digits_shown(value, 4)}g}" == text
    assert marking.equals(marking.read(text), value)
    assert [marking.digits_shown(each, 4) for each in (math.inf, 1e-310, 1.25e305)] == [10, 4, 10]


def test_what_lacks_only_digits_is_told_apart_from_what_is_wrong() -> None:
    for text, value, too_short in (
        ("91", 91.49284451967722, True), ("90.1", 91.49284451967722, False),
        ("60", 91.49284451967722, False), ("92", 91.49284451967722, False),
        ("1", 0.8333, False),  # it may be wrong as well
        ("0.83", 0.8333, True),
    ):  # fmt: skip
        assert marking.is_too_short(marking.read(text), value) is too_short, text


@pytest.mark.parametrize(
    ("text", "value", "said"),
    [
        ("-91.5", 91.4928, "the sign is wrong"), ("-3", 91.4928, "and so is the size"),
        ("9.15", 91.4928, "power of ten"), ("915", 91.4928, "power of ten"),
        ("0.5", 2.0, "1 divided by"), ("1.60", 91.4928, "degrees and radians"),
        ("183", 91.4928, "too large, by a factor of about 2."),
        ("30", 91.4928, "too small, by a factor of about 3."),
        ("92.5", 91.4928, "not exact enough"), ("95", 91.4928, "not exact enough"),
        ("97", 91.4928, "too large, by a factor of about 1.1."),
        ("130", 91.4928, "too large, by a factor of about 1.4."),
        ("87", 91.4928, "too small, by a factor of about 1.1."),
        ("400", 3.2, "too large, by a factor of about 120."),
        ("1000", 10.04, "too large, by a factor of about 100."),
        ("0.001", 123.0, "too small, by a factor of about 120000."),
    ],
)  # fmt: skip
def test_a_wrong_number_is_told_how_it_is_wrong(text: str, value: float, said: str) -> None:
    remark = marking.remark(marking.read(text), value)
    assert remark is not None and said in str(remark)


def test_nothing_is_said_where_nothing_follows() -> None:
    assert marking.remark(marking.read("0"), 2.0) is None
    assert marking.remark(marking.read("2"), 0.0) is None


PARTS = (
    "1", "2", "0.5", "3,4", "1e9", "e-3", "999", "½", "²", "⁻", "⁰", "₂", "(", ")", "^", "^(1/2)",
    "^0.5", "√", "sqrt", "pi", "cos", "tg", "a", "x", "×", "·", "-", "–", "+", "/", ":", "%", "°",
    "rad", "m", "=", "≈", "ca.", "...", "'", "_", " ", "\u0663", "\u200f", "max", ";", "|",
)  # fmt: skip


@given(
    parts=st.lists(st.sampled_from(PARTS), max_size=9), unit=st.sampled_from(["", "°", "rad", "m"])
)
def test_whatever_is_typed_is_read_or_refused_in_a_sentence(parts: list[str], unit: str) -> None:
    try:
        typed = marking.read("".join(parts), unit, near=2000.0)
    except Refusal as error:
        assert str(error).startswith("answer ")
    else:
        assert abs(typed.value) <= 10**302 and typed.unit >= 0


@given(value=st.floats(0.01, 1e4), off=st.integers(-(10**6), 10**6))
def test_the_tolerance_is_the_same_upwards_and_downwards(value: float, off: int) -> None:
    exact = Fraction(f"{value:.4g}")
    away = Fraction(off, 10**7) * exact
    up, down = (
        marking.TypedNumber(exact + sign * away, 4, Fraction(1, 1000) * exact) for sign in (1, -1)
    )
    assert marking.equals(up, float(exact)) is marking.equals(down, float(exact))


def test_every_right_number_may_be_written_in_30_ways() -> None:
    """Each of some values, in each of the ways to write such a value."""
    for value in (0.5, 1.5, -0.75, 12.0, 0.0117, 1280.0, 91.25, -0.8125):
        size, power = abs(Fraction(f"{value:.4g}")), math.floor(math.log10(abs(value)))
        digits, minus = f"{float(size):.4g}", "-" if value < 0 else ""
        head = f"{float(size):.3e}".partition("e")[0]
        longer = f"{digits}0" if "." in digits else f"{digits}.0"
        raised = str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        whole, part = divmod(size, 1)
        top, bottom = size.numerator, size.denominator
        ways = [
            digits, digits.replace(".", ","), f" {digits} ", longer, longer.replace(".", ","),
            f"{top}/{bottom}", f"{top} / {bottom}", f"{top}:{bottom}", f"{top}\u2044{bottom}",
            f"{whole} {part}" if whole and part else f"{digits}×", f"({digits})", f"={digits}",
            f"{float(size):.3e}", f"{float(size):.3E}", f"{digits}e0", f"{head}·10^{power}",
            f"{head} · 10^{power}", f"{head}×10^{power}", f"{head}x10^({power})",
            f"{head}·10{raised}", f"{head} × 10{raised}", f"{head}*10**{power}",
            f"√({digits}^2)", f"sqrt({digits}*{digits})", f"{digits}·√4/2", f"√16*{digits}/4",
            f"2*{digits}/2", f"{digits}·π/pi", f"{100 * top}/{bottom} %", f"½*{digits}*2",
            "".join(chr(ord(sign) + 0xFEE0) if sign.isdigit() else sign for sign in digits),
        ]  # fmt: skip
        assert len(ways) >= 30
        for way in ways:
            signed = f"={minus}{way[1:]}" if way[0] == "=" else minus + way.lstrip()
            assert marking.equals(marking.read(signed), value), (value, signed)


def right_numbers() -> Iterator[tuple[float, str]]:
    """Yield the right numbers of all lessons with their units; three variants of an exercise."""
    for path in contained():
        course = Course(read(path))
        for place, step in enumerate(course.lesson.steps):
            here = course.at(place)
            for part in step.asked:
                asked: list[tuple[object, Here]] = [(part, here)]
                if isinstance(part, Exercise):
                    variants = [part.variant(here, seed) for seed in (1, 2, 3)]
                    asked = [(variant.question, variant.here) for variant in variants]
                for question, there in asked:
                    if isinstance(question, Answer | MatrixQuestion):
                        values = question.values(there, *question.key)
                        yield from ((value, question.unit) for value in values if value)


def test_random_wrong_numbers_are_not_right() -> None:
    """Of 10 000 at most 10 count on average: three digits, of the size of the right number.

    Their logarithms are distributed evenly from a tenth of the right number to ten times as much;
    half have the other sign. The right number at three digits is not wrong. The average is exact:
    only numbers within 3 % of the right one could count, and all of them are tried.
    """
    known, share = list(right_numbers()), 0.0
    for value, unit in known:
        near = {f"{value * (1.0 + part / 2000.0):.2e}" for part in range(-60, 61)}
        for text in near - {f"{value:.2e}"}:
            typed = marking.read(text, unit)
            if marking.equals(typed, value):
                share += float(typed.unit / abs(typed.value)) / (2.0 * math.log(100.0))
    assert len(known) > 50 and 1e-4 < share / len(known) <= 1e-3, share / len(known)
