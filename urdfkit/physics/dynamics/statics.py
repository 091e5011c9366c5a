"""Gravity loads of the joints of a robot at rest, against their effort limits.

The poses looked at: all joints at zero, and all at their limits; poses drawn with a fixed seed; and
for every joint climbs from the worst of these. The root is held.
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

#: Poses that are drawn, and the seed.
SAMPLES, SEED = 200, 0


class Statics(Record):
    """The loads of all joints, the weakest first: those with the largest part of effort used."""

    loads: tuple[Load, ...]  # of the joints that can be set
    poses: int  # how many were looked at before the climbs
    mass: float  # of the robot with its payload, in kg
    payload: dict[str, float]  # masses in kg by link
    weightless: tuple[str, ...]  # links on which Gazebo exerts no gravity, which joints do not hold
    searched: bool  # False for more than `MAX_SEARCHED` joints, whose worst loads are those at zero

    @property
    def weakest(self) -> Load | None:
        """The joint that uses the largest part of its effort; None where none has one."""
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
    """The loads of the joints that can be set by one number.

    Args:
        robot: with its payload.
        pose: one that is looked at besides: positions of joints in rad or m.
        samples: how many poses are drawn between the limits.
        seed: of that drawing.
        joints: the names of those that are judged; all if None.
        progress: called with the number of joints done and of all.
    """
    by_name = robot.tree.model.joints_by_name
    wanted = by_name if joints is None else [name for name in joints if name in by_name]
    efforts = {name: effort(by_name[name]) for name in wanted}
    weightless = links_without_gravity(robot.tree)
    model = GravityModel(robot.tree, robot.payload, weightless)
    starts = model.starts(samples, seed)
    found = gravity_loads(model, efforts, starts, pose or {}, progress)
    mass = robot.mass_properties().mass
    searched = is_searched(len(found))
    names = tuple(sorted(weightless))
    return Statics(tuple(found), len(starts), mass, dict(robot.payload), names, searched)
