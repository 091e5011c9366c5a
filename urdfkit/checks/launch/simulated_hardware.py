"""The hardware of ros2_control that a simulated robot is started with."""

from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawning import spawner_of
from urdfkit.ros.ros_control import components, control_plugins

#: Hardware that Gazebo's plugin alone loads.
_OF_GAZEBO = ("gazebo_ros2_control/", "gz_ros2_control/", "ign_ros2_control/")
_MOCK = ("mock_components/GenericSystem", "fake_components/GenericSystem")


def mock_hardware(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """A robot with Gazebo's control plugin, which loads none of its mock hardware."""
    if not any(map(spawner_of, started)):
        return
    for description, robot in context.described_robots:
        if not description.is_whole:
            continue
        plugins = control_plugins(robot.model)
        found = components(robot.model)
        is_mock = found and all(one.hardware in _MOCK for one in found)
        for one in found if plugins and is_mock else ():
            yield Finding(
                Location((one.plugin or one.at).span, description.frame),
                f"{one.called}: {plugins[0].filename} does not load {one.hardware}, so nothing of "
                "the simulated robot moves",
                "choose the hardware of the simulator where the launch file simulates",
                related=(Related(plugins[0].at.span, "control plugin"),),
            )


def without_simulator(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """A controller manager of its own for hardware that Gazebo's plugin alone loads."""
    managers = [one for one in started if one.executable == "ros2_control_node"]
    if not managers or any(map(spawner_of, started)):
        return
    for description in context.launch.descriptions:
        robot = context.other_robot(description.path, description.arguments)
        if not description.is_whole or robot.reading.document is None:
            continue
        for one in components(robot.model):
            if one.hardware.startswith(_OF_GAZEBO):
                yield Finding(
                    Location((one.plugin or one.at).span, description.frame),
                    f"{one.called}: ros2_control_node does not load {one.hardware}, which Gazebo's "
                    "plugin alone does",
                    "choose the hardware of the robot, or mock_components/GenericSystem, where "
                    "the launch file starts no simulator",
                    related=(Related(managers[0].span, "the controller manager"),),
                )
