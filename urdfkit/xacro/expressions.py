"""What a ``${...}`` may do: an allow-list for expressions of models that nobody vouches for.

xacro evaluates Python, and its own filter can be walked around (a nested lambda, string
subscripts into ``vars(type)``, ``$(eval)``). Here an expression is parsed first, and only
harmless kinds of nodes pass. What may lead out of the data, or grow without bound, is rewritten
to a call of the Sandbox, which decides when the values are known.
"""

import ast
import re
import warnings
from collections.abc import Iterator, Mapping
from functools import lru_cache
from types import CodeType

from urdfkit.core.static_typing import Any
from urdfkit.xacro.bounds import MAX_BITS, TooLarge, UnsafeExpression
from urdfkit.xacro.sandbox import Sandbox

#: Longer than any expression of a model; the longest known has 156 characters.
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

#: Operators whose result may be larger than both operands together, or that compare them.
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

#: A value of a table by its key.
_ITEM = r"(?a)(?!__)[A-Za-z_]\w*(\[(['\"])\w+\2\])+"

#: The place of a node that stands in no text.
_NOWHERE: dict[str, Any] = {"lineno": 1, "col_offset": 0, "end_lineno": 1, "end_col_offset": 0}


@lru_cache(maxsize=4096)
def compile_expression(text: str) -> CodeType:
    """Compile an expression after checking it.

    Raises:
        SyntaxError: as Python's own ``compile``.
        UnsafeExpression: it is rejected.
        TooLarge: it is longer, or nested deeper, than any model's.
    """
    if _is_plain(text):
        return compile(text, "<expression>", "eval")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what Python thinks of its style is nobody's business
        if len(text) > MAX_EXPRESSION:
            raise TooLarge(f"an expression of more than {MAX_EXPRESSION} characters")
        try:
            return compile(
                _sandboxed(ast.parse(text, "<expression>", "eval")), "<expression>", "eval"
            )
        except (RecursionError, MemoryError) as error:
            raise TooLarge("an expression that is nested too deeply") from error


def _is_plain(text: str) -> bool:
    """True for a name or an item, as most expressions are: nothing can be wrong with them."""
    if text.isidentifier():
        return text.isascii() and not text.startswith("__")
    return "[" in text and re.fullmatch(_ITEM, text) is not None


def _sandboxed(tree: ast.Expression) -> ast.Expression:
    """Check an expression and rewrite what the Sandbox has to see; without recursion."""
    nodes = list(ast.walk(tree))
    for node in nodes:
        _reject(node)
    for node in reversed(nodes):  # inner ones first
        for field, value in ast.iter_fields(node):
            if isinstance(value, ast.AST):
                setattr(node, field, _wrapped(value, node))
            elif isinstance(value, list):
                value[:] = [_wrapped(item, node) for item in value]
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


def _wrapped(node: Any, around: ast.AST) -> Any:
    """What stands for a node whose own parts have been rewritten."""
    if isinstance(node, ast.Attribute):
        return _call("sandbox attribute", node.value, ast.Constant(node.attr, **_NOWHERE))
    if isinstance(node, ast.Call):
        if (text := _formatted(node.func)) is not None:
            node.func = _call("sandbox format", text)
        node.args.insert(0, node.func)
        node.func = _name("sandbox call")
    elif isinstance(node, ast.BinOp) and type(node.op) in _OPERATORS:
        return _call(_OPERATORS[type(node.op)], node.left, node.right)
    elif isinstance(node, ast.Compare):
        if not all(isinstance(operator, (ast.Is, ast.IsNot)) for operator in node.ops):
            node.left = _call("sandbox compared", node.left)
            node.comparators = [_call("sandbox compared", one) for one in node.comparators]
    elif isinstance(node, ast.comprehension):
        node.iter = _call("sandbox steps", node.iter)
    elif isinstance(node, ast.Starred):
        guard = "sandbox hashed" if isinstance(around, ast.Set) else "sandbox keep"
        node.value = _call(guard, node.value)
    elif _makes_a_value(node, around):
        return _call("sandbox keep", node)
    return node


def _formatted(node: Any) -> Any:
    """The value whose attribute ``format`` a rewritten node reads; None of any other node."""
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        name = node.args[-1]
        is_format = isinstance(name, ast.Constant) and name.value == "format"
        if is_format and node.func.id == "sandbox attribute":
            return node.args[0]
    return None


def _makes_a_value(node: Any, around: ast.AST) -> bool:
    """True for a list or table, for a slice, and for every item of a comprehension."""
    if isinstance(node, ast.Subscript):
        return not isinstance(node.slice, ast.Constant)
    if isinstance(node, (ast.Tuple, ast.List)):
        return isinstance(node.ctx, ast.Load) and bool(node.elts)
    if isinstance(node, (ast.Dict, ast.Set, ast.ListComp, ast.SetComp, ast.DictComp)):
        return True
    comprehends = isinstance(around, (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp))
    return comprehends and isinstance(node, ast.expr) and not isinstance(node, ast.Constant)


def _name(name: str) -> ast.Name:
    return ast.Name(name, ast.Load(), **_NOWHERE)


def _call(function: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(_name(function), list(arguments), [], **_NOWHERE)


class Scope(dict[str, Any]):
    """The names that an expression may use: the guards of a Sandbox before those of the model."""

    __slots__ = ("_guards", "_names")

    def __init__(self, guards: Mapping[str, Any], names: Any) -> None:
        super().__init__(__builtins__={})
        self._guards = guards
        self._names = names

    def __getitem__(self, name: str) -> Any:
        guard = self._guards.get(name)
        return self._names[name] if guard is None else guard


def evaluate(text: str, names: Any, sandbox: Sandbox) -> Any:
    """The value of an expression; of an iterator the list.

    Args:
        names: what it may look up; raises KeyError.

    Raises:
        Exception: whatever goes wrong in it.
    """
    value = eval(compile_expression(text), Scope(sandbox.guards, names))
    return sandbox.keep(list(value)) if isinstance(value, Iterator) else value
