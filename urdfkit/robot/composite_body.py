"""A robot as one rigid body: its mass, centre and tensor at a configuration."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.core.words import few
from urdfkit.robot.inertia import MassProperties, combined
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.tree import KinematicTree

#: Names in a reason; the rest are counted.
_MOST = 3


class CompositeBody(Record):
    """A robot as one rigid body at a configuration."""

    mass: float  # of all links, in kg
    #: Mass, centre and tensor in the frame of ``root``; None where nothing says how the links with
    #: mass stand to one another.
    properties: MassProperties | None
    root: str  # the root link above them; empty without one
    reason: str  # why there are no properties; empty if there are


def composite_body(tree: KinematicTree, placed: Mapping[str, Transform]) -> CompositeBody:
    """Mass properties of all links together.

    Args:
        placed: where each link is, as `urdfkit.robot.kinematics.frames` says.
    """
    mass = tree.model.mass
    links = tree.model.links_by_name
    heavy = [name for name, link in links.items() if link.mass]
    lost = [name for name in heavy if name not in tree.root_of]
    if lost:
        return CompositeBody(
            mass, None, "", f"no root leads to {few(lost, _MOST)}, in a closed loop"
        )
    roots = list(dict.fromkeys(tree.root_of[name] for name in heavy))
    if len(roots) > 1:
        reason = f"no joint says how the roots {few(roots, _MOST)} stand to one another"
        return CompositeBody(mass, None, "", reason)
    root = next(iter((*roots, *(link.name for link in tree.roots))), "")
    bodies = (
        properties_of(links[name], frame)
        for name, frame in placed.items()
        if tree.root_of[name] == root
    )
    return CompositeBody(mass, combined(bodies), root, "")
