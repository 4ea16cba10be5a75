"""Moving pictures: ``export --sweep``, ``--orbit`` and ``--stages``."""

from __future__ import annotations

import os
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from app.commands.options import parser_of
from app.commands.sweep import order, states, usual_loop
from app.document.document import Document
from app.document.files import read, write
from app.document.view import View
from app.drawings import figures
from app.model.projection import Camera
from app.scenes.scene import load
from tests.support.commands import refused, run_here

SMALL = ("--size=48x32", "--panes=image")
WORLD = ("--size=48x48", "--panes=world")


def frames_of(path: Path) -> list[np.ndarray]:
    with Image.open(path) as film:
        frames = []
        for number in range(getattr(film, "n_frames", 1)):
            film.seek(number)
            frames.append(np.asarray(film.convert("RGB")))
        return frames


def test_each_frame_is_the_figure_of_its_state(tmp_path: Path) -> None:
    sweep = ("--sweep=lens.fov_y_deg=30:60", "--frames=3", *SMALL)
    assert run_here("export", tmp_path / "%02d.png", *sweep).returncode == 0
    assert sorted(os.listdir(tmp_path)) == ["00.png", "01.png", "02.png"]
    figures_of = []
    for number, degrees in enumerate((30, 45, 60)):
        alone = tmp_path / "alone.png"
        assert run_here("export", alone, f"--set=lens.fov_y_deg={degrees}", *SMALL).returncode == 0
        assert alone.read_bytes() == (tmp_path / f"{number:02}.png").read_bytes()
        figures_of += frames_of(alone)
    for ending in ("gif", "apng", "webp"):
        film = tmp_path / f"film.{ending}"
        done = run_here("export", film, *sweep, "--loop=once", "--fps=20")
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
        with Image.open(film) as opened:
            assert opened.info.get("loop", 1) == 1
            opened.load()
            assert opened.info["duration"] == 50
        for found, true in zip(frames_of(film), figures_of, strict=True):
            error = np.abs(found.astype(int) - true)
            # A GIF has 256 colours.
            assert error.max() == 0 if ending != "gif" else error.mean() < 0.5


def test_a_film_goes_there_and_back_with_every_frame_even_if_two_are_equal(tmp_path: Path) -> None:
    back = ("--frames=4", "--loop=back-and-forth", *SMALL)
    for ending in ("gif", "apng", "webp"):
        film = tmp_path / f"film.{ending}"
        assert run_here("export", film, "--sweep=lens.far=15:15", *back).returncode == 0
        frames = frames_of(film)
        assert len(frames) == 4 and all(np.array_equal(frames[0], each) for each in frames)
    assert read(tmp_path / "film.apng").projection.lens.far == 15.0
    assert run_here("export", tmp_path / "%d.png", "--sweep=lens.far=15:17", *back).returncode == 0
    states = [read(tmp_path / f"{k}.png").projection.lens.far for k in range(4)]
    assert states == [15.0, 16.0, 17.0, 16.0]


def states_of(folder: Path, count: int) -> list[Document]:
    """The documents that numbered figures carry; one of them is drawn again from it."""
    states = [read(folder / f"{number}.png") for number in range(count)]
    drawn = folder / f"{count - 1}.png"
    assert run_here("export", folder / "again.png", drawn, *WORLD).returncode == 0
    assert (folder / "again.png").read_bytes() == drawn.read_bytes()
    return states


