"""Find out which OpenGL this machine offers, before the first window.

VTK needs OpenGL 3.2 and crashes silently with less, so this module queries Qt first.
Call `prepare` before the QApplication exists, and `probe` after it but before the first window.
Run as a program, this module prints the answer as JSON: ``doctor`` runs it in a separate process,
which a broken driver may crash.
"""

import atexit
import json
import os
import sys
from dataclasses import asdict, dataclass

from PySide6.QtCore import QCoreApplication, Qt, qInstallMessageHandler
from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext, QSurfaceFormat

from app.languages import said
from widgets.parts.translator import find_plugins

NEEDED = (3, 2)
_GL_RENDERER, _GL_VERSION = 0x1F01, 0x1F02
_SOFTWARE = (
    "llvmpipe", "softpipe", "swrast", "software rasterizer", "swiftshader", "swr ",
    "gdi generic", "microsoft basic", "apple software",
)  # fmt: skip


class DisplayError(RuntimeError):
    """No window can be drawn without a screen or OpenGL; the text says why and what to do."""

    def __init__(self, sentence: str, *values: object) -> None:
        super().__init__(said(sentence, *values))


@dataclass(frozen=True)
class OpenGL:
    version: str  # the driver's text, such as ``"4.5 (Core Profile) Mesa 22.3.6"``
    renderer: str
    software: bool  # whether the CPU draws, because a graphics card or its driver is missing


NO_OPENGL = OpenGL("", "", software=True)  # Qt has no OpenGL; VTK draws off the screen
WITHOUT_OPENGL = ("offscreen", "minimal", "vnc")  # Qt platforms whose windows cannot show OpenGL


def canvas(graphics: OpenGL) -> str:
    """Return the faster value of ``--canvas``."""
    return "raster" if graphics.software else "opengl"


def is_software(renderer: str) -> bool:
    """Whether a renderer's name belongs to a program rather than to a graphics card."""
    return any(name in renderer.lower() for name in _SOFTWARE)


def prepare() -> None:
    """Choose the kind of OpenGL for all later windows; call it before the QApplication."""
    # Mesa's llvmpipe waits for the slowest of its threads, one for each core: with twice as many, a
    # core that another program takes delays a picture less. No other driver reads this.
    os.environ.setdefault("LP_NUM_THREADS", str(2 * (os.cpu_count() or 1)))
    surface_format = QSurfaceFormat.defaultFormat()
    surface_format.setVersion(*NEEDED)
    surface_format.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    surface_format.setSamples(0)
    QSurfaceFormat.setDefaultFormat(surface_format)
    find_plugins()
    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_ShareOpenGLContexts)


def probe() -> OpenGL:
    """Query an OpenGL context without a window; raise DisplayError if there is no OpenGL 3.2."""
    platform, advice = QGuiApplication.platformName(), said("update-driver")
    if platform in WITHOUT_OPENGL:  # some provide a context but show garbage
        raise DisplayError("Qt's platform {0} shows no OpenGL windows. {1}", platform, advice)
    surface, context = QOffscreenSurface(), QOpenGLContext()
    before = qInstallMessageHandler(lambda *_message: None)  # the DisplayError reports it instead
    try:
        surface.create()
        is_usable = surface.isValid() and context.create() and context.makeCurrent(surface)
    finally:
        qInstallMessageHandler(before)
    if not is_usable:
        raise DisplayError("No OpenGL could be started, and 3.2 is needed. {0}", advice)
    try:
        functions = context.functions()
        version, renderer = (
            str(functions.glGetString(name)) for name in (_GL_VERSION, _GL_RENDERER)
        )
        numbers = context.format().version()
    finally:
        context.doneCurrent()
    if context.isOpenGLES():
        raise DisplayError("opengl-es", renderer, advice)
    if tuple(numbers) < NEEDED:
        raise DisplayError("old-opengl", *numbers[:2], renderer, advice)
    return OpenGL(version, renderer, is_software(renderer))


def draw_through_qt() -> None:
    """Let VTK draw off the screen through Qt's OpenGL; raise DisplayError if that is too old."""
    from PySide6.QtWidgets import QApplication

    from app.drawings import off_screen
    from widgets.panes.interactor import window_off_screen

    if QApplication.instance() is None:  # for a command without a window
        prepare()
        QApplication(sys.argv[:1])
    probe()
    off_screen.make_window = window_off_screen
    atexit.register(off_screen.close_kept)  # before Qt ends


def main() -> int:
    """Print the answer as one line of JSON."""
    prepare()
    application = QGuiApplication(sys.argv[:1])
    answer: dict[str, object] = {
        "platform": application.platformName(),
        "screens": [
            [screen.name(), screen.geometry().width(), screen.geometry().height(),
             screen.devicePixelRatio()]
            for screen in application.screens()
        ],
    }  # fmt: skip
    graphics = NO_OPENGL
    try:
        graphics = probe()
        answer |= asdict(graphics)
    except DisplayError as error:
        answer["error"] = str(error)
    answer["canvas"] = canvas(graphics)
    print(json.dumps(answer))
    return 0


if __name__ == "__main__":
    sys.exit(main())
