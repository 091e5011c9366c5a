"""Formatter of URDF and xacro, which keeps the meaning of a document.

Every element begins a line, indented by its depth; attributes have a fixed order and double quotes;
numbers of a vector are separated by one space, as written. Comments and single blank lines stay in
their places. Elements with text do not change, except elements of URDF that may contain only
elements: a text in them is stray, and gets a line of its own.
"""

from __future__ import annotations

from itertools import chain
from xml.parsers import expat

from urdfkit.core.record import Record
from urdfkit.errors import UnreadableRobot
from urdfkit.text.editing.edits import STEP
from urdfkit.text.editing.start_tags import MACRO, container_tags, parameters, start_tag, vectors
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import Source
from urdfkit.text.tokens import Token, TokenKind, tokens
from urdfkit.text.xml_reader import DocumentTooLarge, require_shallow_dtd, syntax_problems

#: Columns of a line; only unbreakable text is longer.
WIDTH = 100
#: Most levels of elements; indentation grows with their square, and robots have 20.
MAX_DEPTH = 1000
#: Columns of a tab before a line of a comment.
_TAB = 4

_TAGS = (TokenKind.START, TokenKind.EMPTY)
#: Elements whose content other programs read.
_FOREIGN = frozenset(("gazebo", "transmission", "ros2_control"))


def formatted(source: Source, width: int = WIDTH) -> bytes:
    r"""The formatted text of a source, in UTF-8, with its line ends.

    >>> text = b"<robot  name='r' >\n<link name='a'></link><!-- one --></robot>"
    >>> print(formatted(Source("r.urdf", text)).decode(), end="")
    <robot name="r">
      <link name="a"/> <!-- one -->
    </robot>

    Args:
        width: columns of a line.

    Raises:
        UnreadableRobot: it is not well-formed, or not a robot.
    """
    _require_robot(source)
    data = source.data.replace(b"\r\n", b"\n")
    document = list(tokens(data))
    outline = _outline(document, source.path)
    text = "\n".join(_LineWriter(document, data, outline, width).lines()) + "\n"
    if _meaning(text.encode()) != _meaning(data):
        raise AssertionError(f"{source.path}: formatting would change the meaning")
    newline = "\r\n" if b"\r\n" in source.data else "\n"
    return text.replace("\n", newline).encode()


def _require_robot(source: Source) -> None:
    """Check that a file can be formatted.

    Raises:
        UnreadableRobot: it is not well-formed, or not a robot.
    """
    if source.undecodable is not None:
        raise UnreadableRobot(f"{source.path}: the file is not valid text")
    try:
        require_shallow_dtd(source.data)
        expat.ParserCreate("utf-8").Parse(source.data, True)
    except DocumentTooLarge as error:
        raise UnreadableRobot(f"{source.path}: {error}") from None
    except expat.ExpatError:
        problems = syntax_problems(source)
        reason = f"{problems[0].span}: {problems[0].message}"
        raise UnreadableRobot(reason, tuple(problems)) from None
    root = next(token for token in tokens(source.data) if token.kind in _TAGS)
    if root.name != "robot" and not is_xacro(source):
        raise UnreadableRobot(f"{source.path}: the root element is <{root.name}>, not <robot>")


class _Outline(Record):
    """The elements among the tokens of a document, by the numbers of their start tags."""

    ends: dict[int, int]  # number of the end tag
    verbatim: set[int]  # elements that must not change: their white space may have a meaning


class _Open(Record):
    """An element before its end tag."""

    name: str
    is_foreign: bool  # True for elements of other programs, whose attributes keep their order


