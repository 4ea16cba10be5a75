"""The interface of the three drawings, for panes, figures, mouse and keyboard."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from app.lecture.highlight import Highlight
from app.lecture.stages import standing_at
from app.model.chain import Chain
from app.model.projection import Array, Camera, Projection, Vector
from app.model.refusal import Refusal
from app.picking.handles import Handle, Spot
from app.picking.picking import Probe, carried
from app.picking.sight import Sight
from app.precision.levels import Precision
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.words import Phrase
from app.scenes.scene import Scene

if TYPE_CHECKING:
    from app.drawings.labels import Board
    from app.drawings.layer import Layers, PaneState
    from app.drawings.own_view import OwnView
    from app.drawings.pane_view import Pose
    from app.drawings.pointing import Names
    from app.drawings.stage_view import StageView


LABELS_FROM = 0.6  # part of a way from which on labels fade in


def light_of_labels(part: float) -> float:
    """Return the opacity of labels at a part of a way, 0 to 1."""
    return max(0.0, (part - LABELS_FROM) / (1.0 - LABELS_FROM))


class Rectangle(NamedTuple):
    """A rectangle of whole device pixels, from the pane's top left."""

    left: int
    top: int
    width: int
    height: int


class Taken(NamedTuple):
    """What the pointer takes: a handle, the world point (3,) grabbed, and what is highlighted."""

    handle: Handle
    point: Array
    about: Highlight


class Handles:
    """The handles of a pane: only a live pane has any.

    `held` is highlighted, and stays visible while it moves. `shown` are those with a grip, with
    their pixels from the pane's top left. `planes_drawn` are the distances from the eye plane at
    which near and far are drawn; (0, 1) without planes. `has_object` if the object shows its axes,
    which have handles.
    """

    held: Handle | None = None
    shown: Sequence[tuple[Handle, Spot]] = ()
    planes_drawn = 0.0, 1.0
    has_object = False

    def call(self, names: frozenset[str]) -> None:
        """Show the handles with these names or settings, though nothing is on them."""

    def rest(self, paths: tuple[str, ...] | None) -> None:
        """Show the handles of these values of a document at rest; None for the scene's controls."""

    def hold(self, handle: Handle | None) -> None:
        """Highlight a handle, and no other one."""

    def at(self, pixel: Spot) -> Taken | None:
        """What the pointer would take at a pixel: a point, an edge, a label, or a face."""
        return None


