"""References to packages in the text of a description: ``$(find pkg)`` and ``package://pkg``.

The text contains more references than the expansion: those in an uncalled macro are needed by the
files that call it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.text.source import Source, Span
from urdfkit.workspace.packages import Packages

#: The substitution ``$(find pkg)`` of xacro and launch files; the group is the package.
FIND = r"\$\(find\s+([A-Za-z][\w.-]*)\s*\)"
_REFERENCE = rf"""(?sx)<!--.*?(?:-->|\Z)
      | {FIND}(/[^\s"'<>]*)?
      | package://([A-Za-z][\w.-]*)(/[^\s"'<>]*)?
    """.encode()


class PackageReference(Record):
    """A reference to a package in a text."""

    package: str  # name of the package
    relative: str  # the path after it, up to the directory before an expression
    span: Span  # the whole reference


def have_references(sources: Iterable[Source]) -> bool:
    """True if texts refer to packages."""
    return any(b"package://" in source.data or b"$(find" in source.data for source in sources)


def package_references(source: Source) -> Iterator[PackageReference]:
    """The references in a text, in order, outside of comments."""
    if not have_references((source,)):
        return
    for match in re.finditer(_REFERENCE, source.data):
        package = match.group(1) or match.group(3)
        if package:
            path = (match.group(2) or match.group(4) or b"").decode("utf-8", "replace")
            yield PackageReference(package.decode(), _plain(path), Span(source, *match.span()))


def references_of_package(
    sources: tuple[Source, ...], packages: Packages
) -> Iterator[PackageReference]:
    """The references in those sources that are in the package of the first source."""
    package = packages.enclosing(sources[0].path)
    for source in sources:
        if package and packages.enclosing(source.path) == package:
            yield from package_references(source)


def _plain(path: str) -> str:
    plain, expression, _ = path.lstrip("/").partition("$")
    return os.path.dirname(plain) if expression else plain.rstrip("/")
