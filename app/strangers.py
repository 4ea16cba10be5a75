"""Files from strangers: open regular files only, decode their text, print no control characters."""

from __future__ import annotations

import errno
import json
import os
import stat
from typing import BinaryIO

LARGEST_FILE = 2 * 2**30
"""Most bytes of a file that is opened."""
LATIN_1 = "is neither UTF-8 nor UTF-16 text, and is read as Latin-1; some letters may be wrong"
"""The note beside a text whose encoding `decode` could not tell."""


def open_regular(path: str | os.PathLike[str]) -> BinaryIO:
    """Open a regular file for reading, or a link to one, but no pipe, device or socket.

    Raises
    ------
    OSError
        If it cannot be opened, is larger than `LARGEST_FILE` or is no regular file; for the
        system's own reasons as `open` does.
    """
    _check_regular(os.stat(path))  # first: merely opening a device may have an effect

    def without_waiting(name: str, flags: int) -> int:
        # It may have become a pipe meanwhile, whose opening waits for a writer.
        return os.open(name, flags | getattr(os, "O_NONBLOCK", 0))

    file = open(path, "rb", opener=without_waiting)  # noqa: SIM115 the caller closes it
    try:
        _check_regular(os.fstat(file.fileno()))
    except OSError:
        file.close()
        raise
    return file


def _check_regular(status: os.stat_result) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, "it is a pipe or a device, not a regular file")
    if status.st_size > LARGEST_FILE:
        raise OSError(errno.EFBIG, f"it is larger than {LARGEST_FILE >> 30} GiB")


def decode(content: bytes) -> tuple[str, bool]:
    """Return the text of a file, and whether its encoding is certain.

    UTF-8, UTF-16 and UTF-32 are known by their byte-order mark, or by their zero bytes. What is
    none of them is read as Latin-1, which has a letter for every byte.
    """
    encoding = json.detect_encoding(content[:4])
    try:
        return content.decode(encoding), True
    except UnicodeDecodeError:
        return content.decode("latin-1"), False


def printable(text: str) -> str:
    """Write the unprintable characters of a text as Python does: ``\\x1b``.

    These are control characters, which a terminal obeys, marks that change the reading direction,
    and characters that no encoding has (half of a surrogate pair, as in a file name that is not
    UTF-8).
    """
    if text.isprintable():
        return text
    return "".join(letter if letter.isprintable() else repr(letter)[1:-1] for letter in text)