class Drawing:
    """The scene in one pane: `WorldDrawing`, `StageDrawing` or `ImageDrawing`, a list of layers.

    A drawing is made once per scene, ``Drawing(screen, scene, words, style)``, in a render window
    that it does not own. It never renders: the caller does, after any number of changes. A method
    here does what the drawings have in common, or nothing where one alone has such a thing.

    A new drawing names what its scene names (`app.document.naming`).
    """

    pane: ClassVar[str]  # one of `app.document.view.PANES`
    refines: ClassVar[bool] = False  # whether it draws by itself, off the screen
    board: "Board"
    names: "Names"
    handles = Handles()
    state: "PaneState"
    layers: "Layers"
    own: "OwnView | StageView | None" = None
    fit = "named"  # what the world frames, as in `Figure`
    _probes: Sequence[Probe] = ()
    former: Chain | None = None  # the object's moves before an edit, which are shown pale
    _way: tuple[Chain, Chain] | None = None  # the whole chain and the moves made, if they differ

    # -- the model

    def show_projection(
        self, projection: Projection, illustration: Illustration | None = None
    ) -> None:
        """Set the model's matrices and show a phenomenon's marks, instead of earlier ones."""

    def show_moves(
        self,
        projection: Projection,
        illustration: Illustration | None,
        stage: float,
        *,
        from_left: bool = False,
    ) -> None:
        """Show the projection at a position of the stage strip; the object may be on its way."""
        standing, beside = projection, tuple[Chain, ...]()
        if stage < 0.0 and projection.placement.on:
            standing, beside = standing_at(projection, stage, from_left=from_left)
        way = (projection.placement, standing.placement) if beside else None
        is_carried = way != self._way
        self._way = way
        self.state.from_left = from_left and bool(projection.placement.on)
        self.state.ghosts = (*beside, self.former) if self.former else beside
        self.show_projection(standing, illustration)
        if is_carried:
            self.show_probes(self._probes)

    def show_detail(self, fewer: Scene | None) -> None:
        """Use the faces of a scene with fewer triangles; None for all. Then show a projection."""
        self.layers.show_detail(fewer)

    def show_layers(self, hidden: frozenset[str]) -> None:
        """Hide these of `app.document.view.LAYERS`, and no others. Then show a projection."""

    def show_names(self, names: frozenset[str] | None) -> None:
        """Name these things, and no others; None for everything.

        What is highlighted or held is named, too.
        """

    def show_probes(self, probes: Sequence[Probe]) -> None:
        """Mark these probes, and no others."""
        self._probes = probes
        self.state.probes = [carried(each, *self._way) for each in probes] if self._way else probes
        self.layers.settle()
        self.layers.place_labels()

    def show_highlight(self, highlighted: Highlight) -> bool:
        """Highlight these things, and nothing else; return whether anything has changed."""
        before, self.names.pointed = self.names.pointed, highlighted
        of_scene = self.layers.show_highlight(highlighted)
        is_new = self.state.emphasis.show(highlighted) or of_scene
        if self.state.renames(before ^ highlighted, of_scene):
            self._show_named()
        return is_new

    def _show_named(self) -> None:
        """Show what is named now, and place its labels."""

    @property
    def precision(self) -> Precision:
        return "float32"

    # -- the pane's own camera

    @property
    def sight(self) -> Sight:
        """How the pane looks at the world now, for picking."""
        return self.state.sight

    def spots_of(self, places: Array) -> Array:
        """Return the pixels (n, 2) of places, from the pane's top left; NaN for a hidden one.

        Places are in world coordinates, in the NDC pane in NDC, in the image in its pixels (n, 2).
        """
        return self.sight.seen(places)

    @property
    def view(self) -> Camera | None:
        """Where the user has moved the pane's camera; None if it was not moved."""
        return None if self.own is None else self.own.view

    def show_view(self, view: Camera) -> None:
        """Move the pane's camera back to an earlier `view`."""
        if self.own is not None:
            self.own.show(view)
            self.reset_clipping_range()

    def reset_view(self) -> None:
        """Place the pane's camera so that everything is in view."""
        self.layers.place_labels(afresh=True)

    def refit(self) -> bool:
        """Frame again what has left a view that the user has not moved.

        Call it when a gesture ends. Return whether the pane has to be painted again.
        """
        return self.layers.place_labels(at_rest=True)

    def cut(self) -> dict[str, float]:
        """What has to be inside the pane and lies outside: names, and by how many pixels."""
        return {}

    def reset_clipping_range(self, *, afresh: bool = True) -> None:
        """Adjust the drawing after the pane's camera was moved from outside.

        If not `afresh`, labels stay beside what they name, until the movement ends.
        """

    # -- on the way from one state to another

    def begin_glide(self, start: "Pose") -> None:
        if self.own is not None:
            self.own.begin_glide(start)

    def glide(self, part: float) -> None:
        """Be at a part of the way, 0 to 1: the labels appear near its end."""
        self.state.canvas.fade_labels(light_of_labels(part))
        self.layers.place_labels(afresh=part == 1.0)

    def remove(self) -> None:
        """Take everything out of the screen."""
        self.state.canvas.remove()

    # -- the stage strip

    def show_stage(self, position: float) -> None:
        """Move to a position of the stage strip, 0 to 5."""

    def hold(self, handle: Handle | None) -> None:
        """Highlight a handle, and keep it visible while it moves."""
        self.handles.hold(handle)

    # -- the world

    @property
    def fixed(self) -> str:
        """The fixed view, one of `app.document.view.FIXED`; ``""`` for the free one."""
        return ""

    def show_fixed(self, view: str) -> None:
        """Look from one of `app.document.view.FIXED`; ``""`` for the free view."""

    def show_step(self, step: int | None) -> None:
        """Build the camera's frame up to a step of `app.lecture.camera_frame.STEPS`."""

    def show_object_axes(self, wanted: bool) -> None:
        """Show the object's axes even where they coincide with the world's."""

    def show_walk(self, eyes: Sequence[Vector]) -> None:
        """Show the way of the eye while the camera walks, through these places; none for none."""

    # -- the image

    def rectangle_in(self, pane_width_px: int, pane_height_px: int) -> Rectangle:
        """Return where the picture would lie in a pane of this size."""
        return Rectangle(0, 0, pane_width_px, pane_height_px)

    @property
    def picture_rectangle_px(self) -> Rectangle:
        """Where the picture lies in the pane now; all of the pane if it is no image."""
        return self.rectangle_in(*self.state.canvas.window.GetSize())

    def image_pixel(self, x_px: float, y_px: float) -> tuple[float, float] | None:
        """Return the image's pixel at a pixel of the pane; None beside the picture."""
        return None

    def image_shift(self, right_px: float, down_px: float) -> tuple[float, float]:
        """Convert a movement from the pane's pixels to the image's."""
        return right_px, down_px

    @property
    def is_coarse(self) -> bool:
        """Whether `refine` would improve the picture, which can only be if it `refines`."""
        return False

    def refine(self, *, whole: bool = False) -> None:
        """Improve a coarse picture for some milliseconds, or fully if `whole`.

        It draws, but not in the drawing's own window: that has to be rendered afterwards.
        """

    @property
    def problem(self) -> Phrase | None:
        """Why the picture is not rasterised as the phenomenon asks; known after a rendering."""
        return None

    @property
    def refused_depth(self) -> Refusal | None:
        """Why the picture does not have the depth buffer that was chosen."""
        return None
