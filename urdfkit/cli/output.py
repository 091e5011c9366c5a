"""Standard output and standard error: colours, width, encoding and errors."""

import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping

from urdfkit.core.grouping import by_key
from urdfkit.errors import UnwritableFile
from urdfkit.text.source import shown_text
from urdfkit.text.terminal import CYAN, RED, YELLOW, columns, painted, printable, wrap

#: Units for terminals whose encoding lacks these letters, such as kg m^2.
_ASCII = str.maketrans({"·": " ", "²": "^2", "³": "^3", "µ": "u"})
#: ANSI colour codes of the lines in a diff, by prefix.
_DIFF = {"---": "1", "+++": "1", "@@": "36", "-": "31", "+": "32"}
#: ANSI colour codes of the words that begin a line of standard error.
_LABELS = {"error": RED, "warning": YELLOW}
#: Colours of a severity that begins a line, or is indented by two columns, for `colored`.
SEVERITIES = {
    rf"(?:^|(?<=^  )){word}\b": code
    for word, code in (("error", RED), ("warning", YELLOW), ("info", CYAN))
}

#: Errors of one code that are listed.
_SAME = 5

_color = "auto"


def use_color(when: str) -> None:
    """Set the colours of this process: ``always``, ``never``, or ``auto`` by the environment."""
    global _color  # noqa: PLW0603 - one process answers one command line
    _color = when


def used_color() -> str:
    """The colours of this process, as they were set."""
    return _color


def has_color() -> bool:
    """True if standard output has colours.

    Source: https://no-color.org and https://force-color.org; only non-empty values count.
    """
    return _has_color(is_terminal())


def _has_color(is_shown: bool) -> bool:
    """True if a stream has colours; ``is_shown`` if it is a terminal."""
    if _color != "auto":
        return _color == "always"
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return is_shown and os.environ.get("TERM") != "dumb"


def width() -> int:
    """Number of columns: of the variable COLUMNS, else of the terminal, else 80."""
    variable = os.environ.get("COLUMNS", "")
    if variable.isdecimal() and int(variable) > 0:
        return int(variable)
    if not is_terminal():
        return 80
    try:
        return os.get_terminal_size(sys.stdout.fileno()).columns or 80
    except (OSError, ValueError):
        return 80


def is_terminal() -> bool:
    """True if standard output is a terminal."""
    return sys.stdout is not None and sys.stdout.isatty()


def write(text: str) -> bytes:
    """Write to standard output, in UTF-8 unless a terminal requires another encoding.

    A pipe that the reader closes early (``| head``) is not an error.

    Returns:
        The bytes that were written.

    Raises:
        UnwritableFile: standard output is closed, or its disk is full.
    """
    if sys.stdout is None:
        raise UnwritableFile("standard output is closed; send it to /dev/null instead")
    data = _for_terminal(text, sys.stdout.encoding) if is_terminal() else encode(text)
    try:
        binary = getattr(sys.stdout, "buffer", None)
        if binary is None:  # replaced by an in-process caller
            sys.stdout.write(text)
        else:
            binary.write(data)
        sys.stdout.flush()
    except OSError as error:
        handle_write_error(error)
    return data


def write_diff(text: str) -> None:
    """Write a diff, in the colours of git if colours are enabled (`has_color`).

    In a file it stays a patch even with FORCE_COLOR, which CI servers set. A note says where
    ``patch`` takes it, if files outside of the current directory change.

    Raises:
        UnwritableFile: standard output is closed, or its disk is full.
    """
    if has_color() and (is_terminal() or _color == "always"):
        text = "\n".join(map(_colored_diff, text.split("\n")))
    write(text)
    if not is_terminal() and (directory := _directory_for_patch(text)):
        note(f"patch rejects absolute paths: run this in {directory}")


def _directory_for_patch(text: str) -> str:
    """The directory of the files of a diff that has absolute paths; else empty."""
    names = [line[4:] for line in text.split("\n") if line.startswith("+++ ")]
    if not any(map(os.path.isabs, names)):
        return ""
    try:
        return os.path.commonpath([os.path.dirname(os.path.abspath(name)) for name in names])
    except ValueError:  # on several drives
        return ""


def _colored_diff(line: str) -> str:
    code = next((code for start, code in _DIFF.items() if line.startswith(start)), "")
    return painted(line, code) if code else line


def handle_write_error(error: OSError) -> None:
    """Handle a failed write to standard output; a closed pipe is not an error.

    Raises:
        UnwritableFile: the disk is full.
    """
    # The rest of the buffer must not fail again when Python exits.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    if not isinstance(error, BrokenPipeError):
        raise UnwritableFile(f"standard output: {error.strerror or error}") from error


def _for_terminal(text: str, encoding: str) -> bytes:
    try:
        return text.encode(encoding)
    except UnicodeEncodeError:
        return text.translate(_ASCII).encode(encoding, "replace")


