"""What tests of the house read: Python sources as trees, each parsed once for all of them."""

import ast
import functools


@functools.cache
def nodes_of(source: str) -> list[ast.AST]:
    """All nodes of a source, its module first."""
    return list(ast.walk(ast.parse(source)))
