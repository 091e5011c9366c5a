"""Tokens of an XML text, in order: tags, comments, texts between them and others.

The text need not be well-formed, as in an editor: a tag ends before the next tag at the latest, and
so does a value.
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
    COMMENT = "comment"
    CDATA = "cdata"
    INSTRUCTION = "instruction"  # including the XML declaration
    DOCTYPE = "doctype"
    START = "start"
    EMPTY = "empty"  # <a/>
    UNFINISHED = "unfinished"  # a start tag without ``>``
    END = "end"
    TEXT = "text"


class AttributeToken(Record):
    """An attribute of a tag."""

    name: tuple[int, int]  # start and end offset, with its prefix
    value: tuple[int, int] | None  # start and end offset without quotes; None if it is missing


class Token(Record):
    """A tag, comment, text, instruction or declaration."""

    kind: TokenKind
    data: bytes  # the whole text
    #: start and end: offsets in ``data``.
    start: int
    end: int
    name_span: tuple[int, int] = (0, 0)  # offsets of the name of a tag; empty for a lone ``<``
    attributes: tuple[AttributeToken, ...] = ()  # of a start tag, in order

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
            (_text(data, token.name), _text(data, token.value or (0, 0)))
            for token in self.attributes
        ]


def tokens(data: bytes) -> Iterator[Token]:
    """The tokens of a text in UTF-8; they cover the whole text."""
    # Computed once: many unclosed '<!DOCTYPE' or '<?' would each be read to the end of the text.
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
        elif match := _UNFINISHED.match(data, at):
            token = Token(TokenKind.INSTRUCTION, data, *match.span())
        elif match := _END_TAG.match(data, at):
            token = Token(TokenKind.END, data, *match.span(), match.span(1))
        else:
            token = _start_tag(data, at)
        yield token
        at = token.end


def _until(end: bytes, kind: TokenKind, data: bytes, start: int) -> Token:
    """A token up to a delimiter, or to the end of the text."""
    at = data.find(end, start + 2)
    return Token(kind, data, start, at + len(end) if at >= 0 else len(data))


def _start_tag(data: bytes, start: int) -> Token:
    name = _NAME.match(data, start + 1)
    assert name is not None
    at, attributes = name.end(), []
    while match := _ATTRIBUTE.match(data, at):
        group = "double" if match["double"] is not None else "single"
        value = match.span(group) if match[group] is not None else None
        attributes.append(AttributeToken(match.span(1), value))
        at = match.end()
    end = _TAG_END.match(data, at)
    assert end is not None
    kind = TokenKind.UNFINISHED
    if end[2]:
        kind = TokenKind.EMPTY if end[1] else TokenKind.START
    return Token(kind, data, start, end.end(), name.span(), tuple(attributes))


def _text(data: bytes, span: tuple[int, int]) -> str:
    return data[slice(*span)].decode("utf-8", "replace")
