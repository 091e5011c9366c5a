"""Everything that a file may lack, have twice, have empty or have garbled, one at a time."""

import re
from collections.abc import Iterator

from urdfkit.text.document import Document
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

#: Values that no attribute has.
GARBLED = ("", "x", "nan", "-1", "0", "1e400", "1 2 3", "1 2 3 4", "${x}", "\u0663", "a/b:c", "  ")
_ATTRIBUTE = r"\s+[\w:.-]+\s*=\s*(\"[^\"<]*\"|'[^'<]*')"
_YAML_LINE = r"(?m)^(\s*(?:- )?)([^\s:#][^:\n]*)(:?)(.*)\n?"


def damaged(text: str) -> Iterator[str]:
    """A text with one defect, for every place and defect there is."""
    document = read_xml(Source("a.xml", text.encode("utf-8", "surrogateescape")))[0]
    if document is not None:
        yield from _damaged_elements(document)
    if text.lstrip().startswith("<"):
        for found in re.finditer(_ATTRIBUTE, text):
            yield text[: found.start()] + text[found.end() :]
            start, end = found.start(1) + 1, found.end(1) - 1
            for value in (*GARBLED, f"{found[1][1:-1]} {found[1][1:-1]}"):
                yield text[:start] + value + text[end:]
        return
    for found in re.finditer(_YAML_LINE, text):
        head, tail = text[: found.start()], text[found.end() :]
        indent, key, colon, value = found.groups()
        for line in ("", found[0] * 2, f"{indent}x{colon}{value}\n", f"{indent}[{key}]:{value}\n"):
            yield head + line + tail
        for other in (*GARBLED, "[]", "{}", "[[x]]", "{a: {b: c}}", "~", "|", "*a"):
            yield f"{head}{indent}{key}{colon} {other}\n{tail}"


def _damaged_elements(document: Document) -> Iterator[str]:
    """Each element removed, doubled, or without its content."""
    data = document.root.tag_at.source.data
    for element in document.root.walk():
        whole, inner = element.tag_at.whole_span, element.tag_at.inner_span
        own = data[whole.start : whole.end]
        pieces = [(whole.start, whole.end, b""), (whole.end, whole.end, own)]
        if inner.end > inner.start:
            pieces.append((inner.start, inner.end, b""))
            pieces.append((inner.start, inner.end, b"x"))
        for start, end, new in pieces:
            yield (data[:start] + new + data[end:]).decode("utf-8", "surrogateescape")
