"""Matching of end tags to start tags in a text where some are missing, wrong or superfluous."""

from __future__ import annotations

import re

from urdfkit.core.record import Record
from urdfkit.core.words import few

MAX_ERRORS = 100
#: Tags that are compared to distinguish a missing end tag from a superfluous one.
LOOK_AHEAD = 10_000
#: Tags before an end tag that are searched for its start tag: the body of a macro is long.
LOOK_BACK = 2000
#: Bytes before an end tag that are searched for a comment with its start tag.
MAX_COMMENT = 5000
#: Children of ``<robot>``, which are no roots themselves.
_PARTS = ("gazebo", "joint", "link", "material", "ros2_control", "transmission")


class SyntaxMistake(Record):
    """One syntax error."""

    #: start and end: offsets of the wrong bytes; equal if something is missing.
    start: int
    end: int
    message: str
    #: Other locations that explain it, as (start, end, message).
    notes: tuple[tuple[int, int, str], ...] = ()
    trailing: bool = False  # True for content after the end of the root element
    nested: bool = False  # True for a comment inside a comment, which may continue behind it
    help: str = ""  # how to fix it; empty if the message says it
    #: Edits that fix it, as (start, end, text); empty if unknown.
    fix: tuple[tuple[int, int, str], ...] = ()


class TagToken(Record):
    """A tag or a text; ``kind`` is ``open``, ``empty``, ``close``, ``text``, or ``unfinished``.

    ``unfinished`` is a start tag without ``>``: it may be intended as an empty element.
    """

    kind: str
    name: str
    start: int
    end: int

    def note(self, message: str) -> tuple[int, int, str]:
        return (self.start, self.end, message)


