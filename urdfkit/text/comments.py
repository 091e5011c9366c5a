"""XML comments in the bytes of a file, which need not be well formed."""

import re

#: What has no end goes on to that of the file: to look for it anew from each beginning takes hours.
_COMMENT = re.compile(rb"<!--(.*?)(?:-->|\Z)", re.DOTALL)


def comments(data: bytes) -> list[re.Match[bytes]]:
    """The comments; the first group is the text of each."""
    return list(_COMMENT.finditer(data))


def without_comments(data: bytes) -> bytes:
    """The bytes that are not in comments."""
    return _COMMENT.sub(b"", data) if b"<!--" in data else data


def blank_comments(data: bytes) -> bytes:
    """The bytes with spaces for comments, so that offsets stay."""
    return _COMMENT.sub(lambda comment: b" " * len(comment[0]), data) if b"<!--" in data else data
