"""The robot at a configuration as one rigid body: mass, centre and tensor."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.core.words import few
from urdfkit.robot.inertia import MassProperties, combined
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.tree import KinematicTree

#: Names that a reason lists; further names are counted.
_MAX_NAMED = 3


class CompositeBody(Record):
    """A robot as one rigid body at a configuration."""

    mass: float  # of all links, in kg
    #: Mass, centre and tensor in the frame of ``root``; None if the links with mass have no
    #: common root.
    properties: MassProperties | None
    root: str  # their root link; empty if ``properties`` is None
    reason: str  # why ``properties`` is None; empty otherwise


def composite_body(tree: KinematicTree, placed: Mapping[str, Transform]) -> CompositeBody:
    """Mass properties of all links.

    Args:
        placed: the frame of each link, from `urdfkit.robot.kinematics.frames`.
    """
    mass = tree.model.mass
    links = tree.model.links_by_name
    heavy = [name for name, link in links.items() if link.mass]
    unreachable = [name for name in heavy if name not in tree.root_of]
    if unreachable:
        return CompositeBody(
            mass, None, "", f"links in a closed loop without a root: {few(unreachable, _MAX_NAMED)}"
        )
    roots = list(dict.fromkeys(tree.root_of[name] for name in heavy))
    if len(roots) > 1:
        reason = f"no joint connects the roots {few(roots, _MAX_NAMED)}"
        return CompositeBody(mass, None, "", reason)
    root = next(iter((*roots, *(link.name for link in tree.roots))), "")
    bodies = (
        properties_of(links[name], frame)
        for name, frame in placed.items()
        if tree.root_of[name] == root
    )
    return CompositeBody(mass, combined(bodies), root, "")
