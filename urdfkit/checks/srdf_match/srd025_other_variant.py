"""The SRDF is for another variant of the robot.

Many of its links and joints are in another robot of the package, or differ by a prefix: the SRDF is
for the complete robot and this is only its arm, or the robot was expanded with `prefix:=left_`.
MoveIt does not load the two together. The other rules for the SRDF do not run in this case.

Sources:
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml

BAD = robot_xml(
    link_xml("left_base"),
    link_xml("left_arm"),
    joint_xml("continuous", name="left_shoulder", parent="left_base", child="left_arm"),
)
GOOD = BAD.replace("left_", "")
FILES = {
    "example.srdf": b"""<robot name="example">
  <group name="arm"><joint name="shoulder"/></group>
  <disable_collisions link1="base" link2="arm" reason="Adjacent"/>
</robot>
"""
}


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.SRDF),
    help="check the variant that the SRDF is for, or generate an SRDF for this variant",
    reports_missing=True,
)
def check(context: Context) -> Findings:
    if context.srdf is not None and context.other_variant:
        yield Finding(context.srdf.root, context.other_variant)