def test_an_orbit_goes_round_in_equal_steps_and_shows_all_of_the_world(tmp_path: Path) -> None:
    done = run_here("export", tmp_path / "%d.png", "--orbit", "--frames=3", *WORLD)
    assert (done.returncode, done.stderr) == (0, "")
    states = states_of(tmp_path, 3)
    views = [state.view.panes["world"] for state in states]
    turns = [view.orbit.azimuth_deg - views[0].orbit.azimuth_deg for view in views]
    # The step after the last one leads to the first.
    assert np.cos(np.radians(turns)) == pytest.approx(np.cos(np.radians([0, 120, 240])))
    assert {state.projection for state in states} == {Document().projection}
    assert len({(view.target, round(view.distance, 9)) for view in views}) == 1
    scene = load("letter-f")
    spots: list[Any] = []

    def seen(drawing: Any, factor: int) -> None:
        lens = drawing.spots_of(drawing.frustum.corners + scene.origin)
        spots.append(lens / factor)

    for state in states:
        figures.render(scene, state.projection, ["world"], (64, 64), view=state.view, seen=seen)
    assert 0.0 < np.min(spots) < np.max(spots) < 64.0, "all of the frustum is in the pane"
    assert np.min(spots) < 16.0 or np.max(spots) > 48.0, "and fills it"


def test_an_orbit_begins_with_the_view_of_the_document_and_comes_back(tmp_path: Path) -> None:
    view = Camera((9.0, 6.0, 2.0), (1.0, 2.0, 0.0))
    write(Document(view=View(fixed="side", panes={"world": view})), tmp_path / "turned.json")
    film = tmp_path / "film.apng"
    back = ("--orbit", "-60", "--frames=4")
    assert run_here("export", film, tmp_path / "turned.json", *back, *WORLD).returncode == 0
    frames = frames_of(film)
    assert np.array_equal(frames[1], frames[3]) and not np.array_equal(frames[0], frames[2])
    found, (out, file) = parser_of("export").read(["a.gif", "b.json", *back, "--panes=world"])
    found.loop = usual_loop(found, numbered=False)
    assert (found.loop, out, file) == ("back-and-forth", "a.gif", "b.json")
    moments = states(found, str(tmp_path / "turned.json"))
    first, middle, last = (each.view.panes["world"] for each in moments)
    assert first == view and middle.target == last.target == view.target
    assert last.orbit.azimuth_deg == pytest.approx(view.orbit.azimuth_deg - 60.0)
    assert middle.orbit.azimuth_deg == pytest.approx(view.orbit.azimuth_deg - 30.0)


def test_the_stages_rest_at_each_stop_and_come_back(tmp_path: Path) -> None:
    def positions(*options: str) -> list[float]:
        found, _ = parser_of("export").read(["a.gif", "--stages", *options])
        found.loop = found.loop or usual_loop(found, numbered=False)
        moments = states(found, None)
        return [moments[place].view.stage for place in order(found)]

    there_and_back = positions()
    assert len(there_and_back) == 120
    assert there_and_back[1:] == there_and_back[:0:-1], "the last step leads to the first"
    assert all(there_and_back.count(stop) >= 5 for stop in range(6))
    assert max(abs(a - b) for a, b in pairwise(there_and_back)) < 0.3
    assert positions("--loop=once", "--frames=6") == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]
    stages = ("--stages", "--frames=6", "--panes=ndc", "--size=48x48")
    assert run_here("export", tmp_path / "%d.png", *stages).returncode == 0
    alone = tmp_path / "alone.png"
    set_ = ("--set=view.stage=pyramid", "--panes=ndc", "--size=48x48")
    assert run_here("export", alone, *set_).returncode == 0
    assert alone.read_bytes() == (tmp_path / "2.png").read_bytes()


def test_the_world_stands_still_while_a_value_changes(tmp_path: Path) -> None:
    sweep = ("--sweep=camera.eye=6,5,9:-6,5,9", "--frames=3")
    assert run_here("export", tmp_path / "%d.png", *sweep, *WORLD).returncode == 0
    states = states_of(tmp_path, 3)
    assert states[0].view.panes["world"] == states[2].view.panes["world"]
    assert states[0].projection != states[2].projection
    # A view that moves with the camera is left as it is.
    side = ("--set=view.fixed=side", "--frames=2")
    assert run_here("export", tmp_path / "%d.png", sweep[0], *side, *WORLD).returncode == 0
    assert not read(tmp_path / "0.png").view.panes


