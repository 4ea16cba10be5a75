"""Figures: the same pixels everywhere, and files that carry their document."""

import gc
import hashlib
import inspect
import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from PIL import Image
from PySide6.QtGui import QOpenGLContext
from PySide6.QtWidgets import QWidget
from vtkmodules.vtkRenderingCore import vtkRenderWindow

from app.bootstrap import ROOT
from app.document.codec import parse, to_json
from app.document.document import Document
from app.document.files import read
from app.document.lengths import DPI
from app.document.view import PANES
from app.drawings import WORDS, one_pane
from app.drawings.figure_files import png_bytes
from app.drawings.off_screen import off_screen, take_screen
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT, PALETTES, rgb
from app.model.projection import Camera, Perspective
from app.model.refusal import Refusal
from app.scenes.scene import load
from tests import PATIENCE_S
from tests.support.drawings import colours_of, figure_of, labels_of


def hashes() -> list[str]:
    """Of all panes, and of one without a background."""
    scene = load("letter-f")
    opaque = figure_of(scene, scene.start, PANES, (330, 120)).pixels()
    transparent = figure_of(scene, scene.start, ("image",), (330, 120), transparent=True).pixels()
    return [hashlib.sha256(pixels.tobytes()).hexdigest() for pixels in (opaque, transparent)]


def test_the_pixels_are_the_same_at_any_scale_of_the_screen(display: Any) -> None:
    """And without a display, which the tests of the command line compare."""
    script = "import hashlib\nfrom app.document.view import PANES\n"
    script += "from tests.support.drawings import figure_of\n"
    script += "from app.scenes.scene import load\n" + inspect.getsource(hashes)
    done = subprocess.run(
        [sys.executable, "-c", f"{script}print(*hashes())"], cwd=ROOT, capture_output=True,
        text=True, env={**os.environ, "QT_SCALE_FACTOR": "2", "GDK_SCALE": "2"},
        timeout=PATIENCE_S, check=False,
    )  # fmt: skip
    assert (done.stdout.split(), done.stderr) == (hashes(), "")


def test_a_figure_beside_a_live_pane_is_the_same_and_leaves_the_pane_alone(
    display: Any, qtbot: Any
) -> None:
    from pyvistaqt import QtInteractor

    scene = load("cube")
    alone = hashlib.sha256(figure_of(scene, scene.start, ("ndc",), (200, 150)).pixels().tobytes())
    canvas = QtInteractor(auto_update=False, multi_samples=0)
    qtbot.addWidget(canvas, before_close_func=lambda widget: widget.close())
    canvas.resize(200, 150)
    drawing = StageDrawing(canvas, scene, WORDS, LIGHT)
    drawing.show_names(None)
    drawing.show_projection(scene.start)
    with qtbot.waitExposed(canvas):
        canvas.show()
    before = canvas.grab().toImage()
    context = QOpenGLContext.currentContext()
    if context is not None:
        context.doneCurrent()
    beside = hashlib.sha256(figure_of(scene, scene.start, ("ndc",), (200, 150)).pixels().tobytes())
    QWidget.update(canvas)
    assert canvas.grab().toImage() == before
    drawing.remove()
    assert beside.hexdigest() == alone.hexdigest()


def test_the_image_alone_is_exactly_the_picture() -> None:
    scene = load("letter-f")
    projection = replace(scene.start, image_size=(321, 123))
    pixels = figure_of(scene, projection, ("image",)).pixels()
    assert pixels.shape == (123, 321, 3)
    assert pixels.dtype == np.uint8
    # The letter's top front left vertex: by the model left of it is nothing, right of it a face.
    assert scene.surface is not None
    x, y = projection.trace((-1.5, 4.5, 0.5)).image
    row = int(y)
    assert (pixels[row, int(x) - 5] == 255).all()
    assert (pixels[row, int(x) + 5] != 255).any()


def test_panes_stand_side_by_side_as_they_would_alone() -> None:
    scene = load("letter-f")
    three = figure_of(scene, scene.start, PANES, (751, 200)).pixels()
    assert three.shape == (200, 751, 3)
    two = figure_of(scene, scene.start, ("image", "world"), (500, 200)).pixels()
    assert (two[:, 250:] == figure_of(scene, scene.start, ("world",), (250, 200)).pixels()).all()
    assert (three[:, :250] == two[:, 250:]).all()
    # Framed beside others: its margin is white here, its frame is not.
    assert (two[:3] == 255).all()
    assert (two[:, :200] != 255).any()


def test_a_phenomenon_is_drawn_with_its_settings() -> None:
    scene = load("similar-triangles")
    size = (480, 160)
    opened = figure_of(scene, scene.start, PANES, size).pixels()
    plain = figure_of(replace(scene, phenomenon=None), scene.start, PANES, size).pixels()
    for left in (0, 160, 320):  # the point P in every pane
        assert (opened[:, left : left + 160] != plain[:, left : left + 160]).any()
    assert scene.phenomenon is not None
    defaults = dict(scene.phenomenon.checked({}))
    assert (figure_of(scene, scene.start, PANES, size, settings=defaults).pixels() == opened).all()
    behind = figure_of(scene, scene.start, PANES, size, settings={"distance": -3.0}).pixels()
    assert (behind[:, :160] != opened[:, :160]).any()
    with pytest.raises(Refusal) as caught:
        figure_of(scene, scene.start, PANES, size, settings={"distance": 0.0}).pixels()
    assert str(caught.value).startswith("settings.distance = 0")


