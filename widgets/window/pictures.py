"""Export what the panes show: into a file, or to the clipboard."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import QByteArray, QMimeData, QObject, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import QGuiApplication, QImage, QOpenGLContext, QPainter, QPixmap
from PySide6.QtWidgets import QMainWindow

from app.document.codec import picture_json
from app.document.document import Document
from app.model.refusal import QT_TRANSLATE_NOOP, Cancelled, Refusal
from app.scenes.scene import Scene
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import sentence, translated
from widgets.parts.progress import ReportProgress, progress
from widgets.parts.saving import ask_where
from widgets.window.settings import Settings

if TYPE_CHECKING:
    from app.drawings.off_screen import Pixels
    from widgets.window.export_dialog import ExportChoice


MOST_IN_PREVIEW = 200_000
"""Triangles and points of a scene that is drawn anew for each change of the dialog."""
NO_PREVIEW = QT_TRANSLATE_NOOP("Refusal", "There is no preview of {0} triangles and points.")


def image_of(pixels: Pixels) -> QImage:
    """Convert a drawn picture to Qt's image."""
    height, width, _ = pixels.shape
    form = QImage.Format.Format_RGB888
    return QImage(pixels.tobytes(), width, height, 3 * width, form).copy()


class Pictures(QObject):
    """Exports and copies pictures for one window.

    Every PNG contains the document that it shows. The message bar reports failures.

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
    settings : Settings
        Keeps the last choice.
    """

    exported = Signal(str)
    """A sentence about what was exported or copied."""

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

    def export_dialog(self) -> None:
        """Ask what to export and where, and export it."""
        from widgets.window.export_dialog import ExportDialog

        size = self._seen().projection.image_size
        kept = self._settings.export
        dialog = ExportDialog(self._titles, size, self._window, self.preview, kept)
        accepted = dialog.exec()
        dialog.deleteLater()
        if not accepted:
            return
        self._settings.export = dialog.kept
        choice = dialog.choice()
        path = self._where(self.tr("Export a picture"), choice.ending)
        if path is not None:
            self.export(path, choice)

    def _where(self, title: str, ending: str = "png") -> Path | None:
        """Ask for a file; None if the user cancels."""
        kinds = self.tr("{0} pictures (*.{1})").format(ending.upper(), ending)
        path = ask_where(self._window, title, f"frustum-lab.{ending}", kinds, f".{ending}")
        return Path(path) if path else None

    def export(self, path: Path, choice: ExportChoice) -> bool:
        """Write a picture; return False if that fails or the user cancels it."""
        if choice.ending == "png":
            return self._write(
                path, lambda document: self._draw(document, choice), choice.scale, choice.panes
            )
        from app.drawings.describing import describe
        from app.drawings.figures import write_shapes

        document = self._seen()

        def write() -> None:
            options = self._options(document, choice)
            scene = self._scene(document.scene, document.mesh)
            about = describe(document, scene, choice.panes, translated)
            with progress(self._window, self.tr("Drawing the picture")) as tell:
                write_shapes(
                    str(path), scene, document.projection, about, hidden=choice.hidden,
                    progress=tell, **options,
                )  # fmt: skip

        return self._try(write, self.tr("Exported {0}").format(path))

    def preview(self, choice: ExportChoice, room: QSize, tell: ReportProgress) -> QPixmap:
        """Draw a choice with as few pixels as a preview has."""
        from PySide6.QtSvg import QSvgRenderer

        from app.document.lengths import Size
        from app.drawings.figures import render, shapes
        from app.drawings.svg import svg

        document = self._seen()
        scene = self._scene(document.scene, document.mesh)
        drawn = scene.triangles + scene.dot_count
        if drawn > MOST_IN_PREVIEW:
            raise Refusal.saying(NO_PREVIEW, drawn)
        options = self._options(document, choice) | {"transparent": False, "progress": tell}
        if choice.hidden != "none":
            size, outlines = shapes(scene, document.projection, hidden=choice.hidden, **options)
            picture = QImage(room, QImage.Format.Format_RGB32)
            picture = picture.scaled(
                QSizeF(*size).scaled(room, Qt.AspectRatioMode.KeepAspectRatio).toSize()
            )
            picture.fill(Qt.GlobalColor.white)
            painter = QPainter(picture)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            QSvgRenderer(QByteArray(svg(outlines, size, scene.title))).render(painter)
            painter.end()
            return QPixmap.fromImage(picture)
        width, height = Size(*choice.size).px
        scale = min(1.0, room.width() / width, room.height() / height)
        pixels = render(scene, document.projection, scale=scale, **options)
        return QPixmap.fromImage(image_of(pixels))

    def _write(
        self,
        path: Path,
        draw: Callable[[Document], Pixels],
        scale: float = 1.0,
        panes: Sequence[str] = (),
    ) -> bool:
        from app.drawings.describing import describe
        from app.drawings.figures import write_png

        document = self._seen()

        def write() -> None:
            pixels, about = draw(document), None
            if panes:
                scene = self._scene(document.scene, document.mesh)
                about = describe(document, scene, panes, translated)
            write_png(path, pixels, picture_json(document), scale, about)

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
            self._messages.show_message(sentence(error))
            return False
        self._messages.done()
        self.exported.emit(done)
        return True

    def _draw(self, document: Document, choice: ExportChoice) -> Pixels:
        from app.drawings.figures import render

        options = self._options(document, choice)
        scene = self._scene(document.scene, document.mesh)
        with progress(self._window, self.tr("Drawing the picture")) as tell:
            return render(scene, document.projection, scale=choice.scale, progress=tell, **options)

    def _options(self, document: Document, choice: ExportChoice) -> dict[str, Any]:
        """Return the options that all formats share; call it just before drawing."""
        from app.drawings.style import PALETTES

        current = QOpenGLContext.currentContext()
        if current is not None:  # otherwise VTK may use Qt's context as its own
            current.doneCurrent()
        return {
            "view": document.view, "settings": document.settings, "quality": document.quality,
            "panes": choice.panes, "size": choice.size, "transparent": choice.transparent,
            "text_pt": choice.text_pt, "column": choice.column, "crop": choice.crop,
            "style": PALETTES[choice.palette], "words": self._words,
        }  # fmt: skip


def _pixels(image: QImage) -> Pixels:
    image = image.convertToFormat(QImage.Format.Format_RGBA8888)
    size = image.height(), image.width(), 4
    return np.frombuffer(image.constBits(), np.uint8).reshape(size).copy()


def _to_clipboard(png: bytes) -> None:
    data = QMimeData()
    data.setImageData(QImage.fromData(png))
    data.setData("image/png", QByteArray(png))
    QGuiApplication.clipboard().setMimeData(data)
