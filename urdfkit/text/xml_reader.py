"""Reading of plain XML into documents with source locations.

Reading never raises on a bad robot. A defect of the text is returned as a Problem, which names the
rule that explains it; the rules XML and XAC turn Problems into findings.
"""

from __future__ import annotations

import gc
import re
from xml.parsers import expat

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.text.comments import blank_comments
from urdfkit.text.diagnostic import Edit, Fix, Problem, Related, Severity
from urdfkit.text.document import Attribute, CallFrame, Document, Element, Tag
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_declaration import encoding_problems, without_declaration

if TYPE_CHECKING:
    from urdfkit.text.tag_matching import SyntaxMistake

#: Most elements and attributes of a document; the largest real robot has 40 000 elements.
MAX_ELEMENTS = 1_000_000
#: Most entities and nested groups of a DTD; expat processes both by recursion.
MAX_DTD_DEPTH = 1000
#: The value of a namespace, in the root element of a well-formed file.
_SPACED_NAMESPACE = rb"""\sxmlns(?::[\w.-]+)?\s*=\s*["']([^"'<>\s]*\s[^"'<>]*)["']"""
#: Most locations of the same defect that are reported.
MAX_RELATED = 5

#: What the prefixes of attributes of Gazebo stand for.
_ADDRESSES = dict.fromkeys(("gz", "ignition"), "http://gazebosim.org/schema")


class DocumentTooLarge(Exception):
    """The document is larger than any robot."""


def read_xml(
    source: Source, frame: CallFrame | None = None
) -> tuple[Document | None, list[Problem]]:
    """Read plain XML.

    Input that urdfdom loads although it is not strict XML (text before the declaration, another
    version number, undeclared prefixes) is read, and reported as a Problem.

    Args:
        frame: the launch file that refers to it, if any.

    Returns:
        The document, or None if it is not well formed, and its problems.
    """
    problems = encoding_problems(source, strict=False)
    data = without_declaration(source, problems)
    builder = _DocumentBuilder(source, frame)
    try:
        builder.parse(data)
    except expat.ExpatError:
        return None, [*problems, *builder.problems, *syntax_problems(source, data)]
    except DocumentTooLarge as error:
        top = Span(source, 0, 0)
        return None, [*problems, Problem("XAC013", top, str(error))]
    problems += builder.problems
    problems += builder.undeclared_prefixes() + builder.unexpanded()
    assert builder.root is not None
    return Document(builder.root, (source,)), problems


def read_as_tinyxml(source: Source) -> tuple[Document | None, list[Problem]]:
    """Read XML as TinyXML does, the parser of Gazebo and MoveIt.

    It ends a comment at the first ``-->``, whatever the comment contains, and does not mind tags
    behind the end of the root element.
    """
    document, problems = read_xml(source)
    if document is None:
        data = blank_comments(source.data) if b"<!--" in source.data else source.data
        lenient = read_xml(Source(source.path, _without_tags_behind(data)))
        return lenient if lenient[0] is not None else (None, problems)
    return document, problems


def _without_tags_behind(data: bytes) -> bytes:
    """XML up to the end of its root element, if a tag follows that."""
    root = re.search(rb"<([A-Za-z_][^\s/>]*)", data)
    end = re.search(rb"</" + re.escape(root[1]) + rb"\s*>", data) if root else None
    is_followed = end is not None and data[end.end() :].lstrip().startswith(b"<")
    return data[: end.end()] if end is not None and is_followed else data


def require_shallow_dtd(data: bytes) -> None:
    """Reject declarations that could overflow the stack of expat.

    Raises:
        DocumentTooLarge: there are too many entities, or parentheses in an element declaration,
            for the recursion of expat.
    """
    if data.count(b"<!ENTITY") > MAX_DTD_DEPTH:
        raise DocumentTooLarge(f"more than {MAX_DTD_DEPTH} entity declarations")
    if data.count(b"(") > MAX_DTD_DEPTH:
        declarations = re.findall(rb"<!ELEMENT[^>]*", data)
        if any(text.count(b"(") > MAX_DTD_DEPTH for text in declarations):
            raise DocumentTooLarge(f"more than {MAX_DTD_DEPTH} groups in an element declaration")


