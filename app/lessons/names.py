"""All names that a lesson's file may use, as a page in Markdown: `docs/lesson-names.md`."""

from collections.abc import Iterable
from pathlib import Path

from app.document.document import Document, fields_of
from app.document.naming import nameable
from app.document.view import PANES
from app.lessons.quantities import FUNCTIONS, Quantities
from app.model.parameter import Parameter, read_content
from app.model.projection import kinds
from app.scenes.scene import BUILT_IN, load

PAGE = Path(__file__).with_name("names.md")


def page() -> str:
    opened = {name: load(name) for name in BUILT_IN}
    documents = {name: Document(name, scene.start) for name, scene in opened.items()}
    drawn = {
        name: frozenset[str]().union(*(nameable(pane, documents[name], scene) for pane in PANES))
        for name, scene in opened.items()
    }
    everywhere = frozenset.intersection(*drawn.values())
    rows = []
    for name, scene in opened.items():
        settings = scene.phenomenon.settings if scene.phenomenon is not None else ()
        readings = Quantities(documents[name], lambda scene=scene: scene).readings  # type: ignore[misc]
        cells = (
            f"`{name}`",
            "; ".join(map(_setting, settings)),
            _listed(readings, in_order=True),
            _listed(drawn[name] - everywhere),
        )
        rows.append(f"| {' | '.join(cells)} |\n")
    known = Quantities(documents["letter-f"], lambda: opened["letter-f"])
    fields = (each for lens in kinds() for each in fields_of("letter-f", lens))
    paths = dict.fromkeys(each.path for each in fields if each.kind is not None)
    return read_content(PAGE).format(
        everywhere=_listed(everywhere),
        scenes="".join(rows),
        paths=_listed(paths, in_order=True),
        functions=_listed(FUNCTIONS, in_order=True),
        names=_listed(known.names, in_order=True),
    )


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
