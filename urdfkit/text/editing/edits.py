"""Text edits of elements; comments, quotes, indentation and line ends do not change.

Only literal text of a file can be edited, so functions return None if the name or the value comes
from a xacro expression: a person must decide where to change it. The body of a macro may be edited:
the edit is kept only if all calls agree on it (`urdfkit.lint.fix`).
"""

import re
from collections.abc import Iterable

from urdfkit.text.diagnostic import Edit, Fix
from urdfkit.text.document import Attribute, Element
from urdfkit.text.source import Source, Span

#: The default indentation of one level.
STEP = "  "

_ESCAPES = str.maketrans(
    {
        "&": "&amp;",
        "<": "&lt;",
        ">": "&gt;",
        '"': "&quot;",
        "'": "&apos;",
        **{char: f"&#{ord(char)};" for char in "\n\r\t"},
    }
)
_END_TAG_NAME = rb"</\s*([^\s>]+)"


def all_or_none(pieces: Iterable[tuple[Edit, ...] | None]) -> tuple[Edit, ...] | None:
    """The edits of several changes together; None if one of them is impossible."""
    edits: list[Edit] = []
    for piece in pieces:
        if piece is None:
            return None
        edits += piece
    return tuple(edits)


def rename_element(element: Element, name: str) -> tuple[Edit, ...] | None:
    """Rename an element, in its start tag and its end tag."""
    tag = element.tag_at
    if tag.name_span.text != element.tag:
        return None
    edits = [Edit(tag.name_span, name)]
    if end := re.compile(_END_TAG_NAME).match(tag.source.data, tag.close):
        edits.append(Edit(Span(tag.source, *end.span(1)), name))
    return tuple(edits)


def rename_attribute(attribute: Attribute, name: str) -> tuple[Edit, ...] | None:
    """Rename an attribute."""
    span = _name_span(attribute)
    return None if span is None else (Edit(span, name),)


def remove_attribute(attribute: Attribute) -> tuple[Edit, ...] | None:
    """Remove an attribute, with the white space before it."""
    span = _name_span(attribute)
    if span is None:
        return None
    source, name_start, _ = span
    tag_start = attribute.element.tag_at.start
    start = tag_start + len(source.data[tag_start:name_start].rstrip())
    return (Edit(Span(source, start, attribute.span.end + 1), ""),)


def _name_span(attribute: Attribute) -> Span | None:
    """The span of an attribute's name in its tag; None if ``<xacro:attribute>`` defines it."""
    tag, values = attribute.element.tag_at, attribute.element.tag_at.attribute_spans()
    if attribute.written_in is not None or attribute.name not in values:
        return None
    before = tag.source.data[tag.start : values[attribute.name].start - 1]
    end = tag.start + len(before.rstrip().removesuffix(b"=").rstrip())
    return Span(tag.source, end - len(attribute.name.encode()), end)


def as_written(attribute: Attribute) -> str:
    """The value with its original white space, which XML normalises to spaces."""
    text = attribute.span.text
    return text if text.split() == attribute.value.split() else attribute.value


def add_attribute(after: Attribute, name: str, value: str) -> tuple[Edit, ...] | None:
    """Add an attribute to an element, after one in its tag."""
    if after.written_in is not None:
        return None
    source, _, end = after.span
    return (Edit(Span(source, end + 1, end + 1), f' {name}="{value}"'),)


def first_attribute(element: Element, name: str, value: str) -> tuple[Edit, ...]:
    """Add an attribute to an element, before all others in its tag."""
    source, _, end = element.tag_at.name_span
    return (Edit(Span(source, end, end), f' {name}="{value}"'),)


def escaped(text: str) -> str:
    """A text, escaped for an attribute with either quotes, or between tags."""
    return text.translate(_ESCAPES)


def replace_value(attribute: Attribute, value: str) -> tuple[Edit, ...] | None:
    if attribute.span.text.split() != attribute.value.split():
        return None
    escaped = value.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    return (Edit(attribute.span, escaped.replace("'", "&apos;")),)


