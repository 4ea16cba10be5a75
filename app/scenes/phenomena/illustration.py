"""What a phenomenon is made of, and what it shows: plain data, no Qt and no VTK.

A phenomenon of the lectures is a scene with settings of its own and one function::

    show(projection, settings, subject) -> Illustration

The illustration holds the readout (numbers with their units), marks to draw over each pane, copies
of the scene under further matrices, diagrams beside the panes, and how the scene is rasterised. It
is made anew at every change, from the arguments alone, so that panes, panel, figures and tests all
show the same. `marks` defines what is drawn, `words` the texts, readout and diagrams.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from types import MappingProxyType
from typing import Any, Literal, NamedTuple

import numpy as np

from app.model.limits import vector
from app.model.parameter import ImpliedSettings, Parameter, Settings, number
from app.model.projection import LENSES, Array, Camera, Projection, Vector
from app.model.refusal import QT_TRANSLATE_NOOP
from app.scenes.phenomena.marks import Copy, Grip, Length, Marks, Rendering, Vertices
from app.scenes.phenomena.words import Diagram, PhenomenonWords, Phrase, Reading, value_of
from app.scenes.shapes import Coloured, letter_f_on_grid

_FREE = QT_TRANSLATE_NOOP(
    "phenomena", "a free matrix has no near, no far and no window: choose a lens to see this"
)


@dataclass(frozen=True, eq=False)
class Illustration:
    """What a phenomenon shows for one projection and one choice of its settings.

    - `warning`: why something cannot be shown at present.
    - `measured`: distances from the eye plane and their letters, which the flat views of the world
      measure. Unless there is a d among them, d is the target's.
    - `idle`: the phenomenon shows nothing, whatever its settings; `warning` says why.
    - `about`: names of `app.lecture.highlight` that are highlighted in all panes and panels until
      the user points at something else.
    """

    readings: tuple[Reading, ...]
    world: Marks = field(default_factory=Marks)
    ndc: Marks = field(default_factory=Marks)
    image: Marks = field(default_factory=Marks)
    copies: tuple[Copy, ...] = ()
    diagrams: tuple[Diagram, ...] = ()
    rendering: Rendering | None = None
    vertices: Vertices | None = None
    warning: Phrase | None = None
    grips: tuple[Grip, ...] = ()
    measured: tuple[tuple[str, float], ...] = ()
    lengths: tuple[Length, ...] = ()
    idle: bool = False
    about: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class OwnMesh:
    """The parts of a user's mesh that a phenomenon computes with, in world coordinates.

    - `edges` (m, 2, 3): the edges of its faces, each once, the longest first; of a large mesh only
      the longest.
    - `edge_count`: the number of all its edges.
    - `triangles` (t, 3, 3): as they are rasterised, those with the longest sides first; of a larger
      mesh only those.
    - `more_triangles`: whether it has more than these.
    - `surface` (s, 3, 3): all its triangles, simplified for a large mesh; empty unless its pixels
      are computed.
    """

    edges: Array
    edge_count: int
    triangles: Array
    more_triangles: bool = False
    surface: Array = field(default_factory=lambda: np.empty((0, 3, 3)))


@dataclass(frozen=True, eq=False)
class Subject:
    """The object of the scene, without the ground grid.

    - `lower`, `upper`: world bounds.
    """

    lower: Vector
    upper: Vector
    points: Array  # (n, 3): its vertices in world coordinates; a sample of those of a large mesh
    mesh: OwnMesh | None = None  # the user's mesh, if it replaces the built-in subject

    @property
    def size(self) -> float:
        """The diagonal of its bounds."""
        return math.dist(self.lower, self.upper)


class Shot(NamedTuple):
    """The direction from which a pane looks at the world; its distance follows from what is named.

    The azimuth is counted from +z towards +x, or likewise from where the model's camera stands: so
    a view from beside the camera goes with it.
    """

    azimuth_deg: float
    elevation_deg: float
    about: Literal["scene", "camera"] = "scene"


FIRST_SHOT = Shot(-66.0, 18.0, "camera")  # from beside the camera, so that near and far stand apart


@dataclass(frozen=True, eq=False, kw_only=True)
class Appearance:
    """How the panes draw a scene, and from where they look at it first.

    - `requires`: what drawings build for this scene beyond faces, lines and marks.
    - `leading`: the pane that shows it best: ``"world"``, ``"ndc"`` or ``"image"``.
    - `names`: the ids of the things that its pictures name, unless the document has a list of its
      own.
    - `inks`: the colours, fields of `Style`, of the lengths that a flat view measures, by their
      names.
    - `shot`: from where the world pane looks as the scene opens.
    - `upright`: likewise in a pane that is higher than wide, if another side shows more there.
    - `cube_side`: from where the cube is seen at first: degrees to the right of its near face, and
      upwards.
    - `fixed`: the fixed view of the world with which the scene opens; empty for the free one.
    - `leaves_out`: layers that the world pane leaves out and does not frame, as long as nothing of
      them is named: ``"frustum"``, ``"near-picture"``, ``"camera"``, ``"grid"``. A ``"subject"``
      that is much longer than the frustum is drawn, but not framed while near or far is named.
    - `pale`: the panes that draw the subject as a pale silhouette, because what is beside it
      matters more.
    """

    requires: frozenset[str] = frozenset()
    leading: str = "world"
    names: tuple[str, ...] = ()
    inks: Mapping[str, str] = field(default_factory=dict)
    shot: Shot = FIRST_SHOT
    upright: Shot | None = None
    cube_side: tuple[float, float] | None = None
    fixed: str = ""
    leaves_out: frozenset[str] = frozenset()
    pale: frozenset[str] = frozenset()


def _shot(text: str) -> Shot:
    azimuth_deg, elevation_deg, *about = text.split()
    return Shot(float(azimuth_deg), float(elevation_deg), "camera" if about else "scene")


def _numbers(text: str) -> tuple[float, ...]:
    return tuple(map(float, text.split()))


def _start(text: str) -> Projection:
    """Read eye, target, the lens with its numbers, and perhaps the image's size."""
    eye, target, lens, *size = text.split(" | ")
    kind, *numbers = lens.split()
    camera = Camera(vector(_numbers(eye)), vector(_numbers(target)))
    width_and_height: Any = (tuple(map(int, _numbers(each))) for each in size)
    return Projection(camera, LENSES[kind](*map(value_of, numbers)), *width_and_height)


