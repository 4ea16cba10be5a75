"""The wheel has one top-level name, so that an `app.py` beside a notebook meets nothing of it."""

import importlib.util
import json
import os
import runpy
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest

from app.bootstrap import ROOT
from app.python_packages import requirements
from app.scenes import reading
from tests import PATIENCE_S
from tests.support.lessons import PREDICTED
from tests.support.meshes import obj_file


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    return folder / runpy.run_path(str(ROOT / "wheel_backend.py"))["build_wheel"](str(folder))


@pytest.fixture(scope="module")
def place(wheel: Path) -> Path:
    """A folder with an `app.py` and a `widgets.py` that no one may import, the wheel beside it."""
    zipfile.ZipFile(wheel).extractall(wheel.parent / "site")
    folder = wheel.parent / "notebooks"
    folder.mkdir()
    for name in ("app", "widgets"):
        (folder / f"{name}.py").write_text(
            f"raise SystemExit('{name}.py is imported')\n", encoding="utf-8"
        )
    return folder


def installed(place: Path, *words: str | Path) -> str:
    """Return what Python prints, started where somebody else's files are."""
    environment = {**os.environ, "PYTHONPATH": str(place.parent / "site")}
    done = subprocess.run(
        [sys.executable, *map(str, words)], cwd=place, env=environment, capture_output=True,
        text=True, check=False, timeout=PATIENCE_S,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_a_wheel_has_one_name_and_every_file(wheel: Path) -> None:
    entries = set(zipfile.ZipFile(wheel).namelist())
    assert {name.partition("/")[0].partition("-")[0] for name in entries} == {"frustum_lab"}
    kept = {
        path.relative_to(ROOT).as_posix()
        for folder in ("app", "widgets")
        for path in (ROOT / folder).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    packed = {name.removeprefix("frustum_lab/") for name in entries if ".dist-info/" not in name}
    packed -= {"__init__.py", "__main__.py", "py.typed"}
    assert packed == {name for name in kept if not name.startswith("app/wheel/")}


def test_pip_installs_the_wheel_without_a_network(wheel: Path) -> None:
    if importlib.util.find_spec("pip") is None:
        pytest.skip("this Python has no pip")
    site = wheel.parent / "by-pip" / "site"
    words = ["-I", "-m", "pip", "install", "--no-index", "--no-deps", "--quiet", "--target"]
    subprocess.run([sys.executable, *words, site, ROOT], check=True, timeout=PATIENCE_S)
    assert "Frustum Lab" in installed(site, site / "bin" / "frustum-lab", "--version")
    script = "from importlib import metadata as m; print(*m.requires('frustum-lab'), sep='\\n')"
    needed = installed(site, "-c", script).splitlines()
    assert {each.text for each in requirements(ROOT)} <= {each.partition(";")[0] for each in needed}
    assert any(each.endswith("extra == 'bundle'") for each in needed)


def test_a_script_draws_beside_files_of_these_names(place: Path) -> None:
    script = """
import sys
import frustum_lab as lab
assert "numpy" not in sys.modules
document = lab.load("letter-f", "lens.near=2")
assert lab.project(document, [0.0, 0.0, 0.0]).image.shape == (2,)
lab.figure(document, panes="image").save("figure.svg")
from frustum_lab import *
print(__version__, Projection.__module__, [n for n in sys.modules if n.startswith(("app", "widg"))])
"""
    assert installed(place, "-c", script).endswith("frustum_lab.app.model.projection []\n")
    assert "<svg" in (place / "figure.svg").read_text(encoding="utf-8")


def test_a_large_mesh_is_read_by_a_process_of_its_own(place: Path) -> None:
    points = np.random.default_rng(1).normal(size=(30_000, 3))
    obj_file(place / "large.obj", points)
    assert (place / "large.obj").stat().st_size > reading.SMALL
    script = "import frustum_lab as lab; print(lab.describe(lab.load('large.obj')).text)"
    assert "The eye is at" in installed(place, "-c", script)


def test_its_commands_start_their_children(place: Path, tmp_path: Path) -> None:
    """A lesson's formulas and pictures are checked, a trade is measured, drivers are tried."""
    lesson = tmp_path / "own.md"
    lesson.write_text(PREDICTED.replace("At 2", "At $2$"), encoding="utf-8")
    script = """
import sys
from frustum_lab.app.commands.cli import main
for words in sys.argv[1:]:
    main(words.split())
"""
    measure = "measure --quick --trade=depth --json -"
    said = installed(place, "-c", script, f"lesson check {lesson}", "doctor", measure)
    assert "1 lesson, 0 talks, 1 check, 0 wrong" in said and " of 1 step" in said
    assert str(place.parent / "site") in said and "without a display through" in said
    assert "Panes" in said
    (trade,) = json.loads(said[said.index("\n{") :])["trades"]
    assert trade["name"] == "depth" and trade["choices"]


def test_the_window_opens(place: Path) -> None:
    installed(place, "-m", "frustum_lab", "--screenshot", "window.png", "--size", "1366x768")
    assert (place / "window.png").stat().st_size > 50_000