def replace_text(element: Element, text: str) -> tuple[Edit, ...] | None:
    """Replace the text of an element, without the white space around it."""
    source, start, end = element.tag_at.inner_span
    original = source.data[start:end]
    if element.children or original.decode("utf-8", "replace").strip() != element.text.strip():
        return None
    start += len(original) - len(original.lstrip())
    escaped = text.replace("&", "&amp;").replace("<", "&lt;")
    return (Edit(Span(source, start, start + len(original.strip())), escaped),)


def rewrite(at: Element | Attribute, text: str) -> tuple[Edit, ...] | None:
    """Replace the value of an attribute, or the text of an element."""
    return replace_value(at, text) if isinstance(at, Attribute) else replace_text(at, text)


def fix_value(at: Element | Attribute, text: str | None) -> Fix | None:
    """The fix that replaces a value; None without a new value, or if it is impossible."""
    if not text:
        return None
    written = f'{at.name}="{text}"' if isinstance(at, Attribute) else f"<{at.tag}>{text}</{at.tag}>"
    return Fix.of(f"write {written}", rewrite(at, text))


def fix_tag(element: Element, tag: str | None) -> Fix | None:
    """The fix that renames an element; None without a new tag, or if it is impossible."""
    return Fix.of(f"rename it to <{tag}>", rename_element(element, tag)) if tag else None


def scale_limits(limit: Element, factor: float) -> tuple[Edit, ...] | None:
    """Multiply ``lower`` and ``upper`` of a ``<limit>``, which are numbers, by a factor."""
    ends = [limit.attributes[key] for key in ("lower", "upper") if key in limit.attributes]
    return all_or_none(
        replace_value(end, f"{float(end.value) * factor:.10g}") for end in ends if float(end.value)
    )


def swap(first: Element | Attribute, second: Element | Attribute) -> tuple[Edit, ...] | None:
    """Swap the values of two attributes or elements."""
    edits, others = rewrite(first, _value(second)), rewrite(second, _value(first))
    return (*edits, *others) if edits and others else None


def _value(at: Element | Attribute) -> str:
    return at.value if isinstance(at, Attribute) else at.text.strip()


def remove_element(element: Element) -> tuple[Edit, ...]:
    """Remove an element, with its lines if they contain nothing else."""
    return remove_elements([element])


def remove_elements(elements: Iterable[Element]) -> tuple[Edit, ...]:
    """Remove elements of one source, with their lines if they contain nothing else."""
    return remove_spans(element.tag_at.whole_span for element in elements)


def remove_spans(spans: Iterable[Span]) -> tuple[Edit, ...]:
    """Remove spans of one source, with their lines if they contain nothing else."""
    merged: list[Span] = []
    for span in sorted(spans, key=lambda span: span.start):
        last = merged[-1] if merged else None
        if last and not span.source.data[last.end : span.start].strip():
            merged[-1] = Span(span.source, last.start, span.end)
        else:
            merged.append(span)
    return tuple(Edit(_with_line(span), "") for span in merged)


def _with_line(span: Span) -> Span:
    """A span to remove, extended to its lines if they contain nothing else."""
    source, start, end = span
    line_start, line_end = _line(source, start, end)
    before, after = source.data[line_start:start], source.data[end:line_end]
    if before.strip():
        return span
    if after.strip():  # such as a comment, which moves to the start
        return Span(source, start, line_end - len(after.lstrip()))
    above, _ = _line(source, line_start - 1, line_start - 1) if line_start else (0, 0)
    _, below = _line(source, line_end, line_end)
    if not source.data[above:line_start].strip() and not source.data[line_end:below].strip():
        return Span(source, above, line_end)  # two blank lines become one
    return Span(source, line_start, line_end)


