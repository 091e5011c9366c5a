"""Which files git leaves out of a repository."""

import os
from fnmatch import fnmatchcase

from urdfkit.core import disk
from urdfkit.workspace.file_head import read_head

#: Longer files are none that people write.
MAX_BYTES = 1024 * 1024


class GitIgnored:
    """The files that git ignores, asked for by path with ``in``.

    Starting git takes time, so it is asked only about a file that a line of some .gitignore or of
    the repository's own list seems to be about.
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

    def _above(self, directory: str) -> set[str] | None:
        """The words of the .gitignore files of a directory and those above it in its repository.

        None outside of repositories.
        """
        if directory not in self._words:
            above = os.path.dirname(directory)
            if disk.exists(os.path.join(directory, ".git")):
                words: set[str] | None = _words(os.path.join(directory, ".git", "info", "exclude"))
            else:
                words = None if above == directory else self._above(above)
            self._words[directory] = words
            if words is not None:
                self._words[directory] = words | _words(os.path.join(directory, ".gitignore"))
        return self._words[directory]


def _may_mean(words: set[str], path: str) -> bool:
    """True if a pattern may hit a path: its last word is, or matches, a part of it."""
    parts = {part.lower() for part in path.replace(os.sep, "/").split("/")}
    return any(_may_match(word, parts) for word in words)


def _may_match(word: str, parts: set[str]) -> bool:
    if "\\" in word:
        return True
    if word.startswith("*") and _is_literal(word[1:]):
        return any(part.endswith(word[1:]) for part in parts)
    return word in parts if _is_literal(word) else any(fnmatchcase(part, word) for part in parts)


def _is_literal(word: str) -> bool:
    return "*" not in word and "?" not in word and "[" not in word


def _words(file: str) -> set[str]:
    """The last words of the patterns in a list of ignored files, such as ``*.obj``."""
    text = read_head(file, MAX_BYTES).decode("utf-8", "replace")
    lines = map(str.strip, text.split("\n"))
    patterns = [line.rstrip("/") for line in lines if line and not line.startswith(("#", "!"))]
    return {pattern.rpartition("/")[2].lower() for pattern in patterns}
