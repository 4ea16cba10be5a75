"""The window's actions, in its menus and its tool bar, with their shortcuts."""

from collections.abc import Callable, Mapping
from functools import cache, partial
from pathlib import Path
from typing import NamedTuple

from PySide6 import QtWidgets
from PySide6.QtCore import QCoreApplication, QObject, QSize, Qt, Signal
from PySide6.QtGui import QAction, QActionGroup, QFontInfo, QKeySequence, QPalette

from app.document.view import LAYOUTS
from app.languages import LANGUAGES
from app.model.parameter import read_sections
from app.scenes.built_in import WORDS
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import BUILT_IN
from widgets.panes.pane import Pane
from widgets.parts.icons import Combo, icon, show_icon
from widgets.parts.messages import file_title, of_phenomena
from widgets.parts.plain import PlainLabel, set_tip
from widgets.window.files import Files
from widgets.window.help import FULL_SCREEN_KEY, PLAY_KEY, show_about, show_keys, ways_to_press
from widgets.window.lesson_card import AGAIN_KEY, BACK_KEY, NEXT_KEY
from widgets.window.lesson_menu import LessonMenu
from widgets.window.pictures import Pictures
from widgets.window.slots import Slots

ICON_PX = 18
SEPARATOR = "-"
_NO_MORE: Mapping[str, str] = {}
_NAMED_KEYS = {
    "Play": PLAY_KEY, "FullScreen": FULL_SCREEN_KEY,
    "Again": AGAIN_KEY, "Next": NEXT_KEY, "Back": BACK_KEY,
}  # fmt: skip
_tr = partial(QCoreApplication.translate, "Actions")


class MenuEntry(NamedTuple):
    text: str
    keys: str
    tip: str


class MenuWords(NamedTuple):
    """A section of the content file: a menu, or the tool bar."""

    title: str
    order: list[str]  # the names of what it shows
    entries: dict[str, MenuEntry]


@cache
def menus() -> dict[str, MenuWords]:
    """Read the menus, by their names; `tests/texts.py` makes a source for lupdate from them."""
    read = {}
    for heading, section in read_sections(Path(__file__).with_name("actions.md")).items():
        title, _, name = heading.removesuffix("}").partition(" {#")
        items = [item.partition(": ") for item in section.items]
        entries = {
            each: MenuEntry(*(part.strip() for part in f"{words}||".split("|")[:3]))
            for each, _, words in items
            if words
        }
        read[name] = MenuWords(title, [each for each, _, _ in items], entries)
    return read


def _keys(text: str) -> str | QKeySequence.StandardKey | None:
    """Return the keys that the content file means; those in braces have a name."""
    name = text.strip("{}")
    if name == text:
        return text or None
    return _NAMED_KEYS.get(name) or QKeySequence.StandardKey[name]


