"""A light link between joints carries more than a thousand times its own mass.

Iterative solvers, such as those of Gazebo, Bullet and PhysX (Isaac Sim), converge slowly with a
large mass ratio: joints separate, and the robot jitters or explodes. A light hand on a heavy arm is
no problem; a gram that carries a kilogram is. Move mass from the heavy link to the light one, or
merge the two joints into one link.

Sources:
    gazebosim/gazebo-classic#895: https://github.com/gazebosim/gazebo-classic/issues/895
    robotology/icub-models#121: https://github.com/robotology/icub-models/issues/121
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.ros.targets import GAZEBO
from urdfkit.text.diagnostic import Severity

BAD = """\
<link name="base"/>
<link name="steering">
  <inertial>
    <mass value="0.005"/>
    <inertia ixx="1e-6" ixy="0" ixz="0" iyy="1e-6" iyz="0" izz="1e-6"/>
  </inertial>
</link>
<link name="wheel">
  <inertial>
    <mass value="15"/>
    <inertia ixx="0.35" ixy="0" ixz="0" iyy="0.35" iyz="0" izz="0.675"/>
  </inertial>
</link>
<joint name="steer" type="continuous">
  <parent link="base"/>
  <child link="steering"/>
</joint>
<joint name="axle" type="continuous">
  <parent link="steering"/>
  <child link="wheel"/>
</joint>"""
GOOD = BAD.replace('"0.005"', '"1"').replace('"1e-6"', '"0.001"')


@rule(
    Severity.INFO,
    help="move mass from the heavy links to the light one, or make one joint of two",
    by_target={"isaac": Severity.WARNING, **dict.fromkeys(GAZEBO, Severity.WARNING)},
    options={"ratio": 1000.0},
)
def check(subject: Subject) -> Findings:
    bound = check.option(subject, "ratio")
    for body, load in subject.masses.overloaded(bound):
        link = body.top
        mass = link.inertial.mass if link.inertial else None
        yield Finding(
            mass or link.at,
            f"link '{link.name}' has {body.mass:.3g} kg and carries {load:.3g} kg by joints, "
            f"{load / body.mass:.0f} times its own mass; solvers are stable up to {bound:g} times",
            weight=load / body.mass,
        )
