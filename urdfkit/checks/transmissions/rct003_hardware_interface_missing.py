"""A joint of a transmission has no hardware interface.

The parser of ROS 1 skips the joint and with it the transmission, so no controller finds the joint:
"Could not find resource". Up to ROS Indigo the tag stood in `<actuator>`; only the one in `<joint>`
counts now. Write `<hardwareInterface>` into the joint.

Sources:
    ros_control, transmission_parser.cpp: https://github.com/ros-controls/ros_control/blob/noetic-devel/transmission_interface/src/transmission_parser.cpp
    ros-controls/ros_control#177: https://github.com/ros-controls/ros_control/issues/177
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import ROS1, called, driven_joints, is_of_pr2, reads_transmissions
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
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
<transmission name="shoulder_transmission">
  <type>transmission_interface/SimpleTransmission</type>
  <joint name="shoulder"/>
  <actuator name="shoulder_motor">
    <mechanicalReduction>50</mechanicalReduction>
  </actuator>
</transmission>"""
GOOD = BAD.replace(
    '<joint name="shoulder"/>',
    """\
<joint name="shoulder">
    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
  </joint>""",
)


@rule(
    "RCT003",
    "hardware-interface-missing",
    Severity.WARNING,
    help="write <hardwareInterface>hardware_interface/...JointInterface</hardwareInterface> "
    "into the joint",
    by_target=dict.fromkeys(ROS1, Severity.ERROR),
)
def check(subject: Subject) -> Iterator[Finding]:
    if not reads_transmissions(subject.targets):
        return
    for joint, transmission in driven_joints(subject.model):
        if _has_interface(joint) or transmission.child("type") is None or is_of_pr2(transmission):
            continue
        misplaced = any(_has_interface(actuator) for actuator in transmission.all("actuator"))
        yield Finding(
            joint,
            f"{called(transmission)}: joint '{joint.get('name') or ''}' "
            "has no <hardwareInterface>"
            + ("; the one in <actuator> does not count" if misplaced else ""),
        )


def _has_interface(element: Element) -> bool:
    return any(found.text.strip() for found in element.all("hardwareInterface"))
