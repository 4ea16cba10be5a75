"""Read the window's arrangement into a document's `View`, and restore it from one.

::

    a document is opened, undo --> Arrangement.take --> slots, strip, drawer, panels, probes
    save, export, another document <-- Arrangement.view

The view also holds the panes' own cameras. `Look` restores them, because it builds new drawings for
another document.
"""

from collections.abc import Mapping
from dataclasses import replace

from PySide6.QtCore import QObject

from app.document.view import PANELS, View
from app.lecture.camera_frame import STEPS
from app.model.projection import Camera
from widgets.panels.frame_panel import FramePanel
from widgets.panels.matrix_panel import MatrixPanel
from widgets.panels.probe_panel import ProbePanel
from widgets.panes.compare import Compare
from widgets.panes.pane import Pane
from widgets.panes.stage_strip import StageStrip
from widgets.parts.panel import Changed, ShownData
from widgets.window.control_strip import ControlStrip
from widgets.window.drawer import Panels
from widgets.window.slots import Slots
from widgets.window.world_look import WorldLook


def cameras(panes: Mapping[str, Pane]) -> dict[str, Camera]:
    """Return the cameras of the panes that the user has turned."""
    turned = {name: pane.view for name, pane in panes.items()}
    return {name: camera for name, camera in turned.items() if camera is not None}


class Arrangement(QObject):
    """Reads the window's arrangement into a `View`, and restores it."""

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
        fixed = self._scene_fixed if view.fixed is None else view.fixed
        self._world.show(fixed, view.layers)
        self._world.name(view.names)
        self._strip.go_to(view.stage)
        self._frame.go_to(STEPS.index(view.frame_step))
        letters = self._matrices.letters
        letters.setCurrentIndex(letters.findData(view.letters))
        if (view.probes, view.pinned) != (self._probes.probes, self._probes.pinned):
            chosen = view.probes[-1].number if view.probes else 0
            self._probes.restore(view.probes, chosen, view.pinned)
        self._compare.show(view.compare, view.dividers)
