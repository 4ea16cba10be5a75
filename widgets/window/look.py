"""How the panes look: theme and size of text, and the quality they are drawn with."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication, QWidget

from app.document.field_names import FIELDS
from app.document.store import Store
from app.drawings import WORDS
from app.drawings.style import Style
from app.lecture.notation import Letters, axis_letters
from app.model.projection import Camera
from app.scenes.scene import Scene
from widgets.panes.adaptive import Adaptive
from widgets.panes.pane import SCALES, Pane
from widgets.parts import icons, palette
from widgets.parts.messages import Words, field_name
from widgets.parts.panel import EVERYTHING, Changed, Shown
from widgets.window.arrangement import cameras
from widgets.window.settings import Settings

SORTED_AHEAD = 10_000
"""Faces of a scene that are sorted before the first click on it; of fewer the click does it."""


def dress(settings: Settings, screen_px: float = 0.0) -> None:
    """Give the application its colours and its font, before there are widgets or later."""
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    palette.apply(application, dark=palette.is_dark(settings.theme), screen_px=screen_px)


class Look(QObject):
    """Builds the drawings of the panes, and hands changes on to them.

    Parameters
    ----------
    panes : mapping of str to Pane
    settings : Settings
        Of which theme, tolerance and frame time are looked at.
    store : Store
    software_rendering : bool
        Whether OpenGL runs without a GPU.
    window : QWidget

    Attributes
    ----------
    adaptive : Adaptive
    words : mapping of str to str
        The drawings' words in the window's language; the letters are the lectures'.
    """

    concerns = EVERYTHING
    built = Signal(Style)
    """The panes have other drawings now; other pictures are drawn in this style as well."""

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
        self._panes, self._settings, self._store = panes, settings, store
        self._window = window
        self.words = Words(
            {
                **WORDS,
                **{english: field_name(name) for name, english in FIELDS.items()},
                "near": self.tr("near"),
                "far": self.tr("far"),
                "eye": self.tr("eye"),
                "target": self.tr("target"),
                "look": self.tr("look"),
                "up": self.tr("up"),
                "held": self.tr("held"),
                "now": self.tr("now"),
                "other": self.tr("other"),
                "half width": self.tr("half width"),
                "half height": self.tr("half height"),
                "no planes": self.tr("A typed matrix has no near, no far and no angle."),
                "no angle": self.tr(
                    "A parallel lens has no angle: it is as wide at every distance."
                ),
                "no eye": self.tr("A parallel lens has no eye: this is the view along its axis."),
                "no room": self.tr("No room for all dimensions."),
                "no half angle": self.tr(
                    "This window is off the axis, which does not halve its angle."
                ),
            }
        )
        self._shown: Shown | None = None
        self._screen_px = 0.0
        """Height of the screen while presenting, of which text and lines are a share."""
        self.adaptive = Adaptive(
            panes, software_rendering=software_rendering, target_ms=settings.frame_ms, window=window
        )
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._scheme_changed)

    # -- what is shown

    def take(self, shown: Shown, changed: Changed) -> None:
        """Let the panes show it: by other drawings, where it cannot be in those that they have."""
        self._shown, quality = shown, shown.document.quality
        anew = "scene" in changed
        built = anew or quality != self.adaptive.quality
        if built:
            self.adaptive.show(shown.scene, quality)
            # A mesh in the place of the objects is looked at from where they were.
            self._build(shown.document.view.panes if "view" in changed else self._turned)
        if anew and shown.scene.faces > SORTED_AHEAD:
            from app.drawings.probes import sort_ahead

            sort_ahead(shown.scene)
        self.adaptive.step(self._store.in_gesture)
        if not built:
            for pane in self._panes.values():
                if changed & pane.concerns:
                    pane.take(shown, changed)
            if "view" in changed:
                for name, pane in self._panes.items():
                    pane.look_from(shown.document.view.panes.get(name))
        self.set_waiting(False)
        if "image_size" in changed:
            width, height = shown.projection.image_size
            self._panes["image"].note.setText(f"{width} × {height}")

    def set_waiting(self, waits: bool) -> None:
        """Let the panes wait, while a whole document is taken, until they are told; or no more."""
        for pane in self._panes.values():
            pane.set_waiting(waits)

    def rebuild(self) -> None:
        """Make all drawings anew, looked at from where they are looked at now."""
        self.forget_ahead()  # it may have other words
        if self._shown is not None:
            self._build(self._turned)

    def forget_ahead(self) -> None:
        """Nothing is made ahead any more."""
        for pane in self._panes.values():
            pane.ahead.keep()

    def _build(self, turned: Mapping[str, Camera]) -> None:
        shown = self._shown
        assert shown is not None
        style = self._style()
        for name, pane in self._panes.items():
            pane.build(shown, turned.get(name), *self._arguments(name, self.adaptive.drawn, style))
        icons.fit(self._window)
        self.built.emit(style)

    def _style(self) -> Style:
        return palette.drawing_style(
            dark=palette.is_dark(self._settings.theme),
            screen_px=self._screen_px,
            device_pixel_ratio=self._window.devicePixelRatioF(),
        )

    def _arguments(self, name: str, drawn: Scene, style: Style) -> tuple[object, ...]:
        """What a pane's drawing of a scene is made with."""
        quality = self.adaptive.quality
        # The world pane is looked at by a camera of its own, which is never at an extreme.
        how: tuple[object, ...] = ()
        if name != "world":
            how = (quality.tolerance_px(self._settings.tolerance_px),)
        if name == "image":
            how += (quality,)
        return drawn, self.words, style.enlarged(SCALES.get(quality.smoothing, 1)), *how

    def ahead(self, steps: Sequence[Shown]) -> Iterator[None]:
        """Draw what may be shown next, a piece at a time, and forget what was drawn so before.

        Parameters
        ----------
        steps : sequence of Shown
            Those of another scene than the one that is shown, with its quality.
        """
        for step in steps:
            self.adaptive.ahead(step.scene)
            yield
        style, drawn = self._style(), self.adaptive.drawn
        steps = [step for step in steps if self.adaptive.whole(step.scene) is not drawn]
        plan = [
            (pane, step, self._arguments(name, self.adaptive.whole(step.scene), style))
            for step in steps
            for name, pane in self._panes.items()
        ]
        for pane in self._panes.values():
            pane.ahead.keep(*(arguments for _, _, arguments in plan))
        for pane, step, arguments in plan:
            pane.ahead.draw(step, *arguments)
            yield

    def refine(self, name: str, smooth: bool) -> None:
        """Draw one pane smoothly, or as while something moves that is no change of the document."""
        smooth = smooth or not self.adaptive.software_rendering
        self._panes[name].set_smoothing(self.adaptive.smoothing(smooth))

    def rest(self) -> None:
        """Draw as well as can be, and bring back what has left a view: the hand rests."""
        self.adaptive.step(dragging=False)
        for pane in self._panes.values():
            pane.refit()

    @property
    def _turned(self) -> dict[str, Camera]:
        return cameras(self._panes)

    # -- theme and text

    def set_letters(self, letters: Letters) -> None:
        """Write the axes in a lecture's letters."""
        names = {"up": self.tr("up"), "eye": self.tr("eye"), "target": self.tr("target")}
        self.words |= names | axis_letters(letters)
        self.rebuild()

    def set_theme(self, theme: str) -> None:
        """Switch to ``"light"``, ``"dark"`` or ``"system"``."""
        self._settings.theme = theme
        dress(self._settings, self._screen_px)
        self.rebuild()

    def set_presenting(self, on: bool) -> None:
        """Write and draw for a class, or as ever."""
        self._screen_px = float(self._window.screen().size().height()) if on else 0.0
        dress(self._settings, self._screen_px)
        self.rebuild()

    def _scheme_changed(self) -> None:
        if self._settings.theme == "system":
            self.set_theme("system")
