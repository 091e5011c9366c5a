"""A well-formed document as a list of tokens: everything that stands in it, in its order."""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum

from urdfkit.core.record import Record

_TOKEN = re.compile(
    r"(?P<comment><!--.*?-->)"
    r"|(?P<cdata><!\[CDATA\[.*?\]\]>)"
    r"|(?P<instruction><\?.*?\?>)"
    r"|(?P<doctype><!DOCTYPE(?:[^\[>\"']|\"[^\"]*\"|'[^']*'|\[.*?\](?=\s*>))*>)"
    r"|(?P<end></[^>]*>)"
    r"|(?P<start><[^\s/>]+(?:[^<>\"']|\"[^\"]*\"|'[^']*')*>)"
    r"|(?P<text>[^<]+)",
    re.DOTALL,
)
_NAME = re.compile(r"<([^\s/>]+)")
_ATTRIBUTE = re.compile(r"""\s+([^\s=]+)\s*=\s*("[^"]*"|'[^']*')""")


class TokenKind(Enum):
    """What a token is."""

    COMMENT = "comment"
    CDATA = "cdata"
    INSTRUCTION = "instruction"  # the XML declaration, too
    DOCTYPE = "doctype"
    START = "start"
    END = "end"
    TEXT = "text"


class Token(Record):
    """A piece of a document, from one offset to the next."""

    kind: TokenKind
    text: str
    at: int

    @property
    def name(self) -> str:
        """Of the element whose start tag it is."""
        match = _NAME.match(self.text)
        return match.group(1) if match else ""

    @property
    def is_empty(self) -> bool:
        """True for ``<a/>``."""
        return self.kind is TokenKind.START and self.text.endswith("/>")

    @property
    def attributes(self) -> list[tuple[str, str]]:
        """Names and values of a start tag; the values with their quotes, as written."""
        return _ATTRIBUTE.findall(self.text, len(self.name) + 1)


def tokens(text: str) -> Iterator[Token]:
    """The tokens of a document that an XML parser accepts.

    Raises:
        ValueError: a piece is no token: the document is not well-formed.
    """
    at = 0
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise ValueError(f"no XML at {at}")
        assert match.lastgroup is not None
        yield Token(TokenKind(match.lastgroup), match.group(), at)
        at = match.end()
