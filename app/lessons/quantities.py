"""The names in the formulas of lessons: every number of the model, by name.

A formula of a lesson (`app.model.formula`, the program's one language) is over a document: the
camera, the lens, the picture, the object, the scene's settings and readout, the probes at every
stage, and every matrix' cells. Angles are in degrees, and so are the functions of angles.
"""

import contextlib
import difflib
import math
import operator
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache, partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from app.document.document import Document
from app.document.view import View
from app.model import formula, parameters
from app.model.formula import Arithmetic, Formula
from app.model.infinity import trace_at_infinity
from app.model.lenses.lens import FAR, NEAR
from app.model.lenses.oblique import ALPHA, BETA
from app.model.lenses.perspective import FOV_Y, focal_length_35mm
from app.model.limits import LARGEST, Row
from app.model.parameter import Parameter
from app.model.pipeline import Stage
from app.model.projection import Array, Projection, Trace
from app.model.refusal import REFUSALS, Refusal

if TYPE_CHECKING:
    from app.scenes.scene import Scene

WITHOUT_VALUE = (
    REFUSALS["divides-by-zero"],
    REFUSALS["quantities-too-large"],
    REFUSALS["quantities-not-defined"],
    REFUSALS["quantities-no-number"],
)
"""Why a formula may have no value in some states."""

WITHIN = 0.01  # tolerance of ``=`` and ``!=`` in a condition: of the larger value, or 1 if one is 0

XYZ = ("x", "y", "z")
_SPACES = {  # the spaces of a probe, and its coordinates there
    "object": XYZ,
    "world": XYZ,
    "view": XYZ,
    "clip": (*XYZ, "w"),
    "ndc": XYZ,
    "image": ("x", "y", "depth"),
}


class NotThere(LookupError):
    """A quantity that is missing at the moment: the second probe, a parallel lens's angle."""


def _to_degrees(function: Callable[[float], float]) -> Callable[[float], float]:
    return lambda value: math.degrees(function(value))


def _sine(angle: float) -> float:
    """Return the sine of degrees, exact where it is 0, 1 or -1."""
    turned = math.remainder(angle, 360.0)
    if abs(turned) > 90.0:  # reduced to the quarter in which it keeps its digits
        turned = math.copysign(180.0, turned) - turned
    return math.sin(math.radians(turned))


def _cosine(angle: float) -> float:
    return _sine(90.0 - abs(math.remainder(angle, 360.0)))


FUNCTIONS: dict[str, Callable[..., float]] = {
    "sin": _sine,
    "cos": _cosine,
    "tan": lambda angle: _sine(angle) / _cosine(angle),
    "cot": lambda angle: _cosine(angle) / _sine(angle),
    "asin": _to_degrees(math.asin),
    "acos": _to_degrees(math.acos),
    "atan": _to_degrees(math.atan),
    "sqrt": math.sqrt,
    "abs": abs,
    "min": min,
    "max": max,
}


def _called(name: str, arguments: Sequence[float]) -> float:
    function = FUNCTIONS[name]
    try:
        return function(*arguments)
    except (ValueError, TypeError):  # outside its domain, or too many arguments
        raise Refusal("formula", name, REFUSALS["quantities-not-defined"]) from None


RATIONAL = Arithmetic(Fraction, lambda name, of: Fraction(_called(name, [*map(float, of)])))
"""Rationals, with the functions in float64; a `KeyError` names an unknown one."""

NEGLIGIBLE = 1.0 / LARGEST  # a number nearer to 0 counts as 0
_LARGEST, _NEGLIGIBLE = Fraction(LARGEST), Fraction(NEGLIGIBLE)
_CONSTANTS = {"pi": math.pi, "infinity": math.inf}


@contextlib.contextmanager
def _of(asked: Formula) -> Iterator[None]:
    """Refuse a formula that divides by zero or is too large."""
    try:
        yield
    except ZeroDivisionError:
        raise _refused(asked, REFUSALS["divides-by-zero"]) from None
    except OverflowError:
        raise _refused(asked, REFUSALS["quantities-too-large"], LARGEST) from None


def _evaluated(
    asked: Formula,
    known: Any,
    call: Callable[[str, Sequence[float]], float] = _called,
    *,
    infinite: bool = False,
) -> float:
    with _of(asked):
        value = float(asked.evaluate(known, Arithmetic(float, call)))
    if math.isnan(value):
        raise _refused(asked, REFUSALS["quantities-no-number"])
    if abs(value) > LARGEST and not (infinite and math.isinf(value)):
        raise _refused(asked, REFUSALS["quantities-too-large"], LARGEST)
    return value if abs(value) >= NEGLIGIBLE else 0.0


