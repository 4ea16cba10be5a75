"""What commands say on a terminal: output, errors of one sentence, and the exit status.

This module needs only the standard library.
"""

import io
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TextIO, TypeVar

from app.languages import said
from app.strangers import printable

_Status = TypeVar("_Status", int, "int | None")

BAD_INPUT = 2
CANNOT_DRAW = 3
INTERRUPTED = 130


class CliError(Exception):
    """One sentence for standard error, in the language and filled in; and the exit status."""

    def __init__(self, sentence: str, *values: object, status: int = BAD_INPUT) -> None:
        super().__init__(said(sentence, *values))
        self.status = status


def print_error(sentence: str, status: int) -> int:
    """Write a sentence to standard error, on one line, and return the exit status."""
    if sys.stderr is not None:
        print(printable(" ".join(sentence.split())), file=sys.stderr)
    return status


def standard_output() -> TextIO:
    """Standard output, set so that it takes every character.

    Files and other programs always get UTF-8, which TeX and JSON expect; Python would use the
    locale's encoding, which is cp1252 on Windows and lacks the minus sign. A terminal keeps its
    encoding and shows the code of a character that it lacks. Raises a `CliError` if it is closed,
    as in ``pythonw``.
    """
    if sys.stdout is None:
        raise CliError("Standard output is closed.")
    if isinstance(sys.stdout, io.TextIOWrapper):
        encoding = sys.stdout.encoding if sys.stdout.isatty() else "utf-8"
        sys.stdout.reconfigure(encoding=encoding, errors="backslashreplace")
    return sys.stdout


def write_out(texts: Iterable[str]) -> None:
    """Write to standard output and flush, so that an error comes here and not when Python ends."""
    out = standard_output()
    try:
        for text in texts:
            out.write(text)
        out.flush()
    except OSError as error:
        # Python must not try again at exit to write what is still buffered.
        os.dup2(os.open(os.devnull, os.O_WRONLY), out.fileno())
        if isinstance(error, BrokenPipeError):
            raise
        raise CliError("Standard output cannot be written: {0}.", error.strerror) from error


@contextmanager
def interrupt() -> Iterator[threading.Event]:
    """Let Ctrl+C set an event instead of raising an exception wherever the program is."""
    event = threading.Event()
    former = signal.signal(signal.SIGINT, lambda *_: event.set())
    try:
        yield event
    finally:
        signal.signal(signal.SIGINT, former)


def outcome(run: Callable[[], _Status]) -> _Status | int:
    """Run, print an error's sentence if there is one, and return the exit status."""
    try:
        return run()
    except CliError as error:
        return print_error(str(error), error.status)
    except SystemExit as done:  # argparse, after --help and --version
        return int(done.code or 0)
    except BrokenPipeError:  # the reader, such as “| head”, has closed the pipe
        return 0
    except KeyboardInterrupt:
        return INTERRUPTED
