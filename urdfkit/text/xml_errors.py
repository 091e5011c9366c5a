"""All errors of a text that is not well-formed XML, each at the location to fix.

A parser stops at the first error, and often reports a later location than that of the mistake.
This scanner continues: it splits the text into tags, then matches end tags to start tags, and
resolves ambiguities by the rest of the file. It is run on files that expat has rejected; it never
rejects a file that expat accepts.
"""

import re

from urdfkit.text.not_xml import other_than_xml
from urdfkit.text.tag_matching import MAX_ERRORS, SyntaxMistake, TagMatching, TagToken
from urdfkit.text.xml_characters import (
    control_characters,
    control_mistake,
    hyphen_mistake,
    is_character,
)

#: Tags that are matched; the rest of a larger malformed file is not read.
MAX_TAGS = 300_000

_NAME = rb"[A-Za-z_:\x80-\xff][A-Za-z0-9_:.\x80-\xff-]*"
_START = re.compile(rb"<(%s)" % _NAME)
_SPACED_START = re.compile(rb"<\s+(%s)(?=\s+[\w:.-]+\s*=|\s*/?>)" % _NAME)
_END = re.compile(rb"</(%s)\s*>" % _NAME)
_ATTRIBUTE_NAME = re.compile(_NAME)
_TARGET = re.compile(rb"<\?%s(?=[\s?])" % _NAME)
_SPACE = re.compile(rb"[ \t\r\n]*")
_UNQUOTED = re.compile(rb"[^\s<>\"'/]+")
_UNOPENED = re.compile(rb"""[^<>="']*""")
_NEXT_ATTRIBUTE = re.compile(rb"\s(%s)\s*=\s*$" % _NAME)
_JUNK = re.compile(
    rb"""[\w.:-]+\s*=\s*(?:"[^"<>]*"|'[^'<>]*')|["']|[^\s/>"'<A-Za-z_:\x80-\xff]+|/"""
)
#: A comment of another language among the attributes of a tag.
_FOREIGN_COMMENT = re.compile(rb"""(?:\#|//)[ \t]*[\w\x80-\xff][^<>/"'=\r\n]*""")
_REFERENCE = re.compile(rb"&(?:#([0-9]+);|#x([0-9A-Fa-f]+);|(%s);)?" % _NAME)
_DECLARATION = re.compile(
    rb"""<\?xml\s+version\s*=\s*(?:"[\w.:-]+"|'[\w.:-]+')"""
    rb"""(?:\s+encoding\s*=\s*(?:"[\w.-]+"|'[\w.-]+'))?"""
    rb"""(?:\s+standalone\s*=\s*(?:"(?:yes|no)"|'(?:yes|no)'))?\s*\?>"""
)
#: The begin of a comment with a character too few, or a space too many.
_MISTYPED_COMMENT = re.compile(rb"<(?:--+|!\s+-+|!-)")
#: A comment on one line with a hyphen too few at both ends.
_ARROW_COMMENT = re.compile(rb"<!-(?!-)[^<>\n]*->")
_PREDEFINED = frozenset((b"lt", b"gt", b"amp", b"quot", b"apos"))


def syntax_mistakes(data: bytes) -> list[SyntaxMistake]:
    """All errors of a UTF-8 text, ordered by offset; empty if this scanner finds none."""
    if mistakes := other_than_xml(data):
        return mistakes  # the other errors follow from them
    scanner = _Scanner(data)
    scanner.run()
    first: dict[int, SyntaxMistake] = {}
    for mistake in scanner.mistakes:
        first.setdefault(mistake.start, mistake)  # others at the same offset follow from it
    comment = min((one.start for one in first.values() if one.nested), default=len(data))
    ordered = (first[start] for start in sorted(first))
    # What follows the root may be the rest of the outer comment.
    return [one for one in ordered if not one.trailing or one.start < comment][:MAX_ERRORS]


