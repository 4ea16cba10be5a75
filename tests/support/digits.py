"""Numbers as they are read, and the switch that shows all of their digits."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from widgets.parts.digits import set_all_digits

_HIGH = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@contextmanager
def all_digits_shown(on: bool = True) -> Iterator[None]:
    """While all digits are shown, as by View > All digits."""
    set_all_digits(on)
    try:
        yield
    finally:
        set_all_digits(False)


def plain(text: str) -> str:
    """A number that is read, as Python would write it with four digits."""
    mantissa, times, power = text.replace("−", "-").partition("·10")
    return f"{float(f'{mantissa}e{power.translate(_HIGH)}'):.4g}" if times else f"{mantissa}"
