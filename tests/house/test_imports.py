"""Who may import whom: the table of the rooms, and the source files held against it.

Arrows run one way: numpy core <- scene <- drawings <- figures <- widgets <- main window <- the
command line. A new file needs a line here before the tests pass; that line is where its place in
the house is decided.
"""

from __future__ import annotations

import ast
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

from app.bootstrap import ROOT, requirements

VTK = ("pyvista", "vtkmodules", "vtk")
QT_CORE = ("PySide6.QtCore",)
QT = ("PySide6",)


@dataclass(frozen=True)
class Room:
    """What one file may import, each name with everything below it.

    Attributes
    ----------
    packages, rooms : tuple of str
        Third-party packages, and rooms of ours, that it may import anywhere. The standard library
        and the bare package ``app`` (for its version) are free to all.
    late : tuple of str
        What it may import only inside a function or under TYPE_CHECKING, so that importing the
        file does not bring it.
    """

    packages: tuple[str, ...] = ()
    rooms: tuple[str, ...] = ()
    late: tuple[str, ...] = ()


CORE = Room(("numpy",))
DRAWING = Room(
    ("numpy", *VTK),
    (
        *(
            "app.model.projection",
            "app.precision.levels",
            "app.lecture.stages",
            "app.picking.picking",
            "app.model.clipping",
        ),
        *(
            "app.lecture.highlight",
            "app.lecture.camera_frame",
            "app.picking.handles",
            "app.precision.quality",
        ),
        *("app.scenes.scene", "app.scenes.phenomena", "app.drawings"),
    ),
)
PHENOMENON = Room(
    ("numpy",),
    (
        *(
            "app.model.projection",
            "app.model.values",
            "app.precision.levels",
            "app.model.depth",
            "app.model.clipping",
        ),
        *("app.scenes.shapes", "app.scenes.phenomena"),
    ),
)
MEASURE = Room(
    ("numpy", *VTK),
    (
        *("app.model.projection", "app.precision.levels", "app.model.depth", "app.model.clipping"),
        *(
            "app.scenes.scene",
            "app.drawings",
            "app.document.document",
            "app.drawings.figures",
            "app.measure",
            "app.scenes.fewer_triangles",
        ),
    ),
)
#: Widgets know the model's values and each other's words, not the store: the window connects them.
PANEL = Room(
    ("numpy", *QT),
    (
        "app.lecture.highlight",
        "app.model.projection",
        "widgets.controls.animation",
        "widgets.parts.highlight",
        "widgets.parts.escape",
        "widgets.parts.focus",
        "widgets.parts.messages",
        "widgets.parts.palette",
        "widgets.parts.fields",
        "widgets.parts.section",
        "widgets.controls.lens_controls",
    ),
)

