"""Characters that XML forbids, and hyphens that it forbids in comments."""

import re

from urdfkit.text.tag_matching import SyntaxMistake

_CONTROLS = re.compile(rb"\x00+|[\x01-\x08\x0b\x0c\x0e-\x1f]|\xef\xbf[\xbe\xbf]")
#: What XML forbids between ``<!--`` and ``-->``: two hyphens, or one before the end.
_HYPHENS = re.compile(rb"--+|-\Z")


def control_characters(data: bytes) -> list[tuple[int, int]]:
    return [found.span() for found in _CONTROLS.finditer(data)]


def control_mistake(data: bytes, start: int, end: int) -> SyntaxMistake:
    """A control character, or NUL bytes in a row."""
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
    """The hyphens that XML forbids in a comment, whose text is between two offsets."""
    inner = data.find(b"<!--", start, end)
    if inner >= 0:  # it holds elements, or an earlier comment has swallowed them
        return SyntaxMistake(
            inner,
            inner + 4,
            "'<!--' inside a comment: comments do not nest",
            notes=((start - 4, start, "this comment is not closed before it"),),
            help="write '-->' at the end of the first comment, or remove the inner one",
        )
    fix: list[tuple[int, int, str]] = []
    for found in _HYPHENS.finditer(data[start:end]):
        at, count = start + found.start(), len(found[0])
        is_word = count == 2 and found.end() < end - start  # such as an option of a command
        text = "- -" if is_word else "=" * count
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
