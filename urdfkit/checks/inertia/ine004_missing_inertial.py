"""A link that a joint moves has no mass, nor has anything that is fixed to it.

RViz and MoveIt do not mind. Gazebo leaves out such a link and everything that hangs on it, without
an error in older versions, and controllers then do not find their joints; MuJoCo refuses the
robot. Give the link an `<inertial>`. A link that only marks a place needs none if its joint is
fixed: Gazebo makes it a part of its parent. A root without mass, such as `world`, is fine when a
fixed joint ties it to the robot.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/sdformat#199: https://github.com/gazebosim/sdformat/issues/199
    gazebosim/gz-sim#2815: https://github.com/gazebosim/gz-sim/issues/2815
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.targets import GAZEBO
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.rigid_bodies import RigidBody

BAD = """\
<link name="base">
  <inertial>
    <mass value="2"/>
    <inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
  </inertial>
</link>
<link name="wheel">
  <collision>
    <geometry><sphere radius="0.1"/></geometry>
  </collision>
</link>
<joint name="axle" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
</joint>"""
GOOD = BAD.replace(
    '<link name="wheel">',
    """<link name="wheel">
  <inertial>
    <mass value="0.5"/>
    <inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.002"/>
  </inertial>""",
)

#: Links below that a message names.
_NAMED = 4


@rule(
    "INE004",
    "missing-inertial",
    Severity.INFO,
    needs=(Need.MODEL, Need.GAZEBO),
    help="give it an <inertial>, or a fixed joint if it only marks a place",
    by_target={"mujoco": Severity.ERROR, **dict.fromkeys(GAZEBO, Severity.ERROR)},
)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.masses.total <= 0 or subject.is_part:
        return  # INE019; and what a part lacks, the whole may have
    for body in subject.gazebo.massless:
        zero = body.top.inertial is not None and body.top.inertial.mass is not None
        reported = body.joint is not None and zero  # INE001
        if not reported and (body.joint or subject.targets.any_of(GAZEBO)):
            finding = _finding(body, subject)
            if finding:
                yield finding


def _finding(body: RigidBody, subject: Subject) -> Finding | None:
    """None where only frames without shape and mass are lost."""
    name, links = body.top.name, subject.model.links_by_name
    lost = subject.tree.below(name)
    if not any(links[n].visuals or links[n].collisions or links[n].mass for n in lost):
        return None
    hanging = [f"'{n}'" for n in lost if n not in {link.name for link, _ in body.links}]
    if len(hanging) > _NAMED:
        hanging = [*hanging[: _NAMED - 1], f"{len(hanging) - _NAMED + 1} more"]
    others = f" and with it {_listed(hanging)}" if hanging else ""
    by = "the root"
    if body.joint:  # a fixed one leads from the world
        verb = "held" if body.joint.kind == "fixed" else "moved"
        by = f"{verb} by the {body.joint.kind} joint '{body.joint.name}'"
    return Finding(
        body.top.at,
        f"link '{name}' is {by} and has no mass: Gazebo leaves it out{others}",
    )


def _listed(names: list[str]) -> str:
    return " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))
