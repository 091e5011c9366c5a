"""YAML values with source locations.

They are built from the parser's events, without recursion and without aliases: parameter files
have few levels, and a deeper file is not one.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Any, TypeAlias

from urdfkit.core.record import Record
from urdfkit.text.source import Source, Span

#: Larger files are not parameter files.
MAX_BYTES = 1024 * 1024
#: RViz stores the tree of frames, which has 40 levels for a humanoid.
MAX_LEVELS = 100
#: Files whose values are cached: the launch files of a workspace refer to the same files often.
CACHE_SIZE = 64
#: Characters of values that only launch or a template resolves.
TEMPLATE_MARKS = ("$", "<", "{")
#: What the scanner says of a line that is no pair of a key and a value, as ``a:1`` is none.
_NO_COLON = "could not find expected ':'"
_JOINED = re.compile(r"[\w./-]+:[^\s:]")

_TRUE, _FALSE = ("true", "yes", "on", "y"), ("false", "no", "off", "n")


class Value(Record):
    """A scalar, with line and column of its start and end, from 0, and its tag (``!degrees``)."""

    text: str
    source: Source
    start: tuple[int, int]
    end: tuple[int, int]
    tag: str = ""

    @property
    def span(self) -> Span:
        """Source location, computed on demand: the lines of a hostile file are long."""
        start, end = (self.source.offset(line + 1, column + 1) for line, column in self[2:4])
        return Span(self.source, start, end)

    @property
    def boolean(self) -> bool | None:
        """None for a text that is neither true nor false in YAML 1.1."""
        text = self.text.lower()
        return text in _TRUE if text in _TRUE + _FALSE else None


class Key(str):
    """A key of a mapping, with its source location."""

    __slots__ = ("at",)
    at: Value

    @property
    def span(self) -> Span:
        return self.at.span


#: None stands for an alias. Keys that are scalars are ``Key``.
Node: TypeAlias = "Value | list[Node] | dict[str, Node] | None"


@lru_cache(CACHE_SIZE)
def load(source: Source) -> Node:
    """The value of a file, shared and not to be changed; None if it is not YAML."""
    if len(source.data) > MAX_BYTES:
        return None
    import yaml  # 15 ms, and few models refer to a parameter file

    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        return _compose(source, yaml.parse(source.data, loader))
    except yaml.YAMLError:
        return None


def loader_as_in_python(text: bytes | str) -> Any:
    """PyYAML's fastest loader that reads a text as ``yaml.safe_load`` does.

    libyaml is six times faster, but accepts tabs that PyYAML's own loader rejects, and vice versa.
    """
    import yaml

    has_tabs = b"\t" in text if isinstance(text, bytes) else "\t" in text
    return yaml.SafeLoader if has_tabs else getattr(yaml, "CSafeLoader", yaml.SafeLoader)


def mapping(node: Node, *keys: str) -> dict[str, Node]:
    """The mapping at a path of keys; empty if there is none."""
    for key in keys:
        node = node.get(key) if isinstance(node, dict) else None
    return node if isinstance(node, dict) else {}


def scalar(node: Node, *keys: str) -> Value | None:
    """The scalar at a path of keys; None if there is none."""
    for key in keys:
        node = mapping(node).get(key)
    return node if isinstance(node, Value) else None


def words(node: Node, *keys: str) -> list[str]:
    """The words of the scalar at a path of keys, which stand between spaces."""
    value = scalar(node, *keys)
    return value.text.split() if value else []


def scalars(node: Node) -> list[Value]:
    """The scalars of a list; empty if the node is not a list."""
    return [item for item in node if isinstance(item, Value)] if isinstance(node, list) else []


def is_template(text: str) -> bool:
    """True for a text that only launch or a template resolves."""
    return any(mark in text for mark in TEMPLATE_MARKS)


def items(node: Node, *path: str) -> Iterator[tuple[Key, Node]]:
    """The keys and values of the mapping at a path of keys; none if there is no mapping."""
    for key, value in mapping(node, *path).items():
        if isinstance(key, Key):
            yield key, value


def entries(node: Node) -> Iterator[tuple[Key, Node]]:
    """The keys of a mapping and of the mappings in it, with their values."""
    stack = [node]
    while stack:
        for key, value in items(stack.pop()):
            yield key, value
            stack.append(value)


def _compose(source: Source, events: Iterable[Any]) -> Node:
    """The value of a stream of events; None if it is too deep.

    Raises:
        yaml.YAMLError: it is not YAML.
    """
    import yaml

    top: list[Node] = []
    stack: list[Node] = [top]  # the open collections
    keys: list[str | None] = [None]  # the pending key of each open collection
    for event in events:
        if isinstance(event, yaml.DocumentEndEvent):
            break
        if isinstance(event, yaml.CollectionEndEvent):
            stack.pop()
            keys.pop()
            continue
        node = _continued(stack[-1], keys[-1], _node(source, event))
        if isinstance(event, yaml.NodeEvent):
            keys[-1] = _add(stack[-1], keys[-1], node)
        if isinstance(event, yaml.CollectionStartEvent):
            stack.append(node)
            keys.append(None)
            if len(stack) > MAX_LEVELS:
                return None
    return top[0] if top else None


def _add(owner: Node, key: str | None, node: Node) -> str | None:
    """Add a node to its collection; returns the key that is pending then."""
    if isinstance(owner, list):
        owner.append(node)
    elif isinstance(owner, dict) and key is None:
        return _key(node)
    elif isinstance(owner, dict) and key is not None:
        owner[key] = node
    return None


def _continued(owner: Node, key: str | None, node: Node) -> Node:
    """The mapping to fill: mappings of a repeated key, such as ``/**``, are merged as in ROS 2."""
    if isinstance(owner, dict) and isinstance(node, dict) and key is not None:
        before = owner.get(key)
        return before if isinstance(before, dict) else node
    return node


def _key(node: Node) -> str:
    if not isinstance(node, Value):
        return ""
    key = Key(node.text)
    key.at = node
    return key


@lru_cache(CACHE_SIZE)
def syntax_error(source: Source, *, in_python: bool = False) -> tuple[Span, str] | None:
    """Location and message of the first syntax error; None if the file is valid YAML.

    Args:
        in_python: True if a program in Python reads it, which rejects most tabs; ROS 2 and Gazebo
            read parameters by libyaml, which accepts them before a comment or a value.
    """
    if len(source.data) > MAX_BYTES:
        return None
    if (at := source.undecodable) is not None:  # also in a comment
        return Span(source, at, at + 1), f"this byte is not {source.encoding}"
    import yaml

    loader: Any = yaml.SafeLoader
    if not in_python and b"\t" in source.data:
        loader = getattr(yaml, "CSafeLoader", loader)
    level = 0
    try:
        for event in yaml.parse(source.data, loader):
            level += isinstance(event, yaml.CollectionStartEvent)
            level -= isinstance(event, yaml.CollectionEndEvent)
            mark = event.start_mark
            if level > MAX_LEVELS and mark:
                at = source.offset(mark.line + 1, mark.column + 1)
                return Span(source, at, at + 1), f"more than {MAX_LEVELS} levels"
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        reason = error.problem or str(error)
        if reason == _NO_COLON and error.context_mark:  # the other mark is in a later line
            mark = error.context_mark
            if _JOINED.match(source.line(mark.line + 1)[mark.column :]):
                reason = "no space after the colon"
        start = source.offset(mark.line + 1, mark.column + 1) if mark else 0
        return Span(source, start, start), reason
    except yaml.YAMLError as error:  # a character that YAML does not allow
        return Span(source, 0, 0), str(error).partition("\n")[0]
    return None


def _node(source: Source, event: Any) -> Node:
    import yaml

    if isinstance(event, yaml.ScalarEvent):
        ends: tuple[Any, Any] = (event.start_mark, event.end_mark)
        start, end = ((mark.line, mark.column) for mark in ends)
        return Value(event.value, source, start, end, event.tag or "")
    if isinstance(event, yaml.MappingStartEvent):
        return {}
    return [] if isinstance(event, yaml.SequenceStartEvent) else None  # None for an alias
