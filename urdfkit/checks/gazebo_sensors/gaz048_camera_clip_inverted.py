"""A camera's near clipping distance is not above zero, or not below its far one.

Nothing lies between the two, or everything lies at the depth 0: the picture stays empty, or Gazebo
refuses the camera.

Sources:
    sdformat, Camera.cc: https://github.com/gazebosim/sdformat/blob/main/src/Camera.cc
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import swap

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="camera" type="camera">
    <camera><clip><near>10</near><far>0.1</far></clip></camera>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("<near>10</near><far>0.1</far>", "<near>0.1</near><far>10</far>")
FIXED = GOOD


@rule(Severity.ERROR, help="let near be above 0 and below far")
def check(subject: Subject) -> Findings:
    for sensor in sensors(subject.model):
        near = sensor.number("camera/clip/near")
        far = sensor.number("camera/clip/far")
        if near and near.value <= 0:
            message = f"{sensor.who}: near is {near.value:g} m, and must be above 0"
            yield Finding(near, message, "write the shortest distance that it sees, such as 0.05")
            continue
        if near and far and near.value >= far.value:
            message = f"{sensor.who}: near {near.value:g} m is not below far {far.value:g} m"
            edits = swap(near.at, far.at)
            yield Finding(near, message, fix=Fix.of("swap the two", edits))
