"""Formulas: the small language in which matrices are stated, evaluated and shown.

A formula is text, parsed once into a tree::

    sum      = product { ("+" | "-") product }
    product  = signed { ("*" | "/") signed }
    signed   = "-" signed | power
    power    = atom [ "^" ["-"] whole number ]
    atom     = number | letter | function "(" sum { "," sum } ")" | "(" sum ")"

with the precedence of the textbooks (``-n^2`` is ``-(n^2)``, ``a/b*c`` is ``(a/b)*c``). A letter
may have a subscript: ``n``, ``z_near``, ``alpha``. A tree has a value in any arithmetic (rationals,
float64, the ratios of letters of `app.lecture.algebra`) and is written as text or LaTeX in the
symbols of a lecture. Python never evaluates the text, and its size is bounded: `LONGEST`,
`DEEPEST`, `LARGEST_DEGREE`.
"""

import operator
import re
from abc import abstractmethod
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any, ClassVar, NamedTuple, TypeAlias

from app.languages import said
from app.model.refusal import REFUSALS, Bound, Refusal

LONGEST = 400  # characters
DEEPEST = 30  # nested brackets, signs and functions
LARGEST_DEGREE = 100  # factors of the largest product, with all powers multiplied out


def _refused(text: str, position: int, bound: Bound, figure: object) -> Refusal:
    """Refuse a text that is not a formula from a position on, counted from 0."""
    return Refusal("formula", text, bound, figure, position + 1)


class Arithmetic(NamedTuple):
    """The constructors of numbers, and the functions by name; operators are Python's own."""

    number: Callable[[Fraction], Any]
    call: Callable[[str, Sequence[Any]], Any]


def _no_function(name: str, arguments: Sequence[Any]) -> Any:
    raise LookupError(f"{name}: no such function here")


Evaluator: TypeAlias = Callable[[Mapping[str, Any], Arithmetic], Any]

EXACT = Arithmetic(Fraction, _no_function)
FLOAT64 = Arithmetic(float, _no_function)


# --------------------------------------------------------------------------- the tree


@dataclass(frozen=True)
class Formula:
    """A formula, or a part of one; formulas are equal if their trees are."""

    @cached_property
    def text(self) -> str:
        """The formula as text, without needless brackets: ``2*n/(r - l)``."""
        return _SOURCE.write(self)

    @property
    def parts(self) -> "tuple[Formula, ...]":
        """The direct parts of the formula."""
        return ()

    def __iter__(self) -> "Iterator[Formula]":
        """Iterate over the formula and all its parts, from the outside in."""
        yield self
        for part in self.parts:
            yield from part

    @property
    def letters(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(part.name for part in self if isinstance(part, Letter)))

    def value(self, known: Mapping[str, Any], arithmetic: Arithmetic = EXACT) -> Any:
        """The value of the formula, or a KeyError for an unknown letter.

        `known` holds the value of every letter, and perhaps of whole terms by their text: ``r - l``
        where a width is not the difference of its rounded sides, ``cot(fov/2)``.
        """
        return self.evaluate(known, arithmetic)

    @cached_property
    @abstractmethod
    def evaluate(self) -> Evaluator:
        """Return `value` as a function that walks the tree only once."""

    def where(self, terms: "Mapping[str, Formula]") -> "Formula":
        """Replace letters or terms, given by their text, with other formulas."""
        term = terms.get(self.text)
        return self.with_parts(part.where(terms) for part in self.parts) if term is None else term

    def with_parts(self, parts: "Iterable[Formula]") -> "Formula":
        return type(self)(*parts) if self.parts else self


