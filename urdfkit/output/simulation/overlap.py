"""Test for overlapping links at the start."""

from collections.abc import Iterator

from urdfkit.output.simulation.simulated_robot import OVERLAP, SimulatedRobot
from urdfkit.physics.verdicts import Verdict

#: The rule about overlapping links and convex hulls.
OVERLAPPING = "COL001"


def overlap(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A warning for each pair of links, the deepest first.

    An overlap alone is not a failure: sound robots have it, most of them by their convex hulls. The
    energy test fails if the overlap throws the robot.
    """
    robot.set_up()
    depths = robot.overlaps(robot.started())
    for names, depth in sorted(depths.items(), key=lambda pair: -pair[1]):
        links = " and ".join(f"'{name}'" for name in names)
        kind = "convex hulls of links" if robot.has_mesh(*names) else "links"
        length = f"{depth * 1e3:.3g} mm" if depth < 1 else f"{depth:.3g} m"
        text = f"{kind} {links} overlap by {length} at the start"
        if frozenset(names) in robot.neighbours:  # which MuJoCo otherwise excludes
            text += "; MuJoCo collides them, since the parent is welded to the world"
        place = robot.collision(names[0])
        yield Verdict("overlap", True, text, depth, OVERLAP, names, place, True, OVERLAPPING)
    if not depths:
        yield Verdict("overlap", True, "no links overlap at the start", 0.0, OVERLAP)
