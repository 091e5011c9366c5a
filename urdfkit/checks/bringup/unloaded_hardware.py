"""Hardware interfaces of ros2_control, and plugins, that the started programs do not load."""

import re

from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.catalog.ros_control import simulated_hardware
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawning import model_spawner, spawns_sdf
from urdfkit.ros.ros_control import Component, components, control_plugins
from urdfkit.ros.targets import CLASSIC, GZ, target_of_plugin
from urdfkit.text.comments import blank_comments

CONTROL_NODE = "ros2_control_node"
MOCK = ("mock_components/GenericSystem", "fake_components/GenericSystem")
#: Names of hardware that may be that of a simulator.
SIMULATED = re.compile(r"(?i)gazebo|gz|ign|sim|mujoco|webots|isaac|mock|fake|topic_based")
#: Hardware that only Gazebo's plugin loads.
_OF_GAZEBO = ("gazebo_ros2_control/", "gz_ros2_control/", "ign_ros2_control/")
#: The package of the programs that spawn models in Gazebo Classic.
_OF_CLASSIC = "gazebo_ros"
_TITLES = {CLASSIC: "Gazebo Classic", GZ: "gz-sim"}


def unloaded_hardware(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Hardware of a robot in Gazebo that Gazebo's control plugin does not load.

    It is mock hardware, or the files of the robot also name that of Gazebo, for other arguments.
    A launch file may describe its robot again, for MoveIt alone.
    """
    if not any(map(model_spawner, programs)):
        return
    robots = list(context.described_robots)
    simulated = {
        description.path
        for description, robot in robots
        if any(component.hardware.startswith(_OF_GAZEBO) for component in components(robot.model))
    }
    for description, robot in robots:
        if not description.is_whole or description.path in simulated:
            continue
        plugins = control_plugins(robot.model)
        hardware = components(robot.model)
        is_mock = hardware and all(component.hardware in MOCK for component in hardware)
        is_real = not any(map(may_be_simulated, hardware)) and _names_simulator(robot)
        for component in hardware if plugins and (is_mock or is_real) else ():
            yield Finding(
                Location((component.plugin or component.at).span, description.frame),
                f"{component.called}: {plugins[0].filename} does not load {component.hardware}, "
                "so the simulated robot does not move",
                "use the hardware of the simulator in a launch file with Gazebo",
                related=(Related(plugins[0].at.span, "control plugin"),),
            )


def may_be_simulated(component: Component) -> bool:
    """True for the hardware of a simulator, by its name."""
    return not component.hardware or SIMULATED.search(component.hardware) is not None


def _names_simulator(robot: Context) -> bool:
    """True if a file of the robot contains the name of Gazebo's hardware, outside of comments."""
    sources = robot.reading.xacro.sources if robot.reading.xacro else ()
    names = [f">{name}<".encode() for name in simulated_hardware()]
    texts = (blank_comments(source.data) for source in sources)
    return any(name in text for text in texts for name in names)


def hardware_without_simulator(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Hardware of Gazebo in ros2_control_node, without Gazebo."""
    managers = [node for node in programs if node.executable == CONTROL_NODE]
    if not managers or any(map(model_spawner, programs)):
        return
    for description, robot in context.described_robots:
        for component in components(robot.model) if description.is_whole else ():
            if component.hardware.startswith(_OF_GAZEBO):
                yield Finding(
                    Location((component.plugin or component.at).span, description.frame),
                    f"{component.called}: ros2_control_node does not load "
                    f"{component.hardware}, only Gazebo's plugin does",
                    "use the hardware of the robot, or mock_components/GenericSystem, in a launch "
                    "file without a simulator",
                    related=(Related(managers[0].span, "the controller manager"),),
                )


def plugins_of_another_gazebo(context: Context) -> Findings:
    """A robot whose plugins are all for Gazebo Classic, and that gz-sim spawns; or the reverse."""
    spawners = [program for program in context.launch.programs if model_spawner(program)]
    packages = {program.package == _OF_CLASSIC for program in spawners}
    if len(packages) != 1 or any(map(spawns_sdf, spawners)):
        return  # the robot in Gazebo may not be the described one
    own, others = (CLASSIC, GZ) if packages.pop() else (GZ, CLASSIC)
    name, other = (_TITLES[family] for family in (own, others))
    for description, robot in context.described_robots:
        targets = {use: target_of_plugin(use.filename, use.at) for use in robot.plugins}
        if not description.is_whole or not targets or not set(targets.values()) <= {*others}:
            continue
        use = next((use for use in targets if "control" in use.filename), next(iter(targets)))
        yield Finding(
            Location(use.at.attributes["filename"].span, description.frame),
            f"{name} does not load {use.title}, which is for {other}",
            "choose the plugins by an argument, or start the other Gazebo",
            related=(Related(spawners[0].span, f"spawned in {name}"),),
        )