class _DocumentBuilder:
    """Builds Elements from expat's events."""

    def __init__(self, source: Source, frame: CallFrame | None = None) -> None:
        self.source = source
        self.frame = frame
        self.root: Element | None = None
        self.problems: list[Problem] = []
        self._open: list[Element] = []
        self._text: list[list[str]] = []
        self._count = 0
        self._prefixed: dict[str, Element] = {}
        self._unexpanded: list[Element] = []
        # Without namespaces, like urdfdom: an undeclared prefix is part of the name.
        self._parser = parser = expat.ParserCreate("utf-8")
        parser.ordered_attributes = True
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        parser.EntityDeclHandler = self._entity

    def parse(self, data: bytes) -> None:
        """Build the document.

        Raises:
            xml.parsers.expat.ExpatError: it is not well formed.
            DocumentTooLarge: it is larger than any robot.
        """
        require_shallow_dtd(data)
        collecting = gc.isenabled()
        gc.disable()  # the document contains no garbage
        try:
            self._parser.Parse(data, True)
        finally:
            if collecting:
                gc.enable()

    def _start(self, name: str, attributes: list[str]) -> None:
        self._count += 1 + len(attributes) // 2
        if self._count > MAX_ELEMENTS:
            raise DocumentTooLarge(f"more than {MAX_ELEMENTS} elements and attributes")
        at = self._parser.CurrentByteIndex
        parent = self._open[-1] if self._open else None
        element = Element(name, Tag(self.source, at, at), parent, self.frame)
        for key, value in zip(attributes[::2], attributes[1::2], strict=True):
            element.attributes[key] = Attribute(key, value, element)
        for qualified in (name, *element.attributes):
            prefix, colon, _ = qualified.partition(":")
            if colon and prefix not in ("xml", "xmlns"):
                self._prefixed.setdefault(prefix, element)
        if name.startswith("xacro:"):
            self._unexpanded.append(element)
        if parent is None:
            self.root = element
        else:
            parent.children.append(element)
        self._open.append(element)
        self._text.append([])

    def _end(self, name: str) -> None:
        element = self._open.pop()
        element.text = "".join(self._text.pop())
        empty = not (element.children or element.text)
        start, end = element.tag_at.start, self._parser.CurrentByteIndex
        element.tag_at = Tag.between(self.source, start, end, empty=empty)

    def _characters(self, data: str) -> None:
        self._text[-1].append(data)

    def undeclared_prefixes(self, *, strict: bool = False) -> list[Problem]:
        """Prefixes without ``xmlns``: strict parsers reject them, urdfdom does not."""
        problems = []
        for prefix, first in self._prefixed.items():
            element: Element | None = first
            while element is not None and f"xmlns:{prefix}" not in element.attributes:
                element = element.parent
            if element is None and (strict or prefix != "xacro" or not self._unexpanded):
                problems.append(_undeclared(prefix, first))
        return problems

    def unexpanded(self) -> list[Problem]:
        if not self._unexpanded:
            return []
        first, *others = self._unexpanded
        count = f", the first of {1 + len(others)}" if others else ""
        message = f"<{first.tag}> calls a xacro macro{count}, but no macro is defined here"
        notes = tuple(Related(other.span, f"<{other.tag}>") for other in others[:MAX_RELATED])
        return [Problem("XAC003", first.tag_at.name_span, message, related=notes)]

    def _entity(self, name: str, *_: object) -> None:
        at = self._parser.CurrentByteIndex
        self.problems.append(entity_problem(self.source, at, name))
        # With a default handler, expat does not expand references.
        self._parser.DefaultHandler = _ignore