def aligned(values: Iterable[float], noise: float = 0.0, width: int = 9) -> str:
    """Numbers in columns of equal width, with ``width - 5`` significant digits.

    Args:
        noise: largest absolute value that is printed as 0, as a rounding error.
        width: width of a column; a number that is too long gets one digit less.
    """
    return " ".join(_short(0.0 if abs(value) <= noise else value, width) for value in values)


def _short(value: float, width: int) -> str:
    exact = f"{value:{width}.{width - 5}g}"
    return exact if len(exact) == width else f"{value:{width}.{width - 6}g}"


def two_columns(rows: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Lines with names and descriptions in two columns; below a name that is too long.

    If most names are too long, each description is below its name.

    Args:
        rows: a row without a name continues the previous row.
    """
    rows = list(rows)
    room = width() - 1 - max((columns(text) for _, text in rows), default=0)
    fitting = [columns(name) for name, _ in rows if name and columns(name) <= room]
    if 2 * len(fitting) < sum(bool(name) for name, _ in rows):
        for name, text in rows:
            yield from [name] if name else []
            yield f"  {text}".rstrip()
        return
    column = max(fitting, default=0)
    for name, text in rows:
        is_long = columns(name) > column
        yield from [name] if is_long else []
        start = " " * column if is_long else f"{name}{' ' * (column - columns(name))}"
        yield f"{start} {text}".rstrip()


def wrapped(text: str) -> list[str]:
    """A text in lines no wider than the terminal, the second and later ones indented."""
    return wrap(text, width(), indent=2).split("\n")


def labelled(label: str, text: str) -> list[str]:
    """A text after a label, in lines no wider than the terminal."""
    lines = indented(text, first=f"  {label:<10} ", rest=" " * 13)
    return lines or [f"  {label}"]


def indented(text: str, first: str = "  ", rest: str = "    ") -> list[str]:
    """A text in lines that are indented and no wider than the terminal."""
    import textwrap

    return textwrap.wrap(
        text,
        max(width(), 40),
        initial_indent=first,
        subsequent_indent=rest,
        break_long_words=False,
        break_on_hyphens=False,
    )


def errors(found: Iterable[tuple[str, str, str]]) -> Iterator[str]:
    """Lines for errors of a robot, of each code the first ones and the number of the others.

    Args:
        found: place, message and code of each; the code is empty without a rule.
    """
    places = by_key((code, f"{place}: {message}") for place, message, code in found)
    for code, texts in places.items():
        rule = f" ({code})" if code else ""
        for text in texts[:_SAME]:
            yield from indented(printable(text + rule))
        if len(texts) > _SAME:
            yield f"  and {len(texts) - _SAME} more{rule}"


def page(lines: Iterable[str], colors: Mapping[str, str] = {}) -> None:
    """Write lines of text, with control characters escaped.

    Args:
        colors: see `colored`.

    Raises:
        UnwritableFile: standard output is closed, or its disk is full.
    """
    write("".join(f"{colored(printable(line), colors)}\n" for line in lines))


def colored(line: str, colors: Mapping[str, str]) -> str:
    """A printable line, in which words have colours if standard output has any.

    Args:
        colors: ANSI codes by regular expression; of each expression, the first match is coloured.
    """
    if colors and has_color():
        for words, code in colors.items():
            line = re.sub(words, painted(r"\g<0>", code), line, count=1)
    return line


def note(text: str) -> None:
    """Write a note to standard error."""
    log(f"note: {text}")


def log(*texts: str) -> None:
    """Write lines to standard error; they are wrapped for a terminal only."""
    if sys.stderr is None:
        return
    is_shown = sys.stderr.isatty()
    for text in map(printable, map(shown_text, texts)):
        line = wrap(text, width(), indent=2) if is_shown else text
        label = line.partition(":")[0]
        if label in _LABELS and _has_color(is_shown):
            line = painted(label, _LABELS[label]) + line.removeprefix(label)
        print(line, file=sys.stderr, flush=True)


def json_or_page(
    format: str,
    document: Callable[[], object],
    lines: Iterable[str],
    colors: Mapping[str, str] = {},
) -> None:
    """Write the result of a command, as JSON or as lines of text.

    Args:
        colors: of words in the text, see `colored`.

    Raises:
        UnwritableFile: standard output is closed, or its disk is full.
    """
    if format == "json":
        from urdfkit.core.strict_json import dumped

        write(dumped(document()))
    else:
        page(lines, colors)


def encode(text: str) -> bytes:
    """Text in UTF-8; undecodable bytes of file names become escapes that are valid in JSON."""
    return text.encode("utf-8", "backslashreplace")


def size(number: int) -> str:
    """A number of bytes in kB or MB."""
    return f"{number / 1e6:.1f} MB" if number >= 1e6 else f"{number / 1e3:.0f} kB"


def csv_text(header: Iterable[object], rows: Iterable[Iterable[object]]) -> str:
    """A table as CSV."""
    import csv
    import io

    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows((header, *rows))
    return text.getvalue()
