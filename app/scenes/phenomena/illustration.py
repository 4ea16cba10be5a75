"""What a phenomenon is made of, and what it shows: plain data, no Qt and no VTK.

A phenomenon of the lectures is a scene with settings of its own and one function::

    show(projection, settings, subject) -> Illustration

The illustration holds the readout (numbers with their units), marks to draw over each pane, copies
of the scene under further matrices, diagrams beside the panes, and how the scene is to be
rasterised. It is made anew at every change, from nothing but the arguments, so that panes, panel,
figures and tests all show the same. Marks are few: what follows every vertex is a matrix (`Copy`)
or the rasteriser's own work (`Rendering`).
"""

from __future__ import annotations

import math
import numbers
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, TypeAlias

import numpy as np

from app.model.depth import DepthBuffer
from app.model.limits import finite, finite_vector, within
from app.model.projection import ONE_OF, Array, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.scenes.shapes import Coloured, Vector

Value: TypeAlias = float | bool | str | Vector
Settings: TypeAlias = Mapping[str, Value]
"""The value of each `Setting` of a phenomenon, by its name; complete and checked."""
Found: TypeAlias = Mapping[str, Value | None]
"""Likewise, as camera and lens have them; None where they are as no value makes them."""

CLOSE = 1e-7
"""Of a number, or of its slider's length: nearer to the one that was chosen, it is that one."""

WHOLE = QT_TRANSLATE_NOOP("Refusal", "must be a whole number")
YES_OR_NO = QT_TRANSLATE_NOOP("Refusal", "must be true or false")


_FREE = QT_TRANSLATE_NOOP(
    "phenomena", "a free matrix has no near, no far and no window: choose a lens to see this"
)


@dataclass(frozen=True)
class Phrase:
    """A sentence with values in it, to be translated before they are filled in.

    Attributes
    ----------
    template : str
        Marked with ``QT_TRANSLATE_NOOP("phenomena", ...)``; ``{0}``, ``{1}`` for the values.
    values : tuple of str or float
    """

    template: str
    values: tuple[str | float, ...] = ()

    def sentence(
        self,
        translate: Callable[[str], str] = str,
        write: Callable[[float], str] = lambda value: figure(value, 4),
    ) -> str:
        """The sentence in another language, with its numbers as they are written there."""
        values = (value if isinstance(value, str) else write(value) for value in self.values)
        return translate(self.template).format(*values)


# --------------------------------------------------------------------------- settings


@dataclass(frozen=True)
class Setting:
    """One thing that can be changed about a phenomenon, beside camera and lens.

    What it is follows from its default: a bool is a switch, a str one of `choices`, a tuple a
    point or direction of the world, a float a number with a slider.

    Attributes
    ----------
    name : str
        In the document, ``settings.NAME``.
    label, tip : str
        For the control; translatable.
    default : float, bool, str or tuple of 3 floats
    low, high : float
        Bounds of a number, included.
    span : (float, float), optional
        What the slider covers, within the bounds; all of them if not given.
    unit : str
    choices : tuple of (str, str)
        Values of a choice and their translatable labels.
    logarithmic, whole : bool
        Of a number: whether its slider runs over powers; whether it counts.
    per_second : float
        How fast a number moves while it is played; 0 if it is not.
    only_with : (str, value), optional
        Another setting's name, and the value of it without which this one has no effect.
    """

    name: str
    label: str
    tip: str
    default: Value
    low: float = -math.inf
    high: float = math.inf
    span: tuple[float, float] | None = None
    unit: str = ""
    choices: tuple[tuple[str, str], ...] = ()
    logarithmic: bool = False
    whole: bool = False
    per_second: float = 0.0
    only_with: tuple[str, Value] | None = None

    @property
    def path(self) -> str:
        """Where the document holds it."""
        return f"settings.{self.name}"

    def checked(self, value: Any) -> Value:
        """The value as its type wants it.

        Raises
        ------
        Refusal
            If it is of another kind, or out of bounds.
        """
        if isinstance(self.default, bool):
            if not isinstance(value, bool):
                raise Refusal(self.path, value, YES_OR_NO)
            return value
        if isinstance(self.default, str):
            known = [name for name, _ in self.choices]
            if value not in known:
                raise Refusal(self.path, value, ONE_OF, ", ".join(known))
            return str(value)
        if isinstance(self.default, tuple):
            return finite_vector(self.path, value)
        number = within(self.path, finite(self.path, value), self.low, self.high)
        if self.whole and not number.is_integer():
            raise Refusal(self.path, number, WHOLE)
        return number

    def can_be(self, value: Value | None) -> bool:
        """Whether this is a value for it."""
        try:
            self.checked(value)
        except Refusal:
            return False
        return True

    def rounded(self, value: float, chosen: float) -> float | None:
        """A number that was found, without rounding errors if it is the one that was chosen."""
        if not math.isfinite(value):
            return None
        low, high = self.span or (self.low, self.high)
        slack = CLOSE * (high - low) if math.isfinite(high - low) else 0.0
        if math.isclose(value, chosen, rel_tol=CLOSE, abs_tol=slack):
            return chosen
        return float(f"{value:.12g}")


