"""Labels that stay set between runs: the same pixels, and any other file is as good as none."""

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app import languages
from app.bootstrap import ROOT
from app.document.document import Document
from app.drawings import kept_labels, label
from app.drawings.figure import Figure
from app.lecture import typesetting
from app.scenes.scene import load
from tests import PATIENCE_S
from tests.pictures import forget_labels, set_labels

TEXTS = ("near n = 4", "y_p", "P'", "u\u2192", "½ in the world", "")


@pytest.fixture(autouse=True)
def _afresh() -> Iterator[None]:
    """Nothing is set, before and afterwards."""
    forget_labels()
    yield
    languages.choose(languages.ENGLISH)
    forget_labels()


def drawn() -> list[np.ndarray]:
    return [label.drawn(text, 15.5, "#8a5a00", "#ffffff") for text in TEXTS]


def test_kept_labels_are_the_same_pixels_without_matplotlib(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, before = tmp_path / "new" / "labels.json", drawn()
    letters = typesetting.outline("y_{p}").letters
    kept_labels.save(path)
    forget_labels()
    kept_labels.load(path)
    for name in ("matplotlib.textpath", "matplotlib.backends.backend_agg"):
        monkeypatch.setitem(sys.modules, name, None)
    for one, other in zip(before, drawn(), strict=True):
        assert np.array_equal(one, other)
    assert typesetting.outline("y_{p}").letters == letters == (("y_p", 0, letters[0][2]),)
    written = path.stat().st_mtime_ns
    kept_labels.save(path)
    assert path.stat().st_mtime_ns == written, "nothing is new"


@pytest.mark.parametrize("language", ["en", "sr"])  # in Latin letters, and in Cyrillic
def test_the_letter_f_needs_no_matplotlib(language: str, tmp_path: Path) -> None:
    """Not even on the first start, when matplotlib would also list the machine's fonts."""
    code = """import sys
from app.commands.cli import main
status = main(sys.argv[1:])
print(status, *{"matplotlib", "pyvista"} & set(sys.modules))"""
    command = ("--language", language, "--screenshot", tmp_path / "a.png", "--set", "lens.near=3.9")
    done = subprocess.run(
        [sys.executable, "-c", code, *command], cwd=ROOT, capture_output=True, text=True,
        env={**os.environ, "HOME": str(tmp_path)}, timeout=PATIENCE_S, check=False,
    )  # fmt: skip
    assert (done.stdout, done.stderr) == ("0\n", "")


@pytest.mark.parametrize(
    "name", ["similar-triangles", "off-axis-window", "oblique-drawing", "drift"]
)
def test_the_letters_of_built_in_scenes_are_not_read_again(name: str) -> None:
    kept_labels.load_shipped()
    scene = load(name)
    Figure(Document(name, scene.start), scene, ("world", "ndc", "image"), (900, 400)).shapes()
    read = {key for key in typesetting.SET if not key.startswith("\n")} - kept_labels.KEYS_SHIPPED
    assert not read


@pytest.mark.parametrize("language", languages.LANGUAGES)
def test_shipped_labels_are_those_that_are_set(language: str) -> None:
    languages.choose(language)
    kept_labels.load_shipped()
    shipped = kept_labels.tree_of(set())
    forget_labels()
    for each in (languages.ENGLISH, language):
        languages.choose(each)
        set_labels()
    for kind, others in kept_labels.tree_of(set()).items():
        assert shipped[kind].keys() == others.keys()
        for key, parts in others.items():
            assert shipped[kind][key] == parts, key


def test_what_is_shipped_is_not_kept(tmp_path: Path) -> None:
    kept_labels.load_shipped()
    typesetting.piece_of("word", False)
    kept_labels.save(tmp_path / "labels.json")
    tree = json.loads((tmp_path / "labels.json").read_bytes())
    assert (list(tree["outlines"]), tree["tiles"]) == (["\nword"], {})


def _change(key: str, value: Any) -> Callable[[dict[str, Any]], Any]:
    return lambda tree: {**tree, key: value}


@pytest.mark.parametrize(
    "change",
    [
        lambda _: None,
        lambda _: [],
        lambda tree: {"made_by": tree["made_by"]},
        _change("made_by", ["another matplotlib 1 2"]),
        _change("outlines", []),
        _change("outlines", {"y": [1.0, 1.0, 0.0, "AAAA", "", []]}),
        _change("outlines", {"y": [1.0, 1.0, 0.0, "AAAAAAAA8D8AAAAAAADwPw==", "", []]}),
        _change("outlines", {"y": [float("nan"), 1.0, 0.0, "", "", []]}),
        _change("outlines", {"y": [1.0, 1.0, 0.0, "?", "", []]}),
        _change("tiles", {"y": [10**9, 10**9, "", "", 0, 0]}),
        _change("tiles", {"y": [-1, 1, "", "", 0, 0]}),
        _change("tiles", {"y": 3}),
    ],
)
def test_a_damaged_file_is_as_good_as_none(
    change: Callable[[dict[str, Any]], Any], tmp_path: Path
) -> None:
    path, before = tmp_path / "labels.json", drawn()
    kept_labels.save(path)
    path.write_text(
        json.dumps(change(json.loads(path.read_text(encoding="utf-8")))), encoding="utf-8"
    )
    forget_labels()
    kept_labels.load(path)
    assert not typesetting.SET and not label.TILES
    assert all(map(np.array_equal, before, drawn()))


@pytest.mark.parametrize("content", [b"", b"{", b"\xff\xfe", b"[" * 100_000])
def test_a_file_that_is_no_text_is_as_good_as_none(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "labels.json"
    path.write_bytes(content)
    kept_labels.load(path)
    kept_labels.load(tmp_path)
    kept_labels.load(tmp_path / "missing")
    assert not typesetting.SET and not label.TILES


def test_a_pipe_stops_no_start(tmp_path: Path) -> None:
    path = tmp_path / "labels.json"
    os.mkfifo(path)
    kept_labels.load(path)
    drawn()
    kept_labels.save(path)
    assert path.is_fifo()


def test_labels_that_cannot_be_written_are_no_error(tmp_path: Path) -> None:
    drawn()
    kept_labels.save(tmp_path)
    (tmp_path / "file").write_bytes(b"")
    kept_labels.save(tmp_path / "file" / "labels.json")


def test_what_is_kept_has_a_bound() -> None:
    for number in range(typesetting.MOST_SET + 20):
        typesetting.piece_of(f"word{number}", False)
    assert len(typesetting.SET) == typesetting.MOST_SET
