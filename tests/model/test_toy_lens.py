"""A lens that the program does not have, in one file: drawn, read, exported, kept, in the dock.

`Shift` is the architect's lens: a one-point perspective whose film is raised, so that a tower is
seen to its top and its walls stay upright. Nothing outside this file knows it; a line of `LENSES`
is all that it takes.
"""

from __future__ import annotations

import json
import math
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest
from PySide6.QtWidgets import QComboBox

from app.arithmetic.double_double import cotangent_deg
from app.commands import cli
from app.document.codec import parse, to_json
from app.document.document import Document
from app.document.files import read
from app.document.view import PANES
from app.lecture import typed_matrix
from app.lecture.letters import LETTERS, written
from app.lecture.notation import letters_in, matrices
from app.model.lenses import LENSES
from app.model.lenses.answers import Window
from app.model.lenses.central import Central
from app.model.lenses.lens import LensTable, plane_letters
from app.model.lenses.perspective import (
    FOV_Y,
    SCALE,
    Perspective,
    fov_y_from_window,
    pyramid_tables,
)
from app.model.limits import Keep, between, finite, keep_checked
from app.model.parameter import Parameter
from app.model.projection import Frustum, Projection
from app.model.refusal import Refusal
from app.precision import levels as precision
from app.scenes.scene import load
from tests.support.controls import choice, enter, number
from tests.support.drawings import figure_of
from tests.support.shown import show
from widgets.controls.controls import Controls

TABLE, TABLE_AT_INFINITY = pyramid_tables(
    {
        "scale": SCALE,
        "rise": """
            1  0  0                0
            0  1  rise/cot(fov/2)  0
            0  0  1                0
            0  0  0                1
        """,
    },
    """
    cot(fov/2)/aspect  0           0     0
    0                  cot(fov/2)  rise  0
    0                  0           A     B
    0                  0           -1    0
    """,
    """
    aspect/cot(fov/2)  0             0  0
    0                  1/cot(fov/2)  0  rise/cot(fov/2)
    0                  0             0  -1
    0                  0             C  D
    """,
    {"rise": ("rise",)},
)


@dataclass(frozen=True)
class Shift(Central):
    """A symmetric lens whose window is raised by `rise` of its half-height."""

    kind: ClassVar[str] = "shift"
    tables: ClassVar[tuple[LensTable, ...]] = (TABLE, TABLE_AT_INFINITY)
    title: ClassVar[str] = "shift"
    tip: ClassVar[str] = "The film is raised: walls stay upright."
    parameters: ClassVar[tuple[Parameter, ...]] = (
        FOV_Y,
        Parameter(
            "rise", section="lens", place="more_lens", span=(-2.0, 2.0), step=0.1, unit="×",
            tip="By how much of its half-height the film is raised.",
        ),
    )  # fmt: skip

    fov_y_deg: float = 45.0
    rise: float = 0.5
    near: float = 1.0
    far: float = 30.0

    def __post_init__(self) -> None:
        near, far = self.checked_planes(self.near, self.far)
        fov_y_deg = between("fov_y_deg", self.fov_y_deg, 0, 180)
        keep_checked(self, fov_y_deg=fov_y_deg, rise=finite("rise", self.rise), near=near, far=far)

    def exact_letters(self, aspect: Fraction) -> dict[str, Fraction]:
        cot = cotangent_deg(Fraction(self.fov_y_deg) / 2)
        rise = Fraction(self.rise)
        return {
            **plane_letters(self.near, self.far),
            "cot(fov/2)": cot,
            "aspect": aspect,
            "rise": rise,
        }

    def letters(self, aspect: Fraction) -> dict[str, float]:
        cot = Perspective(self.fov_y_deg).cot_half_fov_y
        planes = {"n": self.near, "f": self.far}
        return {**planes, "cot(fov/2)": cot, "aspect": float(aspect), "rise": self.rise}

    def exact_window(self, aspect: Fraction) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        half = Fraction(self.near) / cotangent_deg(Fraction(self.fov_y_deg) / 2)
        rise = Fraction(self.rise)
        return -aspect * half, aspect * half, (rise - 1) * half, (rise + 1) * half

    @classmethod
    def with_window(cls, window: Window, near: float, far: float, keep: Keep) -> Shift:
        _, _, bottom, top = window
        fov_y_deg = fov_y_from_window((top - bottom) / 2.0, near)
        return cls(fov_y_deg, (top + bottom) / (top - bottom), near, far)


