"""References of a robot to files, as they are written and what they lead to."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.core.record import Record

DRIVE = r"/?[A-Za-z]:/"


class ResolvedReference(Record):
    """What a reference leads to.

    Attributes:
        reference: as written.
        scheme: ``package``, ``model``, ``absolute`` (a path or ``file://``), ``relative``, or
            another one in small letters.
        package: name of the package that is referred to, or None.
        directory: of that package, or None if it is not found.
        relative: the path below the package, or below the file that refers to it.
        path: the file, or None if there is none.
        tried: the paths that were tried, in order.
        outside: a file that the reference leads to and that the model may not read.
        searched: where the package was searched, if it is not found.
    """

    reference: str
    scheme: str
    package: str | None = None
    directory: str | None = None
    relative: str = ""
    path: str | None = None
    tried: tuple[str, ...] = ()
    searched: tuple[str, ...] = ()
    outside: str | None = None

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
