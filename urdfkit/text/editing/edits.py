"""Text edits of elements: comments, quotes, indentation and line ends stay as they are.

Only what a file holds literally can be edited, so every function here may answer None: the name or
the value came out of a xacro expression, and a person must decide where to change it. What a macro
wrote may be edited: the edit is kept only if all uses agree on it (`urdfkit.lint.fix`).
"""

import re
from collections.abc import Iterable

from urdfkit.text.diagnostic import Edit, Fix
from urdfkit.text.document import Attribute, Element
from urdfkit.text.source import Source, Span

#: The indentation of one level where a file does not show its own.
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
    """The edits of several changes as one; None if one of them cannot be made."""
    edits: list[Edit] = []
    for piece in pieces:
        if piece is None:
            return None
        edits += piece
    return tuple(edits)


def rename_element(element: Element, name: str) -> tuple[Edit, ...] | None:
    """Give an element another name, in its start tag and its end tag."""
    tag = element.tag_at
    if tag.name_span.text != element.tag:
        return None
    edits = [Edit(tag.name_span, name)]
    if end := re.compile(_END_TAG_NAME).match(tag.source.data, tag.close):
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


def add_attribute(after: Attribute, name: str, value: str) -> tuple[Edit, ...] | None:
    """Give an element one more attribute, behind another one that stands in its tag."""
    if after.written_in is not None:
        return None
    source, _, end = after.span
    return (Edit(Span(source, end + 1, end + 1), f' {name}="{value}"'),)


def escaped(text: str) -> str:
    """A text as it stands in an attribute with either quotes, or between tags."""
    return text.translate(_ESCAPES)


def replace_value(attribute: Attribute, value: str) -> tuple[Edit, ...] | None:
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


def rewrite(at: Element | Attribute, text: str) -> tuple[Edit, ...] | None:
    """Give an attribute another value, or an element another text."""
    return replace_value(at, text) if isinstance(at, Attribute) else replace_text(at, text)


def fix_value(at: Element | Attribute, text: str | None) -> Fix | None:
    """The fix that writes another value; None without one, or where it cannot be written."""
    if not text:
        return None
    written = f'{at.name}="{text}"' if isinstance(at, Attribute) else f"<{at.tag}>{text}</{at.tag}>"
    return Fix.of(f"write {written}", rewrite(at, text))


def fix_tag(element: Element, tag: str | None) -> Fix | None:
    """The fix that writes another tag; None without one, or where it cannot be written."""
    return Fix.of(f"rename it to <{tag}>", rename_element(element, tag)) if tag else None


def scale_limits(limit: Element, factor: float) -> tuple[Edit, ...] | None:
    """Multiply the ends of a ``<limit>``, each of which is a number, by a factor; zeros stay."""
    ends = [limit.attributes[key] for key in ("lower", "upper") if key in limit.attributes]
    return all_or_none(
        replace_value(end, f"{float(end.value) * factor:.10g}") for end in ends if float(end.value)
    )


def swap(one: Element | Attribute, other: Element | Attribute) -> tuple[Edit, ...] | None:
    """Give each of two attributes or elements the value of the other."""
    first, second = rewrite(one, _value(other)), rewrite(other, _value(one))
    return (*first, *second) if first and second else None


def _value(at: Element | Attribute) -> str:
    return at.value if isinstance(at, Attribute) else at.text.strip()


def remove_element(element: Element) -> tuple[Edit, ...]:
    """Take an element out, with its line where nothing else stands on it."""
    return remove_elements([element])


def remove_elements(elements: Iterable[Element]) -> tuple[Edit, ...]:
    """Take elements of one source out, with their lines where nothing else stands on them."""
    return remove_spans(element.tag_at.whole_span for element in elements)


def remove_spans(spans: Iterable[Span]) -> tuple[Edit, ...]:
    """Take pieces of one source out, with their lines where nothing else stands on them."""
    pieces: list[Span] = []
    for span in sorted(spans, key=lambda span: span.start):
        last = pieces[-1] if pieces else None
        if last and not span.source.data[last.end : span.start].strip():
            pieces[-1] = Span(span.source, last.start, span.end)
        else:
            pieces.append(span)
    return tuple(Edit(_with_line(piece), "") for piece in pieces)


