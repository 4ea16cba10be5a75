"""Read numbers as people type them, and as this program and others print them.

``−2.5·10⁻⁵``, ``1e−05``, ``5/2`` and ``1.5e-3`` are numbers; Python's own ``1_000`` and digits of
other scripts are not.
"""

import math
import re

_SAME = str.maketrans(
    {
        **dict.fromkeys("\u2212\u2010\u2011\u2013\ufe63\uff0d", "-"),
        **dict.fromkeys("\u00a0\u2007\u2009\u200a\u202f\ufeff", " "),
    }
)
_LOW = str.maketrans("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+-0123456789")
_POWER = re.compile(r"(?:([0-9.]) ?[·×*] ?|(?<![0-9.]))10(?:\^([+-]?[0-9]+)|([⁺⁻]?[⁰¹²³⁴-⁹]+))")
_NUMBER = re.compile(r"[+-]?([0-9]+(\.[0-9]*)?|\.[0-9]+)([eE][+-]?[0-9]+)?")


def plain(text: str) -> str:
    """Write the numbers of a text in ASCII: ``-2.5e-5`` for ``−2.5·10⁻⁵``."""
    text = text.translate(_SAME).strip()
    return _POWER.sub(lambda power: f"{power[1] or 1}e{power[2] or power[3].translate(_LOW)}", text)


def number(text: str) -> float | None:
    """Read a number or a fraction; return None for any other text and beyond float64."""
    parts = [part.strip() for part in plain(text).split("/")]
    if len(parts) > 2 or not all(map(_NUMBER.fullmatch, parts)):
        return None
    above, below = float(parts[0]), float(parts[-1]) if len(parts) == 2 else 1.0
    value = above / below if below else math.inf
    return value if math.isfinite(value) else None


def numbers(text: str) -> list[float] | None:
    """Read numbers separated by commas or blanks, perhaps in brackets; None for any other text."""
    text = plain(text)
    for begin, end in ("()", "[]", "{}"):
        if text.count(begin) != text.count(end):
            return None
        text = text.replace(begin, " ").replace(end, " ")
    text = re.sub(r" ?([,/]) ?", r"\1", " ".join(text.split()))
    parts = [number(part) for part in re.split("[, ]", text)] if text else []
    values = [value for value in parts if value is not None]
    return values if len(values) == len(parts) else None
