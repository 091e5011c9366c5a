"""Origins of values, through expressions, macro arguments, properties and YAML files.

Tracing is a separate expansion, run on request: it records the names that every expression looks
up, and the origin of their values.
"""

import reprlib
from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from itertools import chain
from types import FrameType

from urdfkit.core.static_typing import Any
from urdfkit.core.words import listed
from urdfkit.text.diagnostic import Related
from urdfkit.text.document import Attribute, Element
from urdfkit.text.source import Source, Span
from urdfkit.xacro.definitions import Definitions, annotations_of
from urdfkit.xacro.dom import ELEMENT, Dom, Node
from urdfkit.xacro.origin import DataPlaces, Origin

#: Elements that consist of numbers, with the attributes that a robot needs.
_NUMBERS = {
    "axis": {"xyz"},
    "inertia": {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"},
    "limit": {"lower", "upper", "effort", "velocity"},
    "mass": {"value"},
    "origin": {"xyz"},
}


class Tracer:
    """Records the names that expressions look up during an expansion."""

    def __init__(self, defined: Definitions) -> None:
        self._defined = defined
        self._collected: list[dict[str, Origin]] = []
        self._last: tuple[Origin, ...] = ()
        #: What was looked up outside of expressions: the values of parameters with the default
        #: ``^``, which have them from outside of the macro.
        self._forwarded: dict[str, Origin] = {}
        self._definition: Callable[[Node, str], tuple[str, Span, str]] = cache(_definition)

    def begin(self) -> None:
        """Called before the evaluation of a text."""
        self._collected.append({})
        self._forwarded.clear()

    def end(self, text: str, frame: FrameType) -> None:
        """Called after the evaluation of a text; assigns its inputs to the evaluated attribute."""
        self._last = tuple(self._collected.pop().values())
        local = frame.f_locals
        node = local.get("node")
        if isinstance(node, Node) and local.get("value") is text and "name" in local:
            node.traces = {**(node.traces or {}), local["name"]: self._last}

    def defined(self, table: Any, key: str) -> None:
        """Record that a name has the value of the text that was evaluated last."""
        annotations = annotations_of(table)
        definer = annotations.definers.get(key)
        if forwarded := self._forwarded.pop(key, None):
            annotations.inputs[key] = (forwarded,)
        elif definer is not None and "$" in self._definition(definer, key)[2]:
            annotations.inputs[key] = self._last

    def looked_up(self, table: Any, key: str, value: Any) -> None:
        """Record that an expression used a name."""
        if key.startswith("*"):
            return
        annotations = annotations_of(table)
        definer = annotations.definers.get(key)
        if definer is None:
            return  # built-in names
        inputs = annotations.inputs.get(key, ())
        kind, span, text = self._definition(definer, key)
        looked_up = self._collected[-1] if self._collected else self._forwarded
        looked_up[key] = Origin(key, _short(value), kind, span, text, inputs)

    def argument(self, name: str, value: str) -> None:
        """Record that an expression used ``$(arg name)``."""
        if not self._collected:
            return
        kind, text = "command line", f"{name}:={value}"
        span: Span | None = None
        if name not in self._defined.values:
            for declared in self._defined.arguments:
                if declared.name == name:
                    span = declared.tag.attribute_spans().get("default", declared.tag.span)
                    kind, text = "xacro:arg", span.text
        self._collected[-1][f"$(arg {name})"] = Origin(name, value, kind, span, text, ())

    def yaml_value(self, value: Any) -> None:
        """Record that an expression used a value of a YAML file."""
        span: Span | None = getattr(value, "span", None)
        if span is None or not self._collected:
            return
        line = span.source.line(span.line).strip()
        key = line.partition(":")[0].strip("- ") or "value"
        self._collected[-1][str(span)] = Origin(key, str(value), "YAML", span, line, ())


def data_places(dom: Dom, at: Element | Attribute) -> DataPlaces | None:
    """The places in YAML files of the values of an attribute, or of all of an element.

    Args:
        dom: the expanded DOM of a traced run.
        at: of the Document of this expansion, or of another expansion of the same file.
    """
    attributes = at.attributes.values() if isinstance(at, Element) else (at,)
    by_file: dict[Source, list[tuple[Span, str]]] = {}
    are_copies = isinstance(at, Attribute) or _has_all_numbers(at)
    for attribute in attributes:
        origins = list(_yaml_origins(inputs_of(dom, attribute.element, attribute.name)))
        for span, _ in origins:
            by_file.setdefault(span.source, []).append((span, attribute.name))
        values = [value for _, value in origins]
        are_copies = are_copies and ("$" not in attribute.span.text or _copies(attribute, values))
    lines = tuple(chain.from_iterable(map(_definitions, by_file.values())))
    if not lines:
        return None
    return DataPlaces(lines, lines[0].span if are_copies and len(by_file) == 1 else None)


def _has_all_numbers(element: Element) -> bool:
    """True if a finding at an element is about its numbers, not about one that is missing."""
    expected = _NUMBERS.get(element.tag)
    return expected is not None and expected <= element.attributes.keys()


def _yaml_origins(origins: tuple[Origin, ...]) -> Iterator[tuple[Span, str]]:
    """The place and value of each number or text of a YAML file among all origins."""
    for origin in origins:
        if origin.kind == "YAML" and origin.span is not None:
            yield origin.span, origin.value
        yield from _yaml_origins(origin.inputs)


def _copies(attribute: Attribute, values: Sequence[str]) -> bool:
    """True if an attribute repeats numbers of YAML files; a name may be wrong where it is used."""
    return all(any(map(partial(_is_same, text), values)) for text in attribute.value.split())


def _is_same(number: str, other: str) -> bool:
    try:
        return float(number) == float(other)
    except ValueError:
        return False


def _definitions(places: list[tuple[Span, str]]) -> Iterator[Related]:
    """The first value of each line, in the order of the lines."""
    names = list(dict.fromkeys(name for _, name in places))
    message = f"{listed(names)} {'is' if len(names) == 1 else 'are'} defined here"
    spans = sorted((span for span, _ in places), key=lambda span: -span.start)
    first = {span.line: span for span in spans}
    return (Related(first[line], message) for line in sorted(first))


def _definition(definer: Node, key: str) -> tuple[str, Span, str]:
    """Kind, location and text of the definition of a name."""
    spans = definer.tag_at.attribute_spans()
    if definer.tagName == "xacro:property":
        span = spans.get("value", spans.get("default", definer.tag_at.span))
        return "property", span, span.text
    if key in spans:
        return "argument", spans[key], spans[key].text
    return "default", definer.tag_at.span, definer.tag_at.span.text


def _short(value: Any) -> str:
    # Collections of a YAML file may be large.
    text = reprlib.repr(value) if isinstance(value, (dict, list)) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."


def inputs_of(dom: Dom, element: Element, name: str) -> tuple[Origin, ...]:
    """The origins of the names that the expression of an attribute looked up.

    Args:
        dom: the expanded DOM of a traced run.
    """
    indices: list[int] = []
    while element.parent is not None:
        indices.append(next(i for i, c in enumerate(element.parent.children) if c is element))
        element = element.parent
    node = dom.documentElement
    for index in reversed(indices):
        node = [child for child in node.childNodes if child.nodeType == ELEMENT][index]
    traces: dict[str, tuple[Origin, ...]] = node.traces or {}
    return traces.get(name, ())