ROOMS = {
    "app/__init__.py": Room(),
    "app/bootstrap.py": Room(),
    # Help, and what is wrong with an option, before anything is set up.
    "app/commands/options.py": Room(rooms=("app.strangers",)),
    "app/__main__.py": Room(
        late=("app.bootstrap", "app.commands.options", "app.commands.doctor", "app.commands.cli")
    ),
    "app/arithmetic/double_double.py": CORE,
    "app/model/values.py": CORE,
    "app/model/camera.py": Room(("numpy",), ("app.arithmetic.double_double", "app.model.values")),
    "app/model/lenses.py": Room(rooms=("app.arithmetic.double_double", "app.model.values")),
    "app/arithmetic/rationals.py": Room(),
    # The model's one door: what values, camera and lenses hold is had from here.
    "app/model/projection.py": Room(
        ("numpy",),
        (
            "app.arithmetic.double_double",
            "app.arithmetic.rationals",
            "app.model.values",
            "app.model.camera",
            "app.model.lenses",
        ),
    ),
    "app/precision/levels.py": Room(
        ("numpy",), ("app.arithmetic.double_double", "app.model.projection")
    ),
    "app/model/depth.py": Room(("numpy",), ("app.model.projection",)),
    "app/model/clipping.py": Room(("numpy",), ("app.model.projection",)),
    "app/lecture/stages.py": Room(("numpy",), ("app.model.projection",)),
    "app/lecture/typed_matrix.py": Room(
        rooms=("app.arithmetic.double_double", "app.arithmetic.rationals", "app.model.projection")
    ),
    "app/lecture/dependence.py": Room(rooms=("app.model.projection",)),
    "app/lecture/notation.py": Room(
        rooms=("app.lecture.highlight", "app.lecture.dependence", "app.model.projection")
    ),
    # Names only: the words in which rooms that know nothing of each other point at things.
    "app/lecture/highlight.py": Room(),
    "app/lecture/camera_frame.py": Room(
        ("numpy",), ("app.arithmetic.double_double", "app.model.values", "app.model.projection")
    ),
    "app/picking/picking.py": Room(("numpy",), ("app.model.projection",)),
    "app/picking/handles.py": Room(("numpy",), ("app.model.projection", "app.picking.picking")),
    "app/drawings/label_placement.py": CORE,
    "app/precision/risks.py": Room(
        rooms=("app.model.projection", "app.precision.levels", "app.model.depth")
    ),
    "app/scenes/shapes.py": CORE,
    # Each phenomenon is numpy only: the command line reads its settings without VTK.
    **{
        str(path.relative_to(ROOT).as_posix()): PHENOMENON
        for path in (ROOT / "app" / "phenomena").glob("*.py")
    },
    "app/strangers.py": Room(),
    "app/scenes/mesh_files.py": Room(("numpy",), ("app.strangers",)),
    "app/scenes/reading.py": Room(("numpy",), ("app.scenes.mesh_files",)),
    "app/scenes/scene.py": Room(
        ("numpy", *VTK),
        (
            "app.model.projection",
            "app.scenes.shapes",
            "app.scenes.mesh_files",
            "app.scenes.reading",
            "app.scenes.phenomena",
        ),
    ),
    "app/precision/quality.py": Room(rooms=("app.model.projection", "app.model.depth")),
    "app/drawings/frame_budget.py": Room(),
    "app/document/document.py": Room(
        rooms=(
            "app.model.projection",
            "app.scenes.phenomena",
            "app.precision.quality",
            "app.strangers",
        )
    ),
    "app/drawings/__init__.py": DRAWING,
    "app/drawings/actors.py": DRAWING,
    "app/drawings/precision.py": DRAWING,
    "app/drawings/style.py": DRAWING,
    "app/drawings/frame.py": DRAWING,
    "app/drawings/labels.py": DRAWING,
    "app/drawings/rasterising.py": Room(
        DRAWING.packages, (*DRAWING.rooms, "app.model.depth", "app.scenes.phenomena")
    ),
    "app/drawings/pointing.py": DRAWING,
    "app/drawings/probes.py": DRAWING,
    "app/drawings/handles.py": DRAWING,
    "app/drawings/marks.py": DRAWING,
    "app/drawings/world.py": DRAWING,
    "app/drawings/ndc.py": DRAWING,
    "app/drawings/image.py": DRAWING,
    "app/drawings/figures.py": Room(
        ("numpy", "PIL", *VTK),
        (
            *(
                "app.model.projection",
                "app.scenes.mesh_files",
                "app.scenes.scene",
                "app.scenes.phenomena",
            ),
            *(
                "app.drawings",
                "app.document.document",
                "app.scenes.fewer_triangles",
                "app.precision.levels",
                "app.precision.quality",
            ),
        ),
    ),
    # What is measured, and how it is kept, needs no OpenGL until a picture is timed.
    "app/measure/results.py": Room(),
    "app/measure/run.py": Room(),
    # mpmath only when something is judged: a window knows the rooms of the measurements.
    "app/measure/reference.py": Room(("numpy",), ("app.model.projection",), late=("mpmath",)),
    # matplotlib only when a picture is drawn without a window.
    "app/measure/chart.py": Room(
        ("numpy",),
        (
            *("app.measure", "app.scenes.phenomena.illustration"),
            *("app.drawings.label_placement", "app.drawings.style"),
        ),
        late=("matplotlib", "PIL"),
    ),
    "app/measure/meaning.py": Room(rooms=("app.measure.results",)),
    "app/measure/depth.py": MEASURE,
    "app/measure/arithmetic.py": MEASURE,
    "app/measure/interpolation.py": MEASURE,
    "app/measure/smoothing.py": MEASURE,
    "app/measure/detail.py": MEASURE,
    "app/measure/__init__.py": MEASURE,
    "app/commands/measure.py": Room(
        rooms=(
            *(
                "app.commands.arguments",
                "app.commands.options",
                "app.document.document",
                "app.commands.doctor",
            ),
            *("app.model.projection", "app.measure"),
        )
    ),
    "app/scenes/fewer_triangles.py": Room(("numpy", *VTK), ("app.scenes.scene",)),
    "app/document/store.py": Room(QT_CORE, ("app.model.projection", "app.document.document")),
    # What the commands share: no command of its own, and a scene only when it is asked for.
    "app/commands/arguments.py": Room(
        rooms=(
            "app.bootstrap",
            "app.commands.options",
            "app.model.projection",
            "app.document.document",
            "app.scenes.phenomena",
        ),
        late=("app.scenes.scene",),
    ),
    # The command line starts with numbers only; pictures and windows come when they are asked for.
    "app/commands/cli.py": Room(
        ("numpy",),
        (
            *(
                "app.commands.arguments",
                "app.commands.options",
                "app.model.projection",
                "app.precision.levels",
                "app.lecture.notation",
            ),
            *(
                "app.bootstrap",
                "app.document.document",
                "app.commands.doctor",
                "app.lecture.typed_matrix",
            ),
        ),
        late=(*VTK, *QT, "app", "widgets"),
    ),
    "app/commands/doctor.py": Room(
        rooms=("app.bootstrap", "app.commands.options"), late=(*VTK, *QT, "app", "widgets")
    ),
    "widgets/__init__.py": Room(),
    "widgets/parts/palette.py": Room(QT, ("app.drawings.style",)),
    "widgets/parts/highlight.py": Room(QT, ("app.lecture.highlight",)),
    "widgets/parts/messages.py": Room(QT, ("app.model.projection", "app.document.document")),
    "widgets/parts/note.py": Room(QT),
    "widgets/parts/escape.py": Room(QT),
    "widgets/parts/focus.py": Room(QT),
    "widgets/parts/message_bar.py": PANEL,
    "widgets/parts/fields.py": PANEL,
    "widgets/controls/controls.py": PANEL,
    "widgets/parts/section.py": PANEL,
    "widgets/controls/lens_controls.py": PANEL,
    "widgets/controls/animation.py": PANEL,
    "widgets/parts/readable.py": Room(QT, ()),
    "widgets/panels/matrix_view.py": Room(
        QT,
        (
            *("app.lecture.notation", "app.lecture.highlight", "app.drawings.style"),
            *("widgets.parts.highlight", "widgets.parts.fields"),
        ),
    ),
    "widgets/panels/matrix_panel.py": Room(
        QT,
        (
            *(
                "app.lecture.notation",
                "app.lecture.typed_matrix",
                "app.model.projection",
                "app.lecture.highlight",
            ),
            *(
                "app.drawings.style",
                "widgets.panels.matrix_view",
                "widgets.parts.messages",
                "widgets.parts.fields",
            ),
            *("widgets.parts.readable", "widgets.parts.focus"),
        ),
    ),
    "widgets/panels/frame_panel.py": Room(
        QT,
        (
            *(
                "app.model.projection",
                "app.lecture.camera_frame",
                "app.lecture.highlight",
                "widgets.parts.focus",
            ),
            *(
                "widgets.parts.highlight",
                "widgets.parts.messages",
                "widgets.parts.fields",
                "widgets.parts.section",
            ),
        ),
    ),
    # Its numbers are those of the command `project`, by the same rung.
    "widgets/panels/probe_panel.py": Room(
        QT,
        (
            *(
                "app.model.projection",
                "app.precision.levels",
                "app.picking.picking",
                "app.lecture.highlight",
            ),
            *(
                "widgets.parts.messages",
                "widgets.parts.palette",
                "widgets.parts.readable",
                "widgets.parts.fields",
            ),
        ),
    ),
    "widgets/parts/diagram.py": Room(
        ("numpy", *QT),
        (
            "app.scenes.phenomena",
            "app.drawings.label_placement",
            "app.drawings.style",
            "widgets.parts.messages",
        ),
    ),
    # The measurement runs as a process of its own: nothing of it stops the window.
    "widgets/panels/measuring.py": Room(
        QT,
        ("app.bootstrap", "app.document.document", "app.measure.results", "widgets.parts.messages"),
    ),
    "widgets/panels/measure_panel.py": Room(
        QT,
        (
            *(
                "app.document.document",
                "app.measure.results",
                "app.measure.meaning",
                "app.measure.chart",
            ),
            *("app.scenes.phenomena.illustration", "app.drawings.style"),
            *(
                "widgets.parts.diagram",
                "widgets.panels.measuring",
                "widgets.parts.messages",
                "widgets.parts.note",
            ),
            "widgets.parts.focus",
        ),
    ),
    # Knows what any phenomenon is made of, and none of them.
    "widgets/panels/scene_panel.py": Room(
        QT,
        (
            *("app.scenes.phenomena.illustration", "app.model.projection", "app.drawings.style"),
            *(
                "widgets.controls.animation",
                "widgets.parts.diagram",
                "widgets.parts.messages",
                "widgets.parts.readable",
            ),
            *("widgets.parts.focus", "widgets.parts.fields"),
        ),
    ),
    "widgets/panes/counting.py": Room(
        QT,
        (
            *("app.scenes.phenomena.illustration", "app.model.projection", "app.scenes.scene"),
            *("app.drawings.rasterising", "app.drawings.figures"),
        ),
    ),
    "widgets/window/export_dialog.py": Room(QT, ("app.drawings.figures", "widgets.parts.messages")),
    "widgets/parts/number_dialog.py": Room(
        QT, ("app.model.projection", "widgets.parts.messages", "widgets.parts.fields")
    ),
    # One pane hosts any drawing, so it knows the drawings' values and none of them.
    "widgets/panes/pane.py": Room(
        ("numpy", "pyvistaqt", *VTK, *QT),
        (
            *("app.model.projection", "app.picking.picking", "app.lecture.highlight"),
            *(
                "app.scenes.scene",
                "app.scenes.phenomena",
                "app.drawings",
                "widgets.parts.palette",
                "widgets.parts.note",
            ),
            "widgets.parts.focus",
        ),
    ),
    # Between two panes and the window: it knows what they draw, and not the store.
    "widgets/panes/manipulation.py": Room(
        ("numpy", *QT),
        (
            *("app.model.projection", "app.picking.picking", "app.picking.handles", "app.drawings"),
            "app.scenes.phenomena.illustration",
            *(
                "widgets.parts.message_bar",
                "widgets.parts.messages",
                "widgets.panes.pane",
                "widgets.parts.fields",
            ),
            "widgets.parts.escape",
        ),
    ),
    "widgets/program/opengl.py": Room(QT),
    "widgets/window/autosave.py": Room(QT, ("app.document.document",)),
    # Opens and saves what the store holds, for the window; the only other one that knows the store.
    "widgets/window/files.py": Room(
        QT,
        (
            *(
                "app.document.document",
                "app.scenes.scene",
                "app.model.projection",
                "app.document.store",
            ),
            *("widgets.parts.message_bar", "widgets.parts.messages"),
        ),
    ),
    "widgets/window/pictures.py": Room(
        ("numpy", *QT),
        (
            *("app.document.document", "app.drawings.figures", "app.scenes.scene"),
            *("widgets.window.export_dialog", "widgets.window.files", "widgets.parts.message_bar"),
            *("widgets.parts.messages", "widgets.parts.palette"),
        ),
    ),
    "widgets/window/help.py": Room(QT),
    "widgets/window/drawer.py": Room(QT),
    "widgets/panes/stage_strip.py": Room(
        QT,
        (
            "app.model.projection",
            "app.lecture.stages",
            "widgets.parts.escape",
            "widgets.parts.note",
        ),
    ),
    "widgets/window/status_line.py": Room(
        QT,
        (
            *(
                "app.model.projection",
                "app.precision.levels",
                "app.precision.risks",
                "app.scenes.scene",
                "app.lecture.highlight",
            ),
            *(
                "app.drawings.frame_budget",
                "app.precision.quality",
                "widgets.parts.highlight",
                "widgets.parts.messages",
                "widgets.parts.fields",
            ),
            "widgets.parts.number_dialog",
        ),
    ),
    # Between the panes and the window: it knows how long frames take, and not the store.
    "widgets/panes/adaptive.py": Room(
        QT,
        (
            "app.scenes.fewer_triangles",
            "app.drawings.frame_budget",
            "app.precision.quality",
            "app.scenes.scene",
            "widgets.panes.pane",
        ),
    ),
    "widgets/window/main_window.py": Room(
        ("numpy", *QT),
        (
            *(
                "app.model.projection",
                "app.lecture.stages",
                "app.picking.picking",
                "app.scenes.scene",
                "app.document.document",
            ),
            *(
                "app.lecture.highlight",
                "app.drawings",
                "app.scenes.phenomena",
                "app.precision.levels",
                "app.precision.quality",
            ),
            *("app.document.store", "app.measure", "widgets"),
        ),
    ),
    # Starts and ends the program round the window.
    "widgets/program/application.py": Room(
        QT,
        (
            "app.bootstrap",
            "app.document.document",
            "app.drawings.frame_budget",
            "app.precision.levels",
            "widgets.program.opengl",
        ),
        late=(*VTK, "app.scenes.scene", "widgets.window.main_window"),
    ),
}


