"""References of a robot to files, as they are written and what they lead to."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.core.record import Record

DRIVE = r"/?[A-Za-z]:/"


class ResolvedReference(Record):
    """What a reference leads to."""

    reference: str  # as written
    #: ``package``, ``model``, ``absolute`` (a path or ``file://``), ``relative``, or another one in
    #: small letters.
    scheme: str
    package: str | None = None  # name of the package that is referred to, or None
    directory: str | None = None  # of that package, or None if it is not found
    relative: str = ""  # the path below the package, or below the file that refers to it
    path: str | None = None  # the file, or None if there is none
    tried: tuple[str, ...] = ()  # the paths that were tried, in order
    searched: tuple[str, ...] = ()  # where the package was searched, if it is not found
    outside: str | None = None  # a file that the reference leads to and that the model may not read

    @property
    def attempts(self) -> str:
        """The paths that were tried, for a message; relative where below the current directory."""
        try:
            here = os.path.join(os.getcwd(), "")
        except OSError:  # the current directory is gone
            here = ""
        return ", ".join(path.removeprefix(here) for path in self.tried)


def split_scheme(text: str) -> tuple[str, str]:
    """The scheme before ``://``, in small letters, and the rest; without one, all is the rest.

    One letter is no scheme but a drive.
    """
    scheme, is_written, rest = text.partition("://")
    letters = scheme.replace("+", "").replace(".", "").replace("-", "")
    is_scheme = scheme.isascii() and scheme[:1].isalpha() and letters.isalnum()
    if is_written and is_scheme and len(scheme) > 1:
        return scheme.lower(), rest
    return "", text


def spellings(text: str) -> Iterator[str]:
    """The path as written, and with its percent escapes resolved."""
    yield text
    if "%" in text:
        data = text.encode("utf-8", "replace")
        data = re.sub(rb"%([0-9A-Fa-f]{2})", lambda m: bytes([int(m.group(1), 16)]), data)
        yield data.decode("utf-8", "replace")
