"""Files from strangers become text in one place, `app.strangers.decode`."""

import ast

import pytest

from app.bootstrap import ROOT
from app.languages import said
from app.strangers import decode
from tests.house.test_imports import read, sources
from tests.support.sources import nodes_of

HOME = "app/strangers.py"
OWN = {
    "app/drawings/figure.py": "the SVG text that it has just drawn",
    "app/bootstrap.py": "files of the checkout and of its environment",
    "app/python_packages.py": "pyproject.toml, a file of the checkout",
    "app/document/files.py": "the chunk of a PNG picture, which is UTF-8 by definition",
    "app/drawings/moving.py": "what ffmpeg says",
    "app/model/parameter.py": "a file of the program",
    "app/scenes/phenomena/depth_buffer.py": "codes of a depth buffer, which are numbers",
    "app/scenes/ply.py": "a header, after its encoding is known",
    "widgets/panels/measuring.py": "what a process of the program says",
    "widgets/window/settings.py": "settings, which Qt reads after this check, as UTF-8",
}
"""Other files that decode bytes, and which ones."""


def other_ways(source: str) -> list[str]:
    """The calls in a source file that turn bytes into text."""
    found = []
    for node in nodes_of(source):
        if not isinstance(node, ast.Call):
            continue
        called, given = ast.unparse(node.func), {word.arg for word in node.keywords}
        name = called.rpartition(".")[2]
        of_numbers = "b64encode" in called
        is_bytes = any("b" in ast.literal_eval(word) for word in node.args if _is_mode(word))
        opened = name in ("open", "fdopen") and "encoding" in given and not is_bytes
        read = name in ("read_text", "TextIOWrapper") and "encoding" in given
        if (name == "decode" and "." in called and not of_numbers) or opened or read:
            found.append(called)
    return found


def unstated(source: str) -> list[int]:
    """The lines that read or write text without its encoding, which differs on Windows.

    ruff sees only those whose path it knows to be a `Path`.
    """
    return [
        node.lineno
        for node in nodes_of(source)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and len(node.args) == {"read_text": 0, "write_text": 1}.get(node.func.attr)
        and "encoding" not in {word.arg for word in node.keywords}
    ]


def _is_mode(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str) and len(node.value) < 4


def test_only_one_module_decodes_the_files_of_strangers() -> None:
    found = {path for path in sources() if other_ways(read(path))}
    assert found - {HOME} == set(OWN)


def test_each_other_way_is_seen() -> None:
    for source in (
        "content.decode()",
        "file.read(5).decode('utf-8-sig', 'replace')",
        "Path(path).read_text(encoding='utf-8')",
        "open(path, 'r', encoding='utf-8')",
        "io.TextIOWrapper(file, encoding='utf-8')",
    ):
        assert other_ways(source), source
    assert not other_ways("decode(content); open(path, 'rb'); b64encode(x).decode()")


def test_every_text_has_its_encoding() -> None:
    assert len(unstated("a.read_text(); b.c.write_text('x'); a.read_text('utf-8')")) == 2
    files = [*sources(), *(str(path.relative_to(ROOT)) for path in (ROOT / "tests").rglob("*.py"))]
    assert [(path, lines) for path in files if (lines := unstated(read(path)))] == []


@pytest.mark.parametrize("text", ["v 1 2 3 č\n", "\r\n{}", "---\ntitle: \U0001f4f7\n", ""])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-16-le", "utf-16-be", "utf-32-le", "utf-32-be"])
def test_unicode_is_read_with_or_without_a_mark(text: str, encoding: str) -> None:
    assert decode(text.encode(encoding)) == (text, "")
    assert decode(f"\ufeff{text}".encode(encoding)) == (text, "")


def test_other_bytes_are_latin_1_with_a_note() -> None:
    assert decode("café".encode("latin-1")) == ("café", said("read-as-latin-1"))
    assert decode(b"\xef\xbb\xbfcaf\xe9") == ("café", said("read-as-latin-1"))
    assert decode("cut".encode("utf-16")[:-1]) == ("cu\ufffd", said("damaged-text"))
    assert decode(bytes(8)) == ("\0" * 8, "")  # is no UTF-32
    assert decode(b"\0\0\1\0\xff")[1] == said("read-as-latin-1")
