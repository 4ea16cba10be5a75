"""Export what the panes show: into a PNG file, or to the clipboard."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QByteArray, QMimeData, QObject, Signal
from PySide6.QtGui import QGuiApplication, QImage, QOpenGLContext
from PySide6.QtWidgets import QMainWindow

from app.document.codec import picture_json
from app.document.document import Document
from app.model.refusal import Cancelled, Refusal
from app.scenes.scene import Scene
from widgets.parts import palette
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import sentence
from widgets.parts.progress import progress
from widgets.parts.saving import ask_where

if TYPE_CHECKING:
    from app.drawings.off_screen import Pixels
    from widgets.window.export_dialog import ExportChoice


def image_of(pixels: Pixels) -> QImage:
    """Convert a drawn picture to Qt's image."""
    height, width, _ = pixels.shape
    form = QImage.Format.Format_RGB888
    return QImage(pixels.tobytes(), width, height, 3 * width, form).copy()


class Pictures(QObject):
    """Exports and copies pictures for one window.

    Every picture contains the document that it shows. The message bar reports failures.

    Parameters
    ----------
    seen : callable
        Returns the document with its current view.
    scene : callable
        Returns the loaded scene of a name and a mesh.
    titles : dict
        The panes' translated titles by name.
    words : mapping
        The drawings' words in the window's language.
    """

    told = Signal(str)
    """A sentence about what was exported or copied."""

    def __init__(
        self,
        window: QMainWindow,
        messages: MessageBar,
        seen: Callable[[], Document],
        scene: Callable[[str, str], Scene],
        titles: dict[str, str],
        words: Mapping[str, str],
    ) -> None:
        super().__init__(window)
        self._window, self._messages = window, messages
        self._seen, self._scene = seen, scene
        self._titles, self._words = titles, words

    def export_dialog(self) -> None:
        """Ask what to export and where, and export it."""
        from widgets.window.export_dialog import ExportDialog

        size = self._seen().projection.image_size
        dialog = ExportDialog(self._titles, size, self._window)
        if dialog.exec() != ExportDialog.DialogCode.Accepted:
            return
        path = self._where(self.tr("Export a picture"))
        if path is not None:
            self.export(path, dialog.choice())

    def _where(self, title: str) -> Path | None:
        """Ask for a file; None if the user cancels."""
        kinds = self.tr("PNG pictures (*.png)")
        path = ask_where(self._window, title, "frustum-lab.png", kinds, ".png")
        return Path(path) if path else None

    def export(self, path: Path, choice: ExportChoice) -> bool:
        """Write a picture; return False if that fails or the user cancels it."""
        return self._write(path, lambda document: self._draw(document, choice), choice.scale)

    def _write(self, path: Path, draw: Callable[[Document], Pixels], scale: float = 1.0) -> bool:
        from app.drawings.figures import write_png

        document = self._seen()

        def write() -> None:
            write_png(path, draw(document), picture_json(document), scale)

        return self._try(write, self.tr("Exported {0}").format(path))

    def export_diagram(self, image: QImage) -> None:
        """Ask where to write the picture of a diagram, and write it."""
        path = self._where(self.tr("Export a diagram"))
        if path is not None:
            self._write(path, lambda _document: _pixels(image))

    def copy_diagram(self, image: QImage) -> None:
        """Copy the picture of a diagram to the clipboard."""
        from app.drawings.figures import png_bytes

        png = png_bytes(_pixels(image), picture_json(self._seen()))
        self._try(lambda: _to_clipboard(png), self.tr("Copied the diagram"))

    def copy(self) -> bool:
        """Copy the three panes to the clipboard; False if that fails or the user cancels it."""
        from app.document.view import PANES
        from app.drawings.figures import png_bytes
        from widgets.window.export_dialog import ExportChoice

        document = self._seen()

        def put() -> None:
            pixels = self._draw(document, ExportChoice(PANES, (1800, 600), 1.0, False))
            _to_clipboard(png_bytes(pixels, picture_json(document)))

        return self._try(put, self.tr("Copied the picture"))

    def _try(self, act: Callable[[], object], done: str) -> bool:
        """Call `act`, and report success or, in one sentence, why it failed."""
        try:
            act()
        except Cancelled:
            return False
        except Refusal as error:
            self._messages.say(sentence(error))
            return False
        self._messages.done()
        self.told.emit(done)
        return True

    def _draw(self, document: Document, choice: ExportChoice) -> Pixels:
        from app.drawings.figures import render

        current = QOpenGLContext.currentContext()
        if current is not None:  # otherwise VTK may use Qt's context as its own
            current.doneCurrent()
        with progress(self._window, self.tr("Drawing the picture")) as tell:
            return render(
                self._scene(document.scene, document.mesh),
                document.projection,
                view=document.view,
                settings=document.settings,
                quality=document.quality,
                panes=choice.panes,
                size=choice.size,
                scale=choice.scale,
                transparent=choice.transparent,
                text_pt=choice.text_pt,
                style=palette.drawing_style(dark=False, screen_px=0.0, device_pixel_ratio=1.0),
                words=self._words,
                progress=tell,
            )


def _pixels(image: QImage) -> Pixels:
    image = image.convertToFormat(QImage.Format.Format_RGBA8888)
    size = image.height(), image.width(), 4
    return np.frombuffer(image.constBits(), np.uint8).reshape(size).copy()


def _to_clipboard(png: bytes) -> None:
    data = QMimeData()
    data.setImageData(QImage.fromData(png))
    data.setData("image/png", QByteArray(png))
    QGuiApplication.clipboard().setMimeData(data)
