"""What tools say of the sources, as tests like all others: one command, one verdict."""

import ast
import collections
import dataclasses
import importlib
import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, get_args, get_origin, get_type_hints
from xml.etree import ElementTree

from app.bootstrap import ROOT
from app.model.refusal import SENTENCES
from tests import mutants, texts
from tests.fuzz.regexes import used
from tests.support.sources import nodes_of

SOURCES = sorted(path for folder in ("app", "widgets") for path in (ROOT / folder).rglob("*.py"))


def report(*command: str) -> str:
    """Run a tool on the whole program; what it complains about, empty when it is content."""
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return "" if done.returncode == 0 else done.stdout + done.stderr


def test_ruff_reports_nothing() -> None:
    assert report("ruff", "check", "--output-format", "concise", ".") == ""


def test_mypy_reports_nothing_in_strict_mode() -> None:
    assert report("mypy") == ""


def test_every_regular_expression_can_be_measured() -> None:
    """``python3 -m tests.fuzz regexes`` measures them, for minutes."""
    assert sum(1 for _ in used()) > 200


def translated(node: ast.AST, context: str) -> Iterator[tuple[str, str]]:
    """Context and text of every call that translates, as lupdate should see them."""
    if isinstance(node, ast.ClassDef):
        context = node.name
    if isinstance(node, ast.Call):
        called = ast.unparse(node.func)
        if called.endswith(".tr"):
            yield context, ast.literal_eval(node.args[0])
        elif called == "QT_TRANSLATE_NOOP" or (
            called == "QCoreApplication.translate" and isinstance(node.args[1], ast.Constant)
        ):
            yield ast.literal_eval(node.args[0]), ast.literal_eval(node.args[1])
    for child in ast.iter_child_nodes(node):
        yield from translated(child, context)


def test_lupdate_finds_every_string(tmp_path: Path) -> None:
    """It reads no f-strings, for one, and says nothing of what it overlooks."""
    catalogue, content = tmp_path / "all.ts", tmp_path / "content.py"
    content.write_text(texts.source(), encoding="utf-8")
    sources = [str(path) for path in (*SOURCES, content)]
    lupdate = "from PySide6.scripts.pyside_tool import lupdate; lupdate()"
    command = [sys.executable, "-c", lupdate, *sources, "-ts", str(catalogue)]
    subprocess.run(command, cwd=ROOT, capture_output=True, check=True)
    found = {
        (context.findtext("name"), message.findtext("source"))
        for context in ElementTree.parse(catalogue).iter("context")
        for message in context.iter("message")
    }
    written = {
        text
        for path in sources
        for text in translated(nodes_of(Path(path).read_text(encoding="utf-8"))[0], "")
    }
    assert len(found) > 1000
    assert written == found


def test_every_refusal_can_be_translated() -> None:
    """Its bound is none that is made on the spot: the rest is mypy's, which knows a `Bound`."""
    refusals, makers = 0, []
    for path in SOURCES:
        for node in nodes_of(path.read_text(encoding="utf-8")):
            if not isinstance(node, ast.Call):
                continue
            called, place = ast.unparse(node.func), f"{path.name}, line {node.lineno}"
            if called.rpartition(".")[2] in ("Refusal", "in_document", "saying"):
                bound = node.args[2 if called == "Refusal" else 0]
                made = (ast.Constant, ast.JoinedStr, ast.BinOp)
                assert not any(isinstance(part, made) for part in outcomes(bound)), place
                refusals += 1
            elif called == "Bound" or (called == "cast" and "Bound" in ast.unparse(node.args[0])):
                makers.append(place)
    assert refusals > 200
    assert len(makers) == 1, "REFUSALS alone has Bounds"


def test_every_sentence_of_the_page_is_used_and_every_one_that_is_used_is_there() -> None:
    """Those of a list are used together."""
    sections = {"REFUSALS": "Refusal"} | {name.upper(): name for name in SENTENCES}
    used, lists = set(), set()
    for path in SOURCES:
        for node in nodes_of(path.read_text(encoding="utf-8")):
            if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name):
                name, key = node.value.id, getattr(node.slice, "value", "Refusal")
                if name == "SENTENCES":
                    lists.add(key)
                elif name in sections:
                    used.add((sections[name], key))
    alone = {each for each in SENTENCES if "/" not in each}
    assert used == {(each, name) for each in alone for name in SENTENCES[each]}
    assert lists - alone == SENTENCES.keys() - alone


def test_a_file_that_cannot_be_looked_for_is_not_there() -> None:
    """`os.path` says so; before Python 3.12 a `Path` raises if its folder is closed, for one."""
    asked = re.compile(r"\.(exists|is_file|is_dir|is_symlink|resolve|samefile)\(\)")
    found = [
        f"{path.relative_to(ROOT)}, line {number}"
        for path in SOURCES
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1)
        if asked.search(line)
    ]
    assert not found, found


def parts_of(hint: Any) -> Iterator[Any]:
    """A type, and those that it is made of."""
    yield get_origin(hint) or hint
    for part in get_args(hint) if get_origin(hint) is not Callable else ():
        yield from parts_of(part)


