"""Upper bounds of the gravity loads of joints, without computing a pose.

The bound is the weight below a joint at the longest possible lever, and costs one walk over the
tree. If it is below the effort of the joint, no pose overloads the joint.
"""

from collections.abc import Mapping
from math import hypot

from urdfkit.core.spatial import basis
from urdfkit.robot.inertia import MassProperties, rotated, shifted
from urdfkit.robot.joint import DEGREES_OF_FREEDOM, Joint
from urdfkit.robot.joint_limits import span
from urdfkit.robot.kinematics import direction, laws
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.tree import KinematicTree

#: Standard gravity as in simulators, in m/s².
GRAVITY = 9.81

#: The effort of a joint is excessive if in a step of `STEP` seconds it exceeds `FASTEST` times the
#: velocity limit, or `ROTOR` in rad/s or m/s if that is larger. A sound UR5e has 136 times.
STEP, FASTEST, ROTOR = 0.002, 1e4, 10.0

#: A body with less than this part of the mass it carries may make the mass matrix ill-conditioned.
LIGHT = 1e-4


def effort(joint: Joint) -> float | None:
    """The effort limit in N·m or N; None if it is missing, 0 (meaningless) or negative."""
    limit = joint.limit
    if limit is None or limit.effort is None or limit.effort.value <= 0:
        return None
    return limit.effort.value


def is_effort_excessive(joint: Joint, body: MassProperties) -> bool:
    """True if the effort of a rotary joint is far too large for the inertia of a body.

    Args:
        body: mass properties in the frame of the joint.
    """
    limit, force = joint.limit, effort(joint)
    if limit is None or force is None or not joint.is_rotational:
        return False
    about_joint = shifted(body.tensor, body.mass, body.center)
    moment = rotated(about_joint, basis(direction(joint))).izz
    velocity = limit.velocity.value if limit.velocity else 0.0
    return force * STEP > FASTEST * max(velocity, ROTOR) * moment


def overloadable_joints(tree: KinematicTree) -> list[Joint]:
    """The joints whose effort gravity may exceed in some pose.

    Joints that cannot move (JNT003) are held by their limits and need no effort.

    Args:
        tree: the result is empty unless it is sound.
    """
    if not tree.is_sound:
        return []
    loads = maximum_loads(tree)
    joints = tree.model.joints_by_name
    return [
        joints[name]
        for name, load in loads.items()
        if (limit := effort(joints[name])) is not None and load > limit and _moves(joints[name])
    ]


def _moves(joint: Joint) -> bool:
    lower, upper = span(joint)
    return lower < upper


def maximum_loads(tree: KinematicTree) -> dict[str, float]:
    """The upper bound of the load of each joint by its name, in N·m or N.

    Mimic joints load their leader, as if a linkage connected them.
    """
    mass: dict[str, float] = {}
    lever: dict[str, float] = {}  # sum of mass times distance from the origin of the link
    for name in reversed(tree.below(tree.roots[0].name)):
        link = tree.model.links_by_name[name]
        mass[name] = abs(link.mass)
        lever[name] = mass[name] * (hypot(*link.inertial.origin.position) if link.inertial else 0)
        for joint in tree.children[name]:
            child = joint.child_name
            mass[name] += mass[child]
            lever[name] += lever[child] + mass[child] * (
                hypot(*joint.origin.position) + _travel(joint)
            )
    own = {
        joint.name: GRAVITY * (mass if joint.is_prismatic else lever)[joint.child_name]
        for joint in tree.model.joints
        if joint.child_name and joint.is_single_dof
    }
    return _with_followers(tree, own)


def _with_followers(tree: KinematicTree, own: Mapping[str, float]) -> dict[str, float]:
    loads = dict.fromkeys(own, 0.0)
    for name, (leader, factor, _) in laws(tree.model.joints_by_name).items():
        if name in own and leader in loads:
            loads[leader] += abs(factor) * own[name]
    return loads


def _travel(joint: Joint) -> float:
    """Largest distance of the child of a prismatic joint from the joint's origin, in m."""
    return max(map(abs, span(joint))) if joint.is_prismatic else 0.0


def light_joints(tree: KinematicTree) -> list[Joint]:
    """The joints whose body has a negligible mass compared with the bodies it carries.

    Args:
        tree: the result is empty unless it is sound.
    """
    if not tree.is_sound:
        return []
    bodies = rigid_bodies(tree)
    tops = {body.top.name: body for body in bodies}
    below = {body.top.name: body.mass for body in bodies}
    for body in reversed(bodies):
        for link, _ in body.links:
            for joint in tree.children[link.name]:
                if joint.child_name in tops:
                    below[body.top.name] += below[joint.child_name]
    return [
        body.joint
        for body in bodies
        if body.joint
        and below[body.top.name] > body.mass
        and body.mass < LIGHT * below[body.top.name]
    ]


def joints_without_load(tree: KinematicTree) -> list[Joint]:
    """The joints that move no mass, no visual and no collision.

    Args:
        tree: the result is empty unless it is sound.
    """
    if not tree.is_sound:
        return []
    used: set[str] = set()
    for name in reversed(tree.below(tree.roots[0].name)):
        link = tree.model.links_by_name[name]
        below = (joint.child_name for joint in tree.children[name])
        if link.mass or link.visuals or link.collisions or not used.isdisjoint(below):
            used.add(name)
    return [
        joint
        for joint in tree.model.joints
        if joint.kind in DEGREES_OF_FREEDOM and not joint.mimic and joint.child_name not in used
    ]