def rational(asked: Formula, numbers: Mapping[str, Fraction]) -> Fraction:
    """Return a formula's value as a rational number; a `KeyError` names an unknown name.

    Raise a `Refusal` as `Quantities.value` does.
    """
    with _of(asked):
        value: Fraction = asked.evaluate(numbers, RATIONAL)
    if abs(value) > _LARGEST:
        raise _refused(asked, REFUSALS["quantities-too-large"], LARGEST)
    return value if abs(value) >= _NEGLIGIBLE else Fraction(0)


@lru_cache(maxsize=256)
def _nearest_name(name: str, known: tuple[str, ...]) -> str:
    """Return the known name that is most like an unknown one, which each variant names again."""
    return next(iter(difflib.get_close_matches(name, known, n=1, cutoff=0.0)), "none")


@lru_cache(maxsize=4096)
def read_formula(text: str, *, infinite: bool = False) -> Formula:
    """Read a formula of a lesson; refuse one that has no value in any state.

    With `infinite`, its value may be infinite.
    """
    parsed = formula.parse(text)
    for part in parsed:
        with contextlib.suppress(KeyError):  # a name has a value only in a state
            _evaluated(part, _CONSTANTS, infinite=infinite or part is not parsed)
    return parsed


class Quantities:
    """Every number of a document, by its name.

    `scene` is called only when the readout is needed. The names of an earlier state, `before`,
    begin with ``was_``; those of `given` come before all others.
    """

    def __init__(
        self,
        document: Document,
        scene: "Callable[[], Scene]",
        view: View | None = None,
        before: "Quantities | None" = None,
        given: Mapping[str, float] = MappingProxyType({}),
    ) -> None:
        self.document = document
        self._scene = scene
        self._view = document.view if view is None else view
        self._before = before
        self._given = given
        self._traces: dict[int, Trace] = {}

    # -- the interface of formulas

    def __contains__(self, _text: object) -> bool:
        return False  # no term is known as a whole

    def __getitem__(self, name: str) -> float:
        return self._number(name, ())

    def _call(self, name: str, arguments: Sequence[float]) -> float:
        if name in FUNCTIONS:
            return _called(name, arguments)
        return self._number(name, tuple(arguments))

    def value(self, asked: Formula, *, infinite: bool = False) -> float:
        """Return a formula's value.

        Raise a `Refusal` for an unknown name, a division by zero, a value beyond `LARGEST` (unless
        it is infinite and may be so) and one that is no number, and `NotThere` if a quantity is
        missing just now.
        """
        return _evaluated(asked, self, self._call, infinite=infinite)

    def word(self, path: str) -> str:
        """Return the word at a path of ``--set`` in the document; empty if there is none."""
        section, _, key = path.rpartition(".")
        document, projection = self.document, self.projection
        if section == "settings":
            value = document.settings.get(key, "")
            return str(value).lower() if isinstance(value, bool) else str(value)
        owners = {
            "view": self._view,
            "lens": projection.lens,
            "object": projection.placement.five,
            "quality": document.quality,
            "": projection if path == "depth" else document,
        }
        return str(getattr(owners.get(section), key, None) or "")

    # -- by name

    def _number(self, name: str, places: tuple[float, ...]) -> float:
        if name.startswith("was_") and self._before is not None:
            return self._before._number(name.removeprefix("was_"), places)
        value = self._looked_up(name)
        if value is None:
            known = (*self.names, *(() if places == () else FUNCTIONS))
            bound = REFUSALS["no-function"] if places else REFUSALS["no-name"]
            raise Refusal("formula", name, bound, name, _nearest_name(name, known))
        return _part(name, value, places)

    def _looked_up(self, name: str) -> Any:
        """Return a number, several, or a function for a probe's coordinate; None if unknown."""
        if name in self._given:
            return self._given[name]
        if name in _SIMPLE:
            return _SIMPLE[name](self)
        if name.startswith("reading_"):
            return self._reading(name.removeprefix("reading_"))
        if name.startswith("settings_"):
            return self._setting(name.removeprefix("settings_"))
        space, _, part = name.partition("_")
        if part in _SPACES.get(space, ()):
            return lambda number=1: self._coordinate(number, space, part)
        stage = self._stages.get(name) or self._direct_stages.get(name)
        return stage.matrix if stage is not None else None

    @property
    def names(self) -> tuple[str, ...]:
        settings = [f"settings_{name}" for name in self.document.settings]
        probes = [f"{space}_{part}" for space, parts in _SPACES.items() for part in parts]
        readings = [f"reading_{name}" for name in self.readings]
        known = *self._given, *_SIMPLE, *probes, *self._stages, *self._direct_stages
        return (*known, *settings, *readings)

    @property
    def projection(self) -> Projection:
        return self.document.projection

    @cached_property
    def _stages(self) -> dict[str, Stage]:
        return {stage.name: stage for stage in self.projection.stages}

    @cached_property
    def _direct_stages(self) -> dict[str, Stage]:
        """Return the products of stages; they are made only for a name that needs them."""
        return {stage.name: stage for stage in self.projection.direct_stages}

    def _setting(self, name: str) -> Any:
        settings: Mapping[str, Any] = self.document.settings
        if name in settings:
            return _numeric(f"settings.{name}", settings[name])
        head, _, axis = name.rpartition("_")
        is_part = axis in XYZ and isinstance(settings.get(head), tuple)
        return settings[head][XYZ.index(axis)] if is_part else None

    @cached_property
    def readings(self) -> Mapping[str, Any]:
        """Return the numbers of the scene's readout, by the names that formulas use."""
        shown = self._scene().illustration(self.projection, self.document.settings)
        return {reading_name(each.label): each.value for each in (shown.readings if shown else ())}

    def _reading(self, name: str) -> Any:
        readings = self.readings
        if name not in readings:
            near = _nearest_name(name, tuple(readings))
            raise Refusal(
                "formula", f"reading_{name}", REFUSALS["no-name"], name, f"reading_{near}"
            )
        return _numeric(f"reading_{name}", readings[name])

    def _coordinate(self, number: int, space: str, part: str) -> float:
        row = self._row(number)
        if space == "object":
            return self.projection.placement.object_from_world(row)[XYZ.index(part)]
        if number not in self._traces:
            *place, w = row
            at = self.projection
            self._traces[number] = at.trace(place) if w else trace_at_infinity(at, place)
        trace = self._traces[number]
        of_space: Array = trace.depth if part == "depth" else getattr(trace, space)
        value = float(of_space if part == "depth" else of_space[(*XYZ, "w").index(part)])
        if math.isnan(value):
            raise NotThere(f"{space}_{part}")
        return value

    def _row(self, number: int) -> Row:
        """Return the homogeneous coordinates of a probe."""
        probes = {probe.number: probe for probe in self._view.probes}
        row = probes[number].row if number in probes else None
        if row is None:
            raise NotThere(f"probe {number}")
        return row


