"""A controller of MoveIt does not match the controllers of ros2_control.

- No parameter file of ros2_control in the workspace defines the controller of
  `moveit_controllers.yaml`, while another controller commands its joints.
- The controller has other joints than in ros2_control, and rejects each trajectory: "Joints on
  incoming trajectory don't match the controller joints". Fixed, mimic, passive and virtual joints
  are ignored.
- It has another type or action (warning): "Action client not connected". Or it has none.
- No launch file names the controller, while a spawner loads another one of the file (warning).

Sources:
    MoveIt, controllers: https://moveit.picknik.ai/main/doc/examples/controller_configuration/controller_configuration_tutorial.html
    ros2_controllers, joint_trajectory_controller: https://control.ros.org/rolling/doc/ros2_controllers/joint_trajectory_controller/doc/userdoc.html
    ros-controls/gz_ros2_control#456: https://github.com/ros-controls/gz_ros2_control/issues/456
"""

from itertools import chain

from urdfkit.checks.srdf.trajectories import (
    defined_controllers,
    omitted_joints,
    unknown_type,
)
from urdfkit.core.grouping import by_key
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.controllers import Controller
from urdfkit.ros.gazebo.samples import SHOULDER
from urdfkit.ros.launch.contents import Word
from urdfkit.ros.launch.robot_arguments import launches_of_workspace
from urdfkit.ros.launch.spawned_controllers import MANAGER, spawned_controllers
from urdfkit.ros.moveit.samples import configurations, named_xml
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.located_yaml import Key, Node, Value, scalars
from urdfkit.workspace.launch_files import MAX_FILES, launch_files
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.ros_packages import comes_with_ros

BAD = named_xml("bad", SHOULDER)
GOOD = BAD.replace('"bad"', '"good"')
_CONTROLLERS = """\
moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
moveit_simple_controller_manager:
  controller_names: [shoulder_controller]
  shoulder_controller:
    {type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [shoulder]}
"""
FILES = configurations(
    "moveit_controllers.yaml", _CONTROLLERS, _CONTROLLERS.replace("shoulder_", "arm_")
) | {
    "ros2_controllers.yaml": b"""\
controller_manager:
  ros__parameters:
    arm_controller: {type: joint_trajectory_controller/JointTrajectoryController}
arm_controller: {ros__parameters: {joints: [shoulder]}}
"""
}

#: Functions of MoveIt that spawn all of its controllers.
_SPAWNING_ALL = (b"generate_spawn_controllers", b"generate_demo_launch")
#: Controllers that have topics only.
_WITHOUT_ACTION = (
    "position_controllers/JointGroupPositionController",
    "velocity_controllers/JointGroupVelocityController",
    "effort_controllers/JointGroupEffortController",
    "forward_command_controller/ForwardCommandController",
    "forward_command_controller/MultiInterfaceForwardCommandController",
)
_TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
_GRIPPER = "/GripperActionController"


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF), reports_missing=True)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    manifest = manifest_of(context.resolver, srdf.path)
    if manifest is None or manifest.ros != 2:
        return
    entries = list(context.moveit_config.controller_entries())
    controllers = defined_controllers(context, srdf) if entries else ()
    defined = by_key((controller.name, controller) for controller in controllers)
    served = {
        joint for key, entry in entries if key.strip("/") in defined for joint in _joints(entry)
    }
    for key, entry in entries:
        name = key.strip("/")
        # It may run in the namespace that the key begins with.
        same = defined.get(name) or defined.get(name.rpartition("/")[2])
        if same is None:
            yield from _undefined(key, entry, served, defined)
            continue
        yield from _action(key, entry, same)
        yield from _other_joints(key, entry, same, omitted_joints(context.model, srdf))
        yield from _other_finger(key, entry, same)
    yield from _not_spawned(context, srdf, [key for key, _ in entries if key.strip("/") in defined])


def _undefined(
    key: Key, entry: dict[str, Node], served: set[str], defined: dict[str, list[Controller]]
) -> Findings:
    """A controller that is not defined, while another controller commands its joints."""
    joints = _joints(entry)
    controllers = (one for one in chain.from_iterable(defined.values()) if not _only_reads(one))
    other = next(
        (controller for controller in controllers if joints & _commanded(controller)), None
    )
    # With an unknown type, MoveIt ignores it (SRD028).
    if other is not None and joints.isdisjoint(served) and not unknown_type(entry):
        help = f"write {other.name}, or define '{key}'"
        if other.type in _WITHOUT_ACTION:
            help = f"define '{key}' as a {_TRAJECTORY}: {other.type} has no action"
        yield Finding(
            key.span,
            f"controller '{key}' is not defined in a parameter file of ros2_control; "
            f"'{other.name}' commands its joints",
            help,
            related=(Related(other.type_at, f"controller '{other.name}'"),),
        )


