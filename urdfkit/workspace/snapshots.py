"""A description in a git revision, with the packages of its repository."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfkit.core.paths import is_within
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.revisions import MAX_BYTES, check_out


class Snapshot(Record):
    """A file of a git revision, in a checkout of the repository."""

    path: str  # of the file in the checkout
    packages: dict[str, str]  # directories by name; in the checkout if they are in the repository


def check_out_snapshot(
    path: str,
    revision: str,
    directory: str,
    packages: Mapping[str, str] | None = None,
    largest: int = MAX_BYTES,
) -> Snapshot:
    """Check out the repository of a file in a revision.

    Args:
        path: of the file in the working tree, where it may be deleted.
        revision: a tag, branch or commit.
        directory: an empty directory.
        packages: directories of ROS packages in the working tree.
        largest: larger files are omitted, in bytes.

    Raises:
        UrdfkitError: the revision does not exist, the file is not in it, or git is not installed.
    """
    real = os.path.realpath(path)
    top = check_out(real, revision, directory, largest)
    old = _moved(real, top, directory)
    if not os.path.exists(old):
        raise UrdfkitError(f"{path} is not in revision {revision}")
    return Snapshot(old, _packages(real, packages or {}, top, directory))


def _packages(path: str, explicit: Mapping[str, str], top: str, directory: str) -> dict[str, str]:
    """The packages that the file may need; in the checkout if they are in the repository."""
    known = Resolver().packages.known(path)
    outside = {name: at for name, at in known.items() if not _is_in(os.path.realpath(at), top)}
    old = {name: _moved(os.path.realpath(at), top, directory) for name, at in explicit.items()}
    return outside | {name: at for name, at in old.items() if os.path.isdir(at)}


def _moved(path: str, top: str, directory: str) -> str:
    """The path in the checkout, if it is in the repository."""
    return os.path.join(directory, os.path.relpath(path, top)) if _is_in(path, top) else path


def _is_in(path: str, top: str) -> bool:
    """True for a path in a repository, but not in another one below it, such as a submodule."""
    while is_within(path, top) and path != top and not os.path.lexists(os.path.join(path, ".git")):
        path = os.path.dirname(path)
    return path == top
