"""What lupdate will find in a source: the texts marked for translation where they stand."""

from __future__ import annotations

import ast
from pathlib import Path
from types import ModuleType


def marked(*modules: ModuleType, context: str = "Refusal") -> set[str]:
    """The literals inside ``QT_TRANSLATE_NOOP(context, ...)`` of some modules."""
    return {
        ast.literal_eval(call.args[1])
        for module in modules
        for call in ast.walk(ast.parse(Path(module.__file__ or "").read_text(encoding="utf-8")))
        if isinstance(call, ast.Call)
        and getattr(call.func, "id", "") == "QT_TRANSLATE_NOOP"
        and ast.literal_eval(call.args[0]) == context
    }
