"""Chosen quality in the document and in the panes, and quality that gives way while one drags."""

import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QProgressDialog
from pytestqt.qtbot import QtBot

from app.document.codec import parse, to_json
from app.document.document import Document
from app.document.settings import set_values
from app.drawings import labels
from app.drawings.frame_budget import FrameBudget, FrameQuality
from app.measure import smoothing
from app.model.projection import FreeMatrix, Orthographic, Perspective
from app.model.refusal import Refusal
from app.precision.quality import AUTOMATIC, SMOOTHINGS, Quality
from app.scenes.fewer_triangles import SHARES, is_made, reduced, shares_for_dragging
from app.scenes.scene import Scene, load
from tests.support.drawings import figure_of
from tests.support.window import MakeWindow, counted_repaints, pixels, settle, show_scene
from widgets.panes import adaptive, canvas
from widgets.panes.adaptive import BETWEEN_MS
from widgets.panes.canvas import REST_MS
from widgets.parts.number_field import NumberDialog
from widgets.window.main_window import MainWindow
from widgets.window.settings import Settings

pytestmark = pytest.mark.smooth

PANES = ("world", "ndc", "image")


@pytest.fixture(scope="module")
def mesh(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A ball with dents, of enough triangles to be reduced in advance."""
    path = tmp_path_factory.mktemp("meshes") / "ball.ply"
    ball = pv.Sphere(theta_resolution=240, phi_resolution=240)
    ball.points *= 1.0 + 0.3 * np.sin(25.0 * ball.points[:, :1])
    ball.save(path)
    return str(path)


@pytest.fixture(scope="module")
def ball(mesh: str) -> Scene:
    return load(mesh)


def pictures(window: MainWindow) -> dict[str, np.ndarray]:
    settle()
    return {name: pixels(window, name) for name in PANES}


def same(one: dict[str, np.ndarray], other: dict[str, np.ndarray]) -> dict[str, bool]:
    return {name: bool((one[name] == other[name]).all()) for name in PANES}


ALL_SAME = dict.fromkeys(PANES, True)

# -- the value and the document


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("rung=exact", "quality.rung = 'exact': must be one of auto, float32, float64."),
        ("detail=0.001", "quality.detail = 0.001: must be at least 0.01."),
        ("detail=1.5", "quality.detail = 1.5: must be at most 1."),
        ("detail=nan", "quality.detail = 'nan': must be a finite number."),
        (
            "smoothing=MSAA 16",
            f"quality.smoothing = 'MSAA 16': must be one of {', '.join(SMOOTHINGS)}.",
        ),
        (
            "depth_format=fixed9",
            "quality.depth_format = 'fixed9': must be one of '', fixed8, fixed16, fixed24, "
            "fixed32, float16, float32.",
        ),
        ("runge=float32", "quality.runge is not known; the nearest name is quality.rung."),
    ],
)
def test_an_impossible_value_is_refused_in_one_sentence(text: str, sentence: str) -> None:
    with pytest.raises(Refusal) as refused:
        set_values(Document(), [f"quality.{text}"])
    assert str(refused.value) == sentence


@pytest.mark.parametrize("detail", [math.nan, math.inf, True, "1", None])
def test_a_share_is_a_number(detail: Any) -> None:
    with pytest.raises(Refusal):
        Quality(detail=detail)


def test_the_document_writes_what_is_not_automatic_and_nothing_else() -> None:
    assert '"quality"' not in to_json(Document())
    chosen = set_values(
        Document(), ["quality.rung=float32", "quality.detail=0.2", "quality.smoothing=MSAA 4"]
    )
    assert chosen.quality == Quality("float32", "MSAA 4", 0.2)
    text = to_json(chosen)
    assert '"quality": {"rung": "float32", "smoothing": "MSAA 4", "detail": 0.2}' in text
    assert parse(text) == chosen
    later = text.replace('"rung"', '"dither": 3, "rung"')
    assert '"dither": 3' in to_json(parse(later)), "what is not known is kept"
    assert parse(later).quality == chosen.quality
    back = set_values(chosen, ["quality.rung=auto", "quality.detail=1", "quality.smoothing=auto"])
    assert back == Document() and hash(back) == hash(Document()) != hash(chosen)


def test_the_names_are_those_of_the_measurements() -> None:
    assert set(SMOOTHINGS) == {"auto", *(one.name for one in smoothing.SMOOTHINGS)}
    assert set(canvas.SMOOTHINGS) < set(SMOOTHINGS)
    assert {one.name: one.scale for one in smoothing.SMOOTHINGS if one.name in canvas.SCALES} == (
        canvas.SCALES
    )


# -- the panes


def test_a_precision_is_used_and_undone(window: MainWindow) -> None:
    before = pictures(window)
    for precision in ("float64", "float32"):
        window.quality.use({"rung": precision})
        settle()
        assert {window.panes[name].drawing.precision for name in ("ndc", "image")} == {precision}
    window.store.undo()
    window.store.undo()
    assert window.store.document.quality == AUTOMATIC
    assert same(pictures(window), before) == ALL_SAME


def test_float32_draws_even_where_it_is_wrong(make_window: MakeWindow) -> None:
    """A corner so close that float32 puts it elsewhere."""
    scene = load("letter-f")
    camera = replace(scene.start.camera, target=scene.upper)
    close = replace(scene.start, camera=camera, lens=Perspective(1e-6, 1.0, 30.0))
    window = make_window(Document("letter-f", close))
    exact = pictures(window)["image"]
    assert window.panes["image"].drawing.precision == "float64"
    window.quality.use({"rung": "float32"})
    assert (pictures(window)["image"] != exact).mean() > 0.002
    window.quality.use({"rung": "auto"})
    assert (pictures(window)["image"] == exact).all()


def test_a_smoothing_is_used_in_every_pane_and_kept_during_a_drag(window: MainWindow) -> None:
    window.resize(940, 560)  # quickly drawn
    before = pictures(window)
    window.quality.use({"smoothing": "none"})
    rough = pictures(window)
    for name in canvas.SMOOTHINGS:
        window.quality.use({"smoothing": name})
        chosen = pictures(window)
        others = {"none": before, "FXAA": rough}.get(name, rough)
        assert not any(same(chosen, others).values()), name
        if name in ("none", "FXAA"):
            assert same(chosen, {"none": rough, "FXAA": before}[name]) == ALL_SAME
        for part in window.panes.values():
            sides = np.array(part.canvas.render_window.GetSize())
            shown = np.array([part.canvas.width(), part.canvas.height()])
            assert np.abs(sides - canvas.SCALES.get(name, 1.0) * shown).max() <= 1.0, name
        window.store.begin_gesture()
        window.store.set_projection(replace(window.store.document.projection, depth="direct3d"))
        settle()
        assert (pixels(window, "image") == chosen["image"]).all(), "it does not wait for the hand"
        window.store.end_gesture()
        window.quality.use({"smoothing": "auto", "depth_format": ""})
        window.store.set_projection(replace(window.store.document.projection, depth="opengl"))
        assert same(pictures(window), before) == ALL_SAME, name


def test_supersampling_averages_four_pixels(window: MainWindow) -> None:
    """Between the two colours of a slanted edge there are three steps and no other."""
    window.quality.use({"smoothing": "supersampling 2 x 2"})
    settle()
    part = window.panes["image"]
    rectangle = part.drawing.picture_rectangle_px
    finer = pictures(window)["image"].astype(int)
    window.quality.use({"smoothing": "none"})
    plain = pictures(window)["image"].astype(int)
    left, top, width, height = (side // 2 for side in rectangle)
    inside = np.s_[top + 2 : top + height - 2, left + 2 : left + width - 2]
    blue = np.array([86, 180, 233])
    assert np.abs(plain[inside] - blue).max(axis=-1).min() <= 30, "a face of the letter is there"
    assert (finer != plain).any(axis=-1)[inside].mean() > 0.01
    assert abs(finer[inside].mean() - plain[inside].mean()) < 3.0, "the same picture"


def test_a_click_hits_the_same_vertex_at_any_scale(window: MainWindow) -> None:
    corner = np.array(load("letter-f").upper)
    part = window.panes["image"]
    for name in ("none", "half resolution", "supersampling 2 x 2"):
        window.probe_panel.clear()
        window.quality.use({"smoothing": name})
        settle()
        ((x, y),) = part.drawing.sight.seen([corner.tolist()]).tolist()
        drawn_px, shown_px = part.canvas.render_window.GetSize()[1], part.canvas.height()
        place = QPoint(math.floor(x * shown_px / drawn_px), math.floor(y * shown_px / drawn_px))
        assert part.canvas.rect().contains(place)
        QTest.mouseClick(part.canvas, Qt.MouseButton.LeftButton, pos=place)
        settle()
        (probe,) = window.probe_panel.probes
        assert probe.point is not None and np.allclose(probe.point, corner), name


def test_an_impossible_choice_for_a_pane_or_scene_is_reported_and_changes_nothing(
    window: MainWindow,
) -> None:
    too_fine = "A pane cannot draw with supersampling 3 x 3: it uses its default smoothing."
    for scene, choice, sentence in (
        ("letter-f", {"smoothing": "supersampling 3 x 3"}, too_fine),
        ("letter-f", {"detail": "0.5"}, "The scene has too few triangles to leave any out."),
        ("interpolation", {"rung": "float64"}, "A textured surface can be drawn in float32 only."),
    ):
        before = pictures(show_scene(window, scene))
        window.quality.use(choice)
        assert same(pictures(window), before) == ALL_SAME, choice
        assert sentence in window.status.health.toolTip().splitlines()
        window.store.undo()
        settle()
        assert sentence not in window.status.health.toolTip()


@pytest.mark.undrawn
def test_a_swept_value_that_the_document_cannot_have_is_refused(window: MainWindow) -> None:
    before = window.store.document
    window.quality.use({"lens.near": "20.0"})  # its far is 18
    assert "near" in window.messages.text and "20" in window.messages.text
    assert window.store.document == before


@pytest.mark.undrawn
def test_too_few_samples_are_reported(window: MainWindow) -> None:
    window.quality.use({"smoothing": "MSAA 8"})
    settle()
    given = window.look.adaptive.samples
    sentence = f"This computer's OpenGL gives {given} samples per pixel instead of MSAA 8."
    assert (sentence in window.status.health.toolTip().splitlines()) == (given > 0)


def test_fewer_triangles_are_drawn_and_undone(
    make_window: MakeWindow, mesh: str, ball: Scene
) -> None:
    window = make_window(Document(mesh, ball.start))
    whole = pictures(window)
    window.quality.use({"detail": "0.01"})
    chosen = pictures(window)
    assert not any(same(chosen, whole).values())
    window.store.undo()
    assert same(pictures(window), whole) == ALL_SAME
    opened = make_window(Document(mesh, ball.start, quality=Quality(detail=0.01)))
    assert same(pictures(opened), chosen) == ALL_SAME


def test_a_depth_buffer_is_drawn_with_in_any_scene(make_window: MakeWindow) -> None:
    document = Document("letter-f", load("letter-f").start)
    deep = replace(document.projection, lens=Perspective(45.0, 0.1, 1000.0))
    window = make_window(replace(document, projection=deep))
    window.slots.arrange("pictures", "image")
    settle()
    before = pictures(window)
    window.quality.use({"depth_format": "fixed8", "depth_mapping": "direct3d"})
    assert window.slots.large == "image", "it is looked at as before"
    coarse = pictures(window)
    assert same(coarse, before) == {"world": True, "ndc": True, "image": False}
    wrong = (coarse["image"] != before["image"]).any(axis=-1).mean()
    window.quality.use({"depth_format": "float32", "depth_mapping": "reversed"})
    fine = (pictures(window)["image"] != before["image"]).any(axis=-1).mean()
    assert wrong > 0.005 and fine < wrong / 3.0
    window.store.undo()
    assert (pictures(window)["image"] == coarse["image"]).all()
    # A slider moves what is fought over: the buffer follows the lens.
    window.store.set_projection(replace(deep, lens=Perspective(45.0, 9.0, 15.0)))
    settle()
    near = pictures(window)["image"]
    window.quality.use({"depth_format": "", "depth_mapping": ""})
    assert (pictures(window)["image"] != near).any(axis=-1).mean() < wrong / 3.0


def test_a_depth_buffer_that_a_lens_cannot_have_is_reported(window: MainWindow) -> None:
    start = load("letter-f").start
    for mapping, lens, words in (
        ("logarithmic", Orthographic(), "depth_mapping"),
        ("logarithmic", Perspective(45.0, 1.0, math.inf), "must be a finite number."),
        ("direct3d", FreeMatrix(start.clip_from_view.tolist()), "kind"),
    ):
        window.store.open(Document("letter-f", replace(start, lens=lens)))
        settle()
        before = pictures(window)["image"]
        window.quality.use({"depth_mapping": mapping})
        assert (pictures(window)["image"] == before).all()
        (sentence,) = (
            line
            for line in window.status.health.toolTip().splitlines()
            if line.startswith("The image uses the ordinary depth buffer: ")
        )
        assert words in sentence
        window.store.set_projection(start)
        settle()
        assert "ordinary depth buffer" not in window.status.health.toolTip()


def test_a_scene_about_a_depth_buffer_keeps_its_own(make_window: MakeWindow) -> None:
    scene = load("depth-buffer")
    window = make_window(Document("depth-buffer", scene.start))
    before = pictures(window)["image"]
    window.quality.use({"depth_format": "fixed8"})
    assert (pictures(window)["image"] == before).all()


@pytest.mark.undrawn
def test_the_status_line_shows_the_choice_and_leads_back(window: MainWindow) -> None:
    button = window.status.quality
    assert not button.isVisible()
    window.quality.use({"rung": "float64"})
    window.quality.use({"detail": "0.2"})
    assert button.isVisible() and button.text() == "quality: float64, 20 %"
    document = window.store.document
    window.quality.use({"rung": "float8"})
    assert window.store.document is document
    assert window.messages.text.startswith("quality.rung = 'float8': must be one of ")
    button.click()
    assert window.store.document.quality == AUTOMATIC and not button.isVisible()
    window.store.undo()
    assert window.store.document.quality == Quality("float64", detail=0.2) and button.isVisible()


def test_figures_use_the_quality_of_the_document(ball: Scene) -> None:
    def picture(**choices: Any) -> np.ndarray:
        return figure_of(
            ball, ball.start, ("image",), size=(200, 150), quality=Quality(**choices)
        ).pixels()

    whole = picture()
    fewer = figure_of(reduced(ball, 0.01), ball.start, ("image",), size=(200, 150)).pixels()
    assert (picture(detail=0.01) == fewer).all() and (fewer != whole).any()
    assert (picture(smoothing="none") == whole).all()
    assert (picture(depth_format="fixed8") != whole).any()


# -- the budget


def dragged(budget: FrameBudget, cost: Callable[[FrameQuality], float], frames: int) -> list[float]:
    """Frame times of a drag."""
    times = []
    for _ in range(frames):
        times.append(cost(budget.level))
        budget.frame(times[-1])
    return times


LEVELS = (
    FrameQuality(True, 1.0),
    FrameQuality(False, 1.0),
    *(FrameQuality(False, share) for share in SHARES),
)


@pytest.mark.parametrize("fixed_ms", [2.0, 15.0, 25.0])
@pytest.mark.parametrize("whole_ms", [1.0, 30.0, 100.0, 500.0])
def test_the_frame_budget_holds_the_target_with_the_finest_that_does(
    fixed_ms: float, whole_ms: float
) -> None:
    def cost(level: FrameQuality) -> float:
        return fixed_ms + whole_ms * level.share * (1.5 if level.smooth else 1.0)

    budget = FrameBudget(LEVELS, 33.0)
    times = dragged(budget, cost, 300)
    assert max(times[12:]) <= 33.0
    finer = LEVELS[: LEVELS.index(budget.level)]
    assert all(cost(level) > 0.7 * 33.0 for level in finer), "there was no room for more"


def test_the_frame_budget_rises_again_when_there_is_room() -> None:
    budget = FrameBudget(LEVELS, 33.0)
    dragged(budget, lambda level: 500.0 * level.weight, 40)
    assert budget.level.share < 0.2
    dragged(budget, lambda level: 10.0 * level.weight, 1000)
    assert budget.level == LEVELS[0]


def test_one_late_frame_changes_nothing() -> None:
    budget = FrameBudget(LEVELS, 33.0)
    for frame in range(200):
        budget.frame(90.0 if frame % 40 == 30 else 20.0)
        assert budget.level == LEVELS[0]


def test_the_frame_budget_says_when_even_the_coarsest_is_late() -> None:
    budget = FrameBudget(LEVELS, 33.0)
    dragged(budget, lambda level: 50.0 + level.weight, 60)
    assert budget.level == LEVELS[-1] and budget.is_late and budget.frame_ms == pytest.approx(50.01)
    dragged(budget, lambda level: 5.0 + level.weight, 60)
    assert not budget.is_late
    without_target = FrameBudget(LEVELS, 0.0)
    dragged(without_target, lambda level: 1e4, 50)
    assert without_target.level == LEVELS[0] and not without_target.is_late


def test_frames_that_vary_are_in_time_as_well() -> None:
    """One in twelve takes half as long again: it is those that the target is held for."""
    budget = FrameBudget(LEVELS, 33.0)
    times = []
    for frame in range(400):
        spread = 1.5 if frame % 12 == 3 else 1.0
        times.append(spread * (18.0 + 8.0 * budget.level.weight))
        budget.frame(times[-1])
    assert sum(ms > 33.0 for ms in times) <= 0.05 * len(times)


# -- the window's budget


def step(window: MainWindow, i: int) -> None:
    projection = window.store.document.projection
    window.store.set_projection(replace(projection, lens=replace(projection.lens, fov_y_deg=i)))
    settle()


def triangles(window: MainWindow) -> dict[str, int]:
    """How many each pane has been given to draw."""
    counts = {}
    for name, part in window.panes.items():
        renderers = part.canvas.render_window.GetRenderers()
        actors = [actor for renderer in renderers for actor in renderer.GetActors()]
        counts[name] = sum(actor.GetMapper().GetInput().GetNumberOfPolys() for actor in actors)
    return counts


def test_quality_is_reduced_during_a_drag_and_restored_after_it(
    make_window: MakeWindow, mesh: str
) -> None:
    """No frame is ever as short as is asked for here: the coarsest is drawn, and whole at rest."""
    scene = "planar-shadow"  # which draws the mesh and its copy
    start = load(scene, mesh=mesh).start
    window = make_window(Document(scene, start, mesh=mesh, quality=Quality("float64")))
    window.look.adaptive.set_target(0.001)
    settle()
    window.store.begin_gesture()
    for i in range(16):
        step(window, 40.0 + i)
    assert window.look.adaptive.budget.level == FrameQuality(False, 0.005)
    dragged_pictures = pictures(window)
    (late,) = said_to_be_late(window)
    assert "ms to draw" in late
    window.store.end_gesture()
    assert said_to_be_late(window) == []
    settle()
    fresh = make_window(window.store.document)
    window.slots.reset_views()  # it was opened at another field of view
    settle()
    rested, full = pictures(window), pictures(fresh)
    assert same(rested, full) == ALL_SAME
    assert triangles(window) == triangles(fresh), "copies, too, whose pixels may be the same"
    fresh.quality.use({"smoothing": "none"})
    assert not any(same(pictures(fresh), dragged_pictures).values()), "there were fewer triangles"


def said_to_be_late(window: MainWindow) -> list[str]:
    return [line for line in window.status.health.toolTip().splitlines() if "stutters" in line]


def test_late_frames_are_reported_during_a_drag_at_no_cost(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At rest nothing is late; the next drag says it again with its first frame."""
    window.settings.reduce_motion = True  # labels that move later draw frames of their own
    monkeypatch.setattr(labels, "PATIENCE_S", math.inf)
    told: list[int] = []
    window.look.adaptive.changed.connect(lambda: told.append(len(said_to_be_late(window))))
    drawn: list[tuple[dict[str, int], dict[str, int]]] = []
    for target_ms, first in ((1000.0, 20.0), (0.001, 40.0), (0.001, 60.0)):
        if target_ms != window.look.adaptive.budget.target_ms:
            window.look.adaptive.set_target(target_ms)
        window.store.begin_gesture()
        with counted_repaints(window) as dragging:
            step(window, first)
            at_first = len(said_to_be_late(window))
            for i in range(11):
                step(window, first + 1 + i)
        late = len(said_to_be_late(window))
        with counted_repaints(window) as resting:
            window.store.end_gesture()
            assert said_to_be_late(window) == []
            settle()
        assert said_to_be_late(window) == []
        assert (at_first, late) == {20.0: (0, 0), 40.0: (0, 1), 60.0: (1, 1)}[first]
        assert resting.pop("world") <= 2  # one more where a label stands elsewhere at rest
        drawn.append((dragging, resting))
    assert told == [1, 0, 1, 0]
    assert drawn[0] == drawn[1] == drawn[2] and drawn[0][0] == dict.fromkeys(PANES, 12)


@pytest.mark.parametrize(
    ("triangles", "shares"),
    [
        (180, ()),
        (1_000, (0.5,)),
        (20_000, SHARES[:-1]),
        (2_000_000, (*SHARES, 0.005, 0.002, 0.001, 0.0005)),
    ],
)
def test_the_shares_for_dragging_depend_on_the_size_of_the_mesh(
    triangles: int, shares: tuple[float, ...]
) -> None:
    """A mesh of any size gets down to what hardly takes time, and none to nothing."""
    scene = load("letter-f")
    corners = np.arange(3 * triangles).reshape(-1, 3) % 3
    surface = pv.PolyData.from_regular_faces(np.eye(3, dtype=np.float32), corners)
    assert shares_for_dragging(replace(scene, surface=surface)) == shares
    assert shares_for_dragging(replace(scene, surface=None)) == ()


def test_a_scene_whose_vertices_are_moved_stays_whole_in_a_drag() -> None:
    """Each drawn vertex is looked up among the scene's own, which a coarser mesh does not have."""
    assert shares_for_dragging(load("vertex-depth")) == ()


@pytest.mark.parametrize("software", [True, False])
def test_the_first_step_of_a_drag_waits_for_no_large_mesh(
    make_window: MakeWindow, mesh: str, monkeypatch: pytest.MonkeyPatch, software: bool
) -> None:
    """A software renderer starts with few triangles and takes more while it is in time."""
    monkeypatch.setattr("widgets.panes.adaptive.AT_FIRST", 3_000)
    window = make_window(Document(mesh, load(mesh).start), software_rendering=software)
    window.look.adaptive.set_target(10_000.0)
    settle()
    whole = triangles(window)
    window.store.begin_gesture()
    step(window, 40.0)
    assert (window.look.adaptive.budget.level.share < 1.0) == software
    fewer = triangles(window)
    assert all((fewer[name] < whole[name]) == software for name in PANES)
    for i in range(80):
        step(window, 41.0 + 0.1 * i)
        if window.look.adaptive.budget.level.share == 1.0:
            break
    step(window, 50.0)
    assert window.look.adaptive.budget.level.share == 1.0 and triangles(window) == whole
    window.store.end_gesture()


def test_while_a_small_mesh_is_made_coarser_unseen_nothing_comes_between(
    make_window: MakeWindow, tmp_path: Path
) -> None:
    """No dialog keeps the user from the window, so that neither a key nor a click may reach it."""
    path = tmp_path / "small.ply"
    pv.Sphere(theta_resolution=26, phi_resolution=26).save(path)
    window = make_window()
    window.look.adaptive.set_target(0.0)
    assert window.files.open(path)
    scene = window.shown.scene
    shares = shares_for_dragging(scene)
    assert len(shares) == 1 and not is_made(scene, shares[0])
    found: list[bool] = []
    window.look.adaptive.set_target(33.0)
    QTimer.singleShot(0, lambda: found.append(is_made(scene, shares[0])))
    window.look.adaptive.findChild(QTimer).timeout.emit()  # nothing is asked for just now
    QApplication.processEvents()
    assert found == [True]


def test_a_small_scene_is_made_coarser_in_pauses_and_not_in_a_drag(
    window: MainWindow, tmp_path: Path
) -> None:
    """A hand waits for one version at most."""
    path = tmp_path / "small.ply"
    pv.Sphere(theta_resolution=66, phi_resolution=66).save(path)
    assert window.files.open(path)
    scene, pause = window.shown.scene, window.look.adaptive.findChild(QTimer)
    shares = shares_for_dragging(scene)
    assert pause.isActive() and pause.interval() == BETWEEN_MS and len(shares) == 3
    made = []
    window.store.begin_gesture()
    step(window, 40.0)
    for _ in range(5):
        pause.timeout.emit()
        made.append(sum(is_made(scene, share) for share in shares))
        if made == [0]:
            window.store.end_gesture()
    assert made == [0, 1, 2, 3, 3]


def test_a_pane_hidden_during_the_drag_is_restored_too(
    make_window: MakeWindow, mesh: str, ball: Scene
) -> None:
    window = make_window(Document(mesh, ball.start))
    settle()
    window.look.adaptive.set_target(0.001)
    settle()
    window.store.begin_gesture()
    for i in range(6):
        step(window, 40.0 + i)
    window.slots.make_large("world")
    window.store.end_gesture()
    settle()
    window.slots.make_large("world")
    fresh = make_window(window.store.document)
    assert same(pictures(window), pictures(fresh)) == ALL_SAME


def test_a_view_that_is_turned_is_drawn_in_time_and_restored_after_it(
    make_window: MakeWindow, mesh: str, ball: Scene, qtbot: QtBot
) -> None:
    """Only the pane that the hand turns has fewer triangles, as long as the button is down."""
    window = make_window(Document(mesh, ball.start))
    settle()
    window.look.adaptive.set_target(0.001)
    settle()
    whole, surface = triangles(window), window.panes["world"].canvas
    place, level = QPoint(20, 40), window.look.adaptive.budget.level
    QTest.mousePress(surface, Qt.MouseButton.LeftButton, pos=place)
    for i in range(1, 20):
        QTest.mouseMove(surface, place + QPoint(3 * i, i))
        settle()
    QTest.qWait(2 * REST_MS)
    turned = triangles(window)
    assert turned["world"] < whole["world"] / 10
    assert window.panes["world"].requested["smoothing"] == "none"
    assert (turned["ndc"], turned["image"]) == (whole["ndc"], whole["image"])
    assert window.look.adaptive.budget.level == level, "a drag of a control draws more"
    QTest.mouseRelease(surface, Qt.MouseButton.LeftButton, pos=place)
    qtbot.waitUntil(lambda: triangles(window) == whole, timeout=20_000)
    assert window.panes["world"].requested["smoothing"] != "none"


def test_antialiasing_is_dropped_first(make_window: MakeWindow) -> None:
    window = make_window(software_rendering=False)
    settle()
    window.store.begin_gesture()
    step(window, 41.0)
    smooth = pixels(window, "image")
    window.look.adaptive.set_target(0.001)
    step(window, 42.0)
    step(window, 41.0)
    rough = pixels(window, "image")
    assert (rough != smooth).any()
    window.store.end_gesture()
    settle()
    assert (pixels(window, "image") == smooth).all()


def test_levels_are_made_when_a_large_scene_is_opened_and_can_be_refused(
    make_window: MakeWindow, mesh: str, own_home: Path, qtbot: Any
) -> None:
    settings = Settings(own_home / "settings.ini")
    settings.frame_ms = 0.0
    scene = load(mesh)
    window = make_window(Document(mesh, scene.start), scene=scene, settings=settings)
    settle()
    assert not any(is_made(scene, share) for share in SHARES), "nobody asked for it"

    told: list[str] = []

    def cancel() -> None:
        dialog = QApplication.activeModalWidget()
        if isinstance(dialog, QProgressDialog):
            told.append(dialog.labelText())
            dialog.cancel()
        else:
            QTimer.singleShot(0, cancel)

    QTimer.singleShot(0, cancel)
    window.look.adaptive.set_target(33.0)
    qtbot.waitUntil(lambda: bool(told))
    settle()
    assert told == ["Making coarser versions of the scene"]
    assert not is_made(scene, 0.005)
    window.look.adaptive.set_target(33.0)
    qtbot.waitUntil(lambda: is_made(scene, 0.005))
    assert all(is_made(scene, share) for share in shares_for_dragging(scene))
    assert scene.surface.n_cells > adaptive.MANY_TRIANGLES


@pytest.mark.undrawn
def test_the_target_is_a_setting(
    window: MainWindow, own_home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert window.settings.frame_ms == 33.0 == window.look.adaptive.budget.target_ms
    asked: list[str] = []

    def answer(dialog: NumberDialog) -> int:
        asked.append(dialog.field.text())
        dialog.field.setText("16")
        dialog.accept()
        return dialog.result()

    monkeypatch.setattr(NumberDialog, "exec", answer)
    window.status.precision.menu().aboutToShow.emit()
    (action,) = [
        a for a in window.status.precision.menu().actions() if a.text().startswith("Frames")
    ]
    assert action.text() == "Frames of at most 33 ms while dragging…"
    action.trigger()
    assert asked == ["33"]
    assert window.settings.frame_ms == 16.0 == window.look.adaptive.budget.target_ms
    window.status.precision.menu().aboutToShow.emit()
    texts = [action.text() for action in window.status.precision.menu().actions()]
    assert "Frames of at most 16 ms while dragging…" in texts
    for bad in ("-1", "nan", "1e9", "soon"):
        settings = Settings(None)
        settings.override("frame", bad)
        assert settings.frame_ms == 33.0
