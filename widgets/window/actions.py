"""What can be done: menus, tool bar and shortcuts.

::

    Actions --scene_chosen, undo.triggered, ...--> window
    window  --show_scene, show_recent, show_playing--> Actions
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QObject, QSize, Qt, Signal, SignalInstance
from PySide6.QtGui import QAction, QActionGroup, QFontInfo, QKeySequence
from PySide6.QtWidgets import (
    QLineEdit,
    QMainWindow,
    QMenu,
    QSizePolicy,
    QToolBar,
    QToolButton,
    QWidget,
)

from app.document.view import LAYOUTS
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import BUILT_IN
from widgets.panes.pane import Pane
from widgets.parts.combo import Combo
from widgets.parts.icons import show_icon
from widgets.parts.messages import file_title, of_phenomena
from widgets.parts.plain import Label, set_tip
from widgets.window.files import Files
from widgets.window.help import FULL_SCREEN_KEY, PLAY_KEY, Help
from widgets.window.lesson_menu import LessonMenu
from widgets.window.pictures import Pictures
from widgets.window.slots import Slots

ICON_PX = 18


def take_typed(window: QMainWindow) -> None:
    """Enter what is typed, as leaving its field would."""
    field = window.focusWidget()
    if isinstance(field, QLineEdit) and field.isModified():
        field.clearFocus()
        if not window.isActiveWindow():  # whose field has no keyboard to lose
            field.editingFinished.emit()


class Actions(QObject):
    """The actions of one window, in its menus and its tool bar.

    Those that a part of the window carries out alone are wired to it here; of the others the window
    is told by their `triggered`, or by a signal where there is something to be said.

    Parameters
    ----------
    window : QMainWindow
        Gets the menus and the tool bar.
    files, pictures, help_, slots
        The parts of the window that carry out what is asked for.
    panes : mapping of str to Pane
    theme : str
    all_digits : bool
        How the window looks at first.
    """

    scene_chosen = Signal(str)
    theme_chosen = Signal(str)
    controls_shown = Signal(bool)
    cost_shown = Signal(bool)
    all_digits_set = Signal(bool)

    def __init__(
        self,
        window: QMainWindow,
        *,
        files: Files,
        pictures: Pictures,
        help_: Help,
        slots: Slots,
        panes: Mapping[str, Pane],
        theme: str,
        all_digits: bool,
    ) -> None:
        super().__init__(window)
        self._window, self._files, self._help = window, files, help_
        self._slots, self._panes = slots, panes
        self.scene_titles = {
            "letter-f": self.tr("Letter F"),
            "cube": self.tr("Unit cube"),
            "posts": self.tr("Row of posts"),
            **{each.name: of_phenomena(each.title) for each in PHENOMENA.values()},
        }
        keys = QKeySequence.StandardKey
        self.open = self._action(
            self.tr("&Open…"), self._with_typed(files.open_dialog), keys.Open,
            self.tr("Open a document, a lesson, a mesh or an exported picture"),
        )  # fmt: skip
        self.save = self._action(self.tr("&Save"), self._with_typed(files.save), keys.Save)
        self._save_as = self._action(
            self.tr("Save &as…"), self._with_typed(files.save_as), "Ctrl+Shift+S"
        )
        self.copy = self._action(
            self.tr("&Copy picture"), self._with_typed(pictures.copy), "Ctrl+Shift+C",
            self.tr("Copy the three panes to the clipboard, with the document inside"),
        )  # fmt: skip
        self.export = self._action(
            self.tr("&Export picture…"), self._with_typed(pictures.export_dialog), "Ctrl+E",
            self.tr("Export panes as a PNG picture that carries the document"),
        )  # fmt: skip
        self._make_file_menu()
        self.undo = self._action(self.tr("&Undo"), None, keys.Undo)
        self.redo = self._action(self.tr("&Redo"), None, keys.Redo)
        self.reset = self._action(
            self.tr("Reset &all"), None, "Ctrl+R",
            self.tr("Put camera, lens, image and settings back to how the scene opens"),
        )  # fmt: skip
        self.remove_probe = self._action(
            self.tr("Remove the &probe"), None, "Esc",
            self.tr("Remove the chosen probe from the panes"),
        )  # fmt: skip
        self.find = self._action(
            self.tr("&Find a control"), None, keys.Find,
            self.tr("Find a control by its name, its letter or what it does"),
        )  # fmt: skip
        self.find.setShortcuts([*QKeySequence.keyBindings(keys.Find), QKeySequence("/")])
        self._make_edit_menu()
        self.scene_group = QActionGroup(window)
        self._make_scenes_menu()
        self.lesson_menu = LessonMenu(self.tr("&Lessons"), window, self._action)
        window.menuBar().addMenu(self.lesson_menu)
        self.present = self._action(
            self.tr("&Present"), None, "F5",
            self.tr("Fill the screen with the panes and the controls that matter, for a class"),
        )  # fmt: skip
        self.blank = self._action(
            self.tr("&Blank the screen"), None, "B", self.tr("Let the class see nothing, and back")
        )
        self.pointer = self._action(
            self.tr("P&ointer in all panes"), None, "P",
            self.tr("Mark in all panes what the mouse is over, while presenting"), on=False,
        )  # fmt: skip
        self.compare = self._action(
            self.tr("Co&mpare with this picture"), None, "F6",
            self.tr("Hold the picture as it is and compare it with what comes; again, end that"),
            on=False,
        )  # fmt: skip
        self.compare_way = self._action(
            self.tr("Compared s&ide by side, or over each other"), None, "Shift+F6"
        )
        for later in (self.remove_probe, self.blank, self.pointer, self.compare_way):
            later.setEnabled(False)
        self.show_cost = self._toggle(
            self.tr("&Show cost"), self.cost_shown, False, None,
            self.tr("Measure what every step takes: the model, each pane's matrices and repaint"),
        )  # fmt: skip
        self.all_digits = self._toggle(
            self.tr("All &digits"), self.all_digits_set, all_digits, None,
            self.tr("Show all digits of every number that is read, not four"),
        )  # fmt: skip
        self._make_view_menu(theme)
        self.help = self._action(self.tr("&Keys and mouse"), help_.show_keys, keys.HelpContents)
        self._make_help_menu()
        self.play = self._action(
            self.tr("Play"), None, PLAY_KEY, self.tr("Play or pause the camera's orbit")
        )
        self.scene_box = Combo()
        self._make_tool_bar()
        keyed = [a for a in window.findChildren(QAction) if not a.shortcut().isEmpty()]
        # A hidden menu bar has no shortcuts, and a pane takes them into a window of its own.
        for widget in (window, *panes.values()):
            widget.addActions(keyed)

    # -- making

    def _action(
        self,
        text: str,
        act: Callable[[], object] | None = None,
        shortcut: str | QKeySequence.StandardKey | None = None,
        tip: str = "",
        on: bool | None = None,
    ) -> QAction:
        """Make an action; one that can be checked, if it says whether it is."""
        action = QAction(text, self._window, checkable=on is not None, checked=on is True)
        if act is not None:
            action.triggered.connect(lambda _checked=False: act())
        if shortcut is not None:
            action.setShortcut(QKeySequence(shortcut))
        plain = (tip or text).replace("&", "").rstrip("…")
        keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        set_tip(action, f"{plain} ({keys})" if keys else plain)
        return action

    def _toggle(
        self, text: str, told: SignalInstance, on: bool, shortcut: str | None = None, tip: str = ""
    ) -> QAction:
        action = self._action(text, lambda: told.emit(action.isChecked()), shortcut, tip, on)
        return action

    def _choices(self, menu: QMenu, texts: Mapping[str, str], now: str) -> dict[str, QAction]:
        """Add actions of which one is checked, by what they stand for."""
        group = QActionGroup(menu)
        made = {name: self._action(text, on=name == now) for name, text in texts.items()}
        for action in made.values():
            group.addAction(action)
            menu.addAction(action)
        return made

    def _with_typed(self, act: Callable[[], object]) -> Callable[[], object]:
        """An act on the document with what is typed and not yet entered."""

        def acted() -> None:
            take_typed(self._window)
            act()

        return acted

    def _make_file_menu(self) -> None:
        menu = self._window.menuBar().addMenu(self.tr("&File"))
        menu.addAction(self.open)
        self.recent = menu.addMenu(self.tr("Open &recent"))
        menu.addSeparator()
        menu.addActions([self.save, self._save_as])
        menu.addSeparator()
        menu.addActions([self.export, self.copy])
        menu.addSeparator()
        menu.addAction(
            self._action(self.tr("&Quit"), self._window.close, QKeySequence.StandardKey.Quit)
        )

    def _make_edit_menu(self) -> None:
        menu = self._window.menuBar().addMenu(self.tr("&Edit"))
        menu.addActions([self.undo, self.redo])
        menu.addSeparator()
        menu.addAction(self.reset)
        menu.addSeparator()
        menu.addActions([self.remove_probe, self.find])

    def _make_scenes_menu(self) -> None:
        menu = self._window.menuBar().addMenu(self.tr("&Scenes"))
        for name in BUILT_IN:
            if name == next(iter(PHENOMENA)):
                menu.addSeparator()
            act = partial(self.scene_chosen.emit, name)
            action = self._action(self.scene_titles[name], act, on=False)
            action.setData(name)
            self.scene_group.addAction(action)
            menu.addAction(action)
        menu.addSeparator()
        menu.addAction(self._action(self.tr("Open a &mesh…"), self._files.open_dialog))

    def _make_view_menu(self, theme: str) -> None:
        menu = self._window.menuBar().addMenu(self.tr("&View"))
        slots = self._slots
        menu.addActions([self.present, self.blank, self.pointer])
        menu.addSeparator()
        menu.addActions([self.compare, self.compare_way])
        menu.addSeparator()
        for number, (name, pane) in enumerate(self._panes.items(), start=1):
            text = self.tr("{0} in large").format(pane.name)
            tip = self.tr("Into the large slot; again, as large as the window, and back")
            menu.addAction(self._action(text, partial(slots.bring, name), f"Ctrl+{number}", tip))
        menu.addAction(self._action(self.tr("Back to &all panes"), slots.go_back, "Ctrl+0"))
        self._columns = self._action(
            self.tr("Panes in col&umns"),
            lambda: slots.arrange(LAYOUTS[self._columns.isChecked()], slots.large),
            on=False,
        )
        slots.rearranged.connect(lambda: self._columns.setChecked(slots.layout_name == LAYOUTS[1]))
        menu.addAction(self._columns)
        menu.addAction(
            self._action(self.tr("&Reset the panes' own views"), slots.reset_views, "Ctrl+Home")
        )
        menu.addSeparator()
        self.controls = self._toggle(self.tr("&Controls"), self.controls_shown, True, "F4")
        menu.addActions([self.controls, self.show_cost, self.all_digits])
        self._make_look_menus(menu)
        themes = {
            "system": self.tr("As the system"),
            "light": self.tr("Light"),
            "dark": self.tr("Dark"),
        }
        chosen = self._choices(menu.addMenu(self.tr("&Theme")), themes, theme)
        for value, action in chosen.items():
            action.triggered.connect(partial(self.theme_chosen.emit, value))
        menu.addAction(
            self._action(self.tr("&Full screen"), self._toggle_full_screen, FULL_SCREEN_KEY)
        )

    def _make_look_menus(self, menu: QMenu) -> None:
        """From where the world is looked at, and what of the drawings is seen."""
        views = {
            "": self.tr("&Freely"),
            "side": self.tr("From the &side"),
            "top": self.tr("From &above"),
            "axis": self.tr("Along the a&xis"),
            "eye": self.tr("From the &eye"),
        }
        self.fixed = self._choices(menu.addMenu(self.tr("Look at the &world")), views, "")
        layers = {
            "labels": self.tr("&Labels"),
            "handles": self.tr("&Handles"),
            "grid": self.tr("&Grid"),
            "frustum": self.tr("&Frustum"),
            "camera": self.tr("&Camera"),
            "near-picture": self.tr("&Picture on the near plane"),
        }
        self.layers = {name: self._action(text, on=True) for name, text in layers.items()}
        menu.addMenu(self.tr("&Layers")).addActions(list(self.layers.values()))

    def _make_help_menu(self) -> None:
        menu = self._window.menuBar().addMenu(self.tr("&Help"))
        self.start_card = self._action(
            self.tr("&Start card"), None, None,
            self.tr("The scenes as pictures, lessons, talks, and recent files"),
        )  # fmt: skip
        menu.addActions([self.start_card, self.help])
        menu.addAction(self._action(self.tr("&Conventions"), self._help.show_conventions))
        menu.addAction(self._action(self.tr("&About Frustum Lab"), self._help.show_about))

    def _make_tool_bar(self) -> None:
        self.tools = tools = QToolBar(self.tr("Tools"))
        tools.setObjectName("tools")
        tools.setMovable(False)
        tools.setIconSize(QSize(ICON_PX, ICON_PX))
        self.scene_box.setAccessibleName(self.tr("Scene"))
        set_tip(self.scene_box, self.tr("The scene in front of the camera"))
        self.scene_box.activated.connect(
            lambda index: self.scene_chosen.emit(self.scene_box.itemData(index))
        )
        tools.addWidget(self.scene_box)
        label = Label(self.tr("Scene"), tools)  # on Linux a box is named by its label, seen or not
        label.setBuddy(self.scene_box)
        label.hide()
        tools.addSeparator()
        tools.addActions([self.undo, self.redo, self.reset])
        tools.addSeparator()
        tools.addAction(self.play)
        rest = QWidget()
        rest.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        tools.addWidget(rest)
        tools.addActions(
            [self.open, self.save, self.copy, self.export, self.present, self.controls, self.help]
        )
        self._window.addToolBar(tools)
        for action, icon, text in (
            (self.undo, "undo", self.tr("Undo")),
            (self.redo, "redo", self.tr("Redo")),
            (self.reset, "reset", self.tr("Reset")),
            (self.play, "play", ""),
            (self.open, "open", self.tr("Open")),
            (self.save, "save", self.tr("Save")),
            (self.copy, "copy", self.tr("Copy")),
            (self.export, "export", self.tr("Export")),
            (self.present, "present", self.tr("Present")),
            (self.controls, "controls", self.tr("Controls")),
            (self.help, "help", self.tr("Help")),
        ):
            show_icon(action, icon)
            if text:
                action.setIconText(text)
        for action in (self.export, self.present):
            button = tools.widgetForAction(action)
            assert isinstance(button, QToolButton)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setObjectName("presentButton")  # by which it is dressed, and it was without
        button.style().unpolish(button)
        button.style().polish(button)

    def _toggle_full_screen(self) -> None:
        self._window.setWindowState(self._window.windowState() ^ Qt.WindowState.WindowFullScreen)

    # -- what the owner says

    def fit_icons(self) -> None:
        """Give the tool bar icons of its letters' size."""
        side = max(ICON_PX, round(1.4 * QFontInfo(self.tools.font()).pixelSize()))
        self.tools.setIconSize(QSize(side, side))

    def scene_title(self, name: str) -> str:
        """What a scene is called, translated; of a mesh the name of its file."""
        return self.scene_titles.get(name, file_title(name))

    def show_scene(self, name: str) -> None:
        """List the scenes, with a file's, and mark this one."""
        self.scene_box.clear()
        for built_in in BUILT_IN:
            if built_in == next(iter(PHENOMENA)):
                self.scene_box.insertSeparator(self.scene_box.count())
            self.scene_box.addItem(self.scene_titles[built_in], built_in)
        if name not in BUILT_IN:
            self.scene_box.addItem(self.scene_title(name), name)
        self.scene_box.setCurrentIndex(self.scene_box.findData(name))
        for action in self.scene_group.actions():
            action.setChecked(action.data() == name)

    def show_recent(self) -> None:
        """List the files that were open last."""
        self.recent.clear()
        for path in self._files.recent:
            action = self.recent.addAction(path.replace("&", "&&"))  # no key of the menu
            action.triggered.connect(partial(self._files.open, path))
        self.recent.setEnabled(bool(self._files.recent))

    def show_playing(self, playing: bool) -> None:
        """Name the action that plays after what it would do now."""
        self.play.setText(self.tr("Pause") if playing else self.tr("Play"))
        show_icon(self.play, "pause" if playing else "play")
