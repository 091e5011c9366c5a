"""Reading one description, plain or xacro, whatever state it is in.

Reading never raises on a bad robot. What is wrong with the text becomes a Problem, which names
the rule that explains it; the rules XML and XAC turn Problems into findings.
"""

from __future__ import annotations

import gc
import os
import re
from typing import TYPE_CHECKING
from xml.parsers import expat

from urdfkit.core.record import Record
from urdfkit.text.comments import without_comments
from urdfkit.text.diagnostic import Edit, Fix, Related, Severity
from urdfkit.text.document import Attribute, CallFrame, Document, Element, Tag
from urdfkit.text.source import Source, Span

if TYPE_CHECKING:
    from urdfkit.text.tag_matching import SyntaxMistake

#: Elements of one document; the largest real robot has 40 000.
MAX_ELEMENTS = 1_000_000
#: Places of the same defect that are worth naming.
MAX_RELATED = 5

# Compiled when needed, which is seldom.
_DECLARATION = rb"<\?xml[\s?][^>]*\?>|<\?xml\?>"
_OWN_TAG = rb"<xacro:(macro|include|property|arg|if|unless|insert_block|element|attribute|call)\b"
_VERSION = rb"""\bversion\s*=\s*["']([^"']*)["']"""
_UTF_8 = ("utf-8", "utf8", "utf-8-sig", "us-ascii", "ascii")


class Problem(Record):
    """Something wrong with the text of a description.

    Attributes:
        code: the rule that explains it.
        span: where.
        message: what.
        help: what to do; the rule's own help if empty.
        frame: the macro calls and includes that led there.
        related: other places that explain it.
        fix: as text edits.
        severity: if it is not that of the rule.
    """

    code: str
    span: Span
    message: str
    help: str = ""
    frame: CallFrame | None = None
    related: tuple[Related, ...] = ()
    fix: Fix | None = None
    severity: Severity | None = None


class DocumentTooLarge(Exception):
    """The document is larger than any robot."""


def is_xacro(source: Source) -> bool:
    """Decide by content whether a file is xacro.

    17 of 676 public models are xacro in a ``.urdf``, and many a plain URDF still declares the
    namespace of the xacro it once came from, or holds a call that no macro answers any more:
    readers of URDF pass over those. A file whose name says xacro is taken at its word.
    """
    if ".xacro" in os.path.basename(source.path).lower():
        return True
    data = source.data
    has_tags, has_namespace = b"<xacro:" in data, b"xmlns:xacro" in data
    if not has_tags and not has_namespace:
        return False
    text = without_comments(data)
    if has_tags and re.search(_OWN_TAG, text):
        return True
    return has_namespace and re.search(rb"\$[{(]", text) is not None


_LAUNCH = (
    ".launch", ".launch.xml", "_launch.xml", ".launch.py", "_launch.py",
    ".launch.yaml", "_launch.yaml", ".launch.yml", "_launch.yml",
)  # fmt: skip


def is_launch(path: str) -> bool:
    """True for the names that launch files have."""
    return path.endswith(_LAUNCH)


def read_xml(
    source: Source, frame: CallFrame | None = None
) -> tuple[Document | None, list[Problem]]:
    """Read plain XML.

    What urdfdom loads although it is not strict XML (text before the declaration, another
    version number, undeclared prefixes) is read, and told as a Problem.

    Args:
        source: the file.
        frame: the launch file that asks for it, if one does.

    Returns:
        The document, or None if it is not well formed, and what is wrong with it.
    """
    problems = encoding_problems(source, strict=False)
    data = _forgiven(source, problems)
    builder = _Builder(source, frame)
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


def encoding_problems(source: Source, *, strict: bool) -> list[Problem]:
    """An encoding that readers do not know, or a byte that is not text in it.

    Args:
        source: the file.
        strict: True where only UTF-8 is read, as by xacro.
    """
    if source.undecodable is not None:
        return [_undecodable(source, source.undecodable)]
    encoding = source.encoding
    if encoding in _UTF_8 or (source.data.isascii() and not encoding.startswith("utf-")):
        return []
    if not strict and _is_known_to_expat(encoding):
        return []
    reader = "xacro" if strict else "urdfdom"
    message = f"the file is in {encoding}; {reader} reads UTF-8 only"
    return [Problem("XML002", Span(source, 0, 0), message)]


