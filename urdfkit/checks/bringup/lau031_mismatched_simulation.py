"""Nodes or hardware do not match the simulation that the launch file starts, or does not start.

- A filter or a planner uses the wall clock, while Gazebo and other nodes use simulation time
  (`use_sim_time`): its transforms are years newer than the data. An info for
  robot_state_publisher, which keeps the stamps of the joint states.
- Nodes use `use_sim_time`, but no bridge forwards Gazebo's `/clock`: their time stays zero. Or the
  controller manager of a robot that is not simulated uses it.
- Controllers are spawned in a gz sim that is started without `-r`: the simulation is paused, and
  no controller becomes active. An info without controllers.
- The `<ros2_control>` of a robot in Gazebo is `mock_components/GenericSystem`, which Gazebo's
  plugin does not load, or that of the real robot, although its files also name that of Gazebo. Or
  `ros2_control_node` runs hardware of Gazebo, but no robot is spawned in Gazebo: "class
  gz_ros2_control/GazeboSimSystem does not exist".

A launch file is not checked if it includes unavailable files that are not part of ROS.

Sources:
    ROS 2, clock and time: https://design.ros2.org/articles/clock_and_time.html
    ros-controls/gz_ros2_control#474: https://github.com/ros-controls/gz_ros2_control/issues/474
    ros-controls/gz_ros2_control#720: https://github.com/ros-controls/gz_ros2_control/issues/720
    Ekumen-OS/andino_gz#39: https://github.com/Ekumen-OS/andino_gz/issues/39
"""

from urdfkit.checks.bringup.known_programs import known_programs
from urdfkit.checks.bringup.simulation_time import (
    missing_clock,
    stopped_controllers,
    wall_clock_nodes,
)
from urdfkit.checks.bringup.unloaded_hardware import (
    hardware_without_simulator,
    unloaded_hardware,
)
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.ros.launch.spawning import model_spawner
from urdfkit.ros.launch.worlds import worlds

NAME = "launch/simulation.launch.py"
BAD = """\
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

actions = [
    ExecuteProcess(cmd=["gz", "sim", "empty.sdf"]),
    Node(package="ros_gz_sim", executable="create", arguments=["-string", "<robot/>"]),
    Node(package="controller_manager", executable="spawner", arguments=["arm_controller"]),
]
"""
GOOD = BAD.replace('"sim", ', '"sim", "-r", ')


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    programs = known_programs(context)
    yield from wall_clock_nodes(context, programs)
    yield from missing_clock(context, programs)
    yield from stopped_controllers(context, programs)
    yield from _paused(context, programs)
    yield from unloaded_hardware(context, programs)
    yield from hardware_without_simulator(context, programs)


def _paused(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A gz sim that starts paused."""
    if not any(map(model_spawner, programs)):
        return
    waiting = any(controller.is_activated for controller in spawned_controllers(programs))
    for world in worlds(context.launch):
        if world.is_paused and world.is_sure:
            effect = "no controller becomes active" if waiting else "nothing moves"
            yield Finding(
                world.at,
                f"Gazebo starts paused: {effect} until Play is pressed",
                "write -r before the world",
                severity=None if waiting else Severity.INFO,
            )
