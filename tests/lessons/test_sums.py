"""Every sum that is written by hand in a lesson or a talk is right, to its last digit.

``640 \\cdot 1.1949 = 764.7`` is one. What has letters is reckoned in the keys.
"""

import math
import re
from collections.abc import Iterator
from itertools import pairwise

import pytest

from app.lessons.contents import CONTENT

_FUNCTIONS = {
    "sin": lambda degrees: math.sin(math.radians(degrees)),
    "cos": lambda degrees: math.cos(math.radians(degrees)),
    "tan": lambda degrees: math.tan(math.radians(degrees)),
    "cot": lambda degrees: 1.0 / math.tan(math.radians(degrees)),
    "sqrt": math.sqrt,
    "pi": math.pi,
}
_OF_NUMBERS = re.compile(r"(?:[-+*/(). \d]|sin|cos|tan|cot|sqrt|pi)+")
_PLAIN = (
    (r"\\[,!;]|\\left|\\right|°|\\%", ""),
    (r"−", "-"),
    (r"\\cdot|\\times|·|×", "*"),
    (r"\\(pi)", r"\1"),
    (r"\\[dt]?frac\{([^{}]*)\}\{([^{}]*)\}", r"((\1)/(\2))"),
    (r"\\sqrt\{([^{}]*)\}", r"sqrt(\1)"),
    (r"\\?(sin|cos|tan|cot) ?(\d+(?:\.\d+)?)", r"\1(\2)"),
    (r"\\(sin|cos|tan|cot)\(", r"\1("),
    (r"\^\{?(-?\d+)\}?", r"**(\1)"),
    (r"(\d) (?=\d{3}\b)", r"\1"),
)


def plain(text: str) -> str:
    """Write TeX, or what a sentence has instead, as a formula of Python."""
    for pattern, written in _PLAIN:
        text = re.sub(pattern, written, text)
    return text.strip(" .,;:")


def value(text: str) -> float | None:
    """Return the value of a formula of numbers; None if it is another text."""
    formula = plain(text)
    if not _OF_NUMBERS.fullmatch(formula) or not any(map(str.isdecimal, formula)):
        return None
    try:
        return float(eval(formula, {"__builtins__": {}}, _FUNCTIONS))
    except (SyntaxError, TypeError):  # a half of it: "3 units, so 2"
        return None


def sums(text: str) -> Iterator[tuple[str, str]]:
    """Yield what stands to the left and to the right of each sign = of a lesson."""
    for piece in re.findall(r"\$\$?([^$]+)\$\$?", text) + re.split(r"\$[^$]*\$|[\n;]", text):
        for left, right in pairwise(re.split(r"=|\\approx|≈", piece)):
            yield (
                re.split(r"[,:]\s|\bis\b|\bso\b|\band\b", left)[-1],
                re.split(r",\s|\band\b|\bso\b|\\ |\\quad|\s(?=[a-zA-Z])", right.strip())[0],
            )


def wrong_sums(text: str) -> tuple[int, list[str]]:
    """Count the sums of a text, and return those that are wrong."""
    count, wrong = 0, list[str]()
    for left, right in sums(text):
        one, other = value(left), value(right)
        if one is None or other is None:
            continue
        digits = re.fullmatch(r"-?\d+\.?(\d*)", plain(right))
        half = 0.5 * 10.0 ** -len(digits[1]) if digits else 0.0
        count += 1
        if abs(one - other) > half + 1e-9 * max(1.0, abs(one)):
            wrong.append(f"{left.strip()} = {right.strip()}, but it is {one:.8g}")
    return count, wrong


def test_every_sum_that_is_written_by_hand_is_right() -> None:
    count, wrong = 0, list[str]()
    for path in CONTENT.glob("*.md"):
        found, bad = wrong_sums(path.read_text(encoding="utf-8"))
        count += found
        wrong += [f"{path.name}: {each}" for each in bad]
    assert wrong == [] and count >= 60


@pytest.mark.parametrize(
    "text",
    [
        r"$x = 640 \cdot 1.195 = 764.7$",
        r"$q = 4.95/29.76 = 0.1663$, from $5/0.8337 = 5.998$ m",
        "tan(a/2) = 2·tan 20° = 0.729, so",
        r"$\frac{-2 + 0.01}{-2 - 2} = 0.4976$",
        r"$2^{20} = 1 048 577$",
    ],
)
def test_a_wrong_sum_is_found(text: str) -> None:
    assert len(wrong_sums(text)[1]) == 1