def take_typed(window: QtWidgets.QMainWindow) -> None:
    """Commit a text that is being typed, as if its field lost the focus."""
    field = window.focusWidget()
    if isinstance(field, QtWidgets.QLineEdit) and field.isModified():
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
    language_chosen = Signal(str)

    def __init__(
        self,
        window: QtWidgets.QMainWindow,
        *,
        files: Files,
        pictures: Pictures,
        slots: Slots,
        panes: Mapping[str, Pane],
        theme: str,
        language: str,
        all_digits: bool,
    ) -> None:
        super().__init__(window)
        self._window, self._files = window, files
        self._slots, self._panes = slots, panes
        own_words = {each.name: each.words for each in PHENOMENA.values()}
        titles = {name: words.title for name, words in (WORDS | own_words).items()}
        self.scene_titles = {name: of_phenomena(title) for name, title in titles.items()}
        self._made: dict[str, list[QAction]] = {}  # by the names in the content file
        make, typed = self._named, self._with_typed
        self.open = make("open", typed(files.open_dialog))
        self.save = make("save", typed(files.save))
        make("save_as", typed(files.save_as))
        self.copy = make("copy", typed(pictures.copy))
        self.export = make("export", typed(pictures.export_dialog))
        make("quit", window.close)
        self.recent = self._submenu("recent")
        self.undo, self.redo, self.reset = make("undo"), make("redo"), make("reset")
        self.remove_probe, self.find = make("remove_probe"), make("find")
        every_find = QKeySequence.keyBindings(QKeySequence.StandardKey.Find)
        self.find.setShortcuts([*every_find, QKeySequence("/")])
        self.scene_group = QActionGroup(window)
        self._make_scenes()
        self.present, self.present_all = make("present"), make("present_all")
        self.blank, self.strip = make("blank"), make("strip")
        self.pointer, self.pen = make("pointer", on=False), make("pen", on=False)
        self.compare, self.compare_way = make("compare", on=False), make("compare_way")
        for later in (
            self.remove_probe, self.blank, self.pointer, self.strip, self.pen, self.compare_way,
        ):  # fmt: skip
            later.setEnabled(False)
        self._make_arrangement()
        self.controls = make("controls", on=True)
        self.show_cost = make("show_cost", on=False)
        self.all_digits = make("all_digits", on=all_digits)
        self.reduce_motion = make("reduce_motion", on=False)
        self.name_everything = make("name_everything", on=False)
        self.fixed = self._choices("fixed", "")
        self.layers = self._choices("layers")
        for value, action in self._choices("theme", theme).items():
            action.triggered.connect(partial(self.theme_chosen.emit, value))
        for value, action in self._choices("language", language, LANGUAGES).items():
            action.triggered.connect(partial(self.language_chosen.emit, value))
        full = Qt.WindowState.WindowFullScreen
        make("full_screen", lambda: window.setWindowState(window.windowState() ^ full))
        self.help = make("help", partial(show_keys, window))
        self.start_card, self.trades = make("start_card"), make("trades")
        make("conventions", partial(show_about, window, "Conventions"))
        make("about", partial(show_about, window, "About Frustum Lab"))
        self.play = make("play")
        self.lesson_menu = LessonMenu(window, make, self._submenu)
        self._menu("file")
        self._menu("edit")
        self._menu("scenes")
        self._menu("lessons", self.lesson_menu)
        self.view_menu = self._menu("view")
        self._menu("help")
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

    def _named(
        self, name: str, act: Callable[[], object] | None = None, *, on: bool | None = None
    ) -> QAction:
        entry = next(menu.entries[name] for menu in menus().values() if name in menu.entries)
        action = self._action(_tr(entry.text), act, _keys(entry.keys), _tr(entry.tip), on)
        self._made[name] = [action]
        return action

    def _submenu(self, name: str) -> QtWidgets.QMenu:
        menu = QtWidgets.QMenu(_tr(menus()[name].title), self._window)
        self._made[name] = [menu.menuAction()]
        return menu

    def _choices(
        self, name: str, now: str | None = None, more: Mapping[str, str] = _NO_MORE
    ) -> dict[str, QAction]:
        """Make a menu of switches, or of choices of which one holds `now`; return its actions."""
        texts = {value: _tr(entry.text) for value, entry in menus()[name].entries.items()}
        texts |= more
        made = {value: self._action(text, on=now in (value, None)) for value, text in texts.items()}
        self._submenu(name).addActions(list(made.values()))
        if now is not None:
            group = QActionGroup(self)
            for action in made.values():
                group.addAction(action)
        return made

    def _menu(self, name: str, menu: QtWidgets.QMenu | None = None) -> QtWidgets.QMenu:
        """Add a menu to the menu bar, with what was made for it; by default a new one."""
        menu = menu or QtWidgets.QMenu(self._window)
        menu.setTitle(_tr(menus()[name].title))
        for each in menus()[name].order:
            if each == SEPARATOR:
                menu.addSeparator()
            else:
                menu.addActions(self._made[each])
        self._window.menuBar().addMenu(menu)
        return menu

    def _with_typed(self, act: Callable[[], object]) -> Callable[[], object]:
        """Return a function that first commits a number that is still being typed."""

        def acted() -> None:
            take_typed(self._window)
            act()

        return acted

    def _make_scenes(self) -> None:
        entries = self._made["scenes"] = []
        for name in BUILT_IN:
            if name == next(iter(PHENOMENA)):
                entries.append(QAction(self._window))
                entries[-1].setSeparator(True)
            act = partial(self.scene_chosen.emit, name)
            action = self._action(self.scene_titles[name], act, on=False)
            action.setData(name)
            self.scene_group.addAction(action)
            entries.append(action)
        self._named("mesh", self._files.open_dialog)

    def _make_arrangement(self) -> None:
        slots = self._slots
        for name, pane in self._panes.items():
            large = self._named(f"large_{name}", partial(slots.make_large, name))
            large.setText(large.text().format(pane.accessibleName()))
        self._named("all_panes", slots.go_back)
        columns = self._named(
            "columns", lambda: slots.arrange(LAYOUTS[columns.isChecked()], slots.large), on=False
        )
        slots.rearranged.connect(lambda: columns.setChecked(slots.layout_name == LAYOUTS[1]))
        self._named("reset_views", slots.reset_views)

    def _make_tool_bar(self) -> None:
        self.tools = tools = QtWidgets.QToolBar(self.tr("Tools"))
        tools.setObjectName("tools")
        tools.setMovable(False)
        self.fit_icons()
        self.scene_box.activated.connect(
            lambda index: self.scene_chosen.emit(self.scene_box.itemData(index))
        )
        tools.addWidget(self.scene_box)
        # On Linux a box takes its label's name, even hidden.
        label = PlainLabel(self.tr("Scene"), tools)
        label.setBuddy(self.scene_box)
        label.hide()
        rest = QtWidgets.QWidget()
        rest.setSizePolicy(
            QtWidgets.QSizePolicy.Policy.Expanding, QtWidgets.QSizePolicy.Policy.Preferred
        )
        buttons = menus()["tools"]
        for name in buttons.order:
            if name == SEPARATOR:
                tools.addSeparator()
                continue
            (action,) = self._made[name]
            show_icon(action, name)
            tools.addAction(action)
            if action is self.play:  # its text changes
                tools.addWidget(rest)
            else:
                action.setIconText(_tr(buttons.entries[name].text))
        self._window.addToolBar(tools)
        for action in (self.export, self.present):
            button = tools.widgetForAction(action)
            assert isinstance(button, QtWidgets.QToolButton)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            if action is self.present:  # on the colour of a choice
                button.setIcon(icon("present", QPalette.ColorRole.HighlightedText))
        button.setObjectName("presentButton")  # the style sheet refers to this name
        button.style().unpolish(button)
        button.style().polish(button)

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
