"""A camera's pictures are stamped with a frame that does not look along z.

ROS programs expect an optical frame: z forward, x right, y down (REP 103). A camera link of URDF
looks along x, so that points seen straight ahead appear above the robot. Add a link turned by
rpy="-1.5708 0 -1.5708" and name it as the frame.

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    gazebo_ros_camera.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_camera.cpp
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.diagnostic import Severity
from urdfkit.text.document import Element

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="base_optical"/>
<joint name="optics" type="fixed">
  <origin rpy="-1.5708 0 -1.5708"/>
  <parent link="base"/>
  <child link="base_optical"/>
</joint>
<gazebo reference="base">
  <sensor name="camera" type="camera">
    <plugin name="driver" filename="libgazebo_ros_camera.so">
      <frameName>base</frameName>
    </plugin>
  </sensor>
</gazebo>"""
GOOD = BAD.replace(">base<", ">base_optical<")

_TAGS = ("frameName", "frame_name", "gz_frame_id", "frame_id", "ignition_frame_id")


@rule(
    Severity.INFO,
    help="name an optical frame, a link turned by -1.5708 0 -1.5708 against the camera's",
)
def check(subject: Subject) -> Findings:
    for sensor in sensors(subject.model):
        if "camera" not in sensor.type and sensor.type not in ("depth", "rgbd"):
            continue
        for frame in _frames(sensor):
            name = frame.text.strip()
            # The sensor looks along x of its own link; another link may be turned as it should.
            if name == sensor.reference and "optical" not in name:
                message = (
                    f"{sensor.who}: images are published with frame_id '{name}', which is x-forward"
                )
                yield Finding(frame, message, alike="not optical")


def _frames(sensor: Sensor) -> Iterator[Element]:
    for parent in (sensor.at, *sensor.plugins):
        for tag in _TAGS:
            yield from parent.all(tag)
