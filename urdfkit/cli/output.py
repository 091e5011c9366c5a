"""Standard output: whether it has colours, how wide it is, and what can go wrong with it."""

import os
import sys
from collections.abc import Callable, Iterable, Iterator

from urdfkit.errors import UnwritableFile
from urdfkit.text.source import shown_text
from urdfkit.text.terminal import columns, printable, wrap

#: How units are written where the terminal has no letters for them, such as kg m^2.
_ASCII = str.maketrans({"·": " ", "²": "^2", "³": "^3"})
#: The colours of a line in a diff, by how it begins.
_DIFF = {"---": 1, "+++": 1, "@@": 36, "-": 31, "+": 32}


def has_color(when: str) -> bool:
    """Whether to write colours: ``always``, ``never``, or ``auto`` for what the place allows.

    https://no-color.org and https://force-color.org: a value that is not empty counts.
    """
    if when != "auto":
        return when == "always"
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return is_terminal() and os.environ.get("TERM") != "dumb"


def width() -> int:
    """Columns of the terminal, or as many as COLUMNS says; 80 where there is none."""
    given = os.environ.get("COLUMNS", "")
    if given.isdecimal() and int(given) > 0:
        return int(given)
    if not is_terminal():
        return 80
    try:
        return os.get_terminal_size(sys.stdout.fileno()).columns or 80
    except (OSError, ValueError):
        return 80


def is_terminal() -> bool:
    """True if people read standard output, and no program or file takes it."""
    return sys.stdout is not None and sys.stdout.isatty()


def write(text: str) -> bytes:
    """Write to standard output, in UTF-8 unless a terminal wants another encoding.

    A reader that goes away early (``| head``) is no error.

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
        if binary is None:  # an in-process caller has put something of its own there
            sys.stdout.write(text)
        else:
            binary.write(data)
        sys.stdout.flush()
    except OSError as error:
        give_up(error)
    return data


def write_diff(text: str, when: str) -> None:
    """Write a diff, with the colours of git if there are to be any (`has_color`).

    In a file it stays a patch whatever FORCE_COLOR says, which CI servers set.

    Raises:
        UnwritableFile: standard output is closed, or its disk is full.
    """
    if has_color(when) and (is_terminal() or when == "always"):
        text = "\n".join(map(_colored, text.split("\n")))
    write(text)


def _colored(line: str) -> str:
    code = next((code for start, code in _DIFF.items() if line.startswith(start)), 0)
    return f"\x1b[{code}m{line}\x1b[0m" if code else line


def give_up(error: OSError) -> None:
    """Standard output cannot be written; that nobody reads it any more is no error.

    Raises:
        UnwritableFile: its disk is full.
    """
    # What is left in the buffer must not fail a second time when Python exits.
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    if not isinstance(error, BrokenPipeError):
        raise UnwritableFile(f"standard output: {error.strerror or error}") from error


def _for_terminal(text: str, encoding: str) -> bytes:
    try:
        return text.encode(encoding)
    except UnicodeEncodeError:
        return text.translate(_ASCII).encode(encoding, "replace")


def aligned(values: Iterable[float], noise: float = 0.0, width: int = 9) -> str:
    """Numbers in columns of one width: to four digits in nine, to three in eight.

    Args:
        noise: what is no larger is but the rounding of sums, and 0.
        width: of a column; a number that is too long has a digit less.
    """
    return " ".join(_short(0.0 if abs(value) <= noise else value, width) for value in values)


def _short(value: float, width: int) -> str:
    exact = f"{value:{width}.{width - 5}g}"
    return exact if len(exact) == width else f"{value:{width}.{width - 6}g}"


def two_columns(rows: Iterable[tuple[str, str]]) -> Iterator[str]:
    """Lines of names and their descriptions: in two columns, or below each name if too wide.

    Args:
        rows: a row without a name belongs to the one before.
    """
    every = list(rows)
    most = max((columns(name) for name, _ in every), default=0)
    fits = most + 1 + max((columns(reported) for _, reported in every), default=0) <= width()
    for name, reported in every:
        if fits:
            yield f"{name}{' ' * (most - columns(name))} {reported}".rstrip()
        else:
            yield from [name] if name else []
            yield f"  {reported}".rstrip()


def wrapped(text: str, indent: int = 2) -> list[str]:
    """A text in lines no wider than the terminal, the second and later ones indented."""
    return wrap(text, width(), indent=indent).split("\n")


def labelled(label: str, text: str) -> list[str]:
    """A text behind a word, in lines no wider than the terminal."""
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


def page(lines: Iterable[str]) -> None:
    """Write lines for people; nothing in a name steers the terminal.

    Raises:
        UnwritableFile: standard output is closed, or its disk is full.
    """
    write("".join(f"{printable(line)}\n" for line in lines))


def note(text: str) -> None:
    """Say on standard error what is not part of the result."""
    tell(f"note: {text}")


def tell(*texts: str) -> None:
    """Write lines to standard error; only a terminal gets them wrapped, and `grep` whole."""
    for text in map(printable, map(shown_text, texts)):
        if sys.stderr is not None:
            is_shown = sys.stderr.isatty()
            print(wrap(text, width(), indent=2) if is_shown else text, file=sys.stderr, flush=True)


def json_or_page(form: str, document: Callable[[], object], lines: Iterable[str]) -> None:
    """Write what a command found: as JSON if that is its format, or as lines for people.

    Raises:
        UnwritableFile: standard output is closed, or its disk is full.
    """
    if form == "json":
        from urdfkit.core.strict_json import dumped

        write(dumped(document()))
    else:
        page(lines)


def encode(text: str) -> bytes:
    """UTF-8; bytes of a file name that are no text become escapes that JSON can hold."""
    return text.encode("utf-8", "backslashreplace")


def size(number: int) -> str:
    """A number of bytes in kB or MB."""
    return f"{number / 1e6:.1f} MB" if number >= 1e6 else f"{number / 1e3:.0f} kB"
