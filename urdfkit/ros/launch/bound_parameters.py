"""The arguments of functions in a Python launch file that are called once, as each copy is."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from functools import lru_cache

from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.text.python_source import CACHE_SIZE, dotted_name, nodes

#: The class that calls a function with the launch context, then with its own ``args``.
_OPAQUE = "OpaqueFunction"
#: The key of ``**`` in a call.
_OTHERS = "**"


class Binding(Record):
    """The call of a function, and the expressions that it passes, by parameter."""

    call: ast.Call
    passed: dict[str, ast.expr]


@lru_cache(CACHE_SIZE)
def bound_parameters(tree: ast.Module) -> dict[ast.FunctionDef, Binding]:
    """The parameters of each function that is called in one place, with the expressions passed.

    A function that is used in any other way, or defined twice, is not known. Of a function with a
    copy for each call (see ``repeated_calls``), any copy may be that of any call.
    """
    defined = by_key((node.name, node) for node in nodes(tree) if isinstance(node, ast.FunctionDef))
    uses = Counter(node.id for node in nodes(tree) if isinstance(node, ast.Name))
    free = {
        name: [*functions]
        for name, functions in defined.items()
        if len(functions) == uses[name] and len({node.lineno for node in functions}) == 1
    }
    found = {}
    for call in nodes(tree):
        if isinstance(call, ast.Call) and (target := _target(call)):
            name, positional, keywords = target
            if free.get(name):
                function = free[name].pop(0)
                bound = dict(_bound(function, positional, keywords))
                passed = {name: bound[name] for name in bound.keys() - _asked(function)}
                found[function] = Binding(call, passed)
    return found


def _asked(function: ast.FunctionDef) -> set[str]:
    """The names whose type a function asks: other files call it with other types."""
    asked = [node for node in ast.walk(function) if isinstance(node, ast.Call) and node.args]
    owners = [node.args[0] for node in asked if dotted_name(node.func) == "isinstance"]
    return {owner.id for owner in owners if isinstance(owner, ast.Name)}


def _target(call: ast.Call) -> tuple[str, list[ast.expr | None], dict[str, ast.expr]] | None:
    """The name of the called function, and its arguments; None stands for an unknown one."""
    if not isinstance(call.func, ast.Name):
        return None
    keywords = {keyword.arg or _OTHERS: keyword.value for keyword in call.keywords}
    if call.func.id != _OPAQUE:
        return call.func.id, list(call.args), keywords
    function = keywords.get("function")
    if not isinstance(function, ast.Name):
        return None
    passed, named = keywords.get("args"), keywords.get("kwargs")
    positional = passed.elts if isinstance(passed, (ast.List, ast.Tuple)) else []
    return function.id, [None, *positional], dict(_items(named))


def _items(node: ast.expr | None) -> Iterator[tuple[str, ast.expr]]:
    if isinstance(node, ast.Dict):
        for key, value in zip(node.keys, node.values, strict=True):
            if isinstance(key, ast.Constant) and isinstance(key.value, str):
                yield key.value, value


def _bound(
    function: ast.FunctionDef, positional: list[ast.expr | None], keywords: dict[str, ast.expr]
) -> Iterator[tuple[str, ast.expr]]:
    names = [parameter.arg for parameter in (*function.args.posonlyargs, *function.args.args)]
    defaults = function.args.defaults
    named = zip(function.args.kwonlyargs, function.args.kw_defaults, strict=True)
    of_named = {parameter.arg: default for parameter, default in named if default is not None}
    passed = dict(zip(reversed(names), reversed(defaults), strict=False)) | of_named | keywords
    is_whole = not any(isinstance(value, ast.Starred) for value in positional)
    for name, value in zip(names, positional, strict=False) if is_whole else ():
        passed.pop(name, None)
        if value is not None:
            passed[name] = value
    yield from passed.items() if is_whole else keywords.items()
    if function.args.vararg and is_whole:
        rest = positional[len(names) :]
        known = [value for value in rest if value is not None]
        if len(known) == len(rest):
            yield function.args.vararg.arg, ast.Tuple(known, ast.Load())
    if function.args.kwarg and _OTHERS not in keywords:
        names += [parameter.arg for parameter in function.args.kwonlyargs]
        others = {name: value for name, value in keywords.items() if name not in names}
        keys = [ast.copy_location(ast.Constant(name), value) for name, value in others.items()]
        yield function.args.kwarg.arg, ast.Dict(list(keys), list(others.values()))
