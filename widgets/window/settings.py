"""Where the program keeps what is the user's: folders, and the settings."""

from __future__ import annotations

import base64
import binascii
import json
import logging
import os
import re
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Generic, TypeVar

from PySide6.QtCore import QCoreApplication, QSettings, QStandardPaths

from app import __version__
from app.drawings.frame_budget import FRAME_MS, LARGEST_FRAME_MS
from app.precision.levels import DRAWING_TOLERANCE_PX, LARGEST_TOLERANCE_PX, LEAST_TOLERANCE_PX

log = logging.getLogger(__name__)

_T = TypeVar("_T")
_N = TypeVar("_N", int, float)
THEMES = ("system", "light", "dark")
NAME = "frustum-lab"


def name_application() -> None:
    """Tell Qt the program's name, on which its folders depend."""
    QCoreApplication.setApplicationName(NAME)
    QCoreApplication.setApplicationVersion(__version__)


def _folder(location: QStandardPaths.StandardLocation) -> Path:
    name_application()
    is_config = location == QStandardPaths.StandardLocation.AppConfigLocation
    own = Path(os.environ.get("XDG_CONFIG_HOME" if is_config else "XDG_DATA_HOME", ""))
    if own.is_absolute():  # on Windows and macOS Qt does not ask, and tests would use the user's
        return own / NAME
    return Path(QStandardPaths.writableLocation(location))


def data_folder() -> Path:
    """Where unsaved work is kept for recovery."""
    return _folder(QStandardPaths.StandardLocation.AppDataLocation)


def log_path() -> Path:
    """The file that everything unexpected is written to."""
    return _folder(QStandardPaths.StandardLocation.AppLocalDataLocation) / f"{NAME}.log"


def settings_path() -> Path:
    """The file of the user's settings."""
    return _folder(QStandardPaths.StandardLocation.AppConfigLocation) / f"{NAME}.ini"


# --------------------------------------------------------------------------- settings
LEAST_NOTES_PX, LARGEST_NOTES_PX = 10, 72


def _theme(text: str) -> str:
    if text not in THEMES:
        raise ValueError
    return text


def _flag(text: str) -> bool:
    if text not in ("true", "false"):
        raise ValueError
    return text == "true"


def _flag_text(on: bool) -> str:
    return "true" if on else "false"


def _number_in(low: _N, high: _N) -> Callable[[str], _N]:
    def read(text: str) -> _N:
        number = type(low)(text)
        if not low <= number <= high:
            raise ValueError
        return number

    return read


def _language(text: str) -> str:
    if not re.fullmatch(r"([a-z]{2,3}([_-][A-Za-z]{2,4}){0,2})?", text):
        raise ValueError
    return text


def _bytes(text: str) -> bytes:
    if len(text) > 10_000:
        raise ValueError
    try:
        return base64.b64decode(text, validate=True)
    except binascii.Error as error:
        raise ValueError from error


def _base64(content: bytes | None) -> str:
    return base64.b64encode(content or b"").decode("ascii")


def _json(text: str, kind: type[_T]) -> _T:
    try:
        found = json.loads(text)
    except RecursionError as error:
        raise ValueError from error
    if not isinstance(found, kind):
        raise ValueError
    return found


def _paths(text: str) -> list[str]:
    paths: list[object] = _json(text, list)
    found = [path for path in paths if isinstance(path, str) and path and "\0" not in path]
    if len(found) < len(paths):
        raise ValueError
    return found


MOST_LESSONS, MOST_ANSWERS, LONGEST_ANSWER = 200, 200, 80
"""What is kept of lessons that were begun: the newest, and of each so much."""


@dataclass(frozen=True)
class Progress:
    """How far somebody has come in a lesson.

    Attributes
    ----------
    step : str
        Name of the step to go on at; empty for the first.
    answers : mapping of str to str
        By ``step/block``: the number of a choice, from 1, what was typed, or how a task went.
    done, of : int
        Steps that are done, and that there are.
    """

    step: str = ""
    answers: Mapping[str, str] = field(default_factory=dict)
    done: int = 0
    of: int = 0


