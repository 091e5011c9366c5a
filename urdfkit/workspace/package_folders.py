"""Folders as packages: which package a folder is, and whether it is a repository."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.text.comments import without_comments
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.folders import Folders

_NOT_SOURCES = frozenset("build devel install log node_modules __pycache__ site-packages".split())


class PackageFolders:
    """The names of packages by folder; everything is read once.

    Attributes:
        listings: what is in folders.
    """

    def __init__(self, listings: Folders) -> None:
        self.listings = listings
        self._names: dict[str, str | None] = {}

    def name_of(self, folder: str) -> str | None:
        """The name of the package whose folder this is; None if it is no package's."""
        if folder not in self._names:
            self._names[folder] = _package_name(folder)
        return self._names[folder]

    def is_repository(self, folder: str) -> bool:
        """True of the top of a repository, unless it is a submodule of another one."""
        mark = os.path.join(folder, ".git")
        # Not by its listing: those of the folders above change all the time.
        return disk.has_name(mark) and b"/modules/" not in read_head(mark, 4096)

    def names_in(self, folder: str) -> Mapping[str, bool]:
        """What is in a folder, each with whether it is a folder; nothing if it cannot be read."""
        return self.listings.entries(folder) or {}


def is_searched(name: str) -> bool:
    """False of hidden folders, and of those that a build makes."""
    return name[0] != "." and name not in _NOT_SOURCES


def is_within(path: str, folder: str) -> bool:
    return os.path.join(path, "").startswith(os.path.join(folder, ""))


def _package_name(folder: str) -> str | None:
    data = read_marker(folder, "package.xml")
    if data:
        name = data.partition(b"<name>")[2].partition(b"</name>")[0].strip()
        is_one = b"<" not in name and len(name.split()) == 1
        return name.decode("utf-8", "replace") if is_one else None
    # rosbuild: the name is that of the folder.
    if b"<package" in read_marker(folder, "manifest.xml"):
        return os.path.basename(folder)
    return None


def read_marker(folder: str, name: str) -> bytes:
    """A package.xml or manifest.xml without its comments; empty if there is none."""
    return without_comments(read_head(os.path.join(folder, name), 65_536))


@lru_cache(maxsize=1024)
def upwards(folder: str) -> tuple[str, ...]:
    """A folder and those above it, the innermost first."""
    above = os.path.dirname(folder)
    return (folder,) if above == folder else (folder, *upwards(above))
