"""Every place where a text is not well-formed XML, in words, with the place to fix.

A parser stops at the first error, and often names the place where it noticed a mistake made above.
This scanner reads on: it takes the text apart into tags, then fits end tags to start tags, and
chooses where something is missing what the rest of the file agrees with best. It is run on files
that expat has rejected; it never rejects a file that expat accepts.
"""

import re

from urdfkit.text.tag_matching import MAX_ERRORS, SyntaxMistake, TagMatching, TagToken
from urdfkit.text.xml_characters import (
    control_characters,
    control_mistake,
    hyphen_mistake,
    is_character,
)

#: Tags that are fitted to each other; what follows in a larger broken file is not looked at.
MAX_TAGS = 300_000
#: Control characters that a text may hold by mistake.
MAX_CONTROLS = 20

_NAME = rb"[A-Za-z_:\x80-\xff][A-Za-z0-9_:.\x80-\xff-]*"
_START = re.compile(rb"<(%s)" % _NAME)
_SPACED_START = re.compile(rb"<\s+(%s)(?=\s+[\w:.-]+\s*=|\s*/?>)" % _NAME)
_END = re.compile(rb"</(%s)\s*>" % _NAME)
_ATTRIBUTE_NAME = re.compile(_NAME)
_TARGET = re.compile(rb"<\?%s(?=[\s?])" % _NAME)
_BLANK = re.compile(rb"[ \t\r\n]*")
_UNQUOTED = re.compile(rb"[^\s<>\"'/]+")
_UNOPENED = re.compile(rb"""[^<>="']*""")
_SWALLOWED = re.compile(rb"\s(%s)\s*=\s*$" % _NAME)
_JUNK = re.compile(
    rb"""[\w.:-]+\s*=\s*(?:"[^"<>]*"|'[^'<>]*')|["']|[^\s/>"'<A-Za-z_:\x80-\xff]+|/"""
)
_REFERENCE = re.compile(rb"&(?:#([0-9]+);|#x([0-9A-Fa-f]+);|(%s);)?" % _NAME)
_DECLARATION = re.compile(
    rb"""<\?xml\s+version\s*=\s*(?:"[\w.:-]+"|'[\w.:-]+')"""
    rb"""(?:\s+encoding\s*=\s*(?:"[\w.-]+"|'[\w.-]+'))?"""
    rb"""(?:\s+standalone\s*=\s*(?:"(?:yes|no)"|'(?:yes|no)'))?\s*\?>"""
)
_PREDEFINED = frozenset((b"lt", b"gt", b"amp", b"quot", b"apos"))


_NAME_ANOTHER = "name the URDF or xacro of the robot"


def syntax_mistakes(data: bytes) -> list[SyntaxMistake]:
    """All errors of a text in the order of their places; none if it is not known what is wrong.

    Args:
        data: UTF-8.
    """
    if other := _other_kind(data):
        message, help = other
        return [SyntaxMistake(0, 0, message, help=help)]
    controls = control_characters(data)
    count = sum(end - start for start, end in controls)
    if is_binary(data):
        message = f"not a text file: it holds {count} control characters"
        return [SyntaxMistake(*controls[0], message, help=_NAME_ANOTHER)]
    scanner = _Scanner(data)
    scanner.run()
    first: dict[int, SyntaxMistake] = {}
    for mistake in scanner.mistakes:
        first.setdefault(mistake.start, mistake)  # what else is wrong there follows from it
    return [first[start] for start in sorted(first)][:MAX_ERRORS]


def is_binary(data: bytes) -> bool:
    """True for what is no text in any encoding."""
    return sum(end - start for start, end in control_characters(data)) > MAX_CONTROLS


def _other_kind(data: bytes) -> tuple[str, str] | None:
    """What the file is if it is something else altogether, and what to do."""
    start = data[:1000].lstrip().lower()
    if not data.strip():
        return "the file is empty", "write a <robot> into it, or name another file"
    if start.startswith((b"<!doctype html", b"<html")):
        return "the file is a web page, not a robot", "download the raw file"
    if start.startswith(b"version https://git-lfs"):
        return "the file is a pointer of Git LFS, not the robot itself", "run: git lfs pull"
    if b"<" not in data:
        return "not an XML file: there is no tag in it", _NAME_ANOTHER
    return None


