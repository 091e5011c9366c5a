"""Joints mimic one another in a circle.

Each waits for the position of the next, and none has one of its own. MoveIt drops every mimic of
the robot, Pinocchio refuses it where it is asked for mimic joints, and joint_state_publisher runs
until Python stops it. Let one of them lead, without a `<mimic>`, and the others follow it.

Sources:
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
    joint_state_publisher.py: https://github.com/ros/joint_state_publisher/blob/ros2/joint_state_publisher/joint_state_publisher/joint_state_publisher.py
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import related
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint, RobotModel

BAD = """\
<link name="hand"/>
<link name="left_finger"/>
<link name="right_finger"/>
<joint name="left_finger_joint" type="prismatic">
  <parent link="hand"/>
  <child link="left_finger"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
  <mimic joint="right_finger_joint"/>
</joint>
<joint name="right_finger_joint" type="prismatic">
  <parent link="hand"/>
  <child link="right_finger"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
  <mimic joint="left_finger_joint"/>
</joint>"""
GOOD = BAD.replace('  <mimic joint="right_finger_joint"/>\n', "")

#: Joints that a message names.
_MAX_NAMES = 6


@rule("JNT015", "mimic-cycle", Severity.ERROR, help="let one of them lead, without a <mimic>")
def check(subject: Subject) -> Iterator[Finding]:
    for cycle in _cycles(subject.model):
        first = cycle[0]
        assert first.mimic is not None
        names = [f"'{joint.name}'" for joint in cycle[:_MAX_NAMES]]
        if len(cycle) > _MAX_NAMES:
            names.append(f"{len(cycle) - _MAX_NAMES} more")
        yield Finding(
            first.mimic.joint or first.mimic.at,
            f"joints mimic one another: {' -> '.join([*names, names[0]])}",
            related=related((joint, joint.mimic.at.span) for joint in cycle if joint.mimic),
        )


def _cycles(model: RobotModel) -> Iterator[list[Joint]]:
    """The circles of two or more joints, each once."""
    joints = model.joints_by_name
    seen: dict[str, int] = {}  # the walk that met a joint
    for walk, start in enumerate(joints.values()):
        way: list[Joint] = []
        joint: Joint | None = start
        while joint and joint.mimic and joint.mimic.joint and joint.name not in seen:
            seen[joint.name] = walk
            way.append(joint)
            joint = joints.get(joint.mimic.joint.value)
        if joint and seen.get(joint.name) == walk:
            cycle = way[next(i for i, met in enumerate(way) if met is joint) :]
            if len(cycle) > 1:  # JNT014 tells a joint that mimics itself
                yield cycle
