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
        *("app.projection", "app.precision", "app.morph", "app.picking", "app.clipping"),
        *("app.attention", "app.camera_frame", "app.handles", "app.quality"),
        *("app.scene", "app.phenomena", "app.drawings"),
    ),
)
PHENOMENON = Room(
    ("numpy",),
    (
        *("app.projection", "app.values", "app.precision", "app.depth", "app.clipping"),
        *("app.shapes", "app.phenomena"),
    ),
)
MEASURE = Room(
    ("numpy", *VTK),
    (
        *("app.projection", "app.precision", "app.depth", "app.clipping"),
        *("app.scene", "app.drawings", "app.document", "app.figures", "app.measure", "app.detail"),
    ),
)
#: Widgets know the model's values and each other's words, not the store: the window connects them.
PANEL = Room(
    ("numpy", *QT),
    (
        "app.attention",
        "app.projection",
        "widgets.animation",
        "widgets.attention",
        "widgets.escape",
        "widgets.focus",
        "widgets.messages",
        "widgets.palette",
        "widgets.rows",
        "widgets.section",
        "widgets.lens_controls",
    ),
)

ROOMS = {
    "app/__init__.py": Room(),
    "app/bootstrap.py": Room(),
    # Help, and what is wrong with an option, before anything is set up.
    "app/options.py": Room(rooms=("app.strangers",)),
    "app/__main__.py": Room(late=("app.bootstrap", "app.options", "app.doctor", "app.cli")),
    "app/double_double.py": CORE,
    "app/values.py": CORE,
    "app/camera.py": Room(("numpy",), ("app.double_double", "app.values")),
    "app/lenses.py": Room(rooms=("app.double_double", "app.values")),
    "app/rationals.py": Room(),
    # The model's one door: what values, camera and lenses hold is had from here.
    "app/projection.py": Room(
        ("numpy",),
        ("app.double_double", "app.rationals", "app.values", "app.camera", "app.lenses"),
    ),
    "app/precision.py": Room(("numpy",), ("app.double_double", "app.projection")),
    "app/depth.py": Room(("numpy",), ("app.projection",)),
    "app/clipping.py": Room(("numpy",), ("app.projection",)),
    "app/morph.py": Room(("numpy",), ("app.projection",)),
    "app/free_matrix.py": Room(rooms=("app.double_double", "app.rationals", "app.projection")),
    "app/dependence.py": Room(rooms=("app.projection",)),
    "app/notation.py": Room(rooms=("app.attention", "app.dependence", "app.projection")),
    # Names only: the words in which rooms that know nothing of each other point at things.
    "app/attention.py": Room(),
    "app/camera_frame.py": Room(("numpy",), ("app.double_double", "app.values", "app.projection")),
    "app/picking.py": Room(("numpy",), ("app.projection",)),
    "app/handles.py": Room(("numpy",), ("app.projection", "app.picking")),
    "app/placing.py": CORE,
    "app/health.py": Room(rooms=("app.projection", "app.precision", "app.depth")),
    "app/shapes.py": CORE,
    # Each phenomenon is numpy only: the command line reads its settings without VTK.
    **{
        str(path.relative_to(ROOT).as_posix()): PHENOMENON
        for path in (ROOT / "app" / "phenomena").glob("*.py")
    },
    "app/strangers.py": Room(),
    "app/meshes.py": Room(("numpy",), ("app.strangers",)),
    "app/reading.py": Room(("numpy",), ("app.meshes",)),
    "app/scene.py": Room(
        ("numpy", *VTK),
        ("app.projection", "app.shapes", "app.meshes", "app.reading", "app.phenomena"),
    ),
    "app/quality.py": Room(rooms=("app.projection", "app.depth")),
    "app/pace.py": Room(),
    "app/document.py": Room(
        rooms=("app.projection", "app.phenomena", "app.quality", "app.strangers")
    ),
    "app/drawings/__init__.py": DRAWING,
    "app/drawings/actors.py": DRAWING,
    "app/drawings/rungs.py": DRAWING,
    "app/drawings/style.py": DRAWING,
    "app/drawings/frame.py": DRAWING,
    "app/drawings/labels.py": DRAWING,
    "app/drawings/rasterising.py": Room(
        DRAWING.packages, (*DRAWING.rooms, "app.depth", "app.phenomena")
    ),
    "app/drawings/pointing.py": DRAWING,
    "app/drawings/probes.py": DRAWING,
    "app/drawings/handles.py": DRAWING,
    "app/drawings/marks.py": DRAWING,
    "app/drawings/world.py": DRAWING,
    "app/drawings/ndc.py": DRAWING,
    "app/drawings/image.py": DRAWING,
    "app/figures.py": Room(
        ("numpy", "PIL", *VTK),
        (
            *("app.projection", "app.meshes", "app.scene", "app.phenomena"),
            *("app.drawings", "app.document", "app.detail", "app.precision", "app.quality"),
        ),
    ),
    # What is measured, and how it is kept, needs no OpenGL until a picture is timed.
    "app/measure/results.py": Room(),
    "app/measure/run.py": Room(),
    # mpmath only when something is judged: a window knows the rooms of the measurements.
    "app/measure/reference.py": Room(("numpy",), ("app.projection",), late=("mpmath",)),
    # matplotlib only when a picture is drawn without a window.
    "app/measure/chart.py": Room(
        ("numpy",),
        (
            *("app.measure", "app.phenomena.exhibit"),
            *("app.placing", "app.drawings.style"),
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
    "app/measure/command.py": Room(
        rooms=(
            *("app.arguments", "app.options", "app.document", "app.doctor"),
            *("app.projection", "app.measure"),
        )
    ),
    "app/detail.py": Room(("numpy", *VTK), ("app.scene",)),
    "app/store.py": Room(QT_CORE, ("app.projection", "app.document")),
    # What the commands share: no command of its own, and a scene only when it is asked for.
    "app/arguments.py": Room(
        rooms=("app.bootstrap", "app.options", "app.projection", "app.document", "app.phenomena"),
        late=("app.scene",),
    ),
    # The command line starts with numbers only; pictures and windows come when they are asked for.
    "app/cli.py": Room(
        ("numpy",),
        (
            *("app.arguments", "app.options", "app.projection", "app.precision", "app.notation"),
            *("app.bootstrap", "app.document", "app.doctor", "app.free_matrix"),
        ),
        late=(*VTK, *QT, "app", "widgets"),
    ),
    "app/doctor.py": Room(
        rooms=("app.bootstrap", "app.options"), late=(*VTK, *QT, "app", "widgets")
    ),
    "widgets/__init__.py": Room(),
    "widgets/palette.py": Room(QT, ("app.drawings.style",)),
    "widgets/attention.py": Room(QT, ("app.attention",)),
    "widgets/messages.py": Room(QT, ("app.projection", "app.document")),
    "widgets/note.py": Room(QT),
    "widgets/escape.py": Room(QT),
    "widgets/focus.py": Room(QT),
    "widgets/message_bar.py": PANEL,
    "widgets/rows.py": PANEL,
    "widgets/controls.py": PANEL,
    "widgets/section.py": PANEL,
    "widgets/lens_controls.py": PANEL,
    "widgets/animation.py": PANEL,
    "widgets/readable.py": Room(QT, ()),
    "widgets/matrix_view.py": Room(
        QT,
        (
            *("app.notation", "app.attention", "app.drawings.style"),
            *("widgets.attention", "widgets.rows"),
        ),
    ),
    "widgets/matrix_panel.py": Room(
        QT,
        (
            *("app.notation", "app.free_matrix", "app.projection", "app.attention"),
            *("app.drawings.style", "widgets.matrix_view", "widgets.messages", "widgets.rows"),
            *("widgets.readable", "widgets.focus"),
        ),
    ),
    "widgets/frame_panel.py": Room(
        QT,
        (
            *("app.projection", "app.camera_frame", "app.attention", "widgets.focus"),
            *("widgets.attention", "widgets.messages", "widgets.rows", "widgets.section"),
        ),
    ),
    # Its numbers are those of the command `project`, by the same rung.
    "widgets/probe_panel.py": Room(
        QT,
        (
            *("app.projection", "app.precision", "app.picking", "app.attention"),
            *("widgets.messages", "widgets.palette", "widgets.readable", "widgets.rows"),
        ),
    ),
    "widgets/diagram.py": Room(
        ("numpy", *QT),
        ("app.phenomena", "app.placing", "app.drawings.style", "widgets.messages"),
    ),
    # The measurement runs as a process of its own: nothing of it stops the window.
    "widgets/measuring.py": Room(
        QT, ("app.bootstrap", "app.document", "app.measure.results", "widgets.messages")
    ),
    "widgets/measure_panel.py": Room(
        QT,
        (
            *("app.document", "app.measure.results", "app.measure.meaning", "app.measure.chart"),
            *("app.phenomena.exhibit", "app.drawings.style"),
            *("widgets.diagram", "widgets.measuring", "widgets.messages", "widgets.note"),
            "widgets.focus",
        ),
    ),
    # Knows what any phenomenon is made of, and none of them.
    "widgets/scene_panel.py": Room(
        QT,
        (
            *("app.phenomena.exhibit", "app.projection", "app.drawings.style"),
            *("widgets.animation", "widgets.diagram", "widgets.messages", "widgets.readable"),
            *("widgets.focus", "widgets.rows"),
        ),
    ),
    "widgets/counting.py": Room(
        QT,
        (
            *("app.phenomena.exhibit", "app.projection", "app.scene"),
            *("app.drawings.rasterising", "app.figures"),
        ),
    ),
    "widgets/export_dialog.py": Room(QT, ("app.figures", "widgets.messages")),
    "widgets/number_dialog.py": Room(QT, ("app.projection", "widgets.messages", "widgets.rows")),
    # One pane hosts any drawing, so it knows the drawings' values and none of them.
    "widgets/pane.py": Room(
        ("numpy", "pyvistaqt", *VTK, *QT),
        (
            *("app.projection", "app.picking", "app.attention"),
            *("app.scene", "app.phenomena", "app.drawings", "widgets.palette", "widgets.note"),
            "widgets.focus",
        ),
    ),
    # Between two panes and the window: it knows what they draw, and not the store.
    "widgets/manipulation.py": Room(
        ("numpy", *QT),
        (
            *("app.projection", "app.picking", "app.handles", "app.drawings"),
            "app.phenomena.exhibit",
            *("widgets.message_bar", "widgets.messages", "widgets.pane", "widgets.rows"),
            "widgets.escape",
        ),
    ),
    "widgets/opengl.py": Room(QT),
    "widgets/autosave.py": Room(QT, ("app.document",)),
    # Opens and saves what the store holds, for the window; the only other one that knows the store.
    "widgets/files.py": Room(
        QT,
        (
            *("app.document", "app.scene", "app.projection", "app.store"),
            *("widgets.message_bar", "widgets.messages"),
        ),
    ),
    "widgets/pictures.py": Room(
        ("numpy", *QT),
        (
            *("app.document", "app.figures", "app.scene"),
            *("widgets.export_dialog", "widgets.files", "widgets.message_bar"),
            *("widgets.messages", "widgets.palette"),
        ),
    ),
    "widgets/help.py": Room(QT),
    "widgets/panels.py": Room(QT),
    "widgets/stage_strip.py": Room(
        QT, ("app.projection", "app.morph", "widgets.escape", "widgets.note")
    ),
    "widgets/status_line.py": Room(
        QT,
        (
            *("app.projection", "app.precision", "app.health", "app.scene", "app.attention"),
            *("app.pace", "app.quality", "widgets.attention", "widgets.messages", "widgets.rows"),
            "widgets.number_dialog",
        ),
    ),
    # Between the panes and the window: it knows how long frames take, and not the store.
    "widgets/adaptive.py": Room(
        QT, ("app.detail", "app.pace", "app.quality", "app.scene", "widgets.pane")
    ),
    "widgets/main_window.py": Room(
        ("numpy", *QT),
        (
            *("app.projection", "app.morph", "app.picking", "app.scene", "app.document"),
            *("app.attention", "app.drawings", "app.phenomena", "app.precision", "app.quality"),
            *("app.store", "app.measure", "widgets"),
        ),
    ),
    # Starts and ends the program round the window.
    "widgets/application.py": Room(
        QT,
        ("app.bootstrap", "app.document", "app.pace", "app.precision", "widgets.opengl"),
        late=(*VTK, "app.scene", "widgets.main_window"),
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
            f"{path} is not in the table of tests/test_imports.py: say there what it may import"
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
        ("app/projection.py", "import scipy", "scipy"),
        ("app/projection.py", "from app import scene", "app.scene"),
        ("app/double_double.py", "from app import projection", "app.projection"),
        ("app/projection.py", "from . import scene", "app.scene"),
        ("app/projection.py", "from .scene import load", "app.scene.load"),
        ("app/projection.py", "def f():\n    import pyvista", "pyvista"),
        ("app/drawings/world.py", "from PySide6.QtGui import QColor", "PySide6.QtGui.QColor"),
        ("app/drawings/world.py", "from ..store import Store", "app.store.Store"),
        ("app/store.py", "from PySide6 import QtWidgets", "PySide6.QtWidgets"),
        ("app/figures.py", "import importlib\nimportlib.import_module('widgets')", "widgets"),
        ("app/cli.py", "import widgets.main_window", "widgets.main_window"),
        ("app/cli.py", "class A:\n    from app import scene", "app.scene"),
        ("widgets/pane.py", "import app.store", "app.store"),
        ("widgets/controls.py", "def f():\n    from app import store", "app.store"),
        ("app/bootstrap.py", "import packaging", "packaging"),
    ],
)
def test_a_forbidden_import_is_found(path: str, source: str, name: str) -> None:
    (fault,) = faults(path, source)
    assert name in fault


@pytest.mark.parametrize(
    ("path", "source"),
    [
        ("app/projection.py", "from __future__ import annotations\nimport math, numpy as np"),
        ("app/drawings/ndc.py", "from .actors import lifted\nfrom ..scene import Scene"),
        ("app/cli.py", "def f():\n    from widgets import application"),
        ("app/cli.py", "if TYPE_CHECKING:\n    from app.scene import Scene"),
        ("app/doctor.py", "from app import __version__"),
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
    "module", ["app.bootstrap", "app.projection", "app.document", "app.cli", "app.__main__"]
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
