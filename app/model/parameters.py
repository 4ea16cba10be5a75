"""The table of parameters: each value of camera, lens, image and object, stated once.

Rows of the dock, ``--set``, the finder, formulas, highlights and handles read it. A lens declares
the parameters that only it has; a phenomenon declares the settings of its scene.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from operator import attrgetter
from types import MappingProxyType
from typing import Any, NamedTuple

from app.model.chain import KINDS
from app.model.lenses import perspective
from app.model.lenses.lens import FAR as FAR
from app.model.lenses.lens import NEAR as NEAR
from app.model.lenses.oblique import ALPHA as ALPHA
from app.model.lenses.oblique import BETA as BETA
from app.model.lenses.oblique import OBLIQUE_PRESETS, oblique_angles, receding_of
from app.model.lenses.perspective import FOV_Y as FOV_Y
from app.model.limits import LARGEST_SHEAR
from app.model.parameter import Computed, Parameter, stated
from app.model.projection import LENSES, Camera, Lens, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal

ASPECTS = {"1:1": (1, 1), "4:3": (4, 3), "16:9": (16, 9)}
_SAME_ANGLE_DEG = 1e-9  # rounding error of a preset's angle in a file


# --------------------------------------------------------------------------- computed values


def tidy(number: float) -> float:
    """Round a computed number to 13 digits: 60 comes back as 60, not as 60.00000000000001."""
    return float(f"{number:.13g}")


def _measure(
    measure: Callable[[float, float], float], fov_y: Callable[[float, float], float]
) -> dict[str, Any]:
    """Return functions that read and write another measure of the field of view."""

    def read(projection: Projection) -> float:
        return tidy(measure(FOV_Y.value(projection), projection.aspect))

    def write(projection: Projection, value: float) -> Any:
        return FOV_Y.put(projection, fov_y(value, projection.aspect))

    return {"read": read, "write": write}


def _fov_x(projection: Projection) -> float:
    fov_x_deg = perspective.fov_x_from_fov_y(FOV_Y.value(projection), projection.aspect)
    tidy_deg = tidy(fov_x_deg)
    return tidy_deg if tidy_deg < 180.0 else fov_x_deg


def _with_half(is_width: bool, projection: Projection, half: float) -> Any:
    top = half / projection.aspect if is_width else half
    try:
        fov_y_deg = perspective.fov_y_from_window(top, projection.lens.near)
    except Refusal as error:  # its field is top
        name = (HALF_WIDTH if is_width else HALF_HEIGHT).name
        raise Refusal(name, half, error.bound, *error.limits) from None
    return FOV_Y.put(projection, fov_y_deg)


class Receding(NamedTuple):
    """Length and direction in which an oblique lens draws depth; see `oblique_angles`."""

    receding: float
    receding_deg: float


def _angles(projection: Projection) -> tuple[float, float]:
    return ALPHA.value(projection), BETA.value(projection)


def _with_receding(projection: Projection, numbers: Receding) -> Projection:
    receding = numbers.receding
    if abs(receding) > LARGEST_SHEAR and math.isfinite(receding):
        bound, limit = (
            (REFUSALS["at-most"], LARGEST_SHEAR)
            if receding > 0.0
            else (REFUSALS["at-least"], -LARGEST_SHEAR)
        )
        raise Refusal(RECEDING.name, receding, bound, limit)
    return projection.with_angles(*oblique_angles(*numbers))


def _preset(projection: Projection) -> str | None:
    angles = _angles(projection)
    for name, preset in OBLIQUE_PRESETS.items():
        if max(abs(a - b) for a, b in zip(angles, preset, strict=True)) <= _SAME_ANGLE_DEG:
            return name
    return None


def _with_side(axis: int, projection: Projection, side_px: float) -> Projection:
    size: list[Any] = list(projection.image_size)
    size[axis] = int(side_px) if float(side_px).is_integer() else side_px
    return replace(projection, image_size=tuple(size))


def _aspect(projection: Projection) -> str | None:
    width, height = projection.image_size
    for text, (across, down) in ASPECTS.items():
        if width == round(height * across / down):
            return text
    return None


def _with_aspect(projection: Projection, text: str) -> Projection:
    across, down = ASPECTS[text]
    height = projection.image_size[1]
    return replace(projection, image_size=(max(1, round(height * across / down)), height))


ORBIT = Computed(
    attrgetter("camera"),
    attrgetter("camera.orbit"),
    lambda p, orbit: replace(p, camera=Camera.from_orbit(p.camera.target, orbit)),
)
_RECEDING = Computed(_angles, lambda p: Receding(*receding_of(p.lens)), _with_receding)
_INTRINSICS = Computed(
    lambda p: (p.lens, p.image_size), attrgetter("intrinsics"), Projection.with_intrinsics
)


# --------------------------------------------------------------------------- the table

_ACROSS, _UPWARDS, _AXES = ("left", "right"), ("bottom", "top"), ("u", "v", "n")
_LENGTH = {"unit": "units", "logarithmic": True}
_TURN = {"unit": "°", "span": (-180.0, 180.0), "step": 1.0}

_lens = partial(stated, section="lens", place="lens")
_side = partial(_lens, **_LENGTH, handle="corner")
_oblique = partial(
    _lens, needs=ALPHA.name, changes=(ALPHA.name, BETA.name), shows=(ALPHA.name, BETA.name)
)
_more_lens = partial(stated, section="lens", place="more_lens")
_by_fov = partial(_more_lens, needs="symmetric", changes=FOV_Y.fields)
_of_k = partial(_more_lens, unit="px", logarithmic=True, needs="central", computed=_INTRINSICS)
_orbit = partial(stated, section="camera", place="camera", computed=ORBIT)
_vector = partial(stated, section="camera", place="more_camera", vector=True)
_image = partial(stated, section="image", place="image", changes=("image",), shows=("image",))
_side_px = partial(_image, unit="px", span=(10.0, 4000.0), step=10.0)


def _leftmost(projection: Projection, *kinds: str) -> Any:
    """Return the numbers of the leftmost tile of some kinds, or those that change nothing."""
    chain = projection.placement
    place = chain.place_of(*kinds)
    return KINDS[kinds[0]].neutral if place is None else chain.tiles[place].numbers


def _angles_deg(projection: Projection) -> Any:
    """Return the angles about x, y and z of the leftmost tile about each."""
    return tuple(_leftmost(projection, f"rotate {axis}")[0] for axis in "xyz")


_object = partial(stated, section="object", vector=True)

KIND = _lens("kind", shows=(), write=Projection.with_lens)
FOV_X = _by_fov(
    "fov_x_deg", unit="°", span=(1.0, 179.0), step=0.5, formula="fov_x",
    shows=FOV_Y.shows, makes=_ACROSS, read=_fov_x, write=Projection.with_fov_x,
)  # fmt: skip
FOCAL_LENGTH = _by_fov(
    "focal_length_mm", unit="mm", span=(5.0, 500.0), logarithmic=True, formula="focal_35mm",
    shows=FOV_Y.shows, makes=(*_ACROSS, *_UPWARDS),
    **_measure(perspective.focal_length_35mm, perspective.fov_y_from_focal_length_35mm),
)  # fmt: skip
KEEP = _more_lens("keep")
PRESET = _oblique(
    "preset", shows=(), read=_preset, write=lambda p, name: p.with_angles(*OBLIQUE_PRESETS[name])
)
RECEDING = _oblique("receding", unit="×", span=(0.0, 2.0), step=0.01, computed=_RECEDING)
RECEDING_DEG = _oblique("receding_deg", **_TURN, computed=_RECEDING)
LEFT = _side("left", letter="l", formula="left")
RIGHT = _side("right", letter="r", formula="right")
BOTTOM = _side("bottom", letter="b", formula="bottom")
TOP = _side("top", letter="t", formula="top")
WINDOW_SIDES = (LEFT, RIGHT, BOTTOM, TOP)
FOCAL_E = _by_fov(
    "e", unit="units", span=(1e-2, 1e2), logarithmic=True, formula="focal_e",
    shows=FOV_Y.shows, makes=(*_ACROSS, *_UPWARDS),
    **_measure(perspective.focal_length_e, perspective.fov_y_from_focal_length_e),
)  # fmt: skip
HALF_WIDTH = _by_fov(
    "window_right", **_LENGTH, shows=_ACROSS,
    read=lambda p: tidy(p.window[1]), write=partial(_with_half, True),
)  # fmt: skip
HALF_HEIGHT = _by_fov(
    "window_top", **_LENGTH, shows=_UPWARDS,
    read=lambda p: tidy(p.window[3]), write=partial(_with_half, False),
)  # fmt: skip
FX = _of_k("fx", shows=FOV_Y.shows, makes=_ACROSS)
FY = _of_k("fy", shows=FOV_Y.shows, makes=_UPWARDS)
CX, CY = _of_k("cx"), _of_k("cy")

AZIMUTH = _orbit(
    "azimuth_deg", **_TURN, formula="azimuth", changes=("eye",), shows=("eye",), makes=_AXES
)
ELEVATION = _orbit(
    "elevation_deg", unit="°", span=(-90.0, 90.0), step=1.0, formula="elevation",
    changes=("eye",), shows=("eye",), makes=_AXES,
)  # fmt: skip
DISTANCE = _orbit(
    "distance", **_LENGTH, formula="distance", changes=("eye",), shows=("eye",), handle="eye"
)
ROLL = _orbit("roll_deg", **_TURN, place="more_camera", changes=("up",), shows=("up", "u", "v"))
EYE = _vector("eye", unit="units", letter="eye", formula="eye", makes=_AXES, handle="eye")
TARGET = _vector(
    "target", unit="units", letter="target", formula="target", makes=_AXES, handle="target"
)
UP = _vector("up", span=(-1.0, 1.0), step=0.01, formula="up", shows=("up", "u", "v"), handle="up")

WIDTH = _side_px(
    "width", formula="width", read=lambda p: p.image_size[0], write=partial(_with_side, 0)
)
HEIGHT = _side_px(
    "height", formula="height", read=lambda p: p.image_size[1], write=partial(_with_side, 1)
)
ASPECT = _image(
    "aspect", letter="aspect", formula="aspect", buttons=True, read=_aspect, write=_with_aspect
)
DEPTH = stated(
    "depth", section="", place="image", read=attrgetter("depth"), write=Projection.with_depth
)
CHAIN = stated(
    "chain", section="object", shows=(), read=attrgetter("placement"),
    write=lambda p, chain: replace(p, placement=chain),
)  # fmt: skip
TRANSLATE = _object(
    "translate", unit="units", letter="move", formula="move", handle="origin",
    read=lambda p: _leftmost(p, "translate"),
)  # fmt: skip
ROTATE = _object(
    "rotate_deg", **_TURN, letter="turn", formula="turn", handle="turn", read=_angles_deg
)
SCALE = _object(
    "scale", unit="×", span=(-3.0, 3.0), step=0.01, letter="size", formula="size", handle="object",
    read=lambda p: _leftmost(p, "scale"),
)  # fmt: skip
SHEAR = stated("shear", section="object", span=(-3.0, 3.0), step=0.01, letter="shear")
MATRIX = stated("matrix", section="object", letter="g")
TILES = {each.name: each for each in (TRANSLATE, ROTATE, SCALE, SHEAR, MATRIX)}
"""The parameters of the numbers of the object's tiles, by `TileKind.field`."""


