"""Everything round the window that is not the window.

::

    display there? -> QApplication -> OpenGL there? -> log, settings, language -> MainWindow
          | no                             | no
          +---------- one sentence --------+     (Qt and VTK would end the process instead)

What goes wrong later, in a slot, in a thread, in Qt or in VTK, ends up in one log file, and an
unexpected exception also in one `Report` on the screen.
"""

from __future__ import annotations

import ctypes
import locale
import logging
import logging.handlers
import os
import platform
import signal
import socket
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import FrameType, TracebackType
from typing import TYPE_CHECKING, Any

from PySide6 import __version__ as pyside_version
from PySide6.QtCore import (
    QBuffer,
    QEvent,
    QIODevice,
    QLibraryInfo,
    QLocale,
    QMessageLogContext,
    QObject,
    QSocketNotifier,
    Qt,
    QtMsgType,
    QTranslator,
    Signal,
    qInstallMessageHandler,
)
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDialogButtonBox,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from app import __version__, bootstrap
from app.document.document import Document, write_bytes_atomically
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from widgets.program import opengl
from widgets.program.opengl import DisplayError as DisplayError  # what `run_window` raises
from widgets.window.settings import Settings, log_path, name_application, settings_path

if TYPE_CHECKING:
    from app.scenes.scene import Scene

log = logging.getLogger(__name__)

TRANSLATIONS = Path(__file__).parent / "translations"
WITHOUT_DISPLAY = "“export”, “project” and “matrices” need none."
LARGEST_LOG = 1_000_000
"""Bytes after which a new log file is begun; two old ones are kept."""
X_RETRIES_S = (0.1, 0.4, 0.0)
"""Pauses after each try to reach an X server, which may be starting anew."""
FIRST_PICTURE_S = 60.0
"""Longest wait for the window of a screenshot to be on the screen."""


IN_FILE = QT_TRANSLATE_NOOP("Refusal", "{0}: {1}")
NOT_WHOLE = QT_TRANSLATE_NOOP("Refusal", "{0}: the window could not be shown whole.")
NO_WINDOW = QT_TRANSLATE_NOOP("Refusal", "{0}: the window did not appear on the screen.")


@dataclass(frozen=True)
class Options:
    """What the command line asks of the window besides its document.

    Attributes
    ----------
    theme : str or None
        ``"light"`` or ``"dark"`` for this once; the settings stay as they are.
    size : (int, int) or None
        Width and height of the window, in pixels of the screen's scale.
    screenshot : Path or None
        Where to put a picture of the window, which closes then. The user's settings are neither
        read nor written, and the theme is light, so that the picture is the same everywhere.
    """

    theme: str | None = None
    size: tuple[int, int] | None = None
    screenshot: Path | None = None


# --------------------------------------------------------------------------- log


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


def _log_qt(kind: QtMsgType, _context: QMessageLogContext, message: str) -> None:
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


# --------------------------------------------------------------------------- exceptions


