"""What the joints carry: an upper bound of the gravity load of each, without computing a pose.

The weight below a joint at the longest lever that its links can make: an upper bound that costs
one walk over the tree. Where it is under the effort of a joint, no pose overloads that joint.
"""

from collections.abc import Mapping
from math import hypot

from urdfkit.core.spatial import basis
from urdfkit.robot.inertia import MassProperties, rotated, shifted
from urdfkit.robot.joints import span
from urdfkit.robot.kinematics import SLIDING, TURNING, direction, laws
from urdfkit.robot.model import DEGREES_OF_FREEDOM, Joint
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.tree import KinematicTree

#: Standard gravity as simulators have it, in m/s^2.
GRAVITY = 9.81

#: Seconds of a step in which the effort of a joint must not take it to so many times its velocity,
#: or of this one in rad/s or m/s: what it moves has no mass to speak of. A sound UR5e has 136.
STEP, FASTEST, ROTOR = 0.002, 1e4, 10.0

#: A body this much lighter than what it carries may make the mass matrix ill-conditioned.
LIGHT = 1e-4


def effort(joint: Joint) -> float | None:
    """What a joint can exert, in N·m or N; None where it is not said, or 0, which says nothing."""
    limit = joint.limit
    if limit is None or limit.effort is None or limit.effort.value <= 0:
        return None
    return limit.effort.value


def is_thrown(joint: Joint, moved: MassProperties) -> bool:
    """True if the effort of a joint that turns is far too large for a body.

    Args:
        moved: the body in the frame of the joint.
    """
    limit, force = joint.limit, effort(joint)
    if limit is None or force is None or joint.kind not in TURNING:
        return False
    about_joint = shifted(moved.tensor, moved.mass, moved.center)
    moment = rotated(about_joint, basis(direction(joint))).izz
    velocity = limit.velocity.value if limit.velocity else 0.0
    return force * STEP > FASTEST * max(velocity, ROTOR) * moment


def overloadable(tree: KinematicTree) -> list[Joint]:
    """The joints with an effort that gravity may exceed in some pose.

    What cannot move (JNT003) is held by its stops, and needs no effort.

    Args:
        tree: of the model; joints of one that is not sound are none.
    """
    if not tree.is_sound:
        return []
    most = largest(tree)
    joints = tree.model.joints_by_name
    return [
        joints[name]
        for name, load in most.items()
        if (limit := effort(joints[name])) is not None and load > limit and _moves(joints[name])
    ]


def _moves(joint: Joint) -> bool:
    lower, upper = span(joint)
    return lower < upper


def largest(tree: KinematicTree) -> dict[str, float]:
    """The upper bound of what each joint must hold, in N·m or N, by its name.

    Joints that follow another one load that one, as if a linkage joined them.
    """
    mass: dict[str, float] = {}
    lever: dict[str, float] = {}  # the sum of mass times distance from the origin of a link
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
        joint.name: GRAVITY * (mass if joint.kind in SLIDING else lever)[joint.child_name]
        for joint in tree.model.joints
        if joint.child_name and (joint.kind in TURNING or joint.kind in SLIDING)
    }
    return _with_followers(tree, own)


def _with_followers(tree: KinematicTree, own: Mapping[str, float]) -> dict[str, float]:
    found = dict.fromkeys(own, 0.0)
    for name, (leader, factor, _) in laws(tree.model.joints_by_name).items():
        if name in own and leader in found:
            found[leader] += abs(factor) * own[name]
    return found


def _travel(joint: Joint) -> float:
    """How far a slide takes its child from its origin at most."""
    return max(map(abs, span(joint))) if joint.kind in SLIDING else 0.0


def light(tree: KinematicTree) -> list[Joint]:
    """The joints whose own body has a negligible mass against what it carries by other joints.

    Args:
        tree: of the model; of one that is not sound there are none.
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


def idle(tree: KinematicTree) -> list[Joint]:
    """The joints that move nothing: below them there is no mass, no visual and no collision.

    Args:
        tree: of the model; of one that is not sound there are none.
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