def _undecodable(source: Source, start: int) -> Problem:
    at = Span(source, start, start + 1)
    declared = re.search(rb"encoding\s*=\s*[\"']([^\"']*)", source.data[:200])
    if declared is None:
        message = f"this byte is not {source.encoding}, which XML takes where nothing is declared"
        return Problem("XML002", at, message)
    try:
        "".encode(source.encoding)
    except (LookupError, UnicodeError):  # the latter of the codec 'undefined'
        at = Span(source, *declared.span(1))
        return Problem("XML002", at, f"the declared encoding '{source.encoding}' does not exist")
    return Problem("XML002", at, f"this byte is not {source.encoding}, which the file declares")


def _is_known_to_expat(encoding: str) -> bool:
    """True for encodings of one byte per character, in which urdfdom at least finds the tags."""
    if encoding.startswith("utf-"):
        return False
    try:
        expat.ParserCreate().Parse(
            f'<?xml version="1.0" encoding="{encoding}"?><a/>'.encode(), True
        )
    except (expat.ExpatError, LookupError, ValueError):
        return False
    return True


def _forgiven(source: Source, problems: list[Problem]) -> bytes:
    """The bytes to parse: what urdfdom forgives in and before the XML declaration is blanked."""
    data = source.data
    declaration = re.search(_DECLARATION, data[:20_000])
    if declaration is None:
        return data
    start, end = declaration.span()
    if start:
        if without_comments(data[:start]).strip():
            return data
        problems.append(_before_declaration(Span(source, 0, start), end))
    if not _is_sound(declaration.group()):
        at = Span(source, start, end)
        fix = Fix("write the XML declaration anew", (Edit(at, '<?xml version="1.0"?>'),), safe=True)
        message = "the XML declaration is not that of XML 1.0"
        problems.append(Problem("XML007", at, message, fix=fix))
    # The encoding is settled by Source; the declaration has nothing more to say.
    return b" " * end + data[end:]


def _is_sound(declaration: bytes) -> bool:
    """True for an XML declaration that strict readers accept."""
    version = re.search(_VERSION, declaration)
    if version is None or version.group(1) not in (b"1.0", b"1.1"):
        return False
    try:
        expat.ParserCreate("utf-8").Parse(declaration + b"<a/>", True)
    except expat.ExpatError:
        return False
    return True


def _before_declaration(before: Span, end: int) -> Problem:
    """What stands before the XML declaration, which ends at ``end``."""
    text = before.text.strip()
    edits: tuple[Edit, ...] = (Edit(before, ""),)
    if not text:
        message = "white space before the XML declaration"
        fix = Fix("delete the white space", edits, safe=True)
        return Problem(
            "XML007", before, message, "let <?xml ...?> be the first of the file", fix=fix
        )
    edits += (Edit(Span(before.source, end, end), f"\n{text}"),)
    return Problem(
        "XML007",
        before,
        "a comment before the XML declaration, which urdfdom 4 (ROS 2 Jazzy) rejects",
        "move the comment below <?xml ...?>",
        fix=Fix("move the comment below the XML declaration", edits, safe=True),
    )