def test_scale_is_the_same_figure_with_more_pixels() -> None:
    scene = load("letter-f")
    once = figure_of(scene, scene.start, ("ndc",), (240, 200)).pixels()
    twice = figure_of(scene, scene.start, ("ndc",), (240, 200), scale=2.0).pixels()
    assert twice.shape == (400, 480, 3)
    shrunk = twice.reshape(200, 2, 240, 2, 3).mean(axis=(1, 3))
    # Lines and letters grew with it; hinting moves letters by fractions of a pixel.
    assert np.abs(shrunk - once).mean() < 3.0
    thin = figure_of(scene, scene.start, ("ndc",), (480, 400)).pixels().reshape(200, 2, 240, 2, 3)
    assert np.abs(shrunk - once).mean() < 0.5 * np.abs(thin.mean(axis=(1, 3)) - once).mean()


@pytest.mark.parametrize("panes", [("world",), ("ndc",), ("image",), ("image", "ndc")])
@pytest.mark.parametrize("palette", ["screen", "dark"])
def test_transparent_laid_on_the_background_is_the_opaque_figure(panes: Any, palette: str) -> None:
    """No dark seams: colours at the edges are not mixed with the missing background."""
    scene = load("letter-f")
    size = (160 * len(panes), 160)
    opaque = figure_of(scene, scene.start, panes, size, palette=palette)
    clear = replace(opaque, transparent=True).pixels().astype(float)
    alpha = clear[..., 3:] / 255.0
    assert clear[..., 3].min() == 0.0 and clear[..., 3].max() == 255.0
    assert ((alpha > 0.05) & (alpha < 0.95)).any()
    background = 255.0 * np.array(rgb(PALETTES[palette].background))
    laid = alpha * clear[..., :3] + (1.0 - alpha) * background
    assert np.abs(laid - opaque.pixels()).max() <= 3.0


def test_edges_are_smooth() -> None:
    scene = replace(load("cube"), lines=None)
    pixels = figure_of(scene, scene.start, ("image",), (200, 112)).pixels()
    assert scene.surface is not None
    faces = {tuple(colour) for colour in scene.surface.cell_data["rgb"].tolist()}
    found = {tuple(colour) for colour in pixels.reshape(-1, 3).tolist()}
    assert len(found - faces - {(255, 255, 255)}) > 20


@pytest.mark.parametrize(
    ("changes", "names"),
    [
        ({"size": (0, 600)}, "width = 0"),
        ({"size": (600, -1)}, "height = -1"),
        ({"size": (95, 600)}, "width = 95"),
        ({"size": (16385, 600)}, "width = 16385"),
        ({"size": (600, 100_000)}, "height = 100000"),
        ({"size": (9000, 600), "scale": 2.0}, "width = 9000 times scale 2"),
        ({"size": (float("nan"), 600)}, "width = nan"),
        ({"scale": 0.0}, "scale = 0"),
        ({"scale": -1.0}, "scale = -1"),
        ({"scale": float("nan")}, "scale = nan"),
        ({"scale": float("inf")}, "scale = inf"),
        ({"panes": ()}, "panes = ()"),
        ({"panes": ("ndc", "matrix")}, "pane = 'matrix'"),
        ({"panes": "image"}, "panes = 'image'"),
    ],
)
def test_a_figure_that_cannot_be_is_refused_in_one_sentence(
    changes: dict[str, Any], names: str
) -> None:
    scene = load("cube")
    with pytest.raises(Refusal) as caught:
        figure_of(scene, scene.start, **changes).pixels()
    assert str(caught.value).startswith(names)
    assert "must" in str(caught.value) and str(caught.value).endswith(".")


def test_a_long_figure_is_drawn_to_its_last_pixel() -> None:
    """It is larger than what is averaged, and than many screens: nothing is cut off."""
    scene = replace(load("cube"), lines=None)
    projection = replace(
        scene.start,
        camera=Camera((0.0, 0.5, 0.6), (0.0, 0.5, 0.0)),  # the front face fills the picture
        lens=Perspective(45.0, 0.01, 10.0),
    )
    pixels = figure_of(
        scene, replace(projection, image_size=(64, 64)), ("image",), (16384, 40)
    ).pixels()
    assert pixels.shape == (40, 16384, 3)
    lit = (pixels != 255).any(axis=-1)
    # Unframed it keeps the picture's aspect, in the middle.
    assert lit[:, 8172:8212].all() and lit.sum() == 40 * 40


