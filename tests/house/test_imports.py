"""Who may import whom, by folder: a folder imports what stands before it, and itself.

`docs/architecture.md` says what each folder owns. What a file imports only inside a function or for
type checkers is late: importing the file does not bring it.
"""

import ast
import functools
import subprocess
import sys
from graphlib import TopologicalSorter

import pytest

from app.bootstrap import ROOT
from app.model.lenses import LENSES, FreeMatrix
from app.python_packages import requirements
from tests.support.sources import nodes_of

VTK = ("vtkmodules",)
QT = ("PySide6",)

#: From the ground up. Folders of one line do not know each other.
FLOORS = (
    ("app.arithmetic",),
    ("app.model",),
    ("app.lecture", "app.precision", "app.picking"),
    ("app.scenes",),
    ("app.document",),
    ("app.lessons",),
    ("app.drawings",),
    ("app.measure", "app.api"),
    ("widgets.parts",),
    ("widgets.controls", "widgets.panels", "widgets.panes"),
    ("widgets.window",),
    ("widgets.program",),
    ("app.commands",),
    ("app.__main__",),
    ("app.wheel",),
)
FLOOR = {folder: number for number, folders in enumerate(FLOORS) for folder in folders}
#: Packages of others that a folder, or one file, may import at once, beside numpy.
AT_ONCE: dict[str, tuple[str, ...]] = {
    "app.document": ("PySide6.QtCore",),
    "app.drawings": (*VTK, "PIL"),
    "app.measure": VTK,
    "app.scenes.poly_mesh": VTK,
    "widgets.parts": QT,
    "widgets.controls": QT,
    "widgets.panels": QT,
    "widgets.panes": QT,
    "widgets.panes.interactor": (*QT, *VTK),
    "widgets.window": QT,
    "widgets.program": QT,
}
#: And late.
LATE: dict[str, tuple[str, ...]] = {
    "app.lecture": ("matplotlib",),
    "app.drawings": ("matplotlib", "fontTools", "pyvista"),
    "app.scenes": (*VTK, "mapbox_earcut"),
    "app.lessons": ("markdown_it",),
    "app.measure": ("mpmath",),
    "widgets.panes": VTK,
    "widgets.program": VTK,
    "app.commands": (*VTK, *QT),
}
#: What everyone may know: standard library only. Each knows only those before it.
GROUND = (
    "app.modules",
    "app.languages",
    "app.strangers",
    "app.python_packages",
    "app.held_lock",
    "app.system_packages",
    "app.bootstrap",
)
#: What only some may know although it stands below them: the window joins store and widgets.
NOT_FOR = {
    "app.document.store": ("app", "widgets.parts", "widgets.controls", "widgets.panels",
                           "widgets.panes"),
    "vtkmodules": ("app.scenes.phenomena",),
}  # fmt: skip


def module_of(path: str) -> str:
    """The dotted name of a source file."""
    return path.removesuffix(".py").removesuffix("/__init__").replace("/", ".")


def folder_of(module: str) -> str:
    """The package of a module in the table; empty for modules outside all packages."""
    return ".".join(module.split(".")[:2]) if module.count(".") else ""


@functools.cache
def imports(path: str, source: str) -> list[tuple[str, int, bool]]:
    """Every module that a source file imports.

    Parameters
    ----------
    path : str
        From the root, with forward slashes; relative imports start from it.
    source : str
        Python source.

    Returns
    -------
    list of (name, line, late)
        Dotted names; a name taken from a package counts as that package's module.
    """
    found: list[tuple[str, int, bool]] = []
    package = path.rpartition("/")[0].split("/")

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
            parts = package[: len(package) + 1 - node.level] if node.level else []
            base = ".".join([*parts, *filter(None, [node.module])])
            found.extend((f"{base}.{alias.name}", node.lineno, late) for alias in node.names)
        elif isinstance(node, ast.Call) and node.args:
            called = ast.unparse(node.func).rpartition(".")[2]
            name = node.args[0]
            if called in ("import_module", "__import__") and isinstance(name, ast.Constant):
                found.append((str(name.value), node.lineno, late))
        for child in ast.iter_child_nodes(node):
            visit(child, late)

    visit(nodes_of(source)[0], False)
    return found