@dataclass(frozen=True)
class Number(Formula):
    """A whole number or a decimal fraction."""

    number: Fraction

    @cached_property
    def evaluate(self) -> Evaluator:
        made: dict[Callable[[Fraction], Any], Any] = {}

        def number(known: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
            if arithmetic.number not in made:
                made[arithmetic.number] = arithmetic.number(self.number)
            return made[arithmetic.number]

        return number


@dataclass(frozen=True)
class Degrees(Number):
    """An angle in a worked solution: a number that is written with its degree sign."""


@dataclass(frozen=True)
class Letter(Formula):
    """A letter: ``n``, ``fov``, ``p_11``."""

    name: str

    @cached_property
    def evaluate(self) -> Evaluator:
        name = self.name
        return lambda known, arithmetic: known[name]


@dataclass(frozen=True)
class Call(Formula):
    """A function: ``cot(fov/2)``."""

    name: str
    arguments: tuple[Formula, ...]

    @property
    def parts(self) -> tuple[Formula, ...]:
        return self.arguments

    @cached_property
    def evaluate(self) -> Evaluator:
        text, name = self.text, self.name
        arguments = [part.evaluate for part in self.arguments]

        def call(known: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
            if text in known:
                return known[text]
            return arithmetic.call(name, [part(known, arithmetic) for part in arguments])

        return call

    def with_parts(self, parts: Iterable[Formula]) -> Formula:
        return Call(self.name, tuple(parts))


@dataclass(frozen=True)
class Negative(Formula):
    """``-operand``."""

    operand: Formula

    @property
    def parts(self) -> tuple[Formula, ...]:
        return (self.operand,)

    @cached_property
    def evaluate(self) -> Evaluator:
        operand = self.operand.evaluate
        return lambda known, arithmetic: -operand(known, arithmetic)


@dataclass(frozen=True)
class Power(Formula):
    """``base^exponent`` with a whole exponent."""

    base: Formula
    exponent: int

    @property
    def parts(self) -> tuple[Formula, ...]:
        return (self.base,)

    @cached_property
    def evaluate(self) -> Evaluator:
        base, exponent = self.base.evaluate, self.exponent
        return lambda known, arithmetic: base(known, arithmetic) ** exponent

    def with_parts(self, parts: Iterable[Formula]) -> Formula:
        (base,) = parts
        return Power(base, self.exponent)


@dataclass(frozen=True)
class Pair(Formula):
    """Two formulas and the sign between them."""

    sign: ClassVar[Any]

    left: Formula
    right: Formula

    @property
    def parts(self) -> tuple[Formula, ...]:
        return (self.left, self.right)

    @cached_property
    def evaluate(self) -> Evaluator:
        text, sign, left, right = self.text, self.sign, self.left.evaluate, self.right.evaluate

        def pair(known: Mapping[str, Any], arithmetic: Arithmetic) -> Any:
            if text in known:
                return known[text]
            return sign(left(known, arithmetic), right(known, arithmetic))

        return pair


class Sum(Pair):
    """``left + right``."""

    sign = operator.add


class Difference(Pair):
    """``left - right``."""

    sign = operator.sub


class Product(Pair):
    """``left*right``."""

    sign = operator.mul


class Quotient(Pair):
    """``left/right``."""

    sign = operator.truediv


# --------------------------------------------------------------------------- reading


@lru_cache(maxsize=4096)
def parse(text: str) -> Formula:
    """Read a formula, or raise a `Refusal`; ``−``, ``·`` and ``×`` stand for ``-`` and ``*``."""
    return _FormulaParser(text).whole()


_TOKEN = re.compile(
    r"\s*(?:(?P<number>[0-9]+(?:\.[0-9]*)?|\.[0-9]+)"
    r"|(?P<name>[^\W\d_][^\W_]*(?:_[^\W_]+)*)"
    r"|(?P<sign>[-+*/^(),−·×]))"
)
_ALIKE = {"−": "-", "·": "*", "×": "*"}
_PAIRS: dict[str, type[Pair]] = {"+": Sum, "-": Difference, "*": Product, "/": Quotient}


class _Token(NamedTuple):
    kind: str
    text: str
    position: int


class _FormulaParser:
    """Recursive descent: one method for each line of the grammar."""

    def __init__(self, text: str) -> None:
        self._text = text
        if len(text) > LONGEST:
            raise _refused(text, LONGEST, REFUSALS["formula-too-long"], LONGEST)
        self._tokens = list(self._read())
        self._next = 0
        self._depth = 0

    def _read(self) -> Iterator[_Token]:
        at = 0
        end = len(self._text.rstrip())
        while at < end:
            match = _TOKEN.match(self._text, at)
            if match is None:
                at += len(self._text[at:]) - len(self._text[at:].lstrip())
                raise _refused(self._text, at, REFUSALS["formula-unknown"], self._text[at])
            assert match.lastgroup is not None
            token = match[match.lastgroup]
            yield _Token(match.lastgroup, _ALIKE.get(token, token), match.start(match.lastgroup))
            at = match.end()
        yield _Token("end", "the end", end)

    def whole(self) -> Formula:
        formula = self._sum()
        if self._token.kind != "end":
            raise self._refused(REFUSALS["left-over"])
        _degree(formula, self._text)
        return formula

    @property
    def _token(self) -> _Token:
        return self._tokens[self._next]

    def _taken(self, *signs: str) -> str:
        """Read the next token if it is one of these signs; return its text, else an empty one."""
        token = self._token
        if token.kind != "sign" or token.text not in signs:
            return ""
        self._next += 1
        return token.text

    def _refused(self, refusal: Bound) -> Refusal:
        text = said("the end") if self._token.kind == "end" else self._token.text
        return _refused(self._text, self._token.position, refusal, text)

    def _sum(self) -> Formula:
        self._depth += 1
        if self._depth > DEEPEST:
            raise _refused(self._text, self._token.position, REFUSALS["formula-too-deep"], DEEPEST)
        formula = self._product()
        while sign := self._taken("+", "-"):
            formula = _PAIRS[sign](formula, self._product())
        self._depth -= 1
        return formula

    def _product(self) -> Formula:
        formula = self._signed()
        while sign := self._taken("*", "/"):
            formula = _PAIRS[sign](formula, self._signed())
        return formula

    def _signed(self) -> Formula:
        if not self._taken("-"):
            return self._power()
        self._depth += 1
        if self._depth > DEEPEST:
            raise _refused(self._text, self._token.position, REFUSALS["formula-too-deep"], DEEPEST)
        formula = Negative(self._signed())
        self._depth -= 1
        return formula

    def _power(self) -> Formula:
        base = self._atom()
        if not self._taken("^"):
            return base
        sign = -1 if self._taken("-") else 1
        if self._token.kind != "number" or not self._token.text.isdigit():
            raise self._refused(REFUSALS["whole-power"])
        if len(self._token.text) > len(str(LARGEST_DEGREE)):
            raise _refused(
                self._text, self._token.position, REFUSALS["formula-too-large"], LARGEST_DEGREE
            )
        exponent = sign * int(self._token.text)
        self._next += 1
        return Power(base, exponent)

    def _atom(self) -> Formula:
        token = self._token
        if token.kind == "number":
            self._next += 1
            return Number(Fraction(token.text))
        if token.kind == "name":
            self._next += 1
            if not self._taken("("):
                return Letter(token.text)
            arguments = [self._sum()]
            while self._taken(","):
                arguments.append(self._sum())
            self._close()
            return Call(token.text, tuple(arguments))
        if not self._taken("("):
            raise self._refused(REFUSALS["expected"])
        formula = self._sum()
        self._close()
        return formula

    def _close(self) -> None:
        if not self._taken(")"):
            raise self._refused(REFUSALS["formula-unclosed"])


def _degree(formula: Formula, text: str) -> int:
    """The number of factors of the largest product, with all powers multiplied out.

    Raises a `Refusal` above `LARGEST_DEGREE`: evaluating such a formula could take forever.
    """
    below = [_degree(part, text) for part in formula.parts]
    if isinstance(formula, Power):
        degree = below[0] * max(1, abs(formula.exponent))
    elif isinstance(formula, Pair):  # a sum of quotients becomes one quotient over their product
        degree = sum(below)
    else:
        degree = 1
    if degree > LARGEST_DEGREE and any(isinstance(part, Power) for part in formula):
        raise _refused(text, text.find("^"), REFUSALS["formula-too-large"], LARGEST_DEGREE)
    return degree


# --------------------------------------------------------------------------- writing


IN_SUM, IN_PRODUCT, FACTOR, BASE = 1, 2, 3, 4  # how tightly the surrounding formula binds

ARROW = "\u20d7"  # follows the letter of a vector: n is near, and n⃗ an axis


class FormulaWriter:
    """Writes formulas in their own language; the other writers override the differences."""

    minus, minus_between, plus, space, degree = "-", " - ", " + ", "*", ""

    def __init__(self, symbols: Mapping[str, str]) -> None:
        self._symbols = symbols

    def write(self, formula: Formula, outer: int = 0) -> str:
        """Write a formula that is part of one that binds as tightly as `outer`."""
        if isinstance(formula, Number):
            sign = self.degree if isinstance(formula, Degrees) else ""
            return f"{decimal_of(formula.number)}{sign}"
        if isinstance(formula, Letter):
            return self.symbol(self._symbols.get(formula.name, formula.name))
        if isinstance(formula, Call):
            return self.call(formula.name, [self.write(part) for part in formula.parts], outer)
        if isinstance(formula, Power):
            return self.power(self.write(formula.base, BASE), formula.exponent, outer)
        if isinstance(formula, Negative):
            text = f"{self.minus}{self.write(formula.operand, IN_PRODUCT)}"
            return self.bracketed(text, outer > IN_SUM)
        if isinstance(formula, Product):
            left, right = self.first(formula.left, outer), self.write(formula.right, FACTOR)
            return self.bracketed(self.product(left, right), outer > IN_PRODUCT)
        if isinstance(formula, Quotient):
            return self.quotient(formula.left, formula.right, outer)
        assert isinstance(formula, Sum | Difference)
        sign = self.plus if isinstance(formula, Sum) else self.minus_between
        left, right = self.write(formula.left, IN_SUM), self.write(formula.right, IN_PRODUCT)
        return self.bracketed(f"{left}{sign}{right}", outer > IN_SUM)

    def first(self, formula: Formula, outer: int) -> str:
        """The first factor, whose sign needs no brackets unless another sign precedes it."""
        is_bare = isinstance(formula, Negative | Product | Quotient) and outer < IN_PRODUCT
        return self.write(formula, IN_SUM if is_bare else IN_PRODUCT)

    def bracketed(self, text: str, needed: bool) -> str:
        return self.brackets(text) if needed else text

    def brackets(self, text: str) -> str:
        return f"({text})"

    def symbol(self, name: str) -> str:
        return name

    def call(self, name: str, inside: list[str], outer: int) -> str:
        return f"{name}({', '.join(inside)})"

    def power(self, base: str, exponent: int, outer: int) -> str:
        return self.bracketed(f"{base}^{exponent}", outer > FACTOR)

    def product(self, left: str, right: str) -> str:
        return f"{left}{self.space}{right}"

    def quotient(self, above: Formula, below: Formula, outer: int) -> str:
        text = f"{self.first(above, outer)}/{self.write(below, FACTOR)}"
        return self.bracketed(text, outer > IN_PRODUCT)


def decimal_of(number: Fraction) -> str:
    places = 0
    while (number * 10**places).denominator != 1:
        places += 1
    digits = str((number * 10**places).numerator).rjust(places + 1, "0")
    return f"{digits[:-places]}.{digits[-places:]}" if places else digits


_SOURCE = FormulaWriter({})
