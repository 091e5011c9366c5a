"""The tags of a text that may not be well-formed yet, because it is being edited.

End tags without a start tag are ignored. The module raises no errors, whatever the text.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.text.source import Source, Span
from urdfkit.text.tokens import AttributeToken, Token, TokenKind, tokens

#: Largest nesting depth; deeper elements are siblings at this depth.
MAX_DEPTH = 200

_TAGS = (TokenKind.START, TokenKind.EMPTY, TokenKind.UNFINISHED)


class WrittenAttribute(Record):
    """An attribute in a text."""

    name: str  # with its prefix
    name_span: Span  # the name
    value_span: Span | None  # the value without quotes; None if it is not written yet

    @property
    def value(self) -> str:
        return self.value_span.text if self.value_span else ""


class TagNode:
    """An element in a text.

    Attributes:
        name, name_span: with the prefix; empty directly after a ``<``.
        source: the text.
        start: offset of the start tag.
        tag_end: offset after the start tag.
        end: offset after the element.
        closed: True if the element has an end; an unfinished one extends beyond its last
            character.
        end_name: name in the end tag; None without one.
        attributes: in text order.
        parent: the enclosing element, or None.
        children: the child elements.
    """

    def __init__(self, token: Token, source: Source, parent: TagNode | None) -> None:
        self.name = token.name
        self.name_span = Span(source, *token.name_span)
        self.source = source
        self.start = token.start
        self.tag_end = self.end = token.end
        self.closed = token.kind is TokenKind.EMPTY
        self.end_name: Span | None = None
        self.attributes = [_attribute(attribute, source) for attribute in token.attributes]
        self.parent = parent
        self.children: list[TagNode] = []
        self.depth: int = parent.depth + 1 if parent else 0

    @property
    def span(self) -> Span:
        return Span(self.source, self.start, self.end)

    @property
    def text_span(self) -> Span:
        """Its leading text without surrounding white space."""
        data = self.source.data
        inner = data[self.tag_end : self.end]
        until = inner.find(b"<")
        text = inner if until < 0 else inner[:until]
        start = self.tag_end + len(text) - len(text.lstrip())
        return Span(self.source, start, start + len(text.strip()))

    def get(self, name: str) -> str:
        """The value of an attribute; empty if it is missing."""
        written = self.attribute(name)
        return written.value if written else ""

    def attribute(self, name: str) -> WrittenAttribute | None:
        return next((attribute for attribute in self.attributes if attribute.name == name), None)

    def ancestors(self) -> Iterator[TagNode]:
        """The enclosing elements, from the inside outwards."""
        node = self.parent
        while node is not None:
            yield node
            node = node.parent

    def ancestor(self, *names: str) -> TagNode | None:
        """The nearest enclosing element with one of these names."""
        return next((node for node in self.ancestors() if node.name in names), None)


class Markup:
    """The elements of a text."""

    def __init__(self, source: Source) -> None:
        self.source = source  # the text
        self.nodes: list[TagNode] = []  # all elements, in the order of their start tags
        self._comments: list[tuple[int, int]] = []  # also declarations and processing instructions
        self._ends: list[int] = []  # offsets of the names in end tags
        self._read()
        self._starts = [node.start for node in self.nodes]

    def _read(self) -> None:
        open_: list[TagNode] = []
        for token in tokens(self.source.data):
            if token.kind is TokenKind.END:
                self._ends.append(token.name_span[0])
                self._close(open_, token)
            elif token.kind in _TAGS:
                self._open(open_, token)
            elif token.kind is not TokenKind.TEXT:
                self._comments.append((token.start, token.end))
        for node in open_:
            node.end = len(self.source.data)

    def _open(self, open_: list[TagNode], token: Token) -> None:
        node = TagNode(token, self.source, open_[-1] if open_ else None)
        self.nodes.append(node)
        if node.parent:
            node.parent.children.append(node)
        if token.kind is TokenKind.START and node.name and node.depth < MAX_DEPTH:
            open_.append(node)

    def _close(self, open_: list[TagNode], token: Token) -> None:
        """Close the nearest open element of a name, and the elements inside it."""
        if not any(node.name == token.name for node in open_[-MAX_DEPTH:]):
            return
        while (node := open_.pop()).name != token.name:
            node.end = token.start
        node.end = token.end
        node.closed = True
        node.end_name = Span(self.source, *token.name_span)

    def node_at(self, offset: int) -> TagNode | None:
        """The innermost element that contains an offset between two characters."""
        index = bisect_right(self._starts, offset - 1) - 1
        node = self.nodes[index] if index >= 0 else None
        while node is not None and offset > node.end - node.closed:
            node = node.parent
        return node

    def end_name_at(self, offset: int) -> int | None:
        """Offset of the name if an offset is in the name of an end tag; None elsewhere."""
        index = bisect_right(self._ends, offset) - 1
        if index < 0 or re.search(rb"[\s<>/]", self.source.data[self._ends[index] : offset]):
            return None
        return self._ends[index]

    def is_comment(self, offset: int) -> bool:
        """True inside a comment, a declaration or a processing instruction."""
        data = self.source.data
        return any(
            start < offset < end or (offset == end and not data.endswith(b">", start, end))
            for start, end in self._comments
        )


class Cursor(Record):
    """The syntactic context of the cursor."""

    offset: int  # in bytes
    node: TagNode | None  # the innermost element; None outside of all elements
    #: ``tag`` (in a name after ``<``), ``end`` (in a name after ``</``), ``attribute`` (at an
    #: attribute name or where one could be written), ``value``, ``text``, ``comment``, ``nowhere``.
    place: str
    attribute: WrittenAttribute | None = None  # the attribute of the name or value


def cursor(markup: Markup, offset: int) -> Cursor:
    if markup.is_comment(offset):
        return Cursor(offset, None, "comment")
    node = markup.node_at(offset)
    if node is None:
        return Cursor(offset, None, "nowhere")
    if markup.end_name_at(offset) is not None:
        return Cursor(offset, node, "end")
    if offset <= node.name_span.end:
        return Cursor(offset, node, "tag")
    for written in node.attributes:
        if written.name_span.start <= offset <= written.name_span.end:
            return Cursor(offset, node, "attribute", written)
        value = written.value_span
        if value and value.start <= offset <= value.end:
            return Cursor(offset, node, "value", written)
    data = markup.source.data
    is_inside = offset < node.tag_end or data[node.tag_end - 1 : node.tag_end] != b">"
    if is_inside and offset <= node.tag_end:
        return Cursor(offset, node, "attribute")
    return Cursor(offset, node, "text")


def _attribute(token: AttributeToken, source: Source) -> WrittenAttribute:
    name = Span(source, *token.name)
    return WrittenAttribute(name.text, name, Span(source, *token.value) if token.value else None)
