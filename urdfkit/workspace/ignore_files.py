"""The files by which git decides what it ignores. They are git's to read; here they are noted."""

import os
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.paths import upwards


def note(path: str) -> None:
    """Note that a result depends on whether git ignores a file."""
    for file in _deciding(os.path.abspath(path)):
        try:
            text = disk.read(file).lower()
        except OSError:
            continue
        if file.endswith("config") and (b"excludesfile" in text or b"[include" in text):
            disk.depends_on_more()  # they name further files


def _deciding(path: str) -> Iterator[str]:
    """https://git-scm.com/docs/gitignore; what is in the index is never ignored."""
    for directory in upwards(os.path.dirname(path)):
        yield os.path.join(directory, ".gitignore")
        git = os.path.join(directory, ".git")
        if disk.exists(git):
            break
    else:
        return
    if disk.is_file(git):  # of a submodule or a linked working tree
        git = _named(git, directory)
    common = _named(os.path.join(git, "commondir"), git) or git
    yield from (os.path.join(git, "index"), os.path.join(git, "config.worktree"))
    yield from (os.path.join(common, "config"), os.path.join(common, "info", "exclude"))
    variables = disk.Environment()
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
