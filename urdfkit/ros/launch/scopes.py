"""The expression that a name in a Python program refers to, if it is unique."""

from __future__ import annotations

import ast
from collections import Counter
from functools import lru_cache
from typing import TypeGuard

from urdfkit.core.record import Record
from urdfkit.ros.launch.bound_parameters import bound_parameters
from urdfkit.ros.launch.returned_values import returned_values
from urdfkit.text.python_source import CACHE_SIZE, nodes

_DEFINED = (ast.FunctionDef, ast.AsyncFunctionDef)
_FUNCTIONS = (*_DEFINED, ast.Lambda)
#: Values of a name from which on it is unknown.
_MAX_BINDINGS = 10


class _Binding(Record):
    """A value of a name; None is known only at run time."""

    value: ast.expr | None
    #: End of the assignment, line and column, in the body of the function itself; None inside a
    #: loop or a condition.
    end: tuple[int, int] | None


class _Scope(Record):
    """The bindings of the names in a function or module."""

    bindings: dict[str, list[_Binding]]
    outer: _Scope | None

    def bind(self, name: str, value: ast.expr | None, end: tuple[int, int] | None = None) -> None:
        bindings = self.bindings.setdefault(name, [])
        if len(bindings) < _MAX_BINDINGS:
            bindings.append(_Binding(value, end))

    def value(self, name: ast.Name, *, is_own: bool) -> ast.expr | None:
        """The value of a name; of several that follow one another, the last before its use."""
        bindings = self.bindings[name.id]
        first = bindings[0].value
        if len(bindings) == _MAX_BINDINGS:
            return None
        if all(other.value is first or _are_equal(first, other.value) for other in bindings[1:]):
            return first
        place = name.lineno, name.col_offset
        ends = [binding.end for binding in bindings]
        if not is_own or None in ends:
            return None
        before = [
            (end, binding.value) for binding in bindings if (end := binding.end) and end <= place
        ]
        return max(before, key=lambda pair: pair[0])[1] if before else None


class Scopes:
    """The names of a program, each in its function.

    A name with two different values has the last one before its use, if neither depends on a
    condition and no other function uses it; otherwise its value is known only at run time. So is
    that of a ``global`` name of a function.
    """

    def __init__(self, tree: ast.Module) -> None:
        self._scope_of: dict[int, _Scope] = {}
        self._kept: list[ast.Name] = []  # so that their identities stay theirs
        self._passed = bound_parameters(tree)
        self._returned = returned_values(tree)
        self._module = _Scope({}, None)
        stack: list[tuple[ast.AST, _Scope, bool]] = [(tree, self._module, False)]
        while stack:
            node, scope, is_straight = stack.pop()
            if isinstance(node, ast.Name):
                self._scope_of[id(node)] = scope
            inner = self._bound(node, scope, is_straight=is_straight)
            is_body = isinstance(node, (ast.Module, *_FUNCTIONS))
            stack += [(child, inner, is_body) for child in ast.iter_child_nodes(node)]

    def value(self, name: ast.Name) -> ast.expr | None:
        """The value of a name where it is used; None if it is ambiguous."""
        scope = own = self._scope_of.get(id(name))
        while scope is not None and name.id not in scope.bindings:
            scope = scope.outer
        return scope.value(name, is_own=scope is own) if scope else None

    def returned(self, call: ast.Call) -> ast.expr | None:
        """What a function of the file returns for a call; None if it is ambiguous."""
        return self._returned.get(call)

    def sees(self, name: ast.Name, other: str) -> bool:
        """True if another name has a value where a name is used."""
        scope = self._scope_of.get(id(name))
        while scope is not None and other not in scope.bindings:
            scope = scope.outer
        return scope is not None

    def _bound(self, node: ast.AST, scope: _Scope, *, is_straight: bool) -> _Scope:
        """Record the names that a node binds; returns the scope of its contents."""
        if isinstance(node, ast.Assign) and len(node.targets) == 1:
            target = node.targets[0]
            if isinstance(target, ast.Name):
                end = node.end_lineno or node.lineno, node.end_col_offset or 0
                scope.bind(target.id, node.value, end if is_straight else None)
                return scope
        if isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name) and is_straight:
            end = node.end_lineno or node.lineno, node.end_col_offset or 0
            scope.bind(node.target.id, self._grown(node, node.target, scope), end)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            scope.bind(node.target.id, node.value)
        elif isinstance(node, ast.Global):  # the function may be called at any time
            for name in node.names:
                self._module.bind(name, None)
        elif isinstance(node, _FUNCTIONS):
            inner = _Scope({}, scope)
            parameters = node.args
            known = self._passed.get(node) if isinstance(node, ast.FunctionDef) else None
            passed = known.passed if known else {}
            named = (*parameters.posonlyargs, *parameters.args, *parameters.kwonlyargs)
            for argument in (*named, *filter(None, (parameters.vararg, parameters.kwarg))):
                inner.bind(argument.arg, passed.get(argument.arg))
            return inner
        else:
            for name in _stored(node):
                scope.bind(name, None)
        return scope

    def _grown(self, node: ast.AugAssign, target: ast.Name, scope: _Scope) -> ast.expr | None:
        """The value after ``name += items``: a sum with the value before."""
        if not isinstance(node.op, ast.Add):
            return None
        before = ast.copy_location(ast.Name(target.id, ast.Load()), target)
        self._scope_of[id(before)] = scope
        self._kept.append(before)
        return ast.copy_location(ast.BinOp(before, ast.Add(), node.value), node)


@lru_cache(CACHE_SIZE)
def scopes(tree: ast.Module) -> Scopes:
    """The names of a file; cached."""
    return Scopes(tree)


def unread(tree: ast.Module) -> set[ast.expr]:
    """The expressions that are assigned to unused names.

    A name that only such expressions read is unused, too.
    """
    assigned = [node for node in nodes(tree) if isinstance(node, ast.Assign)]
    reads = Counter(name.id for name in nodes(tree) if is_read(name))
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
            reads.subtract(node.id for node in ast.walk(value) if is_read(node))


def overwritten(tree: ast.Module) -> set[ast.expr]:
    """The expressions that a later one replaces before anything reads their name."""
    found: set[ast.expr] = set()
    for body in (node.body for node in nodes(tree) if isinstance(node, (ast.Module, *_DEFINED))):
        current: dict[str, ast.expr] = {}
        for statement in body:
            target = statement.targets[0] if isinstance(statement, ast.Assign) else None
            is_plain = isinstance(statement, ast.Assign) and len(statement.targets) == 1
            own = target.id if is_plain and isinstance(target, ast.Name) else None
            for name in (node for node in ast.walk(statement) if isinstance(node, ast.Name)):
                if is_read(name) or name.id != own:
                    current.pop(name.id, None)
            if own is not None and isinstance(statement, ast.Assign):
                if own in current:
                    found.add(current[own])
                current[own] = statement.value
    return found


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


def is_read(node: ast.AST) -> TypeGuard[ast.Name]:
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
