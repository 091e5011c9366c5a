"""The box around a robot at a configuration, around its visuals and collisions."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, vector
from urdfkit.robot import Robot
from urdfkit.robot.model import Body
from urdfkit.robot.shapes import BoundingBox, solid


def without_meshes() -> str:
    """Why a mesh is not measured where numpy or the readers of meshes are not installed."""
    from urdfkit.core.installation import install_command

    return f"meshes are not read without: {install_command('meshes')}"


class RobotExtent(Record):
    """What some shapes take up."""

    box: BoundingBox | None  # around them, along the axes of their root; None without any
    measured: int  # how many links have a shape in it
    left_out: dict[str, str]  # why shapes are not in the box, by link


def extent_of(robot: Robot, placed: Mapping[str, Transform]) -> RobotExtent:
    """The box around all visuals and collisions of one tree; of primitives it is exact.

    How the trees of several roots stand to one another, nobody says: the first one with shapes
    counts.

    Args:
        placed: where each link is, as `urdfkit.robot.kinematics.frames` says.
    """
    boxes: list[BoundingBox] = []
    measured: set[str] = set()
    left_out: dict[str, str] = {}
    root = ""
    for name, link in robot.model.links_by_name.items():
        if name not in placed or not (link.visuals or link.collisions):
            continue  # a link of a loop that no root leads to has no place
        root = root or robot.tree.root_of[name]
        if robot.tree.root_of[name] != root:
            left_out[name] = f"not connected to root link {root}"
            continue
        for body in (*link.visuals, *link.collisions):
            if body.shape is None:
                continue
            found = box_of(robot, body, placed[name])
            if isinstance(found, str):
                left_out.setdefault(name, found)
            else:
                boxes.append(found)
                measured.add(name)
    whole = BoundingBox.around(boxes) if boxes else None
    return RobotExtent(whole, len(measured), left_out)


def box_of(robot: Robot, body: Body, link: Transform) -> BoundingBox | str:
    """The box around a visual or collision of a link, or why there is none.

    Args:
        link: the frame of the link, in which the box is wanted.
    """
    shape = body.shape
    if shape is None:
        return "a shape that is missing"
    if shape.filename is None:
        primitive = solid([body._replace(origin=link @ body.origin)])
        return primitive.bounds if primitive else f"a {shape.kind} without positive sizes"
    try:
        vertices = robot.meshes.vertices(shape)
    except ImportError:
        return without_meshes()
    if vertices is None:
        return robot.meshes.reason(shape)
    rotation, position = link @ body.origin
    columns = [vertices @ row + shift for row, shift in zip(rotation, position, strict=True)]
    low, high = ((column.min() for column in columns), (column.max() for column in columns))
    return BoundingBox(vector(low), vector(high))