def _part(name: str, value: Any, places: tuple[float, ...]) -> float:
    """Return a value, an element of a row, a cell of a matrix, or a probe's coordinate."""
    if any(place < 0 or not place.is_integer() for place in places):
        raise Refusal("formula", name, REFUSALS["no-cell"], name)
    indices = [int(place) for place in places]
    if callable(value) and len(indices) < 2:  # of the first probe, or of the one with a number
        return float(value(*indices))
    if isinstance(value, tuple):
        if not indices:
            indices = [0]
        if len(indices) == 2:  # a matrix, row after row
            value = np.reshape(value, (math.isqrt(len(value)), -1))
    shape = np.shape(value)
    if len(shape) != len(indices) or any(i >= n for i, n in zip(indices, shape, strict=True)):
        raise Refusal("formula", name, REFUSALS["no-cell"], name)
    return float(np.asarray(value)[tuple(indices)])


def _numeric(name: str, value: Any) -> Any:
    if value is None:
        raise NotThere(name)
    if isinstance(value, str):
        raise Refusal("formula", name, REFUSALS["no-cell"], name)
    return value


def _refused(asked: Formula, bound: Any, *limits: object) -> Refusal:
    return Refusal("formula", asked.text, bound, *limits)


_WORD = re.compile(r"[^\W_]+")


def reading_name(label: str) -> str:
    """Return the name of a reading: the words of its label before a formula or a remark."""
    return "_".join(_WORD.findall(re.split(r"[=:;]", label)[0]))


# --------------------------------------------------------------------------- simple quantities


def _window(side: int) -> Callable[[Quantities], float]:
    return lambda known: _of_lens(NEAR, known) and known.projection.window[side]


def _of_lens(parameter: Parameter, known: Quantities) -> float:
    value = getattr(known.projection.lens, parameter.name, None)
    if value is None:
        raise NotThere(parameter.name)
    return float(value)


def _angle_of_view(first: int, last: int, known: Quantities) -> float:
    if known.projection.lens.parallel:
        raise NotThere(FOV_Y.formula)
    near, window = _of_lens(NEAR, known), known.projection.window
    return math.degrees(math.atan(window[last] / near) - math.atan(window[first] / near))


def _fov(known: Quantities) -> float:
    typed = known.projection.lens.fov_y_deg
    if typed is not None and getattr(known.projection.lens, "keep", "y") in (None, "y"):
        return float(typed)
    return _angle_of_view(2, 3, known)


def _value(parameter: Parameter, known: Quantities) -> float:
    return float(parameter.value(known.projection))