# --------------------------------------------------------------------------- what is shown


@dataclass(frozen=True)
class Reading:
    """One line of the readout.

    Attributes
    ----------
    label : str
        Translatable; letters as in the lectures.
    value : float, tuple of floats, str or None
        A str is a translatable word; None if there is none, and `note` says why.
    unit : str
        ``"px"``, ``"°"``, ``"%"``, ``"×"``, or empty for world units.
    note : Phrase, optional
    about : tuple of str
        What it speaks of, by the names of `app.lecture.highlight`: it stands out with that.
    cell : int, optional
        Of a matrix, which of its cells, counted row by row, speaks of that; without it all do.
    counted : bool
        Whether the value is not computed but counted in the picture's pixels, by somebody who can
        draw; until then it is None. `note` says why, if there turns out to be nothing to count.
    """

    label: str
    value: float | tuple[float, ...] | str | None
    unit: str = ""
    note: Phrase | None = None
    counted: bool = False
    about: tuple[str, ...] = ()
    cell: int | None = None


@dataclass(frozen=True, eq=False)
class Line:
    """A polyline.

    Attributes
    ----------
    points : (k, 3) array, or (k, 2) in image pixels
    colour : str
    width : float
        In ordinary lines.
    about : tuple of str
        In the world: what it stands out with, as of `Reading`.
    """

    points: Array
    colour: str = "ink"
    width: float = 1.0
    about: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Face:
    """A flat convex polygon, translucent, seen from both sides; (k, 3), or (k, 2) in pixels."""

    points: Array
    colour: str = "accent"
    opacity: float = 0.3


@dataclass(frozen=True, eq=False)
class Dot:
    """A round point of `size` ordinary dots; `point` is (3,), or (2,) in pixels."""

    point: Array
    colour: str = "accent"
    size: float = 1.0


@dataclass(frozen=True, eq=False)
class Text:
    """A few letters beside a point.

    Attributes
    ----------
    text : str
    point : (3,) array, or (2,) in image pixels
    colour : str
        Of its plate, if it has one.
    about : tuple of str
        As of `Line`.
    away_from : array like `point`, optional
        In world and NDC, a point that they are rather not towards: the middle of what has an edge
        here, or what a curve bends away from.
    """

    text: str
    point: Array
    colour: str = ""
    about: tuple[str, ...] = ()
    away_from: Array | None = None


@dataclass(frozen=True, eq=False)
class Grip:
    """Where a setting that is a point or a direction is taken hold of in the world pane.

    Attributes
    ----------
    setting : str
        Its name.
    point : (3,) array
        World coordinates.
    base : tuple of 3 floats
        The setting is ``point - base``: 0 for a point, where it is held from for a direction.
    """

    setting: str
    point: Array
    base: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Length:
    """What one of the world's flat views measures across the axis, beside the distances along it.

    Attributes
    ----------
    view : str
        ``"side"`` or ``"top"``.
    name : str
        Its letter.
    value : float
        With its sign.
    start, end : (3,) array
        World coordinates, parallel to the screen there.
    """

    view: str
    name: str
    value: float
    start: Array
    end: Array


@dataclass(frozen=True, eq=False)
class Marks:
    """What is drawn over one pane.

    Colours are names of `app.drawings.style.Style` (``"near"``, ``"accent"``, ``"u"``, ...) or
    ``"#rrggbb"``. In the world pane points are world coordinates, in the NDC pane NDC, in the
    image pane pixels of the image.
    """

    lines: tuple[Line, ...] = ()
    faces: tuple[Face, ...] = ()
    dots: tuple[Dot, ...] = ()
    texts: tuple[Text, ...] = ()


@dataclass(frozen=True, eq=False)
class Copy:
    """The scene's faces once more, under a further 4x4.

    Attributes
    ----------
    world_from_world : (4, 4) array
        Applied to the scene's world coordinates first; may be projective, and singular (a shadow).
    panes : tuple of {"world", "ndc", "image"}
    colour : str
        Of all faces; empty for their own.
    """

    world_from_world: Array
    panes: tuple[str, ...] = ("world",)
    colour: str = ""


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve of a diagram: (n, 2) points in the diagram's units, NaN where it is broken."""

    points: Array
    colour: str = "ink"
    label: str = ""
    width: float = 1.0
    closed: bool = False
    dots: bool = False


