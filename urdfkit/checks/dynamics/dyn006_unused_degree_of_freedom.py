"""A joint moves nothing: no link below it has a mass, a visual or a collision.

Such a degree of freedom has no effect. Its row of the mass matrix is zero, which Pinocchio's
forward dynamics and MuJoCo reject; Gazebo drops the massless link with it. If it only marks a
frame, make it fixed; if it stands for a mechanism, add `<mimic>`.

Sources:
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from urdfkit.lint.rules import Finding, Findings, Severity, Subject, rule
from urdfkit.robot.joint_loads import idle
from urdfkit.robot.joints import driven

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="tool_frame"/>
<joint name="tool_joint" type="continuous">
  <parent link="base"/>
  <child link="tool_frame"/>
  <axis xyz="0 0 1"/>
</joint>"""
GOOD = BAD.replace("continuous", "fixed").replace('\n  <axis xyz="0 0 1"/>', "")


@rule(Severity.INFO, help='make it type="fixed", or give the link below it a mass')
def check(subject: Subject) -> Findings:
    if subject.is_part or not any(link.mass for link in subject.model.links):
        return
    moved = driven(subject.model)
    seen = {block.get("reference") for block in subject.model.gazebo if block.child("sensor")}
    for joint in idle(subject.tree):
        assert joint.child is not None
        child = joint.child.value
        if joint.name in moved or not seen.isdisjoint(subject.tree.below(child)):
            continue
        yield Finding(
            joint.at,
            f"joint '{joint.name}' ({joint.kind}): link '{child}' and the links below it "
            "have neither mass nor shape",
        )
