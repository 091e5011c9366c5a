"""Runs all simulations of a robot."""

import mujoco

from urdfkit.core.progress import Progress
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.simulation.drive import drive
from urdfkit.output.simulation.drop import drop
from urdfkit.output.simulation.hold import hold
from urdfkit.output.simulation.overlap import overlap
from urdfkit.output.simulation.release import release
from urdfkit.output.simulation.simulated_robot import SimulatedRobot
from urdfkit.output.simulation.size import size
from urdfkit.output.simulation.sweep import follow, sweep
from urdfkit.output.simulation.timestep import timestep
from urdfkit.physics.verdicts import Simulation, Verdict

_ALL = (size, overlap, release, timestep, drive, sweep, follow)


def run(robot: Context, base: str, srdf: str | None, progress: Progress | None) -> Simulation:
    """Run all simulations; the arguments are those of `urdfkit.output.simulation`."""
    simulated = SimulatedRobot(robot, base, srdf)
    tests = (*_ALL, drop if simulated.is_free else hold)
    verdicts: list[Verdict] = []
    for number, test in enumerate(tests):
        if progress:
            progress(number, len(tests))
        try:
            verdicts += test(simulated)
        except mujoco.FatalError as error:  # thousands of contacts exceed its memory
            path = robot.source.path
            raise UrdfkitError(f"{path}: MuJoCo cannot simulate it: {error}") from error
    srdf_path = simulated.srdf.path if simulated.srdf else None
    return Simulation(simulated.is_free, tuple(verdicts), srdf_path)