def _undeclared(prefix: str, first: Element) -> Problem:
    tag = first.tag_at
    at = tag.name_span
    if not first.tag.startswith(f"{prefix}:"):
        name = next(name for name in first.attributes if name.startswith(f"{prefix}:"))
        start = tag.span.source.data.find(name.encode(), tag.start, tag.inner_start)
        at = Span(tag.source, start, start + len(name.encode())) if start >= 0 else tag.span
    message = f"the prefix '{prefix}:' is used but never declared"
    address = _ADDRESSES.get(prefix, "...")
    help = f'declare it on the root element: xmlns:{prefix}="{address}"'
    if prefix == "ignition":
        help += "; Garden and later read gz: instead"
    return Problem("XML007", at, message, help)


def unbound_prefixes(source: Source) -> list[Problem]:
    """Problems of undeclared prefixes in a well-formed file, which strict parsers reject."""
    builder = _DocumentBuilder(source)
    try:
        builder.parse(without_declaration(source, []))
    except (expat.ExpatError, DocumentTooLarge):
        return syntax_problems(source)
    assert builder.root is not None
    root = builder.root
    problems = []
    for problem in builder.undeclared_prefixes(strict=True):
        fix = None
        help = problem.help
        if problem.message.startswith("the prefix 'xacro:'"):
            help = ""
            end = root.tag_at.name_span.end
            text = ' xmlns:xacro="http://www.ros.org/wiki/xacro"'
            edit = Edit(Span(source, end, end), text)
            fix = Fix("declare the prefix on the root element", (edit,), safe=True)
        problems.append(problem._replace(help=help, fix=fix, severity=Severity.ERROR))
    return problems or [_expat_problem(source, source.data, namespaces=True)]


def _ignore(_: str) -> None:
    pass


def entity_problem(source: Source, at: int, name: str) -> Problem:
    """The problem of an entity declaration, which is ignored; ``at`` is an offset in it."""
    start = max(source.data.rfind(b"<!ENTITY", 0, at + 8), 0)
    return Problem("XML003", Span(source, start, start + 8), f"entity '{name}' is declared")


def syntax_problems(source: Source, data: bytes | None = None) -> list[Problem]:
    """All syntax errors of a file that is not well formed.

    Args:
        data: the parsed text, if it differs from the file; with the same offsets.
    """
    from urdfkit.text.xml_errors import syntax_mistakes  # needed for broken files only

    data = source.data if data is None else data
    problems = [
        Problem(
            "XML001",
            Span(source, mistake.start, mistake.end),
            mistake.message,
            mistake.help or ("move it into the root element" if mistake.trailing else ""),
            related=tuple(Related(Span(source, *place), text) for *place, text in mistake.notes),
            fix=_fix(source, mistake),
        )
        for mistake in syntax_mistakes(data)
    ]
    return problems or [_expat_problem(source, data)]


def _fix(source: Source, mistake: SyntaxMistake) -> Fix | None:
    """The fix of a mistake; it is safe, since only comments have one."""
    edits = tuple(Edit(Span(source, *place), text) for *place, text in mistake.fix)
    return Fix(mistake.help, edits, safe=True) if edits else None


def _expat_problem(source: Source, data: bytes, *, namespaces: bool = False) -> Problem:
    """The error of expat, for a file that only expat rejects."""
    parser = expat.ParserCreate("utf-8", " " if namespaces else None)
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        at = parser.ErrorByteIndex
        return Problem("XML001", Span(source, at, at), expat.ErrorString(error.code))
    if declared := re.search(_SPACED_NAMESPACE, data):
        message = "white space in a namespace: xacro and Python's XML parsers reject the file"
        return Problem(
            "XML001", Span(source, *declared.span(1)), message, "write the namespace without it"
        )
    return Problem("XML001", Span(source, 0, 0), "not well-formed")
