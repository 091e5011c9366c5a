"""Characters that are not allowed in XML, and hyphens that are not allowed in its comments."""

import re

from urdfkit.text.tag_matching import SyntaxMistake

_CONTROLS = re.compile(rb"\x00+|[\x01-\x08\x0b\x0c\x0e-\x1f]|\xef\xbf[\xbe\xbf]")
#: Hyphens that XML forbids between ``<!--`` and ``-->``: two, or one before the end.
_HYPHENS = re.compile(rb"--+|-\Z")


def control_characters(data: bytes) -> list[tuple[int, int]]:
    return [match.span() for match in _CONTROLS.finditer(data)]


def control_mistake(data: bytes, start: int, end: int) -> SyntaxMistake:
    """The mistake of a control character, or of consecutive NUL bytes."""
    code, count = ord(data[start:end].decode()[0]), end - start
    if code:
        message = f"the control character U+{code:04X} is not allowed in XML"
    elif count == 1:
        message = "a NUL byte is not allowed in XML"
    else:
        message = f"{count} NUL bytes are not allowed in XML"
    return SyntaxMistake(
        start, end, message, help="remove " + ("it" if count == 1 or code else "them")
    )


def hyphen_mistake(data: bytes, start: int, end: int) -> SyntaxMistake | None:
    """The mistake of forbidden hyphens in a comment with its text from ``start`` to ``end``."""
    inner = data.find(b"<!--", start, end)
    if inner >= 0:  # the comment contains elements, or an unclosed comment continues to here
        return SyntaxMistake(
            inner,
            inner + 4,
            "'<!--' inside a comment: comments do not nest",
            notes=((start - 4, start, "this comment is not closed before it"),),
            help="write '-->' at the end of the first comment, or remove the inner one",
            nested=True,
        )
    fix: list[tuple[int, int, str]] = []
    for match in _HYPHENS.finditer(data[start:end]):
        at, count = start + match.start(), len(match[0])
        is_inside = count == 2 and match.end() < end - start  # such as an option of a command
        text = "- -" if is_inside else "=" * count
        fix.append((at, at + count, text if count > 1 else ""))
    if not fix:
        return None
    first, last, _ = fix[0]
    if last - first == 1:
        message, help = "'--->' does not end a comment", "write '-->'"
    else:
        message, help = "'--' is not allowed inside a comment", "write '- -' or '=='"
    return SyntaxMistake(first, last, message, help=help, fix=tuple(fix))


def is_character(code: int) -> bool:
    return (
        code in (0x9, 0xA, 0xD)
        or 0x20 <= code <= 0xD7FF
        or 0xE000 <= code <= 0xFFFD
        or 0x10000 <= code <= 0x10FFFF
    )
