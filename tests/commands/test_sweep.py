"""Films: ``export --sweep``, ``--orbit``, ``--stages`` and ``--transition``."""

import math
import os
import shutil
import subprocess
import sys
import tempfile
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from app.commands.options import Parser
from app.commands.sweep import order, states, usual_loop, with_views
from app.document.document import Document
from app.document.files import read, write
from app.document.view import View
from app.drawings.figure import Figure
from app.model.projection import Camera
from app.scenes.scene import load
from tests.support.commands import one_sentence, refused, run_here

SMALL = ("--size=48x32", "--panes=image")
WORLD = ("--size=48x48", "--panes=world", "--set=view.layers=labels")
"""Without labels: a film places them on all of its frames together."""


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


def test_a_whole_number_is_swept_in_whole_steps() -> None:
    for frames, shown in (("24", range(1, 25)), ("4", (1, 9, 16, 24))):
        sweep = "--set=scene=jitter", "--sweep=settings.frame=1:24", f"--frames={frames}"
        found, _ = Parser("export").read(["a.gif", *sweep])
        assert [each.settings["frame"] for each in states(found, None)] == list(shown)


def test_steps_are_equal_or_in_equal_ratios_or_slow_at_both_ends() -> None:
    for ease, shown in {
        "linear": [1.0, 1.75, 2.5, 3.25, 4.0],
        "log": [1.0, math.sqrt(2.0), 2.0, math.sqrt(8.0), 4.0],
        "smooth": [2.5 - 1.5 * math.cos(math.pi * k / 4.0) for k in range(5)],
    }.items():
        sweep = "--sweep=lens.near=1:4", f"--ease={ease}", "--frames=5", "--loop=once"
        options, _ = Parser("export").read(["a.gif", *sweep])
        nears = [each.projection.lens.near for each in states(options, None)]
        assert nears == pytest.approx(shown, rel=1e-12), ease


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
    states = [read(tmp_path / f"{number}.png") for number in range(3)]
    views = [state.view.panes["world"] for state in states]
    turns = [view.orbit.azimuth_deg - views[0].orbit.azimuth_deg for view in views]
    # The step after the last one leads to the first.
    assert np.cos(np.radians(turns)) == pytest.approx(np.cos(np.radians([0, 120, 240])))
    assert {state.projection for state in states} == {Document().projection}
    assert len({(view.target, round(view.distance, 9)) for view in views}) == 1
    scene = load("letter-f")
    spots: list[Any] = []

    def seen(drawing: Any, factor: int) -> None:
        lens = drawing.spots_of(drawing.state.volume.corners + scene.origin)
        spots.append(lens / factor)

    for number, state in enumerate(states):
        pixels = Figure(state, scene, ["world"], (48, 48)).pixels(seen=seen)
        assert np.array_equal(pixels, frames_of(tmp_path / f"{number}.png")[0])
    assert 0.0 < np.min(spots) < np.max(spots) < 48.0, "all of the frustum is in the pane"
    assert np.min(spots) < 12.0 or np.max(spots) > 36.0, "and fills it"


def test_an_orbit_begins_with_the_view_of_the_document_and_comes_back(tmp_path: Path) -> None:
    view = Camera((9.0, 6.0, 2.0), (1.0, 2.0, 0.0))
    write(Document(view=View(fixed="side", panes={"world": view})), tmp_path / "turned.json")
    film = tmp_path / "film.apng"
    back = ("--orbit", "-60", "--frames=4")
    assert run_here("export", film, tmp_path / "turned.json", *back, *WORLD).returncode == 0
    frames = frames_of(film)
    assert np.array_equal(frames[1], frames[3]) and not np.array_equal(frames[0], frames[2])
    found, (out, file) = Parser("export").read(["a.gif", "b.json", *back, "--panes=world"])
    found.loop = usual_loop(found, numbered=False)
    assert (found.loop, out, file) == ("back-and-forth", "a.gif", "b.json")
    turned = str(tmp_path / "turned.json")
    figures = [Figure(state, load("letter-f"), ("world",)) for state in states(found, turned)]
    moments = with_views(found, turned, figures)
    first, middle, last = (each.document.view.panes["world"] for each in moments)
    assert first == view and middle.target == last.target == view.target
    assert last.orbit.azimuth_deg == pytest.approx(view.orbit.azimuth_deg - 60.0)
    assert middle.orbit.azimuth_deg == pytest.approx(view.orbit.azimuth_deg - 30.0)


def test_the_stages_rest_at_each_stop_and_come_back(tmp_path: Path) -> None:
    def positions(*options: str) -> list[float]:
        found, _ = Parser("export").read(["a.gif", "--stages", "--panes=ndc", *options])
        found.loop = found.loop or usual_loop(found, numbered=False)
        moments = states(found, None)
        return [moments[place].view.stage for place in order(found)]

    there_and_back = positions()
    assert len(there_and_back) == 120
    assert there_and_back[1:] == there_and_back[:0:-1], "the last step leads to the first"
    assert all(there_and_back.count(stop) >= 5 for stop in range(6))
    assert max(abs(a - b) for a, b in pairwise(there_and_back)) < 0.3
    assert positions("--loop=once", "--frames=6") == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]
    bare = ("--panes=ndc", "--size=48x48", "--set=view.layers=labels")
    stages = ("--stages", "--frames=6", *bare)
    assert run_here("export", tmp_path / "%d.png", *stages).returncode == 0
    alone = tmp_path / "alone.png"
    assert run_here("export", alone, "--set=view.stage=pyramid", *bare).returncode == 0
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