def test_figures_leave_nothing_behind() -> None:
    scene = load("cube")

    def count() -> int:
        gc.collect()
        return sum(isinstance(thing, vtkRenderWindow) for thing in gc.get_objects())

    figure_of(scene, scene.start, PANES, (300, 100)).pixels()
    before = count()
    for _ in range(3):
        figure_of(scene, scene.start, PANES, (300, 100)).pixels()
    assert count() == before
    screens = [take_screen(8, 8) for _ in range(9)]
    while screens:
        screens.pop().give_back()
    tried = 1  # by `check_off_screen`, which keeps it
    assert count() <= max(before, tried + 3), "as many are kept as a window has panes"


def test_a_window_that_figures_were_drawn_in_draws_as_a_new_one() -> None:
    """Also after figures with few depth bits, textures, several layers and no background.

    And after a pane, which adds observers, layers and samples, and swaps no buffers.
    """
    scenes = [load(name) for name in ("depth-buffer", "interpolation", "focus")]
    kinds = [(scene, pane) for scene in scenes for pane in PANES]
    new = []
    for scene, pane in kinds:
        with off_screen(8, 8), off_screen(8, 8), off_screen(8, 8):  # all that had been kept
            new.append(figure_of(scene, scene.start, (pane,), (160, 120)).pixels())
    for scene in scenes:
        figure_of(scene, scene.start, PANES, (600, 90), transparent=True, palette="dark").pixels()
    heard: list[str] = []
    for _ in range(3):
        with off_screen(64, 64) as screen:
            assert list(screen.render_window.GetRenderers()) == [screen.renderer]
            screen.render_window.SetMultiSamples(4)
            screen.render_window.SetNumberOfLayers(2)
            screen.render_window.SwapBuffersOff()
            screen.render_window.Render()
            screen.render_window.AddObserver("StartEvent", lambda _, event: heard.append(event))
    with off_screen(64, 64) as screen:
        assert screen.render_window.GetSwapBuffers()
        assert screen.render_window.GetNumberOfLayers() == 1
    for (scene, pane), expected in zip(kinds, new, strict=True):
        assert np.array_equal(figure_of(scene, scene.start, (pane,), (160, 120)).pixels(), expected)
    assert heard == []


def test_the_environment_is_left_as_it_was(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    before = dict(os.environ)
    scene = load("cube")
    figure_of(scene, scene.start, ("image",), (32, 32)).pixels()
    assert dict(os.environ) == before


def test_a_png_brings_its_pixels_and_its_document_back(tmp_path: Path) -> None:
    scene = load("letter-f")
    document = Document("letter-f", replace(scene.start, depth="reversed"))
    figure = figure_of(scene, document.projection, ("ndc",), (90, 70), transparent=True)
    pixels, path = figure.pixels(), tmp_path / "figure.png"
    figure.save(path)
    with Image.open(path) as image:
        assert (np.array(image) == pixels).all()
        assert image.info["Title"] == figure.description.title
        assert image.info["Description"] == figure.description.text, "for those who do not see it"
    assert read(path) == document
    assert json.loads(to_json(read(path)))["depth"] == "reversed"
    assert parse(to_json(document)) == document
    assert b"frustum-lab" not in png_bytes(pixels)


def test_a_mesh_far_from_the_origin_is_drawn_as_cleanly_as_near_it(tmp_path: Path) -> None:
    """Float32, with a step of 1 at 1e7, would lose this ball of radius 1/2."""
    ball = pv.Sphere(theta_resolution=24, phi_resolution=24)
    points = np.round(np.asarray(ball.points, dtype=np.float64) * 1024.0) / 1024.0
    pictures = []
    for offset in (64.0, 1e7):  # neither has the world's axes in its grid
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in (points + offset).tolist()]
        lines += ["f " + " ".join(map(str, face + 1)) for face in ball.regular_faces]
        path = tmp_path / f"ball-{offset:g}.obj"
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        scene = load(str(path))
        pictures.append(figure_of(scene, scene.start, size=(600, 200)).pixels())
    near, far = pictures
    assert colours_of(near) > 50
    # The eye itself is rounded to 2e-9 there: a pixel on an edge may round the other way.
    assert (near != far).any(axis=2).mean() < 1e-3


@pytest.mark.parametrize(
    ("scene", "scale"),
    [("letter-f", 1.0), ("similar-triangles", 2.0), ("focus", 1.0), ("clipping", 2.0)],
)
def test_all_letters_of_a_figure_have_one_size(
    scene: str, scale: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """8 points are 8/72 of an inch, at `DPI` pixels an inch, in every pane, however small."""
    sizes: dict[str, set[int]] = {}
    original = one_pane.pixels_of

    def noted(window: Any, *args: Any, **options: Any) -> Any:
        done = original(window, *args, **options)
        for renderer in window.GetRenderers():
            for text, label in labels_of(renderer).items():
                sizes.setdefault(text, set()).add(round(label.em))
        return done

    monkeypatch.setattr(one_pane, "pixels_of", noted)
    shown = load(scene)
    figure_of(shown, shown.start, PANES, (750, 250), scale=scale, text_pt=8.0).pixels()
    assert len(sizes) > 3
    (found,) = set().union(*sizes.values())
    # Several pixels are drawn for one of the figure's, along each side.
    assert found / (8.0 * DPI / 72.0 * scale) == pytest.approx(3.0, rel=0.01)