class Report(QDialog):
    """Says that something unexpected happened; not modal, and never more than one at a time.

    Parameters
    ----------
    log_file : Path or None
        Where the details are; None if there is no log.
    """

    def __init__(self, log_file: Path | None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Something went wrong"))
        self._log_file = log_file
        self._count = 0
        self._details = ""
        self._sentence = QLabel()
        self._place = QLabel()
        for label in (self._sentence, self._place):
            label.setTextFormat(Qt.TextFormat.PlainText)
            label.setWordWrap(True)
            label.setMinimumWidth(420)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        copy = buttons.addButton(self.tr("Copy details"), QDialogButtonBox.ButtonRole.ActionRole)
        copy.setToolTip(self.tr("Copies what a person who can repair it needs to know"))
        copy.clicked.connect(self._copy)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.addWidget(self._sentence)
        layout.addWidget(self._place)
        layout.addWidget(buttons)

    @property
    def text(self) -> str:
        """What it says now."""
        return f"{self._sentence.text()}\n{self._place.text()}"

    def tell(self, summary: str, details: str) -> None:
        """Show an exception; while it is shown, further ones are only counted.

        Parameters
        ----------
        summary : str
            The exception in one line.
        details : str
            Its traceback.
        """
        if self.isHidden():
            self._count = 0
        self._count += 1
        if self._count == 1:
            self._details = details
            self._summary = summary
        text = self.tr("An error in the program: {0}. Your work is still there.").format(
            self._summary.rstrip(".")
        )
        if self._count > 1:
            text += " " + self.tr("It or others came {0} more times.").format(self._count - 1)
        self._sentence.setText(text)
        self._place.setText(
            self.tr("The log: {0}").format(self._log_file)
            if self._log_file
            else self.tr("There is no log, because it could not be written.")
        )
        self.show()

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(
            f"Frustum Lab {__version__}, Python {platform.python_version()}, "
            f"PySide6 {pyside_version}, {platform.platform()}\n{self._details}"
        )


class ExceptionWatch(QObject):
    """Logs exceptions that nobody caught, from slots and from threads, and shows the report.

    Parameters
    ----------
    log_file : Path or None
        For the report.

    Attributes
    ----------
    caught : int
        How many exceptions there were.
    """

    _seen = Signal(str, str)

    def __init__(self, log_file: Path | None) -> None:
        super().__init__()
        self._log_file = log_file
        self.report: Report | None = None
        self.caught = 0
        # Queued: a thread may not touch widgets, and a slot may be in the middle of a paint.
        self._seen.connect(self._show, Qt.ConnectionType.QueuedConnection)

    def install(self) -> None:
        """Take over Python's two hooks."""
        sys.excepthook = self._caught
        threading.excepthook = self._caught_in_thread

    @staticmethod
    def remove() -> None:
        """Give the hooks back."""
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

    def _show(self, summary: str, details: str) -> None:
        try:
            if self.report is None:
                self.report = Report(self._log_file)
            self.report.tell(summary, details)
        except Exception:  # it would come here again, for ever
            log.critical("the report itself failed", exc_info=True)


# --------------------------------------------------------------------------- display


@contextmanager
def display() -> Iterator[None]:
    """Make sure that Qt will find a screen inside: without one it ends the process.

    The connection to an X server is held until Qt has its own: a server without any starts anew
    (under xvfb-run, for one) and is deaf meanwhile.

    Raises
    ------
    DisplayError
        If there is none.
    """
    leave = _reach_display() if sys.platform.startswith("linux") else None
    try:
        yield
    finally:
        if leave is not None:
            leave()


def _reach_display() -> Callable[[], object] | None:
    """Connect to Wayland or X; return what ends the connection, if it has to be held."""
    wanted = os.environ.get("QT_QPA_PLATFORM", "")
    names = [part.partition(":")[0] for part in wanted.split(";")] if wanted else []
    wayland = not names or any(name.startswith("wayland") for name in names)
    x11 = not names or "xcb" in names
    if not wayland and not x11:
        raise DisplayError(
            f"QT_QPA_PLATFORM = {wanted}: must be xcb or wayland, because no other shows OpenGL "
            "windows here; unset it."
        )
    if wayland and _wayland_answers():
        return None
    display = os.environ.get("DISPLAY", "")
    if not x11 or not display:
        name = "DISPLAY" if x11 else "WAYLAND_DISPLAY"
        raise DisplayError(
            f"There is no screen to open a window on ({name} leads to none): start it in a desktop "
            "session, over ssh with -X, or with xvfb-run -s '+extension GLX' in front; "
            + WITHOUT_DISPLAY
        )
    return _reach_x11(display)


def _wayland_answers() -> bool:
    if not os.environ.get("XDG_RUNTIME_DIR") or not (
        os.environ.get("WAYLAND_DISPLAY") or os.environ.get("XDG_SESSION_TYPE") == "wayland"
    ):
        return False
    try:
        client = ctypes.CDLL("libwayland-client.so.0")
    except OSError:
        return False
    client.wl_display_connect.restype = ctypes.c_void_p
    client.wl_display_disconnect.argtypes = [ctypes.c_void_p]
    connection = client.wl_display_connect(None)
    if connection:
        client.wl_display_disconnect(connection)
    return bool(connection)


def _reach_x11(display: str) -> Callable[[], object]:
    plugins = QLibraryInfo.path(QLibraryInfo.LibraryPath.PluginsPath)
    try:
        # Qt's own way to the X server, with all the system libraries that it needs.
        ctypes.CDLL(os.path.join(plugins, "platforms", "libqxcb.so"))
        xcb = ctypes.CDLL("libxcb.so.1")
    except OSError as error:
        raise DisplayError(
            f"Qt cannot reach the X server, because a system library is missing ({error}); "
            "python3 -m app doctor says which package brings it."
        ) from error
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connect.argtypes = [ctypes.c_char_p, ctypes.c_void_p]
    xcb.xcb_connection_has_error.argtypes = [ctypes.c_void_p]
    xcb.xcb_disconnect.argtypes = [ctypes.c_void_p]
    for pause_s in X_RETRIES_S:
        connection = xcb.xcb_connect(os.fsencode(display), None)
        if not xcb.xcb_connection_has_error(connection):
            return partial(xcb.xcb_disconnect, connection)
        xcb.xcb_disconnect(connection)
        time.sleep(pause_s)
    raise DisplayError(
        f"The X server DISPLAY = {display} does not answer or does not let this user in: start "
        "it in a desktop session, over ssh with -X, or with xvfb-run -s '+extension GLX' in "
        f"front; {WITHOUT_DISPLAY}"
    )


# --------------------------------------------------------------------------- running


def make_application() -> QApplication:
    """Make the QApplication, ready for OpenGL windows.

    Raises
    ------
    DisplayError
        If no window can be opened here.
    """
    with display():
        name_application()
        opengl.prepare()
        application = QApplication(sys.argv[:1])
    application.setApplicationDisplayName("Frustum Lab")
    # Qt takes the user's locale for the C library too, where VTK's readers would then stop a
    # number at its point: 0.5 would be 0.
    locale.setlocale(locale.LC_NUMERIC, "C")
    return application


def translate(application: QApplication, language: str) -> bool:
    """Load the interface's language, if there is a translation.

    Parameters
    ----------
    application : QApplication
    language : str
        A locale, or nothing for the system's.
    """
    translator = QTranslator(application)
    wanted = QLocale(language) if language else QLocale.system()
    if not translator.load(wanted, "frustum_lab", "_", str(TRANSLATIONS)):
        return False
    return application.installTranslator(translator)


def close_on_interrupt(application: QApplication) -> Callable[[], None]:
    """Make Ctrl-C in the terminal close the windows as their own button does.

    Python sees a signal only when it runs, which Qt's loop may not let it for hours; a byte
    through a socket wakes the loop, and nothing has to poll. A second Ctrl-C, while a window
    still asks about unsaved work, ends the program at once.

    Returns
    -------
    callable
        Undoes it.
    """
    reading, writing = socket.socketpair()
    reading.setblocking(False)
    writing.setblocking(False)

    def note(_signal: int, _frame: FrameType | None) -> None:
        """Exist: only then does Python write the byte."""

    def close() -> None:
        if signal.SIGINT not in reading.recv(100):
            return
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        try:
            application.closeAllWindows()
        finally:
            signal.signal(signal.SIGINT, note)

    notifier = QSocketNotifier(reading.fileno(), QSocketNotifier.Type.Read, application)
    notifier.activated.connect(close)
    before = signal.signal(signal.SIGINT, note)
    signal.set_wakeup_fd(writing.fileno(), warn_on_full_buffer=False)

    def undo() -> None:
        notifier.setEnabled(False)
        signal.set_wakeup_fd(-1)
        signal.signal(signal.SIGINT, before)
        reading.close()
        writing.close()

    return undo


def run_window(
    document: Document,
    saved: Document,
    path: Path | None,
    options: Options,
    scene: Scene | None = None,
) -> int:
    """Open the window on a document and stay until it is closed.

    Parameters
    ----------
    document : Document
    saved : Document
        What of it is in its file: without what the command line changes.
    path : Path or None
        The file that was opened; the document is saved there if it is one itself.
    options : Options
    scene : Scene, optional
        The document's scene, if it is loaded already.

    Returns
    -------
    int
        0; 1 if an exception kept a part of the window from being shown.

    Raises
    ------
    DisplayError
        If no window can be opened here.
    Refusal
        If the document's scene cannot be loaded, there is no whole window to take a picture of, or
        the screenshot cannot be written.
    """
    application = make_application()
    found = opengl.probe()
    file_log = start_log()
    qInstallMessageHandler(_log_qt)
    watch = ExceptionWatch(log_path() if file_log else None)
    watch.install()
    undo_interrupt = close_on_interrupt(application)
    try:
        log.info(
            "Frustum Lab %s, Python %s, PySide6 %s, %s, OpenGL %s on %s",
            __version__, platform.python_version(), pyside_version, platform.platform(),
            found.version, found.renderer,
        )  # fmt: skip
        settings = Settings(None if options.screenshot else settings_path())
        if options.theme or options.screenshot:
            settings.override("theme", options.theme or "light")
        translate(application, settings.language)

        with bootstrap.for_good():
            from widgets.window.main_window import MainWindow

        log_vtk()
        try:
            window = MainWindow(
                document,
                settings=settings,
                software_rendering=found.software,
                saved=document if options.screenshot else saved,  # and closes without a question
                path=path,
                scene=scene,
            )
        except Refusal as error:
            if path is None or error.file is not None:
                raise
            raise Refusal.saying(IN_FILE, path, error) from error
        if options.size:
            window.resize(*options.size)
        show_window(window)
        failed = watch.caught
        if options.screenshot:
            if failed:
                window.close()
                raise Refusal.saying(NOT_WHOLE, options.screenshot)
            _take_screenshot(application, window, options.screenshot)
        else:
            application.exec()
        window.deleteLater()
        application.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    finally:
        undo_interrupt()
        watch.remove()
        qInstallMessageHandler(None)
    return 1 if failed else 0


def show_window(window: QWidget) -> None:
    """Show the window; an exception in one of its parts is reported, and does not end the program.

    In the event loop PySide6 gives such an exception to Python's hook. Here, where Python has
    called, it raises it, after all of the window has been shown.
    """
    try:
        window.show()
    except Exception:
        sys.excepthook(*sys.exc_info())


def _take_screenshot(application: QApplication, window: Any, path: Path) -> None:
    """Save a picture of the window once it is drawn, and close it.

    Parameters
    ----------
    application : QApplication
    window : MainWindow
    path : Path
        A PNG file.
    """
    limit = time.monotonic() + FIRST_PICTURE_S
    while not window.windowHandle().isExposed():
        application.processEvents()
        if time.monotonic() > limit:
            raise Refusal.saying(NO_WINDOW, path)
    application.processEvents()
    window.messages.hide()  # an offer to recover work is no part of the picture
    application.processEvents()
    png = QBuffer()
    png.open(QIODevice.OpenModeFlag.WriteOnly)
    window.grab().save(png, "PNG")
    window.close()
    write_bytes_atomically(path, bytes(png.data().data()))
