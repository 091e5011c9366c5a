"""The update rate of the controllers or a sensor is higher than the step rate of the physics.

Controllers and sensors in Gazebo are updated at most once per step. If the controller manager has a
higher `update_rate`, Gazebo prints "desired controller update period is faster than the gazebo
simulation period", and the controllers run at the step rate, with gains and filters for another
rate; a sensor also publishes at the step rate. Use a shorter step (`<max_step_size>`, 0.001 s by
default) or a lower rate.

Sources:
    gz_ros2_control: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_ros2_control_plugin.cpp
    gazebo_ros2_control: https://github.com/ros-controls/gazebo_ros2_control/blob/master/gazebo_ros2_control/src/gazebo_ros2_control_plugin.cpp
    gz-sim, SimulationRunner.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/SimulationRunner.cc
    SDF, physics: http://sdformat.org/spec?ver=1.9&elem=physics
"""

from collections.abc import Iterator

from urdfkit.checks.worlds.opened_worlds import opened_worlds
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.values import number
from urdfkit.ros.controllers import managers
from urdfkit.ros.gazebo.samples import gazebo_xml, sensor_xml, solid_xml
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.ros.gazebo.worlds import DEFAULT_STEP
from urdfkit.ros.launch.samples import CART_LAUNCH, world_files
from urdfkit.ros.launch.worlds import GZ
from urdfkit.text.source import Span

NAME = "launch/robot.launch.py"
BAD = CART_LAUNCH
GOOD = BAD.replace("bad.sdf", "good.sdf")
_PHYSICS = '<physics name="fast" type="dart"><max_step_size>{}</max_step_size></physics>'
_IMU = sensor_xml("tilt", "imu", "<update_rate>500</update_rate>")
FILES = world_files(
    _PHYSICS.format("0.01"),
    _PHYSICS.format("0.002"),
    solid_xml("base"),
    gazebo_xml(_IMU, reference="base"),
)

#: Greatest rate relative to 1 / step, which may be rounded: 0.00833 s is 120 Hz.
_TOLERANCE = 1.01


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for opened in opened_worlds(context):
        world = opened.world
        if world is None and opened.path:
            continue
        is_gz = opened.started.generation == GZ  # which takes the first
        if world is not None and len(world.at.all("physics")) > 1 and not is_gz:
            continue  # one of them is selected at run time
        step = world.step.value if world is not None else DEFAULT_STEP
        places = (Related(world.step.span, f"a step of {step:g} s"),) if world is not None else ()
        for rate, at, who in _rates(context):
            if rate * step > _TOLERANCE:
                yield Finding(
                    at,
                    f"{who}: update rate is {rate:g} Hz, but {opened.title} steps "
                    f"at {1 / step:g} Hz",
                    f"write {1 / step:g} or less, or a <max_step_size> of {1 / rate:.3g} s",
                    related=(*places, *opened.note),
                )


def _rates(context: Context) -> Iterator[tuple[float, Span, str]]:
    """Update rates in Gazebo: rate in Hz, location, and controller manager or sensor."""
    for _, robot in context.described_robots:
        for _, section in managers(robot):
            for value in section.values("update_rate"):
                if rate := number(value.text):
                    yield rate, value.span, "controller_manager"
        for sensor in sensors(robot.model):
            written = sensor.number("update_rate")
            if written is not None:
                yield written.value, written.span, sensor.who
