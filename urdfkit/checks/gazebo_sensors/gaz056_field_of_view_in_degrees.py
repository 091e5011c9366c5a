"""A camera's field of view is more than a full turn.

`horizontal_fov` is in radians. Gazebo refuses the model: "horizontal fov must be greater than zero
and less than or equal to two pi".

Sources:
    SDF, camera.sdf: https://github.com/gazebosim/sdformat/blob/main/sdf/1.9/camera.sdf
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi, radians
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.model import number
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rewrite

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="camera" type="camera">
    <camera><horizontal_fov>80</horizontal_fov></camera>
  </sensor>
</gazebo>"""
GOOD = BAD.replace(">80<", ">1.3963<")
FIXED = BAD.replace(">80<", ">1.39626<")


@rule(
    "GAZ056",
    "field-of-view-in-degrees",
    Severity.ERROR,
    help="write the angle in radians",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for sensor in sensors(subject.model):
        for camera in sensor.at.all("camera"):
            element = camera.child("horizontal_fov")
            value = number(element.text.strip()) if element else None
            if element is not None and value is not None and not 0 < value <= 2 * pi:
                text = f"{radians(value):.6g}"
                hint = f"if degrees were meant, write {text}" if value > 0 else ""
                message = f"{sensor.who}: a field of view of {value:g} rad is not within 0 to 2 pi"
                edits = rewrite(element, text) if value > 0 else None
                yield Finding(element, message, hint, Fix.of(f"write {text}", edits))
