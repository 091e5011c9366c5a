"""A block of ros2_control holds a tag that it may not hold, or something in it has no name.

The parser of ros2_control stops with an exception, "invalid tag name" or "no attribute name in
tag", and the controller manager does not start. Correct the tag, or give the name. It stops as well
at an `actuator` with several joints, and at a transmission whose joints have no `role`.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.ros_control import grammar
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rename_element

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
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joints name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joints>
</ros2_control>"""
GOOD = BAD.replace("joints", "joint")
FIXED = GOOD

#: How like a tag a word must be to be taken for a slip of it.
_TYPO = 0.8
#: A tag with a prefix, such as a call that nothing expands, is reported elsewhere.
_PREFIX = ":"


@rule(
    "RCT017",
    "control-block-refused",
    Severity.ERROR,
    help="see the grammar of <ros2_control>: hardware, joint, sensor, gpio, transmission",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    tags = grammar()
    for block in subject.model.ros2_controls:
        known = tags["ros2_control"].children
        for child in block.children:
            if child.tag not in known and _PREFIX not in child.tag:
                hint = did_you_mean(child.tag, known)
                message = f"<ros2_control> may not hold <{child.tag}>{hint}"
                yield Finding(child, message, fix=_renamed(child, known))
        for element in _named(block):
            if not element.get("name"):
                yield Finding(element, f"<{element.tag}> has no name", "give it a name")
        yield from _joints_of_actuator(block)
        for transmission in block.all("transmission"):
            for part in transmission.children:
                if part.tag in ("joint", "actuator") and not part.get("role"):
                    message = f"<{part.tag}> of a transmission has no role"
                    yield Finding(part, message, f'add role="{part.tag}1"')


def _joints_of_actuator(block: Element) -> Iterator[Finding]:
    joints = block.all("joint")
    if block.get("type") == "actuator" and len(joints) > 1:
        message = f"an actuator has one joint, and this one has {len(joints)}"
        yield Finding(block.attributes["type"], message, 'write type="system"')


def _renamed(child: Element, known: Iterable[str]) -> Fix | None:
    suggested = nearest(child.tag, known, _TYPO)
    edits = rename_element(child, suggested) if suggested else None
    return Fix.of(f"rename it to <{suggested}>", edits)


def _named(block: Element) -> Iterator[Element]:
    """What needs a name: the block, its parts, and what stands in them."""
    yield block
    tags = grammar()
    for child in block.children:
        if child.tag in tags and "name" in tags[child.tag].required:
            yield child
        for inner in child.children:
            if inner.tag in ("command_interface", "state_interface", "param"):
                yield inner
                yield from inner.all("param")
