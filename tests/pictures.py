"""``python3 -m tests.pictures``: are the pictures of README and docs those that the program draws?

``--write`` draws the pictures again, all of them or those that are named. `PICTURES` has the
command for each. The charts are drawn from the recorded ``app/measure/content/letter-f.json``.
``--measure`` records them again, and draws the charts and the captions of ``docs/measurements.md``.
``--notebook`` runs the notebook and keeps what it shows.
``--labels`` sets the letter F's labels, which come with the program, again, and ``--tiles`` draws
the start card's pictures.
"""

if __name__ == "__main__":  # before anything is imported that it installs
    from app import bootstrap

    bootstrap.start("tests", extras=("test",))

import argparse
import itertools
import json
import re
import subprocess
import sys
import tempfile
import textwrap
import zlib
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image

from app import api, languages
from app.bootstrap import ROOT
from app.commands import cli
from app.document.document import Document
from app.document.view import View
from app.drawings import DrawingWords, kept_labels, label
from app.drawings.figure import Figure
from app.drawings.pdf import rastered
from app.drawings.style import LIGHT
from app.lecture import typesetting
from app.measure.meaning import bargain, meaning
from app.measure.single import SHIPPED, read_results
from app.model.formula import ARROW
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import BUILT_IN, load
from tests import PATIENCE_S
from tests.__main__ import at_home
from tests.support.commands import run
from tests.support.notebook import with_outputs
from tests.support.tools import ToolParser, one_of
from widgets.parts.chart_picture import picture
from widgets.window.start_card import THUMBNAIL_PX, tile_path

DOCS = Path(ROOT) / "docs"
MOST_DIFFERENT = 0.001
"""Share of a picture's squares that may differ: drivers and fonts differ along edges."""
_SQUARE_PX, _LEVELS = 8, 24

_PANES = {"view-volumes": "world,ndc", "clipping": "world,ndc", "affine-depth": "ndc,image"}
"""The panes of phenomena that the world and the image do not show best."""


def _figure(panes: str, size: str, *values: str) -> tuple[str, ...]:
    sets = [part for value in values for part in ("--set", value)]
    return ("export", "--panes", panes, "--size", size, "--text-size", "3", *sets)


_PRESENT = """
import sys, time
from PySide6.QtWidgets import QApplication, QWidget
from app.commands.cli import main
from widgets.window.main_window import MainWindow

def grab(window):
    window.present.begin()
    end = time.monotonic() + 3.0
    while time.monotonic() < end:
        QApplication.processEvents()
    return QWidget.grab(window).scaledToWidth(960)

MainWindow.grab = grab
sys.exit(main(sys.argv[1:]))
"""
_HELIX = np.linspace(0.0, 6.0 * np.pi, 2000)


def _of_script(name: str) -> Figure:
    """The figures that only scripts draw, or whose shapes PNG has not."""
    if name == "figure-hidden.png":
        return api.figure(api.load(), panes="world", size=(1280, 800), text_size=6, hidden="dashed")
    helix = np.column_stack([np.cos(_HELIX), _HELIX / 4.0, np.sin(_HELIX)])
    colours = np.column_stack([_HELIX / _HELIX[-1], 0.4 + 0.0 * _HELIX, 1.0 - _HELIX / _HELIX[-1]])
    document = api.load("letter-f", "lens.near=2", "lens.fov_y_deg=40")
    return api.figure(
        document, cloud=helix, colours=colours, dot_size=1.5, size=(840, 320), text_size=3,
        panes="world,image",
    )  # fmt: skip


