"""What the files of one expansion define: macros, properties and arguments."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.text.diagnostic import Problem, Related
from urdfkit.text.document import CallFrame, Tag
from urdfkit.text.source import Source
from urdfkit.xacro.dom import Node
from urdfkit.xacro.origin import Origin

#: Holds spaces: a name space of xacro makes keys of its attributes, and no model has this one.
_KEY = "annotations of urdfkit"


class Definition(Record):
    """Something that a xacro file defines: a macro, a property or an argument."""

    name: str  # of it
    tag: Tag  # the defining tag
    frame: CallFrame | None  # the calls that led to the definition
    attributes: dict[str, str]  # of the tag, as written


class TableAnnotations:
    """What urdfkit knows of the names in one of xacro's tables of properties and parameters."""

    __slots__ = ("definers", "inputs", "used")

    def __init__(self) -> None:
        self.definers: dict[str, Node] = {}  # the elements that define them
        self.used: set[str] = set()  # those that were looked up since
        #: What the expressions of their values looked up, if the run is traced.
        self.inputs: dict[str, tuple[Origin, ...]] = {}


def annotations_of(table: Any) -> TableAnnotations:
    """The annotations of a table; the built-in names are in no such table and have none."""
    variables: dict[str, Any] = getattr(table, "__dict__", {})
    found: TableAnnotations | None = variables.get(_KEY)
    if found is None:
        found = variables[_KEY] = TableAnnotations()
    return found


class Definitions:
    """What the files define, in order, and the arguments that they are given."""

    def __init__(
        self, source: Source, sources: Mapping[str, Source], given: Mapping[str, str]
    ) -> None:
        self.source = source  # the checked file
        self.sources = sources  # the xacro files that were read, by path
        self.given = dict(given)  # values of ``xacro:arg`` by name
        #: macros and properties: everything that was defined.
        self.macros: list[Definition] = []
        self.properties: list[Definition] = []
        self.arguments: list[Definition] = []  # every ``xacro:arg`` of the files, evaluated or not
        self.argument_nodes: list[Node] = []  # their elements

    def add_arguments(self, nodes: Iterable[Node]) -> None:
        for node in nodes:
            self.argument_nodes.append(node)
            self.arguments.append(_definition(node))

    def add_macro(self, node: Node) -> None:
        name = node.getAttribute("name").removeprefix("xacro:")
        self.macros.append(_definition(node)._replace(name=name))

    def add_value(self, table: Any, key: str, definer: Any) -> Problem | None:
        """Add a property or a macro parameter that gets a value; what is odd about it."""
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

    def argument_defaults(self) -> dict[str, str]:
        """The arguments that the files declare, with their defaults as written."""
        defaults: dict[str, str] = {}
        for argument in self.arguments:
            defaults.setdefault(argument.name, argument.attributes.get("default", ""))
        return defaults


def _redefinition(key: str, node: Node, earlier: Node | None) -> Problem | None:
    """A property that gets a second value in one block before its first one is used."""
    if earlier is None:
        return None
    one, other = earlier.tag_at, node.tag_at
    same_block = one.source is other.source and earlier.around == node.around
    same_value = earlier.written().get("value") == node.written().get("value")
    if not same_block or same_value or earlier.tagName != node.tagName or one == other:
        return None
    message = f"property '{key}' is defined again before its first value is used"
    span = other.attribute_spans().get("name", other.span)
    related = (Related(one.span, "first defined here"),)
    return Problem("XAC008", span, message, frame=node.frame, related=related)


def _definition(node: Node) -> Definition:
    return Definition(node.getAttribute("name"), node.tag_at, node.frame, node.written())
