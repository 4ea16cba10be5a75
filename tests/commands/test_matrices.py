"""The command ``matrices``: other programs' conventions, planes, and matrices after ``--set``."""

import json
import re
from typing import Any

import numpy as np
import pytest

from app.commands import options
from app.document.document import Document
from app.document.settings import set_values
from app.languages import sentences
from app.lecture.conventions import CONVENTIONS, in_convention, world_planes
from app.lecture.letters import LETTERS, Letters
from app.lecture.notation import clip_signs
from app.model.projection import kinds
from app.scenes.scene import load
from tests.lecture.test_printed_products import tex_values
from tests.support.commands import one_sentence, run_here
from tests.support.printed import sides

START = load("letter-f").start
NUMPY = "[[1.8,0,0,0],[0,2.4,0,0],[0,0,-1.002,-0.2002],[0,0,-1,0]]"


def test_the_options_are_those_of_the_table() -> None:
    assert [*CONVENTIONS] == options.choices("matrices", "--convention")
    assert {f"in-{name}" for name in CONVENTIONS} <= sentences().keys()


@pytest.mark.parametrize("name", CONVENTIONS)
@pytest.mark.parametrize("vectors", [None, "rows", "columns"])
def test_camera_and_lens_are_printed_as_another_program_writes_them(
    name: str, vectors: str | None
) -> None:
    rows = vectors == "rows" or (vectors is None and name == "direct3d")
    wanted = in_convention(START, name, rows=rows)
    asked = ["--convention", name, *(["--vectors", vectors] if vectors else [])]
    found = json.loads(run_here("matrices", *asked, "--format=json").stdout)
    assert found == {name: (matrix + 0.0).tolist() for name, matrix in wanted.items()}
    first, *blocks = run_here("matrices", *asked).stdout.split("\n\n")
    assert first.startswith(f"{name}: ")
    assert first.endswith("row vectors, p M" if rows else "column vectors, M p")
    for block, (title, matrix) in zip(blocks, wanted.items(), strict=True):
        lines = block.splitlines()
        assert lines[0] == title
        assert (
            np.array([list(map(float, line.split())) for line in lines[1:]]).tolist()
            == (matrix + 0.0).tolist()
        )


def test_the_planes_are_printed_with_their_names() -> None:
    found = json.loads(
        run_here("matrices", "--planes", "--format=json", "--set=lens.far=inf").stdout
    )
    assert list(found) == ["near", "far", "left", "right", "bottom", "top"]
    assert found["far"] is None
    first, *lines = run_here("matrices", "--planes").stdout.splitlines()
    assert "a x + b y + c z + d >= 0" in first
    assert {line.split()[0]: list(map(float, line.split()[1:])) for line in lines} == world_planes(
        START
    )
    assert "far     at infinity\n" in run_here("matrices", "--planes", "--set=lens.far=inf").stdout


@pytest.mark.parametrize(
    "arguments",
    [
        ["--vectors=rows"], ["--planes", "--convention=unity"], ["--planes", "--format=latex"],
        ["--convention=unity", "--format=latex"], ["--convention=directx"],
        ["--convention=opencv", "--set=lens.kind=orthographic"],
    ],
)  # fmt: skip
def test_what_cannot_be_printed_is_refused(arguments: list[str]) -> None:
    one_sentence(run_here("matrices", *arguments), 2)


@pytest.mark.parametrize("text", [NUMPY, f"np.array({NUMPY})", NUMPY.replace("],", "];\n")])
def test_a_matrix_is_set_as_its_text(text: str) -> None:
    done = run_here("matrices", "--set=lens.kind=matrix", f"--set=lens.clip_from_view={text}")
    assert (done.returncode, done.stderr) == (0, "")
    assert "-1.002  -0.2002" in done.stdout


def test_opencvs_lens_is_refused_by_the_name_that_is_set() -> None:
    done = run_here("matrices", "--convention=opencv", "--set=lens.kind=oblique")
    assert one_sentence(done, 2) == "lens.kind = 'oblique': must be one of perspective, frustum.\n"


def test_a_matrix_of_another_convention_is_described() -> None:
    text = NUMPY.replace("-1.002", "1.002").replace("-1,0", "1,0")
    done = run_here("matrices", "--set=lens.kind=matrix", f"--set=lens.clip_from_view={text}")
    said = "left-handed: looks along +z, y up; z from −1 at near to 1 at far; fov 45.24°, near 0.1"
    assert said in done.stdout
    view = "[0.955336 -0.29552 0 0; 0.29552 0.955336 0 0; 0 0 1 -3]"
    done = run_here("matrices", "--set=lens.kind=matrix", f"--set=lens.view_from_world={view}")
    assert "  (rows are orthonormal to 1e−06: rounded to 6 digits)\n" in done.stdout
    assert "  (the nearest camera would move the picture by at most 0.001" in done.stdout