SHIFT = Shift(50.0, 0.4, 1.0, 40.0)
POINTS = np.array([[0.5, 1.0, 0.25], [-1.0, 3.0, 1.0], [0.0, 0.0, 0.0], [30.0, 2.0, 60.0]])


@pytest.fixture(autouse=True)
def _listed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(LENSES, "shift", Shift)


def same(projection: Projection) -> Projection:
    """The same picture with glFrustum."""
    lens = Frustum(*projection.window, projection.lens.near, projection.lens.far)
    return replace(projection, lens=lens)


@pytest.mark.parametrize("far", [40.0, math.inf])
@pytest.mark.parametrize("depth", ["opengl", "direct3d", "reversed"])
def test_it_projects(depth: Any, far: float) -> None:
    projection = Projection(lens=replace(SHIFT, far=far), depth=depth)
    other = same(projection)
    for mine, its in (
        (projection.clip_from_view, other.clip_from_view),
        (projection.view_from_clip, other.view_from_clip),
        (projection.world_from_clip_at((0.0, 0.0, 0.0)), other.world_from_clip_at((0.0, 0.0, 0.0))),
    ):
        assert np.allclose(mine, its, rtol=1e-13, atol=1e-13)
    for level in precision.PRECISIONS:
        mine, its = (precision.trace(p, POINTS, level) for p in (projection, other))
        assert np.allclose(
            mine.image, its.image, rtol=1e-3 if level == "float32" else 1e-12, equal_nan=True
        )
        assert (mine.outside == its.outside).all() and mine.in_front.any()
    pixels = np.column_stack([mine.image, mine.depth])[mine.in_front]
    back = projection.world_from_image(pixels)
    assert np.allclose(back, POINTS[mine.in_front], atol=1e-9)


def test_other_lenses_become_it_and_it_becomes_others() -> None:
    start = Projection(lens=Frustum(-0.8, 0.8, -0.2, 0.7, 1.0, 40.0), image_size=(1600, 900))
    shift = start.with_lens("shift")
    assert isinstance(shift.lens, Shift) and shift.lens.rise == pytest.approx(5 / 9)
    assert shift.window == pytest.approx(start.window)
    assert shift.with_lens("frustum").window == pytest.approx(start.window)
    assert shift.with_lens("orthographic").lens.kind == "orthographic"
    typed = shift.with_lens("matrix")
    assert np.allclose(typed.clip_from_view, shift.clip_from_view)
    assert typed.with_lens("shift") == shift
    cut = shift.between(2.0, 10.0)
    assert (cut.lens.near, cut.lens.far, cut.lens.kind) == (2.0, 10.0, "shift")
    assert cut.trace(POINTS).image == pytest.approx(shift.trace(POINTS).image, nan_ok=True)
    with pytest.raises(Refusal, match="near"):
        replace(SHIFT, near=50.0)


@pytest.mark.parametrize("letters", LETTERS)
def test_it_is_read(letters: Any) -> None:
    shown = {m.name: m for m in matrices(Projection(lens=SHIFT), letters, running=True)}
    clip = shown["clip_from_view"]
    assert written(clip.formulas[1][2], letters) == ("−rise" if letters == "002" else "rise")
    assert clip.fields[1][2] == ("rise",) and clip.fields[1][1] == ("fov_y_deg",)
    assert letters_in(clip, 1, 2) == frozenset({"rise"})
    if letters in ("000", "002", "003"):  # whose chains have no canonical volumes
        assert "canonical_perspective_from_view" not in shown
        return
    first = shown["canonical_perspective_from_view"]
    assert [factor.name for factor in first.factors] == ["scale", "rise"]
    assert first.values[1][2] == pytest.approx(0.4 / 40.0)


def test_it_is_documented() -> None:
    made = Document(projection=Projection(lens=SHIFT))
    text = to_json(made)
    assert '"kind": "shift", "fov_y_deg": 50, "rise": 0.4, "near": 1, "far": 40' in text
    assert parse(text) == made
    with pytest.raises(Refusal, match="rise"):
        parse(text.replace('"rise": 0.4, ', ""))
    typed = Document(projection=made.projection.with_lens("matrix"))
    assert parse(to_json(typed)) == typed


