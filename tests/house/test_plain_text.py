"""No text is taken for HTML: labels, tooltips, documents are those of `widgets.parts.plain`."""

import ast
from pathlib import Path

from app.bootstrap import ROOT
from tests.support.sources import nodes_of

HOME = "widgets/parts/plain.py"
#: What takes a text that looks like HTML for HTML, or loads what it names.
MADE = {"QLabel", "QMessageBox", "QTextDocument", "QTextEdit", "QTextBrowser", "QErrorMessage",
        "QWhatsThis", "QSplashScreen", "QToolTip", "QStaticText"}  # fmt: skip
CALLED = {"setToolTip", "setStatusTip", "setWhatsThis", "setTextFormat", "setMarkdown",
          "insertHtml", "appendHtml", "setLabelText", "setDetailedText"}  # fmt: skip
#: Kinds of Qt's whose enumerations and types others may name.
NAMED = {"QMessageBox", "QTextDocument", "QTextEdit"}


def faults(path: str, source: str) -> list[str]:
    """What in a source file shows text by another way, one sentence each."""
    found = []
    for node in nodes_of(source):
        if isinstance(node, ast.ImportFrom):
            names = {alias.name for alias in node.names} & (MADE - NAMED)
            found += [f"{path}:{node.lineno}: {name}" for name in sorted(names)]
        elif isinstance(node, ast.Call):
            name = ast.unparse(node.func).rpartition(".")[2]
            asks = ast.unparse(node.func).partition(".")[0] in MADE
            given = {word.arg for word in node.keywords} & {"toolTip", "statusTip", "textFormat"}
            if name in MADE | CALLED or asks or given:
                found.append(f"{path}:{node.lineno}: {ast.unparse(node.func)}")
    return found


def test_every_text_is_shown_literally() -> None:
    files = [path for top in ("app", "widgets") for path in (ROOT / top).rglob("*.py")]
    names = [(path.relative_to(ROOT).as_posix(), path) for path in files]
    found = [
        fault
        for name, path in sorted(names)
        if name != HOME
        for fault in faults(name, path.read_text(encoding="utf-8"))
    ]
    assert not found


def test_each_other_way_is_seen() -> None:
    for source in (
        "from PySide6.QtWidgets import QLabel",
        "QtWidgets.QLabel('x')",
        "row.setToolTip(step.title)",
        "QMessageBox.warning(window, 'x', name)",
        "QMessageBox(window)",
        "QTextDocument(self)",
        "QTextEdit(readOnly=True)",
        "QPushButton(name, toolTip=name)",
        "document.setMarkdown(text)",
    ):
        assert faults("x.py", source), source
    assert not faults("x.py", "box = QMessageBox.Icon.Warning")
    assert HOME in {path.relative_to(ROOT).as_posix() for path in Path(ROOT).glob("widgets/*/*.py")}