_READ: dict[str, Callable[[str], Any]] = {
    **dict.fromkeys(
        ("lectures", "controls", "replaces", "names"), lambda text: tuple(text.split())
    ),
    **dict.fromkeys(("leaves_out", "pale", "requires"), lambda text: frozenset(text.split())),
    **dict.fromkeys(("shot", "upright"), _shot),
    **dict.fromkeys(("leading", "fixed", "clicked"), str),
    **dict.fromkeys(("own_mesh", "own_mesh_crosses"), lambda text: text == "yes"),
    "numbers": int,
    "inks": lambda text: dict(each.split("=") for each in text.split()),
    "cube_side": _numbers,
    "letter_f_on_grid": lambda text: map(_numbers, text.split(" | ")),
    "start": _start,
}
"""How the content file of a phenomenon states these fields: below the heading "Shown"."""


@dataclass(frozen=True, eq=False)
class Phenomenon(Appearance):
    """A phenomenon that the lectures name, as a scene.

    - `words`: its name and its texts.
    - `lectures`: the numbers of the lectures that show it, "000" to "004".
    - `start`: the camera and lens with which it opens.
    - `geometry`: ``geometry() -> (faces, lines)`` makes the scene.
    - `show`: ``show(projection, settings, subject) -> Illustration``.
    - `controls`: the model's controls that matter here: ``lens.near``, ``camera.distance``. With
      the settings there are 2 to 4 at a time.
    - `replaces`: the model's controls that the settings replace, such as the lens's ``preset``.
    - `clicked`: the setting, a point, that a click in the image puts where it picks; or empty.
    - `numbers`: how many readings are shown before the readout is unfolded.
    - `follow`: ``follow(projection, before, after)`` returns the projection for changed settings,
      where a setting moves the camera; `before` comes from `implied`.
    - `implied`: ``implied(projection, settings)`` returns the values that `follow` would need for
      this projection. Where several values give the same projection it keeps those in `settings`; a
      value is None, or not finite, where no value gives it.
    - `check`: raises a `Refusal` for settings that do not go together.
    - `own_mesh`: whether a user's mesh, scaled and moved into its bounds, can replace the built-in
      subject.
    - `own_mesh_crosses`: whether that mesh reaches beyond the bounds instead: as wide or as high as
      they are, its front where theirs is, and its right side a sixth of their width farther out.
    """

    words: PhenomenonWords
    lectures: tuple[str, ...]
    start: Projection
    geometry: Callable[[], tuple[Coloured, Coloured]]
    show: Callable[[Projection, Settings, Subject], Illustration]
    controls: tuple[str, ...] = ()
    replaces: tuple[str, ...] = ()
    clicked: str = ""
    numbers: int = 3
    follow: Callable[[Projection, ImpliedSettings, Settings], Projection] = lambda given, *_: given
    implied: Callable[[Projection, Settings], ImpliedSettings] = lambda *_: {}
    check: Callable[[Settings], None] = lambda _: None
    own_mesh: bool = False
    own_mesh_crosses: bool = False

    @classmethod
    def of(cls, words: PhenomenonWords, **computed: Any) -> "Phenomenon":
        """The phenomenon of a content file, with what is computed."""
        shown = {name: _READ[name](text) for name, text in words.shown.items()}
        if "letter_f_on_grid" in shown:
            computed["geometry"] = partial(letter_f_on_grid, *shown.pop("letter_f_on_grid"))
        return cls(words, **shown, **computed)

    @property
    def name(self) -> str:
        """The scene's name: ``similar-triangles``."""
        return self.words.name

    @property
    def settings(self) -> tuple[Parameter, ...]:
        return tuple(self.words.settings.values())

    def illustration(
        self, projection: Projection, settings: Settings, subject: Subject
    ) -> Illustration:
        """The illustration, or only a warning for a free matrix, which has no lens to show."""
        if is_free(projection):
            return Illustration((), warning=Phrase(_FREE), idle=True)
        return self.show(projection, settings, subject)

    def at_hand(self, projection: Projection, settings: Settings) -> ImpliedSettings:
        """Return all settings as camera and lens imply them, perhaps out of a setting's bounds.

        For a free matrix the settings stay as they were chosen.
        """
        if is_free(projection):
            return settings
        implied = dict(self.implied(projection, settings))
        for setting in self.settings:
            value = implied.get(setting.name)
            if isinstance(value, float):
                implied[setting.name] = setting.rounded(value, number(settings, setting.name))
        return {**settings, **implied}

    def changed(
        self, projection: Projection, settings: Settings, values: Mapping[str, Any]
    ) -> tuple[Projection, Settings]:
        """Choose some settings; returns the projection for them, and all settings then.

        The other settings take the values that camera and lens have now. A value that was chosen
        before, but no longer holds, can be chosen again.

        Raises a `Refusal` if the scene cannot have these values, or no projection fits them.
        """
        at_hand = self.at_hand(projection, settings)
        # A setting that is not changed here keeps its value if its implied value cannot be chosen.
        changed = {name: at_hand.get(name) for name in values}
        before = {**self._possible(at_hand, settings), **changed}
        after = self.checked({**before, **values})
        if after == before:
            return projection, settings
        projection = self.follow(projection, before, after)
        if None in before.values():  # `follow` has also corrected the others
            after = self.checked(self._possible(self.at_hand(projection, after), after))
        return projection, after

    def _possible(self, at_hand: ImpliedSettings, chosen: Settings) -> Settings:
        """The implied values that can be chosen, and the chosen ones in place of the others."""
        values = {**chosen}
        for setting in self.settings:
            value = at_hand[setting.name]
            if value is not None and setting.can_be(value):
                values[setting.name] = value
        return values

    def checked(self, values: Mapping[str, Any]) -> Settings:
        """Complete the settings with their defaults, and check them.

        Raises a `Refusal` for a value that its setting cannot have, and for values that do not go
        together.
        """
        settings = MappingProxyType(
            {each.name: each.checked(values.get(each.name, each.default)) for each in self.settings}
        )
        self.check(settings)
        return settings


def is_free(projection: Projection) -> bool:
    """Whether a typed matrix replaces the lens."""
    return projection.lens.former is not projection.lens
