"""A transmission of ROS 1 stands in a robot of ROS 2.

Nothing reads it: ros2_control has its own `<transmission>` inside `<ros2_control>`, and the
simulators apply neither. Delete it, or move what it says into the block of ros2_control.

Sources:
    URDF, transmission: https://wiki.ros.org/urdf/XML/Transmission
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import called, reads_transmissions
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

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
  <joint name="shoulder">
    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
  </joint>
  <actuator name="shoulder_motor">
    <mechanicalReduction>50</mechanicalReduction>
  </actuator>
</transmission>
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD[: BAD.index("<transmission")] + BAD[BAD.index("<ros2_control") :]

#: Places that the finding lists beside the first.
_MAX_RELATED = 20


@rule(
    "RCT015",
    "transmission-in-ros2",
    Severity.INFO,
    help="delete it, or move it into <ros2_control>",
)
def check(subject: Subject) -> Iterator[Finding]:
    """One finding for all: a robot has one for each joint."""
    first, *others = subject.model.transmissions or (None,)
    if first is None or reads_transmissions(subject.targets):
        return
    more = f" and {len(others)} more" if others else ""
    yield Finding(
        first,
        f"{called(first)}{more}: nothing in ROS 2 reads it",
        related=tuple(Related(other.span, called(other)) for other in others[:_MAX_RELATED]),
    )
