"""A joint lacks a limit that readers require.

A revolute or prismatic joint needs a `<limit>`, and every `<limit>`, of whatever joint, needs
`effort` and `velocity`. Without them urdfdom, and with it RViz, MoveIt, Gazebo and Pinocchio,
refuses the whole robot. `lower` and `upper` may be left out and are then 0. A joint that turns
without end is continuous and needs no `<limit>`. MuJoCo and Drake take what is missing for no
limit: where they are the only targets nothing is reported.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import BOUNDED, effort_unit, unit
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <limit lower="-1" upper="1"/>
</joint>"""
GOOD = BAD.replace('upper="1"', 'upper="1" effort="10" velocity="1"')


@rule("JNT002", "missing-limit", Severity.ERROR)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.targets.are_only("mujoco", "drake"):
        return
    for joint in subject.model.joints:
        units = {"effort": effort_unit(joint), "velocity": f"{unit(joint)}/s"}
        if joint.limit is None:
            if joint.kind in BOUNDED:
                yield Finding(
                    joint.at,
                    f"joint '{joint.name}' is {joint.kind} and has no <limit>",
                    f"add <limit> with lower and upper in {unit(joint)}, effort in "
                    f"{units['effort']} and velocity in {units['velocity']}",
                )
            continue
        missing = [key for key in units if key not in joint.limit.at.attributes]
        if missing:
            yield Finding(
                joint.limit.at,
                f"joint '{joint.name}': <limit> has no {' and no '.join(missing)}",
                "add " + " and ".join(f"{key} in {units[key]}" for key in missing),
            )
