"""A transmission has a type that is not there, joints that do not fit it, or a ratio of 0.

ros_control loads transmissions by their type and divides by the ratio of the gear: with an unknown
type, another number of joints or actuators than the type has, a ratio of 0 or one that is not a
number it leaves the transmission out, and no controller finds the joint; Gazebo leaves out all with
more than one joint. A misspelt element is passed over, and its default taken.

Sources:
    ros_control, transmission_parser.cpp: https://github.com/ros-controls/ros_control/blob/noetic-devel/transmission_interface/src/transmission_parser.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.model import number
from urdfkit.ros.catalog.ros_control import words
from urdfkit.ros.ros_control import ROS1, called, is_of_pr2, reads_transmissions
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rename_element, rewrite

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
  <joint name="shoulder">
    <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
  </joint>
  <actuator name="shoulder_motor">
    <mechanicalReducton>50</mechanicalReducton>
  </actuator>
</transmission>"""
GOOD = BAD.replace("Reducton", "Reduction")
FIXED = GOOD

_CHILDREN = {
    "transmission": ("type", "joint", "actuator"),
    "joint": ("hardwareInterface", "role", "offset", "mechanicalReduction"),
    "actuator": ("hardwareInterface", "role", "mechanicalReduction", "motorTorqueConstant"),
}
#: Joints, and as many actuators, of each type.
_COUNTS = {"SimpleTransmission": 1, "DifferentialTransmission": 2, "FourBarLinkageTransmission": 2}
#: How like a name a word must be to be taken for a slip of it.
_TYPO = 0.85


@rule(
    "RCT024",
    "transmission-refused",
    Severity.WARNING,
    fixable=True,
    by_target=dict.fromkeys(ROS1, Severity.ERROR),
)
def check(subject: Subject) -> Iterator[Finding]:
    if not subject.model.transmissions or not reads_transmissions(subject.targets):
        return
    for transmission in subject.model.transmissions:
        if is_of_pr2(transmission):
            continue
        yield from _type(transmission)
        yield from _count(transmission)
        for element in (transmission, *transmission.children):
            yield from _children(element, called(transmission))


def _type(transmission: Element) -> Iterator[Finding]:
    element, known = transmission.child("type"), words("transmission", "types")
    name = element.text.strip() if element else ""
    suggested = nearest(name, known, _TYPO) if name not in known else None
    full = [one for one in known if one.endswith(f"/{name}")]
    if full and element:
        edits = rewrite(element, full[0])
        fix = Fix.of(f"write {full[0]}", edits)
        message = f"{called(transmission)}: type '{name}' lacks its package"
        yield Finding(element, message, f"write {full[0]}", fix)
    elif element and suggested and abs(len(suggested) - len(name)) <= 2:
        edits = rewrite(element, suggested)
        fix = Fix.of(f"write {suggested}", edits)
        message = f"{called(transmission)}: type '{name}' is nearly '{suggested}'"
        yield Finding(element, message, f"write {suggested}", fix)


def _count(transmission: Element) -> Iterator[Finding]:
    """One joint and actuator for a simple transmission, two of each for the others."""
    element = transmission.child("type")
    kind = element.text.strip().rpartition("/")[2] if element else ""
    for tag in ("joint", "actuator"):
        found = transmission.all(tag)
        if kind in _COUNTS and found and len(found) != _COUNTS[kind]:  # RCT016 tells of none
            wanted = f"a {kind} has {_COUNTS[kind]} <{tag}>, and this one {len(found)}"
            help = "write a transmission for each joint" if kind == "SimpleTransmission" else ""
            yield Finding(found[-1], f"{called(transmission)}: {wanted}", help)


def _children(element: Element, who: str) -> Iterator[Finding]:
    """Slips in the names of elements, and what is no ratio of a gear."""
    for child in element.children:
        known = _CHILDREN.get(element.tag, ())
        suggested = nearest(child.tag, known, _TYPO) if child.tag not in known else None
        if suggested:
            edits = rename_element(child, suggested)
            fix = Fix.of(f"rename it to <{suggested}>", edits)
            message = f"{who}: unknown element <{child.tag}>; did you mean '{suggested}'?"
            yield Finding(child, message, "fix the name of the element", fix)
        elif child.tag == "mechanicalReduction" and not number(child.text.strip()):
            shown = child.text.strip() or "empty"
            message = f"{who}: {child.tag} is {shown}, not a number other than 0"
            yield Finding(child, message, "write the ratio of the gear, such as 50")
