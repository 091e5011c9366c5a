"""Which of its parts an expression with ``or`` or ``if`` has as its value."""

import ast
from collections.abc import Callable
from typing import TypeAlias

#: The value of a name, or the expression itself; None if it is ambiguous.
Known: TypeAlias = Callable[[ast.expr | None], ast.expr | None]


def chosen(node: ast.expr, known: Known) -> ast.expr:
    """The part of an expression that is its value; the expression itself if that is not known.

    Such as ``(arguments or {})``, where ``arguments`` is None by default.
    """
    if isinstance(node, ast.BoolOp) and isinstance(node.op, ast.Or):
        for value in node.values[:-1]:
            is_true = _is_true(known(value))
            if is_true is not False:
                return value if is_true else node
        return node.values[-1]
    if isinstance(node, ast.IfExp):
        holds = _holds(node.test, known)
        return node if holds is None else node.body if holds else node.orelse
    return node


def _holds(test: ast.expr, known: Known) -> bool | None:
    """Whether a value is there: ``if arguments``, ``if arguments is not None``."""
    if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
        is_true = _is_true(known(test.operand))
        return None if is_true is None else not is_true
    if not isinstance(test, ast.Compare):
        return _is_true(known(test))
    value = known(test.left)
    right = test.comparators[0]
    is_about_none = isinstance(right, ast.Constant) and right.value is None
    if not is_about_none or not isinstance(test.ops[0], (ast.Is, ast.IsNot)):
        return None
    if _is_true(value) is None:
        return None
    is_none = isinstance(value, ast.Constant) and value.value is None
    return is_none is isinstance(test.ops[0], ast.Is)


def _is_true(value: ast.expr | None) -> bool | None:
    """Whether Python takes a literal for true; None for any other expression."""
    if isinstance(value, ast.Constant):
        return bool(value.value)
    if isinstance(value, (ast.List, ast.Tuple)):
        return bool(value.elts)
    return bool(value.keys) if isinstance(value, ast.Dict) else None
