"""Changes of a robot when a program imports it, each with its element and a text."""

from __future__ import annotations

from collections.abc import Iterator
from math import isclose

from urdfkit.core.record import Record
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.ros.importers.imported import Imported, ImportedBody
from urdfkit.ros.importers.mass_differences import ROUNDING
from urdfkit.ros.importers.orders import WORLD
from urdfkit.text.document import Element


class Change(Record):
    """A change of an element."""

    at: Element  # the element of the URDF
    text: str  # description in a few words


def changes(robot: Imported) -> Iterator[Change]:
    """Changes of a robot: bodies, then masses, shapes, joints."""
    for body in robot.bodies:
        yield from _merged(body)
    for body in robot.bodies:
        if body.name != WORLD or not robot.facts.merges_into_world:
            yield from _masses(robot, body)
    yield from _tensors(robot)
    yield from _visuals(robot)
    for joint in robot.tree.model.joints:
        yield from _joint(robot, joint)


def _merged(body: ImportedBody) -> Iterator[Change]:
    for link in body.links:
        if link.name == body.name:
            continue
        lost = f"; its {link.mass:g} kg have no effect" if body.name == WORLD and link.mass else ""
        yield Change(link.at, f"link '{link.name}' is merged into {body.name}{lost}")


def _masses(robot: Imported, body: ImportedBody) -> Iterator[Change]:
    facts = robot.facts
    if body.mass is None and facts.massless:
        yield Change(body.links[0].at, f"link '{body.name}' has no mass: {facts.massless}")
        return
    for link in body.links:
        properties = robot.properties_of(link)
        if properties is not None:
            yield from _mass(robot, link, properties.mass)
        elif not facts.massless:
            reason = "no <inertial>: its mass is computed from meshes, which are not read here"
            yield Change(link.at, f"link '{link.name}' has {reason}")


def _mass(robot: Imported, link: Link, mass: float) -> Iterator[Change]:
    if isclose(mass, link.mass, rel_tol=ROUNDING):
        return
    is_computed = bool(robot.facts.density and link.collisions)
    mass_source = "from its collision shapes" if is_computed else "by default"
    original = "no <inertial>" if link.inertial is None else f"{link.mass:g} kg"
    at = (link.inertial or link).at
    yield Change(at, f"link '{link.name}' with {original} gets {mass:.4g} kg {mass_source}")


def _tensors(robot: Imported) -> Iterator[Change]:
    inertials = [link.inertial for link in robot.tree.model.links if link.inertial]
    if robot.facts.ignores_tensors and inertials:
        replacement = "each comes from the collision shapes"
        yield Change(
            inertials[0].at, f"tensors are not read: {len(inertials)} in all; {replacement}"
        )


def _visuals(robot: Imported) -> Iterator[Change]:
    visuals = [visual for link in robot.tree.model.links for visual in link.visuals]
    if robot.drops_visuals and visuals:
        yield Change(visuals[0].at, f"visuals are not loaded: {len(visuals)} in all")


def _joint(robot: Imported, joint: Joint) -> Iterator[Change]:
    facts, name = robot.facts, f"joint '{joint.name}'"
    if joint.kind in facts.unknown_types:
        yield Change(joint.at, f"{name} is {joint.kind}, which {facts.name} rejects")
    elif joint.kind in facts.coordinates and facts.coordinates_of(joint.kind) == (0, 0):
        yield Change(joint.at, f"{name} is {joint.kind}, and becomes fixed")
    if joint.kind in facts.suffixes:
        parts = ", ".join(joint.name + end for end in facts.suffixes[joint.kind])
        yield Change(joint.at, f"{name} becomes {parts}")
    if joint.mimic and joint.leader:
        yield Change(joint.mimic.at, f"{name} mimics '{joint.leader}': {facts.about_mimic}")
