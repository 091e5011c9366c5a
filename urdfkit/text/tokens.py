"""The tokens of an XML text: tags, comments and what stands between them, in their order.

The text need not be well-formed: a tag ends where the next one begins, a value at the next tag at
the latest. What the formatter reads is well-formed; what an editor holds is being written.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum

from urdfkit.core.record import Record

_NAME = re.compile(rb"[^\s<>/=\"'!?]*")
_ATTRIBUTE = re.compile(
    rb"""\s*([^\s=<>/"']+)(?:\s*=\s*(?:"(?P<double>[^"<]*)|'(?P<single>[^'<]*))?)?["']?"""
)
_TAG_END = re.compile(rb"\s*(/?)(>?)")
_END_TAG = re.compile(rb"</\s*([^\s<>/]*)[^<>]*>?")
_DOCTYPE = re.compile(rb"<!DOCTYPE(?:[^\[>\"']|\"[^\"]*\"|'[^']*'|\[.*?\](?=\s*>))*>", re.DOTALL)
_UNFINISHED = re.compile(rb"<[?!][^<>]*>?")


class TokenKind(Enum):
    """What a token is."""

    COMMENT = "comment"
    CDATA = "cdata"
    INSTRUCTION = "instruction"  # the XML declaration, too
    DOCTYPE = "doctype"
    START = "start"
    EMPTY = "empty"  # <a/>
    UNFINISHED = "unfinished"  # a start tag without its end
    END = "end"
    TEXT = "text"


class AttributeToken(Record):
    """An attribute of a tag."""

    name: tuple[int, int]  # first and last byte of it, with its prefix
    value: tuple[int, int] | None  # those of the value without quotes; None if there is none yet


class Token(Record):
    """A piece of a text."""

    kind: TokenKind  # what it is
    data: bytes  # the whole text
    #: start and end: first and last byte of the piece.
    start: int
    end: int
    name_span: tuple[int, int] = (0, 0)  # those of the name of a tag; empty right behind a ``<``
    attributes: tuple[AttributeToken, ...] = ()  # of a start tag, in their order

    @property
    def text(self) -> str:
        return _text(self.data, (self.start, self.end))

    @property
    def name(self) -> str:
        """The name of the element, with its prefix."""
        return _text(self.data, self.name_span)

    @property
    def pairs(self) -> list[tuple[str, str]]:
        """Names and values of the attributes, as written."""
        data = self.data
        return [
            (_text(data, one.name), _text(data, one.value or (0, 0))) for one in self.attributes
        ]


def tokens(data: bytes) -> Iterator[Token]:
    """The tokens of a text in UTF-8; together they are the whole text."""
    # Of many '<!DOCTYPE' or '<?' without an end, not each is read to the end of the text.
    doctype = _DOCTYPE.match(data, max(data.find(b"<!DOCTYPE"), 0))
    last_end = data.rfind(b"?>")
    at = 0
    while at < len(data):
        start = data.find(b"<", at)
        if start != at:
            token = Token(TokenKind.TEXT, data, at, start if start >= 0 else len(data))
        elif data.startswith(b"<!--", at):
            token = _until(b"-->", TokenKind.COMMENT, data, at)
        elif data.startswith(b"<![CDATA[", at):
            token = _until(b"]]>", TokenKind.CDATA, data, at)
        elif data.startswith(b"<?", at) and at < last_end:
            token = _until(b"?>", TokenKind.INSTRUCTION, data, at)
        elif doctype and at == doctype.start():
            token = Token(TokenKind.DOCTYPE, data, *doctype.span())
        elif found := _UNFINISHED.match(data, at):
            token = Token(TokenKind.INSTRUCTION, data, *found.span())
        elif found := _END_TAG.match(data, at):
            token = Token(TokenKind.END, data, *found.span(), found.span(1))
        else:
            token = _start_tag(data, at)
        yield token
        at = token.end


def _until(end: bytes, kind: TokenKind, data: bytes, start: int) -> Token:
    """A token that goes on to a mark, or to the end of the text."""
    found = data.find(end, start + 2)
    return Token(kind, data, start, found + len(end) if found >= 0 else len(data))


def _start_tag(data: bytes, start: int) -> Token:
    name = _NAME.match(data, start + 1)
    assert name is not None
    at, attributes = name.end(), []
    while found := _ATTRIBUTE.match(data, at):
        group = "double" if found["double"] is not None else "single"
        value = found.span(group) if found[group] is not None else None
        attributes.append(AttributeToken(found.span(1), value))
        at = found.end()
    end = _TAG_END.match(data, at)
    assert end is not None
    kind = TokenKind.UNFINISHED
    if end[2]:
        kind = TokenKind.EMPTY if end[1] else TokenKind.START
    return Token(kind, data, start, end.end(), name.span(), tuple(attributes))


def _text(data: bytes, span: tuple[int, int]) -> str:
    return data[slice(*span)].decode("utf-8", "replace")
