"""A link without mass has an inertia tensor.

When Gazebo merges a link into its parent, it adds the tensor, even without mass: a sensor frame of
0 kg with 1, 1, 1 multiplies the inertia of a small robot. Other programs ignore it. A frame needs
no `<inertial>`; a real part needs a mass.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.inertials.diagnosis import values
from urdfkit.robot.inertials.link_comparison import NOISE
from urdfkit.ros.targets import GAZEBO
from urdfkit.text.diagnostic import Severity

BAD = """\
<link name="base">
  <inertial>
    <mass value="3"/>
    <inertia ixx="0.03" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.05"/>
  </inertial>
</link>
<link name="sonar">
  <inertial>
    <mass value="0"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
  </inertial>
</link>
<joint name="sonar_mount" type="fixed">
  <parent link="base"/>
  <child link="sonar"/>
</joint>"""
GOOD = BAD.replace('"1"', '"0"')


@rule(
    Severity.INFO,
    help="remove the <inertial>, or write the mass of the part",
    by_target=dict.fromkeys(GAZEBO, Severity.WARNING),
)
def check(subject: Subject) -> Findings:
    masses = subject.masses
    for link in subject.model.links:
        inertial, body = link.inertial, masses.body_of.get(link.name)
        if inertial is None or inertial.mass is None or inertial.tensor is None:
            continue
        tensor = inertial.tensor.value
        merged = body is not None and body.top is not link
        if merged and inertial.mass.value == 0 and max(map(abs, tensor)) > NOISE:
            moments = values((tensor.ixx, tensor.iyy, tensor.izz))
            yield Finding(
                inertial.tensor,
                f"link '{link.name}' has a mass of 0 kg and moments of inertia of {moments}",
                weight=max(map(abs, tensor)),
            )