def _with_line(span: Span) -> Span:
    """A piece of a file with its line; the lines around it close up."""
    source, start, end = span
    line_start, line_end = _line(source, start, end)
    before, after = source.data[line_start:start], source.data[end:line_end]
    if before.strip():
        return span
    if after.strip():  # a comment, say, which takes its place
        return Span(source, start, line_end - len(after.lstrip()))
    above, _ = _line(source, line_start - 1, line_start - 1) if line_start else (0, 0)
    _, below = _line(source, line_end, line_end)
    if not source.data[above:line_start].strip() and not source.data[line_end:below].strip():
        return Span(source, above, line_end)  # of two blank lines, one
    return Span(source, line_start, line_end)


def insert_before(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Put lines of XML before an element, indented as it is."""
    source, start, _ = element.span
    separator = newline(source) + (indent_of(element.span) or "")
    text = "".join(line + separator for line in lines)
    return (Edit(Span(source, start, start), text),)


def insert_after(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Put lines of XML behind an element, indented as it is."""
    return insert_behind(element.tag_at.whole_span, lines)


def insert_behind(span: Span, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Put lines of XML behind a piece of a file, indented as it is."""
    source, _, end = span
    return (Edit(Span(source, end, end), _below(span, lines)),)


def replace(span: Span, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Put lines of XML in the place of a piece of a file, indented as it is."""
    return (Edit(span, _below(span, lines).lstrip()),)


def _below(span: Span, lines: Iterable[str]) -> str:
    """Lines, each behind a line end and indented as a piece of a file is."""
    end, indent = newline(span.source), indent_of(span) or ""
    return "".join(end + indent + line if line else end for line in lines)


def insert_first(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Put lines of XML into an element, before what it holds."""
    return _inserted(element, lines, element.tag_at.inner_start)


def insert_last(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Put lines of XML into an element, behind what it holds."""
    source, start, end = element.tag_at.inner_span
    return _inserted(element, lines, start + len(source.data[start:end].rstrip()))


def _inserted(element: Element, lines: Iterable[str], at: int) -> tuple[Edit, ...]:
    tag = element.tag_at
    if tag.close == tag.start:
        return _opened(element, lines)
    separator = _before_content(element)
    return (Edit(Span(tag.source, at, at), "".join(separator + line for line in lines)),)


def _opened(element: Element, lines: Iterable[str]) -> tuple[Edit, ...]:
    """Lines in an element that is written as ``<a/>``, which becomes ``<a>...</a>``."""
    source, start, end = element.span
    slash = start + len(source.data[start : end - 2].rstrip())
    outer = newline(source) + (indent_of(element.span) or "")
    inner = "".join(f"{outer}{STEP}{line}" for line in lines)
    return (Edit(Span(source, slash, end), f">{inner}{outer}</{element.tag}>"),)


def _before_content(element: Element) -> str:
    """What stands between the start tag and what the element holds: a line end, or nothing."""
    source, start, end = element.tag_at.inner_span
    data = source.data[start:end]
    space = data[: len(data) - len(data.lstrip())].decode()
    if "\n" not in space:
        return ""
    if not data.strip():  # it holds nothing, and the end tag stands below
        return newline(source) + (indent_of(element.span) or "") + STEP
    return newline(source) + space.rpartition("\n")[2]


def move_after(element: Element, anchor: Element) -> tuple[Edit, ...]:
    """Move an element behind another one that it is in, indented as that one."""
    source, _, end = anchor.tag_at.whole_span
    new = indent_of(anchor.span)
    if indent_of(element.span) is None or new is None:
        text = element.tag_at.whole_span.text
    else:
        text = "".join(newline(source) + new + line for line in lines_of(element))
    return (*remove_element(element), Edit(Span(source, end, end), text))


def lines_of(element: Element) -> list[str]:
    """The text of an element as lines, without the indentation that it has."""
    own = indent_of(element.span) or ""
    text = element.tag_at.whole_span.text.replace("\r\n", "\n")
    return [line.removeprefix(own) for line in text.split("\n")]


def from_macro(element: Element) -> bool:
    """True if a macro wrote the element, so that one edit would change all of its calls."""
    frame = element.frame
    while frame is not None:
        if frame.kind == "macro":
            return True
        frame = frame.outer
    return False


def indent_of(span: Span) -> str | None:
    """The white space before a piece of a file on its line; None if something else stands there."""
    source, start, end = span
    before = source.data[_line(source, start, end)[0] : start].decode("utf-8", "replace")
    return None if before.strip() else before


def newline(source: Source) -> str:
    return "\r\n" if b"\r\n" in source.data else "\n"


def _line(source: Source, start: int, end: int) -> tuple[int, int]:
    """The whole lines that hold some bytes, with the last line end."""
    after = source.data.find(b"\n", end)
    return source.data.rfind(b"\n", 0, start) + 1, after + 1 or len(source.data)
