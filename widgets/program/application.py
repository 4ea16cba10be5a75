"""Everything round the window that is not the window.

::

    display there? -> QApplication -> OpenGL there? -> log, settings, language -> MainWindow
          | no                             | no
          +---------- one sentence --------+     (Qt and VTK would end the process instead)

What goes wrong later, in a slot, in a thread, in Qt or in VTK, ends up in one log file, and an
unexpected exception also in one `Report` on the screen.
"""

from __future__ import annotations

import locale
import logging
import logging.handlers
import platform
import signal
import socket
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any

from PySide6 import __version__ as pyside_version
from PySide6.QtCore import (
    QBuffer,
    QCoreApplication,
    QEvent,
    QEventLoop,
    QIODevice,
    QLocale,
    QSocketNotifier,
    Qt,
    QTranslator,
    qInstallMessageHandler,
)
from PySide6.QtWidgets import QApplication, QWidget

from app import __version__, bootstrap
from app.document.document import Document
from app.document.files import write_bytes_atomically
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from widgets.program import opengl
from widgets.program.display import display
from widgets.program.logs import log_qt, log_vtk, start_log
from widgets.program.report import ExceptionWatch
from widgets.window.settings import Settings, log_path, name_application, settings_path

if TYPE_CHECKING:
    from app.scenes.scene import Scene

log = logging.getLogger(__name__)

TRANSLATIONS = Path(__file__).parent / "translations"
FIRST_PICTURE_S = 60.0
"""Longest wait for the window of a screenshot to be on the screen."""
SAID_MS = 15_000
"""How long the status line says that Qt has no OpenGL."""


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
    canvas : str or None
        ``"opengl"`` or ``"raster"``: how the panes draw; None for the quicker one.
    start_card : bool
        Whether no file and no value was given: the start card then offers the scenes.
    """

    theme: str | None = None
    size: tuple[int, int] | None = None
    screenshot: Path | None = None
    canvas: str | None = None
    start_card: bool = True


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
    lesson: Path | None = None,
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
    lesson : Path, optional
        A lesson or a talk that shall be open.

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
    found = _probe(options)
    file_log = start_log()
    qInstallMessageHandler(log_qt)
    watch = ExceptionWatch(log_path() if file_log else None)
    watch.install()
    undo_interrupt = close_on_interrupt(application)
    try:
        log.info(
            "Frustum Lab %s, Python %s, PySide6 %s, %s, OpenGL %s on %s",
            __version__, platform.python_version(), pyside_version, platform.platform(),
            found.version or "none", found.renderer or application.platformName(),
        )  # fmt: skip
        settings = Settings(None if options.screenshot else settings_path())
        if options.theme or options.screenshot:
            settings.override("theme", options.theme or "light")
        translate(application, settings.language)

        with bootstrap.for_good():
            from widgets.window.main_window import MainWindow

        try:
            window = MainWindow(
                document,
                settings=settings,
                software_rendering=found.software,
                canvas=options.canvas or opengl.canvas(found),
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
        elif settings.geometry is None and not options.screenshot:
            window.setWindowState(Qt.WindowState.WindowMaximized)  # the first time
        if lesson is not None:
            window.lesson_card.open(lesson)
        window.first_painted.connect(partial(_open_panes, window))
        if found is opengl.NO_OPENGL:
            said = QCoreApplication.translate(
                "Program", "Qt has no OpenGL here: VTK draws the panes off the screen."
            )
            window.filled.connect(partial(window.status.showMessage, said, SAID_MS))
        if options.start_card and settings.start_card and not options.screenshot:
            window.filled.connect(window.show_start_card)
        failed: list[bool] = []
        window.filled.connect(lambda: failed.append(bool(watch.caught)))
        show_window(window)
        if options.screenshot:
            _take_screenshot(application, window, options.screenshot, watch)
        else:
            application.exec()
        window.deleteLater()
        application.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    finally:
        undo_interrupt()
        watch.remove()
        qInstallMessageHandler(None)
    return 1 if any(failed) else 0


def _probe(options: Options) -> opengl.OpenGL:
    """What OpenGL Qt has: none will do as well, if VTK can draw off the screen."""
    try:
        return opengl.probe()
    except opengl.DisplayError as error:
        if options.canvas == "opengl":
            raise
        from app.drawings.off_screen import check_off_screen

        try:
            check_off_screen()
        except RuntimeError:
            raise error from None
        return opengl.NO_OPENGL


def _open_panes(window: Any) -> None:
    """Import VTK, now that the window is seen, and fill its panes."""
    with bootstrap.for_good():
        from app.drawings import image, stage, world  # noqa: F401
    log_vtk()
    window.open_panes()


def show_window(window: QWidget) -> None:
    """Show the window; an exception in one of its parts is reported, and does not end the program.

    In the event loop PySide6 gives such an exception to Python's hook. Here, where Python has
    called, it raises it, after all of the window has been shown.
    """
    try:
        window.show()
    except Exception:
        sys.excepthook(*sys.exc_info())


def _take_screenshot(
    application: QApplication, window: Any, path: Path, watch: ExceptionWatch
) -> None:
    """Save a picture of the window once it is drawn, and close it.

    Parameters
    ----------
    application : QApplication
    window : MainWindow
    path : Path
        A PNG file.
    watch : ExceptionWatch
        What it has caught keeps a part of the window from being shown.
    """
    filled: list[bool] = []
    window.filled.connect(lambda: filled.append(True))
    limit = time.monotonic() + FIRST_PICTURE_S
    while not filled:
        application.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents, 100)
        if watch.caught:
            window.close()
            raise Refusal.saying(NOT_WHOLE, path)
        if time.monotonic() > limit:
            raise Refusal.saying(NO_WINDOW, path)
    application.processEvents()
    window.messages.hide()  # an offer to recover work is no part of the picture
    window.status.clearMessage()
    application.processEvents()
    png = QBuffer()
    png.open(QIODevice.OpenModeFlag.WriteOnly)
    window.grab().save(png, "PNG")
    window.close()
    write_bytes_atomically(path, bytes(png.data().data()))