def parameters() -> tuple[Parameter, ...]:
    """Return all of them, those of the lenses included, in the order of the dock's rows."""
    own = {each.name: each for lens in LENSES.values() for each in lens.parameters}
    return (
        KIND, FOV_X, FOCAL_LENGTH, KEEP, *own.values(), PRESET, RECEDING, RECEDING_DEG,
        LEFT, RIGHT, BOTTOM, TOP, NEAR, FAR, FOCAL_E, HALF_WIDTH, HALF_HEIGHT, FX, FY, CX, CY,
        AZIMUTH, ELEVATION, DISTANCE, ROLL, EYE, TARGET, UP, WIDTH, HEIGHT, ASPECT, DEPTH,
        CHAIN, *TILES.values(),
    )  # fmt: skip


def lenses_with(parameter: Parameter) -> tuple[str, ...]:
    """Return the kinds of lens that have a parameter; none if it depends on no lens."""
    if parameter.section != "lens" or parameter is KIND:
        return ()
    needs = parameter.needs or parameter.name

    def has_it(lens: type[Lens]) -> bool:
        property_ = getattr(lens, needs, None)
        return property_ if isinstance(property_, bool) else needs in lens.__dataclass_fields__

    return tuple(kind for kind, lens in LENSES.items() if has_it(lens))


PARAMETERS: Mapping[str, Parameter] = MappingProxyType({each.name: each for each in parameters()})
"""The parameters by their names."""
TITLES = {each.name: each.title for each in PARAMETERS.values()} | {
    "image": QT_TRANSLATE_NOOP("Field", "Image"),
    "answer": QT_TRANSLATE_NOOP("Field", "Answer"),
}
"""The displayed name of each field of the model, in the window and in figures."""
