"""The user's settings, and the folders of the program's files."""

import base64
import binascii
import json
import logging
import os
import re
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QCoreApplication, QSettings, QStandardPaths

from app import __version__
from app.document.files import blamed_on, write_bytes_atomically
from app.drawings.frame_budget import FRAME_MS, LARGEST_FRAME_MS
from app.languages import said
from app.lessons.player import Progress
from app.model.refusal import REFUSALS, Refusal
from app.precision.levels import DRAWING_TOLERANCE_PX, LARGEST_TOLERANCE_PX, LEAST_TOLERANCE_PX
from app.strangers import open_regular

log = logging.getLogger(__name__)

_T = TypeVar("_T")
_N = TypeVar("_N", int, float)
_D = TypeVar("_D", bool, None)
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
    if own.is_absolute():  # Qt reads it on Linux only, but tests need it everywhere
        return own / NAME
    return Path(QStandardPaths.writableLocation(location))


def data_folder() -> Path:
    """Return the folder for copies of unsaved work."""
    return _folder(QStandardPaths.StandardLocation.AppDataLocation)


def log_path() -> Path:
    return _folder(QStandardPaths.StandardLocation.AppLocalDataLocation) / f"{NAME}.log"


def labels_path() -> Path:
    """Return the file of the labels that are kept; it can be deleted at any time."""
    return _folder(QStandardPaths.StandardLocation.AppLocalDataLocation) / "labels.json"


def settings_path() -> Path:
    return _folder(QStandardPaths.StandardLocation.AppConfigLocation) / f"{NAME}.ini"


LEAST_NOTES_PX, LARGEST_NOTES_PX = 10, 72
MOST_LESSONS, MOST_ANSWERS, LONGEST_ANSWER = 200, 200, 1200
"""Limits of saved progress: lessons, the newest answers of each, and characters of an answer,
which may be a matrix."""

TRIAL_BYTES = 2**18
"""Size of a file that finds out why the settings cannot be written; they are seldom as large."""


# Each reads one kind of value from the file's text, and raises ValueError for an invalid one.


def _valid(value: _T, *conditions: bool) -> _T:
    if not all(conditions):
        raise ValueError
    return value


def _number_in(low: _N, high: _N) -> Callable[[str], _N]:
    def read(text: str) -> _N:
        number = type(low)(text)
        return _valid(number, low <= number <= high)

    return read


def _language(text: str) -> str:
    form = r"([a-z]{2,3}([_-][A-Za-z]{2,4}){0,2})?"
    return _valid(text, re.fullmatch(form, text) is not None)


def _bytes(text: str) -> bytes:
    try:
        return base64.b64decode(_valid(text, len(text) <= 10_000), validate=True)
    except binascii.Error as error:
        raise ValueError from error


def _json(text: str, kind: type[_T]) -> _T:
    try:
        value: _T = json.loads(text)
    except RecursionError as error:
        raise ValueError from error
    return _valid(value, isinstance(value, kind))


def _paths(text: str) -> list[str]:
    paths: list[str] = _json(text, list)
    are_paths = (isinstance(path, str) and path and "\0" not in path for path in paths)
    return _valid(paths, all(are_paths))


def _progress(text: str) -> dict[str, Progress]:
    tree: dict[str, Any] = _json(text, dict)
    return {name: _one_progress(kept) for name, kept in tree.items()}


def _one_progress(kept: Any) -> Progress:
    names = [each.name for each in fields(Progress)]
    known = _valid(kept, isinstance(kept, dict))
    progress = Progress(**{name: known[name] for name in names if name in known})
    answers, counts = progress.answers, (progress.done, progress.of)
    return _valid(
        progress,
        isinstance(progress.step, str),
        isinstance(answers, dict) and all(isinstance(text, str) for text in answers.values()),
        all(type(count) is int and 0 <= count < 10_000 for count in counts),
    )


