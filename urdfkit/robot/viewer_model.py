"""Links and joints as JSON values for an interactive viewer. Lengths in m, angles in rad."""

from math import isfinite
from typing import Any

from urdfkit.core.spatial import Transform
from urdfkit.robot.inertia import uniform_solid
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction, laws
from urdfkit.robot.link import Link
from urdfkit.robot.model import RobotModel
from urdfkit.robot.tree import KinematicTree


def viewer_model(model: RobotModel, tree: KinematicTree) -> dict[str, Any]:
    """The links and the joints of the spanning tree, parents before children."""
    names = list(tree.frames)
    numbers = {name: number for number, name in enumerate(names)}
    return {
        "links": [_link(model.links_by_name[name]) for name in names],
        "joints": _joints(model, tree, numbers),
    }


def _link(link: Link) -> dict[str, Any]:
    inertial = link.inertial
    entry: dict[str, Any] = {"name": link.name}
    if inertial and link.mass > 0:
        entry |= {"mass": link.mass, "center": list(inertial.origin.position)}
        if inertial.tensor is not None:
            edges, axes = uniform_solid(inertial.tensor.value, link.mass)
            if all(map(isfinite, edges)):
                frame = matrix(inertial.origin @ Transform(axes))
                entry["box"] = {"edges": list(edges), "matrix": frame}
    return entry


def _joints(
    model: RobotModel, tree: KinematicTree, numbers: dict[str, int]
) -> list[dict[str, Any]]:
    """One joint for each link that has a parent, as in `urdfkit.robot.kinematics.frames`."""
    joints = model.joints_by_name
    followed = laws(joints)
    order = {name: number for number, name in enumerate(joints)}
    entries = []
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
        law = followed.get(joint.name)
        if joint.is_single_dof and law is not None:
            entry |= {"leader": law.leader, "factor": law.factor, "shift": law.shift}
            entry |= {"limits": bounds(joint)}
        entries.append(entry)
    return entries


def matrix(frame: Transform) -> list[float]:
    """The 4x4 matrix in column-major order."""
    (a, b, c), (x, y, z) = frame.rotation, frame.position
    columns = [*zip(a, b, c, strict=True)]
    return [value for column in columns for value in (*column, 0.0)] + [x, y, z, 1.0]