@pytest.mark.parametrize(
    ("text", "bound"),
    [
        ("[[1,0],[0,1]]", "must be 9, 12 or 16 numbers, but has 4"),
        ("1 0 0 0 1 0 0 0 1", "must be four rows of four finite numbers"),
        (NUMPY.replace("2.4", "cos(1)"), "must be a matrix of numbers, but has cos(...)"),
    ],
)
def test_a_text_that_is_no_matrix_is_refused(text: str, bound: str) -> None:
    done = run_here("matrices", "--set=lens.kind=matrix", f"--set=lens.clip_from_view={text}")
    said = one_sentence(done, 2)
    assert "lens.clip_from_view = '" in said and said.rstrip(".\n").endswith(bound)


OBJECT = "object.chain=translate 3,0,0; rotate 1,2,2 40; off mirror x; shear xy 0.5; scale 2,1,1"


@pytest.mark.parametrize("lens", kinds())
def test_the_whole_chain_ends_in_the_picture_and_every_product_so_far_is_one_factor_more(
    lens: str,
) -> None:
    values = ["--set", OBJECT, "--set", f"lens.kind={lens}"]
    printed = json.loads(run_here("matrices", "--chain", "--format=json", *values).stdout)
    so_far, names = np.eye(4), [step["name"] for step in printed["steps"]]
    for step in printed["steps"]:
        so_far = so_far if step["matrix"] is None else np.array(step["matrix"]) @ so_far
        np.testing.assert_allclose(step["so_far"], so_far, rtol=1e-12, atol=1e-12)
    assert printed["product"] == names[::-1]
    assert names[:4] == ["scale 2,1,1", "shear xy 0.5", "rotate 1,2,2 40", "translate 3,0,0"]
    x, y, depth, w = so_far @ [0.3, 0.7, 0.2, 1.0]
    projection = set_values(Document("letter-f", load("letter-f").start), values[1::2]).projection
    seen = projection.trace((0.3, 0.7, 0.2), "object")
    np.testing.assert_allclose([x / w, y / w, depth / w], [*seen.image, seen.depth], rtol=1e-11)


@pytest.mark.parametrize("letters", LETTERS)
@pytest.mark.parametrize("lens", kinds())
def test_the_chain_in_latex_is_true_in_each_lectures_letters(lens: str, letters: Letters) -> None:
    """Its names, the factors in letters and in numbers, and the result."""
    values = ["--set", OBJECT, "--set", f"lens.kind={lens}", "--letters", letters]
    asked = ["--format=latex", "--symbols", "--numbers", "--digits=17", "--width=1500pt", *values]
    done = [run_here("matrices", *more, *asked) for more in ([], ["--chain"])]
    projection = set_values(Document("letter-f", load("letter-f").start), values[1:4:2]).projection
    known, named, printed = tex_values(projection, letters), dict[str, Any](), list[Any]()
    for tex in "".join(each.stdout for each in done).split("\\]"):
        (body,) = re.findall(r"\\\[(.*)", tex, re.DOTALL) or [""]
        body = re.sub(r"(?: \\\\)?\n&?\(p_\{ij\}\) &?=.*", "", body)
        printed = sides(re.sub(r"\\\w+\{aligned\}", "", body), known, named) if body else printed
    assert len(printed) == 5, "the name, the product of names, in letters, in numbers, the result"
    for part in printed:
        np.testing.assert_allclose(part, printed[-1], rtol=1e-11, atol=1e-12)
    of_lecture = {"000": "P", "002": "V", "003": r"M_{\mathrm{O\to W}}", "004": "R P"}
    assert of_lecture.get(letters, "M_{") in done[1].stdout.partition("pmatrix")[0]
    seen = np.array(printed[-1]) @ [0.3, 0.7, 0.2, 1.0]
    wanted = projection.trace((0.3, 0.7, 0.2), "object").clip
    np.testing.assert_allclose(seen, wanted * clip_signs(projection, letters), rtol=1e-11)


def test_the_chain_is_printed_with_its_products_so_far() -> None:
    text = run_here("matrices", "--chain", "--set", OBJECT).stdout
    assert "translate 3,0,0 | rotate 1,2,2 40 | shear xy 0.5 | scale 2,1,1\nthe rightmost" in text
    assert text.count("  so far\n") == 12 and "x, y and z divided by w" in text
    refused = run_here("matrices", "--chain", "--planes")
    assert refused.returncode and "stands alone" in refused.stderr
