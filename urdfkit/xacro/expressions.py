"""Sandboxed evaluation of ``${...}``, by an allow-list for expressions of untrusted models.

xacro evaluates Python, and its own filter can be bypassed (a nested lambda, string subscripts into
``vars(type)``, ``$(eval)``). Here an expression is parsed first, and only harmless kinds of nodes
are allowed. Operations that may access other objects, or grow without limit, are rewritten to calls
of the Sandbox, which checks the values at run time. The names of these calls contain a space, so
that no model can use them.
"""

import ast
import re
import warnings
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from types import CodeType

from urdfkit.core.static_typing import Any
from urdfkit.xacro.bounds import MAX_BITS, TooLarge, UnsafeExpression
from urdfkit.xacro.sandbox import Sandbox

#: Most characters of an expression; the longest known has 156.
MAX_EXPRESSION = 4000

_ALLOWED = (
    ast.Expression, ast.Constant, ast.Name, ast.Load, ast.Store, ast.Attribute, ast.Subscript,
    ast.Slice, ast.Call, ast.keyword, ast.Starred, ast.List, ast.Tuple, ast.Dict, ast.Set,
    ast.IfExp, ast.BoolOp, ast.And, ast.Or, ast.UnaryOp, ast.Not, ast.USub, ast.UAdd, ast.Invert,
    ast.BinOp, ast.Add, ast.Sub, ast.Mult, ast.Div, ast.FloorDiv, ast.Mod, ast.Pow, ast.LShift,
    ast.RShift, ast.BitOr, ast.BitXor, ast.BitAnd, ast.Compare, ast.Eq, ast.NotEq, ast.Lt,
    ast.LtE, ast.Gt, ast.GtE, ast.Is, ast.IsNot, ast.In, ast.NotIn, ast.ListComp, ast.SetComp,
    ast.DictComp, ast.GeneratorExp, ast.comprehension,
)  # fmt: skip

#: Operators whose result may be larger than both operands, or that compare them.
_OPERATORS = {
    ast.Add: "sandbox add",
    ast.Mult: "sandbox times",
    ast.Pow: "sandbox power",
    ast.LShift: "sandbox shift",
    ast.Mod: "sandbox modulo",
    ast.BitAnd: "sandbox and",
    ast.BitOr: "sandbox or",
    ast.BitXor: "sandbox xor",
}

#: Items of a table by literal keys.
_ITEM = r"(?a)(?!__)[A-Za-z_]\w*(\[(['\"])\w+\2\])+"

#: The location of generated nodes.
_GENERATED: dict[str, Any] = {"lineno": 1, "col_offset": 0, "end_lineno": 1, "end_col_offset": 0}


@lru_cache(maxsize=4096)
def compile_expression(text: str) -> CodeType:
    """Compile an expression after checking it.

    Raises:
        SyntaxError: as in Python's ``compile``.
        UnsafeExpression: it is rejected.
        TooLarge: it is too long, or nested too deeply.
    """
    if _is_plain(text):
        return compile(text, "<expression>", "eval")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about style
        if len(text) > MAX_EXPRESSION:
            raise TooLarge(f"an expression of more than {MAX_EXPRESSION} characters")
        try:
            return compile(
                _sandboxed(ast.parse(text, "<expression>", "eval")), "<expression>", "eval"
            )
        except (RecursionError, MemoryError) as error:
            raise TooLarge("an expression that is nested too deeply") from error


def _is_plain(text: str) -> bool:
    """True for a name or an item, as most expressions are, which are always safe."""
    if text.isidentifier():
        return text.isascii() and not text.startswith("__")
    return "[" in text and re.fullmatch(_ITEM, text) is not None


def _sandboxed(tree: ast.Expression) -> ast.Expression:
    """Check an expression and rewrite operations to calls of the Sandbox, without recursion."""
    nodes = list(ast.walk(tree))
    for node in nodes:
        _reject(node)
    for node in reversed(nodes):  # inner ones first
        for field, value in ast.iter_fields(node):
            if isinstance(value, ast.AST):
                setattr(node, field, _guarded(value, node))
            elif isinstance(value, list):
                value[:] = [_guarded(item, node) for item in value]
    return tree


