"""A description as it was in a git revision, with the packages around it as they were."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfkit.core.paths import is_within
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.revisions import MAX_BYTES, check_out


class OldFile(Record):
    """A file of a git revision in a directory of its own."""

    path: str  # of the file there
    top: str  # of the repository that it is from
    #: Directories by name: of the repository as they were, else as they are.
    packages: dict[str, str]


def as_it_was(
    path: str,
    revision: str,
    directory: str,
    packages: Mapping[str, str] | None = None,
    largest: int = MAX_BYTES,
) -> OldFile:
    """Put a file as it was, and everything around it, into a directory.

    Args:
        path: of the file in the working tree, where it need not be any more.
        revision: a tag, branch or commit.
        directory: an empty one.
        packages: directories of ROS packages, as they are now.
        largest: files over so many bytes are left out.

    Raises:
        UrdfkitError: there is no such revision, the file is not in it, or git is not there.
    """
    real = os.path.realpath(path)
    top = check_out(real, revision, directory, largest)
    old = _moved(real, top, directory)
    if not os.path.exists(old):
        raise UrdfkitError(f"{path} is not in revision {revision}")
    return OldFile(old, top, _packages(real, packages or {}, top, directory))


def _packages(path: str, given: Mapping[str, str], top: str, directory: str) -> dict[str, str]:
    """The packages that the file may need: of the repository as they were, else as they are."""
    around = Resolver().packages.known(path)
    outside = {name: at for name, at in around.items() if not is_within(os.path.realpath(at), top)}
    old = {name: _moved(os.path.realpath(at), top, directory) for name, at in given.items()}
    return outside | {name: at for name, at in old.items() if os.path.isdir(at)}


def _moved(path: str, top: str, directory: str) -> str:
    """A path of the repository in the directory that holds its old files; others stay."""
    return os.path.join(directory, os.path.relpath(path, top)) if is_within(path, top) else path
