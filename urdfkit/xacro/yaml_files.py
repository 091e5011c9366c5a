"""Bounded reading of YAML files for ``xacro.load_yaml``."""

import math
from collections.abc import Callable
from functools import lru_cache

from urdfkit.core.static_typing import Any
from urdfkit.text.located_yaml import loader_as_in_python
from urdfkit.text.source import Source, Span
from urdfkit.xacro.errors import BrokenYaml

#: Scalars of one YAML file, with repetitions by aliases; and keys of one table, which are all
#: compared with each other if their hashes are equal.
MAX_VALUES = 100_000
MAX_KEYS = 10_000
#: Keys that are not strings, whose hashes may be equal.
MAX_NUMBERS = 1000
#: Characters of a number: PyYAML parses ``1:1:1``, in base 60, in quadratic time.
MAX_DIGITS = 300
#: Levels of a YAML file. libyaml uses recursion in C, which crashes if it is too deep.
MAX_LEVELS = 100
#: The error of libyaml 0.2.6, which reads ahead, for more than 1,000 levels.
_TOO_DEEP = "exceeded maximum nesting depth"

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


@lru_cache(maxsize=2)
def _loader(base: Any) -> Any:
    class Loader(base):  # type: ignore[misc] # a subclass, so that other users of yaml do not see it
        evaluate: Callable[[str], Any]

    def unit(factor: float) -> Callable[[Any, Any], float]:
        def construct(loader: Any, node: Any) -> float:
            return float(loader.evaluate(loader.construct_scalar(node))) * factor

        return construct

    for tag, factor in _UNITS.items():
        Loader.add_constructor(tag, unit(factor))
    return Loader


class _Located:
    """A value with a source location."""

    location: tuple[Source, Any, Any]  # the file, and libyaml's marks of start and end

    @property
    def span(self) -> Span:
        return _span(*self.location)


class _LocatedFloat(_Located, float):
    pass


class _LocatedInt(_Located, int):
    pass


class _LocatedText(_Located, str):
    pass


_LOCATED: dict[type, Any] = {float: _LocatedFloat, int: _LocatedInt, str: _LocatedText}


def _locating_loader(base: Any, source: Source) -> Any:
    """A loader whose numbers and texts have source locations."""

    class LocatingLoader(base):  # type: ignore[misc]
        def construct_object(self, node: Any, deep: bool = False) -> Any:
            value = super().construct_object(node, deep)
            located_type = _LOCATED.get(type(value))
            if located_type is None:
                return value
            value = located_type(value)
            value.location = source, node.start_mark, node.end_mark
            return value

    return LocatingLoader


def _span(source: Source, start: Any, end: Any) -> Span:
    first = source.offset(start.line + 1, start.column + 1)
    return Span(source, first, max(first, source.offset(end.line + 1, end.column + 1)))


def load(source: Source, evaluate: Callable[[str], Any], *, located: bool = False) -> Any:
    """The value of a YAML file.

    Args:
        evaluate: returns the value of an expression after a unit, such as ``!degrees 90/2``.
        located: True to return numbers and texts with a ``span``.

    Raises:
        BrokenYaml: it is not YAML.
        YamlTooLarge: it is too deep, or too large with its aliases.
    """
    import yaml

    text = source.data.decode("utf-8")
    loader_type = _loader(loader_as_in_python(text))
    if located:
        loader_type = _locating_loader(loader_type, source)
    try:
        _check_levels(text)
        loader = loader_type(text)
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
        if error.problem == _TOO_DEEP:
            raise YamlTooLarge(f"more than {MAX_LEVELS} levels") from error
        mark = error.problem_mark or error.context_mark
        reason = error.problem or "it cannot be read"
        raise BrokenYaml(str(error), _span(source, mark, mark), reason) from error


def _check_levels(text: str) -> None:
    """Reject too many levels, counted from the parser's events, which need no recursion."""
    inline = sum(text.count(opening) for opening in ("[", "{", "- ", "? "))
    if inline <= MAX_LEVELS and "\n" + " " * MAX_LEVELS not in text:
        return
    import yaml

    level = 0
    for event in yaml.parse(text, loader_as_in_python(text)):
        if isinstance(event, yaml.CollectionStartEvent):
            level += 1
            if level > MAX_LEVELS:
                raise YamlTooLarge(f"more than {MAX_LEVELS} levels")
        elif isinstance(event, yaml.CollectionEndEvent):
            level -= 1


def _check_size(root: Any) -> None:
    """Reject too many values, with each alias counted as a copy; without recursion."""
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
    """Reject a number, or a table, that takes too long to construct."""
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
