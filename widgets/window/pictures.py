"""Export what the panes show: into a file, or to the clipboard."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from PySide6.QtCore import QByteArray, QMimeData, QObject, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import QGuiApplication, QImage, QPainter, QPixmap
from PySide6.QtWidgets import QMainWindow

from app.document.codec import picture_json
from app.document.document import Document
from app.document.files import write_bytes_atomically
from app.drawings.figure import Figure
from app.model.refusal import REFUSALS, Cancelled, Refusal
from app.scenes.scene import Scene
from widgets.panes.canvas import release_context
from widgets.parts.messages import MessageBar, sentence
from widgets.parts.progress import ReportProgress, progress
from widgets.parts.saving import ask_where
from widgets.window.settings import Settings

if TYPE_CHECKING:
    from app.drawings.off_screen import Pixels

_Drawn = TypeVar("_Drawn")

MOST_IN_PREVIEW = 200_000
"""Triangles and points of a scene that is drawn anew for each change of the dialog."""


def image_of(pixels: "Pixels") -> QImage:
    height, width, _ = pixels.shape
    form = QImage.Format.Format_RGB888
    return QImage(pixels.tobytes(), width, height, 3 * width, form).copy()


class Pictures(QObject):
    """Exports and copies pictures for one window.

    Every PNG contains the document that it shows. The message bar reports failures. `seen` returns
    the document with its current view; `words` are the drawings', in the window's language.
    """

    exported = Signal(str)  # a sentence about what was exported or copied

    def __init__(
        self,
        window: QMainWindow,
        messages: MessageBar,
        seen: Callable[[], Document],
        scene: Callable[[str, str], Scene],
        titles: dict[str, str],
        words: Mapping[str, str],
        settings: Settings,
    ) -> None:
        super().__init__(window)
        self._settings = settings
        self._window, self._messages = window, messages
        self._seen, self._scene = seen, scene
        self._titles, self._words = titles, words

    def figure(self, **choices: Any) -> Figure:
        """Return a figure of what the window shows, in its language."""
        document = self._seen()
        scene = self._scene(document.scene, document.mesh)
        return Figure(document, scene, words=self._words, **choices)

    def export_dialog(self) -> None:
        from widgets.window.export_dialog import ExportDialog

        kept = self._settings.export
        dialog = ExportDialog(self._titles, self.figure(), self._window, preview, kept)
        accepted = dialog.exec()
        dialog.deleteLater()
        if not accepted:
            return
        self._settings.export = dialog.kept
        path = self._where(self.tr("Export a picture"), dialog.ending)
        if path is not None:
            self.export(path, dialog.figure())

    def _where(self, title: str, ending: str = "png") -> Path | None:
        """Ask for a file; None if the user cancels."""
        kinds = self.tr("{0} pictures (*.{1})").format(ending.upper(), ending)
        path = ask_where(self._window, title, f"frustum-lab.{ending}", kinds, f".{ending}")
        return Path(path) if path else None

    def export(self, path: Path, figure: Figure) -> bool:
        """Write a figure; return False if that fails or the user cancels it."""
        return self._try(
            lambda: self._draw(partial(figure.save, path)), self.tr("Exported {0}").format(path)
        )

    def _draw(self, draw: Callable[[ReportProgress], _Drawn]) -> _Drawn:
        release_context()
        with progress(self._window, self.tr("Drawing the picture")) as tell:
            return draw(tell)

    def export_diagram(self, image: QImage) -> None:
        """Ask where to write the picture of a diagram, and write it."""
        path = self._where(self.tr("Export a diagram"))
        if path is not None:
            done = self.tr("Exported {0}").format(path)
            self._try(lambda: write_bytes_atomically(path, self._png(_pixels(image))), done)

    def copy_diagram(self, image: QImage) -> None:
        self._try(lambda: self._copy(_pixels(image)), self.tr("Copied the diagram"))

    def copy(self) -> bool:
        """Copy the three panes to the clipboard; False if that fails or the user cancels it."""
        figure = self.figure(size=(1800, 600))
        return self._try(
            lambda: self._copy(self._draw(figure.pixels)), self.tr("Copied the picture")
        )

    def _png(self, pixels: "Pixels") -> bytes:
        """Return the file of a picture, with the document."""
        from app.drawings.figure_files import png_bytes

        return png_bytes(pixels, picture_json(self._seen()))

    def _copy(self, pixels: "Pixels") -> None:
        png = self._png(pixels)
        data = QMimeData()
        data.setImageData(QImage.fromData(png))
        data.setData("image/png", QByteArray(png))
        QGuiApplication.clipboard().setMimeData(data)

    def _try(self, act: Callable[[], object], done: str) -> bool:
        """Call `act`, and report success or, in one sentence, why it failed."""
        try:
            act()
        except Cancelled:
            return False
        except Refusal as error:
            self._messages.show_message(sentence(error))
            return False
        self._messages.done()
        self.exported.emit(done)
        return True


def preview(figure: Figure, room: QSize, tell: ReportProgress) -> QPixmap:
    """Draw a figure with as few pixels as a preview has."""
    from PySide6.QtSvg import QSvgRenderer

    from app.drawings.svg import svg

    drawn = figure.scene.triangles + figure.scene.dot_count
    if drawn > MOST_IN_PREVIEW:
        raise Refusal.saying(REFUSALS["no-preview"], drawn)
    figure = replace(figure, transparent=False)
    release_context()
    if figure.hidden != "none":
        size, shapes = figure.shapes(tell)
        fitting = QSizeF(*size).scaled(room, Qt.AspectRatioMode.KeepAspectRatio).toSize()
        picture = QImage(fitting, QImage.Format.Format_RGB32)
        picture.fill(Qt.GlobalColor.white)
        with QPainter(picture) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            QSvgRenderer(QByteArray(svg(shapes, size, figure.scene.title))).render(painter)
        return QPixmap.fromImage(picture)
    width, height = figure.full_size.px
    scale = min(1.0, room.width() / width, room.height() / height)
    return QPixmap.fromImage(image_of(replace(figure, scale=scale).pixels(tell)))


def _pixels(image: QImage) -> "Pixels":
    image = image.convertToFormat(QImage.Format.Format_RGBA8888)
    size = image.height(), image.width(), 4
    return np.frombuffer(image.constBits(), np.uint8).reshape(size).copy()