def _not_spawned(context: Context, srdf: Srdf, keys: list[Key]) -> Findings:
    """A controller that no launch file of the workspace names, while a spawner loads another."""
    directory = context.resolver.packages.workspace(srdf.path)
    if context.resolver.packages.workspace(context.source.path) != directory:
        return
    texts = [source.data for source in launch_files(directory, "", context.resolver)]
    is_whole = len(texts) < MAX_FILES
    if not is_whole or any(mark in text for text in texts for mark in _SPAWNING_ALL):
        return
    unnamed = [key for key in keys if not any(key.strip("/").encode() in text for text in texts)]
    spawned = _spawned(srdf.path, context.resolver) if unnamed else {}
    other = next((spawned[key] for key in keys if key in spawned), None)
    if other is None:
        return
    for key in unnamed:
        yield Finding(
            key.span,
            f"no launch file of the workspace spawns controller '{key}': MoveIt cannot connect to "
            "its action",
            f"spawn '{key}', too",
            related=(Related(other.span, f"controller '{other.text}' is spawned here"),),
            severity=Severity.WARNING,
        )


def _spawned(path: str, resolver: Resolver) -> dict[str, Word]:
    """The controllers that the launch files of a workspace spawn; empty if some are unknown."""
    launches = launches_of_workspace(path, resolver)
    packages = [package for launch in launches for package in launch.packages]
    programs = [program for launch in launches for program in launch.programs]
    spawners = [program for program in programs if program.package in (MANAGER, "")]
    is_whole = all(package.searched is None or comes_with_ros(package.name) for package in packages)
    if not is_whole or any(word.text is None for node in spawners for word in node.words):
        return {}
    return {spawned.word.text or "": spawned.word for spawned in spawned_controllers(spawners)}


def _other_joints(
    key: Key, entry: dict[str, Node], same: list[Controller], omitted: set[str]
) -> Findings:
    """A trajectory controller with other joints, which rejects each trajectory."""
    joints = _joints(entry)
    known = [
        controller
        for controller in same
        if controller.type == _TRAJECTORY and _commanded(controller)
    ]
    partial = filter(_is_partial, same)
    if not joints or not known or any(_commanded(controller) >= joints for controller in partial):
        return
    moved = joints - omitted
    if any(
        _commanded(controller) in (joints, moved) or _has_unknown_joints(controller)
        for controller in known
    ):
        return
    yield _differing(key, joints, joints - omitted, known[0])


def _other_finger(key: Key, entry: dict[str, Node], same: list[Controller]) -> Findings:
    """A gripper controller that moves none of the joints: MoveIt may list mimic joints, too."""
    joints = _joints(entry)
    commanded = set[str]().union(*map(_commanded, same))
    are_grippers = all(controller.type.endswith(_GRIPPER) for controller in same)
    is_known = joints and commanded and not any(map(_has_unknown_joints, same))
    if are_grippers and is_known and joints.isdisjoint(commanded):
        yield _differing(key, joints, joints, same[0])._replace(severity=Severity.WARNING)


def _differing(key: Key, joints: set[str], moved: set[str], controller: Controller) -> Finding:
    commanded = _commanded(controller)
    differing = few([*sorted(moved - commanded), *sorted(commanded - joints)], 4)
    return Finding(
        key.span,
        f"controller '{key}' has other joints here than in ros2_control: {differing}",
        "list the same joints in both files",
        related=(Related(controller.type_at, f"controller '{key}'"),),
    )


def _action(key: Key, entry: dict[str, Node], same: list[Controller]) -> Findings:
    """A type or an action that the controller does not have."""
    kinds = {tuple(data("moveit")["actions"].get(controller.type, ())) for controller in same}
    action = kinds.pop() if len(kinds) == 1 else ()
    for name, expected in zip(("type", "action_ns"), action, strict=False):
        value = entry.get(name)
        if value is None:
            message = f"controller '{key}' has no {name}"
            yield Finding(key.span, message, f"write {name}: {expected}")
        elif isinstance(value, Value) and value.text.strip("/") != expected:
            message = f"{name} of controller '{key}' is '{value.text}', but "
            message += f"{same[0].type} serves '{expected}'"
            # A controller of the real robot may have the same name and another action.
            help = f"write {expected}"
            yield Finding(value.span, message, help, severity=Severity.WARNING)
            return


def _commanded(controller: Controller) -> set[str]:
    return {value.text for value in controller.values(["joints", "joint"])}


def _only_reads(controller: Controller) -> bool:
    """True for a broadcaster, which may also have a list of joints."""
    return controller.type.lower().endswith("broadcaster")


def _is_partial(controller: Controller) -> bool:
    allowed = controller.section.values("allow_partial_joints_goal")
    return any(value.boolean for value in allowed)


def _has_unknown_joints(controller: Controller) -> bool:
    """True if the joints of a controller are known only at run time."""
    return any(mark in joint for joint in _commanded(controller) for mark in "$<{")


def _joints(entry: dict[str, Node]) -> set[str]:
    return {value.text for value in scalars(entry.get("joints"))}
