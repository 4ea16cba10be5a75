"""Presents a scene: its card in the dock, its panel, its settings, its controls."""

from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject

from app.document.store import Store
from app.model.parameter import Value
from app.model.refusal import Refusal
from app.scenes.scene import RASTERISED
from widgets.controls.controls import Controls
from widgets.panels.scene_panel import ScenePanel
from widgets.panes.manipulation import Manipulation
from widgets.panes.pane import Pane
from widgets.parts.panel import Changed, ShownData
from widgets.window.actions import Actions
from widgets.window.drawer import Panels


class SceneGuide(QObject):
    """Presents each new scene, and takes over the settings that the user edits.

    The drawing of `image` finds out whether OpenGL refuses a shader of the scene. `choose` changes
    to the scene with a name, or says why it cannot.
    """

    concerns = frozenset({"scene", "view", "quality"})

    def __init__(
        self,
        panel: ScenePanel,
        panels: Panels,
        controls: Controls,
        manipulation: Manipulation,
        image: Pane,
        menus: Actions,
        store: Store,
        choose: Callable[[str], object],
    ) -> None:
        super().__init__(panel)
        self._panel, self._panels, self._controls = panel, panels, controls
        self._manipulation, self._image, self._menus = manipulation, image, menus
        self._store, self._choose = store, choose
        self._needs_shader = False  # whether the image needs a shader that OpenGL may refuse
        menus.scene_chosen.connect(self.choose)
        self._card = controls.card
        self._card.settings_edited.connect(partial(self._set, self._card.refuse))
        self._card.explanation.clicked.connect(lambda: panels.open(panel))
        by_hand = partial(self._set, lambda error: manipulation.refuse(self._card.named(error)))
        manipulation.setting_edited.connect(by_hand)

    def choose(self, name: str) -> None:
        """Change to another scene, as one undo step."""
        self._manipulation.let_go()  # a held handle belongs to the previous scene
        self._choose(name)
        self._menus.show_scene(self._store.document.scene)

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Describe the scene, and bring the controls that matter for it to the top."""
        document, phenomenon = shown.document, shown.scene.phenomenon
        asks = bool(shown.scene.requires & RASTERISED) or document.quality.has_depth
        if asks != self._needs_shader:
            self._needs_shader, rendered = asks, self._image.canvas.shown
            if asks:
                rendered.connect(self._show_problem)  # only rendering shows whether it works
            else:
                rendered.disconnect(self._show_problem)
                self._card.show_problem(None)
        if not changed & {"scene", "view"}:
            return
        self._menus.show_scene(document.scene)
        title = self._menus.scene_title(document.scene)
        self._card.show_scene(title, shown.scene.tries, phenomenon, Path(document.mesh).name)
        self._panel.show_scene(title, phenomenon)
        self._panels.offer(self._panel, phenomenon is not None)
        own = (phenomenon.controls, phenomenon.replaces) if phenomenon else ((),)
        self._controls.bring_to_front(*own)

    def _set(self, refuse: Callable[[Refusal], None], settings: Mapping[str, Value]) -> None:
        try:
            self._store.set_settings(settings)
        except Refusal as error:
            # A value of the camera may have followed the setting.
            same = (f"settings.{name}" for name in settings if settings[name] == error.value)
            refuse(Refusal(next(same, error.field), error.value, error.bound, *error.limits))

    def _show_problem(self) -> None:
        """Say that this computer's OpenGL has refused the scene's own shader, and draw again."""
        drawing = self._image.drawing
        problem = None if drawing is None else drawing.problem
        if self._card.show_problem(problem) and problem is not None:
            self._image.canvas.redraw()