class _Scanner:
    """Splits a text into tags; ``mistakes`` collects the errors."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.mistakes: list[SyntaxMistake] = []
        self._tags: list[TagToken] = []
        self._has_doctype = False
        self._cut_off = False  # True after an unclosed construct, which extends to the end

    def run(self) -> None:
        for start, end in control_characters(self.data):
            self.mistakes.append(control_mistake(self.data, start, end))
        position = 3 if self.data.startswith(b"\xef\xbb\xbf") else 0
        position = self._declaration(position)
        size = len(self.data)
        while position < size and len(self.mistakes) < MAX_ERRORS and len(self._tags) < MAX_TAGS:
            start = self.data.find(b"<", position)
            self._text(position, start if start >= 0 else size)
            if start < 0:
                break
            position = self._markup(start)
        else:
            self._cut_off = self._cut_off or position < size
        TagMatching(self.data, self._tags, self.mistakes, cut_off=self._cut_off).run()

    def _add(self, start: int, end: int, message: str, *notes: tuple[int, int, str]) -> None:
        self.mistakes.append(SyntaxMistake(start, end, message, notes))

    def _declaration(self, position: int) -> int:
        if not re.compile(rb"<\?\s*xml(?![-_])").match(self.data, position):
            return position
        if match := _DECLARATION.match(self.data, position):
            return match.end()
        end = self.data.find(b"?>", position)
        if 0 <= end < position + 1000:
            message = 'the XML declaration must be <?xml version="1.0"?>'
            self._add(position, end + 2, message)
            return end + 2
        return position

    # ------------------------------------------------------------------- text

    def _text(self, start: int, end: int) -> None:
        """Scan character data for references and ``]]>``, which XML forbids in it."""
        self._references(start, end)
        forbidden = self.data.find(b"]]>", start, end)
        if forbidden >= 0:
            self._add(forbidden, forbidden + 3, "']]>' in a text must be written ']]&gt;'")
        if self.data[start:end].strip():
            self._tags.append(TagToken("text", "", start, end))

    def _references(self, start: int, end: int) -> None:
        position = self.data.find(b"&", start, end)
        while position >= 0 and len(self.mistakes) < MAX_ERRORS:
            match = _REFERENCE.match(self.data, position, end)
            assert match is not None
            decimal, hexadecimal, name = match.groups()
            if match.group() == b"&":
                self._add(position, position + 1, "'&' must be written '&amp;'")
            elif name is not None and name not in _PREDEFINED and not self._has_doctype:
                text = match.group().decode("utf-8", "replace")
                message = f"'{text}' is not defined; XML defines only &lt; &gt; &amp; &quot; &apos;"
                self._add(*match.span(), message)
            elif decimal or hexadecimal:
                digits = (decimal or hexadecimal)[:12]
                if not is_character(int(digits, 10 if decimal else 16)):
                    text = match.group().decode()[:20]
                    self._add(*match.span(), f"'{text}' is not a character")
            position = self.data.find(b"&", match.end(), end)

    # ----------------------------------------------------------------- markup

    def _markup(self, start: int) -> int:
        """Scan the construct that begins with the ``<`` at ``start``; returns its end."""
        data = self.data
        if data.startswith(b"<!--", start):
            return self._comment(start)
        if data.startswith(b"<![CDATA[", start):
            return self._until(start, 9, b"]]>", "CDATA section")
        if data.startswith(b"<?", start):
            return self._instruction(start)
        if data.startswith(b"<!DOCTYPE", start):
            return self._doctype(start)
        if data.startswith(b"</", start):
            return self._end_tag(start)
        if match := _START.match(data, start):
            return self._start_tag(match)
        if match := _SPACED_START.match(data, start):
            name = match.group(1).decode("utf-8", "replace")
            self._add(start, match.end(), f"no space is allowed between '<' and '{name}'")
            return self._start_tag(match)
        return self._stray(start)

    def _stray(self, start: int) -> int:
        """Report a ``<`` without a name: the mistyped begin of a comment, or a character."""
        match, end = _MISTYPED_COMMENT.match(self.data, start), self.data.find(b"-->", start + 3)
        if match and end >= 0 and self.data.find(b"<!--", start, end) < 0:
            message = f"a comment begins with '<!--', not with '{match.group().decode()}'"
            fix = ((*match.span(), "<!--"),)
            self.mistakes.append(SyntaxMistake(*match.span(), message, fix=fix))
            return end + 3
        if arrow := _ARROW_COMMENT.match(self.data, start):
            self._add(*arrow.span(), "a comment is written '<!-- ... -->'")
            return arrow.end()
        message = "'<' does not begin a tag; in a text it must be written '&lt;'"
        self._add(start, start + 1, message)
        return start + 1

    def _instruction(self, start: int) -> int:
        if re.match(rb"<\?[xX][mM][lL][\s?]", self.data[start : start + 6]):
            message = "the XML declaration must be at the very beginning of the file"
            is_second = any(tag.kind != "text" for tag in self._tags)
            help = "a file has one root element: remove it" if is_second else "remove what is above"
            self.mistakes.append(SyntaxMistake(start, start + 5, message, help=help))
        if not _TARGET.match(self.data, start):
            self._add(start, start + 2, "a name must follow '<?'")
            return start + 2
        return self._until(start, 2, b"?>", "'<?' instruction")

    def _until(self, start: int, skip: int, end: bytes, construct: str) -> int:
        at = self.data.find(end, start + skip)
        if at >= 0:
            return at + len(end)
        self._add(start, start + skip, f"the {construct} never ends: '{end.decode()}' is missing")
        return self._skip_rest()

    def _skip_rest(self) -> int:
        self._cut_off = True
        return len(self.data)

    def _comment(self, start: int) -> int:
        end = self._until(start, 4, b"-->", "comment")
        if not self._cut_off and (mistake := hyphen_mistake(self.data, start + 4, end - 3)):
            self.mistakes.append(mistake)
        return end

    def _doctype(self, start: int) -> int:
        self._has_doctype = True
        head = re.compile(rb"""(?:[^<>\["']|"[^"]*"|'[^']*')*(\[)?""").match(self.data, start + 9)
        assert head is not None
        position = head.end()
        if head.group(1):
            inner = re.compile(rb"""(?:<!--.*?-->|"[^"]*"|'[^']*'|[^\]"'])*\]\s*""", re.DOTALL)
            body = inner.match(self.data, position)
            position = body.end() if body else position
        if self.data.startswith(b">", position):
            return position + 1
        self._add(start, start + 9, "the <!DOCTYPE never ends")
        return self._skip_rest()

    def _end_tag(self, start: int) -> int:
        if match := _END.match(self.data, start):
            name = match.group(1).decode("utf-8", "replace")
            self._tags.append(TagToken("close", name, start, match.end()))
            return match.end()
        head = re.compile(rb"</\s*(%s)" % _NAME).match(self.data, start)
        if head is None:
            self._add(start, start + 2, "'</' does not begin an end tag: a name must follow")
            return start + 2
        name = head.group(1).decode("utf-8", "replace")
        rest = re.compile(rb"[^<>]*(>?)").match(self.data, head.end())
        assert rest is not None
        if rest.group(1):
            end, message = rest.end(), f"an end tag contains only its name: </{name}>"
        else:
            end, message = head.end(), f"'>' is missing after </{name}"
            if rest.end() == len(self.data):
                self._add(start, end, f"the file ends inside </{name}")
                return self._skip_rest()
        self._add(start, end, message)
        self._tags.append(TagToken("close", name, start, end))
        return end

    # -------------------------------------------------------------- start tag

    def _start_tag(self, head: re.Match[bytes]) -> int:
        data, start, position = self.data, head.start(), head.end()
        name = head.group(1).decode("utf-8", "replace")
        names: dict[bytes, tuple[int, int]] = {}
        while True:
            space = _SPACE.match(data, position)
            assert space is not None
            before, position = position, space.end()
            if data.startswith(b">", position):
                self._tags.append(TagToken("open", name, start, position + 1))
                return position + 1
            if data.startswith(b"/>", position):
                self._tags.append(TagToken("empty", name, start, position + 2))
                return position + 2
            if position >= len(data):
                if self._cut_off:  # by a value without its closing quote
                    return position
                self._add(start, head.end(), f"the file ends inside <{name}")
                return self._skip_rest()
            if data.startswith(b"<", position):
                self._unfinished_tag(before, name)
                self._tags.append(TagToken("unfinished", name, start, before))
                return position
            attribute = _ATTRIBUTE_NAME.match(data, position)
            if attribute is None:
                position = self._not_an_attribute(position, name)
                continue
            position = self._attribute(attribute, before, names)
            if len(self.mistakes) >= MAX_ERRORS:
                return position

    def _not_an_attribute(self, start: int, tag: str) -> int:
        """Report what stands between the attributes of a tag; returns its end."""
        comment = _FOREIGN_COMMENT.match(self.data, start)
        found = comment or _JUNK.match(self.data, start)
        end = found.end() if found else start + 1
        text = self.data[start:end].decode("utf-8", "replace").rstrip()
        message = f"'{text[:20]}' does not belong in <{tag}>"
        help = "a comment is written <!-- ... -->, outside of tags" if comment else ""
        self.mistakes.append(SyntaxMistake(start, end, message, help=help))
        return end

    def _unfinished_tag(self, at: int, name: str) -> None:
        """Report a start tag without ``>``, unless an attribute cut off there is reported."""
        if not self.mistakes or self.mistakes[-1].end != at:
            self._add(at, at, f"'>' is missing at the end of <{name}")

    def _attribute(
        self, match: re.Match[bytes], before: int, names: dict[bytes, tuple[int, int]]
    ) -> int:
        """Scan an attribute; returns its end."""
        data, name = self.data, match.group().decode("utf-8", "replace")
        if match.start() == before:
            self._add(before, before, f"a space is missing before '{name}'")
        if match.group() in names:
            first = (*names[match.group()], "first given here")
            self._add(*match.span(), f"attribute '{name}' is given twice", first)
        names[match.group()] = match.span()
        equals = re.compile(rb"\s*=\s*").match(data, match.end())
        if (equals or match).end() == len(data):
            return len(data)  # which the caller reports
        if equals is None:
            self._add(*match.span(), f"attribute '{name}' has no value")
            return match.end()
        start = equals.end()
        quote = data[start : start + 1]
        if quote not in (b'"', b"'"):
            return self._unquoted(name, start)
        end = data.find(quote, start + 1)
        opening = data.find(b"<", start + 1, end if end >= 0 else len(data))
        if opening >= 0:
            tag_end = len(data[start:opening].rstrip()) + start
            if end < 0 or data[tag_end - 1 : tag_end] == b">":
                return self._unclosed(name, start, opening)
            self._add(opening, opening + 1, "'<' inside a value must be written '&lt;'")
        elif end < 0:
            return self._unclosed(name, start, len(data))
        elif following := self._next_attribute(start, end):
            self._add(start, start + 1, f"the value of '{name}' has no closing quote")
            return following
        self._references(start + 1, end)
        return end + 1

    def _next_attribute(self, start: int, end: int) -> int:
        """Start of the next attribute if the quote at ``end`` is its opening quote; 0 otherwise."""
        if self.data[end + 1 : end + 2] in (b" ", b"\t", b"\r", b"\n", b"/", b">", b"?", b""):
            return 0
        match = _NEXT_ATTRIBUTE.search(self.data, max(start + 1, end - 1000), end)
        return match.start() if match else 0

    def _unquoted(self, name: str, start: int) -> int:
        data = self.data
        text = _UNOPENED.match(data, start)
        assert text is not None
        if data[text.end() : text.end() + 1] in (b'"', b"'") and text.group().strip():
            self._add(start, start, f"the value of '{name}' has no opening quote")
            return text.end() + 1
        bare = _UNQUOTED.match(data, start)
        if bare is None:
            self._add(start, start, f"attribute '{name}' has no value")
            return start
        value = bare.group().decode("utf-8", "replace")
        self._add(*bare.span(), f"the value of '{name}' needs quotes: {name}=\"{value[:40]}\"")
        return bare.end()

    def _unclosed(self, name: str, start: int, limit: int) -> int:
        """Report a value without its closing quote, which then ends with the tag."""
        self._add(start, start + 1, f"the value of '{name}' has no closing quote")
        end = self.data.find(b">", start, limit)
        if end < 0:
            return limit if limit < len(self.data) else self._skip_rest()
        return end - 1 if self.data[end - 1 : end] == b"/" else end
