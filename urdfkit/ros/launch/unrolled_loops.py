"""Loops of a Python launch file that create an action, or add to a list, for each item of a list.

They are replaced by their bodies, one for each item, so that its variable has one value each; what
adds to a list, by the sum of all that is added.
"""

import ast
from collections import Counter
from collections.abc import Iterator
from copy import deepcopy
from functools import lru_cache, reduce

from urdfkit.ros.launch.bound_parameters import bound_parameters
from urdfkit.ros.launch.calls import called
from urdfkit.ros.launch.repeated_calls import MAX_NODES, creates_actions
from urdfkit.text.python_source import nodes

#: Most items of a list.
_MAX_ITEMS = 20

#: The values of the variables of a loop.
Variables = dict[str, ast.expr]


@lru_cache(maxsize=4)  # a file is read once for each set of its arguments
def without_loops(tree: ast.Module) -> ast.Module:
    """The tree with such loops and comprehensions replaced; the same tree if there is none."""
    loops = (node for node in nodes(tree) if isinstance(node, (ast.For, ast.ListComp)))
    if not any(creates_actions(loop) or _grown_list(loop) for loop in loops):
        return tree
    try:
        copied = deepcopy(tree)
        unroller = _Unroller(copied)
        return ast.Module([*_flat(unroller.visit(node) for node in copied.body)], [])
    except RecursionError:
        return tree


class _Unroller(ast.NodeTransformer):
    """Replaces loops, as long as the copies are few."""

    def __init__(self, tree: ast.Module) -> None:
        self._left = MAX_NODES
        names = [node for node in nodes(tree) if isinstance(node, ast.Name)]
        stored = Counter(node.id for node in names if not isinstance(node.ctx, ast.Load))
        self._uses = Counter(node.id for node in names)
        self._changed = {
            node.value.id
            for node in nodes(tree)
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name)
        }
        self._values = {
            target.id: node.value
            for node in nodes(tree)
            if isinstance(node, ast.Assign)
            for target in node.targets
            if isinstance(target, ast.Name) and stored[target.id] == 1
        }
        self._bound = bound_parameters(tree)
        self._passed: Variables = {}

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        outer, bound = self._passed, self._bound.get(node)
        self._passed = bound.passed if bound else {}
        self.generic_visit(node)
        self._passed = outer
        return node

    def visit_For(self, node: ast.For) -> ast.AST | list[ast.stmt]:
        self.generic_visit(node)
        rounds = self._rounds(node, node.iter, node.target)
        if rounds is None or node.orelse:
            return node
        if grown := _grown_list(node):
            added = [_Substitution(one, {}).visit(deepcopy(grown.value)) for one in rounds]
            nothing: ast.expr = ast.copy_location(ast.List([], ast.Load()), node)
            grown.value = reduce(_sum, added, nothing)
            return grown
        own = self._own_names(node)
        copies: list[ast.stmt] = []
        for number, variables in enumerate(rounds):
            names = {name: f"{name}:{number}" for name in own}
            copies += (_Substitution(variables, names).visit(deepcopy(one)) for one in node.body)
        return copies

    def visit_ListComp(self, node: ast.ListComp) -> ast.AST:
        self.generic_visit(node)
        (first, *others) = node.generators
        rounds = self._rounds(node, first.iter, first.target)
        if rounds is None or others or first.ifs:
            return node
        items = [_Substitution(one, {}).visit(deepcopy(node.elt)) for one in rounds]
        return ast.copy_location(ast.List(items, ast.Load()), node)

    def _rounds(self, loop: ast.AST, items: ast.expr, target: ast.expr) -> list[Variables] | None:
        """The values of the variables in each round; None if a loop is not replaced."""
        is_read = creates_actions(loop) or _grown_list(loop) is not None
        values = self._items(items) if is_read else None
        if values is None or len(values) > _MAX_ITEMS:
            return None
        self._left -= len(values) * sum(1 for _ in ast.walk(loop))
        rounds = [_variables(target, value) for value in values]
        is_known = self._left > 0 and None not in rounds
        return [one for one in rounds if one is not None] if is_known else None

    def _items(self, node: ast.expr) -> list[ast.expr] | None:
        """The items of a list, ``dictionary.items()`` or a call of Python; None if unknown."""
        if isinstance(node, ast.Name) and node.id not in self._changed:
            node = self._passed.get(node.id) or self._values.get(node.id, node)
        if isinstance(node, (ast.List, ast.Tuple)):
            return None if any(isinstance(one, ast.Starred) for one in node.elts) else node.elts
        if isinstance(node, ast.Call) and called(node) in ("enumerate", "range"):
            return self._numbered(node) if called(node) == "enumerate" else self._numbers(node)
        if isinstance(node, ast.Call) and called(node) == "items":
            owner = node.func.value if isinstance(node.func, ast.Attribute) else node.func
            owner = self._values.get(owner.id, owner) if isinstance(owner, ast.Name) else owner
            if isinstance(owner, ast.Dict) and None not in owner.keys:
                rows = zip(filter(None, owner.keys), owner.values, strict=True)
                return [ast.Tuple([*row], ast.Load()) for row in rows]
        return None

    def _numbered(self, call: ast.Call) -> list[ast.expr] | None:
        """The pairs of ``enumerate(list)``."""
        items = self._items(call.args[0]) if len(call.args) == 1 else None
        if items is None:
            return None
        pairs = [(ast.copy_location(ast.Constant(n), call), item) for n, item in enumerate(items)]
        return [ast.Tuple([*pair], ast.Load()) for pair in pairs]

    def _numbers(self, call: ast.Call) -> list[ast.expr] | None:
        """The numbers of ``range(...)`` with known bounds."""
        named = (self._values.get(n.id, n) if isinstance(n, ast.Name) else n for n in call.args)
        bounds = [node.value for node in named if isinstance(node, ast.Constant)]
        integers = [value for value in bounds if isinstance(value, int)]
        if len(integers) < len(call.args) or not 1 <= len(integers) <= 2 or call.keywords:
            return None
        numbers = range(*integers)
        if len(numbers) > _MAX_ITEMS:
            return None
        return [ast.copy_location(ast.Constant(number), call) for number in numbers]

    def _own_names(self, loop: ast.For) -> list[str]:
        """The names that are assigned and used only in a loop."""
        names = [node for node in ast.walk(loop) if isinstance(node, ast.Name)]
        uses = Counter(node.id for node in names)
        stored = {node.id for node in names if isinstance(node.ctx, ast.Store)}
        return [name for name in stored if uses[name] == self._uses[name]]


