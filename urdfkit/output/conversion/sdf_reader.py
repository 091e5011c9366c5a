"""Reads an SDF model by the semantics of SDF 1.7 to 1.11.

The reader is independent of the writer: frames come from ``relative_to`` and ``attached_to``,
bodies from the frames that are attached to a link.
"""

from collections.abc import Iterable, Mapping

from urdfkit.core.spatial import Transform, from_rpy, rotation_about, times, unit
from urdfkit.errors import UrdfkitError
from urdfkit.robot.values import numbers, vector
from urdfkit.text.document import Element
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_as_tinyxml


class Sdf:
    """The model in an SDF file.

    Raises:
        UrdfkitError: the file has no model.
    """

    def __init__(self, source: Source) -> None:
        document, _ = read_as_tinyxml(source)
        model = document.root.child("model") if document else None
        if model is None:
            raise UrdfkitError(f"{source.path}: has no model")
        self.links, self.joints, self._frames = (
            {element.get("name") or "": element for element in model.all(tag)}
            for tag in ("link", "joint", "frame")
        )
        self._children = {text(joint, "child"): joint for joint in self.joints.values()}
        self.counts = {
            "link": len(self.links),
            "joint": len(self.joints),
            "frame": len(self._frames),
            "sensor": sum(element.tag == "sensor" for element in model.walk()),
            "plugin": sum(element.tag == "plugin" for element in model.walk()),
        }

    def link_of(self, name: str) -> str:
        """The link that a link or frame is attached to; empty if there is none."""
        visited = set()
        while name in self._frames and name not in visited:
            visited.add(name)
            name = self._frames[name].get("attached_to") or ""
        return name if name in self.links else ""

    def placed(self, names: Iterable[str], moved: Mapping[str, float]) -> dict[str, Transform]:
        """Poses of links and frames in the model.

        Args:
            moved: positions of joints in rad or m, by name.

        Raises:
            UrdfkitError: the pose of a frame is undefined.
        """
        poses: dict[str, Transform] = {"__model__": Transform(), "world": Transform()}
        known = {*self.links, *self._frames, *self.joints}
        for target in names:
            steps: list[tuple[str, Transform]] = []
            name = target
            while name not in poses:
                if name not in known or len(steps) > len(known):
                    raise UrdfkitError(f"the SDF does not define the pose of '{target}'")
                reference, step = self._step(name, moved)
                steps.append((name, step))
                name = reference
            for frame, step in reversed(steps):
                poses[frame] = poses[name] @ step
                name = frame
        return poses

    def _step(self, name: str, moved: Mapping[str, float]) -> tuple[str, Transform]:
        """The frame that a link, frame or joint is relative to, and its pose in that frame."""
        if name in self.joints:
            joint = self.joints[name]
            reference, at = pose(joint)
            axis = joint.child("axis")
            direction = vector(text(axis, "xyz")) if axis else None
            motion = Transform()
            if direction is not None and joint.get("type") == "revolute":
                motion = Transform(rotation_about(unit(direction), moved.get(name, 0.0)))
            elif direction is not None:
                displacement = times(unit(direction), moved.get(name, 0.0))
                motion = Transform(position=displacement)
            return reference or text(joint, "child"), at @ motion
        element = self._frames.get(name) or self.links[name]
        reference, at = pose(element)
        return reference or element.get("attached_to") or "__model__", at


def text(element: Element, tag: str) -> str:
    child = element.child(tag)
    return child.text.strip() if child else ""


def pose(element: Element) -> tuple[str, Transform]:
    pose = element.child("pose")
    if pose is None:
        return "", Transform()
    values = numbers(pose.text) or (0.0,) * 6
    x, y, z, roll, pitch, yaw = values
    return pose.get("relative_to") or "", Transform(from_rpy(roll, pitch, yaw), (x, y, z))
