"""Substitutions in launch files of XML: ``$(find pkg)``, ``$(var x)`` and the like."""

import os
import re
from collections.abc import Callable, Iterator, Mapping

from urdfkit.ros.launch.collect import UNKNOWN, Collector
from urdfkit.ros.launch.command_line import UNKNOWN_PART, command_words
from urdfkit.ros.launch.computed import computed, evaluated
from urdfkit.ros.launch.contents import Word
from urdfkit.text.document import Attribute
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

#: Substitutions of ROS 1 and ROS 2 in a parameter file.
_IN_FILES = {
    1: r"\$\((arg|find|env|optenv|eval) [^)\n]*\)",
    2: r"\$\((var|find-pkg-share|find-pkg-prefix|env) [^)\n]*\)",
}
#: Characters in a default that is a placeholder: the environment variable must be set.
_PLACEHOLDER = r"[!<>?]"
#: Greatest depth of nested substitutions that are resolved.
MAX_LEVELS = 50
#: Most characters of a text after substitution, as arguments could double repeatedly.
MAX_LENGTH = 100_000
#: Names that roslaunch defines, apart from arguments and functions.
_NAMES = {"true": True, "false": False} | {
    kind.__name__: kind for kind in (list, dict, map, str, float, int)
}
#: An expression of ROS 2, which is quoted as a whole, with escaped quotes in it; $(var ...) is
#: replaced in it.
_ESCAPED = r"\\([\"'\\])"
_QUOTED = re.compile(r"""(?s)\s*(["'])(.*)\1\s*""")


class Substitutions:
    """Resolves substitutions in the texts of a launch file.

    Args:
        values: known values of its arguments; extended while the file is read.
    """

    def __init__(self, collector: Collector, source: Source, values: dict[str, str]) -> None:
        self._collector = collector
        self._source = source
        self._values = values

    def text(self, text: str, span: Span, level: int = 0) -> str | None:
        """A text after substitution; None if known only at run time."""
        if level > MAX_LEVELS:
            return None
        parts: list[str] = []
        for part in self._parts(text, span, level):
            if part is None:
                return None
            parts.append(part)
        return "".join(parts)

    def command_line(self, text: str, span: Span) -> str:
        """A text after substitution, with ``UNKNOWN_PART`` for parts known only at run time."""
        return "".join(UNKNOWN_PART if part is None else part for part in self._parts(text, span))

    def _parts(self, text: str, span: Span, level: int = 0) -> Iterator[str | None]:
        """The parts of a text after substitution; None if unknown, or if the text is too long."""
        length = 0
        for is_command, part in pieces(text):
            value = self.command(part, span, level) if is_command else part
            length += len(value or "")
            if length > MAX_LENGTH:
                yield None
                return
            yield value

    def command(self, content: str, span: Span, level: int = 0) -> str | None:
        """The value of the content of ``$(...)``; None if unknown."""
        if content.startswith("eval "):
            return self._evaluated(content[len("eval ") :], span, level)
        inner = self.text(content, span, level + 1)
        words = inner.split(None, 1) if inner else []
        if not words:
            return None
        command, rest = words[0], words[1].strip() if len(words) > 1 else ""
        if command in ("find", "find-pkg-share", "find-pkg-prefix"):
            return self._found(rest, span)
        if command in ("arg", "var"):
            return self._values.get(rest)
        if command == "dirname":
            return os.path.dirname(os.path.abspath(self._source.path))
        if command in ("optenv", "env"):
            _, _, default = rest.partition(" ")
            default = default.strip().strip("'\"")
            return None if not default or re.search(_PLACEHOLDER, default) else default
        return computed(command, command_words(rest))  # None for anon, exec-in-pkg, command

    def _evaluated(self, expression: str, span: Span, level: int) -> str | None:
        quoted = _QUOTED.fullmatch(expression)
        if quoted and "$(" in quoted[2]:
            text = self.text(re.sub(_ESCAPED, r"\1", quoted[2]), span, level + 1)
            return None if text is None else evaluated(text)
        functions = {"find": lambda name: self._found(name, span)}
        return evaluate(expression, self._values, functions)

    def words(self, attribute: Attribute | None) -> tuple[Word, ...]:
        """The words of a command line, with the locations of constant words."""
        if attribute is None:
            return ()
        # An argument with an empty default is also a word.
        parts = (part or UNKNOWN_PART for part in self._parts(attribute.value, attribute.span))
        return tuple(
            Word(None if UNKNOWN_PART in word else word, attribute.span)
            for word in command_words("".join(parts))
        )

    def _found(self, package: str, span: Span) -> str:
        """The directory of a package.

        Only the file in it is relevant, not whether xacro is installed.
        """
        directory = self._collector.package(package, self._source, span)
        return directory if directory is not None else f"{UNKNOWN}/{package}"


def evaluate(
    text: str, arguments: Mapping[str, str], functions: Mapping[str, Callable[[str], str]]
) -> str | None:
    """The result of ``$(eval ...)`` in ROS 1 as text; None if it is unknown.

    Source: ``_eval`` and ``_DictWrapper`` in ``roslaunch/substitution_args.py`` of ros/ros_comm.

    Args:
        arguments: of the launch file; available by name.
        functions: of one text, such as ``find``.
    """
    values = {name: _converted(value) for name, value in arguments.items()}
    return evaluated(text, _NAMES | {"arg": values.__getitem__, **functions, **values})


def _converted(text: str) -> str | bool | int | float:
    """The value of an argument in an expression, as roslaunch converts it."""
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def pieces(text: str) -> Iterator[tuple[bool, str]]:
    """The texts outside of ``$(...)``, and its contents with nested substitutions."""
    start = position = 0
    while (opening := text.find("$(", position)) >= 0:
        depth, end = 0, opening
        for end in range(opening, len(text)):
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            if text[end] == ")" and depth == 0:
                break
        else:
            break
        if opening > start:
            yield False, text[start:opening]
        yield True, text[opening + 2 : end]
        start = position = end + 1
    if start < len(text):
        yield False, text[start:]


def unresolved(path: str, ros: int, resolver: Resolver) -> str | None:
    """The first substitution in a YAML file, or None."""
    source = resolver.readable(path)
    if source is None or b"$(" not in source.data:  # most files, which many nodes may load
        return None
    text = re.sub(r"(^|\s)#.*", "", source.data.decode("utf-8", "replace"))
    match = re.search(_IN_FILES[ros], text)
    return match.group(0) if match else None