def _of_tile(parameter: Parameter, known: Quantities) -> float:
    """Return a number of the only tile that has it; without one, that of a tile that does nothing.

    Raise `NotThere` for several.
    """
    letter = parameter.name[-1]
    kind = f"rotate {letter}" if parameters.ROTATE.name in parameter.name else parameter.name[:-2]
    rivals = [kind, "rotate"] if kind.startswith("rotate") else [kind]
    tiles = [tile for tile in known.projection.placement.on if tile.kind in rivals]
    if len(tiles) > 1 or any(tile.kind != kind for tile in tiles):
        raise NotThere(f"single tile “{kind}”")
    return _value(parameter, known)


def _of_frame(row: int, place: int, known: Quantities) -> float:
    return float(known.projection.camera.frame[row][place])


_VALUES = (
    parameters.WIDTH,
    parameters.HEIGHT,
    parameters.DISTANCE,
    parameters.AZIMUTH,
    parameters.ELEVATION,
)
_SIMPLE: dict[str, Callable[[Quantities], Any]] = {
    "pi": lambda known: math.pi,
    "infinity": lambda known: math.inf,
    **{each.formula: partial(_of_lens, each) for each in (NEAR, FAR)},
    **{side.formula: _window(place) for place, side in enumerate(parameters.WINDOW_SIDES)},
    FOV_Y.formula: _fov,
    parameters.FOV_X.formula: partial(_angle_of_view, 0, 1),
    parameters.ASPECT.formula: lambda known: float(known.projection.aspect),
    **{each.formula: partial(_of_lens, each) for each in (ALPHA, BETA)},
    parameters.FOCAL_E.formula: lambda known: (
        1.0 / math.tan(math.radians(_angle_of_view(0, 1, known) / 2.0))
    ),
    parameters.FOCAL_LENGTH.formula: lambda known: focal_length_35mm(
        _fov(known), known.projection.aspect
    ),
    **{each.formula: partial(_value, each) for each in _VALUES},
    "stage": lambda known: known._view.stage,
    "turned": lambda known: float("world" in known._view.panes),
}
for _place, _axis in enumerate(XYZ):
    for _vector in (each for each in parameters.PARAMETERS.values() if each.vector):
        _read = _of_tile if _vector.section == "object" else _value
        _SIMPLE[f"{_vector.formula}_{_axis}"] = partial(_read, _vector.component(_place))
    for _row, _letter in enumerate("uvn"):
        _SIMPLE[f"{_letter}_{_axis}"] = partial(_of_frame, _row, _place)

# --------------------------------------------------------------------------- conditions

_SIGN = re.compile(r"<=|>=|!=|≤|≥|≠|=|<|>")
_UNEQUAL = ("!=", "≠")
_PATH = re.compile(r"(scene|mesh|depth|[a-z]+\.[a-z_]+)")
_COMPARED: dict[str, Callable[[float, float], bool]] = {
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
    "≤": operator.le,
    "≥": operator.ge,
}


@dataclass(frozen=True)
class Condition:
    """Two formulas and a sign, or a path of ``--set`` and a word."""

    text: str
    sign: str
    left: Formula | None = None
    right: Formula | None = None
    path: str = ""
    word: str = ""

    @classmethod
    def read(cls, text: str) -> "Condition":
        signs = list(_SIGN.finditer(text))
        if len(signs) != 1:
            raise Refusal("condition", text, REFUSALS["no-condition"])
        sign = signs[0].group()
        left, right = text[: signs[0].start()].strip(), text[signs[0].end() :].strip()
        if sign in ("=", *_UNEQUAL) and _PATH.fullmatch(left):
            return cls(text, sign, path=left, word=right)
        left_side, right_side = (read_formula(side, infinite=True) for side in (left, right))
        return cls(text, sign, left_side, right_side)

    @property
    def letters(self) -> tuple[str, ...]:
        """The names in it."""
        return tuple(name for side in (self.left, self.right) if side for name in side.letters)

    def holds(self, known: Quantities) -> bool:
        """Whether the condition holds; it does not if a quantity is missing."""
        if self.left is None or self.right is None:
            return (known.word(self.path) == self.word) != (self.sign in _UNEQUAL)
        try:
            left, right = (known.value(side, infinite=True) for side in (self.left, self.right))
        except NotThere:
            return False
        if self.sign in _COMPARED:
            return _COMPARED[self.sign](left, right)
        size = max(abs(left), abs(right)) if left and right else 1.0
        is_equal = left == right  # also if both are infinite
        if math.isfinite(size):
            is_equal = is_equal or abs(left - right) <= WITHIN * size
        return is_equal != (self.sign in _UNEQUAL)