@dataclass(frozen=True, eq=False)
class Spot:
    """A point of a diagram that has a name, and can be chosen if it has a key.

    Attributes
    ----------
    x, y : float
        In the diagram's units.
    name : str
        Written beside it, where there is room; it is in `tip` too.
    key : str
        What is told when it is clicked; empty if it cannot be chosen.
    tip : str
    colour : str
    faded : bool
        Whether there is better: dot and name step back.
    marked : bool
        Whether it is the present choice.
    broken : bool
        Whether it is where something ends: a cross instead of a dot.
    """

    x: float
    y: float
    name: str = ""
    key: str = ""
    tip: str = ""
    colour: str = "ink"
    faded: bool = False
    marked: bool = False
    broken: bool = False


@dataclass(frozen=True, eq=False)
class Diagram:
    """A small picture or chart beside the panes.

    Attributes
    ----------
    title : str
        Translatable.
    curves : tuple of Curve
    x_label, y_label : str
        Translatable; empty for none.
    left, right, bottom, top : float
        Its window; with `bottom` greater than `top` y runs down, as in an image.
    x_log, y_log : bool
    equal : bool
        Whether both axes have the same scale, as in a picture; a picture whose axes have no
        names has no numbers either.
    x_ticks, y_ticks : (n,) arrays, optional
        Where lines are drawn across: the codes of a depth buffer.
    spots : tuple of Spot
        Drawn over the curves; those named first get the better places.
    """

    title: str
    curves: tuple[Curve, ...]
    left: float
    right: float
    bottom: float
    top: float
    x_label: str = ""
    y_label: str = ""
    x_log: bool = False
    y_log: bool = False
    equal: bool = False
    x_ticks: Array | None = None
    y_ticks: Array | None = None
    spots: tuple[Spot, ...] = ()


@dataclass(frozen=True, eq=False)
class Texture:
    """A checkerboard laid over the scene's faces by a parallel projection of its own.

    Attributes
    ----------
    texture_from_world : (2, 4) array
        The texture's s and t of a world point; 0 to 1 across the board.
    checks : int
        Along each side.
    affine : bool
        Interpolate s and t linearly on the screen, without the divide that makes them right.
    subdivision : int
        Each face is drawn as the triangles of so many parts a side.
    coordinates : bool
        Show s as red and t as green instead of the checks.
    """

    texture_from_world: Array
    checks: int
    affine: bool = False
    subdivision: int = 1
    coordinates: bool = False


@dataclass(frozen=True)
class Fog:
    """What is far fades into the background.

    Attributes
    ----------
    start, end : float
        Distances from the eye plane between which it thickens, linearly.
    density : float
        If greater than 0, what is left falls as ``exp(-density w)`` instead.
    """

    start: float = 0.0
    end: float = math.inf
    density: float = 0.0

    def left(self, distance: float) -> float:
        """The part of a colour's contrast to the background that is left at a distance, 0..1."""
        if self.density > 0.0:
            return math.exp(-self.density * max(distance, 0.0))
        return min(max((self.end - distance) / (self.end - self.start), 0.0), 1.0)


@dataclass(frozen=True, eq=False)
class Level:
    """One level of detail of the scene's objects.

    Attributes
    ----------
    faces : Coloured
    objects : (m, 3) array
        The place, in world coordinates, of the object that each face is a part of.
    until : float
        Distance of that place from the eye plane from which the next level is drawn.
    """

    faces: Coloured
    objects: Array
    until: float


@dataclass(frozen=True, eq=False)
class Rendering:
    """How the scene is rasterised, where it is not the ordinary way.

    Attributes
    ----------
    buffer : DepthBuffer, optional
        The picture's depths are rounded to the codes of this one.
    texture : Texture, optional
    fog : Fog, optional
    levels : tuple of Level
        Drawn in place of the scene's faces: three of them, nearest first, or none. Their faces
        are those of the first time.
    """

    buffer: DepthBuffer | None = None
    texture: Texture | None = None
    fog: Fog | None = None
    levels: tuple[Level, ...] = ()


