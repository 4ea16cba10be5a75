"""A file of one's own letters: what it changes, where it is used, and what is refused of it."""

import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from app.bootstrap import ROOT
from app.document.codec import parse, to_json
from app.document.document import Document
from app.document.files import read_letters
from app.lecture.copying import latex_called, latex_name
from app.lecture.equation import equation_of
from app.lecture.letters import (
    LETTERS,
    axis_letters,
    in_letters,
    latex_formula,
    lettering,
    written,
)
from app.lecture.notation import matrices, names_of, steps_of_a_point
from app.lecture.paper import displayed
from app.lessons.course import Course
from app.lessons.lesson import read as read_lesson
from app.lessons.writing import begin_talk
from app.model.formula import ARROW
from app.model.formula_text import GREEK
from app.model.projection import Oblique, Perspective, Projection
from app.model.refusal import Refusal
from tests.support.commands import refused, run_here

OWN = """# the letters of the book
base = "004"
[parameters]
near = "N"
far = 'F'
fov = "θ"  # the whole angle
translate = "d"
[vectors]
eye = "C"
n = "w"
target = "Q_1"
[matrices]
view_from_world = "V"
clip_from_view = "Pers"
clip_from_world = "MVP"
"""
NAME = re.compile(r"@|(?:\\mathrm\{\w+\}|[A-Za-z])(?:_\{(?:[^{}]|\{[^{}]*\})*\})?")
LAYOUT = re.compile(r"\\begin\{pmatrix\}.*?\\end\{pmatrix\}", re.DOTALL)
NOTHING = re.compile(
    r"&?\(p_\{ij\}\) &?= .*"
    r"|%.*|\\(?:begin|end)\{aligned\}|\\(?:footnotesize|small|qquad|quad)|\S+ &?= \\textstyle.*|&"
)
PLAIN = Projection(lens=Perspective(45.0, 4.0, 18.0))


def test_letters_are_those_of_the_file_and_else_of_its_lecture() -> None:
    assert written("2*n*f/(f - n)", OWN) == written("2*n*f/(f - n)", "004").replace(
        "n", "N"
    ).replace("f", "F")
    assert written("fov", OWN) == "θ" and written("move_x", OWN) == "d_x"
    assert written("dot(axis_n, eye)", OWN) == f"w{ARROW}·C{ARROW}"
    assert written("n_x*eye_x", OWN) == "w_x\u2009C_x"
    assert in_letters("{axis_n} and {axis_u} at {near_distance}", OWN) == "w and u at N"
    named = axis_letters(OWN)
    assert (named["eye"], named["target"], named["n"], named["up"]) == ("C", "Q_1", "w", "V")
    assert written("l", OWN) == "l", "that of lecture 004"


def test_matrices_have_their_names_in_chains() -> None:
    by_name = {each.name: each for each in matrices(PLAIN, OWN)}
    assert by_name["view_from_world"].called == "V = R P"
    assert by_name["clip_from_world"].called == "MVP"
    assert by_name["clip_from_world"].chain[-1] == "V"
    assert names_of(PLAIN, OWN)["clip_from_view"] == "Pers"
    assert steps_of_a_point(PLAIN, OWN)["clip"] == "Pers p_view"
    tex = displayed(by_name["clip_from_view"], OWN, symbols=True, numbers=False)
    assert r"\mathrm{Pers} &= M_{" in tex and r"\theta" in tex and "F - N" in tex
    equation = equation_of(PLAIN, OWN, "MVP")
    assert equation.result is not None and equation.result.name == r"\mathrm{MVP}"
    own = matrices(PLAIN, '[matrices]\nclip_from_view = "P"\n')
    assert next(each for each in own if each.name == "clip_from_view").called == "P"


def test_every_greek_letter_is_set_everywhere() -> None:
    for letter, name in GREEK.items():
        ours = name if name in ("alpha", "beta") else "W"
        own = f'[parameters]\n{ours.replace("W", "width")} = "{letter}"\n'
        assert latex_formula(ours, own).removeprefix("\\").removeprefix("var") == name


def test_a_lecture_keeps_its_quantities_and_signs() -> None:
    letters = 'base = "002"\n[parameters]\nnear = "N"\n'
    assert in_letters("{near_distance}", letters) == "\u2212N"
    of_file, of_lecture = (
        next(each for each in matrices(PLAIN, each) if each.name == "clip_from_view")
        for each in (letters, "002")
    )
    assert of_file.values == of_lecture.values and of_file.formulas == of_lecture.formulas
    theta = 'base = "001"\n[parameters]\nfov = "ω"\n'
    (matrix,) = (each for each in matrices(PLAIN, theta) if each.name == "clip_from_view")
    assert "ω" in written(matrix.formulas[1][1], theta)


