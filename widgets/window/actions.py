"""The window's actions, in its menus and its tool bar, with their shortcuts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QObject, QSize, Qt, Signal
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
from app.scenes.built_in import WORDS
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import BUILT_IN
from widgets.panes.pane import Pane
from widgets.parts.icons import Combo, show_icon
from widgets.parts.messages import file_title, of_phenomena
from widgets.parts.plain import PlainLabel, set_tip
from widgets.window.files import Files
from widgets.window.help import FULL_SCREEN_KEY, PLAY_KEY, Help, ways_to_press
from widgets.window.lesson_menu import LessonMenu
from widgets.window.pictures import Pictures
from widgets.window.slots import Slots

ICON_PX = 18


def take_typed(window: QMainWindow) -> None:
    """Commit a text that is being typed, as if its field lost the focus."""
    field = window.focusWidget()
    if isinstance(field, QLineEdit) and field.isModified():
        field.clearFocus()
        if not window.isActiveWindow():  # the field then has no focus to lose
            field.editingFinished.emit()


class Actions(QObject):
    """The actions of one window, in its menus and its tool bar.

    Actions that involve only one component are connected here. The window connects the `triggered`
    signals of the others.
    """

    scene_chosen = Signal(str)
    theme_chosen = Signal(str)

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
        self._window, self._files = window, files
        self._slots, self._panes = slots, panes
        own_words = {each.name: each.words for each in PHENOMENA.values()}
        titles = {name: words.title for name, words in (WORDS | own_words).items()}
        self.scene_titles = {name: of_phenomena(title) for name, title in titles.items()}
        keys = QKeySequence.StandardKey
        self.open = self._action(
            self.tr("&Open…"), self._with_typed(files.open_dialog), keys.Open,
            self.tr("Open a document, a lesson, a mesh, a camera or an exported picture"),
        )  # fmt: skip
        self.save = self._action(self.tr("&Save"), self._with_typed(files.save), keys.Save)
        self._save_as = self._action(
            self.tr("Save &as…"), self._with_typed(files.save_as), "Ctrl+Shift+S"
        )
        self.copy = self._action(
            self.tr("&Copy picture"), self._with_typed(pictures.copy), "Ctrl+Shift+C",
            self.tr("Copy the three panes to the clipboard, including the document"),
        )  # fmt: skip
        self.export = self._action(
            self.tr("&Export picture…"), self._with_typed(pictures.export_dialog), "Ctrl+E",
            self.tr("Export panes as PNG, SVG, PDF or TikZ; a PNG contains the document"),
        )  # fmt: skip
        self.recent = QMenu(self.tr("Open &recent"), window)
        self._menu(
            self.tr("&File"), self.open, self.recent.menuAction(), None, self.save, self._save_as,
            None, self.export, self.copy, None,
            self._action(self.tr("&Quit"), window.close, keys.Quit),
        )  # fmt: skip
        self.undo = self._action(self.tr("&Undo"), None, keys.Undo)
        self.redo = self._action(self.tr("&Redo"), None, keys.Redo)
        self.reset = self._action(
            self.tr("Reset &all"), None, "Ctrl+R",
            self.tr("Reset camera, lens, image and settings to how the scene opens"),
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
        self._menu(
            self.tr("&Edit"), self.undo, self.redo, None, self.reset, None, self.remove_probe,
            self.find,
        )  # fmt: skip
        self.scene_group = QActionGroup(window)
        self._make_scenes_menu()
        self.lesson_menu = LessonMenu(self.tr("&Lessons"), window, self._action)
        window.menuBar().addMenu(self.lesson_menu)
        self.present = self._action(
            self.tr("&Present"), None, "F5",
            self.tr("Show the panes and the essential controls on the full screen, for a class"),
        )  # fmt: skip
        self.present_all = self._action(
            self.tr("Present from the beginnin&g"), None, "Shift+F5",
            self.tr("Present the open talk from its first step"),
        )  # fmt: skip
        self.blank = self._action(
            self.tr("&Blank the screen"), None, "B",
            self.tr("Show the class a black screen, or the panes again"),
        )  # fmt: skip
        self.pointer = self._action(
            self.tr("P&ointer in all panes"), None, "P",
            self.tr("While presenting, mark in all panes the point under the mouse"), on=False,
        )  # fmt: skip
        self.strip = self._action(
            self.tr("Co&ntrols of the slide"), None, "C",
            self.tr("While presenting, show the controls of the slide below it, or hide them"),
        )  # fmt: skip
        self.pen = self._action(
            self.tr("P&en"), None, "D",
            self.tr("While presenting, draw on the slide, or put the pen away"), on=False,
        )  # fmt: skip
        self.compare = self._action(
            self.tr("Compare wit&h this picture"), None, "F6",
            self.tr("Hold the current picture and compare it with later ones, or end the"
                    " comparison"),
            on=False,
        )  # fmt: skip
        self.compare_way = self._action(
            self.tr("Compare s&ide by side or overlaid"), None, "Shift+F6"
        )
        for later in (
            self.remove_probe, self.blank, self.pointer, self.strip, self.pen, self.compare_way,
        ):  # fmt: skip
            later.setEnabled(False)
        self.controls = self._action(self.tr("&Controls"), None, "F4", on=True)
        self.show_cost = self._action(
            self.tr("&Show cost"), None, None,
            self.tr("Measure the cost of every step: the model, each pane's matrices and repaint"),
            on=False,
        )  # fmt: skip
        self.all_digits = self._action(
            self.tr("All &digits"), None, None,
            self.tr("Show all digits of every number, not only four"), on=all_digits,
        )  # fmt: skip
        self.reduce_motion = self._action(
            self.tr("Reduce &motion"), None, None,
            self.tr("Show the next step of a lesson or a talk at once, without a transition"),
            on=False,
        )  # fmt: skip
        self._make_view_menu(theme)
        self.help = self._action(self.tr("&Keys and mouse"), help_.show_keys, keys.HelpContents)
        self.start_card = self._action(
            self.tr("&Start card"), None, None,
            self.tr("The scenes as pictures, lessons, talks, and recent files"),
        )  # fmt: skip
        self.trades = self._action(
            self.tr("S&peed and accuracy"), None, None,
            self.tr("What a renderer gives up to be fast: trades as pictures, measured"),
        )  # fmt: skip
        self._menu(
            self.tr("&Help"), self.start_card, self.trades, self.help,
            self._action(self.tr("&Conventions"), help_.show_conventions),
            self._action(self.tr("&About Frustum Lab"), help_.show_about),
        )  # fmt: skip
        self.play = self._action(
            self.tr("Play"), None, PLAY_KEY, self.tr("Play or pause the camera's orbit")
        )
        self.scene_box = Combo(self.tr("Scene"), self.tr("The scene in front of the camera"))
        self._make_tool_bar()
        keyed = [a for a in window.findChildren(QAction) if not a.shortcut().isEmpty()]
        # They work without the menu bar, and in the window of a floating pane.
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
        """Make an action; it is checkable unless `on` is None."""
        action = QAction(text, self._window, checkable=on is not None, checked=on is True)
        if act is not None:
            action.triggered.connect(lambda _checked=False: act())
        if shortcut is not None:
            action.setShortcuts(ways_to_press(shortcut))
        plain = (tip or text).replace("&", "").rstrip("…")
        keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        set_tip(action, f"{plain} ({keys})" if keys else plain)
        return action

    def _choices(self, texts: Mapping[str, str], now: str) -> dict[str, QAction]:
        """Make exclusive actions, by the values that they choose."""
        group = QActionGroup(self)
        made = {name: self._action(text, on=name == now) for name, text in texts.items()}
        for action in made.values():
            group.addAction(action)
        return made

    def _menu(self, title: str, *entries: QAction | None, inside: QMenu | None = None) -> QMenu:
        """Add a menu to the menu bar or to another menu; None is a separator."""
        menu = (inside or self._window.menuBar()).addMenu(title)
        for entry in entries:
            if entry is None:
                menu.addSeparator()
            else:
                menu.addAction(entry)
        return menu

    def _with_typed(self, act: Callable[[], object]) -> Callable[[], object]:
        """Return a function that first commits a number that is still being typed."""

        def acted() -> None:
            take_typed(self._window)
            act()

        return acted

    def _make_scenes_menu(self) -> None:
        entries: list[QAction | None] = []
        for name in BUILT_IN:
            if name == next(iter(PHENOMENA)):
                entries.append(None)
            act = partial(self.scene_chosen.emit, name)
            action = self._action(self.scene_titles[name], act, on=False)
            action.setData(name)
            self.scene_group.addAction(action)
            entries.append(action)
        mesh = self._action(self.tr("Open a &mesh…"), self._files.open_dialog)
        self._menu(self.tr("&Scenes"), *entries, None, mesh)

    def _make_view_menu(self, theme: str) -> None:
        slots = self._slots
        tip = self.tr("Show the pane in the large slot; choose it again to fill the window")
        large = [
            self._action(
                self.tr("{0} in large").format(pane.accessibleName()),
                partial(slots.make_large, name), f"Ctrl+{number}", tip,
            )
            for number, (name, pane) in enumerate(self._panes.items(), start=1)
        ]  # fmt: skip
        columns = self._action(
            self.tr("Panes in col&umns"),
            lambda: slots.arrange(LAYOUTS[columns.isChecked()], slots.large),
            on=False,
        )
        slots.rearranged.connect(lambda: columns.setChecked(slots.layout_name == LAYOUTS[1]))
        self.view_menu = menu = self._menu(
            self.tr("&View"), self.present, self.present_all, self.blank, self.pointer, self.strip,
            self.pen, None, self.compare, self.compare_way, None, *large,
            self._action(self.tr("Back to &all panes"), slots.go_back, "Ctrl+0"), columns,
            self._action(self.tr("&Reset the panes' own views"), slots.reset_views, "Ctrl+Home"),
            None, self.controls, self.show_cost, self.all_digits,
            self.reduce_motion,
        )  # fmt: skip
        views = {
            "": self.tr("&Freely"),
            "side": self.tr("From the &side"),
            "top": self.tr("From &above"),
            "axis": self.tr("Along the a&xis"),
            "eye": self.tr("From the &eye"),
        }
        self.fixed = self._choices(views, "")
        self._menu(self.tr("Look at the &world"), *self.fixed.values(), inside=menu)
        layers = {
            "labels": self.tr("&Labels"),
            "handles": self.tr("&Handles"),
            "grid": self.tr("&Grid"),
            "frustum": self.tr("&Frustum"),
            "camera": self.tr("&Camera"),
            "near-picture": self.tr("&Picture on the near plane"),
        }
        self.layers = {name: self._action(text, on=True) for name, text in layers.items()}
        self._menu(self.tr("&Layers"), *self.layers.values(), inside=menu)
        self.name_everything = self._action(
            self.tr("Name e&verything"), None, "N",
            self.tr("Name everything in the pictures, not only what the scene is about"), on=False,
        )  # fmt: skip
        menu.addAction(self.name_everything)
        themes = {
            "system": self.tr("As the system"),
            "light": self.tr("Light"),
            "dark": self.tr("Dark"),
        }
        chosen = self._choices(themes, theme)
        self._menu(self.tr("&Theme"), *chosen.values(), inside=menu)
        for value, action in chosen.items():
            action.triggered.connect(partial(self.theme_chosen.emit, value))
        menu.addAction(
            self._action(self.tr("&Full screen"), self._toggle_full_screen, FULL_SCREEN_KEY)
        )

    def _make_tool_bar(self) -> None:
        self.tools = tools = QToolBar(self.tr("Tools"))
        tools.setObjectName("tools")
        tools.setMovable(False)
        tools.setIconSize(QSize(ICON_PX, ICON_PX))
        self.scene_box.activated.connect(
            lambda index: self.scene_chosen.emit(self.scene_box.itemData(index))
        )
        tools.addWidget(self.scene_box)
        # On Linux a box takes its label's name, even hidden.
        label = PlainLabel(self.tr("Scene"), tools)
        label.setBuddy(self.scene_box)
        label.hide()
        rest = QWidget()
        rest.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        for action, icon, text in (
            (None, "", ""),
            (self.undo, "undo", self.tr("Undo")),
            (self.redo, "redo", self.tr("Redo")),
            (self.reset, "reset", self.tr("Reset")),
            (None, "", ""),
            (self.play, "play", ""),
            (self.open, "open", self.tr("Open")),
            (self.save, "save", self.tr("Save")),
            (self.copy, "copy", self.tr("Copy")),
            (self.export, "export", self.tr("Export")),
            (self.present, "present", self.tr("Present")),
            (self.controls, "controls", self.tr("Controls")),
            (self.help, "help", self.tr("Help")),
        ):
            if action is None:
                tools.addSeparator()
                continue
            show_icon(action, icon)
            if text:
                action.setIconText(text)
            tools.addAction(action)
            if action is self.play:
                tools.addWidget(rest)
        self._window.addToolBar(tools)
        for action in (self.export, self.present):
            button = tools.widgetForAction(action)
            assert isinstance(button, QToolButton)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setObjectName("presentButton")  # the style sheet refers to this name
        button.style().unpolish(button)
        button.style().polish(button)

    def _toggle_full_screen(self) -> None:
        self._window.setWindowState(self._window.windowState() ^ Qt.WindowState.WindowFullScreen)

    # -- kept up to date by the window

    def fit_icons(self) -> None:
        """Fit the tool bar's icons to the size of its letters."""
        side = max(ICON_PX, round(1.4 * QFontInfo(self.tools.font()).pixelSize()))
        self.tools.setIconSize(QSize(side, side))

    def scene_title(self, name: str) -> str:
        """Return a scene's translated title, or the name of a mesh's file."""
        return self.scene_titles.get(name, file_title(name))

    def show_scene(self, name: str) -> None:
        """List the scenes, including an opened mesh, and mark the current one."""
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
        self.recent.clear()
        for path in self._files.recent:
            action = self.recent.addAction(path.replace("&", "&&"))  # & does not mark a key here
            action.triggered.connect(partial(self._files.open, path))
        self.recent.setEnabled(bool(self._files.recent))

    def show_playing(self, playing: bool) -> None:
        """Name the play action after its next effect."""
        self.play.setText(self.tr("Pause") if playing else self.tr("Play"))
        show_icon(self.play, "pause" if playing else "play")
