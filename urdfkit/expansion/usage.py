"""Which names the expressions of xacro files mention, whether or not they were evaluated."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfkit.record import Record
from urdfkit.source import Source

_COMMENT = re.compile(rb"<!--.*?-->", re.DOTALL)
_EXPRESSION = re.compile(rb"\$\{([^}]*)\}")
_COMMAND = re.compile(rb"\$\(([^)]*)\)")
_WORD = re.compile(rb"[A-Za-z_]\w*")
_FORWARDED = re.compile(rb"=\s*\^")
_NAME_BEFORE = re.compile(rb"(\w+)\s*:?\Z")
_INSERTED = re.compile(rb"""<xacro:insert_block\s+name\s*=\s*["'](\w+)""")
_CALL = re.compile(rb"<xacro:([\w.]+)")
_INCLUDE = re.compile(rb"<xacro:include\b")


#: Bytes before a forwarding that are searched for its name.
_NEAR = 200


class Usage(Record):
    """What the files mention.

    Attributes:
        names: every word in an expression, forwarded parameters and inserted blocks.
        calls: the last parts of all ``<xacro:...>`` tags; ``call`` for a dynamic call.
        includes: places of the include tags, as (path, offset).
    """

    names: frozenset[str]
    calls: frozenset[str]
    includes: frozenset[tuple[str, int]]


def usage(sources: Iterable[Source]) -> Usage:
    """What some xacro files mention outside comments."""
    names: set[bytes] = set()
    calls: set[bytes] = set()
    includes: set[tuple[str, int]] = set()
    for source in sources:
        data = _COMMENT.sub(lambda match: b" " * len(match.group()), source.data)
        # Not behind the last bracket: there every opening one is searched for to the end.
        expressions = _EXPRESSION.findall(data, 0, data.rfind(b"}") + 1)
        expressions += _COMMAND.findall(data, 0, data.rfind(b")") + 1)
        for expression in expressions:
            names.update(_WORD.findall(expression))
        names.update(_forwarded(data))
        names.update(_INSERTED.findall(data))
        calls.update(tag.rpartition(b".")[2] for tag in _CALL.findall(data))
        includes.update((source.path, match.start()) for match in _INCLUDE.finditer(data))
    return Usage(
        frozenset(name.decode() for name in names),
        frozenset(call.decode() for call in calls),
        frozenset(includes),
    )


def _forwarded(data: bytes) -> Iterator[bytes]:
    """The names in ``name:=^``; from the sign backwards, for words are everywhere."""
    for sign in _FORWARDED.finditer(data):
        name = _NAME_BEFORE.search(data, max(0, sign.start() - _NEAR), sign.start())
        if name:
            yield name.group(1)
