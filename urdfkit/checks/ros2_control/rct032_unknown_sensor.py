"""A sensor of `<ros2_control>` has no counterpart in Gazebo, or a broadcaster names an unknown one.

Sensors are matched by name. A `<sensor>` in `<ros2_control>` without a `<sensor>` of the same name
in `<gazebo>` has no data in the simulator: an info if its interfaces are not those of an IMU or a
force-torque sensor, the only sensors that Gazebo's hardware reads. A broadcaster whose
`sensor_name` is not a `<sensor>` in `<ros2_control>` cannot be activated, unless the hardware
driver exports unlisted sensors: with hardware of the robot's own, only typos are reported. Nor can
one that names an interface of such a sensor, or an admittance controller whose `ft_sensor` is none.

Sources:
    gazebo_ros2_control, gazebo_system.cpp: https://github.com/ros-controls/gazebo_ros2_control/blob/master/gazebo_ros2_control/src/gazebo_system.cpp
    gz_ros2_control, gz_system.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_system.cpp
    imu_sensor_broadcaster.cpp: https://github.com/ros-controls/ros2_controllers/blob/master/imu_sensor_broadcaster/src/imu_sensor_broadcaster.cpp
    force_torque_sensor_broadcaster.cpp: https://github.com/ros-controls/ros2_controllers/blob/master/force_torque_sensor_broadcaster/src/force_torque_sensor_broadcaster.cpp
"""

import re

from urdfkit.core.suggest import Suggester, did_you_mean
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import element_xml, robot_xml
from urdfkit.ros.catalog.ros_control import simulated_hardware
from urdfkit.ros.claims import named_sensors
from urdfkit.ros.gazebo.samples import control_xml, gazebo_xml, sensor_xml, solid_xml
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.ros.ros_control import Component, components
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.located_yaml import is_template

BAD = robot_xml(
    solid_xml("base"),
    gazebo_xml(sensor_xml("base_imu", "imu", "<update_rate>100</update_rate>"), reference="base"),
    control_xml(
        "gz_ros2_control/GazeboSimSystem",
        element_xml('sensor name="base_immu"', '<state_interface name="orientation.x"/>'),
    ),
)
FIXED = GOOD = BAD.replace("base_immu", "base_imu")

#: State interfaces of the sensors that Gazebo's hardware reads.
_SIMULATED = re.compile(r"(orientation|angular_velocity|linear_acceleration|force|torque)\.[xyzw]")
_MOCK = ("mock_components/", "fake_components/")


@rule(Severity.WARNING, reports_missing=True)
def check(context: Context) -> Findings:
    blocks = components(context.model)
    if not context.is_part:
        yield from _not_in_gazebo(context, blocks)
    yield from _not_in_ros2_control(context, blocks)


def _not_in_gazebo(context: Context, blocks: list[Component]) -> Findings:
    simulated = {sensor.name for sensor in sensors(context.model)}
    suggester = Suggester(simulated)
    for component in blocks:
        for part in component.parts if component.hardware in simulated_hardware() else ():
            name = part.at.attributes.get("name")
            if part.kind != "sensor" or name is None or name.value in simulated:
                continue
            suggested, hint = suggester.suggested(name.value), suggester.hint(name.value)
            message = f"sensor '{name.value}' of <ros2_control> does not exist in <gazebo>{hint}"
            help, severity = "use the same name for both sensors", None
            if not suggested:
                help = "add a <sensor> of this name in <gazebo>, or leave it out for Gazebo"
            if not any(_SIMULATED.fullmatch(one.name) for one in part.of("state")):
                help, severity = "leave it out for Gazebo, which has no such data", Severity.INFO
            yield Finding(name, message, help, fix_value(name, suggested), severity=severity)


def _not_in_ros2_control(context: Context, blocks: list[Component]) -> Findings:
    parts = [part for component in blocks for part in component.parts]
    known = {part.name for part in parts if part.kind == "sensor"}
    if not known:
        return  # the broadcaster may be for another robot, and not be started
    exported = {part.name for part in parts}
    # The robot's own hardware may export sensors that its block does not name.
    is_closed = all(map(_is_known, blocks))
    for file, controller in context.controllers:
        for name, value in named_sensors(controller).items():
            # A namespace before the name may be added by the broadcaster.
            is_known = any(other == name or other.endswith(f"/{name}") for other in exported)
            hint = did_you_mean(name, known)
            if name and not is_template(name) and not is_known and (is_closed or hint):
                yield Finding(
                    value.span,
                    f"{controller.title}: sensor '{name}' does not exist in <ros2_control>{hint}",
                    "use the name of a <sensor> in <ros2_control>",
                    related=(file.note,),
                    confidence=Confidence.INFERRED,
                )


def _is_known(component: Component) -> bool:
    """True for hardware that exports the sensors of its block and no others, or is missing."""
    name = component.hardware
    is_listed = name in simulated_hardware() or name.startswith(_MOCK)
    return not name or (is_listed and not component.has_conditional_plugin)
