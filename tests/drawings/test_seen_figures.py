"""A value of the view changes the panes that show it in a figure, and no others."""

import io
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from PIL import Image

from app.document.document import Document
from app.document.lengths import DPI
from app.document.view import EVERYTHING, FIXED, LETTERS, PANES, View
from app.drawings.figure import USUAL_TEXT, Figure
from app.drawings.figure_files import png_bytes
from app.drawings.style import LIGHT, rgb, tone
from app.model.projection import Camera
from app.model.refusal import Refusal
from app.picking.picking import Probe
from app.scenes.scene import load
from tests.support.drawings import figure_of

SIDE, HIGH = 160, 128  # the image is as wide as the others
ABOVE = Camera((0.0, 40.0, 0.1), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))
ON_THE_LETTER = Probe(1, (0.5, 2.5, 0.5))


def drawn(view: View, **options: Any) -> dict[str, np.ndarray]:
    """The panes of a figure of the letter F."""
    scene = load("letter-f")
    pixels = figure_of(scene, scene.start, PANES, (3 * SIDE, HIGH), view=view, **options).pixels()
    return {pane: pixels[:, i * SIDE : (i + 1) * SIDE] for i, pane in enumerate(PANES)}


@pytest.fixture(scope="module")
def usual() -> dict[str, np.ndarray]:
    return drawn(View())


@pytest.mark.parametrize(
    ("view", "changed"),
    [
        (View(stage=0.0), {"ndc"}),
        (View(stage=1.0), {"ndc"}),
        (View(stage=2.0), {"ndc"}),
        (View(stage=3.0), {"ndc"}),
        (View(stage=3.5), {"ndc"}),
        (View(stage=5.0), {"ndc"}),
        (View(panel="frame", frame_step="n"), {"world"}),
        *[(View(fixed=fixed), {"world"}) for fixed in FIXED],
        (View(layers=frozenset({"labels"})), {"world", "ndc"}),
        (View(names=EVERYTHING), {"world", "ndc", "image"}),
        (View(names=("pixels", "x", "y", "z", "near", "far")), {"world", "image"}),
        (View(layers=frozenset({"handles"})), set()),
        (View(layers=frozenset({"grid"})), {"world", "ndc", "image"}),
        *[
            (View(layers=frozenset({layer})), {"world"})
            for layer in ("frustum", "camera", "near-picture")
        ],
        (View(probes=(ON_THE_LETTER,)), {"world", "ndc", "image"}),
        (View(probes=(Probe(1, pixel=(900.0, 200.0)),)), {"world", "ndc", "image"}),
        (View(panes={"world": ABOVE}), {"world"}),
        (View(panes={"ndc": replace(ABOVE, eye=(2.0, 1.0, 3.0))}), {"ndc"}),
        (View(panes={"second-screen": ABOVE}), set()),
        (View(frame_step="n", panel="matrices"), set()),
        (View(layout="columns", large="image", panel="probe"), set()),
        # The letters of near and far, and the sign of 002's depth.
        (View(letters=LETTERS[3]), {"world", "ndc"}),
    ],
)
def test_a_value_of_the_view_changes_the_panes_that_show_it_and_no_other(
    usual: dict[str, np.ndarray], view: View, changed: set[str]
) -> None:
    seen = drawn(view)
    assert {pane for pane in PANES if (seen[pane] != usual[pane]).any()} == changed


def test_no_two_stages_and_no_two_steps_are_the_same_figure() -> None:
    views = [View(stage=stage) for stage in (0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0)]
    views += [View(panel="frame", frame_step=step) for step in ("eye", "look", "up", "n", "u", "v")]
    figures = {b"".join(pane.tobytes() for pane in drawn(view).values()) for view in views}
    assert len(figures) == len(views)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("pane", ["world", "ndc", "image"])