@dataclass(frozen=True, eq=False)
class _KeptSetting(Generic[_T]):
    """One setting: its key in the file, how it is read from text and written, and its default."""

    key: str
    convert: Callable[[str], _T]
    default: _T
    text_of: Callable[[_T], str] = str
    shared: bool = False  # read from the file each time, because other windows change it too

    def __get__(self, settings: "Settings", _owner: object = None) -> _T:
        if self.shared:
            settings.refresh(self.key)
        return settings.read(self.key, self.convert, self.default)

    def __set__(self, settings: "Settings", value: _T) -> None:
        settings.write(self.key, self.text_of(value))


def _kept_flag(key: str, default: _D) -> _KeptSetting[bool | _D]:
    def read(text: str) -> bool:
        return _valid(text == "true", text in ("true", "false"))

    return _KeptSetting(key, read, default, lambda on: "true" if on else "false")


def _progress_text(progress: Mapping[str, Progress]) -> str:
    return json.dumps({name: asdict(each) for name, each in progress.items()})


class Settings:
    """The user's settings; the default replaces an invalid value.

    QSettings writes the file, but all values are checked here: it reports no error for a file that
    is not INI, and reads 0 from an invalid number. A broken file is renamed to ``.bak``. Without a
    path the settings are in memory only.
    """

    def __init__(self, path: Path | None) -> None:
        self._file: QSettings | None = None
        self._values: dict[str, object] = {}
        self._for_now: dict[str, str] = {}
        self._refused: set[str] = set()
        self._unsaved: dict[str, str] = {}
        self._is_failure_shown = False
        self.cannot_save: Callable[[Refusal], object] = lambda _why: None
        """Called once when the file cannot be written, until it can be written again."""
        usable, self.problem = _looked_at(path)
        """Why the values in the file are not used; None if they are."""
        if usable:
            self._file = QSettings(str(path), QSettings.Format.IniFormat)
            self._values = {key: self._file.value(key) for key in self._file.allKeys()}

    theme = _KeptSetting("theme", lambda text: _valid(text, text in THEMES), "system")
    """One of `THEMES`."""
    all_digits = _kept_flag("all-digits", False)  # whether panels show all digits instead of four
    language = _KeptSetting("language", _language, "")
    """A locale such as ``"hr"`` or ``"sr_RS"``; empty for the system's."""
    tolerance_px = _KeptSetting(  # error in pixels up to which a GPU's own arithmetic may draw
        "tolerance", _number_in(LEAST_TOLERANCE_PX, LARGEST_TOLERANCE_PX), DRAWING_TOLERANCE_PX
    )
    frame_ms = _KeptSetting("frame", _number_in(0.0, LARGEST_FRAME_MS), FRAME_MS)
    """Longest frame while a control is dragged, in ms; 0 for no limit."""
    reduce_motion = _kept_flag("reduce-motion", None)
    """Whether steps of talks follow each other without a transition; None for the system's."""
    start_card = _kept_flag("start_card", True)  # whether the program starts with the start card
    speaker_window = _kept_flag("speaker_window", True)
    """Whether the speaker's window opens when a talk is presented."""
    swapped_screens = _KeptSetting[list[str]]("swapped-screens", _paths, [], json.dumps)
    """Pairs of screens whose primary one the class sees."""
    notes_px = _KeptSetting("notes", _number_in(LEAST_NOTES_PX, LARGEST_NOTES_PX), 22)
    """Height of the letters in the speaker's notes."""
    export = _KeptSetting[dict[str, Any]]("export", lambda text: _json(text, dict), {}, json.dumps)
    """The last choice in the dialog for pictures."""
    geometry = _KeptSetting[bytes | None](
        "geometry", _bytes, None, lambda content: base64.b64encode(content or b"").decode("ascii")
    )
    """The window's geometry in Qt's format; None before the first time."""
    recent = _KeptSetting[list[str]]("recent", _paths, [], json.dumps, shared=True)
    """Paths of the files opened or saved by any window, newest first."""
    progress = _KeptSetting[dict[str, Progress]](
        "progress", _progress, {}, _progress_text, shared=True
    )
    """Progress of each started lesson, by its name or path, the newest last."""

    def keep_progress(self, name: str, progress: Progress | None) -> None:
        """Save a lesson's progress, or delete it if it is None."""
        kept = {key: each for key, each in self.progress.items() if key != name}
        if progress is not None:
            answers = list(progress.answers.items())[-MOST_ANSWERS:]
            short = {key: text for key, text in answers if len(text) <= LONGEST_ANSWER}
            kept[name] = replace(progress, answers=short)
        self.progress = dict(list(kept.items())[-MOST_LESSONS:])

    def override(self, key: str, text: str) -> None:
        """Use another value, without saving it, until the setting is set again."""
        self._for_now[key] = text

    def refresh(self, key: str) -> None:
        """Read a value again from the file, where other windows may have changed it."""
        if self._file is not None and key not in self._unsaved:
            self._file.sync()
            self._values[key] = self._file.value(key)

    def read(self, key: str, convert: Callable[[str], _T], default: _T) -> _T:
        """Return a checked value, or the default for a missing or invalid one."""
        value = self._for_now.get(key, self._values.get(key))
        if value is None:
            return default
        try:
            # QSettings splits a text that contains a comma into a list.
            return convert(_valid(str(value), isinstance(value, str)))
        except ValueError:
            if key not in self._refused:  # logged once, however often it is read
                self._refused.add(key)
                log.warning("setting %s = %.60r is not valid: using %r", key, value, default)
            return default

    def write(self, key: str, text: str) -> None:
        self._for_now.pop(key, None)
        self._refused.discard(key)
        self._values[key] = text
        if self._file is not None:
            self._unsaved[key] = text
            self.save_again()

    def save_again(self) -> None:
        """Write the values that could not be written before, for example to a full disk."""
        if self._file is None or not self._unsaved:
            return
        path = Path(self._file.fileName())
        if self._is_failure_shown:  # a QSettings keeps an earlier error
            self._file = QSettings(str(path), QSettings.Format.IniFormat)
        for key, text in self._unsaved.items():
            self._file.setValue(key, text)
        self._file.sync()
        if self._file.status() == QSettings.Status.NoError:
            self._unsaved.clear()
            self._is_failure_shown = False
        elif not self._is_failure_shown:
            self._is_failure_shown = True
            why = _why_not(path)
            log.warning("the settings cannot be written: %s", str(why))  # without its traceback
            self.cannot_save(why)


