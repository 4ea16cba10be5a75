"""The view of a document: everything a lecturer arranges besides the model and finds again.

The view is not part of the model: changing it creates neither an undo step nor unsaved work.
"""

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Any

from app.document.compare import ComparedPicture, check_pictures
from app.lecture.camera_frame import STEPS
from app.lecture.letters import LETTERS, Letters, lettering
from app.lecture.stages import IMAGE, NDC
from app.model.chain import MOST_TILES
from app.model.infinity import homogeneous
from app.model.limits import Row, check_name, finite_vector, is_number, keep_checked, real, within
from app.model.projection import LARGEST_IMAGE_PX, Camera
from app.model.refusal import REFUSALS, Refusal
from app.picking.picking import Probe

LAYOUTS = ("pictures", "columns")  # one large pane and two small ones, or three side by side
PANES = ("world", "ndc", "image")  # the panes, from left to right
STAGES = ("world", "view", "pyramid", "box", "ndc", "image")
"""The stops of the stage strip, as a document names them."""
PANELS = ("matrices", "frame", "kinds", "probe", "scene", "measure")  # the panels of the drawer
LAYERS = ("labels", "handles", "grid", "frustum", "camera", "near-picture")
"""The layers of the world that can be hidden."""
FIXED = ("side", "top", "axis", "eye")  # the fixed viewpoints of the world
SLIDES = (*PANES, "equation", "kinds")
"""What can be the slide that a class sees: panes, an equation, the tree of projections."""
STRIP = "stage"  # the name of the stage strip among the controls of a slide
MOST_ON_SLIDE = 2  # most pictures of a slide, and most controls below it
MOST_PROBES = 6  # most probes: more cannot be compared at a glance
MOST_NAMES = 7  # most names of a view: a picture with more of them has no point
EVERYTHING = ("*",)  # the names of a view that names everything


@dataclass(frozen=True)
class View:
    """The view of a document; an invalid value raises a `Refusal`."""

    layout: str = "pictures"
    large: str = ""  # the pane in the large slot; empty for the one that the scene chooses
    stage: float = float(NDC)
    """Position on the stage strip: whole at each of `STAGES`, below 0 during the object's moves."""
    frame_step: str = STEPS[0]  # the step up to which the camera's frame is built
    panel: str | None = None  # the drawer's open panel; empty for none, None for the scene's
    letters: Letters = LETTERS[0]  # of the formulas: a lecture's, or the text of a file
    layers: frozenset[str] = frozenset()  # the hidden `LAYERS`
    fixed: str | None = None  # the world's viewpoint; empty for a free one, None for the scene's
    names: tuple[str, ...] | None = None
    """The ids of the things that the pictures name, or `EVERYTHING`; None for the scene's own
    list."""
    probes: tuple[Probe, ...] = ()  # the probes, in the order of their numbers
    pinned: frozenset[int] = frozenset()  # numbers of the probes that the next click does not move
    compare: tuple[ComparedPicture, ...] = ()
    """The compared pictures from left to right, one of them the document's own; or none."""
    dividers: tuple[float, ...] = ()
    """The dividers of overlaid pictures, as fractions of the width; none if they are side by
    side."""
    slide: tuple[str, ...] = ()
    """The `SLIDES` that a class sees: one, or two beside each other; empty for the large pane."""
    controls: tuple[str, ...] = ()  # paths of the values that a class sees changing, or `STRIP`
    equation: str = ""  # the matrices of an equation that is a slide; see `app.lecture.equation`
    panes: dict[str, Camera] = field(default_factory=dict, hash=False)
    """The camera of each pane that the user turned, even of unknown panes. Do not modify it."""

    def __post_init__(self) -> None:
        check_name("layout", self.layout, LAYOUTS)
        check_name("large", self.large, PANES, or_none=True)
        check_name("frame_step", self.frame_step, STEPS)
        check_name("panel", self.panel or "", PANELS, or_none=True)
        lettering(self.letters)  # or a `Refusal`
        check_name("fixed", self.fixed or "", FIXED, or_none=True)
        if not is_number(self.stage) or not -MOST_TILES <= self.stage <= IMAGE:
            raise Refusal(
                "stage", self.stage, REFUSALS["a-stage"], ", ".join(STAGES), -MOST_TILES, IMAGE
            )
        if not self.layers <= set(LAYERS):
            raise Refusal(
                "layers", sorted(self.layers, key=str), REFUSALS["some-of"], ", ".join(LAYERS)
            )
        _check_names(self.names)
        self._check_slide()
        numbers = [probe.number for probe in self.probes]
        if numbers != sorted(set(numbers) & set(range(1, MOST_PROBES + 1))):
            raise Refusal("probes", numbers, REFUSALS["some-probes"], MOST_PROBES)
        for probe in self.probes:
            where = f"probes[{probe.number - 1}]"
            given = [x for x in (probe.point, probe.pixel, probe.direction) if x is not None]
            if len(given) != 1:
                raise Refusal(where, None, REFUSALS["a-probe"])
            if probe.pixel is not None:
                for part in probe.pixel:
                    within(where, real(where, part), 0.0, LARGEST_IMAGE_PX)
            else:
                _finite_row(where, probe.row or ())
        if not all(map(is_number, self.pinned)) or not self.pinned <= set(numbers):
            raise Refusal("pinned", sorted(self.pinned, key=str), REFUSALS["probe-numbers"])
        check_pictures(self.compare, self.dividers)
        keep_checked(self, stage=float(self.stage), pinned=frozenset(map(int, self.pinned)))

    def _check_slide(self) -> None:
        names = set(self.slide)
        if not len(names) == len(self.slide) <= MOST_ON_SLIDE or not names <= set(SLIDES):
            limits = MOST_ON_SLIDE, ", ".join(SLIDES)
            raise Refusal("slide", ", ".join(self.slide), REFUSALS["some-slides"], *limits)
        if not len(set(self.controls)) == len(self.controls) <= MOST_ON_SLIDE:
            raise Refusal(
                "controls", ", ".join(self.controls), REFUSALS["some-controls"], MOST_ON_SLIDE
            )
        if not isinstance(self.equation, str):
            raise Refusal("equation", self.equation, REFUSALS["an-equation"])

    @property
    def compares_in(self) -> str:
        """The pane that a class sees compared pictures in: the world if that is the slide."""
        return "world" if "world" in self.slide and "image" not in self.slide else "image"

    @property
    def step(self) -> int | None:
        """The drawn step of the camera's frame; None while its panel is closed."""
        return STEPS.index(self.frame_step) if self.panel == "frame" else None


