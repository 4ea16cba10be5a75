"""The command ``matrices``: every stage's matrix as text, JSON or LaTeX."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence

from app.commands.aligned import lengths, lens_line, plain, widths
from app.commands.arguments import document_of
from app.commands.options import parser_of, write_out
from app.lecture.notation import latex_name, latex_number
from app.lecture.typed_matrix import properties
from app.model.projection import Array, Projection, Stage
from app.model.refusal import format_value


def run(arguments: Sequence[str]) -> int:
    """Print every stage's matrix; return the exit status."""
    found, words = parser_of("matrices").read(arguments)
    projection = document_of(words[0] if words else None, found.set).projection
    write_out([_MATRIX_FORMATS[found.format](projection)])
    return 0


def _factors(stage: Stage) -> tuple[tuple[str, Array], ...]:
    """Return those factors of a stage that are not stages themselves."""
    return tuple(factor for factor in stage.factors if "_from_" not in factor[0])


def _matrices_text(projection: Projection) -> str:
    blocks = [f"{lens_line(projection)}\n"]
    for stage in projection.all_stages:
        product = f" = {' '.join(name for name, _ in stage.factors)}" if stage.factors else ""
        notes = [stage.note] if stage.note else []
        notes += map(str, properties(projection, stage.name))
        note = "".join(f"  ({note})\n" for note in notes)
        blocks.append(f"{stage.name}{product}\n{note}{_text(stage.matrix)}")
        factors = _factors(stage)
        if len(factors) > 1:
            blocks += [f"  {name}\n{_text(values)}" for name, values in factors]
        if stage.name == "clip_from_world":
            blocks.append("ndc_from_clip: x, y and z divided by w\n")
    return "\n".join(blocks)


def _text(matrix: Array) -> str:
    texts = [format_value(value) for value in (matrix + 0.0).ravel().tolist()]
    length, before = (part.reshape(1, *matrix.shape) for part in lengths(texts))
    cells = map(str.rjust, texts, widths(length, before))
    return "".join(f"  {''.join(row)}\n" for row in zip(*[cells] * matrix.shape[1], strict=True))


def _matrices_json(projection: Projection) -> str:
    lines = [
        f"  {json.dumps(stage.name)}: {json.dumps(plain(stage.matrix), allow_nan=False)}"
        for stage in projection.all_stages
    ]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _matrices_latex(projection: Projection) -> str:
    blocks = ["% needs \\usepackage{amsmath}\n"]
    for stage in projection.all_stages:
        factors = _factors(stage)
        shown = [values for _, values in factors] if len(factors) > 1 else []
        equal = " = ".join(
            "\n".join(map(_latex, group)) for group in (shown, [stage.matrix]) if group
        )
        notes = [stage.note] if stage.note else []
        notes += map(str, properties(projection, stage.name))
        note = "".join(f"% {note}\n" for note in notes)
        blocks.append(f"{note}\\[\n{latex_name(stage.name)} = {equal}\n\\]\n")
    return "\n".join(blocks)


def _latex(matrix: Array) -> str:
    rows = [" & ".join(map(latex_number, row)) for row in plain(matrix)]
    return "\\begin{pmatrix}\n" + " \\\\\n".join(rows) + "\n\\end{pmatrix}"


_MATRIX_FORMATS: dict[str, Callable[[Projection], str]] = {
    "text": _matrices_text,
    "json": _matrices_json,
    "latex": _matrices_latex,
}