class _Builder:
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
        # Without namespaces, as urdfdom reads: an undeclared prefix is part of the name.
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
            TooMuch: it is larger than any robot.
        """
        collecting = gc.isenabled()
        gc.disable()  # nothing of what is built is garbage
        try:
            self._parser.Parse(data, True)
        finally:
            if collecting:
                gc.enable()

    def _start(self, name: str, attributes: list[str]) -> None:
        self._count += 1
        if self._count > MAX_ELEMENTS:
            raise DocumentTooLarge(f"more than {MAX_ELEMENTS} elements")
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
        """Prefixes without ``xmlns``: strict readers refuse them, urdfdom does not."""
        found = []
        for prefix, first in self._prefixed.items():
            element: Element | None = first
            while element is not None and f"xmlns:{prefix}" not in element.attributes:
                element = element.parent
            if element is None and (strict or prefix != "xacro" or not self._unexpanded):
                found.append(_undeclared(prefix, first))
        return found

    def unexpanded(self) -> list[Problem]:
        """Tags of xacro in a plain file."""
        if not self._unexpanded:
            return []
        first, *others = self._unexpanded
        count = f", the first of {1 + len(others)}" if others else ""
        message = f"<{first.tag}> is a call of a xacro macro{count}, and no macro is defined here"
        notes = tuple(Related(other.span, f"<{other.tag}>") for other in others[:MAX_RELATED])
        return [Problem("XAC003", first.tag_at.name_span, message, related=notes)]

    def _entity(self, name: str, *_: object) -> None:
        at = self._parser.CurrentByteIndex
        self.problems.append(entity_problem(self.source, at, name))
        # With a default handler set, expat hands over references instead of expanding them.
        self._parser.DefaultHandler = _ignore


def _undeclared(prefix: str, first: Element) -> Problem:
    tag = first.tag_at
    at = tag.name_span
    if not first.tag.startswith(f"{prefix}:"):
        name = next(name for name in first.attributes if name.startswith(f"{prefix}:"))
        found = tag.span.source.data.find(name.encode(), tag.start, tag.inner_start)
        at = Span(tag.source, found, found + len(name.encode())) if found >= 0 else tag.span
    message = f"the prefix '{prefix}:' is used but never declared"
    help = f'declare it on the root element: xmlns:{prefix}="..."'
    return Problem("XML007", at, message, help)


def unbound_prefixes(source: Source) -> list[Problem]:
    """The prefixes that a well-formed file uses but does not declare, for a strict reader."""
    builder = _Builder(source)
    try:
        builder.parse(_forgiven(source, []))
    except (expat.ExpatError, DocumentTooLarge):
        return syntax_problems(source)
    assert builder.root is not None
    root = builder.root
    found = []
    for problem in builder.undeclared_prefixes(strict=True):
        fix = None
        help = problem.help
        if problem.message.startswith("the prefix 'xacro:'"):
            help = ""
            end = root.tag_at.name_span.end
            text = ' xmlns:xacro="http://www.ros.org/wiki/xacro"'
            edit = Edit(Span(source, end, end), text)
            fix = Fix("declare the prefix on the root element", (edit,), safe=True)
        error = problem._replace(help=help, fix=fix, severity=Severity.ERROR)
        found.append(error)
    return found or [_expat_problem(source, source.data, namespaces=True)]


def _ignore(_: str) -> None:
    pass


def entity_problem(source: Source, at: int, name: str) -> Problem:
    """An entity declaration, which is read over; ``at`` is a place in it."""
    start = max(source.data.rfind(b"<!ENTITY", 0, at + 8), 0)
    return Problem("XML003", Span(source, start, start + 8), f"entity '{name}' is declared")


def syntax_problems(source: Source, data: bytes | None = None) -> list[Problem]:
    """All syntax errors of a file that is not well formed.

    Args:
        source: the file.
        data: its text if read otherwise than it stands, at the same offsets.
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
            fix=_remedy(source, mistake),
        )
        for mistake in syntax_mistakes(data)
    ]
    return problems or [_expat_problem(source, data)]


def _remedy(source: Source, mistake: SyntaxMistake) -> Fix | None:
    """What puts a slip right; it is known for comments, which no reader of robots heeds."""
    edits = tuple(Edit(Span(source, *place), text) for *place, text in mistake.remedy)
    return Fix(mistake.help, edits, safe=True) if edits else None


def _expat_problem(source: Source, data: bytes, *, namespaces: bool = False) -> Problem:
    """What expat says, for a file that only expat refuses."""
    parser = expat.ParserCreate("utf-8", " " if namespaces else None)
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        at = parser.ErrorByteIndex
        return Problem("XML001", Span(source, at, at), expat.ErrorString(error.code))
    return Problem("XML001", Span(source, 0, 0), "not well-formed")
