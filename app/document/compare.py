"""Pictures compared with the document's own: what each shows, and where they differ.

A held picture keeps the camera, lens, image and settings of one moment. Every other picture follows
the document except for a few values of its own (another interpolation, for example).
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, fields
from types import MappingProxyType
from typing import Any

from app.model.chain import FiveTiles
from app.model.limits import Frozen, is_number
from app.model.parameter import Parameter, Settings
from app.model.projection import Camera, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal
from app.scenes.phenomena.words import FEW, digits_apart

MOST_PICTURES = 4  # the lectures show four side by side: the cases of an edge and the eye plane

NAME_ENDS = ": "  # separates the name of a picture from its values
PARTS = ("settings", "camera", "lens", "image", "object", "depth")
"""The parts of a document that a picture shows and may override."""
ON, OFF = QT_TRANSLATE_NOOP("phenomena", "on"), QT_TRANSLATE_NOOP("phenomena", "off")
ARROW = " \u2192 "
_NAMING = ("settings", "lens", "camera", "image", "object", "depth")
"""The parts whose values name a picture, the most telling ones first."""
_WITHOUT_NAME = ("lens.kind", "image", "depth")  # fields whose values need no name beside them
_ALONG = 1e-9  # sine of the angle between two camera axes that count as equal


@dataclass(frozen=True)
class Held(Frozen):
    """A state that does not follow the document; `settings` belong to the scene's phenomenon."""

    projection: Projection
    settings: Settings = field(default_factory=lambda: MappingProxyType({}), hash=False)


@dataclass(frozen=True)
class ComparedPicture:
    """One of the compared pictures.

    Raises a `Refusal` for changes to values that no picture shows.
    """

    name: str = ""  # translatable if it comes from a phenomenon
    changes: tuple[str, ...] = ()
    """The values that differ from the document's, in the form of ``--set``: ``"lens.keep=x"``. For
    the document's own picture, the values that its name describes."""
    held: Held | None = None  # the state that it shows instead of following the document
    live: bool = False  # whether it is the document's own

    def __post_init__(self) -> None:
        for change in self.changes:
            path, equals, _ = change.partition("=")
            if not equals or path.strip().partition(".")[0] not in PARTS:
                raise Refusal("set", change, REFUSALS["only-of-the-picture"])


def check_pictures(pictures: Sequence[ComparedPicture], dividers: Sequence[float]) -> None:
    """Refuse a wrong number of pictures, and dividers that do not divide them."""
    count = len(pictures)
    live = sum(picture.live for picture in pictures)
    if count and not (2 <= count <= MOST_PICTURES and live == 1):
        raise Refusal("compare", [picture.name for picture in pictures], REFUSALS["some-pictures"],
                      MOST_PICTURES)  # fmt: skip
    if dividers and not (
        all(map(is_number, dividers))
        and len(dividers) == count - 1
        and list(dividers) == sorted(dividers)
        and dividers[0] >= 0.0
        and dividers[-1] <= 1.0
    ):
        raise Refusal("dividers", list(dividers), REFUSALS["some-dividers"])


# --------------------------------------------------------------------------- differences


def differences(states: Sequence[Held]) -> list[tuple[str, tuple[Any, ...]]]:
    """Return the paths at which states differ, each with every state's value.

    Settings come first. ``camera.distance`` stands for the eye if only that differs, and ``image``
    is (width, height). For lenses of several kinds only common fields are compared.
    """
    differing: list[tuple[str, tuple[Any, ...]]] = []

    def compared(path: str, values: Sequence[Any]) -> None:
        if any(value != values[0] for value in values):
            differing.append((path, tuple(values)))

    for name in states[0].settings:
        compared(f"settings.{name}", [state.settings[name] for state in states])
    shown = [state.projection for state in states]
    cameras = [projection.camera for projection in shown]
    if _same_axis(cameras):
        compared("camera.distance", [camera.distance for camera in cameras])
    else:
        for part in ("eye", "target", "up"):
            compared(f"camera.{part}", [getattr(camera, part) for camera in cameras])
    lenses: list[Any] = [projection.lens for projection in shown]
    compared("lens.kind", [lens.kind for lens in lenses])
    for each in fields(lenses[0]):
        if all(each.name in {other.name for other in fields(lens)} for lens in lenses):
            compared(f"lens.{each.name}", [getattr(lens, each.name) for lens in lenses])
    compared("image", [projection.image_size for projection in shown])
    chains = [projection.placement for projection in shown]
    fives = [chain.five for chain in chains]
    if all(fives):
        for each in fields(FiveTiles):
            compared(f"object.{each.name}", [getattr(five, each.name) for five in fives])
    else:
        compared("object.chain", [chain.text for chain in chains])
    compared("depth", [projection.depth for projection in shown])
    return differing


