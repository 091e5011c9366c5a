"""Rigid bodies: links connected by fixed joints.

Gazebo, MuJoCo, Drake and Pinocchio merge them into one body.
"""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.robot.inertia import ZERO, MassProperties, combined, rotated
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.robot.tree import KinematicTree

#: Tags in ``<gazebo>`` that preserve a fixed joint.
KEEPING_TAGS = ("preserveFixedJoint", "disableFixedJointLumping")
#: Masses in kg up to this are 0 for sdformat before 9.10.1 and 12.7.2.
NO_MASS = 1e-6


class RigidBody(Record):
    """Links connected by fixed joints."""

    joint: Joint | None  # the parent joint of the body; None if a root link is in it
    #: The topmost link first, each with its frame in the frame of the topmost.
    links: tuple[tuple[Link, Transform], ...]

    @property
    def top(self) -> Link:
        """The link into which the others are merged."""
        return self.links[0][0]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of its links, the topmost first."""
        return tuple(link.name for link, _ in self.links)

    @property
    def is_ground(self) -> bool:
        """True if the body is fixed to the world: its mass and inertia have no effect."""
        return self.joint is None and self.top.name == "world"

    @property
    def mass(self) -> float:
        """Total mass in kg; 0 for links without a mass."""
        return sum(link.mass for link, _ in self.links)

    @property
    def properties(self) -> MassProperties:
        """Mass properties of all links, in the frame of the topmost link."""
        return combined(properties_of(link, frame) for link, frame in self.links)


def properties_of(link: Link, frame: Transform) -> MassProperties:
    """Mass, centre and tensor of a link in another frame; missing values are zero.

    Args:
        frame: of the link, in the frame of the result.
    """
    if link.inertial is None:
        return MassProperties(0.0, frame.position, ZERO)
    own = frame @ link.inertial.origin
    tensor = link.inertial.tensor.value if link.inertial.tensor else ZERO
    return MassProperties(link.mass, own.position, rotated(tensor, own.rotation))


def rigid_bodies(
    tree: KinematicTree, preserved: frozenset[str] = frozenset()
) -> tuple[RigidBody, ...]:
    """The rigid bodies of a model, parents before children.

    Links in a closed loop without a root are omitted.

    Args:
        preserved: names of fixed joints that are not merged.
    """
    bodies: list[RigidBody] = []
    visited: set[str] = set()
    links = tree.model.links_by_name
    tops: list[tuple[Joint | None, str]] = [(None, root.name) for root in tree.roots]
    for joint, name in tops:  # appended to in the loop
        if name in visited:
            continue
        visited.add(name)
        group = [(links[name], Transform())]
        for link, frame in group:  # appended to in the loop
            for below in tree.children[link.name]:
                child = below.child_name
                if below.kind != "fixed" or below.name in preserved:
                    tops.append((below, child))
                elif child not in visited:
                    visited.add(child)
                    group.append((links[child], frame @ below.origin))
        bodies.append(RigidBody(joint, tuple(group)))
    return tuple(bodies)