def _all_progress(text: str) -> dict[str, Progress]:
    found: dict[str, object] = _json(text, dict)
    return {name: _one_progress(kept) for name, kept in found.items()}


def _one_progress(kept: object) -> Progress:
    if not isinstance(kept, dict):
        raise ValueError
    step, answers = kept.get("step", ""), kept.get("answers", {})
    counts = kept.get("done", 0), kept.get("of", 0)
    if not isinstance(step, str) or not isinstance(answers, dict):
        raise ValueError
    if not all(isinstance(text, str) for text in answers.values()):
        raise ValueError
    if not all(type(count) is int and 0 <= count < 10_000 for count in counts):
        raise ValueError
    return Progress(step, answers, *counts)


class _Kept(Generic[_T]):
    """One setting: its name in the file, how its text is read and written, and its default."""

    def __init__(
        self,
        key: str,
        convert: Callable[[str], _T],
        default: _T,
        text_of: Callable[[_T], str] = str,
    ) -> None:
        self._key, self._convert, self._default, self._text_of = key, convert, default, text_of

    def __get__(self, settings: Settings, _owner: object = None) -> _T:
        return settings.read(self._key, self._convert, self._default)

    def __set__(self, settings: Settings, value: _T) -> None:
        settings.write(self._key, self._text_of(value))


class Settings:
    """The user's settings: every value is checked here, what is not valid is the default.

    QSettings writes the file. It is not trusted to read it: it reports no error for a file that
    is not INI, and makes 0 of a number that is none.

    Parameters
    ----------
    path : Path or None
        The INI file; None keeps the settings in memory only. A broken file is set aside as
        ``.bak``.
    """

    def __init__(self, path: Path | None) -> None:
        self._file: QSettings | None = None
        self._values: dict[str, object] = {}
        self._for_now: dict[str, str] = {}
        self._refused: set[str] = set()
        self._unsaved: dict[str, str] = {}
        self._is_told = False
        self.cannot_save: Callable[[Path], object] = lambda _path: None
        """Told of the file when it cannot be written, once until it can be again."""
        if path is not None and _set_aside_if_broken(path):
            self._file = QSettings(str(path), QSettings.Format.IniFormat)
            self._values = {key: self._file.value(key) for key in self._file.allKeys()}

    theme = _Kept("theme", _theme, "system")
    """One of `THEMES`."""
    all_digits = _Kept("all-digits", _flag, False, _flag_text)
    """Whether numbers that are read have all of their digits, not four."""
    language = _Kept("language", _language, "")
    """A locale such as ``"hr"`` or ``"sr_RS"``; empty for the system's."""
    tolerance_px = _Kept(
        "tolerance", _number_in(LEAST_TOLERANCE_PX, LARGEST_TOLERANCE_PX), DRAWING_TOLERANCE_PX
    )
    """Error in pixels up to which a GPU's own arithmetic may draw."""
    frame_ms = _Kept("frame", _number_in(0.0, LARGEST_FRAME_MS), FRAME_MS)
    """Longest frame that is wanted while a control is dragged, in ms; 0 for any."""
    start_card = _Kept("start_card", _flag, True, _flag_text)
    """Whether the program begins with its scenes as pictures."""
    speaker_window = _Kept("speaker_window", _flag, True, _flag_text)
    """Whether the speaker's window opens when a talk is presented."""
    swapped_screens = _Kept[list[str]]("swapped-screens", _paths, [], json.dumps)
    """Pairs of screens whose primary one is the class's."""
    notes_px = _Kept("notes", _number_in(LEAST_NOTES_PX, LARGEST_NOTES_PX), 22)
    """Height of the letters in the speaker's notes."""
    geometry = _Kept[bytes | None]("geometry", _bytes, None, _base64)
    """The window's place as Qt wrote it, None before the first time."""

    @property
    def recent(self) -> list[str]:
        """Paths of the files opened or saved before, newest first: by every window, as of now."""
        return self._read_again("recent", _paths, [])

    @recent.setter
    def recent(self, recent: list[str]) -> None:
        self.write("recent", json.dumps(recent))

    @property
    def progress(self) -> dict[str, Progress]:
        """Of the lessons that were begun, by their names or paths, the newest last; as of now."""
        return self._read_again("progress", _all_progress, {})

    def keep_progress(self, name: str, progress: Progress | None) -> None:
        """Keep how far somebody has come in a lesson; None forgets it."""
        kept = self.progress
        kept.pop(name, None)
        if progress is not None:
            answers = list(progress.answers.items())[-MOST_ANSWERS:]
            short = {key: text for key, text in answers if len(text) <= LONGEST_ANSWER}
            kept[name] = replace(progress, answers=short)
        newest = dict(list(kept.items())[-MOST_LESSONS:])
        self.write("progress", json.dumps({key: asdict(each) for key, each in newest.items()}))

    def override(self, key: str, text: str) -> None:
        """Use another value until it is set again; it is not saved."""
        self._for_now[key] = text

    def _read_again(self, key: str, convert: Callable[[str], _T], default: _T) -> _T:
        """A value as other windows have left it in the file."""
        if self._file is not None and key not in self._unsaved:
            self._file.sync()
            self._values[key] = self._file.value(key)
        return self.read(key, convert, default)

    def read(self, key: str, convert: Callable[[str], _T], default: _T) -> _T:
        """A value, checked; the default in the place of none, or of one that is not valid."""
        value = self._for_now.get(key, self._values.get(key))
        if value is None:
            return default
        try:
            if not isinstance(value, str):  # what has a comma in it QSettings splits
                raise ValueError
            return convert(value)
        except ValueError:
            if key not in self._refused:  # told once, however often it is asked for
                self._refused.add(key)
                log.warning("setting %s = %.60r is not valid: using %r", key, value, default)
            return default

    def write(self, key: str, text: str) -> None:
        """Keep a value, and save it."""
        self._for_now.pop(key, None)
        self._refused.discard(key)
        self._values[key] = text
        if self._file is not None:
            self._unsaved[key] = text
            self.save_again()

    def save_again(self) -> None:
        """Write what could not be written before, as the disk was full, say."""
        if self._file is None or not self._unsaved:
            return
        path = Path(self._file.fileName())
        if self._is_told:  # an error of before would stay
            self._file = QSettings(str(path), QSettings.Format.IniFormat)
        for key, text in self._unsaved.items():
            self._file.setValue(key, text)
        self._file.sync()
        if self._file.status() == QSettings.Status.NoError:
            self._unsaved.clear()
            self._is_told = False
        elif not self._is_told:
            self._is_told = True
            log.warning("the settings cannot be written to %s", path)
            self.cannot_save(path)


