"""The files by which git decides what it ignores. They are git's to read; here they are noted."""

import os
from collections.abc import Iterator, Mapping

from urdfkit.core import disk
from urdfkit.core.paths import is_within, upwards

#: Variables that decide which git runs, and where it looks for a repository.
_OF_GIT = ("PATH", "GIT_CEILING_DIRECTORIES", "GIT_DISCOVERY_ACROSS_FILESYSTEM")
#: Variables with settings, which may name further files.
_SETTINGS = ("GIT_CONFIG_COUNT", "GIT_CONFIG_PARAMETERS")


def note(path: str) -> bool:
    """Note that a result depends on whether git ignores a file; False outside of repositories."""
    directories = upwards(disk.real(os.path.dirname(path)))
    inside = (at for at in directories if disk.exists(os.path.join(at, ".git")))
    top = next(inside, None)
    if top is None:
        return False
    variables = disk.Environment()
    for name in _OF_GIT:
        variables.get(name)  # notes its value
    if any(variables.get(name) for name in _SETTINGS):
        disk.depends_on_more()
    lists = (os.path.join(at, ".gitignore") for at in directories if is_within(at, top))
    for file in (*lists, *_of_repository(top), *_of_user(variables)):
        try:
            text = disk.read(file).lower()
        except OSError:
            continue
        if file.endswith("config") and (b"excludesfile" in text or b"[include" in text):
            disk.depends_on_more()  # they name further files
    return True


def _of_repository(top: str) -> Iterator[str]:
    """https://git-scm.com/docs/gitignore; what is in the index is never ignored."""
    git = os.path.join(top, ".git")
    if disk.is_file(git):  # of a submodule or a linked working tree
        git = _named(git, top)
    common = _named(os.path.join(git, "commondir"), git) or git
    yield from (os.path.join(git, "index"), os.path.join(git, "config.worktree"))
    yield from (os.path.join(common, "config"), os.path.join(common, "info", "exclude"))


def _of_user(variables: Mapping[str, str]) -> Iterator[str]:
    home = os.path.expanduser("~")
    settings = variables.get("XDG_CONFIG_HOME") or os.path.join(home, ".config")
    yield from (os.path.join(settings, "git", name) for name in ("config", "ignore"))
    yield variables.get("GIT_CONFIG_GLOBAL") or os.path.join(home, ".gitconfig")
    yield variables.get("GIT_CONFIG_SYSTEM") or "/etc/gitconfig"


def _named(file: str, directory: str) -> str:
    """The directory that a file of git names; empty if there is no such file."""
    try:
        text = disk.read(file, 4096)
    except OSError:
        return ""
    return os.path.normpath(
        os.path.join(directory, os.fsdecode(text).removeprefix("gitdir:").strip())
    )
