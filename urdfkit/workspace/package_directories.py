"""Names of packages by directory, and detection of repositories."""

import os
import re
from collections.abc import Callable, Mapping
from functools import cache, lru_cache

from urdfkit.core import disk
from urdfkit.text.comments import without_comments
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.file_head import read_head

#: Files that exclude a directory from a build.
IGNORE_FILES = ("COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE")

_DEPENDENCY = rb"<(\w*depend)\b[^<>]*>\s*([\w.-]+)\s*</\1>"


class PackageDirectories:
    """The names of packages by directory, cached."""

    def __init__(self, listings: Directories) -> None:
        self.listings = listings
        #: Name of the package in a directory; None if it is not a package.
        self.name_of: Callable[[str], str | None] = cache(package_name)

    def is_repository(self, directory: str) -> bool:
        """True for the top directory of a repository that is not a submodule."""
        path = os.path.join(directory, ".git")
        # Directories above a repository are not listed: their contents change all the time.
        return disk.has_name(path) and b"/modules/" not in read_head(path, 4096)

    def names_in(self, directory: str) -> Mapping[str, bool]:
        """Names in a directory, with True for directories; empty if it cannot be read."""
        return self.listings.entries(directory) or {}


def package_name(directory: str) -> str | None:
    data = read_marker(directory, "package.xml")
    if data:
        name = data.partition(b"<name>")[2].partition(b"</name>")[0].strip()
        is_valid = b"<" not in name and len(name.split()) == 1
        return name.decode("utf-8", "replace") if is_valid else None
    # rosbuild: the name of the package is the name of its directory.
    if b"<package" in read_marker(directory, "manifest.xml"):
        return os.path.basename(directory)
    return None


def read_marker(directory: str, name: str) -> bytes:
    """A package.xml or manifest.xml without its comments; empty if there is none."""
    return without_comments(read_head(os.path.join(directory, name), 65_536))


@lru_cache(maxsize=8)  # a robot may refer to a thousand missing packages
def dependencies(data: bytes) -> frozenset[str]:
    """Names of the packages in the dependencies of all kinds in a package.xml without comments."""
    return frozenset(name.decode() for _, name in re.findall(_DEPENDENCY, data))