def _set_aside_if_broken(path: Path) -> bool:
    """Rename a settings file that is none; False if there is no using this path at all."""
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        return True
    except OSError as error:
        log.warning("the settings cannot be read, the defaults are used: %s", error)
        return False
    if _is_ini(content):
        return True
    aside = path.with_name(path.name + ".bak")
    try:
        os.replace(path, aside)
    except OSError as error:
        log.warning("the settings are broken and cannot be set aside: %s", error)
        return False
    log.warning("the settings were broken: set aside as %s, the defaults are used", aside)
    return True


def _is_ini(content: bytes) -> bool:
    """Whether these bytes are INI as QSettings writes our texts."""
    try:
        lines = content.decode().splitlines()
    except UnicodeDecodeError:
        return False
    # A value that begins with @ would be unpacked into any type of Qt's; ours are texts.
    line_of_ini = re.compile(r'\s*|\s*;.*|\[[\w%]+\]\s*|[\w%\\-]+\s*=\s*(?!"?@[^@])[^\0]*')
    return all(line_of_ini.fullmatch(line) for line in lines)


def delete_settings() -> str:
    """Delete the user's settings and return a sentence that says so.

    Raises
    ------
    OSError
        If they cannot be deleted.
    """
    path = settings_path()
    try:
        path.unlink()
    except FileNotFoundError:
        return f"There are no settings to delete: {path}"
    return f"Settings deleted: {path}"
