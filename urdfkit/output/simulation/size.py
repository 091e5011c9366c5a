"""Test of the size of a robot against its mass."""

from collections.abc import Iterator

from urdfkit.output.simulation.simulated_robot import SimulatedRobot
from urdfkit.physics.verdicts import Verdict

#: Largest mass per cube of the size, in kg/m³. Osmium has 22,590, and no robot fills the cube: the
#: densest robots have 1,000.
MAX_DENSITY = 1e6


def size(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict on a robot that moves and is far too small for its mass.

    Without the collisions of all links with mass, its size is unknown.
    """
    if not robot.leaders or any(
        link.mass and not link.collisions for link in robot.robot.model.links
    ):
        return
    extent, mass = robot.extent(), float(robot.model.body_mass.sum())
    density = mass / extent**3
    text = f"the robot weighs {mass:.3g} kg and measures {_length(extent)}"
    if density <= MAX_DENSITY:
        yield Verdict("size", True, text, density, MAX_DENSITY)
        return
    text += f": {density:.2g} kg/m³ (bound {MAX_DENSITY:g}), lengths may have the wrong unit"
    yield Verdict("size", False, text, density, MAX_DENSITY)


def _length(metres: float) -> str:
    return f"{metres:.3g} m" if metres >= 0.1 else f"{metres * 1e3:.3g} mm"
