"""Standard input."""

import sys

from urdfkit.errors import UnreadableFile
from urdfkit.text.source import MAX_BYTES, STANDARD_INPUT, Source


def opened(word: str) -> str | Source:
    """A file of the command line, or the content of standard input for '-'.

    Raises:
        UnreadableFile: standard input is closed, or too large.
    """
    return read(STANDARD_INPUT) if word == "-" else word


def read(name: str) -> Source:
    """The content of standard input, as a source with a name.

    Raises:
        UnreadableFile: standard input is closed, or too large.
    """
    if sys.stdin is None:
        raise UnreadableFile("standard input is closed; pass a file instead of '-'")
    try:
        data = sys.stdin.buffer.read(MAX_BYTES + 1)
    except OSError as error:
        raise UnreadableFile(f"standard input: {error.strerror or error}") from error
    if len(data) > MAX_BYTES:
        raise UnreadableFile(f"standard input: larger than {MAX_BYTES // 2**20} MiB")
    return Source(name, data)
