"""Positions of the protocol: lines from 0, and characters in units of an encoding."""

import os
from urllib.parse import quote, unquote, urlsplit

from lsprotocol.types import Location, Position, PositionEncodingKind, Range

from urdfkit.text.source import Source, Span

_BYTES = {PositionEncodingKind.Utf8: ("utf-8", 1), PositionEncodingKind.Utf16: ("utf-16-le", 2)}


class PositionEncoding:
    """Converts between positions of the client and byte offsets in a text.

    Args:
        encoding: in whose units the client counts characters.
    """

    def __init__(self, encoding: str = PositionEncodingKind.Utf16) -> None:
        self._codec, self._size = _BYTES.get(PositionEncodingKind(encoding), ("utf-32-le", 4))

    def position(self, source: Source, offset: int) -> Position:
        line, column = source.position(offset)
        before = source.line(line)[: column - 1]
        return Position(line - 1, len(before.encode(self._codec, "replace")) // self._size)

    def offset(self, source: Source, position: Position) -> int:
        """The byte offset of a position, or the nearest one."""
        if position.line >= source.position(len(source.data))[0]:
            return len(source.data)
        text = source.line(position.line + 1).encode(self._codec, "replace")
        before = text[: position.character * self._size].decode(self._codec, "ignore")
        return source.offset(position.line + 1, len(before) + 1)

    def range(self, span: Span) -> Range:
        return Range(self.position(span.source, span.start), self.position(span.source, span.end))

    def location(self, span: Span, uris: dict[str, str] | None = None) -> Location:
        """The location of a span, with the client's URI of the file."""
        path = os.path.realpath(span.source.path)
        return Location((uris or {}).get(path) or to_uri(path), self.range(span))


def to_bytes(path: str, text: str) -> bytes:
    """The bytes of a text in the encoding that it declares."""
    data = text.encode("utf-8", "replace")
    encoding = Source(path, data).encoding
    try:
        return data if encoding.startswith("utf-8") else text.encode(encoding, "replace")
    except (LookupError, UnicodeError):  # unknown encoding
        return data


def to_uri(path: str) -> str:
    path = os.path.abspath(path).replace(os.sep, "/")
    return "file://" + ("" if path.startswith("/") else "/") + quote(os.fsencode(path))


def to_path(uri: str) -> str:
    """The path of a URI; the URI itself if it is not a file, such as an untitled text."""
    parts = urlsplit(uri)
    if parts.scheme != "file":
        return uri
    path = unquote(parts.path, errors="surrogateescape")
    if os.name == "nt":
        share = f"//{parts.netloc}{path}" if parts.netloc else path.lstrip("/")
        path = share.replace("/", os.sep)
    return path