@pytest.mark.parametrize("reach", [1e-99, 1e50, 1e100])
def test_what_is_far_beyond_every_scene_breaks_no_figure(pane: str, reach: float) -> None:
    """A file may contain such numbers; none of them becomes NaN."""
    scene = load("letter-f")
    probes = Probe(1, (reach, -reach, reach)), Probe(2, None, (16384.0, 0.0))
    for target in ((0.0, 0.0, 0.0), (-0.5, 3.7, -reach)):
        camera = Camera((reach, 0.5 * reach, 0.1 * reach), target, (0.0, 1e-99, 0.0))
        for stage in (0.0, 2.5, 4.0):
            view = View(stage=stage, probes=probes, panes={pane: camera})
            figure_of(scene, scene.start, (pane,), (32, 32), view=view).pixels()


def test_a_probe_is_marked_where_the_model_projects_it() -> None:
    scene = load("letter-f")
    point = ON_THE_LETTER.point
    assert point is not None
    x, y = scene.start.trace(point).image.tolist()
    plain = figure_of(scene, scene.start, ("image",), text_pt=5.0).pixels()
    marked = figure_of(
        scene, scene.start, ("image",), text_pt=5.0, view=View(probes=(ON_THE_LETTER,))
    ).pixels()
    rows, columns = np.nonzero((plain != marked).any(axis=2))
    em = 5.0 * DPI / 72.0
    assert np.hypot(rows - y, columns - x).min() < 1.0
    assert np.hypot(rows - y, columns - x).max() < 4.0 * em


# -- letters


def letters_height(pixels: np.ndarray) -> int:
    """Rows of the words in which near is written."""
    colour = np.round(255.0 * np.array(rgb(tone(LIGHT.near, LIGHT.background))))
    return int((np.abs(pixels - colour).max(axis=2) <= 2.0).any(axis=1).sum())


def test_letters_are_as_high_as_their_points_say() -> None:
    scene = load("letter-f")
    heights = {}
    for em_px in (20, 40):
        size = (600, 600)
        text_pt = em_px * 72.0 / DPI
        figure = figure_of(
            scene, scene.start, ("ndc",), size, text_pt=text_pt, view=View(stage=2.0)
        ).pixels()
        heights[em_px] = letters_height(figure)
    assert heights[40] / heights[20] == pytest.approx(2.0, rel=0.12)
    assert 0.6 < heights[40] / 40.0 < 0.9  # from the line to the top of the highest letter


def test_usual_letters_are_a_share_of_the_pane_and_7_points_across_a_page() -> None:
    figure = partial(Figure, Document(), load("letter-f"))
    assert figure().em_pt == pytest.approx(7.0)
    assert pytest.approx(162.56) == 3 * 640 / DPI * 25.4  # mm
    assert figure(PANES, (900, 300)).em_pt == pytest.approx(USUAL_TEXT * 300 * 72 / DPI)
    assert figure(("image",)).em_pt == pytest.approx(USUAL_TEXT * 720 * 72 / DPI)
    text_pt = figure(PANES, (3 * SIDE, HIGH)).em_pt
    once, asked = drawn(View()), drawn(View(), text_pt=text_pt)
    # An image has words and numbers alone, and no letter that is larger than they are on screens.
    assert [(once[pane] == asked[pane]).all() for pane in PANES] == [False, False, True]


@pytest.mark.parametrize("text_pt", [0.0, -1.0, 0.2, 1e300, float("nan"), float("inf")])
def test_letters_that_no_pane_can_have_are_refused(text_pt: float) -> None:
    with pytest.raises(Refusal) as caught:
        Figure(Document(), load("letter-f"), text_pt=text_pt)
    assert str(caught.value).startswith("text size = ")
    assert str(caught.value).endswith(": must be from 0.24 to 38.4 points in panes of this size.")


@pytest.mark.parametrize("text_pt", [0.24, 38.4])
def test_the_smallest_and_the_largest_letters_are_drawn(text_pt: float) -> None:
    scene = load("letter-f")
    assert figure_of(scene, scene.start, PANES, text_pt=text_pt).pixels().shape == (640, 1920, 3)


def test_a_file_says_how_many_pixels_are_an_inch() -> None:
    pixels = np.zeros((4, 4, 3), np.uint8)
    for scale in (0.5, 1.0, 2.0):
        with Image.open(io.BytesIO(png_bytes(pixels, "{}", scale))) as image:
            assert image.info["dpi"] == pytest.approx((DPI * scale, DPI * scale), rel=1e-3)
