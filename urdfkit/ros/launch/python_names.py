"""Names of a Python launch file that are not defined, and imports from the wrong module."""

import ast
import builtins
import re
from collections.abc import Iterator
from functools import lru_cache

from urdfkit.core.grouping import by_key
from urdfkit.core.suggest import CLOSE_TYPO, TYPO, Suggester, nearest
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.python_source import nodes

_ENTRY = "generate_launch_description"
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_CONDITIONAL = (ast.If, ast.IfExp, ast.BoolOp, ast.ExceptHandler)
_MODULE_ATTRIBUTES = frozenset(
    ("__file__", "__name__", "__doc__", "__spec__", "__package__", "__path__")
)
#: Modules that launch files import under their own name.
_PLAIN_IMPORTS = ("math", "os", "pathlib", "sys", "tempfile", "xacro", "yaml")
#: What makes names in a way that is not read.
_DYNAMIC = ("exec", "globals", "locals", "NameError", "ImportError", "ModuleNotFoundError")
#: What precedes the last word of the name of a class, which says its kind: ``Substitution``.
_HEAD = r"^.*(?=[A-Z])"


def wrong_names(tree: ast.Module, values: Values) -> Iterator[Problem]:
    """Names without a definition, and imports of names that a module of launch does not have."""
    if any(isinstance(node, ast.Name) and node.id in _DYNAMIC for node in nodes(tree)):
        return
    yield from _wrong_imports(tree, values)
    bound = set(bound_names(tree))
    if "*" in bound or not _imports_launch(tree):
        return
    known = bound | _MODULE_ATTRIBUTES | set(dir(builtins))
    suggester = Suggester(bound)
    asked = {node.value: node.attr for node in nodes(tree) if isinstance(node, ast.Attribute)}
    for node, is_sure in _executed_nodes(tree):
        is_read = isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
        if isinstance(node, ast.Name) and is_read and node.id not in known:
            known.add(node.id)  # each name is reported once
            message = f"name '{node.id}' is not defined"
            help = _of_moveit(asked.get(node)) or _how_to_define(node.id, suggester)
            problem = values.problem("LAU035", node, message, help)
            yield problem if is_sure else problem._replace(severity=Severity.WARNING)


def _imports_launch(tree: ast.Module) -> bool:
    """False for a part of a launch file, such as an example in a document."""
    return any(
        isinstance(node, ast.ImportFrom) and (node.module or "").startswith("launch")
        for node in nodes(tree)
    )


def _of_moveit(attribute: str | None) -> str:
    """How to define what has an attribute of MoveIt's configuration; empty for other attributes."""
    of_configuration = attribute in data("moveit")["builder"][""].split()
    return "define it: MoveItConfigsBuilder(...).to_moveit_configs()" if of_configuration else ""


def _how_to_define(name: str, suggester: Suggester) -> str:
    """How to define a name: by an import, or the name that it stands for."""
    if name in _PLAIN_IMPORTS:
        return f"write import {name}"
    module = next(iter(modules_with(name)), None)
    if module:
        return f"write from {module} import {name}"
    suggested = suggester.suggested(name)
    return f"did you mean '{suggested}'?" if suggested else "define or import it"


def _wrong_imports(tree: ast.Module, values: Values) -> Iterator[Problem]:
    for node in tree.body:  # others may be an attempt that may fail
        module = node.module if isinstance(node, ast.ImportFrom) and not node.level else None
        if module is None or not isinstance(node, ast.ImportFrom):
            continue
        for alias in node.names:
            if help := _right_import(module, alias.name):
                yield values.problem("LAU035", node, f"module {module} has no {alias.name}", help)


def _right_import(module: str, name: str) -> str:
    """What to write instead of an import that fails; empty if it may not fail."""
    known = data("launch_python")["modules"].get(module, "").split()
    modules = modules_with(name)
    # Other modules also have what they import themselves.
    if modules and module not in modules and (known or nearest(module, modules, CLOSE_TYPO)):
        return f"write from {modules[0]} import {name}"
    is_class = name[:1].isupper()  # a module of launch is not
    suggested = nearest(name, known, TYPO) if is_class and not modules else None
    if suggested is None:
        return ""
    last, its_last = (re.sub(_HEAD, "", one) for one in (name, suggested))
    heads = name.removesuffix(last), suggested.removesuffix(its_last)
    is_meant = last != its_last or nearest(heads[0], heads[1:], TYPO)
    return f"write {suggested}" if is_meant else f"import a class that {module} has"


@lru_cache(1024)
def modules_with(name: str) -> tuple[str, ...]:
    """The modules of launch that have a name."""
    modules: dict[str, str] = data("launch_python")["modules"]
    return tuple(module for module, names in modules.items() if name in names.split())


def bound_names(tree: ast.Module) -> Iterator[str]:
    """All names that a file defines anywhere; ``*`` if it imports all names of a module."""
    for node in nodes(tree):
        if isinstance(node, (*_FUNCTIONS, ast.ClassDef)):
            yield node.name
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            for alias in node.names:
                yield alias.asname or alias.name.partition(".")[0]
        elif isinstance(node, ast.arg):
            yield node.arg
        elif isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            yield node.id
        elif isinstance(node, ast.ExceptHandler) and node.name:
            yield node.name
        elif isinstance(node, (ast.Global, ast.Nonlocal)):
            yield from node.names
        elif isinstance(node, ast.Match):
            yield "*"  # its patterns bind names


def _executed_nodes(tree: ast.Module) -> Iterator[tuple[ast.AST, bool]]:
    """The nodes of a file without annotations, and without functions that nothing calls.

    The second item is False for those that run only under a condition.
    """
    called = _reachable_names(tree)
    stack: list[tuple[ast.AST, bool]] = [(tree, True)]
    while stack:
        node, is_sure = stack.pop()
        if isinstance(node, _FUNCTIONS) and node.name not in called:
            continue
        yield node, is_sure
        is_sure = is_sure and not isinstance(node, _CONDITIONAL)
        inside: list[ast.AST] = []
        for field, value in ast.iter_fields(node):
            if field not in ("annotation", "returns"):
                children = value if isinstance(value, list) else [value]
                inside += [child for child in children if isinstance(child, ast.AST)]
        stack += [(child, is_sure) for child in reversed(inside)]  # the first one is the next


def _reachable_names(tree: ast.Module) -> set[str]:
    """The names outside of functions, and those in functions with such names, and so on."""
    functions = by_key((node.name, node) for node in nodes(tree) if isinstance(node, _FUNCTIONS))
    called: set[str] = set()
    waiting = [_ENTRY, *_names_below(tree)]
    while waiting:
        name = waiting.pop()
        if name not in called:
            called.add(name)
            for function in functions.get(name, ()):
                waiting += _names_below(function)
    return called


def _names_below(node: ast.AST) -> Iterator[str]:
    """The names below a node, without those in functions below it."""
    stack = list(ast.iter_child_nodes(node))
    while stack:
        child = stack.pop()
        if isinstance(child, ast.Name):
            yield child.id
        if not isinstance(child, _FUNCTIONS):
            stack += ast.iter_child_nodes(child)