def test_its_matrix_is_recognised() -> None:
    """Typed over its own, and as the lens that a typed matrix goes back to."""
    here, there = Projection(lens=SHIFT), Projection(lens=replace(SHIFT, rise=0.7, far=math.inf))
    cells = typed_matrix.shown(there, "clip_from_view")
    found = typed_matrix.with_matrix(here, "clip_from_view", cells)
    assert isinstance(found.lens, Shift)
    assert found.lens.rise == pytest.approx(0.7, rel=1e-14)
    assert found.lens.fov_y_deg == pytest.approx(SHIFT.fov_y_deg, rel=1e-14)
    assert (found.lens.near, found.lens.far) == (1.0, math.inf)
    tilted = typed_matrix.with_cell(here, "clip_from_view", 0, 1, 0.25)
    assert tilted.lens.kind == "matrix"
    again = typed_matrix.with_cell(tilted, "clip_from_view", 0, 1, 0.0)
    assert again == here


def test_its_paths_can_be_set(capsys: pytest.CaptureFixture[str]) -> None:
    settings = ["lens.kind=shift", "lens.rise=0.3", "lens.near=2"]
    options = [word for setting in settings for word in ("--set", setting)]
    assert cli.main(["matrices", "--format", "json", *options]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["clip_from_view"][1][2] == 0.3
    assert cli.main(["matrices", "--set", "lens.rise=0.3"]) == 2
    error = "lens.rise belongs to another lens: set lens.kind as well (shift)."
    assert error in capsys.readouterr().err
    assert cli.main(["matrices", "--set", "lens.kind=shift", "--set", "lens.rise=high"]) == 2
    assert capsys.readouterr().err.startswith("lens.rise = 'high'")


def test_it_is_in_the_dock(display: Any, qtbot: Any) -> None:
    column, taken = Controls(), []
    qtbot.addWidget(column)
    column.resize(320, 900)
    column.set_scene(6.0, Projection())
    show(column, Projection())
    column.edited.connect(taken.append)
    column.show()
    qtbot.waitExposed(column)
    menu = choice(column, "kind").widgets[0]
    assert isinstance(menu, QComboBox)
    texts = [menu.itemText(i) for i in range(menu.count())]
    assert texts[-2:] == ["shift", "free matrix"]
    for section in column.sections.values():
        section.set_open(True)
    assert not number(column, "rise").isVisible()
    menu.activated.emit(len(texts) - 2)
    assert taken[-1].lens.kind == "shift"
    show(column, Projection(lens=SHIFT))
    for key, value in (("rise", 0.4), ("fov_y_deg", 50.0), ("near", 1.0), ("far", 40.0)):
        assert number(column, key).isVisible() and number(column, key).value() == value
    assert not number(column, "fov_x_deg").isVisible()  # whose window is no longer symmetric
    enter(number(column, "rise"), "0.7")
    assert taken[-1] == Projection(lens=replace(SHIFT, rise=0.7))


def test_the_commands_know_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, out = tmp_path / "shift.json", tmp_path / "shift.png"
    file.write_text(to_json(Document(projection=Projection(lens=SHIFT))), encoding="utf-8")
    assert cli.main(["export", str(out), str(file), "--panes=image", "--size=160x90"]) == 0
    assert read(out).projection.lens == SHIFT
    assert cli.main(["matrices", str(file), "--format", "json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["clip_from_view"][1][2] == 0.4
    points = tmp_path / "points.csv"
    points.write_text("0.5,1,0.25\n", encoding="utf-8")
    assert cli.main(["project", str(file), str(points), "--format", "json"]) == 0
    (point,) = json.loads(capsys.readouterr().out)["points"]
    assert point["image"] == pytest.approx(Projection(lens=SHIFT).trace(POINTS[0]).image.tolist())


def test_it_is_drawn() -> None:
    """All three panes, and the same picture as glFrustum's; without the rise it is another one."""
    projection = Projection(lens=SHIFT, image_size=(320, 180))
    flat = replace(projection, lens=replace(SHIFT, rise=0.0))
    scene = load("letter-f")
    pictures = [
        figure_of(scene, each, PANES, (480, 160)).pixels().astype(int)
        for each in (projection, same(projection), flat)
    ]
    apart = [np.abs(pictures[0] - picture).max(axis=-1) > 8 for picture in pictures[1:]]
    panes = [[pane.mean() for pane in np.split(part, 3, axis=1)] for part in apart]
    assert max(panes[0]) < 1e-3 and min(panes[1]) > 1e-2
