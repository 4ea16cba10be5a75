"""What lupdate will find in a source: the texts marked for translation where they stand."""

import ast
from pathlib import Path
from types import ModuleType

from app.model.refusal import SENTENCES


def marked(*modules: ModuleType, context: str = "Refusal") -> set[str]:
    """The texts of a context that some modules mark, or take from the page of sentences."""
    texts, pages = set(), (context.upper(), f"{context.upper()}S")
    for module in modules:
        for node in ast.walk(ast.parse(Path(module.__file__ or "").read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                if ast.unparse(node).startswith(f"QT_TRANSLATE_NOOP('{context}', "):
                    texts.add(ast.literal_eval(node.args[1]))
            elif isinstance(node, ast.Subscript) and ast.unparse(node.value) in pages:
                texts.add(SENTENCES[context][ast.literal_eval(node.slice)])
    return texts
