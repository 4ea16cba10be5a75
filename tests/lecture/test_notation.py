"""Formulas agree with their numbers, numbers with the command's; and copying works."""

import json
import math
import re
from dataclasses import replace
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest

from app.lecture import copying
from app.lecture.letters import LETTERS, Letters, written
from app.lecture.notation import WrittenMatrix, matrices
from app.model.chain import FiveTiles
from app.model.formula import ARROW, parse
from app.model.lenses.perspective import focal_length_e, fov_x_from_fov_y
from app.model.projection import (
    DEPTH_RANGES,
    Camera,
    FreeMatrix,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.refusal import format_value
from tests.support.commands import told_matrices
from tests.support.lenses import LENSES
from tests.support.samples import pairwise

BOX = (-3.0, 4.5, -2.0, 3.25)
DEPTHS: tuple[Any, ...] = ("opengl", "direct3d", "reversed")
SAMPLE = pairwise(product(LENSES, DEPTHS, LETTERS, (False, True)))
"""Every pair of lens, depth range, letters, and columns or rows."""
CAMERA = Camera((6.0, 5.0, 9.0), (0.5, 2.0, -0.25), (0.1, 1.0, 0.2))


def projection_of(lens: str, depth: Any = "opengl") -> Projection:
    return Projection(CAMERA, LENSES[lens], (1280, 720), depth)


def letter_values(projection: Projection, letters: Letters = "own") -> dict[str, Any]:
    """The values of the names in the formulas: floats, vectors, ``cot``, ``tan`` and ``dot``.

    A free matrix has its cells. Angles are in radians. With ``"002"``, n and f are negative.
    """
    lens, camera = projection.lens, projection.camera
    width, height = projection.image_size
    values: dict[str, Any] = {
        "W": width, "H": height, "aspect": projection.aspect, "a": height / width,
        "eye": camera.eye,
        "cot": lambda angle: math.tan(math.pi / 2.0 - angle), "tan": math.tan,
        "dot": lambda a, b: math.sumprod(a, b) if hasattr(math, "sumprod")
        else math.fsum(x * y for x, y in zip(a, b, strict=True)),
    }  # fmt: skip
    for axis, row in zip("uvn", camera.frame.tolist(), strict=True):
        values[f"axis_{axis}"] = row
        values |= {f"{axis}_{part}": value for part, value in zip("xyz", row, strict=True)}
    values |= {f"eye_{part}": value for part, value in zip("xyz", camera.eye, strict=True)}
    if isinstance(lens, FreeMatrix):
        for letter, cells in (("p", lens.clip_from_view), ("m", lens.view_from_world or ())):
            for i, row in enumerate(cells, 1):
                values |= {f"{letter}_{i}{j}": value for j, value in enumerate(row, 1)}
        return values
    left, right, bottom, top = projection.window
    sign = -1.0 if letters == "002" else 1.0
    values |= {
        "n": sign * lens.near, "f": sign * lens.far, "l": left, "r": right, "b": bottom, "t": top,
    }  # fmt: skip
    values |= {letter: getattr(lens, names[0]) for letter, names in lens.table.fields.items()}
    if lens.fov_y_deg is not None:
        values["fov"] = values["theta_v"] = math.radians(lens.fov_y_deg)
        values["theta_h"] = math.radians(fov_x_from_fov_y(lens.fov_y_deg, projection.aspect))
        values["e"] = focal_length_e(lens.fov_y_deg, projection.aspect)
    if isinstance(lens, Oblique):
        values["alpha"], values["beta"] = math.radians(lens.alpha_deg), math.radians(lens.beta_deg)
    return values


def evaluated(matrix: WrittenMatrix, values: dict[str, Any]) -> list[list[float]]:
    return [[eval(cell, {"__builtins__": {}}, values) for cell in row] for row in matrix.formulas]


@pytest.mark.parametrize("letters", LETTERS)
@pytest.mark.parametrize("lens", LENSES)
def test_a_letter_stands_for_one_thing(lens: str, letters: Letters) -> None:
    """No letter is w, which is the divisor, and the axis in lecture 001's letters."""
    shown = matrices(projection_of(lens), letters, running=True)
    parts = [part for matrix in shown for part in (matrix, *matrix.factors)]
    names = {
        name for part in parts for row in part.formulas for cell in row
        for name in parse(cell).letters
    }  # fmt: skip
    texts = {name: written(name, letters) for name in names}
    assert len(set(texts.values())) == len(names) > 10
    assert "w" not in texts.values() and {texts["W"], texts["H"]} == {"W", "H"}


def expected_count(lens: Lens, letters: Letters) -> int:
    """The number of matrices with their running products."""
    if letters in ("000", "003"):  # one for the lens; lecture 003 also has the object's
        return 5 + (letters == "003")
    if letters == "002":
        return 6 + 3 * isinstance(lens, Frustum | Oblique)
    if lens.parallel:  # two steps are identities
        return 12 if letters == "own" else 9
    return 12 if letters != "own" else 13


@pytest.mark.parametrize(("lens", "depth", "letters", "rows"), SAMPLE)
def test_every_formula_is_its_number(lens: str, depth: str, letters: Letters, rows: bool) -> None:
    projection = projection_of(lens, depth)
    shown = matrices(projection, letters, rows=rows, running=True)
    values = letter_values(projection, letters)
    for i, row in enumerate(one(shown, "clip_from_view").values, 1):
        values |= {f"p_{i}{j}": value for j, value in enumerate(row, 1)}
    assert len(shown) == expected_count(projection.lens, letters)
    for matrix in shown:
        for part in (matrix, *matrix.factors):
            size = max(1.0, np.abs(part.values).max())
            assert np.allclose(evaluated(part, values), part.values, rtol=1e-12, atol=1e-14 * size)


@pytest.mark.parametrize(("lens", "depth", "letters", "rows"), SAMPLE)
def test_products_are_products(lens: str, depth: str, letters: Letters, rows: bool) -> None:
    shown = matrices(projection_of(lens, depth), letters, rows=rows, running=True)
    by_name = {matrix.name: np.array(matrix.values) for matrix in shown}
    assert len(by_name) == len(shown), "none is there twice"
    checked = 0
    for matrix in shown:
        parts = [by_name[name] for name in matrix.product] or [
            np.array(factor.values) for factor in matrix.factors
        ]
        if parts:
            multiplied = np.linalg.multi_dot(parts)
            assert np.allclose(multiplied, matrix.values, rtol=1e-12, atol=1e-12)
            checked += 1
    # The view, the viewport and the whole; ours also have M_z and the running products.
    assert checked >= (3 if letters in ("000", "002", "003") else 6)
    inverse = by_name["world_from_view"] @ by_name["view_from_world"]
    assert np.allclose(inverse, np.eye(4), rtol=0.0, atol=1e-14)


@pytest.mark.parametrize("lens", LENSES)
@pytest.mark.parametrize("depth", DEPTHS)
def test_numbers_are_the_commands(lens: str, depth: str) -> None:
    projection = projection_of(lens, depth)
    told = json.loads(told_matrices(projection, "json"))
    text = told_matrices(projection, "text")
    shown = matrices(projection)
    assert list(told) == [matrix.name for matrix in shown]
    for matrix in shown:
        assert list(map(list, matrix.values)) == told[matrix.name]
        for factor in matrix.factors:
            for row in factor.values:
                assert all(format_value(value) in text for value in row)
        words = text.split()
        assert all(format_value(value) in words for row in matrix.values for value in row)


def test_running_products_are_shown_on_request() -> None:
    extra = {"canonical_perspective_from_world", "canonical_parallel_from_world"}
    for running in (False, True):
        shown = matrices(projection_of("frustum"), running=running)
        assert (extra <= {matrix.name for matrix in shown}) is running


def test_the_letters_of_each_lecture() -> None:
    def lens_cell(letters: Letters, lens: str, row: int, column: int) -> str:
        matrix = one(matrices(projection_of(lens), letters), "clip_from_view")
        return written(matrix.formulas[row][column], letters)

    thin = "\u2009"
    assert lens_cell("own", "perspective", 0, 0) == "cot(fov/2)/aspect"
    assert lens_cell("own", "frustum", 0, 0) == "2n/(r − l)"
    assert lens_cell("own", "frustum", 2, 2) == "−(f + n)/(f − n)"
    assert lens_cell("000", "frustum", 0, 2) == "(x_max + x_min)/(x_max − x_min)"
    assert lens_cell("003", "perspective", 1, 1) == "e/a"
    # Lecture 002, P_persp and P_ort.
    assert lens_cell("002", "frustum", 0, 0) == "2z_n/(x_r − x_l)"
    assert lens_cell("002", "frustum", 2, 2) == "−(z_f + z_n)/(z_f − z_n)"
    assert lens_cell("002", "frustum", 2, 3) == f"2z_n{thin}z_f/(z_f − z_n)"
    assert lens_cell("002", "frustum", 3, 2) == "1"
    assert lens_cell("002", "orthographic", 2, 2) == "2/(z_n − z_f)"
    assert lens_cell("002", "orthographic", 2, 3) == "−(z_n + z_f)/(z_n − z_f)"
    view = one(matrices(projection_of("frustum"), "001"), "view_from_world")
    assert [written(cell, "001") for cell in view.formulas[2]] == [
        "w_x", "w_y", "w_z", f"−w{ARROW}·P{ARROW}",
    ]  # fmt: skip
    # Lecture 001's M_persp, first factor.
    m_persp = one(matrices(projection_of("perspective"), "001"), "canonical_perspective_from_view")
    assert written(m_persp.formulas[0][0], "001") == f"1/(f{thin}tan(θ_h/2))"


def one(shown: tuple[WrittenMatrix, ...], name: str) -> WrittenMatrix:
    (matrix,) = (matrix for matrix in shown if matrix.name == name)
    return matrix


CALLED: dict[tuple[Letters, str], list[str]] = {
    ("000", "frustum"): ["", "P", "", ""],
    ("001", "perspective"): [
        "", "M_persp", "M_pp", "M_z", "f I", "f M_z M_pp M_persp", "", "",
    ],
    ("001", "infinite"): ["", "M_persp", "M_pp", "M_z", "n I", "n M_z M_pp M_persp", "", ""],
    ("001", "orthographic"): ["", "", "M_z", "", "", ""],
    ("002", "perspective"): ["M", "V", "P_persp", "P_persp V", ""],
    ("002", "frustum"): ["M", "V", "H", "P_persp", "P_persp H", "P_persp H V", ""],
    ("002", "orthographic"): ["M", "V", "P_ort", "P_ort V", ""],
    ("002", "oblique"): ["M", "V", "H", "P_ort", "P_obl = P_ort H", "P_ort H V", ""],
    ("003", "frustum"): ["M_O→W", "M_W→E", "M_projection", "M_projection M_W→E", ""],
    ("004", "orthographic"): ["R P", "", "", "", "", ""],
}  # fmt: skip


@pytest.mark.parametrize(("letters", "lens"), CALLED)
def test_l9_a_lectures_chain_has_its_own_names_and_no_identity_between(
    letters: Letters, lens: str
) -> None:
    shown = matrices(projection_of(lens), letters)
    assert [matrix.called for matrix in shown] == CALLED[letters, lens]
    identities = [m.name for m in shown if np.array_equal(m.values, np.eye(4))]
    assert identities == (["world_from_object"] if letters in ("002", "003") else [])


def test_l11_p_obl_is_p_ort_after_h() -> None:
    """Lecture 002: x' = x - (z_n - z) cot alpha, then its box to the cube, near at z' = 1."""
    projection = projection_of("oblique")
    (left, right, bottom, top), lens = projection.window, projection.lens
    z_n, z_f, (cot_a, cot_b) = -lens.near, -lens.far, lens.shear
    h = [[1, 0, cot_a, -z_n * cot_a], [0, 1, cot_b, -z_n * cot_b], [0, 0, 1, 0], [0, 0, 0, 1]]
    p_ort = [
        [2 / (right - left), 0, 0, -(right + left) / (right - left)],
        [0, 2 / (top - bottom), 0, -(top + bottom) / (top - bottom)],
        [0, 0, 2 / (z_n - z_f), -(z_n + z_f) / (z_n - z_f)],
        [0, 0, 0, 1],
    ]
    shown = matrices(projection, "002")
    for name, expected in (
        ("sheared_from_view", h), ("clip_from_sheared", p_ort),
        ("clip_from_view", np.matmul(p_ort, h)),
    ):  # fmt: skip
        assert np.allclose(one(shown, name).values, expected, rtol=1e-14, atol=1e-15)
    texts = [written(cell, "002") for cell in one(shown, "sheared_from_view").formulas[0]]
    assert texts == ["1", "0", "cot(\u03b1)", "−z_n\u2009cot(\u03b1)"]
    assert copying.as_latex(one(shown, "clip_from_view"), "002").startswith(
        "\\[\n" r"P_{\mathrm{obl}} = P_{\mathrm{ort}} H = \begin{pmatrix}"
    )
    assert copying.as_text(one(shown, "sheared_from_view"), "002").startswith(
        "sheared_from_view = H\n"
    )


def test_l6_off_the_axis_is_h_before_a_window_about_it() -> None:
    """Lecture 002: H moves the window's middle to the axis; P_persp has no third term."""
    shown = matrices(projection_of("frustum"), "002")
    p_persp, h = (one(shown, name) for name in ("clip_from_sheared", "sheared_from_view"))
    lens = LENSES["frustum"]
    left, right, bottom, top = lens.window(Fraction(1))
    middle = np.array([(left + right) / 2.0, (bottom + top) / 2.0, -lens.near, 1.0])
    assert np.allclose(h.values @ middle, [0.0, 0.0, -lens.near, 1.0], rtol=0.0, atol=1e-15)
    x, y, _, w = p_persp.formulas
    assert [written(cell, "002") for cell in x] == ["2z_n/(x_r − x_l)", "0", "0", "0"]
    assert [written(cell, "002") for cell in y] == ["0", "2z_n/(y_t − y_b)", "0", "0"]
    assert w == ("0", "0", "1", "0")


def test_l2_the_three_matrices_of_lecture_003() -> None:
    projection = replace(
        projection_of("frustum"), placement=FiveTiles((1.0, 2.0, 3.0), (0.0, 90.0, 0.0)).chain
    )
    object_, view, lens, *_ = matrices(projection, "003")
    assert (object_.called, view.called, lens.called) == ("M_O→W", "M_W→E", "M_projection")
    point = np.array([0.5, 1.0, -2.0, 1.0])  # turned by 90 degrees about y: (z, y, -x)
    assert np.allclose(object_.values @ point, [-1.0, 3.0, 2.5, 1.0], rtol=0.0, atol=1e-15)
    clip = np.array(lens.values) @ np.array(view.values) @ object_.values @ point
    assert np.allclose(clip, projection.clip_from_world @ [-1.0, 3.0, 2.5, 1.0], atol=1e-13)
    latex = copying.as_latex(object_, "003")
    assert latex.startswith("\\[\n" r"M_{\mathrm{O\to W}} = ")


def test_lecture_002_maps_near_to_one_and_has_z_for_w() -> None:
    """z' = 1 at z = z_n and -1 at z = z_f, and w' = z."""
    shown = matrices(projection_of("perspective"), "002")
    matrix = np.array(one(shown, "clip_from_view").values)
    for z, expected in ((-1.0, 1.0), (-30.0, -1.0)):
        _, _, z_clip, w = matrix @ (0.0, 0.0, z, 1.0)
        assert w == z
        assert math.isclose(z_clip / w, expected, rel_tol=1e-14)


def test_row_vectors_turn_matrices_and_products() -> None:
    projection = projection_of("frustum", "reversed")
    columns, rows = matrices(projection), matrices(projection, rows=True)
    for column, row in zip(columns, rows, strict=True):
        assert np.array_equal(np.transpose(column.values), row.values)
        assert column.product == row.product[::-1]
        assert [f.name for f in column.factors] == [f.name for f in row.factors][::-1]
    point = np.array([1.0, 2.0, -3.0, 1.0])
    by_name = {matrix.name: np.array(matrix.values) for matrix in rows}
    there = point @ by_name["view_from_world"] @ by_name["clip_from_view"]
    assert np.allclose(there, projection.clip_from_world @ point, rtol=1e-13, atol=1e-13)


def test_a_cell_names_the_fields_it_depends_on() -> None:
    def fields(lens: str, name: str, row: int, column: int) -> set[str]:
        return set(one(matrices(projection_of(lens)), name).fields[row][column])

    assert fields("perspective", "clip_from_view", 0, 0) == {"fov_y_deg", "image"}
    assert fields("frustum", "clip_from_view", 0, 0) == {"near", "left", "right", "keep"}
    assert fields("frustum", "clip_from_view", 2, 2) == {"near", "far", "depth"}
    assert fields("frustum", "clip_from_view", 3, 2) == set()
    assert fields("frustum", "view_from_world", 2, 0) == {"eye", "target"}
    assert fields("frustum", "view_from_world", 0, 3) == {"eye", "target", "up"}
    assert fields("oblique", "clip_from_view", 1, 2) == {"beta_deg", "bottom", "top", "keep"}
    assert fields("frustum", "image_from_ndc", 0, 0) == {"image"}
    assert fields("frustum", "depth_range_from_canonical_parallel", 2, 3) == {"depth"}
    assert "near" in fields("frustum", "clip_from_world", 0, 0)


def moves(projection: Projection) -> dict[str, list[Projection]]:
    """The projections with one control moved, for each control."""
    camera, lens = projection.camera, projection.lens
    found: dict[str, list[Projection]] = {
        "depth": [projection.with_depth(d) for d in DEPTH_RANGES if d != projection.depth],
        "image": [replace(projection, image_size=size) for size in ((1300, 720), (1280, 700))],
    }
    for vector in ("eye", "target", "up"):
        parts = (
            part + step
            for part, step in zip(getattr(camera, vector), (0.3, 0.25, -0.4), strict=True)
        )
        moved = replace(camera, **{vector: tuple(parts)})
        found[vector] = [replace(projection, camera=moved)]
    for vector in ("translate", "rotate_deg", "scale"):
        five = projection.placement.five
        assert five is not None
        parts = tuple(part + 0.03 for part in getattr(five, vector))
        placement = replace(five, **{vector: parts}).chain
        found[vector] = [replace(projection, placement=placement)]
    if isinstance(lens, FreeMatrix):
        return found
    lenses: dict[str, list[Any]] = {"far": [math.inf] if not lens.parallel else []}
    for name in ("fov_y_deg", "near", "far", "left", "right", "bottom", "top", "alpha_deg",
                 "beta_deg"):  # fmt: skip
        value = getattr(lens, name, None)
        if value is not None:
            lenses.setdefault(name, []).append(25.0 if value == math.inf else value + 0.03)
    if hasattr(lens, "keep"):
        lenses["keep"] = [keep for keep in KEEPS if keep != lens.keep]
    for name, values in lenses.items():
        found[name] = [replace(projection, lens=replace(lens, **{name: v})) for v in values]
    return found


EVEN = (-0.75, 0.75, -0.5, 0.5)
CAMERAS = {
    "askew": CAMERA,
    "upright": Camera((6.0, 5.0, 9.0), (0.0, 2.0, 0.0), (0.0, 1.0, 0.0)),
    "at-the-origin": Camera((0.0, 0.0, 0.0), (0.0, 0.0, -5.0), (0.0, 1.0, 0.0)),
    "along-up": Camera((1.0, 0.0, 0.0), (2.0, 5.5, 0.25), (1.0, 0.0, 0.0)),
    "level": Camera((0.0, 2.0, 9.0), (0.0, 0.0, 0.0), (0.0, 0.0, -2.0)),
}
PLACED = {
    "opengl": FiveTiles().chain,
    "direct3d": FiveTiles((1.0, 0.0, 2.0), (0.0, 20.0, 0.0), (2.0, 1.0, 0.0)).chain,
    "reversed": FiveTiles((1.0, 0.0, 2.0), (10.0, 20.0, 30.0), (2.0, 1.0, 1.0), "rts").chain,
}
KEEPS: tuple[Any, ...] = ("stretch", "x", "y")
MOVED: dict[str, tuple[Lens, ...]] = {
    "perspective": (Perspective(50.0, 1.5, 40.0), Perspective(50.0, 1.5, math.inf)),
    "frustum": tuple(Frustum(-0.7, 0.9, -0.4, 0.65, 1.5, far, keep)
                     for far in (40.0, math.inf) for keep in KEEPS),
    "frustum-even": (Frustum(*EVEN, 1.5, 40.0, "y"),),
    "frustum-fits": (Frustum(-1.125, 0.875, -0.5, 0.625, 1.5, 40.0, "x"),),
    "orthographic": tuple(Orthographic(*BOX, 1.5, 40.0, keep) for keep in KEEPS),
    "orthographic-even": (Orthographic(*EVEN, 0.0, 40.0, "y"), Orthographic(*EVEN, -9.0, 0.0)),
    "oblique": tuple(Oblique(*BOX, 1.5, 40.0, keep, 60.0, 115.0) for keep in KEEPS),
    "oblique-even": (Oblique(*EVEN, 0.0, 40.0, "x", 90.0, 115.0),
                     Oblique(*EVEN, 1.5, 40.0, "stretch", 60.0, 90.0)),
    "free": (
        FreeMatrix(((2, 0, 0, 0), (0, 1.5, 0, 0.5), (0, 0.25, -1, -3), (0, 0, -1, 0))),
        FreeMatrix(((2, 0, 0, 0), (0, 1, 0, 0), (0, 0, -1, 0), (0, 0, 0, 1)),
                   ((1, 2, 0, 0), (0, 1, 0, 0), (0, 0, 1, -9), (0, 0.5, 0, 1))),
    ),
}  # fmt: skip


@pytest.mark.parametrize(
    ("lens", "camera"),
    [*((lens, "askew") for lens in MOVED),
     *(("frustum-even", camera) for camera in CAMERAS if camera != "askew"),
     ("free", "upright")],
)  # fmt: skip
def test_a_cell_names_exactly_the_controls_that_change_it(lens: str, camera: str) -> None:
    """Compare with moving each control; a zero factor hides the other factors."""
    checked = 0
    for chosen, depth in product(MOVED[lens], DEPTHS):
        # The depth range does not affect proportions and cameras.
        as_ever = camera == "askew" and getattr(chosen, "keep", "stretch") == "stretch"
        if not as_ever and depth != "reversed":
            continue
        projection = Projection(CAMERAS[camera], chosen, (1280, 720), depth, PLACED[depth])
        letters: Letters = {"opengl": "002", "direct3d": "003", "reversed": "own"}[depth]
        running = depth == "reversed"
        moved = {
            name: [
                {part.name: part for part in matrices(other, letters, running=running)}
                for other in others
            ]
            for name, others in moves(projection).items()
        }
        for matrix in matrices(projection, letters, running=running):
            for number, part in enumerate((matrix, *matrix.factors)):
                names = {
                    name: np.any([
                        np.not_equal((o[matrix.name], *o[matrix.name].factors)[number].values,
                                     part.values) for o in others
                    ], axis=0) for name, others in moved.items()
                }  # fmt: skip
                for i, j in product(range(4), repeat=2):
                    changing = {name for name, changed in names.items() if changed[i, j]}
                    assert changing == set(part.fields[i][j]), (
                        chosen, depth, matrix.name, part.name, i, j, part.formulas[i][j]
                    )  # fmt: skip
                    checked += 1
    assert checked >= 100


def test_copies() -> None:
    projection = projection_of("frustum")
    matrix = one(matrices(projection), "clip_from_view")
    numbers: dict[str, Any] = {"np": np}
    exec(copying.as_numpy(matrix), numbers)
    assert np.array_equal(numbers["clip_from_view"], matrix.values)
    lines = copying.as_text(matrix).splitlines()
    assert lines[0].startswith("clip_from_view = clip_from_depth_range depth_range_from")
    assert [[float(word) for word in line.split()] for line in lines[1:]] == [
        list(row) for row in matrix.values
    ]
    shown = copying.as_text(matrix, "own", formulas=True).splitlines()
    assert shown[0] == lines[0]
    assert re.split("  +", shown[1]) == ["", "2n/(r − l)", "0", "(r + l)/(r − l)", "0"]
    latex = copying.as_latex(matrix, "own", formulas=True)
    assert r"\frac{2n}{r - l} & 0 & \frac{r + l}{r - l} & 0 \\" in latex
    assert latex.startswith(
        "\\[\n" r"M_{\text{clip}\leftarrow\text{view}} = \begin{pmatrix}"
    ) and latex.endswith("\\end{pmatrix}\n\\]\n")
    assert r"z_{\mathrm{min}}" in copying.as_latex(matrix, "000", formulas=True)
    assert copying.latex_number(-1.5e-9) == r"-1.5 \cdot 10^{-9}"
    numbers_only = copying.as_latex(matrix, "own")
    assert format_value(matrix.values[2][2]) in numbers_only and "frac" not in numbers_only