PICTURES: dict[str, tuple[str, ...]] = {
    "window.png": ("--size", "1366x768", "--screenshot"),
    "present.png": (
        "--set", "view.slide=world,image", "--set", "view.controls=lens.near", "--screenshot",
    ),
    "film.gif": (
        *_figure("world,image", "640x260", "lens.fov_y_deg=40"), "--sweep", "lens.near=2:7",
        "--frames", "16", "--fps", "8", "--loop", "back-and-forth",
    ),
    "figure-panes.png": _figure("world,image", "840x320"),
    "figure-size.png": ("export", "--panes", "world,image", "--size", "70mmx24mm"),
    "figure-text-size.png": (*_figure("world,image", "840x320"), "--text-size", "6"),
    "figure-width.png": ("export", "--panes", "world", "--width", "50mm", "--text-size", "4"),
    "figure-fit.png": (*_figure("world", "640x400"), "--fit", "frustum"),
    "figure-crop.png": (*_figure("ndc", "640x400"), "--crop"),
    "figure-print.png": (*_figure("world,image", "840x320"), "--palette", "print"),
    "figure-transparent.png": (*_figure("ndc", "640x400"), "--transparent"),
    "figure-hidden.png": ("script",),
    "figure-equation.png": (
        "export", "--panes", "equation", "--set", "view.equation=frustum", "--letters", "003",
    ),
    "figure-letters.png": (
        *_figure("world", "640x400", "view.names=eye,n,near,far"), "--letters", "docs/letters.toml",
    ),
    "figure-cloud.png": ("script",),
    "lesson.png": (
        "app/lessons/content/l05-similar-triangles.md", "--size", "1366x768", "--screenshot",
    ),
    "lecture-l1.png": _figure("world", "640x400", "view.frame_step=v", "view.panel=frame"),
    "lecture-l2.png": _figure(
        "world,image", "840x320", "object.translate=2,0,-1", "object.rotate_deg=0,30,0"
    ),
    "lecture-l7.png": _figure(
        "image", "840x320", "scene=off-axis-window", "view.compare=proportions"
    ),
    "lecture-l9.png": _figure("ndc", "420x320", "view.stage=pyramid"),
    "lecture-l10.png": _figure("world,image", "840x320", "lens.kind=orthographic"),
    "lecture-l14.png": _figure("image", "420x320", "view.probes=0.5,2.5,0.5"),
    "lecture-l16.png": _figure("image", "840x320", "scene=eye-plane", "view.compare=divides"),
    "lecture-l18.png": _figure(
        "image", "840x320", "scene=interpolation", "view.compare=interpolation"
    ),
    "lecture-l20.png": _figure(
        "image", "840x320", "scene=field-of-view", "view.compare=photographs"
    ),
    **{
        f"scene-{name}.png": _figure(
            _PANES.get(name, "world,image"), "840x320", f"scene={name}"
        )
        for name in PHENOMENA
    },
    "measure-arithmetic.png": ("arithmetic", "time", "float64"),
    "measure-bytes.png": ("arithmetic", "bytes", "12 bits"),
    "measure-interpolation.png": ("interpolation", "time", "affine, 64 pieces"),
    "measure-depth.png": ("depth", "bytes", "float32, reversed"),
    "measure-smoothing.png": ("smoothing", "time", "FXAA"),
    "measure-detail.png": ("detail", "time", "5 %"),
    "measure-drift.png": ("drift", "time", "float32, fast inverse root"),
    "measure-vertex-depth.png": ("vertex-depth", "time", "each vertex"),
    "measure-cracks.png": ("cracks", "bytes", "8 bits, own boxes"),
    "measure-jitter.png": ("jitter", "time", "two floats"),
    "measure-unprojection.png": ("unprojection", "time", "float32, ray times depth"),
    "measure-sweeps.png": ("sweeps",),
}  # fmt: skip


def draw(name: str, path: Path) -> None:
    """Draw a picture of the docs into a file."""
    command = PICTURES[name]
    if name.startswith("measure-"):
        results = read_results(SHIPPED)
        trades = tuple(trade for trade in results.trades if trade.name == command[0])
        drawn = replace(results, trades=trades, sweeps=() if trades else results.sweeps)
        cost = "bytes" if "bytes" in command else "time"
        path.write_bytes(picture(drawn.by_cost(cost), path.name))
    elif command[0] == "script":
        figure = _of_script(name)
        size, shapes = figure.shapes()
        picture_px = Image.fromarray(rastered(shapes, size, 1.0)[..., :3])
        picture_px.reduce(2 if size[0] > 1000.0 else 1).save(path)
    elif name == "present.png":
        words = [sys.executable, "-c", _PRESENT, *command, path]
        subprocess.run(words, cwd=ROOT, check=True, timeout=PATIENCE_S)
    elif command[0] == "export":
        assert cli.main([*command, str(path)]) == 0, name
    else:
        done = run(*command, path)
        assert done.returncode == 0, done.stderr


def captioned(page: str) -> str:
    """The page of measurements with what the recorded ones say in italics below each chart."""
    trades = {t.name: t for t in read_results(SHIPPED).trades}

    def caption(found: re.Match[str]) -> str:
        trade, cost, name = PICTURES[found[2]]
        part = trades[trade].by_cost(cost)
        (choice,) = (c for c in part.choices if c.name == name)
        said = " ".join(filter(None, (meaning(part), bargain(part, choice))))
        return "\n".join([found[1], *textwrap.wrap(f"*{said}*", 100)])

    return re.sub(r"(!\[[^]]*\]\((measure-(?!sweeps)[\w-]+\.png)\)\n)\n\*[^*]*\*", caption, page)


