"""Does a robot behave? Short simulations in MuJoCo, each with a verdict."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from urdfkit.core.installation import install_command
from urdfkit.errors import MissingLibrary
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read

if TYPE_CHECKING:
    from urdfkit.output.simulation.verdicts import Simulation


def simulate(robot: Context | str | os.PathLike[str], *, base: str = "auto") -> Simulation:
    """Simulate a robot: do links overlap, does it gain energy, can its joints hold it?

    Nothing is random, and nothing is written.

    Args:
        robot: a URDF or xacro file, or what `urdfkit.read` gives of one.
        base: as for `urdfkit.convert`.

    Raises:
        MissingLibrary: MuJoCo is not installed.
        UrdfkitError: the robot cannot be read, or MuJoCo rejects it.
    """
    try:
        from urdfkit.output.simulation.running import run
    except ModuleNotFoundError as error:
        raise MissingLibrary(
            f"to simulate a robot needs {error.name}: {install_command('simulate')}"
        ) from error
    return run(robot if isinstance(robot, Context) else read(robot), base)
