"""Terminal output: safe text of a robot's file, its width in columns, and code frames."""

import re

from urdfkit.text.source import Span

#: Replacement of a tab in a frame, where its true width is unknown.
_TAB = "    "
#: The text for one character, its width in columns, and whether a caret is below.
_Cell = tuple[str, int, bool]
#: Marks the end at which a line is cut.
_CUT = "..."
#: ANSI colour codes.
RED, YELLOW, CYAN, GREEN = "1;31", "1;33", "1;36", "32"
_COMMAND = r"(?:(?<=\s)|^):(?=:)|#(?=#(?:\[|vso))"


def printable(text: str) -> str:
    """A text on one line, without characters that control a terminal or a CI server.

    Escape sequences and marks that change the writing direction are shown by their numbers, and so
    is the first character of a log command of GitHub or Azure: ``::`` at the start of a line, to
    which a word may be wrapped, or ``##[``.
    """
    if not text.isprintable():
        text = "".join(map(_printable, text))
    if "::" in text or "##" in text:
        text = re.sub(_COMMAND, lambda match: f"\\x{ord(match[0]):x}", text)
    return text


def painted(text: str, code: str) -> str:
    """A printable text in an ANSI colour."""
    return f"\x1b[{code}m{text}\x1b[0m"


def _printable(char: str) -> str:
    if char.isprintable():
        return char
    if char.isspace():
        return " "
    return char.encode("unicode_escape").decode("ascii")


def columns(text: str) -> int:
    """Width of a printable text in columns: Chinese characters take two, accents none."""
    if text.isascii():
        return len(text)
    from unicodedata import category, east_asian_width

    special = [char for char in text if char > "\x7f"]
    wide = sum(east_asian_width(char) in "WF" for char in special)
    return len(text) + wide - sum(category(char) in ("Mn", "Me") for char in special)


def wrap(text: str, width: int, *, indent: int = 0, used: int = 0) -> str:
    """Break a printable text at spaces to fit ``width``; a long word is not split.

    Args:
        width: of the screen, in columns.
        indent: columns before the second and later lines.
        used: occupied columns of the first line.
    """
    lines = [""]
    available = width - used
    if used and available < width // 4:
        available = 0  # a lone word at the end of a long first line reads badly
    if columns(text) <= available:
        return text
    taken = 0  # columns of the last line
    for word in text.split(" "):
        size = columns(word)
        longer = taken + 1 + size if lines[-1] else size
        if longer <= available or not (lines[-1] or used):
            lines[-1] = f"{lines[-1]} {word}" if lines[-1] else word
            taken = longer
        else:
            lines.append(word)
            taken = size
            available = width - indent
            used = 0
    return f"\n{' ' * indent}".join(lines)


def frame(span: Span, width: int) -> tuple[str, str]:
    """The line on which a span begins, without its indentation, and carets below the span.

    The line is cut to ``width`` columns around the span. It may contain a whole robot of many
    kilobytes: only the visible part is read.
    """
    data, start = span.source.data, span.start
    window = 4 * width  # bytes; a character has four at most
    before = _last_line(data[max(0, start - window) : start])
    after = _first_line(data[start : start + window])
    text = _text(after)
    length = len(_text(after[: max(0, span.end - start)])) or 1  # an empty span gets one caret
    left = _text(before).lstrip()
    line = left + text
    is_plain = line.isascii() and line.isprintable() and text
    if len(line) <= width and is_plain and max(len(before), len(after)) < window:
        return line.rstrip(), " " * len(left) + "^" * len(text[:length].rstrip() or " ")
    cells = [
        *_cells(_CUT if len(before) == window else "", marked=False),
        *_cells(left, marked=False),
        *_cells(text[:length] or " ", marked=True),
        *_cells(text[length:], marked=False),
        *_cells(_CUT if len(after) == window else "", marked=False),
    ]
    return _cut(cells, width)


def _last_line(data: bytes) -> bytes:
    return data[max(data.rfind(b"\n"), data.rfind(b"\r")) + 1 :]


def _first_line(data: bytes) -> bytes:
    return data.split(b"\n", 1)[0].split(b"\r", 1)[0]


def _text(data: bytes) -> str:
    # The width is unchanged, but a CI server reads no command.
    return data.decode("utf-8", "replace").replace("##[", "#?[").replace("##vso[", "#?vso[")


def _cells(text: str, *, marked: bool) -> list[_Cell]:
    shown = (_TAB if char == "\t" else _printable(char) for char in text)
    return [(cell, columns(cell), marked) for cell in shown]


def _cut(cells: list[_Cell], width: int) -> tuple[str, str]:
    """The part of a line around its marked cells, and the carets."""
    total = sum(size for _, size, _ in cells)
    begin, end = 0, total
    if total > width:
        first = next(number for number, (_, _, mark) in enumerate(cells) if mark)
        left = sum(size for _, size, _ in cells[:first])
        marked = sum(size for _, size, mark in cells if mark)
        # The carets are centred; of a long span, the beginning is shown with some text before it.
        spare = max(width - marked, width // 4)
        begin = min(max(0, left - spare // 2), total - width)
        end = begin + width
    cut_left, cut_right = _CUT * (begin > 0), _CUT * (end < total)
    line, carets, column = cut_left, " " * len(cut_left), 0
    for text, size, mark in cells:
        if begin + len(cut_left) <= column and column + size <= end - len(cut_right):
            line += text
            carets += ("^" if mark else " ") * size
        column += size
    return (line + cut_right).rstrip(), carets.rstrip()
