"""A command range or initial value in `<ros2_control>` does not fit the limits of its joint.

- The range of a command interface exceeds the joint limit. From ROS 2 Jazzy on, the narrower range
  applies; in Humble the hardware reads only `min` and `max`, and may drive the joint past its
  limit. Usually the limits were changed but `<ros2_control>` was not.
- The range is empty: `min` is greater than `max` (error), or equal to it. From Jazzy on, the
  resource manager clamps commands to it.
- `initial_value`, at which simulated and mock hardware start, is outside the joint limits. The
  first command makes the joint jump, MoveIt rejects the start state ("start state out of bounds"),
  and Gazebo pushes the joint back with full force.

Sources:
    ros2_control, joint limiting: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/joint_limiting.rst
    ros2_control, mock components: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/mock_components_userdoc.rst
    gz_ros2_control, gz_system.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_system.cpp
    MoveIt, check_start_state_bounds.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/planning_request_adapter_plugins/src/check_start_state_bounds.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.samples import element_xml, robot_xml
from urdfkit.ros.gazebo.samples import SHOULDER, control_xml
from urdfkit.ros.ros_control import Component, ControlPart, Interface, components
from urdfkit.text.document import Element

_RANGE = '<param name="min">-1</param>', '<param name="max">1.5</param>'
_COMMAND = element_xml('command_interface name="position"', *_RANGE)
BAD = robot_xml(
    SHOULDER,
    control_xml("mock_components/GenericSystem", element_xml('joint name="shoulder"', _COMMAND)),
)
GOOD = BAD.replace("1.5", "0.9")

#: Tolerance of a range, relative: radians are often rounded to three digits.
TOLERANCE = 0.01
#: Tolerance of an initial value, in rad or m.
ROUNDING = 1e-3
#: Places that a finding lists after the first.
_MAX_RELATED = 20


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    joints = context.model.joints_by_name
    for component in components(context.model):
        yield from _wider_ranges(component, joints)
        for part in component.parts:
            for interface in part.interfaces:
                yield from _empty_range(part, interface)
                joint = joints.get(part.name)
                if joint and part.kind == "joint" and interface.name == "position":
                    yield from _initial_value(joint, interface)


def _wider_ranges(component: Component, joints: dict[str, Joint]) -> Findings:
    """One finding for each block: usually all of its ranges are out of date."""
    wider = [
        bound
        for part in component.joints
        if (joint := joints.get(part.name))
        for interface in part.of("command")
        if (bound := _wider(joint, interface))
    ]
    if wider:
        (at, message), *others = wider
        more = f", and {len(others)} more in {component.called}" if others else ""
        yield Finding(
            at,
            message + more,
            "use the values of the joint's <limit> as min and max",
            related=tuple(Related(place.span, text) for place, text in others[:_MAX_RELATED]),
        )


def _wider(joint: Joint, interface: Interface) -> tuple[Element, str] | None:
    """The bound of an interface that is outside the joint's limit, and the message."""
    limits = _limits(joint, interface.name)
    if limits is None or _is_empty(interface):  # an empty range is reported separately
        return None
    lower, upper, unit_name = limits
    tolerance = TOLERANCE * max(abs(lower), abs(upper))
    values = {name: interface.bound(name) for name in ("min", "max")}
    outside = [
        name
        for name, value in values.items()
        if value is not None and not lower - tolerance <= value <= upper + tolerance
    ]
    at = interface.parameter(outside[0]) if outside else None
    if at is None:
        return None
    range_ = ", ".join("..." if value is None else f"{value:g}" for value in values.values())
    return at, (
        f"joint '{joint.name}': the range of command_interface '{interface.name}', [{range_}] "
        f"{unit_name}, exceeds the joint limit [{lower:g}, {upper:g}] {unit_name}"
    )


def _limits(joint: Joint, interface: str) -> tuple[float, float, str] | None:
    """Lower limit, upper limit and unit of a joint; None without limits."""
    if interface == "position":
        limits = bounds(joint)
        return (*limits, joint.unit) if limits and limits[0] < limits[1] else None
    limit = joint.limit
    most = {"velocity": limit.velocity, "effort": limit.effort}.get(interface) if limit else None
    if most is None or most.value <= 0:
        return None
    unit_name = f"{joint.unit}/s" if interface == "velocity" else joint.effort_unit
    return -most.value, most.value, unit_name


def _is_empty(interface: Interface) -> bool:
    least, greatest = interface.bound("min"), interface.bound("max")
    if least is None or greatest is None:
        return False
    return least > greatest or least == greatest != 0


def _empty_range(part: ControlPart, interface: Interface) -> Findings:
    at = interface.parameter("min")
    if at is None or not _is_empty(interface):
        return
    least, greatest = interface.bound("min"), interface.bound("max")
    who = f"{part.kind} '{part.name}', {interface.name}"
    if least == greatest:
        message = f"{who}: min and max are both {least:g}"
        yield Finding(at, message, "write the least value as min and the greatest as max")
    else:
        message = f"{who}: min {least:g} > max {greatest:g}"
        yield Finding(at, message, "swap min and max", severity=Severity.ERROR)


def _initial_value(joint: Joint, interface: Interface) -> Findings:
    limits = _limits(joint, "position")
    value, at = interface.bound("initial_value"), interface.parameter("initial_value")
    if limits is None or value is None or at is None:
        return
    lower, upper, unit_name = limits
    if not lower - ROUNDING <= value <= upper + ROUNDING:
        yield Finding(
            at,
            f"joint '{joint.name}': initial_value {value:g} {unit_name} is outside the joint limit "
            f"[{lower:g}, {upper:g}] {unit_name}",
            "write a value within the limits, or correct the limits",
        )
