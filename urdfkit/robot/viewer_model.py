"""Links and joints as plain values, for a viewer that moves them. Lengths in m, angles in rad."""

from math import isfinite
from typing import Any

from urdfkit.core.spatial import Transform
from urdfkit.robot.inertia import uniform_solid
from urdfkit.robot.joints import bounds
from urdfkit.robot.kinematics import SLIDING, TURNING, direction, laws
from urdfkit.robot.model import Link, RobotModel
from urdfkit.robot.tree import KinematicTree


def viewer_model(model: RobotModel, tree: KinematicTree) -> dict[str, Any]:
    """The links, and the joints between them, parents before children; no closed loops."""
    names = list(tree.frames)
    numbers = {name: number for number, name in enumerate(names)}
    return {
        "links": [_link(model.links_by_name[name]) for name in names],
        "joints": _joints(model, tree, numbers),
    }


def _link(link: Link) -> dict[str, Any]:
    inertial = link.inertial
    found: dict[str, Any] = {"name": link.name}
    if inertial and link.mass > 0:
        found |= {"mass": link.mass, "center": list(inertial.origin.position)}
        if inertial.tensor is not None:
            edges, axes = uniform_solid(inertial.tensor.value, link.mass)
            if all(map(isfinite, edges)):
                place = matrix(inertial.origin @ Transform(axes))
                found["box"] = {"edges": list(edges), "matrix": place}
    return found


def _joints(
    model: RobotModel, tree: KinematicTree, numbers: dict[str, int]
) -> list[dict[str, Any]]:
    """One joint for each link that has a parent, as `urdfkit.robot.kinematics.frames` has it."""
    joints = model.joints_by_name
    every = laws(joints)
    order = {name: number for number, name in enumerate(joints)}
    found = []
    for joint in tree.spanning:
        entry = {
            "name": joint.name,
            "order": order.get(joint.name, 0),
            "type": joint.kind,
            "parent": numbers[joint.parent_name],
            "child": numbers[joint.child_name],
            "origin": matrix(joint.origin),
            "axis": list(direction(joint)),
        }
        law = every.get(joint.name)
        if joint.kind in (*TURNING, *SLIDING) and law is not None:
            entry |= {"leader": law.leader, "factor": law.factor, "shift": law.shift}
            entry |= {"limits": bounds(joint)}
        found.append(entry)
    return found


def matrix(frame: Transform) -> list[float]:
    """Sixteen numbers, column by column."""
    (a, b, c), (x, y, z) = frame.rotation, frame.position
    columns = [*zip(a, b, c, strict=True)]
    return [v for column in columns for v in (*column, 0.0)] + [x, y, z, 1.0]
