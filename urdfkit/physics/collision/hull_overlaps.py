"""Overlaps of convex hulls, which some simulators use instead of the triangles of meshes."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.physics.collision.bodies import CollisionBody
from urdfkit.physics.collision.contacts import Contacts, LinkPair


class HullOverlap(Record):
    """Two links whose hulls overlap in the initial pose."""

    #: first and second: the bodies of the deepest overlap.
    first: CollisionBody
    second: CollisionBody
    depth: float  # in m
    joint: str  # the only movable joint between the links; empty if there are none or several
    is_welded: bool  # True if only fixed joints connect the parent of the joint to the root


def hull_overlaps(contacts: Contacts, least: float) -> Iterator[HullOverlap]:
    """The pairs of links with hulls that overlap by more than a depth, in m.

    Links that only fixed joints connect are one body in all simulators.
    """
    for pair in contacts.pairs:
        if pair.is_rigid:
            continue
        if deepest := _deepest(contacts, pair, least):
            depth, first, second = deepest
            moving = [joint for joint in contacts.between(pair.names) if joint.kind != "fixed"]
            joint = moving[0] if len(moving) == 1 else None
            path = contacts.tree.path(joint.parent_name) if joint else ()
            is_welded = joint is not None and all(above.kind == "fixed" for above in path)
            yield HullOverlap(first, second, depth, joint.name if joint else "", is_welded)


def _deepest(
    contacts: Contacts, pair: LinkPair, least: float
) -> tuple[float, CollisionBody, CollisionBody] | None:
    """The depth in m and the bodies of the deepest overlap of more than ``least``."""
    deepest = None
    for first, second, bound in pair.bounds:
        if -bound > least:
            depth = -contacts.hull_distance(first, second)
            if depth > least:
                least, deepest = depth, (depth, first, second)
    return deepest