def test_frozen_values_are_hashable() -> None:
    """A set or a table may hold them: what has no hash is left out of theirs."""
    found, count = [], 0
    for path in SOURCES:
        source = path.read_text(encoding="utf-8")
        for node in nodes_of(source) if "frozen=True" in source else ():
            if not isinstance(node, ast.ClassDef) or "frozen=True" not in ast.unparse(node):
                continue
            module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
            made = getattr(importlib.import_module(module.removesuffix(".__init__")), node.name)
            own = any(getattr(each, "name", "") == "__hash__" for each in node.body)
            if own or not made.__dataclass_params__.eq:
                continue
            hints, count = get_type_hints(made), count + 1
            found += [
                f"{module}.{node.name}.{each.name}"
                for each in dataclasses.fields(made)
                if (each.compare if each.hash is None else each.hash)
                and any(getattr(part, "__hash__", 0) is None for part in parts_of(hints[each.name]))
            ]
    assert count > 60
    assert not found, found


def outcomes(node: ast.expr) -> list[ast.expr]:
    """What an expression may be: both sides of a condition."""
    if isinstance(node, ast.IfExp):
        return [*outcomes(node.body), *outcomes(node.orelse)]
    return [node]


#: Methods of every named tuple, what Python itself hides, and the text of a shader: one that OpenGL
#: refuses is not to be had otherwise.
ALLOWED = {"_asdict", "_fields", "_make", "_replace", "_exit", "_parser", "_DEPTH"}


def private_names(node: ast.AST) -> list[str]:
    """What begins with an underscore of what a piece of a test speaks of, also in code in texts."""
    names: list[str] = []
    if isinstance(node, ast.Attribute):
        names = [node.attr]
    elif isinstance(node, ast.ImportFrom):
        names = [alias.name for alias in node.names]
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        names = re.findall(r"[\w\])]\.(_[a-z]\w*)", node.value)
    elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "setattr":
        names = [str(each.value) for each in node.args if isinstance(each, ast.Constant)]
    return [name for name in names if re.match("_[A-Za-z]", name)]


def test_tests_use_no_private_names() -> None:
    """Tests use only public names, except of classes and functions that they define themselves."""
    found = {}
    for path in sorted((ROOT / "tests").rglob("*.py")):
        nodes = nodes_of(path.read_text(encoding="utf-8"))
        own = {node.name for node in nodes if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
        own |= {
            node.attr
            for node in nodes
            if isinstance(node, ast.Attribute) and getattr(node.value, "id", "") == "self"
        }
        asked = [name for node in nodes for name in private_names(node)]
        asked = [name for name in asked if name not in own | ALLOWED]
        if asked:
            found[path.name] = asked
    assert found == {}


def test_no_two_classes_share_a_name() -> None:
    """One name, one meaning; a leading underscore makes no other name."""
    homes = collections.defaultdict[str, list[str]](list)
    for folder in ("app", "widgets"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            for node in nodes_of(path.read_text(encoding="utf-8")):
                if isinstance(node, ast.ClassDef):
                    homes[node.name.lstrip("_")].append(str(path.relative_to(ROOT)))
    assert {name: places for name, places in homes.items() if len(places) > 1} == {}


def test_no_class_knows_everybody() -> None:
    """A class with more than 35 methods has more than one idea."""
    large = {
        node.name
        for path in SOURCES
        for node in nodes_of(path.read_text(encoding="utf-8"))
        if isinstance(node, ast.ClassDef)
        if sum(isinstance(each, ast.FunctionDef) for each in node.body) > 35
    }
    assert large == set()


def test_no_name_says_only_that_something_was_found() -> None:
    """A name says what it holds: `match`, `corners`, and never `found`, `outs` or `ways`."""
    vague = {
        f"{path.name}: {name}"
        for path in SOURCES
        for node in nodes_of(path.read_text(encoding="utf-8"))
        for name in (getattr(node, "id", ""), getattr(node, "arg", ""), getattr(node, "name", ""))
        if isinstance(name, str) and name.strip("_") in ("found", "outs", "ways")
    }
    assert vague == set()


def test_no_call_is_put_off_without_an_object_that_ends_it() -> None:
    """`QTimer.singleShot` calls a method of a deleted widget, unless its second argument is one."""
    endless = {
        f"{path.name}:{node.lineno}"
        for path in SOURCES
        for node in nodes_of(path.read_text(encoding="utf-8"))
        if isinstance(node, ast.Call) and ast.unparse(node.func).endswith(".singleShot")
        if len(node.args) != 3
    }
    assert endless == set()


def test_every_mutant_has_its_line_and_its_test() -> None:
    """Otherwise a known mistake is lost, and nobody hears of it before the next `check`."""
    files = [path for folder in mutants.SOURCES for path in (ROOT / folder).rglob("*.*")]
    program = [each.read_text(encoding="utf-8") for each in files if each.suffix in (".py", ".md")]
    lost = []
    for mutant in json.loads(mutants.LIST.read_text(encoding="utf-8")):
        path, _, test = mutant.get("killed_by", "").partition("::")
        is_named = not path or f"def {test.partition('[')[0]}(" in (ROOT / path).read_text("utf-8")
        if sum(text.count(mutant["old"]) for text in program) != 1 or not is_named:
            lost.append(mutant["id"])
    assert lost == []
