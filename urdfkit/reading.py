"""Reading one description, plain or xacro, whatever state it is in.

Reading never raises on a bad robot. What is wrong with the text becomes a Problem, which names
the rule that explains it; the rules XML and XAC turn Problems into findings.
"""

from __future__ import annotations

import re
from typing import NamedTuple
from xml.parsers import expat

from urdfkit.diagnostic import Fix, Related
from urdfkit.document import Attribute, Document, Element, Frame, Tag
from urdfkit.source import Source, Span

#: Elements of one document; the largest real robot has 40 000.
MAX_ELEMENTS = 1_000_000
MAX_SYNTAX_ERRORS = 100

_DECLARATION = re.compile(rb"<\?xml\b[^>]*\?>")
_VERSION = re.compile(rb"""\bversion\s*=\s*["']([^"']*)["']""")


class Problem(NamedTuple):
    """Something wrong with the text of a description.

    Attributes:
        code: the rule that explains it.
        span: where.
        message: what.
        help: what to do; the rule's own help if empty.
        frame: the macro calls and includes that led there.
        related: other places that explain it.
        fix: a remedy as text edits.
    """

    code: str
    span: Span
    message: str
    help: str = ""
    frame: Frame | None = None
    related: tuple[Related, ...] = ()
    fix: Fix | None = None


class TooMuch(Exception):
    """The document is larger than any robot."""


def is_xacro(source: Source) -> bool:
    """Decide by content whether a file is xacro; the suffix says nothing.

    17 of 676 public models are xacro in a ``.urdf``, and many a plain URDF still declares the
    namespace of the xacro it once came from. A file named ``.xacro`` is taken at its word.
    """
    if source.path.endswith(".xacro"):
        return True
    data = source.data
    if b"xmlns:xacro" not in data:
        return False
    return b"<xacro:" in data or b"${" in data or b"$(" in data


def read_xml(source: Source) -> tuple[Document | None, list[Problem]]:
    """Read plain XML.

    What urdfdom loads although it is not strict XML (text before the declaration, another
    version number, undeclared prefixes) is read, and told as a Problem.

    Returns:
        The document, or None if it is not well formed, and what is wrong with it.
    """
    problems = encoding_problems(source)
    start = _skip_to_declaration(source, problems)
    builder = _Builder(source, start)
    try:
        builder.parse(_with_version_1(source, start, problems))
    except expat.ExpatError:
        return None, [*problems, *builder.problems, *syntax_problems(source)]
    except TooMuch as error:
        top = Span(source, 0, 0)
        return None, [*problems, Problem("XAC013", top, str(error))]
    problems += builder.problems
    problems += builder.undeclared_prefixes()
    assert builder.root is not None
    return Document(builder.root, (source,)), problems


def encoding_problems(source: Source) -> list[Problem]:
    """A byte that is not text in the encoding of the file."""
    if source.undecodable is None:
        return []
    at = Span(source, source.undecodable, source.undecodable + 1)
    return [Problem("XML002", at, f"this byte is not {source.encoding}")]


def _skip_to_declaration(source: Source, problems: list[Problem]) -> int:
    """Offset of the XML declaration if something stands before it, else 0."""
    declaration = _DECLARATION.search(source.data, 0, 20_000)
    if declaration is None or declaration.start() == 0:
        return 0
    before = Span(source, 0, declaration.start())
    what = "white space" if not before.text.strip() else "text"
    problems.append(Problem("XML007", before, f"{what} before the XML declaration"))
    return declaration.start()


def _with_version_1(source: Source, start: int, problems: list[Problem]) -> bytes:
    """The bytes to parse; an XML declaration that expat would refuse is blanked out."""
    data = source.data[start:]
    declaration = _DECLARATION.match(data)
    if declaration is None:
        return data
    version = _VERSION.search(declaration.group())
    if version is None or version.group(1) not in (b"1.0", b"1.1"):
        at = Span(source, start, start + declaration.end())
        problems.append(Problem("XML007", at, 'the XML declaration lacks version="1.0"'))
    # The encoding is settled by Source; the declaration has nothing more to say.
    return b" " * declaration.end() + data[declaration.end() :]


