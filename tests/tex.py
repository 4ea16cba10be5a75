"""Compile figures and matrices: ``python3 -m tests.tex [SCENE...]``, where pdfTeX is installed.

Every scene in three panes, every stage of its cube, hidden lines and a text that is no TeX; and the
matrices of every lens in every lecture's letters, whose lines must fit their text. A line for each
fault; the exit status is 1 if there is one.
"""

if __name__ == "__main__":  # before anything is imported that it installs
    from app import bootstrap

    bootstrap.start("tests", extras=("test",))

import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from app.document.document import Document
from app.document.lengths import Size
from app.document.settings import set_values
from app.drawings.figure import Figure
from app.lecture.letters import LETTERS
from app.lecture.notation import matrices
from app.lecture.paper import displayed
from app.lessons.course import scene_of
from app.model.refusal import counted
from app.scenes.scene import BUILT_IN, load
from tests.support.tools import ToolParser, one_of

STAGES = (0.0, 1.0, 2.0, 2.5, 3.0, 4.0)
PT_PER_MM = 72.27 / 25.4
LENSES: tuple[list[str], ...] = (
    [], ["lens.kind=orthographic"], ["lens.kind=oblique"], ["lens.kind=frustum"], ["lens.far=inf"],
    ["lens.near=1e-200"], ["camera.eye=1e50,2e50,3e49"], ["depth=reversed"],
    ["object.rotate_deg=10,20,30", "object.scale=1,2,3", "object.order=rts"],
)  # fmt: skip
CELLS = (False, True, 4), (True, False, 4), (True, True, 4)
WIDTHS_PT = 345.0, 239.0, 200.0


def compiled(folder: Path, body: str) -> tuple[str, str]:
    """Return what a document says while it is compiled, and the error that ended it."""
    head = r"\documentclass{article}\usepackage[T2A]{fontenc}\usepackage{amsmath,tikz}"
    (folder / "document.tex").write_text(
        f"{head}\\begin{{document}}\n{body}\n\\end{{document}}\n", encoding="utf-8"
    )
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "document.tex"]
    done = subprocess.run(command, cwd=folder, capture_output=True, check=False)
    said = done.stdout.decode(errors="replace")
    wrong = re.search(r"^!.*|^LaTeX Font Warning.*|^Missing character.*", said, re.MULTILINE)
    return said, wrong[0] if wrong else ""


def figures(scene: str) -> Iterator[tuple[str, Document, dict[str, Any]]]:
    document = Document(scene, load(scene).start)
    size = Size(120.0, 40.0, "mm")
    yield "panes", document, {"size": size, "text_pt": 6.5}
    yield "dashed", document, {"size": size, "hidden": "dashed", "palette": "print"}
    for stage in STAGES:
        turned = replace(document, view=replace(document.view, stage=stage))
        yield f"stage {stage:g}", turned, {"panes": ["ndc"], "size": Size(120.0, 40.0, "mm")}
    named = r"view.compare=Ближняя \input{a} 100%: lens.near=2|$\write18{a}$ _#&~^: lens.near=4"
    if scene == "letter-f":
        yield "names", set_values(document, [named]), {"panes": ["image"], "size": size}


def faults_of_figures(folder: Path, scene: str) -> Iterator[str]:
    for name, document, options in figures(scene):
        Figure(document, scene_of(document), **options).save(folder / "figure.tex")
        box = r"\setbox0\hbox{\input{figure}}\typeout{WIDE \the\wd0}\copy0"
        said, wrong = compiled(folder, box)
        wide = re.search(r"^WIDE ([\d.]+)pt", said, re.MULTILINE)
        if wrong or wide is None:
            yield f"{scene}, {name}: {wrong}"
        elif abs(float(wide[1]) / PT_PER_MM - 120.0) > 0.05:
            yield f"{scene}, {name}: is {wide[1]} points wide"


def faults_of_matrices(folder: Path, text_pt: float) -> Iterator[str]:
    start, equations = load("letter-f").start, list[str]()
    for values in LENSES:
        projection = set_values(Document("letter-f", start), values).projection
        for letters in LETTERS:
            for matrix in matrices(projection, letters):
                for asked in ((False, True, 1), (False, True, 17), *CELLS):
                    equations.append(displayed(matrix, letters, *asked, text_pt))
    measured = [
        re.sub(r"^\\\[\n", r"\\setbox0\\hbox{$\\displaystyle ", each, flags=re.MULTILINE)
        .replace("\n\\]", r"$}\typeout{WIDE \the\wd0}")
        for each in equations
    ]  # fmt: skip
    said, wrong = compiled(folder, "\n".join(measured))
    widths = [float(each) for each in re.findall(r"^WIDE ([\d.]+)pt", said, re.MULTILINE)]
    if wrong or len(widths) != len(equations):
        yield f"matrices: {wrong}"
    for width, equation in zip(widths, equations, strict=False):
        if width > text_pt and "% perhaps wider" not in equation:
            yield f"{width} points wide:\n{equation}"


def main(words: Sequence[str]) -> int:
    parser, count = ToolParser("tex", __doc__), 0
    parser.add_argument("scene", nargs="*", type=one_of(BUILT_IN, "scene"))
    options = parser.parse_args(words)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for faults in (
            *(faults_of_matrices(folder, width) for width in WIDTHS_PT),
            *(faults_of_figures(folder, scene) for scene in options.scene or BUILT_IN),
        ):
            for fault in faults:
                count += 1
                print(fault, flush=True)
    print(counted(count, "fault"))
    return 1 if count else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
