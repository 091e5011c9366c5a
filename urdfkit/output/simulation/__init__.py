"""Does a robot behave? Short simulations in MuJoCo, each with a verdict."""

from __future__ import annotations

import os
from types import ModuleType
from typing import TYPE_CHECKING

from urdfkit.core.installation import needing
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.core.spatial import Transform
    from urdfkit.output.simulation.verdicts import Simulation


def simulate(
    robot: Context | str | os.PathLike[str], *, base: str = "auto", progress: Progress | None = None
) -> Simulation:
    """Simulate a robot: does it stay whole, move, hold itself and land?

    Nothing is random, and nothing is written.

    Args:
        robot: a URDF or xacro file, or what `urdfkit.read` gives of one.
        base: as for `urdfkit.convert`.
        progress: counts the tests that are done.

    Raises:
        MissingLibrary: MuJoCo is not installed.
        UrdfkitError: the robot cannot be read, or MuJoCo rejects it.
    """
    running = _running()
    found: Simulation = running.run(
        robot if isinstance(robot, Context) else read(robot), base, progress
    )
    return found


def motion(robot: Context, *, base: str, images: int) -> list[dict[str, Transform]]:
    """Where the links of a robot are in the world while it is released, for so many images.

    There are fewer where the simulation diverges. The errors are those of `simulate`.
    """
    return list(_running().motion(robot, base, images))


def _running() -> ModuleType:
    with needing("to simulate a robot", "simulate"):
        from urdfkit.output.simulation import running
    return running
