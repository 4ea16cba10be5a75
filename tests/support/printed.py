"""What printed equations say: their TeX is read and computed by nothing of the program."""

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

_CALLS = {"tan": np.tan, "sin": np.sin, "cos": np.cos, "cot": lambda angle: 1.0 / np.tan(angle)}
_LAYOUT = re.compile(r"\\(?:left|right)(?!arrow)|\\(?:,|q?quad\b)|&|\\\\(?:\[2pt\])?|%.*")
_MATRIX = re.compile(r"\\begin\{pmatrix\}(.*?)\\end\{pmatrix\}", re.DOTALL)


class _Reader:
    """Recursive descent over TeX without layout; `np.dot` multiplies numbers, vectors, matrices."""

    def __init__(self, tex: str, letters: Mapping[str, Any]) -> None:
        self.left = tex.strip()
        self.letters = letters
        self.names = sorted(letters, key=len, reverse=True)

    def taken(self, text: str) -> bool:
        is_next = self.left.startswith(text)
        if is_next:
            self.left = self.left[len(text) :].lstrip()
        return is_next

    def between(self, begin: str, end: str) -> Any:
        assert self.taken(begin), self.left
        value = self.sum()
        assert self.taken(end), self.left
        return value

    def sum(self) -> Any:
        value = -self.product() if self.taken("-") else self.product()
        while self.left[:1] in ("+", "-"):
            value = value + (1.0 if self.taken("+") else -float(self.taken("-"))) * self.product()
        return value

    def product(self) -> Any:
        value = self.power()
        while self.taken(r"\cdot") or (self.left and self.left[0] not in "+-)}"):
            value = value / self.power() if self.taken("/") else np.dot(value, self.power())
        return value

    def power(self) -> Any:
        value = self.atom()
        return value ** self.between("{", "}") if self.taken("^") else value

    def atom(self) -> Any:
        if number := re.match(r"\d+(\.\d+)?", self.left):
            self.taken(number[0])
            return float(number[0])
        if self.taken(r"\frac") or self.taken(r"\dfrac"):
            return self.between("{", "}") / self.between("{", "}")
        if self.left.startswith("("):
            return self.between("(", ")")
        for name, call in _CALLS.items():
            if self.taken(rf"\{name}"):
                return call(self.atom())
        name = next(filter(self.taken, self.names), "")
        assert name, f"no letter begins {self.left!r}"
        return self.letters[name]


def value(tex: str, letters: Mapping[str, Any]) -> Any:
    """The value of a formula, by the TeX of its letters; they may be vectors or matrices."""
    reader = _Reader(_LAYOUT.sub(" ", tex), letters)
    found = reader.sum()
    assert not reader.left, f"{reader.left!r} is left of {tex!r}"
    return found


def sides(tex: str, letters: Mapping[str, Any], named: dict[str, Any]) -> list[Any]:
    """The matrices that an equation says are equal; names that are new are kept in `named`."""
    cells = {"I": np.eye(4)}

    def matrix(found: re.Match[str]) -> str:
        rows = re.split(r"\\\\(?:\[2pt\])?", found[1])
        name = f"@{len(cells)}@"
        cells[name] = np.array([[value(cell, letters) for cell in row.split("&")] for row in rows])
        return name

    tex = _LAYOUT.sub(" ", _MATRIX.sub(matrix, tex))
    left, *texts = [" ".join(side.split()) for side in tex.split("=")]
    known = {**letters, **cells, **named}
    found = [value(text, known) for text in texts]
    names, factors = left.split(" "), texts[0].split(" ")
    if re.fullmatch(r"\S+\{.*\}|\S", left):
        known[left] = named[left] = found[-1]
    elif len(names) == len(factors) and set(factors) <= cells.keys():
        named |= {name: cells[factor] for name, factor in zip(names, factors, strict=True)}
        known |= named
    return [value(left, known), *found]
