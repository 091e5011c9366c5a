"""Classes of a workspace that launch files use to load a robot description.

``loader = RobotDescriptionLoader()``, ``loader.use_gazebo = "true"``, ``loader.load()``: the class
is in a Python module of a package, and a method returns the command line of xacro. The calls are
replaced by what the method returns, with the values of the attributes.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Callable, Iterator
from copy import deepcopy
from functools import lru_cache

from urdfkit.core.record import Record
from urdfkit.ros.launch.repeated_calls import MAX_NODES
from urdfkit.ros.launch.returned_values import returned_value
from urdfkit.text.python_source import nodes

#: Finds the syntax tree of a module by its name with dots; None if it is not in the workspace.
FindModule = Callable[[str], ast.Module | None]


#: Most objects of such classes in a file.
_MAX_LOADERS = 20


class _Loader(Record):
    """An object of such a class, and the attributes that the launch file sets."""

    methods: dict[str, ast.FunctionDef]
    changes: list[ast.Assign]  # of its attributes, in the order of the file
    is_open: bool  # True if an attribute may have another value, as by a condition


def with_loaders(tree: ast.Module, find: FindModule) -> ast.Module:
    """The tree with the calls of such methods replaced; the same tree if there are none."""
    classes = tuple(_imported_classes(tree, find))
    return _replaced(tree, classes) if classes else tree


@lru_cache(maxsize=4)  # a file is read once for each set of its arguments
def _replaced(tree: ast.Module, classes: tuple[tuple[str, ast.ClassDef], ...]) -> ast.Module:
    loaders = _loaders(tree, dict(classes))
    if not loaders:
        return tree
    try:
        replacer, copied = _Replacer(loaders), deepcopy(tree)
        replacer.visit(copied)
    except RecursionError:
        return tree
    return copied if replacer.has_replaced else tree


def _imported_classes(tree: ast.Module, find: FindModule) -> Iterator[tuple[str, ast.ClassDef]]:
    """The classes that a launch file imports from modules of the workspace, by their names here."""
    for node in tree.body:
        module = node.module if isinstance(node, ast.ImportFrom) and not node.level else None
        found = find(module) if module and "." in module else None
        if found is not None and isinstance(node, ast.ImportFrom):
            defined = {one.name: one for one in found.body if isinstance(one, ast.ClassDef)}
            for alias in node.names:
                if alias.name in defined:
                    yield alias.asname or alias.name, defined[alias.name]


def _loaders(tree: ast.Module, classes: dict[str, ast.ClassDef]) -> dict[str, _Loader]:
    """The objects that are created without arguments, each by its only name."""
    names = [node for node in nodes(tree) if isinstance(node, ast.Name)]
    stored = Counter(name.id for name in names if isinstance(name.ctx, ast.Store))
    loaders: dict[str, _Loader] = {}
    for function in (node for node in nodes(tree) if isinstance(node, ast.FunctionDef)):
        for statement in function.body:
            name, of = _created(statement)
            if of in classes and stored[name] == 1 and len(loaders) < _MAX_LOADERS:
                loaders[name] = _loader(name, classes[of], function.body, tree)
    return loaders


def _created(statement: ast.stmt) -> tuple[str, str]:
    """The name and the class in ``name = Class()``; empty for any other statement."""
    if isinstance(statement, ast.Assign) and isinstance(statement.value, ast.Call):
        target, call = statement.targets[0], statement.value
        is_plain = len(statement.targets) == 1 and not (call.args or call.keywords)
        if is_plain and isinstance(target, ast.Name) and isinstance(call.func, ast.Name):
            return target.id, call.func.id
    return "", ""


def _loader(name: str, of: ast.ClassDef, body: list[ast.stmt], tree: ast.Module) -> _Loader:
    methods = {one.name: one for one in of.body if isinstance(one, ast.FunctionDef)}
    changes = [one for one in body if isinstance(one, ast.Assign) and _changed(one, name)]
    every = [node for node in nodes(tree) if isinstance(node, ast.Attribute)]
    stored = [node for node in every if isinstance(node.ctx, ast.Store) and _is_of(node, name)]
    return _Loader(methods, changes, len(stored) != len(changes))


def _changed(statement: ast.Assign, name: str) -> str:
    """The attribute of an object to which a statement assigns; empty for any other statement."""
    target = statement.targets[0] if len(statement.targets) == 1 else None
    is_own = isinstance(target, ast.Attribute) and _is_of(target, name)
    return target.attr if isinstance(target, ast.Attribute) and is_own else ""


def _is_of(node: ast.Attribute, name: str) -> bool:
    return isinstance(node.value, ast.Name) and node.value.id == name


class _Replacer(ast.NodeTransformer):
    """Replaces the calls of methods without arguments, as long as the copies are few."""

    def __init__(self, loaders: dict[str, _Loader]) -> None:
        self._loaders = loaders
        self._left = MAX_NODES
        self.has_replaced = False

    def visit_Call(self, node: ast.Call) -> ast.expr:
        self.generic_visit(node)
        function = node.func
        if not isinstance(function, ast.Attribute) or not isinstance(function.value, ast.Name):
            return node
        name = function.value.id
        loader = self._loaders.get(name)
        method = loader.methods.get(function.attr) if loader else None
        if loader is None or method is None or loader.is_open or self._left < 0:
            return node
        returned = returned_value(method) if _takes_only_itself(method) else None
        if returned is None or node.args or node.keywords:
            return node
        values = _attributes(loader, name, node.lineno)
        result: ast.expr = _Attributes(method.args.args[0].arg, values).visit(deepcopy(returned))
        for inner in ast.walk(result):
            self._left -= 1
            if isinstance(inner, ast.expr):
                ast.copy_location(inner, node)
        self.has_replaced = True
        return result


def _takes_only_itself(method: ast.FunctionDef) -> bool:
    named = method.args
    rest = (*named.posonlyargs, *named.kwonlyargs, named.vararg, named.kwarg)
    return len(named.args) == 1 and not any(rest)


def _attributes(loader: _Loader, name: str, line: int) -> dict[str, ast.expr]:
    """The values of the attributes before a line: those of the constructor, then the changes."""
    constructor = loader.methods.get("__init__")
    values: dict[str, ast.expr] = {}
    own = constructor.args.args[0].arg if constructor and constructor.args.args else ""
    for statement in constructor.body if constructor else ():
        if isinstance(statement, ast.Assign) and (changed := _changed(statement, own)):
            values[changed] = statement.value
    for statement in loader.changes:
        if statement.lineno < line:
            values[_changed(statement, name)] = statement.value
    return values


class _Attributes(ast.NodeTransformer):
    """Puts the values of attributes in the place of ``self.name``."""

    def __init__(self, itself: str, values: dict[str, ast.expr]) -> None:
        self._itself, self._values = itself, values

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        if _is_of(node, self._itself) and node.attr in self._values:
            return deepcopy(self._values[node.attr])
        self.generic_visit(node)
        return node
