"""Scripts and notebooks: their page is true, and what they call is what the program computes."""

import copy
import json
import math
import os
import pickle
import re
import sys
from functools import cache
from itertools import permutations
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pytest
from matplotlib.figure import Figure
from PIL import Image

from app import api
from app.bootstrap import ROOT
from app.document.document import Document
from app.document.files import read
from app.document.view import PANES
from app.drawings import off_screen
from app.drawings.figure import FITS, HIDDEN
from app.drawings.style import PALETTES
from app.model.refusal import Refusal
from tests.support.commands import bare_machine
from tests.support.notebook import with_outputs

#: At the origin, looking along -z; x and y of NDC are those of the view over w; 100 px are 1.
NEAR = "lens.near=2:8"
PLAIN = api.Projection(
    api.Camera(eye=(0.0, 0.0, 0.0), target=(0.0, 0.0, -1.0)), api.Perspective(90.0, 1.0, 3.0),
    image_size=(200, 200),
)  # fmt: skip


@pytest.fixture
def installed(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Import what the wheel installs, and write in a folder of the test's own."""
    monkeypatch.syspath_prepend(str(ROOT / "app" / "wheel"))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_page_on_scripting_prints_what_it_says(
    installed: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = (ROOT / "docs" / "scripting.md").read_text(encoding="utf-8")
    scope: dict[str, Any] = {}
    blocks = re.findall(r"```(\w+)\n(.*?)```", page, re.DOTALL)
    assert len(blocks) >= 10
    assert [kind for kind, _ in blocks] == ["python", "text"] * (len(blocks) // 2)
    first_ten = blocks[0][1].splitlines()
    assert len(first_ten) <= 10
    for kind, text in blocks:
        if kind == "python":
            exec(text, scope)
        else:
            assert capsys.readouterr().out == text
    figure = (installed / "points.svg").read_text(encoding="utf-8")
    assert 'width="120mm" height="60mm"' in figure and "<image" not in figure
    assert "Point 3 at (−1, 0, 1) has its picture at the pixel (502.6, 580.6)." in figure
    assert all(f">{number}</tspan>" in figure for number in (1, 2, 3))


def test_the_notebook_shows_what_it_shows_here(installed: Path) -> None:
    text = (ROOT / "docs" / "scripting.ipynb").read_text(encoding="utf-8")
    ran, (scope, points, figure, matrix) = with_outputs(text)
    assert points.shape == (3, 2) and matrix.shape == (4, 4)
    stored, fresh = (json.loads(each) for each in (text, ran))
    # Letters and lines of the figure may be elsewhere by a rounding, on another machine.
    for notebook in (stored, fresh):
        (drawn,) = (
            output["data"].pop("image/svg+xml")
            for cell in notebook["cells"]
            for output in cell.get("outputs", ())
            if "image/svg+xml" in output["data"]
        )
        assert drawn[0].startswith("<svg") and "Point 3 at" in "".join(drawn)
    assert stored == fresh
    figure.save("figure.png")
    assert read(installed / "figure.png") == scope["document"]


def test_a_figure_is_pixels_files_axes_and_a_film(tmp_path: Path) -> None:
    figure = api.figure(PLAIN, panes="image", size=(80, 60.0), text_size="2pt")
    assert repr(figure) == "<frustum_lab.Figure: Letter F, image, 80 x 60 px>"
    pixels = figure.array()
    assert pixels.shape == (60, 80, 3) and pixels.dtype == np.uint8 and pixels.min() < 200
    (tmp_path / "a.png").write_bytes(figure.png())
    with Image.open(tmp_path / "a.png") as image:
        assert (np.asarray(image) == pixels).all()
    notebook = getattr(figure, "_repr_svg_")()  # noqa: B009
    assert figure.svg().startswith("<svg") and figure.svg() == notebook
    ax = Figure().add_subplot()
    shown = figure.axes(ax)
    assert shown.get_extent() == [0.0, 200.0, 200.0, 0.0], "the image's own pixels"
    assert (shown.get_array() == pixels).all()
    figure.film(tmp_path / "a.gif", "lens.near=0.5:2", "lens.far=3:6", frames=3, ease="log")
    with Image.open(tmp_path / "a.gif") as film:
        assert (film.n_frames, film.info["duration"]) == (3, 40)
    for refused, words in (
        (lambda: figure.film(tmp_path / "a.png", "lens.near=1:2"), "must end in one of .gif"),
        (lambda: figure.film(tmp_path / "a.gif", "lens.near=1"), "sweep = 'lens.near=1': must be"),
        (lambda: figure.film(tmp_path / "a.gif", "lens.near=1:9"), "must be less than far"),
    ):
        with pytest.raises(Refusal, match=re.escape(words)):
            refused()


def test_sizes_are_numbers_or_texts() -> None:
    sizes = [
        api.figure(PLAIN, panes="image", size=size).full_size.px
        for size in ("254mmx127mm", "25.4cmx12.7cm", "3000x1500", (3000, 1500.0))
    ]
    assert np.allclose(sizes, (3000.0, 1500.0))
    wide = [api.figure(PLAIN, width=width).width for width in ("84mm", "8.4cm", 84 / 25.4 * 300.0)]
    assert np.allclose(wide, 84 / 25.4 * 300.0)
    assert {api.figure(PLAIN, text_size=size).text_pt for size in ("8pt", "8", 8, 8.0)} == {8.0}


def test_a_type_checker_knows_the_values() -> None:
    hints = get_type_hints(api.figure)
    assert get_args(hints["palette"]) == tuple(PALETTES)
    assert get_args(hints["hidden"]) == HIDDEN and get_args(hints["fit"]) == FITS
    known = {name for part in get_args(hints["panes"]) for name in get_args(part) or (part,)}
    texts = {name for name in known if isinstance(name, str)}
    rows = {sign.join(each) for count in (1, 2, 3) for each in permutations(PANES, count)
            for sign in ",/"}  # fmt: skip
    assert texts == {*rows, "equation"}


def test_the_world_is_a_plotter_in_world_coordinates(monkeypatch: pytest.MonkeyPatch) -> None:
    document = api.load("letter-f", "object.translate=100,0,0", "lens.far=20")
    plotter = api.figure(document, panes="image").plotter(off_screen=True, window_size=(80, 60))
    try:
        low, high = np.reshape(plotter.bounds, (3, 2)).T
        assert (low < (-3.0, -1.0, -3.0)).all() and high[0] > 101.0, "the ground stays"
        assert any(
            np.isclose(point, document.projection.camera.eye).all()
            for actor in plotter.actors.values() for point in actor.mapper.dataset.points
        )  # fmt: skip
        assert plotter.screenshot(return_img=True).min() < 200
    finally:
        plotter.close()
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(Refusal, match="needs the package pyvista: pip install pyvista"):
        api.figure(document).plotter()


def test_points_are_projected_as_by_hand() -> None:
    # w = 2; z of NDC is (f + n)/(f - n) - 2 f n/(f - n)/w = 2 - 3/2; depth (1 + 0.5)/2.
    found = api.project(PLAIN, [[(1.0, 0.5, -2.0)], [(0.0, 0.0, 1.0)]])
    assert found.image.shape == (2, 1, 2) and found.outside.shape == (2, 1, 6)
    np.testing.assert_allclose(found.ndc[0, 0], (0.5, 0.25, 0.5), rtol=1e-15)
    np.testing.assert_allclose(found.image[0, 0], (150.0, 75.0), rtol=1e-15)
    assert found.depth[0, 0] == 0.75 and not found.in_front[1, 0]
    # The same point with w, and the direction to it: a point beyond far, at the same pixel.
    twice = api.project(PLAIN, [(2.0, 1.0, -4.0, 2.0), (1.0, 0.5, -2.0, 0.0)])
    np.testing.assert_allclose(twice.image, [(150.0, 75.0)] * 2, rtol=1e-15)
    np.testing.assert_array_equal(twice.world, [(1.0, 0.5, -2.0, 1.0), (1.0, 0.5, -2.0, 0.0)])
    np.testing.assert_array_equal(twice.outside[1], [False, True, *[False] * 4])


@pytest.mark.parametrize("precision", [None, "float32", "float64", "exact"])
def test_points_with_w_are_those_without(precision: Any) -> None:
    """(2x, 2y, 2z, 2) is (x, y, z), one by one and together with directions."""
    points = np.random.default_rng(1).uniform(-3.0, 3.0, (50, 3))
    plain = api.project(PLAIN, points, precision=precision)
    for w in (1.0, -2.0, 0.125):
        found = api.project(
            PLAIN, np.column_stack([w * points, np.full(50, w)]), precision=precision
        )
        np.testing.assert_array_equal(found.world, np.column_stack([points, np.ones(50)]))
        for part, other in zip(found[2:], plain[2:], strict=True):
            np.testing.assert_array_equal(part, other)
    rows = np.column_stack([points, np.arange(50) % 2])
    mixed = api.project(PLAIN, rows.reshape(5, 10, 4), precision=precision)
    np.testing.assert_array_equal(mixed.image.reshape(50, 2)[1::2], plain.image[1::2])
    one = api.project(PLAIN, rows[4], precision=precision)
    np.testing.assert_array_equal(mixed.image[0, 4], one.image)


def test_points_are_computed_as_arrays() -> None:
    """A point costs no calls of its own; on the eye plane, where its row is exact, it costs few."""
    points = np.random.default_rng(1).uniform(-3.0, 3.0, (1000, 3))
    projection = api.load().projection
    camera = projection.camera
    across = camera.frame[:2].T @ points[:, :2].T
    on_the_eye_plane = across.T + camera.eye

    def calls(given: Any, **options: Any) -> int:
        """Count the calls of Python functions."""
        events: list[str] = []
        sys.setprofile(lambda _frame, event, _called: events.append(event))
        try:
            api.project(projection, given, **options)
        finally:
            sys.setprofile(None)
        return events.count("call")

    rows = [np.column_stack([points, np.full(len(points), w)]) for w in (1.0, 2.0, 0.0)]
    for given, options, most in (
        (points, {}, 0.1),
        *((row, {}, 0.1) for row in rows),
        (points, {"precision": "float32"}, 0.1),
        (on_the_eye_plane, {}, 20.0),  # once 520
    ):
        calls(given[:2], **options)  # what is kept from now on
        more = calls(given, **options) - calls(given[:100], **options)
        assert more < most * (len(given) - 100)


def test_a_matrix_is_the_product_of_those_before_it() -> None:
    found = api.matrices(PLAIN)
    product = found["clip_from_view"] @ found["view_from_world"]
    np.testing.assert_allclose(product, found["clip_from_world"], rtol=1e-15)
    np.testing.assert_array_equal(found["clip_from_view"][2:], [(0, 0, -2, -3), (0, 0, -1, 0)])


def test_what_cannot_be_is_refused_in_a_sentence() -> None:
    document = api.load("letter-f")

    def call(name: str) -> Any:
        return getattr(api, name)  # its types do not matter here

    def film(*sweeps: Any, **options: Any) -> None:
        api.figure(document).film("a.gif", *sweeps, **options)

    for refused, words in (
        (lambda: api.load("leter-f"), "letter-f"),
        (lambda: api.load("focus", "lens.near=-1"), "lens.near = -1"),
        (lambda: api.load("none.json"), "does not exist"),
        (
            lambda: api.project(document, [(1, 2), (3,)]),
            "points = ((1, 2), (3)): must have equally",
        ),
        (lambda: api.project(document, [(1, 2)]), "points.shape = (1, 2): must end in 3 or 4,"),
        (
            lambda: api.project(document, [(1, 2, 3, 1), (0, 0, 0, 0)]),
            "points[1].w = 0: must not be",
        ),
        (lambda: api.project(document, (1, 0, 0, 1e-200)), "points.x/w = 1e+200: must be at most"),
        (
            lambda: api.figure(document, [(1, 2, math.nan, 1)]),
            "points[0] = (1, 2, nan, 1): must have",
        ),
        (lambda: api.project(document, [(1, 2, 3, "w")]), "points[0] = (1, 2, 3, 'w'): must have"),
        (lambda: api.figure(document, [(1, 2, 3)] * 7), "points: at most 6 can be marked, and 7"),
        (lambda: call("project")(document, [(1, 2, 3)], precision="float16"), "precision = 'float"),
        (lambda: call("figure")("focus"), "of = 'focus': must be a document or a projection"),
        (lambda: call("matrices")("focus"), "such as load('focus')."),
        (lambda: call("load")("focus", {"lens.near": 2}), "must be written as NAME=VALUE"),
        (lambda: call("project")(None, [(1, 2, 3)]), "such as load('letter-f')"),
        (lambda: call("figure")(document, size=84), "size = 84: must be WIDTHxHEIGHT"),
        (lambda: call("figure")(document, width="84"), "width = 84: must be a whole number of"),
        (lambda: call("figure")(document, width="84km"), "width = '84km': must be a length in mm"),
        (lambda: call("figure")(document, panes=3), "panes = 3: must be a text or a list of some"),
        (lambda: call("figure")(document, panes=["world", "film"]), "pane = 'film'"),
        (lambda: call("figure")(document, palette=["print"]), "palette = ('print')"),
        (lambda: call("figure")(document, text_size="8mm"), "text_size = '8mm'"),
        (lambda: call("figure")(document, panes="world/ndc,image"), "'ndc,image'"),
        (lambda: api.figure(document, size="120"), "WIDTHxHEIGHT in mm"),
        (lambda: call("figure")(document, palette="grey"), "palette = 'grey'"),
        (lambda: api.figure(document, text_size=0.0), "text size = 0"),
        (lambda: api.figure(document).save("figure.gif"), "must end in"),
        (lambda: call("figure")(document).save(3), "path = 3: must be the name of a file"),
        (lambda: call("load")(3), "source = 3: must be the name of a file"),
        (
            lambda: api.figure(document, width="84mm", size="9mmx9mm"),
            "size = '9mmx9mm': must be left",
        ),
        (lambda: api.figure(document, width="84mm", crop=True), "crop = True: must be left out"),
        (lambda: call("figure")(document, transparent="no"), "transparent = 'no': must be true or"),
        (lambda: api.figure(document, dot_size=2), "dot_size = 2: must be left out where there is"),
        (lambda: api.figure(document, cloud=[(1, 2)]), "cloud.shape = (1, 2): must end in 3,"),
        (lambda: api.figure(document, cloud=[(0, 1, math.inf)]), "cloud[0] = (0, 1, inf): must"),
        (lambda: api.figure(document).axes(None), "ax = None: must be axes of matplotlib"),
        (lambda: api.figure(document).film("a.gif"), "sweep = '': must be NAME=FIRST:LAST"),
        (lambda: film(3), "sweep = '3': must be NAME=FIRST:LAST"),
        (lambda: film(NEAR, frames="x"), "frames = x: must be a whole number from 2"),
        (lambda: film(NEAR, frames=2.5), "frames = 2.5: must be a whole number from 2"),
        (lambda: film(NEAR, fps="x"), "fps = 'x': must be a finite number"),
    ):
        with pytest.raises(Refusal, match=re.escape(words)):
            refused()


@pytest.mark.parametrize(
    ("made", "words"),
    [
        (lambda no: api.Projection(lens=no), "lens = (1, 2, 3): must be of the type Lens."),
        (lambda no: api.Projection(camera=no), "camera = (1, 2, 3): must be of the type Camera."),
        (lambda no: api.Projection(placement=no), "placement = (1, 2, 3): must be of the type"),
        (lambda no: api.Document(projection=no), "projection = (1, 2, 3): must be of the type"),
        (lambda no: api.Document(view=no), "view = (1, 2, 3): must be of the type View."),
        (lambda no: api.Document(quality=no), "quality = (1, 2, 3): must be of the type Quality."),
        (lambda no: api.Document({no: 1}), "scene = {(1, 2, 3): ...}: must be the name of a scene"),
        (lambda no: api.figure(PLAIN).film("f.gif", NEAR, show_value=no), "show_value = (1, 2, 3)"),
        (lambda no: api.figure(PLAIN, width=10**400), "width = 1000"),
        (lambda no: api.figure(PLAIN, text_size=10**400), "text_size = 1e400: must be a number"),
    ],
)
def test_what_is_of_another_type_is_refused_where_it_is_given(made: Any, words: str) -> None:
    with pytest.raises(Refusal, match=re.escape(words)):
        made((1, 2, 3))


@pytest.mark.parametrize("scene", ["letter-f", "focus"])
@pytest.mark.parametrize("kind", ["perspective", "frustum", "orthographic", "oblique", "matrix"])
def test_what_was_used_is_copied_and_goes_to_another_process(scene: str, kind: str) -> None:
    """`multiprocessing` sends it as pickle does; what it has computed holds functions."""
    document = api.load(scene, f"lens.kind={kind}", "view.compare=image.width=9|image.width=8")
    before = [each.tolist() for each in api.matrices(document).values()]
    for copied in (copy.copy(document), copy.deepcopy(document)):
        assert copied == document and copied.view == document.view
    again = pickle.loads(pickle.dumps(document))
    assert again == document and again.settings == document.settings
    assert [each.tolist() for each in api.matrices(again).values()] == before
    with pytest.raises(TypeError):
        again.settings["anything"] = 1


def test_a_missing_mesh_is_named_where_nothing_can_be_drawn() -> None:
    with bare_machine():
        with pytest.raises(RuntimeError, match="no OpenGL"):
            api.figure(PLAIN).save("figure.svg")
        with pytest.raises(Refusal, match=r"gone\.stl"):
            api.figure(Document("gone.stl")).save("figure.svg")


@pytest.mark.skipif(sys.platform != "linux", reason="X servers")
@pytest.mark.parametrize("chosen", ["", "vtkXOpenGLRenderWindow"])
def test_where_an_x_server_refuses_egl_draws(chosen: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A server whose last client has left starts anew, and refuses who comes meanwhile."""
    variable = "VTK_DEFAULT_OPENGL_WINDOW"

    class Window:
        def SetOffScreenRendering(self, on: int) -> None:
            assert on

        def SupportsOpenGL(self) -> bool:
            return os.environ.get(variable) == "vtkEGLRenderWindow"

        def GetOpenGLSupportMessage(self) -> str:
            return ""

    monkeypatch.setenv(variable, chosen)
    if not chosen:
        monkeypatch.delenv(variable)
    monkeypatch.setattr(off_screen, "window_that_draws", cache(lambda: Window))
    check = off_screen.check_off_screen.__wrapped__
    if chosen:
        with pytest.raises(RuntimeError, match=r"no OpenGL 3\.2"):
            check()
    else:
        assert isinstance(check(), Window)


def test_panes_are_a_text_or_a_list() -> None:
    named = api.figure(PLAIN, panes=["world", "image"])
    assert named.panes == api.figure(PLAIN, panes="world,image").panes == ("world", "image")


def test_a_mesh_that_is_not_whole_is_loaded_with_a_warning(tmp_path: Path) -> None:
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n", encoding="utf-8")
    with pytest.warns(UserWarning, match=r"m\.obj: faces left out: 1 of 2, .* on line 4\.$"):
        api.load(tmp_path / "m.obj")
