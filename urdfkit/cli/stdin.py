"""Standard input."""

import sys

from urdfkit.errors import UnreadableFile
from urdfkit.text.source import MAX_BYTES, STANDARD_INPUT, Source


def opened(word: str) -> str | Source:
    """The file that a word of the command line names; '-' is what comes in.

    Raises:
        UnreadableFile: standard input is closed, or too large.
    """
    return read(STANDARD_INPUT) if word == "-" else word


def read(name: str) -> Source:
    """Everything that comes in, as a source of this name.

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
