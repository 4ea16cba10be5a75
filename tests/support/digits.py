"""Numbers as they are read, and the switch that shows all of their digits."""

from collections.abc import Iterator
from contextlib import contextmanager

from widgets.parts.messages import all_digits

_HIGH = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@contextmanager
def all_digits_shown(on: bool = True) -> Iterator[None]:
    """While all digits are shown, as by View > All digits."""
    all_digits.set(on)
    try:
        yield
    finally:
        all_digits.set(False)


def plain(text: str) -> str:
    """A number that is read, as Python would write it with four digits."""
    mantissa, times, power = text.replace("−", "-").partition("·10")
    return f"{float(f'{mantissa}e{power.translate(_HIGH)}'):.4g}" if times else f"{mantissa}"
