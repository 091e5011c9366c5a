"""Applying text edits to the bytes of a file."""

import codecs
from collections.abc import Iterable

from urdfkit.text.diagnostic import Edit

#: Longer marks first: the mark of UTF-32 begins with the mark of UTF-16.
_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)


def apply_edits(data: bytes, edits: Iterable[Edit]) -> bytes:
    """The text of a source after edits.

    Args:
        data: of the source that all edits refer to.
        edits: in any order; insertions at the same offset keep their order.

    Raises:
        ValueError: two edits overlap, or an edit is outside the text.
    """
    pieces: list[bytes] = []
    done = 0
    for span, text in sorted(edits, key=lambda edit: edit.span[1:]):
        if span.start < done:
            raise ValueError(f"two edits overlap at {span}")
        if not span.start <= span.end <= len(data):
            raise ValueError(f"bytes {span.start} to {span.end} are not in the text")
        pieces += (data[done : span.start], text.encode())
        done = span.end
    return b"".join([*pieces, data[done:]])


def encoded(text: bytes, encoding: str, original: bytes) -> bytes:
    """The text of a source in the encoding of its file, with its byte-order mark.

    Args:
        text: in UTF-8.
        original: the bytes of the file.

    Raises:
        UnicodeEncodeError: the encoding does not have a character.
    """
    for mark, codec in _MARKS:
        if original.startswith(mark):
            return mark + text.decode().encode(codec)
    return text if encoding in ("utf-8", "utf8") else text.decode().encode(encoding)
