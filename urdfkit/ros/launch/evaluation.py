"""``$(eval ...)`` of ROS 1, as far as it can be known without running it.

Source: ``_eval`` and ``_DictWrapper`` in ``roslaunch/substitution_args.py`` of ros/ros_comm.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from urdfkit.text import python_source

if TYPE_CHECKING:
    from typing import TypeAlias

    Value: TypeAlias = str | bool | int | float

#: Expressions inside one another that are followed, and the longest text that one may give.
MAX_DEPTH, MAX_LENGTH = 30, 4096


class Unknown(Exception):
    """The value is known to roslaunch only."""


def evaluate(
    text: str, arguments: Mapping[str, str], functions: Mapping[str, Callable[[str], str | None]]
) -> str | None:
    """The text that an expression gives; None where that is not known.

    Args:
        text: the expression.
        arguments: of the launch file; they can be called by name.
        functions: such as ``find``, which take one text.
    """
    try:
        body = python_source.parse(text.strip()).body
        expression = body[0].value if len(body) == 1 and isinstance(body[0], ast.Expr) else None
        found = _Evaluation(arguments, functions).value(expression, 0)
    except (SyntaxError, Unknown):
        return None
    return str(found)


class _Evaluation:
    """The values of expressions; those that are not listed here raise ``Unknown``."""

    def __init__(
        self,
        arguments: Mapping[str, str],
        functions: Mapping[str, Callable[[str], str | None]],
    ) -> None:
        self._arguments = arguments
        self._functions = functions

    def value(self, node: ast.expr | None, depth: int) -> Value:
        handle = getattr(self, f"_{type(node).__name__.lower()}", None)
        if handle is None or depth > MAX_DEPTH:
            raise Unknown
        found: Value = handle(node, depth + 1)
        return found

    def _constant(self, node: ast.Constant, _: int) -> Value:
        if isinstance(node.value, (str, bool, int, float)):
            return node.value
        raise Unknown

    def _name(self, node: ast.Name, _: int) -> Value:
        return _converted(self._arguments.get(node.id))

    def _boolop(self, node: ast.BoolOp, depth: int) -> Value:
        found = self.value(node.values[0], depth)
        for inner in node.values[1:]:
            if bool(found) is isinstance(node.op, ast.Or):
                break
            found = self.value(inner, depth)
        return found

    def _unaryop(self, node: ast.UnaryOp, depth: int) -> Value:
        if isinstance(node.op, ast.Not):
            return not self.value(node.operand, depth)
        raise Unknown

    def _ifexp(self, node: ast.IfExp, depth: int) -> Value:
        return self.value(node.body if self.value(node.test, depth) else node.orelse, depth)

    def _compare(self, node: ast.Compare, depth: int) -> Value:
        if len(node.ops) > 1 or not isinstance(node.ops[0], (ast.Eq, ast.NotEq)):
            raise Unknown
        left, right = self.value(node.left, depth), self.value(node.comparators[0], depth)
        return (left == right) is isinstance(node.ops[0], ast.Eq)

    def _binop(self, node: ast.BinOp, depth: int) -> Value:
        left, right = self.value(node.left, depth), self.value(node.right, depth)
        are_texts = isinstance(left, str) and isinstance(right, str)
        if not are_texts or not isinstance(node.op, ast.Add):
            raise Unknown
        if len(found := f"{left}{right}") > MAX_LENGTH:
            raise Unknown
        return found

    def _call(self, node: ast.Call, depth: int) -> Value:
        if not isinstance(node.func, ast.Name) or len(node.args) != 1:
            raise Unknown
        name = str(self.value(node.args[0], depth))
        if node.func.id == "arg":
            return _converted(self._arguments.get(name))
        function = self._functions.get(node.func.id)
        found = function(name) if function else None
        if found is None:
            raise Unknown
        return found


def _converted(text: str | None) -> Value:
    """The value of an argument, as roslaunch takes it in an expression."""
    if text is None:
        raise Unknown
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text