def test_an_interrupted_film_leaves_the_old_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[bool] = []

    def interrupted(*given: Any, **options: Any) -> Any:
        if drawn:
            raise KeyboardInterrupt
        drawn.append(True)
        return np.zeros((32, 48, 3), np.uint8)

    monkeypatch.setattr(figures, "render", interrupted)
    film = tmp_path / "film.gif"
    film.write_bytes(b"old")
    assert run_here("export", film, "--sweep=lens.far=15:17", *SMALL).returncode == 130
    assert film.read_bytes() == b"old" and os.listdir(tmp_path) == ["film.gif"] and drawn


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["a.gif", "--sweep=lens.near=1:2000"], "lens.near = 43.53191489361702: must be less than"),
        (["a.gif", "--sweep=lens.neer=1:2"], "lens.neer is not known; the nearest name is"),
        (["a.gif", "--sweep=lens.near=1"], "must be NAME=FIRST:LAST with finite numbers"),
        (["a.gif", "--sweep=lens.near=1:inf"], "must be NAME=FIRST:LAST with finite numbers"),
        (["a.gif", "--sweep=camera.eye=1,2,3:4,5"], "must be NAME=FIRST:LAST"),
        (["a.gif", "--sweep=scene=1:2"], "There is no scene"),
        (["a.gif", "--sweep=settings.light=1,2,3:0,0,0", "--set=scene=planar-shadow"], "light"),
        (["a.png", "--sweep=lens.near=1:2"], "must end in .gif, .apng or .webp, or have one"),
        (["a%d%d.png", "--sweep=lens.near=1:2"], "must end in .gif, .apng or .webp, or have one"),
        (["a.gif"], "for a film add --sweep, --orbit or --stages."),
        (["a.png", "--frames=4"], "--frames: needs --sweep, --orbit or --stages."),
        (["a.gif", "--sweep=lens.near=1:2", "--batch=b"], "--sweep: cannot be used with --batch."),
        (["a.gif", "--orbit", "--stages"], "--orbit: cannot be used with --stages."),
        (["--orbit", "400", "a.gif"], "--orbit = 400: must be from -360 to 360 degrees, not 0."),
        (["a.gif", "--orbit=0"], "--orbit = 0: must be from -360 to 360 degrees, not 0."),
        (["a.gif", "--orbit=nan"], "--orbit = nan: must be from -360"),
        (["a.gif", "--orbit=far"], "--orbit = 'far': must be a number of degrees."),
        (["a.gif", "--orbit", "--panes=ndc"], "--orbit: needs the pane world, and --panes = 'ndc'"),
        (["a.gif", "--stages", "--panes=image"], "--stages: needs the pane ndc"),
        (["a.gif", "--orbit", "--size=9x9"], "--size width = 9: must be"),
        (["a.gif", "--orbit", "--set=view.stage=9"], "view.stage"),
        (["a.gif", "--sweep=lens.near=1:2", "--frames=1"], "must be a whole number from 2 to 1000"),
        (["a.gif", "--sweep=lens.near=1:2", "--frames=4.5"], "--frames = '4.5': must be a whole"),
        (["a.gif", "--sweep=lens.near=1:2", "--fps=nan"], "--fps = nan: must be from 1 to 50."),
        (["a.gif", "--sweep=lens.near=1:2", "--frames=5", "--loop=back-and-forth"], "be even"),
        (["a.gif", "--sweep=lens.near=1:2", "--crop"], "--crop: is for single figures"),
        (["a.gif", "--sweep=lens.near=1:2", "--transparent"], "--transparent: .gif has no"),
        (["a.webp", "--sweep=image.width=8:9", "--panes=image", "--frames=2"], "set --size."),
        (["a.webp", "--sweep=lens.near=1:2", "--size=16384x9", "--panes=image"], "16383"),
    ],
)  # fmt: skip
def test_bad_sweep_is_refused_before_anything_is_drawn(arguments: list[str], words: str) -> None:
    assert words in refused("export", *arguments)
