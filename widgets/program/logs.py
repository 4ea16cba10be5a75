"""One log file for the program, Qt and VTK."""

import logging
import logging.handlers
import sys
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from PySide6.QtCore import QMessageLogContext, QObject, Qt, QtMsgType, Signal

from app import modules
from app.model.refusal import REFUSALS, Refusal
from widgets.parts.messages import sentence
from widgets.window.settings import log_path

log = logging.getLogger(__name__)

LARGEST_LOG = 1_000_000  # a log file of so many bytes is replaced by a new one; two are kept
IN_DETAIL = (*modules.PACKAGES, "qt", "vtk")
"""Whose information is logged. Of the other packages, such as fontTools, only warnings are."""


def start_log() -> logging.Handler | None:
    """Send log records to the log file, and those of crashes to standard error as well.

    Returns the file's handler, or None if it cannot be written.
    """
    root = logging.getLogger()
    root.setLevel(logging.WARNING)
    for name in IN_DETAIL:
        logging.getLogger(name).setLevel(logging.INFO)
    logging.captureWarnings(True)
    form = logging.Formatter("%(asctime)s %(levelname)s %(name)s: %(message)s")
    if sys.stderr is not None:
        terminal = logging.StreamHandler(sys.stderr)
        terminal.setLevel(logging.CRITICAL)
        terminal.setFormatter(form)
        root.addHandler(terminal)
    path = log_path()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        file = _LogFile(
            path, maxBytes=LARGEST_LOG, backupCount=2, encoding="utf-8", errors="backslashreplace"
        )
    except OSError as error:
        log.warning("there is no log: %s", error)
        return None
    file.setFormatter(form)
    root.addHandler(file)
    return file


class _Noted(QObject):
    noted = Signal(str)


class EncodingNotes(logging.Handler):
    """Shows a sentence for a file whose letters are uncertain, whichever thread has read it.

    It waits for what is under way: a document that was opened clears the message before.
    """

    def __init__(self, show: Callable[[str], None]) -> None:
        super().__init__()
        self._signals = _Noted()
        self._signals.noted.connect(show, Qt.ConnectionType.QueuedConnection)

    def emit(self, record: logging.LogRecord) -> None:
        path, _ = record.args or ("", "")
        self._signals.noted.emit(
            sentence(Refusal.in_document(REFUSALS["not-utf8"], file=str(path)))
        )


class _LogFile(logging.handlers.RotatingFileHandler):
    """A log that ends, with a line on the terminal, when the disk is full."""

    def handleError(self, record: logging.LogRecord) -> None:
        error = sys.exc_info()[1]
        if not isinstance(error, OSError):
            super().handleError(record)
            return
        logging.getLogger().removeHandler(self)
        with suppress(OSError):  # flushing its buffer fails again
            self.close()
        log.critical("the log ends: %s", error)


_QT_LEVELS = {
    QtMsgType.QtDebugMsg: logging.DEBUG,
    QtMsgType.QtInfoMsg: logging.INFO,
    QtMsgType.QtWarningMsg: logging.WARNING,
    QtMsgType.QtCriticalMsg: logging.ERROR,
    QtMsgType.QtFatalMsg: logging.CRITICAL,
}


def log_qt(kind: QtMsgType, _context: QMessageLogContext, message: str) -> None:
    """Log a message of Qt: a handler for `qInstallMessageHandler`."""
    logging.getLogger("qt").log(_QT_LEVELS[kind], "%s", message)


def log_vtk() -> None:
    """Send VTK's messages to the log, instead of to its own window or the terminal."""
    from vtkmodules.util.misc import calldata_type
    from vtkmodules.vtkCommonCore import VTK_STRING, vtkLogger, vtkOutputWindow

    logger = logging.getLogger("vtk")
    levels = {
        "ErrorEvent": logging.ERROR,
        "WarningEvent": logging.WARNING,
        "TextEvent": logging.INFO,
    }

    @calldata_type(VTK_STRING)  # type: ignore[no-untyped-call, untyped-decorator]
    def receive(_window: object, event: str, message: str) -> None:
        logger.log(levels[event], "%s", message.strip())

    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    window: Any = vtkOutputWindow()
    window.SetDisplayModeToNever()
    for event in levels:
        window.AddObserver(event, receive)
    vtkOutputWindow.SetInstance(window)
