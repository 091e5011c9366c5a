"""A wheel cannot roll on: its joint is revolute and has ends.

After half a turn or so the wheel stops, and the robot with it, while the motor pushes on. A wheel
wants type="continuous", which has no ends.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.spatial import dot, rotate
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import bounds
from urdfkit.robot.kinematics import direction
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from urdfkit.core.spatial import Vector
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Link

BAD = """\
<link name="base"/>
<link name="wheel">
  <collision>
    <origin rpy="1.5707963 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry>
  </collision>
</link>
<joint name="wheel_joint" type="revolute">
  <parent link="base"/>
  <child link="wheel"/>
  <axis xyz="0 1 0"/>
  <limit lower="-3.14" upper="3.14" effort="5" velocity="10"/>
</joint>"""
GOOD = BAD.replace("revolute", "continuous").replace(' lower="-3.14" upper="3.14"', "")

#: Some write a wheel with far ends, in rad.
_FAR = 100.0


@rule(
    "JNT034",
    "wheel-with-ends",
    Severity.WARNING,
    help='make it type="continuous", without lower and upper',
)
def check(subject: Subject) -> Iterator[Finding]:
    links = subject.model.links_by_name
    for joint in subject.model.joints:
        link = links.get(joint.child.value) if joint.child else None
        ends = bounds(joint)
        if joint.kind != "revolute" or link is None or ends is None or ends[0] >= ends[1]:
            continue
        names = f"{joint.name} {link.name}".lower()
        is_wheel = "wheel" in names and "steer" not in names and "wheelie" not in names
        if is_wheel and max(map(abs, ends)) < _FAR and _rolls(link, direction(joint)):
            yield Finding(
                joint.type or joint.at,
                f"joint '{joint.name}' of wheel '{link.name}' is revolute, from {ends[0]:g} to "
                f"{ends[1]:g} rad",
                confidence=Confidence.INFERRED,
            )


def _rolls(link: Link, axis: Vector) -> bool:
    """True if the joint turns a cylinder of the link about its own axis."""
    for body in (*link.collisions, *link.visuals):
        if body.shape and body.shape.kind == "cylinder":
            return abs(dot(rotate(body.origin.rotation, (0.0, 0.0, 1.0)), axis)) > 0.9
    return False
