"""Launch files in XML and in YAML as the same kind of document.

ROS 2 reads both with the same action parsers: a mapping in YAML is an element, a single value in
it an attribute, and each item of a list an element.
Source: ``launch_yaml/entity.py`` of ros2/launch.
"""

from collections.abc import Sequence
from functools import lru_cache

from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import Attribute, Document, Element, Tag
from urdfkit.text.located_yaml import CACHE_SIZE, Key, Node, Value, items, load, syntax_error
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import read_xml

YAML = (".yaml", ".yml")
#: The key of the actions of a group, next to its attributes.
_CHILDREN = "children"
#: The key of the value of a parameter, which may be a list.
_VALUE = "value"


class _Placed(Attribute):
    """An attribute that is a value in YAML."""

    __slots__ = ("_value",)

    def __init__(self, name: str, value: Value, element: Element) -> None:
        super().__init__(name, value.text, element)
        self._value = value

    @property
    def span(self) -> Span:
        return self._value.span


class _Action(Element):
    """An element that is a mapping in YAML; its location is that of its key."""

    __slots__ = ("_span",)

    def __init__(self, tag: str, span: Span, parent: Element | None) -> None:
        super().__init__(tag, Tag(span.source, span.start, span.start), parent)
        self._span = span

    @property
    def span(self) -> Span:
        return self._span


@lru_cache(CACHE_SIZE)
def parsed(source: Source) -> tuple[Document | None, Sequence[Problem]]:
    """The document of a launch file (None if it is invalid), and the problems of its text."""
    if not source.path.endswith(YAML):
        return read_xml(source)
    if error := syntax_error(source, in_python=True):
        span, reason = error
        return None, (Problem("XML001", span, f"not YAML: {reason}"),)
    for key, actions in items(load(source)):
        if key == "launch":
            root = _Action("launch", key.span, None)
            _fill(root, actions)
            return Document(root, (source,)), ()
    return None, ()


def _fill(element: Element, node: Node) -> None:
    """Add the contents of a YAML node to an element, to a bounded depth."""
    for item in node if isinstance(node, list) else (node,):
        for key, value in items(item):
            if isinstance(value, Value):
                element.attributes[key] = _Placed(key, value, element)
            elif key == _VALUE and (listed := _list(value)):
                element.attributes[key] = _Placed(key, listed, element)
            elif key == _CHILDREN:
                _fill(element, value)
            else:
                _add(element, key, value)


def _list(node: Node) -> Value | None:
    """A list of values as the text that stands for it in XML; None for any other node."""
    every = node if isinstance(node, list) else []
    values = [item for item in every if isinstance(item, Value)]
    if not values or len(values) != len(every):
        return None
    return values[0]._replace(text=f"[{', '.join(value.text for value in values)}]")


def _add(parent: Element, key: Key, node: Node) -> None:
    """Add an action, or each of several actions under a key."""
    is_several = isinstance(node, list) and key in _SEVERAL
    for item in node if isinstance(node, list) and is_several else (node,):
        child = _Action(key, key.span, parent)
        parent.children.append(child)
        _fill(child, item)


#: Keys whose list has an element per item; the lists of other keys are children of an element.
_SEVERAL = frozenset(("arg", "env", "let", "param", "remap", "composable_node", "extra_arg"))
