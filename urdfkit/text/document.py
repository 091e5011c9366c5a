"""XML documents whose elements have source locations.

A plain URDF and an expanded xacro are both a Document. Every Element has the location of its start
tag in its source file, and the calls that led there: a link created by a macro is located in the
body of the macro, and ``via`` contains the macro call.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import lru_cache

from urdfkit.core.record import Record
from urdfkit.text.source import Source, Span

# Compiled when needed: a robot without findings has no location to show.
_TAG_NAME = rb"<\s*([^\s/>]+)"
_ATTRIBUTE = rb"""\s*([^\s=<>/"']+)\s*=\s*("[^"]*"|'[^']*')"""
_START_TAG_END = rb"""(?:[^<>"']|"[^"]*"|'[^']*')*/?>"""


@lru_cache
def _compiled(pattern: bytes) -> re.Pattern[bytes]:
    return re.compile(pattern)


class Step(Record):
    """One step of an expansion trace: a macro call, an include or a launch file."""

    kind: str  # ``macro``, ``include`` or ``launch``
    name: str  # of the macro, or of the included file, which may be a YAML file
    span: Span  # the call
    definition: Span | None  # the ``<xacro:macro>`` that was called; None for an include


class CallFrame:
    """The innermost step of a trace, linked to the outer steps; shared by many elements."""

    __slots__ = ("call", "definition", "kind", "name", "outer")

    def __init__(
        self, kind: str, name: str, call: Tag, definition: Tag | None, outer: CallFrame | None
    ) -> None:
        self.kind = kind
        self.name = name
        self.call = call
        self.definition = definition
        self.outer = outer

    def outwards(self) -> Iterator[CallFrame]:
        """This step and the outer ones."""
        frame: CallFrame | None = self
        while frame is not None:
            yield frame
            frame = frame.outer

    def steps(self) -> tuple[Step, ...]:
        steps = [
            Step(step.kind, step.name, step.call.span, step.definition and step.definition.span)
            for step in self.outwards()
        ]
        return tuple(reversed(steps))


class Location(Record):
    """A place that is not an element of the expanded document, and the calls that led there."""

    span: Span
    frame: CallFrame | None = None


class Tag(Record):
    """Source location of an element: its start tag, and its end tag if it has one."""

    source: Source  # the file
    start: int  # offset of the ``<`` of the start tag
    close: int  # offset of the ``<`` of the end tag; equal to ``start`` for ``<a/>``

    @classmethod
    def between(cls, source: Source, start: int, at: int, *, empty: bool) -> Tag:
        """The tag of an element, from the parser's offsets at its start and end events.

        ``<a/>`` has no end tag, but the end tag of its parent may follow directly.
        """
        data = source.data
        if not data.startswith(b"</", at) or (empty and data.endswith(b"/>", start, at)):
            return cls(source, start, start)
        return cls(source, start, at)

    @property
    def span(self) -> Span:
        """Span of the start tag, from ``<`` to ``>``."""
        return Span(self.source, self.start, self.inner_start)

    @property
    def inner_start(self) -> int:
        """Offset just after the start tag's ``>``."""
        name = _compiled(_TAG_NAME).match(self.source.data, self.start)
        end = name and _compiled(_START_TAG_END).match(self.source.data, name.end())
        return end.end() if end else min(self.start + 1, len(self.source.data))

    @property
    def name_span(self) -> Span:
        match = _compiled(_TAG_NAME).match(self.source.data, self.start)
        start, end = match.span(1) if match else (self.start, self.start + 1)
        return Span(self.source, start, end)

    @property
    def whole_span(self) -> Span:
        """Span from the ``<`` of the start tag to the ``>`` of the end tag."""
        if self.close == self.start:
            return self.span
        end = self.source.data.find(b">", self.close) + 1
        return Span(self.source, self.start, end or len(self.source.data))

    @property
    def inner_span(self) -> Span:
        """Span between start tag and end tag."""
        start = self.inner_start
        return Span(self.source, start, max(start, self.close))

    def attribute_spans(self) -> Mapping[str, Span]:
        """Spans of the attribute values, without their quotes, by name."""
        return _attribute_spans(self)


@lru_cache(maxsize=64)  # called for each attribute of a tag, which may have 100 000
def _attribute_spans(tag: Tag) -> Mapping[str, Span]:
    data = tag.source.data
    match = _compiled(_TAG_NAME).match(data, tag.start)
    attribute = _compiled(_ATTRIBUTE)
    spans: dict[str, Span] = {}
    while match and (match := attribute.match(data, match.end())):
        start, end = match.span(2)
        spans[match.group(1).decode("utf-8", "replace")] = Span(tag.source, start + 1, end - 1)
    return spans


class Attribute:
    """An attribute after expansion."""

    __slots__ = ("element", "name", "value", "written_in")

    def __init__(self, name: str, value: str, element: Element, written_in: Tag | None = None):
        self.name = name  # with its prefix, as written
        self.value = value  # after expansion
        self.element = element
        #: The ``<xacro:attribute>`` that defines it, if it is not in the element's own tag.
        self.written_in = written_in

    @property
    def span(self) -> Span:
        """Span of the value, or of the tag if the value is not in the source."""
        if self.written_in is not None:
            spans = self.written_in.attribute_spans()
            return spans.get("value", self.written_in.span)
        return self.element.tag_at.attribute_spans().get(self.name) or self.element.span

    @property
    def literal(self) -> bool:
        """True if the source contains this value, not an expression that yields it."""
        return self.span.text == self.value

    @property
    def via(self) -> tuple[Step, ...]:
        """The macro calls and includes that led to its element, outermost first."""
        return self.element.via

    @property
    def path(self) -> str:
        return f"{self.element.path}@{self.name}"

    def __repr__(self) -> str:
        return f"Attribute({self.path}={self.value!r})"


class Element:
    """An element after expansion."""

    __slots__ = ("_number", "attributes", "children", "frame", "parent", "tag", "tag_at", "text")

    def __init__(
        self, tag: str, tag_at: Tag, parent: Element | None, frame: CallFrame | None = None
    ):
        self.tag = tag  # its name, with the prefix, as written
        self.tag_at = tag_at  # source location
        self.parent = parent  # None for the root
        self.frame = frame  # the innermost macro call or include that led there, or None
        self.attributes: dict[str, Attribute] = {}  # by name, in document order
        self.children: list[Element] = []
        self.text = ""  # the character data directly in it, joined
        self._number = 0  # among its siblings with the same tag; 0 until it is computed

    @property
    def span(self) -> Span:
        return self.tag_at.span

    @property
    def via(self) -> tuple[Step, ...]:
        """The macro calls and includes that led here, outermost first."""
        return self.frame.steps() if self.frame else ()

    def get(self, name: str) -> str | None:
        attribute = self.attributes.get(name)
        return None if attribute is None else attribute.value

    def child(self, tag: str) -> Element | None:
        for child in self.children:
            if child.tag == tag:
                return child
        return None

    def child_or_self(self, tag: str) -> Element:
        """The first child with a tag; this element, the place of a missing child, without any."""
        return self.child(tag) or self

    def all(self, tag: str) -> list[Element]:
        return [child for child in self.children if child.tag == tag]

    def walk(self) -> Iterator[Element]:
        """This element and its descendants, in document order."""
        stack = [self]
        while stack:
            element = stack.pop()
            yield element
            stack.extend(reversed(element.children))

    @property
    def path(self) -> str:
        """Path from the root, such as ``link/arm/visual[2]/geometry/mesh``.

        Elements with a name are identified by it, others by their number from the second on.
        """
        parts: list[str] = []
        element = self
        while element.parent is not None:
            parts.append(element._step())
            element = element.parent
        return "/".join(reversed(parts)) or self.tag

    def _step(self) -> str:
        name = self.get("name") or self.get("reference")
        if name:
            return f"{self.tag}/{name}"
        assert self.parent is not None
        if not self._number:
            counts: dict[str, int] = {}
            for sibling in self.parent.children:  # all at once: there may be many
                counts[sibling.tag] = sibling._number = counts.get(sibling.tag, 0) + 1
        return f"{self.tag}[{self._number}]" if self._number > 1 else self.tag

    def __repr__(self) -> str:
        return f"<{self.path} at {self.span}>"


class Document(Record):
    """An XML document after expansion."""

    root: Element
    sources: tuple[Source, ...]  # all files that were read for it, the checked file first
