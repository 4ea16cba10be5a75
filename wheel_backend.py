"""How pip makes the wheel: everything lies under one name, `frustum_lab`.

The checkout has the folders `app` and `widgets` side by side; names so common would meet others in
an environment. This backend puts both into the package of `app/wheel` and rewrites their imports.
It uses the standard library only, so that pip needs no network and no other package.
"""

from __future__ import annotations

import base64
import hashlib
import re
import tomllib
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent
NAME = "frustum_lab"
FOLDERS = {"app/wheel/frustum_lab": NAME, "app": f"{NAME}/app", "widgets": f"{NAME}/widgets"}
"""Where the folders of the checkout lie in the wheel."""
IMPORTED = re.compile(rb"^([ \t]*(?:from|import)) (app|widgets)\b", re.MULTILINE)
MADE = (1980, 1, 1, 0, 0, 0)  # a wheel of the same code has the same bytes


def files() -> Iterator[tuple[str, bytes]]:
    """Yield the path and the content of each file of the program."""
    for folder, target in FOLDERS.items():
        for path in sorted((ROOT / folder).rglob("*")):
            inside = path.relative_to(ROOT / folder)
            of_wheel = folder == "app" and inside.parts[0] == "wheel"
            if path.is_file() and path.suffix != ".pyc" and not of_wheel:
                content = path.read_bytes()
                if path.suffix == ".py":
                    content = IMPORTED.sub(rb"\1 " + NAME.encode() + rb".\2", content)
                yield f"{target}/{inside.as_posix()}", content


def metadata(project: dict[str, Any], version: str) -> str:
    """Return what pip knows of the program."""
    lines = ["Metadata-Version: 2.4", f"Name: {project['name']}", f"Version: {version}"]
    lines += [
        f"Summary: {project['description']}",
        f"Requires-Python: {project['requires-python']}",
    ]
    lines += [f"License-Expression: {project['license']}", "License-File: LICENSE"]
    lines += [f"Requires-Dist: {each}" for each in project["dependencies"]]
    for extra, group in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f"Requires-Dist: {each}; extra == '{extra}'" for each in group]
    return "\n".join([*lines, "", ""]) + (ROOT / "README.md").read_text(encoding="utf-8")


def build_wheel(wheel_directory: str, config_settings: object = None, _made: object = None) -> str:
    """Write the wheel and return its name, as PEP 517 asks of a backend."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    source = (ROOT / "app" / "__init__.py").read_text(encoding="utf-8")
    (version,) = re.findall(r'^__version__ = "(.+)"$', source, re.MULTILINE)
    info = f"{NAME}-{version}.dist-info"
    scripts = "".join(f"{name} = {NAME}.{place}\n" for name, place in project["scripts"].items())
    tag = "Wheel-Version: 1.0\nGenerator: wheel_backend\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    texts = {
        "METADATA": metadata(project, version), "WHEEL": tag,
        "entry_points.txt": f"[console_scripts]\n{scripts}",
        "licenses/LICENSE": (ROOT / "LICENSE").read_text(encoding="utf-8"),
    }  # fmt: skip
    entries = [*files(), *((f"{info}/{name}", text.encode()) for name, text in texts.items())]
    record = ""
    for name, content in entries:
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    record_name = f"{info}/RECORD"
    entries.append((record_name, f"{record}{record_name},,\n".encode()))
    wheel = f"{NAME}-{version}-py3-none-any.whl"
    with zipfile.ZipFile(Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in entries:
            archive.writestr(zipfile.ZipInfo(name, MADE), content, zipfile.ZIP_DEFLATED)
    return wheel