FIELDS = tuple(each.name for each in fields(View))


def _check_names(names: tuple[str, ...] | None) -> None:
    if names is None or names == EVERYTHING:
        return
    texts = [name for name in names if isinstance(name, str) and name.strip() not in ("", "*")]
    if len(texts) != len(names) or len(set(texts)) != len(texts) or len(texts) > MOST_NAMES:
        raise Refusal("names", list(names), REFUSALS["some-names"], MOST_NAMES)


AS_EVER = View()  # the default view


def without_scene(view: View) -> View:
    """Drop what concerns a scene; keep what is set up for a class."""
    return replace(
        view, large="", panel=None, probes=(), pinned=frozenset(), compare=(), dividers=(),
        slide=(), controls=(), equation="", names=None,
    )  # fmt: skip


# --------------------------------------------------------------------------- as JSON


def read_view(
    values: Mapping[str, Any], panes: dict[str, Camera], compare: tuple[ComparedPicture, ...] = ()
) -> View:
    """Read a view from its part of a document, as `view_tree` writes it.

    Missing fields get their defaults, and unknown ones are ignored. The panes' cameras and the
    compared pictures are passed in, already read. An invalid value raises a `Refusal`.
    """
    given = {name: values[name] for name in FIELDS if name in values}
    given |= {"panes": panes, "compare": compare}
    for name, value in given.items():
        if name in _LISTS:
            given[name] = _list(name, value)
        elif name in _ONE_OR_NONE:  # null is none of them
            check_name(name, value, _ONE_OR_NONE[name], or_none=True)
        elif name == "probes":
            given[name] = _probes(value)
        elif name == "stage" and value in STAGES:
            given[name] = STAGES.index(value)
    return View(**given)


def view_tree(view: View) -> dict[str, Any]:
    """Write what differs from `AS_EVER`, except for cameras and pictures."""
    values = {name: getattr(view, name) for name in FIELDS if name not in ("panes", "compare")}
    return {
        name: _AS_WRITTEN[name](value) if name in _AS_WRITTEN else value
        for name, value in values.items()
        if value != getattr(AS_EVER, name)
    }


def _list(name: str, value: Any) -> Any:
    make, kind, bound, *limits = _LISTS[name]
    if not isinstance(value, list) or not all(isinstance(part, kind) for part in value):
        raise Refusal(name, value, bound, *limits)
    return make(value)


def _probes(value: Any) -> tuple[Probe, ...]:
    if not isinstance(value, list) or len(value) > MOST_PROBES:
        raise Refusal("probes", value, REFUSALS["some-probes"], MOST_PROBES)
    return tuple(_probe(number, part) for number, part in enumerate(value, 1) if part is not None)


def _probe(number: int, part: Any) -> Probe:
    where = f"probes[{number - 1}]"
    count = len(part) if isinstance(part, list) else 0
    if count not in (2, 3, 4) or not all(map(is_number, part)):
        raise Refusal(where, part, REFUSALS["a-probe"])
    if count == 2:
        return Probe(number, pixel=(real(where, part[0]), real(where, part[1])))
    if count == 3:
        return Probe(number, point=finite_vector(where, part))
    return Probe.of(number, _finite_row(where, part))


def _finite_row(where: str, values: Sequence[Any]) -> Row:
    """Read homogeneous coordinates of a probe; a refusal names the probe."""
    try:
        return homogeneous(*values)
    except Refusal as error:
        raise Refusal(where, list(values), error.bound, *error.limits) from None


def _probe_places(probes: tuple[Probe, ...]) -> list[Any]:
    """Return each probe at the index of its number, with null in the gaps."""
    by_number = {probe.number: probe.point or probe.pixel or probe.row for probe in probes}
    return [by_number.get(number) for number in range(1, max(by_number) + 1)]


_ONE_OR_NONE = {"panel": PANELS, "fixed": FIXED}
_LISTS: dict[str, tuple[Any, ...]] = {
    "layers": (frozenset, Hashable, REFUSALS["some-of"], ", ".join(LAYERS)),
    "names": (tuple, Hashable, REFUSALS["some-names"], MOST_NAMES),
    "pinned": (frozenset, Hashable, REFUSALS["probe-numbers"]),
    "slide": (tuple, str, REFUSALS["some-slides"], MOST_ON_SLIDE, ", ".join(SLIDES)),
    "controls": (tuple, str, REFUSALS["some-controls"], MOST_ON_SLIDE),
    "dividers": (tuple, object, REFUSALS["some-dividers"]),
}
"""What each list becomes, the type of its parts, and its bound; the view checks them further."""
_AS_WRITTEN: dict[str, Callable[[Any], Any]] = {
    "stage": lambda stage: STAGES[int(stage)] if stage in range(len(STAGES)) else stage,
    "layers": lambda layers: [name for name in LAYERS if name in layers],
    "pinned": sorted,
    "probes": _probe_places,
}