class _Scanner:
    """Takes a text apart; ``mistakes`` collects what is wrong."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.mistakes: list[SyntaxMistake] = []
        self._tags: list[TagToken] = []
        self._has_doctype = False
        self._cut_off = False  # the rest of the file belongs to something that never ends

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
        if not re.compile(rb"<\?xml(?![-_])").match(self.data, position):
            return position
        if good := _DECLARATION.match(self.data, position):
            return good.end()
        end = self.data.find(b"?>", position)
        if 0 <= end < position + 1000:
            message = 'the XML declaration must read <?xml version="1.0"?>'
            self._add(position, end + 2, message)
            return end + 2
        return position

    # ------------------------------------------------------------------- text

    def _text(self, start: int, end: int) -> None:
        """Character data: references, and the one sequence that XML forbids in it."""
        self._references(start, end)
        forbidden = self.data.find(b"]]>", start, end)
        if forbidden >= 0:
            self._add(forbidden, forbidden + 3, "']]>' in a text must be written ']]&gt;'")
        if self.data[start:end].strip():
            self._tags.append(TagToken("text", "", start, end))

    def _references(self, start: int, end: int) -> None:
        position = self.data.find(b"&", start, end)
        while position >= 0 and len(self.mistakes) < MAX_ERRORS:
            found = _REFERENCE.match(self.data, position, end)
            assert found is not None
            decimal, hexadecimal, name = found.groups()
            if found.group() == b"&":
                self._add(position, position + 1, "'&' must be written '&amp;'")
            elif name is not None and name not in _PREDEFINED and not self._has_doctype:
                text = found.group().decode("utf-8", "replace")
                self._add(*found.span(), f"'{text}' is not defined; XML knows &lt; &gt; &amp; only")
            elif decimal or hexadecimal:
                digits = (decimal or hexadecimal)[:12]
                if not is_character(int(digits, 10 if decimal else 16)):
                    self._add(*found.span(), f"'{found.group().decode()[:20]}' is no character")
            position = self.data.find(b"&", found.end(), end)

    # ----------------------------------------------------------------- markup

    def _markup(self, start: int) -> int:
        """Read what begins with the ``<`` at ``start``; the offset behind it."""
        data = self.data
        if data.startswith(b"<!--", start):
            return self._comment(start)
        if data.startswith(b"<![CDATA[", start):
            return self._until(start, 9, b"]]>", "CDATA section")
        if data.startswith(b"<?", start):
            if re.match(rb"<\?[xX][mM][lL][\s?]", data[start : start + 6]):
                message = "the XML declaration must stand at the very beginning of the file"
                self._add(start, start + 5, message)
            if not _TARGET.match(data, start):
                self._add(start, start + 2, "a name must follow '<?'")
                return start + 2
            return self._until(start, 2, b"?>", "'<?' instruction")
        if data.startswith(b"<!DOCTYPE", start):
            return self._doctype(start)
        if data.startswith(b"</", start):
            return self._end_tag(start)
        if found := _START.match(data, start):
            return self._start_tag(found)
        if found := _SPACED_START.match(data, start):
            name = found.group(1).decode("utf-8", "replace")
            self._add(start, found.end(), f"no space may stand between '<' and '{name}'")
            return self._start_tag(found)
        self._add(start, start + 1, "'<' begins no tag; in a text it must be written '&lt;'")
        return start + 1

    def _until(self, start: int, skip: int, end: bytes, what: str) -> int:
        found = self.data.find(end, start + skip)
        if found >= 0:
            return found + len(end)
        self._add(start, start + skip, f"the {what} never ends: '{end.decode()}' is missing")
        return self._give_up()

    def _give_up(self) -> int:
        self._cut_off = True
        return len(self.data)

    def _comment(self, start: int) -> int:
        end = self._until(start, 4, b"-->", "comment")
        if not self._cut_off and (mistake := hyphen_mistake(self.data, start + 4, end - 3)):
            self.mistakes.append(mistake)
        return end

    def _doctype(self, start: int) -> int:
        self._has_doctype = True
        found = re.compile(rb"""(?:[^<>\["']|"[^"]*"|'[^']*')*(\[)?""").match(self.data, start + 9)
        assert found is not None
        position = found.end()
        if found.group(1):
            inner = re.compile(rb"""(?:<!--.*?-->|"[^"]*"|'[^']*'|[^\]"'])*\]\s*""", re.DOTALL)
            body = inner.match(self.data, position)
            position = body.end() if body else position
        if self.data.startswith(b">", position):
            return position + 1
        self._add(start, start + 9, "the <!DOCTYPE never ends")
        return self._give_up()

    def _end_tag(self, start: int) -> int:
        if found := _END.match(self.data, start):
            name = found.group(1).decode("utf-8", "replace")
            self._tags.append(TagToken("close", name, start, found.end()))
            return found.end()
        name_found = re.compile(rb"</\s*(%s)" % _NAME).match(self.data, start)
        if name_found is None:
            self._add(start, start + 2, "'</' begins no end tag: a name must follow")
            return start + 2
        name = name_found.group(1).decode("utf-8", "replace")
        rest = re.compile(rb"[^<>]*(>?)").match(self.data, name_found.end())
        assert rest is not None
        closed = bool(rest.group(1))
        end = rest.end() if closed else name_found.end()
        what = f"an end tag holds nothing but its name: </{name}>" if closed else None
        if not closed and rest.end() == len(self.data):
            self._add(start, end, f"the file ends inside </{name}")
            return self._give_up()
        self._add(start, end, what or f"'>' is missing behind </{name}")
        self._tags.append(TagToken("close", name, start, end))
        return end

    # -------------------------------------------------------------- start tag

    def _start_tag(self, found: re.Match[bytes]) -> int:
        data, start, position = self.data, found.start(), found.end()
        name = found.group(1).decode("utf-8", "replace")
        seen: dict[bytes, tuple[int, int]] = {}
        while True:
            blank = _BLANK.match(data, position)
            assert blank is not None
            before, position = position, blank.end()
            if data.startswith(b">", position):
                self._tags.append(TagToken("open", name, start, position + 1))
                return position + 1
            if data.startswith(b"/>", position):
                self._tags.append(TagToken("empty", name, start, position + 2))
                return position + 2
            if position >= len(data):
                if self._cut_off:  # by a value without its closing quote
                    return position
                self._add(start, found.end(), f"the file ends inside <{name}")
                return self._give_up()
            if data.startswith(b"<", position):
                self._cut(before, name)
                self._tags.append(TagToken("unsure", name, start, before))
                return position
            attribute = _ATTRIBUTE_NAME.match(data, position)
            if attribute is None:
                junk = _JUNK.match(data, position)
                end = junk.end() if junk else position + 1
                text = data[position:end].decode("utf-8", "replace")
                self._add(position, end, f"'{text[:20]}' does not belong into <{name}>")
                position = end
                continue
            position = self._attribute(attribute, before, seen)
            if position < 0:
                # The tag's own end was taken into a value that is never closed.
                end = -position
                kind = "empty" if data[end - 2 : end] == b"/>" else "open"
                self._tags.append(TagToken(kind, name, start, end))
                return end
            if len(self.mistakes) >= MAX_ERRORS:
                return position

    def _cut(self, at: int, name: str) -> None:
        """A start tag without its end; an attribute that is cut off there has been reported."""
        if not self.mistakes or self.mistakes[-1].end != at:
            self._add(at, at, f"'>' is missing at the end of <{name}")

    def _attribute(
        self, found: re.Match[bytes], before: int, seen: dict[bytes, tuple[int, int]]
    ) -> int:
        """Read an attribute; the offset behind it, negative if it also ends the tag."""
        data, name = self.data, found.group().decode("utf-8", "replace")
        if found.start() == before:
            self._add(before, before, f"a space is missing before '{name}'")
        if found.group() in seen:
            first = (*seen[found.group()], "first given here")
            self._add(*found.span(), f"attribute '{name}' is given twice", first)
        seen[found.group()] = found.span()
        equals = re.compile(rb"\s*=\s*").match(data, found.end())
        if (equals or found).end() == len(data):
            return len(data)  # which the caller reports
        if equals is None:
            self._add(*found.span(), f"attribute '{name}' has no value")
            return found.end()
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
        elif contained := self._contained(start, end):
            self._add(start, start + 1, f"the value of '{name}' has no closing quote")
            return contained
        self._references(start + 1, end)
        return end + 1

    def _contained(self, start: int, end: int) -> int:
        """Where the next attribute begins if the closing quote found is its opening one."""
        if self.data[end + 1 : end + 2] in (b" ", b"\t", b"\r", b"\n", b"/", b">", b"?", b""):
            return 0
        found = _SWALLOWED.search(self.data, max(start + 1, end - 1000), end)
        return found.start() if found else 0

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
        self._add(start, start + 1, f"the value of '{name}' has no closing quote")
        end = self.data.find(b">", start, limit)
        if end < 0:
            return limit if limit < len(self.data) else self._give_up()
        return -(end + 1)
