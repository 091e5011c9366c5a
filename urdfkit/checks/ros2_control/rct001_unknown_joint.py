"""A transmission or a block of ros2_control names a joint that the model does not have.

From ROS 2 Jazzy on the controller manager stops with an exception; the simulators of Humble leave
the joint out. In ROS 1, one such transmission makes the whole hardware of gazebo_ros_control fail,
so that no joint moves. Correct the name.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    gazebo_ros_control_plugin.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros_control/src/gazebo_ros_control_plugin.cpp
    PilzDE/pilz_robots#16: https://github.com/PilzDE/pilz_robots/issues/16
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.suggest import Suggester
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.ros.ros_control import called, components, driven_joints, reads_transmissions
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.grammar import is_expression

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
  <joint name="sholder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace("sholder", "shoulder")
FIXED = GOOD


@rule(Severity.ERROR, help="fix the name, or add the joint", reports_missing=True)
def check(subject: Subject) -> Findings:
    known = subject.model.joints_by_name
    if not known:
        return  # a description of the hardware alone; Webots, say, has the joints in its world
    suggester = Suggester(known)
    for name, owner in _named(subject):
        if name.value in known or is_expression(name.value):
            continue
        if subject.is_part:  # the file that includes it has the joint
            return
        hint = suggester.hint(name.value)
        yield Finding(
            name,
            f"{owner} names joint '{name.value}', which is not in the model{hint}",
            fix=_fix(name, suggester.suggested(name.value)),
            alike="" if hint else owner,
        )
    yield from _not_in_block(subject)


def _fix(name: Attribute, suggested: str) -> Fix | None:
    edits = replace_value(name, suggested) if suggested else None
    return Fix.of(f"rename '{name.value}' to '{suggested}'", edits)


def _named(subject: Subject) -> Iterator[tuple[Attribute, str]]:
    """The names of joints, each with who gives it."""
    for component in components(subject.model):
        for joint in component.joints:
            if "name" in joint.at.attributes:
                yield joint.at.attributes["name"], component.called
    if subject.model.transmissions and reads_transmissions(subject.targets):
        for element, transmission in driven_joints(subject.model):
            if "name" in element.attributes:
                yield element.attributes["name"], called(transmission)


def _not_in_block(subject: Subject) -> Findings:
    """A transmission of ROS 2 finds the joints of its own block only."""
    for component in components(subject.model):
        listed = {joint.name for joint in component.joints}
        for transmission in component.at.all("transmission"):
            for joint in transmission.all("joint"):
                name = joint.attributes.get("name")
                if name and name.value not in listed and not is_expression(name.value):
                    yield Finding(
                        name,
                        f"{called(transmission)} names joint '{name.value}', "
                        f"which {component.called} does not list",
                        "list the joint in the same block, or correct the name",
                    )
