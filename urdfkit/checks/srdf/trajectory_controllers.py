"""The controllers that MoveIt sends trajectories to, against those of ros2_control."""

from collections.abc import Iterator
from itertools import islice

from urdfkit.core.words import few
from urdfkit.errors import UrdfkitError
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related, Severity
from urdfkit.robot.model import RobotModel
from urdfkit.ros.controllers import Controller, read
from urdfkit.ros.moveit.config import controller_entries
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.located_yaml import Key, Node, Value, scalars
from urdfkit.workspace.manifest import manifest_of

#: Files of the workspace that are read, and directories in which they are searched.
_MAX_FILES, _MAX_DIRECTORIES = 500, 1000
_TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
#: The types of MoveIt and the actions of the controllers that they fit.
_ACTIONS = {
    _TRAJECTORY: ("FollowJointTrajectory", "follow_joint_trajectory"),
    "position_controllers/GripperActionController": ("GripperCommand", "gripper_cmd"),
    "effort_controllers/GripperActionController": ("GripperCommand", "gripper_cmd"),
    "parallel_gripper_action_controller/GripperActionController": (
        "ParallelGripperCommand",
        "gripper_cmd",
    ),
}


def unfit_controllers(context: Context, srdf: Srdf) -> Findings:
    """The controllers of MoveIt 2 that are not there, or that take other trajectories."""
    manifest = manifest_of(context.resolver, srdf.path)
    if manifest is None or manifest.ros != 2:
        return
    entries = list(controller_entries(srdf, context.resolver))
    defined: dict[str, list[Controller]] = {}
    for controller in _defined(context, srdf) if entries else ():
        defined.setdefault(controller.name, []).append(controller)
    served = {
        joint for key, entry in entries if key.strip("/") in defined for joint in _joints(entry)
    }
    for key, entry in entries:
        same = defined.get(key.strip("/"))
        if same is None:
            yield from _undefined(key, entry, served, defined)
            continue
        yield from _action(key, entry, same)
        yield from _other_joints(key, entry, same, _unmoved(context.model, srdf))


def _undefined(
    key: Key, entry: dict[str, Node], served: set[str], defined: dict[str, list[Controller]]
) -> Findings:
    """A controller that is not defined, while another one commands its joints."""
    joints = _joints(entry)
    every = [one for several in defined.values() for one in several]
    other = next((one for one in every if joints & _commanded(one)), None)
    if other is not None and joints.isdisjoint(served):
        yield Finding(
            Location(key.span),
            f"controller '{key}' is defined in no parameter file of ros2_control; "
            f"'{other.name}' commands its joints",
            f"write {other.name}, or define '{key}'",
            related=(Related(other.type_at, f"controller '{other.name}'"),),
        )


def _unmoved(model: RobotModel, srdf: Srdf) -> set[str]:
    """The joints that MoveIt leaves out of the trajectories for its controllers."""
    own = {one.name for one in model.joints if one.kind == "fixed" or one.mimic is not None}
    others = (*srdf.root.all("virtual_joint"), *srdf.root.all("passive_joint"))
    return own.union(one.get("name") or "" for one in others)


def _other_joints(
    key: Key, entry: dict[str, Node], same: list[Controller], unmoved: set[str]
) -> Findings:
    """A trajectory controller with other joints, which rejects each trajectory."""
    joints = _joints(entry)
    known = [one for one in same if one.type == _TRAJECTORY and _commanded(one)]
    if (
        not joints
        or not known
        or any(_commanded(one) >= joints for one in same if _is_partial(one))
    ):
        return
    moved = joints - unmoved
    if any(_commanded(one) in (joints, moved) or _is_open(one) for one in known):
        return
    own = _commanded(known[0])
    differing = few([*sorted(moved - own), *sorted(own - joints)], 4)
    yield Finding(
        Location(key.span),
        f"controller '{key}' has other joints here than in ros2_control: {differing}",
        "list the same joints in both files",
        related=(Related(known[0].type_at, f"controller '{key}'"),),
    )


def _action(key: Key, entry: dict[str, Node], same: list[Controller]) -> Findings:
    """A type or an action that the controller does not have."""
    actions = {_ACTIONS.get(one.type) for one in same}
    expected = actions.pop() if len(actions) == 1 else None
    for name, right in zip(("type", "action_ns"), expected or (), strict=False):
        value = entry.get(name)
        if value is None:
            message = f"controller '{key}' has no {name}"
            yield Finding(Location(key.span), message, f"write {name}: {right}")
        elif isinstance(value, Value) and value.text.strip("/") != right:
            wrong = f"{name} of controller '{key}' is '{value.text}'"
            message = f"{wrong}, but {same[0].type} serves '{right}'"
            # A controller of the real robot may have the same name and another action.
            yield Finding(
                Location(value.span), message, f"write {right}", severity=Severity.WARNING
            )
            return


def _joints(entry: dict[str, Node]) -> set[str]:
    return {one.text for one in scalars(entry.get("joints"))}


def _commanded(controller: Controller) -> set[str]:
    return {value.text for value in controller.values(["joints", "joint"])}


def _is_partial(controller: Controller) -> bool:
    allowed = controller.section.values("allow_partial_joints_goal")
    return any(value.text.lower() == "true" for value in allowed)


def _is_open(controller: Controller) -> bool:
    """True if what it commands is known at run time only."""
    return any(mark in joint for joint in _commanded(controller) for mark in "$<{")


def _defined(context: Context, srdf: Srdf) -> Iterator[Controller]:
    """The controllers of ROS 2 in the YAML files of the workspace of the robot and of the SRDF."""
    resolver = context.resolver
    tops = {resolver.packages.workspace(path) for path in (context.source.path, srdf.path)}
    for top in sorted(tops):
        files = resolver.directories.files_below(top, _MAX_DIRECTORIES)
        named = (path for path in files if path.endswith((".yaml", ".yml")))
        for path in islice(named, _MAX_FILES):
            try:
                source = resolver.read(path)
            except UrdfkitError:
                continue
            if b"controller_manager" in source.data:
                yield from (one for one in read(source) if one.ros == 2)
