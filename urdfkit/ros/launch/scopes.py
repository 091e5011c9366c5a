"""The expression that a name in a Python program refers to, if it is unique."""

from __future__ import annotations

import ast
from collections import Counter
from functools import lru_cache
from typing import TypeGuard

from urdfkit.core.record import Record
from urdfkit.ros.launch.bound_parameters import bound_parameters
from urdfkit.text.python_source import CACHE_SIZE, nodes

_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


class _Scope(Record):
    """The values of names in a function or module; None is known only at run time."""

    values: dict[str, ast.expr | None]
    outer: _Scope | None

    def bind(self, name: str, value: ast.expr | None) -> None:
        first = self.values.setdefault(name, value)
        if first is not value and not _are_equal(first, value):
            self.values[name] = None


class Scopes:
    """The names of a program, each in its function.

    A name with two different values has none here, as its value is known only at run time.
    """

    def __init__(self, tree: ast.Module) -> None:
        self._scope_of: dict[int, _Scope] = {}
        self._passed = bound_parameters(tree)
        stack: list[tuple[ast.AST, _Scope]] = [(tree, _Scope({}, None))]
        while stack:
            node, scope = stack.pop()
            if isinstance(node, ast.Name):
                self._scope_of[id(node)] = scope
            inner = self._bound(node, scope)
            stack += [(child, inner) for child in ast.iter_child_nodes(node)]

    def value(self, name: ast.Name) -> ast.expr | None:
        """The value of a name where it is used; None if it is ambiguous."""
        scope = self._scope_of.get(id(name))
        while scope is not None and name.id not in scope.values:
            scope = scope.outer
        return scope.values[name.id] if scope else None

    def _bound(self, node: ast.AST, scope: _Scope) -> _Scope:
        """Record the names that a node binds; returns the scope of its contents."""
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            target = node.targets[0]
            if isinstance(target, ast.Name):
                scope.bind(target.id, node.value)
                return scope
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            scope.bind(node.target.id, node.value)
        elif isinstance(node, _FUNCTIONS):
            inner = _Scope({}, scope)
            parameters = node.args
            passed = self._passed.get(node, {}) if isinstance(node, ast.FunctionDef) else {}
            for argument in (*parameters.posonlyargs, *parameters.args, *parameters.kwonlyargs):
                inner.bind(argument.arg, passed.get(argument.arg))
            return inner
        else:
            for name in _stored(node):
                scope.bind(name, None)
        return scope


@lru_cache(CACHE_SIZE)
def scopes(tree: ast.Module) -> Scopes:
    """The names of a file; cached."""
    return Scopes(tree)


def unread(tree: ast.Module) -> set[ast.expr]:
    """The expressions that are assigned to unused names.

    A name that only such expressions read is unused, too.
    """
    assigned = [node for node in nodes(tree) if isinstance(node, ast.Assign)]
    reads = Counter(name.id for name in nodes(tree) if _is_read(name))
    found: set[ast.expr] = set()
    while True:
        new = {
            node.value
            for node in assigned
            if node.value not in found
            and all(isinstance(name, ast.Name) and not reads[name.id] for name in node.targets)
        }
        if not new:
            return found
        found |= new
        for value in new:
            reads.subtract(node.id for node in ast.walk(value) if _is_read(node))


def with_items(expressions: set[ast.expr]) -> set[ast.expr]:
    """Expressions, and the items of the lists among them."""
    found = set(expressions)
    stack = [*expressions]
    while stack:
        node = stack.pop()
        items = node.elts if isinstance(node, (ast.List, ast.Tuple)) else []
        stack += items
        found.update(items)
    return found


def _is_read(node: ast.AST) -> TypeGuard[ast.Name]:
    return isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)


def _are_equal(first: ast.expr | None, second: ast.expr | None) -> bool:
    if first is None or second is None:
        return False
    try:
        return ast.dump(first) == ast.dump(second)
    except RecursionError:  # a sum of a thousand parts
        return False


def _stored(node: ast.AST) -> list[str]:
    """The names that a statement other than a plain assignment binds."""
    targets: list[ast.AST | None] = []
    if isinstance(node, ast.Assign):
        targets += node.targets
    elif isinstance(node, (ast.AugAssign, ast.For, ast.AsyncFor, ast.comprehension, ast.NamedExpr)):
        targets.append(node.target)
    elif isinstance(node, ast.withitem):
        targets.append(node.optional_vars)
    return [n.id for t in targets if t for n in ast.walk(t) if isinstance(n, ast.Name)]