def _reject(node: ast.AST) -> None:
    if not isinstance(node, _ALLOWED):
        raise UnsafeExpression(f"{type(node).__name__} is not allowed in expressions")
    if isinstance(node, ast.Attribute) and node.attr.startswith("__"):
        raise UnsafeExpression(f"attribute '{node.attr}' is not allowed in expressions")
    if isinstance(node, ast.Name) and node.id.startswith("__"):
        raise UnsafeExpression(f"name '{node.id}' is not allowed in expressions")
    value = node.value if isinstance(node, ast.Constant) else None
    if isinstance(value, int) and value.bit_length() > MAX_BITS:
        raise TooLarge(f"an integer of {value.bit_length()} bits")


def _guarded(node: Any, parent: ast.AST) -> Any:
    """The replacement of a node whose own parts are already rewritten."""
    if isinstance(node, ast.Attribute):
        return _call("sandbox attribute", node.value, ast.Constant(node.attr, **_GENERATED))
    if isinstance(node, ast.Call):
        if (text := _format_receiver(node.func)) is not None:
            node.func = _call("sandbox format", text)
        node.args.insert(0, node.func)
        node.func = _name("sandbox call")
    elif isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        return _call(_OPERATORS[type(node.op)], node.left, node.right)
    elif isinstance(node, ast.Compare):
        if not all(isinstance(operator, (ast.Is, ast.IsNot)) for operator in node.ops):
            node.left = _call("sandbox compared", node.left)
            node.comparators = [_call("sandbox compared", item) for item in node.comparators]
    elif isinstance(node, ast.comprehension):
        node.iter = _call("sandbox steps", node.iter)
    elif isinstance(node, ast.Starred):
        guard = "sandbox hashed" if isinstance(parent, ast.Set) else "sandbox charged"
        node.value = _call(guard, node.value)
    elif _creates_value(node, parent):
        return _call("sandbox charged", node)
    return node


def _format_receiver(node: Any) -> Any:
    """The object whose attribute ``format`` a rewritten node reads; None for other nodes."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        name = node.args[-1]
        is_format = isinstance(name, ast.Constant) and name.value == "format"
        if is_format and node.func.id == "sandbox attribute":
            return node.args[0]
    return None


def _creates_value(node: Any, parent: ast.AST) -> bool:
    """True for a list or table, a slice, and every item of a comprehension."""
    if isinstance(node, ast.Subscript):
        return not isinstance(node.slice, ast.Constant)
    if isinstance(node, (ast.Tuple, ast.List)):
        return isinstance(node.ctx, ast.Load) and bool(node.elts)
    if isinstance(node, (ast.Dict, ast.Set, ast.ListComp, ast.SetComp, ast.DictComp)):
        return True
    is_item = isinstance(parent, (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp))
    return is_item and isinstance(node, ast.expr) and not isinstance(node, ast.Constant)


def _name(name: str) -> ast.Name:
    return ast.Name(name, ast.Load(), **_GENERATED)


def _call(function: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(_name(function), list(arguments), [], **_GENERATED)


class Scope(dict[str, Any]):
    """The names in an expression: the guards of a Sandbox take precedence over the model."""

    __slots__ = ("_guards", "_names")

    def __init__(self, guards: Mapping[str, Any], names: Any) -> None:
        super().__init__(__builtins__={})
        self._guards = guards
        self._names = names

    def __getitem__(self, name: str) -> Any:
        guard = self._guards.get(name)
        return self._names[name] if guard is None else guard

    def known_values(self, names: Iterable[str]) -> Iterator[tuple[str, Any]]:
        """The names of the model that have a value, with these; nothing is evaluated for it."""
        for name in names:
            table: Any = self._names
            while isinstance(table, dict) and not dict.__contains__(table, name):
                table = getattr(table, "parent", None)
            if isinstance(table, dict) and name not in getattr(table, "unevaluated", ()):
                yield name, dict.__getitem__(table, name)


def evaluate(text: str, names: Any, sandbox: Sandbox) -> Any:
    """The value of an expression; an iterator is converted to a list.

    Args:
        names: a mapping of the names that it may use.

    Raises:
        Exception: any error of the expression.
    """
    value = eval(compile_expression(text), Scope(sandbox.guards, names))
    return sandbox.charged(list(value)) if isinstance(value, Iterator) else value
