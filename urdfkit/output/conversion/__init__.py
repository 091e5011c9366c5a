"""A robot in another format, with what is lost on the way, and a proof by two engines."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from urdfkit.core.installation import install_command
from urdfkit.errors import MissingLibrary
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read

if TYPE_CHECKING:
    from urdfkit.output.conversion.writing import Conversion

#: What becomes of the root link.
BASES = ("auto", "fixed", "free")


def convert(
    robot: Context | str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    base: str = "auto",
    force: bool = False,
) -> Conversion:
    """Write a robot as MJCF with its meshes, and compare what MuJoCo loads with the robot.

    Args:
        robot: a URDF or xacro file, or what `urdfkit.read` gives of one.
        out: a directory; whole or not at all.
        base: ``fixed`` welds the root to the world, ``free`` lets it float; ``auto`` lets a robot
            float that stands on more than its root.
        force: replace what is there, if it is a conversion.

    Raises:
        MissingLibrary: MuJoCo or Pinocchio is not installed.
        UrdfkitError: the robot cannot be converted, or MuJoCo rejects it; a file is missing,
            broken, or cannot be written.
    """
    try:
        from urdfkit.output.conversion.writing import write
    except ModuleNotFoundError as error:
        raise MissingLibrary(
            f"to convert a robot needs {error.name}: {install_command('simulate')}"
        ) from error
    context = robot if isinstance(robot, Context) else read(robot)
    return write(context, os.path.abspath(out), base=base, force=force)
