"""Fixed viewpoints of the world pane, and what all drawings show and name.

::

    buttons on the world pane, menu --> WorldLook --> panes
    Arrangement (the document's view) <----'  ^
                      '-----------------------'
"""

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QButtonGroup, QMenu, QToolButton, QWidget

from app.document.view import EVERYTHING, FIXED, LAYERS
from widgets.panes.pane import Pane
from widgets.parts.buttons import tool_button
from widgets.parts.layouts import in_row
from widgets.window.actions import Actions


class FixedViews(QWidget):
    """A button for each viewpoint; `menu` combines them in one button for a narrow pane."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("fixedViews")
        texts = {
            "": (self.tr("Free"), self.tr("As you turned it with the mouse")),
            "side": (self.tr("Side"),
                     self.tr("From the side, flat like a sketch on the blackboard, with its"
                             " lengths")),
            "top": (self.tr("Above"), self.tr("From above, flat, with its lengths")),
            "axis": (self.tr("Axis"), self.tr("Along the camera's axis, flat")),
            "eye": (self.tr("Eye"), self.tr("From the eye, as the camera sees it")),
        }  # fmt: skip
        self.buttons = {
            name: tool_button(*texts[name], flat=True, checkable=True) for name in ("", *FIXED)
        }
        self.group = QButtonGroup(self)
        for button in self.buttons.values():
            self.group.addButton(button)
        in_row(*self.buttons.values(), on=self, margins=(8, 0, 0, 0), gap=0)
        tip = self.tr("Viewpoint of the world")
        self.menu = tool_button(texts[""][0], tip, icon="choose", flat=True)
        self.menu.setObjectName("fixedViewsMenu")
        self.menu.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.menu.setMenu(QMenu(self.menu))
        self.mark("")

    def mark(self, name: str) -> None:
        self.buttons[name].setChecked(True)
        self.menu.setText(self.buttons[name].text())
        self.menu.setAccessibleName(f"{self.menu.toolTip()}: {self.menu.text()}")


class WorldLook(QObject):
    """Shows the world from a fixed viewpoint, hides layers, and chooses what is named.

    `fixed` is one of `FIXED`, or "" for a free view; `hidden` holds some of `LAYERS`; `names` are
    those of a `View`.
    """

    def __init__(self, panes: Mapping[str, Pane], menus: Actions) -> None:
        super().__init__(menus)
        self._panes, self._world, self._menus = panes, panes["world"], menus
        self.fixed, self.hidden = "", frozenset[str]()
        self.names: tuple[str, ...] | None = None
        self._chosen: tuple[str, ...] | None = None  # the names to return to from everything
        self._views = FixedViews()
        self._views.menu.menu().addActions(list(menus.fixed.values()))
        self._world.header.add(self._views, self._views.menu)
        for name, button in self._views.buttons.items():
            button.clicked.connect(partial(self.show, name))
            menus.fixed[name].triggered.connect(partial(self.show, name))
        for action in menus.layers.values():
            action.triggered.connect(self._switch)
        menus.name_everything.triggered.connect(
            lambda on: self.name(EVERYTHING if on else self._chosen)
        )
        self._world.fixed_left.connect(partial(self.show, ""))

    def show(self, fixed: str, hidden: frozenset[str] | None = None) -> None:
        """Set the viewpoint, and the hidden layers unless they are None."""
        if hidden is not None and hidden != self.hidden:
            self.hidden = hidden
            for pane in self._panes.values():
                pane.request("layers", hidden)
        if fixed != self.fixed:
            self.fixed = fixed
            self._world.request("fixed", fixed)
        self._mark()

    def name(self, names: tuple[str, ...] | None) -> None:
        """Let the pictures name these things; None for those of the scene's own list."""
        if names != EVERYTHING:
            self._chosen = names
        if names != self.names:
            self.names = names
            for pane in self._panes.values():
                pane.request("names", names)
        self._mark()

    def _switch(self) -> None:
        layers = self._menus.layers
        self.show(self.fixed, frozenset(n for n in LAYERS if not layers[n].isChecked()))

    def _mark(self) -> None:
        self._views.mark(self.fixed)
        self._menus.fixed[self.fixed].setChecked(True)
        for name, action in self._menus.layers.items():
            action.setChecked(name not in self.hidden)
        self._menus.name_everything.setChecked(self.names == EVERYTHING)