TALK = """\
---
title: Two steps
---
# One {#one}
```state
scene=letter-f
view.stage=view
```
```note
```
---
# Two {#two}
```state
lens.near=1
view.stage=ndc
```
---
# Three {#three}
---
# Four {#four}
```state
scene=cube
```
"""


def test_a_transition_leads_from_the_figure_of_a_step_to_that_of_the_next(tmp_path: Path) -> None:
    talk = tmp_path / "talk.md"
    talk.write_text(TALK, encoding="utf-8")
    way = ("--step=two", "--transition", "--frames=3", *WORLD)
    assert run_here("export", tmp_path / "%d.png", talk, *way).returncode == 0
    for number, step in ((0, "one"), (2, "2")):
        alone = tmp_path / "alone.png"
        assert run_here("export", alone, talk, "--step", step, *WORLD).returncode == 0
        (frame,), (figure,) = frames_of(tmp_path / f"{number}.png"), frames_of(alone)
        assert (frame == figure).all(axis=2).mean() > 0.98, "the view of the world is rounded"
    middle = read(tmp_path / "1.png")
    assert middle.projection.lens.near == pytest.approx(5.0**0.5)  # of 5 and 1, as in the window
    assert middle.view.stage == pytest.approx(2.5)
    assert set(middle.view.panes) == {"world"}, "which goes from one view to the other"
    for step, words in (
        ("1", "--transition: no step comes before --step 1."),
        ("four", "--transition: step 4 shows another scene or another kind of lens"),
        ("5", "--step = '5': must be a number from 1 to 4, or the name of a step"),
        ("tow", "or the name of a step; the nearest is two."),
    ):
        assert words in refused("export", "a.gif", talk, "--transition", "--step", step)
    same = one_sentence(run_here("export", "a.gif", talk, "--transition", "--step=3"), 2)
    assert same == "--transition: step 3 shows the same as the step before.\n"


def test_an_interrupted_film_leaves_the_old_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn: list[bool] = []

    def interrupted(*given: Any, **options: Any) -> Any:
        if drawn:
            raise KeyboardInterrupt
        drawn.append(True)
        return b""

    monkeypatch.setattr("app.drawings.moving.encoded", interrupted)
    film = tmp_path / "film.gif"
    film.write_bytes(b"old")
    assert run_here("export", film, "--sweep=lens.far=15:17", *SMALL).returncode == 130
    assert film.read_bytes() == b"old" and os.listdir(tmp_path) == ["film.gif"] and drawn


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="needs ffmpeg")
def test_an_mp4_has_the_frames_of_the_numbered_figures(tmp_path: Path) -> None:
    sweep = ("--sweep=lens.fov_y_deg=30:60", "--frames=4", "--size=64x48", "--panes=image")
    assert run_here("export", tmp_path / "%d.png", *sweep).returncode == 0
    film = tmp_path / "-film.mp4"
    done = run_here("export", *sweep, "--", film)
    assert (done.returncode, done.stderr) == (0, "")
    decode = ["ffmpeg", "-v", "error", "-i", str(film), "-vf", "scale=in_color_matrix=bt709"]
    found = subprocess.run(
        [*decode, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], capture_output=True, check=True
    )
    frames = np.frombuffer(found.stdout, np.uint8).reshape(-1, 48, 64, 3)
    true = [frames_of(tmp_path / f"{number}.png")[0] for number in range(4)]
    for frame, figure in zip(frames, true, strict=True):
        error = frame.astype(float) - figure
        assert 10.0 * np.log10(255.0**2 / (error**2).mean()) > 25.0, "half the colours"
        assert abs(error.mean()) < 1.5


@pytest.mark.skipif(sys.platform == "win32", reason="a script stands for ffmpeg")
def test_ffmpeg_gets_the_frames_of_the_numbered_figures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sweep = ("--sweep=lens.far=15:17", "--frames=3", *SMALL)
    assert run_here("export", tmp_path / "%d.png", *sweep).returncode == 0
    ffmpeg = tmp_path / "ffmpeg"
    ffmpeg.write_text(
        '#!/bin/sh\nfor film; do :; done\nexec /bin/cat > "$film"\n', encoding="utf-8"
    )
    ffmpeg.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert run_here("export", tmp_path / "film.mp4", *sweep).returncode == 0
    begin = b"\x89PNG\r\n"
    _, *frames = (tmp_path / "film.mp4").read_bytes().split(begin)
    for number, frame in enumerate(frames):
        (tmp_path / "frame.png").write_bytes(begin + frame)
        (pixels,), (figure,) = (frames_of(tmp_path / n) for n in ("frame.png", f"{number}.png"))
        assert np.array_equal(pixels, figure)
    assert len(frames) == 3


