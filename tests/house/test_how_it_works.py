"""`docs/how-it-works.md` names files, classes and methods that exist."""

import ast
import re

from app.bootstrap import ROOT
from tests.support.sources import nodes_of

PAGE = (ROOT / "docs" / "how-it-works.md").read_text(encoding="utf-8")


def test_every_name_of_the_page_exists() -> None:
    """A class as `Store`, a method as `Store.set_document`, a file by its path."""
    classes: dict[str, set[str]] = {}
    for path in [*(ROOT / "app").rglob("*.py"), *(ROOT / "widgets").rglob("*.py")]:
        for node in nodes_of(path.read_text(encoding="utf-8")):
            if isinstance(node, ast.ClassDef):
                for part in ast.walk(node):
                    named = {getattr(part, name, None) for name in ("name", "attr", "id")}
                    classes.setdefault(node.name, set()).update(filter(None, named))
    names = re.findall(r"`([A-Z]\w+)(?:\.(\w+))?`", PAGE)
    assert len(names) > 40
    unknown = [
        (name, member)
        for name, member in names
        if name not in classes or (member and member not in classes[name])
    ]
    assert unknown == []
    files = re.findall(r"`((?:app|widgets|tests)/[\w/.]+)`", PAGE)
    assert [file for file in files if not (ROOT / file).exists()] == []
