"""Read the window's arrangement into a document's `View`, and restore it from one.

::

    a document is opened, undo --> Arrangement.take --> slots, strip, drawer, panels, probes
    save, export, another document <-- Arrangement.view
    buttons on the world pane, menu --> WorldLook --> panes

The view also holds the panes' own cameras. `Look` restores them, because it builds new drawings for
another document.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QButtonGroup, QMenu, QToolButton, QWidget

from app.document.view import EVERYTHING, FIXED, LAYERS, PANELS, View
from app.lecture.camera_frame import STEPS
from widgets.panels.frame_panel import FramePanel
from widgets.panels.matrix_panel import MatrixPanel
from widgets.panels.probe_panel import ProbePanel
from widgets.panes.compare import Compare
from widgets.panes.pane import Pane
from widgets.panes.stage_strip import StageStrip
from widgets.parts.layouts import in_row, tool_button
from widgets.parts.panel import Changed, ShownData
from widgets.parts.wording import Wording
from widgets.window.actions import Actions
from widgets.window.control_strip import ControlStrip
from widgets.window.drawer import Panels
from widgets.window.look import cameras
from widgets.window.slots import Slots

WORDS = Wording(__file__)


class FixedViews(QWidget):
    """A button for each viewpoint; `menu` combines them in one button for a narrow pane."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("fixedViews")
        self.buttons = {
            name: WORDS.tool(name or "free", flat=True, checkable=True) for name in ("", *FIXED)
        }
        self.group = QButtonGroup(self)
        for button in self.buttons.values():
            self.group.addButton(button)
        in_row(*self.buttons.values(), on=self, margins=(8, 0, 0, 0), gap=0)
        free = self.buttons[""].text()
        self.menu = tool_button(free, WORDS.say("menu"), icon="choose", flat=True)
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


class Arrangement(QObject):
    concerns = frozenset({"view", "scene"})

    def __init__(
        self,
        panes: Mapping[str, Pane],
        slots: Slots,
        world: WorldLook,
        strip: StageStrip,
        drawer: Panels,
        matrices: MatrixPanel,
        frame: FramePanel,
        probes: ProbePanel,
        compare: Compare,
        controls: ControlStrip,
    ) -> None:
        super().__init__(slots)
        self._panes, self._slots, self._strip, self._world = panes, slots, strip, world
        self._drawer, self._panels = drawer, dict(zip(PANELS, drawer.all, strict=True))
        self._matrices, self._frame, self._probes = matrices, frame, probes
        self._compare, self._controls = compare, controls
        self._scene_fixed = ""  # the viewpoint with which the scene opens
        self._given = View()  # the view shown last; it keeps the values that no widget can change

    @property
    def view(self) -> View:
        opened = (name for name, panel in self._panels.items() if panel is self._drawer.open_panel)
        elsewhere = {n: c for n, c in self._given.panes.items() if n not in self._panes}
        return replace(
            self._given,
            layout=self._slots.layout_name,
            large="" if self._slots.large == self._slots.leading else self._slots.large,
            stage=self._strip.position,
            frame_step=STEPS[self._frame.step],
            panel=next(opened, ""),
            letters=self._matrices.letters.currentData(),
            layers=self._world.hidden,
            fixed=None if self._world.fixed == self._scene_fixed else self._world.fixed,
            names=self._world.names,
            probes=self._probes.probes,
            pinned=self._probes.pinned,
            compare=self._compare.pictures,
            dividers=self._compare.dividers,
            panes=elsewhere | cameras(self._panes),
        )

    def take(self, shown: ShownData, changed: Changed) -> None:
        before, self._scene_fixed = self._scene_fixed, shown.scene.fixed
        if "view" in changed:
            self.show(shown.document.view)
        elif self._world.fixed == before:
            self._world.show(self._scene_fixed)

    def show(self, view: View) -> None:
        """Arrange the window according to a view; whatever already agrees is not touched."""
        self._given = view
        panel = "kinds" if "kinds" in view.slide else view.panel
        if panel is not None:  # otherwise the scene has opened its own panel
            self._drawer.open(self._panels.get(panel))
        # After the panel: a rearranged window reopens a panel that presenting has folded.
        self._slots.arrange(view.layout, view.large, self._slots.whole)
        self._slots.show_slide(view.slide)
        self._controls.show_controls(view.controls)
        self._world.show(self._scene_fixed if view.fixed is None else view.fixed, view.layers)
        self._world.name(view.names)
        if view.stage != self._strip.position:  # or it would stop playing
            self._strip.go_to(view.stage)
        self._frame.go_to(STEPS.index(view.frame_step))
        self._matrices.choose_letters(view.letters)
        if (view.probes, view.pinned) != (self._probes.probes, self._probes.pinned):
            chosen = view.probes[-1].number if view.probes else 0
            self._probes.restore(view.probes, chosen, view.pinned)
        self._compare.show(view.compare, view.dividers)
