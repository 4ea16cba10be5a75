"""Read numbers as a person types them; write them as short as a field shows them."""

import math
import re

from app.model.numerals import plain
from app.model.projection import LARGEST
from app.model.refusal import REFUSALS, Refusal
from widgets.parts.messages import number_text

FIELD_CHARACTERS = 8  # longest number, without its sign, that a field shows while it is not edited
_MOST = 6  # most digits of a number that counts as short
_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?", re.ASCII | re.IGNORECASE)
_INFINITY = re.compile(r"([+-]?)(∞|inf|infinity)", re.IGNORECASE)


def parse_number(name: str, text: str, unit: str = "", *, infinite: bool = False) -> float:
    """Read a number as typed: decimal point or comma, ``1/3``, ``inf``, perhaps with its unit.

    A `Refusal` for any other text, and for digits that float64 can only keep as infinity or as 0.
    It mentions infinity only if `infinite`, but infinity is always read: the model decides.
    """
    typed = text.strip()
    bare = plain(typed.removesuffix(unit))
    infinity = _INFINITY.fullmatch(bare)
    if infinity:
        return -math.inf if infinity[1] == "-" else math.inf
    not_a_number = REFUSALS["a-number-or-infinity"] if infinite else REFUSALS["messages-a-number"]
    parts = []
    for part in bare.split("/"):
        match = _NUMBER.fullmatch(part.strip())
        if not match:
            raise Refusal(name, typed, not_a_number)
        number = float(match[0].replace(",", "."))
        if number == 0.0 and re.search("[1-9]", match[1]):
            raise Refusal(name, typed, REFUSALS["distinct"], 0)
        parts.append(number)
    if len(parts) > 2 or parts[1:] == [0.0]:
        raise Refusal(name, typed, not_a_number)
    number = parts[0] / parts[1] if len(parts) == 2 else parts[0]
    if any(map(math.isinf, parts)) or math.isinf(number):
        bound, limit = (
            (REFUSALS["at-least"], -LARGEST) if number < 0.0 else (REFUSALS["at-most"], LARGEST)
        )
        raise Refusal(name, typed, bound, limit)
    if number == 0.0 and parts[0] != 0.0:
        raise Refusal(name, typed, REFUSALS["distinct"], 0)
    return number


def short_text(
    value: float, below: float | None = None, most: int = _MOST, above: float | None = None
) -> str:
    """Return the number unchanged if it is short, otherwise rounded to about `most` digits.

    All digits before the point are shown if they fit: coordinates far from the origin differ
    in the last of them. An exponent is never cut off. A number that stays under a bound `below` or
    over one `above` is not rounded to it: its distance is shown instead, as ``180-3e-12``.
    """
    text = _short_text(value, most)
    if math.isinf(value):
        return text
    shown = float(text)
    for bound, sign, is_crossed in (
        (below, "-", below is not None and value < below <= shown),
        (above, "+", above is not None and value > above >= shown),
    ):
        if bound is not None and is_crossed:
            if most < _MOST:
                return short_text(value, below, most + 1, above)
            return f"{bound:g}{sign}{abs(bound - value):.0e}"
    return text


def _short_text(value: float, most: int) -> str:
    if 10.0**most <= abs(value) < 10.0**FIELD_CHARACTERS - 0.5:
        return f"{value:.0f}"
    if math.isinf(value) or most == _MOST:
        text = number_text(value)
        if math.isinf(value) or len(text.lstrip("-")) <= FIELD_CHARACTERS:
            return text
    for kept in range(most, 0, -1):
        for text in (f"{value:.{kept}g}", f"{value:.{kept - 1}e}"):
            text = re.sub(r"e([+-])0*", r"e\1", text).replace("e+", "e")
            if len(text.lstrip("-")) <= FIELD_CHARACTERS:
                return text
    return text
