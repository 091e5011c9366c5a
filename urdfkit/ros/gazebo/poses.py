"""Poses of sensors as SDF defines them."""

from __future__ import annotations

from collections.abc import Mapping
from math import radians

from urdfkit.core.spatial import Transform, from_quaternion, from_rpy
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import numbers
from urdfkit.text.document import Element


class UnreadablePose(ValueError):
    """A ``<pose>`` is invalid in SDF; the text is the reason."""


def written_pose(pose: Element) -> Transform:
    """The numbers of a ``<pose>``: x y z roll pitch yaw, or x y z and a quaternion x y z w.

    Raises:
        UnreadablePose: the text does not have this many finite numbers.
    """
    is_quaternion = pose.get("rotation_format") == "quat_xyzw"
    values = numbers(pose.text)
    count = 7 if is_quaternion else 6
    if values == ():
        return Transform()
    if values is None or len(values) != count:
        raise UnreadablePose(f"the pose is not {count} finite numbers")
    x, y, z, *rotation = values
    if is_quaternion:
        return Transform(from_quaternion(*rotation), (x, y, z))
    if pose.get("degrees") in ("true", "1"):
        rotation = [radians(angle) for angle in rotation]
    return Transform(from_rpy(*rotation), (x, y, z))


def pose_in(parent: Element, frame: str, tree: KinematicTree) -> Transform:
    """The ``<pose>`` of an element in the frame of a link, with all joints at zero.

    Args:
        parent: the element with the pose.
        frame: the link, to which the pose is relative unless it has ``relative_to``.

    Raises:
        UnreadablePose: the text has other numbers; the pose is relative to an unknown frame.
    """
    pose = parent.child("pose")
    if pose is None:
        return Transform()
    relative = written_pose(pose)
    reference = pose.get("relative_to")
    if not reference:
        return relative
    frames = _frames(tree)
    if reference not in frames:
        raise UnreadablePose(f"the pose is relative to '{reference}', which is not a link or joint")
    return frames[frame].inverse @ frames[reference] @ relative


def _frames(tree: KinematicTree) -> Mapping[str, Transform]:
    """Frames of links, of joints (equal to those of their children), and of the model."""
    links = tree.frames
    joints = {
        joint.name: links[joint.child_name]
        for joint in tree.model.joints
        if joint.child_name in links
    }
    return {"__model__": Transform(), **joints, **links}
