"""The calls of a Python program that depend on an if statement."""

import ast
from collections.abc import Iterator
from functools import lru_cache

from urdfkit.text.python_source import CACHE_SIZE, nodes


@lru_cache(CACHE_SIZE)
def decided_calls(tree: ast.Module) -> frozenset[ast.Call]:
    """The calls that run, or whose value is used, only in one branch of the program."""
    within: set[ast.AST] = set(_decided(tree))
    names = [node for node in nodes(tree) if isinstance(node, ast.Name)]
    loads = [node for node in names if isinstance(node.ctx, ast.Load)]
    always = {node.id for node in loads if node not in within}
    sometimes = {node.id for node in loads} - always
    for node in nodes(tree):
        if isinstance(node, ast.Assign) and _names(node.targets) & sometimes:
            within.update(ast.walk(node.value))
    return frozenset(node for node in within if isinstance(node, ast.Call))


def _decided(tree: ast.Module) -> Iterator[ast.AST]:
    stack: list[tuple[ast.AST, bool]] = [(tree, False)]
    while stack:
        node, is_conditional = stack.pop()
        if is_conditional:
            yield node
        is_branch = isinstance(node, (ast.If, ast.IfExp, ast.match_case))
        for name, value in ast.iter_fields(node):
            may_not_run = is_conditional or (is_branch and name != "test")
            for child in value if isinstance(value, list) else [value]:
                if isinstance(child, ast.AST):
                    stack.append((child, may_not_run))
                    # The statements after a branch that returns are the other branch.
                    may_not_run = may_not_run or _returns(child)


def _returns(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and any(isinstance(child, ast.Return) for child in node.body)


def _names(targets: list[ast.expr]) -> set[str]:
    return {node.id for node in targets if isinstance(node, ast.Name)}