@dataclass(frozen=True)
class DifferenceWriter:
    """How to write a difference in a language: functions for the name of a model field, for a text
    of the phenomena (a setting's name, unit or choice; ``on`` and ``off``), and for a number with
    so many digits.
    """

    field: Callable[[str], str]
    text: Callable[[str], str]
    number: Callable[[float, int], str]


def in_words(
    pictures: Sequence[ComparedPicture],
    states: Sequence[Held],
    settings: Sequence[Parameter],
    written: DifferenceWriter,
) -> list[str]:
    """Describe in words how pictures differ: ``near 4 \u2192 8``.

    Omit values that a picture's name already describes, unless nothing else differs.
    """
    differing = differences(states)
    named = {change.partition("=")[0] for each in pictures for change in each.changes}
    differing = [each for each in differing if each[0] not in named] or differing
    by_path = {setting.path: setting for setting in settings}
    texts = (_written(path, values, by_path.get(path), written) for path, values in differing)
    return [f"{label} {ARROW.join(both)}" if all(both) else label for label, both in texts]


def names_in(
    own: Sequence[str],
    states: Sequence[Held],
    settings: Sequence[Parameter],
    written: DifferenceWriter,
) -> list[str]:
    """The name of each picture: its own one, or what differs: ``near 4``, ``near 8``.

    A setting of the scene names a picture rather than the lens, and the lens rather than the
    camera. A second value follows where the first one does not tell the pictures apart. Where
    nothing differs, the name is empty.
    """
    by_path = {setting.path: setting for setting in settings}
    ranked = sorted(differences(states), key=lambda each: _NAMING.index(each[0].partition(".")[0]))
    values: list[tuple[str, ...]] = [() for _ in states]
    for path, differing in ranked:
        setting = by_path.get(path)
        label, texts = _written(path, differing, setting, written)
        if not all(texts) or all(own):
            continue
        says_itself = path in _WITHOUT_NAME or (setting is not None and setting.choices)
        texts = texts if says_itself else [f"{label} {text}" for text in texts]
        values = [(*before, text) for before, text in zip(values, texts, strict=True)]
        if all(name or values.count(texts) == 1 for name, texts in zip(own, values, strict=True)):
            break
    return [name or ", ".join(texts) for name, texts in zip(own, values, strict=True)]


def values_in(
    path: str, states: Sequence[Held], settings: Sequence[Parameter], written: DifferenceWriter
) -> list[str]:
    """The value of a path in each state, with its name; empty if no picture shows it."""
    values = dict(differences(states)).get(path, ("",) * len(states))
    setting = next((each for each in settings if each.path == path), None)
    label, texts = _written(path, values, setting, written)
    return [f"{label} {text}" if text else "" for text in texts]


def _written(
    path: str, values: Sequence[Any], setting: Parameter | None, written: DifferenceWriter
) -> tuple[str, list[str]]:
    """What a value is called, and the text of each, with its unit; no text for a matrix."""
    _, _, name = path.rpartition(".")
    label, unit = written.field(name), "\u00b0" if name.endswith("_deg") else ""
    numbers = [value if isinstance(value, tuple) else (value,) for value in values]
    digits = max(
        (digits_apart(*column) for column in zip(*numbers, strict=False)
         if all(isinstance(part, (int, float)) for part in column)), default=FEW,
    )  # fmt: skip
    texts = [_value(value, written, digits) for value in values]
    if setting is not None:
        label, unit = written.text(setting.title), written.text(setting.unit)
        words = {key: written.text(text) for key, text in setting.choices}
        texts = [words.get(text, text) for text in texts]
    elif name == "image":
        texts = [f"{width} \u00d7 {height}" for width, height in values]
    if "" in texts:
        return label, [""] * len(texts)
    if label[1:2].islower():  # in the middle of a sentence
        label = label[0].lower() + label[1:]
    return label, [f"{text}{unit}" for text in texts]


def _value(value: Any, written: DifferenceWriter, digits: int) -> str:
    """Write a number, a point or a word; return an empty text for anything larger."""
    if isinstance(value, bool):
        return written.text(ON if value else OFF)
    if isinstance(value, (int, float)):
        return written.number(float(value), digits)
    if isinstance(value, tuple) and all(isinstance(part, float) for part in value):
        return f"({', '.join(written.number(part, digits) for part in value)})"
    return value if isinstance(value, str) and "matrix" not in value else ""


def _same_axis(cameras: Sequence[Camera]) -> bool:
    """Whether the cameras have the same target, view direction and up."""
    first = cameras[0]
    if any((camera.target, camera.up) != (first.target, first.up) for camera in cameras):
        return False
    u, v, _ = first.frame
    return all(
        math.hypot(float(u @ camera.frame[2]), float(v @ camera.frame[2])) <= _ALONG
        for camera in cameras
    )