def _why_not(path: Path) -> Refusal:
    """Return why the settings cannot be written, which Qt does not say."""
    try:
        with blamed_on(path, REFUSALS["unwritable"]):
            path.parent.mkdir(parents=True, exist_ok=True)
            write_bytes_atomically(path, bytes(TRIAL_BYTES), is_trial=True)
    except Refusal as error:
        return error
    return Refusal.in_document(REFUSALS["locked"], file=str(path))


def _looked_at(path: Path | None) -> tuple[bool, Refusal | None]:
    """Whether a settings file can be used, and what was wrong with it; rename a broken one."""
    if path is None or not os.path.lexists(path):
        return path is not None, None
    aside = f"{path}.bak"
    try:
        with blamed_on(path, REFUSALS["files-unreadable"]), open_regular(path) as file:
            is_sound = _is_ini(file.read())
        if is_sound:
            return True, None
        with blamed_on(path, REFUSALS["not-set-aside"]):
            os.replace(path, aside)
        usable, problem = True, Refusal.in_document(REFUSALS["set-aside"], aside, file=str(path))
    except Refusal as error:
        usable, problem = False, error
    log.warning("the default settings are used: %s", str(problem))
    return usable, problem


def _is_ini(content: bytes) -> bool:
    """Whether these bytes are INI as QSettings writes it for texts."""
    try:
        lines = content.decode().splitlines()
    except UnicodeDecodeError:
        return False
    # QSettings would unpack a value that begins with @ into any type of Qt's.
    line_of_ini = re.compile(r'\s*|\s*;.*|\[[\w%]+\]\s*|[\w%\\-]+\s*=\s*(?!"?@[^@])[^\0]*')
    return all(line_of_ini.fullmatch(line) for line in lines)


def delete_settings() -> str:
    """Delete the user's settings and return a sentence that says so, or raise an OSError."""
    path = settings_path()
    try:
        path.unlink()
    except FileNotFoundError:
        return said("There are no settings to delete: {0}", path)
    return said("Settings deleted: {0}", path)
