"""Moving pictures: ``export --sweep``."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from app.document.files import read
from app.drawings import figures
from tests.support.commands import refused, run_here

SMALL = ("--size=48x32", "--panes=image")


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
        (["a.gif"], "must end in .png, .svg, .pdf or .tex; for a film add --sweep."),
        (["a.png", "--frames=4"], "--frames: needs --sweep."),
        (["a.gif", "--sweep=lens.near=1:2", "--batch=b"], "--sweep: cannot be used with --batch."),
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
