"""All names that a lesson's file may use, as a page in Markdown: `docs/lesson-names.md`."""

from collections.abc import Iterable, Iterator

from app.document.document import Document, fields_of
from app.document.naming import nameable
from app.document.view import PANES
from app.lessons.quantities import FUNCTIONS, Quantities
from app.model.parameter import Parameter
from app.model.projection import kinds
from app.scenes.scene import BUILT_IN, load

_HEAD = """# All names in lessons
This page is what `python3 -m app lesson names` prints; [lessons.md](lessons.md) explains the file.

## Scenes
`scene=NAME` shows a scene, `settings.NAME=VALUE` sets one of its settings; formulas call the
setting `settings_NAME`. A reading is a number of the scene's readout as the scene opens; formulas
call it `reading_NAME`. The column *names* lists what `view.names` can name in this scene only. In
every scene it can name {0}.

| scene | settings | readings | names |
|---|---|---|---|
"""
_FORMULAS = """
## Formulas
The functions are {0}.

These names exist in every scene. Of a matrix `(i, j)` is a cell, counted from 0; of a coordinate of
the first probe `(2)` makes the one of the second: {1}.
"""
_VALUES = """
## Values of a state
Besides the settings of the scene, `state` sets {0}.
"""


def page() -> Iterator[str]:
    opened = {name: load(name) for name in BUILT_IN}
    documents = {name: Document(name, scene.start) for name, scene in opened.items()}
    drawn = {
        name: frozenset[str]().union(*(nameable(pane, documents[name], scene) for pane in PANES))
        for name, scene in opened.items()
    }
    everywhere = frozenset.intersection(*drawn.values())
    yield _HEAD.format(_listed(everywhere))
    known = Quantities(documents["letter-f"], lambda: opened["letter-f"])
    for name, scene in opened.items():
        settings = scene.phenomenon.settings if scene.phenomenon is not None else ()
        readings = Quantities(documents[name], lambda scene=scene: scene).readings  # type: ignore[misc]
        cells = (
            f"`{name}`",
            "; ".join(map(_setting, settings)),
            _listed(readings, in_order=True),
            _listed(drawn[name] - everywhere),
        )
        yield f"| {' | '.join(cells)} |\n"
    fields = (each for lens in kinds() for each in fields_of("letter-f", lens))
    paths = dict.fromkeys(each.path for each in fields if each.kind is not None)
    yield _VALUES.format(_listed(paths, in_order=True))
    yield _FORMULAS.format(_listed(FUNCTIONS, in_order=True), _listed(known.names, in_order=True))


def _listed(names: Iterable[str], *, in_order: bool = False) -> str:
    return " ".join(f"`{name}`" for name in (names if in_order else sorted(names)))


def _setting(setting: Parameter) -> str:
    """Return a setting and its values: its choices or its bounds, and what it is at first."""
    default = setting.default
    if isinstance(default, str):
        values = ", ".join(name for name, _ in setting.choices)
    elif isinstance(default, bool):
        values = "true or false"
    elif isinstance(default, tuple):
        values = "x,y,z"
    else:
        values = f"{setting.low:g} to {setting.high:g}"
    return f"`{setting.name}` ({values})"
