"""Names that the expressions of xacro files use, whether or not they are evaluated."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.text.comments import blank_comments
from urdfkit.text.source import Source

_EXPRESSION = rb"\$\{([^}]*)\}"
_COMMAND = rb"\$\(([^)]*)\)"
_WORD = rb"[A-Za-z_]\w*"
_NAME_BEFORE = rb"(\w+)\s*:?=\s*\Z"
_ARGUMENT = rb"""\barg(?:\s+|\(\s*["'])([^\s"')]+)"""
_INSERTED = rb"""<xacro:insert_block\s+name\s*=\s*["'](\w+)"""
_TAG = rb"<xacro:([\w.]+)"

#: Bytes before the ``^`` of a forwarded parameter that are searched for its name.
_MAX_DISTANCE = 200


class Usage(Record):
    """The names that files use."""

    names: frozenset[str]  # all words in expressions, forwarded parameters and inserted blocks
    calls: frozenset[str]  # the last parts of all ``<xacro:...>`` tags; ``call`` for a dynamic call
    includes: frozenset[tuple[str, int]]  # locations of the include tags, as (path, offset)
    arguments: frozenset[str]  # names in ``$(arg name)`` and ``xacro.arg('name')``


def usage(sources: Iterable[Source]) -> Usage:
    """The names that xacro files use outside of comments."""
    names: set[bytes] = set()
    calls: set[bytes] = set()
    includes: set[tuple[str, int]] = set()
    arguments: set[bytes] = set()
    for source in sources:
        data = blank_comments(source.data)
        # Up to the last closing bracket: after it, each opening one would be searched to the end.
        expressions = re.findall(_EXPRESSION, data[: data.rfind(b"}") + 1])
        expressions += re.findall(_COMMAND, data[: data.rfind(b")") + 1])
        names.update(re.findall(_WORD, b" ".join(expressions)))
        arguments.update(re.findall(_ARGUMENT, b" ".join(expressions)))
        names.update(_forwarded(data))
        names.update(re.findall(_INSERTED, data))
        for tag in re.finditer(_TAG, data):
            calls.add(tag.group(1).rpartition(b".")[2])
            if tag.group(1) == b"include":
                includes.add((source.path, tag.start()))
    return Usage(
        frozenset(name.decode() for name in names),
        frozenset(call.decode() for call in calls),
        frozenset(includes),
        frozenset(name.decode(errors="replace") for name in arguments),
    )


def _forwarded(data: bytes) -> Iterator[bytes]:
    """The names in ``name:=^``, searched backwards from the sign, which is rarer than names."""
    sign = data.find(b"^")
    while sign >= 0:
        name = re.search(_NAME_BEFORE, data[max(0, sign - _MAX_DISTANCE) : sign])
        if name:
            yield name.group(1)
        sign = data.find(b"^", sign + 1)
