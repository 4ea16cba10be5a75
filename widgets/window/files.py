"""Open and save scenes and documents, without losing unsaved work."""

import os
from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

from PySide6 import QtWidgets
from PySide6.QtCore import QObject, Signal

from app.document.document import MESH_ENDINGS, Document, is_mesh
from app.document.files import holds_document, read, write
from app.document.store import Store
from app.document.view import EVERYTHING, without_scene
from app.lessons.lesson import is_lesson
from app.model.refusal import Cancelled, Refusal
from app.scenes.scene import BUILT_IN, Scene, load
from widgets.parts.layouts import dialog_buttons, in_column
from widgets.parts.messages import MessageBar, sentence
from widgets.parts.panel import Changed, ShownData
from widgets.parts.plain import PlainLabel, message_box
from widgets.parts.progress import ReportProgress, progress
from widgets.parts.saving import ask_where
from widgets.window.settings import Settings

_T = TypeVar("_T")
MESHES = " ".join(f"*{ending}" for ending in MESH_ENDINGS)
CAMERAS = "*.yml *.yaml *.xml cameras.txt images.txt"
RECENT_LIMIT = 10
MESSAGE_MS = 10_000  # duration of the message about unsaved work in the status line


class Files(QObject):
    """Opens, saves and remembers files for one window.

    If a file cannot be opened or saved, the message bar says why in one sentence, and the window
    does not change.
    """

    concerns = frozenset({"scene", "view"})
    recent_changed = Signal()
    lesson_wanted = Signal(str)  # the user has opened the file of a lesson or talk

    def __init__(
        self, window: QtWidgets.QMainWindow, store: Store, messages: MessageBar, settings: Settings
    ) -> None:
        super().__init__(window)
        self._window, self._store, self._messages = window, store, messages
        self._scenes: dict[tuple[str, str], Scene] = {}
        self._settings = settings
        self.recent = settings.recent[:RECENT_LIMIT]

    @property
    def path(self) -> Path | None:
        """The document's file; None if it was never saved."""
        return self._store.origin.path

    # -- scenes

    def scene(self, name: str, mesh: str = "") -> Scene:
        """Return the scene of a name or mesh path, with `mesh` in place of its objects.

        It is loaded once, or a `Refusal` says why not. All scenes of the undo history stay in
        memory, so that undo does not depend on a file that may have been removed.
        """
        if (name, mesh) not in self._scenes:
            self._scenes[name, mesh] = self._load(name, mesh)
        return self._scenes[name, mesh]

    def keep(self, document: Document, scene: Scene) -> None:
        """Keep the scene of a document, already loaded, and say what of its mesh is left out."""
        self._scenes[document.scene, document.mesh] = scene
        if scene.notes:
            self._messages.show_message(" ".join(map(sentence, scene.notes)))

    def _load(self, name: str, mesh: str) -> Scene:
        file = mesh or name
        if not is_mesh(file):
            return load(name, mesh=mesh)
        with self.progress(self.tr("Opening {0}").format(os.path.basename(file))) as tell:
            return load(name, tell, mesh)

    def progress(self, text: str) -> AbstractContextManager[ReportProgress]:
        """Show the progress of work over this window."""
        return progress(self._window, text)

    # -- opening

    def open_dialog(self) -> None:
        title = self.tr("Open a document, a lesson, a mesh, a camera or an exported picture")
        kinds = self.tr("All supported files ({0});;All files (*)")
        folder = str(self.path.parent) if self.path else ""
        path = self._ask(title, folder, kinds.format(f"*.json {MESHES} {CAMERAS} *.png *.md"))
        if path:
            self.open(path)

    def open(self, path: str | Path) -> bool:
        """Open a document, a picture that contains one, a mesh or a camera; return False if not.

        It asks only for the view of a camera file, whose camera is then over the current scene:
        undo restores the previous document, even unsaved.
        """
        path = os.path.abspath(path)
        if is_lesson(path):
            self.lesson_wanted.emit(path)
            return True

        def opened() -> tuple[Document, Scene, Path | None]:
            if is_mesh(path):
                scene = self._load(path, "")
                return Document(path, scene.start), scene, None
            document = self._with_mesh(read(path, self._store.seen, self._ask_for_view), path)
            return document, self._load(document.scene, document.mesh), self._place(path)

        opened_file = self._try(opened, "" if is_mesh(path) else path)
        if opened_file is None:
            return False
        document, scene, place = opened_file
        self.keep(document, scene)
        if not self._change_to(document, place):
            return False
        self._remember(path)
        return True

    def _ask_for_view(self, names: list[str]) -> str:
        dialog, views = QtWidgets.QDialog(self._window), QtWidgets.QListWidget()
        dialog.setWindowTitle(self.tr("Open a camera"))
        views.addItems(names)
        views.setCurrentRow(0)
        views.itemActivated.connect(dialog.accept)
        asked = PlainLabel(self.tr("The file has {0} views:").format(len(names)))
        asked.setBuddy(views)
        buttons = dialog_buttons(dialog, QtWidgets.QDialogButtonBox.StandardButton.Ok)
        in_column(asked, views, buttons, on=dialog)
        if not dialog.exec():
            raise Cancelled
        return views.currentItem().text()

    def open_step(self, document: Document, scene: Scene, lesson: Path | None) -> bool:
        """Show the first state of a lesson; the student's changes to it are not unsaved work."""
        self.keep(document, scene)
        if not self._change_to(document, None, is_work=False):
            return False
        if lesson is not None:
            self._remember(str(lesson))
        return True

    def _change_to(
        self, document: Document, path: Path | None, *, saved: bool = True, is_work: bool = True
    ) -> bool:
        """Show another document, and say where the unsaved work of the previous one is."""
        left = self._name if self._store.modified else None
        changed = self._store.open(document, saved=saved, path=path, is_work=is_work)
        held = {(each.scene, each.mesh) for each in self._store.documents}
        self._scenes = {names: scene for names, scene in self._scenes.items() if names in held}
        if not changed:
            return False
        self._set_path(path)
        if left is not None:
            text = self.tr("Undo brings back the unsaved changes to {0}.")
            if not self._store.can_undo:  # in a lesson
                text = self.tr("Close the lesson, and Undo brings back the unsaved changes to {0}.")
            self._window.statusBar().showMessage(text.format(left), MESSAGE_MS)
        return True

    def _with_mesh(self, document: Document, path: str) -> Document:
        """Return a picture's document with its mesh: from beside it, or where the user says."""
        mesh = document.scene if is_mesh(document.scene) else document.mesh
        if not mesh or holds_document(path) or os.path.exists(mesh):
            return document
        title = self.tr("Where is the mesh {0} of this picture?").format(os.path.basename(mesh))
        place = self._ask_for_mesh(title, mesh)
        if not place:
            return document
        place = os.path.abspath(place)
        if is_mesh(document.scene):
            return replace(document, scene=place)
        return replace(document, mesh=place)

    def _ask_for_mesh(self, title: str, beside: str) -> str:
        kinds = self.tr("Meshes ({0});;All files (*)").format(MESHES)
        return self._ask(title, os.path.dirname(beside), kinds)

    def _ask(self, title: str, folder: str, kinds: str) -> str:
        return QtWidgets.QFileDialog.getOpenFileName(self._window, title, folder, kinds)[0]

    def note_opened(self, path: Path) -> None:
        self._set_path(self._place(path))
        self._remember(str(path))

    def open_recovered(self, document: Document) -> bool:
        """Open a document from an autosave, as unsaved work."""
        scene = self._try(lambda: self.scene(document.scene, document.mesh))
        return scene is not None and self._change_to(document, None, saved=False)

    def choose_scene(self, name: str) -> bool:
        """Change to a built-in scene, as one undo step."""
        document = self._try(lambda: self.begun(name))
        if document is None:
            return False
        return name == self._store.document.scene or self._store.set_document(document)

    def begun(self, name: str) -> Document:
        """Return a built-in scene as it starts, in the present view; a `Refusal` if it cannot."""
        look = self._store.look()
        names = look.names if look.names == EVERYTHING else None
        view = replace(without_scene(look), panes={}, fixed=None, names=names)
        return Document(name, self.scene(name).start, self._store.document.extra, view)

    def mesh_dialog(self) -> None:
        """Ask for a mesh that replaces the scene's own objects."""
        title = self.tr("Use a mesh in place of the scene's own objects")
        path = self._ask_for_mesh(title, self._store.document.mesh)
        if path:
            self.use_mesh(path)

    def use_mesh(self, path: str) -> bool:
        """Replace the scene's own objects with a mesh, or restore them if the path is empty.

        That is one undo step. The file is read anew, also for the steps of the history that use
        it. Returns False if the mesh cannot be shown there.
        """
        before, mesh = self._store.document, os.path.abspath(path) if path else ""

        def used() -> tuple[Document, Scene]:
            scene = self._load(before.scene, mesh)  # more specific refusal than the document's
            return replace(before, mesh=mesh), scene

        used_mesh = self._try(used)
        if used_mesh is None:
            return False
        document, scene = used_mesh
        self.keep(document, scene)
        if document == before:
            return self._store.show_again()
        return self._store.set_document(document)

    # -- saving

    def save(self) -> bool:
        """Save to the document's file, or ask: for a new file, or if another program wrote it."""
        if self.path is None:
            return self.save_as()
        if (now := _written(self.path)) is None or now == self._store.origin.written:
            return self.save_to(self.path)
        text = self.tr("{0} has been changed elsewhere since it was opened or saved here.")
        box = message_box(self._window, text.format(self.path.name), self.tr("Save over it?"))
        over = box.addButton(
            self.tr("Save &over it"), QtWidgets.QMessageBox.ButtonRole.DestructiveRole
        )
        beside = box.addButton(self.tr("Save &as…"), QtWidgets.QMessageBox.ButtonRole.AcceptRole)
        box.addButton(QtWidgets.QMessageBox.StandardButton.Cancel)
        box.setDefaultButton(beside)
        box.exec()
        if box.clickedButton() is over:
            return self.save_to(self.path)
        return box.clickedButton() is beside and self.save_as()

    def save_as(self) -> bool:
        title, kinds = self.tr("Save the document"), self.tr("Frustum Lab documents (*.json)")
        start = str(self.path or "frustum-lab.json")
        path = ask_where(self._window, title, start, kinds, ".json")
        return bool(path) and self.save_to(Path(path))

    def save_to(self, path: Path) -> bool:
        """Save to a path; if that fails, the old file stays as it is."""
        document = self._store.seen

        def written() -> bool:
            write(document, path)
            return True

        if not self._try(written):
            return False
        self._store.mark_saved()
        self._set_path(path)
        self._remember(str(path))
        return True

    def may_discard(self) -> bool:
        """Ask what to do with unsaved work; return True if the window may close."""
        if not self._store.modified:
            return True
        text = self.tr("There are unsaved changes.")
        box = message_box(self._window, text, self.tr("Save them first?"))
        buttons = QtWidgets.QMessageBox.StandardButton
        box.setStandardButtons(buttons.Save | buttons.Discard | buttons.Cancel)
        box.setDefaultButton(buttons.Save)
        answer = box.exec()
        return self.save() if answer == buttons.Save else answer == buttons.Discard

    # -- helpers

    def _try(self, act: Callable[[], _T], document: str = "") -> _T | None:
        """Call `act`, or say in one sentence why it failed; `document` names the file read."""
        try:
            done = act()
        except Cancelled:
            return None
        except Refusal as error:
            of_scene = document and error.file is None
            text = sentence(error)
            self._messages.show_message(f"{document}: {text}" if of_scene else text)
            return None
        self._messages.done()
        return done

    @staticmethod
    def _place(path: str | Path) -> Path | None:
        """Return the file to save to, which cannot be a picture or a mesh."""
        return Path(path) if holds_document(path) else None

    def _set_path(self, path: Path | None) -> None:
        self._store.origin.path = path
        self._store.origin.written = _written(path) if path else None
        self._name_window()

    def take(self, shown: ShownData, changed: Changed) -> None:
        self._name_window()

    def _name_window(self) -> None:
        name = self._name.replace("[*]", "[*][*]")  # Qt shows this as one [*]
        self._window.setWindowTitle(f"{name}[*] – Frustum Lab")

    @property
    def _name(self) -> str:
        if self.path:
            return self.path.name
        scene = self._store.document.scene
        return self.tr("Untitled") if scene in BUILT_IN else Path(scene).name

    def _remember(self, path: str) -> None:
        path = os.path.abspath(path)
        self.recent = [path, *(old for old in self._settings.recent if old != path)][:RECENT_LIMIT]
        self._settings.recent = self.recent
        self.recent_changed.emit()


def _written(path: Path) -> tuple[int, int] | None:
    """Return a file's time of writing in ns and its size in bytes; None if it does not exist."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size
