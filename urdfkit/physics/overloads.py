"""Joints whose effort limit gravity exceeds in some pose."""

from __future__ import annotations

from functools import lru_cache
from math import isfinite

from urdfkit.physics.gravity import Load, gravity_loads
from urdfkit.physics.gravity_model import GravityModel
from urdfkit.robot.joint_loads import effort, overloadable_joints
from urdfkit.robot.rotors import is_carried_by_rotors
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.gazebo.gravity import links_without_gravity

#: Number of random start poses; a serial arm needs none.
_SAMPLES = 20

#: Most joints in the text of a pose.
_MAX_NAMED = 6

#: Positions below this, in rad or m, are not written.
_AT_ZERO = 5e-4


def overloads(tree: KinematicTree) -> list[Load]:
    """Loads above the effort limit in the worst pose, with the root fixed, largest ratio first.

    Empty for robots that rotors carry, as their root is not fixed.
    """
    joints = overloadable_joints(tree)
    if not joints or is_carried_by_rotors(tree.model):
        return []
    model = GravityModel(tree, weightless=links_without_gravity(tree))
    loads = _loads(model, tuple((joint.name, effort(joint)) for joint in joints))
    return [load for load in loads if load.is_exceeded and isfinite(load.worst)]


@lru_cache(maxsize=16)  # editors and fixes check a robot repeatedly with the same masses
def _loads(model: GravityModel, efforts: tuple[tuple[str, float | None], ...]) -> list[Load]:
    return gravity_loads(model, dict(efforts), model.starts(_SAMPLES, seed=0), pose={})


def worst_pose(load: Load) -> str:
    """The worst pose of a joint as text, such as ``elbow 1.57``.

    Of many joints, the joint itself and those that are farthest from zero.
    """
    pose = {name: place for name, place in load.pose.items() if abs(place) > _AT_ZERO}
    farthest = sorted(pose, key=lambda name: (name != load.joint, -abs(pose[name])))[:_MAX_NAMED]
    named = [f"{name} {place:.3g}" for name, place in pose.items() if name in farthest]
    more = f" and {len(pose) - len(named)} more" if len(pose) > len(named) else ""
    return ", ".join(named) + more or "zero"
