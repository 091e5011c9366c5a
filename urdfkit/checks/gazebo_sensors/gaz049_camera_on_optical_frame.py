"""A camera sits on an optical frame and looks to the side.

A sensor of Gazebo looks along x of its link. In an optical frame z points forward and x to the
right (REP 103), so the camera sees what is beside the robot. Put the sensor on the camera's own
link, and name the optical frame as the frame of its pictures.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
"""

from __future__ import annotations

from urdfkit.core.spatial import rotate
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.model import numbers
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Severity
from urdfkit.text.document import Element

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
  <collision>
    <geometry><box size="0.2 0.2 0.1"/></geometry>
  </collision>
</link>
<link name="camera_link"/>
<link name="camera_optical_frame"/>
<joint name="mount" type="fixed">
  <parent link="base"/>
  <child link="camera_link"/>
</joint>
<joint name="optics" type="fixed">
  <origin rpy="-1.5708 0 -1.5708"/>
  <parent link="camera_link"/>
  <child link="camera_optical_frame"/>
</joint>
<gazebo reference="camera_optical_frame">
  <sensor name="camera" type="camera">
    <update_rate>30</update_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace('reference="camera_optical_frame"', 'reference="camera_link"')

#: Cosine of the angle up to which z counts as pointing forward.
_NEARLY = 0.99


@rule(Severity.WARNING, help="refer to the camera's link, and name the optical frame in the plugin")
def check(subject: Subject) -> Findings:
    for sensor in sensors(subject.model):
        if "camera" not in sensor.type and sensor.type != "depth":
            continue
        if _is_turned(sensor.find("pose")):
            continue
        for joint in subject.tree.parents.get(sensor.reference, ()):
            forward = rotate(joint.origin.rotation, (0.0, 0.0, 1.0))
            if "optical" in sensor.reference and forward[0] > _NEARLY:
                message = (
                    f"{sensor.who} looks along x of '{sensor.reference}', to the robot's right"
                )
                yield Finding(sensor.at, message, alike="optical")


def _is_turned(pose: Element | None) -> bool:
    """True if the sensor's own pose turns it."""
    values = numbers(pose.text) if pose else None
    return values is not None and any(abs(angle) > 1e-6 for angle in values[3:])
