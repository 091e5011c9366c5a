"""Trajectories of MoveIt: the joints in them, and the controllers of ros2_control."""

from collections.abc import Iterator, Mapping
from itertools import islice

from urdfkit.lint.rules import Context
from urdfkit.robot.model import RobotModel
from urdfkit.ros.controllers import Controller, read
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.located_yaml import Node, Value

#: Most files of the workspace that are read, and directories that are searched.
_MAX_FILES, _MAX_DIRECTORIES = 500, 1000
#: The types of controllers in MoveIt 2.
TYPES = ("FollowJointTrajectory", "GripperCommand", "ParallelGripperCommand")


def omitted_joints(model: RobotModel, srdf: Srdf) -> set[str]:
    """The joints that MoveIt omits from trajectories."""
    joints = {
        joint.name for joint in model.joints if joint.kind == "fixed" or joint.mimic is not None
    }
    elements = (*srdf.root.all("virtual_joint"), *srdf.root.all("passive_joint"))
    return joints.union(element.get("name") or "" for element in elements)


def unknown_type(entry: Mapping[str, Node]) -> Value | None:
    """The type of a controller of MoveIt that MoveIt 2 does not have; None if it has it."""
    kind = entry.get("type")
    is_known = not isinstance(kind, Value) or kind.text in TYPES or "$" in kind.text
    return None if is_known or not isinstance(kind, Value) else kind


def defined_controllers(context: Context, srdf: Srdf) -> Iterator[Controller]:
    """The ROS 2 controllers in YAML files of the workspaces of the robot and the SRDF."""
    resolver = context.resolver
    workspaces = {resolver.packages.workspace(path) for path in (context.source.path, srdf.path)}
    for workspace in sorted(workspaces):
        files = resolver.directories.files_below(workspace, _MAX_DIRECTORIES)
        yaml_files = (path for path in files if path.endswith((".yaml", ".yml")))
        for path in islice(yaml_files, _MAX_FILES):
            source = resolver.readable(path)
            if source and b"controller_manager" in source.data:
                yield from (controller for controller in read(source) if controller.ros == 2)