class _Builder:
    """Builds Elements from expat's events."""

    def __init__(self, source: Source, offset: int) -> None:
        self.source = source
        self.offset = offset
        self.root: Element | None = None
        self.problems: list[Problem] = []
        self._open: list[Element] = []
        self._text: list[list[str]] = []
        self._count = 0
        self._prefixed: dict[str, Element] = {}
        # Without namespaces, as urdfdom reads: an undeclared prefix is part of the name.
        self._parser = parser = expat.ParserCreate("utf-8")
        parser.ordered_attributes = True
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        parser.EntityDeclHandler = self._entity

    def parse(self, data: bytes) -> None:
        self._parser.Parse(data, True)

    def _start(self, name: str, attributes: list[str]) -> None:
        self._count += 1
        if self._count > MAX_ELEMENTS:
            raise TooMuch(f"more than {MAX_ELEMENTS} elements")
        at = self.offset + self._parser.CurrentByteIndex
        parent = self._open[-1] if self._open else None
        element = Element(name, Tag(self.source, at, at), parent)
        for key, value in zip(attributes[::2], attributes[1::2], strict=True):
            element.attributes[key] = Attribute(key, value, element)
        for qualified in (name, *element.attributes):
            prefix, colon, _ = qualified.partition(":")
            if colon and prefix not in ("xml", "xmlns"):
                self._prefixed.setdefault(prefix, element)
        if parent is None:
            self.root = element
        else:
            parent.children.append(element)
        self._open.append(element)
        self._text.append([])

    def _end(self, name: str) -> None:
        element = self._open.pop()
        element.text = "".join(self._text.pop())
        tag = element.tag_at
        close = self.offset + self._parser.CurrentByteIndex
        if self.source.data.startswith(b"</", close):
            element.tag_at = tag._replace(close=close)

    def _characters(self, data: str) -> None:
        self._text[-1].append(data)

    def undeclared_prefixes(self) -> list[Problem]:
        """Prefixes without ``xmlns``: strict readers refuse them, urdfdom does not."""
        found = []
        for prefix, first in self._prefixed.items():
            element: Element | None = first
            while element is not None and f"xmlns:{prefix}" not in element.attributes:
                element = element.parent
            if element is None:
                message = f"the prefix '{prefix}:' is used but never declared"
                found.append(Problem("XML007", first.tag_at.name_span, message))
        return found

    def _entity(self, name: str, *_: object) -> None:
        at = self.offset + self._parser.CurrentByteIndex
        self.problems.append(entity_problem(self.source, at, name))
        # With a default handler set, expat hands over references instead of expanding them.
        self._parser.DefaultHandler = _ignore


def _ignore(_: str) -> None:
    pass


def entity_problem(source: Source, at: int, name: str) -> Problem:
    """An entity declaration, which is read over."""
    return Problem("XML003", Span(source, at, at + 8), f"entity '{name}' is declared")


def syntax_problems(source: Source) -> list[Problem]:
    """All syntax errors of a file that is not well formed, by lxml's recovering parser."""
    if not source.data.strip():
        return [Problem("XML001", Span(source, 0, 0), "the file is empty")]
    from lxml import etree  # 25 ms, and needed for broken files only

    parser = etree.XMLParser(recover=True, resolve_entities=False, no_network=True)
    try:
        etree.fromstring(source.data, parser)
    except (etree.XMLSyntaxError, ValueError):
        pass  # the log below says why
    problems: list[Problem] = []
    for entry in list(parser.error_log)[:MAX_SYNTAX_ERRORS]:
        if entry.type_name.startswith("NS_"):
            continue
        at = source.offset(entry.line, entry.column)
        code = "XML006" if entry.type_name == "ERR_DOCUMENT_END" else "XML001"
        problems.append(Problem(code, Span(source, at, at), entry.message.strip()))
    return problems or [_expat_problem(source)]


def _expat_problem(source: Source) -> Problem:
    """What expat says, for a file that only expat refuses."""
    parser = expat.ParserCreate("utf-8")
    try:
        parser.Parse(source.data, True)
    except expat.ExpatError as error:
        at = parser.ErrorByteIndex
        return Problem("XML001", Span(source, at, at), expat.ErrorString(error.code))
    return Problem("XML001", Span(source, 0, 0), "not well-formed")