def insert_before(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Insert lines of XML before an element, with its indentation."""
    source, start, _ = element.span
    separator = newline(source) + (indent_of(element.span) or "")
    text = "".join(line + separator for line in lines)
    return (Edit(Span(source, start, start), text),)


def insert_after(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Insert lines of XML after an element, with its indentation."""
    return insert_behind(element.tag_at.whole_span, lines)


def insert_behind(span: Span, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Insert lines of XML after a span, with its indentation."""
    source, _, end = span
    return (Edit(Span(source, end, end), _below(span, lines)),)


def replace(span: Span, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Replace a span by lines of XML, with its indentation."""
    return (Edit(span, _below(span, lines).lstrip()),)


def _below(span: Span, lines: Iterable[str]) -> str:
    """Lines, each after a line end, with the indentation of a span."""
    end, indent = newline(span.source), indent_of(span) or ""
    return "".join(end + indent + line if line else end for line in lines)


def insert_first(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Insert lines of XML into an element, before its content."""
    return _insert(element, lines, element.tag_at.inner_start)


def insert_last(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Insert lines of XML into an element, after its content."""
    source, start, end = element.tag_at.inner_span
    return _insert(element, lines, start + len(source.data[start:end].rstrip()))


def _insert(element: Element, lines: Iterable[str], at: int) -> tuple[Edit, ...]:
    tag = element.tag_at
    if tag.close == tag.start:
        return _expand_empty(element, lines)
    separator = _before_content(element)
    return (Edit(Span(tag.source, at, at), "".join(separator + line for line in lines)),)


def _expand_empty(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Insert lines of XML into an element ``<a/>``, which becomes ``<a>...</a>``."""
    source, start, end = element.span
    slash = start + len(source.data[start : end - 2].rstrip())
    outer = newline(source) + (indent_of(element.span) or "")
    inner = "".join(f"{outer}{STEP}{line}" for line in lines)
    return (Edit(Span(source, slash, end), f">{inner}{outer}</{element.tag}>"),)


def _before_content(element: Element) -> str:
    """The white space between the start tag and the content: a line end with indent, or nothing."""
    source, start, end = element.tag_at.inner_span
    data = source.data[start:end]
    space = data[: len(data) - len(data.lstrip())].decode()
    if "\n" not in space:
        return ""
    if not data.strip():  # it is empty, and the end tag is on a later line
        return newline(source) + (indent_of(element.span) or "") + STEP
    return newline(source) + space.rpartition("\n")[2]


def move_after(element: Element, anchor: Element) -> tuple[Edit, ...]:
    """Move an element after one of its ancestors, with the indentation of the ancestor."""
    source, _, end = anchor.tag_at.whole_span
    new = indent_of(anchor.span)
    if indent_of(element.span) is None or new is None:
        text = element.tag_at.whole_span.text
    else:
        text = "".join(newline(source) + new + line for line in lines_of(element))
    return (*remove_element(element), Edit(Span(source, end, end), text))


def lines_of(element: Element) -> list[str]:
    """The text of an element as lines, without its indentation."""
    own = indent_of(element.span) or ""
    text = element.tag_at.whole_span.text.replace("\r\n", "\n")
    return [line.removeprefix(own) for line in text.split("\n")]


def from_macro(element: Element) -> bool:
    """True if a macro created the element, so that an edit would change all of its calls."""
    frame = element.frame
    return frame is not None and any(step.kind == "macro" for step in frame.outwards())


def indent_of(span: Span) -> str | None:
    """The indentation of a span; None if other text precedes it on its line."""
    source, start, end = span
    before = source.data[_line(source, start, end)[0] : start].decode("utf-8", "replace")
    return None if before.strip() else before


def newline(source: Source) -> str:
    return "\r\n" if b"\r\n" in source.data else "\n"


def _line(source: Source, start: int, end: int) -> tuple[int, int]:
    """Offsets of the whole lines of a byte range, with the last line end."""
    after = source.data.find(b"\n", end)
    return source.data.rfind(b"\n", 0, start) + 1, after + 1 or len(source.data)
