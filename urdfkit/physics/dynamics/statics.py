"""Gravity loads of the joints of a robot at rest, against their effort limits.

Poses: all joints at zero, all at their limits, random poses with a fixed seed, and for every joint
local searches from the worst of these. The root is fixed.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.physics.dynamics.robot import Dynamics
from urdfkit.physics.gravity import Load, gravity_loads, is_searched
from urdfkit.physics.gravity_model import GravityModel
from urdfkit.robot.joint_loads import effort
from urdfkit.ros.gazebo.gravity import links_without_gravity

#: Number of random poses, and their seed.
SAMPLES, SEED = 200, 0


class Statics(Record):
    """The loads of all joints, sorted by the used part of the effort limit, largest first."""

    loads: tuple[Load, ...]  # of the independent joints
    poses: int  # number of poses before the local searches
    mass: float  # of the robot with its payload, in kg
    payload: dict[str, float]  # masses in kg by link
    weightless: tuple[str, ...]  # links on which Gazebo exerts no gravity, which joints do not hold
    searched: bool  # False for more than `MAX_SEARCHED` joints, whose worst loads are those at zero

    @property
    def weakest(self) -> Load | None:
        """The joint that uses the largest part of its effort limit; None without limits."""
        return next((load for load in self.loads if load.used is not None), None)


def statics(
    robot: Dynamics,
    pose: Mapping[str, float] | None = None,
    *,
    samples: int = SAMPLES,
    seed: int = SEED,
    joints: Iterable[str] | None = None,
    progress: Progress | None = None,
) -> Statics:
    """The gravity loads of the independent joints of one degree of freedom.

    Args:
        robot: with its payload.
        pose: an additional pose: positions of joints in rad or m.
        samples: number of random poses within the limits.
        seed: of the random poses.
        joints: names of the joints to evaluate; all if None.
        progress: called with the number of finished joints and of all.
    """
    by_name = robot.tree.model.joints_by_name
    names = by_name if joints is None else [name for name in joints if name in by_name]
    efforts = {name: effort(by_name[name]) for name in names}
    weightless = links_without_gravity(robot.tree)
    model = GravityModel(robot.tree, robot.payload, weightless)
    starts = model.starts(samples, seed)
    loads = gravity_loads(model, efforts, starts, pose or {}, progress)
    mass = robot.mass_properties().mass
    searched = is_searched(len(loads))
    links = tuple(sorted(weightless))
    return Statics(tuple(loads), len(starts), mass, dict(robot.payload), links, searched)
