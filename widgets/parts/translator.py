"""Qt's texts in the language of the program, also where no window is, and Qt's plugins."""

import sys

import PySide6
from PySide6.QtCore import QCoreApplication, QTranslator
from PySide6.QtWidgets import QApplication

from app import languages


class Translator(QTranslator):
    """Gives Qt the texts of `app.languages`."""

    def translate(
        self, context: str, text: str, _disambiguation: str | None = None, count: int = -1
    ) -> str:
        """Return a text of the window in its language; as it is where none is known."""
        return languages.translate(text, context, None if count < 0 else count)


def find_plugins() -> str:
    """Tell Qt where its plugins are: PySide tells it a path that a comma or a semicolon ends."""
    inside = "plugins" if sys.platform == "win32" else "Qt/plugins"  # if they came by pip
    QCoreApplication.addLibraryPath(f"{PySide6.__path__[0]}/{inside}")
    return "".join(QCoreApplication.libraryPaths()[:1])


def off_screen_application() -> QApplication:
    """Return the application that is there, or one without a display for a command."""
    application = QCoreApplication.instance()
    if application is None:
        find_plugins()
        application = QApplication(["app", "-platform", "offscreen"])
        application.installTranslator(Translator(application))
    assert isinstance(application, QApplication)
    return application
