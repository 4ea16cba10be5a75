"""The File menu's work: scenes and documents in and out, nothing lost on the way."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QMainWindow, QMessageBox

from app.document.document import MESH_ENDINGS, Document, is_mesh
from app.document.files import holds_document, read, write
from app.document.store import Store
from app.lessons.lesson import is_lesson
from app.model.refusal import Cancelled, Refusal
from app.scenes.scene import BUILT_IN, Scene, load
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import sentence
from widgets.parts.panel import Changed, Shown
from widgets.parts.plain import message_box
from widgets.parts.progress import progress
from widgets.parts.saving import ask_where
from widgets.window.settings import Settings

_T = TypeVar("_T")
RECENT_LIMIT = 10
SAID_MS = 10_000
"""How long the status line says where unsaved work is."""


class Files(QObject):
    """Opens, saves and remembers files for one window.

    Whatever cannot be opened or saved is told in the message bar, in one sentence, and the
    window stays as it was.

    Parameters
    ----------
    window : QMainWindow
        Parent of the dialogs.
    store : Store
    messages : MessageBar
    settings : Settings
        Keeps the paths opened or saved before, newest first, also those of other windows.
    """

    concerns = frozenset({"scene", "view"})
    recent_changed = Signal()
    lesson_wanted = Signal(str)
    """The file of a lesson or talk was opened."""

    def __init__(
        self, window: QMainWindow, store: Store, messages: MessageBar, settings: Settings
    ) -> None:
        super().__init__(window)
        self._window, self._store, self._messages = window, store, messages
        self._scenes: dict[tuple[str, str], Scene] = {}
        self._settings = settings
        self.recent = settings.recent[:RECENT_LIMIT]

    @property
    def path(self) -> Path | None:
        """Where the document is saved, if there is such a place yet."""
        return self._store.origin.path

    # -- scenes

    def scene(self, name: str, mesh: str = "") -> Scene:
        """The scene of that name or mesh path, with a mesh in its objects' place, loaded once.

        All scenes that the undo history can come back to stay in memory, so that undo cannot
        fail on a file that has gone meanwhile.

        Raises
        ------
        Refusal
            If it cannot be loaded; `Cancelled` if the user stopped it.
        """
        if (name, mesh) not in self._scenes:
            self._scenes[name, mesh] = self._load(name, mesh)
        return self._scenes[name, mesh]

    def keep(self, document: Document, scene: Scene) -> None:
        """Take a document's scene that is loaded already."""
        self._scenes[document.scene, document.mesh] = scene

    def _load(self, name: str, mesh: str) -> Scene:
        file = mesh or name
        if not is_mesh(file):
            return load(name, mesh=mesh)
        text = self.tr("Opening {0}").format(os.path.basename(file))
        with progress(self._window, text) as tell:
            return load(name, tell, mesh)

    # -- opening

    def open_dialog(self) -> None:
        """Ask for a file and open it."""
        meshes = " ".join(f"*{ending}" for ending in MESH_ENDINGS)
        path, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Open a document, a lesson, a mesh or an exported picture"),
            str(self.path.parent) if self.path else "",
            self.tr("All that can be opened ({0});;All files (*)").format(
                f"*.json {meshes} *.png *.md"
            ),
        )
        if path:
            self.open(path)

    def open(self, path: str | Path) -> bool:
        """Open a document, a picture with a document inside, or a mesh, as its file is now.

        Nothing is asked: undo brings back what was there before, saved or not.

        Returns
        -------
        bool
            False if it could not be opened.
        """
        path = os.path.abspath(path)
        if is_lesson(path):
            self.lesson_wanted.emit(path)
            return True

        def opened() -> tuple[Document, Scene, Path | None]:
            if is_mesh(path):
                scene = self._load(path, "")
                return Document(path, scene.start), scene, None
            document = self._with_mesh(read(path), path)
            return document, self._load(document.scene, document.mesh), self._place(path)

        found = self._try(opened, "" if is_mesh(path) else path)
        if found is None:
            return False
        document, scene, place = found
        self.keep(document, scene)
        if not self._change_to(document, place):
            return False
        self._remember(path)
        return True

    def open_step(self, document: Document, scene: Scene, lesson: Path) -> bool:
        """Show the first state of a lesson; what is tried out beside it is no work to be saved."""
        self.keep(document, scene)
        if not self._change_to(document, None, is_work=False):
            return False
        self._remember(str(lesson))
        return True

    def _change_to(
        self, document: Document, path: Path | None, *, saved: bool = True, is_work: bool = True
    ) -> bool:
        """Show another document, and say where unsaved work is that it takes the place of."""
        left = self._name if self._store.modified else None
        changed = self._store.open(document, saved=saved, path=path, is_work=is_work)
        held = {(each.scene, each.mesh) for each in self._store.documents}
        self._scenes = {names: scene for names, scene in self._scenes.items() if names in held}
        if not changed:
            return False
        self._set_path(path)
        if left is not None:
            text = self.tr("Undo brings back the unsaved changes to {0}.")
            self._window.statusBar().showMessage(text.format(left), SAID_MS)
        return True

    def _with_mesh(self, document: Document, path: str) -> Document:
        """A picture's document, with the mesh from beside it, or else from where the user says."""
        mesh = document.scene if is_mesh(document.scene) else document.mesh
        if not mesh or holds_document(path) or os.path.exists(mesh):
            return document
        place = self._ask_for_mesh(
            self.tr("Where is {0}, which the picture shows?").format(os.path.basename(mesh)),
            os.path.dirname(mesh),
        )
        if not place:
            return document
        place = os.path.abspath(place)
        if is_mesh(document.scene):
            return replace(document, scene=place)
        return replace(document, mesh=place)

    def _ask_for_mesh(self, title: str, folder: str) -> str:
        endings = " ".join(f"*{ending}" for ending in MESH_ENDINGS)
        kinds = self.tr("Meshes ({0});;All files (*)").format(endings)
        path, _ = QFileDialog.getOpenFileName(self._window, title, folder, kinds)
        return path

    def take_up(self, path: Path) -> None:
        """Note that what is shown was opened from a file."""
        self._set_path(self._place(path))
        self._remember(str(path))

    def open_recovered(self, document: Document) -> bool:
        """Take up a document from an autosave; it is in no file of the user's yet."""
        scene = self._try(lambda: self.scene(document.scene, document.mesh))
        if scene is None:
            return False
        return self._change_to(document, None, saved=False)

    def choose_scene(self, name: str) -> bool:
        """Change to a built-in scene as an edit that can be undone."""
        scene = self._try(lambda: self.scene(name))
        if scene is None:
            return False
        if name != self._store.document.scene:
            # What was prepared for a class stays, and what was about the scene before goes.
            view = replace(
                self._store.look(), large="", panel=None, probes=(), pinned=frozenset(), panes={},
                compare=(), dividers=(),
            )  # fmt: skip
            extra = self._store.document.extra
            return self._store.set_document(Document(name, scene.start, extra, view))
        return True

    def mesh_dialog(self) -> None:
        """Ask for a mesh to stand in the place of the scene's own objects."""
        path = self._ask_for_mesh(
            self.tr("Use a mesh in the place of the scene's own objects"),
            os.path.dirname(self._store.document.mesh),
        )
        if path:
            self.use_mesh(path)

    def use_mesh(self, path: str) -> bool:
        """Put a mesh in the place of the scene's own objects, as an edit that can be undone.

        The file is read as it is now, also for the steps of the history that use it.

        Parameters
        ----------
        path : str
            Empty for the scene's own objects.

        Returns
        -------
        bool
            False if it cannot be shown there.
        """

        before, mesh = self._store.document, os.path.abspath(path) if path else ""

        def used() -> tuple[Document, Scene]:
            scene = self._load(before.scene, mesh)  # says more of a file than the document would
            return replace(before, mesh=mesh), scene

        found = self._try(used)
        if found is None:
            return False
        document, scene = found
        self.keep(document, scene)
        if document == before:
            return self._store.show_again()
        return self._store.set_document(document)

    # -- saving

    def save(self) -> bool:
        """Save where the document came from, or ask; also where another program wrote there."""
        if self.path is None:
            return self.save_as()
        if (now := _written(self.path)) is None or now == self._store.origin.written:
            return self.save_to(self.path)
        text = self.tr("{0} has been changed elsewhere since it was opened or saved here.")
        box = message_box(self._window, text.format(self.path.name), self.tr("Save over it?"))
        over = box.addButton(self.tr("Save &over it"), QMessageBox.ButtonRole.DestructiveRole)
        beside = box.addButton(self.tr("Save &as…"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(QMessageBox.StandardButton.Cancel)
        box.setDefaultButton(beside)
        box.exec()
        if box.clickedButton() is over:
            return self.save_to(self.path)
        return box.clickedButton() is beside and self.save_as()

    def save_as(self) -> bool:
        """Ask for a place and save there."""
        path = ask_where(
            self._window,
            self.tr("Save the document"),
            str(self.path or "frustum-lab.json"),
            self.tr("Frustum Lab documents (*.json)"),
            ".json",
        )
        return bool(path) and self.save_to(Path(path))

    def save_to(self, path: Path) -> bool:
        """Save to a path; the old file stays whole if that fails."""
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
        """Ask what shall become of unsaved work; True if the window may go on without it."""
        if not self._store.modified:
            return True
        text = self.tr("There are changes that are not saved.")
        box = message_box(self._window, text, self.tr("Save them first?"))
        buttons = QMessageBox.StandardButton
        box.setStandardButtons(buttons.Save | buttons.Discard | buttons.Cancel)
        box.setDefaultButton(buttons.Save)
        answer = box.exec()
        if answer == buttons.Save:
            return self.save()
        return answer == buttons.Discard

    # -- helpers

    def _try(self, act: Callable[[], _T], document: str = "") -> _T | None:
        """Do it, or say in one sentence why not.

        Parameters
        ----------
        act : callable
        document : str
            The file that asks for a scene, to be named beside it.
        """
        try:
            done = act()
        except Cancelled:
            return None
        except Refusal as error:
            of_scene = document and error.file is None
            self._messages.say(f"{document}: {sentence(error)}" if of_scene else sentence(error))
            return None
        self._messages.done()
        return done

    @staticmethod
    def _place(path: str | Path) -> Path | None:
        """Where what was opened is saved: a picture or a mesh is no place for a document."""
        return Path(path) if holds_document(path) else None

    def _set_path(self, path: Path | None) -> None:
        self._store.origin.path = path
        self._store.origin.written = _written(path) if path else None
        self._name_window()

    def take(self, shown: Shown, changed: Changed) -> None:
        """Name the window after another document."""
        self._name_window()

    def _name_window(self) -> None:
        name = self._name.replace("[*]", "[*][*]")  # which Qt writes as one
        self._window.setWindowTitle(f"{name}[*] – Frustum Lab")

    @property
    def _name(self) -> str:
        """What the document is called."""
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
    """When a file was last written, in ns, and how many bytes it has; None if it is not there."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size
