"""A transmission lacks its name, its type, a joint or an actuator.

The parser of ROS 1 writes an error into the log and leaves the transmission out, so no controller
finds the joint: "Could not find resource". The type is an element, `<type>`; an attribute is the
form of the PR2, which nothing else reads.

Sources:
    URDF, transmission: https://wiki.ros.org/urdf/XML/Transmission
    ros_control, transmission_parser.cpp: https://github.com/ros-controls/ros_control/blob/noetic-devel/transmission_interface/src/transmission_parser.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import ROS1, called, is_of_pr2, reads_transmissions
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
<transmission name="shoulder_transmission" type="transmission_interface/SimpleTransmission">
  <joint name="shoulder">
    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
  </joint>
  <actuator name="shoulder_motor">
    <mechanicalReduction>50</mechanicalReduction>
  </actuator>
</transmission>"""
GOOD = BAD.replace(
    ' type="transmission_interface/SimpleTransmission">',
    ">\n  <type>transmission_interface/SimpleTransmission</type>",
)


@rule(
    "RCT016",
    "transmission-incomplete",
    Severity.WARNING,
    help="give it a name, <type>transmission_interface/SimpleTransmission</type>, <joint> and "
    "<actuator>",
    by_target=dict.fromkeys(ROS1, Severity.ERROR),
)
def check(subject: Subject) -> Iterator[Finding]:
    if not subject.model.transmissions or not reads_transmissions(subject.targets):
        return
    for transmission in subject.model.transmissions:
        missing = [] if is_of_pr2(transmission) else _missing(transmission)
        if missing:
            message = f"{called(transmission)} has no {' and no '.join(missing)}"
            yield Finding(transmission, message)


def _missing(transmission: Element) -> list[str]:
    kind = transmission.child("type")
    missing: list[str] = []
    if not transmission.get("name"):
        missing.append("name")
    if kind is None or not kind.text.strip():
        attribute = " (the attribute does not count)" if "type" in transmission.attributes else ""
        missing.append(f"<type>{attribute}")
    missing += [f"<{tag}>" for tag in ("joint", "actuator") if transmission.child(tag) is None]
    missing += [
        f"name in its <{child.tag}>"
        for child in transmission.children
        if child.tag in ("joint", "actuator") and not child.get("name")
    ]
    return missing
