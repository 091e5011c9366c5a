"""Where in a file an expression stands that xacro is evaluating."""

from __future__ import annotations

import re

from urdfkit.core.record import Record
from urdfkit.core.static_typing import Any
from urdfkit.text.document import CallFrame
from urdfkit.text.source import Span
from urdfkit.xacro.dom import Node

#: Longer expressions are not looked for; the text around them is their place.
_MAX_TOKEN = 2000

#: How a character may be written in XML.
_WRITTEN = {
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

    text: str  # as XML gives it
    #: offset and token: of the expression, with its brackets.
    offset: int
    token: str
    #: The properties around it that are being resolved, as (table, name).
    resolving: tuple[tuple[Any, str], ...] = ()


class ErrorLocation(Record):
    """A place, and the calls that led there."""

    span: Span
    frame: CallFrame | None


def locate(node: Node, local: dict[str, Any], located: LocatedExpression) -> ErrorLocation:
    """The place of an expression: in an attribute, a text, or the default of a parameter.

    Args:
        node: that xacro works on, or that holds the text it works on.
    """
    if (span := _in_attribute(node, local, located)) is not None:
        return ErrorLocation(span, node.frame)
    macro = getattr(local.get("m"), "body", None)
    if isinstance(macro, Node) and (span := _in_parameters(macro, local, located)) is not None:
        name = macro.getAttribute("name")
        return ErrorLocation(span, CallFrame("macro", name, node.tag_at, macro.tag_at, node.frame))
    return ErrorLocation(_in_text(node, local.get("node"), located) or node.tag_at.span, node.frame)


def _in_attribute(node: Node, local: dict[str, Any], located: LocatedExpression) -> Span | None:
    values = node.written()
    names = [name for name, value in values.items() if value == located.text]
    if local.get("name") in names:  # of two that are alike, the one that it works on
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
    given = re.search(rf"(?<!\S){re.escape(str(local.get('param')))}\s*:?=", params.text)
    skipped = params.text[: given.start()] if given else ""
    return _find(params._replace(start=params.start + len(skipped.encode())), located)


def _in_text(node: Node, text: Any, located: LocatedExpression) -> Span | None:
    """The expression in a text or a comment, counted from its end."""
    inner = node.tag_at.inner_span
    end = getattr(text, "ends", None)
    if end is None or not inner.start <= end <= inner.end:
        return _find(inner, located)
    rest = located.text[located.offset + len(located.token) :]
    return _find(inner._replace(end=end), located, -1 - rest.count(located.token))


def _find(around: Span, located: LocatedExpression, number: int = 0) -> Span | None:
    """The expression in a piece of a file, of several that are alike the one of a number."""
    if not located.token or len(located.token) > _MAX_TOKEN:
        return None
    pattern = "".join(_WRITTEN.get(char) or re.escape(char) for char in located.token)
    text = around.text
    found = list(re.finditer(pattern, text))
    if not -len(found) <= number < len(found):
        return None
    start = around.start + len(text[: found[number].start()].encode())
    return Span(around.source, start, start + len(found[number].group().encode()))
