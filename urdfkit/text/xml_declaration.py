"""The encoding of a file and its XML declaration, as URDF parsers interpret them."""

import re
from xml.parsers import expat

from urdfkit.text.comments import blank_comments, without_comments
from urdfkit.text.diagnostic import Edit, Fix, Problem, Severity
from urdfkit.text.source import WIDE, Source, Span

# Compiled when needed, which is rare.
_DECLARATION = rb"<\?xml[\s?][^>]*\?>|<\?xml\?>"
_VERSION = rb"""\bversion\s*=\s*["']([^"']*)["']"""
#: Bytes in which the declaration is sought.
_HEAD = 20_000
_UTF_8 = ("utf-8", "utf8", "utf-8-sig", "us-ascii", "ascii")


def encoding_problems(source: Source, *, strict: bool) -> list[Problem]:
    """Problems of an encoding that parsers do not support, or of a byte that is invalid in it.

    Args:
        strict: True for parsers that read only UTF-8, such as xacro.
    """
    if source.undecodable is not None:
        from urdfkit.text.not_xml import is_binary

        if is_binary(source.data) or b"<" not in source.data:
            return []  # it is not XML in any encoding, which is reported
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
        message = f"this byte is not {source.encoding}, the default encoding of XML"
        return Problem("XML002", at, message)
    if source.encoding.startswith(WIDE):
        at = Span(source, *declared.span(1))
        message = f"the file declares {source.encoding}, but has one byte for a character"
        is_ascii = source.undecodable == 0  # otherwise the text is not what the file holds
        fix = Fix('write encoding="UTF-8"', (Edit(at, "UTF-8"),), safe=True) if is_ascii else None
        return Problem("XML002", at, message, 'write encoding="UTF-8"', fix=fix)
    try:
        "".encode(source.encoding)
    except (LookupError, UnicodeError):  # UnicodeError by the codec 'undefined'
        at = Span(source, *declared.span(1))
        return Problem("XML002", at, f"the declared encoding '{source.encoding}' does not exist")
    return Problem("XML002", at, f"this byte is not {source.encoding}, which the file declares")


def _is_known_to_expat(encoding: str) -> bool:
    """True for encodings with one byte per character, in which urdfdom at least finds the tags."""
    if encoding.startswith("utf-"):
        return False
    try:
        expat.ParserCreate().Parse(
            f'<?xml version="1.0" encoding="{encoding}"?><a/>'.encode(), True
        )
    except (expat.ExpatError, LookupError, ValueError):
        return False
    return True


def without_declaration(source: Source, problems: list[Problem]) -> bytes:
    """The bytes to parse: the XML declaration, which urdfdom does not validate, is blanked.

    Its defects, and text before it, are added to ``problems``.
    """
    data = source.data
    declaration = re.search(_DECLARATION, data[:_HEAD])
    if declaration and declaration.start():  # not one that is itself a comment
        declaration = re.search(_DECLARATION, blank_comments(data[:_HEAD]))
    if declaration is None:
        return data
    start, end = declaration.span()
    if start:
        if without_comments(data[:start]).strip():
            return data
        problems.append(_before_declaration(Span(source, 0, start), end))
    version = re.search(_VERSION, declaration.group())
    is_known = version is not None and version.group(1) in (b"1.0", b"1.1")
    is_well_formed = _is_well_formed(declaration.group())
    if not (is_known and is_well_formed):
        at = Span(source, start, end)
        fix = Fix("replace the XML declaration", (Edit(at, '<?xml version="1.0"?>'),), safe=True)
        message = "the XML declaration is not valid in XML 1.0"
        # No parser rejects a declaration for its version alone.
        severity = Severity.WARNING if is_well_formed else None
        problems.append(Problem("XML007", at, message, fix=fix, severity=severity))
    # Source has already applied the encoding; the declaration has no other effect.
    return b" " * end + data[end:]


def _is_well_formed(declaration: bytes) -> bool:
    """True for an XML declaration that expat accepts."""
    try:
        expat.ParserCreate("utf-8").Parse(declaration + b"<a/>", True)
    except expat.ExpatError:
        return False
    return True


def _before_declaration(before: Span, end: int) -> Problem:
    """The problem of text before the XML declaration, which ends at ``end``."""
    text = before.text.strip()
    edits: tuple[Edit, ...] = (Edit(before, ""),)
    if not text:
        message = "white space before the XML declaration"
        fix = Fix("delete the white space", edits, safe=True)
        return Problem("XML007", before, message, "start the file with <?xml ...?>", fix=fix)
    edits += (Edit(Span(before.source, end, end), f"\n{text}"),)
    return Problem(
        "XML007",
        before,
        "a comment before the XML declaration, which urdfdom 4 (ROS 2 Jazzy) rejects",
        "move the comment below <?xml ...?>",
        fix=Fix("move the comment below the XML declaration", edits, safe=True),
    )
