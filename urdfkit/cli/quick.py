"""Parses ordinary ``check`` command lines without click, whose import takes 27 ms."""

from collections.abc import Sequence

from urdfkit.cli.options import CHECK, COLOR, FILES
from urdfkit.core.static_typing import Any


def parse(words: Sequence[str]) -> dict[str, Any] | None:
    """The values of a ``check`` command line.

    Returns:
        The values by key, or None for any other command line: another command, ``--help``, an
        unknown option, a value that is missing, invalid, or resembles an option. click then parses
        the line, and prints the help or an error.
    """
    if not words or words[0] != "check":
        return None
    known = (*CHECK, COLOR)
    options = {option.flag: option for option in known}
    options.update((option.short, option) for option in known if option.short)
    values: dict[str, Any] = {option.key: option.initial for option in known}
    files: list[str] = []
    rest = iter(words[1:])
    for word in rest:
        if word == "-" or not word.startswith("-"):
            files.append(word)
            continue
        flag, equals, value = word.partition("=")
        option = options.get(flag)
        if option is None or (equals and (flag == option.short or not option.metavar)):
            return None
        if not option.metavar:
            values[option.key] = True
            continue
        if not equals:
            value = next(rest, "-")
            if value.startswith("-"):
                return None
        if option.choices and value not in option.choices:
            return None
        values[option.key] = (*values[option.key], value) if option.many else value
    values[FILES] = tuple(files)
    return values if files else None
