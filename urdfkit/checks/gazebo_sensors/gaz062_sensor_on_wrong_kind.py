"""A sensor for joints is given to a link, or one for links to a joint.

Force and torque are measured in a joint: `<gazebo reference="JOINT">`. On a link gz-sim makes a
sensor that never sends, and Gazebo Classic none. Cameras, lidars and the like belong to links.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    gazebosim/docs#331: https://github.com/gazebosim/docs/issues/331
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.sensors import types
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="hand">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<joint name="wrist" type="continuous">
  <parent link="base"/>
  <child link="hand"/>
</joint>
<gazebo reference="hand">
  <sensor name="force" type="force_torque"/>
</gazebo>"""
GOOD = BAD.replace('reference="hand"', 'reference="wrist"')

_ON_JOINTS = {"force_torque"}


@rule("GAZ062", "sensor-on-wrong-kind", Severity.ERROR)
def check(subject: Subject) -> Iterator[Finding]:
    model = subject.model
    for sensor in sensors(model):
        is_link = sensor.reference in model.links_by_name
        is_joint = sensor.reference in model.joints_by_name
        who = f"{sensor.who} of type '{sensor.type}' is given to"
        if sensor.type in _ON_JOINTS and is_link and not is_joint:
            above = subject.tree.parents.get(sensor.reference, [])
            help = f'write reference="{above[0].name}"' if above else "name a joint"
            message = f"{who} link '{sensor.reference}': it measures in a joint"
            yield Finding(sensor.at, message, help)
        elif sensor.type in types().keys() - _ON_JOINTS and is_joint and not is_link:
            message = f"{who} joint '{sensor.reference}', and belongs to a link"
            yield Finding(sensor.at, message, "name a link")