@pytest.mark.parametrize("letters", (*LETTERS, OWN, '[matrices]\nimage_from_ndc = "W"\n'))
@pytest.mark.parametrize("lens", [Perspective(45.0, 4.0, 18.0), Oblique(alpha_deg=45.0)])
@pytest.mark.parametrize("text_pt", [345.0, 239.0])
def test_every_name_in_a_chain_is_defined(letters: str, lens: Any, text_pt: float) -> None:
    """A name is on the left of an equation, and so is p_ij."""
    defined, used = set[str](), set[str]()
    whole = matrices(Projection(lens=lens), letters)
    clip = next(each for each in whole if each.name == "clip_from_view")
    called = latex_called(clip.called.partition(" = ")[0]) or latex_name(clip.name)
    for matrix in whole:
        own = called if matrix.name == "clip_from_world" else ""
        tex = displayed(matrix, letters, symbols=True, text_pt=text_pt, clip=own)
        assert "tiny" not in tex and "scriptsize" not in tex and "perhaps" not in tex, tex
        assert "(p_{ij})" in tex or matrix.name != "clip_from_world" or "p_{" not in tex
        plain = NOTHING.sub("", LAYOUT.sub(" @ ", tex))
        left, *sides = [NAME.findall(side) for side in plain.split("=")]
        for first, second in pairwise([left, *sides]):  # R and P above their matrices
            if len(first) == len(second) and {*second} == {"@"}:
                defined |= {*first}
        defined |= {*left} if len(left) == 1 else set()
        used |= {name for side in [left, *sides] for name in side}
    assert used - {"@", "f", "I"} <= defined


def test_a_document_keeps_the_letters_and_a_talk_keeps_the_document(tmp_path: Path) -> None:
    document = Document("letter-f", PLAIN)
    document = parse(
        to_json(document).replace('"version"', '"view": {"letters": "003"}, "version"')
    )
    assert document.view.letters == "003"
    (tmp_path / "letters.toml").write_text(OWN, encoding="utf-8")
    own = read_letters(tmp_path / "letters.toml")
    assert own == OWN
    document = replace(document, view=replace(document.view, letters=own))
    assert parse(to_json(document)) == document and parse(to_json(document)).view.letters == own
    begin_talk(tmp_path / "talk.md", "Ours", document)
    course = Course(read_lesson(tmp_path / "talk.md"))
    assert course.shown(0).document.view.letters == own


def test_a_lesson_takes_a_file_beside_it_or_the_one_of_the_command(tmp_path: Path) -> None:
    (tmp_path / "letters.toml").write_text(OWN, encoding="utf-8")
    lesson = tmp_path / "lesson.md"
    lesson.write_text("---\ntitle: T\nletters: letters.toml\n---\n# A\nText.\n", encoding="utf-8")
    assert read_lesson(lesson).letters == OWN
    assert read_lesson(lesson, letters="001").letters == "001"
    lesson.write_text(
        "---\ntitle: T\nletters: ../letters.toml\n---\n# A\nText.\n", encoding="utf-8"
    )
    with pytest.raises(Refusal, match=r"line 3 = '\.\./letters.toml': must be one of own, 000"):
        read_lesson(lesson)
    lesson.write_text("---\ntitle: T\nletters: none.toml\n---\n# A\nText.\n", encoding="utf-8")
    with pytest.raises(Refusal, match=r"line 3 cannot be read: .*none\.toml does not exist"):
        read_lesson(lesson)


def test_commands_take_the_file(tmp_path: Path) -> None:
    path = tmp_path / "letters.toml"
    path.write_text(OWN, encoding="utf-8")
    done = run_here("matrices", "--format", "latex", "--symbols", "--letters", path)
    assert done.returncode == 0, done.stderr
    assert r"\mathrm{MVP} &= " in done.stdout and r"V &= R P" in done.stdout
    figure = tmp_path / "figure.svg"
    words = ("--panes", "world", "--set", "view.names=eye,target,n", "--letters", path)
    done = run_here("export", figure, *words)
    assert done.returncode == 0, done.stderr
    text = figure.read_text(encoding="utf-8")
    assert all(f">{letter}</tspan>" in text for letter in ("C", "Q", "w\u20d7"))
    equation = tmp_path / "equation.svg"
    words = ("--panes", "equation", "--set", "view.equation=frustum", "--letters", path)
    assert run_here("export", equation, *words).returncode == 0
    assert "MVP" in refused("matrices", "--letters", "MVP", "--format", "latex")


