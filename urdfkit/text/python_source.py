"""Syntax trees of Python files of a workspace, which are never run."""

import ast
import warnings
from collections.abc import Iterator
from functools import lru_cache

#: Files whose trees are cached: launch files include the same files often.
CACHE_SIZE = 64
#: Most bytes of a file, and of all cached ones: a tree takes several hundred times as many. The
#: largest public launch files have 60 kB.
MAX_BYTES = 256 * 1024

_INNER = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)

_trees: dict[tuple[bytes | str, str], ast.Module] = {}


def parse(text: bytes | str, path: str = "<unknown>") -> ast.Module:
    """The syntax tree of a Python file, shared and not to be changed.

    Raises:
        SyntaxError: it is not Python, nested too deeply, or too large.
    """
    if len(text) > MAX_BYTES:
        raise SyntaxError(f"larger than {MAX_BYTES // 1024} KiB")
    tree = _trees.get((text, path))
    if tree is None:
        if len(text) + sum(len(cached) for cached, _ in _trees) > MAX_BYTES:
            _trees.clear()
            nodes.cache_clear()
        tree = _trees[text, path] = _parsed(text, path)
    return tree


def _parsed(text: bytes | str, path: str) -> ast.Module:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about style
        try:
            return ast.parse(text, path)
        except (ValueError, RecursionError, MemoryError) as error:
            raise SyntaxError(str(error) or type(error).__name__) from error


@lru_cache(CACHE_SIZE)
def nodes(tree: ast.Module) -> tuple[ast.AST, ...]:
    """All nodes of a file, in the order of `ast.walk`."""
    return tuple(ast.walk(tree))


def own_nodes(function: ast.FunctionDef) -> Iterator[ast.AST]:
    """The nodes in the body of a function, without those of functions and classes in it."""
    stack: list[ast.AST] = [*function.body]
    while stack:  # an expression may be too deep for recursion
        node = stack.pop()
        if not isinstance(node, _INNER):
            yield node
            stack += ast.iter_child_nodes(node)


def dotted_name(node: ast.AST) -> str:
    """A name with its attributes, such as ``os.path.join``; empty for any other expression.

    ``ast.unparse`` fails for a chain of a thousand attributes.
    """
    names = []
    while isinstance(node, ast.Attribute):
        names.append(node.attr)
        node = node.value
    return ".".join((node.id, *reversed(names))) if isinstance(node, ast.Name) else ""


def string(node: ast.AST | None) -> str | None:
    """The value of a string literal; None for any other expression."""
    value = node.value if isinstance(node, ast.Constant) else None
    return value if isinstance(value, str) else None
