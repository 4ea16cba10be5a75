"""A wrong number beside the right one: the model with each of them, as compared pictures."""

import math
from dataclasses import replace

from app.document.compare import ComparedPicture
from app.document.document import Document
from app.document.settings import set_values
from app.lessons.blocks.block import Here
from app.lessons.quantities import NotThere
from app.model.formula import Letter
from app.model.parameters import FOCAL_E, FOV_X, FOV_Y, PARAMETERS
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

YOURS = QT_TRANSLATE_NOOP("phenomena", "your idea")
MODEL = QT_TRANSLATE_NOOP("phenomena", "the model")

_PATHS = {
    each.formula: each.path
    for each in PARAMETERS.values()
    if each.section == "lens" and not each.changes
}
"""Of the numbers of a lens that are fields of a document."""
_OF_WIDTH = (FOV_X.formula, FOCAL_E.formula)
"""Numbers of the horizontal angle, which the lens has from the vertical one."""


def beside(here: Here, own: Document, name: str, wrong: float) -> Document | None:
    """Return a state that shows another value of a number beside its own one.

    None if no value of ``--set`` is this number, or the model does not allow the value.
    """
    change = _change(own, name, wrong)
    try:
        value = here.quantities(set_values(own, [change])).value(Letter(name)) if change else None
    except (Refusal, NotThere):
        return None
    if value is None or not math.isclose(value, wrong, rel_tol=1e-9):
        return None
    pictures = ComparedPicture(YOURS, (change,)), ComparedPicture(MODEL, live=True)
    return replace(own, view=replace(own.view, compare=pictures, dividers=(), large="image"))


def is_set(own: Document, name: str) -> bool:
    """Whether a number has values of its own."""
    return bool(_change(own, name, 1.0))


def _change(own: Document, name: str, value: float) -> str:
    """Return the assignment that gives a number a value; empty if there is none."""
    if name in _OF_WIDTH:
        is_angle = name == FOV_X.formula
        if not 0.0 < value < (180.0 if is_angle else math.inf):
            return ""
        across = math.tan(math.radians(value / 2.0)) if is_angle else 1.0 / value
        name, value = FOV_Y.formula, 2.0 * math.degrees(math.atan(across / own.projection.aspect))
    if name.startswith("settings_"):
        return f"settings.{name.removeprefix('settings_')}={value!r}"
    return f"{_PATHS[name]}={value!r}" if name in _PATHS else ""
