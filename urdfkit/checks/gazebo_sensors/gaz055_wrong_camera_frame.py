"""The body frame and the optical frame of a camera are confused.

A sensor of Gazebo looks along x of its link. ROS programs expect images in an optical frame: z
forward, x right, y down (REP 103).

- The sensor is on the optical frame (warning): it looks to the right of the robot. Put it on the
  camera's own link, and name the optical frame as the frame of its images.
- The images are published in the camera's own link, which is x-forward (info): points straight
  ahead appear above the robot. Add a link turned by rpy="-1.5708 0 -1.5708" and name it as the
  frame.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    gazebo_ros_camera.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_camera.cpp
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.spatial import rotate
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.model import numbers
from urdfkit.ros.gazebo.sensors import Sensor, sensors
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

_TAGS = ("frameName", "frame_name", "gz_frame_id", "frame_id", "ignition_frame_id")
#: Cosine of the angle up to which z counts as pointing forward.
_NEARLY = 0.99


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    for sensor in sensors(subject.model):
        if "camera" in sensor.type or sensor.type in ("depth", "rgbd"):
            yield from _on_optical_frame(sensor, subject)
            yield from _in_body_frame(sensor)


def _on_optical_frame(sensor: Sensor, subject: Subject) -> Findings:
    link = sensor.reference
    if "optical" not in link or _is_turned(sensor.find("pose")):
        return
    for joint in subject.tree.parents.get(link, ()):
        forward = rotate(joint.origin.rotation, (0.0, 0.0, 1.0))
        if forward[0] > _NEARLY:
            yield Finding(
                sensor.at,
                f"{sensor.who} looks along x of optical frame '{link}', to the right of the robot",
                "move it to the camera's link, and name the optical frame in the plugin",
                alike="optical",
            )


def _in_body_frame(sensor: Sensor) -> Findings:
    for frame in _frames(sensor):
        name = frame.text.strip()
        # The sensor looks along x of its own link; another link may be turned as it should.
        if name == sensor.reference and "optical" not in name:
            yield Finding(
                frame,
                f"{sensor.who}: images are published with frame_id '{name}', which is x-forward",
                "name an optical frame: a link turned by -1.5708 0 -1.5708 against the camera's",
                alike="not optical",
                severity=Severity.INFO,
            )


def _is_turned(pose: Element | None) -> bool:
    """True if the sensor's own pose turns it."""
    values = numbers(pose.text) if pose else None
    return values is not None and any(abs(angle) > 1e-6 for angle in values[3:])


def _frames(sensor: Sensor) -> Iterator[Element]:
    for parent in (sensor.at, *sensor.plugins):
        for tag in _TAGS:
            yield from parent.all(tag)
