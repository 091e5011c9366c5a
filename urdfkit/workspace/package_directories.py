"""Directories as packages: which package a directory is, and whether it is a repository."""

import os
from collections.abc import Mapping

from urdfkit.core import disk
from urdfkit.text.comments import without_comments
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.file_head import read_head


class PackageDirectories:
    """The names of packages by directory; everything is read once."""

    def __init__(self, listings: Directories) -> None:
        self.listings = listings  # what is in directories
        self._names: dict[str, str | None] = {}

    def name_of(self, directory: str) -> str | None:
        """The name of the package whose directory this is; None if it is no package's."""
        if directory not in self._names:
            self._names[directory] = _package_name(directory)
        return self._names[directory]

    def is_repository(self, directory: str) -> bool:
        """True of the top of a repository, unless it is a submodule of another one."""
        mark = os.path.join(directory, ".git")
        # Not by its listing: those of the directories above change all the time.
        return disk.has_name(mark) and b"/modules/" not in read_head(mark, 4096)

    def names_in(self, directory: str) -> Mapping[str, bool]:
        """Names in a directory, True for directories; empty if it cannot be read."""
        return self.listings.entries(directory) or {}


def _package_name(directory: str) -> str | None:
    data = read_marker(directory, "package.xml")
    if data:
        name = data.partition(b"<name>")[2].partition(b"</name>")[0].strip()
        is_one = b"<" not in name and len(name.split()) == 1
        return name.decode("utf-8", "replace") if is_one else None
    # rosbuild: the name is that of the directory.
    if b"<package" in read_marker(directory, "manifest.xml"):
        return os.path.basename(directory)
    return None


def read_marker(directory: str, name: str) -> bytes:
    """A package.xml or manifest.xml without its comments; empty if there is none."""
    return without_comments(read_head(os.path.join(directory, name), 65_536))
