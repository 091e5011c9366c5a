"""The bounding box of a robot's visuals and collisions at a configuration."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, vector
from urdfkit.robot import Robot
from urdfkit.robot.link import Body
from urdfkit.robot.shapes import BoundingBox, solid


def without_meshes() -> str:
    """The reason why meshes are not measured if numpy or the mesh readers are not installed."""
    from urdfkit.core.installation import install_command

    return f"meshes are not read without: {install_command('meshes')}"


class RobotExtent(Record):
    """The bounding box of the shapes of a robot."""

    box: BoundingBox | None  # along the axes of the root; None without shapes
    measured: int  # number of links with a shape in the box
    left_out: dict[str, str]  # why shapes of a link are not in the box, by link


def extent_of(robot: Robot, placed: Mapping[str, Transform]) -> RobotExtent:
    """The bounding box of all visuals and collisions of one tree; exact for primitives.

    The relative poses of several trees are unknown: the first tree with shapes counts.

    Args:
        placed: the frame of each link, from `urdfkit.robot.kinematics.frames`.
    """
    boxes: list[BoundingBox] = []
    measured: set[str] = set()
    left_out: dict[str, str] = {}
    root = ""
    for name, link in robot.model.links_by_name.items():
        if name not in placed or not (link.visuals or link.collisions):
            continue  # a link in a closed loop without a root has no frame
        root = root or robot.tree.root_of[name]
        if robot.tree.root_of[name] != root:
            left_out[name] = f"not connected to root link {root}"
            continue
        for body in link.bodies:
            if body.shape is None:
                continue
            box = box_of(robot, body, placed[name])
            if isinstance(box, str):
                left_out.setdefault(name, box)
            else:
                boxes.append(box)
                measured.add(name)
    union = BoundingBox.around(boxes) if boxes else None
    return RobotExtent(union, len(measured), left_out)


def box_of(robot: Robot, body: Body, link: Transform) -> BoundingBox | str:
    """The bounding box of a visual or collision, or the reason why there is none.

    Args:
        link: the frame of the link, in the frame of the box.
    """
    shape = body.shape
    if shape is None:
        return "a missing shape"
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
