"""The layout of URDF and xacro: one way to write a document that means the same.

Every element begins a line, indented by its depth; attributes have one order and one kind of
quotes; numbers of a vector stand one space apart and are spelt as they were. Comments stay where
they stand, single blank lines as well. What holds text is left as it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from itertools import chain
from xml.parsers import expat

from urdfkit import schema
from urdfkit.editing.edits import STEP
from urdfkit.editing.markup import Kind, Token, tokens
from urdfkit.errors import UnreadableRobot
from urdfkit.reading import is_xacro, syntax_problems
from urdfkit.record import Record
from urdfkit.source import Source

#: Columns of a line; only what cannot be broken is longer.
WIDTH = 100
#: Levels of elements; indentation grows with the square of them, and robots have 20.
MAX_DEPTH = 1000
#: What a tab in front of a comment's line stands for.
_TAB = 4

_MACRO = "xacro:macro"
#: First attributes of tags of xacro; those of URDF come from its grammar.
_XACRO_ORDER = {
    _MACRO: ("name", "params"),
    "xacro:property": ("name", "value"),
    "xacro:arg": ("name", "default"),
    "xacro:include": ("filename",),
}
#: The upper half of a tensor: its rows are those of the matrix.
_TENSOR = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
#: Blocks in which other programs read their own tags.
_FOREIGN = frozenset(("gazebo", "transmission", "ros2_control"))


def formatted(source: Source, width: int = WIDTH) -> bytes:
    r"""The text of a source, laid out; in UTF-8, with the line ends that it has.

    >>> text = b"<robot  name='r' >\n<link name='a'></link><!-- one --></robot>"
    >>> print(formatted(Source("r.urdf", text)).decode(), end="")
    <robot name="r">
      <link name="a"/> <!-- one -->
    </robot>

    Args:
        source: URDF or xacro.
        width: columns of a line.

    Raises:
        UnreadableRobot: it is not well-formed, or no robot.
    """
    _require_robot(source)
    text = source.data.decode().replace("\r\n", "\n")
    found = list(tokens(text))
    outline = _outline(found, source.path)
    layout = "\n".join(_Writer(found, text, outline, width).lines()) + "\n"
    if list(_meaning(layout)) != list(_meaning(text)):
        raise AssertionError(f"{source.path}: the layout would change the meaning")
    newline = "\r\n" if b"\r\n" in source.data else "\n"
    return layout.replace("\n", newline).encode()


def _require_robot(source: Source) -> None:
    """See that a file can be laid out.

    Raises:
        UnreadableRobot: it is not well-formed, or no robot.
    """
    if source.undecodable is not None:
        raise UnreadableRobot(f"{source.path}: it has bytes that are no text")
    try:
        expat.ParserCreate("utf-8").Parse(source.data, True)
    except expat.ExpatError:
        problems = syntax_problems(source)
        reason = f"{problems[0].span}: {problems[0].message}"
        raise UnreadableRobot(reason, tuple(problems)) from None
    root = next(one for one in tokens(source.data.decode()) if one.kind is Kind.START)
    if root.name != "robot" and not is_xacro(source):
        raise UnreadableRobot(f"{source.path}: no robot, its root is <{root.name}>")


class _Outline(Record):
    """Which tokens of a document belong together.

    Attributes:
        ends: the number of the end tag by that of the start tag.
        verbatim: start tags of elements that stay as they are, because they hold text: white
            space may mean something there.
    """

    ends: dict[int, int]
    verbatim: set[int]


class _Open(Record):
    """An element whose end tag has not come.

    Attributes:
        name: of it.
        is_foreign: True where attributes are another program's affair.
    """

    name: str
    is_foreign: bool


class _Writer:
    """Makes lines of tokens."""

    def __init__(self, found: list[Token], text: str, outline: _Outline, width: int) -> None:
        self._tokens = found
        self._text = text
        self._width = width
        self._ends, self._verbatim = outline
        self._lines: list[str] = []
        self._open: list[_Open] = []
        #: Line ends since the last token that is no white space.
        self._gap = 0
        #: True after a start tag and before an end tag: inside, blank lines help nobody there.
        self._fresh = True

    def lines(self) -> list[str]:
        """The lines of the document."""
        number = 0
        while number < len(self._tokens):
            token = self._tokens[number]
            if token.kind is Kind.TEXT:
                self._gap += token.text.count("\n")
            elif token.kind is Kind.COMMENT:
                self._comment(token, number)
            elif token.kind is Kind.END:
                self._end(token)
            elif token.kind is Kind.START:
                number = self._element(token, number)
            else:
                self._line(token.text)
            number += 1
        return self._lines

    def _element(self, token: Token, number: int) -> int:
        """Write a start tag, or a whole element that stays as it is; the last token of it."""
        end = self._ends.get(number, number)
        if number in self._verbatim:
            inner = self._text[token.at + len(token.text) : self._tokens[end].at]
            self._line(f"{self._start_tag(token, '>')}{inner}</{token.name}>")
            return end
        if token.is_empty or all(_is_blank(self._tokens[i]) for i in range(number + 1, end)):
            self._line(self._start_tag(token, "/>"))
            return end
        self._line(self._start_tag(token, ">"))
        self._open.append(_Open(token.name, self._is_foreign or token.name in _FOREIGN))
        self._fresh = True
        return number

    def _end(self, token: Token) -> None:
        self._fresh = True
        if len(self._open) > 1:
            self._gap = 0
        self._open.pop()
        self._line(f"</{token.text[2:-1].strip()}>")

    @property
    def _indent(self) -> str:
        return STEP * len(self._open)

    @property
    def _is_foreign(self) -> bool:
        return bool(self._open) and self._open[-1].is_foreign

    def _line(self, text: str) -> None:
        """Begin a line, after a blank one if there was one."""
        if self._gap > 1 and not (self._fresh and len(self._open) > 1):
            self._lines.append("")
        self._lines.append(self._indent + text)
        self._gap, self._fresh = 0, False

    def _comment(self, token: Token, number: int) -> None:
        """Behind what it stands behind on its line, else on a line of its own."""
        before = self._tokens[number - 1] if number else None
        if before and before.kind is Kind.TEXT:
            before = self._tokens[number - 2] if number > 1 else None
        if self._gap == 0 and before and before.kind not in (Kind.INSTRUCTION, Kind.DOCTYPE):
            self._lines[-1] += f" {_stripped(token.text)}"
            return
        self._line(_shifted(token.text, self._column(token.at), len(self._indent)))

    def _column(self, at: int) -> int | None:
        """The indentation of a place; None if something else stands before it on its line."""
        before = self._text[self._text.rfind("\n", 0, at) + 1 : at]
        return None if before.strip() else len(before.expandtabs(_TAB))

    def _start_tag(self, token: Token, close: str) -> str:
        pairs = list(self._attributes(token))
        attributes = [f"{name}={value}" for name, value in pairs]
        one_line = " ".join((f"<{token.name}", *attributes)) + close
        if token.name == _MACRO:
            one_line = one_line.replace("\n", " ")
        if not attributes or len(self._indent) + len(one_line) <= self._width:
            return one_line
        hang = len(self._indent) + len(token.name) + 2
        if hang > self._width // 2:
            hang = len(self._indent) + 2 * len(STEP)
        first = f"{self._indent}<{token.name} "
        room = self._width - len(close)
        if token.name.startswith("xacro:") and token.name not in _XACRO_ORDER:
            rows = [[attribute] for attribute in attributes]  # of a macro: what each stands for
        elif tuple(name for name, _ in pairs) == _TENSOR:
            rows = [attributes[:3], attributes[3:5], attributes[5:]]
        else:
            if token.name == _MACRO:
                attributes = [_filled(name, value, hang, room) for name, value in pairs]
            rows = _rows(attributes, len(first), hang, room)
        lines = [" ".join(row) for row in rows]
        return (first + f"\n{' ' * hang}".join(lines)).lstrip() + close

    def _attributes(self, token: Token) -> Iterator[tuple[str, str]]:
        """Names and quoted values, in their order."""
        written = token.attributes
        order = () if self._is_foreign else _order().get(token.name, ())
        known = sorted((a for a in written if a[0] in order), key=lambda a: order.index(a[0]))
        for name, quoted in (*known, *(a for a in written if a[0] not in order)):
            value = quoted[1:-1]
            if name in _vectors() and not self._is_foreign:
                value = _vector(value)
            elif (token.name, name) == (_MACRO, "params"):
                value = "\n".join(map(" ".join, _parameters(value) or [[value]]))
            yield name, f"'{value}'" if '"' in value else f'"{value}"'


def _filled(name: str, value: str, hang: int, width: int) -> str:
    """An attribute of a macro; its parameters in the lines that they had, each below the first.

    Args:
        name: of it.
        value: with its quotes.
        hang: columns before it.
        width: columns of a line.
    """
    found = _parameters(value[1:-1]) if name == "params" else []
    rows: list[str] = []
    hang += len(name) + 2
    for line in found:
        rows.append("")
        for word in line:
            if rows[-1] and hang + len(f"{rows[-1]} {word}") >= width:
                rows.append("")
            rows[-1] += f" {word}" if rows[-1] else word
    text = f"\n{' ' * hang}".join(rows)
    return f"{name}={value[0]}{text}{value[0]}" if rows else f"{name}={value}"


def _rows(attributes: list[str], first: int, hang: int, width: int) -> list[list[str]]:
    """Attributes in as few lines as they take, with the same number in each if that fits.

    Args:
        attributes: as they are written.
        first: columns before those of the first line.
        hang: columns before those of the others.
        width: columns of a line.
    """
    rows = [attributes[:1]]
    for attribute in attributes[1:]:
        used = (first if len(rows) == 1 else hang) + len(" ".join(rows[-1]))
        if used + 1 + len(attribute) > width:
            rows.append([attribute])
        else:
            rows[-1].append(attribute)
    size = -(-len(attributes) // len(rows))
    even = [attributes[at : at + size] for at in range(0, len(attributes), size)]
    return even if all(max(first, hang) + len(" ".join(row)) <= width for row in even) else rows


def _outline(found: list[Token], path: str) -> _Outline:
    """Which tokens are elements.

    Raises:
        UnreadableRobot: they are nested too deeply.
    """
    ends: dict[int, int] = {}
    verbatim: set[int] = set()
    stack: list[int] = []
    for number, token in enumerate(found):
        if token.kind is Kind.START:
            if "xml:space" in token.text and ("xml:space", "preserve") in _values(token):
                verbatim.add(number)
            if not token.is_empty:
                stack.append(number)
                if len(stack) > MAX_DEPTH:
                    raise UnreadableRobot(f"{path}: elements are nested too deeply to be laid out")
        elif token.kind is Kind.END:
            start = stack.pop()
            ends[start] = number
            inner = found[start + 1]
            if number == start + 2 and inner.kind is Kind.TEXT and "\n" not in inner.text:
                verbatim.add(start)  # one space can be a value
        elif stack and (
            token.kind is Kind.CDATA or (token.kind is Kind.TEXT and token.text.strip())
        ):
            verbatim.add(stack[-1])
    return _Outline(ends, verbatim & ends.keys())


def _values(token: Token) -> list[tuple[str, str]]:
    return [(name, quoted[1:-1]) for name, quoted in token.attributes]


def _is_blank(token: Token) -> bool:
    return token.kind is Kind.TEXT and not token.text.strip()


def _stripped(comment: str) -> str:
    """A comment without white space at the end of its lines."""
    return "\n".join(line.rstrip() for line in comment.split("\n"))


def _shifted(comment: str, old: int | None, new: int) -> str:
    """A comment whose first line moves from one column to another, and the others with it."""
    first, *others = _stripped(comment).split("\n")
    lines = [first]
    for line in others:
        text = line.lstrip(" \t")
        column = len(line[: len(line) - len(text)].expandtabs(_TAB))
        if old is not None:
            column = max(0, column + new - old)
        lines.append(" " * column + text if text else "")
    return "\n".join(lines)


_VECTOR = re.compile(r"\s*[-+.\deE]+(?:\s+[-+.\deE]+)*\s*")


def _vector(value: str) -> str:
    """Numbers one space apart, each spelt as it was; anything else as it is."""
    return " ".join(value.split()) if _VECTOR.fullmatch(value) else value


_PARAMETER = re.compile(r"""(?:'[^'\n]*'|"[^"\n]*"|[^\s'"])+""")


