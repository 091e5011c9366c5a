"""Python files of others as syntax trees: they are read, and never run."""

import ast
import warnings
from functools import lru_cache

#: Files whose trees are kept: launch files include the same ones again and again.
KEPT = 64


@lru_cache(KEPT)
def parse(text: bytes | str, path: str = "<unknown>") -> ast.Module:
    """The syntax tree of a Python file, which several may read and none may change.

    Raises:
        SyntaxError: it is no Python, or nested too deeply to be read.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about its style
        try:
            return ast.parse(text, path)
        except (ValueError, RecursionError, MemoryError) as error:
            raise SyntaxError(str(error) or type(error).__name__) from error


@lru_cache(KEPT)
def nodes(tree: ast.Module) -> tuple[ast.AST, ...]:
    """All nodes of a file, as `ast.walk` finds them."""
    return tuple(ast.walk(tree))


def string(node: ast.expr | None) -> str | None:
    """The text of a string that is written out; None for anything else."""
    value = node.value if isinstance(node, ast.Constant) else None
    return value if isinstance(value, str) else None