class TagMatching:
    def __init__(
        self, data: bytes, tags: list[TagToken], mistakes: list[SyntaxMistake], *, cut_off: bool
    ) -> None:
        self._data = data
        self._tags = tags
        self._mistakes = mistakes
        self._cut_off = cut_off
        self._open: list[TagToken] = []
        self._counts: dict[str, int] = {}
        self._unclosed: dict[str, int] = {}  # reported as such; their end tag may still follow
        self._root: TagToken | None = None

    def run(self) -> None:
        for number, tag in enumerate(self._tags):
            if len(self._mistakes) >= MAX_ERRORS:
                return
            if not self._open and tag.kind != "close" and not self._outside_root(tag):
                return
            if tag.kind in ("open", "unfinished"):
                self._push(tag)
            elif tag.kind == "close":
                self._close(number, tag)
        self._end()

    def _add(self, at: tuple[int, int], message: str, *notes: tuple[int, int, str]) -> None:
        self._mistakes.append(SyntaxMistake(*at, message, notes))

    def _outside_root(self, tag: TagToken) -> bool:
        """Handle content outside of the root element; False if matching must stop there."""
        if self._root is None:
            if tag.kind == "text":
                start, end = _stripped(self._data, tag)
                self._add((start, end), "text before the first tag")
            else:
                self._root = tag
            return True
        name = self._root.name
        start, end = _stripped(self._data, tag) if tag.kind == "text" else (tag.start, tag.end)
        content = "text" if tag.kind == "text" else f"<{tag.name}>"
        note = self._root.note(f"<{name}> begins here")
        message = f"{content} after the end of <{name}>"
        # A file of parts of a robot alone lacks the element around them.
        is_part = name.startswith("xacro:") or name in _PARTS
        help = "put all elements into one <robot>" if is_part else ""
        mistake = SyntaxMistake(start, end, message, (note,), help=help, trailing=True)
        self._mistakes.append(mistake)
        return False

    def _push(self, tag: TagToken) -> None:
        self._open.append(tag)
        self._counts[tag.name] = self._counts.get(tag.name, 0) + 1

    def _pop(self) -> TagToken:
        tag = self._open.pop()
        self._counts[tag.name] -= 1
        return tag

    def _close(self, number: int, tag: TagToken) -> None:
        is_open = self._counts.get(tag.name, 0) > 0
        while (
            self._open and self._open[-1].kind == "unfinished" and self._open[-1].name != tag.name
        ):
            self._pop()
        if self._open and self._open[-1].name == tag.name:
            self._pop()
        elif not self._open:
            self._stray(number, tag)
        elif is_open:
            self._close_outer(number, tag)
        elif self._next_unmatched(number) == self._open[-1].name:
            self._stray(number, tag)
        else:
            self._mismatched(tag)

    def _close_outer(self, number: int, tag: TagToken) -> None:
        """Handle the end tag of an element that contains the innermost open element."""
        depth = len(self._open) - 1
        while self._open[depth].name != tag.name:
            depth -= 1
        outer = self._open[depth - 1].name if depth else None
        parent = self._open[-2].name
        following = self._next_unmatched(number)
        if following == parent and following != outer:
            self._mismatched(tag)
            return
        while self._open[-1].name != tag.name:
            inner = self._pop()
            if inner.kind == "open":
                self._unclosed[inner.name] = self._unclosed.get(inner.name, 0) + 1
                message = f"{self._shown(inner)} is not closed before </{tag.name}>"
                note = tag.note(f"</{tag.name}> closes an enclosing element")
                self._add((inner.start, inner.end), message, note)
        self._pop()

    def _mismatched(self, tag: TagToken) -> None:
        expected = self._pop()
        note = expected.note(f"{self._shown(expected)} is opened here")
        message = f"expected </{expected.name}>, found </{tag.name}>"
        self._add((tag.start, tag.end), message, note)

    def _stray(self, number: int, tag: TagToken) -> None:
        """Handle an end tag without a start tag."""
        if self._unclosed.get(tag.name, 0):
            self._unclosed[tag.name] -= 1
            return
        if not self._open and self._root is not None and self._unclosed:
            return
        tags = reversed(self._tags[max(0, number - LOOK_BACK) : number])
        earlier = next((other for other in tags if other.name == tag.name), None)
        notes = self._in_comment(tag, earlier.end if earlier else 0)
        if not notes and earlier and earlier.kind == "empty":
            text = f"<{tag.name} .../> closes itself: its '/' is one too many"
            notes.append(earlier.note(text))
        message = f"</{tag.name}> closes nothing: no <{tag.name}> is open"
        self._add((tag.start, tag.end), message, *notes)

    def _in_comment(self, tag: TagToken, begin: int) -> list[tuple[int, int, str]]:
        """A note about the start tag of an end tag, if the last comment before it contains it."""
        data = self._data
        start = data.rfind(b"<!--", max(begin, tag.start - MAX_COMMENT), tag.start)
        end = data.find(b"-->", start, tag.start) if start >= 0 else -1
        comment = data[start:end] if end >= 0 else b""
        opened = re.search(rb"<%s\b[^<>]*(?<!/)>" % re.escape(tag.name.encode()), comment)
        if opened is None:
            return []
        place = start + opened.start(), start + opened.end()
        return [(*place, f"this <{tag.name}> is in a comment")]

    def _next_unmatched(self, number: int) -> str | None:
        """Name of the next end tag whose start tag is not after the tag ``number``."""
        opened: list[TagToken] = []
        for tag in self._tags[number + 1 : number + 1 + LOOK_AHEAD]:
            if tag.kind in ("open", "unfinished"):
                opened.append(tag)
            elif tag.kind == "close":
                while opened and opened[-1].kind == "unfinished" and opened[-1].name != tag.name:
                    opened.pop()
                if not any(start.name == tag.name for start in opened[-50:]):
                    return tag.name
                while opened.pop().name != tag.name:
                    pass
        return None

    def _end(self) -> None:
        if self._cut_off:
            return
        unclosed = [tag for tag in reversed(self._open) if tag.kind == "open"]
        if unclosed:
            names = few([f"</{tag.name}>" for tag in unclosed], 5)
            notes = [tag.note(f"{self._shown(tag)} is not closed") for tag in unclosed[:5]]
            end = len(self._data.rstrip())
            self._add((end, end), f"the file ends before {names}", *notes)
        elif self._root is None and not self._mistakes:
            self._add((0, 0), "the file has no element")

    def _shown(self, tag: TagToken) -> str:
        """A start tag with its name attribute."""
        text = self._data[tag.start : tag.end][:500]
        match = re.search(rb"""\bname\s*=\s*["']([^"'<>\n]{1,60})["']""", text)
        name = f' name="{match.group(1).decode("utf-8", "replace")}"' if match else ""
        return f"<{tag.name}{name}>"


def _stripped(data: bytes, tag: TagToken) -> tuple[int, int]:
    text = data[tag.start : tag.end]
    start = tag.start + len(text) - len(text.lstrip())
    return start, start + len(text.strip())
