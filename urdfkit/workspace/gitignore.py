"""Which files git leaves out of a repository."""

from __future__ import annotations

import os

from urdfkit.core import disk
from urdfkit.workspace.file_head import read_head

#: Longer files are none that people write.
MAX_BYTES = 1024 * 1024


class Ignored:
    """The files that git ignores, asked for by path with ``in``.

    Starting git costs more than checking a robot, so it is asked only about a file that a line of
    some .gitignore seems to be about.
    """

    def __init__(self) -> None:
        self._words: dict[str, set[str] | None] = {}

    def __contains__(self, path: object) -> bool:
        if not isinstance(path, str):
            return False
        words = self._above(os.path.dirname(disk.real(path)))
        if not words or not _may_mean(words, path):
            return False
        from urdfkit.workspace.revisions import is_ignored

        return is_ignored(path)

    def _above(self, folder: str) -> set[str] | None:
        """The words of the .gitignore files of a folder and those above it in its repository.

        None outside of repositories.
        """
        if folder not in self._words:
            above = os.path.dirname(folder)
            if disk.exists(os.path.join(folder, ".git")):
                words: set[str] | None = set()
            else:
                words = None if above == folder else self._above(above)
            self._words[folder] = None if words is None else words | _words(folder)
        return self._words[folder]


def _may_mean(words: set[str], path: str) -> bool:
    """True if a pattern may hit a path: it is a part of it, or its suffix, or says anything."""
    parts = {part.lower() for part in path.replace(os.sep, "/").split("/")}
    suffix = os.path.splitext(path)[1].lower()
    return any(word in parts or "*" in word.strip("*") or word.endswith(suffix) for word in words)


def _words(folder: str) -> set[str]:
    """The last words of the patterns in a folder's .gitignore, such as ``*.obj``."""
    text = read_head(os.path.join(folder, ".gitignore"), MAX_BYTES).decode("utf-8", "replace")
    lines = map(str.strip, text.split("\n"))
    patterns = [line.rstrip("/") for line in lines if line and not line.startswith(("#", "!"))]
    return {pattern.rpartition("/")[2].lower() for pattern in patterns}
