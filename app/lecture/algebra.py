"""Symbolic arithmetic: quotients of sums of products of letters.

Products of tables of formulas are tables of formulas, each reduced to one quotient and written as
in textbooks. Two formulas are equal in value if and only if their difference is 0 here.
"""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

from app.model.formula import Arithmetic, Formula

Monomial: TypeAlias = tuple[tuple[str, int], ...]
"""Letters, or the texts of function calls, with their powers, sorted: ``f n^2``."""
Polynomial: TypeAlias = tuple[tuple[Monomial, Fraction], ...]
"""Monomials and their coefficients, none of them 0, sorted."""

_PLANES = ("r", "l", "t", "b", "f", "n")  # their order in textbooks: ``r + l``, ``f - n``


@dataclass(frozen=True)
class Ratio:
    """A quotient of a sum by a product of sums."""

    above: Polynomial
    below: tuple[tuple[Polynomial, int], ...] = ()
    """Factors and their powers: single letters, and sums without a common factor."""

    def __bool__(self) -> bool:
        """Whether it is not identically 0."""
        return bool(self.above)

    def __neg__(self) -> "Ratio":
        return Ratio(_scaled(self.above, Fraction(-1)), self.below)

    def __add__(self, other: "Ratio") -> "Ratio":
        if not (self and other):
            return self or other
        mine, its = Counter(dict(self.below)), Counter(dict(other.below))
        common = mine | its
        total: dict[Monomial, Fraction] = {}
        for part, missing in ((self, common - mine), (other, common - its)):
            for monomial, coefficient in _times(part.above, _expanded(missing)):
                total[monomial] = total.get(monomial, Fraction(0)) + coefficient
        return _reduced(_polynomial(total), common)

    def __sub__(self, other: "Ratio") -> "Ratio":
        return self + -other

    def __mul__(self, other: "Ratio") -> "Ratio":
        for one, another in ((self, other), (other, self)):
            if one.above == _ONE and not one.below:
                return another
        below = Counter(dict(self.below)) + Counter(dict(other.below))
        return _reduced(_times(self.above, other.above), below)

    def __truediv__(self, other: "Ratio") -> "Ratio":
        coefficient, letters, rest = _parts(other.above)
        factors = Counter({_single_letter(name): power for name, power in letters})
        if rest != _ONE:
            factors[rest] += 1
        upside_down = _scaled(_expanded(Counter(dict(other.below))), 1 / coefficient)
        return self * _reduced(upside_down, factors)

    def __pow__(self, exponent: int) -> "Ratio":
        power = number(1)
        for _ in range(abs(exponent)):
            power = power * self if exponent > 0 else power / self
        return power

    @property
    def text(self) -> str:
        """The quotient as a formula's text: ``-2*f*n/(f - n)``."""
        if not self.above:
            return "0"
        coefficient, letters, rest = _parts(self.above)
        above = [str(abs(coefficient.numerator))] if abs(coefficient.numerator) != 1 else []
        below = [str(coefficient.denominator)] if coefficient.denominator != 1 else []
        above += _factors(letters)
        alone = [(part, n) for part, n in self.below if len(part) == 1]
        below += _factors([(name, n) for ((((name, _),), _),), n in alone])
        if rest != _ONE:
            needs_brackets = above or below or self.below or coefficient < 0
            above.append(f"({_sum(rest)})" if needs_brackets else _sum(rest))
        sums = [(f"({_sum(part)})", n) for part, n in self.below if len(part) > 1]
        below += [_powered(text, n) for text, n in sorted(sums)]
        product, divisor = "*".join(above) or "1", "*".join(below)
        divided = f"/({divisor})" if len(below) > 1 else f"/{divisor}" if below else ""
        return f"{'-' if coefficient < 0 else ''}{product}{divided}"


def number(value: Fraction | int) -> Ratio:
    return Ratio(_polynomial({(): Fraction(value)}))


def letter(name: str) -> Ratio:
    return Ratio(_single_letter(name))


def _call(name: str, arguments: Sequence[Ratio]) -> Ratio:
    return letter(f"{name}({', '.join(part.text for part in arguments)})")


SYMBOLS = Arithmetic(number, _call)  # the arithmetic in which letters stand for themselves


