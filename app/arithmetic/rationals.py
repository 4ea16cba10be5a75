"""Matrices of rationals: products, inverse, rank and determinant without any rounding."""

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple, TypeAlias

Rationals: TypeAlias = list[list[Fraction]]


class Elimination(NamedTuple):
    """Properties of a square matrix; the inverse is None if the determinant is 0."""

    rank: int
    determinant: Fraction
    inverse: Rationals | None


def rationals(matrix: Sequence[Sequence[float | Fraction]]) -> Rationals:
    return [[Fraction(part) for part in row] for row in matrix]


def diagonal(*parts: Fraction | int) -> Rationals:
    return [[Fraction(part if i == j else 0) for j in range(4)] for i, part in enumerate(parts)]


def shift(*offset: Fraction | int) -> Rationals:
    matrix = diagonal(1, 1, 1, 1)
    for row, part in zip(matrix, offset, strict=False):
        row[3] = Fraction(part)
    return matrix


def dot(a: Sequence[Fraction], b: Sequence[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def nearest(number: Any) -> float:
    """The nearest float64; infinite beyond the largest one."""
    try:
        return float(number)
    except OverflowError:
        return math.inf if number > 0 else -math.inf


def product(left: list[list[Any]], right: list[list[Any]]) -> list[list[Any]]:
    """``left right`` in any exact arithmetic; skips zeros, which most cells of a lens are."""
    columns, zero = list(zip(*right, strict=True)), left[0][0] - left[0][0]
    return [
        [
            sum((a * b for a, b in zip(row, column, strict=True) if a and b), zero)
            for column in columns
        ]
        for row in left
    ]


def eliminate(matrix: Rationals) -> Elimination:
    """Rank, determinant and inverse of a square matrix (Gauss and Jordan)."""
    size = len(matrix)
    rows = [[*row, *(Fraction(i == j) for j in range(size))] for i, row in enumerate(matrix)]
    rank, determinant = 0, Fraction(1)
    for column in range(size):
        pivot = next((i for i in range(rank, size) if rows[i][column]), None)
        if pivot is None:
            determinant = Fraction(0)
            continue
        if pivot != rank:
            rows[rank], rows[pivot] = rows[pivot], rows[rank]
            determinant = -determinant
        head = rows[rank][column]
        determinant *= head
        rows[rank] = [part / head if part else part for part in rows[rank]]
        for i in range(size):
            factor = rows[i][column]
            if i != rank and factor:
                both = zip(rows[i], rows[rank], strict=True)
                rows[i] = [a - factor * b if b else a for a, b in both]
        rank += 1
    return Elimination(rank, determinant, [row[size:] for row in rows] if rank == size else None)