@dataclass(frozen=True, eq=False)
class Illustration:
    """What a phenomenon shows for one projection and one choice of its settings.

    Attributes
    ----------
    readings : tuple of Reading
    world, ndc, image : Marks
    copies : tuple of Copy
    diagrams : tuple of Diagram
    rendering : Rendering, optional
    warning : Phrase, optional
        Why something cannot be shown as things are.
    grips : tuple of Grip
    measured : tuple of (str, float)
        Distances from the eye plane that the scene has letters for: what the flat views of the
        world measure. Without one of its own, d is the target's.
    lengths : tuple of Length
    idle : bool
        Whether nothing of the phenomenon is shown, whatever its settings; `warning` says why.
    about : tuple of str
        What it is about just now, by the names of `app.lecture.highlight`: it stands out in all
        panes and panels, until somebody points at something else.
    """

    readings: tuple[Reading, ...]
    world: Marks = field(default_factory=Marks)
    ndc: Marks = field(default_factory=Marks)
    image: Marks = field(default_factory=Marks)
    copies: tuple[Copy, ...] = ()
    diagrams: tuple[Diagram, ...] = ()
    rendering: Rendering | None = None
    warning: Phrase | None = None
    grips: tuple[Grip, ...] = ()
    measured: tuple[tuple[str, float], ...] = ()
    lengths: tuple[Length, ...] = ()
    idle: bool = False
    about: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class OwnMesh:
    """Of a mesh of the user's what a phenomenon reckons edge by edge, in world coordinates.

    Attributes
    ----------
    edges : (m, 2, 3) array
        Of its faces, each once, the longest first; of a large mesh only those.
    edge_count : int
        How many it has, all of them.
    triangles : (t, 3, 3) array
        As they are rasterised, those with the longest sides first; of a larger mesh only those.
    more_triangles : bool
        Whether it has more than these.
    surface : (s, 3, 3) array
        All of its triangles, those of a large mesh brought together to fewer; none where its
        pixels are not reckoned.
    """

    edges: Array
    edge_count: int
    triangles: Array
    more_triangles: bool = False
    surface: Array = field(default_factory=lambda: np.empty((0, 3, 3)))


@dataclass(frozen=True, eq=False)
class Subject:
    """What is looked at, without the ground grid.

    Attributes
    ----------
    lower, upper : tuple of 3 floats
        World bounds.
    points : (n, 3) array
        Its vertices in world coordinates; those of a large mesh are sampled.
    mesh : OwnMesh, optional
        If it is the user's, in the place of the built-in subject.
    """

    lower: Vector
    upper: Vector
    points: Array
    mesh: OwnMesh | None = None


def _keep(projection: Projection, _before: Found, _after: Settings) -> Projection:
    return projection


def _nothing(_projection: Projection, _settings: Settings) -> Found:
    return {}


def _any(_settings: Settings) -> None:
    """Every combination of settings can be shown."""


@dataclass(frozen=True)
class Comparison:
    """Pictures of a phenomenon that belong side by side.

    Attributes
    ----------
    name : str
        In the document's words: ``view.compare=NAME``.
    pictures : tuple of (str, tuple of str)
        From left to right: what each is called, translatable, and what it has for itself, as
        ``--set`` has it: ``"settings.preset=wide"``. They follow the document in all else. The
        document is one of them, the last if it is none of them yet.
    """

    name: str
    pictures: tuple[tuple[str, tuple[str, ...]], ...]