def is_below(name: str, prefixes: tuple[str, ...]) -> bool:
    """Whether a dotted name is one of the prefixes or inside of it."""
    return any(f"{name}.".startswith(f"{prefix}.") for prefix in prefixes)


def faults(path: str, source: str) -> list[str]:
    """Return the imports of a source file that the table forbids, one sentence each."""
    module = module_of(path)
    folder = folder_of(module)
    ground = GROUND[: GROUND.index(module)] if module in GROUND else GROUND
    if module in ("app", "widgets"):
        ground = GROUND[:1]
    if module in ("app", "widgets", *GROUND):
        floor = -1
    elif module == "app.__main__":
        floor = len(FLOORS)
    elif folder in FLOOR:
        floor = FLOOR[folder]
    else:
        return [f"{path} is in no folder of the table."]
    free = () if floor < 0 else ("numpy", *AT_ONCE.get(module, AT_ONCE.get(folder, ())))
    late_free = LATE.get(folder, ())
    found = []
    for name, line, late in imports(path, source):
        if name.partition(".")[0] in sys.stdlib_module_names or name in ("app", "app.__version__"):
            continue
        if name.partition(".")[0] in ("app", "widgets"):
            other = folder_of(name)
            fits = (
                other == folder or is_below(name, ground) or FLOOR.get(other, len(FLOORS)) < floor
            )
        else:
            fits = is_below(name, free) or (late and is_below(name, late_free))
        kept_from = (
            others for what, others in NOT_FOR.items() if is_below(name, (what,)) and name != module
        )
        if not fits or any(is_below(module, others) for others in kept_from):
            found.append(f"{path}:{line} imports {name}, which this folder must not")
    return found


def sources() -> list[str]:
    """Every source file of the program, as a path from the root with forward slashes."""
    return sorted(
        path.relative_to(ROOT).as_posix()
        for folder in ("app", "widgets")
        for path in (ROOT / folder).rglob("*.py")
    )


def read(path: str) -> str:
    """The text of a source file."""
    return (ROOT / path).read_text(encoding="utf-8")


def test_a_folder_imports_only_folders_below_it() -> None:
    assert [fault for path in sources() for fault in faults(path, read(path))] == []


def test_no_files_import_each_other_in_a_circle() -> None:
    """Late imports count too: a circle is one, whenever it is walked."""
    modules = {module_of(path): path for path in sources()}
    graph = {
        module: {
            known
            for name, _, _ in imports(path, read(path))
            for known in (name, name.rpartition(".")[0])
            if known in modules and known != module and not modules[known].endswith("__init__.py")
        }
        for module, path in modules.items()
    }
    assert len(list(TopologicalSorter(graph).static_order())) >= len(modules) - 20  # or CycleError


def questions(source: str) -> list[str]:
    """Where a source file asks which lens it is: ``isinstance``, and ``.parallel``."""
    classes = {"Lens", "ClosedForm", "Central", "Parallel", "Windowed"}
    classes |= {lens.__name__ for lens in (*LENSES.values(), FreeMatrix)}
    found = []
    for node in nodes_of(source):
        if isinstance(node, ast.Attribute) and node.attr == "parallel":
            found.append(ast.unparse(node))
        elif isinstance(node, ast.Call) and ast.unparse(node.func) == "isinstance":
            names = {ast.unparse(part) for part in ast.walk(node.args[1])}
            if names & classes:
                found.append(ast.unparse(node))
    return found


def test_few_places_outside_the_lenses_test_the_kind_of_lens() -> None:
    """What differs between lenses is a number or a method of theirs (DESIGN section 2)."""
    assert questions("x = isinstance(a.lens, Frustum | Oblique) or lens.parallel") != []
    asked = {
        path: questions(read(path))
        for path in sources()
        if not path.startswith("app/model/lenses/")
    }
    assert sum(map(len, asked.values())) <= 10, {path: q for path, q in asked.items() if q}


