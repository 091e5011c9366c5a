"""A force-torque sensor is on a fixed joint that Gazebo merges away.

The joint does not exist in the simulation, and the sensor with it: its topic never appears. Keep
the joint with `<preserveFixedJoint>true</preserveFixedJoint>` in the same `<gazebo reference>`.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    gazebosim/gz-sensors#25: https://github.com/gazebosim/gz-sensors/issues/25
    Kinovarobotics/ros_kortex#312: https://github.com/Kinovarobotics/ros_kortex/issues/312
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Fix, Severity
from urdfkit.editing.edits import insert_before
from urdfkit.gazebo.sensors import sensors
from urdfkit.rules import Finding, Need, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
  </inertial>
</link>
<link name="tool">
  <inertial>
    <mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
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
    "GAZ052",
    "force-torque-on-fixed-joint",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    help="add <preserveFixedJoint>true</preserveFixedJoint> to the <gazebo reference> of the joint",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for sensor in sensors(subject.model):
        joint = subject.model.joints_by_name.get(sensor.reference)
        if sensor.type != "force_torque" or joint is None or joint.kind != "fixed":
            continue
        if joint.name not in {kept.joint.name for kept in subject.gazebo.joints}:
            line = "<preserveFixedJoint>true</preserveFixedJoint>"
            yield Finding(
                sensor.at,
                f"{sensor.who} is on joint '{joint.name}', which Gazebo merges",
                fix=Fix("keep the joint in Gazebo", insert_before(sensor.at, (line,))),
                alike="merged",
            )
