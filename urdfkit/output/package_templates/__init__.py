"""Templates of new ROS 2 packages for a robot, for Gazebo Harmonic.

A template is a file with the suffix ``.in``, in which ``@name@`` stands for the package name. The
files of ``common`` are in every package, the files of other directories in packages of that kind.
"""

import os
import re
from collections.abc import Iterator

from urdfkit.errors import UnwritableFile, UrdfkitError
from urdfkit.output.bundle.meshes import BundledFile
from urdfkit.output.bundle.writing import staged

KINDS = ("diff_drive", "arm")

_HOME = os.path.dirname(os.path.abspath(__file__))
#: https://ros.org/reps/rep-0144.html, as ROS 2 has it: no hyphens, for messages.
_NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")


def create(name: str, kind: str, directory: str) -> tuple[str, ...]:
    """Write a new package; after an error, nothing is written.

    Args:
        name: of the package and of its robot.
        kind: one of `KINDS`.
        directory: parent of the new package directory.

    Returns:
        The files, relative to the package, sorted.

    Raises:
        UrdfkitError: the name is not a valid ROS package name.
        UnwritableFile: the directory exists, or cannot be written.
    """
    files = sorted(_filled(name, kind))
    _require_name(name, files)
    out = os.path.join(os.path.abspath(directory), name)
    if os.path.lexists(out):
        raise UnwritableFile(f"{out}: exists; nothing is overwritten")
    with staged(files, out, force=False):
        return tuple(file.path for file in files)


def _filled(name: str, kind: str) -> Iterator[BundledFile]:
    for part in ("common", kind):
        home = os.path.join(_HOME, part)
        for at, _, files in os.walk(home):
            for file in files:
                source = os.path.join(at, file)
                path = os.path.relpath(source, home).removesuffix(".in").replace(os.sep, "/")
                with open(source, encoding="utf-8") as template:
                    text = template.read().replace("@name@", name)
                yield BundledFile(path.replace("@name@", name), text.encode(), "")


def _require_name(name: str, files: list[BundledFile]) -> None:
    """Reject invalid names, and names of packages that the new package depends on."""
    if len(name) < 2 or not _NAME.fullmatch(name):
        raise UrdfkitError(
            f"'{name}' is not a valid package name: two or more lowercase letters, digits and "
            "single underscores, with a letter first and no underscore last"
        )
    manifest = next(file.data for file in files if file.path == "package.xml")
    if f"depend>{name}<".encode() in manifest:
        raise UrdfkitError(f"'{name}' is a ROS package that the new one would depend on")
