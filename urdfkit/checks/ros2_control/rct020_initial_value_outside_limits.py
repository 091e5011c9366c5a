"""A joint starts where its limits do not let it be.

Simulated and mock hardware put the joint at `initial_value`. Outside the limits the first command
makes it jump, MoveIt refuses to plan from there ("start state out of bounds"), and Gazebo pushes
the joint back with all its force.

Sources:
    ros2_control, mock components: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/mock_components_userdoc.rst
    gz_ros2_control, gz_system.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_system.cpp
    MoveIt, check_start_state_bounds.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/planning_request_adapter_plugins/src/check_start_state_bounds.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import bounds, unit
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="column"/>
<link name="carriage"/>
<joint name="lift" type="prismatic">
  <parent link="column"/>
  <child link="carriage"/>
  <axis xyz="0 0 1"/>
  <limit lower="0.1" upper="0.9" effort="500" velocity="0.2"/>
</joint>
<ros2_control name="lift" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="lift">
    <command_interface name="position"/>
    <state_interface name="position">
      <param name="initial_value">0</param>
    </state_interface>
  </joint>
</ros2_control>"""
GOOD = BAD.replace(">0<", ">0.1<")

#: In rad or m; people round.
TOLERANCE = 1e-3


@rule(
    "RCT020",
    "initial-value-outside-limits",
    Severity.WARNING,
    help="start within the limits, or widen them if they are wrong",
)
def check(subject: Subject) -> Iterator[Finding]:
    for component in components(subject.model):
        for part in component.joints:
            joint = subject.model.joints_by_name.get(part.name)
            limits = bounds(joint) if joint else None
            if joint is None or limits is None or limits[0] >= limits[1]:  # JNT003, JNT004
                continue
            for interface in part.interfaces:
                value = interface.bound("initial_value")
                at = interface.parameter("initial_value")
                if interface.name != "position" or value is None or at is None:
                    continue
                if not limits[0] - TOLERANCE <= value <= limits[1] + TOLERANCE:
                    yield Finding(
                        at,
                        f"joint '{joint.name}' starts at {value:g} {unit(joint)}, its limit is "
                        f"{limits[0]:g} to {limits[1]:g} {unit(joint)}",
                    )