class _LineWriter:
    """Writes tokens as lines."""

    def __init__(self, document: list[Token], data: bytes, outline: _Outline, width: int) -> None:
        self._tokens = document
        self._data = data
        self._width = width
        self._ends, self._verbatim = outline
        self._lines: list[str] = []
        self._open: list[_Open] = []
        #: Line ends since the last token that is not white space.
        self._gap = 0
        #: True after a start tag and before an end tag, where blank lines are removed.
        self._at_edge = True

    def lines(self) -> list[str]:
        number = 0
        while number < len(self._tokens):
            token = self._tokens[number]
            if token.kind is TokenKind.TEXT:
                self._text(token)
            elif token.kind is TokenKind.COMMENT:
                self._comment(token, number)
            elif token.kind is TokenKind.END:
                self._end(token)
            elif token.kind in _TAGS:
                number = self._element(token, number)
            else:
                self._line(token.text)
            number += 1
        return self._lines

    def _text(self, token: Token) -> None:
        """Count line ends; write each line of a stray text."""
        for number, line in enumerate(token.text.split("\n")):
            self._gap += bool(number)
            if line.strip():
                self._line(line.strip())

    def _element(self, token: Token, number: int) -> int:
        """Write a start tag, or a whole element that must not change; returns its last token."""
        end = self._ends.get(number, number)
        if number in self._verbatim:
            inner = self._data[token.end : self._tokens[end].start].decode()
            self._line(f"{self._start_tag(token, '>')}{inner}</{token.name}>")
            return end
        if token.kind is TokenKind.EMPTY or all(
            _is_blank(self._tokens[i]) for i in range(number + 1, end)
        ):
            self._line(self._start_tag(token, "/>"))
            return end
        self._line(self._start_tag(token, ">"))
        self._open.append(_Open(token.name, self._is_foreign or token.name in _FOREIGN))
        self._at_edge = True
        return number

    def _start_tag(self, token: Token, close: str) -> str:
        return start_tag(token, close, self._indent, self._width, is_foreign=self._is_foreign)

    def _end(self, token: Token) -> None:
        self._at_edge = True
        if len(self._open) > 1:
            self._gap = 0
        self._open.pop()
        self._line(f"</{token.name}>")

    @property
    def _indent(self) -> str:
        return STEP * len(self._open)

    @property
    def _is_foreign(self) -> bool:
        return bool(self._open) and self._open[-1].is_foreign

    def _line(self, text: str) -> None:
        """Write a line, after a blank line if the source has one."""
        if self._gap > 1 and not (self._at_edge and len(self._open) > 1):
            self._lines.append("")
        self._lines.append(self._indent + text)
        self._gap, self._at_edge = 0, False

    def _comment(self, token: Token, number: int) -> None:
        """Write a comment, on the line of the preceding token if it was there."""
        before = self._tokens[number - 1] if number else None
        if before and before.kind is TokenKind.TEXT:
            before = self._tokens[number - 2] if number > 1 else None
        if (
            self._gap == 0
            and before
            and before.kind not in (TokenKind.INSTRUCTION, TokenKind.DOCTYPE)
        ):
            self._lines[-1] += f" {_stripped(token.text)}"
            return
        self._line(_reindented(token.text, self._column(token.start), len(self._indent)))

    def _column(self, at: int) -> int | None:
        """The indentation at an offset; None if other text precedes it on its line."""
        before = self._data[self._data.rfind(b"\n", 0, at) + 1 : at].decode()
        return None if before.strip() else len(before.expandtabs(_TAB))


def _outline(document: list[Token], path: str) -> _Outline:
    """The elements among the tokens of a document.

    Raises:
        UnreadableRobot: they are nested too deeply.
    """
    ends: dict[int, int] = {}
    verbatim: set[int] = set()
    stack: list[int] = []
    for number, token in enumerate(document):
        if token.kind in _TAGS:
            if ("xml:space", "preserve") in token.pairs:
                verbatim.add(number)
            if token.kind is TokenKind.START:
                stack.append(number)
                if len(stack) > MAX_DEPTH:
                    raise UnreadableRobot(f"{path}: elements are nested too deeply to be formatted")
        elif token.kind is TokenKind.END:
            start = stack.pop()
            ends[start] = number
            inner = document[start + 1]
            if number == start + 2 and inner.kind is TokenKind.TEXT and "\n" not in inner.text:
                verbatim.add(start)  # one space can be a value
        elif stack and _is_significant(token, [document[i].name for i in stack]):
            verbatim.add(stack[-1])
    return _Outline(ends, verbatim & ends.keys())


def _is_blank(token: Token) -> bool:
    return token.kind is TokenKind.TEXT and not token.text.strip()


def _is_significant(token: Token, path: list[str]) -> bool:
    """True for a text that a parser may read; ``token`` is not a tag."""
    if token.kind is TokenKind.CDATA:
        return True
    return token.kind is TokenKind.TEXT and bool(token.text.strip()) and not _is_stray_in(path)


def _is_stray_in(path: list[str]) -> bool:
    """True if no parser reads a text in the innermost of nested elements."""
    return path[-1] in container_tags() and not _FOREIGN.intersection(path)


def _stripped(comment: str) -> str:
    """A comment without trailing white space."""
    return "\n".join(line.rstrip() for line in comment.split("\n"))


def _reindented(comment: str, old: int | None, new: int) -> str:
    """A comment moved from one column to another, with all its lines."""
    first, *rest = _stripped(comment).split("\n")
    lines = [first]
    for line in rest:
        text = line.lstrip(" \t")
        column = len(line[: len(line) - len(text)].expandtabs(_TAB))
        if old is not None:
            column = max(0, column + new - old)
        lines.append(" " * column + text if text else "")
    return "\n".join(lines)


def _meaning(data: bytes) -> list[tuple[object, ...]]:
    """The content of a document without its layout: tags, values, texts and comments in order."""
    events: list[tuple[object, ...]] = []
    path: list[str] = []

    def start(name: str, values: dict[str, str]) -> None:
        known: dict[str, object] = {
            key: value.split() if key in vectors() else value for key, value in values.items()
        }
        if name == MACRO and "params" in values:
            known["params"] = [*chain(*parameters(values["params"]))] or values["params"]
        events.append(("start", name, known))
        path.append(name)

    def end(name: str) -> None:
        events.append(("end", name))
        path.pop()

    def text_of(data: str) -> None:
        if data.strip():
            events.append(("text", data.split() if _is_stray_in(path) else data))

    parser = expat.ParserCreate("utf-8")
    parser.buffer_text = True
    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = text_of
    parser.CommentHandler = lambda data: events.append(("comment", data.split()))
    parser.ProcessingInstructionHandler = lambda *words: events.append(("instruction", *words))
    parser.Parse(data, True)
    return events
