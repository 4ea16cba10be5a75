"""Files from strangers: open regular files only, decode their text, print no control characters."""

from __future__ import annotations

import codecs
import errno
import json
import os
import re
import stat
from typing import BinaryIO

from app.languages import said

LARGEST_FILE = 2 * 2**30  # most bytes of a file that is opened


def open_regular(path: str | os.PathLike[str]) -> BinaryIO:
    """Open a regular file for reading, or a link to one, but no pipe, device or socket.

    Raises an `OSError` if it cannot be opened, is larger than `LARGEST_FILE` or is no regular file;
    for the system's own reasons as `open` does.
    """
    _check_regular(os.stat(path))  # first: merely opening a device may have an effect

    file = open(path, "rb", opener=without_waiting)  # noqa: SIM115 the caller closes it
    try:
        _check_regular(os.fstat(file.fileno()))
    except OSError:
        file.close()
        raise
    return file


def without_waiting(path: str, flags: int) -> int:
    """Open for `open` what may be a pipe, without a wait for its other end."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0), 0o666)


def _check_regular(status: os.stat_result) -> None:
    if stat.S_ISDIR(status.st_mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, said("it is a pipe or a device, not a regular file"))
    if status.st_size > LARGEST_FILE:
        raise OSError(errno.EFBIG, said("it is larger than {0} GiB", LARGEST_FILE >> 30))


def decode(content: bytes) -> tuple[str, str]:
    """Return the text of a file, and a note to show beside it; empty if the encoding is certain.

    What is not Unicode is read as Latin-1, which has a letter for every byte.
    """
    encoding = encoding_of(content)
    try:
        return content.decode(encoding), ""
    except UnicodeDecodeError:
        if encoding.startswith("utf-8"):
            return content.removeprefix(codecs.BOM_UTF8).decode("latin-1"), said("read-as-latin-1")
        return content.decode(encoding, "replace"), said("damaged-text")


def log_warning(path: str | os.PathLike[str], note: str) -> None:
    """Log the note on a file's encoding, if there is one."""
    if note:
        import logging  # seldom: not at the start

        logging.getLogger(__name__).warning("%s %s.", printable(os.fspath(path)), note)


def encoding_of(content: bytes) -> str:
    """Return the Unicode encoding of a text by its byte-order mark, or else by its zero bytes."""
    encoding, first = json.detect_encoding(content[:4]), content[:4].replace(b"\0", b"")
    is_marked = encoding[-2:] not in ("le", "be")
    return encoding if is_marked or re.fullmatch(rb"[\t\n\r -~]+", first) else "utf-8"


def printable(text: str) -> str:
    """Write the unprintable characters of a text as Python does: ``\\x1b``.

    These are control characters, which a terminal obeys, marks that change the reading direction,
    and characters that no encoding has (half of a surrogate pair, as in a file name that is not
    UTF-8).
    """
    if text.isprintable():
        return text
    return "".join(letter if letter.isprintable() else repr(letter)[1:-1] for letter in text)
