"""Log uncaught exceptions, and report them in one dialog."""

import logging
import platform
import sys
import threading
import traceback
from pathlib import Path
from types import TracebackType

from PySide6 import __version__ as pyside_version
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication, QDialog, QDialogButtonBox

from app import __version__
from widgets.parts.layouts import in_column
from widgets.parts.plain import PlainLabel, set_tip

log = logging.getLogger(__name__)


class ErrorReport(QDialog):
    """Reports an error without blocking the window; `log_file` is None if there is no log."""

    def __init__(self, log_file: Path | None) -> None:
        super().__init__()
        self.setWindowTitle(self.tr("Something went wrong"))
        self._log_file, self._details = log_file, ""
        self.count = 0  # the errors since the report was closed
        selectable = Qt.TextInteractionFlag.TextSelectableByMouse
        labels = (PlainLabel(wordWrap=True, textInteractionFlags=selectable) for _ in range(2))
        self._sentence, self._place = labels
        self._sentence.setMinimumWidth(420)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        copy = buttons.addButton(self.tr("Copy details"), QDialogButtonBox.ButtonRole.ActionRole)
        set_tip(copy, self.tr("Copies the details that a developer needs"))
        copy.clicked.connect(self._copy)
        buttons.rejected.connect(self.reject)
        self.finished.connect(self._forget)
        in_column(self._sentence, self._place, buttons, on=self)

    def show_error(self, summary: str, details: str) -> None:
        """Say an exception and keep its traceback; until the report is closed, count more."""
        self.count += 1
        if self.count == 1:
            self._details, self._summary = details, summary
        text = self.tr("An error in the program: {0}. Your work is still there.")
        text = text.format(self._summary.rstrip("."))
        if self.count == 2:
            text += " " + self.tr("Another error followed it.")
        elif self.count > 2:
            text += " " + self.tr("{0} more errors followed it.").format(self.count - 1)
        self._sentence.setText(text)
        place = self.tr("There is no log, because it could not be written.")
        if self._log_file:
            place = self.tr("The log: {0}").format(self._log_file)
        self._place.setText(place)
        self.adjustSize()  # or more text than before is cut off

    def _forget(self) -> None:
        self.count = 0

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(
            f"Frustum Lab {__version__}, Python {platform.python_version()}, "
            f"PySide6 {pyside_version}, {platform.platform()}\n{self._details}"
        )


class ExceptionWatch(QObject):
    """Logs the uncaught exceptions of slots and threads, counts them, and shows the report.

    A class does not see it, and it takes no key from a talk: it waits until presenting ends.
    """

    _seen = Signal(str, str)

    def __init__(self, log_file: Path | None) -> None:
        super().__init__()
        self._log_file = log_file
        self.report: ErrorReport | None = None
        self.caught = 0
        self._waits = False
        # Queued: a thread must not touch widgets, and a slot may run inside a paint event.
        self._seen.connect(self._show, Qt.ConnectionType.QueuedConnection)

    def install(self) -> None:
        sys.excepthook = self._caught
        threading.excepthook = self._caught_in_thread

    @staticmethod
    def remove() -> None:
        sys.excepthook = sys.__excepthook__
        threading.excepthook = threading.__excepthook__

    def _caught(
        self, kind: type[BaseException], error: BaseException, trace: TracebackType | None
    ) -> None:
        if issubclass(kind, KeyboardInterrupt):
            QApplication.closeAllWindows()
            return
        self.caught += 1
        log.critical("unexpected %s", kind.__name__, exc_info=(kind, error, trace))
        last_line = traceback.format_exception_only(kind, error)[-1].strip()
        details = "".join(traceback.format_exception(kind, error, trace))
        self._seen.emit(" ".join(last_line.split()), details)

    def _caught_in_thread(self, args: threading.ExceptHookArgs) -> None:
        if args.exc_type is not SystemExit and args.exc_value is not None:
            self._caught(args.exc_type, args.exc_value, args.exc_traceback)

    def put_off(self, waits: bool) -> None:
        """Hide a report from a class, or show it."""
        self._waits = waits
        if self.report is not None and self.report.count:
            self.report.setVisible(not waits)

    def _show(self, summary: str, details: str) -> None:
        try:
            if self.report is None:
                self.report = ErrorReport(self._log_file)
            self.report.show_error(summary, details)
            self.put_off(self._waits)
        except Exception:  # raising it would call this method again, forever
            log.critical("the report itself failed", exc_info=True)