class _Substitution(ast.NodeTransformer):
    """Puts values in the place of variables, and other names in that of names."""

    def __init__(self, variables: Variables, renamed: dict[str, str]) -> None:
        self._variables, self._renamed = variables, renamed

    def visit_Name(self, node: ast.Name) -> ast.expr:
        if node.id in self._variables and isinstance(node.ctx, ast.Load):
            return deepcopy(self._variables[node.id])
        node.id = self._renamed.get(node.id, node.id)
        return node


def _grown_list(loop: ast.AST) -> ast.AugAssign | None:
    """The only statement of a loop, if it adds items to a list."""
    body = loop.body if isinstance(loop, ast.For) and not loop.orelse else ()
    only = body[0] if len(body) == 1 else None
    is_growth = isinstance(only, ast.AugAssign) and isinstance(only.op, ast.Add)
    return only if isinstance(only, ast.AugAssign) and is_growth and _is_list(only.value) else None


def _is_list(node: ast.expr) -> bool:
    return isinstance(node, (ast.List, ast.Tuple))


def _sum(left: ast.expr, right: ast.expr) -> ast.expr:
    return ast.copy_location(ast.BinOp(left, ast.Add(), right), right)


def _variables(target: ast.expr, value: ast.expr) -> Variables | None:
    """The variables of a loop for one item; None if it has another number of parts."""
    if isinstance(target, ast.Name):
        return {target.id: value}
    if not isinstance(target, ast.Tuple) or not isinstance(value, (ast.List, ast.Tuple)):
        return None
    if len(target.elts) != len(value.elts):
        return None
    parts = [_variables(*pair) for pair in zip(target.elts, value.elts, strict=True)]
    return None if None in parts else {k: v for part in parts if part for k, v in part.items()}


def _flat(items: Iterator[ast.AST | list[ast.stmt]]) -> Iterator[ast.stmt]:
    for item in items:
        if isinstance(item, list):
            yield from item
        elif isinstance(item, ast.stmt):
            yield item
