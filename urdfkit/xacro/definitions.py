"""Macros, properties and arguments that the files of an expansion define."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.text.diagnostic import Problem, Related
from urdfkit.text.document import CallFrame, Tag
from urdfkit.text.source import Source
from urdfkit.xacro.dom import Node
from urdfkit.xacro.origin import Origin

#: Contains spaces: the attributes of a xacro namespace are its keys, and no model has this key.
_KEY = "annotations of urdfkit"


class Definition(Record):
    """A definition of a macro, a property or an argument."""

    name: str
    tag: Tag  # the defining tag
    frame: CallFrame | None  # the calls that led to the definition
    attributes: dict[str, str]  # of the tag, as written


class TableAnnotations:
    """Notes of urdfkit on the names in one of xacro's tables of properties and parameters."""

    __slots__ = ("definers", "inputs", "used")

    def __init__(self) -> None:
        self.definers: dict[str, Node] = {}  # the elements that define the names
        self.used: set[str] = set()  # names that were looked up since their definition
        #: The names that the expressions of the values looked up, if the run is traced.
        self.inputs: dict[str, tuple[Origin, ...]] = {}


def annotations_of(table: Any) -> TableAnnotations:
    """The annotations of a table; empty for built-in names, which are not in such a table."""
    variables: dict[str, Any] = getattr(table, "__dict__", {})
    annotations: TableAnnotations | None = variables.get(_KEY)
    if annotations is None:
        annotations = variables[_KEY] = TableAnnotations()
    return annotations


class Definitions:
    """The definitions of the files, in order, and the values of the arguments."""

    def __init__(
        self, source: Source, sources: Mapping[str, Source], values: Mapping[str, str]
    ) -> None:
        self.source = source  # the checked file
        self.sources = sources  # the xacro files that were read, by path
        self.values = dict(values)  # of ``xacro:arg`` by name, as passed by the user
        self.macros: list[Definition] = []
        self.properties: list[Definition] = []
        self.arguments: list[Definition] = []  # every ``xacro:arg`` of the files, evaluated or not
        #: The defaults of the arguments as written, and the elements that define them, by name.
        self.argument_defaults: dict[str, str] = {}
        self.defaulting_nodes: dict[str, Node] = {}

    def add_arguments(self, nodes: Iterable[Node]) -> None:
        for node in nodes:
            argument = _definition(node)
            self.arguments.append(argument)
            default = argument.attributes.get("default")
            self.argument_defaults.setdefault(argument.name, default or "")
            if default is not None:
                self.defaulting_nodes.setdefault(argument.name, node)

    def add_macro(self, node: Node) -> None:
        name = node.getAttribute("name").removeprefix("xacro:")
        self.macros.append(_definition(node)._replace(name=name))

    def add_value(self, table: Any, key: str, definer: Any) -> Problem | None:
        """Add a property or a macro parameter with a value; returns a problem with it, if any."""
        if not isinstance(definer, Node):
            return None
        annotations = annotations_of(table)
        problem = None
        if definer.tagName == "xacro:property":
            self.properties.append(_definition(definer)._replace(name=key))
            if key not in annotations.used and not key.startswith("**"):
                problem = _redefinition(key, definer, annotations.definers.get(key))
        annotations.definers[key] = definer
        annotations.used.discard(key)
        return problem


def _redefinition(key: str, node: Node, earlier: Node | None) -> Problem | None:
    """The problem of a property that is redefined in the same block before its value is used."""
    if earlier is None:
        return None
    first, second = earlier.tag_at, node.tag_at
    same_block = first.source is second.source and earlier.parent_start == node.parent_start
    same_value = earlier.raw_attributes().get("value") == node.raw_attributes().get("value")
    if not same_block or same_value or earlier.tagName != node.tagName or first == second:
        return None
    message = f"property '{key}' is defined again before its first value is used"
    span = second.attribute_spans().get("name", second.span)
    related = (Related(first.span, "first defined here"),)
    return Problem("XAC008", span, message, frame=node.frame, related=related)


def _definition(node: Node) -> Definition:
    return Definition(node.getAttribute("name"), node.tag_at, node.frame, node.raw_attributes())
