"""What OpenGL this machine offers, asked before the first window.

VTK needs OpenGL 3.2 and crashes without a word where there is less, so that the question has to be
put by Qt, which answers. `prepare` comes before the QApplication, `probe` after it and before the
first window. Run as a program, this module prints the answer as JSON: ``doctor`` asks it that way,
because a broken driver can take the asking process down with it.
"""

from __future__ import annotations

import json
import sys
from dataclasses import asdict, dataclass

from PySide6.QtCore import QCoreApplication, Qt, qInstallMessageHandler
from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext, QSurfaceFormat

NEEDED = (3, 2)
_GL_RENDERER, _GL_VERSION = 0x1F01, 0x1F02
_SOFTWARE = (
    "llvmpipe", "softpipe", "swrast", "software rasterizer", "swiftshader", "swr ",
    "gdi generic", "microsoft basic", "apple software",
)  # fmt: skip

ADVICE = (
    "Update the graphics driver; on Linux install Mesa (libgl1-mesa-dri) or start with "
    "LIBGL_ALWAYS_SOFTWARE=1, and over a remote desktop use one that offers OpenGL."
)


class DisplayError(RuntimeError):
    """No window can be drawn here, for want of a screen or of OpenGL: why, and what to do."""


@dataclass(frozen=True)
class OpenGL:
    """The OpenGL that windows get here.

    Attributes
    ----------
    version : str
        As the driver gives it, ``"4.5 (Core Profile) Mesa 22.3.6"``.
    renderer : str
        What draws.
    software : bool
        Whether the processor draws, because there is no graphics card or no driver for it.
    """

    version: str
    renderer: str
    software: bool


NO_OPENGL = OpenGL("", "", software=True)
"""Qt has none: VTK draws off the screen, by what it finds."""
WITHOUT_OPENGL = ("offscreen", "minimal", "vnc")
"""Qt's platforms on which its windows show no OpenGL."""


def canvas(found: OpenGL) -> str:
    """Name the quicker way to draw the panes, of those of ``--canvas``."""
    return "raster" if found.software else "opengl"


def is_software(renderer: str) -> bool:
    """Whether a renderer's name is that of a program rather than of a graphics card."""
    return any(name in renderer.lower() for name in _SOFTWARE)


def prepare() -> None:
    """Choose the kind of OpenGL for every window to come; call it before the QApplication."""
    surface_format = QSurfaceFormat.defaultFormat()
    surface_format.setVersion(*NEEDED)
    surface_format.setProfile(QSurfaceFormat.OpenGLContextProfile.CoreProfile)
    surface_format.setSamples(0)
    QSurfaceFormat.setDefaultFormat(surface_format)
    QCoreApplication.setAttribute(Qt.ApplicationAttribute.AA_ShareOpenGLContexts)


def probe() -> OpenGL:
    """Make an OpenGL context without a window and ask it what it is.

    Raises
    ------
    DisplayError
        If there is none, or less than 3.2.
    """
    platform = QGuiApplication.platformName()
    if platform in WITHOUT_OPENGL:  # some give a context, and show garbage
        raise DisplayError(f"Qt's platform {platform} shows no OpenGL windows. {ADVICE}")
    surface, context = QOffscreenSurface(), QOpenGLContext()
    before = qInstallMessageHandler(lambda *_said: None)  # it is said below, in one sentence
    try:
        surface.create()
        is_usable = surface.isValid() and context.create() and context.makeCurrent(surface)
    finally:
        qInstallMessageHandler(before)
    if not is_usable:
        raise DisplayError(f"No OpenGL could be started, and 3.2 is needed. {ADVICE}")
    try:
        functions = context.functions()
        version, renderer = (
            str(functions.glGetString(name)) for name in (_GL_VERSION, _GL_RENDERER)
        )
        found = context.format().version()
    finally:
        context.doneCurrent()
    if context.isOpenGLES():
        raise DisplayError(f"Only OpenGL ES is offered here ({renderer}), not OpenGL 3.2. {ADVICE}")
    if tuple(found) < NEEDED:
        raise DisplayError(
            f"OpenGL {found[0]}.{found[1]} is too old ({renderer}): 3.2 is needed. {ADVICE}"
        )
    return OpenGL(version, renderer, is_software(renderer))


def main() -> int:
    """Print what is found as one line of JSON."""
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
    found = NO_OPENGL
    try:
        found = probe()
        answer |= asdict(found)
    except DisplayError as error:
        answer["error"] = str(error)
    answer["canvas"] = canvas(found)
    print(json.dumps(answer))
    return 0


if __name__ == "__main__":
    sys.exit(main())
