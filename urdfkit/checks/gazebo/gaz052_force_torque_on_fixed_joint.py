"""Forces are to be measured at a fixed joint that Gazebo merges away.

The joint does not exist in the simulation, and a force-torque sensor or `<provideFeedback>` with
it: the topic never appears. Keep the joint with `<preserveFixedJoint>true</preserveFixedJoint>` in
the same `<gazebo reference>`. It is a warning where nothing in the robot reads the forces: no
topic, no plugin, no sensor of ros2_control.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    gazebosim/gz-sensors#25: https://github.com/gazebosim/gz-sensors/issues/25
    Kinovarobotics/ros_kortex#312: https://github.com/Kinovarobotics/ros_kortex/issues/312
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.robot.model import RobotModel
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.ros.gazebo.values import is_true
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import insert_before

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="tool">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<joint name="wrist" type="fixed">
  <parent link="base"/>
  <child link="tool"/>
</joint>
<gazebo reference="wrist">
  <sensor name="force" type="force_torque">
    <update_rate>100</update_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("  <sensor", "  <preserveFixedJoint>true</preserveFixedJoint>\n  <sensor")
FIXED = GOOD


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    help="add <preserveFixedJoint>true</preserveFixedJoint> to the <gazebo reference> of the joint",
)
def check(subject: Subject) -> Findings:
    kept = {joint.joint.name for joint in subject.gazebo.joints}
    for name, at, who in _measuring(subject.model):
        joint = subject.model.joints_by_name.get(name)
        if joint is not None and joint.kind == "fixed" and name not in kept:
            line = "<preserveFixedJoint>true</preserveFixedJoint>"
            yield Finding(
                at,
                f"{who} is on joint '{name}', which Gazebo merges",
                fix=Fix("keep the joint in Gazebo", insert_before(at, (line,))),
                alike="merged",
                severity=None if _is_read(subject.model, name, at) else Severity.WARNING,
            )


def _is_read(model: RobotModel, name: str, at: Element) -> bool:
    """True if the sensor has a topic or a plugin, or something else asks for the forces."""
    if at.tag == "sensor" and (at.child("topic") or at.child("plugin")):
        return True
    plugins = [plugin for block in model.gazebo for plugin in block.all("plugin")]
    if any(value.text.strip() == name for plugin in plugins for value in plugin.children):
        return True
    sensors_of_control = [one for block in model.ros2_controls for one in block.all("sensor")]
    interfaces = [state for one in sensors_of_control for state in one.all("state_interface")]
    return any((one.get("name") or "").startswith(("force", "torque")) for one in interfaces)


def _measuring(model: RobotModel) -> Iterator[tuple[str, Element, str]]:
    """The joints whose forces are asked for, by whom, and where."""
    measured: set[str] = set()
    for sensor in sensors(model):
        if sensor.type == "force_torque":
            measured.add(sensor.reference)
            yield sensor.reference, sensor.at, sensor.who
    for block in model.gazebo:
        name = block.get("reference") or ""
        for wish in block.all("provideFeedback"):
            if name not in measured and is_true(wish):
                yield name, wish, "<provideFeedback>"
