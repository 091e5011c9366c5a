"""An element contains text, which URDF does not use.

All values in URDF are attributes; parsers ignore text between the tags. A value that is written as
in SDF, `<origin>0 0 0.1</origin>`, is lost without a message, and a part of a comment or a doubled
`>` is a mistake in editing. A comment in the style of another language, `## wheels`, is an info.

Sources:
    URDF, XML specification: http://wiki.ros.org/urdf/XML
"""

import re

from urdfkit.lint.rules import Context, Finding, Findings, Location, Severity, rule
from urdfkit.robot.samples import link_xml, visual_xml
from urdfkit.text.document import Element
from urdfkit.text.grammar import owner
from urdfkit.text.source import Source, Span

BAD = link_xml("arm", visual_xml('<box size="0.1 0.1 0.2"/>', "<origin>0 0 0.1</origin>"))
GOOD = BAD.replace("<origin>0 0 0.1</origin>", '<origin xyz="0 0 0.1"/>')

#: An attribute may contain ">".
_TAGS = rb"""<!--[\s\S]*?(?:-->|\Z)|<(?:"[^"]*"|'[^']*'|[^<>"'])*>"""
#: Number of characters of a text that a message contains.
_MAX_CHARACTERS = 40


@rule(Severity.WARNING, help="write the value as an attribute, or remove it")
def check(context: Context) -> Findings:
    for deviation in context.deviations.get("URD017", ()):
        element = deviation.element
        text = element.text.strip().split("\n")[0].rstrip()
        shown = text if len(text) <= _MAX_CHARACTERS else f"{text[:_MAX_CHARACTERS]}..."
        message = f"{owner(element)}: URDF parsers ignore the text '{shown}' in <{element.tag}>"
        place = _place(element, text.encode(), context.document.sources)
        is_comment = text.startswith(("#", "//"))
        yield Finding(place, message, severity=Severity.INFO if is_comment else None)


def _place(element: Element, text: bytes, sources: tuple[Source, ...]) -> Location | Element:
    """The span of the text, if a source contains it literally; else that of the tag around it."""
    source, start, end = element.tag_at.inner_span
    inside = re.sub(_TAGS, _blank, source.data[start:end])
    written = dict.fromkeys((text, text.replace(b">", b"&gt;")))
    for spelling in written:
        if spelling in inside:
            at = start + inside.find(spelling)
            return Location(Span(source, at, at + len(spelling)), element.frame)
    texts = {file: re.sub(_TAGS, _blank, file.data) for file in sources}  # a file may be included
    places = [(source, text) for source, bare in texts.items() for text in written if text in bare]
    if len(places) != 1 or texts[places[0][0]].count(places[0][1]) != 1:
        return element
    source, spelling = places[0]
    at = texts[source].find(spelling)
    return Location(Span(source, at, at + len(spelling)), element.frame)


def _blank(tag: re.Match[bytes]) -> bytes:
    """Spaces in place of a tag, so that offsets are preserved."""
    return b" " * len(tag.group())
