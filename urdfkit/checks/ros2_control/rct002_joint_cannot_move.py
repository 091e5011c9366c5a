"""A transmission or a block of ros2_control drives a fixed joint.

Nothing can move it. From ROS 2 Jazzy on the controller manager stops with an exception; in Gazebo
the joint is gone, because its links are merged, and gazebo_ros_control of ROS 1 then drives no
joint at all. Give the joint the type that it has in reality, or leave it out. A transmission with a
vendor's interface may stand for a model and drive nothing; it is not reported.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    gazebo_ros_control_plugin.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros_control/src/gazebo_ros_control_plugin.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog import ros_control
from urdfkit.ros.ros_control import (
    ROS1,
    ROS2,
    called,
    components,
    driven_joints,
    reads_transmissions,
)
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Element

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="fixed">
  <parent link="base"/>
  <child link="arm"/>
</joint>
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace('type="fixed"', 'type="continuous"')


@rule(
    "RCT002",
    "joint-cannot-move",
    Severity.WARNING,
    help="give the joint a type that moves, or leave it out",
    by_target=dict.fromkeys((*ROS1, *ROS2), Severity.ERROR),
)
def check(subject: Subject) -> Iterator[Finding]:
    joints = subject.model.joints_by_name
    for element, owner in _driven(subject):
        joint = joints.get(element.get("name") or "")
        if joint and joint.kind == "fixed":
            yield Finding(
                element.attributes["name"],
                f"{owner} drives joint '{joint.name}', which is fixed",
                alike="fixed",
            )


def _driven(subject: Subject) -> Iterator[tuple[Element, str]]:
    for component in components(subject.model):
        for joint in component.joints:
            yield joint.at, component.called
    if subject.model.transmissions and reads_transmissions(subject.targets):
        for element, transmission in driven_joints(subject.model):
            if not _is_of_a_vendor(element):
                yield element, called(transmission)


def _is_of_a_vendor(joint: Element) -> bool:
    """True if a transmission gives a joint interfaces, and ROS has none of them."""
    known = {name.rpartition("/")[2] for name in ros_control.words("transmission", "interfaces")}
    named = {element.text.strip().rpartition("/")[2] for element in joint.all("hardwareInterface")}
    return bool(named) and named.isdisjoint(known)
