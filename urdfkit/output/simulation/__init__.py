"""Short simulations of a robot in MuJoCo, each with a verdict."""

import os

from urdfkit.core.installation import needing
from urdfkit.core.progress import Progress
from urdfkit.core.spatial import Transform
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.physics.verdicts import Simulation


def simulate(
    robot: Context | str | os.PathLike[str],
    *,
    base: str = "auto",
    srdf: str | os.PathLike[str] | None = None,
    progress: Progress | None = None,
) -> Simulation:
    """Test in simulation whether a robot is stable, moves, holds its pose and lands.

    The simulations are deterministic, and nothing is written.

    Args:
        robot: a URDF or xacro file, or the result of `urdfkit.read`.
        base: as for `urdfkit.convert`.
        srdf: an SRDF file, whose disabled pairs of links do not collide; by default the SRDF of the
            robot's package.
        progress: called with the number of finished tests and of all tests.

    Raises:
        MissingLibrary: MuJoCo is not installed.
        UrdfkitError: the robot cannot be read, or MuJoCo rejects it.
    """
    with needing("simulation", "simulate", mujoco=4):
        from urdfkit.output.simulation.running import run
    context = robot if isinstance(robot, Context) else read(robot)
    return run(context, base, os.fspath(srdf) if srdf else None, progress)


def motion(
    robot: Context, *, base: str, images: int, srdf: str | None = None
) -> list[dict[str, Transform]]:
    """Link poses in the world while a robot is released, at the times of ``images`` images.

    There are fewer if the simulation diverges. The errors are those of `simulate`.
    """
    with needing("simulation", "simulate", mujoco=4):
        from urdfkit.output.simulation.release import moments
        from urdfkit.output.simulation.simulated_robot import SimulatedRobot
    return list(moments(SimulatedRobot(robot, base, srdf), images))
