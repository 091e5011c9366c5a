"""Files that lie beside a robot and belong to it, found by where they are."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.workspace.resolve import Resolver

_SRDF = (".srdf", ".srdf.xacro")
_SETUP = (  # compiled when needed, which is seldom
    r"URDF:\s*\n\s*package:\s*\"?([\w-]+)\"?\s*\n\s*relative_path:\s*\"?([^\s\"]+)"
)


def srdf_files(robot: str, resolver: Resolver) -> list[str]:
    """The SRDF files that may be a robot's.

    They are looked for in the robot's folder, in ``config`` and ``srdf`` of its package, and in
    MoveIt packages beside it whose ``.setup_assistant`` names the robot's file.
    """
    folder = os.path.dirname(os.path.abspath(robot))
    package = resolver.packages.enclosing(robot)
    top = package[1] if package else folder
    folders = dict.fromkeys((folder, *(os.path.join(top, name) for name in ("config", "srdf"))))
    if package is not None:
        folders.update(dict.fromkeys(_moveit_folders(package, robot, resolver)))
    return [
        os.path.join(place, name)
        for place in folders
        for name in sorted(resolver.folders.entries(place) or ())
        if name.endswith(_SRDF)
    ]


def _moveit_folders(package: tuple[str, str], robot: str, resolver: Resolver) -> Iterator[str]:
    around = os.path.dirname(package[1])
    for name in resolver.folders.entries(around) or ():
        folder = os.path.join(around, name)
        if name.endswith("moveit_config") and _is_set_up_for(folder, package, robot):
            yield os.path.join(folder, "config")


def _is_set_up_for(folder: str, package: tuple[str, str], robot: str) -> bool:
    """True if a MoveIt package says that it was made for a robot's file."""
    try:
        with open(os.path.join(folder, ".setup_assistant"), encoding="utf-8") as file:
            setup = re.search(_SETUP, file.read(100_000))
    except (OSError, UnicodeDecodeError):
        return False
    if setup is None or setup.group(1) != package[0]:
        return False
    return os.path.normpath(os.path.join(package[1], setup.group(2))) == os.path.abspath(robot)