def imports(source: str, package: str) -> list[tuple[str, int, bool]]:
    """Every module that a source file imports.

    Parameters
    ----------
    source : str
        Python source.
    package : str
        The dotted package that the file is in, for relative imports.

    Returns
    -------
    list of (name, line, late)
        Dotted names; a name taken from a package counts as that package's module. `late` is
        whether it happens inside a function or for type checkers only.
    """
    found: list[tuple[str, int, bool]] = []

    def visit(node: ast.AST, late: bool) -> None:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            late = True
        elif isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            for child in node.body:
                visit(child, True)
            for child in node.orelse:
                visit(child, late)
            return
        elif isinstance(node, ast.Import):
            found.extend((alias.name, node.lineno, late) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            parts = package.split(".")[: len(package.split(".")) + 1 - node.level]
            base = ".".join([*(parts if node.level else []), *filter(None, [node.module])])
            found.extend((f"{base}.{alias.name}", node.lineno, late) for alias in node.names)
        elif isinstance(node, ast.Call) and node.args:
            called = ast.unparse(node.func).rpartition(".")[2]
            name = node.args[0]
            if called in ("import_module", "__import__") and isinstance(name, ast.Constant):
                found.append((str(name.value), node.lineno, late))
        for child in ast.iter_child_nodes(node):
            visit(child, late)

    visit(ast.parse(source), False)
    return found


def faults(path: str, source: str) -> list[str]:
    """What in a source file is against the table, one sentence each."""
    room = ROOMS.get(path)
    if room is None:
        return [
            f"{path} is not in the table of tests/house/test_imports.py: say there what it may import"
        ]
    found = []
    for name, line, late in imports(source, path.rpartition("/")[0].replace("/", ".")):
        if name.partition(".")[0] in sys.stdlib_module_names or _is_package_itself(name):
            continue
        free = (*room.packages, *room.rooms)
        if _is_below(name, free) or (late and _is_below(name, room.late)):
            continue
        when = " when it is itself imported" if _is_below(name, room.late) else ""
        found.append(f"{path}:{line} imports {name}, which this room must not{when}")
    return found


def _is_package_itself(name: str) -> bool:
    """Whether this is `app` or its version, as opposed to a room in it."""
    return name in ("app", "app.__version__")


def _is_below(name: str, allowed: tuple[str, ...]) -> bool:
    return any(f"{name}.".startswith(f"{prefix}.") for prefix in allowed)


def sources() -> list[str]:
    """Every source file of the program, as a path from the root with forward slashes."""
    return sorted(
        path.relative_to(ROOT).as_posix()
        for folder in ("app", "widgets")
        for path in (ROOT / folder).rglob("*.py")
    )


@pytest.mark.parametrize("path", sources())
def test_a_room_imports_only_what_the_table_allows(path: str) -> None:
    assert faults(path, (ROOT / path).read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    ("path", "source", "name"),
    [
        ("app/model/projection.py", "import scipy", "scipy"),
        ("app/model/projection.py", "from app import scene", "app.scenes.scene"),
        ("app/arithmetic/double_double.py", "from app import projection", "app.model.projection"),
        ("app/model/projection.py", "from . import scene", "app.scenes.scene"),
        ("app/model/projection.py", "from .scene import load", "app.scenes.scene.load"),
        ("app/model/projection.py", "def f():\n    import pyvista", "pyvista"),
        ("app/drawings/world.py", "from PySide6.QtGui import QColor", "PySide6.QtGui.QColor"),
        ("app/drawings/world.py", "from ..store import Store", "app.document.store.Store"),
        ("app/document/store.py", "from PySide6 import QtWidgets", "PySide6.QtWidgets"),
        (
            "app/drawings/figures.py",
            "import importlib\nimportlib.import_module('widgets')",
            "widgets",
        ),
        ("app/commands/cli.py", "import widgets.window.main_window", "widgets.window.main_window"),
        ("app/commands/cli.py", "class A:\n    from app import scene", "app.scenes.scene"),
        ("widgets/panes/pane.py", "import app.document.store", "app.document.store"),
        (
            "widgets/controls/controls.py",
            "def f():\n    from app import store",
            "app.document.store",
        ),
        ("app/bootstrap.py", "import packaging", "packaging"),
    ],
)
def test_a_forbidden_import_is_found(path: str, source: str, name: str) -> None:
    (fault,) = faults(path, source)
    assert name in fault


@pytest.mark.parametrize(
    ("path", "source"),
    [
        ("app/model/projection.py", "from __future__ import annotations\nimport math, numpy as np"),
        ("app/drawings/ndc.py", "from .actors import lifted\nfrom ..scene import Scene"),
        ("app/commands/cli.py", "def f():\n    from widgets import application"),
        ("app/commands/cli.py", "if TYPE_CHECKING:\n    from app.scenes.scene import Scene"),
        ("app/commands/doctor.py", "from app import __version__"),
    ],
)
def test_an_allowed_import_is_let_pass(path: str, source: str) -> None:
    assert faults(path, source) == []


def test_a_file_outside_the_table_is_told_so() -> None:
    (fault,) = faults("app/shadows.py", "")
    assert "app/shadows.py is not in the table" in fault


def test_every_package_in_use_is_declared() -> None:
    declared = {requirement.import_name for requirement in requirements(ROOT)}
    used = {
        name.partition(".")[0]
        for path in sources()
        for name, _, _ in imports((ROOT / path).read_text(encoding="utf-8"), Path(path).parts[0])
    }
    assert used - set(sys.stdlib_module_names) - {"app", "widgets"} <= declared


@pytest.mark.parametrize(
    "module",
    [
        "app.bootstrap",
        "app.model.projection",
        "app.document.document",
        "app.commands.cli",
        "app.__main__",
    ],
)
def test_numbers_start_without_pictures(module: str) -> None:
    """In a fresh interpreter, because this one has long imported everything."""
    probe = f"import sys, {module}; print(*sorted({{m.partition('.')[0] for m in sys.modules}}))"
    done = subprocess.run(
        [sys.executable, "-c", probe], cwd=ROOT, capture_output=True, text=True, check=True
    )
    loaded = done.stdout.split()
    assert "app" in loaded
    slow = {"PySide6", "shiboken6", "vtkmodules", "pyvista", "matplotlib", "mpmath"}
    assert not slow & set(loaded)