@pytest.mark.skipif(sys.platform == "win32", reason="a script stands for ffmpeg")
def test_an_mp4_that_cannot_be_encoded_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    film, ffmpeg, own = tmp_path / "film.mp4", tmp_path / "bin" / "ffmpeg", tmp_path / "own"
    ffmpeg.parent.mkdir()
    own.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(own))
    command = ("export", film, "--sweep=lens.far=15:17", "--frames=2", *SMALL)

    monkeypatch.setenv("PATH", str(ffmpeg.parent))
    words = "needs the program ffmpeg, which is not on the PATH: write .webp instead."
    assert refused(*command) == f"{film} {words}\n"

    ffmpeg.write_text(
        "#!/bin/sh\necho one >&2\necho Unknown encoder. >&2\nexit 1\n", encoding="utf-8"
    )
    ffmpeg.chmod(0o755)
    said = one_sentence(run_here(*command), 2)
    assert said == f"{film} cannot be written: ffmpeg says “Unknown encoder”.\n"

    pid = tmp_path / "pid"
    interrupted = "read first_line\nkill -INT $PPID\nexec /bin/sleep 60\n"
    ffmpeg.write_text(f"#!/bin/sh\necho $$ > {pid}\n{interrupted}", encoding="utf-8")
    assert run_here(*command).returncode == 130
    with pytest.raises(ProcessLookupError):
        os.kill(int(pid.read_text(encoding="utf-8")), 0)
    assert not os.listdir(own) and not film.exists()


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
        (["a.png", "--sweep=lens.near=1:2"], "must end in .gif, .apng, .webp or .mp4, or have"),
        (["a%d%d.png", "--sweep=lens.near=1:2"], "must end in .gif, .apng, .webp or .mp4, or have"),
        (["a.gif"], "for a film add --sweep, --orbit, --stages or"),
        (["a.png", "--frames=4"], "--frames: needs --sweep, --orbit, --stages or --transition."),
        (["a.gif", "--sweep=lens.near=1:2", "--batch=b"], "--sweep: cannot be used with --batch."),
        (["a.mp4", "--orbit", "--size=65x48", "--panes=world"], "even sides in pixels, not 65x48"),
        (["a.mp4", "--orbit", "--transparent"], "--transparent: .mp4 has no transparency"),
        (["a.gif", "--transition", "--step=2"], "--transition: needs a lesson or a talk as FILE"),
        (["a.png", "--step=2"], "--step: needs a lesson or a talk as FILE."),
        (["a.png", "L5", "--step=1", "--set=scene=cube"], "--set scene: the steps of a lesson"),
        (["a.gif", "--orbit", "--stages"], "--orbit: cannot be used with --stages."),
        (["--orbit", "400", "a.gif"], "--orbit = 400: must be from -360 to 360 degrees, not 0."),
        (["a.gif", "--orbit=0"], "--orbit = 0: must be from -360 to 360 degrees, not 0."),
        (["a.gif", "--orbit=nan"], "--orbit = nan: must be from -360"),
        (["a.gif", "--orbit=far"], "--orbit = 'far': must be a number of degrees."),
        (["a.gif", "--orbit", "--panes=ndc"], "--orbit: needs the pane world, and --panes = 'ndc'"),
        (["a.gif", "--stages", "--panes=image"], "--stages: needs the pane ndc"),
        (["a.html", "--stages", "--panes=world,image"], "--stages: needs the pane ndc"),
        (["a.gif", "--orbit", "--size=9x9"], "--size width = 9: must be"),
        (["a.gif", "--orbit", "--set=view.stage=9"], "view.stage"),
        (["a.gif", "--sweep=lens.near=1:2", "--frames=1"], "must be a whole number from 2 to 1000"),
        (["a.gif", "--sweep=lens.near=1:2", "--frames=4.5"], "--frames = '4.5': must be a whole"),
        (["a.gif", "--sweep=lens.near=1:2", "--fps=nan"], "--fps = nan: must be from 1 to 50."),
        (["a.gif", "--sweep=lens.near=1:2", "--sweep=lens.near=1:3"], "is swept already"),
        (["a.gif", "--sweep=camera.eye=1,2,3:1,2,-3", "--ease=log"], "no equal ratios from 3 to"),
        (["a.gif", "--orbit", "--show-value"], "--show-value: needs --sweep."),
        (["a.png", "--ease=log"], "--ease: needs --sweep."),
        (["a.gif", "--sweep=lens.near=1:2", "--frames=5", "--loop=back-and-forth"], "be even"),
        (["a.gif", "--sweep=lens.near=1:2", "--crop"], "--crop: is for single figures"),
        (["a.gif", "--sweep=lens.near=1:2", "--transparent"], "--transparent: .gif has no"),
        (["a.webp", "--sweep=image.width=8:9", "--panes=image", "--frames=2"], "set --size."),
        (["a.webp", "--sweep=lens.near=1:2", "--size=16384x9", "--panes=image"], "16383"),
    ],
)  # fmt: skip
def test_bad_sweep_is_refused_before_anything_is_drawn(arguments: list[str], words: str) -> None:
    assert words in refused("export", *arguments)
