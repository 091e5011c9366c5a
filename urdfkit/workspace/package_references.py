"""Packages that the text of a description mentions: ``$(find pkg)`` and ``package://pkg``.

The text names more than the expansion: what a macro that is not called here refers to is needed by
those who call it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.text.source import Source, Span
from urdfkit.workspace.packages import Packages

#: The substitution of xacro and of launch files, and the package in it.
FIND = r"\$\(find\s+([A-Za-z][\w.-]*)\s*\)"
_MENTION = rf"""(?sx)<!--.*?(?:-->|\Z)
      | {FIND}(/[^\s"'<>]*)?
      | package://([A-Za-z][\w.-]*)(/[^\s"'<>]*)?
    """.encode()


class PackageReference(Record):
    """A package at one place in a text."""

    package: str  # its name
    #: The path behind it, as far as it is written plainly; a directory if it goes on with an
    #: expression.
    relative: str
    span: Span  # the whole reference


def are_in(sources: Iterable[Source]) -> bool:
    """True if texts mention packages."""
    return any(b"package://" in source.data or b"$(find" in source.data for source in sources)


def mentions(source: Source) -> Iterator[PackageReference]:
    """The packages in a text, in its order, outside of comments."""
    if not are_in((source,)):
        return
    for match in re.finditer(_MENTION, source.data):
        found = match.group(1) or match.group(3)
        if found:
            path = (match.group(2) or match.group(4) or b"").decode("utf-8", "replace")
            yield PackageReference(found.decode(), _plain(path), Span(source, *match.span()))


def of_package(sources: tuple[Source, ...], packages: Packages) -> Iterator[PackageReference]:
    """What the sources mention that lie in the package of the first."""
    home = packages.enclosing(sources[0].path)
    for source in sources:
        if home and packages.enclosing(source.path) == home:
            yield from mentions(source)


def _plain(path: str) -> str:
    plain, expression, _ = path.lstrip("/").partition("$")
    return os.path.dirname(plain) if expression else plain.rstrip("/")