def test_lessons_are_checked_and_printed_with_the_file(qapp: Any, tmp_path: Path) -> None:
    """Its names are known there, and nowhere else."""
    letters, lesson, out = (tmp_path / name for name in ("letters.toml", "own.md", "tests"))
    letters.write_text(OWN, encoding="utf-8")
    lesson.write_text(
        "---\ntitle: Own\n---\n# One {#one}\n```state\nscene=letter-f\nview.equation=MVP\n```\n"
        "```exercise half\nvary d: 1..30\nHalf of {=2*d}?\nvalue: d\n```\n",
        encoding="utf-8",
    )
    check = "lesson", "check", lesson
    done = run_here(*check, "--letters", letters)
    assert (done.returncode, done.stderr) == (0, "") and ", 0 wrong" in done.stdout
    assert run_here(*check).returncode == 1
    test = "lesson", "print", "--topics", lesson, "--seeds", "1", "--out", out
    assert "MVP" in run_here(*test).stderr
    done = run_here(*test, "--letters", letters)
    assert (done.returncode, done.stderr) == (0, "") and [*out.iterdir()]
    assert "--letters: is an option of lesson check" in refused("lesson", "list", "--letters=001")


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ('[parameters]\nnear = "N$"', r"line 2: near = 'N\$': must be a Latin letter or word"),
        ('[parameters]\n\nfar = "N"\nnear = "N"', "line 3: far = 'N': is the letter of near"),
        ('[parameters]\nfar = "n"', "line 2: far = 'n': is the letter of near already"),
        ('[parameters]\nnear = ""', "line 2: near = '': must be a Latin"),
        ('[parameters]\nnear = "abcdefghijklm"', "of at most 12 characters"),
        ('[parameters]\nnera = "N"', "line 2 = 'nera': is not known; the nearest name is near"),
        ('[vectors]\n[vektors]\n', "line 2 = 'vektors': is not known; the nearest .* vectors"),
        ('base = "005"\n', "line 1: base = '005': must be one of own, 000"),
        ('base = "004"\n[matrices]\nclip_from_view = "P"', "view_from_world/translation already"),
        ('near = "N"\n', "line 1 = 'near': is not known; the nearest name is base"),
        ('[parameters]\nnear = "N"\nnear = "Q"', "line 3 = 'near': is given twice"),
        ("vectors = 3\n", r"line 1 = 'vectors = 3': must be \[SECTION\], or NAME = \"LETTER\""),
        ('[parameters]\nnear = 4', "line 2 = 'near = 4': must be"),
        ('\n[parameters\n', r"line 2 = '\[parameters': must be"),
        ("a = " + "[" * 5000, "line 1 = .*: must be"),
        ("\n" + " " * 5000 + "\0", "line 2 = .*: must be"),
        ("#" * 20_000 + "=", "must be one of own, .*, or a file of letters of at most 10000"),
        ("letters", "must be one of own, 000, 001"),
        ("", "must be one of own, 000, 001"),
        ('[matrices]\nimage_from_ndc = "\\write18{a}"', "line 2: image_from_ndc = .*: must"),
    ],
)  # fmt: skip
def test_a_bad_file_is_refused_in_a_sentence(tmp_path: Path, text: str, sentence: str) -> None:
    path = tmp_path / "letters.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Refusal) as caught:
        read_letters(path)
    said = str(caught.value)
    assert re.search(sentence, said) and said.startswith(str(path)), said
    assert len(said) < 400 and said.endswith(".") and said.isprintable()
    with pytest.raises(Refusal):
        lettering(text)


def test_the_file_of_the_docs_is_read() -> None:
    letters = lettering(read_letters(ROOT / "docs" / "letters.toml"))
    assert letters.base == "004" and letters.matrices["clip_from_world"] == "MVP"


def test_a_document_with_bad_letters_is_refused_with_its_path() -> None:
    text = to_json(Document("letter-f", PLAIN))
    bad = '"view": {"letters": "[parameters]\\nnear = \'3\'"}, "version"'
    with pytest.raises(Refusal, match=r"view\.letters, line 2: near = '3': must be a Latin letter"):
        parse(text.replace('"version"', bad))