@dataclass(frozen=True, eq=False)
class Phenomenon:
    """A phenomenon that the lectures name, as a scene.

    Attributes
    ----------
    name : str
        Of the scene: ``similar-triangles``.
    title, explanation : str
        Translatable; the explanation is two or three sentences.
    lectures : tuple of str
        Numbers of those that it is from, "000" to "004".
    start : Projection
        From where it is best seen.
    geometry : callable
        Makes the faces and the lines of the scene: ``geometry() -> (faces, lines)``.
    show : callable
        ``show(projection, settings, subject) -> Illustration``.
    settings : tuple of Setting
    controls : tuple of str
        The model's controls that matter here: ``lens.near``, ``camera.distance``. With the settings
        there are 2 to 4 at a time.
    replaces : tuple of str
        The model's controls whose work settings do here, so that none is there twice: the lens's
        ``preset``.
    tries : tuple of 3 str
        Translatable: what to try, in short imperatives and questions.
    numbers : int
        How many readings are seen without being unfolded.
    follow : callable
        ``follow(projection, before, after)``: the projection that goes with changed settings,
        where a setting moves the camera; before it is what `found` found.
    found : callable
        ``found(projection, settings)``: those settings that `follow` follows, as camera and lens
        have them, which may be moved without the settings. Of several values with one outcome
        those in `settings`; None, or no number, where it is no value's outcome.
    check : callable
        Raises a `Refusal` for settings that do not go together.
    requires : frozenset of str
        What drawings build for this scene beyond faces, lines and marks.
    leading : str
        The pane that shows it best: ``"world"``, ``"ndc"`` or ``"image"``.
    own_mesh : bool
        Whether a mesh of the user's can take the place of the built-in subject: scaled and moved
        into its bounds.
    own_mesh_crosses : bool
        Whether that mesh is rather to reach beyond the bounds: as wide or as high as they are,
        its front where theirs is, and its right side a sixth of their width farther out.
    comparisons : tuple of Comparison
        Those that the lectures make.
    """

    name: str
    title: str
    explanation: str
    lectures: tuple[str, ...]
    start: Projection
    geometry: Callable[[], tuple[Coloured, Coloured]]
    show: Callable[[Projection, Settings, Subject], Illustration]
    settings: tuple[Setting, ...] = ()
    controls: tuple[str, ...] = ()
    replaces: tuple[str, ...] = ()
    tries: tuple[str, ...] = ()
    numbers: int = 3
    follow: Callable[[Projection, Found, Settings], Projection] = _keep
    found: Callable[[Projection, Settings], Found] = _nothing
    check: Callable[[Settings], None] = _any
    requires: frozenset[str] = frozenset()
    leading: str = "world"
    own_mesh: bool = False
    own_mesh_crosses: bool = False
    comparisons: tuple[Comparison, ...] = ()

    @property
    def defaults(self) -> Settings:
        """The settings with which it opens."""
        return MappingProxyType({setting.name: setting.default for setting in self.settings})

    def illustration(
        self, projection: Projection, settings: Settings, subject: Subject
    ) -> Illustration:
        """What is shown; of a free matrix, that has no lens to show it with, only that."""
        if is_free(projection):
            return Illustration((), warning=Phrase(_FREE), idle=True)
        return self.show(projection, settings, subject)

    def at_hand(self, projection: Projection, settings: Settings) -> Found:
        """All settings as camera and lens have them, perhaps beyond the bounds of what is chosen.

        A free matrix has none, and leaves all as they were chosen.
        """
        if is_free(projection):
            return settings
        found = dict(self.found(projection, settings))
        for setting in self.settings:
            value = found.get(setting.name)
            if isinstance(value, float):
                found[setting.name] = setting.rounded(value, number(settings, setting.name))
        return {**settings, **found}

    def changed(
        self, projection: Projection, settings: Settings, values: Mapping[str, Any]
    ) -> tuple[Projection, Settings]:
        """Choose some settings: the projection that goes with them, and all settings then.

        What camera and lens have of the others is chosen with them. A value that was chosen once
        and holds no more can be chosen again.

        Raises
        ------
        Refusal
            If the scene cannot have them, or no projection goes with them.
        """
        found = self.at_hand(projection, settings)
        # What nobody asks for stays, on both sides, where it cannot be chosen as it is.
        before = {**self._possible(found, settings), **{name: found.get(name) for name in values}}
        after = self.checked({**before, **values})
        if after == before:
            return projection, settings
        projection = self.follow(projection, before, after)
        if None in before.values():  # what was off goes with others now, which it has put right
            after = self.checked(self._possible(self.at_hand(projection, after), after))
        return projection, after

    def _possible(self, found: Found, chosen: Settings) -> Settings:
        """What was found, and what had been chosen where that is no value to choose."""
        values = {**chosen}
        for setting in self.settings:
            value = found[setting.name]
            if value is not None and setting.can_be(value):
                values[setting.name] = value
        return values

    def checked(self, values: Mapping[str, Any]) -> Settings:
        """Complete and check settings.

        Raises
        ------
        Refusal
            For a value that one of them cannot have, and for values that do not go together.
        """
        settings = MappingProxyType(
            {
                setting.name: setting.checked(values.get(setting.name, setting.default))
                for setting in self.settings
            }
        )
        self.check(settings)
        return settings


def is_free(projection: Projection) -> bool:
    """Whether a matrix was typed in the place of the lens that a phenomenon is shown with."""
    return projection.lens.former is not projection.lens


def of_parallel(projection: Projection, template: str) -> Phrase | None:
    """What is to be said of a lens whose projectors do not meet in an eye, if it is one."""
    return None if projection.lens.central else Phrase(template)


def figure(value: float, digits: int) -> str:
    """A number for a mark or a sentence, with the minus of the readouts."""
    return f"{value + 0.0:.{digits}g}".replace("-", "−")


def number(settings: Found, name: str) -> float:
    """A setting that is a number."""
    value = settings[name]
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(name)
    return float(value)


def point(settings: Settings, name: str) -> Vector:
    """A setting that is a point or a direction."""
    value = settings[name]
    if not isinstance(value, tuple):
        raise TypeError(name)
    return value
