"""Start and end of the program around its window.

::

    display there? -> QApplication -> OpenGL there? -> log, settings, language -> MainWindow
          | no                             | no
          +---------- one sentence --------+     (Qt and VTK would end the process instead)

Later errors of slots, threads, Qt and VTK go to one log file; an uncaught exception also opens a
`ErrorReport`.
"""

import contextlib
import gc
import locale
import logging
import platform
import signal
import socket
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, Any

from PySide6 import __version__ as pyside_version
from PySide6.QtCore import (
    QAbstractEventDispatcher,
    QEvent,
    QEventLoop,
    QLocale,
    QSocketNotifier,
    Qt,
    qInstallMessageHandler,
)
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QApplication, QWidget

from app import __version__, languages, python_packages, strangers
from app.document.document import Document
from app.document.files import write_bytes_atomically
from app.lecture.letters import Letters
from app.model.refusal import REFUSALS, Refusal
from widgets.parts.saving import png_of
from widgets.parts.translator import Translator
from widgets.program import opengl
from widgets.program.display import display
from widgets.program.logs import EncodingNotes, log_qt, log_vtk, start_log
from widgets.program.report import ExceptionWatch
from widgets.window.settings import Settings, labels_path, log_path, name_application, settings_path

if TYPE_CHECKING:
    from app.scenes.scene import Scene
    from widgets.window.main_window import MainWindow, Work

log = logging.getLogger(__name__)

FIRST_PICTURE_S = 60.0  # longest wait for the window of a screenshot to appear
MESSAGE_MS = 15_000  # duration of the status line's message that Qt has no OpenGL


@dataclass(frozen=True)
class Options:
    """The command line's options for the window, besides its document."""

    theme: str | None = None  # ``"light"`` or ``"dark"`` for this run only
    size: tuple[int, int] | None = None
    """The window's width and height, in pixels of the screen's scale."""
    screenshot: Path | None = None
    """The file for a picture of the window, which then closes. The user's settings are neither read
    nor written, and the theme is light, so that the picture is the same everywhere."""
    canvas: str | None = None  # ``"opengl"`` or ``"raster"``: how panes draw; None for the faster
    start_card: bool = True  # whether to offer the start card: no file and no value was given
    letters: Letters | None = None  # for lessons, instead of their own
    language: str | None = None  # for this run only


def make_application() -> QApplication:
    """Make the QApplication, ready for OpenGL windows; raise DisplayError if none can be opened."""
    with display():
        name_application()
        opengl.prepare()
        application = QApplication(sys.argv[:1])
    application.setApplicationDisplayName("Frustum Lab")
    # Qt sets the user's locale for the C library too. With a decimal comma, VTK's readers would end
    # a number at its point: 0.5 would be 0.
    locale.setlocale(locale.LC_NUMERIC, "C")
    return application


def choose_language(asked: str) -> None:
    """Speak the language that is asked for, or that of the system."""
    language = asked or languages.known(QLocale.system().uiLanguages())
    languages.choose(language)
    is_english = language == languages.ENGLISH  # of which country, the system says
    QLocale.setDefault(QLocale.system() if is_english else QLocale(language))  # of dates


def close_on_interrupt(application: QApplication) -> Callable[[], None]:
    """Make Ctrl-C in the terminal close the windows like their close buttons.

    Python handles a signal only when Python code runs, which may take hours inside Qt's loop. A
    byte through a socket wakes the loop, without polling. A second Ctrl-C, while a window shows its
    question about unsaved work, ends the program at once. Returns a function that undoes all this.
    """
    reading, writing = socket.socketpair()
    reading.setblocking(False)
    writing.setblocking(False)

    def note(_signal: int, _frame: FrameType | None) -> None:
        """Do nothing; Python writes the byte only if there is a handler."""

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


def collect_when_idle() -> Callable[[], None]:
    """Let Python collect garbage only while the window waits; return a function that undoes it.

    Python would collect in any thread, and Qt may crash if another thread destroys a widget.
    """
    dispatcher = QAbstractEventDispatcher.instance()

    def collect() -> None:
        pairs = zip(gc.get_count(), gc.get_threshold(), strict=True)
        due = [each for each, (count, most) in enumerate(pairs) if 0 < most < count]
        if due:
            gc.collect(due[-1])

    def undo() -> None:
        dispatcher.aboutToBlock.disconnect(collect)
        gc.enable()

    gc.disable()
    dispatcher.aboutToBlock.connect(collect)
    return undo


