"""A launch file starts a program, a model or a controller twice, or two that exclude each other.

- Two active controllers of one controller manager claim the same command interface of a joint: the
  second fails to activate. Load it with `--inactive`.
- `ros2_control_node` runs twice, or next to Gazebo's plugin, which runs its own controller manager:
  a spawner may reach either.
- A server of Nav2 is started twice: lifecycle managers change the state of both. In ROS 1,
  roslaunch rejects two nodes of one name.
- Two models of one name are spawned in Gazebo, which rejects the second.

Programs with a condition that is known only at run time are ignored.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
    gz_ros2_control: https://control.ros.org/rolling/doc/gz_ros2_control/doc/index.html
    Nav2, lifecycle manager: https://docs.nav2.org/configuration/packages/configuring-lifecycle.html
"""

from urdfkit.checks.bringup.defined_controllers import defined_controllers
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.claims import commanded_joints, commands
from urdfkit.ros.controllers import Controller
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import manager_name, spawned_controllers
from urdfkit.ros.launch.spawning import model_spawner, spawn_option
from urdfkit.ros.ros_control import control_plugins
from urdfkit.text.located_yaml import Value

NAME = "launch/robot.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [
    Node(package="ros_gz_sim", executable="create", arguments=["-topic", "left", "-name", "arm"]),
    Node(package="ros_gz_sim", executable="create", arguments=["-topic", "right", "-name", "arm"]),
]
"""
GOOD = BAD.replace('"right", "-name", "arm"', '"right", "-name", "arm_2"')

_MANAGER = "ros2_control_node"
#: Packages of ROS 1 with such a server.
_OF_ROS1 = ("amcl", "map_server")


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    programs = [node for node in context.launch.programs if node.is_sure]
    yield from _claims(context, programs)
    yield from _second_manager(context, programs)
    yield from _second_server(context, programs)
    yield from _second_model(context)


def _claims(context: Context, programs: list[StartedProgram]) -> Findings:
    """Two controllers that are started with the same command interface of a joint."""
    defined = defined_controllers(context)
    #: The first controller of a claim, and its joint.
    owners: dict[tuple[str | None, str, str], tuple[str, Value]] = {}
    for spawned in spawned_controllers(programs):
        controller = defined.get(spawned.name) if spawned.is_activated else None
        for joint, interface in _claimed(controller) if controller else ():
            claim = (manager_name(spawned.program), joint.text, interface)
            owner, joint_of_owner = owners.setdefault(claim, (spawned.name, joint))
            if controller and owner != spawned.name:
                inactive = "--inactive" if controller.ros == 2 else "--stopped"
                yield Finding(
                    spawned.at,
                    f"controllers '{owner}' and '{spawned.name}' are both started and claim "
                    f"the command interface '{interface}' of joint '{joint.text}'",
                    f"start one of them with {inactive}, or correct its joints",
                    related=(
                        Related(joint_of_owner.span, f"joint of controller '{owner}'"),
                        Related(joint.span, f"joint of controller '{spawned.name}'"),
                    ),
                )
                break


def _claimed(controller: Controller) -> list[tuple[Value, str]]:
    """The joints and command interfaces that a controller claims."""
    joints = commanded_joints(controller)
    return [(joint, interface) for joint in joints for interface in commands(controller)]


def _second_manager(context: Context, programs: list[StartedProgram]) -> Findings:
    """A second controller manager, next to that of Gazebo's plugin."""
    spawners = list(filter(model_spawner, programs))
    if not spawners:
        return
    simulated = Related(spawners[0].span, "the robot is spawned in Gazebo here")
    nodes = [node for node in programs if node.executable == _MANAGER]
    for _, robot in context.described_robots if nodes else ():
        for plugin in control_plugins(robot.model):
            for node in nodes if "ros2_control" in (plugin.at.get("filename") or "") else ():
                yield Finding(
                    node.at,
                    "ros2_control_node is a second controller manager: Gazebo's plugin runs one",
                    "remove ros2_control_node from launch files with Gazebo",
                    related=(Related(plugin.at.span, "the plugin"), simulated),
                )


def _second_server(context: Context, programs: list[StartedProgram]) -> Findings:
    """A second node of one name: of Nav2, slam_toolbox, ros2_control, or navigation in ROS 1."""
    servers = (*data("nodes")["lifecycle"].split(), _MANAGER)
    first: dict[tuple[str, str | None], StartedProgram] = {}
    for node in programs if not context.launch.has_scopes else ():
        if node.executable not in servers or node.namespace is None:
            continue
        other = first.setdefault((node.title, node.namespace), node)
        if other.span != node.span:
            effect = "lifecycle managers change the state of both"
            if node.package in _OF_ROS1:
                effect = "roslaunch rejects two nodes of one name"
            elif node.executable == _MANAGER:
                effect = "a spawner may reach either controller manager"
            yield Finding(
                node.at,
                f"'{node.title}' is started twice: {effect}",
                "start it once",
                related=(Related(other.span, "it is started here, too"),),
            )
            return


def _second_model(context: Context) -> Findings:
    """A second model with the name of the first, which Gazebo rejects."""
    first: dict[str, StartedProgram] = {}
    for node in context.launch.started:
        names = (spawn_option(node, name) for name in ("name", "entity", "model"))
        word = next(filter(None, names), None)
        may_rename = any("allow_renaming" in (item.text or "") for item in node.words)
        spaces = [spawn_option(node, name) for name in ("world", "gazebo_namespace")]
        is_own = node.is_sure and node.frame is None
        if word is None or not word.text or may_rename or any(spaces) or not is_own:
            continue
        other = first.setdefault(word.text, node)
        if other is not node:
            yield Finding(
                Location(word.span, node.frame),
                f"Gazebo has a model '{word.text}' already: the second one is not spawned",
                "give it another name",
                related=(Related(other.span, "the first is spawned here"),),
            )
