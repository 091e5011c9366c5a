"""The range of a command interface is wider than the limit of its joint.

From ROS 2 Jazzy on the narrower of the two counts; in Humble the hardware sees only `min` and `max`
and may drive the joint past its limit. One of the two is wrong: usually the limits were changed
and the block of ros2_control was forgotten.

Sources:
    ros2_control, joint limiting: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/joint_limiting.rst
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import bounds, effort_unit, unit
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint
    from urdfkit.ros.ros_control import Interface
    from urdfkit.text.document import Element

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="10" velocity="1"/>
</joint>
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position">
      <param name="min">-1</param>
      <param name="max">1.5</param>
    </command_interface>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace("1.5", "0.9")

#: Relative; people round radians to three digits.
TOLERANCE = 0.01

#: Places that a finding lists beside the first.
_MAX_RELATED = 20


@rule(
    "RCT009",
    "command-range-wider-than-limit",
    Severity.WARNING,
    help="make min and max those of the joint's <limit>",
)
def check(subject: Subject) -> Iterator[Finding]:
    """One finding for each block: who forgets one range forgets all of them."""
    for component in components(subject.model):
        wider = [
            found
            for part in component.joints
            if (joint := subject.model.joints_by_name.get(part.name))
            for interface in part.of("command")
            if (found := _wider(joint, interface))
        ]
        if wider:
            (at, message), *others = wider
            more = f", and {len(others)} more in {component.called}"
            yield Finding(
                at,
                message + (more if others else ""),
                related=tuple(
                    Related(place.span, reported) for place, reported in others[:_MAX_RELATED]
                ),
            )


def _wider(joint: Joint, interface: Interface) -> tuple[Element, str] | None:
    """The bound of an interface that is outside the joint's limit, and what to say."""
    limits = _limits(joint, interface.name)
    if limits is None:
        return None
    lower, upper, of = limits
    slack = TOLERANCE * max(abs(lower), abs(upper))
    bounds_of = {name: interface.bound(name) for name in ("min", "max")}
    outside = [
        name
        for name, value in bounds_of.items()
        if value is not None and not lower - slack <= value <= upper + slack
    ]
    at = interface.parameter(outside[0]) if outside else None
    if at is None:
        return None
    range_ = ", ".join("..." if value is None else f"{value:g}" for value in bounds_of.values())
    return at, (
        f"joint '{joint.name}': the range of command_interface '{interface.name}', [{range_}] "
        f"{of}, exceeds the joint limit [{lower:g}, {upper:g}] {of}"
    )


def _limits(joint: Joint, interface: str) -> tuple[float, float, str] | None:
    """The least and greatest value that the joint allows, and the unit."""
    if interface == "position":
        found = bounds(joint)
        if found is None or found[0] >= found[1]:  # JNT003, JNT004
            return None
        return (*found, unit(joint))
    limit = joint.limit
    placed = {"velocity": limit.velocity, "effort": limit.effort}.get(interface) if limit else None
    if placed is None or placed.value <= 0:  # JNT008
        return None
    return -placed.value, placed.value, _unit_of(joint, interface)


def _unit_of(joint: Joint, interface: str) -> str:
    return f"{unit(joint)}/s" if interface == "velocity" else effort_unit(joint)
