"""A robot in three dimensions, for the engine in a page: surfaces, and how joints move links."""

from __future__ import annotations

import gzip
from math import isfinite
from typing import TYPE_CHECKING, Any

from urdfkit.core.installation import install_command
from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.errors import MissingLibrary
from urdfkit.lint.context import Unavailable
from urdfkit.robot.inertia import uniform_solid
from urdfkit.robot.joints import bounds
from urdfkit.robot.kinematics import SLIDING, TURNING, direction, laws

if TYPE_CHECKING:
    from urdfkit.lint.context import Context
    from urdfkit.render import Scene
    from urdfkit.robot.model import Link

#: A page of more links is too slow to open, one of more triangles too large to send.
MAX_LINKS, MAX_TRIANGLES = 5000, 1_500_000


def without_report() -> str:
    """Why there is no 3D view where what draws it is not installed."""
    return f"images and the 3D view need: {install_command('report')}"


class PageScene(Record):
    """The robot as the 3D engine draws it."""

    model: bytes  # binary glTF, packed with gzip; each surface in the frame of its link
    robot: dict[str, Any]  # links, and joints with parents before children, as plain values


def surfaces(context: Context) -> Scene:
    """The triangles of a robot, for images and for the engine.

    Raises:
        Unavailable: a library is not installed, or the robot has too many links for a page.
    """
    if len(context.model.links) > MAX_LINKS:
        raise Unavailable(f"{len(context.model.links)} links are more than a page can show")
    try:
        from urdfkit.render import build as build_surfaces
    except (ImportError, MissingLibrary) as error:
        raise Unavailable(without_report()) from error
    return build_surfaces(context, roles=("visual", "collision"))


def build(context: Context, built: Scene) -> PageScene:
    """The scene of a robot; of one with very many triangles a coarse one."""
    from urdfkit.output.report.gltf import write
    from urdfkit.render.coarse import coarsened

    tree = context.tree
    model, triangles = write(coarsened(built.items, MAX_TRIANGLES))
    names = list(tree.frames)  # parents before children, links of closed loops left out
    numbers = {name: number for number, name in enumerate(names)}
    robot = {
        "links": [_link(context.model.links_by_name[name]) for name in names],
        "joints": _joints(context, numbers),
        "triangles": triangles,
        "missing": [list(map(str, missing)) for missing in built.missing],
    }
    return PageScene(packed(model), robot)


def nothing() -> PageScene:
    """The scene of a robot that cannot be read.

    Raises:
        Unavailable: numpy is not installed.
    """
    try:
        from urdfkit.output.report.gltf import write
    except (ImportError, MissingLibrary) as error:
        raise Unavailable(without_report()) from error
    model, triangles = write(())
    return PageScene(
        packed(model), {"links": [], "joints": [], "triangles": triangles, "missing": []}
    )


def packed(model: bytes) -> bytes:
    """A model as a page carries it."""
    return gzip.compress(model, 6, mtime=0)  # 9 takes twice as long for 0.1 % less


def _link(link: Link) -> dict[str, Any]:
    inertial = link.inertial
    found: dict[str, Any] = {"name": link.name}
    if inertial and link.mass > 0:
        found |= {"mass": link.mass, "center": list(inertial.origin.position)}
        if inertial.tensor is not None:
            edges, axes = uniform_solid(inertial.tensor.value, link.mass)
            if all(map(isfinite, edges)):
                matrix = _matrix(inertial.origin @ Transform(axes))
                found["box"] = {"edges": list(edges), "matrix": matrix}
    return found


def _joints(context: Context, numbers: dict[str, int]) -> list[dict[str, Any]]:
    """One joint for each link that has a parent, as `urdfkit.robot.kinematics.frames` has it."""
    joints = context.model.joints_by_name
    every = laws(joints)
    order = {name: number for number, name in enumerate(joints)}
    found = []
    for joint in context.tree.spanning:
        entry = {
            "name": joint.name,
            "order": order.get(joint.name, 0),
            "type": joint.kind,
            "parent": numbers[joint.parent_name],
            "child": numbers[joint.child_name],
            "origin": _matrix(joint.origin),
            "axis": list(direction(joint)),
        }
        law = every.get(joint.name)
        if joint.kind in (*TURNING, *SLIDING) and law is not None:
            entry |= {"leader": law.leader, "factor": law.factor, "shift": law.shift}
            entry |= {"limits": bounds(joint)}
        found.append(entry)
    return found


def _matrix(frame: Transform) -> list[float]:
    """Sixteen numbers, column by column, as three.js takes them."""
    (a, b, c), (x, y, z) = frame.rotation, frame.position
    columns = [*zip(a, b, c, strict=True)]
    return [v for column in columns for v in (*column, 0.0)] + [x, y, z, 1.0]
