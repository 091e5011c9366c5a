"""The hardware of ros2_control that a simulated robot is started with."""

from __future__ import annotations

from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawning import spawner_of
from urdfkit.ros.ros_control import components, control_plugins

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
