"""Source locations of the expressions that xacro is evaluating."""

from __future__ import annotations

import re
from functools import lru_cache

from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.text.document import CallFrame, Location
from urdfkit.text.source import Span
from urdfkit.xacro.dom import Node

#: Longer expressions are not searched; they have the location of the text that contains them.
_MAX_TOKEN = 2000

#: Patterns of the spellings of a character in XML.
_SPELLINGS = {
    "<": "&lt;",
    "&": "&amp;",
    ">": "(?:>|&gt;)",
    '"': '(?:"|&quot;|&#34;)',
    "'": "(?:'|&apos;|&#39;)",
    " ": "(?:[ \t\n]|\r\n?)",
    "\n": "(?:\n|\r\n?|&#10;)",
}


class LocatedExpression(Record):
    """An expression in a text."""

    text: str  # without the escapes of XML
    offset: int  # of the expression in the text
    token: str  # the expression with its brackets
    #: The enclosing properties that are being resolved, as (table, name).
    resolving: tuple[tuple[Any, str], ...] = ()


def locate(node: Node, local: dict[str, Any], located: LocatedExpression) -> Location:
    """The location of an expression: in an attribute, a text, or the default of a parameter.

    Args:
        node: the element that xacro is processing, or that contains the text.
    """
    if (span := _in_attribute(node, local, located)) is not None:
        return Location(span, node.frame)
    macro = getattr(local.get("m"), "body", None)
    if isinstance(macro, Node) and (span := _in_parameters(macro, local, located)) is not None:
        name = macro.getAttribute("name")
        return Location(span, CallFrame("macro", name, node.tag_at, macro.tag_at, node.frame))
    return Location(_in_text(node, local.get("node"), located) or node.tag_at.span, node.frame)


def _in_attribute(node: Node, local: dict[str, Any], located: LocatedExpression) -> Span | None:
    values = node.raw_attributes()
    names = [name for name, value in values.items() if value == located.text]
    if local.get("name") in names:  # of several equal values, the one that xacro is processing
        names = [local["name"]]
    span = node.tag_at.attribute_spans().get(names[0]) if names else None
    if span is None:
        return None
    return _find(span, located, located.text[: located.offset].count(located.token)) or span


def _in_parameters(macro: Node, local: dict[str, Any], located: LocatedExpression) -> Span | None:
    """The expression in the default of a parameter."""
    params = macro.tag_at.attribute_spans().get("params")
    if params is None:
        return None
    match = re.search(rf"(?<!\S){re.escape(str(local.get('param')))}\s*:?=", params.text)
    skipped = params.text[: match.start()] if match else ""
    return _find(params._replace(start=params.start + len(skipped.encode())), located)


def _in_text(node: Node, text: Any, located: LocatedExpression) -> Span | None:
    """The expression in a text or a comment, counted from the end of the text."""
    inner = node.tag_at.inner_span
    end = getattr(text, "end_offset", None)
    if end is None or not inner.start <= end <= inner.end:
        return _find(inner, located)
    rest = located.text[located.offset + len(located.token) :]
    return _find(inner._replace(end=end), located, -1 - rest.count(located.token))


def _find(span: Span, located: LocatedExpression, number: int = 0) -> Span | None:
    """The expression in a span; of several equal expressions, the one with a number."""
    if not located.token or len(located.token) > _MAX_TOKEN:
        return None
    pattern = "".join(_SPELLINGS.get(char) or re.escape(char) for char in located.token)
    matches = _matches(pattern, span.source.data[span.start : span.end])
    if not -len(matches) <= number < len(matches):
        return None
    start, end = matches[number]
    return Span(span.source, span.start + start, span.start + end)


@lru_cache(maxsize=1)
def _matches(pattern: str, text: bytes) -> list[tuple[int, int]]:
    """Start and end of all matches; cached, because each of many equal expressions may fail."""
    return [match.span() for match in re.finditer(pattern.encode("utf-8", "surrogatepass"), text)]
