"""Why the mass of a robot differs between its URDF and a program that imports it."""

from collections.abc import Iterator
from math import isclose

from urdfkit.core.words import counted
from urdfkit.robot.link import Link
from urdfkit.ros.importers.imported import Imported, ImportedBody
from urdfkit.ros.importers.orders import WORLD

#: Relative difference up to which masses are equal.
ROUNDING = 1e-9


def mass_differences(robot: Imported) -> Iterator[str]:
    """The causes, each in a few words; none if the masses are those of the URDF."""
    facts = robot.facts
    moving: list[ImportedBody] = []
    welded: list[ImportedBody] = []
    for body in robot.bodies:
        is_world = facts.merges_into_world and body.name == WORLD
        (welded if is_world else moving).append(body)
    if lost := sum(link.mass for body in welded for link in body.links):
        yield f"{lost:g} kg of links welded to the world have no effect"
    if unknown := sum(body.mass is None for body in moving if facts.massless):
        yield f"{_having(unknown)} no mass: {facts.massless}"
    elif unread := sum(body.mass is None for body in moving):
        yield f"the mass of {counted(unread, 'link')} is that of meshes, which are not read here"
    yield from _gained(robot, moving)


def _having(bodies: int) -> str:
    return "1 body has" if bodies == 1 else f"{bodies} bodies have"


def _gained(robot: Imported, bodies: list[ImportedBody]) -> Iterator[str]:
    """Masses that a program gives to links."""
    found: dict[str, list[tuple[Link, float]]] = {}
    for link in (link for body in bodies for link in body.links):
        properties = robot.properties_of(link)
        if properties and not isclose(properties.mass, link.mass, rel_tol=ROUNDING):
            is_computed = bool(robot.facts.density and link.collisions)
            source = "from collision shapes" if is_computed else "by default"
            found.setdefault(source, []).append((link, properties.mass))
    for source, given in found.items():
        lacks = all(link.inertial is None for link, _ in given)
        links = counted(len(given), "link") + " without <inertial>" * lacks
        verb = "gets" if len(given) == 1 else "get"
        yield f"{links} {verb} {sum(mass for _, mass in given):.4g} kg {source}"