class Letters(dict[str, Ratio]):
    """The values of letters and terms, by their text; a missing letter stands for itself."""

    def __missing__(self, name: str) -> Ratio:
        return letter(name)


def ratio(formula: Formula) -> Ratio:
    fraction: Ratio = formula.value(Letters(), SYMBOLS)
    return fraction


# --------------------------------------------------------------------------- sums of products

_ONE: Polynomial = (((), Fraction(1)),)


def _single_letter(name: str) -> Polynomial:
    """Return a letter as a sum of one product of one factor."""
    return ((((name, 1),), Fraction(1)),)


def _polynomial(terms: Mapping[Monomial, Fraction]) -> Polynomial:
    return tuple(sorted((monomial, part) for monomial, part in terms.items() if part))


def _scaled(polynomial: Polynomial, factor: Fraction) -> Polynomial:
    return tuple((monomial, part * factor) for monomial, part in polynomial)


def _times(left: Polynomial, right: Polynomial) -> Polynomial:
    total: dict[Monomial, Fraction] = {}
    for a, a_part in left:
        for b, b_part in right:
            powers = Counter(dict(a)) + Counter(dict(b))
            monomial = tuple(sorted(powers.items()))
            total[monomial] = total.get(monomial, Fraction(0)) + a_part * b_part
    return _polynomial(total)


def _expanded(factors: Mapping[Polynomial, int]) -> Polynomial:
    product = _ONE
    for factor, power in factors.items():
        for _ in range(power):
            product = _times(product, factor)
    return product


def _parts(polynomial: Polynomial) -> tuple[Fraction, Monomial, Polynomial]:
    """Split a sum into a number, letters, and a sum without common factor and leading minus."""
    if not polynomial:
        raise ZeroDivisionError
    coefficients = [part for _, part in polynomial]
    content = Fraction(
        math.gcd(*(part.numerator for part in coefficients)),
        math.lcm(*(part.denominator for part in coefficients)),
    )
    _, leading = min(polynomial, key=_place)
    if leading < 0:
        content = -content
    shared = Counter(dict(polynomial[0][0]))
    for monomial, _ in polynomial:
        shared &= Counter(dict(monomial))
    rest = {
        tuple(sorted((Counter(dict(monomial)) - shared).items())): part / content
        for monomial, part in polynomial
    }
    return content, tuple(sorted(shared.items())), _polynomial(rest)


def _reduced(above: Polynomial, below: Mapping[Polynomial, int]) -> Ratio:
    """Cancel the letters and the sum that numerator and denominator share."""
    if not above:
        return Ratio(())
    coefficient, letters, rest = _parts(above)
    left = Counter(dict(letters))
    factors = Counter(below)
    for name, power in letters:
        factor = _single_letter(name)
        gone = min(power, factors[factor])
        factors[factor] -= gone
        left[name] -= gone
    if factors[rest] and rest != _ONE:
        factors[rest] -= 1
        rest = _ONE
    monomial = tuple(sorted((+left).items()))
    whole = _times(((monomial, coefficient),), rest)
    return Ratio(whole, tuple(sorted((+factors).items())))


# --------------------------------------------------------------------------- writing


def _atom_place(name: str) -> tuple[bool, int, str]:
    """Sort key of a factor: the planes in their order, other letters, then functions."""
    return "(" in name, _PLANES.index(name) if name in _PLANES else -1, name


def _place(term: tuple[Monomial, Fraction]) -> tuple[int, list[tuple[bool, int, str]]]:
    """Sort key of a term of a sum: shorter terms first."""
    monomial, _ = term
    return sum(n for _, n in monomial), sorted(_atom_place(name) for name, _ in monomial)


def _powered(text: str, power: int) -> str:
    return text if power == 1 else f"{text}^{power}"


def _factors(letters: Sequence[tuple[str, int]]) -> list[str]:
    ordered = sorted(letters, key=lambda item: _atom_place(item[0]))
    return [_powered(name, power) for name, power in ordered]


def _sum(polynomial: Polynomial) -> str:
    text = ""
    for monomial, part in sorted(polynomial, key=_place):
        size = [str(abs(part))] if abs(part) != 1 or not monomial else []
        term = "*".join([*size, *_factors(monomial)])
        sign = ("-" if part < 0 else "") if not text else " - " if part < 0 else " + "
        text += sign + term
    return text