def run_window(
    document: Document,
    saved: Document,
    path: Path | None,
    options: Options,
    scene: "Scene | None" = None,
    lesson: Path | None = None,
) -> int:
    """Open the window on a document; return 0 when it is closed, 1 if a part of it stayed empty.

    `saved` is the document in its file, without the changes of the command line; `path` is the file
    that was opened. A DisplayError if no window can be opened. A `Refusal` if the document's scene
    cannot be loaded, or the screenshot cannot be taken or written.
    """
    application = make_application()
    graphics, canvas = find_graphics(options)
    file_log = start_log()
    qInstallMessageHandler(log_qt)
    watch = ExceptionWatch(log_path() if file_log else None)
    watch.install()
    undo_interrupt, undo_idle = close_on_interrupt(application), collect_when_idle()
    try:
        log.info(
            "Frustum Lab %s, Python %s, PySide6 %s, %s, OpenGL %s on %s",
            __version__, platform.python_version(), pyside_version, platform.platform(),
            graphics.version or "none", graphics.renderer or application.platformName(),
        )  # fmt: skip
        settings = Settings(None if options.screenshot else settings_path())
        if options.theme or options.screenshot:
            settings.override("theme", options.theme or "light")
        application.installTranslator(Translator(application))
        choose_language(options.language or settings.language)

        with python_packages.for_good():
            from widgets.window.main_window import Work

        failed: list[bool] = []
        work: Work | None = Work(document, saved, path, lesson)
        while work is not None:
            window = _window_with(work, scene, settings, graphics, canvas, options)
            window.first_painted.connect(partial(_open_panes, window))
            window.present.switched.connect(watch.put_off)
            notes = EncodingNotes(window.messages.show_message)
            logging.getLogger(strangers.__name__).addHandler(notes)
            window.filled.connect(lambda: failed.append(bool(watch.caught)))
            show_window(window)
            if options.screenshot:
                _take_screenshot(application, window, options.screenshot, watch)
            else:
                if window.isVisible():  # or its close is over, and nothing would end the loop
                    application.exec()
                from app.drawings import kept_labels

                kept_labels.save(labels_path())
            logging.getLogger(strangers.__name__).removeHandler(notes)
            work = window.work_left
            window.deleteLater()
            application.sendPostedEvents(None, QEvent.Type.DeferredDelete)
            if work is not None:  # in another language: a window's texts are made with it
                choose_language(settings.language)
                options, scene = replace(options, start_card=False, size=None), None
    finally:
        undo_interrupt()
        undo_idle()
        watch.remove()
        qInstallMessageHandler(None)
    return 1 if any(failed) else 0


def _window_with(
    work: "Work",
    scene: "Scene | None",
    settings: Settings,
    graphics: opengl.OpenGL,
    canvas: str,
    options: Options,
) -> "MainWindow":
    """Make a window that goes on with some work."""
    from widgets.window.main_window import MainWindow

    saved = work.document if options.screenshot else work.saved  # and closes without a question
    try:
        window = MainWindow(
            work.document, settings=settings, software_rendering=graphics.software, canvas=canvas,
            saved=saved, path=work.path, scene=scene,
        )  # fmt: skip
    except Refusal as error:
        if work.path is None or error.file is not None:
            raise
        raise Refusal.saying(REFUSALS["in-file"], work.path, error) from error
    if options.size:
        window.resize(*options.size)
    elif settings.geometry is None and not options.screenshot:
        window.setWindowState(Qt.WindowState.WindowMaximized)  # the first start
    window.lessons.letters = options.letters
    window.go_on(work)
    if graphics is opengl.NO_OPENGL:
        said = languages.said("Qt has no OpenGL here: VTK draws the panes off the screen.")
        window.filled.connect(partial(window.status.showMessage, said, MESSAGE_MS))
    if options.start_card and settings.start_card and not options.screenshot:
        window.filled.connect(window.show_start_card)
    return window


def find_graphics(options: Options) -> tuple[opengl.OpenGL, str]:
    """Return Qt's OpenGL, or `NO_OPENGL` if VTK can draw off-screen without it, and the canvas."""
    try:
        graphics = opengl.probe()
    except opengl.DisplayError:
        if options.canvas == "opengl" or not draws_off_screen():
            raise
        return opengl.NO_OPENGL, "raster"
    # Windows without a driver: Qt brings an OpenGL in software, and VTK gets the system's 1.1.
    if graphics.software and sys.platform == "win32" and not draws_off_screen():
        opengl.draw_through_qt()
    return graphics, options.canvas or opengl.canvas(graphics)


def draws_off_screen() -> bool:
    from app.drawings.off_screen import check_off_screen

    with contextlib.suppress(RuntimeError):
        check_off_screen()
        return True
    return False


def _open_panes(window: Any) -> None:
    """Import VTK, now that the window is visible, and fill its panes."""
    with python_packages.for_good():
        from app.drawings import image, kept_labels, stage, world  # noqa: F401
    kept_labels.load_shipped()
    kept_labels.load(labels_path())
    log_vtk()
    window.open_panes()


def show_window(window: QWidget) -> None:
    """Show the window; an exception in one of its parts is reported but does not end the program.

    PySide6 passes an exception in the event loop to Python's hook, but raises one that occurs in
    `show` here, after the whole window is shown.
    """
    try:
        window.show()
    except Exception:
        sys.excepthook(*sys.exc_info())


def _take_screenshot(
    application: QApplication, window: Any, path: Path, watch: ExceptionWatch
) -> None:
    """Save a PNG picture of the window once it is drawn, and close the window.

    An exception that `watch` has caught means that a part of the window is missing.
    """
    filled: list[bool] = []
    window.filled.connect(lambda: filled.append(True))
    limit = time.monotonic() + FIRST_PICTURE_S
    while not filled:
        application.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents, 100)
        if watch.caught:
            window.close()
            raise Refusal.saying(REFUSALS["application-not-whole"], path)
        if time.monotonic() > limit:
            raise Refusal.saying(REFUSALS["no-window"], path)
    application.processEvents()
    window.messages.hide()  # the window may offer to recover work
    window.status.clearMessage()
    under = application.widgetAt(QCursor.pos())
    while under is not None:  # nothing lights up in the picture, wherever the pointer rests
        application.sendEvent(under, QEvent(QEvent.Type.Leave))
        under = under.parentWidget()
    application.processEvents()
    png = png_of(window.grab())
    window.close()
    write_bytes_atomically(path, png)
