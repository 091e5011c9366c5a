"""Test for overlapping links at the start."""

from collections.abc import Iterator

from urdfkit.output.simulation.simulated_robot import OVERLAP, SimulatedRobot
from urdfkit.output.simulation.verdicts import Verdict


def overlap(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each pair of links, the deepest first."""
    robot.set_up()
    depths = robot.overlaps(robot.started())
    for names, depth in sorted(depths.items(), key=lambda pair: -pair[1]):
        links = " and ".join(f"'{name}'" for name in names)
        kind = "convex hulls of links" if any(map(robot.has_mesh, names)) else "links"
        text = f"{kind} {links} overlap by {depth * 1e3:.3g} mm at the start"
        if frozenset(names) in robot.neighbours:  # which MuJoCo otherwise excludes
            text += "; MuJoCo collides them, since the parent is welded to the world"
        yield Verdict("overlap", False, text, depth, OVERLAP, names, robot.collision(names[0]))
    if not depths:
        yield Verdict("overlap", True, "no links overlap at the start", 0.0, OVERLAP)
