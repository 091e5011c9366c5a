"""Two transmissions move the same joint, or have the same name.

It happens where a transmission was copied and a name was not changed. Both write to the joint, and
the joint that was meant has none: its controller does not find it. Of two transmissions with one
name ros_control keeps the second.

Sources:
    ros_control, transmission_interface_loader.cpp: https://github.com/ros-controls/ros_control/blob/noetic-devel/transmission_interface/src/transmission_interface_loader.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import is_of_pr2, reads_transmissions
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Attribute, Element

BAD = """\
<link name="base"/>
<link name="upper_arm"/>
<link name="forearm"/>
<joint name="shoulder" type="continuous">
  <parent link="base"/>
  <child link="upper_arm"/>
  <axis xyz="0 0 1"/>
</joint>
<joint name="elbow" type="continuous">
  <parent link="upper_arm"/>
  <child link="forearm"/>
  <axis xyz="0 0 1"/>
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
<transmission name="elbow_transmission">
  <type>transmission_interface/SimpleTransmission</type>
  <joint name="shoulder">
    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
  </joint>
  <actuator name="elbow_motor">
    <mechanicalReduction>50</mechanicalReduction>
  </actuator>
</transmission>"""
_SECOND = BAD.index('<joint name="shoulder">', BAD.index('"elbow_transmission"'))
GOOD = BAD[:_SECOND] + BAD[_SECOND:].replace('"shoulder"', '"elbow"')


@rule(
    "RCT030",
    "joint-transmitted-twice",
    Severity.WARNING,
    help="name the joint that was meant, or leave one of the transmissions out",
)
def check(subject: Subject) -> Iterator[Finding]:
    if not reads_transmissions(subject.targets):
        return
    names: dict[str, Attribute] = {}
    moved: dict[tuple[str, str], Attribute] = {}
    for transmission in subject.model.transmissions:
        if is_of_pr2(transmission):
            continue
        own = transmission.attributes.get("name")
        if own and (first := names.setdefault(own.value, own)) is not own:
            message = f"a second transmission is called '{own.value}'"
            related = (Related(first.span, "first here"),)
            yield Finding(own, message, "give it another name", related=related)
        for joint in transmission.all("joint"):
            name = joint.attributes.get("name")
            firsts = [moved.setdefault((name.value, how), name) for how in _ways(joint) if name]
            if name and (others := [one for one in firsts if one is not name]):
                yield Finding(
                    name,
                    f"joint '{name.value}' has a transmission already",
                    related=(Related(others[0].span, "the other one"),),
                )


def _ways(joint: Element) -> list[str]:
    """In which ways a transmission moves a joint; another may move it in another way."""
    return [
        interface.text.strip().rpartition("/")[2] for interface in joint.all("hardwareInterface")
    ]
