"""References of a robot to files: their parts, and the files that they resolve to."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.core.record import Record

DRIVE = r"/?[A-Za-z]:/"


class ResolvedReference(Record):
    """The result of resolving a reference."""

    reference: str  # as written
    #: ``package``, ``model``, ``absolute`` (a path or ``file://``), ``relative``, or another scheme
    #: in lower case.
    scheme: str
    package: str | None = None  # name of the package, if any
    directory: str | None = None  # of the package, or None if it is not found
    relative: str = ""  # the path below the package, or below the referring file
    path: str | None = None  # the file, or None if it is not found
    tried: tuple[str, ...] = ()  # the paths that were tried, in order
    searched: tuple[str, ...] = ()  # where the package was searched, if it is not found
    outside: str | None = None  # an existing file that the model may not read

    @property
    def tried_paths(self) -> str:
        """The tried paths, for a message; relative if below the current directory."""
        try:
            current = os.path.join(os.getcwd(), "")
        except OSError:  # the current directory is deleted
            current = ""
        return ", ".join(path.removeprefix(current) for path in self.tried)


def split_scheme(text: str) -> tuple[str, str]:
    """The scheme before ``://``, in lower case, and the rest; an empty scheme if there is none.

    A single letter is a drive, not a scheme.
    """
    scheme, is_written, rest = text.partition("://")
    letters = scheme.replace("+", "").replace(".", "").replace("-", "")
    is_scheme = scheme.isascii() and scheme[:1].isalpha() and letters.isalnum()
    if is_written and is_scheme and len(scheme) > 1:
        return scheme.lower(), rest
    return "", text


def spellings(text: str) -> Iterator[str]:
    """The path as written, and with its percent escapes decoded."""
    yield text
    if "%" in text:
        data = text.encode("utf-8", "replace")
        data = re.sub(rb"%([0-9A-Fa-f]{2})", lambda m: bytes([int(m.group(1), 16)]), data)
        yield data.decode("utf-8", "replace")
