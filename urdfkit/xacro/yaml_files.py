"""YAML files that ``xacro.load_yaml`` reads, within bounds."""

import math
from collections.abc import Callable
from functools import lru_cache

from urdfkit.core.static_typing import Any
from urdfkit.text.source import Source, Span
from urdfkit.xacro.errors import BrokenYaml

#: Scalars of one YAML file, counted as often as aliases repeat them; and keys of one table, all
#: of which are compared with each other if they hash alike.
MAX_VALUES = 100_000
MAX_KEYS = 10_000
#: Of the keys, those that are no texts, and may hash alike.
MAX_NUMBERS = 1000
#: Characters of a number: PyYAML reads ``1:1:1``, to the base of 60, in quadratic time.
MAX_DIGITS = 300
#: Levels of a YAML file. libyaml builds it by recursion, in C, where the end is a crash.
MAX_LEVELS = 100

_NUMBERS = frozenset(f"tag:yaml.org,2002:{kind}" for kind in ("int", "float"))

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


class _Placed:
    """A value that knows where it stands."""

    place: tuple[Source, Any, Any]  # the file, and libyaml's marks of its ends

    @property
    def span(self) -> Span:
        return _span(*self.place)


class _PlacedFloat(_Placed, float):
    pass


class _PlacedInt(_Placed, int):
    pass


class _PlacedText(_Placed, str):
    pass


_PLACED: dict[type, Any] = {float: _PlacedFloat, int: _PlacedInt, str: _PlacedText}


def _placing(base: Any, source: Source) -> Any:
    """A loader whose numbers and texts know where they stand."""

    class Placing(base):  # type: ignore[misc]
        def construct_object(self, node: Any, deep: bool = False) -> Any:
            value = super().construct_object(node, deep)
            placed = _PLACED.get(type(value))
            if placed is None:
                return value
            value = placed(value)
            value.place = source, node.start_mark, node.end_mark
            return value

    return Placing


def _span(source: Source, start: Any, end: Any) -> Span:
    first = source.offset(start.line + 1, start.column + 1)
    return Span(source, first, max(first, source.offset(end.line + 1, end.column + 1)))


def load(source: Source, evaluate: Callable[[str], Any], *, placed: bool = False) -> Any:
    """The value of a YAML file.

    Args:
        source: the file.
        evaluate: gives the value of an expression behind a unit, such as ``!degrees 90/2``.
        placed: True if numbers and texts are to have their place as ``span``.

    Raises:
        BrokenYaml: it is not YAML.
        YamlTooLarge: it is too deep, or its aliases multiply it.
    """
    import yaml

    text = source.data.decode("utf-8")
    kind = _placing(_loader(), source) if placed else _loader()
    try:
        _check_levels(text)
        loader = kind(text)
        try:
            loader.evaluate = evaluate
            node = loader.get_single_node()
            if node is None:
                return None
            _check_size(node)
            return loader.construct_document(node)
        finally:
            loader.dispose()
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        reason = error.problem or "it cannot be read"
        raise BrokenYaml(str(error), _span(source, mark, mark), reason) from error


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
            _check_keys(node)
        elif key in open_nodes:
            raise YamlTooLarge("a value contains itself")
        elif key not in sizes:
            open_nodes.add(key)
            stack.append((node, True))
            stack.extend((child, False) for child in inner)


def _check_keys(node: Any) -> None:
    """Refuse a number, or a table, that takes too long to make."""
    if not isinstance(node.value, list):
        if node.tag in _NUMBERS and len(node.value) > MAX_DIGITS:
            raise YamlTooLarge(f"a number of more than {MAX_DIGITS} characters")
        return
    keys = [key for key, _ in filter(lambda item: isinstance(item, tuple), node.value)]
    numbers = sum(key.tag != "tag:yaml.org,2002:str" for key in keys)
    if len(keys) > MAX_KEYS or numbers > MAX_NUMBERS:
        raise YamlTooLarge(f"a table of more than {MAX_KEYS} keys, or {MAX_NUMBERS} numbers")


def _inner(node: Any) -> list[Any]:
    value = node.value
    if not isinstance(value, list):
        return []
    return [part for item in value for part in (item if isinstance(item, tuple) else (item,))]
