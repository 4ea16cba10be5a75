"""One log file: of the program, of Qt and of VTK."""

from __future__ import annotations

import logging
import logging.handlers
import sys
from contextlib import suppress
from typing import Any

from PySide6.QtCore import QMessageLogContext, QtMsgType

from widgets.window.settings import log_path

log = logging.getLogger(__name__)

LARGEST_LOG = 1_000_000
"""Bytes after which a new log file is begun; two old ones are kept."""


def start_log() -> logging.Handler | None:
    """Send all log records to the log file, those of crashes to standard error as well.

    Returns
    -------
    logging.Handler or None
        That of the file; None if it cannot be written.
    """
    root = logging.getLogger()
    root.setLevel(logging.INFO)
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


class _LogFile(logging.handlers.RotatingFileHandler):
    """A log that ends, with a line on the terminal, where the disk takes no more."""

    def handleError(self, record: logging.LogRecord) -> None:
        error = sys.exc_info()[1]
        if not isinstance(error, OSError):
            super().handleError(record)
            return
        logging.getLogger().removeHandler(self)
        with suppress(OSError):  # the same again, of what it still held
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
    """Send what Qt says to the log: a handler for `qInstallMessageHandler`."""
    logging.getLogger("qt").log(_QT_LEVELS[kind], "%s", message)


def log_vtk() -> None:
    """Send what VTK says to the log, instead of a window of its own or the terminal."""
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