@pytest.mark.parametrize(
    ("path", "source", "name"),
    [
        ("app/model/projection.py", "import scipy", "scipy"),
        ("app/model/projection.py", "from app.scenes import scene", "app.scenes.scene"),
        ("app/arithmetic/rationals.py", "from app.model import camera", "app.model.camera"),
        ("app/model/projection.py", "from ..scenes.scene import load", "app.scenes.scene.load"),
        ("app/model/projection.py", "def f():\n    import pyvista", "pyvista"),
        ("app/lecture/stages.py", "import app.precision.levels", "app.precision.levels"),
        ("app/scenes/phenomena/focus.py", "import vtkmodules", "vtkmodules"),
        ("app/drawings/world.py", "from PySide6.QtGui import QColor", "PySide6.QtGui.QColor"),
        ("app/drawings/world.py", "import app.document.store", "app.document.store"),
        ("app/document/store.py", "from PySide6 import QtWidgets", "PySide6.QtWidgets"),
        ("app/drawings/figure.py", "import importlib\nx = __import__('widgets')", "widgets"),
        ("app/commands/cli.py", "import pyvista", "pyvista"),
        ("app/commands/cli.py", "class A:\n    import PySide6", "PySide6"),
        ("widgets/panes/pane.py", "import app.document.store", "app.document.store"),
        ("widgets/panels/matrix_view.py", "import widgets.panes.pane", "widgets.panes.pane"),
        ("widgets/parts/icons.py", "import widgets.window.files", "widgets.window.files"),
        ("app/bootstrap.py", "import packaging", "packaging"),
        ("app/__init__.py", "import app.bootstrap", "app.bootstrap"),
        ("app/shadows.py", "", "app/shadows.py"),
    ],
)  # fmt: skip
def test_a_forbidden_import_is_found(path: str, source: str, name: str) -> None:
    (fault,) = faults(path, source)
    assert name in fault


@pytest.mark.parametrize(
    ("path", "source"),
    [
        ("app/model/projection.py", "from __future__ import annotations\nimport math, numpy"),
        ("app/drawings/stage.py", "from .actors import lifted\nfrom ..scenes.scene import Scene"),
        ("app/commands/cli.py", "def f():\n    import vtkmodules"),
        ("app/commands/cli.py", "if TYPE_CHECKING:\n    import PySide6"),
        ("app/commands/doctor.py", "from app import __version__, bootstrap"),
        ("widgets/window/files.py", "import app.document.store"),
    ],
)
def test_an_allowed_import_is_accepted(path: str, source: str) -> None:
    assert faults(path, source) == []


def test_every_package_in_use_is_declared() -> None:
    declared = {requirement.import_name for requirement in requirements(ROOT)}
    used = {
        name.partition(".")[0] for path in sources() for name, _, _ in imports(path, read(path))
    }
    # matplotlib needs fontTools, and `Figure.plotter` says that pyvista is missing.
    known = {"app", "widgets", "fontTools", "pyvista"} | set(sys.stdlib_module_names)
    assert used - known <= declared


def test_numbers_start_without_pictures() -> None:
    """In a fresh interpreter, because this one has long imported everything."""
    modules = ["api", "bootstrap", "model.projection", "document.settings", "commands.cli"]
    probe = f"""import sys, {", ".join(f"app.{name}" for name in modules)}, app.__main__
print(*sorted({{name.partition(".")[0] for name in sys.modules}}))"""
    done = subprocess.run(
        [sys.executable, "-c", probe], cwd=ROOT, capture_output=True, text=True, check=True
    )
    loaded = done.stdout.split()
    assert "app" in loaded
    slow = {"PySide6", "shiboken6", "vtkmodules", "pyvista", "matplotlib", "mpmath", "trimesh"}
    assert not slow & set(loaded)
