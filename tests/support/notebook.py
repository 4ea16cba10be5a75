"""A notebook that runs here, cell by cell, as Jupyter does it."""

import ast
import json
from typing import Any


def with_outputs(text: str) -> tuple[str, list[Any]]:
    """Run a notebook's cells; return it with what they show, and the values of their last lines."""
    notebook, scope = json.loads(text), dict[str, Any]()
    values: list[Any] = []
    for cell in notebook["cells"]:
        if cell["cell_type"] != "code":
            continue
        *first, last = ast.parse("".join(cell["source"])).body
        exec(compile(ast.Module(first, []), "cell", "exec"), scope)
        assert isinstance(last, ast.Expr)
        values.append(eval(compile(ast.Expression(last.value), "cell", "eval"), scope))
        data = {"text/plain": lines_of(repr(values[-1]))}
        draw = getattr(values[-1], "_repr_svg_", None)
        if draw is not None:
            data["image/svg+xml"] = lines_of(draw())
        number = cell["execution_count"] = len(values)
        cell["outputs"] = [
            {"data": data, "execution_count": number, "metadata": {},
             "output_type": "execute_result"}
        ]  # fmt: skip
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", [scope, *values]


def lines_of(text: str) -> list[str]:
    return text.splitlines(keepends=True)
