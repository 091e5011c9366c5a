"""YAML files that ``xacro.load_yaml`` reads, fenced in and bounded."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import Any

from urdfkit.expansion.trace import Mark

#: Scalars of one YAML file, counted as often as aliases repeat them; and keys of one table, all
#: of which are compared with each other if they hash alike.
MAX_VALUES = 100_000
MAX_KEYS = 10_000
#: Levels of a YAML file. libyaml builds it by recursion, in C, where the end is a crash.
MAX_LEVELS = 100

#: xacro's units: tag, factor to radians or metres.
_UNITS = {
    "!radians": 1.0,
    "!degrees": math.pi / 180.0,
    "!meters": 1.0,
    "!millimeters": 0.001,
    "!foot": 0.3048,
    "!inches": 0.0254,
}


class YamlTooLarge(Exception):
    """The file, with its aliases, is larger or deeper than any configuration."""


@lru_cache(maxsize=1)
def _loader() -> Any:
    import yaml  # 15 ms, and few models load YAML

    base: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)  # libyaml's is six times faster

    class Loader(base):  # type: ignore[misc] # of its own, so that no other user of yaml sees it
        evaluate: Callable[[str], Any]

    def unit(factor: float) -> Callable[[Any, Any], float]:
        def construct(loader: Any, node: Any) -> float:
            return float(loader.evaluate(loader.construct_scalar(node))) * factor

        return construct

    for tag, factor in _UNITS.items():
        Loader.add_constructor(tag, unit(factor))
    return Loader


class _MarkedFloat(float):
    mark: Mark


class _MarkedInt(int):
    mark: Mark


class _MarkedText(str):
    mark: Mark


_MARKED: dict[type, Any] = {float: _MarkedFloat, int: _MarkedInt, str: _MarkedText}


def _marking(base: Any, path: str) -> Any:
    """A loader whose numbers and texts know where they stand."""

    class Marking(base):  # type: ignore[misc]
        def construct_object(self, node: Any, deep: bool = False) -> Any:
            value = super().construct_object(node, deep)
            marked = _MARKED.get(type(value))
            if marked is None:
                return value
            value = marked(value)
            value.mark = Mark(path, node.start_mark.line + 1, node.start_mark.column + 1)
            return value

    return Marking


def load(text: str, evaluate: Callable[[str], Any], *, marked_as: str | None = None) -> Any:
    """The value of a YAML text.

    Args:
        text: of the file.
        evaluate: gives the value of an expression behind a unit, such as ``!degrees 90/2``.
        marked_as: a path; numbers and texts then carry their place as ``mark``.

    Raises:
        yaml.YAMLError: it is not YAML.
        YamlTooLarge: it is too deep, or its aliases multiply it.
    """
    _check_levels(text)
    kind = _loader() if marked_as is None else _marking(_loader(), marked_as)
    loader = kind(text)
    loader.evaluate = evaluate
    try:
        node = loader.get_single_node()
        if node is None:
            return None
        _check_size(node)
        return loader.construct_document(node)
    finally:
        loader.dispose()


def _check_levels(text: str) -> None:
    """Count the levels from the parser's events, which are read without recursion."""
    inline = sum(text.count(opening) for opening in ("[", "{", "- ", "? "))
    if inline <= MAX_LEVELS and "\n" + " " * MAX_LEVELS not in text:
        return
    import yaml

    level = 0
    for event in yaml.parse(text, _loader()):
        if isinstance(event, yaml.CollectionStartEvent):
            level += 1
            if level > MAX_LEVELS:
                raise YamlTooLarge(f"more than {MAX_LEVELS} levels")
        elif isinstance(event, yaml.CollectionEndEvent):
            level -= 1


def _check_size(root: Any) -> None:
    """Count the values that a node stands for, each alias as a copy; without recursion."""
    sizes: dict[int, int] = {}
    open_nodes: set[int] = set()
    stack = [(root, False)]
    while stack:
        node, done = stack.pop()
        key = id(node)
        inner = _inner(node)
        if done:
            open_nodes.discard(key)
            sizes[key] = 1 + sum(sizes.get(id(child), 1) for child in inner)
            if sizes[key] > MAX_VALUES:
                raise YamlTooLarge(f"more than {MAX_VALUES} values")
            if len(inner) > 2 * MAX_KEYS and isinstance(node.value[0], tuple):
                raise YamlTooLarge(f"a table of more than {MAX_KEYS} keys")
        elif key in open_nodes:
            raise YamlTooLarge("a value contains itself")
        elif key not in sizes:
            open_nodes.add(key)
            stack.append((node, True))
            stack.extend((child, False) for child in inner)


def _inner(node: Any) -> list[Any]:
    value = node.value
    if not isinstance(value, list):
        return []
    return [part for item in value for part in (item if isinstance(item, tuple) else (item,))]