def _parameters(value: str) -> list[list[str]]:
    """The parameters of a macro, line by line; none where that is not sure.

    White space between them says nothing to xacro; that in quotes is part of a default, and a
    line end there is a space.
    """
    lines = value.split("\n")
    if any(map(_rest, lines)):
        lines = [" ".join(lines)]
    if "&" in value or _rest(lines[0]):
        return []
    return [words for line in lines if (words := _PARAMETER.findall(line))]


def _rest(line: str) -> str:
    """What is no parameter: a quote that is open at the end."""
    return _PARAMETER.sub("", line).strip()


@cache
def _grammars() -> dict[str, schema.Grammar]:
    """The grammars of URDF's elements by tag."""
    found: dict[str, schema.Grammar] = {}
    stack = [("robot", schema.ROBOT)]
    while stack:
        tag, grammar = stack.pop()
        if tag not in found:
            found[tag] = grammar
            stack.extend(grammar.children.items())
    return found


@cache
def _order() -> dict[str, tuple[str, ...]]:
    """The order of the attributes of a tag, as far as it is known."""
    return {tag: tuple(one.attributes) for tag, one in _grammars().items()} | _XACRO_ORDER


@cache
def _vectors() -> frozenset[str]:
    """Attributes of several numbers."""
    return frozenset(
        name
        for grammar in _grammars().values()
        for name, rule in grammar.attributes.items()
        if schema.LENGTHS.get(rule.type, 1) > 1
    )


def _meaning(text: str) -> Iterator[tuple[object, ...]]:
    """What a document says, whatever its layout: tags, values, texts and comments in order."""
    events: list[tuple[object, ...]] = []

    def start(name: str, values: dict[str, str]) -> None:
        known: dict[str, object] = {
            key: value.split() if key in _vectors() else value for key, value in values.items()
        }
        if name == _MACRO and "params" in values:
            known["params"] = [*chain(*_parameters(values["params"]))] or values["params"]
        events.append(("start", name, known))

    parser = expat.ParserCreate("utf-8")
    parser.buffer_text = True
    parser.StartElementHandler = start
    parser.EndElementHandler = lambda name: events.append(("end", name))
    parser.CharacterDataHandler = lambda data: events.append(("text", data))
    parser.CommentHandler = lambda data: events.append(("comment", data.split()))
    parser.ProcessingInstructionHandler = lambda *words: events.append(("instruction", *words))
    parser.Parse(text.encode(), True)
    for event in events:
        if event[0] != "text" or str(event[1]).strip():
            yield event
