"""Files that git ignores."""

import os
from collections.abc import Callable, Iterator, Mapping
from fnmatch import fnmatchcase
from functools import cache

from urdfkit.core import disk
from urdfkit.core.paths import is_within, upwards
from urdfkit.workspace.file_head import head_text

#: Variables that decide which git runs, and where it searches for a repository.
_OF_GIT = ("PATH", "GIT_CEILING_DIRECTORIES", "GIT_DISCOVERY_ACROSS_FILESYSTEM")
#: Variables with settings, which may refer to further files.
_SETTINGS = ("GIT_CONFIG_COUNT", "GIT_CONFIG_PARAMETERS")


class GitIgnored:
    """The files that git ignores; supports ``path in ignored``.

    Starting git takes time, so git is run only for a file that a pattern in some .gitignore or in
    the repository's own list may match.
    """

    def __init__(self) -> None:
        self._words_above: Callable[[str], set[str] | None] = cache(self._read_words)

    def __contains__(self, path: object) -> bool:
        if not isinstance(path, str):
            return False
        words = self._words_above(os.path.dirname(disk.real(path)))
        return words is not None and _may_match(words, path) and is_ignored(path)

    def _read_words(self, directory: str) -> set[str] | None:
        """The words of the .gitignore files from a directory up to its repository.

        None outside of repositories.
        """
        parent = os.path.dirname(directory)
        if disk.exists(os.path.join(directory, ".git")):
            words: set[str] | None = _words(os.path.join(directory, ".git", "info", "exclude"))
        else:
            words = None if parent == directory else self._words_above(parent)
        return None if words is None else words | _words(os.path.join(directory, ".gitignore"))


def is_ignored(path: str) -> bool:
    """True if git ignores a file; False outside of repositories or without git."""
    if not _log_ignore_files(path):
        return False
    from urdfkit.workspace.revisions import check_ignore  # imports subprocess

    return check_ignore(path)


def _may_match(words: set[str], path: str) -> bool:
    """True if a pattern may match a path: its last word is, or matches, a part of the path."""
    parts = {part.lower() for part in path.replace(os.sep, "/").split("/")}
    return any(_may_match_part(word, parts) for word in words)


def _may_match_part(word: str, parts: set[str]) -> bool:
    if "\\" in word:
        return True
    if word.startswith("*") and _is_literal(word[1:]):
        return any(part.endswith(word[1:]) for part in parts)
    return word in parts if _is_literal(word) else any(fnmatchcase(part, word) for part in parts)


def _is_literal(word: str) -> bool:
    return "*" not in word and "?" not in word and "[" not in word


def _words(file: str) -> set[str]:
    """The last words of the patterns in a list of ignored files, such as ``*.obj``."""
    text = head_text(file)
    lines = map(str.strip, text.split("\n"))
    patterns = [line.rstrip("/") for line in lines if line and not line.startswith(("#", "!"))]
    return {pattern.rpartition("/")[2].lower() for pattern in patterns}


def _log_ignore_files(path: str) -> bool:
    """Log the files that git reads for a decision, on which the result depends.

    Returns:
        False outside of repositories.
    """
    directories = upwards(disk.real(os.path.dirname(path)))
    repositories = (at for at in directories if disk.exists(os.path.join(at, ".git")))
    top = next(repositories, None)
    if top is None:
        return False
    variables = disk.Environment()
    for name in _OF_GIT:
        variables.get(name)  # logs its value
    if any(variables.get(name) for name in _SETTINGS):
        disk.depends_on_more()
    lists = (os.path.join(at, ".gitignore") for at in directories if is_within(at, top))
    for file in (*lists, *_files_of_repository(top), *_files_of_user(variables)):
        text = (disk.contents(file) or b"").lower()
        if file.endswith("config") and (b"excludesfile" in text or b"[include" in text):
            disk.depends_on_more()  # the configuration refers to further files
    return True


def _files_of_repository(top: str) -> Iterator[str]:
    """The files of https://git-scm.com/docs/gitignore, and the index: its files are not ignored."""
    git = os.path.join(top, ".git")
    if disk.is_file(git):  # of a submodule or a linked working tree
        git = _referenced_directory(git, top)
    common = _referenced_directory(os.path.join(git, "commondir"), git) or git
    yield from (os.path.join(git, "index"), os.path.join(git, "config.worktree"))
    yield from (os.path.join(common, "config"), os.path.join(common, "info", "exclude"))


def _files_of_user(variables: Mapping[str, str]) -> Iterator[str]:
    home = os.path.expanduser("~")
    settings = variables.get("XDG_CONFIG_HOME") or os.path.join(home, ".config")
    yield from (os.path.join(settings, "git", name) for name in ("config", "ignore"))
    yield variables.get("GIT_CONFIG_GLOBAL") or os.path.join(home, ".gitconfig")
    yield variables.get("GIT_CONFIG_SYSTEM") or "/etc/gitconfig"


def _referenced_directory(file: str, directory: str) -> str:
    """The directory that a file of git refers to; empty if the file does not exist."""
    text = disk.contents(file, 4096)
    if text is None:
        return ""
    return os.path.normpath(
        os.path.join(directory, os.fsdecode(text).removeprefix("gitdir:").strip())
    )
