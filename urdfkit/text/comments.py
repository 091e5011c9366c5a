"""XML comments in the bytes of a file, which may be malformed."""

import re

#: An unclosed comment extends to the end of the file; searching on from each ``<!--`` takes hours.
_COMMENT = re.compile(rb"<!--(.*?)(?:-->|\Z)", re.DOTALL)


def comments(data: bytes) -> list[re.Match[bytes]]:
    """All comments; the first group of each match is its text."""
    return list(_COMMENT.finditer(data))


def without_comments(data: bytes) -> bytes:
    """The bytes outside of comments."""
    return _COMMENT.sub(b"", data) if b"<!--" in data else data


def blank_comments(data: bytes) -> bytes:
    """The bytes with comments replaced by spaces, so that offsets stay valid."""
    return _COMMENT.sub(lambda comment: b" " * len(comment[0]), data) if b"<!--" in data else data
