"""Rigid bodies: links connected by fixed joints.

Gazebo, MuJoCo, Drake and Pinocchio merge them; what matters to a simulator is the whole.
"""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.robot.inertia import ZERO, MassProperties, combined, rotated
from urdfkit.robot.model import Joint, Link
from urdfkit.robot.tree import KinematicTree

#: Tags in ``<gazebo>`` that keep a fixed joint as a joint.
KEEPING_TAGS = ("preserveFixedJoint", "disableFixedJointLumping")
#: A mass in kg that sdformat before 9.10.1 and 12.7.2 takes for none, and any smaller one.
NO_MASS = 1e-6


class RigidBody(Record):
    """Links without a moving joint between them."""

    joint: Joint | None  # that moves the body; None for one with a root link
    #: The topmost first, each with its frame in that of the topmost.
    links: tuple[tuple[Link, Transform], ...]

    @property
    def top(self) -> Link:
        """The link that a merger keeps."""
        return self.links[0][0]

    @property
    def is_ground(self) -> bool:
        """True for what is fixed to the world: its mass and inertia have no effect."""
        return self.joint is None and self.top.name == "world"

    @property
    def mass(self) -> float:
        """Total mass in kg; a link without a mass counts as 0."""
        return sum(link.mass for link, _ in self.links)

    @property
    def properties(self) -> MassProperties:
        """Mass properties of all links together, in the frame of the topmost."""
        return combined(properties_of(link, frame) for link, frame in self.links)


def properties_of(link: Link, frame: Transform) -> MassProperties:
    """Mass, centre and tensor of a link in another frame; what is not written is zero.

    Args:
        frame: of the link, in the frame in which they are wanted.
    """
    if link.inertial is None:
        return MassProperties(0.0, frame.position, ZERO)
    own = frame @ link.inertial.origin
    tensor = link.inertial.tensor.value if link.inertial.tensor else ZERO
    return MassProperties(link.mass, own.position, rotated(tensor, own.rotation))


def rigid_bodies(
    tree: KinematicTree, preserved: frozenset[str] = frozenset()
) -> tuple[RigidBody, ...]:
    """The rigid bodies of a model, each before its children.

    A link in a closed loop that no root leads to is in no body.

    Args:
        preserved: names of fixed joints that are kept as joints.
    """
    bodies: list[RigidBody] = []
    seen: set[str] = set()
    links = tree.model.links_by_name
    tops: list[tuple[Joint | None, str]] = [(None, root.name) for root in tree.roots]
    for joint, name in tops:  # grows while it is walked
        if name in seen:
            continue
        seen.add(name)
        group = [(links[name], Transform())]
        for link, frame in group:  # grows, too
            for below in tree.children[link.name]:
                child = below.child_name
                if below.kind != "fixed" or below.name in preserved:
                    tops.append((below, child))
                elif child not in seen:
                    seen.add(child)
                    group.append((links[child], frame @ below.origin))
        bodies.append(RigidBody(joint, tuple(group)))
    return tuple(bodies)
