"""Text edits that mend an element: comments, quotes, indentation and line ends stay as they are.

Only what a file holds literally can be edited, so every function here may answer None: the name or
the value came out of a xacro expression, and a person must decide where to change it. What a macro
wrote may be edited: the judge keeps the edit only if all uses agree on it (``agreement``).
"""

from __future__ import annotations

import re

from urdfkit.diagnostic import Edit
from urdfkit.document import Attribute, Element
from urdfkit.source import Source, Span

_END_TAG_NAME = re.compile(rb"</\s*([^\s>]+)")


def rename_element(element: Element, name: str) -> tuple[Edit, ...] | None:
    """Give an element another name, in its start tag and its end tag."""
    tag = element.tag_at
    if tag.name_span.text != element.tag:
        return None
    edits = [Edit(tag.name_span, name)]
    if end := _END_TAG_NAME.match(tag.source.data, tag.close):
        edits.append(Edit(Span(tag.source, *end.span(1)), name))
    return tuple(edits)


def rename_attribute(attribute: Attribute, name: str) -> tuple[Edit, ...] | None:
    """Give an attribute another name and leave its value alone."""
    span = _name_span(attribute)
    return None if span is None else (Edit(span, name),)


def remove_attribute(attribute: Attribute) -> tuple[Edit, ...] | None:
    """Take an attribute out, with the white space before it."""
    span = _name_span(attribute)
    if span is None:
        return None
    source, name_start, _ = span
    tag_start = attribute.element.tag_at.start
    start = tag_start + len(source.data[tag_start:name_start].rstrip())
    return (Edit(Span(source, start, attribute.span.end + 1), ""),)


def _name_span(attribute: Attribute) -> Span | None:
    """The name of an attribute in its tag; None if an expression put it there."""
    tag, values = attribute.element.tag_at, attribute.element.tag_at.attribute_spans()
    if attribute.written_in is not None or attribute.name not in values:
        return None
    before = tag.source.data[tag.start : values[attribute.name].start - 1]
    end = tag.start + len(before.rstrip().removesuffix(b"=").rstrip())
    return Span(tag.source, end - len(attribute.name.encode()), end)


def as_written(attribute: Attribute) -> str:
    """The value with the white space that it has in the file, which XML turns into spaces."""
    text = attribute.span.text
    return text if text.split() == attribute.value.split() else attribute.value


def replace_value(attribute: Attribute, value: str) -> tuple[Edit, ...] | None:
    """Give an attribute another value."""
    if attribute.span.text.split() != attribute.value.split():
        return None
    escaped = value.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    return (Edit(attribute.span, escaped.replace("'", "&apos;")),)


def replace_text(element: Element, text: str) -> tuple[Edit, ...] | None:
    """Give an element another text, with the white space around it as it is."""
    source, start, end = element.tag_at.inner_span
    written = source.data[start:end]
    if element.children or written.decode("utf-8", "replace").strip() != element.text.strip():
        return None
    start += len(written) - len(written.lstrip())
    escaped = text.replace("&", "&amp;").replace("<", "&lt;")
    return (Edit(Span(source, start, start + len(written.strip())), escaped),)


def remove_element(element: Element) -> tuple[Edit, ...]:
    """Take an element out, with its line where nothing else stands on it."""
    whole = element.tag_at.whole_span
    source, start, end = whole
    line_start, line_end = _line(source, start, end)
    alone = not source.data[line_start:start].strip() and not source.data[end:line_end].strip()
    return (Edit(Span(source, line_start, line_end) if alone else whole, ""),)


def insert_before(element: Element, lines: tuple[str, ...]) -> tuple[Edit, ...] | None:
    """Put lines of XML before an element, indented as it is.

    None in a macro, where names in the lines would be those of one call.
    """
    if from_macro(element):
        return None
    source, start, _ = element.span
    separator = _newline(source) + (_indent(element) or "")
    text = "".join(line + separator for line in lines)
    return (Edit(Span(source, start, start), text),)


def move_after(element: Element, anchor: Element) -> tuple[Edit, ...]:
    """Move an element behind another one that it is in, indented as that one."""
    removal = remove_element(element)
    source, _, end = anchor.tag_at.whole_span
    own, new = _indent(element), _indent(anchor)
    text = element.tag_at.whole_span.text
    if own is not None and new is not None:
        newline = _newline(source)
        lines = [line.removeprefix(own) for line in text.splitlines()]
        text = "".join(newline + new + line for line in lines)
    return (*removal, Edit(Span(source, end, end), text))


def from_macro(element: Element) -> bool:
    """True if a macro wrote the element, so that one edit would change all of its calls."""
    frame = element.frame
    while frame is not None:
        if frame.kind == "macro":
            return True
        frame = frame.outer
    return False


def _indent(element: Element) -> str | None:
    """The white space before an element on its line; None if something else stands there."""
    source, start, end = element.span
    before = source.data[_line(source, start, end)[0] : start].decode("utf-8", "replace")
    return None if before.strip() else before


def _newline(source: Source) -> str:
    return "\r\n" if b"\r\n" in source.data else "\n"


def _line(source: Source, start: int, end: int) -> tuple[int, int]:
    """The whole lines that hold some bytes, with the last line end."""
    after = source.data.find(b"\n", end)
    return source.data.rfind(b"\n", 0, start) + 1, after + 1 or len(source.data)