def different(one: Path, other: Path) -> float:
    """The share of squares in which two pictures differ; 1 for pictures of different sizes."""
    means = []
    for path in (one, other):
        with Image.open(path) as image:
            whole = image.convert("RGB")
        columns, rows = (side // _SQUARE_PX for side in whole.size)
        small = whole.resize((columns, rows), Image.Resampling.BOX)
        means.append(np.asarray(small, dtype=np.int64))
    if means[0].shape != means[1].shape:
        return 1.0
    return float((abs(means[0] - means[1]).max(axis=2) > _LEVELS).mean())


def forget_labels() -> None:
    """Let no label be set."""
    kept_labels.KEYS_SHIPPED.clear()
    typesetting.SET.clear()
    label.TILES.clear()
    for module in (typesetting, label):
        for each in vars(module).values():
            if hasattr(each, "cache_clear"):
                each.cache_clear()


def set_labels(scales: Iterable[float] = (1.0, 2.0)) -> None:
    """Set the labels of the letter F, with any numbers, as screens of scales show them.

    A piece may begin at any part of a pixel: where it does depends on the numbers. Of the letters
    of other scenes, only the outlines are set: matplotlib takes 2 to 5 ms to read each.
    """
    words = DrawingWords()
    texts = (words["eye"], words["target"], *"xyz", *(axis + ARROW for axis in "uvn"))
    planes = f"{words['near']} n = 0123456789.", f"{words['far']} f = \u2212+,"
    lines = map(typesetting.line_of, (*texts, *planes, "0123456789, "))
    pieces = {piece[:3] for line in lines for piece in line.pieces}
    for scale in scales:
        em = scale * LIGHT.font_size
        for name, is_tex, size in sorted(pieces):
            for part in range(label.PARTS):
                label.tile(name, is_tex, size * em, label.HALO_EM * em, part)
    names = {*"uv", *(name for scene in BUILT_IN for name in load(scene).names)}
    for piece, is_tex in itertools.chain.from_iterable(map(typesetting.pieces_of, sorted(names))):
        if is_tex and "mathrm" not in piece:  # a name with a subscript of a word is no letter
            typesetting.outline(piece)


def draw_tile(name: str, path: Path, *, dark: bool) -> None:
    """Draw a scene's picture for the start card, without labels, for screens of the scale 2.

    It is drawn twice as large once more, so that its lines do not hide the scene.
    """
    scene, (width, height) = load(name), (2 * side for side in THUMBNAIL_PX)
    document = Document(name, scene.start, view=View(layers=frozenset({"labels"})))
    palette = "dark" if dark else "screen"
    figure = Figure(document, scene, (scene.leading,), (width, height), scale=2.0, palette=palette)
    image = Image.fromarray(figure.pixels()).resize((width, height), Image.Resampling.BOX)
    image.quantize(256, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(
        path, optimize=True
    )


def compare(names: Iterable[str], folder: Path) -> dict[str, float]:
    """The pictures that differ now, drawn into a folder, and the share that differs."""
    found = {}
    for name in names:
        draw(name, folder / name)
        found[name] = different(DOCS / name, folder / name)
    return {name: share for name, share in found.items() if share > MOST_DIFFERENT}


def main(words: Sequence[str]) -> int:
    """Compare or write the pictures; 1 if one of them is not what the program draws."""
    parser = ToolParser("pictures", __doc__)
    known = one_of({*PICTURES, *BUILT_IN}, "picture")
    parser.add_argument("names", nargs="*", metavar="NAME", type=known, help="of pictures (all)")
    parser.add_argument("--write", action="store_true", help="draw them anew")
    parser.add_argument("--measure", action="store_true", help="measure and draw the charts anew")
    parser.add_argument("--labels", action="store_true", help="set the shipped labels anew")
    parser.add_argument("--tiles", action="store_true", help="draw the start card's pictures anew")
    parser.add_argument("--notebook", action="store_true", help="run the notebook anew")
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    found = parser.parse_args(words)
    if found.notebook:
        sys.path.insert(0, str(ROOT / "app" / "wheel"))  # `frustum_lab`
        notebook = DOCS / "scripting.ipynb"
        ran, _ = with_outputs(notebook.read_text(encoding="utf-8"))
        notebook.write_text(ran, encoding="utf-8")
        return 0
    if found.tiles:
        for name in found.names or BUILT_IN:
            for dark in (False, True):
                draw_tile(name, tile_path(name, dark=dark), dark=dark)
        return 0
    if found.labels:
        in_english = set[str]()
        for language in languages.LANGUAGES:  # English comes first
            languages.choose(language)
            forget_labels()
            set_labels()
            content = json.dumps(kept_labels.tree_of(in_english)).encode()
            kept_labels.shipped(language).write_bytes(zlib.compress(content, 9))
            in_english = in_english or {*typesetting.SET, *label.TILES}
        return 0
    names = found.names or list(PICTURES)
    if not found.inside:  # some pictures show the window
        with at_home() as environment:
            command = [sys.executable, "-m", "tests.pictures", "--inside", *words]
            return subprocess.run(command, env=environment, cwd=ROOT, check=False).returncode
    if found.measure:
        done = run("measure", "--json=-")
        assert done.returncode == 0, done.stderr
        SHIPPED.write_text(json.dumps(json.loads(done.stdout)) + "\n", encoding="utf-8")
        page = DOCS / "measurements.md"
        page.write_text(captioned(page.read_text(encoding="utf-8")), encoding="utf-8")
        names = [name for name in PICTURES if name.startswith("measure-")]
    if found.write or found.measure:
        for name in names:
            draw(name, DOCS / name)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        changed = compare(names, Path(folder))
    for name, share in changed.items():
        print(f"docs/{name}: {100.0 * share:.1f} % differs from what the program draws")
    print(f"{len(names)} pictures, {len(changed)} differ")
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
