"""Products of vectors for the keys, in the digits of mpmath."""

from collections.abc import Sequence

from mpmath import mpf, sqrt

Vector = tuple[mpf, mpf, mpf]


def dot(p: Sequence[mpf], q: Sequence[mpf]) -> mpf:
    return sum(a * b for a, b in zip(p, q, strict=True))


def cross(p: Sequence[mpf], q: Sequence[mpf]) -> Vector:
    (a, b, c), (d, e, f) = p, q
    return b * f - c * e, c * d - a * f, a * e - b * d


def unit(p: Sequence[mpf]) -> Vector:
    length = sqrt(dot(p, p))
    x, y, z = (part / length for part in p)
    return x, y, z
