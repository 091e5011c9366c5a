"""The slow parts of a report: gravity loads of the joints, stability, and colliding links."""

from urdfkit.core.progress import Progress
from urdfkit.errors import Unavailable, UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.report.tables import Row
from urdfkit.robot.stability import standing_verdict

#: Number of sampled poses for statics and for collisions; the separate commands sample more.
POSES, SAMPLES = 200, 1000
#: Most pairs of links that a report compares; more take minutes.
MAX_PAIRS = 10_000
#: Torques in N·m and forces in N below this value are rounding errors.
NOISE = 1e-9


def statics(context: Context) -> Row:
    """The gravity load of each joint in its worst pose, the most loaded joint first.

    Raises:
        Unavailable: Pinocchio is not installed, or cannot read the robot.
    """
    robot = context.dynamics
    from urdfkit.physics.dynamics.statics import statics as loads_of

    result = loads_of(robot, samples=POSES)
    joints = context.model.joints_by_name
    return {
        "poses": result.poses,
        "mass": result.mass,
        "joints": [
            {
                "joint": load.joint,
                "unit": joints[load.joint].effort_unit,
                "at_zero": _round(load.at_zero),
                "worst": _round(load.worst),
                "effort": load.effort,
                "used": load.used,
                "exceeded": load.is_exceeded,
            }
            for load in result.loads
        ],
    }


def _round(torque: float) -> float:
    """A torque; 0 if it is only a rounding error."""
    return 0.0 if abs(torque) < NOISE else torque


def standing(context: Context) -> Row:
    """Stability of the robot with all joints at zero, as in ``urdfkit statics``.

    Raises:
        Unavailable: links and joints do not form one tree.
    """
    if not context.tree.is_sound:
        raise Unavailable(context.tree.unsound)
    return standing_verdict(context).facts()


def collisions(context: Context, progress: Progress | None = None) -> Row:
    """Pairs of links that can collide, by sampling.

    Args:
        context: the robot.
        progress: called with the number of finished samples and of all samples.

    Raises:
        Unavailable: coal is not installed, or the robot has too many pairs of links.
    """
    links = sum(bool(link.collisions) for link in context.model.links)
    if links * (links - 1) // 2 > MAX_PAIRS:
        raise Unavailable(f"too many pairs of {links} links; see 'urdfkit collisions'")
    try:
        matrix = context.collisions.matrix(samples=SAMPLES, progress=progress)
    except UrdfkitError as error:
        raise Unavailable(str(error)) from error
    names = dict.fromkeys(name for pair in matrix.pairs for name in (pair.first, pair.second))
    return {
        "samples": matrix.samples,
        "seed": matrix.seed,
        "links": [name for name in context.model.links_by_name if name in names],
        "pairs": [
            {
                "first": pair.first,
                "second": pair.second,
                "verdict": pair.verdict.value,
                "frequency": pair.frequency,
                "distance": pair.nearest.distance if pair.nearest else None,
                "near_miss": pair.is_near_miss,
            }
            for pair in matrix.pairs
        ],
        "parts": list(matrix.parts),
        "omitted": [{"link": item.link, "reason": item.reason} for item in matrix.omitted],
    }
