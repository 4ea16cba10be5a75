"""The folder to carry; the whole of it takes minutes, and is made by the workflow and by hand."""

import ast
import importlib.util
import runpy
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from app import modules
from app.bootstrap import ROOT
from app.commands import bundle
from app.commands.terminal import CliError
from app.python_packages import pins, requirements
from tests.house.test_imports import module_of, sources


@pytest.fixture(scope="module")
def spec() -> dict[str, Any]:
    """What ``frustum-lab.spec`` defines, without making anything."""
    return runpy.run_path(str(ROOT / "frustum-lab.spec"), {"SPECPATH": str(ROOT)})


def test_the_program_has_every_file_that_a_wheel_has(spec: dict[str, Any]) -> None:
    of_wheel = dict(runpy.run_path(str(ROOT / "wheel_backend.py"))["files"]())
    beside = {
        name.removeprefix("frustum_lab/")
        for name in of_wheel
        if not name.endswith((".py", ".typed"))
    }
    assert len(beside) > 60
    entries = [(f"{folder}/{Path(path).name}", path, "DATA") for path, folder in spec["data"]()]
    carried = {name.replace("\\", "/") for name, _, _ in spec["kept"](entries)}
    assert carried - {"app/wheel/frustum_lab/py.typed"} == beside


def test_the_program_has_every_module(spec: dict[str, Any]) -> None:
    names = {module_of(path).removesuffix(".__init__") for path in sources()}
    assert set(spec["modules"]()) == {name for name in names if not name.startswith("app.wheel")}


def test_no_package_that_the_program_imports_is_left_out(spec: dict[str, Any]) -> None:
    needed = {each.import_name for each in requirements(ROOT)}
    assert not needed & set(spec["EXCLUDED"])
    texts = [(ROOT / path).read_text(encoding="utf-8") for path in sources()]
    assert not [name for name in spec["EMPTIED"] if any(name in text for text in texts)]


def test_the_driver_of_the_machine_finds_its_own_libraries(spec: dict[str, Any]) -> None:
    entries = [
        ("libstdc++.so.6", "/usr/lib/x86_64-linux-gnu/libstdc++.so.6", "BINARY"),
        ("libxcb-cursor.so.0", "/usr/lib/x86_64-linux-gnu/libxcb-cursor.so.0", "DATA"),
        ("PySide6/Qt/qml/a.qml", "/somewhere/a.qml", "DATA"),
    ]
    kept = [name for name, _, _ in spec["kept"](entries)]
    if sys.platform.startswith("linux"):
        assert kept == ["libxcb-cursor.so.0"]


FROZEN = "import sys; sys.frozen = True; from app.__main__ import main; sys.exit(main())"


def test_the_program_runs_its_children_in_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(modules, "FROZEN", True)
    command = modules.command("app", "matrices", "--set", "lens.far=inf")
    assert command == [sys.executable, "-m", "app", "matrices", "--set", "lens.far=inf"]
    child = [sys.executable, "-c", FROZEN, *command[1:]]
    usual = [sys.executable, *command[1:]]
    made, expected = (
        subprocess.run(each, cwd=ROOT, capture_output=True, text=True, check=True)
        for each in (child, usual)
    )
    assert made.stdout == expected.stdout != ""


def test_every_child_is_a_module_of_the_program(spec: dict[str, Any]) -> None:
    names = [
        ast.literal_eval(node.args[0])
        for path in sources()
        for node in ast.walk(ast.parse((ROOT / path).read_text(encoding="utf-8")))
        if isinstance(node, ast.Call)
        and ast.unparse(node.func) in ("modules.command", "_try")
        and isinstance(node.args[0], ast.Constant)
    ]
    assert len(names) >= 4 + 1  # and PyInstaller itself
    assert {*names} - {"PyInstaller"} <= {*spec["modules"]()}


def test_without_pyinstaller_one_sentence_says_how_to_get_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda _name: None)
    with pytest.raises(CliError, match=r"needs PyInstaller.*pip install ['\"]pyinstaller>=\d.*<\d"):
        bundle.run([str(tmp_path / "out")])
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_there_is_not_overwritten(tmp_path: Path) -> None:
    (tmp_path / "frustum-lab").mkdir()
    with pytest.raises(CliError, match="is there already"):
        bundle.run([str(tmp_path)])


def test_wheels_come_with_the_code_for_each_platform_and_python(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[list[str]] = []

    def pip(command: list[str], **_: object) -> object:
        calls.append(command)
        return SimpleNamespace(returncode=0)

    monkeypatch.setattr(subprocess, "run", pip)
    options = ["--platform=windows-x86_64", "--platform=linux-arm64", "--python=3.13"]
    bundle.run([str(tmp_path), "--wheels", *options])
    folder = tmp_path / "frustum-lab"
    assert {"app", "widgets", "__main__.py", "pyproject.toml", "constraints.txt"} <= {
        path.name for path in folder.iterdir()
    }
    windows, linux = calls
    assert windows[windows.index("--platform") + 1] == "win_amd64"
    assert "manylinux_2_28_aarch64" in linux
    for command in calls:
        assert command[command.index("--dest") + 1] == str(folder / "wheels")
        assert command[command.index("--python-version") + 1] == "3.13"
        assert any(word.startswith("PySide6-Essentials>=6.11.2,<6.13") for word in command)


def test_pins_are_those_of_the_python() -> None:
    assert any(pin.startswith("numpy==2.4") for pin in pins(ROOT, "3.11"))
    assert any(pin.startswith("numpy==2.5") for pin in pins(ROOT, "3.13"))
    assert not any(";" in pin for pin in pins(ROOT))
