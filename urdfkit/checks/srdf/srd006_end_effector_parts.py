"""The group of an end effector and its parent group do not match.

The links of the end effector's group must not be in the parent group, and the parent link must be.
MoveIt loads the robot, but handles the hand as a part of the arm, or attaches it to another group
with the parent link, or to none.

Sources:
    SRDF: https://wiki.ros.org/srdf
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import arm_xml
from urdfkit.ros.moveit.samples import named_xml, srdf_files

BAD = named_xml("bad", arm_xml("fixed"))
_GROUPS = """\
<group name="base"><link name="base"/></group>
<group name="arm"><link name="arm"/></group>
<end_effector name="arm" group="arm" parent_link="base" parent_group="base"/>"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files(_GROUPS.replace("</group>", '<link name="arm"/></group>', 1), _GROUPS)


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="use groups without common links, and a parent link in the parent group",
)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    for effector in srdf.end_effectors:
        name, parent = effector.get("name"), effector.get("parent_group")
        hand = srdf.links_of(effector.get("group") or "")
        arm = srdf.links_of(parent) if parent else set()
        if shared := sorted(hand & arm):
            links = ", ".join(f"'{link}'" for link in shared)
            yield Finding(effector, f"end effector '{name}' and group '{parent}' share {links}")
        link = effector.get("parent_link")
        if link in hand:
            yield Finding(effector, f"end effector '{name}' is attached to '{link}', its own link")
