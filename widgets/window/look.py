"""The panes' appearance: theme, text size, and drawing quality."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication, QWidget

from app.document.store import Store
from app.drawings import DrawingWords
from app.drawings.style import Style
from app.lecture.letters import Letters, axis_letters
from app.model.projection import Camera
from app.scenes.scene import Scene
from widgets.panes.adaptive import Adaptive
from widgets.panes.canvas import SCALES
from widgets.panes.pane import Pane
from widgets.parts import icons, palette
from widgets.parts.kept_style import KeptStyle
from widgets.parts.messages import TranslatedWords
from widgets.parts.panel import EVERYTHING, Changed, ShownData
from widgets.window.present import readable_px
from widgets.window.settings import Settings
from widgets.window.slots import panes_of_slide

SORTED_AHEAD = 10_000
"""Number of faces above which a scene is sorted before the first click on it, not at the click."""


def dress(settings: Settings, screen_px: float = 0.0, kept: KeptStyle | None = None) -> None:
    """Set the application's colours and font; `screen_px` is the screen's height in Present."""
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    dark = palette.is_dark(settings.theme)
    palette.apply(application, dark=dark, screen_px=screen_px, kept=kept)


def cameras(panes: Mapping[str, Pane]) -> dict[str, Camera]:
    """Return the cameras of the panes that the user has turned."""
    turned = {name: pane.view for name, pane in panes.items()}
    return {name: camera for name, camera in turned.items() if camera is not None}


class Look(QObject):
    """Builds the panes' drawings, and forwards changes to them.

    `words` holds the drawings' words in the window's language, and the chosen lecture's letters.
    """

    concerns = EVERYTHING
    built = Signal(Style)  # the panes have new drawings, in this style

    def __init__(
        self,
        panes: Mapping[str, Pane],
        settings: Settings,
        store: Store,
        *,
        software_rendering: bool,
        window: QWidget,
    ) -> None:
        super().__init__(window)
        self._panes, self._settings, self._store, self._window = panes, settings, store, window
        self.drawn = [pane.canvas.drawn for pane in panes.values()]
        self.words = TranslatedWords(DrawingWords())
        self._shown: ShownData | None = None
        self._glides = False
        self.kept: KeptStyle | None = None
        self._screen_px = 0.0
        """Height of the screen while presenting, otherwise 0: the scale of text and lines."""
        self.adaptive = Adaptive(
            panes, software_rendering=software_rendering, target_ms=settings.frame_ms, window=window
        )
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._scheme_changed)

    # -- what is shown

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Update the panes' drawings, or build new ones if those cannot show the change."""
        self._shown, quality = shown, shown.document.quality
        anew = "scene" in changed
        built = anew or quality != self.adaptive.quality
        if built:
            self.adaptive.show(shown.scene, quality)
            # A mesh that replaces the objects keeps their cameras.
            self._build(shown.document.view.panes if "view" in changed else cameras(self._panes))
        if anew and shown.scene.cells > SORTED_AHEAD:
            from app.drawings.probes import sort_ahead

            sort_ahead(shown.scene)
        self.adaptive.step(self._store.in_gesture or self._glides)
        if not built:
            for pane in self._panes.values():
                if changed & pane.concerns:
                    pane.take(shown, changed)
            if "view" in changed:
                self.look_from(shown.document.view.panes)
        if changed & {"scene", "view"}:
            self.set_waiting(False)
        if "image_size" in changed:
            width, height = shown.projection.image_size
            self._panes["image"].note.setText(f"{width} × {height}")

    def look_from(self, cameras: Mapping[str, Camera]) -> None:
        """Set the panes' own cameras; panes not named get the default one."""
        for name, pane in self._panes.items():
            pane.look_from(cameras.get(name))

    def poses(self) -> dict[str, Any]:
        """Return where the panes' own cameras stand."""
        return {name: pane.pose for name, pane in self._panes.items()}

    def begin_glide(self, poses: Mapping[str, Any]) -> None:
        """Let the panes' cameras begin a way from these poses to where they stand now."""
        self._glides = True
        for name, pane in self._panes.items():
            self.refine(name, False)
            pane.begin_glide(poses.get(name))

    def glide(self, part: float) -> None:
        ends, self._glides = part == 1.0 and self._glides, self._glides and part < 1.0
        for pane in self._panes.values():
            pane.glide(part)
        if ends and not self._store.in_gesture:
            self.rest()

    def set_waiting(self, waits: bool) -> None:
        """Suspend or resume the panes while the window takes over a whole document."""
        for pane in self._panes.values():
            pane.set_waiting(waits)

    def rebuild(self, *, anew: bool = True) -> None:
        """Build all drawings anew, and keep the panes' own cameras.

        If not `anew`, drawings in the same style stay: their words are the same.
        """
        if anew:  # they were drawn with other words
            for pane in self._panes.values():
                pane.resting.clear()
        if self._shown is not None:
            self._build(cameras(self._panes), anew=anew)

    def _build(self, turned: Mapping[str, Camera], *, anew: bool = True) -> None:
        shown = self._shown
        assert shown is not None
        style = self._style()
        for name, pane in self._panes.items():
            args = self._arguments(name, self.adaptive.drawn, style)
            pane.build(shown, turned.get(name), *args, anew=anew)
        self.built.emit(style)

    def _style(self) -> Style:
        return palette.drawing_style(
            dark=palette.is_dark(self._settings.theme),
            screen_px=self._screen_px,
            device_pixel_ratio=self._window.devicePixelRatioF(),
        )

    def _arguments(self, name: str, drawn: Scene, style: Style) -> tuple[object, ...]:
        """Return the constructor's arguments for a pane's drawing of a scene."""
        quality = self.adaptive.quality
        # The world pane's own camera is never at an extreme, so that it needs no tolerance.
        how: tuple[object, ...] = ()
        if name != "world":
            how = (quality.tolerance_px(self._settings.tolerance_px),)
        if name == "image":
            how += (quality,)
        return drawn, self.words, style.enlarged(SCALES.get(quality.smoothing, 1)), *how

    def draw_ahead(self, steps: Sequence[ShownData]) -> Iterator[None]:
        """Draw what may be shown next and has not been drawn, piece by piece."""
        for step in steps:
            self.adaptive.reduce_ahead(step.scene)
            yield
        style = self._style()
        for step, (name, pane) in product(steps, self._panes.items()):
            asked = self._arguments(name, self.adaptive.whole(step.scene), style)
            is_there = asked[0] is self.adaptive.drawn and asked == pane.drawn_with
            if not is_there and self._is_seen_at(step, name):
                pane.resting.draw(step, pane.drawing, *asked)
                yield
            view = step.document.view
            if view.compare and name == view.compares_in:
                pane.resting.draw_beside(len(view.compare) - 1, step, *asked)
                yield

    def _is_seen_at(self, step: ShownData, name: str) -> bool:
        """Whether a pane will be visible at a step."""
        if not self._screen_px:
            return self._panes[name].isVisible()
        view = step.document.view
        return name in panes_of_slide(view.slide, view.large or step.scene.leading)

    def refine(self, name: str, smooth: bool) -> None:
        """Draw one pane smoothly, or coarsely while something moves that is not in the document."""
        smooth = smooth or not self.adaptive.software_rendering
        self._panes[name].request("smoothing", self.adaptive.smoothing(smooth))

    def rest(self) -> None:
        """Draw at full quality, and refit views that objects have left, once the input stops."""
        if not self._glides:
            self.adaptive.step(dragging=False)
            for pane in self._panes.values():
                pane.refit()

    # -- theme and text

    def set_letters(self, letters: Letters) -> None:
        """Name the axes by a lecture's letters."""
        names = {"up": self.tr("up"), "eye": self.tr("eye"), "target": self.tr("target")}
        names |= {f"object_{axis}": axis for axis in "xyz"}
        self.words |= names | axis_letters(letters)
        self.rebuild()

    def set_theme(self, theme: str) -> None:
        """Use one of `THEMES`."""
        self._settings.theme = theme
        self._dress()

    def set_presenting(self, on: bool) -> None:
        """Use sizes for a class, or the ordinary ones."""
        self._screen_px = readable_px(self._window) if on else 0.0
        self._dress()

    def _dress(self) -> None:
        dress(self._settings, self._screen_px, self.kept)
        icons.fit(self._window)
        self.rebuild(anew=False)

    def _scheme_changed(self) -> None:
        if self._settings.theme == "system":
            self.set_theme("system")
